#include "etalon/base/rng.h"
#include "etalon/base/real.h"
#include <math.h>
#include <stdlib.h>

/* mt19937 (Matsumoto and Nishimura 1998; seeding of 2002), the numbers of GSL's gsl_rng_mt19937, written so that a compiler makes a block of words
 * with vectors: seven times as fast as calling GSL for each, and the searches draw thousands for every evaluation. */
enum { WORDS = 624, MIDDLE = 397, BLOCK = 8 };

struct et_rng {
    uint32_t mt[WORDS];
    size_t at;                                /* words of the block already drawn */
    uint32_t seed;
    uint64_t draws;
};

/*@ predicate rng_sound{L}(et_rng *rng) = \valid(rng) && rng->at <= WORDS; */

/* Steele, Lea and Flood 2014: the finaliser of splitmix64. */
/*@ assigns \nothing; */
static uint64_t mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

uint64_t et_rng_stream(uint64_t seed, uint64_t k)
{
    return mix(seed + (k + 1) * UINT64_C(0x9e3779b97f4a7c15));
}

/*@ assigns \nothing; */
static uint32_t twist(uint32_t far, uint32_t a, uint32_t b)
{
    const uint32_t y = (a & 0x80000000u) | (b & 0x7fffffffu);
    return far ^ (y >> 1) ^ ((0u - (y & 1u)) & 0x9908b0dfu);
}

/* The next block in place.  Two counts are split so that they are multiples of four. */
/*@ requires words: \valid(mt + (0 .. WORDS - 1));
    assigns  mt[0 .. WORDS - 1];
*/
static void refill(uint32_t *mt)
{
    const size_t wrap = WORDS - MIDDLE;
    /*@ loop invariant place: 0 <= k <= 224;
        loop assigns k, mt[0 .. WORDS - 1];
        loop variant 224 - k;
    */
    for (size_t k = 0; k < 224; k++) {
        mt[k] = twist(mt[k + MIDDLE], mt[k], mt[k + 1]);
    }
    /*@ loop invariant place: 224 <= k <= WORDS - MIDDLE;
        loop assigns k, mt[0 .. WORDS - 1];
        loop variant WORDS - MIDDLE - k;
    */
    for (size_t k = 224; k < wrap; k++) {
        mt[k] = twist(mt[k + MIDDLE], mt[k], mt[k + 1]);
    }
    /*@ loop invariant place: 227 <= k <= 623;
        loop assigns k, mt[0 .. WORDS - 1];
        loop variant 623 - k;
    */
    for (size_t k = 227; k < 623; k++) {
        mt[k] = twist(mt[k - 227], mt[k], mt[k + 1]);
    }
    mt[WORDS - 1] = twist(mt[MIDDLE - 1], mt[WORDS - 1], mt[0]);
}

/*@ assigns \nothing; */
static uint32_t temper(uint32_t y)
{
    y ^= y >> 11;
    y ^= (y << 7) & 0x9d2c5680u;
    y ^= (y << 15) & 0xefc60000u;
    return y ^ (y >> 18);
}

/*@ requires rng:   \valid(rng);
    assigns  rng->mt[0 .. WORDS - 1], rng->at;
    ensures  first: rng->at == 0;
*/
static void renew(et_rng *rng)
{
    refill(rng->mt);
    rng->at = 0;
}

/*@ requires sound: rng_sound(rng);
    assigns  *rng;
    ensures  sound: rng_sound(rng);
    ensures  word:  \result <= 0xffffffff;
*/
static uint64_t draw(et_rng *rng)
{
    if (rng->at == WORDS) {
        renew(rng);
    }
    rng->draws++;
    return temper(rng->mt[rng->at++]);
}

/*@ ensures  sound: \result == ET_OK ==> rng_sound(*rng); */
et_status et_rng_new(et_rng **rng, uint64_t seed)
{
    et_rng *r = malloc(sizeof *r);
    if (!r) {
        return ET_ENOMEM;
    }
    r->seed = (uint32_t)(seed >> 32 == 0 ? seed : mix(seed) & UINT64_C(0xffffffff));
    *rng = r;
    et_rng_seek(r, 0);
    return ET_OK;
}

void et_rng_free(et_rng *rng)
{
    free(rng);
}

uint64_t et_rng_tell(const et_rng *rng)
{
    return rng->draws;
}

/*@ ensures  sound: rng->at <= WORDS; */
void et_rng_seek(et_rng *rng, uint64_t draws)
{
    rng->mt[0] = rng->seed == 0 ? 4357 : rng->seed;      /* GSL's convention for the seed 0 */
    /*@ loop invariant place: 1 <= k <= WORDS;
        loop assigns k, rng->mt[1 .. WORDS - 1];
        loop variant WORDS - k;
    */
    for (uint32_t k = 1; k < WORDS; k++) {
        rng->mt[k] = 1812433253u * (rng->mt[k - 1] ^ (rng->mt[k - 1] >> 30)) + k;
    }
    rng->at = WORDS;
    rng->draws = draws;
    /*@ loop invariant place: block <= draws / WORDS + (draws % WORDS != 0 ? 1 : 0);
        loop assigns block, rng->mt[0 .. WORDS - 1], rng->at;
        loop variant draws / WORDS + 1 - block;
    */
    for (uint64_t block = 0; block < draws / WORDS + (draws % WORDS != 0); block++) {
        renew(rng);
        rng->at = WORDS;
    }
    rng->at = draws % WORDS == 0 ? WORDS : (size_t)(draws % WORDS);
}

/*@ requires sound: rng_sound(rng);
    ensures  sound: rng_sound(rng);
*/
double et_rng_uniform(et_rng *rng)
{
    return (double)draw(rng) * 0x1p-32;     /* exact: 32 bits fit */
}

/* x[k] = word k / 2^32, exactly. */
/*@ requires words: \valid_read(mt + (0 .. n - 1)) && \valid(x + (0 .. n - 1)) && n <= WORDS;
    requires apart: \separated(x + (0 .. n - 1), mt + (0 .. n - 1));
    assigns  x[0 .. n - 1];
*/
static void uniforms(double *restrict x, const uint32_t *restrict mt, size_t n)
{
    size_t k = 0;
    /*@ loop invariant place: k <= n;
        loop assigns k, x[0 .. n - 1];
        loop variant n - k;
    */
    for (; k + BLOCK <= n; k += BLOCK) {
        /*@ loop invariant block: b <= BLOCK;
            loop assigns b, x[0 .. n - 1];
            loop variant BLOCK - b;
        */
        for (size_t b = 0; b < BLOCK; b++) {
            x[k + b] = (double)temper(mt[k + b]) * 0x1p-32;
        }
    }
    /*@ loop invariant place: k <= n;
        loop assigns k, x[0 .. n - 1];
        loop variant n - k;
    */
    for (; k < n; k++) {
        x[k] = (double)temper(mt[k]) * 0x1p-32;
    }
}

/*@ requires sound: rng_sound(rng);
    ensures  sound: rng_sound(rng);
*/
void et_rng_fill(double *x, size_t n, et_rng *rng)
{
    rng->draws += n;
    /*@ loop invariant sound: rng_sound(rng);
        loop invariant place: n <= \at(n, Pre) && x == \at(x, Pre) + (\at(n, Pre) - n);
        loop assigns x, n, \at(x, Pre)[0 .. \at(n, Pre) - 1], *rng;
        loop variant n;
    */
    while (n > 0) {
        if (rng->at == WORDS) {
            renew(rng);
        }
        const size_t left = WORDS - rng->at, count = n < left ? n : left;
        uniforms(x, rng->mt + rng->at, count);
        rng->at += count;
        x += count;
        n -= count;
    }
}

/* Lemire 2019: the high word of a 32 x 32 bit product, redrawn for the (2^32 mod n) low words that would be too many. */
/*@ requires sound: rng_sound(rng);
    requires n:     1 <= n <= 0xffffffff;
    assigns  *rng;
    ensures  sound: rng_sound(rng);
    ensures  below: \result < n;
*/
static uint64_t index_narrow(et_rng *rng, uint64_t n)
{
    uint64_t m = draw(rng) * n;
    if ((m & UINT64_C(0xffffffff)) < n) {
        uint64_t excess = (UINT64_C(0x100000000) - n) % n;
        /*@ loop invariant sound: rng_sound(rng);
            loop invariant words: m <= 0xffffffff * n;
            loop assigns m, *rng;
        */
        while ((m & UINT64_C(0xffffffff)) < excess) {
            m = draw(rng) * n;
        }
    }
    return m >> 32;
}

/* Two draws a word, the first the high half; words at and beyond the greatest multiple of n are redrawn. */
/*@ requires sound: rng_sound(rng);
    requires n:     1 <= n;
    assigns  *rng;
    ensures  sound: rng_sound(rng);
    ensures  wide:  \result < n;
*/
static uint64_t index_wide(et_rng *rng, uint64_t n)
{
    uint64_t excess = (UINT64_MAX - n + 1) % n;     /* 2^64 mod n */
    uint64_t m;
    /*@ loop invariant sound: rng_sound(rng);
        loop assigns m, *rng;
    */
    do {
        m = draw(rng) << 32;
        m |= draw(rng);
    } while (m > UINT64_MAX - excess);
    return m % n;
}

/* n has 64 bits here, whatever size_t has: else a compiler for 32 bits would complain of the comparison. */
/*@ requires sound: rng_sound(rng);
    requires n:     1 <= n;
    assigns  *rng;
    ensures  sound: rng_sound(rng);
    ensures  below: \result < n;
*/
static uint64_t index_of(et_rng *rng, uint64_t n)
{
    return n <= UINT64_C(0xffffffff) ? index_narrow(rng, n) : index_wide(rng, n);
}

/*@ requires sound: rng_sound(rng);
    ensures  sound: rng_sound(rng);
*/
size_t et_rng_index(et_rng *rng, size_t n)
{
    return (size_t)index_of(rng, n);
}

/*@ requires sound: rng_sound(rng);
    ensures  sound: rng_sound(rng);
*/
double et_rng_normal(et_rng *rng)
{
    double a, b, s;
    /*@ loop invariant sound: rng_sound(rng);
        loop assigns a, b, s, *rng;
    */
    do {
        a = 2.0 * et_rng_uniform(rng) - 1.0;
        b = 2.0 * et_rng_uniform(rng) - 1.0;
        s = a * a + b * b;
    } while (s >= 1.0 || s == 0.0);
    return a * sqrt(-2.0 * et_real_log(s) / s);
}
