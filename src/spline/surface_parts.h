/* surface_parts: contraction of control points with basis values: over u for each column, then over v, each sum from its first term on. */
#ifndef SPLINE_SURFACE_PARTS_H
#define SPLINE_SURFACE_PARTS_H
#include "etalon/spline/surface.h"

typedef struct { double x, y, z, w; } surface_point;

/* The columns' sums live in a workspace of doubles. */
typedef char surface_assert_point[sizeof(surface_point) == 4 * sizeof(double) ? 1 : -1];

/*@ requires s:     \valid_read(s) && \valid_read(s->points + index) && (s->weights == \null || \valid_read(s->weights + index));
    assigns  \nothing;
*/
static inline surface_point surface_lift(const et_surface *s, size_t index)
{
    et_vec3 P = s->points[index];
    double w = s->weights ? s->weights[index] : 1.0;
    return (surface_point){w * P.x, w * P.y, w * P.z, w};
}

/*@ assigns \nothing; */
static inline surface_point surface_scale(double a, surface_point h)
{
    return (surface_point){a * h.x, a * h.y, a * h.z, a * h.w};
}

/*@ assigns \nothing; */
static inline surface_point surface_add(surface_point a, surface_point b)
{
    return (surface_point){a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}

/* Where the control points of the spans i and j begin. */
/*@ requires s:     \valid_read(s) && s->p <= i < s->nu && s->q <= j < s->nv && s->nu * s->nv <= SIZE_MAX;
    assigns  \nothing;
    ensures  place: \result + s->p * s->nv + s->q < s->nu * s->nv;
*/
static inline size_t surface_first(const et_surface *s, size_t i, size_t j)
{
    //@ ghost fact_product(i + 1, s->nu, s->nv);
    //@ ghost fact_product(0, i - s->p, s->nv);
    return (i - s->p) * s->nv + j - s->q;
}

/* T[j] = sum_k N[k] (w P)[first + k*nv + j], k = 0..p, j < n. */
/*@ requires s:     \valid_read(s) && et_surface_stored((et_surface *)s);
    requires T:     \valid(T + (0 .. n - 1));
    requires N:     \valid_read(N + (0 .. s->p));
    requires place: first + s->p * s->nv + n <= s->nu * s->nv;
    assigns  T[0 .. n - 1];
*/
static inline void surface_contract_u(surface_point *T, size_t n, const double *N, const et_surface *s, size_t first)
{
    //@ ghost fact_product(0, s->p, s->nv);
    /*@ loop invariant place: j <= n;
        loop assigns j, T[0 .. n - 1];
        loop variant n - j;
    */
    for (size_t j = 0; j < n; j++) {
        T[j] = surface_scale(N[0], surface_lift(s, first + j));
        /*@ loop invariant place: 1 <= k <= s->p + 1;
            loop assigns k, T[0 .. n - 1];
            loop variant s->p - k;
        */
        for (size_t k = 1; k <= s->p; k++) {
            //@ ghost fact_product(k, s->p, s->nv);
            T[j] = surface_add(T[j], surface_scale(N[k], surface_lift(s, first + k * s->nv + j)));
        }
    }
}

/*@ requires T:     \valid_read(T + (0 .. q));
    requires N:     \valid_read(N + (0 .. q));
    requires count: q < SIZE_MAX;
    assigns  \nothing;
*/
static inline surface_point surface_contract_v(const surface_point *T, const double *N, size_t q)
{
    surface_point S = surface_scale(N[0], T[0]);
    /*@ loop invariant place: 1 <= l <= q + 1;
        loop assigns l, S;
        loop variant q - l;
    */
    for (size_t l = 1; l <= q; l++) {
        S = surface_add(S, surface_scale(N[l], T[l]));
    }
    return S;
}

/*@ assigns \nothing; */
static inline et_vec3 surface_project(surface_point S, int rational)
{
    return rational ? (et_vec3){S.x / S.w, S.y / S.w, S.z / S.w} : (et_vec3){S.x, S.y, S.z};
}
#endif
