/* base/dd: every operation against MPFR with room for all bits: the exact ones exactly, the others within their proved bounds. */
#include "etalon/base/dd.h"
#include "gen.h"
#include "golden.h"
#include <float.h>
#include <math.h>
#include <mpfr.h>

enum { BITS = 2200 };                     /* exponents from -1074 to 1023, and some */

/* x 2^e, 1 <= |x| < 2, low <= e <= high; half of the numbers have few bits, so that carries and ties come. */
static double draw_double(gen *g, int low, int high)
{
    const double many = 1 + (double)gen_upto(g, UINT64_C(0xfffffffffffff)) * 0x1p-52, few = 1 + (double)gen_upto(g, 255) * 0x1p-8;
    const double near = 2 - (double)(1 + gen_upto(g, 3)) * 0x1p-52;
    const double m = gen_chance(g, 2) ? many : gen_chance(g, 4) ? near : few;

    return ldexp(gen_chance(g, 2) ? -m : m, low + (int)gen_upto(g, (uint64_t)(high - low)));
}

/* Of normal form; lo is 0, anything up to half an ulp of hi, or close to that. */
static et_dd draw_dd(gen *g, int low, int high)
{
    const double hi = draw_double(g, low, high);
    const double lo = ldexp(draw_double(g, -1, 0), ilogb(hi) - 53 - (gen_chance(g, 2) ? (int)gen_upto(g, 60) : 0));
    const double sum = hi + lo;

    if (gen_chance(g, 3))
        return (et_dd){hi, 0};
    return (et_dd){sum, lo - (sum - hi)};
}

static void set(mpfr_t r, et_dd a)
{
    mpfr_set_d(r, a.hi, MPFR_RNDN);
    mpfr_add_d(r, r, a.lo, MPFR_RNDN);
}

static bool normal(gen *g, et_dd a)
{
    return gen_check(g, a.hi + a.lo == a.hi, "%a + %a is not in normal form", a.hi, a.lo);
}

/* |got - exact| <= bound |exact|, the bound in u^2; exact is cleared. */
static bool within(gen *g, et_dd got, mpfr_t exact, double bound, const char *what)
{
    mpfr_t error;

    mpfr_init2(error, BITS);
    set(error, got);
    mpfr_sub(error, error, exact, MPFR_RNDN);
    mpfr_div(error, error, exact, MPFR_RNDN);
    const double e = mpfr_zero_p(exact) ? got.hi == 0 && got.lo == 0 ? 0 : HUGE_VAL : fabs(mpfr_get_d(error, MPFR_RNDU)) * 0x1p106;
    mpfr_clears(error, exact, (mpfr_ptr)0);
    return normal(g, got) && gen_check(g, e <= bound, "%s: error %g u^2 above %g", what, e, bound);
}

verdict prop_dd_two_sum(gen *g)
{
    const bool wide = gen_chance(g, 4);
    const int low = wide ? -1074 : -60, high = wide ? 1021 : 60;
    const double a = draw_double(g, low, high), b = gen_chance(g, 8) ? 0 : draw_double(g, low, high);
    const et_dd s = et_dd_two_sum(a, b), t = et_dd_two_sum(b, a), minus = et_dd_two_sum(a, -a);
    mpfr_t exact;

    mpfr_init2(exact, BITS);
    mpfr_set_d(exact, a, MPFR_RNDN);
    mpfr_add_d(exact, exact, b, MPFR_RNDN);
    bool ok = gen_check(g, s.hi == a + b && s.hi == t.hi && s.lo == t.lo, "%a + %a: hi %a", a, b, s.hi);
    ok = ok && gen_check(g, minus.hi == 0 && minus.lo == 0, "%a less itself", a);
    return within(g, s, exact, 0, "two_sum") && ok ? PASS : FAIL;
}

verdict prop_dd_two_product(gen *g)
{
    const int low = gen_chance(g, 4) ? -480 : -60, high = low == -480 ? 500 : 60;
    double a = draw_double(g, low, high);
    const double b = gen_chance(g, 8) ? 0 : draw_double(g, low, high);

    if (gen_chance(g, 4)) /* one large, one small, to the ends of the range: 2^-968 <= |a b| */
        a = b == 0 ? ldexp(a, 400) : ldexp(a / fabs(a), -968 - ilogb(b));
    if (fabs(a) > 0x1p995)
        a = 1;
    const et_dd p = et_dd_two_product(a, b), q = et_dd_two_product(b, a);
    mpfr_t exact;
    mpfr_init2(exact, BITS);
    mpfr_set_d(exact, a, MPFR_RNDN);
    mpfr_mul_d(exact, exact, b, MPFR_RNDN);
    bool ok = gen_check(g, p.hi == a * b && p.hi == q.hi && p.lo == q.lo, "%a times %a: hi %a", a, b, p.hi);
    return within(g, p, exact, 0, "two_product") && ok ? PASS : FAIL;
}

/* Close in size, or b near -a so that most cancels. */
static void draw_summands(gen *g, et_dd *a, et_dd *b)
{
    const bool wide = gen_chance(g, 4);

    *a = draw_dd(g, wide ? -960 : -30, wide ? 1019 : 30);
    *b = draw_dd(g, wide ? -960 : -30, wide ? 1019 : 30);
    if (gen_chance(g, 3)) {
        const et_dd near = {-a->hi, -a->lo};
        *b = near;
        if (gen_chance(g, 2))
            b->lo = nextafter(b->lo, 0);
        else if (gen_chance(g, 2))
            *b = (et_dd){nextafter(b->hi, 0), 0};
    }
}

verdict prop_dd_add(gen *g)
{
    et_dd a, b;
    mpfr_t exact;

    draw_summands(g, &a, &b);
    mpfr_init2(exact, BITS);
    set(exact, a);
    mpfr_add_d(exact, exact, b.hi, MPFR_RNDN);
    mpfr_add_d(exact, exact, b.lo, MPFR_RNDN);
    return within(g, et_dd_add(a, b), exact, 3.0000001, "add") ? PASS : FAIL;
}

verdict prop_dd_sub(gen *g)
{
    et_dd a, b;
    mpfr_t exact;

    draw_summands(g, &a, &b);
    mpfr_init2(exact, BITS);
    set(exact, a);
    mpfr_sub_d(exact, exact, b.hi, MPFR_RNDN);
    mpfr_sub_d(exact, exact, b.lo, MPFR_RNDN);
    return within(g, et_dd_sub(a, b), exact, 3.0000001, "sub") ? PASS : FAIL;
}

verdict prop_dd_mul(gen *g)
{
    const bool wide = gen_chance(g, 4);
    const int low = wide ? -449 : -30, high = wide ? 508 : 30;
    const et_dd a = draw_dd(g, low, high), b = gen_chance(g, 8) ? (et_dd){0, 0} : draw_dd(g, low, high);
    mpfr_t exact, other;

    mpfr_inits2(BITS, exact, other, (mpfr_ptr)0);
    set(exact, a);
    set(other, b);
    mpfr_mul(exact, exact, other, MPFR_RNDN);
    mpfr_clear(other);
    return within(g, et_dd_mul(a, b), exact, 7, "mul") ? PASS : FAIL;
}

verdict prop_dd_div(gen *g)
{
    const bool wide = gen_chance(g, 4);
    const int low = wide ? -449 : -30, high = wide ? 450 : 30;
    const et_dd a = gen_chance(g, 8) ? (et_dd){0, 0} : draw_dd(g, low, high), b = draw_dd(g, low, high);
    mpfr_t exact, other;

    mpfr_inits2(BITS, exact, other, (mpfr_ptr)0);
    set(exact, a);
    set(other, b);
    mpfr_div(exact, exact, other, MPFR_RNDN);
    mpfr_clear(other);
    return within(g, et_dd_div(a, b), exact, 15.0000001, "div") ? PASS : FAIL;
}

verdict prop_dd_sqrt(gen *g)
{
    const bool wide = gen_chance(g, 4);
    et_dd a = draw_dd(g, wide ? -899 : -30, wide ? 1020 : 30);
    const et_dd zero = et_dd_sqrt((et_dd){0, 0}), minus = et_dd_sqrt((et_dd){-0.0, 0}), none = et_dd_sqrt((et_dd){-1, 0});
    mpfr_t exact;

    if (a.hi < 0)
        a = (et_dd){-a.hi, -a.lo};
    mpfr_init2(exact, BITS);
    set(exact, a);
    mpfr_sqrt(exact, exact, MPFR_RNDN);
    bool ok = gen_check(g, zero.hi == 0 && zero.lo == 0 && minus.hi == 0 && signbit(minus.hi) && minus.lo == 0, "roots of zero");
    ok = ok && gen_check(g, isnan(none.hi), "root of -1");
    return within(g, et_dd_sqrt(a), exact, 3.125, "sqrt") && ok ? PASS : FAIL;
}

static verdict is(const row *r, et_dd got)
{
    const bool hi = row_is(r, 0, got.hi), lo = row_is(r, 1, got.lo);

    return hi && lo ? PASS : FAIL;
}

static et_dd operand(const row *r, size_t i)
{
    return (et_dd){row_real(r, i), row_real(r, i + 1)};
}

verdict gold_dd_two_sum(const row *r)
{
    return is(r, et_dd_two_sum(row_real(r, 0), row_real(r, 1)));
}

verdict gold_dd_two_product(const row *r)
{
    return is(r, et_dd_two_product(row_real(r, 0), row_real(r, 1)));
}

verdict gold_dd_add(const row *r)
{
    return is(r, et_dd_add(operand(r, 0), operand(r, 2)));
}

verdict gold_dd_sub(const row *r)
{
    return is(r, et_dd_sub(operand(r, 0), operand(r, 2)));
}

verdict gold_dd_mul(const row *r)
{
    return is(r, et_dd_mul(operand(r, 0), operand(r, 2)));
}

verdict gold_dd_div(const row *r)
{
    return is(r, et_dd_div(operand(r, 0), operand(r, 2)));
}

verdict gold_dd_sqrt(const row *r)
{
    return is(r, et_dd_sqrt(operand(r, 0)));
}
