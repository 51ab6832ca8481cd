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

/* Particle i: its new velocity, and where that takes it, in the workspace behind the best of before. */
/*@ requires search: et_search_started(s) && et_search_rng(s, rng) && s->velocity != \null && i < s->options.population;
    assigns  s->velocity[0 .. s->options.population * s->n - 1], s->trial[0 .. 4 * s->n - 1], *rng;
*/
static void steer(et_search *s, size_t i, et_rng *rng)
{
    const et_search_options *o = &s->options;
    const coefficients c = { o->K, o->c1, o->c2 };
    const size_t n = s->n;
    /*@ ghost fact_search(s); */
    /*@ ghost fact_slot(i, o->population, n); */
    double *before = s->trial, *y = before + n, *r = y + n, *x = s->x + i * n, *v = s->velocity + i * n;
    const double *all = o->immediate ? s->best : before;
    et_rng_fill(r, 2 * n, rng);
    accelerate(v, x, s->memory + i * n, all, r, c, n);
    limit(v, o->vmax, n);
    move(y, v, x, s);
}

et_status et_pso_step(et_search *search, et_rng *rng)
{
    if (!search->velocity) return ET_EINVAL;
    const size_t n = search->n, population = search->options.population;
    /*@ ghost fact_search(search); */
    /*@ ghost fact_order(); */
    double *before = search->trial, *y = before + n, *value = y + 3 * n;
    /*@ assert work:   search_aside(search->trial, (population + 1) * (n + 1), search); */
    /*@ assert best:   search_aside(search->best, n, search); */
    /*@ assert speed:  search_aside(search->velocity, population * n, search); */
    memcpy(before, search->best, n * sizeof *before);
    /*@ loop invariant range:   0 <= i <= population && search->evaluations == \at(search->evaluations, Pre) + i;
        loop invariant same:    search->n == n && search->options.population == population && search->generation == \at(search->generation, Pre);
        loop invariant rng:     et_search_rng(search, rng);
        loop invariant values:  \forall integer j; 0 <= j < population ==> !\is_NaN(search->value[j]);
        loop invariant own:     \forall integer j; 0 <= j < population ==> \le_double(search->remembered[j], \at(search->remembered[j], Pre));
        loop invariant centre:  search_centre{Here}(search);
        loop invariant falling: \le_double(search->best_value, \at(search->best_value, Pre));
        loop invariant arrays:  et_search_arrays(search);
        loop invariant apart:   et_search_apart(search);
        loop invariant options: et_search_options_ok(search);
        loop invariant ordered: et_search_ordered(search);
        loop assigns   i, search->x[0 .. population * n - 1], search->value[0 .. population - 1], search->velocity[0 .. population * n - 1],
                       search->memory[0 .. population * n - 1], search->remembered[0 .. population - 1],
                       search->trial[0 .. (population + 1) * (n + 1) - 1], search->best[0 .. n - 1], search->best_value,
                       search->evaluations, *rng;
        loop variant   population - i; */
    for (size_t i = 0; i < population; i++) {
        steer(search, i, rng);
        /*@ assert values:  \forall integer j; 0 <= j < population ==> !\is_NaN(search->value[j]); */
        /*@ assert own:     \forall integer j; 0 <= j < population ==> \le_double(search->remembered[j], \at(search->remembered[j], Pre)); */
        /*@ assert centre:  search_centre{Here}(search); */
        /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
        /*@ assert arrays:  et_search_arrays(search); */
        /*@ assert apart:   et_search_apart(search); */
        /*@ assert options: et_search_options_ok(search); */
        /*@ assert ordered: et_search_ordered(search); */
        const et_status status = et_search_eval(value, search, y);
        /*@ assert values:  \forall integer j; 0 <= j < population ==> !\is_NaN(search->value[j]); */
        /*@ assert own:     \forall integer j; 0 <= j < population ==> \le_double(search->remembered[j], \at(search->remembered[j], Pre)); */
        /*@ assert centre:  search_centre{Here}(search); */
        /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
        /*@ assert arrays:  et_search_arrays(search); */
        /*@ assert apart:   et_search_apart(search); */
        /*@ assert options: et_search_options_ok(search); */
        /*@ assert ordered: et_search_ordered(search); */
        if (status != ET_OK) return status;
        settle(search, i, y, *value);
        /*@ assert values:  \forall integer j; 0 <= j < population ==> !\is_NaN(search->value[j]); */
        /*@ assert own:     \forall integer j; 0 <= j < population ==> \le_double(search->remembered[j], \at(search->remembered[j], Pre)); */
        /*@ assert centre:  search_centre{Here}(search); */
        /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
        /*@ assert arrays:  et_search_arrays(search); */
        /*@ assert apart:   et_search_apart(search); */
        /*@ assert options: et_search_options_ok(search); */
        /*@ assert ordered: et_search_ordered(search); */
    }
    search->generation++;
    /*@ assert values:  \forall integer j; 0 <= j < population ==> !\is_NaN(search->value[j]); */
    /*@ assert own:     \forall integer j; 0 <= j < population ==> \le_double(search->remembered[j], \at(search->remembered[j], Pre)); */
    /*@ assert centre:  search_centre{Here}(search); */
    /*@ assert falling: \le_double(search->best_value, \at(search->best_value, Pre)); */
    /*@ assert arrays:  et_search_arrays(search); */
    /*@ assert apart:   et_search_apart(search); */
    /*@ assert options: et_search_options_ok(search); */
    /*@ assert ordered: et_search_ordered(search); */
    return ET_OK;
}
