/* spline/knots: each promise by a walk over all knots. */
#include "etalon/spline/knots.h"
#include "golden.h"
#include "reference.h"
#include <float.h>
#include <stdint.h>

/* A degree, a number of knots and knots for them. */
static size_t draw(gen *g, double *u, size_t *p)
{
    *p = (size_t)gen_upto(g, 5);
    size_t nu = 2 * *p + 2 + (size_t)gen_upto(g, 12);
    ref_draw_knots(g, u, nu, *p);
    return nu;
}

verdict prop_knots_valid(gen *g)
{
    double u[REF_KNOTS];
    size_t p, nu = draw(g, u, &p), at = (size_t)gen_upto(g, nu - 1);
    bool want = u[p] < u[nu - p - 1];
    for (size_t i = 1; i < nu; i++) {
        want = want && (u[i] == u[i - 1] || u[i] - u[i - 1] >= DBL_MIN);
    }
    bool ok = gen_check(g, et_knots_valid(u, nu, p) == want, "valid knots, p = %zu, nu = %zu", p, nu);
    ok = ok && gen_check(g, !et_knots_valid(u, nu, SIZE_MAX) && !et_knots_valid(u, nu, SIZE_MAX / 2) && !et_knots_valid(u, nu, SIZE_MAX / 2 - 1),
                         "a degree beyond all sizes");
    ok = ok && gen_check(g, !et_knots_valid(u, 2 * p + 1, p), "2p + 1 knots");
    double old = u[at];
    switch (gen_upto(g, 2)) {
    case 0:                                   /* out of order by one ulp */
        u[at] = at > 0 ? nextafter(u[at - 1], -HUGE_VAL) : nextafter(u[1], HUGE_VAL);
        ok = ok && gen_check(g, !et_knots_valid(u, nu, p), "knot %zu out of order", at);
        break;
    case 1:
        u[at] = gen_upto(g, 1) ? NAN : at == 0 ? -HUGE_VAL : HUGE_VAL;
        ok = ok && gen_check(g, !et_knots_valid(u, nu, p), "knot %zu not finite", at);
        break;
    default:                                  /* an empty domain in a vector that is not all one knot */
        for (size_t i = p; i + p < nu; i++) {
            u[i] = u[p];
        }
        for (size_t i = nu - p; i < nu; i++) {
            u[i] = fmax(u[i], u[p]);
        }
        ok = ok && gen_check(g, !et_knots_valid(u, nu, p), "an empty domain");
    }
    gen_note(g, "p = %zu, nu = %zu, knot %zu was %a", p, nu, at, old);
    return ok ? PASS : FAIL;
}

/* The limits on distances: 2^-1022 between neighbours, DBL_MAX between the ends. */
verdict prop_knots_valid_distances(gen *g)
{
    size_t p = (size_t)gen_upto(g, 4), nu = 2 * p + 3;
    double u[REF_KNOTS], step = gen_upto(g, 1) ? DBL_MIN : DBL_MIN * (1.0 - 0x1p-52);
    for (size_t i = 0; i < nu; i++) {
        u[i] = i <= p ? 0.0 : i == p + 1 ? step : 1.0;
    }
    bool ok = gen_check(g, et_knots_valid(u, nu, p) == (step == DBL_MIN), "neighbours %a apart", step);
    double reach = gen_upto(g, 1) ? 0.5 * DBL_MAX : 0.5 * DBL_MAX * (1.0 + 0x1p-52);
    for (size_t i = 0; i < nu; i++) {
        u[i] = i <= p ? -reach : i == p + 1 ? 0.0 : reach;
    }
    ok = ok && gen_check(g, et_knots_valid(u, nu, p) == (reach == 0.5 * DBL_MAX), "ends at %a", reach);
    return ok ? PASS : FAIL;
}

verdict prop_knots_clamped(gen *g)
{
    double u[REF_KNOTS];
    size_t p, nu = draw(g, u, &p);
    int want = 1;
    for (size_t i = 0; i < p; i++) {
        want = want && u[i] == u[i + 1] && u[nu - 1 - i] == u[nu - 2 - i];
    }
    bool ok = gen_check(g, et_knots_clamped(u, nu, p) == want, "clamped: %d", !want);
    gen_knots(g, u, nu, p);
    ok = ok && gen_check(g, et_knots_clamped(u, nu, p) == 1, "clamped knots are not");
    if (p > 0) {
        double left = u[0], right = u[nu - 1];
        u[0] = nextafter(left, -1.0);
        ok = ok && gen_check(g, et_knots_clamped(u, nu, p) == 0, "the first knot differs");
        u[0] = left;
        u[nu - 1] = nextafter(right, 2.0);
        ok = ok && gen_check(g, et_knots_clamped(u, nu, p) == 0, "the last knot differs");
    }
    return ok ? PASS : FAIL;
}

verdict prop_knots_span(gen *g)
{
    double u[REF_KNOTS];
    size_t p, nu = draw(g, u, &p);
    if (!et_knots_valid(u, nu, p)) {
        return SKIP;
    }
    double lo = u[p], hi = u[nu - p - 1], x = gen_parameter(g, u, nu, p);
    if (gen_chance(g, 6)) {
        gen_label(g, "outside");
        x = gen_upto(g, 1) ? hi + (hi - lo) : lo - (hi - lo);
    }
    size_t k = et_knots_span(u, nu, p, x);
    bool ok = gen_check(g, k >= p && k <= nu - p - 2 && u[k] < u[k + 1], "span %zu of p = %zu, nu = %zu at %a", k, p, nu, x);
    ok = ok && gen_check(g, k == ref_span(u, nu, p, x), "span %zu, by the walk %zu, at %a", k, ref_span(u, nu, p, x), x);
    if (x >= lo && x < hi) {
        ok = ok && gen_check(g, u[k] <= x && x < u[k + 1], "%a is not in span %zu", x, k);
    } else {
        ok = ok && gen_check(g, x < lo ? u[k] == lo : u[k + 1] == hi, "%a is not clamped: span %zu", x, k);
    }
    return ok ? PASS : FAIL;
}

/* degree, then the knots. */
static size_t knots_of(const row *r, double *u)
{
    size_t n = r->nargs - 1;
    for (size_t i = 0; i < n && i < REF_KNOTS; i++) {
        u[i] = row_real(r, i + 1);
    }
    return n;
}

verdict gold_knots_valid(const row *r)
{
    double u[REF_KNOTS];
    size_t nu = knots_of(r, u);
    return row_is_size(r, 0, (size_t)et_knots_valid(u, nu, row_size(r, 0))) ? PASS : FAIL;
}

verdict gold_knots_clamped(const row *r)
{
    double u[REF_KNOTS];
    size_t nu = knots_of(r, u);
    return row_is_size(r, 0, (size_t)et_knots_clamped(u, nu, row_size(r, 0))) ? PASS : FAIL;
}

/* degree, the knots, the parameter. */
verdict gold_knots_span(const row *r)
{
    double u[REF_KNOTS];
    size_t nu = knots_of(r, u) - 1;
    return row_is_size(r, 0, et_knots_span(u, nu, row_size(r, 0), u[nu])) ? PASS : FAIL;
}
