/* judge_valid: which requests are valid, implementation-defined or invalid (docs/judge.md, "Validity, to the letter"). */
#include "conform/judge_parts.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* What is worse stands; of equal ones the first reason. */
static void fault(judge_case *c, et_validity validity, int known, const char *format, ...)
{
    if (validity > c->validity) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(c->reason, sizeof c->reason, format, arguments);
        va_end(arguments);
        c->validity = validity;
    }
    c->known = c->known && known;
}

static void invalid(judge_case *c, const char *reason)
{
    fault(c, ET_INVALID, 0, "%s", reason);
}

static void unknown(judge_case *c, const char *reason)
{
    fault(c, ET_IMPLEMENTATION_DEFINED, 0, "%s", reason);
}

static void defined(judge_case *c, const char *reason)
{
    fault(c, ET_IMPLEMENTATION_DEFINED, 1, "%s", reason);
}

static int finite(const double *x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(x[i]))
            return 0;
    return 1;
}

/* ---- knots ---- */

/* Finite and not decreasing. */
static int sorted(judge_case *c, const double *u, size_t nu)
{
    if (!finite(u, nu)) {
        invalid(c, "a knot is not finite");
        return 0;
    }
    for (size_t i = 1; i < nu; i++)
        if (u[i] < u[i - 1]) {
            invalid(c, "the knots decrease");
            return 0;
        }
    return 1;
}

/* Knots that are all right but perhaps hard. */
static void hard_knots(judge_case *c, const double *u, size_t nu, size_t p)
{
    size_t run = 1;

    if (!isfinite(u[nu - 1] - u[0]))
        unknown(c, "the knots' range overflows");
    if (u[0] < u[p] || u[nu - p - 1] < u[nu - 1])
        defined(c, "the knots are not clamped");
    for (size_t i = 1; i < nu; i++) {
        run = u[i] == u[i - 1] ? run + 1 : 1;
        if (run > p + 1)
            defined(c, "a knot stands more than p + 1 times");
        if (u[i] > u[i - 1] && u[i] - u[i - 1] < 0x1p-1022)
            unknown(c, "different knots are less than 2^-1022 apart");
    }
}

/* 1: sizes and domain can be relied on. */
static int knots(judge_case *c, const et_request_value *u, size_t p)
{
    if (u->count < 2 || p > (u->count - 2) / 2) {
        invalid(c, "fewer than 2p + 2 knots");
        return 0;
    }
    if (!sorted(c, u->x, u->count))
        return 0;
    if (!(u->x[p] < u->x[u->count - p - 1])) {
        invalid(c, "the domain is empty");
        return 0;
    }
    if (p > JUDGE_DEGREE)
        unknown(c, "the degree is above 64");
    hard_knots(c, u->x, u->count, p);
    return 1;
}

static int clamped(const et_request_value *u, size_t p)
{
    return u->x[0] == u->x[p] && u->x[u->count - p - 1] == u->x[u->count - 1];
}

static int inside(const et_request_value *u, size_t p, double x)
{
    return u->x[p] <= x && x <= u->x[u->count - p - 1];
}

static size_t times(const et_request_value *u, double x)
{
    size_t n = 0;

    for (size_t i = 0; i < u->count; i++)
        n += u->x[i] == x;
    return n;
}

int judge_jumps(const double *u, size_t nu, size_t p, const double *t, size_t n)
{
    for (size_t i = 0; i + p < nu; i++)
        if (u[i] == u[i + p] && u[p] < u[i] && u[i] < u[nu - p - 1])
            for (size_t k = 0; k < n; k++)
                if (t[k] == u[i])
                    return 1;
    return 0;
}

/* A knot inside the domain that stands p + 1 times or more. */
static int broken(const et_request_value *u, size_t p)
{
    return judge_jumps(u->x, u->count, p, u->x, u->count);
}

/* ---- curves and surfaces ---- */

static void net(judge_case *c, const et_request_value *points, const et_request_value *weights, size_t n)
{
    if (points->count != n)
        invalid(c, "the knots say another number of control points");
    if (weights->count != 0 && weights->count != n)
        invalid(c, "the knots say another number of weights");
    if (c->validity == ET_INVALID)
        return;
    if (!finite(points->x, 3 * n))
        invalid(c, "a control point is not finite");
    if (!finite(weights->x, weights->count))
        invalid(c, "a weight is not finite");
    for (size_t i = 0; i < weights->count; i++) {
        if (weights->x[i] < 0)
            invalid(c, "a weight is negative");
        if (weights->x[i] == 0)
            unknown(c, "a weight is zero");
    }
}

static int curve(judge_case *c, const et_request_value *a)
{
    if (!knots(c, &a[1], a[0].count))
        return 0;
    net(c, &a[2], &a[3], a[1].count - a[0].count - 1);
    return c->validity != ET_INVALID;
}

static int surface(judge_case *c, const et_request_value *a)
{
    size_t n;

    if (!knots(c, &a[2], a[0].count) || !knots(c, &a[3], a[1].count))
        return 0;
    if (et_size_mul(&n, a[2].count - a[0].count - 1, a[3].count - a[1].count - 1) != ET_OK || n > SIZE_MAX / 3) {
        invalid(c, "the knots say another number of control points");
        return 0;
    }
    net(c, &a[4], &a[5], n);
    return c->validity != ET_INVALID;
}

static void parameter(judge_case *c, const et_request_value *u, size_t p, double x)
{
    if (!isfinite(x))
        invalid(c, "the parameter is not finite");
    else if (!inside(u, p, x))
        unknown(c, "the parameter is outside the domain");
}

static void degree_zero(judge_case *c, size_t p, size_t q, int known)
{
    if (p == 0 || q == 0)
        fault(c, ET_IMPLEMENTATION_DEFINED, known, "degree 0");
}

/* Orders, and the numbers of an answer: n for each of `rows`. */
static void order(judge_case *c, size_t d, size_t most)
{
    if (d > most)
        unknown(c, "derivatives of too high an order");
}

static void size(judge_case *c, size_t rows, size_t n)
{
    size_t product;

    if (et_size_mul(&product, rows, n) != ET_OK || product > JUDGE_NUMBERS)
        unknown(c, "an answer of more than 10^6 numbers");
}

/* ---- operations ---- */

/* span, multiplicity, greville, basis, basis_ders */
static void knots_only(judge_case *c, const et_request *request)
{
    const et_request_value *a = request->arg;

    if (request->op == ET_OP_MULTIPLICITY) {
        if (a[0].count == 0)
            invalid(c, "no knots");
        sorted(c, a[0].x, a[0].count);
        if (!isfinite(a[1].x[0]))
            invalid(c, "the parameter is not finite");
        return;
    }
    if (!knots(c, &a[1], a[0].count))
        return;
    if (request->op == ET_OP_GREVILLE) {
        degree_zero(c, a[0].count, 1, 0);
        size(c, 1, a[1].count);
        return;
    }
    parameter(c, &a[1], a[0].count, a[2].x[0]);
    if (request->op == ET_OP_BASIS_DERS) {
        degree_zero(c, a[0].count, 1, 1);
        order(c, a[4].count, JUDGE_DEGREE);
    }
    size(c, request->op == ET_OP_BASIS_DERS && a[4].count <= JUDGE_DEGREE ? a[4].count + 1 : 1, a[1].count);
}

static void at_parameters(judge_case *c, const et_request *request)
{
    const et_request_value *a = request->arg;
    const int of_curve = request->op == ET_OP_CURVE_POINT || request->op == ET_OP_CURVE_DERS;
    const int ders = request->op == ET_OP_CURVE_DERS || request->op == ET_OP_SURFACE_DERS;

    if (of_curve ? !curve(c, a) : !surface(c, a))
        return;
    if (of_curve)
        parameter(c, &a[1], a[0].count, a[4].x[0]);
    else {
        parameter(c, &a[2], a[0].count, a[6].x[0]);
        parameter(c, &a[3], a[1].count, a[7].x[0]);
    }
    if (ders) {
        degree_zero(c, a[0].count, of_curve ? 1 : a[1].count, 1);
        order(c, of_curve ? a[6].count : a[10].count, of_curve ? JUDGE_DEGREE : JUDGE_ORDER);
    }
    if (request->op == ET_OP_SURFACE_NORMAL)
        degree_zero(c, a[0].count, a[1].count, 0);
}

/* Insertion, removal and elevation in the direction u of degree p, `other` control points across. */
static void edit(judge_case *c, et_request_op op, const et_request_value *u, size_t p, size_t other, const et_request_value *a)
{
    const int elevates = op == ET_OP_CURVE_ELEVATE || op == ET_OP_SURFACE_ELEVATE, removes = op == ET_OP_CURVE_REMOVE || op == ET_OP_SURFACE_REMOVE;
    const double x = elevates ? 0 : a[0].x[0];
    const size_t r = elevates ? a[0].count : a[1].count, m = elevates ? 0 : times(u, x);

    degree_zero(c, p, 1, 0);
    size(c, elevates && r <= JUDGE_DEGREE ? 4 * u->count * (r + 1) : 4 * u->count, other);
    if (elevates) {
        if (!clamped(u, p))
            unknown(c, "the knots are not clamped");
        for (size_t i = p + 1; i < u->count; i++)
            if (u->x[i] == u->x[i - p - 1])
                unknown(c, "a knot stands more than p + 1 times");
        if (r > JUDGE_DEGREE)
            unknown(c, "elevated by more than 64");
    } else if (!isfinite(x)) {
        invalid(c, "the knot is not finite");
    } else if (removes) {
        if (m == 0 || !(u->x[p] < x && x < u->x[u->count - p - 1]))
            invalid(c, "no knot inside the domain");
        if (!(a[2].x[0] >= 0 && isfinite(a[2].x[0])))
            invalid(c, "the tolerance is not finite or negative");
    } else if (!inside(u, p, x)) {
        invalid(c, "the knot is outside the domain");
    } else if (r > 0 && (m > p + 1 || r > p + 1 - m)) {
        invalid(c, "the knot's multiplicity would exceed p + 1");
    } else if (r > 0) {
        for (size_t i = 0; i < u->count; i++)
            if (u->x[i] != x && fabs(u->x[i] - x) < 0x1p-1022)
                unknown(c, "different knots would be less than 2^-1022 apart");
    }
}

static void edits(judge_case *c, const et_request *request)
{
    const et_request_value *a = request->arg;

    if (request->op == ET_OP_CURVE_INSERT || request->op == ET_OP_CURVE_REMOVE || request->op == ET_OP_CURVE_ELEVATE) {
        if (curve(c, a))
            edit(c, request->op, &a[1], a[0].count, 1, a + 4);
    } else if (surface(c, a)) {
        const size_t v = a[6].count;
        degree_zero(c, a[1 - v].count, 1, 0);
        edit(c, request->op, &a[2 + v], a[v].count, a[3 - v].count, a + 7);
    }
}

et_knotrule_kind judge_rule(size_t word)
{
    static const et_knotrule_kind rules[] = { ET_KNOTRULE_PIEGL, ET_KNOTRULE_AVERAGING, ET_KNOTRULE_FAITHFUL, ET_KNOTRULE_UNIFORM };

    return rules[word & 3];
}

static void rule(judge_case *c, const et_request_value *a)
{
    const size_t p = a[1].count, n = a[2].count, m = a[3].count;
    const double *t = a[3].x;

    if (n <= p)
        invalid(c, "fewer than p + 1 control points");
    if (m < 2)
        invalid(c, "fewer than two parameters");
    if (!finite(t, m))
        invalid(c, "a parameter is not finite");
    if (c->validity == ET_INVALID)
        return;
    if (judge_rule(a[0].count) == ET_KNOTRULE_AVERAGING ? m != n : judge_rule(a[0].count) != ET_KNOTRULE_UNIFORM && m < n)
        invalid(c, "a number of parameters that the rule does not know");
    degree_zero(c, p, 1, 0);
    if (p > JUDGE_DEGREE)
        unknown(c, "the degree is above 64");
    size(c, n, 2);
    for (size_t i = 0; i < m; i++)
        if (!(0 <= t[i] && t[i] <= 1) || (i > 0 && t[i] < t[i - 1]))
            unknown(c, "the parameters decrease or leave [0,1]");
}

static void parameters(judge_case *c, const et_request *request)
{
    const et_request_value *a = request->arg;

    if (request->op == ET_OP_KNOTS) {
        rule(c, a);
    } else {
        const size_t k = request->op == ET_OP_PARAMETERS ? 1 : 3;
        size_t n = a[k].count;
        if (k == 1 ? n < 2 : a[1].count < 2 || a[2].count < 2)
            invalid(c, "fewer than two points to parameterise");
        if (k == 3 && (et_size_mul(&n, a[1].count, a[2].count) != ET_OK || n != a[3].count))
            invalid(c, "the points are no grid of these sizes");
        if (!finite(a[k].x, 3 * a[k].count))
            invalid(c, "a point is not finite");
        size(c, 1, a[k].count);
    }
}

/* ---- fits ---- */

/* N_i > 0 at t, limits from the right but at the right end. */
static int lives(const et_request_value *k, size_t p, size_t i, double t)
{
    const double *u = k->x;

    if (u[i] < t && t < u[i + p + 1])
        return 1;
    if (t == u[k->count - p - 1])
        return u[i] < t && t == u[i + 1];
    return t == u[i] && t == u[i + p] && t < u[i + p + 1];
}

/* Schoenberg and Whitney: parameters t_0' < t_1' < ... among t with N_i(t_i') > 0; the least that is left is taken each time. */
static int determined(const et_request_value *u, size_t p, const et_request_value *t)
{
    double last = -INFINITY;

    for (size_t i = 0; i + p + 1 < u->count; i++) {
        double next = INFINITY;
        for (size_t k = 0; k < t->count; k++)
            if (t->x[k] > last && t->x[k] < next && lives(u, p, i, t->x[k]))
                next = t->x[k];
        if (next == INFINITY)
            return 0;
        last = next;
    }
    return 1;
}

/* One direction's parameters; 1 if nothing stands against them. */
static int sites(judge_case *c, const et_request_value *u, size_t p, const et_request_value *t)
{
    if (p == 0)
        unknown(c, "degree 0 is seldom fitted");
    if (!finite(t->x, t->count)) {
        invalid(c, "a parameter is not finite");
        return 0;
    }
    for (size_t i = 0; i < t->count; i++)
        if (!inside(u, p, t->x[i])) {
            invalid(c, "a parameter is outside the domain");
            return 0;
        }
    if (judge_jumps(u->x, u->count, p, t->x, t->count))
        unknown(c, "a parameter is on a knot that stands p + 1 times");
    return c->validity != ET_INVALID;
}

static void rank(judge_case *c, const et_request_value *u, size_t p, const et_request_value *t)
{
    if (c->known && !determined(u, p, t))
        invalid(c, "the fit is rank deficient");
}

static int from_end_to_end(const et_request_value *u, size_t p, const et_request_value *t)
{
    return t->count > 0 && clamped(u, p) && t->x[0] == u->x[p] && t->x[t->count - 1] == u->x[u->count - p - 1];
}

static void data(judge_case *c, const et_request_value *points, size_t m, size_t n)
{
    size_t product;

    if (et_size_mul(&product, m, n) != ET_OK || points->count != product)
        invalid(c, "parameters and data differ in number");
    else if (!finite(points->x, 3 * points->count))
        invalid(c, "a data point is not finite");
}

static void fits(judge_case *c, const et_request *request)
{
    const et_request_value *a = request->arg;

    if (request->op == ET_OP_FIT_CURVE) {
        if (!knots(c, &a[1], a[0].count))
            return;
        data(c, &a[3], a[2].count, 1);
        if (sites(c, &a[1], a[0].count, &a[2]))
            rank(c, &a[1], a[0].count, &a[2]);
        return;
    }
    const size_t k = request->op == ET_OP_FIT_GRID ? 1 : 0;
    if (!knots(c, &a[k + 2], a[k].count) || !knots(c, &a[k + 3], a[k + 1].count))
        return;
    size(c, a[k + 2].count, a[k + 3].count);
    data(c, &a[k + 6], a[k + 4].count, k == 1 ? a[k + 5].count : 1);
    if (k == 0 && a[4].count != a[5].count)
        invalid(c, "parameters and data differ in number");
    /* What makes the one invalid stands against the other, too. */
    (void)sites(c, &a[k + 2], a[k].count, &a[k + 4]);
    if (!sites(c, &a[k + 3], a[k + 1].count, &a[k + 5]))
        return;
    if (k == 0) {
        if (a[4].count < (a[2].count - a[0].count - 1) * (a[3].count - a[1].count - 1))
            invalid(c, "the fit is rank deficient");
        return;
    }
    rank(c, &a[3], a[1].count, &a[5]);
    rank(c, &a[4], a[2].count, &a[6]);
    if (a[0].count == 1 && (!from_end_to_end(&a[3], a[1].count, &a[5]) || !from_end_to_end(&a[4], a[2].count, &a[6])))
        unknown(c, "corners that the parameters do not reach");
}

static void approximate(judge_case *c, const et_request_value *a)
{
    const size_t p = a[0].count, q = a[1].count, nu = a[2].count, nv = a[3].count, mx = a[4].count, my = a[5].count;

    if (p == 0 || q == 0)
        unknown(c, "degree 0 is seldom fitted");
    if (nu <= p || nv <= q)
        invalid(c, "fewer than p + 1 control points");
    if (mx < 2 || my < 2)
        invalid(c, "fewer than two points to parameterise");
    data(c, &a[6], mx, my);
    if (p > JUDGE_DEGREE || q > JUDGE_DEGREE)
        unknown(c, "the degree is above 64");
    if (mx < nu || my < nv)
        unknown(c, "more control points than data");
}

/* ---- distances and nets ---- */

static void distances(judge_case *c, const et_request *request)
{
    const et_request_value *a = request->arg;
    const int of_curve = request->op == ET_OP_CURVE_NEAREST;
    const size_t k = of_curve ? 4 : 6;

    if (of_curve ? !curve(c, a) : !surface(c, a))
        return;
    if (request->op != ET_OP_SURFACE_ERROR) {
        degree_zero(c, a[0].count, of_curve ? 1 : a[1].count, 0);
        if (a[k].count != 1)
            invalid(c, "one point is asked for");
        else if (!finite(a[k].x, 3))
            invalid(c, "the point is not finite");
        return;
    }
    degree_zero(c, a[0].count, a[1].count, 1);
    data(c, &a[8], a[6].count, a[7].count);
    if (a[8].count == 0)
        invalid(c, "no data");
    for (size_t v = 0; v < 2; v++) {
        const et_request_value *t = &a[6 + v], *u = &a[2 + v];
        for (size_t i = 0; i < t->count; i++)
            parameter(c, u, a[v].count, t->x[i]);
        if (judge_jumps(u->x, u->count, a[v].count, t->x, t->count))
            unknown(c, "a parameter is on a knot that stands p + 1 times");
    }
}

static int unit_domain(const et_request_value *u, size_t p)
{
    return u->x[p] == 0 && u->x[u->count - p - 1] == 1;
}

static void seam(judge_case *c, const et_request_value *a)
{
    const et_request_value *b = a + 6;

    if (!surface(c, a) || !surface(c, b))
        return;
    for (size_t v = 0; v < 2; v++) {
        degree_zero(c, a[v].count, b[v].count, 0);
        if (a[v].count != b[v].count || a[2 + v].count != b[2 + v].count)
            unknown(c, "surfaces of different shapes");
        if (!unit_domain(&a[2 + v], a[v].count) || !unit_domain(&b[2 + v], b[v].count))
            unknown(c, "a domain other than [0,1]^2");
        if (!clamped(&a[2 + v], a[v].count) || !clamped(&b[2 + v], b[v].count))
            unknown(c, "the knots are not clamped");
        if (broken(&a[2 + v], a[v].count) || broken(&b[2 + v], b[v].count))
            unknown(c, "a knot that stands p + 1 times");
    }
    if ((a[5].count == 0) != (b[5].count == 0))
        unknown(c, "only one surface is rational");
    if (a[12].count > JUDGE_SAMPLES)
        unknown(c, "more than 100 samples");
}

static void net_operation(judge_case *c, const et_request *request)
{
    const et_request_value *a = request->arg;
    const size_t nx = a[0].count, ny = a[1].count;
    size_t n;

    if (nx < 2 || ny < 2)
        invalid(c, "a side of less than two nodes");
    if (request->op == ET_OP_NET_CLASS && (a[2].count > 1 || a[3].count >= nx || a[4].count >= ny))
        invalid(c, "no node of the net");
    if (c->validity == ET_INVALID)
        return;
    if (et_size_mul(&n, nx, ny) != ET_OK || (double)n > 0x1p52) {
        if (request->op == ET_OP_NET_NODE && a[2].count == 0)
            invalid(c, "no class of the net");
        unknown(c, "more than 2^53 nodes");
    } else if (request->op == ET_OP_NET_NODE && (a[2].count < 1 || a[2].count > et_doublenet_nov((et_doublenet){ nx, ny }))) {
        invalid(c, "no class of the net");
    }
}

/* ---- all ---- */

static void words(judge_case *c, const et_request *request)
{
    const et_request_shape *shape;

    for (size_t k = 0; (shape = et_request_argument(request->op, k)) != NULL; k++)
        for (size_t n = 0; shape->kind == ET_ARG_WORD && n <= request->arg[k].count; n++)
            if (!shape->words[n]) {
                invalid(c, "no such word");
                break;
            }
}

static void operation(judge_case *c, const et_request *request)
{
    switch (request->op) {
    case ET_OP_SPAN: case ET_OP_MULTIPLICITY: case ET_OP_GREVILLE: case ET_OP_BASIS: case ET_OP_BASIS_DERS:
        knots_only(c, request);
        break;
    case ET_OP_CURVE_POINT: case ET_OP_CURVE_DERS: case ET_OP_SURFACE_POINT: case ET_OP_SURFACE_DERS: case ET_OP_SURFACE_NORMAL:
        at_parameters(c, request);
        break;
    case ET_OP_CURVE_INSERT: case ET_OP_CURVE_REMOVE: case ET_OP_CURVE_ELEVATE:
    case ET_OP_SURFACE_INSERT: case ET_OP_SURFACE_REMOVE: case ET_OP_SURFACE_ELEVATE:
        edits(c, request);
        break;
    case ET_OP_PARAMETERS: case ET_OP_PARAMETERS_GRID: case ET_OP_KNOTS:
        parameters(c, request);
        break;
    case ET_OP_FIT_CURVE: case ET_OP_FIT_GRID: case ET_OP_FIT_SCATTERED:
        fits(c, request);
        break;
    case ET_OP_APPROXIMATE:
        approximate(c, request->arg);
        break;
    case ET_OP_CURVE_NEAREST: case ET_OP_SURFACE_NEAREST: case ET_OP_SURFACE_ERROR:
        distances(c, request);
        break;
    case ET_OP_SEAM_GAP:
        seam(c, request->arg);
        break;
    default:
        net_operation(c, request);
    }
}

void judge_valid(judge_case *c, const et_request *request)
{
    *c = (judge_case){ ET_VALID, 1, "" };
    if ((size_t)request->op >= ET_OPS) {
        invalid(c, "no such operation");
        return;
    }
    words(c, request);
    if (c->validity != ET_INVALID)
        operation(c, request);
}
