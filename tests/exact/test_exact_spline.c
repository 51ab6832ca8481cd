/* exact/exact: basis functions and curves: against de Boor's algorithm and Taylor series in rationals, against balls, and the fast functions within the
 * bounds that their headers state. */
#include "exact/splines.h"

/* ---- basis functions ---- */

typedef struct { double u[REF_KNOTS], x; size_t p, nu, span; } problem;

static bool draw_basis(gen *g, problem *b)
{
    b->p = (size_t)gen_upto(g, DEGREE + 1);
    b->nu = 2 * b->p + 2 + (size_t)gen_upto(g, 8);
    ref_draw_knots(g, b->u, b->nu, b->p);
    if (!et_knots_valid(b->u, b->nu, b->p)) {
        return false;
    }
    b->x = gen_parameter(g, b->u, b->nu, b->p);
    if (gen_chance(g, 10)) {
        b->x = gen_upto(g, 1) ? DBL_MAX : -DBL_MAX;
        gen_label(g, "outside");
    }
    b->span = et_knots_span(b->u, b->nu, b->p, b->x);
    gen_note(g, "p = %zu, nu = %zu, x = %a, span %zu", b->p, b->nu, b->x, b->span);
    return true;
}

/* N, the k-th derivative of the r-th function: the spline whose only control value not 0 is its. */
static void unit_spline(fmpq_t N, const problem *b, size_t r, size_t k)
{
    size_t n = b->nu - b->p - 1;
    fmpq *c = _fmpq_vec_init((slong)n);
    fmpq_one(c + b->span - b->p + r);
    deboor(N, c, 1, b->u, b->nu, b->p, b->x, k);
    _fmpq_vec_clear(c, (slong)n);
}

verdict prop_exact_basis_eval(gen *g)
{
    problem b;
    double N[DEGREE + 3], F[DEGREE + 2], work[2 * (DEGREE + 2)];
    fmpq_t q, one, sum;
    if (!draw_basis(g, &b)) {
        return SKIP;
    }
    fmpq_init(q);
    fmpq_init(one);
    fmpq_init(sum);
    fmpq_one(one);
    N[b.p + 1] = 4711.0;
    bool ok = gen_check(g, et_exact_basis_eval(N, b.u, b.nu, b.p, b.span, b.x) == ET_OK && N[b.p + 1] == 4711.0, "status, or wrote beyond N[p]");
    et_basis_eval(F, b.u, b.nu, b.p, b.span, b.x, work, et_basis_work(b.p, 0));
    for (size_t r = 0; ok && r <= b.p; r++) {
        unit_spline(q, &b, r, 0);
        ok = gen_check(g, ref_same(N[r], exact_round(q)) && N[r] >= 0.0 && N[r] <= 1.0, "N[%zu] is %a, by de Boor %a", r, N[r], exact_round(q));
        /* Factors from (1-u)^m to (1-u)^-m: off by at most (1-u)^-m - 1 times the exact value. */
        ok = ok && gen_check(g, within(F[r], one, q, b.p == 0 ? 0 : 6 * b.p - 1, q), "et_basis_eval: N[%zu] is %a for %a", r, F[r], N[r]);
        exact_set(q, F[r]);
        fmpq_add(sum, sum, q);
    }
    ok = ok && gen_check(g, within(1.0, one, sum, b.p == 0 ? 0 : 4 * b.p - 1, one), "et_basis_eval: the sum is %a", exact_round(sum));
    fmpq_clear(q);
    fmpq_clear(one);
    fmpq_clear(sum);
    return ok ? PASS : FAIL;
}

verdict prop_exact_basis_ders(gen *g)
{
    problem b;
    double D[(ORDER + 1) * (DEGREE + 2) + 1], F[(ORDER + 1) * (DEGREE + 2)], N[DEGREE + 2], work[(DEGREE + 2) * (DEGREE + 6)];
    fmpq_t q, one;
    if (!draw_basis(g, &b)) {
        return SKIP;
    }
    size_t d = (size_t)gen_upto(g, ORDER), w = b.p + 1;
    fmpq *M = _fmpq_vec_init((slong)w);
    fmpq_init(q);
    fmpq_init(one);
    fmpq_one(one);
    D[0] = D[(d + 1) * w] = 4711.0;
    bool ok = gen_check(g, et_exact_basis_ders(D, SIZE_MAX, b.u, b.nu, b.p, b.span, b.x) == ET_ENOMEM && D[0] == 4711.0, "an order beyond all sizes");
    ok = ok && gen_check(g, et_exact_basis_ders(D, SIZE_MAX / w, b.u, b.nu, b.p, b.span, b.x) == ET_ENOMEM && D[0] == 4711.0, "a size beyond all");
    live_begin(d + b.p + b.nu);
    et_status status = et_exact_basis_ders(D, d, b.u, b.nu, b.p, b.span, b.x);
    ok = gen_check(g, live_end(), "memory is kept") && ok;
    ok = ok && gen_check(g, status == ET_OK && D[(d + 1) * w] == 4711.0, "status, or wrote beyond");
    et_exact_basis_eval(N, b.u, b.nu, b.p, b.span, b.x);
    ok = ok && gen_check(g, memcmp(N, D, w * sizeof *N) == 0, "row 0 is not that of eval");
    et_basis_ders(F, d, b.u, b.nu, b.p, b.span, b.x, work, et_basis_work(b.p, 1));
    fmpq *E = _fmpq_vec_init((slong)((d + 1) * w));
    for (size_t k = 0; k < (d + 1) * w; k++) {                  /* what stood there before does not matter */
        fmpq_one(E + k);
    }
    exact_basis(E, d, b.u, b.nu, b.p, b.span, b.x);
    for (size_t k = 0; ok && k < (d + 1) * w; k++) {
        ok = gen_check(g, ref_same(exact_round(E + k), D[k]), "number %zu depends on what stood there", k);
    }
    _fmpq_vec_clear(E, (slong)((d + 1) * w));
    for (size_t k = 0; ok && k <= d; k++) {
        magnitudes(M, b.u, b.nu, b.p, b.span, b.x, k);
        for (size_t r = 0; ok && r <= b.p; r++) {
            unit_spline(q, &b, r, k);
            ok = gen_check(g, ref_same(D[k * w + r], exact_round(q)), "derivative %zu of N[%zu]: %a, by de Boor %a", k, r, D[k * w + r],
                           exact_round(q));
            ok = ok && gen_check(g, k <= b.p || D[k * w + r] == 0.0, "derivative %zu of degree %zu", k, b.p);
            ok = ok && gen_check(g, within(F[k * w + r], one, q, 6 * b.p + 2, M + r), "et_basis_ders: derivative %zu of N[%zu]: %a for %a", k, r,
                                 F[k * w + r], D[k * w + r]);
        }
    }
    fmpq_clear(q);
    fmpq_clear(one);
    _fmpq_vec_clear(M, (slong)w);
    return ok ? PASS : FAIL;
}

/* ---- curves ---- */

/* T[4k + a], k <= d: Taylor coefficients at x, of the curve's coordinates (a < 3) and of w. */
static void curve_taylor(fmpq *T, size_t d, const et_curve *c, double x)
{
    fmpq *h = lifted(c->points, c->weights, c->n);
    fmpq_t f;
    fmpq_init(f);
    for (size_t k = 0; k <= d; k++) {
        factorial(f, k);
        for (size_t a = 0; a < 4; a++) {
            deboor(T + 4 * k + a, h + a, 4, c->u, c->n + c->p + 1, c->p, x, k);
            fmpq_div(T + 4 * k + a, T + 4 * k + a, f);
        }
        for (size_t a = 0; a < 3; a++) {       /* the quotient of two series */
            for (size_t i = 1; i <= k; i++) {
                fmpq_submul(T + 4 * k + a, T + 4 * i + 3, T + 4 * (k - i) + a);
            }
            fmpq_div(T + 4 * k + a, T + 4 * k + a, T + 3);
        }
    }
    fmpq_clear(f);
    _fmpq_vec_clear(h, (slong)(4 * c->n));
}

static et_vec3 fast_curve(const et_curve *c, double x)
{
    size_t n = et_curve_work(c, 0);
    double *work = et_size_array(n, sizeof(double));
    et_vec3 C = et_curve_point(c, x, work, n);
    free(work);
    return C;
}

/* sum_i M_i |h_ia|, M the magnitudes of the basis. */
static void curve_size(fmpq_t q, const et_curve *c, const fmpq *h, const fmpq *M, size_t span, size_t a)
{
    fmpq_t t;
    fmpq_init(t);
    fmpq_zero(q);
    for (size_t r = 0; r <= c->p; r++) {
        fmpq_abs(t, h + 4 * (span - c->p + r) + a);
        fmpq_addmul(q, t, M + r);
    }
    fmpq_clear(t);
}

verdict prop_exact_curve_point(gen *g)
{
    et_curve c;
    et_vec3 C = {1.0, 2.0, 3.0}, before = C;
    fmpq_t A, size;
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = gen_parameter(g, c.u, c.n + c.p + 1, c.p);
    size_t span = et_knots_span(c.u, c.n + c.p + 1, c.p, x);
    fmpq *T = _fmpq_vec_init(4), *h = lifted(c.points, c.weights, c.n), *M = _fmpq_vec_init((slong)(c.p + 1));
    fmpq_init(A);
    fmpq_init(size);
    bool ok =
        gen_check(g, et_exact_curve_point(&C, &c, NAN) == ET_EINVAL && et_exact_curve_point(&C, &c, HUGE_VAL) == ET_EINVAL && same_point(C, before),
                  "a parameter that is not finite");
    ok = ok && gen_check(g, et_exact_curve_point(&C, &c, x) == ET_OK, "no point");
    et_vec3 fast = fast_curve(&c, x);
    curve_taylor(T, 0, &c, x);
    magnitudes(M, c.u, c.n + c.p + 1, c.p, span, x, 0);
    for (int a = 0; ok && a < 3; a++) {
        double want = exact_round(T + a);
        ok = gen_check(g, ref_same(coordinate(C, a), want), "%a: coordinate %d is %a, by de Boor %a", x, a, coordinate(C, a), want);
        fmpq_mul(A, T + a, T + 3);
        curve_size(size, &c, h, M, span, (size_t)a);
        ok = ok && gen_check(g, point_within(coordinate(fast, a), T + 3, A, 7 * c.p, size, c.weights != NULL),
                             "et_curve_point: coordinate %d is %a for %a", a, coordinate(fast, a), want);
    }
    c.points[c.n - 1].y = NAN;
    before = C;
    ok = ok && gen_check(g, et_exact_curve_point(&C, &c, x) == ET_EINVAL && same_point(C, before), "a curve that is not valid");
    fmpq_clear(A);
    fmpq_clear(size);
    _fmpq_vec_clear(T, 4);
    _fmpq_vec_clear(M, (slong)(c.p + 1));
    _fmpq_vec_clear(h, (slong)(4 * c.n));
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Control points x or its neighbour y: at 1/2 a curve of degree 1 or 3 is in the middle of the two, a tie; beside it, or at degree 2, it is not. */
verdict prop_exact_curve_point_ties(gen *g)
{
    static const double from[] = {1.0, 0.0, 0x1p-1074, 0x1.fffffffffffffp0, DBL_MIN, 0x1.8p300, 0x1.ffffffffffffep1023, 0x1.0000000000001p-1022};
    et_curve c;
    et_vec3 C;
    uint64_t bits;
    double sign = gen_upto(g, 1) ? -1.0 : 1.0, x = from[gen_upto(g, 7)], y = nextafter(x, HUGE_VAL), side = (double)gen_upto(g, 2) - 1.0;
    size_t p = (size_t)gen_between(g, 1, 3);
    if (et_curve_new(&c, p, p + 1, gen_upto(g, 1) == 1) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= p; i++) {          /* x y; x x y; x x y y */
        c.u[p + 1 + i] = 1.0;
        c.points[i] = (et_vec3){sign * (2 * i < p || (p == 2 && i == 1) ? x : y), sign * x, sign * y};
    }
    memcpy(&bits, &x, sizeof bits);
    double even = bits % 2 == 0 ? x : y, want = p == 2 || side < 0.0 ? x : side > 0.0 ? y : even;
    bool ok = gen_check(g, et_exact_curve_point(&C, &c, 0.5 + side * 0x1p-20) == ET_OK, "no point");
    ok = ok && gen_check(g, C.x == sign * want && C.y == sign * x && C.z == sign * y, "degree %zu, side %g of the middle of %a and its neighbour: %a",
                         p, side, sign * x, C.x);
    ok = ok && gen_check(g, C.x != 0.0 || ref_same(C.x, 0.0), "a zero of the other sign");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Balls by de Boor's algorithm, coordinate a, or w for a = 3. */
static void ball_deboor(arb_t C, const et_curve *c, double x, int a, slong bits)
{
    size_t p = c->p, span = ref_span(c->u, c->n + p + 1, p, x);
    arb_ptr h = _arb_vec_init((slong)(p + 1)), t = _arb_vec_init(4);
    arb_ptr y = t + 1, lo = t + 2, hi = t + 3;
    arb_set_d(y, fmin(fmax(x, c->u[p]), c->u[c->n]));
    for (size_t r = 0; r <= p; r++) {
        arb_set_d(h + r, c->weights ? c->weights[span - p + r] : 1.0);
        arb_set_d(t, a < 3 ? coordinate(c->points[span - p + r], a) : 1.0);
        arb_mul(h + r, h + r, t, bits);
    }
    for (size_t j = 1; j <= p; j++) {
        for (size_t r = p; r >= j; r--) {
            arb_set_d(lo, c->u[span - p + r]);
            arb_set_d(hi, c->u[span + 1 + r - j]);
            arb_sub(t, y, lo, bits);
            arb_mul(h + r, h + r, t, bits);
            arb_sub(t, hi, y, bits);
            arb_addmul(h + r, h + r - 1, t, bits);
            arb_sub(t, hi, lo, bits);
            arb_div(h + r, h + r, t, bits);
        }
    }
    arb_set(C, h + p);
    _arb_vec_clear(h, (slong)(p + 1));
    _arb_vec_clear(t, 4);
}

/* What balls round to at some precision is the result, and at four times that precision still; they fail to round only what is a tie. */
verdict prop_exact_curve_point_balls(gen *g)
{
    et_curve c;
    et_vec3 C;
    arb_t ball, w;
    slong bits = (slong)gen_between(g, 64, 400);
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = gen_parameter(g, c.u, c.n + c.p + 1, c.p), got = 0.0;
    arb_init(ball);
    arb_init(w);
    bool ok = gen_check(g, et_exact_curve_point(&C, &c, x) == ET_OK, "no point"), decided = false;
    for (int a = 0; ok && a < 3; a++) {
        for (int times = 1; ok && times <= 16; times *= 4) {
            ball_deboor(ball, &c, x, a, bits * times);
            ball_deboor(w, &c, x, 3, bits * times);
            arb_div(ball, ball, w, bits * times);
            bool now = exact_round_ball(&got, ball);
            ok = gen_check(g, now || !decided, "decided by fewer bits than %ld", (long)(bits * times));
            ok = ok && (!now || gen_check(g, ref_same(got, coordinate(C, a)), "%ld bits: coordinate %d is %a, not %a", (long)(bits * times), a, got,
                                          coordinate(C, a)));
            decided = now;
        }
        if (!decided) {
            gen_label(g, "undecided");
        }
        decided = false;
    }
    arb_clear(ball);
    arb_clear(w);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Halving a Bezier curve: the control points of both halves are sums of eighths and the like, no roundings; points and derivatives stay. */
verdict prop_exact_curve_ders_halved(gen *g)
{
    et_curve c, t;
    et_vec3 C[ORDER + 1], T[ORDER + 1];
    size_t p = (size_t)gen_between(g, 1, 7), d = (size_t)gen_upto(g, ORDER);
    double x = gen_real(g, 0.0, 1.0), weight = ldexp(1.0, (int)gen_upto(g, 8));
    bool rational = gen_upto(g, 1) == 1;
    if (et_curve_new(&c, p, p + 1, rational) != ET_OK || et_curve_new(&t, p, 2 * p + 1, rational) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= p; i++) {
        c.u[p + 1 + i] = t.u[2 * p + 1 + i] = 1.0;
        c.points[i] = (et_vec3){(double)gen_upto(g, 64) - 32.0, (double)gen_upto(g, 64), (double)(i * i)};
    }
    for (size_t i = 0; i < p; i++) {
        t.u[p + 1 + i] = 0.5;
    }
    et_vec3 h[8];
    memcpy(h, c.points, (p + 1) * sizeof *h);
    for (size_t j = 0; j <= p; j++) {          /* de Casteljau at 1/2 */
        t.points[j] = h[0];
        t.points[2 * p - j] = h[p - j];
        for (size_t i = 0; i + j < p; i++) {
            h[i] = (et_vec3){(h[i].x + h[i + 1].x) / 2.0, (h[i].y + h[i + 1].y) / 2.0, (h[i].z + h[i + 1].z) / 2.0};
        }
    }
    for (size_t i = 0; rational && i <= 2 * p; i++) {
        t.weights[i] = weight;
        c.weights[i <= p ? i : p] = weight;
    }
    bool ok = gen_check(g, et_exact_curve_ders(C, d, &c, x) == ET_OK && et_exact_curve_ders(T, d, &t, x) == ET_OK, "no derivatives");
    for (size_t k = 0; ok && k <= d; k++) {
        ok = gen_check(g, same_point(C[k], T[k]), "derivative %zu at %a: %a, halved %a", k, x, C[k].x, T[k].x);
    }
    /* With x a sixteenth nothing is rounded in the fast one either. */
    if (ok && x * 16.0 == floor(x * 16.0)) {
        gen_label(g, "sixteenths");
        ok = gen_check(g, same_point(fast_curve(&c, x), C[0]), "et_curve_point: %a, not %a", fast_curve(&c, x).x, C[0].x);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Leibniz' rule for the fast derivatives, within the bound that curve.h states: |sum C(k,i) w_i D_(k-i) - A_k| against the terms' magnitudes. */
static bool ders_within(gen *g, const et_curve *c, const et_vec3 *D, const fmpq *T, size_t d, double x)
{
    size_t span = et_knots_span(c->u, c->n + c->p + 1, c->p, x), m = c->weights ? 8 * c->p + 5 : 7 * c->p + 3;
    fmpq *h = lifted(c->points, c->weights, c->n), *M = _fmpq_vec_init((slong)((d + 1) * (c->p + 1))), *s = _fmpq_vec_init(8);
    fmpq *sum = s, *size = s + 1, *f = s + 2, *W = s + 3, *q = s + 4, *one = s + 5, *A = s + 6, *w = s + 7;
    bool ok = true;
    fmpq_one(one);
    for (size_t k = 0; k <= d; k++) {
        magnitudes(M + k * (c->p + 1), c->u, c->n + c->p + 1, c->p, span, x, k);
    }
    for (size_t k = 0; ok && k <= d; k++) {
        for (size_t a = 0; ok && a < 3; a++) {
            fmpq_zero(sum);
            fmpq_zero(A);
            curve_size(size, c, h, M + k * (c->p + 1), span, a);
            for (size_t i = 0; i <= k; i++) {
                /* C(k,i) w_i D_(k-i); A_k / k! is the Cauchy product of the exact series of w and of the curve. */
                double coefficient = 1.0;
                for (size_t j = 0; j < i; j++) {
                    coefficient = coefficient * (double)(k - j) / (double)(j + 1);
                }
                fmpq_addmul(A, T + 4 * i + 3, T + 4 * (k - i) + a);
                factorial(f, i);
                fmpq_mul(w, T + 4 * i + 3, f);
                exact_set(q, coefficient);
                fmpq_mul(w, w, q);
                exact_set(f, coordinate(D[k - i], (int)a));
                fmpq_addmul(sum, w, f);
                if (c->weights) {
                    curve_size(W, c, h, M + i * (c->p + 1), span, 3);
                    fmpq_mul(W, W, q);
                    fmpq_abs(f, f);
                    fmpq_addmul(size, W, f);
                }
            }
            factorial(f, k);
            fmpq_mul(A, A, f);
            fmpq_sub(sum, sum, A);
            fmpq_add(sum, sum, one);           /* within() compares 1 times one with what is off */
            ok = gen_check(g, within(1.0, one, sum, m, size), "et_curve_ders: derivative %zu, coordinate %zu: %a", k, a, coordinate(D[k], (int)a));
        }
    }
    _fmpq_vec_clear(h, (slong)(4 * c->n));
    _fmpq_vec_clear(M, (slong)((d + 1) * (c->p + 1)));
    _fmpq_vec_clear(s, 8);
    return ok;
}

verdict prop_exact_curve_ders(gen *g)
{
    et_curve c;
    et_vec3 P[ORDER + 2], D[ORDER + 2], F[ORDER + 1];
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = gen_parameter(g, c.u, c.n + c.p + 1, c.p);
    size_t d = (size_t)gen_upto(g, ORDER), n = et_curve_work(&c, d);
    fmpq *T = _fmpq_vec_init((slong)(4 * (d + 1)));
    fmpq_t f;
    double *work = et_size_array(n, sizeof(double));
    fmpq_init(f);
    D[d + 1] = D[0] = (et_vec3){1.0, 2.0, 3.0};
    bool ok = gen_check(g, et_exact_curve_ders(D, d, &c, NAN) == ET_EINVAL && same_point(D[0], D[d + 1]), "a parameter that is not finite");
    ok = ok && gen_check(g, et_exact_curve_ders(D, SIZE_MAX, &c, x) == ET_ENOMEM && et_exact_curve_ders(D, SIZE_MAX / 8, &c, x) == ET_ENOMEM &&
                                same_point(D[0], D[d + 1]), "an order beyond all sizes");
    live_begin(d + c.n);
    et_status status = et_exact_curve_ders(D, d, &c, x);
    ok = gen_check(g, live_end(), "memory is kept") && ok;
    ok = ok && gen_check(g, status == ET_OK && same_point(D[d + 1], (et_vec3){1.0, 2.0, 3.0}), "status, or wrote beyond");
    curve_taylor(T, d, &c, x);
    for (size_t k = 0; ok && k <= d; k++) {
        factorial(f, k);
        for (size_t a = 0; ok && a < 3; a++) {
            fmpq *q = T + 4 * k + a;
            fmpq_mul(q, q, f);
            ok = gen_check(g, ref_same(coordinate(D[k], (int)a), exact_round(q)), "derivative %zu, coordinate %zu at %a: %a, by its series %a", k, a,
                           x, coordinate(D[k], (int)a), exact_round(q));
            fmpq_div(q, q, f);
        }
    }
    et_curve_ders(F, d, &c, x, work, n);
    /* Where spans are so short that derivatives come near overflow there is no bound. */
    ok = ok && (!moderate(D, d + 1) || !moderate(F, d + 1) || ders_within(g, &c, F, T, d, x));
    for (size_t i = 0; i < c.n; i++) {                      /* in a plane the others are the same */
        c.points[i].z = 0.0;
    }
    ok = ok && gen_check(g, et_exact_curve_ders(P, d, &c, x) == ET_OK, "no derivatives in a plane");
    for (size_t k = 0; ok && k <= d; k++) {
        ok = gen_check(g, same_point(P[k], (et_vec3){D[k].x, D[k].y, 0.0}), "in a plane derivative %zu is (%a, %a, %a)", k, P[k].x, P[k].y, P[k].z);
    }
    c.u[0] = NAN;
    D[0] = D[d + 1];
    ok = ok && gen_check(g, et_exact_curve_ders(D, d, &c, x) == ET_EINVAL && same_point(D[0], D[d + 1]), "a curve that is not valid");
    free(work);
    fmpq_clear(f);
    _fmpq_vec_clear(T, (slong)(4 * (d + 1)));
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Binomials beyond a word: C(70, 34), order 70 of a degree of 34. */
/* One case in 500. */
verdict prop_exact_curve_ders_high(gen *g)
{
    enum { P = 34, D = 70 };
    et_vec3 S[D + 1], C;
    et_curve c;
    if (et_curve_new(&c, P, P + 1, 1) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= P; i++) {
        c.u[P + 1 + i] = 1.0;
        c.points[i] = (et_vec3){(double)gen_upto(g, 9), (double)i, 1.0};
        c.weights[i] = 1.0 + (double)(i * i % 7);
    }
    live_begin(0);
    et_status status = et_exact_curve_ders(S, D, &c, 0.5);
    bool ok = gen_check(g, live_end(), "memory is kept") && gen_check(g, status == ET_OK, "status %d", (int)status);
    ok = ok && gen_check(g, et_exact_curve_point(&C, &c, 0.5) == ET_OK && same_point(S[0], C) && S[0].z == 1.0, "another point");
    for (size_t k = 1; ok && k <= D; k++) {
        ok = gen_check(g, S[k].z == 0.0, "derivative %zu of a constant: %a", k, S[k].z);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}
