#include "etalon/refine/de.h"
#include <string.h>

enum { BLOCK = 8 };                       /* loops of a fixed count become vectors at any level of optimisation */

/* r[0..2]: three individuals different from each other and from i. */
/*@ requires sizes:    4 <= population && i < population && \valid(rng) && \valid(r + (0 .. 2)) && \separated(rng, r + (0 .. 2));
    assigns  r[0 .. 2], *rng;
    ensures  range:    r[0] < population && r[1] < population && r[2] < population;
    ensures  distinct: r[0] != i && r[1] != i && r[2] != i && r[0] != r[1] && r[0] != r[2] && r[1] != r[2];
*/
static void draw_three(size_t r[3], size_t i, size_t population, et_rng *rng)
{
    /*@ loop assigns r[0], *rng; */
    do r[0] = et_rng_index(rng, population); while (r[0] == i);
    /*@ loop assigns r[1], *rng; */
    do r[1] = et_rng_index(rng, population); while (r[1] == i || r[1] == r[0]);
    /*@ loop assigns r[2], *rng; */
    do r[2] = et_rng_index(rng, population); while (r[2] == i || r[2] == r[0] || r[2] == r[1]);
}

/* y[k] = a[k] + F (b[k] - c[k]) */
/*@ requires size:  n * sizeof(double) <= SIZE_MAX;
    requires in:    \valid_read(a + (0 .. n - 1)) && \valid_read(b + (0 .. n - 1)) && \valid_read(c + (0 .. n - 1));
    requires out:   \valid(y + (0 .. n - 1)) && \separated(y + (0 .. n - 1), a + (0 .. n - 1)) && \separated(y + (0 .. n - 1), b + (0 .. n - 1))
                    && \separated(y + (0 .. n - 1), c + (0 .. n - 1));
    assigns  y[0 .. n - 1];
*/
static void mutant(double *restrict y, const double *restrict a, const double *restrict b, const double *restrict c, double F, size_t n)
{
    size_t k = 0;
    /*@ loop invariant range: 0 <= k <= n;
        loop assigns   k, y[0 .. n - 1];
        loop variant   n - k; */
    for (; k + BLOCK <= n; k += BLOCK)
        /*@ loop invariant range: 0 <= i <= BLOCK;
            loop assigns   i, y[0 .. n - 1];
            loop variant   BLOCK - i; */
        for (size_t i = 0; i < BLOCK; i++) y[k + i] = a[k + i] + F * (b[k + i] - c[k + i]);
    /*@ loop invariant range: 0 <= k <= n;
        loop assigns   k, y[0 .. n - 1];
        loop variant   n - k; */
    for (; k < n; k++) y[k] = a[k] + F * (b[k] - c[k]);
}

/* Genes not drawn are the target's own; gene `always` is the mutant's whatever was drawn. */
/*@ requires size:  1 <= group && genes * group * sizeof(double) <= SIZE_MAX;
    requires in:    \valid_read(target + (0 .. genes * group - 1)) && \valid_read(draw + (0 .. genes - 1));
    requires out:   \valid(y + (0 .. genes * group - 1)) && \separated(y + (0 .. genes * group - 1), target + (0 .. genes * group - 1))
                    && \separated(y + (0 .. genes * group - 1), draw + (0 .. genes - 1));
    assigns  y[0 .. genes * group - 1];
*/
static void cross(double *y, const double *target, const double *draw, size_t always, double CR, size_t genes, size_t group)
{
    /*@ loop invariant range: 0 <= g <= genes;
        loop assigns   g, y[0 .. genes * group - 1];
        loop variant   genes - g; */
    for (size_t g = 0; g < genes; g++) {
        if (draw[g] < CR || g == always) continue;
        /*@ ghost fact_slot(g, genes, group); */
        /*@ loop invariant range: g * group <= k <= (g + 1) * group;
            loop assigns   k, y[0 .. genes * group - 1];
            loop variant   (g + 1) * group - k; */
        for (size_t k = g * group; k < (g + 1) * group; k++) y[k] = target[k];
    }
}

/*@ requires search: et_search_started(s);
    requires trials: \valid_read(trial + (0 .. s->options.population * s->n - 1)) && \valid_read(value + (0 .. s->options.population - 1));
    requires apart:  \separated(s->x + (0 .. s->options.population * s->n - 1), trial + (0 .. s->options.population * s->n - 1)) &&
                     \separated(s->x + (0 .. s->options.population * s->n - 1), value + (0 .. s->options.population - 1)) &&
                     \separated(s->value + (0 .. s->options.population - 1), value + (0 .. s->options.population - 1)) &&
                     \separated(s->value + (0 .. s->options.population - 1), trial + (0 .. s->options.population * s->n - 1));
    assigns  s->x[0 .. s->options.population * s->n - 1], s->value[0 .. s->options.population - 1];
    ensures  better: \forall integer i; 0 <= i < s->options.population ==> \le_double(s->value[i], \old(s->value[i]));
*/
static void select_better(et_search *s, const double *trial, const double *value)
{
    /*@ loop invariant range:  0 <= i <= s->options.population;
        loop invariant better: \forall integer j; 0 <= j < i ==> \le_double(s->value[j], \at(s->value[j], Pre));
        loop invariant others: \forall integer j; i <= j < s->options.population ==>
                               !\is_NaN(s->value[j]) && \le_double(s->value[j], \at(s->value[j], Pre));
        loop assigns   i, s->x[0 .. s->options.population * s->n - 1], s->value[0 .. s->options.population - 1];
        loop variant   s->options.population - i; */
    for (size_t i = 0; i < s->options.population; i++) {
        if (!(value[i] <= s->value[i])) continue;
        /*@ ghost fact_search(s); */
        /*@ ghost fact_slot(i, s->options.population, s->n); */
        /*@ assert apart: \separated(s->x + (i * s->n .. i * s->n + s->n - 1), s->value + (0 .. s->options.population - 1)); */
        /*@ assert trial: \separated(s->x + (i * s->n .. i * s->n + s->n - 1), value + (0 .. s->options.population - 1)); */
        memcpy(s->x + i * s->n, trial + i * s->n, s->n * sizeof *trial);
        /*@ assert kept: \forall integer j; i <= j < s->options.population ==> !\is_NaN(s->value[j]); */
        /*@ assert least: \forall integer j; i <= j < s->options.population ==> \le_double(s->value[j], \at(s->value[j], Pre)); */
        /*@ assert done: \forall integer j; 0 <= j < i ==> \le_double(s->value[j], \at(s->value[j], Pre)); */
        /*@ assert lower: \le_double(value[i], \at(s->value[\at(i, Here)], Pre)); */
        s->value[i] = value[i];
    }
}

/* Trial i: a mutant crossed with individual i, in the box. */
/*@ requires search: et_search_started(s) && et_search_rng(s, rng) && i < s->options.population;
    assigns  s->trial[0 .. (s->options.population + 1) * (s->n + 1) - 1], *rng;
*/
static void build(et_search *s, size_t i, et_rng *rng)
{
    const et_search_options *o = &s->options;
    const size_t n = s->n, group = o->by_coordinate ? 1 : o->group, genes = n / group;
    /*@ ghost fact_search(s); */
    /*@ ghost fact_slot(i, s->options.population, n); */
    /*@ assert sizes: i * n <= SIZE_MAX && o->population * n <= SIZE_MAX && o->population * n + o->population <= SIZE_MAX; */
    /*@ ghost if (!o->by_coordinate) fact_genes(n, group); */
    /*@ assert genes: genes * group == n && 1 <= genes <= n; */
    double *y = s->trial + i * n, *draw = s->trial + o->population * n + o->population;
    size_t r[3];
    draw_three(r, i, o->population, rng);
    const size_t always = et_rng_index(rng, genes);
    et_rng_fill(draw, genes, rng);
    /*@ ghost fact_slot(r[0], o->population, n); */
    /*@ ghost fact_slot(r[1], o->population, n); */
    /*@ ghost fact_slot(r[2], o->population, n); */
    mutant(y, s->x + r[0] * n, s->x + r[1] * n, s->x + r[2] * n, o->F, n);
    cross(y, s->x + i * n, draw, always, o->CR, genes, group);
    et_search_clamp(y, s);
}

et_status et_de_step(et_search *search, et_rng *rng)
{
    const size_t n = search->n, population = search->options.population;
    /*@ ghost fact_search(search); */
    /*@ ghost fact_order(); */
    double *value = search->trial + population * n;
    /*@ assert work:   search_aside(search->trial, (population + 1) * (n + 1), search); */
    /*@ assert best:   search_aside(search->best, n, search); */
    /*@ loop invariant range:   0 <= i <= population && search->evaluations == \at(search->evaluations, Pre) + i;
        loop invariant same:    search->n == n && search->options.population == population && search->generation == \at(search->generation, Pre);
        loop invariant values:  search_values{Pre, Here}(search);
        loop invariant centre:  search_centre{Here}(search);
        loop invariant own:     search_own{Here}(search);
        loop invariant arrays:  et_search_arrays(search);
        loop invariant apart:   et_search_apart(search);
        loop invariant options: et_search_options_ok(search);
        loop invariant falling: \le_double(search->best_value, \at(search->best_value, Pre));
        loop invariant rng:     et_search_rng(search, rng);
        loop assigns   i, search->trial[0 .. (population + 1) * (n + 1) - 1], search->best[0 .. n - 1], search->best_value,
                       search->evaluations, *rng;
        loop variant   population - i; */
    for (size_t i = 0; i < population; i++) {
        /*@ ghost fact_slot(i, population, n); */
        /*@ assert inside: population * n + i < (population + 1) * (n + 1) && i * n + n <= population * n; */
        build(search, i, rng);
        /*@ assert values:  search_values{Pre, Here}(search); */
        /*@ assert centre:  search_centre{Here}(search); */
        /*@ assert own:     search_own{Here}(search); */
        /*@ assert arrays:  et_search_arrays(search); */
        /*@ assert apart:   et_search_apart(search); */
        /*@ assert options: et_search_options_ok(search); */
        /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
        /*@ assert trial:   \valid(search->trial + (i * n .. i * n + n - 1)); */
        /*@ assert out:     \valid(value + i) && \valid(search->best + (0 .. n - 1)); */
        const et_status status = et_search_eval(&value[i], search, search->trial + i * n);
        /*@ assert values:  search_values{Pre, Here}(search); */
        /*@ assert centre:  search_centre{Here}(search); */
        /*@ assert own:     search_own{Here}(search); */
        /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
        /*@ assert arrays:  et_search_arrays(search); */
        /*@ assert apart:   et_search_apart(search); */
        /*@ assert options: et_search_options_ok(search); */
        /*@ assert ordered: et_search_ordered(search); */
        if (status != ET_OK) return status;
    }
    /*@ assert ordered: et_search_ordered(search); */
    select_better(search, search->trial, value);
    /*@ assert values:  search_values{Pre, Here}(search); */
    /*@ assert centre:  search_centre{Here}(search); */
    /*@ assert own:     search_own{Here}(search); */
    /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
    /*@ assert arrays:  et_search_arrays(search); */
    /*@ assert apart:   et_search_apart(search); */
    /*@ assert options: et_search_options_ok(search); */
    search->generation++;
    /*@ assert arrays:  et_search_arrays(search); */
    /*@ assert apart:   et_search_apart(search); */
    /*@ assert options: et_search_options_ok(search); */
    /*@ assert ordered: et_search_ordered(search); */
    return ET_OK;
}
