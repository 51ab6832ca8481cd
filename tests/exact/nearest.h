/* nearest: the second way of the exact layer's tests: MPFR at a precision at which its own errors do not matter. */
#ifndef TESTS_EXACT_NEAREST_H
#define TESTS_EXACT_NEAREST_H
#include <math.h>
#include <mpfr.h>
#include <stdint.h>
#include <string.h>

/* Numbers are computed from doubles by positive sums, products, quotients and roots, fewer than 2^16 of them, each within 2^-5000 of itself: together
 * within 2^-4980.  A square beside another may count 2^-4200, if it is that of the least double beside that of the greatest. */
enum { SECOND_BITS = 5000, SECOND_SURE = 4980 };

/* Whether the last digit of x is even. */
static inline int nearest_even(double x)
{
    uint64_t b;

    memcpy(&b, &x, sizeof b);
    return b % 2 == 0;
}

/* The double nearest to the number that v stands for.  Where doubles on both sides are in question it is taken to be the middle, which has an even
 * and an odd neighbour. */
static inline double nearest(const mpfr_t v)
{
    mpfr_t end;
    double lo, hi;

    mpfr_init2(end, SECOND_BITS);
    mpfr_div_2ui(end, v, SECOND_SURE, MPFR_RNDN);
    mpfr_sub(end, v, end, MPFR_RNDN);
    lo = mpfr_get_d(end, MPFR_RNDN);
    mpfr_div_2ui(end, v, SECOND_SURE, MPFR_RNDN);
    mpfr_add(end, v, end, MPFR_RNDN);
    hi = mpfr_get_d(end, MPFR_RNDN);
    mpfr_clear(end);
    return lo == hi || nearest_even(lo) ? lo + 0.0 : hi;
}
#endif
