/* Everything an enclosure says, computed a second time: the formulas of docs/enclosure.md ("In numbers") in the order told there, with the basis
 * functions by the recursion of Cox and de Boor, matrices whole, sums without skipping anything.  The same operations in the same order give the same
 * bits on every processor, so that radii, norms, backward errors, statuses and messages must be equal and not only near. */
#include "etalon/fit/linalg.h"
#include "fit/enclosure_parts.h"
#include "fit/fit_parts.h"
#include "gen.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 5, NODES = SIDE * SIDE, KNOTS = 2 * SIDE, LEFT_OUT = 999 };

static const double TINY = 0x1p-1000, U2 = 0x1p-106;

/* ---- systems ---- */

typedef struct {
    size_t rows, columns, width, tall;
    size_t at[NODES * NODES]; /* of the row's entries; 0 for those that are left out */
    et_dd a[NODES * NODES];
    double weight[NODES], share[NODES], relative;
    double T[NODES][NODES], C[NODES][NODES], defect, norm, inverse;
    et_dd r[NODES], g[NODES];
} matrix;

static bool same(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

static bool same_dd(et_dd a, et_dd b)
{
    return same(a.hi, b.hi) && same(a.lo, b.lo);
}

static et_dd whole(double x)
{
    return (et_dd){ x, 0 };
}

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

/* Where x is a knot p times or more, the function that is 1 there: of those that could be the last, at the end of the domain the first; else n. */
static size_t alone_at(const double *u, size_t n, size_t p, double x)
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
    const size_t alone = alone_at(u, n, p, x);

    return alone < n ? whole(j == alone) : recursion(u, j, p, x, interval(u, n, p, x));
}

static void no_weights(matrix *s)
{
    for (size_t i = 0; i < NODES; i++)
        s->weight[i] = s->share[i] = 1;
}

static void direction(matrix *s, const double *t, size_t m, const double *u, size_t n, size_t p, bool inner)
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

static void product(matrix *s, const matrix *U, const matrix *V, const size_t *number, size_t columns)
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

static double upper_part(const matrix *s, size_t i, size_t j)
{
    double a = 0;

    for (size_t k = 0; k < s->width; k++)
        if (s->at[i * s->width + k] == j && s->a[i * s->width + k].hi != 0)
            a = s->a[i * s->width + k].hi;
    return a;
}

static double greatest_entry(const matrix *s)
{
    double most = 0;

    for (size_t i = 0; i < s->columns; i++)
        for (size_t j = 0; j < s->columns; j++)
            most = fmax(most, fabs(s->T[i][j]));
    return most > 0 ? most : 1;
}

/* y = S A'W A S x, or S^-1 T T'S^-1 x over the square of T's greatest entry, S being 1 / sqrt(share). */
static void operate(double *y, const double *x, const matrix *s, bool inverse)
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

static double power(const matrix *s, bool inverse)
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
static et_status factor(matrix *s)
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
static void multiply(double B[NODES][NODES], double E[NODES][NODES], const matrix *s)
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
static double from_identity(const matrix *s, double B[NODES][NODES], double E[NODES][NODES])
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

static et_status verify(matrix *s)
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
static double residuals(double *z, matrix *s, const et_dd *d, const et_dd *x)
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
static void errors(double *q, double *v, const matrix *s, const et_dd *d, const double *error, const et_dd *x)
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

static void solve_column(et_dd *x, double *radius, matrix *s, const et_dd *d, const double *error)
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

/* ---- approaches ---- */

typedef struct {
    et_dd x[2][3 * NODES];
    double radius[2][3 * NODES], norm, inverse;
    char text[sizeof ((et_message *)0)->text];
} answer;

static const char *const names[3] = { "bottom view", "top view", "both views" };

static bool on_border(et_doublenet n, size_t i, size_t j)
{
    return i == 0 || j == 0 || i + 1 == n.nx || j + 1 == n.ny;
}

static bool at_corner(et_doublenet n, size_t i, size_t j)
{
    return (i == 0 || i + 1 == n.nx) && (j == 0 || j + 1 == n.ny);
}

/* The datum at the corner of the node (i, j) of the control net; all corners are border, and the bottom view's. */
static double corner_datum(const enclosure_job *k, size_t i, size_t j, size_t c)
{
    return k->D[0][3 * ((i ? k->data.nx - 1 : 0) * k->data.ny + (j ? k->data.ny - 1 : 0)) + c];
}

static et_status unbounded(answer *x, size_t name, double norm, double inverse)
{
    snprintf(x->text, sizeof x->text, "%s: no bound can be given in twice the working precision; the condition number is about %.1g", names[name],
             norm * inverse);
    return ET_ENOCONV;
}

static void norms_of(answer *x, double norm, double inverse)
{
    x->norm = fmax(x->norm, norm);
    x->inverse = fmax(x->inverse, inverse);
}

static void both_directions(matrix *U, matrix *V, const enclosure_job *k, size_t w, bool inner)
{
    const et_surface *s = &k->fit->shell.view[w];

    direction(U, k->fit->s[w], k->data.nx, s->u, s->nu, s->p, inner);
    direction(V, k->fit->r[w], k->data.ny, s->v, s->nv, s->q, inner);
}

/* P = U+ D (V+)' for a grid of data, direction u first. */
static et_status by_directions(et_dd *P, double *radius, answer *x, const enclosure_job *k, size_t w, bool inner, const et_dd *D, const double *error)
{
    static matrix U, V;
    static et_dd X[3 * NODES];
    static double e[3 * NODES];
    et_dd d[NODES], p[NODES];
    double off[NODES], r[NODES];
    const size_t name = inner ? 2 : w;
    bool finite = true;

    both_directions(&U, &V, k, w, inner);
    if (verify(&U) != ET_OK)
        return unbounded(x, name, U.norm, U.inverse);
    if (verify(&V) != ET_OK)
        return unbounded(x, name, U.norm * (V.norm > 0 ? V.norm : 1), U.inverse * (V.inverse > 0 ? V.inverse : 1));
    for (size_t j = 0; j < V.rows; j++)
        for (size_t c = 0; c < 3; c++) {
            for (size_t i = 0; i < U.rows; i++) {
                d[i] = D[3 * (i * V.rows + j) + c];
                off[i] = error[3 * (i * V.rows + j) + c];
            }
            solve_column(p, r, &U, d, off);
            for (size_t a = 0; a < U.columns; a++) {
                X[3 * (a * V.rows + j) + c] = p[a];
                e[3 * (a * V.rows + j) + c] = r[a];
                finite = finite && isfinite(r[a]) && isfinite(p[a].hi);
            }
        }
    for (size_t a = 0; finite && a < U.columns; a++)
        for (size_t c = 0; c < 3; c++) {
            for (size_t j = 0; j < V.rows; j++) {
                d[j] = X[3 * (a * V.rows + j) + c];
                off[j] = e[3 * (a * V.rows + j) + c];
            }
            solve_column(p, r, &V, d, off);
            for (size_t b = 0; b < V.columns; b++) {
                P[3 * (a * V.columns + b) + c] = p[b];
                radius[3 * (a * V.columns + b) + c] = r[b];
                finite = finite && isfinite(r[b]) && isfinite(p[b].hi);
            }
        }
    if (!finite)
        return unbounded(x, name, U.norm * V.norm, U.inverse * V.inverse);
    norms_of(x, U.norm * V.norm, U.inverse * V.inverse);
    return ET_OK;
}

/* What the corners that stand take from the data, and what it may be off. */
static void without_corners(et_dd *d, double *error, const enclosure_job *k, const matrix *U, const matrix *V, size_t c)
{
    for (size_t i = 0; i < k->data.nx; i++)
        for (size_t j = 0; j < k->data.ny; j++)
            for (int e = 0; e < 4; e++) {
                const size_t a = e & 1 ? U->columns - 1 : 0, b = e & 2 ? V->columns - 1 : 0, at = i * k->data.ny + j;
                const double P = corner_datum(k, a, b, c);
                et_dd Nu = whole(0), Nv = whole(0);
                for (size_t l = U->width; l-- > 0;)
                    Nu = U->at[i * U->width + l] == a ? U->a[i * U->width + l] : Nu;
                for (size_t l = V->width; l-- > 0;)
                    Nv = V->at[j * V->width + l] == b ? V->a[j * V->width + l] : Nv;
                const et_dd N = et_dd_mul(Nu, Nv);
                const double size = fabs(d[at].hi) + N.hi * fabs(P);
                if (N.hi != 0 && (P != 0 || k->lost[c] != 0)) {
                    d[at] = et_dd_sub(d[at], et_dd_mul(N, whole(P)));
                    error[at] = (error[at] + ((U->relative + V->relative + 20 * U2) * size + k->lost[c] + 4 * TINY)) * (1 + 0x1p-50);
                }
            }
}

/* All control points of a view at once, or of half the sum of both (w = 2). */
static et_status at_once(answer *x, const enclosure_job *k, size_t w)
{
    static matrix U, V, S;
    size_t number[NODES] = { 0 }, count = 0;
    et_dd d[NODES], p[NODES];
    double error[NODES], r[NODES];
    const et_doublenet n = k->data, f = k->control;
    bool finite = true;

    both_directions(&U, &V, k, w & 1, false);
    for (size_t at = 0; at < f.nx * f.ny; at++)
        number[at] = k->fixed && at_corner(f, at / f.ny, at % f.ny) ? LEFT_OUT : count++;
    product(&S, &U, &V, number, count);
    for (size_t at = 0; w == 2 && at < n.nx * n.ny; at++)
        S.weight[at] = on_border(n, at / n.ny, at % n.ny) ? 1 : 2;
    for (size_t at = 0; w == 2 && at < f.nx * f.ny; at++)
        if (!on_border(f, at / f.ny, at % f.ny))
            S.share[number[at]] = 2;
    if (count > 0 && verify(&S) != ET_OK)
        return unbounded(x, w, S.norm, S.inverse);
    for (size_t c = 0; c < 3; c++) {
        for (size_t at = 0; at < n.nx * n.ny; at++) {
            const et_dd sum = et_dd_two_sum(k->D[0][3 * at + c], k->D[1][3 * at + c]);
            d[at] = w == 2 ? (et_dd){ sum.hi / 2, sum.lo / 2 } : whole(k->D[w][3 * at + c]);
            error[at] = k->lost[c];
        }
        if (k->fixed)
            without_corners(d, error, k, &U, &V, c);
        solve_column(p, r, &S, d, error);
        for (size_t at = 0; at < f.nx * f.ny; at++) {
            const bool stands = number[at] == LEFT_OUT;
            x->x[w & 1][3 * at + c] = stands ? whole(corner_datum(k, at / f.ny, at % f.ny, c)) : p[number[at]];
            x->radius[w & 1][3 * at + c] = stands ? k->lost[c] : r[number[at]];
            finite = finite && isfinite(x->radius[w & 1][3 * at + c]) && isfinite(x->x[w & 1][3 * at + c].hi);
        }
    }
    if (!finite)
        return unbounded(x, w, S.norm, S.inverse);
    norms_of(x, S.norm, S.inverse);
    return ET_OK;
}

/* Half the sum and half the difference of two views that share their border. */
static et_status glued(answer *x, const enclosure_job *k)
{
    const et_doublenet n = k->data, f = k->control;
    static et_dd D[3 * NODES], T[3 * NODES];
    static double error[3 * NODES], r[3 * NODES];
    et_status status = at_once(x, k, 2);

    if (status == ET_OK && f.nx > 2 && f.ny > 2) {
        for (size_t i = 1; i + 1 < n.nx; i++)
            for (size_t e = 3; e + 3 < 3 * n.ny; e++) {
                const et_dd d = et_dd_two_sum(k->D[0][3 * i * n.ny + e], -k->D[1][3 * i * n.ny + e]);
                D[3 * (i - 1) * (n.ny - 2) + e - 3] = (et_dd){ d.hi / 2, d.lo / 2 };
                error[3 * (i - 1) * (n.ny - 2) + e - 3] = k->lost[e % 3];
            }
        status = by_directions(T, r, x, k, 0, true, D, error);
    }
    memcpy(x->x[1], x->x[0], sizeof x->x[0]);
    memcpy(x->radius[1], x->radius[0], sizeof x->radius[0]);
    for (size_t at = 0; at < 3 * f.nx * f.ny; at++) {
        const size_t i = at / 3 / f.ny, j = at / 3 % f.ny;
        if (on_border(f, i, j))
            continue;
        const et_dd s = x->x[0][at], t = T[3 * ((i - 1) * (f.ny - 2) + j - 1) + at % 3];
        const double both = x->radius[0][at] + r[3 * ((i - 1) * (f.ny - 2) + j - 1) + at % 3];
        x->x[0][at] = et_dd_add(s, t);
        x->x[1][at] = et_dd_sub(s, t);
        x->radius[0][at] = x->radius[1][at] = (both + 4 * U2 * (fabs(s.hi) + fabs(t.hi))) * (1 + 0x1p-50);
    }
    return status;
}

static void means(answer *x, const enclosure_job *k)
{
    const et_doublenet f = k->control;

    for (size_t at = 0; at < 3 * f.nx * f.ny; at++) {
        const size_t i = at / 3 / f.ny, j = at / 3 % f.ny;
        const et_dd sum = et_dd_add(x->x[0][at], x->x[1][at]);
        const double r = x->radius[0][at] + x->radius[1][at] + 4 * U2 * fabs(sum.hi);
        if (!on_border(f, i, j))
            continue;
        x->x[0][at] = x->x[1][at] = (et_dd){ sum.hi / 2, sum.lo / 2 };
        x->radius[0][at] = x->radius[1][at] = r / 2 * (1 + 0x1p-50);
        if (k->fixed && at_corner(f, i, j)) {
            x->x[0][at] = x->x[1][at] = whole(corner_datum(k, i, j, at % 3));
            x->radius[0][at] = x->radius[1][at] = k->lost[at % 3];
        }
    }
}

/* ---- rank: the most functions that parameters of their own make positive, by augmenting paths ---- */

static bool augment(size_t *owner, bool *seen, bool positive[SIDE][SIDE], size_t j, size_t m)
{
    for (size_t i = 0; i < m; i++)
        if (positive[j][i] && !seen[i]) {
            seen[i] = true;
            if (owner[i] == LEFT_OUT || augment(owner, seen, positive, owner[i], m)) {
                owner[i] = j;
                return true;
            }
        }
    return false;
}

static size_t matched(const double *t, size_t m, const double *u, size_t n, size_t p, bool inner)
{
    bool positive[SIDE][SIDE] = { { false } };
    size_t owner[SIDE], rank = 0;

    for (size_t i = 0; i < m; i++)
        owner[i] = LEFT_OUT;
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < m; i++)
            positive[j][i] = (i == 0 || t[i - 1] < t[i]) && ((u[j] < t[i] && t[i] < u[j + p + 1]) || alone_at(u, n, p, t[i]) == j);
    for (size_t j = inner; j + inner < n; j++) {
        bool seen[SIDE] = { false };
        rank += augment(owner, seen, positive, j, m);
    }
    return rank;
}

static et_status rank(answer *x, const enclosure_job *k)
{
    const bool fixed = k->fixed && k->options->approach != ET_FIT_IMPROVED;

    for (size_t e = 0; e < 4; e++) {
        const size_t w = e / 2;
        const et_surface *s = &k->fit->shell.view[w];
        const bool inner = fixed && (e % 2 ? k->control.nx : k->control.ny) == 2;
        const size_t n = e % 2 ? s->nv : s->nu, m = e % 2 ? k->data.ny : k->data.nx, wanted = n - 2 * inner;
        const size_t got = matched(e % 2 ? k->fit->r[w] : k->fit->s[w], m, e % 2 ? s->v : s->u, n, e % 2 ? s->q : s->p, inner);
        if (got < wanted) {
            snprintf(x->text, sizeof x->text, "%s, direction %s: the %zu parameters determine only %zu of %zu control points", names[w],
                     e % 2 ? "v" : "u", m, got, wanted);
            return ET_ERANK;
        }
    }
    return ET_OK;
}

static et_status solve_again(answer *x, const enclosure_job *k)
{
    const et_fit_approach approach = k->options->approach;
    et_status status;

    memset(x, 0, sizeof *x);
    status = rank(x, k);
    if (status != ET_OK)
        return status;
    if (approach == ET_FIT_JOINT)
        return glued(x, k);
    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        et_dd D[3 * NODES];
        double error[3 * NODES];
        for (size_t at = 0; at < 3 * k->data.nx * k->data.ny; at++) {
            D[at] = whole(k->D[w][at]);
            error[at] = k->lost[at % 3];
        }
        status = k->fixed && approach == ET_FIT_CONVENTIONAL ? at_once(x, k, w) : by_directions(x->x[w], x->radius[w], x, k, w, false, D, error);
    }
    if (status == ET_OK && approach == ET_FIT_IMPROVED)
        means(x, k);
    return status;
}

/* ---- the backward error ---- */

/* A problem of one view or of two: the matrix whole, border data and border control points of the second view being the first's. */
typedef struct {
    const enclosure_job *k;
    size_t first, views, nodes, points;
    double U[2][SIDE][SIDE], V[2][SIDE][SIDE];
    bool unknown[2 * NODES], counted[2 * NODES];
} backward;

static bool tabulate(double N[SIDE][SIDE], const double *t, size_t m, const double *u, size_t n, size_t p)
{
    fit_collocation c;

    memset(N, 0, sizeof(double[SIDE][SIDE]));
    if (fit_collocate(&c, t, m, u, n, p) != ET_OK)
        return false;
    for (size_t i = 0; i < m; i++)
        for (size_t e = 0; e <= p; e++)
            N[i][c.start[i] + e] = c.a[i * (p + 1) + e];
    fit_collocation_free(&c);
    return true;
}

static bool backward_start(backward *b, const enclosure_job *k, size_t first, size_t views)
{
    const et_surface *s = &k->fit->shell.view[first];
    const et_doublenet n = k->data, f = k->control;

    *b = (backward){ .k = k, .first = first, .views = views, .nodes = n.nx * n.ny, .points = f.nx * f.ny };
    for (size_t at = 0; at < 2 * b->points; at++) {
        const size_t i = at % b->points / f.ny, j = at % b->points % f.ny;
        b->unknown[at] = !(k->fixed && at_corner(f, i, j)) && !(at >= b->points && on_border(f, i, j));
    }
    for (size_t at = 0; at < 2 * b->nodes; at++)
        b->counted[at] = at < b->nodes || !on_border(n, at % b->nodes / n.ny, at % b->nodes % n.ny);
    return tabulate(b->U[0], k->fit->s[first], n.nx, s->u, s->nu, s->p) && tabulate(b->V[0], k->fit->r[first], n.ny, s->v, s->nv, s->q);
}

/* y = A x, x with all its control points. */
static void forward(double *y, const backward *b, const double *x)
{
    const et_doublenet n = b->k->data, f = b->k->control;

    for (size_t at = 0; at < b->views * b->nodes; at++) {
        const size_t w = at / b->nodes, i = at % b->nodes / n.ny, j = at % b->nodes % n.ny;
        double sum = 0;
        for (size_t l = 0; l < b->points; l++)
            if (b->U[0][i][l / f.ny] != 0 && b->V[0][j][l % f.ny] != 0)
                sum += b->U[0][i][l / f.ny] * b->V[0][j][l % f.ny] * x[w * b->points + l];
        y[at] = b->counted[at] ? sum : 0;
    }
}

/* q = A'A x over the unknowns. */
static void normal(double *q, const backward *b, const double *x)
{
    const et_doublenet n = b->k->data, f = b->k->control;
    double y[2 * NODES], whole_x[2 * NODES] = { 0 };

    for (size_t l = 0; l < b->views * b->points; l++)
        whole_x[l] = l >= b->points && on_border(f, l % b->points / f.ny, l % b->points % f.ny) ? x[l - b->points] : x[l];
    forward(y, b, whole_x);
    for (size_t l = 0; l < b->views * b->points; l++) {
        const size_t w = l / b->points, c = l % b->points / f.ny, d = l % b->points % f.ny;
        q[l] = 0;
        for (size_t at = 0; at < b->nodes; at++)
            if (b->U[0][at / n.ny][c] != 0 && b->V[0][at % n.ny][d] != 0)
                q[l] += b->U[0][at / n.ny][c] * b->V[0][at % n.ny][d] * y[w * b->nodes + at];
    }
    for (size_t l = b->points; l < b->views * b->points; l++)
        if (on_border(f, l % b->points / f.ny, l % b->points % f.ny))
            q[l - b->points] += q[l];
    for (size_t l = 0; l < b->views * b->points; l++)
        q[l] = b->unknown[l] ? q[l] : 0;
}

static double sum_of_squares(const double *x, size_t n)
{
    double sum = 0;

    for (size_t i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sum;
}

/* g'(A'A + shift I)^-1 g by conjugate gradients. */
static double conjugate(const backward *b, double *g, double shift)
{
    const size_t n = b->views * b->points;
    double p[2 * NODES], q[2 * NODES], value = 0, before = sum_of_squares(g, n), first = before;

    memcpy(p, g, n * sizeof *p);
    for (int step = 1; step <= 40 && before > first * 0x1p-60; step++) {
        double curvature = 0, after;
        normal(q, b, p);
        for (size_t i = 0; i < n; i++) {
            q[i] += shift * p[i];
            curvature += p[i] * q[i];
        }
        if (!(curvature > 0))
            return value;
        value += before / curvature * before;
        for (size_t i = 0; i < n; i++)
            g[i] -= before / curvature * q[i];
        after = sum_of_squares(g, n);
        for (size_t i = 0; i < n; i++)
            p[i] = g[i] + after / before * p[i];
        before = after;
    }
    return value;
}

static double one_backward(const backward *b, const answer *x, size_t c)
{
    const enclosure_job *k = b->k;
    double P[2 * NODES], e[2 * NODES], y[2 * NODES], g[2 * NODES], solution = 0, residual = 0, gradient;

    for (size_t l = 0; l < b->views * b->points; l++) {
        const size_t w = b->first + l / b->points, at = l % b->points;
        P[l] = ldexp((&k->fit->shell.view[w].points[at].x)[c], -k->exponent[c]);
        e[l] = b->unknown[l] ? et_dd_sub(whole(P[l]), x->x[w][3 * at + c]).hi : 0;
        solution += b->unknown[l] ? P[l] * P[l] : 0;
    }
    forward(y, b, P);
    for (size_t w = 0; w < b->views; w++) {
        for (size_t at = 0; at < b->nodes; at++)
            y[w * b->nodes + at] = b->counted[w * b->nodes + at] ? k->D[b->first + w][3 * at + c] - y[w * b->nodes + at] : 0;
        residual += sum_of_squares(y + w * b->nodes, b->nodes);
    }
    normal(g, b, e);
    gradient = sum_of_squares(g, b->views * b->points);
    if (gradient == 0)
        return 0;
    if (!(solution < 0x1p1000) || !(residual < 0x1p1000) || !(gradient < 0x1p1000))
        return HUGE_VAL;
    if (solution > residual * 0x1p-900)
        return sqrt(conjugate(b, g, residual / solution) / solution) / x->norm / 0x1p-52;
    return sqrt(gradient / residual) / x->norm / 0x1p-52;
}

static double backward_again(const enclosure_job *k, const answer *x)
{
    const size_t views = k->options->approach == ET_FIT_JOINT ? 2 : 1;
    double most = 0;
    backward b;

    for (size_t first = 0; first < 2; first += views)
        for (size_t c = 0; c < 3 && backward_start(&b, k, first, views); c++)
            most = fmax(most, one_backward(&b, x, c));
    return most;
}

/* ---- radii around given points ---- */

/* Whether every number within radius of x (in units of 2^exponent) rounds to P. */
static bool rounds_to(double P, et_dd x, double radius, int exponent)
{
    double above = nextafter(P, HUGE_VAL) - P, below = P - nextafter(P, -HUGE_VAL);
    const double d = et_dd_sub(x, whole(ldexp(P, -exponent))).hi, slack = (fabs(d) + radius) * 0x1p-49;

    if (radius == 0)
        return P == 0;
    above = isinf(above) ? below : above;
    below = isinf(below) ? above : below;
    above = ldexp(above, -exponent - 1);
    below = ldexp(below, -exponent - 1);
    return above > TINY && below > TINY && d + radius + slack < above && -d + radius + slack < below;
}

/* |P - exact| and all it may be off, in the data's unit. */
static double around(double P, et_dd x, double radius, int exponent)
{
    const double unit = ldexp(P, -exponent);
    const double off = ldexp(unit, exponent) == P ? 0 : TINY;
    const double sum = (fabs(et_dd_sub(x, whole(unit)).hi) * (1 + 0x1p-51) + (radius + off)) * (1 + 0x1p-51), back = ldexp(sum, exponent);

    if (isinf(unit))
        return (fabs(P) + nextafter(ldexp((fabs(x.hi) + radius) * (1 + 0x1p-51), exponent), HUGE_VAL)) * (1 + 0x1p-51);
    return ldexp(back, -exponent) < sum ? nextafter(back, HUGE_VAL) : back;
}

static double to_nearest(et_dd x, double radius, int exponent)
{
    const double P = ldexp(x.hi, exponent), above = nextafter(P, HUGE_VAL), below = nextafter(P, -HUGE_VAL);

    if (fabs(P) >= 0x1p-1021 || rounds_to(P, x, radius, exponent))
        return P;
    return rounds_to(above, x, radius, exponent) ? above : rounds_to(below, x, radius, exponent) ? below : P;
}

/* ---- cases ---- */

typedef struct {
    et_fit fit;
    et_fit_options options;
    enclosure_job job;
    et_message message;
    double t[2][2][SIDE], u[2][2][KNOTS], D[2][3 * NODES];
    et_vec3 P[2][NODES];
} problem;

static void sort(double *x, size_t n)
{
    for (size_t i = 1; i < n; i++)
        for (size_t j = i; j > 0 && x[j] < x[j - 1]; j--) {
            const double t = x[j];
            x[j] = x[j - 1];
            x[j - 1] = t;
        }
}

/* Parameters from 0 to 1: even; any; with coincident ones; two very near each other; near 0. */
static void draw_parameters(gen *g, double *t, size_t m)
{
    const size_t kind = gen_upto(g, 9);

    for (size_t i = 0; i < m; i++)
        t[i] = kind < 5 ? ((double)i + (i > 0 && i + 1 < m ? gen_real(g, -0.4, 0.4) : 0)) / (double)(m - 1) : gen_real(g, 0, 1);
    sort(t, m);
    t[0] = 0;
    t[m - 1] = 1;
    if (kind == 1 && m > 3)
        t[2] = fmin(1, t[1] + ldexp(gen_real(g, 1, 2), -(int)gen_between(g, 30, 50)));
    if (kind == 2 && m > 2)
        t[1] = ldexp(gen_real(g, 1, 2), -(int)(gen_between(g, 30, 60) * (gen_chance(g, 2) ? 1 + gen_upto(g, 15) : 1)));
    if (kind == 3 && m > 2)
        t[1] = gen_chance(g, 2) ? 0 : t[2];
    if (kind == 4)
        t[m - 2] = m > 2 ? 1 - ldexp(gen_real(g, 1, 2), -(int)gen_between(g, 30, 52)) : 0;
}

/* Clamped on [0, 1]: averages of parameters, rarely an end knot more often than p + 1 times; even; hard ones. */
static void draw_knots(gen *g, double *u, size_t n, size_t p, const double *t, size_t m)
{
    const size_t kind = gen_upto(g, 7);

    for (size_t i = 0; i < n + p + 1; i++)
        u[i] = i <= p ? 0 : i >= n ? 1 : (double)(i - p) / (double)(n - p);
    for (size_t i = p + 1; i < n && kind < 4; i++)
        u[i] = fmax(0x1p-30, fmin(1 - 0x1p-30, (t[(i - p) * m / n] + t[(i - 1) * m / n]) / 2));
    if (kind == 4)
        gen_knots(g, u, n + p + 1, p);
    if (kind == 5 && n > p + 1)
        u[gen_chance(g, 2) ? p + 1 : n - 1] = gen_real(g, 0, 1);
    sort(u, n + p + 1);
    if (kind == 6 && n > p + 1 && gen_chance(g, 4))
        u[gen_chance(g, 2) ? p + 1 : n - 1] = gen_chance(g, 2);
    for (size_t i = 0; i < n + p + 1; i++)
        u[i] = u[i] < 0x1p-900 ? 0 : u[i];
    sort(u, n + p + 1);
}

static void draw_frame(gen *g, problem *c)
{
    const bool hard = gen_chance(g, 2);
    et_fit_options *o = &c->options;
    et_fit *f = &c->fit;

    memset(c, 0, sizeof *c);
    f->data = (et_doublenet){ gen_between(g, 2, SIDE), gen_between(g, 2, SIDE) };
    *o = et_fit_defaults();
    o->control = (et_doublenet){ gen_between(g, 2, f->data.nx), gen_between(g, 2, f->data.ny) };
    o->p = gen_between(g, 1, o->control.nx - 1 < 3 ? o->control.nx - 1 : 3);
    o->q = gen_between(g, 1, o->control.ny - 1 < 3 ? o->control.ny - 1 : 3);
    o->approach = (et_fit_approach)gen_upto(g, 2);
    o->corners = (et_fit_corners)gen_upto(g, 2);
    for (size_t w = 0; w < 2; w++) {
        et_surface *s = &f->shell.view[w];
        const size_t from = o->approach == ET_FIT_CONVENTIONAL ? w : 0;
        *s = (et_surface){ o->p, o->q, o->control.nx, o->control.ny, c->u[from][0], c->u[from][1], c->P[w], NULL };
        for (size_t e = 0; e < 2 && from == w; e++) {
            const size_t m = e ? f->data.ny : f->data.nx, n = e ? s->nv : s->nu, p = e ? s->q : s->p;
            for (size_t i = 0; i < m; i++)
                c->t[w][e][i] = (double)i / (double)(m - 1);
            if (hard)
                draw_parameters(g, c->t[w][e], m);
            draw_knots(g, c->u[w][e], n, p, c->t[w][e], m);
        }
        f->s[w] = c->t[from][0];
        f->r[w] = c->t[from][1];
    }
}

/* Data of a job: between -1 and 1, next to nothing, or past what sums can hold; what scaling lost may be much, to be seen. */
static void draw_job(gen *g, problem *c)
{
    static const double losses[] = { 0, 0, 0, 0x1p-1000, 0x1p-999, 0x1p-90, 0x1p-20 };
    static const int scales[] = { 0, 0, 0, 0, 0, 0, 0, -2000, -2000, -170, -538, 1023 };
    enclosure_job *k = &c->job;

    *k = (enclosure_job){ .fit = &c->fit, .options = &c->options, .message = &c->message, .data = c->fit.data, .control = c->options.control,
                          .fixed = c->options.corners != ET_CORNERS_FREE, .D = { c->D[0], c->D[1] } };
    for (size_t e = 0; e < 3; e++) {
        const int scale = scales[gen_upto(g, 11)];
        const bool like = gen_chance(g, 3);
        k->lost[e] = losses[gen_upto(g, 6)];
        k->exponent[e] = (int)gen_upto(g, 20) - 10;
        for (size_t w = 0; w < 2; w++)
            for (size_t at = 0; at < k->data.nx * k->data.ny; at++) {
                const bool border = on_border(k->data, at / k->data.ny, at % k->data.ny);
                c->D[w][3 * at + e] = border && w ? c->D[0][3 * at + e] : ldexp(gen_real(g, -1, 1), like && !w ? 0 : scale);
            }
    }
}

static void draw_points(gen *g, problem *c, const enclosure_solution *x)
{
    static const int scales[] = { -52, -52, -20, 0, -538, -541, -460, 300, 480, 505, 520, 1000, -2000 };

    for (size_t e = 0; e < 3; e++) {
        const int scale = scales[gen_upto(g, 12)];
        const bool near = gen_chance(g, 2);
        for (size_t w = 0; w < 2; w++)
            for (size_t at = 0; at < c->options.control.nx * c->options.control.ny; at++) {
                const double p = ldexp((near && x ? x->x[w][3 * at + e].hi : 0) + ldexp(gen_real(g, -1, 1), scale), c->job.exponent[e]);
                (&c->P[w][at].x)[e] = isfinite(p) ? p : copysign(0x1.fffffffffffffp1023, p);
            }
    }
}

static void tell(gen *g, const problem *c)
{
    gen_note(g, "%s, corners %d, degrees %zu %zu, data %zux%zu, control %zux%zu", et_fit_name(c->options.approach), (int)c->options.corners,
             c->options.p, c->options.q, c->fit.data.nx, c->fit.data.ny, c->options.control.nx, c->options.control.ny);
    for (size_t e = 0; e < 4; e++) {
        for (size_t i = 0; i < (e % 2 ? c->fit.data.ny : c->fit.data.nx); i++)
            gen_note(g, "t[%zu][%zu][%zu] = %a", e / 2, e % 2, i, c->t[e / 2][e % 2][i]);
        for (size_t i = 0; i <= (e % 2 ? c->options.q + c->options.control.ny : c->options.p + c->options.control.nx); i++)
            gen_note(g, "u[%zu][%zu][%zu] = %a", e / 2, e % 2, i, c->u[e / 2][e % 2][i]);
    }
}

/* ---- properties ---- */

/* The solution of a job and its backward error. */
verdict prop_enclosure_make_again(gen *g)
{
    static answer want;
    problem c;
    enclosure_solution x, unset;
    bool ok;

    draw_frame(g, &c);
    draw_job(g, &c);
    tell(g, &c);
    memset(&unset, 0x3c, sizeof unset);
    x = unset;
    const et_status wanted = solve_again(&want, &c.job), status = enclosure_solve(&x, &c.job);
    ok = gen_check(g, status == wanted, "status %d, not %d (%s; %s)", (int)status, (int)wanted, c.message.text, want.text);
    gen_label(g, wanted == ET_OK ? "solved" : wanted == ET_ERANK ? "deficient" : "no bound");
    if (!ok || status != ET_OK) {
        ok = gen_check(g, !ok || strcmp(c.message.text, want.text) == 0, "'%s', not '%s'", c.message.text, want.text) && ok;
        ok = gen_check(g, status == ET_OK || memcmp(&x, &unset, sizeof x) == 0, "set, though it failed") && ok;
        if (status == ET_OK)
            enclosure_solution_free(&x);
        return ok ? PASS : FAIL;
    }
    ok = gen_check(g, same(x.norm, want.norm) && same(x.inverse, want.inverse), "norms %a %a, not %a %a", x.norm, x.inverse, want.norm, want.inverse);
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < 3 * c.job.control.nx * c.job.control.ny; at++)
            ok = gen_check(g, same_dd(x.x[w][at], want.x[w][at]) && same(x.radius[w][at], want.radius[w][at]),
                           "view %zu, %zu: %a + %a within %a, not %a + %a within %a", w, at, x.x[w][at].hi, x.x[w][at].lo, x.radius[w][at],
                           want.x[w][at].hi, want.x[w][at].lo, want.radius[w][at]) && ok;
    draw_points(g, &c, &x);
    double b = -1;
    const double b_wanted = backward_again(&c.job, &want);
    ok = gen_check(g, enclosure_backward(&b, &c.job, &x) == ET_OK && same(b, b_wanted), "backward error %a, not %a", b, b_wanted) && ok;
    enclosure_solution_free(&x);
    ok = gen_check(g, x.x[0] == NULL && x.x[1] == NULL && x.radius[0] == NULL && x.radius[1] == NULL && x.norm == 0 && x.inverse == 0, "freed") && ok;
    return ok ? PASS : FAIL;
}

/* The job of data: coordinates over powers of two, the greatest in [1/2, 1). */
static void take_job(problem *c, const et_vec3 *data)
{
    enclosure_job *k = &c->job;
    const et_doublenet n = c->fit.data;

    *k = (enclosure_job){ .fit = &c->fit, .options = &c->options, .message = &c->message, .data = n, .control = c->options.control,
                          .fixed = c->options.corners == ET_CORNERS_INTERPOLATED ||
                                   (c->options.corners == ET_CORNERS_DEFAULT && c->options.approach == ET_FIT_IMPROVED),
                          .D = { c->D[0], c->D[1] } };
    for (size_t e = 0; e < 3; e++) {
        double most = 0;
        for (size_t i = 0; i < et_doublenet_nov(n); i++)
            most = fmax(most, fabs((&data[i].x)[e]));
        frexp(most, &k->exponent[e]);
        for (size_t at = 0; at < 2 * n.nx * n.ny; at++) {
            const double x = (&data[et_doublenet_class(n, at % 2, at / 2 / n.ny, at / 2 % n.ny) - 1].x)[e];
            c->D[at % 2][3 * (at / 2) + e] = ldexp(x, -k->exponent[e]);
            k->lost[e] = ldexp(ldexp(x, -k->exponent[e]), k->exponent[e]) == x ? k->lost[e] : TINY;
        }
    }
}

/* Data of any unit for the functions themselves. */
static void draw_data(gen *g, problem *c, et_vec3 *data)
{
    static const int units[] = { 0, 0, 0, 0, 1020, 1023, -1060, -1070, -400 };
    const size_t nov = et_doublenet_nov(c->fit.data);

    for (size_t e = 0; e < 3; e++) {
        const int unit = units[gen_upto(g, 8)];
        const size_t kind = gen_upto(g, 5);
        for (size_t i = 0; i < nov; i++) {
            double x = ldexp(gen_real(g, -1, 1), unit);
            if (kind == 0)
                x = ldexp((double)gen_upto(g, 8) - 4, unit);
            if (kind == 1)
                x = 0;
            if (kind == 2 && gen_chance(g, 2))
                x = ldexp(x, -1040);
            (&data[i].x)[e] = isfinite(x) ? x : copysign(0x1.fffffffffffffp1023, x);
        }
    }
    take_job(c, data);
}

/* What an enclosure of the points P must be. */
static void enclose_again(et_enclosure *e, et_vec3 R[2][NODES], const problem *c, et_vec3 P[2][NODES], const answer *x, const et_vec3 *data)
{
    const enclosure_job *k = &c->job;

    *e = (et_enclosure){ { R[0], R[1] }, k->control.nx * k->control.ny, 1, 0, 0 };
    for (size_t at = 0; at < 6 * e->count; at++) {
        const size_t w = at / 3 / e->count, l = at / 3 % e->count, m = at % 3, i = l / k->control.ny, j = l % k->control.ny;
        const double p = (&P[w][l].x)[m], r = x->radius[w][3 * l + m];
        const size_t corner = et_doublenet_class(k->data, 0, i ? k->data.nx - 1 : 0, j ? k->data.ny - 1 : 0) - 1;
        const double d = (&data[corner].x)[m];
        if (k->fixed && at_corner(k->control, i, j)) {
            (&R[w][l].x)[m] = p == d ? 0 : nextafter(fabs(p - d), HUGE_VAL);
            e->undecided += p != d;
        } else {
            (&R[w][l].x)[m] = around(p, x->x[w][3 * l + m], r, k->exponent[m]);
            e->undecided += !rounds_to(p, x->x[w][3 * l + m], r, k->exponent[m]);
        }
    }
    e->condition = x->norm > 0 ? x->norm * x->inverse : 1;
}

static bool equal(gen *g, const char *what, const et_enclosure *e, const et_enclosure *want)
{
    bool ok = gen_check(g, e->count == want->count && same(e->condition, want->condition) && same(e->backward, want->backward) &&
                               e->undecided == want->undecided,
                        "%s: condition %a, backward %a, %zu undecided, not %a, %a, %zu", what, e->condition, e->backward, e->undecided, want->condition,
                        want->backward, want->undecided);

    for (size_t at = 0; ok && at < 6 * e->count; at++) {
        const double r = (&e->radius[at / 3 / e->count][at / 3 % e->count].x)[at % 3];
        const double wanted = (&want->radius[at / 3 / e->count][at / 3 % e->count].x)[at % 3];
        ok = gen_check(g, same(r, wanted), "%s: radius %zu is %a, not %a", what, at, r, wanted);
    }
    return ok;
}

/* The rounded solution; false where it overflows. */
static bool round_again(et_vec3 P[2][NODES], const problem *c, const answer *x, const et_vec3 *data)
{
    const enclosure_job *k = &c->job;
    bool finite = true;

    for (size_t at = 0; at < 6 * k->control.nx * k->control.ny; at++) {
        const size_t n = k->control.nx * k->control.ny, w = at / 3 / n, l = at / 3 % n, m = at % 3, i = l / k->control.ny, j = l % k->control.ny;
        const size_t corner = et_doublenet_class(k->data, 0, i ? k->data.nx - 1 : 0, j ? k->data.ny - 1 : 0) - 1;
        double *p = &(&P[w][l].x)[m];
        *p = k->fixed && at_corner(k->control, i, j) ? (&data[corner].x)[m]
                                                      : to_nearest(x->x[w][3 * l + m], x->radius[w][3 * l + m], k->exponent[m]) + 0.0;
        finite = finite && isfinite(*p);
    }
    return finite;
}

static bool as_again(gen *g, problem *c, const et_vec3 *data)
{
    static answer x;
    static et_vec3 R[2][NODES], P[2][NODES];
    const size_t nov = et_doublenet_nov(c->fit.data);
    et_enclosure e, want;
    const et_status wanted = solve_again(&x, &c->job);
    et_status status = et_enclosure_make(&e, &c->fit, data, nov, &c->options, &c->message);
    bool ok = gen_check(g, status == wanted, "make: status %d, not %d", (int)status, (int)wanted);

    if (status == ET_OK && wanted == ET_OK) {
        enclose_again(&want, R, c, c->P, &x, data);
        want.backward = backward_again(&c->job, &x);
        ok = equal(g, "make", &e, &want) && ok;
    } else {
        ok = gen_check(g, strcmp(c->message.text, x.text) == 0, "make: '%s', not '%s'", c->message.text, x.text) && ok;
    }
    if (status == ET_OK)
        et_enclosure_free(&e);
    if (!ok || wanted != ET_OK)
        return ok;
    const bool finite = round_again(P, c, &x, data);
    status = et_enclosure_refine(&c->fit, &e, data, nov, &c->options, &c->message);
    ok = gen_check(g, status == (finite ? ET_OK : ET_EFORMAT), "refine: status %d, %s", (int)status, finite ? "finite" : "overflow");
    if (!finite)
        ok = gen_check(g, strcmp(c->message.text, "the control points overflow: the data are too large") == 0, "refine: '%s'", c->message.text) && ok;
    gen_label(g, finite ? "refined" : "overflow");
    if (status == ET_OK) {
        for (size_t at = 0; at < 6 * e.count; at++) {
            const size_t w = at / 3 / e.count, l = at / 3 % e.count, m = at % 3;
            const double p = (&c->P[w][l].x)[m], q = (&P[w][l].x)[m];
            ok = gen_check(g, p == q && !signbit(p) == !signbit(q), "refine: coordinate %zu is %a, not %a", at, p, q) && ok;
        }
        enclose_again(&want, R, c, P, &x, data);
        want.backward = backward_again(&c->job, &x);
        ok = equal(g, "refine", &e, &want) && ok;
        et_enclosure_free(&e);
    }
    return ok;
}

/* Both functions, whole. */
verdict prop_enclosure_refine_again(gen *g)
{
    problem c;
    et_vec3 data[2 * NODES];

    draw_frame(g, &c);
    draw_data(g, &c, data);
    draw_points(g, &c, NULL);
    tell(g, &c);
    return as_again(g, &c, data) ? PASS : FAIL;
}

/* ---- systems by themselves ---- */

static bool same_system(gen *g, const enclosure_system *s, const matrix *want)
{
    bool ok = gen_check(g, s->rows == want->rows && s->columns == want->columns && s->width == want->width && s->tall == want->tall &&
                               s->relative == want->relative,
                        "%zu rows, %zu columns, width %zu, %zu entries in a column, relative %a", s->rows, s->columns, s->width, s->tall, s->relative);

    for (size_t e = 0; ok && e < s->rows * s->width; e++)
        ok = gen_check(g, s->at[e] == want->at[e] && same_dd(s->a[e], want->a[e]), "entry %zu: %zu, %a, not %zu, %a", e, s->at[e], s->a[e].hi,
                       want->at[e], want->a[e].hi);
    return ok;
}

static bool same_factors(gen *g, const enclosure_system *s, const matrix *want)
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
static bool same_columns(gen *g, enclosure_system *s, matrix *want)
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
    solve_column(y, q, want, d, error);
    for (size_t j = 0; j < s->columns; j++)
        ok = gen_check(g, same_dd(x[j], y[j]) && same(r[j], q[j]), "unit 2^%d, column %zu: %a within %a, not %a within %a", unit, j, x[j].hi, r[j],
                       y[j].hi, q[j]) && ok;
    return ok;
}

static bool verified_again(gen *g, enclosure_system *s, matrix *want)
{
    et_status wanted, status;
    bool ok = same_system(g, s, want);

    for (size_t i = 0; i < s->rows; i++)
        s->weight[i] = want->weight[i] = (double)gen_between(g, 1, 2);
    for (size_t j = 0; j < s->columns; j++)
        s->share[j] = want->share[j] = (double)gen_between(g, 1, 2);
    wanted = verify(want);
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
    static matrix a, b, c;
    enclosure_system U, V, s = { 0 };
    size_t number[NODES] = { 0 }, mine[NODES] = { 0 }, count = 0;
    problem k;
    bool ok = true, inner[2];

    draw_frame(g, &k);
    const et_surface *v = &k.fit.shell.view[0];
    for (size_t e = 0; e < 2; e++) {
        const size_t n = e ? v->nv : v->nu, m = e ? k.fit.data.ny : k.fit.data.nx;
        inner[e] = n > 2 && gen_chance(g, 3);
        if (m > 3 && gen_chance(g, 3)) /* where proofs begin to fail */
            k.t[0][e][2] = fmin(k.t[0][e][3], k.t[0][e][1] + ldexp(gen_real(g, 1, 2), -(int)gen_between(g, 40, 52)));
        if (matched(k.t[0][e], m, k.u[0][e], n, e ? v->q : v->p, false) < n)
            return SKIP;
    }
    tell(g, &k);
    direction(&a, k.t[0][0], k.fit.data.nx, v->u, v->nu, v->p, inner[0]);
    direction(&b, k.t[0][1], k.fit.data.ny, v->v, v->nv, v->q, inner[1]);
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
        product(&c, &a, &b, mine, count);
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

/* ---- next to a boundary ---- */

static bool bottom_decided(const problem *c, const answer *x)
{
    return rounds_to(c->P[0][0].x, x->x[0][0], x->radius[0][0], c->job.exponent[0]);
}

/* Two data at one parameter: their mean is as near as one likes to the middle between two doubles.  Where the proof just succeeds and where it just fails is found by halving; there all must be equal. */
/* One case in 25. */
verdict prop_enclosure_refine_boundary(gen *g)
{
    static answer x;
    problem c;
    et_vec3 data[2 * NODES];
    const bool negative = gen_chance(g, 2), below = gen_chance(g, 2), zero = gen_chance(g, 2);
    const double big = gen_chance(g, 2) ? 1 : 1 + 2 * (double)gen_upto(g, 100) * 0x1p-52;
    double near = 0, far = 0x1p-30;
    enum { HALVINGS = 26 };
    bool ok = true;

    memset(&c, 0, sizeof c);
    c.fit.data = (et_doublenet){ 3, 2 };
    c.options = et_fit_defaults();
    c.options.control = (et_doublenet){ 2, 2 };
    c.options.p = c.options.q = 1;
    c.options.approach = (et_fit_approach)gen_upto(g, 2);
    c.options.corners = ET_CORNERS_FREE;
    for (size_t i = 0; i < 2; i++) {
        c.t[0][0][2] = c.t[0][1][1] = c.u[0][i][2] = c.u[0][i][3] = 1;
        c.fit.shell.view[i] = (et_surface){ 1, 1, 2, 2, c.u[0][0], c.u[0][1], c.P[i], NULL };
        c.fit.s[i] = c.t[0][0];
        c.fit.r[i] = c.t[0][1];
    }
    for (size_t i = 0; i < 6; i++)
        data[i] = (et_vec3){ (double)i + 1, zero ? 0 : 0.5 + (double)i, zero ? 0 : 2 };
    const size_t first = et_doublenet_class(c.fit.data, 0, 0, 0) - 1, second = et_doublenet_class(c.fit.data, 0, 1, 0) - 1;
    for (int step = 0; step < HALVINGS + 8; step++) {
        /* big / 2 and half an ulp of it, less a little: halvings first, then the doubles around */
        const double gap = below ? -0x1p-53 * (big == 1 ? 0.5 : 1) : 0x1p-53, middle = near + (far - near) / 2;
        const double less = step < HALVINGS ? middle : far + (step - HALVINGS - 4) * 0x1p-53;
        data[first].x = negative ? -big : big;
        data[second].x = gap * (1 - less) * (negative ? -1 : 1);
        c.P[0][0].x = c.P[1][0].x = (negative ? -big : big) / 2;
        take_job(&c, data);
        if (solve_again(&x, &c.job) != ET_OK)
            return FAIL;
        if (step < HALVINGS) {
            if (bottom_decided(&c, &x))
                far = middle;
            else
                near = middle;
            continue;
        }
        ok = as_again(g, &c, data) && ok;
    }
    return gen_check(g, ok && far < 0x1p-31, "decided from %a", far) ? PASS : FAIL;
}

/* Of the least doubles: a line through data at 0, t and 1 stands at 0 at (d0 + d1)/2 + O(t), next to the middle between two multiples of 2^-1074, so
 * near that 53 bits do not tell on which side, but the rest of a double-double does. */
verdict prop_enclosure_refine_least(gen *g)
{
    problem c;
    et_vec3 data[2 * NODES];
    const bool normal = gen_chance(g, 3);

    memset(&c, 0, sizeof c);
    c.fit.data = (et_doublenet){ 3, 2 };
    c.options = et_fit_defaults();
    c.options.control = (et_doublenet){ 2, 2 };
    c.options.p = c.options.q = 1;
    c.options.approach = (et_fit_approach)gen_upto(g, 2);
    c.options.corners = ET_CORNERS_FREE;
    for (size_t i = 0; i < 2; i++) {
        c.t[0][0][2] = c.t[0][1][1] = c.u[0][i][2] = c.u[0][i][3] = 1;
        c.fit.shell.view[i] = (et_surface){ 1, 1, 2, 2, c.u[0][0], c.u[0][1], c.P[i], NULL };
        c.fit.s[i] = c.t[0][0];
        c.fit.r[i] = c.t[0][1];
    }
    c.t[0][0][1] = ldexp(1, -(int)gen_between(g, 54, 80));
    for (size_t m = 0; m < 3; m++) {
        const bool zero = gen_chance(g, 3);
        for (size_t i = 0; i < 6; i++) {
            double *d = &(&data[i].x)[m];
            *d = (double)gen_upto(g, 40) - 20;
            if (normal) /* about the least normal double, above and below */
                *d = (gen_chance(g, 2) ? -1 : 1) * (0x1p52 + (double)gen_upto(g, 4) - 2);
            *d = zero ? 0 : ldexp(*d, -1074);
        }
    }
    take_job(&c, data);
    draw_points(g, &c, NULL);
    return as_again(g, &c, data) ? PASS : FAIL;
}
