#include "etalon/base/frame.h"
#include <math.h>

const char *et_frame_name(et_frame_kind kind)
{
    static const char *const name[] = {"box", "uniform", "none"};
    return (unsigned)kind <= ET_FRAME_NONE ? name[kind] : NULL;
}

/* fmin and fmax may pick either of two zeros; these pick the first. */
/*@ assigns \nothing;
    ensures finite: \is_finite(a) && \is_finite(b) ==> \is_finite(\result);
*/
static double lesser(double a, double b)
{
    return b < a ? b : a;
}

/*@ assigns \nothing;
    ensures finite: \is_finite(a) && \is_finite(b) ==> \is_finite(\result);
*/
static double greater(double a, double b)
{
    return b > a ? b : a;
}

/*@ assigns \nothing; */
static et_vec3 least(et_vec3 a, et_vec3 b)
{
    return (et_vec3){lesser(a.x, b.x), lesser(a.y, b.y), lesser(a.z, b.z)};
}

/*@ assigns \nothing; */
static et_vec3 greatest(et_vec3 a, et_vec3 b)
{
    return (et_vec3){greater(a.x, b.x), greater(a.y, b.y), greater(a.z, b.z)};
}

/*@ assigns \nothing;
    ensures positive: \gt_double(\result, (double)0.0);
*/
static double or_one(double extent)
{
    return extent > 0.0 ? extent : 1.0;
}

et_status et_frame_of(et_frame *frame, const et_vec3 *points, size_t n, et_frame_kind kind)
{
    if (!et_frame_name(kind)) {
        return ET_EINVAL;
    }
    if (n == 0 || !et_vec3_finite(points, n)) {
        return ET_EFORMAT;
    }
    et_vec3 lo = points[0], hi = points[0];
    /*@ loop invariant place: 1 <= i <= n;
        loop assigns i, lo, hi;
        loop variant n - i;
    */
    for (size_t i = 1; i < n; i++) {
        lo = least(lo, points[i]);
        hi = greatest(hi, points[i]);
    }
    et_vec3 extent = {hi.x - lo.x, hi.y - lo.y, hi.z - lo.z};
    double longest = greater(extent.x, greater(extent.y, extent.z));
    if (!(longest > 0.0) || !isfinite(longest)) {
        return ET_EFORMAT;
    }
    switch (kind) {
    case ET_FRAME_BOX:
        *frame = (et_frame){lo, {or_one(extent.x), or_one(extent.y), or_one(extent.z)}};
        break;
    case ET_FRAME_UNIFORM:
        *frame = (et_frame){lo, {longest, longest, longest}};
        break;
    case ET_FRAME_NONE:
        *frame = (et_frame){{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
        break;
    }
    return ET_OK;
}

void et_frame_to_unit(et_vec3 *points, size_t n, const et_frame *frame)
{
    et_vec3 o = frame->offset, s = frame->scale;
    /*@ loop invariant place: i <= n;
        loop assigns i, points[0 .. n - 1];
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++) {
        points[i].x = (points[i].x - o.x) / s.x;
        points[i].y = (points[i].y - o.y) / s.y;
        points[i].z = (points[i].z - o.z) / s.z;
    }
}

/* 0 + (-0) is +0: with no offset nothing is added, so that the identity keeps every bit. */
/*@ assigns \nothing; */
static double from_unit(double unit, double offset, double scale)
{
    return offset == 0.0 ? scale * unit : offset + scale * unit;
}

void et_frame_from_unit(et_vec3 *points, size_t n, const et_frame *frame)
{
    et_vec3 o = frame->offset, s = frame->scale;
    /*@ loop invariant place: i <= n;
        loop assigns i, points[0 .. n - 1];
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++) {
        points[i].x = from_unit(points[i].x, o.x, s.x);
        points[i].y = from_unit(points[i].y, o.y, s.y);
        points[i].z = from_unit(points[i].z, o.z, s.z);
    }
}
