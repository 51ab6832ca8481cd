/* planted: properties that are wrong on purpose.  tests/harness.sh knows the simplest counterexample of each, byte by byte. */
#include "gen.h"
#include "golden.h"
#include <math.h>
#include <signal.h>
#include <string.h>

enum { MOST = 20 };

/* A list: its length, then its elements. */
static size_t numbers(gen *g, uint64_t x[MOST], uint64_t max)
{
    const size_t n = gen_upto(g, MOST);

    for (size_t i = 0; i < n; i++)
        x[i] = gen_upto(g, max);
    return n;
}

verdict prop_planted_length(gen *g)
{
    uint64_t x[MOST];

    return numbers(g, x, 1000) >= 5 ? FAIL : PASS;
}

verdict prop_planted_sum(gen *g)
{
    uint64_t x[MOST], sum = 0;
    const size_t n = numbers(g, x, 1000);

    for (size_t i = 0; i < n; i++)
        sum += x[i];
    return gen_check(g, sum < 2500, "the sum is %llu", (unsigned long long)sum) ? PASS : FAIL;
}

verdict prop_planted_twins(gen *g)
{
    uint64_t x[MOST];
    const size_t n = numbers(g, x, 100);

    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < i; j++)
            if (x[i] == x[j] && x[i] != 0)
                return FAIL;
    return PASS;
}

verdict prop_planted_unsorted(gen *g)
{
    uint64_t x[MOST];
    const size_t n = numbers(g, x, 1000);

    for (size_t i = 1; i < n; i++)
        if (x[i] < x[i - 1])
            return FAIL;
    return PASS;
}

/* A list with a mark before each element and one at the end. */
verdict prop_planted_marked(gen *g)
{
    size_t large = 0;

    while (gen_upto(g, 4) > 0)
        large += gen_upto(g, 100) >= 50;
    return large >= 2 ? FAIL : PASS;
}

verdict prop_planted_nested(gen *g)
{
    const size_t n = gen_upto(g, 10);
    bool bad = false;

    for (size_t i = 0; i < n; i++) {
        const size_t m = gen_upto(g, 10);
        bool nine = false;
        for (size_t j = 0; j < m; j++)
            nine |= gen_upto(g, 30) == 9;
        bad |= nine && m >= 3;
    }
    return bad ? FAIL : PASS;
}

verdict prop_planted_large(gen *g)
{
    return gen_upto(g, UINT64_MAX) >= UINT64_C(12345678901) ? FAIL : PASS;
}

verdict prop_planted_odd(gen *g)
{
    const uint64_t x = gen_upto(g, 100000);

    return x > 100 && x % 2 == 1 ? FAIL : PASS;
}

verdict prop_planted_apart(gen *g)
{
    const uint64_t x = gen_upto(g, 100), y = gen_upto(g, 100);

    return x == y + 7 && x > 50 ? FAIL : PASS;
}

verdict prop_planted_real(gen *g)
{
    const double x = gen_real(g, -1, 1);

    return x > 0.3 && x < 1 ? FAIL : PASS;
}

verdict prop_planted_knots(gen *g)
{
    double u[40];
    const size_t p = gen_upto(g, 5), nu = 2 * p + 2 + gen_upto(g, MOST);

    gen_knots(g, u, nu, p);
    for (size_t i = p + 2; i + p + 1 < nu; i++)
        if (u[i] == u[i - 1])
            return FAIL;
    return PASS;
}

verdict prop_planted_points(gen *g)
{
    double xyz[3 * MOST];
    const size_t n = gen_upto(g, MOST);

    gen_points(g, xyz, n);
    for (size_t i = 0; i < n; i++)
        if (xyz[3 * i + 1] < -0.5)
            return FAIL;
    return PASS;
}

/* A reader: brackets that do not match. */
verdict prop_planted_raw(gen *g)
{
    static const sample some[] = { { "f(x) = (1)", 10 }, { "((), ())", 8 }, { "", 0 }, { NULL, 0 } };
    uint8_t text[100];
    const size_t n = gen_rest(g, text, sizeof text, some);
    int depth = 0;

    for (size_t i = 0; i < n; i++)
        depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    return gen_check(g, depth == 0, "depth %d: %.*s", depth, (int)n, (const char *)text) ? PASS : FAIL;
}

verdict prop_planted_crash(gen *g)
{
    uint64_t x[MOST];
    const size_t n = numbers(g, x, 1000);

    for (size_t i = 0; i < n; i++)
        if (x[i] > 777)
            raise(SIGSEGV);
    return PASS;
}

verdict prop_planted_hang(gen *g)
{
    volatile uint64_t x = gen_upto(g, 1000);

    while (x == 999)
        ;
    return PASS;
}

verdict prop_planted_skips(gen *g)
{
    return gen_upto(g, 99) < 92 ? SKIP : PASS;
}

/* The generators keep what gen.h says of them. */
verdict prop_sound_rest(gen *g)
{
    static const sample some[] = { { "0123456789", 10 }, { "a\0b", 3 }, { NULL, 0 } }, none[] = { { NULL, 0 } };
    uint8_t text[17] = { 0 };
    const uint64_t before = gen_upto(g, 3);
    const size_t most = gen_upto(g, 16);
    size_t n;

    memset(text, 0xA5, sizeof text);
    n = gen_rest(g, text, most, before == 3 ? none : some);
    if (n == 10 && memcmp(text, some[0].bytes, 10) == 0)
        gen_label(g, "a sample as it is");
    else
        gen_label(g, n == 0 ? "nothing" : "altered");
    return gen_check(g, n <= most && text[most] == 0xA5, "%zu of %zu bytes", n, most) ? PASS : FAIL;
}

verdict prop_sound_skips(gen *g)
{
    return gen_upto(g, 99) < 85 ? SKIP : PASS;
}

verdict prop_sound_real(gen *g)
{
    static const double ends[6] = { 0, 1, -1, -1.7976931348623157e308, 1.7976931348623157e308, 0x1p-1074 };
    const double a = ends[gen_upto(g, 5)], b = ends[gen_upto(g, 5)];
    const double lo = fmin(a, b), hi = fmax(a, b), x = gen_real(g, lo, hi);

    if (x == lo)
        gen_label(g, "left end");
    if (x == hi)
        gen_label(g, "right end");
    return x >= lo && x <= hi ? PASS : FAIL;
}

verdict prop_sound_knots(gen *g)
{
    double u[64];
    const size_t p = gen_upto(g, 5), inner = gen_upto(g, 30), nu = 2 * p + 2 + inner;
    size_t run = 1;

    gen_knots(g, u, nu, p);
    for (size_t i = 0; i <= p; i++)
        if (!gen_check(g, u[i] == 0 && u[nu - 1 - i] == 1, "clamped on [0,1]"))
            return FAIL;
    for (size_t i = p + 1; i < p + 1 + inner; i++) {
        if (!gen_check(g, u[i] > 0 && u[i] < 1 && u[i] >= u[i - 1], "inside and in order"))
            return FAIL;
        run = u[i] == u[i - 1] ? run + 1 : 1;
        if (!gen_check(g, run <= (p > 0 ? p : 1), "multiplicity at most p"))
            return FAIL;
        if (run == p && p > 1)
            gen_label(g, "full multiplicity");
        if (u[i] == nextafter(u[i - 1], 2))
            gen_label(g, "one ulp apart");
    }
    const double x = gen_parameter(g, u, nu, p);
    if (x == 1)
        gen_label(g, "right end");
    return x >= 0 && x <= 1 ? PASS : FAIL;
}

verdict prop_sound_points(gen *g)
{
    double xyz[3 * MOST];
    const size_t n = gen_upto(g, MOST);

    gen_points(g, xyz, n);
    for (size_t i = 0; i < 3 * n; i++)
        if (!(fabs(xyz[i]) <= 0x1.1p100))
            return FAIL;
    for (size_t i = 1; i < n; i++)
        if (xyz[3 * i] == xyz[0] && xyz[3 * i + 1] == xyz[1] && xyz[3 * i + 2] == xyz[2])
            gen_label(g, "coincident");
    return PASS;
}

/* Nothing depends on the bytes beyond what was drawn, and ranges are kept. */
verdict prop_sound_ranges(gen *g)
{
    const uint64_t max = gen_upto(g, UINT64_MAX), lo = gen_upto(g, max);
    const uint64_t x = gen_upto(g, max), y = gen_between(g, lo, max);

    return x <= max && y >= lo && y <= max && gen_upto(g, 0) == 0 ? PASS : FAIL;
}

verdict gold_planted_half(const row *r)
{
    return row_is(r, 0, row_real(r, 0) / 2) ? PASS : FAIL;
}

verdict true_planted_half(const row *r)
{
    return row_is(r, 0, row_real(r, 0) / 2) ? PASS : FAIL;
}

verdict gold_planted_count(const row *r)
{
    return row_is_size(r, 0, row_size(r, 0) + 1) ? PASS : FAIL;
}

/* Looks at the first wanted value only. */
verdict gold_planted_blind(const row *r)
{
    return row_is(r, 0, row_real(r, 0)) ? PASS : FAIL;
}
