/* spline/knots: each promise by a walk over all knots. */
#include "etalon/spline/knots.h"
#include "etalon/spline/basis.h"
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

/* By counting: the ends' values stand p + 1 times each, at the ends. */
verdict prop_knots_interpolating(gen *g)
{
    double u[REF_KNOTS];
    size_t p, nu = draw(g, u, &p);
    if (gen_upto(g, 1) == 1) {
        gen_knots(g, u, nu, p);
    }
    if (nu > 2 * p + 2 && gen_upto(g, 3) == 0) {
        u[p + 1] = u[p];
    }
    if (nu > 2 * p + 2 && gen_upto(g, 3) == 0) {
        u[nu - p - 2] = u[nu - p - 1];
    }
    if (!et_knots_valid(u, nu, p)) {
        return SKIP;
    }
    int want = et_knots_multiplicity(u, nu, u[0]) == p + 1 && et_knots_multiplicity(u, nu, u[nu - 1]) == p + 1;
    return gen_check(g, et_knots_interpolating(u, nu, p) == want, "interpolating: %d", !want) ? PASS : FAIL;
}

/* A curve with one control point that is not 0 is 0 at an end unless that is the end's, and for interpolating knots it is 1 there. */
verdict prop_knots_interpolating_ends(gen *g)
{
    double u[REF_KNOTS], N[REF_KNOTS], work[REF_KNOTS];
    size_t p, nu = draw(g, u, &p);
    gen_knots(g, u, nu, p);
    if (nu > 2 * p + 2 && gen_upto(g, 1) == 1) {
        u[p + 1] = u[p];
    }
    if (!et_knots_valid(u, nu, p)) {
        return SKIP;
    }
    size_t k = et_knots_span(u, nu, p, u[p]);
    et_basis_eval(N, u, nu, p, k, u[p], work, et_basis_work(p, 0));
    bool first = k == p && N[0] == 1.0;
    k = et_knots_span(u, nu, p, u[nu - p - 1]);
    et_basis_eval(N, u, nu, p, k, u[nu - p - 1], work, et_basis_work(p, 0));
    bool last = k == nu - p - 2 && N[p] == 1.0;
    return gen_check(g, et_knots_interpolating(u, nu, p) == (first && last), "ends: %d %d", first, last) ? PASS : FAIL;
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

/* From the right the other's bits; from the left by a walk over the spans that are not empty. */
verdict prop_knots_span_side(gen *g)
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
    size_t right = et_knots_span_side(u, nu, p, x, ET_SIDE_RIGHT), left = et_knots_span_side(u, nu, p, x, ET_SIDE_LEFT), want = nu;
    for (size_t k = p; k + p + 1 < nu; k++) {
        bool first = want == nu;
        want = u[k] < u[k + 1] && (first || u[k] < x) ? k : want;
    }
    bool ok = gen_check(g, right == et_knots_span(u, nu, p, x), "from the right the span %zu", right);
    ok = ok && gen_check(g, left == want, "from the left the span %zu for %zu at %a", left, want, x);
    gen_label(g, left == right ? "one span" : "two spans");
    return ok ? PASS : FAIL;
}

verdict prop_knots_multiplicity(gen *g)
{
    double u[REF_KNOTS];
    size_t p, nu = draw(g, u, &p), want = 0, k = (size_t)gen_upto(g, nu - 1);
    double x = gen_upto(g, 2) ? u[k] : nextafter(u[k], gen_upto(g, 1) ? HUGE_VAL : -HUGE_VAL);
    for (size_t i = nu; i-- > 0;) {
        want += u[i] >= x && u[i] <= x;
    }
    bool ok = gen_check(g, et_knots_multiplicity(u, nu, x) == want, "%a is there %zu times, not %zu", x, want, et_knots_multiplicity(u, nu, x));
    static const double zeros[] = {-1.0, -0.0, 0.0, -0.0, 0.5};
    ok = ok && gen_check(g, et_knots_multiplicity(zeros, 5, 0.0) == 3 && et_knots_multiplicity(zeros, 5, -0.0) == 3 && et_knots_multiplicity(zeros, 0, 0.0) == 0,
                         "zeros of both signs");
    return ok ? PASS : FAIL;
}

/* Against the sum by halves; between its knots; and the curve of these points is the parameter: sum g_i N_i(x) = x. */
verdict prop_knots_greville(gen *g)
{
    double u[REF_KNOTS], G[REF_KNOTS + 1], N[REF_KNOTS], x, identity = 0.0, size = 0.0;
    size_t p, nu = draw(g, u, &p), n = nu - p - 1;
    if (!et_knots_valid(u, nu, p)) {
        return SKIP;
    }
    bool ok = true;
    G[n] = 4711.0;
    et_knots_greville(G, n, u, nu, p);
    for (size_t i = 0; ok && i < n; i++) {
        size_t first = p == 0 ? i : i + 1, count = p == 0 ? 2 : p;
        double want = et_real_sum(u + first, count) / (double)count, most = fmax(fabs(u[first]), fabs(u[first + count - 1]));
        /* The sum's p roundings of p terms, a quotient; ours p + 1 and one. */
        ok = gen_check(g, fabs(G[i] - want) <= (2.0 * (double)count + 4.0) * ET_UNIT * most, "g[%zu] is %a for %a", i, G[i], want);
        ok = ok && gen_check(g, G[i] >= u[first] && G[i] <= u[first + count - 1], "g[%zu] = %a is not between its knots", i, G[i]);
        size = fmax(size, most);
    }
    ok = ok && gen_check(g, G[n] == 4711.0, "wrote beyond %zu points", n);
    x = gen_parameter(g, u, nu, p);
    ref_basis(N, u, nu, p, x);
    for (size_t i = 0; i < n; i++) {
        identity += N[i] * G[i];
    }
    ok = ok && gen_check(g, p == 0 || fabs(identity - x) <= (7.0 * (double)p + 8.0 + (double)n) * ET_UNIT * size * (1.0 + 0x1p-30), "%a becomes %a", x, identity);
    return ok ? PASS : FAIL;
}

/* The greatest knots do not overflow, and of equal ones the mean is what they are. */
verdict prop_knots_greville_scales(gen *g)
{
    double u[REF_KNOTS], G[REF_KNOTS], lo = gen_upto(g, 1) ? -0.5 * DBL_MAX : gen_real(g, 0.0, 1.0), hi = gen_upto(g, 1) ? 0.5 * DBL_MAX : lo + 1.0;
    size_t p = (size_t)gen_upto(g, 20), nu = 2 * p + 2;
    for (size_t i = 0; i < nu; i++) {
        u[i] = i <= p ? lo : hi;
    }
    bool ok = true;
    et_knots_greville(G, p + 1, u, nu, p);
    for (size_t i = 0; ok && p > 0 && i <= p; i++) {
        double t = (double)i / (double)p, want = lo * (1.0 - t) + hi * t, size = fmax(fabs(lo), fabs(hi));
        ok = gen_check(g, fabs(G[i] - want) <= ((double)p + 8.0) * ET_UNIT * size, "g[%zu] of %zu is %a for %a", i, p, G[i], want);
    }
    ok = ok && gen_check(g, p == 0 || (G[0] == lo && G[p] == hi), "the ends are %a and %a", G[0], G[p]);
    ok = ok && gen_check(g, p > 0 || fabs(G[0] - (0.5 * lo + 0.5 * hi)) <= 4.0 * ET_UNIT * fmax(fabs(lo), fabs(hi)), "the middle is %a", G[0]);
    for (size_t i = 0; i < nu && p > 0; i++) {               /* not in general 3 x / 3 */
        u[i] = i == 0 ? lo - 1.0 : i + 1 == nu ? hi : lo;
    }
    et_knots_greville(G, p + 1, u, nu, p);
    ok = ok && gen_check(g, p == 0 || (G[0] == lo && G[p / 2] == lo), "of equal knots %a the mean is %a", lo, G[0]);
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

verdict gold_knots_interpolating(const row *r)
{
    double u[REF_KNOTS];
    size_t nu = knots_of(r, u);
    return row_is_size(r, 0, (size_t)et_knots_interpolating(u, nu, row_size(r, 0))) ? PASS : FAIL;
}

/* degree, the knots, the parameter. */
verdict gold_knots_span(const row *r)
{
    double u[REF_KNOTS];
    size_t nu = knots_of(r, u) - 1;
    return row_is_size(r, 0, et_knots_span(u, nu, row_size(r, 0), u[nu])) ? PASS : FAIL;
}

/* degree, the knots, the parameter, the side (0 right, 1 left). */
verdict gold_knots_span_side(const row *r)
{
    double u[REF_KNOTS];
    size_t nu = knots_of(r, u) - 2;
    et_side side = u[nu + 1] != 0.0 ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
    return row_is_size(r, 0, et_knots_span_side(u, nu, row_size(r, 0), u[nu], side)) ? PASS : FAIL;
}

/* degree (which does not matter), the knots, the parameter. */
verdict gold_knots_multiplicity(const row *r)
{
    double u[REF_KNOTS];
    size_t nu = knots_of(r, u) - 1;
    return row_is_size(r, 0, et_knots_multiplicity(u, nu, u[nu])) ? PASS : FAIL;
}

/* degree, the knots. */
verdict gold_knots_greville(const row *r)
{
    double u[REF_KNOTS], G[REF_KNOTS];
    size_t nu = knots_of(r, u), p = row_size(r, 0), n = nu - p - 1;
    bool ok = nu <= REF_KNOTS && r->nwant == n;
    et_knots_greville(G, ok ? n : 0, u, nu, p);
    for (size_t i = 0; ok && i < n; i++) {
        ok = row_is(r, i, G[i]);
    }
    return ok ? PASS : FAIL;
}
