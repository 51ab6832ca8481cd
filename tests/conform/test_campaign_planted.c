/* conform/campaign: do its cases find faults?  Wrappers around the right answers are each wrong in one place. */
#include "etalon/conform/answer.h"
#include "etalon/conform/campaign.h"
#include "gen.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where knots, degree, parameter, control points and side of a request are; enough for the faults below. */
typedef struct { size_t p; const double *u; size_t nu; double x; } direction;

static direction direction_of(const et_request *q, size_t degree, size_t knots, size_t at)
{
    return (direction){q->arg[degree].count, q->arg[knots].x, q->arg[knots].count, q->arg[at].x[0]};
}

static size_t times(const double *u, size_t nu, double x)
{
    size_t n = 0;
    for (size_t i = 0; i < nu; i++) {
        n += u[i] == x;
    }
    return n;
}

static int at_end(direction d)
{
    return d.x == d.u[d.nu - 1 - d.p];
}

/* Answers a changed copy of the request. */
static et_status changed(et_reply *reply, const et_request *q, void (*change)(et_request *q))
{
    et_request c;
    et_status status = et_request_copy(&c, q);
    if (status == ET_OK) {
        change(&c);
        status = et_answer_fast(reply, &c);
        et_request_free(&c);
    }
    return status;
}

static void no_weights_of_curve(et_request *q)
{
    (void)et_request_set(q, 3, 0, NULL);
}

static void no_weights_of_surface(et_request *q)
{
    (void)et_request_set(q, 5, 0, NULL);
}

static void no_weights_of_second(et_request *q)
{
    (void)et_request_set(q, 5, 0, NULL);
    (void)et_request_set(q, 11, 0, NULL);
}

static void from_the_right(et_request *q)
{
    q->arg[5].count = 1;
}

static void surface_from_the_right(et_request *q)
{
    q->arg[8].count = q->arg[9].count = 1;
}

static void once(et_request *q)
{
    q->arg[q->op == ET_OP_CURVE_ELEVATE ? 4 : 5].count = 1;
}

static void along_u(et_request *q)
{
    q->arg[6].count = 0;
}

static void chord(et_request *q)
{
    q->arg[0].count = 1;
}

static void free_corners(et_request *q)
{
    q->arg[0].count = 0;
}

static void last_data_moved(et_request *q)
{
    et_request_value *P = &q->arg[q->op == ET_OP_FIT_CURVE ? 3 : q->op == ET_OP_FIT_GRID ? 7 : q->op == ET_OP_SURFACE_ERROR ? 8 : 6];
    P->x[3 * P->count - 1] *= 1.0 + 0x1p-10;
}

static void nothing_outside(et_request *q)
{
    const direction d = direction_of(q, 0, 1, 4);
    if (!isnan(d.x) && d.nu > 2 * d.p + 1) {
        q->arg[4].x[0] = d.u[0] <= d.x && d.x <= d.u[d.nu - 1] ? d.x : 0.4 * d.u[0] + 0.6 * d.u[d.nu - 1];
    }
}

static void finite_knots(et_request *q)
{
    for (size_t i = 0; i < q->arg[1].count; i++) {
        double *u = q->arg[1].x;
        u[i] = i > 0 && (isnan(u[i]) || u[i] < u[i - 1]) ? u[i - 1] : u[i];
    }
}

static void good_weights(et_request *q)
{
    for (size_t i = 0; i < q->arg[3].count; i++) {
        q->arg[3].x[i] = fabs(q->arg[3].x[i]);
    }
}

static void near_is_equal(et_request *q)
{
    double *u = q->arg[1].x;
    for (size_t i = 1; i < q->arg[1].count; i++) {
        u[i] = fabs(u[i] - u[i - 1]) < 1e-9 ? u[i - 1] : u[i];
    }
}

static void snapped_to_the_end(et_request *q)
{
    const direction d = direction_of(q, 0, 1, 4);
    if (d.nu > 2 * d.p + 1 && fabs(d.x - d.u[d.nu - 1 - d.p]) < 1e-9) {
        q->arg[4].x[0] = d.u[d.nu - 1 - d.p];
    }
}

static void single_weights(et_request *q)
{
    for (size_t i = 0; i < q->arg[3].count; i++) {
        q->arg[3].x[i] = (double)(float)q->arg[3].x[i];
    }
}

static void scale_row(et_reply *r, size_t from, size_t n, double factor)
{
    for (size_t i = from; i < from + n && i < r->count; i++) {
        r->x[i] *= factor;
    }
}

static void swap_rows(et_reply *r, size_t a, size_t b)
{
    for (size_t i = 0; i < 3 && 3 * a + i < r->count && 3 * b + i < r->count; i++) {
        const double x = r->x[3 * a + i];
        r->x[3 * a + i] = r->x[3 * b + i];
        r->x[3 * b + i] = x;
    }
}

typedef enum {
    SECOND_DERIVATIVE, THIRD_DERIVATIVE, DERIVATIVE_WEIGHTS, SURFACE_WEIGHTS, RIGHT_END, SPAN_END, SIDE_IGNORED, SURFACE_SIDE, UV_SWAPPED, MIXED_SIGN,
    NORMAL_SIGN, BASIS_HIGH, GREVILLE_ONE, NEAR_EQUAL, SNAPPED, MINUS_ZERO, INSERT_REPEATED, INSERT_ONCE, ALONG_IGNORED, ELEVATE_ONCE,
    ELEVATE_WEIGHTS,
    REMOVE_ONCE, REMOVE_NONE, CENTRIPETAL, EXPONENTIAL, NO_LENGTH, KNOT_RULE, FIT_LAST, GRID_LAST, GRID_CORNERS, SCATTERED_LAST, RANK, ERROR_LAST,
    CLASS_TOP, NODE_TOP, SEAM_WEIGHTS, SEAM_ZERO, COUNTS_32, MANY_POINTS, HIGH_DEGREE, SINGLE, OUTSIDE, NAN_KNOT, NEGATIVE_WEIGHT, BIG,
    APPROXIMATE_SHORT,
    FAULTS
} fault;

static const et_request_op where[FAULTS] = {
    ET_OP_CURVE_DERS, ET_OP_CURVE_DERS, ET_OP_CURVE_DERS, ET_OP_SURFACE_DERS, ET_OP_CURVE_POINT, ET_OP_SPAN, ET_OP_CURVE_DERS, ET_OP_SURFACE_DERS,
    ET_OP_SURFACE_DERS, ET_OP_SURFACE_DERS, ET_OP_SURFACE_NORMAL, ET_OP_BASIS, ET_OP_GREVILLE, ET_OP_CURVE_POINT, ET_OP_CURVE_POINT,
    ET_OP_MULTIPLICITY,
    ET_OP_CURVE_INSERT, ET_OP_CURVE_INSERT, ET_OP_SURFACE_INSERT, ET_OP_CURVE_ELEVATE, ET_OP_CURVE_ELEVATE, ET_OP_CURVE_REMOVE, ET_OP_SURFACE_REMOVE,
    ET_OP_PARAMETERS, ET_OP_PARAMETERS_GRID, ET_OP_PARAMETERS, ET_OP_KNOTS, ET_OP_FIT_CURVE, ET_OP_FIT_GRID, ET_OP_FIT_GRID, ET_OP_FIT_SCATTERED,
    ET_OP_FIT_SCATTERED, ET_OP_SURFACE_ERROR, ET_OP_NET_CLASS, ET_OP_NET_NODE, ET_OP_SEAM_GAP, ET_OP_SEAM_GAP, ET_OP_NET_COUNTS, ET_OP_CURVE_POINT,
    ET_OP_CURVE_POINT, ET_OP_CURVE_POINT, ET_OP_CURVE_INSERT, ET_OP_CURVE_POINT, ET_OP_CURVE_DERS, ET_OP_CURVE_POINT, ET_OP_APPROXIMATE};

static const char *const told[FAULTS] = {
    "second derivative p/(p+1) of what it is", "third derivative's sign", "weights forgotten in derivatives",
    "weights forgotten in surface derivatives",
    "the right end gives 0", "span at the right end one too many", "the side is ignored", "a surface's sides are ignored", "S_u and S_v swapped",
    "S_uv has the wrong sign", "the normal points inward where p > q", "basis from degree 5 on slightly off", "Greville points of degree 1 shifted",
    "knots 1e-9 apart are equal", "parameters near the end snap to it", "-0 is not 0", "insertion at a knot that is there already moves a point",
    "only one knot is inserted", "surfaces are refined along u only", "degree elevated by one only", "weights forgotten when elevating",
    "never more than one knot removed", "no knot removed from surfaces", "centripetal is chord", "exponential is chord",
    "points of no length give NaN",
    "a knot rule is off by one parameter", "the last datum is moved", "a grid's last datum is moved", "corners are never interpolated",
    "the last scattered datum is moved", "rank deficient fits are answered", "the error's last datum is moved",
    "classes of the top view one too great",
    "nodes of the top view swapped", "the gap forgets weights", "the gap of shells is always 0", "counts in 32 bits", "more than 256 control points",
    "degrees above 9", "weights in single precision", "insertion outside is answered", "NaN among knots is answered", "negative weights are answered",
    "coordinates beyond 1e300 overflow", "the approximation has a control point too few"};

static void spoil_points(fault f, et_reply *r, const et_request *q)
{
    const size_t p = q->arg[0].count;
    switch (f) {
    case SECOND_DERIVATIVE: scale_row(r, 6, 3, (double)p / (double)(p + 1)); break;
    case THIRD_DERIVATIVE: scale_row(r, 9, 3, -1.0); break;
    case RIGHT_END: scale_row(r, 0, 3, at_end(direction_of(q, 0, 1, 4)) ? 0.0 : 1.0); break;
    case SPAN_END: r->x[0] += at_end(direction_of(q, 0, 1, 2)) ? 1.0 : 0.0; break;
    case UV_SWAPPED: swap_rows(r, 1, 2); break;
    case MIXED_SIGN: scale_row(r, 12, 3, -1.0); break;
    case NORMAL_SIGN: scale_row(r, 0, 3, p > q->arg[1].count ? -1.0 : 1.0); break;
    case BASIS_HIGH: scale_row(r, 0, r->count, p >= 5 ? 1.0 + 0x1p-40 : 1.0); break;
    case GREVILLE_ONE: scale_row(r, 0, r->count, p == 1 ? 0.5 : 1.0); break;
    case MANY_POINTS: scale_row(r, 0, 1, q->arg[2].count > 256 ? 2.0 : 1.0); break;
    case HIGH_DEGREE: scale_row(r, 0, 1, p > 9 ? 2.0 : 1.0); break;
    case BIG:
        for (size_t i = 0; i < 3; i++) {
            r->x[i] = fabs(r->x[i]) > 1e300 ? r->x[i] * HUGE_VAL : r->x[i];
        }
        break;
    default: break;
    }
}

static void spoil_others(fault f, et_reply *r, const et_request *q)
{
    switch (f) {
    case MINUS_ZERO:
        for (size_t i = 0; i < q->arg[0].count; i++) {
            r->x[0] -= q->arg[0].x[i] == 0.0 && q->arg[1].x[0] == 0.0 && signbit(q->arg[0].x[i]) != signbit(q->arg[1].x[0]);
        }
        break;
    case INSERT_REPEATED:
        if (times(q->arg[1].x, q->arg[1].count, q->arg[4].x[0]) > 0 && q->arg[5].count > 0) {
            r->x[r->count - 2] += 1.0;
            r->x[r->count - 2 - (q->arg[3].count > 0 ? (size_t)r->x[1] / 2 : 0)] += 1.0;
        }
        break;
    case REMOVE_ONCE: case REMOVE_NONE: break;
    case NO_LENGTH: {
        int equal = 1;
        for (size_t i = 3; i < 3 * q->arg[1].count; i++) {
            equal = equal && q->arg[1].x[i] == q->arg[1].x[i - 3];
        }
        scale_row(r, 0, r->count, equal ? (double)NAN : 1.0);
        break;
    }
    case KNOT_RULE:
        if (q->arg[0].count == 0 && q->arg[2].count > q->arg[1].count + 2) {
            r->x[q->arg[1].count + 1] = r->x[q->arg[1].count + 2];
        }
        break;
    case CLASS_TOP: r->x[0] += r->x[0] > (double)(q->arg[0].count * q->arg[1].count); break;
    case NODE_TOP: r->x[0] = r->x[0] == 1.0 && r->x[1] != r->x[2] ? 0.0 : r->x[0]; break;
    case SEAM_ZERO: r->x[0] = 0.0; break;
    case COUNTS_32: r->x[0] = fmod(r->x[0], 0x1p32); break;
    case APPROXIMATE_SHORT: r->count -= r->count > 0; break;
    default: break;
    }
}

/* What is asked in a wrong way. */
static et_status ask_wrongly(fault f, et_reply *reply, const et_request *q)
{
    switch (f) {
    case DERIVATIVE_WEIGHTS: return q->arg[6].count > 0 ? changed(reply, q, no_weights_of_curve) : et_answer_fast(reply, q);
    case SURFACE_WEIGHTS: return q->arg[10].count > 0 ? changed(reply, q, no_weights_of_surface) : et_answer_fast(reply, q);
    case SIDE_IGNORED: return changed(reply, q, from_the_right);
    case SURFACE_SIDE: return changed(reply, q, surface_from_the_right);
    case NEAR_EQUAL: return changed(reply, q, near_is_equal);
    case SNAPPED: return changed(reply, q, snapped_to_the_end);
    case INSERT_ONCE: case ELEVATE_ONCE: case REMOVE_ONCE: return changed(reply, q, once);
    case ALONG_IGNORED: return changed(reply, q, along_u);
    case ELEVATE_WEIGHTS: return changed(reply, q, no_weights_of_curve);
    case CENTRIPETAL: return q->arg[0].count == 2 ? changed(reply, q, chord) : et_answer_fast(reply, q);
    case EXPONENTIAL: return q->arg[0].count == 3 ? changed(reply, q, chord) : et_answer_fast(reply, q);
    case FIT_LAST: case GRID_LAST: case SCATTERED_LAST: case ERROR_LAST: return changed(reply, q, last_data_moved);
    case GRID_CORNERS: return changed(reply, q, free_corners);
    case SEAM_WEIGHTS: return changed(reply, q, no_weights_of_second);
    case SINGLE: return changed(reply, q, single_weights);
    case OUTSIDE: return changed(reply, q, nothing_outside);
    case NAN_KNOT: return changed(reply, q, finite_knots);
    case NEGATIVE_WEIGHT: return changed(reply, q, good_weights);
    default: return et_answer_fast(reply, q);
    }
}

static et_status ask(void *context, et_reply *reply, const et_request *q)
{
    const fault f = *(const fault *)context;
    if (f >= FAULTS || q->op != where[f]) {
        return et_answer_fast(reply, q);
    }
    et_status status = ask_wrongly(f, reply, q);
    if (status == ET_OK && f == RANK && reply->kind == ET_REPLY_REFUSED && strstr(reply->reason, "rank")) {
        const size_t n = (q->arg[2].count - q->arg[0].count - 1) * (q->arg[3].count - q->arg[1].count - 1);
        et_reply_free(reply);
        memset(reply, 0, sizeof *reply);
        for (size_t i = 0; i < 3 * n && status == ET_OK; i++) {
            status = et_reply_put(reply, &(double){1.0}, 1);
        }
    }
    if (status == ET_OK && reply->kind == ET_REPLY_OK && reply->count > 0) {
        spoil_points(f, reply, q);
        spoil_others(f, reply, q);
        if (f == REMOVE_NONE && reply->x[0] > 0.0) {
            reply->x[0] = 0.0;
        }
    }
    return status;
}

/* 1 if the answer to case `number` is told as a fault. */
static int shows(fault f, et_request_op op, et_category category, uint64_t seed, uint64_t number)
{
    const et_hello hello = et_answer_hello(0);
    et_request q;
    et_truth truth;
    et_reply reply;
    et_judgement j;
    int bad = 0;
    if (et_campaign_draw(&q, op, category, seed, number, &hello) != ET_OK) {
        return 0;
    }
    memset(&reply, 0, sizeof reply);
    if (et_judge_truth(&truth, &q) == ET_OK) {
        if (ask(&f, &reply, &q) == ET_OK) {
            bad = et_judge_reply(&j, &q, &truth, &reply) == ET_OK && et_judge_bad(j.verdict);
            et_reply_free(&reply);
        }
        et_judge_free(&truth);
    }
    et_request_free(&q);
    return bad;
}

/* How many cases of each category are needed; SIZE_MAX if `most` are too few. */
static size_t needed(fault f, uint64_t seed, size_t most)
{
    for (size_t number = 0; number < most; number++) {
        for (int c = 0; c < ET_CATEGORIES; c++) {
            if (et_campaign_has(where[f], (et_category)c) && shows(f, where[f], (et_category)c, seed, number)) {
                return number + 1;
            }
        }
    }
    return SIZE_MAX;
}

/* Level 2 has some 40 cases of each operation and category. */
/* One case in 20. */
verdict prop_campaign_draw_finds(gen *g)
{
    const fault f = (fault)gen_upto(g, FAULTS - 1);
    const uint64_t seed = gen_upto(g, 1000);
    const size_t n = needed(f, seed, 40);
    char label[64];
    snprintf(label, sizeof label, "%.25s: %s", told[f], n <= 2 ? "2" : n <= 4 ? "4" : n <= 8 ? "8" : "more");
    gen_label(g, label);
    return gen_check(g, n != SIZE_MAX, "not found in 40 cases of each category, seed %llu: %s", (unsigned long long)seed, told[f]) ? PASS : FAIL;
}
