#include "etalon/fit/fit.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* The linear algebra sees points as three columns of doubles. */
typedef char et_fit_assert_vec3[sizeof(et_vec3) == 3 * sizeof(double) ? 1 : -1];

static const char *const names[] = {"conventional", "improved", "joint"};
static const char *const view_names[] = {"bottom view", "top view"};

const char *et_fit_name(et_fit_approach approach)
{
    return (unsigned)approach < sizeof names / sizeof *names ? names[approach] : NULL;
}

et_fit_options et_fit_defaults(void)
{
    return (et_fit_options){ET_FIT_IMPROVED, ET_PARAM_CHORD, ET_KNOTRULE_PIEGL, ET_LINALG_QR, ET_CORNERS_DEFAULT, 3, 3, {12, 12}};
}

/* ---- data ---- */

/* The grid D[i*ny + j] of one view.  The bottom's classes are numbered in just that order. */
static void view_grid(et_vec3 *D, const et_vec3 *data, et_doublenet net, size_t view)
{
    for (size_t i = 0; i < net.nx; i++)
        for (size_t j = 0; j < net.ny; j++)
            D[i * net.ny + j] = data[et_doublenet_class(net, view, i, j) - 1];
}

static et_vec3 corner(const et_vec3 *D, et_doublenet net, int far_u, int far_v)
{
    return D[(far_u ? (net.nx - 1) * net.ny : 0) + (far_v ? net.ny - 1 : 0)];
}

/* ---- parameters ---- */

static et_status allocate_parameters(et_fit *fit, et_doublenet net)
{
    memset(fit, 0, sizeof *fit);
    fit->data = net;
    for (size_t w = 0; w < 2; w++) {
        fit->s[w] = et_size_array(net.nx, sizeof(double));
        fit->r[w] = et_size_array(net.ny, sizeof(double));
        if (fit->s[w] == NULL || fit->r[w] == NULL)
            return ET_ENOMEM;
    }
    return ET_OK;
}

et_status et_fit_parameters(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, et_fit_approach approach, et_param_method method)
{
    et_fit made;
    et_vec3 *D;
    et_status status;

    if (!et_doublenet_valid(net) || nov != et_doublenet_nov(net) || et_fit_name(approach) == NULL || et_param_name(method) == NULL)
        return ET_EINVAL;
    status = allocate_parameters(&made, net);
    D = et_size_array(net.nx * net.ny, sizeof *D);
    if (D == NULL)
        status = ET_ENOMEM;
    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        size_t flat = 0;
        view_grid(D, data, net, w);
        status = et_param_grid(made.s[w], net.nx, made.r[w], net.ny, &flat, D, method);
        made.flat += flat;
    }
    free(D);
    if (status != ET_OK) {
        et_fit_free(&made);
        return status;
    }
    if (approach != ET_FIT_CONVENTIONAL) {
        et_param_standardise(made.s[0], made.s[1], net.nx);
        et_param_standardise(made.r[0], made.r[1], net.ny);
    }
    *fit = made;
    return ET_OK;
}

void et_fit_free(et_fit *fit)
{
    et_shell_free(&fit->shell);
    for (size_t w = 0; w < 2; w++) {
        free(fit->s[w]);
        free(fit->r[w]);
    }
    memset(fit, 0, sizeof *fit);
}

/* ---- collocation: the basis functions at the parameters, by rows of p + 1 entries ---- */

typedef struct {
    size_t m, n, w; /* parameters, control points, p + 1 */
    double *a;      /* a[i*w + k] = N_{start[i]+k}(t_i) */
    size_t *start;
} collocation;

static void collocation_free(collocation *N)
{
    free(N->a);
    free(N->start);
    memset(N, 0, sizeof *N);
}

static et_status collocate(collocation *N, const double *t, size_t m, const double *u, size_t n, size_t p)
{
    const size_t nwork = et_basis_work(p, 0);
    double *work = et_size_array(nwork, sizeof *work);
    size_t entries;

    *N = (collocation){m, n, p + 1, NULL, NULL};
    if (et_size_mul(&entries, m, p + 1) == ET_OK) {
        N->a = et_size_array(entries, sizeof *N->a);
        N->start = et_size_array(m, sizeof *N->start);
    }
    if (work == NULL || N->a == NULL || N->start == NULL) {
        free(work);
        collocation_free(N);
        return ET_ENOMEM;
    }
    for (size_t i = 0; i < m; i++) {
        const size_t span = et_knots_span(u, n + p + 1, p, t[i]);
        N->start[i] = span - p;
        et_basis_eval(N->a + i * N->w, u, n + p + 1, p, span, t[i], work, nwork);
    }
    free(work);
    return ET_OK;
}

static double entry(const collocation *N, size_t i, size_t c)
{
    return c < N->start[i] || c >= N->start[i] + N->w ? 0 : N->a[i * N->w + c - N->start[i]];
}

/* ---- a view by itself: P = Nu^+ D (Nv^+)' ---- */

/* T[j*m + i] = A[i*n + j], by tiles that fit the first cache. */
static void transpose(et_vec3 *T, const et_vec3 *A, size_t m, size_t n)
{
    enum { TILE = 16 };

    for (size_t i0 = 0; i0 < m; i0 += TILE)
        for (size_t j0 = 0; j0 < n; j0 += TILE)
            for (size_t i = i0; i < m && i < i0 + TILE; i++)
                for (size_t j = j0; j < n && j < j0 + TILE; j++)
                    T[j * m + i] = A[i * n + j];
}

static et_status solve_direction(et_vec3 *X, const collocation *N, const et_vec3 *B, size_t columns, const char *where, const char *direction,
                                 et_linalg_method method, et_message *message)
{
    size_t rank = 0, k;
    et_status status = et_size_mul(&k, columns, 3);

    if (status == ET_OK)
        status = et_linalg_band_lsq(&X->x, &rank, N->a, N->start, N->m, N->n, N->w, &B->x, k, method);
    if (status == ET_ERANK)
        return et_status_fail(message, status, "%s, direction %s: the %zu parameters determine only %zu of %zu control points", where, direction,
                              N->m, rank, N->n);
    return status == ET_OK ? ET_OK : et_status_fail(message, status, "%s, direction %s: %s", where, direction, et_status_text(status));
}

static et_status solve_view(et_vec3 *P, const collocation *U, const collocation *V, const et_vec3 *D, const char *where, et_linalg_method method,
                            et_message *message)
{
    et_vec3 *X = et_size_array(U->n * V->m, sizeof *X), *T = et_size_array(U->n * V->m, sizeof *T), *Y = et_size_array(U->n * V->n, sizeof *Y);
    et_status status = ET_ENOMEM;

    if (X != NULL && T != NULL && Y != NULL)
        status = solve_direction(X, U, D, V->m, where, "u", method, message);
    if (status == ET_OK) {
        transpose(T, X, U->n, V->m);
        status = solve_direction(Y, V, T, U->n, where, "v", method, message);
    }
    if (status == ET_OK)
        transpose(P, Y, V->n, U->n);
    free(X);
    free(T);
    free(Y);
    return status;
}

/* ---- views glued along their border, corners free or fixed ----
 *
 * Knots are clamped, so border data depend on border control points alone.  With the columns of Nu ordered (interior, first, last) and Nu = Qu Ru
 * over the interior data rows, likewise Nv, the interior data ask for Ru P Rv' = Qu' D Qv: rows whose index in u or v is among the last two hold
 * border control points only and join the border data in one small least-squares problem; the others then give each view's interior exactly.
 */
typedef struct {
    size_t views; /* 1 or 2; two share their border and their collocation */
    int fixed;    /* corners stand at the data's corners */
    et_doublenet data, control;
    const collocation *U, *V;
    const et_vec3 *D[2];
    et_vec3 *P[2];
    const char *where;
} glued;

#define FIXED SIZE_MAX
#define INTERIOR (SIZE_MAX - 1)

static int on_border(et_doublenet net, size_t i, size_t j)
{
    return i == 0 || i == net.nx - 1 || j == 0 || j == net.ny - 1;
}

static int is_corner(et_doublenet net, size_t i, size_t j)
{
    return (i == 0 || i == net.nx - 1) && (j == 0 || j == net.ny - 1);
}

/* number[w*cx*cy + i*cy + j]: the unknown of a node, FIXED, or (unless all are wanted) INTERIOR.  Returns how many unknowns there are. */
static size_t number_unknowns(size_t *number, const glued *g, int all)
{
    const et_doublenet c = g->control;
    size_t count = 0;

    for (size_t w = 0; w < g->views; w++)
        for (size_t i = 0; i < c.nx; i++)
            for (size_t j = 0; j < c.ny; j++) {
                const size_t at = i * c.ny + j;
                if (g->fixed && is_corner(c, i, j))
                    number[w * c.nx * c.ny + at] = FIXED;
                else if (on_border(c, i, j))
                    number[w * c.nx * c.ny + at] = w == 0 ? count++ : number[at];
                else
                    number[w * c.nx * c.ny + at] = all ? count++ : INTERIOR;
            }
    return count;
}

/* A dense least-squares problem in the numbered unknowns. */
typedef struct {
    size_t rows, columns;
    double *A;
    et_vec3 *B, *X;
    size_t *number;
} dense;

static void dense_free(dense *d)
{
    free(d->A);
    free(d->B);
    free(d->X);
    free(d->number);
}

static et_status dense_new(dense *d, const glued *g, size_t rows, int all)
{
    size_t entries;

    memset(d, 0, sizeof *d);
    d->number = et_size_array(g->views * g->control.nx * g->control.ny, sizeof *d->number);
    if (d->number == NULL)
        return ET_ENOMEM;
    d->columns = number_unknowns(d->number, g, all);
    d->rows = rows;
    if (et_size_mul(&entries, d->rows, d->columns) == ET_OK)
        d->A = et_size_array(entries, sizeof *d->A);
    d->B = et_size_array(d->rows, sizeof *d->B);
    d->X = et_size_array(d->columns, sizeof *d->X);
    if (d->A != NULL && d->B != NULL && d->X != NULL)
        return ET_OK;
    dense_free(d);
    return ET_ENOMEM;
}

/* The row's coefficient of control point (i, j) of a view; a fixed one goes to the right-hand side. */
static void add_term(dense *d, size_t row, const glued *g, size_t w, size_t i, size_t j, double x)
{
    const et_doublenet c = g->control;
    const size_t k = d->number[(w * c.nx + i) * c.ny + j];

    if (k == FIXED) {
        const et_vec3 P = corner(g->D[0], g->data, i != 0, j != 0);
        d->B[row].x -= x * P.x;
        d->B[row].y -= x * P.y;
        d->B[row].z -= x * P.z;
    } else if (k != INTERIOR) {
        d->A[row * d->columns + k] += x;
    }
}

static void add_data_row(dense *d, size_t row, const glued *g, size_t w, size_t i, size_t j)
{
    const size_t c = g->U->start[i], e = g->V->start[j];

    d->B[row] = g->D[w][i * g->data.ny + j];
    for (size_t k = 0; k < g->U->w; k++)
        for (size_t l = 0; l < g->V->w; l++) {
            const double x = g->U->a[i * g->U->w + k] * g->V->a[j * g->V->w + l];
            if (x != 0)
                add_term(d, row, g, w, c + k, e + l, x);
        }
}

static et_status dense_solve(dense *d, const glued *g, const char *what, et_linalg_method method, et_message *message)
{
    size_t rank = 0;
    et_status status = ET_OK;

    if (d->columns > 0)
        status = et_linalg_lsq(&d->X->x, &rank, d->A, d->rows, d->columns, &d->B->x, 3, method);
    if (status == ET_ERANK)
        return et_status_fail(message, status, "%s: the data determine only %zu of %zu %s control points", g->where, rank, d->columns, what);
    return status == ET_OK ? ET_OK : et_status_fail(message, status, "%s: %s", g->where, et_status_text(status));
}

/* Every numbered or fixed node gets its point, in both views the same. */
static void dense_deliver(const dense *d, const glued *g)
{
    const et_doublenet c = g->control;

    for (size_t w = 0; w < g->views; w++)
        for (size_t at = 0; at < c.nx * c.ny; at++) {
            const size_t k = d->number[w * c.nx * c.ny + at];
            if (k == FIXED)
                g->P[w][at] = corner(g->D[0], g->data, at / c.ny != 0, at % c.ny != 0);
            else if (k != INTERIOR)
                g->P[w][at] = d->X[k];
        }
}

/* All unknowns at once: NOV rows and columns (of a double net, or of one view). */
static et_status solve_glued_dense(const glued *g, et_linalg_method method, et_message *message)
{
    const et_doublenet n = g->data;
    size_t row = 0;
    dense d;
    et_status status = dense_new(&d, g, g->views == 2 ? et_doublenet_nov(n) : n.nx * n.ny, 1);

    if (status != ET_OK)
        return et_status_fail(message, status, "%s: no memory for a dense system; use qr", g->where);
    for (size_t w = 0; w < g->views; w++)
        for (size_t i = 0; i < n.nx; i++)
            for (size_t j = 0; j < n.ny; j++)
                if (w == 0 || !on_border(n, i, j))
                    add_data_row(&d, row++, g, w, i, j);
    status = dense_solve(&d, g, "", method, message);
    if (status == ET_OK)
        dense_deliver(&d, g);
    dense_free(&d);
    return status;
}

/* The control index of column a in the order (interior, first, last). */
static size_t place(size_t a, size_t n)
{
    return a + 2 < n ? a + 1 : a + 2 == n ? 0 : n - 1;
}

/* The interior rows of N with reordered columns, padded by zero rows to at least n. */
static double *interior_rows(const collocation *N, size_t *rows)
{
    double *A;
    size_t entries;

    *rows = N->m - 2 > N->n ? N->m - 2 : N->n;
    if (et_size_mul(&entries, *rows, N->n) != ET_OK)
        return NULL;
    A = et_size_array(entries, sizeof *A);
    if (A != NULL)
        for (size_t i = 1; i + 1 < N->m; i++)
            for (size_t a = 0; a < N->n; a++)
                A[(i - 1) * N->n + a] = entry(N, i, place(a, N->n));
    return A;
}

/* One direction of the reduction: R of the interior rows of N, and C = Q'B for B of m - 2 rows of `columns` points. */
static et_status reduce_direction(double *R, et_vec3 *C, const collocation *N, const et_vec3 *B, size_t columns)
{
    size_t rows;
    double *A = interior_rows(N, &rows);
    et_vec3 *padded = et_size_array(rows * columns, sizeof *padded);
    et_status status = ET_ENOMEM;

    if (A != NULL && padded != NULL) {
        if (columns > 0 && N->m > 2)
            memcpy(padded, B, (N->m - 2) * columns * sizeof *B);
        status = et_linalg_qr(R, &C->x, A, rows, N->n, &padded->x, 3 * columns);
    }
    free(A);
    free(padded);
    return status;
}

typedef struct {
    double *Ru, *Rv; /* cx x cx, cy x cy, columns (interior, first, last) */
    et_vec3 *E;      /* E[(b*views + w)*cx + a] = (Qu' D_w Qv)(a, b) */
} reduction;

static void reduction_free(reduction *r)
{
    free(r->Ru);
    free(r->Rv);
    free(r->E);
}

static et_status reduction_fill(reduction *r, const glued *g, et_vec3 *B, et_vec3 *C)
{
    const size_t mi = g->data.nx - 2, mj = g->data.ny - 2, cx = g->control.nx, wide = g->views * mj;
    et_vec3 *T = B;
    et_status status;

    for (size_t i = 0; i < mi; i++)
        for (size_t w = 0; w < g->views; w++)
            for (size_t j = 0; j < mj; j++)
                B[i * wide + w * mj + j] = g->D[w][(i + 1) * g->data.ny + j + 1];
    status = reduce_direction(r->Ru, C, g->U, B, wide);
    if (status != ET_OK)
        return status;
    for (size_t j = 0; j < mj; j++)
        for (size_t w = 0; w < g->views; w++)
            for (size_t a = 0; a < cx; a++)
                T[(j * g->views + w) * cx + a] = C[a * wide + w * mj + j];
    return reduce_direction(r->Rv, r->E, g->V, T, g->views * cx);
}

static et_status reduction_new(reduction *r, const glued *g)
{
    const size_t mi = g->data.nx - 2, mj = g->data.ny - 2, cx = g->control.nx, cy = g->control.ny, taller = mi > cx ? mi : cx;
    et_vec3 *B = et_size_array(g->views * mj * taller, sizeof *B), *C = et_size_array(g->views * mj * cx, sizeof *C);
    et_status status = ET_ENOMEM;

    r->Ru = et_size_array(cx * cx, sizeof *r->Ru);
    r->Rv = et_size_array(cy * cy, sizeof *r->Rv);
    r->E = et_size_array(g->views * cx * cy, sizeof *r->E);
    if (r->Ru != NULL && r->Rv != NULL && r->E != NULL && B != NULL && C != NULL)
        status = reduction_fill(r, g, B, C);
    free(B);
    free(C);
    if (status != ET_OK)
        reduction_free(r);
    return status;
}

/* Row (a, b) of Ru P Rv' = E, of all views at once: with equal left sides, k rows are one row sqrt(k) times as heavy against the mean. */
static void add_reduced_row(dense *d, size_t row, const glued *g, const reduction *r, size_t a, size_t b)
{
    const size_t cx = g->control.nx, cy = g->control.ny;
    const double weight = sqrt((double)g->views);

    for (size_t w = 0; w < g->views; w++) {
        const et_vec3 e = r->E[(b * g->views + w) * cx + a];
        d->B[row].x += e.x / weight;
        d->B[row].y += e.y / weight;
        d->B[row].z += e.z / weight;
    }
    for (size_t k = a; k < cx; k++)
        for (size_t l = b; l < cy; l++)
            add_term(d, row, g, 0, place(k, cx), place(l, cy), weight * r->Ru[a * cx + k] * r->Rv[b * cy + l]);
}

static et_status solve_border(const glued *g, const reduction *r, et_message *message)
{
    const et_doublenet n = g->data, c = g->control;
    size_t row = 0;
    dense d;
    et_status status = dense_new(&d, g, et_doublenet_nor(n) + et_doublenet_nor(c) + 2 * c.nx + 2 * c.ny - 4, 0);

    if (status != ET_OK)
        return et_status_fail(message, status, "%s: no memory for the border's system", g->where);
    for (size_t i = 0; i < n.nx; i++)
        for (size_t j = 0; j < n.ny; j++)
            if (on_border(n, i, j))
                add_data_row(&d, row++, g, 0, i, j);
    for (size_t a = 0; a < c.nx; a++)
        for (size_t b = 0; b < c.ny; b++)
            if (a + 2 >= c.nx || b + 2 >= c.ny)
                add_reduced_row(&d, row++, g, r, a, b);
    status = dense_solve(&d, g, "border", ET_LINALG_QR, message);
    if (status == ET_OK)
        dense_deliver(&d, g);
    dense_free(&d);
    return status;
}

/* B (ci x cj) = E - Ru P Rv' over the border control points of a view. */
static et_status subtract_border(et_vec3 *B, const glued *g, const reduction *r, size_t w)
{
    const size_t cx = g->control.nx, cy = g->control.ny, ci = cx - 2, cj = cy - 2;
    et_vec3 *W = et_size_array(ci * cy, sizeof *W);

    if (W == NULL)
        return ET_ENOMEM;
    for (size_t a = 0; a < ci; a++)
        for (size_t l = 0; l < cy; l++)
            for (size_t k = l < cj ? ci : a; k < cx; k++) {
                const et_vec3 P = g->P[w][place(k, cx) * cy + place(l, cy)];
                const double x = r->Ru[a * cx + k];
                W[a * cy + l] = (et_vec3){W[a * cy + l].x + x * P.x, W[a * cy + l].y + x * P.y, W[a * cy + l].z + x * P.z};
            }
    for (size_t a = 0; a < ci; a++)
        for (size_t b = 0; b < cj; b++) {
            et_vec3 e = r->E[(b * g->views + w) * cx + a];
            for (size_t l = b; l < cy; l++) {
                const double x = r->Rv[b * cy + l];
                const et_vec3 P = W[a * cy + l];
                e = (et_vec3){e.x - x * P.x, e.y - x * P.y, e.z - x * P.z};
            }
            B[a * cj + b] = e;
        }
    free(W);
    return ET_OK;
}

/* X of R X = B for the leading m x m block of R (n x n). */
static et_status solve_triangle(et_vec3 *X, const double *R, size_t m, size_t n, const et_vec3 *B, size_t columns, const char *where,
                                const char *direction, et_message *message)
{
    double *block = et_size_array(m * m, sizeof *block);
    size_t rank = 0;
    et_status status = ET_ENOMEM;

    if (block != NULL) {
        for (size_t i = 0; i < m; i++)
            memcpy(block + i * m, R + i * n, m * sizeof *R);
        status = et_linalg_lsq(&X->x, &rank, block, m, m, &B->x, 3 * columns, ET_LINALG_QR);
    }
    free(block);
    if (status == ET_ERANK)
        return et_status_fail(message, status, "%s, direction %s: the interior parameters determine only %zu of %zu interior control points", where,
                              direction, rank, m);
    return status == ET_OK ? ET_OK : et_status_fail(message, status, "%s, direction %s: %s", where, direction, et_status_text(status));
}

static et_status solve_interior(const glued *g, const reduction *r, size_t w, et_message *message)
{
    const size_t cx = g->control.nx, cy = g->control.ny, ci = cx - 2, cj = cy - 2;
    et_vec3 *B = et_size_array(ci * cj, sizeof *B), *X = et_size_array(ci * cj, sizeof *X);
    et_status status = B == NULL || X == NULL ? ET_ENOMEM : subtract_border(B, g, r, w);

    if (status == ET_OK)
        status = solve_triangle(X, r->Ru, ci, cx, B, cj, g->where, "u", message);
    if (status == ET_OK) {
        transpose(B, X, ci, cj);
        status = solve_triangle(X, r->Rv, cj, cy, B, ci, g->where, "v", message);
    }
    for (size_t i = 0; status == ET_OK && i < ci; i++)
        for (size_t j = 0; j < cj; j++)
            g->P[w][(i + 1) * cy + j + 1] = X[j * ci + i];
    free(B);
    free(X);
    return status;
}

static et_status solve_glued(const glued *g, et_linalg_method method, et_message *message)
{
    reduction r;
    et_status status;

    if (method != ET_LINALG_QR)
        return solve_glued_dense(g, method, message);
    status = reduction_new(&r, g);
    if (status != ET_OK)
        return et_status_fail(message, status, "%s: %s", g->where, et_status_text(status));
    status = solve_border(g, &r, message);
    for (size_t w = 0; status == ET_OK && w < g->views && g->control.nx > 2 && g->control.ny > 2; w++)
        status = solve_interior(g, &r, w, message);
    reduction_free(&r);
    return status;
}

/* ---- the three approaches ---- */

typedef struct {
    const et_fit_options *options;
    int fixed;
    et_vec3 *D[2];
    collocation U[2], V[2];
} job;

static et_status run_separate(et_fit *fit, const job *k, et_message *message)
{
    const et_fit_options *o = k->options;
    et_status status = ET_OK;

    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        et_vec3 *P = fit->shell.view[w].points;
        if (k->fixed && o->approach == ET_FIT_CONVENTIONAL) {
            const glued g = {1, 1, fit->data, o->control, &k->U[w], &k->V[w], {k->D[w], NULL}, {P, NULL}, view_names[w]};
            status = solve_glued(&g, o->algebra, message);
        } else {
            status = solve_view(P, &k->U[w], &k->V[w], k->D[w], view_names[w], o->algebra, message);
        }
    }
    return status;
}

/* Border control points of equal class become their mean (Eq. 5.7); corners, where fixed, the data's. */
static void close_border(et_fit *fit, const job *k)
{
    const et_doublenet c = k->options->control;

    for (size_t i = 0; i < c.nx; i++)
        for (size_t j = 0; j < c.ny; j++) {
            et_vec3 *a = &fit->shell.view[ET_BOTTOM].points[i * c.ny + j], *b = &fit->shell.view[ET_TOP].points[i * c.ny + j];
            if (k->fixed && is_corner(c, i, j))
                *a = *b = corner(k->D[0], fit->data, i != 0, j != 0);
            else if (on_border(c, i, j))
                *a = *b = (et_vec3){(a->x + b->x) / 2, (a->y + b->y) / 2, (a->z + b->z) / 2};
        }
}

static et_status run(et_fit *fit, const job *k, et_message *message)
{
    const et_fit_options *o = k->options;
    et_surface *view = fit->shell.view;
    et_status status;

    if (o->approach == ET_FIT_JOINT) {
        const glued g = {2, k->fixed, fit->data, o->control, &k->U[0], &k->V[0], {k->D[0], k->D[1]}, {view[0].points, view[1].points}, "both views"};
        status = solve_glued(&g, o->algebra, message);
    } else {
        status = run_separate(fit, k, message);
        if (status == ET_OK && o->approach == ET_FIT_IMPROVED)
            close_border(fit, k);
    }
    if (status == ET_OK && !et_shell_valid(&fit->shell))
        return et_status_fail(message, ET_EFORMAT, "the control points overflow: the data are too large");
    return status;
}

static et_status prepare_view(et_fit *fit, job *k, size_t w, const et_vec3 *data)
{
    const et_fit_options *o = k->options;
    const et_doublenet n = fit->data, c = o->control;
    et_surface *view = &fit->shell.view[w];
    et_status status = et_knotrule_make(view->u, c.nx + o->p + 1, o->p, fit->s[w], n.nx, o->knots);

    if (status == ET_OK)
        status = et_knotrule_make(view->v, c.ny + o->q + 1, o->q, fit->r[w], n.ny, o->knots);
    if (status == ET_OK)
        status = collocate(&k->U[w], fit->s[w], n.nx, view->u, c.nx, o->p);
    if (status == ET_OK)
        status = collocate(&k->V[w], fit->r[w], n.ny, view->v, c.ny, o->q);
    if (status != ET_OK)
        return status;
    k->D[w] = et_size_array(n.nx * n.ny, sizeof *k->D[w]);
    if (k->D[w] == NULL)
        return ET_ENOMEM;
    view_grid(k->D[w], data, n, w);
    return ET_OK;
}

static et_status make(et_fit *fit, const et_vec3 *data, const et_fit_options *o, et_message *message)
{
    job k;
    et_status status = et_shell_new(&fit->shell, o->p, o->q, o->control, 0);

    memset(&k, 0, sizeof k);
    k.options = o;
    k.fixed = o->corners == ET_CORNERS_INTERPOLATED || (o->corners == ET_CORNERS_DEFAULT && o->approach == ET_FIT_IMPROVED);
    for (size_t w = 0; status == ET_OK && w < 2; w++)
        status = prepare_view(fit, &k, w, data);
    if (status == ET_OK)
        status = run(fit, &k, message);
    else
        et_status_fail(message, status, "%s", et_status_text(status));
    for (size_t w = 0; w < 2; w++) {
        free(k.D[w]);
        collocation_free(&k.U[w]);
        collocation_free(&k.V[w]);
    }
    return status;
}

static et_status check_options(et_doublenet n, const et_fit_options *o, et_message *message)
{
    const et_doublenet c = o->control;

    if (et_fit_name(o->approach) == NULL || et_param_name(o->method) == NULL || et_knotrule_name(o->knots) == NULL ||
        et_linalg_name(o->algebra) == NULL || (unsigned)o->corners > ET_CORNERS_INTERPOLATED)
        return et_status_fail(message, ET_EINVAL, "a fit option is not one of its enumeration");
    if (!et_doublenet_valid(c))
        return et_status_fail(message, ET_EINVAL, "a control net %zux%zu is too small", c.nx, c.ny);
    if (c.nx > n.nx || c.ny > n.ny)
        return et_status_fail(message, ET_EINVAL, "control net %zux%zu is larger than the data %zux%zu", c.nx, c.ny, n.nx, n.ny);
    if (o->p < 1 || o->q < 1 || o->p >= c.nx || o->q >= c.ny)
        return et_status_fail(message, ET_EINVAL, "degrees %zu and %zu do not suit a control net %zux%zu: at least 1, less than its side", o->p, o->q,
                              c.nx, c.ny);
    if (o->knots == ET_KNOTRULE_AVERAGING && (c.nx != n.nx || c.ny != n.ny))
        return et_status_fail(message, ET_EINVAL, "averaged knots need as many control points (%zux%zu) as data (%zux%zu)", c.nx, c.ny, n.nx, n.ny);
    return ET_OK;
}

et_status et_fit_make(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, const et_fit_options *options, et_message *message)
{
    et_fit made;
    et_status status;

    if (!et_doublenet_valid(net) || nov != et_doublenet_nov(net))
        return et_status_fail(message, ET_EINVAL, "%zu points are not the classes of a double net %zux%zu", nov, net.nx, net.ny);
    status = check_options(net, options, message);
    if (status != ET_OK)
        return status;
    status = et_fit_parameters(&made, data, nov, net, options->approach, options->method);
    if (status != ET_OK)
        return et_status_fail(message, status, "parameters: %s", et_status_text(status));
    status = make(&made, data, options, message);
    if (status != ET_OK) {
        et_fit_free(&made);
        return status;
    }
    *fit = made;
    return ET_OK;
}

/* ---- errors ---- */

/* d[at] = distance of each node of a view. */
static et_status node_distances(double *d, const et_fit *fit, size_t w, const et_vec3 *data, et_vec3 *S)
{
    const et_doublenet n = fit->data;
    const et_status status = et_surface_grid(S, &fit->shell.view[w], fit->s[w], n.nx, fit->r[w], n.ny);

    if (status != ET_OK)
        return status;
    for (size_t i = 0; i < n.nx; i++)
        for (size_t j = 0; j < n.ny; j++)
            d[i * n.ny + j] = et_vec3_distance(data[et_doublenet_class(n, w, i, j) - 1], S[i * n.ny + j]);
    return ET_OK;
}

/* d: distances of all nodes, bottom then top; c: the same by class. */
static void summarise(et_fit_error *error, const double *d, const double *c, size_t nov, et_doublenet n)
{
    const size_t nodes = n.nx * n.ny;
    et_fit_error e = {et_real_sum(c, nov), et_real_sum(d, 2 * nodes), 0, 0};

    for (size_t at = 0; at < 2 * nodes; at++) {
        e.greatest = fmax(e.greatest, d[at]);
        if (is_corner(n, at % nodes / n.ny, at % n.ny))
            e.corner = fmax(e.corner, d[at]);
    }
    *error = e;
}

et_status et_fit_measure(et_fit_error *error, double *residual, size_t nov, const et_fit *fit, const et_vec3 *data)
{
    const et_doublenet n = fit->data;
    const size_t nodes = n.nx * n.ny;
    et_vec3 *S;
    double *d, *c;
    et_status status = ET_ENOMEM;

    if (!et_doublenet_valid(n) || nov != et_doublenet_nov(n))
        return ET_EINVAL;
    S = et_size_array(nodes, sizeof *S);
    d = et_size_array(2 * nodes, sizeof *d);
    c = et_size_array(nov, sizeof *c);
    if (S != NULL && d != NULL && c != NULL) {
        status = node_distances(d, fit, ET_BOTTOM, data, S);
        if (status == ET_OK)
            status = node_distances(d + nodes, fit, ET_TOP, data, S);
    }
    if (status == ET_OK) {
        for (size_t k = 1; k <= nov; k++) {
            const et_index x = et_doublenet_index(n, k);
            c[k - 1] = d[(x.k == 2 ? nodes : 0) + x.i * n.ny + x.j];
        }
        summarise(error, d, c, nov, n);
        if (residual != NULL)
            memcpy(residual, c, nov * sizeof *c);
    }
    free(S);
    free(d);
    free(c);
    return status;
}
