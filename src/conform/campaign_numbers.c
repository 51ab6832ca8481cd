/* campaign, shrinking: shorter numbers. */
#include "conform/campaign_shrink.h"
#include <math.h>

enum { WAYS = 24 };

/* The way-th simplification of x; x where there is none. */
static double simpler(double x, size_t way)
{
    static const int bits[12] = {1, 2, 3, 4, 6, 8, 12, 16, 20, 26, 35, 44};
    int e;
    if (way < 2) {
        return way == 0 ? 0.0 : 1.0;
    }
    if (!isfinite(x) || x == 0.0) {
        return x;
    }
    const double r = frexp(x, &e);
    switch (way) {
    case 2: return fabs(x);
    case 3: return -1.0;
    case 4: return 2.0;
    case 5: return fabs(x) < 0x1p53 ? floor(x) : x;
    case 6: return fabs(x) < 0x1p53 ? ceil(x) : x;
    case 7: return e > 4 || e < -4 ? 2.0 * r : x;                        /* near 1 */
    case 8: return e > 4 || e < -4 ? ldexp(r, e - e / 2) : x;
    case 9: return ldexp(r, e - (e > 0 ? 1 : -1));
    case 10: return 0.5;
    case 11: return fabs(x) < 0x1p53 ? x - floor(x) : x;
    default: {
        const double kept = ldexp(floor(ldexp(fabs(r), bits[way - 12])), e - bits[way - 12]);
        return x < 0.0 ? -kept : kept;
    }
    }
}

/* ---- knots: different ones become 0, 1, 2, ... or equidistant in [0,1]; parameters and sites go with them ---- */

static double position(double x, const double *t, size_t n, const double *to, int half)
{
    if (!isfinite(x) || n == 0) {
        return x;
    }
    if (x < t[0]) {
        return to[0] - 1.0;
    }
    for (size_t i = 0; i < n; i++) {
        if (x == t[i]) {
            return to[i];
        }
        if (i + 1 < n && x < t[i + 1]) {
            const double f = half ? 0.5 : x / 2.0 / (t[i + 1] / 2.0 - t[i] / 2.0) - t[i] / 2.0 / (t[i + 1] / 2.0 - t[i] / 2.0);
            return isfinite(f) ? to[i] + f * (to[i + 1] - to[i]) : x;
        }
    }
    return to[n - 1] + 1.0;
}

static void move(et_request_value *v, size_t n, const double *t, size_t nt, const double *to, int half)
{
    for (size_t i = 0; i < n; i++) {
        v->x[i] = position(v->x[i], t, nt, to, half);
    }
}

/* The knots of the axis, and what is measured by them, at simple places. */
static void simple_knots(et_request *q, size_t axis, int unit, int half)
{
    enum { MOST = 256 };
    double t[MOST], to[MOST];
    const campaign_layout *l = campaign_layout_of(q->op);
    const campaign_axis *a = &l->axis[axis];
    et_request_value *u = &q->arg[a->knots];
    const int at = campaign_at(q, axis);
    size_t n = 0;
    for (size_t i = 0; i < u->count; i++) {
        if (!isfinite(u->x[i]) || (i > 0 && u->x[i] < u->x[i - 1]) || n == MOST) {
            return;
        }
        if (n == 0 || u->x[i] > t[n - 1]) {
            t[n++] = u->x[i];
        }
    }
    double step = 1.0;
    while (unit && step * (double)(n - 1) > 1.0) {
        step *= 0.5;
    }
    for (size_t i = 0; i < n; i++) {
        to[i] = unit && i + 1 == n ? 1.0 : step * (double)i;
    }
    move(u, u->count, t, n, to, half);
    if (at >= 0) {
        move(&q->arg[at], 1, t, n, to, half);
    }
    if (a->sites >= 0) {
        move(&q->arg[a->sites], q->arg[a->sites].count, t, n, to, half);
    }
}

static int knots(campaign_shrinker *s)
{
    const campaign_layout *l = campaign_layout_of(s->best.op);
    int progress = 0;
    for (size_t axis = 0; axis <= l->axes && l->axes > 0; axis++) {           /* each, then all at once */
        for (int way = 0; way < 4; way++) {
            et_request c;
            if (!campaign_try(s, &c)) {
                return progress;
            }
            for (size_t k = 0; k < l->axes; k++) {
                if (axis == k || axis == l->axes) {
                    simple_knots(&c, k, way % 2, way < 2);
                }
            }
            if (campaign_take(s, &c)) {
                progress = 1;
                break;
            }
        }
    }
    return progress;
}

/* Equal knots, parameters and sites together: each different knot to something simpler. */
static int each_knot(campaign_shrinker *s, size_t axis)
{
    const campaign_axis *a = &campaign_layout_of(s->best.op)->axis[axis];
    int progress = 0;
    for (size_t i = 0; i < s->best.arg[a->knots].count; i++) {
        const double x = s->best.arg[a->knots].x[i];
        if (i > 0 && s->best.arg[a->knots].x[i - 1] == x) {
            continue;
        }
        for (size_t way = 0; way < WAYS; way++) {
            const double y = simpler(x, way);
            et_request c;
            if (campaign_cost_of(y) >= campaign_cost_of(x) || !campaign_try(s, &c)) {
                continue;
            }
            const int places[3] = {a->knots, campaign_at(&c, axis), a->sites};
            for (size_t k = 0; k < 3; k++) {
                const size_t n = places[k] < 0 ? 0 : k == 1 ? 1 : c.arg[places[k]].count;
                for (size_t j = 0; j < n; j++) {
                    double *v = &c.arg[places[k]].x[j];
                    *v = *v == x ? y : *v;
                }
            }
            if (campaign_take(s, &c)) {
                progress = 1;
                break;
            }
        }
    }
    return progress;
}

/* ---- any numbers ---- */

static size_t numbers_of(const et_request *q, size_t k)
{
    const et_request_kind kind = et_request_argument(q->op, k)->kind;
    return kind == ET_ARG_REAL ? 1 : kind == ET_ARG_REALS ? q->arg[k].count : kind == ET_ARG_POINTS ? 3 * q->arg[k].count : 0;
}

/* Numbers from, from + stride, ... of argument k, all in one way. */
static int together(campaign_shrinker *s, size_t k, size_t from, size_t stride, size_t n)
{
    for (size_t way = 0; way < WAYS; way++) {
        et_request c;
        if (!campaign_try(s, &c)) {
            return 0;
        }
        for (size_t i = 0; i < n; i++) {
            double *x = &c.arg[k].x[from + i * stride];
            const double y = simpler(*x, way);
            *x = campaign_cost_of(y) < campaign_cost_of(*x) ? y : *x;
        }
        if (campaign_take(s, &c)) {
            return 1;
        }
    }
    return 0;
}

static int is_knots(et_request_op op, size_t k)
{
    const campaign_layout *l = campaign_layout_of(op);
    int found = 0;
    for (size_t axis = 0; axis < l->axes; axis++) {
        found = found || l->axis[axis].knots == (int)k;
    }
    return found;
}

int campaign_shrink_numbers(campaign_shrinker *s)
{
    const campaign_layout *l = campaign_layout_of(s->best.op);
    int progress = knots(s);
    for (size_t k = 0; k < campaign_arguments(s->best.op); k++) {
        const size_t n = numbers_of(&s->best, k), width = et_request_argument(s->best.op, k)->kind == ET_ARG_POINTS ? 3 : 1;
        if (n == 0 || is_knots(s->best.op, k)) {
            continue;
        }
        progress |= together(s, k, 0, 1, n);
        for (size_t c = 0; c < width && width > 1; c++) {                 /* one coordinate of all points */
            progress |= together(s, k, c, width, n / width);
        }
        for (size_t i = 0; i < n / width && width > 1; i++) {              /* one point */
            progress |= together(s, k, i * width, 1, width);
        }
        for (size_t i = 0; i < n; i++) {
            progress |= together(s, k, i, 1, 1);
        }
    }
    for (size_t axis = 0; axis < l->axes; axis++) {
        progress |= each_knot(s, axis);
    }
    for (size_t k = 0; k < campaign_arguments(s->best.op); k++) {             /* knots one by one: invalid ones need no neighbours */
        for (size_t i = 0; is_knots(s->best.op, k) && i < s->best.arg[k].count; i++) {
            progress |= together(s, k, i, 1, 1);
        }
    }
    return progress;
}
