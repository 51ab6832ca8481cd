/* basis: the p+1 B-spline basis functions that are not zero at a parameter (The NURBS Book, A2.2 and A2.3; Cox-de Boor, 0/0 = 0).
 *
 *     N_{i,0}(x) = 1 if u_i <= x < u_{i+1} (the last non-empty span of the domain is closed), else 0,
 *     N_{i,p}(x) = (x - u_i)/(u_{i+p} - u_i) N_{i,p-1}(x) + (u_{i+p+1} - x)/(u_{i+p+1} - u_{i+1}) N_{i+1,p-1}(x).
 *
 * Any degree, 0 included, and any valid knots (et_knots_valid).  x outside the domain is clamped to it.
 */
#ifndef ETALON_SPLINE_BASIS_H
#define ETALON_SPLINE_BASIS_H
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Doubles of workspace for degree p and derivatives up to order d (d = 0 for et_basis_eval): 2 (p+1), or (p+1)(p+5) with derivatives;
 * SIZE_MAX if that does not fit, so that no allocation succeeds. */
/*@ assigns \nothing;
    ensures room: \result >= 2;
    ensures size: d > 0 ==> \result == ((p + 1)*(p + 5) <= SIZE_MAX ? (p + 1)*(p + 5) : SIZE_MAX);
    ensures none: d == 0 ==> \result == 2*(p + 1) || \result == SIZE_MAX;
*/
size_t et_basis_work(size_t p, size_t d);

/* N[0..p] = N_{span-p,p}(x) .. N_{span,p}(x), where span = et_knots_span(u, nu, p, x).
 *
 * Barring underflow each value is within the factors (1-u)^(6p-1) and (1-u)^-(6p-1) of the exact one (p >= 1; p = 0 is exact), and the
 * exact sum of the p+1 values within (1-u)^(4p-1) and (1-u)^-(4p-1) of 1 (both machine-checked for A2.2).  Never negative.  Where x is a knot of
 * multiplicity p or more, so at both ends of clamped knots, the values are exactly 1 and 0. */
/*@ requires count:  nu >= 2 * p + 2;
    requires N:      \valid(N + (0 .. p));
    requires knots:  \valid_read(u + (0 .. nu - 1));
    requires span:   p <= span <= nu - p - 2 && u[span] < u[span + 1];
    requires finite: \is_finite(x) && \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    requires sorted: \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    requires spread: \is_finite((double)(u[nu - 1] - u[0])) &&
                     \forall integer i; 0 < i < nu && u[i - 1] < u[i] ==> u[i] - u[i - 1] >= 0x1p-1022;
    requires room:   nwork >= 2 * (p + 1) && \valid(work + (0 .. nwork - 1));
    requires apart:  \separated(N + (0 .. p), u + (0 .. nu - 1), work + (0 .. nwork - 1));
    assigns  N[0 .. p], work[0 .. nwork - 1];
    ensures  range:  \forall integer r; 0 <= r <= p ==> N[r] >= 0.0;
*/
void et_basis_eval(double *N, const double *u, size_t nu, size_t p, size_t span, double x, double *work, size_t nwork);

/* D[k*(p+1) + j] = k-th derivative of N_{span-p+j,p} at x, k = 0..d (zero for k > p); at a knot the derivative from the right, at the
 * right end of the domain from the left.  Row 0 has the bits of et_basis_eval.
 *
 * A k-th derivative is p!/(p-k)! sum_j a_kj N_{i+j,p-k} (Eq. 2.9).  The a_kj and their recursion suffer no cancellation; hence the error is
 * at most ((1-u)^-m - 1) p!/(p-k)! sum_j |a_kj| N_{i+j,p-k}, m = 6p + 2, barring over- and underflow: small relative to the largest
 * derivatives, not to one that vanishes. */
/*@ requires count:  nu >= 2 * p + 2;
    requires D:      (d + 1) * (p + 1) <= SIZE_MAX && \valid(D + (0 .. (d + 1) * (p + 1) - 1));
    requires knots:  \valid_read(u + (0 .. nu - 1));
    requires span:   p <= span <= nu - p - 2 && u[span] < u[span + 1];
    requires finite: \is_finite(x) && \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    requires sorted: \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    requires spread: \is_finite((double)(u[nu - 1] - u[0])) &&
                     \forall integer i; 0 < i < nu && u[i - 1] < u[i] ==> u[i] - u[i - 1] >= 0x1p-1022;
    requires room:   nwork >= (p + 1) * (p + 5) && \valid(work + (0 .. nwork - 1));
    requires apart:  \separated(D + (0 .. (d + 1) * (p + 1) - 1), u + (0 .. nu - 1), work + (0 .. nwork - 1));
    assigns  D[0 .. (d + 1) * (p + 1) - 1], work[0 .. nwork - 1];
    ensures  range:  \forall integer r; 0 <= r <= p ==> D[r] >= 0.0;
    ensures  above:  \forall integer k, r; p < k <= d && 0 <= r <= p ==> D[k * (p + 1) + r] == 0.0;
*/
void et_basis_ders(double *D, size_t d, const double *u, size_t nu, size_t p, size_t span, double x, double *work, size_t nwork);

#ifdef __cplusplus
}
#endif
#endif
