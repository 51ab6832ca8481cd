#!/bin/sh
# floors.sh CC: nobody includes from above.  Read off the compiler's own list of what each file includes (-MM), all the way down.
set -u
LC_ALL=C
export LC_ALL
cc=$1
passed=0 failed=0 why=
lacks() { why="$why; $1"; }
verdict() {
    if [ -z "$why" ]; then passed=$((passed + 1)); echo "ok $1"; else failed=$((failed + 1)); echo "FAIL $1: ${why#; }"; fi
    why=
}
floor() {
    case $1 in
    base) echo 0 ;; spline | net) echo 1 ;; som | fit) echo 2 ;; refine | mesh) echo 3 ;; exact | io) echo 4 ;; conform) echo 5 ;; cli) echo 6 ;; *) echo none ;;
    esac
}
room() {
    r=${1#include/etalon/} r=${r#src/}
    echo "${r%%/*}"
}
# The project's headers that a file includes, directly or not.
includes() {
    case $1 in *.cpp) std='-x c++ -std=c++17' ;; *) std='-x c -std=c99' ;; esac
    $cc $std -Iinclude -Isrc -isystem /usr/include/eigen3 -MM "$1" 2> /dev/null | tr ' \\' '\n\n' | grep -E '^(include|src)/.*\.h$' | grep -vx "$1"
}
# FILE:LINE of the lines that match, comments taken out.
code() {
    awk -v pattern="$1" 'FNR == 1 { inside = 0 }
        { line = $0; if (inside) { if (!sub(/^.*\*\//, "", line)) next; inside = 0 }
          gsub(/\/\*([^*]|\*[^\/])*\*\//, "", line); sub(/\/\/.*/, "", line); if (sub(/\/\*.*/, "", line)) inside = 1 }
        line ~ pattern { print FILENAME ":" FNR }' "$2"
}

for f in include/etalon/*/*.h src/*/*.c src/*/*.cpp src/*/*.h; do
    [ -f "$f" ] || continue
    r=$(room "$f") n=$(floor "$r")
    if [ "$n" = none ]; then lacks "room '$r' has no floor"; verdict "$f"; continue; fi
    seen=$(includes "$f") || { [ -n "$(grep '#include "' "$f")" ] && lacks "its includes cannot be read"; }
    for h in $seen; do
        q=$(room "$h") m=$(floor "$q")
        [ "$q" = "$r" ] || [ "$m" != none ] && [ "$q" = "$r" -o "$m" -lt "$n" ] || lacks "includes $h (floor $m)"
        case $h in src/*) [ "$q" = "$r" ] || lacks "includes $h, private to its room" ;; esac
        [ "$r/$q" != refine/som ] || lacks "refine knows som"
        case $f/$q/$h in
        */refine/ga.[ch]/* | */refine/de.[ch]/* | */refine/pso.[ch]/*)
            case $q/$h in base/* | */refine/search.h | */refine/"$(basename "${f%.*}")".h) ;; *) lacks "includes $h, not search alone" ;; esac ;;
        esac
    done
    verdict "$f"
done

# No circles among headers, nor among the files of a room: each header stands before those that include it.
for h in include/etalon/*/*.h src/*/*.h; do
    [ -f "$h" ] || continue
    for i in $(sed -nE 's/^#include "([^"]+)".*/\1/p' "$h"); do
        [ -f "include/$i" ] && echo "$h include/$i" || echo "$h src/$i"
    done
done | tsort > /dev/null 2>&1 || lacks 'tsort finds one'
verdict 'no circles of headers'

# only WHAT PATTERN ALLOWED FILE...: the pattern occurs in the allowed files and nowhere else.
only() {
    what=$1 pattern=$2 allowed=$3
    shift 3
    for f in "$@"; do
        for a in $allowed; do case $f in $a) continue 2 ;; esac; done
        for line in $(code "$pattern" "$f"); do lacks "$line"; done
    done
    verdict "$what"
}
all=$(ls src/*/*.c src/*/*.cpp src/*/*.h include/etalon/*/*.h 2> /dev/null)
lib=$(echo "$all" | grep -v '^src/cli/')
only 'LAPACKE in linalg_lapack only'        'lapacke[.]h|LAPACKE_|cblas'                             'src/fit/linalg_lapack.c' $all
only 'Ceres in ceres.cpp only'              'ceres/ceres[.]h|ceres::'                                'src/refine/ceres.cpp' $all
only 'jansson in json only'                'jansson[.]h'                                            'src/io/json* src/conform/vectors*' $lib
only 'ball arithmetic in exact and optimum'  '[<"/](arb|acb|fmpq|fmpz|flint)[a-z_]*[.]h'           'src/exact/* src/refine/optimum*' $all
only 'GSL splines in tests only'            'gsl_(bspline|spline|interp)'                           none $all
only 'no omp.h: pragmas may be ignored'     'omp[.]h|omp_get|omp_set'                                none $all
only 'no conditional code'                  '^#[ ]*(if[ (]|elif|else|ifdef +([^_]|_[^_])|ifndef +[A-Z0-9_]*[^H]$)' none $all
only 'no macros that take arguments'        '^#[ ]*define[ ]+[A-Za-z_0-9]+[(]'                       none $all
only 'the library prints nothing'           '(^|[^a-zA-Z_>.])(printf|puts|putchar|perror)[(]|stdout|stderr' 'src/io/*.c' $lib
only 'nobody leaves by another door'        '(^|[^a-zA-Z_])(abort|exit|_Exit|longjmp|setjmp)[(]'     none $lib
only 'no clock, no hidden randomness'       '(^|[^a-zA-Z_])(s?rand|random|time|clock|clock_gettime|gettimeofday)[(]|<time[.]h>' src/conform/peer.c $lib
only 'double only: float in files alone'    '(^|[^a-z_])(long double|float) '                       'src/io/*.c' $lib
only 'own transcendental functions'         '(^|[^a-z_A-Z0-9:.])(exp|log|pow|sin|cos|tan|exp2|log2|log10|expm1|log1p|cbrt|hypot|fma|atan|atan2|acos|asin|tgamma|erf)[(]' none \
    $(echo "$lib" | grep -v 'ceres\.cpp$')
only 'MPFR in real_mpfr.c and with Arb only' 'mpfr[.]h'                                              'src/base/real_mpfr.c' \
    $(echo "$lib" | grep -vE '^src/(exact/|refine/optimum)')
found=$(ls src/*/*.cpp src/*/*.cc src/*/*.cxx 2> /dev/null | grep -vx 'src/refine/ceres.cpp')
[ -z "$found" ] || lacks "$found"
verdict 'one C++ file'
grep -q 'FLT_EVAL_METHOD == 0' src/base/real.c 2> /dev/null || lacks 'src/base/real.c does not assert it'
verdict 'double is evaluated as double'

# Each public header stands alone, in C and in C++.
for h in include/etalon/*/*.h; do
    $cc -std=c99 -pedantic-errors -Wall -Wextra -Wstrict-prototypes -Werror -Iinclude -fsyntax-only -x c "$h" 2> /dev/null || lacks "$h in C"
    $cc -std=c++17 -pedantic-errors -Wall -Wextra -Werror -Iinclude -fsyntax-only -x c++ "$h" 2> /dev/null || lacks "$h in C++"
done
verdict 'every header stands alone, in C and C++'
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
