#include "etalon/base/real.h"
#include "etalon/som/quality.h"
#include "gen.h"
#include "golden.h"
#include <math.h>
#include <string.h>

enum { SIDE = 9, CLASSES = 2 * SIDE * SIDE, POINTS = 8200, FEW = 40, BLOCK = 4096 };

typedef struct {
    et_doublenet net;
    size_t nov, n;
    et_vec3 weights[CLASSES], cloud[POINTS];
} job;

static double square(et_vec3 a, et_vec3 b)
{
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;

    return x * x + y * y + z * z;
}

static size_t apart(size_t a, size_t b)
{
    return a > b ? a - b : b - a;
}

/* All classes for all points, each point's two winners by sorting them to the front. */
static et_som_quality brute(const job *j)
{
    static double error[POINTS];
    double block[POINTS / BLOCK + 1] = {0};
    size_t blocks = 0;
    et_som_quality q = {0, 0, INFINITY, 0, j->n};

    for (size_t s = 0; s < j->n; s++) {
        size_t a = 0, b = 1;

        if (square(j->cloud[s], j->weights[1]) < square(j->cloud[s], j->weights[0])) {
            a = 1;
            b = 0;
        }
        for (size_t c = 2; c < j->nov; c++) {
            const double d = square(j->cloud[s], j->weights[c]), db = square(j->cloud[s], j->weights[b]);

            if (d < square(j->cloud[s], j->weights[a])) {
                b = a;
                a = c;
            } else if (d < db)
                b = c;
        }
        if (b > a) /* of classes as near as b the lowest but a */
            for (size_t c = b; c-- > 0;)
                b = c != a && square(j->cloud[s], j->weights[c]) == square(j->cloud[s], j->weights[b]) ? c : b;
        const et_index v = et_doublenet_index(j->net, a + 1), w = et_doublenet_index(j->net, b + 1);
        error[s] = sqrt(square(j->cloud[s], j->weights[a]));
        q.te += apart(v.i, w.i) + apart(v.j, w.j) > 1 || apart(v.k, w.k) > 1;
        q.min_error = fmin(q.min_error, error[s]);
        q.max_error = fmax(q.max_error, error[s]);
    }
    for (size_t s = 0; s < j->n; s += BLOCK)
        block[blocks++] = et_real_sum(error + s, j->n - s < BLOCK ? j->n - s : BLOCK);
    q.qe = et_real_sum(block, blocks) / (double)j->n;
    q.te /= (double)j->n;
    return q;
}

static void fill(et_vec3 *p, size_t n, uint64_t kind, et_rng *rng)
{
    for (size_t k = 0; k < 3 * n; k++)
        (&p[0].x)[k] = kind == 0 ? 0 : kind == 1 ? (double)et_rng_index(rng, 3) / 2 : et_rng_uniform(rng);
}

static bool any_job(gen *g, job *j)
{
    et_rng *rng;

    j->net = (et_doublenet){gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)};
    if (gen_chance(g, 16))
        j->net = gen_chance(g, 2) ? (et_doublenet){2, 50} : (et_doublenet){50, 2};
    j->n = gen_between(g, 1, FEW);
    if (gen_chance(g, 20)) { /* more than one block, on the least net */
        static const size_t edges[] = {BLOCK - 1, BLOCK, 2 * BLOCK - 1, 2 * BLOCK};
        j->n = gen_upto(g, 1) ? edges[gen_upto(g, 3)] : gen_between(g, BLOCK - 1, POINTS);
        j->net = (et_doublenet){2, 2};
        gen_label(g, "several blocks");
    }
    j->nov = et_doublenet_nov(j->net);
    if (et_rng_new(&rng, gen_upto(g, UINT32_MAX)))
        return false;
    fill(j->weights, j->nov, gen_upto(g, 2), rng);
    if (j->n <= FEW && gen_chance(g, 2))
        gen_points(g, &j->cloud[0].x, j->n);
    else
        fill(j->cloud, j->n, gen_upto(g, 2), rng);
    et_rng_free(rng);
    return true;
}

static bool same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

verdict prop_quality_of(gen *g);
verdict prop_quality_of(gen *g)
{
    static job j, before;
    et_som_quality q, want;

    if (!any_job(g, &j))
        return FAIL;
    before = j;
    want = brute(&j);
    if (!gen_check(g, et_quality_of(&q, j.weights, j.nov, j.net, j.cloud, j.n) == ET_OK, "computed"))
        return FAIL;
    if (!gen_check(g, memcmp(&j, &before, sizeof j) == 0, "nothing else is written"))
        return FAIL;
    if (!gen_check(g, same(q.te, want.te) && q.steps == want.steps, "%zu x %zu: te %a is %a", j.net.nx, j.net.ny, q.te, want.te))
        return FAIL;
    return gen_check(g, same(q.qe, want.qe) && same(q.min_error, want.min_error) && same(q.max_error, want.max_error), "qe %a is %a", q.qe, want.qe)
               ? PASS
               : FAIL;
}

/* Each weight asked for itself: no error at all, and each class is its own winner. */
verdict prop_quality_of_itself(gen *g);
verdict prop_quality_of_itself(gen *g)
{
    static job j;
    et_som_quality q;

    if (!any_job(g, &j))
        return FAIL;
    if (!gen_check(g, et_quality_of(&q, j.weights, j.nov, j.net, j.weights, j.nov) == ET_OK && q.steps == j.nov, "computed"))
        return FAIL;
    return gen_check(g, q.qe == 0 && q.min_error == 0 && q.max_error == 0 && 0 <= q.te && q.te <= 1, "qe %a, te %a", q.qe, q.te) ? PASS : FAIL;
}

verdict prop_quality_of_refuses(gen *g);
verdict prop_quality_of_refuses(gen *g)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, 0x1.0000000000001p500, -0x1.0000000000001p500};
    static job j;
    et_som_quality q = {1, 2, 3, 4, 5};
    const uint64_t what = gen_upto(g, 4);

    if (!any_job(g, &j))
        return FAIL;
    if (what == 0)
        j.net.ny = gen_upto(g, 1);
    else if (what == 1)
        j.nov += gen_chance(g, 2) ? 1 : SIZE_MAX;
    else if (what == 2)
        j.n = 0;
    else if (what == 3)
        (&j.weights[0].x)[gen_upto(g, 3 * j.nov - 1)] = bad[gen_upto(g, 4)];
    else
        (&j.cloud[0].x)[gen_upto(g, 3 * j.n - 1)] = bad[gen_upto(g, 4)];
    if (!gen_check(g, et_quality_of(&q, j.weights, j.nov, j.net, j.cloud, j.n) == ET_EINVAL, "refused"))
        return FAIL;
    return gen_check(g, q.qe == 1 && q.te == 2 && q.min_error == 3 && q.max_error == 4 && q.steps == 5, "quality as before") ? PASS : FAIL;
}

/* nx ny, NOV weights, points -> qe te least greatest */
verdict gold_quality_of(const row *r);
verdict gold_quality_of(const row *r)
{
    static job j;
    et_som_quality q;
    bool ok;

    j.net = (et_doublenet){row_size(r, 0), row_size(r, 1)};
    j.nov = et_doublenet_nov(j.net);
    j.n = (r->nargs - 2) / 3 - j.nov;
    for (size_t k = 0; k < 3 * j.nov; k++)
        (&j.weights[0].x)[k] = row_real(r, 2 + k);
    for (size_t k = 0; k < 3 * j.n; k++)
        (&j.cloud[0].x)[k] = row_real(r, 2 + 3 * j.nov + k);
    ok = et_quality_of(&q, j.weights, j.nov, j.net, j.cloud, j.n) == ET_OK && q.steps == j.n;
    ok = row_is(r, 0, q.qe) && ok;
    ok = row_is(r, 1, q.te) && ok;
    ok = row_is(r, 2, q.min_error) && ok;
    return row_is(r, 3, q.max_error) && ok ? PASS : FAIL;
}
