#!/bin/sh
# min.sh BUILD [PROPERTY | MODULE]...: what fuzzing kept (BUILD/fuzz/corpus and BUILD/afl/corpus), reduced to a few small files a property that together
# reach most of what the named files in fuzz/corpus/MODULE do not, put there as PROPERTY.found-SUM; earlier files of that name are chosen among, too.
# KEEP: how many of a property (4, of one on raw bytes 16); MOST: how many bytes one may have (600, 2000).
set -u
build=$1
shift
work=$(mktemp -d) || exit 2
[ -x "$build/fuzz/fuzzer" ] || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
sed -nE 's/^    \{ "([a-z0-9_]+)", prop_.*/\1/p' "$build/fuzz/registry.c" > "$work/all"
[ $# -gt 0 ] || set -- '[a-z0-9]*'
for n in "$@"; do grep -E "^$n(_|\$)" "$work/all"; done | sort -u > "$work/names"
passed=0 failed=0

# The control file of libFuzzer's merge lists the files, the named ones first and then by size, and of each the features that none before it reached.
gains='
/^FT / { print NF - 2, file[$2 + 0]; next }
/^(STARTED|COV|DONE)/ { next }
NR > 2 { file[NR - 3] = $0 }'
while read -r name <&4; do
    room=fuzz/corpus/${name%%_*}
    case $name in *_raw | *_raw_*) keep=${KEEP:-16} most=${MOST:-2000} ;; *) keep=${KEEP:-4} most=${MOST:-600} ;; esac
    rm -rf "$work/named" "$work/grown" "$work/control"
    mkdir -p "$work/named" "$work/grown" "$room"
    for f in "$room/$name".*; do
        case $f in *.found-*) cp "$f" "$work/grown/" ;; *) [ ! -f "$f" ] || cp "$f" "$work/named/" ;; esac
    done
    for d in "$build/fuzz/corpus/$name" "$build/afl/corpus/$name"; do
        [ ! -d "$d" ] || find "$d" -type f -size -"$((most + 1))"c -exec cp {} "$work/grown/" \;
    done
    [ -n "$(find "$work/grown" -type f)" ] || continue
    if ! nice -n 19 env ET_PROP="$name" "$build/fuzz/fuzzer" -merge=1 -timeout=30 -rss_limit_mb=2048 -merge_control_file="$work/control" \
        "$work/named" "$work/grown" > "$work/log" 2>&1; then
        failed=$((failed + 1))
        echo "FAIL $name: $(tail -n 1 "$work/log")"
        continue
    fi
    awk "$gains" "$work/control" | grep -F " $work/grown/" | sort -rn | head -n "$keep" | cut -d ' ' -f 2- > "$work/chosen"
    mkdir -p "$work/new" && rm -f "$work/new"/*
    while read -r f; do cp "$f" "$work/new/$name.found-$(cksum < "$f" | cut -d ' ' -f 1)"; done < "$work/chosen"
    rm -f "$room/$name".found-*
    for f in "$work/new"/*; do [ ! -f "$f" ] || cp "$f" "$room/"; done
    passed=$((passed + 1))
    echo "ok $name $(find "$work/grown" -type f | grep -c .) files, $(grep -c . "$work/chosen") kept"
done 4< "$work/names"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
