#!/bin/sh
# accuracy.sh PROGRAM CASES PAGE: the program's table into the page, between its two marks.
set -eu
program=$1 cases=$2 page=$3
table=$(mktemp) new=$(mktemp)
trap 'rm -f "$table" "$new"' EXIT
grep -q '^<!-- measured -->$' "$page" && grep -q '^<!-- end -->$' "$page" || { echo "accuracy: $page has no marks for the table" >&2; exit 1; }
"$program" "$cases" > "$table"
awk -v table="$table" '
    /^<!-- measured -->$/ { print; print ""; while ((getline line < table) > 0) print line; print ""; skip = 1 }
    /^<!-- end -->$/ { skip = 0 }
    !skip { if ($0 != "<!-- measured -->") print }' "$page" > "$new"
cat "$new" > "$page"
echo "the table is in $page"
