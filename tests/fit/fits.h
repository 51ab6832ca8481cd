/* fits: the cases of the tests of fits, and their solution a second way: Cox and de Boor's recursion, dense matrices. */
#ifndef TESTS_FIT_FITS_H
#define TESTS_FIT_FITS_H
#include "etalon/base/real.h"
#include "etalon/fit/fit.h"
#include "etalon/fit/seam.h"
#include "gen.h"
#include "golden.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 6, NODES = SIDE * SIDE, CLASSES = 2 * NODES };

/* ---- cases ---- */

typedef struct {
    et_doublenet net;
    size_t nov;
    et_vec3 data[CLASSES];
    et_fit_options options;
} problem;

/* A pillow with steps of sixteenths: sizes 2 .. 6, every approach, method, rule. */
static inline void draw_options(gen *g, problem *c)
{
    et_fit_options *o = &c->options;

    c->net = (et_doublenet){gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)};
    c->nov = et_doublenet_nov(c->net);
    *o = et_fit_defaults();
    o->control = (et_doublenet){gen_between(g, 2, c->net.nx), gen_between(g, 2, c->net.ny)};
    o->p = gen_between(g, 1, o->control.nx > 4 ? 3 : o->control.nx - 1);
    o->q = gen_between(g, 1, o->control.ny > 4 ? 3 : o->control.ny - 1);
    o->approach = (et_fit_approach)gen_upto(g, 2);
    o->method = (et_param_method)gen_upto(g, 3);
    o->knots = (et_knotrule_kind)gen_upto(g, c->net.nx == o->control.nx && c->net.ny == o->control.ny ? 3 : 2);
    o->algebra = (et_linalg_method)gen_upto(g, 2);
    o->corners = (et_fit_corners)gen_upto(g, 2);
}

static inline void draw_pillow(gen *g, problem *c)
{
    const et_doublenet n = c->net;

    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < n.nx; i++)
            for (size_t j = 0; j < n.ny; j++) {
                const double x = 2.0 * (double)i / (double)(n.nx - 1) - 1, y = 2.0 * (double)j / (double)(n.ny - 1) - 1;
                const double z = (w == 0 ? -1 : 1) * (1 - x * x) * (1 - y * y);
                c->data[et_doublenet_class(n, w, i, j) - 1] =
                    (et_vec3){x + (double)gen_upto(g, 3) / 16, y + (double)gen_upto(g, 3) / 16, z + (double)gen_upto(g, 3) / 16};
            }
}

/* All lines but the first and last fall on the second: three parameters in one direction, too few for more than three control points. */
static inline void crowd(problem *c, bool along_u)
{
    const et_doublenet n = c->net;

    for (size_t w = 0; w < 2; w++)
        for (size_t i = along_u ? 2 : 0; i + along_u < n.nx; i++)
            for (size_t j = along_u ? 0 : 2; j + !along_u < n.ny; j++)
                c->data[et_doublenet_class(n, w, i, j) - 1] = c->data[et_doublenet_class(n, w, along_u ? 1 : i, along_u ? j : 1) - 1];
}

static inline void draw_problem(gen *g, problem *c)
{
    const size_t kind = gen_upto(g, 3);

    draw_options(g, c);
    if (kind == 2)
        gen_points(g, &c->data[0].x, c->nov);
    else
        draw_pillow(g, c);
    if (kind == 3)
        crowd(c, gen_upto(g, 1));
}

/* ---- a second way: Cox and de Boor's recursion, dense matrices ---- */

static inline int corner_node(et_doublenet n, size_t i, size_t j)
{
    return (i == 0 || i + 1 == n.nx) && (j == 0 || j + 1 == n.ny);
}
#endif
