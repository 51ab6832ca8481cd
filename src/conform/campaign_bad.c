/* campaign, bad input: a valid request made invalid in one place. */
#include "conform/campaign_parts.h"
#include <math.h>
#include <stdint.h>

static et_request_value *value(campaign_maker *m, int k)
{
    return &m->request->arg[k];
}

/* What is spoiled is there (`applies`), and a plain case has one knot, point and site at least.  1: the request is invalid; 0: it need not be. */

/* The argument gets n numbers (or points): those it has, without the last or with the first again. */
static int resize(campaign_maker *m, int k, size_t n, size_t width)
{
    const et_request_value *v = value(m, k);
    double *x = campaign_array(m, n * width);
    for (size_t i = 0; i < n * width; i++) {
        x[i] = v->x[i % (v->count * width)];
    }
    campaign_list(m, k, x, n);
    return 1;
}

static double broken(campaign_maker *m)
{
    const size_t kind = campaign_pick(m, 4);
    return kind < 2 ? NAN : kind == 2 ? HUGE_VAL : -HUGE_VAL;
}

/* One of the numbers becomes NaN or infinite. */
static int spoil_list(campaign_maker *m, int k, size_t width)
{
    const size_t i = campaign_pick(m, value(m, k)->count * width);
    value(m, k)->x[i] = broken(m);
    return 1;
}

static int one_number(campaign_maker *m, int k)
{
    value(m, k)->x[0] = broken(m);
    return 1;
}

/* Two different knots change places: the first and the last differ, so there are such. */
static int decrease(campaign_maker *m, int k)
{
    et_request_value *u = value(m, k);
    const size_t i = campaign_pick(m, u->count);
    size_t j = (i + 1) % u->count;
    while (u->x[j] == u->x[i]) {
        j = (j + 1) % u->count;
    }
    const double x = u->x[i];
    u->x[i] = u->x[j];
    u->x[j] = x;
    return 1;
}

/* No domain. */
static int empty(campaign_maker *m, const campaign_axis *a)
{
    et_request_value *u = value(m, a->knots);
    for (size_t i = 0; i < u->count; i++) {
        u->x[i] = u->x[0];
    }
    return 1;
}

static int fewer_knots(campaign_maker *m, const campaign_axis *a)
{
    const size_t p = value(m, a->degree)->count;
    return resize(m, a->knots, campaign_pick(m, 2) ? 2 * p + 1 : p, 1);
}

/* A point more or less than the knots say: of the net, or of the data. */
static int other_number(campaign_maker *m, int k)
{
    const size_t n = value(m, k)->count, more = campaign_pick(m, 2);
    return resize(m, k, more || n == 1 ? n + 1 : n - 1, 3);
}

static int bad_weight(campaign_maker *m, int net)
{
    const size_t n = value(m, net)->count;      /* 2 or more */
    double *w = campaign_array(m, n + 1);
    for (size_t k = 0; k <= n; k++) {
        w[k] = 1.0;
    }
    const size_t kind = campaign_pick(m, 4);
    const size_t i = campaign_pick(m, n);
    w[i] = kind < 2 ? -1.0 : kind == 2 ? broken(m) : 1.0;
    campaign_list(m, net + 1, w, kind < 3 ? n : campaign_pick(m, 2) ? n + 1 : n - 1);
    return 1;
}

/* An edit that cannot be made. */
static int bad_edit(campaign_maker *m)
{
    const campaign_layout *l = m->layout;
    const size_t axis = l->along >= 0 ? value(m, l->along)->count : 0;
    const int at = campaign_at(m->request, axis);
    const campaign_axis *a = &l->axis[axis];
    const size_t p = value(m, a->degree)->count, kind = campaign_pick(m, 4);
    const et_request_value *u = value(m, a->knots);
    const double lo = u->x[p], hi = u->x[u->count - 1 - p];
    const campaign_basis b = {p, u->count, u->count - p - 1, u->x};
    double *x = &value(m, at)->x[0];
    if (kind == 0) {
        *x = campaign_pick(m, 2) ? hi + (hi - lo) : lo - (hi - lo);
    } else if (l->tolerance >= 0) {
        *x = kind == 1 ? lo : kind == 2 ? hi : campaign_inside(m, &b);
        while (kind == 3 && campaign_multiplicity(&b, *x) > 0) {
            *x = campaign_real(m, lo, hi);
        }
    } else if (kind == 1) {
        *x = campaign_pick(m, 2) ? hi : lo;                          /* clamped: full already */
    } else {
        campaign_count(m, l->times, p + 2 - campaign_multiplicity(&b, *x) + campaign_pick(m, 2));
    }
    return 1;
}

/* Sites: outside, broken, or of another number. */
static int bad_sites(campaign_maker *m, const campaign_axis *a, size_t kind)
{
    et_request_value *t = value(m, a->sites);
    const et_request_value *u = value(m, a->knots);
    const double lo = u->x[0], hi = u->x[u->count - 1];
    if (kind == 0) {
        t->x[t->count - 1] = hi + (hi - lo);
        return m->op != ET_OP_SURFACE_ERROR;
    }
    if (kind == 1) {
        t->x[0] = lo - (hi - lo);
        return m->op != ET_OP_SURFACE_ERROR;
    }
    return kind == 2 ? spoil_list(m, a->sites, 1) : resize(m, a->sites, t->count + 1, 1);
}

static int bad_counts(campaign_maker *m, size_t kind)
{
    const size_t nx = value(m, 0)->count, ny = value(m, 1)->count;
    switch (m->op) {
    case ET_OP_PARAMETERS: return resize(m, 1, kind % 2, 3);
    case ET_OP_PARAMETERS_GRID:
        campaign_count(m, 1 + (int)(kind % 2), kind % 4 < 2 ? 1 : value(m, 1 + (int)(kind % 2))->count + 1);
        return 1;
    case ET_OP_KNOTS: {
        enum { PIEGL, AVERAGING, FAITHFUL, UNIFORM };
        const size_t p = value(m, 1)->count;
        if (kind % 4 == 0) {
            campaign_count(m, 2, p);                                              /* n <= p */
        } else if (kind % 4 == 1 && nx != UNIFORM) {
            campaign_count(m, 2, value(m, 3)->count + 1);                         /* more control points than parameters */
        } else if (kind % 4 == 2) {
            return spoil_list(m, 3, 1);
        } else {
            return resize(m, 3, 1, 1);
        }
        return 1;
    }
    case ET_OP_APPROXIMATE:
        campaign_count(m, 2 + (int)(kind % 2), kind % 4 < 2 ? value(m, (int)(kind % 2))->count : 0);
        return 1;
    case ET_OP_NET_COUNTS: campaign_count(m, (int)(kind % 2), kind / 2 % 2); return 1;
    case ET_OP_NET_CLASS:
        campaign_count(m, (int)(kind % 5), kind % 5 < 2 ? kind / 5 % 2 : kind % 5 == 2 ? 2 : kind % 5 == 3 ? nx : ny);
        return 1;
    case ET_OP_NET_NODE: campaign_count(m, 2, kind % 3 == 0 ? 0 : 2 * (nx * ny - nx - ny + 2) + kind % 3); return 1;
    default: return 0;
    }
}

/* The rules that can be broken, in the order in which they take turns. */
typedef enum { DECREASE, KNOT, WEIGHT, PARAMETER, POINT, EDIT, NUMBER, KNOTS, DATUM, COUNTS, SITES, EMPTY, DATA, KINDS } fault;

/* Whether the operation has what the fault is about. */
static int applies(const campaign_maker *m, fault kind)
{
    const campaign_layout *l = m->layout;
    const int knots = l->axes > 0, degree = knots && l->axis[0].degree >= 0;
    switch (kind) {
    case DECREASE: case KNOT: return knots;
    case PARAMETER: return l->at >= 0 || (knots && l->axis[0].at >= 0);
    case POINT: case NUMBER: return l->net[0] >= 0;
    case WEIGHT: return l->net[0] >= 0 && m->hello->rational;
    case EDIT: return l->times >= 0 && m->op != ET_OP_CURVE_ELEVATE && m->op != ET_OP_SURFACE_ELEVATE;
    case KNOTS: case EMPTY: return degree;
    case DATUM: return l->data >= 0;
    case DATA: return l->data >= 0 && m->op != ET_OP_PARAMETERS;       /* any number of points can be parameterised */
    case SITES: return knots && l->axis[0].sites >= 0;
    default: return m->op >= ET_OP_PARAMETERS && m->op != ET_OP_CURVE_NEAREST && m->op != ET_OP_SURFACE_NEAREST && m->op != ET_OP_SURFACE_ERROR &&
                    m->op != ET_OP_SEAM_GAP;
    }
}

static int spoil(campaign_maker *m, fault kind)
{
    const campaign_layout *l = m->layout;
    const campaign_axis *a = &l->axis[l->axes > 1 ? campaign_pick(m, l->axes) : 0];
    const int net = l->net[l->net[1] >= 0 ? campaign_pick(m, 2) : 0], at = l->along < 0 ? a->at : l->at;
    switch (kind) {
    case DECREASE: return decrease(m, a->knots);
    case KNOT: return spoil_list(m, a->knots, 1);
    case WEIGHT: return bad_weight(m, net);
    case PARAMETER: return one_number(m, at);
    case POINT: return spoil_list(m, net, 3);
    case EDIT: return bad_edit(m);
    case NUMBER: return other_number(m, net);
    case KNOTS: return fewer_knots(m, a);
    case DATUM: return spoil_list(m, l->data, 3);
    case COUNTS: return bad_counts(m, campaign_pick(m, 20));
    case SITES: return bad_sites(m, a, campaign_pick(m, 4));
    case EMPTY: return empty(m, a);
    default: return other_number(m, l->data);
    }
}

void campaign_spoil(campaign_maker *m)
{
    fault kinds[KINDS];
    size_t n = 0;
    int done = 0;
    for (int k = 0; k < KINDS; k++) {
        if (applies(m, (fault)k)) {
            kinds[n++] = (fault)k;
        }
    }
    for (size_t k = 0; k < n && !done; k++) {       /* every operation has a kind that never returns 0 */
        done = spoil(m, kinds[(size_t)((m->number + k) % n)]);
    }
}
