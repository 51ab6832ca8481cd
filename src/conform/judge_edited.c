/* judge_edited: what is right of edited curves and surfaces, and how far an answer may be from it. */
#include "conform/judge_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double eta = 0x1p-1074;

void judge_shape_free(judge_shape *f)
{
    if (f->curve)
        et_curve_free(&f->c);
    else
        et_surface_free(&f->s);
}

et_vec3 *judge_shape_points(const judge_shape *f)
{
    return f->curve ? f->c.points : f->s.points;
}

double *judge_shape_weights(const judge_shape *f)
{
    return f->curve ? f->c.weights : f->s.weights;
}

size_t judge_shape_size(const judge_shape *f)
{
    return f->curve ? f->c.n : f->s.nu * f->s.nv;
}

et_curve judge_curve_of(const et_request *request)
{
    et_curve c = { 0, 0, NULL, NULL, NULL };

    (void)et_request_curve(&c, request, 0);
    return c;
}

et_surface judge_surface_of(const et_request *request, size_t k)
{
    et_surface s = { 0, 0, 0, 0, NULL, NULL, NULL, NULL };

    (void)et_request_surface(&s, request, k);
    return s;
}

void judge_edit_of(judge_shape *f, judge_editing *e, const et_request *request)
{
    const et_request_value *a = request->arg;

    memset(f, 0, sizeof *f);
    memset(e, 0, sizeof *e);
    f->curve = request->op == ET_OP_CURVE_INSERT || request->op == ET_OP_CURVE_REMOVE || request->op == ET_OP_CURVE_ELEVATE;
    e->op = request->op;
    e->along = f->curve || a[6].count == 0 ? ET_ALONG_U : ET_ALONG_V;
    a += f->curve ? 4 : 7;
    if (request->op == ET_OP_CURVE_ELEVATE || request->op == ET_OP_SURFACE_ELEVATE) {
        e->r = a[0].count;
    } else {
        e->x = a[0].x[0];
        e->r = a[1].count;
    }
    if (request->op == ET_OP_CURVE_REMOVE || request->op == ET_OP_SURFACE_REMOVE)
        e->tolerance = a[2].x[0];
    if (f->curve)
        f->c = judge_curve_of(request);
    else
        f->s = judge_surface_of(request, 0);
}

static et_status run(judge_shape *made, size_t *removed, const judge_shape *f, const judge_editing *e)
{
    memset(made, 0, sizeof *made);
    made->curve = f->curve;
    switch (e->op) {
    case ET_OP_CURVE_INSERT:
        return et_exact_curve_insert(&made->c, &f->c, e->x, e->r);
    case ET_OP_CURVE_REMOVE:
        return et_exact_curve_remove(&made->c, removed, &f->c, e->x, e->r);
    case ET_OP_CURVE_ELEVATE:
        return et_exact_curve_elevate(&made->c, &f->c, e->r);
    case ET_OP_SURFACE_INSERT:
        return et_exact_surface_insert(&made->s, &f->s, e->along, e->x, e->r);
    case ET_OP_SURFACE_REMOVE:
        return et_exact_surface_remove(&made->s, removed, &f->s, e->along, e->x, e->r);
    default:
        return et_exact_surface_elevate(&made->s, &f->s, e->along, e->r);
    }
}

/* widest[i]: coordinate by coordinate the greatest of all at most p places away in the direction that is edited, p its degree. */
static void widen(et_vec3 *widest, const et_vec3 *P, const judge_shape *f, const judge_editing *e)
{
    const int along_u = f->curve || e->along == ET_ALONG_U;
    const size_t n = f->curve ? f->c.n : along_u ? f->s.nu : f->s.nv, step = f->curve || !along_u ? 1 : f->s.nv;
    const size_t p = f->curve ? f->c.p : along_u ? f->s.p : f->s.q;

    for (size_t k = 0; k < judge_shape_size(f); k++) {
        const size_t i = k / step % n, first = i < p ? 0 : i - p, last = n - 1 - i < p ? n - 1 : i + p;
        const et_vec3 *line = P + (k - i * step);
        et_vec3 most = { 0, 0, 0 };
        for (size_t j = first; j <= last; j++) {
            const et_vec3 Q = line[j * step];
            most = (et_vec3){ fmax(most.x, Q.x), fmax(most.y, Q.y), fmax(most.z, Q.z) };
        }
        widest[k] = most;
    }
}

/* The same edit of the magnitudes |P|, or w |P|, or, heavy, (w, w, w), as coefficients, each the greatest near it.  ET_EINVAL if one overflows. */
static et_status run_magnitudes(judge_shape *made, const judge_shape *f, const judge_editing *e, int heavy)
{
    const size_t n = judge_shape_size(f);
    const double *w = judge_shape_weights(f);
    et_vec3 *P = et_size_array(n, 2 * sizeof *P);
    judge_shape g = *f;

    if (!P)
        return ET_ENOMEM;
    for (size_t i = 0; i < n; i++) {
        const et_vec3 Q = heavy ? (et_vec3){ 1, 1, 1 } : judge_shape_points(f)[i];
        const double v = w ? w[i] : 1;
        P[n + i] = (et_vec3){ v * fabs(Q.x), v * fabs(Q.y), v * fabs(Q.z) };
    }
    widen(P, P + n, f, e);
    g.c.points = g.s.points = P;
    g.c.weights = g.s.weights = NULL;
    const et_status status = run(made, NULL, &g, e);
    free(P);
    return status;
}

static void put_count(judge_list *list, size_t n)
{
    judge_put(list, (double)n);
}

static void put_knots(judge_list *list, const double *u, size_t nu)
{
    put_count(list, nu);
    judge_put_all(list, u, nu);
}

static void put_head(judge_list *list, const judge_shape *f)
{
    put_count(list, f->curve ? f->c.p : f->s.p);
    if (f->curve) {
        put_knots(list, f->c.u, f->c.n + f->c.p + 1);
    } else {
        put_count(list, f->s.q);
        put_knots(list, f->s.u, f->s.nu + f->s.p + 1);
        put_knots(list, f->s.v, f->s.nv + f->s.q + 1);
    }
    put_count(list, judge_shape_size(f));
}

double judge_edit_k(const judge_shape *f, const judge_editing *e)
{
    const size_t p = f->curve ? f->c.p : e->along == ET_ALONG_U ? f->s.p : f->s.q;

    return 16 * (double)(p + e->r + 1);
}

/* R: the magnitudes, null where they overflow; heavy: those of the weights, if there are. */
static void put_edited(judge_list *list, const judge_shape *made, const judge_shape *R, const judge_shape *heavy, double K)
{
    const size_t n = judge_shape_size(made);
    const double *w = judge_shape_weights(made), ku = K * ET_UNIT;

    put_head(list, made);
    for (size_t i = 0; i < n; i++)
        for (size_t c = 0; c < 3; c++) {
            const double x = judge_coordinate(&judge_shape_points(made)[i], c);
            double B = R ? ku * judge_coordinate(&judge_shape_points(R)[i], c) + K * eta : INFINITY;
            if (w)
                B = (B + judge_times(fabs(x), ku * judge_shape_points(heavy)[i].x + K * eta)) / w[i] + K * eta;
            judge_put_bound(list, x, B, ku);
        }
    put_count(list, w ? n : 0);
    for (size_t i = 0; w && i < n; i++)
        judge_put_bound(list, w[i], 2 * ku * judge_shape_points(heavy)[i].x + 2 * K * eta, ku);
}

static void put_removed(judge_list *list, const judge_shape *made, size_t removed, const judge_shape *f, double tolerance, double K)
{
    const size_t n = judge_shape_size(made);
    const double *w = judge_shape_weights(made), ku = K * ET_UNIT;
    double most = 0, heaviest = 0;

    for (size_t i = 0; i < judge_shape_size(f); i++) {
        for (size_t c = 0; c < 3; c++)
            most = fmax(most, fabs(judge_coordinate(&judge_shape_points(f)[i], c)));
        heaviest = fmax(heaviest, w ? judge_shape_weights(f)[i] : 0);
    }
    put_count(list, removed);
    put_head(list, made);
    for (size_t i = 0; i < n; i++)
        for (size_t c = 0; c < 3; c++)
            judge_put_bound(list, judge_coordinate(&judge_shape_points(made)[i], c), tolerance + ku * most, ku);
    put_count(list, w ? n : 0);
    for (size_t i = 0; w && i < n; i++)
        judge_put_bound(list, w[i], 2 * ku * heaviest + 2 * K * eta, ku);
}

static et_status put_with_bounds(judge_list *list, const judge_shape *made, const judge_shape *f, const judge_editing *e)
{
    judge_shape R, heavy;
    const et_status magnitudes = run_magnitudes(&R, f, e, 0);
    et_status status = magnitudes == ET_EINVAL ? ET_OK : magnitudes;

    if (status == ET_OK)
        status = run_magnitudes(&heavy, f, e, 1);
    if (status == ET_OK) {
        put_edited(list, made, magnitudes == ET_OK ? &R : NULL, &heavy, judge_edit_k(f, e));
        judge_shape_free(&heavy);
    }
    if (magnitudes == ET_OK)
        judge_shape_free(&R);
    return status;
}

et_status judge_edited(judge_list *list, const et_request *request)
{
    judge_shape f, made;
    judge_editing e;
    size_t removed = 0;

    judge_edit_of(&f, &e, request);
    et_status status = run(&made, &removed, &f, &e);
    if (status != ET_OK)
        return status;
    if (e.op == ET_OP_CURVE_REMOVE || e.op == ET_OP_SURFACE_REMOVE)
        put_removed(list, &made, removed, &f, e.tolerance, judge_edit_k(&f, &e));
    else
        status = put_with_bounds(list, &made, &f, &e);
    judge_shape_free(&made);
    return status;
}
