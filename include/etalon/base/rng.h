/* rng: the seeded generator, GSL's mt19937 behind one handle.  Randomness enters Etalon only through an explicit et_rng:
 * the same seed gives the same numbers on every compiler, processor and thread count.
 */
#ifndef ETALON_BASE_RNG_H
#define ETALON_BASE_RNG_H
#include "etalon/base/status.h"
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct et_rng et_rng;             /* opaque: GSL hides behind it */

/* The seed of stream number k of a family: a 64-bit mix (splitmix64) of seed and k, so that run k of an experiment draws the
 * same numbers whether it is run alone, after others, or on another thread. */
uint64_t et_rng_stream(uint64_t seed, uint64_t k);

/* A new generator; et_rng_free(NULL) does nothing. */
et_status et_rng_new(et_rng **rng, uint64_t seed);
void et_rng_free(et_rng *rng);

/* Draws so far, and a jump to that many draws after the seed: a generator is saved as (seed, draws). */
uint64_t et_rng_tell(const et_rng *rng);
void et_rng_seek(et_rng *rng, uint64_t draws);

/* One draw: k / 2^32 with k uniform in 0 .. 2^32 - 1. */
double et_rng_uniform(et_rng *rng);

/* x[0..n-1], the same numbers as n calls of et_rng_uniform in turn, but faster. */
void et_rng_fill(double *x, size_t n, et_rng *rng);

/* Uniform in 0 .. n-1 without bias (rejection; the number of draws varies), n >= 1. */
size_t et_rng_index(et_rng *rng, size_t n);

/* A standard normal deviate (Marsaglia's polar method; nothing is kept between calls). */
double et_rng_normal(et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
