/* real_parts: what the files of real share: the first phase of each elementary function, its proved bound, the rounding test, and the last resort.
 *
 * A first phase gives a value hi + lo, not necessarily normal, whose distance from the exact one is below a bound E.  If hi + (lo - E) and hi + (lo +
 * E) round to the same double, that is the correctly rounded result; the bounds leave room for the rounding of lo -+ E.  Else MPFR decides.
 */
#ifndef BASE_REAL_PARTS_H
#define BASE_REAL_PARTS_H
#include "base/dd_parts.h"
#include "etalon/base/real.h"
#include <float.h>
#include <stdint.h>
#include <string.h>

#define REAL_EXP_ERROR 0x1p-67   /* absolute, of a value in 0.99 .. 2.01 */
#define REAL_LOG_ERROR 0x1p-73   /* relative */
#define REAL_TRIG_RANGE 0x1p12

/* e^(x + low) = 2^scale (hi + lo), hi + lo within REAL_EXP_ERROR of the exact; |x| < 710, |low| <= ulp(x)/2 (real_exp.c). */
/*@ requires scale: \valid(scale);
    assigns  *scale;
    ensures  power: -2048 <= *scale < 1 << 25;
*/
et_dd real_exp_fast(int *scale, double x, double low);
/* ln x in normal form, 0 < x finite (real_log.c). */
/*@ assigns \nothing; */
et_dd real_log_fast(double x);
/* sin(x + shift pi/2) within *error, |x| <= REAL_TRIG_RANGE (real_trig.c). */
/*@ requires error: \valid(error);
    requires small: \is_finite(x) && -REAL_TRIG_RANGE <= x <= REAL_TRIG_RANGE;
    assigns  *error;
*/
et_dd real_trig_fast(double *error, double x, unsigned shift);

/* Correct rounding in all cases, special values as C99, annex F, says (real_mpfr.c). */
/*@ assigns \nothing; */
double real_mpfr_exp(double x);
/*@ assigns \nothing; */
double real_mpfr_log(double x);
/*@ assigns \nothing; */
double real_mpfr_pow(double x, double y);
/*@ assigns \nothing; */
double real_mpfr_sin(double x);
/*@ assigns \nothing; */
double real_mpfr_cos(double x);

/* Does everything within the error round to one double?  That goes to *r. */
/*@ requires result: \valid(r);
    assigns  *r;
    ensures  truth: \result == 0 || \result == 1;
*/
static inline int real_rounds(double *r, et_dd value, double error)
{
    const double low = value.hi + (value.lo - error), high = value.hi + (value.lo + error);

    *r = low;
    return low == high;
}

/*@ assigns \nothing; */
static inline uint64_t real_bits(double x)
{
    uint64_t b;

    memcpy(&b, &x, sizeof b);
    return b;
}

/*@ assigns \nothing; */
static inline double real_of_bits(uint64_t b)
{
    double x;

    memcpy(&x, &b, sizeof x);
    return x;
}

/* The integer nearest to x, |x| < 2^31: adding 1.5 2^52 leaves no bit below the unit. */
/*@ requires small: \is_finite(x) && -0x1p30 <= x <= 0x1p30;
    assigns  \nothing;
    ensures  small: \is_finite(\result) && -0x1p30 <= \result <= 0x1p30;
*/
static inline double real_nearest(double x)
{
    return (x + 0x1.8p52) - 0x1.8p52;
}
#endif
