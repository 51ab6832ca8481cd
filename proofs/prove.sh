#!/bin/sh
# prove.sh [--quick | --changed] [--accept] BUILD [PIECE...]: everything that is proved, proved again; without PIECE all.
#
#   quote      what Coq's files quote of the C code still stands there
#   tie        the rows by which Tie.v holds the models against the code are those the code gives, bit for bit
#   constants  the bounds in the documentation, in the code's comments and in the proofs are one and the same
#   gappa      the bounds for degree 3
#   coq        the theorems, and on which axioms they rest: golden/proofs/assumptions.txt, rounding_assumptions.txt;
#              of every single one golden/proofs/theorems.txt
#   eva        no run-time error in the ranges of proofs/eva
#   UNIT       a unit of proofs/wp.tsv
#
# --quick: of the last four kinds only those whose text (or whatever it includes) is not the one that golden/proofs/proved.tsv says was proved.
# --changed: only their names.
# --accept: numbers of goals, axioms and texts become golden.  What BUILD holds is not proved again, so that a run that was stopped goes on.
set -u
LC_ALL=C
export LC_ALL
quick= changed= accept=
while :; do
    case ${1-} in
    --quick) quick=yes ;;
    --changed) changed=yes ;;
    --accept) accept=--accept ;;
    *) break ;;
    esac
    shift
done
[ $# -gt 0 ] || { echo 'usage: prove.sh [--quick | --changed] [--accept] BUILD [PIECE...]' >&2; exit 2; }
mkdir -p "$1" && build=$(cd "$1" && pwd) || exit 2
shift
cd "$(dirname "$0")/.." || exit 2
golden=golden/proofs proved=golden/proofs/proved.tsv
passed=0 failed=0
good() { echo "ok $1"; passed=$((passed + 1)); }
bad() { echo "FAIL $1"; failed=$((failed + 1)); }
# A shell's jobs in the background do not hear Ctrl-C.
trap 'trap - INT TERM; kill 0; exit 130' INT TERM

# The files on which a piece depends.
inputs() {
    case $1 in
    gappa) ls proofs/gappa/*.g ;;
    coq) ls proofs/coq/*.v proofs/coq/order ;;
    eva) for room in base spline net som fit; do ls include/etalon/$room/*.h src/$room/*; done; ls proofs/eva.sh proofs/heap.ml proofs/eva/* ;;
    *)
        source=$(sed -n "s/^$1	\([^	]*\).*/\1/p" proofs/wp.tsv)
        gcc -MM -Iinclude -Isrc "$source" | tr -d '\\' | tr ' ' '\n' | grep -E '^(src|include|proofs)/'
        ls proofs/logic/*.h proofs/why3/* proofs/why3.conf proofs/heap.ml proofs/wp.sh
        ;;
    esac
}

key() {
    { grep "^$1	" proofs/wp.tsv; inputs "$1" | sort -u | xargs sha256sum; } | sha256sum | cut -d ' ' -f 1
}

unchanged() {
    grep -qx "$1	$(key "$1")" "$proved" 2> /dev/null
}

# Records the text of a piece that was proved.
record() {
    [ -n "$accept" ] || return 0
    { grep -v "^$1	" "$proved" 2> /dev/null; printf '%s\t%s\n' "$1" "$(key "$1")"; } | sort > "$proved.new" && mv "$proved.new" "$proved"
}

# Golden text: prints what differs.
same() {
    if [ -n "$accept" ]; then
        cp "$2" "$1"
    else
        diff "$1" "$2"
    fi
}

wants() {
    command -v "$1" > /dev/null && return
    bad "$2: $1 is not installed"
    return 1
}

# Of every theorem what it says and, of those of a file together, on which axioms they rest.
theorems() {
    echo 'Set Printing Width 140.'
    for v in $(grep -v Assumptions proofs/coq/order); do echo "From Etalon Require ${v%.v}."; done
    for v in $(grep -v Assumptions proofs/coq/order); do
        names=$(sed -nE "s/^(Theorem|Corollary) ([A-Za-z0-9_']+).*/@${v%.v}.\\2/p" "proofs/coq/$v")
        [ -n "$names" ] || continue
        for name in $names; do echo "Check $name."; done
        echo "Definition theorems_of_${v%.v} := ($(echo "$names" | paste -sd ,)). Print Assumptions theorems_of_${v%.v}."
    done
}

# In the order of proofs/coq/order, each with the text of all before it for its key.
coq() {
    wants coqc coq || return
    mkdir -p "$build/coq"
    chain= right=yes
    for v in $(cat proofs/coq/order); do
        chain=$(printf '%s\n' "$chain" | cat - "proofs/coq/$v" | sha256sum | cut -d ' ' -f 1)
        at=$build/coq/${v%.v}
        if [ "$(cat "$at.key" 2> /dev/null)" != "$chain" ]; then
            cp "proofs/coq/$v" "$at.v"
            rm -f "$at.key"
            if ! (cd "$build/coq" && nice coqc -R . Etalon "$v") > "$at.out" 2> "$at.log"; then
                sed 's/^/  /' "$at.log"
                bad "coq $v"
                return
            fi
            echo "$chain" > "$at.key"
        fi
        good "coq $v"
    done
    theorems > "$build/coq/Theorems.v"
    if ! (cd "$build/coq" && nice coqc -R . Etalon Theorems.v) > "$build/coq/Theorems.out" 2> "$build/coq/Theorems.log"; then
        sed 's/^/  /' "$build/coq/Theorems.log"
        bad 'coq: the theorems are not printed'
        return
    fi
    if grep -lE '^[[:space:]]*(Admitted|Axiom|Parameter|Conjecture)\b|admit\.' proofs/coq/*.v; then
        bad 'coq: something is assumed'
        right=
    fi
    same $golden/assumptions.txt "$build/coq/Assumptions.out" && same $golden/rounding_assumptions.txt "$build/coq/RoundingAssumptions.out" &&
        same $golden/theorems.txt "$build/coq/Theorems.out" || right=
    [ -n "$right" ] && good 'coq: definitions, statements and axioms are the golden ones' && return
    bad 'coq: definitions, statements or axioms are not the golden ones'
}

gappa_all() {
    wants gappa gappa || return
    right=yes
    for g in proofs/gappa/*.g; do
        if (cd proofs/gappa && gappa "${g##*/}") > "$build/gappa.log" 2>&1; then
            good "gappa ${g##*/}"
        else
            sed 's/^/  /' "$build/gappa.log"
            bad "gappa ${g##*/}"
            right=
        fi
    done
    [ -z "$right" ] || record gappa
}

eva() {
    wants frama-c eva || return
    # shellcheck disable=SC2086
    sh proofs/eva.sh $accept "$build/eva" ${EVA-} > "$build/eva.log" 2>&1
    code=$?
    grep -v ' passed, ' "$build/eva.log"
    [ "$code" -eq 0 ] || grep -q '^FAIL' "$build/eva.log" || bad eva
}

# A piece with what it says in a file.
apart() { { "$1"; echo 'to the end'; } > "$build/$1.out" 2>&1; }

# Coq and Eva, at once.
others() {
    for piece; do
        case $piece in coq | eva) ;; *) continue ;; esac
        [ -n "$quick" ] && unchanged "$piece" && continue
        apart "$piece" &
    done
    wait
}

# What such a piece said, when it is done.
said() {
    sed '$d' "$build/$1.out"
    passed=$((passed + $(grep -c '^ok' "$build/$1.out"))) wrong=$(grep -c '^FAIL' "$build/$1.out")
    failed=$((failed + wrong))
    [ "$(tail -n 1 "$build/$1.out")" = 'to the end' ] || { bad "$1: it was stopped"; return; }
    [ "$wrong" -gt 0 ] || record "$1"
}

# The units among the pieces that are to be proved, several at once, since WP itself waits more than it works; each is printed when it is done.
units() {
    for piece; do
        grep -q "^$piece	" proofs/wp.tsv || continue
        rm -f "$build/$piece.proved"
        [ -n "$quick" ] && unchanged "$piece" || echo "$piece"
    done > "$build/units"
    [ -s "$build/units" ] || return 0
    wants frama-c wp && wants cvc4 wp && wants z3 wp || return
    xargs -n 1 -P $((1 + 2 * $(getconf _NPROCESSORS_ONLN))) sh -c '
        if sh proofs/wp.sh $1 "$2/wp" "$3" > "$2/$3.log" 2>&1; then
            touch "$2/$3.proved"
        fi
        grep -v " passed, " "$2/$3.log"' sh "$accept" "$build" < "$build/units"
}

# script PIECE COMMAND...: a piece that is one command, which says itself, last, what it found.
script() {
    piece=$1
    shift
    if "$@" > "$build/$piece.log" 2>&1; then
        good "$piece: $(tail -n 1 "$build/$piece.log")"
    else
        cat "$build/$piece.log"
        bad "$piece"
    fi
}

# What was said of it stands above.
unit() {
    if [ -f "$build/$1.proved" ]; then
        passed=$((passed + 1))
        record "$1"
    else
        failed=$((failed + 1))
    fi
}

mkdir -p $golden
units=$(sed -n 's/^\([a-z][^	]*\)	.*/\1/p' proofs/wp.tsv)
if [ -n "$changed" ]; then
    for piece in gappa coq eva $units; do unchanged "$piece" || echo "$piece"; done
    exit 0
fi
[ $# -gt 0 ] || set -- $units quote tie constants gappa coq eva
others "$@"
units "$@"
for piece; do
    case $piece in
    quote) script quote sh proofs/coq/quote.sh ;;
    tie) script tie python3 proofs/coq/tie.py --check ;;
    constants) script constants python3 proofs/constants.py ;;
    *)
        if [ -n "$quick" ] && unchanged "$piece"; then
            good "$piece: the text that was proved"
            continue
        fi
        case $piece in
        coq | eva) said "$piece" ;;
        gappa) gappa_all ;;
        *) unit "$piece" ;;
        esac
        ;;
    esac
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
