/* The second computation of an enclosure: its systems, their verified factors, the solution of a column and its radii. */
#include "etalon/fit/linalg.h"
#include "fit/enclosure_again.h"
#include <string.h>

/* ---- systems ---- */

/* The last interval that begins at x or before; of the end of the domain the last that is not empty. */
static size_t interval(const double *u, size_t n, size_t p, double x)
{
    size_t span = p;

    for (size_t i = p; i < n; i++)
        if (u[i] < u[i + 1] && u[i] <= x)
            span = i;
    return span;
}

/* N_{i,k}(x) by Cox and de Boor. */
static et_dd recursion(const double *u, size_t i, size_t k, double x, size_t span)
{
    et_dd lower, sum = whole(0);

    if (i > span || i + k < span)
        return sum;
    if (k == 0)
        return whole(1);
    lower = recursion(u, i, k - 1, x, span);
    if (i + k > span)
        sum = et_dd_mul(et_dd_two_sum(x, -u[i]), et_dd_div(lower, et_dd_two_sum(u[i + k], -u[i])));
    lower = recursion(u, i + 1, k - 1, x, span);
    if (i + 1 <= span)
        sum = et_dd_add(sum, et_dd_mul(et_dd_two_sum(u[i + k + 1], -x), et_dd_div(lower, et_dd_two_sum(u[i + k + 1], -u[i + 1]))));
    return sum;
}

size_t again_alone(const double *u, size_t n, size_t p, double x)
{
    size_t alone = n;

    for (size_t i = 0; i < n; i++)
        if (u[i + 1] == x && u[i + p] == x && (x < u[n] || alone == n))
            alone = i;
    return alone;
}

/* N_j(x). */
static et_dd function(const double *u, size_t n, size_t p, size_t j, double x)
{
    const size_t alone = again_alone(u, n, p, x);

    return alone < n ? whole(j == alone) : recursion(u, j, p, x, interval(u, n, p, x));
}

static void no_weights(again_system *s)
{
    for (size_t i = 0; i < NODES; i++)
        s->weight[i] = s->share[i] = 1;
}

void again_direction(again_system *s, const double *t, size_t m, const double *u, size_t n, size_t p, bool inner)
{
    const size_t skip = inner;

    memset(s, 0, sizeof *s);
    no_weights(s);
    s->rows = s->tall = m - 2 * skip;
    s->columns = n - 2 * skip;
    s->width = p + 1;
    s->relative = 26 * (double)p * U2;
    for (size_t i = 0; i < s->rows; i++) {
        const double x = t[i + skip];
        const size_t first = interval(u, n, p, x) - p;
        for (size_t k = 0; k <= p; k++)
            if (first + k >= skip && first + k < n - skip) {
                s->at[i * s->width + k] = first + k - skip;
                s->a[i * s->width + k] = function(u, n, p, first + k, x);
            }
    }
}

void again_product(again_system *s, const again_system *U, const again_system *V, const size_t *number, size_t columns)
{
    size_t count[NODES] = { 0 };

    memset(s, 0, sizeof *s);
    no_weights(s);
    s->rows = U->rows * V->rows;
    s->columns = columns;
    s->width = U->width * V->width;
    s->relative = U->relative + V->relative + 8 * U2;
    for (size_t e = 0; e < s->rows * s->width; e++) {
        const size_t i = e / s->width, k = e % s->width;
        const size_t a = i / V->rows * U->width + k / V->width, b = i % V->rows * V->width + k % V->width;
        const size_t c = number[U->at[a] * V->columns + V->at[b]];
        if (c == LEFT_OUT)
            continue;
        s->at[e] = c;
        s->a[e] = et_dd_mul(U->a[a], V->a[b]);
        count[c] += s->a[e].hi != 0;
        s->tall = count[c] > s->tall ? count[c] : s->tall;
    }
}

/* ---- verified factors ---- */

static double upper_part(const again_system *s, size_t i, size_t j)
{
    double a = 0;

    for (size_t k = 0; k < s->width; k++)
        if (s->at[i * s->width + k] == j && s->a[i * s->width + k].hi != 0)
            a = s->a[i * s->width + k].hi;
    return a;
}

static double greatest_entry(const again_system *s)
{
    double most = 0;

    for (size_t i = 0; i < s->columns; i++)
        for (size_t j = 0; j < s->columns; j++)
            most = fmax(most, fabs(s->T[i][j]));
    return most > 0 ? most : 1;
}

/* y = S A'W A S x, or S^-1 T T'S^-1 x over the square of T's greatest entry, S being 1 / sqrt(share). */
static void operate(double *y, const double *x, const again_system *s, bool inverse)
{
    const size_t n = s->columns;
    double z[NODES] = { 0 };

    memset(y, 0, n * sizeof *y);
    if (!inverse) {
        for (size_t i = 0; i < s->rows; i++) {
            double sum = 0;
            for (size_t j = 0; j < n; j++)
                sum += upper_part(s, i, j) * x[j] / sqrt(s->share[j]);
            for (size_t j = 0; j < n; j++)
                y[j] += s->weight[i] * sum * upper_part(s, i, j) / sqrt(s->share[j]);
        }
        return;
    }
    const double unit = greatest_entry(s);
    for (size_t i = 0; i < n; i++)
        for (size_t j = i; j < n; j++)
            z[j] += s->T[i][j] / unit * x[i] * sqrt(s->share[i]);
    for (size_t i = 0; i < n; i++) {
        for (size_t j = i; j < n; j++)
            y[i] += s->T[i][j] / unit * z[j];
        y[i] *= sqrt(s->share[i]);
    }
}

static double power(const again_system *s, bool inverse)
{
    static const double steps[7] = { 0, 0.5 / 7, 1.0 / 7, 1.5 / 7, 2.0 / 7, 2.5 / 7, 3.0 / 7 };
    double x[NODES], y[NODES], value = 0;

    for (size_t j = 0; j < s->columns; j++)
        x[j] = 1 + steps[j % 7] + (j % 2 ? -0.25 : 0.25);
    for (int k = 0; k < 40; k++) {
        double square = 0;
        for (size_t j = 0; j < s->columns; j++)
            square += x[j] * x[j];
        for (size_t j = 0; j < s->columns && square > 0; j++)
            x[j] /= sqrt(square);
        operate(y, x, s, inverse);
        value = 0;
        for (size_t j = 0; j < s->columns; j++)
            value += x[j] * y[j];
        memcpy(x, y, sizeof x);
    }
    return sqrt(fabs(value));
}

/* T = R^-1: false where R has a zero in its diagonal. */
static et_status factor(again_system *s)
{
    const size_t n = s->columns;
    static double A[NODES * NODES], R[NODES * NODES];
    et_status status;

    for (size_t i = 0; i < s->rows; i++)
        for (size_t j = 0; j < n; j++)
            A[i * n + j] = sqrt(s->weight[i]) * upper_part(s, i, j);
    status = et_linalg_qr(R, R, A, s->rows, n, A, 0);
    for (size_t i = n; status == ET_OK && i-- > 0;) {
        if (R[i * n + i] == 0)
            return ET_ENOCONV;
        for (size_t j = i; j < n; j++) {
            s->T[i][j] = i == j;
            for (size_t k = i + 1; k <= j; k++)
                s->T[i][j] -= R[i * n + k] == 0 ? 0 : R[i * n + k] * s->T[k][j];
            s->T[i][j] /= R[i * n + i];
        }
    }
    return status;
}

/* B = A T and E, its error. */
static void multiply(double B[NODES][NODES], double E[NODES][NODES], const again_system *s)
{
    const double w = (double)s->width, most = greatest_entry(s);

    for (size_t i = 0; i < s->rows; i++)
        for (size_t j = 0; j < s->columns; j++) {
            double sum = 0, size = 0;
            for (size_t c = 0; c <= j; c++) {
                const double a = upper_part(s, i, c);
                sum += a == 0 ? 0 : a * s->T[c][j];
                size += a == 0 ? 0 : a * fabs(s->T[c][j]);
            }
            B[i][j] = sum;
            E[i][j] = (w + 8) * 0x1p-53 * size + 2 * w * TINY * (1 + most);
        }
}

/* The greatest row sum of |I - B'W B|, with all errors. */
static double from_identity(const again_system *s, double B[NODES][NODES], double E[NODES][NODES])
{
    const size_t n = s->columns, m = s->rows;
    double most = 0;

    for (size_t j = 0; j < n; j++) {
        double x = 0, sum = 0;
        for (size_t k = 0; k < n; k++) {
            const size_t lo = j < k ? j : k, hi = j < k ? k : j;
            double h = 0;
            for (size_t i = 0; i < m; i += 4) {
                double q[4] = { 0 };
                for (size_t e = 0; e < 4 && i + e < m; e++)
                    q[e] = s->weight[i + e] * B[i + e][lo] * B[i + e][hi];
                h += (q[0] + q[1]) + (q[2] + q[3]);
            }
            x += fabs((j == k) - h);
        }
        for (size_t i = 0; i < m; i++) {
            double b = 0, e = 0;
            for (size_t k = 0; k < n; k++) {
                b += fabs(B[i][k]);
                e += E[i][k];
            }
            sum += fabs(B[i][j]) * (s->weight[i] * (((double)m + 4) * 0x1p-53 * b + e)) + E[i][j] * (s->weight[i] * (b + e));
        }
        x = (x + sum) * (1 + ((double)(2 * n + 2 * m + 16) + 2) * 0x1p-52) + TINY;
        most = x <= most ? most : x;
    }
    return most;
}

et_status again_verify(again_system *s)
{
    static double B[NODES][NODES], E[NODES][NODES];
    et_status status = factor(s);
    double distance;

    s->norm = power(s, false);
    if (status != ET_OK)
        return status;
    s->inverse = greatest_entry(s) * power(s, true);
    multiply(B, E, s);
    distance = from_identity(s, B, E);
    if (!(distance <= 0.5))
        return ET_ENOCONV;
    s->defect = distance / (1 - distance) * (1 + 0x1p-50);
    for (size_t i = 0; i < s->rows; i++)
        for (size_t j = 0; j < s->columns; j++)
            s->C[i][j] = (fabs(B[i][j]) + E[i][j]) * (1 + 0x1p-52);
    return ET_OK;
}

/* ---- columns ---- */

/* r, g and z of x; returns the greatest |z_j|, NaN if one is. */
static double residuals(double *z, again_system *s, const et_dd *d, const et_dd *x)
{
    double most = 0;

    memset(s->g, 0, sizeof s->g);
    for (size_t i = 0; i < s->rows; i++) {
        s->r[i] = d[i];
        for (size_t e = i * s->width; e < (i + 1) * s->width; e++)
            s->r[i] = et_dd_sub(s->r[i], et_dd_mul(s->a[e], x[s->at[e]]));
        for (size_t e = i * s->width; e < (i + 1) * s->width; e++)
            s->g[s->at[e]] = et_dd_add(s->g[s->at[e]], et_dd_mul(s->a[e], (et_dd){ s->weight[i] * s->r[i].hi, s->weight[i] * s->r[i].lo }));
    }
    for (size_t j = 0; j < s->columns; j++) {
        et_dd sum = whole(0);
        for (size_t i = 0; i <= j; i++)
            sum = et_dd_add(sum, et_dd_mul(whole(s->T[i][j]), s->g[i]));
        z[j] = sum.hi;
        most = fabs(z[j]) <= most ? most : fabs(z[j]);
    }
    return most;
}

/* q: the residual's error.  v: the gradient's. */
static void errors(double *q, double *v, const again_system *s, const et_dd *d, const double *error, const et_dd *x)
{
    const double w = (double)s->width, terms = (4 * (w + 1) + 8) * U2, tall = s->relative + (4 * ((double)s->tall + 1) + 8) * U2;

    memset(v, 0, s->columns * sizeof *v);
    for (size_t i = 0; i < s->rows; i++) {
        const double r = s->weight[i] * fabs(s->r[i].hi);
        double sum = 0, most = 0;
        for (size_t e = i * s->width; e < (i + 1) * s->width; e++) {
            sum += s->a[e].hi * fabs(x[s->at[e]].hi);
            most = fmax(most, fabs(x[s->at[e]].hi));
            v[s->at[e]] += s->a[e].hi * r * tall + 2 * TINY * (1 + r);
        }
        q[i] = (error[i] + (terms * fabs(d[i].hi) + (terms + s->relative) * sum)) * (1 + (w + 8) * 0x1p-52) + 2 * w * TINY * (1 + most);
    }
    for (size_t j = 0; j < s->columns; j++)
        v[j] *= 1 + ((double)s->rows * w + 8) * 0x1p-52;
}

void again_column(et_dd *x, double *radius, again_system *s, const et_dd *d, const double *error)
{
    const size_t n = s->columns, m = s->rows;
    const double c = (4 * ((double)n + 1) + 8) * U2, inflate = 1 + ((double)m + 2 * (double)n + 16) * 0x1p-51;
    double z[NODES], q[NODES], v[NODES], before = HUGE_VAL, now, most = 0;
    bool zero = true;

    memset(x, 0, n * sizeof *x);
    memset(radius, 0, n * sizeof *radius);
    for (size_t i = 0; i < m; i++)
        zero = zero && d[i].hi == 0 && error[i] == 0;
    if (n == 0 || zero)
        return;
    for (now = residuals(z, s, d, x); now <= before / 2 && now != 0; now = residuals(z, s, d, x)) {
        for (size_t i = 0; i < n; i++) {
            double step = 0;
            for (size_t j = i; j < n; j++)
                step += s->T[i][j] * z[j];
            x[i] = et_dd_add(x[i], whole(step));
        }
        before = now;
    }
    errors(q, v, s, d, error, x);
    for (size_t j = 0; j < n; j++) {
        z[j] = fabs(z[j]) + TINY;
        for (size_t i = 0; i <= j; i++)
            z[j] += fabs(s->T[i][j]) * (c * fabs(s->g[i].hi) + v[i]);
        for (size_t i = 0; i < m; i++)
            z[j] += s->C[i][j] * (s->weight[i] * q[i]);
        most = z[j] <= most ? most : z[j];
    }
    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (size_t j = i; j < n; j++)
            sum += fabs(s->T[i][j]) * (z[j] + s->defect * most);
        radius[i] = sum * inflate + TINY;
    }
}

/* ---- systems by themselves ---- */

static bool same_system(gen *g, const enclosure_system *s, const again_system *want)
{
    bool ok = gen_check(g, s->rows == want->rows && s->columns == want->columns && s->width == want->width && s->tall == want->tall &&
                               s->relative == want->relative,
                        "%zu rows, %zu columns, width %zu, %zu entries in a column, relative %a", s->rows, s->columns, s->width, s->tall, s->relative);

    for (size_t e = 0; ok && e < s->rows * s->width; e++)
        ok = gen_check(g, s->at[e] == want->at[e] && same_dd(s->a[e], want->a[e]), "entry %zu: %zu, %a, not %zu, %a", e, s->at[e], s->a[e].hi,
                       want->at[e], want->a[e].hi);
    return ok;
}

static bool same_factors(gen *g, const enclosure_system *s, const again_system *want)
{
    bool ok = gen_check(g, s->defect == want->defect && s->norm == want->norm && s->inverse == want->inverse, "defect %a, norms %a %a, not %a %a %a",
                        s->defect, s->norm, s->inverse, want->defect, want->norm, want->inverse);

    for (size_t i = 0; ok && i < s->rows; i++)
        for (size_t j = 0; j < s->columns; j++)
            ok = gen_check(g, s->C[i * s->columns + j] == want->C[i][j], "C[%zu][%zu] %a, not %a", i, j, s->C[i * s->columns + j], want->C[i][j]) &&
                 gen_check(g, i >= s->columns || s->T[i * s->columns + j] == want->T[i][j], "T[%zu][%zu]", i, j) && ok;
    return ok;
}

/* Right-hand sides of any size, past the greatest double too. */
static bool same_columns(gen *g, enclosure_system *s, again_system *want)
{
    static const int units[] = { 0, 0, 0, -538, -1000, -1060, 500, 990, 1023 };
    const int unit = units[gen_upto(g, 8)];
    const double lost = ldexp(1, unit - (int)gen_between(g, 20, 110));
    et_dd d[NODES], x[NODES], y[NODES];
    double error[NODES], r[NODES], q[NODES];
    bool ok = true;

    for (size_t i = 0; i < s->rows; i++) {
        d[i] = gen_chance(g, 4) ? whole(0) : whole(ldexp(gen_real(g, -1, 1), unit));
        d[i].lo = gen_chance(g, 2) ? d[i].hi * 0x1p-54 * gen_real(g, -1, 1) : 0;
        error[i] = gen_chance(g, 2) ? lost : 0;
    }
    enclosure_column(x, r, s, d, error);
    again_column(y, q, want, d, error);
    for (size_t j = 0; j < s->columns; j++)
        ok = gen_check(g, same_dd(x[j], y[j]) && same(r[j], q[j]), "unit 2^%d, column %zu: %a within %a, not %a within %a", unit, j, x[j].hi, r[j],
                       y[j].hi, q[j]) && ok;
    return ok;
}

static bool verified_again(gen *g, enclosure_system *s, again_system *want)
{
    et_status wanted, status;
    bool ok = same_system(g, s, want);

    for (size_t i = 0; i < s->rows; i++)
        s->weight[i] = want->weight[i] = (double)gen_between(g, 1, 2);
    for (size_t j = 0; j < s->columns; j++)
        s->share[j] = want->share[j] = (double)gen_between(g, 1, 2);
    wanted = again_verify(want);
    status = enclosure_verify(s);
    ok = ok && gen_check(g, status == wanted, "status %d, not %d", (int)status, (int)wanted);
    gen_label(g, wanted == ET_OK ? "proved" : "no bound");
    if (ok && status == ET_OK)
        ok = same_factors(g, s, want) && same_columns(g, s, want) && same_columns(g, s, want);
    return ok;
}

/* A direction, whole or inner, or the product of both directions with some numbers left out. */
verdict prop_enclosure_make_system(gen *g)
{
    static again_system a, b, c;
    enclosure_system U, V, s = { 0 };
    size_t number[NODES] = { 0 }, mine[NODES] = { 0 }, count = 0;
    again_case k;
    bool ok = true, inner[2];

    again_draw_frame(g, &k);
    const et_surface *v = &k.fit.shell.view[0];
    for (size_t e = 0; e < 2; e++) {
        const size_t n = e ? v->nv : v->nu, m = e ? k.fit.data.ny : k.fit.data.nx;
        inner[e] = n > 2 && gen_chance(g, 3);
        if (m > 3 && gen_chance(g, 3)) /* where proofs begin to fail */
            k.t[0][e][2] = fmin(k.t[0][e][3], k.t[0][e][1] + ldexp(gen_real(g, 1, 2), -(int)gen_between(g, 40, 52)));
        if (again_rank(k.t[0][e], m, k.u[0][e], n, e ? v->q : v->p, false) < n)
            return SKIP;
    }
    again_tell(g, &k);
    again_direction(&a, k.t[0][0], k.fit.data.nx, v->u, v->nu, v->p, inner[0]);
    again_direction(&b, k.t[0][1], k.fit.data.ny, v->v, v->nv, v->q, inner[1]);
    if (enclosure_direction(&U, k.t[0][0], k.fit.data.nx, v->u, v->nu, v->p, inner[0]) != ET_OK)
        return FAIL;
    if (enclosure_direction(&V, k.t[0][1], k.fit.data.ny, v->v, v->nv, v->q, inner[1]) != ET_OK)
        return FAIL;
    ok = same_system(g, &U, &a) && same_system(g, &V, &b);
    for (size_t l = 0; l < U.columns * V.columns; l++) {
        const bool out = gen_chance(g, 6);
        number[l] = out ? SIZE_MAX : count;
        mine[l] = out ? LEFT_OUT : count;
        count += !out;
    }
    if (ok && count > 0 && gen_chance(g, 2)) {
        again_product(&c, &a, &b, mine, count);
        ok = enclosure_product(&s, &U, &V, number, count) == ET_OK && verified_again(g, &s, &c);
        enclosure_system_free(&s);
    } else if (ok) {
        ok = verified_again(g, &U, &a);
    }
    enclosure_system_free(&U);
    enclosure_system_free(&V);
    ok = gen_check(g, s.at == NULL && s.a == NULL && s.weight == NULL && s.T == NULL && s.C == NULL && s.work == NULL && s.rows == 0 && s.norm == 0,
                   "freed") && ok;
    return ok ? PASS : FAIL;
}
