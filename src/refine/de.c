#include "etalon/refine/de.h"
#include <string.h>

enum { BLOCK = 8 };                       /* loops of a fixed count become vectors at any level of optimisation */

/* r[0..2]: three individuals different from each other and from i. */
static void draw_three(size_t r[3], size_t i, size_t population, et_rng *rng)
{
    do r[0] = et_rng_index(rng, population); while (r[0] == i);
    do r[1] = et_rng_index(rng, population); while (r[1] == i || r[1] == r[0]);
    do r[2] = et_rng_index(rng, population); while (r[2] == i || r[2] == r[0] || r[2] == r[1]);
}

/* y[k] = a[k] + F (b[k] - c[k]) */
static void mutant(double *restrict y, const double *restrict a, const double *restrict b, const double *restrict c, double F, size_t n)
{
    size_t k = 0;
    for (; k + BLOCK <= n; k += BLOCK)
        for (size_t i = 0; i < BLOCK; i++) y[k + i] = a[k + i] + F * (b[k + i] - c[k + i]);
    for (; k < n; k++) y[k] = a[k] + F * (b[k] - c[k]);
}

/* Genes not drawn are the target's own; gene `always` is the mutant's whatever was drawn. */
static void cross(double *y, const double *target, const double *draw, size_t always, double CR, size_t genes, size_t group)
{
    for (size_t g = 0; g < genes; g++) {
        if (draw[g] < CR || g == always) continue;
        for (size_t k = g * group; k < (g + 1) * group; k++) y[k] = target[k];
    }
}

static void select_better(et_search *s, const double *trial, const double *value)
{
    for (size_t i = 0; i < s->options.population; i++) {
        if (!(value[i] <= s->value[i])) continue;
        memcpy(s->x + i * s->n, trial + i * s->n, s->n * sizeof *trial);
        s->value[i] = value[i];
    }
}

et_status et_de_step(et_search *search, et_rng *rng)
{
    const et_search_options *o = &search->options;
    const size_t n = search->n, group = o->by_coordinate ? 1 : o->group, genes = n / group;
    double *value = search->trial + o->population * n, *draw = value + o->population;
    for (size_t i = 0; i < o->population; i++) {
        double *y = search->trial + i * n;
        size_t r[3];
        draw_three(r, i, o->population, rng);
        const size_t always = et_rng_index(rng, genes);
        et_rng_fill(draw, genes, rng);
        mutant(y, search->x + r[0] * n, search->x + r[1] * n, search->x + r[2] * n, o->F, n);
        cross(y, search->x + i * n, draw, always, o->CR, genes, group);
        et_search_clamp(y, search);
        const et_status status = et_search_eval(&value[i], search, y);
        if (status != ET_OK) return status;
    }
    select_better(search, search->trial, value);
    search->generation++;
    return ET_OK;
}
