#!/bin/sh
# docs.sh LIBRARY BUILD CC LIBS: the examples of the documentation compile, run and end with 0; its links lead somewhere.
set -u
lib=$1 work=$2/docs cc=$3 libs=$4
passed=0 failed=0
rm -rf "$work"
mkdir -p "$work" || exit 2
told() {
    if "$@" > "$work/said" 2>&1; then
        passed=$((passed + 1)) && echo "ok $what"
    else
        failed=$((failed + 1)) && echo "FAIL $what" && head -n 5 "$work/said"
    fi
}

# Each block of C that has a main becomes a program.
for page in README.md docs/*.md; do
    [ -f "$page" ] || continue
    name=$(basename "$page" .md)
    awk -v to="$work/$name" '/^```c$/ { n++; inside = 1; next } /^```/ { inside = 0 } inside { print > (to "." n ".c") }' "$page"
    if grep -q '^## et_' "$page"; then what="$page has an example"; told grep -q 'int main(' "$work/$name".*.c; fi
    for c in "$work/$name".*.c; do
        [ -f "$c" ] && grep -q 'int main(' "$c" || continue
        what="$page: the example compiles"
        told $cc -std=c99 -pedantic-errors -Wall -Wextra -Wno-unused-parameter -Werror -D_POSIX_C_SOURCE=200809L -Iinclude \
            -o "${c%.c}" "$c" "$lib" $libs
        [ -x "${c%.c}" ] || continue
        what="$page: the example runs and ends with 0"
        told sh -c "cd '$work' && ulimit -t 60 && './$(basename "${c%.c}")' < /dev/null"
    done
done
what='every link of the documentation leads somewhere'
broken() {
    for page in *.md docs/*.md tests/bench/*.md proofs/*.md; do
        [ -f "$page" ] || continue
        for link in $(grep -oE '\]\([^)# ]+' "$page" | sed 's/^](//' | grep -vE '^[a-z]+:'); do
            [ -e "$(dirname "$page")/$link" ] || echo "$page: $link"
        done
    done
}
told test -z "$(broken)"
broken
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
