/* exact: correctly rounded results of everything deterministic, by exact rationals and by ball arithmetic (FLINT, Arb).
 *
 * Each function has the meaning of the one whose name it bears (et_exact_basis_eval: et_basis_eval) and computes stage-wise: its inputs are the
 * doubles handed over, its outputs the doubles nearest to the exact mathematical results, ties to even, as IEEE 754 rounds: beyond the greatest
 * double infinity, below the least subnormal zero; a zero is always +0.  There is no error to bound.
 *
 * What is rational in its inputs is computed in rationals.  Where there are roots, balls are evaluated at a precision that is doubled until
 * every number of a ball rounds to one double; a tie between two doubles, which no precision would resolve, is recognised by exact
 * arithmetic (the square roots of rationals are linearly independent over the rationals unless quotients of them are rational).
 *
 * `bits`, where a function takes it, may be null: *bits is the precision to begin with (0: the function's own choice) and becomes the one at which
 * everything was decided (0: balls were not needed).  What is computed does not depend on it.
 *
 * Preconditions are those of the functions named.  FLINT ends the program when memory runs out; ET_ENOMEM tells only of sizes and of arrays of our
 * own.
 */
#ifndef ETALON_EXACT_EXACT_H
#define ETALON_EXACT_EXACT_H
#include "etalon/base/frame.h"
#include "etalon/base/task.h"
#include "etalon/fit/fit.h"
#include "etalon/fit/seam.h"
#include "etalon/som/quality.h"
#include "etalon/spline/curve.h"
#include "etalon/spline/surface.h"
#ifdef __cplusplus
extern "C" {
#endif

/* x[0] + ... + x[n-1], rounded once; +0 for n == 0.
 * Golden: none (the rows of et_real_sum are checked against it, bit for bit). */
/*@ requires terms:  \valid_read(x + (0 .. n - 1));
    requires finite: \forall integer i; 0 <= i < n ==> \is_finite(x[i]);
    assigns  \nothing;
    ensures  empty:  n == 0 ==> \result == 0.0;
*/
double et_exact_real_sum(const double *x, size_t n);

/* |a - b|, rounded once.
 * Golden: none (the rows of et_vec3_distance are checked against it). */
/*@ requires finite: \is_finite(a.x) && \is_finite(a.y) && \is_finite(a.z) && \is_finite(b.x) && \is_finite(b.y) && \is_finite(b.z);
    assigns  \nothing;
    ensures  range:  \is_plus_infinity(\result) || \result >= 0.0;
*/
double et_exact_vec3_distance(et_vec3 a, et_vec3 b);

/* (own - offset) / scale, each coordinate rounded once.
 * Golden: none (the rows of et_frame_to_unit are checked against it). */
/*@ requires points: \valid(points + (0 .. n - 1));
    requires frame:  \valid_read(frame);
    requires finite: et_points_finite(points, n) && \is_finite(frame->offset.x) && \is_finite(frame->offset.y) && \is_finite(frame->offset.z);
    requires scale:  \is_finite(frame->scale.x) && \is_finite(frame->scale.y) && \is_finite(frame->scale.z) &&
                     frame->scale.x > 0.0 && frame->scale.y > 0.0 && frame->scale.z > 0.0;
    requires apart:  \separated(frame, points + (0 .. n - 1));
    assigns  points[0 .. n - 1];
*/
void et_exact_frame_to_unit(et_vec3 *points, size_t n, const et_frame *frame);

/* offset + scale unit, each coordinate rounded once.
 * Golden: none (the rows of et_frame_from_unit are checked against it). */
/*@ requires points: \valid(points + (0 .. n - 1));
    requires frame:  \valid_read(frame);
    requires finite: et_points_finite(points, n) && \is_finite(frame->offset.x) && \is_finite(frame->offset.y) && \is_finite(frame->offset.z);
    requires scale:  \is_finite(frame->scale.x) && \is_finite(frame->scale.y) && \is_finite(frame->scale.z);
    requires apart:  \separated(frame, points + (0 .. n - 1));
    assigns  points[0 .. n - 1];
*/
void et_exact_frame_from_unit(et_vec3 *points, size_t n, const et_frame *frame);

/* N[0..p] of et_basis_eval.  ET_ENOMEM.
 * Golden: none (the rows of et_basis_eval are checked against it). */
/*@ requires count:  nu >= 2 * p + 2;
    requires N:      \valid(N + (0 .. p));
    requires knots:  \valid_read(u + (0 .. nu - 1));
    requires span:   p <= span <= nu - p - 2 && u[span] < u[span + 1];
    requires inside: (u[span] <= x || u[span] <= u[p]) && (x <= u[span + 1] || u[nu - p - 1] <= u[span + 1]);
    requires finite: \is_finite(x) && \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    requires sorted: \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    assigns  N[0 .. p];
    ensures  range:  \result == ET_OK ==> \forall integer r; 0 <= r <= p ==> 0.0 <= N[r] <= 1.0;
*/
et_status et_exact_basis_eval(double *N, const double *u, size_t nu, size_t p, size_t span, double x);

/* D[k*(p+1) + j], k = 0..d, of et_basis_ders.  ET_ENOMEM.
 * Golden: none (the rows of et_basis_ders are checked against it). */
/*@ requires count:  nu >= 2 * p + 2;
    requires D:      \valid(D + (0 .. (d + 1) * (p + 1) - 1));
    requires knots:  \valid_read(u + (0 .. nu - 1));
    requires span:   p <= span <= nu - p - 2 && u[span] < u[span + 1];
    requires inside: (u[span] <= x || u[span] <= u[p]) && (x <= u[span + 1] || u[nu - p - 1] <= u[span + 1]);
    requires finite: \is_finite(x) && \forall integer i; 0 <= i < nu ==> \is_finite(u[i]);
    requires sorted: \forall integer i, j; 0 <= i <= j < nu ==> u[i] <= u[j];
    assigns  D[0 .. (d + 1) * (p + 1) - 1];
    ensures  above:  \result == ET_OK ==> \forall integer k, r; p < k <= d && 0 <= r <= p ==> D[k * (p + 1) + r] == 0.0;
*/
et_status et_exact_basis_ders(double *D, size_t d, const double *u, size_t nu, size_t p, size_t span, double x);

/* C(x) of a curve, polynomial or rational.  ET_EINVAL (curve not valid, x not finite), ET_ENOMEM.
 * Golden: none (the rows of et_curve_point are checked against it). */
/*@ requires C:      \valid(C) && \valid_read(c);
    requires curve:  et_curve_readable((et_curve *)c);
    assigns  *C;
    ensures  kept:   \result != ET_OK ==> *C == \old(*C);
*/
et_status et_exact_curve_point(et_vec3 *C, const et_curve *c, double x);

/* D[0..d]: the curve and its derivatives to any order, at inner knots from the right.  ET_EINVAL, ET_ENOMEM.
 * Golden: none (the rows of et_curve_ders are checked against it). */
/*@ requires D:      \valid(D + (0 .. d)) && \valid_read(c);
    requires curve:  et_curve_readable((et_curve *)c);
    assigns  D[0 .. d];
    ensures  kept:   \result != ET_OK ==> \forall integer k; 0 <= k <= d ==> D[k] == \old(D[k]);
*/
et_status et_exact_curve_ders(et_vec3 *D, size_t d, const et_curve *c, double x);

/* S(u,v), polynomial or rational.  ET_EINVAL (surface not valid, parameters not finite), ET_ENOMEM.
 * Golden: none (the rows of et_surface_point are checked against it). */
/*@ requires S:       \valid(S) && \valid_read(s);
    requires storage: et_surface_readable((et_surface *)s);
    assigns  *S;
    ensures  kept:    \result != ET_OK ==> *S == \old(*S);
*/
et_status et_exact_surface_point(et_vec3 *S, const et_surface *s, double u, double v);

/* All partial derivatives of order up to d (any d): (d+1)(d+2)/2 of them, by order, and within an order by falling power of u: S, S_u, S_v, S_uu,
 * S_uv, S_vv, S_uuu, S_uuv, ...; for d = 2 the layout of et_surface_ders.  At inner knots from the right.  ET_EINVAL, ET_ENOMEM.
 * Golden: none (the rows of et_surface_ders are checked against it). */
/*@ requires D:       \valid(D + (0 .. (d + 1) * (d + 2) / 2 - 1)) && \valid_read(s);
    requires storage: et_surface_readable((et_surface *)s);
    assigns  D[0 .. (d + 1) * (d + 2) / 2 - 1];
    ensures  kept:    \result != ET_OK ==> \forall integer k; 0 <= k < (d + 1) * (d + 2) / 2 ==> D[k] == \old(D[k]);
*/
et_status et_exact_surface_ders(et_vec3 *D, size_t d, const et_surface *s, double u, double v);

/* S[i*nb + j] = S(a[i], b[j]).  ET_EINVAL, ET_ENOMEM.
 * Golden: none (the rows of et_surface_grid are checked against it). */
/*@ requires S:       \valid(S + (0 .. na * nb - 1)) && \valid_read(s);
    requires storage: et_surface_readable((et_surface *)s);
    requires ab:      \valid_read(a + (0 .. na - 1)) && \valid_read(b + (0 .. nb - 1));
    assigns  S[0 .. na * nb - 1];
    ensures  kept:    \result != ET_OK ==> \forall integer k; 0 <= k < na * nb ==> S[k] == \old(S[k]);
*/
et_status et_exact_surface_grid(et_vec3 *S, const et_surface *s, const double *a, size_t na, const double *b, size_t nb);

/* Parameters of a line of points (et_param_row; the exponential method's power is exactly 4/5).  *flat: the line has no length and got the uniform
 * parameters.  ET_EINVAL (n < 2, stride 0, method unknown), ET_ENOMEM.
 * Golden: none (the rows of et_param_row are checked against it). */
/*@ requires valid:     \valid(t + (0 .. n - 1)) && \valid(flat) && (bits == \null || \valid(bits));
    requires points:    n >= 1 && \valid_read(D + (0 .. (n - 1)*stride));
    assigns t[0 .. n - 1], *flat, *bits;
    ensures invalid:    n < 2 || stride < 1 || !et_param_known(method) ==> \result == ET_EINVAL;
    ensures params:     \result == ET_OK ==> et_params(t, n);
*/
et_status et_exact_param_row(double *t, size_t n, int *flat, const et_vec3 *D, size_t stride, et_param_method method, size_t *bits);

/* Averages of the parameters of all lines (et_param_grid), each average rounded once.  ET_EINVAL, ET_ENOMEM; ET_ENOCONV when a tie of sums of
 * different roots cannot be decided by 2^16 bits.
 * Golden: none (the rows of et_param_grid are checked against it). */
/*@ requires valid:     \valid(s + (0 .. nx - 1)) && \valid(r + (0 .. ny - 1)) && \valid(flat) && (bits == \null || \valid(bits));
    requires points:    \valid_read(D + (0 .. nx*ny - 1));
    assigns s[0 .. nx - 1], r[0 .. ny - 1], *flat, *bits;
    ensures invalid:    nx < 2 || ny < 2 || !et_param_known(method) ==> \result == ET_EINVAL;
    ensures params:     \result == ET_OK ==> et_params(s, nx) && et_params(r, ny);
    ensures unchanged:  \result != ET_OK ==> *flat == \old(*flat);
*/
et_status et_exact_param_grid(double *s, size_t nx, double *r, size_t ny, size_t *flat, const et_vec3 *D, et_param_method method, size_t *bits);

/* (a[i] + b[i]) / 2, rounded once, written to both.
 * Golden: none (the rows of et_param_standardise are checked against it). */
/*@ requires valid:     \valid(a + (0 .. n - 1)) && \valid(b + (0 .. n - 1));
    requires separated: \separated(a + (0 .. n - 1), b + (0 .. n - 1));
    assigns a[0 .. n - 1], b[0 .. n - 1];
    ensures shared:     \forall integer i; 0 <= i < n ==> a[i] == b[i];
*/
void et_exact_param_standardise(double *a, double *b, size_t n);

/* The knots of et_knotrule_make, each rounded once.  Errors as there.
 * Golden: none (the rows of et_knotrule_make are checked against it). */
/*@ requires valid:     \valid(u + (0 .. nu - 1)) && \valid_read(t + (0 .. nt - 1));
    requires separated: \separated(u + (0 .. nu - 1), t + (0 .. nt - 1));
    requires sorted:    \forall integer i; 0 <= i < nt - 1 ==> t[i] <= t[i+1];
    requires range:     \forall integer i; 0 <= i < nt ==> 0.0 <= t[i] <= 1.0;
    assigns u[0 .. nu - 1];
    ensures invalid:    !et_knotrule_fits(nu, p, nt, kind) ==> \result == ET_EINVAL;
    ensures unchanged:  \result != ET_OK ==> \forall integer i; 0 <= i < nu ==> u[i] == \old(u[i]);
*/
et_status et_exact_knotrule_make(double *u, size_t nu, size_t p, const double *t, size_t nt, et_knotrule_kind kind);

/* The parameters of et_fit_parameters: averages rounded once, then standardised ones rounded once.  Errors as there, and ET_ENOCONV.
 * Golden: none (the rows of et_fit_parameters are checked against it). */
/*@ requires valid:     \valid(fit) && \valid_read(data + (0 .. nov - 1)) && (bits == \null || \valid(bits));
    requires finite:    et_points_finite((et_vec3 *)data, nov);
    assigns *fit, *bits;
    ensures parameters: \result == ET_OK ==> \forall integer w; 0 <= w < 2 ==> et_params(fit->s[w], net.nx) && et_params(fit->r[w], net.ny);
    ensures unchanged:  \result != ET_OK ==> *fit == \old(*fit);
*/
et_status et_exact_fit_parameters(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, et_fit_approach approach, et_param_method method,
                                  size_t *bits);

/* The least-squares control points at the fit's own parameters and on its shell's own knots: the exact minimiser of the approach (for improved the
 * means of the two views' exact minimisers, and the corners), each coordinate rounded once.  Replaces the control points of fit->shell, nothing else.
 * options: approach and corners are used; degrees and sides are the shell's.  Knots are clamped, parameters rise from end to end of the domain.
 * ET_EINVAL (fit or options not valid, a shell rational, views of unequal parameters or knots where the approach shares them, nov not the data's),
 * ET_ERANK (the exact matrix is rank deficient; message names view, direction and rank), ET_EFORMAT (a coordinate overflows), ET_ENOMEM, and
 * ET_ESTOPPED or what else the task returned; it is asked before each precision and after each coordinate.  On failure nothing is changed.
 * Golden: none (the rows of et_fit_make are checked against it). */
/*@ requires valid:     \valid(fit) && \valid_read(options) && \valid_read(data + (0 .. nov - 1)) && (bits == \null || \valid(bits));
    requires fit:       et_fit_stored(fit);
    requires finite:    et_points_finite((et_vec3 *)data, nov);
    requires task:      task == \null || \valid_read(task);
    requires message:   message == \null || \valid(message);
    requires separated: \separated(fit, data + (0 .. nov - 1), options, bits, message);
    assigns fit->shell.view[0].points[0 .. fit->shell.view[0].nu * fit->shell.view[0].nv - 1],
            fit->shell.view[1].points[0 .. fit->shell.view[1].nu * fit->shell.view[1].nv - 1], *bits, *message;
    ensures invalid:    nov != NOV(fit->data.nx, fit->data.ny) ==> \result == ET_EINVAL;
    ensures finite:     \result == ET_OK ==> et_points_finite(fit->shell.view[0].points, fit->shell.view[0].nu * fit->shell.view[0].nv)
                            && et_points_finite(fit->shell.view[1].points, fit->shell.view[1].nu * fit->shell.view[1].nv);
    ensures unchanged:  \result != ET_OK ==> \forall integer k; 0 <= k < fit->shell.view[0].nu * fit->shell.view[0].nv ==>
                            fit->shell.view[0].points[k] == \old(fit->shell.view[0].points[k]);
*/
et_status et_exact_fit_solve(et_fit *fit, const et_vec3 *data, size_t nov, const et_fit_options *options, size_t *bits, const et_task *task,
                             et_message *message);

/* et_fit_make with every stage exact: parameters, standardised parameters, knots, control points.  options->algebra is not used.
 * Errors as et_fit_make (ET_EFORMAT also where knots come closer than 2^-1022), and ET_ENOCONV, ET_ESTOPPED.  Freed by et_fit_free.
 * Golden: none (the rows of et_fit_make are checked against it). */
/*@ requires valid:     \valid(fit) && \valid_read(options) && \valid_read(data + (0 .. nov - 1)) && (bits == \null || \valid(bits));
    requires finite:    et_points_finite((et_vec3 *)data, nov);
    requires task:      task == \null || \valid_read(task);
    requires message:   message == \null || \valid(message);
    assigns *fit, *bits, *message;
    ensures invalid:    !et_net_ok(net.nx, net.ny) || nov != NOV(net.nx, net.ny) ==> \result == ET_EINVAL;
    ensures unchanged:  \result != ET_OK ==> *fit == \old(*fit);
*/
et_status et_exact_fit_make(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, const et_fit_options *options, size_t *bits,
                            const et_task *task, et_message *message);

/* The surface errors of et_fit_measure, each rounded once: every distance, both sums, both maxima.  ET_EINVAL (nov not the data's, a surface not
 * valid, a parameter not finite), ET_ENOMEM.
 * Golden: none (the rows of et_fit_measure are checked against it). */
/*@ requires valid:     \valid(error) && \valid_read(fit) && \valid_read(data + (0 .. nov - 1)) && (bits == \null || \valid(bits));
    requires residual:  residual == \null || \valid(residual + (0 .. nov - 1));
    requires fit:       et_fit_stored((et_fit *)fit);
    requires finite:    et_points_finite((et_vec3 *)data, nov);
    assigns *error, residual[0 .. nov - 1], *bits;
    ensures unchanged:  \result != ET_OK ==> *error == \old(*error);
*/
et_status et_exact_fit_measure(et_fit_error *error, double *residual, size_t nov, const et_fit *fit, const et_vec3 *data, size_t *bits);

/* The greatest of the gaps that et_seam_gap samples, found exactly (the first of equal ones) and rounded once; at the same parameters, doubles
 * themselves.  ET_EINVAL, ET_ENOMEM.
 * Golden: none (the rows of et_seam_gap are checked against it). */
/*@ requires valid:    \valid(gap) && \valid_read(shell) && et_shell_readable((et_shell *)shell);
    assigns *gap;
    ensures gap:       \result == ET_OK ==> \is_plus_infinity(gap->distance) || gap->distance >= 0.0;
    ensures unchanged: \result != ET_OK ==> *gap == \old(*gap);
*/
et_status et_exact_seam_gap(et_seam *gap, const et_shell *shell, size_t samples);

/* The quality of et_quality_of: winners by exactly compared distances (ties to the lowest class), the mean and the extremes rounded once.
 * ET_EINVAL, ET_ENOMEM.
 * Golden: none (the rows of et_quality_of are checked against it). */
/*@ requires quality:   \valid(quality) && (bits == \null || \valid(bits));
    requires weights:   \valid_read(weights + (0 .. nov - 1));
    requires cloud:     \valid_read(cloud + (0 .. n - 1));
    assigns *quality, *bits;
    ensures unchanged:  \result != ET_OK ==> *quality == \old(*quality);
*/
et_status et_exact_quality_of(et_som_quality *quality, const et_vec3 *weights, size_t nov, et_doublenet net, const et_vec3 *cloud, size_t n,
                              size_t *bits);

/* ---- editing, one-sided derivatives: each value rounded once ---- */

/* g[i] = (u[i+1] + ... + u[i+p]) / p, for p = 0 (u[i] + u[i+1]) / 2.  ET_EINVAL (knots not valid, n not nu - p - 1).
 * Golden: none (the rows of et_knots_greville are checked against it). */
/*@ requires g:       \valid(g + (0 .. n - 1));
    requires knots:   \valid_read(u + (0 .. nu - 1));
    requires apart:   \separated(g + (0 .. n - 1), u + (0 .. nu - 1));
    assigns  g[0 .. n - 1];
    ensures  inside:  \result == ET_OK ==> \forall integer i; 0 <= i < n ==> u[i] <= g[i] <= u[i + p + 1];
    ensures  kept:    \result != ET_OK ==> \forall integer i; 0 <= i < n ==> g[i] == \old(g[i]);
*/
et_status et_exact_knots_greville(double *g, size_t n, const double *u, size_t nu, size_t p);

/* D[0..d] of et_curve_ders_side, to any order: one-sided limits, at the ends of the domain those from inside.  ET_EINVAL, ET_ENOMEM.
 * Golden: none (the rows of et_curve_ders_side are checked against it). */
/*@ requires D:       \valid(D + (0 .. d)) && \valid_read(c);
    requires curve:   et_curve_readable((et_curve *)c);
    assigns  D[0 .. d];
    ensures  kept:    \result != ET_OK ==> \forall integer k; 0 <= k <= d ==> D[k] == \old(D[k]);
*/
et_status et_exact_curve_ders_side(et_vec3 *D, size_t d, const et_curve *c, double x, et_side side);

/* D[(a+b)(a+b+1)/2 + b]: the derivative a times by u and b times by v, a + b <= d (any d), one-sided as in et_surface_partials.  ET_EINVAL,
 * ET_ENOMEM.
 * Golden: none (the rows of et_surface_partials are checked against it). */
/*@ requires D:       \valid(D + (0 .. (d + 1) * (d + 2) / 2 - 1)) && \valid_read(s);
    requires storage: et_surface_readable((et_surface *)s);
    assigns  D[0 .. (d + 1) * (d + 2) / 2 - 1];
    ensures  kept:    \result != ET_OK ==> \forall integer k; 0 <= k < (d + 1) * (d + 2) / 2 ==> D[k] == \old(D[k]);
*/
et_status et_exact_surface_partials(et_vec3 *D, size_t d, const et_surface *s, double u, double v, et_side side_u, et_side side_v);

/* S_u x S_v / |S_u x S_v|, derivatives from the right, each coordinate rounded once.  ET_EINVAL; ET_ERANK where the cross product is exactly 0.
 * Golden: none (the rows of et_surface_normal are checked against it). */
/*@ requires n:       \valid(n) && \valid_read(s);
    requires storage: et_surface_readable((et_surface *)s);
    assigns  *n;
    ensures  unit:    \result == ET_OK ==> -1.0 <= n->x <= 1.0 && -1.0 <= n->y <= 1.0 && -1.0 <= n->z <= 1.0;
    ensures  kept:    \result != ET_OK ==> *n == \old(*n);
*/
et_status et_exact_surface_normal(et_vec3 *n, const et_surface *s, double u, double v);

/* The same curve with the knot x of the closed domain `times` times more, behind those that equal it; control points, after the division by their
 * exact weights, and weights rounded once each.  times = 0: a copy (with +0 for -0).  What *refined held before is not freed.
 * ET_EINVAL (curve not valid; x outside the domain, not finite or nearer than 2^-1022 to a knot that it does not equal; times > 0 and a multiplicity
 * beyond p + 1 afterwards), ET_ENOMEM.
 * Golden: none (the rows of et_curve_insert are checked against it). */
/*@ requires refined: \valid(refined) && \valid_read(c);
    requires curve:   et_curve_readable((et_curve *)c);
    assigns  *refined;
    ensures  valid:   \result == ET_OK ==> et_curve_ok(refined) && refined->n == \old(c->n) + times && refined->p == \old(c->p);
    ensures  kept:    \result != ET_OK ==> *refined == \old(*refined);
*/
et_status et_exact_curve_insert(et_curve *refined, const et_curve *c, double x, size_t times);

/* The same curve of degree p + times: each different knot `times` times more, rounded as in et_exact_curve_insert.  Control points whose functions
 * live nowhere (beside knots of a multiplicity beyond p + 1) keep their places beside the knot.
 * ET_EINVAL (curve not valid or not clamped), ET_ENOMEM.
 * Golden: none (the rows of et_curve_elevate are checked against it). */
/*@ requires elevated: \valid(elevated) && \valid_read(c);
    requires curve:    et_curve_readable((et_curve *)c);
    assigns  *elevated;
    ensures  valid:    \result == ET_OK ==> et_curve_ok(elevated) && elevated->p == \old(c->p) + times;
    ensures  kept:     \result != ET_OK ==> *elevated == \old(*elevated);
*/
et_status et_exact_curve_elevate(et_curve *elevated, const et_curve *c, size_t times);

/* The knot x inside the open domain removed as often, at most `times`, as the curve (its homogeneous coordinates) stays exactly as it is and weights
 * stay positive; *removed: how often, which may be 0.  Control points and weights are rounded once each: beyond the range of doubles they become
 * infinite, weights below it 0, and the curve is then no valid one.
 * ET_EINVAL (curve not valid; x is no knot inside the open domain), ET_ENOMEM.
 * Golden: none (the rows of et_curve_remove are checked against it). */
/*@ requires reduced: \valid(reduced) && \valid(removed) && \valid_read(c);
    requires apart:   \separated(reduced, removed) && \separated(removed, c);
    requires curve:   et_curve_readable((et_curve *)c);
    assigns  *reduced, *removed;
    ensures  often:   \result == ET_OK ==> *removed <= times && reduced->n + *removed == \old(c->n) && reduced->p == \old(c->p);
    ensures  kept:    \result != ET_OK ==> *reduced == \old(*reduced) && *removed == \old(*removed);
*/
et_status et_exact_curve_remove(et_curve *reduced, size_t *removed, const et_curve *c, double x, size_t times);

/* et_exact_curve_insert of all curves of the surface along one direction.  ET_EINVAL, ET_ENOMEM.
 * Golden: none (the rows of et_surface_insert are checked against it). */
/*@ requires refined: \valid(refined) && \valid_read(s);
    requires storage: et_surface_readable((et_surface *)s);
    assigns  *refined;
    ensures  valid:   \result == ET_OK ==> et_surface_ok(refined) && refined->p == \old(s->p) && refined->q == \old(s->q);
    ensures  along:   \result == ET_OK ==> refined->nu == \old(s->nu) + (along == ET_ALONG_U ? times : 0)
                          && refined->nv == \old(s->nv) + (along == ET_ALONG_U ? 0 : times);
    ensures  kept:    \result != ET_OK ==> *refined == \old(*refined);
*/
et_status et_exact_surface_insert(et_surface *refined, const et_surface *s, et_direction along, double x, size_t times);

/* et_exact_curve_elevate of all curves of the surface along one direction.  ET_EINVAL (surface not valid, that direction not clamped), ET_ENOMEM.
 * Golden: none (the rows of et_surface_elevate are checked against it). */
/*@ requires elevated: \valid(elevated) && \valid_read(s);
    requires storage:  et_surface_readable((et_surface *)s);
    assigns  *elevated;
    ensures  valid:    \result == ET_OK ==> et_surface_ok(elevated) && elevated->p == \old(s->p) + (along == ET_ALONG_U ? times : 0)
                           && elevated->q == \old(s->q) + (along == ET_ALONG_U ? 0 : times);
    ensures  kept:     \result != ET_OK ==> *elevated == \old(*elevated);
*/
et_status et_exact_surface_elevate(et_surface *elevated, const et_surface *s, et_direction along, size_t times);

/* et_exact_curve_remove of all curves of the surface along one direction, from all of them or from none.  ET_EINVAL, ET_ENOMEM.
 * Golden: none (the rows of et_surface_remove are checked against it). */
/*@ requires reduced: \valid(reduced) && \valid(removed) && \valid_read(s);
    requires apart:   \separated(reduced, removed) && \separated(removed, s);
    requires storage: et_surface_readable((et_surface *)s);
    assigns  *reduced, *removed;
    ensures  often:   \result == ET_OK ==> *removed <= times && reduced->p == \old(s->p) && reduced->q == \old(s->q);
    ensures  kept:    \result != ET_OK ==> *reduced == \old(*reduced) && *removed == \old(*removed);
*/
et_status et_exact_surface_remove(et_surface *reduced, size_t *removed, const et_surface *s, et_direction along, double x, size_t times);

/* ---- least squares with given parameters and knots ---- */

/* What a bound for a computed solution needs, each number rounded once, to nearest.  A is the matrix of the basis functions at the parameters:
 * N_j(t_i) of a curve, N_i(a_k) M_j(b_k) of scattered points, Kronecker's product of both directions' of a grid, so that its norms are the products
 * of theirs.  norm = |A|_F; condition = |A|_F |A+|_F = sqrt(tr(A'A) tr((A'A)^-1)).  With interpolated corners both are those of the same A, of the
 * free problem: the reduced one has some of its columns, so that its condition is no greater.
 * solution: |P|_2 over all control points, residual: |A P - D|_2 over all data, coordinate by coordinate. */
typedef struct { double condition, norm; et_vec3 solution, residual; } et_exact_lsq;

/* P[0..n-1]: the least squares curve of degree p with knots u through the m points D at parameters t, each coordinate rounded once; beyond the range
 * of doubles infinite.  Parameters in any order.
 * ET_EINVAL (p = 0, nu not n + p + 1, knots not valid, m = 0, a parameter outside the domain, a datum not finite); ET_ERANK: the columns of A depend
 * on each other (exactly), as they do where the conditions of Schoenberg and Whitney are violated; ET_ENOMEM.
 * Golden: none (exact by definition; conformance vectors computed in Python's rationals agree). */
/*@ requires valid:   \valid(P + (0 .. n - 1)) && \valid(lsq);
    requires read:    \valid_read(u + (0 .. nu - 1)) && \valid_read(t + (0 .. m - 1)) && \valid_read(D + (0 .. m - 1));
    assigns  P[0 .. n - 1], *lsq;
    ensures  few:     m < n ==> \result != ET_OK;
    ensures  norms:   \result == ET_OK ==> lsq->condition >= n && lsq->norm > 0.0;
    ensures  kept:    \result != ET_OK ==> *lsq == \old(*lsq) && \forall integer i; 0 <= i < n ==> P[i] == \old(P[i]);
*/
et_status et_exact_fit_curve(et_vec3 *P, size_t n, et_exact_lsq *lsq, const double *u, size_t nu, size_t p, const double *t, const et_vec3 *D,
                             size_t m);

/* P[i*nv + j]: the least squares surface of degrees p, q with knots u (nu + p + 1), v (nv + q + 1) through D[i*mv + j] at (a[i], b[j]);
 * corners != 0: of those whose four corners are the data's, the one of least squares (a constrained optimum).
 * ET_EINVAL as in et_exact_fit_curve; with corners also if knots are not clamped or the first and the last parameters are not the ends of the domain.
 * ET_ERANK: the columns of either direction's matrix depend on each other.  ET_ENOMEM.
 * Golden: none (exact by definition; conformance vectors computed in Python's rationals agree). */
/*@ requires valid:   \valid(P + (0 .. nu * nv - 1)) && \valid(lsq);
    requires read:    \valid_read(u + (0 .. nu + p)) && \valid_read(v + (0 .. nv + q)) && \valid_read(a + (0 .. mu - 1)) &&
                      \valid_read(b + (0 .. mv - 1)) && \valid_read(D + (0 .. mu * mv - 1));
    assigns  P[0 .. nu * nv - 1], *lsq;
    ensures  few:     mu < nu || mv < nv ==> \result != ET_OK;
    ensures  norms:   \result == ET_OK ==> lsq->condition >= nu * nv && lsq->norm > 0.0;
    ensures  kept:    \result != ET_OK ==> *lsq == \old(*lsq) && \forall integer k; 0 <= k < nu * nv ==> P[k] == \old(P[k]);
*/
et_status et_exact_fit_grid(et_vec3 *P, size_t nu, size_t nv, et_exact_lsq *lsq, const double *u, size_t p, const double *v, size_t q,
                            const double *a, size_t mu, const double *b, size_t mv, const et_vec3 *D, int corners);

/* P[i*nv + j]: the least squares surface through m points D[k] at (a[k], b[k]).  Errors as in et_exact_fit_curve.
 * Golden: none (exact by definition; conformance vectors computed in Python's rationals agree). */
/*@ requires valid:   \valid(P + (0 .. nu * nv - 1)) && \valid(lsq);
    requires read:    \valid_read(u + (0 .. nu + p)) && \valid_read(v + (0 .. nv + q)) && \valid_read(a + (0 .. m - 1)) &&
                      \valid_read(b + (0 .. m - 1)) && \valid_read(D + (0 .. m - 1));
    assigns  P[0 .. nu * nv - 1], *lsq;
    ensures  few:     m < nu * nv ==> \result != ET_OK;
    ensures  norms:   \result == ET_OK ==> lsq->condition >= nu * nv && lsq->norm > 0.0;
    ensures  kept:    \result != ET_OK ==> *lsq == \old(*lsq) && \forall integer k; 0 <= k < nu * nv ==> P[k] == \old(P[k]);
*/
et_status et_exact_fit_scattered(et_vec3 *P, size_t nu, size_t nv, et_exact_lsq *lsq, const double *u, size_t p, const double *v, size_t q,
                                 const double *a, const double *b, const et_vec3 *D, size_t m);

/* ---- distances ---- */

/* The least distance of a point from the curve, over the closed domain, with both limits where the curve jumps.  *distance is the exact distance of
 * the point C(x) rounded up, *lower a proved lower bound: *lower <= the least distance <= *distance.  One of these holds:
 *     (1 - 2^-40) *distance <= *lower;
 *     *distance is at most 2^-40 times the size of the control net, the longest side of the box of its control points (then *lower is 0);
 *     what is nearer lies strictly between two neighbouring doubles as parameters (where the doubles of the domain lie far apart, or at a jump);
 *     (1 - 2^-20) *distance <= *lower where 2^12 pieces do not decide more, or (1 - 2^-10) *distance <= *lower where 2^14 do not: where the nearest
 *     points of a surface fill a curve across its parameters.
 * ET_EINVAL (curve not valid, point not finite), ET_ENOMEM, ET_ENOCONV: 2^16 pieces do not decide that either.
 * Golden: none (which of many nearest parameters is found is free; the distance is proved by each call). */
/*@ requires valid:   \valid(x) && \valid(distance) && \valid(lower) && \separated(x, distance, lower) && \valid_read(c);
    requires curve:   et_curve_readable((et_curve *)c);
    assigns  *x, *distance, *lower;
    ensures  bounds:  \result == ET_OK ==> 0.0 <= *lower <= *distance;
    ensures  kept:    \result != ET_OK ==> *x == \old(*x) && *distance == \old(*distance) && *lower == \old(*lower);
*/
et_status et_exact_curve_nearest(double *x, double *distance, double *lower, const et_curve *c, et_vec3 point);

/* The same of a surface: borders, seams and poles are nothing special.
 * Golden: none (which of many nearest parameters is found is free; the distance is proved by each call). */
/*@ requires valid:   \valid(uv + (0 .. 1)) && \valid(distance) && \valid(lower) && \separated(uv + (0 .. 1), distance, lower) && \valid_read(s);
    requires storage: et_surface_readable((et_surface *)s);
    assigns  uv[0 .. 1], *distance, *lower;
    ensures  bounds:  \result == ET_OK ==> 0.0 <= *lower <= *distance;
    ensures  kept:    \result != ET_OK ==> uv[0] == \old(uv[0]) && uv[1] == \old(uv[1]) && *distance == \old(*distance) && *lower == \old(*lower);
*/
et_status et_exact_surface_nearest(double uv[2], double *distance, double *lower, const et_surface *s, et_vec3 point);

/* The sum and the greatest of |D[i*mv + j] - S(a[i], b[j])|, each rounded once; both 0 if there are no data.  ET_EINVAL (surface not valid, a
 * parameter or a datum not finite), ET_ENOMEM.
 * Golden: none (exact by definition; the distances are those of et_exact_fit_measure). */
/*@ requires valid:   \valid(sum) && \valid(greatest) && \separated(sum, greatest) && \valid_read(s);
    requires storage: et_surface_readable((et_surface *)s);
    requires read:    \valid_read(a + (0 .. mu - 1)) && \valid_read(b + (0 .. mv - 1)) && \valid_read(D + (0 .. mu * mv - 1));
    assigns  *sum, *greatest;
    ensures  order:   \result == ET_OK ==> 0.0 <= *greatest <= *sum;
    ensures  kept:    \result != ET_OK ==> *sum == \old(*sum) && *greatest == \old(*greatest);
*/
et_status et_exact_surface_error(double *sum, double *greatest, const et_surface *s, const double *a, size_t mu, const double *b, size_t mv,
                                 const et_vec3 *D);

#ifdef __cplusplus
}
#endif
#endif
