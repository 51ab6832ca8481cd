#!/bin/sh
# wp.sh [--accept] [MODULE...]: Frama-C's WP proves the contracts of src/MODULE/*.c and the theorems of proofs/MODULE.c, all of them, or this fails.
#
# Run-time errors count, the wrapping of unsigned integers too, and smoke tests look for contradictory preconditions.  Provers get a limit of steps, the same
# on every machine; the time limit is only a safety net.  golden/proofs/MODULE.tsv has the number of goals of each function: another number is a
# failure, so that no goal gets lost; --accept writes it anew.  WPFLAGS: further options, such as -wp-fct NAME while working (then nothing is compared).
set -u
LC_ALL=C
export LC_ALL
accept=
if [ "${1-}" = --accept ]; then
    accept=yes
    shift
fi
[ $# -gt 0 ] || set -- net
if ! command -v frama-c > /dev/null || ! command -v cvc4 > /dev/null || ! command -v z3 > /dev/null; then
    echo 'skip wp: frama-c-base, cvc4 and z3 are wanted, one is not installed'
    exit 0
fi
cd "$(dirname "$0")" || exit 2
WHY3CONFIG=$PWD/why3.conf
export WHY3CONFIG
tmp=$(mktemp -d) || exit 2
trap 'rm -rf "$tmp"' EXIT
failed=0

# The number of goals of each function: "function goals", sorted, from WP's listing of the goals with their places in the report.
counts() {
    python3 - "$1" <<'EOF'
import json
import sys
functions = json.load(open(sys.argv[1]))["wp:functions"]
for name in sorted(functions):
    total = functions[name]["wp:section"]["wp:main"]["total"]
    print("%s\t%d" % (name, total))
EOF
}

for module in "$@"; do
    n=0
    : > "$tmp/counts"
    : > "$tmp/report"
    for source in ../src/"$module"/*.c "$module".c; do
        [ -f "$source" ] || continue
        rm -f "$tmp/report.json"
        # shellcheck disable=SC2086
        nice frama-c -machdep gcc_x86_64 -cpp-extra-args="-I../include -I../src -include $PWD/logic/$module.h" -wp -wp-rte -warn-unsigned-overflow \
            -wp-smoke-tests -wp-prover cvc4axf,z3axf -wp-par 2 -wp-steps 400000 -wp-timeout 120 -wp-report-json "$tmp/report.json" ${WPFLAGS-} "$source" \
            > "$tmp/log" 2>&1 < /dev/null
        code=$?
        proved=$(sed -n 's/.*Proved goals: *\([0-9]*\) *\/ *\([0-9]*\).*/\1 \2/p' "$tmp/log" | tail -n 1)
        if [ "$code" -ne 0 ] || [ -z "$proved" ] || [ "${proved% *}" != "${proved#* }" ] \
            || grep -q 'User Error\|[Mm]issing guards\|Missing RTE\|Missing assigns\|kernel:annot\|Smoke Test.*Failed' "$tmp/log"; then
            failed=1
            echo "FAIL wp $source: ${proved:-none} (proved, wanted)"
            grep -E 'Failed|Timeout|Stepout|Unknown|Error|Warning|[Mm]issing|Inconsistent' "$tmp/log"
        else
            echo "ok wp $source: $proved (proved, wanted)"
        fi
        [ -f "$tmp/report.json" ] && counts "$tmp/report.json" | sed "s|^|$(basename "$source")	|" >> "$tmp/counts"
    done
    n=$(wc -l < "$tmp/counts")
    golden=../golden/proofs/$module.tsv
    { printf '# file\tfunction\tgoals\n'; cat "$tmp/counts"; } > "$tmp/table"
    if [ "$n" -eq 0 ]; then
        failed=1
        echo "FAIL wp $module: no goals"
    elif [ -n "${WPFLAGS-}" ]; then
        cat "$tmp/table"
    elif [ -n "$accept" ]; then
        [ "$failed" -eq 0 ] && mkdir -p ../golden/proofs && cp "$tmp/table" "$golden"
    elif ! diff "$golden" "$tmp/table"; then
        failed=1
        echo "FAIL wp $module: other numbers of goals than in golden/proofs/$module.tsv"
    fi
done
exit "$failed"
