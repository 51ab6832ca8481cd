/* written: curves and surfaces as golden rows write them. */
#ifndef TESTS_EXACT_WRITTEN_H
#define TESTS_EXACT_WRITTEN_H
#include "etalon/spline/curve.h"
#include "etalon/spline/surface.h"
#include "golden.h"

/* Knots, points, weights from argument `at` on; the place of the next. */
static inline size_t read_knots(const row *r, double *u, size_t n, size_t at)
{
    for (size_t i = 0; i < n; i++) {
        u[i] = row_real(r, at++);
    }
    return at;
}

static inline size_t read_points(const row *r, et_vec3 *P, double *weights, size_t n, size_t at)
{
    for (size_t i = 0; i < n; i++, at += 3) {
        P[i] = (et_vec3){row_real(r, at), row_real(r, at + 1), row_real(r, at + 2)};
    }
    for (size_t i = 0; weights && i < n; i++) {
        weights[i] = row_real(r, at++);
    }
    return at;
}

static inline size_t read_curve(const row *r, et_curve *c)
{
    if (et_curve_new(c, row_size(r, 0), row_size(r, 1), (int)row_size(r, 2)) != ET_OK) {
        return 0;
    }
    return read_points(r, c->points, c->weights, c->n, read_knots(r, c->u, c->n + c->p + 1, 3));
}

static inline size_t read_surface(const row *r, et_surface *s)
{
    if (et_surface_new(s, row_size(r, 0), row_size(r, 1), row_size(r, 2), row_size(r, 3), (int)row_size(r, 4)) != ET_OK) {
        return 0;
    }
    size_t at = read_knots(r, s->v, s->nv + s->q + 1, read_knots(r, s->u, s->nu + s->p + 1, 5));
    return read_points(r, s->points, s->weights, s->nu * s->nv, at);
}
#endif
