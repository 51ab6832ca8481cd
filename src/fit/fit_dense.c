/* fit_dense: least squares in the control points of glued views, written out as a dense matrix. */
#include "fit/fit_parts.h"
#include "etalon/base/size.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define FIXED SIZE_MAX
#define INTERIOR (SIZE_MAX - 1)

/* number[w*cx*cy + i*cy + j]: the unknown of a node, FIXED, or (unless all are wanted) INTERIOR.  Returns how many unknowns there are. */
static size_t number_unknowns(size_t *number, const fit_glued *g, int all)
{
    const et_doublenet c = g->control;
    size_t count = 0;

    for (size_t w = 0; w < g->views; w++)
        for (size_t i = 0; i < c.nx; i++)
            for (size_t j = 0; j < c.ny; j++) {
                const size_t at = i * c.ny + j;
                if (g->fixed && fit_is_corner(c, i, j))
                    number[w * c.nx * c.ny + at] = FIXED;
                else if (fit_on_border(c, i, j))
                    number[w * c.nx * c.ny + at] = w == 0 ? count++ : number[at];
                else
                    number[w * c.nx * c.ny + at] = all ? count++ : INTERIOR;
            }
    return count;
}

void fit_dense_free(fit_dense *d)
{
    free(d->A);
    free(d->B);
    free(d->X);
    free(d->number);
}

et_status fit_dense_new(fit_dense *d, const fit_glued *g, size_t rows, int all)
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
    fit_dense_free(d);
    return ET_ENOMEM;
}

void fit_dense_term(fit_dense *d, size_t row, const fit_glued *g, size_t w, size_t i, size_t j, double x)
{
    const et_doublenet c = g->control;
    const size_t k = d->number[(w * c.nx + i) * c.ny + j];

    if (k == FIXED) {
        const et_vec3 P = fit_corner(g->D[0], g->data, i != 0, j != 0);
        d->B[row].x -= x * P.x;
        d->B[row].y -= x * P.y;
        d->B[row].z -= x * P.z;
    } else if (k != INTERIOR) {
        d->A[row * d->columns + k] += x;
    }
}

void fit_dense_data(fit_dense *d, size_t row, const fit_glued *g, size_t w, size_t i, size_t j)
{
    const size_t c = g->U->start[i], e = g->V->start[j];

    d->B[row] = g->D[w][i * g->data.ny + j];
    for (size_t k = 0; k < g->U->w; k++)
        for (size_t l = 0; l < g->V->w; l++) {
            const double x = g->U->a[i * g->U->w + k] * g->V->a[j * g->V->w + l];
            if (x != 0)
                fit_dense_term(d, row, g, w, c + k, e + l, x);
        }
}

et_status fit_dense_solve(fit_dense *d, const fit_glued *g, const char *what, et_linalg_method method, et_message *message)
{
    size_t rank = 0;
    et_status status = ET_OK;

    if (d->columns > 0)
        status = et_linalg_lsq(&d->X->x, &rank, d->A, d->rows, d->columns, &d->B->x, 3, method);
    if (status == ET_ERANK)
        return et_status_fail(message, status, "%s: the data determine only %zu of %zu %s control points", g->where, rank, d->columns, what);
    return status == ET_OK ? ET_OK : et_status_fail(message, status, "%s: %s", g->where, et_status_text(status));
}

void fit_dense_deliver(const fit_dense *d, const fit_glued *g)
{
    const et_doublenet c = g->control;

    for (size_t w = 0; w < g->views; w++)
        for (size_t at = 0; at < c.nx * c.ny; at++) {
            const size_t k = d->number[w * c.nx * c.ny + at];
            if (k == FIXED)
                g->P[w][at] = fit_corner(g->D[0], g->data, at / c.ny != 0, at % c.ny != 0);
            else if (k != INTERIOR)
                g->P[w][at] = d->X[k];
        }
}

et_status fit_solve_dense(const fit_glued *g, et_linalg_method method, et_message *message)
{
    const et_doublenet n = g->data;
    size_t row = 0;
    fit_dense d;
    et_status status = fit_dense_new(&d, g, g->views == 2 ? et_doublenet_nov(n) : n.nx * n.ny, 1);

    if (status != ET_OK)
        return et_status_fail(message, status, "%s: no memory for a dense system; use qr", g->where);
    for (size_t w = 0; w < g->views; w++)
        for (size_t i = 0; i < n.nx; i++)
            for (size_t j = 0; j < n.ny; j++)
                if (w == 0 || !fit_on_border(n, i, j))
                    fit_dense_data(&d, row++, g, w, i, j);
    status = fit_dense_solve(&d, g, "", method, message);
    if (status == ET_OK)
        fit_dense_deliver(&d, g);
    fit_dense_free(&d);
    return status;
}
