/* curve_parts: many curves over one knot vector, in homogeneous coordinates, for what edits the knots of a curve or of a surface. */
#ifndef SPLINE_CURVE_PARTS_H
#define SPLINE_CURVE_PARTS_H
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

/* A net of n points a line.  ET_ENOMEM. */
et_status curve_net_new(curve_net *net, size_t p, size_t n, size_t lines, int rational);
void curve_net_free(curve_net *net);

/* With storage for `room` points a line more.  ET_ENOMEM. */
et_status curve_net_load(curve_net *net, size_t p, size_t n, size_t room, size_t lines, const double *u, const curve_controls *c);

/* Knots and control points of what net became; old: those it was loaded from. */
void curve_net_store(double *u, const curve_controls *to, const curve_net *net, const curve_controls *old);

/* 1 if the knot x can be inserted `times` times more. */
int curve_net_insertable(const double *u, size_t p, size_t n, double x, size_t times);

/* 1 if x is a knot of the open domain. */
int curve_net_removable(const double *u, size_t p, size_t n, double x);

/* The net has room for `times` points more, and x can be inserted. */
void curve_net_insert(curve_net *net, double x, size_t times);

/* x can be removed.  ET_ENOMEM. */
et_status curve_net_remove(curve_net *net, size_t *removed, double x, size_t times, double tolerance);

/* A net of a degree higher by `times`, the ends clamped.  ET_ENOMEM. */
et_status curve_net_elevate(curve_net *net, size_t times);

/* Control points of a line after the elevation; SIZE_MAX if that does not fit. */
size_t curve_net_elevated(const double *u, size_t p, size_t n, size_t times);
#endif
