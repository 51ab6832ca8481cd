#!/bin/sh
# fuzz.sh BUILD ENGINE SECONDS [PROPERTY | MODULE]...: fuzz each property (all, if none is named) for so many seconds, one a processor at a time.
# ENGINE: fuzz (libFuzzer) or afl (AFL++).  Each starts from fuzz/corpus/MODULE/PROPERTY.* and what earlier runs left in BUILD/ENGINE/corpus/PROPERTY, with
# the dictionary fuzz/dict/PROPERTY.dict where there is one.  What is found stands in BUILD/ENGINE/found/PROPERTY.*, ready for `check --shrink`.
# Ctrl-C ends it with what there is so far.  ET_JOBS: how many at once.
set -u
build=$1/$2 engine=$2 seconds=$3
shift 3
work=$(mktemp -d) || exit 2
jobs=${ET_JOBS:-$(nproc 2> /dev/null || echo 1)}
mkdir -p "$build/corpus" "$build/found"
trap 'rm -rf "$work"' EXIT
trap 'touch "$work/stop"; for p in "$work"/*.pid; do [ -f "$p" ] && kill -TERM "$(cat "$p")" 2> /dev/null; done' INT TERM

# The names wanted, in their order.
sed -nE 's/^    \{ "([a-z0-9_]+)", prop_.*/\1/p' "$build/registry.c" > "$work/all"
[ $# -gt 0 ] || set -- ''
for n in "$@"; do
    if [ -z "$n" ]; then cat "$work/all"; else grep -E "^$n(_|\$)" "$work/all" || echo "$n" >> "$work/unknown"; fi
done > "$work/picked"
awk '!seen[$0]++' "$work/picked" > "$work/names"
if [ -f "$work/unknown" ]; then echo "FAIL $(head -n 1 "$work/unknown"): no property of this name"; echo "0 passed, 1 failed"; exit 2; fi
total=$(grep -c . "$work/names")

# Sizes beyond all memory are asked for on purpose; what AFL++ wants of the sanitizer it wants said.
sizes=allocator_may_return_null=1
[ "$engine" = fuzz ] || sizes=$sizes:abort_on_error=1:symbolize=0:detect_leaks=0
# run NAME COMMAND...: in the background with a process that can be told to stop; the log is BUILD/found/NAME.log.
run() {
    name=$1
    shift
    nice -n 19 env ET_PROP="$name" ASAN_OPTIONS="$sizes${ASAN_OPTIONS:+:$ASAN_OPTIONS}" "$@" > "$build/found/$name.log" 2>&1 < /dev/null &
    echo $! > "$work/$name.pid"
    [ ! -f "$work/stop" ] || kill -TERM $!
    wait $!
    code=$?
    rm -f "$work/$name.pid"
    return $code
}
count() { ls "$1" 2> /dev/null | grep -c .; }

with_fuzz() {
    before=$(count "$corpus")
    run "$1" "$build/fuzzer" -max_total_time="$seconds" -timeout=30 -rss_limit_mb=2048 -print_final_stats=1 ${dict:+"-dict=$dict"} \
        -artifact_prefix="$build/found/$1." "$corpus"
    code=$?
    log=$build/found/$1.log
    cases=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)
    speed=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log" | tail -n 1)
    edges=$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1)
    new=$(($(count "$corpus") - before))
    found=$(sed -nE 's/.*Test unit written to (.*)/\1/p' "$log" | grep -v '\.slow-unit-' | tail -n 1)
    [ $code -eq 0 ] || [ -f "$work/stop" ] || found=${found:-$log}
}

with_afl() {
    rm -rf "$build/out/$1"
    mkdir -p "$build/out"
    [ -n "$(find "$corpus" -type f -size +0)" ] || printf '\0' > "$corpus/zero"
    AFL_NO_UI=1 AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_AFFINITY=1 AFL_FAST_CAL=1 \
        run "$1" afl-fuzz -i "$corpus" -o "$build/out/$1" -V "$seconds" -t 30000 -m none ${dict:+-x "$dict"} -- "$build/fuzzer"
    code=$?
    log=$build/found/$1.log out=$build/out/$1/default
    stat() { sed -n "s/^$1 *: *//p" "$out/fuzzer_stats" 2> /dev/null; }
    cases=$(stat execs_done) speed=$(stat execs_per_sec | cut -d . -f 1) edges=$(stat edges_found) new=$(stat corpus_found) found=
    for f in "$out"/crashes/id* "$out"/hangs/id*; do
        [ -f "$f" ] || continue
        case $f in */crashes/*) kind=crash ;; *) kind=timeout ;; esac
        found=$build/found/$1.$kind-$(cksum < "$f" | cut -d ' ' -f 1)
        cp "$f" "$found"
    done
    for f in "$out"/queue/id*; do
        case $f in *orig:*) ;; *) [ ! -f "$f" ] || cp "$f" "$corpus/$(cksum < "$f" | tr ' ' -)" ;; esac
    done
    [ $code -eq 0 ] && [ -n "$cases" ] || [ -f "$work/stop" ] || found=${found:-$log}
}

# One target, one line.
target() {
    corpus=$build/corpus/$1 dict=fuzz/dict/$1.dict
    mkdir -p "$corpus"
    [ -f "$dict" ] || dict=
    rm -f "$build/found/$1".*
    for f in fuzz/corpus/"${1%%_*}/$1".*; do [ ! -f "$f" ] || cp "$f" "$corpus/"; done
    "with_$engine" "$1"
    figures="${cases:-0} cases, ${speed:-0}/s, ${edges#cov: } edges, ${new:-0} new"
    said="ok $1 $figures"
    [ -z "$found" ] || said="FAIL $1 $figures: $found: $(grep -E 'SUMMARY: |ERROR: [a-zA-Z]+: |PROGRAM ABORT' "$log" | head -n 1)"
    echo "$said" | tee -a "$work/said"
    echo "${cases:-0} ${new:-0} ${found:+1}" >> "$work/sums"
}

# A slot is a line in a pipe.
mkfifo "$work/slots" && exec 3<> "$work/slots" || exit 2
k=0 begun=0 started=$(date +%s)
while [ $k -lt "$jobs" ]; do echo >&3; k=$((k + 1)); done
while read -r name <&4; do
    read -r _ <&3
    [ ! -f "$work/stop" ] || break
    if [ -t 2 ]; then
        left=$(((total - begun + jobs - 1) / jobs * seconds))
        printf '\r\033[K%d of %d targets begun, %d min %d s left\r' "$begun" "$total" $((left / 60)) $((left % 60)) >&2
    fi
    { target "$name"; echo >&3; } &
    begun=$((begun + 1))
done 4< "$work/names"
until wait; do :; done
[ ! -t 2 ] || printf '\033[K' >&2
[ ! -f "$work/stop" ] || echo "stopped after $begun of $total targets"
touch "$work/sums"
awk -v s=$(($(date +%s) - started)) '{ cases += $1; new += $2; found += $3 }
    END { printf "%d cases in %d s, %d new entries of corpora, %d findings\n", cases, s, new, found }' "$work/sums"
touch "$work/said"
echo "$(grep -c '^ok ' "$work/said") passed, $(grep -c '^FAIL ' "$work/said") failed"
! grep -q '^FAIL ' "$work/said"
