#include "etalon/refine/pso.h"
#include <string.h>

enum { BLOCK = 8 };                       /* loops of a fixed count become vectors at any level of optimisation */

typedef struct { double K, c1, c2; } coefficients;

/* v = K (v + c1 r1 (own - x) + c2 r2 (all - x)), r1 = r[0..n-1], r2 = r[n..2n-1] */
/*@ requires size:  2 * n * sizeof(double) <= SIZE_MAX;
    requires in:    \valid_read(x + (0 .. n - 1)) && \valid_read(own + (0 .. n - 1)) && \valid_read(all + (0 .. n - 1)) &&
                    \valid_read(r + (0 .. 2 * n - 1));
    requires out:   \valid(v + (0 .. n - 1)) && \separated(v + (0 .. n - 1), x + (0 .. n - 1)) && \separated(v + (0 .. n - 1), own + (0 .. n - 1))
                    && \separated(v + (0 .. n - 1), all + (0 .. n - 1)) && \separated(v + (0 .. n - 1), r + (0 .. 2 * n - 1));
    assigns  v[0 .. n - 1];
*/
static void accelerate(double *restrict v, const double *restrict x, const double *restrict own, const double *restrict all, const double *restrict r,
                       coefficients c, size_t n)
{
    const double *restrict r2 = r + n;
    size_t k = 0;
    /*@ loop invariant range: 0 <= k <= n;
        loop assigns   k, v[0 .. n - 1];
        loop variant   n - k; */
    for (; k + BLOCK <= n; k += BLOCK)
        /*@ loop invariant range: 0 <= i <= BLOCK;
            loop assigns   i, v[0 .. n - 1];
            loop variant   BLOCK - i; */
        for (size_t i = 0; i < BLOCK; i++)
            v[k + i] = c.K * ((v[k + i] + c.c1 * r[k + i] * (own[k + i] - x[k + i])) + c.c2 * r2[k + i] * (all[k + i] - x[k + i]));
    /*@ loop invariant range: 0 <= k <= n;
        loop assigns   k, v[0 .. n - 1];
        loop variant   n - k; */
    for (; k < n; k++) v[k] = c.K * ((v[k] + c.c1 * r[k] * (own[k] - x[k])) + c.c2 * r2[k] * (all[k] - x[k]));
}

/*@ requires inout: \valid(v + (0 .. n - 1));
    assigns  v[0 .. n - 1];
*/
static void limit(double *v, double vmax, size_t n)
{
    if (!(vmax > 0.0)) return;
    /*@ loop invariant range: 0 <= k <= n;
        loop assigns   k, v[0 .. n - 1];
        loop variant   n - k; */
    for (size_t k = 0; k < n; k++) {
        const double w = v[k] < -vmax ? -vmax : v[k];
        v[k] = w > vmax ? vmax : w;
    }
}

/* y = x + v in the box */
/*@ requires search: et_search_arrays(s) && et_search_options_ok(s);
    requires inout:  \valid(y + (0 .. s->n - 1)) && \valid(v + (0 .. s->n - 1)) && \valid_read(x + (0 .. s->n - 1));
    requires apart:  \separated(y + (0 .. s->n - 1), v + (0 .. s->n - 1), s, s->x0 + (0 .. s->n - 1));
    assigns  y[0 .. s->n - 1], v[0 .. s->n - 1];
*/
static void move(double *y, double *v, const double *x, const et_search *s)
{
    /*@ loop invariant range: 0 <= k <= s->n;
        loop assigns   k, y[0 .. s->n - 1];
        loop variant   s->n - k; */
    for (size_t k = 0; k < s->n; k++) y[k] = x[k] + v[k];
    et_search_clamp(y, s);
    if (!s->options.absorb) return;
    /*@ loop invariant range: 0 <= k <= s->n;
        loop assigns   k, v[0 .. s->n - 1];
        loop variant   s->n - k; */
    for (size_t k = 0; k < s->n; k++) v[k] = y[k] == x[k] + v[k] ? v[k] : 0.0;
}

/*@ requires search: et_search_started(s) && s->velocity != \null && i < s->options.population;
    requires moved:  \valid_read(y + (0 .. s->n - 1)) && !\is_NaN(value);
    requires apart:  \separated(y + (0 .. s->n - 1), s, s->x + (0 .. s->options.population * s->n - 1), s->value + (0 .. s->options.population - 1),
                                s->memory + (0 .. s->options.population * s->n - 1), s->remembered + (0 .. s->options.population - 1));
    assigns  s->x[0 .. s->options.population * s->n - 1], s->value[i], s->memory[0 .. s->options.population * s->n - 1], s->remembered[i];
    ensures  value:  !\is_NaN(s->value[i]);
    ensures  own:    \le_double(s->remembered[i], \old(s->remembered[i]));
*/
static void settle(et_search *s, size_t i, const double *y, double value)
{
    const size_t n = s->n;
    /*@ ghost fact_search(s); */
    /*@ ghost fact_slot(i, s->options.population, n); */
    memcpy(s->x + i * n, y, n * sizeof *y);
    s->value[i] = value;
    if (!(value < s->remembered[i])) return;
    /*@ assert apart: \separated(s->memory + (i * n .. i * n + n - 1), s->remembered + (0 .. s->options.population - 1)); */
    memcpy(s->memory + i * n, y, n * sizeof *y);
    s->remembered[i] = value;
}

/* Particle i of the velocity v: v anew, and y, where that takes it; r: room for 2n draws. */
/*@ requires search: et_search_arrays(s) && et_search_options_ok(s) && s->velocity != \null && i < s->options.population && \valid(rng);
    requires all:    \valid_read(all + (0 .. s->n - 1)) && \separated(v + (0 .. s->n - 1), all + (0 .. s->n - 1));
    requires room:   \valid(v + (0 .. s->n - 1)) && \valid(y + (0 .. s->n - 1)) && \valid(r + (0 .. 2 * s->n - 1));
    requires apart:  \separated(v + (0 .. s->n - 1), y + (0 .. s->n - 1), r + (0 .. 2 * s->n - 1), s, rng, s->x0 + (0 .. s->n - 1));
    requires own:    \separated(v + (0 .. s->n - 1), s->x + (0 .. s->options.population * s->n - 1)) &&
                     \separated(v + (0 .. s->n - 1), s->memory + (0 .. s->options.population * s->n - 1));
    assigns  v[0 .. s->n - 1], y[0 .. s->n - 1], r[0 .. 2 * s->n - 1], *rng;
*/
static void steer(double *v, double *y, double *r, const et_search *s, size_t i, const double *all, et_rng *rng)
{
    const et_search_options *o = &s->options;
    const coefficients c = { o->K, o->c1, o->c2 };
    const size_t n = s->n;
    /*@ ghost fact_search(s); */
    /*@ ghost fact_slot(i, o->population, n); */
    const double *x = s->x + i * n;
    et_rng_fill(r, 2 * n, rng);
    /*@ assert centre: search_centre{Here}(s); */
    accelerate(v, x, s->memory + i * n, all, r, c, n);
    /*@ assert centre: search_centre{Here}(s); */
    limit(v, o->vmax, n);
    /*@ assert centre: search_centre{Here}(s); */
    move(y, v, x, s);
}

/* Particle i flies: its next place, in the workspace behind the best of before, evaluated and settled. */
/*@ requires search: et_search_started(s) && et_search_rng(s, rng) && s->velocity != \null && i < s->options.population
                     && s->evaluations < UINT64_MAX;
    assigns  s->x[0 .. s->options.population * s->n - 1], s->value[i], s->velocity[0 .. s->options.population * s->n - 1],
             s->memory[0 .. s->options.population * s->n - 1], s->remembered[i], s->trial[0 .. (s->options.population + 1) * (s->n + 1) - 1],
             s->best[0 .. s->n - 1], s->best_value, s->evaluations, *rng;
    ensures  count:   \result == ET_OK ==> s->evaluations == \old(s->evaluations) + 1;
    ensures  started: et_search_started(s);
    ensures  falling: \le_double(s->best_value, \old(s->best_value));
    ensures  own:     \le_double(s->remembered[i], \old(s->remembered[i]));
*/
static et_status fly(et_search *s, size_t i, et_rng *rng)
{
    const size_t n = s->n;
    /*@ ghost size_t population = s->options.population; */
    /*@ ghost fact_search(s); */
    /*@ ghost fact_slot(i, population, n); */
    /*@ ghost fact_order(); */
    /*@ assert size:   4 * n < (s->options.population + 1) * (n + 1) && 4 * n <= SIZE_MAX && i * n <= SIZE_MAX; */
    double *before = s->trial, *y = before + n, *r = y + n, *value = r + 2 * n, *v = s->velocity + i * n;
    const double *all = s->options.immediate ? s->best : before;
    /*@ assert work:   search_aside(s->trial, (s->options.population + 1) * (s->n + 1), s); */
    /*@ assert best:   search_aside(s->best, s->n, s); */
    /*@ assert speed:  search_aside(v, n, s); */
    /*@ assert inside: i * n + n <= s->options.population * n && 4 * n + 1 <= (s->options.population + 1) * (n + 1); */
    /*@ assert within: y == s->trial + n && r == s->trial + 2 * n && value == s->trial + 4 * n && v == s->velocity + i * n; */
    steer(v, y, r, s, i, all, rng);
    /*@ ghost fact_cells(s->options.population, s->n, population, n); */
    /*@ ghost fact_places(s->options.population, s->n, population, n); */
    /*@ assert values:  \forall integer k; 0 <= k < s->options.population ==> !\is_NaN(s->value[k]); */
    /*@ assert centre:  search_centre{Here}(s); */
    /*@ assert own:     search_own{Here}(s) && \le_double(s->remembered[i], \at(s->remembered[i], Pre)); */
    /*@ assert falling: \le_double(s->best_value, \at(s->best_value, Pre)); */
    /*@ assert arrays:  et_search_arrays(s); */
    /*@ assert apart:   et_search_apart(s); */
    /*@ assert options: et_search_options_ok(s); */
    const et_status status = et_search_eval(value, s, y);
    /*@ assert values:  \forall integer k; 0 <= k < s->options.population ==> !\is_NaN(s->value[k]); */
    /*@ assert centre:  search_centre{Here}(s); */
    /*@ assert own:     search_own{Here}(s) && \le_double(s->remembered[i], \at(s->remembered[i], Pre)); */
    /*@ assert falling: \le_double(s->best_value, \at(s->best_value, Pre)); */
    /*@ assert arrays:  et_search_arrays(s); */
    /*@ assert apart:   et_search_apart(s); */
    /*@ assert options: et_search_options_ok(s); */
    /*@ assert ordered: et_search_ordered(s); */
    if (status != ET_OK) return status;
    /*@ ghost fact_places(s->options.population, s->n, population, n); */
    /*@ assert places: search_aside(s->x, s->options.population * n, s) && search_aside(s->memory, s->options.population * n, s); */
    settle(s, i, y, *value);
    /*@ assert values:  \forall integer k; 0 <= k < s->options.population ==> !\is_NaN(s->value[k]); */
    /*@ assert centre:  search_centre{Here}(s); */
    /*@ assert own:     search_own{Here}(s) && \le_double(s->remembered[i], \at(s->remembered[i], Pre)); */
    /*@ assert falling: \le_double(s->best_value, \at(s->best_value, Pre)); */
    /*@ assert arrays:  et_search_arrays(s); */
    /*@ assert apart:   et_search_apart(s); */
    /*@ assert options: et_search_options_ok(s); */
    /*@ assert ordered: et_search_ordered(s); */
    return ET_OK;
}

et_status et_pso_step(et_search *search, et_rng *rng)
{
    if (!search->velocity) return ET_EINVAL;
    const size_t n = search->n, population = search->options.population;
    /*@ ghost fact_search(search); */
    /*@ ghost fact_order(); */
    /*@ assert cells:  (population + 1) * (n + 1) * sizeof(double) <= SIZE_MAX &&
                       (population + 1) * (n + 1) == (search->options.population + 1) * (search->n + 1); */
    /*@ assert work:   search_aside(search->trial, (population + 1) * (n + 1), search); */
    memcpy(search->trial, search->best, n * sizeof(double));
    /*@ assert centre: search_centre{Here}(search); */
    /*@ assert own:    search_own{Here}(search); */
    /*@ loop invariant range:   0 <= i <= population && search->evaluations == \at(search->evaluations, Pre) + i;
        loop invariant same:    search->n == n && search->options.population == population && search->generation == \at(search->generation, Pre)
                                && search->velocity != \null;
        loop invariant started: et_search_started(search);
        loop invariant rng:     et_search_rng(search, rng);
        loop invariant own:     \forall integer j; 0 <= j < population ==> \le_double(search->remembered[j], \at(search->remembered[j], Pre));
        loop invariant falling: \le_double(search->best_value, \at(search->best_value, Pre));
        loop assigns   i, search->x[0 .. population * n - 1], search->value[0 .. population - 1], search->velocity[0 .. population * n - 1],
                       search->memory[0 .. population * n - 1], search->remembered[0 .. population - 1],
                       search->trial[0 .. (population + 1) * (n + 1) - 1], search->best[0 .. n - 1], search->best_value,
                       search->evaluations, *rng;
        loop variant   population - i; */
    for (size_t i = 0; i < population; i++) {
        /*@ ghost fact_cells(search->options.population, search->n, population, n); */
        /*@ ghost fact_places(search->options.population, search->n, population, n); */
        /*@ assert places:  search_aside(search->x, population * n, search); */
        /*@ assert memory:  search_aside(search->memory, population * n, search); */
        /*@ assert speed:   search_aside(search->velocity, population * n, search); */
        /*@ assert work:    search_aside(search->trial, (population + 1) * (n + 1), search) && search_aside(search->best, n, search); */
        /*@ assert values:  \forall integer j; 0 <= j < population ==> \separated(search->value + i, search->remembered + j); */
        const et_status status = fly(search, i, rng);
        /*@ assert others:  \forall integer j; 0 <= j < population && j != i ==>
                            \le_double(search->remembered[j], \at(search->remembered[j], Pre)); */
        /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
        if (status != ET_OK) return status;
    }
    search->generation++;
    /*@ assert arrays:  et_search_arrays(search); */
    /*@ assert apart:   et_search_apart(search); */
    /*@ assert options: et_search_options_ok(search); */
    /*@ assert ordered: et_search_ordered(search); */
    return ET_OK;
}
