#include "etalon/fit/fit.h"
#include "etalon/base/size.h"
#include "fit/fit_parts.h"
#include <stdlib.h>
#include <string.h>

static const char *const names[] = {"conventional", "improved", "joint"};
static const char *const view_names[] = {"bottom view", "top view"};

const char *et_fit_name(et_fit_approach approach)
{
    return (unsigned)approach < sizeof names / sizeof *names ? names[approach] : NULL;
}

et_fit_options et_fit_defaults(void)
{
    return (et_fit_options){ET_FIT_IMPROVED, ET_PARAM_CHORD, ET_KNOTRULE_PIEGL, ET_LINALG_QR, ET_CORNERS_DEFAULT, 3, 3, {12, 12}};
}

/* ---- data ---- */

/* The grid D[i*ny + j] of one view.  The bottom's classes are numbered in just that order. */
/*@ requires net:    et_net_ok(net.nx, net.ny) && view <= 1;
    requires valid:  \valid(D + (0 .. net.nx * net.ny - 1)) && \valid_read(data + (0 .. NOV(net.nx, net.ny) - 1));
    assigns  D[0 .. net.nx * net.ny - 1];
*/
static void view_grid(et_vec3 *D, const et_vec3 *data, et_doublenet net, size_t view)
{
    /*@ loop invariant place:  i <= net.nx;
        loop assigns i, D[0 .. net.nx * net.ny - 1];
        loop variant net.nx - i;
    */
    for (size_t i = 0; i < net.nx; i++)
        /*@ loop invariant place:  j <= net.ny;
            loop assigns j, D[0 .. net.nx * net.ny - 1];
            loop variant net.ny - j;
        */
        for (size_t j = 0; j < net.ny; j++) {
            //@ ghost fact_product(i + 1, net.nx, net.ny);
            //@ assert inside: 0 <= i * net.ny && i * net.ny + j < net.nx * net.ny;
            D[i * net.ny + j] = data[et_doublenet_class(net, view, i, j) - 1];
        }
}

/* ---- parameters ---- */

/*@ requires fit:    \valid(fit);
    assigns  *fit;
    ensures  status: \result == ET_OK || \result == ET_ENOMEM;
    ensures  bottom: \result == ET_OK ==> et_numbers(fit->s[0], net.nx) && et_numbers(fit->r[0], net.ny);
    ensures  top:    \result == ET_OK ==> et_numbers(fit->s[1], net.nx) && et_numbers(fit->r[1], net.ny);
    ensures  flat:   fit->flat == 0;
*/
static et_status allocate_parameters(et_fit *fit, et_doublenet net)
{
    memset(fit, 0, sizeof *fit);
    fit->data = net;
    /*@ loop invariant place:  w <= 2;
        loop invariant flat:   fit->flat == 0;
        loop invariant bottom: 1 <= w ==> et_numbers(fit->s[0], net.nx) && et_numbers(fit->r[0], net.ny);
        loop invariant top:    2 <= w ==> et_numbers(fit->s[1], net.nx) && et_numbers(fit->r[1], net.ny);
        loop assigns w, fit->s[0 .. 1], fit->r[0 .. 1];
        loop variant 2 - w;
    */
    for (size_t w = 0; w < 2; w++) {
        fit->s[w] = et_size_array(net.nx, sizeof(double));
        fit->r[w] = et_size_array(net.ny, sizeof(double));
        if (fit->s[w] == NULL || fit->r[w] == NULL)
            return ET_ENOMEM;
        //@ ghost fact_array(fit->s[w], net.nx);
        //@ ghost fact_array(fit->r[w], net.ny);
    }
    return ET_OK;
}

et_status et_fit_parameters(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, et_fit_approach approach, et_param_method method)
{
    et_fit made;
    et_vec3 *D;
    et_status status;

    if (!et_doublenet_valid(net) || nov != et_doublenet_nov(net) || et_fit_name(approach) == NULL || et_param_name(method) == NULL)
        return ET_EINVAL;
    status = allocate_parameters(&made, net);
    D = et_size_array(net.nx * net.ny, sizeof *D);
    if (D == NULL)
        status = ET_ENOMEM;
    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        size_t flat = 0;
        view_grid(D, data, net, w);
        status = et_param_grid(made.s[w], net.nx, made.r[w], net.ny, &flat, D, method);
        made.flat += flat;
    }
    free(D);
    if (status != ET_OK) {
        et_fit_free(&made);
        return status;
    }
    if (approach != ET_FIT_CONVENTIONAL) {
        et_param_standardise(made.s[0], made.s[1], net.nx);
        et_param_standardise(made.r[0], made.r[1], net.ny);
    }
    *fit = made;
    return ET_OK;
}

void et_fit_free(et_fit *fit)
{
    et_shell_free(&fit->shell);
    /*@ loop invariant place: w <= 2;
        loop assigns w;
        loop variant 2 - w;
    */
    for (size_t w = 0; w < 2; w++) {
        free(fit->s[w]);
        free(fit->r[w]);
    }
    memset(fit, 0, sizeof *fit);
}

/* ---- the three approaches ---- */

typedef struct {
    const et_fit_options *options;
    int fixed;
    et_vec3 *D[2];
    fit_collocation U[2], V[2];
} job;

static et_status run_separate(et_fit *fit, const job *k, et_message *message)
{
    const et_fit_options *o = k->options;
    et_status status = ET_OK;

    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        et_vec3 *P = fit->shell.view[w].points;
        if (k->fixed && o->approach == ET_FIT_CONVENTIONAL) {
            const fit_glued g = {1, 1, fit->data, o->control, &k->U[w], &k->V[w], {k->D[w], NULL}, {P, NULL}, view_names[w]};
            status = fit_solve_glued(&g, o->algebra, message);
        } else {
            status = fit_solve_view(P, &k->U[w], &k->V[w], k->D[w], view_names[w], o->algebra, message);
        }
    }
    return status;
}

/* Border control points of equal class become their mean (Eq. 5.7); corners, where fixed, the data's. */
/*@ requires valid: \valid_read(fit) && \valid_read(k) && \valid_read(k->options);
    requires nets:  et_net_ok(k->options->control.nx, k->options->control.ny) && et_net_ok(fit->data.nx, fit->data.ny);
    requires views: \valid(fit->shell.view[0].points + (0 .. k->options->control.nx * k->options->control.ny - 1)) &&
                    \valid(fit->shell.view[1].points + (0 .. k->options->control.nx * k->options->control.ny - 1));
    requires grid:  \valid_read(k->D[0] + (0 .. fit->data.nx * fit->data.ny - 1));
    requires apart: \separated(fit->shell.view[0].points + (0 .. k->options->control.nx * k->options->control.ny - 1), fit, k, k->options) &&
                    \separated(fit->shell.view[1].points + (0 .. k->options->control.nx * k->options->control.ny - 1), fit, k, k->options);
    assigns  fit->shell.view[0].points[0 .. k->options->control.nx * k->options->control.ny - 1],
             fit->shell.view[1].points[0 .. k->options->control.nx * k->options->control.ny - 1];
*/
static void close_border(et_fit *fit, const job *k)
{
    const et_doublenet c = k->options->control;

    /*@ loop invariant place: i <= c.nx;
        loop assigns i, fit->shell.view[0].points[0 .. c.nx * c.ny - 1], fit->shell.view[1].points[0 .. c.nx * c.ny - 1];
        loop variant c.nx - i;
    */
    for (size_t i = 0; i < c.nx; i++)
        /*@ loop invariant place: j <= c.ny;
            loop assigns j, fit->shell.view[0].points[0 .. c.nx * c.ny - 1], fit->shell.view[1].points[0 .. c.nx * c.ny - 1];
            loop variant c.ny - j;
        */
        for (size_t j = 0; j < c.ny; j++) {
            //@ ghost fact_product(i + 1, c.nx, c.ny);
            //@ assert inside: 0 <= i * c.ny && i * c.ny + j < c.nx * c.ny;
            et_vec3 *a = &fit->shell.view[ET_BOTTOM].points[i * c.ny + j], *b = &fit->shell.view[ET_TOP].points[i * c.ny + j];
            if (k->fixed && fit_is_corner(c, i, j))
                *a = *b = fit_corner(k->D[0], fit->data, i != 0, j != 0);
            else if (fit_on_border(c, i, j))
                *a = *b = (et_vec3){(a->x + b->x) / 2, (a->y + b->y) / 2, (a->z + b->z) / 2};
        }
}

static et_status run(et_fit *fit, const job *k, et_message *message)
{
    const et_fit_options *o = k->options;
    et_surface *view = fit->shell.view;
    et_status status;

    if (o->approach == ET_FIT_JOINT) {
        const fit_glued g = {2, k->fixed, fit->data, o->control, &k->U[0], &k->V[0], {k->D[0], k->D[1]}, {view[0].points, view[1].points},
                             "both views"};
        status = fit_solve_glued(&g, o->algebra, message);
    } else {
        status = run_separate(fit, k, message);
        if (status == ET_OK && o->approach == ET_FIT_IMPROVED)
            close_border(fit, k);
    }
    if (status == ET_OK && !et_shell_valid(&fit->shell))
        return et_status_fail(message, ET_EFORMAT, "the control points overflow: the data are too large");
    return status;
}

static et_status prepare_view(et_fit *fit, job *k, size_t w, const et_vec3 *data)
{
    const et_fit_options *o = k->options;
    const et_doublenet n = fit->data, c = o->control;
    et_surface *view = &fit->shell.view[w];
    et_status status = et_knotrule_make(view->u, c.nx + o->p + 1, o->p, fit->s[w], n.nx, o->knots);

    if (status == ET_OK)
        status = et_knotrule_make(view->v, c.ny + o->q + 1, o->q, fit->r[w], n.ny, o->knots);
    if (status == ET_OK)
        status = fit_collocate(&k->U[w], fit->s[w], n.nx, view->u, c.nx, o->p);
    if (status == ET_OK)
        status = fit_collocate(&k->V[w], fit->r[w], n.ny, view->v, c.ny, o->q);
    if (status != ET_OK)
        return status;
    k->D[w] = et_size_array(n.nx * n.ny, sizeof *k->D[w]);
    if (k->D[w] == NULL)
        return ET_ENOMEM;
    view_grid(k->D[w], data, n, w);
    return ET_OK;
}

static et_status make(et_fit *fit, const et_vec3 *data, const et_fit_options *o, et_message *message)
{
    job k;
    et_status status = et_shell_new(&fit->shell, o->p, o->q, o->control, 0);

    memset(&k, 0, sizeof k);
    k.options = o;
    k.fixed = o->corners == ET_CORNERS_INTERPOLATED || (o->corners == ET_CORNERS_DEFAULT && o->approach == ET_FIT_IMPROVED);
    for (size_t w = 0; status == ET_OK && w < 2; w++)
        status = prepare_view(fit, &k, w, data);
    if (status == ET_OK)
        status = run(fit, &k, message);
    else
        et_status_fail(message, status, "%s", et_status_text(status));
    for (size_t w = 0; w < 2; w++) {
        free(k.D[w]);
        fit_collocation_free(&k.U[w]);
        fit_collocation_free(&k.V[w]);
    }
    return status;
}

/*@ requires valid:    \valid_read(o) && (message == \null || \valid(message));
    requires apart:    \separated(o, message);
    assigns  message->text[0 .. ET_MESSAGE_SIZE - 1];
    ensures  status:   \result == ET_OK || \result == ET_EINVAL;
    ensures  options:  \result == ET_OK ==> et_fit_known(o->approach) && et_param_known(o->method) && et_knotrule_known(o->knots) &&
                           et_linalg_known(o->algebra) && et_net_ok(o->control.nx, o->control.ny);
    ensures  control:  \result == ET_OK ==> o->control.nx <= n.nx && o->control.ny <= n.ny;
    ensures  degrees:  \result == ET_OK ==> 1 <= o->p < o->control.nx && 1 <= o->q < o->control.ny;
    ensures  averages: \result == ET_OK && o->knots == ET_KNOTRULE_AVERAGING ==> o->control == n;
*/
static et_status check_options(et_doublenet n, const et_fit_options *o, et_message *message)
{
    const et_doublenet c = o->control;

    if (et_fit_name(o->approach) == NULL || et_param_name(o->method) == NULL || et_knotrule_name(o->knots) == NULL ||
        et_linalg_name(o->algebra) == NULL || (unsigned)o->corners > ET_CORNERS_INTERPOLATED)
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

et_status et_fit_make(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, const et_fit_options *options, et_message *message)
{
    et_fit made;
    et_status status;

    if (!et_doublenet_valid(net) || nov != et_doublenet_nov(net))
        return et_status_fail(message, ET_EINVAL, "%zu points are not the classes of a double net %zux%zu", nov, net.nx, net.ny);
    status = check_options(net, options, message);
    if (status != ET_OK)
        return status;
    status = et_fit_parameters(&made, data, nov, net, options->approach, options->method);
    if (status != ET_OK)
        return et_status_fail(message, status, "parameters: %s", et_status_text(status));
    status = make(&made, data, options, message);
    if (status != ET_OK) {
        et_fit_free(&made);
        return status;
    }
    *fit = made;
    return ET_OK;
}
