#include "etalon/base/real.h"
#include "etalon/som/som.h"
#include "gen.h"
#include "golden.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The training loop as one writes it down: every class, every step, nothing tabulated, nothing skipped. */
enum { SIDE = 9, CLASSES = 2 * SIDE * SIDE, POINTS = 24, STEPS = 9000, BLOCK = 4096 };

typedef struct {
    et_doublenet net;
    size_t nov, n;
    et_vec3 weights[CLASSES], cloud[POINTS];
    et_som_options options;
    uint64_t seed;
} job;

static double square(et_vec3 a, et_vec3 b)
{
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;

    return x * x + y * y + z * z;
}

static size_t nearest(const job *j, et_vec3 p, size_t but)
{
    size_t best = but == 0 ? 1 : 0;

    for (size_t c = 0; c < j->nov; c++)
        if (c != but && square(p, j->weights[c]) < square(p, j->weights[best]))
            best = c;
    return best;
}

static size_t apart(size_t a, size_t b)
{
    return a > b ? a - b : b - a;
}

/* sum_b sum_{s in b} error_s, blocks of 4096. */
static double mean(const double *error, size_t n)
{
    double block[STEPS / BLOCK + 1] = {0};
    size_t blocks = 0;

    for (size_t s = 0; s < n; s += BLOCK)
        block[blocks++] = et_real_sum(error + s, n - s < BLOCK ? n - s : BLOCK);
    return et_real_sum(block, blocks) / (double)n;
}

static double radius(const job *j)
{
    const double half = (double)(j->net.nx < j->net.ny ? j->net.nx : j->net.ny) / 2, sigma0 = j->options.sigma0 == 0 ? half : j->options.sigma0;

    return sigma0 < 1 ? 1 : sigma0;
}

static void update(job *j, et_vec3 p, size_t first, size_t t)
{
    const double sigma0 = radius(j), tau = (double)j->options.iterations / et_real_log(sigma0);
    const double shrink = sigma0 > 1 ? et_real_exp(-((double)t / tau)) : 1, alpha = j->options.alpha0 * shrink, sigma = sigma0 * shrink;
    const et_index w = et_doublenet_index(j->net, first + 1);

    for (size_t c = 0; c < j->nov; c++) {
        const et_index v = et_doublenet_index(j->net, c + 1);
        const size_t di = apart(v.i, w.i), dj = apart(v.j, w.j), dk = apart(v.k, w.k);
        const double dist2 = (double)(di * di + dj * dj + dk * dk), f = alpha * et_real_exp(-(dist2 / (2 * (sigma * sigma))));

        if (!(dist2 < sigma * sigma) || dk == 2)
            continue;
        j->weights[c].x += f * (p.x - j->weights[c].x);
        j->weights[c].y += f * (p.y - j->weights[c].y);
        j->weights[c].z += f * (p.z - j->weights[c].z);
    }
}

static et_som_quality reference(job *j, size_t steps, et_rng *rng)
{
    static double error[STEPS];
    et_som_quality q = {0, 0, INFINITY, 0, steps};

    for (size_t t = 1; t <= steps; t++) {
        const et_vec3 p = j->cloud[et_rng_index(rng, j->n)];
        const size_t first = nearest(j, p, SIZE_MAX), second = nearest(j, p, first);
        const et_index a = et_doublenet_index(j->net, first + 1), b = et_doublenet_index(j->net, second + 1);

        error[t - 1] = sqrt(square(p, j->weights[first]));
        q.min_error = fmin(q.min_error, error[t - 1]);
        q.max_error = fmax(q.max_error, error[t - 1]);
        q.te += apart(a.i, b.i) + apart(a.j, b.j) > 1 || apart(a.k, b.k) > 1;
        update(j, p, first, t);
    }
    q.te /= (double)steps;
    q.qe = mean(error, steps);
    return q;
}

static void any_net(gen *g, job *j)
{
    j->net = (et_doublenet){gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)};
    if (gen_chance(g, 16))
        j->net = gen_chance(g, 2) ? (et_doublenet){2, 50} : (et_doublenet){50, 2};
    j->nov = et_doublenet_nov(j->net);
}

/* From all weights equal, by few values (many ties), to uniform ones at any scale the cloud has. */
static void any_weights(gen *g, job *j, et_rng *rng)
{
    static const double scale[] = {1, 0x1p-100, 0x1p100, 0x1p-520, 0x1p499};
    const uint64_t kind = gen_upto(g, 3);
    const double s = scale[gen_chance(g, 4) ? gen_upto(g, 4) : 0];

    memset(j->weights, 0, sizeof j->weights);
    if (kind == 0)
        gen_label(g, "all weights equal");
    else if (kind == 1)
        gen_label(g, "lattice of weights");
    for (size_t c = 0; c < j->nov && kind > 0; c++) {
        double *x = &j->weights[c].x;

        for (size_t k = 0; k < 3; k++)
            x[k] = s * (kind == 1 ? (double)et_rng_index(rng, 3) / 2 : et_rng_uniform(rng));
    }
}

static void any_options(gen *g, job *j, size_t most)
{
    static const double sigma0[] = {0, 0.5, 1, 1.5, 2, 3, 1e300, 0x1.0000000000001p0};
    const uint64_t pick = gen_upto(g, 11);

    j->options = et_som_defaults();
    j->options.iterations = gen_between(g, 1, most);
    j->options.alpha0 = gen_chance(g, 3) ? 1 : gen_chance(g, 2) ? 1 - gen_real(g, 0, 0.99) : 0.9;
    j->options.sigma0 = pick < 8 ? sigma0[pick] : gen_real(g, 0, 12);
}

static bool any_job(gen *g, job *j, size_t most)
{
    et_rng *rng;

    any_net(g, j);
    j->seed = gen_upto(g, UINT32_MAX);
    if (et_rng_new(&rng, j->seed))
        return false;
    j->n = gen_between(g, 1, POINTS);
    gen_points(g, &j->cloud[0].x, j->n);
    any_weights(g, j, rng);
    any_options(g, j, most);
    et_rng_free(rng);
    return true;
}

static bool same_double(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static bool same_quality(gen *g, et_som_quality a, et_som_quality b)
{
    return gen_check(g, same_double(a.qe, b.qe), "qe %a is %a", a.qe, b.qe) && gen_check(g, same_double(a.te, b.te), "te %a is %a", a.te, b.te) &&
           gen_check(g, same_double(a.min_error, b.min_error), "min %a is %a", a.min_error, b.min_error) &&
           gen_check(g, same_double(a.max_error, b.max_error), "max %a is %a", a.max_error, b.max_error) &&
           gen_check(g, a.steps == b.steps, "%zu steps are %zu", a.steps, b.steps);
}

static bool same_weights(gen *g, const job *a, const job *b)
{
    for (size_t c = 0; c < a->nov; c++)
        if (!gen_check(g, memcmp(&a->weights[c], &b->weights[c], sizeof a->weights[c]) == 0, "class %zu of %zu x %zu: x %a is %a", c + 1, a->net.nx,
                       a->net.ny, a->weights[c].x, b->weights[c].x))
            return false;
    for (size_t c = a->nov; c < CLASSES; c++)
        if (!gen_check(g, a->weights[c].x == 0, "nothing is written beyond the classes"))
            return false;
    return true;
}

static et_status train(job *j, et_som_quality *q, et_rng *rng, const et_task *task)
{
    return et_som_train(j->weights, j->nov, q, j->net, j->cloud, j->n, &j->options, rng, task);
}

/* Both loops, the reference stopping after `steps`; equal bits in everything. */
static bool agree(gen *g, job *a, const et_task *task, et_status want, size_t steps)
{
    static job b;
    et_rng *ra, *rb;
    et_som_quality qa, qb;
    et_status status;
    bool ok;

    b = *a;
    if (et_rng_new(&ra, a->seed))
        return false;
    if (et_rng_new(&rb, a->seed)) {
        et_rng_free(ra);
        return false;
    }
    status = train(a, &qa, ra, task);
    qb = reference(&b, steps, rb);
    ok = gen_check(g, status == want, "status %d is %d", (int)status, (int)want) && same_quality(g, qa, qb) && same_weights(g, a, &b) &&
         gen_check(g, et_rng_tell(ra) == et_rng_tell(rb), "both drew alike");
    et_rng_free(ra);
    et_rng_free(rb);
    return ok;
}

verdict prop_som_defaults(gen *g);
verdict prop_som_defaults(gen *g)
{
    const et_som_options o = et_som_defaults();

    return gen_check(g, o.iterations == 30000 && same_double(o.alpha0, 9.0 / 10.0) && same_double(o.sigma0, 0), "30000, 0.9, 0") ? PASS : FAIL;
}

verdict prop_som_start(gen *g);
verdict prop_som_start(gen *g)
{
    enum { MOST = 40 };
    et_vec3 w[MOST + 1];
    const size_t nov = gen_between(g, 1, MOST), before = gen_upto(g, 5);
    double x[3 * MOST + 5];
    et_rng *rng;
    bool ok = true;

    if (et_rng_new(&rng, gen_upto(g, UINT64_MAX)))
        return FAIL;
    et_rng_fill(x, before + 3 * nov, rng);
    et_rng_seek(rng, before);
    w[nov].x = 77;
    et_som_start(w, nov, rng);
    for (size_t c = 0; c < nov; c++) {
        const double *y = x + before + 3 * c;

        ok = ok && gen_check(g, w[c].x == y[0] && w[c].y == y[1] && w[c].z == y[2], "class %zu draws x, y, z in turn", c + 1);
        ok = ok && gen_check(g, 0 <= w[c].x && w[c].x < 1 && 0 <= w[c].y && w[c].y < 1 && 0 <= w[c].z && w[c].z < 1, "in [0,1)^3");
    }
    ok = ok && gen_check(g, et_rng_tell(rng) == before + 3 * nov && w[nov].x == 77, "3 draws a class");
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

verdict prop_som_train(gen *g);
verdict prop_som_train(gen *g)
{
    static job j;

    if (!any_job(g, &j, 30))
        return FAIL;
    return agree(g, &j, NULL, ET_OK, j.options.iterations) ? PASS : FAIL;
}

/* More than one block of errors; a net of four to six classes, for speed. */
verdict prop_som_train_long(gen *g);
verdict prop_som_train_long(gen *g)
{
    static job j;

    if (!any_job(g, &j, 1))
        return FAIL;
    j.net = (et_doublenet){2, gen_between(g, 2, 3)};
    j.nov = et_doublenet_nov(j.net);
    memset(j.weights + j.nov, 0, (CLASSES - j.nov) * sizeof j.weights[0]);
    j.options.iterations = gen_chance(g, 8) ? gen_between(g, BLOCK - 1, 2 * BLOCK + 1) : gen_between(g, 100, 900);
    return agree(g, &j, NULL, ET_OK, j.options.iterations) ? PASS : FAIL;
}

typedef struct {
    size_t calls, stop, total;
    et_status status;
    bool ok;
} watch;

static et_status look(void *context, size_t done, size_t total)
{
    watch *w = context;

    w->calls++;
    w->ok = w->ok && done == 1000 * w->calls && done < total && total == w->total;
    return w->calls == w->stop ? w->status : ET_OK;
}

/* Stopped at a report, the state is that of a loop ended there; else every thousandth step but the last is reported. */
verdict prop_som_train_stop(gen *g);
verdict prop_som_train_stop(gen *g)
{
    static const et_status stop[] = {ET_ESTOPPED, ET_ENOCONV};
    static job j;
    watch w = {0, 0, 0, ET_OK, true};
    const et_task task = {look, &w};
    size_t reports, steps;

    if (!any_job(g, &j, 1))
        return FAIL;
    j.net = (et_doublenet){2, 2};
    j.nov = 4;
    memset(j.weights + j.nov, 0, (CLASSES - j.nov) * sizeof j.weights[0]);
    j.options.iterations = gen_chance(g, 2) ? 2000 : gen_between(g, 999, 2101);
    reports = (j.options.iterations - 1) / 1000;
    w.total = j.options.iterations;
    w.stop = gen_upto(g, reports + 1);
    w.status = stop[gen_upto(g, 1)];
    steps = w.stop >= 1 && w.stop <= reports ? 1000 * w.stop : j.options.iterations;
    if (!agree(g, &j, &task, w.stop >= 1 && w.stop <= reports ? w.status : ET_OK, steps))
        return FAIL;
    return gen_check(g, w.ok && w.calls == (w.stop >= 1 && w.stop <= reports ? w.stop : reports), "%zu reports of %zu", w.calls, reports) ? PASS
                                                                                                                                          : FAIL;
}

/* A power of two on everything scales everything exactly, and no weight leaves the box of what it began as and what it saw: w + f(p - w) is
 * within 3 roundings of a point between w and p, so after T steps at most 3 T u of the box's greatest number beyond it. */
verdict prop_som_train_scale(gen *g);
verdict prop_som_train_scale(gen *g)
{
    static job a, b;
    et_rng *rng;
    et_som_quality qa, qb;
    const double s = gen_chance(g, 2) ? 0x1p40 : 0x1p-40;
    bool ok;

    any_net(g, &a);
    if (et_rng_new(&rng, gen_upto(g, UINT32_MAX)))
        return FAIL;
    memset(a.weights, 0, sizeof a.weights);
    a.n = POINTS;
    et_som_start(a.weights, a.nov, rng);
    et_som_start(a.cloud, a.n, rng);
    any_options(g, &a, 200);
    b = a;
    for (size_t k = 0; k < 3 * CLASSES; k++)
        (&b.weights[0].x)[k] *= s;
    for (size_t k = 0; k < 3 * POINTS; k++)
        (&b.cloud[0].x)[k] *= s;
    et_rng_seek(rng, 0);
    ok = gen_check(g, train(&a, &qa, rng, NULL) == ET_OK, "trains");
    et_rng_seek(rng, 0);
    ok = ok && gen_check(g, train(&b, &qb, rng, NULL) == ET_OK, "trains");
    et_rng_free(rng);
    for (size_t k = 0; ok && k < 3 * a.nov; k++) {
        const double x = (&a.weights[0].x)[k], slack = 3 * (double)a.options.iterations * ET_UNIT;

        ok = gen_check(g, (&b.weights[0].x)[k] == s * x, "weight %zu scales", k) &&
             gen_check(g, -slack <= x && x <= 1 + slack, "weight %zu: %a", k, x);
    }
    return ok && gen_check(g, qb.qe == s * qa.qe && qb.te == qa.te && qb.max_error == s * qa.max_error, "quality scales") ? PASS : FAIL;
}

static void spoil(gen *g, job *j)
{
    static const double bad[] = {-1, NAN, INFINITY, -INFINITY, 1.5, 0, 0x1.0000000000001p0, 0x1.0000000000001p500};
    const uint64_t what = gen_upto(g, 8);
    const double odd = bad[1 + gen_upto(g, 2)];

    if (what == 0)
        j->net.nx = gen_upto(g, 1);
    else if (what == 1)
        j->nov += gen_chance(g, 2) ? 1 : SIZE_MAX;
    else if (what == 2)
        j->n = 0;
    else if (what == 3)
        j->options.iterations = 0;
    else if (what == 4)
        j->options.alpha0 = bad[gen_upto(g, 6)];
    else if (what == 5)
        j->options.sigma0 = bad[gen_upto(g, 3)];
    else if (what == 6)
        (&j->weights[0].x)[gen_upto(g, 3 * j->nov - 1)] = gen_chance(g, 2) ? bad[7] : odd;
    else if (what == 7)
        (&j->cloud[0].x)[gen_upto(g, 3 * j->n - 1)] = gen_chance(g, 2) ? -bad[7] : odd;
    else
        j->net = (et_doublenet){SIZE_MAX, SIZE_MAX};
}

/* What it refuses it leaves alone: weights, quality and generator. */
verdict prop_som_train_refuses(gen *g);
verdict prop_som_train_refuses(gen *g)
{
    static job j, before;
    et_som_quality q = {1, 2, 3, 4, 5};
    et_rng *rng;
    bool ok;

    if (!any_job(g, &j, 30) || et_rng_new(&rng, j.seed))
        return FAIL;
    spoil(g, &j);
    before = j;
    ok = gen_check(g, train(&j, &q, rng, NULL) == ET_EINVAL, "refused") && gen_check(g, memcmp(&j, &before, sizeof j) == 0, "weights as before") &&
         gen_check(g, q.qe == 1 && q.te == 2 && q.min_error == 3 && q.max_error == 4 && q.steps == 5, "quality as before") &&
         gen_check(g, et_rng_tell(rng) == 0, "nothing drawn");
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

/* The greatest coordinates allowed. */
verdict prop_som_train_limits(gen *g);
verdict prop_som_train_limits(gen *g)
{
    et_vec3 w[4] = {{0x1p500, 0, 0}, {-0x1p500, 0, 0}, {0, 0x1p500, 0x1p500}, {0, 0, -0x1p500}};
    const et_vec3 cloud[2] = {{-0x1p500, 0x1p500, -0x1p500}, {0x1p500, 0x1p500, 0x1p500}};
    et_som_options o = {gen_between(g, 1, 50), 1, 3};
    et_som_quality q = {1, 2, 3, 4, 5};
    et_rng *rng;
    bool ok;

    if (et_rng_new(&rng, gen_upto(g, 1000)))
        return FAIL;
    ok = et_som_train(w, 4, &q, (et_doublenet){2, 2}, cloud, 2, &o, rng, NULL) == ET_OK && isfinite(q.qe) && isfinite(q.max_error);
    ok = gen_check(g, ok, "2^500 is not too much");
    for (size_t k = 0; k < 12; k++)
        ok = ok && gen_check(g, fabs((&w[0].x)[k]) <= 0x1p500, "weight %zu stays in the box", k);
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

verdict gold_som_defaults(const row *r);
verdict gold_som_defaults(const row *r)
{
    const et_som_options o = et_som_defaults();
    const bool a = row_is_size(r, 0, o.iterations), b = row_is(r, 1, o.alpha0), c = row_is(r, 2, o.sigma0);

    return a && b && c ? PASS : FAIL;
}

static bool row_weights(const row *r, size_t at, const et_vec3 *w, size_t nov)
{
    bool ok = true;

    for (size_t k = 0; k < 3 * nov; k++)
        ok = row_is(r, at + k, (&w[0].x)[k]) && ok;
    return ok;
}

/* seed, classes -> weights */
verdict gold_som_start(const row *r);
verdict gold_som_start(const row *r)
{
    et_vec3 w[300];
    const size_t nov = row_size(r, 1);
    et_rng *rng;
    bool ok;

    if (et_rng_new(&rng, row_size(r, 0)))
        return FAIL;
    et_som_start(w, nov, rng);
    ok = row_weights(r, 0, w, nov) && r->nwant == 3 * nov;
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

/* nx ny T alpha0 sigma0 seed, points -> te, least error, greatest error, weights; started by et_som_start from the same generator */
verdict gold_som_train(const row *r);
verdict gold_som_train(const row *r)
{
    static job j;
    et_som_quality q;
    et_rng *rng;
    bool ok;

    j.net = (et_doublenet){row_size(r, 0), row_size(r, 1)};
    j.nov = et_doublenet_nov(j.net);
    j.options = (et_som_options){row_size(r, 2), row_real(r, 3), row_real(r, 4)};
    j.n = (r->nargs - 6) / 3;
    for (size_t k = 0; k < 3 * j.n; k++)
        (&j.cloud[0].x)[k] = row_real(r, 6 + k);
    if (et_rng_new(&rng, row_size(r, 5)))
        return FAIL;
    et_som_start(j.weights, j.nov, rng);
    ok = train(&j, &q, rng, NULL) == ET_OK && q.steps == j.options.iterations && r->nwant == 3 + 3 * j.nov;
    et_rng_free(rng);
    ok = row_is(r, 0, q.te) && ok;
    ok = row_is(r, 1, q.min_error) && ok;
    ok = row_is(r, 2, q.max_error) && ok;
    return row_weights(r, 3, j.weights, j.nov) && ok ? PASS : FAIL;
}
