#!/bin/sh
# sum.sh [-j N] COMMAND...: run each, show what it prints, and add up the last lines `N passed, N failed`.  With -j N so many run at once, and what they print is
# shown in the order in which they are named, each when it has ended.
# A command without such a line counts its lines `ok ...` and `FAIL ...`; one that ends badly without a failed test is a failed test.
set -u
jobs=1
if [ "$1" = -j ]; then
    jobs=$2
    shift 2
fi
passed=0 failed=0
work=$(mktemp -d) || exit 2
lanes=
trap 'rm -rf "$work"' EXIT
trap 'trap "" INT TERM; [ -z "$lanes" ] || kill -TERM -"$lanes" 2> /dev/null; exit 130' INT TERM

# run K: the K-th command; its output is in K.out, its exit status in K.code.
cat > "$work/run" <<'R'
sh -c "$(cat "$1.command")" < /dev/null > "$1.out"
echo $? > "$1.status"
mv "$1.status" "$1.code"
R
k=0
for command in "$@"; do
    k=$((k + 1))
    printf '%s\n' "$command" > "$work/$k.command"
done
if [ "$jobs" -gt 1 ]; then
    seq "$k" | sed "s|^|$work/|" > "$work/list"
    setsid xargs -P "$jobs" -n 1 sh "$work/run" < "$work/list" &       # a process group of its own, which can be told to stop
    lanes=$!
fi

k=0
for command in "$@"; do
    k=$((k + 1))
    out=$work/$k.out
    if [ -n "$lanes" ]; then
        while [ ! -e "$work/$k.code" ]; do
            kill -0 "$lanes" 2> /dev/null || [ -e "$work/$k.code" ] || { echo "sum.sh: stopped"; exit 130; }
            sleep 0.1
        done
        grep -vE '^[0-9]+ passed, [0-9]+ failed$' "$out"
    else
        { sh -c "$command" < /dev/null; echo $? > "$work/$k.code"; } | tee "$out" | grep -vE '^[0-9]+ passed, [0-9]+ failed$'
    fi
    code=$(cat "$work/$k.code")
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
