#!/bin/sh
# bits.sh BUILD: same seed, same bits.  The command built by two compilers, at four levels of optimisation, with one thread and with two, makes
# the same files; by definition what gcc -O0 with one thread makes is compared with all others.
set -u
build=$1
passed=0 failed=0
for p in debug clang release native; do
    make -s -j"$(nproc 2> /dev/null || echo 1)" P=$p BUILD="$build" "$build/$p/etalon" > /dev/null || {
        echo "FAIL bits: the build $p"
        echo "0 passed, 1 failed"
        exit 1
    }
done
root=$(cd "$build" && pwd)
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT

# make_all ETALON THREADS FOLDER: every seeded thing, small.
make_all() {
    e=$1
    OMP_NUM_THREADS=$2 OPENBLAS_NUM_THREADS=$2
    export OMP_NUM_THREADS OPENBLAS_NUM_THREADS
    mkdir -p "$3" && cd "$3" || return
    for c in cube sphere spindle oiltank; do "$e" generate $c -q -o $c.xyz; done
    "$e" generate sphere --noise 0.01 --outliers 0.05 --seed 7 -q -o noisy.xyz
    "$e" train noisy.xyz --grid 12x9 --seed 5 -q -o net.json
    "$e" train cube.xyz --grid 20x20 --seed 6 --iterations 5000 -q -o other_net.json
    for a in conventional improved joint; do
        for m in uniform chord centripetal exponential; do
            "$e" fit net.json --control 6x5 --approach $a --method $m -q -o $a.$m.json --iges $a.$m.igs
        done
    done
    for a in cholesky svd; do "$e" fit net.json --control 6x5 --algebra $a -q -o $a.json; done
    for a in ga de pso; do
        "$e" refine improved.chord.json --net net.json --with $a --seed 3 --generations 60 -q -o $a.json --history $a.csv --checkpoint $a.state
    done
    "$e" reconstruct noisy.xyz --grid 8x8 --control 6x6 --refine de --generations 20 --seed 2 --no-pictures -q -o all
    rm -f all/summary.json all/report.md     # these tell times
}
( make_all "$root/debug/etalon" 1 "$work/want" ) || exit 1
set -- $(cd "$work/want" && find . -type f | sort)
[ $# -ge 40 ] || { echo "FAIL bits: only $# files were made"; failed=1; }
for run in debug:2 clang:1 clang:2 release:1 release:2 native:1 native:2; do
    ( make_all "$root/${run%:*}/etalon" "${run#*:}" "$work/$run" )
    for f in "$@"; do
        if cmp -s "$work/want/$f" "$work/$run/$f"; then
            passed=$((passed + 1))
            echo "ok bits $run ${f#./}"
        else
            failed=$((failed + 1))
            echo "FAIL bits $run ${f#./}: differs from gcc -O0, one thread"
        fi
    done
    rm -rf "${work:?}/$run"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
