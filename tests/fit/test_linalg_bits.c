/* linalg computed a second time, entry by entry and bit for bit; what its condition numbers decide; what is too large for it. */
#include "etalon/base/real.h"
#include "etalon/fit/linalg.h"
#include "fit/fence.h"
#include "fit/linalg_parts.h"
#include "gen.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 14, COLUMNS = 6, RIGHT = 131, WIDE = 24 };

/* ---- the frozen order of operations, one matrix entry at a time: Q is written out -------------------------------------------- */

/* Rows of equal start, t of them under the rows s .. s + w - 1 of R: H[c] = I - tau[c] (1, v[c])(1, v[c])'. */
typedef struct {
    double tau[COLUMNS], v[COLUMNS][ROWS];
} reflections;

static double longest(double alpha, const double *v, size_t t)
{
    double scale = fabs(alpha);

    for (size_t i = 0; i < t; i++)
        scale = fmax(scale, fabs(v[i]));
    return scale;
}

static double reflected(double *tau, double alpha, double *v, size_t t)
{
    const double scale = longest(alpha, v, t);
    double sum, beta;

    *tau = 0;
    if (scale == 0)
        return alpha;
    sum = (alpha / scale) * (alpha / scale);
    for (size_t i = 0; i < t; i++)
        sum += (v[i] / scale) * (v[i] / scale);
    beta = scale * sqrt(sum);
    beta = alpha > 0 ? -beta : beta;
    for (size_t i = 0; i < t; i++)
        v[i] = v[i] / (alpha - beta);
    *tau = (beta - alpha) / beta;
    return beta;
}

/* One block into R (n x n, full); M (t x w) is used up. */
static void block_of(reflections *h, double R[COLUMNS][COLUMNS], double M[ROWS][COLUMNS], size_t s, size_t t, size_t w)
{
    for (size_t c = 0; c < w; c++) {
        for (size_t i = 0; i < t; i++)
            h->v[c][i] = M[i][c];
        R[s + c][s + c] = reflected(&h->tau[c], R[s + c][s + c], h->v[c], t);
        for (size_t e = c + 1; e < w; e++) {
            double dot = R[s + c][s + e];
            for (size_t i = 0; i < t; i++)
                dot += h->v[c][i] * M[i][e];
            dot *= h->tau[c];
            for (size_t i = 0; i < t; i++)
                M[i][e] -= h->v[c][i] * dot;
            R[s + c][s + e] -= dot;
        }
    }
}

/* The first w rows of H_w ... H_1: top (w x w) for the rows of R, q (w x t) for the new ones. */
static void product(double top[COLUMNS][COLUMNS], double q[COLUMNS][ROWS], const reflections *h, size_t t, size_t w)
{
    for (size_t r = 0; r < w; r++) {
        for (size_t c = 0; c < w; c++)
            top[r][c] = r == c;
        for (size_t i = 0; i < t; i++)
            q[r][i] = 0;
        for (size_t c = w; c-- > 0;) {
            double dot = top[r][c];
            for (size_t i = 0; i < t; i++)
                dot += h->v[c][i] * q[r][i];
            dot *= h->tau[c];
            for (size_t i = 0; i < t; i++)
                q[r][i] -= h->v[c][i] * dot;
            top[r][c] -= dot;
        }
    }
}

typedef struct {
    size_t m, n, w, k, start[ROWS];
    double a[ROWS * COLUMNS], *B;
    double R[COLUMNS][COLUMNS], C[COLUMNS][RIGHT], X[COLUMNS][RIGHT];
} system_;

/* The right-hand sides of one block: four data rows at a time. */
static void project(system_ *s, double top[COLUMNS][COLUMNS], double q[COLUMNS][ROWS], size_t first, size_t t)
{
    const size_t at = s->start[first];

    for (size_t x = 0; x < s->k; x++) {
        double made[COLUMNS];
        for (size_t r = 0; r < s->w; r++) {
            double sum = 0;
            size_t i = 0;
            for (size_t c = 0; c < s->w; c++)
                sum += top[r][c] * s->C[at + c][x];
            for (; i + 4 <= t; i += 4) {
                const double *b = s->B + (first + i) * s->k + x;
                sum += (q[r][i] * b[0] + q[r][i + 1] * b[s->k]) + (q[r][i + 2] * b[2 * s->k] + q[r][i + 3] * b[3 * s->k]);
            }
            for (; i < t; i++)
                sum += q[r][i] * s->B[(first + i) * s->k + x];
            made[r] = sum;
        }
        for (size_t r = 0; r < s->w; r++)
            s->C[at + r][x] = made[r];
    }
}

static void second_time(system_ *s)
{
    double M[ROWS][COLUMNS], top[COLUMNS][COLUMNS], q[COLUMNS][ROWS];
    reflections h;

    memset(s->R, 0, sizeof s->R);
    memset(s->C, 0, sizeof s->C);
    for (size_t first = 0, t; first < s->m; first += t) {
        for (t = 0; first + t < s->m && s->start[first + t] == s->start[first]; t++)
            for (size_t c = 0; c < s->w; c++)
                M[t][c] = s->a[(first + t) * s->w + c];
        block_of(&h, s->R, M, s->start[first], t, s->w);
        product(top, q, &h, t, s->w);
        project(s, top, q, first, t);
    }
    for (size_t x = 0; x < s->k; x++)
        for (size_t i = s->n; i-- > 0;) {
            double y = s->C[i][x];
            for (size_t c = 1; c < s->w && i + c < s->n; c++)
                y += -s->R[i][i + c] * s->X[i + c][x];
            s->X[i][x] = y * (1 / s->R[i][i]);
        }
}

static double drawn(gen *g, bool sparse)
{
    if (!sparse)
        return gen_real(g, -4, 4);
    const double x = (double)gen_upto(g, 3) - 1;
    return x > 1 ? 0 : x;
}

/* The right-hand sides: few choices for many columns. */
static void draw_right(gen *g, system_ *s, bool sparse)
{
    double few[16];

    for (size_t i = 0; i < 16; i++)
        few[i] = drawn(g, sparse);
    for (size_t i = 0; i < s->m * s->k; i++)
        s->B[i] = s->k <= 4 ? drawn(g, sparse) : few[(i * i + i / 7) % 16] + (sparse ? 0 : (double)i);
}

static void draw(gen *g, system_ *s, fence *f)
{
    static const size_t sizes[] = {1, 2, 3, 63, 64, 65, 127, 128, 129, 131};
    const bool sparse = gen_upto(g, 1), large = gen_chance(g, 4);

    s->n = gen_between(g, 1, COLUMNS);
    s->w = gen_between(g, 1, s->n);
    s->m = gen_between(g, s->n, ROWS);
    s->k = sizes[large ? gen_between(g, 3, 9) : gen_upto(g, 2)];
    s->B = fence_doubles(f, s->m * s->k);
    for (size_t i = 0; i < s->m; i++) {
        s->start[i] = gen_upto(g, 2) == 0 ? i * (s->n - s->w + 1) / s->m : gen_upto(g, s->n - s->w);
        if (i > 0 && s->start[i] < s->start[i - 1])
            s->start[i] = s->start[i - 1];
        for (size_t c = 0; c < s->w; c++)
            s->a[i * s->w + c] = drawn(g, sparse);
    }
    if (s->B != NULL)
        draw_right(g, s, sparse);
}

static bool same(gen *g, const char *what, const double *got, const double *want, size_t row, size_t k)
{
    for (size_t x = 0; x < k; x++)
        if (!gen_check(g, got[x] == want[x] || (isnan(got[x]) && isnan(want[x])), "%s(%zu, %zu) = %a, a second time %a", what, row, x, got[x],
                       want[x]))
            return false;
    return true;
}

verdict prop_linalg_band_lsq_bits(gen *g)
{
    static system_ s;
    static fence right, left;
    size_t rank = 99;

    draw(g, &s, &right);
    double *X = fence_doubles(&left, s.n * s.k);
    if (s.B == NULL || X == NULL)
        return gen_check(g, false, "no fences") ? PASS : FAIL;
    const et_status status = et_linalg_band_lsq(X, &rank, s.a, s.start, s.m, s.n, s.w, s.B, s.k, ET_LINALG_QR);
    gen_label(g, status == ET_OK ? "solved" : "deficient");
    second_time(&s);
    for (size_t i = 0; status == ET_OK && i < s.n; i++)
        if (!same(g, "X", X + i * s.k, s.X[i], i, s.k))
            return FAIL;
    if (status == ET_OK && et_linalg_band_lsq(X, &rank, s.a, s.start, s.m, s.n, s.w, s.B, s.k, ET_LINALG_CHOLESKY) == ET_OK)
        for (size_t i = 0; i < s.n * s.k; i++)
            if (!gen_check(g, isfinite(X[i]), "Cholesky's X[%zu]", i))
                return FAIL;
    return gen_check(g, rank == s.n || status == ET_ERANK, "rank %zu", rank) ? PASS : FAIL;
}

verdict prop_linalg_qr_bits(gen *g)
{
    static system_ s;
    static fence right, left, square;

    draw(g, &s, &right);
    s.w = s.n;
    memset(s.start, 0, sizeof s.start);
    for (size_t i = 0; i < s.m * s.n; i++)
        s.a[i] = drawn(g, i % 2);
    double *C = fence_doubles(&left, s.n * s.k), *R = fence_doubles(&square, s.n * s.n);
    if (s.B == NULL || C == NULL || R == NULL)
        return gen_check(g, false, "no fences") ? PASS : FAIL;
    if (!gen_check(g, et_linalg_qr(R, C, s.a, s.m, s.n, s.B, s.k) == ET_OK, "made"))
        return FAIL;
    second_time(&s);
    for (size_t i = 0; i < s.n; i++)
        if (!same(g, "R", R + i * s.n, s.R[i], i, s.n) || !same(g, "C", C + i * s.k, s.C[i], i, s.k))
            return FAIL;
    /* Without right-hand sides: the same R. */
    memset(R, 0x41, s.n * s.n * sizeof *R);
    if (!gen_check(g, et_linalg_qr(R, NULL, s.a, s.m, s.n, NULL, 0) == ET_OK, "R alone"))
        return FAIL;
    for (size_t i = 0; i < s.n; i++)
        if (!same(g, "R", R + i * s.n, s.R[i], i, s.n))
            return FAIL;
    return PASS;
}

/* ---- what is singular --------------------------------------------------------------------------------------------------------- */

/* A = (a b; 0 d) over rows of zeros, the columns in either order: A'A and its Cholesky factor are exact, since b and a are powers of two (or 0) and
 * d a multiple of 2^-26, and so are both norms, in the estimate too: 2 x 2.  A dense matrix' norm is taken as it is, of a band twice the half rows.
 */
static bool judged_singular(double a, double b, double d, size_t m, bool banded)
{
    const double aa = a * a, ab = fabs(a * b), bb = b * b + d * d, inverse = fmax(aa + ab, bb + ab) / (aa * d * d);
    const double norm = banded ? 2 * fmax(aa + ab, bb) : fmax(aa + ab, bb + ab);

    return !(1 / (inverse * norm) > (double)m * ET_EPS);
}

static bool near_threshold(double a, double b, double d, size_t m, bool banded)
{
    return judged_singular(a, b, d * (1 + 0x1p-20), m, banded) != judged_singular(a, b, d * (1 - 0x1p-20), m, banded);
}

verdict prop_linalg_band_lsq_singular(gen *g)
{
    static const double firsts[] = {1, 0.25, 4, 0x1p-10}, offs[] = {0, 1, -1, 0.5, -0.5};
    const double a = firsts[gen_upto(g, 3)], b = offs[gen_upto(g, 4)], d = (double)gen_between(g, 1, 24) * 0x1p-26;
    const int scale = (int)gen_upto(g, 2) * 8 - 8;
    const size_t m = gen_between(g, 2, WIDE);
    double A[2 * WIDE] = {0}, B[WIDE] = {0}, X[2];
    size_t start[WIDE] = {0}, rank;

    A[0] = ldexp(a, scale);
    A[1] = ldexp(b, scale);
    A[3] = ldexp(d, scale);
    for (int banded = 0; banded < 2; banded++) {
        if (near_threshold(a, b, d, m, banded))
            continue;
        rank = 9;
        const et_status status = banded ? et_linalg_band_lsq(X, &rank, A, start, m, 2, 2, B, 1, ET_LINALG_CHOLESKY)
                                        : et_linalg_lsq(X, &rank, A, m, 2, B, 1, ET_LINALG_CHOLESKY);
        const bool singular = judged_singular(a, b, d, m, banded);
        gen_label(g, singular ? "singular" : "regular");
        /* Of A itself the second column is far from dependent. */
        if (!gen_check(g, status == (singular ? ET_ERANK : ET_OK) && rank == (singular ? 1 : 2),
                       "banded %d, a %g b %g d %g m %zu: status %d, rank %zu", banded, a, b, d, m, (int)status, rank))
            return FAIL;
    }
    return PASS;
}

/* Diagonals, in any order: the condition number is exact, and m eps itself is singular. */
verdict prop_linalg_lsq_singular(gen *g)
{
    const size_t n = gen_between(g, 2, 4), m = gen_between(g, n, WIDE), least = gen_upto(g, n - 1);
    const et_linalg_method method = (et_linalg_method)gen_upto(g, 1);
    const bool edge = m == 16 || m == 4;
    const double d = method == ET_LINALG_QR ? (edge ? (double)m : (double)gen_between(g, 1, 40)) * 0x1p-52
                     : edge                 ? sqrt((double)m) * 0x1p-26
                                            : (double)gen_between(g, 1, 8) * 0x1p-26;
    const double c = method == ET_LINALG_QR ? d : d * d;
    double A[4 * WIDE] = {0}, a[WIDE] = {0}, B[WIDE] = {0}, X[4];
    size_t start[WIDE], rank = 9;

    for (size_t i = 0; i < m; i++)
        start[i] = i < n ? i : n - 1;
    for (size_t i = 0; i < n; i++)
        A[i * n + i] = a[i] = i == least ? d : 1;
    const bool singular = !(c > (double)m * ET_EPS);
    et_status status = et_linalg_lsq(X, &rank, A, m, n, B, 1, method);
    const bool kept = d > (double)m * ET_EPS; /* of r(i, i), the greatest being 1 */
    const size_t told = singular ? n - 1 : n;
    gen_label(g, singular ? "singular" : "regular");
    if (!gen_check(g, status == (singular ? ET_ERANK : ET_OK) && rank == told, "method %d, c %a, m %zu: status %d, rank %zu (%d)", (int)method, c, m,
                   (int)status, rank, kept))
        return FAIL;
    rank = 9;
    status = et_linalg_band_lsq(X, &rank, a, start, m, n, 1, B, 1, method);
    const bool banded = method == ET_LINALG_QR ? singular : !(c / 2 > (double)m * ET_EPS);
    return gen_check(g, status == (banded ? ET_ERANK : ET_OK) && rank == (banded ? n - 1 : n), "band: method %d, c %a, m %zu: status %d, rank %zu",
                     (int)method, c, m, (int)status, rank)
               ? PASS
               : FAIL;
}

/* A third column of zeros: the rank counts what exceeds max(m, n) eps times the greatest. */
verdict prop_linalg_lsq_rank(gen *g)
{
    const size_t tall = gen_between(g, 3, WIDE), m = gen_upto(g, 1) ? 2 : tall, n = m == 2 ? tall : 3;
    const double factor = 0.25 + (double)gen_upto(g, 64);
    const double d = factor * ET_EPS, scale = ldexp(1, (int)gen_upto(g, 20) - 10);
    double A[3 * WIDE] = {0}, B[WIDE] = {0}, X[WIDE];
    size_t rank = 9;

    A[0] = scale;
    A[n + 1] = d * scale;
    const et_status status = et_linalg_lsq(X, &rank, A, m, n, B, 1, ET_LINALG_QR);
    const size_t want = factor > (double)(m > n ? m : n) ? 2 : 1;
    return gen_check(g, status == ET_ERANK && rank == want, "%zu x %zu, %g eps: status %d, rank %zu, not %zu", m, n, factor, (int)status, rank, want)
               ? PASS
               : FAIL;
}

/* ---- what is too large -------------------------------------------------------------------------------------------------------- */

/* One case in 1000. */
verdict prop_linalg_lsq_fits(gen *g)
{
    const size_t most = INT_MAX;
    const bool fit = linalg_fits(0, 0) && linalg_fits(0, most) && linalg_fits(most, 0) && linalg_fits(1, most) && linalg_fits(most, 1) &&
                     linalg_fits(46340, 46341) && linalg_fits(7, most / 7) && linalg_fits(most / 7, 7);
    const bool not = !linalg_fits(0, most + 1) && !linalg_fits(most + 1, 0) && !linalg_fits(1, most + 1) && !linalg_fits(most + 1, 1) &&
                     !linalg_fits(2, most) && !linalg_fits(most, 2) && !linalg_fits(46341, 46341) && !linalg_fits(7, most / 7 + 1) &&
                     !linalg_fits(most / 7 + 1, 7) && !linalg_fits((size_t)1 << 32, (size_t)1 << 32);

    return gen_check(g, fit, "refused") && gen_check(g, not, "accepted") ? PASS : FAIL;
}

/* Sizes whose products are small again when they wrap. */
/* One case in 1000. */
verdict prop_linalg_band_lsq_large(gen *g)
{
    enum { SIDE = 1 << 16 };
    const size_t wraps = SIZE_MAX / 8 + 1; /* times 8 it is 0 */
    static double a[SIDE], X[1];
    static size_t start[SIDE];
    size_t rank = 7;
    linalg_band f;
    bool ok;

    ok = gen_check(g, linalg_band_new(&f, wraps, 8, 8) == ET_ENOMEM, "m w wraps");
    ok = gen_check(g, linalg_band_new(&f, 8, wraps + 8, 8) == ET_ENOMEM, "n w wraps") && ok;
    ok = gen_check(g, linalg_band_new(&f, 1, 1024, 1024) == ET_OK, "a block of a million") && ok;
    if (ok)
        linalg_band_free(&f);
    X[0] = 3;
    for (size_t i = 0; i < SIDE; i++)
        start[i] = i;
    /* Dense it has 2^32 entries. */
    ok = gen_check(g, et_linalg_band_lsq(X, &rank, a, start, SIDE, SIDE, 1, a, 1, ET_LINALG_SVD) == ET_ENOMEM && X[0] == 3 && rank == 7,
                   "a dense band") &&
         ok;
    ok = gen_check(g, et_linalg_band_lsq(X, &rank, a, start, SIDE, SIDE, 1, a, 1, ET_LINALG_QR) == ET_ENOMEM && X[0] == 3 && rank == 7, "its rank") &&
         ok;
    ok = gen_check(g, linalg_deficient(&rank, a, SIDE, SIDE) == ET_ENOMEM && rank == 7, "the rank of a matrix") && ok;
    ok = gen_check(g, linalg_lsq_svd(X, &rank, a, SIDE, SIDE, a, 1) == ET_ENOMEM && X[0] == 3 && rank == 7, "least norm") && ok;
    ok = gen_check(g, linalg_lsq_cholesky(X, &rank, a, 1, SIDE, a, 1) == ET_ENOMEM && X[0] == 3 && rank == 7, "normal equations") && ok;
    ok = gen_check(g, linalg_lsq_cholesky(X, &rank, a, 1, 1, a, wraps) == ET_ENOMEM && X[0] == 3 && rank == 7, "their right-hand sides") && ok;
    ok = gen_check(g, et_linalg_qr(X, X, a, SIDE, 1, a, SIDE) == ET_ENOMEM && X[0] == 3, "right-hand sides") && ok;
    ok = gen_check(g, et_linalg_qr(X, X, a, SIDE, SIDE, a, 1) == ET_ENOMEM && X[0] == 3, "a square") && ok;
    return gen_check(g, et_linalg_lsq(X, &rank, a, SIDE, 1, a, SIDE, ET_LINALG_QR) == ET_ENOMEM && X[0] == 3 && rank == 7, "a wide solution") && ok
               ? PASS
               : FAIL;
}
