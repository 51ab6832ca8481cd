#!/bin/sh
# sum.sh COMMAND...: run each, show what it prints, and add up the last lines `N passed, N failed`.
# A command without such a line counts its lines `ok ...` and `FAIL ...`; one that ends badly without a failed test is a failed test.
set -u
passed=0 failed=0
out=$(mktemp) || exit 2
trap 'rm -f "$out" "$out.code"' EXIT
for command in "$@"; do
    { sh -c "$command" < /dev/null; echo $? > "$out.code"; } | tee "$out" | grep -vE '^[0-9]+ passed, [0-9]+ failed$'
    code=$(cat "$out.code")
    last=$(grep -E '^[0-9]+ passed, [0-9]+ failed$' "$out" | tail -n 1)
    if [ -n "$last" ]; then
        p=${last%% passed*} f=${last#*, } f=${f%% failed}
    else
        p=$(grep -c '^ok ' "$out") f=$(grep -c '^FAIL ' "$out")
        if [ "$code" -eq 0 ] && [ $((p + f)) -eq 0 ]; then echo "ok $command"; p=1; fi
    fi
    if [ "$code" -ne 0 ] && [ "$f" -eq 0 ]; then
        echo "FAIL $command: exit status $code"
        f=1
    fi
    passed=$((passed + p)) failed=$((failed + f))
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
