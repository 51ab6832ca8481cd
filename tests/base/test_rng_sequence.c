/* base/rng: any sequence of calls on one generator, against a list of its numbers and a place in it. */
#include "etalon/base/rng.h"
#include "gen.h"
#include <math.h>
#include <string.h>

enum { NUMBERS = 2000, CALLS = 24 };

typedef struct { double u[NUMBERS]; size_t at; } model;

/* Lemire's index from the list. */
static size_t index_of(model *m, size_t n)
{
    const uint64_t range = n;
    uint64_t product;

    do
        product = (uint64_t)(m->u[m->at++] * 0x1p32) * range;
    while ((uint32_t)product < (UINT64_C(1) << 32) % range && m->at + 2 < NUMBERS);
    return (size_t)(product >> 32);
}

/* How many numbers the polar method takes: pairs, until one lies in the disc. */
static void pass_normal(model *m)
{
    double s = 0.0;

    while (!(s > 0.0 && s < 1.0) && m->at + 2 < NUMBERS) {
        const double a = 2.0 * m->u[m->at] - 1.0, b = 2.0 * m->u[m->at + 1] - 1.0;
        s = a * a + b * b;
        m->at += 2;
    }
}

static bool call(gen *g, et_rng *rng, model *m)
{
    double x[64];
    size_t n;
    bool ok = true;

    switch (gen_upto(g, 5)) {
    case 0:
        gen_label(g, "uniform");
        m->at++;
        return gen_check(g, et_rng_uniform(rng) == m->u[m->at - 1], "number %zu", m->at - 1);
    case 1:
        gen_label(g, "fill");
        n = (size_t)gen_upto(g, 64);
        et_rng_fill(x, n, rng);
        for (size_t i = 0; ok && i < n; i++)
            ok = gen_check(g, x[i] == m->u[m->at + i], "number %zu of a fill from %zu", i, m->at);
        m->at += n;
        return ok;
    case 2:
        gen_label(g, "index");
        n = 1 + (size_t)gen_upto(g, UINT32_MAX - 1);
        return gen_check(g, et_rng_index(rng, n) == index_of(m, n), "index below %zu at %zu", n, m->at);
    case 3:
        gen_label(g, "normal");
        pass_normal(m);
        return gen_check(g, isfinite(et_rng_normal(rng)), "normal");
    case 4:
        gen_label(g, "seek");
        m->at = (size_t)gen_upto(g, NUMBERS / 2);
        et_rng_seek(rng, m->at);
        return true;
    default:
        et_rng_seek(rng, et_rng_tell(rng));
        return true;
    }
}

verdict prop_rng_seek_sequence(gen *g)
{
    static model m;
    const uint64_t seed = gen_upto(g, UINT64_MAX);
    et_rng *rng = NULL, *plain = NULL;
    bool ok = et_rng_new(&rng, seed) == ET_OK && et_rng_new(&plain, seed) == ET_OK;

    for (size_t i = 0; ok && i < NUMBERS; i++)
        m.u[i] = et_rng_uniform(plain);
    m.at = 0;
    for (uint64_t calls = 1 + gen_upto(g, CALLS - 1); ok && calls > 0 && m.at + 200 < NUMBERS; calls--)
        ok = call(g, rng, &m) && gen_check(g, et_rng_tell(rng) == m.at, "at %llu, not %zu", (unsigned long long)et_rng_tell(rng), m.at);
    et_rng_free(rng);
    et_rng_free(plain);
    return ok ? PASS : FAIL;
}
