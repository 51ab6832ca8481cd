#include "etalon/refine/de.h"
#include "golden.h"
#include "refine/probe.h"
#include "refine/replay.h"

/* The algorithm as the header tells it, a draw at a time; the new generation stands beside the old one. */
static size_t other_than(const size_t *taken, size_t n, size_t population, et_rng *rng)
{
    for (;;) {
        const size_t r = et_rng_index(rng, population);
        size_t k = 0;
        while (k < n && taken[k] != r) k++;
        if (k == n) return r;
    }
}

static void make_trial(double *y, const et_search *s, size_t i, et_rng *rng)
{
    const et_search_options *o = &s->options;
    const size_t n = s->n, gene = o->by_coordinate ? 1 : o->group;
    size_t taken[4] = { i, 0, 0, 0 };
    for (size_t k = 1; k < 4; k++) taken[k] = other_than(taken, k, o->population, rng);
    const double *a = s->x + taken[1] * n, *b = s->x + taken[2] * n, *c = s->x + taken[3] * n;
    const size_t always = et_rng_index(rng, n / gene);
    bool crosses = false;
    for (size_t k = 0; k < n; k++) {
        if (k % gene == 0) crosses = (et_rng_uniform(rng) < o->CR) | (k / gene == always);
        y[k] = into_box(crosses ? a[k] + o->F * (b[k] - c[k]) : s->x[i * n + k], s->x0[k], o->box);
    }
}

static void reference(et_search *s, et_rng *rng)
{
    const size_t n = s->n, m = s->options.population;
    const probe_kind kind = ((const probe *)s->context)->kind;
    double next[PROBE_POPULATION * PROBE_COORDINATES], value[PROBE_POPULATION];
    for (size_t i = 0; i < m; i++) {
        double *y = next + i * n;
        make_trial(y, s, i, rng);
        value[i] = probe_value(kind, y, n);
        s->evaluations++;
        if (value[i] < s->best_value) {
            s->best_value = value[i];
            memcpy(s->best, y, n * sizeof *y);
        }
        if (value[i] > s->value[i]) {
            value[i] = s->value[i];
            memcpy(y, s->x + i * n, n * sizeof *y);
        }
    }
    memcpy(s->x, next, m * n * sizeof *next);
    memcpy(s->value, value, m * sizeof *value);
    s->generation++;
}

verdict prop_de_step(gen *g)
{
    return agrees_with(g, et_de_step, reference, 0, 0);
}

verdict prop_de_step_fails(gen *g)
{
    return failing_step(g, et_de_step, 0, 0, false);
}

verdict gold_de_step(const row *r)
{
    return replay(r, et_de_step, 0);
}
