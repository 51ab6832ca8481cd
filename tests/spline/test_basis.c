/* spline/basis: against Cox and de Boor's definition, against GSL, and within the machine-checked bounds. */
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include "golden.h"
#include "reference.h"
#include <gsl/gsl_bspline.h>
#include <stdint.h>

enum { DERIVATIVES = 5, WORK = (REF_DEGREE + 1) * (REF_DEGREE + 5) };

/* Products of parameters' differences underflow where values are below this; relative bounds hold above it only. */
static const double tiny = 0x1p-1000;

typedef struct { double u[REF_KNOTS], x; size_t p, nu, span; } problem;

static bool draw(gen *g, problem *b)
{
    b->p = (size_t)gen_upto(g, REF_DEGREE);
    b->nu = 2 * b->p + 2 + (size_t)gen_upto(g, 12);
    ref_draw_knots(g, b->u, b->nu, b->p);
    if (!et_knots_valid(b->u, b->nu, b->p)) {
        return false;
    }
    b->x = gen_parameter(g, b->u, b->nu, b->p);
    b->span = et_knots_span(b->u, b->nu, b->p, b->x);
    gen_note(g, "p = %zu, nu = %zu, x = %a, span %zu", b->p, b->nu, b->x, b->span);
    return true;
}

static void eval(double *N, const problem *b)
{
    double work[2 * (REF_DEGREE + 1)];
    et_basis_eval(N, b->u, b->nu, b->p, b->span, b->x, work, et_basis_work(b->p, 0));
}

verdict prop_basis_work(gen *g)
{
    size_t p = (size_t)gen_upto(g, 1000), d = (size_t)gen_upto(g, 3);
    size_t want = d == 0 ? 2 * (p + 1) : (p + 1) * (p + 5), huge = SIZE_MAX - (size_t)gen_upto(g, 10), root = (size_t)1 << (4 * sizeof(size_t));
    bool ok = gen_check(g, et_basis_work(p, d) == want, "p = %zu, d = %zu: %zu", p, d, et_basis_work(p, d));
    ok = ok && gen_check(g, et_basis_work(huge, d) == SIZE_MAX && et_basis_work(root, 1) == SIZE_MAX, "a degree beyond all sizes");
    return ok ? PASS : FAIL;
}

/* Nothing is written but N[0..p] and the stated workspace: guards stand behind both. */
verdict prop_basis_eval_room(gen *g)
{
    problem b;
    double N[REF_DEGREE + 2], D[(DERIVATIVES + 1) * (REF_DEGREE + 1) + 1], work[WORK + 1];
    if (!draw(g, &b)) {
        return SKIP;
    }
    size_t d = (size_t)gen_upto(g, DERIVATIVES), nwork = et_basis_work(b.p, 0), nders = et_basis_work(b.p, 1);
    N[b.p + 1] = work[nwork] = 4711.0;
    et_basis_eval(N, b.u, b.nu, b.p, b.span, b.x, work, nwork);
    bool ok = gen_check(g, N[b.p + 1] == 4711.0 && work[nwork] == 4711.0, "eval wrote beyond its room");
    D[(d + 1) * (b.p + 1)] = work[nders] = 4711.0;
    et_basis_ders(D, d, b.u, b.nu, b.p, b.span, b.x, work, nders);
    ok = ok && gen_check(g, D[(d + 1) * (b.p + 1)] == 4711.0 && work[nders] == 4711.0, "ders wrote beyond its room");
    return ok ? PASS : FAIL;
}

verdict prop_basis_eval(gen *g)
{
    problem b;
    double N[REF_DEGREE + 1], R[REF_KNOTS];
    if (!draw(g, &b)) {
        return SKIP;
    }
    eval(N, &b);
    ref_basis(R, b.u, b.nu, b.p, b.x);
    bool ok = true;
    for (size_t i = 0; ok && i + b.p + 1 < b.nu; i++) {
        double n = i + b.p >= b.span && i <= b.span ? N[i + b.p - b.span] : 0.0;
        /* Ours 6p - 1 roundings, the definition's 5p. */
        double bound = 11.0 * (double)b.p * ET_UNIT * (1.0 + 0x1p-40) * R[i] + tiny;
        ok = gen_check(g, n >= 0.0 && fabs(n - R[i]) <= bound, "N_%zu is %a, by the definition %a", i, n, R[i]);
    }
    return ok ? PASS : FAIL;
}

/* The exact sum of the computed values lies within 4p - 1 roundings of 1; it is formed here with its rounding errors. */
verdict prop_basis_eval_unity(gen *g)
{
    problem b;
    double N[REF_DEGREE + 1], sum = 0.0, rest = 0.0;
    if (!draw(g, &b)) {
        return SKIP;
    }
    eval(N, &b);
    for (size_t r = 0; r <= b.p; r++) {
        double t = sum + N[r], v = t - sum;
        rest += (sum - (t - v)) + (N[r] - v);
        sum = t;
    }
    double bound = b.p == 0 ? 0.0 : (4.0 * (double)b.p - 1.0) * ET_UNIT * (1.0 + 0x1p-40);
    return gen_check(g, fabs((sum - 1.0) + rest) <= bound, "the sum is off by %g u of %g", ((sum - 1.0) + rest) / ET_UNIT, bound / ET_UNIT) ? PASS : FAIL;
}

/* Exactly one function at a knot of multiplicity p or more, both ends of clamped knots among them; clamping of x. */
verdict prop_basis_eval_ends(gen *g)
{
    problem b, c;
    double N[REF_DEGREE + 1], M[REF_DEGREE + 1];
    if (!draw(g, &b)) {
        return SKIP;
    }
    c = b;
    double lo = b.u[b.p], hi = b.u[b.nu - b.p - 1];
    bool right = gen_upto(g, 1) == 1, clamped = et_knots_clamped(b.u, b.nu, b.p) == 1, ok = true;
    b.x = right ? hi : lo;
    c.x = right ? hi + (hi - lo) : lo - (hi - lo);
    b.span = et_knots_span(b.u, b.nu, b.p, b.x);
    c.span = et_knots_span(c.u, c.nu, c.p, c.x);
    eval(N, &b);
    eval(M, &c);
    for (size_t r = 0; ok && r <= b.p; r++) {
        ok = gen_check(g, ref_same(N[r], M[r]) && b.span == c.span, "outside the domain another value, N[%zu]", r);
        ok = ok && gen_check(g, !clamped || N[r] == (r == (right ? b.p : 0) ? 1.0 : 0.0), "N[%zu] = %a at an end", r, N[r]);
    }
    for (size_t k = 0; k + 1 < b.nu && b.p > 0; k++) {      /* an inner knot repeated p times */
        if (k < b.p || k + b.p + 2 > b.nu || !(b.u[k] < b.u[k + 1]) || b.u[k + 1 - b.p] != b.u[k]) {
            continue;
        }
        b.x = b.u[k];
        b.span = k;
        eval(N, &b);
        for (size_t r = 0; ok && r <= b.p; r++) {
            ok = gen_check(g, N[r] == (r == 0 ? 1.0 : 0.0), "N[%zu] = %a at the knot %zu", r, N[r], k);
        }
    }
    return ok ? PASS : FAIL;
}

/* GSL evaluates the same functions (its own code); both within 6p - 1 roundings. */
verdict prop_basis_eval_gsl(gen *g)
{
    problem b;
    double N[REF_DEGREE + 1];
    size_t start = 0, end = 0;
    if (!draw(g, &b)) {
        return SKIP;
    }
    for (size_t i = 0; i <= b.p; i++) {       /* GSL wants clamped knots */
        b.u[i] = b.u[b.p];
        b.u[b.nu - 1 - i] = b.u[b.nu - b.p - 1];
    }
    for (size_t i = b.p + 1; i < b.nu - b.p - 1; i++) {      /* and knots repeated at most p + 1 times */
        if (b.u[i] == b.u[0] || b.u[i] == b.u[b.nu - 1] || (i > 2 * b.p + 1 && b.u[i] == b.u[i - b.p - 1])) {
            return SKIP;
        }
    }
    b.span = et_knots_span(b.u, b.nu, b.p, b.x);
    eval(N, &b);
    gsl_bspline_workspace *w = gsl_bspline_alloc(b.p + 1, b.nu - 2 * b.p);
    gsl_vector *B = gsl_vector_alloc(b.p + 1);
    memcpy(w->knots->data, b.u, b.nu * sizeof *b.u);
    int status = gsl_bspline_eval_nonzero(b.x, B, &start, &end, w);
    bool ok = gen_check(g, status == 0 && start + b.p == b.span && end == b.span, "GSL's functions %zu to %zu, status %d", start, end, status);
    for (size_t r = 0; ok && r <= b.p; r++) {
        double want = gsl_vector_get(B, r);
        ok = gen_check(g, fabs(N[r] - want) <= 12.0 * (double)b.p * ET_UNIT * want + tiny, "N[%zu] = %a, GSL's %a", r, N[r], want);
    }
    gsl_vector_free(B);
    gsl_bspline_free(w);
    return ok ? PASS : FAIL;
}

verdict prop_basis_ders(gen *g)
{
    problem b;
    double D[(DERIVATIVES + 1) * (REF_DEGREE + 1)], work[WORK], N[REF_DEGREE + 1], R[REF_KNOTS], M[REF_KNOTS];
    if (!draw(g, &b)) {
        return SKIP;
    }
    size_t d = (size_t)gen_upto(g, DERIVATIVES), w = b.p + 1;
    et_basis_ders(D, d, b.u, b.nu, b.p, b.span, b.x, work, et_basis_work(b.p, d > 0 ? d : 1));
    eval(N, &b);
    bool ok = true;
    for (size_t r = 0; ok && r <= b.p; r++) {
        ok = gen_check(g, ref_same(D[r], N[r]), "row 0, function %zu: %a, %a by eval", r, D[r], N[r]);
    }
    for (size_t k = 1; ok && k <= d; k++) {
        ref_derivative(R, M, b.u, b.nu, b.p, b.x, k);
        for (size_t r = 0; ok && r <= b.p; r++) {
            double want = R[b.span - b.p + r], size = M[b.span - b.p + r];
            /* Ours 6p + 2 roundings, Eq. 2.7's 5p at most; scales of 2^100 and spans of 2^-60 keep clear of 2^-500. */
            double bound = (11.0 * (double)b.p + 3.0) * ET_UNIT * size + 0x1p-500;
            ok = gen_check(g, fabs(D[k * w + r] - want) <= bound, "derivative %zu of function %zu: %a for %a, within %g", k, r, D[k * w + r], want, bound);
            ok = ok && gen_check(g, k <= b.p || D[k * w + r] == 0.0, "derivative %zu of degree %zu", k, b.p);
        }
    }
    return ok ? PASS : FAIL;
}

verdict gold_basis_work(const row *r)
{
    return row_is_size(r, 0, et_basis_work(row_size(r, 0), row_size(r, 1))) ? PASS : FAIL;
}

enum { GOLD_DEGREE = 25, GOLD_WORK = (GOLD_DEGREE + 1) * (GOLD_DEGREE + 5) };

/* degree, order, number of knots, knots, parameter; wanted: the rows of D up to the order, or with `only` the last of them. */
static bool read_problem(const row *r, problem *b)
{
    b->p = row_size(r, 0);
    b->nu = row_size(r, 2);
    if (b->p > GOLD_DEGREE || b->nu > REF_KNOTS) {
        return false;
    }
    for (size_t i = 0; i < b->nu; i++) {
        b->u[i] = row_real(r, 3 + i);
    }
    b->x = row_real(r, 3 + b->nu);
    b->span = et_knots_span(b->u, b->nu, b->p, b->x);
    return et_knots_valid(b->u, b->nu, b->p) == 1;
}

verdict gold_basis_eval(const row *r)
{
    problem b;
    double N[GOLD_DEGREE + 1], work[GOLD_WORK];
    if (!read_problem(r, &b)) {
        return FAIL;
    }
    et_basis_eval(N, b.u, b.nu, b.p, b.span, b.x, work, et_basis_work(b.p, 0));
    for (size_t i = 0; i <= b.p; i++) {
        if (!row_is(r, i, N[i])) {
            return FAIL;
        }
    }
    return PASS;
}

verdict gold_basis_ders(const row *r)
{
    problem b;
    double D[(DERIVATIVES + 1) * (GOLD_DEGREE + 1)], work[GOLD_WORK];
    size_t d = row_size(r, 1);
    if (!read_problem(r, &b) || d > DERIVATIVES) {
        return FAIL;
    }
    et_basis_ders(D, d, b.u, b.nu, b.p, b.span, b.x, work, et_basis_work(b.p, d));
    for (size_t i = 0; i <= b.p; i++) {
        if (!row_is(r, i, D[d * (b.p + 1) + i])) {
            return FAIL;
        }
    }
    return PASS;
}
