#include "etalon/conform/judge.h"
#include "conform/judge_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const verdicts[] = { "correctly_rounded", "within_bound", "inaccurate", "wrong", "non_finite", "wrongly_accepted",
                                        "wrongly_refused", "crash", "timeout", "nondeterministic", "unsupported" };
static const char *const validities[] = { "valid", "implementation_defined", "invalid" };

const char *et_judge_name(et_verdict verdict)
{
    return (size_t)verdict < ET_VERDICTS ? verdicts[verdict] : NULL;
}

const char *et_judge_validity_name(et_validity validity)
{
    return (size_t)validity <= ET_INVALID ? validities[validity] : NULL;
}

int et_judge_bad(et_verdict verdict)
{
    return verdict != ET_VERDICT_CORRECTLY_ROUNDED && verdict != ET_VERDICT_WITHIN_BOUND && verdict != ET_VERDICT_UNSUPPORTED;
}

/* ---- the wanted numbers ---- */

void judge_list_free(judge_list *list)
{
    free(list->want);
    free(list->bound);
    memset(list, 0, sizeof *list);
}

static void put(judge_list *list, double want, double bound)
{
    if (list->failed == ET_OK && list->count == list->room) {
        const size_t room = 2 * list->room + 16;
        double *w = et_size_array(room, sizeof *w), *b = et_size_array(room, sizeof *b);
        if (w && b && list->count > 0) {
            memcpy(w, list->want, list->count * sizeof *w);
            memcpy(b, list->bound, list->count * sizeof *b);
        }
        free(w && b ? list->want : w);
        free(w && b ? list->bound : b);
        if (w && b) {
            list->want = w;
            list->bound = b;
            list->room = room;
        } else {
            list->failed = ET_ENOMEM;
        }
    }
    if (list->failed == ET_OK) {
        list->want[list->count] = want;
        list->bound[list->count++] = bound;
    }
}

void judge_put(judge_list *list, double want)
{
    put(list, want, 0);
}

void judge_put_all(judge_list *list, const double *want, size_t n)
{
    for (size_t i = 0; i < n; i++)
        put(list, want[i], 0);
}

void judge_put_free(judge_list *list, double want)
{
    put(list, want, INFINITY);
}

void judge_put_bound(judge_list *list, double want, double B, double ku)
{
    const double bound = judge_bound(want, B);

    put(list, want, bound);
    if (!isfinite(bound))
        list->doubt = "a number of the answer, or what it is made of, is beyond the range of doubles";
    else if (want == 0)
        list->condition = B > 0x1p-1000 ? INFINITY : list->condition;
    else if (ku > 0)
        list->condition = fmax(list->condition, B / ku / fabs(want));
}

/* ---- validity and truth ---- */

static et_status by_group(judge_list *list, const et_request *request, int left_u, int left_v)
{
    switch (request->op) {
    case ET_OP_BASIS: case ET_OP_BASIS_DERS:
        return judge_basis(list, request, left_u);
    case ET_OP_CURVE_POINT: case ET_OP_CURVE_DERS: case ET_OP_SURFACE_POINT: case ET_OP_SURFACE_DERS:
        return judge_points(list, request, left_u, left_v);
    case ET_OP_SURFACE_NORMAL:
        return judge_normal(list, request, left_u, left_v);
    case ET_OP_CURVE_INSERT: case ET_OP_CURVE_REMOVE: case ET_OP_CURVE_ELEVATE:
    case ET_OP_SURFACE_INSERT: case ET_OP_SURFACE_REMOVE: case ET_OP_SURFACE_ELEVATE:
        return judge_edited(list, request);
    case ET_OP_PARAMETERS: case ET_OP_PARAMETERS_GRID: case ET_OP_KNOTS:
        return judge_parameters(list, request);
    case ET_OP_FIT_CURVE: case ET_OP_FIT_GRID: case ET_OP_FIT_SCATTERED:
        return judge_fitted(list, request);
    case ET_OP_CURVE_NEAREST: case ET_OP_SURFACE_NEAREST: case ET_OP_SURFACE_ERROR: case ET_OP_SEAM_GAP:
        return judge_measured(list, request);
    case ET_OP_APPROXIMATE:
        return ET_OK;
    default:
        return judge_counted(list, request);
    }
}

et_status judge_limits(judge_list *list, const et_request *request, int left_u, int left_v)
{
    memset(list, 0, sizeof *list);
    list->condition = 1;
    et_status status = by_group(list, request, left_u, left_v);
    status = status == ET_OK ? list->failed : status;
    if (status != ET_OK)
        judge_list_free(list);
    return status;
}

/* How many sides an operation has, and the argument where they begin; a normal's are any. */
static size_t sides(size_t *k, et_request_op op)
{
    switch (op) {
    case ET_OP_BASIS: case ET_OP_BASIS_DERS:
        *k = 3;
        return 1;
    case ET_OP_CURVE_POINT: case ET_OP_CURVE_DERS:
        *k = 5;
        return 1;
    case ET_OP_SURFACE_POINT: case ET_OP_SURFACE_DERS:
        *k = 8;
        return 2;
    case ET_OP_SURFACE_NORMAL:
        return 2;
    default:
        return 0;
    }
}

int judge_sides(int left[2], const et_request *request, int any_u, int any_v)
{
    const int any[2] = { any_u, any_v };
    size_t k = ET_REQUEST_ARGS;
    const size_t n = sides(&k, request->op);
    int free_sides = 0;

    left[0] = left[1] = 0;
    for (size_t i = 0; i < n; i++) {
        const size_t word = k < ET_REQUEST_ARGS ? request->arg[k + i].count : JUDGE_ANY;
        left[i] = word == JUDGE_LEFT || (word == JUDGE_ANY && any[i]);
        free_sides |= word == JUDGE_ANY ? 1 << i : 0;
    }
    return free_sides;
}

static int knot_inside(const et_request_value *u, size_t p, double x)
{
    for (size_t i = 0; i < u->count; i++)
        if (u->x[i] == x)
            return u->x[p] < x && x < u->x[u->count - p - 1];
    return 0;
}

int judge_at_knot(const et_request *request)
{
    const et_request_value *a = request->arg;

    if (request->op == ET_OP_BASIS || request->op == ET_OP_BASIS_DERS)
        return knot_inside(&a[1], a[0].count, a[2].x[0]);
    if (request->op == ET_OP_CURVE_POINT || request->op == ET_OP_CURVE_DERS)
        return knot_inside(&a[1], a[0].count, a[4].x[0]);
    return knot_inside(&a[2], a[0].count, a[6].x[0]) || knot_inside(&a[3], a[1].count, a[7].x[0]);
}

static int differ(const judge_list *a, const judge_list *b)
{
    return a->count > 0 && memcmp(a->want, b->want, a->count * sizeof *a->want) != 0;
}

/* A normal that only one of the limits has: whoever takes the other finds none, so that there is no right value. */
static void neither(judge_list *right, judge_list *left)
{
    const char *doubt = right->count == 0 ? right->doubt : left->doubt;

    judge_list_free(right);
    judge_list_free(left);
    right->doubt = doubt;
    right->condition = 1;
}

/* Both limits, if they differ. */
static et_status limits(judge_list *right, judge_list *left, const et_request *request)
{
    int side[2];
    const int any = judge_sides(side, request, 0, 0);
    et_status status = judge_limits(right, request, side[0], side[1]);

    memset(left, 0, sizeof *left);
    if (status != ET_OK || !any || !judge_at_knot(request))
        return status;
    judge_sides(side, request, 1, 1);
    status = judge_limits(left, request, side[0], side[1]);
    if (status != ET_OK)
        judge_list_free(right);
    else if (right->count != left->count)
        neither(right, left);
    else if (!differ(right, left))
        judge_list_free(left);
    return status;
}

static void set_reason(char reason[128], const char *text)
{
    snprintf(reason, 128, "%s", text);
}

/* Why a function of the exact layer has no answer to what looked valid. */
static void refuse(et_truth *truth, et_status status)
{
    truth->validity = status == ET_ERANK ? ET_INVALID : ET_IMPLEMENTATION_DEFINED;
    set_reason(truth->reason, status == ET_ERANK ? "the fit is rank deficient" : "no number within the range of doubles");
}

et_status et_judge_truth(et_truth *truth, const et_request *request)
{
    judge_case c;
    judge_list right, left;
    et_truth made = { 0 };

    judge_valid(&c, request);
    made.validity = c.validity;
    made.condition = 1;
    set_reason(made.reason, c.reason);
    if (c.known) {
        const et_status status = limits(&right, &left, request);
        if (status == ET_ENOMEM || status == ET_ENOCONV) {
            return status;
        } else if (status != ET_OK) {
            refuse(&made, status);
        } else {
            const char *doubt = right.doubt ? right.doubt : left.doubt;
            made.count = right.count;
            made.want = right.want;
            made.bound = right.bound;
            made.other = left.want;
            made.other_bound = left.bound;
            made.condition = fmax(right.condition, left.condition);
            if (doubt && made.validity == ET_VALID) {
                made.validity = ET_IMPLEMENTATION_DEFINED;
                set_reason(made.reason, doubt);
            }
        }
    }
    *truth = made;
    return ET_OK;
}

void et_judge_free(et_truth *truth)
{
    free(truth->want);
    free(truth->bound);
    free(truth->other);
    free(truth->other_bound);
    memset(truth, 0, sizeof *truth);
}

/* The rank of scattered data takes the exact solution. */
et_validity et_judge_validity(char reason[128], const et_request *request)
{
    judge_case c;
    judge_list list;

    judge_valid(&c, request);
    if (request->op == ET_OP_FIT_SCATTERED && c.known) {
        if (judge_limits(&list, request, 0, 0) == ET_ERANK) {
            c.validity = ET_INVALID;
            set_reason(c.reason, "the fit is rank deficient");
        } else {
            judge_list_free(&list);
        }
    }
    set_reason(reason, c.reason);
    return c.validity;
}
