/* fit computed a second time from what linalg promises, bit for bit: the views by themselves, and glued by orthogonal reduction. */
#include "etalon/fit/fit.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include "fit/fit_parts.h"
#include "gen.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIDE = 9, NODES = SIDE * SIDE, CLASSES = 2 * NODES, BORDER = 4 * SIDE, TALL = 3 * BORDER };

typedef struct {
    et_doublenet net, control;
    et_fit_options options;
    et_vec3 data[CLASSES], D[2][NODES], P[2][NODES];
    double U[2][NODES], V[2][NODES]; /* dense: U[w][i*cx + a] */
} fitting;

static void draw(gen *g, fitting *f)
{
    et_fit_options *o = &f->options;

    *o = et_fit_defaults();
    f->net = (et_doublenet){gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)};
    o->control = f->control = (et_doublenet){gen_between(g, 2, f->net.nx), gen_between(g, 2, f->net.ny)};
    o->p = gen_between(g, 1, f->control.nx > 3 ? 3 : f->control.nx - 1);
    o->q = gen_between(g, 1, f->control.ny > 3 ? 3 : f->control.ny - 1);
    o->approach = (et_fit_approach)gen_upto(g, 2);
    o->corners = (et_fit_corners)gen_upto(g, 2);
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < f->net.nx; i++)
            for (size_t j = 0; j < f->net.ny; j++)
                f->data[et_doublenet_class(f->net, w, i, j) - 1] =
                    (et_vec3){(double)i + gen_real(g, 0, 0.5), (double)j + gen_real(g, 0, 0.5), (w == 0 ? -1 : 1) * gen_real(g, 0, 1)};
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < f->net.nx * f->net.ny; at++)
            f->D[w][at] = f->data[et_doublenet_class(f->net, w, at / f->net.ny, at % f->net.ny) - 1];
}

/* The basis functions at t, dense and banded. */
static void functions(double *N, double *a, size_t *start, const double *t, size_t m, const double *u, size_t n, size_t p)
{
    double work[64];

    memset(N, 0, m * n * sizeof *N);
    for (size_t i = 0; i < m; i++) {
        const size_t span = et_knots_span(u, n + p + 1, p, t[i]);
        et_basis_eval(a + i * (p + 1), u, n + p + 1, p, span, t[i], work, et_basis_work(p, 0));
        start[i] = span - p;
        memcpy(N + i * n + start[i], a + i * (p + 1), (p + 1) * sizeof *a);
    }
}

static void turn(et_vec3 *T, const et_vec3 *A, size_t m, size_t n)
{
    for (size_t at = 0; at < m * n; at++)
        T[at % n * m + at / n] = A[at];
}

static bool by_itself(fitting *f, const et_fit *fit, size_t w)
{
    const size_t mx = f->net.nx, my = f->net.ny, cx = f->control.nx, cy = f->control.ny, p = f->options.p, q = f->options.q;
    const et_surface *s = &fit->shell.view[w];
    double a[NODES];
    size_t start[SIDE], rank;
    et_vec3 X[NODES], T[NODES], Y[NODES];

    functions(f->U[w], a, start, fit->s[w], mx, s->u, cx, p);
    if (et_linalg_band_lsq(&X->x, &rank, a, start, mx, cx, p + 1, &f->D[w]->x, 3 * my, ET_LINALG_QR) != ET_OK)
        return false;
    turn(T, X, cx, my);
    functions(f->V[w], a, start, fit->r[w], my, s->v, cy, q);
    if (et_linalg_band_lsq(&Y->x, &rank, a, start, my, cy, q + 1, &T->x, 3 * cx, ET_LINALG_QR) != ET_OK)
        return false;
    turn(f->P[w], Y, cy, cx);
    return true;
}

/* ---- glued -------------------------------------------------------------------------------------------------------------------- */

typedef struct {
    size_t views, first;
    int fixed;
    double Ru[NODES], Rv[NODES];
    et_vec3 E[2 * NODES];
    size_t number[NODES], columns, rows;
    double A[TALL * BORDER];
    et_vec3 B[TALL], X[BORDER];
} glue;

static size_t ordered(size_t a, size_t n)
{
    const size_t last = n - 1;

    return a + 1 == n ? last : a + 1 == last ? 0 : a + 1;
}

/* R and the n first rows of Q'B for the inner rows of N, columns inner, first, last; B: m - 2 rows of k points. */
static bool reduced(double *R, et_vec3 *C, const double *N, size_t m, size_t n, const et_vec3 *B, size_t k)
{
    static double A[NODES];
    static et_vec3 padded[2 * NODES * SIDE];
    const size_t rows = m - 2 > n ? m - 2 : n;

    memset(A, 0, sizeof A);
    memset(padded, 0, sizeof padded);
    for (size_t i = 0; i + 2 < m; i++) {
        for (size_t a = 0; a < n; a++)
            A[i * n + a] = N[(i + 1) * n + ordered(a, n)];
        for (size_t x = 0; x < k; x++)
            padded[i * k + x] = B[i * k + x];
    }
    return et_linalg_qr(R, &C->x, A, rows, n, &padded->x, 3 * k) == ET_OK;
}

static bool reduction(glue *g, const fitting *f)
{
    static et_vec3 B[2 * NODES], C[2 * NODES], T[2 * NODES];
    const size_t mi = f->net.nx - 2, mj = f->net.ny - 2, cx = f->control.nx, wide = g->views * mj;

    for (size_t at = 0; at < mi * wide; at++)
        B[at] = f->D[g->first + at % wide / mj][(at / wide + 1) * f->net.ny + at % mj + 1];
    if (!reduced(g->Ru, C, f->U[g->first], f->net.nx, cx, B, wide))
        return false;
    for (size_t a = 0; a < cx; a++)
        for (size_t x = 0; x < wide; x++)
            T[(x % mj * g->views + x / mj) * cx + a] = C[a * wide + x];
    return reduced(g->Rv, g->E, f->V[g->first], f->net.ny, f->control.ny, T, g->views * cx);
}

static et_vec3 less(et_vec3 a, double x, et_vec3 b)
{
    return (et_vec3){a.x - x * b.x, a.y - x * b.y, a.z - x * b.z};
}

/* The corner of the data at a corner of the control net. */
static et_vec3 corner(const fitting *f, size_t at)
{
    return f->D[0][(at / f->control.ny ? (f->net.nx - 1) * f->net.ny : 0) + (at % f->control.ny ? f->net.ny - 1 : 0)];
}

static void term(glue *g, const fitting *f, size_t at, double x)
{
    const size_t i = at / f->control.ny, j = at % f->control.ny;

    if (!fit_on_border(f->control, i, j))
        return;
    if (g->fixed && fit_is_corner(f->control, i, j))
        g->B[g->rows] = less(g->B[g->rows], x, corner(f, at));
    else
        g->A[g->rows * g->columns + g->number[at]] += x;
}

static bool border(glue *g, fitting *f)
{
    const et_doublenet n = f->net, c = f->control;
    const double weight = sqrt((double)g->views);
    size_t rank;

    g->columns = g->rows = 0;
    for (size_t at = 0; at < c.nx * c.ny; at++)
        if (fit_on_border(c, at / c.ny, at % c.ny) && !(g->fixed && fit_is_corner(c, at / c.ny, at % c.ny)))
            g->number[at] = g->columns++;
    memset(g->A, 0, sizeof g->A);
    memset(g->B, 0, sizeof g->B);
    for (size_t at = 0; at < n.nx * n.ny; at++)
        if (fit_on_border(n, at / n.ny, at % n.ny)) {
            g->B[g->rows] = f->D[g->first][at];
            for (size_t k = 0; k < c.nx * c.ny; k++) {
                const double x = f->U[g->first][at / n.ny * c.nx + k / c.ny] * f->V[g->first][at % n.ny * c.ny + k % c.ny];
                if (x != 0)
                    term(g, f, k, x);
            }
            g->rows++;
        }
    for (size_t a = 0; a < c.nx; a++)
        for (size_t b = 0; b < c.ny; b++) {
            if (a + 2 < c.nx && b + 2 < c.ny)
                continue;
            for (size_t w = 0; w < g->views; w++)
                g->B[g->rows] = less(g->B[g->rows], -1,
                                     (et_vec3){g->E[(b * g->views + w) * c.nx + a].x / weight, g->E[(b * g->views + w) * c.nx + a].y / weight,
                                               g->E[(b * g->views + w) * c.nx + a].z / weight});
            for (size_t k = a; k < c.nx; k++)
                for (size_t l = b; l < c.ny; l++)
                    term(g, f, ordered(k, c.nx) * c.ny + ordered(l, c.ny), weight * g->Ru[a * c.nx + k] * g->Rv[b * c.ny + l]);
            g->rows++;
        }
    g->rows += et_doublenet_nor(c); /* rows of zeros, never fewer than columns */
    if (g->columns > 0 && et_linalg_lsq(&g->X->x, &rank, g->A, g->rows, g->columns, &g->B->x, 3, ET_LINALG_QR) != ET_OK)
        return false;
    for (size_t w = 0; w < g->views; w++)
        for (size_t at = 0; at < c.nx * c.ny; at++)
            if (g->fixed && fit_is_corner(c, at / c.ny, at % c.ny))
                f->P[g->first + w][at] = corner(f, at);
            else if (fit_on_border(c, at / c.ny, at % c.ny))
                f->P[g->first + w][at] = g->X[g->number[at]];
    return true;
}

/* R X = B of the leading m x m block of R (n x n). */
static bool triangle(et_vec3 *X, const double *R, size_t m, size_t n, const et_vec3 *B, size_t k)
{
    double A[NODES];
    size_t rank;

    for (size_t at = 0; at < m * m; at++)
        A[at] = R[at / m * n + at % m];
    return et_linalg_lsq(&X->x, &rank, A, m, m, &B->x, 3 * k, ET_LINALG_QR) == ET_OK;
}

static bool interior(const glue *g, fitting *f, size_t w)
{
    const size_t cx = f->control.nx, cy = f->control.ny, ci = cx - 2, cj = cy - 2;
    et_vec3 W[NODES], B[NODES], X[NODES], *P = f->P[g->first + w];

    for (size_t a = 0; a < ci; a++)
        for (size_t l = 0; l < cy; l++) {
            et_vec3 sum = {0, 0, 0};
            for (size_t k = a; k < cx; k++)
                if (k >= ci || l >= cj)
                    sum = less(sum, -g->Ru[a * cx + k], P[ordered(k, cx) * cy + ordered(l, cy)]);
            W[a * cy + l] = sum;
        }
    for (size_t a = 0; a < ci; a++)
        for (size_t b = 0; b < cj; b++) {
            et_vec3 e = g->E[(b * g->views + w) * cx + a];
            for (size_t l = b; l < cy; l++)
                e = less(e, g->Rv[b * cy + l], W[a * cy + l]);
            B[a * cj + b] = e;
        }
    if (!triangle(X, g->Ru, ci, cx, B, cj))
        return false;
    turn(B, X, ci, cj);
    if (!triangle(X, g->Rv, cj, cy, B, ci))
        return false;
    for (size_t at = 0; at < ci * cj; at++)
        P[(at % ci + 1) * cy + at / ci + 1] = X[at];
    return true;
}

static bool glued(fitting *f, const et_fit *fit, size_t first, size_t views, int fixed)
{
    static glue g;
    const size_t cx = f->control.nx, cy = f->control.ny;
    double a[NODES];
    size_t start[SIDE];
    bool ok;

    g.first = first;
    g.views = views;
    g.fixed = fixed;
    functions(f->U[first], a, start, fit->s[first], f->net.nx, fit->shell.view[first].u, cx, f->options.p);
    functions(f->V[first], a, start, fit->r[first], f->net.ny, fit->shell.view[first].v, cy, f->options.q);
    ok = reduction(&g, f) && border(&g, f);
    for (size_t w = 0; ok && w < views && cx > 2 && cy > 2; w++)
        ok = interior(&g, f, w);
    return ok;
}

static void closed(fitting *f, int fixed)
{
    for (size_t at = 0; at < f->control.nx * f->control.ny; at++) {
        et_vec3 *a = &f->P[0][at], *b = &f->P[1][at];
        if (!fit_on_border(f->control, at / f->control.ny, at % f->control.ny))
            continue;
        *a = (et_vec3){(a->x + b->x) / 2, (a->y + b->y) / 2, (a->z + b->z) / 2};
        if (fixed && fit_is_corner(f->control, at / f->control.ny, at % f->control.ny))
            *a = corner(f, at);
        *b = *a;
    }
}

static bool second_time(fitting *f, const et_fit *fit)
{
    const et_fit_options *o = &f->options;
    const int fixed = o->corners == ET_CORNERS_INTERPOLATED || (o->corners == ET_CORNERS_DEFAULT && o->approach == ET_FIT_IMPROVED);
    bool ok = true;

    if (o->approach == ET_FIT_JOINT)
        return glued(f, fit, 0, 2, fixed);
    for (size_t w = 0; ok && w < 2; w++)
        ok = o->approach == ET_FIT_CONVENTIONAL && fixed ? glued(f, fit, w, 1, 1) : by_itself(f, fit, w);
    if (ok && o->approach == ET_FIT_IMPROVED)
        closed(f, fixed);
    return ok;
}

/* One case in 3. */
verdict prop_fit_make_bits(gen *g)
{
    static fitting f;
    et_fit fit;
    bool ok;

    draw(g, &f);
    if (et_fit_make(&fit, f.data, et_doublenet_nov(f.net), f.net, &f.options, NULL) != ET_OK)
        return SKIP;
    gen_label(g, et_fit_name(f.options.approach));
    ok = gen_check(g, second_time(&f, &fit), "not solved a second time");
    for (size_t w = 0; ok && w < 2; w++)
        for (size_t at = 0; ok && at < 3 * f.control.nx * f.control.ny; at++) {
            const double got = (&fit.shell.view[w].points[at / 3].x)[at % 3], want = (&f.P[w][at / 3].x)[at % 3];
            ok = gen_check(g, got == want, "%s, view %zu, control point %zu: %a, a second time %a", et_fit_name(f.options.approach), w, at / 3, got,
                           want);
        }
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

/* By tiles and without: the same. */
/* One case in 20. */
verdict prop_fit_make_transposed(gen *g)
{
    enum { LONG = 50 };
    static et_vec3 A[LONG * LONG], T[LONG * LONG + 1];
    const size_t m = gen_between(g, 1, LONG), n = gen_between(g, 1, LONG);

    for (size_t at = 0; at < m * n; at++)
        A[at] = (et_vec3){(double)(at / n), (double)(at % n), 1};
    memset(T, 0, sizeof T);
    fit_transpose(T, A, m, n);
    for (size_t at = 0; at < m * n; at++)
        if (!gen_check(g, T[at].x == (double)(at % m) && T[at].y == (double)(at / m) && T[at].z == 1, "%zu x %zu: at %zu", m, n, at))
            return FAIL;
    return gen_check(g, T[m * n].z == 0, "beyond the end") ? PASS : FAIL;
}
