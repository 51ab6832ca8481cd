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
 * Preconditions are those of the functions named.  FLINT ends the program when memory runs out; ET_ENOMEM tells only of sizes and of arrays of our own.
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

/* All partial derivatives of order up to d (any d): (d+1)(d+2)/2 of them, by order, and within an order by falling power of u: S, S_u, S_v, S_uu, S_uv,
 * S_vv, S_uuu, S_uuv, ...; for d = 2 the layout of et_surface_ders.  At inner knots from the right.  ET_EINVAL, ET_ENOMEM.
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

/* Averages of the parameters of all lines (et_param_grid), each average rounded once.  ET_EINVAL, ET_ENOMEM; ET_ENOCONV when a tie of sums of different
 * roots cannot be decided by 2^16 bits.
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

/* The surface errors of et_fit_measure, each rounded once: every distance, both sums, both maxima.  ET_EINVAL (nov not the data's, a surface not valid, a
 * parameter not finite), ET_ENOMEM.
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

et_status et_exact_knots_greville(double *g, size_t n, const double *u, size_t nu, size_t p);
et_status et_exact_curve_ders_side(et_vec3 *D, size_t d, const et_curve *c, double x, et_side side);
et_status et_exact_surface_partials(et_vec3 *D, size_t d, const et_surface *s, double u, double v, et_side side_u, et_side side_v);
et_status et_exact_surface_normal(et_vec3 *n, const et_surface *s, double u, double v);
/* Control points (after the division by the exact weight) and weights rounded once each. */
et_status et_exact_curve_insert(et_curve *refined, const et_curve *c, double x, size_t times);
et_status et_exact_curve_elevate(et_curve *elevated, const et_curve *c, size_t times);
/* The knot is removed as often as the exact curve allows without any change: of the exact removability, no tolerance; *removed says how often. */
et_status et_exact_curve_remove(et_curve *reduced, size_t *removed, const et_curve *c, double x, size_t times);
et_status et_exact_surface_insert(et_surface *refined, const et_surface *s, et_direction along, double x, size_t times);
et_status et_exact_surface_elevate(et_surface *elevated, const et_surface *s, et_direction along, size_t times);
et_status et_exact_surface_remove(et_surface *reduced, size_t *removed, const et_surface *s, et_direction along, double x, size_t times);

/* ---- least squares with given parameters and knots ---- */

/* What a bound for a computed solution needs: condition |A|_F |A+|_F of the collocation matrix (the product of both directions' for a grid), rounded once upwards or to nearest;
 * norm |A|_F; per coordinate |P|_2 and the residual |A P - D|_2. */
typedef struct { double condition, norm; et_vec3 solution, residual; } et_exact_lsq;

/* P[0..n-1]: the least squares curve of degree p with knots u through the m points D at parameters t.  ET_EINVAL, ET_ERANK, ET_ENOMEM. */
et_status et_exact_fit_curve(et_vec3 *P, size_t n, et_exact_lsq *lsq, const double *u, size_t nu, size_t p, const double *t, const et_vec3 *D, size_t m);
/* P[i*nv + j]: the least squares surface through D[i*mv + j] at (a[i], b[j]); corners != 0: it interpolates the four corners (a constrained optimum). */
et_status et_exact_fit_grid(et_vec3 *P, size_t nu, size_t nv, et_exact_lsq *lsq, const double *u, size_t p, const double *v, size_t q, const double *a, size_t mu,
                            const double *b, size_t mv, const et_vec3 *D, int corners);
/* P[i*nv + j]: the least squares surface through m points D[k] at (a[k], b[k]). */
et_status et_exact_fit_scattered(et_vec3 *P, size_t nu, size_t nv, et_exact_lsq *lsq, const double *u, size_t p, const double *v, size_t q, const double *a,
                                 const double *b, const et_vec3 *D, size_t m);

/* ---- distances ---- */

/* The least distance of a point from the curve: *lower <= exact minimum <= *distance, (1 - 2^-40) *distance <= *lower or *distance below 2^-40 times the size of the control net;
 * *x where *distance is attained.  A branch and bound over rigorous (Bezier hull) bounds.  ET_ENOCONV if that many boxes do not decide it. */
et_status et_exact_curve_nearest(double *x, double *distance, double *lower, const et_curve *c, et_vec3 point);
et_status et_exact_surface_nearest(double uv[2], double *distance, double *lower, const et_surface *s, et_vec3 point);
/* sum and greatest of |D[i*mv + j] - S(a[i], b[j])|, each rounded once. */
et_status et_exact_surface_error(double *sum, double *greatest, const et_surface *s, const double *a, size_t mu, const double *b, size_t mv, const et_vec3 *D);

#ifdef __cplusplus
}
#endif
#endif
