#!/bin/sh
. "$(dirname "$0")/kit"
"$etalon" generate cube -o c.xyz
"$etalon" train c.xyz --grid 10x10 --seed 2 -q -o n.json
"$etalon" fit n.json --control 6x6 -q -o s.json
for a in ga de pso ceres ceres-full; do
    want "$a" 0 "$etalon" refine s.json --net n.json --with $a --seed 3 --generations 200 --json -o $a.json --history $a.csv
    cp out $a.line
    holds "$a: not worse, and closed" "j['after'] <= j['before'] and j['seam_gap'] == 0" $a.line
    exists "$a: surface" $a.json
    exists "$a: history" $a.csv
done
for a in de pso ceres ceres-full; do holds "$a gains" "j['after'] < j['before']" $a.line; done
holds "evaluations of GA" "j['evaluations'] == 40 + 2 * 200" ga.line
holds "evaluations of DE" "j['evaluations'] == 40 + 40 * 200" de.line
holds "evaluations of PSO" "j['evaluations'] == 40 + 40 * 200" pso.line
python3 -c 'import json
a = {k: json.load(open(k + ".line"))["after"] for k in ("ga", "de", "pso", "ceres", "ceres-full")}
raise SystemExit(not (a["ceres"] < min(a["ga"], a["de"], a["pso"]) and a["ceres-full"] <= a["ceres"] * (1 + 1e-6)))' \
    && pass "Ceres goes lower than the populations, all unknowns lower than points" || fail "Ceres goes lower than the populations, all unknowns lower than points"
for a in ga de pso; do
    "$etalon" refine s.json --net n.json --with $a --seed 3 --generations 6 -q -o whole.json --history whole.csv
    rm -f state
    for g in 1 2 3 4 5 6; do
        "$etalon" refine s.json --net n.json --with $a --seed 3 --generations 1 -q -o steps.json --history steps.csv --checkpoint state $([ $g -gt 1 ] && echo --resume state)
    done
    same "$a: six runs of one generation are one of six" whole.json steps.json
    same "$a: and have one history" whole.csv steps.csv
done
"$etalon" refine s.json --net n.json --with de --seed 3 --generations 3 -q --checkpoint state
says "resume with another seed" 3 "seed" "$etalon" refine s.json --net n.json --with de --seed 4 --resume state
says "resume with other settings" 3 "settings" "$etalon" refine s.json --net n.json --with de --seed 3 --F 0.5 --resume state
says "resume another algorithm" 3 "algorithm" "$etalon" refine s.json --net n.json --with pso --seed 3 --resume state
want "faithful" 0 "$etalon" refine s.json --net n.json --with de --faithful --json
holds "the box keeps the gain small" "0 < j['before'] - j['after'] < 0.01" out
sed 's/"version": 1/"version": 99/' state > later.state
says "a checkpoint of another version" 3 "version" "$etalon" refine s.json --net n.json --with de --seed 3 --resume later.state
python3 -c 'import json; s = json.load(open("state")); s["best_value"] = -1.0; json.dump(s, open("lying.state", "w"))'
says "a checkpoint that lies" 3 "not those of its points" "$etalon" refine s.json --net n.json --with de --seed 3 --resume lying.state
"$etalon" train c.xyz --grid 10x10 --seed 9 -q -o n9.json
says "a net of the same sides, trained otherwise" 3 "not fitted to the net" "$etalon" refine s.json --net n9.json --with de
says "one file for two things" 2 "two different files" "$etalon" refine s.json --net n.json --with de -o x --history x
says "no net" 2 "needed" "$etalon" refine s.json --with de
says "no algorithm" 2 "needed" "$etalon" refine s.json --net n.json
says "population of 3" 2 "population" "$etalon" refine s.json --net n.json --with de --population 3
says "probability over one" 2 "probabilities" "$etalon" refine s.json --net n.json --with de --CR 1.5
"$etalon" train c.xyz --grid 9x10 -q -o other.json
says "another net" 3 "10x10.*9x10" "$etalon" refine s.json --net other.json --with de
"$etalon" fit n.json --control 6x6 --approach conventional -q -o gap.json
says "a surface with a gap" 3 "gap" "$etalon" refine gap.json --net n.json --with de
says "rational surface and DE" 3 "rational" "$etalon" refine ceres-full.json --net n.json --with de
sed 's/"etalon-surface"/"something"/' s.json > wrong.json
says "wrong format" 3 "wrong.json" "$etalon" refine wrong.json --net n.json --with de
cp de.json earlier.json
timeout -s INT 1 "$etalon" refine s.json --net n.json --with de --generations 100000000 -o de.json > out 2> err
grep -q "best so far is in de.json.partial" err && pass "interrupted: says where the best so far is" || fail "interrupted: says where the best so far is" "$(cat err)"
same "interrupted: the earlier result stays" de.json earlier.json
want "the best so far is a surface" 0 "$etalon" refine de.json.partial --net n.json --with ga --generations 2 -q
"$etalon" refine s.json --net n.json --with de --generations 100000000 -o code.json > out 2> err & pid=$!
sleep 1; kill -TERM $pid; wait $pid
[ $? -eq 130 ] && pass "exit code 130" || fail "exit code 130"
finish
