/* curves: drawing curves, and their points and derivatives by the definition, for the tests of what curves do. */
#ifndef TESTS_SPLINE_CURVES_H
#define TESTS_SPLINE_CURVES_H
#include "etalon/base/dd.h"
#include "etalon/base/size.h"
#include "etalon/spline/curve.h"
#include "gen.h"
#include "golden.h"
#include "reference.h"
#include <stdlib.h>

enum { DEGREE = 6, ORDER = 8 };

static inline double coordinate(const et_vec3 *p, int a)
{
    return a == 0 ? p->x : a == 1 ? p->y : p->z;
}

static inline bool same_point(et_vec3 a, et_vec3 b)
{
    return ref_same(a.x, b.x) && ref_same(a.y, b.y) && ref_same(a.z, b.z);
}

/* A curve of degree up to DEGREE, a third of them rational.  Clamped on [0,1] unless `free_ends`. */
static inline bool draw(gen *g, et_curve *c, bool free_ends)
{
    bool rational = gen_upto(g, 2) == 2;
    size_t p = gen_upto(g, 1) == 0 ? 3 : (size_t)gen_upto(g, DEGREE), n = p + 1 + (size_t)gen_upto(g, 8);
    if (et_curve_new(c, p, n, rational) != ET_OK) {
        return false;
    }
    gen_points(g, &c->points[0].x, n);
    for (size_t i = 0; rational && i < n; i++) {
        c->weights[i] = gen_real(g, 0.25, 4.0);
    }
    if (free_ends) {
        ref_draw_knots(g, c->u, n + p + 1, p);
    } else {
        gen_knots(g, c->u, n + p + 1, p);
    }
    gen_note(g, "p = %zu, n = %zu, %s", p, n, rational ? "rational" : "polynomial");
    if (!et_curve_valid(c)) {
        et_curve_free(c);
        return false;
    }
    return true;
}

static inline double draw_x(gen *g, const et_curve *c)
{
    return gen_parameter(g, c->u, c->n + c->p + 1, c->p);
}

static inline et_vec3 point(const et_curve *c, double x)
{
    size_t n = et_curve_work(c, 0);
    double *work = et_size_array(n, sizeof(double));
    et_vec3 C = et_curve_point(c, x, work, n);
    free(work);
    return C;
}

static inline void ders(et_vec3 *D, size_t d, const et_curve *c, double x)
{
    size_t n = et_curve_work(c, d);
    double *work = et_size_array(n, sizeof(double));
    et_curve_ders(D, d, c, x, work, n);
    free(work);
}

/* The sums over all control points of a derivative of the basis times w, w x, w y, w z, and of the terms' magnitudes. */
typedef struct { double value[4], size[4]; } sums;

static inline sums brute(const et_curve *c, double x, size_t k)
{
    double N[REF_KNOTS], M[REF_KNOTS];
    sums t = {{0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}};
    ref_derivative(N, M, c->u, c->n + c->p + 1, c->p, x, k);
    for (size_t i = c->n; i-- > 0;) {
        double w = c->weights ? c->weights[i] : 1.0;
        for (int a = 0; a < 4; a++) {
            double h = a == 0 ? w : w * coordinate(&c->points[i], a - 1);
            t.value[a] += N[i] * h;
            t.size[a] += M[i] * fabs(h);
        }
    }
    return t;
}

/* Ours 8p + 5, the brute way's 5p for its basis, 2 and p + 1 more for products and sums, a derivative's factor and the comparison's own k + 3. */
static inline double slack(const et_curve *c)
{
    return (14.0 * (double)c->p + 12.0 + ORDER) * ET_UNIT * (1.0 + 0x1p-40);
}

/* Homogeneous values at x of the span's polynomial, and the sums of the terms' magnitudes, by de Boor's algorithm in double-double: convex combinations, so
 * within 2^-90 of the sizes. */
typedef struct { et_dd value[4]; double size[4]; } fine;

static inline et_dd dd_of(double x)
{
    return (et_dd){x, 0.0};
}

static inline double dd_off(et_dd a, et_dd b)
{
    return fabs(et_dd_sub(a, b).hi);
}

/* (1-u)^-m - 1, not less. */
static inline double roundings(double m)
{
    return m * ET_UNIT * (1.0 + 0x1p-40);
}

static inline fine combine(fine a, et_dd s, fine b, et_dd t)
{
    for (int k = 0; k < 4; k++) {
        a.value[k] = et_dd_add(et_dd_mul(s, a.value[k]), et_dd_mul(t, b.value[k]));
        a.size[k] = s.hi * a.size[k] + t.hi * b.size[k];
    }
    return a;
}

/* h[0..p], the control points of the span's functions, are used up. */
static inline fine fine_deboor(fine *h, const double *u, size_t p, size_t span, double x)
{
    for (size_t j = 1; j <= p; j++) {
        for (size_t r = p; r >= j; r--) {
            double lo = u[span - p + r], hi = u[span + 1 + r - j];
            et_dd width = et_dd_two_sum(hi, -lo);
            h[r] = combine(h[r - 1], et_dd_div(et_dd_two_sum(hi, -x), width), h[r], et_dd_div(et_dd_two_sum(x, -lo), width));
        }
    }
    return h[p];
}

static inline fine fine_lift(et_vec3 P, double w)
{
    fine h;
    for (int a = 0; a < 4; a++) {
        h.value[a] = a == 3 ? dd_of(w) : et_dd_two_product(w, coordinate(&P, a));
        h.size[a] = fabs(h.value[a].hi);
    }
    return h;
}

/* The curve at x of the domain, from that side. */
static inline fine fine_point(const et_curve *c, double x, et_side side)
{
    fine h[64];
    size_t span = et_knots_span_side(c->u, c->n + c->p + 1, c->p, x, side);
    for (size_t r = 0; r <= c->p; r++) {
        size_t i = span - c->p + r;
        h[r] = fine_lift(c->points[i], c->weights ? c->weights[i] : 1.0);
    }
    return fine_deboor(h, c->u, c->p, span, x);
}

static inline bool same_curve(const et_curve *a, const et_curve *b)
{
    return a->p == b->p && a->n == b->n && !a->weights == !b->weights && !memcmp(a->u, b->u, (a->n + a->p + 1) * sizeof *a->u) &&
           !memcmp(a->points, b->points, a->n * sizeof *a->points) && (!a->weights || !memcmp(a->weights, b->weights, a->n * sizeof *a->weights));
}

/* p, n, rational; knots; points; weights if rational.  Returns the place of the next argument, 0 if memory is short. */
static inline size_t read_curve(const row *r, et_curve *c)
{
    size_t at = 3;
    if (et_curve_new(c, row_size(r, 0), row_size(r, 1), (int)row_size(r, 2)) != ET_OK) {
        return 0;
    }
    for (size_t i = 0; i <= c->n + c->p; i++) {
        c->u[i] = row_real(r, at++);
    }
    for (size_t i = 0; i < c->n; i++, at += 3) {
        c->points[i] = (et_vec3){row_real(r, at), row_real(r, at + 1), row_real(r, at + 2)};
    }
    for (size_t i = 0; c->weights && i < c->n; i++) {
        c->weights[i] = row_real(r, at++);
    }
    return at;
}
#endif
