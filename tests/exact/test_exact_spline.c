/* exact/exact: basis functions, curves and surfaces: against de Boor's algorithm and Taylor series in rationals, against balls, and the fast
 * functions within the bounds that their headers state. */
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/exact/exact.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include "exact/exact_parts.h"
#include "exact/live.h"
#include "exact/rational.h"
#include "exact/written.h"
#include "golden.h"
#include "spline/reference.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEGREE = 5, ORDER = 6, TALL = 140 };

/* ---- the second way ---- */

/* M[0..p]: the k-th derivatives of the functions of the span, all terms taken by their magnitudes (Eq. 2.9 with plus signs). */
static void magnitudes(fmpq *M, const double *u, size_t nu, size_t p, size_t span, double x, size_t k)
{
    fmpq_t zero, part;
    fmpq_init(zero);
    fmpq_init(part);
    for (size_t r = 0; r <= p; r++) {
        fmpq_zero(M + r);
    }
    if (k <= p) {
        exact_basis(M, 0, u + k, nu - 2 * k, p - k, span - k, fmin(fmax(x, u[p]), u[nu - p - 1]));
    }
    for (size_t q = p - k + 1; k <= p && q <= p; q++) {
        for (size_t r = q; r-- > 0;) {
            slope(part, zero, M + r, q, u[span + 1 + r - q], u[span + 1 + r]);
            fmpq_set(M + r, part);
            fmpq_add(M + r + 1, M + r + 1, part);
        }
    }
    fmpq_clear(zero);
    fmpq_clear(part);
}

/* (1-u)^-m - 1, u = 2^-53. */
static void gamma_of(fmpq_t q, size_t m)
{
    fmpq_t one;
    fmpq_init(one);
    exact_set(one, 1.0);
    exact_set(q, 1.0 - ET_UNIT);
    fmpq_pow_si(q, q, -(slong)m);
    fmpq_sub(q, q, one);
    fmpq_clear(one);
}

/* |fast f - want| <= ((1-u)^-m - 1) size, and a number that allows for underflow where sizes are not small. */
static bool within(double fast, const fmpq_t f, const fmpq_t want, size_t m, const fmpq_t size)
{
    fmpq_t d, bound, small;
    if (!isfinite(fast)) {
        return false;
    }
    fmpq_init(d);
    fmpq_init(bound);
    fmpq_init(small);
    exact_set(d, fast);
    fmpq_mul(d, d, f);
    fmpq_sub(d, d, want);
    fmpq_abs(d, d);
    gamma_of(bound, m);
    fmpq_mul(bound, bound, size);
    exact_set(small, 0x1p-700);
    fmpq_add(bound, bound, small);
    bool ok = fmpq_cmp(d, bound) <= 0;
    fmpq_clear(d);
    fmpq_clear(bound);
    fmpq_clear(small);
    return ok;
}

/* ---- basis functions ---- */

typedef struct { double u[REF_KNOTS], x; size_t p, nu, span; } problem;

static bool draw_basis(gen *g, problem *b)
{
    b->p = (size_t)gen_upto(g, DEGREE + 1);
    b->nu = 2 * b->p + 2 + (size_t)gen_upto(g, 8);
    ref_draw_knots(g, b->u, b->nu, b->p);
    if (!et_knots_valid(b->u, b->nu, b->p)) {
        return false;
    }
    b->x = gen_parameter(g, b->u, b->nu, b->p);
    if (gen_chance(g, 10)) {
        b->x = gen_upto(g, 1) ? DBL_MAX : -DBL_MAX;
        gen_label(g, "outside");
    }
    b->span = et_knots_span(b->u, b->nu, b->p, b->x);
    gen_note(g, "p = %zu, nu = %zu, x = %a, span %zu", b->p, b->nu, b->x, b->span);
    return true;
}

/* N, the k-th derivative of the r-th function: the spline whose only control value not 0 is its. */
static void unit_spline(fmpq_t N, const problem *b, size_t r, size_t k)
{
    size_t n = b->nu - b->p - 1;
    fmpq *c = _fmpq_vec_init((slong)n);
    fmpq_one(c + b->span - b->p + r);
    deboor(N, c, 1, b->u, b->nu, b->p, b->x, k);
    _fmpq_vec_clear(c, (slong)n);
}

verdict prop_exact_basis_eval(gen *g)
{
    problem b;
    double N[DEGREE + 3], F[DEGREE + 2], work[2 * (DEGREE + 2)];
    fmpq_t q, one, sum;
    if (!draw_basis(g, &b)) {
        return SKIP;
    }
    fmpq_init(q);
    fmpq_init(one);
    fmpq_init(sum);
    fmpq_one(one);
    N[b.p + 1] = 4711.0;
    bool ok = gen_check(g, et_exact_basis_eval(N, b.u, b.nu, b.p, b.span, b.x) == ET_OK && N[b.p + 1] == 4711.0, "status, or wrote beyond N[p]");
    et_basis_eval(F, b.u, b.nu, b.p, b.span, b.x, work, et_basis_work(b.p, 0));
    for (size_t r = 0; ok && r <= b.p; r++) {
        unit_spline(q, &b, r, 0);
        ok = gen_check(g, ref_same(N[r], exact_round(q)) && N[r] >= 0.0 && N[r] <= 1.0, "N[%zu] is %a, by de Boor %a", r, N[r], exact_round(q));
        /* Factors from (1-u)^m to (1-u)^-m: off by at most (1-u)^-m - 1 times the exact value. */
        ok = ok && gen_check(g, within(F[r], one, q, b.p == 0 ? 0 : 6 * b.p - 1, q), "et_basis_eval: N[%zu] is %a for %a", r, F[r], N[r]);
        exact_set(q, F[r]);
        fmpq_add(sum, sum, q);
    }
    ok = ok && gen_check(g, within(1.0, one, sum, b.p == 0 ? 0 : 4 * b.p - 1, one), "et_basis_eval: the sum is %a", exact_round(sum));
    fmpq_clear(q);
    fmpq_clear(one);
    fmpq_clear(sum);
    return ok ? PASS : FAIL;
}

verdict prop_exact_basis_ders(gen *g)
{
    problem b;
    double D[(ORDER + 1) * (DEGREE + 2) + 1], F[(ORDER + 1) * (DEGREE + 2)], N[DEGREE + 2], work[(DEGREE + 2) * (DEGREE + 6)];
    fmpq_t q, one;
    if (!draw_basis(g, &b)) {
        return SKIP;
    }
    size_t d = (size_t)gen_upto(g, ORDER), w = b.p + 1;
    fmpq *M = _fmpq_vec_init((slong)w);
    fmpq_init(q);
    fmpq_init(one);
    fmpq_one(one);
    D[0] = D[(d + 1) * w] = 4711.0;
    bool ok = gen_check(g, et_exact_basis_ders(D, SIZE_MAX, b.u, b.nu, b.p, b.span, b.x) == ET_ENOMEM && D[0] == 4711.0, "an order beyond all sizes");
    ok = ok && gen_check(g, et_exact_basis_ders(D, SIZE_MAX / w, b.u, b.nu, b.p, b.span, b.x) == ET_ENOMEM && D[0] == 4711.0, "a size beyond all");
    live_begin(d + b.p + b.nu);
    et_status status = et_exact_basis_ders(D, d, b.u, b.nu, b.p, b.span, b.x);
    ok = gen_check(g, live_end(), "memory is kept") && ok;
    ok = ok && gen_check(g, status == ET_OK && D[(d + 1) * w] == 4711.0, "status, or wrote beyond");
    et_exact_basis_eval(N, b.u, b.nu, b.p, b.span, b.x);
    ok = ok && gen_check(g, memcmp(N, D, w * sizeof *N) == 0, "row 0 is not that of eval");
    et_basis_ders(F, d, b.u, b.nu, b.p, b.span, b.x, work, et_basis_work(b.p, 1));
    fmpq *E = _fmpq_vec_init((slong)((d + 1) * w));
    for (size_t k = 0; k < (d + 1) * w; k++) {                  /* what stood there before does not matter */
        fmpq_one(E + k);
    }
    exact_basis(E, d, b.u, b.nu, b.p, b.span, b.x);
    for (size_t k = 0; ok && k < (d + 1) * w; k++) {
        ok = gen_check(g, ref_same(exact_round(E + k), D[k]), "number %zu depends on what stood there", k);
    }
    _fmpq_vec_clear(E, (slong)((d + 1) * w));
    for (size_t k = 0; ok && k <= d; k++) {
        magnitudes(M, b.u, b.nu, b.p, b.span, b.x, k);
        for (size_t r = 0; ok && r <= b.p; r++) {
            unit_spline(q, &b, r, k);
            ok = gen_check(g, ref_same(D[k * w + r], exact_round(q)), "derivative %zu of N[%zu]: %a, by de Boor %a", k, r, D[k * w + r],
                           exact_round(q));
            ok = ok && gen_check(g, k <= b.p || D[k * w + r] == 0.0, "derivative %zu of degree %zu", k, b.p);
            ok = ok && gen_check(g, within(F[k * w + r], one, q, 6 * b.p + 2, M + r), "et_basis_ders: derivative %zu of N[%zu]: %a for %a", k, r,
                                 F[k * w + r], D[k * w + r]);
        }
    }
    fmpq_clear(q);
    fmpq_clear(one);
    _fmpq_vec_clear(M, (slong)w);
    return ok ? PASS : FAIL;
}

/* ---- curves ---- */

/* q = k! */
static void factorial(fmpq_t q, size_t k)
{
    fmpq_one(q);
    for (size_t i = 2; i <= k; i++) {
        fmpq_mul_ui(q, q, (ulong)i);
    }
}

/* T[4k + a], k <= d: Taylor coefficients at x, of the curve's coordinates (a < 3) and of w. */
static void curve_taylor(fmpq *T, size_t d, const et_curve *c, double x)
{
    fmpq *h = lifted(c->points, c->weights, c->n);
    fmpq_t f;
    fmpq_init(f);
    for (size_t k = 0; k <= d; k++) {
        factorial(f, k);
        for (size_t a = 0; a < 4; a++) {
            deboor(T + 4 * k + a, h + a, 4, c->u, c->n + c->p + 1, c->p, x, k);
            fmpq_div(T + 4 * k + a, T + 4 * k + a, f);
        }
        for (size_t a = 0; a < 3; a++) {       /* the quotient of two series */
            for (size_t i = 1; i <= k; i++) {
                fmpq_submul(T + 4 * k + a, T + 4 * i + 3, T + 4 * (k - i) + a);
            }
            fmpq_div(T + 4 * k + a, T + 4 * k + a, T + 3);
        }
    }
    fmpq_clear(f);
    _fmpq_vec_clear(h, (slong)(4 * c->n));
}

static et_vec3 fast_curve(const et_curve *c, double x)
{
    size_t n = et_curve_work(c, 0);
    double *work = et_size_array(n, sizeof(double));
    et_vec3 C = et_curve_point(c, x, work, n);
    free(work);
    return C;
}

/* sum_i M_i |h_ia|, M the magnitudes of the basis. */
static void curve_size(fmpq_t q, const et_curve *c, const fmpq *h, const fmpq *M, size_t span, size_t a)
{
    fmpq_t t;
    fmpq_init(t);
    fmpq_zero(q);
    for (size_t r = 0; r <= c->p; r++) {
        fmpq_abs(t, h + 4 * (span - c->p + r) + a);
        fmpq_addmul(q, t, M + r);
    }
    fmpq_clear(t);
}

/* The fast point f w = A within the stated bound: fast w is off by gamma(m+1) of the numerator's size, and by as many of w times the result. */
static bool point_within(double fast, const fmpq_t w, const fmpq_t A, size_t m, const fmpq_t size, bool rational)
{
    fmpq_t q, s;
    fmpq_init(q);
    fmpq_init(s);
    fmpq_set(s, size);
    if (rational && isfinite(fast)) {
        exact_set(q, fabs(fast));
        fmpq_addmul(s, q, w);
    }
    bool ok = within(fast, w, A, rational ? m + 1 : m, s);
    fmpq_clear(q);
    fmpq_clear(s);
    return ok;
}

verdict prop_exact_curve_point(gen *g)
{
    et_curve c;
    et_vec3 C = {1.0, 2.0, 3.0}, before = C;
    fmpq_t A, size;
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = gen_parameter(g, c.u, c.n + c.p + 1, c.p);
    size_t span = et_knots_span(c.u, c.n + c.p + 1, c.p, x);
    fmpq *T = _fmpq_vec_init(4), *h = lifted(c.points, c.weights, c.n), *M = _fmpq_vec_init((slong)(c.p + 1));
    fmpq_init(A);
    fmpq_init(size);
    bool ok =
        gen_check(g, et_exact_curve_point(&C, &c, NAN) == ET_EINVAL && et_exact_curve_point(&C, &c, HUGE_VAL) == ET_EINVAL && same_point(C, before),
                  "a parameter that is not finite");
    ok = ok && gen_check(g, et_exact_curve_point(&C, &c, x) == ET_OK, "no point");
    et_vec3 fast = fast_curve(&c, x);
    curve_taylor(T, 0, &c, x);
    magnitudes(M, c.u, c.n + c.p + 1, c.p, span, x, 0);
    for (int a = 0; ok && a < 3; a++) {
        double want = exact_round(T + a);
        ok = gen_check(g, ref_same(coordinate(C, a), want), "%a: coordinate %d is %a, by de Boor %a", x, a, coordinate(C, a), want);
        fmpq_mul(A, T + a, T + 3);
        curve_size(size, &c, h, M, span, (size_t)a);
        ok = ok && gen_check(g, point_within(coordinate(fast, a), T + 3, A, 7 * c.p, size, c.weights != NULL),
                             "et_curve_point: coordinate %d is %a for %a", a, coordinate(fast, a), want);
    }
    c.points[c.n - 1].y = NAN;
    before = C;
    ok = ok && gen_check(g, et_exact_curve_point(&C, &c, x) == ET_EINVAL && same_point(C, before), "a curve that is not valid");
    fmpq_clear(A);
    fmpq_clear(size);
    _fmpq_vec_clear(T, 4);
    _fmpq_vec_clear(M, (slong)(c.p + 1));
    _fmpq_vec_clear(h, (slong)(4 * c.n));
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Control points x or its neighbour y: at 1/2 a curve of degree 1 or 3 is in the middle of the two, a tie; beside it, or at degree 2, it is not. */
verdict prop_exact_curve_point_ties(gen *g)
{
    static const double from[] = {1.0, 0.0, 0x1p-1074, 0x1.fffffffffffffp0, DBL_MIN, 0x1.8p300, 0x1.ffffffffffffep1023, 0x1.0000000000001p-1022};
    et_curve c;
    et_vec3 C;
    uint64_t bits;
    double sign = gen_upto(g, 1) ? -1.0 : 1.0, x = from[gen_upto(g, 7)], y = nextafter(x, HUGE_VAL), side = (double)gen_upto(g, 2) - 1.0;
    size_t p = (size_t)gen_between(g, 1, 3);
    if (et_curve_new(&c, p, p + 1, gen_upto(g, 1) == 1) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= p; i++) {          /* x y; x x y; x x y y */
        c.u[p + 1 + i] = 1.0;
        c.points[i] = (et_vec3){sign * (2 * i < p || (p == 2 && i == 1) ? x : y), sign * x, sign * y};
    }
    memcpy(&bits, &x, sizeof bits);
    double even = bits % 2 == 0 ? x : y, want = p == 2 || side < 0.0 ? x : side > 0.0 ? y : even;
    bool ok = gen_check(g, et_exact_curve_point(&C, &c, 0.5 + side * 0x1p-20) == ET_OK, "no point");
    ok = ok && gen_check(g, C.x == sign * want && C.y == sign * x && C.z == sign * y, "degree %zu, side %g of the middle of %a and its neighbour: %a",
                         p, side, sign * x, C.x);
    ok = ok && gen_check(g, C.x != 0.0 || ref_same(C.x, 0.0), "a zero of the other sign");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Balls by de Boor's algorithm, coordinate a, or w for a = 3. */
static void ball_deboor(arb_t C, const et_curve *c, double x, int a, slong bits)
{
    size_t p = c->p, span = ref_span(c->u, c->n + p + 1, p, x);
    arb_ptr h = _arb_vec_init((slong)(p + 1)), t = _arb_vec_init(4);
    arb_ptr y = t + 1, lo = t + 2, hi = t + 3;
    arb_set_d(y, fmin(fmax(x, c->u[p]), c->u[c->n]));
    for (size_t r = 0; r <= p; r++) {
        arb_set_d(h + r, c->weights ? c->weights[span - p + r] : 1.0);
        arb_set_d(t, a < 3 ? coordinate(c->points[span - p + r], a) : 1.0);
        arb_mul(h + r, h + r, t, bits);
    }
    for (size_t j = 1; j <= p; j++) {
        for (size_t r = p; r >= j; r--) {
            arb_set_d(lo, c->u[span - p + r]);
            arb_set_d(hi, c->u[span + 1 + r - j]);
            arb_sub(t, y, lo, bits);
            arb_mul(h + r, h + r, t, bits);
            arb_sub(t, hi, y, bits);
            arb_addmul(h + r, h + r - 1, t, bits);
            arb_sub(t, hi, lo, bits);
            arb_div(h + r, h + r, t, bits);
        }
    }
    arb_set(C, h + p);
    _arb_vec_clear(h, (slong)(p + 1));
    _arb_vec_clear(t, 4);
}

/* What balls round to at some precision is the result, and at four times that precision still; they fail to round only what is a tie. */
verdict prop_exact_curve_point_balls(gen *g)
{
    et_curve c;
    et_vec3 C;
    arb_t ball, w;
    slong bits = (slong)gen_between(g, 64, 400);
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = gen_parameter(g, c.u, c.n + c.p + 1, c.p), got = 0.0;
    arb_init(ball);
    arb_init(w);
    bool ok = gen_check(g, et_exact_curve_point(&C, &c, x) == ET_OK, "no point"), decided = false;
    for (int a = 0; ok && a < 3; a++) {
        for (int times = 1; ok && times <= 16; times *= 4) {
            ball_deboor(ball, &c, x, a, bits * times);
            ball_deboor(w, &c, x, 3, bits * times);
            arb_div(ball, ball, w, bits * times);
            bool now = exact_round_ball(&got, ball);
            ok = gen_check(g, now || !decided, "decided by fewer bits than %ld", (long)(bits * times));
            ok = ok && (!now || gen_check(g, ref_same(got, coordinate(C, a)), "%ld bits: coordinate %d is %a, not %a", (long)(bits * times), a, got,
                                          coordinate(C, a)));
            decided = now;
        }
        if (!decided) {
            gen_label(g, "undecided");
        }
        decided = false;
    }
    arb_clear(ball);
    arb_clear(w);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Halving a Bezier curve: the control points of both halves are sums of eighths and the like, no roundings; points and derivatives stay. */
verdict prop_exact_curve_ders_halved(gen *g)
{
    et_curve c, t;
    et_vec3 C[ORDER + 1], T[ORDER + 1];
    size_t p = (size_t)gen_between(g, 1, 7), d = (size_t)gen_upto(g, ORDER);
    double x = gen_real(g, 0.0, 1.0), weight = ldexp(1.0, (int)gen_upto(g, 8));
    bool rational = gen_upto(g, 1) == 1;
    if (et_curve_new(&c, p, p + 1, rational) != ET_OK || et_curve_new(&t, p, 2 * p + 1, rational) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= p; i++) {
        c.u[p + 1 + i] = t.u[2 * p + 1 + i] = 1.0;
        c.points[i] = (et_vec3){(double)gen_upto(g, 64) - 32.0, (double)gen_upto(g, 64), (double)(i * i)};
    }
    for (size_t i = 0; i < p; i++) {
        t.u[p + 1 + i] = 0.5;
    }
    et_vec3 h[8];
    memcpy(h, c.points, (p + 1) * sizeof *h);
    for (size_t j = 0; j <= p; j++) {          /* de Casteljau at 1/2 */
        t.points[j] = h[0];
        t.points[2 * p - j] = h[p - j];
        for (size_t i = 0; i + j < p; i++) {
            h[i] = (et_vec3){(h[i].x + h[i + 1].x) / 2.0, (h[i].y + h[i + 1].y) / 2.0, (h[i].z + h[i + 1].z) / 2.0};
        }
    }
    for (size_t i = 0; rational && i <= 2 * p; i++) {
        t.weights[i] = weight;
        c.weights[i <= p ? i : p] = weight;
    }
    bool ok = gen_check(g, et_exact_curve_ders(C, d, &c, x) == ET_OK && et_exact_curve_ders(T, d, &t, x) == ET_OK, "no derivatives");
    for (size_t k = 0; ok && k <= d; k++) {
        ok = gen_check(g, same_point(C[k], T[k]), "derivative %zu at %a: %a, halved %a", k, x, C[k].x, T[k].x);
    }
    /* With x a sixteenth nothing is rounded in the fast one either. */
    if (ok && x * 16.0 == floor(x * 16.0)) {
        gen_label(g, "sixteenths");
        ok = gen_check(g, same_point(fast_curve(&c, x), C[0]), "et_curve_point: %a, not %a", fast_curve(&c, x).x, C[0].x);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Leibniz' rule for the fast derivatives, within the bound that curve.h states: |sum C(k,i) w_i D_(k-i) - A_k| against the terms' magnitudes. */
static bool ders_within(gen *g, const et_curve *c, const et_vec3 *D, const fmpq *T, size_t d, double x)
{
    size_t span = et_knots_span(c->u, c->n + c->p + 1, c->p, x), m = c->weights ? 8 * c->p + 5 : 7 * c->p + 3;
    fmpq *h = lifted(c->points, c->weights, c->n), *M = _fmpq_vec_init((slong)((d + 1) * (c->p + 1))), *s = _fmpq_vec_init(8);
    fmpq *sum = s, *size = s + 1, *f = s + 2, *W = s + 3, *q = s + 4, *one = s + 5, *A = s + 6, *w = s + 7;
    bool ok = true;
    fmpq_one(one);
    for (size_t k = 0; k <= d; k++) {
        magnitudes(M + k * (c->p + 1), c->u, c->n + c->p + 1, c->p, span, x, k);
    }
    for (size_t k = 0; ok && k <= d; k++) {
        for (size_t a = 0; ok && a < 3; a++) {
            fmpq_zero(sum);
            fmpq_zero(A);
            curve_size(size, c, h, M + k * (c->p + 1), span, a);
            for (size_t i = 0; i <= k; i++) {
                /* C(k,i) w_i D_(k-i); A_k / k! is the Cauchy product of the exact series of w and of the curve. */
                double coefficient = 1.0;
                for (size_t j = 0; j < i; j++) {
                    coefficient = coefficient * (double)(k - j) / (double)(j + 1);
                }
                fmpq_addmul(A, T + 4 * i + 3, T + 4 * (k - i) + a);
                factorial(f, i);
                fmpq_mul(w, T + 4 * i + 3, f);
                exact_set(q, coefficient);
                fmpq_mul(w, w, q);
                exact_set(f, coordinate(D[k - i], (int)a));
                fmpq_addmul(sum, w, f);
                if (c->weights) {
                    curve_size(W, c, h, M + i * (c->p + 1), span, 3);
                    fmpq_mul(W, W, q);
                    fmpq_abs(f, f);
                    fmpq_addmul(size, W, f);
                }
            }
            factorial(f, k);
            fmpq_mul(A, A, f);
            fmpq_sub(sum, sum, A);
            fmpq_add(sum, sum, one);           /* within() compares 1 times one with what is off */
            ok = gen_check(g, within(1.0, one, sum, m, size), "et_curve_ders: derivative %zu, coordinate %zu: %a", k, a, coordinate(D[k], (int)a));
        }
    }
    _fmpq_vec_clear(h, (slong)(4 * c->n));
    _fmpq_vec_clear(M, (slong)((d + 1) * (c->p + 1)));
    _fmpq_vec_clear(s, 8);
    return ok;
}

static bool moderate(const et_vec3 *D, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        if (!(fabs(D[k].x) < 0x1p900 && fabs(D[k].y) < 0x1p900 && fabs(D[k].z) < 0x1p900)) {
            return false;
        }
    }
    return true;
}

verdict prop_exact_curve_ders(gen *g)
{
    et_curve c;
    et_vec3 P[ORDER + 2], D[ORDER + 2], F[ORDER + 1];
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = gen_parameter(g, c.u, c.n + c.p + 1, c.p);
    size_t d = (size_t)gen_upto(g, ORDER), n = et_curve_work(&c, d);
    fmpq *T = _fmpq_vec_init((slong)(4 * (d + 1)));
    fmpq_t f;
    double *work = et_size_array(n, sizeof(double));
    fmpq_init(f);
    D[d + 1] = D[0] = (et_vec3){1.0, 2.0, 3.0};
    bool ok = gen_check(g, et_exact_curve_ders(D, d, &c, NAN) == ET_EINVAL && same_point(D[0], D[d + 1]), "a parameter that is not finite");
    ok = ok && gen_check(g, et_exact_curve_ders(D, SIZE_MAX, &c, x) == ET_ENOMEM && et_exact_curve_ders(D, SIZE_MAX / 8, &c, x) == ET_ENOMEM &&
                                same_point(D[0], D[d + 1]), "an order beyond all sizes");
    live_begin(d + c.n);
    et_status status = et_exact_curve_ders(D, d, &c, x);
    ok = gen_check(g, live_end(), "memory is kept") && ok;
    ok = ok && gen_check(g, status == ET_OK && same_point(D[d + 1], (et_vec3){1.0, 2.0, 3.0}), "status, or wrote beyond");
    curve_taylor(T, d, &c, x);
    for (size_t k = 0; ok && k <= d; k++) {
        factorial(f, k);
        for (size_t a = 0; ok && a < 3; a++) {
            fmpq *q = T + 4 * k + a;
            fmpq_mul(q, q, f);
            ok = gen_check(g, ref_same(coordinate(D[k], (int)a), exact_round(q)), "derivative %zu, coordinate %zu at %a: %a, by its series %a", k, a,
                           x, coordinate(D[k], (int)a), exact_round(q));
            fmpq_div(q, q, f);
        }
    }
    et_curve_ders(F, d, &c, x, work, n);
    /* Where spans are so short that derivatives come near overflow there is no bound. */
    ok = ok && (!moderate(D, d + 1) || !moderate(F, d + 1) || ders_within(g, &c, F, T, d, x));
    for (size_t i = 0; i < c.n; i++) {                      /* in a plane the others are the same */
        c.points[i].z = 0.0;
    }
    ok = ok && gen_check(g, et_exact_curve_ders(P, d, &c, x) == ET_OK, "no derivatives in a plane");
    for (size_t k = 0; ok && k <= d; k++) {
        ok = gen_check(g, same_point(P[k], (et_vec3){D[k].x, D[k].y, 0.0}), "in a plane derivative %zu is (%a, %a, %a)", k, P[k].x, P[k].y, P[k].z);
    }
    c.u[0] = NAN;
    D[0] = D[d + 1];
    ok = ok && gen_check(g, et_exact_curve_ders(D, d, &c, x) == ET_EINVAL && same_point(D[0], D[d + 1]), "a curve that is not valid");
    free(work);
    fmpq_clear(f);
    _fmpq_vec_clear(T, (slong)(4 * (d + 1)));
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* A[a]: the derivative (k,l) of w x, w y, w z, w: de Boor's algorithm along v for each line of control points, then along u. */
static void surface_deboor(fmpq *A, const et_surface *s, const fmpq *h, double u, double v, size_t k, size_t l)
{
    fmpq *line = _fmpq_vec_init((slong)s->nu);
    for (size_t a = 0; a < 4; a++) {
        for (size_t i = 0; i < s->nu; i++) {
            deboor(line + i, h + 4 * i * s->nv + a, 4, s->v, s->nv + s->q + 1, s->q, v, l);
        }
        deboor(A + a, line, 1, s->u, s->nu + s->p + 1, s->p, u, k);
    }
    _fmpq_vec_clear(line, (slong)s->nu);
}

/* Where the derivative (k,l) stands. */
static size_t place(size_t k, size_t l)
{
    size_t m = k + l, at = l;
    while (m > 0) {
        at += m--;
    }
    return at;
}

/* T[4 place(k,l) + a]: coefficients of Taylor's series in two variables, the coordinates by dividing series. */
static void surface_taylor(fmpq *T, size_t d, const et_surface *s, double u, double v)
{
    fmpq *h = lifted(s->points, s->weights, s->nu * s->nv);
    fmpq_t f, e;
    fmpq_init(f);
    fmpq_init(e);
    for (size_t m = 0; m <= d; m++) {
        for (size_t l = 0; l <= m; l++) {
            size_t k = m - l;
            fmpq *C = T + 4 * place(k, l);
            factorial(f, k);
            factorial(e, l);
            fmpq_mul(f, f, e);
            surface_deboor(C, s, h, u, v, k, l);
            for (size_t a = 0; a < 4; a++) {
                fmpq_div(C + a, C + a, f);
            }
            for (size_t a = 0; a < 3; a++) {
                for (size_t i = 0; i <= k; i++) {
                    for (size_t j = i == 0; j <= l; j++) {
                        fmpq_submul(C + a, T + 4 * place(i, j) + 3, T + 4 * place(k - i, l - j) + a);
                    }
                }
                fmpq_div(C + a, C + a, T + 3);
            }
        }
    }
    fmpq_clear(f);
    fmpq_clear(e);
    _fmpq_vec_clear(h, (slong)(4 * s->nu * s->nv));
}

/* sum N M |h_a| with the magnitudes of derivatives k, l of the basis. */
static void surface_size(fmpq_t size, const et_surface *s, double u, double v, size_t k, size_t l, size_t a)
{
    size_t i = et_knots_span(s->u, s->nu + s->p + 1, s->p, u) - s->p, j = et_knots_span(s->v, s->nv + s->q + 1, s->q, v) - s->q;
    fmpq *N = _fmpq_vec_init((slong)(s->p + 1)), *M = _fmpq_vec_init((slong)(s->q + 1)), *h = lifted(s->points, s->weights, s->nu * s->nv);
    fmpq_t t;
    fmpq_init(t);
    magnitudes(N, s->u, s->nu + s->p + 1, s->p, i + s->p, u, k);
    magnitudes(M, s->v, s->nv + s->q + 1, s->q, j + s->q, v, l);
    fmpq_zero(size);
    for (size_t r = 0; r <= s->p; r++) {
        for (size_t c = 0; c <= s->q; c++) {
            fmpq_mul(t, N + r, M + c);
            fmpq_mul(t, t, h + 4 * ((i + r) * s->nv + j + c) + a);
            fmpq_abs(t, t);
            fmpq_add(size, size, t);
        }
    }
    fmpq_clear(t);
    _fmpq_vec_clear(N, (slong)(s->p + 1));
    _fmpq_vec_clear(M, (slong)(s->q + 1));
    _fmpq_vec_clear(h, (slong)(4 * s->nu * s->nv));
}

static double *room(const et_surface *s)
{
    return et_size_array(et_surface_work(s), sizeof(double));
}

/* Binomials beyond a word: C(70, 34), order 70 of a degree of 34. */
/* One case in 500. */
verdict prop_exact_curve_ders_high(gen *g)
{
    enum { P = 34, D = 70 };
    et_vec3 S[D + 1], C;
    et_curve c;
    if (et_curve_new(&c, P, P + 1, 1) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= P; i++) {
        c.u[P + 1 + i] = 1.0;
        c.points[i] = (et_vec3){(double)gen_upto(g, 9), (double)i, 1.0};
        c.weights[i] = 1.0 + (double)(i * i % 7);
    }
    live_begin(0);
    et_status status = et_exact_curve_ders(S, D, &c, 0.5);
    bool ok = gen_check(g, live_end(), "memory is kept") && gen_check(g, status == ET_OK, "status %d", (int)status);
    ok = ok && gen_check(g, et_exact_curve_point(&C, &c, 0.5) == ET_OK && same_point(S[0], C) && S[0].z == 1.0, "another point");
    for (size_t k = 1; ok && k <= D; k++) {
        ok = gen_check(g, S[k].z == 0.0, "derivative %zu of a constant: %a", k, S[k].z);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict prop_exact_surface_point(gen *g)
{
    et_surface s;
    et_vec3 S = {1.0, 2.0, 3.0}, before = S;
    fmpq_t A, size;
    if (!draw_surface(g, &s, 4)) {
        return SKIP;
    }
    double u = gen_parameter(g, s.u, s.nu + s.p + 1, s.p), v = gen_parameter(g, s.v, s.nv + s.q + 1, s.q), *work = room(&s);
    fmpq *T = _fmpq_vec_init(4);
    fmpq_init(A);
    fmpq_init(size);
    bool ok = gen_check(g, et_exact_surface_point(&S, &s, NAN, v) == ET_EINVAL && et_exact_surface_point(&S, &s, u, -HUGE_VAL) == ET_EINVAL &&
                               same_point(S, before), "parameters that are not finite");
    ok = ok && gen_check(g, et_exact_surface_point(&S, &s, u, v) == ET_OK, "no point");
    et_vec3 fast = et_surface_point(&s, u, v, work, et_surface_work(&s));
    surface_taylor(T, 0, &s, u, v);
    for (int a = 0; ok && a < 3; a++) {
        double want = exact_round(T + a);
        ok = gen_check(g, ref_same(coordinate(S, a), want), "(%a, %a): coordinate %d is %a, by de Boor %a", u, v, a, coordinate(S, a), want);
        fmpq_mul(A, T + a, T + 3);
        surface_size(size, &s, u, v, 0, 0, (size_t)a);
        ok = ok && gen_check(g, point_within(coordinate(fast, a), T + 3, A, 7 * (s.p + s.q), size, s.weights != NULL),
                             "et_surface_point: coordinate %d is %a for %a", a, coordinate(fast, a), want);
    }
    s.points[0].z = NAN;
    before = S;
    ok = ok && gen_check(g, et_exact_surface_point(&S, &s, u, v) == ET_EINVAL && same_point(S, before), "a surface that is not valid");
    free(work);
    fmpq_clear(A);
    fmpq_clear(size);
    _fmpq_vec_clear(T, 4);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Corners of a clamped polynomial surface are control points; integers at sixteenths of a Bezier patch are not rounded, so the fast point is this
 * one. */
verdict prop_exact_surface_point_exact(gen *g)
{
    et_surface s;
    et_vec3 S;
    size_t p = (size_t)gen_upto(g, 4), q = (size_t)gen_upto(g, 4);
    if (et_surface_new(&s, p, q, p + 1, q + 1, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= p; i++) {
        s.u[p + 1 + i] = 1.0;
    }
    for (size_t j = 0; j <= q; j++) {
        s.v[q + 1 + j] = 1.0;
    }
    for (size_t k = 0; k < (p + 1) * (q + 1); k++) {
        s.points[k] = (et_vec3){(double)gen_upto(g, 64) - 32.0, (double)gen_upto(g, 64), (double)gen_upto(g, 9)};
    }
    double u = (double)gen_upto(g, 16) / 16.0, v = (double)gen_upto(g, 16) / 16.0, *work = room(&s);
    et_vec3 fast = et_surface_point(&s, u, v, work, et_surface_work(&s));
    bool ok = gen_check(g, et_exact_surface_point(&S, &s, u, v) == ET_OK && S.x == fast.x && S.y == fast.y && S.z == fast.z, "(%g, %g): %a, fast %a",
                        u, v, S.x, fast.x);
    for (int corner = 0; ok && corner < 4; corner++) {
        et_vec3 P = s.points[(corner / 2 ? p : 0) * (q + 1) + (corner % 2 ? q : 0)];
        ok = gen_check(g, et_exact_surface_point(&S, &s, corner / 2 ? 9.0 : -9.0, corner % 2 ? 1.0 : 0.0) == ET_OK && same_point(S, P), "corner %d",
                       corner);
    }
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Leibniz' rule for the six fast derivatives.  Roundings of a term: 6p + 2 and 6q + 2 in the basis, p and q sums, 3 products, 1 or 2 more with w's
 * derivative, 3 differences: fewer than 7(p+q) + 12. */
static bool six_within(gen *g, const et_surface *s, const et_vec3 *D, const fmpq *T, double u, double v)
{
    static const size_t du[6] = {0, 1, 0, 2, 1, 0}, dv[6] = {0, 0, 1, 0, 1, 2};
    fmpq *q = _fmpq_vec_init(6);
    fmpq *sum = q, *size = q + 1, *W = q + 2, *w = q + 3, *f = q + 4, *one = q + 5;
    bool ok = true;
    fmpq_one(one);
    for (size_t n = 0; ok && n < 6; n++) {
        size_t k = du[n], l = dv[n];
        for (int a = 0; ok && a < 3; a++) {
            fmpq_one(sum);
            surface_size(size, s, u, v, k, l, (size_t)a);
            for (size_t i = 0; i <= k; i++) {
                for (size_t j = 0; j <= l; j++) {
                    /* Orders up to 2: C(k,i) C(l,j) is 1 or 2, the factorials that make derivatives of coefficients likewise. */
                    ulong factor = (k == 2 && i == 1 ? 2u : 1u) * (l == 2 && j == 1 ? 2u : 1u);
                    size_t rest = place(k - i, l - j);
                    fmpq_mul_ui(w, T + 4 * place(i, j) + 3, factor * (i == 2 || j == 2 ? 2u : 1u));
                    exact_set(f, coordinate(D[rest], a));
                    fmpq_set(W, T + 4 * rest + (size_t)a);
                    fmpq_mul_ui(W, W, k - i == 2 || l - j == 2 ? 2u : 1u);
                    fmpq_sub(W, f, W);
                    fmpq_addmul(sum, w, W);
                    if (s->weights) {
                        surface_size(W, s, u, v, i, j, 3);
                        fmpq_mul_ui(W, W, factor);
                        fmpq_abs(f, f);
                        fmpq_addmul(size, W, f);
                    }
                }
            }
            ok = gen_check(g, within(1.0, one, sum, 7 * (s->p + s->q) + 12, size), "et_surface_ders: derivative %zu, coordinate %d: %a", n, a,
                           coordinate(D[n], a));
        }
    }
    _fmpq_vec_clear(q, 6);
    return ok;
}

verdict prop_exact_surface_ders(gen *g)
{
    et_surface s;
    et_vec3 D[(ORDER + 1) * (ORDER + 2) / 2 + 1], F[6], end = {1.0, 2.0, 3.0}, S;
    if (!draw_surface(g, &s, 3)) {
        return SKIP;
    }
    double u = gen_parameter(g, s.u, s.nu + s.p + 1, s.p), v = gen_parameter(g, s.v, s.nv + s.q + 1, s.q), *work = room(&s);
    size_t d = (size_t)gen_upto(g, gen_chance(g, 6) ? ORDER : 3), n = (d + 1) * (d + 2) / 2;
    fmpq *T = _fmpq_vec_init((slong)(4 * n));
    fmpq_t f, e;
    fmpq_init(f);
    fmpq_init(e);
    D[0] = D[n] = end;
    bool ok = gen_check(g, et_exact_surface_ders(D, d, &s, u, NAN) == ET_EINVAL && et_exact_surface_ders(D, d, &s, HUGE_VAL, v) == ET_EINVAL &&
                               same_point(D[0], end), "parameters that are not finite");
    ok = ok && gen_check(g,
                         et_exact_surface_ders(D, SIZE_MAX, &s, u, v) == ET_ENOMEM && et_exact_surface_ders(D, SIZE_MAX - 1, &s, u, v) == ET_ENOMEM &&
                             et_exact_surface_ders(D, SIZE_MAX / 2, &s, u, v) == ET_ENOMEM && same_point(D[0], end),
                         "an order beyond all sizes");
    ok = ok && gen_check(g, et_exact_surface_ders(D, d, &s, u, v) == ET_OK && same_point(D[n], end), "status, or wrote beyond %zu", n);
    ok = ok && gen_check(g, et_exact_surface_point(&S, &s, u, v) == ET_OK && same_point(D[0], S), "D[0] is another point");
    surface_taylor(T, d, &s, u, v);
    for (size_t m = 0; m <= d; m++) {
        for (size_t l = 0; l <= m; l++) {
            factorial(f, m - l);
            factorial(e, l);
            fmpq_mul(f, f, e);
            for (size_t a = 0; ok && a < 3; a++) {
                fmpq_mul(e, T + 4 * place(m - l, l) + a, f);
                ok = gen_check(g, ref_same(coordinate(D[m * (m + 1) / 2 + l], (int)a), exact_round(e)),
                               "(%a, %a): derivative (%zu,%zu), coordinate %zu: %a, by its series %a", u, v, m - l, l, a,
                               coordinate(D[m * (m + 1) / 2 + l], (int)a), exact_round(e));
            }
        }
    }
    et_surface_ders(F, &s, u, v, work, et_surface_work(&s));
    ok = ok && (d < 2 || !moderate(D, 6) || !moderate(F, 6) || six_within(g, &s, F, T, u, v));
    s.q = s.nv;
    D[0] = end;
    ok = ok && gen_check(g, et_exact_surface_ders(D, d, &s, u, v) == ET_EINVAL && same_point(D[0], end), "a surface that is not valid");
    s.q = 0;
    free(work);
    fmpq_clear(f);
    fmpq_clear(e);
    _fmpq_vec_clear(T, (slong)(4 * n));
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_exact_surface_grid(gen *g)
{
    et_surface s;
    et_vec3 S[2 * TALL + 1], P, end = {1.0, 2.0, 3.0};
    double a[TALL], b[6];
    bool tall = gen_chance(g, 30);             /* more rows than are computed at a time */
    size_t na = tall ? (size_t)gen_between(g, 60, TALL) : (size_t)gen_upto(g, 6), nb = (size_t)gen_upto(g, tall ? 2 : 6);
    if (!draw_surface(g, &s, 4)) {
        return SKIP;
    }
    for (size_t i = 0; i < na; i++) {
        a[i] = gen_chance(g, 10) ? 1e300 : gen_parameter(g, s.u, s.nu + s.p + 1, s.p);
    }
    for (size_t j = 0; j < nb; j++) {
        b[j] = gen_chance(g, 10) ? -1e300 : gen_parameter(g, s.v, s.nv + s.q + 1, s.q);
    }
    S[0] = S[na * nb] = end;
    bool ok =
        gen_check(g, et_exact_surface_grid(S, &s, a, na, b, nb) == ET_OK && same_point(S[na * nb], end), "status, or wrote beyond %zu x %zu", na, nb);
    for (size_t k = 0; ok && k < na * nb; k++) {
        ok = gen_check(g, et_exact_surface_point(&P, &s, a[k / nb], b[k % nb]) == ET_OK && same_point(P, S[k]), "point %zu of %zu x %zu: %a for %a",
                       k, na, nb, S[k].x, P.x);
    }
    S[0] = end;
    if (na > 0) {
        double old = a[na - 1];
        a[na - 1] = NAN;
        ok = ok && gen_check(g, et_exact_surface_grid(S, &s, a, na, b, nb) == ET_EINVAL && same_point(S[0], end), "a NaN among a");
        a[na - 1] = old;
    }
    if (nb > 0) {
        double old = b[nb - 1];
        b[nb - 1] = HUGE_VAL;
        ok = ok && gen_check(g, et_exact_surface_grid(S, &s, a, na, b, nb) == ET_EINVAL && same_point(S[0], end), "an infinity among b");
        b[nb - 1] = old;
    }
    s.u[0] = NAN;
    ok = ok && gen_check(g, et_exact_surface_grid(S, &s, a, na, b, nb) == ET_EINVAL && same_point(S[0], end), "a surface that is not valid");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* ---- golden rows: arguments as for the fast functions ---- */

static bool is(const row *r, const double *x, size_t n)
{
    bool ok = r->nwant == n;
    for (size_t k = 0; k < n; k++) {
        ok = row_is(r, k, x[k]) && ok;
    }
    return ok;
}

static bool are(const row *r, const et_vec3 *P, size_t n)
{
    bool ok = r->nwant == 3 * n;
    for (size_t k = 0; k < 3 * n; k++) {
        ok = row_is(r, k, coordinate(P[k / 3], (int)(k % 3))) && ok;
    }
    return ok;
}

/* degree, order, number of knots, knots, parameter. */
static verdict true_basis(const row *r, size_t d)
{
    size_t p = row_size(r, 0), nu = row_size(r, 2);
    if (p > 100 || d > 100 || nu + 4 != r->nargs) {
        return FAIL;
    }
    double *u = et_size_array(nu, sizeof *u), *D = et_size_array((d + 1) * (p + 1), sizeof *D), x = row_real(r, 3 + nu);
    for (size_t i = 0; i < nu; i++) {
        u[i] = row_real(r, 3 + i);
    }
    bool ok = et_knots_valid(u, nu, p) == 1;
    size_t span = ok ? et_knots_span(u, nu, p, x) : 0;
    ok = ok && (d == 0 ? et_exact_basis_eval(D, u, nu, p, span, x) : et_exact_basis_ders(D, d, u, nu, p, span, x)) == ET_OK;
    ok = ok && is(r, D + d * (p + 1), p + 1);
    free(u);
    free(D);
    return ok ? PASS : FAIL;
}

verdict true_basis_eval(const row *r)
{
    return true_basis(r, 0);
}

verdict true_basis_ders(const row *r)
{
    return true_basis(r, row_size(r, 1));
}

verdict true_curve_point(const row *r)
{
    et_curve c;
    et_vec3 C;
    size_t at = read_curve(r, &c);
    bool ok = at > 0 && et_exact_curve_point(&C, &c, row_real(r, at)) == ET_OK && are(r, &C, 1);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict true_curve_ders(const row *r)
{
    et_curve c;
    et_vec3 D[32];
    size_t at = read_curve(r, &c), k = row_size(r, at);
    bool ok = at > 0 && k < 32 && et_exact_curve_ders(D, k, &c, row_real(r, at + 1)) == ET_OK && are(r, D + k, 1);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict true_surface_point(const row *r)
{
    et_surface s;
    et_vec3 S;
    size_t at = read_surface(r, &s);
    bool ok = at > 0 && et_exact_surface_point(&S, &s, row_real(r, at), row_real(r, at + 1)) == ET_OK && are(r, &S, 1);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict true_surface_ders(const row *r)
{
    et_surface s;
    et_vec3 D[28];
    size_t at = read_surface(r, &s), k = row_size(r, at), d = 0;
    while ((d + 1) * (d + 2) / 2 <= k && d < 7) {
        d++;
    }
    bool ok = at > 0 && d < 7 && et_exact_surface_ders(D, d, &s, row_real(r, at + 1), row_real(r, at + 2)) == ET_OK && are(r, D + k, 1);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* After the surface: n, then u and v by turns. */
verdict true_surface_points(const row *r)
{
    et_surface s;
    size_t at = read_surface(r, &s), n = row_size(r, at++);
    et_vec3 *S = et_size_array(n, sizeof *S);
    bool ok = at > 1 && S;
    for (size_t k = 0; ok && k < n; k++) {
        ok = et_exact_surface_point(S + k, &s, row_real(r, at + 2 * k), row_real(r, at + 2 * k + 1)) == ET_OK;
    }
    ok = ok && are(r, S, n);
    free(S);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* After the surface: na, nb, the a, the b. */
verdict true_surface_grid(const row *r)
{
    et_surface s;
    size_t at = read_surface(r, &s), na = row_size(r, at), nb = row_size(r, at + 1);
    double *a = et_size_array(na, sizeof *a), *b = et_size_array(nb, sizeof *b);
    et_vec3 *S = et_size_array(na * nb, sizeof *S);
    bool ok = at > 0 && a && b && S;
    if (ok) {
        read_knots(r, b, nb, read_knots(r, a, na, at + 2));
        ok = et_exact_surface_grid(S, &s, a, na, b, nb) == ET_OK && are(r, S, na * nb);
    }
    free(a);
    free(b);
    free(S);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
