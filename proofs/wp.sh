#!/bin/sh
# wp.sh [--accept] CACHE UNIT...: Frama-C's WP proves the contracts of each unit of proofs/wp.tsv, every goal, or this fails.
#
# Run-time errors count, the wrapping of unsigned integers too.  Provers get a limit of steps, the same on every machine; the time limit is only a
# safety net.  Smoke tests, afterwards, look for contradictory preconditions, calls that cannot return and statements that cannot be reached:
# z3, which only instantiates there and so stops soon, tries to prove "false".
# golden/proofs/UNIT.tsv has the number of goals and of smoke tests of each function: another number is a failure, so that none gets lost;
# --accept writes it anew.  Of what was proved CACHE keeps the answers, so that a run that was stopped goes on.
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

# A file of a library without what no driver here hands to a prover (why3/unused).
prune() { awk -v "file=${1##*/}" -f proofs/why3/prune.awk proofs/why3/unused "$1" > "$2.new" && rm -f "$2" && mv "$2.new" "$2"; }

# Why3's library and WP's, pruned; the configuration that finds them; a module of Frama-C that gives its memory manager more room.
library() {
    share=$(sed -n 's/^datadir = "\(.*\)"/\1/p' proofs/why3.conf) wp=$(frama-c -print-share-path)/wp
    mkdir -p "$tmp/share/stdlib" "$tmp/wp/why3/frama_c_wp" &&
        ln -s "$share"/drivers "$share"/*.conf "$tmp/share" &&
        ln -s "$share"/stdlib/* "$tmp/share/stdlib" && prune "$share/stdlib/real.mlw" "$tmp/share/stdlib/real.mlw" &&
        prune "$share/stdlib/ieee_float.mlw" "$tmp/share/stdlib/ieee_float.mlw" &&
        ln -s "$wp"/*.driver "$tmp/wp" && ln -s "$wp"/why3/frama_c_wp/* "$tmp/wp/why3/frama_c_wp" &&
        prune "$wp/why3/frama_c_wp/cfloat.mlw" "$tmp/wp/why3/frama_c_wp/cfloat.mlw" &&
        sed "s#^datadir = .*#datadir = \"$tmp/share\"#" proofs/why3.conf > "$tmp/why3.conf" &&
        cp proofs/heap.ml "$tmp" && (cd "$tmp" && ocamlopt -shared -o heap.cmxs heap.ml)
}

# "function goals smoke tests", sorted, from WP's two reports; 1 if a smoke test failed.
counts() {
    python3 - "$1" "$2" <<'EOF'
import json
import sys
goals, smoke = (json.load(open(name))["wp:functions"] for name in sys.argv[1:])
failed = 0
for name in sorted(set(goals) | set(smoke)):
    tests = [value["wp:main"] for key, value in smoke.get(name, {}).items() if "_wp_smoke_" in key]
    failed += sum(test["total"] - test.get("valid", 0) for test in tests)
    total = goals[name]["wp:section"]["wp:main"]["total"] if name in goals else 0
    if total or tests:
        print("%s\t%d\t%d" % (name, total, sum(test["total"] for test in tests)))
sys.exit(failed > 0)
EOF
}

# Frama-C on the source of the unit, with what helps the provers for that module: every goal by the provers of the unit, then, as what is proved is
# not looked at again, the smoke tests.  $tmp/log, goals.json and smoke.json are left.
# shellcheck disable=SC2086
prove() {
    provers=cvc4axf,z3axf
    [ "${options#*-wp-prover=}" = "$options" ] || provers=none
    helps=proofs/logic/$(echo "$unit" | sed 's/_theorems$//').h
    [ -f "$helps" ] || helps=proofs/logic/logic.h
    # WP forgets what it is to look at, but not its provers.
    looked="$(echo "$options" | sed -E 's/-wp-(prover|steps|timeout)[= ][^ ]*//g') $left_out ${WPFLAGS-}"
    others=$(sed -n 's/^shortcut = "\(.*\)"/-\1/p' proofs/why3.conf | paste -sd ,)
    rm -f "$tmp"/*.json
    (cd proofs && WHY3CONFIG=$tmp/why3.conf nice frama-c -load-module "$tmp/heap.cmxs" -wp-share "$tmp/wp" -machdep gcc_x86_64 \
        -cpp-extra-args="-I../include -I../src -include $PWD/../$helps" -wp -wp-rte -warn-unsigned-overflow -wp-no-pruning -wp-no-ground -wp-par 1 \
        -wp-cache update -wp-cache-dir "$cache" -wp-no-smoke-tests -wp-prover $provers -wp-steps 400000 -wp-timeout 120 $options $left_out ${WPFLAGS-} \
        -wp-report-json "$tmp/goals.json" "../$source" \
        -then -wp -wp-smoke-tests -wp-smoke-timeout 20 -wp-prover=$others,-none,+z3ordem -wp-steps 100000 $looked -wp-report-json "$tmp/smoke.json") \
        > "$tmp/log" 2>&1 < /dev/null
}

library || { echo 'wp.sh: the library of Why3 is another one than that of 1.5.1, or there is no ocamlopt' >&2; exit 2; }
for unit; do
    line=$(grep "^$unit	" proofs/wp.tsv) || { echo "FAIL wp $unit: not in proofs/wp.tsv"; failed=$((failed + 1)); continue; }
    source=$(echo "$line" | cut -f 2) left_out=$(echo "$line" | cut -f 3) options=$(echo "$line" | cut -f 4)
    [ "$left_out" = - ] && left_out= || left_out="-wp-skip-fct $left_out"
    [ "$options" = - ] && options=
    prove
    code=$?
    goals=$(sed -n 's/.*Proved goals: *\([0-9]*\) *\/ *\([0-9]*\).*/\1 \2/p' "$tmp/log" | head -n 1)
    { printf '# function\tgoals\tsmoke tests\n'; counts "$tmp/goals.json" "$tmp/smoke.json"; } > "$tmp/table" 2> /dev/null || code=1
    if [ "$code" -ne 0 ] || [ -z "$goals" ] || [ "${goals% *}" != "${goals#* }" ] \
        || { [ "${options%-wp-no-rte*}" = "$options" ] && grep -q '[Mm]issing RTE' "$tmp/log"; } \
        || grep -q 'User Error\|[Mm]issing guards\|Missing assigns\|kernel:annot\|Failed. Smoke' "$tmp/log"; then
        failed=$((failed + 1))
        echo "FAIL wp $unit: ${goals:-none} (proved, wanted) in $source"
        grep -hE 'Failed|Timeout|Stepout|Unknown|Error|Warning|[Mm]issing|Inconsistent' "$tmp/log"
        continue
    fi
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
    echo "ok wp $unit: ${goals% *} of ${goals#* } goals, $(awk '{ n += $NF } END { print n }' "$tmp/table") smoke tests"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
