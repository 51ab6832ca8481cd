/* exact/exact: surfaces, the same way; golden rows, arguments as for the fast functions. */
#include "exact/splines.h"

/* ---- curves ---- */

/* A[a]: the derivative (k,l) of w x, w y, w z, w: de Boor's algorithm along v for each line of control points, then along u. */
static void surface_deboor(fmpq *A, const et_surface *s, const fmpq *h, double u, double v, size_t k, size_t l)
{
    fmpq *line = _fmpq_vec_init((slong)s->nu);
    for (size_t a = 0; a < 4; a++) {
        for (size_t i = 0; i < s->nu; i++) {
            deboor(line + i, h + 4 * i * s->nv + a, 4, s->v, s->nv + s->q + 1, s->q, v, l);
        }
        deboor(A + a, line, 1, s->u, s->nu + s->p + 1, s->p, u, k);
    }
    _fmpq_vec_clear(line, (slong)s->nu);
}

/* Where the derivative (k,l) stands. */
static size_t place(size_t k, size_t l)
{
    size_t m = k + l, at = l;
    while (m > 0) {
        at += m--;
    }
    return at;
}

/* T[4 place(k,l) + a]: coefficients of Taylor's series in two variables, the coordinates by dividing series. */
static void surface_taylor(fmpq *T, size_t d, const et_surface *s, double u, double v)
{
    fmpq *h = lifted(s->points, s->weights, s->nu * s->nv);
    fmpq_t f, e;
    fmpq_init(f);
    fmpq_init(e);
    for (size_t m = 0; m <= d; m++) {
        for (size_t l = 0; l <= m; l++) {
            size_t k = m - l;
            fmpq *C = T + 4 * place(k, l);
            factorial(f, k);
            factorial(e, l);
            fmpq_mul(f, f, e);
            surface_deboor(C, s, h, u, v, k, l);
            for (size_t a = 0; a < 4; a++) {
                fmpq_div(C + a, C + a, f);
            }
            for (size_t a = 0; a < 3; a++) {
                for (size_t i = 0; i <= k; i++) {
                    for (size_t j = i == 0; j <= l; j++) {
                        fmpq_submul(C + a, T + 4 * place(i, j) + 3, T + 4 * place(k - i, l - j) + a);
                    }
                }
                fmpq_div(C + a, C + a, T + 3);
            }
        }
    }
    fmpq_clear(f);
    fmpq_clear(e);
    _fmpq_vec_clear(h, (slong)(4 * s->nu * s->nv));
}

/* sum N M |h_a| with the magnitudes of derivatives k, l of the basis. */
static void surface_size(fmpq_t size, const et_surface *s, double u, double v, size_t k, size_t l, size_t a)
{
    size_t i = et_knots_span(s->u, s->nu + s->p + 1, s->p, u) - s->p, j = et_knots_span(s->v, s->nv + s->q + 1, s->q, v) - s->q;
    fmpq *N = _fmpq_vec_init((slong)(s->p + 1)), *M = _fmpq_vec_init((slong)(s->q + 1)), *h = lifted(s->points, s->weights, s->nu * s->nv);
    fmpq_t t;
    fmpq_init(t);
    magnitudes(N, s->u, s->nu + s->p + 1, s->p, i + s->p, u, k);
    magnitudes(M, s->v, s->nv + s->q + 1, s->q, j + s->q, v, l);
    fmpq_zero(size);
    for (size_t r = 0; r <= s->p; r++) {
        for (size_t c = 0; c <= s->q; c++) {
            fmpq_mul(t, N + r, M + c);
            fmpq_mul(t, t, h + 4 * ((i + r) * s->nv + j + c) + a);
            fmpq_abs(t, t);
            fmpq_add(size, size, t);
        }
    }
    fmpq_clear(t);
    _fmpq_vec_clear(N, (slong)(s->p + 1));
    _fmpq_vec_clear(M, (slong)(s->q + 1));
    _fmpq_vec_clear(h, (slong)(4 * s->nu * s->nv));
}

static double *room(const et_surface *s)
{
    return et_size_array(et_surface_work(s), sizeof(double));
}

verdict prop_exact_surface_point(gen *g)
{
    et_surface s;
    et_vec3 S = {1.0, 2.0, 3.0}, before = S;
    fmpq_t A, size;
    if (!draw_surface(g, &s, 4)) {
        return SKIP;
    }
    double u = gen_parameter(g, s.u, s.nu + s.p + 1, s.p), v = gen_parameter(g, s.v, s.nv + s.q + 1, s.q), *work = room(&s);
    fmpq *T = _fmpq_vec_init(4);
    fmpq_init(A);
    fmpq_init(size);
    bool ok = gen_check(g, et_exact_surface_point(&S, &s, NAN, v) == ET_EINVAL && et_exact_surface_point(&S, &s, u, -HUGE_VAL) == ET_EINVAL &&
                               same_point(S, before), "parameters that are not finite");
    ok = ok && gen_check(g, et_exact_surface_point(&S, &s, u, v) == ET_OK, "no point");
    et_vec3 fast = et_surface_point(&s, u, v, work, et_surface_work(&s));
    surface_taylor(T, 0, &s, u, v);
    for (int a = 0; ok && a < 3; a++) {
        double want = exact_round(T + a);
        ok = gen_check(g, ref_same(coordinate(S, a), want), "(%a, %a): coordinate %d is %a, by de Boor %a", u, v, a, coordinate(S, a), want);
        fmpq_mul(A, T + a, T + 3);
        surface_size(size, &s, u, v, 0, 0, (size_t)a);
        ok = ok && gen_check(g, point_within(coordinate(fast, a), T + 3, A, 7 * (s.p + s.q), size, s.weights != NULL),
                             "et_surface_point: coordinate %d is %a for %a", a, coordinate(fast, a), want);
    }
    s.points[0].z = NAN;
    before = S;
    ok = ok && gen_check(g, et_exact_surface_point(&S, &s, u, v) == ET_EINVAL && same_point(S, before), "a surface that is not valid");
    free(work);
    fmpq_clear(A);
    fmpq_clear(size);
    _fmpq_vec_clear(T, 4);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Corners of a clamped polynomial surface are control points; integers at sixteenths of a Bezier patch are not rounded, so the fast point is this
 * one. */
verdict prop_exact_surface_point_exact(gen *g)
{
    et_surface s;
    et_vec3 S;
    size_t p = (size_t)gen_upto(g, 4), q = (size_t)gen_upto(g, 4);
    if (et_surface_new(&s, p, q, p + 1, q + 1, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= p; i++) {
        s.u[p + 1 + i] = 1.0;
    }
    for (size_t j = 0; j <= q; j++) {
        s.v[q + 1 + j] = 1.0;
    }
    for (size_t k = 0; k < (p + 1) * (q + 1); k++) {
        s.points[k] = (et_vec3){(double)gen_upto(g, 64) - 32.0, (double)gen_upto(g, 64), (double)gen_upto(g, 9)};
    }
    double u = (double)gen_upto(g, 16) / 16.0, v = (double)gen_upto(g, 16) / 16.0, *work = room(&s);
    et_vec3 fast = et_surface_point(&s, u, v, work, et_surface_work(&s));
    bool ok = gen_check(g, et_exact_surface_point(&S, &s, u, v) == ET_OK && S.x == fast.x && S.y == fast.y && S.z == fast.z, "(%g, %g): %a, fast %a",
                        u, v, S.x, fast.x);
    for (int corner = 0; ok && corner < 4; corner++) {
        et_vec3 P = s.points[(corner / 2 ? p : 0) * (q + 1) + (corner % 2 ? q : 0)];
        ok = gen_check(g, et_exact_surface_point(&S, &s, corner / 2 ? 9.0 : -9.0, corner % 2 ? 1.0 : 0.0) == ET_OK && same_point(S, P), "corner %d",
                       corner);
    }
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Leibniz' rule for the six fast derivatives.  Roundings of a term: 6p + 2 and 6q + 2 in the basis, p and q sums, 3 products, 1 or 2 more with w's
 * derivative, 3 differences: fewer than 7(p+q) + 12. */
static bool six_within(gen *g, const et_surface *s, const et_vec3 *D, const fmpq *T, double u, double v)
{
    static const size_t du[6] = {0, 1, 0, 2, 1, 0}, dv[6] = {0, 0, 1, 0, 1, 2};
    fmpq *q = _fmpq_vec_init(6);
    fmpq *sum = q, *size = q + 1, *W = q + 2, *w = q + 3, *f = q + 4, *one = q + 5;
    bool ok = true;
    fmpq_one(one);
    for (size_t n = 0; ok && n < 6; n++) {
        size_t k = du[n], l = dv[n];
        for (int a = 0; ok && a < 3; a++) {
            fmpq_one(sum);
            surface_size(size, s, u, v, k, l, (size_t)a);
            for (size_t i = 0; i <= k; i++) {
                for (size_t j = 0; j <= l; j++) {
                    /* Orders up to 2: C(k,i) C(l,j) is 1 or 2, the factorials that make derivatives of coefficients likewise. */
                    ulong factor = (k == 2 && i == 1 ? 2u : 1u) * (l == 2 && j == 1 ? 2u : 1u);
                    size_t rest = place(k - i, l - j);
                    fmpq_mul_ui(w, T + 4 * place(i, j) + 3, factor * (i == 2 || j == 2 ? 2u : 1u));
                    exact_set(f, coordinate(D[rest], a));
                    fmpq_set(W, T + 4 * rest + (size_t)a);
                    fmpq_mul_ui(W, W, k - i == 2 || l - j == 2 ? 2u : 1u);
                    fmpq_sub(W, f, W);
                    fmpq_addmul(sum, w, W);
                    if (s->weights) {
                        surface_size(W, s, u, v, i, j, 3);
                        fmpq_mul_ui(W, W, factor);
                        fmpq_abs(f, f);
                        fmpq_addmul(size, W, f);
                    }
                }
            }
            ok = gen_check(g, within(1.0, one, sum, 7 * (s->p + s->q) + 12, size), "et_surface_ders: derivative %zu, coordinate %d: %a", n, a,
                           coordinate(D[n], a));
        }
    }
    _fmpq_vec_clear(q, 6);
    return ok;
}

verdict prop_exact_surface_ders(gen *g)
{
    et_surface s;
    et_vec3 D[(ORDER + 1) * (ORDER + 2) / 2 + 1], F[6], end = {1.0, 2.0, 3.0}, S;
    if (!draw_surface(g, &s, 3)) {
        return SKIP;
    }
    double u = gen_parameter(g, s.u, s.nu + s.p + 1, s.p), v = gen_parameter(g, s.v, s.nv + s.q + 1, s.q), *work = room(&s);
    size_t d = (size_t)gen_upto(g, gen_chance(g, 6) ? ORDER : 3), n = (d + 1) * (d + 2) / 2;
    fmpq *T = _fmpq_vec_init((slong)(4 * n));
    fmpq_t f, e;
    fmpq_init(f);
    fmpq_init(e);
    D[0] = D[n] = end;
    bool ok = gen_check(g, et_exact_surface_ders(D, d, &s, u, NAN) == ET_EINVAL && et_exact_surface_ders(D, d, &s, HUGE_VAL, v) == ET_EINVAL &&
                               same_point(D[0], end), "parameters that are not finite");
    ok = ok && gen_check(g,
                         et_exact_surface_ders(D, SIZE_MAX, &s, u, v) == ET_ENOMEM && et_exact_surface_ders(D, SIZE_MAX - 1, &s, u, v) == ET_ENOMEM &&
                             et_exact_surface_ders(D, SIZE_MAX / 2, &s, u, v) == ET_ENOMEM && same_point(D[0], end),
                         "an order beyond all sizes");
    ok = ok && gen_check(g, et_exact_surface_ders(D, d, &s, u, v) == ET_OK && same_point(D[n], end), "status, or wrote beyond %zu", n);
    ok = ok && gen_check(g, et_exact_surface_point(&S, &s, u, v) == ET_OK && same_point(D[0], S), "D[0] is another point");
    surface_taylor(T, d, &s, u, v);
    for (size_t m = 0; m <= d; m++) {
        for (size_t l = 0; l <= m; l++) {
            factorial(f, m - l);
            factorial(e, l);
            fmpq_mul(f, f, e);
            for (size_t a = 0; ok && a < 3; a++) {
                fmpq_mul(e, T + 4 * place(m - l, l) + a, f);
                ok = gen_check(g, ref_same(coordinate(D[m * (m + 1) / 2 + l], (int)a), exact_round(e)),
                               "(%a, %a): derivative (%zu,%zu), coordinate %zu: %a, by its series %a", u, v, m - l, l, a,
                               coordinate(D[m * (m + 1) / 2 + l], (int)a), exact_round(e));
            }
        }
    }
    et_surface_ders(F, &s, u, v, work, et_surface_work(&s));
    ok = ok && (d < 2 || !moderate(D, 6) || !moderate(F, 6) || six_within(g, &s, F, T, u, v));
    s.q = s.nv;
    D[0] = end;
    ok = ok && gen_check(g, et_exact_surface_ders(D, d, &s, u, v) == ET_EINVAL && same_point(D[0], end), "a surface that is not valid");
    s.q = 0;
    free(work);
    fmpq_clear(f);
    fmpq_clear(e);
    _fmpq_vec_clear(T, (slong)(4 * n));
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_exact_surface_grid(gen *g)
{
    et_surface s;
    et_vec3 S[2 * TALL + 1], P, end = {1.0, 2.0, 3.0};
    double a[TALL], b[6];
    bool tall = gen_chance(g, 30);             /* more rows than are computed at a time */
    size_t na = tall ? (size_t)gen_between(g, 60, TALL) : (size_t)gen_upto(g, 6), nb = (size_t)gen_upto(g, tall ? 2 : 6);
    if (!draw_surface(g, &s, 4)) {
        return SKIP;
    }
    for (size_t i = 0; i < na; i++) {
        a[i] = gen_chance(g, 10) ? 1e300 : gen_parameter(g, s.u, s.nu + s.p + 1, s.p);
    }
    for (size_t j = 0; j < nb; j++) {
        b[j] = gen_chance(g, 10) ? -1e300 : gen_parameter(g, s.v, s.nv + s.q + 1, s.q);
    }
    S[0] = S[na * nb] = end;
    bool ok =
        gen_check(g, et_exact_surface_grid(S, &s, a, na, b, nb) == ET_OK && same_point(S[na * nb], end), "status, or wrote beyond %zu x %zu", na, nb);
    for (size_t k = 0; ok && k < na * nb; k++) {
        ok = gen_check(g, et_exact_surface_point(&P, &s, a[k / nb], b[k % nb]) == ET_OK && same_point(P, S[k]), "point %zu of %zu x %zu: %a for %a",
                       k, na, nb, S[k].x, P.x);
    }
    S[0] = end;
    if (na > 0) {
        double old = a[na - 1];
        a[na - 1] = NAN;
        ok = ok && gen_check(g, et_exact_surface_grid(S, &s, a, na, b, nb) == ET_EINVAL && same_point(S[0], end), "a NaN among a");
        a[na - 1] = old;
    }
    if (nb > 0) {
        double old = b[nb - 1];
        b[nb - 1] = HUGE_VAL;
        ok = ok && gen_check(g, et_exact_surface_grid(S, &s, a, na, b, nb) == ET_EINVAL && same_point(S[0], end), "an infinity among b");
        b[nb - 1] = old;
    }
    s.u[0] = NAN;
    ok = ok && gen_check(g, et_exact_surface_grid(S, &s, a, na, b, nb) == ET_EINVAL && same_point(S[0], end), "a surface that is not valid");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* ---- golden rows: arguments as for the fast functions ---- */

static bool is(const row *r, const double *x, size_t n)
{
    bool ok = r->nwant == n;
    for (size_t k = 0; k < n; k++) {
        ok = row_is(r, k, x[k]) && ok;
    }
    return ok;
}

static bool are(const row *r, const et_vec3 *P, size_t n)
{
    bool ok = r->nwant == 3 * n;
    for (size_t k = 0; k < 3 * n; k++) {
        ok = row_is(r, k, coordinate(P[k / 3], (int)(k % 3))) && ok;
    }
    return ok;
}

/* degree, order, number of knots, knots, parameter. */
static verdict true_basis(const row *r, size_t d)
{
    size_t p = row_size(r, 0), nu = row_size(r, 2);
    if (p > 100 || d > 100 || nu + 4 != r->nargs) {
        return FAIL;
    }
    double *u = et_size_array(nu, sizeof *u), *D = et_size_array((d + 1) * (p + 1), sizeof *D), x = row_real(r, 3 + nu);
    for (size_t i = 0; i < nu; i++) {
        u[i] = row_real(r, 3 + i);
    }
    bool ok = et_knots_valid(u, nu, p) == 1;
    size_t span = ok ? et_knots_span(u, nu, p, x) : 0;
    ok = ok && (d == 0 ? et_exact_basis_eval(D, u, nu, p, span, x) : et_exact_basis_ders(D, d, u, nu, p, span, x)) == ET_OK;
    ok = ok && is(r, D + d * (p + 1), p + 1);
    free(u);
    free(D);
    return ok ? PASS : FAIL;
}

verdict true_basis_eval(const row *r)
{
    return true_basis(r, 0);
}

verdict true_basis_ders(const row *r)
{
    return true_basis(r, row_size(r, 1));
}

verdict true_curve_point(const row *r)
{
    et_curve c;
    et_vec3 C;
    size_t at = read_curve(r, &c);
    bool ok = at > 0 && et_exact_curve_point(&C, &c, row_real(r, at)) == ET_OK && are(r, &C, 1);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict true_curve_ders(const row *r)
{
    et_curve c;
    et_vec3 D[32];
    size_t at = read_curve(r, &c), k = row_size(r, at);
    bool ok = at > 0 && k < 32 && et_exact_curve_ders(D, k, &c, row_real(r, at + 1)) == ET_OK && are(r, D + k, 1);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict true_surface_point(const row *r)
{
    et_surface s;
    et_vec3 S;
    size_t at = read_surface(r, &s);
    bool ok = at > 0 && et_exact_surface_point(&S, &s, row_real(r, at), row_real(r, at + 1)) == ET_OK && are(r, &S, 1);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict true_surface_ders(const row *r)
{
    et_surface s;
    et_vec3 D[28];
    size_t at = read_surface(r, &s), k = row_size(r, at), d = 0;
    while ((d + 1) * (d + 2) / 2 <= k && d < 7) {
        d++;
    }
    bool ok = at > 0 && d < 7 && et_exact_surface_ders(D, d, &s, row_real(r, at + 1), row_real(r, at + 2)) == ET_OK && are(r, D + k, 1);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* After the surface: n, then u and v by turns. */
verdict true_surface_points(const row *r)
{
    et_surface s;
    size_t at = read_surface(r, &s), n = row_size(r, at++);
    et_vec3 *S = et_size_array(n, sizeof *S);
    bool ok = at > 1 && S;
    for (size_t k = 0; ok && k < n; k++) {
        ok = et_exact_surface_point(S + k, &s, row_real(r, at + 2 * k), row_real(r, at + 2 * k + 1)) == ET_OK;
    }
    ok = ok && are(r, S, n);
    free(S);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* After the surface: na, nb, the a, the b. */
verdict true_surface_grid(const row *r)
{
    et_surface s;
    size_t at = read_surface(r, &s), na = row_size(r, at), nb = row_size(r, at + 1);
    double *a = et_size_array(na, sizeof *a), *b = et_size_array(nb, sizeof *b);
    et_vec3 *S = et_size_array(na * nb, sizeof *S);
    bool ok = at > 0 && a && b && S;
    if (ok) {
        read_knots(r, b, nb, read_knots(r, a, na, at + 2));
        ok = et_exact_surface_grid(S, &s, a, na, b, nb) == ET_OK && are(r, S, na * nb);
    }
    free(a);
    free(b);
    free(S);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
