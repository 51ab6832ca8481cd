/* As in rng.h and alloc.h; malloc and free of a generator: of one type, so that no cast is needed. */
#include "rng.h"
#include <stdint.h>
#include <stdlib.h>
#include "etalon/base/rng.h"
#define malloc(bytes) rng_malloc()
#define free(p) rng_dispose(p)
/*@ assigns \result \from \nothing;
    ensures made: \result == \null || \valid(\result);
*/
et_rng *rng_malloc(void);
/*@ assigns \nothing; */
void rng_dispose(et_rng *rng);
