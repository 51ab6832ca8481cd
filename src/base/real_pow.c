#include "base/real_parts.h"

/* 0 < x finite, y finite.  w = y ln x is within 2^-73.3 |w|, so its power, at most 2.01 2^scale, within 2^-72 |w| more than e^w itself. */
/*@ assigns \nothing; */
static double power(double x, double y)
{
    const et_dd l = real_log_fast(x);
    const double about = y * l.hi;
    double r;
    int scale;

    if (fabs(about) < 0x1p-55) /* within a quarter of an ulp of 1 */
        return 1;
    if (!(fabs(about) < 708))
        return about > 710 ? HUGE_VAL : about < -746 ? 0 : real_mpfr_pow(x, y);
    const et_dd w = dd_mul_double(l, y), value = real_exp_fast(&scale, w.hi, w.lo);
    if (real_rounds(&r, value, REAL_EXP_ERROR + 2 * REAL_LOG_ERROR * fabs(w.hi)))
        return r * real_of_bits((uint64_t)(scale + 1023) << 52);
    return real_mpfr_pow(x, y);
}

/* 1 for odd integers, 2 for even ones, 0 for other numbers; y finite or infinite (which is even). */
/*@ assigns \nothing; */
static int parity(double y)
{
    const double half = 0.5 * y;

    return floor(y) != y ? 0 : fabs(y) > 0x1p53 || floor(half) == half ? 2 : 1;
}

/* What is not a power of a positive number with a finite exponent (C99, F.9.4.4). */
/*@ assigns \nothing; */
static double special(double x, double y)
{
    if (y == 0 || x == 1)
        return 1;
    if (x != x || y != y)
        return x + y;
    if (fabs(y) > DBL_MAX)
        return x == -1 ? 1 : (fabs(x) > 1) == (y > 0) ? HUGE_VAL : 0;
    const int kind = parity(y);
    const double size = fabs(x), sign = kind == 1 && copysign(1, x) < 0 ? -1 : 1;
    if (size == 0 || size > DBL_MAX)
        return sign * ((size == 0) == (y < 0) ? HUGE_VAL : 0);
    return kind == 0 ? NAN : sign * power(size, y);
}

double et_real_pow(double x, double y)
{
    return x > 0 && x <= DBL_MAX && fabs(y) <= DBL_MAX ? power(x, y) : special(x, y);
}
