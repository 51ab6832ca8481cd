/* enclosure_system: the matrices of a fit in double-double, with what their entries may be off. */
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include "fit/enclosure_parts.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- basis functions ---- */

/* x - u[span+1-j], j = 1..p: exact, as every difference of two doubles is a double-double. */
static et_dd left(const double *u, size_t span, double x, size_t j)
{
    return et_dd_two_sum(x, -u[span + 1 - j]);
}

static et_dd right(const double *u, size_t span, double x, size_t j)
{
    return et_dd_two_sum(u[span + j], -x);
}

/* A2.2 of The NURBS Book.  All terms are >= 0, so relative errors only add up: a level of the triangle costs a division (15 u^2 + 56 u^3), a
 * product (7 u^2) and a sum (3 u^2 + 13 u^3), less than 26 u^2 with their products; denominators are exact.  What underflows is below 2^-1060 an
 * operation and is never enlarged, since each quotient by a knot difference is multiplied by a part of that difference. */
void enclosure_basis(et_dd *N, const double *u, size_t p, size_t span, double x)
{
    size_t only = p + 1; /* the only function that is not zero, where x meets a knot of multiplicity p or more */

    if (p == 0 || left(u, span, x, p).hi == 0)
        only = 0;
    else if (right(u, span, x, p).hi == 0)
        only = p;
    N[0] = (et_dd){1, 0};
    for (size_t j = 1; j <= p && only > p; j++) {
        et_dd saved = {0, 0};
        for (size_t r = 0; r < j; r++) {
            const et_dd t = et_dd_div(N[r], et_dd_two_sum(u[span + r + 1], -u[span + 1 + r - j]));
            N[r] = et_dd_add(saved, et_dd_mul(right(u, span, x, r + 1), t));
            saved = et_dd_mul(left(u, span, x, j - r), t);
        }
        N[j] = saved;
    }
    for (size_t r = 0; only <= p && r <= p; r++)
        N[r] = (et_dd){r == only, 0};
}

/* N_j(x) > 0: inside the support, or at the closed end of functions that are 1 there. */
static int positive(const double *u, size_t n, size_t p, size_t j, double x)
{
    if (u[j] < x && x < u[j + p + 1])
        return 1;
    if (x == u[n] && u[j + p + 1] == x)
        return u[j] < x && u[j + 1] == x;
    return x == u[j] && u[j + p] == x && x < u[j + p + 1];
}

size_t enclosure_rank(const double *u, size_t n, size_t p, const double *t, size_t m, int inner)
{
    const size_t skip = inner ? 1 : 0;
    size_t rank = 0, i = 0;

    for (size_t j = skip; j + skip < n; j++) {
        size_t k = i;
        while (k < m && !positive(u, n, p, j, t[k]))
            k++;
        if (k == m)
            continue;
        rank++;
        for (i = k + 1; i < m && t[i] == t[k];)
            i++;
    }
    return rank;
}

/* ---- systems ---- */

void enclosure_system_free(enclosure_system *s)
{
    free(s->at);
    free(s->a);
    free(s->weight);
    free(s->share);
    free(s->T);
    free(s->C);
    free(s->r);
    free(s->g);
    free(s->z);
    free(s->work);
    memset(s, 0, sizeof *s);
}

static et_status system_new(enclosure_system *s, size_t rows, size_t columns, size_t width)
{
    size_t entries;

    memset(s, 0, sizeof *s);
    s->rows = rows;
    s->columns = columns;
    s->width = width;
    if (et_size_mul(&entries, rows, width) == ET_OK) {
        s->at = et_size_array(entries, sizeof *s->at);
        s->a = et_size_array(entries, sizeof *s->a);
    }
    s->weight = et_size_array(rows, sizeof *s->weight);
    s->share = et_size_array(columns, sizeof *s->share);
    s->r = et_size_array(rows, sizeof *s->r);
    s->g = et_size_array(columns, sizeof *s->g);
    s->z = et_size_array(columns, sizeof *s->z);
    if (rows <= SIZE_MAX - columns)
        s->work = et_size_array(rows + columns, 3 * sizeof *s->work);
    if (s->at == NULL || s->a == NULL || s->weight == NULL || s->share == NULL || s->r == NULL || s->g == NULL || s->z == NULL || s->work == NULL) {
        enclosure_system_free(s);
        return ET_ENOMEM;
    }
    for (size_t i = 0; i < rows; i++)
        s->weight[i] = 1;
    for (size_t j = 0; j < columns; j++)
        s->share[j] = 1;
    return ET_OK;
}

et_status enclosure_direction(enclosure_system *s, const double *t, size_t m, const double *u, size_t n, size_t p, int inner)
{
    const size_t skip = inner ? 1 : 0, last = n - 1 - skip;
    const et_status status = system_new(s, m - 2 * skip, n - 2 * skip, p + 1);

    if (status != ET_OK)
        return status;
    s->relative = 26 * (double)p * ENCLOSURE_UNIT2;
    s->tall = s->rows;
    for (size_t i = 0; i < s->rows; i++) {
        const size_t span = et_knots_span(u, n + p + 1, p, t[i + skip]);
        et_dd *row = s->a + i * s->width;
        enclosure_basis(row, u, p, span, t[i + skip]);
        for (size_t k = 0; k <= p; k++) {
            const size_t j = span - p + k;
            if (j < skip || j > last)
                row[k] = (et_dd){0, 0};
            else
                s->at[i * s->width + k] = j - skip;
        }
    }
    return ET_OK;
}

/* s->tall, which bounds the terms of each component of A'r. */
static et_status count_columns(enclosure_system *s)
{
    size_t *count = et_size_array(s->columns, sizeof *count);

    if (count == NULL)
        return ET_ENOMEM;
    for (size_t e = 0; e < s->rows * s->width; e++)
        if (s->a[e].hi != 0 && ++count[s->at[e]] > s->tall)
            s->tall = count[s->at[e]];
    free(count);
    return ET_OK;
}

et_status enclosure_product(enclosure_system *s, const enclosure_system *U, const enclosure_system *V, const size_t *number, size_t columns)
{
    et_status status = system_new(s, U->rows * V->rows, columns, U->width * V->width);

    if (status != ET_OK)
        return status;
    s->relative = U->relative + V->relative + 8 * ENCLOSURE_UNIT2; /* a product costs 7 u^2; the rest is for products of errors */
    for (size_t i = 0; i < U->rows; i++)
        for (size_t j = 0; j < V->rows; j++)
            for (size_t k = 0; k < U->width; k++)
                for (size_t l = 0; l < V->width; l++) {
                    const size_t e = (i * V->rows + j) * s->width + k * V->width + l;
                    const size_t c = number[U->at[i * U->width + k] * V->columns + V->at[j * V->width + l]];
                    if (c != SIZE_MAX) {
                        s->at[e] = c;
                        s->a[e] = et_dd_mul(U->a[i * U->width + k], V->a[j * V->width + l]);
                    }
                }
    status = count_columns(s);
    if (status != ET_OK)
        enclosure_system_free(s);
    return status;
}
