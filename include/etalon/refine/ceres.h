/* ceres: gradient refinement by the Ceres solver.  The one module whose code is C++; not of the bit-for-bit class: its results agree
 * between builds within the tolerance it was asked for (docs/ceres.md). */
#ifndef ETALON_REFINE_CERES_H
#define ETALON_REFINE_CERES_H
#include "etalon/base/task.h"
#include "etalon/fit/fit.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    size_t iterations;                    /* in all; default 400 */
    double tolerance;                     /* relative change of the objective at which a stage ends; default 1e-10 */
    double smooth_start, smooth_end;      /* mu of sqrt(|r|^2 + mu^2) is driven from start to end by factors of ten; 1e-2, 1e-8 */
} et_ceres_options;

typedef struct {
    double before, after;                 /* E (Eq. 6.2), unsmoothed, as et_fit_measure's nov */
    size_t iterations, evaluations;
    size_t made;                          /* entries of history written */
    int converged;
} et_ceres_summary;

et_ceres_options et_ceres_defaults(void);

/* (a) The control points of a closed polynomial fit under the sum of distances.  fit->shell is replaced by the best found, never a
 * worse one.  history (size nhistory, may be null): E after each iteration. */
et_status et_ceres_points(et_fit *fit, et_ceres_summary *summary, double *history, size_t nhistory, const et_vec3 *data, size_t nov,
                          const et_ceres_options *options, const et_task *task, et_message *message);

/* (b) Control points, weights and the data's parameters together: the shell becomes rational, the border shared in points and weights; each
 * data class has its own (u, v), border data move along the border only, corners not at all.  uv[2*(c-1)], uv[2*(c-1)+1]: the parameters
 * of class c at the end (border: the bottom view's).  E is measured at these parameters. */
et_status et_ceres_full(et_fit *fit, double *uv, et_ceres_summary *summary, double *history, size_t nhistory, const et_vec3 *data, size_t nov,
                        const et_ceres_options *options, const et_task *task, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
