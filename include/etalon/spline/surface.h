/* surface: a tensor-product B-spline or NURBS surface (The NURBS Book, sections 3.4 and 4.4). */
#ifndef ETALON_SPLINE_SURFACE_H
#define ETALON_SPLINE_SURFACE_H
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* S(u,v) = sum_ij N_i,p(u) N_j,q(v) w_ij P_ij / sum_ij N_i,p(u) N_j,q(v) w_ij.
 * Control point (i, j) stands at points[i*nv + j], i < nu, j < nv.  weights is null for a polynomial surface, else nu*nv
 * positive numbers.  u has nu+p+1 knots, v has nv+q+1. */
typedef struct {
    size_t p, q;                          /* degrees in u and v */
    size_t nu, nv;                        /* control points in u and v */
    double *u, *v;                        /* knots */
    et_vec3 *points;
    double *weights;
} et_surface;

/* Knots valid (et_knots_valid), control points finite, weights null or finite and positive. */
int et_surface_valid(const et_surface *s);

/* Storage for the given sizes, all zero; rational != 0 also allocates weights (all 1).  et_surface_free on a zeroed struct does nothing. */
et_status et_surface_new(et_surface *s, size_t p, size_t q, size_t nu, size_t nv, int rational);
et_status et_surface_copy(et_surface *copy, const et_surface *s);
void et_surface_free(et_surface *s);

/* Doubles of workspace for every call below. */
size_t et_surface_work(const et_surface *s);

/* One point (A3.5, A4.3). */
et_vec3 et_surface_point(const et_surface *s, double u, double v, double *work, size_t nwork);

/* D[0] = S, D[1] = S_u, D[2] = S_v, D[3] = S_uu, D[4] = S_uv, D[5] = S_vv (A3.6, A4.4). */
void et_surface_ders(et_vec3 D[6], const et_surface *s, double u, double v, double *work, size_t nwork);

/* n points at (u[k], v[k]); the same bits as n calls of et_surface_point. */
void et_surface_points(et_vec3 *S, const et_surface *s, const double *u, const double *v, size_t n, double *work, size_t nwork);

/* S[i*nb + j] = S(a[i], b[j]); the same bits as et_surface_point.  Allocates what it needs to reuse basis values and row sums. */
et_status et_surface_grid(et_vec3 *S, const et_surface *s, const double *a, size_t na, const double *b, size_t nb);

#ifdef __cplusplus
}
#endif
#endif
