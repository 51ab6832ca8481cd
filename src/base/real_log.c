#include "base/real_parts.h"
#include "base/real_log_table.h"

/* ln(1 + z) = z + z^2 (z/3 - 1/2) - z^4/4 + ... + z^11/11, the first two terms in double-double; |z| <= 2^-7.  Relative errors: tail 5.2u of z^3/4:
 * 2^-73.6; its sum with q.lo 2^-77; series cut off 2^-80.6; double-double 2^-103. */
/*@ assigns \nothing; */
static et_dd log_near_one(et_dd z)
{
    const double x = z.hi;
    const et_dd square = dd_mul(z, z);
    const double tail = -0.25 + x * (0x1.999999999999ap-3 + x * (-0x1.5555555555555p-3 + x * (0x1.2492492492492p-3 + x * (-0.125 +
                        x * (0x1.c71c71c71c71cp-4 + x * (-0x1.999999999999ap-4 + x * 0x1.745d1745d1746p-4))))));
    const et_dd q = dd_mul(square, dd_add_double(dd_mul(z, log_third), -0.5));

    return dd_add(z, dd_fast_two_sum(q.hi, q.lo + square.hi * square.hi * tail));
}

/* x = 2^k m, 11/16 <= m < 11/8; c of 13 bits near 1/m by the upper 7 bits of m - 11/16; ln x = (k ln 2 - ln c) + ln(1 + z), z = c m - 1.
 *
 * c is 1 around m = 1, so that nothing cancels there: |z| <= 2^-7.  Elsewhere |z| <= 2^-7.9 and |ln x| > 2^-8.02.  c times the upper 32 bits of m,
 * less 1, is exact, so are c times the lower 21 bits and their sum z.  k log_2 and its sum with -ln c are multiples of 2^-42 below 2^10: exact; the
 * rests are below 2^-32.8 together and off by 2^-84.5; the tail by 2^-84.4: 2^-75.3 relative.  So the error is below 2^-73.3 in all cases. */
et_dd real_log_fast(double x)
{
    const double m0 = x < DBL_MIN ? x * 0x1p54 : x;
    const uint64_t b = real_bits(m0) + UINT64_C(0x401a000000000000); /* less the bits of 11/16, 2048 added to the exponent */
    const double k = (double)((int)(b >> 52) - (x < DBL_MIN ? 2048 + 54 : 2048));
    const uint64_t m = (b & UINT64_C(0x000fffffffffffff)) + UINT64_C(0x3fe6000000000000);
    const double *row = log_table[b >> 45 & 127];
    const double upper = real_of_bits(m & ~UINT64_C(0x1fffff)), lower = real_of_bits(m) - upper;
    const et_dd z = dd_fast_two_sum(upper * row[0] - 1, lower * row[0]);
    const et_dd a = dd_fast_two_sum(k * log_2 + row[1], k * log_2_rest + row[2]);

    return dd_add(a, log_near_one(z));
}

double et_real_log(double x)
{
    double r;

    if (!(x > 0 && x <= DBL_MAX))
        return x < 0 ? NAN : x == 0 ? -HUGE_VAL : x;
    const et_dd value = real_log_fast(x);
    return real_rounds(&r, value, fabs(value.hi) * REAL_LOG_ERROR) ? r : real_mpfr_log(x);
}
