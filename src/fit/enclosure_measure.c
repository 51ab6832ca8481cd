/* enclosure_measure: the backward error of the control points, once the exact solution is known. */
#include "etalon/base/size.h"
#include "fit/enclosure_parts.h"
#include "fit/fit_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One coordinate of one problem: a view's, or that of both views glued. */
typedef struct {
    fit_collocation U, V;
    double *y, *e, *g; /* at data, at control points, at control points */
    double image, gradient, residual, solution; /* sums of squares */
} measure;

static et_status measure_new(measure *m, const enclosure_job *k, size_t w)
{
    const et_surface *s = &k->fit->shell.view[w];
    et_status status, second;

    memset(m, 0, sizeof *m);
    status = fit_collocate(&m->U, k->fit->s[w], k->data.nx, s->u, s->nu, s->p);
    second = fit_collocate(&m->V, k->fit->r[w], k->data.ny, s->v, s->nv, s->q);
    m->y = et_size_array(k->data.nx * k->data.ny, sizeof *m->y);
    m->e = et_size_array(k->control.nx * k->control.ny, sizeof *m->e);
    m->g = et_size_array(k->control.nx * k->control.ny, sizeof *m->g);
    if (status == ET_OK)
        status = second;
    return m->y == NULL || m->e == NULL || m->g == NULL ? ET_ENOMEM : status;
}

static void measure_free(measure *m)
{
    fit_collocation_free(&m->U);
    fit_collocation_free(&m->V);
    free(m->y);
    free(m->e);
    free(m->g);
}

/* y = N e at the data; back: g += N'y. */
static void apply(measure *m, size_t cy, int back)
{
    const size_t p = m->U.w, q = m->V.w;

    for (size_t i = 0; i < m->U.m; i++)
        for (size_t j = 0; j < m->V.m; j++) {
            double *y = m->y + i * m->V.m + j, sum = 0;
            for (size_t k = 0; k < p; k++)
                for (size_t l = 0; l < q; l++) {
                    const size_t at = (m->U.start[i] + k) * cy + m->V.start[j] + l;
                    const double N = m->U.a[i * p + k] * m->V.a[j * q + l];
                    if (back)
                        m->g[at] += N * *y;
                    else
                        sum += N * m->e[at];
                }
            if (!back)
                *y = sum;
        }
}

/* Adds what view w has to say about coordinate c; glued: a border that the first view has counted is left out. */
static void add_view(measure *m, const enclosure_job *k, const enclosure_solution *x, size_t w, size_t c, int glued)
{
    const et_doublenet n = k->data, net = k->control;
    const int counted = glued && w == 1;

    for (size_t at = 0; at < net.nx * net.ny; at++)
        m->e[at] = x->x[w][3 * at + c].hi;
    apply(m, net.ny, 0);
    for (size_t at = 0; at < n.nx * n.ny; at++) {
        const double r = k->D[w][3 * at + c] - m->y[at];
        m->residual += counted && fit_on_border(n, at / n.ny, at % n.ny) ? 0 : r * r;
    }
    for (size_t at = 0; at < net.nx * net.ny; at++) {
        const double P = ldexp((&k->fit->shell.view[w].points[at].x)[c], -k->exponent[c]);
        const int fixed = k->fixed && fit_is_corner(net, at / net.ny, at % net.ny);
        m->e[at] = fixed ? 0 : et_dd_sub((et_dd){P, 0}, x->x[w][3 * at + c]).hi;
        m->solution += fixed || (counted && fit_on_border(net, at / net.ny, at % net.ny)) ? 0 : P * P;
    }
    apply(m, net.ny, 0);
    for (size_t at = 0; at < n.nx * n.ny; at++) {
        m->y[at] = counted && fit_on_border(n, at / n.ny, at % n.ny) ? 0 : m->y[at];
        m->image += m->y[at] * m->y[at];
    }
    apply(m, net.ny, 1);
}

static void add_gradient(measure *m, const enclosure_job *k)
{
    const et_doublenet net = k->control;

    for (size_t at = 0; at < net.nx * net.ny; at++)
        m->gradient += k->fixed && fit_is_corner(net, at / net.ny, at % net.ny) ? 0 : m->g[at] * m->g[at];
}

/* Stewart's two perturbations of A that make P exact (Higham, Accuracy and Stability of Numerical Algorithms, section 20.7): of norms |A'r| / |r| and
 * |A (P - exact)| / |P|, the lesser, relative to |A|.  A'r is A'A (P - exact), free of cancellation. */
static double stewart(const measure *m, double norm)
{
    const double first = m->gradient > 0 ? sqrt(m->gradient / m->residual) : 0, second = m->image > 0 ? sqrt(m->image / m->solution) : 0;
    const double least = first < second ? first : second;

    return norm > 0 ? least / norm / 0x1p-52 : 0;
}

static double backward_coordinate(measure *m, const enclosure_job *k, const enclosure_solution *x, size_t w, size_t c)
{
    const int glued = k->options->approach == ET_FIT_JOINT;

    memset(m->g, 0, k->control.nx * k->control.ny * sizeof *m->g);
    m->image = m->gradient = m->residual = m->solution = 0;
    add_view(m, k, x, w, c, glued);
    if (glued) {
        const et_doublenet net = k->control; /* unknowns of the interior belong to one view each */
        for (size_t i = 1; i + 1 < net.nx; i++)
            for (size_t j = 1; j + 1 < net.ny; j++) {
                m->gradient += m->g[i * net.ny + j] * m->g[i * net.ny + j];
                m->g[i * net.ny + j] = 0;
            }
        add_view(m, k, x, 1, c, glued);
    }
    add_gradient(m, k);
    return stewart(m, x->norm);
}

et_status enclosure_backward(double *backward, const enclosure_job *job, const enclosure_solution *x)
{
    const size_t problems = job->options->approach == ET_FIT_JOINT ? 1 : 2;
    double most = 0;

    for (size_t w = 0; w < problems; w++) {
        measure m;
        const et_status status = measure_new(&m, job, w);
        for (size_t c = 0; status == ET_OK && c < 3; c++) {
            const double b = backward_coordinate(&m, job, x, w, c);
            most = b > most ? b : most;
        }
        measure_free(&m);
        if (status != ET_OK)
            return status;
    }
    *backward = most;
    return ET_OK;
}
