/* rational: the exact layer's tests with splines: curves and surfaces drawn, and the second way: de Boor's algorithm in rationals. */
#ifndef TESTS_EXACT_RATIONAL_H
#define TESTS_EXACT_RATIONAL_H
#include "exact/exact_parts.h"
#include "spline/reference.h"
#include "gen.h"
#include <math.h>

static inline double coordinate(et_vec3 P, int a)
{
    return a == 0 ? P.x : a == 1 ? P.y : P.z;
}

static inline bool same_point(et_vec3 a, et_vec3 b)
{
    return ref_same(a.x, b.x) && ref_same(a.y, b.y) && ref_same(a.z, b.z);
}

/* C = a + t (b - a), t = (x - lo)/(hi - lo). */
static inline void between(fmpq_t C, const fmpq_t a, const fmpq_t b, const fmpq_t x, double lo, double hi)
{
    fmpq_t t, d, l;
    fmpq_init(t);
    fmpq_init(d);
    fmpq_init(l);
    exact_set(l, lo);
    exact_set(d, hi);
    fmpq_sub(d, d, l);
    fmpq_sub(t, x, l);
    fmpq_div(t, t, d);
    fmpq_sub(d, b, a);
    fmpq_mul(d, d, t);
    fmpq_add(C, a, d);
    fmpq_clear(t);
    fmpq_clear(d);
    fmpq_clear(l);
}

/* C = m (b - a)/(hi - lo). */
static inline void slope(fmpq_t C, const fmpq_t a, const fmpq_t b, size_t m, double lo, double hi)
{
    fmpq_t d, l;
    fmpq_init(d);
    fmpq_init(l);
    exact_set(l, lo);
    exact_set(d, hi);
    fmpq_sub(d, d, l);
    fmpq_sub(C, b, a);
    fmpq_div(C, C, d);
    fmpq_mul_ui(C, C, (ulong)m);
    fmpq_clear(d);
    fmpq_clear(l);
}

/* The k-th derivative at x of the spline with control values c[0], c[stride], ...: those of its derivative by Eq. 3.8, then de Boor's algorithm. */
static inline void deboor(fmpq_t C, const fmpq *c, size_t stride, const double *u, size_t nu, size_t p, double x, size_t k)
{
    size_t span = ref_span(u, nu, p, x), first = span - p;
    fmpq_t y;
    if (k > p) {
        fmpq_zero(C);
        return;
    }
    fmpq *h = _fmpq_vec_init((slong)(p + 1));
    fmpq_init(y);
    exact_set(y, fmin(fmax(x, u[p]), u[nu - p - 1]));
    for (size_t r = 0; r <= p; r++) {
        fmpq_set(h + r, c + (first + r) * stride);
    }
    for (size_t j = 1; j <= p; j++) {
        for (size_t r = p; r >= j; r--) {
            if (j <= k) {
                slope(h + r, h + r - 1, h + r, p - j + 1, u[first + r], u[span + 1 + r - j]);
            } else {
                between(h + r, h + r - 1, h + r, y, u[first + r], u[span + 1 + r - j]);
            }
        }
    }
    fmpq_set(C, h + p);
    fmpq_clear(y);
    _fmpq_vec_clear(h, (slong)(p + 1));
}

/* w x, w y, w z, w of n control points. */
static inline fmpq *lifted(const et_vec3 *P, const double *weights, size_t n)
{
    fmpq *h = _fmpq_vec_init((slong)(4 * n));
    for (size_t i = 0; i < n; i++) {
        exact_set(h + 4 * i + 3, weights ? weights[i] : 1.0);
        for (int a = 0; a < 3; a++) {
            exact_set(h + 4 * i + (size_t)a, coordinate(P[i], a));
            fmpq_mul(h + 4 * i + (size_t)a, h + 4 * i + (size_t)a, h + 4 * i + 3);
        }
    }
    return h;
}

/* A curve of degree up to `degree`, a third of them rational; now and then weights of all sizes. */
static inline bool draw_curve(gen *g, et_curve *c, size_t degree)
{
    bool rational = gen_upto(g, 2) == 2, wide = gen_chance(g, 4);
    size_t p = (size_t)gen_upto(g, degree), n = p + 1 + (size_t)gen_upto(g, 5);
    if (et_curve_new(c, p, n, rational) != ET_OK) {
        return false;
    }
    gen_points(g, &c->points[0].x, n);
    for (size_t i = 0; rational && i < n; i++) {
        c->weights[i] = wide ? ldexp(gen_real(g, 0.5, 1.0), (int)gen_upto(g, 60) - 30) : gen_real(g, 0.25, 4.0);
    }
    ref_draw_knots(g, c->u, n + p + 1, p);
    gen_note(g, "p = %zu, n = %zu, %s", p, n, rational ? "rational" : "polynomial");
    if (!et_curve_valid(c)) {
        et_curve_free(c);
        return false;
    }
    return true;
}

/* The same of surfaces. */
static inline bool draw_surface(gen *g, et_surface *s, size_t degree)
{
    bool rational = gen_upto(g, 2) == 2, wide = gen_chance(g, 4);
    size_t p = (size_t)gen_upto(g, degree), q = (size_t)gen_upto(g, degree), nu = p + 1 + (size_t)gen_upto(g, 3), nv = q + 1 + (size_t)gen_upto(g, 3);
    if (et_surface_new(s, p, q, nu, nv, rational) != ET_OK) {
        return false;
    }
    gen_points(g, &s->points[0].x, nu * nv);
    for (size_t i = 0; rational && i < nu * nv; i++) {
        s->weights[i] = wide ? ldexp(gen_real(g, 0.5, 1.0), (int)gen_upto(g, 60) - 30) : gen_real(g, 0.25, 4.0);
    }
    ref_draw_knots(g, s->u, nu + p + 1, p);
    ref_draw_knots(g, s->v, nv + q + 1, q);
    gen_note(g, "p = %zu, q = %zu, %zu x %zu, %s", p, q, nu, nv, rational ? "rational" : "polynomial");
    if (!et_surface_valid(s)) {
        et_surface_free(s);
        return false;
    }
    return true;
}
#endif
