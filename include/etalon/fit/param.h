/* param: parameters of gridded data (Piegl and Tiller, The NURBS Book, section 9.2; You 2023, Eqs. 2.8, 5.1-5.4). */
#ifndef ETALON_FIT_PARAM_H
#define ETALON_FIT_PARAM_H
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

/* t_i = t_{i-1} + |D_i - D_{i-1}|^e / L with e = 1 chord, 0.8 exponential, 0.5 centripetal; t_i = i/(n-1) uniform. */
typedef enum { ET_PARAM_UNIFORM = 0, ET_PARAM_CHORD, ET_PARAM_CENTRIPETAL, ET_PARAM_EXPONENTIAL } et_param_method;

/*@ predicate et_params(double *t, integer n) =
        t[0] == 0.0 && t[n-1] == 1.0 && (\forall integer i; 0 <= i < n - 1 ==> t[i] <= t[i+1]);
    predicate et_param_known(integer method) = 0 <= method <= 3;
    predicate et_point_finite(et_vec3 *D) = \is_finite(D->x) && \is_finite(D->y) && \is_finite(D->z);
    predicate et_line_finite(et_vec3 *D, integer stride, integer i) = et_point_finite(D + i*stride);
    predicate et_points_finite(et_vec3 *D, integer n) = \forall integer i; 0 <= i < n ==> et_point_finite(D + i);
*/

/* "uniform", "chord", "centripetal", "exponential": the names options and reports use; null past the last. */
/*@ assigns \result \from method;
    ensures known:   et_param_known(method) ==> valid_read_string(\result);
    ensures named:   et_param_known(method) ==> \result != \null;
    ensures unknown: !et_param_known(method) ==> \result == \null;
*/
const char *et_param_name(et_param_method method);

/* Parameters t[0..n-1] of the points D[0], D[stride], ..., D[(n-1)*stride] (Eq. 2.8): t_i is the sum of the first i powers of distances over the sum
 * of all of them.  t is non-decreasing also as rounded, t[0] = 0 and t[n-1] = 1 exactly.  Distances are scaled by a power of two first, so that no
 * finite data overflow or vanish, and data scaled by a power of two have the same chord lengths' bits.  Error of t_i: (2n + 6) u t_i for chord.
 * Returns 1 if the row has no length and got the uniform parameters instead, else 0 (0 too where uniform is asked for).  work: n doubles. */
/*@ requires size:      2 <= n && 1 <= stride && (n - 1)*stride < SIZE_MAX;
    requires method:    et_param_known(method);
    requires valid:     \valid(t + (0 .. n - 1)) && \valid(work + (0 .. n - 1)) && \valid_read(D + (0 .. (n - 1)*stride));
    requires finite:    \forall integer i; 0 <= i < n ==> et_line_finite((et_vec3 *)D, stride, i);
    requires separated: \separated(t + (0 .. n - 1), work + (0 .. n - 1), D + (0 .. (n - 1)*stride));
    assigns t[0 .. n - 1], work[0 .. n - 1];
    ensures params:     et_params(t, n);
    ensures flat:       \result == 0 || \result == 1;
    ensures uniform:    method == ET_PARAM_UNIFORM ==> \result == 0;
*/
int et_param_row(double *t, size_t n, const et_vec3 *D, size_t stride, et_param_method method, double *work);

/* Average over all lines of the grid D[i*ny + j] (You 2023, Eqs. 5.1, 5.2): s[0..nx-1] along i, averaged over j, and r[0..ny-1] along j, averaged
 * over i.  *flat counts the lines of no length.  Sums are et_real_sum, which is monotone: s and r are non-decreasing from 0 to 1 like their terms.
 * ET_EINVAL (nx < 2, ny < 2, method unknown), ET_ENOMEM. */
/*@ requires valid:     \valid(s + (0 .. nx - 1)) && \valid(r + (0 .. ny - 1)) && \valid(flat) && \valid_read(D + (0 .. nx*ny - 1));
    requires finite:    et_points_finite((et_vec3 *)D, nx*ny);
    requires separated: \separated(s + (0 .. nx - 1), r + (0 .. ny - 1), flat, D + (0 .. nx*ny - 1));
    assigns s[0 .. nx - 1], r[0 .. ny - 1], *flat;
    ensures status:     \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures invalid:    nx < 2 || ny < 2 || !et_param_known(method) ==> \result == ET_EINVAL;
    ensures params:     \result == ET_OK ==> et_params(s, nx) && et_params(r, ny);
    ensures flat:       \result == ET_OK ==> *flat <= nx + ny;
    ensures unchanged:  \result != ET_OK ==> *flat == \old(*flat);
*/
et_status et_param_grid(double *s, size_t nx, double *r, size_t ny, size_t *flat, const et_vec3 *D, et_param_method method);

/* Standardised parameters of two views (You 2023, Eqs. 5.3, 5.4): (a[i] + b[i]) / 2, written to both; 0 and 1 stay exact. */
/*@ requires valid:     \valid(a + (0 .. n - 1)) && \valid(b + (0 .. n - 1));
    requires separated: \separated(a + (0 .. n - 1), b + (0 .. n - 1));
    requires range:     \forall integer i; 0 <= i < n ==> 0.0 <= a[i] <= 1.0 && 0.0 <= b[i] <= 1.0;
    assigns a[0 .. n - 1], b[0 .. n - 1];
    ensures shared:     \forall integer i; 0 <= i < n ==> a[i] == b[i];
    ensures between:    \forall integer i; 0 <= i < n ==> 0.0 <= a[i] <= 1.0;
*/
void et_param_standardise(double *a, double *b, size_t n);

#ifdef __cplusplus
}
#endif
#endif
