/* judge_truth: what is right, by the exact layer, and how far an answer may be from it. */
#include "conform/judge_parts.h"
#include "etalon/base/dd.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

static const double eta = 0x1p-1074;

static et_side side_of(int left)
{
    return left ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
}

/* ---- knots and basis functions ---- */

et_status judge_basis(judge_list *list, const et_request *request, int left)
{
    const et_request_value *a = request->arg;
    const size_t p = a[0].count, nu = a[1].count, n = nu - p - 1, d = request->op == ET_OP_BASIS_DERS ? a[4].count : 0;
    const double *u = a[1].x, x = a[2].x[0];
    const size_t span = et_knots_span_side(u, nu, p, x, side_of(left));
    double *D = et_size_array((d + 1) * (p + 1), sizeof *D);
    judge_line line = { 0 };
    et_status status = D ? judge_line_make(&line, u, nu, p, x, left, d) : ET_ENOMEM;

    if (status == ET_OK)
        status = et_exact_basis_ders(D, d, u, nu, p, span, x);
    for (size_t k = 0; status == ET_OK && k <= d; k++) {
        double all = 0;
        for (size_t j = 0; j <= p; j++)
            all += line.m[k * (p + 1) + j];
        for (size_t i = 0; i < n; i++) {
            const double K = 16 * (double)(p + k + 2);
            const size_t at = k * (p + 1) + i - line.first;
            if (i < line.first || i > line.first + p)
                judge_put_bound(list, 0, 2 * K * eta, K * ET_UNIT);
            else
                judge_put_bound(list, D[at], K * ET_UNIT * all + K * eta * (2 + line.length * line.s[at]), K * ET_UNIT);
        }
    }
    judge_line_free(&line);
    free(D);
    return status;
}

static et_status greville(judge_list *list, const et_request *request)
{
    const size_t p = request->arg[0].count, nu = request->arg[1].count, n = nu - p - 1;
    const double *u = request->arg[1].x, ku = 4 * (double)(p + 2) * ET_UNIT;
    double *g = et_size_array(n, sizeof *g);
    et_status status = g ? et_exact_knots_greville(g, n, u, nu, p) : ET_ENOMEM;

    for (size_t i = 0; status == ET_OK && i < n; i++)
        judge_put_bound(list, g[i], ku * fmax(fabs(u[i + 1]), fabs(u[i + p])), ku);
    free(g);
    return status;
}

et_status judge_counted(judge_list *list, const et_request *request)
{
    const et_request_value *a = request->arg;
    const et_doublenet net = { a[0].count, a[1].count };

    if (request->op == ET_OP_SPAN) {
        judge_put(list, (double)et_knots_span(a[1].x, a[1].count, a[0].count, a[2].x[0]));
    } else if (request->op == ET_OP_MULTIPLICITY) {
        judge_put(list, (double)et_knots_multiplicity(a[0].x, a[0].count, a[1].x[0]));
    } else if (request->op == ET_OP_NET_COUNTS) {
        judge_put(list, (double)et_doublenet_non(net));
        judge_put(list, (double)et_doublenet_nov(net));
        judge_put(list, (double)et_doublenet_nor(net));
    } else if (request->op == ET_OP_NET_CLASS) {
        judge_put(list, (double)et_doublenet_class(net, a[2].count, a[3].count, a[4].count));
    } else if (request->op == ET_OP_NET_NODE) {
        const et_index node = et_doublenet_index(net, a[2].count);
        judge_put(list, node.k == 2 ? 1 : 0);
        judge_put(list, (double)node.i);
        judge_put(list, (double)node.j);
    } else {
        return greville(list, request);
    }
    return ET_OK;
}

/* ---- points, derivatives, normals ---- */

/* n derivatives with the B's of each coordinate. */
static void put_derivatives(judge_list *list, const judge_net *net, const et_vec3 *C, const double *B, size_t d)
{
    for (size_t o = 0; o <= d; o++)
        for (size_t b = 0; b <= (net->curve ? 0 : o); b++) {
            const size_t at = net->curve ? o : o * (o + 1) / 2 + b;
            for (size_t c = 0; c < 3; c++)
                judge_put_bound(list, judge_coordinate(&C[at], c), B[3 * at + c], judge_net_k(net, o - b, b) * ET_UNIT);
        }
}

et_status judge_points(judge_list *list, const et_request *request, int left_u, int left_v)
{
    const et_request_value *a = request->arg;
    const int of_curve = request->op == ET_OP_CURVE_POINT || request->op == ET_OP_CURVE_DERS;
    const size_t d = request->op == ET_OP_CURVE_DERS ? a[6].count : request->op == ET_OP_SURFACE_DERS ? a[10].count : 0;
    const size_t n = of_curve ? d + 1 : (d + 1) * (d + 2) / 2;
    et_vec3 *C = et_size_array(n, sizeof *C);
    double *B = et_size_array(n, 3 * sizeof *B);
    judge_net net = { 0 };
    const et_curve c = judge_curve_of(request);
    const et_surface s = judge_surface_of(request, 0);
    et_status status = C && B ? ET_OK : ET_ENOMEM;

    if (status == ET_OK && of_curve) {
        status = et_exact_curve_ders_side(C, d, &c, a[4].x[0], side_of(left_u));
        if (status == ET_OK)
            status = judge_net_curve(&net, &c, a[4].x[0], left_u, d);
    } else if (status == ET_OK) {
        status = et_exact_surface_partials(C, d, &s, a[6].x[0], a[7].x[0], side_of(left_u), side_of(left_v));
        if (status == ET_OK)
            status = judge_net_surface(&net, &s, a[6].x[0], a[7].x[0], left_u, left_v, d);
    }
    if (status == ET_OK)
        status = judge_net_bounds(B, &net, C, d);
    if (status == ET_OK)
        put_derivatives(list, &net, C, B, d);
    judge_net_free(&net);
    free(C);
    free(B);
    return status;
}

/* a b - c d, of numbers of size 1 to nearly all of their digits. */
static double difference(double a, double b, double c, double d)
{
    return et_dd_sub(et_dd_two_product(a, b), et_dd_two_product(c, d)).hi;
}

static double greatest(et_vec3 a)
{
    return fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z)));
}

/* The power of two by which the vector is nearly of size 1. */
static double unit_of(et_vec3 a)
{
    const double most = greatest(a);
    int e;

    frexp(most, &e);
    return most == 0 || !isfinite(most) ? 1 : ldexp(1, e < -1000 ? 1000 : -e);
}

/* |a x b|, as if the product were exact. */
static double cross_length(et_vec3 a, et_vec3 b)
{
    const double s = unit_of(a), t = unit_of(b);
    const et_vec3 A = { s * a.x, s * a.y, s * a.z }, B = { t * b.x, t * b.y, t * b.z };
    const double cross[3] = { difference(A.y, B.z, A.z, B.y), difference(A.z, B.x, A.x, B.z), difference(A.x, B.y, A.y, B.x) };

    return judge_length(cross) / s / t;
}

/* What underflows in the cross product where each factor is brought to size 1 by a power of two; as small as eta at least. */
static double lost_by_scaling(et_vec3 a, et_vec3 b)
{
    const double p = greatest(a), q = greatest(b);

    return fmax(eta, eta * fmax(p, q) * fmin(p, q));
}

static void put_normal(judge_list *list, const et_vec3 *n, const et_vec3 D[3], const double B[9], double K)
{
    double e[3], sum = 0, along = 0;

    for (size_t c = 0; c < 3; c++) {
        const size_t y = (c + 1) % 3, z = (c + 2) % 3;
        const double ay = judge_coordinate(&D[1], y), az = judge_coordinate(&D[1], z);
        const double by = judge_coordinate(&D[2], y), bz = judge_coordinate(&D[2], z);
        e[c] = judge_times(fabs(ay), B[6 + z]) + judge_times(B[3 + y], fabs(bz)) + judge_times(fabs(az), B[6 + y]) + judge_times(B[3 + z], fabs(by))
             + K * ET_UNIT * (fabs(ay * bz) + fabs(az * by)) + K * lost_by_scaling(D[1], D[2]);
        sum += e[c];
        along += judge_times(fabs(judge_coordinate(n, c)), e[c]);
    }
    const double l = fmin(cross_length(D[1], D[2]), DBL_MAX);
    if (!(l > 0x1p10 * sum))
        list->doubt = "the normal can hardly be told from none";
    for (size_t c = 0; c < 3; c++) {
        const double x = judge_coordinate(n, c);
        judge_put_bound(list, x, (e[c] + fabs(x) * along) / l + K * ET_UNIT * fabs(x) + K * eta, K * ET_UNIT);
    }
}

static void mirror_knots(double *u, size_t nu)
{
    for (size_t i = 0; i < nu - i; i++) {
        const double x = -u[i];
        u[i] = -u[nu - 1 - i];
        u[nu - 1 - i] = x;
    }
}

/* Control point (i, j) changes places with (mi, mj), mi = nu-1-i where u is mirrored, else i. */
static void mirror(et_surface *s, int in_u, int in_v)
{
    if (in_u)
        mirror_knots(s->u, s->nu + s->p + 1);
    if (in_v)
        mirror_knots(s->v, s->nv + s->q + 1);
    for (size_t i = 0; i < s->nu; i++)
        for (size_t j = 0; j < s->nv; j++) {
            const size_t at = i * s->nv + j, other = (in_u ? s->nu - 1 - i : i) * s->nv + (in_v ? s->nv - 1 - j : j);
            if (at < other) {
                const et_vec3 P = s->points[at];
                s->points[at] = s->points[other];
                s->points[other] = P;
            }
            if (at < other && s->weights) {
                const double w = s->weights[at];
                s->weights[at] = s->weights[other];
                s->weights[other] = w;
            }
        }
}

/* The limit from the left is the one from the right of the surface run through backwards, whose normal points the other way if that is done once. */
static et_status exact_normal(et_vec3 *n, const et_surface *s, double x, double y, int left_u, int left_v)
{
    et_surface back;

    if (!left_u && !left_v)
        return et_exact_surface_normal(n, s, x, y);
    et_status status = et_surface_copy(&back, s);
    if (status != ET_OK)
        return status;
    mirror(&back, left_u, left_v);
    status = et_exact_surface_normal(n, &back, left_u ? -x : x, left_v ? -y : y);
    et_surface_free(&back);
    if (status == ET_OK && left_u != left_v)
        *n = (et_vec3){ 0 - n->x, 0 - n->y, 0 - n->z };
    return status;
}

et_status judge_normal(judge_list *list, const et_request *request, int left_u, int left_v)
{
    const double x = request->arg[6].x[0], y = request->arg[7].x[0];
    const et_surface s = judge_surface_of(request, 0);
    et_vec3 n, D[3];
    double B[9];
    judge_net net = { 0 };
    et_status status = et_exact_surface_partials(D, 1, &s, x, y, side_of(left_u), side_of(left_v));

    if (status == ET_OK)
        status = exact_normal(&n, &s, x, y, left_u, left_v);
    if (status == ET_OK)
        status = judge_net_surface(&net, &s, x, y, left_u, left_v, 1);
    if (status == ET_OK)
        status = judge_net_bounds(B, &net, D, 1);
    if (status == ET_OK)
        put_normal(list, &n, D, B, 16 * (double)(s.p + s.q + 4));
    judge_net_free(&net);
    if (status != ET_ERANK)
        return status;
    list->doubt = "there is no normal";
    return ET_OK;
}
