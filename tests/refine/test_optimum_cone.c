/* The primal-dual method a second time, on arrays of four numbers a cone, from the same equations of the model: everything it finds and tells is
 * compared bit for bit.  A step that is only nearly right still ends in a valid bound, and is seen here alone. */
#include "etalon/refine/optimum.h"
#include "etalon/base/real.h"
#include "refine/optimum_cases.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { C = OPTIMUM_CLASSES, NODES = 2 * OPTIMUM_MOST * OPTIMUM_MOST, HISTORY = 40 };

/* (t, r): the first stands for t. */
typedef double four[4];

typedef struct {
    optimum_search *s;
    const optimum_model *m;
    size_t nov, unknowns, idle;
    optimum_solver blocks, numbers;
    four at[C], step[C], right[C];        /* (t, r), its step, and right sides */
    four q[C], v[C], lambda[C];           /* Nesterov and Todd's scaling, eta too */
    double eta[C], y[3 * C], dy[3 * C], x[3 * NODES], dx[3 * NODES], weight[6 * C], w[3 * C];
    double value, dual;
} twin;

static double dot3(const double *a, const double *b)
{
    double s = a[0] * b[0];

    s += a[1] * b[1];
    s += a[2] * b[2];
    return s;
}

static double length3(const double *a)
{
    return sqrt(dot3(a, a));
}

/* b = factor (2 v v' - diag(1, -1, -1, -1)) a; v mirrored where sign is -1. */
static void apply(four b, const four v, double sign, double factor, const four a)
{
    const four u = {v[0], sign * v[1], sign * v[2], sign * v[3]};
    const double twice = 2 * (u[0] * a[0] + dot3(u + 1, a + 1));
    four out;

    for (int k = 0; k < 4; k++)
        out[k] = factor * (k == 0 ? twice * u[0] - a[0] : twice * u[k] + a[k]);
    memcpy(b, out, sizeof out);
}

/* The product of (1, 1) and (t, |r|) in the plane: t^2 - |r|^2. */
static double room_in(const four a)
{
    const double r = length3(a + 1);

    return (a[0] - r) * (a[0] + r);
}

static double residuals_of(twin *a)
{
    double r[3 * C], length[C];

    memcpy(r, a->s->D, 3 * a->nov * sizeof *r);
    optimum_model_apply(r, a->m, a->x);
    for (size_t c = 0; c < a->nov; c++) {
        memcpy(a->at[c] + 1, r + 3 * c, 3 * sizeof *r);
        length[c] = length3(r + 3 * c);
    }
    return et_real_sum(length, a->nov);
}

static double bound_of(const twin *a)
{
    double part[C], longest = 1;

    for (size_t c = 0; c < a->nov; c++) {
        part[c] = dot3(a->y + 3 * c, a->at[c] + 1);
        if (length3(a->y + 3 * c) > longest)
            longest = length3(a->y + 3 * c);
    }
    return et_real_sum(part, a->nov) / longest;
}

static bool balanced(const twin *a)
{
    double f[3 * NODES];

    optimum_model_adjoint(f, a->m, a->y);
    for (size_t k = 0; k < a->unknowns; k++)
        if (!(f[k] < 0x1p-40 && f[k] > -0x1p-40))
            return false;
    return true;
}

/* What a step found; true: the last. */
static bool done(twin *a, bool starting)
{
    optimum_search *const s = a->s;
    const double gap = a->value - a->dual, value = residuals_of(a), dual = bound_of(a);

    if (value < a->value) {
        a->value = value;
        memcpy(s->x, a->x, a->unknowns * sizeof *a->x);
    }
    if (dual > a->dual && balanced(a)) {
        a->dual = dual;
        memcpy(s->y, a->y, 3 * a->nov * sizeof *a->y);
        memcpy(s->weight, a->weight, 6 * a->nov * sizeof *a->weight);
    }
    a->idle++;
    if (starting || a->value - a->dual < 0.75 * gap)
        a->idle = 0;
    if (s->iterations < s->room) {
        double told = a->value * s->unit;

        if (s->iterations > 0 && s->history[s->iterations - 1] < told)
            told = s->history[s->iterations - 1];
        s->history[s->iterations] = told;
    }
    s->status = et_task_step(s->task, ++s->iterations, s->limit);
    return s->status != ET_OK || s->iterations == s->limit || a->value - a->dual <= s->tolerance / 4 * a->value || a->idle == 5;
}

/* ---- the start: six times reweighted, mu halved, or half the mean distance ---- */

static double reweighted(twin *a, double mu)
{
    double weight[C], force[3 * NODES], longest = 0;

    for (size_t c = 0; c < a->nov; c++) {
        weight[c] = 1 / sqrt(dot3(a->at[c] + 1, a->at[c] + 1) + mu * mu);
        for (size_t d = 0; d < 3; d++)
            a->y[3 * c + d] = weight[c] * a->at[c][1 + d];
    }
    optimum_solve_factor(&a->numbers, weight);
    optimum_model_adjoint(force, a->m, a->y);
    optimum_solve_run(&a->numbers, force, 0x1p-50);
    optimum_solve_take(a->dx, a->w, &a->numbers);
    for (size_t k = 0; k < a->unknowns; k++)
        a->x[k] += a->dx[k];
    residuals_of(a);
    for (size_t c = 0; c < a->nov; c++) {
        const double all[6] = {weight[c], 0, 0, weight[c], 0, weight[c]};

        memcpy(a->weight + 6 * c, all, sizeof all);
        for (size_t d = 0; d < 3; d++)
            a->y[3 * c + d] = weight[c] * a->at[c][1 + d];
        longest = fmax(longest, length3(a->y + 3 * c));
    }
    if (longest > 0.9)
        for (size_t k = 0; k < 3 * a->nov; k++)
            a->y[k] *= 0.9 / longest;
    return longest;
}

static bool started(twin *a)
{
    const double n = (double)a->nov;
    double mu = a->value / n;

    for (int step = 1; step <= 6; step++) {
        reweighted(a, mu);
        if (done(a, true))
            return false;
        if (step < 6)
            mu = fmin(mu / 2, a->value / n / 2);
    }
    for (size_t c = 0; c < a->nov; c++)
        a->at[c][0] = mu + sqrt(mu * mu + dot3(a->at[c] + 1, a->at[c] + 1));
    return true;
}

/* ---- a step inside the cones ---- */

static void scaled(twin *a, size_t c)
{
    const double *const x = a->at[c], *const y = a->y + 3 * c;
    const four z = {1, y[0], y[1], y[2]};
    const double dx = sqrt(room_in(x)), dz = sqrt(room_in(z)), gamma = sqrt((1 + (x[0] - dot3(x + 1, y)) / (dx * dz)) / 2);
    double d, e, f;

    for (int k = 0; k < 4; k++)
        a->q[c][k] = (k == 0 ? 1 : -1) * (x[k] / dx + z[k] / dz) / (2 * gamma);
    d = sqrt(2 * (a->q[c][0] + 1));
    for (int k = 0; k < 4; k++)
        a->v[c][k] = (k == 0 ? a->q[c][k] + 1 : a->q[c][k]) / d;
    a->eta[c] = sqrt(dz / dx);
    apply(a->lambda[c], a->v[c], 1, a->eta[c], x);
    e = a->eta[c] * a->eta[c];
    f = 2 / (1 + 2 * dot3(a->q[c] + 1, a->q[c] + 1));
    for (int i = 0, at = 0; i < 3; i++)
        for (int j = i; j < 3; j++)
            a->weight[6 * c + (size_t)at++] = e * (i == j ? 1 - f * a->q[c][1 + i] * a->q[c][1 + j] : -f * a->q[c][1 + i] * a->q[c][1 + j]);
}

/* W^-1 (lambda \ (target e - (W^-1 dx) o (W dz))), the product only if second. */
static void aimed(twin *a, size_t c, double target, bool second)
{
    const double *const l = a->lambda[c];
    const four dz = {0, -a->dy[3 * c], -a->dy[3 * c + 1], -a->dy[3 * c + 2]};
    four p = {0}, q = {0}, u, s;

    if (second) {
        apply(p, a->v[c], 1, a->eta[c], a->step[c]);
        apply(q, a->v[c], -1, 1 / a->eta[c], dz);
    }
    u[0] = target - (p[0] * q[0] + dot3(p + 1, q + 1));
    for (int k = 1; k < 4; k++)
        u[k] = -(p[0] * q[k] + q[0] * p[k]);
    s[0] = (l[0] * u[0] - dot3(l + 1, u + 1)) / room_in(l);
    for (int k = 1; k < 4; k++)
        s[k] = (u[k] - s[0] * l[k]) / l[0];
    apply(a->right[c], a->v[c], 1, a->eta[c], s);
}

static void solved(twin *a, double accuracy)
{
    double force[3 * NODES];

    for (size_t c = 0; c < a->nov; c++) {
        const double e = a->eta[c] * a->eta[c], q0 = a->q[c][0];

        for (size_t d = 0; d < 3; d++)
            a->dy[3 * c + d] = 2 * e * q0 * a->q[c][1 + d] * (a->right[c][0] - 1) / (e * (2 * q0 * q0 - 1)) - a->right[c][1 + d];
    }
    optimum_model_adjoint(force, a->m, a->dy);
    optimum_solve_run(&a->blocks, force, accuracy);
    optimum_solve_take(a->dx, a->w, &a->blocks);
    for (size_t c = 0; c < a->nov; c++) {
        const double *const q = a->q[c] + 1, qq = dot3(q, q), q0 = a->q[c][0], e = a->eta[c] * a->eta[c], free = a->right[c][0] - 1;
        double along, share = 2 * q0 * free / (1 + 2 * qq);

        for (size_t d = 0; d < 3; d++)
            a->step[c][1 + d] = -a->w[3 * c + d];
        along = dot3(q, a->step[c] + 1);
        a->step[c][0] = (free / e - 2 * q0 * along) / (1 + 2 * qq);
        if (qq > 0)
            share += e * along / (qq * (1 + 2 * qq));
        for (size_t d = 0; d < 3; d++)
            a->dy[3 * c + d] = e * (qq > 0 ? a->step[c][1 + d] - along / qq * q[d] : a->step[c][1 + d]) + share * q[d] - a->y[3 * c + d] - a->right[c][1 + d];
    }
}

/* The least positive root of |r + s dr| = t + s dt, or infinity. */
static double to_boundary(const four a, const four d)
{
    const double c = room_in(a), b = a[0] * d[0] - dot3(a + 1, d + 1), k = d[0] * d[0] - dot3(d + 1, d + 1), root = b * b - k * c;

    return root >= 0 && sqrt(root) - b > 0 ? c / (sqrt(root) - b) : HUGE_VAL;
}

/* Steps, shortened, at most 1; the complementarity after them. */
static double lengths(const twin *a, double share, double *primal, double *dual)
{
    double sum = 0;

    *primal = *dual = HUGE_VAL;
    for (size_t c = 0; c < a->nov; c++) {
        const double *const y = a->y + 3 * c, *const dy = a->dy + 3 * c;
        const four z = {1, y[0], y[1], y[2]}, dz = {0, dy[0], dy[1], dy[2]};

        *primal = fmin(*primal, to_boundary(a->at[c], a->step[c]));
        *dual = fmin(*dual, to_boundary(z, dz));
    }
    *primal = fmin(share * *primal, 1);
    *dual = fmin(share * *dual, 1);
    for (size_t c = 0; c < a->nov; c++) {
        four x;
        double y[3], inner = 0;

        for (size_t k = 0; k < 4; k++)
            x[k] = a->at[c][k] + *primal * a->step[c][k];
        for (size_t d = 0; d < 3; d++) {
            y[d] = a->y[3 * c + d] + *dual * a->dy[3 * c + d];
            inner += x[1 + d] * y[d];
        }
        sum += x[0] - inner;
    }
    return sum;
}

static void directed(twin *a, double target, bool second, double accuracy)
{
    for (size_t c = 0; c < a->nov; c++)
        aimed(a, c, target, second);
    solved(a, accuracy);
}

static void stepped(twin *a, double primal, double dual)
{
    for (size_t k = 0; k < a->unknowns; k++)
        a->x[k] += primal * a->dx[k];
    residuals_of(a);
    for (size_t c = 0; c < a->nov; c++) {
        const double t = a->at[c][0] + primal * a->step[c][0], least = length3(a->at[c] + 1) * (1 + 0x1p-50) + 0x1p-500;
        double length;

        a->at[c][0] = t > least ? t : least;
        for (size_t d = 0; d < 3; d++)
            a->y[3 * c + d] += dual * a->dy[3 * c + d];
        length = length3(a->y + 3 * c);
        if (length > 1 - 0x1p-50)
            for (size_t d = 0; d < 3; d++)
                a->y[3 * c + d] *= (1 - 0x1p-50) / length;
    }
}

static void inside(twin *a)
{
    const double n = (double)a->nov;
    double primal, dual;

    do {
        double now = 0, left;

        for (size_t c = 0; c < a->nov; c++) {
            now += a->at[c][0] - dot3(a->at[c] + 1, a->y + 3 * c);
            scaled(a, c);
        }
        optimum_solve_factor(&a->blocks, a->weight);
        directed(a, 0, false, 0x1p-12);
        left = fmax(lengths(a, 1, &primal, &dual), 0) / now;
        directed(a, now / n * fmin(left * left * left, 1), true, 0x1p-50);
        lengths(a, 0.98, &primal, &dual);
        if (primal < 0.25 || dual < 0.25) {
            directed(a, now / n, false, 0x1p-50);
            lengths(a, 0.98, &primal, &dual);
        }
        stepped(a, primal, dual);
    } while (!done(a, false));
}

static bool second_run(twin *a, const optimum_model *m, optimum_search *s)
{
    memset(a, 0, sizeof *a);
    a->s = s;
    a->m = m;
    a->nov = m->nov;
    a->unknowns = 3 * m->m;
    if (optimum_solve_new(&a->numbers, m, 0) != ET_OK || optimum_solve_new(&a->blocks, m, 1) != ET_OK)
        return false;
    a->value = residuals_of(a);
    for (size_t c = 0; c < m->nov; c++)
        for (size_t k = 0; k < 6; k += k == 0 ? 3 : 2)
            s->weight[6 * c + k] = 1;
    if (a->value > 0 && s->iterations < s->limit && started(a))
        inside(a);
    optimum_solve_free(&a->numbers);
    optimum_solve_free(&a->blocks);
    return true;
}

/* ---- drawing and comparing ---- */

typedef struct { double D[3 * C], x[3 * NODES], y[3 * C], weight[6 * C], history[HISTORY]; } arrays;
typedef struct { size_t calls, stop_at; } stopper;

static et_status stop_step(void *context, size_t done_, size_t total)
{
    stopper *const s = context;

    (void)done_;
    (void)total;
    return ++s->calls == s->stop_at ? ET_ESTOPPED : ET_OK;
}

static double hashed(size_t *seed)
{
    *seed = (*seed * 1103515245u + 12345u) & 0x7fffffffu;
    return (double)(*seed >> 7) * 0x1p-23 - 1;
}

/* Anything; what some control points give, exactly, nearly, or but for one; some at zero; at scales of their own; all zero. */
static void draw_residuals(gen *g, double *D, const optimum_model *m)
{
    const size_t kind = gen_upto(g, 6), n = 3 * m->nov;
    const double off = ldexp(1, -(int)gen_upto(g, 50));
    size_t seed = gen_upto(g, 0xffffff);
    double x[3 * NODES];

    for (size_t k = 0; k < n; k++)
        D[k] = kind == 6 || (kind == 1 && k / 3 % 3 == 0) || kind == 2 || kind == 3 ? 0 : hashed(&seed);
    for (size_t k = 0; k < n && kind == 4; k++)
        D[k] = ldexp(D[k], (int)(20 * hashed(&seed)) - 20);
    for (size_t k = 0; k < 3 * m->m; k++)
        x[k] = hashed(&seed);
    if (kind == 2 || kind == 3)
        optimum_model_apply(D, m, x);
    for (size_t k = 0; k < (kind == 2 ? 3 : n) && (kind == 2 || kind == 3); k++)
        D[k] += off * hashed(&seed);
}

static optimum_search searching(const optimum_model *m, const et_task *task, arrays *a)
{
    optimum_search s;

    memset(&s, 0, sizeof s);
    s.model = m;
    s.task = task;
    s.history = a->history;
    s.D = a->D;
    s.x = a->x;
    s.y = a->y;
    s.weight = a->weight;
    return s;
}

static bool alike(gen *g, const char *what, const double *a, const double *b, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (!gen_check(g, memcmp(a + k, b + k, sizeof *a) == 0 || (isnan(a[k]) && isnan(b[k])), "%s %zu: %a, not %a", what, k, a[k], b[k]))
            return false;
    return true;
}

/* One case in 10. */
verdict prop_optimum_find_cone(gen *g)
{
    static twin a;
    static arrays one, two;
    optimum_case c;
    optimum_model m;
    bool ok = optimum_case_draw(g, &c, (optimum_state)gen_upto(g, 3)) && optimum_model_new(&m, &c.fit) == ET_OK;
    stopper first = {0, gen_chance(g, 6) ? gen_upto(g, 12) : 0}, second = first;
    const et_task task = {stop_step, &first}, again = {stop_step, &second};
    optimum_search s, t;

    if (!ok)
        return FAIL;
    memset(&one, 0, sizeof one);
    draw_residuals(g, one.D, &m);
    for (size_t k = 0; k < C; k++) {
        one.y[3 * k] = 0.5;
        one.weight[6 * k + 1] = 0.25;
    }
    one.history[0] = one.history[1] = 10;
    two = one;
    s = searching(&m, &task, &one);
    t = searching(&m, &again, &two);
    s.iterations = t.iterations = gen_upto(g, 2);
    s.room = t.room = gen_upto(g, HISTORY);
    s.limit = t.limit = gen_chance(g, 3) ? gen_upto(g, 14) : HISTORY;
    s.tolerance = t.tolerance = gen_chance(g, 2) ? ldexp(1, -(int)gen_upto(g, 40)) : 1e-12;
    s.unit = t.unit = gen_upto(g, 1) ? 0x1p-3 : 1;
    ok = gen_check(g, optimum_cone_run(&s) == ET_OK, "not run") && gen_check(g, second_run(&a, &m, &t), "not run again");
    ok = ok && gen_check(g, s.iterations == t.iterations && s.status == t.status, "%zu iterations, not %zu", s.iterations, t.iterations);
    ok = ok && alike(g, "history", one.history, two.history, HISTORY) && alike(g, "x", one.x, two.x, 3 * NODES);
    ok = ok && alike(g, "y", one.y, two.y, 3 * C) && alike(g, "weight", one.weight, two.weight, 6 * C);
    gen_label(g, s.iterations > 12 ? "iterations: more" : s.iterations > 6 ? "iterations: 7 to 12" : "iterations: up to 6");
    optimum_model_free(&m);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}
