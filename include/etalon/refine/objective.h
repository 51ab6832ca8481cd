/* objective: E(P) = sum over the NOV data classes of |D_c - (N P)_c| (Eq. 6.2) as a function of the NOV control classes, evaluated through local
 * support, and incrementally where a candidate differs from the one before in few control points: with the same bits either way.
 */
#ifndef ETALON_REFINE_OBJECTIVE_H
#define ETALON_REFINE_OBJECTIVE_H
#include "etalon/fit/fit.h"
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct et_objective et_objective;                    /* opaque: basis values, layout and the last candidate's state */

/* For a polynomial, closed fit and its data.  Equal, bit for bit, to et_fit_measure's nov at the fit's own control points. */
et_status et_objective_new(et_objective **objective, const et_fit *fit, const et_vec3 *data, size_t nov);
void et_objective_free(et_objective *objective);

/* 3 NOV(control): coordinate d of control class c stands at x[3*(c-1) + d]. */
size_t et_objective_size(const et_objective *objective);

/* *value = E(x); an et_search_fn, context being the et_objective.  ET_EINVAL if n is not et_objective_size. */
et_status et_objective_eval(double *value, const double *x, size_t n, void *objective);

/* Evaluations so far, and how many of them were incremental. */
void et_objective_counts(uint64_t *full, uint64_t *incremental, const et_objective *objective);

#ifdef __cplusplus
}
#endif
#endif
