/* N'WN x = b, from inside: sums in twice the precision, and conjugate gradients a second time, bit for bit. */
#include "etalon/base/real.h"
#include "etalon/refine/optimum.h"
#include "refine/optimum_cases.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NODES = 2 * OPTIMUM_MOST * OPTIMUM_MOST };

/* ---- sums ---- */

static double some_real(gen *g)
{
    return (1 + (double)gen_upto(g, ((uint64_t)1 << 52) - 1) * 0x1p-52) * ldexp(gen_chance(g, 2) ? -1 : 1, (int)gen_upto(g, 60) - 30);
}

static optimum_pair some_pair(gen *g)
{
    const double hi = gen_chance(g, 8) ? 0 : some_real(g), lo = gen_chance(g, 4) ? 0 : hi * some_real(g) * 0x1p-90;

    return (optimum_pair){hi + lo, lo - ((hi + lo) - hi)};
}

/* |s + a x - (hi + lo)| <= 2^-100 of the greatest term; nothing is lost of one product of doubles; hi is hi + lo rounded. */
verdict prop_optimum_find_sum(gen *g)
{
    const optimum_pair s = gen_chance(g, 4) ? (optimum_pair){0, 0} : some_pair(g), x = some_pair(g);
    const double a = some_real(g);
    const optimum_pair got = optimum_solve_add(s, a, x), product = optimum_solve_add((optimum_pair){0, 0}, a, (optimum_pair){x.hi, 0});
    const double most = fmax(fabs(s.hi), fabs(a * x.hi));
    arb_ptr t = _arb_vec_init(4);
    double error;
    bool ok;

    arb_set_d(t, a);
    arb_set_d(t + 1, x.hi);
    arb_mul(t + 2, t, t + 1, OPTIMUM_BITS);
    arb_set_d(t + 3, product.hi);
    arb_sub(t + 2, t + 2, t + 3, OPTIMUM_BITS);
    arb_set_d(t + 3, product.lo);
    arb_sub(t + 2, t + 2, t + 3, OPTIMUM_BITS);
    ok = gen_check(g, arb_is_zero(t + 2), "a product of doubles is not exact: %a, %a", product.hi, product.lo);
    arb_set_d(t + 3, x.lo);
    arb_add(t + 1, t + 1, t + 3, OPTIMUM_BITS);
    arb_mul(t + 2, t, t + 1, OPTIMUM_BITS);
    arb_set_d(t + 3, s.hi);
    arb_add(t + 2, t + 2, t + 3, OPTIMUM_BITS);
    arb_set_d(t + 3, s.lo);
    arb_add(t + 2, t + 2, t + 3, OPTIMUM_BITS);
    arb_set_d(t + 3, got.hi);
    arb_sub(t + 2, t + 2, t + 3, OPTIMUM_BITS);
    arb_set_d(t + 3, got.lo);
    arb_sub(t + 2, t + 2, t + 3, OPTIMUM_BITS);
    error = fabs(optimum_case_nearest(t + 2));
    ok = ok && gen_check(g, error <= 0x1p-100 * most, "an error of %g of %g", error, most);
    ok = ok && gen_check(g, got.hi + got.lo == got.hi, "%a, %a overlap", got.hi, got.lo);
    _arb_vec_clear(t, 4);
    return ok ? PASS : FAIL;
}

/* ---- conjugate gradients ---- */

typedef struct {
    const optimum_model *m;
    bool blocks;
    const double *weight;
    double ridge;
    optimum_band band;
    optimum_pair x[3 * NODES], w[3 * OPTIMUM_CLASSES];
} expected;

static double weight_of(const expected *e, size_t c, size_t i, size_t j)
{
    static const size_t block[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

    return e->weight[6 * c + block[i][j]];
}

static void factor(expected *e)
{
    (e->blocks ? optimum_model_blocks : optimum_model_scalar)(&e->band, e->m, e->weight);
    for (size_t k = 0; k < e->m->m * (e->blocks ? 3 : 1); k++)
        *optimum_band_at(&e->band, k, k) *= 1 + e->ridge;
    optimum_band_factor(&e->band, NULL);
}

/* z = M^-1 r: all at once, or a coordinate at a time. */
static void precondition(const expected *e, double *z, const double *r)
{
    const size_t m = e->m->m;
    double work[3 * NODES + OPTIMUM_SIDE], part[3 * NODES];

    if (e->blocks) {
        memcpy(z, r, 3 * m * sizeof *z);
        optimum_band_solve(&e->band, z, 1, work);
        return;
    }
    for (size_t d = 0; d < 3; d++) {
        for (size_t k = 0; k < m; k++)
            part[k] = r[3 * k + d];
        optimum_band_solve(&e->band, part, 1, work);
        for (size_t k = 0; k < m; k++)
            z[3 * k + d] = part[k];
    }
}

/* r = b - N'WN x, and w = N x, all in pairs. */
static void residual(expected *e, double *r, const double *b)
{
    const optimum_model *const m = e->m;
    static optimum_pair sum[3 * NODES];

    for (size_t k = 0; k < 3 * m->m; k++)
        sum[k] = (optimum_pair){b[k], 0};
    for (size_t c = 0; c < m->nov; c++) {
        const size_t from = m->start[c], to = m->start[c + 1];

        for (size_t d = 0; d < 3; d++) {
            e->w[3 * c + d] = (optimum_pair){0, 0};
            for (size_t k = from; k < to; k++)
                e->w[3 * c + d] = optimum_solve_add(e->w[3 * c + d], m->value[k], e->x[3 * m->at[k] + d]);
        }
        for (size_t d = 0; d < 3; d++) {
            optimum_pair y = {0, 0};

            for (size_t i = e->blocks ? 0 : d; i < (e->blocks ? 3 : d + 1); i++)
                y = optimum_solve_add(y, e->blocks ? weight_of(e, c, d, i) : e->weight[c], e->w[3 * c + i]);
            for (size_t k = from; k < to; k++)
                sum[3 * m->at[k] + d] = optimum_solve_add(sum[3 * m->at[k] + d], -m->value[k], y);
        }
    }
    for (size_t k = 0; k < 3 * m->m; k++)
        r[k] = sum[k].hi + sum[k].lo;
}

static double inner(const double *a, const double *b, size_t n)
{
    double sum = 0;

    for (size_t k = 0; k < n; k++)
        sum += a[k] * b[k];
    return sum;
}

static double energy(const expected *e, const double *p)
{
    double sum = 0;

    for (size_t c = 0; c < e->m->nov; c++) {
        double v[3] = {0, 0, 0};

        for (size_t k = e->m->start[c]; k < e->m->start[c + 1]; k++)
            for (size_t d = 0; d < 3; d++)
                v[d] += e->m->value[k] * p[3 * e->m->at[k] + d];
        if (e->blocks)
            sum += v[0] * (weight_of(e, c, 0, 0) * v[0] + 2 * (weight_of(e, c, 0, 1) * v[1] + weight_of(e, c, 0, 2) * v[2])) +
                   v[1] * (weight_of(e, c, 1, 1) * v[1] + 2 * weight_of(e, c, 1, 2) * v[2]) + weight_of(e, c, 2, 2) * v[2] * v[2];
        else
            sum += e->weight[c] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    return sum;
}

/* At most 60 steps of Polak and Ribiere's; whether they came to an end. */
static bool descend(expected *e, const double *b, double tolerance)
{
    const size_t n = 3 * e->m->m;
    double r[3 * NODES], old[3 * NODES], z[3 * NODES], p[3 * NODES] = {0}, before = 0, end = 0;

    memset(e->x, 0, sizeof e->x);
    memset(e->w, 0, sizeof e->w);
    memcpy(r, b, n * sizeof *r);
    for (size_t step = 0; step < 60; step++) {
        double now, beta = 0, most, along;

        precondition(e, z, r);
        now = inner(r, z, n);
        end = step == 0 ? now * tolerance * tolerance : end;
        if (!(now > end))
            return now >= -end;
        for (size_t k = 0; k < n && step > 0; k++)
            beta += z[k] * (r[k] - old[k]);
        for (size_t k = 0; k < n; k++)
            p[k] = z[k] + (step > 0 ? beta / before : 0) * p[k];
        most = energy(e, p);
        along = inner(p, r, n) / most;
        if (!(most > 0) || !(along > 0) || isinf(along))
            return false;
        for (size_t k = 0; k < n; k++)
            e->x[k] = optimum_solve_add(e->x[k], along, (optimum_pair){p[k], 0});
        memcpy(old, r, n * sizeof *r);
        before = now;
        residual(e, r, b);
    }
    return false;
}

static bool run(expected *e, const double *b, double tolerance)
{
    static const double ridges[] = {0x1p-48, 0x1p-44, 0x1p-40, 0x1p-36, 0x1p-32};

    for (size_t k = 0;; k++) {
        while (k < 5 && ridges[k] <= e->ridge)
            k++;
        if (descend(e, b, tolerance))
            return true;
        if (k == 5)
            return false;
        e->ridge = ridges[k];
        factor(e);
    }
}

/* ---- the property ---- */

/* Positive numbers, or I + f q q', some of them far from the others.  odd: all of them zero, or some of them negative: then nothing is solved, but
 * that is told, and what comes out is determined all the same. */
static void draw_weights(gen *g, double *weight, size_t nov, bool blocks, size_t odd)
{
    const int far = (int)gen_upto(g, 3) * 25;

    for (size_t c = 0; c < nov; c++) {
        const double size = ldexp(gen_real(g, 1, 2), gen_chance(g, 3) ? -far : 0),
                     q[3] = {gen_real(g, -1, 1), gen_real(g, -1, 1), gen_real(g, -1, 1)};
        double *const h = weight + (blocks ? 6 * c : c);

        h[0] = size;
        for (size_t i = 0, k = 0; i < 3 && blocks; i++)
            for (size_t j = i; j < 3; j++, k++)
                h[k] = size * (q[i] * q[j] + (i == j ? 0x1p-4 : 0));
        for (size_t k = 0; k < (blocks ? 6 : 1) && odd > 0; k++)
            h[k] *= odd == 1 ? 0 : gen_chance(g, 4) ? -1 : 1;
    }
}

static bool same_solution(gen *g, const optimum_solver *s, const expected *e)
{
    double x[3 * NODES], w[3 * OPTIMUM_CLASSES];
    const size_t n = 3 * e->m->m, nov = 3 * e->m->nov;
    bool ok = gen_check(g, s->ridge == e->ridge, "ridge %a, not %a", s->ridge, e->ridge);

    optimum_solve_take(x, w, s);
    for (size_t k = 0; k < n && ok; k++)
        ok = gen_check(g, optimum_case_same(s->x + 2 * k, &e->x[k].hi, 1) && optimum_case_same(s->x + 2 * k + 1, &e->x[k].lo, 1),
                       "x[%zu]: %a, not %a", k, s->x[2 * k], e->x[k].hi) &&
             gen_check(g, x[k] == e->x[k].hi + e->x[k].lo, "x[%zu] taken", k);
    for (size_t k = 0; k < nov && ok; k++)
        ok = gen_check(g, optimum_case_same(s->w + 2 * k, &e->w[k].hi, 1) && optimum_case_same(s->w + 2 * k + 1, &e->w[k].lo, 1),
                       "w[%zu]: %a, not %a", k, s->w[2 * k], e->w[k].hi) &&
             gen_check(g, w[k] == e->w[k].hi + e->w[k].lo, "w[%zu] taken", k);
    return ok;
}

/* What is taken of a pair is its sum, whatever stands in it. */
static bool taken(gen *g, optimum_solver *s)
{
    double x[3 * NODES], w[3 * OPTIMUM_CLASSES];
    const size_t n = 3 * s->model->m, nov = 3 * s->model->nov;
    bool ok = true;

    for (size_t k = 0; k < 2 * n; k++)
        s->x[k] = (double)(k + 1);
    for (size_t k = 0; k < 2 * nov; k++)
        s->w[k] = (double)(3 * k + 2);
    optimum_solve_take(x, w, s);
    for (size_t k = 0; k < n && ok; k++)
        ok = gen_check(g, x[k] == (double)(4 * k + 3), "x[%zu]: %g", k, x[k]);
    for (size_t k = 0; k < nov && ok; k++)
        ok = gen_check(g, w[k] == (double)(12 * k + 7), "w[%zu]: %g", k, w[k]);
    return ok;
}

/* One case in 6. */
verdict prop_optimum_find_solve(gen *g)
{
    static expected e;
    const bool blocks = gen_chance(g, 2);
    const size_t odd = gen_chance(g, 4) ? gen_between(g, 1, 2) : 0;
    const double tolerance = ldexp(1, -(int)gen_between(g, 12, 50)), size = ldexp(1, -20 * (int)gen_upto(g, 3));
    double weight[6 * OPTIMUM_CLASSES], b[3 * NODES];
    optimum_case c;
    optimum_model m;
    optimum_solver s;
    bool ok = optimum_case_draw(g, &c, (optimum_state)gen_upto(g, 3));

    ok = ok && optimum_model_new(&m, &c.fit) == ET_OK;
    if (!ok)
        return FAIL;
    memset(&e, 0, sizeof e);
    e.m = &m;
    e.blocks = blocks;
    e.weight = weight;
    draw_weights(g, weight, c.nov, blocks, odd);
    for (size_t k = 0; k < 3 * m.m; k++)
        b[k] = gen_real(g, -size, size);
    ok = optimum_solve_new(&s, &m, blocks) == ET_OK && optimum_band_new(&e.band, (blocks ? 3 : 1) * m.m, blocks ? 3 * m.half + 2 : m.half) == ET_OK;
    s.ridge = 1;                          /* of another matrix */
    optimum_solve_factor(&s, weight);
    factor(&e);
    for (size_t k = 0; k < 3 && ok; k++) {  /* a second right side keeps the ridge; the third is 0, and so is its solution */
        const bool want = run(&e, b, tolerance);

        ok = gen_check(g, optimum_solve_run(&s, b, tolerance) == want, "%s", want ? "not solved" : "solved") && same_solution(g, &s, &e);
        gen_label(g, !want ? "not solved" : e.ridge > 0 ? "ridge" : "solved");
        b[0] = size;
        if (k == 1)
            memset(b, 0, sizeof b);
    }
    ok = ok && taken(g, &s);
    optimum_band_free(&e.band);
    optimum_solve_free(&s);
    optimum_model_free(&m);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}
