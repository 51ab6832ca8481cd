/* base/real: sums against exact integers and against the order in the header; elementary functions against identities and golden rows. */
#include "etalon/base/real.h"
#include "gen.h"
#include "golden.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { MOST = 1300 };

static bool same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static size_t draw_count(gen *g)
{
    switch (gen_upto(g, 3)) {
    case 0:
        return (size_t)gen_upto(g, 20);
    case 1:
        return 128 * (size_t)gen_upto(g, 9) + (size_t)gen_upto(g, 2);
    case 2:
        return 128 * (size_t)gen_between(g, 1, 9) - (size_t)gen_between(g, 1, 9);
    default:
        return (size_t)gen_upto(g, MOST);
    }
}

/* Roundings a term passes at most, as the header says. */
static double roundings(size_t n)
{
    double m = 18.0;
    for (size_t blocks = (n + 127) / 128, reach = 1; reach < blocks; reach *= 2) {
        m += 1.0;
    }
    return m;
}

/* Integers below 2^50: their sum is exact in 64 bits, and every partial sum in doubles is an integer. */
verdict prop_real_sum(gen *g)
{
    double x[MOST];
    int64_t exact = 0;
    double size = 0.0;
    size_t n = draw_count(g);
    uint64_t max = (UINT64_C(1) << gen_upto(g, 50)) - 1, seed = gen_upto(g, UINT64_MAX);
    for (size_t i = 0; i < n; i++) {
        seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        int64_t k = (int64_t)((seed >> 13) & max);
        k = seed >> 63 ? -k : k;
        x[i] = (double)k;
        exact += k;
        size += fabs(x[i]);
    }
    double sum = et_real_sum(x, n), error = fabs((double)((int64_t)sum - exact));
    /* |error| <= ((1+u)^m - 1) size; 1 + 2^-30 covers second order and the rounding of `size`. */
    double bound = roundings(n) * ET_UNIT * size * (1.0 + 0x1p-30);
    bool ok = gen_check(g, error <= bound, "n = %zu: error %g above %g", n, error, bound);
    ok = ok && gen_check(g, size >= 0x1p53 || error == 0.0, "n = %zu: small integers add exactly, error %g", n, error);
    ok = ok && gen_check(g, n > 0 || same(sum, 0.0), "nothing sums to %g", sum);
    return ok ? PASS : FAIL;
}

/* The order of the header, written again without lanes or recursion on pointers. */
static double block_again(const double *x, size_t n)
{
    double lane[8], rest = 0.0;
    size_t full = n / 8 * 8;
    for (size_t k = 0; k < 8; k++) {
        lane[k] = 0.0;
        for (size_t i = k; i < full; i += 8) {
            lane[k] += x[i];
        }
    }
    for (size_t i = full; i < n; i++) {
        rest += x[i];
    }
    return (((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]))) + rest;
}

static double sum_again(const double *x, size_t from, size_t to)
{
    size_t whole = (to - from) / 128;
    if (to - from <= 128) {
        return block_again(x + from, to - from);
    }
    size_t middle = from + 128 * (whole - whole / 2);
    return sum_again(x, from, middle) + sum_again(x, middle, to);
}

verdict prop_real_sum_order(gen *g)
{
    double x[MOST];
    size_t n = draw_count(g);
    uint64_t seed = gen_upto(g, UINT64_MAX), range = gen_upto(g, 60);
    for (size_t i = 0; i < n; i++) {
        seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        x[i] = ldexp((double)(int64_t)seed, range ? (int)((seed >> 20) % range) : 0);
    }
    double a = et_real_sum(x, n), b = sum_again(x, 0, n);
    return gen_check(g, same(a, b), "n = %zu: %a, in the header's order %a", n, a, b) ? PASS : FAIL;
}

/* The library's bound, at most one ulp = 2u relative, is what these identities rest on. */
verdict prop_real_exp(gen *g)
{
    double x = gen_real(g, 0.0, 700.0);
    double a = et_real_exp(x), b = et_real_exp(-x);
    bool ok = gen_check(g, a >= 1.0 && b <= 1.0 && b > 0.0, "exp(%a) = %a, exp(-x) = %a", x, a, b);
    ok = ok && gen_check(g, fabs(a * b - 1.0) <= 5.01 * ET_UNIT, "exp(x) exp(-x) - 1 = %g at %a", a * b - 1.0, x);
    double h = et_real_exp(0.5 * x);
    ok = ok && gen_check(g, fabs(h * h - a) <= 7.01 * ET_UNIT * a, "exp(x/2)^2 and exp(x) differ at %a", x);
    ok = ok && gen_check(g, et_real_exp(0.0) == 1.0, "exp(0) is not 1");
    return ok ? PASS : FAIL;
}

/* ln 2^k x = k ln 2 + ln x; the terms' errors are relative to each. */
verdict prop_real_log(gen *g)
{
    double x = gen_real(g, 1.0, 2.0), k = (double)gen_upto(g, 1000);
    double a = et_real_log(ldexp(x, (int)k)), b = et_real_log(x), l = et_real_log(2.0);
    /* 2u each for a, b, l; one for the product; one for the sum. */
    double bound = 6.01 * ET_UNIT * (fabs(a) + fabs(b) + k * l);
    bool ok = gen_check(g, fabs(a - (k * l + b)) <= bound, "ln(2^%g %a) = %a", k, x, a);
    ok = ok && gen_check(g, et_real_log(1.0) == 0.0 && et_real_log(0.0) == -HUGE_VAL && isnan(et_real_log(-1.0)), "ln at 1, 0, -1");
    ok = ok && gen_check(g, fabs(et_real_log(et_real_exp(k)) - k) <= 2.01 * ET_UNIT * (1.0 + k) || k > 700.0, "ln exp %g", k);
    return ok ? PASS : FAIL;
}

verdict prop_real_pow(gen *g)
{
    double x = gen_real(g, 0x1p-4, 16.0);
    bool ok = gen_check(g, fabs(et_real_pow(x, 2.0) - x * x) <= 3.01 * ET_UNIT * x * x, "%a ^ 2", x);
    ok = ok && gen_check(g, fabs(et_real_pow(x, 3.0) - x * x * x) <= 4.01 * ET_UNIT * x * x * x, "%a ^ 3", x);
    ok = ok && gen_check(g, fabs(et_real_pow(x, 0.5) - sqrt(x)) <= 3.01 * ET_UNIT * sqrt(x), "%a ^ 1/2", x);
    ok = ok && gen_check(g, fabs(et_real_pow(x, -1.0) - 1.0 / x) <= 3.01 * ET_UNIT / x, "%a ^ -1", x);
    ok = ok && gen_check(g, et_real_pow(x, 0.0) == 1.0 && et_real_pow(1.0, x) == 1.0 && et_real_pow(0.0, x) == 0.0, "0 and 1 with %a", x);
    return ok ? PASS : FAIL;
}

/* s^2 + c^2: 5u each relative, together 1, and one rounding. */
verdict prop_real_sin(gen *g)
{
    double x = gen_real(g, 0.0, 1000.0), s = et_real_sin(x), c = et_real_cos(x);
    bool ok = gen_check(g, fabs(s * s + c * c - 1.0) <= 6.01 * ET_UNIT, "sin^2 + cos^2 at %a", x);
    ok = ok && gen_check(g, et_real_sin(-x) == -s && et_real_sin(0.0) == 0.0, "sin is odd, at %a", x);
    /* sin 2x = 2 sin x cos x: 2u, 2u, one product; the left side 2u. */
    ok = ok && gen_check(g, fabs(et_real_sin(2.0 * x) - 2.0 * s * c) <= 7.01 * ET_UNIT * fabs(2.0 * s * c) + DBL_MIN, "sin 2x at %a", x);
    return ok ? PASS : FAIL;
}

/* cos 2x = c^2 - s^2, each within 5u, the difference and the left side within 3u of at most 1. */
verdict prop_real_cos(gen *g)
{
    double x = gen_real(g, 0.0, 1000.0), s = et_real_sin(x), c = et_real_cos(x);
    bool ok = gen_check(g, fabs(et_real_cos(2.0 * x) - (c * c - s * s)) <= 8.01 * ET_UNIT, "cos 2x at %a", x);
    ok = ok && gen_check(g, et_real_cos(-x) == c && et_real_cos(0.0) == 1.0, "cos is even, at %a", x);
    return ok ? PASS : FAIL;
}

verdict gold_real_sum(const row *r)
{
    double x[MOST];
    size_t n = r->nargs < MOST ? r->nargs : MOST;
    for (size_t i = 0; i < n; i++) {
        x[i] = row_real(r, i);
    }
    return row_is(r, 0, et_real_sum(x, n)) ? PASS : FAIL;
}

/* n terms start + i step, too many to write down. */
verdict gold_real_sum_ramp(const row *r)
{
    double x[MOST];
    size_t n = row_size(r, 0);
    for (size_t i = 0; i < n && i < MOST; i++) {
        x[i] = row_real(r, 1) + (double)i * row_real(r, 2);
    }
    return row_is(r, 0, et_real_sum(x, n)) ? PASS : FAIL;
}

verdict gold_real_exp(const row *r)
{
    return row_is(r, 0, et_real_exp(row_real(r, 0))) ? PASS : FAIL;
}

verdict gold_real_log(const row *r)
{
    return row_is(r, 0, et_real_log(row_real(r, 0))) ? PASS : FAIL;
}

verdict gold_real_pow(const row *r)
{
    return row_is(r, 0, et_real_pow(row_real(r, 0), row_real(r, 1))) ? PASS : FAIL;
}

verdict gold_real_sin(const row *r)
{
    return row_is(r, 0, et_real_sin(row_real(r, 0))) ? PASS : FAIL;
}

verdict gold_real_cos(const row *r)
{
    return row_is(r, 0, et_real_cos(row_real(r, 0))) ? PASS : FAIL;
}
