/* curve: a B-spline or NURBS curve in space (The NURBS Book, sections 3.2 and 4.2).
 *
 *     C(x) = sum_i N_i,p(x) w_i P_i / sum_i N_i,p(x) w_i.
 *
 * The order of operations is part of the contract: with c a coordinate of P_i, or fl(w_i c) and w_i if there are weights, sums run from left to right over
 * the p+1 functions that are not zero, each product and sum rounded; last, with weights, the division by the sum for w.  x outside the domain is
 * clamped to it.
 */
#ifndef ETALON_SPLINE_CURVE_H
#define ETALON_SPLINE_CURVE_H
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* n control points, n + p + 1 knots; weights is null for a polynomial curve, else n positive numbers. */
typedef struct {
    size_t p, n;
    double *u;
    et_vec3 *points;
    double *weights;
} et_curve;

/*@ predicate et_curve_stored(et_curve *c) =
        \valid_read(c->u + (0 .. c->n + c->p)) && \valid_read(c->points + (0 .. c->n - 1)) &&
        (c->weights == \null || \valid_read(c->weights + (0 .. c->n - 1)));
    predicate et_curve_readable(et_curve *c) = c->u == \null || c->points == \null || et_curve_stored(c);
*/

int et_curve_valid(const et_curve *c);
et_status et_curve_new(et_curve *c, size_t p, size_t n, int rational);
void et_curve_free(et_curve *c);
size_t et_curve_work(const et_curve *c, size_t d);
et_vec3 et_curve_point(const et_curve *c, double x, double *work, size_t nwork);
void et_curve_ders(et_vec3 *D, size_t d, const et_curve *c, double x, double *work, size_t nwork);

#ifdef __cplusplus
}
#endif
#endif
