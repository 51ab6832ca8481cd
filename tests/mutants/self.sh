#!/bin/sh
# self.sh FOLDER CC: make mutants tested on a sample: what is tested must be killed, planted lines that nobody tests must be reported, an explained
# survivor must be let through, a second run must try nothing again.
set -u
here=$1 cc=$2 root=$(pwd)
passed=0 failed=0
rm -rf "$here"
mkdir -p "$here/src/spline" "$here/include" "$here/tests" "$here/o" || exit 2
here=$(cd "$here" && pwd)
cp tests/mutants/self/sample.[ch] "$here/src/spline/"
cp tests/mutants/self/test_sample.c tests/gen.[ch] tests/golden.[ch] tests/rows.h tests/source.h "$here/tests/"
sh tests/registry.sh tests/mutants/self/test_sample.c > "$here/registry.c"
cd "$here" || exit 2
for f in tests/gen.c tests/golden.c tests/test_sample.c registry.c; do
    mkdir -p "o/$(dirname "$f")"
    "$cc" -std=c99 -O1 -D_POSIX_C_SOURCE=200809L -Itests -Isrc/spline -c -o "o/$f.o" "$f" || exit 2
done
objects=$(find "$here/o" -name '*.o' | tr '\n' ' ')
mutants() { python3 "$root/tests/mutants/mutants.py" --build "$here/work" --cc "$cc" --rooms spline --objects "$objects" --libs=-lm --phases test "$@" > out 2>&1; }
told() {
    what=$1
    shift
    if "$@"; then passed=$((passed + 1)); echo "ok mutants: $what"; else failed=$((failed + 1)); echo "FAIL mutants: $what"; cat out; fi
}
says() { grep -q -F -- "$1" out; }
fails() { ! mutants "$@"; }
lives() { awk '/ \((survived|never differs|budget)\)/' out; }

: > none.tsv
told 'survivors are a failure' fails --explained none.tsv
told 'a line that is never run' says 'et_sample_untested: a * 3  ->  a + 3 (never differs)'
told 'a line whose result nobody looks at' says 'et_sample_untested: a -= 5  ->  a += 5 (survived)'
told 'a deleted statement' says 'et_sample_untested: a -= 5;  ->  ; (survived)'
# Any place between lo and hi will do; where x[lo] is not above what is wanted it is not below either; x and lo are equal where they are.
told 'nothing else survives but what is equivalent' test "$(lives | grep -cv et_sample_untested) $(lives | grep -cE ': (2  ->  3|x.lo. == wanted  ->  x.lo. <= wanted|x < lo  ->  x <= lo) ')" = '3 3'
told 'an endless loop is a killed one' grep -q "endless" work/answers.tsv
lives | sed -E 's/^([^:]*):[0-9]+: ([a-z_]+): (.*)  ->  (.*) \((survived|never differs|budget)\)$/\1:\2\t\3 -> \4\tequivalent\tplanted/' > all.tsv
told 'explained survivors are let through' mutants --explained all.tsv
told 'what is known is not tried again' test -z "$(grep '^trying' out)"
sed -i 's/a -= 5;/a -= 6;/' src/spline/sample.c
told 'one that is explained no longer is a failure' fails --explained all.tsv
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
