#!/bin/sh
# fuzz.sh BUILD NAME SECONDS: fuzz one property, or with an empty name each in turn, starting from fuzz/corpus.
# What is found stands in BUILD/found/NAME.crash-*, ready for `check --shrink`.
set -u
build=$1 name=$2 seconds=$3
list=$(sed -nE 's/^    \{ "([a-z0-9_]+)", prop_.*/\1/p' "$build/registry.c")
passed=0 failed=0
for p in ${name:-$list}; do
    case " $(echo $list) " in *" $p "*) ;; *) echo "FAIL $p: no property of this name"; exit 2 ;; esac
    mkdir -p "$build/corpus/$p" "$build/found"
    for f in fuzz/corpus/"${p%%_*}/$p".*; do [ -f "$f" ] && cp "$f" "$build/corpus/$p/"; done
    if ET_PROP=$p "$build/fuzzer" -max_total_time="$seconds" -timeout=30 -rss_limit_mb=2048 -print_final_stats=1 \
        -artifact_prefix="$build/found/$p." "$build/corpus/$p" > "$build/found/$p.log" 2>&1; then
        passed=$((passed + 1))
        echo "ok $p $(sed -n 's/stat::number_of_executed_units: *//p' "$build/found/$p.log") cases"
    else
        failed=$((failed + 1))
        echo "FAIL $p: see $build/found/$p.log"
        grep -E 'ERROR|SUMMARY|Test unit written' "$build/found/$p.log" | head -n 3
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
