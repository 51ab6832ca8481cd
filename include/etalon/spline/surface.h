/* surface: a tensor-product B-spline or NURBS surface (The NURBS Book, sections 3.4 and 4.4).
 *
 *     S(u,v) = sum_ij N_i,p(u) N_j,q(v) w_ij P_ij / sum_ij N_i,p(u) N_j,q(v) w_ij.
 *
 * The order of operations is part of the contract, because every way to a point gives the same bits: with x a coordinate of P_ij, or
 * fl(w_ij x) and w_ij if there are weights,
 *     T_j = N_0 x_0j + N_1 x_1j + ...  over u first, for each column j,      S = M_0 T_0 + M_1 T_1 + ...  then over v,
 * each sum from left to right, each product and sum rounded; last, with weights, the division by the sum for w.
 *
 * Parameters outside the domain are clamped to it.  Error of a coordinate of a polynomial surface: at most ((1-u)^-m - 1) sum N M |x|,
 * m = 7(p + q), barring underflow; a rational one: the same bound for numerator (m+1) and denominator, and one rounding.
 */
#ifndef ETALON_SPLINE_SURFACE_H
#define ETALON_SPLINE_SURFACE_H
#include "etalon/base/size.h"
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#include "etalon/spline/knots.h"
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Control point (i, j) stands at points[i*nv + j], i < nu, j < nv.  weights is null for a polynomial surface, else nu*nv
 * positive numbers.  u has nu+p+1 knots, v has nv+q+1. */
typedef struct {
    size_t p, q;                          /* degrees in u and v */
    size_t nu, nv;                        /* control points in u and v */
    double *u, *v;                        /* knots */
    et_vec3 *points;
    double *weights;
} et_surface;

/* No array has more than SIZE_MAX bytes: so sizes are bounded wherever the arrays are there. */
/*@ predicate et_surface_sizes(et_surface *s) = (s->nu + s->p + 1) * sizeof(double) <= SIZE_MAX && (s->nv + s->q + 1) * sizeof(double) <= SIZE_MAX &&
        s->nu * s->nv * sizeof(et_vec3) <= SIZE_MAX;

    predicate et_surface_stored(et_surface *s) = et_surface_sizes(s) &&
        \valid_read(s->u + (0 .. s->nu + s->p)) && \valid_read(s->v + (0 .. s->nv + s->q)) &&
        \valid_read(s->points + (0 .. s->nu * s->nv - 1)) && (s->weights == \null || \valid_read(s->weights + (0 .. s->nu * s->nv - 1)));

    predicate et_surface_readable(et_surface *s) = s->u == \null || s->v == \null || s->points == \null || et_surface_stored(s);

    predicate et_surface_finite(double *t, integer last) = \forall integer i; 0 <= i <= last ==> \is_finite(t[i]);
    predicate et_surface_rising(double *t, integer last) = \forall integer i, j; 0 <= i <= j <= last ==> t[i] <= t[j];
    predicate et_surface_spread(double *t, integer last) =
        \forall integer i; 0 < i <= last && t[i - 1] < t[i] ==> t[i] - t[i - 1] >= 0x1p-1022;
    predicate et_surface_width(double *t, integer last) = \is_finite((double)(t[last] - t[0]));

    predicate et_surface_domain(double *t, integer last, integer p) =
        t[p] < t[last - p] && et_surface_width(t, last) && et_surface_finite(t, last) && et_surface_rising(t, last) && et_surface_spread(t, last);

    predicate et_surface_ok(et_surface *s) =
        et_surface_stored(s) && s->nu > s->p && s->nv > s->q &&
        et_surface_domain(s->u, s->nu + s->p, s->p) && et_surface_domain(s->v, s->nv + s->q, s->q) &&
        (\forall integer i; 0 <= i < s->nu * s->nv ==>
            \is_finite(s->points[i].x) && \is_finite(s->points[i].y) && \is_finite(s->points[i].z) &&
            (s->weights == \null || (\is_finite(s->weights[i]) && s->weights[i] > 0)));

    predicate et_surface_apart(et_surface *s, double *a, integer n) =
        \separated(a + (0 .. n - 1), s->u + (0 .. s->nu + s->p)) && \separated(a + (0 .. n - 1), s->v + (0 .. s->nv + s->q)) &&
        \separated(a + (0 .. n - 1), s->points + (0 .. s->nu * s->nv - 1)) &&
        (s->weights == \null || \separated(a + (0 .. n - 1), s->weights + (0 .. s->nu * s->nv - 1)));

    logic integer et_surface_room(et_surface *s) =
        3*(s->p + 1) + 15*(s->q + 1) + \max((s->p + 1)*(s->p + 5), (s->q + 1)*(s->q + 5));
*/

/* 1 if knots are valid (et_knots_valid), control points finite, weights null or finite and positive; else 0.  A zeroed struct is not valid. */
/*@ requires s:       \valid_read(s);
    requires storage: et_surface_readable(s);
    assigns  \nothing;
    ensures  flag:    \result == 0 || \result == 1;
    ensures  valid:   \result == 1 ==> et_surface_ok(s);
*/
int et_surface_valid(const et_surface *s);

/* Storage for the given sizes, all zero; rational != 0 also allocates weights (all 1).  What *s held before is not freed.
 * ET_EINVAL (nu <= p or nv <= q), ET_ENOMEM.
 * Golden: none (storage). */
/*@ requires s:     \valid(s);
    assigns  *s;
    ensures  sizes: \result == ET_OK ==> s->p == p && s->q == q && s->nu == nu && s->nv == nv;
    ensures  fits:  \result == ET_OK ==> (nu + p + 1) * sizeof(double) <= SIZE_MAX && (nv + q + 1) * sizeof(double) <= SIZE_MAX &&
                                          nu * nv * sizeof(et_vec3) <= SIZE_MAX;
    ensures  made:  \result == ET_OK ==> et_numbers(s->u, nu + p + 1) && et_numbers(s->v, nv + q + 1) &&
                                          et_numbers((double *)s->points, 3 * (nu * nv));
    ensures  kind:  \result == ET_OK ==> (s->weights == \null <==> rational == 0);
    ensures  room:  \result == ET_OK && rational != 0 ==> et_numbers(s->weights, nu * nv);
    ensures  ones:  \result == ET_OK && rational != 0 ==> \forall integer i; 0 <= i < nu * nv ==> s->weights[i] == 1.0;
    ensures  ends:  \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures  few:   nu <= p || nv <= q ==> \result == ET_EINVAL;
    ensures  kept:  \result != ET_OK ==> *s == \old(*s);
*/
et_status et_surface_new(et_surface *s, size_t p, size_t q, size_t nu, size_t nv, int rational);

/* A copy with storage of its own.  ET_EINVAL (sizes as in et_surface_new), ET_ENOMEM.
 * Golden: none (a copy). */
/*@ requires copy:  \valid(copy);
    requires s:     \valid_read(s) && et_surface_stored(s);
    requires apart: \separated(copy, s);
    assigns  *copy;
    ensures  sizes: \result == ET_OK ==> copy->p == s->p && copy->q == s->q && copy->nu == s->nu && copy->nv == s->nv;
    ensures  own:   \result == ET_OK ==> copy->u != s->u && copy->v != s->v && copy->points != s->points;
    ensures  whole: \result == ET_OK ==> et_numbers(copy->u, s->nu + s->p + 1) &&
                        et_numbers(copy->v, s->nv + s->q + 1) && et_numbers((double *)copy->points, 3 * (s->nu * s->nv));
    ensures  kind:  \result == ET_OK ==> (copy->weights == \null <==> s->weights == \null);
    ensures  room:  \result == ET_OK && s->weights != \null ==> et_numbers(copy->weights, s->nu * s->nv);
    ensures  ends:  \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures  kept:  \result != ET_OK ==> *copy == \old(*copy);
*/
et_status et_surface_copy(et_surface *copy, const et_surface *s);

/* Frees the storage and zeroes the struct; nothing to do for a zeroed one.
 * Golden: none (no value). */
/*@ requires s:    \valid(s);
    assigns  *s;
    ensures  zero: s->u == \null && s->v == \null && s->points == \null && s->weights == \null && s->nu == 0 && s->nv == 0;
*/
void et_surface_free(et_surface *s);

/* Doubles of workspace for every call below; SIZE_MAX if that does not fit, so that no allocation succeeds.
 * Golden: none (a size that only has to suffice). */
/*@ requires s:    \valid_read(s);
    requires sums: 3*(s->p + 1) + 15*(s->q + 1) <= SIZE_MAX;
    assigns  \nothing;
    ensures  room: et_surface_room(s) <= SIZE_MAX ==> \result >= et_surface_room(s);
    ensures  none: et_surface_room(s) > SIZE_MAX ==> \result == SIZE_MAX;
*/
size_t et_surface_work(const et_surface *s);

/* One point (A3.5, A4.3).  At the four corners of a clamped polynomial surface the corner control point exactly (a zero may change its sign);
 * with weights fl(fl(w x) / w), which is x for w a power of two and else within two roundings of it. */
/*@ requires s:      \valid_read(s) && et_surface_ok(s);
    requires finite: \is_finite(u) && \is_finite(v);
    requires room:   nwork >= et_surface_room(s) && \valid(work + (0 .. nwork - 1));
    requires own:    et_surface_apart(s, work, nwork);
    assigns  work[0 .. nwork - 1];
*/
et_vec3 et_surface_point(const et_surface *s, double u, double v, double *work, size_t nwork);

/* D[0] = S, D[1] = S_u, D[2] = S_v, D[3] = S_uu, D[4] = S_uv, D[5] = S_vv (A3.6, A4.4, Eq. 4.20).  D[0] has the bits of et_surface_point;
 * at inner knots the derivatives are those from the right (et_basis_ders).  They satisfy Leibniz' rule for w S = A as a curve's do (et_curve_ders),
 * with ((1-u)^-m - 1), m = 7(p+q) + 12, times the magnitudes of the rule's terms. */
/*@ requires s:      \valid_read(s) && et_surface_ok(s);
    requires D:      \valid(D + (0 .. 5));
    requires finite: \is_finite(u) && \is_finite(v);
    requires room:   nwork >= et_surface_room(s) && \valid(work + (0 .. nwork - 1));
    requires own:    et_surface_apart(s, work, nwork);
    requires apart:  \separated(D + (0 .. 5), work + (0 .. nwork - 1));
    assigns  D[0 .. 5], work[0 .. nwork - 1];
*/
void et_surface_ders(et_vec3 D[6], const et_surface *s, double u, double v, double *work, size_t nwork);

/* n points at (u[k], v[k]); the same bits as n calls of et_surface_point. */
/*@ requires s:      \valid_read(s) && et_surface_ok(s);
    requires S:      \valid(S + (0 .. n - 1));
    requires uv:     \valid_read(u + (0 .. n - 1)) && \valid_read(v + (0 .. n - 1));
    requires finite: \forall integer k; 0 <= k < n ==> \is_finite(u[k]) && \is_finite(v[k]);
    requires room:   nwork >= et_surface_room(s) && \valid(work + (0 .. nwork - 1));
    requires own:    et_surface_apart(s, work, nwork) && et_surface_apart(s, (double *)S, 3 * n);
    requires apart:  \separated(S + (0 .. n - 1), u + (0 .. n - 1), work + (0 .. nwork - 1)) &&
                     \separated(S + (0 .. n - 1), v + (0 .. n - 1), work + (0 .. nwork - 1));
    assigns  S[0 .. n - 1], work[0 .. nwork - 1];
*/
void et_surface_points(et_vec3 *S, const et_surface *s, const double *u, const double *v, size_t n, double *work, size_t nwork);

/* S[i*nb + j] = S(a[i], b[j]); the same bits as et_surface_point.  Allocates what it needs to reuse basis values and column sums: ET_ENOMEM. */
/*@ requires s:      \valid_read(s) && et_surface_ok(s);
    requires S:      \valid(S + (0 .. na * nb - 1));
    requires ab:     \valid_read(a + (0 .. na - 1)) && \valid_read(b + (0 .. nb - 1));
    requires finite: (\forall integer i; 0 <= i < na ==> \is_finite(a[i])) && (\forall integer j; 0 <= j < nb ==> \is_finite(b[j]));
    requires apart:  \separated(S + (0 .. na * nb - 1), a + (0 .. na - 1)) && \separated(S + (0 .. na * nb - 1), b + (0 .. nb - 1));
    assigns  S[0 .. na * nb - 1];
    ensures  ends:   \result == ET_OK || \result == ET_ENOMEM;
*/
et_status et_surface_grid(et_vec3 *S, const et_surface *s, const double *a, size_t na, const double *b, size_t nb);

/* Doubles of workspace for et_surface_partials up to total order d, with a = min(d,p) + 1 and b = min(d,q) + 1:
 * a (p+1) + b (q+1) + 4 a (q+1) + max((p+1)(p+5), (q+1)(q+5)) + (d+1)(d+2); SIZE_MAX if that does not fit, so that no allocation succeeds. */
/*@ requires s:    \valid_read(s);
    assigns  \nothing;
    ensures  room: \result >= 2;
*/
size_t et_surface_partials_work(const et_surface *s, size_t d);

/*@ logic integer et_surface_partials_room(et_surface *s, integer d) =
        (\min(d, s->p) + 1)*(s->p + 1) + (\min(d, s->q) + 1)*(s->q + 1) + 4*(\min(d, s->p) + 1)*(s->q + 1) +
        \max((s->p + 1)*(s->p + 5), (s->q + 1)*(s->q + 5)) + (d + 1)*(d + 2);
*/

/* All partial derivatives of total order up to d, with the sides chosen at knots (of the value, too), in the order of et_exact_surface_ders: the one
 * a times in u and b times in v stands at (a+b)(a+b+1)/2 + b (A3.6, A4.4, Eq. 4.20).  From the right in both directions D[0] has the bits of
 * et_surface_point, and D[1] .. D[5] those of et_surface_ders but for the signs of zeros; derivatives of a polynomial surface beyond a degree are +0.
 *
 * Error of a coordinate of a polynomial surface's derivative: at most ((1-u)^-(7(p+q)+6) - 1) M_ab, M_ab the sum of the magnitudes of all terms.  A
 * rational surface's derivatives satisfy Leibniz' rule for w S = A within ((1-u)^-m - 1) times the magnitudes of the rule's terms, as a curve's do
 * (et_curve_ders), m = 7(p+q) + (p+1)(q+1) + 8, for orders up to 56.  All barring over- and underflow. */
/*@ requires s:      \valid_read(s) && et_surface_ok(s);
    requires D:      \valid(D + (0 .. (d + 1) * (d + 2) / 2 - 1));
    requires finite: \is_finite(u) && \is_finite(v);
    requires sides:  (side_u == ET_SIDE_RIGHT || side_u == ET_SIDE_LEFT) && (side_v == ET_SIDE_RIGHT || side_v == ET_SIDE_LEFT);
    requires room:   nwork >= et_surface_partials_room(s, d) && \valid(work + (0 .. nwork - 1));
    requires apart:  \separated(D + (0 .. (d + 1) * (d + 2) / 2 - 1), work + (0 .. nwork - 1));
    assigns  D[0 .. (d + 1) * (d + 2) / 2 - 1], work[0 .. nwork - 1];
    ensures  above:  s->weights == \null ==> \forall integer a, b; 0 <= a && 0 <= b && a + b <= d && (a > s->p || b > s->q) ==>
                         D[(a + b) * (a + b + 1) / 2 + b].x == 0.0 && D[(a + b) * (a + b + 1) / 2 + b].y == 0.0 &&
                         D[(a + b) * (a + b + 1) / 2 + b].z == 0.0;
*/
void et_surface_partials(et_vec3 *D, size_t d, const et_surface *s, double u, double v, et_side side_u, et_side side_v, double *work, size_t nwork);

/* The unit normal S_u x S_v / |S_u x S_v|, from the right at knots; workspace as for et_surface_point.  ET_ERANK (*n as it was) where the cross
 * product is 0, or cannot be told from 0: where its length does not exceed the bound of its error.
 *
 * With h = w (P - O), O the control point of the greatest share: where all control points that matter coincide, as at a pole, the derivative is 0
 * exactly. S_u and S_v have m = 7(p+q) + 2 roundings relative to the magnitudes of their terms (those of the derivatives' of the basis added, not
 * subtracted); as w A_u - w_u A, if there are weights, 2m + 2; the cross product c 28(p+q) + 14, relative to the products of the magnitudes, as a
 * vector: B.  The normal is off by at most 2 |B| / |c| + 5u. */
/*@ requires s:      \valid_read(s) && et_surface_ok(s);
    requires n:      \valid(n);
    requires finite: \is_finite(u) && \is_finite(v);
    requires room:   nwork >= et_surface_room(s) && \valid(work + (0 .. nwork - 1));
    requires apart:  \separated(n, s, work + (0 .. nwork - 1));
    assigns  *n, work[0 .. nwork - 1];
    ensures  ends:   \result == ET_OK || \result == ET_ERANK;
    ensures  range:  \result == ET_OK ==> \is_finite(n->x) && \is_finite(n->y) && \is_finite(n->z);
    ensures  kept:   \result != ET_OK ==> *n == \old(*n);
*/
et_status et_surface_normal(et_vec3 *n, const et_surface *s, double u, double v, double *work, size_t nwork);

typedef enum { ET_ALONG_U = 0, ET_ALONG_V } et_direction;

/*@ logic integer et_surface_degree(et_surface *s, et_direction along) = along == ET_ALONG_U ? s->p : s->q;
    logic integer et_surface_count(et_surface *s, et_direction along) = along == ET_ALONG_U ? s->nu : s->nv;
    predicate et_surface_across(et_surface *a, et_surface *b, et_direction along) = (a->weights == \null <==> b->weights == \null) &&
        (along == ET_ALONG_U ? a->q == b->q && a->nv == b->nv : a->p == b->p && a->nu == b->nu);
*/

/* et_curve_insert of each of the surface's curves along one direction, with the same bits (barring underflow); errors and bounds as there, and
 * ET_EINVAL for a direction that is none. */
/*@ requires refined: \valid(refined);
    requires s:       \valid_read(s) && et_surface_readable(s);
    requires apart:   \separated(refined, s);
    assigns  *refined;
    ensures  ends:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures  sizes:   \result == ET_OK ==> et_surface_degree(refined, along) == et_surface_degree(s, along) &&
                          et_surface_count(refined, along) == et_surface_count(s, along) + times && et_surface_across(refined, s, along);
    ensures  kept:    \result != ET_OK ==> *refined == \old(*refined);
*/
et_status et_surface_insert(et_surface *refined, const et_surface *s, et_direction along, double x, size_t times);

/* As et_curve_remove; a knot is removed from all curves along the direction or from none, and the greatest of their distances decides. */
/*@ requires reduced: \valid(reduced) && \valid(removed);
    requires s:       \valid_read(s) && et_surface_readable(s);
    requires apart:   \separated(reduced, removed, s);
    assigns  *reduced, *removed;
    ensures  ends:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures  often:   \result == ET_OK ==> *removed <= times;
    ensures  sizes:   \result == ET_OK ==> et_surface_degree(reduced, along) == et_surface_degree(s, along) &&
                          et_surface_count(reduced, along) == et_surface_count(s, along) - *removed && et_surface_across(reduced, s, along);
    ensures  kept:    \result != ET_OK ==> *reduced == \old(*reduced) && *removed == \old(*removed);
*/
et_status et_surface_remove(et_surface *reduced, size_t *removed, const et_surface *s, et_direction along, double x, size_t times, double tolerance);

/* As et_curve_elevate, along one direction, whose ends must be clamped. */
/*@ requires elevated: \valid(elevated);
    requires s:        \valid_read(s) && et_surface_readable(s);
    requires apart:    \separated(elevated, s);
    assigns  *elevated;
    ensures  ends:     \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures  degree:   \result == ET_OK ==> et_surface_degree(elevated, along) == et_surface_degree(s, along) + times &&
                           et_surface_count(elevated, along) >= et_surface_count(s, along) + times && et_surface_across(elevated, s, along);
    ensures  kept:     \result != ET_OK ==> *elevated == \old(*elevated);
*/
et_status et_surface_elevate(et_surface *elevated, const et_surface *s, et_direction along, size_t times);

#ifdef __cplusplus
}
#endif
#endif
