#!/bin/sh
# kinds.sh LIBRARY: tests/kinds.tsv says of every public function which kinds of properties it has, and why it cannot have the others.  One line
# a function.
set -u
LC_ALL=C
export LC_ALL
table=tests/kinds.tsv
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT

# included TEST: it, the headers beside it that it includes, and those that these include.
included() {
    set -- "$1" $(sed -nE "s|^#include \"(.*/)?([a-z_]+\.h)\"\$|${1%/*}/\2|p" "$1")
    for h in "$@"; do [ ! -f "$h" ] || { echo "$h"; sed -nE "s|^#include \"(.*/)?([a-z_]+\.h)\"\$|${h%/*}/\2|p" "$h"; }; done | sort -u |
        while read -r h; do [ ! -f "$h" ] || cat "$h"; done
}

# What there is: public functions, properties and where they stand, what each test calls, rows that are compared bit for bit, whole runs.
nm -g --defined-only "$1" 2> /dev/null |
    awk 'NF == 3 && $2 == "T" && $3 ~ /^et_[a-z0-9]+_[a-z0-9_]+$/ { print substr($3, 4) }' | sort -u > "$work/exported"
cat include/etalon/*/*.h | grep -oE '(^|[^a-z0-9_])et_[a-z0-9]+_[a-z0-9_]+\(' | sed -E 's/^[^a-z]?et_//; s/\($//' | sort -u > "$work/declared"
comm -12 "$work/exported" "$work/declared" | sed 's/^/function /' > "$work/facts"
for t in tests/*/test_*.c; do
    sed -nE "s|^verdict prop_([a-z0-9_]+)\(gen \*g\)\$|property \1 $t|p" "$t"
    included "$t" | grep -oE '(^|[^a-z0-9_])et_[a-z0-9]+_[a-z0-9_]+' | sed -E 's/^[^a-z]?et_//' | sort -u | sed "s|^|calls $t |"
done >> "$work/facts"
awk -F '\t' '!/^#/ && $2 ~ /^(bits|exact)$/ { print "golden", $1 }' golden/*.tsv | sort -u >> "$work/facts"
sed -nE '/^ *static const entry runs/,/};/p' tests/bits/replay.c | grep -oE '\{"[a-z_0-9]+"' | sed 's/^{"/replay /; s/"$//' >> "$work/facts"

awk -F '\t' -v facts="$work/facts" '
    function lacks(f, what) { why[f] = (why[f] == "" ? "" : why[f] "; ") what }
    # The function that a golden row is about: its name, or the longest beginning of it that is one.
    function about(n) {
        while (!(n in public)) if (!sub(/_[^_]*$/, "", n)) return ""
        return n
    }
    function checked(f, kind, p,  file) {
        if (p == "golden") { if (kind != "bits" || !(f in golden)) lacks(f, kind ": no golden rows of class bits or exact"); return }
        if (p ~ /^replay:/) { if (kind != "bits" || !(substr(p, 8) in replay)) lacks(f, kind ": no run " p); return }
        if (!(p in property)) { lacks(f, kind ": no property " p); return }
        file = property[p]
        if (file !~ /^tests\/conform\/test_(answer|judge)/ && !((file, f) in calls)) lacks(f, kind ": " p " does not call et_" f)
    }
    BEGIN {
        nkinds = split("contract,second method,round trip,metamorphic,residual,bits", kinds, ",")
        for (k = 1; k <= nkinds; k++) is_kind[kinds[k]] = 1
        while ((getline line < facts) > 0) {
            split(line, w, " ")
            if (w[1] == "function") { public[w[2]] = 1; order[++functions] = w[2] }
            if (w[1] == "property") property[w[2]] = w[3]
            if (w[1] == "calls") calls[w[2], w[3]] = 1
            if (w[1] == "golden") rows[w[2]] = 1
            if (w[1] == "replay") replay[w[2]] = 1
        }
        for (n in rows) golden[about(n)] = 1
    }
    /^#/ || /^$/ { next }
    !($1 in public) { if (!($1 in stray)) { lacks($1, "no public function"); stray[$1] = 1; strays[++nstrays] = $1 } next }
    !($2 in is_kind) { lacks($1, "no kind \"" $2 "\""); next }
    {
        if (($1, $2) in seen) lacks($1, $2 ": twice")
        seen[$1, $2] = 1
        if ($3 == "-") {
            if (NF != 4 || $4 !~ /[^ ]/) lacks($1, $2 ": no reason why not")
            next
        }
        n = split($3, p, " ")
        if (n == 0 || NF != 3) lacks($1, $2 ": neither properties nor a reason")
        for (k = 1; k <= n; k++) checked($1, $2, p[k])
        has[$1] = has[$1] (has[$1] == "" ? "" : ", ") $2
        number[$1]++
    }
    END {
        if (!functions) { print "FAIL kinds: no public functions"; failed++ }
        for (i = 1; i <= functions; i++) {
            f = order[i]
            for (k = 1; k <= nkinds; k++) if (!((f, kinds[k]) in seen)) lacks(f, "no row for " kinds[k])
            if (number[f] < 2) lacks(f, "fewer than two kinds")
            if (f in why) { print "FAIL kinds " f ": " why[f]; failed++ } else { print "ok kinds " f ": " has[f]; passed++ }
        }
        for (i = 1; i <= nstrays; i++) { print "FAIL kinds " strays[i] ": " why[strays[i]]; failed++ }
        print passed + 0 " passed, " failed + 0 " failed"
        exit failed > 0
    }' "$table"
