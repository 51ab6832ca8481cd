/* pso: particle swarm with constriction factor and velocity clamping (Clerc and Kennedy 2002; You 2023, 6.2.4.3 and Table 6.1, Eqs. 2.17 to 2.20). */
#ifndef ETALON_REFINE_PSO_H
#define ETALON_REFINE_PSO_H
#include "etalon/refine/search.h"
#ifdef __cplusplus
extern "C" {
#endif

/* One generation of a search started by et_search_start with velocities.  For every particle in turn: 2n draws, r1 then r2, one a coordinate;
 *     v = K (v + c1 r1 (own best - x) + c2 r2 (swarm's best - x)),   |v| <= vmax,   x = x + v clamped to the box
 * (the velocity stays as it is where the position is clamped, or with `absorb` becomes 0); evaluated; the own best is replaced if strictly better.
 * The swarm's best is that of the generation before for the whole sweep, or with `immediate` the best so far.
 * population evaluations.  ET_EINVAL: a search without velocities. */
/*@ requires search:  et_search_started(search) && et_search_rng(search, rng);
    requires room:    search->evaluations + search->options.population <= UINT64_MAX && search->generation < SIZE_MAX;
    assigns  search->x[0 .. search->options.population * search->n - 1], search->value[0 .. search->options.population - 1],
             search->velocity[0 .. search->options.population * search->n - 1], search->memory[0 .. search->options.population * search->n - 1],
             search->remembered[0 .. search->options.population - 1],
             search->trial[0 .. (search->options.population + 1) * (search->n + 1) - 1],
             search->best[0 .. search->n - 1], search->best_value, search->generation, search->evaluations, *rng;
    ensures  count:   \result == ET_OK ==> search->evaluations == \old(search->evaluations) + search->options.population
                                        && search->generation == \old(search->generation) + 1;
    ensures  started: et_search_started(search);
    ensures  falling: \le_double(search->best_value, \old(search->best_value));
    ensures  own:     search->velocity != \null ==> \forall integer i; 0 <= i < search->options.population ==>
                      \le_double(search->remembered[i], \old(search->remembered[i]));
    ensures  none:    search->velocity == \null ==> \result == ET_EINVAL;
*/
et_status et_pso_step(et_search *search, et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
