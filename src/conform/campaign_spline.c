/* campaign, splines: requests that evaluate and edit. */
#include "conform/campaign_parts.h"
#include <math.h>
#include <stdlib.h>

/* Degree 0 is implementation-defined but for these. */
static size_t least_degree(const campaign_maker *m)
{
    const int zero = m->op == ET_OP_SPAN || m->op == ET_OP_BASIS || m->op == ET_OP_CURVE_POINT || m->op == ET_OP_SURFACE_POINT ||
                     m->op == ET_OP_MULTIPLICITY;
    return zero || m->category == ET_CATEGORY_DEGREES ? 0 : 1;
}

/* The order of derivatives: the result must stay within doubles. */
static size_t order(campaign_maker *m, size_t p)
{
    const size_t likely[8] = {1, 2, 3, 2, 3, 1, 0, p + 1};
    size_t d = likely[campaign_pick(m, 8)];
    if (campaign_pick(m, 16) == 0 && m->category != ET_CATEGORY_EXTREME_SCALE) {
        d = 4 + campaign_pick(m, 3);
    }
    d = d > m->hello->order ? m->hello->order : d;
    d = d > p + 3 ? p + 3 : d;
    while (d > 0 && abs(m->e_points - (int)d * m->e_knots) > 1010) {
        d--;
    }
    return d;
}

void campaign_draw_basis(campaign_maker *m)
{
    const campaign_axis *a = &m->layout->axis[0];
    const size_t p = campaign_degree(m, 0, least_degree(m), 25);
    const campaign_basis b = campaign_knots(m, 0, p, campaign_spans(m, 0));
    campaign_put_basis(m, a, &b);
    if (a->at >= 0) {
        const int knot = m->op == ET_OP_MULTIPLICITY && m->category != ET_CATEGORY_NEAR_KNOTS && campaign_pick(m, 3);
        campaign_number(m, a->at, knot ? b.u[campaign_pick(m, b.nu)] : campaign_place(m, &b, 0));
    }
    if (a->side >= 0) {
        campaign_count(m, a->side, (size_t)campaign_side(m));
    }
    if (m->layout->order >= 0) {
        campaign_count(m, m->layout->order, order(m, p));
    }
}

/* Control points and weights into arguments k and k + 1. */
static void net(campaign_maker *m, int k, size_t nx, size_t ny)
{
    double *P = campaign_array(m, 3 * nx * ny);
    campaign_points(m, P, nx, ny);
    campaign_list(m, k, P, nx * ny);
    if (m->rational) {
        double *w = campaign_weights(m, nx * ny);
        campaign_list(m, k + 1, w, nx * ny);
    }
}

void campaign_draw_spline(campaign_maker *m)
{
    const campaign_layout *l = m->layout;
    campaign_basis b[2] = {{0, 0, 1, NULL}, {0, 0, 1, NULL}};
    size_t p = 0;
    for (size_t k = 0; k < l->axes; k++) {
        const size_t degree = campaign_degree(m, k, least_degree(m), 25);
        b[k] = campaign_knots(m, k, degree, campaign_spans(m, k));
        campaign_put_basis(m, &l->axis[k], &b[k]);
        campaign_number(m, l->axis[k].at, campaign_place(m, &b[k], k));
        if (l->axis[k].side >= 0) {
            campaign_count(m, l->axis[k].side, (size_t)campaign_side(m));
        }
        p = b[k].p > p ? b[k].p : p;
    }
    net(m, l->net[0], b[0].n, b[1].n);
    if (l->order >= 0) {
        campaign_count(m, l->order, order(m, p));
    }
}

/* ---- editing ---- */

/* A surface, or a curve with b[1].n = 1: w P in H, w in w. */
typedef struct { campaign_basis b[2]; double *H, *w; } spline;

static size_t place(const spline *s, size_t along, size_t i, size_t line)
{
    return along == 0 ? i * s->b[1].n + line : line * s->b[1].n + i;
}

static void copy_knots(campaign_maker *m, campaign_basis *b, double x)
{
    double *u = campaign_array(m, b->nu + 1);
    size_t n = 0;
    for (size_t i = 0; b->u[i] <= x; i++) {                /* x is below the last knot */
        u[n++] = b->u[i];
    }
    u[n++] = x;
    for (size_t i = n - 1; i < b->nu; i++) {
        u[n++] = b->u[i];
    }
    b->u = u;
    b->nu++;
    b->n++;
}

/* Boehm: the knot x once more.  With distances of 1 and 2 and x at quarters, the products and sums are exact for short numbers. */
static void insert(campaign_maker *m, spline *s, size_t along, double x)
{
    const campaign_basis b = s->b[along];
    const size_t lines = s->b[1 - along].n, times = campaign_multiplicity(&b, x);
    spline t = *s;
    size_t k = b.p;
    while (k + 1 < b.n && b.u[k + 1] <= x) {
        k++;
    }
    copy_knots(m, &t.b[along], x);
    t.H = campaign_array(m, 3 * (b.n + 1) * lines);
    t.w = campaign_array(m, (b.n + 1) * lines);
    for (size_t i = 0; i <= b.n; i++) {
        const double a = i + b.p <= k ? 1.0 : i + times > k ? 0.0 : (x - b.u[i]) / (b.u[i + b.p] - b.u[i]);
        for (size_t line = 0; line < lines; line++) {
            const size_t to = place(&t, along, i, line), from = place(s, along, i < b.n ? i : i - 1, line);
            const size_t left = place(s, along, i > 0 ? i - 1 : 0, line);
            t.w[to] = a * s->w[from] + (1.0 - a) * s->w[left];
            for (size_t c = 0; c < 3; c++) {
                t.H[3 * to + c] = a * s->H[3 * from + c] + (1.0 - a) * s->H[3 * left + c];
            }
        }
    }
    *s = t;
}

static void put_spline(campaign_maker *m, const spline *s)
{
    const campaign_layout *l = m->layout;
    const size_t n = s->b[0].n * s->b[1].n;
    for (size_t k = 0; k < l->axes; k++) {
        campaign_put_basis(m, &l->axis[k], &s->b[k]);
    }
    for (size_t i = 0; i < 3 * n && m->rational; i++) {
        s->H[i] = s->w[i / 3] == 0.0 ? 0.0 : s->H[i] / s->w[i / 3];
    }
    campaign_list(m, l->net[0], s->H, n);
    if (m->rational) {
        campaign_list(m, l->net[0] + 1, s->w, n);
    }
}

static spline draw(campaign_maker *m)
{
    spline s = {{{0, 0, 1, NULL}, {0, 0, 1, NULL}}, NULL, NULL};
    const int elevate = m->op == ET_OP_CURVE_ELEVATE || m->op == ET_OP_SURFACE_ELEVATE;
    for (size_t k = 0; k < m->layout->axes; k++) {
        const size_t room = m->hello->degree - (elevate ? 1 : 0), most = elevate || m->exact ? 12 : 25;
        size_t spans = campaign_spans(m, k);
        spans = m->category == ET_CATEGORY_SIZE && (elevate || m->exact) ? spans / 4 + 3 : spans;
        s.b[k] = campaign_knots(m, k, campaign_degree(m, k, 1, room < most ? room : most), spans);
    }
    const size_t n = s.b[0].n * s.b[1].n;
    s.H = campaign_array(m, 3 * n);
    campaign_points(m, s.H, s.b[0].n, s.b[1].n);
    s.w = m->rational ? campaign_weights(m, n) : campaign_array(m, n);
    for (size_t i = 0; i < n; i++) {
        s.w[i] = m->rational ? s.w[i] : 1.0;
        for (size_t c = 0; c < 3 && m->rational; c++) {
            s.H[3 * i + c] *= s.w[i];
        }
    }
    return s;
}

/* Inside a span, at a quarter of it. */
static double quarter(campaign_maker *m, const campaign_basis *b)
{
    size_t k = b->p + campaign_pick(m, b->n - b->p);
    while (k > b->p && !(b->u[k] < b->u[k + 1])) {
        k--;
    }
    return b->u[k] + (b->u[k + 1] - b->u[k]) * 0.25 * (double)(1 + campaign_pick(m, 3));
}

static void draw_insert(campaign_maker *m, const campaign_basis *b)
{
    double x = campaign_place(m, b, 0);
    if (m->category == ET_CATEGORY_END_OF_DOMAIN && (x == b->u[b->p] || x == b->u[b->n])) {
        /* The ends cannot be inserted: what is next to them can. */
        x = x == b->u[b->p] ? nextafter(x, HUGE_VAL) : nextafter(x, -HUGE_VAL);
    } else if (m->exact || x == b->u[b->p] || x == b->u[b->n]) {
        x = quarter(m, b);
    }
    const size_t times = campaign_multiplicity(b, x), most = times < b->p ? b->p - times : 1;
    size_t r = campaign_pick(m, 3) ? 1 + campaign_pick(m, most) : 1;
    if (times <= b->p && campaign_pick(m, 6) == 0) {
        r = b->p + 1 - times;                     /* to full multiplicity */
    }
    campaign_number(m, campaign_at(m->request, m->layout->along >= 0 ? m->request->arg[m->layout->along].count : 0), x);
    campaign_count(m, m->layout->times, campaign_kind(m, 16) == 15 && m->category == ET_CATEGORY_EDITING ? 0 : r);
}

/* What was inserted is removed again; or what cannot be removed; or, with a great tolerance, anything. */
static void draw_remove(campaign_maker *m, spline *s, size_t along)
{
    const campaign_basis *b = &s->b[along];
    const size_t kind = campaign_kind(m, 5);
    const double size = ldexp(1.0, m->e_points);
    double x = quarter(m, b), tolerance = 0x1p-30 * size;
    size_t r = 0;
    if (kind == 1 || kind == 2 || kind == 4) {
        for (size_t i = b->p + 1; i < b->n; i++) {
            x = r == 0 || campaign_pick(m, 2) ? b->u[i] : x;
            r = 1;
        }
    }
    const size_t times = campaign_multiplicity(b, x);
    const size_t most = times < b->p ? b->p - times : 0, inserted = kind == 2 || most == 0 ? 0 : 1 + campaign_pick(m, most);
    for (size_t i = 0; i < inserted; i++) {
        insert(m, s, along, x);
    }
    r = kind == 0 ? inserted : 1 + campaign_pick(m, times + inserted);      /* x is a knot now */
    tolerance = kind == 3 ? 0x1p-20 * size : kind == 4 ? fmin(0x1p40 * size, 0x1p1020) : tolerance;
    if (m->o_points > 0.0 && kind != 4) {
        tolerance = 0x1p-10;
    }
    put_spline(m, s);
    campaign_number(m, m->layout->along >= 0 ? m->layout->at : m->layout->axis[0].at, x);
    campaign_count(m, m->layout->times, r);
    campaign_number(m, m->layout->tolerance, tolerance);
}

void campaign_draw_edit(campaign_maker *m)
{
    const campaign_layout *l = m->layout;
    spline s = draw(m);
    const size_t along = l->along >= 0 ? campaign_pick(m, 2) : 0;
    if (l->along >= 0) {
        campaign_count(m, l->along, along);
    }
    if (l->tolerance >= 0) {
        draw_remove(m, &s, along);
        return;
    }
    if (m->exact && campaign_pick(m, 2)) {            /* edited before */
        insert(m, &s, along, quarter(m, &s.b[along]));
    }
    put_spline(m, &s);
    if (m->op == ET_OP_CURVE_INSERT || m->op == ET_OP_SURFACE_INSERT) {
        draw_insert(m, &s.b[along]);
    } else {
        const size_t room = m->hello->degree - s.b[along].p;
        campaign_count(m, l->times, 1 + campaign_pick(m, room > 3 ? 3 : room));
    }
}

/* ---- what is measured ---- */

/* A point of the curve or surface at a control point of its end, or one that is symmetric, far, ... */
static void sought(campaign_maker *m, double Q[3], const double *P, size_t nx, size_t ny)
{
    const size_t n = nx * ny, i = campaign_pick(m, n), kind = m->category == ET_CATEGORY_INVERSION ? campaign_kind(m, 8) : campaign_pick(m, 4);
    const size_t corner[4] = {0, ny - 1, n - ny, n - 1};
    const double *end = P + 3 * corner[campaign_pick(m, 4)];
    for (size_t c = 0; c < 3; c++) {
        const double off = ldexp(campaign_real(m, -12.0, 12.0), m->e_points), mean = 0.5 * P[3 * i + c] + 0.5 * P[3 * (n - 1 - i) + c];
        switch (kind) {
        case 0: Q[c] = m->o_points + off; break;
        case 1: Q[c] = end[c]; break;                                          /* on it, at an end */
        case 2: Q[c] = P[3 * i + c]; break;
        case 3: Q[c] = mean; break;
        case 4: Q[c] = end[c] + 0x1p-20 * off; break;
        case 5: Q[c] = m->o_points + 1024.0 * off; break;                      /* far away */
        case 6: Q[c] = end[c] + (end[c] - P[3 * i + c]); break;                /* beyond the end */
        default: Q[c] = 0.5 * (end[c] + mean); break;
        }
    }
}

/* Arcs of a parabola and of a circle, and the centre of curvature at their vertex: many points are about equally near. */
static void centre(campaign_maker *m)
{
    static const double u[6] = {0.0, 0.0, 0.0, 1.0, 1.0, 1.0};
    const int arc = m->rational && campaign_pick(m, 2);
    const double P[9] = {arc ? 1.0 : -1.0, arc ? 0.0 : 1.0, 0.0, arc ? 1.0 : 0.0, arc ? 1.0 : -1.0, 0.0, arc ? 0.0 : 1.0, 1.0, 0.0};
    const double w[3] = {1.0, 0x1.6a09e667f3bcdp-1, 1.0};
    const double Q[3] = {campaign_pick(m, 2) ? 0.0 : 0x1p-30, arc ? 0.0 : 0.5, 0.0};        /* y = x^2 has radius 1/2 there */
    campaign_count(m, 0, 2);
    campaign_list(m, 1, u, 6);
    campaign_list(m, 2, P, 3);
    campaign_list(m, 3, w, arc ? 3 : 0);
    campaign_list(m, 4, Q, 1);
}

static double *put_net(campaign_maker *m, int k, size_t nx, size_t ny)
{
    double *P = campaign_array(m, 3 * nx * ny);
    campaign_points(m, P, nx, ny);
    campaign_list(m, k, P, nx * ny);
    if (m->rational) {
        campaign_list(m, k + 1, campaign_weights(m, nx * ny), nx * ny);
    }
    return P;
}

void campaign_draw_nearest(campaign_maker *m)
{
    const campaign_layout *l = m->layout;
    campaign_basis b[2] = {{0, 0, 1, NULL}, {0, 0, 1, NULL}};
    double Q[3];
    if (m->op == ET_OP_CURVE_NEAREST && m->category == ET_CATEGORY_INVERSION && campaign_kind(m, 4) == 3 && m->hello->degree > 1) {
        centre(m);
        return;
    }
    for (size_t k = 0; k < l->axes; k++) {
        const size_t spans = campaign_spans(m, k);
        b[k] = campaign_knots(m, k, campaign_degree(m, k, 1, l->axes > 1 ? 5 : 9), spans);
        campaign_put_basis(m, &l->axis[k], &b[k]);
    }
    const double *P = put_net(m, l->net[0], b[0].n, b[1].n);
    sought(m, Q, P, b[0].n, b[1].n);
    campaign_list(m, l->data, Q, 1);
}

void campaign_draw_error(campaign_maker *m)
{
    const campaign_layout *l = m->layout;
    campaign_basis b[2];
    size_t n[2];
    for (size_t k = 0; k < 2; k++) {
        const size_t degree = campaign_degree(m, k, 1, 25);
        b[k] = campaign_knots(m, k, degree, campaign_spans(m, k));
        campaign_put_basis(m, &l->axis[k], &b[k]);
        n[k] = m->category == ET_CATEGORY_SIZE ? 20 + campaign_pick(m, 20) : 1 + campaign_pick(m, 4);
        double *t = campaign_array(m, n[k]);
        for (size_t i = 0; i < n[k]; i++) {
            /* Sites outside the domain are another question. */
            const double x = m->category == ET_CATEGORY_PLAIN ? campaign_inside(m, &b[k]) : campaign_place(m, &b[k], k);
            t[i] = campaign_clamp(b[k].u[b[k].p], x, b[k].u[b[k].n]);
        }
        campaign_list(m, l->axis[k].sites, t, n[k]);
    }
    put_net(m, l->net[0], b[0].n, b[1].n);
    double *D = campaign_array(m, 3 * n[0] * n[1]);
    campaign_points(m, D, n[0], n[1]);
    campaign_list(m, l->data, D, n[0] * n[1]);
}

/* Two surfaces on [0,1]^2: of different knots, with an equal border, or with one border point moved. */
void campaign_draw_seam(campaign_maker *m)
{
    const campaign_layout *l = m->layout;
    const int shell = m->category == ET_CATEGORY_SEAM || campaign_pick(m, 2);
    campaign_basis b[4];
    for (size_t k = 0; k < 4; k++) {
        if (k < 2) {
            const size_t degree = campaign_degree(m, k, 1, 9);
            b[k] = campaign_knots(m, k, degree, campaign_spans(m, k));
        } else {
            b[k] = b[k - 2];
        }
        if (k > 1 && !shell) {
            b[k].u = campaign_array(m, b[k].nu);
            for (size_t i = 0; i < b[k].nu; i++) {         /* other knots, as many */
                b[k].u[i] = b[k - 2].u[i] * b[k - 2].u[i];
            }
        }
        campaign_put_basis(m, &l->axis[k], &b[k]);
    }
    const size_t nx = b[0].n, ny = b[1].n;
    double *P = put_net(m, l->net[0], nx, ny);
    if (!shell) {
        put_net(m, l->net[1], b[2].n, b[3].n);
    } else {
        double *Q = campaign_array(m, 3 * nx * ny);
        const size_t moved = campaign_kind(m, 3) ? campaign_pick(m, nx * ny) : nx * ny;
        for (size_t i = 0; i < nx * ny; i++) {
            const int inside = i / ny > 0 && i / ny + 1 < nx && i % ny > 0 && i % ny + 1 < ny;
            for (size_t c = 0; c < 3; c++) {
                Q[3 * i + c] = inside ? P[3 * i + c] * 0.5 + m->o_points * 0.5 : P[3 * i + c] + (i == moved ? ldexp(0.25, m->e_points) : 0.0);
            }
        }
        campaign_list(m, l->net[1], Q, nx * ny);
        campaign_list(m, l->net[1] + 1, m->request->arg[l->net[0] + 1].x, m->request->arg[l->net[0] + 1].count);
    }
    campaign_count(m, 12, m->category == ET_CATEGORY_SIZE ? 20 : campaign_pick(m, 5));
}
