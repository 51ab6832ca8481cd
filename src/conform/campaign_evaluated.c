/* campaign, relations of evaluation: what moves with the control points and the knots, and what bases add up to. */
#include "conform/campaign_relate.h"
#include "etalon/base/real.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const et_category usual[] = {ET_CATEGORY_PLAIN, ET_CATEGORY_PLAIN, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_END_OF_DOMAIN,
                                    ET_CATEGORY_NEAR_KNOTS, ET_CATEGORY_WEIGHTS, ET_CATEGORY_DEGREES, ET_CATEGORY_SEAM};
/* Those of bases. */
static const et_category bases[] = {ET_CATEGORY_PLAIN, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_END_OF_DOMAIN, ET_CATEGORY_NEAR_KNOTS,
                                    ET_CATEGORY_DEGREES};
enum { USUAL = sizeof usual / sizeof usual[0], BASES = sizeof bases / sizeof bases[0] };

/* The first numbers of the reply with derivatives against the reply without. */
void campaign_relate_order(campaign_relation *r, et_request_op op, et_request_op plain)
{
    const int basis = op == ET_OP_BASIS_DERS;
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply with, without;
    size_t n, m;
    if (!campaign_base(r, op, basis ? bases : usual, basis ? (size_t)BASES : (size_t)USUAL)) {
        return;
    }
    const int order = campaign_layout_of(op)->order;
    if (et_rng_index(r->rng, 2) == 0) {
        r->told->arg[order].count = 0;
    }
    et_status status = et_request_new(&q, plain);
    for (size_t k = 0; k < campaign_arguments(plain) && status == ET_OK; k++) {
        const et_request_kind kind = et_request_argument(plain, k)->kind;
        status = et_request_set(&q, k, kind == ET_ARG_REAL ? 1 : r->told->arg[k].count, r->told->arg[k].x);
    }
    campaign_fail(r, status);
    double *a = status == ET_OK ? campaign_bounds(r, &n, &q) : NULL, *b = a ? campaign_bounds(r, &m, r->told) : NULL;
    if (b && campaign_asked(r, &with, r->told, m)) {
        if (campaign_asked(r, &without, &q, n)) {
            for (size_t i = 0; i < n; i++) {
                campaign_compare(r, i, with.x[i], without.x[i], a[i] + b[i]);
            }
            et_reply_free(&without);
        }
        et_reply_free(&with);
    }
    free(a);
    free(b);
    et_request_free(&q);
}

/* The n numbers of one row add up to `want`, within their bounds and those of the sum. */
static void add_up(campaign_relation *r, const double *x, const double *bound, size_t n, double want)
{
    double size = 0.0;
    for (size_t i = 0; i < n; i++) {
        size += fabs(x[i]);
    }
    campaign_compare(r, 0, et_real_sum(x, n), want, et_real_sum(bound, n) + 64.0 * ET_UNIT * size);
}

void campaign_relate_unity(campaign_relation *r)
{
    et_reply N;
    size_t n;
    if (!campaign_base(r, ET_OP_BASIS, bases, BASES)) {
        return;
    }
    double *bound = campaign_bounds(r, &n, r->told);
    if (bound && campaign_asked(r, &N, r->told, n)) {
        add_up(r, N.x, bound, n, 1.0);
        for (size_t i = 0; i < n; i++) {                   /* none is negative */
            campaign_compare(r, i, N.x[i], fmax(N.x[i], 0.0), bound[i]);
        }
        et_reply_free(&N);
    }
    free(bound);
}

void campaign_relate_constant(campaign_relation *r)
{
    et_reply N;
    size_t n;
    if (!campaign_base(r, ET_OP_BASIS_DERS, bases, BASES)) {
        return;
    }
    double *bound = campaign_bounds(r, &n, r->told);
    if (bound && campaign_asked(r, &N, r->told, n)) {
        const size_t rows = r->told->arg[4].count + 1, row = n / rows;
        for (size_t k = 0; k < rows; k++) {
            add_up(r, N.x + k * row, bound + k * row, row, k == 0 ? 1.0 : 0.0);
        }
        et_reply_free(&N);
    }
    free(bound);
}

/* ---- translation, scaling, reversal ---- */

/* Order in v of the derivative number k of a surface; *total its order in all. */
static size_t order_in_v(size_t k, size_t *total)
{
    size_t t = 0;
    while ((t + 1) * (t + 2) / 2 <= k) {
        t++;
    }
    *total = t;
    return k - t * (t + 1) / 2;
}

/* Points i, j -> nu - 1 - i, j (axis 0) or i, nv - 1 - j. */
static void reverse_net(et_request_value *v, size_t nx, size_t ny, size_t width, size_t axis)
{
    if (v->count == 0) {
        return;
    }
    if (axis == 0) {
        campaign_reverse(v->x, nx, ny * width);
        return;
    }
    for (size_t i = 0; i < nx; i++) {
        campaign_reverse(v->x + i * ny * width, ny, width);
    }
}

/* The other side, if hello offers it. */
static size_t opposite(size_t side, const et_hello *hello)
{
    return side == 1 && hello->left ? 2 : side == 2 && hello->right ? 1 : side;
}

static int reverse(campaign_relation *r, et_request *q, size_t axis)
{
    const campaign_layout *l = campaign_layout_of(q->op);
    const campaign_axis *a = &l->axis[axis];
    const size_t nx = q->arg[l->axis[0].knots].count - q->arg[l->axis[0].degree].count - 1;
    const size_t ny = l->axes > 1 ? q->arg[l->axis[1].knots].count - q->arg[l->axis[1].degree].count - 1 : 1;
    const size_t side = q->arg[a->side].count;
    campaign_negate(&q->arg[a->knots]);
    reverse_net(&q->arg[l->net[0]], nx, ny, 3, axis);
    reverse_net(&q->arg[l->net[0] + 1], nx, ny, 1, axis);
    q->arg[a->at].x[0] = 0.0 - q->arg[a->at].x[0];
    q->arg[a->side].count = opposite(side, r->hello);
    return side == 0 || q->arg[a->side].count != side;
}

/* The same question of what was moved, in q; axis: the one reversed. */
static int move(campaign_relation *r, et_request *q, int how, size_t axis, double shift[3], int *power)
{
    const campaign_layout *l = campaign_layout_of(q->op);
    et_request_value *P = &q->arg[l->net[0]];
    if (how == CAMPAIGN_REVERSE) {
        return reverse(r, q, axis);
    }
    *power = (int)et_rng_index(r->rng, 61) - 30;
    for (size_t c = 0; c < 3; c++) {
        shift[c] = (double)et_rng_index(r->rng, 2001) - 1000.0;
    }
    for (size_t i = 0; i < 3 * P->count; i++) {
        P->x[i] = how == CAMPAIGN_SCALE ? ldexp(P->x[i], *power) : P->x[i] + shift[i % 3];
    }
    return 1;
}

void campaign_relate_moved(campaign_relation *r, et_request_op op, int how)
{
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply before, after;
    size_t n, m;
    double shift[3] = {0.0, 0.0, 0.0};
    int power = 0;
    if (!campaign_base(r, op, usual, USUAL)) {
        return;
    }
    if (how == CAMPAIGN_SHIFT) {
        campaign_dyadic(&r->told->arg[campaign_layout_of(op)->net[0]]);
    }
    if (!campaign_again(r, &q)) {
        return;
    }
    const size_t axis = campaign_layout_of(op)->axes > 1 ? et_rng_index(r->rng, 2) : 0;
    if (!move(r, &q, how, axis, shift, &power)) {
        campaign_decide(r, ET_VERDICT_UNSUPPORTED, "");
    }
    double *a = campaign_bounds(r, &n, r->told), *b = a ? campaign_bounds(r, &m, &q) : NULL;
    if (b && campaign_asked(r, &before, r->told, n)) {
        if (campaign_asked(r, &after, &q, n)) {
            for (size_t i = 0; i < n; i++) {
                size_t total = i / 3, in_v = op == ET_OP_SURFACE_DERS ? order_in_v(i / 3, &total) : 0;
                const size_t order = axis == 0 ? total - in_v : in_v;
                const double sign = how == CAMPAIGN_REVERSE && order % 2 ? -1.0 : 1.0, moved = how == CAMPAIGN_SHIFT && i < 3 ? shift[i] : 0.0;
                campaign_compare(r, i, after.x[i], sign * ldexp(before.x[i], how == CAMPAIGN_SCALE ? power : 0) + moved,
                                 ldexp(a[i], how == CAMPAIGN_SCALE ? power : 0) + b[i] + 2.0 * ET_UNIT * fabs(after.x[i]));
            }
            et_reply_free(&after);
        }
        et_reply_free(&before);
    }
    free(a);
    free(b);
    et_request_free(&q);
}

/* ---- u and v change places ---- */

static void swap(et_request *q, int a, int b)
{
    const et_request_value v = q->arg[a];
    q->arg[a] = q->arg[b];
    q->arg[b] = v;
}

static void transpose(et_request_value *v, const et_request_value *old, size_t nx, size_t ny, size_t width)
{
    for (size_t k = 0; k < nx * ny && old->count > 0; k++) {
        memcpy(v->x + (k % ny * nx + k / ny) * width, old->x + k * width, width * sizeof *v->x);
    }
}

void campaign_relate_transposed(campaign_relation *r)
{
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply before, after;
    size_t n, m;
    if (!campaign_base(r, ET_OP_SURFACE_DERS, usual, USUAL) || !campaign_again(r, &q)) {
        return;
    }
    const size_t nx = q.arg[2].count - q.arg[0].count - 1, ny = q.arg[3].count - q.arg[1].count - 1;
    transpose(&q.arg[4], &r->told->arg[4], nx, ny, 3);
    transpose(&q.arg[5], &r->told->arg[5], nx, ny, 1);
    swap(&q, 0, 1);
    swap(&q, 2, 3);
    swap(&q, 6, 7);
    swap(&q, 8, 9);
    double *a = campaign_bounds(r, &n, r->told), *b = a ? campaign_bounds(r, &m, &q) : NULL;
    if (b && campaign_asked(r, &before, r->told, n)) {
        if (campaign_asked(r, &after, &q, n)) {
            for (size_t i = 0; i < n; i++) {
                size_t total, in_v = order_in_v(i / 3, &total), other = 3 * (total * (total + 1) / 2 + total - in_v) + i % 3;
                campaign_compare(r, i, after.x[other], before.x[i], a[i] + b[other]);
            }
            et_reply_free(&after);
        }
        et_reply_free(&before);
    }
    free(a);
    free(b);
    et_request_free(&q);
}

/* ---- at knots ---- */

static size_t times(const et_request_value *u, double x)
{
    size_t n = 0;
    for (size_t i = 0; i < u->count; i++) {
        n += u->x[i] == x;
    }
    return n;
}

/* An inner knot of a valid curve that is there p times at most; 0 if there is none. */
static int smooth_knot(campaign_relation *r, double *x)
{
    const et_request_value *u = &r->told->arg[1];
    const size_t p = r->told->arg[0].count, n = u->count - p - 1;
    int found = 0;
    for (size_t i = p + 1; i < n; i++) {
        if (times(u, u->x[i]) <= p && (!found || et_rng_index(r->rng, 2))) {
            *x = u->x[i];
            found = 1;
        }
    }
    return found;
}

void campaign_relate_limits(campaign_relation *r)
{
    static const et_category knotted[] = {ET_CATEGORY_PLAIN, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_WEIGHTS};
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply right, left;
    size_t n;
    if (!campaign_base(r, ET_OP_CURVE_POINT, knotted, 3)) {
        return;
    }
    if (!r->hello->left || !r->hello->right || !smooth_knot(r, r->told->arg[4].x)) {
        campaign_decide(r, ET_VERDICT_UNSUPPORTED, "");
        return;
    }
    r->told->arg[5].count = 1;
    if (!campaign_again(r, &q)) {
        return;
    }
    q.arg[5].count = 2;
    double *bound = campaign_bounds(r, &n, r->told);
    if (bound && campaign_asked(r, &right, r->told, n)) {
        if (campaign_asked(r, &left, &q, n)) {
            for (size_t i = 0; i < n; i++) {
                campaign_compare(r, i, left.x[i], right.x[i], 2.0 * bound[i]);
            }
            et_reply_free(&left);
        }
        et_reply_free(&right);
    }
    free(bound);
    et_request_free(&q);
}

/* With x = u_k < u_k+1, a knot before the end of the domain: as many knots up to number k equal x as multiplicity says. */
void campaign_relate_spans(campaign_relation *r)
{
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply span, count;
    if (!campaign_base(r, ET_OP_SPAN, bases, BASES)) {
        return;
    }
    const size_t p = r->told->arg[0].count, nu = r->told->arg[1].count;
    const double *u = r->told->arg[1].x, x = u[p + et_rng_index(r->rng, nu - 2 * p - 1)];
    r->told->arg[2].x[0] = x;
    campaign_fail(r, et_request_new(&q, ET_OP_MULTIPLICITY));
    campaign_fail(r, et_request_set(&q, 0, nu, u));
    campaign_fail(r, et_request_set(&q, 1, 1, &x));
    if (campaign_asked(r, &span, r->told, 1)) {
        if (campaign_asked(r, &count, &q, 1)) {
            size_t upto = 0;
            for (size_t i = 0; i < nu; i++) {
                upto += (double)i <= span.x[0] && u[i] == x;
            }
            campaign_compare(r, 0, count.x[0], (double)upto, 0.0);
            et_reply_free(&count);
        }
        et_reply_free(&span);
    }
    et_request_free(&q);
}

/* Marsden: with the Greville points for control points C(x) = x. */
void campaign_relate_greville(campaign_relation *r)
{
    static const et_category few[] = {ET_CATEGORY_PLAIN, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_DEGREES};
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply g, C;
    size_t n, m;
    if (!campaign_base(r, ET_OP_CURVE_POINT, few, 3)) {
        return;
    }
    const size_t p = r->told->arg[0].count;
    campaign_fail(r, et_request_new(&q, ET_OP_GREVILLE));
    campaign_fail(r, et_request_set(&q, 0, p, NULL));
    campaign_fail(r, et_request_set(&q, 1, r->told->arg[1].count, r->told->arg[1].x));
    campaign_fail(r, et_request_set(r->told, 3, 0, NULL));
    double *a = p > 0 ? campaign_bounds(r, &n, &q) : NULL;
    if (a && campaign_asked(r, &g, &q, n)) {
        double worst = 0.0;
        for (size_t i = 0; i < n; i++) {
            r->told->arg[2].x[3 * i] = g.x[i];
            r->told->arg[2].x[3 * i + 1] = r->told->arg[2].x[3 * i + 2] = 0.0;
            worst = fmax(worst, a[i]);
        }
        double *b = campaign_bounds(r, &m, r->told);
        if (b && campaign_asked(r, &C, r->told, m)) {
            campaign_compare(r, 0, C.x[0], r->told->arg[4].x[0], worst + b[0]);
            et_reply_free(&C);
        }
        free(b);
        et_reply_free(&g);
    }
    free(a);
    et_request_free(&q);
}
