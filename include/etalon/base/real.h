/* real: the one place where elementary functions and long sums are computed.
 *
 * Every sum over many terms in Etalon is et_real_sum, so that two ways to the same number give the same bits.
 * exp, log, pow, sin, cos pass through here so that one implementation decides their bits; in this version it is the C library's.
 */
#ifndef ETALON_BASE_REAL_H
#define ETALON_BASE_REAL_H
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* 2^-52 and 2^-53 (the unit roundoff u). */
#define ET_EPS 0x1p-52
#define ET_UNIT 0x1p-53

/* x[0] + ... + x[n-1] in an order of additions that depends on n alone; +0 for n == 0.
 *
 * The terms are cut into blocks of 128, the last one shorter.  In a block, term i goes to lane i mod 8 and the lanes are added by
 * halves (0+4, 1+5, ...; 0+2, 1+3; 0+1); the last n mod 8 terms are added in turn and come last.  The blocks' sums are added
 * pairwise: the left part has half of the whole blocks, rounded up.
 *
 * A term passes at most m = 18 + ceil(log2 ceil(n/128)) roundings, so the error is at most ((1+u)^m - 1) sum|x_i| barring overflow
 * (underflow does no harm: sums of doubles that are subnormal are exact).  Terms that are not finite give what IEEE 754 says. */
/*@ requires terms:  \valid_read(x + (0 .. n - 1));
    assigns  \nothing;
    ensures  empty:  n == 0 ==> \result == 0.0;
    ensures  one:    n == 1 && \is_finite(x[0]) ==> \result == x[0];
*/
double et_real_sum(const double *x, size_t n);

/* e^x. */
/*@ assigns \nothing;
    ensures one: \is_finite(x) && x == 0.0 ==> \result == 1.0;
*/
double et_real_exp(double x);

/* The natural logarithm; -infinity at 0, NaN below. */
/*@ assigns \nothing;
    ensures zero: \is_finite(x) && x == 1.0 ==> \result == 0.0;
*/
double et_real_log(double x);

/* x^y; 1 for y == 0, exact where the result is a double and the C library's error is below 1/2 ulp. */
/*@ assigns \nothing;
    ensures one: \is_finite(y) && y == 0.0 ==> \result == 1.0;
*/
double et_real_pow(double x, double y);

/* Sine and cosine of x in radians. */
/*@ assigns \nothing;
    ensures range: \is_finite(x) ==> -1.0 <= \result <= 1.0;
*/
double et_real_sin(double x);

/* See et_real_sin. */
/*@ assigns \nothing;
    ensures range: \is_finite(x) ==> -1.0 <= \result <= 1.0;
*/
double et_real_cos(double x);

#ifdef __cplusplus
}
#endif
#endif
