/* exact/exact_nearest: certified distances against those of polygons and planes, which are rational, against points all over, and against themselves
 * after changes that move nothing; the error of a surface against 5000 digits. */
#include "etalon/base/size.h"
#include "etalon/exact/exact.h"
#include "exact/exact_parts.h"
#include "exact/live.h"
#include "exact/nearest.h"
#include "exact/rational.h"
#include "golden.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { DEGREE = 4 };

/* ---- what is common ---- */

/* q = |S - P|^2 for the homogeneous point h. */
static void square_of(fmpq_t q, const fmpq *h, et_vec3 P)
{
    fmpq_t x, y;
    fmpq_init(x);
    fmpq_init(y);
    fmpq_zero(q);
    for (int a = 0; a < 3; a++) {
        fmpq_div(x, h + a, h + 3);
        exact_set(y, coordinate(P, a));
        fmpq_sub(x, x, y);
        fmpq_addmul(q, x, x);
    }
    fmpq_clear(x);
    fmpq_clear(y);
}

/* x^2 <= q. */
static bool square_below(double x, const fmpq_t q)
{
    fmpq_t y;
    fmpq_init(y);
    exact_set(y, x);
    fmpq_mul(y, y, y);
    bool below = fmpq_cmp(y, q) <= 0;
    fmpq_clear(y);
    return below;
}

/* Whether x is the root of q rounded up. */
static bool root_up(double x, const fmpq_t q)
{
    fmpq_t y;
    fmpq_init(y);
    exact_set(y, x);
    fmpq_mul(y, y, y);
    bool ok = fmpq_cmp(y, q) >= 0;
    if (ok && x > 0.0) {
        exact_set(y, nextafter(x, 0.0));
        fmpq_mul(y, y, y);
        ok = fmpq_cmp(y, q) < 0;
    }
    fmpq_clear(y);
    return ok;
}

/* The longest side of the box of n points, from below. */
static double size_of(const et_vec3 *P, size_t n)
{
    double size = 0.0;
    for (int a = 0; a < 3; a++) {
        double lo = coordinate(P[0], a), hi = lo;
        for (size_t i = 1; i < n; i++) {
            lo = fmin(lo, coordinate(P[i], a));
            hi = fmax(hi, coordinate(P[i], a));
        }
        size = fmax(size, hi - lo);
    }
    return size;
}

/* The bounds' promise where parameters cost nothing: by 2^-40, or where nearest points fill a curve by 2^-10. */
static bool close_enough(double distance, double lower, double size, bool curve)
{
    return (1.0 - (curve ? 0x1p-10 : 0x1p-40)) * distance <= lower || (distance <= 0x1.0000001p-40 * size && lower == 0.0);
}

static void curve_at(fmpq *h, const et_curve *c, double x)
{
    fmpq *all = lifted(c->points, c->weights, c->n);
    for (size_t a = 0; a < 4; a++) {
        deboor(h + a, all + a, 4, c->u, c->n + c->p + 1, c->p, x, 0);
    }
    _fmpq_vec_clear(all, (slong)(4 * c->n));
}

static void surface_at(fmpq *h, const et_surface *s, double u, double v)
{
    fmpq *all = lifted(s->points, s->weights, s->nu * s->nv), *line = _fmpq_vec_init((slong)s->nv);
    for (size_t a = 0; a < 4; a++) {
        for (size_t j = 0; j < s->nv; j++) {
            deboor(line + j, all + 4 * j + a, 4 * s->nv, s->u, s->nu + s->p + 1, s->p, u, 0);
        }
        deboor(h + a, line, 1, s->v, s->nv + s->q + 1, s->q, v, 0);
    }
    _fmpq_vec_clear(all, (slong)(4 * s->nu * s->nv));
    _fmpq_vec_clear(line, (slong)s->nv);
}

/* A point near the control points or on the curve (surface), of their scale. */
static et_vec3 draw_point(gen *g, const et_vec3 *P, size_t n, et_vec3 on)
{
    et_vec3 A = P[(size_t)gen_upto(g, n - 1)], B = P[(size_t)gen_upto(g, n - 1)];
    double t = gen_real(g, 0.0, 1.0);
    uint64_t kind = gen_upto(g, 3);
    gen_label(g, kind == 0 ? "a control point" : kind == 1 ? "on it" : "off it");
    if (kind == 0) {
        return A;
    }
    if (kind == 1) {
        return on;
    }
    return (et_vec3){A.x + t * (B.y - A.x), A.y + t * (B.z - A.y), A.z + (kind == 3 ? 100.0 : t) * (B.x - A.z)};
}

/* Whether what is nearer may be between two doubles: at jumps, and where spans are of a few ulps. */
static bool short_spans(const double *u, size_t nu, size_t p)
{
    bool jumps = false;
    for (size_t i = 0; i + 1 < nu; i++) {
        jumps = jumps || (u[i] < u[i + 1] && u[i + 1] - u[i] < 0x1p-20);
    }
    for (size_t i = p + 1; i + p + 1 < nu; i++) {
        jumps = jumps || (u[i] == u[i + p] && u[p] < u[i] && u[i] < u[nu - p - 1]);
    }
    return jumps || p == 0;
}

/* Weights of very different sizes. */
static bool wide(const double *w, size_t n)
{
    double lo = HUGE_VAL, hi = 0.0;
    for (size_t i = 0; w != NULL && i < n; i++) {
        lo = fmin(lo, w[i]);
        hi = fmax(hi, w[i]);
    }
    return hi > 0x1p20 * lo;
}

/* Clamped knots on [0,1], so that neighbouring parameters are close. */
static bool draw_plain(gen *g, et_curve *c)
{
    if (!draw_curve(g, c, DEGREE)) {
        return false;
    }
    gen_knots(g, c->u, c->n + c->p + 1, c->p);
    if (!et_curve_valid(c)) {
        et_curve_free(c);
        return false;
    }
    return true;
}

/* The functions themselves; ET_EINTERNAL: memory is kept. */
static et_status curve_nearest(double *x, double *distance, double *lower, const et_curve *c, et_vec3 P)
{
    live_begin(c->n + c->p);
    et_status status = et_exact_curve_nearest(x, distance, lower, c, P);
    return live_end() ? status : ET_EINTERNAL;
}

static et_status surface_nearest(double x[2], double *distance, double *lower, const et_surface *s, et_vec3 P)
{
    live_begin(s->nu + s->nv + s->q);
    et_status status = et_exact_surface_nearest(x, distance, lower, s, P);
    return live_end() ? status : ET_EINTERNAL;
}

static et_status surface_error(double *sum, double *greatest, const et_surface *s, const double *a, size_t mu, const double *b, size_t mv,
                               const et_vec3 *D)
{
    live_begin(mu + mv);
    et_status status = et_exact_surface_error(sum, greatest, s, a, mu, b, mv, D);
    return live_end() ? status : ET_EINTERNAL;
}

/* ---- curves ---- */

/* One case in 4. */
verdict prop_exact_curve_nearest(gen *g)
{
    et_curve c;
    et_vec3 on;
    if (!draw_plain(g, &c)) {
        return SKIP;
    }
    double x = -7.0, distance = -8.0, lower = -9.0, size = size_of(c.points, c.n);
    bool ok = gen_check(g, et_exact_curve_point(&on, &c, gen_parameter(g, c.u, c.n + c.p + 1, c.p)) == ET_OK, "no point");
    et_vec3 P = draw_point(g, c.points, c.n, on), bad = P;
    fmpq *h = _fmpq_vec_init(4);
    fmpq_t q;
    fmpq_init(q);
    bad.z = gen_upto(g, 1) ? NAN : HUGE_VAL;
    ok = ok && gen_check(g, curve_nearest(&x, &distance, &lower, &c, bad) == ET_EINVAL && x == -7.0 && distance == -8.0 && lower == -9.0,
                         "a point that is not finite");
    ok = ok && gen_check(g, curve_nearest(&x, &distance, &lower, &c, P) == ET_OK, "status");
    ok = ok && gen_check(g, c.u[c.p] <= x && x <= c.u[c.n], "%a is outside the domain", x);
    if (ok) {
        curve_at(h, &c, x);
        square_of(q, h, P);
        ok = gen_check(g, root_up(distance, q), "%a is not the distance at %a", distance, x);
        ok = ok && gen_check(g, 0.0 <= lower && lower <= distance, "bounds %a, %a", lower, distance);
        ok = ok && gen_check(g, close_enough(distance, lower, size, false) || short_spans(c.u, c.n + c.p + 1, c.p) || distance < 0x1p-25 * size,
                             "bounds %a, %a: too far apart", lower, distance);
    }
    for (size_t k = 0; ok && k <= 24; k++) {                /* nothing is nearer than the lower bound */
        double y = k <= c.n + c.p ? c.u[k] : gen_parameter(g, c.u, c.n + c.p + 1, c.p);
        curve_at(h, &c, y);
        square_of(q, h, P);
        ok = gen_check(g, square_below(lower, q), "at %a it is nearer than %a", y, lower);
    }
    c.points[0].x = NAN;
    distance = -8.0;
    ok = ok && gen_check(g, curve_nearest(&x, &distance, &lower, &c, P) == ET_EINVAL && distance == -8.0, "a curve that is not valid");
    fmpq_clear(q);
    _fmpq_vec_clear(h, 4);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* q: the squared distance of P from the segment AB. */
static void segment(fmpq_t q, et_vec3 A, et_vec3 B, et_vec3 P)
{
    fmpq *v = _fmpq_vec_init(9), *t = v + 6, *l = v + 7, *x = v + 8;
    for (int a = 0; a < 3; a++) {
        exact_set(v + a, coordinate(B, a));
        exact_set(x, coordinate(A, a));
        fmpq_sub(v + a, v + a, x);
        exact_set(v + 3 + a, coordinate(P, a));
        fmpq_sub(v + 3 + a, v + 3 + a, x);
        fmpq_addmul(t, v + a, v + 3 + a);
        fmpq_addmul(l, v + a, v + a);
    }
    if (fmpq_sgn(t) <= 0) {
        fmpq_zero(t);
    } else if (fmpq_cmp(t, l) >= 0) {
        fmpq_one(t);
    } else {
        fmpq_div(t, t, l);
    }
    fmpq_zero(q);
    for (int a = 0; a < 3; a++) {
        fmpq_mul(x, t, v + a);
        fmpq_sub(x, v + 3 + a, x);
        fmpq_addmul(q, x, x);
    }
    _fmpq_vec_clear(v, 9);
}

/* A polygon, of degree 1 or of a higher one (its control points on each side at equal distances), with any weights: the least distance is rational.
 */
verdict prop_exact_curve_nearest_polygon(gen *g)
{
    et_curve c;
    et_vec3 V[6];
    size_t p = 1 + (size_t)gen_upto(g, 3), sides = 1 + (size_t)gen_upto(g, 3), n = p * sides + 1;
    double x = 0.0, distance = 0.0, lower = 0.0;
    if (et_curve_new(&c, p, n, gen_upto(g, 1) == 1) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < n + p + 1; i++) {
        c.u[i] = i == 0 ? 0.0 : i == n + p ? (double)sides : (double)((i - 1) / p);
    }
    for (size_t i = 0; i <= sides; i++) {
        V[i] = (et_vec3){12.0 * (double)gen_upto(g, 8), 12.0 * (double)gen_upto(g, 8), 12.0 * (double)gen_upto(g, 2)};
    }
    for (size_t i = 0; i < n; i++) {
        double t = (double)(i % p) / (double)p;
        et_vec3 A = V[i / p], B = V[i / p < sides ? i / p + 1 : sides];
        c.points[i] = (et_vec3){A.x + t * (B.x - A.x), A.y + t * (B.y - A.y), A.z + t * (B.z - A.z)};
        if (c.weights != NULL) {
            c.weights[i] = ldexp(1.0 + (double)gen_upto(g, 6), (int)gen_upto(g, 4));
        }
    }
    et_vec3 P = {(double)gen_upto(g, 96), (double)gen_upto(g, 96), (double)gen_upto(g, 24)};
    double *fine = (size_t)gen_upto(g, 2) + &P.x;           /* one coordinate's digits may be below all others */
    *fine = gen_upto(g, 1) ? ldexp((double)gen_upto(g, 99), -(int)gen_between(g, 1, 80)) : *fine;
    P = gen_chance(g, 4) ? V[0] : P;
    fmpq_t q, least;
    fmpq_init(q);
    fmpq_init(least);
    for (size_t i = 0; i < sides; i++) {
        segment(q, V[i], V[i + 1], P);
        if (i == 0 || fmpq_cmp(q, least) < 0) {
            fmpq_set(least, q);
        }
    }
    bool ok = gen_check(g, curve_nearest(&x, &distance, &lower, &c, P) == ET_OK, "status");
    ok = ok && gen_check(g, square_below(lower, least), "lower bound %a", lower);
    exact_set(q, distance);
    fmpq_mul(q, q, q);
    ok = ok && gen_check(g, fmpq_cmp(least, q) <= 0, "the distance %a is less than the least", distance);
    ok = ok && gen_check(g, close_enough(distance, lower, size_of(c.points, n), false), "%a, %a: too far apart", lower, distance);
    gen_label(g, fmpq_is_zero(least) ? "on it" : "off it");
    fmpq_clear(q);
    fmpq_clear(least);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* A curve that jumps: from the left it comes as near as one likes, but is not there; its other limit is. */
verdict prop_exact_curve_nearest_jump(gen *g)
{
    et_curve c;
    size_t more = (size_t)gen_upto(g, 2), p = 1 + (size_t)gen_upto(g, 1), n = 2 * p + 2 + more;
    double x = 0.0, distance = 0.0, lower = 0.0, height = (double)(1 + gen_upto(g, 8));
    bool right = gen_upto(g, 1) == 1;
    if (et_curve_new(&c, p, n, gen_upto(g, 1) == 1) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < n + p + 1; i++) {
        c.u[i] = i <= p ? 0.0 : i < n ? 1.0 : 2.0;
    }
    for (size_t i = 0; c.weights != NULL && i < n; i++) {   /* it stays on its lines */
        c.weights[i] = (double)gen_between(g, 1, 5);
    }
    for (size_t i = 0; i <= p; i++) {                      /* from (0,0) to (8,0); from (16,0) to (24,0) */
        c.points[i].x = 8.0 * (double)i / (double)p;
        c.points[n - 1 - i].x = 24.0 - c.points[i].x;
    }
    for (size_t i = 0; i < more; i++) {                     /* these are no part of it */
        c.points[p + 1 + i] = (et_vec3){right ? 15.0 : 9.0, height, 0.0};
    }
    et_vec3 P = {right ? 15.0 : 9.0, height, 0.0};
    bool ok = gen_check(g, curve_nearest(&x, &distance, &lower, &c, P) == ET_OK, "status");
    double want = sqrt(1.0 + height * height);
    ok = ok && gen_check(g, fabs(distance - want) <= 0x1p-40 * want && lower <= want * (1.0 + 0x1p-52) && lower >= want * (1.0 - 0x1p-39),
                         "%a, %a for %a", lower, distance, want);
    ok = ok && gen_check(g, right ? x == 1.0 : 1.0 - 0x1p-30 <= x && x < 1.0, "at %a", x);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Parameters far from 0, where doubles are far apart: bounds stay true, and end. */
verdict prop_exact_curve_nearest_coarse(gen *g)
{
    et_curve c;
    size_t p = 2 + (size_t)gen_upto(g, 1), n = p + 1;
    double from = ldexp(1.0, 30 + (int)gen_upto(g, 20)), x = 0.0, distance = 0.0, lower = 0.0;
    if (et_curve_new(&c, p, n, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= p; i++) {
        c.u[i] = from;
        c.u[n + i] = from + 8.0;
        c.points[i] = (et_vec3){(double)(3 * i), (double)(i * i), 0.0};
    }
    et_vec3 P = {gen_real(g, 0.0, 6.0), gen_real(g, 0.0, 4.0), 0x1p-30 * (double)gen_upto(g, 1)};
    if (gen_upto(g, 1)) {
        (void)et_exact_curve_point(&P, &c, from + 1.0);
    }
    bool ok = gen_check(g, curve_nearest(&x, &distance, &lower, &c, P) == ET_OK, "status");
    ok = ok && gen_check(g, 0.0 <= lower && lower <= distance && from <= x && x <= from + 8.0, "%a, %a", lower, distance);
    fmpq *h = _fmpq_vec_init(4);
    fmpq_t q, mine;
    fmpq_init(q);
    fmpq_init(mine);
    curve_at(h, &c, x);
    square_of(mine, h, P);
    for (int k = -1; ok && k <= 1; k += 2) {                /* no neighbour is much nearer */
        curve_at(h, &c, nextafter(x, k * HUGE_VAL));
        square_of(q, h, P);
        ok = gen_check(g, square_below(lower, q), "a neighbour is below the lower bound");
        fmpq_mul_ui(q, q, 1 + (1UL << 20));
        fmpq_div_2exp(q, q, 20);
        ok = ok && gen_check(g, fmpq_cmp(mine, q) <= 0 || distance < 0x1p-38, "a neighbour of %a is nearer", x);
    }
    fmpq_clear(q);
    fmpq_clear(mine);
    _fmpq_vec_clear(h, 4);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Where doubles are as far apart as the knots: what passes through the point between two of them counts for the lower bound, which is 0. */
verdict prop_exact_curve_nearest_between(gen *g)
{
    et_curve c;
    double height = (double)gen_between(g, 1, 9), x = 0.0, distance = 0.0, lower = -1.0;
    if (et_curve_new(&c, 1, 2, gen_upto(g, 1) == 1) != ET_OK) {
        return FAIL;
    }
    c.u[0] = c.u[1] = 0x1p53;
    c.u[2] = c.u[3] = 0x1p53 + 2.0;
    c.points[0] = (et_vec3){-height, 0.0, 0.0};
    c.points[1] = (et_vec3){2.0 * height, height, 0.0};
    et_vec3 P = {2.0 * height, 1.0 - height, 0.0};          /* off the line, or its middle */
    P = gen_upto(g, 1) ? (et_vec3){0.5 * height, 0.5 * height, 0.0} : P;
    double want = fmin(hypot(P.x + height, P.y), hypot(P.x - 2.0 * height, P.y - height));
    bool on = P.x == 0.5 * height, ok = gen_check(g, curve_nearest(&x, &distance, &lower, &c, P) == ET_OK, "status");
    ok =
        ok && gen_check(g, fabs(distance - want) <= 0x1p-50 * want && (on ? lower == 0.0 : lower < distance), "%a, %a for %a", lower, distance, want);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Distances beyond all doubles. */
verdict prop_exact_curve_nearest_overflow(gen *g)
{
    et_curve c;
    double x = -1.0, distance = 0.0, lower = 0.0, sign = gen_upto(g, 1) ? -1.0 : 1.0;
    size_t at = (size_t)gen_upto(g, 2);
    if (et_curve_new(&c, 1, 2, gen_upto(g, 1) == 1) != ET_OK) {
        return FAIL;
    }
    c.u[0] = c.u[1] = 0.0;
    c.u[2] = c.u[3] = 1.0;
    (&c.points[0].x)[at] = (&c.points[1].x)[at] = sign * DBL_MAX;
    (&c.points[1].x)[(at + 1) % 3] = 1.0;
    et_vec3 P = {0.0, 0.0, 0.0};
    (&P.x)[at] = -sign * DBL_MAX;
    bool ok = gen_check(g, curve_nearest(&x, &distance, &lower, &c, P) == ET_OK && distance == HUGE_VAL && lower == DBL_MAX, "%a, %a", lower,
                        distance);
    (&P.x)[at] = nextafter(sign * DBL_MAX, 0.0);
    ok = ok && gen_check(g, curve_nearest(&x, &distance, &lower, &c, P) == ET_OK && distance == 0x1p971 && x == 0.0, "%a at %a", distance, x);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

static void scale_points(et_vec3 *P, size_t n, int k)
{
    for (size_t i = 0; i < n; i++) {
        P[i] = (et_vec3){ldexp(P[i].x, k), ldexp(P[i].y, k), ldexp(P[i].z, k)};
    }
}

/* Points of few digits, far from underflow. */
static void draw_whole(gen *g, et_vec3 *P, size_t n)
{
    for (size_t i = 0; i < 3 * n; i++) {
        (&P[0].x)[i] = (double)gen_upto(g, 64) - 32.0;
    }
}

/* In units 2^k all is as before, to where doubles end; weights 2^k and a clamped domain 2^k change nothing either. */
/* One case in 4. */
verdict prop_exact_curve_nearest_units(gen *g)
{
    et_curve c;
    et_vec3 P;
    double x = 0.0, distance = 0.0, lower = 0.0, y = 0.0, d = 0.0, l = 0.0;
    int k = (int)gen_between(g, 900, 1000) * (gen_upto(g, 1) ? -1 : 1), e = (int)gen_upto(g, 200) - 100, f = (int)gen_upto(g, 1000) - 500;
    if (!draw_plain(g, &c)) {
        return SKIP;
    }
    draw_whole(g, c.points, c.n);
    draw_whole(g, &P, 1);
    for (size_t i = 0; i < c.n + c.p + 1; i++) {
        c.u[i] = round(16.0 * c.u[i]);
    }
    if (!et_curve_valid(&c)) {
        et_curve_free(&c);
        return SKIP;
    }
    bool ok = gen_check(g, curve_nearest(&x, &distance, &lower, &c, P) == ET_OK, "status");
    scale_points(c.points, c.n, k);
    scale_points(&P, 1, k);
    for (size_t i = 0; i < c.n + c.p + 1; i++) {
        c.u[i] = ldexp(c.u[i], f);
    }
    for (size_t i = 0; c.weights != NULL && i < c.n; i++) {
        c.weights[i] = ldexp(c.weights[i], e);
    }
    ok = ok && gen_check(g, curve_nearest(&y, &d, &l, &c, P) == ET_OK, "status in units 2^%d", k);
    ok = ok && gen_check(g, ref_same(y, ldexp(x, f)) && ref_same(d, ldexp(distance, k)) && ref_same(l, ldexp(lower, k)),
                         "at %a, %a, %a; in units 2^%d at %a, %a, %a", x, distance, lower, k, y, d, l);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* ---- surfaces ---- */

/* One case in 20. */
verdict prop_exact_surface_nearest(gen *g)
{
    et_surface s;
    et_vec3 on;
    if (!draw_surface(g, &s, 2)) {
        return SKIP;
    }
    gen_knots(g, s.u, s.nu + s.p + 1, s.p);
    gen_knots(g, s.v, s.nv + s.q + 1, s.q);
    if (!et_surface_valid(&s)) {
        et_surface_free(&s);
        return SKIP;
    }
    double x[2] = {-6.0, -7.0}, distance = -8.0, lower = -9.0, size = size_of(s.points, s.nu * s.nv);
    double u = gen_parameter(g, s.u, s.nu + s.p + 1, s.p), v = gen_parameter(g, s.v, s.nv + s.q + 1, s.q);
    bool ok = gen_check(g, et_exact_surface_point(&on, &s, u, v) == ET_OK, "no point");
    et_vec3 P = draw_point(g, s.points, s.nu * s.nv, on), bad = P;
    fmpq *h = _fmpq_vec_init(4);
    fmpq_t q;
    fmpq_init(q);
    bad.y = gen_upto(g, 1) ? NAN : HUGE_VAL;
    ok = ok && gen_check(g,
                         surface_nearest(x, &distance, &lower, &s, bad) == ET_EINVAL && x[0] == -6.0 && x[1] == -7.0 && distance == -8.0 &&
                             lower == -9.0,
                         "a point that is not finite");
    et_status status = surface_nearest(x, &distance, &lower, &s, P);
    if (ok && status == ET_ENOCONV && wide(s.weights, s.nu * s.nv)) {
        gen_label(g, "undecided");                          /* where a weight outweighs all others a surface is almost a curve */
        ok = gen_check(g, x[0] == -6.0 && x[1] == -7.0 && distance == -8.0 && lower == -9.0, "undecided, but changed");
        fmpq_clear(q);
        _fmpq_vec_clear(h, 4);
        et_surface_free(&s);
        return ok ? PASS : FAIL;
    }
    ok = ok && gen_check(g, status == ET_OK, "status");
    ok = ok && gen_check(g, s.u[s.p] <= x[0] && x[0] <= s.u[s.nu] && s.v[s.q] <= x[1] && x[1] <= s.v[s.nv], "(%a, %a) is outside", x[0], x[1]);
    if (ok) {
        surface_at(h, &s, x[0], x[1]);
        square_of(q, h, P);
        ok = gen_check(g, root_up(distance, q), "%a is not the distance at (%a, %a)", distance, x[0], x[1]);
        ok = ok && gen_check(g, 0.0 <= lower && lower <= distance, "bounds %a, %a", lower, distance);
        ok = ok && gen_check(g,
                             close_enough(distance, lower, size, true) || short_spans(s.u, s.nu + s.p + 1, s.p) ||
                                 short_spans(s.v, s.nv + s.q + 1, s.q) || distance < 0x1p-25 * size,
                             "bounds %a, %a: too far apart", lower, distance);
    }
    for (size_t k = 0; ok && k < 12; k++) {
        u = k < 4 ? (k % 2 ? s.u[s.p] : s.u[s.nu]) : gen_parameter(g, s.u, s.nu + s.p + 1, s.p);
        v = k < 4 ? (k / 2 ? s.v[s.q] : s.v[s.nv]) : gen_parameter(g, s.v, s.nv + s.q + 1, s.q);
        surface_at(h, &s, u, v);
        square_of(q, h, P);
        ok = gen_check(g, square_below(lower, q), "at (%a, %a) it is nearer than %a", u, v, lower);
    }
    s.points[0].x = NAN;
    distance = -8.0;
    ok = ok && gen_check(g, surface_nearest(x, &distance, &lower, &s, P) == ET_EINVAL && distance == -8.0, "a surface that is not valid");
    fmpq_clear(q);
    _fmpq_vec_clear(h, 4);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* A plate [0, a] x [0, b] of any degrees, knots and weights, in the plane or on a cylinder over a polygon: the least distance is rational.  Its
 * direction of straight lines may be u or v. */
/* One case in 2. */
verdict prop_exact_surface_nearest_plate(gen *g)
{
    et_surface s;
    size_t p = 1 + (size_t)gen_upto(g, 1), sides = 1 + (size_t)gen_upto(g, 2), n = p * sides + 1, q = 1 + (size_t)gen_upto(g, 2), m = q + 1;
    et_vec3 V[4];
    double high = 4.0 * (double)gen_between(g, 1, 4), x[2] = {0.0, 0.0}, distance = 0.0, lower = 0.0;
    bool turned = gen_upto(g, 1) == 1, rational = gen_upto(g, 1) == 1;
    if (et_surface_new(&s, turned ? q : p, turned ? p : q, turned ? m : n, turned ? n : m, rational) != ET_OK) {
        return FAIL;
    }
    double *u = turned ? s.v : s.u, *v = turned ? s.u : s.v;
    for (size_t i = 0; i < n + p + 1; i++) {
        u[i] = i == 0 ? 0.0 : i == n + p ? (double)sides : (double)((i - 1) / p);
    }
    for (size_t j = 0; j < m + q + 1; j++) {
        v[j] = j <= q ? 0.0 : 1.0;
    }
    for (size_t i = 0; i <= sides; i++) {
        V[i] = (et_vec3){4.0 * (double)gen_upto(g, 8), 4.0 * (double)gen_upto(g, 8) + (i > 0 ? V[i - 1].y + 4.0 : 0.0), 0.0};
    }
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < m; j++) {
            double t = (double)(i % p) / (double)p;
            et_vec3 A = V[i / p], B = V[i / p < sides ? i / p + 1 : sides];
            size_t at = turned ? j * n + i : i * m + j;
            s.points[at] = (et_vec3){A.x + t * (B.x - A.x), A.y + t * (B.y - A.y), floor(high * (double)j / (double)q)};
            if (rational) {
                s.weights[at] = 1.0 + (double)gen_upto(g, 3);
            }
        }
    }
    et_vec3 P = {(double)gen_upto(g, 32), (double)gen_upto(g, 32), (double)gen_upto(g, 24) - 4.0}, F = P;
    double above = P.z > high ? P.z - high : P.z < 0.0 ? -P.z : 0.0;
    F.z = 0.0;
    fmpq_t d, least, z;
    fmpq_init(d);
    fmpq_init(least);
    fmpq_init(z);
    for (size_t i = 0; i < sides; i++) {
        segment(d, V[i], V[i + 1], F);
        if (i == 0 || fmpq_cmp(d, least) < 0) {
            fmpq_set(least, d);
        }
    }
    exact_set(z, above);
    fmpq_addmul(least, z, z);
    bool ok = gen_check(g, surface_nearest(x, &distance, &lower, &s, P) == ET_OK, "status");
    ok = ok && gen_check(g, square_below(lower, least), "lower bound %a", lower);
    exact_set(d, distance);
    fmpq_mul(d, d, d);
    ok = ok && gen_check(g, fmpq_cmp(least, d) <= 0, "the distance %a is less than the least", distance);
    ok = ok && gen_check(g, close_enough(distance, lower, size_of(s.points, n * m), false), "%a, %a: too far apart", lower, distance);
    fmpq_clear(d);
    fmpq_clear(least);
    fmpq_clear(z);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* A ball's surface of circles (two poles, a seam), weights sqrt(1/2) rounded, so that it is a ball but for some ulps; and all points the same. */
/* One case in 3. */
verdict prop_exact_surface_nearest_ball(gen *g)
{
    static const double cx[9] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, cy[9] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    static const double px[5] = {0, 1, 1, 1, 0}, pz[5] = {-1, -1, 0, 1, 1};
    const double r = sqrt(0.5);
    et_surface s;
    double x[2] = {0.0, 0.0}, distance = 0.0, lower = 0.0, scale = ldexp(1.0, (int)gen_upto(g, 600) - 300);
    bool same = gen_chance(g, 8);
    if (et_surface_new(&s, 2, 2, 9, 5, 1) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < 12; i++) {
        s.u[i] = i < 3 ? 0.0 : (double)((i - 1) / 2) / 4.0;
    }
    for (size_t j = 0; j < 8; j++) {
        s.v[j] = j < 3 ? 0.0 : j < 5 ? 0.5 : 1.0;
    }
    s.u[11] = 1.0;
    for (size_t i = 0; i < 9; i++) {
        for (size_t j = 0; j < 5; j++) {
            s.points[i * 5 + j] = same ? (et_vec3){scale, 0.0, 0.0} : (et_vec3){scale * cx[i] * px[j], scale * cy[i] * px[j], scale * pz[j]};
            s.weights[i * 5 + j] = (i % 2 ? r : 1.0) * (j % 2 ? r : 1.0);
        }
    }
    double a = gen_real(g, 0.0, 2.0), b = gen_real(g, 0.0, 1.0), c = gen_real(g, 0.0, 2.0);
    et_vec3 P = {scale * a * (gen_upto(g, 2) == 2), scale * b * (gen_upto(g, 2) == 2), scale * c};
    double away = same ? et_vec3_distance(P, s.points[0]) : fabs(et_vec3_distance(P, (et_vec3){0.0, 0.0, 0.0}) - scale);
    bool ok = gen_check(g, et_surface_valid(&s), "not valid");
    ok = ok && gen_check(g, surface_nearest(x, &distance, &lower, &s, P) == ET_OK, "status");
    ok = ok && gen_check(g, fabs(distance - away) <= 0x1p-38 * scale && lower <= distance && close_enough(distance, lower, 2.0 * scale, false),
                         "%a, %a for about %a", lower, distance, away);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* A paraboloid: nearest points on its axis, beyond its centre of curvature all around, and a valley: both directions have to be cut. */
/* One case in 5. */
verdict prop_exact_surface_nearest_paraboloid(gen *g)
{
    et_surface s;
    size_t p = 2 + (size_t)gen_upto(g, 1);
    double x[2] = {0.0, 0.0}, distance = 0.0, lower = 0.0, k = (double)(1 + gen_upto(g, 3)), z = (double)gen_upto(g, 16) / 4.0;
    bool ring = gen_chance(g, 40), trough = !ring && (gen_upto(g, 1) == 1 || 2.0 * k * z > 1.0);
    if (et_surface_new(&s, 2, p, 3, p + 1, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < 6; i++) {
        s.u[i] = i < 3 ? -1.0 : 1.0;
    }
    for (size_t j = 0; j < 2 * p + 2; j++) {
        s.v[j] = j <= p ? -1.0 : 1.0;
    }
    static const double square[2][4] = {{1.0, -1.0, 1.0, 0.0}, {3.0, -1.0, -1.0, 3.0}};    /* of v^2 on [-1, 1], by 1 and by 3 */
    for (size_t i = 0; i < 3; i++) {
        for (size_t j = 0; j <= p; j++) {
            double f = p == 2 ? 1.0 : 3.0;
            s.points[i * (p + 1) + j] = (et_vec3){f * ((double)i - 1.0), (double)(2 * j) * (p == 2 ? 0.5 * f : 1.0) - f,
                                                  k * f * square[0][i] + (trough ? 0.0 : k * square[p - 2][j])};
        }
    }
    double f = p == 2 ? 1.0 : 3.0, h = f * z;               /* (f u, f v, k f (u^2 + v^2)) */
    et_vec3 P = {0.0, 0.0, h};
    /* |.|^2 = f^2 (r + (k r - z)^2), r = u^2 + v^2 (or u^2): least where r = (2 k z - 1)/(2 k^2), if that is positive; here r is below 2 (or 1). */
    double rest = (2.0 * k * z - 1.0) / (2.0 * k * k), most = trough ? 1.0 : 2.0, at = rest <= 0.0 ? 0.0 : rest > most ? most : rest;
    double want = f * sqrt(at + (k * at - z) * (k * at - z));
    bool ok = gen_check(g, surface_nearest(x, &distance, &lower, &s, P) == ET_OK, "status");
    gen_label(g, rest <= 0.0 ? "on the axis" : rest > most ? "at the border" : "all around");
    ok = ok && gen_check(g, fabs(distance - want) <= 0x1p-36 * (f + want), "%a for %a", distance, want);
    ok = ok && gen_check(g, lower <= distance && close_enough(distance, lower, size_of(s.points, 3 * (p + 1)), ring), "%a, %a: too far apart", lower,
                         distance);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* In units 2^k all is as before, to where doubles end; weights 2^k and clamped domains 2^k change nothing either. */
/* One case in 20. */
verdict prop_exact_surface_nearest_units(gen *g)
{
    et_surface s;
    et_vec3 P;
    double x[2] = {0.0, 0.0}, distance = 0.0, lower = 0.0, y[2] = {0.0, 0.0}, d = 0.0, l = 0.0;
    int k = (int)gen_between(g, 900, 1000) * (gen_upto(g, 1) ? -1 : 1), e = (int)gen_upto(g, 200) - 100, f = (int)gen_upto(g, 1000) - 500;
    size_t p = 1 + (size_t)gen_upto(g, 1), q = 1 + (size_t)gen_upto(g, 1), nu = p + 1 + (size_t)gen_upto(g, 1), nv = q + 1;
    if (et_surface_new(&s, p, q, nu, nv, gen_upto(g, 1) == 1) != ET_OK) {
        return FAIL;
    }
    draw_whole(g, s.points, nu * nv);
    draw_whole(g, &P, 1);
    for (size_t i = 0; s.weights != NULL && i < nu * nv; i++) {
        s.weights[i] = (double)gen_between(g, 1, 4);
    }
    for (size_t i = 0; i < nu + p + 1; i++) {
        s.u[i] = i <= p ? 0.0 : i >= nu ? 1.0 : 0.5;
    }
    for (size_t j = 0; j < nv + q + 1; j++) {
        s.v[j] = j <= q ? 0.0 : 1.0;
    }
    et_status status = surface_nearest(x, &distance, &lower, &s, P);
    scale_points(s.points, nu * nv, k);
    scale_points(&P, 1, k);
    for (size_t i = 0; i < nu + p + 1; i++) {
        s.u[i] = ldexp(s.u[i], f);
    }
    for (size_t j = 0; j < nv + q + 1; j++) {
        s.v[j] = ldexp(s.v[j], -f);
    }
    for (size_t i = 0; s.weights != NULL && i < nu * nv; i++) {
        s.weights[i] = ldexp(s.weights[i], e);
    }
    bool ok = gen_check(g, surface_nearest(y, &d, &l, &s, P) == status && status == ET_OK, "status %d", (int)status);
    ok = ok && gen_check(g, ref_same(y[0], ldexp(x[0], f)) && ref_same(y[1], ldexp(x[1], -f)) && ref_same(d, ldexp(distance, k)) &&
                                ref_same(l, ldexp(lower, k)), "in units 2^%d at (%a, %a), %a, %a", k, y[0], y[1], d, l);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* ---- the error of a surface ---- */

/* One case in 4. */
verdict prop_exact_surface_error(gen *g)
{
    et_surface s;
    double a[4], b[4], sum = -1.0, greatest = -2.0;
    et_vec3 D[16];
    if (!draw_surface(g, &s, 2)) {
        return SKIP;
    }
    size_t mu = (size_t)gen_upto(g, 4), mv = (size_t)gen_upto(g, 4), n = mu * mv;
    bool on = gen_chance(g, 4);
    for (size_t i = 0; i < 4; i++) {
        a[i] = gen_parameter(g, s.u, s.nu + s.p + 1, s.p);
        b[i] = gen_parameter(g, s.v, s.nv + s.q + 1, s.q);
    }
    gen_points(g, &D->x, 16);
    mpfr_t total, most, x, d;
    mpfr_inits2(SECOND_BITS, total, most, x, d, (mpfr_ptr)0);
    mpfr_set_zero(total, 1);
    mpfr_set_zero(most, 1);
    fmpq *h = _fmpq_vec_init(4);
    fmpq_t q;
    fmpq_init(q);
    bool ok = true;
    for (size_t k = 0; ok && k < n; k++) {
        if (on) {
            ok = gen_check(g, et_exact_surface_point(D + k, &s, a[k / mv], b[k % mv]) == ET_OK, "no point");
        }
        surface_at(h, &s, a[k / mv], b[k % mv]);
        square_of(q, h, D[k]);
        fmpq_get_mpfr(d, q, MPFR_RNDN);
        mpfr_sqrt(d, d, MPFR_RNDN);
        mpfr_add(total, total, d, MPFR_RNDN);
        mpfr_max(most, most, d, MPFR_RNDN);
    }
    ok = ok && gen_check(g, surface_error(&sum, &greatest, &s, a, mu, b, mv, D) == ET_OK, "status");
    double want = mpfr_zero_p(total) ? 0.0 : nearest(total), top = mpfr_zero_p(most) ? 0.0 : nearest(most);
    ok = ok && gen_check(g, ref_same(sum, want) && ref_same(greatest, top), "%zu x %zu: %a and %a, not %a and %a", mu, mv, sum, greatest, want, top);
    sum = -1.0;
    greatest = -2.0;
    a[mu > 0 ? mu - 1 : 0] = NAN;
    ok = ok && gen_check(g, mu == 0 || surface_error(&sum, &greatest, &s, a, mu, b, mv, D) == ET_EINVAL, "a parameter");
    a[mu > 0 ? mu - 1 : 0] = 0.5;
    b[mv > 0 ? mv - 1 : 0] = HUGE_VAL;
    ok = ok && gen_check(g, mv == 0 || surface_error(&sum, &greatest, &s, a, mu, b, mv, D) == ET_EINVAL, "a parameter");
    b[mv > 0 ? mv - 1 : 0] = 0.5;
    D[n > 0 ? n - 1 : 0].z = NAN;
    ok = ok && gen_check(g, n == 0 || surface_error(&sum, &greatest, &s, a, mu, b, mv, D) == ET_EINVAL, "a datum");
    D[n > 0 ? n - 1 : 0].z = 0.0;
    s.points[0].x = NAN;
    ok =
        ok && gen_check(g, surface_error(&sum, &greatest, &s, a, mu, b, mv, D) == ET_EINVAL && sum == -1.0 && greatest == -2.0, "not valid");
    mpfr_clears(total, most, x, d, (mpfr_ptr)0);
    fmpq_clear(q);
    _fmpq_vec_clear(h, 4);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
