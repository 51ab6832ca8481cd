/* edited: what the tests of knots inserted and removed, degrees elevated and one-sided derivatives share. */
#ifndef TESTS_EXACT_EDITED_H
#define TESTS_EXACT_EDITED_H
#include "etalon/base/size.h"
#include "etalon/exact/exact.h"
#include "exact/exact_parts.h"
#include "exact/live.h"
#include "exact/nearest.h"
#include "exact/rational.h"
#include "exact/written.h"
#include "golden.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { DEGREE = 4, ORDER = 5 };

/* ---- the functions, memory counted: ET_EINTERNAL if any is kept ---- */

static inline et_status none_kept(et_status status)
{
    return live_end() ? status : ET_EINTERNAL;
}

static inline et_status knots_greville(double *G, size_t n, const double *u, size_t nu, size_t p)
{
    live_begin(n + p);
    return none_kept(et_exact_knots_greville(G, n, u, nu, p));
}

static inline et_status curve_insert(et_curve *r, const et_curve *c, double x, size_t times)
{
    live_begin(times + c->n + 3 * c->p);
    return none_kept(et_exact_curve_insert(r, c, x, times));
}

static inline et_status curve_elevate(et_curve *r, const et_curve *c, size_t times)
{
    live_begin(times + c->n + 3 * c->p);
    return none_kept(et_exact_curve_elevate(r, c, times));
}

static inline et_status curve_remove(et_curve *r, size_t *removed, const et_curve *c, double x, size_t times)
{
    live_begin(times + c->n + 3 * c->p);
    return none_kept(et_exact_curve_remove(r, removed, c, x, times));
}

static inline et_status surface_insert(et_surface *r, const et_surface *s, et_direction along, double x, size_t times)
{
    live_begin(times + s->nu + 3 * s->nv);
    return none_kept(et_exact_surface_insert(r, s, along, x, times));
}

static inline et_status surface_elevate(et_surface *r, const et_surface *s, et_direction along, size_t times)
{
    live_begin(times + s->nu + 3 * s->nv);
    return none_kept(et_exact_surface_elevate(r, s, along, times));
}

static inline et_status surface_remove(et_surface *r, size_t *removed, const et_surface *s, et_direction along, double x, size_t times)
{
    live_begin(times + s->nu + 3 * s->nv);
    return none_kept(et_exact_surface_remove(r, removed, s, along, x, times));
}

static inline size_t knots_of(const et_curve *c)
{
    return c->n + c->p + 1;
}

static inline size_t multiplicity(const double *u, size_t nu, double x)
{
    size_t n = 0;
    for (size_t i = 0; i < nu; i++) {
        n += u[i] == x;
    }
    return n;
}

static inline bool same_reals(const double *a, const double *b, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (!ref_same(a[i], b[i])) {
            return false;
        }
    }
    return true;
}

/* ---- insertion ---- */

/* A knot, or any parameter. */
static inline double draw_place(gen *g, const double *u, size_t nu, size_t p)
{
    return gen_upto(g, 2) == 0 ? u[p + (size_t)gen_upto(g, nu - 2 * p - 1)] : gen_parameter(g, u, nu, p);
}
#endif
