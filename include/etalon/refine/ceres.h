/* ceres: gradient refinement by the Ceres solver.  The one module whose code is C++; not of the bit-for-bit class: its results agree
 * between builds within the tolerance it was asked for (docs/ceres.md).
 *
 * Both functions minimise E = sum over the NOV data classes of |D_c - S_c| (You 2023, Eq. 6.2), smoothed to sum sqrt(|r_c|^2 + mu^2) with mu taken
 * from smooth_start to smooth_end by factors of ten, each stage started where the one before ended: L-BFGS with a Wolfe line search, in
 * coordinates in which the Gauss-Newton matrix of the moment is the unit matrix (for the control points: a step of length one is a step of
 * iteratively reweighted least squares).  E is without smoothing wherever it is reported.
 */
#ifndef ETALON_REFINE_CERES_H
#define ETALON_REFINE_CERES_H
#include "etalon/base/task.h"
#include "etalon/fit/fit.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    size_t iterations;                    /* in all, >= 1; default 400 */
    double tolerance;                     /* relative change of the objective at which a stage ends, >= 0; default 1e-10 */
    double smooth_start, smooth_end;      /* mu, start >= end > 0; defaults 1e-2, 1e-8 */
} et_ceres_options;

typedef struct {
    double before, after;                 /* E of the fit as it came and as it went: after <= before */
    size_t iterations, evaluations;
    size_t made;                          /* entries of history written: the lesser of iterations and nhistory */
    int converged;                        /* the last stage ended by the tolerance */
} et_ceres_summary;

/*@ predicate et_ceres_options_ok(et_ceres_options o) = 1 <= o.iterations
        && (\is_plus_infinity(o.tolerance) || (\is_finite(o.tolerance) && 0 <= o.tolerance))
        && \is_finite(o.smooth_start) && \is_finite(o.smooth_end) && 0 < o.smooth_end <= o.smooth_start;
*/

/* Golden: none (four constants, restated by the property) */
/*@ assigns \nothing;
    ensures valid:      et_ceres_options_ok(\result);
    ensures iterations: \result.iterations == 400;
*/
et_ceres_options et_ceres_defaults(void);

/* (a) The control points of a closed polynomial fit.  The problem is convex: the result is within NOV * smooth_end of the least E, and what the
 * tolerance leaves.  fit->shell keeps its knots and stays closed; its control points are replaced by the best found, or stay as they
 * are when nothing better is found.  before and after are et_fit_measure's nov.
 *
 * history (null, or nhistory numbers): the least E seen up to each iteration, non-increasing; within rounding of `after` at the last.
 * options null: the defaults.  task is told iterations done of options->iterations; what it returns but ET_OK ends the search: the best
 * so far is delivered, and that status returned.
 * ET_EINVAL (null pointer, options out of range, shell not glued or rational, nov not NOV of fit->data, data not finite or so large that
 * E overflows), ET_ENOMEM, ET_EINTERNAL; outputs are then unchanged, but for history.
 * Golden: none (not of the bit-for-bit class; the property compares with optima known exactly and with another algorithm) */
/*@ requires fit:       fit == \null || (\valid(fit) && et_fit_readable(fit));
    requires summary:   summary == \null || \valid(summary);
    requires history:   history == \null || \valid(history + (0 .. nhistory - 1));
    requires data:      data == \null || \valid_read(data + (0 .. nov - 1));
    requires options:   options == \null || \valid_read(options);
    requires task:      task == \null || \valid_read(task);
    requires message:   message == \null || \valid(message);
    requires apart:     fit != \null && summary != \null && data != \null ==>
                          \separated(fit, summary, data + (0 .. nov - 1), history + (0 .. nhistory - 1)) &&
                          \separated(fit, summary, options) && \separated(fit, summary, message) &&
                          (history != \null ==> \separated(history + (0 .. nhistory - 1), options));
    assigns fit->shell.view[0].points[0 .. fit->shell.view[0].nu * fit->shell.view[0].nv - 1],
            fit->shell.view[1].points[0 .. fit->shell.view[1].nu * fit->shell.view[1].nv - 1],
            *summary, history[0 .. nhistory - 1], *message,
            ((char *)task->context)[0 .. \block_length((char *)task->context) - 1];
    ensures refused:    (fit == \null || summary == \null || data == \null) ==> \result == ET_EINVAL;
    ensures options:    options != \null && !\old(et_ceres_options_ok(*options)) ==> \result == ET_EINVAL;
    ensures not_worse:  \result == ET_OK ==> summary->after <= summary->before;
    ensures iterations: \result == ET_OK && options != \null ==> summary->iterations <= options->iterations;
    ensures made:       \result == ET_OK ==> summary->made <= nhistory && summary->made <= summary->iterations;
*/
et_status et_ceres_points(et_fit *fit, et_ceres_summary *summary, double *history, size_t nhistory, const et_vec3 *data, size_t nov,
                          const et_ceres_options *options, const et_task *task, et_message *message);

/* (b) Control points, weights and the data's parameters together: the shell becomes rational, the border shared in points and weights; each
 * data class has its own (u, v), border data move along the border only, corners not at all.  uv[2*(c-1)], uv[2*(c-1)+1]: the parameters
 * of class c at the end (border: the bottom view's), in [0, 1].
 *
 * Knots stay, and so do the weights at the four corners (a common factor of all weights changes nothing); the others stay within a factor of 100
 * of their start, 1 for a polynomial fit.  A parameter that starts at 0 or 1 stays there.  The problem is not convex: what is found is better than
 * the start, not best.  before and after are E at the parameters of each class, before at those of the fit: et_fit_measure's nov within
 * rounding, for the surface is evaluated as a rational one.  The rest as for et_ceres_points.
 * ET_EINVAL (null pointer, options out of range, shell not glued, nov or data as above), ET_ENOMEM, ET_EINTERNAL.
 * Golden: none (not of the bit-for-bit class; the property measures the result by another evaluation) */
/*@ requires fit:       fit == \null || (\valid(fit) && et_fit_readable(fit));
    requires uv:        uv == \null || \valid(uv + (0 .. 2 * nov - 1));
    requires summary:   summary == \null || \valid(summary);
    requires history:   history == \null || \valid(history + (0 .. nhistory - 1));
    requires data:      data == \null || \valid_read(data + (0 .. nov - 1));
    requires options:   options == \null || \valid_read(options);
    requires task:      task == \null || \valid_read(task);
    requires message:   message == \null || \valid(message);
    requires apart:     fit != \null && uv != \null && summary != \null && data != \null ==>
                          \separated(fit, uv + (0 .. 2 * nov - 1), summary, data + (0 .. nov - 1), history + (0 .. nhistory - 1)) &&
                          \separated(fit, uv + (0 .. 2 * nov - 1), summary, options) && \separated(fit, uv + (0 .. 2 * nov - 1), summary, message) &&
                          (history != \null ==> \separated(history + (0 .. nhistory - 1), options));
    assigns *fit, uv[0 .. 2 * nov - 1], *summary, history[0 .. nhistory - 1], *message,
            ((char *)task->context)[0 .. \block_length((char *)task->context) - 1];
    ensures refused:    (fit == \null || uv == \null || summary == \null || data == \null) ==> \result == ET_EINVAL;
    ensures options:    options != \null && !\old(et_ceres_options_ok(*options)) ==> \result == ET_EINVAL;
    ensures not_worse:  \result == ET_OK ==> summary->after <= summary->before;
    ensures parameters: \result == ET_OK ==> \forall integer k; 0 <= k < 2 * nov ==> 0 <= uv[k] <= 1;
    ensures made:       \result == ET_OK ==> summary->made <= nhistory && summary->made <= summary->iterations;
*/
et_status et_ceres_full(et_fit *fit, double *uv, et_ceres_summary *summary, double *history, size_t nhistory, const et_vec3 *data, size_t nov,
                        const et_ceres_options *options, const et_task *task, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
