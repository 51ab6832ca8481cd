#include "etalon/io/primitive.h"
#include "etalon/base/frame.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* Points are first laid out in whole units of the source's rounding (1e-4; the cube 1e-5), kept as doubles without a fraction: the
 * normalisation then subtracts exactly and divides once, so that every coordinate is the correctly rounded quotient of two integers. */

static const double pi = 0x1.921fb54442d18p+1;
static const double tank_angle = 0x1.dac670561bb4fp-1; /* asin(4/5): half the cap's angle, radius 10 on a sphere of 12.5 */

/* Rings of one cap (its rim included) and of the side between the rims. */
typedef struct {
    size_t cap, side;
} rings;

/* A point of the profile: distance from the axis, and height. */
typedef struct {
    double r, y;
} profile;

const char *et_primitive_name(et_primitive_kind kind)
{
    static const char *const name[] = {"cube", "sphere", "spindle", "oiltank"};

    return (size_t)kind < sizeof name / sizeof *name ? name[kind] : NULL;
}

/* To whole units of 1e-4: halves upwards, after adding the bias f. */
static double units(double v, double f)
{
    return floor(1e4 * v + f + 0.5);
}

/* The source's resolution for a = b = 0. */
static void source_size(et_primitive_kind kind, size_t *a, size_t *b)
{
    static const size_t size[][2] = {{36, 0}, {59, 120}, {151, 50}, {99, 60}};

    if (*a == 0 && (*b == 0 || kind == ET_PRIMITIVE_CUBE)) {
        *a = size[kind][0];
        *b = size[kind][1];
    }
}

et_status et_primitive_count(size_t *count, et_primitive_kind kind, size_t a, size_t b)
{
    static const size_t least[] = {2, 1, 4, 2};
    size_t n;

    if (!et_primitive_name(kind))
        return ET_EINVAL;
    source_size(kind, &a, &b);
    if (a < least[kind] || (kind != ET_PRIMITIVE_CUBE && b < 3))
        return ET_EINVAL;
    if (kind == ET_PRIMITIVE_CUBE ? et_size_mul(&n, a - 1, a - 1) || et_size_mul(&n, n, 6) : et_size_mul(&n, a, b))
        return ET_ENOMEM;
    if (n > SIZE_MAX - 2)
        return ET_ENOMEM;
    *count = n + 2;
    return ET_OK;
}

/* Lattice point i of n in units of 1e-5, rounded up. */
static double lattice(size_t i, size_t n)
{
    return (double)(((uint64_t)i * 100000 + n - 2) / (n - 1));
}

/* The face y = 0 in quads, from z = 1 downwards, each point where the quads name it first; then the layers y > 0, row by row. */
static void make_cube(et_vec3 *point, size_t n)
{
    const size_t corner[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};

    for (size_t r = 0; r + 1 < n; r++)
        for (size_t c = 0; c + 1 < n; c++)
            for (size_t k = 0; k < 4; k++) {
                const size_t dc = corner[k][0], dr = corner[k][1];

                if ((c == 0 || dc == 1) && (r == 0 || dr == 1))
                    *point++ = (et_vec3){lattice(c + dc, n), 0, lattice(n - 1 - (r + dr), n)};
            }
    for (size_t y = 1; y < n; y++)
        for (size_t r = 0; r < n; r++) {
            const size_t step = y == n - 1 || r == 0 || r == n - 1 ? 1 : n - 1;

            for (size_t c = 0; c < n; c += step)
                *point++ = (et_vec3){lattice(c, n), lattice(y, n), lattice(n - 1 - r, n)};
        }
}

static void make_sphere(et_vec3 *point, size_t a, size_t b)
{
    *point++ = (et_vec3){0, units(10, 0), 0};
    for (size_t r = 1; r <= a; r++) {
        const double theta = pi * (double)r / (double)(a + 1), radius = 10 * et_real_sin(theta), y = units(10 * et_real_cos(theta), 0);

        for (size_t s = 0; s < b; s++) {
            const double phi = 2 * pi * (double)s / (double)b;

            *point++ = (et_vec3){units(-radius * et_real_sin(phi), 0), y, units(-radius * et_real_cos(phi), -0.2)};
        }
    }
    *point = (et_vec3){0, units(-10, 0), 0};
}

/* a rings of a solid with two caps, in the proportions of the source: the nearest whole number to a*cap/(2*cap + side), at least 1. */
static rings divide(size_t a, size_t cap, size_t side)
{
    const double share = floor((double)a * (double)cap / (double)(2 * cap + side) + 0.5);
    rings d;

    d.cap = share < 1 ? 1 : (size_t)share;
    d.side = a - 2 * d.cap;
    return d;
}

static profile spindle_cap(size_t i, size_t cap)
{
    return (profile){0.01 + 29.99 * (double)i / (double)cap, 30 - 15 * (double)i / (double)cap};
}

static profile tank_cap(size_t i, size_t cap)
{
    const double angle = tank_angle * (double)i / (double)cap;

    return (profile){12.5 * et_real_sin(angle), 12.45 - 12.5 * (1 - et_real_cos(angle))};
}

/* Ring k of a, from the top: of the cap, of the side, or the mirror of one above.  The spindle's cap begins with the ring at its tip. */
static profile ring(et_primitive_kind kind, size_t k, size_t a)
{
    const size_t tip = kind == ET_PRIMITIVE_SPINDLE ? 1 : 0;
    const rings d = kind == ET_PRIMITIVE_SPINDLE ? divide(a - 2, 50, 49) : divide(a, 20, 59);
    const size_t top = tip + d.cap;
    const size_t mirrored = k < top ? k : a - 1 - k;
    profile p;

    if (k >= top && k < top + d.side) {
        const double along = (double)(k - top + 1) / (double)(d.side + 1);

        return kind == ET_PRIMITIVE_SPINDLE ? (profile){30, 15 - 30 * along} : (profile){10, 7.45 - 14.9 * along};
    }
    p = kind == ET_PRIMITIVE_SPINDLE ? spindle_cap(mirrored, d.cap) : tank_cap(mirrored + 1, d.cap);
    p.y = k < top ? p.y : -p.y;
    return p;
}

static void make_revolved(et_vec3 *point, et_primitive_kind kind, size_t a, size_t b)
{
    const double pole = kind == ET_PRIMITIVE_SPINDLE ? 30 : 12.45;

    *point++ = (et_vec3){0, units(pole, 0), 0};
    for (size_t k = 0; k < a; k++) {
        const profile p = ring(kind, k, a);

        for (size_t s = 0; s < b; s++) {
            const double phi = 2 * pi * (double)s / (double)b;

            *point++ = (et_vec3){units(p.r * et_real_cos(phi), 0), units(p.y, 0), units(-p.r * et_real_sin(phi), 0)};
        }
    }
    *point = (et_vec3){0, units(-pole, 0), 0};
}

et_status et_primitive_make(et_vec3 *points, size_t count, et_primitive_kind kind, size_t a, size_t b)
{
    size_t wanted;
    et_frame frame;
    const et_status status = et_primitive_count(&wanted, kind, a, b);

    if (status)
        return status;
    if (count != wanted)
        return ET_EINVAL;
    source_size(kind, &a, &b);
    if (kind == ET_PRIMITIVE_CUBE)
        make_cube(points, a);
    else if (kind == ET_PRIMITIVE_SPHERE)
        make_sphere(points, a, b);
    else
        make_revolved(points, kind, a, b);
    if (et_frame_of(&frame, points, count, ET_FRAME_BOX))
        return ET_EINTERNAL; /* cannot be: finite, and extended along each axis */
    et_frame_to_unit(points, count, &frame);
    return ET_OK;
}

static void add_noise(et_vec3 *points, size_t count, double sigma, et_rng *rng)
{
    for (size_t i = 0; i < count; i++) {
        points[i].x += sigma * et_rng_normal(rng);
        points[i].y += sigma * et_rng_normal(rng);
        points[i].z += sigma * et_rng_normal(rng);
    }
}

/* Partial Fisher-Yates: the first `chosen` of a random permutation. */
static void choose(size_t *index, size_t count, size_t chosen, et_rng *rng)
{
    for (size_t i = 0; i < count; i++)
        index[i] = i;
    for (size_t k = 0; k < chosen; k++) {
        const size_t other = k + et_rng_index(rng, count - k), kept = index[k];

        index[k] = index[other];
        index[other] = kept;
    }
}

et_status et_primitive_disturb(et_vec3 *points, size_t count, double sigma, double fraction, et_rng *rng)
{
    size_t *index, chosen;

    if (!(sigma >= 0) || !isfinite(sigma) || !(fraction >= 0) || !(fraction <= 1))
        return ET_EINVAL;
    chosen = (size_t)floor(fraction * (double)count + 0.5);
    chosen = chosen < count ? chosen : count;
    index = et_size_array(count, sizeof *index);
    if (!index)
        return ET_ENOMEM;
    if (sigma > 0)
        add_noise(points, count, sigma, rng);
    choose(index, count, chosen, rng);
    for (size_t k = 0; k < chosen; k++) {
        et_vec3 *p = points + index[k];

        p->x = -0.1 + 1.2 * et_rng_uniform(rng);
        p->y = -0.1 + 1.2 * et_rng_uniform(rng);
        p->z = -0.1 + 1.2 * et_rng_uniform(rng);
    }
    free(index);
    return ET_OK;
}
