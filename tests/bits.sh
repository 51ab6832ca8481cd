#!/bin/sh
# bits.sh BUILD [PART...]: same seed, same bits.  Parts, all of them unless named:
#   native              two compilers, four ways of optimising, one thread and two, three BLAS: the files that the command makes, whole runs
#                       (tests/bits/replay.c), and the golden rows of class bits and exact
#   aarch64 s390x i386  runs and rows on other processors, under qemu
#   fault               a build planted with a fault: it must be noticed
# By definition what gcc -O0 makes with one thread is compared with all others.  What is left out is named, and is not counted.
set -u
build=$1
shift
parts=${*:-native aarch64 s390x i386 fault}
passed=0 failed=0
strict='^(bits|exact)$'
jobs=-j$(nproc 2> /dev/null || echo 1)
mkdir -p "$build" && root=$(cd "$build" && pwd) || exit 2
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT

ok() { passed=$((passed + 1)); echo "ok bits $*"; }
fail() { failed=$((failed + 1)); echo "FAIL bits $*"; }
finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
    exit
}

# made PROFILE BORROWED PROGRAM...: build them; what is wrong is told.
made() {
    p=$1 borrow=$2
    shift 2
    for program in "$@"; do set -- "$@" "$root/$p/$program"; shift; done
    make -s "$jobs" P="$p" BORROW="$borrow" BUILD="$root" "$@" > "$work/make.log" 2>&1 && return
    tail -n 5 "$work/make.log"
    return 1
}

# rows FOLDER REGISTRY BITS CLASSES: the golden rows of these classes, module by module, that a build with these checks and a size_t of so many bits
# can have.  Where size_t has 32 bits a count past 2^32 - 1 is none, and no net has more nodes.
rows() {
    mkdir -p "$1"
    sed -n 's/^    { "\(.*\)", gold_.*/\1/p' "$2" > "$1/known"
    for table in golden/*.tsv; do
        awk -F '\t' -v bits="$3" -v classes="$4" -v left="$1/left" -v module="$(basename "$table" .tsv)" '
            function wide(list,  n, i, w) {
                n = split(list, w, " ")
                for (i = 1; i <= n; i++) if (w[i] ~ /^[0-9]+$/ && w[i] > 4294967295) return 1
                return 0
            }
            function nodes(list,  w) { split(list, w, " "); return $1 == "doublenet_valid" ? 2 * w[1] * w[2] : 0 }
            FILENAME != ARGV[2]   { known[$1] = 1; next }
            /^#/ || $2 !~ classes { next }
            !($1 in known)        { unknown++; next }
            bits == 32 && (wide($4) || wide($5) || nodes($4) > 4294967295) { large++; next }
                                  { print }
            END {
                if (unknown) print module ": " unknown " rows of what is left out" >> left
                if (large) print module ": " large " rows of sizes that 32 bits cannot hold" >> left
            }' "$1/known" "$table" > "$1/$(basename "$table")"
    done
    find "$1" -name '*.tsv' -size 0 -delete
}

# golden NAME FOLDER COMMAND...: one line a module.
golden() {
    who=$1 folder=$2
    shift 2
    for table in "$folder"/*.tsv; do
        "$@" --golden "$table" > "$work/out" 2>&1
        module=$(basename "$table" .tsv)
        if [ "$(tail -n 1 "$work/out")" = "$(grep -c . "$table") passed, 0 failed" ]; then
            ok "$who $module $(grep -c . "$table") rows"
        else
            fail "$who $module: $(tail -n 1 "$work/out")"
            grep -v '^ok' "$work/out" | head -n 5
        fi
    done
}

# replayed NAME COMMAND...: one line a run; each must have the hash that it has with gcc -O0.
replayed() {
    who=$1
    shift
    mkdir -p "$work/replay"
    "$@" "$work/replay" > "$work/hashes" 2> "$work/err" || sed 's/^/  /' "$work/err"
    while read -r run hash; do
        if grep -qx "$run $hash" "$work/hashes"; then ok "$who run $run"; else fail "$who run $run: differs from gcc -O0"; fi
    done < "$work/want.hashes"
}

# ---- native -----------------------------------------------------------------------------------------------------------------

# make_all ETALON THREADS FOLDER: every seeded thing, small; the list of what failed is one more file.
make_all() {
    command=$1
    OMP_NUM_THREADS=$2 OPENBLAS_NUM_THREADS=$2
    export OMP_NUM_THREADS OPENBLAS_NUM_THREADS
    mkdir -p "$3" && cd "$3" || return
    e() { "$command" "$@" || echo "$*" >> failures; }
    for c in cube sphere spindle oiltank; do e generate $c -q -o $c.xyz; done
    e generate sphere --noise 0.01 --outliers 0.05 --seed 7 -q -o noisy.xyz
    e train noisy.xyz --grid 12x9 --seed 5 -q -o net.json
    e train cube.xyz --grid 20x20 --seed 6 --iterations 5000 -q -o other_net.json
    for a in conventional improved joint; do
        for m in uniform chord centripetal exponential; do
            e fit net.json --control 6x5 --approach $a --method $m -q -o $a.$m.json --iges $a.$m.igs
        done
    done
    for a in cholesky svd; do e fit net.json --control 6x5 --algebra $a -q -o $a.json; done
    for a in qr cholesky svd; do
        e fit net.json --control 6x5 --algebra $a --refine-solution -q -o refined.$a.json --iges refined.$a.igs
        e fit net.json --control 6x5 --approach joint --algebra $a --refine-solution -q -o refined.joint.$a.json
    done
    e fit net.json --control 6x5 --exact -q -o exact.json
    e refine improved.chord.json --net net.json --with optimum -q -o optimum.json --certificate dual.json --history optimum.csv
    for a in ga de pso; do
        e refine improved.chord.json --net net.json --with $a --seed 3 --generations 60 -q -o $a.json --history $a.csv --checkpoint $a.state
    done
    e reconstruct noisy.xyz --grid 8x8 --control 6x6 --refine de --generations 20 --seed 2 --no-pictures -q -o all
    rm -f all/summary.json all/report.md     # these tell times
}

# compared NAME ETALON THREADS [EXCEPT]: the files that gcc -O0 made, one by one.
compared() {
    ( make_all "$2" "$3" "$work/got" )
    for f in $files; do
        case " ${4:-} " in *" $f "*) continue ;; esac
        if cmp -s "$work/want/$f" "$work/got/$f"; then ok "$1 $f"; else fail "$1 $f: differs from gcc -O0, one thread"; fi
    done
    rm -rf "$work/got"
}

# A build: its files, runs and rows, with one thread and, where there are threads, with two.
native_build() {
    p=$1 name=$2 threads=$3
    made "$p" release etalon check replay || { fail "$name: cannot be built"; return; }
    for t in $threads; do
        compared "$name threads $t" "$root/$p/etalon" "$t"
        OMP_NUM_THREADS=$t replayed "$name threads $t" "$root/$p/replay"
    done
    golden "$name" "$work/rows" "$root/$p/check"
}

# What LAPACK alone computed, dense Cholesky and SVD, is the BLAS's own; refined it is not.
blas() {
    name=$1 path=$2
    LD_LIBRARY_PATH=$path
    export LD_LIBRARY_PATH
    for p in debug native; do
        for l in blas lapack; do
            found=$(ldd "$root/$p/etalon" | sed -n "s/^.*lib$l\.so\.3 => \(.*\)\/lib$l\..*/\1/p")
            case ":$path:" in *":$found:"*) ;; *) fail "$name: lib$l is that of $found"; unset LD_LIBRARY_PATH; return ;; esac
        done
        for t in 1 2; do compared "$name $p threads $t" "$root/$p/etalon" $t 'cholesky.json svd.json'; done
        replayed "$name $p" "$root/$p/replay"
        golden "$name $p" "$work/rows" "$root/$p/check"
    done
    unset LD_LIBRARY_PATH
}

native() {
    rows "$work/rows" "$root/release/registry.c" 64 "$strict"
    ( make_all "$root/debug/etalon" 1 "$work/want" ) || return
    files=$(cd "$work/want" && find . -type f | sort | sed 's/^..//')
    [ "$(echo "$files" | wc -l)" -ge 40 ] || fail "native: only these files were made: $files"
    [ -e "$work/want/failures" ] && fail "native: gcc -O0 fails: $(cat "$work/want/failures")"
    native_build debug        'gcc -O0'                 2
    native_build release      'gcc -O2'                 '1 2'
    native_build gcc-O3       'gcc -O3'                 1
    native_build native       'gcc -O3 -march=native'   '1 2'
    native_build clang-O0     'clang -O0'               1
    native_build clang-O2     'clang -O2'               1
    native_build clang        'clang -O3'               '1 2'
    native_build clang-native 'clang -O3 -march=native' 1
    for a in qr cholesky svd; do
        hash=$(sed -n "s/^refined_$a //p" "$work/want.hashes")
        if grep -qx "refined_qr ${hash:-none}" "$work/want.hashes"; then ok "refined $a is refined qr"; else fail "refined $a is not refined qr"; fi
    done
    libs=/usr/lib/$(gcc -print-multiarch)
    for b in "reference:$libs/blas:$libs/lapack" "openblas:$libs/openblas-pthread" "atlas:$libs/atlas"; do
        if [ -e "${b##*:}/liblapack.so.3" ]; then blas "BLAS ${b%%:*}" "${b#*:}"; else fail "BLAS ${b%%:*}: it is not in ${b##*:}"; fi
    done
}

# ---- other processors ------------------------------------------------------------------------------------------------------------

FOREIGN='libc6-dev libgmp-dev libmpfr-dev libflint-dev libflint-arb-dev liblapacke-dev libjansson-dev libgsl-dev'

# cross PROFILE ARCHITECTURE TRIPLET COMPILER BITS
cross() {
    p=$1 qemu=qemu-$1-static sysroot=$root/sysroot/$1
    for tool in "$4" "$qemu"; do
        command -v "$tool" > /dev/null || { fail "$p: all of it is left out: $tool is not installed"; return; }
    done
    sh tests/bits/sysroot.sh "$2" "$3" "$sysroot" $FOREIGN || { fail "$p: all of it is left out: no libraries of $2"; return; }
    made "$p" '' check replay || { fail "$p: cannot be built"; return; }
    make -s P="$p" BUILD="$root" left-out | sed "s/^/left out bits $p /"
    rows "$work/$p" "$root/$p/registry.c" "$5" "$strict"
    [ -e "$work/$p/left" ] && sed "s/^/left out bits $p /" "$work/$p/left"
    replayed "$p" "$qemu" -L "$sysroot" "$root/$p/replay"
    golden "$p" "$work/$p" "$qemu" -L "$sysroot" "$root/$p/check"
    # The exact layer judges the rows of all classes as it does here.
    rows "$work/$p.all" "$root/$p/registry.c" "$5" .
    "$root/release/check" --truth "$work/$p.all"/*.tsv > "$work/here"
    "$qemu" -L "$sysroot" "$root/$p/check" --truth "$work/$p.all"/*.tsv > "$work/there"
    if cmp -s "$work/here" "$work/there"; then ok "$p exact layer $(cat "$work/$p.all"/*.tsv | grep -c .) rows"
    else fail "$p exact layer: judges rows otherwise than here"; fi
}

# ---- a planted fault ---------------------------------------------------------------------------------------------------------------

fault() {
    made planted release check replay || { fail 'planted: cannot be built'; return; }
    mkdir -p "$work/replay"
    "$root/planted/replay" "$work/replay" > "$work/hashes" 2> /dev/null
    for run in sum som_cube fit_improved surface de; do
        if grep -qx "$(grep "^$run " "$work/want.hashes")" "$work/hashes"; then fail "fault: -ffast-math is not noticed in run $run"
        else ok "fault noticed in run $run"; fi
    done
    for module in basis som; do
        if "$root/planted/check" --golden golden/$module.tsv > /dev/null; then fail "fault: -ffast-math is not noticed in the rows of $module"
        else ok "fault noticed in the rows of $module"; fi
    done
}

# ------------------------------------------------------------------------------------------------------------------------------------

if ! made release '' etalon check || ! made debug release etalon replay; then
    fail 'gcc -O0: cannot be built'
    finish
fi
mkdir -p "$work/replay"
OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 "$root/debug/replay" "$work/replay" > "$work/want.hashes" || fail 'gcc -O0: the runs'
[ "$(grep -c . "$work/want.hashes")" -ge 15 ] || fail "gcc -O0: only these runs were made: $(cat "$work/want.hashes")"
for part in $parts; do
    case $part in
        native)  native ;;
        aarch64) cross aarch64 arm64 aarch64-linux-gnu aarch64-linux-gnu-gcc 64 ;;
        s390x)   cross s390x s390x s390x-linux-gnu s390x-linux-gnu-gcc 64 ;;
        i386)    cross i386 i386 i386-linux-gnu i686-linux-gnu-gcc 32 ;;
        fault)   fault ;;
        *)       fail "$part: no such part" ;;
    esac
done
finish
