#include "etalon/fit/enclosure.h"
#include "fit/enclosure_parts.h"
#include "gen.h"
#include "golden.h"
#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 5, NODES = SIDE * SIDE, CLASSES = 2 * NODES, OUT = (int)CLASSES };

/* ---- rationals ---- */

/* q = x, exactly. */
static void set(fmpq_t q, double x)
{
    int e = 0;
    const double m = ldexp(frexp(x, &e), 53);

    fmpz_set_si(fmpq_numref(q), (slong)m);
    fmpz_one(fmpq_denref(q));
    if (e >= 53)
        fmpq_mul_2exp(q, q, (flint_bitcnt_t)(e - 53));
    else
        fmpq_div_2exp(q, q, (flint_bitcnt_t)(53 - e));
}

/* a - b as doubles, exactly. */
static void difference(fmpq_t q, double a, double b)
{
    fmpq_t c;

    fmpq_init(c);
    set(q, a);
    set(c, b);
    fmpq_sub(q, q, c);
    fmpq_clear(c);
}

/* Whether |q| <= bound; not for a NaN. */
static bool within(const fmpq_t q, double bound)
{
    fmpq_t a, b;
    bool ok;

    if (isinf(bound))
        return bound > 0;
    if (isnan(bound))
        return false;
    fmpq_init(a);
    fmpq_init(b);
    fmpq_abs(a, q);
    set(b, bound);
    ok = fmpq_cmp(a, b) <= 0;
    fmpq_clear(a);
    fmpq_clear(b);
    return ok;
}

/* A double within an ulp or so. */
static double about(const fmpq_t q)
{
    fmpz_t n;
    double m;
    slong bits;

    if (fmpq_is_zero(q))
        return 0;
    fmpz_init(n);
    bits = (slong)fmpz_bits(fmpq_denref(q)) - (slong)fmpz_bits(fmpq_numref(q)) + 60;
    if (bits >= 0) {
        fmpz_mul_2exp(n, fmpq_numref(q), (ulong)bits);
        fmpz_tdiv_q(n, n, fmpq_denref(q));
    } else {
        fmpz_mul_2exp(n, fmpq_denref(q), (ulong)-bits);
        fmpz_tdiv_q(n, fmpq_numref(q), n);
    }
    m = fmpz_get_d(n);
    fmpz_clear(n);
    return ldexp(m, (int)-bits);
}

/* How far q is inside the reals that round to P: negative when it is not.  In rationals, since half an ulp may be no double. */
static void margin(fmpq_t m, double P, const fmpq_t q)
{
    fmpq_t above, below, x;
    const double hi = nextafter(P, HUGE_VAL), lo = nextafter(P, -HUGE_VAL);

    fmpq_init(above);
    fmpq_init(below);
    fmpq_init(x);
    set(x, P);
    difference(above, isinf(hi) ? P : hi, isinf(hi) ? lo : P);
    difference(below, isinf(lo) ? hi : P, isinf(lo) ? P : lo);
    fmpq_div_2exp(above, above, 1);
    fmpq_div_2exp(below, below, 1);
    fmpq_sub(x, q, x);
    fmpq_sub(above, above, x);
    fmpq_add(below, below, x);
    fmpq_set(m, fmpq_cmp(above, below) < 0 ? above : below);
    fmpq_clear(above);
    fmpq_clear(below);
    fmpq_clear(x);
}

/* ---- the exact least-squares solution by its definition: normal equations in rationals, all unknowns at once ---- */

typedef struct {
    et_doublenet net;
    size_t nov;
    et_vec3 data[CLASSES];
    et_fit_options options;
} problem;

static int inside(et_doublenet n, size_t i, size_t j)
{
    return i > 0 && j > 0 && i + 1 < n.nx && j + 1 < n.ny;
}

static int corner_node(et_doublenet n, size_t i, size_t j)
{
    return (i == 0 || i + 1 == n.nx) && (j == 0 || j + 1 == n.ny);
}

static int corners_fixed(const et_fit_options *o)
{
    return o->corners == ET_CORNERS_INTERPOLATED || (o->corners == ET_CORNERS_DEFAULT && o->approach == ET_FIT_IMPROVED);
}

static const et_vec3 *corner_data(const problem *c, size_t i, size_t j)
{
    return &c->data[(i ? (c->net.nx - 1) * c->net.ny : 0) + (j ? c->net.ny - 1 : 0)];
}

/* Cox and de Boor, 0/0 = 0, the last non-empty span closed. */
static void deboor(fmpq_t N, const double *u, size_t i, size_t p, double x, double end)
{
    fmpq_t a, b, lower;

    if (p == 0) {
        fmpq_set_si(N, (u[i] <= x && x < u[i + 1]) || (x == end && u[i] < end && u[i + 1] == end), 1);
        return;
    }
    fmpq_init(a);
    fmpq_init(b);
    fmpq_init(lower);
    fmpq_zero(N);
    if (u[i + p] > u[i]) {
        deboor(lower, u, i, p - 1, x, end);
        difference(a, x, u[i]);
        difference(b, u[i + p], u[i]);
        fmpq_div(a, a, b);
        fmpq_addmul(N, a, lower);
    }
    if (u[i + p + 1] > u[i + 1]) {
        deboor(lower, u, i + 1, p - 1, x, end);
        difference(a, u[i + p + 1], x);
        difference(b, u[i + p + 1], u[i + 1]);
        fmpq_div(a, a, b);
        fmpq_addmul(N, a, lower);
    }
    fmpq_clear(a);
    fmpq_clear(b);
    fmpq_clear(lower);
}

static void collocate(fmpq_mat_t N, const double *t, const double *u, size_t p)
{
    for (slong i = 0; i < fmpq_mat_nrows(N); i++)
        for (slong j = 0; j < fmpq_mat_ncols(N); j++)
            deboor(fmpq_mat_entry(N, i, j), u, (size_t)j, p, t[i], 1);
}

/* number[w][a*cy + b] of the unknowns of views first .. first + views - 1, OUT for fixed ones; returns their count. */
static size_t count_unknowns(size_t number[2][NODES], const problem *c, size_t views, int fixed)
{
    const et_doublenet k = c->options.control;
    size_t count = 0;

    for (size_t w = 0; w < views; w++)
        for (size_t a = 0; a < k.nx; a++)
            for (size_t b = 0; b < k.ny; b++) {
                const size_t at = a * k.ny + b;
                if (fixed && corner_node(k, a, b))
                    number[w][at] = OUT;
                else
                    number[w][at] = w == 1 && !inside(k, a, b) ? number[0][at] : count++;
            }
    return count;
}

/* G = N'N and H = N'd for the views. */
static void assemble(fmpq_mat_t G, fmpq_mat_t H, size_t number[2][NODES], const problem *c, const et_fit *f, size_t first, size_t views)
{
    const et_doublenet n = c->net, k = c->options.control;
    const et_surface *v = &f->shell.view[first];
    fmpq_mat_t U, V;
    fmpq *line = _fmpq_vec_init((slong)CLASSES), *rhs = _fmpq_vec_init(3);
    fmpq_t x, e;

    fmpq_mat_init(U, (slong)n.nx, (slong)k.nx);
    fmpq_mat_init(V, (slong)n.ny, (slong)k.ny);
    fmpq_init(x);
    fmpq_init(e);
    collocate(U, f->s[first], v->u, v->p);
    collocate(V, f->r[first], v->v, v->q);
    for (size_t w = 0; w < views; w++)
        for (size_t at = 0; at < n.nx * n.ny; at++) {
            const size_t i = at / n.ny, j = at % n.ny;
            const et_vec3 *d = &c->data[et_doublenet_class(n, first + w, i, j) - 1];
            if (w == 1 && !inside(n, i, j))
                continue;
            for (slong s = 0; s < CLASSES; s++)
                fmpq_zero(line + s);
            for (size_t m = 0; m < 3; m++)
                set(rhs + m, (&d->x)[m]);
            for (size_t a = 0; a < k.nx; a++)
                for (size_t b = 0; b < k.ny; b++) {
                    fmpq_mul(x, fmpq_mat_entry(U, (slong)i, (slong)a), fmpq_mat_entry(V, (slong)j, (slong)b));
                    if (number[w][a * k.ny + b] < OUT)
                        fmpq_add(line + number[w][a * k.ny + b], line + number[w][a * k.ny + b], x);
                    for (size_t m = 0; number[w][a * k.ny + b] == OUT && m < 3; m++) {
                        set(e, (&corner_data(c, a, b)->x)[m]);
                        fmpq_submul(rhs + m, e, x);
                    }
                }
            for (slong s = 0; s < fmpq_mat_nrows(G); s++) {
                if (fmpq_is_zero(line + s))
                    continue;
                for (slong t = 0; t < fmpq_mat_nrows(G); t++)
                    if (!fmpq_is_zero(line + t))
                        fmpq_addmul(fmpq_mat_entry(G, s, t), line + s, line + t);
                for (slong m = 0; m < 3; m++)
                    fmpq_addmul(fmpq_mat_entry(H, s, m), line + s, rhs + m);
            }
        }
    fmpq_mat_clear(U);
    fmpq_mat_clear(V);
    fmpq_clear(x);
    fmpq_clear(e);
    _fmpq_vec_clear(line, (slong)CLASSES);
    _fmpq_vec_clear(rhs, 3);
}

/* The greatest row sum of |A|. */
static double row_sum(const fmpq_mat_t A)
{
    double most = 0;

    for (slong i = 0; i < fmpq_mat_nrows(A); i++) {
        double sum = 0;
        for (slong j = 0; j < fmpq_mat_ncols(A); j++)
            sum += fabs(about(fmpq_mat_entry(A, i, j)));
        most = fmax(most, sum);
    }
    return most;
}

typedef struct {
    fmpq *P[2];       /* [3*(a*cy + b) + coordinate] */
    bool full;        /* the solution is unique */
    double norm;      /* at most the matrix's (where its entries are small, data weigh more) */
    double square;    /* at least the square of the 2-norm condition number, at most n times it (of its worst part); wanted only if asked for */
} exact;

/* Of the views first ..; false if the solution is not unique. */
static bool solve_views(exact *x, const problem *c, const et_fit *f, size_t first, size_t views, int fixed, bool condition)
{
    static size_t number[2][NODES];
    const et_doublenet k = c->options.control;
    const slong n = (slong)count_unknowns(number, c, views, fixed);
    fmpq_mat_t G, H, X;
    bool full;

    fmpq_mat_init(G, n, n);
    fmpq_mat_init(H, n, 3);
    fmpq_mat_init(X, n, 3);
    assemble(G, H, number, c, f, first, views);
    full = n == 0 || fmpq_mat_solve(X, G, H) != 0;
    if (n > 0)
        x->norm = fmin(x->norm, sqrt(row_sum(G) / (double)n));
    if (full && condition && n > 0) {
        fmpq_mat_t V;
        fmpq_mat_init(V, n, n);
        fmpq_mat_inv(V, G);
        x->square = fmax(x->square, row_sum(G) * row_sum(V));
        fmpq_mat_clear(V);
    }
    for (size_t w = 0; full && w < views; w++)
        for (size_t at = 0; at < k.nx * k.ny; at++)
            for (size_t m = 0; m < 3; m++) {
                if (number[w][at] == OUT)
                    set(x->P[first + w] + 3 * at + m, (&corner_data(c, at / k.ny, at % k.ny)->x)[m]);
                else
                    fmpq_set(x->P[first + w] + 3 * at + m, fmpq_mat_entry(X, (slong)number[w][at], (slong)m));
            }
    fmpq_mat_clear(G);
    fmpq_mat_clear(H);
    fmpq_mat_clear(X);
    return full;
}

/* Means along the border, and the data's corners. */
static void close_border(exact *x, const problem *c)
{
    const et_doublenet k = c->options.control;

    for (size_t at = 0; at < k.nx * k.ny; at++)
        for (size_t m = 0; m < 3 && !inside(k, at / k.ny, at % k.ny); m++) {
            fmpq *a = x->P[0] + 3 * at + m, *b = x->P[1] + 3 * at + m;
            fmpq_add(a, a, b);
            fmpq_div_2exp(a, a, 1);
            if (corner_node(k, at / k.ny, at % k.ny) && corners_fixed(&c->options))
                set(a, (&corner_data(c, at / k.ny, at % k.ny)->x)[m]);
            fmpq_set(b, a);
        }
}

static void solve_exactly(exact *x, const problem *c, const et_fit *f, bool condition)
{
    const et_fit_options *o = &c->options;
    const int fixed = corners_fixed(o) && o->approach != ET_FIT_IMPROVED;

    x->P[0] = _fmpq_vec_init(3 * NODES);
    x->P[1] = _fmpq_vec_init(3 * NODES);
    x->square = x->norm = 1;
    if (o->approach == ET_FIT_JOINT) {
        x->full = solve_views(x, c, f, 0, 2, fixed, condition);
        return;
    }
    x->full = solve_views(x, c, f, 0, 1, fixed, condition) && solve_views(x, c, f, 1, 1, fixed, condition);
    if (o->approach == ET_FIT_IMPROVED && x->full)
        close_border(x, c);
}

static void exact_clear(exact *x)
{
    _fmpq_vec_clear(x->P[0], 3 * NODES);
    _fmpq_vec_clear(x->P[1], 3 * NODES);
}

/* ---- cases ---- */

static void draw_options(gen *g, problem *c, size_t side)
{
    et_fit_options *o = &c->options;

    c->net = (et_doublenet){gen_between(g, 2, side), gen_between(g, 2, side)};
    c->nov = et_doublenet_nov(c->net);
    *o = et_fit_defaults();
    o->control = (et_doublenet){gen_between(g, 2, c->net.nx), gen_between(g, 2, c->net.ny)};
    o->p = gen_between(g, 1, o->control.nx - 1);
    o->q = gen_between(g, 1, o->control.ny - 1);
    o->approach = (et_fit_approach)gen_upto(g, 2);
    o->corners = (et_fit_corners)gen_upto(g, 2);
    o->method = (et_param_method)gen_upto(g, 3);
    o->knots = (et_knotrule_kind)gen_upto(g, 2);
    o->algebra = (et_linalg_method)gen_upto(g, 2);
}

/* Points of sixteenths or of all bits, of any scale; sometimes a coordinate is zero throughout. */
static void draw_data(gen *g, problem *c)
{
    const size_t kind = gen_upto(g, 3);
    static const int exponents[] = {0, 0, 0, 0, 400, -400, 1010, -1040};
    const int e = exponents[gen_upto(g, 7)];
    const size_t zero = gen_upto(g, 8);

    if (kind == 3)
        gen_points(g, &c->data[0].x, c->nov);
    for (size_t i = 0; i < c->nov; i++) {
        const et_index k = et_doublenet_index(c->net, i + 1);
        const double at[3] = {(double)k.i, (double)k.j, (double)k.k};
        double *d = &c->data[i].x;
        for (size_t m = 0; m < 3; m++) {
            if (kind < 2)
                d[m] = at[m] + (double)gen_upto(g, 7) / 16;
            else if (kind == 2)
                d[m] = at[m] + gen_real(g, -1, 1);
            if (m == zero)
                d[m] = 0;
            if (kind < 3)
                d[m] = ldexp(d[m], e);
        }
    }
}

/* Parameters and knots as the options ask for them (of points that have no scale), in a shell of zeros. */
static bool frame_of(et_fit *f, const problem *c)
{
    const et_fit_options *o = &c->options;
    et_vec3 plain[CLASSES];
    bool ok;

    for (size_t i = 0; i < c->nov; i++)
        for (size_t m = 0; m < 3; m++) {
            int e = 0;
            (&plain[i].x)[m] = frexp((&c->data[i].x)[m], &e) + (double)(e % 7);
        }
    ok = et_fit_parameters(f, plain, c->nov, c->net, o->approach, o->method) == ET_OK;
    ok = ok && et_shell_new(&f->shell, o->p, o->q, o->control, 0) == ET_OK;
    for (size_t w = 0; ok && w < 2; w++) {
        et_surface *v = &f->shell.view[w];
        ok = et_knotrule_make(v->u, o->control.nx + o->p + 1, o->p, f->s[w], c->net.nx, o->knots) == ET_OK &&
             et_knotrule_make(v->v, o->control.ny + o->q + 1, o->q, f->r[w], c->net.ny, o->knots) == ET_OK;
    }
    return ok;
}

/* Hard parameters: an ulp apart, tiny, on a knot, coincident. */
static void spoil_parameters(gen *g, et_fit *f, const problem *c)
{
    const size_t kind = gen_upto(g, 11), n = c->net.nx;
    const et_surface *v = &f->shell.view[0];
    double x;

    if (kind == 0 || kind > 5 || n < 3)
        return;
    x = kind == 1 ? nextafter(f->s[0][2], 0) : kind == 2 ? 0x1p-600 : kind == 3 ? v->u[v->nu / 2] : kind == 4 ? f->s[0][0] : 0x1p-1074;
    if (x > f->s[0][2] || x > f->s[1][2])
        return;
    f->s[0][1] = f->s[1][1] = x;
}

static void fill(gen *g, et_fit *f, const problem *c)
{
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < c->options.control.nx * c->options.control.ny; at++)
            f->shell.view[w].points[at] = (et_vec3){gen_real(g, -1e3, 1e3), gen_real(g, -1, 1), gen_real(g, 0, 1e-9)};
}

static void note(gen *g, const et_fit *f, const problem *c)
{
    const et_fit_options *o = &c->options;

    gen_note(g, "%s, corners %d, degrees %zu %zu, data %zux%zu, control %zux%zu", et_fit_name(o->approach), (int)o->corners, o->p, o->q, c->net.nx,
             c->net.ny, o->control.nx, o->control.ny);
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; i < c->net.nx; i++)
            gen_note(g, "s[%zu][%zu] = %a", w, i, f->s[w][i]);
        for (size_t j = 0; j < c->net.ny; j++)
            gen_note(g, "r[%zu][%zu] = %a", w, j, f->r[w][j]);
    }
    for (size_t i = 0; i < c->nov; i++)
        gen_note(g, "class %zu: %a %a %a", i + 1, c->data[i].x, c->data[i].y, c->data[i].z);
}

/* The solver's control points where it has any, else anything. */
static bool draw_fit(gen *g, et_fit *f, problem *c, size_t side)
{
    draw_options(g, c, side);
    draw_data(g, c);
    if (gen_upto(g, 1) == 0 && et_fit_make(f, c->data, c->nov, c->net, &c->options, NULL) == ET_OK) {
        note(g, f, c);
        return true;
    }
    if (!frame_of(f, c))
        return false;
    spoil_parameters(g, f, c);
    fill(g, f, c);
    note(g, f, c);
    return true;
}

/* ---- what must hold ---- */

static double coordinate(const et_vec3 *const P[2], size_t at, size_t n)
{
    return (&P[at / (3 * n)][at % (3 * n) / 3].x)[at % 3];
}

/* How uncertain the double-double solution of coordinate m may be: with N the entries of the matrix and the condition number k, (8 N)^2 (k + k^2) u^2
 * of the largest of solution and data over the matrix: every bound in the library is a product of at most that many terms of those sizes, a
 * direction's condition being at most that of the whole.  k is estimated within a factor 2. */
static double uncertainty(const problem *c, const exact *x, double condition, size_t m)
{
    const et_doublenet k = c->options.control;
    const double N = (double)(c->nov * k.nx * k.ny), cond = 2 * condition;
    double most = 0;

    for (size_t i = 0; i < c->nov; i++)
        most = fmax(most, fabs((&c->data[i].x)[m]));
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < k.nx * k.ny; at++)
            most = fmax(most, fabs(about(x->P[w] + 3 * at + m)));
    return fmin(64 * N * N * (cond + cond * cond) * 0x1p-106 / x->norm * most, 0x1p1000);
}

/* Every radius is large enough, and not larger than the distance and the uncertainty together. */
static bool encloses(gen *g, const problem *c, const et_fit *f, const et_enclosure *e, const exact *x)
{
    const size_t n = c->options.control.nx * c->options.control.ny;
    const et_vec3 *const P[2] = {f->shell.view[0].points, f->shell.view[1].points}, *const R[2] = {e->radius[0], e->radius[1]};
    fmpq_t d;
    bool ok = true;

    fmpq_init(d);
    for (size_t at = 0; ok && at < 6 * n; at++) {
        const double p = coordinate(P, at, n), r = coordinate(R, at, n), spread = uncertainty(c, x, e->condition, at % 3);
        set(d, p);
        fmpq_sub(d, d, x->P[at / (3 * n)] + at % (3 * n));
        ok = gen_check(g, within(d, r), "coordinate %zu: %a is %g off, radius %g", at, p, about(d), r);
        ok = ok && (e->condition > 1e9 || gen_check(g, r <= fabs(about(d)) * (1 + 0x1p-40) + spread + 0x1p-1073,
                                                    "coordinate %zu is %g off, radius %g, uncertainty %g, condition %g", at, about(d), r, spread,
                                                    e->condition));
    }
    fmpq_clear(d);
    return ok;
}

/* Undecided are at least those that are wrong, at most those that are not well inside their interval. */
static bool decided(gen *g, const problem *c, const et_fit *f, const et_enclosure *e, const exact *x)
{
    const size_t n = c->options.control.nx * c->options.control.ny;
    const et_vec3 *const P[2] = {f->shell.view[0].points, f->shell.view[1].points};
    size_t wrong = 0, near = 0;
    fmpq_t m, s;

    fmpq_init(m);
    fmpq_init(s);
    for (size_t at = 0; at < 6 * n; at++) {
        margin(m, coordinate(P, at, n), x->P[at / (3 * n)] + at % (3 * n));
        wrong += fmpq_sgn(m) <= 0;
        set(s, 2 * uncertainty(c, x, e->condition, at % 3));
        near += fmpq_cmp(m, s) <= 0;
    }
    fmpq_clear(m);
    fmpq_clear(s);
    return gen_check(g, wrong <= e->undecided, "%zu are wrong, %zu undecided", wrong, e->undecided) &&
           gen_check(g, e->condition > 1e9 || e->undecided <= near, "%zu undecided, %zu are near a boundary; condition %g", e->undecided, near,
                     e->condition);
}

/* No unique solution: never a bound.  A unique one: a bound, unless the condition number is past 1e11 (its square within a
 * factor n) or basis functions nearly underflow. */
static bool status_right(gen *g, et_status status, const problem *c, const et_fit *f)
{
    exact x;
    bool ok;

    if (status == ET_OK)
        return true;
    solve_exactly(&x, c, f, true);
    ok = gen_check(g, status == ET_ERANK || status == ET_ENOCONV, "status %d", (int)status);
    ok = gen_check(g, status != ET_ERANK || !x.full, "a unique solution, and rank deficient") && ok;
    ok = gen_check(g, !x.full || x.square > 1e22 || x.norm < 0x1p-400, "no bound, condition number %g", sqrt(x.square)) && ok;
    gen_label(g, x.full ? "no bound" : "deficient");
    exact_clear(&x);
    return ok;
}

/* ---- properties ---- */

/* One case in 4. */
verdict prop_enclosure_make(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, was;
    exact x;
    bool ok = true;

    if (!draw_fit(g, &f, &c, 4))
        return FAIL;
    memset(&e, 0x3c, sizeof e);
    was = e;
    const et_status status = et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL);
    if (status != ET_OK) {
        ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0, "unchanged") && status_right(g, status, &c, &f);
    } else {
        solve_exactly(&x, &c, &f, false);
        ok = gen_check(g, x.full, "a bound, but no unique solution") && gen_check(g, e.count == c.options.control.nx * c.options.control.ny, "count");
        ok = ok && encloses(g, &c, &f, &e, &x) && decided(g, &c, &f, &e, &x);
        exact_clear(&x);
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* A coordinate moved by an ulp or by much more: the radius tells. */
verdict prop_enclosure_make_moved(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, moved;
    bool ok;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return SKIP;
    if (et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL) != ET_OK) {
        et_fit_free(&f);
        return SKIP;
    }
    const size_t w = gen_upto(g, 1), at = gen_upto(g, e.count - 1), m = gen_upto(g, 2);
    double *p = &(&f.shell.view[w].points[at].x)[m];
    const double was = *p, r = (&e.radius[w][at].x)[m];
    *p = gen_upto(g, 1) ? nextafter(*p, HUGE_VAL) : *p + 1e-6 * fabs(*p);
    ok = gen_check(g, et_enclosure_make(&moved, &f, c.data, c.nov, &c.options, NULL) == ET_OK, "made");
    if (ok) {
        const double s = (&moved.radius[w][at].x)[m], step = *p - was;
        ok = gen_check(g, s >= (step - r) * (1 - 0x1p-50), "radius %g after a step of %g, %g before", s, step, r);
        ok = gen_check(g, s <= (step + r) * (1 + 0x1p-40) + 0x1p-1072, "radius %g after a step of %g, %g before", s, step, r) && ok;
        ok = gen_check(g, step <= 4 * r || moved.backward >= e.backward || moved.undecided > 0, "a step tells nothing") && ok;
        et_enclosure_free(&moved);
    }
    et_enclosure_free(&e);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* condition: against the exact Gram matrix, whose row sums are within a factor n of its 2-norm, and the estimate at least half of the value. */
/* One case in 4. */
verdict prop_enclosure_make_condition(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    exact x;
    bool ok = true;

    if (!draw_fit(g, &f, &c, 4))
        return FAIL;
    const et_status status = et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL);
    if (status == ET_OK) {
        const double n = 2 * (double)(c.options.control.nx * c.options.control.ny);
        solve_exactly(&x, &c, &f, true);
        if (e.condition < 1e9)
            ok = gen_check(g, e.condition <= sqrt(x.square) * (c.options.approach == ET_FIT_JOINT ? 1.0001 : n), "condition %g, bound %g",
                           e.condition, sqrt(x.square)) &&
                 gen_check(g, 2 * e.condition * sqrt(n) >= sqrt(x.square / n), "condition %g, at least %g", e.condition, sqrt(x.square / n));
        ok = gen_check(g, e.condition >= 1 - 1e-12, "condition %g", e.condition) && ok;
        exact_clear(&x);
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* backward: a stable solver's is a few eps; a fit whose control points are all scaled by 1 + h is h off. */
verdict prop_enclosure_make_backward(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, off;
    bool ok;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    c.options.algebra = ET_LINALG_QR;
    c.options.approach = gen_upto(g, 1) ? ET_FIT_JOINT : ET_FIT_CONVENTIONAL;
    c.options.corners = ET_CORNERS_FREE;
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return SKIP;
    if (et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL) != ET_OK) {
        et_fit_free(&f);
        return SKIP;
    }
    note(g, &f, &c);
    /* The gradient is at most 64 (rows + 8)(columns + 8) u |N| (|D| + |N| |P|) (as the properties of et_fit_make hold it to), through the inverse. */
    const double n = (double)(c.options.control.nx * c.options.control.ny), size = 64 * (2 * (double)c.nov + 8) * (2 * n + 8) * (1 + e.condition);
    bool coarse = false; /* near the least doubles results are rounded to multiples of 2^-1074 */
    for (size_t i = 0; i < c.nov; i++)
        for (size_t m = 0; m < 3; m++)
            coarse = coarse || ((&c.data[i].x)[m] != 0 && fabs((&c.data[i].x)[m]) < 0x1p-960);
    ok = gen_check(g, e.backward >= 0 && (coarse || e.backward <= size * (1 + e.condition)), "backward error %g eps", e.backward);
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < (size_t)n; at++) {
            et_vec3 *p = &f.shell.view[w].points[at];
            *p = (et_vec3){p->x * (1 + 0x1p-10), p->y * (1 + 0x1p-10), p->z * (1 + 0x1p-10)};
        }
    ok = gen_check(g, et_enclosure_make(&off, &f, c.data, c.nov, &c.options, NULL) == ET_OK, "made") && ok;
    if (ok) {
        /* |N e| / |P| is at most |N| 2^-10 (1 + 2^-10) and what was off before. */
        ok = gen_check(g, off.backward <= 0x1p42 * 1.01 + 2 * e.backward, "scaled: %g eps", off.backward);
        et_enclosure_free(&off);
    }
    et_enclosure_free(&e);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Interpolation with degree 1 at knots that are the parameters: N is the identity, and of a coordinate all 1 that became 1 + h the backward error
 * is h / sqrt((1 + h)^2 + h^2). */
verdict prop_enclosure_make_identity(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    const double h = ldexp(1, -(int)gen_between(g, 10, 30));
    bool ok;

    memset(&c, 0, sizeof c);
    c.net = (et_doublenet){gen_between(g, 2, 4), gen_between(g, 2, 4)};
    c.nov = et_doublenet_nov(c.net);
    c.options = et_fit_defaults();
    c.options.approach = gen_upto(g, 1) ? ET_FIT_JOINT : ET_FIT_CONVENTIONAL;
    c.options.corners = ET_CORNERS_FREE;
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_AVERAGING;
    c.options.p = c.options.q = 1;
    c.options.control = c.net;
    for (size_t i = 0; i < c.nov; i++)
        c.data[i] = (et_vec3){1 + (double)gen_upto(g, 3), 1, 3};
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return FAIL;
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < c.net.nx * c.net.ny; at++)
            f.shell.view[w].points[at].y = 1 + h;
    ok = gen_check(g, et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL) == ET_OK, "made");
    if (ok) {
        ok = gen_check(g, fabs(e.condition - 1) < 1e-12, "condition %g", e.condition);
        ok = gen_check(g, fabs(e.backward * 0x1p-52 * sqrt((1 + h) * (1 + h) + h * h) / h - 1) < 1e-9, "backward error %g eps, moved by %g",
                       e.backward, h) &&
             ok;
        for (size_t w = 0; w < 2; w++)
            for (size_t at = 0; at < e.count; at++)
                ok = gen_check(g, fabs(e.radius[w][at].y / h - 1) < 1e-12 && e.radius[w][at].x < 1e-27 && e.radius[w][at].z < 1e-27,
                               "radii %g %g %g", e.radius[w][at].x, e.radius[w][at].y, e.radius[w][at].z) &&
                     ok;
        ok = gen_check(g, e.undecided == 2 * e.count, "%zu undecided", e.undecided) && ok;
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Everything that is wrong with the arguments, one at a time. */
verdict prop_enclosure_make_refuses(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, was;
    et_message message;
    double weight[NODES];
    bool ok;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    if (!frame_of(&f, &c))
        return FAIL;
    memset(&e, 0x3c, sizeof e);
    was = e;
    for (size_t i = 0; i < NODES; i++)
        weight[i] = 1;
    const et_fit good = f;
    et_fit_options o = c.options;
    size_t nov = c.nov;
    const double last = f.s[1][c.net.nx - 1], knot = f.shell.view[1].v[f.shell.view[1].nv];
    const size_t kind = gen_upto(g, 13);
    double end = 1;
    switch (kind) {
    case 0: nov++; break;
    case 1: nov--; break;
    case 2: o.approach = (et_fit_approach)3; break;
    case 3: o.corners = (et_fit_corners)3; break;
    case 4: o.p++; break;
    case 5: o.q = 0; break;
    case 6: o.control.nx++; break;
    case 7: o.control.ny--; break;
    case 8: f.shell.view[0].weights = f.shell.view[1].weights = weight; break;
    case 9: f.s[1][c.net.nx - 1] = end = 0.999; break;
    case 10: f.shell.view[1].v[f.shell.view[1].nv] = 1 - 0x1p-53; break;
    case 11: f.r[0] = NULL; break;
    case 12: f.s[0][0] = 0x1p-60; break;
    default: f.data.nx = 1; break;
    }
    message.text[0] = 0;
    ok = gen_check(g, et_enclosure_make(&e, &f, c.data, nov, &o, &message) == ET_EINVAL && message.text[0] != 0, "case %zu, make", kind);
    ok = gen_check(g, et_enclosure_refine(&f, &e, c.data, nov, &o, &message) == ET_EINVAL, "case %zu, refine", kind) && ok;
    ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0, "case %zu, unchanged", kind) && ok;
    f.s[1][c.net.nx - 1] = last;
    f.shell.view[1].v[f.shell.view[1].nv] = knot;
    (void)end;
    f = good;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Views that do not share what the approach shares; parameters out of order. */
verdict prop_enclosure_make_unshared(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    et_status want;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    c.net.nx = c.options.control.nx = 4;
    c.nov = et_doublenet_nov(c.net);
    c.options.p = gen_between(g, 1, 3);
    c.options.method = ET_PARAM_UNIFORM;
    for (size_t i = 0; i < c.nov; i++)
        c.data[i] = (et_vec3){(double)i, 1, 2};
    if (!frame_of(&f, &c))
        return FAIL;
    want = c.options.approach == ET_FIT_CONVENTIONAL ? ET_OK : ET_EINVAL;
    const size_t kind = gen_upto(g, 2);
    if (kind == 0)
        f.s[1][1] += 0x1p-40;
    else if (kind == 1)
        f.shell.view[0].v[0] = f.shell.view[0].v[0]; /* nothing: what is shared is accepted */
    else
        f.s[0][1] = f.s[1][1] = nextafter(f.s[0][2], 1);
    want = kind == 1 ? ET_OK : kind == 2 ? ET_EINVAL : want;
    const et_status status = et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL);
    const bool ok = gen_check(g, status == want, "case %zu: status %d, wanted %d", kind, (int)status, (int)want);
    if (status == ET_OK)
        et_enclosure_free(&e);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Interior parameters an ulp apart: full rank, but past what double-double can bound; and coincident ones: deficient. */
verdict prop_enclosure_make_hopeless(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, was;
    et_message message;
    bool ok;
    const bool coincident = gen_upto(g, 1);

    memset(&c, 0, sizeof c);
    c.net = c.options.control = (et_doublenet){4, gen_between(g, 2, 4)};
    c.options = et_fit_defaults();
    c.options.control = c.net;
    c.options.q = 1;
    c.options.method = ET_PARAM_UNIFORM;
    c.options.approach = (et_fit_approach)gen_upto(g, 2);
    c.options.corners = (et_fit_corners)gen_upto(g, 2);
    c.nov = et_doublenet_nov(c.net);
    for (size_t i = 0; i < c.nov; i++)
        c.data[i] = (et_vec3){(double)i, 1, (double)(i * i)};
    if (!frame_of(&f, &c))
        return FAIL;
    f.s[0][2] = f.s[1][2] = coincident ? f.s[0][1] : nextafter(f.s[0][1], 1);
    memset(&e, 0x3c, sizeof e);
    was = e;
    message.text[0] = 0;
    const et_status want = coincident ? ET_ERANK : ET_ENOCONV;
    const et_vec3 first = f.shell.view[0].points[0];
    ok = gen_check(g, et_enclosure_make(&e, &f, c.data, c.nov, &c.options, &message) == want && message.text[0] != 0, "make: %s", message.text);
    ok = gen_check(g, et_enclosure_refine(&f, &e, c.data, c.nov, &c.options, &message) == want, "refine: %s", message.text) && ok;
    ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0 && memcmp(&first, f.shell.view[0].points, sizeof first) == 0, "unchanged") && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* The terms of the bound that rounding alone never fills, filled on purpose: right-hand sides moved by the whole of their error (kind 0), or entries
 * of the matrix by 2^-30 of themselves, and `relative` says so (kind 1).  The radius must cover what that does to the solution; the factor is for the
 * products of 2^-30 with itself and with the condition, which `relative`, some u^2 in earnest, leaves out. */
verdict prop_enclosure_make_uncertain(gen *g)
{
    static const double t[6] = {0, 0.125, 0.375, 0.5, 0.8125, 1}, u[8] = {0, 0, 0, 0.25, 0.625, 1, 1, 1};
    enclosure_system s, moved;
    et_dd d[6], e[6], x[5], y[5];
    double error[6], none[6] = {0}, r[5], q[5];
    const int kind = (int)gen_upto(g, 1);
    bool ok;

    if (enclosure_direction(&s, t, 6, u, 5, 2, 0) != ET_OK ||
        enclosure_direction(&moved, t, 6, u, 5, 2, 0) != ET_OK)
        return FAIL;
    for (size_t i = 0; i < 6; i++) {
        d[i] = e[i] = (et_dd){(double)gen_between(g, 1, 16) * (gen_upto(g, 1) ? -1 : 1), 0};
        error[i] = kind == 0 && gen_upto(g, 3) ? 0x1p-20 : 0;
        e[i].hi += gen_upto(g, 1) ? error[i] : -error[i];
    }
    for (size_t k = 0; kind == 1 && k < 18; k++)
        moved.a[k].hi *= 1 + (gen_upto(g, 1) ? 0x1p-30 : -0x1p-30);
    s.relative = kind == 1 ? 0x1p-30 : s.relative;
    ok = enclosure_verify(&s) == ET_OK && enclosure_verify(&moved) == ET_OK;
    if (ok) {
        enclosure_column(x, r, &s, d, error);
        enclosure_column(y, q, &moved, e, none);
        for (size_t j = 0; j < 5; j++) {
            const double off = fabs(et_dd_sub(x[j], y[j]).hi);
            ok = gen_check(g, off <= (r[j] + q[j]) * (1 + 0x1p-16), "kind %d: %g off, radius %g", kind, off, r[j]) && ok;
        }
    }
    enclosure_system_free(&s);
    enclosure_system_free(&moved);
    return ok ? PASS : FAIL;
}

verdict prop_enclosure_free(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    bool ok;

    memset(&e, 0, sizeof e);
    if (!draw_fit(g, &f, &c, 3))
        return FAIL;
    const et_status status = et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL);
    et_enclosure_free(&e);
    ok = gen_check(g, e.radius[0] == NULL && e.radius[1] == NULL && e.count == 0 && e.undecided == 0 && e.condition == 0 && e.backward == 0,
                   "something is left, status %d", (int)status);
    et_enclosure_free(&e);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

static bool same_points(const et_fit *a, const et_fit *b)
{
    const size_t n = a->shell.view[0].nu * a->shell.view[0].nv;

    return memcmp(a->shell.view[0].points, b->shell.view[0].points, n * sizeof(et_vec3)) == 0 &&
           memcmp(a->shell.view[1].points, b->shell.view[1].points, n * sizeof(et_vec3)) == 0;
}

/* Corners that stand are the data's bits; a coordinate zero throughout is +0, with radius 0. */
static bool zeros_and_corners(gen *g, const problem *c, const et_fit *f, const et_enclosure *e)
{
    const et_doublenet k = c->options.control;
    bool ok = true;

    for (size_t m = 0; m < 3; m++) {
        bool zero = true;
        for (size_t i = 0; i < c->nov; i++)
            zero = zero && (&c->data[i].x)[m] == 0;
        for (size_t at = 0; at < 2 * e->count; at++) {
            const size_t w = at / e->count, a = at % e->count / k.ny, b = at % k.ny;
            const double p = (&f->shell.view[w].points[a * k.ny + b].x)[m], r = (&e->radius[w][a * k.ny + b].x)[m];
            if (corners_fixed(&c->options) && corner_node(k, a, b))
                ok = gen_check(g, memcmp(&p, &(&corner_data(c, a, b)->x)[m], sizeof p) == 0 && r == 0, "corner %zu %zu: %a, radius %g", a, b, p, r) &&
                     ok;
            else if (zero)
                ok = gen_check(g, p == 0 && !signbit(p) && r == 0, "zero: %a, radius %g", p, r) && ok;
        }
    }
    return ok;
}

static bool refined_again(gen *g, const problem *c, et_fit *f, const et_enclosure *e)
{
    et_fit other = *f;
    et_enclosure again;
    bool ok;

    memset(&other.shell, 0, sizeof other.shell);
    if (et_shell_copy(&other.shell, &f->shell) != ET_OK)
        return false;
    fill(g, &other, c);
    ok = gen_check(g, et_enclosure_refine(&other, NULL, c->data, c->nov, &c->options, NULL) == ET_OK, "refined from elsewhere");
    ok = gen_check(g, same_points(f, &other), "another start, other bits") && ok;
    if (et_enclosure_make(&again, f, c->data, c->nov, &c->options, NULL) == ET_OK) {
        ok = gen_check(g, again.undecided == e->undecided && memcmp(again.radius[0], e->radius[0], e->count * sizeof(et_vec3)) == 0 &&
                              memcmp(again.radius[1], e->radius[1], e->count * sizeof(et_vec3)) == 0 && again.backward == e->backward &&
                              again.condition == e->condition,
                       "the refinement's enclosure is not that of its points") &&
             ok;
        et_enclosure_free(&again);
    } else {
        ok = gen_check(g, false, "no enclosure of what was refined");
    }
    et_shell_free(&other.shell);
    return ok;
}

/* One case in 4. */
verdict prop_enclosure_refine(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, was;
    exact x;
    bool ok = true;

    if (!draw_fit(g, &f, &c, 4))
        return FAIL;
    memset(&e, 0x3c, sizeof e);
    was = e;
    const et_vec3 first = f.shell.view[1].points[0];
    const et_status status = et_enclosure_refine(&f, &e, c.data, c.nov, &c.options, NULL);
    if (status == ET_EFORMAT) {
        gen_label(g, "overflow");
        ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0, "unchanged");
    } else if (status != ET_OK) {
        ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0 && memcmp(&first, f.shell.view[1].points, sizeof first) == 0, "unchanged") &&
             status_right(g, status, &c, &f);
    } else {
        solve_exactly(&x, &c, &f, false);
        gen_label(g, e.undecided ? "undecided" : "decided");
        ok = gen_check(g, x.full, "refined, but no unique solution") && encloses(g, &c, &f, &e, &x) && decided(g, &c, &f, &e, &x);
        ok = ok && zeros_and_corners(g, &c, &f, &e) && refined_again(g, &c, &f, &e);
        ok = gen_check(g, c.options.approach == ET_FIT_CONVENTIONAL || et_shell_glued(&f.shell), "closed") && ok;
        exact_clear(&x);
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Data of all bits on well-conditioned nets: every coordinate is decided, and is the exact one rounded. */
verdict prop_enclosure_refine_decides(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    exact x;
    bool ok;

    draw_options(g, &c, 4);
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_PIEGL;
    for (size_t i = 0; i < c.nov; i++) /* odd last bits: no ties, no zeros */
        for (size_t m = 0; m < 3; m++)
            (&c.data[i].x)[m] = (double)(2 * (gen_upto(g, UINT64_C(1) << 51)) + 1) * 0x1p-52 + (m == 2 ? 3 : 1);
    if (!frame_of(&f, &c))
        return FAIL;
    ok = gen_check(g, et_enclosure_refine(&f, &e, c.data, c.nov, &c.options, NULL) == ET_OK, "refined");
    if (ok) {
        solve_exactly(&x, &c, &f, false);
        ok = gen_check(g, e.condition < 1e4, "condition %g", e.condition) && decided(g, &c, &f, &e, &x);
        gen_label(g, e.undecided ? "undecided" : "all decided");
        exact_clear(&x);
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Turning the net (rows for columns) and exchanging views give the same control points, turned. */
verdict prop_enclosure_refine_symmetry(gen *g)
{
    problem c, t;
    et_fit f, h;
    et_enclosure e;
    bool ok = true;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    if (!frame_of(&f, &c))
        return FAIL;
    t = c;
    t.net = (et_doublenet){c.net.ny, c.net.nx};
    t.options.control = (et_doublenet){c.options.control.ny, c.options.control.nx};
    t.options.p = c.options.q;
    t.options.q = c.options.p;
    for (size_t at = 0; at < 2 * c.net.nx * c.net.ny; at++) {
        const size_t w = at % 2, i = at / 2 / c.net.ny, j = at / 2 % c.net.ny;
        t.data[et_doublenet_class(t.net, w, j, i) - 1] = c.data[et_doublenet_class(c.net, 1 - w, i, j) - 1];
    }
    memset(&h, 0, sizeof h);
    if (et_fit_parameters(&h, t.data, t.nov, t.net, t.options.approach, t.options.method) != ET_OK ||
        et_shell_new(&h.shell, t.options.p, t.options.q, t.options.control, 0) != ET_OK)
        return FAIL;
    for (size_t w = 0; w < 2; w++) {
        const et_surface *v = &f.shell.view[1 - w];
        memcpy(h.s[w], f.r[1 - w], t.net.nx * sizeof(double));
        memcpy(h.r[w], f.s[1 - w], t.net.ny * sizeof(double));
        memcpy(h.shell.view[w].u, v->v, (v->nv + v->q + 1) * sizeof(double));
        memcpy(h.shell.view[w].v, v->u, (v->nu + v->p + 1) * sizeof(double));
    }
    const et_status a = et_enclosure_refine(&f, &e, c.data, c.nov, &c.options, NULL);
    if (a == ET_OK && e.undecided == 0) {
        et_enclosure_free(&e);
        ok = gen_check(g, et_enclosure_refine(&h, &e, t.data, t.nov, &t.options, NULL) == ET_OK, "turned");
        ok = ok && gen_check(g, e.undecided > 0 || e.condition > 0, "turned");
        for (size_t at = 0; ok && e.undecided == 0 && at < 2 * e.count; at++) {
            const size_t w = at / e.count, i = at % e.count / c.options.control.ny, j = at % c.options.control.ny;
            const et_vec3 p = f.shell.view[w].points[i * c.options.control.ny + j], q = h.shell.view[1 - w].points[j * c.options.control.nx + i];
            ok = gen_check(g, p.x == q.x && p.y == q.y && p.z == q.z, "view %zu (%zu,%zu)", w, i, j);
        }
    }
    if (a == ET_OK)
        et_enclosure_free(&e);
    et_fit_free(&f);
    et_fit_free(&h);
    return ok ? PASS : FAIL;
}

/* ---- golden rows ---- */

static const double *take(double *to, size_t n, const row *r, size_t *at)
{
    for (size_t i = 0; i < n; i++)
        to[i] = row_real(r, (*at)++);
    return to;
}

/* Rows: approach corners p q nx ny cx cy, then for the view, or for each of two (conventional), its parameters s and r and knots u and v; the data by
 * class.  Wanted: control points, bottom view then top. */
verdict gold_enclosure_refine(const row *r)
{
    et_fit_options o = et_fit_defaults();
    const et_doublenet n = {row_size(r, 4), row_size(r, 5)};
    et_vec3 data[128];
    et_fit f;
    et_enclosure e;
    size_t at = 8;
    bool ok;

    o.approach = (et_fit_approach)row_size(r, 0);
    o.corners = (et_fit_corners)row_size(r, 1);
    o.p = row_size(r, 2);
    o.q = row_size(r, 3);
    o.control = (et_doublenet){row_size(r, 6), row_size(r, 7)};
    memset(data, 0, sizeof data);
    if (et_doublenet_nov(n) > sizeof data / sizeof *data ||
        et_fit_parameters(&f, data, et_doublenet_nov(n), n, o.approach, ET_PARAM_UNIFORM) != ET_OK)
        return FAIL;
    if (et_shell_new(&f.shell, o.p, o.q, o.control, 0) != ET_OK) {
        et_fit_free(&f);
        return FAIL;
    }
    for (size_t w = 0; w < 2; w++) {
        et_surface *v = &f.shell.view[w];
        at = w == 1 && o.approach != ET_FIT_CONVENTIONAL ? 8 : at;
        take(f.s[w], n.nx, r, &at);
        take(f.r[w], n.ny, r, &at);
        take(v->u, v->nu + v->p + 1, r, &at);
        take(v->v, v->nv + v->q + 1, r, &at);
    }
    take(&data[0].x, 3 * et_doublenet_nov(n), r, &at);
    ok = et_enclosure_refine(&f, &e, data, et_doublenet_nov(n), &o, NULL) == ET_OK;
    if (ok) {
        const size_t count = e.count;
        ok = e.undecided == 0;
        et_enclosure_free(&e);
        for (size_t i = 0; ok && i < 6 * count; i++)
            ok = row_is(r, i, (&f.shell.view[i / (3 * count)].points[i % (3 * count) / 3].x)[i % 3]);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}
