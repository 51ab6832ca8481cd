/* campaign, shrinking: degrees, knots with their control points, data with their sites. */
#include "conform/campaign_shrink.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- what is simpler ---- */

/* Bits of the odd part and the power of two; fractions cost more than whole numbers, a sign a little. */
uint64_t campaign_cost_of(double x)
{
    uint64_t bits = 0;
    int e = 0;
    if (!isfinite(x)) {
        return isnan(x) ? 100 : x > 0.0 ? 101 : 102;
    }
    if (x == 0.0) {
        return signbit(x) ? 1 : 0;
    }
    for (double r = frexp(fabs(x), &e); r > 0.0; bits++, e--) {
        r = 2.0 * r;
        r -= floor(r);
    }
    return 1 + 2 * (bits - 1) + (uint64_t)(e < 0 ? -4 * e : e) + (x < 0.0);
}

uint64_t campaign_cost(const et_request *q)
{
    enum { NUMBER = 1 << 16, COUNT = 1 << 13, WORD = 1 };
    uint64_t cost = 0;
    for (size_t k = 0; k < campaign_arguments(q->op); k++) {
        const et_request_kind kind = et_request_argument(q->op, k)->kind;
        const size_t n = kind == ET_ARG_REAL ? 1 : kind == ET_ARG_REALS ? q->arg[k].count : kind == ET_ARG_POINTS ? 3 * q->arg[k].count : 0;
        if (kind == ET_ARG_COUNT || kind == ET_ARG_WORD) {
            cost += (uint64_t)q->arg[k].count * (kind == ET_ARG_WORD ? WORD : COUNT);
        }
        for (size_t i = 0; i < n; i++) {
            cost += (kind == ET_ARG_REAL ? 0 : NUMBER) + campaign_cost_of(q->arg[k].x[i]);
        }
    }
    return cost;
}

/* ---- candidates ---- */

int campaign_try(campaign_shrinker *s, et_request *candidate)
{
    if (s->status != ET_OK || s->calls == 0) {
        return 0;
    }
    s->status = et_request_copy(candidate, &s->best);
    return s->status == ET_OK;
}

int campaign_take(campaign_shrinker *s, et_request *candidate)
{
    const uint64_t cost = campaign_cost(candidate);
    if (cost < s->cost) {
        s->calls--;
        if (s->fails(s->context, candidate)) {
            et_request_free(&s->best);
            s->best = *candidate;
            s->cost = cost;
            return 1;
        }
    }
    et_request_free(candidate);
    return 0;
}

void campaign_cut(et_request *q, int k, size_t width, size_t from, size_t count)
{
    et_request_value *v = &q->arg[k];
    if (from >= v->count || count > v->count - from) {
        return;
    }
    v->count -= count;
    memmove(v->x + from * width, v->x + (from + count) * width, (v->count - from) * width * sizeof *v->x);
    if (v->count == 0) {
        free(v->x);
        v->x = NULL;
    }
}

/* ---- nets ---- */

static size_t columns(const et_request *q, const campaign_layout *l, size_t axis)
{
    const campaign_axis *a = &l->axis[axis];
    const size_t nu = q->arg[a->knots].count, p = a->degree >= 0 ? q->arg[a->degree].count : 0;
    return nu > p + 1 ? nu - p - 1 : 0;
}

/* Rows from .. from + count - 1 of an nx x ny grid (along 0) or columns (along 1), of `width` numbers each, out of argument k. */
static void cut_grid(et_request *q, int k, size_t width, size_t nx, size_t ny, size_t along, size_t from, size_t count)
{
    if (q->arg[k].count != nx * ny) {
        return;
    }
    if (along == 0) {
        campaign_cut(q, k, width, from * ny, count * ny);
        return;
    }
    for (size_t i = nx; i > 0; i--) {
        campaign_cut(q, k, width, (i - 1) * ny + from, count);
    }
}

/* The same of the net (and its weights) that belongs to the axis, which has n control points still. */
static void cut_net(et_request *q, size_t axis, size_t n, size_t from, size_t count)
{
    const campaign_layout *l = campaign_layout_of(q->op);
    const int net = l->net[axis / 2];
    if (net < 0 || count == 0) {
        return;
    }
    const size_t nx = axis % 2 == 0 ? n : columns(q, l, axis - 1), ny = axis % 2 == 1 ? n : l->axes > 1 ? columns(q, l, axis + 1) : 1;
    cut_grid(q, net, 3, nx, ny, axis % 2, from, count);
    cut_grid(q, net + 1, 1, nx, ny, axis % 2, from, count);
}

/* ---- degrees ---- */

/* `more` new knots equidistant in the first span that is not empty; the list has room. */
static void fill(et_request_value *u, size_t more)
{
    size_t i = 1;
    while (i < u->count && !(u->x[i - 1] < u->x[i])) {
        i++;
    }
    if (i < u->count) {
        const double lo = u->x[i - 1], step = (u->x[i] - lo) / (double)(more + 1);
        memmove(u->x + i + more, u->x + i, (u->count - i) * sizeof *u->x);
        for (size_t k = 0; k < more; k++) {
            u->x[i + k] = lo + step * (double)(k + 1);
        }
        u->count += more;
    }
}

/* Knots fit for a lower degree: at the ends as many less, inside at most degree + 1; control points are dropped at the end (how 0) or the front (1),
 * or all stay and new knots come in (2). */
static void lower(et_request *q, size_t axis, size_t degree, int how)
{
    const campaign_layout *l = campaign_layout_of(q->op);
    const campaign_axis *a = &l->axis[axis];
    const size_t p = q->arg[a->degree].count, n = columns(q, l, axis), drop = p - degree;
    et_request_value *u = &q->arg[a->knots];
    const size_t room = u->count;
    size_t to = 0;
    for (size_t i = 0, run; i < u->count; i += run) {
        for (run = 1; i + run < u->count && u->x[i + run] == u->x[i]; run++) {
        }
        const int end = i == 0 || i + run == u->count;
        size_t left = end ? (run > drop ? run - drop : 1) : run <= degree + 1 ? run : degree + 1;
        for (; left > 0; left--) {
            u->x[to++] = u->x[i];
        }
    }
    u->count = to;
    q->arg[a->degree].count = degree;
    if (how == 2 && to < n + degree + 1 && n + degree + 1 <= room) {
        fill(u, n + degree + 1 - to);
        return;
    }
    const size_t less = to > degree + 1 ? to - degree - 1 : 0;
    cut_net(q, axis, n, how == 1 || less > n ? 0 : less, less > n ? 0 : n - less);
}

static int degrees(campaign_shrinker *s)
{
    const campaign_layout *l = campaign_layout_of(s->best.op);
    int progress = 0;
    for (size_t from = 0; from <= l->axes && l->axes > 0; from++) {         /* all axes at once, then each */
        size_t most = 0;
        for (size_t k = 0; k < l->axes; k++) {
            const int degree = l->axis[k].degree;
            most = degree >= 0 && (from == 0 || from == k + 1) && s->best.arg[degree].count > most ? s->best.arg[degree].count : most;
        }
        for (size_t p = 0; p < most && p < 64; p++) {
            for (int how = 0; how < 3; how++) {
                et_request c;
                if (!campaign_try(s, &c)) {
                    return progress;
                }
                for (size_t k = 0; k < l->axes; k++) {
                    if ((from == 0 || from == k + 1) && c.arg[l->axis[k].degree].count > p) {
                        lower(&c, k, p, how);
                    }
                }
                if (campaign_take(s, &c)) {
                    progress = 1;
                    p = most;
                    break;
                }
            }
        }
    }
    return progress;
}

/* ---- knots ---- */

/* A run of knots, and as many control points, out of one axis; 1 if that was taken. */
static int cut_knots(campaign_shrinker *s, size_t axis, size_t at, size_t run)
{
    const campaign_layout *l = campaign_layout_of(s->best.op);
    const size_t n = columns(&s->best, l, axis), nu = s->best.arg[l->axis[axis].knots].count, p = n > 0 ? nu - n - 1 : 0;
    const size_t rows[3] = {at > p ? at - p : 0, at, 0};
    for (size_t k = 0; k < 3 && (k == 0 || l->net[0] >= 0); k++) {
        et_request c;
        if (!campaign_try(s, &c)) {
            return 0;
        }
        if (n >= run) {
            cut_net(&c, axis, n, rows[k] + run <= n ? rows[k] : n - run, run);
        }
        campaign_cut(&c, l->axis[axis].knots, 1, at, run);
        if (campaign_take(s, &c)) {
            return 1;
        }
    }
    return 0;
}

static int knots(campaign_shrinker *s)
{
    const campaign_layout *l = campaign_layout_of(s->best.op);
    int progress = 0;
    for (size_t axis = 0; axis < l->axes; axis++) {
        const et_request_value *u = &s->best.arg[l->axis[axis].knots];
        for (size_t run = u->count / 2; run > 0; run /= 2) {
            for (size_t at = 0; at + run <= s->best.arg[l->axis[axis].knots].count && s->calls > 0;) {
                if (cut_knots(s, axis, at, run)) {
                    progress = 1;
                } else {
                    at += run > 1 ? run / 2 : 1;
                }
            }
        }
    }
    return progress;
}

/* The same knots taken out of both surfaces at once, so that what they share stays shared. */
static int knots_of_both(campaign_shrinker *s)
{
    const campaign_layout *l = campaign_layout_of(s->best.op);
    int progress = 0;
    for (size_t axis = 0; axis < 2 && l->axes == 4; axis++) {
        for (size_t at = 0; at < s->best.arg[l->axis[axis].knots].count && s->calls > 0;) {
            const size_t n[2] = {columns(&s->best, l, axis), columns(&s->best, l, axis + 2)};
            et_request c;
            if (n[0] != n[1] || n[0] == 0 || !campaign_try(s, &c)) {
                return progress;
            }
            for (size_t k = 0; k < 2; k++) {
                cut_net(&c, axis + 2 * k, n[k], at < n[k] ? at : n[k] - 1, 1);
                campaign_cut(&c, l->axis[axis + 2 * k].knots, 1, at, 1);
            }
            const int taken = campaign_take(s, &c);
            at += !taken;
            progress |= taken;
        }
    }
    return progress;
}

/* ---- data ---- */

/* Rows of data along one direction: their number; 0 where there are none.  *sites, *count: where sites and the number are told, or -1. */
static size_t rows_of(const et_request *q, size_t along, int *sites, int *count)
{
    const campaign_layout *l = campaign_layout_of(q->op);
    *sites = l->grid && l->axes > 1 ? l->axis[along].sites : along == 0 ? l->axis[0].sites : -1;
    *count = q->op == ET_OP_PARAMETERS_GRID ? 1 + (int)along : q->op == ET_OP_APPROXIMATE ? 4 + (int)along : -1;
    if (*count >= 0) {
        return q->arg[*count].count;
    }
    if (along > 0 && !l->grid) {
        return 0;
    }
    return *sites >= 0 ? q->arg[*sites].count : l->data >= 0 ? q->arg[l->data].count : 0;
}

static int cut_rows(campaign_shrinker *s, size_t along, size_t at, size_t run)
{
    const campaign_layout *l = campaign_layout_of(s->best.op);
    int sites, count, other[2];
    et_request c;
    if (!campaign_try(s, &c)) {
        return 0;
    }
    const size_t n = rows_of(&c, along, &sites, &count), across = l->grid ? rows_of(&c, 1 - along, &other[0], &other[1]) : 1;
    if (l->data >= 0) {
        cut_grid(&c, l->data, 3, along == 0 ? n : across, along == 0 ? across : n, along, at, run);
    }
    if (sites >= 0) {
        campaign_cut(&c, sites, 1, at, run);
    }
    if (c.op == ET_OP_FIT_SCATTERED) {
        campaign_cut(&c, l->axis[1].sites, 1, at, run);
    }
    if (count >= 0) {
        c.arg[count].count -= run;
    }
    return campaign_take(s, &c);
}

static int data(campaign_shrinker *s)
{
    int progress = 0, sites, count;
    for (size_t along = 0; along < 2; along++) {
        for (size_t run = rows_of(&s->best, along, &sites, &count) / 2; run > 0; run /= 2) {
            for (size_t at = 0; at + run <= rows_of(&s->best, along, &sites, &count) && s->calls > 0;) {
                if (cut_rows(s, along, at, run)) {
                    progress = 1;
                } else {
                    at += run;
                }
            }
        }
    }
    return progress;
}

/* ---- counts, and what fits nothing any more ---- */

static int counts(campaign_shrinker *s)
{
    int progress = 0;
    for (size_t k = 0; k < campaign_arguments(s->best.op); k++) {
        const et_request_kind kind = et_request_argument(s->best.op, k)->kind;
        const size_t n = s->best.arg[k].count, simpler[6] = {0, 1, 2, 3, n / 2, n - 1};
        if (kind != ET_ARG_COUNT && kind != ET_ARG_WORD) {
            continue;
        }
        for (size_t i = 0; i < 6 && n > 0; i++) {
            et_request c;
            if (simpler[i] >= n || !campaign_try(s, &c)) {
                continue;
            }
            c.arg[k].count = simpler[i];
            if (campaign_take(s, &c)) {
                progress = 1;
                break;
            }
        }
    }
    return progress;
}

/* No weights, of both surfaces at once. */
static int weights(campaign_shrinker *s)
{
    const campaign_layout *l = campaign_layout_of(s->best.op);
    et_request c;
    if (l->net[0] < 0 || s->best.arg[l->net[0] + 1].count == 0 || !campaign_try(s, &c)) {
        return 0;
    }
    for (size_t k = 0; k < 2 && l->net[k] >= 0; k++) {
        campaign_cut(&c, l->net[k] + 1, 1, 0, c.arg[l->net[k] + 1].count);
    }
    return campaign_take(s, &c);
}

/* Each list alone: nothing of it, or one item less. */
static int lists(campaign_shrinker *s)
{
    int progress = 0;
    for (size_t k = 0; k < campaign_arguments(s->best.op); k++) {
        const et_request_kind kind = et_request_argument(s->best.op, k)->kind;
        const size_t width = kind == ET_ARG_POINTS ? 3 : 1;
        for (int way = 0; way < 3 && (kind == ET_ARG_POINTS || kind == ET_ARG_REALS); way++) {
            const size_t n = s->best.arg[k].count;
            et_request c;
            if (n == 0 || !campaign_try(s, &c)) {
                break;
            }
            campaign_cut(&c, (int)k, width, way == 1 ? n - 1 : 0, way == 0 ? n : 1);
            progress |= campaign_take(s, &c);
        }
    }
    return progress;
}

int campaign_shrink_structure(campaign_shrinker *s)
{
    int progress = weights(s);
    progress |= degrees(s);
    progress |= data(s);
    progress |= knots_of_both(s);
    progress |= knots(s);
    progress |= counts(s);
    return lists(s) || progress;
}

et_status et_campaign_shrink(et_request *request, et_campaign_fails *fails, void *context, size_t calls)
{
    campaign_shrinker s = {{ET_OPS, {{0, NULL}}}, 0, fails, context, calls, ET_OK};
    const et_status status = et_request_copy(&s.best, request);
    if (status != ET_OK) {
        return status;
    }
    s.cost = campaign_cost(&s.best);
    /* Every step taken is cheaper than the one before, so this ends. */
    int progress = 1;
    while (progress && s.calls > 0 && s.status == ET_OK) {
        progress = 0;
        while (campaign_shrink_structure(&s)) {
            progress = 1;
        }
        progress |= campaign_shrink_numbers(&s);
    }
    if (s.status != ET_OK) {
        et_request_free(&s.best);
        return s.status;
    }
    et_request_free(request);
    *request = s.best;
    return ET_OK;
}
