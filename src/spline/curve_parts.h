/* curve_parts: many curves over one knot vector, in homogeneous coordinates, for what edits the knots of a curve or of a surface. */
#ifndef SPLINE_CURVE_PARTS_H
#define SPLINE_CURVE_PARTS_H
#include "etalon/base/size.h"
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#include <stddef.h>
#include <stdint.h>

typedef struct { double x, y, z, w; } curve_point;

/* `from` of a point that was computed. */
#define CURVE_COMPUTED SIZE_MAX

/* Point i of a line stands at h[i*lines + line], as (w x, w y, w z, w), the weights divided by 2^exponent, so that the greatest is from 1/2 to 1 and
 * no product overflows.  from[i]: of which control point of the curve that is edited point i is a copy, whose bits it keeps. */
typedef struct {
    size_t p, n, lines;
    int rational, exponent;
    double *u;
    curve_point *h;
    size_t *from;
} curve_net;

/* Control point i of a line stands at points[i*step + line*across], its weight likewise; weights may be null. */
typedef struct {
    et_vec3 *points;
    double *weights;
    size_t step, across;
} curve_controls;

/*@ predicate curve_net_made(curve_net *net, integer m) =
        m + net->p < SIZE_MAX && et_numbers(net->u, m + net->p + 1) && et_array((char *)net->from, m, sizeof(size_t)) &&
        m*net->lines <= SIZE_MAX && et_numbers((double *)net->h, 4*(m*net->lines));

    predicate curve_net_apart(curve_net *net, integer m) =
        \separated(net, net->from + (0 .. m - 1)) && \separated(net->u + (0 .. m + net->p), net->h + (0 .. m*net->lines - 1));

    predicate curve_net_from(curve_net *net, integer m) = \forall integer i; 0 <= i < net->n ==> net->from[i] == SIZE_MAX || net->from[i] < m;

    predicate curve_knots(double *u, integer n, integer p) =
        0 <= p < n && n + p < SIZE_MAX && u[p] < u[n] && \is_finite((double)(u[n + p] - u[0])) &&
        (\forall integer i; 0 <= i <= n + p ==> \is_finite(u[i])) && (\forall integer i, j; 0 <= i <= j <= n + p ==> u[i] <= u[j]);

    predicate curve_open(double *u, integer n, integer p, double x, integer times) =
        \is_finite(x) && u[p] <= x <= u[n] &&
        (times == 0 || (times <= p + 1 && \forall integer i; 0 <= i < n + times ==> !(u[i] == x && u[i + p + 1 - times] == x)));

    logic integer curve_last(curve_controls *c, integer n, integer lines) = (n - 1)*c->step + (lines - 1)*c->across;

    predicate curve_controls_read(curve_controls *c, integer n, integer lines) =
        1 <= n && 1 <= lines && curve_last(c, n, lines) < SIZE_MAX && \valid_read(c->points + (0 .. curve_last(c, n, lines))) &&
        (c->weights == \null || \valid_read(c->weights + (0 .. curve_last(c, n, lines))));

    predicate curve_controls_made(curve_controls *c, integer n, integer lines) =
        1 <= n && 1 <= lines && curve_last(c, n, lines) < SIZE_MAX && et_numbers((double *)c->points, 3*(curve_last(c, n, lines) + 1)) &&
        (c->weights == \null || et_numbers(c->weights, curve_last(c, n, lines) + 1));

    logic integer curve_different(double *u, integer nu) = nu <= 1 ? 1 : curve_different(u, nu - 1) + (u[nu - 2] < u[nu - 1] ? 1 : 0);
*/

/* A net of n points a line.  ET_ENOMEM. */
/*@ requires net:   \valid(net);
    assigns  *net;
    ensures  ends:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  sizes: \result == ET_OK ==> net->p == p && net->n == n && net->lines == lines && net->rational == rational;
    ensures  made:  \result == ET_OK ==> curve_net_made(net, n) && curve_net_apart(net, n);
*/
et_status curve_net_new(curve_net *net, size_t p, size_t n, size_t lines, int rational);

/*@ requires net:   \valid_read(net);
    assigns  \nothing;
*/
void curve_net_free(curve_net *net);

/* With storage for `room` points a line more.  ET_ENOMEM. */
/*@ requires net:   \valid(net) && \valid_read(c) && \separated(net, c);
    requires knots: \valid_read(u + (0 .. n + p)) && curve_knots((double *)u, n, p);
    requires c:     curve_controls_read((curve_controls *)c, n, lines);
    requires room:  n + room + p < SIZE_MAX;
    assigns  *net;
    ensures  ends:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  sizes: \result == ET_OK ==> net->p == p && net->n == n && net->lines == lines && (net->rational != 0 <==> c->weights != \null);
    ensures  made:  \result == ET_OK ==> curve_net_made(net, n + room) && curve_net_apart(net, n + room);
    ensures  from:  \result == ET_OK ==> curve_net_from(net, n);
    ensures  knots: \result == ET_OK ==> curve_knots(net->u, n, p);
    ensures  same:  \result == ET_OK ==> \forall integer i; 0 <= i <= n + p ==> net->u[i] == u[i];
    ensures  count: \result == ET_OK ==> curve_different(net->u, n + p + 1) == curve_different((double *)u, n + p + 1);
*/
et_status curve_net_load(curve_net *net, size_t p, size_t n, size_t room, size_t lines, const double *u, const curve_controls *c);

/* Knots and control points of what net became; old: those it was loaded from. */
/*@ requires net:   \valid_read(net) && \valid_read(to) && \valid_read(old) && curve_net_made((curve_net *)net, net->n);
    requires to:    et_numbers(u, net->n + net->p + 1) && curve_controls_made((curve_controls *)to, net->n, net->lines);
    requires old:   \exists integer m; curve_net_from((curve_net *)net, m) && curve_controls_read((curve_controls *)old, m, net->lines);
    requires kind:  net->rational != 0 ==> to->weights != \null && old->weights != \null;
    requires apart: \separated(u + (0 .. net->n + net->p), net->u + (0 .. net->n + net->p));
    assigns  u[0 .. net->n + net->p], to->points[0 .. (net->n - 1)*to->step + (net->lines - 1)*to->across],
             to->weights[0 .. (net->n - 1)*to->step + (net->lines - 1)*to->across];
*/
void curve_net_store(double *u, const curve_controls *to, const curve_net *net, const curve_controls *old);

/* 1 if the knot x can be inserted `times` times more. */
/*@ requires knots:  \valid_read(u + (0 .. n + p)) && curve_knots((double *)u, n, p);
    assigns  \nothing;
    ensures  flag:   \result == 0 || \result == 1;
    ensures  inside: \result == 1 ==> u[p] <= x <= u[n] && times <= p + 1;
    ensures  open:   \result == 1 ==> curve_open((double *)u, n, p, x, times);
*/
int curve_net_insertable(const double *u, size_t p, size_t n, double x, size_t times);

/* 1 if x is a knot of the open domain. */
/*@ requires knots:  \valid_read(u + (0 .. n + p)) && curve_knots((double *)u, n, p);
    assigns  \nothing;
    ensures  flag:   \result == 0 || \result == 1;
    ensures  inside: \result == 1 ==> u[p] < x < u[n] && \is_finite(x);
*/
int curve_net_removable(const double *u, size_t p, size_t n, double x);

/* The net has room for `times` points more, and x can be inserted. */
/*@ requires net:   \valid(net) && curve_knots(net->u, net->n, net->p) && curve_open(net->u, net->n, net->p, x, times);
    requires made:  curve_net_made(net, net->n + times) && curve_net_apart(net, net->n + times);
    assigns  net->n, net->u[0 .. net->n + times + net->p], net->h[0 .. (net->n + times)*net->lines - 1], net->from[0 .. net->n + times - 1];
    ensures  count: net->n == \old(net->n) + times;
    ensures  from:  \forall integer m; \old(curve_net_from(net, m)) ==> curve_net_from(net, m);
*/
void curve_net_insert(curve_net *net, double x, size_t times);

/* x can be removed.  ET_ENOMEM. */
/*@ requires net:   \valid(net) && curve_knots(net->u, net->n, net->p) && net->u[net->p] < x < net->u[net->n] && \is_finite(x);
    requires made:  curve_net_made(net, net->n) && curve_net_apart(net, net->n);
    requires apart: \valid(removed) && \separated(removed, net) && \separated(removed, net->from + (0 .. net->n - 1));
    assigns  *removed, net->n, net->u[0 .. net->n + net->p], net->h[0 .. net->n*net->lines - 1], net->from[0 .. net->n - 1];
    ensures  ends:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  often: \result == ET_OK ==> *removed <= times && net->n == \old(net->n) - *removed && net->n > net->p;
    ensures  kept:  \result != ET_OK ==> net->n == \old(net->n);
    ensures  from:  \result == ET_OK ==> \forall integer m; \old(curve_net_from(net, m)) ==> curve_net_from(net, m);
*/
et_status curve_net_remove(curve_net *net, size_t *removed, double x, size_t times, double tolerance);

/* A net of a degree higher by `times`, the ends clamped.  ET_ENOMEM. */
/*@ requires net:   \valid(net) && curve_knots(net->u, net->n, net->p) && curve_net_made(net, net->n) && curve_net_apart(net, net->n);
    assigns  *net;
    ensures  ends:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  sizes: \result == ET_OK ==> net->p == \old(net->p) + times && net->lines == \old(net->lines) && net->rational == \old(net->rational);
    ensures  count: \result == ET_OK ==>
                        net->n == \old(net->n) + times*(\at(curve_different(net->u, net->n + net->p + 1), Pre) - 1);
    ensures  made:  \result == ET_OK ==> curve_net_made(net, net->n) && curve_net_apart(net, net->n);
    ensures  from:  \result == ET_OK ==> \forall integer m; \old(curve_net_from(net, m)) ==> curve_net_from(net, m);
*/
et_status curve_net_elevate(curve_net *net, size_t times);

/* Control points of a line after the elevation; SIZE_MAX if that does not fit. */
/*@ requires knots:  \valid_read(u + (0 .. n + p)) && curve_knots((double *)u, n, p);
    assigns  \nothing;
    ensures  count:  \result == n + times*(curve_different((double *)u, n + p + 1) - 1) || \result == SIZE_MAX;
    ensures  more:   \result < SIZE_MAX ==> \result >= n + times;
*/
size_t curve_net_elevated(const double *u, size_t p, size_t n, size_t times);
#endif
