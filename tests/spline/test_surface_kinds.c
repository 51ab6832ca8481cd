/* spline/surface: in other units: points, weights and knots times powers of two, in every way to points and derivatives; and v for u. */
#include "etalon/spline/surface.h"
#include "surfaces.h"

enum { TOP = 3, ALL = (TOP + 1) * (TOP + 2) / 2, MANY = 80 };

static et_surface in_units(const et_surface *s, int e, int w, int f, int h)
{
    et_surface t;

    if (et_surface_copy(&t, s) != ET_OK) {
        abort();
    }
    for (size_t k = 0; k < s->nu * s->nv; k++) {
        et_vec3 P = s->points[k];
        t.points[k] = (et_vec3){ldexp(P.y, e), -ldexp(P.z, e), ldexp(P.x, e)};
        if (s->weights) {
            t.weights[k] = ldexp(s->weights[k], w);
        }
    }
    for (size_t i = 0; i <= s->nu + s->p; i++) {
        t.u[i] = ldexp(s->u[i], f);
    }
    for (size_t j = 0; j <= s->nv + s->q; j++) {
        t.v[j] = ldexp(s->v[j], h);
    }
    return t;
}

/* Every bit, but for what underflows before and not after. */
static bool is_scaled(gen *g, et_vec3 T, et_vec3 S, int power, const char *what)
{
    et_vec3 want = {ldexp(S.y, power), -ldexp(S.z, power), ldexp(S.x, power)};
    bool same = fabs(T.x - want.x) <= 0x1p-600 && fabs(T.y - want.y) <= 0x1p-600 && fabs(T.z - want.z) <= 0x1p-600;

    return gen_check(g, same || !isfinite(S.x + S.y + S.z), "%s: (%a, %a, %a), not (%a, %a, %a)", what, T.x, T.y, T.z, want.x, want.y, want.z);
}

verdict prop_surface_ders_scaled(gen *g)
{
    et_surface s;
    et_vec3 D[ALL], E[ALL], A[MANY], B[MANY];
    double a[MANY], b[MANY], c[MANY], d[MANY];
    int e = (int)gen_upto(g, 40), w = (int)gen_upto(g, 40), f = (int)gen_upto(g, 20), h = (int)gen_upto(g, 20);

    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    et_surface t = in_units(&s, e, w, f, h);
    double u = draw_u(g, &s), v = draw_v(g, &s), *room = surface_room(&s);
    size_t n = et_surface_partials_work(&s, TOP), nroom = et_surface_work(&s), many = (size_t)gen_upto(g, MANY);
    double *work = et_size_array(n, sizeof(double));
    et_side left_u = gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT, left_v = gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
    bool ok = gen_check(g, et_surface_valid(&t) && et_surface_work(&t) == nroom && et_surface_partials_work(&t, TOP) == n, "not valid, or more room");
    et_surface_partials(D, TOP, &s, u, v, left_u, left_v, work, n);
    et_surface_partials(E, TOP, &t, ldexp(u, f), ldexp(v, h), left_u, left_v, work, n);
    for (int order = 0, k = 0; order <= TOP; order++) {
        for (int l = 0; ok && l <= order; l++, k++) {
            ok = is_scaled(g, E[k], D[k], e - f * (order - l) - h * l, "derivative");
        }
    }
    et_surface_ders(D, &s, u, v, room, nroom);
    et_surface_ders(E, &t, ldexp(u, f), ldexp(v, h), room, nroom);
    static const int du[6] = {0, 1, 0, 2, 1, 0}, dv[6] = {0, 0, 1, 0, 1, 2};
    for (size_t k = 0; ok && k < 6; k++) {
        ok = is_scaled(g, E[k], D[k], e - f * du[k] - h * dv[k], "one of the six");
    }
    for (size_t k = 0; k < many; k++) {
        a[k] = s.u[s.p] + (s.u[s.nu] - s.u[s.p]) * ((double)(k * 7 % MANY) / MANY);
        b[k] = s.v[s.q] + (s.v[s.nv] - s.v[s.q]) * ((double)(k * 11 % MANY) / MANY);
        c[k] = ldexp(a[k], f);
        d[k] = ldexp(b[k], h);
    }
    et_surface_points(A, &s, a, b, many, room, nroom);
    et_surface_points(B, &t, c, d, many, room, nroom);
    for (size_t k = 0; ok && k < many; k++) {
        ok = is_scaled(g, B[k], A[k], e, "point of many");
    }
    size_t rows = many < 8 ? many : 8;
    ok = ok && gen_check(g, et_surface_grid(A, &s, a, rows, b, rows) == ET_OK && et_surface_grid(B, &t, c, rows, d, rows) == ET_OK, "no grid");
    for (size_t k = 0; ok && k < rows * rows; k++) {
        ok = is_scaled(g, B[k], A[k], e, "point of a grid");
    }
    ok = ok && is_scaled(g, surface_at(&t, ldexp(u, f), ldexp(v, h)), surface_at(&s, u, v), e, "point");
    free(work);
    free(room);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

/* u and v exchanged: an edit along one direction is the other's along the other, bit for bit; so is the room that is needed. */
static et_surface exchanged(const et_surface *s)
{
    et_surface t;

    if (et_surface_new(&t, s->q, s->p, s->nv, s->nu, s->weights != NULL) != ET_OK) {
        abort();
    }
    memcpy(t.u, s->v, (s->nv + s->q + 1) * sizeof *t.u);
    memcpy(t.v, s->u, (s->nu + s->p + 1) * sizeof *t.v);
    for (size_t k = 0; k < s->nu * s->nv; k++) {
        size_t to = k % s->nv * s->nu + k / s->nv;
        t.points[to] = s->points[k];
        if (s->weights) {
            t.weights[to] = s->weights[k];
        }
    }
    return t;
}

/* One case in 2. */
verdict prop_surface_insert_exchanged(gen *g)
{
    et_surface s, a = {0, 0, 0, 0, NULL, NULL, NULL, NULL}, b = a;
    size_t removed = 0, again = 0;

    if (!draw_surface(g, &s, false)) {
        return SKIP;
    }
    et_surface t = exchanged(&s);
    double x = draw_u(g, &s), tolerance = ldexp(1.0, (int)gen_upto(g, 60) - 20);
    uint64_t kind = gen_upto(g, 2);
    et_status status = kind == 0   ? et_surface_insert(&a, &s, ET_ALONG_U, x, 1)
                       : kind == 1 ? et_surface_elevate(&a, &s, ET_ALONG_U, 1)
                                   : et_surface_remove(&a, &removed, &s, ET_ALONG_U, x, 1, tolerance);
    et_status turned = kind == 0   ? et_surface_insert(&b, &t, ET_ALONG_V, x, 1)
                       : kind == 1 ? et_surface_elevate(&b, &t, ET_ALONG_V, 1)
                                   : et_surface_remove(&b, &again, &t, ET_ALONG_V, x, 1, tolerance);
    bool ok = gen_check(g, status == turned && removed == again && a.nu == b.nv && a.nv == b.nu && a.p == b.q, "statuses %d and %d", (int)status,
            (int)turned);
    for (size_t k = 0; ok && status == ET_OK && k < a.nu * a.nv; k++) {
        size_t to = k % a.nv * a.nu + k / a.nv;
        ok = gen_check(g, same_point(a.points[k], b.points[to]) && (!a.weights || a.weights[k] == b.weights[to]), "control point %zu", k);
    }
    gen_label(g, status != ET_OK ? "refused" : kind == 0 ? "inserted" : kind == 1 ? "elevated" : removed ? "removed" : "not removed");
    et_surface_free(&s);
    et_surface_free(&t);
    et_surface_free(&a);
    et_surface_free(&b);
    return ok ? PASS : FAIL;
}
