#!/bin/sh
# Where commands end early, and say why: sizes beyond memory and doubles, folders that are none, locks, names that are no text, odd programs under judgement.
vectors=$(cd "$(dirname "$0")/../../golden/conformance" && pwd)
. "$(dirname "$0")/kit"
"$etalon" generate sphere -o s.xyz -q
"$etalon" train s.xyz --grid 6x6 --iterations 2000 -q -o n.json
"$etalon" fit n.json --control 5x5 -q -o f.json
few="--grid 6x6 --iterations 500 --control 5x5 --no-pictures -q"
kept() { if [ "$(cat "$2")" = kept ]; then pass "$1"; else fail "$1" "$2 is another file"; fi; }

# ---- sizes ----
echo kept > out.xyz
says 'a cloud beyond memory' 70 'cannot make' "$etalon" generate cube --size 4000000000 -o out.xyz
kept 'and the earlier one stays' out.xyz
says 'runs beyond memory' 70 'not enough memory' "$etalon" compare s.xyz --grid 6x6 --control 5x5 --runs 18446744073709551615
says 'half a size' 2 "--grid wants a size such as 20x30, not '5x'" "$etalon" train s.xyz --grid 5x
sed 's/ /e200 /g; s/$/e200/' s.xyz > huge.xyz
says 'coordinates whose squares overflow' 3 'huge.xyz: coordinates this large' "$etalon" train huge.xyz --grid 6x6 --normalise none --iterations 100 -q
python3 - <<'P'
import json
j = json.load(open('n.json'))
def times(x, k): return [times(y, k) for y in x] if isinstance(x, list) else x * k
w = j['weights']
j['weights'] = times(w, 1e200); json.dump(j, open('large.json', 'w'))
j['weights'] = times([[x - 0.5 for x in p] for p in w], 8e307); json.dump(j, open('largest.json', 'w'))
P
echo kept > g.json
says 'a fit whose squares overflow' 3 'want --exact, or a cloud' "$etalon" fit large.json --control 5x5 -o g.json
kept 'and the earlier one stays, too' g.json
want 'exactly it has an error' 0 "$etalon" fit large.json --control 5x5 --exact -q -o g.json
says 'errors beyond all doubles' 3 'even the errors are beyond all doubles' "$etalon" fit largest.json --control 4x4 --knots uniform --exact -o g.json
says 'a start population beyond all doubles' 2 'de ' "$etalon" refine f.json --net n.json --with de --spread 1e308
says 'a mesh beyond memory' 70 '--mesh 1000000000x1000000000 cannot be made' "$etalon" reconstruct s.xyz $few --refine none --mesh 1000000000x1000000000 -o mesh.d
[ ! -e mesh.d ] && pass 'and no folder' || fail 'and no folder' "$(ls -A mesh.d)"

says 'fit: one file for two things' 2 'two different files' "$etalon" fit n.json --output g.json --iges g.json
says 'reconstruct: no such algorithm' 2 "does not know 'abc'" "$etalon" reconstruct s.xyz --refine abc -o x.d
python3 -c "import json; j = json.load(open('n.json')); del j['training']['seed']; json.dump(j, open('seedless.json', 'w'))"
says 'a net that does not tell its seed' 3 'seedless.json: training.seed' "$etalon" fit seedless.json

# ---- folders and locks ----
says 'a folder where none can be made' 4 'cannot make a folder in /proc' "$etalon" reconstruct s.xyz $few --refine none -o /proc
mkdir -p locked/.lock && echo kept > locked/surface.json
says 'a lock that is a folder' 4 'cannot lock locked/.lock' "$etalon" reconstruct s.xyz $few --refine none -o locked
kept 'and what is there stays' locked/surface.json
[ "$(ls -A locked | wc -l)" -eq 2 ] && pass 'nothing is left beside it' || fail 'nothing is left beside it' "$(ls -A locked)"
cat > hold.py <<'P'
"""hold.py FOLDER: hold its lock until the file FOLDER.go is there, and remove it while it is held, as those do who publish."""
import fcntl, os, sys, time
lock = os.open(sys.argv[1] + '/.lock', os.O_RDWR | os.O_CREAT)
fcntl.lockf(lock, fcntl.LOCK_EX)
open(sys.argv[1] + '.held', 'w').close()
for k in range(600):
    if os.path.exists(sys.argv[1] + '.go'): break
    time.sleep(0.05)
os.unlink(sys.argv[1] + '/.lock')
P
until_there() { tries=0; while [ ! -e "$1" ] && [ $tries -lt 600 ]; do sleep 0.05; tries=$((tries + 1)); done; }
waiting() { tries=0; while ! ls "$1"/.part-*/report.md > there 2>&1 && [ $tries -lt 600 ]; do sleep 0.05; tries=$((tries + 1)); done; sleep 0.2; }
mkdir one two && echo kept > two/surface.json
python3 hold.py one & until_there one.held
"$etalon" reconstruct s.xyz $few --refine none -o one 2> err & pid=$!
waiting one; touch one.go; wait $pid
[ $? -eq 0 ] && [ -s one/surface.json ] && [ ! -e one/.lock ] && pass 'who waits for a lock publishes in the end' || fail 'who waits for a lock publishes in the end' "$(cat err)"
python3 hold.py two & until_there two.held
"$etalon" reconstruct s.xyz $few --refine none -o two 2> err & pid=$!
waiting two; kill -INT $pid; wait $pid; got=$?
touch two.go; wait
[ $got -eq 130 ] && grep -q 'nothing was written' err && pass 'interrupted while it waits for a lock' || fail 'interrupted while it waits for a lock' "exit code $got: $(cat err)"
kept 'and nothing was' two/surface.json
[ "$(ls -A two)" = surface.json ] && pass 'nor left' || fail 'nor left' "$(ls -A two)"

"$etalon" reconstruct s.xyz --grid 20x20 --iterations 1000000000 --no-pictures -o train.d 2> err & pid=$!
sleep 0.7; kill -INT $pid; wait $pid; got=$?
[ $got -eq 130 ] && grep -q 'nothing was written' err && [ ! -e train.d ] && pass 'interrupted in training' || fail 'interrupted in training' "exit code $got: $(cat err)"

# ---- readings, names, files ----
want 'reconstruct: the source'\''s readings, and the optimum' 0 "$etalon" reconstruct s.xyz --grid 6x6 --iterations 500 --control 5x5 --no-pictures --refine de,optimum --generations 2 --faithful -o faithful.d
grep -q '^Certified: no closed surface' faithful.d/report.md && pass 'the report tells what is certified' || fail 'the report tells what is certified'
holds 'knots are the source'\''s' "j['fit']['knots'] == 'faithful'" faithful.d/surface.json
odd=$(printf 'odd\377.xyz')
want 'a name that is no text' 0 "$etalon" generate cube --size 5 -o "$odd" --json
holds 'has a question mark in JSON' "j['file'] == 'odd?.xyz'" out
want 'a cloud of such a name' 0 "$etalon" reconstruct "$odd" $few --refine none -o odd.d
holds 'and its summary' "j['cloud']['file'] == 'odd?.xyz'" odd.d/summary.json
want 'a comparison of such a cloud' 0 "$etalon" compare "$odd" --grid 6x6 --iterations 500 --control 5x5 --with none --json
holds 'and its table' "j['cloud'] == 'odd?.xyz'" out
says 'parameters that are a folder' 4 'cannot read odd.d: Is a directory' "$etalon" evaluate f.json odd.d
says 'a checkpoint that is a folder' 4 'cannot read odd.d: Is a directory' "$etalon" refine f.json --net n.json --with de --resume odd.d
says 'a baseline that is a folder' 4 'cannot read odd.d: Is a directory' "$etalon" compare s.xyz --baseline odd.d
printf '0.5 0.5\n' > uv
"$etalon" fit largest.json --control 5x5 --knots uniform --exact -q -o steep.json
says 'derivatives beyond all doubles, as JSON' 3 'a value is not finite' "$etalon" evaluate steep.json uv --order 2 --json
echo kept > c.state
says 'a checkpoint of values beyond all doubles' 3 'c.state cannot be written: a value is not finite' "$etalon" refine f.json --net n.json --with pso --generations 3 --c1 1e100 --vmax 0 --checkpoint c.state
kept 'and the earlier one stays, as ever' c.state
(ulimit -S -f 1; exec "$etalon" compare s.xyz --grid 6x6 --control 5x5 --with de --runs 40 --generations 2 --journal j > out 2> err)
[ $? -eq 4 ] && grep -q 'cannot write j:' err && pass 'a journal that may not grow' || fail 'a journal that may not grow' "$(cat err)"
says 'no terminal to write to' 4 'cannot write /dev/tty' setsid -w "$etalon" generate cube --size 5 -o /dev/tty
# As root nothing is read-only: then as nobody, if that can be.
user=; if [ "$(id -u)" -eq 0 ]; then user="setpriv --reuid 65534 --regid 65534 --clear-groups"; chmod 755 .; fi
cp "$etalon" for-all; echo kept > read-only; chmod 777 .; chmod 444 read-only
if $user true 2> err; then says 'a file that is read-only' 4 'cannot write read-only: Permission denied' $user ./for-all generate cube --size 5 -o read-only; fi
kept 'and it stays' read-only
head -c 70000000 /dev/zero | tr '\0' 1 > long.xyz
says 'a line without end' 3 'long.xyz:1: line of more than 67108864 bytes' "$etalon" train long.xyz
rm long.xyz
python3 - <<'P'
import json
open('many.ply', 'w').write('ply\nformat ascii 1.0\n' + ''.join('element e%d 0\n' % k for k in range(65)) + 'end_header\n')
j = json.load(open('f.json'))
j['data']['uv'] = [[0.5, 0.5]] * 52
json.dump(j, open('own.json', 'w'))
P
says 'a file of more elements than any' 3 'many.ply:67: more than 64 elements' "$etalon" train many.ply
says 'refine: exact, a surface of its own parameters' 3 'own.json has parameters of its own' "$etalon" refine own.json --net n.json --with de --exact

# A surface each of whose views is closed in both directions; the message tells six digits of its error, a surface must know seven.
cat > bend.py <<'P'
import json, re, subprocess, sys
j = json.load(open('f.json'))
for view in j['views'].values():
    p = view['points']
    p[20:25] = p[0:5]
    for i in range(5): p[5 * i + 4] = p[5 * i]
def refined():
    json.dump(j, open('bent.json', 'w'))
    return subprocess.run([sys.argv[1], 'refine', 'bent.json', '--net', 'n.json', '--with', 'de', '--generations', '1', '--spread', '0', '-o', 'bent.out',
                           '--iges', 'bent.igs', '-q'], stderr=subprocess.PIPE, universal_newlines=True)
told = float(re.search('its error there is ([^,]*),', refined().stderr).group(1))
for k in range(-10, 11):
    j['error']['nov'] = told * (1 + 5e-7 * k)
    if refined().returncode == 0: break
P
python3 bend.py "$etalon" 2> err && [ "$(grep -c '^128,4,4,3,3,1,1,' bent.igs)" -eq 2 ] && pass 'IGES tells what is closed' || fail 'IGES tells what is closed' "$(cat err; grep '^128' bent.igs)"

# ---- programs under judgement ----
cat > say.py <<'P'
"""say.py HELLO REPLY [N]: answer hello with HELLO, all else with REPLY; both are Python's escapes of bytes.  The N-th answer is cut short, once."""
import codecs, os, sys
for n, line in enumerate(sys.stdin):
    if len(sys.argv) > 3 and n == int(sys.argv[3]) and not os.path.exists('died'): open('died', 'w').close(); sys.stdout.write(line.split()[0] + ' o'); break
    id = line.split()[0]
    text = codecs.escape_decode(sys.argv[1 if id == '0' else 2])[0]
    sys.stdout.buffer.write(id.encode() + b' ' + text + b'\n'); sys.stdout.flush()
P
hello='ok protocol=1 name=h version=1 ops=span'
want 'no hello, as JSON' 1 "$etalon" conform --adapter "python3 say.py 'hello yourself' x" --json --seed 18446744073709551615
holds 'has a finding and the seed' "j['seed'] == '18446744073709551615' and j['findings'][-1]['operation'] == 'hello'" out
for what in junit trace; do says "--json and --$what to the same place" 2 'standard output for itself' "$etalon" conform --adapter true --json --$what -; done
want 'a name in letters of all alphabets' 1 "$etalon" conform --adapter "python3 say.py 'ok protocol=1 name=\\xc3\\xa9\\xe2\\x82\\xac\\xf0\\x9d\\x84\\x9e\\xc2\\x85\\xed\\xa0\\x80\\xf4\\x90\\x80\\x80\\xc3\\x28\\xff version=1 ops=span' 'ok 77'" --trace talk --findings 1
head -n 1 out | grep -qF 'é€𝄞' && pass 'is told as it is' || fail 'is told as it is' "$(head -n 1 out)"
grep -qF '\xff version=1' talk && pass 'the trace escapes bytes' || fail 'the trace escapes bytes' "$(head -n 5 talk)"
says 'a trace on a full disk' 4 'cannot write /dev/full' "$etalon" conform --adapter "'$etalon' serve" --ops span --trace /dev/full
want 'what is not offered, as JUnit' 1 "$etalon" conform --adapter "python3 say.py '$hello' 'ok 77'" --ops span,basis --junit none.xml
grep -q '<skipped message="unsupported"/>' none.xml && pass 'is skipped' || fail 'is skipped' "$(cat none.xml)"
want 'a baseline of what is wrong' 1 "$etalon" conform --adapter "python3 say.py '$hello' 'ok 77'" --ops span --baseline-write known.json
want 'what is known, as JUnit' 0 "$etalon" conform --adapter "python3 say.py '$hello' 'ok 77'" --ops span --baseline known.json --junit known.xml
grep -q 'all of them known' known.xml && pass 'is skipped, too' || fail 'is skipped, too' "$(cat known.xml)"
want 'a program that dies within a line' 1 "$etalon" conform --adapter "python3 -S say.py '$hello' unsupported 3" --ops span --trace talk --findings 1
grep -q '^! ' talk && pass 'the trace tells' || fail 'the trace tells' "$(tail -n 3 talk)"
echo '[' > cut; says 'a baseline cut short' 3 'cut:' "$etalon" conform --adapter true --baseline cut
echo '{"known": [1]}' > one.base; says 'a baseline of numbers' 3 'not a baseline' "$etalon" conform --adapter true --baseline one.base
mkdir -p prefix/bin prefix/share/etalon/conformance
cp "$etalon" prefix/bin && cp "$vectors"/*.json prefix/share/etalon/conformance
want 'the vectors installed beside the program' 1 prefix/bin/etalon conform --adapter "python3 say.py '$hello' 'ok 77'" --level 1 --ops span --findings 10000
grep -q 'vector: ' out && pass 'are told by name' || fail 'are told by name' "$(tail -n 5 out)"
finish
