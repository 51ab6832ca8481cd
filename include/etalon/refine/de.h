/* de: differential evolution rand/1/bin (Storn and Price 1997; You 2023, 6.2.4.2 and Table 6.1, Eqs. 2.12 to 2.14). */
#ifndef ETALON_REFINE_DE_H
#define ETALON_REFINE_DE_H
#include "etalon/refine/search.h"
#ifdef __cplusplus
extern "C" {
#endif

/* One generation of a search started by et_search_start.  For every individual i in turn, in this order of draws:
 *   1. r1, r2, r3 by et_rng_index over the population, each drawn again until it differs from i and from those before it;
 *   2. one gene (et_rng_index) that always crosses; a U for every gene (a gene is `group` coordinates, or one with by_coordinate);
 *   3. trial = x_r1 + F (x_r2 - x_r3) in the genes with U < CR and in that one, x_i in the others; clamped to the box; evaluated.
 * Generations are separate, as Storn and Price have it: all trials are built from the old generation; then trial i replaces x_i if its value is
 * not greater.  population evaluations.  If the objective fails the population is that of the generation before. */
/*@ requires search:  et_search_started(search) && et_search_rng(search, rng);
    requires room:    search->evaluations + search->options.population <= UINT64_MAX && search->generation < SIZE_MAX;
    assigns  search->x[0 .. search->options.population * search->n - 1], search->value[0 .. search->options.population - 1],
             search->trial[0 .. (search->options.population + 1) * (search->n + 1) - 1],
             search->best[0 .. search->n - 1], search->best_value, search->generation, search->evaluations, *rng;
    ensures  count:   \result == ET_OK ==> search->evaluations == \old(search->evaluations) + search->options.population
                                        && search->generation == \old(search->generation) + 1;
    ensures  started: et_search_started(search);
    ensures  falling: \le_double(search->best_value, \old(search->best_value));
    ensures  better:  \forall integer i; 0 <= i < search->options.population ==> \le_double(search->value[i], \old(search->value[i]));
*/
et_status et_de_step(et_search *search, et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
