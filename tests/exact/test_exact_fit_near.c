/* Exact fits of larger nets: the gradient at the rounded solution is what rounding leaves, and the fast fit is near. */
#include "exact/fitted.h"

/* ---- larger nets: the gradient at the rounded solution is what rounding leaves ---- */

enum { BITS = 512 };

static void collocation(arb_mat_t A, const double *t, const double *u, size_t p)
{
    const size_t m = (size_t)arb_mat_nrows(A), n = (size_t)arb_mat_ncols(A);
    fmpq *N = _fmpq_vec_init((slong)p + 1);

    arb_mat_zero(A);
    for (size_t i = 0; i < m; i++) {
        size_t span = p;
        while (span + 1 < n && !(t[i] < u[span + 1]))
            span++;
        while (u[span] == u[span + 1])
            span--;
        exact_basis(N, 0, u, n + p + 1, p, span, t[i]);
        for (size_t k = 0; k <= p; k++)
            arb_set_fmpq(arb_mat_entry(A, (slong)i, (slong)(span - p + k)), N + k, BITS);
    }
    _fmpq_vec_clear(N, (slong)p + 1);
}

/* C = A X B', or A'X B. */
static void sandwich(arb_mat_t C, const arb_mat_t A, const arb_mat_t X, const arb_mat_t B, bool from_left)
{
    arb_mat_t T, L;

    if (from_left) {
        arb_mat_init(L, arb_mat_ncols(A), arb_mat_nrows(A));
        arb_mat_init(T, arb_mat_ncols(A), arb_mat_ncols(X));
        arb_mat_transpose(L, A);
        arb_mat_mul(T, L, X, BITS);
        arb_mat_mul(C, T, B, BITS);
    } else {
        arb_mat_init(L, arb_mat_ncols(B), arb_mat_nrows(B));
        arb_mat_init(T, arb_mat_nrows(A), arb_mat_ncols(X));
        arb_mat_transpose(L, B);
        arb_mat_mul(T, A, X, BITS);
        arb_mat_mul(C, T, L, BITS);
    }
    arb_mat_clear(L);
    arb_mat_clear(T);
}

static double half_ulp(double x)
{
    return fmax((nextafter(fabs(x), HUGE_VAL) - fabs(x)) / 2, 0x1p-1074);
}

/* Of view w and one coordinate: gradient A'(A P B' - D)B, and its bound, A'A |half ulps| B'B, basis functions being positive.  border: of the view's
 * own, too, are the border's data. */
static void slope(arb_mat_t G, arb_mat_t E, const problem *c, const et_fit *f, size_t w, size_t e, bool border)
{
    const et_surface *v = &f->shell.view[w];
    const size_t m = c->net.nx, n = c->net.ny;
    arb_mat_t A, B, P, H, R, S;

    arb_mat_init(A, (slong)m, (slong)v->nu);
    arb_mat_init(B, (slong)n, (slong)v->nv);
    arb_mat_init(P, (slong)v->nu, (slong)v->nv);
    arb_mat_init(H, (slong)v->nu, (slong)v->nv);
    arb_mat_init(R, (slong)m, (slong)n);
    arb_mat_init(S, (slong)m, (slong)n);
    collocation(A, f->s[w], v->u, v->p);
    collocation(B, f->r[w], v->v, v->q);
    for (size_t at = 0; at < v->nu * v->nv; at++) {
        const double x = (&v->points[at].x)[e];
        arb_set_d(arb_mat_entry(P, (slong)(at / v->nv), (slong)(at % v->nv)), x);
        arb_set_d(arb_mat_entry(H, (slong)(at / v->nv), (slong)(at % v->nv)), half_ulp(x));
    }
    sandwich(R, A, P, B, false);
    sandwich(S, A, H, B, false);
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < n; j++) {
            arb_ptr r = arb_mat_entry(R, (slong)i, (slong)j), s = arb_mat_entry(S, (slong)i, (slong)j);
            arb_t d;
            arb_init(d);
            arb_set_d(d, (&c->data[class_at(c, w, i, j)].x)[e]);
            arb_sub(r, r, d, BITS);
            arb_clear(d);
            if (!border && (i == 0 || j == 0 || i + 1 == m || j + 1 == n)) {
                arb_zero(r);
                arb_zero(s);
            }
        }
    sandwich(G, A, R, B, true);
    sandwich(E, A, S, B, true);
    arb_mat_clear(A);
    arb_mat_clear(B);
    arb_mat_clear(P);
    arb_mat_clear(H);
    arb_mat_clear(R);
    arb_mat_clear(S);
}

static bool stationary(gen *g, const problem *c, const et_fit *f, size_t e, bool fixed)
{
    const et_doublenet k = c->options.control;
    const bool joint = c->options.approach == ET_FIT_JOINT;
    arb_mat_t G[2], E[2];
    bool ok = true;

    for (size_t w = 0; w < 2; w++) {
        arb_mat_init(G[w], (slong)k.nx, (slong)k.ny);
        arb_mat_init(E[w], (slong)k.nx, (slong)k.ny);
        slope(G[w], E[w], c, f, w, e, !joint || w == 0);
    }
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < k.nx; i++)
            for (size_t j = 0; j < k.ny; j++) {
                const bool end_u = i == 0 || i + 1 == k.nx, end_v = j == 0 || j + 1 == k.ny;
                arb_ptr x = arb_mat_entry(G[w], (slong)i, (slong)j), bound = arb_mat_entry(E[w], (slong)i, (slong)j);
                if ((fixed && end_u && end_v) || (joint && w == 1 && (end_u || end_v)))
                    continue;
                if (joint && (end_u || end_v)) {
                    arb_add(x, x, arb_mat_entry(G[1], (slong)i, (slong)j), BITS);
                    arb_add(bound, bound, arb_mat_entry(E[1], (slong)i, (slong)j), BITS);
                }
                arb_abs(x, x);
                ok = gen_check(g, !arb_gt(x, bound), "view %zu (%zu,%zu): gradient %g, rounding leaves %g", w, i, j,
                               arf_get_d(arb_midref(x), ARF_RND_NEAR), arf_get_d(arb_midref(bound), ARF_RND_NEAR)) &&
                     ok;
            }
    for (size_t w = 0; w < 2; w++) {
        arb_mat_clear(G[w]);
        arb_mat_clear(E[w]);
    }
    return ok;
}

verdict prop_exact_fit_make_gradient(gen *g)
{
    problem c;
    et_fit f;
    bool ok = true;

    draw_options(g, &c, 2, gen_chance(g, 8) ? LARGE : SIDE);
    draw_pillow(g, &c);
    if (c.options.approach == ET_FIT_IMPROVED)
        c.options.approach = ET_FIT_JOINT;
    if (fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL) != ET_OK)
        return SKIP;
    gen_label(g, et_fit_name(c.options.approach));
    for (size_t e = 0; e < 3; e++)
        ok = stationary(g, &c, &f, e, c.options.corners == ET_CORNERS_INTERPOLATED) && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- the fast fit is near ---- */

/* |A+| and |A| of a direction, Frobenius norms, from above. */
static bool norms(double *inverse, double *norm, const double *t, size_t m, const double *u, size_t n, size_t p)
{
    arb_mat_t A, At, G;
    arb_t sum;
    bool ok;

    arb_mat_init(A, (slong)m, (slong)n);
    arb_mat_init(At, (slong)n, (slong)m);
    arb_mat_init(G, (slong)n, (slong)n);
    arb_init(sum);
    collocation(A, t, u, p);
    arb_mat_transpose(At, A);
    arb_mat_mul(G, At, A, BITS);
    arb_mat_trace(sum, G, BITS);
    *norm = sqrt(arf_get_d(arb_midref(sum), ARF_RND_UP)) * (1 + 0x1p-40);
    ok = arb_mat_inv(G, G, BITS);
    arb_mat_trace(sum, G, BITS);
    *inverse = sqrt(arf_get_d(arb_midref(sum), ARF_RND_UP)) * (1 + 0x1p-40);
    arb_clear(sum);
    arb_mat_clear(A);
    arb_mat_clear(At);
    arb_mat_clear(G);
    return ok && *inverse < HUGE_VAL;
}

/* How far backward stable solvers may be: (1 + condition)^2 times their backward error (the number of entries they touch, in u; the basis functions'
 * own error is within it) times |A+| times the data; both views share a border, which may halve squares of the singular values, and corners moved to
 * the right make it greater by |A| times themselves. */
static double spread(const problem *c, const et_fit *f)
{
    double bound = 0, data = 0;

    for (size_t i = 0; i < c->nov; i++)
        data += c->data[i].x * c->data[i].x + c->data[i].y * c->data[i].y + c->data[i].z * c->data[i].z;
    data = 2 * sqrt(data);
    for (size_t w = 0; w < 2; w++) {
        const et_surface *v = &f->shell.view[w];
        double iu, iv, nu, nv;
        if (!norms(&iu, &nu, f->s[w], c->net.nx, v->u, v->nu, v->p) || !norms(&iv, &nv, f->r[w], c->net.ny, v->v, v->nv, v->q))
            return HUGE_VAL;
        const double inverse = sqrt(2) * iu * iv, norm = sqrt(2) * nu * nv;
        const double size = 64 * (double)((c->nov + 8) * (2 * v->nu * v->nv + 8)) * ET_UNIT;
        bound = fmax(bound, size * (1 + inverse * norm) * (1 + inverse * norm) * inverse * data * (1 + norm));
    }
    return bound;
}

verdict prop_exact_fit_solve_fast(gen *g)
{
    problem c;
    et_fit f, h;
    bool ok;

    draw_options(g, &c, 2, SIDE);
    draw_pillow(g, &c);
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return SKIP;
    h = f; /* its parameters and knots, but control points of its own */
    if (!gen_check(g, et_shell_copy(&h.shell, &f.shell) == ET_OK, "copy"))
        return FAIL;
    const double bound = spread(&c, &f);
    const et_status status = fit_solve(&h, c.data, c.nov, &c.options, NULL, NULL, NULL);
    gen_label(g, bound < 1e-6 ? "well conditioned" : bound < 1 ? "badly" : "hopeless");
    ok = gen_check(g, status == ET_OK || (status == ET_ERANK && bound > 1), "status %d", (int)status);
    for (size_t w = 0; ok && status == ET_OK && w < 2; w++)
        for (size_t at = 0; at < controls(&f); at++) {
            const double off = et_vec3_distance(f.shell.view[w].points[at], h.shell.view[w].points[at]);
            ok = gen_check(g, off <= bound, "view %zu, %zu: fast is off by %g, bound %g", w, at, off, bound) && ok;
        }
    et_shell_free(&h.shell);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}
