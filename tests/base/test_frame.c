/* base/frame: ends hit exactly, there and back within the stated bounds, unusable clouds refused. */
#include "etalon/base/frame.h"
#include "etalon/base/real.h"
#include "gen.h"
#include "golden.h"
#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST = 24 };

static double *axis(et_vec3 *p, int a)
{
    return a == 0 ? &p->x : a == 1 ? &p->y : &p->z;
}

static size_t draw_cloud(gen *g, et_vec3 *p)
{
    size_t n = 1 + (size_t)gen_upto(g, MOST - 1);
    gen_points(g, &p[0].x, n);
    if (gen_chance(g, 4)) {                  /* far from the origin: the extent rounds */
        double far = ldexp(1.0 + (double)gen_upto(g, 7), (int)gen_upto(g, 12));
        for (size_t i = 0; i < n; i++) {
            p[i].x = p[i].x * 0.37 + far;
        }
    }
    return n;
}

static void bounds(et_vec3 *lo, et_vec3 *hi, et_vec3 *p, size_t n)
{
    *lo = *hi = p[n - 1];
    for (size_t i = 0; i < n; i++) {
        for (int a = 0; a < 3; a++) {
            double c = *axis(&p[i], a);
            *axis(lo, a) = c < *axis(lo, a) ? c : *axis(lo, a);
            *axis(hi, a) = c > *axis(hi, a) ? c : *axis(hi, a);
        }
    }
}

verdict prop_frame_name(gen *g)
{
    static const char *const name[] = {"box", "uniform", "none"};
    int kind = (int)gen_upto(g, 2), past = 3 + (int)gen_upto(g, 100);
    bool ok = gen_check(g, strcmp(et_frame_name((et_frame_kind)kind), name[kind]) == 0, "kind %d", kind);
    return ok && gen_check(g, !et_frame_name((et_frame_kind)past), "kind %d has a name", past) ? PASS : FAIL;
}

verdict prop_frame_of(gen *g)
{
    et_vec3 p[MOST], lo, hi, offset, scale;
    et_frame f, old;
    et_frame_kind kind = (et_frame_kind)gen_upto(g, 2);
    size_t n = draw_cloud(g, p);
    memset(&f, 0x2b, sizeof f);
    old = f;
    bounds(&lo, &hi, p, n);
    double sides[3] = {hi.x - lo.x, hi.y - lo.y, hi.z - lo.z}, longest = fmax(sides[0], fmax(sides[1], sides[2]));
    et_status status = et_frame_of(&f, p, n, kind);
    if (longest == 0.0) {
        gen_label(g, "all equal");
        return gen_check(g, status == ET_EFORMAT && memcmp(&f, &old, sizeof f) == 0, "all points equal: %d", (int)status) ? PASS : FAIL;
    }
    bool ok = gen_check(g, status == ET_OK, "status %d", (int)status);
    for (int a = 0; a < 3; a++) {
        *axis(&offset, a) = kind == ET_FRAME_NONE ? 0.0 : *axis(&lo, a);
        *axis(&scale, a) = kind == ET_FRAME_NONE ? 1.0 : kind == ET_FRAME_UNIFORM ? longest : sides[a] > 0.0 ? sides[a] : 1.0;
        ok = ok && gen_check(g, *axis(&f.offset, a) == *axis(&offset, a) && *axis(&f.scale, a) == *axis(&scale, a), "axis %d: offset %a scale %a", a,
                             *axis(&f.offset, a), *axis(&f.scale, a));
    }
    return ok ? PASS : FAIL;
}

verdict prop_frame_of_refuses(gen *g)
{
    et_vec3 p[MOST];
    et_frame f, old;
    size_t n = draw_cloud(g, p), at = (size_t)gen_upto(g, n - 1);
    int kind = (int)gen_upto(g, 2), a = (int)gen_upto(g, 2);
    et_status want = ET_EFORMAT;
    memset(&f, 0x2b, sizeof f);
    old = f;
    switch (gen_upto(g, 4)) {
    case 0:
        n = 0;
        break;
    case 1:
        *axis(&p[at], a) = gen_upto(g, 1) ? NAN : -HUGE_VAL;
        break;
    case 2:
        n = n > 1 ? n : 2;
        p[0] = p[1] = (et_vec3){1.0, 2.0, 3.0};
        *axis(&p[0], a) = -0.6 * DBL_MAX;
        *axis(&p[1], a) = 0.6 * DBL_MAX;
        break;
    case 3:
        for (size_t i = 0; i < n; i++) {
            p[i] = p[0];
        }
        break;
    default:
        kind = 3;
        want = ET_EINVAL;
    }
    et_status status = et_frame_of(&f, p, n, (et_frame_kind)kind);
    return gen_check(g, status == want && memcmp(&f, &old, sizeof f) == 0, "status %d for %d", (int)status, (int)want) ? PASS : FAIL;
}

verdict prop_frame_to_unit(gen *g)
{
    et_vec3 p[MOST], q[MOST], lo, hi;
    et_frame f;
    et_frame_kind kind = (et_frame_kind)gen_upto(g, 2);
    size_t n = draw_cloud(g, p);
    if (et_frame_of(&f, p, n, kind) != ET_OK) {
        return SKIP;
    }
    memcpy(q, p, sizeof q);
    et_frame_to_unit(q, n, &f);
    bounds(&lo, &hi, p, n);
    if (kind == ET_FRAME_NONE) {
        return gen_check(g, memcmp(p, q, n * sizeof *p) == 0, "the identity changes bits") ? PASS : FAIL;
    }
    for (size_t i = 0; i < n; i++) {
        for (int a = 0; a < 3; a++) {
            double x = *axis(&p[i], a), y = *axis(&q[i], a), least = *axis(&lo, a), most = *axis(&hi, a), s = *axis(&f.scale, a);
            bool end = kind == ET_FRAME_BOX && most > least;
            bool ok = gen_check(g, y >= 0.0 && y <= 1.0, "axis %d: %a outside [0,1]", a, y);
            ok = ok && gen_check(g, x != least || y == 0.0, "the minimum becomes %a", y);
            ok = ok && gen_check(g, !end || x != most || y == 1.0, "the maximum becomes %a", y);
            /* y s = (x - least)(1 + e), |e| <= 2u + u^2, and the product here rounds once more, as does the difference. */
            ok = ok && gen_check(g, fabs(y * s - (x - least)) <= 4.01 * ET_UNIT * (x - least) + 0x1p-1074 * s + DBL_MIN, "axis %d: %a becomes %a", a, x, y);
            if (!ok) {
                return FAIL;
            }
        }
    }
    return PASS;
}

verdict prop_frame_from_unit(gen *g)
{
    et_vec3 p[MOST], q[MOST];
    et_frame f;
    et_frame_kind kind = (et_frame_kind)gen_upto(g, 2);
    size_t n = draw_cloud(g, p);
    if (et_frame_of(&f, p, n, kind) != ET_OK) {
        return SKIP;
    }
    memcpy(q, p, sizeof q);
    et_frame_to_unit(q, n, &f);
    et_frame_from_unit(q, n, &f);
    if (kind == ET_FRAME_NONE) {
        return gen_check(g, memcmp(p, q, n * sizeof *p) == 0, "the identity changes bits") ? PASS : FAIL;
    }
    for (size_t i = 0; i < n; i++) {
        for (int a = 0; a < 3; a++) {
            double x = *axis(&p[i], a), back = *axis(&q[i], a), s = *axis(&f.scale, a), o = *axis(&f.offset, a);
            double bound = 3.01 * ET_UNIT * s + ET_UNIT * fabs(back) + 0x1p-1074 * s + DBL_MIN;
            bool ok = gen_check(g, fabs(back - x) <= bound, "axis %d: %a comes back as %a", a, x, back);
            ok = ok && gen_check(g, x != o || back == o, "the offset %a comes back as %a", o, back);
            if (!ok) {
                return FAIL;
            }
        }
    }
    et_vec3 one = {1.0, 1.0, 1.0};
    et_frame_from_unit(&one, 1, &f);
    return gen_check(g, one.x == f.offset.x + f.scale.x && one.y == f.offset.y + f.scale.y && one.z == f.offset.z + f.scale.z, "1 becomes %a", one.x)
               ? PASS
               : FAIL;
}

/* kind, then the points; wanted: status, offset, scale. */
verdict gold_frame_of(const row *r)
{
    et_vec3 p[MOST];
    et_frame f = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    size_t n = (r->nargs - 1) / 3;
    for (size_t i = 0; i < n && i < MOST; i++) {
        p[i] = (et_vec3){row_real(r, 3 * i + 1), row_real(r, 3 * i + 2), row_real(r, 3 * i + 3)};
    }
    et_status status = et_frame_of(&f, p, n, (et_frame_kind)row_size(r, 0));
    bool ok = row_is_size(r, 0, (size_t)status);
    for (int a = 0; ok && a < 3; a++) {
        ok = row_is(r, (size_t)(1 + a), *axis(&f.offset, a)) && row_is(r, (size_t)(4 + a), *axis(&f.scale, a));
    }
    return ok ? PASS : FAIL;
}

/* offset, scale, coordinate; wanted: the coordinate on the other side, the same on each axis. */
static verdict one_way(const row *r, void (*map)(et_vec3 *, size_t, const et_frame *))
{
    double o = row_real(r, 0), s = row_real(r, 1), x = row_real(r, 2);
    bool ok = true;
    for (int a = 0; ok && a < 3; a++) {
        et_frame f = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
        et_vec3 p = {0.25, 0.5, 0.75}, q = p;
        *axis(&f.offset, a) = o;
        *axis(&f.scale, a) = s;
        *axis(&p, a) = x;
        *axis(&q, a) = x;
        map(&p, 1, &f);
        ok = row_is(r, 0, *axis(&p, a));
        *axis(&p, a) = x;
        ok = ok && memcmp(&p, &q, sizeof p) == 0;
    }
    return ok ? PASS : FAIL;
}

verdict gold_frame_to_unit(const row *r)
{
    return one_way(r, et_frame_to_unit);
}

verdict gold_frame_from_unit(const row *r)
{
    return one_way(r, et_frame_from_unit);
}
