#include "etalon/spline/surface.h"
#include "etalon/base/size.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- storage ---- */

int et_surface_valid(const et_surface *s)
{
    size_t n;
    if (!s->u || !s->v || !s->points || s->p > SIZE_MAX - s->nu || s->q > SIZE_MAX - s->nv || s->nu + s->p == SIZE_MAX || s->nv + s->q == SIZE_MAX) {
        return 0;
    }
    if (et_size_mul(&n, s->nu, s->nv) != ET_OK || !et_knots_valid(s->u, s->nu + s->p + 1, s->p) || !et_knots_valid(s->v, s->nv + s->q + 1, s->q)) {
        return 0;
    }
    for (size_t i = 0; s->weights && i < n; i++) {
        if (!isfinite(s->weights[i]) || !(s->weights[i] > 0.0)) {
            return 0;
        }
    }
    return et_vec3_finite(s->points, n);
}

et_status et_surface_new(et_surface *s, size_t p, size_t q, size_t nu, size_t nv, int rational)
{
    size_t n;
    if (nu == 0 || nv == 0 || nu - 1 < p || nv - 1 < q) {
        return ET_EINVAL;
    }
    if (p > SIZE_MAX - nu || q > SIZE_MAX - nv || nu + p == SIZE_MAX || nv + q == SIZE_MAX || et_size_mul(&n, nu, nv) != ET_OK) {
        return ET_ENOMEM;
    }
    et_surface t = {p, q, nu, nv, et_size_array(nu + p + 1, sizeof(double)), et_size_array(nv + q + 1, sizeof(double)),
                    et_size_array(n, sizeof(et_vec3)), rational ? et_size_array(n, sizeof(double)) : NULL};
    if (!t.u || !t.v || !t.points || (rational && !t.weights)) {
        et_surface_free(&t);
        return ET_ENOMEM;
    }
    for (size_t i = 0; rational && i < n; i++) {
        t.weights[i] = 1.0;
    }
    *s = t;
    return ET_OK;
}

et_status et_surface_copy(et_surface *copy, const et_surface *s)
{
    et_surface t;
    et_status status = et_surface_new(&t, s->p, s->q, s->nu, s->nv, s->weights != NULL);
    if (status != ET_OK) {
        return status;
    }
    size_t n = s->nu * s->nv;
    memcpy(t.u, s->u, (s->nu + s->p + 1) * sizeof *t.u);
    memcpy(t.v, s->v, (s->nv + s->q + 1) * sizeof *t.v);
    memcpy(t.points, s->points, n * sizeof *t.points);
    if (s->weights) {
        memcpy(t.weights, s->weights, n * sizeof *t.weights);
    }
    *copy = t;
    return ET_OK;
}

void et_surface_free(et_surface *s)
{
    free(s->u);
    free(s->v);
    free(s->points);
    free(s->weights);
    *s = (et_surface){0, 0, 0, 0, NULL, NULL, NULL, NULL};
}

/* ---- contraction: over u for each column, then over v, each sum from its first term on ---- */

typedef struct { double x, y, z, w; } homogeneous;

static homogeneous lift(const et_surface *s, size_t index)
{
    et_vec3 P = s->points[index];
    double w = s->weights ? s->weights[index] : 1.0;
    return (homogeneous){w * P.x, w * P.y, w * P.z, w};
}

static homogeneous scale(double a, homogeneous h)
{
    return (homogeneous){a * h.x, a * h.y, a * h.z, a * h.w};
}

static homogeneous add(homogeneous a, homogeneous b)
{
    return (homogeneous){a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}

/* T[j] = sum_k N[k] (w P)[first + k*nv + j], k = 0..p, j < n. */
static void contract_u(homogeneous *T, size_t n, const double *N, const et_surface *s, size_t first)
{
    for (size_t j = 0; j < n; j++) {
        T[j] = scale(N[0], lift(s, first + j));
        for (size_t k = 1; k <= s->p; k++) {
            T[j] = add(T[j], scale(N[k], lift(s, first + k * s->nv + j)));
        }
    }
}

static homogeneous contract_v(const homogeneous *T, const double *N, size_t q)
{
    homogeneous S = scale(N[0], T[0]);
    for (size_t l = 1; l <= q; l++) {
        S = add(S, scale(N[l], T[l]));
    }
    return S;
}

static et_vec3 project(homogeneous S, int rational)
{
    return rational ? (et_vec3){S.x / S.w, S.y / S.w, S.z / S.w} : (et_vec3){S.x, S.y, S.z};
}

/* ---- one point ---- */

/* The workspace in doubles: three rows of basis values a direction, three of column sums, the basis' own room. */
typedef struct {
    double *N, *M, *basis;
    homogeneous *T;
    size_t nbasis;
} room;

/* The columns' sums live in the doubles' workspace. */
typedef char et_surface_assert_homogeneous[sizeof(homogeneous) == 4 * sizeof(double) ? 1 : -1];

static size_t greater(size_t a, size_t b)
{
    return a > b ? a : b;
}

static size_t basis_work(const et_surface *s)
{
    return greater(et_basis_work(s->p, 2), et_basis_work(s->q, 2));
}

size_t et_surface_work(const et_surface *s)
{
    return 3 * (s->p + 1) + 15 * (s->q + 1) + basis_work(s);
}

static room divide(const et_surface *s, double *work)
{
    double *T = work + 3 * (s->p + 1) + 3 * (s->q + 1);
    return (room){work, work + 3 * (s->p + 1), T + 12 * (s->q + 1), (homogeneous *)T, basis_work(s)};
}

et_vec3 et_surface_point(const et_surface *s, double u, double v, double *work, size_t nwork)
{
    size_t nu = s->nu + s->p + 1, nv = s->nv + s->q + 1;
    room r = divide(s, work);
    (void)nwork;
    size_t i = et_knots_span(s->u, nu, s->p, u);
    size_t j = et_knots_span(s->v, nv, s->q, v);
    et_basis_eval(r.N, s->u, nu, s->p, i, u, r.basis, r.nbasis);
    et_basis_eval(r.M, s->v, nv, s->q, j, v, r.basis, r.nbasis);
    contract_u(r.T, s->q + 1, r.N, s, (i - s->p) * s->nv + j - s->q);
    return project(contract_v(r.T, r.M, s->q), s->weights != NULL);
}

/* (A - a S) with the homogeneous derivative A and a number a. */
static et_vec3 less(et_vec3 A, double a, et_vec3 S)
{
    return (et_vec3){A.x - a * S.x, A.y - a * S.y, A.z - a * S.z};
}

static et_vec3 over(et_vec3 A, double w)
{
    return (et_vec3){A.x / w, A.y / w, A.z / w};
}

/* Eq. 4.20: from the homogeneous derivatives A, in the order of D, to those of the quotient. */
static void quotient(et_vec3 D[6], const homogeneous A[6])
{
    et_vec3 B[6];
    for (size_t k = 0; k < 6; k++) {
        B[k] = (et_vec3){A[k].x, A[k].y, A[k].z};
    }
    double w = A[0].w, wu = A[1].w, wv = A[2].w;
    D[0] = over(B[0], w);
    D[1] = over(less(B[1], wu, D[0]), w);
    D[2] = over(less(B[2], wv, D[0]), w);
    D[3] = over(less(less(B[3], 2.0 * wu, D[1]), A[3].w, D[0]), w);
    D[4] = over(less(less(less(B[4], wu, D[2]), wv, D[1]), A[4].w, D[0]), w);
    D[5] = over(less(less(B[5], 2.0 * wv, D[2]), A[5].w, D[0]), w);
}

void et_surface_ders(et_vec3 D[6], const et_surface *s, double u, double v, double *work, size_t nwork)
{
    static const size_t du[6] = {0, 1, 0, 2, 1, 0}, dv[6] = {0, 0, 1, 0, 1, 2};
    size_t nu = s->nu + s->p + 1, nv = s->nv + s->q + 1, n = s->q + 1;
    homogeneous A[6];
    room r = divide(s, work);
    (void)nwork;
    size_t i = et_knots_span(s->u, nu, s->p, u);
    size_t j = et_knots_span(s->v, nv, s->q, v);
    et_basis_ders(r.N, 2, s->u, nu, s->p, i, u, r.basis, r.nbasis);
    et_basis_ders(r.M, 2, s->v, nv, s->q, j, v, r.basis, r.nbasis);
    for (size_t k = 0; k < 3; k++) {
        contract_u(r.T + k * n, n, r.N + k * (s->p + 1), s, (i - s->p) * s->nv + j - s->q);
    }
    for (size_t k = 0; k < 6; k++) {
        A[k] = contract_v(r.T + du[k] * n, r.M + dv[k] * n, s->q);
    }
    if (s->weights) {
        quotient(D, A);
        return;
    }
    for (size_t k = 0; k < 6; k++) {
        D[k] = project(A[k], 0);
    }
}

/* ---- many points ---- */

void et_surface_points(et_vec3 *S, const et_surface *s, const double *u, const double *v, size_t n, double *work, size_t nwork)
{
    for (size_t k = 0; k < n; k++) {
        S[k] = et_surface_point(s, u[k], v[k], work, nwork);
    }
}

et_status et_surface_grid(et_vec3 *S, const et_surface *s, const double *a, size_t na, const double *b, size_t nb)
{
    size_t nwork = et_surface_work(s);
    double *work = et_size_array(nwork, sizeof *work);
    if (!work) {
        return ET_ENOMEM;
    }
    for (size_t i = 0; i < na; i++) {
        for (size_t j = 0; j < nb; j++) {
            S[i * nb + j] = et_surface_point(s, a[i], b[j], work, nwork);
        }
    }
    free(work);
    return ET_OK;
}
