#!/bin/sh
. "$(dirname "$0")/kit"
"$etalon" generate sphere -o s.xyz
"$etalon" train s.xyz --grid 12x14 --seed 3 -q -o n.json
for a in conventional improved joint; do
    want "$a" 0 "$etalon" fit n.json --approach $a --control 7x8 --json -o $a.json
    cp out $a.line
    holds "$a: error and greatest" "0 < j['greatest_error'] < j['surface_error'] < j['surface_error_non']" $a.line
done
holds "conventional leaves a gap" "j['seam_gap'] > 1e-6" conventional.line
for a in improved joint; do holds "$a: no gap, bit for bit" "j['seam_gap'] == 0" $a.line; done
holds "improved interpolates the corners" "j['corner_error'] == 0" improved.line
want "joint with interpolated corners" 0 "$etalon" fit n.json --approach joint --corners interpolated --control 7x8 --json
holds "joint interpolates when asked" "j['corner_error'] == 0 and j['seam_gap'] == 0" out
for m in uniform chord centripetal exponential; do
    for d in 1x1 2x3 5x4; do want "$m $d" 0 "$etalon" fit n.json --method $m --degree $d --control 7x7 --json; holds "$m $d has no gap" "j['seam_gap'] == 0" out; done
done
# That the switch works; the solvers' agreement within a derived bound is tested in tests/fit/test_fit.c and test_linalg.c.
for g in qr cholesky svd; do "$etalon" fit n.json --approach joint --algebra $g --control 7x8 --json > $g.line; done
python3 -c 'import json
e = [json.load(open(g + ".line"))["surface_error"] for g in ("qr", "cholesky", "svd")]
raise SystemExit(max(e) - min(e) > 1e-9 * e[0])' && pass "QR, Cholesky and SVD agree" || fail "QR, Cholesky and SVD agree"
want "faithful knots" 0 "$etalon" fit n.json --faithful --json
holds "are named" "j['knots'] == 'faithful'" out
want "control net as large as the data" 0 "$etalon" fit n.json --control 12x14
says "control net larger than the data" 2 "13x14|larger" "$etalon" fit n.json --control 13x14
says "degree too high for the control net" 2 "degree|control" "$etalon" fit n.json --control 4x4 --degree 4x4
says "degree 0" 2 "degree" "$etalon" fit n.json --degree 0x3
says "unknown approach" 2 "does not know 'best'" "$etalon" fit n.json --approach best
says "not a net" 3 "joint.json" "$etalon" fit joint.json
head -c 1000 n.json > cut.json
says "truncated net" 3 "cut.json" "$etalon" fit cut.json
says "missing net" 4 "gone.json" "$etalon" fit gone.json
"$etalon" train s.xyz --grid 2x2 -q -o n22.json
want "2x2 net" 0 "$etalon" fit n22.json --control 2x2 --degree 1x1 --json
holds "2x2 has no gap" "j['seam_gap'] == 0" out
want "IGES" 0 "$etalon" fit n.json --iges s.igs
[ "$(awk 'length($0) != 80' s.igs | wc -l)" -eq 0 ] && pass "IGES lines have 80 columns" || fail "IGES lines have 80 columns"
cp joint.json earlier.json
says "disk full" 4 "cannot write" sh -c "ulimit -f 4; exec '$etalon' fit n.json --approach improved -o joint.json"
same "the earlier surface stays" joint.json earlier.json
says "a second file that cannot be written" 4 "nowhere" "$etalon" fit n.json --approach improved --control 5x5 -o joint.json --iges nowhere/x.igs
same "leaves the first as it was" joint.json earlier.json
says "standard output is full" 4 "standard output" sh -c "'$etalon' fit n.json > /dev/full"
finish
