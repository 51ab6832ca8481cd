/* de: Differential evolution rand/1/bin (Storn and Price 1997; spec section 6). */
#ifndef ETALON_REFINE_DE_H
#define ETALON_REFINE_DE_H
#include "etalon/refine/search.h"
#ifdef __cplusplus
extern "C" {
#endif

/* One generation.  Requires a search started by et_search_start. */
et_status et_de_step(et_search *search, et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
