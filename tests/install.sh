#!/bin/sh
# install.sh BUILD: what is installed can be used, and can be removed again.
set -u
mkdir -p "$1/install" || exit 2
to=$(cd "$1/install" && pwd)
rm -rf "$to" "$to.x"
passed=0 failed=0
told() {
    what=$1
    shift
    if "$@" > "$to.said" 2>&1; then
        passed=$((passed + 1)) && echo "ok install: $what"
    else
        failed=$((failed + 1)) && echo "FAIL install: $what" && head -n 5 "$to.said"
    fi
}
told 'make install' make -s BUILD="$1" install DESTDIR="$to" PREFIX=/opt/etalon
cat > "$to.c" <<'C'
#include <etalon/spline/knots.h>
#include <etalon/refine/ceres.h>

int main(void)
{
    const double u[] = {0, 0, 0, 1, 1, 1};

    return et_knots_span(u, 6, 2, 0.5) == 2 && et_ceres_defaults().iterations > 0 ? 0 : 1;
}
C
pc=$to/opt/etalon/lib/pkgconfig/etalon.pc
field() { sed -n "s/^$1: //p" "$pc" | sed "s|\${includedir}|$to/opt/etalon/include|; s|\${libdir}|$to/opt/etalon/lib|"; }
told 'a program is compiled by the flags of etalon.pc' sh -c "gcc -std=c99 $(field Cflags) -o '$to.x' '$to.c' $(field Libs) $(field Libs.private)"
told 'it runs' "$to.x"
told 'the command runs' "$to/opt/etalon/bin/etalon" --version
told 'the manual page is there' test -s "$to/opt/etalon/share/man/man1/etalon.1"
same() { [ "$(cd include && find . -name '*.h' | sort)" = "$(cd "$to/opt/etalon/include" && find . -type f | sort)" ]; }
told 'all headers and nothing else' same
told 'make uninstall' make -s BUILD="$1" uninstall DESTDIR="$to" PREFIX=/opt/etalon
told 'nothing is left' test -z "$(find "$to" -type f)"
told 'a second make does nothing' env MAKEFLAGS= make -q BUILD="$1" all
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
