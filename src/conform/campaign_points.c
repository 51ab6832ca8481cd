/* campaign, points: control points, data points and weights as the categories want them. */
#include "conform/campaign_parts.h"
#include <math.h>

/* One coordinate in -10 .. 10. */
static double coordinate(campaign_maker *m, size_t style)
{
    switch (style) {
    case 0: return (double)campaign_pick(m, 19) - 9.0;
    case 1: return 0.0625 * (double)campaign_pick(m, 321) - 10.0;
    default: return campaign_real(m, -10.0, 10.0);
    }
}

/* P[i] := P[k]. */
static void same(double *P, size_t i, size_t k)
{
    for (size_t c = 0; c < 3; c++) {
        P[3 * i + c] = P[3 * k + c];
    }
}

/* Poles, coincident points, nothing but one point, a line, back and forth. */
static void degenerate(campaign_maker *m, double *P, size_t nx, size_t ny, size_t kind)
{
    const size_t n = nx * ny, run = 1 + campaign_pick(m, n);
    for (size_t i = 0; i < n; i++) {
        switch (kind) {
        case 0: same(P, i, i / ny == 0 ? 0 : i); break;                               /* a pole (of a curve: the first two points, below) */
        case 1: same(P, i, 0); break;                                                 /* all points equal */
        case 2: same(P, i, i > 0 && i <= run ? i - 1 : i); break;                     /* coincident from the first on */
        case 3: same(P, i, i % ny == ny - 1 && i > 0 ? i - (ny > 1) : i); break;      /* the last two columns */
        case 4:                                                                       /* on a line; a surface in a plane */
            P[3 * i + 1] = ny > 1 ? P[3 * i + 1] : P[3 * i];
            P[3 * i + 2] = P[3 * i] + P[3 * i + 1];
            break;
        case 5: same(P, i, i % 2); break;                                             /* back and forth */
        case 6: same(P, i, i / ny == nx - 1 ? n - ny : i / ny == 0 ? 0 : i); break;   /* two poles */
        default: P[3 * i] = P[3 * i + 1] = P[3 * i + 2] = 0.0; break;
        }
    }
    if ((kind == 0 || kind == 6) && ny == 1 && n > 1) {
        same(P, 1, 0);
    }
}

static void scale(const campaign_maker *m, double *P, size_t n)
{
    for (size_t i = 0; i < 3 * n; i++) {
        P[i] = ldexp(P[i], m->e_points) + m->o_points;
    }
}

void campaign_close(double *P, size_t nx, size_t ny, size_t kind)
{
    for (size_t j = 0; j < ny && kind != 1; j++) {
        same(P, (nx - 1) * ny + j, j);
    }
    for (size_t i = 0; i < nx && ny > 1 && kind != 0; i++) {
        same(P, i * ny + ny - 1, i * ny);
    }
}

void campaign_points(campaign_maker *m, double *P, size_t nx, size_t ny)
{
    const size_t n = nx * ny, style = m->exact || m->category == ET_CATEGORY_SIZE ? 0 : campaign_pick(m, 4);
    for (size_t i = 0; i < 3 * n; i++) {
        P[i] = coordinate(m, style);
    }
    if (m->category == ET_CATEGORY_DEGENERATE) {
        degenerate(m, P, nx, ny, campaign_kind(m, 8));
    }
    if (m->category == ET_CATEGORY_SEAM) {
        campaign_close(P, nx, ny, campaign_kind(m, 3));
    }
    scale(m, P, n);
}

/* Grid points with a little unevenness. */
void campaign_data(campaign_maker *m, double *P, size_t nx, size_t ny)
{
    const size_t n = nx * ny, style = m->category == ET_CATEGORY_SIZE ? 1 : campaign_pick(m, 3);
    for (size_t i = 0; i < n; i++) {
        P[3 * i] = (double)(i / ny) + 0.03125 * coordinate(m, style);
        P[3 * i + 1] = (ny > 1 ? (double)(i % ny) : 0.0) + 0.03125 * coordinate(m, style);
        P[3 * i + 2] = 0.25 * coordinate(m, style);
    }
    if (m->category == ET_CATEGORY_DEGENERATE) {
        degenerate(m, P, nx, ny, campaign_kind(m, 8));
    }
    if (m->category == ET_CATEGORY_SEAM) {
        campaign_close(P, nx, ny, campaign_kind(m, 3));
    }
    scale(m, P, n);
}

static double weight(campaign_maker *m, size_t kind, size_t i)
{
    switch (kind) {
    case 0: return i != 1 ? 1.0 : m->op == ET_OP_SURFACE_NEAREST ? 1e4 : 1e16;       /* ratio 1e16; the nearest point is then beyond certainty */
    case 1: return ldexp(campaign_real(m, 0.5, 2.0), -1000);         /* all tiny */
    case 2: return 7.0;                                              /* equal: a polynomial in disguise */
    case 3: return i % 2 ? 0x1.6a09e667f3bcdp-1 : 1.0;               /* arcs */
    case 4: return i % 3 == 0 ? 1e-16 : 1.0;
    case 5: return ldexp(1.0, (int)campaign_pick(m, 41) - 20);
    case 6: return i == 0 ? 1e-8 : 1e8;
    default: return i == 1 ? 0.0 : 1.0;                              /* implementation-defined */
    }
}

double *campaign_weights(campaign_maker *m, size_t n)
{
    double *w = campaign_array(m, n);
    const size_t style = campaign_pick(m, 3);
    for (size_t i = 0; i < n; i++) {
        if (m->category == ET_CATEGORY_WEIGHTS) {
            w[i] = weight(m, m->exact ? 5 : campaign_kind(m, 8), i);
        } else if (m->exact || style == 0 || m->category == ET_CATEGORY_SIZE) {
            w[i] = 0.25 * (double)(1 + campaign_pick(m, 8));
        } else {
            w[i] = style == 1 ? campaign_real(m, 0.5, 2.0) : campaign_pick(m, 2) ? 1.0 : campaign_real(m, 0.125, 4.0);
        }
    }
    return w;
}
