/* spline/curve: knots removed. */
#include "spline/edits.h"

/* ---- removal ---- */

/* How far the points solved for may be off: known ones by e, of magnitude `size` at most; and the deviation found at the end. */
typedef struct { double off, deviation; } spread;

/* Along one side of the equations: c[k] of the point solved for, 1 - c[k] of the one before. */
static double solved(double off, double share, double e, double size)
{
    return (e + (1.0 - share) * off + roundings(6.0) * (3.0 * (size + off) + e)) / share;
}

static spread removal_errors(const et_curve *c, double x, double e, double size)
{
    size_t p = c->p, s = et_knots_multiplicity(c->u, knots(c), x), r = 0, equations = s <= p ? p + 1 - s : 0;
    while (c->u[r + 1] <= x) {
        r++;
    }
    double left = e, right = e, most = e, a = 0.5;
    for (size_t k = 0; k < equations / 2; k++) {
        size_t i = r - p + k, j = r - s - k;
        left = solved(left, (x - c->u[i]) / (c->u[i + p + 1] - c->u[i]), e, size);
        right = solved(right, (c->u[j + p + 1] - x) / (c->u[j + p + 1] - c->u[j]), e, size);
        most = fmax(most, fmax(left, right));
    }
    if (equations % 2 == 1) {
        size_t i = r - p + equations / 2;
        a = (x - c->u[i]) / (c->u[i + p + 1] - c->u[i]);
        return (spread){most, e + a * right + (1.0 - a) * left + roundings(8.0) * (size + e + left + right)};
    }
    return (spread){most, left + right + roundings(4.0) * (size + left + right)};
}

/* What was inserted is removed again, with a tolerance not more than what roundings can make of it. */
verdict prop_curve_remove(gen *g)
{
    et_curve c, want, t, back = untouched();
    double x;
    size_t times, removed = 77;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    if (!draw_site(g, &c, &x, &times) || times == 0 || x <= c.u[c.p] || x >= c.u[c.n] || et_curve_insert(&t, &c, x, times) != ET_OK) {
        et_curve_free(&c);
        return SKIP;
    }
    bool ok = et_curve_insert(&want, &c, x, times - 1) == ET_OK;
    double size = greatest(&c), e = 2.0 * roundings(5.0 * (double)times + 2.0) * size + speck, least = 1.0, most = 0.0;
    spread s = removal_errors(&t, x, e, size);
    for (size_t i = 0; i < t.n; i++) {
        et_vec3 P = t.points[i];
        least = t.weights ? fmin(least, t.weights[i]) : 1.0;
        most = fmax(most, fabs(P.x) + fabs(P.y) + fabs(P.z));
    }
    /* Four coordinates; and so that with weights |e_A| + (|P| + tolerance) |e_w| is not more than tolerance w. */
    double d = 2.0 * (1.0 + 0x1p-20) * s.deviation, tolerance = !t.weights ? d : d < 0.5 * least ? 2.0 * d * (1.0 + most) / least / (1.0 - d / least) : NAN;
    if (!ok || !isfinite(tolerance) || tolerance > 0x1p900) {
        gen_label(g, "ill-conditioned");
    } else {
        ok = gen_check(g, et_curve_remove(&back, &removed, &t, x, 1, tolerance) == ET_OK && removed == 1, "not removed within %g", tolerance);
        ok = ok && gen_check(g, back.p == c.p && back.n == t.n - 1 && memcmp(back.u, want.u, knots(&want) * sizeof *want.u) == 0, "other knots");
        for (size_t i = 0; ok && i < want.n && !c.weights; i++) {
            for (int a = 0; ok && a < 3; a++) {
                ok = gen_check(g, fabs(coordinate(&back.points[i], a) - coordinate(&want.points[i], a)) <= s.off + e, "control point %zu, coordinate %d: %a for %a",
                               i, a, coordinate(&back.points[i], a), coordinate(&want.points[i], a));
            }
        }
        if (removed == 1) {
            et_curve_free(&back);
        }
    }
    et_curve_free(&c);
    et_curve_free(&t);
    et_curve_free(&want);
    return ok ? PASS : FAIL;
}

/* Whatever is removed moves no point by more than the tolerance, but for roundings; what is not removed leaves a copy. */
verdict prop_curve_remove_tolerance(gen *g)
{
    et_curve c, t;
    size_t removed = 77;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    size_t k = c.p + 1 + (size_t)gen_upto(g, c.n - c.p - 1), times = (size_t)gen_upto(g, c.p + 2);
    double x = c.u[k < c.n ? k : c.n - 1], size = greatest(&c), tolerance = gen_chance(g, 8) ? 0.0 : ldexp(size, (int)gen_upto(g, 12) - 9);
    if (x <= c.u[c.p] || x >= c.u[c.n]) {
        et_curve_free(&c);
        return SKIP;
    }
    if (!gen_check(g, et_curve_remove(&t, &removed, &c, x, times, tolerance) == ET_OK, "status")) {
        return FAIL;
    }
    size_t s = et_knots_multiplicity(c.u, knots(&c), x);
    bool ok = gen_check(g, removed <= times && removed <= s && t.n == c.n - removed && et_curve_valid(&t), "%zu of %zu", removed, s);
    ok = ok && gen_check(g, et_knots_multiplicity(t.u, knots(&t), x) == s - removed, "multiplicity");
    ok = ok && gen_check(g, removed > 0 || same_curve(&t, &c), "not a copy");
    gen_label(g, removed > 0 ? "removed" : "not removed");
    places at = places_of(&t);
    double least = 1.0, top = greatest(&t);
    for (size_t i = 0; c.weights && i < t.n; i++) {
        least = fmin(least, t.weights[i]);
    }
    for (size_t i = 0; ok && removed > 0 && i < at.n; i++) {
        fine e = fine_point(&t, at.x[i], at.side[i]), f = fine_point(&c, at.x[i], at.side[i]);
        double move[3];
        for (int a = 0; a < 3; a++) {
            move[a] = et_dd_sub(et_dd_div(e.value[a], e.value[3]), et_dd_div(f.value[a], f.value[3])).hi;
        }
        /* Each removal's residual, w c and w; seven roundings with those of storing. */
        double rounded = (double)removed * 4.0 * roundings(8.0) * (top + size) * (c.weights ? (1.0 + top) / least : 1.0);
        double moved = sqrt(move[0] * move[0] + move[1] * move[1] + move[2] * move[2]);
        ok = gen_check(g, moved <= tolerance * (1.0 + 0x1p-30) + rounded + speck, "at %a moved by %g, tolerance %g", at.x[i], moved, tolerance);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* With any movement allowed every knot goes, and several at once give the bits of one after the other. */
verdict prop_curve_remove_steps(gen *g)
{
    et_curve c, t, once, next;
    size_t removed = 77, one = 77;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    size_t k = c.p + 1 + (size_t)gen_upto(g, c.n - c.p - 1), times = (size_t)gen_upto(g, c.p + 1);
    double x = c.u[k < c.n ? k : c.n - 1];
    if (c.weights || x <= c.u[c.p] || x >= c.u[c.n]) {
        et_curve_free(&c);
        return SKIP;
    }
    size_t s = et_knots_multiplicity(c.u, knots(&c), x), want = times < s ? times : s;
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, x, times, 1e300) == ET_OK && removed == want, "%zu of %zu removed", removed, s);
    ok = ok && et_curve_copy(&once, &c) == ET_OK;
    for (size_t i = 0; ok && i < want; i++) {
        ok = gen_check(g, et_curve_remove(&next, &one, &once, x, 1, 1e300) == ET_OK && one == 1, "no step %zu", i);
        et_curve_free(&once);
        once = next;
    }
    ok = ok && gen_check(g, same_curve(&t, &once), "other bits than one after the other");
    et_curve_free(&c);
    et_curve_free(&t);
    et_curve_free(&once);
    return ok ? PASS : FAIL;
}

/* Two lines that nearly meet, b and c apart by 1 unit at the middle of a and d, which is 2 more away: the removals' distances add up. */
verdict prop_curve_remove_budget(gen *g)
{
    static const struct { double tolerance; size_t removed; } cases[] = {{0.0, 0}, {0.99, 0}, {1.0, 1}, {2.5, 1}, {2.99, 1}, {3.0, 2}, {1e9, 2}};
    double unit = ldexp(1.0, -(int)gen_upto(g, 20)), weight = ldexp(1.0, (int)gen_upto(g, 40) - 20);
    size_t k = (size_t)gen_upto(g, 6), removed = 77, axis = (size_t)gen_upto(g, 2);
    int rational = (int)gen_upto(g, 1);
    et_curve c, t;
    if (et_curve_new(&c, 1, 4, rational) != ET_OK) {
        return FAIL;
    }
    static const double u[] = {0.0, 0.0, 0.5, 0.5, 1.0, 1.0}, value[] = {0.0, 3.0, 2.0, 0.0};
    memcpy(c.u, u, sizeof u);
    for (size_t i = 0; i < 4; i++) {
        (&c.points[i].x)[axis] = value[i] * unit;
        if (rational) {
            c.weights[i] = weight;
        }
    }
    /* Equal weights do not matter. */
    double tolerance = cases[k].tolerance * unit;
    size_t want = cases[k].removed;
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, 0.5, 2, tolerance) == ET_OK && removed == want, "%g: %zu removed for %zu", tolerance, removed, want);
    ok = ok && gen_check(g, same_point(t.points[0], c.points[0]) && same_point(t.points[t.n - 1], c.points[3]), "other ends");
    ok = ok && gen_check(g, removed != 1 || same_point(t.points[1], c.points[2]), "one point of two is left");
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Degree 1: what it takes to remove the middle point is known by hand: |e_A| + (max |P| + T) |e_w| <= T min w.  At any scale. */
verdict prop_curve_remove_threshold(gen *g)
{
    static const double u[] = {0.0, 0.0, 0.5, 1.0, 1.0};
    int rational = (int)gen_upto(g, 1), e = (int)gen_upto(g, 600) - 300, f = (int)gen_upto(g, 1200) - 600;
    et_curve c, t;
    et_vec3 A = {0.0, 0.0, 0.0};
    double w = 0.0, most = 0.0, least = HUGE_VAL;
    if (et_curve_new(&c, 1, 3, rational) != ET_OK) {
        return FAIL;
    }
    memcpy(c.u, u, sizeof u);
    for (size_t i = 0; i < 3; i++) {
        et_vec3 P = {(double)gen_upto(g, 16) - 8.0, (double)gen_upto(g, 16) - 8.0, (double)gen_upto(g, 16) - 8.0};
        double weight = rational ? (double)gen_between(g, 8, 16) / 8.0 : 1.0, share = (i == 1 ? 1.0 : -0.5) * weight;
        A = (et_vec3){A.x + share * P.x, A.y + share * P.y, A.z + share * P.z};
        w += share;
        most = fmax(most, sqrt(P.x * P.x + P.y * P.y + P.z * P.z));
        least = fmin(least, weight);
        c.points[i] = (et_vec3){ldexp(P.x, e), ldexp(P.y, e), ldexp(P.z, e)};
        if (rational) {
            c.weights[i] = ldexp(weight, f);
        }
    }
    double need = ldexp((sqrt(A.x * A.x + A.y * A.y + A.z * A.z) + most * fabs(w)) / (least - fabs(w)), e);
    size_t less = 77, more = 77;
    if (least <= fabs(w)) {                   /* a weight might vanish: no tolerance is enough */
        bool kept = gen_check(g, et_curve_remove(&t, &more, &c, 0.5, 1, ldexp(1.0, e + 20)) == ET_OK && (more == 0 || most == 0.0), "removed");
        et_curve_free(&c);
        et_curve_free(&t);
        return kept ? PASS : FAIL;
    }
    /* A few roundings of the need. */
    bool ok = gen_check(g, et_curve_remove(&t, &less, &c, 0.5, 1, need * (1.0 - 0x1p-45)) == ET_OK && (less == 0 || need == 0.0), "removed below %g", need);
    et_curve_free(&t);
    t = (et_curve){0, 0, NULL, NULL, NULL};
    ok = ok && gen_check(g, et_curve_remove(&t, &more, &c, 0.5, 2, need * (1.0 + 0x1p-45)) == ET_OK && more == 1, "not removed above %g", need);
    ok = ok && gen_check(g, t.n == 2 && same_point(t.points[0], c.points[0]) && same_point(t.points[1], c.points[2]), "other ends");
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Spans from 2^-1000 to 2^900: no quotient that counts overflows, and what is constant stays so. */
verdict prop_curve_elevate_scales(gen *g)
{
    size_t p = (size_t)gen_upto(g, 4), inner = (size_t)gen_upto(g, 5), n = p + 1 + inner;
    int e = -1000, rational = (int)gen_upto(g, 1);
    et_curve c, t;
    if (et_curve_new(&c, p, n, rational) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < n; i++) {
        if (i > p) {
            c.u[i] = ldexp(1.0, e);
            e += gen_upto(g, 2) ? (int)gen_upto(g, 300) : 0;
        }
        c.points[i] = (et_vec3){1e300, (double)i * 1e-300, -1.0};
        if (rational) {
            c.weights[i] = i + 1 == n ? 0x1p1000 : 0x1p980;
        }
    }
    for (size_t i = n; i <= n + p; i++) {
        c.u[i] = 0x1p900;
    }
    bool ok = gen_check(g, et_curve_elevate(&t, &c, 1) == ET_OK, "not elevated");
    double off = roundings(2.0 * (7.0 * (double)p + 2.0) + 4.0);
    for (size_t i = 0; ok && i < t.n; i++) {
        et_vec3 P = t.points[i];
        ok = gen_check(g, fabs(P.x - 1e300) <= off * 1e300 && fabs(P.z + 1.0) <= off && P.y >= 0.0 && P.y <= (double)n * 1e-300, "control point %zu: %a", i, P.x);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* More than p + 1 equal knots: control points that do not matter go first, without a move. */
verdict prop_curve_remove_beyond(gen *g)
{
    size_t p = (size_t)gen_upto(g, DEGREE), more = (size_t)gen_upto(g, 3), n = 2 * p + 2 + more, removed = 77;
    int rational = (int)gen_upto(g, 1);
    et_curve c, t;
    if (et_curve_new(&c, p, n, rational) != ET_OK) {
        return FAIL;
    }
    gen_points(g, &c.points[0].x, n);
    for (size_t i = 0; i < n + p + 1; i++) {
        c.u[i] = i <= p ? 0.0 : i < n ? 0.375 : 1.0;
    }
    for (size_t i = 0; rational && i < n; i++) {
        c.weights[i] = gen_real(g, 0.25, 4.0);
    }
    c.points[p] = (et_vec3){1.0, 2.0, 3.0};
    c.points[n - p - 1] = (et_vec3){1.0, 2.0, 5.0};
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, 0.375, SIZE_MAX, 0.0) == ET_OK && removed == more, "%zu of %zu", removed, more);
    for (size_t i = 0; ok && i < t.n; i++) {
        size_t j = i <= p ? i : i + more;
        ok = gen_check(g, same_point(t.points[i], c.points[j]) && (!rational || t.weights[i] == c.weights[j]), "control point %zu", i);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

verdict prop_curve_remove_refused(gen *g)
{
    et_curve c, t = untouched();
    size_t removed = 77;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    double x = c.n > c.p + 1 ? c.u[c.p + 1] : c.u[c.p], lo = c.u[c.p], hi = c.u[c.n], between = NAN;
    for (size_t i = c.p; i < c.n; i++) {
        double mid = c.u[i] + 0.5 * (c.u[i + 1] - c.u[i]);
        between = mid > c.u[i] && mid < c.u[i + 1] ? mid : between;
    }
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, lo, 1, 1.0) == ET_EINVAL && et_curve_remove(&t, &removed, &c, hi, 1, 1.0) == ET_EINVAL &&
                               et_curve_remove(&t, &removed, &c, NAN, 1, 1.0) == ET_EINVAL, "the domain's ends");
    ok = ok && gen_check(g, et_curve_remove(&t, &removed, &c, between, 1, 1.0) == ET_EINVAL, "%a is no knot", between);
    ok = ok && gen_check(g, et_curve_remove(&t, &removed, &c, x, 1, -1.0) == ET_EINVAL && et_curve_remove(&t, &removed, &c, x, 1, NAN) == ET_EINVAL &&
                                et_curve_remove(&t, &removed, &c, x, 1, HUGE_VAL) == ET_EINVAL, "tolerances");
    c.points[0].z = HUGE_VAL;
    ok = ok && gen_check(g, et_curve_remove(&t, &removed, &c, x, 1, 1.0) == ET_EINVAL, "a coordinate infinite");
    ok = ok && gen_check(g, is_untouched(&t) && removed == 77, "outputs were changed");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* The weights 2 w_1 - w_0 = 2 w_2 - w_3 of the point left would be 0 or less: not removed, whatever the tolerance; else it is. */
verdict prop_curve_remove_weights(gen *g)
{
    static const double u[] = {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0};
    size_t removed = 77;
    double great = (double)gen_between(g, 1, 64) / 16.0;
    et_curve c, t;
    if (et_curve_new(&c, 2, 4, 1) != ET_OK) {
        return FAIL;
    }
    memcpy(c.u, u, sizeof u);
    for (size_t i = 0; i < 4; i++) {
        c.points[i] = (et_vec3){1.0, 2.0, -1.0};
        c.weights[i] = i == 1 || i == 2 ? 1.0 : great;
    }
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, 0.5, 1, 1e18) == ET_OK && removed == (great < 2.0), "%g: %zu removed", great, removed);
    ok = ok && gen_check(g, removed == 0 || (t.weights[1] == 2.0 - great && t.points[1].y == 2.0), "weight %g", t.weights[1]);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* All control points 0: a polynomial curve is not moved, by nothing at all, though shares of weights are rounded. */
verdict prop_curve_remove_zeros(gen *g)
{
    size_t p = 1 + (size_t)gen_upto(g, 3), removed = 77;
    et_curve c, t;
    if (et_curve_new(&c, p, p + 4, 0) != ET_OK) {
        return FAIL;
    }
    double x = 0.0;
    for (size_t i = 0; i < 2 * p + 5; i++) {
        x += i > p && i <= p + 4 ? gen_real(g, 0.1, 1.0) : 0.0;
        c.u[i] = x;
    }
    x = c.u[p + 1 + (size_t)gen_upto(g, 2)];
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, x, 1, 0.0) == ET_OK && removed == 1, "%zu removed", removed);
    for (size_t i = 0; ok && i < t.n; i++) {
        ok = gen_check(g, t.points[i].x == 0.0 && t.points[i].y == 0.0 && t.points[i].z == 0.0, "control point %zu", i);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Both ways to the point left agree, its weight 2 w_1 - w_0 is positive, and the point is infinite: nothing is returned. */
verdict prop_curve_remove_overflow(gen *g)
{
    static const double u[] = {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0};
    size_t removed = 77;
    double weight = ldexp(1.0, -(int)gen_between(g, 40, 52)), far = gen_upto(g, 1) ? 0x1p1000 : -0x1p1000;
    bool infinite = gen_upto(g, 1) == 1;
    et_curve c, t = untouched();
    if (et_curve_new(&c, 2, 4, 1) != ET_OK) {
        return FAIL;
    }
    memcpy(c.u, u, sizeof u);
    for (size_t i = 0; i < 4; i++) {
        bool end = i == 0 || i == 3;
        c.points[i] = (et_vec3){1.0, (end ? -1.0 : 1.0) * (infinite ? far : 1.0), 0.0};
        c.weights[i] = end ? 2.0 - weight : 1.0;
    }
    et_status status = et_curve_remove(&t, &removed, &c, 0.5, 1, 0x1p900);
    bool ok = infinite ? gen_check(g, status == ET_EINVAL && removed == 77 && is_untouched(&t), "status %d, %zu removed", (int)status, removed)
                       : gen_check(g, status == ET_OK && removed == 1 && t.weights[1] == weight && t.points[1].y == (4.0 - weight) / weight, "%a", t.points[1].y);
    et_curve_free(&c);
    if (status == ET_OK) {
        et_curve_free(&t);
    }
    return ok ? PASS : FAIL;
}
