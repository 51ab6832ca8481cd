#!/bin/sh
# audit.sh LIBRARY: one word, eight rooms.  Every public function has its declaration with comment and contract, its property, its golden rows (or
# the reason why there are none), its page; every module its corpus; and no room holds anything else.
set -u
LC_ALL=C
export LC_ALL
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
passed=0 failed=0 why=

lacks() { why="$why; $1"; }
verdict() {
    if [ -z "$why" ]; then passed=$((passed + 1)); echo "ok $1"; else failed=$((failed + 1)); echo "FAIL $1: ${why#; }"; fi
    why=
}
is_module() { grep -qx "$1" "$work/modules"; }
# A function's name, or one with more after it.
is_about() {
    about=$1
    while ! grep -qx "et_$about" "$work/functions"; do
        case $about in *_*) about=${about%_*} ;; *) return 1 ;; esac
    done
}

nm -g --defined-only "$1" 2> /dev/null | awk 'NF == 3 && $2 ~ /[TDBRC]/ { print $2, $3 }' | sort -u > "$work/symbols"
awk '$1 == "T" && $2 ~ /^et_[a-z0-9]+_[a-z0-9_]+$/ { print $2 }' "$work/symbols" > "$work/functions"
ls include/etalon/*/*.h | sed 's|.*/||; s|\.h$||' | sort > "$work/modules"

# HEADER FUNCTION CONTRACT COMMENT GOLDEN: what stands directly before each prototype.
awk '
    function opened(s) { return s ~ /^[ \t]*\/\*/ }
    FNR == 1 { last = before = text = ""; inside = depth = more = 0 }
    inside { text = text "\n" $0; if ($0 ~ /\*\//) inside = 0; next }
    opened($0) {
        before = last; last = $0 ~ /^[ \t]*\/\*@/ ? "contract" : "comment"
        if (last == "comment") text = ""
        text = text "\n" $0; inside = $0 !~ /\*\//; next
    }
    /^[ \t]*\/\/@/ { if (last != "contract") { before = last; last = "contract" } text = text "\n" $0; next }
    /^extern "C"/ || (/^}$/ && !depth) { next }
    /^[ \t]*$/ { if (!more && !depth) last = before = ""; next }
    {
        if (!more && !depth && $0 !~ /^(typedef|#|static)/ && match($0, /et_[a-z0-9]+_[a-z0-9_]+\(/))
            print FILENAME, substr($0, RSTART, RLENGTH - 1), last == "contract", last == "contract" ? before == "comment" : last == "comment",
                  text ~ /Golden: none \(/
        depth += gsub(/{/, "{") - gsub(/}/, "}"); more = depth == 0 && $0 !~ /;[ \t]*(\/\*.*\*\/[ \t]*)?$/ && $0 !~ /^(#|})/
        last = before = text = ""
    }' include/etalon/*/*.h > "$work/declared"
cat tests/*/test_*.c 2> /dev/null | sed -nE 's/^verdict prop_([a-z0-9_]+)\(gen \*g\)$/\1/p' > "$work/properties"
for f in golden/*.tsv; do [ -f "$f" ] && awk -F '\t' -v f="$f" '!/^#/ && NF > 1 { print f, $1 }' "$f"; done | sort -u > "$work/rows"

while read -r f; do
    n=${f#et_} m=${n%%_*}
    h=$(echo include/etalon/*/"$m.h") t=$(echo tests/*/"test_$m".c tests/*/"test_$m"_*.c)
    set -- $(grep -E "^[^ ]+/$m\.h $f " "$work/declared")
    if [ $# -lt 5 ]; then
        lacks "not declared in $h"
    else
        [ $# -eq 5 ] || lacks "declared more than once"
        [ "$3" = 1 ] || lacks "no contract directly before its prototype in $1"
        [ "$4" = 1 ] || lacks "no comment before its contract in $1"
        [ "$5" = 1 ] || grep -qE "^golden/$m\.tsv $n(_.*)?$" "$work/rows" || lacks "no rows in golden/$m.tsv, nor 'Golden: none (' in $1"
    fi
    cat $t 2> /dev/null | grep -qx "verdict prop_$n(gen \*g)" || lacks "no property prop_$n in $t"
    [ -f "docs/$m.md" ] && grep -qx "## $f" "docs/$m.md" || lacks "no section '## $f' in docs/$m.md"
    verdict "$f"
done < "$work/functions"

while read -r m; do
    h=$(echo include/etalon/*/"$m.h") r=${h#include/etalon/} r=${r%/*}
    [ -f "$h" ] || lacks "in more than one room"
    grep -q "^et_${m}_" "$work/functions" || { grep -q "^$h " "$work/declared" && lacks "none of its functions is in the library"; }
    if grep -q "^$h " "$work/declared"; then
        [ -f "src/$r/$m.c" ] || [ -f "src/$r/$m.cpp" ] || lacks "no src/$r/$m.c"
        ls "tests/$r/test_$m".c "tests/$r/test_$m"_*.c 2> /dev/null | grep -q . || lacks "no tests/$r/test_$m.c"
        [ -f "docs/$m.md" ] && grep -qx "# $m" "docs/$m.md" || lacks "no docs/$m.md with the title '# $m'"
        found=
        for c in fuzz/corpus/"$m"/*; do
            c=${c##*/} c=${c%%.*}
            case $c in "$m"_*) grep -qx "$c" "$work/properties" && found=1 ;; esac
        done
        [ -n "$found" ] || lacks "no case of its properties in fuzz/corpus/$m"
    fi
    verdict "module $m"
done < "$work/modules"

# Orphans.
awk '!($1 == "T" && $2 ~ /^et_[a-z0-9]+_[a-z0-9_]+$/) { print $1, $2 }' "$work/symbols" > "$work/odd"
# What the parts of one module share begins with its word and is declared in a header private to its room.
while read -r kind s; do
    known=
    for h in $(grep -lE "(^|[^a-z0-9_])$s[(]" src/*/*.h 2> /dev/null); do
        m=${h##*/} m=${m%.h} m=${m%%_*}
        case $kind$s in T"$m"*) is_module "$m" && known=1 ;; esac
    done
    [ -n "$known" ] || lacks "$s ($kind)"
done < "$work/odd"
verdict 'the library exports functions et_MODULE_VERB, and what the parts of a module share'
for f in $(awk '{ print $2 }' "$work/declared"); do grep -qx "$f" "$work/functions" || lacks "$f"; done
verdict 'every declared function is defined'
for s in src/*/*.c src/*/*.cpp; do
    r=${s#src/} r=${r%/*} m=${s##*/} m=${m%.*}
    [ "$r" = cli ] || [ ! -f "$s" ] || [ -f "include/etalon/$r/${m%%_*}.h" ] || lacks "$s"
done
verdict 'every source file is a module, or MODULE_part, with its header in the same room'
for t in tests/*/test_*.c; do
    r=${t#tests/} r=${r%/*} m=${t##*/test_} m=${m%.c}
    [ ! -f "$t" ] || [ "$r" = cli ] || [ -f "include/etalon/$r/${m%%_*}.h" ] || lacks "$t"
done
while read -r p; do is_about "$p" || lacks "prop_$p"; done < "$work/properties"
verdict 'every test is about a public function'
while read -r f n; do
    m=${f##*/} m=${m%.tsv}
    is_module "$m" || lacks "$f"
    case $n in "$m"_*) is_about "$n" || lacks "$f: $n" ;; *) lacks "$f: $n" ;; esac
done < "$work/rows"
for f in tests/golden/*.py; do
    m=${f##*/} m=${m%.py}
    [ ! -f "$f" ] || [ "$m" = second ] || [ "$m" = conformance ] || is_module "${m%%_*}" || grep -qE "^(import|from) $m( |\$)" tests/golden/*.py || lacks "$f"
done
verdict 'every golden row is about a function of its module'
for d in fuzz/corpus/*; do
    [ -d "$d" ] || continue
    is_module "${d##*/}" || lacks "$d"
    for c in "$d"/*; do
        [ -f "$c" ] || continue
        n=${c##*/} n=${n%%.*}
        case $n in "${d##*/}"_*) grep -qx "$n" "$work/properties" || lacks "$c" ;; *) lacks "$c" ;; esac
    done
done
verdict 'every file of the corpus is a case of a property of its module'
for s in $(sed -nE 's/^#+ (et_[a-z0-9_]+)$/\1/p' docs/*.md 2> /dev/null); do grep -qx "$s" "$work/functions" || lacks "$s"; done
verdict 'every heading of a function in docs is about one that exists'
for f in proofs/*; do
    m=${f##*/} m=${m%%[._]*}
    case ${f##*/} in README.md | *.sh | *.py | wp.tsv | status.tsv | mutants.tsv | planted.c | heap.ml | why3.conf | why3 | coq | gappa | eva | logic) continue ;; esac
    [ ! -e "$f" ] || is_module "$m" || lacks "$f"
done
verdict 'every proof is about a module that exists'
if [ -f proofs/status.tsv ]; then
    grep -v '^#' proofs/status.tsv | cut -f 1 | sort > "$work/status"
    comm -3 "$work/status" "$work/functions" | tr -d '\t' | while read -r s; do echo "$s in proofs/status.tsv"; done > "$work/unlike"
    while read -r s; do lacks "$s"; done < "$work/unlike"
    awk -F '\t' '!/^#/ && (NF != 4 || $2 !~ /^(-|(safe|order|real|bound)( (safe|order|real|bound))*)$/ || $3 == "" || $4 == "")' proofs/status.tsv > "$work/odd"
    while read -r s; do lacks "$s"; done < "$work/odd"
    verdict 'proofs/status.tsv has a line for each public function and says what is proved, by what, and what is not'
    for room in base net spline som fit; do cat include/etalon/"$room"/*.h; done | grep -oE '\bet_[a-z0-9_]+\(' | tr -d '(' | sort -u |
        comm -12 - "$work/functions" > "$work/low"
    awk -F '\t' 'NR == FNR { low[$1] = 1; n++; next } low[$1] && $2 ~ /safe/ { safe++ } END { if (20 * safe < 19 * n) printf "%d of %d functions are safe\n", safe, n }' \
        "$work/low" proofs/status.tsv > "$work/few"
    while read -r s; do lacks "95 %: $s"; done < "$work/few"
    verdict 'of the functions of floors 0 to 2 at least 95 % are proved safe'
fi
for u in $(sed -nE 's/^([a-z][^\t]*)\t.*/\1/p' proofs/wp.tsv 2> /dev/null); do [ -f "golden/proofs/$u.tsv" ] || lacks "golden/proofs/$u.tsv"; done
for g in golden/proofs/*.tsv; do
    u=${g##*/} u=${u%.tsv}
    [ ! -f "$g" ] || [ "$u" = proved ] || [ "$u" = eva ] || grep -q "^$u	" proofs/wp.tsv || lacks "$g"
done
verdict 'every unit of proofs/wp.tsv has its golden goals'
for b in tests/bench/bench_*.c; do
    m=${b##*/bench_} m=${m%.c}
    [ ! -f "$b" ] || is_module "${m%%_*}" || [ -d "include/etalon/${m%%_*}" ] || lacks "$b"
done
verdict 'every benchmark is about a module or a room'
v=$(sed -n 's/^VERSION := //p' Makefile)
grep -rq "ETALON_VERSION \"$v\"" src/cli || lacks "src/cli does not say $v"
grep -q "^## $v" CHANGELOG.md 2> /dev/null || lacks "CHANGELOG.md has no section $v"
verdict 'one version everywhere'
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
