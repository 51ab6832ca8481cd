/* exact/exact: rounding, sums, distances, frames: against MPFR, against ties made on purpose, and the fast functions within their bounds. */
#include "etalon/exact/exact.h"
#include "etalon/base/real.h"
#include "exact/exact_sums_parts.h"
#include "exact/live.h"
#include "golden.h"
#include <float.h>
#include <math.h>
#include <mpfr.h>
#include <string.h>

enum { TERMS = 300, ALL_BITS = 4400 };     /* squares of differences of doubles, and their sums, fit into so many bits */

static bool same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* Any finite double: small integers, numbers of one size, of any size, subnormals, the greatest. */
static double draw_any(gen *g)
{
    static const double ends[] = {0.0, DBL_MAX, DBL_MIN, 0x1p-1074, 0x0.fffffffffffffp-1022, 1.0, 0x1p970, 0x1p-1022};
    uint64_t kind = gen_upto(g, 5);
    double sign = gen_upto(g, 1) ? -1.0 : 1.0;
    if (kind == 0) {
        return sign * (double)gen_upto(g, 9);
    }
    if (kind == 1) {
        return sign * gen_real(g, 0.0, 1.0);
    }
    if (kind == 2) {
        return sign * ldexp(gen_real(g, 0.0, 1.0), (int)gen_upto(g, 2096) - 1073);
    }
    if (kind == 3) {
        return sign * ldexp((double)gen_upto(g, UINT64_C(1) << 53), -1074 + (int)gen_upto(g, 60));
    }
    return sign * (kind == 4 ? ends[gen_upto(g, 7)] : gen_real(g, 0x1p1023, DBL_MAX));
}

/* The double nearest to the number that MPFR rounded to y, 53 bits, on the side t of it: subnormals, overflow, and zero as +0. */
static double settled(mpfr_t y, int t)
{
    mpfr_exp_t lo = mpfr_get_emin(), hi = mpfr_get_emax();
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
    t = mpfr_check_range(y, t, MPFR_RNDN);
    mpfr_subnormalize(y, t, MPFR_RNDN);
    double x = mpfr_get_d(y, MPFR_RNDN);
    mpfr_set_emin(lo);
    mpfr_set_emax(hi);
    return x == 0.0 ? 0.0 : x;
}

/* ---- rounding ---- */

/* Two neighbouring doubles, from 0 to beyond the greatest, their middle and a bit that is small beside their distance; *even is the one of them that
 * a tie goes to. */
typedef struct { fmpq_t lo, hi, middle, bit; double x, y, even; } gap;

static void gap_init(gap *s, gen *g)
{
    uint64_t bits;
    s->x = fabs(draw_any(g));
    s->y = nextafter(s->x, HUGE_VAL);
    memcpy(&bits, &s->x, sizeof bits);
    s->even = bits % 2 == 0 ? s->x : s->y;
    fmpq_init(s->lo);
    fmpq_init(s->hi);
    fmpq_init(s->middle);
    fmpq_init(s->bit);
    exact_set(s->lo, s->x);
    if (isinf(s->y)) {
        exact_set(s->hi, 0x1p1023);
        fmpq_mul_2exp(s->hi, s->hi, 1);
    } else {
        exact_set(s->hi, s->y);
    }
    fmpq_add(s->middle, s->lo, s->hi);
    fmpq_div_2exp(s->middle, s->middle, 1);
    fmpq_sub(s->bit, s->hi, s->lo);
    fmpq_div_2exp(s->bit, s->bit, (flint_bitcnt_t)gen_between(g, 2, 200));
    if (gen_upto(g, 1)) {                      /* not a dyadic number */
        fmpz_mul_ui(fmpq_denref(s->bit), fmpq_denref(s->bit), 3);
        fmpq_canonicalise(s->bit);
    }
}

static void gap_clear(gap *s)
{
    fmpq_clear(s->lo);
    fmpq_clear(s->hi);
    fmpq_clear(s->middle);
    fmpq_clear(s->bit);
}

/* q rounds to x, and -q to -x. */
static bool rounds(gen *g, fmpq_t q, double x, const char *what)
{
    double got = exact_round(q);
    fmpq_neg(q, q);
    double minus = exact_round(q);
    fmpq_neg(q, q);
    return gen_check(g, same(got, x) && same(minus, x == 0.0 ? 0.0 : -x), "%s: %a and %a for %a", what, got, minus, x);
}

static bool rounds_root(gen *g, const fmpq_t q, double x, const char *what)
{
    double got = exact_round_sqrt(q);
    return gen_check(g, same(got, x), "the root of the square of %s: %a for %a", what, got, x);
}

/* What a sum is rounded by: between two neighbours all goes to the nearer one, the middle to the even one, roots likewise. */
verdict prop_exact_real_sum_rounding(gen *g)
{
    gap s;
    fmpq_t q, square;
    gap_init(&s, g);
    fmpq_init(q);
    fmpq_init(square);
    bool ok = rounds(g, s.lo, s.x, "a double") && rounds(g, s.middle, s.even, "a tie") && rounds(g, s.hi, s.y, "its neighbour");
    fmpq_mul(square, s.lo, s.lo);
    ok = ok && rounds_root(g, square, s.x, "a double");
    fmpq_mul(square, s.middle, s.middle);
    ok = ok && rounds_root(g, square, s.even, "a tie");
    for (int side = 0; ok && side < 4; side++) {
        const fmpq *from = side == 0 ? s.lo : side == 3 ? s.hi : s.middle;
        if (side % 2 == 0) {
            fmpq_add(q, from, s.bit);
        } else {
            fmpq_sub(q, from, s.bit);
        }
        fmpq_mul(square, q, q);
        double want = side == 0 || side == 1 ? s.x : s.y;
        ok = rounds(g, q, want, side < 2 ? "below the middle" : "above the middle");
        ok = ok && rounds_root(g, square, want, side < 2 ? "a number below the middle" : "a number above the middle");
    }
    fmpq_clear(q);
    fmpq_clear(square);
    gap_clear(&s);
    return ok ? PASS : FAIL;
}

/* The ball around mid, a number of finitely many bits, of radius 2^e rounds to `want`, or to nothing (NaN), and so does its negative. */
static bool ball_rounds(gen *g, const fmpq_t mid, slong e, double want, const char *what)
{
    arb_t ball;
    double x = 4711.0, y = 4711.0;
    arb_init(ball);
    arf_set_fmpz(arb_midref(ball), fmpq_numref(mid));
    arf_mul_2exp_si(arb_midref(ball), arb_midref(ball), -(slong)fmpz_val2(fmpq_denref(mid)));
    mag_set_ui_2exp_si(arb_radref(ball), 1, e);
    int plus = exact_round_ball(&x, ball);
    arb_neg(ball, ball);
    int minus = exact_round_ball(&y, ball);
    arb_clear(ball);
    if (isnan(want)) {
        return gen_check(g, !plus && !minus && x == 4711.0 && y == 4711.0, "a ball %s is rounded to %a, %a", what, x, y);
    }
    return gen_check(g, plus == 1 && minus == 1 && same(x, want) && same(y, want == 0.0 ? 0.0 : -want), "a ball %s: %d %a, %d %a for %a", what, plus,
                     x, minus, y, want);
}

/* A ball is rounded where all of it rounds to one double, its ends included, and not across a middle. */
verdict prop_exact_real_sum_ball(gen *g)
{
    gap s;
    arb_t ball;
    fmpq_t q;
    double x = 4711.0;
    slong k = (slong)gen_between(g, 2, 200);
    gap_init(&s, g);
    fmpq_init(q);
    arb_init(ball);
    fmpq_sub(q, s.hi, s.lo);
    slong e = exact_place(WORD_MAX, exact_round(q)) + 52 - k;      /* the distance of the doubles is 2^(e+k) */
    fmpq_set_si(q, 1, 1);
    exact_scale(q, e);
    fmpq_sub(q, s.middle, q);
    bool ok = ball_rounds(g, q, e - 1, s.x, "below the middle") && ball_rounds(g, q, e + 1, NAN, "across the middle");
    ok = ok && ball_rounds(g, q, e, s.even == s.x ? s.x : NAN, "up to the middle");
    fmpq_sub(q, s.middle, q);
    fmpq_add(q, s.middle, q);
    ok = ok && ball_rounds(g, q, e - 1, s.y, "above the middle") && ball_rounds(g, q, e + 1, NAN, "across the middle from above");
    ok = ok && ball_rounds(g, q, e, s.even == s.y ? s.y : NAN, "down to the middle");
    fmpq_zero(q);
    ok = ok && ball_rounds(g, q, -1075, 0.0, "around zero") && ball_rounds(g, q, -1074, NAN, "beyond half the least number");
    arb_pos_inf(ball);
    ok = ok && gen_check(g, exact_round_ball(&x, ball) == 0, "infinity is rounded");
    arb_zero_pm_inf(ball);
    ok = ok && gen_check(g, exact_round_ball(&x, ball) == 0, "everything is rounded");
    arb_indeterminate(ball);
    ok = ok && gen_check(g, exact_round_ball(&x, ball) == 0 && x == 4711.0, "nothing is rounded");
    arb_clear(ball);
    fmpq_clear(q);
    gap_clear(&s);
    return ok ? PASS : FAIL;
}

/* ---- sums ---- */

static size_t draw_terms(gen *g, double *x)
{
    size_t n = gen_chance(g, 20) ? (size_t)gen_between(g, 120, TERMS) : (size_t)gen_upto(g, 24);
    bool one_size = gen_upto(g, 1) == 0;
    for (size_t k = 0; k < n; k++) {
        uint64_t kind = k > 0 ? gen_upto(g, 5) : 0;
        double old = k > 0 ? x[gen_upto(g, k - 1)] : 0.0;
        x[k] = one_size ? gen_real(g, -1.0, 1.0) : draw_any(g);
        if (kind == 4) {                       /* what cancels */
            x[k] = -old;
        }
        if (kind == 5 && old != 0.0) {         /* half an ulp: ties */
            x[k] = ldexp(old > 0.0 ? 0.5 : -0.5, ilogb(old) - 52);
        }
    }
    return n;
}

static double by_mpfr(const double *x, size_t n)
{
    static mpfr_t t[TERMS];
    static mpfr_ptr p[TERMS];
    mpfr_t y;
    mpfr_init2(y, 53);
    for (size_t k = 0; k < n; k++) {
        mpfr_init2(t[k], 53);
        mpfr_set_d(t[k], x[k], MPFR_RNDN);
        p[k] = t[k];
    }
    double s = settled(y, mpfr_sum(y, p, (unsigned long)n, MPFR_RNDN));
    for (size_t k = 0; k < n; k++) {
        mpfr_clear(t[k]);
    }
    mpfr_clear(y);
    return s;
}

/* |fast - sum x| <= ((1+u)^m - 1) sum |x|, in rationals. */
static bool sum_within(double fast, const double *x, size_t n)
{
    fmpq_t sum, size, t, u;
    slong m = 18;
    for (size_t blocks = 1; blocks * 128 < n; blocks *= 2) {
        m++;
    }
    fmpq_init(sum);
    fmpq_init(size);
    fmpq_init(t);
    fmpq_init(u);
    for (size_t k = 0; k < n; k++) {
        exact_set(t, x[k]);
        fmpq_add(sum, sum, t);
        fmpq_abs(t, t);
        fmpq_add(size, size, t);
    }
    exact_set(t, 1.0 + ET_EPS);
    exact_set(u, ET_UNIT);
    fmpq_sub(u, t, u);                         /* 1 + u is not a double */
    fmpq_pow_si(u, u, m);
    exact_set(t, 1.0);
    fmpq_sub(u, u, t);
    fmpq_mul(size, size, u);
    exact_set(t, fast);
    fmpq_sub(t, t, sum);
    fmpq_abs(t, t);
    bool ok = fmpq_cmp(t, size) <= 0;
    fmpq_clear(sum);
    fmpq_clear(size);
    fmpq_clear(t);
    fmpq_clear(u);
    return ok;
}

verdict prop_exact_real_sum(gen *g)
{
    double x[TERMS], y[TERMS];
    size_t n = draw_terms(g, x);
    live_begin(n);
    double s = et_exact_real_sum(x, n);
    bool kept = !live_end();
    double want = by_mpfr(x, n), fast = et_real_sum(x, n);
    bool ok = gen_check(g, !kept && same(s, want), "%zu terms: %a, by MPFR %a", n, s, want) && gen_check(g, n > 0 || same(s, 0.0), "nothing gives %a", s);
    for (size_t k = 0; k < n; k++) {
        y[k] = -x[n - 1 - k];
    }
    double back = et_exact_real_sum(y, n);
    ok = ok && gen_check(g, same(back, s == 0.0 ? 0.0 : -s), "backwards and negative: %a", back);
    ok = ok && (!isfinite(fast) || gen_check(g, sum_within(fast, x, n), "et_real_sum gives %a for %a, beyond its bound", fast, s));
    for (size_t k = 0; k < n; k++) {           /* integers: no rounding in any order */
        x[k] = (double)(k * 7919 % 1001) - 500.0;
    }
    s = et_exact_real_sum(x, n);
    return ok && gen_check(g, s == et_real_sum(x, n), "%zu integers: %a", n, s) ? PASS : FAIL;
}

/* 1, half a unit of its last place, and as good as nothing to decide, in any order and with any neighbours in memory. */
verdict prop_exact_real_sum_least(gen *g)
{
    double x[5] = {1.0, 0.0, 0.0, 0.0, 1.0}, least = ldexp(gen_upto(g, 1) ? -1.0 : 1.0, -160 - (int)gen_upto(g, 900));
    size_t at = (size_t)gen_upto(g, 2), half = (at + 1 + (size_t)gen_upto(g, 1)) % 3;
    x[1 + at] = least;
    x[1 + half] = 0x1p-53;
    x[1 + 3 - at - half] = 1.0;
    double s = et_exact_real_sum(x + 1, 3);
    return gen_check(g, s == (least > 0.0 ? 1.0 + 0x1p-52 : 1.0), "%a + ..: %a", least, s) ? PASS : FAIL;
}

/* ---- distances ---- */

static et_vec3 draw_point(gen *g)
{
    double scale = ldexp(1.0, (int)gen_upto(g, 1) * ((int)gen_upto(g, 1800) - 900));
    et_vec3 P;
    if (gen_chance(g, 4)) {
        return (et_vec3){draw_any(g), draw_any(g), draw_any(g)};
    }
    P.x = gen_real(g, -1.0, 1.0) * scale;
    P.y = gen_real(g, -1.0, 1.0) * scale;
    P.z = gen_real(g, -1.0, 1.0) * scale;
    return P;
}

static double distance_by_mpfr(et_vec3 a, et_vec3 b)
{
    const double from[3] = {a.x, a.y, a.z}, to[3] = {b.x, b.y, b.z};
    mpfr_t d, t, sum, y;
    mpfr_inits2(ALL_BITS, d, t, sum, (mpfr_ptr)0);
    mpfr_init2(y, 53);
    mpfr_set_zero(sum, 1);
    for (int k = 0; k < 3; k++) {
        mpfr_set_d(d, from[k], MPFR_RNDN);
        mpfr_sub_d(d, d, to[k], MPFR_RNDN);
        mpfr_sqr(t, d, MPFR_RNDN);
        mpfr_add(sum, sum, t, MPFR_RNDN);      /* all exact */
    }
    double r = settled(y, mpfr_sqrt(y, sum, MPFR_RNDN));
    mpfr_clears(d, t, sum, y, (mpfr_ptr)0);
    return r;
}

verdict prop_exact_vec3_distance(gen *g)
{
    et_vec3 a = draw_point(g), b = gen_chance(g, 10) ? a : draw_point(g);
    if (gen_chance(g, 4)) {                    /* near each other */
        b = (et_vec3){nextafter(a.x, b.x), gen_upto(g, 1) ? a.y : nextafter(a.y, b.y), a.z};
    }
    live_begin(gen_upto(g, 7));
    double d = et_exact_vec3_distance(a, b);
    bool kept = !live_end();
    double want = distance_by_mpfr(a, b), fast = et_vec3_distance(a, b);
    bool ok =
        gen_check(g, !kept && same(d, want), "%a, by MPFR %a", d, want) && gen_check(g, same(d, et_exact_vec3_distance(b, a)), "from b to a another distance");
    /* 3.5u to first order, and the exact one is rounded: half an ulp, u.  Differences beyond 2^500 have squares that overflow, below 2^-500
     * underflow. */
    if (d > 0x1p-450 && d < 0x1p500) {
        ok = ok && gen_check(g, fabs(fast - d) <= 4.5 * ET_UNIT * (1.0 + 0x1p-40) * d, "et_vec3_distance gives %a for %a", fast, d);
        gen_label(g, "in range");
    }
    return ok ? PASS : FAIL;
}

/* Pythagorean quadruples: integers all the way, so no rounding in the fast one either; and a root that ends with the middle of two doubles. */
verdict prop_exact_vec3_distance_integers(gen *g)
{
    int64_t m = (int64_t)gen_upto(g, 1000), n = (int64_t)gen_upto(g, 1000), p = (int64_t)gen_upto(g, 1000), q = (int64_t)gen_upto(g, 1000);
    int e = (int)gen_upto(g, 400) - 200;
    et_vec3 a = {(double)(m * m + n * n - p * p - q * q), (double)(2 * (m * q + n * p)), (double)(2 * (n * q - m * p))}, zero = {0.0, 0.0, 0.0};
    double r = (double)(m * m + n * n + p * p + q * q), d = et_exact_vec3_distance(a, zero), fast = et_vec3_distance(a, zero);
    bool ok = gen_check(g, d == r && fast == r, "%g: %a, fast %a", r, d, fast);
    a = (et_vec3){ldexp(a.x, e), ldexp(a.y, e), ldexp(a.z, e)};
    ok = ok && gen_check(g, et_exact_vec3_distance(zero, a) == ldexp(r, e), "times 2^%d", e);
    /* 3^2 + 4^2 = 5^2 with 5t between two doubles: t odd with 52 bits or so. */
    double t = (double)(2 * gen_upto(g, UINT64_C(1) << 50) + (UINT64_C(1) << 51) + 1), want = 5.0 * t;
    et_vec3 b = {3.0 * t, 4.0 * t, 0.0};
    ok = ok && (3.0 * t > 0x1p53 || gen_check(g, et_exact_vec3_distance(b, zero) == want, "5 * %a: %a", t, et_exact_vec3_distance(b, zero)));
    return ok ? PASS : FAIL;
}

/* ---- frames ---- */

static double component(et_vec3 P, int a)
{
    return a == 0 ? P.x : a == 1 ? P.y : P.z;
}

static double to_unit_by_mpfr(double own, double offset, double scale)
{
    mpfr_t d, y;
    mpfr_init2(d, ALL_BITS);
    mpfr_init2(y, 53);
    mpfr_set_d(d, own, MPFR_RNDN);
    mpfr_sub_d(d, d, offset, MPFR_RNDN);
    double x = settled(y, mpfr_div_d(y, d, scale, MPFR_RNDN));
    mpfr_clears(d, y, (mpfr_ptr)0);
    return x;
}

static double from_unit_by_mpfr(double unit, double offset, double scale)
{
    mpfr_t a, b, c, y;
    mpfr_inits2(53, a, b, c, y, (mpfr_ptr)0);
    mpfr_set_d(a, unit, MPFR_RNDN);
    mpfr_set_d(b, scale, MPFR_RNDN);
    mpfr_set_d(c, offset, MPFR_RNDN);
    double x = settled(y, mpfr_fma(y, a, b, c, MPFR_RNDN));
    mpfr_clears(a, b, c, y, (mpfr_ptr)0);
    return x;
}

static bool draw_frame(gen *g, et_frame *f, et_vec3 *P, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        P[k] = draw_point(g);
    }
    if (gen_upto(g, 1)) {
        return et_frame_of(f, P, n, (et_frame_kind)gen_upto(g, 2)) == ET_OK;
    }
    f->offset = draw_point(g);
    f->scale = draw_point(g);
    f->scale = (et_vec3){fabs(f->scale.x), fabs(f->scale.y), fabs(f->scale.z)};
    return f->scale.x > 0.0 && f->scale.y > 0.0 && f->scale.z > 0.0;
}

verdict prop_exact_frame_to_unit(gen *g)
{
    et_vec3 P[4], Q[4], F[4];
    et_frame f, none = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
    size_t n = (size_t)gen_between(g, 1, 3);
    if (!draw_frame(g, &f, P, 4)) {
        return SKIP;
    }
    memcpy(Q, P, sizeof P);
    memcpy(F, P, sizeof P);
    live_begin(n + 1);
    et_exact_frame_to_unit(Q, n, &f);
    bool kept = !live_end();
    et_frame_to_unit(F, n, &f);
    bool ok = gen_check(g, !kept && memcmp(Q + n, P + n, sizeof *P) == 0, "wrote beyond %zu points", n);
    for (size_t k = 0; k < 3 * n; k++) {
        double x = component(P[k / 3], (int)(k % 3)), o = component(f.offset, (int)(k % 3)), s = component(f.scale, (int)(k % 3));
        double got = component(Q[k / 3], (int)(k % 3)), fast = component(F[k / 3], (int)(k % 3)), want = to_unit_by_mpfr(x, o, s);
        ok = ok && gen_check(g, same(got, want), "(%a - %a) / %a: %a, by MPFR %a", x, o, s, got, want);
        /* 2u + u^2, and the exact one is rounded. */
        bool bounded = fabs(got) > 0x1p-1000 && fabs(got) < 0x1p1000 && fabs(x) < 0x1p1000 && fabs(o) < 0x1p1000;
        ok = ok &&
             (!bounded || gen_check(g, fabs(fast - got) <= 3.0 * ET_UNIT * (1.0 + 0x1p-40) * fabs(got), "the fast one gives %a for %a", fast, got));
    }
    memcpy(Q, P, sizeof P);
    et_exact_frame_to_unit(Q, n, &none);
    for (size_t k = 0; k < n; k++) {
        ok = ok && gen_check(g, Q[k].x == P[k].x && Q[k].y == P[k].y && Q[k].z == P[k].z, "the frame of offset 0 and scale 1 moves point %zu", k);
    }
    return ok ? PASS : FAIL;
}

verdict prop_exact_frame_from_unit(gen *g)
{
    et_vec3 P[4], Q[4], F[4];
    et_frame f, none = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
    size_t n = (size_t)gen_between(g, 1, 3);
    if (!draw_frame(g, &f, P, 4)) {
        return SKIP;
    }
    memcpy(Q, P, sizeof P);
    memcpy(F, P, sizeof P);
    live_begin(n + 1);
    et_exact_frame_from_unit(Q, n, &f);
    bool kept = !live_end();
    et_frame_from_unit(F, n, &f);
    bool ok = gen_check(g, !kept && memcmp(Q + n, P + n, sizeof *P) == 0, "wrote beyond %zu points", n);
    for (size_t k = 0; k < 3 * n; k++) {
        double x = component(P[k / 3], (int)(k % 3)), o = component(f.offset, (int)(k % 3)), s = component(f.scale, (int)(k % 3));
        double got = component(Q[k / 3], (int)(k % 3)), fast = component(F[k / 3], (int)(k % 3)), want = from_unit_by_mpfr(x, o, s);
        ok = ok && gen_check(g, same(got, want), "%a + %a * %a: %a, by MPFR %a", o, s, x, got, want);
        /* fl(o + fl(s x)): u |s x|, u of the sum, and the exact one is rounded. */
        double bound = ET_UNIT * (1.0 + 0x1p-40) * (fabs(s * x) + fabs(fast) + fabs(got)) + 0x1p-1073;
        ok = ok && (!isfinite(bound) || gen_check(g, fabs(fast - got) <= bound, "the fast one gives %a for %a", fast, got));
    }
    memcpy(Q, P, sizeof P);
    et_exact_frame_from_unit(Q, n, &none);
    for (size_t k = 0; k < n; k++) {
        ok = ok && gen_check(g, Q[k].x == P[k].x && Q[k].y == P[k].y && Q[k].z == P[k].z, "the frame of offset 0 and scale 1 moves point %zu", k);
    }
    return ok ? PASS : FAIL;
}

/* ---- golden rows ---- */

verdict true_real_sum(const row *r)
{
    double x[TERMS];
    for (size_t k = 0; k < r->nargs; k++) {
        if (k == TERMS) {
            return FAIL;
        }
        x[k] = row_real(r, k);
        if (!isfinite(x[k])) {                 /* what IEEE 754 says: not a sum */
            return SKIP;
        }
    }
    return row_is(r, 0, et_exact_real_sum(x, r->nargs)) ? PASS : FAIL;
}

/* n terms start + i step. */
verdict true_real_sum_ramp(const row *r)
{
    enum { MOST = 20000 };
    static double x[MOST];
    size_t n = row_size(r, 0);
    double start = row_real(r, 1), step = row_real(r, 2);
    for (size_t k = 0; k < n && k < MOST; k++) {
        x[k] = start + (double)k * step;
    }
    return n <= MOST && row_is(r, 0, et_exact_real_sum(x, n)) ? PASS : FAIL;
}

verdict true_vec3_distance(const row *r)
{
    et_vec3 a = {row_real(r, 0), row_real(r, 1), row_real(r, 2)}, b = {row_real(r, 3), row_real(r, 4), row_real(r, 5)};
    return row_is(r, 0, et_exact_vec3_distance(a, b)) ? PASS : FAIL;
}

/* offset, scale, coordinate; wanted: the coordinate on the other side, the same on each axis. */
static verdict one_way(const row *r, void (*map)(et_vec3 *points, size_t n, const et_frame *frame))
{
    double o = row_real(r, 0), s = row_real(r, 1), x = row_real(r, 2);
    et_frame f = {{o, o, o}, {s, s, s}};
    et_vec3 P = {x, x, x};
    map(&P, 1, &f);
    return row_is(r, 0, P.x) && row_is(r, 0, P.y) && row_is(r, 0, P.z) ? PASS : FAIL;
}

verdict true_frame_to_unit(const row *r)
{
    return one_way(r, et_exact_frame_to_unit);
}

verdict true_frame_from_unit(const row *r)
{
    return one_way(r, et_exact_frame_from_unit);
}
