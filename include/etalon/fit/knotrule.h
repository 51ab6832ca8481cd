/* knotrule: interior knots from parameters (spec section 4). */
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
const char *et_knotrule_name(et_knotrule_kind kind);          /* "piegl", "faithful", "uniform", "averaging" */

/* Clamped knots u[0..nu-1] on [0,1] of degree p for nu - p - 1 control points, from the nt parameters t (non-decreasing, 0 .. 1).
 * ET_EINVAL: nu < 2p+2; AVERAGING with nu - p - 1 != nt; FAITHFUL or PIEGL with nt < nu - p - 1. */
et_status et_knotrule_make(double *u, size_t nu, size_t p, const double *t, size_t nt, et_knotrule_kind kind);

#ifdef __cplusplus
}
#endif
#endif
