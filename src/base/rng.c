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

/* Steele, Lea and Flood 2014: the finaliser of splitmix64. */
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

static uint32_t twist(uint32_t far, uint32_t a, uint32_t b)
{
    const uint32_t y = (a & 0x80000000u) | (b & 0x7fffffffu);
    return far ^ (y >> 1) ^ ((0u - (y & 1u)) & 0x9908b0dfu);
}

/* The next block in place.  Two counts are split so that they are multiples of four. */
static void refill(uint32_t *mt)
{
    const size_t wrap = WORDS - MIDDLE;
    for (size_t k = 0; k < 224; k++) {
        mt[k] = twist(mt[k + MIDDLE], mt[k], mt[k + 1]);
    }
    for (size_t k = 224; k < wrap; k++) {
        mt[k] = twist(mt[k + MIDDLE], mt[k], mt[k + 1]);
    }
    for (size_t k = 227; k < 623; k++) {
        mt[k] = twist(mt[k - 227], mt[k], mt[k + 1]);
    }
    mt[WORDS - 1] = twist(mt[MIDDLE - 1], mt[WORDS - 1], mt[0]);
}

static uint32_t temper(uint32_t y)
{
    y ^= y >> 11;
    y ^= (y << 7) & 0x9d2c5680u;
    y ^= (y << 15) & 0xefc60000u;
    return y ^ (y >> 18);
}

static void renew(et_rng *rng)
{
    refill(rng->mt);
    rng->at = 0;
}

static uint64_t draw(et_rng *rng)
{
    if (rng->at == WORDS) {
        renew(rng);
    }
    rng->draws++;
    return temper(rng->mt[rng->at++]);
}

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

void et_rng_seek(et_rng *rng, uint64_t draws)
{
    rng->mt[0] = rng->seed == 0 ? 4357 : rng->seed;      /* GSL's convention for the seed 0 */
    for (uint32_t k = 1; k < WORDS; k++) {
        rng->mt[k] = 1812433253u * (rng->mt[k - 1] ^ (rng->mt[k - 1] >> 30)) + k;
    }
    rng->at = WORDS;
    rng->draws = draws;
    for (uint64_t block = 0; block < draws / WORDS + (draws % WORDS != 0); block++) {
        renew(rng);
        rng->at = WORDS;
    }
    rng->at = draws % WORDS == 0 ? WORDS : (size_t)(draws % WORDS);
}

double et_rng_uniform(et_rng *rng)
{
    return (double)draw(rng) * 0x1p-32;     /* exact: 32 bits fit */
}

/* x[k] = word k / 2^32, exactly. */
static void uniforms(double *restrict x, const uint32_t *restrict mt, size_t n)
{
    size_t k = 0;
    for (; k + BLOCK <= n; k += BLOCK) {
        for (size_t b = 0; b < BLOCK; b++) {
            x[k + b] = (double)temper(mt[k + b]) * 0x1p-32;
        }
    }
    for (; k < n; k++) {
        x[k] = (double)temper(mt[k]) * 0x1p-32;
    }
}

void et_rng_fill(double *x, size_t n, et_rng *rng)
{
    rng->draws += n;
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
static uint64_t index_narrow(et_rng *rng, uint64_t n)
{
    uint64_t m = draw(rng) * n;
    if ((m & UINT64_C(0xffffffff)) < n) {
        uint64_t excess = (UINT64_C(0x100000000) - n) % n;
        while ((m & UINT64_C(0xffffffff)) < excess) {
            m = draw(rng) * n;
        }
    }
    return m >> 32;
}

/* Two draws a word, the first the high half; words at and beyond the greatest multiple of n are redrawn. */
static uint64_t index_wide(et_rng *rng, uint64_t n)
{
    uint64_t excess = (UINT64_MAX - n + 1) % n;     /* 2^64 mod n */
    uint64_t m;
    do {
        m = draw(rng) << 32;
        m |= draw(rng);
    } while (m > UINT64_MAX - excess);
    return m % n;
}

/* n has 64 bits here, whatever size_t has: else a compiler for 32 bits would complain of the comparison. */
static uint64_t index_of(et_rng *rng, uint64_t n)
{
    return n <= UINT64_C(0xffffffff) ? index_narrow(rng, n) : index_wide(rng, n);
}

size_t et_rng_index(et_rng *rng, size_t n)
{
    return (size_t)index_of(rng, n);
}

double et_rng_normal(et_rng *rng)
{
    double a, b, s;
    do {
        a = 2.0 * et_rng_uniform(rng) - 1.0;
        b = 2.0 * et_rng_uniform(rng) - 1.0;
        s = a * a + b * b;
    } while (s >= 1.0 || s == 0.0);
    return a * sqrt(-2.0 * et_real_log(s) / s);
}
