#include "etalon/refine/pso.h"
#include "golden.h"
#include "refine/probe.h"
#include "refine/replay.h"

/* The algorithm as the header tells it: first all draws of a particle, then its coordinates one by one; the swarm's best is looked up in the
 * personal bests of the generation before. */
static void fly(et_search *s, size_t i, const double *swarm, et_rng *rng)
{
    const et_search_options *o = &s->options;
    const size_t n = s->n;
    double r[2][PROBE_COORDINATES];
    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; k < n; k++) r[w][k] = et_rng_uniform(rng);
    for (size_t k = 0; k < n; k++) {
        double *x = s->x + i * n + k, *v = s->velocity + i * n + k;
        const double own = s->memory[i * n + k] - *x, all = swarm[k] - *x;
        *v = ((o->c1 * r[0][k]) * own + *v + (o->c2 * r[1][k]) * all) * o->K;
        if (o->vmax > 0.0) *v = fmin(o->vmax, fmax(-o->vmax, *v));
        const double free = *x + *v;
        *x = into_box(free, s->x0[k], o->box);
        if (o->absorb && *x != free) *v = 0.0;
    }
}

static void reference(et_search *s, et_rng *rng)
{
    const size_t n = s->n, m = s->options.population;
    const probe_kind kind = ((const probe *)s->context)->kind;
    double swarm[PROBE_COORDINATES];
    memcpy(swarm, s->best, n * sizeof *swarm);
    for (size_t i = 0; i < m; i++) {
        if (s->options.immediate) memcpy(swarm, s->best, n * sizeof *swarm);
        fly(s, i, swarm, rng);
        const double *x = s->x + i * n, f = probe_value(kind, x, n);
        s->evaluations++;
        s->value[i] = f;
        if (f < s->best_value) memcpy(s->best, x, n * sizeof *x);
        if (f < s->best_value) s->best_value = f;
        if (f < s->remembered[i]) memcpy(s->memory + i * n, x, n * sizeof *x);
        if (f < s->remembered[i]) s->remembered[i] = f;
    }
    s->generation++;
}

static bool memory_holds(gen *g, const problem *q, int generations)
{
    trial t;
    bool ok = trial_start(&t, q, 1);
    for (int k = 0; k < generations && ok; k++) {
        ok = et_pso_step(&t.search, t.rng) == ET_OK;
        double least = INFINITY;
        for (size_t i = 0; i < q->options.population && ok; i++) {
            const et_search *s = &t.search;
            const double f = probe_value(q->kind, s->memory + i * q->n, q->n);
            least = fmin(least, f);
            ok = gen_check(g, f == s->remembered[i] && f <= s->value[i], "personal best %zu", i);
            for (size_t d = 0; d < q->n && q->options.vmax > 0.0; d++)
                ok = ok && gen_check(g, fabs(s->velocity[i * q->n + d]) <= q->options.vmax, "velocity above vmax");
        }
        ok = ok && gen_check(g, least == t.search.best_value, "the least personal best is not the best");
    }
    trial_end(&t);
    return ok;
}

verdict prop_pso_step(gen *g)
{
    return agrees_with(g, et_pso_step, reference, 1, 0);
}

verdict prop_pso_step_memory(gen *g)
{
    const problem q = gen_problem(g);
    return memory_holds(g, &q, (int)gen_between(g, 1, 6)) ? PASS : FAIL;
}

verdict prop_pso_step_fails(gen *g)
{
    return failing_step(g, et_pso_step, 1, 0, true);
}

verdict prop_pso_step_without_velocities(gen *g)
{
    const problem q = gen_problem(g);
    trial t;
    bool ok = trial_start(&t, &q, 0);
    et_search old = clone(&t.search, &t.probe);
    const uint64_t draws = ok ? et_rng_tell(t.rng) : 0;
    ok = ok && gen_check(g, et_pso_step(&t.search, t.rng) == ET_EINVAL, "a search without velocities was stepped");
    ok = ok && gen_check(g, same_search(&old, &t.search) && et_rng_tell(t.rng) == draws, "it changed");
    et_search_free(&old);
    trial_end(&t);
    return ok ? PASS : FAIL;
}

verdict gold_pso_step(const row *r)
{
    return replay(r, et_pso_step, 1);
}
