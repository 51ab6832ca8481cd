#!/bin/sh
# golden.sh compare|accept BUILD [CHECK]: makes every golden/MODULE.tsv anew with tests/golden/MODULE.py, and every golden/conformance/OPERATION.json with
# tests/golden/conformance.py, two at a time, into BUILD/golden.
# compare: each must be the golden file byte for byte, and all together many rows and few bytes; with CHECK, the program that checks them, also its
#          --golden and --truth, and the second oracle (tests/golden/second.py).
# accept:  what was made takes the golden file's place; what differs is then seen in a diff.
set -eu
LC_ALL=C
export LC_ALL
least=20000 most=20000000
mode=$1 build=$2 check=${3:-}
made=$build/golden

if [ "$mode" = make ]; then
    # One file, MODULE.tsv or conformance/OPERATION.json; called below, two at a time.
    case $4 in
    conformance/*) python3 tests/golden/conformance.py "$(basename "$4" .json)" ;;
    *) python3 "tests/golden/${4%.tsv}.py" ;;
    esac > "$made/$4.new" 2> "$made/$4.log" && mv "$made/$4.new" "$made/$4" || rm -f "$made/$4"
    exit 0
fi
if [ "$mode" != compare ] && [ "$mode" != accept ]; then
    echo "usage: golden.sh compare|accept BUILD [CHECK]" >&2
    exit 2
fi
if [ -n "$check" ]; then
    exec sh tests/sum.sh "sh tests/golden.sh $mode $build" "$check --golden golden/*.tsv" "$check --truth golden/*.tsv" \
        "python3 tests/golden/second.py"
fi

mkdir -p "$made/conformance"
rm -f "$made"/*.tsv "$made"/*.new "$made"/conformance/*
passed=0 failed=0
good() { echo "ok golden $1"; passed=$((passed + 1)); }
bad() { echo "FAIL golden $1"; failed=$((failed + 1)); }

PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE
# The longest first: the operations, then the modules by the size of what they made last time.
files=$(python3 tests/golden/conformance.py --list | sed 's|.*|conformance/&.json|'; ls -S golden/*.tsv | sed 's|.*/||')
printf '%s\n' $files | xargs -P 2 -n 1 sh tests/golden.sh make "$build" ''

for m in $files; do
    if [ ! -f "$made/$m" ]; then
        sed 's/^/  /' "$made/$m.log"
        bad "$m: not made"
    elif [ "$mode" = accept ]; then
        cmp -s "$made/$m" "golden/$m" || echo "  golden/$m is new"
        mv "$made/$m" "golden/$m"
        good "$m"
    elif cmp -s "$made/$m" "golden/$m"; then
        good "$m"
    else
        diff "golden/$m" "$made/$m" | cut -c 1-200 | sed -n '1,6s/^/  /p'
        bad "$m"
    fi
done
for f in golden/conformance/*; do
    case $f in */schema.json) ;; *) [ -f "$made/${f#golden/}" ] || [ "$mode" = accept ] || bad "$f: no operation makes it" ;; esac
done
if python3 tests/golden/conformance.py --check golden/conformance > "$made/conformance/check.log" 2>&1; then
    good "conformance: $(sed -n 's/^ok \([0-9]* vectors\)$/\1/p' "$made/conformance/check.log"), as the schema says"
else
    grep -v '^ok' "$made/conformance/check.log" | cut -c 1-200 | sed 's/^/  /'
    bad "conformance: not as the schema says, or too few"
fi
rows=$(cat golden/*.tsv | grep -vc '^#') bytes=$(cat golden/*.tsv | wc -c)
if [ "$rows" -ge $least ]; then good "rows: $rows"; else bad "rows: $rows, fewer than $least"; fi
if [ "$bytes" -lt $most ]; then good "bytes: $bytes"; else bad "bytes: $bytes, not below $most"; fi
echo "$passed passed, $failed failed"
[ $failed = 0 ]
