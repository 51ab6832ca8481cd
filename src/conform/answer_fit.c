/* answer_fit: least squares by the fast library's band and dense solvers, and approximation of a grid. */
#include "conform/answer_parts.h"
#include "etalon/base/size.h"
#include "etalon/exact/exact.h"
#include "etalon/fit/knotrule.h"
#include "etalon/fit/linalg.h"
#include "etalon/fit/param.h"
#include "etalon/spline/basis.h"
#include <stdlib.h>
#include <string.h>

/* One direction's collocation matrix: row k has p + 1 entries from column start[k], rows sorted by parameter; order[k] is the datum's number. */
typedef struct {
    size_t m, n, w;
    double *a;
    size_t *start, *order;
} rows;

static void rows_free(rows *r)
{
    free(r->a);
    free(r->start);
    free(r->order);
}

typedef struct { double t; size_t at; } site;

static int by_parameter(const void *a, const void *b)
{
    const site *s = a, *t = b;

    return s->t != t->t ? (s->t > t->t) - (s->t < t->t) : (s->at > t->at) - (s->at < t->at);
}

static et_status rows_make(rows *r, const double *u, size_t nu, size_t p, const double *t, size_t m)
{
    const size_t nwork = et_basis_work(p, 0);
    double *work = et_size_array(nwork, sizeof *work);
    site *sites = et_size_array(m, sizeof *sites);
    const rows made = { m, nu - p - 1, p + 1, et_size_array(m, (p + 1) * sizeof(double)), et_size_array(m, sizeof(size_t)),
                        et_size_array(m, sizeof(size_t)) };
    const int ok = work && sites && made.a && made.start && made.order;

    *r = made;
    for (size_t k = 0; ok && k < m; k++)
        sites[k] = (site){ t[k], k };
    if (ok)
        qsort(sites, m, sizeof *sites, by_parameter);
    for (size_t k = 0; ok && k < m; k++) {
        const size_t span = et_knots_span(u, nu, p, sites[k].t);
        et_basis_eval(r->a + k * r->w, u, nu, p, span, sites[k].t, work, nwork);
        r->start[k] = span - p;
        r->order[k] = sites[k].at;
    }
    free(work);
    free(sites);
    if (!ok)
        rows_free(r);
    return ok ? ET_OK : ET_ENOMEM;
}

/* X (n x k) from B (m x k), whose rows are in the data's order. */
static et_status rows_solve(double *X, const rows *r, const double *B, size_t k)
{
    double *sorted = et_size_array(r->m, k * sizeof *sorted);
    size_t rank;

    if (!sorted)
        return ET_ENOMEM;
    for (size_t i = 0; i < r->m; i++)
        memcpy(sorted + i * k, B + r->order[i] * k, k * sizeof *sorted);
    const et_status status = et_linalg_band_lsq(X, &rank, r->a, r->start, r->m, r->n, r->w, sorted, k, ET_LINALG_QR);
    free(sorted);
    return status;
}

/* How the others move when the first and the last unknown do: E (n x 2), the least |A e| with those two given: 1, 0 and 0, 1. */
static et_status rows_ends(double *E, const rows *r)
{
    const size_t inner = r->n - 2;
    double *A = et_size_array(r->m, inner * sizeof *A), *B = et_size_array(r->m, 2 * sizeof *B);
    size_t rank;
    et_status status = A && B ? ET_OK : ET_ENOMEM;

    memset(E, 0, 2 * r->n * sizeof *E);
    E[0] = E[2 * r->n - 1] = 1;
    for (size_t i = 0; status == ET_OK && i < r->m; i++)
        for (size_t k = 0; k < r->w; k++) {
            const size_t c = r->start[i] + k;
            if (c == 0 || c == r->n - 1)
                B[2 * i + (c != 0)] = -r->a[i * r->w + k];
            else
                A[i * inner + c - 1] = r->a[i * r->w + k];
        }
    if (status == ET_OK && inner > 0)
        status = et_linalg_lsq(E + 2, &rank, A, r->m, inner, B, 2, ET_LINALG_QR);
    free(A);
    free(B);
    return status;
}

static void transpose(et_vec3 *T, const et_vec3 *P, size_t n, size_t m)
{
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < m; j++)
            T[j * n + i] = P[i * m + j];
}

static double *coordinate(et_vec3 *P, size_t c)
{
    return c == 0 ? &P->x : c == 1 ? &P->y : &P->z;
}

/* The least sum of squares with the corners at the data's: what the corners are moved by moves the others along. */
static et_status hold_corners(et_vec3 *P, const rows *u, const rows *v, et_vec3 *D)
{
    double *U = et_size_array(u->n, 2 * sizeof *U), *V = et_size_array(v->n, 2 * sizeof *V);
    et_status status = U && V ? rows_ends(U, u) : ET_ENOMEM;

    if (status == ET_OK)
        status = rows_ends(V, v);
    for (size_t c = 0; status == ET_OK && c < 3; c++) {
        double to[4], by[4];
        for (size_t e = 0; e < 4; e++) {
            to[e] = *coordinate(&D[e / 2 * (u->m - 1) * v->m + e % 2 * (v->m - 1)], c);
            by[e] = to[e] - *coordinate(&P[e / 2 * (u->n - 1) * v->n + e % 2 * (v->n - 1)], c);
        }
        for (size_t i = 0; i < u->n; i++)
            for (size_t j = 0; j < v->n; j++) {
                double *x = coordinate(&P[i * v->n + j], c);
                for (size_t e = 0; e < 4; e++)
                    *x += U[2 * i + e / 2] * by[e] * V[2 * j + e % 2];
            }
        for (size_t e = 0; e < 4; e++)
            *coordinate(&P[e / 2 * (u->n - 1) * v->n + e % 2 * (v->n - 1)], c) = to[e];
    }
    free(U);
    free(V);
    return status;
}

/* P (n_u x n_v) from D (m_u x m_v): along u first, then along v. */
static et_status solve_grid(et_vec3 *P, const rows *u, const rows *v, et_vec3 *D, int corners)
{
    et_vec3 *X = et_size_array(u->n, v->m * sizeof *X), *T = et_size_array(u->n, v->m * sizeof *T), *Y = et_size_array(u->n, v->n * sizeof *Y);
    et_status status = X && T && Y ? rows_solve(&X->x, u, &D->x, 3 * v->m) : ET_ENOMEM;

    if (status == ET_OK) {
        transpose(T, X, u->n, v->m);
        status = rows_solve(&Y->x, v, &T->x, 3 * u->n);
    }
    if (status == ET_OK) {
        transpose(P, Y, v->n, u->n);
        if (corners)
            status = hold_corners(P, u, v, D);
    }
    free(X);
    free(T);
    free(Y);
    return status;
}

static et_status fit_grid(et_vec3 *P, const double *u, size_t ku, size_t p, const double *v, size_t kv, size_t q, const double *s, size_t mu,
                          const double *r, size_t mv, et_vec3 *D, int corners)
{
    rows a, b;
    et_status status = rows_make(&a, u, ku, p, s, mu);

    if (status != ET_OK)
        return status;
    status = rows_make(&b, v, kv, q, r, mv);
    if (status == ET_OK) {
        status = solve_grid(P, &a, &b, D, corners);
        rows_free(&b);
    }
    rows_free(&a);
    return status;
}

/* Row k: all products of the functions at (a_k, b_k). */
static et_status fit_scattered(et_vec3 *P, const et_request_value *a)
{
    const size_t p = a[0].count, q = a[1].count, m = a[4].count, nu = a[2].count - p - 1, nv = a[3].count - q - 1;
    const size_t work_u = et_basis_work(p, 0), work_v = et_basis_work(q, 0), nwork = work_u > work_v ? work_u : work_v;
    size_t rank, size = 0;
    double *A = et_size_mul(&size, nu, nv) == ET_OK && et_size_mul(&size, size, m) == ET_OK ? et_size_array(size, sizeof *A) : NULL;
    double *work = et_size_array(nwork, sizeof *work), *N = et_size_array(p + q + 2, sizeof *N);
    et_status status = A && work && N ? ET_OK : ET_ENOMEM;

    for (size_t k = 0; status == ET_OK && k < m; k++) {
        const size_t i = et_knots_span(a[2].x, a[2].count, p, a[4].x[k]), j = et_knots_span(a[3].x, a[3].count, q, a[5].x[k]);
        et_basis_eval(N, a[2].x, a[2].count, p, i, a[4].x[k], work, nwork);
        et_basis_eval(N + p + 1, a[3].x, a[3].count, q, j, a[5].x[k], work, nwork);
        for (size_t g = 0; g <= p; g++)
            for (size_t h = 0; h <= q; h++)
                A[k * nu * nv + (i - p + g) * nv + j - q + h] = N[g] * N[p + 1 + h];
    }
    if (status == ET_OK)
        status = et_linalg_lsq(&P->x, &rank, A, m, nu * nv, a[6].x, 3, ET_LINALG_QR);
    free(A);
    free(work);
    free(N);
    return status;
}

static et_status fit_curve(et_vec3 *P, const et_request_value *a)
{
    rows r;
    et_status status = rows_make(&r, a[1].x, a[1].count, a[0].count, a[2].x, a[2].count);

    if (status == ET_OK) {
        status = rows_solve(&P->x, &r, a[3].x, 3);
        rows_free(&r);
    }
    return status;
}

et_status answer_fit(et_reply *reply, const et_request *request)
{
    const int curve = request->op == ET_OP_FIT_CURVE;
    const et_request_value *a = request->arg + (request->op == ET_OP_FIT_GRID);
    const size_t nu = a[curve ? 1 : 2].count - a[0].count - 1, nv = curve ? 1 : a[3].count - a[1].count - 1, n = nu * nv;
    et_vec3 *P = et_size_array(n, sizeof *P);
    et_status status;

    if (!P)
        return ET_ENOMEM;
    if (curve)
        status = fit_curve(P, a);
    else if (request->op == ET_OP_FIT_SCATTERED)
        status = fit_scattered(P, a);
    else
        status = fit_grid(P, a[2].x, a[2].count, a[0].count, a[3].x, a[3].count, a[1].count, a[4].x, a[4].count, a[5].x, a[5].count,
                          (et_vec3 *)a[6].x, request->arg[0].count == 1);
    if (status == ET_OK)
        status = et_reply_put(reply, &P->x, 3 * n);
    free(P);
    return status;
}

/* ---- approximation ---- */

static et_status sites(double *s, size_t mx, double *r, size_t my, const et_vec3 *D, et_param_method method, int exact)
{
    size_t flat;

    return exact ? et_exact_param_grid(s, mx, r, my, &flat, D, method, NULL) : et_param_grid(s, mx, r, my, &flat, D, method);
}

static et_status knots(double *u, size_t n, size_t p, const double *t, size_t m, int exact)
{
    return exact ? et_exact_knotrule_make(u, n + p + 1, p, t, m, ET_KNOTRULE_PIEGL) : et_knotrule_make(u, n + p + 1, p, t, m, ET_KNOTRULE_PIEGL);
}

/* The surface has its sizes; t: room for mx + my parameters. */
static et_status approximate(et_surface *s, double *t, size_t mx, size_t my, et_vec3 *D, et_param_method method, int exact)
{
    et_exact_lsq lsq;
    et_status status = sites(t, mx, t + mx, my, D, method, exact);

    if (status == ET_OK)
        status = knots(s->u, s->nu, s->p, t, mx, exact);
    if (status == ET_OK)
        status = knots(s->v, s->nv, s->q, t + mx, my, exact);
    if (status != ET_OK)
        return status;
    status = exact ? et_exact_fit_grid(s->points, s->nu, s->nv, &lsq, s->u, s->p, s->v, s->q, t, mx, t + mx, my, D, 0)
                   : fit_grid(s->points, s->u, s->nu + s->p + 1, s->p, s->v, s->nv + s->q + 1, s->q, t, mx, t + mx, my, D, 0);
    return status != ET_OK || et_surface_valid(s) ? status : ET_EFORMAT;
}

et_status answer_approximate(et_reply *reply, const et_request *request, int exact)
{
    const et_request_value *a = request->arg;
    const size_t mx = a[4].count, my = a[5].count;
    et_surface s;
    et_status status = et_surface_new(&s, a[0].count, a[1].count, a[2].count, a[3].count, 0);

    if (status != ET_OK)
        return status;
    double *t = et_size_array(mx + my, sizeof *t);
    status = t ? approximate(&s, t, mx, my, (et_vec3 *)a[6].x, ET_PARAM_CHORD, exact) : ET_ENOMEM;
    if (status != ET_OK && status != ET_ENOMEM)
        status = approximate(&s, t, mx, my, (et_vec3 *)a[6].x, ET_PARAM_UNIFORM, exact);
    if (status == ET_OK)
        status = et_reply_put_surface(reply, &s);
    free(t);
    et_surface_free(&s);
    return status;
}
