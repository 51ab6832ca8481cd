#include "etalon/base/real.h"
#include "etalon/fit/linalg.h"
#include "gen.h"
#include "golden.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { M = 9, N = 4, K = 3, BIG_K = 70, WIDE = 200 };

verdict prop_linalg_name(gen *g)
{
    static const char *const names[] = {"qr", "cholesky", "svd"};
    const size_t k = gen_upto(g, 5);
    const char *name = et_linalg_name((et_linalg_method)k);

    return gen_check(g, k < 3 ? name != NULL && strcmp(name, names[k]) == 0 : name == NULL, "name %zu", k) &&
                   gen_check(g, et_linalg_name((et_linalg_method)-1) == NULL, "name of -1")
               ? PASS
               : FAIL;
}

verdict gold_linalg_name(const row *r)
{
    const char *name = et_linalg_name((et_linalg_method)row_size(r, 0));

    return strcmp(name == NULL ? "null" : name, r->want[0]) == 0 ? PASS : FAIL;
}

static double integer(gen *g, uint64_t most)
{
    const double x = (double)gen_upto(g, most);

    return x != 0 && gen_upto(g, 1) ? -x : x;
}

/* The exact rank of a small matrix of small integers, by elimination without fractions (entries stay below 2^53: Hadamard). */
static size_t exact_rank(const double *A, size_t m, size_t n)
{
    double B[WIDE];
    double last = 1;
    size_t rank = 0;

    memcpy(B, A, m * n * sizeof *B);
    for (size_t c = 0; c < n && rank < m; c++) {
        size_t pivot = rank;
        while (pivot < m && B[pivot * n + c] == 0)
            pivot++;
        if (pivot == m)
            continue;
        for (size_t j = 0; j < n; j++) {
            const double x = B[pivot * n + j];
            B[pivot * n + j] = B[rank * n + j];
            B[rank * n + j] = x;
        }
        for (size_t i = rank + 1; i < m; i++)
            for (size_t j = n; j-- > c;)
                B[i * n + j] = (B[rank * n + c] * B[i * n + j] - B[i * n + c] * B[rank * n + j]) / last;
        last = B[rank * n + c];
        rank++;
    }
    return rank;
}

static double norm(const double *A, size_t n)
{
    double sum = 0;

    for (size_t i = 0; i < n; i++)
        sum += A[i] * A[i];
    return sqrt(sum);
}

/* A'(A X - B) is zero for the exact solution.  QR and SVD solve a system perturbed by at most c u |A| and c u |B|, c of the order m n (Higham,
 * Accuracy and Stability, theorem 20.3), Cholesky leaves c u |A|^2 |X| likewise; the product A'(AX - B) formed here errs by (m + n)u of the same
 * terms. */
static bool optimal(gen *g, const double *X, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    const double c = 16 * (double)((m + n) * (n + 1)) * ET_UNIT, a = norm(A, m * n);

    for (size_t e = 0; e < k; e++) {
        double r[M] = {0}, x = 0, b = 0, slope = 0;
        for (size_t i = 0; i < m; i++) {
            r[i] = -B[i * k + e];
            b += B[i * k + e] * B[i * k + e];
            for (size_t j = 0; j < n; j++)
                r[i] += A[i * n + j] * X[j * k + e];
        }
        for (size_t j = 0; j < n; j++) {
            double s = 0;
            x += X[j * k + e] * X[j * k + e];
            for (size_t i = 0; i < m; i++)
                s += A[i * n + j] * r[i];
            slope += s * s;
        }
        if (!gen_check(g, sqrt(slope) <= c * a * (a * sqrt(x) + sqrt(b)), "column %zu: gradient %g, |A| %g |x| %g |b| %g", e, sqrt(slope), a, sqrt(x),
                       sqrt(b)))
            return false;
    }
    return true;
}

/* Least norm: X is orthogonal to A's null space, here for a last column that is a combination z of the others.  The null space of the perturbed
 * matrix turns by at most c u |A| / sigma; sigma, the least non-zero singular value of an integer matrix of rank r, is at least |A|^(1-r) (the
 * product of the non-zero ones is at least 1, being the root of a sum of squared integer minors). */
static bool least_norm(gen *g, const double *X, const double *A, size_t m, size_t n, size_t rank, const double *z, size_t k)
{
    const double a = norm(A, m * n), bound = 16 * (double)((m + n) * (n + 1)) * ET_UNIT * pow(a, (double)rank) * norm(z, n);

    for (size_t e = 0; e < k; e++) {
        double dot = 0, x = 0;
        for (size_t j = 0; j < n; j++) {
            dot += z[j] * X[j * k + e];
            x += X[j * k + e] * X[j * k + e];
        }
        if (!gen_check(g, fabs(dot) <= bound * sqrt(x), "not of least norm: %g against %g", dot, bound * sqrt(x)))
            return false;
    }
    return true;
}

static bool lsq_refuses(gen *g)
{
    double X[1] = {3}, A[1] = {1}, B[1] = {1};
    const size_t zero = 0;
    size_t rank = 7;
    const bool ok = et_linalg_lsq(X, &rank, A, 0, 1, B, 1, ET_LINALG_QR) == ET_EINVAL &&
                    et_linalg_lsq(X, &rank, A, 1, 0, B, 1, ET_LINALG_QR) == ET_EINVAL &&
                    et_linalg_lsq(X, &rank, A, 1, 1, B, 0, ET_LINALG_QR) == ET_EINVAL &&
                    et_linalg_lsq(X, &rank, A, 1, 1, B, 1, (et_linalg_method)3) == ET_EINVAL &&
                    et_linalg_lsq(X, &rank, A, (size_t)1 << 20, (size_t)1 << 20, B, 1, ET_LINALG_QR) == ET_ENOMEM &&
                    et_linalg_lsq(X, &rank, A, (size_t)1 << 20, 1, B, (size_t)1 << 20, ET_LINALG_SVD) == ET_ENOMEM &&
                    et_linalg_band_lsq(X, &rank, A, &zero, 0, 1, 1, B, 1, ET_LINALG_QR) == ET_EINVAL &&
                    et_linalg_band_lsq(X, &rank, A, &zero, 1, 1, 0, B, 1, ET_LINALG_QR) == ET_EINVAL &&
                    et_linalg_band_lsq(X, &rank, A, &zero, 1, 1, 2, B, 1, ET_LINALG_QR) == ET_EINVAL &&
                    et_linalg_band_lsq(X, &rank, A, &zero, 1, 1, 1, B, 0, ET_LINALG_QR) == ET_EINVAL &&
                    et_linalg_band_lsq(X, &rank, A, &zero, 1, 1, 1, B, 1, (et_linalg_method)3) == ET_EINVAL;

    return gen_check(g, ok && X[0] == 3 && rank == 7, "bad arguments");
}

/* What a status says, and how X came out: the same for dense and banded. */
static bool judged(gen *g, et_status status, size_t rank, size_t exact, const double *X, const double *A, size_t m, size_t n, const double *B,
                   size_t k, et_linalg_method method)
{
    const bool full = exact == n;

    gen_label(g, full ? "full rank" : "deficient");
    if (!gen_check(g, rank == exact, "method %d: rank %zu, not %zu", (int)method, rank, exact))
        return false;
    if (!full && method != ET_LINALG_SVD)
        return gen_check(g, status == ET_ERANK && X[0] == 3 && X[n * k - 1] == 3, "deficient: status %d", (int)status);
    return gen_check(g, status == ET_OK && X[n * k] == 3, "status %d", (int)status) && optimal(g, X, A, m, n, B, k);
}

verdict prop_linalg_lsq(gen *g)
{
    const size_t m = gen_between(g, 1, M - 3), n = gen_between(g, 1, N), k = gen_between(g, 1, K);
    const et_linalg_method method = (et_linalg_method)gen_upto(g, 2);
    const int scale = gen_chance(g, 3) ? 200 : gen_chance(g, 3) ? -200 : 0;
    double A[M * N], B[M * K], X[N * K + 1], z[N] = {0}, S[M * N];
    size_t rank = 99;
    bool planted = n > 1 && gen_chance(g, 3);

    for (size_t i = 0; i < m * n; i++)
        A[i] = integer(g, 3);
    for (size_t i = 0; i < m * k; i++)
        B[i] = integer(g, 20);
    for (size_t j = 0; planted && j + 1 < n; j++)
        z[j] = integer(g, 2);
    for (size_t i = 0; planted && i < m; i++) {
        A[i * n + n - 1] = 0;
        for (size_t j = 0; j + 1 < n; j++)
            A[i * n + n - 1] += z[j] * A[i * n + j];
    }
    z[n - 1] = -1;
    for (size_t i = 0; i <= n * k; i++)
        X[i] = 3;
    const size_t exact = exact_rank(A, m, n);
    et_status status = et_linalg_lsq(X, &rank, A, m, n, B, k, method);
    if (!lsq_refuses(g) || !judged(g, status, rank, exact, X, A, m, n, B, k, method))
        return FAIL;
    if (planted && method == ET_LINALG_SVD && exact > 0 && !least_norm(g, X, A, m, n, exact, z, k))
        return FAIL;
    if (status == ET_OK && exact == n) { /* A scaled by 2^s: the solution is 2^-s times as large. */
        for (size_t i = 0; i < m * n; i++)
            S[i] = ldexp(A[i], scale);
        status = et_linalg_lsq(X, &rank, S, m, n, B, k, method);
        for (size_t i = 0; i < n * k; i++)
            X[i] = ldexp(X[i], scale);
        if (!gen_check(g, status == ET_OK, "scaled: status %d", (int)status) || !optimal(g, X, A, m, n, B, k))
            return FAIL;
    }
    return PASS;
}

/* G = A'B by rows of length n and k. */
static void cross(double *G, const double *A, size_t m, size_t n, const double *B, size_t k)
{
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < k; j++) {
            double sum = 0;
            for (size_t e = 0; e < m; e++)
                sum += A[e * n + i] * B[e * k + j];
            G[i * k + j] = sum;
        }
}

/* R'R = A'A and R'C = A'B hold whatever the signs of R's rows.  R and C are exact for A, B perturbed by at most c u (theorem 19.4 of the same book),
 * so each product is within 2 c u |A| |A|, |A| |B|, and C has no more than B's length. */
verdict prop_linalg_qr(gen *g)
{
    const size_t n = gen_between(g, 1, N), m = gen_between(g, n, M), k = gen_upto(g, K);
    double A[M * N], B[M * K], R[N * N + 1], C[N * K + 1], G[N * N], H[N * N];

    for (size_t i = 0; i < m * n; i++)
        A[i] = gen_real(g, -4, 4);
    for (size_t i = 0; i < m * k; i++)
        B[i] = gen_real(g, -4, 4);
    R[0] = C[0] = R[n * n] = C[n * k] = 5;
    const double a = norm(A, m * n), b = norm(B, m * k), c = 16 * (double)((m + 1) * n) * ET_UNIT;
    if (!gen_check(g, et_linalg_qr(R, C, A, m, 0, B, k) == ET_EINVAL && et_linalg_qr(R, C, A, n - 1, n, B, k) == ET_EINVAL && R[0] == 5 && C[0] == 5,
                   "bad arguments") ||
        !gen_check(g, et_linalg_qr(R, C, A, m, n, B, k) == ET_OK && R[n * n] == 5 && C[n * k] == 5, "made"))
        return FAIL;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < i; j++)
            if (!gen_check(g, R[i * n + j] == 0, "R below its diagonal"))
                return FAIL;
    cross(G, A, m, n, A, n);
    cross(H, R, n, n, R, n);
    for (size_t i = 0; i < n * n; i++)
        if (!gen_check(g, fabs(G[i] - H[i]) <= c * a * a, "R'R: %a, A'A: %a", H[i], G[i]))
            return FAIL;
    cross(G, A, m, n, B, k);
    cross(H, R, n, n, C, k);
    for (size_t i = 0; i < n * k; i++)
        if (!gen_check(g, fabs(G[i] - H[i]) <= c * a * b, "R'C: %a, A'B: %a", H[i], G[i]))
            return FAIL;
    return gen_check(g, norm(C, n * k) <= b * (1 + c), "C longer than B") ? PASS : FAIL;
}

verdict prop_linalg_band_lsq(gen *g)
{
    const size_t n = gen_between(g, 1, N), w = gen_between(g, 1, n), m = gen_between(g, 1, M), k = gen_chance(g, 8) ? BIG_K : gen_between(g, 1, K);
    const et_linalg_method method = (et_linalg_method)gen_upto(g, 2);
    double a[M * N], A[M * N] = {0}, B[M * BIG_K], X[N * BIG_K + 1];
    size_t start[M], rank = 99;

    for (size_t i = 0; i < m; i++) {
        const size_t least = i > 0 ? start[i - 1] : 0;
        start[i] = least + gen_upto(g, n - w - least > 1 ? 1 : n - w - least);
        for (size_t j = 0; j < w; j++)
            A[i * n + start[i] + j] = a[i * w + j] = integer(g, 3);
        for (size_t j = 0; j < k; j++)
            B[i * k + j] = j < K ? integer(g, 20) : (double)((i * 7 + j * 5) % 23);
    }
    for (size_t i = 0; i <= n * k; i++)
        X[i] = 3;
    const size_t first = start[0];
    start[0] = n - w + 1;
    et_status status = et_linalg_band_lsq(X, &rank, a, start, m, n, w, B, k, method);
    if (!lsq_refuses(g) || !gen_check(g, status == ET_EINVAL && X[0] == 3 && rank == 99, "a row past the last column"))
        return FAIL;
    start[0] = first;
    if (m > 1 && first < start[m - 1]) {
        start[0] = start[m - 1] == n - w ? n - w : start[m - 1];
        if (start[1] < start[0] &&
            !gen_check(g, et_linalg_band_lsq(X, &rank, a, start, m, n, w, B, k, method) == ET_EINVAL && X[0] == 3, "starts that decrease"))
            return FAIL;
        start[0] = first;
    }
    status = et_linalg_band_lsq(X, &rank, a, start, m, n, w, B, k, method);
    gen_label(g, k == BIG_K ? "strips" : "one strip");
    return judged(g, status, rank, exact_rank(A, m, n), X, A, m, n, B, k, method) ? PASS : FAIL;
}

/* Longer bands: entries of a partition of unity over many rows, against the dense solution by another method's code.  Both gradients vanish, so
 * the difference is at most the sum of both backward errors over the least singular value, which normal equations' inverse bounds. */
verdict prop_linalg_band_lsq_long(gen *g)
{
    enum { ROWS = 40, COLUMNS = 12 };
    const size_t w = gen_between(g, 2, 4), n = gen_between(g, w, COLUMNS), m = gen_between(g, n, ROWS), k = gen_between(g, 1, K);
    double a[ROWS * 4], A[ROWS * COLUMNS] = {0}, B[ROWS * K], X[COLUMNS * K], Y[COLUMNS * K], I[COLUMNS * COLUMNS] = {0}, V[COLUMNS * COLUMNS],
                                 G[COLUMNS * COLUMNS];
    size_t start[ROWS], rank = 0;

    for (size_t i = 0; i < m; i++) {
        start[i] = i * (n - w + 1) / m;
        for (size_t j = 0; j < w; j++)
            A[i * n + start[i] + j] = a[i * w + j] = 0.0625 + gen_real(g, 0, 1);
        for (size_t j = 0; j < k; j++)
            B[i * k + j] = gen_real(g, -4, 4);
    }
    const et_status dense = et_linalg_lsq(Y, &rank, A, m, n, B, k, ET_LINALG_QR);
    if (dense != ET_OK)
        return et_linalg_band_lsq(X, &rank, a, start, m, n, w, B, k, ET_LINALG_QR) == ET_OK ? FAIL : SKIP;
    for (size_t i = 0; i < n; i++)
        I[i * n + i] = 1;
    cross(G, A, m, n, A, n);
    if (et_linalg_lsq(V, &rank, G, n, n, I, n, ET_LINALG_QR) != ET_OK)
        return SKIP;
    const double inverse = sqrt(norm(V, n * n)), condition = norm(A, m * n) * inverse, c = 32 * (double)((m + n) * (n + 1)) * ET_UNIT;
    const double bound = c * condition * (1 + condition) * (norm(Y, n * k) + inverse * norm(B, m * k));
    for (size_t method = 0; method < 2; method++) {
        if (method == 1 && c * condition * condition > 0.01)
            break;
        if (!gen_check(g, et_linalg_band_lsq(X, &rank, a, start, m, n, w, B, k, (et_linalg_method)method) == ET_OK && rank == n, "made"))
            return FAIL;
        for (size_t i = 0; i < n * k; i++)
            if (!gen_check(g, fabs(X[i] - Y[i]) <= bound, "method %zu: %g, dense %g, bound %g", method, X[i], Y[i], bound))
                return FAIL;
    }
    return PASS;
}

/* Rows: method m n k, A, B; wanted: rank, X. */
verdict gold_linalg_lsq(const row *r)
{
    const size_t m = row_size(r, 1), n = row_size(r, 2), k = row_size(r, 3);
    double A[256], B[64], X[64];
    size_t rank = 0;
    bool ok;

    for (size_t i = 0; i < m * n; i++)
        A[i] = row_real(r, 4 + i);
    for (size_t i = 0; i < m * k; i++)
        B[i] = row_real(r, 4 + m * n + i);
    const et_status status = et_linalg_lsq(X, &rank, A, m, n, B, k, (et_linalg_method)row_size(r, 0));
    ok = row_is_size(r, 0, rank);
    if (r->nwant == 1)
        return ok && status == ET_ERANK ? PASS : FAIL;
    for (size_t i = 0; ok && i < n * k; i++)
        ok = row_is(r, 1 + i, X[i]);
    return ok && status == ET_OK ? PASS : FAIL;
}

/* Rows: m n k, A, B; wanted: R's rows with non-negative diagonal, and C with the same signs. */
verdict gold_linalg_qr(const row *r)
{
    const size_t m = row_size(r, 0), n = row_size(r, 1), k = row_size(r, 2);
    double A[256], B[64], R[64], C[64];
    bool ok;

    for (size_t i = 0; i < m * n; i++)
        A[i] = row_real(r, 3 + i);
    for (size_t i = 0; i < m * k; i++)
        B[i] = row_real(r, 3 + m * n + i);
    ok = et_linalg_qr(R, C, A, m, n, B, k) == ET_OK;
    for (size_t i = 0; ok && i < n; i++) {
        const double sign = R[i * n + i] < 0 ? -1 : 1;
        for (size_t j = 0; ok && j < n; j++)
            ok = row_is(r, i * n + j, sign * R[i * n + j]);
        for (size_t j = 0; ok && j < k; j++)
            ok = row_is(r, n * n + i * k + j, sign * C[i * k + j]);
    }
    return ok ? PASS : FAIL;
}

/* Rows: method m n w k, start, a, B; wanted: rank, X. */
verdict gold_linalg_band_lsq(const row *r)
{
    const size_t m = row_size(r, 1), n = row_size(r, 2), w = row_size(r, 3), k = row_size(r, 4);
    double a[256], B[256], X[64];
    size_t start[64], rank = 0;
    bool ok;

    for (size_t i = 0; i < m; i++)
        start[i] = row_size(r, 5 + i);
    for (size_t i = 0; i < m * w; i++)
        a[i] = row_real(r, 5 + m + i);
    for (size_t i = 0; i < m * k; i++)
        B[i] = row_real(r, 5 + m + m * w + i);
    const et_status status = et_linalg_band_lsq(X, &rank, a, start, m, n, w, B, k, (et_linalg_method)row_size(r, 0));
    ok = row_is_size(r, 0, rank);
    if (r->nwant == 1)
        return ok && status == ET_ERANK ? PASS : FAIL;
    for (size_t i = 0; ok && i < n * k; i++)
        ok = row_is(r, 1 + i, X[i]);
    return ok && status == ET_OK ? PASS : FAIL;
}
