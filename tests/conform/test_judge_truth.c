/* conform/judge: what is right, against the exact layer and by other ways; bounds a second way: by control polygons of magnitudes. */
#include "etalon/base/real.h"
#include "etalon/exact/exact.h"
#include "etalon/spline/basis.h"
#include "judge_kit.h"

/* Two computations of a bound, each a few dozen roundings off. */
static bool close_to(gen *g, double bound, double want, double B, const char *what, size_t at)
{
    const double a = fabs(want);
    const double h = a < 0x1p-1021 ? 0x1p-1074 : (nextafter(a, INFINITY) - a) / 2, sum = B + h;

    if (isinf(bound))
        return gen_check(g, isinf(want) || sum > 0x1.ffp+1023 || isnan(sum), "%s %zu: infinite instead of %a", what, at, sum);
    return gen_check(g, fabs(bound - sum) <= 0x1p-32 * sum + 0x1p-1062, "%s %zu: bound %a, by another way %a", what, at, bound, sum);
}

static double part(et_vec3 P, size_t c)
{
    return c == 0 ? P.x : c == 1 ? P.y : P.z;
}

/* ---- magnitudes: derivatives of the polygon of |c|, differences become sums ---- */

enum { MOST = 1 << 14 };

/* M and S: the sums with the functions and without, of the k-th derivative's polygon of magnitudes c (Eq. 3.8 with plus). */
static void sums(double *M, double *S, const double *c, size_t n, const double *u, size_t p, size_t span, double x, size_t k)
{
    static double d[MOST];
    double N[66], work[140];

    memcpy(d, c, n * sizeof *d);
    *M = *S = 0;
    if (k > p)
        return;
    for (size_t s = 0; s < k; s++)
        for (size_t i = span - p; i + s < span; i++)
            d[i] = (double)(p - s) * (d[i] + d[i + 1]) / (u[i + p + 1] - u[i + s + 1]);
    /* Q_i of order k belongs to N_i+k,p-k; in these knots the functions of the span are i + k = span - (p - k) .. span */
    et_basis_eval(N, u, n + p + 1, p - k, span, x, work, 2 * (p - k + 1));
    for (size_t j = 0; j <= p - k; j++) {
        *M += d[span - p + j] == 0 ? 0 : N[j] * d[span - p + j];
        *S += d[span - p + j];
    }
}

typedef struct { double M, E; } size;

/* The sum of the magnitudes of the basis functions' k-th derivatives: M of coefficients 1. */
static double of_ones(size_t n, const double *u, size_t p, size_t span, double x, size_t k)
{
    static double ones[MOST];
    double M, S;

    for (size_t i = 0; i < n; i++)
        ones[i] = 1;
    sums(&M, &S, ones, n, u, p, span, x, k);
    return M;
}

static size_t span_of(const double *u, size_t nu, size_t p, double x, int left)
{
    return et_knots_span_side(u, nu, p, x, left ? ET_SIDE_LEFT : ET_SIDE_RIGHT);
}

static double longest(const double *u, size_t nu)
{
    return fmax(1, u[nu - 1] - u[0]);
}

static double total(const double *c, size_t first, size_t p)
{
    double sum = 0;

    for (size_t i = first; i <= first + p; i++)
        sum += c[i];
    return sum;
}

static double product(double a, double b)
{
    return a == 0 || b == 0 ? 0 : a * b;
}

static size curve_size(const et_curve *c, const double *magnitudes, double x, int left, size_t k)
{
    const size_t nu = c->n + c->p + 1, span = span_of(c->u, nu, c->p, x, left);
    const double K = 16 * (double)(c->p + k + 2);
    double M, S;

    sums(&M, &S, magnitudes, c->n, c->u, c->p, span, x, k);
    double most = 0;
    for (size_t i = span - c->p; i <= span; i++)
        most = fmax(most, magnitudes[i]);
    return (size){ M, product(K * 0x1p-53 * of_ones(c->n, c->u, c->p, span, x, k), most) + K * 0x1p-1074 * (1 + total(magnitudes, span - c->p, c->p) + product(longest(c->u, nu), S)) };
}

static size surface_size(const et_surface *s, const double *magnitudes, const double x[2], const int left[2], size_t a, size_t b)
{
    static double row[MOST], all[MOST];
    const size_t ku = s->nu + s->p + 1, kv = s->nv + s->q + 1;
    const size_t i = span_of(s->u, ku, s->p, x[0], left[0]), j = span_of(s->v, kv, s->q, x[1], left[1]);
    const double K = 16 * (double)(s->p + s->q + a + b + 2);
    double M, S;

    memset(row, 0, s->nu * sizeof *row);
    memset(all, 0, s->nu * sizeof *all);
    for (size_t k = i - s->p; k <= i; k++) {
        sums(&row[k], &S, magnitudes + k * s->nv, s->nv, s->v, s->q, j, x[1], b);
        all[k] = total(magnitudes + k * s->nv, j - s->q, s->q) + product(longest(s->v, kv), S);
    }
    sums(&M, &S, row, s->nu, s->u, s->p, i, x[0], a);
    double unused, sum, most = 0;
    sums(&unused, &sum, all, s->nu, s->u, s->p, i, x[0], a);
    for (size_t k = i - s->p; k <= i; k++)
        for (size_t l = j - s->q; l <= j; l++)
            most = fmax(most, magnitudes[k * s->nv + l]);
    const double first = of_ones(s->nu, s->u, s->p, i, x[0], a), then = of_ones(s->nv, s->v, s->q, j, x[1], b);
    return (size){ M, product(product(K * 0x1p-53 * first, most), then) + K * 0x1p-1074 * (1 + total(all, i - s->p, s->p) + product(longest(s->u, ku), sum)) };
}

/* ---- bounds of points and derivatives ---- */

typedef struct {
    int curve;
    et_curve c;
    et_surface s;
    double x[2];
    int left[2];
    const et_vec3 *points;
    const double *weights;
    size_t n;
} shape;

/* Component 3 is the weight. */
static size size_of(const shape *f, size_t a, size_t b, size_t component)
{
    static double c[MOST];

    for (size_t i = 0; i < f->n; i++)
        c[i] = (f->weights ? f->weights[i] : 1) * (component == 3 ? 1 : fabs(part(f->points[i], component)));
    return f->curve ? curve_size(&f->c, c, f->x[0], f->left[0], a) : surface_size(&f->s, c, f->x, f->left, a, b);
}

static size_t place(const shape *f, size_t a, size_t b)
{
    return f->curve ? a : (a + b) * (a + b + 1) / 2 + b;
}

static double choose(size_t n, size_t k)
{
    double row[70] = { 1 };

    for (size_t m = 1; m <= n; m++)
        for (size_t i = m; i > 0; i--)
            row[i] += row[i - 1];
    return row[k];
}

/* B of the derivative (a, b), from those of lower order. */
static double bound_of(const shape *f, const et_vec3 *C, const double *B, size_t a, size_t b, size_t c)
{
    const size own = size_of(f, a, b, c);
    const double K = 16 * (double)((f->curve ? f->c.p : f->s.p + f->s.q) + a + b + 2);
    double sum = own.E;

    if (!f->weights)
        return own.E;
    const double w = size_of(f, 0, 0, 3).M;
    for (size_t i = 0; i <= a; i++)
        for (size_t j = 0; j <= b; j++) {
            const size of = size_of(f, i, j, 3);
            const size_t rest = place(f, a - i, b - j);
            sum += choose(a, i) * choose(b, j) * (product(of.E, fabs(part(C[rest], c))) + (i + j > 0 ? product(of.M, B[3 * rest + c]) : 0));
        }
    return sum / w + K * 0x1p-1074;
}

static bool derivatives(gen *g, const shape *f, const double *want, const double *bound, size_t d)
{
    static double B[3 * 2300];
    et_vec3 C[2300];
    bool ok = true;
    const et_side u = f->left[0] ? ET_SIDE_LEFT : ET_SIDE_RIGHT, v = f->left[1] ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
    const et_status status = f->curve ? et_exact_curve_ders_side(C, d, &f->c, f->x[0], u) : et_exact_surface_partials(C, d, &f->s, f->x[0], f->x[1],
            u, v);

    ok = gen_check(g, status == ET_OK, "exact: %s", et_status_text(status));
    for (size_t o = 0; ok && o <= d; o++)
        for (size_t b = 0; ok && b <= (f->curve ? 0 : o); b++)
            for (size_t c = 0; ok && c < 3; c++) {
                const size_t at = place(f, o - b, b);
                B[3 * at + c] = bound_of(f, C, B, o - b, b, c);
                ok = gen_check(g, want[3 * at + c] == part(C[at], c), "want %zu: %a, exactly %a", 3 * at + c, want[3 * at + c], part(C[at], c));
                ok = ok && close_to(g, bound[3 * at + c], want[3 * at + c], B[3 * at + c], "number", 3 * at + c);
            }
    return ok;
}

/* A request for points and its shape; word: where its sides stand. */
static bool shape_of(shape *f, const et_request *r)
{
    memset(f, 0, sizeof *f);
    f->curve = r->op == ET_OP_CURVE_POINT || r->op == ET_OP_CURVE_DERS;
    if (f->curve ? et_request_curve(&f->c, r, 0) != ET_OK : et_request_surface(&f->s, r, 0) != ET_OK)
        return false;
    f->points = f->curve ? f->c.points : f->s.points;
    f->weights = f->curve ? f->c.weights : f->s.weights;
    f->n = f->curve ? f->c.n : f->s.nu * f->s.nv;
    f->x[0] = r->arg[f->curve ? 4 : 6].x[0];
    f->x[1] = f->curve ? 0 : r->arg[7].x[0];
    return f->n < MOST;
}

static bool points_judged(gen *g, const et_request *r, const et_truth *t)
{
    const size_t word = r->op == ET_OP_CURVE_POINT || r->op == ET_OP_CURVE_DERS ? 5 : 8;
    const size_t d = r->op == ET_OP_CURVE_DERS ? r->arg[6].count : r->op == ET_OP_SURFACE_DERS ? r->arg[10].count : 0;
    shape f;

    if (!shape_of(&f, r) || d > 8)
        return true;
    for (size_t k = 0; k < (f.curve ? 1 : 2); k++)
        f.left[k] = r->arg[word + k].count == 2;
    bool ok = derivatives(g, &f, t->want, t->bound, d);
    for (size_t k = 0; k < (f.curve ? 1 : 2); k++)
        f.left[k] = r->arg[word + k].count != 1;
    if (t->other)
        return ok && gen_check(g, memcmp(t->want, t->other, t->count * sizeof *t->want) != 0, "the same twice") && derivatives(g, &f, t->other,
                t->other_bound, d);
    /* no other limit: then it is the same */
    double *const same = calloc(t->count, sizeof *same);
    et_vec3 C[46];
    const et_side u = f.left[0] ? ET_SIDE_LEFT : ET_SIDE_RIGHT, v = f.left[1] ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
    ok = ok && (f.curve ? et_exact_curve_ders_side(C, d, &f.c, f.x[0], u) : et_exact_surface_partials(C, d, &f.s, f.x[0], f.x[1], u, v)) == ET_OK;
    for (size_t i = 0; ok && i < t->count; i++)
        ok = gen_check(g, t->want[i] == part(C[i / 3], i % 3), "another limit, number %zu", i);
    free(same);
    return ok;
}

/* A request of one of the operations that has a truth; 0 if not. */
static int known(gen *g, et_request *r, et_truth *t, et_request_op op)
{
    if (!kit_draw(g, r, op, ET_CATEGORY_BAD_INPUT))
        return -1;
    const et_status status = et_judge_truth(t, r);
    if (status == ET_OK && t->count > 0)
        return 1;
    if (status == ET_OK)
        et_judge_free(t);
    et_request_free(r);
    return gen_check(g, status == ET_OK || status == ET_ENOCONV, "%s", et_status_text(status)) ? 0 : -1;
}

static verdict end(et_request *r, et_truth *t, bool ok)
{
    et_judge_free(t);
    et_request_free(r);
    return ok ? PASS : FAIL;
}

/* One case in 2. */
verdict prop_judge_truth_points(gen *g)
{
    static const et_request_op ops[] = { ET_OP_CURVE_POINT, ET_OP_CURVE_DERS, ET_OP_SURFACE_POINT, ET_OP_SURFACE_DERS };
    et_request r;
    et_truth t;
    const int is = known(g, &r, &t, ops[gen_upto(g, 3)]);

    return is < 0 ? FAIL : is == 0 ? SKIP : end(&r, &t, points_judged(g, &r, &t));
}

/* Function i of degree p is the curve whose control points are 0 and, the i-th, 1. */
/* One case in 2. */
verdict prop_judge_truth_basis(gen *g)
{
    static double unit[MOST];
    static et_vec3 P[MOST];
    et_request r;
    et_truth t;
    const int is = known(g, &r, &t, gen_chance(g, 2) ? ET_OP_BASIS : ET_OP_BASIS_DERS);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    const size_t p = r.arg[0].count, n = r.arg[1].count - p - 1, d = r.op == ET_OP_BASIS ? 0 : r.arg[4].count, i = gen_upto(g, n - 1);
    const et_curve c = { p, n, r.arg[1].x, P, NULL };
    et_vec3 C[65];
    bool ok = gen_check(g, t.count == (d + 1) * n && d <= 64, "%zu numbers", t.count);
    memset(unit, 0, n * sizeof *unit);
    memset(P, 0, n * sizeof *P);
    unit[i] = P[i].x = 1;
    for (int left = 0; ok && left < 2; left++) {
        const double *want = r.arg[3].count == (left ? 1 : 2) ? NULL : left && t.other ? t.other : t.want;
        const double *bound = left && t.other ? t.other_bound : t.bound;
        if (!want)
            continue;
        ok = et_exact_curve_ders_side(C, d, &c, r.arg[2].x[0], left ? ET_SIDE_LEFT : ET_SIDE_RIGHT) == ET_OK;
        for (size_t k = 0; ok && k <= d; k++) {
            const double K = 16 * (double)(p + k + 2);
            size of = curve_size(&c, unit, r.arg[2].x[0], left, k);
            const bool on = i + p >= span_of(c.u, n + p + 1, p, r.arg[2].x[0], left) && i <= span_of(c.u, n + p + 1, p, r.arg[2].x[0], left);
            ok = gen_check(g, want[k * n + i] == C[k].x, "N_%zu, derivative %zu", i, k)
                && ((left && !t.other && r.arg[3].count == 0) || close_to(g, bound[k * n + i], C[k].x, on ? of.E : K * 0x1p-1073, "derivative", k));
        }
    }
    return end(&r, &t, ok);
}

/* ---- edited ---- */

static et_reply put(const et_curve *c, const et_surface *s, size_t removed, bool removal)
{
    et_reply reply = { ET_REPLY_OK, 0, NULL, "" };
    const double t = (double)removed;

    if ((removal && et_reply_put(&reply, &t, 1) != ET_OK) || (c ? et_reply_put_curve(&reply, c) : et_reply_put_surface(&reply, s)) != ET_OK)
        abort();
    return reply;
}

/* The points' magnitudes, with the weights if there are. */
static void magnitudes(et_vec3 *P, const et_vec3 *Q, const double *w, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const double v = w ? w[i] : 1;
        P[i] = (et_vec3){ v * fabs(Q[i].x), v * fabs(Q[i].y), v * fabs(Q[i].z) };
    }
}

/* Each of the n numbers of a line, `step` apart, becomes the greatest of its neighbours' up to p places away: p times the greatest of three. */
static void widen(et_vec3 *P, size_t n, size_t step, size_t p)
{
    for (size_t k = 0; k < p; k++) {
        et_vec3 before = P[0];
        for (size_t i = 0; i < n; i++) {
            const et_vec3 here = P[i * step], after = P[(i + 1 < n ? i + 1 : i) * step];
            P[i * step] = (et_vec3){ fmax(fmax(before.x, here.x), after.x), fmax(fmax(before.y, here.y), after.y), fmax(fmax(before.z, here.z), after.z) };
            before = here;
        }
    }
}

/* want is the answer put; R the sums of magnitudes, n of them behind the head of `head` numbers; W those of the weights. */
static bool edited(gen *g, const et_truth *t, const et_reply *want, size_t head, const et_vec3 *R, const et_vec3 *W, size_t n, const double *w, double K)
{
    bool ok = gen_check(g, t->count == want->count, "%zu numbers, not %zu", t->count, want->count);

    for (size_t i = 0; ok && i < t->count; i++)
        ok = gen_check(g, t->want[i] == want->x[i], "number %zu is %a, not %a", i, t->want[i], want->x[i]);
    for (size_t i = 0; ok && i < t->count; i++)
        if (i < head || i == head + 3 * n) {
            ok = gen_check(g, t->bound[i] == 0, "number %zu has to be equal", i);
        } else if (i < head + 3 * n) {
            double B = K * 0x1p-53 * part(R[(i - head) / 3], (i - head) % 3) + K * 0x1p-1074;
            const double v = w ? w[(i - head) / 3] : 1;
            if (w)
                B = (B + product(fabs(t->want[i]), K * 0x1p-53 * W[(i - head) / 3].x + K * 0x1p-1074)) / v + K * 0x1p-1074;
            ok = close_to(g, t->bound[i], t->want[i], B, "number", i);
        } else {
            ok = close_to(g, t->bound[i], t->want[i], 2 * K * 0x1p-53 * W[i - head - 3 * n - 1].x + 2 * K * 0x1p-1074, "weight", i);
        }
    return ok;
}

static bool curve_edited(gen *g, const et_request *r, const et_truth *t)
{
    static et_vec3 P[MOST], Q[MOST];
    et_curve c, made, sizes, heavy, of = { 0 };
    bool ok = et_request_curve(&c, r, 0) == ET_OK && c.n < MOST;
    const et_request_value *a = r->arg + 4;
    const bool inserts = r->op == ET_OP_CURVE_INSERT;
    const size_t times = inserts ? a[1].count : a[0].count;

    if (!ok)
        return true;
    magnitudes(P, c.points, c.weights, c.n);
    for (size_t i = 0; i < c.n; i++)
        Q[i].x = c.weights ? c.weights[i] : 1;
    widen(P, c.n, 1, c.p);
    widen(Q, c.n, 1, c.p);
    of = c;
    of.points = P;
    of.weights = NULL;
    if (!et_curve_valid(&of))
        return true;
    ok = (inserts ? et_exact_curve_insert(&made, &c, a[0].x[0], times) : et_exact_curve_elevate(&made, &c, times)) == ET_OK
         && (inserts ? et_curve_insert(&sizes, &of, a[0].x[0], times) : et_curve_elevate(&sizes, &of, times)) == ET_OK;
    of.points = Q;
    ok = ok && (inserts ? et_curve_insert(&heavy, &of, a[0].x[0], times) : et_curve_elevate(&heavy, &of, times)) == ET_OK;
    if (!gen_check(g, ok, "not edited"))
        return false;
    et_reply want = put(&made, NULL, 0, false);
    ok = edited(g, t, &want, 2 + made.n + made.p + 1 + 1, sizes.points, heavy.points, made.n, made.weights, 16 * (double)(c.p + times + 1));
    et_reply_free(&want);
    et_curve_free(&made);
    et_curve_free(&sizes);
    et_curve_free(&heavy);
    return ok;
}

static bool surface_edited(gen *g, const et_request *r, const et_truth *t)
{
    static et_vec3 P[MOST], Q[MOST];
    et_surface s, made, sizes, heavy, of;
    const et_request_value *a = r->arg + 7;
    const bool inserts = r->op == ET_OP_SURFACE_INSERT;
    const et_direction along = r->arg[6].count ? ET_ALONG_V : ET_ALONG_U;
    const size_t times = inserts ? a[1].count : a[0].count;

    if (et_request_surface(&s, r, 0) != ET_OK || s.nu * s.nv >= MOST)
        return true;
    magnitudes(P, s.points, s.weights, s.nu * s.nv);
    for (size_t i = 0; i < s.nu * s.nv; i++)
        Q[i].x = s.weights ? s.weights[i] : 1;
    for (size_t i = 0; i < (along == ET_ALONG_U ? s.nv : s.nu); i++)
        for (int heavier = 0; heavier < 2; heavier++)
            widen((heavier ? Q : P) + (along == ET_ALONG_U ? i : i * s.nv), along == ET_ALONG_U ? s.nu : s.nv, along == ET_ALONG_U ? s.nv : 1,
                  along == ET_ALONG_U ? s.p : s.q);
    of = s;
    of.points = P;
    of.weights = NULL;
    if (!et_surface_valid(&of))
        return true;
    bool ok = (inserts ? et_exact_surface_insert(&made, &s, along, a[0].x[0], times) : et_exact_surface_elevate(&made, &s, along, times)) == ET_OK
              && (inserts ? et_surface_insert(&sizes, &of, along, a[0].x[0], times) : et_surface_elevate(&sizes, &of, along, times)) == ET_OK;
    of.points = Q;
    ok = ok && (inserts ? et_surface_insert(&heavy, &of, along, a[0].x[0], times) : et_surface_elevate(&heavy, &of, along, times)) == ET_OK;
    if (!gen_check(g, ok, "not edited"))
        return false;
    et_reply want = put(NULL, &made, 0, false);
    ok = edited(g, t, &want, 4 + made.nu + made.p + 1 + made.nv + made.q + 1 + 1, sizes.points, heavy.points, made.nu * made.nv, made.weights,
                16 * (double)((along == ET_ALONG_U ? s.p : s.q) + times + 1));
    et_reply_free(&want);
    et_surface_free(&made);
    et_surface_free(&sizes);
    et_surface_free(&heavy);
    return ok;
}

/* One case in 3. */
verdict prop_judge_truth_edits(gen *g)
{
    static const et_request_op ops[] = { ET_OP_CURVE_INSERT, ET_OP_CURVE_ELEVATE, ET_OP_SURFACE_INSERT, ET_OP_SURFACE_ELEVATE };
    et_request r;
    et_truth t;
    const size_t k = gen_upto(g, 3);
    const int is = known(g, &r, &t, ops[k]);

    return is < 0 ? FAIL : is == 0 ? SKIP : end(&r, &t, k < 2 ? curve_edited(g, &r, &t) : surface_edited(g, &r, &t));
}

/* One case in 3. */
verdict prop_judge_truth_removal(gen *g)
{
    et_request r;
    et_truth t;
    et_curve c, made;
    size_t removed, at = 0;
    double most = 0, heaviest = 0;
    const int is = known(g, &r, &t, ET_OP_CURVE_REMOVE);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    bool ok = et_request_curve(&c, &r, 0) == ET_OK && et_exact_curve_remove(&made, &removed, &c, r.arg[4].x[0], r.arg[5].count) == ET_OK;
    if (!gen_check(g, ok, "not removed"))
        return end(&r, &t, false);
    et_reply want = put(&made, NULL, removed, true);
    for (size_t i = 0; i < c.n; i++) {
        most = fmax(most, fmax(fabs(c.points[i].x), fmax(fabs(c.points[i].y), fabs(c.points[i].z))));
        heaviest = fmax(heaviest, c.weights ? c.weights[i] : 0);
    }
    const double K = 16 * (double)(c.p + r.arg[5].count + 1);
    ok = gen_check(g, t.count == want.count, "%zu numbers, not %zu", t.count, want.count);
    for (const size_t head = 3 + made.n + made.p + 1 + 1; ok && at < t.count; at++) {
        ok = gen_check(g, t.want[at] == want.x[at], "number %zu", at);
        if (at < head || at == head + 3 * made.n)
            ok = ok && gen_check(g, t.bound[at] == 0, "number %zu has to be equal", at);
        else
            ok = ok && close_to(g, t.bound[at], t.want[at], at < head + 3 * made.n
                    ? r.arg[6].x[0] + K * 0x1p-53 * most : 2 * K * 0x1p-53 * heaviest + 2 * K * 0x1p-1074,
                                "number", at);
    }
    et_reply_free(&want);
    et_curve_free(&made);
    return end(&r, &t, ok);
}

/* ---- parameters, knots, Greville points ---- */

static bool all_close(gen *g, const et_truth *t, const double *want, size_t n, double B)
{
    bool ok = gen_check(g, t->count == n, "%zu numbers, not %zu", t->count, n);

    for (size_t i = 0; ok && i < n; i++)
        ok = gen_check(g, t->want[i] == want[i], "number %zu is %a, not %a", i, t->want[i], want[i]) && close_to(g, t->bound[i], want[i], B,
                "number", i);
    return ok;
}

static bool knots_judged(gen *g, const et_request *r, const et_truth *t)
{
    static const et_knotrule_kind kinds[] = { ET_KNOTRULE_PIEGL, ET_KNOTRULE_AVERAGING, ET_KNOTRULE_FAITHFUL, ET_KNOTRULE_UNIFORM };
    const size_t p = r->arg[1].count, n = r->arg[2].count, nu = n + p + 1;
    double *u = calloc(nu, sizeof *u);
    bool ok = gen_check(g, et_exact_knotrule_make(u, nu, p, r->arg[3].x, r->arg[3].count, kinds[r->arg[0].count]) == ET_OK && t->count == nu,
            "knots");

    for (size_t i = 0; ok && i < nu; i++) {
        ok = gen_check(g, t->want[i] == u[i], "knot %zu", i);
        if (i <= p || i >= n)
            ok = ok && gen_check(g, t->bound[i] == 0 && u[i] == (i <= p ? 0 : 1), "end knot %zu", i);
        else
            ok = ok && close_to(g, t->bound[i], u[i], 4 * (double)(p + 2) * 0x1p-53, "knot", i);
    }
    free(u);
    return ok;
}

verdict prop_judge_truth_parameters(gen *g)
{
    static const et_request_op ops[] = { ET_OP_GREVILLE, ET_OP_PARAMETERS, ET_OP_PARAMETERS_GRID, ET_OP_KNOTS };
    static double want[MOST];
    et_request r;
    et_truth t;
    size_t flat;
    int line;
    const int is = known(g, &r, &t, ops[gen_upto(g, 3)]);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    bool ok = true;
    if (r.op == ET_OP_KNOTS) {
        ok = knots_judged(g, &r, &t);
    } else if (r.op == ET_OP_PARAMETERS && r.arg[1].count < MOST) {
        const size_t n = r.arg[1].count;
        ok = et_exact_param_row(want, n, &line, (const et_vec3 *)r.arg[1].x, 1, (et_param_method)r.arg[0].count, NULL) == ET_OK
             && all_close(g, &t, want, n, 4 * (double)(n + 8) * (0x1p-53 + 0x1p-1074));
    } else if (r.op == ET_OP_PARAMETERS_GRID && r.arg[1].count + r.arg[2].count < MOST) {
        const size_t nx = r.arg[1].count, ny = r.arg[2].count;
        ok = et_exact_param_grid(want, nx, want + nx, ny, &flat, (const et_vec3 *)r.arg[3].x, (et_param_method)r.arg[0].count, NULL) == ET_OK
             && all_close(g, &t, want, nx + ny, 4 * (double)(nx + ny + 8) * (0x1p-53 + 0x1p-1074));
    } else if (r.op == ET_OP_GREVILLE && r.arg[1].count < MOST) {
        const size_t p = r.arg[0].count, n = r.arg[1].count - p - 1;
        ok = et_exact_knots_greville(want, n, r.arg[1].x, r.arg[1].count, p) == ET_OK && t.count == n;
        for (size_t i = 0; ok && i < n; i++) {
            double most = 0;
            for (size_t k = i + 1; k <= i + p; k++)
                most = fmax(most, fabs(r.arg[1].x[k]));
            ok = gen_check(g, t.want[i] == want[i], "%zu", i) && close_to(g, t.bound[i], want[i], 4 * (double)(p + 2) * 0x1p-53 * most,
                    "Greville point", i);
        }
    }
    return end(&r, &t, ok);
}

/* ---- fits ---- */

/* One case in 20. */
verdict prop_judge_truth_fits(gen *g)
{
    static et_vec3 P[MOST];
    et_exact_lsq q;
    et_request r;
    et_truth t;
    const int is = known(g, &r, &t, (et_request_op)(ET_OP_FIT_CURVE + gen_upto(g, 2)));

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    const et_request_value *a = r.arg + (r.op == ET_OP_FIT_GRID);
    const size_t p = a[0].count, nu = a[r.op == ET_OP_FIT_CURVE ? 1 : 2].count - p - 1, nv = r.op == ET_OP_FIT_CURVE
            ? 1 : a[3].count - a[1].count - 1;
    const size_t m = a[r.op == ET_OP_FIT_CURVE ? 2 : 4].count, n = nu * nv;
    double k = 16 * (double)(n > m ? n : m), N = (double)n;
    bool ok = n < MOST;
    if (ok && r.op == ET_OP_FIT_CURVE)
        ok = et_exact_fit_curve(P, nu, &q, a[1].x, a[1].count, p, a[2].x, (const et_vec3 *)a[3].x, m) == ET_OK;
    else if (ok && r.op == ET_OP_FIT_SCATTERED)
        ok = et_exact_fit_scattered(P, nu, nv, &q, a[2].x, p, a[3].x, a[1].count, a[4].x, a[5].x, (const et_vec3 *)a[6].x, m) == ET_OK;
    else if (ok) {
        const size_t mv = a[5].count;
        ok = et_exact_fit_grid(P, nu, nv, &q, a[2].x, p, a[3].x, a[1].count, a[4].x, m, a[5].x, mv, (const et_vec3 *)a[6].x,
                r.arg[0].count != 0) == ET_OK;
        k = 16 * (double)((nu > m ? nu : m) + (nv > mv ? nv : mv));
        N = (double)(nu > nv ? nu : nv);
    }
    ok = gen_check(g, ok && t.count == 3 * n, "not fitted") && gen_check(g,
            (N * k * 0x1p-53 * q.condition >= 1) <= (t.validity == ET_IMPLEMENTATION_DEFINED), "condition %a", q.condition);
    for (size_t i = 0; ok && i < 3 * n; i++) {
        const double K = q.condition;
        ok = gen_check(g, t.want[i] == part(P[i / 3], i % 3), "number %zu", i)
            && close_to(g, t.bound[i], t.want[i], k * 0x1p-53 * (K * part(q.solution, i % 3) + K * K * part(q.residual,
                    i % 3) / q.norm) + k * 0x1p-1074 * (1 + K * K),
                        "number", i);
    }
    return end(&r, &t, ok);
}

/* ---- distances ---- */

/* The surface of magnitudes: its points are the sums M (A) / M (w). */
static bool surface_error_judged(gen *g, const et_request *r, const et_truth *t)
{
    static et_vec3 P[MOST];
    et_surface s;
    const et_request_value *a = r->arg;
    double sum, greatest, M = 0, most = 0;
    bool ok = et_request_surface(&s, r, 0) == ET_OK && s.nu * s.nv < MOST;

    if (!ok)
        return true;
    ok = et_exact_surface_error(&sum, &greatest, &s, a[6].x, a[6].count, a[7].x, a[7].count, (const et_vec3 *)a[8].x) == ET_OK;
    ok = gen_check(g, ok && t->count == 2 && t->want[0] == sum && t->want[1] == greatest, "distances");
    magnitudes(P, s.points, NULL, s.nu * s.nv);
    s.points = P;
    for (size_t k = 0; ok && k < a[8].count; k++) {
        et_vec3 S;
        const double *D = a[8].x + 3 * k;
        ok = et_exact_surface_point(&S, &s, a[6].x[k / a[7].count], a[7].x[k % a[7].count]) == ET_OK;
        const double here = S.x + S.y + S.z + fabs(D[0]) + fabs(D[1]) + fabs(D[2]);
        M += here;
        most = fmax(most, here);
    }
    const double K = 16 * (double)(s.p + s.q + 2) + (double)a[8].count;
    return gen_check(g, ok, "points") && close_to(g, t->bound[0], sum, K * 0x1p-53 * M + K * 0x1p-1074, "sum", 0)
        && close_to(g, t->bound[1], greatest, K * 0x1p-53 * most + K * 0x1p-1074, "greatest", 1);
}

static double diagonal(const et_vec3 *P, size_t n, double *most)
{
    double d[3];

    *most = 0;
    for (size_t c = 0; c < 3; c++) {
        double lo = INFINITY, hi = -INFINITY;
        for (size_t i = 0; i < n; i++) {
            lo = fmin(lo, part(P[i], c));
            hi = fmax(hi, part(P[i], c));
            *most = fmax(*most, fabs(part(P[i], c)));
        }
        d[c] = hi - lo;
    }
    return et_exact_vec3_distance((et_vec3){ 0, 0, 0 }, (et_vec3){ d[0], d[1], d[2] });
}

static bool nearest_judged(gen *g, const et_request *r, const et_truth *t)
{
    et_curve c;
    double x, distance, lower, most;
    bool ok = et_request_curve(&c, r, 0) == ET_OK && et_exact_curve_nearest(&x, &distance, &lower, &c, *(const et_vec3 *)r->arg[4].x) == ET_OK;

    ok = gen_check(g, ok && t->count == 2 && t->want[0] == x && isinf(t->bound[0]), "parameter");
    ok = ok && gen_check(g, t->want[1] <= distance && t->want[1] >= distance * (1 - 0x1p-30) - 0x1p-1070, "distance %a, not %a", t->want[1],
            distance);
    const double e = diagonal(c.points, c.n, &most), K = 64 * (double)(c.p + 2);
    return ok && close_to(g, t->bound[1], t->want[1], K * 0x1p-53 * (most + t->want[1]) + e * sqrt(0x1p-53), "distance", 1);
}

/* One case in 3. */
verdict prop_judge_truth_distances(gen *g)
{
    et_request r;
    et_truth t;
    const int is = known(g, &r, &t, gen_chance(g, 2) ? ET_OP_CURVE_NEAREST : ET_OP_SURFACE_ERROR);

    return is < 0 ? FAIL : is == 0 ? SKIP : end(&r, &t, r.op == ET_OP_SURFACE_ERROR ? surface_error_judged(g, &r, &t) : nearest_judged(g, &r, &t));
}

/* A border of a clamped surface is the curve of its outer control points. */
static et_curve border(const et_surface *s, int v, int end_of, et_vec3 *P, double *w)
{
    const size_t n = v ? s->nv : s->nu;

    for (size_t i = 0; i < n; i++) {
        const size_t at = v ? (end_of ? s->nu - 1 : 0) * s->nv + i : i * s->nv + (end_of ? s->nv - 1 : 0);
        P[i] = s->points[at];
        if (s->weights)
            w[i] = s->weights[at];
    }
    return (et_curve){ v ? s->q : s->p, n, v ? s->v : s->u, P, s->weights ? w : NULL };
}

/* V and V' of one sample of a border. */
static void sample_sizes(double *V, double *W, const et_curve *c, double x)
{
    const shape f = { 1, *c, { 0 }, { x, 0 }, { 0, 0 }, c->points, c->weights, c->n };
    const double w = size_of(&f, 0, 0, 3).M, w1 = size_of(&f, 1, 0, 3).M;

    for (size_t k = 0; k < 3; k++) {
        const double A = size_of(&f, 0, 0, k).M, A1 = size_of(&f, 1, 0, k).M;
        *V += A / w;
        *W += A1 / w + (c->weights ? w1 / w * (A / w) : 0);
    }
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* One case in 20. */
verdict prop_judge_truth_seam(gen *g)
{
    static et_vec3 P[MOST], Q[MOST];
    static double w[MOST], z[MOST], knots[2 * MOST];
    et_request r;
    et_truth t;
    et_shell shell;
    et_seam gap;
    double most = 0;
    const int is = known(g, &r, &t, ET_OP_SEAM_GAP);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    bool ok = et_request_surface(&shell.view[0], &r, 0) == ET_OK && et_request_surface(&shell.view[1], &r, 6) == ET_OK;
    const size_t samples = r.arg[12].count;
    ok = gen_check(g, ok && et_exact_seam_gap(&gap, &shell, samples) == ET_OK && t.count == 1 && t.want[0] == gap.distance, "gap");
    const double K = 16 * (double)(shell.view[0].p + shell.view[0].q + 2) + 1;
    for (int k = 0; ok && k < 4; k++) {
        const et_curve a = border(&shell.view[0], k & 1, k >> 1, P, w), b = border(&shell.view[1], k & 1, k >> 1, Q, z);
        const size_t n = a.n + a.p + 1;
        memcpy(knots, a.u, n * sizeof *knots);
        memcpy(knots + n, b.u, n * sizeof *knots);
        qsort(knots, 2 * n, sizeof *knots, ascending);
        for (size_t i = 0; i < 2 * n; i++)
            for (size_t j = 0; j <= samples; j++) {
                const double next = i + 1 < 2 * n ? knots[i + 1] : knots[i], x = knots[i] + (next - knots[i]) * ((double)j / (double)(samples + 1));
                double V = 0, W = 0;
                if (next == knots[i] && (j > 0 || i + 1 < 2 * n))
                    continue;
                sample_sizes(&V, &W, &a, x);
                sample_sizes(&V, &W, &b, x);
                most = fmax(most, K * 0x1p-53 * V + 0x1p-51 * W);
            }
    }
    return end(&r, &t, ok && close_to(g, t.bound[0], t.want[0], most + K * 0x1p-1074, "gap", 0));
}

/* The normal of a surface that lies in a plane through the origin, and its bound, by the formula with vectors. */
static bool normal_judged(gen *g, const et_request *r, const double *want, const double *bound, const int left[2])
{
    static double B[9];
    shape f;
    et_vec3 C[3];
    const size_t K0 = r->arg[0].count + r->arg[1].count;
    const double K = 16 * (double)(K0 + 4);

    if (!shape_of(&f, r))
        return true;
    f.left[0] = left[0];
    f.left[1] = left[1];
    bool ok = et_exact_surface_partials(C, 1, &f.s, f.x[0], f.x[1], left[0] ? ET_SIDE_LEFT : ET_SIDE_RIGHT, left[1]
            ? ET_SIDE_LEFT : ET_SIDE_RIGHT) == ET_OK;
    for (size_t k = 0; k < 9; k++)
        B[k] = bound_of(&f, C, B, k / 3 == 1, k / 3 == 2, k % 3);
    double e[3], along = 0;
    long double cross[3], l = 0;
    for (size_t x = 0; x < 3; x++) {
        const size_t y = (x + 1) % 3, z = (x + 2) % 3;
        const double ay = part(C[1], y), az = part(C[1], z), by = part(C[2], y), bz = part(C[2], z);
        if (fabs(ay) > 1e150 || fabs(az) > 1e150 || fabs(by) > 1e150 || fabs(bz) > 1e150)
            return ok;
        cross[x] = (long double)ay * bz - (long double)az * by;
        l += cross[x] * cross[x];
        e[x] = fabs(ay) * B[6 + z] + B[3 + y] * fabs(bz) + fabs(az) * B[6 + y] + B[3 + z] * fabs(by)
             + K * 0x1p-53 * (fabs(ay * bz) + fabs(az * by)) + K * 0x1p-1074;
        along += fabs(want[x]) * e[x];
    }
    const double length = (double)sqrtl(l);
    /* the extended product of two doubles has lost some digits where much cancels */
    if (!(length > 0x1p-20 * (fabs(part(C[1], 0)) + fabs(part(C[1], 1)) + fabs(part(C[1], 2))) * (fabs(part(C[2], 0)) + fabs(part(C[2],
            1)) + fabs(part(C[2], 2)))) || length < 1e-140)
        return ok;
    for (size_t x = 0; ok && x < 3; x++) {
        ok = gen_check(g, fabs(want[x] - (double)(cross[x] / length)) < 1e-9, "%zu: %a", x, want[x]);
        ok = ok && close_to(g, bound[x], want[x], (e[x] + fabs(want[x]) * along) / length + K * 0x1p-53 * fabs(want[x]) + K * 0x1p-1074, "normal", x);
    }
    return ok;
}

/* One case in 2. */
verdict prop_judge_truth_normal(gen *g)
{
    et_request r;
    et_truth t;
    static const int right[2] = { 0, 0 }, left[2] = { 1, 1 };
    const int is = known(g, &r, &t, ET_OP_SURFACE_NORMAL);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    bool ok = gen_check(g, t.count == 3, "count") && normal_judged(g, &r, t.want, t.bound, right);
    ok = ok && (!t.other || normal_judged(g, &r, t.other, t.other_bound, left));
    return end(&r, &t, ok);
}

/* ---- all ---- */

/* One case in 3. */
verdict prop_judge_truth(gen *g)
{
    const et_request_op op = kit_op(g);
    et_request r;
    et_truth t, again;
    char reason[128];

    if (!kit_draw(g, &r, op, ET_CATEGORIES))
        return FAIL;
    const et_validity validity = et_judge_validity(reason, &r);
    bool ok = gen_check(g, et_judge_truth(&t, &r) == ET_OK, "truth");
    if (!ok) {
        et_request_free(&r);
        return FAIL;
    }
    ok = gen_check(g, t.validity >= validity, "%s, by its arguments %s", et_judge_validity_name(t.validity), et_judge_validity_name(validity))
        && gen_check(g, (t.validity == ET_INVALID) == (validity == ET_INVALID), "invalid or not") && gen_check(g,
                (t.validity == ET_VALID) == (t.reason[0] == '\0'), "%s", t.reason)
        && gen_check(g, t.validity != ET_INVALID || (t.count == 0 && !t.other), "invalid, and an answer") && gen_check(g, t.condition >= 1,
                "condition %a", t.condition)
        && gen_check(g, t.validity != ET_VALID || op == ET_OP_APPROXIMATE ? true : t.count > 0 || t.validity != ET_VALID, "valid, no answer");
    for (size_t i = 0; ok && i < t.count; i++) {
        ok = gen_check(g, t.bound[i] >= 0 && !isnan(t.want[i]), "bound %zu", i);
        if (t.validity == ET_VALID && op != ET_OP_CURVE_NEAREST)
            ok = ok && gen_check(g, isfinite(t.want[i]) && isfinite(t.bound[i]), "valid, number %zu is %a, bound %a", i, t.want[i], t.bound[i]);
    }
    ok = ok && gen_check(g, et_judge_truth(&again, &r) == ET_OK, "again");
    if (ok) {
        ok = gen_check(g, t.count == again.count && t.condition == again.condition && (t.other != NULL) == (again.other != NULL)
                              && (t.count == 0 || (memcmp(t.want, again.want, t.count * sizeof *t.want) == 0 && memcmp(t.bound, again.bound,
                                      t.count * sizeof *t.bound) == 0)),
                       "another truth");
        et_judge_free(&again);
    }
    return end(&r, &t, ok);
}

static const char *const counted[][2] = {
    { "span 2 7 0 0 0 0x1p-1 1 1 1 0x1p-1", "3" }, { "span 2 7 0 0 0 0x1p-1 1 1 1 0x1p-2", "2" }, { "span 2 7 0 0 0 0x1p-1 1 1 1 1", "3" },
    { "multiplicity 5 0 -0 0 1 1 -0", "3" }, { "multiplicity 2 0 1 0x1p-1", "0" }, { "net_counts 3 4", "24 14 10" }, { "net_class 3 4 0 2 3", "12" },
    { "net_class 3 4 1 1 2", "14" }, { "net_class 3 4 1 0 2", "3" }, { "net_node 3 4 13", "1 1 1" }, { "net_node 3 4 6", "0 1 1" },
      { "net_node 3 4 12", "0 2 3" },
};

verdict prop_judge_truth_counts(gen *g)
{
    const size_t k = gen_upto(g, sizeof counted / sizeof *counted - 1);
    et_request r = kit_parse(counted[k][0]);
    et_truth t;
    const char *at = counted[k][1];
    bool ok = gen_check(g, et_judge_truth(&t, &r) == ET_OK && t.count > 0, "%s", counted[k][0]);

    for (size_t i = 0; ok && i < t.count; i++) {
        char *rest;
        ok = gen_check(g, t.want[i] == strtod(at, &rest) && t.bound[i] == 0 && rest > at, "%s: %g", counted[k][0], t.want[i]);
        at = rest;
    }
    ok = ok && gen_check(g, *at == '\0', "%s: more", counted[k][0]);
    return end(&r, &t, ok);
}

/* Degree 0 has right values where it is allowed, and where it is not forbidden. */
static const struct { const char *line; et_validity validity; double want[4]; size_t n; } constant[] = {
    { "basis 0 3 0 0x1p-1 1 0x1p-1 right", ET_VALID, { 0, 1 }, 2 },
    { "basis_ders 0 3 0 0x1p-1 1 0x1p-1 left 1", ET_IMPLEMENTATION_DEFINED, { 1, 0, 0, 0 }, 4 },
    { "curve_point 0 3 0 0x1p-1 1 2 1 2 3 4 5 6 0 0x1p-1 left", ET_VALID, { 1, 2, 3 }, 3 },
    { "curve_ders 0 3 0 0x1p-1 1 2 1 2 3 4 5 6 0 0x1p-1 right 0", ET_IMPLEMENTATION_DEFINED, { 4, 5, 6 }, 3 },
    { "surface_point 0 0 2 0 1 2 0 1 1 7 8 9 1 2 0x1p-1 0x1p-1 any any", ET_VALID, { 7, 8, 9 }, 3 },
    { "surface_error 0 0 2 0 1 2 0 1 1 0 0 0 0 1 0x1p-1 1 0x1p-1 1 3 4 0", ET_IMPLEMENTATION_DEFINED, { 5, 5 }, 2 },
};

verdict prop_judge_truth_constant(gen *g)
{
    const size_t k = gen_upto(g, sizeof constant / sizeof *constant - 1);
    et_request r = kit_parse(constant[k].line);
    et_truth t = { 0 };
    bool ok = gen_check(g, et_judge_truth(&t, &r) == ET_OK && t.validity == constant[k].validity && t.count == constant[k].n, "%s: %zu numbers",
            constant[k].line, t.count);

    for (size_t i = 0; ok && i < t.count; i++)
        ok = gen_check(g, t.want[i] == constant[k].want[i] && t.bound[i] < 1e-10, "%s: %g", constant[k].line, t.want[i]);
    return end(&r, &t, ok);
}
