/* campaign, neighbours: a request whose numbers are moved a little or much. */
#include "conform/campaign_parts.h"
#include <math.h>

typedef struct { et_rng *rng; et_request *q; } varier;

static size_t pick(varier *v, size_t n)
{
    return et_rng_index(v->rng, n);
}

/* Drawn in statements of their own: the order of two draws in one expression is the compiler's.  By ulps, by a part, by a power of two, to the
 * other sign, or to a short number. */
static double moved(varier *v, double x)
{
    const double sign = pick(v, 2) ? 1.0 : -1.0, part = et_rng_uniform(v->rng);
    switch (pick(v, 8)) {
    case 0:
    case 1:
        for (size_t k = 1 + pick(v, 8); k > 0; k--) {
            x = nextafter(x, sign * HUGE_VAL);
        }
        return x;
    case 2:
    case 3: return x + sign * x * ldexp(part, -(int)pick(v, 50));
    case 4: return ldexp(x, (int)pick(v, 7) - 3);
    case 5: return x * (1.0 + sign * part);
    case 6: return -x;
    default: return x == 0.0 ? sign : floor(x);
    }
}

/* All knots equal to one of an axis, and by chance what is measured there: to a place between its neighbours. */
static void move_knot(varier *v, size_t axis)
{
    const campaign_axis *a = &campaign_layout_of(v->q->op)->axis[axis];
    et_request_value *u = &v->q->arg[a->knots];
    if (u->count < 2) {
        return;
    }
    const double x = u->x[pick(v, u->count)];
    size_t first = 0, behind = u->count;
    if (isnan(x)) {                                        /* equal to none, itself included */
        return;
    }
    while (u->x[first] != x) {
        first++;
    }
    while (u->x[behind - 1] != x) {
        behind--;
    }
    const double lo = first > 0 ? u->x[first - 1] : -HUGE_VAL, hi = behind < u->count ? u->x[behind] : HUGE_VAL, f = et_rng_uniform(v->rng);
    double y = moved(v, x);
    if (isfinite(lo) && isfinite(hi) && pick(v, 2)) {
        y = pick(v, 3) ? lo + (hi - lo) * f : pick(v, 2) ? nextafter(lo, hi) : nextafter(hi, lo);
    }
    if (!(lo < y && y < hi)) {
        return;
    }
    const int at = campaign_at(v->q, axis), along = pick(v, 2) != 0;
    for (size_t i = first; i < behind; i++) {
        u->x[i] = y;
    }
    if (at >= 0 && along && v->q->arg[at].x[0] == x) {
        v->q->arg[at].x[0] = y;
    }
}

static void move_parameter(varier *v, size_t axis)
{
    const campaign_axis *a = &campaign_layout_of(v->q->op)->axis[axis];
    const int at = campaign_at(v->q, axis), place = at >= 0 ? at : a->sites;
    const et_request_value *u = &v->q->arg[a->knots];
    if (place < 0 || (at < 0 && v->q->arg[place].count == 0)) {
        return;
    }
    double *x = &v->q->arg[place].x[at >= 0 ? 0 : pick(v, v->q->arg[place].count)];
    if (u->count > 1 && pick(v, 3) == 0) {
        *x = u->x[pick(v, u->count)];
        *x = pick(v, 2) ? *x : nextafter(*x, pick(v, 2) ? HUGE_VAL : -HUGE_VAL);
    } else if (u->count > 1 && pick(v, 2)) {
        *x = u->x[0] + (u->x[u->count - 1] - u->x[0]) * et_rng_uniform(v->rng);
    } else {
        *x = moved(v, *x);
    }
}

static void move_number(varier *v, size_t k, size_t width)
{
    et_request_value *a = &v->q->arg[k];
    if (a->count > 0) {
        double *x = &a->x[pick(v, width * a->count)];
        *x = width == 1 ? fabs(moved(v, *x)) : moved(v, *x);
    }
}

static void mutate(varier *v)
{
    const campaign_layout *l = campaign_layout_of(v->q->op);
    const size_t kind = pick(v, 4), axis = l->axes > 0 ? pick(v, l->axes) : 0, net = l->net[1] >= 0 ? pick(v, 2) : 0;
    if (kind == 0 && l->axes > 0) {
        move_parameter(v, axis);
    } else if (kind == 1 && l->axes > 0) {
        move_knot(v, axis);
    } else if (kind == 2 && l->net[net] >= 0 && v->q->arg[l->net[net] + 1].count > 0) {
        move_number(v, (size_t)l->net[net] + 1, 1);
    } else if (l->data >= 0 && (l->net[0] < 0 || pick(v, 2))) {
        move_number(v, (size_t)l->data, 3);
    } else if (l->net[net] >= 0) {
        move_number(v, (size_t)l->net[net], 3);
    } else if (v->q->op == ET_OP_KNOTS) {
        move_number(v, 3, 1);
    }
}

et_status et_campaign_vary(et_request *varied, const et_request *request, uint64_t seed, uint64_t number, const et_hello *hello)
{
    enum { TRIES = 16 };
    char reason[128];
    const et_validity validity = et_judge_validity(reason, request);
    et_rng *rng;
    et_request made;
    et_status status = et_rng_new(&rng, et_rng_stream(seed, number));
    if (status != ET_OK) {
        return status;
    }
    int done = 0;
    for (size_t k = 0; !done && status == ET_OK; k++) {
        status = et_request_copy(&made, request);
        if (status == ET_OK) {
            varier v = {rng, &made};
            for (size_t n = k < TRIES ? 1 + pick(&v, 3) : 0; n > 0; n--) {       /* at the last try: the request as it is */
                mutate(&v);
            }
            done = k == TRIES || (et_judge_validity(reason, &made) == validity && campaign_offered(&made, hello));
            if (!done) {
                et_request_free(&made);
            }
        }
    }
    et_rng_free(rng);
    if (status == ET_OK) {
        *varied = made;
    }
    return status;
}
