/* surface_parts: contraction of control points with basis values: over u for each column, then over v, each sum from its first term on. */
#ifndef SPLINE_SURFACE_PARTS_H
#define SPLINE_SURFACE_PARTS_H
#include "etalon/spline/surface.h"

typedef struct { double x, y, z, w; } surface_point;

/* The columns' sums live in a workspace of doubles. */
typedef char surface_assert_point[sizeof(surface_point) == 4 * sizeof(double) ? 1 : -1];

static inline surface_point surface_lift(const et_surface *s, size_t index)
{
    et_vec3 P = s->points[index];
    double w = s->weights ? s->weights[index] : 1.0;
    return (surface_point){w * P.x, w * P.y, w * P.z, w};
}

static inline surface_point surface_scale(double a, surface_point h)
{
    return (surface_point){a * h.x, a * h.y, a * h.z, a * h.w};
}

static inline surface_point surface_add(surface_point a, surface_point b)
{
    return (surface_point){a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}

/* T[j] = sum_k N[k] (w P)[first + k*nv + j], k = 0..p, j < n. */
static inline void surface_contract_u(surface_point *T, size_t n, const double *N, const et_surface *s, size_t first)
{
    for (size_t j = 0; j < n; j++) {
        T[j] = surface_scale(N[0], surface_lift(s, first + j));
        for (size_t k = 1; k <= s->p; k++) {
            T[j] = surface_add(T[j], surface_scale(N[k], surface_lift(s, first + k * s->nv + j)));
        }
    }
}

static inline surface_point surface_contract_v(const surface_point *T, const double *N, size_t q)
{
    surface_point S = surface_scale(N[0], T[0]);
    for (size_t l = 1; l <= q; l++) {
        S = surface_add(S, surface_scale(N[l], T[l]));
    }
    return S;
}

static inline et_vec3 surface_project(surface_point S, int rational)
{
    return rational ? (et_vec3){S.x / S.w, S.y / S.w, S.z / S.w} : (et_vec3){S.x, S.y, S.z};
}
#endif
