/* probe: objectives that watch the search which calls them, and searches drawn at random; for the tests of search, ga, de and pso. */
#ifndef TESTS_REFINE_PROBE_H
#define TESTS_REFINE_PROBE_H
#include "etalon/refine/search.h"
#include "gen.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PROBE_COORDINATES = 15, PROBE_POPULATION = 9 };

typedef enum { PROBE_SPHERE, PROBE_ROSENBROCK, PROBE_STEPS, PROBE_CONSTANT } probe_kind;

typedef struct {
    probe_kind kind;
    size_t calls, fail_at;                /* the call that fails; 0: none */
    et_status failure;
    double least, least_x[PROBE_COORDINATES];    /* of the calls that did not fail, the first of equals */
    const double *x0;
    double box;
    size_t outside;                       /* coordinates seen outside the box */
} probe;

static inline double probe_value(probe_kind kind, const double *x, size_t n)
{
    double f = 0.0;
    for (size_t k = 0; k < n && kind == PROBE_SPHERE; k++) f = f + x[k] * x[k];
    for (size_t k = 0; k + 1 < n && kind == PROBE_ROSENBROCK; k++) {
        const double a = x[k + 1] - x[k] * x[k], b = 1.0 - x[k];
        f = f + (100.0 * (a * a) + b * b);
    }
    for (size_t k = 0; k < n && kind == PROBE_STEPS; k++) f = f + floor(fabs(4.0 * x[k]));    /* ties come often */
    return f;
}

static inline et_status probe_call(double *value, const double *x, size_t n, void *context)
{
    probe *p = context;
    p->calls++;
    for (size_t k = 0; k < n && p->box > 0.0; k++) p->outside += !(x[k] >= p->x0[k] - p->box && x[k] <= p->x0[k] + p->box);
    if (p->calls == p->fail_at && p->failure != ET_OK) return p->failure;
    const double v = p->calls == p->fail_at ? NAN : probe_value(p->kind, x, n);
    *value = v;
    if (!(isnan(v)) && (p->least_x[0] != p->least_x[0] || v < p->least)) {
        p->least = v;
        memcpy(p->least_x, x, n * sizeof *x);
    }
    return ET_OK;
}

static inline probe probe_of(probe_kind kind, const double *x0, double box)
{
    probe p;
    memset(&p, 0, sizeof p);
    p.kind = kind;
    p.x0 = x0;
    p.box = box;
    p.failure = ET_ESTOPPED;
    p.least_x[0] = NAN;                   /* nothing seen yet */
    return p;
}

/* A problem drawn at random: everything that et_search_start takes. */
typedef struct {
    et_search_options options;
    size_t n;
    double x0[PROBE_COORDINATES];
    probe_kind kind;
    uint64_t seed;
} problem;

static inline double gen_probability(gen *g)
{
    static const double often[] = { 1.0, 0.0, 0.5 };
    const uint64_t k = gen_upto(g, 5);
    return k < 3 ? often[k] : gen_real(g, 0.0, 1.0);
}

static inline problem gen_problem(gen *g)
{
    static const double radius[] = { 0.5, 5e-6, 0.0, 1.0, 0x1p-60, 3.0 };
    static const double box[] = { 0.5, 0.0, 5e-6, -1.0, 0x1p-60, 2.0 }, vmax[] = { 0.25, 0.0, 5e-6, -1.0 };
    problem q;
    et_search_options *o = &q.options;
    *o = et_search_defaults();
    o->population = gen_between(g, 4, PROBE_POPULATION);
    o->group = gen_between(g, 1, 3);
    q.n = o->group * gen_between(g, 1, PROBE_COORDINATES / o->group);     /* one less than a block of eight, too */
    o->spread = radius[gen_upto(g, 5)];
    o->box = box[gen_upto(g, 5)];
    o->tournament = gen_between(g, 1, 5);
    o->crossover = gen_probability(g);
    o->swap = gen_probability(g);
    o->mutation = gen_probability(g);
    o->CR = gen_probability(g);
    o->F = gen_real(g, 0.0, 2.0);
    o->by_coordinate = (int)gen_upto(g, 1);
    o->K = gen_real(g, 0.0, 1.0);
    o->c1 = gen_real(g, 0.0, 2.5);
    o->c2 = gen_real(g, 0.0, 2.5);
    o->vmax = vmax[gen_upto(g, 3)];
    o->immediate = (int)gen_upto(g, 1);
    o->absorb = (int)gen_upto(g, 1);
    for (size_t k = 0; k < q.n; k++) q.x0[k] = gen_real(g, 0.0, 1.0) - gen_real(g, 0.0, 1.0);
    q.kind = (probe_kind)gen_upto(g, 3);
    q.seed = gen_upto(g, 0xffff);
    return q;
}

static inline bool same_bits(const void *a, const void *b, size_t doubles)
{
    return memcmp(a, b, doubles * sizeof(double)) == 0;
}

/* The two searches hold the same bits; the workspace is no part of a search. */
static inline bool same_search(const et_search *a, const et_search *b)
{
    const size_t m = a->options.population, n = a->n;
    if (m != b->options.population || n != b->n || a->generation != b->generation || a->evaluations != b->evaluations) return false;
    if (!same_bits(a->x0, b->x0, n) || !same_bits(a->x, b->x, m * n) || !same_bits(a->value, b->value, m)) return false;
    if (!same_bits(a->best, b->best, n) || !same_bits(&a->best_value, &b->best_value, 1)) return false;
    if ((a->velocity == NULL) != (b->velocity == NULL)) return false;
    return !a->velocity
        || (same_bits(a->velocity, b->velocity, m * n) && same_bits(a->memory, b->memory, m * n) && same_bits(a->remembered, b->remembered, m));
}

static inline double *copy_of(const double *a, size_t n)
{
    double *b = a ? malloc(n * sizeof *b) : NULL;
    if (b) memcpy(b, a, n * sizeof *b);
    return b;
}

/* A search saved and restored: its numbers, and a workspace full of rubbish. */
static inline et_search clone(const et_search *s, void *context)
{
    const size_t m = s->options.population, n = s->n, work = (m + 1) * (n + 1);
    et_search c = *s;
    c.context = context;
    c.x0 = copy_of(s->x0, n);
    c.x = copy_of(s->x, m * n);
    c.value = copy_of(s->value, m);
    c.best = copy_of(s->best, n);
    c.velocity = copy_of(s->velocity, m * n);
    c.memory = copy_of(s->memory, m * n);
    c.remembered = copy_of(s->remembered, m);
    c.trial = malloc(work * sizeof *c.trial);
    for (size_t k = 0; k < work; k++) c.trial[k] = 1e300;
    return c;
}

/* What holds after every call of the library, failed or not. */
static inline bool consistent(gen *g, const et_search *s, const probe *p)
{
    bool ok = gen_check(g, p->outside == 0, "%zu coordinates outside the box were evaluated", p->outside);
    ok = ok && gen_check(g, same_bits(s->best, p->least_x, s->n) && s->best_value == p->least, "best is not the first least of all seen");
    for (size_t i = 0; i < s->options.population && ok; i++) {
        const double f = probe_value(p->kind, s->x + i * s->n, s->n);
        ok = gen_check(g, same_bits(&f, &s->value[i], 1), "value %zu is not that of its individual", i);
        ok = ok && gen_check(g, s->best_value <= s->value[i], "individual %zu is better than the best", i);
    }
    return ok;
}

/* A started search, its generator and its probe; false: no memory, or the start failed. */
typedef struct { et_search search; et_rng *rng; probe probe; } trial;

static inline bool trial_start(trial *t, const problem *q, int velocities)
{
    memset(t, 0, sizeof *t);
    t->probe = probe_of(q->kind, q->x0, q->options.box);
    return et_rng_new(&t->rng, q->seed) == ET_OK
        && et_search_start(&t->search, q->x0, q->n, &q->options, velocities, probe_call, &t->probe, t->rng) == ET_OK;
}

static inline void trial_end(trial *t)
{
    et_search_free(&t->search);
    et_rng_free(t->rng);
}

/* U in [a - r, a + r] as et_search_draw defines it. */
static inline double about(double a, double r, et_rng *rng)
{
    const double u = et_rng_uniform(rng);
    return a + r * (u + u - 1.0);
}

static inline double into_box(double x, double a, double box)
{
    return box > 0.0 ? fmax(a - box, fmin(a + box, x)) : x;
}

/* Steps fail at every call of the objective in turn: the status comes back, nothing but the best has changed in the population, and the search
 * can still be freed.  moves: the step may move what it has evaluated before the failure (pso). */
static inline verdict failing_step(gen *g, et_status (*step)(et_search *, et_rng *), int velocities, size_t calls, bool moves)
{
    const problem q = gen_problem(g);
    trial t;
    bool ok = trial_start(&t, &q, velocities);
    const size_t at = gen_between(g, 1, calls > 0 ? calls : q.options.population), before = t.probe.calls;
    et_search old = clone(&t.search, &t.probe);
    t.probe.fail_at = before + at;
    t.probe.failure = gen_upto(g, 1) ? ET_OK : ET_ESTOPPED;       /* ET_OK: a NaN instead */
    const et_status want = t.probe.failure == ET_OK ? ET_EINVAL : ET_ESTOPPED;
    ok = ok && gen_check(g, step(&t.search, t.rng) == want, "status of the failing call %zu", at);
    ok = ok && consistent(g, &t.search, &t.probe);
    ok = ok && gen_check(g, t.probe.calls == before + at && t.search.evaluations == before + at - 1, "evaluations");
    ok = ok && gen_check(g, t.search.generation == 0, "a failed generation was counted");
    ok = ok && gen_check(g, moves || same_bits(old.x, t.search.x, q.n * q.options.population), "the population moved");
    et_search_free(&old);
    trial_end(&t);
    return ok ? PASS : FAIL;
}

/* Several generations of `step`, each next to the same generation by `reference`: the same bits, the same draws. */
static inline verdict agrees_with(gen *g, et_status (*step)(et_search *, et_rng *), void (*reference)(et_search *, et_rng *), int velocities,
                                  size_t calls)
{
    const problem q = gen_problem(g);
    trial t;
    et_rng *rng = NULL;
    bool ok = trial_start(&t, &q, velocities) && et_rng_new(&rng, q.seed) == ET_OK;
    probe again = t.probe;
    et_search other = clone(&t.search, &again);
    if (ok) et_rng_seek(rng, et_rng_tell(t.rng));
    for (size_t k = gen_between(g, 1, 5), before = 0; k > 0 && ok; k--) {
        const double best = t.search.best_value;
        before = t.probe.calls;
        ok = gen_check(g, step(&t.search, t.rng) == ET_OK, "status");
        reference(&other, rng);
        ok = ok && gen_check(g, same_search(&t.search, &other), "differs from the reference");
        ok = ok && gen_check(g, et_rng_tell(rng) == et_rng_tell(t.rng), "draws");
        ok = ok && gen_check(g, t.probe.calls - before == (calls > 0 ? calls : q.options.population), "evaluations a generation");
        ok = ok && gen_check(g, t.search.evaluations == t.probe.calls && t.search.best_value <= best, "count, or the best rose");
        ok = ok && consistent(g, &t.search, &t.probe);
    }
    et_search_free(&other);
    et_rng_free(rng);
    trial_end(&t);
    return ok ? PASS : FAIL;
}
#endif
