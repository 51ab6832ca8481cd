#!/bin/sh
# faults.sh BUILD ETALON [MOST]: every command with every allocation failing in turn, every call that writes failing in turn, and files that may not grow.
# After each: no crash, a documented exit code and a message, the earlier file as it was (or, where the failure did no harm, the right file), nothing left
# beside it.  With more than MOST (default 120) places in a command, so many are taken at even distances; MOST 0: all.
set -u
build=$(cd "$1" && pwd) etalon=$(cd "$(dirname "$2")" && pwd)/$(basename "$2") most=${3:-120}
here=$(cd "$(dirname "$0")" && pwd)
cc -shared -fPIC -O1 -Wall -Wextra -Werror -o "$build/fail.so" "$here/faults/fail.c" -ldl || { echo "FAIL faults: fail.so cannot be built"; echo "0 passed, 1 failed"; exit 1; }
dir=$(mktemp -d) || exit 2
trap 'rm -rf "$dir"' EXIT
cd "$dir" || exit 2
passed=0 failed=0
OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
export OMP_NUM_THREADS OPENBLAS_NUM_THREADS

under() { env LD_PRELOAD="$build/fail.so" "$@"; }
bad() { why="$why
  $1"; }

# after NAME PLACE CODE...: what one run has left; CODE...: the exit codes it may have had.
after() {
    place=$1
    shift
    case " $* " in *" $code "*) ;; *) bad "$place: exit code $code ($(head -c 200 err))" ;; esac
    [ "$code" -eq 0 ] || [ -s err ] || bad "$place: no message"
    for f in $outputs; do
        if [ "$code" -eq 0 ]; then
            cmp -s "$f" "reference/$f" || bad "$place: exit code 0, but $f is another file"
        else
            # The last thing to fail may be a word to standard output, when the files are in place.
            [ "$(cat "$f" 2> /dev/null)" = old ] || cmp -s "$f" "reference/$f" || bad "$place: $f is neither the old nor the new one"
        fi
    done
    beside=$(ls -A | grep -vxE "$keep")
    [ -z "$beside" ] || { bad "$place: left behind: $beside"; rm -rf $beside; }
}
old() { for f in $outputs; do echo old > "$f"; done; }

# places N: 1 .. N, or $most of them.
places() { awk -v n="$1" -v most="$most" 'BEGIN { if (most == 0 || n <= most) for (k = 1; k <= n; k++) print k; else for (k = 0; k < most; k++) print 1 + int(k * n / most) }'; }

# command NAME 'OUTPUTS' ARGUMENTS...
command() {
    name=$1 outputs=$2 why=
    shift 2
    mkdir -p reference
    keep="reference|err|count|$(ls -A | tr '\n' '|')$(echo $outputs | tr ' ' '|')"
    ET_FAIL_TELL=$dir/count under "$etalon" "$@" > /dev/null 2> err < input || { failed=$((failed + 1)); echo "FAIL faults $name: it does not even run: $(cat err)"; return; }
    for f in $outputs; do cp "$f" reference/; done
    read -r allocations writes < count
    for k in $(places "$allocations"); do
        for lasting in 0 1; do
            old
            ET_FAIL_ALLOC=$k ET_FAIL_LASTING=$lasting under "$etalon" "$@" > /dev/null 2> err < input
            code=$?
            after "allocation $k${lasting#0}" 0 70
        done
    done
    for k in $(places "$writes"); do
        old
        ET_FAIL_WRITE=$k under "$etalon" "$@" > /dev/null 2> err < input
        code=$?
        after "write $k" 0 4
    done
    size=$(cd reference && cat /dev/null $outputs | wc -c)
    for k in $(places $((size / 512)) | head -n 40); do           # at least a block: messages go to a file, too
        old
        (ulimit -f "$k" && exec "$etalon" "$@") > /dev/null 2> err < input
        code=$?
        after "no file above $k blocks" 0 4
    done
    if [ -z "$why" ]; then
        passed=$((passed + 1))
        echo "ok faults $name: $allocations allocations, $writes writes, $size bytes"
    else
        failed=$((failed + 1))
        echo "FAIL faults $name:$why"
    fi
    rm -rf reference
}

echo 0.25 0.75 > uv
printf '0 hello 1\n1 span 2 6 0 0 0 1 1 1 0.5\n2 curve_point 1 4 0 0 1 1 2 0 0 0 1 1 1 0 0.5 any\n' > input
"$etalon" generate sphere -o cloud.xyz --seed 1 > /dev/null 2>&1
head -n 400 cloud.xyz > small.xyz
"$etalon" train small.xyz --grid 6x6 --iterations 2000 -o net.json --quiet && "$etalon" fit net.json --control 5x5 -o surface.json --quiet || exit 2

command generate made.xyz generate cube -o made.xyz
command train trained.json train small.xyz --grid 6x6 --iterations 500 -o trained.json
command train-exact trained.json train small.xyz --grid 4x4 --iterations 100 --exact -o trained.json
for a in conventional improved joint; do command "fit-$a" fitted.json fit net.json --control 5x5 --approach $a -o fitted.json; done
for a in cholesky svd; do command "fit-$a" fitted.json fit net.json --control 5x5 --algebra $a -o fitted.json; done
command fit-bounds 'fitted.json radii.csv' fit net.json --control 5x5 --refine-solution --bounds radii.csv -o fitted.json
command fit-exact fitted.json fit net.json --control 5x5 --exact -o fitted.json
for w in ga de pso; do command "refine-$w" better.json refine surface.json --net net.json --with $w --generations 3 -o better.json; done
command refine-optimum 'better.json dual.json' refine surface.json --net net.json --with optimum --certificate dual.json -o better.json
command evaluate points.csv evaluate surface.json uv --order 2 -o points.csv
command evaluate-exact points.csv evaluate surface.json uv --order 3 --exact -o points.csv
command iges 'better.json better.igs' refine surface.json --net net.json --with de --generations 2 -o better.json --iges better.igs
command serve '' serve
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
