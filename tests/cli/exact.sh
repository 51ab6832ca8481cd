#!/bin/sh
. "$(dirname "$0")/kit"
"$etalon" generate sphere -o s.xyz
"$etalon" train s.xyz --grid 12x9 --seed 3 -q -o n.json
want "train --exact" 0 "$etalon" train s.xyz --grid 12x9 --seed 3 --exact --json -o ne.json
cp out te.line
python3 -c 'import json
a, b = json.load(open("n.json")), json.load(open("ne.json"))
raise SystemExit(a["weights"] != b["weights"])' && pass "exact quality, the same net" || fail "exact quality, the same net"
"$etalon" train s.xyz --grid 12x9 --seed 3 --json > t.line
# The fast mean is within (18 + log2 7082) u < 31 u of the exact one.
python3 -c 'import json
a, b = json.load(open("t.line"))["final"], json.load(open("te.line"))["final"]
raise SystemExit(not (abs(a["qe"] - b["qe"]) <= 31 * 2**-53 * b["qe"] and a["te"] == b["te"]))' && pass "fast quality is within its bound" || fail "fast quality is within its bound"

# Uniform parameters and knots are the same doubles either way: then double-double and balls must come to the same control points.
for a in conventional improved joint; do
    u="--approach $a --method uniform --knots uniform --control 7x6"
    want "$a exactly" 0 "$etalon" fit n.json $u --exact --json -o exact.$a.json
    holds "$a: says so" "j['exact'] is True" out
    for g in qr cholesky svd; do
        want "$a refined from $g" 0 "$etalon" fit n.json $u --algebra $g --refine-solution --json -o $a.$g.json --bounds $a.$g.csv
        holds "$a from $g: enclosed" "0 <= j['enclosure']['greatest_radius'] < 1e-15 and j['enclosure']['undecided'] == j['enclosure']['solved_exactly']" out
        python3 - "$a" "$g" <<'END' && pass "$a from $g: the exact solution, bit for bit" || fail "$a from $g: the exact solution, bit for bit"
import json, sys
a, b = (json.load(open(f)) for f in ("exact.%s.json" % sys.argv[1], "%s.%s.json" % tuple(sys.argv[1:])))
sys.exit(any(a["views"][w][k] != b["views"][w][k] for w in ("bottom", "top") for k in ("u", "v", "points")))
END
    done
    "$etalon" fit n.json $u --algebra cholesky -q -o fast.json --bounds fast.csv
    python3 - "$a" <<'END' && pass "$a: the exact solution lies within the radii" || fail "$a: the exact solution lies within the radii"
import csv, json, sys
from fractions import Fraction as F
exact = json.load(open("exact.%s.json" % sys.argv[1]))
n = moved = 0
for r in csv.DictReader(open("fast.csv")):
    view = exact["views"][r["view"]]
    p = view["points"][int(r["i"]) * 6 + int(r["j"])]
    for k, c in enumerate("xyz"):
        n += 1
        moved += float(r[c]) != p[k]
        half = F(2) ** -53 * abs(F(p[k]))            # the exact solution is within half an ulp of its rounding
        if abs(F(float(r[c])) - F(p[k])) > F(float(r["radius_" + c])) + half:
            sys.exit("%s: off by more than its radius" % r)
sys.exit(n != 2 * 7 * 6 * 3 or moved == 0)
END
done
for m in chord centripetal exponential; do
    want "$m exactly" 0 "$etalon" fit n.json --method $m --control 6x6 --exact --json -o e.json
    holds "$m: closed" "j['seam_gap'] == 0 and j['corner_error'] == 0" out
done
says "exact and bounds" 2 "no error to bound" "$etalon" fit n.json --exact --bounds b.csv
says "exact and refined" 2 "nothing to refine" "$etalon" fit n.json --exact --refine-solution
cp exact.joint.json earlier.json
says "disk full" 4 "cannot write" sh -c "ulimit -f 1; exec '$etalon' fit n.json --exact --control 6x6 -o exact.joint.json"
same "the earlier surface stays" exact.joint.json earlier.json

# Evaluation.
printf '0 0\n# a comment\n0.25,0.75\n\n1 1\n0.5 0.1\n' > uv.txt
want "evaluate" 0 "$etalon" evaluate exact.joint.json uv.txt --order 2 -o fast.csv
want "evaluate exactly" 0 "$etalon" evaluate exact.joint.json uv.txt --order 2 --exact -o exact.csv
want "evaluate to order 3" 0 "$etalon" evaluate exact.joint.json uv.txt --view top --order 3 --exact --hex
head -n 1 out | grep -q 'xuuu,yuuu,zuuu,xuuv,yuuv,zuuv,xuvv,yuvv,zuvv,xvvv,yvvv,zvvv$' && pass "columns are named" || fail "columns are named" "$(head -n 1 out)"
grep -q 0x1 out && pass "hex floats" || fail "hex floats"
python3 - <<'END' && pass "fast and exact values agree within the bound" || fail "fast and exact values agree within the bound"
import csv, json, sys
a, b = (list(csv.DictReader(open(f))) for f in ("fast.csv", "exact.csv"))
P = json.load(open("exact.joint.json"))["views"]["bottom"]["points"]
m = max(abs(c) for p in P for c in p)
if len(a) != 4 or [float(a[0][c]) for c in "xyz"] != P[0] or [float(b[2][c]) for c in "xyz"] != P[-1]:
    sys.exit("corners")
for x, y in zip(a, b):
    for c in "xyz":
        if abs(float(x[c]) - float(y[c])) > 43 * 2**-53 * m:      # 7 (p + q) roundings and that of the exact value
            sys.exit(c)
END
want "evaluate as JSON" 0 sh -c "echo 0.5 0.5 | '$etalon' evaluate exact.joint.json - --exact --json"
holds "one row" "len(j['values']) == 1 and len(j['values'][0]) == 5" out
says "third derivatives want --exact" 2 "want --exact" "$etalon" evaluate exact.joint.json uv.txt --order 3
for o in 4294967295 18446744073709551614 18446744073709551615; do
    says "order $o" 70 "memory" timeout 20 "$etalon" evaluate exact.joint.json uv.txt --order $o --exact
done
printf '0 0\n0.5 nan\n' > bad.txt
says "NaN in the parameters" 3 "bad.txt:2" "$etalon" evaluate exact.joint.json bad.txt
printf '0 0 0\n' > three.txt
says "three numbers in a line" 3 "three.txt:1" "$etalon" evaluate exact.joint.json three.txt
: > none.txt
says "no parameters" 3 "no parameters" "$etalon" evaluate exact.joint.json none.txt
says "no such file" 4 "gone.txt" "$etalon" evaluate exact.joint.json gone.txt
cp exact.csv earlier.csv
says "disk full while evaluating" 4 "cannot write" sh -c "yes '0.5 0.5' | head -n 2000 > many.txt; ulimit -f 1; exec '$etalon' evaluate exact.joint.json many.txt -o exact.csv"
same "the earlier table stays" exact.csv earlier.csv
finish
