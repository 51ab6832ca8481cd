/* et_optimum_find put together a second time from its parts: rounds of the primal-dual method, each from the residuals of the best so far, then the
 * better of two duals.  Everything it tells is compared bit for bit. */
#include "etalon/refine/optimum.h"
#include "etalon/base/real.h"
#include "refine/optimum_cases.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NODES = 2 * OPTIMUM_MOST * OPTIMUM_MOST, HISTORY = 32 };

typedef struct {
    et_optimum_result result;
    et_vec3 dual[OPTIMUM_CLASSES];
    double history[HISTORY];
    size_t rounds;
    int proved;
    et_status status;
} expected;

/* A power of two not less than half the greatest coordinate nor greater than it, a normal number. */
static double unit_of(const double *r, size_t n)
{
    double unit = 0x1p-1021, most = 0;

    for (size_t k = 0; k < n; k++)
        most = fabs(r[k]) > most ? fabs(r[k]) : most;
    if (most == 0)
        return 1;
    while (unit <= most && unit < 0x1p+1023)
        unit *= 2;
    return unit;
}

static void directions(double *y, double *r, size_t nov, double unit)
{
    for (size_t c = 0; c < nov; c++) {
        const double a = r[3 * c] / unit, b = r[3 * c + 1] / unit, d = r[3 * c + 2] / unit, length = sqrt(a * a + b * b + d * d);
        const double all[3] = {a, b, d};

        for (size_t k = 0; k < 3; k++) {
            r[3 * c + k] = all[k];
            y[3 * c + k] = length == 0 ? 0 : all[k] / length;
        }
    }
}

/* Where control class c is kept its step is added, unless the sum is no number. */
static void stepped(et_vec3 *P, const optimum_case *c, const optimum_model *m, const double *x, double unit)
{
    double X[3 * NODES];

    optimum_model_points(X, m, x);
    for (size_t k = 0; k < c->n; k++) {
        const et_index at = et_doublenet_index(c->control, k + 1);
        const size_t place = optimum_model_place(m, at.k == 2 ? 1 : 0, at.i, at.j);
        const int shift = m->u.shift[at.i] + m->v.shift[at.j];

        if (place != SIZE_MAX) {
            const double *const s = X + 3 * place;
            const et_vec3 p = {P[k].x + ldexp(s[0], shift) * unit, P[k].y + ldexp(s[1], shift) * unit, P[k].z + ldexp(s[2], shift) * unit};

            P[k] = isfinite(p.x) && isfinite(p.y) && isfinite(p.z) ? p : P[k];
        }
    }
}

static bool rounds(expected *e, optimum_case *c, const optimum_model *m, optimum_search *s)
{
    const size_t nov = c->nov;
    double value, before, y[3 * OPTIMUM_CLASSES], polished = 0;
    et_vec3 P[OPTIMUM_CLASSES];

    optimum_ball_value(&e->result.before, NULL, &c->fit, m, c->data);
    e->result.value = e->result.before;
    do {
        before = e->result.value;
        optimum_ball_value(&value, s->D, &c->fit, m, c->data);
        s->unit = unit_of(s->D, 3 * nov);
        directions(s->y, s->D, nov, s->unit);
        for (size_t k = 0; k < 3 * m->m; k++)
            s->x[k] = 0;
        if (optimum_cone_run(s) != ET_OK)
            return false;
        et_shell_gather(P, c->n, &c->fit.shell);
        stepped(P, c, m, s->x, s->unit);
        et_shell_gather(c->start, c->n, &c->fit.shell);
        et_shell_scatter(&c->fit.shell, P, c->n);
        optimum_ball_value(&value, NULL, &c->fit, m, c->data);
        if (value <= e->result.value)
            e->result.value = value;
        else
            et_shell_scatter(&c->fit.shell, c->start, c->n);
        e->rounds++;
    } while (e->rounds < 4 && s->status == ET_OK && s->iterations < s->limit && ldexp(before, -16) > e->result.value);
    memcpy(y, s->y, 3 * nov * sizeof *y);
    if (optimum_ball_bound(&e->result.lower, &e->proved, s->y, m, c->data) != ET_OK || optimum_ball_polish(y, m, s->weight) != ET_OK ||
        optimum_ball_bound(&polished, &e->proved, y, m, c->data) != ET_OK)
        return false;
    for (size_t k = 0; k < nov; k++) {
        const double *const best = (polished > e->result.lower ? y : s->y) + 3 * k;

        e->dual[k] = (et_vec3){best[0], best[1], best[2]};
    }
    e->result.lower = fmax(e->result.lower, polished);
    e->result.iterations = s->iterations;
    e->result.gap = e->result.value - e->result.lower;
    if (e->result.gap > 0)
        e->result.gap += e->result.gap * ET_EPS + 0x1p-1074;
    e->status = s->status;
    return true;
}

static bool expect(expected *e, optimum_case *c, size_t room, const et_optimum_options *o, const et_task *task)
{
    optimum_model m;
    optimum_search s = {0};
    bool ok = optimum_model_new(&m, &c->fit) == ET_OK;

    s.model = &m;
    s.task = task;
    s.history = e->history;
    s.room = room;
    s.limit = o->iterations;
    s.tolerance = o->gap;
    s.D = calloc(3 * c->nov, sizeof(double));
    s.y = calloc(3 * c->nov, sizeof(double));
    s.x = calloc(3 * m.m + 1, sizeof(double));
    s.weight = calloc(6 * c->nov, sizeof(double));
    ok = ok && s.D && s.y && s.x && s.weight && rounds(e, c, &m, &s);
    free(s.D);
    free(s.y);
    free(s.x);
    free(s.weight);
    optimum_model_free(&m);
    return ok;
}

typedef struct { size_t calls, stop_at; } stopper;

static et_status stop_step(void *context, size_t done, size_t total)
{
    stopper *const s = context;

    (void)done;
    (void)total;
    return ++s->calls == s->stop_at ? ET_ESTOPPED : ET_OK;
}

/* Data of all sizes, up to the greatest and the least doubles; on the surface itself, near it, far from the start. */
static void draw_data(gen *g, optimum_case *c)
{
    const size_t kind = gen_upto(g, 7);
    const double scale = kind == 1 ? 0x1p-1070 : kind == 2 ? 0x1p+1000 : kind == 3 ? ldexp(1, (int)gen_upto(g, 2000) - 1000) : 1;
    double work[512];

    for (size_t k = 0; k < c->nov; k++)
        c->data[k] = (et_vec3){scale * c->data[k].x, scale * c->data[k].y, scale * c->data[k].z};
    for (size_t k = 0; k < c->n; k++)
        c->start[k] = (et_vec3){scale * c->start[k].x, scale * c->start[k].y, scale * c->start[k].z};
    for (size_t k = 0; k < c->nov && kind >= 5; k++) {      /* on the surface but for the first, which may be off it by little */
        const et_index at = et_doublenet_index(c->fit.data, k + 1);
        const et_surface *const s = &c->fit.shell.view[at.k == 2];

        c->data[k] = et_surface_point(s, c->fit.s[0][at.i], c->fit.r[0][at.j], work, et_surface_work(s));
        c->data[k].x += k == 0 && kind == 7 ? ldexp(1, -(int)gen_upto(g, 60)) : 0;
    }
    for (size_t k = 0; k < c->n && kind >= 5; k++)
        c->start[k].y += ldexp(gen_real(g, -1, 1), (int)gen_upto(g, 50));
    if (kind == 4) {                      /* one coordinate near the greatest double */
        const size_t end = gen_upto(g, 2);

        memset(c->data, 0, sizeof c->data);
        memset(c->start, 0, sizeof c->start);
        (&c->data[0].x)[end == 0 ? 0 : end == 1 ? 3 * c->nov - 1 : gen_upto(g, 3 * c->nov - 1)] = gen_chance(g, 2) ? 0x1.8p+1022 : 0x1.8p+1023;
    }
    et_shell_scatter(&c->fit.shell, c->start, c->n);
}

static bool same_reals(gen *g, const char *what, double got, double want)
{
    return gen_check(g, optimum_case_same(&got, &want, 1), "%s %a, not %a", what, got, want);
}

static bool same_result(gen *g, const et_optimum_result *r, const expected *e)
{
    return same_reals(g, "before", r->before, e->result.before) && same_reals(g, "value", r->value, e->result.value) &&
           same_reals(g, "lower", r->lower, e->result.lower) && same_reals(g, "gap", r->gap, e->result.gap) &&
           gen_check(g, r->iterations == e->result.iterations, "%zu iterations, not %zu", r->iterations, e->result.iterations);
}

static const char unproved[] = "no lower bound but 0 is proved: the control points are not determined by the data";

/* One case in 10. */
verdict prop_optimum_find_rounds(gen *g)
{
    static expected e;
    const et_optimum_options o = {gen_chance(g, 3) ? gen_chance(g, 2) ? 0 : gen_upto(g, 12) : 100, gen_chance(g, 4) ? 0x1p-10 : 1e-12};
    stopper first = {0, gen_chance(g, 6) ? gen_upto(g, 8) : 0}, second = first;
    const et_task one = {stop_step, &first}, two = {stop_step, &second};
    const size_t room = gen_upto(g, HISTORY);
    optimum_case c;
    et_optimum_result r = {0, 0, 0, 0, 0};
    et_vec3 dual[OPTIMUM_CLASSES], P[OPTIMUM_CLASSES], Q[OPTIMUM_CLASSES];
    et_message message = {"left alone"};
    double history[HISTORY] = {0};
    et_status status;
    bool ok = optimum_case_draw(g, &c, (optimum_state)gen_upto(g, 3));

    draw_data(g, &c);
    memset(&e, 0, sizeof e);
    status = et_optimum_find(&c.fit, &r, dual, history, room, c.data, c.nov, &o, &one, &message);
    et_shell_gather(P, c.n, &c.fit.shell);
    et_shell_scatter(&c.fit.shell, c.start, c.n);
    ok = ok && gen_check(g, status == ET_OK || status == ET_ESTOPPED, "status %d: %s", (int)status, message.text);
    ok = ok && gen_check(g, expect(&e, &c, room, &o, &two), "not computed") && gen_check(g, status == e.status, "status %d", (int)status);
    et_shell_gather(Q, c.n, &c.fit.shell);
    ok = ok && same_result(g, &r, &e) && gen_check(g, memcmp(P, Q, c.n * sizeof *P) == 0, "control points");
    ok = ok && gen_check(g, memcmp(dual, e.dual, c.nov * sizeof *dual) == 0, "dual") &&
         gen_check(g, memcmp(history, e.history, sizeof history) == 0, "history");
    ok = ok && gen_check(g, strcmp(message.text, e.proved ? "left alone" : unproved) == 0, "message: %s", message.text);
    gen_label(g, e.rounds > 2 ? "rounds: 3 or 4" : e.rounds == 2 ? "rounds: 2" : "rounds: 1");
    gen_label(g, e.proved ? "proved" : "nothing proved");
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* ---- what is refused, and in which words ---- */

typedef struct { gen *g; optimum_case c; et_optimum_result r; et_vec3 dual[OPTIMUM_CLASSES]; } refusal;

static const char no_fit[] = "optimum: no closed polynomial fit of these data with equal parameters in both views";
static const char no_shell[] = "optimum: the shell is not glued along its border, or there are no parameters";

/* Refused by both functions, in these words, and nothing touched. */
static bool refused(refusal *k, const char *words)
{
    const et_optimum_result was = k->r;
    et_message message = {"none"};
    double lower = 7;
    bool ok = gen_check(k->g, et_optimum_find(&k->c.fit, &k->r, NULL, NULL, 0, k->c.data, k->c.nov, NULL, NULL, &message) == ET_EINVAL,
                        "not refused: %s", words);

    ok = ok && gen_check(k->g, strcmp(message.text, words) == 0, "%s, not %s", message.text, words);
    ok = ok && gen_check(k->g, et_optimum_bound(&lower, k->dual, k->c.nov, &k->c.fit, k->c.data) == ET_EINVAL && lower == 7, "a bound: %s", words);
    return ok && gen_check(k->g, memcmp(&was, &k->r, sizeof was) == 0, "result touched");
}

/* A parameter of both views at once, so that they stay equal. */
static bool refused_parameter(refusal *k, double **t, size_t i, double value)
{
    const double was = t[0][i];
    bool ok;

    t[0][i] = t[1][i] = value;
    ok = refused(k, no_fit);
    t[0][i] = t[1][i] = was;
    return ok;
}

static bool refused_parameters(refusal *k, double **t, size_t n)
{
    bool ok = true;

    for (size_t i = 0; i < n && ok; i++)
        ok = refused_parameter(k, t, i, NAN);
    ok = ok && refused_parameter(k, t, 0, -INFINITY) && refused_parameter(k, t, n - 1, INFINITY);
    for (size_t i = 0; i + 1 < n && ok; i++)
        ok = refused_parameter(k, t, i, 2);
    return ok;
}

static bool refused_null(refusal *k, double **t)
{
    double *const was = *t;
    bool ok;

    *t = NULL;
    ok = refused(k, no_shell);
    *t = was;
    return ok;
}

/* One case in 20. */
verdict prop_optimum_find_refuses_each(gen *g)
{
    refusal k = {.g = g, .r = {1, 2, 3, 4, 5}};
    et_surface *const top = &k.c.fit.shell.view[ET_TOP];
    et_message message = {"none"};
    et_optimum_options o = {100, -1};
    bool ok = optimum_case_draw(g, &k.c, TAME);
    const et_doublenet data = k.c.fit.data;

    for (size_t w = 0; w < 2 && ok; w++)
        ok = refused_null(&k, &k.c.fit.s[w]) && refused_null(&k, &k.c.fit.r[w]);
    ok = ok && refused_parameters(&k, k.c.fit.s, data.nx) && refused_parameters(&k, k.c.fit.r, data.ny);
    top->points[0].z += 1;
    ok = ok && refused(&k, no_shell);
    top->points[0] = k.c.fit.shell.view[ET_BOTTOM].points[0];
    k.c.fit.data = (et_doublenet){data.ny + 1, data.nx + 1};
    ok = ok && refused(&k, no_fit);
    k.c.fit.data = (et_doublenet){1, 1};
    ok = ok && refused(&k, no_fit);
    k.c.fit.data = data;
    k.c.data[k.c.nov - 1].x = INFINITY;
    k.c.nov--;                            /* what is said first */
    k.c.data[0].y = NAN;
    ok = ok && refused(&k, no_fit);
    k.c.data[0].y = 0;
    k.c.nov++;
    ok = ok && refused(&k, "optimum: the data are not finite");
    k.c.data[k.c.nov - 1].x = 0;
    ok = ok && gen_check(g, et_optimum_find(&k.c.fit, &k.r, NULL, NULL, 0, k.c.data, k.c.nov, &o, NULL, &message) == ET_EINVAL &&
                               strcmp(message.text, "optimum: a gap of -1 is none") == 0, "%s", message.text);
    k.c.data[0] = (et_vec3){0x1.8p+1023, 0x1.8p+1023, 0};
    ok = ok && gen_check(g, et_optimum_find(&k.c.fit, &k.r, NULL, NULL, 0, k.c.data, k.c.nov, NULL, NULL, &message) == ET_EINVAL &&
                               strcmp(message.text, "optimum: E overflows") == 0, "%s", message.text);
    ok = ok && gen_check(g, k.r.before == 1 && k.r.iterations == 5, "result touched");
    optimum_case_end(&k.c);
    return ok ? PASS : FAIL;
}
