/* exact, golden rows of functions that have no exact twin: volumes, least squares, triangular factors and the objective once more, in FLINT's
 * rationals and balls, by other ways than the generators'. */
#include "etalon/exact/exact.h"
#include "etalon/net/doublenet.h"
#include "exact/exact_parts.h"
#include "golden.h"
#include <arb_mat.h>
#include <flint/fmpq_mat.h>
#include <stdlib.h>
#include <string.h>

/* M = the numbers of the row from `at` on, line by line. */
static void read_matrix(fmpq_mat_t M, const row *r, size_t at)
{
    for (slong i = 0; i < fmpq_mat_nrows(M); i++)
        for (slong j = 0; j < fmpq_mat_ncols(M); j++)
            exact_set(fmpq_mat_entry(M, i, j), row_real(r, at++));
}

/* ---- volumes ---- */

static void minor(fmpq_t d, const fmpq *a, const fmpq *b, size_t i, size_t j)
{
    fmpq_t t;

    fmpq_init(t);
    fmpq_mul(d, a + i, b + j);
    fmpq_mul(t, a + j, b + i);
    fmpq_sub(d, d, t);
    fmpq_clear(t);
}

/* Rows: vertices triangles, coordinates, indices; wanted: the volume, a sixth of the sum of determinants. */
verdict true_tessellation_volume(const row *r)
{
    const size_t n = row_size(r, 0), m = row_size(r, 1);
    fmpq *x = _fmpq_vec_init((slong)(3 * n));
    fmpq_t sum, d;
    bool ok = r->nargs == 2 + 3 * (n + m);

    fmpq_init(sum);
    fmpq_init(d);
    for (size_t k = 0; ok && k < 3 * n; k++)
        exact_set(x + k, row_real(r, 2 + k));
    for (size_t t = 0; ok && t < m; t++) {
        const fmpq *v[3];
        for (size_t k = 0; k < 3; k++) {
            const size_t at = row_size(r, 2 + 3 * (n + t) + k);
            ok = ok && at < n;
            v[k] = x + 3 * (at < n ? at : 0);
        }
        for (size_t c = 0; c < 3; c++) {
            minor(d, v[1], v[2], (c + 1) % 3, (c + 2) % 3);
            fmpq_addmul(sum, v[0] + c, d);
        }
    }
    fmpq_div_2exp(sum, sum, 1);
    fmpq_set_si(d, 1, 3);
    fmpq_mul(sum, sum, d);
    ok = row_is(r, 0, exact_round(sum)) && ok;
    fmpq_clear(sum);
    fmpq_clear(d);
    _fmpq_vec_clear(x, (slong)(3 * n));
    return ok ? PASS : FAIL;
}

/* ---- least squares ---- */

/* A basis of A's null space as columns of N (n x (n - rank)), from the echelon form E of A. */
static void null_space(fmpq_mat_t N, const fmpq_mat_t E, slong rank)
{
    const slong n = fmpq_mat_ncols(E);
    slong free_at = 0;

    for (slong c = 0, i = 0; c < n; c++) {
        if (i < rank && !fmpq_is_zero(fmpq_mat_entry(E, i, c))) {
            i++;                                        /* a pivot's column */
            continue;
        }
        fmpq_one(fmpq_mat_entry(N, c, free_at));
        for (slong k = 0, row_of = 0; k < c && row_of < i; k++) {
            if (fmpq_is_zero(fmpq_mat_entry(E, row_of, k)))
                continue;
            fmpq_neg(fmpq_mat_entry(N, k, free_at), fmpq_mat_entry(E, row_of, c));
            row_of++;
        }
        free_at++;
    }
}

/* X -= N (N'N)^-1 N'X: what of X lies in the null space goes. */
static void project(fmpq_mat_t X, const fmpq_mat_t N)
{
    const slong n = fmpq_mat_nrows(N), f = fmpq_mat_ncols(N), k = fmpq_mat_ncols(X);
    fmpq_mat_t T, G, H, Y;

    fmpq_mat_init(T, f, n);
    fmpq_mat_init(G, f, f);
    fmpq_mat_init(H, f, k);
    fmpq_mat_init(Y, n, k);
    fmpq_mat_transpose(T, N);
    fmpq_mat_mul(G, T, N);
    fmpq_mat_mul(H, T, X);
    if (f > 0 && fmpq_mat_solve(H, G, H)) {
        fmpq_mat_mul(Y, N, H);
        fmpq_mat_sub(X, X, Y);
    }
    fmpq_mat_clear(T);
    fmpq_mat_clear(G);
    fmpq_mat_clear(H);
    fmpq_mat_clear(Y);
}

/* A solution of A'A X = A'B read off the echelon form of both sides. */
static void particular(fmpq_mat_t X, const fmpq_mat_t A, const fmpq_mat_t B)
{
    const slong m = fmpq_mat_nrows(A), n = fmpq_mat_ncols(A), k = fmpq_mat_ncols(B);
    fmpq_mat_t T, G, H, both;

    fmpq_mat_init(T, n, m);
    fmpq_mat_init(G, n, n);
    fmpq_mat_init(H, n, k);
    fmpq_mat_init(both, n, n + k);
    fmpq_mat_transpose(T, A);
    fmpq_mat_mul(G, T, A);
    fmpq_mat_mul(H, T, B);
    fmpq_mat_concat_horizontal(both, G, H);
    fmpq_mat_rref(both, both);
    fmpq_mat_zero(X);
    for (slong c = 0, i = 0; c < n && i < n; c++) {
        if (fmpq_is_zero(fmpq_mat_entry(both, i, c)))
            continue;
        for (slong j = 0; j < k; j++)
            fmpq_set(fmpq_mat_entry(X, c, j), fmpq_mat_entry(both, i, n + j));
        i++;
    }
    fmpq_mat_clear(T);
    fmpq_mat_clear(G);
    fmpq_mat_clear(H);
    fmpq_mat_clear(both);
}

/* Wanted: the rank, then, unless it stands alone, the least-squares solution of least norm. */
static bool solved(const row *r, const fmpq_mat_t A, const fmpq_mat_t B)
{
    const slong m = fmpq_mat_nrows(A), n = fmpq_mat_ncols(A), k = fmpq_mat_ncols(B);
    fmpq_mat_t E, N, X;

    fmpq_mat_init(E, m, n);
    const slong rank = fmpq_mat_rref(E, A);
    fmpq_mat_init(N, n, n - rank);
    fmpq_mat_init(X, n, k);
    null_space(N, E, rank);
    particular(X, A, B);
    project(X, N);
    bool ok = row_is_size(r, 0, (size_t)rank) && (r->nwant == 1 || r->nwant == 1 + (size_t)(n * k));
    for (slong i = 0; r->nwant > 1 && i < n * k; i++)
        ok = row_is(r, 1 + (size_t)i, exact_round(fmpq_mat_entry(X, i / k, i % k))) && ok;
    fmpq_mat_clear(E);
    fmpq_mat_clear(N);
    fmpq_mat_clear(X);
    return ok;
}

/* Rows: method m n k A B. */
verdict true_linalg_lsq(const row *r)
{
    const size_t m = row_size(r, 1), n = row_size(r, 2), k = row_size(r, 3);
    fmpq_mat_t A, B;

    if (r->nargs != 4 + m * (n + k))
        return FAIL;
    fmpq_mat_init(A, (slong)m, (slong)n);
    fmpq_mat_init(B, (slong)m, (slong)k);
    read_matrix(A, r, 4);
    read_matrix(B, r, 4 + m * n);
    const bool ok = solved(r, A, B);
    fmpq_mat_clear(A);
    fmpq_mat_clear(B);
    return ok ? PASS : FAIL;
}

/* Rows: method m n w k, starts, bands, B. */
verdict true_linalg_band_lsq(const row *r)
{
    const size_t m = row_size(r, 1), n = row_size(r, 2), w = row_size(r, 3), k = row_size(r, 4);
    fmpq_mat_t A, B;
    bool ok = r->nargs == 5 + m * (1 + w + k);

    if (!ok)
        return FAIL;
    fmpq_mat_init(A, (slong)m, (slong)n);
    fmpq_mat_init(B, (slong)m, (slong)k);
    for (size_t i = 0; i < m; i++) {
        const size_t start = row_size(r, 5 + i);
        ok = ok && start + w <= n;
        for (size_t j = 0; ok && j < w; j++)
            exact_set(fmpq_mat_entry(A, (slong)i, (slong)(start + j)), row_real(r, 5 + m + i * w + j));
    }
    read_matrix(B, r, 5 + m + m * w);
    ok = ok && solved(r, A, B);
    fmpq_mat_clear(A);
    fmpq_mat_clear(B);
    return ok ? PASS : FAIL;
}

/* ---- the triangular factor ---- */

/* Balls of R, the transposed Cholesky factor of A'A, and of C = R^-T A'B; false where they do not round yet, their roundings in x else. */
static bool factor(double *x, const fmpq_mat_t G, const fmpq_mat_t H, slong bits)
{
    const slong n = fmpq_mat_nrows(G), k = fmpq_mat_ncols(H);
    arb_mat_t g, h;
    bool ok;

    arb_mat_init(g, n, n);
    arb_mat_init(h, n, k);
    arb_mat_set_fmpq_mat(g, G, bits);
    arb_mat_set_fmpq_mat(h, H, bits);
    ok = arb_mat_cho(g, g, bits);
    if (ok)
        arb_mat_solve_tril(h, g, h, 0, bits);
    for (slong i = 0; ok && i < n; i++) {
        for (slong j = 0; ok && j < n; j++)
            ok = exact_round_ball(&x[i * n + j], arb_mat_entry(g, j, i));
        for (slong j = 0; ok && j < k; j++)
            ok = exact_round_ball(&x[n * n + i * k + j], arb_mat_entry(h, i, j));
    }
    arb_mat_clear(g);
    arb_mat_clear(h);
    return ok;
}

/* Rows: m n k A B; wanted: R with a positive diagonal, and the first n rows of Q'B. */
verdict true_linalg_qr(const row *r)
{
    const size_t m = row_size(r, 0), n = row_size(r, 1), k = row_size(r, 2);
    double x[512];
    fmpq_mat_t A, B, T, G, H;
    bool ok = false;

    if (r->nargs != 3 + m * (n + k) || r->nwant != n * (n + k) || r->nwant > 512)
        return FAIL;
    fmpq_mat_init(A, (slong)m, (slong)n);
    fmpq_mat_init(B, (slong)m, (slong)k);
    fmpq_mat_init(T, (slong)n, (slong)m);
    fmpq_mat_init(G, (slong)n, (slong)n);
    fmpq_mat_init(H, (slong)n, (slong)k);
    read_matrix(A, r, 3);
    read_matrix(B, r, 3 + m * n);
    fmpq_mat_transpose(T, A);
    fmpq_mat_mul(G, T, A);
    fmpq_mat_mul(H, T, B);
    for (slong bits = EXACT_BITS; !ok && bits <= 8192; bits *= 2)
        ok = factor(x, G, H, bits);
    for (size_t i = 0; ok && i < r->nwant; i++)
        ok = row_is(r, i, x[i]);
    fmpq_mat_clear(A);
    fmpq_mat_clear(B);
    fmpq_mat_clear(T);
    fmpq_mat_clear(G);
    fmpq_mat_clear(H);
    return ok ? PASS : FAIL;
}

/* ---- the objective ---- */

static void real_list(double *x, size_t n, const row *r, size_t *at)
{
    for (size_t i = 0; i < n; i++)
        x[i] = row_real(r, (*at)++);
}

/* A fit with storage for everything, knots and parameters from the row. */
static bool begin(et_fit *f, const row *r, size_t *at)
{
    const size_t p = row_size(r, 0), q = row_size(r, 1), nu = row_size(r, 2), nv = row_size(r, 3), nx = row_size(r, 4), ny = row_size(r, 5);

    memset(f, 0, sizeof *f);
    f->data = (et_doublenet){nx, ny};
    if (nx > 64 || ny > 64 || et_shell_new(&f->shell, p, q, (et_doublenet){nu, nv}, 0) != ET_OK)
        return false;
    for (size_t w = 0; w < 2; w++) {
        *at = 6;
        f->s[w] = calloc(nx, sizeof *f->s[w]);
        f->r[w] = calloc(ny, sizeof *f->r[w]);
        if (!f->s[w] || !f->r[w])
            return false;
        real_list(f->shell.view[w].u, nu + p + 1, r, at);
        real_list(f->shell.view[w].v, nv + q + 1, r, at);
        real_list(f->s[w], nx, r, at);
        real_list(f->r[w], ny, r, at);
    }
    return true;
}

/* The control points of both views from those of the classes. */
static void place(et_fit *f, const et_vec3 *P)
{
    const et_doublenet control = {f->shell.view[0].nu, f->shell.view[0].nv};

    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < control.nx; i++)
            for (size_t j = 0; j < control.ny; j++)
                f->shell.view[w].points[i * control.ny + j] = P[et_doublenet_class(control, w, i, j) - 1];
}

/* Rows: p q nu nv nx ny, knots u v, parameters s r, data, candidates; wanted: each candidate's sum of distances over the classes. */
verdict true_objective_eval(const row *r)
{
    et_fit f;
    size_t at = 0;
    bool ok = begin(&f, r, &at);

    if (!ok) {
        et_fit_free(&f);
        return FAIL;
    }
    const size_t nov = et_doublenet_nov(f.data), n = et_doublenet_nov((et_doublenet){f.shell.view[0].nu, f.shell.view[0].nv});
    et_vec3 *data = calloc(nov, sizeof *data), *P = calloc(n, sizeof *P);
    ok = data && P && r->nargs == at + 3 * nov + 3 * n * r->nwant;
    if (ok)
        real_list(&data[0].x, 3 * nov, r, &at);
    for (size_t w = 0; ok && w < r->nwant; w++) {
        et_fit_error e;
        real_list(&P[0].x, 3 * n, r, &at);
        place(&f, P);
        ok = et_exact_fit_measure(&e, NULL, nov, &f, data, NULL) == ET_OK && row_is(r, w, e.nov);
    }
    free(data);
    free(P);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}
