/* spline/curve: against the sum over all control points with the basis by its definition, against surfaces of one direction, de Boor's algorithm. */
#include "curves.h"
#include "etalon/spline/knots.h"
#include "etalon/spline/surface.h"
#include <stdint.h>

verdict prop_curve_valid(gen *g)
{
    static const double bad[] = {0.0, -1.0, HUGE_VAL, NAN, -0.0};
    et_curve c, zero = {0, 0, NULL, NULL, NULL};
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    size_t at = (size_t)gen_upto(g, c.n - 1), axis = (size_t)gen_upto(g, 2);
    et_curve t = c;
    bool ok = gen_check(g, et_curve_valid(&c) == 1 && et_curve_valid(&zero) == 0, "a curve is not, or a zeroed struct is");
    t.u = NULL;
    ok = ok && gen_check(g, !et_curve_valid(&t), "no knots");
    t = c, t.points = NULL;
    ok = ok && gen_check(g, !et_curve_valid(&t), "no points");
    t = c, t.p = c.n;
    ok = ok && gen_check(g, !et_curve_valid(&t), "p = n");
    t = c, t.p = SIZE_MAX;
    ok = ok && gen_check(g, !et_curve_valid(&t), "p = SIZE_MAX");
    t = c, t.n = SIZE_MAX - c.p;
    ok = ok && gen_check(g, !et_curve_valid(&t), "n + p + 1 wraps");
    double *x = axis == 0 ? &c.points[at].x : axis == 1 ? &c.points[at].y : &c.points[at].z, old = *x;
    *x = gen_upto(g, 1) ? NAN : -HUGE_VAL;
    ok = ok && gen_check(g, !et_curve_valid(&c), "control point %zu", at);
    *x = old;
    if (c.weights) {
        old = c.weights[at];
        c.weights[at] = bad[gen_upto(g, 4)];
        ok = ok && gen_check(g, !et_curve_valid(&c), "weight %zu is %g", at, c.weights[at]);
        c.weights[at] = old;
    }
    size_t k = (size_t)gen_upto(g, c.n + c.p);
    old = c.u[k];
    c.u[k] = k > 0 && gen_upto(g, 1) ? nextafter(c.u[k - 1], -HUGE_VAL) : NAN;
    ok = ok && gen_check(g, !et_curve_valid(&c), "knot %zu", k);
    c.u[k] = old;
    ok = ok && gen_check(g, et_curve_valid(&c), "put back, and not valid");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict prop_curve_new(gen *g)
{
    et_curve c, old;
    size_t p = (size_t)gen_upto(g, 9), n = (size_t)gen_upto(g, 15);
    int rational = (int)gen_upto(g, 2);
    memset(&c, 0x3c, sizeof c);
    old = c;
    et_status huge = et_curve_new(&c, p, SIZE_MAX / 4, rational), wide = et_curve_new(&c, p, SIZE_MAX - p, rational),
              wrap = et_curve_new(&c, SIZE_MAX - 1, SIZE_MAX, 0);
    bool ok = gen_check(g, huge == ET_ENOMEM && wide == ET_ENOMEM && wrap == ET_ENOMEM && memcmp(&c, &old, sizeof c) == 0, "%d, %d, %d", (int)huge,
                        (int)wide, (int)wrap);
    et_status status = et_curve_new(&c, p, n, rational);
    if (n <= p) {
        gen_label(g, "too few");
        ok = ok && gen_check(g, status == ET_EINVAL && memcmp(&c, &old, sizeof c) == 0, "%zu points, degree %zu: %d", n, p, (int)status);
        return ok ? PASS : FAIL;
    }
    if (!gen_check(g, status == ET_OK && c.p == p && c.n == n && (c.weights != NULL) == (rational != 0), "status %d", (int)status)) {
        return FAIL;
    }
    for (size_t i = 0; i < n; i++) {
        ok = ok && c.points[i].x == 0.0 && c.points[i].y == 0.0 && c.points[i].z == 0.0 && (!rational || c.weights[i] == 1.0);
    }
    for (size_t i = 0; i <= n + p; i++) {
        ok = ok && c.u[i] == 0.0;
    }
    gen_check(g, ok, "storage is not zero, or weights not 1");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict prop_curve_free(gen *g)
{
    et_curve c, zero = {0, 0, NULL, NULL, NULL};
    et_curve_free(&zero);
    if (!draw(g, &c, false)) {
        return SKIP;
    }
    et_curve_free(&c);
    bool ok = gen_check(g, !c.u && !c.points && !c.weights && !c.n && !c.p, "not zeroed");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* The stated workspace suffices: a guard stands behind it, and behind the results. */
verdict prop_curve_work(gen *g)
{
    et_curve c, wide;
    et_vec3 D[ORDER + 2];
    if (!draw(g, &c, false)) {
        return SKIP;
    }
    size_t d = (size_t)gen_upto(g, ORDER), n = et_curve_work(&c, d), p = c.p, top = d < p ? d : p;
    double *work = et_size_array(n + 1, sizeof(double)), x = draw_x(g, &c);
    bool ok = gen_check(g, n == (top + 1) * (p + 1) + (p + 1) * (p + 5) + 2 * (d + 1), "%zu doubles", n);
    work[n] = 4711.0;
    D[d + 1] = (et_vec3){1.0, 2.0, 3.0};
    et_curve_ders(D, d, &c, x, work, n);
    ok = ok && gen_check(g, work[n] == 4711.0 && D[d + 1].x == 1.0 && D[d + 1].y == 2.0 && D[d + 1].z == 3.0, "ders wrote beyond %zu", n);
    work[et_curve_work(&c, 0)] = 4711.0;
    et_curve_point(&c, x, work, et_curve_work(&c, 0));
    ok = ok && gen_check(g, work[et_curve_work(&c, 0)] == 4711.0, "point wrote beyond");
    wide = c;
    wide.p = (size_t)1 << (4 * sizeof(size_t));
    ok = ok && gen_check(g, et_curve_work(&wide, 1) == SIZE_MAX, "a degree beyond all sizes");
    ok = ok && gen_check(g, et_curve_work(&c, SIZE_MAX - d) == SIZE_MAX && et_curve_work(&c, SIZE_MAX / 2) == SIZE_MAX, "an order beyond all sizes");
    size_t half = (size_t)1 << (4 * sizeof(size_t) - 2);
    wide.p = 3 * half;                         /* two squares of 3/4 the root of all sizes */
    ok = ok && gen_check(g, et_curve_work(&wide, wide.p) == SIZE_MAX, "a sum beyond all sizes");
    wide.p = half / 25 * 67;                   /* nine tenths of all sizes, and a fifth of them twice */
    ok = ok && gen_check(g, et_curve_work(&wide, 0) == (wide.p + 1) + (wide.p + 1) * (wide.p + 5) + 2, "degree %zu", wide.p);
    ok = ok && gen_check(g, et_curve_work(&wide, SIZE_MAX / 5) == SIZE_MAX, "a sum beyond all sizes with the order's share");
    free(work);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict prop_curve_point(gen *g)
{
    et_curve c;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    double x = draw_x(g, &c);
    et_vec3 C = point(&c, x);
    sums t = brute(&c, x, 0);
    bool ok = true;
    for (int a = 0; ok && a < 3; a++) {
        /* Numerator and denominator within slack of theirs; then one rounding each way. */
        double w = c.weights ? t.value[0] : 1.0, want = t.value[a + 1] / w;
        double bound = (c.weights ? 2.0 : 1.0) * (slack(&c) + 2.0 * ET_UNIT) * (t.size[a + 1] / w) + 0x1p-700;
        ok = gen_check(g, fabs(coordinate(&C, a) - want) <= bound, "%a: coordinate %d is %a, by brute force %a", x, a, coordinate(&C, a), want);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* The ends of a clamped curve are its end control points; a parameter outside is one at the end; only p + 1 control points matter. */
verdict prop_curve_point_ends(gen *g)
{
    et_curve c;
    if (!draw(g, &c, false)) {
        return SKIP;
    }
    bool right = gen_upto(g, 1) == 1, ok = true;
    size_t k = right ? c.n - 1 : 0;
    et_vec3 C = point(&c, right ? 1.0 : 0.0), T = point(&c, right ? 1.5 : -1e300);
    for (int a = 0; ok && a < 3; a++) {
        double P = coordinate(&c.points[k], a), want = c.weights ? c.weights[k] * P / c.weights[k] : P;
        ok = gen_check(g, coordinate(&C, a) == want, "end %zu, coordinate %d: %a for %a", k, a, coordinate(&C, a), want);
    }
    ok = ok && gen_check(g, same_point(C, T), "outside another point");
    double x = draw_x(g, &c);
    size_t span = et_knots_span(c.u, c.n + c.p + 1, c.p, x);
    C = point(&c, x);
    for (size_t i = 0; i < c.n; i++) {
        c.points[i] = i + c.p < span || i > span ? (et_vec3){1e300, -1e300, NAN} : c.points[i];
    }
    T = point(&c, x);
    ok = ok && gen_check(g, same_point(C, T), "depends on control points out of reach of the span %zu at %a", span, x);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* The curve as a surface of degree 0 across, drawn out along u or along v, has the same bits, derivatives too: sums of one term add nothing. */
verdict prop_curve_point_surface(gen *g)
{
    et_curve c;
    et_vec3 D[6], E[3];
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    double x = draw_x(g, &c), across[2] = {0.0, 1.0};
    bool along_u = gen_upto(g, 1) == 0;
    et_surface s = along_u ? (et_surface){c.p, 0, c.n, 1, c.u, across, c.points, c.weights}
                           : (et_surface){0, c.p, 1, c.n, across, c.u, c.points, c.weights};
    size_t n = et_surface_work(&s), first = along_u ? 1 : 2, second = along_u ? 3 : 5;
    double *work = et_size_array(n, sizeof(double));
    et_vec3 C = point(&c, x), S = et_surface_point(&s, along_u ? x : 0.5, along_u ? 0.5 : x, work, n);
    bool ok = gen_check(g, same_point(C, S), "%a: %a, as a surface %a", x, C.x, S.x);
    et_surface_ders(D, &s, along_u ? x : 0.5, along_u ? 0.5 : x, work, n);
    ders(E, 2, &c, x);
    for (int a = 0; ok && a < 3; a++) {
        ok = gen_check(g, coordinate(&E[1], a) == coordinate(&D[first], a) && coordinate(&E[2], a) == coordinate(&D[second], a),
                       "derivatives at %a: %a and %a, as a surface %a and %a", x, coordinate(&E[1], a), coordinate(&E[2], a),
                       coordinate(&D[first], a), coordinate(&D[second], a));
    }
    free(work);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* De Boor's algorithm: convex combinations of control points, p deep, each three roundings of numbers not above the largest. */
verdict prop_curve_point_deboor(gen *g)
{
    et_curve c;
    double h[DEGREE + 1][4];
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    size_t p = c.p, nu = c.n + p + 1;
    double x = draw_x(g, &c), size[4] = {0.0, 0.0, 0.0, 0.0};
    x = fmin(fmax(x, c.u[p]), c.u[c.n]);
    size_t span = et_knots_span(c.u, nu, p, x);
    for (size_t r = 0; r <= p; r++) {
        double w = c.weights ? c.weights[span - p + r] : 1.0;
        for (int a = 0; a < 4; a++) {
            h[r][a] = a == 3 ? w : w * coordinate(&c.points[span - p + r], a);
            size[a] = fmax(size[a], fabs(h[r][a]));
        }
    }
    for (size_t j = 1; j <= p; j++) {
        for (size_t r = p; r >= j; r--) {
            double lo = c.u[span - p + r], hi = c.u[span + 1 + r - j], t = (x - lo) / (hi - lo), s = (hi - x) / (hi - lo);
            for (int a = 0; a < 4; a++) {
                h[r][a] = s * h[r - 1][a] + t * h[r][a];
            }
        }
    }
    et_vec3 C = point(&c, x);
    bool ok = true;
    for (int a = 0; ok && a < 3; a++) {
        /* Each level: quotients 3 roundings, product and sum 2; and of w: it is at least the least of 16 times less. */
        double w = c.weights ? h[p][3] : 1.0, bound = 2.0 * (slack(&c) + 2.0 * ET_UNIT) * fmax(size[a], fabs(h[p][a] / w) * size[3]) / w + 0x1p-700;
        ok = gen_check(g, fabs(coordinate(&C, a) - h[p][a] / w) <= bound, "%a: coordinate %d is %a, by de Boor %a", x, a, coordinate(&C, a),
                       h[p][a] / w);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict prop_curve_ders(gen *g)
{
    et_curve c;
    et_vec3 D[ORDER + 1];
    sums A[ORDER + 1];
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    double x = draw_x(g, &c);
    size_t d = (size_t)gen_upto(g, ORDER);
    ders(D, d, &c, x);
    bool ok = gen_check(g, same_point(D[0], point(&c, x)), "D[0] is another point");
    for (size_t k = 0; k <= d; k++) {
        A[k] = brute(&c, x, k);
        if (!c.weights) {                     /* the sum of the basis is 1, of its derivatives 0 */
            A[k].value[0] = A[k].size[0] = k == 0 ? 1.0 : 0.0;
        }
    }
    for (size_t k = 0; k <= d; k++) {
        for (int a = 0; ok && a < 3; a++) {
            double sum = 0.0, size = A[k].size[a + 1], binomial = 1.0;
            for (size_t i = 0; i <= k; i++) {
                sum += binomial * A[i].value[0] * coordinate(&D[k - i], a);
                size += binomial * A[i].size[0] * fabs(coordinate(&D[k - i], a));
                binomial = binomial * (double)(k - i) / (double)(i + 1);
            }
            /* Where derivatives overflow (short spans to the power -8) there is nothing to compare. */
            ok = !(size < 0x1p900) || gen_check(g, fabs(sum - A[k].value[a + 1]) <= slack(&c) * size + 0x1p-300,
                                                "%a: derivative %zu, coordinate %d: %a for %a", x, k, a, sum, A[k].value[a + 1]);
        }
        ok = ok && gen_check(g, c.weights || k <= c.p || same_point(D[k], (et_vec3){0.0, 0.0, 0.0}), "derivative %zu of degree %zu", k, c.p);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* More derivatives do not change the first ones, and the workspace's former content is not read. */
verdict prop_curve_ders_prefix(gen *g)
{
    et_curve c;
    et_vec3 D[ORDER + 1], E[ORDER + 1];
    if (!draw(g, &c, false)) {
        return SKIP;
    }
    double x = draw_x(g, &c), *work = et_size_array(et_curve_work(&c, ORDER), sizeof(double));
    size_t d = (size_t)gen_upto(g, ORDER);
    bool ok = true;
    memset(work, 0xff, et_curve_work(&c, ORDER) * sizeof *work);
    et_curve_ders(D, ORDER, &c, x, work, et_curve_work(&c, ORDER));
    ders(E, d, &c, x);
    for (size_t k = 0; ok && k <= d; k++) {
        ok = gen_check(g, same_point(D[k], E[k]) || isnan(D[k].x + D[k].y + D[k].z), "derivative %zu is another one", k);
    }
    free(work);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

static bool is(const row *r, et_vec3 C)
{
    bool x = row_is(r, 0, C.x), y = row_is(r, 1, C.y), z = row_is(r, 2, C.z);
    return x && y && z && r->nwant == 3;
}

verdict gold_curve_valid(const row *r)
{
    et_curve c;
    if (read_curve(r, &c) == 0) {
        return FAIL;
    }
    bool ok = row_is_size(r, 0, (size_t)et_curve_valid(&c));
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict gold_curve_work(const row *r)
{
    et_curve c = {row_size(r, 0), 0, NULL, NULL, NULL};
    return row_is_size(r, 0, et_curve_work(&c, row_size(r, 1))) ? PASS : FAIL;
}

/* After the curve: x. */
verdict gold_curve_point(const row *r)
{
    et_curve c;
    size_t at = read_curve(r, &c);
    if (at == 0 || !et_curve_valid(&c)) {
        return FAIL;
    }
    bool ok = is(r, point(&c, row_real(r, at)));
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* After the curve: k, x; wanted is the k-th derivative. */
verdict gold_curve_ders(const row *r)
{
    et_curve c;
    et_vec3 D[32];
    size_t at = read_curve(r, &c), k = at > 0 ? row_size(r, at) : 0;
    if (at == 0 || k >= 32 || !et_curve_valid(&c)) {
        return FAIL;
    }
    ders(D, k, &c, row_real(r, at + 1));
    bool ok = is(r, D[k]);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}
