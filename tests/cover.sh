#!/bin/sh
# cover.sh BUILD: all that can be counted is run in the coverage build; then lines and branches that were reached, and the lines that were not, each of which
# must stand in tests/cover/unreached.tsv with the reason.  The bars: 98 % of the branches of src without io and cli, 92 % of all.
set -u
build=$1 b=$1/cover
find "$b" -name '*.gcda' -delete
mkdir -p "$b/faults"
sh tests/sum.sh "ET_RUNS=${ET_RUNS:-400} make -s P=cover BUILD=$build test" "$b/memory $b/faults" "make -s P=cover BUILD=$build end-to-end" "LASTINGS=0 sh tests/faults.sh $b $b/etalon 500" > "$b/cover.log" 2>&1
tail -n 1 "$b/cover.log"
grep '^FAIL' "$b/cover.log"
gcovr --gcov-ignore-parse-errors -r . -f src/ --object-directory "$b" --exclude-throw-branches --exclude-unreachable-branches --json "$b/cover.json" --html-details "$b/coverage.html" > /dev/null || exit 2
python3 tests/cover/judge.py "$b/cover.json" tests/cover/unreached.tsv
