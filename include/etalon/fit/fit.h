/* fit: a trained double net (NOV points) becomes two B-spline surfaces by linear least squares (You 2023, chapter 5). */
#ifndef ETALON_FIT_FIT_H
#define ETALON_FIT_FIT_H
#include "etalon/fit/knotrule.h"
#include "etalon/fit/linalg.h"
#include "etalon/fit/param.h"
#include "etalon/fit/shell.h"
#ifdef __cplusplus
extern "C" {
#endif

/* CONVENTIONAL: each view by itself; gaps remain.  IMPROVED: shared parameters and knots, border control points of one class replaced by
 * their mean, corners set to the data's.  JOINT: least squares over the NOV data classes in the NOV control classes; no gap. */
typedef enum { ET_FIT_CONVENTIONAL = 0, ET_FIT_IMPROVED, ET_FIT_JOINT } et_fit_approach;

typedef enum { ET_CORNERS_DEFAULT = 0,   /* improved: interpolated; conventional, joint: free */
               ET_CORNERS_FREE, ET_CORNERS_INTERPOLATED } et_fit_corners;

typedef struct {
    et_fit_approach approach;             /* improved */
    et_param_method method;               /* chord */
    et_knotrule_kind knots;               /* piegl */
    et_linalg_method algebra;             /* qr */
    et_fit_corners corners;               /* default */
    size_t p, q;                          /* degrees, 3 and 3; p < control.nx, q < control.ny */
    et_doublenet control;                 /* control net, sides <= those of the data */
} et_fit_options;

/* A fit: the shell and the parameters at which it was fitted, for each view (equal for improved and joint). */
typedef struct {
    et_shell shell;
    et_doublenet data;                    /* sides of the data */
    double *s[2], *r[2];                  /* s[view][0..nx-1] in u, r[view][0..ny-1] in v */
    size_t flat;                          /* rows or columns of no length that got uniform parameters */
} et_fit;

/* Surface errors, sums of |D_c - S(s_i, r_j)| (Eq. 5.13).  nov: each class once, the bottom view's surface on the border.  non: every node of both
 * views, bottom first.  The source's own sum (its double count) is non for conventional and nov for the others.  greatest: over all nodes. */
typedef struct { double nov, non, greatest; double corner; } et_fit_error;   /* corner: greatest distance at the four corners, both views */

/*@ predicate et_fit_known(integer approach) = 0 <= approach <= 2;
    predicate et_fit_readable(et_fit *f) =
        et_shell_readable(&f->shell) && (\forall integer w; 0 <= w < 2 ==> (f->s[w] == \null || \valid_read(f->s[w] + (0 .. f->data.nx - 1))) &&
                                                                          (f->r[w] == \null || \valid_read(f->r[w] + (0 .. f->data.ny - 1))));
    predicate et_fit_stored(et_fit *f) =
        et_shell_stored(&f->shell) && (\forall integer w; 0 <= w < 2 ==> \valid_read(f->s[w] + (0 .. f->data.nx - 1)) &&
                                                                        \valid_read(f->r[w] + (0 .. f->data.ny - 1)));
*/

/* "conventional", "improved", "joint"; null past the last. */
/*@ assigns \result \from approach;
    ensures known:   et_fit_known(approach) ==> valid_read_string(\result);
    ensures named:   et_fit_known(approach) ==> \result != \null;
    ensures unknown: !et_fit_known(approach) ==> \result == \null;
*/
const char *et_fit_name(et_fit_approach approach);

/* The defaults named beside the fields above; control {12, 12}.  Golden: none (a table of defaults). */
/*@ assigns \nothing;
    ensures approach: \result.approach == ET_FIT_IMPROVED && \result.algebra == ET_LINALG_QR && \result.corners == ET_CORNERS_DEFAULT;
    ensures rules:    \result.method == ET_PARAM_CHORD && \result.knots == ET_KNOTRULE_PIEGL;
    ensures degrees:  \result.p == 3 && \result.q == 3;
    ensures control:  \result.control.nx == 12 && \result.control.ny == 12;
*/
et_fit_options et_fit_defaults(void);

/* Fit `data` (NOV points of the double net `net`), with weights 1.  With Nu, Nv the basis functions at a view's parameters and D its data
 *   conventional  P = Nu+ D (Nv+)' for each view (with interpolated corners: the constrained optimum, the corners moved to the right-hand side);
 *   improved      the same with parameters averaged over both views; then border control points of a class become their mean (Eq. 5.7) and, unless
 *                 corners are free, the corner control points the corner data: no optimum of anything, but closed;
 *   joint         the least sum over NOV classes of |D_c - (N P)_c|^2 in the NOV control classes.  QR: solved by orthogonal reduction to a problem in
 *                 the border's control points alone; cholesky and svd: one dense NOV x NOV' system.
 * Improved and joint shells are glued bit for bit (et_shell_glued), and closed unless parameters coincide at an end.  The squares of the data must not
 * overflow.
 * ET_EINVAL (sizes, degrees, options; message), ET_ENOMEM, ET_ERANK (message names view, direction and rank), ET_EFORMAT (overflow of the solution).
 * The result is freed with et_fit_free. */
/*@ requires valid:     \valid(fit) && \valid_read(options) && \valid_read(data + (0 .. nov - 1));
    requires message:   message == \null || \valid(message);
    requires finite:    et_points_finite((et_vec3 *)data, nov);
    requires separated: \separated(fit, data + (0 .. nov - 1), options, message);
    assigns *fit, *message;
    ensures invalid:    !et_net_ok(net.nx, net.ny) || nov != NOV(net.nx, net.ny) ==> \result == ET_EINVAL;
    ensures control:    options->control.nx > net.nx || options->control.ny > net.ny ==> \result == ET_EINVAL;
    ensures degrees:    options->p < 1 || options->q < 1 || options->p >= options->control.nx || options->q >= options->control.ny
                            ==> \result == ET_EINVAL;
    ensures shell:      \result == ET_OK ==> et_fit_stored(fit) && fit->shell.view[0].nu == options->control.nx
                            && fit->shell.view[0].nv == options->control.ny
                            && fit->shell.view[0].p == options->p && fit->shell.view[0].q == options->q;
    ensures parameters: \result == ET_OK ==> \forall integer w; 0 <= w < 2 ==> et_params(fit->s[w], net.nx) && et_params(fit->r[w], net.ny);
    ensures unchanged:  \result != ET_OK ==> *fit == \old(*fit);
*/
et_status et_fit_make(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, const et_fit_options *options, et_message *message);

/* Frees what a fit owns and leaves a fit of zeros, which may be freed again.  Golden: none (storage). */
/*@ requires valid: \valid(fit);
    assigns *fit;
    ensures empty: fit->s[0] == \null && fit->s[1] == \null && fit->r[0] == \null && fit->r[1] == \null;
*/
void et_fit_free(et_fit *fit);

/* The parameters alone: what et_fit_make computes before it solves; the shell stays zero.  s and r are freed with et_fit_free.
 * ET_EINVAL: net, nov, approach or method; ET_ENOMEM. */
/*@ requires valid:     \valid(fit) && \valid_read(data + (0 .. nov - 1));
    requires finite:    et_points_finite((et_vec3 *)data, nov);
    requires separated: \separated(fit, data + (0 .. nov - 1));
    assigns *fit;
    ensures status:     \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures invalid:    !et_net_ok(net.nx, net.ny) || nov != NOV(net.nx, net.ny) || !et_fit_known(approach) || !et_param_known(method)
                            <==> \result == ET_EINVAL;
    ensures parameters: \result == ET_OK ==> \forall integer w; 0 <= w < 2 ==> et_params(fit->s[w], net.nx) && et_params(fit->r[w], net.ny);
    ensures shared:     \result == ET_OK && approach != ET_FIT_CONVENTIONAL ==> \forall integer i; 0 <= i < net.nx ==> fit->s[0][i] == fit->s[1][i];
    ensures unchanged:  \result != ET_OK ==> *fit == \old(*fit);
*/
et_status et_fit_parameters(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, et_fit_approach approach, et_param_method method);

/* Errors of a fit's shell against its data (Eq. 5.13).  Surface points have the bits of et_surface_point, distances are et_vec3_distance, sums
 * et_real_sum in the order of classes (nov) and of nodes (non).  residual (may be null): |D_c - S| for each class, residual[c-1].
 * ET_EINVAL (nov is not the data's), ET_ENOMEM. */
/*@ requires valid:     \valid(error) && \valid_read(fit) && \valid_read(data + (0 .. nov - 1));
    requires residual:  residual == \null || \valid(residual + (0 .. nov - 1));
    requires fit:       et_fit_stored((et_fit *)fit) && et_surface_ok(&fit->shell.view[0]) && et_surface_ok(&fit->shell.view[1]);
    requires finite:    et_points_finite((et_vec3 *)data, nov);
    requires parameters: \forall integer w, i; 0 <= w < 2 ==> (0 <= i < fit->data.nx ==> \is_finite(fit->s[w][i]))
                            && (0 <= i < fit->data.ny ==> \is_finite(fit->r[w][i]));
    requires separated: \separated(error, fit, data + (0 .. nov - 1), residual + (0 .. nov - 1));
    assigns *error, residual[0 .. nov - 1];
    ensures invalid:    !et_net_ok(fit->data.nx, fit->data.ny) || nov != NOV(fit->data.nx, fit->data.ny) <==> \result == ET_EINVAL;
    ensures order:      \result == ET_OK && \is_finite(error->greatest) ==> 0.0 <= error->corner <= error->greatest;
    ensures sums:       \result == ET_OK && \is_finite(error->nov) && \is_finite(error->non) ==> 0.0 <= error->nov && 0.0 <= error->non;
    ensures unchanged:  \result != ET_OK ==> *error == \old(*error);
*/
et_status et_fit_measure(et_fit_error *error, double *residual, size_t nov, const et_fit *fit, const et_vec3 *data);

#ifdef __cplusplus
}
#endif
#endif
