#!/bin/sh
# rooms.sh FOLDER CC: audit.sh, floors.sh and contracts.sh tested on a small tree which is in order, and broken in one place at a time.
set -u
mkdir -p "$1" && here=$(cd "$1" && pwd) cc=$2 root=$PWD
passed=0 failed=0
tree=$here/tree

lay() {
    rm -rf "$tree"
    mkdir -p "$tree" && cd "$tree" || exit 2
    mkdir -p include/etalon/base include/etalon/spline include/etalon/refine include/etalon/som src/base src/spline src/refine src/som src/cli \
        tests/base tests/spline golden docs fuzz/corpus/real fuzz/corpus/knots proofs
    cat > include/etalon/base/real.h <<'H'
/* real: halves. */
#ifndef ETALON_BASE_REAL_H
#define ETALON_BASE_REAL_H
#ifdef __cplusplus
extern "C" {
#endif
typedef struct {
    double x;                             /* et_real_half( of it */
} et_real;

/* Half of x. */
/*@ assigns \nothing;
    ensures half: \result == x / 2;
*/
double et_real_half(double x);
#ifdef __cplusplus
}
#endif
#endif
H
    cat > include/etalon/spline/knots.h <<'H'
#ifndef ETALON_SPLINE_KNOTS_H
#define ETALON_SPLINE_KNOTS_H
#include "etalon/base/real.h"
/* Nothing.  Golden: none (there is nothing to know). */
/*@ assigns \nothing; */
void et_knots_sort(double *u,
                   int n);
#endif
H
    printf '%s\n' '#ifndef ETALON_SOM_SOM_H' '#define ETALON_SOM_SOM_H' 'typedef int et_som;' '#endif' > include/etalon/som/som.h
    printf '%s\n' '#ifndef ETALON_REFINE_GA_H' '#define ETALON_REFINE_GA_H' 'typedef int et_ga;' '#endif' > include/etalon/refine/ga.h
    printf '%s\n' '#include "etalon/base/real.h"' '#include <float.h>' '/* FLT_EVAL_METHOD == 0 */' 'double et_real_half(double x)' '{' \
        '    return x / 2;     /* no sin( here */' '}' > src/base/real.c
    printf '%s\n' '#include "etalon/spline/knots.h"' 'void et_knots_sort(double *u, int n)' '{' '    (void)u, (void)n;' '}' > src/spline/knots.c
    printf 'verdict prop_real_half(gen *g)\n{\n}\nverdict prop_real_half_twice(gen *g)\n{\n}\n' > tests/base/test_real.c
    printf 'verdict prop_knots_sort(gen *g)\n{\n}\n' > tests/spline/test_knots.c
    printf '# function\nreal_half\texact\tr\t2\t1\n' > golden/real.tsv
    printf '# real\n\n## et_real_half\n' > docs/real.md
    printf '# knots\n\n## et_knots_sort\n' > docs/knots.md
    : > fuzz/corpus/real/real_half.zero
    : > fuzz/corpus/knots/knots_sort.zero
    echo 'VERSION := 0.1.0' > Makefile
    echo '#define ETALON_VERSION "0.1.0"' > src/cli/main.c
    echo '## 0.1.0' > CHANGELOG.md
}
library() {
    for f in src/*/*.c; do $cc -std=c99 -Iinclude -Isrc -c -o "$(basename "$f" .c).o" "$f" || return; done
    rm -f lib.a main.o && ar rc lib.a ./*.o
}
# judged AUDIT|FLOORS WHAT PATTERN COMMAND: the command breaks the tree, the judge says so.
judged() {
    judge=$1 what=$2 pattern=$3
    lay
    eval "$4"
    case $judge in
    audit) library && sh "$root/tests/audit.sh" lib.a > said 2>&1 ;;
    floors) sh "$root/tests/floors.sh" "$cc" > said 2>&1 ;;
    contracts) sh "$root/tests/contracts.sh" include > said 2>&1 ;;
    esac
    code=$?
    if [ -z "$pattern" ]; then [ $code -eq 0 ] && tail -n 1 said | grep -q ' 0 failed$'
    else [ $code -eq 1 ] && grep '^FAIL' said | grep -qE -- "$pattern"; fi
    if [ $? -eq 0 ]; then passed=$((passed + 1)); echo "ok $judge: $what"; else failed=$((failed + 1)); echo "FAIL $judge: $what"; grep '^FAIL' said; fi
}
real=include/etalon/base/real.h
judged audit 'a tree in order' '' :
judged audit 'no declaration' 'et_real_half: not declared' "sed -i '/^double et_real_half/d' $real; sed -i '1i double et_real_half(double x);' src/base/real.c"
judged audit 'no contract' 'et_real_half: no contract' "sed -i '/^\/\*@/,/\*\//d' $real"
judged audit 'a blank between contract and prototype' 'et_real_half: no contract' "sed -i 's/^double et/\n&/' $real"
judged audit 'no comment' 'et_real_half: no comment' "sed -i '/^\/\* Half/d' $real"
judged audit 'no property' 'et_real_half: no property' "sed -i 's/prop_real_half(/prop_real_half_once(/' tests/base/test_real.c"
judged audit 'no section' 'et_real_half: no section' "sed -i '/^##/d' docs/real.md"
judged audit 'no golden rows' 'et_real_half: no rows' ": > golden/real.tsv"
judged audit 'no reason for no rows' 'et_knots_sort: no rows' "sed -i 's/Golden: none/Golden none/' include/etalon/spline/knots.h"
judged audit 'no title' 'module real: no docs' "sed -i 1d docs/real.md"
judged audit 'no corpus' 'module real: no case' 'rm fuzz/corpus/real/*'
judged audit 'no test file' 'module knots: no tests' 'rm tests/spline/test_knots.c'
judged audit 'source in another room' 'every source file.*src/som/real.c' 'mv src/base/real.c src/som/real.c'
judged audit 'an exported name of no module' 'exports.*helper' "echo 'int helper(void) { return 1; }' >> src/base/real.c"
judged audit 'a part of a module' '' \
    "echo 'int real_helper(void) { return 1; }' > src/base/real_part.c; echo 'int real_helper(void);' > src/base/real_parts.h"
judged audit 'a part that is not declared' 'exports.*real_helper' "echo 'int real_helper(void) { return 1; }' > src/base/real_part.c"
judged audit 'exported data' 'exports.*et_real_table' "echo 'int et_real_table = 1;' >> src/base/real.c"
judged audit 'declared, not defined' 'declared function.*et_real_third' "sed -i 's/^double et_real_half.*/&\n\/* A. *\/\n\/*@ assigns \\\\\\\\nothing; *\/\ndouble et_real_third(double x);/' $real"
judged audit 'an orphan heading' 'heading.*et_real_third' "echo '## et_real_third' >> docs/real.md"
judged audit 'an orphan row' 'golden row.*real_third' "printf 'real_third\texact\tr\t2\t1\n' >> golden/real.tsv"
judged audit 'an orphan table' 'golden row.*golden/halves.tsv' 'cp golden/real.tsv golden/halves.tsv'
judged audit 'an orphan case' 'corpus.*real_third.zero' ': > fuzz/corpus/real/real_third.zero'
judged audit 'an orphan folder' 'corpus.*fuzz/corpus/halves' 'mkdir fuzz/corpus/halves'
judged audit 'an orphan test file' 'every test.*test_halves' 'cp tests/base/test_real.c tests/base/test_halves.c'
judged audit 'an orphan property' 'every test.*prop_real_third' "sed -i 's/_half_twice/_third/' tests/base/test_real.c"
judged audit 'an orphan proof' 'every proof.*halves' ': > proofs/halves.v'
judged audit 'two versions' 'one version' "echo '## 0.2.0' > CHANGELOG.md"

judged floors 'a tree in order' '' :
judged floors 'a header from above' 'src/base/real.c: includes include/etalon/spline/knots.h' "sed -i '1i #include \"etalon/spline/knots.h\"' src/base/real.c"
judged floors 'from above by way of another' 'src/base/real.c: includes include/etalon/som/som.h' \
    "printf '%s\n' '#ifndef A_H' '#define A_H' '#include \"etalon/som/som.h\"' '#endif' > src/base/a.h; sed -i '1i #include \"base/a.h\"' src/base/real.c"
judged floors 'rooms of one floor' 'knots.h: includes include/etalon/net' \
    "mkdir include/etalon/net; echo 'typedef int et_net;' > include/etalon/net/net.h; sed -i '3i #include \"etalon/net/net.h\"' include/etalon/spline/knots.h"
judged floors 'refine knows som' 'refine knows som' "sed -i '3i #include \"etalon/som/som.h\"' include/etalon/refine/ga.h"
judged floors 'ga knows more than search' 'not search alone' "sed -i '3i #include \"etalon/spline/knots.h\"' include/etalon/refine/ga.h"
judged floors 'a private header of another room' 'private to its room' ": > src/base/a.h; sed -i '1i #include \"base/a.h\"' src/spline/knots.c"
judged floors 'a room without a floor' 'has no floor' 'mkdir src/attic; : > src/attic/a.c'
judged floors 'a circle' 'no circles' "for p in 'a b' 'b a'; do set -- \$p; printf '#ifndef %s_H\n#define %s_H\n#include \"base/%s.h\"\n#endif\n' \$1 \$1 \$2 > src/base/\$1.h; done"
judged floors 'LAPACKE elsewhere' 'LAPACKE.*src/base/real.c' "echo 'int x; /* a */ int LAPACKE_dgels(void);' >> src/base/real.c"
judged floors 'omp.h' 'omp.h' "echo '#include <omp.h>' >> src/base/real.c"
judged floors 'GSL splines' 'GSL splines' "echo '#include <gsl/gsl_bspline.h>' >> src/base/real.c"
judged floors 'conditional code' 'conditional' "echo '#ifdef FAST' >> src/base/real.c"
judged floors 'a macro with arguments' 'macros' "echo '#define TWICE(x) (2 * (x))' >> src/base/real.c"
judged floors 'printing' 'prints' "echo 'void f(void) { puts(\"\"); }' >> src/base/real.c"
judged floors 'a clock' 'clock' "echo '#include <time.h>' >> src/base/real.c"
judged floors 'a foreign sine' 'transcendental' "echo 'double f(void) { return sin(1); }' >> src/spline/knots.c"
judged floors 'a second C++ file' 'one C\+\+' ': > src/base/a.cpp'
judged floors 'a header that does not stand alone' 'stands alone' "echo 'et_real f(size_t n);' >> $real"
judged floors 'x87' 'evaluated as double' "sed -i '/FLT_EVAL/d' src/base/real.c"

if command -v frama-c > /dev/null; then
    judged contracts 'a tree in order' '' :
    judged contracts 'a name that is not bound' 'base/real.h: .*unbound logic variable y' "sed -i 's|x / 2|y / 2|' $real"
    judged contracts 'a predicate for a term' 'base/real.h: .*not a function' "sed -i 's|^/\*@ assigns|/*@ predicate et_half(real a) = a > 0; */\n&|; s|== x / 2|== et_half(x)|' $real"
    judged contracts 'a bracket too many' 'base/real.h: ' "sed -i 's|x / 2;|x / 2);|' $real"
    judged contracts 'a clause that is none' 'base/real.h: ' "sed -i 's|ensures half|assures half|' $real"
    judged contracts 'broken in a header that is included' 'spline/knots.h: .*unbound' "sed -i 's|x / 2|y / 2|' $real"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
