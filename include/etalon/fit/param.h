/* param: parameters of gridded data (Piegl and Tiller, section 9.2; You 2023, Eqs. 2.8, 5.1-5.4). */
#ifndef ETALON_FIT_PARAM_H
#define ETALON_FIT_PARAM_H
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* t_i = t_{i-1} + |D_i - D_{i-1}|^e / L with e = 1 chord, 0.8 exponential, 0.5 centripetal; t_i = i/(n-1) uniform. */
typedef enum { ET_PARAM_UNIFORM = 0, ET_PARAM_CHORD, ET_PARAM_CENTRIPETAL, ET_PARAM_EXPONENTIAL } et_param_method;
const char *et_param_name(et_param_method method);           /* "uniform" ...; null past the last */

/* Parameters t[0..n-1], n >= 2, of the points D[0], D[stride], ..., D[(n-1)*stride]: non-decreasing, t[0] = 0, t[n-1] = 1.
 * Returns 1 if the row has no length and got the uniform parameters instead, else 0.  work: n doubles. */
int et_param_row(double *t, size_t n, const et_vec3 *D, size_t stride, et_param_method method, double *work);

/* Average over all lines of the grid D[i*ny + j]: s[0..nx-1] (along i, averaged over j) and r[0..ny-1] (along j, averaged over i).
 * *flat counts the lines of no length.  ET_EINVAL, ET_ENOMEM. */
et_status et_param_grid(double *s, size_t nx, double *r, size_t ny, size_t *flat, const et_vec3 *D, et_param_method method);

/* a[i] = (a[i] + b[i]) / 2: standardised parameters of two views (Eqs. 5.3, 5.4), written to both. */
void et_param_standardise(double *a, double *b, size_t n);

#ifdef __cplusplus
}
#endif
#endif
