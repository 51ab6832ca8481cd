#include "etalon/base/real.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/surface.h"
#include "surface_parts.h"
#include <math.h>

/* Of one direction: the functions that are not zero, N; their derivatives times the span's width and over p, which no scale of the knots lets
 * overflow, dN; and the sums of the magnitudes of what those are made of, size.  One after the other in a workspace. */
typedef struct {
    double *N, *dN, *size;
    size_t first, most;                   /* the first function, and the greatest of the p + 1 */
} functions;

/* Eq. 2.7 without its factor p: N_{i,p-1}/(u_{i+p} - u_i) less the same of the next; each term has 6p - 1 roundings at most. */
static void derivatives(functions *f, const double *u, size_t nu, size_t p, size_t span, double x, double *room, size_t nroom)
{
    double width = u[span + 1] - u[span], before = 0.0;
    if (p > 0) {
        et_basis_eval(f->dN, u + 1, nu - 2, p - 1, span - 1, x, room, nroom);
    }
    for (size_t r = 0; r <= p; r++) {
        /* The function of degree p - 1 that follows function r. */
        size_t i = span - p + r + 1;
        double next = r < p ? f->dN[r] * (width / (u[i + p] - u[i])) : 0.0;
        f->dN[r] = before - next;
        f->size[r] = before + next;
        before = next;
    }
}

/* In the first 3 (p + 1) doubles of the workspace; the basis works behind them. */
static functions functions_at(const double *u, size_t nu, size_t p, double x, double *work, size_t nwork)
{
    size_t span = et_knots_span(u, nu, p, x), rows = 3 * (p + 1);
    functions f = {work, work + p + 1, work + 2 * (p + 1), span - p, 0};
    et_basis_eval(f.N, u, nu, p, span, x, work + rows, nwork - rows);
    derivatives(&f, u, nu, p, span, x, work + rows, nwork - rows);
    for (size_t r = 1; r <= p; r++) {
        f.most = f.N[r] > f.N[f.most] ? r : f.most;
    }
    return f;
}

/* The control points of one parameter as seen from that of the greatest share, all times 2^-exponent and weights times 2^-weight: the greatest
 * coordinate and the greatest weight are from 1/2 to 1.  Where all that matter coincide, as at a pole, what follows is 0 and not its roundings. */
typedef struct {
    const et_surface *s;
    et_vec3 origin;
    size_t first;
    int exponent, weight;
} view;

static double greatest(et_vec3 P)
{
    return fmax(fabs(P.x), fmax(fabs(P.y), fabs(P.z)));
}

static et_vec3 scaled(et_vec3 P, int exponent)
{
    return (et_vec3){ldexp(P.x, exponent), ldexp(P.y, exponent), ldexp(P.z, exponent)};
}

static view view_of(const et_surface *s, const functions *f, const functions *g)
{
    size_t first = f->first * s->nv + g->first;
    view w = {.s = s, .origin = s->points[first + f->most * s->nv + g->most], .first = first};
    double most = 0.0, weight = 0.0;
    for (size_t k = 0; k < (s->p + 1) * (s->q + 1); k++) {
        size_t index = first + k / (s->q + 1) * s->nv + k % (s->q + 1);
        most = fmax(most, greatest(s->points[index]));
        if (s->weights) {
            weight = fmax(weight, s->weights[index]);
        }
    }
    frexp(most, &w.exponent);
    frexp(weight, &w.weight);
    w.origin = scaled(w.origin, -w.exponent);
    return w;
}

static surface_point seen(const view *w, size_t index)
{
    et_vec3 P = scaled(w->s->points[index], -w->exponent), O = w->origin;
    double weight = w->s->weights ? ldexp(w->s->weights[index], -w->weight) : 1.0;
    return (surface_point){weight * (P.x - O.x), weight * (P.y - O.y), weight * (P.z - O.z), weight};
}

static surface_point magnitude(surface_point h)
{
    return (surface_point){fabs(h.x), fabs(h.y), fabs(h.z), h.w};
}

/* A vector and the magnitudes of what its coordinates are sums of. */
typedef struct { surface_point value, size; } sums;

static void accumulate(sums *t, double a, double size, surface_point h, surface_point m)
{
    t->value = surface_add(t->value, surface_scale(a, h));
    t->size = surface_add(t->size, surface_scale(size, m));
}

/* S w, and its derivatives along u and v, each within 7(p+q) + 2 roundings of its sizes. */
static void contract(sums out[3], const view *w, const functions *f, const functions *g)
{
    const sums zero = {{0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}};
    out[0] = out[1] = out[2] = zero;
    for (size_t l = 0; l <= w->s->q; l++) {
        sums t = zero, du = zero;
        for (size_t k = 0; k <= w->s->p; k++) {
            surface_point h = seen(w, w->first + k * w->s->nv + l);
            accumulate(&t, f->N[k], f->N[k], h, magnitude(h));
            accumulate(&du, f->dN[k], f->size[k], h, magnitude(h));
        }
        accumulate(&out[0], g->N[l], g->N[l], t.value, t.size);
        accumulate(&out[1], g->N[l], g->N[l], du.value, du.size);
        accumulate(&out[2], g->dN[l], g->size[l], t.value, t.size);
    }
}

/* w A' - w' A, the direction of (A/w)', and its size, both times a power of two. */
typedef struct { et_vec3 value, size; } tangent;

static tangent tangent_of(const sums *A, const sums *D, int rational)
{
    surface_point a = A->value, d = D->value, m = A->size, n = D->size;
    tangent t = {{d.x, d.y, d.z}, {n.x, n.y, n.z}};
    if (rational) {
        t.value = (et_vec3){a.w * d.x - d.w * a.x, a.w * d.y - d.w * a.y, a.w * d.z - d.w * a.z};
        t.size = (et_vec3){m.w * n.x + n.w * m.x, m.w * n.y + n.w * m.y, m.w * n.z + n.w * m.z};
    }
    /* What underflows is below 2^-1074 a time, of numbers not above 1: with this it counts as a rounding. */
    t.size = (et_vec3){t.size.x + 0x1p-1000, t.size.y + 0x1p-1000, t.size.z + 0x1p-1000};
    int exponent;
    frexp(greatest(t.value), &exponent);
    return (tangent){scaled(t.value, -exponent), scaled(t.size, -exponent)};
}

static double length(et_vec3 c)
{
    return sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
}

et_status et_surface_normal(et_vec3 *n, const et_surface *s, double u, double v, double *work, size_t nwork)
{
    functions f = functions_at(s->u, s->nu + s->p + 1, s->p, u, work, nwork);
    functions g = functions_at(s->v, s->nv + s->q + 1, s->q, v, f.size + s->p + 1, nwork - 3 * (s->p + 1));
    view w = view_of(s, &f, &g);
    sums A[3];
    contract(A, &w, &f, &g);
    tangent a = tangent_of(&A[0], &A[1], s->weights != NULL), b = tangent_of(&A[0], &A[2], s->weights != NULL);
    et_vec3 x = a.value, y = b.value, c = {x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x};
    et_vec3 k = a.size, l = b.size, m = {k.y * l.z + k.z * l.y, k.z * l.x + k.x * l.z, k.x * l.y + k.y * l.x};
    /* A tangent has 14(p+q) + 6 roundings with weights, the difference of two products 28(p+q) + 14; the rest is for the sizes' own. */
    int exponent;               /* squares of what is far below 1 would vanish */
    frexp(greatest(c), &exponent);
    c = scaled(c, -exponent);
    double size = length(c), bound = (28.0 * (double)(s->p + s->q) + 16.0) * ET_UNIT * length(scaled(m, -exponent));
    if (!(size > bound)) {
        return ET_ERANK;
    }
    *n = (et_vec3){c.x / size, c.y / size, c.z / size};
    return ET_OK;
}
