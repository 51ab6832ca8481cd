/* spline/knots: run backwards, and in other units. */
#include "etalon/spline/knots.h"
#include "gen.h"
#include "reference.h"

/* u run backwards: -u[nu-1], .., -u[0]. */
static void turn(double *v, const double *u, size_t nu)
{
    for (size_t i = 0; i < nu; i++) {
        v[i] = -u[nu - 1 - i];
    }
}

/* What is from the right in one is from the left in the other; the mean of knots changes its sign but for its roundings. */
verdict prop_knots_span_turned(gen *g)
{
    double u[REF_KNOTS], v[REF_KNOTS], G[REF_KNOTS], H[REF_KNOTS];
    size_t p = (size_t)gen_upto(g, 5), nu = 2 * p + 2 + (size_t)gen_upto(g, 12), n = nu - p - 1;

    ref_draw_knots(g, u, nu, p);
    turn(v, u, nu);
    bool ok = gen_check(g, et_knots_valid(v, nu, p) == et_knots_valid(u, nu, p) && et_knots_clamped(v, nu, p) == et_knots_clamped(u, nu, p),
            "valid, clamped");
    if (!et_knots_valid(u, nu, p)) {
        return ok ? PASS : FAIL;
    }
    ok = ok && gen_check(g, et_knots_interpolating(v, nu, p) == et_knots_interpolating(u, nu, p), "interpolating");
    double x = gen_parameter(g, u, nu, p);
    size_t right = et_knots_span_side(u, nu, p, x, ET_SIDE_RIGHT), left = et_knots_span_side(u, nu, p, x, ET_SIDE_LEFT);
    ok = ok && gen_check(g, et_knots_multiplicity(v, nu, -x) == et_knots_multiplicity(u, nu, x), "multiplicity of %a", x);
    ok = ok && gen_check(g, et_knots_span_side(v, nu, p, -x, ET_SIDE_LEFT) == nu - 2 - right && et_knots_span_side(v, nu, p, -x,
            ET_SIDE_RIGHT) == nu - 2 - left,
                         "spans %zu and %zu of %zu knots at %a", left, right, nu, x);
    ok = ok && gen_check(g, et_knots_span(v, nu, p, -x) == nu - 2 - left, "span at %a", x);
    et_knots_greville(G, n, u, nu, p);
    et_knots_greville(H, n, v, nu, p);
    for (size_t i = 0; ok && i < n; i++) {
        /* p + 2 roundings of each. */
        size_t first = p == 0 ? i : i + 1, last = p == 0 ? i + 1 : i + p;
        ok = gen_check(g, fabs(G[i] + H[n - 1 - i]) <= 2.0 * ((double)p + 4.0) * ET_UNIT * fmax(fabs(u[first]), fabs(u[last])),
                "Greville point %zu: %a and %a", i,
                       G[i], H[n - 1 - i]);
    }
    return ok ? PASS : FAIL;
}

verdict prop_knots_span_scaled(gen *g)
{
    double u[REF_KNOTS], v[REF_KNOTS], G[REF_KNOTS], H[REF_KNOTS];
    size_t p = (size_t)gen_upto(g, 5), nu = 2 * p + 2 + (size_t)gen_upto(g, 12), n = nu - p - 1;
    int e = (int)gen_upto(g, 60);

    ref_draw_knots(g, u, nu, p);
    for (size_t i = 0; i < nu; i++) {
        v[i] = ldexp(u[i], e);
    }
    if (!et_knots_valid(u, nu, p)) {
        return SKIP;
    }
    double x = gen_parameter(g, u, nu, p), y = ldexp(x, e);
    bool ok = gen_check(g, et_knots_valid(v, nu, p) == 1 && et_knots_clamped(v, nu, p) == et_knots_clamped(u, nu, p), "valid, clamped");
    ok = ok && gen_check(g, et_knots_interpolating(v, nu, p) == et_knots_interpolating(u, nu, p), "interpolating");
    ok = ok && gen_check(g, et_knots_span(v, nu, p, y) == et_knots_span(u, nu, p, x) && et_knots_multiplicity(v, nu, y) == et_knots_multiplicity(u,
            nu, x), "at %a", x);
    ok = ok && gen_check(g, et_knots_span_side(v, nu, p, y, ET_SIDE_LEFT) == et_knots_span_side(u, nu, p, x, ET_SIDE_LEFT), "from the left at %a", x);
    et_knots_greville(G, n, u, nu, p);
    et_knots_greville(H, n, v, nu, p);
    for (size_t i = 0; ok && i < n; i++) {
        ok = gen_check(g, H[i] == ldexp(G[i], e), "Greville point %zu times 2^%d: %a, not %a", i, e, H[i], ldexp(G[i], e));
    }
    return ok ? PASS : FAIL;
}
