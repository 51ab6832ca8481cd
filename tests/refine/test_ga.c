#include "etalon/refine/ga.h"
#include "golden.h"
#include "refine/probe.h"
#include "refine/replay.h"

/* The algorithm as the header tells it, a draw at a time and on copies. */
static size_t contest(const et_search *s, et_rng *rng)
{
    size_t drawn[8], k = 0, t = s->options.tournament;
    while (k < t) drawn[k++] = et_rng_index(rng, s->options.population);
    size_t least = drawn[t - 1];
    while (k-- > 0)                       /* backwards, so that of equals the first drawn is taken last */
        if (s->value[drawn[k]] <= s->value[least]) least = drawn[k];
    return least;
}

static void maybe_redraw(double *child, const et_search *s, et_rng *rng)
{
    const et_search_options *o = &s->options;
    if (et_rng_uniform(rng) >= o->mutation) return;
    const size_t gene = et_rng_index(rng, s->n / o->group);
    for (size_t k = 0; k < o->group; k++)
        child[gene * o->group + k] = about(s->x0[gene * o->group + k], o->box > 0.0 ? o->box : o->spread, rng);
}

static void meet(et_search *s, const double *x, double f)
{
    s->evaluations++;
    if (!(f < s->best_value)) return;
    s->best_value = f;
    memcpy(s->best, x, s->n * sizeof *x);
}

static void reference(et_search *s, et_rng *rng)
{
    const et_search_options *o = &s->options;
    const probe_kind kind = ((const probe *)s->context)->kind;
    double child[2][PROBE_COORDINATES], f[2];
    size_t parent[2];
    for (size_t w = 0; w < 2; w++) {
        parent[w] = contest(s, rng);
        memcpy(child[w], s->x + parent[w] * s->n, s->n * sizeof(double));
    }
    const bool crossed = et_rng_uniform(rng) < o->crossover;
    bool swap = false;
    for (size_t k = 0; k < s->n && crossed; k++) {
        if (k % o->group == 0) swap = et_rng_uniform(rng) < o->swap;
        const double a = child[0][k], b = child[1][k];
        child[0][k] = swap ? b : a;
        child[1][k] = swap ? a : b;
    }
    for (size_t w = 0; w < 2; w++) maybe_redraw(child[w], s, rng);
    for (size_t w = 0; w < 2; w++) meet(s, child[w], f[w] = probe_value(kind, child[w], s->n));
    for (size_t w = 0; w < 2; w++) {
        if (f[w] >= s->value[parent[w]]) continue;
        s->value[parent[w]] = f[w];
        memcpy(s->x + parent[w] * s->n, child[w], s->n * sizeof(double));
    }
    s->generation++;
}

verdict prop_ga_step(gen *g)
{
    return agrees_with(g, et_ga_step, reference, 0, 2);
}

verdict prop_ga_step_fails(gen *g)
{
    return failing_step(g, et_ga_step, 0, 2, false);
}

/* 2000 generations of a population of 40 are 4040 evaluations (Table 6.1). */
verdict prop_ga_step_count(gen *g)
{
    problem q = gen_problem(g);
    trial t;
    size_t made = 0;
    q.options.population = 40;
    bool ok = trial_start(&t, &q, 0) && et_search_run(&t.search, &made, NULL, 200, et_ga_step, t.rng, NULL) == ET_OK;
    ok = gen_check(g, ok && t.search.evaluations == 440 && made == 200, "%zu evaluations", (size_t)t.search.evaluations);
    trial_end(&t);
    return ok ? PASS : FAIL;
}

verdict gold_ga_step(const row *r)
{
    return replay(r, et_ga_step, 0);
}
