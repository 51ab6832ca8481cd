#include "etalon/refine/ceres.h"
#include "gen.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* A descent costs milliseconds: most cases of a property only try what must be refused, one in RARE descends. */
enum { RARE = 20, SIDE = 6, CLASSES = 2 * SIDE * SIDE, UNKNOWNS = 64 };

static void knots(gen *g, double *u, size_t n, size_t p)
{
    for (size_t k = 0; k < n + p + 1; k++)
        u[k] = k <= p ? 0 : k >= n ? 1 : (double)(k - p) / (double)(n - p);
    if (gen_chance(g, 4))
        gen_knots(g, u, n + p + 1, p);
}

/* 0 = t_0 < ... < t_{n-1} = 1, unequal steps. */
static void parameters(gen *g, double *t, size_t n)
{
    t[0] = 0;
    for (size_t i = 1; i < n; i++)
        t[i] = t[i - 1] + 1 + gen_real(g, 0, 1);
    for (size_t i = 1; i < n; i++)
        t[i] /= t[n - 1];
}

/* A closed polynomial fit without control points yet: degrees, knots, data sides, parameters. */
static bool some_fit(gen *g, et_fit *fit, et_doublenet control, et_doublenet data, size_t p, size_t q)
{
    et_surface *const a = &fit->shell.view[0], *const b = &fit->shell.view[1];

    memset(fit, 0, sizeof *fit);
    if (et_shell_new(&fit->shell, p, q, control, 0))
        return false;
    fit->data = data;
    knots(g, a->u, a->nu, p);
    knots(g, a->v, a->nv, q);
    memcpy(b->u, a->u, (a->nu + p + 1) * sizeof *a->u);
    memcpy(b->v, a->v, (a->nv + q + 1) * sizeof *a->v);
    for (size_t view = 0; view < 2; view++) {
        fit->s[view] = calloc(data.nx, sizeof(double));
        fit->r[view] = calloc(data.ny, sizeof(double));
        if (!fit->s[view] || !fit->r[view])
            return false;
    }
    parameters(g, fit->s[0], data.nx);
    parameters(g, fit->r[0], data.ny);
    memcpy(fit->s[1], fit->s[0], data.nx * sizeof(double));
    memcpy(fit->r[1], fit->r[0], data.ny * sizeof(double));
    return true;
}

static et_vec3 some_point(gen *g, double scale)
{
    return (et_vec3){gen_real(g, 0, scale), gen_real(g, 0, scale), gen_real(g, 0, scale)};
}

static void some_points(gen *g, et_vec3 *points, size_t n, double scale)
{
    for (size_t k = 0; k < n; k++)
        points[k] = some_point(g, scale);
}

static void shape(gen *g, et_doublenet *control, et_doublenet *data, size_t *p, size_t *q)
{
    *p = 1 + (size_t)gen_upto(g, 2);
    *q = 1 + (size_t)gen_upto(g, 2);
    control->nx = *p + 1 + (size_t)gen_upto(g, 4 - *p);
    control->ny = *q + 1 + (size_t)gen_upto(g, 4 - *q);
    data->nx = control->nx + (size_t)gen_upto(g, SIDE - control->nx);
    data->ny = control->ny + (size_t)gen_upto(g, SIDE - control->ny);
}

/* N_k,p(t) by the recursion of Cox and de Boor, 0/0 = 0, the last span closed. */
static double basis(const double *u, size_t n, size_t p, size_t k, double t)
{
    double value = 0;

    if (p == 0) {
        const bool last = t >= u[n] && u[k] < u[k + 1] && u[k + 1] == u[n];

        return (u[k] <= t && t < u[k + 1]) || last ? 1 : 0;
    }
    if (u[k + p] > u[k])
        value += (t - u[k]) / (u[k + p] - u[k]) * basis(u, n, p - 1, k, t);
    if (u[k + p + 1] > u[k + 1])
        value += (u[k + p + 1] - t) / (u[k + p + 1] - u[k + 1]) * basis(u, n, p - 1, k + 1, t);
    return value;
}

/* Row c: the share of each control class in the surface at a class's parameters (weights null: 1). */
static void row_of(double *row, size_t n, const et_surface *s, size_t view, et_doublenet control, double u, double v)
{
    double sum = 0;

    memset(row, 0, n * sizeof *row);
    for (size_t i = 0; i < s->nu; i++)
        for (size_t j = 0; j < s->nv; j++) {
            const double b = basis(s->u, s->nu, s->p, i, u) * basis(s->v, s->nv, s->q, j, v) * (s->weights ? s->weights[i * s->nv + j] : 1);

            row[et_doublenet_class(control, view, i, j) - 1] += b;
            sum += b;
        }
    for (size_t k = 0; k < n; k++)
        row[k] /= sum;
}

/* The dense matrix of a fit, a row a data class, at uv or (null) at the fit's parameters. */
static void matrix(double a[CLASSES][UNKNOWNS], const et_fit *fit, const double *uv)
{
    const et_doublenet control = et_shell_net(&fit->shell);

    for (size_t c = 1; c <= et_doublenet_nov(fit->data); c++) {
        const et_index at = et_doublenet_index(fit->data, c);
        const size_t view = at.k == 2;
        const double u = uv ? uv[2 * c - 2] : fit->s[view][at.i], v = uv ? uv[2 * c - 1] : fit->r[view][at.j];

        row_of(a[c - 1], et_doublenet_nov(control), &fit->shell.view[view], view, control, u, v);
    }
}

static double residual(double r[3], const double *row, const double (*x)[3], size_t n, et_vec3 d)
{
    const double want[3] = {d.x, d.y, d.z};
    double square = 0;

    for (int i = 0; i < 3; i++) {
        r[i] = want[i];
        for (size_t k = 0; k < n; k++)
            r[i] -= row[k] * x[k][i];
        square += r[i] * r[i];
    }
    return sqrt(square);
}

static void unknowns(double x[UNKNOWNS][3], const et_shell *shell)
{
    et_vec3 p[UNKNOWNS];
    const size_t n = et_doublenet_nov(et_shell_net(shell));

    et_shell_gather(p, n, shell);
    for (size_t k = 0; k < n; k++) {
        x[k][0] = p[k].x;
        x[k][1] = p[k].y;
        x[k][2] = p[k].z;
    }
}

static double dense_E(double a[CLASSES][UNKNOWNS], double x[UNKNOWNS][3], size_t n, const et_vec3 *data, size_t nov)
{
    double sum = 0, r[3];

    for (size_t c = 0; c < nov; c++)
        sum += residual(r, a[c], (const double(*)[3])x, n, data[c]);
    return sum;
}

/* Symmetric positive definite m x = b for three right sides, in place, by elimination. */
static void solve(double m[UNKNOWNS][UNKNOWNS], double b[UNKNOWNS][3], size_t n)
{
    for (size_t k = 0; k < n; k++)
        for (size_t i = k + 1; i < n; i++) {
            const double f = m[i][k] / m[k][k];

            for (size_t j = k; j < n; j++)
                m[i][j] -= f * m[k][j];
            for (int d = 0; d < 3; d++)
                b[i][d] -= f * b[k][d];
        }
    for (size_t k = n; k-- > 0;)
        for (int d = 0; d < 3; d++) {
            for (size_t j = k + 1; j < n; j++)
                b[k][d] -= m[k][j] * b[j][d];
            b[k][d] /= m[k][k];
        }
}

/* Iteratively reweighted least squares, dense, from zero: another way to the least E. */
static double reweighted(double a[CLASSES][UNKNOWNS], size_t n, const et_vec3 *data, size_t nov)
{
    static double m[UNKNOWNS][UNKNOWNS], x[UNKNOWNS][3], b[UNKNOWNS][3];
    double least = DBL_MAX;

    memset(x, 0, sizeof x);
    for (int step = 0; step < 400; step++) {
        const double mu = pow(10, -1 - step / 40);

        memset(m, 0, sizeof m);
        memset(b, 0, sizeof b);
        for (size_t k = 0; k < n; k++)
            m[k][k] = 1e-12;             /* where a control point is free */
        for (size_t c = 0; c < nov; c++) {
            double r[3];
            const double length = residual(r, a[c], (const double(*)[3])x, n, data[c]), w = 1 / sqrt(length * length + mu * mu);
            const double d[3] = {data[c].x, data[c].y, data[c].z};

            for (size_t k = 0; k < n; k++) {
                for (size_t l = 0; l < n && a[c][k] != 0; l++)
                    m[k][l] += w * a[c][k] * a[c][l];
                for (int i = 0; i < 3; i++)
                    b[k][i] += w * a[c][k] * d[i];
            }
        }
        solve(m, b, n);
        memcpy(x, b, sizeof x);
        least = fmin(least, dense_E(a, x, n, data, nov));
    }
    return least;
}

static double matrix_a[CLASSES][UNKNOWNS], solution[UNKNOWNS][3];

static bool same_knots(const et_fit *fit, const et_shell *before)
{
    bool same = true;

    for (size_t view = 0; view < 2; view++) {
        const et_surface *const s = &fit->shell.view[view], *const b = &before->view[view];

        same = same && s->p == b->p && s->q == b->q && s->nu == b->nu && s->nv == b->nv;
        same = same && memcmp(s->u, b->u, (s->nu + s->p + 1) * sizeof *s->u) == 0 && memcmp(s->v, b->v, (s->nv + s->q + 1) * sizeof *s->v) == 0;
    }
    return same;
}

static bool history_is(gen *g, const double *history, size_t nhistory, const et_ceres_summary *sum, double slack)
{
    bool ok = gen_check(g, sum->made == (sum->iterations < nhistory ? sum->iterations : nhistory), "made %zu", sum->made);

    for (size_t k = 1; k < sum->made; k++)
        ok = ok && gen_check(g, history[k] <= history[k - 1], "history rises at %zu", k);
    if (sum->made)
        ok = ok && gen_check(g, history[0] <= sum->before + slack && history[sum->made - 1] >= sum->after - slack, "history's ends");
    if (sum->made && sum->made == sum->iterations)
        ok = ok && gen_check(g, fabs(history[sum->made - 1] - sum->after) <= slack, "history's end %g, E %g", history[sum->made - 1], sum->after);
    return ok;
}

/* Rounding of one E of coordinates up to 4, say 2^8 roundings a residual: 2^-53 2^8 2^2 NOV. */
static double rounding(size_t nov)
{
    return 0x1p-43 * (double)nov;
}

/* What every descent owes: not worse, E as measured otherwise, closed, knots as they were, history. */
static bool owed(gen *g, const et_fit *fit, const et_shell *start, const et_vec3 *data, const double *uv, const double *history, size_t nhistory,
                 const et_ceres_summary *sum)
{
    const size_t nov = et_doublenet_nov(fit->data), n = et_doublenet_nov(et_shell_net(&fit->shell));
    bool ok = gen_check(g, sum->after <= sum->before, "worse: %.17g after %.17g", sum->after, sum->before);
    double E;

    matrix(matrix_a, fit, uv);
    unknowns(solution, &fit->shell);
    E = dense_E(matrix_a, solution, n, data, nov);
    ok = ok && gen_check(g, fabs(E - sum->after) <= rounding(nov), "E is %.17g, told %.17g", E, sum->after);
    ok = ok && gen_check(g, et_shell_glued(&fit->shell), "not glued") && gen_check(g, same_knots(fit, start), "knots changed");
    return ok && history_is(g, history, nhistory, sum, rounding(nov));
}

typedef struct { size_t calls, stop_at, last, total; et_status status; bool ok; } stopper;

static et_status stop_step(void *context, size_t done, size_t total)
{
    stopper *const s = context;

    s->ok = s->ok && done >= s->last && done <= total;
    s->last = done;
    s->total = total;
    return s->calls++ >= s->stop_at ? s->status : ET_OK;
}

static bool same_fit(const et_fit *a, const et_fit *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

/* One call of either function, by number. */
static et_status call(int full, et_fit *fit, double *uv, et_ceres_summary *sum, const et_vec3 *data, size_t nov, const et_ceres_options *o)
{
    return full ? et_ceres_full(fit, uv, sum, NULL, 0, data, nov, o, NULL, NULL) : et_ceres_points(fit, sum, NULL, 0, data, nov, o, NULL, NULL);
}

static et_ceres_options bad_options(gen *g)
{
    et_ceres_options o = et_ceres_defaults();

    switch (gen_upto(g, 6)) {
    case 0: o.iterations = 0; break;
    case 1: o.tolerance = -1e-10; break;
    case 2: o.tolerance = NAN; break;
    case 3: o.smooth_end = 0; break;
    case 4: o.smooth_end = 2 * o.smooth_start; break;
    case 5: o.smooth_start = INFINITY; break;
    default: o.smooth_end = NAN; break;
    }
    return o;
}

/* Everything that must be refused is, and nothing is touched by it. */
static verdict refusals(gen *g, int full)
{
    static double uv[2 * CLASSES];
    const et_doublenet net = {3, 3};
    const size_t nov = et_doublenet_nov(net);
    const et_ceres_options bad = bad_options(g);
    et_vec3 data[CLASSES], x[CLASSES], worst[CLASSES];
    et_ceres_summary sum = {1, 2, 3, 4, 5, 6};
    et_fit fit, was;
    double *const r = NULL;
    bool ok = some_fit(g, &fit, net, net, 2, 2);

    some_points(g, data, nov, 1);
    some_points(g, x, nov, 1);
    et_shell_scatter(&fit.shell, x, nov);
    memcpy(worst, data, sizeof data);
    worst[gen_upto(g, nov - 1)].y = gen_chance(g, 2) ? NAN : INFINITY;
    was = fit;
    uv[0] = 7;
    ok = ok && gen_check(g, call(full, NULL, uv, &sum, data, nov, NULL) == ET_EINVAL, "null fit");
    ok = ok && gen_check(g, call(full, &fit, uv, NULL, data, nov, NULL) == ET_EINVAL, "null summary");
    ok = ok && gen_check(g, call(full, &fit, uv, &sum, NULL, nov, NULL) == ET_EINVAL, "null data");
    ok = ok && gen_check(g, !full || call(full, &fit, NULL, &sum, data, nov, NULL) == ET_EINVAL, "null uv");
    ok = ok && gen_check(g, call(full, &fit, uv, &sum, data, nov, &bad) == ET_EINVAL, "bad options");
    ok = ok && gen_check(g, call(full, &fit, uv, &sum, data, nov - 1, NULL) == ET_EINVAL, "nov too small");
    ok = ok && gen_check(g, call(full, &fit, uv, &sum, data, nov + 1, NULL) == ET_EINVAL, "nov too large");
    ok = ok && gen_check(g, call(full, &fit, uv, &sum, worst, nov, NULL) == ET_EINVAL, "data not finite");
    worst[0] = worst[1] = worst[2] = worst[3] = worst[4] = worst[5] = worst[6] = worst[7] = worst[8] = worst[9] = (et_vec3){1e200, 0, 0};
    ok = ok && gen_check(g, call(full, &fit, uv, &sum, worst, nov, NULL) == ET_EINVAL, "E overflows");
    fit.s[1] = r;
    ok = ok && gen_check(g, call(full, &fit, uv, &sum, data, nov, NULL) == ET_EINVAL, "no parameters");
    fit.s[1] = was.s[1];
    fit.r[0][1] = gen_chance(g, 2) ? -0x1p-1074 : 1 + 0x1p-52;
    ok = ok && gen_check(g, call(full, &fit, uv, &sum, data, nov, NULL) == ET_EINVAL, "parameter outside");
    fit.r[0][1] = fit.r[1][1];
    fit.shell.view[1].points[1].z += 1;
    ok = ok && gen_check(g, call(full, &fit, uv, &sum, data, nov, NULL) == ET_EINVAL, "open shell");
    fit.shell.view[1].points[1].z = fit.shell.view[0].points[1].z;
    ok = ok && gen_check(g, same_fit(&fit, &was) && uv[0] == 7 && sum.before == 1 && sum.made == 5 && sum.converged == 6, "outputs touched");
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

verdict prop_ceres_defaults(gen *g)
{
    const et_ceres_options o = et_ceres_defaults();

    return gen_check(g, o.iterations == 400 && o.tolerance == 1e-10 && o.smooth_start == 1e-2 && o.smooth_end == 1e-8, "not as stated") ? PASS : FAIL;
}

/* Random data: the least E of another algorithm, to 1e-6 and the smoothing's NOV mu.  A fit that descends at most 3000 iterations converges. */
verdict prop_ceres_points(gen *g)
{
    static double history[3000];
    et_ceres_options o = et_ceres_defaults();
    et_doublenet control, net;
    et_vec3 data[CLASSES], x[UNKNOWNS];
    et_ceres_summary sum;
    et_shell start = {0};
    et_fit fit;
    size_t p, q, nov, n, nhistory;
    double least;
    bool ok;

    if (!gen_chance(g, RARE))
        return refusals(g, 0);
    shape(g, &control, &net, &p, &q);
    nov = et_doublenet_nov(net);
    n = et_doublenet_nov(control);
    o.iterations = 3000;
    nhistory = gen_chance(g, 3) ? (size_t)gen_upto(g, 20) : 3000;
    ok = some_fit(g, &fit, control, net, p, q);
    some_points(g, data, nov, 1);
    some_points(g, x, n, 1);
    et_shell_scatter(&fit.shell, x, n);
    ok = ok && et_shell_copy(&start, &fit.shell) == ET_OK;
    ok = ok && gen_check(g, et_ceres_points(&fit, &sum, history, nhistory, data, nov, &o, NULL, NULL) == ET_OK, "not done");
    ok = ok && owed(g, &fit, &start, data, NULL, history, nhistory, &sum) && gen_check(g, !fit.shell.view[0].weights, "rational");
    least = ok ? reweighted(matrix_a, n, data, nov) : 0;
    ok = ok && gen_check(g, sum.after <= least * (1 + 1e-6) + (double)nov * 1e-8, "E %.12g, another way %.12g", sum.after, least);
    ok = ok && gen_check(g, sum.converged, "not converged after %zu", sum.iterations);
    et_shell_free(&start);
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

/* The start that the fit has is the one E is told for; a rational fit is refused. */
verdict prop_ceres_points_before(gen *g)
{
    et_ceres_options o = et_ceres_defaults();
    et_doublenet control = {3, 4}, net = {4, 5};
    et_vec3 data[CLASSES], x[UNKNOWNS];
    const size_t nov = et_doublenet_nov(net), n = et_doublenet_nov(control);
    et_ceres_summary sum = {0};
    et_fit_error before = {0}, after = {0};
    et_fit fit;
    et_shell rational = {0}, own;
    bool ok = some_fit(g, &fit, control, net, 2, 2);

    o.iterations = 1 + (size_t)gen_upto(g, 3);
    some_points(g, data, nov, 1);
    some_points(g, x, n, 1);
    et_shell_scatter(&fit.shell, x, n);
    ok = ok && et_fit_measure(&before, NULL, nov, &fit, data) == ET_OK && et_shell_new(&rational, 2, 2, control, 1) == ET_OK;
    ok = ok && gen_check(g, et_ceres_points(&fit, &sum, NULL, 5, data, nov, &o, NULL, NULL) == ET_OK, "not done");
    ok = ok && et_fit_measure(&after, NULL, nov, &fit, data) == ET_OK;
    ok = ok && gen_check(g, sum.before == before.nov && sum.after == after.nov, "E is not et_fit_measure's");
    ok = ok && gen_check(g, sum.iterations <= o.iterations && sum.made == 0 && sum.evaluations >= sum.iterations, "counts");
    own = fit.shell;
    fit.shell = rational;
    memcpy(fit.shell.view[0].u, own.view[0].u, 6 * sizeof(double));
    memcpy(fit.shell.view[1].u, own.view[0].u, 6 * sizeof(double));
    memcpy(fit.shell.view[0].v, own.view[0].v, 7 * sizeof(double));
    memcpy(fit.shell.view[1].v, own.view[0].v, 7 * sizeof(double));
    ok = ok && gen_check(g, et_shell_glued(&fit.shell), "the test's own shell");
    ok = ok && gen_check(g, et_ceres_points(&fit, &sum, NULL, 0, data, nov, &o, NULL, NULL) == ET_EINVAL, "rational taken");
    et_shell_free(&own);
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

/* Data on a surface of the kind: E is 0 there, and the smoothed least value NOV mu. */
verdict prop_ceres_points_exact(gen *g)
{
    et_ceres_options o = et_ceres_defaults();
    et_doublenet control, net;
    et_vec3 data[CLASSES], x[UNKNOWNS];
    et_ceres_summary sum = {0};
    et_fit fit;
    size_t p, q, nov, n;
    bool ok;

    if (!gen_chance(g, RARE))
        return refusals(g, 0);
    shape(g, &control, &net, &p, &q);
    nov = et_doublenet_nov(net);
    n = et_doublenet_nov(control);
    o.iterations = 1000;
    ok = some_fit(g, &fit, control, net, p, q);
    some_points(g, x, n, 1);
    et_shell_scatter(&fit.shell, x, n);
    matrix(matrix_a, &fit, NULL);
    unknowns(solution, &fit.shell);
    for (size_t c = 0; c < nov; c++) {
        double r[3];

        residual(r, matrix_a[c], (const double(*)[3])solution, n, (et_vec3){0, 0, 0});
        data[c] = (et_vec3){-r[0], -r[1], -r[2]};
    }
    for (size_t k = 0; k < n; k++)
        x[k].z += gen_real(g, 0, 1);
    et_shell_scatter(&fit.shell, x, n);
    ok = ok && gen_check(g, et_ceres_points(&fit, &sum, NULL, 0, data, nov, &o, NULL, NULL) == ET_OK, "not done");
    ok = ok && gen_check(g, sum.after <= (double)nov * o.smooth_end + rounding(nov), "E is %g, not 0", sum.after);
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

/* A bilinear patch and data at its corners only: each corner is the median of the collinear points there, and E the sum of their distances to it. */
verdict prop_ceres_points_median(gen *g)
{
    const et_doublenet control = {2, 2}, net = {2, 6};
    const size_t nov = et_doublenet_nov(net), split = 1 + (size_t)gen_upto(g, 4);
    et_vec3 data[CLASSES], x[4];
    et_ceres_summary sum = {0};
    et_fit fit;
    double want = 0;
    bool ok = some_fit(g, &fit, control, net, 1, 1);

    if (!gen_chance(g, RARE))
        return et_fit_free(&fit), refusals(g, 0);
    for (size_t view = 0; view < 2; view++)
        for (size_t j = 0; j < 6; j++)
            fit.r[view][j] = j < split ? 0 : 1;
    for (size_t c = 0; c < nov; c++)
        data[c] = (et_vec3){(double)gen_upto(g, 16) / 16, 0.5, 0.25};
    for (size_t c = 0; c < nov; c++) {    /* sorted x_0 .. x_{s-1}: the distances to a median add up to sum sign(2 i + 1 - s) x_i */
        size_t below = 0, size = 0;

        for (size_t k = 0; k < nov; k++)
            if (k / 6 == c / 6 && (k % 6 < split) == (c % 6 < split)) {
                below += data[k].x < data[c].x || (data[k].x == data[c].x && k < c);
                size++;
            }
        want += 2 * below + 1 > size ? data[c].x : 2 * below + 1 < size ? -data[c].x : 0;
    }
    some_points(g, x, 4, 1);
    et_shell_scatter(&fit.shell, x, 4);
    ok = ok && gen_check(g, et_ceres_points(&fit, &sum, NULL, 0, data, nov, NULL, NULL, NULL) == ET_OK, "not done");
    ok = ok && gen_check(g, fabs(sum.after - want) <= (double)nov * 1e-8 + want * 1e-6, "E is %.12g, not %.12g", sum.after, want);
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

/* Stopped from outside after k calls: that status, the best so far, closed. */
static verdict stopped(gen *g, int full)
{
    static double uv[2 * CLASSES], history[400];
    const et_doublenet control = {3, 3}, net = {4, 4};
    const size_t nov = et_doublenet_nov(net), n = et_doublenet_nov(control);
    stopper s = {0, (size_t)gen_upto(g, 12), 0, 0, gen_chance(g, 3) ? ET_EIO : ET_ESTOPPED, true};
    const et_task task = {stop_step, &s};
    et_vec3 data[CLASSES], x[UNKNOWNS];
    et_ceres_summary sum = {0};
    et_shell start = {0};
    et_fit fit;
    et_status status;
    bool ok;

    if (!gen_chance(g, RARE))
        return refusals(g, full);
    ok = some_fit(g, &fit, control, net, 2, 2);
    some_points(g, data, nov, 1);
    some_points(g, x, n, 1);
    et_shell_scatter(&fit.shell, x, n);
    ok = ok && et_shell_copy(&start, &fit.shell) == ET_OK;
    status = full ? et_ceres_full(&fit, uv, &sum, history, 400, data, nov, NULL, &task, NULL)
                  : et_ceres_points(&fit, &sum, history, 400, data, nov, NULL, &task, NULL);
    const bool perfect = ok && status == ET_OK && sum.before == 0;       /* all points equal: there is nothing to be stopped */
    if (perfect)
        ok = gen_check(g, s.calls == 0 && sum.converged && sum.after == 0, "%zu calls for a perfect fit", s.calls);
    else
        ok = ok && gen_check(g, status == s.status && s.ok && s.total == 400 && s.calls == s.stop_at + 1, "status %d after %zu calls", status, s.calls);
    ok = ok && gen_check(g, perfect || (sum.iterations <= s.stop_at + 1 && !sum.converged), "%zu iterations", sum.iterations);
    ok = ok && owed(g, &fit, &start, data, full ? uv : NULL, history, 400, &sum);
    if (s.stop_at > 8 && !perfect)
        ok = ok && gen_check(g, sum.after < sum.before, "nothing gained in %zu calls", s.calls);
    et_shell_free(&start);
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

verdict prop_ceres_points_stop(gen *g)
{
    return stopped(g, 0);
}

verdict prop_ceres_full_stop(gen *g)
{
    return stopped(g, 1);
}

/* Weights: positive, within a factor of 100, the corners as they were. */
static bool weights_are(gen *g, const et_shell *shell)
{
    const size_t nu = shell->view[0].nu, nv = shell->view[0].nv;
    bool ok = gen_check(g, shell->view[0].weights && shell->view[1].weights, "not rational");

    for (size_t view = 0; ok && view < 2; view++)
        for (size_t k = 0; k < nu * nv; k++) {
            const bool corner = (k / nv == 0 || k / nv + 1 == nu) && (k % nv == 0 || k % nv + 1 == nv);
            const double w = shell->view[view].weights[k];

            ok = ok && gen_check(g, corner ? w == 1 : w > 0.0099 && w < 101, "weight %zu is %g", k, w);
        }
    return ok;
}

/* Parameters: in [0,1], borders on their border, corners where they were. */
static bool uv_is(gen *g, const double *uv, const et_fit *fit)
{
    bool ok = true;

    for (size_t c = 1; ok && c <= et_doublenet_nov(fit->data); c++) {
        const et_index at = et_doublenet_index(fit->data, c);
        const double u = uv[2 * c - 2], v = uv[2 * c - 1];

        ok = gen_check(g, u >= 0 && u <= 1 && v >= 0 && v <= 1, "(%g, %g)", u, v);
        ok = ok && gen_check(g, (at.i != 0 || u == 0) && (at.i + 1 != fit->data.nx || u == 1), "class %zu left its border, u %g", c, u);
        ok = ok && gen_check(g, (at.j != 0 || v == 0) && (at.j + 1 != fit->data.ny || v == 1), "class %zu left its border, v %g", c, v);
    }
    return ok;
}

verdict prop_ceres_full(gen *g)
{
    static double uv[2 * CLASSES], history[60];
    et_ceres_options o = et_ceres_defaults();
    et_doublenet control, net;
    et_vec3 data[CLASSES], x[UNKNOWNS];
    et_ceres_summary sum = {0};
    et_fit_error before = {0};
    et_shell start = {0};
    et_fit fit;
    size_t p, q, nov, n;
    bool ok;

    if (!gen_chance(g, RARE))
        return refusals(g, 1);
    shape(g, &control, &net, &p, &q);
    nov = et_doublenet_nov(net);
    n = et_doublenet_nov(control);
    o.iterations = 50;
    ok = some_fit(g, &fit, control, net, p, q);
    some_points(g, data, nov, 1);
    some_points(g, x, n, 1);
    et_shell_scatter(&fit.shell, x, n);
    ok = ok && et_shell_copy(&start, &fit.shell) == ET_OK && et_fit_measure(&before, NULL, nov, &fit, data) == ET_OK;
    ok = ok && gen_check(g, et_ceres_full(&fit, uv, &sum, history, 60, data, nov, &o, NULL, NULL) == ET_OK, "not done");
    ok = ok && gen_check(g, fabs(sum.before - before.nov) <= rounding(nov), "before is %.17g, not %.17g", sum.before, before.nov);
    ok = ok && weights_are(g, &fit.shell) && uv_is(g, uv, &fit) && owed(g, &fit, &start, data, uv, history, 60, &sum);
    ok = ok && gen_check(g, sum.after <= 0.9 * sum.before, "hardly better: %g after %g", sum.after, sum.before);
    et_shell_free(&start);
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

/* A second run starts from the weights of the first, and from the fit's own parameters. */
verdict prop_ceres_full_again(gen *g)
{
    static double uv[2 * CLASSES];
    const et_doublenet control = {4, 3}, net = {5, 5};
    const size_t nov = et_doublenet_nov(net), n = et_doublenet_nov(control);
    et_ceres_options o = et_ceres_defaults();
    et_vec3 data[CLASSES], x[UNKNOWNS];
    et_ceres_summary sum = {0};
    et_fit fit;
    double E;
    bool ok;

    if (!gen_chance(g, RARE))
        return refusals(g, 1);
    ok = some_fit(g, &fit, control, net, 3, 2);
    o.iterations = 10;
    some_points(g, data, nov, 1);
    some_points(g, x, n, 1);
    et_shell_scatter(&fit.shell, x, n);
    ok = ok && gen_check(g, et_ceres_full(&fit, uv, &sum, NULL, 0, data, nov, &o, NULL, NULL) == ET_OK, "not done");
    matrix(matrix_a, &fit, NULL);
    unknowns(solution, &fit.shell);
    E = dense_E(matrix_a, solution, n, data, nov);
    ok = ok && gen_check(g, et_ceres_full(&fit, uv, &sum, NULL, 0, data, nov, &o, NULL, NULL) == ET_OK, "not done again");
    ok = ok && gen_check(g, fabs(sum.before - E) <= rounding(nov), "started from %.17g, not %.17g", sum.before, E) && uv_is(g, uv, &fit);
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}

/* Data on a rational surface at parameters a little off the grid: weights and parameters are needed, and found. */
/* One case in 2. */
verdict prop_ceres_full_exact(gen *g)
{
    static double uv[2 * CLASSES];
    const et_doublenet control = {4, 4}, net = {6, 6};
    const size_t nov = et_doublenet_nov(net), n = et_doublenet_nov(control);
    et_vec3 data[CLASSES], x[UNKNOWNS];
    et_ceres_summary points = {0}, sum = {0};
    et_fit fit;
    bool ok;

    if (!gen_chance(g, RARE))
        return refusals(g, 1);
    ok = some_fit(g, &fit, control, net, 3, 3);
    for (size_t c = 1; c <= n; c++) {
        const et_index at = et_doublenet_index(control, c);

        x[c - 1] = (et_vec3){(double)at.i / 3, (double)at.j / 3, (double)at.k / 2 + gen_real(g, 0, 0.25)};
    }
    et_shell_scatter(&fit.shell, x, n);
    for (size_t c = 1; c <= nov; c++) {
        const et_index at = et_doublenet_index(net, c);
        const bool in_u = at.i > 0 && at.i < 5, in_v = at.j > 0 && at.j < 5;

        uv[2 * c - 2] = fit.s[0][at.i] + (in_u ? gen_real(g, -0.03, 0.03) : 0);
        uv[2 * c - 1] = fit.r[0][at.j] + (in_v ? gen_real(g, -0.03, 0.03) : 0);
    }
    matrix(matrix_a, &fit, uv);
    unknowns(solution, &fit.shell);
    for (size_t c = 0; c < nov; c++) {
        double r[3];

        residual(r, matrix_a[c], (const double(*)[3])solution, n, (et_vec3){0, 0, 0});
        data[c] = (et_vec3){-r[0], -r[1], -r[2]};
    }
    ok = ok && gen_check(g, et_ceres_points(&fit, &points, NULL, 0, data, nov, NULL, NULL, NULL) == ET_OK, "points not done");
    ok = ok && gen_check(g, et_ceres_full(&fit, uv, &sum, NULL, 0, data, nov, NULL, NULL, NULL) == ET_OK, "not done");
    ok = ok && gen_check(g, sum.after <= 0.1 * points.after, "E %g, control points alone %g", sum.after, points.after);
    et_fit_free(&fit);
    return ok ? PASS : FAIL;
}
