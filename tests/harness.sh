#!/bin/sh
# harness.sh FOLDER CC: the test harness tested: planted faults are found, shrunk to the simplest case known, and replayed.
set -u
here=$1 cc=$2 t=tests/harness
passed=0 failed=0
mkdir -p "$here" || exit 2
flags='-std=c99 -pedantic-errors -g -O1 -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion -Werror -D_POSIX_C_SOURCE=200809L -Itests'
sh tests/registry.sh $t/planted.c > "$here/registry.c"
$cc $flags -o "$here/check" $t/planted.c "$here/registry.c" tests/check.c tests/gen.c tests/golden.c tests/shrink.c -lm || exit 2
check=$here/check

# told WHAT COMMAND...: a test.
told() {
    what=$1
    shift
    if "$@"; then passed=$((passed + 1)); echo "ok harness: $what"; else failed=$((failed + 1)); echo "FAIL harness: $what"; fi
}
bytes() { echo $(od -An -v -tx1 "$1"); }
fails() { ! "$@" > "$here/out" 2>&1 && tail -n 1 "$here/out" | grep -q ', 1 failed$'; }
run() { "$@" > "$here/out"; }
says() { grep -q -- "$1" "$here/out"; }

# shrinks NAME BYTES: from many seeds, always to these bytes, which fail again.
shrinks() {
    for seed in 1 2 3 4 5 6 7 8 9 10 11 12; do
        rm -f "$here/planted_$1.fail"
        fails "$check" -n 100000 -s $seed "planted_$1" || { echo "  seed $seed: not found"; return 1; }
        [ "$(bytes "$here/planted_$1.fail")" = "$2" ] || { echo "  seed $seed: $(bytes "$here/planted_$1.fail"), not $2"; return 1; }
    done
    fails "$check" --replay "$here/planted_$1.fail"
}
told 'a length'                        shrinks length   '05 00 00 00 00 00 00 00 00 00 00'
told 'a sum is moved to the end'       shrinks sum      '03 01 f4 03 e8 03 e8'
told 'two equal values'                shrinks twins    '02 01 01'
told 'an order'                        shrinks unsorted '02 00 01 00 00'
told 'a list with marks'               shrinks marked   '01 32 01 32 00'
told 'a list of lists'                 shrinks nested   '01 03 00 00 09'
told 'a large number'                  shrinks large    '00 00 00 02 df dc 1c 35'
told 'a failure that is not monotone'  shrinks odd      '00 00 65'
told 'a difference that must be kept'  shrinks apart    '33 2c'
told 'a real'                          shrinks real     '00 0b'
told 'knots'                           shrinks knots    '02 02 01 03 03'
told 'points'                          shrinks points   '01 00 00 00 00 00 09 01 00 00 00'
told 'a crash'                         shrinks crash    '01 03 0a'
told 'a text'                          shrinks raw      '28'

hang() { ET_SECONDS=1 fails "$check" -n 100000 planted_hang && says 'timed out' && [ "$(bytes "$here/planted_hang.fail")" = '03 e7' ]; }
told 'an endless loop is stopped and its case kept' hang
skips() { fails "$check" planted_skips && says 'skips .* of 1000'; }
told 'more than nine in ten skipped is a failure' skips
told 'fewer are not' run "$check" sound_skips
told 'the generators are sound' run "$check" -n 20000 sound
labels() { "$check" -v sound > "$here/out" && says '% one ulp apart' && says '% full multiplicity' && says '% right end' && says '% coincident'; }
told 'hard cases come' labels
all_labels() { "$check" --labels sound > "$here/out" && says '^# a knots: uniform' && says '^sound_knots  *1000  *0  .*  [1-9]' && says '^sound_real  *1000  *0   \.'; }
told 'their shares are told, a line a property' all_labels
rest() { "$check" -v sound_rest > "$here/out" && says '% altered' && says '% a sample as it is' && says '% nothing'; }
told 'a reader is given samples and what is made of them' rest
again() { "$check" > "$here/a" 2> /dev/null; "$check" > "$here/b" 2> /dev/null; cmp -s "$here/a" "$here/b"; }
ET_SECONDS=1
export ET_SECONDS
told 'the same seed tells the same' again
unset ET_SECONDS
unknown() { fails "$check" nobody && fails "$check" --replay "$here/nobody.x"; }
told 'an unknown property is a failure' unknown

# Files: any bytes are a case; what is missing is zero.
printf '\377\377\377' > "$here/planted_large.ff"
: > "$here/planted_large.empty"
head -c 3000 "$check" > "$here/sound_knots.noise"
told 'a file of large bytes fails' fails "$check" --replay "$here/planted_large.ff"
told 'an empty file is the simplest case' run "$check" --replay "$here/planted_large.empty"
told 'any file is a case' run "$check" --replay "$here/sound_knots.noise"
shrunk() { fails "$check" --shrink "$here/planted_large.ff" && [ "$(bytes "$here/planted_large.fail")" = '00 00 00 02 df dc 1c 35' ]; }
told 'a file can be shrunk' shrunk
printf 'f(x) = (1))' > "$here/planted_raw.text"
printf '(f)(x) = 1' > "$here/planted_raw.good"
raw() { fails "$check" --replay "$here/planted_raw.text" && says 'depth -1: f(x) = (1))' && run "$check" --replay "$here/planted_raw.good"; }
told 'to a reader a file is its own text' raw

# golden ROW...: a table of these rows.
golden() { printf '%b\n' "$@" > "$here/rows.tsv"; }
caught() { golden "$2"; fails "$check" --golden "$here/rows.tsv" && says "$1"; }
passes() { golden "$@"; "$check" --golden "$here/rows.tsv" > "$here/out" && says "^$# passed, 0 failed"; }
told 'rows that are right' passes 'planted_half\texact\tr\t0x1p-3\t0x1p-4' 'planted_half\tulp 1\tr\t2\t0x1.0000000000001p+0' \
    'planted_half\tabs 0x1p-10\tr\t2\t1.0009' 'planted_count\texact\tr\t4\t5' 'planted_half\texact\tr\tinf\tinf' 'planted_half\texact\tr\tnan\tnan' \
    'planted_half\tresidual 4\tr\t8\t-' 'planted_half\tbits\tr\t-0\t-0x0p+0'
told 'one ulp off is caught' caught '1 ulps apart' 'planted_half\texact\tr\t2\t0x1.0000000000001p+0'
told 'two ulps off are caught' caught '2 ulps apart' 'planted_half\tulp 1\tr\t2\t0x1.0000000000002p+0'
told 'one ulp off across zero is caught' caught '2 ulps apart' 'planted_half\tulp 1\tr\t-0x1p-1073\t0x1p-1074'
told 'beyond a bound is caught' caught 'apart' 'planted_half\tabs 0x1p-10\tr\t2\t0x1.005p+0'
told 'a residual too large is caught' caught 'r' 'planted_half\tresidual 4\tr\t8.5\t-'
told 'the sign of zero is caught' caught 'got -0x0p+0' 'planted_half\texact\tr\t-0\t0'
told 'NaN is no bound' caught 'got' 'planted_half\tabs 0x1p+900\tr\tnan\t1'
told 'a wrong count is caught' caught 'wanted count' 'planted_count\texact\tr\t4\t6'
told 'an unknown function is caught' caught 'no such golden check' 'nobody\texact\tr\t4\t6'
told 'an unknown class is caught' caught 'malformed row' 'planted_half\tnearly\tr\t2\t1'
told 'a missing column is caught' caught 'malformed row' 'planted_half\texact\t2\t1'
told 'a missing argument is caught' caught 'argument 0' 'planted_half\texact\tr\t\t0'
denied() { golden "$2"; fails "$check" --truth "$here/rows.tsv" && says "$1"; }
told 'a tolerant row one ulp off is caught by the exact layer' denied '1 ulps apart' 'planted_half\tulp 3\tr\t2\t0x1.0000000000001p+0'
told 'a tolerant row that the exact layer does not know is caught' denied 'no exact function' 'planted_count\tulp 1\tr\t4\t5'
known() { golden "$@"; "$check" --truth "$here/rows.tsv" > "$here/out" && says '2 rows computed again exactly, 1 that the exact layer does not know'; }
told 'the exact layer knows rows, and leaves strict ones out' known 'planted_half\tulp 1\tr\t2\t1' 'planted_half\tbits\tr\t-0\t0' 'planted_count\texact\tr\t4\t5'
told 'an empty table is caught' caught 'no rows' '# nothing'
bites() { golden "$2"; "$1" "$check" --bite "$here/rows.tsv"; }
told 'altered values are noticed' bites run 'planted_half\tulp 3\tr\t2\t1'
told 'a value nobody looks at is found' bites fails 'planted_blind\texact\tr\t2\t2 3'

# The other engines, where they are installed: fuzz/fuzz.sh finds the same fault with either, among a sound property.
engine() {
    mkdir -p "$here/$1" && rm -rf "$here/$1/found" "$here/$1/corpus" && cp "$here/registry.c" "$here/$1/" || return 1
    $2 $flags -fsanitize=$3address,undefined -c -o "$here/$1/planted.o" $t/planted.c || return 1
    $2 $flags -fsanitize=fuzzer,address,undefined -o "$here/$1/fuzzer" fuzz/fuzz.c "$here/$1/planted.o" "$here/registry.c" tests/gen.c tests/golden.c -lm
}
fuzzed() {
    engine "$1" "$2" "$3" || return 1
    rm -f "$here/planted_sum.fail"
    sh fuzz/fuzz.sh "$here" "$1" "$4" planted_sum sound_real > "$here/out" 2>&1 && return 1
    says '^FAIL planted_sum [1-9][0-9]* cases, .* edges' && says '^ok sound_real [1-9][0-9]* cases, .* edges, ' && says ', 1 findings' && says '^1 passed, 1 failed' || return 1
    fails "$check" --shrink "$(ls "$here/$1"/found/planted_sum.crash-* | head -n 1)" && [ "$(bytes "$here/planted_sum.fail")" = '03 01 f4 03 e8 03 e8' ]
}
nobody() { sh fuzz/fuzz.sh "$here" fuzz 1 nobody > "$here/out"; [ $? -eq 2 ] && says 'nobody: no property'; }
# Stopped early: what there is so far, and nothing left running.
stopped() {
    begun=$(date +%s)
    sh fuzz/fuzz.sh "$here" fuzz 60 sound > "$here/out" &
    sleep 2
    kill -TERM $! && wait $!
    says '^stopped after [12] of ' && says ' 0 findings' && says ' passed, 0 failed' && [ $(($(date +%s) - begun)) -lt 30 ]
}
# What fuzzing kept: few files, and each reaches something new; the named ones stay.
kept() {
    rm -rf "$here/tree" && mkdir -p "$here/tree/fuzz/corpus/sound" && cp fuzz/min.sh "$here/tree/fuzz/" && : > "$here/tree/fuzz/corpus/sound/sound_real.named" || return 1
    (cd "$here/tree" && sh fuzz/min.sh .. sound_real) > "$here/out" || return 1
    says '^ok sound_real [1-9][0-9]* files, [1-4] kept' && [ -f "$here/tree/fuzz/corpus/sound/sound_real.named" ] && ls "$here/tree/fuzz/corpus/sound"/sound_real.found-* > /dev/null
}
if command -v clang > /dev/null; then
    told 'libFuzzer finds, check shrinks, the same file' fuzzed fuzz clang fuzzer-no-link, 5
    told 'an unknown target is a failure' nobody
    told 'fuzzing can be stopped' stopped
    told 'a corpus is reduced to what is worth keeping' kept
fi
if command -v afl-clang-fast > /dev/null; then
    AFL_QUIET=1 AFL_DONT_OPTIMIZE=1
    export AFL_QUIET AFL_DONT_OPTIMIZE
    told 'AFL++ finds, check shrinks, the same file' fuzzed afl afl-clang-fast '' 5
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
