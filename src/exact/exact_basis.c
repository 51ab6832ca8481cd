#include "exact/exact_sums_parts.h"

/* u[0..n-1] as rationals. */
static fmpq *rationals(const double *u, size_t n)
{
    fmpq *q = _fmpq_vec_init((slong)n);
    for (size_t i = 0; i < n; i++) {
        exact_set(q + i, u[i]);
    }
    return q;
}

/* N[0..p], the functions of degree p that are not zero in the span [t[-1], t[0]) of the knots around t: Cox-de Boor, a function at a time from the
 * right, so that those of one degree take the place of those of the last. */
static void values(fmpq *N, const fmpq *t, size_t p, const fmpq_t x)
{
    fmpq_t a, b;
    fmpq_init(a);
    fmpq_init(b);
    fmpq_one(N);
    for (size_t j = 1; j <= p; j++) {
        fmpq_zero(N + j);
        for (size_t r = j; r-- > 0;) {
            /* N[r] of degree j-1 lives on [lo, hi]: it gives (hi - x)/(hi - lo) of itself to N[r] and the rest to N[r+1]. */
            const fmpq *hi = t + r, *lo = hi - j;
            fmpq_sub(a, x, lo);
            fmpq_sub(b, hi, lo);
            fmpq_div(a, a, b);
            fmpq_mul(a, a, N + r);
            fmpq_sub(N + r, N + r, a);
            fmpq_add(N + r + 1, N + r + 1, a);
        }
    }
    fmpq_clear(a);
    fmpq_clear(b);
}

/* From the derivatives D[0..p-1] of the functions of degree p-1 the next ones of degree p (Eq. 2.7). */
static void differentiate(fmpq *D, const fmpq *t, size_t p)
{
    fmpq_t b;
    fmpq_init(b);
    fmpq_zero(D + p);
    for (size_t r = p; r-- > 0;) {
        fmpq_sub(b, t + r, t + r - p);
        fmpq_div(b, D + r, b);
        fmpq_mul_ui(b, b, (ulong)p);
        fmpq_neg(D + r, b);
        fmpq_add(D + r + 1, D + r + 1, b);
    }
    fmpq_clear(b);
}

void exact_basis(fmpq *D, size_t d, const double *u, size_t nu, size_t p, size_t span, double x)
{
    double lo = u[p], hi = u[nu - p - 1];
    fmpq *t = rationals(u + span + 1 - p, 2 * p + 1);        /* one more than 2p, so that there is one for p = 0 */
    fmpq_t y;
    fmpq_init(y);
    exact_set(y, x < lo ? lo : x > hi ? hi : x);
    for (size_t k = 0; k <= d && k <= p; k++) {
        fmpq *row = D + k * (p + 1);
        values(row, t + p, p - k, y);
        for (size_t j = p - k + 1; j <= p; j++) {
            differentiate(row, t + p, j);
        }
    }
    for (size_t k = (p + 1) * (p + 1); k < (d + 1) * (p + 1); k++) {
        fmpq_zero(D + k);
    }
    fmpq_clear(y);
    _fmpq_vec_clear(t, (slong)(2 * p + 1));
}

et_status et_exact_basis_eval(double *N, const double *u, size_t nu, size_t p, size_t span, double x)
{
    return et_exact_basis_ders(N, 0, u, nu, p, span, x);
}

et_status et_exact_basis_ders(double *D, size_t d, const double *u, size_t nu, size_t p, size_t span, double x)
{
    size_t n;
    if (d == SIZE_MAX || !exact_fits(&n, d + 1, p + 1)) {
        return ET_ENOMEM;
    }
    fmpq *E = _fmpq_vec_init((slong)n);
    exact_basis(E, d, u, nu, p, span, x);
    for (size_t k = 0; k < n; k++) {
        D[k] = exact_round(E + k);
    }
    _fmpq_vec_clear(E, (slong)n);
    return ET_OK;
}
