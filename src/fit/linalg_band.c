/* linalg_band: banded least squares in our own arithmetic.
 *
 * Rows of equal start form a block of t rows in w columns.  QR in the order of the blocks (sequential Householder accumulation): a block is put
 * under the w rows of R at its columns and eliminated by w reflectors, after which its rows are zero.  The w x (w + t) matrix that takes (rows of
 * R's right-hand side, rows of B) to the new rows of R's right-hand side is orthonormal; it is formed once, `top` (w x w) and `q` (w a data row),
 * and then costs w multiplications a datum, no more than normal equations do.
 */
#include "fit/linalg_parts.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

void linalg_band_free(linalg_band *f)
{
    free(f->R);
    free(f->top);
    free(f->q);
    free(f->v);
    free(f->tau);
    free(f->dots);
}

et_status linalg_band_new(linalg_band *f, size_t m, size_t n, size_t w)
{
    if (!linalg_fits(m, w) || !linalg_fits(n, w) || !linalg_fits(w, w) || !linalg_fits((n - w + 1), w * w))
        return ET_ENOMEM;
    f->R = et_size_array(n * w, sizeof *f->R);
    f->top = et_size_array((n - w + 1) * w * w, sizeof *f->top);
    f->q = et_size_array(m * w, sizeof *f->q);
    f->v = et_size_array(m * w, sizeof *f->v);
    f->tau = et_size_array(w, sizeof *f->tau);
    f->dots = et_size_array(w, sizeof *f->dots);
    if (f->R != NULL && f->top != NULL && f->q != NULL && f->v != NULL && f->tau != NULL && f->dots != NULL)
        return ET_OK;
    linalg_band_free(f);
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
static void eliminate(linalg_band *f, double *M, size_t s, size_t t, size_t w)
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
static void form(linalg_band *f, double *top, double *q, size_t t, size_t w)
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

void linalg_band_qr(linalg_band *f, const double *a, const size_t *start, size_t m, size_t w)
{
    for (size_t i = 0, end; i < m; i = end) {
        const size_t s = start[i];
        end = block_end(start, m, i);
        memcpy(f->q + i * w, a + i * w, (end - i) * w * sizeof *a);
        eliminate(f, f->q + i * w, s, end - i, w);
        form(f, f->top + s * w * w, f->q + i * w, end - i, w);
    }
}

/* y += a x.  The whole strip has a loop of its own because its constant length lets compilers use vectors at -O2; each element is computed alike. */
static void add_scaled(double *restrict y, double a, const double *restrict x, size_t width)
{
    if (width == LINALG_STRIP)
        for (size_t i = 0; i < LINALG_STRIP; i++)
            y[i] += a * x[i];
    else
        for (size_t i = 0; i < width; i++)
            y[i] += a * x[i];
}

static void add_four(double *restrict y, const double q[4], const double *restrict b0, size_t k, size_t width)
{
    const double *restrict b1 = b0 + k, *restrict b2 = b1 + k, *restrict b3 = b2 + k;
    const double q0 = q[0], q1 = q[1], q2 = q[2], q3 = q[3];

    if (width == LINALG_STRIP)
        for (size_t x = 0; x < LINALG_STRIP; x++)
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
    memset(acc, 0, w * LINALG_STRIP * sizeof *acc);
    for (size_t r = 0; r < w; r++) {
        for (size_t c = 0; c < w; c++)
            if (top[r * w + c] != 0)
                add_scaled(acc + r * LINALG_STRIP, top[r * w + c], C + c * k, width);
        accumulate(acc + r * LINALG_STRIP, q + r, w, b, k, t, width);
    }
    for (size_t r = 0; r < w; r++)
        memcpy(C + r * k, acc + r * LINALG_STRIP, width * sizeof *C);
}

/* y a, by parts like add_scaled. */
static void scale(double *y, double a, size_t width)
{
    if (width == LINALG_STRIP)
        for (size_t x = 0; x < LINALG_STRIP; x++)
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

void linalg_band_project(double *C, const linalg_band *f, const size_t *start, size_t m, size_t w, const double *B, size_t k, size_t width,
                         double *work)
{
    for (size_t i = 0, end; i < m; i = end) {
        const size_t s = start[i];
        end = block_end(start, m, i);
        project_block(C + s * k, f->top + s * w * w, f->q + i * w, w, B + i * k, k, end - i, width, work);
    }
}

void linalg_band_solve(double *X, const linalg_band *f, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k, int normal,
                       double *work)
{
    for (size_t x = 0; x < k; x += LINALG_STRIP) {
        const size_t width = k - x < LINALG_STRIP ? k - x : LINALG_STRIP;
        linalg_band_project(X + x, f, start, m, w, B + x, k, width, work);
        if (normal)
            band_forward(X + x, f->R, n, w, k, width);
        band_back(X + x, f->R, n, w, k, width);
    }
}
