/* The terms of an enclosure one by one: what a verified system and its columns say is compared with the formulas of their headers, computed in
 * rationals from the factors at hand.  A term that is missing, or less than it says, is seen even where rounding errors leave room. */
#include "ascending.h"
#include "etalon/base/real.h"
#include "fit/enclosure_parts.h"
#include "gen.h"
#include <arf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FUNCTIONS = 6, SITES = 9, NUMBERS = 16, ROWS = 36 };

/* s += a b c.  All numbers are whole numbers times powers of two: exact. */
static void add3(arf_t s, double a, double b, double c)
{
    arf_t x, y;

    arf_init(x);
    arf_init(y);
    arf_set_d(x, a);
    arf_set_d(y, b);
    arf_mul(x, x, y, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_set_d(y, c);
    arf_addmul(s, x, y, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_clear(x);
    arf_clear(y);
}

/* s += a b q. */
static void add_multiple(arf_t s, double a, double b, const arf_t q)
{
    arf_t x;

    arf_init(x);
    add3(x, a, b, 1);
    arf_addmul(s, x, q, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_clear(x);
}

static void plus(arf_t s, const arf_t q)
{
    arf_add(s, s, q, ARF_PREC_EXACT, ARF_RND_DOWN);
}

/* low <= x <= low (1 + slack). */
static bool between(const arf_t low, double x, double slack)
{
    arf_t high;
    bool ok;

    arf_init(high);
    arf_set(high, low);
    add_multiple(high, slack, 1, low);
    ok = isfinite(x) && arf_cmp_d(low, x) <= 0 && arf_cmp_d(high, x) >= 0;
    arf_clear(high);
    return ok;
}

static double about(const arf_t q)
{
    return arf_get_d(q, ARF_RND_NEAR);
}

static arf_ptr numbers(size_t n)
{
    arf_ptr x = malloc((n + 1) * sizeof *x);

    for (size_t i = 0; x && i < n; i++)
        arf_init(x + i);
    return x;
}

static void forget(arf_ptr x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        arf_clear(x + i);
    free(x);
}

/* ---- a system ---- */

/* A direction of full rank, or false. */
static bool any_direction(gen *g, enclosure_system *s, size_t most)
{
    double u[2 * FUNCTIONS + 2], t[SITES];
    const size_t p = gen_between(g, 1, 3), n = p + 1 + gen_upto(g, most - 4), m = n + gen_upto(g, 2);

    gen_knots(g, u, n + p + 1, p);
    for (size_t i = 0; i < m; i++)
        t[i] = i == 0 ? 0 : i + 1 == m ? 1 : gen_real(g, 0, 1);
    ascending(t, m);
    if (enclosure_rank(u, n, p, t, m, 0) < n || enclosure_direction(s, t, m, u, n, p, 0) != ET_OK)
        return false;
    if (s->relative == 26 * (double)p * 0x1p-106 && s->tall == m && s->width == p + 1)
        return true;
    enclosure_system_free(s);
    return false;
}

/* Two directions' product, with weights; some corners left out. */
static bool any_product(gen *g, enclosure_system *s)
{
    enclosure_system U, V;
    size_t number[NUMBERS], count = 0;
    bool made;

    if (!any_direction(g, &U, 4))
        return false;
    if (!any_direction(g, &V, 4)) {
        enclosure_system_free(&U);
        return false;
    }
    const size_t n = U.columns * V.columns;
    for (size_t k = 0; k < n; k++)
        number[k] = k == 0 && gen_chance(g, 3) ? SIZE_MAX : count++;
    made = enclosure_product(s, &U, &V, number, count) == ET_OK;
    if (made && s->relative != U.relative + V.relative + 8 * 0x1p-106) {
        enclosure_system_free(s);
        made = false;
    }
    for (size_t i = 0; made && i < s->rows; i++)
        s->weight[i] = (double)gen_between(g, 1, 2);
    for (size_t j = 0; made && j < s->columns; j++)
        s->share[j] = (double)gen_between(g, 1, 2);
    enclosure_system_free(&U);
    enclosure_system_free(&V);
    return made;
}

static double entry(const enclosure_system *s, size_t i, size_t j)
{
    double sum = 0;

    for (size_t k = 0; k < s->width; k++)
        if (s->at[i * s->width + k] == j && s->a[i * s->width + k].hi != 0)
            sum += s->a[i * s->width + k].hi;
    return sum;
}

/* ---- what verification says ---- */

/* B = fl(A T), sums from the left; E its distance from A T: (w + 8) u A|T| and what underflow costs. */
static void product(double *B, arf_ptr E, const enclosure_system *s)
{
    const size_t n = s->columns;
    const double w = (double)s->width;
    double most = 0;

    for (size_t k = 0; k < n * n; k++)
        most = fmax(most, fabs(s->T[k]));
    for (size_t i = 0; i < s->rows; i++)
        for (size_t j = 0; j < n; j++) {
            double sum = 0, size = 0;
            for (size_t k = 0; k < s->width; k++) {
                const size_t c = s->at[i * s->width + k];
                const double a = s->a[i * s->width + k].hi, t = c <= j ? s->T[c * n + j] : 0;
                sum += a * t;
                size += a * fabs(t);
            }
            B[i * n + j] = sum;
            arf_zero(E + i * n + j);
            add3(E + i * n + j, w + 8, 0x1p-53, size);
            add3(E + i * n + j, 2 * w, 0x1p-1000, 1 + (most > 0 ? most : 1));
        }
}

/* The row sums of |I - B'W B|, and of what the product's error adds: low.  H's own roundings: (m + 4) u |B|'W|B|, twice of which is in `more`. */
static bool defect_is_right(gen *g, const enclosure_system *s, const double *B, const arf_ptr E)
{
    const size_t n = s->columns, m = s->rows;
    arf_t most, room, sum, x, y;
    bool ok;

    arf_init(most), arf_init(room), arf_init(sum), arf_init(x), arf_init(y);
    for (size_t j = 0; j < n; j++) {
        double loose = 0;
        arf_zero(sum);
        for (size_t k = 0; k < n; k++) {
            arf_set_ui(x, k == j);
            for (size_t i = 0; i < m; i++) {
                add3(x, -s->weight[i], B[i * n + j], B[i * n + k]);
                loose += s->weight[i] * fabs(B[i * n + j]) * fabs(B[i * n + k]);
            }
            arf_abs(x, x);
            plus(sum, x);
            for (size_t i = 0; i < m; i++) {
                add_multiple(sum, s->weight[i], fabs(B[i * n + j]), E + i * n + k);
                add_multiple(sum, s->weight[i], fabs(B[i * n + k]), E + i * n + j);
                arf_mul(y, E + i * n + j, E + i * n + k, ARF_PREC_EXACT, ARF_RND_DOWN);
                add_multiple(sum, s->weight[i], 1, y);
            }
        }
        arf_set_d(x, 2.001 * ((double)m + 4) * 0x1p-53 * loose + 0x1p-990);
        arf_set(room, j == 0 || arf_cmp(x, room) > 0 ? x : room);
        arf_set(most, j == 0 || arf_cmp(sum, most) > 0 ? sum : most);
    }
    /* delta = defect / (1 + defect) is at least `most`, and at most `room` more. */
    arf_one(y);
    add3(y, s->defect, 1, 1);
    arf_mul(x, most, y, ARF_PREC_EXACT, ARF_RND_DOWN);
    plus(most, room);
    arf_mul(y, most, y, ARF_PREC_EXACT, ARF_RND_DOWN);
    add_multiple(y, 0x1p-40, 1, y);
    ok = gen_check(g, arf_cmp_d(x, s->defect) <= 0 && arf_cmp_d(y, s->defect) >= 0, "defect %a", s->defect);
    arf_clear(most), arf_clear(room), arf_clear(sum), arf_clear(x), arf_clear(y);
    return ok;
}

/* ---- norms ---- */

/* The greatest eigenvalue of a symmetric matrix by Jacobi's rotations. */
static double greatest_eigenvalue(double A[NUMBERS][NUMBERS], size_t n)
{
    double most = 0;

    for (int sweep = 0; sweep < 12; sweep++)
        for (size_t p = 0; p < n; p++)
            for (size_t q = p + 1; q < n; q++) {
                const double theta = (A[q][q] - A[p][p]) / (2 * A[p][q]);
                const double t = A[p][q] == 0 ? 0 : (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
                const double c = 1 / sqrt(t * t + 1), s = t * c;
                for (size_t k = 0; k < n; k++) {
                    const double x = A[k][p], y = A[k][q];
                    A[k][p] = c * x - s * y;
                    A[k][q] = s * x + c * y;
                }
                for (size_t k = 0; k < n; k++) {
                    const double x = A[p][k], y = A[q][k];
                    A[p][k] = c * x - s * y;
                    A[q][k] = s * x + c * y;
                }
            }
    for (size_t p = 0; p < n; p++)
        most = fmax(most, A[p][p]);
    return most;
}

/* Of unknowns that share[j] views have, each counted in its own: the matrix is A diag(1 / sqrt(share)).  Power methods come from below; forty steps
 * are short of the square by at most ln(n / cos^2) / 80 of it, less than a fifth unless the beginning is nearly orthogonal to the eigenvector (its
 * cosine below 1/700): an estimate may be, but these few matrices are not. */
static bool norms_are_right(gen *g, const enclosure_system *s)
{
    static double G[NUMBERS][NUMBERS], H[NUMBERS][NUMBERS];
    const size_t n = s->columns;

    for (size_t j = 0; j < n; j++)
        for (size_t k = 0; k < n; k++) {
            const double root = sqrt(s->share[j]) * sqrt(s->share[k]);
            double sum = 0, product = 0;
            for (size_t i = 0; i < s->rows; i++)
                sum += s->weight[i] * entry(s, i, j) * entry(s, i, k);
            for (size_t i = j > k ? j : k; i < n; i++)
                product += s->T[j * n + i] * s->T[k * n + i];
            G[j][k] = sum / root;
            H[j][k] = product * root;
        }
    const double norm = sqrt(greatest_eigenvalue(G, n)), inverse = sqrt(greatest_eigenvalue(H, n));
    return gen_check(g, s->norm <= norm * (1 + 0x1p-30) && s->norm >= 0.9 * norm, "norm %g, not %g", s->norm, norm) &&
           gen_check(g, s->inverse <= inverse * (1 + 0x1p-30) && s->inverse >= 0.9 * inverse, "inverse %g, not %g", s->inverse, inverse);
}

static bool verified(gen *g, const enclosure_system *s)
{
    static double B[ROWS * NUMBERS];
    const size_t entries = s->rows * s->columns;
    arf_ptr E = numbers(entries);
    arf_t c;
    bool ok = true;

    arf_init(c);
    product(B, E, s);
    for (size_t e = 0; ok && e < entries; e++) {
        /* Four roundings of E, which has room for them; two of the sum, and a factor that makes good for them but for u^2. */
        arf_zero(c);
        add3(c, fabs(B[e]), 1, 1);
        add3(c, fabs(B[e]), -0x1p-90, 1);
        add_multiple(c, 1 - 0x1p-50, 1, E + e);
        ok = gen_check(g, between(c, s->C[e], 0x1p-49), "C is |A T| and its error: entry %zu, %a", e, s->C[e]);
    }
    ok = ok && defect_is_right(g, s, B, E) && norms_are_right(g, s);
    arf_clear(c);
    forget(E, entries);
    return ok;
}

/* ---- what a column says ---- */

/* q_i: the residual's error. */
static void residual_error(arf_ptr q, const enclosure_system *s, const et_dd *d, const double *error, const et_dd *x)
{
    const double w = (double)s->width, rounding = (4 * (w + 1) + 8) * 0x1p-106;

    for (size_t i = 0; i < s->rows; i++) {
        double most = 0;
        arf_zero(q + i);
        add3(q + i, error[i], 1, 1);
        add3(q + i, rounding, fabs(d[i].hi), 1);
        for (size_t k = 0; k < s->width; k++) {
            const double y = fabs(x[s->at[i * s->width + k]].hi);
            add3(q + i, rounding + s->relative, s->a[i * s->width + k].hi, y);
            most = fmax(most, y);
        }
        add3(q + i, 2 * w, 0x1p-1000, 1 + most);
    }
}

/* v_j: the gradient's error; z_j = |T'g|, its roundings and v passed through |T|', q through C'W. */
static void zeta_of(arf_ptr zeta, const enclosure_system *s, const arf_ptr q)
{
    const size_t n = s->columns;
    const double factor = s->relative + (4 * ((double)s->tall + 1) + 8) * 0x1p-106, c = (4 * ((double)n + 1) + 8) * 0x1p-106;
    arf_ptr v = numbers(n);
    arf_t x;

    arf_init(x);
    for (size_t i = 0; i < s->rows; i++)
        for (size_t k = 0; k < s->width; k++) {
            const double r = s->weight[i] * fabs(s->r[i].hi);
            add3(v + s->at[i * s->width + k], s->a[i * s->width + k].hi, r, factor);
            add3(v + s->at[i * s->width + k], 2, 0x1p-1000, 1 + r);
        }
    for (size_t j = 0; j < n; j++) {
        arf_zero(x);
        for (size_t i = 0; i <= j; i++) {
            add3(x, s->T[i * n + j], s->g[i].hi, 1);
            add3(x, s->T[i * n + j], s->g[i].lo, 1);
        }
        arf_abs(zeta + j, x);
        add3(zeta + j, 0x1p-1000, 1, 1);
        for (size_t i = 0; i <= j; i++) {
            arf_set(x, v + i);
            add3(x, c, fabs(s->g[i].hi), 1);
            add_multiple(zeta + j, fabs(s->T[i * n + j]), 1, x);
        }
        for (size_t i = 0; i < s->rows; i++)
            add_multiple(zeta + j, s->C[i * n + j], s->weight[i], q + i);
    }
    arf_clear(x);
    forget(v, n);
}

/* radius_i = sum_j |T_ij| (zeta_j + defect max zeta), and what the code adds for its own roundings: (m + 2n + 16) 2^-51 here, (m w + 8) 2^-52 in v
 * and (w + 8) 2^-52 in q; they are less than that themselves, so that twice of it is let through. */
static bool radii_are_right(gen *g, const enclosure_system *s, const double *radius, const arf_ptr zeta)
{
    const size_t n = s->columns;
    arf_t most, sum, x;
    const double slack = 2 * (((double)(s->rows + 2 * n) + 16) * 0x1p-51 + ((double)((s->rows + 1) * s->width) + 16) * 0x1p-52);
    bool ok = true;

    arf_init(most), arf_init(sum), arf_init(x);
    for (size_t j = 0; j < n; j++)
        arf_set(most, arf_cmp(zeta + j, most) > 0 ? zeta + j : most);
    for (size_t i = 0; ok && i < n; i++) {
        arf_zero(sum);
        for (size_t j = i; j < n; j++) {
            arf_set(x, zeta + j);
            add_multiple(x, s->defect, 1, most);
            add_multiple(sum, fabs(s->T[i * n + j]), 1, x);
        }
        add3(sum, 0x1p-1000, 1, 1);
        ok = gen_check(g, between(sum, radius[i], slack), "radius %zu: %a, not %a and a little", i, radius[i], about(sum));
    }
    arf_clear(most), arf_clear(sum), arf_clear(x);
    return ok;
}

/* A x = d within the radii: the solver's answer for an x of small whole numbers, where d is exact. */
static bool solves(gen *g, enclosure_system *s)
{
    static const double scales[] = { 1, 1, 0x1p-960, 0x1p-1010, 0x1p-1060, 0x1p300 };
    et_dd d[ROWS], x[NUMBERS];
    double error[ROWS], radius[NUMBERS];
    const double scale = scales[gen_upto(g, 5)];
    arf_ptr q = numbers(s->rows), zeta = numbers(s->columns);
    bool ok, zero = true;

    for (size_t i = 0; i < s->rows; i++) {
        const double hi = scale * gen_real(g, -1, 1);
        d[i] = (et_dd){ hi, gen_chance(g, 2) ? hi * 0x1p-54 * gen_real(g, -1, 1) : 0 };
        error[i] = gen_chance(g, 3) ? scale * 0x1p-90 * gen_real(g, 0, 1) : 0;
        zero = zero && hi == 0 && error[i] == 0;
    }
    enclosure_column(x, radius, s, d, error);
    if (zero)
        for (ok = true; ok && zero; zero = false)
            for (size_t j = 0; j < s->columns; j++)
                ok = ok && x[j].hi == 0 && x[j].lo == 0 && radius[j] == 0;
    else {
        residual_error(q, s, d, error, x);
        zeta_of(zeta, s, q);
        ok = radii_are_right(g, s, radius, zeta);
    }
    forget(q, s->rows);
    forget(zeta, s->columns);
    return gen_check(g, ok, "scale %a, %zu rows, %zu columns", scale, s->rows, s->columns);
}

verdict prop_enclosure_make_bound(gen *g)
{
    enclosure_system s;
    size_t tall = 0;
    bool ok;

    if (!(gen_chance(g, 2) ? any_product(g, &s) : any_direction(g, &s, FUNCTIONS)))
        return SKIP;
    for (size_t j = 0; j < s.columns; j++) {
        size_t count = 0;
        for (size_t i = 0; i < s.rows; i++)
            count += entry(&s, i, j) > 0;
        tall = count > tall ? count : tall;
    }
    ok = gen_check(g, s.tall >= tall && s.tall <= s.rows, "%zu entries in a column, %zu", tall, s.tall);
    const et_status status = enclosure_verify(&s);
    if (status == ET_OK)
        ok = ok && verified(g, &s) && solves(g, &s) && solves(g, &s);
    enclosure_system_free(&s);
    return !ok || (status != ET_OK && status != ET_ENOCONV) ? FAIL : status == ET_OK ? PASS : SKIP;
}
