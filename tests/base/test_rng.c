/* base/rng against a second mt19937, written from its definition, against GSL's, and against its own promises. */
#include "etalon/base/rng.h"
#include "etalon/base/real.h"
#include "gen.h"
#include "golden.h"
#include <gsl/gsl_rng.h>
#include <math.h>
#include <string.h>

/* Matsumoto and Nishimura: x_{k+624} = x_{k+397} + (upper bit of x_k | lower bits of x_{k+1}) A, one word at a time, tempered. */
typedef struct { uint32_t x[624]; size_t k; } twister;

static void twister_seed(twister *t, uint32_t seed)
{
    t->x[0] = seed ? seed : 4357;
    for (uint32_t i = 1; i < 624; i++) {
        t->x[i] = UINT32_C(1812433253) * (t->x[i - 1] ^ (t->x[i - 1] >> 30)) + i;
    }
    t->k = 0;
}

static uint32_t twister_next(twister *t)
{
    size_t k = t->k;
    uint32_t y = (t->x[k] & UINT32_C(0x80000000)) | (t->x[(k + 1) % 624] & UINT32_C(0x7fffffff));
    t->x[k] = t->x[(k + 397) % 624] ^ (y >> 1) ^ (y & 1 ? UINT32_C(0x9908b0df) : 0);
    y = t->x[k];
    t->k = (k + 1) % 624;
    y ^= y >> 11;
    y ^= (y << 7) & UINT32_C(0x9d2c5680);
    y ^= (y << 15) & UINT32_C(0xefc60000);
    return y ^ (y >> 18);
}

static bool same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static et_rng *make(uint64_t seed)
{
    et_rng *rng = NULL;
    return et_rng_new(&rng, seed) == ET_OK ? rng : NULL;
}

/* A seed and a generator some draws after it. */
static et_rng *draw_rng(gen *g, uint64_t *seed)
{
    *seed = gen_upto(g, 1) ? gen_upto(g, UINT64_MAX) : gen_upto(g, UINT32_MAX);
    et_rng *rng = make(*seed);
    if (rng) {
        et_rng_seek(rng, gen_upto(g, 700));
    }
    return rng;
}

verdict prop_rng_stream(gen *g)
{
    uint64_t seed = gen_upto(g, UINT64_MAX), k = gen_upto(g, 100), state = seed, z = 0;
    for (uint64_t i = 0; i <= k; i++) {      /* splitmix64 as its authors run it: state by state */
        state += UINT64_C(11400714819323198485);
        z = state;
        z = (z ^ z >> 30) * UINT64_C(13787848793156543929);
        z = (z ^ z >> 27) * UINT64_C(10723151780598845931);
        z ^= z >> 31;
    }
    bool ok = gen_check(g, et_rng_stream(seed, k) == z, "stream %llu of %llu", (unsigned long long)k, (unsigned long long)seed);
    ok = ok && gen_check(g, et_rng_stream(seed, k) != et_rng_stream(seed, k + 1), "two streams with one seed");
    return ok ? PASS : FAIL;
}

verdict prop_rng_new(gen *g)
{
    uint64_t seed;
    et_rng *a = draw_rng(g, &seed), *b = make(seed), *c = make(seed ^ UINT64_C(1) << gen_upto(g, 63));
    bool ok = gen_check(g, a && b && c, "no generator");
    size_t equal = 0;
    if (ok) {
        ok = gen_check(g, et_rng_tell(b) == 0, "a new generator has drawn");
        et_rng_seek(a, 0);
        for (int i = 0; i < 8; i++) {
            double x = et_rng_uniform(a);
            ok = gen_check(g, same(x, et_rng_uniform(b)), "one seed, two numbers") && ok;
            equal += same(x, et_rng_uniform(c));
        }
        /* 4357 and 0 are one seed; else eight equal numbers of two seeds do not happen. */
        ok = gen_check(g, equal < 8 || seed == 0 || seed == 4357, "two seeds, one sequence") && ok;
    }
    et_rng_free(a);
    et_rng_free(b);
    et_rng_free(c);
    return ok ? PASS : FAIL;
}

verdict prop_rng_free(gen *g)
{
    et_rng_free(NULL);
    for (uint64_t n = gen_upto(g, 3); n > 0; n--) {      /* leaks show under the sanitizer */
        et_rng_free(make(n));
    }
    return PASS;
}

verdict prop_rng_tell(gen *g)
{
    uint64_t seed;
    et_rng *rng = draw_rng(g, &seed);
    double x[50];
    if (!rng) {
        return FAIL;
    }
    uint64_t at = et_rng_tell(rng);
    size_t n = (size_t)gen_upto(g, 50), m = (size_t)gen_upto(g, 20);
    et_rng_fill(x, n, rng);
    bool ok = gen_check(g, et_rng_tell(rng) == at + n, "%zu draws filled", n);
    for (size_t i = 0; i < m; i++) {
        et_rng_uniform(rng);
    }
    ok = gen_check(g, et_rng_tell(rng) == at + n + m, "%zu draws", m) && ok;
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

verdict prop_rng_seek(gen *g)
{
    uint64_t seed;
    et_rng *a = draw_rng(g, &seed), *b = make(seed);
    uint64_t to = gen_upto(g, 1500);
    bool ok = a && b;
    if (ok) {
        et_rng_seek(a, to);
        ok = gen_check(g, et_rng_tell(a) == to, "after seek to %llu: at %llu", (unsigned long long)to, (unsigned long long)et_rng_tell(a));
        for (uint64_t k = 0; k < to; k++) {
            et_rng_uniform(b);
        }
        for (int i = 0; i < 3; i++) {
            ok = gen_check(g, same(et_rng_uniform(a), et_rng_uniform(b)), "other numbers after seek to %llu", (unsigned long long)to) && ok;
        }
    }
    et_rng_free(a);
    et_rng_free(b);
    return ok ? PASS : FAIL;
}

verdict prop_rng_uniform(gen *g)
{
    twister t;
    uint64_t seed = gen_upto(g, UINT32_MAX);
    et_rng *rng = make(seed);
    bool ok = rng != NULL;
    twister_seed(&t, (uint32_t)seed);
    for (uint64_t k = 0, n = gen_upto(g, 1300); ok && k <= n; k++) {
        double x = et_rng_uniform(rng), want = ldexp((double)twister_next(&t), -32);
        ok = gen_check(g, same(x, want) && x >= 0.0 && x < 1.0, "draw %llu is %a for %a", (unsigned long long)k, x, want);
    }
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

verdict prop_rng_uniform_gsl(gen *g)
{
    uint64_t seed = gen_upto(g, UINT32_MAX);
    et_rng *rng = make(seed);
    gsl_rng *gsl = gsl_rng_alloc(gsl_rng_mt19937);
    bool ok = rng && gsl;
    if (ok) {
        gsl_rng_set(gsl, (unsigned long)seed);
    }
    for (uint64_t k = 0, n = gen_upto(g, 700); ok && k <= n; k++) {
        double x = et_rng_uniform(rng), want = gsl_rng_uniform(gsl);
        ok = gen_check(g, same(x, want), "draw %llu is %a, GSL's %a", (unsigned long long)k, x, want);
    }
    gsl_rng_free(gsl);
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

verdict prop_rng_fill(gen *g)
{
    uint64_t seed;
    et_rng *a = draw_rng(g, &seed), *b = make(seed);
    size_t n = (size_t)gen_upto(g, 700);
    double x[701];
    bool ok = a && b;
    if (ok) {
        et_rng_seek(b, et_rng_tell(a));
        x[n] = 5.0;
        et_rng_fill(x, n, a);
        for (size_t i = 0; ok && i < n; i++) {
            ok = gen_check(g, same(x[i], et_rng_uniform(b)), "number %zu of %zu", i, n);
        }
        ok = ok && gen_check(g, x[n] == 5.0, "wrote beyond %zu", n);
        ok = ok && gen_check(g, same(et_rng_uniform(a), et_rng_uniform(b)), "the next one");
    }
    et_rng_free(a);
    et_rng_free(b);
    return ok ? PASS : FAIL;
}

/* The header's rule, on the draws of a twin: exact integers of 64 bits, the remainders by %. */
static uint64_t index_again(et_rng *rng, uint64_t n)
{
    for (;;) {
        uint64_t k = (uint64_t)(et_rng_uniform(rng) * 0x1p32);
        if (n >> 32 == 0) {
            if ((k * n) % (UINT64_C(1) << 32) >= (UINT64_C(1) << 32) % n) {
                return k * n / (UINT64_C(1) << 32);
            }
            continue;
        }
        k = (k << 32) + (uint64_t)(et_rng_uniform(rng) * 0x1p32);
        uint64_t over = (UINT64_MAX % n + 1) % n;
        if (over == 0 || k < UINT64_MAX - over + 1) {
            return k % n;
        }
    }
}

verdict prop_rng_index(gen *g)
{
    static const uint64_t hard[] = {1, 2, 3, UINT64_C(1) << 31, (UINT64_C(1) << 31) + 1, UINT64_C(3) << 30, UINT32_MAX, UINT64_C(1) << 32,
                                    (UINT64_C(1) << 32) + 1, (UINT64_C(1) << 63) + 1, UINT64_MAX, UINT64_C(1) << 63};
    uint64_t seed, n = gen_upto(g, 1) ? hard[gen_upto(g, sizeof hard / sizeof *hard - 1)] : 1 + gen_upto(g, 10000);
    et_rng *a = draw_rng(g, &seed), *b = make(seed);
    bool ok = a && b;
    if (ok) {
        et_rng_seek(b, et_rng_tell(a));
    }
    for (int i = 0; ok && i < 20; i++) {
        uint64_t x = et_rng_index(a, (size_t)n), y = index_again(b, n);
        ok = gen_check(g, x == y && x < n && et_rng_tell(a) == et_rng_tell(b), "below %llu: %llu for %llu", (unsigned long long)n, (unsigned long long)x,
                       (unsigned long long)y);
    }
    et_rng_free(a);
    et_rng_free(b);
    return ok ? PASS : FAIL;
}

verdict prop_rng_normal(gen *g)
{
    uint64_t seed;
    et_rng *a = draw_rng(g, &seed), *b = make(seed);
    double sum = 0.0, squares = 0.0;
    bool ok = a && b;
    if (ok) {
        et_rng_seek(b, et_rng_tell(a));
    }
    for (int i = 0; ok && i < 400; i++) {
        double p, q, s, x = et_rng_normal(a);
        do {
            p = 2.0 * et_rng_uniform(b) - 1.0;
            q = 2.0 * et_rng_uniform(b) - 1.0;
            s = p * p + q * q;
        } while (!(s > 0.0 && s < 1.0));
        double want = p * sqrt(-2.0 * et_real_log(s) / s);
        ok = gen_check(g, same(x, want) && fabs(x) < 9.4 && et_rng_tell(a) == et_rng_tell(b), "%a for %a", x, want);
        sum += x;
        squares += x * x;
    }
    /* Seven standard deviations of the mean and of the mean square (sd sqrt 2). */
    ok = ok && gen_check(g, fabs(sum / 400.0) < 7.0 / 20.0 && fabs(squares / 400.0 - 1.0) < 7.0 * sqrt(2.0) / 20.0, "mean %g, square %g", sum / 400.0,
                         squares / 400.0);
    et_rng_free(a);
    et_rng_free(b);
    return ok ? PASS : FAIL;
}

verdict gold_rng_stream(const row *r)
{
    return row_is_size(r, 0, (size_t)et_rng_stream(row_size(r, 0), row_size(r, 1))) ? PASS : FAIL;
}

/* seed, draws to leave out, then as many as are wanted. */
static verdict replay(const row *r, double (*next)(et_rng *))
{
    et_rng *rng = make(row_size(r, 0));
    bool ok = rng != NULL;
    for (size_t k = row_size(r, 1); ok && k > 0; k--) {
        et_rng_uniform(rng);
    }
    for (size_t i = 0; ok && i < r->nwant; i++) {
        ok = row_is(r, i, next(rng));
    }
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

verdict gold_rng_uniform(const row *r)
{
    return replay(r, et_rng_uniform);
}

verdict gold_rng_normal(const row *r)
{
    return replay(r, et_rng_normal);
}

verdict gold_rng_seek(const row *r)
{
    et_rng *rng = make(row_size(r, 0));
    bool ok = rng != NULL;
    if (ok) {
        et_rng_seek(rng, row_size(r, 1));
        ok = row_is(r, 0, et_rng_uniform(rng));
    }
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

verdict gold_rng_fill(const row *r)
{
    double x[64];
    et_rng *rng = make(row_size(r, 0));
    bool ok = rng != NULL && r->nwant <= 64;
    if (ok) {
        et_rng_seek(rng, row_size(r, 1));
        et_rng_fill(x, r->nwant, rng);
    }
    for (size_t i = 0; ok && i < r->nwant; i++) {
        ok = row_is(r, i, x[i]);
    }
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}

/* seed, n, and the indices in turn, then the draws they took. */
verdict gold_rng_index(const row *r)
{
    et_rng *rng = make(row_size(r, 0));
    bool ok = rng != NULL;
    for (size_t i = 0; ok && i + 1 < r->nwant; i++) {
        ok = row_is_size(r, i, et_rng_index(rng, row_size(r, 1)));
    }
    ok = ok && row_is_size(r, r->nwant - 1, (size_t)et_rng_tell(rng));
    et_rng_free(rng);
    return ok ? PASS : FAIL;
}
