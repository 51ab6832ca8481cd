/* optimum: the true minimum of E(P) = sum over the NOV data classes of |D_c - (N P)_c|, with a certificate.
 *
 * E is convex in the NOV control classes P, so it has a least value E*, and for all y_c with |y_c| <= 1 and N'y = 0
 *     sum_c y_c . D_c = sum_c y_c . (D_c - (N P)_c) <= E(P)      for every P:
 * such a y proves a lower bound.  (You 2023, Eq. 6.2, is the objective; the dual is that of a sum of norms, Andersen, Christiansen, Conn and Overton 2000.)
 */
#ifndef ETALON_REFINE_OPTIMUM_H
#define ETALON_REFINE_OPTIMUM_H
#include "etalon/base/task.h"
#include "etalon/fit/fit.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    size_t iterations;                    /* at most, default 100 */
    double gap;                           /* done when (value - lower) <= gap * value, default 1e-12 */
} et_optimum_options;

/* All three are proved, in ball arithmetic: E(P) <= value at the control points delivered, lower <= E(P) for all P; gap >= value - lower. */
typedef struct {
    double before;                        /* an upper bound of E at the start */
    double value, lower, gap;
    size_t iterations;                    /* made */
} et_optimum_result;

et_optimum_options et_optimum_defaults(void);
/* fit: as et_objective_new takes it; its control points become the best found.  dual, may be null: NOV vectors y that prove `lower`.  history, may be null
 * (room entries): the value after each iteration. */
et_status et_optimum_find(et_fit *fit, et_optimum_result *result, et_vec3 *dual, double *history, size_t room, const et_vec3 *data, size_t nov,
                          const et_optimum_options *options, const et_task *task, et_message *message);
/* The lower bound that any y proves, whatever it is: residuals of |y_c| <= 1 and N'y = 0 are charged for. */
et_status et_optimum_bound(double *lower, const et_vec3 *dual, size_t nov, const et_fit *fit, const et_vec3 *data);

#ifdef __cplusplus
}
#endif
#endif
