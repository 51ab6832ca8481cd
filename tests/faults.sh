#!/bin/sh
# faults.sh BUILD ETALON [MOST]: every command with every allocation failing in turn, every call that writes failing in turn, and files that may not grow.
# After each: no crash, a documented exit code and a message, the earlier file as it was (or, where the failure did no harm, the right file), nothing left
# beside it.  A place is a chain of calls in the program: its first allocation or write fails.  With more than MOST (default 120) places in a command, so many
# are taken at even distances; MOST 0: every allocation and every write.  ONLY: a pattern of the names of commands.
set -u
build=$(cd "$1" && pwd) etalon=$(cd "$(dirname "$2")" && pwd)/$(basename "$2") most=${3:-120} lastings=${LASTINGS:-0 1}
here=$(cd "$(dirname "$0")" && pwd)
cc -shared -fPIC -O1 -Wall -Wextra -Werror -o "$build/fail.so" "$here/faults/fail.c" -ldl || { echo "FAIL faults: fail.so cannot be built"; echo "0 passed, 1 failed"; exit 1; }
dir=$(mktemp -d) || exit 2
trap 'rm -rf "$dir"' EXIT
cd "$dir" || exit 2
passed=0 failed=0 codes=
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
    for f in $(case " $codes " in *" $code "*) ;; *) echo "$outputs" ;; esac); do
        if [ "$code" -eq 0 ]; then
            same "$f" || bad "$place: exit code 0, but $f is another file"
        else
            # The last thing to fail may be a word to standard output, when the files are in place.
            [ "$(cat "$f" 2> /dev/null)" = old ] || same "$f" || bad "$place: $f is neither the old nor the new one"
        fi
    done
    beside=$(find . -path ./reference -prune -o ! -type d -print | grep -vxF "$keep")
    [ -z "$beside" ] || { bad "$place: left behind: $beside"; rm -rf $beside; }
}
same() { case "$1" in *.json | *.md) sed "$times" "$1" > now && sed "$times" "reference/$1" | cmp -s now - ;; *) cmp -s "$1" "reference/$1" ;; esac; }
times='s/"[a-z_]*seconds":[^,}]*//g; s/[0-9.]* s CPU//; s/[0-9]*[.][0-9][0-9] |$//'
old() { for f in $outputs; do echo old > "$f"; done; }

# places N [KIND]: of N allocations (a) or writes (w) the first of each place, or $most of these; without KIND 1 .. N, or $most of them.
places() {
    { if [ $# -lt 2 ] || [ "$most" -eq 0 ]; then awk -v n="$1" 'BEGIN { for (k = 1; k <= n; k++) print k }'; else sed -n "s/^$2 //p" count | sort -n; fi; } |
        awk -v most="$most" '{ place[NR] = $1 } END { m = most == 0 || NR <= most ? NR : most; for (k = 0; k < m; k++) print place[1 + int(k * NR / m)] }'
}

# command NAME 'OUTPUTS' ARGUMENTS...; $codes: what it may exit with besides 0 and the fault's own code.
command() {
    case $1 in ${ONLY:-*}) ;; *) return ;; esac
    name=$1 outputs=$2 why=
    shift 2
    mkdir -p reference
    keep=$(printf './%s\n' err count now; find . ! -type d; for f in $outputs; do mkdir -p "reference/$(dirname "$f")" "$(dirname "$f")" && echo "./$f"; done)
    ET_FAIL_TELL=$dir/count under "$etalon" "$@" > /dev/null 2> err < input || { failed=$((failed + 1)); echo "FAIL faults $name: it does not even run: $(cat err)"; return; }
    for f in $outputs; do cp "$f" "reference/$f"; done
    read -r allocations writes reads < count
    for k in $(places "$allocations" a); do
        for lasting in $lastings; do
            old
            ET_FAIL_ALLOC=$k ET_FAIL_LASTING=$lasting under "$etalon" "$@" > /dev/null 2> err < input
            code=$?
            after "allocation $k${lasting#0}" 0 70 $codes
        done
    done
    for k in $(places "$writes" w); do
        old
        ET_FAIL_WRITE=$k under "$etalon" "$@" > /dev/null 2> err < input
        code=$?
        after "write $k" 0 4 $codes
    done
    for k in $(places "$reads" r); do
        old
        ET_FAIL_READ=$k under "$etalon" "$@" > /dev/null 2> err < input
        code=$?
        after "read $k" 4 $codes
    done
    size=$(cd reference && cat /dev/null $outputs | wc -c)
    for k in $(places $((size / 512)) | head -n 40); do           # at least a block: messages go to a file, too
        old
        (ulimit -S -f "$k" && exec "$etalon" "$@") > /dev/null 2> err < input
        code=$?
        after "no file above $k blocks" 0 4 $codes
    done
    if [ -z "$why" ]; then
        passed=$((passed + 1))
        echo "ok faults $name: $allocations allocations, $writes writes, $reads reads, $size bytes"
    else
        failed=$((failed + 1))
        echo "FAIL faults $name:$why"
    fi
    rm -rf reference
}

# interrupted NAME K 'OUTPUTS' ARGUMENTS...: the K-th call that writes takes its time; the first signal asks, the second ends the command at once.
interrupted() {
    case $1 in ${ONLY:-*}) ;; *) return ;; esac
    name=$1 at=$2 outputs=$3 why=
    shift 3
    rm -f slow
    keep=$(printf './%s\n' err count now slow; find . ! -type d; for f in $outputs; do mkdir -p "$(dirname "$f")" && echo "./$f"; done)
    old
    env LD_PRELOAD="$build/fail.so" ET_FAIL_SLOW=$at "$etalon" "$@" > /dev/null 2> err < input & pid=$!
    for k in $(seq 200); do [ -e slow ] && break; sleep 0.05; done
    kill -INT $pid
    sleep 0.6
    kill -TERM $pid
    wait $pid
    code=$?
    [ "$code" -eq 130 ] && grep -q 'nothing was written' err || bad "exit code $code ($(tail -n 1 err))"
    for f in $outputs; do [ "$(cat "$f")" = old ] || bad "$f is another file"; done
    beside=$(find . -path ./reference -prune -o ! -type d -print | grep -vxF "$keep")
    [ -z "$beside" ] || { bad "left behind: $beside"; rm -rf $beside; }
    if [ -z "$why" ]; then
        passed=$((passed + 1))
        echo "ok faults $name: interrupted twice"
    else
        failed=$((failed + 1))
        echo "FAIL faults $name, interrupted twice:$why"
    fi
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
command generate-json made.xyz generate cube --size 5 -o made.xyz --noise 0.01 --json
command train-json trained.json train small.xyz --grid 4x4 --iterations 100 -o trained.json --json
command fit-json fitted.json fit net.json --control 5x5 --exact -o fitted.json --json
for w in ga optimum; do command "refine-$w-json" 'better.json steps.csv' refine surface.json --net net.json --with $w --generations 3 -o better.json --history steps.csv --json; done
command refine-exact better.json refine surface.json --net net.json --with de --generations 3 --exact -o better.json --json
for w in ceres ceres-full; do command "refine-$w" better.json refine surface.json --net net.json --with $w --ceres-iterations 3 -o better.json; done
command checkpoint 'better.json then.state' refine surface.json --net net.json --with pso --generations 3 -o better.json --checkpoint then.state
"$etalon" refine surface.json --net net.json --with pso --generations 3 --checkpoint resume.state -q || exit 2
command resume better.json refine surface.json --net net.json --with pso --generations 3 -o better.json --resume resume.state
command evaluate-json '' evaluate surface.json uv --order 2 --json
made=
for f in cloud.ply fit.json history.csv net.json report.md surface.igs surface.json surface.obj surface.stl summary.json; do made="$made made/$f"; done
command reconstruct "$made" reconstruct small.xyz --grid 6x6 --iterations 500 --control 5x5 --refine de,optimum --generations 2 --no-pictures --json -o made
command compare table.json compare small.xyz --grid 6x6 --iterations 500 --control 5x5 --with de,optimum --runs 1 --generations 2 --format json -o table.json
"$etalon" compare small.xyz --grid 6x6 --iterations 500 --control 5x5 --with de --runs 1 --generations 2 --json > base.json || exit 2
"$etalon" compare small.xyz --grid 6x6 --iterations 500 --control 5x5 --with de,optimum --runs 2 --generations 2 --json --journal runs > /dev/null || exit 2
command journal '' compare small.xyz --grid 6x6 --iterations 500 --control 5x5 --with de,optimum --runs 2 --generations 2 --json --journal runs
cat > gnuplot <<'G'
#!/bin/sh
cat > /dev/null
echo picture
G
chmod +x gnuplot
path=$PATH PATH=$dir:$PATH
pictured=
for f in cloud net surface error convergence; do pictured="$pictured pictured/$f.png"; done
for f in $made; do pictured="$pictured pictured/${f#made/}"; done
command reconstruct-pictures "$pictured" reconstruct small.xyz --grid 6x6 --iterations 500 --control 5x5 --refine de --generations 2 -o pictured
PATH=$path
command standard-output '' generate cube --size 5 -o /dev/stdout
command baseline '' compare small.xyz --grid 6x6 --iterations 500 --control 5x5 --with de --runs 1 --generations 2 --baseline base.json
cat > adapter <<A
#!/bin/sh
unset LD_PRELOAD
exec "$etalon" serve
A
chmod +x adapter
codes=1                                  # what the adapter was not told it has not answered
command conform 'found.xml base' conform --adapter ./adapter --ops span,multiplicity --junit found.xml --baseline-write base --json
cat > ends <<A
#!/bin/sh
echo \$\$ > begun
unset LD_PRELOAD
exec "$etalon" serve
A
chmod +x ends
: > begun
interrupted conform 4 found.xml conform --adapter ./ends --ops span --junit found.xml
sleep 0.2
if [ -s begun ] && ps -o stat= -p "$(cat begun)" | grep -qv '^Z'; then failed=$((failed + 1)); echo "FAIL faults the adapter of an interrupted run is left"; else passed=$((passed + 1)); fi
interrupted reconstruct 200 "$made" reconstruct small.xyz --grid 6x6 --iterations 500 --control 5x5 --refine none --no-pictures -o made
codes=
for f in xyz ply ply-ascii stl obj pcd; do
    python3 "$here/faults/cloud.py" $f small.xyz > "$f.${f%-*}"
    command "train-$f" trained.json train "$f.${f%-*}" --grid 4x4 --iterations 100 -o trained.json
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
