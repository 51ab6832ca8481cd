#!/bin/sh
# contracts.sh FOLDER: the ACSL contracts of every public header under FOLDER parse and type-check with Frama-C, if it is installed.
set -u
LC_ALL=C
export LC_ALL
if ! command -v frama-c > /dev/null; then
    echo 'skip contracts: frama-c-base is not installed'
    exit 0
fi
said=$(mktemp) || exit 2
trap 'rm -f "$said"' EXIT
passed=0 failed=0
for h in "$1"/etalon/*/*.h; do
    # What does not type-check ends frama-c badly; an annotation that it only skips (an unknown clause, say) is a warning.
    if frama-c -no-autoload-plugins -cpp-extra-args="-I$1" "$h" > "$said" 2>&1 && ! grep -q '^\[kernel:annot' "$said"; then
        passed=$((passed + 1))
        echo "ok contracts $h"
    else
        failed=$((failed + 1))
        echo "FAIL contracts $h: $(grep -v '^\[kernel\] Parsing' "$said" | head -n 2 | sed 's/^ *//' | tr '\n' ' ')"
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
