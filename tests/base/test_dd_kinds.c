/* base/dd: relations between calls.  Powers of two and signs go through every operation, sums and products do not depend on the order, what was added
 * or multiplied is taken away again, and quotient and root solve what they are to solve: within the proved bounds, 3u^2 a sum (and some u^3), 7u^2
 * a product, 15u^2 a quotient, 25/8 u^2 a root. */
#include "etalon/base/dd.h"
#include "gen.h"
#include <math.h>

static const double uu = 0x1p-106;

/* Of normal form, from 2^-30 to 2^31. */
static et_dd drawn(gen *g)
{
    const double m = 1 + (double)gen_upto(g, UINT64_C(0xfffffffffffff)) * 0x1p-52, rest = (double)gen_upto(g, UINT64_C(1) << 52) * 0x1p-52;
    const int e = (int)gen_upto(g, 60) - 30;
    const double hi = ldexp(gen_chance(g, 2) ? -m : m, e), lo = ldexp(gen_chance(g, 2) ? -rest : rest, e - 53 - (int)gen_upto(g, 9)), sum = hi + lo;

    return (et_dd){sum, lo - (sum - hi)};
}

static et_dd scaled(et_dd a, int e)
{
    return (et_dd){ldexp(a.hi, e), ldexp(a.lo, e)};
}

static et_dd negative(et_dd a)
{
    return (et_dd){-a.hi, -a.lo};
}

static bool same(gen *g, et_dd a, et_dd b, const char *what)
{
    return gen_check(g, a.hi == b.hi && a.lo == b.lo, "%s: %a + %a, not %a + %a", what, a.hi, a.lo, b.hi, b.lo);
}

static bool near(gen *g, et_dd a, et_dd b, double bound, const char *what)
{
    return gen_check(g, fabs(et_dd_sub(a, b).hi) <= bound, "%s: off by %g u^2, not by %g", what, fabs(et_dd_sub(a, b).hi) / uu, bound / uu);
}

verdict prop_dd_add_order(gen *g)
{
    const et_dd a = drawn(g), b = drawn(g), sum = et_dd_add(a, b), less = et_dd_sub(a, b);
    bool ok = same(g, et_dd_add(b, a), sum, "b + a") && same(g, et_dd_add(negative(a), negative(b)), negative(sum), "-a - b");

    ok = ok && same(g, et_dd_sub(b, a), negative(less), "b - a") && same(g, et_dd_add(a, negative(b)), less, "a + -b");
    return ok && same(g, et_dd_two_sum(-a.hi, -b.hi), negative(et_dd_two_sum(a.hi, b.hi)), "two_sum") ? PASS : FAIL;
}

verdict prop_dd_add_scaled(gen *g)
{
    const et_dd a = drawn(g), b = drawn(g);
    const int e = (int)gen_upto(g, 400) - 200;
    bool ok = same(g, et_dd_add(scaled(a, e), scaled(b, e)), scaled(et_dd_add(a, b), e), "add");

    ok = ok && same(g, et_dd_sub(scaled(a, e), scaled(b, e)), scaled(et_dd_sub(a, b), e), "sub");
    return ok && same(g, et_dd_two_sum(ldexp(a.hi, e), ldexp(b.hi, e)), scaled(et_dd_two_sum(a.hi, b.hi), e), "two_sum") ? PASS : FAIL;
}

/* (a + b) - b is a: each step's 3u^2 of what it makes. */
verdict prop_dd_sub_back(gen *g)
{
    const et_dd a = drawn(g), b = drawn(g);
    const double size = 6.1 * uu * (fabs(a.hi) + fabs(b.hi));
    const et_dd s = et_dd_two_sum(a.hi, b.hi);
    bool ok = near(g, et_dd_sub(et_dd_add(a, b), b), a, size, "(a + b) - b") && near(g, et_dd_add(et_dd_sub(a, b), b), a, size, "(a - b) + b");

    /* A sum of two doubles is exact, so that taking away one of them leaves the other. */
    return ok && near(g, et_dd_sub(s, (et_dd){b.hi, 0}), (et_dd){a.hi, 0}, 3.1 * uu * fabs(a.hi), "two_sum less b") ? PASS : FAIL;
}

verdict prop_dd_mul_order(gen *g)
{
    const et_dd a = drawn(g), b = drawn(g), product = et_dd_mul(a, b);
    bool ok = same(g, et_dd_mul(b, a), product, "b a") && same(g, et_dd_mul(negative(a), b), negative(product), "-a b");

    ok = ok && same(g, et_dd_div(negative(a), b), negative(et_dd_div(a, b)), "-a / b");
    return ok && same(g, et_dd_two_product(-a.hi, b.hi), negative(et_dd_two_product(a.hi, b.hi)), "two_product") ? PASS : FAIL;
}

verdict prop_dd_mul_scaled(gen *g)
{
    const et_dd a = drawn(g), b = drawn(g), c = a.hi < 0 ? negative(a) : a;
    const int e = (int)gen_upto(g, 200) - 100;
    bool ok = same(g, et_dd_mul(scaled(a, e), b), scaled(et_dd_mul(a, b), e), "mul") && same(g, et_dd_div(scaled(a, e), b), scaled(et_dd_div(a, b),
            e), "div");

    ok = ok && same(g, et_dd_div(a, scaled(b, e)), scaled(et_dd_div(a, b), -e), "div by") && same(g, et_dd_sqrt(scaled(c, 2 * e)),
            scaled(et_dd_sqrt(c), e), "sqrt");
    return ok && same(g, et_dd_two_product(ldexp(a.hi, e), b.hi), scaled(et_dd_two_product(a.hi, b.hi), e), "two_product") ? PASS : FAIL;
}

/* q b is a: 15u^2 of the quotient, 7u^2 of the product; and (a b) / b is a within the same. */
verdict prop_dd_div_back(gen *g)
{
    const et_dd a = drawn(g), b = drawn(g);
    const double size = 22.1 * uu * fabs(a.hi);

    return near(g, et_dd_mul(et_dd_div(a, b), b), a, size, "(a / b) b") && near(g, et_dd_div(et_dd_mul(a, b), b), a, size, "(a b) / b") &&
           near(g, et_dd_div(et_dd_two_product(a.hi, b.hi), (et_dd){b.hi, 0}), (et_dd){a.hi, 0}, 15.1 * uu * fabs(a.hi), "two_product over b")
           ? PASS
           : FAIL;
}

/* r r is a: twice 25/8 u^2, 7u^2 of the product; and the root of a a is |a|: half of 7u^2, and 25/8 u^2. */
verdict prop_dd_sqrt_back(gen *g)
{
    const et_dd b = drawn(g), a = b.hi < 0 ? negative(b) : b, r = et_dd_sqrt(a);

    return near(g, et_dd_mul(r, r), a, 13.3 * uu * a.hi, "root squared") && near(g, et_dd_sqrt(et_dd_mul(a, a)), a, 6.7 * uu * a.hi,
            "root of the square")
           ? PASS
           : FAIL;
}
