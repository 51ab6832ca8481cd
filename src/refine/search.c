#include "etalon/refine/search.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 8 };

et_search_options et_search_defaults(void)
{
    et_search_options o = { .population = 40, .spread = 5e-6, .box = 5e-6, .group = 1,
                            .tournament = 4, .crossover = 0.7, .swap = 0.5, .mutation = 0.01,
                            .F = 0.3, .CR = 0.8, .by_coordinate = 0,
                            .K = 0.729, .c1 = 2.05, .c2 = 2.05, .vmax = 5e-6, .immediate = 0, .absorb = 0 };
    return o;
}

/*@ assigns \nothing; */
static int is_probability(double p)
{
    return p >= 0.0 && p <= 1.0;          /* false for NaN */
}

/*@ requires in:    \valid_read(o);
    assigns  \nothing;
    ensures  sizes: \result != 0 ==> 4 <= o->population && 1 <= n && 1 <= o->group && n % o->group == 0 && 1 <= o->tournament;
    ensures  reals: \result != 0 ==> \is_finite(o->spread) && o->spread >= 0 && \is_finite(o->box);
*/
static int options_valid(const et_search_options *o, size_t n)
{
    return o->population >= 4 && n >= 1 && o->group >= 1 && n % o->group == 0 && o->tournament >= 1
        && o->spread >= 0.0 && isfinite(o->spread) && isfinite(o->box)
        && is_probability(o->crossover) && is_probability(o->swap) && is_probability(o->mutation) && is_probability(o->CR)
        && isfinite(o->F) && isfinite(o->K) && isfinite(o->c1) && isfinite(o->c2) && isfinite(o->vmax);
}

void et_search_free(et_search *search)
{
    free(search->x0);
    free(search->x);
    free(search->value);
    free(search->trial);
    free(search->velocity);
    free(search->memory);
    free(search->remembered);
    free(search->best);
    memset(search, 0, sizeof *search);
}

static et_status search_allocate(et_search *s, size_t n, size_t population, int velocities)
{
    size_t cells = 0;
    if (et_size_mul(&cells, population + 1, n + 1) != ET_OK || population == SIZE_MAX || n == SIZE_MAX) return ET_ENOMEM;
    s->x0 = et_size_array(n, sizeof(double));
    s->x = et_size_array(population * n, sizeof(double));
    s->value = et_size_array(population, sizeof(double));
    s->trial = et_size_array(cells, sizeof(double));
    s->best = et_size_array(n, sizeof(double));
    int ok = s->x0 && s->x && s->value && s->trial && s->best;
    if (velocities) {
        s->velocity = et_size_array(population * n, sizeof(double));
        s->memory = et_size_array(population * n, sizeof(double));
        s->remembered = et_size_array(population, sizeof(double));
        ok = ok && s->velocity && s->memory && s->remembered;
    }
    return ok ? ET_OK : ET_ENOMEM;
}

void et_search_draw(double *x, const et_search *search, size_t first, size_t count, double radius, et_rng *rng)
{
    et_rng_fill(x, count, rng);
    /*@ loop invariant range: 0 <= k <= count;
        loop assigns   k, x[0 .. count - 1];
        loop variant   count - k; */
    for (size_t k = 0; k < count; k++) x[k] = search->x0[first + k] + radius * (2.0 * x[k] - 1.0);
}

/*@ assigns \nothing;
    ensures  none: \is_NaN(x) ==> \is_NaN(\result);
    ensures  ends: \is_NaN(x) || \eq_double(\result, x) || \eq_double(\result, lo) || \eq_double(\result, hi);
    ensures  hi:   !\is_NaN(x) && !\is_NaN(lo) && !\is_NaN(hi) ==> \le_double(\result, hi);
    ensures  lo:   !\is_NaN(x) && !\is_NaN(lo) && !\is_NaN(hi) && \le_double(lo, hi) ==> \ge_double(\result, lo);
*/
static double clamped(double x, double lo, double hi)
{
    const double y = x < lo ? lo : x;
    return y > hi ? hi : y;
}

/* Loops of a fixed count become vectors at any level of optimisation. */
/*@ requires inout: \valid(x + (0 .. n - 1)) && \valid_read(x0 + (0 .. n - 1)) && \separated(x + (0 .. n - 1), x0 + (0 .. n - 1));
    requires size:  n * sizeof(double) <= SIZE_MAX;
    assigns  x[0 .. n - 1];
    ensures  nan:   \forall integer k; 0 <= k < n && \is_NaN(\old(x[k])) ==> \is_NaN(x[k]);
*/
static void clamp(double *restrict x, const double *restrict x0, double box, size_t n)
{
    size_t k = 0;
    /*@ loop invariant range: 0 <= k <= n;
        loop invariant nan:   \forall integer j; 0 <= j < n && \is_NaN(\at(x[j], Pre)) ==> \is_NaN(x[j]);
        loop assigns   k, x[0 .. n - 1];
        loop variant   n - k; */
    for (; k + BLOCK <= n; k += BLOCK)
        /*@ loop invariant range: 0 <= i <= BLOCK;
            loop invariant nan:   \forall integer j; 0 <= j < n && \is_NaN(\at(x[j], Pre)) ==> \is_NaN(x[j]);
            loop assigns   i, x[0 .. n - 1];
            loop variant   BLOCK - i; */
        for (size_t i = 0; i < BLOCK; i++) x[k + i] = clamped(x[k + i], x0[k + i] - box, x0[k + i] + box);
    /*@ loop invariant range: 0 <= k <= n;
        loop invariant nan:   \forall integer j; 0 <= j < n && \is_NaN(\at(x[j], Pre)) ==> \is_NaN(x[j]);
        loop assigns   k, x[0 .. n - 1];
        loop variant   n - k; */
    for (; k < n; k++) x[k] = clamped(x[k], x0[k] - box, x0[k] + box);
}

void et_search_clamp(double *x, const et_search *search)
{
    if (search->options.box > 0.0) clamp(x, search->x0, search->options.box, search->n);
}

et_status et_search_eval(double *value, et_search *search, const double *x)
{
    double v = 0.0;
    et_status status;
    /*@ assert any: search->fn == &search_any_fn; */
    /*@ calls search_any_fn; */
    status = search->fn(&v, x, search->n, search->context);
    if (status != ET_OK) return status;
    if (isnan(v)) return ET_EINVAL;       /* an order must exist, or no best does */
    if (search->evaluations == 0 || v < search->best_value) {
        memcpy(search->best, x, search->n * sizeof *x);
        search->best_value = v;
    }
    search->evaluations++;
    *value = v;
    return ET_OK;
}

static et_status population_draw(et_search *s, et_rng *rng)
{
    const size_t n = s->n;
    for (size_t i = 0; i < s->options.population; i++) {
        et_search_draw(s->x + i * n, s, 0, n, s->options.spread, rng);
        et_search_clamp(s->x + i * n, s);
        const et_status status = et_search_eval(&s->value[i], s, s->x + i * n);
        if (status != ET_OK) return status;
    }
    if (s->memory) {
        memcpy(s->memory, s->x, s->options.population * n * sizeof(double));
        memcpy(s->remembered, s->value, s->options.population * sizeof(double));
    }
    return ET_OK;
}

et_status et_search_start(et_search *search, const double *x0, size_t n, const et_search_options *options, int velocities,
                          et_search_fn fn, void *context, et_rng *rng)
{
    if (!search || !x0 || !options || !fn || !rng || !options_valid(options, n)) return ET_EINVAL;
    et_search s;
    memset(&s, 0, sizeof s);
    s.options = *options;
    s.n = n;
    s.fn = fn;
    s.context = context;
    et_status status = search_allocate(&s, n, options->population, velocities);
    if (status == ET_OK) {
        memcpy(s.x0, x0, n * sizeof *x0);
        status = population_draw(&s, rng);
    }
    if (status != ET_OK) {
        et_search_free(&s);
        return status;
    }
    *search = s;
    return ET_OK;
}

/*@ ghost
  /@ requires valid:    n == 0 || \valid(a + (0 .. n - 1));
     requires none:     b == \null;
     assigns  \nothing;
     ensures  apart:    \forall integer m; \separated(a + (0 .. n - 1), b + (0 .. m - 1)); @/
  static void fact_null(const double *a, size_t n, const double *b) {}
*/
et_status et_search_run(et_search *search, size_t *made, double *history, size_t generations, et_search_step step, et_rng *rng, const et_task *task)
{
    /*@ ghost const size_t population = search->options.population; */
    /*@ ghost
        if (history && !search->velocity) {
            fact_null(history, generations, search->velocity);
            fact_null(history, generations, search->memory);
            fact_null(history, generations, search->remembered);
        } */
    /*@ assert room:    search->evaluations + generations * population <= UINT64_MAX; */
    /*@ assert own:     history == \null || (\separated(history + (0 .. generations - 1), search->velocity + (0 .. population * search->n - 1))
                        && \separated(history + (0 .. generations - 1), search->memory + (0 .. population * search->n - 1))
                        && \separated(history + (0 .. generations - 1), search->remembered + (0 .. population - 1))); */
    *made = 0;
    /*@ assert arrays:  et_search_arrays(search) && et_search_apart(search); */
    /*@ assert options: et_search_options_ok(search); */
    /*@ assert ordered: et_search_ordered(search); */
    /*@ loop invariant range:   0 <= g <= generations && *made == g;
        loop invariant same:    search->options.population == population && search->n == \at(search->n, Pre);
        loop invariant started: et_search_started(search);
        loop invariant count:   search->generation <= \at(search->generation, Pre) + g;
        loop invariant room:    search->evaluations <= \at(search->evaluations, Pre) + g * population;
        loop invariant best:    \le_double(search->best_value, \at(search->best_value, Pre));
        loop invariant falling: history != \null ==> \forall integer h, k; 0 <= k < h < g ==> \le_double(history[h], history[k]);
        loop invariant start:   history != \null ==> \forall integer h; 0 <= h < g ==> \le_double(history[h], \at(search->best_value, Pre));
        loop invariant last:    history != \null && 0 < g ==> \eq_double(history[g - 1], search->best_value);
        loop invariant least:   history != \null ==> \forall integer h; 0 <= h < g ==> \le_double(search->best_value, history[h]);
        loop assigns   g, search->best_value, search->generation, search->evaluations, *made, history[0 .. generations - 1], *rng,
                       search->x[0 .. \at(search->options.population * search->n, Pre) - 1],
                       search->value[0 .. \at(search->options.population, Pre) - 1],
                       search->velocity[0 .. \at(search->options.population * search->n, Pre) - 1],
                       search->memory[0 .. \at(search->options.population * search->n, Pre) - 1],
                       search->remembered[0 .. \at(search->options.population, Pre) - 1],
                       search->trial[0 .. \at((search->options.population + 1) * (search->n + 1), Pre) - 1],
                       search->best[0 .. \at(search->n, Pre) - 1];
        loop variant   generations - g; */
    for (size_t g = 0; g < generations; g++) {
        et_status status;
        /*@ ghost fact_product(g + 1, generations, population); */
        /*@ assert next: g * population + population <= generations * population; */
        /*@ assert room: search->evaluations + search->options.population <= UINT64_MAX; */
        /*@ ghost const double before = search->best_value; */
        /*@ assert frame:   history != \null ==> \forall integer h; 0 <= h < g ==>
                            \separated(history + h, search); */
        /*@ assert frame:   history != \null ==> \forall integer h; 0 <= h < g ==>
                            \separated(history + h, search->x + (0 .. search->options.population * search->n - 1)); */
        /*@ assert frame:   history != \null ==> \forall integer h; 0 <= h < g ==>
                            \separated(history + h, search->value + (0 .. search->options.population - 1)); */
        /*@ assert frame:   history != \null ==> \forall integer h; 0 <= h < g ==>
                            \separated(history + h, search->velocity + (0 .. search->options.population * search->n - 1)); */
        /*@ assert frame:   history != \null ==> \forall integer h; 0 <= h < g ==>
                            \separated(history + h, search->memory + (0 .. search->options.population * search->n - 1)); */
        /*@ assert frame:   history != \null ==> \forall integer h; 0 <= h < g ==>
                            \separated(history + h, search->remembered + (0 .. search->options.population - 1)); */
        /*@ assert frame:   history != \null ==> \forall integer h; 0 <= h < g ==>
                            \separated(history + h, search->trial + (0 .. (search->options.population + 1) * (search->n + 1) - 1)); */
        /*@ assert frame:   history != \null ==> \forall integer h; 0 <= h < g ==>
                            \separated(history + h, search->best + (0 .. search->n - 1)); */
        /*@ assert any: step == &search_any_step; */
        /*@ calls search_any_step; */
        status = step(search, rng);
        /*@ assert best:    \le_double(search->best_value, before) && \le_double(search->best_value, \at(search->best_value, Pre)); */
        /*@ assert start:   history != \null ==> \forall integer h; 0 <= h < g ==> \le_double(history[h], \at(search->best_value, Pre)); */
        /*@ assert falling: history != \null ==> \forall integer h, k; 0 <= k < h < g ==> \le_double(history[h], history[k]); */
        /*@ assert before:  history != \null ==> \forall integer h; 0 <= h < g ==> \le_double(before, history[h]); */
        /*@ assert least:   history != \null ==> \forall integer h; 0 <= h < g ==> \le_double(search->best_value, history[h]); */
        if (status != ET_OK) return status;
        /*@ assert same:    search->options.population == population && search->n == \at(search->n, Pre); */
        /*@ assert room:    search->evaluations <= \at(search->evaluations, Pre) + g * population + population; */
        if (history) {
            history[g] = search->best_value;
            /*@ assert start:   \forall integer h; 0 <= h <= g ==> \le_double(history[h], \at(search->best_value, Pre)); */
            /*@ assert below:   \forall integer h, k; 0 <= k < h < g ==> \le_double(history[h], history[k]); */
            /*@ assert least:   \forall integer h; 0 <= h <= g ==> \le_double(search->best_value, history[h]); */
            /*@ assert falling: \forall integer h, k; 0 <= k < h <= g ==> \le_double(history[h], history[k]); */
        }
        /*@ assert arrays:  et_search_arrays(search) && et_search_apart(search); */
        /*@ assert options: et_search_options_ok(search); */
        /*@ assert ordered: et_search_ordered(search); */
        *made = g + 1;
        /*@ assert arrays:  et_search_arrays(search) && et_search_apart(search); */
        /*@ assert options: et_search_options_ok(search); */
        /*@ assert ordered: et_search_ordered(search); */
        status = et_task_step(task, g + 1, generations);
        if (status != ET_OK) return status;
    }
    return ET_OK;
}
