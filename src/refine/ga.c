#include "etalon/refine/ga.h"
#include <string.h>

/* The best of `tournament` individuals drawn with replacement; of equals the one drawn first. */
/*@ requires search: et_search_started(s) && et_search_rng(s, rng);
    assigns  *rng;
    ensures  range:  \result < s->options.population;
*/
static size_t tournament(const et_search *s, et_rng *rng)
{
    size_t winner = et_rng_index(rng, s->options.population);
    /*@ loop invariant range: 1 <= k <= s->options.tournament && winner < s->options.population;
        loop assigns   k, winner, *rng;
        loop variant   s->options.tournament - k; */
    for (size_t k = 1; k < s->options.tournament; k++) {
        const size_t rival = et_rng_index(rng, s->options.population);
        if (s->value[rival] < s->value[winner]) winner = rival;
    }
    return winner;
}

/* Uniform crossover, a gene at a time. */
/*@ requires search: \valid_read(s) && 1 <= s->n && 1 <= s->options.group && s->n % s->options.group == 0 && \valid(rng);
    requires inout:  \valid(a + (0 .. s->n - 1)) && \valid(b + (0 .. s->n - 1)) && \valid(draw + (0 .. s->n - 1));
    requires apart:  \separated(rng, s, a + (0 .. s->n - 1), b + (0 .. s->n - 1), draw + (0 .. s->n - 1));
    assigns  a[0 .. s->n - 1], b[0 .. s->n - 1], draw[0 .. s->n - 1], *rng;
*/
static void crossover(double *a, double *b, const et_search *s, double *draw, et_rng *rng)
{
    const size_t group = s->options.group, genes = s->n / group;
    /*@ ghost fact_genes(s->n, s->options.group); */
    /*@ assert genes: genes <= s->n; */
    if (!(et_rng_uniform(rng) < s->options.crossover)) return;
    et_rng_fill(draw, genes, rng);
    /*@ loop invariant range: 0 <= g <= genes;
        loop assigns   g, a[0 .. s->n - 1], b[0 .. s->n - 1];
        loop variant   genes - g; */
    for (size_t g = 0; g < genes; g++) {
        if (!(draw[g] < s->options.swap)) continue;
        /*@ ghost fact_gene(g, s->n, group); */
        /*@ loop invariant range: g * group <= k <= (g + 1) * group;
            loop assigns   k, a[0 .. s->n - 1], b[0 .. s->n - 1];
            loop variant   (g + 1) * group - k; */
        for (size_t k = g * group; k < (g + 1) * group; k++) {
            const double t = a[k];
            a[k] = b[k];
            b[k] = t;
        }
    }
}

/* One gene redrawn uniformly in the box, or where there is none in the start's. */
/*@ requires search: \valid_read(s) && 1 <= s->n && et_search_options_ok(s) && \valid_read(s->x0 + (0 .. s->n - 1)) && \valid(rng);
    requires inout:  \valid(a + (0 .. s->n - 1));
    requires apart:  \separated(rng, s, a + (0 .. s->n - 1), s->x0 + (0 .. s->n - 1));
    assigns  a[0 .. s->n - 1], *rng;
*/
static void mutate(double *a, const et_search *s, et_rng *rng)
{
    const size_t group = s->options.group;
    /*@ ghost fact_genes(s->n, s->options.group); */
    if (!(et_rng_uniform(rng) < s->options.mutation)) return;
    const size_t gene = et_rng_index(rng, s->n / group);
    /*@ ghost fact_gene(gene, s->n, group); */
    const size_t k = gene * group;
    et_search_draw(a + k, s, k, group, s->options.box > 0.0 ? s->options.box : s->options.spread, rng);
}

/*@ requires search: et_search_started(s) && parent < s->options.population;
    requires child:  \valid_read(child + (0 .. s->n - 1));
    requires apart:  \separated(child + (0 .. s->n - 1), s, s->x + (0 .. s->options.population * s->n - 1),
                                s->value + (0 .. s->options.population - 1));
    assigns  s->x[0 .. s->options.population * s->n - 1], s->value[parent];
    ensures  better: \le_double(s->value[parent], \old(s->value[parent]));
*/
static void replace(et_search *s, size_t parent, const double *child, double value)
{
    /*@ ghost fact_search(s); */
    /*@ ghost fact_slot(parent, s->options.population, s->n); */
    if (!(value < s->value[parent])) return;
    memcpy(s->x + parent * s->n, child, s->n * sizeof *child);
    s->value[parent] = value;
}

et_status et_ga_step(et_search *search, et_rng *rng)
{
    const size_t n = search->n, size = n * sizeof(double);
    /*@ ghost fact_search(search); */
    double *a = search->trial, *b = a + n, *draw = b + n, fa = 0.0, fb = 0.0;
    const size_t i = tournament(search, rng), j = tournament(search, rng);
    /*@ ghost fact_slot(i, search->options.population, n); */
    /*@ ghost fact_slot(j, search->options.population, n); */
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
