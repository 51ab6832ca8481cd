#!/bin/sh
# conformance.sh BIN light: Etalon's own adapters, GSL and SISL at level 0; of the others' faults those in tests/adapters/PEER/known.json are no news.
# conformance.sh BIN known: these files written anew.
# conformance.sh BIN scoreboard: every adapter (or those named in ADAPTERS) at level 2 (CASES cases, 10000 if not told), and docs/scoreboard.md written
#     from all reports there are.
set -u
bin=$1 what=$2
etalon=$bin/etalon out=$bin/conformance
seed=1
passed=0 failed=0
mkdir -p "$out"
# Of several pythons the one that has SciPy.
python=python3
for p in /usr/bin/python3 python3; do "$p" -c 'import scipy' 2> /dev/null && { python=$p; break; }; done

adapter() {
    case $1 in
    library) echo "$bin/adapters/etalon" ;;
    serve) echo "$etalon serve" ;;
    exact) echo "$etalon serve --exact" ;;
    command) echo "python3 tests/adapters/cli/adapter.py $etalon" ;;
    scipy | fitpack) echo "$python tests/adapters/scipy/adapter.py $1" ;;
    *) echo "$bin/adapters/$1" ;;
    esac
}
# judge NAME ARGUMENTS...: the report into $out/NAME.json.
judge() {
    name=$1 patience=10
    shift
    [ "$name" = exact ] && patience=60        # a nearest point that takes long is right all the same
    "$etalon" conform --adapter "$(adapter "$name")" --seed $seed --timeout $patience --json "$@" > "$out/$name.json" 2> "$out/$name.err"
}
tell() { python3 -c 'import json, sys
v = json.load(open(sys.argv[1]))["verdicts"]
print(", ".join("%d %s" % (n, k) for k, n in v.items() if n))' "$out/$1.json" 2> /dev/null; }
# check NAME ARGUMENTS...: the exit code must be 0.
check() {
    if judge "$@"; then
        passed=$((passed + 1))
        echo "ok conformance $1: $(tell "$1")"
    else
        failed=$((failed + 1))
        echo "FAIL conformance $1: $(tell "$1") $(head -c 300 "$out/$1.err")"
    fi
}

case $what in
light)
    for a in library serve exact; do check $a --level 0; done
    check command --level 0 --ops surface_point,surface_ders
    for a in gsl sisl; do check $a --level 0 --baseline tests/adapters/$a/known.json; done
    ;;
known)
    for a in gsl sisl; do
        judge $a --level 0 --baseline-write tests/adapters/$a/known.json
        echo "ok conformance $a: $(tell $a), known from now on"
        passed=$((passed + 1))
    done
    ;;
scoreboard)
    for a in ${ADAPTERS:-library serve exact command gsl sisl occt scipy fitpack}; do
        level=2
        [ $a = command ] && level=1               # each of its requests starts a program
        judge $a --level $level --cases "${CASES:-10000}" --vectors golden/conformance
        code=$?
        if [ $code -le 1 ]; then
            passed=$((passed + 1))
            echo "ok conformance $a: $(tell $a)"
        else
            failed=$((failed + 1))
            echo "FAIL conformance $a: exit code $code: $(head -c 300 "$out/$a.err")"
        fi
    done
    python3 tests/scoreboard.py "$out" > "$out/scoreboard.md" && mv "$out/scoreboard.md" docs/scoreboard.md || failed=$((failed + 1))
    ;;
*) echo "conformance.sh BIN light|known|scoreboard" >&2; exit 2 ;;
esac
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
