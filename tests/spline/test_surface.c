/* spline/surface: against the sum over all control points with the basis by its definition, and every way to a point against every other. */
#include "surfaces.h"
#include <stdint.h>

enum { POINTS = 1200 };

verdict prop_surface_valid(gen *g)
{
    static const double bad[] = {0.0, -1.0, HUGE_VAL, NAN, -0.0};
    et_surface s, zero = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    size_t n = s.nu * s.nv, at = (size_t)gen_upto(g, n - 1);
    et_surface t = s;
    bool ok = gen_check(g, et_surface_valid(&s) == 1 && et_surface_valid(&zero) == 0, "a surface is not, or a zeroed struct is");
    t.u = NULL;
    ok = ok && gen_check(g, !et_surface_valid(&t), "no u");
    t = s, t.v = NULL;
    ok = ok && gen_check(g, !et_surface_valid(&t), "no v");
    t = s, t.points = NULL;
    ok = ok && gen_check(g, !et_surface_valid(&t), "no points");
    t = s, t.p = s.nu;
    ok = ok && gen_check(g, !et_surface_valid(&t), "p = nu");
    t = s, t.q = SIZE_MAX;
    ok = ok && gen_check(g, !et_surface_valid(&t), "q = SIZE_MAX");
    t = s, t.p = SIZE_MAX;
    ok = ok && gen_check(g, !et_surface_valid(&t), "p = SIZE_MAX");
    t = s, t.nu = SIZE_MAX - s.p;
    ok = ok && gen_check(g, !et_surface_valid(&t), "nu + p + 1 wraps");
    t = s, t.nv = SIZE_MAX - s.q;
    ok = ok && gen_check(g, !et_surface_valid(&t), "nv + q + 1 wraps");
    double *c = at % 3 == 0 ? &s.points[at].x : at % 3 == 1 ? &s.points[at].y : &s.points[at].z, old = *c;
    *c = gen_upto(g, 1) ? NAN : -HUGE_VAL;
    ok = ok && gen_check(g, !et_surface_valid(&s), "control point %zu", at);
    *c = old;
    if (s.weights) {
        s.weights[at] = bad[gen_upto(g, 4)];
        ok = ok && gen_check(g, !et_surface_valid(&s), "weight %zu is %g", at, s.weights[at]);
        s.weights[at] = 1.0;
    }
    old = s.u[s.p];
    s.u[s.p] = NAN;
    ok = ok && gen_check(g, !et_surface_valid(&s), "u knot");
    s.u[s.p] = old;
    old = s.v[s.nv + s.q];
    s.v[s.nv + s.q] = s.v[s.q] - 1.0;
    ok = ok && gen_check(g, !et_surface_valid(&s), "v knot");
    s.v[s.nv + s.q] = old;
    ok = ok && gen_check(g, et_surface_valid(&s), "put back, and not valid");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_surface_new(gen *g)
{
    et_surface s, old;
    size_t p = (size_t)gen_upto(g, 5), q = (size_t)gen_upto(g, 5), nu = (size_t)gen_upto(g, 9), nv = (size_t)gen_upto(g, 9);
    int rational = (int)gen_upto(g, 2);
    memset(&s, 0x3c, sizeof s);
    old = s;
    et_status huge = et_surface_new(&s, p, q, SIZE_MAX / 4, 1 + q, rational), wide = et_surface_new(&s, p, q, SIZE_MAX - p, SIZE_MAX - q, 0);
    bool ok = gen_check(g, huge == ET_ENOMEM && wide == ET_ENOMEM && memcmp(&s, &old, sizeof s) == 0, "SIZE_MAX: %d, %d", (int)huge, (int)wide);
    et_status status = et_surface_new(&s, p, q, nu, nv, rational);
    if (nu <= p || nv <= q) {
        gen_label(g, "too few");
        return ok && gen_check(g, status == ET_EINVAL && memcmp(&s, &old, sizeof s) == 0, "%zu x %zu, degrees %zu, %zu: %d", nu, nv, p, q, (int)status)
                   ? PASS
                   : FAIL;
    }
    if (!gen_check(g, status == ET_OK && s.p == p && s.q == q && s.nu == nu && s.nv == nv && (s.weights != NULL) == (rational != 0), "status %d",
                   (int)status)) {
        return FAIL;
    }
    for (size_t i = 0; i < nu * nv; i++) {
        ok = ok && s.points[i].x == 0.0 && s.points[i].y == 0.0 && s.points[i].z == 0.0 && (!rational || s.weights[i] == 1.0);
    }
    for (size_t i = 0; i <= nu + p; i++) {
        ok = ok && s.u[i] == 0.0;
    }
    for (size_t i = 0; i <= nv + q; i++) {
        ok = ok && s.v[i] == 0.0;
    }
    gen_check(g, ok, "storage is not zero, or weights not 1");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_surface_copy(gen *g)
{
    et_surface s, t, none = {3, 3, 2, 2, NULL, NULL, NULL, NULL};
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    memset(&t, 0x3c, sizeof t);
    et_surface old = t;
    bool ok = gen_check(g, et_surface_copy(&t, &none) == ET_EINVAL && memcmp(&t, &old, sizeof t) == 0, "a copy of nothing");
    if (!gen_check(g, et_surface_copy(&t, &s) == ET_OK, "no copy")) {
        return FAIL;
    }
    size_t n = s.nu * s.nv;
    ok = ok && gen_check(g, t.p == s.p && t.q == s.q && t.nu == s.nu && t.nv == s.nv, "other sizes");
    ok = ok && gen_check(g, t.u != s.u && t.v != s.v && t.points != s.points && (t.weights != s.weights || !s.weights), "shared storage");
    ok = ok && gen_check(g, !memcmp(t.u, s.u, (s.nu + s.p + 1) * sizeof *s.u) && !memcmp(t.v, s.v, (s.nv + s.q + 1) * sizeof *s.v), "other knots");
    ok = ok && gen_check(g, !memcmp(t.points, s.points, n * sizeof *s.points), "other points");
    ok = ok && gen_check(g, !s.weights == !t.weights && (!s.weights || !memcmp(t.weights, s.weights, n * sizeof *s.weights)), "other weights");
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

verdict prop_surface_free(gen *g)
{
    et_surface s, zero = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    et_surface_free(&zero);
    if (!draw_surface(g, &s, false)) {
        return SKIP;
    }
    et_surface_free(&s);
    bool ok = gen_check(g, !s.u && !s.v && !s.points && !s.weights && !s.nu && !s.nv && !s.p && !s.q, "not zeroed");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* The stated workspace suffices: a guard stands behind it. */
verdict prop_surface_work(gen *g)
{
    et_surface s;
    et_vec3 D[6], S[70];
    double a[70], b[70];
    if (!draw_surface(g, &s, false)) {
        return SKIP;
    }
    size_t n = et_surface_work(&s);
    double *work = surface_room(&s);
    bool ok = gen_check(g, n >= 1 && work, "%zu doubles", n);
    for (size_t k = 0; k < 70; k++) {
        a[k] = draw_u(g, &s);
        b[k] = draw_v(g, &s);
    }
    work[n] = 4711.0;
    et_surface_point(&s, a[0], b[0], work, n);
    ok = ok && gen_check(g, work[n] == 4711.0, "point wrote beyond %zu", n);
    et_surface_ders(D, &s, a[0], b[0], work, n);
    ok = ok && gen_check(g, work[n] == 4711.0, "ders wrote beyond %zu", n);
    et_surface_points(S, &s, a, b, 70, work, n);
    ok = ok && gen_check(g, work[n] == 4711.0, "points wrote beyond %zu", n);
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_surface_point(gen *g)
{
    et_surface s;
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    double u = draw_u(g, &s), v = draw_v(g, &s);
    et_vec3 S = surface_at(&s, u, v);
    sums t = surface_brute(&s, u, v, 0, 0);
    bool ok = true;
    for (int a = 0; ok && a < 3; a++) {
        /* Numerator and denominator within slack of theirs; then one rounding each way. */
        double w = s.weights ? t.value[0] : 1.0, want = t.value[a + 1] / w;
        double bound = (s.weights ? 2.0 : 1.0) * (surface_slack(&s) + 2.0 * ET_UNIT) * (t.size[a + 1] / w) + 0x1p-700;
        ok = gen_check(g, fabs(coordinate(&S, a) - want) <= bound, "(%a, %a): coordinate %d is %a, by brute force %a", u, v, a, coordinate(&S, a), want);
    }
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* A corner of a clamped surface is its control point; a parameter outside is one at the end. */
verdict prop_surface_point_corners(gen *g)
{
    et_surface s;
    if (!draw_surface(g, &s, false)) {
        return SKIP;
    }
    bool right = gen_upto(g, 1) == 1, top = gen_upto(g, 1) == 1, ok = true;
    double u = right ? 1.0 : 0.0, v = top ? 1.0 : 0.0;
    size_t k = (right ? s.nu - 1 : 0) * s.nv + (top ? s.nv - 1 : 0);
    et_vec3 S = surface_at(&s, u, v), T = surface_at(&s, right ? 1.5 : -0.5, top ? 7.0 : -1e300);
    for (int a = 0; ok && a < 3; a++) {
        double P = coordinate(&s.points[k], a);
        double want = s.weights ? s.weights[k] * P / s.weights[k] : P;
        ok = gen_check(g, coordinate(&S, a) == want, "corner %zu, coordinate %d: %a for %a", k, a, coordinate(&S, a), want);
    }
    ok = ok && gen_check(g, same_point(S, T), "outside another point");
    /* An edge is the curve of its own control points: the others may be anywhere. */
    v = draw_v(g, &s);
    S = surface_at(&s, u, v);
    for (size_t i = 0; i < s.nu; i++) {
        for (size_t j = 0; j < s.nv && i != (right ? s.nu - 1 : 0); j++) {
            s.points[i * s.nv + j] = (et_vec3){3.0, -5.0, 7.0};
        }
    }
    T = surface_at(&s, u, v);
    ok = ok && gen_check(g, S.x == T.x && S.y == T.y && S.z == T.z, "the edge u = %g depends on inner control points at v = %a", u, v);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Scaling by a power of two and permuting coordinates keep every bit, translation the bound; the point is in the hull's box. */
verdict prop_surface_point_affine(gen *g)
{
    et_surface s;
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    double u = draw_u(g, &s), v = draw_v(g, &s), size = 0.0;
    int e = (int)gen_upto(g, 60);
    et_vec3 shift = {(double)gen_upto(g, 9), -(double)gen_upto(g, 9), 0.5}, S = surface_at(&s, u, v), lo = s.points[0], hi = lo;
    size_t n = s.nu * s.nv;
    for (size_t k = 0; k < n; k++) {
        et_vec3 P = s.points[k];
        lo = (et_vec3){fmin(lo.x, P.x), fmin(lo.y, P.y), fmin(lo.z, P.z)};
        hi = (et_vec3){fmax(hi.x, P.x), fmax(hi.y, P.y), fmax(hi.z, P.z)};
        size = fmax(size, fmax(fabs(P.x), fmax(fabs(P.y), fabs(P.z))));
        s.points[k] = (et_vec3){ldexp(P.y, e), -ldexp(P.z, e), ldexp(P.x, e)};
    }
    /* A convex combination's weights add up within slack of 1, and each term of it is within slack. */
    double bound = 3.0 * (surface_slack(&s) + 2.0 * ET_UNIT) * size + 0x1p-700;
    bool ok = gen_check(g, S.x >= lo.x - bound && S.x <= hi.x + bound && S.y >= lo.y - bound && S.y <= hi.y + bound && S.z >= lo.z - bound &&
                               S.z <= hi.z + bound, "outside the convex hull");
    et_vec3 T = surface_at(&s, u, v), want = {ldexp(S.y, e), -ldexp(S.z, e), ldexp(S.x, e)};
    /* Exactly, but for products that underflow before and not after. */
    ok = ok && gen_check(g, fabs(T.x - want.x) <= 0x1p-900 && fabs(T.y - want.y) <= 0x1p-900 && fabs(T.z - want.z) <= 0x1p-900, "scaled by 2^%d: %a for %a",
                         e, T.x, want.x);
    for (size_t k = 0; k < n; k++) {
        s.points[k] = (et_vec3){ldexp(s.points[k].x, -e) + shift.x, ldexp(s.points[k].y, -e) + shift.y, ldexp(s.points[k].z, -e) + shift.z};
    }
    T = surface_at(&s, u, v);
    bound = 4.0 * (surface_slack(&s) + 2.0 * ET_UNIT) * (size + 9.0) + 0x1p-700;
    ok = ok && gen_check(g, fabs(T.x - (S.y + shift.x)) <= bound && fabs(T.y - (shift.y - S.z)) <= bound && fabs(T.z - (S.x + shift.z)) <= bound,
                         "moved: %a for %a", T.x, S.y + shift.x);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* With every weight equal to a power of two the surface is the polynomial one up to the division by a sum near that power. */
verdict prop_surface_point_weights(gen *g)
{
    et_surface s;
    if (!draw_surface(g, &s, false)) {
        return SKIP;
    }
    double u = draw_u(g, &s), v = draw_v(g, &s), *own = s.weights, w = ldexp(1.0, (int)gen_upto(g, 40) - 20);
    size_t n = s.nu * s.nv;
    s.weights = NULL;
    et_vec3 S = surface_at(&s, u, v);
    s.weights = et_size_array(n, sizeof(double));
    for (size_t k = 0; k < n; k++) {
        s.weights[k] = w;
    }
    et_vec3 T = surface_at(&s, u, v);
    /* The sum of weights: 7(p+q) roundings from w at most; a division. */
    double bound = (7.0 * (double)(s.p + s.q) + 1.0) * ET_UNIT * (1.0 + 0x1p-40);
    bool ok = gen_check(g, fabs(S.x - T.x) <= bound * fabs(S.x) + 0x1p-900 && fabs(S.y - T.y) <= bound * fabs(S.y) + 0x1p-900 &&
                               fabs(S.z - T.z) <= bound * fabs(S.z) + 0x1p-900, "weights %g: %a for %a", w, T.x, S.x);
    free(s.weights);
    s.weights = own;
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_surface_ders(gen *g)
{
    static const size_t du[6] = {0, 1, 0, 2, 1, 0}, dv[6] = {0, 0, 1, 0, 1, 2};
    et_surface s;
    et_vec3 D[6];
    sums A[6];
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    double u = draw_u(g, &s), v = draw_v(g, &s), *work = surface_room(&s);
    et_surface_ders(D, &s, u, v, work, et_surface_work(&s));
    bool ok = gen_check(g, same_point(D[0], surface_at(&s, u, v)), "D[0] is another point");
    for (size_t k = 0; k < 6; k++) {
        A[k] = surface_brute(&s, u, v, du[k], dv[k]);
        if (!s.weights) {                     /* the sum of the basis is 1, of its derivatives 0 */
            A[k].value[0] = k == 0 ? 1.0 : 0.0;
            A[k].size[0] = A[k].value[0];
        }
    }
    /* Leibniz on w S = A: for each k the sum over parts of the derivative, c w^(part) S^(rest). */
    static const int part[6][4][3] = {{{0, 0, 1}, {0, 0, 0}}, {{0, 1, 1}, {1, 0, 1}}, {{0, 2, 1}, {2, 0, 1}}, {{0, 3, 1}, {1, 1, 2}, {3, 0, 1}},
                                      {{0, 4, 1}, {1, 2, 1}, {2, 1, 1}, {4, 0, 1}}, {{0, 5, 1}, {2, 2, 2}, {5, 0, 1}}};
    for (size_t k = 0; k < 6; k++) {
        for (int a = 0; ok && a < 3; a++) {
            double sum = 0.0, size = A[k].size[a + 1];
            for (size_t m = 0; m < 4; m++) {
                const int *t = part[k][m];
                sum += t[2] * A[t[0]].value[0] * coordinate(&D[t[1]], a);
                size += t[2] * A[t[0]].size[0] * fabs(coordinate(&D[t[1]], a));
            }
            ok = gen_check(g, fabs(sum - A[k].value[a + 1]) <= surface_slack(&s) * size + 0x1p-300, "(%a, %a): derivative %zu, coordinate %d: %a for %a", u, v, k, a,
                           sum, A[k].value[a + 1]);
        }
    }
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* All points at once are those one by one.  It frees the surface. */
static verdict points_alike(gen *g, et_surface *s, const double *u, const double *v, size_t n)
{
    static et_vec3 S[POINTS];
    double *work = surface_room(s);
    bool ok = gen_check(g, n <= POINTS && et_surface_valid(s), "not valid");
    if (ok) {
        et_surface_points(S, s, u, v, n, work, et_surface_work(s));
    }
    for (size_t k = 0; ok && k < n; k++) {
        et_vec3 P = et_surface_point(s, u[k], v[k], work, et_surface_work(s));
        ok = gen_check(g, same_point(S[k], P), "point %zu, (%a, %a): (%a, %a, %a) for (%a, %a, %a)", k, u[k], v[k], S[k].x, S[k].y, S[k].z, P.x, P.y, P.z);
    }
    free(work);
    et_surface_free(s);
    return ok ? PASS : FAIL;
}

/* Lengths around blocks and tables; most parameters are made, not drawn, and some drawn ones are hard. */
verdict prop_surface_points(gen *g)
{
    et_surface s;
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    size_t n = gen_chance(g, 8) ? 1023 + (size_t)gen_upto(g, 80) : (size_t)gen_upto(g, 150);
    double *u = malloc(n * sizeof *u + 1), *v = malloc(n * sizeof *v + 1);      /* not a double more: the sanitizer watches the ends */
    et_vec3 *S = malloc((n + 1) * sizeof *S);
    uint64_t seed = gen_upto(g, UINT64_MAX);
    double lou = s.u[s.p], hiu = s.u[s.nu], lov = s.v[s.q], hiv = s.v[s.nv], *work = surface_room(&s);
    for (size_t k = 0; k < n; k++) {
        seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        u[k] = lou + (hiu - lou) * ((double)(seed >> 43) * 0x1p-20 - 0.5);      /* half of them outside */
        v[k] = lov + (hiv - lov) * ((double)((seed >> 20) & 0x1fffff) * 0x1p-20 - 0.5);
    }
    for (size_t k = 0, hard = n < 12 ? n : 12; k < hard; k++) {
        size_t at = (size_t)gen_upto(g, n - 1);
        u[at] = draw_u(g, &s);
        v[at] = draw_v(g, &s);
    }
    S[n] = (et_vec3){1.0, 2.0, 3.0};
    et_surface_points(S, &s, u, v, n, work, et_surface_work(&s));
    bool ok = gen_check(g, S[n].x == 1.0 && S[n].y == 2.0 && S[n].z == 3.0, "wrote beyond %zu points", n);
    for (size_t k = 0; ok && k < n; k++) {
        et_vec3 P = et_surface_point(&s, u[k], v[k], work, et_surface_work(&s));
        ok = gen_check(g, same_point(S[k], P), "point %zu of %zu, (%a, %a): %a for %a", k, n, u[k], v[k], S[k].x, P.x);
    }
    free(work);
    free(u);
    free(v);
    free(S);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* A table of cells meets many knots in one cell: crowded knots, all points near them. */
verdict prop_surface_points_crowded(gen *g)
{
    static double u[POINTS], v[POINTS];
    et_surface s;
    size_t nu = 4 + (size_t)gen_between(g, 4, 24), crowd = (size_t)gen_upto(g, 900);
    double at = 0.25 + 0.5 * gen_real(g, 0.0, 1.0);
    if (et_surface_new(&s, 3, 3, nu, 5, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < nu + 4; i++) {
        s.u[i] = i < 4 ? 0.0 : i >= nu ? 1.0 : at + (double)(i - 4) * 0x1p-16;
    }
    for (size_t i = 0; i < 9; i++) {
        s.v[i] = i < 4 ? -3.0 : i > 4 ? 5.0 : -2.5 + gen_real(g, 0.0, 7.0);
    }
    for (size_t k = 0; k < nu * 5; k++) {
        s.points[k] = (et_vec3){(double)(k % 7), (double)(k % 11) - 4.0, 1.0 / (double)(k + 1)};
    }
    for (size_t k = 0; k < POINTS; k++) {
        u[k] = k < crowd ? at + (double)k * 0x1p-20 : k % 97 == 0 ? s.u[k % (nu + 4)] : (double)k / POINTS;
        v[k] = k % 89 == 0 ? s.v[k % 9] : -3.0 + 8.0 * (double)(k * 77 % POINTS) / POINTS;
    }
    return points_alike(g, &s, u, v, POINTS);
}

/* A domain so narrow that cells to its width overflow: no table, and the same points. */
verdict prop_surface_points_narrow(gen *g)
{
    static double u[POINTS], v[POINTS];
    et_surface s;
    bool across = gen_upto(g, 1) == 1;
    double step = ldexp(1.0, -1022 + (int)gen_upto(g, 12));
    if (et_surface_new(&s, 3, 3, 6, 6, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < 10; i++) {
        double knot = i < 4 ? 0.0 : i < 6 ? (double)(i - 3) : 3.0;
        s.u[i] = knot * (across ? 1.0 : step);
        s.v[i] = knot * (across ? step : 1.0);
    }
    for (size_t k = 0; k < 36; k++) {
        s.points[k] = (et_vec3){(double)(k % 7), (double)(k % 11) - 4.0, 1.0 / (double)(k + 1)};
    }
    for (size_t k = 0; k < POINTS; k++) {
        u[k] = s.u[6] * ((double)(k % 41) / 40.0);
        v[k] = s.v[6] * ((double)(k * 7 % 64) / 64.0);
    }
    return points_alike(g, &s, u, v, POINTS);
}

/* Blocks of nothing but ends, over knots whose distance times its reciprocal is not 1: the control points of the corners all the same. */
verdict prop_surface_points_ends(gen *g)
{
    static double u[POINTS], v[POINTS];
    static et_vec3 S[POINTS];
    et_surface s;
    size_t n = gen_chance(g, 4) ? 600 : 32 * (size_t)gen_between(g, 1, 4), kind = (size_t)gen_upto(g, 3);
    double width = (double)gen_between(g, 49, 200);
    if (et_surface_new(&s, 3, 3, 5, 6, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < 9; i++) {
        s.u[i] = width * (i < 4 ? -1.0 : i < 5 ? 0.0 : 1.0);
    }
    for (size_t j = 0; j < 10; j++) {
        s.v[j] = width * (j < 4 ? 0.0 : j < 6 ? (double)(j - 3) : 3.0);
    }
    for (size_t k = 0; k < 30; k++) {
        s.points[k] = (et_vec3){(double)k, 0.1 * (double)k, -1.0};
    }
    for (size_t k = 0; k < n; k++) {
        u[k] = width * (kind & 1 ? 1.0 : -1.0);
        v[k] = width * (kind & 2 ? 3.0 : 0.0);
    }
    double *work = surface_room(&s);
    et_surface_points(S, &s, u, v, n, work, et_surface_work(&s));
    bool ok = true;
    for (size_t k = 0; ok && k < n; k++) {
        ok = gen_check(g, same_point(S[k], s.points[(kind & 1 ? 24 : 0) + (kind & 2 ? 5 : 0)]), "point %zu of %zu, corner %zu: %a", k, n, kind, S[k].x);
    }
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* The ends of a domain that is not clamped are zeros of either sign, as are parameters: the bits are et_surface_point's, the signs of zeros, too. */
verdict prop_surface_points_zeros(gen *g)
{
    double u[40], v[40];
    et_surface s;
    bool right = gen_upto(g, 1) == 1, across = gen_upto(g, 1) == 1, negative = gen_upto(g, 1) == 1;
    if (et_surface_new(&s, 3, 3, 4, 4, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < 8; i++) {
        s.u[i] = s.v[i] = (double)i - (right ? 4.0 : 3.0);
    }
    *(across ? &s.v[right ? 4 : 3] : &s.u[right ? 4 : 3]) = negative ? -0.0 : 0.0;
    for (size_t k = 0; k < 16; k++) {
        s.points[k] = (et_vec3){-0.0, 0.0, gen_upto(g, 1) ? -0.0 : 0.0};
    }
    for (size_t k = 0; k < 40; k++) {
        double zero = k % 2 ? -0.0 : 0.0, other = (right ? -1.0 : 0.0) + (double)(k % 5) / 5.0;
        u[k] = across ? other : zero;
        v[k] = across ? zero : other;
    }
    return points_alike(g, &s, u, v, 40);
}

/* More knots than the table's numbers count: none then. */
/* One case in 1000. */
verdict prop_surface_points_many(gen *g)
{
    static double u[POINTS], v[POINTS];
    et_surface s;
    size_t n = 600, nu = UINT16_MAX + (size_t)gen_upto(g, 1000);
    if (et_surface_new(&s, 3, 3, nu, 4, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < nu + 4; i++) {
        s.u[i] = i < 4 ? 0.0 : i >= nu ? (double)(nu - 3) : (double)(i - 3);
    }
    for (size_t j = 4; j < 8; j++) {
        s.v[j] = 1.0;
    }
    for (size_t k = 0; k < 4 * nu; k++) {
        s.points[k] = (et_vec3){(double)(k / 4), (double)(k % 4), (double)(k % 7)};
    }
    for (size_t k = 0; k < n; k++) {
        u[k] = (double)(nu - 3) * ((double)k / (double)(n - 1));
        v[k] = (double)(k % 9) / 8.0;
    }
    return points_alike(g, &s, u, v, n);
}

verdict prop_surface_grid(gen *g)
{
    double a[20], b[20];
    et_vec3 S[401];
    et_surface s;
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    size_t na = (size_t)gen_upto(g, 20), nb = (size_t)gen_upto(g, 20);
    double *work = surface_room(&s);
    for (size_t i = 0; i < na; i++) {
        a[i] = gen_chance(g, 10) ? (gen_upto(g, 1) ? -1e9 : 1e9) : draw_u(g, &s);
    }
    for (size_t j = 0; j < nb; j++) {
        b[j] = gen_chance(g, 10) ? (gen_upto(g, 1) ? 1e9 : -1e9) : draw_v(g, &s);
    }
    S[na * nb] = (et_vec3){1.0, 2.0, 3.0};
    bool ok = gen_check(g, et_surface_grid(S, &s, a, na, b, nb) == ET_OK, "no grid");
    ok = ok && gen_check(g, S[na * nb].x == 1.0 && S[na * nb].y == 2.0 && S[na * nb].z == 3.0, "wrote beyond %zu x %zu", na, nb);
    for (size_t k = 0; ok && k < na * nb; k++) {
        et_vec3 P = et_surface_point(&s, a[k / nb], b[k % nb], work, et_surface_work(&s));
        ok = gen_check(g, same_point(S[k], P), "point %zu of %zu x %zu: %a for %a", k, na, nb, S[k].x, P.x);
    }
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

static bool are(const row *r, const et_vec3 *S, size_t n)
{
    bool ok = r->nwant == 3 * n;
    for (size_t k = 0; ok && k < 3 * n; k++) {
        ok = row_is(r, k, coordinate(&S[k / 3], (int)(k % 3)));
    }
    return ok;
}

verdict gold_surface_valid(const row *r)
{
    et_surface s;
    bool ok = read_surface(r, &s) > 0 && row_is_size(r, 0, (size_t)et_surface_valid(&s));
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict gold_surface_point(const row *r)
{
    et_surface s;
    size_t at = read_surface(r, &s);
    et_vec3 S = surface_at(&s, row_real(r, at), row_real(r, at + 1));
    bool ok = at > 0 && are(r, &S, 1);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* After the surface: which of the six, u, v. */
verdict gold_surface_ders(const row *r)
{
    et_surface s;
    et_vec3 D[6];
    size_t at = read_surface(r, &s), k = row_size(r, at);
    double *work = surface_room(&s);
    et_surface_ders(D, &s, row_real(r, at + 1), row_real(r, at + 2), work, et_surface_work(&s));
    bool ok = at > 0 && k < 6 && are(r, &D[k], 1);
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* After the surface: n, then u and v by turns.  Repeated, so that blocks and tables are met. */
verdict gold_surface_points(const row *r)
{
    static double u[POINTS], v[POINTS];
    static et_vec3 S[POINTS];
    et_surface s;
    size_t at = read_surface(r, &s), n = row_size(r, at++);
    double *work = surface_room(&s);
    for (size_t k = 0; k < POINTS; k++) {
        u[k] = row_real(r, at + 2 * (k % n));
        v[k] = row_real(r, at + 2 * (k % n) + 1);
    }
    et_surface_points(S, &s, u, v, POINTS, work, et_surface_work(&s));
    bool ok = are(r, S, n) && are(r, S + POINTS / n / 2 * n, n);
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* After the surface: na, nb, the a, the b. */
verdict gold_surface_grid(const row *r)
{
    double a[16], b[16];
    et_vec3 S[256];
    et_surface s;
    size_t at = read_surface(r, &s), na = row_size(r, at), nb = row_size(r, at + 1);
    at += 2;
    for (size_t i = 0; i < na && i < 16; i++) {
        a[i] = row_real(r, at++);
    }
    for (size_t j = 0; j < nb && j < 16; j++) {
        b[j] = row_real(r, at++);
    }
    bool ok = na <= 16 && nb <= 16 && et_surface_grid(S, &s, a, na, b, nb) == ET_OK && are(r, S, na * nb);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
