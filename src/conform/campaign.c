#include "etalon/conform/campaign.h"
#include "conform/campaign_parts.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

static const char *const names[ET_CATEGORIES + 1] = {
    "plain", "end_of_domain", "near_knots", "repeated_knots", "editing", "degenerate", "fit_failure", "seam", "inversion", "size", "extreme_scale",
    "weights", "degrees", "bad_input", NULL};

const char *et_campaign_name(et_category category)
{
    return (unsigned)category < ET_CATEGORIES ? names[category] : NULL;
}

/* ---- which categories an operation has ---- */

enum {
    PLAIN = 1 << ET_CATEGORY_PLAIN, ENDS = 1 << ET_CATEGORY_END_OF_DOMAIN, NEAR = 1 << ET_CATEGORY_NEAR_KNOTS,
    REPEATED = 1 << ET_CATEGORY_REPEATED_KNOTS, EDITING = 1 << ET_CATEGORY_EDITING, DEGENERATE = 1 << ET_CATEGORY_DEGENERATE,
    FAILURE = 1 << ET_CATEGORY_FIT_FAILURE, SEAM = 1 << ET_CATEGORY_SEAM, INVERSION = 1 << ET_CATEGORY_INVERSION, SIZE = 1 << ET_CATEGORY_SIZE,
    EXTREME = 1 << ET_CATEGORY_EXTREME_SCALE, WEIGHTS = 1 << ET_CATEGORY_WEIGHTS,
    DEGREES = 1 << ET_CATEGORY_DEGREES, BAD = 1 << ET_CATEGORY_BAD_INPUT,
    ALL = PLAIN | SIZE | BAD,
    BASIS = ALL | NEAR | REPEATED | EXTREME,
    SPLINE = BASIS | ENDS | DEGENERATE | SEAM | WEIGHTS | DEGREES,
    EDIT = ALL | REPEATED | EDITING | DEGENERATE | EXTREME | WEIGHTS | DEGREES,
    INSERT = EDIT | ENDS | NEAR,
    FIT = BASIS | ENDS | DEGENERATE | FAILURE | DEGREES,
    LINES = ALL | DEGENERATE | SEAM | EXTREME,
    NEAREST = ALL | REPEATED | DEGENERATE | SEAM | INVERSION | EXTREME | WEIGHTS | DEGREES
};

static const int has[ET_OPS] = {
    BASIS | ENDS | DEGREES, BASIS | ENDS, BASIS | DEGREES, BASIS | ENDS | DEGREES, BASIS | ENDS | DEGREES,
    SPLINE, SPLINE, SPLINE, SPLINE, SPLINE,
    INSERT, EDIT, EDIT, INSERT, EDIT, EDIT,
    LINES, LINES, ALL | REPEATED | EXTREME | DEGREES, FIT, FIT | SEAM, FIT, LINES | DEGREES,
    NEAREST, NEAREST, SPLINE, ALL, ALL | ENDS | SEAM, ALL | ENDS | SEAM, ALL | REPEATED | DEGENERATE | SEAM | EXTREME | WEIGHTS | DEGREES};

int et_campaign_has(et_request_op op, et_category category)
{
    return (unsigned)op < ET_OPS && (unsigned)category < ET_CATEGORIES && (has[op] >> category & 1);
}

/* ---- where an operation has what ---- */

static const campaign_layout layouts[ET_OPS] = {
    {1, {{0, 1, 2, -1, -1}}, {-1, -1}, -1, 0, -1, -1, -1, -1, -1},
    {1, {{-1, 0, 1, -1, -1}}, {-1, -1}, -1, 0, -1, -1, -1, -1, -1},
    {1, {{0, 1, -1, -1, -1}}, {-1, -1}, -1, 0, -1, -1, -1, -1, -1},
    {1, {{0, 1, 2, -1, 3}}, {-1, -1}, -1, 0, -1, -1, -1, -1, -1},
    {1, {{0, 1, 2, -1, 3}}, {-1, -1}, -1, 0, 4, -1, -1, -1, -1},
    {1, {{0, 1, 4, -1, 5}}, {2, -1}, -1, 0, -1, -1, -1, -1, -1},
    {1, {{0, 1, 4, -1, 5}}, {2, -1}, -1, 0, 6, -1, -1, -1, -1},
    {2, {{0, 2, 6, -1, 8}, {1, 3, 7, -1, 9}}, {4, -1}, -1, 0, -1, -1, -1, -1, -1},
    {2, {{0, 2, 6, -1, 8}, {1, 3, 7, -1, 9}}, {4, -1}, -1, 0, 10, -1, -1, -1, -1},
    {2, {{0, 2, 6, -1, -1}, {1, 3, 7, -1, -1}}, {4, -1}, -1, 0, -1, -1, -1, -1, -1},
    {1, {{0, 1, 4, -1, -1}}, {2, -1}, -1, 0, -1, -1, -1, 5, -1},
    {1, {{0, 1, 4, -1, -1}}, {2, -1}, -1, 0, -1, -1, -1, 5, 6},
    {1, {{0, 1, -1, -1, -1}}, {2, -1}, -1, 0, -1, -1, -1, 4, -1},
    {2, {{0, 2, -1, -1, -1}, {1, 3, -1, -1, -1}}, {4, -1}, -1, 0, -1, 6, 7, 8, -1},
    {2, {{0, 2, -1, -1, -1}, {1, 3, -1, -1, -1}}, {4, -1}, -1, 0, -1, 6, 7, 8, 9},
    {2, {{0, 2, -1, -1, -1}, {1, 3, -1, -1, -1}}, {4, -1}, -1, 0, -1, 6, -1, 7, -1},
    {0, {{-1, -1, -1, -1, -1}}, {-1, -1}, 1, 0, -1, -1, -1, -1, -1},
    {0, {{-1, -1, -1, -1, -1}}, {-1, -1}, 3, 1, -1, -1, -1, -1, -1},
    {0, {{1, -1, -1, 3, -1}}, {-1, -1}, -1, 0, -1, -1, -1, -1, -1},
    {1, {{0, 1, -1, 2, -1}}, {-1, -1}, 3, 0, -1, -1, -1, -1, -1},
    {2, {{1, 3, -1, 5, -1}, {2, 4, -1, 6, -1}}, {-1, -1}, 7, 1, -1, -1, -1, -1, -1},
    {2, {{0, 2, -1, 4, -1}, {1, 3, -1, 5, -1}}, {-1, -1}, 6, 0, -1, -1, -1, -1, -1},
    {0, {{-1, -1, -1, -1, -1}}, {-1, -1}, 6, 1, -1, -1, -1, -1, -1},
    {1, {{0, 1, -1, -1, -1}}, {2, -1}, 4, 0, -1, -1, -1, -1, -1},
    {2, {{0, 2, -1, -1, -1}, {1, 3, -1, -1, -1}}, {4, -1}, 6, 0, -1, -1, -1, -1, -1},
    {2, {{0, 2, -1, 6, -1}, {1, 3, -1, 7, -1}}, {4, -1}, 8, 1, -1, -1, -1, -1, -1},
    {0, {{-1, -1, -1, -1, -1}}, {-1, -1}, -1, 0, -1, -1, -1, -1, -1},
    {0, {{-1, -1, -1, -1, -1}}, {-1, -1}, -1, 0, -1, -1, -1, -1, -1},
    {0, {{-1, -1, -1, -1, -1}}, {-1, -1}, -1, 0, -1, -1, -1, -1, -1},
    {4, {{0, 2, -1, -1, -1}, {1, 3, -1, -1, -1}, {6, 8, -1, -1, -1}, {7, 9, -1, -1, -1}}, {4, 10}, -1, 0, -1, -1, -1, -1, -1}};

const campaign_layout *campaign_layout_of(et_request_op op)
{
    return &layouts[op];
}

int campaign_at(const et_request *request, size_t axis)
{
    const campaign_layout *l = &layouts[request->op];
    return l->along >= 0 ? (request->arg[l->along].count == axis ? l->at : -1) : l->axis[axis].at;
}

size_t campaign_arguments(et_request_op op)
{
    size_t n = 0;
    while (et_request_argument(op, n)) {
        n++;
    }
    return n;
}

/* ---- what hello offers ---- */

static int apart(double a, double b, double tolerance)
{
    return a == b || !(fabs(a - b) <= tolerance);
}

/* No two different knots, and no parameter and a knot, within the tolerance. */
static int axis_apart(const et_request *q, size_t axis, double part)
{
    const campaign_axis *a = &layouts[q->op].axis[axis];
    const et_request_value *u = &q->arg[a->knots];
    const size_t p = a->degree >= 0 ? q->arg[a->degree].count : 0;
    const int at = campaign_at(q, axis);
    if (u->count < 2 || p >= u->count / 2) {
        return 1;
    }
    const double tolerance = part * (u->x[u->count - 1 - p] - u->x[p]);
    int ok = 1;
    for (size_t i = 0; i < u->count; i++) {
        ok = ok && (i == 0 || apart(u->x[i], u->x[i - 1], tolerance)) && (at < 0 || apart(q->arg[at].x[0], u->x[i], tolerance));
    }
    for (size_t k = 0; a->sites >= 0 && k < q->arg[a->sites].count; k++) {
        for (size_t i = 0; i < u->count; i++) {
            ok = ok && apart(q->arg[a->sites].x[k], u->x[i], tolerance);
        }
    }
    return ok;
}

static int side_offered(size_t word, const et_hello *hello)
{
    return word == 0 ? hello->any : word == 1 ? hello->right : hello->left;
}

int campaign_offered(const et_request *q, const et_hello *hello)
{
    const campaign_layout *l = &layouts[q->op];
    int ok = hello->op[q->op] != 0 && (l->order < 0 || q->arg[l->order].count <= hello->order);
    for (size_t k = 0; k < l->axes; k++) {
        const campaign_axis *a = &l->axis[k];
        ok = ok && (a->degree < 0 || q->arg[a->degree].count <= hello->degree) && (a->side < 0 || side_offered(q->arg[a->side].count, hello));
        ok = ok && (!(hello->knot_tolerance > 0.0) || axis_apart(q, k, hello->knot_tolerance));
    }
    for (size_t k = 0; k < 2; k++) {
        ok = ok && (l->net[k] < 0 || hello->rational || q->arg[l->net[k] + 1].count == 0);
    }
    if (q->op == ET_OP_KNOTS) {
        ok = ok && q->arg[1].count <= hello->degree;
    }
    if (q->op == ET_OP_APPROXIMATE) {
        ok = ok && q->arg[0].count <= hello->degree && q->arg[1].count <= hello->degree;
    }
    if (q->op == ET_OP_CURVE_ELEVATE || q->op == ET_OP_SURFACE_ELEVATE) {
        const size_t p = q->arg[l->along >= 0 && q->arg[l->along].count == 1 ? 1 : 0].count, r = q->arg[l->times].count;
        ok = ok && r <= hello->degree - p;                 /* p is the degree of an axis, seen above */
    }
    return ok;
}

/* ---- drawing ---- */

size_t campaign_pick(campaign_maker *m, size_t n)
{
    return et_rng_index(m->rng, n);
}

size_t campaign_kind(const campaign_maker *m, size_t n)
{
    return (size_t)(m->number % n);
}

double campaign_real(campaign_maker *m, double lo, double hi)
{
    const double high = et_rng_uniform(m->rng), low = et_rng_uniform(m->rng);
    return lo + (hi - lo) * (high + 0x1p-32 * low);
}

double campaign_clamp(double lo, double x, double hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

double *campaign_array(campaign_maker *m, size_t n)
{
    if (n > m->size - m->used) {
        /* By the sizes drawn this does not happen; what is drawn goes to waste. */
        m->status = ET_ENOMEM;
        m->used = 0;
    }
    double *x = m->room + m->used;
    m->used += n <= m->size - m->used ? n : 0;
    return x;
}

static void keep(campaign_maker *m, et_status status)
{
    m->status = m->status == ET_OK ? status : m->status;
}

void campaign_count(campaign_maker *m, int k, size_t count)
{
    keep(m, et_request_set(m->request, (size_t)k, count, NULL));
}

void campaign_list(campaign_maker *m, int k, const double *x, size_t n)
{
    keep(m, et_request_set(m->request, (size_t)k, n, x));
}

void campaign_number(campaign_maker *m, int k, double x)
{
    keep(m, et_request_set(m->request, (size_t)k, 1, &x));
}

static void family(campaign_maker *m)
{
    static void (*const draw[ET_OPS])(campaign_maker *) = {
        campaign_draw_basis, campaign_draw_basis, campaign_draw_basis, campaign_draw_basis, campaign_draw_basis,
        campaign_draw_spline, campaign_draw_spline, campaign_draw_spline, campaign_draw_spline, campaign_draw_spline,
        campaign_draw_edit, campaign_draw_edit, campaign_draw_edit, campaign_draw_edit, campaign_draw_edit, campaign_draw_edit,
        campaign_draw_parameters, campaign_draw_parameters, campaign_draw_knots, campaign_draw_fit, campaign_draw_fit, campaign_draw_fit,
        campaign_draw_approximate, campaign_draw_nearest, campaign_draw_nearest, campaign_draw_error,
        campaign_draw_net, campaign_draw_net, campaign_draw_net, campaign_draw_seam};
    draw[m->op](m);
}

/* What an operation asks of its knots; `attempt` 0 .. 15. */
static et_status attempt_draw(campaign_maker *m, et_category category, uint64_t seed, uint64_t attempt)
{
    et_rng *rng;
    const uint64_t stream = et_rng_stream(et_rng_stream(et_rng_stream(seed, (uint64_t)m->op), (uint64_t)category), m->number);
    if (et_rng_new(&rng, et_rng_stream(stream, attempt)) != ET_OK) {
        return ET_ENOMEM;
    }
    const int bad = category == ET_CATEGORY_BAD_INPUT;
    m->rng = rng;
    m->used = 0;
    m->status = ET_OK;
    m->category = bad ? ET_CATEGORY_PLAIN : category;
    m->rational = m->hello->rational && (campaign_pick(m, 2) || category == ET_CATEGORY_WEIGHTS);
    m->unit = m->op == ET_OP_SEAM_GAP;
    m->smooth = m->layout->data >= 0 || m->op == ET_OP_SEAM_GAP;
    m->exact = m->layout->tolerance >= 0 || category == ET_CATEGORY_EDITING;
    m->e_points = m->e_knots = 0;
    m->o_points = m->o_knots = 0.0;
    if (category == ET_CATEGORY_EXTREME_SCALE) {
        campaign_scales(m);
    }
    family(m);
    if (bad && m->status == ET_OK) {
        campaign_spoil(m);
    }
    et_rng_free(rng);
    return m->status;
}

/* What is left by hello at all. */
static int leaves(et_request_op op, et_category category, const et_hello *hello)
{
    const campaign_layout *l = &layouts[op];
    const int side = l->axes > 0 && l->axis[0].side >= 0;
    const int elevate = op == ET_OP_CURVE_ELEVATE || op == ET_OP_SURFACE_ELEVATE;
    const int zero = op == ET_OP_SPAN || op == ET_OP_BASIS || op == ET_OP_CURVE_POINT || op == ET_OP_SURFACE_POINT || op == ET_OP_MULTIPLICITY ||
                     op == ET_OP_NET_COUNTS || op == ET_OP_NET_CLASS || op == ET_OP_NET_NODE || op == ET_OP_PARAMETERS || op == ET_OP_PARAMETERS_GRID;
    return et_campaign_has(op, category) && hello->op[op] && (hello->rational || category != ET_CATEGORY_WEIGHTS) &&
           (!side || hello->any || hello->left || hello->right) && (zero || hello->degree >= (elevate ? 2u : 1u));
}

et_status et_campaign_draw(et_request *request, et_request_op op, et_category category, uint64_t seed, uint64_t number, const et_hello *hello)
{
    /* Enough for two surfaces of 40 x 40 with weights, for a curve of 3000, and for what is made on the way. */
    enum { ROOM = 1 << 16, LITTLE = 1 << 13, ATTEMPTS = 16 };
    if ((unsigned)op >= ET_OPS || !leaves(op, category, hello)) {
        return ET_EINVAL;
    }
    campaign_maker m = {0};
    et_request made;
    m.size = category == ET_CATEGORY_SIZE || category == ET_CATEGORY_DEGREES ? ROOM : LITTLE;
    m.room = et_size_array(m.size, sizeof *m.room);
    m.hello = hello;
    m.layout = &layouts[op];
    m.op = op;
    m.number = number;
    m.request = &made;
    et_status status = m.room ? ET_EINVAL : ET_ENOMEM;
    for (uint64_t k = 0; k < 2 * ATTEMPTS && status == ET_EINVAL; k++) {
        status = et_request_new(&made, op);
        if (status == ET_OK) {
            /* Where the tolerance of knots leaves nothing of the category, a plain one comes instead; of bad input the first is taken. */
            status = attempt_draw(&m, k < ATTEMPTS ? category : ET_CATEGORY_PLAIN, seed, k);
            status = status == ET_OK && category != ET_CATEGORY_BAD_INPUT && !campaign_offered(&made, hello) ? ET_EINVAL : status;
            if (status != ET_OK) {
                et_request_free(&made);
            }
        }
    }
    free(m.room);
    if (status == ET_OK) {
        *request = made;
    }
    return status;
}
