/* edits: what the tests of edited curves share: the edited curve against the given one in double-double, within the bounds that the
 * header states, at as many places as determine it. */
#ifndef TESTS_SPLINE_EDITS_H
#define TESTS_SPLINE_EDITS_H
#include "curves.h"
#include "etalon/spline/knots.h"
#include <float.h>
#include <stdint.h>

enum { PLACES = 256 };

static const double speck = 0x1p-700;         /* what underflows is below this */

/* ---- what the edits have in common ---- */

/* The Greville points and both sides of the knots of the domain: they determine a spline. */
typedef struct { double x[PLACES]; et_side side[PLACES]; size_t n; } places;

static inline void add(places *at, double x, et_side side)
{
    if (at->n < PLACES) {
        at->x[at->n] = x;
        at->side[at->n++] = side;
    }
}

static inline places places_of(const et_curve *c)
{
    double greville[PLACES];
    places at = {{0.0}, {ET_SIDE_RIGHT}, 0};
    et_knots_greville(greville, c->n, c->u, c->n + c->p + 1, c->p);
    for (size_t i = 0; i < c->n; i++) {
        add(&at, fmin(fmax(greville[i], c->u[c->p]), c->u[c->n]), ET_SIDE_RIGHT);
    }
    for (size_t i = c->p; i <= c->n; i++) {
        add(&at, c->u[i], ET_SIDE_RIGHT);
        add(&at, c->u[i], ET_SIDE_LEFT);
    }
    return at;
}

/* The edited curve is the given one: a weight of it m roundings off, w times a coordinate m + 1, and the division's. */
static inline bool agree(gen *g, const et_curve *edited, const et_curve *c, double m)
{
    places at = places_of(edited);
    bool ok = true;
    for (size_t k = 0; ok && k < at.n; k++) {
        fine e = fine_point(edited, at.x[k], at.side[k]), f = fine_point(c, at.x[k], at.side[k]);
        for (int a = 0; ok && a < 4; a++) {
            double bound = roundings(a < 3 && c->weights ? m + 2.0 : m) * f.size[a] + 0x1p-90 * f.size[a] + speck;
            ok = gen_check(g, dd_off(e.value[a], f.value[a]) <= bound, "at %a, side %d, coordinate %d is %a for %a, within %a", at.x[k], (int)at.side[k], a,
                           e.value[a].hi, f.value[a].hi, bound);
        }
    }
    return ok;
}

static inline size_t knots(const et_curve *c)
{
    return c->n + c->p + 1;
}

/* Output that nothing has written to. */
static inline et_curve untouched(void)
{
    et_curve c;
    memset(&c, 0x3c, sizeof c);
    return c;
}

static inline bool is_untouched(const et_curve *c)
{
    et_curve t = untouched();
    return memcmp(c, &t, sizeof t) == 0;
}

/* A place to insert at, and how often: up to what is allowed. */
static inline bool draw_site(gen *g, const et_curve *c, double *x, size_t *times)
{
    *x = draw_x(g, c);
    size_t s = et_knots_multiplicity(c->u, knots(c), *x);
    if (s > c->p + 1) {
        return false;
    }
    *times = (size_t)gen_upto(g, c->p + 1 - s);
    gen_note(g, "the knot %a, %zu times there, %zu times more", *x, s, *times);
    gen_label(g, s == 0 ? "new knot" : s + *times == c->p + 1 ? "to multiplicity p + 1" : "knot there");
    return true;
}

/* ---- removal ---- */

static inline double greatest(const et_curve *c)
{
    double most = 0.0;
    for (size_t i = 0; i < c->n; i++) {
        double w = c->weights ? fmax(c->weights[i], 1.0) : 1.0;
        most = fmax(most, w * fmax(1.0, fmax(fabs(c->points[i].x), fmax(fabs(c->points[i].y), fabs(c->points[i].z)))));
    }
    return most;
}
#endif
