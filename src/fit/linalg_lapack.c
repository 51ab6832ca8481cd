/* linalg_lapack: what LAPACK does: dense Cholesky and SVD, ranks, condition numbers, the band's Cholesky. */
#include "fit/linalg_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <lapacke.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static et_status status_of(lapack_int info)
{
    if (info == 0)
        return ET_OK;
    return info == LAPACK_WORK_MEMORY_ERROR || info == LAPACK_TRANSPOSE_MEMORY_ERROR ? ET_ENOMEM : ET_EINTERNAL;
}

int linalg_fits(size_t a, size_t b)
{
    return a <= INT_MAX && b <= INT_MAX && (a == 0 || b <= INT_MAX / a);
}

/* A new column-major copy, with `rows` >= m rows of which those past m are zero, of row-major A (m x n). */
static double *by_columns(const double *A, size_t m, size_t n, size_t rows)
{
    double *copy;

    if (!linalg_fits(rows, n))
        return NULL;
    copy = et_size_array(rows * n, sizeof *copy);
    if (copy != NULL)
        for (size_t i = 0; i < m; i++)
            for (size_t j = 0; j < n; j++)
                copy[j * rows + i] = A[i * n + j];
    return copy;
}

/* The first n rows of column-major C (rows x k) to row-major X. */
static void by_rows(double *X, const double *C, size_t rows, size_t n, size_t k)
{
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < k; j++)
            X[i * k + j] = C[j * rows + i];
}

/* Singular to working precision: the reciprocal condition number is within what rounding in m rows can do, m eps. */
static int singular(double rcond, size_t m)
{
    return !(rcond > (double)m * ET_EPS);
}

/* The numerical rank of row-major A by QR with column pivoting: how many |r_ii| exceed max(m, n) eps |r_11|. */
static et_status pivoted_rank(size_t *rank, const double *A, size_t m, size_t n)
{
    const size_t least = m < n ? m : n, most = m < n ? n : m;
    double *Q = by_columns(A, m, n, m), *tau = et_size_array(least, sizeof *tau);
    lapack_int *pivot = et_size_array(n, sizeof *pivot);
    et_status status = ET_ENOMEM;

    if (Q != NULL && tau != NULL && pivot != NULL)
        status = status_of(LAPACKE_dgeqp3(LAPACK_COL_MAJOR, (lapack_int)m, (lapack_int)n, Q, (lapack_int)m, pivot, tau));
    if (status == ET_OK) {
        size_t r = 0;
        while (r < least && fabs(Q[r * m + r]) > (double)most * ET_EPS * fabs(Q[0]))
            r++;
        *rank = r;
    }
    free(Q);
    free(tau);
    free(pivot);
    return status;
}

et_status linalg_deficient(size_t *rank, const double *A, size_t m, size_t n)
{
    size_t r = 0;
    const et_status status = pivoted_rank(&r, A, m, n);

    if (status != ET_OK)
        return status;
    *rank = r < n ? r : n - 1;
    return ET_ERANK;
}

/* G = A'A and H = A'B, row-major; each entry a sum of m products in order of the rows. */
static void normal_equations(double *G, double *H, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    for (size_t i = 0; i < m; i++)
        for (size_t r = 0; r < n; r++) {
            const double a = A[i * n + r];
            for (size_t c = 0; c < n; c++)
                G[r * n + c] += a * A[i * n + c];
            for (size_t c = 0; c < k; c++)
                H[r * k + c] += a * B[i * k + c];
        }
}

static double norm1_symmetric(const double *G, size_t n)
{
    double norm = 0;

    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (size_t j = 0; j < n; j++)
            sum += fabs(G[i * n + j]);
        norm = fmax(norm, sum);
    }
    return norm;
}

/* G (n x n) is symmetric, so its row-major order is its column-major order; H is column-major n x k. */
static et_status solve_cholesky(double *G, double *H, size_t m, size_t n, size_t k, int *lost)
{
    const double norm = norm1_symmetric(G, n);
    lapack_int info = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', (lapack_int)n, G, (lapack_int)n);
    double rcond = 0;

    if (info == 0)
        info = LAPACKE_dpocon(LAPACK_COL_MAJOR, 'L', (lapack_int)n, G, (lapack_int)n, norm, &rcond);
    if (info < 0)
        return status_of(info);
    *lost = info > 0 || singular(rcond, m > n ? m : n);
    if (*lost)
        return ET_ERANK;
    return status_of(LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'L', (lapack_int)n, (lapack_int)k, G, (lapack_int)n, H, (lapack_int)n));
}

et_status linalg_lsq_cholesky(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    double *G = linalg_fits(n, n) ? et_size_array(n * n, sizeof *G) : NULL, *H = linalg_fits(n, k) ? et_size_array(n * k, sizeof *H) : NULL;
    double *C = NULL;
    et_status status = ET_ENOMEM;
    int lost = 1;

    if (G != NULL && H != NULL) {
        normal_equations(G, H, A, m, n, B, k);
        C = by_columns(H, n, k, n);
    }
    if (C != NULL)
        status = solve_cholesky(G, C, m, n, k, &lost);
    if (status == ET_OK) {
        by_rows(X, C, n, n, k);
        *rank = n;
    }
    free(G);
    free(H);
    free(C);
    return status == ET_ERANK ? linalg_deficient(rank, A, m, n) : status;
}

/* dgelsd with workspace of our own: of one alignment, see et_size_array. */
static lapack_int least_norm(double *Q, double *C, double *sigma, lapack_int *rank, lapack_int m, lapack_int n, lapack_int k)
{
    const lapack_int most = m < n ? n : m;
    const double rcond = (double)most * ET_EPS;
    double room = 0, *work;
    lapack_int iroom = 0, *iwork, info = LAPACKE_dgelsd_work(LAPACK_COL_MAJOR, m, n, k, Q, m, C, most, sigma, rcond, rank, &room, -1, &iroom);

    if (info != 0)
        return info;
    work = et_size_array((size_t)room, sizeof *work);
    iwork = et_size_array((size_t)iroom, sizeof *iwork);
    info = LAPACK_WORK_MEMORY_ERROR;
    if (work != NULL && iwork != NULL)
        info = LAPACKE_dgelsd_work(LAPACK_COL_MAJOR, m, n, k, Q, m, C, most, sigma, rcond, rank, work, (lapack_int)room, iwork);
    free(work);
    free(iwork);
    return info;
}

et_status linalg_lsq_svd(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    const size_t most = m < n ? n : m;
    double *Q = by_columns(A, m, n, m), *C = by_columns(B, m, k, most), *sigma = et_size_array(n, sizeof *sigma);
    et_status status = ET_ENOMEM;
    lapack_int info, found = 0;

    if (Q != NULL && C != NULL && sigma != NULL) {
        info = least_norm(Q, C, sigma, &found, (lapack_int)m, (lapack_int)n, (lapack_int)k);
        status = info > 0 ? ET_ENOCONV : status_of(info);
    }
    if (status == ET_OK) {
        by_rows(X, C, most, n, k);
        *rank = (size_t)found;
    }
    free(Q);
    free(C);
    free(sigma);
    return status;
}

/* Normal equations in the same frame: top = I, q = a, and R of A'A = R'R. */
static lapack_int band_cholesky(linalg_band *f, const double *a, const size_t *start, size_t m, size_t n, size_t w, double *rcond)
{
    double norm = 0;
    lapack_int info;

    memcpy(f->q, a, m * w * sizeof *a);
    for (size_t i = 0; i < m; i++)
        for (size_t r = 0; r < w; r++) {
            f->top[start[i] * w * w + r * w + r] = 1;
            for (size_t c = r; c < w; c++)
                f->R[(start[i] + r) * w + c - r] += a[i * w + r] * a[i * w + c];
        }
    /* Twice the greatest sum of a stored half row bounds the 1-norm from above within a factor of two. */
    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (size_t c = 0; c < w; c++)
            sum += fabs(f->R[i * w + c]);
        norm = fmax(norm, 2 * sum);
    }
    /* R(i, i+c) at i*w + c is L(i+c, i) of L = R' in LAPACK's lower band storage. */
    info = LAPACKE_dpbtrf(LAPACK_COL_MAJOR, 'L', (lapack_int)n, (lapack_int)(w - 1), f->R, (lapack_int)w);
    *rcond = 0;
    if (info == 0)
        info = LAPACKE_dpbcon(LAPACK_COL_MAJOR, 'L', (lapack_int)n, (lapack_int)(w - 1), f->R, (lapack_int)w, norm, rcond);
    return info;
}

et_status linalg_band_factor(linalg_band *f, const double *a, const size_t *start, size_t m, size_t n, size_t w, et_linalg_method method)
{
    double rcond = 0;
    lapack_int info;

    if (method == ET_LINALG_CHOLESKY) {
        info = band_cholesky(f, a, start, m, n, w, &rcond);
    } else {
        linalg_band_qr(f, a, start, m, w);
        info = LAPACKE_dtbcon(LAPACK_COL_MAJOR, '1', 'L', 'N', (lapack_int)n, (lapack_int)(w - 1), f->R, (lapack_int)w, &rcond);
    }
    if (info < 0)
        return status_of(info);
    return info > 0 || singular(rcond, m > n ? m : n) ? ET_ERANK : ET_OK;
}
