/* frame: the axis-parallel map between a cloud's own coordinates and the unit cube in which Etalon works.
 *
 *     unit = (own - offset) / scale,   own = offset + scale * unit,   a coordinate at a time.
 *
 * ET_FRAME_BOX is the source's normalisation: each axis by its own minimum and maximum to [0,1].  ET_FRAME_UNIFORM keeps
 * proportions: one scale, the longest side.  ET_FRAME_NONE: offset 0, scale 1.  An axis of no extent gets scale 1 under BOX.
 */
#ifndef ETALON_BASE_FRAME_H
#define ETALON_BASE_FRAME_H
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef enum { ET_FRAME_BOX = 0, ET_FRAME_UNIFORM, ET_FRAME_NONE } et_frame_kind;
typedef struct { et_vec3 offset, scale; } et_frame;

/* "box", "uniform", "none"; null past the last.
 * Golden: none (names). */
/*@ assigns \result \from kind;
    ensures named: ET_FRAME_BOX <= kind <= ET_FRAME_NONE ==> \result != \null;
    ensures known: ET_FRAME_BOX <= kind <= ET_FRAME_NONE ==> valid_read_string(\result);
    ensures past:  !(ET_FRAME_BOX <= kind <= ET_FRAME_NONE) ==> \result == \null;
*/
const char *et_frame_name(et_frame_kind kind);

/* The frame of a cloud: offset the minima, scale the extents fl(max - min).  ET_EFORMAT (points not finite, n == 0, or all points
 * equal, or an extent that overflows), ET_EINVAL (kind unknown). */
/*@ requires frame:  \valid(frame);
    requires points: \valid_read(points + (0 .. n - 1));
    requires apart:  \separated(frame, points + (0 .. n - 1));
    assigns  *frame;
    ensures  above:  \result == ET_OK ==> \gt_double(frame->scale.x, (double)0.0) && \gt_double(frame->scale.y, (double)0.0)
                         && \gt_double(frame->scale.z, (double)0.0);
    ensures  scale:  \result == ET_OK ==> frame->scale.x > 0.0 && frame->scale.y > 0.0 && frame->scale.z > 0.0;
    ensures  kept:   \result != ET_OK ==> *frame == \old(*frame);
    ensures  empty:  n == 0 && ET_FRAME_BOX <= kind <= ET_FRAME_NONE ==> \result == ET_EFORMAT;
*/
et_status et_frame_of(et_frame *frame, const et_vec3 *points, size_t n, et_frame_kind kind);

/* In place, own -> unit: two roundings, fl(fl(own - offset) / scale), relative error at most 2u + u^2 barring underflow.  Under BOX the minimum of an
 * axis becomes 0 and its maximum 1 exactly (the scale is the same rounded difference), and all else lies in [0,1], because each
 * operation rounds monotonically.  With offset 0 and scale 1 every bit is kept. */
/*@ requires points: \valid(points + (0 .. n - 1));
    requires frame:  \valid_read(frame);
    requires scale:  frame->scale.x > 0.0 && frame->scale.y > 0.0 && frame->scale.z > 0.0;
    requires apart:  \separated(frame, points + (0 .. n - 1));
    assigns  points[0 .. n - 1];
*/
void et_frame_to_unit(et_vec3 *points, size_t n, const et_frame *frame);

/* In place, unit -> own: fl(offset + fl(scale * unit)).  0 becomes the offset exactly; 1 becomes fl(offset + scale), which is the
 * maximum only up to the rounding of the extent.  There and back, own -> unit -> own, differs by at most 3.01u scale + u |result|
 * for points of the box.  With offset 0 and scale 1 every bit is kept. */
/*@ requires points: \valid(points + (0 .. n - 1));
    requires frame:  \valid_read(frame);
    requires apart:  \separated(frame, points + (0 .. n - 1));
    assigns  points[0 .. n - 1];
*/
void et_frame_from_unit(et_vec3 *points, size_t n, const et_frame *frame);

#ifdef __cplusplus
}
#endif
#endif
