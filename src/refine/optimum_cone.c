/* The least sum of norms by a primal-dual interior-point method: least t_1 + t_2 + ... with (t_c, r_c) in the cone |r| <= t, r = D - N x, and
 * its dual, the greatest sum of y_c . D_c with (1, -y_c) in the cone, N'y = 0; scaling of Nesterov and Todd, steps of Mehrotra's kind.
 * It starts from iteratively reweighted least squares, which gives an x and a y that are both inside. */
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { REWEIGHTED = 6,                    /* steps of least squares, at most: each costs a twentieth of the others */
       PATIENCE = 5 };                    /* steps without a smaller gap */
#define ACCURACY 0x1p-50                  /* of a step, in energy; of one that is only tried */
#define TRIED 0x1p-12

/* A vector of the cone's space. */
typedef struct { double t, r[3]; } vector;

typedef struct {
    vector q, v;                          /* W^-2 = eta^2 (2 qq' - J), W^-1 = eta (2 vv' - J), J = diag(1, -1, -1, -1) */
    vector lambda;                        /* W^-1 x = W z */
    double eta;
} scaling;

typedef struct {
    optimum_search *s;
    const optimum_model *model;
    optimum_solver full, thin;            /* 3 m rows; m rows */
    scaling *scale;                       /* [nov] */
    vector *dx, *h;                       /* [nov] steps of (t, r); right sides */
    double *t, *r, *y, *dy, *x, *step;    /* the state and its steps */
    double *weight, *length;
    double value, dual;                   /* best so far, in the method's lengths */
    size_t idle;                          /* steps since either grew better */
} state;

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double norm(const double *a)
{
    return sqrt(dot(a, a));
}

/* ---- the algebra of one cone ---- */

/* factor (2 vv' - J) a. */
static vector reflect(const vector *v, double factor, const vector *a)
{
    const double s = 2 * (v->t * a->t + dot(v->r, a->r));
    vector b = {factor * (s * v->t - a->t), {0}};

    for (int d = 0; d < 3; d++)
        b.r[d] = factor * (s * v->r[d] + a->r[d]);
    return b;
}

static vector mirrored(const vector *a)
{
    return (vector){a->t, {-a->r[0], -a->r[1], -a->r[2]}};
}

/* W^-1 a and W a. */
static vector shrink(const scaling *w, const vector *a)
{
    return reflect(&w->v, w->eta, a);
}

static vector stretch(const scaling *w, const vector *a)
{
    const vector v = mirrored(&w->v);

    return reflect(&v, 1 / w->eta, a);
}

/* t^2 - |r|^2 without the squares' cancellation. */
static double determinant(double t, const double *r)
{
    const double length = norm(r);

    return (t - length) * (t + length);
}

/* The scaling point of x = (t, r) and z = (1, -y). */
static void set_scaling(scaling *w, double t, const double *r, const double *y)
{
    const double dx = sqrt(determinant(t, r)), dz = sqrt(determinant(1, y));
    const vector x = {t, {r[0], r[1], r[2]}};
    double gamma, d;

    gamma = sqrt((1 + (t - dot(r, y)) / (dx * dz)) / 2);
    w->q.t = (t / dx + 1 / dz) / (2 * gamma);
    for (int k = 0; k < 3; k++)
        w->q.r[k] = -(r[k] / dx + y[k] / dz) / (2 * gamma);
    d = sqrt(2 * (w->q.t + 1));
    w->v = (vector){(w->q.t + 1) / d, {w->q.r[0] / d, w->q.r[1] / d, w->q.r[2] / d}};
    w->eta = sqrt(dz / dx);
    w->lambda = shrink(w, &x);
}

/* W^-1 (lambda \ (target e - a o b)): Jordan product and its inverse. */
static vector right_side(const scaling *w, double target, const vector *a, const vector *b)
{
    const vector *const l = &w->lambda;
    const vector u = {target - (a->t * b->t + dot(a->r, b->r)),
                      {-(a->t * b->r[0] + b->t * a->r[0]), -(a->t * b->r[1] + b->t * a->r[1]), -(a->t * b->r[2] + b->t * a->r[2])}};
    vector s;

    s.t = (l->t * u.t - dot(l->r, u.r)) / determinant(l->t, l->r);
    for (int d = 0; d < 3; d++)
        s.r[d] = (u.r[d] - s.t * l->r[d]) / l->t;
    return shrink(w, &s);
}

/* The 3 x 3 block: what is left of W^-2 when t is eliminated, eta^2 (I - 2 qq' / (1 + 2 |q|^2)). */
static void set_weight(double *weight, const scaling *w)
{
    const double e = w->eta * w->eta, f = 2 / (1 + 2 * dot(w->q.r, w->q.r));
    const double *const q = w->q.r;

    weight[0] = e * (1 - f * q[0] * q[0]);
    weight[1] = e * (-f * q[0] * q[1]);
    weight[2] = e * (-f * q[0] * q[2]);
    weight[3] = e * (1 - f * q[1] * q[1]);
    weight[4] = e * (-f * q[1] * q[2]);
    weight[5] = e * (1 - f * q[2] * q[2]);
}

/* The longest step along which (t, r) stays in the cone. */
static double reach(double t, const double *r, double dt, const double *dr)
{
    const double c = determinant(t, r), b = t * dt - dot(r, dr), a = dt * dt - dot(dr, dr), root = b * b - a * c;
    const double down = root >= 0 ? sqrt(root) - b : -1;

    return down > 0 ? c / down : HUGE_VAL;
}

/* ---- the state ---- */

static void release(state *a)
{
    void *const arrays[] = {a->scale, a->dx, a->h, a->t, a->r, a->y, a->dy, a->x, a->step, a->weight, a->length};

    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
        free(arrays[k]);
    optimum_solve_free(&a->full);
    optimum_solve_free(&a->thin);
}

static double *triples(size_t n)
{
    size_t count = 0;

    return et_size_mul(&count, n, 3) == ET_OK ? et_size_array(count, sizeof(double)) : NULL;
}

static et_status acquire(state *a, optimum_search *s)
{
    const optimum_model *const model = s->model;
    et_status status;

    memset(a, 0, sizeof *a);
    a->s = s;
    a->model = model;
    status = optimum_solve_new(&a->thin, model, 0);
    if (status == ET_OK)
        status = optimum_solve_new(&a->full, model, 1);
    a->scale = et_size_array(model->nov, sizeof *a->scale);
    a->dx = et_size_array(model->nov, sizeof *a->dx);
    a->h = et_size_array(model->nov, sizeof *a->h);
    a->t = et_size_array(model->nov, sizeof *a->t);
    a->length = et_size_array(model->nov, sizeof *a->length);
    a->r = triples(model->nov);
    a->y = triples(model->nov);
    a->dy = triples(model->nov);
    a->weight = triples(2 * model->nov);
    a->x = triples(model->m);
    a->step = triples(model->m);
    return a->scale && a->dx && a->h && a->t && a->length && a->r && a->y && a->dy && a->weight && a->x && a->step ? status : ET_ENOMEM;
}

/* r of x, and its E. */
static double residuals(state *a)
{
    memcpy(a->r, a->s->D, 3 * a->model->nov * sizeof *a->r);
    optimum_model_apply(a->r, a->model, a->x);
    for (size_t c = 0; c < a->model->nov; c++)
        a->length[c] = norm(a->r + 3 * c);
    return et_real_sum(a->length, a->model->nov);
}

/* What y . D is for the y of the state, were N'y = 0, shrunk until it is feasible. */
static double dual_value(state *a)
{
    double most = 1;

    for (size_t c = 0; c < a->model->nov; c++) {
        a->length[c] = dot(a->y + 3 * c, a->r + 3 * c);
        most = fmax(most, norm(a->y + 3 * c));
    }
    return et_real_sum(a->length, a->model->nov) / most;
}

/* N'y = 0 as far as rounding goes; not so where the equations could not be solved. */
static int feasible(state *a)
{
    optimum_model_adjoint(a->step, a->model, a->y);
    for (size_t k = 0; k < 3 * a->model->m; k++)
        if (!(fabs(a->step[k]) < 0x1p-40))
            return 0;
    return 1;
}

/* Keep what is better, tell it; 1 if it is time to end. */
static int took(state *a, int last_of_start)
{
    optimum_search *const s = a->s;
    const double value = residuals(a), dual = dual_value(a), before = a->value - a->dual;

    if (value < a->value) {
        a->value = value;
        memcpy(s->x, a->x, 3 * a->model->m * sizeof *a->x);
    }
    if (dual > a->dual && feasible(a)) {
        a->dual = dual;
        memcpy(s->y, a->y, 3 * a->model->nov * sizeof *a->y);
        memcpy(s->weight, a->weight, 6 * a->model->nov * sizeof *a->weight);
    }
    a->idle = last_of_start || a->value - a->dual < before * 0.75 ? 0 : a->idle + 1;
    if (s->iterations < s->room) {
        s->history[s->iterations] = a->value * s->unit;
        if (s->iterations > 0)
            s->history[s->iterations] = fmin(s->history[s->iterations], s->history[s->iterations - 1]);
    }
    s->iterations++;
    s->status = et_task_step(s->task, s->iterations, s->limit);
    return s->status != ET_OK || s->iterations >= s->limit || !(a->value - a->dual > s->tolerance / 4 * a->value) || a->idle >= PATIENCE;
}

/* ---- reweighted least squares ---- */

/* One step with the weights 1 / sqrt(|r|^2 + mu^2); y are the new residuals so weighted: N'y = 0. */
static void reweight(state *a, double mu)
{
    const size_t nov = a->model->nov;
    double most = 0;

    for (size_t c = 0; c < nov; c++)
        a->t[c] = 1 / sqrt(dot(a->r + 3 * c, a->r + 3 * c) + mu * mu);
    optimum_solve_factor(&a->thin, a->t);
    for (size_t k = 0; k < 3 * nov; k++)
        a->y[k] = a->t[k / 3] * a->r[k];
    optimum_model_adjoint(a->step, a->model, a->y);
    optimum_solve_run(&a->thin, a->step, ACCURACY);
    optimum_solve_take(a->step, a->dy, &a->thin);
    for (size_t k = 0; k < 3 * a->model->m; k++)
        a->x[k] += a->step[k];
    residuals(a);
    for (size_t c = 0; c < nov; c++) {
        for (size_t d = 0; d < 3; d++)
            a->y[3 * c + d] = a->t[c] * a->r[3 * c + d];
        most = fmax(most, norm(a->y + 3 * c));
        memset(a->weight + 6 * c, 0, 6 * sizeof *a->weight);
        a->weight[6 * c] = a->weight[6 * c + 3] = a->weight[6 * c + 5] = a->t[c];
    }
    for (size_t k = 0; k < 3 * nov && most > 0.9; k++)
        a->y[k] *= 0.9 / most;
}

static int start(state *a)
{
    const size_t nov = a->model->nov;
    double mu = a->value / (double)nov;

    for (size_t k = 0; k < REWEIGHTED; k++) {
        reweight(a, mu);
        if (took(a, 1))
            return 1;
        if (k + 1 < REWEIGHTED)
            mu = fmin(mu / 2, a->value / (double)nov / 2);
    }
    for (size_t c = 0; c < nov; c++)
        a->t[c] = mu + sqrt(mu * mu + dot(a->r + 3 * c, a->r + 3 * c));
    return 0;
}

/* ---- interior points ---- */

/* The steps for the right sides h: N'WN dx = N'k, dr = -N dx, dt and dy from each cone's two equations. */
static void solve(state *a, double accuracy)
{
    const size_t nov = a->model->nov;

    for (size_t c = 0; c < nov; c++) {
        const scaling *const w = &a->scale[c];
        const double e = w->eta * w->eta, q0 = w->q.t, down = e * (2 * q0 * q0 - 1);

        for (size_t d = 0; d < 3; d++)
            a->dy[3 * c + d] = 2 * e * q0 * w->q.r[d] * (a->h[c].t - 1) / down - a->h[c].r[d];
    }
    optimum_model_adjoint(a->step, a->model, a->dy);
    optimum_solve_run(&a->full, a->step, accuracy);
    optimum_solve_take(a->step, a->dy, &a->full);
    for (size_t c = 0; c < nov; c++) {
        const scaling *const w = &a->scale[c];
        const double *const q = w->q.r, qq = dot(q, q), e = w->eta * w->eta, q0 = w->q.t;
        double along, share;

        for (size_t d = 0; d < 3; d++)
            a->dx[c].r[d] = -a->dy[3 * c + d];
        along = dot(q, a->dx[c].r);
        a->dx[c].t = ((a->h[c].t - 1) / e - 2 * q0 * along) / (1 + 2 * qq);
        share = 2 * q0 * (a->h[c].t - 1) / (1 + 2 * qq) + (qq > 0 ? e * along / (qq * (1 + 2 * qq)) : 0);
        for (size_t d = 0; d < 3; d++) {   /* along q and across it: near the boundary q is long, and the two differ by its square */
            const double across = a->dx[c].r[d] - (qq > 0 ? along / qq * q[d] : 0);

            a->dy[3 * c + d] = e * across + share * q[d] - a->y[3 * c + d] - a->h[c].r[d];
        }
    }
}

/* The longest steps, at most `most`, of (t, r) and of y, and the sum of x z after them. */
static double longest(double *primal, double *dual, const state *a, double share, double most)
{
    double sum = 0;

    *primal = *dual = HUGE_VAL;
    for (size_t c = 0; c < a->model->nov; c++) {
        *primal = fmin(*primal, reach(a->t[c], a->r + 3 * c, a->dx[c].t, a->dx[c].r));
        *dual = fmin(*dual, reach(1, a->y + 3 * c, 0, a->dy + 3 * c));
    }
    *primal = fmin(*primal * share, most);
    *dual = fmin(*dual * share, most);
    for (size_t c = 0; c < a->model->nov; c++) {
        double inner = 0;

        for (size_t d = 0; d < 3; d++)
            inner += (a->r[3 * c + d] + *primal * a->dx[c].r[d]) * (a->y[3 * c + d] + *dual * a->dy[3 * c + d]);
        sum += a->t[c] + *primal * a->dx[c].t - inner;
    }
    return sum;
}

static void scale_all(state *a)
{
    for (size_t c = 0; c < a->model->nov; c++) {
        set_scaling(&a->scale[c], a->t[c], a->r + 3 * c, a->y + 3 * c);
        set_weight(a->weight + 6 * c, &a->scale[c]);
    }
    optimum_solve_factor(&a->full, a->weight);
}

/* Right sides: first without a target, to see how far one could go; then with target and the second-order term of that step. */
static void aim(state *a, double target, int corrected)
{
    const vector zero = {0, {0, 0, 0}};

    for (size_t c = 0; c < a->model->nov; c++) {
        const scaling *const w = &a->scale[c];
        const vector dz = {0, {-a->dy[3 * c], -a->dy[3 * c + 1], -a->dy[3 * c + 2]}};
        const vector da = corrected ? shrink(w, &a->dx[c]) : zero, db = corrected ? stretch(w, &dz) : zero;

        a->h[c] = right_side(w, target, &da, &db);
    }
}

/* Strictly inside again, whatever rounding did. */
static void step_inside(state *a, double primal, double dual)
{
    for (size_t k = 0; k < 3 * a->model->m; k++)
        a->x[k] += primal * a->step[k];
    residuals(a);
    for (size_t c = 0; c < a->model->nov; c++) {
        double *const y = a->y + 3 * c, length;

        a->t[c] = fmax(a->t[c] + primal * a->dx[c].t, norm(a->r + 3 * c) * (1 + 0x1p-50) + 0x1p-500);
        for (size_t d = 0; d < 3; d++)
            y[d] += dual * a->dy[3 * c + d];
        length = norm(y);
        for (size_t d = 0; d < 3 && length > 1 - 0x1p-50; d++)
            y[d] *= (1 - 0x1p-50) / length;
    }
}

static void iterate(state *a)
{
    const double n = (double)a->model->nov;
    double primal, dual, now, then;

    do {
        now = 0;
        for (size_t c = 0; c < a->model->nov; c++)
            now += a->t[c] - dot(a->r + 3 * c, a->y + 3 * c);
        scale_all(a);
        aim(a, 0, 0);
        solve(a, TRIED);
        then = fmax(longest(&primal, &dual, a, 1, 1), 0) / now;
        aim(a, now / n * fmin(then * then * then, 1), 1);
        solve(a, ACCURACY);
        longest(&primal, &dual, a, 0.98, 1);
        if (fmin(primal, dual) < 0.25) {   /* too near the boundary: towards the centre first */
            aim(a, now / n, 0);
            solve(a, ACCURACY);
            longest(&primal, &dual, a, 0.98, 1);
        }
        step_inside(a, primal, dual);
    } while (!took(a, 0));
}

et_status optimum_cone_run(optimum_search *search)
{
    state a;
    const et_status status = acquire(&a, search);

    if (status == ET_OK) {
        a.value = residuals(&a);
        a.dual = 0;
        for (size_t c = 0; c < a.model->nov; c++)
            search->weight[6 * c] = search->weight[6 * c + 3] = search->weight[6 * c + 5] = 1;
        if (a.value > 0 && search->iterations < search->limit && !start(&a))
            iterate(&a);
    }
    release(&a);
    return status;
}
