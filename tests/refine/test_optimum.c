#include "etalon/refine/optimum.h"
#include "ascending.h"
#include "etalon/refine/ceres.h"
#include "golden.h"
#include "refine/optimum_cases.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Finding a minimum costs milliseconds: one case in RARE does what costs most. */
enum { SIDE = OPTIMUM_MOST, CLASSES = OPTIMUM_CLASSES, DEGREE = 4, BITS = OPTIMUM_BITS, RARE = 8 };

/* From 0 to 1, sorted; even ones are the simplest.  wild: anything goes, knots and their neighbours and equal ones often. */
static void parameters(gen *g, double *t, size_t nt, const double *u, size_t nu, size_t p, bool wild)
{
    const size_t kind = gen_upto(g, 3);

    for (size_t i = 0; i < nt; i++)
        t[i] = kind == 0 || (kind == 1 && !wild) ? (double)i / (double)(nt - 1)
             : wild                              ? gen_parameter(g, u, nu, p)
                                                 : ((double)i + gen_real(g, 0, 0.5)) / ((double)nt - 0.5);
    ascending(t, nt);
    if (kind != 3 || !wild) {
        t[0] = 0;
        t[nt - 1] = 1;
    }
}

static et_vec3 some_point(gen *g, double scale)
{
    return (et_vec3){gen_real(g, -scale, scale), gen_real(g, -scale, scale), gen_real(g, -scale, scale)};
}

/* tame: knots even, more data than control points, coordinates within [-1, 1]: nothing is undetermined. */
static bool draw(gen *g, optimum_case *c, bool tame)
{
    static const size_t degrees[] = {1, 2, 3, DEGREE};
    const size_t p = degrees[gen_upto(g, tame ? 2 : 3)], q = degrees[gen_upto(g, tame ? 2 : 3)];
    const et_doublenet control = {gen_between(g, p + 1, tame ? 5 : 6), gen_between(g, q + 1, tame ? 5 : 6)};
    const et_doublenet data = {gen_between(g, tame ? control.nx + 1 : 2, tame ? 7 : 6), gen_between(g, tame ? control.ny + 1 : 2, tame ? 7 : 6)};
    et_surface *const s = &c->fit.shell.view[ET_BOTTOM];

    if (!optimum_case_new(c, p, q, control, data))
        return false;
    optimum_case_even(s->u, s->nu, p);
    optimum_case_even(s->v, s->nv, q);
    if (!tame) {
        gen_knots(g, s->u, s->nu + p + 1, p);
        gen_knots(g, s->v, s->nv + q + 1, q);
    }
    parameters(g, c->fit.s[ET_BOTTOM], data.nx, s->u, s->nu + p + 1, p, !tame);
    parameters(g, c->fit.r[ET_BOTTOM], data.ny, s->v, s->nv + q + 1, q, !tame);
    if (!tame) {
        gen_points(g, &c->data[0].x, c->nov);
        gen_points(g, &c->start[0].x, c->n);
    }
    for (size_t k = 0; tame && k < c->nov; k++)
        c->data[k] = some_point(g, 1);
    for (size_t k = 0; tame && k < c->n; k++)
        c->start[k] = some_point(g, 1);
    optimum_case_close(c);
    return true;
}

/* ---- E by the definition, in balls ---- */

/* All of one direction: N[t][n]. */
static arb_ptr bases(const double *u, size_t n, size_t p, const double *t, size_t nt)
{
    arb_ptr N = _arb_vec_init((slong)(n * nt));

    for (size_t k = 0; k < nt; k++)
        for (size_t i = 0; i < n; i++)
            optimum_case_basis(N + k * n + i, u, n, p, i, t[k]);
    return N;
}

/* E(P) lies within [low, high]. */
static void true_E(double *low, double *high, const optimum_case *c, const et_vec3 *P)
{
    const et_surface *const s = &c->fit.shell.view[ET_BOTTOM];
    arb_ptr U = bases(s->u, s->nu, s->p, c->fit.s[0], c->fit.data.nx), V = bases(s->v, s->nv, s->q, c->fit.r[0], c->fit.data.ny);
    arb_ptr x = _arb_vec_init(6);
    arf_t end_;

    arf_init(end_);
    for (size_t k = 0; k < c->nov; k++) {
        const et_index at = et_doublenet_index(c->fit.data, k + 1);
        const size_t view = at.k == 2;

        arb_set_d(x, c->data[k].x);
        arb_set_d(x + 1, c->data[k].y);
        arb_set_d(x + 2, c->data[k].z);
        for (size_t i = 0; i < s->nu; i++)
            for (size_t j = 0; j < s->nv; j++) {
                const et_vec3 p = P[et_doublenet_class(c->control, view, i, j) - 1];
                const double coordinate[3] = {p.x, p.y, p.z};

                arb_mul(x + 4, U + at.i * s->nu + i, V + at.j * s->nv + j, BITS);
                for (int d = 0; d < 3 && !arb_is_zero(x + 4); d++) {
                    arb_set_d(x + 5, coordinate[d]);
                    arb_submul(x + d, x + 4, x + 5, BITS);
                }
            }
        arb_mul(x, x, x, BITS);
        arb_addmul(x, x + 1, x + 1, BITS);
        arb_addmul(x, x + 2, x + 2, BITS);
        arb_sqrtpos(x, x, BITS);
        arb_add(x + 3, x + 3, x, BITS);
    }
    arb_get_lbound_arf(end_, x + 3, BITS);
    *low = arf_get_d(end_, ARF_RND_FLOOR);
    arb_get_ubound_arf(end_, x + 3, BITS);
    *high = arf_get_d(end_, ARF_RND_CEIL);
    arf_clear(end_);
    _arb_vec_clear(U, (slong)(s->nu * c->fit.data.nx));
    _arb_vec_clear(V, (slong)(s->nv * c->fit.data.ny));
    _arb_vec_clear(x, 6);
}

/* ---- what every result owes ---- */

static double greatest(const et_vec3 *p, size_t n)
{
    double most = 0;

    for (size_t k = 0; k < n; k++)
        most = fmax(most, fmax(fabs(p[k].x), fmax(fabs(p[k].y), fabs(p[k].z))));
    return most;
}

static bool same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* E as told, at both ends; bound below value; never worse; closed; the dual proves the bound told. */
static bool owed(gen *g, const optimum_case *c, const et_optimum_result *r, const et_vec3 *dual)
{
    et_vec3 P[CLASSES];
    double low, high, lower = -1, tiny;
    bool ok;

    et_shell_gather(P, c->n, &c->fit.shell);
    true_E(&low, &high, c, P);
    tiny = 0x1p-1074 + 0x1p-240 * fmax(greatest(c->data, c->nov), fmax(greatest(P, c->n), greatest(c->start, c->n)));    /* of balls, here or there */
    ok = gen_check(g, r->value >= low && r->value <= high * (1 + 0x1p-52) + tiny, "value %a of E in [%a, %a]", r->value, low, high);
    ok = ok && gen_check(g, 0 <= r->lower && r->lower <= high, "lower %a of E in [%a, %a]", r->lower, low, high);
    ok = ok && gen_check(g, r->value - r->lower <= r->gap && r->gap <= (r->value - r->lower) * (1 + 0x1p-50) + 0x1p-1073, "gap %a", r->gap);
    true_E(&low, &high, c, c->start);
    ok = ok && gen_check(g, r->before >= low && r->before <= high * (1 + 0x1p-52) + tiny, "before %a of E in [%a, %a]", r->before, low, high);
    ok = ok && gen_check(g, r->value <= r->before, "worse") && gen_check(g, r->lower <= high, "the start lies below the bound");
    ok = ok && gen_check(g, et_shell_glued(&c->fit.shell), "not glued");
    ok = ok && gen_check(g, et_optimum_bound(&lower, dual, c->nov, &c->fit, c->data) == ET_OK && same(lower, r->lower), "dual: %a, not %a", lower,
                         r->lower);
    return ok;
}

/* No P lies below: near the best, far from it, and in all places at once. */
static bool below_all(gen *g, const optimum_case *c, double lower, double scale)
{
    et_vec3 P[CLASSES];
    double low, high;
    bool ok = true;

    for (int k = 0; k < 2 && ok; k++) {
        const double step = scale * ldexp(1, -(int)gen_upto(g, 60));

        et_shell_gather(P, c->n, &c->fit.shell);
        for (size_t i = 0; i < c->n; i++) {
            const et_vec3 move = some_point(g, step);

            P[i] = (et_vec3){P[i].x + move.x, P[i].y + move.y, P[i].z + move.z};
        }
        if (!et_vec3_finite(P, c->n))
            continue;
        true_E(&low, &high, c, P);
        ok = gen_check(g, lower <= high, "%a is no lower bound: E is at most %a", lower, high);
    }
    return ok;
}

static et_status find(optimum_case *c, et_optimum_result *r, et_vec3 *dual)
{
    return et_optimum_find(&c->fit, r, dual, NULL, 0, c->data, c->nov, NULL, NULL, NULL);
}

/* ---- defaults ---- */

verdict prop_optimum_defaults(gen *g)
{
    const et_optimum_options o = et_optimum_defaults();

    return gen_check(g, o.iterations == 100 && o.gap == 1e-12, "not as stated") ? PASS : FAIL;
}

/* ---- find ---- */

/* Whatever comes: knots at full multiplicity or an ulp apart, parameters anywhere, coincident points, any scale, control points without data. */
/* One case in 12. */
verdict prop_optimum_find(gen *g)
{
    optimum_case c;
    et_optimum_result r = {0, 0, 0, 0, 0};
    et_vec3 dual[CLASSES];
    et_message message = {{0}};
    double scale, low, high;
    bool ok = draw(g, &c, false);
    et_status status;

    scale = fmax(greatest(c.data, c.nov), greatest(c.start, c.n));
    status = et_optimum_find(&c.fit, &r, dual, NULL, 0, c.data, c.nov, NULL, NULL, &message);
    true_E(&low, &high, &c, c.start);
    if (!isfinite(high)) {
        gen_label(g, "overflow");
        ok = ok && gen_check(g, status == ET_EINVAL, "status %d", (int)status);
    } else {
        ok = ok && gen_check(g, status == ET_OK, "status %d: %s", (int)status, message.text) && owed(g, &c, &r, dual) && below_all(g, &c, r.lower, scale);
        gen_label(g, message.text[0] ? "nothing proved" : r.gap <= 1e-9 * scale ? "narrow" : "wide");
    }
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* Random data in general position: the gap is narrow, and Ceres finds nothing below the bound, nor do we stay above what it finds. */
/* One case in 10. */
verdict prop_optimum_find_tame(gen *g)
{
    optimum_case c;
    et_optimum_result r;
    et_vec3 dual[CLASSES];
    et_ceres_summary sum;
    bool ok = draw(g, &c, true);

    ok = ok && gen_check(g, find(&c, &r, dual) == ET_OK, "not done") && owed(g, &c, &r, dual);
    ok = ok && gen_check(g, r.gap <= 1e-9 && r.gap <= 1e-9 * r.value, "gap %g of %g", r.gap, r.value);
    if (ok && gen_chance(g, RARE)) {
        et_shell_scatter(&c.fit.shell, c.start, c.n);
        ok = gen_check(g, et_ceres_points(&c.fit, &sum, NULL, 0, c.data, c.nov, NULL, NULL, NULL) == ET_OK, "ceres");
        ok = ok && gen_check(g, r.lower <= sum.after * (1 + 0x1p-40), "ceres is below: %.17g < %.17g", sum.after, r.lower);
        ok = ok && gen_check(g, r.value <= sum.after * (1 + 0x1p-40), "ceres is better: %.17g < %.17g", sum.after, r.value);
        ok = ok && gen_check(g, sum.after <= r.value * (1 + 1e-5) + 1e-8 * (double)c.nov, "ceres: %.17g, optimum %.17g", sum.after, r.value);
    }
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* Bilinear patches over parameters 0, .., 0, 1: each corner sees `many` data points of its own, and is their median. */
static bool medians(optimum_case *c, size_t many)
{
    et_surface *const s = &c->fit.shell.view[ET_BOTTOM];

    if (!optimum_case_new(c, 1, 1, (et_doublenet){2, 2}, (et_doublenet){many + 1, 2}))
        return false;
    optimum_case_even(s->u, 2, 1);
    optimum_case_even(s->v, 2, 1);
    c->fit.s[ET_BOTTOM][many] = 1;
    c->fit.r[ET_BOTTOM][1] = 1;
    return true;
}

static double distance(et_vec3 a, et_vec3 b)
{
    return et_vec3_distance(a, b);
}

/* Fermat's point: the least sum of distances from three points. */
static double fermat(et_vec3 A, et_vec3 B, et_vec3 C)
{
    const double a = distance(B, C), b = distance(C, A), c = distance(A, B);
    const double x = fmax(a, fmax(b, c)), sum = a + b + c, z = fmin(a, fmin(b, c)), y = sum - x - z;
    const et_vec3 p = {B.x - A.x, B.y - A.y, B.z - A.z}, q = {C.x - A.x, C.y - A.y, C.z - A.z};
    const double n[3] = {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
    const double area = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;

    if (x * x >= y * y + z * z + y * z)    /* an angle of 120 degrees or more: its vertex */
        return y + z;
    return sqrt((a * a + b * b + c * c) / 2 + 2 * sqrt(3.0) * area);
}

/* Three points: Fermat's; any number on a line: the middle one.  The corners (0,0) and (0,1) have `many` points each, the others one, met exactly. */
verdict prop_optimum_find_median(gen *g)
{
    const bool line = gen_chance(g, 2);
    const size_t many = line ? gen_between(g, 1, 7) : 3;
    optimum_case c;
    et_optimum_result r;
    et_vec3 dual[CLASSES];
    double want = 0;
    bool ok = medians(&c, many);

    for (size_t k = 0; ok && k < c.nov; k++)
        c.data[k] = line ? (et_vec3){(double)gen_upto(g, 16), 0, 0} : some_point(g, 4);
    for (size_t j = 0; ok && j < 2; j++) {
        double x[8];

        for (size_t k = 0; k < many; k++)
            x[k] = c.data[2 * k + j].x;
        ascending(x, many);
        for (size_t k = 0; k < many && line; k++)
            want += fabs(x[k] - x[many / 2]);
        want += line ? 0 : fermat(c.data[j], c.data[2 + j], c.data[4 + j]);
    }
    for (size_t k = 0; k < c.n; k++)
        c.start[k] = some_point(g, 4);
    optimum_case_close(&c);
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_OK, "not done") && owed(g, &c, &r, dual);
    ok = ok && gen_check(g, r.lower <= want * (1 + 0x1p-45) && want <= r.value * (1 + 0x1p-45) + 0x1p-60 && r.gap <= 1e-9,
                         "%.17g is not within [%.17g, %.17g]", want, r.lower, r.value);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* Axes exchanged, mirrored, scaled by a power of two, shifted: the minimum goes along. */
/* One case in 20. */
verdict prop_optimum_find_moved(gen *g)
{
    const int shift = (int)gen_upto(g, 600) - 300;
    const double scale = ldexp(gen_chance(g, 2) ? -1 : 1, shift), offset = (double)gen_upto(g, 1024);
    optimum_case c;
    et_optimum_result a, b;
    et_vec3 dual[CLASSES];
    bool ok = draw(g, &c, true);

    ok = ok && gen_check(g, find(&c, &a, dual) == ET_OK, "not done");
    for (size_t k = 0; k < c.nov; k++)
        c.data[k] = (et_vec3){scale * (c.data[k].y + offset), scale * c.data[k].z, scale * c.data[k].x};
    for (size_t k = 0; k < c.n; k++)
        c.start[k] = (et_vec3){scale * (c.start[k].y + offset), scale * c.start[k].z, scale * c.start[k].x};
    et_shell_scatter(&c.fit.shell, c.start, c.n);
    ok = ok && gen_check(g, find(&c, &b, dual) == ET_OK, "not done") && owed(g, &c, &b, dual);
    b.value /= fabs(scale);
    b.lower /= fabs(scale);
    /* the data were rounded by half an ulp of the offset */
    ok = ok && gen_check(g, a.lower <= b.value + 0x1p-53 * 1024 * (double)c.nov && b.lower <= a.value + 0x1p-53 * 1024 * (double)c.nov,
                         "[%.17g, %.17g] and [%.17g, %.17g] are apart", a.lower, a.value, b.lower, b.value);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* Data of the surface itself, whether or not they determine it: E* is what rounding makes of 0. */
/* One case in 8. */
verdict prop_optimum_find_interpolated(gen *g)
{
    optimum_case c;
    et_optimum_result r;
    et_vec3 dual[CLASSES];
    double work[512];
    const bool flat = gen_chance(g, 3), far = gen_chance(g, 4), tame = far || !gen_chance(g, 2);
    bool ok = draw(g, &c, tame);
    const double scale = fmin(fmax(greatest(c.start, c.n), 0x1p-500), 0x1p+500);

    for (size_t k = 0; k < c.n; k++)        /* flat: all points are equal */
        c.start[k] = flat ? (et_vec3){scale, 0, -scale} : some_point(g, scale);
    et_shell_scatter(&c.fit.shell, c.start, c.n);
    for (size_t k = 0; k < c.nov; k++) {
        const et_index at = et_doublenet_index(c.fit.data, k + 1);
        const et_surface *const s = &c.fit.shell.view[at.k == 2];

        c.data[k] = flat ? c.start[0] : et_surface_point(s, c.fit.s[0][at.i], c.fit.r[0][at.j], work, et_surface_work(s));
    }
    for (size_t k = 0; k < c.n; k++)        /* from far away, one round of steps leaves their rounding */
        c.start[k] = some_point(g, far ? 0x1p+40 * scale : scale);
    et_shell_scatter(&c.fit.shell, c.start, c.n);
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_OK, "not done") && owed(g, &c, &r, dual);
    gen_label(g, r.value <= 1e-9 * scale ? "met" : "not met");
    /* knots and parameters an ulp apart determine some control points by their last bits alone: then only what is told must be true */
    ok = ok && gen_check(g, !tame || r.gap <= 1e-9 * scale, "value %g, gap %g, scale %g", r.value, r.gap, scale);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* From the minimum on: nothing gets worse, and nothing much better. */
/* One case in 40. */
verdict prop_optimum_find_again(gen *g)
{
    optimum_case c;
    et_optimum_result first, r;
    et_vec3 dual[CLASSES];
    bool ok = draw(g, &c, true);

    ok = ok && gen_check(g, find(&c, &first, dual) == ET_OK, "not done");
    for (int k = 0; k < 3 && ok; k++) {     /* each time rounding may go wrong */
        const double before = first.value;

        ok = gen_check(g, find(&c, &first, dual) == ET_OK && first.before == before && first.value <= before, "worse: %a after %a", first.value, before);
    }
    et_shell_gather(c.start, c.n, &c.fit.shell);
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_OK, "not done") && owed(g, &c, &r, dual);
    ok = ok && gen_check(g, r.before == first.value && r.value >= first.lower && r.gap <= 1e-9, "gap %g", r.gap);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

typedef struct { size_t calls, stop_at, total; et_status status; bool ok; } stopper;

static et_status stop_step(void *context, size_t done, size_t total)
{
    stopper *const s = context;

    s->calls++;
    s->ok = s->ok && done == s->calls && total == s->total;
    return s->calls == s->stop_at ? s->status : ET_OK;
}

/* Stopped by the caller, or by the number of iterations: what is delivered is certified all the same.  History never rises. */
/* One case in 8. */
verdict prop_optimum_find_stop(gen *g)
{
    const size_t limit = gen_upto(g, 12), room = gen_upto(g, 14);
    stopper s = {0, 1 + gen_upto(g, 12), limit, gen_chance(g, 2) ? ET_EIO : ET_ESTOPPED, true};
    const et_task task = {stop_step, &s};
    const et_optimum_options o = {limit, gen_chance(g, 4) ? 1e-3 : 0};
    optimum_case c;
    et_optimum_result r;
    et_vec3 dual[CLASSES];
    double history[16];
    et_status status;
    bool ok = draw(g, &c, true);

    for (size_t k = 0; k < 16; k++)
        history[k] = -1;
    status = et_optimum_find(&c.fit, &r, dual, history, room, c.data, c.nov, &o, &task, NULL);
    ok = ok && owed(g, &c, &r, dual) && gen_check(g, s.ok && s.calls == r.iterations && r.iterations <= limit, "told wrongly");
    ok = ok && gen_check(g, status == (s.calls == s.stop_at ? s.status : ET_OK), "status %d", (int)status);
    ok = ok && gen_check(g, status != ET_OK || r.iterations == limit || r.gap <= (o.gap > 0 ? o.gap : 1e-9) * r.value, "ended early");
    for (size_t k = 0; k < 16 && ok; k++) {
        ok = gen_check(g, (k < room && k < r.iterations) == (history[k] >= 0), "entry %zu is %g", k, history[k]);
        if (ok && k > 0 && history[k] >= 0)
            ok = gen_check(g, history[k] <= history[k - 1], "history rises");
    }
    if (ok && r.iterations > 0 && r.iterations <= room)     /* 2^10 roundings of terms up to 4 times NOV */
        ok = gen_check(g, fabs(history[r.iterations - 1] - r.value) <= 0x1p-41 * (double)c.nov, "history ends at %.17g, value %.17g",
                       history[r.iterations - 1], r.value);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* The same E with the parameters of both views exchanged is another problem; a net larger than the data, points without data: they stay. */
/* One case in 8. */
verdict prop_optimum_find_undetermined(gen *g)
{
    optimum_case c;
    et_optimum_result r;
    et_vec3 dual[CLASSES], P[CLASSES];
    const et_doublenet control = {gen_between(g, 4, SIDE), gen_between(g, 4, SIDE)}, data = {gen_between(g, 2, 6), gen_between(g, 2, 6)};
    et_surface *const s = &c.fit.shell.view[ET_BOTTOM];
    bool ok = optimum_case_new(&c, 3, 3, control, data);

    optimum_case_even(s->u, s->nu, 3);
    optimum_case_even(s->v, s->nv, 3);
    for (size_t i = 0; i < data.nx; i++)    /* the later half of the data see the first span alone */
        c.fit.s[ET_BOTTOM][i] = i + 1 == data.nx ? 1 : (double)i / (double)data.nx * (gen_chance(g, 2) ? 0x1p-4 : 1);
    ascending(c.fit.s[ET_BOTTOM], data.nx);
    for (size_t j = 0; j < data.ny; j++)
        c.fit.r[ET_BOTTOM][j] = (double)j / (double)(data.ny - 1);
    for (size_t k = 0; k < c.nov; k++)
        c.data[k] = some_point(g, 1);
    for (size_t k = 0; k < c.n; k++)
        c.start[k] = some_point(g, 1);
    optimum_case_close(&c);
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_OK, "not done") && owed(g, &c, &r, dual) && below_all(g, &c, r.lower, 1);
    ok = ok && gen_check(g, r.gap <= 1e-9 * fmax(1, r.value), "gap %g of %g", r.gap, r.value);
    et_shell_gather(P, c.n, &c.fit.shell);
    for (size_t k = 0; k < c.n && ok; k++) {
        const et_index at = et_doublenet_index(control, k + 1);
        bool seen = false;

        for (size_t i = 0; i < data.nx; i++)
            seen = seen || (s->u[at.i] < c.fit.s[0][i] && c.fit.s[0][i] < s->u[at.i + 4]) || (at.i == 0 && c.fit.s[0][i] == 0) || at.i + 1 == s->nu;
        ok = gen_check(g, seen || memcmp(&P[k], &c.start[k], sizeof *P) == 0, "control point %zu has no data, and moved", k);
    }
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* Everything that must be refused is, and nothing is touched by it. */
verdict prop_optimum_find_refuses(gen *g)
{
    optimum_case c;
    et_optimum_result r = {1, 2, 3, 4, 5}, was = r;
    et_optimum_options o = et_optimum_defaults();
    et_vec3 dual[CLASSES] = {{7, 7, 7}};
    et_message message;
    et_surface *const top = &c.fit.shell.view[ET_TOP];
    double *kept;
    bool ok = draw(g, &c, true);
    const et_vec3 first = c.data[0], point = c.start[0];

    ok = ok && gen_check(g, et_optimum_find(NULL, &r, dual, NULL, 0, c.data, c.nov, NULL, NULL, &message) == ET_EINVAL, "null fit");
    ok = ok && gen_check(g, et_optimum_find(&c.fit, NULL, dual, NULL, 0, c.data, c.nov, NULL, NULL, NULL) == ET_EINVAL, "null result");
    ok = ok && gen_check(g, et_optimum_find(&c.fit, &r, dual, NULL, 0, NULL, c.nov, NULL, NULL, NULL) == ET_EINVAL, "null data");
    ok = ok && gen_check(g, et_optimum_find(&c.fit, &r, dual, NULL, 0, c.data, c.nov - 1, NULL, NULL, NULL) == ET_EINVAL, "nov too small");
    ok = ok && gen_check(g, et_optimum_find(&c.fit, &r, dual, NULL, 0, c.data, c.nov + 1, NULL, NULL, NULL) == ET_EINVAL, "nov too large");
    o.gap = gen_chance(g, 2) ? -0x1p-1074 : NAN;
    ok = ok && gen_check(g, et_optimum_find(&c.fit, &r, dual, NULL, 0, c.data, c.nov, &o, NULL, NULL) == ET_EINVAL, "bad gap");
    c.data[0].y = gen_chance(g, 2) ? NAN : INFINITY;
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_EINVAL, "data not finite");
    c.data[0] = (et_vec3){0x1.8p+1023, 0x1.8p+1023, 0};
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_EINVAL, "E overflows");
    c.data[0] = first;
    top->points[0].x += 1;
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_EINVAL, "open shell");
    top->points[0] = point;
    kept = c.fit.s[ET_TOP];
    c.fit.s[ET_TOP] = NULL;
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_EINVAL, "no parameters");
    c.fit.s[ET_TOP] = kept;
    c.fit.s[ET_TOP][1] += 0x1p-53;
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_EINVAL, "other parameters in the other view");
    c.fit.s[ET_BOTTOM][1] = c.fit.s[ET_TOP][1] = gen_chance(g, 2) ? 2 : NAN;
    ok = ok && gen_check(g, find(&c, &r, dual) == ET_EINVAL, "parameters out of order");
    ok = ok && gen_check(g, memcmp(&r, &was, sizeof r) == 0 && dual[0].x == 7 && memcmp(&c.fit.shell.view[0].points[0], &point, sizeof point) == 0,
                         "outputs touched");
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* ---- bound ---- */

/* Any y: random, the right one with a fault, huge, tiny, none. */
/* One case in 16. */
verdict prop_optimum_bound(gen *g)
{
    const bool tame = gen_chance(g, 2);
    const double size = ldexp(1, (int)gen_upto(g, 600) - 300);
    optimum_case c;
    et_optimum_result r;
    et_vec3 dual[CLASSES];
    double bound = -1, again = -1;
    size_t k;
    bool ok = draw(g, &c, tame);

    if (find(&c, &r, dual) != ET_OK) {
        optimum_case_end(&c);
        return tame ? FAIL : SKIP;
    }
    k = gen_upto(g, c.nov - 1);
    switch (gen_upto(g, 4)) {
    case 0: dual[k].x += gen_real(g, -2, 2); break;
    case 1: dual[k] = (et_vec3){-dual[k].x, -dual[k].y, -dual[k].z}; break;
    case 2: memset(dual, 0, sizeof dual); break;
    case 3: dual[k].z = dual[k].z * (1 + ldexp(1, -(int)gen_upto(g, 52))); break;
    default:
        for (size_t i = 0; i < c.nov; i++)
            dual[i] = some_point(g, 1);
    }
    ok = ok && gen_check(g, et_optimum_bound(&bound, dual, c.nov, &c.fit, c.data) == ET_OK, "not done");
    ok = ok && gen_check(g, bound >= 0 && bound <= r.value, "%a is a bound for a least value of at most %a", bound, r.value);
    for (size_t i = 0; i < c.nov; i++)
        dual[i] = (et_vec3){size * dual[i].x, size * dual[i].y, size * dual[i].z};
    ok = ok && gen_check(g, et_optimum_bound(&again, dual, c.nov, &c.fit, c.data) == ET_OK && same(again, bound), "size matters: %a, %a", again, bound);
    dual[k].y = gen_chance(g, 2) ? NAN : -INFINITY;
    ok = ok && gen_check(g, et_optimum_bound(&again, dual, c.nov, &c.fit, c.data) == ET_OK && again == 0, "no number proves %a", again);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* y whose sum with the data is known: one corner with its points at x = 0 and the others', y = -1 for the first and +1 for the last of two. */
verdict prop_optimum_bound_pair(gen *g)
{
    const double a = (double)gen_upto(g, 64), b = (double)gen_upto(g, 64), slant = ldexp(1, -(int)gen_upto(g, 10));
    optimum_case c;
    et_vec3 y[6] = {{0, 0, 0}};
    double bound = -1;
    bool ok = medians(&c, 2);

    optimum_case_close(&c);
    c.data[0].x = a;
    c.data[2].x = a + b;
    y[0].x = -slant;
    y[2].x = slant;
    ok = ok && gen_check(g, et_optimum_bound(&bound, y, c.nov, &c.fit, c.data) == ET_OK, "not done");
    ok = ok && gen_check(g, bound <= b && bound >= b * (1 - 0x1p-52), "%a, not %a", bound, b);
    y[2].x = 3 * slant;                    /* N'y is not 0: the nearest y that is, has -2, 2 there; the bound is the same */
    y[0].x = -slant;
    ok = ok && gen_check(g, et_optimum_bound(&bound, y, c.nov, &c.fit, c.data) == ET_OK, "not done");
    ok = ok && gen_check(g, bound <= b && bound >= b * (1 - 0x1p-52), "%a, not %a", bound, b);
    y[0].x = slant;                        /* the wrong way round: negative, so 0 */
    y[2].x = -slant;
    ok = ok && gen_check(g, et_optimum_bound(&bound, y, c.nov, &c.fit, c.data) == ET_OK && bound == 0, "%a, not 0", bound);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

verdict prop_optimum_bound_refuses(gen *g)
{
    optimum_case c;
    et_vec3 y[CLASSES] = {{1, 0, 0}};
    double bound = 7;
    bool ok = draw(g, &c, true);

    ok = ok && gen_check(g, et_optimum_bound(NULL, y, c.nov, &c.fit, c.data) == ET_EINVAL, "null bound");
    ok = ok && gen_check(g, et_optimum_bound(&bound, NULL, c.nov, &c.fit, c.data) == ET_EINVAL, "null dual");
    ok = ok && gen_check(g, et_optimum_bound(&bound, y, c.nov, NULL, c.data) == ET_EINVAL, "null fit");
    ok = ok && gen_check(g, et_optimum_bound(&bound, y, c.nov, &c.fit, NULL) == ET_EINVAL, "null data");
    ok = ok && gen_check(g, et_optimum_bound(&bound, y, c.nov + 1, &c.fit, c.data) == ET_EINVAL, "nov");
    c.data[c.nov - 1].z = NAN;
    ok = ok && gen_check(g, et_optimum_bound(&bound, y, c.nov, &c.fit, c.data) == ET_EINVAL, "data not finite");
    ok = ok && gen_check(g, bound == 7, "touched");
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* ---- golden ---- */

static bool read_case(optimum_case *c, size_t *at, const row *r)
{
    const size_t p = row_size(r, 0), q = row_size(r, 1), nu = row_size(r, 2), nv = row_size(r, 3), nx = row_size(r, 4), ny = row_size(r, 5);
    et_surface *const s = &c->fit.shell.view[ET_BOTTOM];

    *at = 6;
    if (nu > SIDE || nv > SIDE || nx > SIDE || ny > SIDE || !optimum_case_new(c, p, q, (et_doublenet){nu, nv}, (et_doublenet){nx, ny}))
        return false;
    for (size_t k = 0; k < nu + p + 1; k++)
        s->u[k] = row_real(r, (*at)++);
    for (size_t k = 0; k < nv + q + 1; k++)
        s->v[k] = row_real(r, (*at)++);
    for (size_t k = 0; k < nx; k++)
        c->fit.s[ET_BOTTOM][k] = row_real(r, (*at)++);
    for (size_t k = 0; k < ny; k++)
        c->fit.r[ET_BOTTOM][k] = row_real(r, (*at)++);
    for (size_t k = 0; k < 3 * c->nov; k++)
        (&c->data[0].x)[k] = row_real(r, (*at)++);
    optimum_case_close(c);
    return true;
}

/* From control points at 0. */
verdict gold_optimum_find(const row *r)
{
    optimum_case c;
    et_optimum_result result;
    size_t at;
    bool ok = read_case(&c, &at, r) && at == r->nargs && find(&c, &result, NULL) == ET_OK;

    ok = ok && row_is(r, 0, result.value) && row_is(r, 0, result.lower) && result.gap <= 2 * r->tolerance;
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

verdict gold_optimum_bound(const row *r)
{
    optimum_case c;
    et_vec3 y[CLASSES];
    double bound = -1;
    size_t at;
    bool ok = read_case(&c, &at, r) && at + 3 * c.nov == r->nargs;

    for (size_t k = 0; ok && k < 3 * c.nov; k++)
        (&y[0].x)[k] = row_real(r, at + k);
    ok = ok && et_optimum_bound(&bound, y, c.nov, &c.fit, c.data) == ET_OK && row_is(r, 0, bound);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}
