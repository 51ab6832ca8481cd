/* The C library's functions on doubles, as IEEE 754 and C99, annex F, have them; errno, which nobody reads, is left out of the frames.
 * (Frama-C's own contract of sqrt says that the rounded root is the exact one.) */
#ifndef LIBM_H
#define LIBM_H
#include <math.h>
#undef isfinite
#define isfinite(x) libm_isfinite(x)
#define sqrt(x) libm_sqrt(x)
#define fabs(x) libm_fabs(x)
#define floor(x) libm_floor(x)
#define copysign(x, y) libm_copysign(x, y)
/*@ assigns \nothing;
    ensures  truth:    \result == 0 || \result == 1;
    ensures  finite:   \result == 1 <==> \is_finite(x);
*/
int libm_isfinite(double x);
/*@ assigns \nothing;
    ensures  root:     \is_finite(x) && x >= 0.0 ==> \is_finite(\result) && \result >= 0.0;
    ensures  zero:     \is_finite(x) && x == 0.0 ==> \result == 0.0;
    ensures  infinite: \is_plus_infinity(x) ==> \is_plus_infinity(\result);
    ensures  none:     (\is_finite(x) && x < 0.0) || \is_minus_infinity(x) || \is_NaN(x) ==> \is_NaN(\result);
*/
double libm_sqrt(double x);
/*@ assigns \nothing;
    ensures  size:     \is_finite(x) ==> \is_finite(\result) && \result >= 0.0 && (\result == x || \result == -x);
    ensures  infinite: \is_infinite(x) ==> \is_plus_infinity(\result);
    ensures  none:     \is_NaN(x) ==> \is_NaN(\result);
*/
double libm_fabs(double x);
/*@ assigns \nothing; */
double libm_floor(double x);
/*@ assigns \nothing; */
double libm_copysign(double x, double y);
#endif
