/* enclosure: a posteriori bounds of a fit (Rump, Verification methods, 2010): how far its control points are from the exact least-squares solution. */
#ifndef ETALON_FIT_ENCLOSURE_H
#define ETALON_FIT_ENCLOSURE_H
#include "etalon/fit/fit.h"
#ifdef __cplusplus
extern "C" {
#endif

/* |P - exact| <= radius, coordinate by coordinate, the exact solution being that of the data, parameters and knots as the doubles they are (so that errors
 * of the basis functions count). */
typedef struct {
    et_vec3 *radius[2];                   /* radius[view][i*cy + j], of the control point (i, j) */
    size_t count;                         /* cx cy, of each view */
    double condition;                     /* estimate of the 2-norm condition number of the whole least-squares matrix */
    double backward;                      /* normwise backward error of P, in units of eps */
    size_t undecided;                     /* coordinates not proved to be the correctly rounded ones */
} et_enclosure;

et_status et_enclosure_make(et_enclosure *enclosure, const et_fit *fit, const et_vec3 *data, size_t nov, const et_fit_options *options,
                            et_message *message);
void et_enclosure_free(et_enclosure *enclosure);
et_status et_enclosure_refine(et_fit *fit, et_enclosure *enclosure, const et_vec3 *data, size_t nov, const et_fit_options *options, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
