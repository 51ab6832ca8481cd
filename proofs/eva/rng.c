#include "eva.h"
#include "etalon/base/rng.h"

void eva_rng(void)    /* eva: -eva-min-loop-unroll 700 */
{
    et_rng *rng;
    double x[30];

    if (et_rng_new(&rng, (uint64_t)Frama_C_unsigned_long_interval(0, UINT64_MAX)) != ET_OK)
        return;
    et_rng_uniform(rng);
    et_rng_fill(x, 30, rng);
    et_rng_index(rng, Frama_C_size_t_interval(1, SIZE_MAX));
    et_rng_seek(rng, 3);
    et_rng_tell(rng);
    et_rng_free(rng);
    et_rng_free(NULL);
}
