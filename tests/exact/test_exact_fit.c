/* Least squares in one dense matrix of rationals, from Cox and de Boor's recursion as it is written, and rounded: the judge of et_exact_fit_solve. */
#include "ascending.h"
#include "etalon/spline/knots.h"
#include "exact/exact_fit_parts.h"
#include "exact/live.h"
#include "gen.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 5, DEGREE = 3, NODES = SIDE * SIDE, KNOTS = SIDE + DEGREE + 1, CLASSES = 2 * NODES };

#define FIXED SIZE_MAX

/* ---- cases: a fit in storage of its own ---- */

typedef struct {
    et_fit fit;
    size_t nov;
    et_vec3 data[CLASSES];
    et_fit_options options;
    double s[2][SIDE], r[2][SIDE], u[2][KNOTS], v[2][KNOTS];
    et_vec3 P[2][NODES];
} problem;

/* Parameters from 0 to 1, and knots that suit them, or do not, or fall on an end. */
static void draw_direction(gen *g, double *t, size_t n, double *u, size_t control, size_t p)
{
    const size_t kind = gen_upto(g, 7);

    for (size_t i = 0; i < n; i++)
        t[i] = kind < 2 ? (double)i / (double)(n - 1) : gen_real(g, 0, 1);
    t[0] = 0;
    t[n - 1] = 1;
    ascending(t, n);
    if (kind < 4 && control <= n)
        (void)et_knotrule_make(u, control + p + 1, p, t, n, kind % 2 ? ET_KNOTRULE_PIEGL : ET_KNOTRULE_UNIFORM);
    else
        gen_knots(g, u, control + p + 1, p);
    if (!et_knots_valid(u, control + p + 1, p)) /* neighbours of 0 */
        (void)et_knotrule_make(u, control + p + 1, p, t, n, ET_KNOTRULE_UNIFORM);
    if (kind == 7 && control > p + 1 && gen_chance(g, 2))
        u[p + 1] = 0;
    if (kind == 7 && control > p + 1 && gen_chance(g, 2))
        u[control - 1] = 1;
}

static void store(problem *c, et_doublenet net, et_doublenet control, size_t p, size_t q)
{
    memset(&c->fit, 0, sizeof c->fit);
    c->fit.data = net;
    c->nov = et_doublenet_nov(net);
    for (size_t w = 0; w < 2; w++) {
        c->fit.shell.view[w] = (et_surface){p, q, control.nx, control.ny, c->u[w], c->v[w], c->P[w], NULL};
        c->fit.s[w] = c->s[w];
        c->fit.r[w] = c->r[w];
        for (size_t i = 0; i < NODES; i++)
            c->P[w][i] = (et_vec3){-7, 0.3, (double)i};
    }
}

static void draw_frame(gen *g, problem *c)
{
    const et_doublenet net = {gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)};
    const size_t few = gen_chance(g, 16) ? 1 : 0; /* now and then more control points than data */
    const et_doublenet control = {gen_between(g, 2, few ? SIDE : net.nx), gen_between(g, 2, few ? SIDE : net.ny)};
    const size_t p = gen_between(g, 1, control.nx > DEGREE ? DEGREE : control.nx - 1),
                 q = gen_between(g, 1, control.ny > DEGREE ? DEGREE : control.ny - 1);

    store(c, net, control, p, q);
    c->options = et_fit_defaults();
    c->options.approach = (et_fit_approach)gen_upto(g, 2);
    c->options.corners = (et_fit_corners)gen_upto(g, 2);
    for (size_t w = 0; w < 2; w++) {
        if (w == 1 && c->options.approach != ET_FIT_CONVENTIONAL) {
            memcpy(c->s[1], c->s[0], sizeof c->s[0]);
            memcpy(c->r[1], c->r[0], sizeof c->r[0]);
            memcpy(c->u[1], c->u[0], sizeof c->u[0]);
            memcpy(c->v[1], c->v[0], sizeof c->v[0]);
            continue;
        }
        draw_direction(g, c->s[w], net.nx, c->u[w], control.nx, p);
        draw_direction(g, c->r[w], net.ny, c->v[w], control.ny, q);
    }
}

/* Whole numbers; whole multiples of the least subnormal; neighbours of 1; near overflow; anything; a plane. */
static void draw_data(gen *g, problem *c)
{
    static const double scales[] = {1, 0x1p-1074, 0x1p-52, 0x1p1019, 0, 1};
    const size_t kind = gen_upto(g, 5);

    if (kind == 4) {
        gen_points(g, &c->data[0].x, c->nov);
        return;
    }
    for (size_t i = 0; i < 3 * c->nov; i++) {
        const double x = (double)gen_upto(g, 16) - 8;
        (&c->data[i / 3].x)[i % 3] = kind == 5 && i % 3 == 2 ? -0.0 : (kind == 2 ? 1 : 0) + x * scales[kind];
    }
}

/* ---- the judge ---- */

/* N_i,p(x) on rational knots; the last span of the domain is closed. */
static void deboor(fmpq_t N, const fmpq *u, size_t i, size_t p, const fmpq_t x, const fmpq_t end)
{
    fmpq_t a, b;

    if (p == 0) {
        const int inside = fmpq_cmp(u + i, x) <= 0 && fmpq_cmp(x, u + i + 1) < 0;
        const int last = fmpq_equal(x, end) && fmpq_cmp(u + i, end) < 0 && fmpq_equal(u + i + 1, end);
        fmpq_set_si(N, inside || last, 1);
        return;
    }
    fmpq_init(a);
    fmpq_init(b);
    fmpq_zero(N);
    for (size_t k = 0; k < 2; k++)
        if (fmpq_cmp(u + i + k, u + i + k + p) < 0) {
            deboor(a, u, i + k, p - 1, x, end);
            fmpq_sub(b, u + i + k + p, u + i + k);
            fmpq_div(a, a, b);
            if (k == 0)
                fmpq_sub(b, x, u + i);
            else
                fmpq_sub(b, u + i + 1 + p, x);
            fmpq_addmul(N, a, b);
        }
    fmpq_clear(a);
    fmpq_clear(b);
}

/* m x n: basis functions at the parameters. */
static void basis(fmpq_mat_t A, const double *t, const double *u, size_t p)
{
    const size_t m = (size_t)fmpq_mat_nrows(A), n = (size_t)fmpq_mat_ncols(A);
    fmpq *knots = _fmpq_vec_init((slong)(n + p + 1));
    fmpq_t x;

    fmpq_init(x);
    for (size_t k = 0; k < n + p + 1; k++)
        exact_set(knots + k, u[k]);
    for (size_t i = 0; i < m; i++) {
        exact_set(x, t[i]);
        for (size_t k = 0; k < n; k++)
            deboor(fmpq_mat_entry(A, (slong)i, (slong)k), knots, k, p, x, knots + n);
    }
    fmpq_clear(x);
    _fmpq_vec_clear(knots, (slong)(n + p + 1));
}

static size_t rank_of(const fmpq_mat_t A)
{
    fmpz_mat_t whole;
    slong rank;

    fmpz_mat_init(whole, fmpq_mat_nrows(A), fmpq_mat_ncols(A));
    fmpq_mat_get_fmpz_mat_rowwise(whole, NULL, A);
    rank = fmpz_mat_rank(whole);
    fmpz_mat_clear(whole);
    return (size_t)rank;
}

typedef struct {
    size_t views, columns, number[2][NODES];
    fmpq_mat_t X; /* columns x 3 */
} dense;

static bool at_border(et_doublenet n, size_t at)
{
    const size_t i = at / n.ny, j = at % n.ny;

    return i == 0 || j == 0 || i + 1 == n.nx || j + 1 == n.ny;
}

static bool at_corner(et_doublenet n, size_t at)
{
    return at == 0 || at == n.ny - 1 || at == (n.nx - 1) * n.ny || at == n.nx * n.ny - 1;
}

static et_vec3 corner_of(const problem *c, size_t at)
{
    const et_doublenet n = c->fit.data;
    const size_t i = at / c->fit.shell.view[0].nv, j = at % c->fit.shell.view[0].nv;

    return c->data[(i ? (n.nx - 1) * n.ny : 0) + (j ? n.ny - 1 : 0)];
}

static void number(dense *d, et_doublenet k, size_t views, bool fixed)
{
    d->views = views;
    d->columns = 0;
    for (size_t w = 0; w < views; w++)
        for (size_t at = 0; at < k.nx * k.ny; at++)
            d->number[w][at] = fixed && at_corner(k, at) ? FIXED : w == 1 && at_border(k, at) ? d->number[0][at] : d->columns++;
}

/* One row of the matrix, and its right-hand side. */
static void fill(const dense *d, fmpq_mat_t A, fmpq_mat_t B, size_t row, const problem *c, size_t w, et_vec3 D, const fmpq *U, const fmpq *V)
{
    const et_doublenet k = et_shell_net(&c->fit.shell);
    fmpq_t x, y;

    fmpq_init(x);
    fmpq_init(y);
    for (size_t e = 0; e < 3; e++)
        exact_set(fmpq_mat_entry(B, (slong)row, (slong)e), (&D.x)[e]);
    for (size_t at = 0; at < k.nx * k.ny; at++) {
        const et_vec3 C = corner_of(c, at);
        fmpq_mul(x, U + at / k.ny, V + at % k.ny);
        if (d->number[w][at] != FIXED) {
            fmpq *a = fmpq_mat_entry(A, (slong)row, (slong)d->number[w][at]);
            fmpq_add(a, a, x);
            continue;
        }
        for (size_t e = 0; e < 3; e++) {
            exact_set(y, (&C.x)[e]);
            fmpq_submul(fmpq_mat_entry(B, (slong)row, (slong)e), x, y);
        }
    }
    fmpq_clear(x);
    fmpq_clear(y);
}

/* The normal equations, solved: false if the matrix is deficient. */
static bool solve(dense *d, const fmpq_mat_t A, const fmpq_mat_t B)
{
    fmpq_mat_t T, G, R;
    bool full = rank_of(A) == d->columns;

    fmpq_mat_init(T, (slong)d->columns, fmpq_mat_nrows(A));
    fmpq_mat_init(G, (slong)d->columns, (slong)d->columns);
    fmpq_mat_init(R, (slong)d->columns, 3);
    fmpq_mat_transpose(T, A);
    fmpq_mat_mul(G, T, A);
    fmpq_mat_mul(R, T, B);
    full = full && fmpq_mat_solve(d->X, G, R);
    fmpq_mat_clear(T);
    fmpq_mat_clear(G);
    fmpq_mat_clear(R);
    return full;
}

/* The classes of `views` views from `first` on. */
static bool dense_init(dense *d, const problem *c, size_t first, size_t views, bool fixed)
{
    const et_doublenet n = c->fit.data, k = et_shell_net(&c->fit.shell);
    const et_surface *v = &c->fit.shell.view[first];
    const size_t rows = views == 2 ? c->nov : n.nx * n.ny;
    fmpq_mat_t U, V, A, B;
    size_t row = 0;
    bool full;

    number(d, k, views, fixed);
    fmpq_mat_init(d->X, (slong)d->columns, 3);
    fmpq_mat_init(U, (slong)n.nx, (slong)k.nx);
    fmpq_mat_init(V, (slong)n.ny, (slong)k.ny);
    fmpq_mat_init(A, (slong)rows, (slong)d->columns);
    fmpq_mat_init(B, (slong)rows, 3);
    basis(U, c->s[first], v->u, v->p);
    basis(V, c->r[first], v->v, v->q);
    for (size_t w = 0; w < views; w++)
        for (size_t at = 0; at < n.nx * n.ny; at++)
            if (w == 0 || !at_border(n, at)) {
                const size_t i = at / n.ny, j = at % n.ny;
                fill(d, A, B, row++, c, w, c->data[et_doublenet_class(n, first + w, i, j) - 1], fmpq_mat_entry(U, (slong)i, 0),
                     fmpq_mat_entry(V, (slong)j, 0));
            }
    full = d->columns == 0 || solve(d, A, B);
    fmpq_mat_clear(U);
    fmpq_mat_clear(V);
    fmpq_mat_clear(A);
    fmpq_mat_clear(B);
    return full;
}

static void dense_value(fmpq_t q, const dense *d, const problem *c, size_t w, size_t at, size_t e)
{
    const size_t k = d->number[w][at];
    const et_vec3 C = corner_of(c, at);

    if (k == FIXED)
        exact_set(q, (&C.x)[e]);
    else
        fmpq_set(q, fmpq_mat_entry(d->X, (slong)k, (slong)e));
}

static bool corners_fixed(const et_fit_options *o)
{
    return o->corners == ET_CORNERS_INTERPOLATED || (o->corners == ET_CORNERS_DEFAULT && o->approach == ET_FIT_IMPROVED);
}

/* The value by the definition of the approach; d[w]: each view's problem, or d[0] both views'. */
static void defined_value(fmpq_t q, const dense d[2], const problem *c, size_t w, size_t at, size_t e)
{
    const et_doublenet k = et_shell_net(&c->fit.shell);
    const bool improved = c->options.approach == ET_FIT_IMPROVED;
    const et_vec3 C = corner_of(c, at);
    fmpq_t other;

    if (c->options.approach == ET_FIT_JOINT)
        dense_value(q, &d[0], c, w, at, e);
    else
        dense_value(q, &d[w], c, 0, at, e);
    if (improved && at_border(k, at)) {
        fmpq_init(other);
        dense_value(other, &d[1 - w], c, 0, at, e);
        fmpq_add(q, q, other);
        fmpq_div_2exp(q, q, 1);
        fmpq_clear(other);
    }
    if (improved && corners_fixed(&c->options) && at_corner(k, at))
        exact_set(q, (&C.x)[e]);
}

/* Between two doubles, at equal distances. */
static bool is_tie(const fmpq_t q)
{
    const double x = exact_round(q);
    fmpq_t t, s;
    bool tie = false;

    if (x == 0 || isinf(x))
        return false;
    fmpq_init(t);
    fmpq_init(s);
    for (size_t k = 0; k < 2; k++) {
        exact_set(t, x);
        exact_set(s, nextafter(x, k ? HUGE_VAL : -HUGE_VAL));
        fmpq_add(t, t, s);
        fmpq_div_2exp(t, t, 1);
        tie = tie || fmpq_equal(t, q);
    }
    fmpq_clear(t);
    fmpq_clear(s);
    return tie;
}

typedef struct {
    et_status status;
    double P[2][NODES][3];
    bool tie;
} judgement;

static void judge(judgement *is, const problem *c)
{
    const et_doublenet k = et_shell_net(&c->fit.shell);
    const bool joint = c->options.approach == ET_FIT_JOINT, fixed = corners_fixed(&c->options) && c->options.approach != ET_FIT_IMPROVED;
    dense d[2];
    bool full = true;
    fmpq_t q;

    fmpq_init(q);
    for (size_t w = 0; w < (joint ? 1u : 2u); w++)
        full = dense_init(&d[w], c, w, joint ? 2 : 1, fixed) && full;
    *is = (judgement){full ? ET_OK : ET_ERANK, {{{0}}}, false};
    for (size_t w = 0; full && w < 2; w++)
        for (size_t at = 0; at < k.nx * k.ny; at++)
            for (size_t e = 0; e < 3; e++) {
                defined_value(q, d, c, w, at, e);
                is->P[w][at][e] = exact_round(q);
                is->tie = is->tie || is_tie(q);
                if (isinf(is->P[w][at][e]))
                    is->status = ET_EFORMAT;
            }
    for (size_t w = 0; w < (joint ? 1u : 2u); w++)
        fmpq_mat_clear(d[w].X);
    fmpq_clear(q);
}

/* The first direction of the first view that lacks rank, in words. */
static bool deficiency(char *text, size_t size, const problem *c)
{
    const et_doublenet k = et_shell_net(&c->fit.shell);
    const bool fixed = corners_fixed(&c->options) && c->options.approach != ET_FIT_IMPROVED;
    static const char *const views[] = {"bottom view", "top view"};

    for (size_t w = 0; w < 2; w++)
        for (size_t v = 0; v < 2; v++) {
            const size_t m = v ? c->fit.data.ny : c->fit.data.nx, n = v ? k.ny : k.nx;
            const slong ends = fixed && (v ? k.nx : k.ny) == 2 ? 1 : 0;
            const size_t unknowns = n - 2 * (size_t)ends;
            fmpq_mat_t A, inner;
            size_t rank;
            fmpq_mat_init(A, (slong)m, (slong)n);
            basis(A, v ? c->r[w] : c->s[w], v ? c->v[w] : c->u[w], v ? c->fit.shell.view[w].q : c->fit.shell.view[w].p);
            fmpq_mat_window_init(inner, A, 0, ends, (slong)m, (slong)n - ends);
            rank = rank_of(inner);
            fmpq_mat_window_clear(inner);
            fmpq_mat_clear(A);
            if (rank < unknowns) {
                snprintf(text, size, "%s, direction %s: the %zu parameters determine only %zu of %zu %scontrol points",
                         c->options.approach == ET_FIT_JOINT ? "both views" : views[w], v ? "v" : "u", m, rank, unknowns, ends ? "interior " : "");
                return true;
            }
        }
    return false;
}

/* ---- against the judge ---- */

static bool equals(gen *g, const problem *c, const judgement *is, const char *what)
{
    const et_doublenet k = et_shell_net(&c->fit.shell);
    bool ok = true;

    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < k.nx * k.ny; at++)
            for (size_t e = 0; e < 3; e++)
                ok = gen_check(g, memcmp(&(&c->P[w][at].x)[e], &is->P[w][at][e], sizeof(double)) == 0, "%s: view %zu (%zu,%zu) %c: %a, should be %a",
                               what, w, at / k.ny, at % k.ny, "xyz"[e], (&c->P[w][at].x)[e], is -> P[w][at][e]) &&
                     ok;
    return ok;
}

/* Everything but the control points. */
static bool same_frame(const problem *a, const problem *b)
{
    return memcmp(a->s, b->s, sizeof a->s) == 0 && memcmp(a->r, b->r, sizeof a->r) == 0 && memcmp(a->u, b->u, sizeof a->u) == 0 &&
           memcmp(a->v, b->v, sizeof a->v) == 0 && memcmp(a->data, b->data, sizeof a->data) == 0;
}

static bool agrees(gen *g, problem *c, const judgement *is, size_t *bits, const char *what)
{
    const problem was = *c;
    et_message message = {"untouched"};
    char text[ET_MESSAGE_SIZE] = "untouched";
    const size_t before = bits == NULL ? 0 : *bits;
    bool ok;

    live_begin(c->nov / 2 + c->fit.shell.view[0].p + before);
    const et_status status = et_exact_fit_solve(&c->fit, c->data, c->nov, &c->options, bits, NULL, &message);
    if (!gen_check(g, live_end(), "%s: memory is kept", what))
        return false;
    if (!gen_check(g, status == is->status, "%s: status %d, should be %d: %s", what, (int)status, (int)is->status, message.text))
        return false;
    if (status == ET_OK)
        ok = equals(g, c, is, what) && gen_check(g, bits == NULL || *bits >= (before > 0 ? before : EXACT_BITS), "%s: too few bits", what);
    else {
        ok = gen_check(g, memcmp(c->P, was.P, sizeof c->P) == 0 && (bits == NULL || *bits == before), "%s: outputs changed", what);
        if (status == ET_EFORMAT)
            snprintf(text, sizeof text, "the control points overflow: the data are too large");
        else if (!gen_check(g, deficiency(text, sizeof text, c), "deficient, but not in a direction"))
            ok = false;
    }
    ok = gen_check(g, strcmp(message.text, text) == 0, "%s: message \"%s\", should be \"%s\"", what, message.text, text) && ok;
    ok = gen_check(g, same_frame(c, &was), "%s: not only control points changed", what) && ok;
    memcpy(c->P, was.P, sizeof c->P);
    return ok;
}

static bool judged(gen *g, problem *c)
{
    judgement is;
    size_t own = 0, given = gen_chance(g, 6) ? 1 : gen_between(g, 2, gen_chance(g, 2) ? 300 : 40), four;
    bool ok;

    judge(&is, c);
    gen_label(g, is.status == ET_ERANK ? "deficient" : is.status == ET_EFORMAT ? "overflow" : is.tie ? "a tie" : et_fit_name(c->options.approach));
    ok = agrees(g, c, &is, NULL, "bits null");
    ok = agrees(g, c, &is, &own, "own bits") && ok;
    four = 4 * own;
    ok = agrees(g, c, &is, &given, "bits given") && ok;
    return (is.status != ET_OK || agrees(g, c, &is, &four, "four times the bits")) && ok;
}

/* One case in 4. */
verdict prop_exact_fit_solve(gen *g)
{
    problem c = {.nov = 0};

    draw_frame(g, &c);
    draw_data(g, &c);
    return judged(g, &c) ? PASS : FAIL;
}

/* Where inner knots fall on an end, end functions vanish; between fixed corners a net two wide may be determined all the same. */
/* One case in 2. */
verdict prop_exact_fit_solve_ends(gen *g)
{
    problem c = {.nov = 0};
    const bool across = gen_chance(g, 2);
    const size_t m = gen_between(g, 3, SIDE), n = gen_between(g, 2, 4), control = gen_between(g, 3, m),
                 p = gen_between(g, 1, control - 2 < DEGREE ? control - 2 : DEGREE);
    double *t = across ? c.r[0] : c.s[0], *u = across ? c.v[0] : c.u[0], *x = across ? c.s[0] : c.r[0], *y = across ? c.u[0] : c.v[0];

    store(&c, across ? (et_doublenet){n, m} : (et_doublenet){m, n}, across ? (et_doublenet){2, control} : (et_doublenet){control, 2}, across ? 1 : p,
          across ? p : 1);
    c.options = et_fit_defaults();
    c.options.approach = gen_chance(g, 2) ? ET_FIT_CONVENTIONAL : ET_FIT_JOINT;
    c.options.corners = gen_chance(g, 8) ? ET_CORNERS_FREE : ET_CORNERS_INTERPOLATED;
    draw_direction(g, t, m, u, control, p);
    draw_direction(g, x, n, y, 2, 1);
    if (gen_chance(g, 2))
        u[control - 1] = 1;
    else
        u[p + 1] = 0;
    ascending(u, control + p + 1);
    memcpy(c.s[1], c.s[0], sizeof c.s[0]);
    memcpy(c.r[1], c.r[0], sizeof c.r[0]);
    memcpy(c.u[1], c.u[0], sizeof c.u[0]);
    memcpy(c.v[1], c.v[0], sizeof c.v[0]);
    draw_data(g, &c);
    return judged(g, &c) ? PASS : FAIL;
}

/* Products of unit triangles have as many independent rows as columns between them, though a prime as a factor of the last hides it from residues. */
verdict prop_exact_fit_solve_rank(gen *g)
{
    const size_t m = gen_between(g, 1, 7), n = gen_between(g, 1, 7), most = m < n ? m : n, rank = gen_upto(g, most);
    const ulong factor = gen_chance(g, 2) ? EXACT_PRIME : 1;
    fmpq_mat_t L, R, A;
    size_t found;

    fmpq_mat_init(L, (slong)m, (slong)rank);
    fmpq_mat_init(R, (slong)rank, (slong)n);
    fmpq_mat_init(A, (slong)m, (slong)n);
    for (size_t k = 0; k < rank; k++) {
        for (size_t i = k; i < m; i++)
            fmpq_set_si(fmpq_mat_entry(L, (slong)i, (slong)k), i == k ? 1 : (slong)gen_upto(g, 8) - 4, 1 + gen_upto(g, 2));
        for (size_t j = k; j < n; j++)
            fmpq_set_si(fmpq_mat_entry(R, (slong)k, (slong)j), j == k ? 1 : (slong)gen_upto(g, 8) - 4, 1);
    }
    for (size_t i = 0; rank > 0 && i < m; i++)
        fmpz_mul_ui(fmpq_mat_entry_num(L, (slong)i, (slong)rank - 1), fmpq_mat_entry_num(L, (slong)i, (slong)rank - 1), factor);
    fmpq_mat_mul(A, L, R);
    live_begin(m + n);
    found = exact_rank(A);
    const int dependent = exact_dependent(A);
    const bool kept = !live_end();
    fmpq_mat_clear(L);
    fmpq_mat_clear(R);
    fmpq_mat_clear(A);
    return gen_check(g, !kept, "memory is kept") && gen_check(g, found == rank, "%zu x %zu: rank %zu, should be %zu", m, n, found, rank) &&
                   gen_check(g, (dependent != 0) == (rank < n), "%zu x %zu of rank %zu: dependent: %d", m, n, rank, dependent)
               ? PASS
               : FAIL;
}
