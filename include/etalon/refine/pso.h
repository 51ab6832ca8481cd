/* pso: Particle swarm with constriction factor (Clerc and Kennedy 2002; spec section 6). */
#ifndef ETALON_REFINE_PSO_H
#define ETALON_REFINE_PSO_H
#include "etalon/refine/search.h"
#ifdef __cplusplus
extern "C" {
#endif

/* One generation.  Requires a search started by et_search_start with velocities. */
et_status et_pso_step(et_search *search, et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
