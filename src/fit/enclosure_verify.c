/* enclosure_verify: an approximate inverse of R, and the proof that it is one (Rump, Verification methods, 2010, sections 10.3 and 10.8).
 *
 * With B = A T a bound || I - B'W B || < 1 bounds the inverse of B'W B by Neumann's series.  The condition enters once, not squared, since B'W B is
 * formed from B.
 */
#include "etalon/base/size.h"
#include "fit/enclosure_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* x >= 0 made from at most n roundings of terms >= 0: an upper bound of the exact value. */
static double up(double x, size_t n)
{
    return x * (1 + ((double)n + 2) * 0x1p-52);
}

/* ---- T = R^-1 ---- */

/* The dense matrix of the upper parts, rows times the roots of their weights. */
static double *dense(const enclosure_system *s)
{
    const size_t n = s->columns;
    double *A = NULL;
    size_t entries;

    if (et_size_mul(&entries, s->rows, n) == ET_OK)
        A = et_size_array(entries, sizeof *A);
    for (size_t i = 0; A != NULL && i < s->rows; i++) {
        const double root = sqrt(s->weight[i]);
        for (size_t k = 0; k < s->width; k++)
            A[i * n + s->at[i * s->width + k]] += root * s->a[i * s->width + k].hi;
    }
    return A;
}

static et_status upper_factor(double *R, const enclosure_system *s)
{
    double *A = dense(s);
    et_status status = ET_ENOMEM;

    if (A != NULL)
        status = et_linalg_qr(R, R, A, s->rows, s->columns, A, 0);
    free(A);
    return status;
}

/* T = R^-1 by rows from the last one: T_i = (e_i - sum_k>i R_ik T_k) / R_ii. */
static et_status invert(double *T, const double *R, size_t n)
{
    for (size_t i = n; i-- > 0;) {
        double *t = T + i * n;
        if (R[i * n + i] == 0) /* by underflow: the rank is full */
            return ET_ENOCONV;
        t[i] = 1;
        for (size_t k = i + 1; k < n; k++) {
            const double x = R[i * n + k], *other = T + k * n;
            for (size_t j = k; x != 0 && j < n; j++)
                t[j] -= x * other[j];
        }
        for (size_t j = i; j < n; j++)
            t[j] /= R[i * n + i];
    }
    return ET_OK;
}

/* ---- || I - B'W B || ---- */

/* B = fl(A T) and M = fl(A |T|), from the upper parts of A >= 0. */
static void multiply(double *B, double *M, const enclosure_system *s)
{
    const size_t n = s->columns;

    for (size_t i = 0; i < s->rows; i++)
        for (size_t k = 0; k < s->width; k++) {
            const double x = s->a[i * s->width + k].hi;
            const size_t c = s->at[i * s->width + k];
            const double *t = s->T + c * n;
            double *b = B + i * n, *m = M + i * n;
            for (size_t j = c; x != 0 && j < n; j++) {
                b[j] += x * t[j];
                m[j] += x * fabs(t[j]);
            }
        }
}

/* The greatest |T_ij|, and 1 if that is 0. */
static double greatest(const double *T, size_t n)
{
    double most = 0;

    for (size_t e = 0; e < n * n; e++)
        most = fabs(T[e]) > most ? fabs(T[e]) : most;
    return most > 0 ? most : 1;
}

/* |A T - B| entry by entry, written over M.  Each entry is a sum of at most w products of a.hi with T (w u), a.lo is left out (u), A itself is off by
 * much less than u; M's own roundings and all products of errors take less than 2 u.  Where something underflows: w ENCLOSURE_TINY (1 + |T|). */
static void product_error(double *M, const enclosure_system *s)
{
    const size_t n = s->columns;
    const double w = (double)s->width;
    const double most = greatest(s->T, n);

    for (size_t e = 0; e < s->rows * n; e++)
        M[e] = (w + 8) * 0x1p-53 * M[e] + 2 * w * ENCLOSURE_TINY * (1 + most);
}

/* H = fl(B'W B), upper half, four rows at a time. */
static void gram(double *H, const double *B, const enclosure_system *s)
{
    const size_t n = s->columns, m = s->rows;

    for (size_t i = 0; i < m; i += 4) {
        const size_t rows = m - i < 4 ? m - i : 4;
        const double *b = B + i * n, *b1 = rows > 1 ? b + n : b, *b2 = rows > 2 ? b + 2 * n : b, *b3 = rows > 3 ? b + 3 * n : b;
        for (size_t j = 0; j < n; j++) {
            const double x = s->weight[i] * b[j], x1 = rows > 1 ? s->weight[i + 1] * b1[j] : 0;
            const double x2 = rows > 2 ? s->weight[i + 2] * b2[j] : 0, x3 = rows > 3 ? s->weight[i + 3] * b3[j] : 0;
            double *h = H + j * n;
            for (size_t k = j; k < n; k++)
                h[k] += (x * b[k] + x1 * b1[k]) + (x2 * b2[k] + x3 * b3[k]);
        }
    }
}

/* The greatest row sum of |I - B'W B|, B the exact product, which lies within E of the computed one.  Beside |I - H| each entry has
 *   (m + 4) u |B|'W |B|           H's sums of at most m + 3 terms in any order, and the subtraction from I, where 1 and H cancel;
 *   E'W |B| + |B|'W E + E'W E     the product's own error.
 * Summed over a row these are products with the vectors |B| 1 and E 1. */
static double distance_from_identity(const enclosure_system *s, const double *B, const double *E, const double *H, double *row, double *sum)
{
    const size_t n = s->columns, m = s->rows;
    double most = 0;

    memset(sum, 0, n * sizeof *sum);
    for (size_t i = 0; i < m; i++) {
        double b = 0, e = 0;
        for (size_t j = 0; j < n; j++) {
            b += fabs(B[i * n + j]);
            e += E[i * n + j];
        }
        row[i] = s->weight[i] * (((double)m + 4) * 0x1p-53 * b + e);
        for (size_t j = 0; j < n; j++)
            sum[j] += fabs(B[i * n + j]) * row[i] + E[i * n + j] * (s->weight[i] * (b + e));
    }
    for (size_t j = 0; j < n; j++) {
        double x = 0;
        for (size_t k = 0; k < n; k++)
            x += k == j ? fabs(1 - H[j * n + j]) : fabs(k < j ? H[k * n + j] : H[j * n + k]);
        x = up(x + sum[j], 2 * n + 2 * m + 16) + ENCLOSURE_TINY;
        most = x <= most ? most : x; /* if one is NaN all are: row[i] is */
    }
    return most;
}

/* ---- norms ---- */

/* The square root of the greatest eigenvalue of an operator y = F'F x of size n, by the power method from a vector of no symmetry: an estimate. */
static double power_method(const enclosure_system *s, void (*apply)(double *y, double *x, const enclosure_system *s), double *x, double *y)
{
    const size_t n = s->columns;
    double value = 0;

    for (size_t j = 0; j < n; j++)
        x[j] = 1 + 0.5 * (double)(j % 7) / 7 + (j % 2 == 0 ? 0.25 : -0.25);
    for (size_t k = 0; k < 40; k++) {
        double length = 0;
        for (size_t j = 0; j < n; j++)
            length += x[j] * x[j];
        length = sqrt(length);
        for (size_t j = 0; j < n && length > 0; j++)
            x[j] /= length;
        apply(y, x, s);
        value = 0;
        for (size_t j = 0; j < n; j++)
            value += x[j] * y[j];
        memcpy(x, y, n * sizeof *x);
    }
    return sqrt(fabs(value));
}

/* y = S'A'W A S x, S the roots of 1/share: shared unknowns count once in each view. */
static void apply_normal(double *y, double *x, const enclosure_system *s)
{
    memset(y, 0, s->columns * sizeof *y);
    for (size_t i = 0; i < s->rows; i++) {
        const double *w = s->weight + i;
        double sum = 0;
        for (size_t k = 0; k < s->width; k++) {
            const size_t c = s->at[i * s->width + k];
            sum += s->a[i * s->width + k].hi * x[c] / sqrt(s->share[c]);
        }
        for (size_t k = 0; k < s->width; k++) {
            const size_t c = s->at[i * s->width + k];
            y[c] += *w * sum * s->a[i * s->width + k].hi / sqrt(s->share[c]);
        }
    }
}

/* y = S^-1 T T'S^-1 x with T divided by its greatest entry, whose square might overflow. */
static void apply_inverse(double *y, double *x, const enclosure_system *s)
{
    const size_t n = s->columns;
    const double unit = greatest(s->T, n);
    double *z = s->work + n * 2;

    memset(z, 0, n * sizeof *z);
    for (size_t i = 0; i < n; i++)
        for (size_t j = i; j < n; j++)
            z[j] += s->T[i * n + j] / unit * x[i] * sqrt(s->share[i]);
    for (size_t i = 0; i < n; i++) {
        y[i] = 0;
        for (size_t j = i; j < n; j++)
            y[i] += s->T[i * n + j] / unit * z[j];
        y[i] *= sqrt(s->share[i]);
    }
}

/* ---- all of it ---- */

static int finite_entries(const enclosure_system *s)
{
    for (size_t e = 0; e < s->rows * s->width; e++)
        if (!isfinite(s->a[e].hi) || !isfinite(s->a[e].lo))
            return 0;
    return 1;
}

/* With T in place: C and the defect. */
static et_status prove(enclosure_system *s, double *M, double *H)
{
    const size_t entries = s->rows * s->columns;
    double distance;

    multiply(s->C, M, s);
    product_error(M, s);
    memset(H, 0, s->columns * s->columns * sizeof *H);
    gram(H, s->C, s);
    distance = distance_from_identity(s, s->C, M, H, s->work, s->work + s->rows);
    if (!(distance <= 0.5))
        return ET_ENOCONV;
    s->defect = distance / (1 - distance) * (1 + 0x1p-50); /* sum of ||I - H||^k, k >= 1; three roundings */
    for (size_t e = 0; e < entries; e++)
        s->C[e] = (fabs(s->C[e]) + M[e]) * (1 + 0x1p-52);
    return ET_OK;
}

et_status enclosure_verify(enclosure_system *s)
{
    const size_t n = s->columns;
    double *R = NULL, *M;
    size_t square, entries;
    et_status status = ET_ENOMEM;

    if (!finite_entries(s))
        return ET_ENOCONV;
    if (et_size_mul(&square, n, n) != ET_OK || et_size_mul(&entries, s->rows, n) != ET_OK)
        return ET_ENOMEM;
    R = et_size_array(square, sizeof *R);
    s->T = et_size_array(square, sizeof *s->T);
    s->C = et_size_array(entries, sizeof *s->C);
    M = et_size_array(entries, sizeof *M);
    if (R != NULL && M != NULL && s->T != NULL && s->C != NULL)
        status = upper_factor(R, s);
    if (status == ET_OK)
        status = invert(s->T, R, n);
    s->norm = power_method(s, apply_normal, s->work, s->work + n);
    if (status == ET_OK) {
        s->inverse = greatest(s->T, n) * power_method(s, apply_inverse, s->work, s->work + n);
        status = prove(s, M, R);
    }
    free(R);
    free(M);
    return status;
}
