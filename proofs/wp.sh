#!/bin/sh
# wp.sh [--accept] CACHE UNIT...: Frama-C's WP proves the contracts of each unit of proofs/wp.tsv, every goal, or this fails.
#
# Run-time errors count, the wrapping of unsigned integers too, and smoke tests look for contradictory preconditions.  Provers get a limit of steps, the same
# on every machine; the time limit is only a safety net.  golden/proofs/UNIT.tsv has the number of goals of each function: another number is a
# failure, so that no goal gets lost; --accept writes it anew.  Of what was proved CACHE keeps the answers, so that a run that was stopped goes on.
# The options of a unit add provers (-wp-prover A) or say which alone are asked (-wp-prover=A).
# WPFLAGS: further options, such as -wp-fct NAME while working (then nothing is compared).
set -u
LC_ALL=C
export LC_ALL
accept=
if [ "${1-}" = --accept ]; then
    accept=yes
    shift
fi
[ $# -gt 1 ] || { echo 'usage: wp.sh [--accept] CACHE UNIT...' >&2; exit 2; }
mkdir -p "$1" && cache=$(cd "$1" && pwd) || exit 2
shift
cd "$(dirname "$0")/.." || exit 2
tmp=$(mktemp -d) || exit 2
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
passed=0 failed=0

# "function goals", sorted, from WP's report.
counts() {
    python3 - "$1" <<'EOF'
import json
import sys
functions = json.load(open(sys.argv[1]))["wp:functions"]
for name in sorted(functions):
    main = functions[name]["wp:section"]["wp:main"]
    print("%s\t%d" % (name, main["total"]))
EOF
}

# WP on the source, with what helps the provers for that module; the log is left in $tmp/log.
prove() {
    helps=proofs/logic/$(echo "$unit" | sed 's/_theorems$//').h
    [ -f "$helps" ] || helps=proofs/logic/logic.h
    [ "$left_out" = - ] && left_out= || left_out="-wp-skip-fct $left_out"
    [ "$options" = - ] && options=
    provers=cvc4axf,z3axf
    [ "${options#*-wp-prover=}" = "$options" ] || provers=none
    rm -f "$tmp/report.json"
    # shellcheck disable=SC2086
    (cd proofs && WHY3CONFIG=$PWD/why3.conf nice frama-c -machdep gcc_x86_64 -cpp-extra-args="-I../include -I../src -include $PWD/../$helps" -wp -wp-rte \
        -warn-unsigned-overflow -wp-smoke-tests -wp-prover $provers -wp-par 2 -wp-steps 400000 -wp-timeout 120 -wp-cache update \
        -wp-cache-dir "$cache" $options $left_out -wp-report-json "$tmp/report.json" ${WPFLAGS-} "../$source") > "$tmp/log" 2>&1 < /dev/null
}

for unit; do
    line=$(grep "^$unit	" proofs/wp.tsv) || { echo "FAIL wp $unit: not in proofs/wp.tsv"; failed=$((failed + 1)); continue; }
    source=$(echo "$line" | cut -f 2) left_out=$(echo "$line" | cut -f 3) options=$(echo "$line" | cut -f 4)
    prove
    code=$?
    goals=$(sed -n 's/.*Proved goals: *\([0-9]*\) *\/ *\([0-9]*\).*/\1 \2/p' "$tmp/log" | tail -n 1)
    if [ "$code" -ne 0 ] || [ -z "$goals" ] || [ "${goals% *}" != "${goals#* }" ] || [ ! -f "$tmp/report.json" ] \
        || { [ "${options%-wp-no-rte*}" = "$options" ] && grep -q '[Mm]issing RTE' "$tmp/log"; } \
        || grep -q 'User Error\|[Mm]issing guards\|Missing assigns\|kernel:annot\|Smoke Test.*Failed' "$tmp/log"; then
        failed=$((failed + 1))
        echo "FAIL wp $unit: ${goals:-none} (proved, wanted) in $source"
        grep -E 'Failed|Timeout|Stepout|Unknown|Error|Warning|[Mm]issing|Inconsistent' "$tmp/log"
        continue
    fi
    { printf '# function\tgoals\n'; counts "$tmp/report.json"; } > "$tmp/table"
    golden=golden/proofs/$unit.tsv
    if [ -n "${WPFLAGS-}" ]; then
        cat "$tmp/table"
    elif [ -n "$accept" ]; then
        mkdir -p golden/proofs && cp "$tmp/table" "$golden"
    elif ! diff "$golden" "$tmp/table"; then
        failed=$((failed + 1))
        echo "FAIL wp $unit: other numbers of goals than in $golden"
        continue
    fi
    passed=$((passed + 1))
    echo "ok wp $unit: ${goals% *} of ${goals#* } goals"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
