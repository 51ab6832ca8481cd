/* search: what the population searches ga, de and pso share: a callback objective, a population, a history, one generation at a time.
 *
 * A search is started, stepped generation by generation, and freed; `best` is at all times the best seen.  N steps of one generation equal
 * one run of N generations, bit for bit: everything that a generation depends on is in the struct and in the rng.  A search is saved as its
 * numbers (x0, x, value, best, best_value, generation, evaluations; for pso also velocity, memory, remembered) and the rng as (seed, draws).
 *
 * The value of x must be determined by x alone.  Values may be infinite (a penalty), not NaN: a NaN ends the search with ET_EINVAL.
 */
#ifndef ETALON_REFINE_SEARCH_H
#define ETALON_REFINE_SEARCH_H
#include "etalon/base/rng.h"
#include "etalon/base/status.h"
#include "etalon/base/task.h"
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

/* *value = f(x), x of n coordinates.  Anything but ET_OK ends the search.  It writes *value and its own memory only: nothing else that the search
 * reads or writes. */
typedef et_status (*et_search_fn)(double *value, const double *x, size_t n, void *context);

typedef struct {
    size_t population;                    /* >= 4, default 40 */
    double spread;                        /* start: x0 + U(-spread, spread) per coordinate, default 5e-6 */
    double box;                           /* every coordinate stays within x0 +- box; <= 0: no box.  Default 5e-6 (the source's) */
    size_t group;                         /* coordinates to a gene (3: a control point), divides n; default 1 */
    /* ga */
    size_t tournament;                    /* 4 */
    double crossover, swap, mutation;     /* 0.7, 0.5, 0.01 */
    /* de */
    double F, CR;                         /* 0.3, 0.8 */
    int by_coordinate;                    /* 0: crossover per gene; 1: per coordinate */
    /* pso */
    double K, c1, c2;                     /* 0.729, 2.05, 2.05 */
    double vmax;                          /* greatest |velocity| per coordinate; default 5e-6; <= 0: none */
    int immediate;                        /* 0 (default): the swarm's best is that of the generation before; 1: the best so far */
    int absorb;                           /* 0 (default): a clamped coordinate keeps its velocity; 1: it loses it */
} et_search_options;

typedef struct {
    et_search_options options;
    size_t n;                             /* coordinates */
    et_search_fn fn; void *context;
    double *x0;                           /* n: the centre of start and box */
    double *x, *value;                    /* population*n, population: individuals and their values */
    double *trial;                        /* workspace of the algorithm: (population+1)*(n+1), nothing in it outlives a step */
    double *velocity, *memory, *remembered;   /* pso: velocities, personal bests and their values; else null */
    double *best; double best_value;      /* the best seen */
    size_t generation;                    /* generations made */
    uint64_t evaluations;                 /* values obtained */
} et_search;

/*@ predicate et_search_arrays(et_search *s) =
        \valid(s) && 4 <= s->options.population && 1 <= s->n && s->n * sizeof(double) <= SIZE_MAX &&
        (s->options.population + 1) * (s->n + 1) * sizeof(double) <= SIZE_MAX &&
        \valid(s->x + (0 .. s->options.population * s->n - 1)) && \valid(s->value + (0 .. s->options.population - 1)) &&
        \valid(s->trial + (0 .. (s->options.population + 1) * (s->n + 1) - 1)) &&
        \valid(s->x0 + (0 .. s->n - 1)) && \valid(s->best + (0 .. s->n - 1)) &&
        (s->velocity == \null || (\valid(s->velocity + (0 .. s->options.population * s->n - 1)) &&
                                  \valid(s->memory + (0 .. s->options.population * s->n - 1)) &&
                                  \valid(s->remembered + (0 .. s->options.population - 1))));

    predicate et_search_apart(et_search *s) =
        \separated(s, s->x0 + (0 .. s->n - 1), s->x + (0 .. s->options.population * s->n - 1), s->value + (0 .. s->options.population - 1),
                   s->trial + (0 .. (s->options.population + 1) * (s->n + 1) - 1), s->best + (0 .. s->n - 1)) &&
        (s->velocity == \null ||
         \separated(s, s->x0 + (0 .. s->n - 1), s->x + (0 .. s->options.population * s->n - 1), s->value + (0 .. s->options.population - 1),
                    s->trial + (0 .. (s->options.population + 1) * (s->n + 1) - 1), s->best + (0 .. s->n - 1),
                    s->velocity + (0 .. s->options.population * s->n - 1), s->memory + (0 .. s->options.population * s->n - 1),
                    s->remembered + (0 .. s->options.population - 1)));

    predicate et_search_options_ok(et_search *s) =
        1 <= s->options.tournament && 1 <= s->options.group && s->n % s->options.group == 0 &&
        \is_finite(s->options.spread) && s->options.spread >= 0 && \is_finite(s->options.box) &&
        (\forall integer k; 0 <= k < s->n ==> \is_finite(s->x0[k]));

    predicate et_search_ordered(et_search *s) =
        !\is_NaN(s->best_value) && (\forall integer i; 0 <= i < s->options.population ==> !\is_NaN(s->value[i])) &&
        (s->velocity == \null || \forall integer i; 0 <= i < s->options.population ==> !\is_NaN(s->remembered[i]));

    predicate et_search_started(et_search *s) =
        et_search_arrays(s) && et_search_apart(s) && et_search_options_ok(s) && et_search_ordered(s) && 1 <= s->evaluations;

    predicate et_search_rng(et_search *s, et_rng *rng) =
        \valid(rng) && \separated(rng, s, s->x0 + (0 .. s->n - 1), s->x + (0 .. s->options.population * s->n - 1),
                                  s->value + (0 .. s->options.population - 1), s->best + (0 .. s->n - 1),
                                  s->trial + (0 .. (s->options.population + 1) * (s->n + 1) - 1)) &&
        (s->velocity == \null || \separated(rng, s->velocity + (0 .. s->options.population * s->n - 1),
                                            s->memory + (0 .. s->options.population * s->n - 1), s->remembered + (0 .. s->options.population - 1)));
*/

/* The values of the source's Table 6.1 with the readings of docs/search.md, one coordinate to a gene. */
/*@ assigns \nothing;
    ensures population: \result.population == 40;
    ensures lengths:    \result.spread == (double)5e-6 && \result.box == (double)5e-6 && \result.vmax == (double)5e-6;
    ensures gene:       \result.group == 1 && \result.by_coordinate == 0;
    ensures ga:         \result.tournament == 4 && \result.crossover == (double)0.7 && \result.swap == 0.5 && \result.mutation == (double)0.01;
    ensures de:         \result.F == (double)0.3 && \result.CR == (double)0.8;
    ensures pso:        \result.K == (double)0.729 && \result.c1 == (double)2.05 && \result.c2 == (double)2.05;
    ensures variants:   \result.immediate == 0 && \result.absorb == 0;
*/
et_search_options et_search_defaults(void);

/* Allocate, draw the start population around x0 (one individual after the other, et_search_draw with radius spread, then et_search_clamp) and
 * evaluate it.  velocities: 1 for pso; they start at 0.  ET_EINVAL: population < 4, n == 0, group 0 or no divisor of n, tournament 0, spread
 * negative, a probability outside [0, 1], a constant not finite, a null pointer (context may be null), a NaN from fn.  ET_ENOMEM.  fn's own
 * status.  Whatever fails, *search is as it was. */
/*@ requires out:    \valid(search);
    requires x0:     \valid_read(x0 + (0 .. n - 1));
    requires finite: \forall integer k; 0 <= k < n ==> \is_finite(x0[k]);
    requires in:     \valid_read(options) && \valid(rng);
    requires apart:  \separated(search, x0 + (0 .. n - 1), options, rng);
    assigns  *search, *rng;
    ensures  made:   \result == ET_OK ==> et_search_started(search);
    ensures  size:   \result == ET_OK ==> search->n == n && search->options.population == options->population;
    ensures  start:  \result == ET_OK ==> search->generation == 0 && search->evaluations == options->population;
    ensures  best:   \result == ET_OK ==> \forall integer i; 0 <= i < options->population ==> \le_double(search->best_value, search->value[i]);
    ensures  memory: \result == ET_OK ==> (search->velocity == \null <==> velocities == 0);
    ensures  nulls:  \result == ET_OK && velocities == 0 ==> search->memory == \null && search->remembered == \null;
    ensures  same:   \result != ET_OK ==> *search == \old(*search);
*/
et_status et_search_start(et_search *search, const double *x0, size_t n, const et_search_options *options, int velocities,
                          et_search_fn fn, void *context, et_rng *rng);

/* Free what et_search_start allocated and zero the struct; a zeroed struct may be freed.  Golden: none (nothing is computed). */
/*@ requires search: \valid(search);
    assigns  *search;
    ensures  zero:   search->x == \null && search->best == \null && search->velocity == \null && search->n == 0;
*/
void et_search_free(et_search *search);

/* x[k] = x0[first + k] + radius (2 U - 1), k < count, U one draw of et_rng_fill each: the only way points are drawn, at the start with radius
 * spread, by the mutation of ga with radius box (spread without a box).  |x[k] - x0[first + k]| <= radius up to the rounding of the sum.
 * Golden: none (the rows of et_search_start and et_ga_step are made of its numbers). */
/*@ requires search: \valid_read(search) && \valid(rng);
    requires range:  first + count <= search->n && \valid_read(search->x0 + (0 .. search->n - 1));
    requires finite: \forall integer k; 0 <= k < search->n ==> \is_finite(search->x0[k]);
    requires out:    \valid(x + (0 .. count - 1));
    requires apart:  \separated(x + (0 .. count - 1), search->x0 + (0 .. search->n - 1), rng, search);
    requires radius: \is_finite(radius) && radius >= 0;
    assigns  x[0 .. count - 1], *rng;
    ensures  drawn:  \forall integer k; 0 <= k < count ==>
                     \ge_double(x[k], (double)(search->x0[first + k] - radius)) && \le_double(x[k], (double)(search->x0[first + k] + radius));
*/
void et_search_draw(double *x, const et_search *search, size_t first, size_t count, double radius, et_rng *rng);

/* Every coordinate of x into [x0 - box, x0 + box] (the ends rounded as a double subtraction and sum are); without a box nothing.  A NaN stays one. */
/*@ requires search: \valid_read(search) && \valid_read(search->x0 + (0 .. search->n - 1));
    requires inout:  \valid(x + (0 .. search->n - 1)) && \separated(x + (0 .. search->n - 1), search, search->x0 + (0 .. search->n - 1));
    requires order:  \is_finite(search->options.box) && \forall integer k; 0 <= k < search->n ==> \is_finite(search->x0[k]);
    requires size:   search->n * sizeof(double) <= SIZE_MAX;
    assigns  x[0 .. search->n - 1];
    ensures  box:    search->options.box > 0 ==> \forall integer k; 0 <= k < search->n && !\is_NaN(\old(x[k])) ==>
                     \ge_double(x[k], (double)(search->x0[k] - search->options.box)) &&
                     \le_double(x[k], (double)(search->x0[k] + search->options.box));
    ensures  nan:    \forall integer k; 0 <= k < search->n && \is_NaN(\old(x[k])) ==> \is_NaN(x[k]);
    ensures  none:   search->options.box <= 0 ==> \forall integer k; 0 <= k < search->n && !\is_NaN(\old(x[k])) ==> x[k] == \old(x[k]);
*/
void et_search_clamp(double *x, const et_search *search);

/* *value = f(x): counts the evaluation and keeps the best.  Only a strictly smaller value replaces the best: of equals the first stays.  On
 * failure (fn's status; ET_EINVAL for NaN) nothing changes.  Golden: none (the value is the caller's). */
/*@ requires out:    \valid(value) && \valid(search) && \valid(search->best + (0 .. search->n - 1)) && search->n * sizeof(double) <= SIZE_MAX;
    requires x:      \valid_read(x + (0 .. search->n - 1));
    requires apart:  \separated(value, x + (0 .. search->n - 1), search->best + (0 .. search->n - 1), search);
    requires order:  search->evaluations == 0 || !\is_NaN(search->best_value);
    requires room:   search->evaluations < UINT64_MAX;
    assigns  *value, search->best[0 .. search->n - 1], search->best_value, search->evaluations;
    ensures  count:  \result == ET_OK ==> search->evaluations == \old(search->evaluations) + 1;
    ensures  best:   \result == ET_OK ==> !\is_NaN(*value) && \le_double(search->best_value, *value);
    ensures  falling: \old(search->evaluations) > 0 ==> \le_double(search->best_value, \old(search->best_value));
    ensures  same:   \result != ET_OK ==> search->evaluations == \old(search->evaluations) &&
                     (\is_NaN(\old(search->best_value)) || search->best_value == \old(search->best_value));
*/
et_status et_search_eval(double *value, et_search *search, const double *x);

/* One generation of an algorithm: et_ga_step, et_de_step, et_pso_step have this type. */
typedef et_status (*et_search_step)(et_search *search, et_rng *rng);

/* generations steps; history[g] = best value after step g (generations numbers, may be null); task is told (g + 1, generations) after each.
 * ET_ESTOPPED (or whatever else task or step returns) leaves the best so far in search and the rest of history unset; *made tells how many
 * steps were made, search->generation how many since the start.  After a failing objective the best, its value, the count of evaluations and
 * the values of the population hold; a search stepped on from there is not on the path of an unbroken run.
 * Golden: none (the rows of et_ga_step, et_de_step and et_pso_step are runs). */
/*@ requires search:  et_search_started(search) && et_search_rng(search, rng) && \valid(made) && step != \null;
    requires nulls:   search->velocity == \null ==> search->memory == \null && search->remembered == \null;
    requires history: history == \null || \valid(history + (0 .. generations - 1));
    requires task:    task == \null || \valid_read(task);
    requires apart:   \separated(made, search, rng) && (task == \null || \separated(task, made, search, rng));
    requires own:     history == \null ||
                      (\separated(history + (0 .. generations - 1), search, made, rng, search->x0 + (0 .. search->n - 1),
                                  search->x + (0 .. search->options.population * search->n - 1),
                                  search->value + (0 .. search->options.population - 1), search->best + (0 .. search->n - 1),
                                  search->trial + (0 .. (search->options.population + 1) * (search->n + 1) - 1)) &&
                       (search->velocity == \null ||
                        \separated(history + (0 .. generations - 1), search->velocity + (0 .. search->options.population * search->n - 1),
                                   search->memory + (0 .. search->options.population * search->n - 1),
                                   search->remembered + (0 .. search->options.population - 1))));
    requires room:    search->evaluations + generations * search->options.population <= UINT64_MAX &&
                      search->generation + generations <= SIZE_MAX;
    assigns  search->best_value, search->generation, search->evaluations, *made, history[0 .. generations - 1], *rng,
             search->x[0 .. search->options.population * search->n - 1], search->value[0 .. search->options.population - 1],
             search->velocity[0 .. search->options.population * search->n - 1], search->memory[0 .. search->options.population * search->n - 1],
             search->remembered[0 .. search->options.population - 1],
             search->trial[0 .. (search->options.population + 1) * (search->n + 1) - 1], search->best[0 .. search->n - 1];
    ensures  made:    *made <= generations && (\result == ET_OK ==> *made == generations);
    ensures  best:    \le_double(search->best_value, \old(search->best_value));
    ensures  descending: history != \null ==> \forall integer g; 0 < g < *made ==> \le_double(history[g], history[g - 1]);
    ensures  under:   history != \null ==> \forall integer g; 0 <= g < *made ==> \le_double(history[g], \old(search->best_value));
    ensures  last:    history != \null && \result == ET_OK && generations > 0 ==> \eq_double(history[generations - 1], search->best_value);
    ensures  started: et_search_started(search);
*/
et_status et_search_run(et_search *search, size_t *made, double *history, size_t generations, et_search_step step, et_rng *rng, const et_task *task);

#ifdef __cplusplus
}
#endif
#endif
