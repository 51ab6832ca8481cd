/* curve: a B-spline or NURBS curve in space (The NURBS Book, sections 3.2 and 4.2).
 *
 *     C(x) = sum_i N_i,p(x) w_i P_i / sum_i N_i,p(x) w_i.
 *
 * The order of operations is part of the contract: with c a coordinate of P_i, or fl(w_i c) and w_i if there are weights, sums run from left to right
 * over the p+1 functions that are not zero, each product and sum rounded; last, with weights, the division by the sum for w.  x outside the domain is
 * clamped to it.
 *
 * Error of a coordinate of a polynomial curve: at most ((1-u)^-m - 1) sum N |c|, m = 7p, barring underflow; a rational one: the same bound for
 * numerator (m + 1) and denominator, and one rounding.
 */
#ifndef ETALON_SPLINE_CURVE_H
#define ETALON_SPLINE_CURVE_H
#include "etalon/base/size.h"
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#include "etalon/spline/knots.h"
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* n control points, n + p + 1 knots; weights is null for a polynomial curve, else n positive numbers. */
typedef struct {
    size_t p, n;
    double *u;
    et_vec3 *points;
    double *weights;
} et_curve;

/*@ predicate et_curve_stored(et_curve *c) =
        \valid_read(c->u + (0 .. c->n + c->p)) && \valid_read(c->points + (0 .. c->n - 1)) &&
        (c->weights == \null || \valid_read(c->weights + (0 .. c->n - 1)));
    predicate et_curve_readable(et_curve *c) = c->u == \null || c->points == \null || et_curve_stored(c);

    predicate et_curve_ok(et_curve *c) =
        et_curve_stored(c) && c->n > c->p && c->n + c->p < SIZE_MAX && c->u[c->p] < c->u[c->n] && \is_finite((double)(c->u[c->n + c->p] - c->u[0])) &&
        (\forall integer i; 0 <= i <= c->n + c->p ==> \is_finite(c->u[i])) &&
        (\forall integer i, j; 0 <= i <= j <= c->n + c->p ==> c->u[i] <= c->u[j]) &&
        (\forall integer i; 0 < i <= c->n + c->p && c->u[i - 1] < c->u[i] ==> c->u[i] - c->u[i - 1] >= 0x1p-1022) &&
        (\forall integer i; 0 <= i < c->n ==>
            \is_finite(c->points[i].x) && \is_finite(c->points[i].y) && \is_finite(c->points[i].z) &&
            (c->weights == \null || (\is_finite(c->weights[i]) && c->weights[i] > 0)));

    predicate et_curve_apart(et_curve *c, double *a, integer n) =
        \separated(a + (0 .. n - 1), c->u + (0 .. c->n + c->p)) && \separated(a + (0 .. n - 1), c->points + (0 .. c->n - 1)) &&
        (c->weights == \null || \separated(a + (0 .. n - 1), c->weights + (0 .. c->n - 1)));

    logic integer et_curve_room(et_curve *c, integer d) = (\min(d, c->p) + 1)*(c->p + 1) + (c->p + 1)*(c->p + 5) + 2*(d + 1);
*/

/* 1 if the knots are valid (et_knots_valid), control points finite, weights null or finite and positive; else 0.  A zeroed struct is not valid. */
/*@ requires c:       \valid_read(c);
    requires storage: et_curve_readable(c);
    assigns  \nothing;
    ensures  flag:    \result == 0 || \result == 1;
    ensures  valid:   \result == 1 ==> et_curve_ok(c);
*/
int et_curve_valid(const et_curve *c);

/* Storage for n control points of degree p, all zero; rational != 0 also allocates weights (all 1).  What *c held before is not freed.
 * ET_EINVAL (n <= p), ET_ENOMEM.
 * Golden: none (storage). */
/*@ requires c:     \valid(c);
    assigns  *c;
    ensures  sizes: \result == ET_OK ==> c->p == p && c->n == n && n + p < SIZE_MAX;
    ensures  made:  \result == ET_OK ==> et_numbers(c->u, n + p + 1) && et_numbers((double *)c->points, 3 * n);
    ensures  fits:  \result == ET_OK ==> sizeof(double)*(n + p + 1) <= SIZE_MAX && sizeof(et_vec3)*n <= SIZE_MAX;
    ensures  kind:  \result == ET_OK ==> (c->weights == \null <==> rational == 0);
    ensures  room:  \result == ET_OK && rational != 0 ==> et_numbers(c->weights, n);
    ensures  ones:  \result == ET_OK && rational != 0 ==> \forall integer i; 0 <= i < n ==> c->weights[i] == 1.0;
    ensures  few:   n <= p ==> \result == ET_EINVAL;
    ensures  kept:  \result != ET_OK ==> *c == \old(*c);
*/
et_status et_curve_new(et_curve *c, size_t p, size_t n, int rational);

/* Frees the storage and zeroes the struct; nothing to do for a zeroed one.
 * Golden: none (no value). */
/*@ requires c:    \valid(c);
    assigns  *c;
    ensures  zero: c->u == \null && c->points == \null && c->weights == \null && c->n == 0 && c->p == 0;
*/
void et_curve_free(et_curve *c);

/* Doubles of workspace for et_curve_point and for et_curve_ders up to order d: (min(d,p) + 1)(p+1) + (p+1)(p+5) + 2(d+1); SIZE_MAX if that does not
 * fit, so that no allocation succeeds. */
/*@ requires c:    \valid_read(c);
    assigns  \nothing;
    ensures  room: \result >= 2;
    ensures  size: \result == (et_curve_room(c, d) <= SIZE_MAX && d <= SIZE_MAX / 4 ? et_curve_room(c, d) : SIZE_MAX);
*/
size_t et_curve_work(const et_curve *c, size_t d);

/* C(x) (A3.1, A4.1).  At the ends of a clamped polynomial curve the end control point exactly (a zero may change its sign); with weights
 * fl(fl(w c) / w), which is c for w a power of two and else within two roundings of it. */
/*@ requires c:      \valid_read(c) && et_curve_ok(c);
    requires finite: \is_finite(x);
    requires room:   nwork >= et_curve_room(c, 0) && \valid(work + (0 .. nwork - 1));
    requires own:    et_curve_apart(c, work, nwork);
    assigns  work[0 .. nwork - 1];
*/
et_vec3 et_curve_point(const et_curve *c, double x, double *work, size_t nwork);

/* D[k] = the k-th derivative of C at x, k = 0..d (A3.2; with weights A4.2, Eq. 4.8), at inner knots from the right, at the right end from the left.
 * D[0] has the bits of et_curve_point; derivatives of a polynomial curve beyond the degree are +0.
 *
 * Error of a coordinate of a polynomial curve's k-th derivative: at most ((1-u)^-(7p+3) - 1) M_k, M_k the sum of the magnitudes of all terms,
 * p!/(p-k)! sum_ij |a_kj| N_{i+j,p-k} |c_i| (et_basis_ders).  A rational curve's derivatives satisfy Leibniz' rule for w C = A up to roundings:
 * for k <= 56, where binomial coefficients are exact,
 *     |sum_i C(k,i) w_i D_{k-i} - A_k| <= ((1-u)^-(8p+5) - 1) (M_k + sum_i C(k,i) W_i |D_{k-i}|),  i = 0..k,
 * with the exact derivatives w_i and A_k, M_k of w c, W_i the sum of the magnitudes of the terms of w_i.  All barring over- and underflow. */
/*@ requires c:      \valid_read(c) && et_curve_ok(c);
    requires D:      \valid(D + (0 .. d));
    requires finite: \is_finite(x);
    requires room:   nwork >= et_curve_room(c, d) && \valid(work + (0 .. nwork - 1));
    requires own:    et_curve_apart(c, work, nwork) && et_curve_apart(c, (double *)D, 3 * (d + 1));
    requires apart:  \separated(D + (0 .. d), work + (0 .. nwork - 1));
    assigns  D[0 .. d], work[0 .. nwork - 1];
    ensures  above:  c->weights == \null ==> \forall integer k; c->p < k <= d ==> D[k].x == 0.0 && D[k].y == 0.0 && D[k].z == 0.0;
*/
void et_curve_ders(et_vec3 *D, size_t d, const et_curve *c, double x, double *work, size_t nwork);

/* A copy with storage of its own.  ET_EINVAL (sizes as in et_curve_new), ET_ENOMEM.
 * Golden: none (a copy). */
/*@ requires copy:  \valid(copy);
    requires c:     \valid_read(c) && et_curve_stored(c);
    requires apart: \separated(copy, c);
    assigns  *copy;
    ensures  sizes: \result == ET_OK ==> copy->p == c->p && copy->n == c->n && (copy->weights == \null <==> c->weights == \null);
    ensures  own:   \result == ET_OK ==> copy->u != c->u && copy->points != c->points;
    ensures  kept:  \result != ET_OK ==> *copy == \old(*copy);
*/
et_status et_curve_copy(et_curve *copy, const et_curve *c);

/* et_curve_ders with the side chosen at knots, of the value, too, which jumps at inner knots of multiplicity p + 1 and more; from the right its bits.
 * The same bounds, with the terms of that side. */
/*@ requires c:      \valid_read(c) && et_curve_ok(c);
    requires D:      \valid(D + (0 .. d));
    requires finite: \is_finite(x);
    requires side:   side == ET_SIDE_RIGHT || side == ET_SIDE_LEFT;
    requires room:   nwork >= et_curve_room(c, d) && \valid(work + (0 .. nwork - 1));
    requires own:    et_curve_apart(c, work, nwork) && et_curve_apart(c, (double *)D, 3 * (d + 1));
    requires apart:  \separated(D + (0 .. d), work + (0 .. nwork - 1));
    assigns  D[0 .. d], work[0 .. nwork - 1];
    ensures  above:  c->weights == \null ==> \forall integer k; c->p < k <= d ==> D[k].x == 0.0 && D[k].y == 0.0 && D[k].z == 0.0;
*/
void et_curve_ders_side(et_vec3 *D, size_t d, const et_curve *c, double x, et_side side, double *work, size_t nwork);

/* ---- the same curve in another form.  What the output held before is not freed; it must not be the input.
 *
 * Rational curves are edited in homogeneous coordinates (w x, w y, w z, w), all weights over one power of two, so that no product overflows.  Control
 * points (and weights) that an edit leaves alone keep their bits.  ET_EINVAL is returned for a curve that is not valid, too, and where no valid curve
 * would come out: knots nearer than 2^-1022 to each other, an overflow, a weight that underflows to 0. ---- */

/* With the knot x, inside the domain (its ends included, if they are not clamped), `times` times more, behind those equal to it (A5.1, one knot
 * after the other).  The multiplicity becomes p + 1 at most: there the curve falls apart into two.  Knots need not be clamped.
 * ET_EINVAL (x outside the domain or not a number, too great a multiplicity), ET_ENOMEM.
 *
 * Each knot makes Q_i = a P_i + (1-a) P_{i-1}, a = (x - u_i)/(u_{i+p} - u_i), where a and 1-a are quotients of differences, both from 0 to 1: so
 * weights remain positive.  A coordinate of a polynomial curve's control point, and a weight, is off by at most ((1-u)^-m - 1) sum A |c|, A the
 * convex combination that makes it of the old ones, m = 5 min(times, p); a coordinate of a rational one: numerator m + 1, denominator m, and one
 * rounding. All barring underflow. */
/*@ requires refined: \valid(refined);
    requires c:       \valid_read(c) && et_curve_readable(c);
    requires apart:   \separated(refined, c);
    assigns  *refined;
    ensures  ends:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures  inside:  \result == ET_OK ==> c->u[c->p] <= x <= c->u[c->n];
    ensures  often:   \result == ET_OK ==> times <= c->p + 1;
    ensures  sizes:   \result == ET_OK ==> refined->p == c->p && refined->n == c->n + times;
    ensures  kind:    \result == ET_OK ==> (refined->weights == \null <==> c->weights == \null);
    ensures  kept:    \result != ET_OK ==> *refined == \old(*refined);
*/
et_status et_curve_insert(et_curve *refined, const et_curve *c, double x, size_t times);

/* Without the knot x, of the open domain, as often as possible, at most `times`, with no point moved by more than `tolerance`, finite and not
 * negative (A5.8, one knot after the other).  *removed: how often; 0 gives a copy.  Knots need not be clamped.  ET_EINVAL (x is no knot of the open
 * domain, the tolerance), ET_ENOMEM.
 *
 * Half of the equations P_i = a Q_i + (1-a) Q_{i-1} are solved from the left, half from the right.  The last one is not satisfied by e, or, with
 * none left, the two ways to the middle point differ by e: by |e| at most a polynomial curve moves.  With weights e is e_A of w P and e_w of w, and
 * the curve moves by at most the tolerance if |e_A| + (max |P| + tolerance) |e_w| is at most tolerance min w: less than Eq. 5.30 asks for, and the
 * same at any scale.  What several removals need is added up.  A removal that would give a weight that is not positive is not made.
 *
 * Each new point satisfies its equation within ((1-u)^-5 - 1) (a |Q_i| + (1-a) |Q_{i-1}|), by which the curve moves beside. */
/*@ requires reduced: \valid(reduced) && \valid(removed);
    requires c:       \valid_read(c) && et_curve_readable(c);
    requires apart:   \separated(reduced, removed, c);
    assigns  *reduced, *removed;
    ensures  ends:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures  inner:   \result == ET_OK ==> c->u[c->p] < x < c->u[c->n] && \is_finite(tolerance) && tolerance >= 0.0;
    ensures  often:   \result == ET_OK ==> *removed <= times;
    ensures  sizes:   \result == ET_OK ==> reduced->p == c->p && reduced->n == c->n - *removed;
    ensures  kind:    \result == ET_OK ==> (reduced->weights == \null <==> c->weights == \null);
    ensures  kept:    \result != ET_OK ==> *reduced == \old(*reduced) && *removed == \old(*removed);
*/
et_status et_curve_remove(et_curve *reduced, size_t *removed, const et_curve *c, double x, size_t times, double tolerance);

/* Of a degree higher by `times`: each different knot gets that multiplicity more.  The ends must be clamped.  Any degree, 0 included, and any inner
 * multiplicity.  ET_EINVAL (ends not clamped), ET_ENOMEM.
 *
 * One degree after the other.  A control point of degree p + 1 is the mean of p + 1 control points of degree p over the new knots without one of its
 * p + 1 (Prautzsch 1984); those are combinations of the old ones by discrete B-splines (the Oslo algorithm; Cohen, Lyche and Riesenfeld 1980).  The
 * shares of the old control points are summed up first; none is negative, so weights remain positive, and there are no binomial coefficients.
 * A coordinate of a polynomial curve's control point, and a weight, is off by at most ((1-u)^-m - 1) sum A |c|, A the convex combination that makes
 * it of the old ones, m = sum of 7(p + k) + 2 over k = 0 .. times - 1; a coordinate of a rational one: numerator m + 1, denominator m, and one
 * rounding.  The ends, and the points on both sides of an inner knot of multiplicity p + 1, keep their bits.  All barring underflow. */
/*@ requires elevated: \valid(elevated);
    requires c:        \valid_read(c) && et_curve_readable(c);
    requires apart:    \separated(elevated, c);
    assigns  *elevated;
    ensures  ends:     \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures  clamped:  \result == ET_OK ==> c->u[0] == c->u[c->p] && c->u[c->n] == c->u[c->n + c->p];
    ensures  degree:   \result == ET_OK ==> elevated->p == c->p + times && elevated->n >= c->n + times;
    ensures  kind:     \result == ET_OK ==> (elevated->weights == \null <==> c->weights == \null);
    ensures  kept:     \result != ET_OK ==> *elevated == \old(*elevated);
*/
et_status et_curve_elevate(et_curve *elevated, const et_curve *c, size_t times);

#ifdef __cplusplus
}
#endif
#endif
