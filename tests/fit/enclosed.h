/* enclosed: small fits in every approach, and their exact least-squares solution by its definition, for the tests of enclosures. */
#ifndef TESTS_FIT_ENCLOSED_H
#define TESTS_FIT_ENCLOSED_H
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
static inline void set(fmpq_t q, double x)
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
static inline void difference(fmpq_t q, double a, double b)
{
    fmpq_t c;

    fmpq_init(c);
    set(q, a);
    set(c, b);
    fmpq_sub(q, q, c);
    fmpq_clear(c);
}

/* Whether |q| <= bound; not for a NaN. */
static inline bool within(const fmpq_t q, double bound)
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
static inline double about(const fmpq_t q)
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
static inline void margin(fmpq_t m, double P, const fmpq_t q)
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

static inline int inside(et_doublenet n, size_t i, size_t j)
{
    return i > 0 && j > 0 && i + 1 < n.nx && j + 1 < n.ny;
}

static inline int corner_node(et_doublenet n, size_t i, size_t j)
{
    return (i == 0 || i + 1 == n.nx) && (j == 0 || j + 1 == n.ny);
}

static inline int corners_fixed(const et_fit_options *o)
{
    return o->corners == ET_CORNERS_INTERPOLATED || (o->corners == ET_CORNERS_DEFAULT && o->approach == ET_FIT_IMPROVED);
}

static inline const et_vec3 *corner_data(const problem *c, size_t i, size_t j)
{
    return &c->data[(i ? (c->net.nx - 1) * c->net.ny : 0) + (j ? c->net.ny - 1 : 0)];
}

/* Cox and de Boor, 0/0 = 0, the last non-empty span closed. */
static inline void deboor(fmpq_t N, const double *u, size_t i, size_t p, double x, double end)
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

static inline void collocate(fmpq_mat_t N, const double *t, const double *u, size_t p)
{
    for (slong i = 0; i < fmpq_mat_nrows(N); i++)
        for (slong j = 0; j < fmpq_mat_ncols(N); j++)
            deboor(fmpq_mat_entry(N, i, j), u, (size_t)j, p, t[i], 1);
}

/* number[w][a*cy + b] of the unknowns of views first .. first + views - 1, OUT for fixed ones; returns their count. */
static inline size_t count_unknowns(size_t number[2][NODES], const problem *c, size_t views, int fixed)
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
static inline void assemble(fmpq_mat_t G, fmpq_mat_t H, size_t number[2][NODES], const problem *c, const et_fit *f, size_t first, size_t views)
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
static inline double row_sum(const fmpq_mat_t A)
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
static inline bool solve_views(exact *x, const problem *c, const et_fit *f, size_t first, size_t views, int fixed, bool condition)
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
static inline void close_border(exact *x, const problem *c)
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

static inline void solve_exactly(exact *x, const problem *c, const et_fit *f, bool condition)
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

static inline void exact_clear(exact *x)
{
    _fmpq_vec_clear(x->P[0], 3 * NODES);
    _fmpq_vec_clear(x->P[1], 3 * NODES);
}

/* ---- cases ---- */

static inline void draw_options(gen *g, problem *c, size_t side)
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
static inline void draw_data(gen *g, problem *c)
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
static inline bool frame_of(et_fit *f, const problem *c)
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
static inline void spoil_parameters(gen *g, et_fit *f, const problem *c)
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

static inline void fill(gen *g, et_fit *f, const problem *c)
{
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < c->options.control.nx * c->options.control.ny; at++)
            f->shell.view[w].points[at] = (et_vec3){gen_real(g, -1e3, 1e3), gen_real(g, -1, 1), gen_real(g, 0, 1e-9)};
}

static inline void note(gen *g, const et_fit *f, const problem *c)
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
static inline bool draw_fit(gen *g, et_fit *f, problem *c, size_t side)
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

static inline double coordinate(const et_vec3 *const P[2], size_t at, size_t n)
{
    return (&P[at / (3 * n)][at % (3 * n) / 3].x)[at % 3];
}

/* How uncertain the double-double solution of coordinate m may be: with N the entries of the matrix and the condition number k, (8 N)^2 (k + k^2) u^2
 * of the largest of solution and data over the matrix: every bound in the library is a product of at most that many terms of those sizes, a
 * direction's condition being at most that of the whole.  k is estimated within a factor 2. */
static inline double uncertainty(const problem *c, const exact *x, double condition, size_t m)
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
static inline bool encloses(gen *g, const problem *c, const et_fit *f, const et_enclosure *e, const exact *x)
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
static inline bool decided(gen *g, const problem *c, const et_fit *f, const et_enclosure *e, const exact *x)
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
static inline bool status_right(gen *g, et_status status, const problem *c, const et_fit *f)
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
#endif
