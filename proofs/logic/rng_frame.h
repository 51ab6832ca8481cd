/* As in rng_new.h, for frames: what is new was not allocated when the function was called (alloc.h). */
#include "rng.h"
#include <stdint.h>
#include <stdlib.h>
#include "etalon/base/rng.h"
#define malloc(bytes) rng_malloc()
#define free(p) rng_dispose(p)
/*@ assigns \result \from \nothing;
    ensures fresh: \result == \null || (\block_length((char *)\result) == 0 && (char *)\result == \base_addr((char *)\result));
*/
et_rng *rng_malloc(void);
/*@ assigns \nothing; */
void rng_dispose(et_rng *rng);
