/* rng: the seeded generator, mt19937 (Matsumoto and Nishimura 1998, initialised as of 2002) with the numbers of GSL's gsl_rng_mt19937.
 * Randomness enters Etalon only through an explicit et_rng: the same seed gives the same numbers on every compiler, processor and thread
 * count.
 */
#ifndef ETALON_BASE_RNG_H
#define ETALON_BASE_RNG_H
#include "etalon/base/status.h"
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct et_rng et_rng;             /* opaque */

/* The seed of stream number k of a family: output number k (from 0) of splitmix64 (Steele, Lea and Flood 2014) started at `seed`, so
 * that run k of an experiment draws the same numbers whether it is run alone, after others, or on another thread.  For one seed the
 * 2^64 streams' seeds are all different. */
/*@ assigns \nothing; */
uint64_t et_rng_stream(uint64_t seed, uint64_t k);

/* A new generator; free it with et_rng_free.  ET_ENOMEM.
 * A seed below 2^32 is the generator's own (0 means 4357, as in GSL); a larger one is mixed down to 32 bits, so that two of them may give
 * the same numbers (one chance in 2^32 a pair).
 * Golden: none (a handle; its numbers are those of et_rng_uniform). */
/*@ requires rng:  \valid(rng);
    assigns  *rng;
    ensures  made: \result == ET_OK ==> \valid(*rng);
    ensures  kept: \result != ET_OK ==> \result == ET_ENOMEM && *rng == \old(*rng);
*/
et_status et_rng_new(et_rng **rng, uint64_t seed);

/* et_rng_free(NULL) does nothing.
 * Golden: none (no value). */
/*@ requires rng: rng == \null || \valid(rng);
    assigns  \nothing;
    frees    rng;
*/
void et_rng_free(et_rng *rng);

/* Draws so far: a generator is saved as (seed, draws).
 * Golden: none (a count of calls). */
/*@ requires rng: \valid_read(rng);
    assigns  \nothing;
*/
uint64_t et_rng_tell(const et_rng *rng);

/* A jump to that many draws after the seed; the time is that of the draws (about 3 ns each). */
/*@ requires rng: \valid(rng);
    assigns  *rng;
*/
void et_rng_seek(et_rng *rng, uint64_t draws);

/* One draw: k / 2^32 with k uniform in 0 .. 2^32 - 1. */
/*@ requires rng:   \valid(rng);
    assigns  *rng;
    ensures  range: 0.0 <= \result < 1.0;
*/
double et_rng_uniform(et_rng *rng);

/* x[0..n-1], the same numbers as n calls of et_rng_uniform in turn, but faster. */
/*@ requires x:     \valid(x + (0 .. n - 1));
    requires rng:   \valid(rng);
    requires apart: \separated(x + (0 .. n - 1), rng);
    assigns  x[0 .. n - 1], *rng;
    ensures  range: \forall integer i; 0 <= i < n ==> 0.0 <= x[i] < 1.0;
*/
void et_rng_fill(double *x, size_t n, et_rng *rng);

/* Uniform in 0 .. n-1 without bias (rejection; the number of draws varies), n >= 1.
 * n < 2^32: the high 32 bits of k n, k a 32-bit draw, redrawn while the low 32 bits are below 2^32 mod n (Lemire 2019).
 * Else: k = 2^32 k1 + k2 from two draws, redrawn while k >= 2^64 - 2^64 mod n; the result is k mod n. */
/*@ requires rng:   \valid(rng);
    requires n:     1 <= n;
    assigns  *rng;
    ensures  below: 0 <= \result < n;
*/
size_t et_rng_index(et_rng *rng, size_t n);

/* A standard normal deviate: a sqrt(-2 ln s / s), s = a^2 + b^2, with a, b = 2 U - 1 redrawn until 0 < s < 1 (Marsaglia's polar
 * method; the second deviate b sqrt(...) is not kept, so that nothing is hidden between calls).  |result| < 9.4. */
/*@ requires rng:    \valid(rng);
    assigns  *rng;
    ensures  finite: \is_finite(\result);
*/
double et_rng_normal(et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
