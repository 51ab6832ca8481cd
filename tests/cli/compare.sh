#!/bin/sh
. "$(dirname "$0")/kit"
"$etalon" generate sphere -o s.xyz
common="--grid 10x10 --control 5x5,6x7 --method chord,uniform --runs 3 --generations 20 --seed 4"
want "text" 0 "$etalon" compare s.xyz $common
for w in conventional improved joint ceres ga de pso; do grep -q "^  $w " out || { fail "text has $w"; }; done
[ "$(grep -c '^control' out)" -eq 4 ] && pass "a block a case" || fail "a block a case"
want "csv" 0 "$etalon" compare s.xyz $common --format csv -o t.csv
[ "$(wc -l < t.csv)" -eq $((1 + 4 * 8)) ] && pass "a line a contender" || fail "a line a contender"
want "json" 0 "$etalon" compare s.xyz $common --json
cp out t.json
holds "rows" "len(j['rows']) == 32 and all(r['least'] <= r['error'] * (1 + 1e-12) and r['error'] <= r['greatest'] * (1 + 1e-12) for r in j['rows'])" t.json
holds "runs" "all(r['runs'] == (3 if r['contender'] in ('ga', 'de', 'pso') else 1) for r in j['rows'])" t.json
holds "no gaps but in the conventional" "all((r['seam_gap'] == 0) != (r['contender'] == 'conventional') for r in j['rows'])" t.json
want "two threads" 0 "$etalon" compare s.xyz $common --json --threads 2
python3 - <<'P' && pass "threads do not change a figure" || fail "threads do not change a figure"
import json
a, b = json.load(open('t.json'))['rows'], json.load(open('out'))['rows']
for r in a + b: r.pop('seconds')
raise SystemExit(a != b)
P
want "baseline holds" 0 "$etalon" compare s.xyz $common --format json -o again.json --baseline t.json
python3 - <<'P'
import json, math
t = json.load(open('t.json')); t['rows'][4]['least'] = math.nextafter(t['rows'][4]['least'], 9) if hasattr(math, 'nextafter') else t['rows'][4]['least'] * (1 + 2e-16)
json.dump(t, open('altered.json', 'w'))
P
says "one ulp off the baseline" 1 "row 5 differs" "$etalon" compare s.xyz $common --format csv -o x.csv --baseline altered.json
echo "{}" > none.json; says "a baseline that is none" 3 "no table" "$etalon" compare s.xyz --with none --control 5x5 --grid 10x10 --format csv -o x.csv --baseline none.json
want "journal" 0 "$etalon" compare s.xyz $common --json --journal j
lines=$(wc -l < j)
head -n 9 j > k; printf '{"job": 3, "bef' >> k
want "a cut journal is taken up" 0 "$etalon" compare s.xyz $common --json --journal k
[ "$(wc -l < k)" -eq "$lines" ] && pass "and completed" || fail "and completed"
says "a journal of other settings" 3 "other settings" "$etalon" compare s.xyz $common --F 0.4 --json --journal j
want "faithful beside default" 0 "$etalon" compare s.xyz --grid 10x10 --control 6x6 --runs 2 --generations 50 --faithful --json --with de
holds "two modes" "sorted(set(r['readings'] for r in j['rows'])) == ['default', 'faithful']" out
says "empty list" 2 "control" "$etalon" compare s.xyz --control ,
says "twice" 2 "twice" "$etalon" compare s.xyz --method chord,chord
says "unknown refiner" 2 "does not know 'abc'" "$etalon" compare s.xyz --with abc
printf 'my notes' > notes.txt
says "a file that is no journal" 3 "not a journal" "$etalon" compare s.xyz $common --journal notes.txt
[ "$(cat notes.txt)" = "my notes" ] && pass "and it stays" || fail "and it stays"
says "a journal that is no file" 4 "journal" "$etalon" compare s.xyz $common --journal /dev/full
says "one file for two things" 2 "two different files" "$etalon" compare s.xyz $common --json -o t.json --baseline t.json
says "a baseline that is not there" 4 "nofile" "$etalon" compare s.xyz $common --baseline nofile
echo '{' > broken.json
says "a baseline that is not JSON" 3 "broken.json" "$etalon" compare s.xyz $common --baseline broken.json
python3 - <<'P'
import json
for what, change in (('non', lambda t: t['rows'][0].update(error_non=1.0)), ('qe', lambda t: t['som'].update(qe=1.0)), ('seed', lambda t: t.update(seed='9'))):
    t = json.load(open('t.json')); change(t); json.dump(t, open(what + '.json', 'w'))
P
for what in non qe seed; do says "the baseline's $what is compared" 1 "differ" "$etalon" compare s.xyz $common --format csv -o x.csv --baseline $what.json; done
python3 -c "import json; t = json.load(open('t.json')); t['rows'][2]['more'] = 1; json.dump(t, open('more.json', 'w'))"
says "a baseline that knows more" 1 "row 3 differs from the baseline in its more" "$etalon" compare s.xyz $common --format csv -o x.csv --baseline more.json
says "a size twice" 2 "twice" "$etalon" compare s.xyz --control 4x4,4x4
finish
