#include "etalon/base/rng.h"
#include "etalon/base/real.h"
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>

/* GSL's generator is held by its type and state, not through gsl_rng_alloc, which calls GSL's error handler (abort, by default) where memory
 * is short. */
struct et_rng {
    const gsl_rng_type *type;
    void *state;
    unsigned long seed;
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

static uint64_t draw(et_rng *rng)
{
    rng->draws++;
    return rng->type->get(rng->state);
}

et_status et_rng_new(et_rng **rng, uint64_t seed)
{
    et_rng *r = malloc(sizeof *r);
    void *state = malloc(gsl_rng_mt19937->size);
    if (!r || !state) {
        free(r);
        free(state);
        return ET_ENOMEM;
    }
    r->type = gsl_rng_mt19937;
    r->state = state;
    r->seed = (unsigned long)(seed >> 32 == 0 ? seed : mix(seed) & UINT64_C(0xffffffff));
    *rng = r;
    et_rng_seek(r, 0);
    return ET_OK;
}

void et_rng_free(et_rng *rng)
{
    if (rng) {
        free(rng->state);
        free(rng);
    }
}

uint64_t et_rng_tell(const et_rng *rng)
{
    return rng->draws;
}

void et_rng_seek(et_rng *rng, uint64_t draws)
{
    rng->type->set(rng->state, rng->seed);
    for (uint64_t k = 0; k < draws; k++) {
        rng->type->get(rng->state);
    }
    rng->draws = draws;
}

double et_rng_uniform(et_rng *rng)
{
    return (double)draw(rng) * 0x1p-32;     /* exact: 32 bits fit */
}

void et_rng_fill(double *x, size_t n, et_rng *rng)
{
    unsigned long (*get)(void *) = rng->type->get;
    void *state = rng->state;
    for (size_t i = 0; i < n; i++) {
        x[i] = (double)get(state) * 0x1p-32;
    }
    rng->draws += n;
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

size_t et_rng_index(et_rng *rng, size_t n)
{
    return (size_t)((uint64_t)n <= UINT64_C(0xffffffff) ? index_narrow(rng, n) : index_wide(rng, n));
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
