#include "etalon/base/real.h"
#include "etalon/io/primitive.h"
#include "etalon/som/som.h"
#include "gen.h"
#include "golden.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { CUBE = 12, RINGS = 40, SIDES = 24, MOST = RINGS * SIDES + 2 };

static const char *const names[] = {"cube", "sphere", "spindle", "oiltank"};
static const size_t least_rings[] = {2, 1, 4, 2};

verdict prop_primitive_name(gen *g);
verdict prop_primitive_name(gen *g)
{
    const size_t k = gen_upto(g, 6);
    const char *name = et_primitive_name((et_primitive_kind)k);

    if (k > 3)
        return gen_check(g, name == NULL, "no kind %zu", k) ? PASS : FAIL;
    return gen_check(g, name && strcmp(name, names[k]) == 0, "kind %zu is %s", k, names[k]) ? PASS : FAIL;
}

static size_t count_cube(size_t n)
{
    size_t count = 0;

    for (size_t x = 0; x < n; x++)
        for (size_t y = 0; y < n; y++)
            for (size_t z = 0; z < n; z++)
                count += x == 0 || y == 0 || z == 0 || x == n - 1 || y == n - 1 || z == n - 1;
    return count;
}

verdict prop_primitive_count(gen *g);
verdict prop_primitive_count(gen *g)
{
    static const size_t source[] = {7352, 7082, 7552, 5942}, huge[] = {SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 3 + 1};
    const size_t kind = gen_upto(g, 4), a = gen_upto(g, CUBE), b = gen_upto(g, 8), big = huge[gen_upto(g, 2)];
    const bool cube = kind == ET_PRIMITIVE_CUBE, by_default = a == 0 && (b == 0 || cube);
    const bool sound = kind < 4 && (by_default || (a >= least_rings[kind] && (cube || b >= 3)));
    const size_t want = by_default && kind < 4 ? source[kind] : cube ? count_cube(a) : a * b + 2;
    size_t n = 77;
    et_status status = et_primitive_count(&n, (et_primitive_kind)kind, a, b);

    if (!gen_check(g, status == (sound ? ET_OK : ET_EINVAL) && n == (sound ? want : 77), "kind %zu, %zu, %zu: %zu points, got %zu", kind, a, b, want,
                   n))
        return FAIL;
    n = 77;
    status = et_primitive_count(&n, (et_primitive_kind)(kind % 4), big, 3);
    if (!gen_check(g, (status == ET_ENOMEM) == (cube || kind == 4 || big > (SIZE_MAX - 2) / 3) && (status || n == 3 * big + 2), "%zu overflow", big))
        return FAIL;
    if (!gen_check(g, status == ET_OK || n == 77, "unchanged"))
        return FAIL;
    status = et_primitive_count(&n, ET_PRIMITIVE_SPHERE, 1, SIZE_MAX - 2);
    return gen_check(g, status == ET_OK && n == SIZE_MAX && et_primitive_count(&n, ET_PRIMITIVE_SPHERE, 1, SIZE_MAX - 1) == ET_ENOMEM,
                     "the greatest count")
               ? PASS
               : FAIL;
}

/* Lattice line i of n: the least whole number of 1e-5 not below i/(n-1). */
static double line(size_t i, size_t n)
{
    size_t m = i * 100000 / (n - 1);

    while (m * (n - 1) < i * 100000)
        m++;
    return (double)m / 100000;
}

static size_t expect_cube(et_vec3 *p, size_t n)
{
    static const size_t turn[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    bool seen[CUBE][CUBE] = {{false}};
    size_t at = 0;

    for (size_t r = 0; r + 1 < n; r++)
        for (size_t c = 0; c + 1 < n; c++)
            for (size_t k = 0; k < 4; k++) {
                bool *s = &seen[c + turn[k][0]][r + turn[k][1]];

                if (!*s)
                    p[at++] = (et_vec3){line(c + turn[k][0], n), 0, line(n - 1 - (r + turn[k][1]), n)};
                *s = true;
            }
    for (size_t y = 1; y < n; y++)
        for (size_t r = 0; r < n; r++)
            for (size_t x = 0; x < n; x++)
                if (y == n - 1 || r == 0 || r == n - 1 || x == 0 || x == n - 1)
                    p[at++] = (et_vec3){line(x, n), line(y, n), line(n - 1 - r, n)};
    return at;
}

/* Rings of a cap: the number nearest to the source's share, the greater of two equally near, at least 1. */
static size_t cap_rings(size_t a, size_t cap, size_t whole)
{
    size_t best = 1;

    for (size_t c = 2; 2 * c <= a; c++) {
        const double off = fabs((double)(c * whole) - (double)(a * cap)), old = fabs((double)(best * whole) - (double)(a * cap));

        best = off <= old ? c : best;
    }
    return best;
}

/* Radius and height of ring k < a from the top, in the source's lengths; rings below the middle mirror those above. */
static void expect_ring(double *r, double *y, size_t kind, size_t k, size_t a)
{
    const double angle = acos(-1) * (double)(k + 1) / (double)(a + 1), half = asin(0.8);
    const size_t up = 2 * k + 1 > a ? a - 1 - k : k, spindle_cap = kind == 2 ? cap_rings(a - 2, 50, 149) : 0,
                 tank_cap = kind == 3 ? cap_rings(a, 20, 99) : 0;
    const size_t cap = kind == 2 ? spindle_cap + 1 : tank_cap, side = a - 2 * cap, past = up + 1 - (up < cap ? up + 1 : cap);
    const double down = (double)past / (double)(side + 1);

    if (kind == 1) {
        *r = 10 * sin(angle);
        *y = 10 * cos(angle);
        return;
    }
    if (up >= cap) {
        *r = kind == 2 ? 30 : 10;
        *y = (kind == 2 ? 15 : 7.45) * (1 - 2 * down);
    } else if (kind == 2) {
        *r = 0.01 + (30 - 0.01) * (double)up / (double)spindle_cap;
        *y = 30 - 60 * 0.25 * (double)up / (double)spindle_cap;
    } else {
        *r = 12.5 * sin(half * (double)(up + 1) / (double)tank_cap);
        *y = 24.9 / 2 - 12.5 + 12.5 * cos(half * (double)(up + 1) / (double)tank_cap);
    }
    *y = up == k ? *y : -*y;
}

static void expect_rings(et_vec3 *p, size_t kind, size_t a, size_t b)
{
    const double top = kind == 1 ? 10 : kind == 2 ? 30 : 12.45;

    p[0] = (et_vec3){0, top, 0};
    p[a * b + 1] = (et_vec3){0, -top, 0};
    for (size_t k = 0; k < a; k++)
        for (size_t s = 0; s < b; s++) {
            const double f = 2 * acos(-1) * (double)s / (double)b;
            double r, y;

            expect_ring(&r, &y, kind, k, a);
            p[1 + k * b + s] = kind == 1 ? (et_vec3){-r * sin(f), y, -r * cos(f)} : (et_vec3){r * cos(f), y, -r * sin(f)};
        }
}

static bool in_cube(gen *g, const et_vec3 *p, size_t n)
{
    for (size_t k = 0; k < 3; k++) {
        double lo = 2, hi = -1;

        for (size_t i = 0; i < n; i++) {
            lo = fmin(lo, (&p[i].x)[k]);
            hi = fmax(hi, (&p[i].x)[k]);
        }
        if (!gen_check(g, lo == 0 && hi == 1, "axis %zu reaches from %a to %a", k, lo, hi))
            return false;
    }
    return true;
}

/* A coordinate was rounded by at most 0.7e-4 and so were the ends of its axis: the normalised one is off by at most three times that over the extent
 * (1e-9 for the roundings of doubles). */
static bool near(gen *g, const et_vec3 *p, const et_vec3 *want, size_t n)
{
    for (size_t k = 0; k < 3; k++) {
        double lo = INFINITY, hi = -INFINITY;

        for (size_t i = 0; i < n; i++) {
            lo = fmin(lo, (&want[i].x)[k]);
            hi = fmax(hi, (&want[i].x)[k]);
        }
        for (size_t i = 0; i < n; i++) {
            const double x = (&p[i].x)[k], w = ((&want[i].x)[k] - lo) / (hi - lo), slack = 2.1e-4 / (hi - lo) + 1e-9;

            if (!gen_check(g, fabs(x - w) <= slack, "point %zu, axis %zu: %.9f is %.9f", i, k, x, w))
                return false;
        }
    }
    return true;
}

/* Cube: bit for bit; the others to their rounding (golden rows have their bits). */
verdict prop_primitive_make(gen *g);
verdict prop_primitive_make(gen *g)
{
    static et_vec3 p[MOST + 1], want[MOST];
    const size_t kind = gen_upto(g, 3), a = gen_between(g, least_rings[kind], kind == 0 ? CUBE : RINGS), b = gen_between(g, 3, SIDES);
    size_t n = 0;

    if (!gen_check(g, et_primitive_count(&n, (et_primitive_kind)kind, a, b) == ET_OK && n <= MOST, "counted"))
        return FAIL;
    p[0].x = p[n].x = 77;
    if (!gen_check(g, et_primitive_make(p, n - 1, (et_primitive_kind)kind, a, b) == ET_EINVAL, "one too few") ||
        !gen_check(g, et_primitive_make(p, n + 1, (et_primitive_kind)kind, a, b) == ET_EINVAL && p[0].x == 77, "one too many"))
        return FAIL;
    if (!gen_check(g, et_primitive_make(p, n, (et_primitive_kind)kind, a, b) == ET_OK && p[n].x == 77, "made") || !in_cube(g, p, n))
        return FAIL;
    if (kind != 0) {
        expect_rings(want, kind, a, b);
        return near(g, p, want, n) ? PASS : FAIL;
    }
    if (!gen_check(g, expect_cube(want, a) == n, "the test's own cube"))
        return FAIL;
    for (size_t i = 0; i < n; i++)
        if (!gen_check(g, p[i].x == want[i].x && p[i].y == want[i].y && p[i].z == want[i].z, "point %zu", i))
            return FAIL;
    return PASS;
}

/* a = b = 0 is the source's resolution, its points all different. */
static bool source_cloud(gen *g, et_primitive_kind kind)
{
    static const size_t size[][2] = {{36, 99}, {59, 120}, {151, 50}, {99, 60}};
    static et_vec3 p[7552], q[7552];
    size_t n = 0;
    bool ok = et_primitive_count(&n, kind, 0, 0) == ET_OK && et_primitive_make(p, n, kind, 0, 0) == ET_OK && in_cube(g, p, n);

    ok = ok && et_primitive_make(q, n, kind, size[kind][0], size[kind][1]) == ET_OK && memcmp(p, q, n * sizeof *p) == 0;
    for (size_t i = 1; ok && i < n; i++)
        ok = memcmp(&p[i], &p[i - 1], sizeof *p) != 0;
    return gen_check(g, ok, "the source's %s", names[kind]);
}

verdict prop_primitive_make_source(gen *g);
/* One case in 3. */
verdict prop_primitive_make_source(gen *g)
{
    const size_t kind = gen_upto(g, 3);
    et_vec3 p[4] = {{77, 0, 0}};

    if (!gen_check(g,
                   et_primitive_make(p, 4, ET_PRIMITIVE_SPHERE, 0, 4) == ET_EINVAL &&
                       et_primitive_make(p, 4, (et_primitive_kind)4, 0, 0) == ET_EINVAL &&
                       et_primitive_make(p, 4, ET_PRIMITIVE_CUBE, 1, 0) == ET_EINVAL && p[0].x == 77,
                   "refused"))
        return FAIL;
    return source_cloud(g, (et_primitive_kind)kind) ? PASS : FAIL;
}

/* The same draws in plain steps. */
static void expect_disturbed(et_vec3 *p, size_t n, double sigma, size_t chosen, bool *hit, et_rng *rng)
{
    size_t left[MOST];

    for (size_t k = 0; sigma > 0 && k < 3 * n; k++)
        (&p[0].x)[k] += sigma * et_rng_normal(rng);
    for (size_t i = 0; i < n; i++)
        left[i] = i;
    for (size_t k = 0; k < chosen; k++) {
        const size_t j = k + et_rng_index(rng, n - k), i = left[j];

        left[j] = left[k];
        left[k] = i;
        hit[i] = true;
    }
    for (size_t k = 0; k < 3 * chosen; k++)
        (&p[left[k / 3]].x)[k % 3] = -0.1 + 1.2 * et_rng_uniform(rng);
}

verdict prop_primitive_disturb(gen *g);
verdict prop_primitive_disturb(gen *g)
{
    static const double sigmas[] = {0, 0.01, 1, 0x1p-1070};
    et_vec3 p[61], want[61], old[61];
    bool hit[60] = {false};
    const size_t n = gen_upto(g, 60);
    const double sigma = sigmas[gen_upto(g, 3)], fraction = gen_real(g, 0, 1);
    const size_t chosen = (size_t)floor(fraction * (double)n + 0.5);
    et_rng *a, *b;
    const uint64_t seed = gen_upto(g, UINT32_MAX);
    size_t changed = 0, hits = 0;
    bool ok;

    memset(p, 0, sizeof p);
    gen_points(g, &p[0].x, n);
    memcpy(old, p, sizeof p);
    memcpy(want, p, sizeof p);
    if (et_rng_new(&a, seed))
        return FAIL;
    if (et_rng_new(&b, seed)) {
        et_rng_free(a);
        return FAIL;
    }
    expect_disturbed(want, n, sigma, chosen, hit, b);
    ok = gen_check(g, et_primitive_disturb(p, n, sigma, fraction, a) == ET_OK, "disturbed") &&
         gen_check(g, memcmp(p, want, sizeof p) == 0, "by the draws in their order") &&
         gen_check(g, et_rng_tell(a) == et_rng_tell(b), "as many draws");
    for (size_t i = 0; ok && i < n; i++) {
        hits += hit[i];
        changed += memcmp(&p[i], &old[i], sizeof p[i]) != 0;
        for (size_t k = 0; ok && k < 3 && hit[i]; k++)
            ok = gen_check(g, -0.1 <= (&p[i].x)[k] && (&p[i].x)[k] <= 1.1, "outlier %zu in its box", i);
    }
    ok = ok && gen_check(g, hits == chosen && (sigma > 0 || changed <= chosen), "%zu points replaced", chosen);
    et_rng_free(a);
    et_rng_free(b);
    return ok ? PASS : FAIL;
}

verdict prop_primitive_disturb_refuses(gen *g);
verdict prop_primitive_disturb_refuses(gen *g)
{
    static const double bad[] = {-DBL_MIN, -1, INFINITY, NAN, 0x1.0000000000001p0};
    et_vec3 p[3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const double x = bad[gen_upto(g, 3)], y = bad[gen_upto(g, 4)];
    const bool first = gen_chance(g, 2);
    et_rng *rng;
    bool ok;

    if (et_rng_new(&rng, 1))
        return FAIL;
    ok = et_primitive_disturb(p, 3, first ? x : 0.5, first ? 0.5 : y, rng) == ET_EINVAL && et_rng_tell(rng) == 0;
    for (size_t k = 0; k < 9; k++)
        ok = ok && (&p[0].x)[k] == (double)(k + 1);
    et_rng_free(rng);
    return gen_check(g, ok, "refused, nothing changed, nothing drawn") ? PASS : FAIL;
}

typedef struct {
    double qe, te;
} figures;

static bool train_ten(figures *mean, et_primitive_kind kind, et_vec3 *cloud)
{
    const et_doublenet net = {10, 10};
    const et_som_options o = et_som_defaults();
    et_vec3 w[164];
    size_t n;
    bool ok = et_primitive_count(&n, kind, 0, 0) == ET_OK && et_primitive_make(cloud, n, kind, 0, 0) == ET_OK;

    *mean = (figures){0, 0};
    for (uint64_t k = 0; ok && k < 10; k++) {
        et_som_quality q = {0};
        et_rng *rng;

        if (et_rng_new(&rng, et_rng_stream(1, k)))
            return false;
        et_som_start(w, 164, rng);
        ok = et_som_train(w, 164, &q, net, cloud, n, &o, rng, NULL) == ET_OK;
        et_rng_free(rng);
        mean->qe += q.qe / 10;
        mean->te += q.te / 10;
    }
    return ok;
}

/* You 2023, Appendix B, 10 x 10: quantisation error within 2 %, topographic error within 0.02, mean of ten seeds.  Trained once a process. */
verdict prop_som_train_published(gen *g);
verdict prop_som_train_published(gen *g)
{
    static const figures printed[2] = {{0.138079, 0.218967}, {0.098825, 0.235833}};
    static et_vec3 cloud[7352];
    static figures ours[2];
    static int state; /* 0 not yet, 1 trained, 2 failed */
    const size_t k = gen_upto(g, 1);

    if (state == 0)
        state = train_ten(&ours[0], ET_PRIMITIVE_CUBE, cloud) && train_ten(&ours[1], ET_PRIMITIVE_SPHERE, cloud) ? 1 : 2;
    return gen_check(g, state == 1 && fabs(ours[k].qe / printed[k].qe - 1) <= 0.02 && fabs(ours[k].te - printed[k].te) <= 0.02,
                     "%s: %f, %f printed %f, %f", names[k], ours[k].qe, ours[k].te, printed[k].qe, printed[k].te)
               ? PASS
               : FAIL;
}

static et_primitive_kind row_kind(const row *r)
{
    size_t k = 0;

    while (k < 4 && (r->nargs == 0 || strcmp(r->arg[0], names[k]) != 0))
        k++;
    return (et_primitive_kind)k;
}

/* number -> name */
verdict gold_primitive_name(const row *r);
verdict gold_primitive_name(const row *r)
{
    const char *name = et_primitive_name((et_primitive_kind)row_size(r, 0));

    return r->nwant == 1 && strcmp(r->want[0], name ? name : "null") == 0 ? PASS : FAIL;
}

/* kind a b -> count */
verdict gold_primitive_count(const row *r);
verdict gold_primitive_count(const row *r)
{
    size_t n = 0;

    return et_primitive_count(&n, row_kind(r), row_size(r, 1), row_size(r, 2)) == ET_OK && row_is_size(r, 0, n) ? PASS : FAIL;
}

/* kind a b, index of a point -> x y z */
verdict gold_primitive_make(const row *r);
verdict gold_primitive_make(const row *r)
{
    static et_vec3 p[7552];
    size_t n = 0;
    const size_t at = row_size(r, 3);
    bool ok = et_primitive_count(&n, row_kind(r), row_size(r, 1), row_size(r, 2)) == ET_OK && n <= 7552 && at < n &&
              et_primitive_make(p, n, row_kind(r), row_size(r, 1), row_size(r, 2)) == ET_OK;

    for (size_t k = 0; k < 3; k++)
        ok = ok && row_is(r, k, (&p[at].x)[k]);
    return ok ? PASS : FAIL;
}
