/* campaign, relations of parameters and fits, seams, nearest points, and the double net. */
#include "conform/campaign_relate.h"
#include "conform/judge_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/spline/basis.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const et_category fits[] = {ET_CATEGORY_PLAIN, ET_CATEGORY_DEGENERATE, ET_CATEGORY_PLAIN, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_FIT_FAILURE};
static const et_category lines[] = {ET_CATEGORY_PLAIN, ET_CATEGORY_DEGENERATE, ET_CATEGORY_SEAM};

/* Data moved: by whole numbers, by a power of two, or in reversed order. */
static void move_data(campaign_relation *r, et_request_value *P, int how, double shift[3], int *power)
{
    *power = how == CAMPAIGN_SCALE ? (int)et_rng_index(r->rng, 61) - 30 : 0;
    for (size_t c = 0; c < 3; c++) {
        shift[c] = how == CAMPAIGN_SHIFT ? (double)et_rng_index(r->rng, 2001) - 1000.0 : 0.0;
    }
    for (size_t i = 0; i < 3 * P->count; i++) {
        P->x[i] = ldexp(P->x[i] + shift[i % 3], *power);
    }
}

void campaign_relate_parameters(campaign_relation *r, int how)
{
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply before, after;
    size_t n, m;
    double shift[3];
    int power;
    if (!campaign_base(r, ET_OP_PARAMETERS, lines, 3)) {
        return;
    }
    campaign_dyadic(&r->told->arg[1]);
    if (!campaign_again(r, &q)) {
        return;
    }
    if (how == CAMPAIGN_REVERSE) {
        campaign_reverse(q.arg[1].x, q.arg[1].count, 3);
    } else {
        move_data(r, &q.arg[1], how, shift, &power);
    }
    double *a = campaign_bounds(r, &n, r->told), *b = a ? campaign_bounds(r, &m, &q) : NULL;
    if (b && campaign_asked(r, &before, r->told, n)) {
        if (campaign_asked(r, &after, &q, n)) {
            for (size_t i = 0; i < n; i++) {
                const size_t k = how == CAMPAIGN_REVERSE ? n - 1 - i : i;
                campaign_compare(r, i, after.x[i], how == CAMPAIGN_REVERSE ? 1.0 - before.x[k] : before.x[k], a[k] + b[i] + ET_UNIT);
            }
            et_reply_free(&after);
        }
        et_reply_free(&before);
    }
    free(a);
    free(b);
    et_request_free(&q);
}

/* ---- least squares ---- */

static size_t controls(const et_request *q, size_t axis)
{
    const campaign_axis *a = &campaign_layout_of(q->op)->axis[axis];
    return q->arg[a->knots].count - q->arg[a->degree].count - 1;
}

/* Knots and sites -x in reversed order, data in reversed order of the sites, along all axes. */
static void reverse_fit(et_request *q)
{
    const campaign_layout *l = campaign_layout_of(q->op);
    for (size_t k = 0; k < l->axes; k++) {
        campaign_negate(&q->arg[l->axis[k].knots]);
        campaign_negate(&q->arg[l->axis[k].sites]);
    }
    campaign_reverse(q->arg[l->data].x, q->arg[l->data].count, 3);
}

void campaign_relate_fitted(campaign_relation *r, et_request_op op, int how)
{
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply before, after;
    size_t n, m;
    double shift[3] = {0.0, 0.0, 0.0};
    int power = 0;
    if (!campaign_base(r, op, fits, sizeof fits / sizeof fits[0])) {
        return;
    }
    if (how == CAMPAIGN_SHIFT) {
        campaign_dyadic(&r->told->arg[campaign_layout_of(op)->data]);
    }
    if (!campaign_again(r, &q)) {
        return;
    }
    if (how == CAMPAIGN_REVERSE) {
        reverse_fit(&q);
    } else {
        move_data(r, &q.arg[campaign_layout_of(op)->data], how, shift, &power);
    }
    double *a = campaign_bounds(r, &n, r->told), *b = a ? campaign_bounds(r, &m, &q) : NULL;
    if (b && campaign_asked(r, &before, r->told, n)) {
        if (campaign_asked(r, &after, &q, n)) {
            for (size_t i = 0; i < n; i++) {
                const size_t k = how == CAMPAIGN_REVERSE ? 3 * (n / 3 - 1 - i / 3) + i % 3 : i;
                const double want = ldexp(before.x[k] + shift[i % 3], power);
                campaign_compare(r, i, after.x[i], want, ldexp(a[k], power) + b[i] + 2.0 * ET_UNIT * fabs(after.x[i]));
            }
            et_reply_free(&after);
        }
        et_reply_free(&before);
    }
    free(a);
    free(b);
    et_request_free(&q);
}

/* The basis functions at a site; *first: the number of the first that is not zero. */
static int functions(double *N, size_t *first, const et_request *q, size_t axis, double x)
{
    const campaign_axis *a = &campaign_layout_of(q->op)->axis[axis];
    const et_request_value *u = &q->arg[a->knots];
    const size_t p = q->arg[a->degree].count, span = et_knots_span(u->x, u->count, p, x), room = et_basis_work(p, 0);
    double *work = et_size_array(room, sizeof *work);
    if (!work) {
        return 0;
    }
    et_basis_eval(N, u->x, u->count, p, span, x, work, room);
    free(work);
    *first = span - p;
    return 1;
}

typedef struct { size_t p[2], n[2], first[2]; double *N[2]; } row;

/* The k-th row of the system: N_i(a) M_j(b) of data point k. */
static int row_of(row *w, const et_request *q, size_t k)
{
    const campaign_layout *l = campaign_layout_of(q->op);
    int ok = 1;
    for (size_t axis = 0; axis < l->axes; axis++) {
        const size_t across = l->grid ? q->arg[l->axis[1].sites].count : 1;
        const size_t site = !l->grid ? k : axis == 0 ? k / across : k % across;
        ok = ok && functions(w->N[axis], &w->first[axis], q, axis, q->arg[l->axis[axis].sites].x[site]);
    }
    return ok;
}

/* gradient += A_k (A_k X - P_k), magnitude += |A_k| (|A_k| |X| + |P_k|), weight += |A_k|. */
static void add_row(const row *w, const double *X, const double *P, double *gradient, double *magnitude, double *weight)
{
    double e[3] = {-P[0], -P[1], -P[2]}, size[3] = {fabs(P[0]), fabs(P[1]), fabs(P[2])};
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i <= w->p[0]; i++) {
            for (size_t j = 0; j <= w->p[1]; j++) {
                const size_t at = (w->first[0] + i) * w->n[1] + w->first[1] + j;
                const double a = w->N[0][i] * w->N[1][j];
                for (size_t c = 0; c < 3; c++) {
                    if (pass == 0) {
                        e[c] += a * X[3 * at + c];
                        size[c] += a * fabs(X[3 * at + c]);
                    } else {
                        gradient[3 * at + c] += a * e[c];
                        magnitude[3 * at + c] += a * size[c];
                    }
                }
                weight[at] += pass == 1 ? a : 0.0;
            }
        }
    }
}

/* |A'(A X - P)| where the exact optimum has 0: with |X - X*| <= bound, A'A (X - X*) is at most (sum of column |A|) max bound, the rows of A adding up
 * to 1; computing it costs k u |A|'(|A||X| + |P|). */
static void residual(campaign_relation *r, const et_reply *X, const double *bound, row *w)
{
    const et_request *q = r->told;
    const et_request_value *P = &q->arg[campaign_layout_of(q->op)->data];
    const size_t n = w->n[0] * w->n[1];
    double *sums = et_size_array(7 * n, sizeof *sums), worst = 0.0;
    int ok = sums != NULL;
    for (size_t k = 0; ok && k < P->count; k++) {
        ok = row_of(w, q, k);
        if (ok) {
            add_row(w, X->x, P->x + 3 * k, sums, sums + 3 * n, sums + 6 * n);
        }
    }
    for (size_t i = 0; ok && i < 3 * n; i++) {
        worst = fmax(worst, bound[i]);
    }
    for (size_t i = 0; ok && i < 3 * n; i++) {
        const double k = 16.0 * (double)(w->p[0] + w->p[1] + 2) + 2.0 * (double)P->count;
        campaign_compare(r, i, sums[i], 0.0, sums[6 * n + i / 3] * worst + k * ET_UNIT * sums[3 * n + i]);
    }
    campaign_fail(r, ok ? ET_OK : ET_ENOMEM);
    free(sums);
}

void campaign_relate_normal(campaign_relation *r, et_request_op op)
{
    const campaign_layout *l = campaign_layout_of(op);
    double one = 1.0;
    row w = {{0, 0}, {1, 1}, {0, 0}, {&one, &one}};
    et_reply X;
    size_t n;
    if (!campaign_base(r, op, fits, sizeof fits / sizeof fits[0])) {
        return;
    }
    if (op == ET_OP_FIT_GRID) {
        r->told->arg[0].count = 0;                       /* free corners */
    }
    double *own[2] = {NULL, NULL};
    for (size_t k = 0; k < l->axes; k++) {
        w.p[k] = r->told->arg[l->axis[k].degree].count;
        w.n[k] = controls(r->told, k);
        w.N[k] = own[k] = et_size_array(w.p[k] + 1, sizeof(double));
        campaign_fail(r, own[k] ? ET_OK : ET_ENOMEM);
    }
    double *bound = campaign_bounds(r, &n, r->told);
    if (bound && campaign_asked(r, &X, r->told, n)) {
        residual(r, &X, bound, &w);
        et_reply_free(&X);
    }
    free(bound);
    free(own[0]);
    free(own[1]);
}

/* ---- approximation: an opaque fitter ---- */

/* The greatest distance of neighbours in the grid of data. */
static double coarse(const et_request *q)
{
    const size_t ny = q->arg[5].count, n = q->arg[6].count;
    double most = 0.0;
    for (size_t k = 0; k < n; k++) {
        for (size_t c = 0; c < 3; c++) {
            const double *x = q->arg[6].x + 3 * k + c;
            most = fmax(most, fabs((k + 1) % ny ? x[3] - x[0] : 0.0));
            most = fmax(most, fabs(k + ny < n ? x[3 * ny] - x[0] : 0.0));
        }
    }
    return most;
}

static int surface_of(campaign_relation *r, et_surface *s, const et_request *q)
{
    et_reply reply;
    size_t at = 0;
    if (!campaign_asked(r, &reply, q, SIZE_MAX)) {
        return 0;
    }
    const et_status status = et_reply_get_surface(s, &at, &reply);
    et_reply_free(&reply);
    const int unit = status == ET_OK && et_surface_valid(s) && s->u[s->p] == 0.0 && s->u[s->nu] == 1.0 && s->v[s->q] == 0.0 && s->v[s->nv] == 1.0;
    if (status == ET_EFORMAT || (status == ET_OK && !unit)) {
        if (status == ET_OK) {
            et_surface_free(s);
        }
        campaign_decide(r, ET_VERDICT_WRONG, "the reply is no surface on [0,1]^2");
        return 0;
    }
    campaign_fail(r, status);
    return status == ET_OK;
}

static et_vec3 point(campaign_relation *r, const et_surface *s, double u, double v)
{
    et_vec3 S = {0.0, 0.0, 0.0};
    const size_t room = et_surface_work(s);
    double *work = et_size_array(room, sizeof *work);
    if (work) {
        S = et_surface_point(s, u, v, work, room);
    }
    campaign_fail(r, work ? ET_OK : ET_ENOMEM);
    free(work);
    return S;
}

/* The fitter's own parameters and knots do not depend on place and size, so its surfaces move with the data: within 2^-20 of their size, which
 * leaves room for any stable method.  Knots chosen from one end do depend on the order; but a surface that follows its data is never further from its
 * mirror image than a few of the data's distances. */
void campaign_relate_approximate(campaign_relation *r, int how)
{
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_surface a, b;
    double shift[3] = {0.0, 0.0, 0.0};
    int power = 0;
    if (!campaign_base(r, ET_OP_APPROXIMATE, lines, 1)) {
        return;
    }
    campaign_dyadic(&r->told->arg[6]);
    if (!campaign_again(r, &q)) {
        return;
    }
    if (how == CAMPAIGN_REVERSE) {
        campaign_reverse(q.arg[6].x, q.arg[4].count, 3 * q.arg[5].count);
    } else {
        move_data(r, &q.arg[6], how, shift, &power);
    }
    const double size = campaign_size(r->told, 6) + fabs(shift[0]) + fabs(shift[1]) + fabs(shift[2]);
    const double tolerance = how == CAMPAIGN_REVERSE ? 4.0 * coarse(r->told) : ldexp(0x1p-20 * size, power);
    if (surface_of(r, &a, r->told)) {
        if (surface_of(r, &b, &q)) {
            for (size_t k = 0; k < 25; k++) {
                const double u = 0.25 * (double)(k / 5), v = 0.25 * (double)(k % 5);
                const et_vec3 S = point(r, &a, u, v), T = point(r, &b, how == CAMPAIGN_REVERSE ? 1.0 - u : u, v);
                campaign_compare(r, 3 * k, T.x, ldexp(S.x + shift[0], power), tolerance);
                campaign_compare(r, 3 * k + 1, T.y, ldexp(S.y + shift[1], power), tolerance);
                campaign_compare(r, 3 * k + 2, T.z, ldexp(S.z + shift[2], power), tolerance);
            }
            et_surface_free(&b);
        }
        et_surface_free(&a);
    }
    et_request_free(&q);
}

/* ---- seam, nearest point, net ---- */

/* Two surfaces of the same knots, control points and weights on the border: the gap is 0. */
void campaign_relate_seam(campaign_relation *r)
{
    static const et_category shells[] = {ET_CATEGORY_SEAM};
    et_reply gap;
    size_t n;
    if (!campaign_base(r, ET_OP_SEAM_GAP, shells, 1)) {
        return;
    }
    const size_t nx = controls(r->told, 0), ny = controls(r->told, 1);
    const et_request_value *P = &r->told->arg[4];
    et_request_value *Q = &r->told->arg[10];
    for (size_t i = 0; i < P->count; i++) {
        if (i / ny == 0 || i / ny + 1 == nx || i % ny == 0 || i % ny + 1 == ny) {
            memcpy(Q->x + 3 * i, P->x + 3 * i, 3 * sizeof *P->x);
        }
    }
    double *bound = campaign_bounds(r, &n, r->told);
    if (bound && campaign_asked(r, &gap, r->told, n)) {
        campaign_compare(r, 0, gap.x[0], 0.0, bound[0]);
        et_reply_free(&gap);
    }
    free(bound);
}

static et_vec3 point_of_curve(campaign_relation *r, const et_curve *c, double x)
{
    et_vec3 C = {0.0, 0.0, 0.0};
    const size_t room = et_curve_work(c, 0);
    double *work = et_size_array(room, sizeof *work);
    if (work) {
        C = et_curve_point(c, x, work, room);
    }
    campaign_fail(r, work ? ET_OK : ET_ENOMEM);
    free(work);
    return C;
}

/* A point of the curve or surface of the request, which is valid, at x: evaluated here, with an error far below what a nearest point may be off. */
static void on_it(campaign_relation *r, double P[3], double x, double y)
{
    et_vec3 S;
    if (r->told->op == ET_OP_SURFACE_NEAREST) {
        const et_surface s = judge_surface_of(r->told, 0);
        S = point(r, &s, x, y);
    } else {
        const et_curve c = judge_curve_of(r->told);
        S = point_of_curve(r, &c, x);
    }
    P[0] = S.x;
    P[1] = S.y;
    P[2] = S.z;
}

void campaign_relate_nearest(campaign_relation *r, et_request_op op)
{
    static const et_category usual[] = {ET_CATEGORY_PLAIN, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_SEAM};
    const campaign_layout *l = campaign_layout_of(op);
    double x[2] = {0.0, 0.0}, P[3];
    et_reply found;
    if (!campaign_base(r, op, usual, 3)) {
        return;
    }
    for (size_t k = 0; k < l->axes; k++) {
        const et_request_value *u = &r->told->arg[l->axis[k].knots];
        const double lo = u->x[0], hi = u->x[u->count - 1];
        x[k] = campaign_clamp(lo, lo + (hi - lo) * et_rng_uniform(r->rng), hi);
    }
    on_it(r, P, x[0], x[1]);
    campaign_fail(r, et_request_set(r->told, (size_t)l->data, 1, P));
    const double size = campaign_size(r->told, l->net[0]), tolerance = 2.0 * sqrt(ET_UNIT) * size;
    if (campaign_asked(r, &found, r->told, l->axes + 1)) {
        double Q[3];
        campaign_compare(r, l->axes, found.x[l->axes], 0.0, tolerance);
        on_it(r, Q, found.x[0], found.x[1]);
        for (size_t c = 0; c < 3; c++) {
            campaign_compare(r, c, Q[c], P[c], 2.0 * tolerance);
        }
        et_reply_free(&found);
    }
}

/* node -> class -> node. */
void campaign_relate_net(campaign_relation *r)
{
    static const et_category sizes[] = {ET_CATEGORY_PLAIN, ET_CATEGORY_END_OF_DOMAIN, ET_CATEGORY_SEAM, ET_CATEGORY_SIZE};
    et_request q = {ET_OPS, {{0, NULL}}};                 /* that it may be freed when it could not be made */
    et_reply node, class;
    if (!campaign_base(r, ET_OP_NET_NODE, sizes, 4)) {
        return;
    }
    campaign_fail(r, et_request_new(&q, ET_OP_NET_CLASS));
    const size_t nx = r->told->arg[0].count, ny = r->told->arg[1].count;
    if (campaign_asked(r, &node, r->told, 3)) {
        const double *v = node.x;
        if (!(v[0] >= 0.0 && v[0] <= 1.0 && v[1] >= 0.0 && v[1] < (double)nx && v[2] >= 0.0 && v[2] < (double)ny)) {
            campaign_decide(r, ET_VERDICT_WRONG, "the node is not in the net");
        } else {
            const size_t value[5] = {nx, ny, (size_t)v[0], (size_t)v[1], (size_t)v[2]};
            for (size_t k = 0; k < 5; k++) {
                campaign_fail(r, et_request_set(&q, k, value[k], NULL));
            }
        }
        if (campaign_asked(r, &class, &q, 1)) {
            campaign_compare(r, 0, class.x[0], (double)r->told->arg[2].count, 0.0);
            et_reply_free(&class);
        }
        et_reply_free(&node);
    }
    et_request_free(&q);
}
