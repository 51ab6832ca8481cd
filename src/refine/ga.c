#include "etalon/refine/ga.h"
#include <string.h>

/* The best of `tournament` individuals drawn with replacement; of equals the one drawn first. */
/*@ requires search: et_search_started(s) && et_search_rng(s, rng);
    assigns  *rng;
    ensures  range:  \result < s->options.population;
    ensures  started: et_search_started(s) && et_search_rng(s, rng);
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

/* The children of parents i and j, at the start of the workspace. */
/*@ requires search: et_search_started(s) && et_search_rng(s, rng) && i < s->options.population && j < s->options.population;
    assigns  s->trial[0 .. 3 * s->n - 1], *rng;
*/
static void breed(et_search *s, size_t i, size_t j, et_rng *rng)
{
    const size_t n = s->n, size = n * sizeof(double);
    /*@ ghost fact_search(s); */
    /*@ ghost fact_order(); */
    double *a = s->trial, *b = a + n, *draw = b + n;
    /*@ ghost fact_slot(i, s->options.population, n); */
    /*@ ghost fact_slot(j, s->options.population, n); */
    memcpy(a, s->x + i * n, size);
    memcpy(b, s->x + j * n, size);
    crossover(a, b, s, draw, rng);
    mutate(a, s, rng);
    mutate(b, s, rng);
}

/* The values of the children, behind them in the workspace. */
/*@ requires search: et_search_started(s) && s->evaluations + 2 <= UINT64_MAX;
    assigns  s->trial[3 * s->n .. 3 * s->n + 1], s->best[0 .. s->n - 1], s->best_value, s->evaluations;
    ensures  count:  \result == ET_OK ==> s->evaluations == \old(s->evaluations) + 2;
    ensures  started: et_search_started(s);
    ensures  falling: \le_double(s->best_value, \old(s->best_value));
    ensures  kept:   \forall integer k; 0 <= k < s->options.population ==> \le_double(s->value[k], \old(s->value[k]));
*/
static et_status evaluate(et_search *s)
{
    double *a = s->trial, *b = a + s->n, *value = b + 2 * s->n;
    /*@ ghost fact_search(s); */
    /*@ ghost fact_order(); */
    /*@ assert best:    search_aside(s->best, s->n, s); */
    /*@ assert value:   search_aside(value, 2, s); */
    et_status status = et_search_eval(&value[0], s, a);
    /*@ assert values:  search_values{Pre, Here}(s); */
    /*@ assert centre:  search_centre{Here}(s); */
    /*@ assert own:     search_own{Here}(s); */
    /*@ assert arrays:  et_search_arrays(s); */
    /*@ assert apart:   et_search_apart(s); */
    if (status == ET_OK) status = et_search_eval(&value[1], s, b);
    /*@ assert values:  search_values{Pre, Here}(s); */
    /*@ assert centre:  search_centre{Here}(s); */
    /*@ assert own:     search_own{Here}(s); */
    /*@ assert arrays:  et_search_arrays(s); */
    /*@ assert apart:   et_search_apart(s); */
    /*@ assert options: et_search_options_ok(s); */
    /*@ assert ordered: et_search_ordered(s); */
    return status;
}

/*@ requires search: et_search_started(s) && parent < s->options.population;
    requires child:  \valid_read(child + (0 .. s->n - 1));
    requires apart:  \separated(child + (0 .. s->n - 1), s, s->x + (0 .. s->options.population * s->n - 1),
                                s->value + (0 .. s->options.population - 1));
    assigns  s->x[0 .. s->options.population * s->n - 1], s->value[parent];
    ensures  started: et_search_started(s);
    ensures  better: \forall integer k; 0 <= k < s->options.population ==> \le_double(s->value[k], \old(s->value[k]));
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
    const size_t i = tournament(search, rng), j = tournament(search, rng);
    /*@ ghost fact_search(search); */
    /*@ ghost fact_order(); */
    /*@ assert work:    search_aside(search->trial, 3 * search->n, search); */
    breed(search, i, j, rng);
    /*@ assert values:  search_values{Pre, Here}(search); */
    /*@ assert centre:  search_centre{Here}(search); */
    /*@ assert own:     search_own{Here}(search); */
    /*@ assert arrays:  et_search_arrays(search); */
    /*@ assert apart:   et_search_apart(search); */
    /*@ assert options: et_search_options_ok(search); */
    /*@ assert ordered: et_search_ordered(search); */
    /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
    const et_status status = evaluate(search);
    /*@ assert values:  search_values{Pre, Here}(search); */
    /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
    if (status != ET_OK) return status;
    const double *a = search->trial, *b = a + search->n, *value = b + 2 * search->n;
    /*@ ghost fact_search(search); */
    const double fb = value[1];
    replace(search, i, a, value[0]);
    /*@ assert values:  search_values{Pre, Here}(search); */
    /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
    replace(search, j, b, fb);
    /*@ assert values:  search_values{Pre, Here}(search); */
    /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
    search->generation++;
    /*@ assert values:  search_values{Pre, Here}(search); */
    /*@ assert own:     search_own{Here}(search); */
    /*@ assert arrays:  et_search_arrays(search); */
    /*@ assert apart:   et_search_apart(search); */
    /*@ assert options: et_search_options_ok(search); */
    /*@ assert ordered: et_search_ordered(search); */
    return ET_OK;
}
