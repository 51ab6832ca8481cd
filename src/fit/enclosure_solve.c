/* enclosure_solve: one right-hand side in double-double, and how far the result can be from the exact solution. */
#include "fit/enclosure_parts.h"
#include <math.h>
#include <string.h>

/* r = d - A x. */
static void residual(enclosure_system *s, const et_dd *d, const et_dd *x)
{
    for (size_t i = 0; i < s->rows; i++) {
        et_dd sum = d[i];
        for (size_t k = 0; k < s->width; k++)
            sum = et_dd_sub(sum, et_dd_mul(s->a[i * s->width + k], x[s->at[i * s->width + k]]));
        s->r[i] = sum;
    }
}

/* g = A'W r. */
static void gradient(enclosure_system *s)
{
    memset(s->g, 0, s->columns * sizeof *s->g);
    for (size_t i = 0; i < s->rows; i++) {
        const et_dd r = {s->weight[i] * s->r[i].hi, s->weight[i] * s->r[i].lo}; /* times 1 or 2: exact */
        for (size_t k = 0; k < s->width; k++) {
            et_dd *g = s->g + s->at[i * s->width + k];
            *g = et_dd_add(*g, et_dd_mul(s->a[i * s->width + k], r));
        }
    }
}

/* z = T'g, summed in double-double and rounded: rounded on the way, cancellation would cost the condition number once more.  Returns the greatest
 * |z_j|, NaN if one is. */
static double to_orthonormal(double *z, enclosure_system *s)
{
    const size_t n = s->columns;
    double most = 0;

    memset(s->z, 0, n * sizeof *s->z);
    for (size_t i = 0; i < n; i++)
        for (size_t j = i; j < n; j++)
            s->z[j] = et_dd_add(s->z[j], et_dd_mul((et_dd){s->T[i * n + j], 0}, s->g[i]));
    for (size_t j = 0; j < n; j++) {
        z[j] = s->z[j].hi;
        most = fabs(z[j]) <= most ? most : fabs(z[j]); /* if one is NaN so is the last: T is triangular */
    }
    return most;
}

/* x += fl(T z). */
static void add_step(et_dd *x, const double *z, const enclosure_system *s)
{
    const size_t n = s->columns;

    for (size_t i = 0; i < n; i++) {
        double e = 0;
        for (size_t j = i; j < n; j++)
            e += s->T[i * n + j] * z[j];
        x[i] = et_dd_add(x[i], (et_dd){e, 0});
    }
}

/* x += T T'A'W (d - A x) while that halves z = T'A'W (d - A x) at least; at the end r, g and z belong to x.  Measured by z, the error shrinks by
 * || I - B'W B || a step; in x itself it need not. */
static void iterate(et_dd *x, enclosure_system *s, const et_dd *d, double *z)
{
    double before = HUGE_VAL;

    for (;;) {
        residual(s, d, x);
        gradient(s);
        const double now = to_orthonormal(z, s);
        if (!(now <= before / 2) || now == 0)
            return;
        add_step(x, z, s);
        before = now;
    }
}

/* q_i >= |r_i - (d - A x)_i| for the exact d and A.  Of w products and w differences: a product's 7 u^2, and at most w + 1 sums of 3 u^2 + 13 u^3
 * over a term; the sum of terms in double is short by at most (w + 2) u of itself. */
static void residual_error(double *q, const enclosure_system *s, const et_dd *d, const double *error, const et_dd *x)
{
    const double w = (double)s->width, rounding = (4 * (w + 1) + 8) * ENCLOSURE_UNIT2;

    for (size_t i = 0; i < s->rows; i++) {
        double sum = 0, most = 0;
        for (size_t k = 0; k < s->width; k++) {
            const double y = fabs(x[s->at[i * s->width + k]].hi);
            sum += s->a[i * s->width + k].hi * y;
            most = y > most ? y : most;
        }
        q[i] = (error[i] + (rounding * fabs(d[i].hi) + (rounding + s->relative) * sum)) * (1 + (w + 8) * 0x1p-52) +
               2 * w * ENCLOSURE_TINY * (1 + most);
    }
}

/* v_j >= |g_j - (A'W r)_j| for the exact A and the r at hand: of at most `tall` products and sums each. */
static void gradient_error(double *v, const enclosure_system *s)
{
    const double tall = (double)s->tall, factor = s->relative + (4 * (tall + 1) + 8) * ENCLOSURE_UNIT2;

    memset(v, 0, s->columns * sizeof *v);
    for (size_t i = 0; i < s->rows; i++) {
        const double r = s->weight[i] * fabs(s->r[i].hi);
        for (size_t k = 0; k < s->width; k++)
            v[s->at[i * s->width + k]] += s->a[i * s->width + k].hi * r * factor + 2 * ENCLOSURE_TINY * (1 + r);
    }
    for (size_t j = 0; j < s->columns; j++)
        v[j] *= 1 + ((double)s->rows * (double)s->width + 8) * 0x1p-52;
}

/* The exact error is e = T (B'W B)^-1 B'W (d - A x), and B'W (d - A x) = T'(A'W r) + B'W (d - A x - r) is at most, component by component,
 *   |z| + |T|'(c u^2 |g| + v) + C'W q,      c = 4 (n + 1) + 8,
 * each component of T'g being a sum of at most n products (7 u^2 each, and 3 u^2 + 13 u^3 a sum).  Then |e| <= |T| (zeta + defect max zeta).
 * The last factor covers the roundings of these sums of terms >= 0, of z and of g to their upper parts. */
static void bound(double *radius, enclosure_system *s, double *zeta, const double *q, const double *v)
{
    const size_t n = s->columns, m = s->rows;
    const double c = (4 * ((double)n + 1) + 8) * ENCLOSURE_UNIT2, inflate = 1 + ((double)(m + 2 * n) + 16) * 0x1p-51;
    double most = 0, sum;

    for (size_t j = 0; j < n; j++)
        zeta[j] = fabs(zeta[j]) + ENCLOSURE_TINY;
    for (size_t i = 0; i < n; i++) {
        const double x = c * fabs(s->g[i].hi) + v[i];
        for (size_t j = i; j < n; j++)
            zeta[j] += fabs(s->T[i * n + j]) * x;
    }
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < n; j++)
            zeta[j] += s->C[i * n + j] * (s->weight[i] * q[i]);
    for (size_t j = 0; j < n; j++)
        most = zeta[j] <= most ? most : zeta[j]; /* if one is NaN so is the last */
    for (size_t i = 0; i < n; i++) {
        sum = 0;
        for (size_t j = i; j < n; j++)
            sum += fabs(s->T[i * n + j]) * (zeta[j] + s->defect * most);
        radius[i] = sum * inflate + ENCLOSURE_TINY;
    }
}

static int all_zero(const et_dd *d, const double *error, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (d[i].hi != 0 || error[i] != 0)
            return 0;
    return 1;
}

/* Starts from zero: the result depends on the data alone, not on a solution that some library gave. */
void enclosure_column(et_dd *x, double *radius, enclosure_system *s, const et_dd *d, const double *error)
{
    const size_t n = s->columns;
    double *z = s->work, *v = z + n, *q = v + n;

    memset(x, 0, n * sizeof *x);
    memset(radius, 0, n * sizeof *radius);
    if (n == 0 || all_zero(d, error, s->rows))
        return;
    iterate(x, s, d, z);
    residual_error(q, s, d, error, x);
    gradient_error(v, s);
    bound(radius, s, z, q, v);
}
