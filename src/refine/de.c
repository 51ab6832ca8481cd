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

/* The mutant of individuals a, b and c. */
/*@ requires search: et_search_arrays(s) && a < s->options.population && b < s->options.population && c < s->options.population;
    requires out:    \valid(y + (0 .. s->n - 1)) && \separated(y + (0 .. s->n - 1), s->x + (0 .. s->options.population * s->n - 1));
    assigns  y[0 .. s->n - 1];
*/
static void mix(double *y, const et_search *s, size_t a, size_t b, size_t c)
{
    const size_t n = s->n;
    /*@ ghost fact_search(s); */
    /*@ ghost fact_slot(a, s->options.population, n); */
    /*@ ghost fact_slot(b, s->options.population, n); */
    /*@ ghost fact_slot(c, s->options.population, n); */
    mutant(y, s->x + a * n, s->x + b * n, s->x + c * n, s->options.F, n);
}

/*@ requires search: et_search_arrays(s) && et_search_options_ok(s);
    assigns  \nothing;
    ensures  group:  1 <= \result && s->n % \result == 0 && \result <= s->n;
*/
static size_t group_of(const et_search *s)
{
    /*@ ghost if (!s->options.by_coordinate) fact_genes(s->n, s->options.group); */
    return s->options.by_coordinate ? 1 : s->options.group;
}

/* Genes not drawn become individual i's. */
/*@ requires search: et_search_arrays(s) && et_search_options_ok(s) && i < s->options.population;
    requires in:     \valid_read(draw + (0 .. s->n - 1));
    requires out:    \valid(y + (0 .. s->n - 1)) && \separated(y + (0 .. s->n - 1), s->x + (0 .. s->options.population * s->n - 1)) &&
                     \separated(y + (0 .. s->n - 1), draw + (0 .. s->n - 1));
    assigns  y[0 .. s->n - 1];
*/
static void inherit(double *y, const double *draw, const et_search *s, size_t i, size_t always)
{
    const size_t n = s->n, group = group_of(s), genes = n / group;
    /*@ ghost fact_search(s); */
    /*@ ghost fact_slot(i, s->options.population, n); */
    /*@ ghost fact_genes(n, group); */
    cross(y, s->x + i * n, draw, always, s->options.CR, genes, group);
}

/* y becomes a mutant crossed with individual i, in the box; draw: room for as many numbers. */
/*@ requires search: et_search_arrays(s) && et_search_options_ok(s) && i < s->options.population && \valid(rng);
    requires room:   \valid(y + (0 .. s->n - 1)) && \valid(draw + (0 .. s->n - 1));
    requires apart:  \separated(y + (0 .. s->n - 1), draw + (0 .. s->n - 1), s, rng, s->x0 + (0 .. s->n - 1),
                                s->x + (0 .. s->options.population * s->n - 1));
    assigns  y[0 .. s->n - 1], draw[0 .. s->n - 1], *rng;
*/
static void build(double *y, double *draw, const et_search *s, size_t i, et_rng *rng)
{
    const size_t group = group_of(s), genes = s->n / group;
    size_t r[3];
    /*@ ghost fact_search(s); */
    /*@ ghost fact_genes(s->n, group); */
    draw_three(r, i, s->options.population, rng);
    const size_t always = et_rng_index(rng, genes);
    et_rng_fill(draw, genes, rng);
    /*@ assert centre: search_centre{Here}(s); */
    mix(y, s, r[0], r[1], r[2]);
    /*@ assert centre: search_centre{Here}(s); */
    inherit(y, draw, s, i, always);
    /*@ assert centre: search_centre{Here}(s); */
    et_search_clamp(y, s);
}

/* Trial i and its value, both in the workspace. */
/*@ requires search: et_search_started(s) && et_search_rng(s, rng) && i < s->options.population && s->evaluations < UINT64_MAX;
    assigns  s->trial[0 .. (s->options.population + 1) * (s->n + 1) - 1], s->best[0 .. s->n - 1], s->best_value, s->evaluations, *rng;
    ensures  count:   \result == ET_OK ==> s->evaluations == \old(s->evaluations) + 1;
    ensures  started: et_search_started(s);
    ensures  falling: \le_double(s->best_value, \old(s->best_value));
    ensures  kept:    \forall integer k; 0 <= k < s->options.population ==> \le_double(s->value[k], \old(s->value[k]));
*/
static et_status attempt(et_search *s, size_t i, et_rng *rng)
{
    /*@ ghost fact_search(s); */
    /*@ ghost fact_slot(i, s->options.population, s->n); */
    /*@ ghost fact_order(); */
    /*@ assert size:   s->options.population * s->n + s->options.population < SIZE_MAX && i * s->n <= SIZE_MAX; */
    double *value = s->trial + s->options.population * s->n + i, *y = s->trial + i * s->n;
    double *draw = s->trial + s->options.population * s->n + s->options.population;
    /*@ assert work:   search_aside(s->trial, (s->options.population + 1) * (s->n + 1), s); */
    /*@ assert best:   search_aside(s->best, s->n, s); */
    /*@ assert inside: s->options.population * s->n + i < (s->options.population + 1) * (s->n + 1) &&
                       i * s->n + s->n <= s->options.population * s->n &&
                       s->options.population * s->n + s->options.population + s->n < (s->options.population + 1) * (s->n + 1); */
    /*@ assert value:  search_aside(value, 1, s); */
    build(y, draw, s, i, rng);
    /*@ assert values:  search_values{Pre, Here}(s); */
    /*@ assert centre:  search_centre{Here}(s); */
    /*@ assert own:     search_own{Here}(s); */
    /*@ assert falling: \le_double(s->best_value, \at(s->best_value, Pre)); */
    /*@ assert arrays:  et_search_arrays(s); */
    /*@ assert apart:   et_search_apart(s); */
    /*@ assert options: et_search_options_ok(s); */
    const et_status status = et_search_eval(value, s, y);
    /*@ assert values:  search_values{Pre, Here}(s); */
    /*@ assert centre:  search_centre{Here}(s); */
    /*@ assert own:     search_own{Here}(s); */
    /*@ assert falling: \le_double(s->best_value, \at(s->best_value, Pre)); */
    /*@ assert arrays:  et_search_arrays(s); */
    /*@ assert apart:   et_search_apart(s); */
    /*@ assert options: et_search_options_ok(s); */
    /*@ assert ordered: et_search_ordered(s); */
    return status;
}

et_status et_de_step(et_search *search, et_rng *rng)
{
    const size_t n = search->n, population = search->options.population;
    /*@ ghost fact_search(search); */
    /*@ ghost fact_order(); */
    /*@ assert cells:  (population + 1) * (n + 1) * sizeof(double) <= SIZE_MAX &&
                       (population + 1) * (n + 1) == (search->options.population + 1) * (search->n + 1); */
    /*@ loop invariant range:   0 <= i <= population && search->evaluations == \at(search->evaluations, Pre) + i;
        loop invariant same:    search->n == n && search->options.population == population && search->generation == \at(search->generation, Pre);
        loop invariant started: et_search_started(search);
        loop invariant rng:     et_search_rng(search, rng);
        loop invariant values:  search_values{Pre, Here}(search);
        loop invariant falling: \le_double(search->best_value, \at(search->best_value, Pre));
        loop assigns   i, search->trial[0 .. (population + 1) * (n + 1) - 1], search->best[0 .. n - 1], search->best_value,
                       search->evaluations, *rng;
        loop variant   population - i; */
    for (size_t i = 0; i < population; i++) {
        /*@ ghost fact_cells(search->options.population, search->n, population, n); */
        const et_status status = attempt(search, i, rng);
        /*@ assert values:  search_values{Pre, Here}(search); */
        /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
        if (status != ET_OK) return status;
    }
    /*@ assert work:   search_aside(search->x, population * n, search); */
    /*@ assert apart:  search->velocity == \null ||
                       \separated(search->value + (0 .. population - 1), search->remembered + (0 .. population - 1)); */
    select_better(search, search->trial, search->trial + population * n);
    /*@ assert values:  search_values{Pre, Here}(search); */
    /*@ assert centre:  search_centre{Here}(search); */
    /*@ assert own:     search_own{Here}(search); */
    /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
    search->generation++;
    /*@ assert arrays:  et_search_arrays(search); */
    /*@ assert apart:   et_search_apart(search); */
    /*@ assert options: et_search_options_ok(search); */
    /*@ assert ordered: et_search_ordered(search); */
    return ET_OK;
}
