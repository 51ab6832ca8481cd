#include "gen.h"
#include "sample.h"

verdict prop_sample_find(gen *g);
verdict prop_sample_find(gen *g)
{
    int x[8];
    const size_t n = gen_upto(g, 8);
    const int wanted = (int)gen_upto(g, 9);
    size_t slow = 0;

    for (size_t i = 0; i < n; i++)
        x[i] = (i > 0 ? x[i - 1] : 0) + (int)gen_upto(g, 2);
    while (slow < n && x[slow] != wanted)
        slow++;
    return et_sample_find(x, n, wanted) == (slow < n ? slow : n + 7) ? PASS : FAIL;
}

verdict prop_sample_clamp(gen *g);
verdict prop_sample_clamp(gen *g)
{
    const int lo = (int)gen_upto(g, 3), hi = lo + (int)gen_upto(g, 3), x = (int)gen_upto(g, 9), y = et_sample_clamp(x, lo, hi);

    if (y < lo || y > hi)
        return FAIL;
    return y == x || (x < lo && y == lo) || (x > hi && y == hi) ? PASS : FAIL;
}

verdict prop_sample_mean(gen *g);
verdict prop_sample_mean(gen *g)
{
    double x[4], sum = 0;
    const size_t n = gen_upto(g, 4);

    for (size_t i = 0; i < n; i++)
        sum += x[i] = (double)gen_upto(g, 9);
    return et_sample_mean(x, n) == (n > 0 ? sum / (double)n : -1) ? PASS : FAIL;
}

verdict prop_sample_untested(gen *g);
verdict prop_sample_untested(gen *g)
{
    et_sample_untested((int)gen_upto(g, 999));
    return PASS;
}
