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

/* nu >= 2p + 2, all knots finite, non-decreasing, and the domain not empty: u[p] < u[nu-p-1]. */
int et_knots_valid(const double *u, size_t nu, size_t p);

/* The first and the last p+1 knots are equal: the ends of the control polygon are the ends of the curve. */
int et_knots_clamped(const double *u, size_t nu, size_t p);

/* The span k with u[k] <= x < u[k+1], p <= k <= nu-p-2; at the right end of the domain the last non-empty one (A2.1).
 * x outside the domain is clamped to it.  Requires et_knots_valid. */
size_t et_knots_span(const double *u, size_t nu, size_t p, double x);

#ifdef __cplusplus
}
#endif
#endif
