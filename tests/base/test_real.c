/* base/real: sums against exact integers and against the order in the header; golden rows.  The elementary functions: test_real_rounding.c. */
#include "etalon/base/real.h"
#include "gen.h"
#include "golden.h"
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
