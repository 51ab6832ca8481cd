/* base/real: exp, log, pow, sin, cos against MPFR at ever more bits, in every case the same double; the first phases against their bounds; and
 * arguments made so that the first phase cannot decide. */
#include "base/real_exp_table.h"
#include "base/real_log_table.h"
#include "base/real_parts.h"
#include "base/real_trig_table.h"
#include "etalon/base/real.h"
#include "gen.h"
#include <math.h>
#include <mpfr.h>

typedef int (*operation)(mpfr_t r, const mpfr_t x, const mpfr_t y, mpfr_rnd_t round);

static int exponential(mpfr_t r, const mpfr_t x, const mpfr_t y, mpfr_rnd_t round)
{
    (void)y;
    return mpfr_exp(r, x, round);
}

static int logarithm(mpfr_t r, const mpfr_t x, const mpfr_t y, mpfr_rnd_t round)
{
    (void)y;
    return mpfr_log(r, x, round);
}

static int sine(mpfr_t r, const mpfr_t x, const mpfr_t y, mpfr_rnd_t round)
{
    (void)y;
    return mpfr_sin(r, x, round);
}

static int cosine(mpfr_t r, const mpfr_t x, const mpfr_t y, mpfr_rnd_t round)
{
    (void)y;
    return mpfr_cos(r, x, round);
}

static int power(mpfr_t r, const mpfr_t x, const mpfr_t y, mpfr_rnd_t round)
{
    return mpfr_pow(r, x, y, round);
}

static bool same(double a, double b)
{
    return real_bits(a) == real_bits(b) || (isnan(a) && isnan(b));
}

/* Bounds from below and above at ever more bits until both round to one double: mpfr_get_d rounds, subnormal numbers and overflow too. */
static double nearest(operation f, double x, double y)
{
    double low = 0, high = 1;

    for (mpfr_prec_t bits = 120; !same(low, high) && bits < 5000; bits *= 2) {
        mpfr_t a, b, r;
        mpfr_inits2(bits, a, b, r, (mpfr_ptr)0);
        mpfr_set_d(a, x, MPFR_RNDN);
        mpfr_set_d(b, y, MPFR_RNDN);
        const int inexact = f(r, a, b, MPFR_RNDD);
        low = high = mpfr_get_d(r, MPFR_RNDN);
        if (inexact) {
            f(r, a, b, MPFR_RNDU);
            high = mpfr_get_d(r, MPFR_RNDN);
        }
        mpfr_clears(a, b, r, (mpfr_ptr)0);
    }
    mpfr_free_cache();
    return low;
}

static bool agrees(gen *g, const char *name, operation f, double got, double x, double y)
{
    const double want = nearest(f, x, y);

    return gen_check(g, same(got, want), "%s of %a (and %a): %a, correctly rounded %a", name, x, y, got, want);
}

/* |value 2^scale - f(x, y)| / bound. */
static double part_of(operation f, double x, double y, et_dd value, int scale, double bound)
{
    mpfr_t a, b, r;
    double q;

    mpfr_inits2(260, a, b, r, (mpfr_ptr)0);
    mpfr_set_d(a, x, MPFR_RNDN);
    mpfr_set_d(b, y, MPFR_RNDN);
    f(r, a, b, MPFR_RNDN);
    mpfr_mul_2si(r, r, -scale, MPFR_RNDN);
    mpfr_sub_d(r, r, value.hi, MPFR_RNDN);
    mpfr_sub_d(r, r, value.lo, MPFR_RNDN);
    mpfr_div_d(r, r, bound, MPFR_RNDN);
    q = fabs(mpfr_get_d(r, MPFR_RNDU));
    mpfr_clears(a, b, r, (mpfr_ptr)0);
    mpfr_free_cache();
    return q;
}

/* The rounding test needs a little room above the error itself. */
static bool bounded(gen *g, const char *name, double part, double x, double y)
{
    return gen_check(g, part <= 0.97, "first phase of %s at %a (and %a): error %g of its bound", name, x, y, part);
}

static double draw_any(gen *g)
{
    return real_of_bits(gen_upto(g, UINT64_MAX));
}

/* Of any size from 2^low to 2^high and either sign. */
static double draw_sized(gen *g, int low, int high)
{
    const int e = low + (int)gen_upto(g, (uint64_t)(high - low));
    const double m = real_of_bits(UINT64_C(0x3ff0000000000000) + gen_upto(g, UINT64_C(0xfffffffffffff)));

    return ldexp(gen_chance(g, 2) ? -m : m, e);
}

/* A few ulps away, or not. */
static double draw_beside(gen *g, double x)
{
    for (uint64_t n = gen_upto(g, 6), up = n & 1; n > 1; n -= 2) {
        x = nextafter(x, up ? HUGE_VAL : -HUGE_VAL);
    }
    return x;
}

/* The double nearest to f(m, y) where m is midway between a drawn double near 1, 1 + k 2^-52, and the next. */
static double draw_midway(gen *g, operation f, double y)
{
    const double k = (double)gen_upto(g, (UINT64_C(1) << gen_upto(g, 40)) - 1), one = gen_chance(g, 2) ? 1 - (k + 1) * 0x1p-53 : 1 + k * 0x1p-52;
    mpfr_t m, e;
    double x;

    mpfr_inits2(120, m, e, (mpfr_ptr)0);
    mpfr_set_d(m, one, MPFR_RNDN);
    mpfr_add_d(m, m, (nextafter(one, 2) - one) / 2, MPFR_RNDN);
    mpfr_set_d(e, y, MPFR_RNDN);
    f(m, m, e, MPFR_RNDN);
    x = mpfr_get_d(m, MPFR_RNDN);
    mpfr_clears(m, e, (mpfr_ptr)0);
    mpfr_free_cache();
    return x;
}

static double draw_exp(gen *g)
{
    static const double edge[] = {0, 0x1.62e42fefa39efp+9, -0x1.74385446d71c4p+9, -0x1.74910d52d3051p+9, -0x1.6232bdd7abcd2p+9, -708, 709, 710, -746};

    switch (gen_upto(g, 5)) {
    case 0:
        return draw_beside(g, edge[gen_upto(g, 8)]);
    case 1:
        return gen_real(g, -746, 710);
    case 2:
        return draw_sized(g, -60, 10);
    case 3:
        return draw_midway(g, logarithm, 0);
    case 4: /* where k changes */
        return draw_beside(g, ((double)gen_upto(g, 1000) - 500.5) * 0x1.62e42fefa39efp-8);
    default:
        return draw_any(g);
    }
}

verdict prop_real_exp(gen *g)
{
    const double x = draw_exp(g), got = et_real_exp(x);
    bool ok = agrees(g, "exp", exponential, got, x, 0);

    ok = ok && gen_check(g, x != 0 || got == 1, "exp(0) is %a", got);
    return ok ? PASS : FAIL;
}

verdict prop_real_exp_bound(gen *g)
{
    const double x = draw_exp(g);
    double r;
    int scale;

    if (!(fabs(x) <= 708))
        return SKIP;
    const et_dd value = real_exp_fast(&scale, x, 0);
    const double part = part_of(exponential, x, 0, value, scale, REAL_EXP_ERROR);
    if (!real_rounds(&r, value, REAL_EXP_ERROR))
        gen_label(g, "not decided");
    return bounded(g, "exp", part, x, 0) && gen_check(g, value.hi > 0.99 && value.hi < 2.01, "hi = %a", value.hi) ? PASS : FAIL;
}

static double draw_log(gen *g)
{
    static const double worst[] = {1, 0x1.01fecdde4c67ap+0, 0x1.01eb696094a7cp+0}; /* 0.31, 0.27 of the bound */
    double x;

    switch (gen_upto(g, 5)) {
    case 0:
        x = 1 + draw_sized(g, -53, -1);
        break;
    case 1: /* where the error is greatest */
        x = gen_chance(g, 4) ? worst[gen_upto(g, 2)] : gen_real(g, 1.0072, 1.0078125);
        break;
    case 2:
        x = gen_real(g, 0, 30);
        break;
    case 3: /* where the table's index changes */
        x = draw_beside(g, 0.6875 + (double)gen_upto(g, 176) / 256);
        break;
    case 4:
        x = fabs(draw_any(g));
        break;
    default:
        x = draw_any(g);
    }
    return x;
}

verdict prop_real_log(gen *g)
{
    const double x = draw_log(g), got = et_real_log(x);
    bool ok = agrees(g, "log", logarithm, got, x, 0);

    ok = ok && gen_check(g, x != 1 || same(got, 0), "log(1) is %a", got);
    return ok ? PASS : FAIL;
}

verdict prop_real_log_bound(gen *g)
{
    const double x = draw_log(g);
    double r;

    if (!(x > 0 && x <= DBL_MAX) || x == 1)
        return gen_check(g, !(real_log_fast(1).hi != 0), "log(1)") ? PASS : FAIL;
    const et_dd value = real_log_fast(x);
    if (!real_rounds(&r, value, REAL_LOG_ERROR * fabs(value.hi)))
        gen_label(g, "not decided");
    const double part = part_of(logarithm, x, 0, value, 0, REAL_LOG_ERROR * fabs(value.hi));
    return bounded(g, "log", part, x, 0) && gen_check(g, value.hi + value.lo == value.hi, "not normal at %a", x) ? PASS : FAIL;
}

/* Base and exponent. */
static void draw_pow(gen *g, double *x, double *y)
{
    static const double special[] = {0.0,  -0.0, 1,   -1,  HUGE_VAL, -HUGE_VAL, NAN,     2,        -2,      0.5,
                                     -0.5, 3,    -3,  1.5, DBL_MAX,  -DBL_MAX,  DBL_MIN, 0x1p-1074, 0x1p53, 0x1.fffffffffffffp52};

    switch (gen_upto(g, 7)) {
    case 0:
        *x = special[gen_upto(g, 19)];
        *y = special[gen_upto(g, 19)];
        break;
    case 1:
        *x = gen_real(g, 0, 4);
        *y = 0.8;
        break;
    case 2: /* of any size, the result in range */
        *x = fabs(draw_sized(g, -1070, 1020));
        *y = gen_real(g, -750, 750) / log(*x);
        break;
    case 3:
        *x = 1 + draw_sized(g, -52, -2);
        *y = gen_real(g, -750, 750) / log(*x);
        break;
    case 4: /* integers: exact powers, midpoints, signs */
        *x = (double)gen_upto(g, 3000) - 1000;
        *y = (double)gen_upto(g, 60) - 10;
        break;
    case 5: /* flat: x^y near a midpoint */
        *y = draw_sized(g, -20, -3);
        *x = draw_midway(g, power, 1 / *y);
        break;
    case 6: /* roots of squares and fourth powers */
        *x = (double)gen_upto(g, 1 << 26);
        *x *= *x;
        *y = ldexp((double)gen_upto(g, 9) - 4, -(int)gen_upto(g, 2));
        break;
    default:
        *x = draw_any(g);
        *y = draw_any(g);
    }
}

verdict prop_real_pow(gen *g)
{
    double x, y;

    draw_pow(g, &x, &y);
    const double got = et_real_pow(x, y);
    bool ok = agrees(g, "pow", power, got, x, y);
    ok = ok && gen_check(g, y != 0 || got == 1, "%a to the power 0 is %a", x, got);
    return ok ? PASS : FAIL;
}

/* The two phases in turn, as et_real_pow uses them. */
verdict prop_real_pow_bound(gen *g)
{
    double x, y;
    int scale;

    draw_pow(g, &x, &y);
    x = fabs(x);
    if (!(x > 0 && x <= DBL_MAX && fabs(y) <= DBL_MAX))
        return PASS;
    const et_dd l = real_log_fast(x);
    if (!(fabs(y * l.hi) < 708 && fabs(y * l.hi) >= 0x1p-55))
        return PASS;
    gen_label(g, "bounded");
    const et_dd w = dd_mul_double(l, y), value = real_exp_fast(&scale, w.hi, w.lo);
    const double part = part_of(power, x, y, value, scale, REAL_EXP_ERROR + 2 * REAL_LOG_ERROR * fabs(w.hi));
    return bounded(g, "pow", part, x, y) ? PASS : FAIL;
}

/* Near multiples of pi/2 and of pi/512, small, huge, and any. */
static double draw_angle(gen *g)
{
    switch (gen_upto(g, 5)) {
    case 0:
        return draw_beside(g, (double)gen_upto(g, 2607) * 0x1.921fb54442d18p+0);
    case 1:
        return draw_beside(g, ((double)gen_upto(g, 4000) - 2000) * 0x1.921fb54442d18p-9);
    case 2:
        return gen_real(g, -4096, 4096);
    case 3:
        return draw_sized(g, -60, 3);
    case 4:
        return draw_sized(g, 10, 1023);
    default:
        return draw_any(g);
    }
}

/* cos is so flat at 0 that arguments of midpoints stay near them; sin is nearly straight there. */
static int arc(mpfr_t r, const mpfr_t x, const mpfr_t y, mpfr_rnd_t round)
{
    (void)y;
    return mpfr_acos(r, x, round);
}

verdict prop_real_sin(gen *g)
{
    const double x = draw_angle(g), got = et_real_sin(x);
    bool ok = agrees(g, "sin", sine, got, x, 0);

    ok = ok && gen_check(g, isnan(got) == !(fabs(x) <= DBL_MAX) && !(fabs(got) > 1), "sin(%a) = %a", x, got);
    return ok ? PASS : FAIL;
}

verdict prop_real_cos(gen *g)
{
    const double flat = draw_midway(g, arc, 0), x = isnan(flat) || gen_chance(g, 2) ? draw_angle(g) : flat, got = et_real_cos(x);
    bool ok = agrees(g, "cos", cosine, got, x, 0);

    ok = ok && gen_check(g, isnan(got) == !(fabs(x) <= DBL_MAX) && !(fabs(got) > 1), "cos(%a) = %a", x, got);
    return ok ? PASS : FAIL;
}

verdict prop_real_sin_bound(gen *g)
{
    const double x = draw_angle(g);
    bool ok = true;

    for (unsigned shift = 0; ok && shift < 2 && fabs(x) <= REAL_TRIG_RANGE && x != 0; shift++) {
        double error, r;
        const et_dd value = real_trig_fast(&error, x, shift);
        if (!real_rounds(&r, value, error))
            gen_label(g, "not decided");
        gen_label(g, "bounded");
        ok = bounded(g, shift ? "cos" : "sin", part_of(shift ? cosine : sine, x, 0, value, 0, error), x, 0);
    }
    return ok ? PASS : FAIL;
}

/* The last resort by itself, special values included; the caller's settings and flags of MPFR stay as they were. */
verdict prop_real_exp_mpfr(gen *g)
{
    static const operation f[] = {exponential, logarithm, sine, cosine, power};
    const mpfr_exp_t least = mpfr_get_emin(), greatest = mpfr_get_emax();
    const size_t which = gen_upto(g, 4);
    double x, y;

    draw_pow(g, &x, &y);
    mpfr_set_emin(-3000);
    mpfr_set_emax(2000);
    mpfr_clear_flags();
    mpfr_set_erangeflag();
    const double got = which == 0 ? real_mpfr_exp(x) : which == 1 ? real_mpfr_log(x) : which == 2 ? real_mpfr_sin(x)
                     : which == 3 ? real_mpfr_cos(x) : real_mpfr_pow(x, y);
    bool ok = gen_check(g, mpfr_get_emin() == -3000 && mpfr_get_emax() == 2000, "range of exponents altered");
    ok = ok && gen_check(g, mpfr_flags_save() == MPFR_FLAGS_ERANGE, "flags altered");
    mpfr_set_emin(least);
    mpfr_set_emax(greatest);
    return ok && agrees(g, "MPFR", f[which], got, x, y) ? PASS : FAIL;
}

/* What no first phase decides, and what is yet right: exact midpoints, powers so flat that they stay near one, and large powers
 * where the logarithm's error alone, times the exponent, reaches beyond one. */
verdict prop_real_pow_last(gen *g)
{
    static const double base[] = {3, 94906267, 7, 9, 81, 0x1.000000043b13bp+0, 0x1.fffff1d0f8aacp-1, 0x1.03a98d4da7e09p+0, 0x1.01e08232ac264p+0,
                                  0x1.01efc19db3299p+0, 0x1.01fe4140e1a9cp+0};
    static const double exponent[] = {34, 2, 19, 17, 8.5, 0x1.4cccccccccccdp-20, -0x1.b333333333333p-18, 0x1.199999999999ap-16,
                                      0x1.62ee03bdd0417p+16, 0x1.6490b09d5ea04p+16, -0x1.5c3a489013757p+16};
    const size_t i = gen_upto(g, 10);
    const et_dd w = dd_mul_double(real_log_fast(base[i]), exponent[i]);
    double r;
    int scale;

    const bool decided = real_rounds(&r, real_exp_fast(&scale, w.hi, w.lo), REAL_EXP_ERROR + 2 * REAL_LOG_ERROR * fabs(w.hi));
    bool ok = gen_check(g, !decided, "%a ^ %a is decided", base[i], exponent[i]);
    ok = ok && agrees(g, "pow", power, et_real_pow(base[i], exponent[i]), base[i], exponent[i]);
    return ok ? PASS : FAIL;
}

/* 1 + x is midway; the others are published as hard (Lefevre and Muller 2001). */
verdict prop_real_exp_last(gen *g)
{
    static const double hard[] = {0x1p-53, -0x1p-54, 0x1.8p-52, -0x1.8p-53, -0x1.12d31a20fb38bp+5, 0x1.9e9cbbfd6080bp-31};
    const double x = hard[gen_upto(g, 5)];
    double r;
    int scale;

    const et_dd value = real_exp_fast(&scale, x, 0);
    bool ok = gen_check(g, !real_rounds(&r, value, REAL_EXP_ERROR), "exp(%a) is decided", x);
    ok = ok && agrees(g, "exp", exponential, et_real_exp(x), x, 0);
    return ok ? PASS : FAIL;
}

/* 1 + z with z^2/2 half an ulp of z, or an odd number of halves: z - z^2/2 is midway. */
verdict prop_real_log_last(gen *g)
{
    static const double z[] = {0x1.8p-50, 0x1.4p-48, 0x1.cp-48, 0x1.ap-46, 0x1.ep-46};
    const double x = 1 + z[gen_upto(g, 4)];
    const et_dd value = real_log_fast(x);
    double r;

    bool ok = gen_check(g, !real_rounds(&r, value, REAL_LOG_ERROR * fabs(value.hi)), "log(%a) is decided", x);
    ok = ok && agrees(g, "log", logarithm, et_real_log(x), x, 0);
    return ok ? PASS : FAIL;
}

/* cos x = 1 - x^2/2 + ..., x^2/2 an odd number of halves of an ulp. */
verdict prop_real_cos_last(gen *g)
{
    static const double hard[] = {0x1.6a09e667f3bcdp-27, 0x1.3988e1409212ep-26, 0x1.94c583ada5b53p-26};
    const double x = hard[gen_upto(g, 2)];
    double r, error;

    const et_dd value = real_trig_fast(&error, x, 1);
    bool ok = gen_check(g, !real_rounds(&r, value, error), "cos(%a) is decided", x);
    ok = ok && agrees(g, "cos", cosine, et_real_cos(x), x, 0);
    return ok ? PASS : FAIL;
}

/* Published as hard (Lefevre and Muller 2001), and beyond the first phase. */
verdict prop_real_sin_last(gen *g)
{
    static const double hard[] = {0x1.598bae9e632f6p-7, 0x1.0102947e7003bp-3, 0x1.005023d32fee5p+1, 0x1.921fb54442d18p+20, DBL_MAX};
    const size_t i = gen_upto(g, 4);
    double r, error;

    const et_dd value = real_trig_fast(&error, i > 2 ? 0 : hard[i], 0);
    bool ok = gen_check(g, i > 2 || !real_rounds(&r, value, error), "sin(%a) is decided", hard[i]);
    ok = ok && agrees(g, "sin", sine, et_real_sin(hard[i]), hard[i], 0);
    return ok ? PASS : FAIL;
}

/* q less the nearest multiple of 2^-bits, which must be `part`; bits 0: part is the nearest double. */
static bool splits(gen *g, mpfr_t q, double part, int bits, const char *what, size_t i)
{
    mpfr_t t;
    double want;

    mpfr_init2(t, 400);
    mpfr_mul_2si(t, q, bits, MPFR_RNDN);
    if (bits)
        mpfr_rint(t, t, MPFR_RNDN);
    mpfr_mul_2si(t, t, -bits, MPFR_RNDN);
    want = mpfr_get_d(t, MPFR_RNDN);
    mpfr_clear(t);
    mpfr_sub_d(q, q, part, MPFR_RNDN);
    return gen_check(g, part == want, "%s %zu: %a, not %a", what, i, part, want);
}

verdict prop_real_exp_table(gen *g)
{
    mpfr_t q;
    bool ok = true;

    mpfr_init2(q, 400);
    for (size_t n = 0, i = gen_upto(g, 127); ok && n < 8; n++, i = (i + 1) % 128) {
        mpfr_set_ui_2exp(q, i, -7, MPFR_RNDN);
        mpfr_exp2(q, q, MPFR_RNDN);
        ok = splits(g, q, exp_table[i][0], 25, "2^(i/128)", i) && splits(g, q, exp_table[i][1], 0, "its rest", i);
    }
    mpfr_const_log2(q, MPFR_RNDN);
    mpfr_div_2ui(q, q, 7, MPFR_RNDN);
    ok = ok && splits(g, q, exp_step, 42, "ln 2 / 128", 0) && splits(g, q, exp_step_rest, 0, "its rest", 0);
    mpfr_const_log2(q, MPFR_RNDN);
    mpfr_ui_div(q, 128, q, MPFR_RNDN);
    ok = ok && splits(g, q, exp_steps, 0, "128 / ln 2", 0);
    mpfr_clear(q);
    mpfr_free_cache();
    return ok ? PASS : FAIL;
}

static bool log_row_right(gen *g, mpfr_t q, size_t i)
{
    const double c = log_table[i][0], low = i < 80 ? (176 + (double)i) / 256 : (48 + (double)i) / 128, high = low + (i < 80 ? 0x1p-8 : 0x1p-7);
    const double most = c == 1 ? 0x1p-7 : 1.0 / 239; /* c m - 1 */

    mpfr_set_d(q, c, MPFR_RNDN);
    mpfr_log(q, q, MPFR_RNDN);
    mpfr_neg(q, q, MPFR_RNDN);
    bool ok = splits(g, q, log_table[i][1], 42, "-ln c", i) && splits(g, q, log_table[i][2], 0, "its rest", i);
    ok = ok && gen_check(g, c * 4096 == floor(c * 4096) && fabs(c * low - 1) <= most && fabs(c * high - 1) <= most, "c %zu: %a", i, c);
    return ok && gen_check(g, (c == 1) == (low == 1 || high == 1), "c %zu: %a", i, c);
}

verdict prop_real_log_table(gen *g)
{
    mpfr_t q;
    bool ok = true;

    mpfr_init2(q, 400);
    for (size_t n = 0, i = gen_upto(g, 127); ok && n < 8; n++, i = (i + 1) % 128)
        ok = log_row_right(g, q, i);
    mpfr_const_log2(q, MPFR_RNDN);
    ok = ok && splits(g, q, log_2, 42, "ln 2", 0) && splits(g, q, log_2_rest, 0, "its rest", 0);
    mpfr_set_ui(q, 1, MPFR_RNDN);
    mpfr_div_ui(q, q, 3, MPFR_RNDN);
    ok = ok && splits(g, q, log_third.hi, 0, "1/3", 0) && splits(g, q, log_third.lo, 0, "its rest", 0);
    mpfr_clear(q);
    mpfr_free_cache();
    return ok ? PASS : FAIL;
}

verdict prop_real_sin_table(gen *g)
{
    mpfr_t q, p;
    bool ok = true;

    mpfr_inits2(400, q, p, (mpfr_ptr)0);
    mpfr_const_pi(p, MPFR_RNDN);
    mpfr_div_2ui(p, p, 9, MPFR_RNDN);
    for (size_t n = 0, j = gen_upto(g, 256); ok && n < 8; n++, j = (j + 1) % 257) {
        mpfr_mul_ui(q, p, j, MPFR_RNDN);
        mpfr_sin(q, q, MPFR_RNDN);
        if (j == 256) /* pi's own error */
            mpfr_set_ui(q, 1, MPFR_RNDN);
        ok = splits(g, q, sine_table[j][0], 26, "sin(j pi/512)", j) && splits(g, q, sine_table[j][1], 0, "its rest", j);
    }
    mpfr_ui_div(q, 1, p, MPFR_RNDN);
    ok = ok && splits(g, q, sine_steps, 0, "512 / pi", 0);
    ok = ok && splits(g, p, sine_step1, 39, "pi/512", 0) && splits(g, p, sine_step2, 72, "its rest", 0) && splits(g, p, sine_step3, 0, "the last", 0);
    mpfr_clears(q, p, (mpfr_ptr)0);
    mpfr_free_cache();
    return ok ? PASS : FAIL;
}
