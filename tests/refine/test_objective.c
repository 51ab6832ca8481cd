#include "etalon/refine/objective.h"
#include "ascending.h"
#include "etalon/base/real.h"
#include "etalon/spline/knots.h"
#include "golden.h"
#include "gen.h"
#include "refine/some_fit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 12, CLASSES = 2 * SIDE * SIDE };

typedef struct {
    et_fit fit;
    et_doublenet control;
    size_t nov, n;                        /* data classes; coordinates of a candidate */
    et_vec3 data[CLASSES];
    double x[3 * CLASSES];
} instance;

/* Sorted parameters; the simplest are equidistant. */
static void gen_parameters(gen *g, double *t, size_t nt, const double *u, size_t nu, size_t p)
{
    const bool even = gen_upto(g, 3) == 0;
    for (size_t i = 0; i < nt; i++) t[i] = even ? (double)i / (double)(nt - 1) : gen_parameter(g, u, nu, p);
    ascending(t, nt);
}

static bool allocate(instance *c, size_t p, size_t q, et_doublenet control, et_doublenet data)
{
    memset(c, 0, sizeof *c);
    c->control = control;
    c->nov = et_doublenet_nov(data);
    c->n = 3 * et_doublenet_nov(control);
    return some_fit_new(&c->fit, p, q, control, data);
}

static void place(instance *c, const double *x)
{
    et_vec3 points[CLASSES];
    memcpy(points, x, c->n * sizeof *x);
    et_shell_scatter(&c->fit.shell, points, c->n / 3);
}

static bool gen_instance(gen *g, instance *c, size_t most)
{
    static const size_t degrees[] = { 3, 1, 2, 4 };
    const size_t p = degrees[gen_upto(g, 3)], q = degrees[gen_upto(g, 3)], least_u = p + 1 > 2 ? p + 1 : 2, least_v = q + 1 > 2 ? q + 1 : 2;
    const et_doublenet control = { gen_between(g, least_u, least_u + most), gen_between(g, least_v, least_v + most) };
    const et_doublenet data = { gen_between(g, 2, 2 + most), gen_between(g, 2, 2 + most) };
    if (!allocate(c, p, q, control, data)) return false;
    et_surface *s = &c->fit.shell.view[ET_BOTTOM];
    gen_knots(g, s->u, s->nu + p + 1, p);
    gen_knots(g, s->v, s->nv + q + 1, q);
    gen_parameters(g, c->fit.s[ET_BOTTOM], data.nx, s->u, s->nu + p + 1, p);
    gen_parameters(g, c->fit.r[ET_BOTTOM], data.ny, s->v, s->nv + q + 1, q);
    some_fit_share(&c->fit);
    gen_points(g, &c->data[0].x, c->nov);
    gen_points(g, c->x, c->n / 3);
    place(c, c->x);
    return true;
}

/* A larger net whose coordinates cost no draws. */
static bool net_instance(gen *g, instance *c, size_t p, size_t q, et_doublenet control)
{
    const et_doublenet data = { SIDE, SIDE - 1 };
    const size_t seed = gen_upto(g, 1023);
    if (!allocate(c, p, q, control, data)) return false;
    et_surface *s = &c->fit.shell.view[ET_BOTTOM];
    for (size_t i = 0; i < s->nu + p + 1; i++) s->u[i] = i <= p ? 0.0 : i >= s->nu ? 1.0 : (double)(i - p) / (double)(s->nu - p);
    for (size_t j = 0; j < s->nv + q + 1; j++) s->v[j] = j <= q ? 0.0 : j >= s->nv ? 1.0 : (double)(j - q) / (double)(s->nv - q);
    for (size_t i = 0; i < data.nx; i++) c->fit.s[ET_BOTTOM][i] = (double)i / (double)(data.nx - 1);
    for (size_t j = 0; j < data.ny; j++) c->fit.r[ET_BOTTOM][j] = (double)j / (double)(data.ny - 1);
    some_fit_share(&c->fit);
    for (size_t k = 0; k < 3 * c->nov; k++) (&c->data[0].x)[k] = (double)((k * 7919 + seed) % 1009) / 1009.0;
    for (size_t k = 0; k < c->n; k++) c->x[k] = (double)((k * 104729 + seed) % 997) / 997.0;
    place(c, c->x);
    return true;
}

static bool large_instance(gen *g, instance *c, size_t p, size_t q)
{
    return net_instance(g, c, p, q, (et_doublenet){ SIDE - 2, SIDE - 1 });
}

static void end(instance *c)
{
    et_fit_free(&c->fit);
}

/* E by the definition: a surface point for each class. */
static double reference(instance *c, const double *x)
{
    double distance[CLASSES], work[256];
    place(c, x);
    for (size_t k = 0; k < c->nov; k++) {
        const et_index v = et_doublenet_index(c->fit.data, k + 1);
        const size_t w = v.k == 2 ? ET_TOP : ET_BOTTOM;
        const et_surface *s = &c->fit.shell.view[w];
        distance[k] = et_vec3_distance(c->data[k], et_surface_point(s, c->fit.s[w][v.i], c->fit.r[w][v.j], work, et_surface_work(s)));
    }
    return et_real_sum(distance, c->nov);
}

static bool same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static bool evaluates(gen *g, et_objective *f, instance *c, const double *x)
{
    double value = -1.0;
    const et_status status = et_objective_eval(&value, x, c->n, f);
    const double want = reference(c, x);
    return gen_check(g, status == ET_OK, "status %d", (int)status) && gen_check(g, same(value, want), "%a, not %a", value, want);
}

static bool counted(gen *g, const et_objective *f, uint64_t full, uint64_t incremental)
{
    uint64_t a = UINT64_MAX, b = UINT64_MAX;
    et_objective_counts(&a, &b, f);
    return gen_check(g, a == full && b == incremental, "%llu full evaluations and %llu incremental, not %llu and %llu", (unsigned long long)a,
                     (unsigned long long)b, (unsigned long long)full, (unsigned long long)incremental);
}

static verdict finish(et_objective *f, instance *c, bool ok)
{
    et_objective_free(f);
    end(c);
    return ok ? PASS : FAIL;
}

/* ---- new, size, free, counts ---- */

verdict prop_objective_new(gen *g)
{
    instance c;
    et_objective *f = NULL;
    et_fit_error error;
    double value = -1.0;
    bool ok = gen_instance(g, &c, 5);
    ok = ok && gen_check(g, et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK && f, "status");
    ok = ok && gen_check(g, et_objective_eval(&value, c.x, c.n, f) == ET_OK, "status of eval");
    ok = ok && gen_check(g, et_fit_measure(&error, NULL, c.nov, &c.fit, c.data) == ET_OK && same(error.nov, value), "%a is not as measured", value);
    return finish(f, &c, ok);
}

/* Each fault by itself. */
static void spoil(gen *g, instance *c, uint64_t how)
{
    et_surface *top = &c->fit.shell.view[ET_TOP];
    const double by = gen_upto(g, 1) ? -0x1p-40 : 0x1p-40;
    if (how == 0) c->fit.s[ET_TOP][gen_upto(g, c->fit.data.nx - 1)] += by;
    else if (how == 1) c->fit.r[ET_TOP][gen_upto(g, c->fit.data.ny - 1)] += by;
    else if (how == 2) top->points[gen_upto(g, 1) ? top->nv - 1 : 0].y += 1e200;
    else if (how == 3) c->nov += gen_upto(g, 1) ? 1 : (size_t)-1;
    else if (how == 4) c->fit.data.nx = 1;
    else if (how == 5) top->points[0].x = NAN;
}

static bool make_rational(instance *c)
{
    for (size_t w = 0; w < 2; w++) {
        et_surface *s = &c->fit.shell.view[w];
        s->weights = calloc(s->nu * s->nv, sizeof *s->weights);
        if (!s->weights) return false;
        for (size_t k = 0; k < s->nu * s->nv; k++) s->weights[k] = 1.0;
    }
    return true;
}

verdict prop_objective_new_invalid(gen *g)
{
    instance c;
    const uint64_t how = gen_upto(g, 9);
    bool ok = gen_instance(g, &c, 3);
    et_objective *const before = (et_objective *)&c, *f = before;
    if (ok) spoil(g, &c, how);
    if (how == 6) ok = ok && make_rational(&c);
    const et_status status = et_objective_new(how == 7 ? NULL : &f, how == 8 ? NULL : &c.fit, how == 9 ? NULL : c.data, c.nov);
    ok = ok && gen_check(g, status == ET_EINVAL && f == before, "fault %zu was accepted", (size_t)how);
    end(&c);
    return ok ? PASS : FAIL;
}

verdict prop_objective_size(gen *g)
{
    instance c;
    et_objective *f = NULL;
    bool ok = gen_instance(g, &c, 5) && et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK;
    const size_t nu = c.control.nx, nv = c.control.ny;
    ok = ok && gen_check(g, et_objective_size(f) == 3 * (2 * nu * nv - 2 * (nu + nv - 2)), "size");
    return finish(f, &c, ok);
}

verdict prop_objective_free(gen *g)
{
    instance c;
    et_objective *f = NULL;
    double value;
    et_objective_free(NULL);
    bool ok = gen_instance(g, &c, 2) && et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK;
    end(&c);                              /* the fit may go before its objective */
    memset(c.data, 0, sizeof c.data);
    ok = ok && gen_check(g, et_objective_eval(&value, c.x, c.n, f) == ET_OK, "status");
    et_objective_free(f);
    return ok ? PASS : FAIL;
}

verdict prop_objective_counts(gen *g)
{
    instance c;
    et_objective *f = NULL;
    double value;
    bool ok = large_instance(g, &c, 3, 3) && et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK;
    ok = ok && counted(g, f, 0, 0);
    const size_t evaluations = gen_between(g, 1, 6), few = gen_upto(g, evaluations);
    for (size_t k = 0; k < evaluations && ok; k++) {      /* the first is full; then `few` times one corner, then everything */
        for (size_t d = 0; d < (k <= few ? 3 : c.n); d++) c.x[d] += 0.125;
        ok = et_objective_eval(&value, c.x, c.n, f) == ET_OK && et_objective_eval(&value, c.x, c.n - 1, f) == ET_EINVAL;
    }
    const size_t want = few < evaluations - 1 ? few : evaluations - 1;
    ok = ok && counted(g, f, evaluations - want, want);
    return finish(f, &c, ok);
}

/* Control points that see little: bilinear, all parameters within the first spans. */
static bool corner_instance(gen *g, instance *c)
{
    const et_doublenet control = { SIDE, SIDE }, data = { gen_between(g, 2, 4), gen_between(g, 2, 4) };
    if (!allocate(c, 1, 1, control, data)) return false;
    et_surface *s = &c->fit.shell.view[ET_BOTTOM];
    for (size_t i = 0; i < SIDE + 2; i++) s->u[i] = s->v[i] = i < 1 ? 0.0 : i > SIDE ? 1.0 : (double)(i - 1) / (SIDE - 1);
    for (size_t i = 0; i < data.nx; i++) c->fit.s[ET_BOTTOM][i] = (double)i * 0x1p-6;
    for (size_t j = 0; j < data.ny; j++) c->fit.r[ET_BOTTOM][j] = (double)j * 0x1p-6;
    some_fit_share(&c->fit);
    for (size_t k = 0; k < 3 * c->nov; k++) (&c->data[0].x)[k] = (double)(k % 7);
    for (size_t k = 0; k < c->n; k++) c->x[k] = (double)(k % 11) + 1.0;
    place(c, c->x);
    return true;
}

/* How many of the parameters lie where the basis function i is one of the p+1 in use. */
static size_t seen_by(size_t i, const double *u, size_t nu, size_t p, const double *t, size_t nt)
{
    size_t count = 0;
    for (size_t k = 0; k < nt; k++) {
        const size_t span = et_knots_span(u, nu, p, t[k]);
        count += i <= span && i + p >= span;
    }
    return count;
}

/* Data classes within reach of a control class; those of a border in both views. */
static size_t cost(const instance *c, size_t class)
{
    const et_surface *s = &c->fit.shell.view[ET_BOTTOM];
    const et_index v = et_doublenet_index(c->control, class + 1);
    return seen_by(v.i, s->u, s->nu + s->p + 1, s->p, c->fit.s[0], c->fit.data.nx) *
           seen_by(v.j, s->v, s->nv + s->q + 1, s->q, c->fit.r[0], c->fit.data.ny) * (v.k == 1 ? 2 : 1);
}

/* E of x as an objective has it that never saw another candidate. */
static bool afresh(double *value, const instance *c, const double *x)
{
    et_objective *f = NULL;
    const bool ok = et_objective_new(&f, &c->fit, c->data, c->nov) == ET_OK && et_objective_eval(value, x, c->n, f) == ET_OK;
    et_objective_free(f);
    return ok;
}

/* Signs change: of a few control points, or of all that see no data; how far that reaches. */
static size_t turn(gen *g, const instance *c, double *x, bool unseen)
{
    size_t reached = 0;
    bool turned[CLASSES] = { false };
    for (size_t m = unseen ? 0 : gen_between(g, 1, 8); m > 0; m--) turned[gen_upto(g, c->n / 3 - 1)] = true;
    for (size_t k = 0; k < c->n / 3; k++) {
        if (!(unseen ? cost(c, k) == 0 : turned[k])) continue;
        x[3 * k + k % 3] = -x[3 * k + k % 3];
        reached += cost(c, k);
    }
    return reached;
}

/* Incremental just as long as what differs reaches at most a sixth of the data. */
verdict prop_objective_counts_cost(gen *g)
{
    instance c;
    et_objective *f = NULL;
    double x[3 * CLASSES], value = -1.0, want = -2.0;
    uint64_t expected = 0;
    const uint64_t kind = gen_upto(g, 3);
    bool ok = kind == 0 ? corner_instance(g, &c) : kind == 1 ? gen_instance(g, &c, 7) : large_instance(g, &c, gen_between(g, 1, 3), gen_between(g, 1, 2));
    memcpy(x, c.x, c.n * sizeof *x);
    ok = ok && et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK && et_objective_eval(&value, x, c.n, f) == ET_OK;
    for (size_t k = 0; k < 3 && ok; k++) {
        const size_t reached = turn(g, &c, x, kind == 0 && k == 0);
        expected += reached <= c.nov / 6;
        ok = et_objective_eval(&value, x, c.n, f) == ET_OK && afresh(&want, &c, x) && gen_check(g, same(value, want), "%a, not %a", value, want);
        gen_note(g, "%zu of %zu data reached", reached, c.nov);
        ok = ok && counted(g, f, k + 2 - expected, expected);
    }
    return finish(f, &c, ok);
}

/* ---- eval ---- */

/* The next candidate: the same, a few control points moved, the first one again, or everything moved. */
static void move(gen *g, instance *c, double *x)
{
    const uint64_t kind = gen_upto(g, 7);
    if (kind == 0) return;
    if (kind == 7) memcpy(x, c->x, c->n * sizeof *x);
    for (size_t k = 0; k < c->n && kind == 6; k++) x[k] += 0.25 * (double)(k % 5);
    for (size_t m = kind < 6 ? gen_between(g, 1, 3) : 0; m > 0; m--) {
        double *P = x + 3 * gen_upto(g, c->n / 3 - 1);
        const size_t d = gen_upto(g, 2);
        P[d] = gen_upto(g, 3) == 3 ? -P[d] : P[d] + gen_real(g, 0.0, 1.0);
    }
}

static verdict sequence(gen *g, instance *c, size_t candidates)
{
    et_objective *f = NULL, *other = NULL;
    double x[3 * CLASSES], y[3 * CLASSES];
    uint64_t full = 0, incremental = 0;
    bool ok = et_objective_new(&f, &c->fit, c->data, c->nov) == ET_OK && et_objective_new(&other, &c->fit, c->data, c->nov) == ET_OK;
    memcpy(x, c->x, c->n * sizeof *x);
    memcpy(y, c->x, c->n * sizeof *y);
    for (size_t k = 0; k < candidates && ok; k++) {
        move(g, c, x);
        ok = evaluates(g, f, c, x);
        if (k % 3 == 0) move(g, c, y);    /* another object in between */
        ok = ok && (k % 3 != 0 || evaluates(g, other, c, y));
    }
    if (ok) et_objective_counts(&full, &incremental, f);
    ok = ok && gen_check(g, full + incremental == candidates && full >= 1, "counts");
    if (incremental > 0) gen_label(g, "incremental");
    et_objective_free(f);
    et_objective_free(other);
    end(c);
    return ok ? PASS : FAIL;
}

verdict prop_objective_eval(gen *g)
{
    instance c;
    return gen_instance(g, &c, 6) ? sequence(g, &c, gen_between(g, 1, 6)) : FAIL;
}

verdict prop_objective_eval_large(gen *g)
{
    static const size_t degrees[] = { 3, 2 };
    instance c;
    const size_t p = degrees[gen_upto(g, 1)], q = degrees[gen_upto(g, 1)];
    return large_instance(g, &c, p, q) ? sequence(g, &c, gen_between(g, 2, 8)) : FAIL;
}

/* Every control point by itself: moved and moved back, always incrementally. */
verdict prop_objective_eval_each(gen *g)
{
    instance c;
    et_objective *f = NULL;
    bool ok = large_instance(g, &c, 3, 2) && et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK && evaluates(g, f, &c, c.x);
    const size_t k = 3 * gen_upto(g, c.n / 3 - 1) + gen_upto(g, 2);
    const double was = c.x[k], first = ok ? reference(&c, c.x) : 0.0;
    double again = -1.0;
    c.x[k] = was + 0.5;
    ok = ok && evaluates(g, f, &c, c.x);
    c.x[k] = was;
    ok = ok && et_objective_eval(&again, c.x, c.n, f) == ET_OK && gen_check(g, same(first, again), "moved back: %a, not %a", again, first);
    ok = ok && counted(g, f, 1, 2);
    return finish(f, &c, ok);
}

/* One coordinate of many that are alike: all zero, with zeros on both sides of the candidate, or all one ulp above what the one becomes. */
/* One case in 4. */
verdict prop_objective_eval_alike(gen *g)
{
    instance c;
    et_objective *f = NULL;
    double room[12 * CLASSES] = { 0 }, *x = room + 3 * CLASSES;
    const bool ulp = gen_upto(g, 1);
    bool ok = large_instance(g, &c, 3, 2) && et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK;
    for (size_t k = 0; k < c.n && ulp; k++) x[k] = 1.0 + 0x1p-52;
    ok = ok && evaluates(g, f, &c, x);
    for (size_t k = 0; k < 3 && ok; k++) {
        x[gen_upto(g, c.n - 1)] = ulp ? 1.0 : 0.5;
        ok = evaluates(g, f, &c, x);
    }
    return finish(f, &c, ok);
}

/* Control points near the corners, one after another: each view's net keeps what is its own. */
/* One case in 2. */
verdict prop_objective_eval_corners(gen *g)
{
    instance c;
    et_objective *f = NULL;
    double value = -1.0, want = -2.0;
    const size_t nu = SIDE - 2, nv = gen_upto(g, 1) ? SIDE - 1 : 8;              /* 8: rows of control points without a gap */
    bool ok = net_instance(g, &c, 3, 2, (et_doublenet){ nu, nv }) && et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK;
    ok = ok && et_objective_eval(&value, c.x, c.n, f) == ET_OK;
    for (size_t k = 0; k < 8 && ok; k++) {
        const size_t i = gen_upto(g, 1), j = gen_upto(g, 1), at = gen_upto(g, 7);
        c.x[3 * (et_doublenet_class(c.control, at & 1, at & 2 ? i : nu - 1 - i, at & 4 ? j : nv - 1 - j) - 1) + k % 3] += 1.0;
        ok = et_objective_eval(&value, c.x, c.n, f) == ET_OK && afresh(&want, &c, c.x) && gen_check(g, same(value, want), "%a, not %a", value, want);
    }
    ok = ok && counted(g, f, 1, 8);
    return finish(f, &c, ok);
}

/* Knots that are not clamped, and parameters on both sides beyond the domain. */
/* One case in 4. */
verdict prop_objective_eval_unclamped(gen *g)
{
    instance c;
    et_objective *f = NULL;
    const size_t p = gen_between(g, 1, 3), q = gen_between(g, 1, 3);
    bool ok = large_instance(g, &c, p, q);
    et_surface *s = &c.fit.shell.view[ET_BOTTOM];
    for (size_t i = 0; ok && i < s->nu + p + 1; i++) s->u[i] = (double)i;
    for (size_t j = 0; ok && j < s->nv + q + 1; j++) s->v[j] = (double)j * 0.5;
    for (size_t i = 0; ok && i < c.fit.data.nx; i++) c.fit.s[ET_BOTTOM][i] = gen_real(g, 0.0, (double)(s->nu + p));
    for (size_t j = 0; ok && j < c.fit.data.ny; j++) c.fit.r[ET_BOTTOM][j] = gen_real(g, 0.0, (double)(s->nv + q) * 0.5);
    if (ok) {
        ascending(c.fit.s[ET_BOTTOM], c.fit.data.nx);
        ascending(c.fit.r[ET_BOTTOM], c.fit.data.ny);
        some_fit_share(&c.fit);
    }
    ok = ok && et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK && evaluates(g, f, &c, c.x);
    return finish(f, &c, ok);
}

verdict prop_objective_eval_invalid(gen *g)
{
    instance c;
    et_objective *f = NULL;
    double value = -1.0;
    bool ok = gen_instance(g, &c, 2) && et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK;
    const uint64_t how = gen_upto(g, 4);
    const size_t n = how == 0 ? c.n - 1 : how == 1 ? c.n + 1 : c.n;
    const et_status status = et_objective_eval(how == 2 ? NULL : &value, how == 3 ? NULL : c.x, n, how == 4 ? NULL : f);
    ok = ok && gen_check(g, status == ET_EINVAL, "fault %zu was accepted", (size_t)how);
    ok = ok && gen_check(g, value == -1.0, "value changed");
    ok = ok && counted(g, f, 0, 0);
    return finish(f, &c, ok);
}

/* ---- rows ---- */

/* Arguments: p, q, nu, nv, nx, ny; knots u, v; parameters s, r; data by class; then one or more candidates.  Wanted: a value each. */
verdict gold_objective_eval(const row *r)
{
    instance c;
    et_objective *f = NULL;
    const size_t p = row_size(r, 0), q = row_size(r, 1), nu = row_size(r, 2), nv = row_size(r, 3), nx = row_size(r, 4), ny = row_size(r, 5);
    size_t at = 6;
    if (nu > SIDE || nv > SIDE || nx > SIDE || ny > SIDE) return FAIL;
    if (!allocate(&c, p, q, (et_doublenet){ nu, nv }, (et_doublenet){ nx, ny })) return FAIL;
    et_surface *s = &c.fit.shell.view[ET_BOTTOM];
    for (size_t k = 0; k < nu + p + 1; k++) s->u[k] = row_real(r, at++);
    for (size_t k = 0; k < nv + q + 1; k++) s->v[k] = row_real(r, at++);
    for (size_t k = 0; k < nx; k++) c.fit.s[ET_BOTTOM][k] = row_real(r, at++);
    for (size_t k = 0; k < ny; k++) c.fit.r[ET_BOTTOM][k] = row_real(r, at++);
    some_fit_share(&c.fit);
    for (size_t k = 0; k < 3 * c.nov; k++) (&c.data[0].x)[k] = row_real(r, at++);
    bool ok = et_objective_new(&f, &c.fit, c.data, c.nov) == ET_OK && r->nargs == at + c.n * r->nwant;
    for (size_t w = 0; w < r->nwant && ok; w++) {
        double value = -1.0;
        for (size_t k = 0; k < c.n; k++) c.x[k] = row_real(r, at++);
        ok = et_objective_eval(&value, c.x, c.n, f) == ET_OK && row_is(r, w, value);
    }
    return finish(f, &c, ok);
}
