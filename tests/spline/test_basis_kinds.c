/* spline/basis: in other units, and what derivatives add up to. */
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include "gen.h"
#include "reference.h"

enum { DERIVATIVES = 5, ROOM = (DERIVATIVES + 1) * (REF_DEGREE + 1), WORK = (REF_DEGREE + 1) * (REF_DEGREE + 5) };

/* Knots and parameter times 2^e: the same functions bit for bit, their k-th derivatives 2^-ek times as great. */
verdict prop_basis_ders_scaled(gen *g)
{
    double u[REF_KNOTS], v[REF_KNOTS], D[ROOM], E[ROOM], N[REF_DEGREE + 1], work[WORK];
    size_t p = (size_t)gen_upto(g, REF_DEGREE), nu = 2 * p + 2 + (size_t)gen_upto(g, 12), d = (size_t)gen_upto(g, DERIVATIVES);
    int e = (int)gen_upto(g, 20);

    ref_draw_knots(g, u, nu, p);
    for (size_t i = 0; i < nu; i++) {
        v[i] = ldexp(u[i], e);
    }
    if (!et_knots_valid(u, nu, p)) {
        return SKIP;
    }
    double x = gen_parameter(g, u, nu, p);
    size_t span = et_knots_span(u, nu, p, x);
    et_basis_ders(D, d, u, nu, p, span, x, work, WORK);
    et_basis_ders(E, d, v, nu, p, span, ldexp(x, e), work, WORK);
    et_basis_eval(N, v, nu, p, span, ldexp(x, e), work, WORK);
    bool ok = true;
    for (size_t k = 0; ok && k < (d + 1) * (p + 1); k++) {
        /* Exactly, but for what underflows. */
        double want = ldexp(D[k], -e * (int)(k / (p + 1)));
        ok = gen_check(g, fabs(E[k] - want) <= 0x1p-900, "number %zu times 2^-%d a derivative: %a, not %a", k, e, E[k], want);
        const double n = k <= p ? N[k] : D[k];
        ok = ok && gen_check(g, fabs(n - D[k]) <= 0x1p-900, "function %zu: %a, not %a", k, n, D[k]);
    }
    return ok ? PASS : FAIL;
}

/* The functions add up to 1, their derivatives to 0: each is within 6p + 2 roundings of the sum of its terms' magnitudes, and p additions follow. */
verdict prop_basis_ders_sum(gen *g)
{
    double u[REF_KNOTS], D[ROOM], R[REF_KNOTS], M[REF_KNOTS], work[WORK];
    size_t p = (size_t)gen_upto(g, REF_DEGREE), nu = 2 * p + 2 + (size_t)gen_upto(g, 12), d = (size_t)gen_upto(g, DERIVATIVES);

    ref_draw_knots(g, u, nu, p);
    if (!et_knots_valid(u, nu, p)) {
        return SKIP;
    }
    double x = gen_parameter(g, u, nu, p);
    size_t span = et_knots_span(u, nu, p, x);
    et_basis_ders(D, d, u, nu, p, span, x, work, WORK);
    bool ok = true;
    for (size_t k = 0; ok && k <= d; k++) {
        double sum = 0.0, size = 0.0;
        ref_derivative(R, M, u, nu, p, x, k);
        for (size_t r = 0; r <= p; r++) {
            sum += D[k * (p + 1) + r];
            size += M[span - p + r];
        }
        double bound = (7.0 * (double)p + 3.0) * ET_UNIT * size * (1.0 + 0x1p-30) + 0x1p-500;
        ok = gen_check(g, fabs(sum - (k == 0 ? 1.0 : 0.0)) <= bound, "derivatives %zu add up to %a, within %g", k, sum, bound);
    }
    return ok ? PASS : FAIL;
}
