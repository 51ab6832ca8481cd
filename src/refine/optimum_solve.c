/* N'WN x = b by conjugate gradients with the band's factor as preconditioner, residuals in twice the precision: where the factor is good that is one
 * step of iterative refinement or two, where rounding has spoilt it (control nets nearly as large as the data) it still converges. */
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 60 };

static optimum_pair two_sum(double a, double b)
{
    const double s = a + b, t = s - a;

    return (optimum_pair){s, (a - (s - t)) + (b - t)};
}

static optimum_pair fast_two_sum(double a, double b)
{
    const double s = a + b;

    return (optimum_pair){s, b - (s - a)};
}

/* The upper half of a's digits (Veltkamp). */
static double upper(double a)
{
    const double c = 0x1.0000002p+27 * a;

    return c - (c - a);
}

/* s + a x, to about 2^-100 of the greatest term. */
optimum_pair optimum_solve_add(optimum_pair s, double a, optimum_pair x)
{
    const double p = a * x.hi, ah = upper(a), al = a - ah, xh = upper(x.hi), xl = x.hi - xh;
    const double e = ((ah * xh - p) + ah * xl + al * xh) + al * xl;
    const optimum_pair t = two_sum(s.hi, p);

    return fast_two_sum(t.hi, t.lo + (s.lo + (e + a * x.lo)));
}

et_status optimum_solve_new(optimum_solver *solver, const optimum_model *model, int blocks)
{
    et_status status;

    memset(solver, 0, sizeof *solver);
    solver->model = model;
    solver->blocks = blocks;
    status = blocks ? optimum_band_new(&solver->band, 3 * model->m, 3 * model->half + 2) : optimum_band_new(&solver->band, model->m, model->half);
    solver->x = et_size_array(model->m, 6 * sizeof(double));
    solver->w = et_size_array(model->nov, 6 * sizeof(double));
    solver->row = et_size_array(model->nov, 3 * sizeof(double));
    solver->work = et_size_array(model->m, 6 * 3 * sizeof(double));
    solver->tile = et_size_array(optimum_band_work(&solver->band), sizeof(double));
    return solver->x && solver->w && solver->row && solver->work && solver->tile ? status : ET_ENOMEM;
}

void optimum_solve_free(optimum_solver *solver)
{
    optimum_band_free(&solver->band);
    free(solver->x);
    free(solver->w);
    free(solver->row);
    free(solver->work);
    free(solver->tile);
}

static void factor(optimum_solver *solver)
{
    const size_t n = solver->blocks ? 3 * solver->model->m : solver->model->m;

    if (solver->blocks)
        optimum_model_blocks(&solver->band, solver->model, solver->weight);
    else
        optimum_model_scalar(&solver->band, solver->model, solver->weight);
    for (size_t k = 0; k < n; k++)
        *optimum_band_at(&solver->band, k, k) *= 1 + solver->ridge;
    optimum_band_factor(&solver->band, NULL);
}

void optimum_solve_factor(optimum_solver *solver, const double *weight)
{
    solver->weight = weight;
    solver->ridge = 0;
    factor(solver);
}

static void precondition(const optimum_solver *s, double *z, const double *r)
{
    memcpy(z, r, 3 * s->model->m * sizeof *z);
    for (size_t d = 0; d < (s->blocks ? 1 : 3); d++)
        optimum_band_solve(&s->band, z + d, s->blocks ? 1 : 3, s->tile);
}

/* W w of one class, in doubles or optimum_pair. */
static void weigh(optimum_pair out[3], const optimum_solver *s, size_t c, const optimum_pair w[3])
{
    static const size_t place[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

    for (size_t d = 0; d < 3; d++) {
        out[d] = (optimum_pair){0, 0};
        for (size_t e = 0; e < 3 && s->blocks; e++)
            out[d] = optimum_solve_add(out[d], s->weight[6 * c + place[d][e]], w[e]);
        if (!s->blocks)
            out[d] = optimum_solve_add(out[d], s->weight[c], w[d]);
    }
}

/* r = b - N'WN x, in pairs; s->w keeps N x. */
static void residual(double *r, const optimum_solver *s, const double *b, optimum_pair *sum)
{
    const optimum_model *const m = s->model;
    const optimum_pair *const x = (const optimum_pair *)s->x;
    optimum_pair *const w = (optimum_pair *)s->w;

    for (size_t k = 0; k < 3 * m->m; k++)
        sum[k] = (optimum_pair){b[k], 0};
    for (size_t c = 0; c < m->nov; c++) {
        optimum_pair y[3];

        for (size_t d = 0; d < 3; d++) {
            w[3 * c + d] = (optimum_pair){0, 0};
            for (size_t k = m->start[c]; k < m->start[c + 1]; k++)
                w[3 * c + d] = optimum_solve_add(w[3 * c + d], m->value[k], x[3 * m->at[k] + d]);
        }
        weigh(y, s, c, w + 3 * c);
        for (size_t k = m->start[c]; k < m->start[c + 1]; k++)
            for (size_t d = 0; d < 3; d++)
                sum[3 * m->at[k] + d] = optimum_solve_add(sum[3 * m->at[k] + d], -m->value[k], y[d]);
    }
    for (size_t k = 0; k < 3 * m->m; k++)
        r[k] = sum[k].hi + sum[k].lo;
}

/* (N p)'W N p, in doubles. */
static double energy(const optimum_solver *s, const double *p, double *w)
{
    const optimum_model *const m = s->model;
    double sum = 0;

    memset(w, 0, 3 * m->nov * sizeof *w);
    optimum_model_apply(w, m, p);
    for (size_t c = 0; c < m->nov; c++) {
        const double *const v = w + 3 * c, *const h = s->weight + (s->blocks ? 6 * c : c);

        if (s->blocks)
            sum += v[0] * (h[0] * v[0] + 2 * (h[1] * v[1] + h[2] * v[2])) + v[1] * (h[3] * v[1] + 2 * h[4] * v[2]) + h[5] * v[2] * v[2];
        else
            sum += h[0] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    return sum;
}

static double product(const double *a, const double *b, size_t n)
{
    double sum = 0;

    for (size_t k = 0; k < n; k++)
        sum += a[k] * b[k];
    return sum;
}

/* p = z + beta p, with the factor of Polak and Ribiere, for which the preconditioner need not be quite the same each time. */
static void turn(double *p, const double *z, const double *r, const double *old, double before, size_t n)
{
    double beta = 0;

    for (size_t k = 0; k < n && before > 0; k++)
        beta += z[k] * (r[k] - old[k]);
    beta = before > 0 ? beta / before : 0;
    for (size_t k = 0; k < n; k++)
        p[k] = z[k] + beta * p[k];
}

/* 1 if it converged; 0 if it broke down. */
static int gradients(optimum_solver *solver, const double *b, double tolerance)
{
    const size_t n = 3 * solver->model->m;
    optimum_pair *const x = (optimum_pair *)solver->x, *const sum = (optimum_pair *)solver->work;
    double *const r = solver->work + 2 * n, *const z = r + n, *const p = z + n, *const old = p + n;
    double before = 0, first = 0;

    memset(solver->x, 0, 2 * n * sizeof *solver->x);
    memset(p, 0, n * sizeof *p);
    memcpy(r, b, n * sizeof *r);
    memset(solver->w, 0, 6 * solver->model->nov * sizeof *solver->w);
    for (size_t step = 0; step < STEPS; step++) {
        double now, along, most;

        precondition(solver, z, r);
        now = product(r, z, n);
        first = step == 0 ? now : first;
        if (!(now > first * tolerance * tolerance))
            return now >= -first * tolerance * tolerance;
        turn(p, z, r, old, before, n);
        most = energy(solver, p, solver->row);
        along = most > 0 ? product(p, r, n) / most : 0;
        if (!(along > 0 && isfinite(along)))
            return 0;
        for (size_t k = 0; k < n; k++)
            x[k] = optimum_solve_add(x[k], along, (optimum_pair){p[k], 0});
        memcpy(old, r, n * sizeof *r);
        before = now;
        residual(r, solver, b, sum);
    }
    return 0;
}

int optimum_solve_run(optimum_solver *solver, const double *b, double tolerance)
{
    while (!gradients(solver, b, tolerance)) {
        if (solver->ridge > 0x1p-36)
            return 0;
        solver->ridge = solver->ridge > 0 ? solver->ridge * 16 : 0x1p-48;
        factor(solver);
    }
    return 1;
}

void optimum_solve_take(double *x, double *w, const optimum_solver *solver)
{
    for (size_t k = 0; k < 3 * solver->model->m; k++)
        x[k] = solver->x[2 * k] + solver->x[2 * k + 1];
    for (size_t k = 0; k < 3 * solver->model->nov; k++)
        w[k] = solver->w[2 * k] + solver->w[2 * k + 1];
}
