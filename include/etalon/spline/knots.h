/* knots: clamped knot vectors (The NURBS Book, section 2.2).
 *
 * A knot vector U of degree p for n+1 control points has m+1 = n+p+2 knots u_0 <= ... <= u_m.  In calls: `u` the knots, `nu` their
 * number m+1, `p` the degree; nu - p - 1 is the number of control points.  The domain is [u_p, u_{m-p}].
 */
#ifndef ETALON_SPLINE_KNOTS_H
#define ETALON_SPLINE_KNOTS_H
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* 1 if nu >= 2p + 2, all knots finite, non-decreasing, the domain not empty: u[p] < u[nu-p-1], u[nu-1] - u[0] does not overflow, and no
 * two different neighbours are less than 2^-1022 apart (so that no quotient of the basis functions overflows); else 0.
 * Knots may be repeated as often as one likes. */
/*@ requires knots:  \valid_read(u + (0 .. nu - 1));
    assigns  \nothing;
    ensures  flag:   \result == 0 || \result == 1;
    ensures  count:  \result == 1 ==> nu >= 2 * p + 2;
    ensures  finite: \result == 1 ==> \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    ensures  sorted: \result == 1 ==> \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    ensures  domain: \result == 1 ==> u[p] < u[nu - p - 1];
    ensures  spread: \result == 1 ==> \is_finite((double)(u[nu - 1] - u[0]));
    ensures  apart:  \result == 1 ==> \forall integer i; 0 < i < nu && u[i - 1] < u[i] ==> u[i] - u[i - 1] >= 0x1p-1022;
*/
int et_knots_valid(const double *u, size_t nu, size_t p);

/* 1 if the first and the last p+1 knots are equal, else 0.  Where no further knot equals them the ends of the control polygon are the ends of the
 * curve; a knot that stands more than p+1 times at an end leaves the outermost control point without a basis function. */
/*@ requires count:   nu >= 2 * p + 2;
    requires knots:   \valid_read(u + (0 .. nu - 1));
    requires finite:  \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    requires sorted:  \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    assigns  \nothing;
    ensures  clamped: \result == 1 <==> u[0] == u[p] && u[nu - p - 1] == u[nu - 1];
    ensures  flag:    \result == 0 || \result == 1;
*/
int et_knots_clamped(const double *u, size_t nu, size_t p);

/* 1 if the first p+1 knots are equal, the last p+1 too, and no other knot equals them, else 0.  Then the first and the last basis function, and they
 * alone, are 1 at the ends of the domain: the curve ends in the ends of the control polygon, and a surface's borders are the curves of its border
 * control points. */
/*@ requires count:   nu >= 2 * p + 2;
    requires knots:   \valid_read(u + (0 .. nu - 1));
    requires finite:  \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    requires sorted:  \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    assigns  \nothing;
    ensures  ends:    \result == 1 <==> u[0] == u[p] && u[p] < u[p + 1] && u[nu - p - 2] < u[nu - p - 1] && u[nu - p - 1] == u[nu - 1];
    ensures  flag:    \result == 0 || \result == 1;
*/
int et_knots_interpolating(const double *u, size_t nu, size_t p);

/* The span k with u[k] <= x < u[k+1], p <= k <= nu-p-2; at the right end of the domain the last non-empty one (A2.1).
 * x outside the domain is clamped to it.  Binary search, at most 1 + log2(nu - 2p - 1) comparisons.  Requires et_knots_valid. */
/*@ requires count:  nu >= 2 * p + 2;
    requires knots:  \valid_read(u + (0 .. nu - 1));
    requires finite: \is_finite(x) && \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    requires sorted: \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    requires domain: u[p] < u[nu - p - 1];
    assigns  \nothing;
    ensures  range:  p <= \result <= nu - p - 2;
    ensures  span:   u[\result] < u[\result + 1];
    ensures  inside: u[p] <= x < u[nu - p - 1] ==> u[\result] <= x < u[\result + 1];
    ensures  right:  x >= u[nu - p - 1] ==> u[\result + 1] == u[nu - p - 1];
    ensures  left:   x < u[p] ==> u[\result] == u[p];
*/
size_t et_knots_span(const double *u, size_t nu, size_t p, double x);

/* From which side a limit is taken: it matters at knots, where derivatives (and, at a knot of multiplicity p + 1 or more, values) may jump.  At the
 * left end of the domain both are the limit from the right, at its right end both the one from the left. */
typedef enum { ET_SIDE_RIGHT = 0, ET_SIDE_LEFT } et_side;

/* et_knots_span for ET_SIDE_RIGHT; for ET_SIDE_LEFT the span k with u[k] < x <= u[k+1], at (or before) the left end of the domain the first non-empty
 * one, behind its right end the last.  With it et_basis_ders gives the derivatives from that side.  Comparisons only: no error. */
/*@ requires count:  nu >= 2 * p + 2;
    requires knots:  \valid_read(u + (0 .. nu - 1));
    requires finite: \is_finite(x) && \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    requires sorted: \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    requires domain: u[p] < u[nu - p - 1];
    requires side:   side == ET_SIDE_RIGHT || side == ET_SIDE_LEFT;
    assigns  \nothing;
    ensures  range:  p <= \result <= nu - p - 2;
    ensures  span:   u[\result] < u[\result + 1];
    ensures  right:  side == ET_SIDE_RIGHT && u[p] <= x < u[nu - p - 1] ==> u[\result] <= x < u[\result + 1];
    ensures  left:   side == ET_SIDE_LEFT && u[p] < x <= u[nu - p - 1] ==> u[\result] < x <= u[\result + 1];
    ensures  first:  x <= u[p] ==> u[\result] == u[p];
    ensures  last:   x >= u[nu - p - 1] ==> u[\result + 1] == u[nu - p - 1];
*/
size_t et_knots_span_side(const double *u, size_t nu, size_t p, double x, et_side side);

/* How many of the knots equal x (0 and -0 are equal). */
/*@ requires knots:  \valid_read(u + (0 .. nu - 1));
    requires finite: \is_finite(x) && \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    assigns  \nothing;
    ensures  range:  0 <= \result <= nu;
    ensures  none:   \result == 0 <==> \forall integer i; 0 <= i < nu ==> u[i] != x;
*/
size_t et_knots_multiplicity(const double *u, size_t nu, double x);

/* The Greville points g[i] = (u[i+1] + ... + u[i+p]) / p, i < n = nu - p - 1 (Greville 1964); of degree 0 the spans' midpoints.
 *
 * Computed as a + sum (u[i+j] - a)/p, a = u[i+1], which does not overflow and is exact where all are equal, and never beyond u[i+p].  The error is
 * at most ((1-u)^-(p+1) - 1) (g - a) + 2^-53 |g|, u = 2^-53, and 2^-1075 for each quotient that underflows. */
/*@ requires count:  nu >= 2 * p + 2 && n == nu - p - 1;
    requires g:      \valid(g + (0 .. n - 1));
    requires knots:  \valid_read(u + (0 .. nu - 1));
    requires finite: \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    requires sorted: \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    requires spread: \is_finite((double)(u[nu - 1] - u[0]));
    requires apart:  \separated(g + (0 .. n - 1), u + (0 .. nu - 1));
    assigns  g[0 .. n - 1];
    ensures  within: \forall integer i; 0 <= i < n ==> u[i + (p > 0 ? 1 : 0)] <= g[i] <= u[i + (p > 0 ? p : 1)];
*/
void et_knots_greville(double *g, size_t n, const double *u, size_t nu, size_t p);

#ifdef __cplusplus
}
#endif
#endif
