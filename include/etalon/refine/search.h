/* search: what the population searches ga, de and pso share: a callback objective, a population, a history, one generation at a time.
 *
 * A search is started, stepped generation by generation, and freed; `x best` is at all times the best seen.  N steps of one generation equal
 * one run of N generations, bit for bit: everything that a generation depends on is in the struct and in the rng.
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

/* *value = f(x), x of n coordinates.  Anything but ET_OK ends the search. */
typedef et_status (*et_search_fn)(double *value, const double *x, size_t n, void *context);

typedef struct {
    size_t population;                    /* >= 4, default 40 */
    double spread;                        /* start: x0 + U(-spread, spread) per coordinate, default 5e-6 */
    double box;                           /* every coordinate stays within x0 +- box; <= 0: no box.  Default 5e-6 (the source's) */
    size_t group;                         /* coordinates to a gene (3: a control point), divides n */
    /* ga */
    size_t tournament;                    /* 4 */
    double crossover, swap, mutation;     /* 0.7, 0.5, 0.01 */
    /* de */
    double F, CR;                         /* 0.3, 0.8 */
    int by_coordinate;                    /* 0: crossover per gene; 1: per coordinate */
    /* pso */
    double K, c1, c2;                     /* 0.729, 2.05, 2.05 */
    double vmax;                          /* greatest |velocity| per coordinate; default 5e-6; <= 0: none */
} et_search_options;

typedef struct {
    et_search_options options;
    size_t n;                             /* coordinates */
    et_search_fn fn; void *context;
    double *x0;                           /* n: the centre of start and box */
    double *x, *value;                    /* population*n, population: individuals and their values */
    double *trial;                        /* workspace of the algorithm */
    double *velocity, *memory, *remembered;   /* pso: velocities, personal bests and their values; else null */
    double *best; double best_value;      /* the best seen */
    size_t generation;                    /* generations made */
    uint64_t evaluations;
} et_search;

et_search_options et_search_defaults(void);

/* Allocate, draw the start population around x0, evaluate it.  velocities: 1 for pso. */
et_status et_search_start(et_search *search, const double *x0, size_t n, const et_search_options *options, int velocities,
                          et_search_fn fn, void *context, et_rng *rng);
void et_search_free(et_search *search);

/* One generation of an algorithm: et_ga_step, et_de_step, et_pso_step have this type. */
typedef et_status (*et_search_step)(et_search *search, et_rng *rng);

/* generations steps; history[g] = best value after step g (generations numbers, may be null); task is told after each.
 * ET_ESTOPPED leaves the best so far in search and the rest of history unset; *made tells how many steps were made. */
et_status et_search_run(et_search *search, size_t *made, double *history, size_t generations, et_search_step step, et_rng *rng, const et_task *task);

#ifdef __cplusplus
}
#endif
#endif
