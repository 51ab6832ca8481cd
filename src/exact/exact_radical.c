/* exact_radical: distances between points, and their sums. */
#include "exact/exact_radical_parts.h"

enum { LEAST_BITS = 2, DOUBLINGS = 2 }; /* a tie is looked for after so many */

size_t exact_first_bits(const size_t *bits)
{
    if (bits == NULL || *bits == 0)
        return EXACT_BITS;
    return *bits < LEAST_BITS ? LEAST_BITS : *bits < EXACT_MOST_BITS ? *bits : EXACT_MOST_BITS;
}

void exact_net_align(exact_net *net, slong e)
{
    for (size_t k = 0; k < net->n; k++) {
        fmpz *H = net->H + EXACT_COMPONENTS * k;
        _fmpz_vec_scalar_mul_2exp(H, H, 3, (ulong)(net->e - e));
    }
    net->e = e;
}

void exact_gap(fmpz_t num, fmpz_t den, const fmpz *A, slong a, const fmpz *B, slong b)
{
    fmpz_t x, y;

    fmpz_init(x);
    fmpz_init(y);
    fmpz_zero(num);
    for (size_t c = 0; c < 3; c++) {
        fmpz_mul(x, A + c, B + 3);
        fmpz_mul(y, B + c, A + 3);
        fmpz_mul_2exp(x, x, a > b ? (ulong)(a - b) : 0);
        fmpz_mul_2exp(y, y, b > a ? (ulong)(b - a) : 0);
        fmpz_sub(x, x, y);
        fmpz_addmul(num, x, x);
    }
    fmpz_mul(den, A + 3, B + 3);
    fmpz_clear(x);
    fmpz_clear(y);
}

double exact_root(const fmpz_t num, const fmpz_t den, slong e)
{
    double x;
    fmpz_t d;
    fmpq_t q;

    fmpz_init(d);
    fmpq_init(q);
    fmpz_mul(d, den, den);
    fmpq_set_fmpz_frac(q, num, d);
    exact_scale(q, 2 * e);
    x = exact_round_sqrt(q);
    fmpz_clear(d);
    fmpq_clear(q);
    return x;
}

/* The sum as a ball. */
static void enclose(arb_t sum, const fmpz *num, const fmpz *den, size_t n, slong e, size_t divisor, slong prec)
{
    arb_t x;

    arb_init(x);
    arb_zero(sum);
    for (size_t k = 0; k < n; k++) {
        arb_sqrt_fmpz(x, num + k, prec);
        if (den != NULL)
            arb_div_fmpz(x, x, den + k, prec);
        arb_add(sum, sum, x, prec);
    }
    arb_mul_2exp_si(sum, sum, e);
    arb_div_ui(sum, sum, (ulong)divisor, prec);
    arb_clear(x);
}

static int squares(const fmpz *num, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (!fmpz_is_square(num + k))
            return 0;
    return 1;
}

/* p/q = sum of sqrt(num[k])/den[k], all of them whole numbers' roots; by halves, so that only the last numbers are long. */
static void add_rationals(fmpz_t p, fmpz_t q, const fmpz *num, const fmpz *den, size_t n)
{
    fmpz_t a, b;

    if (n == 1) {
        fmpz_sqrt(p, num);
        fmpz_one(q);
        if (den != NULL)
            fmpz_set(q, den);
        return;
    }
    fmpz_init(a);
    fmpz_init(b);
    add_rationals(p, q, num, den, n / 2);
    add_rationals(a, b, num + n / 2, den == NULL ? NULL : den + n / 2, n - n / 2);
    if (fmpz_equal(q, b)) {
        fmpz_add(p, p, a);
    } else {
        fmpz_mul(p, p, b);
        fmpz_addmul(p, a, q);
        fmpz_mul(q, q, b);
    }
    fmpz_clear(a);
    fmpz_clear(b);
}

static double rational_sum(const fmpz *num, const fmpz *den, size_t n, slong e, size_t divisor)
{
    double x;
    fmpz_t p, q;
    fmpq_t sum;

    fmpz_init(p);
    fmpz_init(q);
    fmpq_init(sum);
    add_rationals(p, q, num, den, n);
    fmpz_mul_ui(q, q, (ulong)divisor);
    fmpq_set_fmpz_frac(sum, p, q);
    exact_scale(sum, e);
    x = exact_round(sum);
    fmpz_clear(p);
    fmpz_clear(q);
    fmpq_clear(sum);
    return x;
}

/* Positive radicals are linearly independent over the rationals but for those whose quotients are rational (Besicovitch 1940, Mordell 1953).  Square
 * roots of rationals that come with positive factors only add up to a rational, therefore, only if each is rational; a sum that is not is no
 * midpoint of two doubles, and the doubling comes to an end. */
double exact_root_sum(const fmpz *num, const fmpz *den, size_t n, slong e, size_t divisor, size_t *bits)
{
    double x = 0;
    size_t prec = *bits;
    arb_t sum;

    arb_init(sum);
    enclose(sum, num, den, n, e, divisor, (slong)prec);
    for (size_t doublings = 0; !exact_round_ball(&x, sum); doublings++) {
        if (doublings == DOUBLINGS && squares(num, n)) {
            x = rational_sum(num, den, n, e, divisor);
            break;
        }
        prec *= 2;
        enclose(sum, num, den, n, e, divisor, (slong)prec);
    }
    arb_clear(sum);
    *bits = prec;
    return x;
}
