/* fit_glue: views glued along their border, corners free or fixed, by orthogonal reduction.
 *
 * Knots are clamped, so border data depend on border control points alone.  With the columns of Nu ordered (interior, first, last) and Nu = Qu Ru
 * over the interior data rows, likewise Nv, the interior data ask for Ru P Rv' = Qu' D Qv: rows whose index in u or v is among the last two hold
 * border control points only and join the border data in one small least-squares problem; the others then give each view's interior exactly.
 */
#include "fit/fit_parts.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double entry(const fit_collocation *N, size_t i, size_t c)
{
    return c < N->start[i] || c >= N->start[i] + N->w ? 0 : N->a[i * N->w + c - N->start[i]];
}

/* The control index of column a in the order (interior, first, last). */
static size_t place(size_t a, size_t n)
{
    return a + 2 < n ? a + 1 : a + 2 == n ? 0 : n - 1;
}

/* The interior rows of N with reordered columns, padded by zero rows to at least n. */
static double *interior_rows(const fit_collocation *N, size_t *rows)
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
static et_status reduce_direction(double *R, et_vec3 *C, const fit_collocation *N, const et_vec3 *B, size_t columns)
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

static et_status reduction_fill(reduction *r, const fit_glued *g, et_vec3 *B, et_vec3 *C)
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

static et_status reduction_new(reduction *r, const fit_glued *g)
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
static void add_reduced_row(fit_dense *d, size_t row, const fit_glued *g, const reduction *r, size_t a, size_t b)
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
            fit_dense_term(d, row, g, 0, place(k, cx), place(l, cy), weight * r->Ru[a * cx + k] * r->Rv[b * cy + l]);
}

static et_status solve_border(const fit_glued *g, const reduction *r, et_message *message)
{
    const et_doublenet n = g->data, c = g->control;
    size_t row = 0;
    fit_dense d;
    et_status status = fit_dense_new(&d, g, et_doublenet_nor(n) + et_doublenet_nor(c) + 2 * c.nx + 2 * c.ny - 4, 0);

    if (status != ET_OK)
        return et_status_fail(message, status, "%s: no memory for the border's system", g->where);
    for (size_t i = 0; i < n.nx; i++)
        for (size_t j = 0; j < n.ny; j++)
            if (fit_on_border(n, i, j))
                fit_dense_data(&d, row++, g, 0, i, j);
    for (size_t a = 0; a < c.nx; a++)
        for (size_t b = 0; b < c.ny; b++)
            if (a + 2 >= c.nx || b + 2 >= c.ny)
                add_reduced_row(&d, row++, g, r, a, b);
    status = fit_dense_solve(&d, g, "border", ET_LINALG_QR, message);
    if (status == ET_OK)
        fit_dense_deliver(&d, g);
    fit_dense_free(&d);
    return status;
}

/* B (ci x cj) = E - Ru P Rv' over the border control points of a view. */
static et_status subtract_border(et_vec3 *B, const fit_glued *g, const reduction *r, size_t w)
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

static et_status solve_interior(const fit_glued *g, const reduction *r, size_t w, et_message *message)
{
    const size_t cx = g->control.nx, cy = g->control.ny, ci = cx - 2, cj = cy - 2;
    et_vec3 *B = et_size_array(ci * cj, sizeof *B), *X = et_size_array(ci * cj, sizeof *X);
    et_status status = B == NULL || X == NULL ? ET_ENOMEM : subtract_border(B, g, r, w);

    if (status == ET_OK)
        status = solve_triangle(X, r->Ru, ci, cx, B, cj, g->where, "u", message);
    else
        et_status_fail(message, status, "%s: %s", g->where, et_status_text(status));
    if (status == ET_OK) {
        fit_transpose(B, X, ci, cj);
        status = solve_triangle(X, r->Rv, cj, cy, B, ci, g->where, "v", message);
    }
    for (size_t i = 0; status == ET_OK && i < ci; i++)
        for (size_t j = 0; j < cj; j++)
            g->P[w][(i + 1) * cy + j + 1] = X[j * ci + i];
    free(B);
    free(X);
    return status;
}

et_status fit_solve_glued(const fit_glued *g, et_linalg_method method, et_message *message)
{
    reduction r;
    et_status status;

    if (method != ET_LINALG_QR)
        return fit_solve_dense(g, method, message);
    status = reduction_new(&r, g);
    if (status != ET_OK)
        return et_status_fail(message, status, "%s: %s", g->where, et_status_text(status));
    status = solve_border(g, &r, message);
    for (size_t w = 0; status == ET_OK && w < g->views && g->control.nx > 2 && g->control.ny > 2; w++)
        status = solve_interior(g, &r, w, message);
    reduction_free(&r);
    return status;
}
