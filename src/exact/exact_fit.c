#include "exact/exact_fit_parts.h"
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- parameters ---- */

static et_status parameters_new(et_fit *fit, et_doublenet net)
{
    memset(fit, 0, sizeof *fit);
    fit->data = net;
    for (size_t w = 0; w < 2; w++) {
        fit->s[w] = et_size_array(net.nx, sizeof(double));
        fit->r[w] = et_size_array(net.ny, sizeof(double));
        if (fit->s[w] == NULL || fit->r[w] == NULL)
            return ET_ENOMEM;
    }
    return ET_OK;
}

/* One view's parameters, before they are standardised; *most becomes the greatest number of bits that was needed. */
static et_status parameters_of(et_fit *fit, const et_vec3 *data, size_t w, et_param_method method, size_t begin, size_t *most)
{
    const et_doublenet n = fit->data;
    et_vec3 *D = et_size_array(n.nx * n.ny, sizeof *D);
    size_t flat = 0, bits = begin;
    et_status status;

    if (D == NULL)
        return ET_ENOMEM;
    for (size_t i = 0; i < n.nx; i++)
        for (size_t j = 0; j < n.ny; j++)
            D[i * n.ny + j] = data[et_doublenet_class(n, w, i, j) - 1];
    status = et_exact_param_grid(fit->s[w], n.nx, fit->r[w], n.ny, &flat, D, method, &bits);
    free(D);
    if (status == ET_OK) {
        fit->flat += flat;
        *most = bits > *most ? bits : *most;
    }
    return status;
}

et_status et_exact_fit_parameters(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, et_fit_approach approach, et_param_method method,
                                  size_t *bits)
{
    size_t most = 0;
    et_fit made;
    et_status status;

    if (!et_doublenet_valid(net) || nov != et_doublenet_nov(net) || et_fit_name(approach) == NULL || et_param_name(method) == NULL)
        return ET_EINVAL;
    status = parameters_new(&made, net);
    for (size_t w = 0; status == ET_OK && w < 2; w++)
        status = parameters_of(&made, data, w, method, bits == NULL ? 0 : *bits, &most);
    if (status != ET_OK) {
        et_fit_free(&made);
        return status;
    }
    if (approach != ET_FIT_CONVENTIONAL) {
        et_exact_param_standardise(made.s[0], made.s[1], net.nx);
        et_exact_param_standardise(made.r[0], made.r[1], net.ny);
    }
    *fit = made;
    if (bits != NULL)
        *bits = most;
    return ET_OK;
}

/* ---- what can be solved ---- */

static int same(const double *a, const double *b, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (a[i] != b[i])
            return 0;
    return 1;
}

/* Parameters t[0..n-1] from one end of the domain to the other, on clamped knots. */
static int direction_valid(const double *t, size_t n, const double *u, size_t control, size_t p)
{
    if (t == NULL || u == NULL || !et_knots_valid(u, control + p + 1, p) || !et_knots_clamped(u, control + p + 1, p))
        return 0;
    for (size_t i = 1; i < n; i++)
        if (!(t[i - 1] <= t[i]))
            return 0;
    return t[0] == u[p] && t[n - 1] == u[control];
}

static int view_valid(const et_fit *fit, size_t w)
{
    const et_surface *view = &fit->shell.view[w], *first = &fit->shell.view[0];

    return view->p >= 1 && view->q >= 1 && view->p < view->nu && view->q < view->nv && view->p == first->p && view->q == first->q &&
           view->nu == first->nu && view->nv == first->nv && view->points != NULL && view->weights == NULL &&
           direction_valid(fit->s[w], fit->data.nx, view->u, view->nu, view->p) &&
           direction_valid(fit->r[w], fit->data.ny, view->v, view->nv, view->q);
}

static int views_equal(const et_fit *fit)
{
    const et_surface *a = &fit->shell.view[0], *b = &fit->shell.view[1];

    return same(fit->s[0], fit->s[1], fit->data.nx) && same(fit->r[0], fit->r[1], fit->data.ny) && same(a->u, b->u, a->nu + a->p + 1) &&
           same(a->v, b->v, a->nv + a->q + 1);
}

static et_status check_fit(const et_fit *fit, size_t nov, const et_fit_options *o, et_message *message)
{
    if (et_fit_name(o->approach) == NULL || (unsigned)o->corners > ET_CORNERS_INTERPOLATED)
        return et_status_fail(message, ET_EINVAL, "a fit option is not one of its enumeration");
    if (!et_doublenet_valid(fit->data) || nov != et_doublenet_nov(fit->data))
        return et_status_fail(message, ET_EINVAL, "%zu points are not the classes of a double net %zux%zu", nov, fit->data.nx, fit->data.ny);
    for (size_t w = 0; w < 2; w++)
        if (!view_valid(fit, w))
            return et_status_fail(message, ET_EINVAL, "%s view: not a polynomial surface on clamped knots with parameters from end to end",
                                  w == 0 ? "bottom" : "top");
    if (!et_doublenet_valid(et_shell_net(&fit->shell)))
        return et_status_fail(message, ET_EINVAL, "the control net is too large");
    if (o->approach != ET_FIT_CONVENTIONAL && !views_equal(fit))
        return et_status_fail(message, ET_EINVAL, "the views' parameters or knots differ");
    return ET_OK;
}

/* ---- the solution ---- */

static void problem_init(exact_fit *f, const et_fit *fit, const et_vec3 *data, const et_fit_options *o)
{
    f->data = fit->data;
    f->control = et_shell_net(&fit->shell);
    f->approach = o->approach;
    f->fixed = o->corners == ET_CORNERS_INTERPOLATED || (o->corners == ET_CORNERS_DEFAULT && o->approach == ET_FIT_IMPROVED);
    f->D = data;
    for (size_t w = 0; w < 2; w++) {
        const et_surface *view = &fit->shell.view[w];
        fmpq_mat_init(&f->A[w][0], (slong)f->data.nx, (slong)f->control.nx);
        fmpq_mat_init(&f->A[w][1], (slong)f->data.ny, (slong)f->control.ny);
        exact_collocation(&f->A[w][0], fit->s[w], view->u, view->p);
        exact_collocation(&f->A[w][1], fit->r[w], view->v, view->q);
    }
}

static void problem_clear(exact_fit *f)
{
    for (size_t k = 0; k < 4; k++)
        fmpq_mat_clear(&f->A[k / 2][k % 2]);
}

static int all_finite(const et_vec3 *P, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(P[i].x) || !isfinite(P[i].y) || !isfinite(P[i].z))
            return 0;
    return 1;
}

/* The control points of both views, one after the other, into P. */
static et_status solve(et_vec3 *P, const et_fit *fit, const et_vec3 *data, const et_fit_options *options, size_t *bits, const et_task *task,
                       et_message *message)
{
    const size_t n = fit->shell.view[0].nu * fit->shell.view[0].nv;
    size_t used = bits == NULL ? 0 : *bits;
    exact_fit f;
    et_status status;

    problem_init(&f, fit, data, options);
    f.P[0] = P;
    f.P[1] = P + n;
    status = exact_fit_run(&f, &used, task, message);
    problem_clear(&f);
    if (status == ET_OK && !all_finite(P, 2 * n))
        status = et_status_fail(message, ET_EFORMAT, "the control points overflow: the data are too large");
    if (status == ET_OK && bits != NULL)
        *bits = used;
    return status;
}

et_status et_exact_fit_solve(et_fit *fit, const et_vec3 *data, size_t nov, const et_fit_options *options, size_t *bits, const et_task *task,
                             et_message *message)
{
    et_status status = check_fit(fit, nov, options, message);
    et_vec3 *P;
    size_t n;

    if (status != ET_OK)
        return status;
    n = fit->shell.view[0].nu * fit->shell.view[0].nv;
    P = et_size_array(2 * n, sizeof *P);
    if (P == NULL)
        return et_status_fail(message, ET_ENOMEM, "%s", et_status_text(ET_ENOMEM));
    status = solve(P, fit, data, options, bits, task, message);
    for (size_t w = 0; status == ET_OK && w < 2; w++)
        memcpy(fit->shell.view[w].points, P + w * n, n * sizeof *P);
    free(P);
    return status;
}

/* ---- all stages ---- */

/* As et_fit_make has it. */
static et_status check_options(et_doublenet n, const et_fit_options *o, et_message *message)
{
    const et_doublenet c = o->control;

    if (et_fit_name(o->approach) == NULL || et_param_name(o->method) == NULL || et_knotrule_name(o->knots) == NULL ||
        (unsigned)o->corners > ET_CORNERS_INTERPOLATED)
        return et_status_fail(message, ET_EINVAL, "a fit option is not one of its enumeration");
    if (!et_doublenet_valid(c))
        return et_status_fail(message, ET_EINVAL, "a control net %zux%zu is too small", c.nx, c.ny);
    if (c.nx > n.nx || c.ny > n.ny)
        return et_status_fail(message, ET_EINVAL, "control net %zux%zu is larger than the data %zux%zu", c.nx, c.ny, n.nx, n.ny);
    if (o->p < 1 || o->q < 1 || o->p >= c.nx || o->q >= c.ny)
        return et_status_fail(message, ET_EINVAL, "degrees %zu and %zu do not suit a control net %zux%zu: at least 1, less than its side", o->p, o->q,
                              c.nx, c.ny);
    if (o->knots == ET_KNOTRULE_AVERAGING && (c.nx != n.nx || c.ny != n.ny))
        return et_status_fail(message, ET_EINVAL, "averaged knots need as many control points (%zux%zu) as data (%zux%zu)", c.nx, c.ny, n.nx, n.ny);
    return ET_OK;
}

static et_status knots_of(et_fit *fit, const et_fit_options *o)
{
    const et_doublenet n = fit->data, c = o->control;
    et_status status = et_shell_new(&fit->shell, o->p, o->q, c, 0);

    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        const et_surface *view = &fit->shell.view[w];
        status = et_exact_knotrule_make(view->u, c.nx + o->p + 1, o->p, fit->s[w], n.nx, o->knots);
        if (status == ET_OK)
            status = et_exact_knotrule_make(view->v, c.ny + o->q + 1, o->q, fit->r[w], n.ny, o->knots);
        if (status == ET_OK && (!et_knots_valid(view->u, c.nx + o->p + 1, o->p) || !et_knots_valid(view->v, c.ny + o->q + 1, o->q)))
            status = ET_EFORMAT; /* closer than 2^-1022: distances of 1 and of 1e308 in one row */
    }
    return status;
}

et_status et_exact_fit_make(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, const et_fit_options *options, size_t *bits,
                            const et_task *task, et_message *message)
{
    size_t line = bits == NULL ? 0 : *bits, point = line;
    et_fit made;
    et_status status;

    if (!et_doublenet_valid(net) || nov != et_doublenet_nov(net))
        return et_status_fail(message, ET_EINVAL, "%zu points are not the classes of a double net %zux%zu", nov, net.nx, net.ny);
    status = check_options(net, options, message);
    if (status != ET_OK)
        return status;
    status = et_exact_fit_parameters(&made, data, nov, net, options->approach, options->method, &line);
    if (status != ET_OK)
        return et_status_fail(message, status, "parameters: %s", et_status_text(status));
    status = knots_of(&made, options);
    if (status != ET_OK)
        et_status_fail(message, status, "knots: %s", et_status_text(status));
    else
        status = et_exact_fit_solve(&made, data, nov, options, &point, task, message);
    if (status != ET_OK) {
        et_fit_free(&made);
        return status;
    }
    *fit = made;
    if (bits != NULL)
        *bits = line > point ? line : point;
    return ET_OK;
}
