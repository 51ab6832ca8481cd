/* base/frame: clouds in another order, larger by a power of two; names found again. */
#include "etalon/base/frame.h"
#include "gen.h"
#include <math.h>
#include <string.h>

enum { MOST = 24 };

static bool close(double a, double b)
{
    return fabs(a - b) <= 0x1p-1000;
}

static bool same(const et_vec3 *a, const et_vec3 *b, size_t n)
{
    bool ok = true;

    for (size_t i = 0; i < n; i++)
        ok = ok && a[i].x == b[i].x && a[i].y == b[i].y && a[i].z == b[i].z;
    return ok;
}

static double larger(double scale, bool long_, int e)
{
    return long_ ? ldexp(scale, e) : scale;           /* 1 along an axis without extent, in a box */
}

/* The same frame from any order; 2^e times as large where the cloud is; the same place in the unit cube; and back 2^e times as far. */
verdict prop_frame_of_scaled(gen *g)
{
    et_vec3 p[MOST], q[MOST], lo, hi, unit[MOST], again[MOST];
    et_frame f, turned, large;
    const et_frame_kind kind = gen_upto(g, 1) ? ET_FRAME_UNIFORM : ET_FRAME_BOX;
    const size_t n = 1 + (size_t)gen_upto(g, MOST - 1);
    const int e = (int)gen_upto(g, 40);

    gen_points(g, &p[0].x, n);
    lo = hi = p[0];
    for (size_t i = 0; i < n; i++) {
        q[n - 1 - i] = p[i];
        lo = (et_vec3){fmin(lo.x, p[i].x), fmin(lo.y, p[i].y), fmin(lo.z, p[i].z)};
        hi = (et_vec3){fmax(hi.x, p[i].x), fmax(hi.y, p[i].y), fmax(hi.z, p[i].z)};
    }
    if (et_frame_of(&f, p, n, kind) != ET_OK)
        return SKIP;
    bool ok = gen_check(g, et_frame_of(&turned, q, n, kind) == ET_OK && same(&f.offset, &turned.offset, 1) && same(&f.scale, &turned.scale, 1),
            "another order");
    for (size_t i = 0; i < n; i++)
        q[i] = (et_vec3){ldexp(p[i].x, e), ldexp(p[i].y, e), ldexp(p[i].z, e)};
    const et_vec3 offset = {ldexp(f.offset.x, e), ldexp(f.offset.y, e), ldexp(f.offset.z, e)};
    const bool all = kind == ET_FRAME_UNIFORM;
    const et_vec3 scale = {larger(f.scale.x, all || hi.x > lo.x, e), larger(f.scale.y, all || hi.y > lo.y, e), larger(f.scale.z, all || hi.z > lo.z,
            e)};
    ok = ok && gen_check(g, et_frame_of(&large, q, n, kind) == ET_OK && same(&large.offset, &offset, 1) && same(&large.scale, &scale, 1),
            "2^%d times", e);
    memcpy(unit, p, sizeof unit);
    memcpy(again, q, sizeof again);
    et_frame_to_unit(unit, n, &f);
    et_frame_to_unit(again, n, &large);
    ok = ok && gen_check(g, same(unit, again, n), "2^%d times, another place in the unit cube", e);
    et_frame_from_unit(unit, n, &f);
    et_frame_from_unit(again, n, &large);
    for (size_t i = 0; ok && i < n; i++) {          /* but for what was below the normal numbers */
        const et_vec3 a = {ldexp(unit[i].x, e), ldexp(unit[i].y, e), ldexp(unit[i].z, e)}, b = again[i];
        ok = gen_check(g, close(a.x, b.x) && close(a.y, b.y) && close(a.z, b.z), "2^%d times, and back to another place", e);
    }
    return ok ? PASS : FAIL;
}

/* By its name a kind is found again: no two have one name. */
verdict prop_frame_name_found(gen *g)
{
    const int kind = (int)gen_upto(g, 2);
    int found = 0;

    while (strcmp(et_frame_name((et_frame_kind)found), et_frame_name((et_frame_kind)kind)) != 0)
        found++;
    return gen_check(g, found == kind, "kind %d is called as %d is", kind, found) ? PASS : FAIL;
}
