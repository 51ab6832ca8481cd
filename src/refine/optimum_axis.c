/* One direction: basis functions at the parameters, which columns count, and a better basis where they are badly conditioned. */
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CHANGED = 64 };                    /* control points of a direction, at most, whose basis is changed: it then has no local support */

static double inside(const optimum_axis *a, double t)
{
    return fmin(fmax(t, a->knots[a->p]), a->knots[a->n]);
}

/* Whether N_j(t) > 0, decided by comparisons alone: t lies within the support, or at an end of it where the function does not vanish. */
static int positive(const optimum_axis *a, size_t j, double t)
{
    const double *const u = a->knots + j;
    const size_t p = a->p;
    const int left = u[0] < t || (u[0] == t && u[p] == t && t < u[p + 1]);
    const int right = t < u[p + 1] || (t == a->knots[a->n] && t == u[p + 1] && u[1] == t && u[0] < t);

    return left && right;
}

static int repeated(const optimum_axis *a, size_t i)
{
    return i > 0 && inside(a, a->t[i]) == inside(a, a->t[i - 1]);
}

/* The greatest set of columns with an increasing choice of parameters at which they are positive.  By the total positivity of B-splines
 * (Schoenberg and Whitney 1953; de Boor 1976) its columns are independent, and there are as many as the rank: the others depend on them. */
static size_t choose_first(optimum_axis *a)
{
    size_t next = 0, count = 0;

    for (size_t i = 0; i < a->nt; i++) {
        size_t j = next > a->first[i] ? next : a->first[i];

        while (j <= a->first[i] + a->p && a->value[i * (a->p + 1) + j - a->first[i]] == 0)
            j++;
        if (!repeated(a, i) && j <= a->first[i] + a->p) {
            a->keep[j] = 1;
            next = j + 1;
            count++;
        }
    }
    return count;
}

/* How many of the first columns are matched with how many of the first parameters, and the sum of the logarithms of their values. */
typedef struct { size_t count; double sum; } matching;

static int better(matching a, matching b)
{
    return a.count > b.count || (a.count == b.count && a.sum > b.sum);
}

/* best[i*(n+1) + j]: of the first i parameters and the first j columns. */
static void match(matching *best, const optimum_axis *a)
{
    const size_t n = a->n, w = a->p + 1;

    for (size_t i = 1; i <= a->nt; i++)
        for (size_t j = 1; j <= n; j++) {
            const size_t k = j - 1 - a->first[i - 1];
            const double x = j > a->first[i - 1] && k < w && !repeated(a, i - 1) ? a->value[(i - 1) * w + k] : 0;
            const matching diagonal = best[(i - 1) * (n + 1) + j - 1];
            const matching with = { diagonal.count + 1, diagonal.sum + (x > 0 ? et_real_log(x) : 0) };
            matching most = best[(i - 1) * (n + 1) + j];

            if (better(best[i * (n + 1) + j - 1], most))
                most = best[i * (n + 1) + j - 1];
            best[i * (n + 1) + j] = x > 0 && better(with, most) ? with : most;
        }
}

/* Of all greatest sets one whose values at its parameters have the greatest product: columns that are barely positive there would make the control
 * points that carry them huge. */
static et_status choose(optimum_axis *a)
{
    size_t entries = 0, i = a->nt, j = a->n;
    matching *best;

    a->whole = 1;
    if (choose_first(a) == a->n)
        return ET_OK;
    if (et_size_mul(&entries, a->nt + 1, a->n + 1) != ET_OK || !(best = et_size_array(entries, sizeof *best)))
        return ET_ENOMEM;
    memset(a->keep, 0, a->n);
    match(best, a);
    while (i > 0 && j > 0) {
        const matching here = best[i * (a->n + 1) + j];
        if (!better(here, best[(i - 1) * (a->n + 1) + j]))
            i--;
        else if (!better(here, best[i * (a->n + 1) + j - 1]))
            j--;
        else {
            i--;
            a->keep[--j] = 1;
        }
    }
    free(best);
    return ET_OK;
}

/* Columns to the same size, by powers of two; those left out are told from zero ones. */
static void equilibrate(optimum_axis *a)
{
    const size_t w = a->p + 1;

    for (size_t j = 0; j < a->n; j++) {
        double most = 0;

        for (size_t i = 0; i < a->nt; i++)
            if (a->first[i] <= j && j <= a->first[i] + a->p)
                most = fmax(most, a->value[i * w + j - a->first[i]]);
        if (most > 0 && !a->keep[j])
            a->whole = 0;
        frexp(most, &a->shift[j]);
        a->shift[j] = -a->shift[j];
        for (size_t i = 0; i < a->nt; i++)
            if (a->first[i] <= j && j <= a->first[i] + a->p)
                a->value[i * w + j - a->first[i]] = ldexp(a->value[i * w + j - a->first[i]], a->shift[j]);
    }
}

static void evaluate(optimum_axis *a)
{
    const size_t w = a->p + 1;

    optimum_ball_axis(a);
    for (size_t i = 0; i < a->nt; i++) {
        const double t = inside(a, a->t[i]);

        a->first[i] = et_knots_span(a->knots, a->n + w, a->p, t) - a->p;
        for (size_t k = 0; k < w; k++)      /* what is positive may have underflowed, but is there */
            a->value[i * w + k] = positive(a, a->first[i] + k, t) ? fmax(a->value[i * w + k], 0x1p-1022) : 0;
    }
}

void optimum_axis_keep_all(optimum_axis *a)
{
    const size_t w = a->p + 1;

    for (size_t k = 0; k < a->nt * w; k++)
        if (a->value[k] != 0)
            a->keep[a->first[k / w] + k % w] = 1;
    a->whole = 1;
}

static int alone(const optimum_axis *a, size_t i, size_t j)
{
    for (size_t k = 0; k <= a->p; k++)
        if ((a->value[i * (a->p + 1) + k] != 0) != (a->first[i] + k == j))
            return 0;
    return 1;
}

et_status optimum_axis_new(optimum_axis *a, const double *knots, size_t n, size_t p, const double *t, size_t nt)
{
    size_t count = 0;
    et_status status = et_size_mul(&count, nt, p + 1);

    *a = (optimum_axis){knots, t, n, p, nt, NULL, NULL, NULL, NULL, 0, 0, NULL, NULL};
    if (status != ET_OK)
        return status;
    a->first = et_size_array(nt, sizeof *a->first);
    a->value = et_size_array(count, sizeof *a->value);
    a->shift = et_size_array(n, sizeof *a->shift);
    a->keep = et_size_array(n, 1);
    if (!a->first || !a->value || !a->shift || !a->keep)
        return ET_ENOMEM;
    evaluate(a);
    a->clamped = alone(a, 0, 0) && alone(a, nt - 1, n - 1);
    status = choose(a);
    if (status == ET_OK)
        equilibrate(a);
    return status;
}

void optimum_axis_free(optimum_axis *a)
{
    free(a->first);
    free(a->value);
    free(a->shift);
    free(a->keep);
    free(a->change);
    free(a->table);
}

/* ---- a better basis ---- */

static double product(const double *a, const double *b, size_t n, size_t stride)
{
    double s = 0;

    for (size_t i = 0; i < n; i++)
        s += a[i * stride] * b[i * stride];
    return s;
}

/* Column j of Q = value T made orthogonal to column k, the same done to T. */
static void part(optimum_axis *a, size_t j, size_t k)
{
    const size_t n = a->n;
    const double share = product(a->table + j, a->table + k, a->nt, n);

    for (size_t i = 0; i < a->nt; i++)
        a->table[i * n + j] -= share * a->table[i * n + k];
    for (size_t i = 0; i < n; i++)
        a->change[i * n + j] -= share * a->change[i * n + k];
}

/* To length one; 0 if there is nothing left of it. */
static int normalise(optimum_axis *a, size_t j)
{
    const size_t n = a->n;
    const double length = sqrt(product(a->table + j, a->table + j, a->nt, n));

    for (size_t i = 0; i < a->nt && length > 0x1p-40; i++)
        a->table[i * n + j] /= length;
    for (size_t i = 0; i < n && length > 0x1p-40; i++)
        a->change[i * n + j] /= length;
    return length > 0x1p-40;
}

static void unchange(optimum_axis *a)
{
    free(a->change);
    free(a->table);
    a->change = a->table = NULL;
}

/* T by Gram and Schmidt, twice for each column: the inner columns in turn, then the two at the ends against the inner ones.  *amplified: how much T
 * amplifies, 0 for no T: too many columns, or rounding has left nothing of one.  ET_ENOMEM. */
static et_status change(double *amplified, optimum_axis *a)
{
    const size_t n = a->n, w = a->p + 1;
    int done = 1;

    *amplified = 0;
    if (n > CHANGED || !a->keep[0] || !a->keep[n - 1])
        return ET_OK;
    a->change = et_size_array(n * n, sizeof *a->change);
    a->table = et_size_array(n, a->nt * sizeof *a->table);
    if (!a->change || !a->table) {
        unchange(a);
        return ET_ENOMEM;
    }
    for (size_t i = 0; i < a->nt; i++)
        for (size_t k = 0; k < w; k++)
            if (a->keep[a->first[i] + k])
                a->table[i * n + a->first[i] + k] = a->value[i * w + k];
    for (size_t step = 1; step <= n && done; step++) {
        const size_t j = step % n == n - 1 ? 0 : step == n ? n - 1 : step, last = j == 0 || j == n - 1 ? n - 1 : j;

        a->change[j * n + j] = 1;
        for (size_t k = 1; k < 2 * last && a->keep[j]; k++)
            if (k % last != 0 && a->keep[k % last])
                part(a, j, k % last);
        done = !a->keep[j] || normalise(a, j);
    }
    if (done)
        *amplified = sqrt(product(a->change, a->change, n * n, 1));
    else
        unchange(a);
    return ET_OK;
}

et_status optimum_axis_change(int *which, optimum_axis *first, optimum_axis *second)
{
    double u = 0, v = 0;
    et_status status = change(&u, first);

    if (status == ET_OK)
        status = change(&v, second);
    *which = -1;
    if (status != ET_OK || u * v <= 64 * sqrt((double)(first->n * second->n))) {
        unchange(first);
        unchange(second);
        return status;
    }
    unchange(u > v ? second : first);
    optimum_ball_table(u > v ? first : second);
    *which = u <= v;
    return ET_OK;
}
