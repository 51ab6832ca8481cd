/* lines: requests for the readers of lines to be given, and made more of. */
#ifndef TESTS_CONFORM_LINES_H
#define TESTS_CONFORM_LINES_H
#include "gen.h"
#include <stdlib.h>
#include <string.h>

enum { LINE_MOST = 4096 };

#define LINE_TEXT(s) { s, sizeof s - 1 }
#define LINE_CURVE "2 7 0 0 0 0x1p-1 1 1 1 4 0 0 0 1 2 0 2 2 0x1p-3 3 0 1 "
#define LINE_SURFACE "1 1 5 0 0 0x1p-1 1 1 4 0 0 1 1 6 0 0 0 0 1 0 1 0 1 1 1 1 2 0 0 2 1 0 "

static const sample line_samples[] = {
    LINE_TEXT("span 3 8 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+0 0x1p+0 0x1.8p-1"), LINE_TEXT("multiplicity 4 0x0p+0 0x1p-1 0x1p-1 inf -0x0p+0"),
    LINE_TEXT("greville 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0"), LINE_TEXT("basis 2 6 0 0 0 1 1 1 0x1p-1 right"),
    LINE_TEXT("basis_ders 1 5 0x0p+0 0x0p+0 0x1p-1 0x1p+0 0x1p+0 0x1p-1 left 2"),
    LINE_TEXT("curve_point 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 2 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+0 2 0x1p+0 0x1p-1 0x1p-2 any"),
    LINE_TEXT("curve_point " LINE_CURVE "4 1 0x1p-1 2 1 0x1p-2 left"), LINE_TEXT("curve_ders " LINE_CURVE "0 0x1p-1 any 3"),
    LINE_TEXT("surface_point " LINE_SURFACE "6 1 2 1 1 0x1p-1 1 0x1p-1 0x1p-2 any right"),
    LINE_TEXT("surface_ders 1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0x1p-1074 0 0x1p-1 nan right left 1"),
    LINE_TEXT("surface_normal " LINE_SURFACE "0 0x1p-2 0x1p-1"),
    LINE_TEXT("curve_insert 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 2 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+0 0 0x1p-1 1"),
    LINE_TEXT("curve_remove " LINE_CURVE "0 0x1p-1 1 0x1p-3"), LINE_TEXT("curve_elevate " LINE_CURVE "0 2"),
    LINE_TEXT("surface_insert " LINE_SURFACE "0 v 0x1p-1 1"), LINE_TEXT("surface_elevate " LINE_SURFACE "0 u 1"),
    LINE_TEXT("surface_remove 1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 0 u 0x1p-1 1 0x1p-20"), LINE_TEXT("parameters centripetal 3 0 0 0 1 1 1 4 5 6"),
    LINE_TEXT("parameters_grid chord 2 2 4 0 0 0 0 1 0 1 0 0 1 1 1"), LINE_TEXT("knots averaging 2 4 4 0x0p+0 0x1p-2 0x1p-1 0x1p+0"),
    LINE_TEXT("fit_curve 1 4 0 0 1 1 3 0 0x1p-1 1 3 0 0 0 1 1 1 3 0 0"),
    LINE_TEXT("fit_grid interpolated 1 1 4 0 0 1 1 4 0 0 1 1 2 0 1 2 0 1 4 0 0 0 0 1 0 1 0 0 1 1 1"),
    LINE_TEXT("fit_scattered 1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 1 1 4 0 1 0 1 4 0 0 0 0 1 0 1 0 0 1 1 1"),
    LINE_TEXT("approximate 1 1 2 2 2 2 4 0 0 0 0 1 0 1 0 0 1 1 1"), LINE_TEXT("curve_nearest " LINE_CURVE "0 1 1 1 1"),
    LINE_TEXT("surface_error " LINE_SURFACE "0 1 0x1p-1 1 0x1p-1 1 1 1 1"), LINE_TEXT("net_class 3 4 1 2 2"), LINE_TEXT("net_node 3 4 11"),
    LINE_TEXT("net_counts 9007199254740992 2"), LINE_TEXT("seam_gap " LINE_SURFACE "0 " LINE_SURFACE "0 3"), { NULL, 0 } };

/* A line of the source's own bytes, which ends at a NUL byte. */
static inline char *line_rest(gen *g, size_t most)
{
    static uint8_t bytes[LINE_MOST];
    const size_t n = gen_rest(g, bytes, most < LINE_MOST ? most : LINE_MOST, line_samples);
    char *const line = calloc(n + 1, 1);

    if (line)
        memcpy(line, bytes, n);
    gen_note(g, "%s", line ? line : "");
    return line;
}
#endif
