/* exact/exact_edit: Greville points, one-sided derivatives (against those of what is run through backwards), normals. */
#include "exact/edited.h"

/* ---- Greville points ---- */

verdict prop_exact_knots_greville(gen *g)
{
    double u[REF_KNOTS], G[REF_KNOTS];
    size_t p = (size_t)gen_upto(g, DEGREE + 2), nu = 2 * p + 2 + (size_t)gen_upto(g, 8), n = nu - p - 1;
    mpfr_t sum;
    ref_draw_knots(g, u, nu, p);
    if (gen_chance(g, 5)) {                                 /* neighbours: the middle of two is a tie */
        gen_label(g, "neighbours");
        u[0] = gen_upto(g, 1) ? 1.0 : 0x1.fffffffffffffp0;
        for (size_t i = 1; i < nu; i++) {
            u[i] = gen_upto(g, 1) ? u[i - 1] : nextafter(u[i - 1], HUGE_VAL);
        }
    }
    if (!et_knots_valid(u, nu, p)) {
        return SKIP;
    }
    G[0] = G[n] = 4711.0;
    bool ok = gen_check(g, knots_greville(G, n + 1, u, nu, p) == ET_EINVAL && knots_greville(G, n - 1, u, nu, p) == ET_EINVAL &&
                               knots_greville(G, n, u, 2 * p + 1, p) == ET_EINVAL && G[0] == 4711.0,
                        "another number of points, too few knots");
    ok = ok && gen_check(g, knots_greville(G, n, u, nu, p) == ET_OK && G[n] == 4711.0, "status, or wrote beyond");
    mpfr_init2(sum, SECOND_BITS);
    for (size_t i = 0; ok && i < n; i++) {
        mpfr_set_d(sum, u[i + (p > 0 ? 1 : 0)], MPFR_RNDN);
        for (size_t j = 2; j <= (p > 0 ? p : 2); j++) {
            mpfr_add_d(sum, sum, u[i + j - (p > 0 ? 0 : 1)], MPFR_RNDN);
        }
        mpfr_div_ui(sum, sum, p > 0 ? (unsigned long)p : 2, MPFR_RNDN);
        double want = mpfr_zero_p(sum) ? 0.0 : nearest(sum);
        ok = gen_check(g, ref_same(G[i], want), "p = %zu: point %zu is %a, not %a", p, i, G[i], want);
        ok = ok && gen_check(g, u[i] <= G[i] && G[i] <= u[i + p + 1], "point %zu, %a, is outside", i, G[i]);
    }
    u[1] = NAN;
    double before = G[0];
    ok = ok && gen_check(g, knots_greville(G, n, u, nu, p) == ET_EINVAL && ref_same(G[0], before), "knots that are not valid");
    mpfr_clear(sum);
    return ok ? PASS : FAIL;
}

/* ---- one-sided derivatives ---- */

static et_side draw_side(gen *g)
{
    return gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
}

static et_side other(et_side side)
{
    return side == ET_SIDE_LEFT ? ET_SIDE_RIGHT : ET_SIDE_LEFT;
}

/* One of the knots, a third of them repeated p + 1 times. */
static double draw_knot(gen *g, double *u, size_t nu, size_t p)
{
    size_t from = (size_t)gen_upto(g, nu - 1);
    if (gen_chance(g, 3)) {
        gen_label(g, "run of knots");
        for (size_t i = from; i + 1 < nu && i <= from + p && u[from] < u[nu - 1]; i++) {
            u[i] = u[from];
        }
    }
    return u[from];
}

static void reverse_knots(double *u, size_t nu)
{
    for (size_t i = 0; i < (nu + 1) / 2; i++) {
        double x = u[i];
        u[i] = -u[nu - 1 - i];
        u[nu - 1 - i] = -x;
    }
}

/* What is run through backwards: points k of n lines of `step` each change places. */
static void reverse_points(et_vec3 *P, double *w, size_t n, size_t step)
{
    for (size_t i = 0; i < n / 2; i++) {
        for (size_t k = 0; k < step; k++) {
            size_t a = i * step + k, b = (n - 1 - i) * step + k;
            et_vec3 Q = P[a];
            double v = w == NULL ? 0.0 : w[a];
            P[a] = P[b];
            P[b] = Q;
            if (w != NULL) {
                w[a] = w[b];
                w[b] = v;
            }
        }
    }
}

static bool equal_signed(et_vec3 a, et_vec3 b, bool minus)
{
    double s = minus ? -1.0 : 1.0;
    return a.x == s * b.x && a.y == s * b.y && a.z == s * b.z;
}

verdict prop_exact_curve_ders_side(gen *g)
{
    et_curve c;
    et_vec3 D[ORDER + 2], E[ORDER + 1];
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = draw_knot(g, c.u, knots_of(&c), c.p);
    x = gen_chance(g, 4) ? gen_parameter(g, c.u, knots_of(&c), c.p) : x;
    size_t d = (size_t)gen_upto(g, ORDER);
    et_side side = draw_side(g);
    if (!et_curve_valid(&c)) {
        et_curve_free(&c);
        return SKIP;
    }
    D[0] = D[d + 1] = (et_vec3){1.0, 2.0, 3.0};
    bool ok = gen_check(g, et_exact_curve_ders_side(D, d, &c, NAN, side) == ET_EINVAL && D[0].y == 2.0, "a parameter that is no number");
    ok = ok && gen_check(g, et_exact_curve_ders_side(D, SIZE_MAX, &c, x, side) == ET_ENOMEM && D[0].y == 2.0, "an order beyond all sizes");
    live_begin(d + c.n + 3 * c.p);
    et_status status = et_exact_curve_ders_side(D, d, &c, x, side);
    ok = gen_check(g, live_end(), "memory is kept") && ok && gen_check(g, status == ET_OK && D[d + 1].z == 3.0, "status, or wrote beyond");
    ok = ok && gen_check(g, et_exact_curve_ders(E, d, &c, x) == ET_OK, "no derivatives");
    for (size_t k = 0; ok && k <= d && side == ET_SIDE_RIGHT; k++) {
        ok = gen_check(g, same_point(D[k], E[k]), "derivative %zu from the right is another one", k);
    }
    reverse_knots(c.u, knots_of(&c));
    reverse_points(c.points, c.weights, c.n, 1);
    ok = ok && gen_check(g, et_exact_curve_ders_side(E, d, &c, -x, other(side)) == ET_OK, "not the other way round");
    for (size_t k = 0; ok && k <= d; k++) {
        ok = gen_check(g, equal_signed(D[k], E[k], k % 2 == 1), "derivative %zu: %a, the other way round %a", k, D[k].x, E[k].x);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Two constants, or two straight lines, that meet at a knot or jump there: both limits by hand, and none but them. */
verdict prop_exact_curve_ders_side_jump(gen *g)
{
    et_curve c;
    et_vec3 L[3], R[3];
    size_t p = (size_t)gen_upto(g, 2), more = (size_t)gen_upto(g, 2), n = 2 * p + 2 + more;
    double a = (double)gen_upto(g, 16), b = (double)gen_upto(g, 16);
    if (et_curve_new(&c, p, n, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < n + p + 1; i++) {               /* 0 .., 1 .. (p + 1 + more), 2 .. */
        c.u[i] = i <= p ? 0.0 : i < n ? 1.0 : 2.0;
    }
    for (size_t i = 0; i <= p; i++) {
        c.points[i].x = a * (double)i;
        c.points[n - 1 - i].x = 1.0 + b * (double)(p - i);
    }
    bool ok = et_exact_curve_ders_side(L, 2, &c, 1.0, ET_SIDE_LEFT) == ET_OK && et_exact_curve_ders_side(R, 2, &c, 1.0, ET_SIDE_RIGHT) == ET_OK;
    ok = gen_check(g, ok, "no derivatives");
    ok = ok && gen_check(g, L[0].x == (double)p * a && L[1].x == (double)p * a && L[2].x == 0.0, "from the left: %g, slope %g", L[0].x, L[1].x);
    ok = ok && gen_check(g, R[0].x == 1.0 && R[1].x == (double)p * b && R[2].x == 0.0, "from the right: %g, slope %g", R[0].x, R[1].x);
    for (int end = 0; ok && end < 2; end++) {               /* and beyond the ends */
        double x = end ? 2.0 : 0.0, want = end ? 1.0 + (double)p * b : 0.0, slope_there = (double)p * (end ? b : a);
        for (int beyond = 0; ok && beyond < 2; beyond++) {
            double at = x + (end ? 1.0 : -1.0) * beyond;
            ok = et_exact_curve_ders_side(L, 1, &c, at, ET_SIDE_LEFT) == ET_OK && et_exact_curve_ders_side(R, 1, &c, at, ET_SIDE_RIGHT) == ET_OK;
            ok = gen_check(g, ok && L[0].x == want && R[0].x == want && L[1].x == slope_there && R[1].x == slope_there, "at %g: %g and %g", at,
                           L[0].x, R[0].x);
        }
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict prop_exact_surface_partials(gen *g)
{
    et_surface s;
    enum { MOST = (ORDER + 1) * (ORDER + 2) / 2 };
    et_vec3 D[MOST + 1], E[MOST];
    if (!draw_surface(g, &s, 3)) {
        return SKIP;
    }
    double u = draw_knot(g, s.u, s.nu + s.p + 1, s.p), v = draw_knot(g, s.v, s.nv + s.q + 1, s.q);
    size_t d = (size_t)gen_upto(g, 3), n = (d + 1) * (d + 2) / 2;
    et_side a = draw_side(g), b = draw_side(g);
    bool along_u = gen_upto(g, 1) == 0;
    if (!et_surface_valid(&s)) {
        et_surface_free(&s);
        return SKIP;
    }
    D[0] = D[n] = (et_vec3){1.0, 2.0, 3.0};
    bool ok = gen_check(g,
                        et_exact_surface_partials(D, d, &s, NAN, v, a, b) == ET_EINVAL &&
                            et_exact_surface_partials(D, d, &s, u, HUGE_VAL, a, b) == ET_EINVAL &&
                            et_exact_surface_partials(D, SIZE_MAX, &s, u, v, a, b) == ET_ENOMEM && D[0].y == 2.0,
                        "what has to be refused");
    ok = ok && gen_check(g, et_exact_surface_partials(D, d, &s, u, v, a, b) == ET_OK && D[n].z == 3.0, "status, or wrote beyond");
    ok = ok && gen_check(g, et_exact_surface_ders(E, d, &s, u, v) == ET_OK, "no derivatives");
    for (size_t k = 0; ok && k < n && a == ET_SIDE_RIGHT && b == ET_SIDE_RIGHT; k++) {
        ok = gen_check(g, same_point(D[k], E[k]), "derivative %zu from the right is another one", k);
    }
    reverse_knots(along_u ? s.u : s.v, along_u ? s.nu + s.p + 1 : s.nv + s.q + 1);
    if (along_u) {
        reverse_points(s.points, s.weights, s.nu, s.nv);
    } else {
        for (size_t i = 0; i < s.nu; i++) {
            reverse_points(s.points + i * s.nv, s.weights == NULL ? NULL : s.weights + i * s.nv, s.nv, 1);
        }
    }
    ok =
        ok &&
        gen_check(g, et_exact_surface_partials(E, d, &s, along_u ? -u : u, along_u ? v : -v, along_u ? other(a) : a, along_u ? b : other(b)) == ET_OK,
                  "not the other way round");
    for (size_t order = 0; ok && order <= d; order++) {
        for (size_t l = 0; ok && l <= order; l++) {
            size_t k = order * (order + 1) / 2 + l, times = along_u ? order - l : l;
            ok = gen_check(g, equal_signed(D[k], E[k], times % 2 == 1), "derivative %zu: %a, the other way round %a", k, D[k].x, E[k].x);
        }
    }
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* ---- normals ---- */

/* h[4 k + a], k = 0, 1, 2: w S and its derivatives by u and by v, by de Boor's algorithm over u, then over v. */
static void surface_slopes(fmpq *h, const et_surface *s, double u, double v)
{
    fmpq *all = lifted(s->points, s->weights, s->nu * s->nv), *line = _fmpq_vec_init((slong)s->nv);
    for (size_t k = 0; k < 3; k++) {
        for (size_t a = 0; a < 4; a++) {
            for (size_t j = 0; j < s->nv; j++) {
                deboor(line + j, all + 4 * j + a, 4 * s->nv, s->u, s->nu + s->p + 1, s->p, u, k == 1);
            }
            deboor(h + 4 * k + a, line, 1, s->v, s->nv + s->q + 1, s->q, v, k == 2);
        }
    }
    _fmpq_vec_clear(all, (slong)(4 * s->nu * s->nv));
    _fmpq_vec_clear(line, (slong)s->nv);
}

/* N: a vector along the normal: the cross product of (w A_u - w_u A) and (w A_v - w_v A). */
static void along_normal(fmpq *N, const fmpq *h)
{
    fmpq *t = _fmpq_vec_init(6);
    fmpq_t x;
    fmpq_init(x);
    for (size_t k = 0; k < 6; k++) {
        fmpq_mul(t + k, h + 3, h + 4 * (1 + k / 3) + k % 3);
        fmpq_mul(x, h + k % 3, h + 4 * (1 + k / 3) + 3);
        fmpq_sub(t + k, t + k, x);
    }
    for (size_t a = 0; a < 3; a++) {
        fmpq_mul(N + a, t + (a + 1) % 3, t + 3 + (a + 2) % 3);
        fmpq_mul(x, t + (a + 2) % 3, t + 3 + (a + 1) % 3);
        fmpq_sub(N + a, N + a, x);
    }
    fmpq_clear(x);
    _fmpq_vec_clear(t, 6);
}

/* n_a / sqrt(n_x^2 + n_y^2 + n_z^2). */
static double direction(const fmpq *N, size_t a)
{
    mpfr_t sum, x;
    mpfr_init2(sum, SECOND_BITS);
    mpfr_init2(x, SECOND_BITS);
    mpfr_set_zero(sum, 1);
    for (size_t k = 0; k < 3; k++) {
        fmpq_get_mpfr(x, N + k, MPFR_RNDN);
        mpfr_sqr(x, x, MPFR_RNDN);
        mpfr_add(sum, sum, x, MPFR_RNDN);
    }
    mpfr_sqrt(sum, sum, MPFR_RNDN);
    fmpq_get_mpfr(x, N + a, MPFR_RNDN);
    mpfr_div(x, x, sum, MPFR_RNDN);
    double want = mpfr_zero_p(x) ? 0.0 : nearest(x);
    mpfr_clear(sum);
    mpfr_clear(x);
    return want;
}

verdict prop_exact_surface_normal(gen *g)
{
    et_surface s;
    et_vec3 n = {1.0, 2.0, 3.0}, before = n;
    if (!draw_surface(g, &s, 3)) {
        return SKIP;
    }
    double u = gen_parameter(g, s.u, s.nu + s.p + 1, s.p), v = gen_parameter(g, s.v, s.nv + s.q + 1, s.q);
    fmpq *h = _fmpq_vec_init(12), *N = _fmpq_vec_init(3);
    surface_slopes(h, &s, u, v);
    along_normal(N, h);
    bool flat = fmpq_is_zero(N) && fmpq_is_zero(N + 1) && fmpq_is_zero(N + 2);
    gen_label(g, flat ? "no normal" : "normal");
    bool ok = gen_check(g, et_exact_surface_normal(&n, &s, NAN, v) == ET_EINVAL && et_exact_surface_normal(&n, &s, u, -HUGE_VAL) == ET_EINVAL &&
                               same_point(n, before), "parameters that are not finite");
    ok = ok && gen_check(g, et_exact_surface_normal(&n, &s, u, v) == (flat ? ET_ERANK : ET_OK), "status");
    ok = ok && gen_check(g, !flat || same_point(n, before), "changed where there is none");
    for (int a = 0; ok && !flat && a < 3; a++) {
        double want = direction(N, (size_t)a);
        ok = gen_check(g, ref_same(coordinate(n, a), want), "coordinate %d is %a, not %a", a, coordinate(n, a), want);
    }
    s.points[0].z = NAN;
    before = n;
    ok = ok && gen_check(g, et_exact_surface_normal(&n, &s, u, v) == ET_EINVAL && same_point(n, before), "a surface that is not valid");
    _fmpq_vec_clear(h, 12);
    _fmpq_vec_clear(N, 3);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
