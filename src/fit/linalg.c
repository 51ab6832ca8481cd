#include "etalon/fit/linalg.h"
#include "etalon/base/size.h"
#include "fit/linalg_parts.h"
#include <stdlib.h>
#include <string.h>

static const char *const names[] = {"qr", "cholesky", "svd"};

const char *et_linalg_name(et_linalg_method method)
{
    return (unsigned)method < sizeof names / sizeof *names ? names[method] : NULL;
}

/* ET_ERANK without the rank, X and *rank untouched. */
static et_status solve_banded(double *X, size_t *rank, const double *a, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k,
                              et_linalg_method method)
{
    double *work = et_size_array(w, LINALG_STRIP * sizeof *work);
    linalg_band f;
    et_status status = linalg_band_new(&f, m, n, w);

    if (status != ET_OK) {
        free(work);
        return status;
    }
    status = work == NULL ? ET_ENOMEM : linalg_band_factor(&f, a, start, m, n, w, method);
    if (status == ET_OK) {
        memset(X, 0, n * k * sizeof *X);
        linalg_band_solve(X, &f, start, m, n, w, B, k, method == ET_LINALG_CHOLESKY, work);
        *rank = n;
    }
    free(work);
    linalg_band_free(&f);
    return status;
}

/* Dense QR is the band of one block and of full width: our own arithmetic, so that bits depend neither on the BLAS nor on its threads. */
static et_status lsq_qr(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    size_t *start = et_size_array(m, sizeof *start);
    const et_status status = start == NULL ? ET_ENOMEM : solve_banded(X, rank, A, start, m, n, n, B, k, ET_LINALG_QR);

    free(start);
    return status == ET_ERANK ? linalg_deficient(rank, A, m, n) : status;
}

et_status et_linalg_lsq(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k, et_linalg_method method)
{
    if (m < 1 || n < 1 || k < 1 || et_linalg_name(method) == NULL)
        return ET_EINVAL;
    if (!linalg_fits(m, n) || !linalg_fits(m < n ? n : m, k))
        return ET_ENOMEM;
    if (method == ET_LINALG_QR)
        return lsq_qr(X, rank, A, m, n, B, k);
    if (method == ET_LINALG_CHOLESKY)
        return linalg_lsq_cholesky(X, rank, A, m, n, B, k);
    return linalg_lsq_svd(X, rank, A, m, n, B, k);
}

et_status et_linalg_qr(double *R, double *C, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    size_t *start;
    double *work;
    linalg_band f;
    et_status status;

    if (n < 1 || m < n)
        return ET_EINVAL;
    if (!linalg_fits(m, n) || !linalg_fits(m, k))
        return ET_ENOMEM;
    status = linalg_band_new(&f, m, n, n);
    if (status != ET_OK)
        return status;
    start = et_size_array(m, sizeof *start);
    work = et_size_array(n, LINALG_STRIP * sizeof *work);
    status = start == NULL || work == NULL ? ET_ENOMEM : ET_OK;
    if (status == ET_OK) {
        linalg_band_qr(&f, A, start, m, n);
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++)
                R[i * n + j] = j < i ? 0 : f.R[i * n + j - i];
        if (k > 0)
            memset(C, 0, n * k * sizeof *C);
        for (size_t x = 0; x < k; x += LINALG_STRIP)
            linalg_band_project(C + x, &f, start, m, n, B + x, k, k - x < LINALG_STRIP ? k - x : LINALG_STRIP, work);
    }
    free(start);
    free(work);
    linalg_band_free(&f);
    return status;
}

static double *dense(const double *a, const size_t *start, size_t m, size_t n, size_t w)
{
    double *A = linalg_fits(m, n) ? et_size_array(m * n, sizeof *A) : NULL;

    if (A != NULL)
        for (size_t i = 0; i < m; i++)
            memcpy(A + i * n + start[i], a + i * w, w * sizeof *a);
    return A;
}

/* What the band methods cannot do or need not do fast: least norm, and the rank of a deficient matrix. */
static et_status by_dense(double *X, size_t *rank, const double *a, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k)
{
    double *A = dense(a, start, m, n, w);
    et_status status;

    if (A == NULL)
        return ET_ENOMEM;
    status = B != NULL ? et_linalg_lsq(X, rank, A, m, n, B, k, ET_LINALG_SVD) : linalg_deficient(rank, A, m, n);
    free(A);
    return status;
}

static int band_valid(const size_t *start, size_t m, size_t n, size_t w)
{
    for (size_t i = 0; i < m; i++)
        if (start[i] > n - w || (i > 0 && start[i] < start[i - 1]))
            return 0;
    return 1;
}

et_status et_linalg_band_lsq(double *X, size_t *rank, const double *a, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k,
                             et_linalg_method method)
{
    et_status status;

    if (m < 1 || w < 1 || n < w || k < 1 || et_linalg_name(method) == NULL || !band_valid(start, m, n, w))
        return ET_EINVAL;
    if (method == ET_LINALG_SVD)
        return by_dense(X, rank, a, start, m, n, w, B, k);
    status = solve_banded(X, rank, a, start, m, n, w, B, k, method);
    return status == ET_ERANK ? by_dense(X, rank, a, start, m, n, w, NULL, 0) : status;
}
