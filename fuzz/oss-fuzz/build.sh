#!/bin/sh
# build.sh: one program a target into $OUT, with its seeds (NAME_seed_corpus.zip), dictionary (NAME.dict) and options (NAME.options), by the conventions of
# OSS-Fuzz: SRC, OUT, WORK, CC, CXX, CFLAGS, CXXFLAGS, LIB_FUZZING_ENGINE, SANITIZER are given.  Ours: TARGETS, properties by pattern, or `all`; ROOMS.
set -eu
cd "$SRC/etalon"
rooms=${ROOMS:-base spline net som fit refine exact io conform}
targets=${TARGETS:-'.*_raw(_.*)? .*_sequence .*_sisl .*_gsl exact_(basis|curve|surface)_(eval|ders|point|insert|remove|elevate) exact_param_row exact_fit_solve'}
build=$WORK/build libs=$OUT/lib

# What is in C++ is left out, as on other processors, and SISL or Arb's own library where they are not packaged (FLINT 3 contains Arb).
left="$(echo src/*/*.cpp) $(echo src/cli/*.c tests/cli/test_*.c) $(grep -l 'etalon/refine/ceres\.h' src/*/*.c tests/*/test_*.c 2> /dev/null | tr '\n' ' ' || :)"
gone='-lceres -lglog -lstdc++' second='-lgsl -lgslcblas -lsisl' include=
[ -f /usr/include/sisl.h ] || { left="$left $(echo tests/spline/test_*_sisl.c)" second='-lgsl -lgslcblas'; }
[ -f /usr/include/arb.h ] || { gone="$gone -lflint-arb" include=-I/usr/include/flint; }
make -s -j"$(nproc)" P=oss BUILD="$build" ROOMS="$rooms" LEFT_OUT="$left" LEFT_OUT_LIBS="$gone" GSL="$second" CC_oss="$CC" \
    FLAGS_oss="$CFLAGS $include -Wno-error" "$build/oss/libfuzz.a"
needs="$second $(make -s P=oss BUILD="$build" LEFT_OUT_LIBS="$gone" print-libs)"

mkdir -p "$libs"
# shellcheck disable=SC2086
$CXX $CXXFLAGS -o "$WORK/fuzzer" "$build/oss/libfuzz.a" "$build/oss/libetalon.a" $LIB_FUZZING_ENGINE -Wl,--as-needed -Wl,-rpath,'$ORIGIN/lib' $needs
# The machine that runs it has a C library and nothing else.
ldd "$WORK/fuzzer" | awk '/=> \// { print $3 }' | grep -vE '/(libc|libm|libdl|librt|libpthread)\.so' | while read -r l; do cp -L "$l" "$libs/"; done

made=0
for name in $(sed -nE 's/^    \{ "([a-z0-9_]+)", prop_.*/\1/p' "$build/oss/registry.c"); do
    wanted=
    for t in $targets; do [ "$t" != all ] && ! echo "$name" | grep -qxE "$t" || wanted=1; done
    [ -n "$wanted" ] || continue
    ln -f "$WORK/fuzzer" "$OUT/$name" 2> /dev/null || cp "$WORK/fuzzer" "$OUT/$name"
    rm -f "$OUT/${name}_seed_corpus.zip"
    seeds=$(ls fuzz/corpus/"${name%%_*}/$name".* 2> /dev/null || :)
    [ -z "$seeds" ] || zip -q -j "$OUT/${name}_seed_corpus.zip" $seeds
    [ ! -f "fuzz/dict/$name.dict" ] || cp -L "fuzz/dict/$name.dict" "$OUT/"
    printf '[libfuzzer]\ntimeout = 30\nmax_len = 16384\n' > "$OUT/$name.options"
    made=$((made + 1))
done
echo "$made targets in $OUT"
