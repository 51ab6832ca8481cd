/* surfaces: drawing surfaces, and their points and derivatives by the definition, for the tests of what surfaces do. */
#ifndef TESTS_SPLINE_SURFACES_H
#define TESTS_SPLINE_SURFACES_H
#include "curves.h"
#include "etalon/spline/surface.h"

enum { SURFACE_DEGREE = 4 };

/* A surface of degrees p, q up to SURFACE_DEGREE; cubic and polynomial often, as the fast ways are.  Clamped unless `free_ends`. */
static inline bool draw_surface(gen *g, et_surface *s, bool free_ends)
{
    bool cubic = gen_upto(g, 1) == 0, rational = gen_upto(g, 2) == 2;
    size_t p = cubic ? 3 : (size_t)gen_upto(g, SURFACE_DEGREE), q = cubic || gen_chance(g, 3) ? 3 : (size_t)gen_upto(g, SURFACE_DEGREE);
    size_t nu = p + 1 + (size_t)gen_upto(g, 6), nv = q + 1 + (size_t)gen_upto(g, 6);
    if (et_surface_new(s, p, q, nu, nv, rational) != ET_OK) {
        return false;
    }
    gen_points(g, &s->points[0].x, nu * nv);
    for (size_t i = 0; rational && i < nu * nv; i++) {
        s->weights[i] = gen_real(g, 0.25, 4.0);
    }
    if (free_ends) {
        ref_draw_knots(g, s->u, nu + p + 1, p);
        ref_draw_knots(g, s->v, nv + q + 1, q);
    } else {
        gen_knots(g, s->u, nu + p + 1, p);
        gen_knots(g, s->v, nv + q + 1, q);
    }
    gen_note(g, "p = %zu, q = %zu, %zu x %zu, %s", p, q, nu, nv, rational ? "rational" : "polynomial");
    if (!et_surface_valid(s)) {
        et_surface_free(s);
        return false;
    }
    return true;
}

static inline double draw_u(gen *g, const et_surface *s)
{
    return gen_parameter(g, s->u, s->nu + s->p + 1, s->p);
}

static inline double draw_v(gen *g, const et_surface *s)
{
    return gen_parameter(g, s->v, s->nv + s->q + 1, s->q);
}

static inline double *surface_room(const et_surface *s)
{
    return et_size_array(et_surface_work(s) + 1, sizeof(double));
}

static inline et_vec3 surface_at(const et_surface *s, double u, double v)
{
    double *work = surface_room(s);
    et_vec3 S = et_surface_point(s, u, v, work, et_surface_work(s));
    free(work);
    return S;
}

/* The sums over all control points of a derivative of the basis times w, w x, w y, w z, and of the terms' magnitudes. */
static inline sums surface_brute(const et_surface *s, double u, double v, size_t du, size_t dv)
{
    double N[REF_KNOTS], NM[REF_KNOTS], M[REF_KNOTS], MM[REF_KNOTS];
    sums t = {{0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}};
    ref_derivative(N, NM, s->u, s->nu + s->p + 1, s->p, u, du);
    ref_derivative(M, MM, s->v, s->nv + s->q + 1, s->q, v, dv);
    for (size_t j = s->nv; j-- > 0;) {
        for (size_t i = s->nu; i-- > 0;) {
            size_t k = i * s->nv + j;
            double w = s->weights ? s->weights[k] : 1.0;
            for (int a = 0; a < 4; a++) {
                double c = a == 0 ? w : w * coordinate(&s->points[k], a - 1);
                t.value[a] += N[i] * M[j] * c;
                t.size[a] += NM[i] * MM[j] * fabs(c);
            }
        }
    }
    return t;
}

/* Roundings of ours and of the brute way together, values and derivatives, first order and a bit. */
static inline double surface_slack(const et_surface *s)
{
    double p = (double)s->p, q = (double)s->q;
    return (7.0 * (p + q) + 12.0 + 6.0 * (p + q) + (p + 1.0) * (q + 1.0) + 8.0) * ET_UNIT * (1.0 + 0x1p-40);
}

/* The surface at (u, v) of the domain, from those sides, in double-double. */
static inline fine fine_surface(const et_surface *s, double u, double v, et_side side_u, et_side side_v)
{
    fine h[32], T[32];
    size_t i = et_knots_span_side(s->u, s->nu + s->p + 1, s->p, u, side_u), j = et_knots_span_side(s->v, s->nv + s->q + 1, s->q, v, side_v);
    for (size_t l = 0; l <= s->q; l++) {
        for (size_t k = 0; k <= s->p; k++) {
            size_t at = (i - s->p + k) * s->nv + j - s->q + l;
            h[k] = fine_lift(s->points[at], s->weights ? s->weights[at] : 1.0);
        }
        T[l] = fine_deboor(h, s->u, s->p, i, u);
    }
    return fine_deboor(T, s->v, s->q, j, v);
}

static inline bool same_surface(const et_surface *a, const et_surface *b)
{
    return a->p == b->p && a->q == b->q && a->nu == b->nu && a->nv == b->nv && !a->weights == !b->weights &&
           !memcmp(a->u, b->u, (a->nu + a->p + 1) * sizeof *a->u) && !memcmp(a->v, b->v, (a->nv + a->q + 1) * sizeof *a->v) &&
           !memcmp(a->points, b->points, a->nu * a->nv * sizeof *a->points) &&
           (!a->weights || !memcmp(a->weights, b->weights, a->nu * a->nv * sizeof *a->weights));
}

/* p, q, nu, nv, rational; knots u, v; points; weights if rational.  Returns the place of the next argument, 0 if memory is short. */
static inline size_t read_surface(const row *r, et_surface *s)
{
    size_t at = 5;
    if (et_surface_new(s, row_size(r, 0), row_size(r, 1), row_size(r, 2), row_size(r, 3), (int)row_size(r, 4)) != ET_OK) {
        return 0;
    }
    for (size_t i = 0; i <= s->nu + s->p; i++) {
        s->u[i] = row_real(r, at++);
    }
    for (size_t i = 0; i <= s->nv + s->q; i++) {
        s->v[i] = row_real(r, at++);
    }
    for (size_t i = 0; i < s->nu * s->nv; i++, at += 3) {
        s->points[i] = (et_vec3){row_real(r, at), row_real(r, at + 1), row_real(r, at + 2)};
    }
    for (size_t i = 0; s->weights && i < s->nu * s->nv; i++) {
        s->weights[i] = row_real(r, at++);
    }
    return at;
}

#endif
