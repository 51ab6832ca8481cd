#!/bin/sh
# Programs that answer wrongly, late, never, too much, or not what was asked: each ends in bounded time, with the right counts.
here=$(cd "$(dirname "$0")" && pwd)
adapters=$here/../adapters
. "$here/kit"
vectors=$(cd "$here/../../golden/conformance" && pwd)

# ---- cases side by side: each in a folder of its own, so many at once, told in order ----
MARK=$$                                   # sleeps of ours, and of nobody else
export MARK
mkfifo tokens && exec 3<> tokens && for k in 1 2 3 4 5 6 7 8; do echo >&3; done
jobs=0
job() {
    jobs=$((jobs + 1))
    place=$dir/$((1000 + jobs))
    mkdir "$place" && cp h.py deaf.py "$place"
    read -r token <&3
    { cd "$place" && "$@" > told 3>&-; echo >&3; } &
}
all_told() {
    wait
    cat "$dir"/1[0-9][0-9][0-9]/told
    if grep -q '^FAIL' "$dir"/1[0-9][0-9][0-9]/told; then failures=1; fi
}

# ---- a program that answers two operations rightly, and how it may go wrong ----
cat > h.py <<'P'
import math, os, sys, time          # the rest where it is needed: it is started often
mode = sys.argv[1]
ops, asked, at = 'span,multiplicity', 0, int(os.environ.get('AT', 5))      # at: the request where it happens
mark = os.environ['MARK']
def multiplicity(words):
    n = int(words[0]); u = [float.fromhex(w) for w in words[1:1 + n]]; x = float.fromhex(words[1 + n])
    if not all(map(math.isfinite, u + [x])) or u != sorted(u): return 'refused'
    return 'ok %d' % u.count(x)
def span(words):
    p, n = int(words[0]), int(words[1]); u = [float.fromhex(w) for w in words[2:2 + n]]; x = float.fromhex(words[2 + n])
    if n < 2 * p + 2 or not all(map(math.isfinite, u + [x])) or u != sorted(u) or not u[p] < u[n - p - 1]: return 'refused'
    if not u[p] <= x <= u[n - p - 1]: return 'refused'
    k = n - p - 2
    while k > p and (x < u[k] or u[k] == u[n - p - 1]): k -= 1
    return 'ok %d' % k
def say(text): sys.stdout.write(text); sys.stdout.flush()
def hang():
    open('hangs', 'w').close()
    while True: time.sleep(100)
if mode == 'hangs at start': hang()
if mode == 'deaf':
    import signal
    [signal.signal(s, signal.SIG_IGN) for s in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGPIPE)]; hang()
if mode == 'ends at start': sys.exit(0)
if mode == 'dies at start': os.kill(os.getpid(), 11)
if mode == 'talks first': say('welcome\n')
if mode == 'closes its input': os.close(0); say('0 ok protocol=1 name=h version=1 ops=span\n'); time.sleep(0.3); hang()
if mode == 'random': import random
if 'child' in mode: import subprocess
waiting = None
for line in sys.stdin:
    id, op, *words = line.split()
    if op == 'hello':
        if mode == 'dies at every start again':
            if os.path.exists('started'): sys.exit(3)
            open('started', 'w').close()
        if mode == 'another hello':
            if os.path.exists('started'): ops = 'span'
            open('started', 'w').close()
        if mode == 'lies': ops += ',greville,basis'
        if mode == 'offers nothing': ops = ''
        if mode == 'offers the unknown': ops += ',fold,spindle'
        if mode == 'hello of two': say('0 ok protocol=2 name=h version=1 ops=span\n'); continue
        if mode == 'hello without a name': say('0 ok protocol=1 ops=span\n'); continue
        if mode == 'hello of rubbish': say('hello yourself, <&"\n'); continue
        if mode == 'hello of bytes': sys.stdout.buffer.write(bytes(range(256)) * 20 + b'\n'); sys.stdout.flush(); continue
        if mode == 'hello without end': say('0 ok protocol=1 name=h'); hang()
        if mode == 'hello for ever':
            while True: sys.stdout.write('x' * 65536)
        if mode == 'a name of bytes': sys.stdout.buffer.write(b'0 ok protocol=1 name=\xff<&> version=" ops=span,multiplicity\n'); sys.stdout.flush(); continue
        say('0 ok protocol=1 name=h version=1 ops=%s\n' % ops); continue
    asked += 1
    reply = {'span': span, 'multiplicity': multiplicity}.get(op, lambda w: 'unsupported')(words)
    ok = reply.startswith('ok')
    if mode == 'hangs later' and asked == at: hang()
    if mode == 'always hangs' and op == 'span': hang()
    if mode == 'always dies' and op == 'span': os.abort()
    if mode == 'ends later' and asked == at: sys.exit(0)
    if mode == 'dies later' and asked == at: os.kill(os.getpid(), 9)
    if mode == 'dies after each': say('%s %s\n' % (id, reply)); sys.exit(0)
    if mode == 'dies at every start again' and asked == 3: sys.exit(3)
    if mode == 'another hello' and asked == at: sys.exit(0)
    if mode == 'another number' and asked % 2: say('%d %s\n' % (int(id) - 1, reply)); continue
    if mode == 'out of order':
        if waiting is None: waiting = '%s %s\n' % (id, reply); say('%s ok 0\n' % (int(id) + 1))
        else: say('%s %s\n' % (id, reply) + waiting); waiting = None
        continue
    if mode == 'twice': say(('%s %s\n' % (id, reply)) * 2); continue
    if mode == 'one for ever' and asked == 3:
        while True: sys.stdout.write('1 ok ' + '0 ' * 65536)
    if mode == 'half a line' and asked == at: say('%s ok 0' % id); sys.exit(0)
    if mode == 'half a line, then nothing' and asked == at: say('%s ok 0' % id); hang()
    if mode == 'bytes' and ok: sys.stdout.buffer.write(b'\0\xff\x1b[31m\r' + id.encode() + b'\n'); sys.stdout.flush(); continue
    if mode == 'a zero byte' and ok: say('%s ok 0\0 1\n' % id); continue
    if mode == 'words' and ok: say('%s ok many\n' % id); continue
    if mode == 'not a number' and ok: say('%s ok nan\n' % id); continue
    if mode == 'two numbers' and ok: say('%s ok 0x1p+0 0x1p+0\n' % id); continue
    if mode == 'no number' and ok: say('%s ok\n' % id); continue
    if mode == 'accepts all' and not ok: reply = 'ok 1'
    if mode == 'refuses all': reply = 'refused <because> & "so"'
    if mode == 'off by one' and op == 'span' and ok: reply = 'ok %d' % (int(reply[3:]) + 1)
    if mode == 'decimal' and ok: reply = 'OK'.lower() + ' %.17g' % float(reply[3:])
    if mode == 'random' and ok: reply = 'ok %d' % random.randrange(10)
    if mode == 'stateful' and ok and asked % 7 == 0: reply = 'ok 77'
    if mode == 'slow': time.sleep(0.01)
    if mode == 'drops out' and asked > 40: reply = 'unsupported'
    if mode == 'closes its output' and asked == at: os.close(1); hang()
    if mode == 'a child keeps the pipe' and asked == at: subprocess.Popen(['sleep', '1000.' + mark]); os._exit(0)
    if mode == 'children' and asked == at: subprocess.Popen(['sh', '-c', 'sleep 1000.%s & sleep 1000.%s' % (mark, mark)]); hang()
    if mode == 'late' and asked == at: time.sleep(3)
    if mode == 'trickles' and asked == at:
        for c in '%s ok 0 0 0 0 0 0 0 0 0 0\n' % id: say(c); time.sleep(0.2)
    if mode == 'splits': [say(c) for c in '%s %s\r\n' % (id, reply)]; continue
    say('%s %s\n' % (id, reply))
if mode == 'no end': hang()
P

cat > deaf.py <<'P'
import sys, time
for line in sys.stdin:
    if 'hello' in line: print('0 ok protocol=1 name=deaf version=1 ops=fit_grid,curve_point', flush=True); time.sleep(1000)
P

# Programs that hang are given two seconds a reply; the others, which a busy machine may be slow to start, ten.
limit=10 ops=span,multiplicity,greville
judge() {
    mode=$1 code=$2 expression=$3; shift 3
    timeout -k 1 300 "$etalon" conform --adapter "python3 -S h.py '$mode'" --findings 1 --ops $ops --timeout $limit --json "$@" > out.json 2> said
    got=$?
    if [ "$got" -ne "$code" ]; then fail "$mode" "exit code $got, not $code: $(head -c 300 said)"; return; fi
    holds "$mode" "(lambda v, o, f: $expression)(j['verdicts'], j['operations'], j['findings'])" out.json
}
# run MODE CODE EXPRESSION [OPTION...]: judged in bounded time, with this exit code; the JSON object holds the expression.
run() { job judge "$@"; }
# few: the same with one operation, for what costs a new process at each request; late: what hangs, and at the 20th request of each process.
few() { ops=multiplicity; job judge "$@"; ops=span,multiplicity,greville; }
late() { ops=multiplicity limit=2 AT=20; export AT; job judge "$@"; unset AT; ops=span,multiplicity,greville limit=10; }
mute() { limit=2; job judge "$@"; limit=10; }
bad="sum(n for k, n in v.items() if k not in ('correctly_rounded', 'within_bound', 'unsupported'))"
start='sum(v.values()) == 1'

run right 0 "$bad == 0 and len(v) == 11 and o['span']['correctly_rounded'] > 5 and v['unsupported'] > 0 and j['refused_rightly'] > 0 and f == []"
run decimal 0 "$bad == 0"
run splits 0 "$bad == 0"
run slow 0 "$bad == 0"
run 'no end' 0 "$bad == 0"
run 'offers the unknown' 0 "$bad == 0"
run 'a name of bytes' 0 "$bad == 0 and j['adapter']['name'] == '?<&>'"

mute 'hangs at start' 1 "$start and v['timeout'] == 1"
mute deaf 1 "$start and v['timeout'] == 1"
run 'ends at start' 1 "$start and v['crash'] == 1 and 'exit code 0' in f[0]['text']"
run 'dies at start' 1 "$start and v['crash'] == 1 and ('signal 11' in f[0]['text'] or '139' in f[0]['text'])"
run 'talks first' 1 "$start and v['wrong'] == 1"
run 'closes its input' 1 "$bad >= 1 and v['wrong'] + v['crash'] >= 1"
run 'hello of two' 1 "$start and v['wrong'] == 1 and 'protocol=2' in f[0]['text']"
run 'hello without a name' 1 "$start and v['wrong'] == 1 and 'name is missing' in f[0]['text']"
run 'hello of rubbish' 1 "$start and v['wrong'] == 1"
run 'hello of bytes' 1 "$start and v['wrong'] == 1"
mute 'hello without end' 1 "$start and v['timeout'] == 1"
run 'hello for ever' 1 "$start and v['wrong'] == 1 and 'does not end' in f[0]['text']"
greetings() {
    says 'a hello that is none, for people' 3 'wrong: hello' "$etalon" conform --adapter "python3 h.py 'hello of rubbish'"
    says 'offers nothing' 3 'offers none of the operations' "$etalon" conform --adapter "python3 h.py 'offers nothing'" --json
    says 'offers none of them' 3 'offers none of the operations' "$etalon" conform --adapter "python3 h.py right" --ops basis
    says 'no such command' 4 'cannot start' "$etalon" conform --adapter ./nothing
    says 'not executable' 4 'cannot start' "$etalon" conform --adapter ./h.py --json
}
job greetings

late 'hangs later' 1 "v['timeout'] > 0 and v['correctly_rounded'] > 0 and $bad == v['timeout'] + v['nondeterministic']"
mute 'always hangs' 1 "o['span']['timeout'] == 3 and j['skipped'] > 5 and o['multiplicity']['correctly_rounded'] > 5"
run 'always dies' 1 "o['span']['crash'] == 8 and j['skipped'] >= 5 and o['multiplicity']['correctly_rounded'] > 5"
few 'ends later' 1 "v['crash'] > 0 and v['correctly_rounded'] > 0 and $bad == v['crash'] + v['nondeterministic']"
few 'dies later' 1 "v['crash'] > 0 and ('signal 9' in f[0]['text'] or '137' in f[0]['text'])"
few 'dies after each' 1 "v['crash'] > 0 and v['wrong'] == 0"
starts_no_more() {
    judge 'dies at every start again' 1 "v['crash'] == 2"
    grep -q 'does not start any more' said && pass 'and says so' || fail 'and says so' "$(cat said)"
}
ops=multiplicity
job starts_no_more
ops=span,multiplicity,greville
few 'another hello' 1 "v['nondeterministic'] > 0 and any('hello was another' in g['text'] for g in f)"
few 'another number' 1 "v['wrong'] > 5 and 'answered' in f[0]['text'] and 'when asked' in f[0]['text']"
few 'out of order' 1 "v['wrong'] > 5"
few twice 1 "v['wrong'] > 5 and 'nothing had asked for' in f[0]['text'] + f[-1]['text']"
few 'one for ever' 1 "v['wrong'] > 0 and any('does not end' in g['text'] for g in f)"
few 'half a line' 1 "v['crash'] > 0"
late 'half a line, then nothing' 1 "v['timeout'] > 0"
few bytes 1 "v['wrong'] > 5"
few 'a zero byte' 1 "v['wrong'] > 5"
few words 1 "v['wrong'] > 5 and 'is not a number' in f[0]['text']"
run 'not a number' 1 "v['non_finite'] + v['wrong'] > 5"
run 'two numbers' 1 "v['wrong'] > 5"
run 'no number' 1 "v['wrong'] > 5"
run 'accepts all' 1 "v['wrongly_accepted'] > 0 and v['wrongly_refused'] == 0"
run 'refuses all' 1 "v['wrongly_refused'] > 5 and v['correctly_rounded'] > 0"
run lies 1 "v['wrongly_refused'] == 1 and o['greville']['wrongly_refused'] == 1 and o['greville']['unsupported'] > 0 and 'offers it' in f[0]['text']"
run 'off by one' 1 "o['span']['wrong'] > 5 and o['multiplicity']['wrong'] == 0 and all(g['shrunk'] for g in f) and min(len(g['shrunk'].split()) for g in f) <= 7"
run random 1 "v['nondeterministic'] > 5"
few stateful 1 "v['nondeterministic'] > 0 and v['wrong'] >= 0"
few 'drops out' 1 "v['nondeterministic'] > 0"
few 'closes its output' 1 "v['crash'] > 0 and v['timeout'] == 0"
few 'a child keeps the pipe' 1 "v['crash'] > 0 and v['timeout'] == 0"
late children 1 "v['timeout'] > 0"
late late 1 "v['timeout'] > 0"
late trickles 1 "v['timeout'] > 0"

# An adapter that does not read while a long request is written.
never_reads() {
    timeout -k 1 300 "$etalon" conform --adapter 'python3 -S deaf.py' --timeout 1.5 --json > out.json 2> err
    holds 'a program that never reads' "j['verdicts']['timeout'] == 6 and j['skipped'] > 0" out.json
}
job never_reads

# ---- files, options, interruption ----
good="python3 -S h.py right" wrong="python3 -S h.py 'off by one'" ops="--ops span,multiplicity"
junit() {
    want 'JUnit' 1 "$etalon" conform --adapter "$wrong" $ops --junit out.xml
    python3 - <<'P' && pass 'JUnit is XML that holds the counts' || fail 'JUnit is XML that holds the counts'
import xml.etree.ElementTree as E
suite = E.parse('out.xml').getroot().find('testsuite')
cases = suite.findall('testcase')
failed = [c for c in cases if c.find('failure') is not None]
assert int(suite.get('tests')) == len(cases) and int(suite.get('failures')) == len(failed) > 0
assert all(c.get('classname') == 'span' for c in failed) and any("| python3 -S h.py 'off by one'" in c.find('failure').text for c in failed)
P
    want 'JUnit of a program that says rubbish' 1 "$etalon" conform --adapter "python3 h.py 'hello of rubbish'" --json --junit bad.xml
    python3 -c "import xml.etree.ElementTree as E; assert E.parse('bad.xml').getroot().find('testsuite').get('failures') == '1'" && pass 'is XML' || fail 'is XML'
    want 'JUnit of reasons with marks' 1 "$etalon" conform --adapter "python3 h.py 'refuses all'" $ops --junit marks.xml
    python3 -c "import xml.etree.ElementTree as E; E.parse('marks.xml')" && pass 'is XML, too' || fail 'is XML, too'
}
job junit

until_there() { tries=0; while [ ! -e "$1" ] && [ $tries -lt 600 ]; do sleep 0.1; tries=$((tries + 1)); done; }
baselines() {
    want 'a baseline is written' 1 "$etalon" conform --adapter "$wrong" $ops --baseline-write known.json
    cp known.json kept.json
    "$etalon" conform --adapter "touch begun; exec '$etalon' serve" --level 2 --cases 1000000 --baseline-write kept.json > out 2> err & asking=$!
    until_there begun
    sleep 0.5
    kill -INT $asking; wait $asking; got=$?
    [ $got -eq 130 ] && pass 'a run is interrupted' || fail 'a run is interrupted' "exit code $got"
    same 'an interrupted run leaves the baseline' known.json kept.json
    want 'what is known is no failure' 0 "$etalon" conform --adapter "$wrong" $ops --baseline known.json
    want 'another fault is' 1 "$etalon" conform --adapter "python3 h.py 'accepts all'" $ops --baseline known.json
    want 'the JSON is made' 1 "$etalon" conform --adapter "$wrong" $ops --json
    cp out before.json
    want 'and is a baseline' 0 "$etalon" conform --adapter "$wrong" $ops --baseline before.json --json
    want 'the same again' 1 "$etalon" conform --adapter "$wrong" $ops --json
    same 'the same seed, the same report' before.json out
    says 'a baseline that is not there' 4 'nofile' "$etalon" conform --adapter "$good" --baseline nofile
    echo '{}' > none.json; says 'a baseline that is none' 3 'not a baseline' "$etalon" conform --adapter "$good" --baseline none.json
}
job baselines

told() {
    "$etalon" conform --adapter "true; $wrong" $ops > out 2> err
    if grep "echo '1" out | grep -qv '| (true; .*)$'; then fail 'several commands stand in brackets' "$(grep -m 1 echo out)"; else pass 'several commands stand in brackets'; fi
    want 'the conversation' 0 "$etalon" conform --adapter "$good" $ops --trace talk
    grep -q '^> 0 hello 1$' talk && grep -q '^< 0 ok protocol=1' talk && grep -q '^> 1 span ' talk && grep -q '^< 1 ' talk && pass 'is in the trace' || fail 'is in the trace' "$(head -c 200 talk)"
    want 'findings can be left out' 1 "$etalon" conform --adapter "$wrong" $ops --findings 0
    grep -q '^1\. ' out && fail 'none is told' || pass 'none is told'
    want 'a finding can be tried' 1 "$etalon" conform --adapter "$wrong" $ops --findings 1
    sh -c "$(grep -m 1 "^    echo '1 " out)" > again; sed -n 's/^    reply: /1 /p' out | head -n 1 > said
    python3 -c "a, b = (open(f).read().split() for f in ('again', 'said')); assert a[:2] == b[:2] and float(a[2]) == float.fromhex(b[2])" 2> err && pass 'and shows what was told' || fail 'and shows what was told' "$(cat again said)"
}
job told

options() {
    says 'no adapter' 2 'adapter is missing' "$etalon" conform
    says 'no such operation' 2 "'fold'" "$etalon" conform --adapter "$good" --ops span,fold
    says 'no such level' 2 'level' "$etalon" conform --adapter "$good" --level 4
    says 'no time' 2 'timeout' "$etalon" conform --adapter "$good" --timeout 0
    says 'one file for two things' 2 'two different files' "$etalon" conform --adapter "$good" --junit x --trace x
    says 'no vectors' 4 'no frozen vectors' "$etalon" conform --adapter "$good" --level 1 --vectors .
    says 'a file that cannot be written' 4 'cannot write' "$etalon" conform --adapter "$good" $ops --junit no/such/place.xml
    "$etalon" conform --adapter "$good" $ops --json > /dev/full 2> err; [ $? -eq 4 ] && pass 'a full disk' || fail 'a full disk'
}
job options

interrupted() {
    "$etalon" conform --adapter "python3 -S h.py 'always hangs'" $ops --timeout 300 --json > out 2> err & asking=$!
    until_there hangs
    kill -INT $asking; wait $asking; got=$?
    [ $got -eq 130 ] && pass 'interrupted' || fail 'interrupted' "exit code $got"
    holds 'the report so far' "j['interrupted']" out
}
job interrupted

# ---- Etalon itself, the templates, the sample ----
itself() {
    want 'Etalon' 0 "$etalon" conform --adapter "'$etalon' serve" --level 1 --vectors "$vectors" --timeout 60 --json
    holds 'Etalon is within the bound' "j['asked'] >= 5000 and sum(n for k, n in j['verdicts'].items() if k not in ('correctly_rounded', 'within_bound', 'unsupported')) == 0" out
}
exactly() { want 'Etalon, exactly' 0 "$etalon" conform --adapter "'$etalon' serve --exact" --timeout 60 --json; }
templates() {
    ${CC:-cc} -std=c99 -Wall -Wextra -o template "$adapters/template/adapter.c" 2> err && pass 'the template in C compiles' || fail 'the template in C compiles' "$(cat err)"
    for a in ./template "python3 '$adapters/template/adapter.py'"; do
        want "$a" 0 "$etalon" conform --adapter "$a" --level 2 --cases 500 --vectors "$vectors" --json
        holds 'answers three operations' "all(j['operations'][o]['correctly_rounded'] > 50 for o in ('span', 'basis', 'curve_point'))" out
    done
}
# The walk-through of docs/conformance.md, command by command.
walk_through() {
    cp -r "$adapters/sample" sample
    (cd sample && PATH=$(dirname "$etalon"):$PATH && etalon conform --adapter 'python3 adapter.py') > walk 2> err; got=$?
    [ $got -eq 1 ] && grep -q '^1\. span, extreme_scale: wrong$' walk && pass 'the planted fault is found' || fail 'the planted fault is found' "$(cat err)"
    line=$(grep -m 1 "^    echo '1 span" walk); grep -qF "$line" "$here/../../docs/conformance.md" && pass 'as the page tells' || fail 'as the page tells' "$line"
    sed 's/abs(x - u\[n\]) < 1e-7/x == u[n]/' sample/spline.py > new && mv new sample/spline.py
    (cd sample && PATH=$(dirname "$etalon"):$PATH && etalon conform --adapter 'python3 adapter.py' --level 1 --vectors "$vectors") > walk 2> err; got=$?
    [ $got -eq 0 ] && pass 'and is gone when mended' || fail 'and is gone when mended' "$(head -n 20 walk)"
}
job itself
job exactly
job templates
job walk_through

all_told
sleep 0.2
if ps -A -o args | grep -E "^sleep 1000\.$MARK\$" > left; then fail 'no process is left' "$(cat left)"; else pass 'no process is left'; fi
finish
