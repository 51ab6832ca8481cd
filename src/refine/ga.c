#include "etalon/refine/ga.h"
#include <string.h>

/* The best of `tournament` individuals drawn with replacement; of equals the one drawn first. */
static size_t tournament(const et_search *s, et_rng *rng)
{
    size_t winner = et_rng_index(rng, s->options.population);
    for (size_t k = 1; k < s->options.tournament; k++) {
        const size_t rival = et_rng_index(rng, s->options.population);
        if (s->value[rival] < s->value[winner]) winner = rival;
    }
    return winner;
}

/* Uniform crossover, a gene at a time. */
static void crossover(double *a, double *b, const et_search *s, double *draw, et_rng *rng)
{
    const size_t group = s->options.group, genes = s->n / group;
    if (!(et_rng_uniform(rng) < s->options.crossover)) return;
    et_rng_fill(draw, genes, rng);
    for (size_t g = 0; g < genes; g++) {
        if (!(draw[g] < s->options.swap)) continue;
        for (size_t k = g * group; k < (g + 1) * group; k++) {
            const double t = a[k];
            a[k] = b[k];
            b[k] = t;
        }
    }
}

/* One gene redrawn uniformly in the box, or where there is none in the start's. */
static void mutate(double *a, const et_search *s, et_rng *rng)
{
    const size_t group = s->options.group;
    if (!(et_rng_uniform(rng) < s->options.mutation)) return;
    const size_t k = et_rng_index(rng, s->n / group) * group;
    et_search_draw(a + k, s, k, group, s->options.box > 0.0 ? s->options.box : s->options.spread, rng);
}

static void replace(et_search *s, size_t parent, const double *child, double value)
{
    if (!(value < s->value[parent])) return;
    memcpy(s->x + parent * s->n, child, s->n * sizeof *child);
    s->value[parent] = value;
}

et_status et_ga_step(et_search *search, et_rng *rng)
{
    const size_t n = search->n, size = n * sizeof(double);
    double *a = search->trial, *b = a + n, *draw = b + n, fa = 0.0, fb = 0.0;
    const size_t i = tournament(search, rng), j = tournament(search, rng);
    memcpy(a, search->x + i * n, size);
    memcpy(b, search->x + j * n, size);
    crossover(a, b, search, draw, rng);
    mutate(a, search, rng);
    mutate(b, search, rng);
    et_status status = et_search_eval(&fa, search, a);
    if (status == ET_OK) status = et_search_eval(&fb, search, b);
    if (status != ET_OK) return status;
    replace(search, i, a, fa);
    replace(search, j, b, fb);
    search->generation++;
    return ET_OK;
}
