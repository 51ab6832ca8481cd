#!/bin/sh
# oss-fuzz.sh FOLDER [all]: what OSS-Fuzz does with fuzz/oss-fuzz/build.sh, without its image: build, then run each target on its seeds for a moment.
# Without `all` the rooms base and spline only, which takes seconds.
set -u
mkdir -p "$1/src" "$1/out" "$1/work" && here=$(cd "$1" && pwd) || exit 2
if ! command -v clang > /dev/null || ! command -v zip > /dev/null; then echo 'skip oss-fuzz: clang or zip is not installed'; exit 0; fi
rm -rf "$here/src/etalon" "${here:?}/out"/*
ln -s "$PWD" "$here/src/etalon"
passed=0 failed=0
told() {
    what=$1
    shift
    if "$@"; then passed=$((passed + 1)); echo "ok oss-fuzz: $what"; else failed=$((failed + 1)); echo "FAIL oss-fuzz: $what"; fi
}
sanitize='-fsanitize=address,undefined -fno-sanitize-recover=all -fsanitize=fuzzer-no-link'
SRC=$here/src OUT=$here/out WORK=$here/work SANITIZER=address LIB_FUZZING_ENGINE=-fsanitize=fuzzer CC=clang CXX=clang++
CFLAGS="-O1 -fno-omit-frame-pointer -gline-tables-only -DFUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION $sanitize" CXXFLAGS=$CFLAGS
export SRC OUT WORK SANITIZER LIB_FUZZING_ENGINE CC CXX CFLAGS CXXFLAGS
if [ "${2:-}" != all ]; then
    ROOMS='base spline' TARGETS='rng_seek_sequence curve_point_sisl basis_eval_gsl knots_span'
    export ROOMS TARGETS
fi
built() { MAKEFLAGS='' sh fuzz/oss-fuzz/build.sh > "$here/log" 2>&1 && grep -qE '^[1-9][0-9]* targets in ' "$here/log" || { tail -n 5 "$here/log"; false; }; }
runs() {
    rm -rf "$here/seeds" && mkdir "$here/seeds" || return 1
    [ ! -f "$OUT/$1_seed_corpus.zip" ] || python3 -m zipfile -e "$OUT/$1_seed_corpus.zip" "$here/seeds" || return 1
    [ -f "$OUT/$1.options" ] && (cd "$here/seeds" && "$OUT/$1" -runs=200 -max_total_time=5 "$here/seeds" > "$here/log" 2>&1 && grep -q 'Done [0-9]* runs' "$here/log") \
        || { tail -n 5 "$here/log"; false; }
}
seeded() { ls "$OUT"/*_seed_corpus.zip > /dev/null 2>&1; }
told 'build.sh builds the targets' built
told 'targets bring seeds' seeded
for f in "$OUT"/*.options; do
    [ ! -f "$f" ] || { name=$(basename "$f" .options); told "$name runs" runs "$name"; }
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
