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

/* For a polynomial, glued fit with equal parameters in both views (improved and joint fits) and its data, D_c = data[c-1]; both are copied,
 * fit and data may go.  Equal, bit for bit, to et_fit_measure's nov at the fit's own control points.  ET_EINVAL: a shell rational, open or not
 * valid, parameters of the views not equal, nov not that of fit->data, a null pointer.  ET_ENOMEM.  Golden: none (what it makes is opaque). */
/*@ requires out:    \valid(objective);
    requires fit:    \valid_read(fit) && et_fit_readable((et_fit *)fit);
    requires data:   \valid_read(data + (0 .. nov - 1));
    requires apart:  \separated(objective, fit, data + (0 .. nov - 1));
    assigns  *objective;
    ensures  made:   \result == ET_OK ==> \valid(*objective);
    ensures  same:   \result != ET_OK ==> *objective == \old(*objective);
*/
et_status et_objective_new(et_objective **objective, const et_fit *fit, const et_vec3 *data, size_t nov);

/* et_objective_free(NULL) does nothing.  Golden: none (nothing is computed). */
/*@ requires known: objective == \null || \valid(objective);
    assigns  \nothing;
    frees    objective;
    ensures  freed: objective != \null ==> \allocable(objective);
*/
void et_objective_free(et_objective *objective);

/* 3 NOV(control): coordinate d of control class c stands at x[3*(c-1) + d].  Golden: none (the rows of et_doublenet_nov hold its values). */
/*@ requires known:  \valid_read(objective);
    assigns  \nothing;
    ensures  whole:  \result % 3 == 0 && \result >= 12;
*/
size_t et_objective_size(const et_objective *objective);

/* *value = E(x); an et_search_fn, context being the et_objective.  Each surface point has the bits of et_surface_point, each distance those of
 * et_vec3_distance, and the sum in class order is et_real_sum: the value depends on x alone, not on what was evaluated before.  One object serves
 * one thread at a time.  ET_EINVAL if n is not et_objective_size, or for a null pointer. */
/*@ requires out:    value == \null || \valid(value);
    requires x:      x == \null || \valid_read(x + (0 .. n - 1));
    requires known:  objective == \null || \valid((et_objective *)objective);
    requires finite: x != \null ==> \forall integer k; 0 <= k < n ==> \is_finite(x[k]);
    assigns  *value, *(et_objective *)objective;
    ensures  sign:   \result == ET_OK && \is_finite(*value) ==> *value >= 0;
    ensures  same:   \result != ET_OK && value != \null ==> *value == \old(*value);
*/
et_status et_objective_eval(double *value, const double *x, size_t n, void *objective);

/* Evaluations so far: how many were full, and how many incremental; their sum is the number of successful calls of et_objective_eval.
 * Golden: none (which evaluations are incremental is a matter of cost). */
/*@ requires known:  \valid_read(objective);
    requires out:    \valid(full) && \valid(incremental) && \separated(full, incremental, objective);
    assigns  *full, *incremental;
*/
void et_objective_counts(uint64_t *full, uint64_t *incremental, const et_objective *objective);

#ifdef __cplusplus
}
#endif
#endif
