/* answer_fast: what the fast functions answer, of valid requests. */
#include "conform/answer_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/conform/judge.h"
#include "conform/judge_parts.h"
#include "etalon/fit/knotrule.h"
#include "etalon/fit/param.h"
#include "etalon/net/doublenet.h"
#include "etalon/spline/basis.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static et_status put_count(et_reply *reply, size_t n)
{
    const double x = (double)n;

    return et_reply_put(reply, &x, 1);
}

static et_status put_points(et_reply *reply, const et_vec3 *P, size_t n)
{
    return et_reply_put(reply, &P->x, 3 * n);
}

/* The limit from the right unless the left one is asked for. */
static et_side side(const et_request_value *word)
{
    return word->count == JUDGE_LEFT ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
}

/* Curve and surface of a request that has an answer: it is of its kind, and valid (judge_valid asks for more). */
/* ---- basis functions ---- */

/* The p + 1 functions of a row among zeros. */
static et_status put_rows(et_reply *reply, const double *D, size_t rows, size_t p, size_t first, size_t n)
{
    double *row = et_size_array(n, sizeof *row);
    et_status status = row ? ET_OK : ET_ENOMEM;

    for (size_t k = 0; status == ET_OK && k < rows; k++) {
        memcpy(row + first, D + k * (p + 1), (p + 1) * sizeof *row);
        status = et_reply_put(reply, row, n);
    }
    free(row);
    return status;
}

static et_status basis(et_reply *reply, const et_request *request)
{
    const et_request_value *a = request->arg;
    const int ders = request->op == ET_OP_BASIS_DERS;
    const size_t p = a[0].count, nu = a[1].count, d = ders ? a[4].count : 0, nwork = et_basis_work(p, d);
    const size_t span = et_knots_span_side(a[1].x, nu, p, a[2].x[0], side(&a[3]));
    double *work = et_size_array(nwork, sizeof *work), *D = et_size_array((d + 1) * (p + 1), sizeof *D);
    et_status status = work && D ? ET_OK : ET_ENOMEM;

    if (status == ET_OK && d > 0)
        et_basis_ders(D, d, a[1].x, nu, p, span, a[2].x[0], work, nwork);
    else if (status == ET_OK)
        et_basis_eval(D, a[1].x, nu, p, span, a[2].x[0], work, nwork);
    if (status == ET_OK)
        status = put_rows(reply, D, d + 1, p, span - p, nu - p - 1);
    free(work);
    free(D);
    return status;
}

et_status answer_basis(et_reply *reply, const et_request *request)
{
    const et_request_value *a = request->arg;

    if (request->op == ET_OP_SPAN)
        return put_count(reply, et_knots_span(a[1].x, a[1].count, a[0].count, a[2].x[0]));
    if (request->op == ET_OP_MULTIPLICITY)
        return put_count(reply, et_knots_multiplicity(a[0].x, a[0].count, a[1].x[0]));
    if (request->op != ET_OP_GREVILLE)
        return basis(reply, request);
    const size_t n = a[1].count - a[0].count - 1;
    double *g = et_size_array(n, sizeof *g);
    if (!g)
        return ET_ENOMEM;
    et_knots_greville(g, n, a[1].x, a[1].count, a[0].count);
    const et_status status = et_reply_put(reply, g, n);
    free(g);
    return status;
}

/* ---- points ---- */

static et_status curve_points(et_reply *reply, const et_request *request)
{
    const size_t d = request->op == ET_OP_CURVE_DERS ? request->arg[6].count : 0;
    const double x = request->arg[4].x[0];
    const et_curve c = judge_curve_of(request);
    const size_t nwork = et_curve_work(&c, d);
    double *work = et_size_array(nwork, sizeof *work);
    et_vec3 *D = et_size_array(d + 1, sizeof *D);
    et_status status = work && D ? ET_OK : ET_ENOMEM;

    if (status == ET_OK && request->op == ET_OP_CURVE_POINT && side(&request->arg[5]) == ET_SIDE_RIGHT)
        *D = et_curve_point(&c, x, work, nwork);
    else if (status == ET_OK)
        et_curve_ders_side(D, d, &c, x, side(&request->arg[5]), work, nwork);
    if (status == ET_OK)
        status = put_points(reply, D, d + 1);
    free(work);
    free(D);
    return status;
}

/* D, n of them: what a surface operation answers. */
static et_status evaluate(et_vec3 *D, const et_surface *s, const et_request *request, size_t d, double *work, size_t nwork)
{
    const double x = request->arg[6].x[0], y = request->arg[7].x[0];

    if (request->op == ET_OP_SURFACE_NORMAL)
        return et_surface_normal(D, s, x, y, work, nwork);
    const et_side u = side(&request->arg[8]), v = side(&request->arg[9]);
    if (request->op == ET_OP_SURFACE_POINT && u == ET_SIDE_RIGHT && v == ET_SIDE_RIGHT)
        *D = et_surface_point(s, x, y, work, nwork);
    else
        et_surface_partials(D, d, s, x, y, u, v, work, nwork);
    return ET_OK;
}

static et_status surface_points(et_reply *reply, const et_request *request)
{
    const size_t d = request->op == ET_OP_SURFACE_DERS ? request->arg[10].count : 0, n = (d + 1) * (d + 2) / 2;
    const et_surface s = judge_surface_of(request, 0);
    const size_t room[2] = { et_surface_work(&s), et_surface_partials_work(&s, d > 0 ? d : 1) }, nwork = room[0] > room[1] ? room[0] : room[1];
    double *work = et_size_array(nwork, sizeof *work);
    et_vec3 *D = et_size_array(n, sizeof *D);
    et_status status = work && D ? evaluate(D, &s, request, d, work, nwork) : ET_ENOMEM;
    if (status == ET_OK)
        status = put_points(reply, D, n);
    free(work);
    free(D);
    return status;
}

et_status answer_point(et_reply *reply, const et_request *request)
{
    return request->op == ET_OP_CURVE_POINT || request->op == ET_OP_CURVE_DERS ? curve_points(reply, request) : surface_points(reply, request);
}

/* ---- editing ---- */

static et_status edit_curve(et_reply *reply, const et_request *request)
{
    const et_request_value *a = request->arg + 4;
    const et_curve c = judge_curve_of(request);
    size_t removed = 0;
    et_curve made;
    et_status status = request->op == ET_OP_CURVE_INSERT  ? et_curve_insert(&made, &c, a[0].x[0], a[1].count)
                     : request->op == ET_OP_CURVE_ELEVATE ? et_curve_elevate(&made, &c, a[0].count)
                                                          : et_curve_remove(&made, &removed, &c, a[0].x[0], a[1].count, a[2].x[0]);

    if (status != ET_OK)
        return status;
    if (request->op == ET_OP_CURVE_REMOVE)
        status = put_count(reply, removed);
    if (status == ET_OK)
        status = et_reply_put_curve(reply, &made);
    et_curve_free(&made);
    return status;
}

static et_status edit_surface(et_reply *reply, const et_request *request)
{
    const et_request_value *a = request->arg + 7;
    const et_direction along = request->arg[6].count == 0 ? ET_ALONG_U : ET_ALONG_V;
    const et_surface s = judge_surface_of(request, 0);
    size_t removed = 0;
    et_surface made;
    et_status status = request->op == ET_OP_SURFACE_INSERT  ? et_surface_insert(&made, &s, along, a[0].x[0], a[1].count)
                     : request->op == ET_OP_SURFACE_ELEVATE ? et_surface_elevate(&made, &s, along, a[0].count)
                                                            : et_surface_remove(&made, &removed, &s, along, a[0].x[0], a[1].count, a[2].x[0]);

    if (status != ET_OK)
        return status;
    if (request->op == ET_OP_SURFACE_REMOVE)
        status = put_count(reply, removed);
    if (status == ET_OK)
        status = et_reply_put_surface(reply, &made);
    et_surface_free(&made);
    return status;
}

et_status answer_edit(et_reply *reply, const et_request *request)
{
    const int curve = request->op == ET_OP_CURVE_INSERT || request->op == ET_OP_CURVE_REMOVE || request->op == ET_OP_CURVE_ELEVATE;

    return curve ? edit_curve(reply, request) : edit_surface(reply, request);
}

/* ---- parameters, knots, nets ---- */

et_status answer_parameters(et_reply *reply, const et_request *request)
{
    const et_request_value *a = request->arg;
    const int grid = request->op == ET_OP_PARAMETERS_GRID, knots = request->op == ET_OP_KNOTS;
    const size_t n = knots ? a[2].count + a[1].count + 1 : grid ? a[1].count + a[2].count : a[1].count;
    double *t = et_size_array(n, 2 * sizeof *t);
    size_t flat;
    et_status status = ET_OK;

    if (!t)
        return ET_ENOMEM;
    if (knots)
        status = et_knotrule_make(t, n, a[1].count, a[3].x, a[3].count, judge_rule(a[0].count));
    else if (grid)
        status = et_param_grid(t, a[1].count, t + a[1].count, a[2].count, &flat, (const et_vec3 *)a[3].x, (et_param_method)a[0].count);
    else
        (void)et_param_row(t, n, (const et_vec3 *)a[1].x, 1, (et_param_method)a[0].count, t + n);
    if (status == ET_OK)
        status = et_reply_put(reply, t, n);
    free(t);
    return status;
}

et_status answer_net(et_reply *reply, const et_request *request)
{
    const et_request_value *a = request->arg;
    const et_doublenet net = { a[0].count, a[1].count };
    size_t n[3];

    if (request->op == ET_OP_NET_CLASS)
        return put_count(reply, et_doublenet_class(net, a[2].count, a[3].count, a[4].count));
    if (request->op == ET_OP_NET_COUNTS) {
        n[0] = et_doublenet_non(net);
        n[1] = et_doublenet_nov(net);
        n[2] = et_doublenet_nor(net);
    } else {
        const et_index node = et_doublenet_index(net, a[2].count);
        n[0] = node.k == 2;
        n[1] = node.i;
        n[2] = node.j;
    }
    const double x[3] = { (double)n[0], (double)n[1], (double)n[2] };
    return et_reply_put(reply, x, 3);
}
