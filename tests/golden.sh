#!/bin/sh
# golden.sh compare|accept BUILD [CHECK]: makes every golden/MODULE.tsv anew with tests/golden/MODULE.py, two at a time, into BUILD/golden.
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
    # One module; called below, two at a time.
    python3 "tests/golden/$4.py" > "$made/$4.new" 2> "$made/$4.log" && mv "$made/$4.new" "$made/$4.tsv" || rm -f "$made/$4.tsv"
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

mkdir -p "$made"
rm -f "$made"/*.tsv "$made"/*.new
passed=0 failed=0
good() { echo "ok golden $1"; passed=$((passed + 1)); }
bad() { echo "FAIL golden $1"; failed=$((failed + 1)); }

# The longest first, by the size of what they made last time.
modules=$(ls -S golden/*.tsv | sed 's|.*/||; s|\.tsv$||')
PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE
printf '%s\n' $modules | xargs -P 2 -n 1 sh tests/golden.sh make "$build" ''

for m in $modules; do
    if [ ! -f "$made/$m.tsv" ]; then
        sed 's/^/  /' "$made/$m.log"
        bad "$m: not made"
    elif [ "$mode" = accept ]; then
        cmp -s "$made/$m.tsv" "golden/$m.tsv" || echo "  golden/$m.tsv is new"
        mv "$made/$m.tsv" "golden/$m.tsv"
        good "$m"
    elif cmp -s "$made/$m.tsv" "golden/$m.tsv"; then
        good "$m"
    else
        diff "golden/$m.tsv" "$made/$m.tsv" | cut -c 1-200 | sed -n '1,6s/^/  /p'
        bad "$m"
    fi
done
rows=$(cat golden/*.tsv | grep -vc '^#') bytes=$(cat golden/*.tsv | wc -c)
if [ "$rows" -ge $least ]; then good "rows: $rows"; else bad "rows: $rows, fewer than $least"; fi
if [ "$bytes" -lt $most ]; then good "bytes: $bytes"; else bad "bytes: $bytes, not below $most"; fi
echo "$passed passed, $failed failed"
[ $failed = 0 ]
