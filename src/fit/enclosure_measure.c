/* enclosure_measure: the backward error of the control points, once the exact solution is known. */
#include "etalon/base/size.h"
#include "fit/enclosure_parts.h"
#include "fit/fit_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 40 };

/* One least-squares problem: a view's, or that of both views glued.  Vectors of unknowns have cx cy entries a view; the second view's border and
 * fixed corners stay zero. */
typedef struct {
    const enclosure_job *job;
    fit_collocation U, V;
    size_t first, views, nodes, points;
    double *y;                    /* at data */
    double *e, *g, *p, *q, *full; /* at control points */
} measure;

static et_status measure_new(measure *m, const enclosure_job *k, size_t first, size_t views)
{
    const et_surface *s = &k->fit->shell.view[first];
    et_status status, second;

    memset(m, 0, sizeof *m);
    m->job = k;
    m->first = first;
    m->views = views;
    m->nodes = k->data.nx * k->data.ny;
    m->points = k->control.nx * k->control.ny;
    status = fit_collocate(&m->U, k->fit->s[first], k->data.nx, s->u, s->nu, s->p);
    second = fit_collocate(&m->V, k->fit->r[first], k->data.ny, s->v, s->nv, s->q);
    m->y = et_size_array(m->nodes, 2 * sizeof *m->y);
    m->e = et_size_array(m->points, 10 * sizeof *m->e);
    if (m->e != NULL) {
        m->g = m->e + 2 * m->points;
        m->p = m->g + 2 * m->points;
        m->q = m->p + 2 * m->points;
        m->full = m->q + 2 * m->points;
    }
    if (status == ET_OK)
        status = second;
    return m->y == NULL || m->e == NULL ? ET_ENOMEM : status;
}

static void measure_free(measure *m)
{
    fit_collocation_free(&m->U);
    fit_collocation_free(&m->V);
    free(m->y);
    free(m->e);
}

/* Whether entry `at` of the view's part stands for an unknown. */
static int unknown(const measure *m, size_t w, size_t at)
{
    const et_doublenet c = m->job->control;
    const size_t i = at / c.ny, j = at % c.ny;

    return !(m->job->fixed && fit_is_corner(c, i, j)) && !(w == 1 && fit_on_border(c, i, j));
}

static double square(const double *x, size_t n)
{
    double sum = 0;

    for (size_t i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sum;
}

/* y = N x of one view, all its control points given. */
static void view_image(double *y, const measure *m, const double *x)
{
    for (size_t i = 0; i < m->U.m; i++)
        for (size_t j = 0; j < m->V.m; j++) {
            double sum = 0;
            for (size_t k = 0; k < m->U.w; k++)
                for (size_t l = 0; l < m->V.w; l++)
                    sum += m->U.a[i * m->U.w + k] * m->V.a[j * m->V.w + l] * x[(m->U.start[i] + k) * m->V.n + m->V.start[j] + l];
            y[i * m->V.m + j] = sum;
        }
}

/* x += N'y. */
static void view_adjoint(double *x, const measure *m, const double *y)
{
    for (size_t i = 0; i < m->U.m; i++)
        for (size_t j = 0; j < m->V.m; j++)
            for (size_t k = 0; k < m->U.w; k++)
                for (size_t l = 0; l < m->V.w; l++)
                    x[(m->U.start[i] + k) * m->V.n + m->V.start[j] + l] += m->U.a[i * m->U.w + k] * m->V.a[j * m->V.w + l] * y[i * m->V.m + j];
}

/* A border that the first view has counted is not counted again. */
static void clear_border(double *y, et_doublenet n)
{
    for (size_t at = 0; at < n.nx * n.ny; at++)
        if (fit_on_border(n, at / n.ny, at % n.ny))
            y[at] = 0;
}

/* y = A x. */
static void image(double *y, const measure *m, const double *x)
{
    for (size_t w = 0; w < m->views; w++) {
        for (size_t at = 0; at < m->points; at++)
            m->full[at] = w == 1 && fit_on_border(m->job->control, at / m->V.n, at % m->V.n) ? x[at] : x[w * m->points + at];
        view_image(y + w * m->nodes, m, m->full);
        if (w == 1)
            clear_border(y + m->nodes, m->job->data);
    }
}

/* x = A'y. */
static void adjoint(double *x, const measure *m, const double *y)
{
    memset(x, 0, m->views * m->points * sizeof *x);
    for (size_t w = 0; w < m->views; w++)
        view_adjoint(x + w * m->points, m, y + w * m->nodes);
    for (size_t at = 0; m->views == 2 && at < m->points; at++)
        if (fit_on_border(m->job->control, at / m->V.n, at % m->V.n))
            x[at] += x[m->points + at];
    for (size_t at = 0; at < m->views * m->points; at++)
        x[at] = unknown(m, at / m->points, at % m->points) ? x[at] : 0;
}

/* Takes coordinate c: e = P - exact; *solution = |P|^2 over the unknowns, and *residual = |d - N P|^2. */
static void take(measure *m, const enclosure_solution *x, size_t c, double *solution, double *residual)
{
    const enclosure_job *k = m->job;

    *solution = *residual = 0;
    for (size_t w = 0; w < m->views; w++) {
        for (size_t at = 0; at < m->points; at++) {
            const double P = ldexp((&k->fit->shell.view[m->first + w].points[at].x)[c], -k->exponent[c]);
            const int free_one = unknown(m, w, at);
            m->full[at] = P;
            m->e[w * m->points + at] = free_one ? et_dd_sub((et_dd){P, 0}, x->x[m->first + w][3 * at + c]).hi : 0;
            *solution += free_one ? P * P : 0;
        }
        view_image(m->y, m, m->full);
        for (size_t at = 0; at < m->nodes; at++)
            m->y[at] = k->D[m->first + w][3 * at + c] - m->y[at];
        if (w == 1)
            clear_border(m->y, k->data);
        *residual += square(m->y, m->nodes);
    }
}

/* g'(A'A + shift I)^-1 g: the sum that conjugate gradients build up from below.  g becomes their residual. */
static double quadratic(measure *m, double shift)
{
    const size_t n = m->views * m->points;
    double value = 0, before = square(m->g, n);
    const double enough = before * 0x1p-60;

    memcpy(m->p, m->g, n * sizeof *m->p);
    for (int k = 0; k < STEPS && before > enough; k++) {
        double curvature = 0, after;
        image(m->y, m, m->p);
        adjoint(m->q, m, m->y);
        for (size_t i = 0; i < n; i++) {
            m->q[i] += shift * m->p[i];
            curvature += m->p[i] * m->q[i];
        }
        if (!(curvature > 0))
            break;
        value += before / curvature * before;
        for (size_t i = 0; i < n; i++)
            m->g[i] -= before / curvature * m->q[i];
        after = square(m->g, n);
        for (size_t i = 0; i < n; i++)
            m->p[i] = m->g[i] + after / before * m->p[i];
        before = after;
    }
    return value;
}

/* |(A'A + t^2 I)^-1/2 A'r| / |x|, t = |r| / |x|, relative to |A| (Karlson and Walden 1997); where A'A is nothing beside t^2, |A'r| / |r|.  A'r is
 * A'A e, free of cancellation.  Infinite where squares are past any range: points 2^500 times as large as the data. */
static double coordinate(measure *m, const enclosure_solution *x, size_t c)
{
    double solution, residual, gradient, value;

    take(m, x, c, &solution, &residual);
    image(m->y, m, m->e);
    adjoint(m->g, m, m->y);
    gradient = square(m->g, m->views * m->points);
    if (gradient == 0)
        return 0;
    if (!(solution < 0x1p1000) || !(residual < 0x1p1000) || !(gradient < 0x1p1000))
        return HUGE_VAL;
    value = solution > residual * 0x1p-900 ? sqrt(quadratic(m, residual / solution) / solution) : sqrt(gradient / residual);
    return value / x->norm / 0x1p-52;
}

et_status enclosure_backward(double *backward, const enclosure_job *job, const enclosure_solution *x)
{
    const size_t views = job->options->approach == ET_FIT_JOINT ? 2 : 1;
    double most = 0;

    for (size_t first = 0; first < 2; first += views) {
        measure m;
        const et_status status = measure_new(&m, job, first, views);
        for (size_t c = 0; status == ET_OK && c < 3; c++) {
            const double b = coordinate(&m, x, c);
            most = b > most ? b : most;
        }
        measure_free(&m);
        if (status != ET_OK)
            return status;
    }
    *backward = most;
    return ET_OK;
}
