#include "base/real_parts.h"
#include "base/real_trig_table.h"

/* x - k pi/512 for |k| < 2^19.4, in normal form.  sine_step1 has 33 bits, sine_step2 32: k sine_step1 and k sine_step2 are exact, x - k sine_step1 is a multiple of 2^-61
 * below 2^-8 (or k = 0): exact.  k sine_step3 is below 2^-53.5: it, its own error times k and the difference are off by 2^-105.3 together. */
/*@ assigns \nothing; */
static et_dd reduced(double x, double k)
{
    const et_dd r = dd_two_sum(x - k * sine_step1, -(k * sine_step2));

    return dd_two_sum(r.hi, r.lo - k * sine_step3);
}

/* sin(t + r) = S + C r + S (cos r - 1) + C (sin r - r) with S = sin t, C = cos t in two parts each; |r| < 0.00307 = 2^-8.34, |r.lo| <= 2^-62.
 *
 * C1 and the upper part a of r have 26 bits: C1 a is exact, and S1 + C1 a as well (S1 is 0 or above 0.006).
 *
 * S not 0, thus above 2^-7.36.  S (cos r - 1): 4.5u of S 2^-17.7; five sums 5u of that; r r.lo left out S 2^-70.4: in all S 2^-67.27.
 * C (sin r - r): 6u of 2^-27.6; sums of what has not the factor S 5.3u 2^-27: together 2^-76.8 < S 2^-69.4.
 *
 * S = 0.  Everything is relative to r, and (sin r - r) / r below 2^-19.2: r 2^-69.
 *
 * r itself is off by 2^-105.3.  The rounding of lo -+ E adds S 2^-70.7: below E = 1.5 2^-67 S + 2^-68 r + 2^-104. */
/*@ requires valid: \valid(error) && \valid_read(s + (0 .. 1)) && \valid_read(c + (0 .. 1));
    assigns  *error;
*/
static et_dd turned(double *error, const double s[2], const double c[2], double sign_c, et_dd r)
{
    const double x = r.hi, xx = x * x, a = dd_upper(x), b = (x - a) + r.lo;
    const double sine = x * xx * (-0x1.5555555555555p-3 + xx * (0x1.1111111111111p-7 - xx * 0x1.a01a01a01a01ap-13));
    const double cosine = xx * (-0.5 + xx * (0x1.5555555555555p-5 - xx * 0x1.6c16c16c16c17p-10));
    const double c1 = sign_c * c[0], c2 = sign_c * c[1], whole_s = s[0] + s[1], whole_c = c1 + c2;
    const et_dd h = dd_fast_two_sum(s[0], c1 * a);

    *error = 0x1.8p-67 * whole_s + 0x1p-68 * fabs(x) + 0x1p-104;
    return (et_dd){h.hi, h.lo + (s[1] + (c2 * a + (whole_c * b + (whole_s * cosine + whole_c * sine))))};
}

et_dd real_trig_fast(double *error, double x, unsigned shift)
{
    const double k = real_nearest(x * sine_steps);
    const unsigned turn = (unsigned)(int)k, j = turn & 255, quarter = (turn >> 8) + shift;
    const double *one = sine_table[j], *other = sine_table[256 - j];
    const et_dd r = reduced(x, k);
    const et_dd value = quarter & 1 ? turned(error, other, one, -1, r) : turned(error, one, other, 1, r);

    return quarter & 2 ? dd_negative(value) : value;
}

double et_real_sin(double x)
{
    double r, error;

    if (fabs(x) <= 0x1p-26) /* x^3/6 is below a quarter of an ulp */
        return x;
    if (!(fabs(x) <= DBL_MAX))
        return x - x;
    if (fabs(x) <= REAL_TRIG_RANGE) {
        const et_dd value = real_trig_fast(&error, x, 0);
        if (real_rounds(&r, value, error))
            return r;
    }
    return real_mpfr_sin(x);
}

double et_real_cos(double x)
{
    double r, error;

    if (!(fabs(x) <= DBL_MAX))
        return x - x;
    if (fabs(x) <= REAL_TRIG_RANGE) {
        const et_dd value = real_trig_fast(&error, x, 1);
        if (real_rounds(&r, value, error))
            return r;
    }
    return real_mpfr_cos(x);
}
