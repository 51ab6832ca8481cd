/* campaign, knots: degrees, knot vectors and parameters as the categories want them. */
#include "conform/campaign_parts.h"
#include <math.h>
#include <string.h>

/* The kinds of extreme scales.  Results stay within doubles: a k-th derivative is multiplied by 2^(e_points - k e_knots), which the order of
 * derivatives heeds (campaign_draw_spline). */
void campaign_scales(campaign_maker *m)
{
    const int derived = m->layout->order >= 0 || m->op == ET_OP_SURFACE_NORMAL || m->layout->data >= 0 || m->rational || m->layout->times >= 0 ||
                        m->op == ET_OP_SEAM_GAP;
    switch (campaign_kind(m, 8)) {
    case 0: m->e_points = derived ? 1000 : 1019; break;            /* 1e301, 6e306 */
    case 1: m->e_points = -1020; break;                            /* 1e-307 */
    case 2: m->e_knots = 531; break;                               /* 1e160 */
    case 3: m->e_knots = -531; break;
    case 4: m->o_points = 1e9; break;
    case 5: m->o_knots = 1e9; break;
    case 6: m->e_knots = campaign_pick(m, 2) ? -1030 : -960; break;      /* 1e-310: implementation-defined; 1e-289 */
    default: m->e_points = 500; m->e_knots = -300; break;
    }
    if (m->unit || m->op == ET_OP_KNOTS) {
        m->e_knots = 0;
        m->o_knots = 0.0;
    }
    if (m->layout->data >= 0 && m->e_knots == -1030) {
        m->e_knots = -1000;
    }
}

size_t campaign_degree(campaign_maker *m, size_t axis, size_t least, size_t most)
{
    static const size_t often[] = {3, 2, 1, 3, 4, 2, 5, 3};
    const size_t limit = m->hello->degree < most ? m->hello->degree : most;
    size_t p = often[campaign_pick(m, 8)];
    if (m->category == ET_CATEGORY_DEGREES && axis == m->number % (m->layout->axes > 1 ? 2 : 1)) {
        p = (size_t)((m->number * 9 + 12) % 26);   /* 12, 21, 4, 13, 22, ...: all in 26 cases */
    } else if (m->category == ET_CATEGORY_DEGREES) {
        p = 1 + campaign_pick(m, 3);
    }
    p = p > limit ? p % (limit + 1) : p;
    return p < least ? least : p;
}

size_t campaign_spans(campaign_maker *m, size_t axis)
{
    const size_t few = m->layout->axes > 1 ? 3 : 5;
    if (m->category == ET_CATEGORY_SIZE) {
        const int fit = m->op == ET_OP_FIT_CURVE || m->op == ET_OP_FIT_GRID || m->op == ET_OP_FIT_SCATTERED;
        const int hard = fit || m->op == ET_OP_CURVE_NEAREST || m->op == ET_OP_SURFACE_NEAREST;
        const size_t most = m->layout->axes == 1 ? (hard ? 60 : m->layout->net[0] >= 0 ? 1200 : 2500) : hard ? 7 : 20;
        return most / 4 + campaign_pick(m, most - most / 4);
    }
    if (m->category == ET_CATEGORY_NEAR_KNOTS || m->category == ET_CATEGORY_REPEATED_KNOTS || m->exact) {
        return 3 + campaign_pick(m, few - 1);
    }
    return (m->category == ET_CATEGORY_PLAIN && axis == 0 ? 2 : 1) + campaign_pick(m, few);
}

/* ---- breakpoints: the different knots of the domain ---- */

/* A little above x (dir 1) or below (dir -1): a few ulps, or what hello still tells apart. */
static double beside(campaign_maker *m, double x, double dir, double length)
{
    const size_t steps = campaign_pick(m, 2) ? 1 : 1 + campaign_pick(m, 4);
    double y = x;
    if (m->hello->knot_tolerance > 0.0) {
        y = x + dir * 2.5 * m->hello->knot_tolerance * length;
    }
    if (y == x && x == 0.0) {
        y = dir * 0x1p-60 * length;
    }
    for (size_t i = 0; y == x || (i > 0 && i < steps); i++) {
        y = nextafter(y, dir * HUGE_VAL);
    }
    return y;
}

static void near_breaks(campaign_maker *m, double *b, size_t spans)
{
    const double length = b[spans] - b[0];
    const size_t i = 1 + campaign_pick(m, spans - 1);
    double old[2] = {b[i], 0.0};
    if (campaign_pick(m, 2)) {
        b[i] = beside(m, b[i - 1], 1.0, length);
    } else {
        b[i] = beside(m, b[i + 1], -1.0, length);
    }
    if (!(b[i - 1] < b[i] && b[i] < b[i + 1])) {
        b[i] = old[0];
    }
    if (spans > 3 && campaign_pick(m, 2) && i + 2 < spans) {      /* a third one: three knots within a few ulps */
        old[1] = b[i + 1];
        b[i + 1] = beside(m, b[i], 1.0, length);
        b[i + 1] = b[i + 1] < b[i + 2] ? b[i + 1] : old[1];
    }
}

static void breaks(campaign_maker *m, double *b, size_t spans)
{
    const size_t style = m->exact || m->category == ET_CATEGORY_SIZE ? 0 : campaign_pick(m, 4);
    const int zero = m->category == ET_CATEGORY_NEAR_KNOTS && campaign_kind(m, 4) == 1;
    const double shift = zero ? -(double)(1 + campaign_pick(m, spans - 1)) : style == 3 ? campaign_real(m, -4.0, 4.0) : 0.0;
    b[0] = shift;
    for (size_t i = 1; i <= spans; i++) {
        const double step = zero || style == 0 ? 1.0 : style == 1 ? 0.0625 * (double)(1 + campaign_pick(m, 16)) : campaign_real(m, 0.25, 1.5);
        b[i] = b[i - 1] + step;
    }
    if (m->unit || (style == 2 && !zero)) {      /* on [0,1] */
        const double lo = b[0], length = b[spans] - lo;
        for (size_t i = 0; i < spans; i++) {
            b[i] = (b[i] - lo) / length;
        }
        b[spans] = 1.0;
    }
    if (m->category == ET_CATEGORY_NEAR_KNOTS && !zero) {
        near_breaks(m, b, spans);
    }
    for (size_t i = 0; i <= spans; i++) {
        b[i] = ldexp(b[i], m->e_knots) + m->o_knots;
    }
}

/* How often an inner breakpoint is a knot. */
static size_t multiplicity(campaign_maker *m, size_t p, size_t i)
{
    const size_t least = m->exact ? (p + 1) / 2 : 1, most = m->smooth || m->layout->times >= 0 ? p : p + 1;
    size_t k = least;
    if (p == 0 || m->category == ET_CATEGORY_SIZE) {
        return least;                             /* where it is more than 1, p is not 0 */
    }
    if (m->category == ET_CATEGORY_REPEATED_KNOTS) {
        const size_t turn = campaign_kind(m, 4) + i;
        k = turn % 4 == 1 ? most : turn % 4 == 2 ? p : 1 + campaign_pick(m, most);
    } else if (m->category == ET_CATEGORY_NEAR_KNOTS && campaign_kind(m, 4) == 1) {
        k = 2;                                    /* -0 and 0 */
    } else if (campaign_pick(m, 6) == 0) {
        k = 1 + campaign_pick(m, p);
    }
    return k < least ? least : k > most ? most : k;
}

static void fill(campaign_basis *b, double x, size_t times)
{
    for (size_t i = 0; i < times; i++) {
        b->u[b->nu++] = x;
    }
}

/* Knots before or behind the domain where the ends are not clamped (implementation-defined). */
static void unclamp(campaign_basis *b)
{
    const double lo = b->u[b->p], hi = b->u[b->nu - 1 - b->p], step = (hi - lo) / 8.0;
    for (size_t i = 1; i <= b->p; i++) {
        b->u[b->p - i] = lo - (double)i * step;
        b->u[b->nu - 1 - b->p + i] = hi + (double)i * step;
    }
}

/* -0 beside 0 is one knot. */
static void signs(campaign_basis *b)
{
    int minus = 1;
    for (size_t i = 0; i < b->nu; i++) {
        if (b->u[i] == 0.0) {
            b->u[i] = minus ? -0.0 : 0.0;
            minus = 0;
        }
    }
}

campaign_basis campaign_knots(campaign_maker *m, size_t axis, size_t p, size_t spans)
{
    double *t = campaign_array(m, spans + 1);
    campaign_basis b = {p, 0, 0, campaign_array(m, (spans + 1) * (p + 2))};
    const size_t kind = campaign_kind(m, 8);
    /* Rarely more than p + 1: implementation-defined. */
    const int too_often = m->category == ET_CATEGORY_REPEATED_KNOTS && kind == 7 && !m->smooth && !m->exact && axis == 0;
    const size_t more = too_often ? 1 + campaign_pick(m, 2) : 0;
    breaks(m, t, spans);
    fill(&b, t[0], p + 1 + (more == 1));
    for (size_t i = 1; i < spans; i++) {
        fill(&b, t[i], more == 2 && i == 1 ? p + 2 : multiplicity(m, p, i));
    }
    fill(&b, t[spans], p + 1);
    b.n = b.nu - p - 1;
    if (m->category == ET_CATEGORY_END_OF_DOMAIN && kind == 7 && !m->smooth && m->layout->times < 0 && axis == 0) {
        unclamp(&b);
    }
    if (m->category == ET_CATEGORY_NEAR_KNOTS && campaign_kind(m, 4) == 1) {
        signs(&b);
    }
    return b;
}

size_t campaign_multiplicity(const campaign_basis *b, double x)
{
    size_t k = 0;
    for (size_t i = 0; i < b->nu; i++) {
        k += b->u[i] == x;
    }
    return k;
}

void campaign_put_basis(campaign_maker *m, const campaign_axis *at, const campaign_basis *b)
{
    if (at->degree >= 0) {
        campaign_count(m, at->degree, b->p);
    }
    campaign_list(m, at->knots, b->u, b->nu);
}

/* ---- parameters ---- */

double campaign_inside(campaign_maker *m, const campaign_basis *b)
{
    const double lo = b->u[b->p], hi = b->u[b->n];
    const double f = campaign_pick(m, 3) == 0 ? 0.0625 * (double)campaign_pick(m, 17) : campaign_real(m, 0.0, 1.0);
    return campaign_clamp(lo, lo + (hi - lo) * f, hi);
}

/* The first knot of a span that is not empty, of the domain. */
static size_t span(campaign_maker *m, const campaign_basis *b)
{
    size_t k = b->p + campaign_pick(m, b->n - b->p);
    while (k > b->p && !(b->u[k] < b->u[k + 1])) {
        k--;
    }
    return k;
}

static double at_end(campaign_maker *m, const campaign_basis *b, size_t kind)
{
    const double lo = b->u[b->p], hi = b->u[b->n];
    switch (kind) {
    case 0: return hi;
    case 1: return beside(m, hi, -1.0, hi - lo);
    case 2: return lo;
    case 3: return beside(m, lo, 1.0, hi - lo);
    case 4: return b->u[b->n - 1] + (hi - b->u[b->n - 1]) * campaign_real(m, 0.0, 1.0);
    case 5: return beside(m, hi, 1.0, hi - lo);                       /* outside: implementation-defined */
    case 6: return campaign_pick(m, 2) ? beside(m, lo, -1.0, hi - lo) : lo - (hi - lo);
    default: return campaign_pick(m, 2) ? hi : lo;
    }
}

/* The inner knot with an odd number of neighbours: of a repeated one, the most repeated. */
static double inner(campaign_maker *m, const campaign_basis *b)
{
    double x = b->u[b->p + campaign_pick(m, b->n - b->p + 1)];
    for (size_t i = b->p + 1; i < b->n && m->category == ET_CATEGORY_REPEATED_KNOTS; i++) {
        x = campaign_multiplicity(b, b->u[i]) > campaign_multiplicity(b, x) || x == b->u[b->p] || x == b->u[b->n] ? b->u[i] : x;
    }
    return x;
}

/* At a knot that stands next to another, or a little beside one. */
static double near_knot(campaign_maker *m, const campaign_basis *b)
{
    const double lo = b->u[b->p], hi = b->u[b->n];
    size_t k = b->p;
    for (size_t i = b->p; i < b->n; i++) {       /* the narrowest span */
        const double width = b->u[i + 1] - b->u[i], least = b->u[k + 1] - b->u[k];
        k = width > 0.0 && width < least ? i : k;
    }
    const double x = b->u[campaign_pick(m, 3) ? k + campaign_pick(m, 2) : b->p + campaign_pick(m, b->n - b->p + 1)];
    const size_t turn = (campaign_kind(m, 12) / 4 + campaign_pick(m, 2)) % 3;
    if (campaign_kind(m, 4) == 1 && campaign_pick(m, 3)) {
        return campaign_pick(m, 2) ? 0.0 : -0.0;
    }
    const double y = turn == 0 ? x : beside(m, x, turn == 1 ? 1.0 : -1.0, hi - lo);
    return campaign_clamp(lo, y, hi);
}

double campaign_place(campaign_maker *m, const campaign_basis *b, size_t axis)
{
    const size_t turn = campaign_pick(m, 8);
    if (m->category == ET_CATEGORY_END_OF_DOMAIN) {
        return at_end(m, b, axis == 0 ? campaign_kind(m, 8) : campaign_pick(m, 2) ? campaign_pick(m, 5) : 0);
    }
    if (m->category == ET_CATEGORY_NEAR_KNOTS) {
        return near_knot(m, b);
    }
    if ((m->category == ET_CATEGORY_REPEATED_KNOTS && (turn < 6 || axis == 0)) || turn == 0) {
        return inner(m, b);
    }
    if (m->category == ET_CATEGORY_PLAIN && turn == 1) {
        return campaign_pick(m, 2) ? b->u[b->n] : b->u[b->p];
    }
    if (turn < 5) {
        const size_t k = turn == 2 ? b->n - 1 : turn == 3 ? b->p : span(m, b);
        const double x = b->u[k] + (b->u[k + 1] - b->u[k]) * (turn == 4 ? 0.5 : campaign_real(m, 0.0, 1.0));
        return campaign_clamp(b->u[b->p], x, b->u[b->n]);
    }
    return campaign_inside(m, b);
}

int campaign_side(campaign_maker *m)
{
    const int offered[3] = {m->hello->any, m->hello->right, m->hello->left};
    int side[3] = {0, 0, 0}, n = 0;
    for (int k = 2; k >= 0; k--) {               /* the left ones first: they are forgotten most */
        if (offered[k]) {
            side[n++] = k;
        }
    }
    const size_t turn = m->category == ET_CATEGORY_REPEATED_KNOTS ? campaign_kind(m, (size_t)n) : campaign_pick(m, (size_t)n);
    return side[turn];
}
