/* base/real: relations between calls, which follow from correct rounding: what a function undoes, what rises with its argument, what powers of two
 * and signs do, squares of sine and cosine.  u = 2^-53. */
#include "etalon/base/real.h"
#include "gen.h"
#include <math.h>
#include <string.h>

enum { MOST = 700 };

static bool same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* Of any size from 2^low to 2^high. */
static double sized(gen *g, int low, int high)
{
    return ldexp(1 + (double)gen_upto(g, UINT64_C(0xfffffffffffff)) * 0x1p-52, low + (int)gen_upto(g, (uint64_t)(high - low)));
}

/* exp is off by u of itself, which the logarithm sees as u, and rounds once more.  The other way round an error of u |log x| becomes a factor. */
verdict prop_real_log_back(gen *g)
{
    const double x = gen_real(g, -700, 700), y = sized(g, -1000, 1000), l = et_real_log(y), back = et_real_log(et_real_exp(x));
    bool ok = gen_check(g, fabs(back - x) <= (1 + fabs(x)) * ET_UNIT * (1 + 0x1p-30), "log(exp(%a)) = %a", x, back);

    if (fabs(l) < 700)
        ok = ok && gen_check(g, fabs(et_real_exp(l) - y) <= (1 + fabs(l)) * ET_UNIT * (1 + 0x1p-30) * y, "exp(log(%a)) = %a", y, et_real_exp(l));
    return ok ? PASS : FAIL;
}

/* Rounding keeps the order. */
verdict prop_real_exp_rises(gen *g)
{
    const double x = gen_real(g, -740, 709), y = gen_upto(g, 1) ? nextafter(x, 710) : x + gen_real(g, 0, 1), a = sized(g, -1000, 1000),
            b = nextafter(a, HUGE_VAL);
    bool ok = gen_check(g, et_real_exp(x) <= et_real_exp(y), "exp falls from %a to %a", x, y);

    ok = ok && gen_check(g, et_real_log(a) <= et_real_log(b), "log falls at %a", a);
    ok = ok && gen_check(g, et_real_pow(a, 0.8) <= et_real_pow(b, 0.8) && et_real_pow(a, -0.5) >= et_real_pow(b, -0.5), "a power turns at %a", a);
    return ok && gen_check(g, a < 1 || et_real_pow(a, fabs(x) * 0x1p-10) <= et_real_pow(a, fabs(x) * 0x1p-9), "powers of %a", a) ? PASS : FAIL;
}

/* Squares, reciprocals and roots are single operations of IEEE 754, correctly rounded, too; and x^y x^-y is 1 but for three roundings. */
verdict prop_real_pow_powers(gen *g)
{
    const double x = sized(g, -500, 500), y = gen_real(g, -1.3, 1.3), one = et_real_pow(x, y) * et_real_pow(x, -y);
    bool ok = gen_check(g, same(et_real_pow(x, 1), x) && same(et_real_pow(x, 2), x * x) && same(et_real_pow(x, -1), 1 / x), "whole powers of %a", x);

    ok = ok && gen_check(g, same(et_real_pow(x, 0.5), sqrt(x)) && same(et_real_pow(-x, 2), x * x) && same(et_real_pow(-x, -1), -1 / x),
            "powers of %a", x);
    return ok && gen_check(g, fabs(one - 1) <= 3 * ET_UNIT * (1 + 0x1p-30) + ET_UNIT, "%a to the powers +-%a: %a", x, y, one) ? PASS : FAIL;
}

/* x^y is exp(y log x): u |y log x| of the logarithm and as much of the product, as factors, and both results' roundings. */
verdict prop_real_pow_by_exp(gen *g)
{
    const double x = sized(g, -60, 60), y = gen_real(g, -10, 10), w = y * et_real_log(x), a = et_real_pow(x, y), b = et_real_exp(w);

    return gen_check(g, fabs(a - b) <= 2 * (1 + fabs(w)) * ET_UNIT * (1 + 0x1p-20) * a, "%a ^ %a: %a, by exp %a", x, y, a, b) ? PASS : FAIL;
}

/* Squares of numbers u off are 2u off, and three roundings follow, of which those of the squares share 1. */
verdict prop_real_sin_cos(gen *g)
{
    const double x = gen_upto(g, 1) ? gen_real(g, -4096, 4096) : sized(g, -40, 1000), s = et_real_sin(x), c = et_real_cos(x);
    bool ok = gen_check(g, same(et_real_sin(-x), -s) && same(et_real_cos(-x), c), "signs at %a", x);

    return ok && gen_check(g, fabs(s * s + c * c - 1) <= 4 * ET_UNIT * (1 + 0x1p-30), "squares at %a: %a", x, s * s + c * c) ? PASS : FAIL;
}

/* Powers of two and signs go through; the other end first, each sum is within its bound of the exact one: 18 roundings and one more a doubling of
 * blocks. */
verdict prop_real_sum_scaled(gen *g)
{
    double x[MOST], y[MOST], z[MOST], size = 0;
    const size_t n = (size_t)gen_upto(g, MOST);
    const int e = (int)gen_upto(g, 400) - 200;
    uint64_t seed = gen_upto(g, UINT64_MAX);

    for (size_t i = 0; i < n; i++) {
        seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        x[i] = ldexp((double)(int64_t)seed, -(int)(seed >> 20 & 31));
        y[i] = -ldexp(x[i], e);
        size += fabs(x[i]);
    }
    for (size_t i = 0; i < n; i++)
        z[i] = x[n - 1 - i];
    const double sum = et_real_sum(x, n), back = et_real_sum(z, n);
    bool ok = gen_check(g, et_real_sum(y, n) == -ldexp(sum, e), "%zu terms by -2^%d: %a, not %a", n, e, et_real_sum(y, n), -ldexp(sum, e));

    return ok && gen_check(g, fabs(back - sum) <= 2 * 21 * ET_UNIT * size * (1 + 0x1p-30), "%zu terms, the other end first: %a, not %a", n, back,
            sum) ? PASS : FAIL;
}
