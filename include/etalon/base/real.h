/* real: the one place where elementary functions and long sums are computed.
 *
 * Every sum over many terms in Etalon is et_real_sum, so that two ways to the same number give the same bits.
 *
 * exp, log, pow, sin and cos are correctly rounded: the result is the double nearest to the exact value, ties to the even one, for every argument,
 * results that are subnormal or overflow included, whatever the C library, compiler and processor.  (So is the C library's sqrt, by IEEE 754.)  A
 * first phase in double and double-double arithmetic (etalon/base/dd.h) gives hi + lo with a proved bound of its error; if all numbers within the
 * bound round to one double, that is the result, else MPFR decides, which happens to one argument in some 10000 and takes microseconds.  MPFR takes
 * memory from malloc, and ends the process when there is none; its settings, flags and caches are left as they were.  Rounding to nearest must be in
 * force.
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
    decreases n;
    assigns  \nothing;
    ensures  empty:  n == 0 ==> \result == 0.0;
    ensures  one:    n == 1 && \is_finite(x[0]) ==> \result == x[0];
*/
double et_real_sum(const double *x, size_t n);

/* e^x, correctly rounded; +0 at -infinity and from x = -745.14 down, +infinity from x = 709.79 up; NaN for NaN.
 *
 * First phase: 2^(k/128) from a table times a polynomial of degree 6; error at most 2^-67 of the power of two below the result.  Results below
 * 2^-1021 and above 2^1022 go straight to MPFR. */
/*@ assigns \nothing;
    ensures one:       \is_finite(x) && x == 0.0 ==> \result == 1.0;
    ensures above_one: \is_finite(x) && x > 0.0 ==> \result >= 1.0;
    ensures below_one: \is_finite(x) && x < 0.0 ==> 0.0 <= \result <= 1.0;
    ensures finite:    \is_finite(x) && x <= 709.0 ==> \is_finite(\result);
*/
double et_real_exp(double x);

/* The natural logarithm, correctly rounded; -infinity at 0 of either sign, NaN below and for NaN, +infinity at +infinity; +0 at 1.
 *
 * First phase: a table of 128 logarithms and a series of degree 11, its first two terms in double-double; relative error at most 2^-73. */
/*@ assigns \nothing;
    ensures zero:   \is_finite(x) && x == 1.0 ==> \result == 0.0;
    ensures sign:   \is_finite(x) && x > 1.0 ==> \result > 0.0;
    ensures finite: \is_finite(x) && x > 0.0 ==> \is_finite(\result) && -745.0 <= \result <= 710.0;
*/
double et_real_log(double x);

/* x^y, correctly rounded: exact where the result is a double; 1 for y = 0 and for x = 1, whatever the other is; NaN for x < 0 and finite y that is no
 * integer; the other special values as C99, F.9.4.4, says.
 *
 * First phase: the exponential's of y times the logarithm's; error at most 2^-67 + 2^-72 |y ln x| of the power of two below the result. */
/*@ assigns \nothing;
    ensures one:      \is_finite(y) && y == 0.0 ==> \result == 1.0;
    ensures base_one: \is_finite(x) && x == 1.0 ==> \result == 1.0;
    ensures positive: \is_finite(x) && \is_finite(y) && x > 0.0 && \is_finite(\result) ==> \result >= 0.0;
*/
double et_real_pow(double x, double y);

/* Sine of x in radians, correctly rounded; NaN for infinities and NaN; the zero given for a zero.
 *
 * First phase, up to |x| = 4096: x less a multiple of pi/512, sines from a table, polynomials of degree 7; error at most 1.5 2^-67 |S| + 2^-68 |r|
 * + 2^-104, S the table's sine near the result and r what remains of x, |r| < 0.0031.  Beyond, MPFR. */
/*@ assigns \nothing;
    ensures range: \is_finite(x) ==> -1.0 <= \result <= 1.0;
    ensures zero:  \is_finite(x) && x == 0.0 ==> \result == 0.0;
*/
double et_real_sin(double x);

/* Cosine of x in radians: as et_real_sin, of which it is the other half. */
/*@ assigns \nothing;
    ensures range: \is_finite(x) ==> -1.0 <= \result <= 1.0;
    ensures one:   \is_finite(x) && x == 0.0 ==> \result == 1.0;
*/
double et_real_cos(double x);

#ifdef __cplusplus
}
#endif
#endif
