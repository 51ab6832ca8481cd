#include "etalon/fit/linalg.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <lapacke.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const names[] = {"qr", "cholesky", "svd"};

const char *et_linalg_name(et_linalg_method method)
{
    return (unsigned)method < sizeof names / sizeof *names ? names[method] : NULL;
}

static et_status status_of(lapack_int info)
{
    if (info == 0)
        return ET_OK;
    return info == LAPACK_WORK_MEMORY_ERROR || info == LAPACK_TRANSPOSE_MEMORY_ERROR ? ET_ENOMEM : ET_EINTERNAL;
}

/* LAPACK counts in 32 bits, products such as m n included. */
static int fits(size_t a, size_t b)
{
    return a <= INT_MAX && b <= INT_MAX && (a == 0 || b <= INT_MAX / a);
}

/* A new column-major copy, with `rows` >= m rows of which those past m are zero, of row-major A (m x n). */
static double *by_columns(const double *A, size_t m, size_t n, size_t rows)
{
    double *copy;

    if (!fits(rows, n))
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

/* ET_ERANK with the rank told; at most n - 1, since the caller has found the matrix singular. */
static et_status deficient(size_t *rank, const double *A, size_t m, size_t n)
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

static et_status lsq_cholesky(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    double *G = fits(n, n) ? et_size_array(n * n, sizeof *G) : NULL, *H = fits(n, k) ? et_size_array(n * k, sizeof *H) : NULL, *C = NULL;
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
    return status == ET_ERANK ? deficient(rank, A, m, n) : status;
}

static et_status lsq_svd(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    const size_t most = m < n ? n : m;
    double *Q = by_columns(A, m, n, m), *C = by_columns(B, m, k, most), *sigma = et_size_array(n, sizeof *sigma);
    et_status status = ET_ENOMEM;
    lapack_int info, found = 0;

    if (Q != NULL && C != NULL && sigma != NULL) {
        info = LAPACKE_dgelsd(LAPACK_COL_MAJOR, (lapack_int)m, (lapack_int)n, (lapack_int)k, Q, (lapack_int)m, C, (lapack_int)most, sigma,
                              (double)most * ET_EPS, &found);
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

/* ---- banded least squares ----
 *
 * Rows of equal start form a block of t rows in w columns.  QR in the order of the blocks (sequential Householder accumulation): a block is put
 * under the w rows of R at its columns and eliminated by w reflectors, after which its rows are zero.  The w x (w + t) matrix that takes (rows of
 * R's right-hand side, rows of B) to the new rows of R's right-hand side is orthonormal; it is formed once, `top` (w x w) and `q` (w a data row),
 * and then costs w multiplications a datum, no more than normal equations do.
 */
enum { STRIP = 64 }; /* columns treated together: their w accumulators stay in the first cache */

typedef struct {
    double *R;              /* R[i*w + c] = R(i, i+c) */
    double *top, *q;        /* top[s*w*w + ...] for the block that starts at column s; q[i*w + c] */
    double *v, *tau, *dots; /* of one block of t rows: reflector c's bottom part at v[c*t + ...] */
} band;

static void band_free(band *f)
{
    free(f->R);
    free(f->top);
    free(f->q);
    free(f->v);
    free(f->tau);
    free(f->dots);
}

static et_status band_new(band *f, size_t m, size_t n, size_t w)
{
    if (!fits(m, w) || !fits(n, w) || !fits(w, w) || !fits((n - w + 1), w * w))
        return ET_ENOMEM;
    f->R = et_size_array(n * w, sizeof *f->R);
    f->top = et_size_array((n - w + 1) * w * w, sizeof *f->top);
    f->q = et_size_array(m * w, sizeof *f->q);
    f->v = et_size_array(m * w, sizeof *f->v);
    f->tau = et_size_array(w, sizeof *f->tau);
    f->dots = et_size_array(w, sizeof *f->dots);
    if (f->R != NULL && f->top != NULL && f->q != NULL && f->v != NULL && f->tau != NULL && f->dots != NULL)
        return ET_OK;
    band_free(f);
    return ET_ENOMEM;
}

/* The reflector I - tau (1, v)(1, v)' that takes (alpha, v) to (beta, 0); returns beta.  v becomes the reflector's bottom part. */
static double reflector(double *tau, double alpha, double *v, size_t t)
{
    double scale = fabs(alpha), sum, beta;

    for (size_t i = 0; i < t; i++)
        scale = fmax(scale, fabs(v[i]));
    *tau = 0;
    if (!(scale > 0))
        return alpha;
    sum = (alpha / scale) * (alpha / scale);
    for (size_t i = 0; i < t; i++)
        sum += (v[i] / scale) * (v[i] / scale);
    beta = alpha > 0 ? -scale * sqrt(sum) : scale * sqrt(sum);
    for (size_t i = 0; i < t; i++)
        v[i] /= alpha - beta;
    *tau = (beta - alpha) / beta;
    return beta;
}

/* dots = first + v'M, the rows of M (t x w) taken in order so that memory is read along rows; then M -= v dots'. */
static void reflect(double *M, const double *v, double tau, double *dots, size_t from, size_t to, size_t t, size_t w)
{
    for (size_t i = 0; i < t; i++)
        for (size_t e = from; e < to; e++)
            dots[e] += v[i] * M[i * w + e];
    for (size_t e = from; e < to; e++)
        dots[e] *= tau;
    for (size_t i = 0; i < t; i++)
        for (size_t e = from; e < to; e++)
            M[i * w + e] -= v[i] * dots[e];
}

/* Triangularise one block: M (t x w, overwritten) under rows s .. s+w-1 of R. */
static void eliminate(band *f, double *M, size_t s, size_t t, size_t w)
{
    for (size_t c = 0; c < w; c++) {
        double *v = f->v + c * t, *row = f->R + (s + c) * w;
        for (size_t i = 0; i < t; i++)
            v[i] = M[i * w + c];
        row[0] = reflector(&f->tau[c], row[0], v, t);
        for (size_t e = c + 1; e < w; e++)
            f->dots[e] = row[e - c];
        reflect(M, v, f->tau[c], f->dots, c + 1, w, t, w);
        for (size_t e = c + 1; e < w; e++)
            row[e - c] -= f->dots[e];
    }
}

/* The first w rows of H_w ... H_1: from the left, (I 0) H_w, then H_{w-1}, ... */
static void form(band *f, double *top, double *q, size_t t, size_t w)
{
    memset(q, 0, t * w * sizeof *q);
    for (size_t c = 0; c < w; c++)
        top[c * w + c] = 1;
    for (size_t c = w; c-- > 0;) {
        for (size_t r = 0; r < w; r++)
            f->dots[r] = top[r * w + c];
        reflect(q, f->v + c * t, f->tau[c], f->dots, 0, w, t, w);
        for (size_t r = 0; r < w; r++)
            top[r * w + c] -= f->dots[r];
    }
}

static size_t block_end(const size_t *start, size_t m, size_t i)
{
    size_t end = i + 1;

    while (end < m && start[end] == start[i])
        end++;
    return end;
}

static void band_qr(band *f, const double *a, const size_t *start, size_t m, size_t w)
{
    for (size_t i = 0, end; i < m; i = end) {
        const size_t s = start[i];
        end = block_end(start, m, i);
        memcpy(f->q + i * w, a + i * w, (end - i) * w * sizeof *a);
        eliminate(f, f->q + i * w, s, end - i, w);
        form(f, f->top + s * w * w, f->q + i * w, end - i, w);
    }
}

/* Normal equations in the same frame: top = I, q = a, and R of A'A = R'R. */
static lapack_int band_cholesky(band *f, const double *a, const size_t *start, size_t m, size_t n, size_t w, double *rcond)
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

/* y += a x.  The whole strip has a loop of its own because its constant length lets compilers use vectors at -O2; each element is computed alike. */
static void add_scaled(double *restrict y, double a, const double *restrict x, size_t width)
{
    if (width == STRIP)
        for (size_t i = 0; i < STRIP; i++)
            y[i] += a * x[i];
    else
        for (size_t i = 0; i < width; i++)
            y[i] += a * x[i];
}

static void add_four(double *restrict y, const double q[4], const double *restrict b0, size_t k, size_t width)
{
    const double *restrict b1 = b0 + k, *restrict b2 = b1 + k, *restrict b3 = b2 + k;
    const double q0 = q[0], q1 = q[1], q2 = q[2], q3 = q[3];

    if (width == STRIP)
        for (size_t x = 0; x < STRIP; x++)
            y[x] += (q0 * b0[x] + q1 * b1[x]) + (q2 * b2[x] + q3 * b3[x]);
    else
        for (size_t x = 0; x < width; x++)
            y[x] += (q0 * b0[x] + q1 * b1[x]) + (q2 * b2[x] + q3 * b3[x]);
}

/* acc += sum of q[i*w] b[i*k ...] over i < t, in the order of i by fours. */
static void accumulate(double *acc, const double *q, size_t w, const double *b, size_t k, size_t t, size_t width)
{
    size_t i = 0;

    for (; i + 4 <= t; i += 4) {
        const double four[4] = {q[i * w], q[(i + 1) * w], q[(i + 2) * w], q[(i + 3) * w]};
        add_four(acc, four, b + i * k, k, width);
    }
    for (; i < t; i++)
        add_scaled(acc, q[i * w], b + i * k, width);
}

/* One block on one strip: rows s .. s+w-1 of C become top * (those rows) + q' * (t rows of b). */
static void project_block(double *C, const double *top, const double *q, size_t w, const double *b, size_t k, size_t t, size_t width, double *acc)
{
    memset(acc, 0, w * STRIP * sizeof *acc);
    for (size_t r = 0; r < w; r++) {
        for (size_t c = 0; c < w; c++)
            if (top[r * w + c] != 0)
                add_scaled(acc + r * STRIP, top[r * w + c], C + c * k, width);
        accumulate(acc + r * STRIP, q + r, w, b, k, t, width);
    }
    for (size_t r = 0; r < w; r++)
        memcpy(C + r * k, acc + r * STRIP, width * sizeof *C);
}

/* y a, by parts like add_scaled. */
static void scale(double *y, double a, size_t width)
{
    if (width == STRIP)
        for (size_t x = 0; x < STRIP; x++)
            y[x] *= a;
    else
        for (size_t x = 0; x < width; x++)
            y[x] *= a;
}

/* R'Y = C in place. */
static void band_forward(double *C, const double *R, size_t n, size_t w, size_t k, size_t width)
{
    for (size_t i = 0; i < n; i++) {
        scale(C + i * k, 1 / R[i * w], width); /* one rounding more than a quotient's */
        for (size_t c = 1; c < w && i + c < n; c++)
            add_scaled(C + (i + c) * k, -R[i * w + c], C + i * k, width);
    }
}

/* R X = C in place. */
static void band_back(double *C, const double *R, size_t n, size_t w, size_t k, size_t width)
{
    for (size_t i = n; i-- > 0;) {
        for (size_t c = 1; c < w && i + c < n; c++)
            add_scaled(C + i * k, -R[i * w + c], C + (i + c) * k, width);
        scale(C + i * k, 1 / R[i * w], width); /* one rounding more than a quotient's */
    }
}

/* One strip of C (zero on entry) becomes Q'B, or A'B for normal equations.  work: w * STRIP doubles. */
static void band_project(double *C, const band *f, const size_t *start, size_t m, size_t w, const double *B, size_t k, size_t width, double *work)
{
    for (size_t i = 0, end; i < m; i = end) {
        const size_t s = start[i];
        end = block_end(start, m, i);
        project_block(C + s * k, f->top + s * w * w, f->q + i * w, w, B + i * k, k, end - i, width, work);
    }
}

/* X (n x k, zero on entry) = the solution, a strip of columns at a time while it is in the cache. */
static void band_solve(double *X, const band *f, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k, int normal,
                       double *work)
{
    for (size_t x = 0; x < k; x += STRIP) {
        const size_t width = k - x < STRIP ? k - x : STRIP;
        band_project(X + x, f, start, m, w, B + x, k, width, work);
        if (normal)
            band_forward(X + x, f->R, n, w, k, width);
        band_back(X + x, f->R, n, w, k, width);
    }
}

static double *dense(const double *a, const size_t *start, size_t m, size_t n, size_t w)
{
    double *A = fits(m, n) ? et_size_array(m * n, sizeof *A) : NULL;

    if (A != NULL)
        for (size_t i = 0; i < m; i++)
            memcpy(A + i * n + start[i], a + i * w, w * sizeof *a);
    return A;
}

static et_status band_factor(band *f, const double *a, const size_t *start, size_t m, size_t n, size_t w, et_linalg_method method)
{
    double rcond = 0;
    lapack_int info;

    if (method == ET_LINALG_CHOLESKY) {
        info = band_cholesky(f, a, start, m, n, w, &rcond);
    } else {
        band_qr(f, a, start, m, w);
        info = LAPACKE_dtbcon(LAPACK_COL_MAJOR, '1', 'L', 'N', (lapack_int)n, (lapack_int)(w - 1), f->R, (lapack_int)w, &rcond);
    }
    if (info < 0)
        return status_of(info);
    return info > 0 || singular(rcond, m > n ? m : n) ? ET_ERANK : ET_OK;
}

static int band_valid(const size_t *start, size_t m, size_t n, size_t w)
{
    for (size_t i = 0; i < m; i++)
        if (start[i] > n - w || (i > 0 && start[i] < start[i - 1]))
            return 0;
    return 1;
}

/* ET_ERANK without the rank, X and *rank untouched. */
static et_status solve_banded(double *X, size_t *rank, const double *a, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k,
                              et_linalg_method method)
{
    double *work = et_size_array(w, STRIP * sizeof *work);
    band f;
    et_status status = band_new(&f, m, n, w);

    if (status != ET_OK) {
        free(work);
        return status;
    }
    status = work == NULL ? ET_ENOMEM : band_factor(&f, a, start, m, n, w, method);
    if (status == ET_OK) {
        memset(X, 0, n * k * sizeof *X);
        band_solve(X, &f, start, m, n, w, B, k, method == ET_LINALG_CHOLESKY, work);
        *rank = n;
    }
    free(work);
    band_free(&f);
    return status;
}

/* Dense QR is the band of one block and of full width: our own arithmetic, so that bits depend neither on the BLAS nor on its threads. */
static et_status lsq_qr(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    size_t *start = et_size_array(m, sizeof *start);
    const et_status status = start == NULL ? ET_ENOMEM : solve_banded(X, rank, A, start, m, n, n, B, k, ET_LINALG_QR);

    free(start);
    return status == ET_ERANK ? deficient(rank, A, m, n) : status;
}

et_status et_linalg_lsq(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k, et_linalg_method method)
{
    if (m < 1 || n < 1 || k < 1 || et_linalg_name(method) == NULL)
        return ET_EINVAL;
    if (!fits(m, n) || !fits(m < n ? n : m, k))
        return ET_ENOMEM;
    if (method == ET_LINALG_QR)
        return lsq_qr(X, rank, A, m, n, B, k);
    if (method == ET_LINALG_CHOLESKY)
        return lsq_cholesky(X, rank, A, m, n, B, k);
    return lsq_svd(X, rank, A, m, n, B, k);
}

et_status et_linalg_qr(double *R, double *C, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    size_t *start;
    double *work;
    band f;
    et_status status;

    if (n < 1 || m < n)
        return ET_EINVAL;
    if (!fits(m, n) || !fits(m, k))
        return ET_ENOMEM;
    status = band_new(&f, m, n, n);
    if (status != ET_OK)
        return status;
    start = et_size_array(m, sizeof *start);
    work = et_size_array(n, STRIP * sizeof *work);
    status = start == NULL || work == NULL ? ET_ENOMEM : ET_OK;
    if (status == ET_OK) {
        band_qr(&f, A, start, m, n);
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++)
                R[i * n + j] = j < i ? 0 : f.R[i * n + j - i];
        if (k > 0)
            memset(C, 0, n * k * sizeof *C);
        for (size_t x = 0; x < k; x += STRIP)
            band_project(C + x, &f, start, m, n, B + x, k, k - x < STRIP ? k - x : STRIP, work);
    }
    free(start);
    free(work);
    band_free(&f);
    return status;
}

/* What the band methods cannot do or need not do fast: least norm, and the rank of a deficient matrix. */
static et_status by_dense(double *X, size_t *rank, const double *a, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k)
{
    double *A = dense(a, start, m, n, w);
    et_status status;

    if (A == NULL)
        return ET_ENOMEM;
    status = B != NULL ? et_linalg_lsq(X, rank, A, m, n, B, k, ET_LINALG_SVD) : deficient(rank, A, m, n);
    free(A);
    return status;
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
