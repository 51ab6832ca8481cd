/* optimum: the true minimum of E(P) = sum over the NOV data classes of |D_c - (N P)_c|, with a certificate.
 *
 * E is convex in the NOV control classes P, so it has a least value E*, and for all y_c with |y_c| <= 1 and N'y = 0
 *     sum_c y_c . D_c = sum_c y_c . (D_c - (N P)_c) <= E(P)      for every P:
 * such a y proves a lower bound.  (You 2023, Eq. 6.2, is the objective; the dual is that of a sum of norms, Andersen, Christiansen, Conn and Overton 2000.)
 * N holds the exact basis functions at the knots and parameters as they are.  Bit for bit the same with every compiler; no BLAS is used.
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
    double gap;                           /* >= 0: done when (value - lower) <= gap * value, default 1e-12 */
} et_optimum_options;

/* All three are proved, in ball arithmetic: E(P) <= value at the control points delivered, lower <= E(P) for all P; gap >= value - lower. */
typedef struct {
    double before;                        /* an upper bound of E at the start */
    double value, lower, gap;
    size_t iterations;                    /* made */
} et_optimum_result;

/*@ predicate et_optimum_options_ok(et_optimum_options o) = \is_plus_infinity(o.gap) || (\is_finite(o.gap) && 0 <= o.gap); */

/* Golden: none (two constants, restated by the property) */
/*@ assigns \nothing;
    ensures iterations: \result.iterations == 100;
    ensures gap:        \result.gap == 1e-12;
    ensures valid:      et_optimum_options_ok(\result);
*/
et_optimum_options et_optimum_defaults(void);

/* fit: as et_objective_new takes it, all numbers finite, parameters in order; its control points become the best found, or stay as they are when nothing
 * better is found; knots stay, the shell stays closed.  Control points that the data do not determine stay where they are.
 *
 * dual, may be null: NOV vectors y from which et_optimum_bound proves just `lower`.  history, may be null (room entries): the least E seen up to each
 * iteration, within rounding, non-increasing.  options null: the defaults; iterations 0 leaves the control points and bounds how far E could fall.
 * The iterations also end when rounding lets neither value nor bound grow better: the gap is then wider than asked for, and told.  Where nothing can be
 * proved of the least E (et_optimum_bound), lower is 0, which always holds, and the message, otherwise left alone, says so; the status is ET_OK.
 *
 * task is told iterations done of options->iterations; what it returns but ET_OK ends the search: the best so far is delivered, certified, and that
 * status returned.
 * ET_EINVAL (null pointer, options out of range, a fit that is not as described, nov not NOV of fit->data, data not finite or so large that E overflows),
 * ET_ENOMEM; outputs are then unchanged, but for history. */
/*@ requires fit:       fit == \null || (\valid(fit) && et_fit_readable(fit));
    requires result:    result == \null || \valid(result);
    requires dual:      dual == \null || \valid(dual + (0 .. nov - 1));
    requires history:   history == \null || \valid(history + (0 .. room - 1));
    requires data:      data == \null || \valid_read(data + (0 .. nov - 1));
    requires options:   options == \null || \valid_read(options);
    requires task:      task == \null || \valid_read(task);
    requires message:   message == \null || \valid(message);
    requires apart:     fit != \null && result != \null && data != \null ==>
                          \separated(fit, result, data + (0 .. nov - 1)) &&
                          (dual != \null ==> \separated(dual + (0 .. nov - 1), fit, result, data + (0 .. nov - 1))) &&
                          (history != \null ==> \separated(history + (0 .. room - 1), fit, result, data + (0 .. nov - 1)));
    assigns fit->shell.view[0].points[0 .. fit->shell.view[0].nu * fit->shell.view[0].nv - 1],
            fit->shell.view[1].points[0 .. fit->shell.view[1].nu * fit->shell.view[1].nv - 1],
            *result, dual[0 .. nov - 1], history[0 .. room - 1], *message,
            ((char *)task->context)[0 .. \block_length((char *)task->context) - 1];
    ensures refused:    (fit == \null || result == \null || data == \null) ==> \result == ET_EINVAL;
    ensures options:    options != \null && !\old(et_optimum_options_ok(*options)) ==> \result == ET_EINVAL;
    ensures order:      \result == ET_OK ==> 0 <= result->lower && result->lower <= result->value <= result->before && 0 <= result->gap;
    ensures iterations: \result == ET_OK && options != \null ==> result->iterations <= options->iterations;
*/
et_status et_optimum_find(et_fit *fit, et_optimum_result *result, et_vec3 *dual, double *history, size_t room, const et_vec3 *data, size_t nov,
                          const et_optimum_options *options, const et_task *task, et_message *message);

/* The lower bound that any y proves, whatever it is: with z = y - N x nearly the nearest to y of N'z = 0, found in doubles, and evaluated in ball arithmetic,
 *     E(P) >= E* >= (sum_c z_c . D_c - |N'z| |P*|) / max |z_c|,
 * |P*| bounded by |N P*| <= 2 sum |D_c| and the least singular values of the two directions' basis functions; rounded downwards; 0 where that is negative, or
 * nothing can be proved: y not finite or of no use, or control points left undetermined by parameters that do not run from end to end of clamped knots.  The
 * control points of fit do not matter.  ET_EINVAL (null pointer; fit, nov and data as for et_optimum_find), ET_ENOMEM; lower is then unchanged. */
/*@ requires lower:  lower == \null || \valid(lower);
    requires dual:   dual == \null || \valid_read(dual + (0 .. nov - 1));
    requires fit:    fit == \null || (\valid_read(fit) && et_fit_readable((et_fit *)fit));
    requires data:   data == \null || \valid_read(data + (0 .. nov - 1));
    requires apart:  lower != \null && dual != \null && fit != \null && data != \null ==>
                       \separated(lower, dual + (0 .. nov - 1), fit, data + (0 .. nov - 1));
    assigns *lower;
    ensures refused:   (lower == \null || dual == \null || fit == \null || data == \null) ==> \result == ET_EINVAL;
    ensures bound:     \result == ET_OK ==> *lower >= 0.0 && \is_finite(*lower);
    ensures unchanged: \result != ET_OK && lower != \null ==> *lower == \old(*lower);
*/
et_status et_optimum_bound(double *lower, const et_vec3 *dual, size_t nov, const et_fit *fit, const et_vec3 *data);

#ifdef __cplusplus
}
#endif
#endif
