#include "base/real_parts.h"
#include "base/real_exp_table.h"

/* With k = i + 128 e, 0 <= i < 128: e^x = 2^e 2^(i/128) e^r, r = x - k ln 2 / 128, |r| < 0.00271 < 2^-8.52; 2^(i/128) = t1 + t2 < 2.
 *
 * Reduction.  |k| < 2^17.2 and `exp_step` has 35 bits: k exp_step is exact, and x - k exp_step is a multiple of 2^-61 below 2^-8 (or k = 0): exact.
 * k exp_step_rest is below 2^-25.8; it is rounded, low subtracted and rounded: 2^-79 each, and exp_step_rest's own error times k is 2^-79.8.  r + r2 is
 * exact (Fast2Sum).  Together 2^-77.6.
 *
 * s = e^r - 1 - a.  Up to r^6/720: 2^-72 left out; e^(r + r2) - e^r - r2: 2^-70.5; rounding of r^2/2: 2.02u of 2^-18.05: 2^-70.04; two sums:
 * 2^-72 each.
 *
 * Product.  t1 is a multiple of 2^-25 and a one of 2^-34 below 2^-8.5: p is exact, and h + l = t1 + p exactly.  Rounding of t1 + t2, of its
 * product with s, and of the last sum: 2^-71 each; the rest 2^-78.
 *
 * In all 2 (2^-77.6 + 2^-72 + 2^-70.5 + 2^-70.04 + 2 2^-72) + 3 2^-71 + 2^-78 < 2^-67.3; the rounding of lo -+ E adds 2^-71: below 2^-67. */
/*@ requires scale: \valid(scale);
    assigns  *scale;
    ensures  power: -2048 <= *scale < 1 << 25;
*/
static inline et_dd fast(int *scale, double x, double low)
{
    const double shifted = x * exp_steps + 0x1.8p52, k = shifted - 0x1.8p52;        /* the nearest integer, which stands in the last bits of shifted */
    const unsigned n = (unsigned)real_bits(shifted) + 128 * 2048, i = n & 127;  /* k made positive */
    const double r1 = x - k * exp_step, t = k * exp_step_rest - low, r = r1 - t, r2 = (r1 - r) - t;
    const double a = (r + 0x1.8p18) - 0x1.8p18, b = (r - a) + r2, square = r * r;
    const double tail = (0x1.5555555555555p-3 + r * 0x1.5555555555555p-5) + square * (0x1.1111111111111p-7 + r * 0x1.6c16c16c16c17p-10);
    const double s = (b + 0.5 * square) + square * r * tail;
    const double t1 = exp_table[i][0], t2 = exp_table[i][1], p = t1 * a, h = t1 + p, l = (t1 - h) + p;

    *scale = (int)(n >> 7) - 2048;
    return (et_dd){h, (l + (t2 + t2 * a)) + (t1 + t2) * s};
}

et_dd real_exp_fast(int *scale, double x, double low)
{
    return fast(scale, x, low);
}

/* Results that overflow, that are subnormal, that are near to it, or that are none. */
/*@ assigns \nothing; */
static double outside(double x)
{
    if (x != x)
        return x;
    return x > 710 ? HUGE_VAL : x < -746 ? 0 : real_mpfr_exp(x);
}

double et_real_exp(double x)
{
    double r;
    int scale;

    if (!(x >= -708 && x <= 709)) /* the result is normal, and scale at most 1023 */
        return outside(x);
    if (real_rounds(&r, fast(&scale, x, 0), REAL_EXP_ERROR))
        return r * real_of_bits((uint64_t)(scale + 1023) << 52);
    return real_mpfr_exp(x);
}
