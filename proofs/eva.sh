#!/bin/sh
# eva.sh [--accept] BUILD [ENTRY...]: Frama-C's Eva finds no run-time error of floors 0 to 2 in the ranges that the harnesses of proofs/eva state.
#
# The sources are analysed without their annotations, since a contract that is not proved must not help; what LAPACK and MPFR do stands in
# eva/lapacke.h and eva/eva.c.  NaN and infinity are values, not errors.  golden/proofs/eva.tsv has, for each entry point, the functions and statements
# that are reached, and the alarms left: other numbers are a failure; --accept writes them anew.  BUILD keeps the answers, so that a run that was
# stopped goes on.
set -u
LC_ALL=C
export LC_ALL
accept= analyse=
if [ "${1-}" = --accept ]; then
    accept=yes
    shift
fi
if [ "${1-}" = --analyse ]; then    # for this script itself: one entry point
    analyse=yes
    shift
fi
[ $# -gt 0 ] || { echo 'usage: eva.sh [--accept] BUILD [ENTRY...]' >&2; exit 2; }
mkdir -p "$1/plain" && build=$(cd "$1" && pwd) || exit 2
shift
cd "$(dirname "$0")/.." || exit 2
trap 'exit 130' INT TERM
golden=golden/proofs/eva.tsv
rooms='base spline net som fit'

# The sources without ACSL, with the line numbers they have.
plain() {
    rm -rf "$build/plain" && mkdir -p "$build/plain" && cp -R include src "$build/plain" || return
    python3 - "$build/plain" <<'EOF'
import glob
import re
import sys
for path in glob.glob(sys.argv[1] + "/**/*.[ch]", recursive=True):
    text = re.sub(r"/\*@.*?\*/", lambda m: "\n" * m.group(0).count("\n"), open(path).read(), flags=re.S)
    text = re.sub(r"//@.*", "", text)
    # Frama-C's own sqrt and fabs complain of what is not finite.
    open(path, "w").write(re.sub(r"\b(sqrt|fabs)\(", r"eva_\1(", text))
EOF
}

# All sources and harnesses, parsed once.
parse() {
    (cd "$build/plain" && frama-c -machdep gcc_x86_64 -save ../all.sav \
        -cpp-extra-args="-I$OLDPWD/proofs/eva -Iinclude -Isrc -D_XOPEN_SOURCE=700 -include libm.h" \
        $(for room in $rooms; do ls src/"$room"/*.c; done | grep -v 'mpfr\|/rng\.c') \
        "$OLDPWD"/proofs/eva/*.c) > "$build/parse.log" 2>&1 < /dev/null &&
        cp proofs/heap.ml "$build" && (cd "$build" && ocamlopt -shared -o heap.cmxs heap.ml)
}

# States are kept apart, also after a function has returned, but not after a loop, save where the indices that it found depend on one another; those of
# different requests for memory that failed (eva/eva.c) are, always; each allocation is one of its own; an entry point may ask for more:
# `/* eva: OPTIONS */`.
analyse() {
    options=$(sed -n "s|^void $1(void).*/\* eva: \(.*\) \*/.*|\1|p" proofs/eva/*.c)
    # shellcheck disable=SC2086
    nice timeout 600 frama-c -load-module "$build/heap.cmxs" -load "$build/all.sav" -main "$1" -eva -eva-slevel 400 \
        -eva-slevel-merge-after-loop @all,-et_knots_span,-et_knots_span_side,-lines_new \
        -eva-interprocedural-history -eva-interprocedural-splits -eva-split-return full \
        -eva-alloc-builtin fresh -eva-no-alloc-returns-null -warn-special-float none $options > "$build/$1.log" 2>&1 < /dev/null
}

# "entry functions statements alarms" from Eva's summary.
summary() {
    awk -v entry="$1" '/functions analyzed/ { f = $1 } /statements reached/ { s = $4 } /alarms? generated/ { a = $1 } /Preconditions|Assertions/ { a += $4 + $6 }
        END { if (s == "") exit 1; printf "%s\t%d\t%d\t%d\n", entry, f, s, a }' "$build/$1.log"
}

if [ -n "$analyse" ]; then
    analyse "$1"
    exit 0
fi
key=$( { cat proofs/eva.sh proofs/heap.ml proofs/eva/*; for room in $rooms; do cat include/etalon/"$room"/*.h src/"$room"/*; done; } | sha256sum | cut -d ' ' -f 1)
if [ "$(cat "$build/key" 2> /dev/null)" != "$key" ]; then
    rm -f "$build"/*.log "$build/key"
    plain && parse || { grep -v Parsing "$build/parse.log"; echo 'FAIL eva: the sources are not read'; exit 1; }
    echo "$key" > "$build/key"
fi
[ $# -gt 0 ] || set -- $(sed -n 's/^void \(eva_[a-z0-9_]*\)(void).*/\1/p' proofs/eva/*.c)
passed=0 failed=0
table=$(mktemp) || exit 2
trap 'rm -f "$table"' EXIT
# Those that reach the most statements first, so that none of the longest runs alone in the end.
for entry; do
    summary "$entry" > /dev/null 2>&1 || awk -v entry="$entry" '$1 == entry { n = $3 } END { print n + 0, entry }' "$golden"
done | sort -rn | cut -d ' ' -f 2 | xargs -r -n 1 -P 2 sh proofs/eva.sh --analyse "$build"
for entry; do
    row=$(summary "$entry")
    if [ -z "$row" ]; then
        tail -n 3 "$build/$entry.log"
        echo "FAIL eva $entry: no end"
        failed=$((failed + 1))
        continue
    fi
    echo "$row" >> "$table"
    if [ -n "$accept" ] || grep -qxF "$row" "$golden"; then
        echo "ok eva $entry: $(echo "$row" | awk -F '\t' '{ print $3 " statements of " $2 " functions, " $4 " alarms" }')"
        passed=$((passed + 1))
    else
        grep -A 2 'eva:alarm' "$build/$entry.log"
        echo "FAIL eva $entry: $row, wanted $(grep "^$entry	" "$golden")"
        failed=$((failed + 1))
    fi
done
if [ -n "$accept" ]; then
    { printf '# entry point\tfunctions\tstatements\talarms\n'; { cat "$table"; grep -v '^#' "$golden" 2> /dev/null; } | sort -s -u -k 1,1; } > "$golden.new"
    mv "$golden.new" "$golden"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
