/* The rows of dd computed once more, in rationals: the wanted pair is the exact result's nearest double and that of what is left. */
#include "exact/exact_parts.h"
#include "golden.h"

/* q = the sum of the pair of arguments at i. */
static void operand(fmpq_t q, const row *r, size_t i)
{
    fmpq_t lo;

    fmpq_init(lo);
    exact_set(q, row_real(r, i));
    exact_set(lo, row_real(r, i + 1));
    fmpq_add(q, q, lo);
    fmpq_clear(lo);
}

static verdict pair(const row *r, const fmpq_t q)
{
    const double hi = exact_round(q);
    fmpq_t rest;

    fmpq_init(rest);
    exact_set(rest, hi);
    fmpq_sub(rest, q, rest);
    const double lo = exact_round(rest);
    fmpq_clear(rest);
    return row_is(r, 0, hi) && row_is(r, 1, lo) ? PASS : FAIL;
}

static verdict binary(const row *r, void (*operation)(fmpq_t, const fmpq_t, const fmpq_t))
{
    fmpq_t a, b;

    fmpq_init(a);
    fmpq_init(b);
    operand(a, r, 0);
    operand(b, r, 2);
    operation(a, a, b);
    const verdict v = pair(r, a);
    fmpq_clear(a);
    fmpq_clear(b);
    return v;
}

verdict true_dd_add(const row *r)
{
    return binary(r, fmpq_add);
}

verdict true_dd_sub(const row *r)
{
    return binary(r, fmpq_sub);
}

verdict true_dd_mul(const row *r)
{
    return binary(r, fmpq_mul);
}

verdict true_dd_div(const row *r)
{
    return binary(r, fmpq_div);
}

/* The rest of the root as a ball of a precision at which, in these rows, it has one rounding. */
verdict true_dd_sqrt(const row *r)
{
    enum { BITS = 4000 };
    fmpq_t a;
    arb_t root, hi_ball;
    double lo = 0;

    fmpq_init(a);
    arb_init(root);
    arb_init(hi_ball);
    operand(a, r, 0);
    if (fmpq_sgn(a) < 0) {                    /* not a number, which nobody computes otherwise */
        fmpq_clear(a);
        arb_clear(root);
        arb_clear(hi_ball);
        return SKIP;
    }
    const double hi = exact_round_sqrt(a);
    arb_set_fmpq(root, a, BITS);
    arb_sqrt(root, root, BITS);
    arb_set_d(hi_ball, hi);
    arb_sub(root, root, hi_ball, BITS);
    const int known = exact_round_ball(&lo, root);
    arb_clear(root);
    arb_clear(hi_ball);
    fmpq_clear(a);
    return known && row_is(r, 0, hi) && row_is(r, 1, lo) ? PASS : FAIL;
}
