/* ga: Genetic algorithm (You 2023, 6.2.4.1; spec section 6): two tournaments, uniform crossover, redrawing mutation, weak-parent replacement; two evaluations a generation. */
#ifndef ETALON_REFINE_GA_H
#define ETALON_REFINE_GA_H
#include "etalon/refine/search.h"
#ifdef __cplusplus
extern "C" {
#endif

/* One generation.  Requires a search started by et_search_start. */
et_status et_ga_step(et_search *search, et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
