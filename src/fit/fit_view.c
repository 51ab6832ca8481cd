/* fit_view: the basis functions at the parameters, and a view fitted by itself. */
#include "fit/fit_parts.h"
#include "etalon/base/size.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include <stdlib.h>
#include <string.h>

/* ---- collocation ---- */

void fit_collocation_free(fit_collocation *N)
{
    free(N->a);
    free(N->start);
    memset(N, 0, sizeof *N);
}

et_status fit_collocate(fit_collocation *N, const double *t, size_t m, const double *u, size_t n, size_t p)
{
    const size_t nwork = et_basis_work(p, 0);
    double *work = et_size_array(nwork, sizeof *work);
    size_t entries;

    *N = (fit_collocation){m, n, p + 1, NULL, NULL};
    if (et_size_mul(&entries, m, p + 1) == ET_OK) {
        N->a = et_size_array(entries, sizeof *N->a);
        N->start = et_size_array(m, sizeof *N->start);
    }
    if (work == NULL || N->a == NULL || N->start == NULL) {
        free(work);
        fit_collocation_free(N);
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

/* ---- its solution, P = Nu^+ D (Nv^+)' ---- */

/* By tiles that fit the first cache. */
void fit_transpose(et_vec3 *T, const et_vec3 *A, size_t m, size_t n)
{
    enum { TILE = 16 };

    for (size_t i0 = 0; i0 < m; i0 += TILE)
        for (size_t j0 = 0; j0 < n; j0 += TILE)
            for (size_t i = i0; i < m && i < i0 + TILE; i++)
                for (size_t j = j0; j < n && j < j0 + TILE; j++)
                    T[j * m + i] = A[i * n + j];
}

static et_status solve_direction(et_vec3 *X, const fit_collocation *N, const et_vec3 *B, size_t columns, const char *where, const char *direction,
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

et_status fit_solve_view(et_vec3 *P, const fit_collocation *U, const fit_collocation *V, const et_vec3 *D, const char *where, et_linalg_method method,
                         et_message *message)
{
    et_vec3 *X = et_size_array(U->n * V->m, sizeof *X), *T = et_size_array(U->n * V->m, sizeof *T), *Y = et_size_array(U->n * V->n, sizeof *Y);
    et_status status = ET_ENOMEM;

    if (X != NULL && T != NULL && Y != NULL)
        status = solve_direction(X, U, D, V->m, where, "u", method, message);
    else
        et_status_fail(message, status, "%s: %s", where, et_status_text(status));
    if (status == ET_OK) {
        fit_transpose(T, X, U->n, V->m);
        status = solve_direction(Y, V, T, U->n, where, "v", method, message);
    }
    if (status == ET_OK)
        fit_transpose(P, Y, V->n, U->n);
    free(X);
    free(T);
    free(Y);
    return status;
}
