/* campaign, fits: parameters, knot rules, least squares, approximation, and the double net's numbers. */
#include "conform/campaign_parts.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Sites at the Greville points, where Schoenberg and Whitney's condition holds with room to spare, and others. */
static size_t good_sites(campaign_maker *m, double *t, const campaign_basis *b, size_t more)
{
    size_t n = 0;
    for (size_t i = 0; i < b->n; i++) {
        double sum = 0.0;
        for (size_t k = 1; k <= b->p; k++) {
            sum += b->u[i + k] / (double)b->p;
        }
        /* the mean of equal knots is that knot, however it is rounded */
        t[n++] = b->u[i + 1] == b->u[i + b->p] ? b->u[i + 1] : campaign_clamp(b->u[b->p], sum, b->u[b->n]);
    }
    for (size_t k = 0; k < more; k++) {
        t[n++] = m->category == ET_CATEGORY_NEAR_KNOTS || m->category == ET_CATEGORY_REPEATED_KNOTS ? campaign_place(m, b, 0) : campaign_inside(m, b);
    }
    qsort(t, n, sizeof *t, ascending);
    return n;
}

/* The kinds of failure, and what is nearly one. */
static size_t failing_sites(campaign_maker *m, double *t, size_t n, const campaign_basis *b)
{
    const double lo = b->u[b->p], hi = b->u[b->n], last = b->u[b->n - 1];
    const size_t i = 1 + campaign_pick(m, b->n - 2);     /* neither the first function nor the last, which are 1 at the ends */
    switch (campaign_kind(m, 8)) {
    case 0:                                              /* nothing in the last span */
        for (size_t k = 0; k < n; k++) {
            t[k] = campaign_clamp(lo, lo + (t[k] - lo) * ((last - lo) / (hi - lo)), last);
        }
        return n;
    case 1:                                              /* too few different ones */
        for (size_t k = 0; k < n; k++) {
            t[k] = t[k % (b->n - 1)];
        }
        break;
    case 2: return b->n - 1;                             /* too few */
    case 3:                                              /* those of the last span at its very beginning: hardly independent */
        for (size_t k = 0; k < n; k++) {
            t[k] = t[k] > last ? last + (t[k] - last) * 0x1p-7 : t[k];
        }
        return n;
    case 4:                                              /* each twice */
        for (size_t k = n; k > 0; k--) {
            t[2 * k - 2] = t[2 * k - 1] = t[k - 1];
        }
        return 2 * n;
    case 5:                                              /* none where a function is not zero */
        for (size_t k = 0; k < n; k++) {
            t[k] = t[k] > b->u[i] && t[k] < b->u[i + b->p + 1] ? (b->u[i] > lo ? b->u[i] : b->u[i + b->p + 1]) : t[k];
        }
        break;
    case 6: return b->n;                                 /* the first of them: as many as unknowns */
    default:
        for (size_t k = 0; k < n; k++) {
            t[k] = t[0];
        }
    }
    qsort(t, n, sizeof *t, ascending);
    return n;
}

static size_t end_sites(campaign_maker *m, double *t, size_t n, const campaign_basis *b)
{
    switch (campaign_kind(m, 6)) {
    case 0: break;                                       /* the Greville points hold both ends */
    case 1: t[0] = nextafter(t[0], HUGE_VAL); break;
    case 2: t[n - 1] = nextafter(t[n - 1], -HUGE_VAL); break;
    case 3:
        t[n] = b->u[b->n];                               /* the end again */
        return n + 1;
    case 4: t[n - 1] = nextafter(b->u[b->n], HUGE_VAL); break;       /* outside: invalid */
    default: t[0] = nextafter(b->u[b->p], -HUGE_VAL); break;
    }
    return n;
}

/* Sites for one direction; `faulty`: as the category wants them. */
static size_t sites(campaign_maker *m, double **t, const campaign_basis *b, int faulty)
{
    const size_t size = m->category == ET_CATEGORY_SIZE ? b->n : 0, more = campaign_pick(m, 4) ? campaign_pick(m, 6) + size : 0;
    *t = campaign_array(m, 2 * (b->n + more) + 2);
    const size_t n = good_sites(m, *t, b, m->category == ET_CATEGORY_FIT_FAILURE && campaign_kind(m, 8) == 6 ? 0 : more);
    if (!faulty) {
        return n;
    }
    if (m->category == ET_CATEGORY_FIT_FAILURE) {
        return failing_sites(m, *t, n, b);
    }
    return m->category == ET_CATEGORY_END_OF_DOMAIN ? end_sites(m, *t, n, b) : n;
}

/* Pairs of sites, a little beside a grid's, in any order. */
static void scatter(campaign_maker *m, double *t[2], const size_t n[2], const campaign_basis b[2])
{
    const size_t count = n[0] * n[1];
    const int still = m->category == ET_CATEGORY_FIT_FAILURE || m->category == ET_CATEGORY_END_OF_DOMAIN || m->category == ET_CATEGORY_NEAR_KNOTS;
    double *a[2] = {campaign_array(m, count), campaign_array(m, count)};
    for (size_t k = 0; k < count; k++) {
        const size_t at[2] = {k / n[1], k % n[1]};
        for (size_t c = 0; c < 2; c++) {
            const double lo = b[c].u[b[c].p], hi = b[c].u[b[c].n], x = t[c][at[c]];
            const double moved = x + (hi - lo) * campaign_real(m, -0x1p-8, 0x1p-8);
            a[c][k] = still ? x : campaign_clamp(lo, moved, hi);
        }
    }
    for (size_t k = count; k > 1; k--) {
        const size_t other = campaign_pick(m, k);
        for (size_t c = 0; c < 2; c++) {
            const double x = a[c][k - 1];
            a[c][k - 1] = a[c][other];
            a[c][other] = x;
        }
    }
    campaign_list(m, m->layout->axis[0].sites, a[0], count);
    campaign_list(m, m->layout->axis[1].sites, a[1], count);
}

void campaign_draw_fit(campaign_maker *m)
{
    const campaign_layout *l = m->layout;
    const size_t most = m->op == ET_OP_FIT_CURVE ? 25 : m->op == ET_OP_FIT_GRID ? 9 : 4, faulty = campaign_kind(m, 16) / 8 % l->axes;
    campaign_basis b[2] = {{0, 0, 1, NULL}, {0, 0, 1, NULL}};
    double *t[2] = {NULL, NULL};
    size_t n[2] = {1, 1};
    for (size_t k = 0; k < l->axes; k++) {
        size_t spans = campaign_spans(m, k);
        spans = m->op == ET_OP_FIT_SCATTERED && spans > 3 ? 3 : spans;
        spans = m->category == ET_CATEGORY_FIT_FAILURE && spans < 3 ? 3 : spans;
        b[k] = campaign_knots(m, k, campaign_degree(m, k, 1, most), spans);
        campaign_put_basis(m, &l->axis[k], &b[k]);
        n[k] = sites(m, &t[k], &b[k], k == faulty);
        if (m->op != ET_OP_FIT_SCATTERED) {
            campaign_list(m, l->axis[k].sites, t[k], n[k]);
        }
    }
    if (m->op == ET_OP_FIT_SCATTERED) {
        scatter(m, t, n, b);
    }
    if (m->op == ET_OP_FIT_GRID) {
        campaign_count(m, 0, campaign_pick(m, 2));
    }
    double *D = campaign_array(m, 3 * n[0] * n[1]);
    if (campaign_pick(m, 2)) {
        campaign_data(m, D, n[0], n[1]);
    } else {
        campaign_points(m, D, n[0], n[1]);
    }
    campaign_list(m, l->data, D, n[0] * n[1]);
}

/* ---- parameters and knots ---- */

void campaign_draw_parameters(campaign_maker *m)
{
    const int grid = m->op == ET_OP_PARAMETERS_GRID, large = m->category == ET_CATEGORY_SIZE;
    const size_t nx = large ? (grid ? 20 + campaign_pick(m, 20) : 300 + campaign_pick(m, 1200)) : 2 + campaign_pick(m, grid ? 5 : 10);
    const size_t ny = !grid ? 1 : large ? 20 + campaign_pick(m, 20) : 2 + campaign_pick(m, 5);
    double *P = campaign_array(m, 3 * nx * ny);
    if (campaign_pick(m, 2)) {
        campaign_data(m, P, nx, ny);
    } else {
        campaign_points(m, P, nx, ny);
    }
    campaign_count(m, 0, (size_t)((m->number + 1) % 4));             /* chord first */
    if (grid) {
        campaign_count(m, 1, nx);
        campaign_count(m, 2, ny);
    }
    campaign_list(m, m->layout->data, P, nx * ny);
}

/* m parameters from 0 to 1. */
static void parameter_line(campaign_maker *m, double *t, size_t n)
{
    const size_t style = campaign_pick(m, 3);
    for (size_t i = 0; i < n; i++) {
        t[i] = style == 0 ? (double)i / (double)(n - 1) : style == 1 ? 0x1p-10 * (double)campaign_pick(m, 1025) : campaign_real(m, 0.0, 1.0);
        if (m->category == ET_CATEGORY_REPEATED_KNOTS) {
            t[i] = 0.25 * (double)campaign_pick(m, 5);
        } else if (m->category == ET_CATEGORY_EXTREME_SCALE) {
            t[i] = campaign_kind(m, 2) ? 1.0 - 0x1p-53 * (double)campaign_pick(m, 9) : ldexp(t[i], -1000);
        }
    }
    qsort(t, n, sizeof *t, ascending);
    t[0] = 0.0;
    t[n - 1] = 1.0;
}

void campaign_draw_knots(campaign_maker *m)
{
    enum { PIEGL, AVERAGING, FAITHFUL, UNIFORM };
    const size_t rule = campaign_kind(m, 4), p = campaign_degree(m, 0, 1, 25), large = m->category == ET_CATEGORY_SIZE ? 300 : 0;
    const size_t n = p + 1 + campaign_pick(m, large ? 600 : 9), more = campaign_pick(m, 12 + large);
    const size_t count = rule == AVERAGING ? n : rule == UNIFORM ? 2 + more % 10 : n + more;
    double *t = campaign_array(m, count);
    parameter_line(m, t, count < 2 ? 2 : count);
    campaign_count(m, 0, rule);
    campaign_count(m, 1, p);
    campaign_count(m, 2, n);
    campaign_list(m, 3, t, count);
}

void campaign_draw_approximate(campaign_maker *m)
{
    size_t n[2], count[2];
    for (int k = 0; k < 2; k++) {
        const size_t p = campaign_degree(m, (size_t)k, 1, 9);
        n[k] = p + 1 + campaign_pick(m, m->category == ET_CATEGORY_SIZE ? 8 : 4);
        count[k] = n[k] + campaign_pick(m, 6) + (m->category == ET_CATEGORY_SIZE ? 20 : 0);
        campaign_count(m, k, p);
        campaign_count(m, k + 2, n[k]);
        campaign_count(m, k + 4, count[k]);
    }
    double *P = campaign_array(m, 3 * count[0] * count[1]);
    campaign_data(m, P, count[0], count[1]);
    campaign_list(m, 6, P, count[0] * count[1]);
}

/* ---- the double net ---- */

void campaign_draw_net(campaign_maker *m)
{
    /* Sizes whose products leave 32 bits, where counts have more. */
    const size_t most = m->category != ET_CATEGORY_SIZE ? 11 : SIZE_MAX >> 16 >> 16 > 0 ? (size_t)1 << 26 : 1 << 15;
    const size_t nx = 2 + campaign_pick(m, most - 1), ny = 2 + campaign_pick(m, most - 1), kind = campaign_kind(m, 4);
    size_t i = campaign_pick(m, nx), j = campaign_pick(m, ny);
    campaign_count(m, 0, nx);
    campaign_count(m, 1, ny);
    if (m->category == ET_CATEGORY_END_OF_DOMAIN) {
        i = kind & 2 ? nx - 1 : 0;
        j = kind & 1 ? ny - 1 : 0;
    } else if (m->category == ET_CATEGORY_SEAM) {
        i = kind == 0 ? 0 : kind == 1 ? nx - 1 : i;
        j = kind == 2 ? 0 : kind == 3 ? ny - 1 : j;
    }
    const size_t view = campaign_pick(m, 2), nov = 2 * (nx * ny - nx - ny + 2);
    if (m->op == ET_OP_NET_CLASS) {
        campaign_count(m, 2, view);
        campaign_count(m, 3, i);
        campaign_count(m, 4, j);
    } else if (m->op == ET_OP_NET_NODE) {
        const size_t last = campaign_kind(m, 8) / 4 ? nov : nx * ny;
        campaign_count(m, 2, m->category == ET_CATEGORY_END_OF_DOMAIN || m->category == ET_CATEGORY_SEAM
                                 ? (view ? i * ny + j + 1 : last)
                                 : 1 + campaign_pick(m, nov));
    }
}
