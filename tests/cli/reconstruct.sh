#!/bin/sh
. "$(dirname "$0")/kit"
"$etalon" generate sphere -o s.xyz
want "the README's line" 0 "$etalon" reconstruct s.xyz --grid 20x20 --control 12x12 --method chord --approach improved --refine de --seed 1 -o out.d
for f in cloud.ply net.json fit.json surface.json surface.igs surface.obj surface.stl history.csv summary.json report.md cloud.png net.png surface.png error.png convergence.png; do
    exists "$f" out.d/$f
done
s=out.d/summary.json
holds "counts" "(j['som']['non'], j['som']['nov'], j['som']['nor']) == (800, 724, 76)" $s
holds "som" "all(0 < j['som'][k] < 1 for k in ('qe', 'te', 'min_error', 'max_error'))" $s
holds "fit" "all(j['fit'][k] > 0 for k in ('surface_error', 'surface_error_conventional', 'surface_error_joint')) and j['fit']['seam_gap'] == 0 and j['fit']['corner_error'] == 0" $s
holds "refine" "[r['algorithm'] for r in j['refine']] == ['de'] and j['refine'][0]['evaluations'] == 80040 and j['refine'][0]['after'] < j['refine'][0]['before']" $s
holds "closed" "j['surface']['closed'] and j['surface']['seam_gap'] == 0 and j['surface']['from'] == 'de'" $s
holds "volume of the sphere in the unit cube" "0.4 < j['mesh']['volume'] < math.pi / 6" $s
holds "mesh is that of a closed surface" "j['mesh']['triangles'] == 2 * j['mesh']['vertices'] - 4" $s
want "its surface can be refined on" 0 "$etalon" refine out.d/surface.json --net out.d/net.json --with pso --seed 3 -o better.json --generations 100 --json
"$etalon" train s.xyz --grid 20x20 --seed 1 -q -o n.json
same "train gives the same net" n.json out.d/net.json
"$etalon" fit n.json --control 12x12 -q -o f.json
same "fit gives the same surface" f.json out.d/fit.json
"$etalon" refine f.json --net n.json --with de --seed 1 -q -o r.json
same "refine gives the same surface" r.json out.d/surface.json
awk '{ print 1000 + 50 * $1, -20 + 7 * $2, 0.001 * $3 }' s.xyz > far.xyz
want "a cloud elsewhere" 0 "$etalon" reconstruct far.xyz --grid 8x8 --control 5x5 --refine none --no-pictures -o far.d
python3 - <<'P' && pass "the mesh is where the cloud is" || fail "the mesh is where the cloud is"
v = [tuple(map(float, l.split()[1:4])) for l in open('far.d/surface.obj') if l.startswith('v ')]
lo, hi = [min(c) for c in zip(*v)], [max(c) for c in zip(*v)]
ok = all(a - 0.2 * (b - a) < l and h < b + 0.2 * (b - a) and h - l > 0.5 * (b - a) for l, h, (a, b) in zip(lo, hi, ((1000, 1050), (-20, -13), (0, 0.001))))
raise SystemExit(not ok)
P
absent "no pictures when not asked for" far.d/cloud.png
want "again, with pictures and convergence" 0 "$etalon" reconstruct s.xyz --grid 8x8 --control 5x5 --refine ga --generations 5 -q -o again.d
want "and then without" 0 "$etalon" reconstruct s.xyz --grid 8x8 --control 5x5 --refine none --no-pictures -q -o again.d
absent "stale pictures go" again.d/convergence.png
want "joint, all refiners" 0 "$etalon" reconstruct s.xyz --grid 8x8 --control 5x5 --approach joint --refine ga,de,pso,ceres,ceres-full --generations 20 --no-pictures -q -o all.d
holds "the best is taken" "j['surface']['error'] == min(r['after'] for r in j['refine'])" all.d/summary.json
want "conventional without refinement" 0 "$etalon" reconstruct s.xyz --grid 8x8 --control 5x5 --approach conventional --refine none --no-pictures -q -o conv.d
says "conventional with refinement" 2 "refine none" "$etalon" reconstruct s.xyz --approach conventional -o x.d
awk 'BEGIN { for (i = 0; i < 20; i++) for (j = 0; j < 20; j++) print i, j, 5 }' > plane.xyz
awk 'BEGIN { for (i = 0; i < 100; i++) print i, 2 * i, -i }' > line.xyz
for c in plane line; do
    "$etalon" reconstruct $c.xyz --grid 6x6 --control 4x4 --refine pso --generations 5 -q -o $c.d > out 2> err; code=$?
    case $code in 0|3|5) pass "$c: a surface or a named error";; *) fail "$c: a surface or a named error" "exit code $code $(cat err)";; esac
done
want "grid 2x2" 0 "$etalon" reconstruct s.xyz --grid 2x2 --control 2x2 --degree 1x1 --refine de --generations 5 --no-pictures -q -o d22
want "grid 2x50" 0 "$etalon" reconstruct s.xyz --grid 2x50 --control 2x9 --degree 1x3 --refine de --generations 5 --no-pictures -q -o d250
says "no folder named" 2 "output" "$etalon" reconstruct s.xyz
: > file
says "the folder is a file" 4 "file" "$etalon" reconstruct s.xyz --grid 8x8 --control 5x5 --refine none --no-pictures -o file
cp -r all.d before.d
(ulimit -f 60; "$etalon" reconstruct s.xyz --grid 20x20 --control 12x12 --refine none --no-pictures -q -o all.d > out 2> err); code=$?
[ $code -eq 4 ] && pass "disk full" || fail "disk full" "exit code $code $(cat err)"
diff -r all.d before.d > /dev/null && pass "disk full: the earlier result stays" || fail "disk full: the earlier result stays"
timeout -s INT 2 "$etalon" reconstruct s.xyz --refine pso --generations 100000000 -q -o all.d > out 2> err
grep -q "nothing was written" err && pass "interrupted" || fail "interrupted" "$(cat err)"
diff -r all.d before.d > /dev/null && pass "interrupted: the earlier result stays" || fail "interrupted: the earlier result stays"
[ -z "$(ls -A all.d | grep '^\.')" ] && pass "interrupted: nothing is left behind" || fail "interrupted: nothing is left behind" "$(ls -A all.d)"
quick="--grid 6x6 --control 5x5 --refine none --no-pictures -q"
mkdir -p blocked.d/surface.json
echo old > blocked.d/net.json
says "a folder where a file belongs" 4 "surface.json: a folder" "$etalon" reconstruct s.xyz $quick -o blocked.d
[ "$(cat blocked.d/net.json)" = old ] && pass "and nothing was moved" || fail "and nothing was moved"
"$etalon" generate cube -o c.xyz
for k in 1 2 3 4 5 6; do
    "$etalon" reconstruct s.xyz $quick -o both.d & "$etalon" reconstruct c.xyz $quick -o both.d
    wait
    from=$(python3 -c 'import json; print(json.load(open("both.d/summary.json"))["cloud"]["file"])')
    grep -q "Reconstruction of $from" both.d/report.md || mixed=$k
done
[ -z "${mixed:-}" ] && pass "two runs into one folder do not mix" || fail "two runs into one folder do not mix" "run $mixed"
[ -z "$(ls -A both.d | grep '^\.')" ] && pass "no lock, no staging folder is left" || fail "no lock, no staging folder is left" "$(ls -A both.d)"
awk '{ printf "%.6f %.6f %.6f\n", 500000 + $1, 4649776 + $2, 120 + $3 }' s.xyz > utm.xyz
says "the single precision of STL is warned of" 0 "single precision" "$etalon" reconstruct utm.xyz --grid 6x6 --control 5x5 --refine none --no-pictures -o utm.d
holds "and measured" "0.1 < j['mesh']['stl_rounding'] < 0.5" utm.d/summary.json
printf '0 0 0\n1e300 1 1\n-1e300 2 2\n3 3 1e300\n' > huge.xyz
says "a cloud beyond single precision" 3 "STL" "$etalon" reconstruct huge.xyz $quick -o huge.d
absent "and no empty folder is left" huge.d
finish
