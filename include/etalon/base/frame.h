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

/* "box", "uniform", "none"; null past the last. */
const char *et_frame_name(et_frame_kind kind);

/* The frame of a cloud.  ET_EFORMAT (points not finite, n == 0, or all points equal, or an extent that overflows). */
et_status et_frame_of(et_frame *frame, const et_vec3 *points, size_t n, et_frame_kind kind);

/* In place: own -> unit, and unit -> own. */
void et_frame_to_unit(et_vec3 *points, size_t n, const et_frame *frame);
void et_frame_from_unit(et_vec3 *points, size_t n, const et_frame *frame);

#ifdef __cplusplus
}
#endif
#endif
