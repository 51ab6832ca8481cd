/* exact/exact_edit: knots inserted (against Boehm's algorithm in rationals) and removed, degrees elevated (against the dual functionals of de Boor
 * and Fix), one-sided derivatives (against those of what is run through backwards), normals, Greville points. */
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

static et_status none_kept(et_status status)
{
    return live_end() ? status : ET_EINTERNAL;
}

static et_status knots_greville(double *G, size_t n, const double *u, size_t nu, size_t p)
{
    live_begin(n + p);
    return none_kept(et_exact_knots_greville(G, n, u, nu, p));
}

static et_status curve_insert(et_curve *r, const et_curve *c, double x, size_t times)
{
    live_begin(times + c->n + 3 * c->p);
    return none_kept(et_exact_curve_insert(r, c, x, times));
}

static et_status curve_elevate(et_curve *r, const et_curve *c, size_t times)
{
    live_begin(times + c->n + 3 * c->p);
    return none_kept(et_exact_curve_elevate(r, c, times));
}

static et_status curve_remove(et_curve *r, size_t *removed, const et_curve *c, double x, size_t times)
{
    live_begin(times + c->n + 3 * c->p);
    return none_kept(et_exact_curve_remove(r, removed, c, x, times));
}

static et_status surface_insert(et_surface *r, const et_surface *s, et_direction along, double x, size_t times)
{
    live_begin(times + s->nu + 3 * s->nv);
    return none_kept(et_exact_surface_insert(r, s, along, x, times));
}

static et_status surface_elevate(et_surface *r, const et_surface *s, et_direction along, size_t times)
{
    live_begin(times + s->nu + 3 * s->nv);
    return none_kept(et_exact_surface_elevate(r, s, along, times));
}

static et_status surface_remove(et_surface *r, size_t *removed, const et_surface *s, et_direction along, double x, size_t times)
{
    live_begin(times + s->nu + 3 * s->nv);
    return none_kept(et_exact_surface_remove(r, removed, s, along, x, times));
}

static size_t knots_of(const et_curve *c)
{
    return c->n + c->p + 1;
}

static size_t multiplicity(const double *u, size_t nu, double x)
{
    size_t n = 0;
    for (size_t i = 0; i < nu; i++) {
        n += u[i] == x;
    }
    return n;
}

static bool same_reals(const double *a, const double *b, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (!ref_same(a[i], b[i])) {
            return false;
        }
    }
    return true;
}

/* Equal but for the signs of zeros. */
static bool equal_points(const et_vec3 *a, const et_vec3 *b, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (!(a[i].x == b[i].x && a[i].y == b[i].y && a[i].z == b[i].z)) {
            return false;
        }
    }
    return true;
}

static bool equal_curves(const et_curve *a, const et_curve *b)
{
    return a->p == b->p && a->n == b->n && same_reals(a->u, b->u, knots_of(a)) && equal_points(a->points, b->points, a->n) &&
           (a->weights == NULL) == (b->weights == NULL) && (a->weights == NULL || same_reals(a->weights, b->weights, a->n));
}

/* Whether the curve's n control points (and weights) are the homogeneous ones of h, rounded. */
static bool is_rounded(gen *g, const et_curve *c, const fmpq *h)
{
    bool ok = true;
    fmpq_t q;
    fmpq_init(q);
    for (size_t i = 0; ok && i < c->n; i++) {
        for (int a = 0; ok && a < 3; a++) {
            fmpq_div(q, h + 4 * i + (size_t)a, h + 4 * i + 3);
            ok = gen_check(g, ref_same(coordinate(c->points[i], a), exact_round(q)), "coordinate %d of control point %zu is %a, not %a", a, i,
                           coordinate(c->points[i], a), exact_round(q));
        }
        ok = ok && (c->weights == NULL || gen_check(g, ref_same(c->weights[i], exact_round(h + 4 * i + 3)), "weight %zu is %a, not %a", i,
                                                    c->weights[i], exact_round(h + 4 * i + 3)));
    }
    fmpq_clear(q);
    return ok;
}

/* Boehm's algorithm: the knot x once more; n + 1 points of 4 numbers in place of n, and the knots u. */
static fmpq *boehm(fmpq *h, double *u, size_t n, size_t p, double x)
{
    size_t nu = n + p + 1, upto = 0, times = multiplicity(u, nu, x);
    fmpq *q = _fmpq_vec_init((slong)(4 * (n + 1)));
    fmpq_t at;
    fmpq_init(at);
    exact_set(at, x);
    while (upto < nu && u[upto] <= x) {
        upto++;
    }
    for (size_t i = 0; i <= n; i++) {
        for (size_t a = 0; a < 4; a++) {
            if (i + p < upto) {
                fmpq_set(q + 4 * i + a, h + 4 * i + a);
            } else if (i >= upto - times) {
                fmpq_set(q + 4 * i + a, h + 4 * (i - 1) + a);
            } else {
                between(q + 4 * i + a, h + 4 * (i - 1) + a, h + 4 * i + a, at, u[i], u[i + p]);
            }
        }
    }
    memmove(u + upto + 1, u + upto, (nu - upto) * sizeof *u);
    u[upto] = x;
    fmpq_clear(at);
    _fmpq_vec_clear(h, (slong)(4 * n));
    return q;
}

/* ---- Greville points ---- */

verdict prop_exact_knots_greville(gen *g)
{
    double u[REF_KNOTS], G[REF_KNOTS];
    size_t p = (size_t)gen_upto(g, DEGREE + 2), nu = 2 * p + 2 + (size_t)gen_upto(g, 8), n = nu - p - 1;
    mpfr_t sum;
    ref_draw_knots(g, u, nu, p);
    if (gen_chance(g, 5)) {                                 /* neighbours: the middle of two is a tie */
        gen_label(g, "neighbours");
        u[0] = gen_upto(g, 1) ? 1.0 : 0x1.fffffffffffffp0;
        for (size_t i = 1; i < nu; i++) {
            u[i] = gen_upto(g, 1) ? u[i - 1] : nextafter(u[i - 1], HUGE_VAL);
        }
    }
    if (!et_knots_valid(u, nu, p)) {
        return SKIP;
    }
    G[0] = G[n] = 4711.0;
    bool ok = gen_check(g, knots_greville(G, n + 1, u, nu, p) == ET_EINVAL && knots_greville(G, n - 1, u, nu, p) == ET_EINVAL &&
                               knots_greville(G, n, u, 2 * p + 1, p) == ET_EINVAL && G[0] == 4711.0,
                        "another number of points, too few knots");
    ok = ok && gen_check(g, knots_greville(G, n, u, nu, p) == ET_OK && G[n] == 4711.0, "status, or wrote beyond");
    mpfr_init2(sum, SECOND_BITS);
    for (size_t i = 0; ok && i < n; i++) {
        mpfr_set_d(sum, u[i + (p > 0 ? 1 : 0)], MPFR_RNDN);
        for (size_t j = 2; j <= (p > 0 ? p : 2); j++) {
            mpfr_add_d(sum, sum, u[i + j - (p > 0 ? 0 : 1)], MPFR_RNDN);
        }
        mpfr_div_ui(sum, sum, p > 0 ? (unsigned long)p : 2, MPFR_RNDN);
        double want = mpfr_zero_p(sum) ? 0.0 : nearest(sum);
        ok = gen_check(g, ref_same(G[i], want), "p = %zu: point %zu is %a, not %a", p, i, G[i], want);
        ok = ok && gen_check(g, u[i] <= G[i] && G[i] <= u[i + p + 1], "point %zu, %a, is outside", i, G[i]);
    }
    u[1] = NAN;
    double before = G[0];
    ok = ok && gen_check(g, knots_greville(G, n, u, nu, p) == ET_EINVAL && ref_same(G[0], before), "knots that are not valid");
    mpfr_clear(sum);
    return ok ? PASS : FAIL;
}

/* ---- one-sided derivatives ---- */

static et_side draw_side(gen *g)
{
    return gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
}

static et_side other(et_side side)
{
    return side == ET_SIDE_LEFT ? ET_SIDE_RIGHT : ET_SIDE_LEFT;
}

/* One of the knots, a third of them repeated p + 1 times. */
static double draw_knot(gen *g, double *u, size_t nu, size_t p)
{
    size_t from = (size_t)gen_upto(g, nu - 1);
    if (gen_chance(g, 3)) {
        gen_label(g, "run of knots");
        for (size_t i = from; i + 1 < nu && i <= from + p && u[from] < u[nu - 1]; i++) {
            u[i] = u[from];
        }
    }
    return u[from];
}

static void reverse_knots(double *u, size_t nu)
{
    for (size_t i = 0; i < (nu + 1) / 2; i++) {
        double x = u[i];
        u[i] = -u[nu - 1 - i];
        u[nu - 1 - i] = -x;
    }
}

/* What is run through backwards: points k of n lines of `step` each change places. */
static void reverse_points(et_vec3 *P, double *w, size_t n, size_t step)
{
    for (size_t i = 0; i < n / 2; i++) {
        for (size_t k = 0; k < step; k++) {
            size_t a = i * step + k, b = (n - 1 - i) * step + k;
            et_vec3 Q = P[a];
            double v = w == NULL ? 0.0 : w[a];
            P[a] = P[b];
            P[b] = Q;
            if (w != NULL) {
                w[a] = w[b];
                w[b] = v;
            }
        }
    }
}

static bool equal_signed(et_vec3 a, et_vec3 b, bool minus)
{
    double s = minus ? -1.0 : 1.0;
    return a.x == s * b.x && a.y == s * b.y && a.z == s * b.z;
}

verdict prop_exact_curve_ders_side(gen *g)
{
    et_curve c;
    et_vec3 D[ORDER + 2], E[ORDER + 1];
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = draw_knot(g, c.u, knots_of(&c), c.p);
    x = gen_chance(g, 4) ? gen_parameter(g, c.u, knots_of(&c), c.p) : x;
    size_t d = (size_t)gen_upto(g, ORDER);
    et_side side = draw_side(g);
    if (!et_curve_valid(&c)) {
        et_curve_free(&c);
        return SKIP;
    }
    D[0] = D[d + 1] = (et_vec3){1.0, 2.0, 3.0};
    bool ok = gen_check(g, et_exact_curve_ders_side(D, d, &c, NAN, side) == ET_EINVAL && D[0].y == 2.0, "a parameter that is no number");
    ok = ok && gen_check(g, et_exact_curve_ders_side(D, SIZE_MAX, &c, x, side) == ET_ENOMEM && D[0].y == 2.0, "an order beyond all sizes");
    live_begin(d + c.n + 3 * c.p);
    et_status status = et_exact_curve_ders_side(D, d, &c, x, side);
    ok = gen_check(g, live_end(), "memory is kept") && ok && gen_check(g, status == ET_OK && D[d + 1].z == 3.0, "status, or wrote beyond");
    ok = ok && gen_check(g, et_exact_curve_ders(E, d, &c, x) == ET_OK, "no derivatives");
    for (size_t k = 0; ok && k <= d && side == ET_SIDE_RIGHT; k++) {
        ok = gen_check(g, same_point(D[k], E[k]), "derivative %zu from the right is another one", k);
    }
    reverse_knots(c.u, knots_of(&c));
    reverse_points(c.points, c.weights, c.n, 1);
    ok = ok && gen_check(g, et_exact_curve_ders_side(E, d, &c, -x, other(side)) == ET_OK, "not the other way round");
    for (size_t k = 0; ok && k <= d; k++) {
        ok = gen_check(g, equal_signed(D[k], E[k], k % 2 == 1), "derivative %zu: %a, the other way round %a", k, D[k].x, E[k].x);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Two constants, or two straight lines, that meet at a knot or jump there: both limits by hand, and none but them. */
verdict prop_exact_curve_ders_side_jump(gen *g)
{
    et_curve c;
    et_vec3 L[3], R[3];
    size_t p = (size_t)gen_upto(g, 2), more = (size_t)gen_upto(g, 2), n = 2 * p + 2 + more;
    double a = (double)gen_upto(g, 16), b = (double)gen_upto(g, 16);
    if (et_curve_new(&c, p, n, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < n + p + 1; i++) {               /* 0 .., 1 .. (p + 1 + more), 2 .. */
        c.u[i] = i <= p ? 0.0 : i < n ? 1.0 : 2.0;
    }
    for (size_t i = 0; i <= p; i++) {
        c.points[i].x = a * (double)i;
        c.points[n - 1 - i].x = 1.0 + b * (double)(p - i);
    }
    bool ok = et_exact_curve_ders_side(L, 2, &c, 1.0, ET_SIDE_LEFT) == ET_OK && et_exact_curve_ders_side(R, 2, &c, 1.0, ET_SIDE_RIGHT) == ET_OK;
    ok = gen_check(g, ok, "no derivatives");
    ok = ok && gen_check(g, L[0].x == (double)p * a && L[1].x == (double)p * a && L[2].x == 0.0, "from the left: %g, slope %g", L[0].x, L[1].x);
    ok = ok && gen_check(g, R[0].x == 1.0 && R[1].x == (double)p * b && R[2].x == 0.0, "from the right: %g, slope %g", R[0].x, R[1].x);
    for (int end = 0; ok && end < 2; end++) {               /* and beyond the ends */
        double x = end ? 2.0 : 0.0, want = end ? 1.0 + (double)p * b : 0.0, slope_there = (double)p * (end ? b : a);
        for (int beyond = 0; ok && beyond < 2; beyond++) {
            double at = x + (end ? 1.0 : -1.0) * beyond;
            ok = et_exact_curve_ders_side(L, 1, &c, at, ET_SIDE_LEFT) == ET_OK && et_exact_curve_ders_side(R, 1, &c, at, ET_SIDE_RIGHT) == ET_OK;
            ok = gen_check(g, ok && L[0].x == want && R[0].x == want && L[1].x == slope_there && R[1].x == slope_there, "at %g: %g and %g", at,
                           L[0].x, R[0].x);
        }
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict prop_exact_surface_partials(gen *g)
{
    et_surface s;
    enum { MOST = (ORDER + 1) * (ORDER + 2) / 2 };
    et_vec3 D[MOST + 1], E[MOST];
    if (!draw_surface(g, &s, 3)) {
        return SKIP;
    }
    double u = draw_knot(g, s.u, s.nu + s.p + 1, s.p), v = draw_knot(g, s.v, s.nv + s.q + 1, s.q);
    size_t d = (size_t)gen_upto(g, 3), n = (d + 1) * (d + 2) / 2;
    et_side a = draw_side(g), b = draw_side(g);
    bool along_u = gen_upto(g, 1) == 0;
    if (!et_surface_valid(&s)) {
        et_surface_free(&s);
        return SKIP;
    }
    D[0] = D[n] = (et_vec3){1.0, 2.0, 3.0};
    bool ok = gen_check(g,
                        et_exact_surface_partials(D, d, &s, NAN, v, a, b) == ET_EINVAL &&
                            et_exact_surface_partials(D, d, &s, u, HUGE_VAL, a, b) == ET_EINVAL &&
                            et_exact_surface_partials(D, SIZE_MAX, &s, u, v, a, b) == ET_ENOMEM && D[0].y == 2.0,
                        "what has to be refused");
    ok = ok && gen_check(g, et_exact_surface_partials(D, d, &s, u, v, a, b) == ET_OK && D[n].z == 3.0, "status, or wrote beyond");
    ok = ok && gen_check(g, et_exact_surface_ders(E, d, &s, u, v) == ET_OK, "no derivatives");
    for (size_t k = 0; ok && k < n && a == ET_SIDE_RIGHT && b == ET_SIDE_RIGHT; k++) {
        ok = gen_check(g, same_point(D[k], E[k]), "derivative %zu from the right is another one", k);
    }
    reverse_knots(along_u ? s.u : s.v, along_u ? s.nu + s.p + 1 : s.nv + s.q + 1);
    if (along_u) {
        reverse_points(s.points, s.weights, s.nu, s.nv);
    } else {
        for (size_t i = 0; i < s.nu; i++) {
            reverse_points(s.points + i * s.nv, s.weights == NULL ? NULL : s.weights + i * s.nv, s.nv, 1);
        }
    }
    ok =
        ok &&
        gen_check(g, et_exact_surface_partials(E, d, &s, along_u ? -u : u, along_u ? v : -v, along_u ? other(a) : a, along_u ? b : other(b)) == ET_OK,
                  "not the other way round");
    for (size_t order = 0; ok && order <= d; order++) {
        for (size_t l = 0; ok && l <= order; l++) {
            size_t k = order * (order + 1) / 2 + l, times = along_u ? order - l : l;
            ok = gen_check(g, equal_signed(D[k], E[k], times % 2 == 1), "derivative %zu: %a, the other way round %a", k, D[k].x, E[k].x);
        }
    }
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* ---- normals ---- */

/* h[4 k + a], k = 0, 1, 2: w S and its derivatives by u and by v, by de Boor's algorithm over u, then over v. */
static void surface_slopes(fmpq *h, const et_surface *s, double u, double v)
{
    fmpq *all = lifted(s->points, s->weights, s->nu * s->nv), *line = _fmpq_vec_init((slong)s->nv);
    for (size_t k = 0; k < 3; k++) {
        for (size_t a = 0; a < 4; a++) {
            for (size_t j = 0; j < s->nv; j++) {
                deboor(line + j, all + 4 * j + a, 4 * s->nv, s->u, s->nu + s->p + 1, s->p, u, k == 1);
            }
            deboor(h + 4 * k + a, line, 1, s->v, s->nv + s->q + 1, s->q, v, k == 2);
        }
    }
    _fmpq_vec_clear(all, (slong)(4 * s->nu * s->nv));
    _fmpq_vec_clear(line, (slong)s->nv);
}

/* N: a vector along the normal: the cross product of (w A_u - w_u A) and (w A_v - w_v A). */
static void along_normal(fmpq *N, const fmpq *h)
{
    fmpq *t = _fmpq_vec_init(6);
    fmpq_t x;
    fmpq_init(x);
    for (size_t k = 0; k < 6; k++) {
        fmpq_mul(t + k, h + 3, h + 4 * (1 + k / 3) + k % 3);
        fmpq_mul(x, h + k % 3, h + 4 * (1 + k / 3) + 3);
        fmpq_sub(t + k, t + k, x);
    }
    for (size_t a = 0; a < 3; a++) {
        fmpq_mul(N + a, t + (a + 1) % 3, t + 3 + (a + 2) % 3);
        fmpq_mul(x, t + (a + 2) % 3, t + 3 + (a + 1) % 3);
        fmpq_sub(N + a, N + a, x);
    }
    fmpq_clear(x);
    _fmpq_vec_clear(t, 6);
}

/* n_a / sqrt(n_x^2 + n_y^2 + n_z^2). */
static double direction(const fmpq *N, size_t a)
{
    mpfr_t sum, x;
    mpfr_init2(sum, SECOND_BITS);
    mpfr_init2(x, SECOND_BITS);
    mpfr_set_zero(sum, 1);
    for (size_t k = 0; k < 3; k++) {
        fmpq_get_mpfr(x, N + k, MPFR_RNDN);
        mpfr_sqr(x, x, MPFR_RNDN);
        mpfr_add(sum, sum, x, MPFR_RNDN);
    }
    mpfr_sqrt(sum, sum, MPFR_RNDN);
    fmpq_get_mpfr(x, N + a, MPFR_RNDN);
    mpfr_div(x, x, sum, MPFR_RNDN);
    double want = mpfr_zero_p(x) ? 0.0 : nearest(x);
    mpfr_clear(sum);
    mpfr_clear(x);
    return want;
}

verdict prop_exact_surface_normal(gen *g)
{
    et_surface s;
    et_vec3 n = {1.0, 2.0, 3.0}, before = n;
    if (!draw_surface(g, &s, 3)) {
        return SKIP;
    }
    double u = gen_parameter(g, s.u, s.nu + s.p + 1, s.p), v = gen_parameter(g, s.v, s.nv + s.q + 1, s.q);
    fmpq *h = _fmpq_vec_init(12), *N = _fmpq_vec_init(3);
    surface_slopes(h, &s, u, v);
    along_normal(N, h);
    bool flat = fmpq_is_zero(N) && fmpq_is_zero(N + 1) && fmpq_is_zero(N + 2);
    gen_label(g, flat ? "no normal" : "normal");
    bool ok = gen_check(g, et_exact_surface_normal(&n, &s, NAN, v) == ET_EINVAL && et_exact_surface_normal(&n, &s, u, -HUGE_VAL) == ET_EINVAL &&
                               same_point(n, before), "parameters that are not finite");
    ok = ok && gen_check(g, et_exact_surface_normal(&n, &s, u, v) == (flat ? ET_ERANK : ET_OK), "status");
    ok = ok && gen_check(g, !flat || same_point(n, before), "changed where there is none");
    for (int a = 0; ok && !flat && a < 3; a++) {
        double want = direction(N, (size_t)a);
        ok = gen_check(g, ref_same(coordinate(n, a), want), "coordinate %d is %a, not %a", a, coordinate(n, a), want);
    }
    s.points[0].z = NAN;
    before = n;
    ok = ok && gen_check(g, et_exact_surface_normal(&n, &s, u, v) == ET_EINVAL && same_point(n, before), "a surface that is not valid");
    _fmpq_vec_clear(h, 12);
    _fmpq_vec_clear(N, 3);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* ---- insertion ---- */

/* A knot, or any parameter. */
static double draw_place(gen *g, const double *u, size_t nu, size_t p)
{
    return gen_upto(g, 2) == 0 ? u[p + (size_t)gen_upto(g, nu - 2 * p - 1)] : gen_parameter(g, u, nu, p);
}

verdict prop_exact_curve_insert(gen *g)
{
    et_curve c, r = {0, 0, NULL, NULL, NULL};
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = draw_place(g, c.u, knots_of(&c), c.p), u[REF_KNOTS];
    size_t times = (size_t)gen_upto(g, c.p + 2), m = multiplicity(c.u, knots_of(&c), x);
    bool can = times == 0 || m + times <= c.p + 1;
    et_status status = curve_insert(&r, &c, x, times);
    bool ok = gen_check(g, can || (status == ET_EINVAL && r.u == NULL), "%zu times more a knot of multiplicity %zu", times, m);
    memcpy(u, c.u, knots_of(&c) * sizeof *u);
    if (ok && can) {
        fmpq *h = lifted(c.points, c.weights, c.n);
        for (size_t k = 0; k < times; k++) {
            h = boehm(h, u, c.n + k, c.p, x);
        }
        bool valid = et_knots_valid(u, knots_of(&c) + times, c.p);
        gen_label(g, !valid ? "too close" : times + m == c.p + 1 ? "to p + 1" : times == 0 ? "copy" : "insert");
        ok = gen_check(g, status == (valid ? ET_OK : ET_EINVAL), "status %d", (int)status);
        if (ok && valid) {
            ok = gen_check(g, r.p == c.p && r.n == c.n + times && (r.weights == NULL) == (c.weights == NULL) && same_reals(r.u, u, knots_of(&r)),
                           "knots") &&
                 is_rounded(g, &r, h) && gen_check(g, et_curve_valid(&r), "not valid");
        }
        _fmpq_vec_clear(h, (slong)(4 * (c.n + times)));
    }
    et_curve_free(&r);
    ok = ok && gen_check(g, curve_insert(&r, &c, nextafter(c.u[c.p], -HUGE_VAL), 1) == ET_EINVAL &&
                                curve_insert(&r, &c, nextafter(c.u[c.n], HUGE_VAL), 1) == ET_EINVAL && r.u == NULL, "outside the domain");
    ok = ok &&
         gen_check(g, curve_insert(&r, &c, NAN, 0) == ET_EINVAL && curve_insert(&r, &c, x, SIZE_MAX) == ET_EINVAL && r.u == NULL,
                   "no number, or too often");
    for (size_t i = c.n; ok && i < knots_of(&c); i++) {    /* clamped at the right end, where p + 1 are enough */
        c.u[i] = c.u[c.n];
    }
    m = multiplicity(c.u, knots_of(&c), c.u[c.n]);
    ok = ok && gen_check(g, curve_insert(&r, &c, c.u[c.n], 1) == ET_EINVAL && r.u == NULL, "a knot of multiplicity %zu at the end", m);
    c.points[0].x = HUGE_VAL;
    ok = ok && gen_check(g, curve_insert(&r, &c, x, 0) == ET_EINVAL && r.u == NULL, "a curve that is not valid");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* ---- elevation ---- */

/* The value of the dual functional of the j-th function of degree p on the knots t at the polynomial whose derivatives from 0 to d at y are D[stride
 * k]: sum over r of (-1)^(p-r) psi^(p-r)(y) D_r / p!, psi(x) = (t_{j+1} - x) .. (t_{j+p} - x). */
static void dual(fmpq_t L, const double *t, size_t p, size_t j, double y, const fmpq *D, size_t stride, size_t d)
{
    fmpq *c = _fmpq_vec_init((slong)(p + 2)), *f = c + p + 1;
    fmpz_t factor;
    fmpz_init(factor);
    fmpq_one(c);
    for (size_t i = 1; i <= p; i++) {                       /* c: coefficients of psi(y + s); times (t - y - s) */
        fmpq_t k;
        fmpq_init(k);
        exact_set(f, t[j + i]);
        exact_set(k, y);
        fmpq_sub(f, f, k);
        for (size_t e = i + 1; e-- > 0;) {
            fmpq_mul(c + e, c + e, f);
            if (e > 0) {
                fmpq_sub(c + e, c + e, c + e - 1);
            }
        }
        fmpq_clear(k);
    }
    fmpq_zero(L);
    for (size_t r = 0; r <= p && r <= d; r++) {
        fmpz_fac_ui(factor, (ulong)(p - r));
        fmpq_mul_fmpz(f, c + p - r, factor);
        fmpq_mul(f, f, D + r * stride);
        if ((p - r) % 2 == 1) {
            fmpq_neg(f, f);
        }
        fmpq_add(L, L, f);
    }
    fmpz_fac_ui(factor, (ulong)p);
    fmpq_div_fmpz(L, L, factor);
    fmpz_clear(factor);
    _fmpq_vec_clear(c, (slong)(p + 2));
}

/* Whether span i is a part of the domain. */
static bool lives(const double *t, size_t i, const et_curve *c)
{
    return t[i] < t[i + 1] && c->u[c->p] <= t[i] && t[i + 1] <= c->u[c->n];
}

/* The homogeneous control point j of the same curve on the knots t of degree p; 0 if the function lives nowhere.  Of the spans where it lives the
 * `which`-th: all give the same. */
static bool dual_point(fmpq *h, const double *t, size_t p, size_t j, const et_curve *c, size_t which)
{
    fmpq *all = lifted(c->points, c->weights, c->n), *D = _fmpq_vec_init((slong)(4 * (c->p + 1)));
    size_t spans = 0, at = 0;
    for (size_t i = j; i <= j + p; i++) {
        spans += lives(t, i, c);
    }
    for (size_t i = j, k = 0; spans > 0 && i <= j + p; i++) {
        if (lives(t, i, c) && k++ == which % spans) {
            at = i;
        }
    }
    for (size_t k = 0; k <= c->p && spans > 0; k++) {
        for (size_t a = 0; a < 4; a++) {
            deboor(D + 4 * k + a, all + a, 4, c->u, knots_of(c), c->p, t[at], k);
        }
    }
    for (size_t a = 0; a < 4 && spans > 0; a++) {
        dual(h + a, t, p, j, t[at], D + a, 4, c->p);
    }
    _fmpq_vec_clear(all, (slong)(4 * c->n));
    _fmpq_vec_clear(D, (slong)(4 * (c->p + 1)));
    return spans > 0;
}

/* Clamped knots of any scale, knots inside repeated up to p + 2 times now and then. */
static bool draw_clamped(gen *g, et_curve *c)
{
    if (!draw_curve(g, c, DEGREE)) {
        return false;
    }
    for (size_t i = 0; i < c->p; i++) {
        c->u[i] = c->u[c->p];
        c->u[c->n + 1 + i] = c->u[c->n];
    }
    if (gen_chance(g, 6) && c->n > c->p + 1) {
        size_t i = c->p + (size_t)gen_upto(g, c->n - c->p - 2);
        c->u[i + 1] = c->u[i];                              /* at the left end: p + 2 times */
        gen_label(g, "repeated");
    }
    if (gen_chance(g, 6) && c->n > c->p + 1 && c->u[c->p] < c->u[c->n - 1]) {
        c->u[c->n - 1] = c->u[c->n];
        gen_label(g, "repeated end");
    }
    if (!et_curve_valid(c)) {
        et_curve_free(c);
        return false;
    }
    return true;
}

/* The new knots, and what old control point keeps its place at j if no other says where it is: the j-th less `times` for every knot left of it. */
static size_t elevated_knots(double *t, const double *u, size_t nu, size_t times)
{
    size_t n = 0;
    for (size_t i = 0; i < nu; i++) {
        t[n++] = u[i];
        for (size_t k = 0; k < times && (i + 1 == nu || u[i] < u[i + 1]); k++) {
            t[n++] = u[i];
        }
    }
    return n;
}

verdict prop_exact_curve_elevate(gen *g)
{
    et_curve c, e = {0, 0, NULL, NULL, NULL};
    double t[4 * REF_KNOTS];
    fmpq *h = NULL;
    if (!draw_clamped(g, &c)) {
        return SKIP;
    }
    size_t times = (size_t)gen_upto(g, 3), nt = elevated_knots(t, c.u, knots_of(&c), times), p = c.p + times, n = nt - p - 1,
           which = (size_t)gen_upto(g, 3);
    bool ok = gen_check(g, curve_elevate(&e, &c, times) == ET_OK, "status");
    ok = ok && gen_check(g, e.p == p && e.n == n && (e.weights == NULL) == (c.weights == NULL) && same_reals(e.u, t, nt), "knots");
    h = _fmpq_vec_init((slong)(4 * n));
    for (size_t j = 0; ok && j < n; j++) {
        if (!dual_point(h + 4 * j, t, p, j, &c, which)) {   /* among so many equal knots a place, no point */
            size_t before = 0;
            for (size_t i = 0; i + 1 < nt && t[i] < t[j]; i++) {
                before += t[i] < t[i + 1];
            }
            fmpq *all = lifted(c.points, c.weights, c.n);
            for (size_t a = 0; a < 4; a++) {
                fmpq_set(h + 4 * j + a, all + 4 * (j - before * times) + a);
            }
            _fmpq_vec_clear(all, (slong)(4 * c.n));
            gen_label(g, "lives nowhere");
        }
    }
    ok = ok && is_rounded(g, &e, h) && gen_check(g, et_curve_valid(&e), "not valid");
    _fmpq_vec_clear(h, (slong)(4 * n));
    et_curve_free(&e);
    ok = ok &&
         gen_check(g,
                   curve_elevate(&e, &c, SIZE_MAX) == ET_ENOMEM && curve_elevate(&e, &c, SIZE_MAX / 2) == ET_ENOMEM && e.u == NULL,
                   "sizes beyond all");
    double first = c.u[0], last = c.u[knots_of(&c) - 1];
    if (ok && c.p > 0) {
        c.u[0] = first - fabs(first) - 1.0;
        ok = gen_check(g, curve_elevate(&e, &c, 1) == ET_EINVAL && e.u == NULL, "not clamped at the left");
        c.u[0] = first;
        c.u[knots_of(&c) - 1] = last + fabs(last) + 1.0;
        ok = ok && gen_check(g, curve_elevate(&e, &c, 1) == ET_EINVAL && e.u == NULL, "not clamped at the right");
        c.u[knots_of(&c) - 1] = last;
    }
    c.points[0].x = NAN;
    ok = ok && gen_check(g, curve_elevate(&e, &c, 0) == ET_EINVAL && e.u == NULL, "a curve that is not valid");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* ---- removal ---- */

/* Whether each function lives somewhere: of others the dual functionals do not tell. */
static bool all_live(const et_curve *c)
{
    for (size_t j = 0; j < c->n; j++) {
        size_t spans = 0;
        for (size_t i = j; i <= j + c->p; i++) {
            spans += lives(c->u, i, c);
        }
        if (spans == 0) {
            return false;
        }
    }
    return true;
}

/* Coordinates whole multiples of 6^6, weights of 2^12; knots whole numbers or fourths: inserting up to three knots makes no fraction that is no
 * double. */
static bool draw_whole(gen *g, et_curve *c)
{
    size_t p = (size_t)gen_upto(g, 3), n = p + 2 + (size_t)gen_upto(g, 4);
    if (et_curve_new(c, p, n, 0) != ET_OK) {
        return false;
    }
    double x = 0.0;
    for (size_t i = 0; i < n + p + 1; i++) {
        c->u[i] = x;
        x += gen_upto(g, 3) != 3 ? 1.0 : 0.0;
    }
    for (size_t i = 0; i < n; i++) {
        c->points[i] = (et_vec3){46656.0 * ((double)gen_upto(g, 64) - 32.0), 46656.0 * (double)gen_upto(g, 3), 46656.0 * (double)(i % 3)};
    }
    if (!et_curve_valid(c) || !all_live(c)) {
        et_curve_free(c);
        return false;
    }
    return true;
}

/* Whether the curve without r of its knots x, its control points by dual functionals at the left of each function's support, gives the curve back
 * when they are inserted; h: those control points. */
static bool restores(fmpq **h, const et_curve *c, double x, size_t r)
{
    size_t nu = knots_of(c), upto = 0, n = c->n - r;
    double t[REF_KNOTS];
    while (upto < nu && c->u[upto] <= x) {
        upto++;
    }
    memcpy(t, c->u, upto * sizeof *t);
    memcpy(t + upto - r, c->u + upto, (nu - upto) * sizeof *t);
    *h = _fmpq_vec_init((slong)(4 * n));
    for (size_t j = 0; j < n; j++) {
        if (!dual_point(*h + 4 * j, t, c->p, j, c, 0)) {
            return false;
        }
    }
    fmpq *back = _fmpq_vec_init((slong)(4 * n)), *all = lifted(c->points, c->weights, c->n);
    for (size_t k = 0; k < 4 * n; k++) {
        fmpq_set(back + k, *h + k);
    }
    for (size_t k = 0; k < r; k++) {
        back = boehm(back, t, n + k, c->p, x);
    }
    bool same = true;
    for (size_t k = 0; same && k < 4 * c->n; k++) {
        same = fmpq_equal(back + k, all + k);
    }
    _fmpq_vec_clear(back, (slong)(4 * c->n));
    _fmpq_vec_clear(all, (slong)(4 * c->n));
    return same;
}

static bool all_positive(const fmpq *h, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (fmpq_sgn(h + 4 * i + 3) <= 0) {
            return false;
        }
    }
    return true;
}

/* The greatest number of removals, by trying each. */
static bool remove_as_often(gen *g, const et_curve *c, double x, size_t times)
{
    et_curve r = {0, 0, NULL, NULL, NULL};
    size_t removed = 4711, m = multiplicity(c->u, knots_of(c), x), want = 0;
    fmpq *h = NULL, *try = NULL;
    bool ok = gen_check(g, curve_remove(&r, &removed, c, x, times) == ET_OK, "status");
    for (size_t k = 0; ok && k <= m && k <= times; k++) {
        if (restores(&try, c, x, k) && all_positive(try, c->n - k)) {
            if (h != NULL) {
                _fmpq_vec_clear(h, (slong)(4 * (c->n - want)));
            }
            want = k;
            h = try;
        } else {
            _fmpq_vec_clear(try, (slong)(4 * (c->n - k)));
        }
    }
    gen_label(g, want == 0 ? "kept" : want == m ? "all" : "some");
    ok = ok && gen_check(g, removed == want && r.p == c->p && r.n == c->n - want, "%zu of %zu removed, not %zu", removed, m, want);
    ok = ok && is_rounded(g, &r, h);
    ok = ok && gen_check(g, multiplicity(r.u, knots_of(&r), x) == m - want, "knots x");
    for (size_t i = 0, k = 0; ok && i < knots_of(c); i++) {  /* the others in their order */
        if (c->u[i] != x) {
            while (k < knots_of(&r) && r.u[k] == x) {
                k++;
            }
            ok = gen_check(g, k < knots_of(&r) && ref_same(r.u[k++], c->u[i]), "knot %zu", i);
        }
    }
    if (h != NULL) {
        _fmpq_vec_clear(h, (slong)(4 * (c->n - want)));
    }
    et_curve_free(&r);
    return ok;
}

/* A knot inserted into whole numbers, so that nothing is rounded, goes again, and the rounding of a coordinate keeps it. */
verdict prop_exact_curve_remove(gen *g)
{
    et_curve c, r = {0, 0, NULL, NULL, NULL};
    size_t removed = 4711;
    if (!draw_whole(g, &c)) {
        return SKIP;
    }
    double lo = c.u[c.p], hi = c.u[c.n], x = lo + (double)(1 + gen_upto(g, (uint64_t)(2.0 * (hi - lo)) - 2)) / 2.0;
    size_t m = multiplicity(c.u, knots_of(&c), x), times = 1 + (size_t)gen_upto(g, 2);
    if (m + times > c.p + 1) {
        times = m <= c.p ? c.p + 1 - m : 0;
    }
    bool ok = gen_check(g, curve_insert(&r, &c, x, times) == ET_OK, "not inserted");
    if (ok && gen_chance(g, 3)) {
        size_t i = (size_t)gen_upto(g, r.n - 1);
        r.points[i].y = nextafter(r.points[i].y, HUGE_VAL);
        gen_label(g, "off by an ulp");
    }
    if (ok && multiplicity(r.u, knots_of(&r), x) > 0) {
        ok = remove_as_often(g, &r, x, (size_t)gen_upto(g, 4));
        ok = ok && remove_as_often(g, &r, x, SIZE_MAX);
    }
    et_curve_free(&r);
    ok = ok && gen_check(g,
                         curve_remove(&r, &removed, &c, lo, 1) == ET_EINVAL && curve_remove(&r, &removed, &c, hi, 1) == ET_EINVAL &&
                             curve_remove(&r, &removed, &c, nextafter(x, lo), 1) == ET_EINVAL && r.u == NULL && removed == 4711,
                         "no knots of the open domain");
    c.points[0].x = NAN;
    ok =
        ok && gen_check(g, curve_remove(&r, &removed, &c, x, 0) == ET_EINVAL && r.u == NULL && removed == 4711, "a curve that is not valid");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Any curve, rational ones, too, at any of its knots: mostly none can go. */
verdict prop_exact_curve_remove_any(gen *g)
{
    et_curve c, r;
    if (!draw_curve(g, &c, 3)) {
        return SKIP;
    }
    double x = c.u[(size_t)gen_upto(g, knots_of(&c) - 1)];
    bool constant = gen_chance(g, 4), inner = c.u[c.p] < x && x < c.u[c.n];
    for (size_t i = 0; i < c.n && constant; i++) {          /* equal points and weights: all knots can go */
        c.points[i] = c.points[0];
        if (c.weights != NULL) {
            c.weights[i] = c.weights[0];
        }
    }
    size_t removed = 4711, m = multiplicity(c.u, knots_of(&c), x);
    bool ok = true;
    if (!inner) {
        ok = gen_check(g, curve_remove(&r, &removed, &c, x, 1) == ET_EINVAL && removed == 4711, "not inside, but removed");
    } else if (all_live(&c)) {
        ok = remove_as_often(g, &c, x, (size_t)gen_upto(g, m));
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* By hand: control points of no function go first, then those that are twice there; a weight that would become negative stays; what leaves the
 * doubles' range becomes infinite. */
verdict prop_exact_curve_remove_byhand(gen *g)
{
    et_curve c, r;
    size_t removed = 0, more = (size_t)gen_upto(g, 2), p = (size_t)gen_upto(g, 3), n = 2 * p + 2 + more;
    bool meets = gen_upto(g, 1) == 1;
    if (et_curve_new(&c, p, n, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < n + p + 1; i++) {
        c.u[i] = i <= p ? 0.0 : i < n ? 1.0 : 2.0;
    }
    for (size_t i = 0; i < n; i++) {                       /* two pieces, between them `more` points that count for nothing */
        c.points[i] = (et_vec3){(double)(i * i), 1.0, 0.0};
    }
    c.points[n - 1 - p] = c.points[p];
    c.points[n - 1 - p].z = meets ? 0.0 : 1.0;
    bool ok =
        gen_check(g, curve_remove(&r, &removed, &c, 1.0, more) == ET_OK && removed == more && r.n == n - more, "%zu of %zu", removed, more);
    for (size_t i = 0; ok && i < r.n; i++) {
        ok = gen_check(g, same_point(r.points[i], c.points[i <= p ? i : i + more]), "control point %zu of two pieces", i);
    }
    et_curve_free(&r);
    ok = ok && gen_check(g, curve_remove(&r, &removed, &c, 1.0, more + 1) == ET_OK && removed == more + meets, "%zu of %zu, meets: %d",
                         removed, more, (int)meets);
    for (size_t i = 0; ok && meets && i < r.n; i++) {
        ok = gen_check(g, same_point(r.points[i], c.points[i <= p ? i : i + more + 1]), "control point %zu of a corner", i);
    }
    et_curve_free(&r);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* The knot 1/2, twice there, goes once of five points with these weights, and the other points stay. */
static bool kept_positive(gen *g, const double *w, const double *x)
{
    static const double knots[] = {0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0}, fewer[] = {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0};
    et_curve c, r = {0, 0, NULL, NULL, NULL};
    size_t removed = 0;
    if (et_curve_new(&c, 2, 5, 1) != ET_OK) {
        return false;
    }
    memcpy(c.u, knots, sizeof knots);
    memcpy(c.weights, w, 5 * sizeof *w);
    for (size_t i = 0; i < 5; i++) {
        c.points[i].x = x[i];
    }
    bool ok = gen_check(g, curve_remove(&r, &removed, &c, 0.5, 2) == ET_OK && removed == 1 && r.n == 4, "a weight not positive: %zu removed", removed);
    ok = ok && gen_check(g, same_reals(r.u, fewer, 7), "knots");
    for (size_t i = 0; ok && i < 4; i++) {
        size_t k = i < 2 ? i : i + 1;
        ok = gen_check(g, r.weights[i] == w[k] && r.points[i].x == x[k], "point %zu: %g, weight %g", i, r.points[i].x, r.weights[i]);
    }
    et_curve_free(&c);
    et_curve_free(&r);
    return ok;
}

verdict prop_exact_curve_remove_limits(gen *g)
{
    static const double weights[] = {1.0, 0.375, 0.375, 0.375, 1.0}, x[] = {0.0, 1.0, 5.0, 9.0, 6.0};  /* of 1, -1/4, 1, with 1/2 twice more */
    static const double even[] = {1.0, 0.5, 0.5, 0.5, 1.0}, y[] = {0.0, 0.75, 3.75, 6.75, 6.0};          /* of 1, 0, 1 */
    et_curve c, r;
    size_t removed = 0, sign = (size_t)gen_upto(g, 1);
    double least = ldexp(1.0, -(int)gen_upto(g, 1070)), s = sign ? -1.0 : 1.0;
    for (size_t k = 0; k < 2; k++) {
        if (!gen_check(g, kept_positive(g, k == 0 ? weights : even, k == 0 ? x : y), "weights %zu", k)) {
            return FAIL;
        }
    }
    if (et_curve_new(&c, 2, 4, 0) != ET_OK) {
        return FAIL;
    }
    c.u[3] = 0.5;
    c.u[4] = c.u[5] = c.u[6] = 1.0;
    c.points[1].x = c.points[2].x = s * 0x1p1023;          /* of 0, 2^1024, 0 */
    c.points[1].y = c.points[2].y = s * least;
    bool ok = gen_check(g, curve_remove(&r, &removed, &c, 0.5, 7) == ET_OK && removed == 1 && r.n == 3, "not removed");
    ok = ok && gen_check(g, r.points[1].x == s * HUGE_VAL && r.points[1].y == s * 2.0 * least && ref_same(r.points[1].z, 0.0), "to infinity: %g",
                         r.points[1].x);
    et_curve_free(&r);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* ---- surfaces: each of their curves ---- */

/* Curve k of the surface along a direction, with storage of its own. */
static bool curve_of(et_curve *c, const et_surface *s, et_direction along, size_t k)
{
    bool u = along == ET_ALONG_U;
    if (et_curve_new(c, u ? s->p : s->q, u ? s->nu : s->nv, s->weights != NULL) != ET_OK) {
        return false;
    }
    memcpy(c->u, u ? s->u : s->v, knots_of(c) * sizeof *c->u);
    for (size_t i = 0; i < c->n; i++) {
        size_t at = u ? i * s->nv + k : k * s->nv + i;
        c->points[i] = s->points[at];
        if (s->weights != NULL) {
            c->weights[i] = s->weights[at];
        }
    }
    return true;
}

static size_t curves_of(const et_surface *s, et_direction along)
{
    return along == ET_ALONG_U ? s->nv : s->nu;
}

typedef enum { INSERT, ELEVATE, REMOVE } edit;

static et_status edit_surface(et_surface *r, size_t *removed, const et_surface *s, et_direction along, edit what, double x, size_t times)
{
    return what == INSERT    ? surface_insert(r, s, along, x, times)
           : what == ELEVATE ? surface_elevate(r, s, along, times)
                             : surface_remove(r, removed, s, along, x, times);
}

static et_status edit_curve(et_curve *r, size_t *removed, const et_curve *c, edit what, double x, size_t times)
{
    return what == INSERT    ? curve_insert(r, c, x, times)
           : what == ELEVATE ? curve_elevate(r, c, times)
                             : curve_remove(r, removed, c, x, times);
}

/* How often a knot goes from all curves. */
static size_t least_removed(const et_surface *s, et_direction along, double x, size_t times)
{
    size_t least = times;
    for (size_t k = 0; k < curves_of(s, along); k++) {
        et_curve c, r;
        size_t removed = 0;
        if (curve_of(&c, s, along, k)) {
            if (curve_remove(&r, &removed, &c, x, times) == ET_OK) {
                et_curve_free(&r);
            }
            et_curve_free(&c);
        }
        least = removed < least ? removed : least;
    }
    return least;
}

/* The edited surface is made of the edited curves, and what is across stays. */
static bool as_curves(gen *g, const et_surface *s, et_direction along, edit what, double x, size_t times)
{
    et_surface r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t removed = 4711, often = times;
    et_status status = edit_surface(&r, &removed, s, along, what, x, times), want = ET_OK;
    if (status == ET_OK && what == REMOVE) {
        often = least_removed(s, along, x, times);
        if (!gen_check(g, removed == often, "%zu removed, not %zu", removed, often)) {
            et_surface_free(&r);
            return false;
        }
    }
    bool ok = true, u = along == ET_ALONG_U;
    for (size_t k = 0; ok && k < curves_of(s, along); k++) {
        et_curve c, d = {0, 0, NULL, NULL, NULL}, e = {0, 0, NULL, NULL, NULL};
        ok = curve_of(&c, s, along, k);
        want = edit_curve(&d, &removed, &c, what, x, often);
        ok = ok && gen_check(g, status == want, "status %d, of curve %zu %d", (int)status, k, (int)want);
        ok = ok && (want != ET_OK || (curve_of(&e, &r, along, k) && gen_check(g, equal_curves(&e, &d), "curve %zu is another one", k)));
        et_curve_free(&c);
        et_curve_free(&d);
        et_curve_free(&e);
    }
    if (ok && status == ET_OK) {
        ok = gen_check(g, u ? r.q == s->q && r.nv == s->nv && same_reals(r.v, s->v, s->nv + s->q + 1)
                            : r.p == s->p && r.nu == s->nu && same_reals(r.u, s->u, s->nu + s->p + 1), "the other direction changed");
        ok = ok && gen_check(g, (r.weights == NULL) == (s->weights == NULL), "weights");
        et_surface_free(&r);
    }
    return ok && gen_check(g, r.u == NULL && r.points == NULL, "changed on failure");
}

/* A surface of which one direction is clamped now and then, and a direction of it. */
static bool draw_edited(gen *g, et_surface *s, et_direction *along, size_t degree)
{
    if (!draw_surface(g, s, degree)) {
        return false;
    }
    *along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    gen_label(g, *along == ET_ALONG_V ? "along v" : "along u");
    return true;
}

verdict prop_exact_surface_insert(gen *g)
{
    et_surface s, r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    et_direction along;
    if (!draw_edited(g, &s, &along, 3)) {
        return SKIP;
    }
    bool u = along == ET_ALONG_U;
    double x = u ? draw_place(g, s.u, s.nu + s.p + 1, s.p) : draw_place(g, s.v, s.nv + s.q + 1, s.q);
    bool ok = as_curves(g, &s, along, INSERT, x, (size_t)gen_upto(g, 3));
    s.points[0].y = NAN;
    ok = ok && gen_check(g, surface_insert(&r, &s, along, x, 0) == ET_EINVAL && r.u == NULL, "a surface that is not valid");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_exact_surface_elevate(gen *g)
{
    et_surface s, r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    et_direction along;
    if (!draw_edited(g, &s, &along, 3)) {
        return SKIP;
    }
    bool ok = as_curves(g, &s, along, ELEVATE, 0.0, (size_t)gen_upto(g, 2));
    ok = ok && gen_check(g, surface_elevate(&r, &s, along, SIZE_MAX) != ET_OK && r.u == NULL, "a degree beyond all sizes");
    s.points[0].y = NAN;
    ok = ok && gen_check(g, surface_elevate(&r, &s, along, 0) == ET_EINVAL && r.u == NULL, "a surface that is not valid");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_exact_surface_remove(gen *g)
{
    et_surface s, r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    et_direction along;
    size_t removed = 4711;
    if (!draw_edited(g, &s, &along, 3)) {
        return SKIP;
    }
    bool u = along == ET_ALONG_U;
    size_t p = u ? s.p : s.q, n = u ? s.nu : s.nv;
    double *knot = u ? s.u : s.v;
    for (size_t i = 0; i < n + p + 1; i++) {                /* whole numbers, and points of which sums of halves and sixths are doubles */
        knot[i] = i == 0 ? 0.0 : knot[i - 1] + (gen_upto(g, 3) != 3 ? 1.0 : 0.0);
    }
    for (size_t k = 0; k < s.nu * s.nv; k++) {
        s.points[k] = (et_vec3){46656.0 * (double)gen_upto(g, 16), 46656.0 * (double)gen_upto(g, 1), 0.0};
        if (s.weights != NULL) {
            s.weights[k] = 1.0;
        }
    }
    if (!et_surface_valid(&s) || !(knot[n] - knot[p] > 1.0)) {
        et_surface_free(&s);
        return SKIP;
    }
    double x = knot[p] + (double)(1 + gen_upto(g, (uint64_t)(2.0 * (knot[n] - knot[p])) - 2)) / 2.0;
    size_t m = multiplicity(knot, n + p + 1, x), times = m <= p ? 1 + (size_t)gen_upto(g, p - m) : 0;
    bool ok = gen_check(g, surface_insert(&r, &s, along, x, times) == ET_OK, "not inserted");
    if (ok && gen_chance(g, 3)) {
        size_t i = (size_t)gen_upto(g, r.nu * r.nv - 1);
        r.points[i].z = 1.0;
        gen_label(g, "one point off");
    }
    if (ok) {
        ok = as_curves(g, &r, along, REMOVE, x, (size_t)gen_upto(g, 3)) && as_curves(g, &r, along, REMOVE, x, times + m);
        et_surface_free(&r);
        r = (et_surface){0, 0, 0, 0, NULL, NULL, NULL, NULL};
    }
    ok = ok && gen_check(g, surface_remove(&r, &removed, &s, along, knot[p], 1) == ET_EINVAL && r.u == NULL && removed == 4711, "at an end");
    s.points[0].y = NAN;
    ok = ok && gen_check(g, surface_remove(&r, &removed, &s, along, x, 0) == ET_EINVAL && r.u == NULL && removed == 4711, "not valid");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Lines of constant weight but for one, in which a weight would become negative if the knot went twice. */
verdict prop_exact_surface_remove_weights(gen *g)
{
    static const double knots[] = {0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0}, weights[] = {1.0, 0.375, 0.375, 0.375, 1.0};
    et_surface s, r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t removed = 0, lines = 2 + (size_t)gen_upto(g, 2), odd = (size_t)gen_upto(g, lines);
    bool u = gen_upto(g, 1) == 0;
    if (et_surface_new(&s, u ? 2 : 1, u ? 1 : 2, u ? 5 : lines, u ? lines : 5, 1) != ET_OK) {
        return FAIL;
    }
    double *across = u ? s.v : s.u;
    memcpy(u ? s.u : s.v, knots, sizeof knots);
    for (size_t i = 0; i < lines + 2; i++) {
        across[i] = (double)i;
    }
    for (size_t k = 0; k < 5 * lines; k++) {
        size_t line = u ? k % lines : k / 5;
        s.weights[k] = line == odd ? weights[u ? k / lines : k % 5] : 1.0;
    }
    size_t want = odd < lines ? 1 : 2;
    bool ok = gen_check(g, surface_remove(&r, &removed, &s, u ? ET_ALONG_U : ET_ALONG_V, 0.5, 2) == ET_OK && removed == want, "%zu removed", removed);
    for (size_t k = 0; ok && k < (5 - want) * lines; k++) {
        size_t line = u ? k % lines : k / (5 - want), i = u ? k / lines : k % (5 - want);
        ok = gen_check(g, r.weights[k] == (line == odd && i > 0 && i < 3 ? 0.375 : 1.0), "line %zu, weight %zu: %g", line, i, r.weights[k]);
    }
    et_surface_free(&s);
    et_surface_free(&r);
    return ok ? PASS : FAIL;
}

/* ---- golden rows, written as the functions' own tests read them ---- */

static bool are_reals(const row *r, size_t *at, const double *x, size_t n)
{
    bool ok = true;
    for (size_t i = 0; ok && i < n; i++, ++*at) {
        ok = row_is(r, *at, x[i]);
    }
    return ok;
}

static bool are_sizes(const row *r, size_t *at, const size_t *x, size_t n)
{
    bool ok = true;
    for (size_t i = 0; ok && i < n; i++, ++*at) {
        ok = *at < r->nwant && strtod(r->want[*at], NULL) == (double)x[i];
    }
    return ok;
}

/* Points, and weights if there are any: the last of what is wanted. */
static bool are_points(const row *r, size_t *at, const et_vec3 *P, const double *w, size_t n)
{
    return are_reals(r, at, &P->x, 3 * n) && (w == NULL || are_reals(r, at, w, n)) && *at == r->nwant;
}

static bool is_curve(const row *r, size_t at, const et_curve *c)
{
    size_t sizes[] = {c->p, c->n, c->weights != NULL};
    return are_sizes(r, &at, sizes, 3) && are_reals(r, &at, c->u, knots_of(c)) && are_points(r, &at, c->points, c->weights, c->n);
}

static bool is_surface(const row *r, size_t at, const et_surface *s)
{
    size_t sizes[] = {s->p, s->q, s->nu, s->nv, s->weights != NULL};
    return are_sizes(r, &at, sizes, 5) && are_reals(r, &at, s->u, s->nu + s->p + 1) && are_reals(r, &at, s->v, s->nv + s->q + 1) &&
           are_points(r, &at, s->points, s->weights, s->nu * s->nv);
}

verdict true_knots_greville(const row *r)
{
    double u[REF_KNOTS], G[REF_KNOTS];
    size_t nu = r->nargs - 1, p = row_size(r, 0), n = nu - p - 1, at = 0;
    if (nu > REF_KNOTS) {
        return FAIL;
    }
    read_knots(r, u, nu, 1);
    return knots_greville(G, n, u, nu, p) == ET_OK && are_reals(r, &at, G, n) && at == r->nwant ? PASS : FAIL;
}

verdict true_curve_ders_side(const row *r)
{
    et_curve c;
    et_vec3 D[32];
    size_t at = read_curve(r, &c), k = at > 0 ? row_size(r, at) : 32, from = 0;
    bool ok = k < 32 && et_exact_curve_ders_side(D, k, &c, row_real(r, at + 1), row_size(r, at + 2) ? ET_SIDE_LEFT : ET_SIDE_RIGHT) == ET_OK &&
              are_points(r, &from, D + k, NULL, 1);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

static et_status insert_as_told(et_curve *t, const row *r)
{
    et_curve c;
    size_t at = read_curve(r, &c);
    et_status status = at > 0 ? curve_insert(t, &c, row_real(r, at), row_size(r, at + 1)) : ET_EINTERNAL;
    et_curve_free(&c);
    return status;
}

verdict true_curve_insert(const row *r)
{
    et_curve t = {0, 0, NULL, NULL, NULL};
    bool ok = insert_as_told(&t, r) == ET_OK && is_curve(r, 0, &t);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_curve_insert_status(const row *r)
{
    et_curve t = {0, 0, NULL, NULL, NULL};
    bool ok = row_is_size(r, 0, (size_t)insert_as_told(&t, r));
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_curve_elevate(const row *r)
{
    et_curve c, t = {0, 0, NULL, NULL, NULL};
    size_t at = read_curve(r, &c);
    bool ok = at > 0 && curve_elevate(&t, &c, row_size(r, at)) == ET_OK && is_curve(r, 0, &t);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* The tolerance of the row is for what rounds: exactly, too, a knot goes or does not. */
verdict true_curve_remove(const row *r)
{
    et_curve c, t = {0, 0, NULL, NULL, NULL};
    size_t at = read_curve(r, &c), removed = 0, from = 0;
    bool ok = at > 0 && curve_remove(&t, &removed, &c, row_real(r, at), row_size(r, at + 1)) == ET_OK && are_sizes(r, &from, &removed, 1) &&
              is_curve(r, 1, &t);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_surface_insert(const row *r)
{
    et_surface s, t = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t at = read_surface(r, &s);
    bool ok = at > 0 && surface_insert(&t, &s, (et_direction)row_size(r, at), row_real(r, at + 1), row_size(r, at + 2)) == ET_OK &&
              is_surface(r, 0, &t);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_surface_elevate(const row *r)
{
    et_surface s, t = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t at = read_surface(r, &s);
    bool ok = at > 0 && surface_elevate(&t, &s, (et_direction)row_size(r, at), row_size(r, at + 1)) == ET_OK && is_surface(r, 0, &t);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_surface_remove(const row *r)
{
    et_surface s, t = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t at = read_surface(r, &s), removed = 0, from = 0;
    bool ok = at > 0 && surface_remove(&t, &removed, &s, (et_direction)row_size(r, at), row_real(r, at + 1), row_size(r, at + 2)) == ET_OK &&
              are_sizes(r, &from, &removed, 1) && is_surface(r, 1, &t);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

verdict true_surface_partials(const row *r)
{
    et_surface s;
    et_vec3 D[91];                                          /* up to order 12 */
    size_t at = read_surface(r, &s), a = at > 0 ? row_size(r, at) : 12, b = at > 0 ? row_size(r, at + 1) : 12, d = a + b, from = 0;
    bool ok = d <= 12 &&
              et_exact_surface_partials(D, d, &s, row_real(r, at + 2), row_real(r, at + 3), row_size(r, at + 4) ? ET_SIDE_LEFT : ET_SIDE_RIGHT,
                                        row_size(r, at + 5) ? ET_SIDE_LEFT : ET_SIDE_RIGHT) == ET_OK &&
              are_points(r, &from, D + d * (d + 1) / 2 + b, NULL, 1);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict true_surface_normal(const row *r)
{
    et_surface s;
    et_vec3 n;
    size_t at = read_surface(r, &s), from = 0;
    bool ok = at > 0 && et_exact_surface_normal(&n, &s, row_real(r, at), row_real(r, at + 1)) == ET_OK && are_points(r, &from, &n, NULL, 1);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict true_surface_normal_status(const row *r)
{
    et_surface s;
    et_vec3 n;
    size_t at = read_surface(r, &s);
    bool ok = at > 0 && row_is_size(r, 0, (size_t)et_exact_surface_normal(&n, &s, row_real(r, at), row_real(r, at + 1)));
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
