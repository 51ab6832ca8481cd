#include "exact/exact_parts.h"
#include <math.h>

/* The last binary place of the doubles from 2^E to 2^(E+1), and the place beyond all of them. */
enum { DIGITS = 53, LAST_PLACE = -1074, BEYOND = 1025 };

void exact_set(fmpq_t q, double x)
{
    int e;
    double m = frexp(x, &e);
    fmpz_set_d(fmpq_numref(q), ldexp(m, DIGITS));
    fmpz_one(fmpq_denref(q));
    if (e >= DIGITS) {
        fmpq_mul_2exp(q, q, (flint_bitcnt_t)(e - DIGITS));
    } else {
        fmpq_div_2exp(q, q, (flint_bitcnt_t)(DIGITS - e));
    }
}

/* floor(log2(n/d)), n and d positive. */
static slong magnitude(const fmpz_t n, const fmpz_t d)
{
    slong e = (slong)fmpz_bits(n) - (slong)fmpz_bits(d);     /* 2^(e-1) < n/d < 2^(e+1) */
    fmpz_t t;
    fmpz_init(t);
    if (e >= 0) {
        fmpz_mul_2exp(t, d, (ulong)e);
        e -= fmpz_cmp(n, t) < 0;
    } else {
        fmpz_mul_2exp(t, n, (ulong)-e);
        e -= fmpz_cmp(t, d) < 0;
    }
    fmpz_clear(t);
    return e;
}

/* n/d = (n/d) / 2^place. */
static void shift(fmpz_t n, fmpz_t d, slong place)
{
    if (place >= 0) {
        fmpz_mul_2exp(d, d, (ulong)place);
    } else {
        fmpz_mul_2exp(n, n, (ulong)-place);
    }
}

/* The place of the last digit of a double in [2^e, 2^(e+1)). */
static slong last_place(slong e)
{
    return e - (DIGITS - 1) > LAST_PLACE ? e - (DIGITS - 1) : LAST_PLACE;
}

/* The double k 2^place or (k+1) 2^place: the exact multiple lies above the middle between the two (above > 0), at it (0), or below.  Neither
 * exceeds 2^53, so the product is exact or overflows. */
static double assemble(fmpz_t k, int above, slong place)
{
    if (above > 0 || (above == 0 && fmpz_is_odd(k))) {
        fmpz_add_ui(k, k, 1);
    }
    return ldexp(fmpz_get_d(k), (int)place);
}

/* The double nearest to n/d, both positive; both are overwritten. */
static double round_ratio(fmpz_t n, fmpz_t d)
{
    fmpz_t k, r;
    slong e = magnitude(n, d), place = last_place(e);
    if (e >= BEYOND) {
        return HUGE_VAL;
    }
    fmpz_init(k);
    fmpz_init(r);
    shift(n, d, place);
    fmpz_fdiv_qr(k, r, n, d);
    fmpz_mul_2exp(r, r, 1);
    double x = assemble(k, fmpz_cmp(r, d), place);
    fmpz_clear(k);
    fmpz_clear(r);
    return x;
}

/* The double nearest to sqrt(n/d), both positive; both are overwritten.  With k = floor(sqrt(m)), m = n/d / 4^place, the root is above the middle
 * where 4 m > (2k + 1)^2. */
static double round_root(fmpz_t n, fmpz_t d)
{
    fmpz_t k, t;
    slong e = magnitude(n, d);
    e = e >= 0 ? e / 2 : -((1 - e) / 2);                     /* floor(e / 2) */
    if (e >= BEYOND) {
        return HUGE_VAL;
    }
    slong place = last_place(e);
    fmpz_init(k);
    fmpz_init(t);
    shift(n, d, 2 * place);
    fmpz_fdiv_q(k, n, d);
    fmpz_sqrt(k, k);
    fmpz_mul_ui(t, k, 2);
    fmpz_add_ui(t, t, 1);
    fmpz_mul(t, t, t);
    fmpz_mul(t, t, d);
    fmpz_mul_2exp(n, n, 2);
    double x = assemble(k, fmpz_cmp(n, t), place);
    fmpz_clear(k);
    fmpz_clear(t);
    return x;
}

static double round_by(double (*rounding)(fmpz_t n, fmpz_t d), const fmpq_t q)
{
    fmpz_t n, d;
    if (fmpq_is_zero(q)) {
        return 0.0;
    }
    fmpz_init(n);
    fmpz_init_set(d, fmpq_denref(q));
    fmpz_abs(n, fmpq_numref(q));
    double x = rounding(n, d);
    fmpz_clear(n);
    fmpz_clear(d);
    return fmpq_sgn(q) < 0 && x != 0.0 ? -x : x;
}

double exact_round(const fmpq_t q)
{
    return round_by(round_ratio, q);
}

double exact_round_sqrt(const fmpq_t q)
{
    return round_by(round_root, q);
}

/* Rounding is monotone: what holds at both ends of the ball holds in it. */
int exact_round_ball(double *x, const arb_t ball)
{
    arf_t end;
    if (!arb_is_finite(ball)) {
        return 0;
    }
    arf_init(end);
    arf_set_mag(end, arb_radref(ball));
    arf_sub(end, arb_midref(ball), end, ARF_PREC_EXACT, ARF_RND_DOWN);
    double lo = arf_get_d(end, ARF_RND_NEAR);
    arf_set_mag(end, arb_radref(ball));
    arf_add(end, arb_midref(ball), end, ARF_PREC_EXACT, ARF_RND_DOWN);
    double hi = arf_get_d(end, ARF_RND_NEAR);
    arf_clear(end);
    if (!(lo == hi)) {
        return 0;
    }
    *x = lo == 0.0 ? 0.0 : lo;
    return 1;
}
