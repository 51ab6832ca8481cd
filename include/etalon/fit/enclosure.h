/* enclosure: how far a fit's control points are from the exact least-squares solution, and that solution itself, rounded once.
 *
 * The exact solution is that of the approach for the data, parameters and knots as the doubles they are, the basis functions at them being exact:
 *   conventional  P = Nu+ D (Nv+)' of each view (with interpolated corners: the constrained optimum);
 *   improved      the same, then the exact means along the border and, unless corners are free, the data's corners;
 *   joint         the least sum over the NOV data classes in the NOV control classes.
 * It is enclosed, |P - exact| <= radius coordinate by coordinate, by a verified computation (Rump, Verification methods: rigorous results using
 * floating-point arithmetic, Acta Numerica 2010): with N = Q R, T about R^-1 in double and B = N T, a bound of ||I - B'B|| < 1 makes every bound
 * rigorous; residuals and basis functions are double-double.  No rounding mode is changed and no BLAS is used: the same bits everywhere.
 * All bounds count overflow and underflow: what cannot be bounded is refused.
 */
#ifndef ETALON_FIT_ENCLOSURE_H
#define ETALON_FIT_ENCLOSURE_H
#include "etalon/fit/fit.h"
#ifdef __cplusplus
extern "C" {
#endif

/* |P - exact| <= radius, coordinate by coordinate. */
typedef struct {
    et_vec3 *radius[2];                   /* radius[view][i*cy + j], of the control point (i, j); may be infinite */
    size_t count;                         /* cx cy, of each view */
    double condition;                     /* estimate of the 2-norm condition number of the whole least-squares matrix; 1 without unknowns */
    double backward;                      /* normwise backward error of P, in units of eps */
    size_t undecided;                     /* coordinates not proved to be the correctly rounded ones */
} et_enclosure;

/*@ predicate et_enclosure_stored(et_enclosure *e) =
        \valid(e->radius[0] + (0 .. e->count - 1)) && \valid(e->radius[1] + (0 .. e->count - 1));
    predicate et_enclosure_of(et_enclosure *e, et_fit *fit) =
        et_enclosure_stored(e) && e->count == fit->shell.view[0].nu * fit->shell.view[0].nv && e->undecided <= 6 * e->count;
*/

/* The enclosure of the fit's control points; degrees, control net, approach and corners of the options are used and must be the fit's.
 * The radius is the distance of P from the solution in double-double, plus the proved error of that, about (condition + condition^2 |r|/(|N||x|)) u^2
 * |x|, r the least-squares residual: so it is nearly the true error of P.  A coordinate is proved when all numbers the exact one can be
 * lie strictly inside the interval of reals that round to P; corners that stand at the data's have the radius 0.
 *
 * condition: greatest over least singular value, by 40 steps of the power method with N and with T (lower estimates, commonly within some per cent);
 * for views by themselves that of both together.  backward: Karlson and Walden's estimate (1997) of the least perturbation of N that makes P exact,
 * |(N'N + t^2 I)^-1/2 N'r| / |P| with t = |r| / |P|, relative to |N|, N'r taken as N'N (P - exact), by 40 steps of conjugate gradients (from below;
 * N and not the data is perturbed); the worst coordinate of the worst view.  For improved r and the exact ones are those of the means.
 *
 * ET_EINVAL: nov, options, or a fit that is not what the options say (rational, other sides or degrees, knots not clamped, parameters that do not run
 * over the domain in order, views that do not share what the approach shares).  ET_ERANK: the exact matrix is rank deficient.  ET_ENOCONV: no bound
 * can be given, the condition number of one direction (fixed corners, joint: of the whole; columns scaled) being about 1e13 and more, basis functions
 * nearly underflowing.  ET_ENOMEM.  Freed by et_enclosure_free.
 * Golden: none (bounds hold with any radius that is not too small; the rows of et_enclosure_refine have radii below half an ulp). */
/*@ requires valid:     \valid(enclosure) && \valid_read(fit) && \valid_read(options) && \valid_read(data + (0 .. nov - 1));
    requires fit:       et_fit_readable((et_fit *)fit) && et_shell_readable((et_shell *)&fit->shell);
    requires message:   message == \null || \valid(message);
    requires finite:    et_points_finite((et_vec3 *)data, nov);
    requires separated: \separated(enclosure, fit, data + (0 .. nov - 1), options, message);
    assigns *enclosure, *message;
    ensures status:     \result == ET_OK || \result == ET_EINVAL || \result == ET_ERANK || \result == ET_ENOCONV || \result == ET_ENOMEM ||
                        \result == ET_EINTERNAL;
    ensures invalid:    !et_net_ok(fit->data.nx, fit->data.ny) || nov != NOV(fit->data.nx, fit->data.ny) || !et_fit_known(options->approach)
                            ==> \result == ET_EINVAL;
    ensures stored:     \result == ET_OK ==> et_enclosure_of(enclosure, (et_fit *)fit);
    ensures radii:      \result == ET_OK ==> \forall integer w, i; 0 <= w < 2 && 0 <= i < enclosure->count ==>
                            enclosure->radius[w][i].x >= 0.0 && enclosure->radius[w][i].y >= 0.0 && enclosure->radius[w][i].z >= 0.0;
    ensures unchanged:  \result != ET_OK ==> *enclosure == \old(*enclosure);
*/
et_status et_enclosure_make(et_enclosure *enclosure, const et_fit *fit, const et_vec3 *data, size_t nov, const et_fit_options *options,
                            et_message *message);

/* Frees what an enclosure owns and leaves one of zeros, which may be freed again.  Golden: none (storage). */
/*@ requires valid: \valid(enclosure);
    assigns *enclosure;
    ensures empty: enclosure->radius[0] == \null && enclosure->radius[1] == \null && enclosure->count == 0;
*/
void et_enclosure_free(et_enclosure *enclosure);

/* The control points become the exact solution, each coordinate rounded once, to nearest: by x += T T'N'(d - N x) from x = 0 in double-double.  The
 * control points the fit had are not read, so that the bits do not depend on who computed them, not even where a coordinate is undecided.
 * enclosure (may be null) is what et_enclosure_make gives for the new control points.  Coordinates that double-double cannot decide (ties, exact
 * zeros among data that are not all zero, condition numbers past about 1e10) are counted in `undecided`; there P is the double nearest to the
 * double-double.
 * Coordinates of data all zero are +0 with radius 0, corners that stand at the data's are those bit for bit.  Improved and joint shells are glued
 * bit for bit (et_shell_glued).
 * Errors as et_enclosure_make, and ET_EFORMAT (overflow of the solution); then fit and enclosure are as they were. */
/*@ requires valid:     \valid(fit) && \valid_read(options) && \valid_read(data + (0 .. nov - 1));
    requires enclosure: enclosure == \null || \valid(enclosure);
    requires fit:       et_fit_readable(fit) && et_shell_readable(&fit->shell);
    requires message:   message == \null || \valid(message);
    requires finite:    et_points_finite((et_vec3 *)data, nov);
    requires separated: \separated(fit, enclosure, data + (0 .. nov - 1), options, message);
    assigns fit->shell.view[0].points[0 .. fit->shell.view[0].nu * fit->shell.view[0].nv - 1],
            fit->shell.view[1].points[0 .. fit->shell.view[1].nu * fit->shell.view[1].nv - 1], *enclosure, *message;
    ensures invalid:    !et_net_ok(fit->data.nx, fit->data.ny) || nov != NOV(fit->data.nx, fit->data.ny) || !et_fit_known(options->approach)
                            ==> \result == ET_EINVAL;
    ensures stored:     \result == ET_OK && enclosure != \null ==> et_enclosure_of(enclosure, fit);
    ensures finite:     \result == ET_OK ==> et_points_finite(fit->shell.view[0].points, fit->shell.view[0].nu * fit->shell.view[0].nv) &&
                            et_points_finite(fit->shell.view[1].points, fit->shell.view[1].nu * fit->shell.view[1].nv);
    ensures unchanged:  \result != ET_OK ==> \forall integer w, i; 0 <= w < 2 && 0 <= i < fit->shell.view[0].nu * fit->shell.view[0].nv ==>
                            fit->shell.view[w].points[i] == \old(fit->shell.view[w].points[i]);
    ensures kept:       \result != ET_OK && enclosure != \null ==> *enclosure == \old(*enclosure);
*/
et_status et_enclosure_refine(et_fit *fit, et_enclosure *enclosure, const et_vec3 *data, size_t nov, const et_fit_options *options,
                              et_message *message);

#ifdef __cplusplus
}
#endif
#endif
