/* campaign, relations of editing: the curve or surface stays where it is. */
#include "conform/campaign_relate.h"
#include "etalon/base/real.h"
#include <math.h>
#include <stdlib.h>

static const et_category edits[] = {ET_CATEGORY_PLAIN, ET_CATEGORY_EDITING, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_PLAIN, ET_CATEGORY_DEGREES,
                                    ET_CATEGORY_DEGENERATE};

/* The curve or surface at the beginning of a request or reply becomes the first arguments of a question of the point at x. */
static et_status ask_at(et_request *q, et_request_op op, const et_request *from, const et_reply *edited, const double x[2])
{
    const int surface = op == ET_OP_SURFACE_POINT;
    et_curve c = {0, 0, NULL, NULL, NULL};
    et_surface s = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t at = 0;
    et_status status = surface ? (edited ? et_reply_get_surface(&s, &at, edited) : et_request_surface(&s, from, 0))
                               : (edited ? et_reply_get_curve(&c, &at, edited) : et_request_curve(&c, from, 0));
    if (status != ET_OK) {
        return status;
    }
    const size_t n = surface ? s.nu * s.nv : c.n;
    const double *w = surface ? s.weights : c.weights, *P = surface ? &s.points[0].x : &c.points[0].x;
    status = et_request_new(q, op);
    if (status == ET_OK) {
        et_status set[10];
        size_t k = 0;
        set[k++] = et_request_set(q, 0, surface ? s.p : c.p, NULL);
        if (surface) {
            set[k++] = et_request_set(q, 1, s.q, NULL);
            set[k++] = et_request_set(q, 2, s.nu + s.p + 1, s.u);
            set[k++] = et_request_set(q, 3, s.nv + s.q + 1, s.v);
        } else {
            set[k++] = et_request_set(q, 1, c.n + c.p + 1, c.u);
        }
        const size_t net = surface ? 4 : 2;
        set[k++] = et_request_set(q, net, n, P);
        set[k++] = et_request_set(q, net + 1, w ? n : 0, w);
        set[k++] = et_request_set(q, net + 2, 1, &x[0]);
        if (surface) {
            set[k++] = et_request_set(q, net + 3, 1, &x[1]);
        }
        for (size_t i = 0; i < k; i++) {
            status = status == ET_OK ? set[i] : status;
        }
        if (status != ET_OK) {
            et_request_free(q);
        }
    }
    if (edited && surface) {
        et_surface_free(&s);
    } else if (edited) {
        et_curve_free(&c);
    }
    return status;
}

static double within(campaign_relation *r, const et_request_value *u, size_t p)
{
    const double lo = u->x[p], hi = u->x[u->count - 1 - p], x = lo + (hi - lo) * et_rng_uniform(r->rng);
    return campaign_clamp(lo, x, hi);
}

/* What errors of the new control points do to a point: each is a sum with convex coefficients, so its error is at most k u times the greatest |w P|;
 * of a rational one that of the numerator and |P| times that of the denominator, over the least weight. */
static double spread(const et_request *q, size_t times)
{
    const campaign_layout *l = campaign_layout_of(q->op);
    const et_request_value *w = &q->arg[l->net[0] + 1];
    double most = 1.0, least = 1.0;
    for (size_t i = 0; i < w->count; i++) {
        most = i == 0 ? w->x[i] : fmax(most, w->x[i]);
        least = i == 0 ? w->x[i] : fmin(least, w->x[i]);
    }
    size_t p = q->arg[l->axis[0].degree].count;
    p = l->axes > 1 && q->arg[l->axis[1].degree].count > p ? q->arg[l->axis[1].degree].count : p;
    return 16.0 * (double)(p + times + 1) * ET_UNIT * campaign_size(q, l->net[0]) * 2.0 * (most / least);
}

/* Points before and after, at some parameters. */
static void same_points(campaign_relation *r, const et_reply *edited, double more)
{
    const campaign_layout *l = campaign_layout_of(r->told->op);
    const et_request_op op = l->axes > 1 ? ET_OP_SURFACE_POINT : ET_OP_CURVE_POINT;
    for (size_t k = 0; k < 3 && r->status == ET_OK && !r->decided; k++) {
        double x[2] = {0.0, 0.0};
        et_request q[2];
        et_reply a, b;
        size_t n, m;
        for (size_t i = 0; i < l->axes; i++) {
            x[i] = within(r, &r->told->arg[l->axis[i].knots], r->told->arg[l->axis[i].degree].count);
        }
        et_status status = ask_at(&q[0], op, r->told, NULL, x);
        if (status == ET_OK) {
            status = ask_at(&q[1], op, r->told, edited, x);
            if (status != ET_OK) {
                et_request_free(&q[0]);
            }
        }
        if (status == ET_EFORMAT) {
            campaign_decide(r, ET_VERDICT_WRONG, "the reply is no curve or surface");
            return;
        }
        campaign_fail(r, status);
        if (status != ET_OK) {
            return;
        }
        double *e[2] = {campaign_bounds(r, &n, &q[0]), NULL};
        char reason[128];
        if (e[0] && et_judge_validity(reason, &q[1]) != ET_VALID) {
            campaign_decide(r, ET_VERDICT_WRONG, "the reply is no valid curve or surface with this domain");
        }
        e[1] = e[0] ? campaign_bounds(r, &m, &q[1]) : NULL;
        if (e[1] && campaign_asked(r, &a, &q[0], n)) {
            if (campaign_asked(r, &b, &q[1], n)) {
                for (size_t i = 0; i < n; i++) {
                    campaign_compare(r, i, b.x[i], a.x[i], e[0][i] + e[1][i] + more);
                }
                et_reply_free(&b);
            }
            et_reply_free(&a);
        }
        for (size_t i = 0; i < 2; i++) {
            free(e[i]);
            et_request_free(&q[i]);
        }
    }
}

void campaign_relate_edited(campaign_relation *r, et_request_op op)
{
    et_reply edited;
    if (!campaign_base(r, op, edits, sizeof edits / sizeof edits[0])) {
        return;
    }
    if (!r->hello->op[campaign_layout_of(op)->axes > 1 ? ET_OP_SURFACE_POINT : ET_OP_CURVE_POINT]) {
        campaign_decide(r, ET_VERDICT_UNSUPPORTED, "");
    }
    if (campaign_asked(r, &edited, r->told, SIZE_MAX)) {
        same_points(r, &edited, spread(r->told, r->told->arg[campaign_layout_of(op)->times].count));
        et_reply_free(&edited);
    }
}

/* Knots and control points as they were: insertion at quarters of short spans amplifies no error by more than 4^r. */
void campaign_relate_removed(campaign_relation *r)
{
    static const et_category exact[] = {ET_CATEGORY_EDITING};
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply inserted, back;
    et_curve c;
    size_t at = 0;
    if (!campaign_base(r, ET_OP_CURVE_INSERT, exact, 1)) {
        return;
    }
    const size_t times = r->told->arg[5].count, p = r->told->arg[0].count;
    const double tolerance = 0x1p-30 * campaign_size(r->told, 2);
    if (!r->hello->op[ET_OP_CURVE_REMOVE] || times > p) {
        campaign_decide(r, ET_VERDICT_UNSUPPORTED, "");
    }
    if (!campaign_asked(r, &inserted, r->told, SIZE_MAX)) {
        return;
    }
    const et_status status = et_reply_get_curve(&c, &at, &inserted);
    et_reply_free(&inserted);
    if (status == ET_EFORMAT) {
        campaign_decide(r, ET_VERDICT_WRONG, "the reply is no curve");
        return;
    }
    campaign_fail(r, status);
    if (status != ET_OK) {
        return;
    }
    campaign_fail(r, et_request_new(&q, ET_OP_CURVE_REMOVE));
    if (r->status == ET_OK) {
        campaign_fail(r, et_request_set(&q, 0, c.p, NULL));
        campaign_fail(r, et_request_set(&q, 1, c.n + c.p + 1, c.u));
        campaign_fail(r, et_request_set(&q, 2, c.n, &c.points[0].x));
        campaign_fail(r, et_request_set(&q, 3, c.weights ? c.n : 0, c.weights));
        campaign_fail(r, et_request_set(&q, 4, 1, r->told->arg[4].x));
        campaign_fail(r, et_request_set(&q, 5, times, NULL));
        campaign_fail(r, et_request_set(&q, 6, 1, &tolerance));
        if (campaign_asked(r, &back, &q, SIZE_MAX)) {
            et_reply rest = back;
            campaign_compare(r, 0, back.count > 0 ? back.x[0] : -1.0, (double)times, 0.0);
            if (back.count > 0) {
                rest.x++;
                rest.count--;
                same_points(r, &rest, tolerance + spread(r->told, times));
            }
            et_reply_free(&back);
        }
        et_request_free(&q);
    }
    et_curve_free(&c);
}
