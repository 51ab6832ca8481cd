/* spline/curve: copies, one-sided derivatives, knots inserted. */
#include "spline/edits.h"

/* ---- what the edits have in common ---- */

/* The knots with x so often more, in order. */
static void merge(double *v, const et_curve *c, double x, size_t times)
{
    size_t k = 0;
    for (size_t i = 0; i < knots(c); i++) {
        v[k++] = c->u[i];
        for (size_t t = 0; t < times && c->u[i] <= x && (i + 1 == knots(c) || c->u[i + 1] > x); t++) {
            v[k++] = x;
        }
    }
}

/* ---- copies, sides ---- */

verdict prop_curve_copy(gen *g)
{
    et_curve c, t = untouched(), none = {3, 3, NULL, NULL, NULL};
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    bool ok = gen_check(g, et_curve_copy(&t, &none) == ET_EINVAL && is_untouched(&t), "a copy of nothing");
    if (!gen_check(g, et_curve_copy(&t, &c) == ET_OK, "no copy")) {
        return FAIL;
    }
    ok = ok && gen_check(g, same_curve(&t, &c), "another curve");
    ok = ok && gen_check(g, t.u != c.u && t.points != c.points && (t.weights != c.weights || !c.weights), "shared storage");
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* The curve run backwards: its right is the other's left. */
static bool backwards(et_curve *back, const et_curve *c)
{
    if (et_curve_copy(back, c) != ET_OK) {
        return false;
    }
    for (size_t i = 0; i < knots(c); i++) {
        back->u[i] = -c->u[knots(c) - 1 - i];
    }
    for (size_t i = 0; i < c->n; i++) {
        back->points[i] = c->points[c->n - 1 - i];
        if (c->weights) {
            back->weights[i] = c->weights[c->n - 1 - i];
        }
    }
    return true;
}

verdict prop_curve_ders_side(gen *g)
{
    et_curve c, back;
    et_vec3 D[ORDER + 2], E[ORDER + 1];
    if (!draw(g, &c, true) || !backwards(&back, &c)) {
        return SKIP;
    }
    double x = draw_x(g, &c);
    if (gen_chance(g, 8)) {
        x = gen_upto(g, 1) ? c.u[c.n] + 1.0 : c.u[c.p] - 1.0;
        gen_label(g, "outside");
    }
    size_t d = (size_t)gen_upto(g, ORDER), n = et_curve_work(&c, d);
    double *work = et_size_array(n + 1, sizeof(double)), sign = 1.0, inside = fmin(fmax(x, c.u[c.p]), c.u[c.n]);
    work[n] = D[d + 1].x = 4711.0;
    et_curve_ders(E, d, &c, x, work, n);
    et_curve_ders_side(D, d, &c, x, ET_SIDE_RIGHT, work, n);
    bool ok = gen_check(g, memcmp(D, E, (d + 1) * sizeof *D) == 0 || isnan(D[d].x + D[d].y + D[d].z), "from the right other bits");
    et_curve_ders_side(D, d, &c, x, ET_SIDE_LEFT, work, n);
    ok = ok && gen_check(g, work[n] == 4711.0 && D[d + 1].x == 4711.0, "wrote beyond");
    sums A[ORDER + 1];
    for (size_t k = 0; k <= d; k++, sign = -sign) {
        A[k] = brute(&back, -inside, k);
        for (int a = 0; a < 4; a++) {
            A[k].value[a] *= sign;
        }
        if (!c.weights) {
            A[k].value[0] = A[k].size[0] = k == 0 ? 1.0 : 0.0;
        }
    }
    for (size_t k = 0; k <= d; k++) {                        /* Leibniz' rule, as from the right */
        for (int a = 0; ok && a < 3; a++) {
            double sum = 0.0, size = A[k].size[a + 1], binomial = 1.0;
            for (size_t i = 0; i <= k; i++) {
                sum += binomial * A[i].value[0] * coordinate(&D[k - i], a);
                size += binomial * A[i].size[0] * fabs(coordinate(&D[k - i], a));
                binomial = binomial * (double)(k - i) / (double)(i + 1);
            }
            ok = !(size < 0x1p900) || gen_check(g, fabs(sum - A[k].value[a + 1]) <= slack(&c) * size + 0x1p-300,
                                                "%a from the left: derivative %zu, coordinate %d: %a for %a", x, k, a, sum, A[k].value[a + 1]);
        }
        ok = ok && gen_check(g, c.weights || k <= c.p || same_point(D[k], (et_vec3){0.0, 0.0, 0.0}), "derivative %zu of degree %zu", k, c.p);
    }
    free(work);
    et_curve_free(&c);
    et_curve_free(&back);
    return ok ? PASS : FAIL;
}

/* ---- insertion ---- */

verdict prop_curve_insert(gen *g)
{
    et_curve c, t = untouched();
    double x, v[REF_KNOTS];
    size_t times;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    if (!draw_site(g, &c, &x, &times)) {
        et_curve_free(&c);
        return SKIP;
    }
    merge(v, &c, x, times);
    et_status status = et_curve_insert(&t, &c, x, times);
    if (!et_knots_valid(v, knots(&c) + times, c.p)) {
        gen_label(g, "too near");
        bool kept = gen_check(g, status == ET_EINVAL && is_untouched(&t), "knots too near each other: %d", (int)status);
        et_curve_free(&c);
        return kept ? PASS : FAIL;
    }
    if (!gen_check(g, status == ET_OK, "status %d", (int)status)) {
        return FAIL;
    }
    bool ok = gen_check(g, t.p == c.p && t.n == c.n + times && !t.weights == !c.weights && et_curve_valid(&t), "%zu points", t.n);
    ok = ok && gen_check(g, memcmp(t.u, v, knots(&t) * sizeof *v) == 0, "other knots");
    ok = ok && agree(g, &t, &c, 5.0 * (double)(times < c.p ? times : c.p));
    /* Out of reach of x, every bit. */
    size_t s = et_knots_multiplicity(c.u, knots(&c), x), below = 0;
    while (below < knots(&c) && c.u[below] <= x) {
        below++;
    }
    for (size_t i = 0; ok && i < c.n; i++) {
        size_t j = i + c.p < below ? i : i + times;
        bool kept = i + c.p < below || i + s + 1 > below;
        ok = !kept || gen_check(g, same_point(t.points[j], c.points[i]) && (!c.weights || ref_same(t.weights[j], c.weights[i])), "control point %zu", i);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Several times at once are the bits of one after the other, up to multiplicity p + 1, where the curve falls apart; so are weights of any one power of two. */
verdict prop_curve_insert_steps(gen *g)
{
    et_curve c, t, once, next;
    double x;
    size_t times;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    if (!draw_site(g, &c, &x, &times) || et_curve_insert(&t, &c, x, times) != ET_OK) {
        et_curve_free(&c);
        return SKIP;
    }
    bool ok = et_curve_copy(&once, &c) == ET_OK;
    fine C = fine_point(&c, x, ET_SIDE_LEFT);
    double w = c.weights ? C.value[3].hi : 1.0;
    for (size_t k = 0; ok && k < times && !c.weights; k++) {
        ok = gen_check(g, et_curve_insert(&next, &once, x, 1) == ET_OK, "no step %zu", k);
        et_curve_free(&once);
        once = next;
    }
    ok = ok && gen_check(g, c.weights || same_curve(&t, &once), "other bits than one after the other");
    et_curve_free(&once);
    if (ok && c.weights) {
        static const int powers[] = {0, 1, 40, 1000, -1000};
        int e = powers[gen_upto(g, 4)];
        for (size_t i = 0; i < c.n; i++) {
            c.weights[i] = ldexp(c.weights[i], e);
        }
        ok = gen_check(g, et_curve_insert(&next, &c, x, times) == ET_OK, "weights of 2^%d", e);
        for (size_t i = 0; ok && i < t.n; i++) {
            ok = gen_check(g, same_point(next.points[i], t.points[i]) && next.weights[i] == ldexp(t.weights[i], e), "weights of 2^%d: point %zu", e, i);
        }
        et_curve_free(&next);
    }
    size_t s = et_knots_multiplicity(t.u, knots(&t), x), k = 0;
    while (s == t.p + 1 && t.u[k] < x) {
        k++;
    }
    /* Both parts end where they meet. */
    if (ok && times > 0 && s == t.p + 1 && x > c.u[c.p] && x < c.u[c.n]) {
        for (int a = 0; ok && a < 3; a++) {
            double bound = 2.0 * roundings(5.0 * (double)c.p + 3.0) * C.size[a] / w + speck;
            ok = gen_check(g, fabs(coordinate(&t.points[k - 1], a) - C.value[a].hi / w) <= bound, "the end before %a", x);
        }
        ok = ok && gen_check(g, times > 1 || same_point(t.points[k - 1], t.points[k]), "two ends at %a", x);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* What is refused leaves the output alone. */
verdict prop_curve_insert_refused(gen *g)
{
    et_curve c, t = untouched();
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    double x = c.u[c.p] + 0.5 * (c.u[c.n] - c.u[c.p]), lo = c.u[c.p], hi = c.u[c.n], *u = c.u, *weights = c.weights;
    size_t s = et_knots_multiplicity(c.u, knots(&c), x), most = s > c.p ? 0 : c.p + 1 - s;
    bool ok = gen_check(g, et_curve_insert(&t, &c, x, most + 1) == ET_EINVAL && et_curve_insert(&t, &c, x, SIZE_MAX) == ET_EINVAL &&
                               et_curve_insert(&t, &c, x, SIZE_MAX - s) == ET_EINVAL, "%zu times there, %zu more", s, most + 1);
    ok = ok && gen_check(g, et_curve_insert(&t, &c, NAN, 1) == ET_EINVAL && et_curve_insert(&t, &c, HUGE_VAL, 1) == ET_EINVAL &&
                                et_curve_insert(&t, &c, nextafter(lo, -HUGE_VAL), 1) == ET_EINVAL &&
                                et_curve_insert(&t, &c, nextafter(hi, HUGE_VAL), 0) == ET_EINVAL, "outside the domain");
    c.u = NULL;
    ok = ok && gen_check(g, et_curve_insert(&t, &c, x, 0) == ET_EINVAL, "no curve");
    c.u = u;
    c.points[0].y = NAN;
    ok = ok && gen_check(g, et_curve_insert(&t, &c, x, 0) == ET_EINVAL, "a coordinate NaN");
    c.points[0].y = 0.0;
    c.weights = weights;
    ok = ok && gen_check(g, is_untouched(&t), "the output was changed");
    if (ok && most > 0) {
        ok = gen_check(g, et_curve_insert(&t, &c, x, most) == ET_OK, "%zu times there, %zu more", s, most);
        et_curve_free(ok ? &t : &c);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* The greatest coordinates, weights of all sizes: nothing overflows on the way; a weight that vanishes is refused. */
verdict prop_curve_insert_scales(gen *g)
{
    et_curve c, t = untouched();
    size_t p = 1 + (size_t)gen_upto(g, 4);
    if (et_curve_new(&c, p, p + 1, 1) != ET_OK) {
        return FAIL;
    }
    double most = gen_upto(g, 1) ? 1e307 : 1e-300, x = gen_real(g, 0.0625, 0.9375), unit = gen_upto(g, 1) ? 0x1p1020 : 0x1p-1060;
    size_t heavy = (size_t)gen_upto(g, p);
    for (size_t i = 0; i <= p; i++) {
        c.u[p + 1 + i] = 1.0;
        c.points[i] = (et_vec3){most, (double)i * most, -most};
        c.weights[i] = unit;
    }
    bool ok = gen_check(g, et_curve_insert(&t, &c, x, 1) == ET_OK, "not inserted");
    for (size_t i = 0; ok && i <= p + 1; i++) {
        /* Coordinates that do not change: seven roundings and the division's denominator's. */
        ok = gen_check(g, fabs(t.points[i].x - most) <= roundings(13.0) * most && fabs(t.weights[i] - unit) <= roundings(5.0) * unit + 0x1p-1074,
                       "point %zu: %a of weight %a", i, t.points[i].x, t.weights[i]);
    }
    if (ok) {
        et_curve_free(&t);
        c.weights[heavy] = unit > 1.0 ? 0x1p1023 : 0x1p-1040;      /* one that would overflow for itself */
        ok = gen_check(g, et_curve_insert(&t, &c, x, 1) == ET_OK, "weight %zu the greatest", heavy);
    }
    for (size_t i = 0; ok && i <= p + 1; i++) {
        ok = gen_check(g, fabs(t.points[i].x - most) <= roundings(13.0) * most, "point %zu: %a", i, t.points[i].x);
    }
    if (ok) {
        et_curve_free(&t);
    }
    t = untouched();
    if (ok && p == 1) {                       /* the combination of two least weights is one of them, or nothing */
        c.weights[1] = DBL_MAX;
        c.weights[0] = 1.0;
        ok = gen_check(g, et_curve_insert(&t, &c, 0.5, 1) == ET_OK && t.weights[1] == 0.5 * DBL_MAX, "weights 1 and the greatest");
        et_curve_free(&t);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}
