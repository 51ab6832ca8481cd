/* judge_made: what is right of parameters, fits and distances, and how far an answer may be from it. */
#include "conform/judge_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdlib.h>

static const double eta = 0x1p-1074;

/* ---- parameters and knots ---- */

static void put_parameters(judge_list *list, const double *t, size_t n, double ku)
{
    for (size_t i = 0; i < n; i++)
        judge_put_bound(list, t[i], ku + ku / ET_UNIT * eta, ku);
}

static et_status knots(judge_list *list, const et_request_value *a)
{
    const size_t p = a[1].count, n = a[2].count, nu = n + p + 1;
    const double ku = 4 * (double)(p + 2) * ET_UNIT;
    double *u = et_size_array(nu, sizeof *u);
    const et_status status = u ? et_exact_knotrule_make(u, nu, p, a[3].x, a[3].count, judge_rule(a[0].count)) : ET_ENOMEM;

    for (size_t i = 0; status == ET_OK && i < nu; i++)
        if (i <= p || i >= n)
            judge_put(list, u[i]);
        else
            judge_put_bound(list, u[i], ku, ku);
    free(u);
    return status;
}

et_status judge_parameters(judge_list *list, const et_request *request)
{
    const et_request_value *a = request->arg;
    const int grid = request->op == ET_OP_PARAMETERS_GRID;
    const size_t nx = a[1].count, ny = grid ? a[2].count : 0, n = nx + ny;
    const double ku = 4 * (double)(n + 8) * ET_UNIT;
    et_status status;

    if (request->op == ET_OP_KNOTS)
        return knots(list, a);
    double *t = et_size_array(n, sizeof *t);
    if (!t)
        return ET_ENOMEM;
    if (grid) {
        size_t flat;
        status = et_exact_param_grid(t, nx, t + nx, ny, &flat, (const et_vec3 *)a[3].x, (et_param_method)a[0].count, NULL);
    } else {
        int flat;
        status = et_exact_param_row(t, nx, &flat, (const et_vec3 *)a[1].x, 1, (et_param_method)a[0].count, NULL);
    }
    if (status == ET_OK)
        put_parameters(list, t, n, ku);
    free(t);
    return status;
}

/* ---- least squares ---- */

typedef struct { size_t n, unknowns; double k; } fit_size;

static double most(size_t a, size_t b)
{
    return (double)(a > b ? a : b);
}

static et_status exact_fit(et_vec3 **P, fit_size *size, et_exact_lsq *lsq, const et_request *request)
{
    const et_request_value *a = request->arg + (request->op == ET_OP_FIT_GRID);
    const size_t curve = request->op == ET_OP_FIT_CURVE, p = a[0].count;
    const size_t nu = a[curve ? 1 : 2].count - p - 1, nv = curve ? 1 : a[3].count - a[1].count - 1;

    *P = et_size_array(nu * nv, sizeof **P);
    if (!*P)
        return ET_ENOMEM;
    *size = (fit_size){ nu * nv, nu * nv, 16 * most(nu * nv, a[curve ? 2 : 4].count) };
    if (curve)
        return et_exact_fit_curve(*P, nu, lsq, a[1].x, a[1].count, p, a[2].x, (const et_vec3 *)a[3].x, a[2].count);
    if (request->op == ET_OP_FIT_SCATTERED)
        return et_exact_fit_scattered(*P, nu, nv, lsq, a[2].x, p, a[3].x, a[1].count, a[4].x, a[5].x, (const et_vec3 *)a[6].x, a[4].count);
    size->unknowns = nu > nv ? nu : nv;
    size->k = 16 * (most(nu, a[4].count) + most(nv, a[5].count));
    return et_exact_fit_grid(*P, nu, nv, lsq, a[2].x, p, a[3].x, a[1].count, a[4].x, a[4].count, a[5].x, a[5].count, (const et_vec3 *)a[6].x,
                             request->arg[0].count == 1);
}

et_status judge_fitted(judge_list *list, const et_request *request)
{
    et_vec3 *P = NULL;
    et_exact_lsq lsq;
    fit_size size;
    const et_status status = exact_fit(&P, &size, &lsq, request);

    if (status == ET_OK) {
        const double K = lsq.condition, ku = size.k * ET_UNIT;
        if ((double)size.unknowns * ku * K >= 1)
            list->doubt = "so badly conditioned that it may count as rank deficient";
        for (size_t i = 0; i < size.n; i++)
            for (size_t c = 0; c < 3; c++) {
                const double X = judge_coordinate(&lsq.solution, c), r = judge_coordinate(&lsq.residual, c);
                const double B = ku * (judge_times(K, X) + judge_times(K * K, r / lsq.norm)) + size.k * eta * (1 + K * K);
                judge_put_bound(list, judge_coordinate(&P[i], c), B, ku);
            }
    }
    free(P);
    return status;
}

/* ---- distances ---- */

double judge_nearest_bound(double *own, const et_request *request, double distance)
{
    const int of_curve = request->op == ET_OP_CURVE_NEAREST;
    const et_request_value *a = request->arg, *points = of_curve ? &a[2] : &a[4];
    const double K = 64 * (double)(a[0].count + (of_curve ? 0 : a[1].count) + 2);
    double greatest = 0, side[3];

    for (size_t c = 0; c < 3; c++) {
        double lo = INFINITY, hi = -INFINITY;
        for (size_t i = 0; i < points->count; i++) {
            const double x = points->x[3 * i + c];
            greatest = fmax(greatest, fabs(x));
            lo = fmin(lo, x);
            hi = fmax(hi, x);
        }
        side[c] = hi - lo;
    }
    *own = K * ET_UNIT * (greatest + distance);
    return *own + 0x1.6a09e667f3bcdp-27 * judge_length(side);
}

static et_status nearest(judge_list *list, const et_request *request)
{
    const int of_curve = request->op == ET_OP_CURVE_NEAREST;
    double at[2], distance, lower, own;
    const et_curve c = judge_curve_of(request);
    const et_surface s = judge_surface_of(request, 0);
    const et_vec3 *P = (const et_vec3 *)request->arg[of_curve ? 4 : 6].x;
    et_status status = of_curve ? et_exact_curve_nearest(at, &distance, &lower, &c, *P) : et_exact_surface_nearest(at, &distance, &lower, &s, *P);

    if (status == ET_OK)
        status = judge_distance_at(&distance, request, at);
    if (status != ET_OK)
        return status;
    for (size_t k = 0; k < (of_curve ? 1u : 2u); k++)
        judge_put_free(list, at[k]);
    judge_put_bound(list, distance, judge_nearest_bound(&own, request, distance), 0);
    return ET_OK;
}

/* The sum over coordinates of M(A) / M(w), or M(P). */
static double magnitude(const judge_net *net)
{
    double sum = 0, M, W = 1, E;

    if (net->weights)
        judge_net_sums(&W, &E, net, 0, 0, JUDGE_WEIGHT);
    for (size_t c = 0; c < 3; c++) {
        judge_net_sums(&M, &E, net, 0, 0, c);
        sum += M / W;
    }
    return sum;
}

static et_status error_sizes(double *sum, double *greatest, const et_surface *s, const et_request_value *a)
{
    *sum = *greatest = 0;
    for (size_t i = 0; i < a[6].count; i++)
        for (size_t j = 0; j < a[7].count; j++) {
            const double *D = a[8].x + 3 * (i * a[7].count + j);
            judge_net net;
            const et_status status = judge_net_surface(&net, s, a[6].x[i], a[7].x[j], 0, 0, 0);
            if (status != ET_OK)
                return status;
            const double M = magnitude(&net) + fabs(D[0]) + fabs(D[1]) + fabs(D[2]);
            judge_net_free(&net);
            *sum += M;
            *greatest = fmax(*greatest, M);
        }
    return ET_OK;
}

static et_status surface_error(judge_list *list, const et_request *request)
{
    const et_request_value *a = request->arg;
    double sum, greatest, M, most_of_all;
    const et_surface s = judge_surface_of(request, 0);
    et_status status = et_exact_surface_error(&sum, &greatest, &s, a[6].x, a[6].count, a[7].x, a[7].count, (const et_vec3 *)a[8].x);

    if (status == ET_OK)
        status = error_sizes(&M, &most_of_all, &s, a);
    if (status != ET_OK)
        return status;
    const double K = 16 * (double)(s.p + s.q + 2) + (double)a[8].count;
    judge_put_bound(list, sum, K * ET_UNIT * M + K * eta, K * ET_UNIT);
    judge_put_bound(list, greatest, K * ET_UNIT * most_of_all + K * eta, K * ET_UNIT);
    return ET_OK;
}

/* K u V + 4 u V' of one sample, greatest so far; v != 0: the border runs along v. */
static et_status sample(double *most_of_all, const et_surface s[2], double x, double y, int v, double K)
{
    double V = 0, W = 0;

    for (size_t k = 0; k < 2; k++) {
        judge_net net;
        const et_status status = judge_net_surface(&net, &s[k], x, y, 0, 0, 1);
        double M, E, w = 1, w1 = 0;
        if (status != ET_OK)
            return status;
        V += magnitude(&net);
        if (net.weights) {
            judge_net_sums(&w, &E, &net, 0, 0, JUDGE_WEIGHT);
            judge_net_sums(&w1, &E, &net, !v, v != 0, JUDGE_WEIGHT);
        }
        for (size_t c = 0; c < 3; c++) {
            judge_net_sums(&M, &E, &net, !v, v != 0, c);
            W += M / w;
            if (net.weights) {
                judge_net_sums(&M, &E, &net, 0, 0, c);
                W += judge_times(w1 / w, M / w);
            }
        }
        judge_net_free(&net);
    }
    *most_of_all = fmax(*most_of_all, K * ET_UNIT * V + 4 * ET_UNIT * W);
    return ET_OK;
}

/* All samples of both borders that run along one direction, at the knots of both surfaces in their order.  Both end at 1, and of equal knots the
 * first surface's comes first: the other's are the last to end. */
static et_status borders(double *most_of_all, const et_surface s[2], int v, size_t samples, double K)
{
    const double *u[2] = { v ? s[0].v + s[0].q : s[0].u + s[0].p, v ? s[1].v + s[1].q : s[1].u + s[1].p };
    const size_t n = v ? s[0].nv - s[0].q : s[0].nu - s[0].p;
    size_t at[2] = { 0, 0 };
    double last = 0;
    et_status status = ET_OK;

    while (status == ET_OK && at[1] <= n) {
        const size_t k = at[0] <= n && u[0][at[0]] <= u[1][at[1]] ? 0 : 1;
        const double next = u[k][at[k]++];
        for (size_t i = 0; status == ET_OK && i <= samples; i++) {
            const double t = i == samples ? next : last + (next - last) * ((double)(i + 1) / (double)(samples + 1));
            if (next == last && i < samples)
                continue;
            for (int end = 0; status == ET_OK && end < 2; end++)
                status = v ? sample(most_of_all, s, end, t, 1, K) : sample(most_of_all, s, t, end, 0, K);
        }
        last = next;
    }
    return status;
}

static et_status seam_gap(judge_list *list, const et_request *request)
{
    const size_t samples = request->arg[12].count;
    const et_shell shell = { { judge_surface_of(request, 0), judge_surface_of(request, 6) } };
    et_seam gap;
    double B = 0;
    et_status status = et_exact_seam_gap(&gap, &shell, samples);
    const double K = status == ET_OK ? 16 * (double)(shell.view[0].p + shell.view[0].q + 2) + 1 : 0;
    for (int v = 0; status == ET_OK && v < 2; v++)
        status = borders(&B, shell.view, v, samples, K);
    if (status == ET_OK)
        judge_put_bound(list, gap.distance, B + K * eta, K * ET_UNIT);
    return status;
}

et_status judge_measured(judge_list *list, const et_request *request)
{
    return request->op == ET_OP_SURFACE_ERROR ? surface_error(list, request)
         : request->op == ET_OP_SEAM_GAP      ? seam_gap(list, request)
                                              : nearest(list, request);
}
