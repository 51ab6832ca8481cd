/* ga: genetic algorithm (You 2023, 6.2.4.1 and Table 6.1): two tournaments, uniform crossover, redrawing mutation, weak-parent replacement;
 * two evaluations a generation. */
#ifndef ETALON_REFINE_GA_H
#define ETALON_REFINE_GA_H
#include "etalon/refine/search.h"
#ifdef __cplusplus
extern "C" {
#endif

/* One generation of a search started by et_search_start.  In this order of draws:
 *   1. parent a: the best of `tournament` individuals drawn with replacement (et_rng_index; of equals the first drawn); parent b likewise:
 *      both may be one individual;
 *   2. one U; if U < crossover: a U for every gene, and where it is < swap the children (copies of a and b) exchange that gene;
 *   3. child of a: one U; if U < mutation, one gene (et_rng_index) is redrawn, a U a coordinate, uniformly in x0 +- box (without a box: x0 +-
 *      spread); child of b likewise;
 *   4. the child of a is evaluated, then that of b; then each replaces its own parent if strictly better (a first).
 * If the objective fails the population is that of the generation before. */
/*@ requires search:  et_search_started(search) && et_search_rng(search, rng);
    requires room:    search->evaluations + 2 <= UINT64_MAX && search->generation < SIZE_MAX;
    assigns  search->x[0 .. search->options.population * search->n - 1], search->value[0 .. search->options.population - 1],
             search->trial[0 .. (search->options.population + 1) * (search->n + 1) - 1],
             search->best[0 .. search->n - 1], search->best_value, search->generation, search->evaluations, *rng;
    ensures  count:   \result == ET_OK ==> search->evaluations == \old(search->evaluations) + 2 && search->generation == \old(search->generation) + 1;
    ensures  started: et_search_started(search);
    ensures  falling: \le_double(search->best_value, \old(search->best_value));
    ensures  better:  \forall integer i; 0 <= i < search->options.population ==> \le_double(search->value[i], \old(search->value[i]));
*/
et_status et_ga_step(et_search *search, et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
