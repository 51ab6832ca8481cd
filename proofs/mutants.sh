#!/bin/sh
# mutants.sh BUILD [LINE...]: breaks what is proved, line by line of proofs/mutants.tsv, in a copy, and fails where proofs/prove.sh does not;
# without LINE first the contradictions of proofs/planted.c, which the smoke tests have to find.
#
# First the piece has to go through as it is, with the same limits of time: then it is the mutant that fails.  A unit of WP is asked for the mutated
# function alone, Eva for one entry point, which takes seconds; whatever else is proved of it can only fail too.
set -u
LC_ALL=C
export LC_ALL
[ $# -gt 0 ] || { echo 'usage: mutants.sh BUILD [LINE...]' >&2; exit 2; }
mkdir -p "$1" && build=$(cd "$1" && pwd) || exit 2
shift
cd "$(dirname "$0")/.." || exit 2
tree=$(mktemp -d) || exit 2
trap 'rm -rf "$tree"' EXIT
trap 'exit 130' INT TERM
passed=0 failed=0

# Runs the piece in the copy; a unit's function alone.
goes() {
    case $function in
    -) flags= ;;
    *) flags="-wp-fct $function -wp-timeout 20" ;;
    esac
    [ "$piece" = eva ] && EVA=$function || EVA=
    export EVA
    WPFLAGS=$flags sh "$tree/proofs/prove.sh" "$build" "$piece" > "$tree/log" 2>&1 < /dev/null
}

# Puts the new text in the place of the old one, which has to stand there once.
mutate() {
    python3 - "$tree/$file" "$text" "$instead" <<'EOF'
import sys
path, text, instead = sys.argv[1:]
whole = open(path).read()
if whole.count(text) != 1:
    sys.exit("%s: %d times, not once: %s" % (path, whole.count(text), text))
open(path, "w").write(whole.replace(text, instead))
EOF
}

report() { echo "$1 $2"; [ "$1" = ok ] && passed=$((passed + 1)) || failed=$((failed + 1)); }

copy() { cp -R src include proofs golden docs tests Makefile "$tree" || exit 2; }

try() {
    copy
    if ! goes; then
        cat "$tree/log"
        report FAIL "$piece: not proved as it is"
    elif ! mutate; then
        report FAIL "$piece: nothing to break in $file"
    elif goes; then
        report FAIL "$piece: proved although $file says '$instead' for '$text'"
    else
        report ok "$piece fails where $file says '$instead' for '$text'"
    fi
    rm -rf "${tree:?}"/*
}

# The smoke tests find each contradiction of proofs/planted.c.
plant() {
    copy
    printf 'planted\tproofs/planted.c\t-\t-warn-special-float none\n' >> "$tree/proofs/wp.tsv"
    sh "$tree/proofs/wp.sh" "$build/wp" planted > "$tree/log" 2>&1 < /dev/null
    for name in $(sed -nE 's/^[a-z].* \*?(planted_[a-z]+)\(.*\{.*/\1/p' proofs/planted.c); do
        if grep -q "Failed. Smoke-test typed_${name}_wp_smoke" "$tree/log"; then
            report ok "planted: the contradiction of $name is found"
        else
            report FAIL "planted: the contradiction of $name is not found"
        fi
    done
    rm -rf "${tree:?}"/*
}

tab=$(printf '\t')
if [ $# -eq 0 ]; then
    plant
    # shellcheck disable=SC2046
    set -- $(grep -n '^[a-z]' proofs/mutants.tsv | cut -d : -f 1)
fi
for number; do
    line=$(sed -n "${number}p" proofs/mutants.tsv)
    IFS=$tab read -r piece function file text instead <<EOF
$line
EOF
    try
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
