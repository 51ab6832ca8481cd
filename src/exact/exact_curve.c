#include "exact/exact_sums_parts.h"
#include <math.h>

/* D[4k + a]: the derivatives of w x, w y, w z and w, up to a common power of two, and in *e another of the first three. */
static void homogeneous(fmpq *D, size_t d, slong *e, const et_curve *c, double x, et_side side)
{
    size_t span = exact_span(c->u, c->n + c->p + 1, c->p, x, side);
    exact_line line;
    exact_net net;
    fmpz *S = _fmpz_vec_init(EXACT_COMPONENTS);
    exact_line_init_at(&line, c->u, c->n, c->p, span, x, d);
    exact_net_init(&net, c->points + line.first, c->weights ? c->weights + line.first : NULL, c->p + 1, 1, 1);
    for (size_t k = 0; k <= d; k++) {
        exact_contract(S, 1, line.row + k, net.H, 1);
        for (size_t a = 0; a < EXACT_COMPONENTS; a++) {
            fmpq_set_fmpz_frac(D + EXACT_COMPONENTS * k + a, S + a, line.row[k].denominator);
        }
    }
    *e = net.e;
    _fmpz_vec_clear(S, EXACT_COMPONENTS);
    exact_net_clear(&net);
    exact_line_clear(&line);
}

/* Eq. 4.8, those of lower order being quotients already: w C^(k) is A^(k) less the sum of C(k,i) w^(i) C^(k-i), i = 1..k. */
static void quotient(fmpq *A, size_t k)
{
    fmpq *C = A + EXACT_COMPONENTS * k;
    fmpz_t b;
    fmpq_t f;
    fmpz_init(b);
    fmpq_init(f);
    for (size_t i = 1; i <= k; i++) {
        if (fmpq_is_zero(A + EXACT_COMPONENTS * i + 3)) {
            continue;
        }
        fmpz_bin_uiui(b, (ulong)k, (ulong)i);
        fmpq_mul_fmpz(f, A + EXACT_COMPONENTS * i + 3, b);
        for (size_t a = 0; a < 3; a++) {
            fmpq_submul(C + a, f, A + EXACT_COMPONENTS * (k - i) + a);
        }
    }
    for (size_t a = 0; a < 3; a++) {
        fmpq_div(C + a, C + a, A + 3);
    }
    fmpz_clear(b);
    fmpq_clear(f);
}

et_status et_exact_curve_point(et_vec3 *C, const et_curve *c, double x)
{
    return et_exact_curve_ders(C, 0, c, x);
}

et_status et_exact_curve_ders(et_vec3 *D, size_t d, const et_curve *c, double x)
{
    return et_exact_curve_ders_side(D, d, c, x, ET_SIDE_RIGHT);
}

et_status et_exact_curve_ders_side(et_vec3 *D, size_t d, const et_curve *c, double x, et_side side)
{
    size_t n;
    slong e;
    if (!et_curve_valid(c) || !isfinite(x)) {
        return ET_EINVAL;
    }
    if (d == SIZE_MAX || !exact_fits(&n, d + 1, c->p + EXACT_COMPONENTS)) {
        return ET_ENOMEM;
    }
    n = EXACT_COMPONENTS * (d + 1);
    fmpq *A = _fmpq_vec_init((slong)n);
    homogeneous(A, d, &e, c, x, side);
    for (size_t k = 0; k <= d; k++) {
        quotient(A, k);
    }
    for (size_t k = 0; k <= d; k++) {
        for (size_t a = 0; a < 3; a++) {
            exact_scale(A + EXACT_COMPONENTS * k + a, e);
        }
        D[k] = exact_round_point(A + EXACT_COMPONENTS * k);
    }
    _fmpq_vec_clear(A, (slong)n);
    return ET_OK;
}
