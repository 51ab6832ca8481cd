#!/bin/sh
. "$(dirname "$0")/kit"
for pair in cube:7352 sphere:7082 spindle:7552 oiltank:5942; do
    kind=${pair%:*} count=${pair#*:}
    want "$kind" 0 "$etalon" generate "$kind" -o "$kind.xyz"
    [ "$(grep -vc '^#' "$kind.xyz")" -eq "$count" ] && pass "$kind has $count points" || fail "$kind has $count points"
done
head -n 5 cube.xyz | awk '{ printf "%.6f %.6f %.6f\n", $1, $2, $3 }' > got
printf '0.000000 0.000000 1.000000\n0.000000 0.000000 0.971430\n0.028580 0.000000 0.971430\n0.028580 0.000000 1.000000\n0.057150 0.000000 0.971430\n' > printed
same "cube begins with the printed rows" got printed
head -n 5 sphere.xyz | awk '{ printf "%.6f %.6f %.6f\n", $1, $2, $3 }' > got
printf '0.500000 1.000000 0.500000\n0.500000 0.999315 0.473830\n0.498630 0.999315 0.473865\n0.497265 0.999315 0.473975\n0.495905 0.999315 0.474155\n' > printed
same "sphere begins with the printed rows" got printed
"$etalon" generate sphere > piped.xyz
same "standard output is the default" piped.xyz sphere.xyz
"$etalon" generate sphere --noise 0.01 --outliers 0.1 --seed 5 -o a.xyz && "$etalon" generate sphere --noise 0.01 --outliers 0.1 --seed 5 -o b.xyz
same "equal seeds, equal noise" a.xyz b.xyz
"$etalon" generate sphere --noise 0.01 --outliers 0.1 --seed 6 -o b.xyz
if cmp -s a.xyz b.xyz; then fail "other seed, other noise"; else pass "other seed, other noise"; fi
want "size" 0 "$etalon" generate sphere --size 9x10 -o small.ply
[ "$("$etalon" generate sphere --size 9x10 | wc -l)" -eq 92 ] && pass "9 rings of 10 points and two poles" || fail "9 rings of 10 points and two poles"
says "unknown cloud" 2 "no cloud 'pear'" "$etalon" generate pear
says "no cloud" 2 "argument is missing" "$etalon" generate
says "unknown option" 2 "unknown option '--sise'" "$etalon" generate cube --sise 3
says "bad number" 2 "--noise wants a finite number" "$etalon" generate cube --noise nan
says "share over one" 2 "outliers must be in" "$etalon" generate cube --outliers 1.5
says "size too small" 2 "size 1x1" "$etalon" generate cube --size 1
says "size beyond memory" 70 "." "$etalon" generate cube --size 99999999999
says "disk full" 4 "cannot write /dev/full" "$etalon" generate cube -o /dev/full
says "no such folder" 4 "nowhere/x.xyz" "$etalon" generate cube -o nowhere/x.xyz
cp cube.xyz earlier.xyz
(ulimit -f 20; "$etalon" generate cube -o cube.xyz > out 2> err); code=$?
[ $code -eq 4 ] && pass "file size limit is an error of writing" || fail "file size limit is an error of writing" "exit code $code"
same "and leaves the earlier file" cube.xyz earlier.xyz
[ -z "$(ls -A | grep 'etalon-.*tmp')" ] && pass "no temporary is left" || fail "no temporary is left" "$(ls -a | tr '\n' ' ')"
{ timeout 20 "$etalon" generate cube --size 300 2> err; echo $? > code; } | head -n 1 > out
[ "$(cat code)" -eq 4 ] && pass "a closed pipe is an error of writing" || fail "a closed pipe is an error of writing" "exit code $(cat code)"
want "help" 0 "$etalon" generate --help
want "version" 0 "$etalon" --version
want "no command" 2 "$etalon"
says "unknown command" 2 "unknown command 'frobnicate'" "$etalon" frobnicate
says "a cube with two sizes" 2 "cube" "$etalon" generate cube --size 2x5
says "no threads" 2 "threads" "$etalon" generate cube --threads 0
want "version to a full disk" 4 sh -c "'$etalon' --version > /dev/full"
cp cube.xyz earlier.xyz
python3 - "$etalon" <<'P' && pass "interrupted at once" || fail "interrupted at once"
import os, signal, subprocess, sys, time
p = subprocess.Popen([sys.argv[1], 'generate', 'cube', '--size', '1200', '-o', 'cube.xyz'], stderr=subprocess.DEVNULL)
time.sleep(0.8); p.send_signal(signal.SIGINT); t = time.time()
raise SystemExit(p.wait() != 130 or time.time() - t > 1)
P
same "and the earlier file stays" cube.xyz earlier.xyz
finish
