#!/bin/sh
# Words that are no options, values that are none, files that belong to something else, a terminal: each command says which and why.
. "$(dirname "$0")/kit"
"$etalon" generate sphere -o s.xyz -q
"$etalon" train s.xyz --grid 8x8 --seed 2 -q -o n.json
"$etalon" fit n.json --control 5x5 -q -o f.json
few="--grid 8x8 --control 5x5 --refine none --no-pictures -q"

# ---- options ----
says 'no command' 2 'Usage' "$etalon"
says 'no such command' 2 "'fold'" "$etalon" fold
want 'help' 0 "$etalon" --help
grep -q '^  *reconstruct' out && pass 'names the commands' || fail 'names the commands'
want 'version' 0 "$etalon" --version
for c in generate train fit refine compare reconstruct evaluate serve conform; do
    "$etalon" $c --help > out 2> err && grep -q "etalon $c" out && pass "$c --help" || fail "$c --help" "$(cat err)"
    says "$c: an unknown option" 2 "unknown option '--nothing'" "$etalon" $c --nothing
    "$etalon" $c --help > /dev/full 2> err; [ $? -eq 4 ] && pass "$c --help to a full disk" || fail "$c --help to a full disk"
done
says 'a count that is a word' 2 "--iterations wants a whole number, not 'many'" "$etalon" train s.xyz --iterations many
says 'a count beyond all sizes' 2 "--iterations wants a whole number" "$etalon" train s.xyz --iterations 99999999999999999999999
says 'a count below 0' 2 "--iterations wants a whole number, not '-1'" "$etalon" train s.xyz --iterations -1
says 'a size of words' 2 "--grid wants a size" "$etalon" train s.xyz --grid axb
says 'a size with a tail' 2 "--grid wants a size" "$etalon" train s.xyz --grid 20x30x2
says 'a number that is none' 2 "--noise wants a finite number, not 'nan'" "$etalon" generate cube --noise nan
says 'a number with a tail' 2 "--noise wants a finite number" "$etalon" generate cube --noise 1u
says 'a seed beyond 64 bits' 2 "--seed wants a whole number below 2.64" "$etalon" train s.xyz --seed 18446744073709551616
says 'a seed that is a word' 2 "--seed wants a whole number" "$etalon" train s.xyz --seed=x
says 'a flag with a value' 2 '--json takes no value' "$etalon" train s.xyz --json=yes
says 'an option without its value' 2 '--grid wants a value' "$etalon" train s.xyz --grid
says 'a short one without its value' 2 '--output wants a value' "$etalon" train s.xyz -o
says 'a word the option does not know' 2 "--frame does not know|--normalise does not know" "$etalon" train s.xyz --normalise perhaps
says 'no threads' 2 'threads' "$etalon" train s.xyz --threads 0
says 'an argument too many' 2 "'t.xyz' is one argument too many" "$etalon" train s.xyz t.xyz
says 'an argument missing' 2 'an argument is missing' "$etalon" train
want 'a value after =' 0 "$etalon" train s.xyz --grid=5x5 --seed=18446744073709551615 -q
cp s.xyz ./--odd
want 'a file of an odd name after --' 0 "$etalon" train -q --grid 5x5 -- --odd
says 'a size of a list twice' 2 'names 5x5 twice' "$etalon" compare s.xyz --control 5x5,5x5
says 'sizes that are words' 2 'wants sizes such as' "$etalon" compare s.xyz --control 5x5,x
many=$(awk 'BEGIN { for (k = 4; k < 400; k++) printf "%s%dx4", (k > 4 ? "," : ""), k }')
says 'more sizes than there is room' 2 'names more than' "$etalon" compare s.xyz --control "$many"
says 'compare: no runs' 2 '--runs must be at least 1' "$etalon" compare s.xyz --runs 0
says 'compare: a start with a gap' 2 '--start' "$etalon" compare s.xyz --start conventional
says 'compare: one file for two things' 2 'two different files' "$etalon" compare s.xyz --journal x --output x
says 'compare: no cloud' 4 'gone.xyz' "$etalon" compare gone.xyz
says 'compare: a control net that the net cannot carry' 2 'larger than the data' "$etalon" compare s.xyz --grid 5x5 --control 30x30 --with none
says 'refine: a box below 0' 2 'must not be negative' "$etalon" refine f.json --net n.json --with de --box -1
says 'refine: no steps of Ceres' 2 'ceres-iterations' "$etalon" refine f.json --net n.json --with ceres --ceres-iterations 0
says 'refine: a tolerance of 0' 2 'ceres-tolerance' "$etalon" refine f.json --net n.json --with ceres --ceres-tolerance 0
says 'refine: no steps of the optimum' 2 'optimum-iterations' "$etalon" refine f.json --net n.json --with optimum --optimum-iterations 0
says 'refine: a checkpoint of Ceres' 2 'are for ga, de, pso' "$etalon" refine f.json --net n.json --with ceres --checkpoint c
says 'refine: exact, with its own parameters' 2 'parameters' "$etalon" refine f.json --net n.json --with ceres-full --exact
says 'reconstruct: exact, with its own parameters' 2 'parameters' "$etalon" reconstruct s.xyz --exact --refine ceres-full -o x.d
says 'reconstruct: a mesh of one point' 2 '--mesh wants at least 2x2' "$etalon" reconstruct s.xyz --mesh 1x5 -o x.d
says 'reconstruct: no folder name' 2 'no usable folder name' "$etalon" reconstruct s.xyz -o ''
long=$(awk 'BEGIN { for (k = 0; k < 900; k++) printf "long/" }')
says 'reconstruct: a folder name beyond all paths' 2 'no usable folder name' "$etalon" reconstruct s.xyz $few -o "$long"
: > file
says 'reconstruct: a folder in a file' 4 'cannot make the folder' "$etalon" reconstruct s.xyz $few -o file/in/it
says 'reconstruct: a folder below a file' 4 'cannot make the folder' "$etalon" reconstruct s.xyz $few -o file/below
want 'reconstruct: folders within folders' 0 "$etalon" reconstruct s.xyz --grid 8x8 --control 5x5 --refine none --no-pictures --mesh 7x9 --json -o new/within/new.d
holds 'and its result as JSON' "j['points'] == 0 or j['cloud']['points'] > 0 if 'points' in j else j['surface']['closed']" out
says 'reconstruct: no cloud' 4 'gone.xyz' "$etalon" reconstruct gone.xyz -o x.d
says 'generate: noise below 0' 2 '' "$etalon" generate cube --noise -1
want 'generate: its result as JSON' 0 "$etalon" generate cube --size 9 -o c.xyz --json
holds 'tells the file' "j['file'] == 'c.xyz' and j['cloud'] == 'cube' and j['points'] > 0" out
"$etalon" generate cube -o c.xyz --json > /dev/full 2> err; [ $? -eq 4 ] && pass 'JSON to a full disk' || fail 'JSON to a full disk'
want 'fit: exact' 0 "$etalon" fit n.json --control 5x5 --exact --json -o e.json
says 'fit: no net' 4 'gone.json' "$etalon" fit gone.json
says 'evaluate: no surface' 4 'gone.json' "$etalon" evaluate gone.json uv
says 'evaluate: JSON into a file' 2 'without --output' "$etalon" evaluate f.json uv --json --output x
says 'evaluate: parameters that are not there' 4 'gone.txt' "$etalon" evaluate f.json gone.txt

for o in crossover swap mutation CR; do for x in -0.1 1.1; do says "refine: --$o $x" 2 '' "$etalon" refine f.json --net n.json --with ga --$o $x; done; done
for o in 'population 3' 'generations 0' 'tournament 0' 'spread -1' 'vmax -1' 'optimum-iterations 0' 'optimum-gap -1' 'K 1e999' 'seed 1x' 'F x'; do
    says "refine: --$o" 2 "${o%% *}|population|must" "$etalon" refine f.json --net n.json --with ga --${o%% *} "${o#* }"
done
for o in 'iterations 0' 'alpha 0' 'alpha 1.5' 'radius -1' 'grid 1x5' 'grid 5x1' 'grid x5' 'grid 5x99999999999999999999999'; do
    says "train: --$o" 2 "--${o%% *}" "$etalon" train s.xyz --${o%% *} "${o#* }"
done
for o in 'outliers -1' 'outliers 2' 'noise inf'; do says "generate: --$o" 2 '' "$etalon" generate cube --${o%% *} "${o#* }"; done
for m in 5x1 0x5 5x0; do says "reconstruct: a mesh of $m" 2 '--mesh wants' "$etalon" reconstruct s.xyz --mesh $m -o x.d; done
for o in 'timeout 1e7' 'timeout -1'; do says "conform: --$o" 2 'timeout' "$etalon" conform --adapter true --${o%% *} "${o#* }"; done
for w in help -h; do want "$w" 0 "$etalon" $w; done
"$etalon" --help > /dev/full 2> err; [ $? -eq 4 ] && pass 'help to a full disk' || fail 'help to a full disk'
want 'a short help' 0 "$etalon" train -h
want 'faithful, with a box of its own' 0 "$etalon" refine f.json --net n.json --with de --generations 2 --faithful --box 1e-4 -q
want 'noise alone' 0 "$etalon" generate cube --size 5 --noise 0.01 -q -o c.xyz
want 'outliers alone' 0 "$etalon" generate cube --size 5 --outliers 0.1 -q -o c.xyz
want 'quiet, a fit' 0 "$etalon" fit n.json --control 5x5 -q
for c in 'train s.xyz --grid 5x5' 'fit n.json --control 5x5' 'refine f.json --net n.json --with de --generations 2' 'generate cube --size 5'; do
    "$etalon" $c -o - > out 2> err; [ $? -eq 0 ] && [ -s out ] && pass "${c%% *} to standard output" || fail "${c%% *} to standard output" "$(cat err)"
    "$etalon" $c --json > /dev/full 2> err; [ $? -eq 4 ] && pass "${c%% *} --json to a full disk" || fail "${c%% *} --json to a full disk" "$(cat err)"
done

# ---- checkpoints and journals of something else ----
"$etalon" refine f.json --net n.json --with pso --seed 3 --generations 2 -q --checkpoint p.state
echo '[1]' > none.state
says 'a checkpoint that is none' 3 'not a checkpoint' "$etalon" refine f.json --net n.json --with pso --seed 3 --resume none.state
echo '{' > cut.state
says 'a checkpoint cut short' 3 'cut.state:' "$etalon" refine f.json --net n.json --with pso --seed 3 --resume cut.state
says 'a checkpoint that is not there' 4 'gone.state' "$etalon" refine f.json --net n.json --with pso --seed 3 --resume gone.state
alter() { python3 -c "import json; s = json.load(open('p.state')); $1; json.dump(s, open('a.state', 'w'))"; }
altered() { alter "$2"; says "a checkpoint: $1" 3 "$3" "$etalon" refine f.json --net n.json --with pso --seed 3 --resume a.state; }
altered 'of another surface' "s['x0'][0] += 1" 'begun from another surface'
altered 'without velocities' "del s['velocity']" 'member of the swarm is missing'
altered 'a velocity too few' "s['velocity'].pop()" 'member of the swarm'
altered 'a word for a number' "s['x'][0] = 'one'" 'missing or malformed'
altered 'a number beyond all' "s['best'][0] = True" 'missing or malformed'
altered 'a generation below 0' "s['generation'] = '-1'" 'missing or malformed'
altered 'draws that nobody made' "s['draws'] = '18446744073709551615'" 'more draws'
altered 'a memory that lies' "s['remembered'][0] -= 1" 'not those of its points'
altered 'another seed' "s['seed'] = 'x'" 'seed'
altered 'a generation that is a number' "s['generation'] = 2" 'missing or malformed'
altered 'evaluations that are none' "s['evaluations'] = ''" 'missing or malformed'
altered 'draws with a tail' "s['draws'] += 'x'" 'missing or malformed'
altered 'no best value' "del s['best_value']" 'missing or malformed'
altered 'a value too few' "s['value'].pop()" 'missing or malformed'
altered 'a history too short' "s['history'].pop()" 'missing or malformed'
altered 'no start' "del s['x0']" 'begun from another surface'
altered 'a memory too short' "s['memory'].pop()" 'member of the swarm'
altered 'no remembered values' "del s['remembered']" 'member of the swarm'
altered 'settings too few' "s['settings'].pop()" 'settings'
altered 'a value that lies' "s['value'][0] -= 1" 'not those of its points'
altered 'a best value that lies' "s['best_value'] -= 1" 'not those of its points'
altered 'no format' "del s['format']" 'not a checkpoint'
altered 'another format' "s['format'] = 'x'" 'not a checkpoint'
altered 'another version' "s['version'] = 2" 'only version 1'
altered 'no algorithm' "del s['algorithm']" 'algorithm'
few="--grid 8x8 --control 5x5 --with de --runs 2 --generations 2 --seed 4"
"$etalon" compare s.xyz $few --json --journal j > whole
printf '{"job": 99999, "evaluations": 1, "steps": 1}\n' > line
{ head -n 1 j; cat line; } > far.j
says 'a journal of a run that is not asked for' 3 'far.j:2: not a line of a journal' "$etalon" compare s.xyz $few --journal far.j
{ head -n 1 j; printf '{"job": 0, "evaluations": 1, "steps": 1, "before": "x"}\n'; } > word.j
says 'a journal with a word for a number' 3 'word.j:2' "$etalon" compare s.xyz $few --journal word.j
mkdir folder.j
says 'a journal that is a folder' 4 'not a file' "$etalon" compare s.xyz $few --journal folder.j
says 'a journal in no folder' 4 'cannot open' "$etalon" compare s.xyz $few --journal no/such/j
says 'a baseline that is not there' 4 'gone.json' "$etalon" compare s.xyz $few --baseline gone.json
timeout -s INT 1 "$etalon" compare s.xyz --grid 8x8 --control 5x5 --with de --runs 2 --generations 100000000 > out 2> err
grep -q -- '--journal FILE keeps finished runs' err && pass 'interrupted: what would have kept the runs' || fail 'interrupted: what would have kept the runs' "$(cat err)"
timeout -s INT 1 "$etalon" compare s.xyz --grid 8x8 --control 5x5 --with de --runs 2 --generations 100000000 --journal i.j > out 2> err
grep -q 'finished runs are in i.j' err && pass 'interrupted: where the runs are' || fail 'interrupted: where the runs are' "$(cat err)"

# ---- interruption at each command, twice, and a terminal ----
timeout -s INT 1 "$etalon" fit n.json --control 7x7 --refine-solution -q -o f2.json > out 2> err
absent_parts() { [ -z "$(ls -A | grep -E '\.part|\.lock')" ]; }
absent_parts && pass 'no part is left' || fail 'no part is left' "$(ls -A)"
"$etalon" reconstruct s.xyz --grid 20x20 --control 12x12 --refine pso --generations 100000000 --no-pictures -o twice.d > out 2> err & pid=$!
sleep 1; kill -INT $pid; sleep 0.5; kill -INT $pid 2> /dev/null; wait $pid
[ $? -eq 130 ] && pass 'interrupted twice' || fail 'interrupted twice' "$(cat err)"
cat > terminal.py <<'P'
"""terminal.py COMMAND...: run it on a terminal of its own; print what it showed."""
import os, pty, sys
shown = b''
def keep(fd):
    global shown
    data = os.read(fd, 4096)
    shown += data
    return b''
code = pty.spawn(sys.argv[1:], keep)
sys.stdout.buffer.write(shown)
sys.exit(os.waitstatus_to_exitcode(code) if hasattr(os, 'waitstatus_to_exitcode') else code >> 8)
P
name='progress on a terminal: rate and time left'
if python3 -c 'import os; os.openpty()' 2> err; then
    python3 terminal.py "$etalon" refine f.json --net n.json --with de --generations 20000 < /dev/null > shown 2> err
    grep -qE '%.*/s.*s left' shown && pass "$name" || fail "$name" "$(head -c 300 shown)"
else
    echo "left out $group $name: $(tail -n 1 err)"
fi
"$etalon" refine f.json --net n.json --with de --generations 300 > out 2> err < /dev/null
grep -q 'left' err && fail 'none off a terminal' || pass 'none off a terminal'
"$etalon" refine f.json --net n.json --with de --generations 300 --progress -q > out 2> err
grep -q 'left' err && fail 'none when quiet' || pass 'none when quiet'
"$etalon" refine f.json --net n.json --with de --generations 300 --progress > out 2> err
grep -q 'left' err && pass 'progress when asked for' || fail 'progress when asked for'
finish
