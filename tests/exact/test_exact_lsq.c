/* exact/exact_lsq: least squares of curves, grids and scattered points against the dense normal equations in rationals, with basis functions by de
 * Boor's algorithm; rank against echelon forms and the conditions of Schoenberg and Whitney. */
#include "etalon/base/size.h"
#include "etalon/exact/exact.h"
#include "exact/exact_fit_parts.h"
#include "exact/live.h"
#include "exact/nearest.h"
#include "exact/rational.h"
#include "golden.h"
#include <flint/ulong_extras.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { MOST = 32 };

/* ---- the second way ---- */

/* A[k][j] = N_j(t_k). */
static void collocation(fmpq_mat_t A, const double *u, size_t p, const double *t)
{
    size_t n = (size_t)fmpq_mat_ncols(A);
    fmpq *c = _fmpq_vec_init((slong)n);
    for (size_t j = 0; j < n; j++) {
        fmpq_one(c + j);
        for (slong k = 0; k < fmpq_mat_nrows(A); k++) {
            deboor(fmpq_mat_entry(A, k, (slong)j), c, 1, u, n + p + 1, p, t[k], 0);
        }
        fmpq_zero(c + j);
    }
    _fmpq_vec_clear(c, (slong)n);
}

/* (sqrt of q), to the nearest double. */
static double root(const fmpq_t q)
{
    mpfr_t x;
    mpfr_init2(x, SECOND_BITS);
    fmpq_get_mpfr(x, q, MPFR_RNDN);
    mpfr_sqrt(x, x, MPFR_RNDN);
    double r = mpfr_zero_p(x) ? 0.0 : nearest(x);
    mpfr_clear(x);
    return r;
}

static void squares(fmpq_t sum, const fmpq_mat_t A)
{
    fmpq_zero(sum);
    for (slong i = 0; i < fmpq_mat_nrows(A); i++) {
        for (slong j = 0; j < fmpq_mat_ncols(A); j++) {
            fmpq_addmul(sum, fmpq_mat_entry(A, i, j), fmpq_mat_entry(A, i, j));
        }
    }
}

/* G = A'A. */
static void gram(fmpq_mat_t G, const fmpq_mat_t A)
{
    fmpq_mat_t T;
    fmpq_mat_init(T, fmpq_mat_ncols(A), fmpq_mat_nrows(A));
    fmpq_mat_transpose(T, A);
    fmpq_mat_mul(G, T, A);
    fmpq_mat_clear(T);
}

/* X of the least |A X - D|, columns that are fixed as they stand in X. */
static void normal_equations(fmpq_mat_t X, const fmpq_mat_t A, const fmpq_mat_t D, const bool *fixed)
{
    slong m = fmpq_mat_nrows(A), n = fmpq_mat_ncols(A), left = 0, k = fmpq_mat_ncols(D);
    fmpq_mat_t R, F, G, T, Y;
    fmpq_mat_init(R, m, k);
    fmpq_mat_mul(R, A, X);
    fmpq_mat_sub(R, D, R);                  /* those that are not fixed are zero in X */
    for (slong j = 0; j < n; j++) {
        left += !fixed[j];
    }
    fmpq_mat_init(F, m, left);
    fmpq_mat_init(G, left, left);
    fmpq_mat_init(T, left, m);
    fmpq_mat_init(Y, left, k);
    for (slong j = 0, c = 0; j < n; j++) {
        for (slong i = 0; i < m && !fixed[j]; i++) {
            fmpq_set(fmpq_mat_entry(F, i, c), fmpq_mat_entry(A, i, j));
        }
        c += !fixed[j];
    }
    gram(G, F);
    fmpq_mat_transpose(T, F);
    fmpq_mat_mul(Y, T, R);
    if (left > 0) {
        fmpq_mat_solve(Y, G, Y);
    }
    for (slong j = 0, c = 0; j < n; j++) {
        for (slong a = 0; a < k && !fixed[j]; a++) {
            fmpq_set(fmpq_mat_entry(X, j, a), fmpq_mat_entry(Y, c, a));
        }
        c += !fixed[j];
    }
    fmpq_mat_clear(R);
    fmpq_mat_clear(F);
    fmpq_mat_clear(G);
    fmpq_mat_clear(T);
    fmpq_mat_clear(Y);
}

/* The norms of all of A. */
static bool same_norms(gen *g, const fmpq_mat_t A, const et_exact_lsq *lsq)
{
    slong n = fmpq_mat_ncols(A);
    fmpq_t norm, trace;
    fmpq_mat_t G;
    fmpq_init(norm);
    fmpq_init(trace);
    fmpq_mat_init(G, n, n);
    squares(norm, A);
    gram(G, A);
    bool ok = gen_check(g, fmpq_mat_inv(G, G), "no inverse");
    fmpq_mat_trace(trace, G);
    fmpq_mul(trace, trace, norm);
    ok = ok && gen_check(g, ref_same(lsq->norm, root(norm)), "norm %a, not %a", lsq->norm, root(norm));
    ok =
        ok && gen_check(g, ref_same(lsq->condition, root(trace)) && lsq->condition >= (double)n, "condition %a, not %a", lsq->condition, root(trace));
    fmpq_clear(norm);
    fmpq_clear(trace);
    fmpq_mat_clear(G);
    return ok;
}

static double component(et_vec3 P, slong a)
{
    return coordinate(P, (int)a);
}

/* P and all the numbers of lsq, of A P = D. */
static bool same_solution(gen *g, const et_vec3 *P, const et_exact_lsq *lsq, const fmpq_mat_t A, const et_vec3 *D, const bool *fixed,
                          const size_t *at)
{
    slong m = fmpq_mat_nrows(A), n = fmpq_mat_ncols(A);
    fmpq_mat_t X, B, R, x, r;
    fmpq_t sum;
    bool ok = same_norms(g, A, lsq);
    fmpq_init(sum);
    fmpq_mat_init(X, n, 3);
    fmpq_mat_init(B, m, 3);
    fmpq_mat_init(R, m, 3);
    for (slong a = 0; a < 3; a++) {
        for (slong k = 0; k < m; k++) {
            exact_set(fmpq_mat_entry(B, k, a), component(D[k], a));
        }
        for (slong j = 0; j < n; j++) {
            if (fixed[j]) {
                exact_set(fmpq_mat_entry(X, j, a), component(D[at[j]], a));
            }
        }
    }
    normal_equations(X, A, B, fixed);
    fmpq_mat_mul(R, A, X);
    fmpq_mat_sub(R, R, B);
    for (slong a = 0; ok && a < 3; a++) {
        for (slong j = 0; ok && j < n; j++) {
            double want = exact_round(fmpq_mat_entry(X, j, a));
            ok = gen_check(g, ref_same(component(P[j], a), want), "coordinate %ld of control point %ld is %a, not %a", (long)a, (long)j,
                           component(P[j], a), want);
        }
        fmpq_mat_window_init(x, X, 0, a, n, a + 1);
        fmpq_mat_window_init(r, R, 0, a, m, a + 1);
        squares(sum, x);
        ok = ok && gen_check(g, ref_same(component(lsq->solution, a), root(sum)), "solution %a, not %a", component(lsq->solution, a), root(sum));
        squares(sum, r);
        ok = ok && gen_check(g, ref_same(component(lsq->residual, a), root(sum)), "residual %a, not %a", component(lsq->residual, a), root(sum));
        if (fmpq_is_zero(sum)) {
            gen_label(g, "no residual");
        }
        fmpq_mat_window_clear(x);
        fmpq_mat_window_clear(r);
    }
    fmpq_clear(sum);
    fmpq_mat_clear(X);
    fmpq_mat_clear(B);
    fmpq_mat_clear(R);
    return ok;
}

static slong rank_of(const fmpq_mat_t A)
{
    fmpq_mat_t E;
    fmpq_mat_init(E, fmpq_mat_nrows(A), fmpq_mat_ncols(A));
    slong rank = fmpq_mat_rref(E, A);
    fmpq_mat_clear(E);
    return rank;
}

/* ---- problems ---- */

static const et_exact_lsq NOTHING = {-1.0, -2.0, {-3.0, -4.0, -5.0}, {-6.0, -7.0, -8.0}};

static bool untouched(const et_vec3 *P, const et_exact_lsq *lsq)
{
    return P[0].x == 4711.0 && memcmp(lsq, &NOTHING, sizeof NOTHING) == 0;
}

/* Parameters of n functions, m of them: the first n where the functions are greatest, mostly, so that the rank is full; the others anywhere. */
static void draw_parameters(gen *g, double *t, size_t m, const double *u, size_t n, size_t p)
{
    bool anywhere = gen_chance(g, 3), few = gen_chance(g, 3);
    for (size_t k = 0; k < m; k++) {
        double sum = 0.0;
        for (size_t j = 1; j <= p; j++) {
            sum += u[k % n + j];
        }
        t[k] = k < n && !anywhere ? fmin(fmax(sum / (double)p, u[p]), u[n])
               : few              ? u[p] + (u[n] - u[p]) * (double)gen_upto(g, 3) / 4.0
                                  : gen_parameter(g, u, n + p + 1, p);
    }
}

/* Knots of which most are clamped and simple. */
static bool draw_fit_knots(gen *g, double *u, size_t n, size_t p)
{
    if (gen_upto(g, 2) < 2) {
        for (size_t i = 0; i < n + p + 1; i++) {
            u[i] = i <= p ? 0.0 : i >= n ? 1.0 : (double)(i - p) / (double)(n - p);
        }
        return true;
    }
    ref_draw_knots(g, u, n + p + 1, p);
    return et_knots_valid(u, n + p + 1, p);
}

static void draw_data(gen *g, et_vec3 *D, size_t m)
{
    if (gen_upto(g, 2) < 2) {
        for (size_t k = 0; k < m; k++) {
            D[k] = (et_vec3){(double)gen_upto(g, 16) - 8.0, (double)gen_upto(g, 1), gen_real(g, 0.0, 1.0)};
        }
    } else {
        gen_points(g, &D->x, m);
    }
}

/* ---- curves ---- */

typedef struct {
    size_t p, n, m;
    double u[MOST], t[MOST];
    et_vec3 D[MOST];
} curve_problem;

static bool draw_curve_problem(gen *g, curve_problem *b, size_t most)
{
    b->p = 1 + (size_t)gen_upto(g, 2);
    b->n = b->p + 1 + (size_t)gen_upto(g, 3);
    b->m = b->n - 1 + (size_t)gen_upto(g, most);
    if (!draw_fit_knots(g, b->u, b->n, b->p)) {
        return false;
    }
    draw_parameters(g, b->t, b->m, b->u, b->n, b->p);
    draw_data(g, b->D, b->m);
    gen_note(g, "p = %zu, n = %zu, m = %zu", b->p, b->n, b->m);
    return true;
}

/* ET_EINTERNAL: memory is kept. */
static et_status run_curve(et_vec3 *P, et_exact_lsq *lsq, const curve_problem *b)
{
    live_begin(b->m + 2 * b->n + b->p);
    et_status status = et_exact_fit_curve(P, b->n, lsq, b->u, b->n + b->p + 1, b->p, b->t, b->D, b->m);
    return live_end() ? status : ET_EINTERNAL;
}

static int ascending(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return *x < *y ? -1 : *x > *y;
}

/* Schoenberg and Whitney: there are parameters t_1 < t_2 < .. with N_j(t_j) not 0. */
static bool interlaced(const curve_problem *b)
{
    double t[MOST];
    size_t at = 0;
    memcpy(t, b->t, b->m * sizeof *t);
    qsort(t, b->m, sizeof *t, ascending);
    for (size_t j = 0; j < b->n; j++) {
        double lo = b->u[j], hi = b->u[j + b->p + 1], last = b->u[b->n];
        bool left = b->u[j + b->p] == lo, right = b->u[j + 1] == hi;          /* 1 at an end, or at a jump from the right */
        while (at < b->m && !((t[at] > lo || (left && t[at] == lo)) && (t[at] < hi || (right && hi == last && t[at] == hi)))) {
            at++;
        }
        if (at == b->m || lo == hi) {
            return false;
        }
        for (double x = t[at]; at < b->m && t[at] == x;) {
            at++;
        }
    }
    return true;
}

/* One case in 3. */
verdict prop_exact_fit_curve(gen *g)
{
    curve_problem b;
    et_vec3 P[MOST] = {{4711.0, 0.0, 0.0}};
    et_exact_lsq lsq = NOTHING;
    static const bool fixed[MOST] = {false};
    fmpq_mat_t A;
    if (!draw_curve_problem(g, &b, 5)) {
        return SKIP;
    }
    fmpq_mat_init(A, (slong)b.m, (slong)b.n);
    collocation(A, b.u, b.p, b.t);
    bool full = rank_of(A) == (slong)b.n;
    gen_label(g, full ? b.m == b.n ? "interpolation" : "full rank" : "rank deficient");
    et_status status = run_curve(P, &lsq, &b);
    bool ok = gen_check(g, status == (full ? ET_OK : ET_ERANK), "status %d", (int)status);
    ok = ok && (full ? same_solution(g, P, &lsq, A, b.D, fixed, NULL) : gen_check(g, untouched(P, &lsq), "changed without a solution"));
    ok = ok && gen_check(g, full == interlaced(&b), "Schoenberg and Whitney: %d", (int)full);
    fmpq_mat_clear(A);
    return ok ? PASS : FAIL;
}

/* What is no problem at all. */
verdict prop_exact_fit_curve_refuses(gen *g)
{
    curve_problem b;
    et_vec3 P[MOST] = {{4711.0, 0.0, 0.0}};
    et_exact_lsq lsq = NOTHING;
    if (!draw_curve_problem(g, &b, 3)) {
        return SKIP;
    }
    size_t nu = b.n + b.p + 1, k = (size_t)gen_upto(g, b.m - 1);
    bool ok = gen_check(g, et_exact_fit_curve(P, b.n, &lsq, b.u, nu + 1, b.p, b.t, b.D, b.m) == ET_EINVAL &&
                               et_exact_fit_curve(P, b.n, &lsq, b.u, nu - 1, b.p, b.t, b.D, b.m) == ET_EINVAL &&
                               et_exact_fit_curve(P, b.p, &lsq, b.u, 2 * b.p + 1, b.p, b.t, b.D, b.m) == ET_EINVAL &&
                               et_exact_fit_curve(P, nu - 1, &lsq, b.u, nu, 0, b.t, b.D, b.m) == ET_EINVAL &&
                               et_exact_fit_curve(P, b.n, &lsq, b.u, b.n - 1, b.p, b.t, b.D, b.m) == ET_EINVAL &&
                               et_exact_fit_curve(P, b.n, &lsq, b.u, nu, b.p, b.t, b.D, 0) == ET_EINVAL, "sizes");
    double x = b.t[k], y = b.D[k].y;
    double bad[] = {nextafter(b.u[b.p], -HUGE_VAL), nextafter(b.u[b.n], HUGE_VAL), NAN};
    for (size_t i = 0; ok && i < 3; i++) {
        b.t[k] = bad[i];
        ok = gen_check(g, run_curve(P, &lsq, &b) == ET_EINVAL, "a parameter %a", bad[i]);
    }
    b.t[k] = x;
    b.D[k].y = gen_upto(g, 1) ? NAN : HUGE_VAL;
    ok = ok && gen_check(g, run_curve(P, &lsq, &b) == ET_EINVAL, "a datum that is not finite");
    b.D[k].y = y;
    b.u[b.p] = NAN;
    ok = ok && gen_check(g, run_curve(P, &lsq, &b) == ET_EINVAL, "knots that are not valid");
    ok = ok && gen_check(g, untouched(P, &lsq), "changed without a solution");
    return ok ? PASS : FAIL;
}

/* The mean of two neighbours is a tie that balls do not decide; and zeros, roots of squares, overflow. */
verdict prop_exact_fit_curve_ties(gen *g)
{
    static const double from[] = {1.0, 0.0, 0x1p-1074, 0x1.fffffffffffffp0, DBL_MIN, 0x1.8p300, 0x1.ffffffffffffep1023, 0x1.0000000000001p-1022};
    double x = from[gen_upto(g, 7)], y = nextafter(x, HUGE_VAL), u[4] = {0.0, 0.0, 1.0, 1.0}, t[4] = {0.0, 0.0, 1.0, 1.0};
    double sign = gen_upto(g, 1) ? -1.0 : 1.0, even = nearest_even(x) ? x : y;
    et_vec3 D[4] = {{sign * x, 3.0, 0.0}, {sign * y, 3.0, 0.0}, {5.0, -4.0, 0.0}, {7.0, -4.0, 0.0}}, P[2];
    et_exact_lsq lsq;
    bool ok = gen_check(g, et_exact_fit_curve(P, 2, &lsq, u, 4, 1, t, D, 4) == ET_OK, "status");
    ok = ok && gen_check(g, P[0].x == sign * even && P[0].y == 3.0 && ref_same(P[0].z, 0.0), "the mean of %a and %a: %a", x, y, P[0].x);
    ok = ok && gen_check(g, P[1].x == 6.0 && P[1].y == -4.0, "the mean of 5 and 7: %a", P[1].x);
    /* A = two rows each of (1 0) and (0 1): |A| = 2, |A+| = 1. */
    ok = ok && gen_check(g, lsq.norm == 2.0 && lsq.condition == 2.0 && lsq.solution.y == 5.0 && lsq.solution.z == 0.0 && lsq.residual.y == 0.0,
                         "norm %a, condition %a", lsq.norm, lsq.condition);
    D[0].z = 0x1p1023;
    D[1].z = DBL_MAX;
    t[1] = 0.5;                                            /* a straight line from 2^1023 through DBL_MAX and on */
    ok = ok && gen_check(g,
                         et_exact_fit_curve(P, 2, &lsq, u, 4, 1, t, D, 2) == ET_OK && P[0].z == 0x1p1023 && P[1].z == HUGE_VAL &&
                             lsq.solution.z == HUGE_VAL && ref_same(lsq.residual.z, 0.0),
                         "beyond the range: %a", P[1].z);
    return ok ? PASS : FAIL;
}

/* Spans at the limits of the doubles and data that lie on a line: all is as for whole numbers. */
verdict prop_exact_fit_curve_scales(gen *g)
{
    curve_problem b, c;
    et_vec3 P[MOST], Q[MOST];
    et_exact_lsq p, q;
    if (!draw_curve_problem(g, &b, 4)) {
        return SKIP;
    }
    int e = (int)gen_upto(g, 1600) - 800, f = (int)gen_upto(g, 800) - 400;
    c = b;
    for (size_t i = 0; i < b.n + b.p + 1; i++) {
        b.u[i] = ldexp(round(ldexp(b.u[i], 20)), -20);
        c.u[i] = ldexp(b.u[i], e);
    }
    for (size_t k = 0; k < b.m; k++) {
        b.t[k] = ldexp(round(ldexp(b.t[k], 20)), -20);
        c.t[k] = ldexp(b.t[k], e);
        b.D[k] = (et_vec3){(double)gen_upto(g, 8), 2.0 * (double)k, 0.0};
        c.D[k] = (et_vec3){ldexp(b.D[k].x, f), ldexp(b.D[k].y, f), 0.0};
    }
    if (!et_knots_valid(b.u, b.n + b.p + 1, b.p) || !et_knots_valid(c.u, c.n + c.p + 1, c.p)) {
        return SKIP;
    }
    et_status status = run_curve(P, &p, &b);
    bool ok = gen_check(g, run_curve(Q, &q, &c) == status, "another status");
    for (size_t j = 0; ok && status == ET_OK && j < b.n; j++) {
        ok = gen_check(g, ref_same(Q[j].x, ldexp(P[j].x, f)) && ref_same(Q[j].y, ldexp(P[j].y, f)), "control point %zu: %a for %a 2^%d", j, Q[j].x,
                       P[j].x, f);
    }
    ok = ok && gen_check(g, status != ET_OK || (p.norm == q.norm && p.condition == q.condition && q.residual.x == ldexp(p.residual.x, f)), "norms");
    return ok ? PASS : FAIL;
}

/* Columns that depend on each other, over the integers and primes that are tried. */
verdict prop_exact_fit_curve_dependent(gen *g)
{
    slong m = (slong)gen_between(g, 1, 6), n = (slong)gen_between(g, 1, 5);
    fmpq_mat_t A;
    ulong prime = EXACT_PRIME;
    fmpq_mat_init(A, m, n);
    for (slong i = 0; i < m; i++) {
        for (slong j = 0; j < n; j++) {
            slong x = (slong)gen_upto(g, 4) - 2;
            fmpq_set_si(fmpq_mat_entry(A, i, j), x, 1 + gen_upto(g, 2));
            for (uint64_t k = gen_upto(g, 5); k > 3; k--) { /* modulo these nothing is left */
                fmpq_mul_ui(fmpq_mat_entry(A, i, j), fmpq_mat_entry(A, i, j), k == 5 ? n_nextprime(prime, 1) : prime);
            }
        }
    }
    for (slong j = 1; j < n && gen_chance(g, 3); j++) {     /* a column that is twice another one */
        for (slong i = 0; i < m; i++) {
            fmpq_mul_ui(fmpq_mat_entry(A, i, j), fmpq_mat_entry(A, i, j - 1), 2);
        }
    }
    bool dependent = rank_of(A) < n;
    gen_label(g, dependent ? "dependent" : "independent");
    bool ok = gen_check(g, exact_dependent(A) == dependent, "%ld x %ld: dependent %d", (long)m, (long)n, (int)dependent);
    fmpq_mat_clear(A);
    return ok ? PASS : FAIL;
}

/* ---- grids ---- */

typedef struct {
    size_t p, q, nu, nv, mu, mv;
    double u[MOST], v[MOST], a[MOST], b[MOST];
    et_vec3 D[MOST];
} grid_problem;

static bool draw_grid_problem(gen *g, grid_problem *b)
{
    b->p = 1 + (size_t)gen_upto(g, 1);
    b->q = 1 + (size_t)gen_upto(g, 1);
    b->nu = b->p + 1 + (size_t)gen_upto(g, 1);
    b->nv = b->q + 1 + (size_t)gen_upto(g, 1);
    b->mu = b->nu + (size_t)gen_upto(g, 1);
    b->mv = b->nv + (size_t)gen_upto(g, 1);
    if (gen_chance(g, 20)) {
        b->mu--;
    }
    if (!draw_fit_knots(g, b->u, b->nu, b->p) || !draw_fit_knots(g, b->v, b->nv, b->q)) {
        return false;
    }
    draw_parameters(g, b->a, b->mu, b->u, b->nu, b->p);
    draw_parameters(g, b->b, b->mv, b->v, b->nv, b->q);
    draw_data(g, b->D, b->mu * b->mv);
    gen_note(g, "p = %zu, q = %zu, %zu x %zu from %zu x %zu", b->p, b->q, b->nu, b->nv, b->mu, b->mv);
    return true;
}

/* ET_EINTERNAL: memory is kept. */
static et_status run_grid(et_vec3 *P, et_exact_lsq *lsq, const grid_problem *b, int corners)
{
    live_begin(b->mu + b->mv + b->nu + b->p);
    et_status status = et_exact_fit_grid(P, b->nu, b->nv, lsq, b->u, b->p, b->v, b->q, b->a, b->mu, b->b, b->mv, b->D, corners);
    return live_end() ? status : ET_EINTERNAL;
}

/* Of data (i, j) at i*mv + j, control points at i*nv + j. */
static void product(fmpq_mat_t A, const fmpq_mat_t U, const fmpq_mat_t V)
{
    slong mv = fmpq_mat_nrows(V), nv = fmpq_mat_ncols(V);
    for (slong r = 0; r < fmpq_mat_nrows(A); r++) {
        for (slong c = 0; c < fmpq_mat_ncols(A); c++) {
            fmpq_mul(fmpq_mat_entry(A, r, c), fmpq_mat_entry(U, r / mv, c / nv), fmpq_mat_entry(V, r % mv, c % nv));
        }
    }
}

static bool ends_at(const double *u, size_t n, size_t p, const double *t, size_t m)
{
    return u[0] == u[p] && u[n] == u[n + p] && t[0] == u[p] && t[m - 1] == u[n];
}

/* One case in 5. */
verdict prop_exact_fit_grid(gen *g)
{
    grid_problem b;
    et_vec3 P[MOST] = {{4711.0, 0.0, 0.0}};
    et_exact_lsq lsq = NOTHING;
    bool fixed[MOST] = {false};
    size_t at[MOST] = {0};
    fmpq_mat_t U, V, A;
    if (!draw_grid_problem(g, &b)) {
        return SKIP;
    }
    int corners = (int)gen_upto(g, 1);
    if (corners && !gen_chance(g, 8)) {
        b.a[0] = b.u[b.p];
        b.a[b.mu - 1] = b.u[b.nu];
        b.b[0] = b.v[b.q];
        b.b[b.mv - 1] = b.v[b.nv];
    }
    bool can = !corners || (ends_at(b.u, b.nu, b.p, b.a, b.mu) && ends_at(b.v, b.nv, b.q, b.b, b.mv));
    fmpq_mat_init(U, (slong)b.mu, (slong)b.nu);
    fmpq_mat_init(V, (slong)b.mv, (slong)b.nv);
    fmpq_mat_init(A, (slong)(b.mu * b.mv), (slong)(b.nu * b.nv));
    collocation(U, b.u, b.p, b.a);
    collocation(V, b.v, b.q, b.b);
    product(A, U, V);
    for (size_t e = 0; e < 4; e++) {
        size_t j = e / 2 * (b.nu - 1) * b.nv + e % 2 * (b.nv - 1);
        fixed[j] = corners;
        at[j] = e / 2 * (b.mu - 1) * b.mv + e % 2 * (b.mv - 1);
    }
    bool full = rank_of(U) == (slong)b.nu && rank_of(V) == (slong)b.nv;
    gen_label(g, !can ? "no corners" : !full ? "rank deficient" : corners ? "corners" : "free");
    et_status status = run_grid(P, &lsq, &b, corners);
    bool ok = gen_check(g, status == (!can ? ET_EINVAL : full ? ET_OK : ET_ERANK), "status %d", (int)status);
    ok = ok && (status == ET_OK ? same_solution(g, P, &lsq, A, b.D, fixed, at) : gen_check(g, untouched(P, &lsq), "changed without a solution"));
    fmpq_mat_clear(U);
    fmpq_mat_clear(V);
    fmpq_mat_clear(A);
    return ok ? PASS : FAIL;
}

verdict prop_exact_fit_grid_refuses(gen *g)
{
    grid_problem b;
    et_vec3 P[MOST] = {{4711.0, 0.0, 0.0}};
    et_exact_lsq lsq = NOTHING;
    if (!draw_grid_problem(g, &b)) {
        return SKIP;
    }
    size_t i = (size_t)gen_upto(g, b.mu - 1), j = (size_t)gen_upto(g, b.mv - 1), k = i * b.mv + j;
    int corners = (int)gen_upto(g, 1);
    grid_problem c = b;
    c.a[i] = gen_upto(g, 1) ? NAN : nextafter(c.u[c.p], -HUGE_VAL);
    bool ok = gen_check(g, run_grid(P, &lsq, &c, corners) == ET_EINVAL, "a parameter in u");
    c = b;
    c.b[j] = gen_upto(g, 1) ? NAN : nextafter(c.v[c.nv], HUGE_VAL);
    ok = ok && gen_check(g, run_grid(P, &lsq, &c, corners) == ET_EINVAL, "a parameter in v");
    c = b;
    c.D[k].z = gen_upto(g, 1) ? NAN : HUGE_VAL;
    ok = ok && gen_check(g, run_grid(P, &lsq, &c, 0) == ET_EINVAL, "a datum");
    for (size_t e = 0; e < 4; e++) {                        /* a corner that is not the data's */
        c = b;
        c.a[0] = c.u[c.p];
        c.a[c.mu - 1] = c.u[c.nu];
        c.b[0] = c.v[c.q];
        c.b[c.mv - 1] = c.v[c.nv];
        double *end = e == 0 ? c.a : e == 1 ? c.a + c.mu - 1 : e == 2 ? c.b : c.b + c.mv - 1;
        *end = nextafter(*end, e % 2 == 0 ? HUGE_VAL : -HUGE_VAL);
        ok = ok && gen_check(g, run_grid(P, &lsq, &c, 1) == ET_EINVAL, "corner %zu", e);
    }
    c = b;
    c.nu = SIZE_MAX - gen_upto(g, 4);
    ok = ok && gen_check(g, run_grid(P, &lsq, &c, corners) == ET_EINVAL, "%zu control points", c.nu);
    c = b;
    c.u[1] = NAN;
    ok = ok && gen_check(g, run_grid(P, &lsq, &c, corners) == ET_EINVAL, "knots in u");
    c = b;
    c.v[1] = NAN;
    ok = ok && gen_check(g, run_grid(P, &lsq, &c, corners) == ET_EINVAL, "knots in v");
    c = b;
    c.mu = 0;
    ok = ok && gen_check(g, run_grid(P, &lsq, &c, corners) == ET_EINVAL, "no data in u");
    c = b;
    c.mv = 0;
    ok = ok && gen_check(g, run_grid(P, &lsq, &c, corners) == ET_EINVAL, "no data in v");
    c = b;
    c.p = 0;
    ok = ok && gen_check(g, run_grid(P, &lsq, &c, corners) == ET_EINVAL, "degree 0");
    c = b;
    c.q = 0;
    ok = ok && gen_check(g, run_grid(P, &lsq, &c, corners) == ET_EINVAL, "degree 0");
    ok = ok && gen_check(g, untouched(P, &lsq), "changed without a solution");
    return ok ? PASS : FAIL;
}

/* ---- scattered points ---- */

/* One case in 20. */
verdict prop_exact_fit_scattered(gen *g)
{
    double u[MOST], v[MOST], a[MOST], b[MOST];
    et_vec3 D[MOST], P[MOST] = {{4711.0, 0.0, 0.0}};
    et_exact_lsq lsq = NOTHING;
    static const bool fixed[MOST] = {false};
    fmpq_mat_t U, V, A;
    size_t p = 1 + (size_t)gen_upto(g, 1), q = 1 + (size_t)gen_upto(g, 1), nu = p + 1 + (size_t)gen_upto(g, 1), nv = q + 1 + (size_t)gen_upto(g, 1);
    size_t n = nu * nv, m = n - 1 + (size_t)gen_upto(g, 4);
    if (!draw_fit_knots(g, u, nu, p) || !draw_fit_knots(g, v, nv, q)) {
        return SKIP;
    }
    draw_parameters(g, a, nu, u, nu, p);
    draw_parameters(g, b, nv, v, nv, q);
    for (size_t k = m; k-- > 0;) {                          /* a grid, and some more */
        a[k] = k < n ? a[k / nv] : gen_parameter(g, u, nu + p + 1, p);
        b[k] = k < n ? b[k % nv] : gen_parameter(g, v, nv + q + 1, q);
    }
    draw_data(g, D, m);
    fmpq_mat_init(U, (slong)m, (slong)nu);
    fmpq_mat_init(V, (slong)m, (slong)nv);
    fmpq_mat_init(A, (slong)m, (slong)n);
    collocation(U, u, p, a);
    collocation(V, v, q, b);
    for (slong k = 0; k < (slong)m; k++) {
        for (slong c = 0; c < (slong)n; c++) {
            fmpq_mul(fmpq_mat_entry(A, k, c), fmpq_mat_entry(U, k, c / (slong)nv), fmpq_mat_entry(V, k, c % (slong)nv));
        }
    }
    bool full = rank_of(A) == (slong)n;
    gen_label(g, full ? "full rank" : "rank deficient");
    live_begin(m + p);
    et_status status = et_exact_fit_scattered(P, nu, nv, &lsq, u, p, v, q, a, b, D, m);
    bool kept = !live_end();
    bool ok = gen_check(g, !kept, "memory is kept") && gen_check(g, status == (full ? ET_OK : ET_ERANK), "status %d", (int)status);
    ok = ok && (full ? same_solution(g, P, &lsq, A, D, fixed, NULL) : gen_check(g, untouched(P, &lsq), "changed without a solution"));
    P[0].x = 4711.0;
    lsq = NOTHING;
    double x = a[m - 1], y = b[m - 1];
    a[m - 1] = nextafter(u[nu], HUGE_VAL);
    ok = ok && gen_check(g, et_exact_fit_scattered(P, nu, nv, &lsq, u, p, v, q, a, b, D, m) == ET_EINVAL, "a parameter in u");
    a[m - 1] = x;
    b[m - 1] = NAN;
    ok = ok && gen_check(g, et_exact_fit_scattered(P, nu, nv, &lsq, u, p, v, q, a, b, D, m) == ET_EINVAL, "a parameter in v");
    b[m - 1] = y;
    ok = ok && gen_check(g, et_exact_fit_scattered(P, nu, nv, &lsq, u, p, v, q, a, b, D, 0) == ET_EINVAL, "no data");
    D[m - 1].x = NAN;
    ok = ok && gen_check(g, et_exact_fit_scattered(P, nu, nv, &lsq, u, p, v, q, a, b, D, m) == ET_EINVAL, "a datum");
    ok = ok && gen_check(g, untouched(P, &lsq), "changed without a solution");
    fmpq_mat_clear(U);
    fmpq_mat_clear(V);
    fmpq_mat_clear(A);
    return ok ? PASS : FAIL;
}
