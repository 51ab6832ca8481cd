/* knotrule: interior knots from parameters (Piegl and Tiller, The NURBS Book, section 9.4.1; You 2023, Eq. 2.10). */
#ifndef ETALON_FIT_KNOTRULE_H
#define ETALON_FIT_KNOTRULE_H
#include "etalon/base/status.h"
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* PIEGL: Eqs. 9.68, 9.69 (every span holds a parameter).  FAITHFUL: the source's reading, Eq. 2.10 averaging over the first h+1
 * parameters only.  UNIFORM: equal spans.  AVERAGING: Eq. 9.8, only when control points and parameters are equal in number. */
typedef enum { ET_KNOTRULE_PIEGL = 0, ET_KNOTRULE_FAITHFUL, ET_KNOTRULE_UNIFORM, ET_KNOTRULE_AVERAGING } et_knotrule_kind;

/*@ predicate et_knotrule_known(integer kind) = 0 <= kind <= 3;
    predicate et_knotrule_fits(integer nu, integer p, integer nt, integer kind) =
        et_knotrule_known(kind) && 1 <= p && 2*p + 2 <= nu && 2 <= nt &&
        (kind == ET_KNOTRULE_AVERAGING ==> nu - p - 1 == nt) && (kind != ET_KNOTRULE_UNIFORM ==> nu - p - 1 <= nt);
*/

/* "piegl", "faithful", "uniform", "averaging"; null past the last. */
/*@ assigns \result \from kind;
    ensures known:   et_knotrule_known(kind) ==> valid_read_string(\result);
    ensures named:   et_knotrule_known(kind) ==> \result != \null;
    ensures unknown: !et_knotrule_known(kind) ==> \result == \null;
*/
const char *et_knotrule_name(et_knotrule_kind kind);

/* Clamped knots u[0..nu-1] on [0,1] of degree p for h + 1 = nu - p - 1 control points, from the nt parameters t (non-decreasing, 0 .. 1).
 * With N = h + 1 - p spans the interior knots u[p+j], j = 1..N-1, are
 *   PIEGL      (1 - alpha) t_{i-1} + alpha t_i,  j nt/N = i + alpha, i whole, 0 <= alpha < 1   (d = nt/N; from integers: never off by one)
 *   FAITHFUL   (t_j + ... + t_{j+p-1}) / p, over the first h + 1 parameters even if there are more
 *   UNIFORM    j/N
 *   AVERAGING  the formula of FAITHFUL, nt = h + 1.
 * Knots are non-decreasing as rounded; error (3u relative) for PIEGL, (p + 1)u for the averages, u/2 for UNIFORM.
 * ET_EINVAL: p < 1; nu < 2p+2; nt < 2; AVERAGING with nu - p - 1 != nt; FAITHFUL or PIEGL with nt < nu - p - 1; kind unknown.
 * ET_ENOMEM: N^2 overflows. */
/*@ requires valid:     \valid(u + (0 .. nu - 1)) && \valid_read(t + (0 .. nt - 1));
    requires separated: \separated(u + (0 .. nu - 1), t + (0 .. nt - 1));
    requires sorted:    \forall integer i, j; 0 <= i <= j < nt ==> t[i] <= t[j];
    requires range:     \forall integer i; 0 <= i < nt ==> \is_finite(t[i]) && 0.0 <= t[i] <= 1.0;
    assigns u[0 .. nu - 1];
    ensures status:     \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures invalid:    !et_knotrule_fits(nu, p, nt, kind) <==> \result == ET_EINVAL;
    ensures clamped:    \result == ET_OK ==> \forall integer i; 0 <= i <= p ==> u[i] == 0.0 && u[nu-1-i] == 1.0;
    ensures ordered:    \result == ET_OK ==> \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    ensures rising:     \result == ET_OK && kind == ET_KNOTRULE_PIEGL ==> \forall integer i, j; p < i <= j < nu - p - 1 ==> u[i] <= u[j];
    ensures within:     \result == ET_OK && kind == ET_KNOTRULE_PIEGL ==> \forall integer i; p < i < nu - p - 1 ==>
                            \is_finite(u[i]) && 0.0 <= u[i] <= 1.0;
    ensures unchanged:  \result != ET_OK ==> \forall integer i; 0 <= i < nu ==> u[i] == \old(u[i]);
*/
et_status et_knotrule_make(double *u, size_t nu, size_t p, const double *t, size_t nt, et_knotrule_kind kind);

#ifdef __cplusplus
}
#endif
#endif
