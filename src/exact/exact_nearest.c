/* exact_nearest: the least distance of a point from a curve or a surface, by branch and bound.
 *
 * In a piece that is polynomial, A/w its points less the given one, the squared distance is N/W with N = |A|^2 and W = w^2, both of twice the degree,
 * and the Bernstein coefficients of W are positive.  Where N_i >= t W_i for all i, no point is nearer than sqrt(t).  Pieces are halved at doubles, so
 * that values at their corners are those of the curve or surface at parameters that there are.  All numbers are balls; their unit is such that the
 * points of the control net are within some units of the given one.
 */
#include "exact/exact_radical_parts.h"
#include <math.h>
#include <stdlib.h>

/* What is nearer than 2^-40 of the control net's size is not looked at closer. */
enum { NEGLIGIBLE = 40 };

/* A search: bits of its balls, pieces at most, and the part 2^-close of the least square found that no piece may be below by.  The first one looks
 * everywhere, the second closely; the third is made where more bits may help; the last where the nearest points fill a curve across the parameters,
 * which takes pieces without number to follow closely.  What was found is kept. */
typedef struct {
    slong bits;
    size_t pieces;
    slong close;
} pass;
enum { COARSE, CLOSE, BITS, PASSES = 5 };
static const pass passes[PASSES] = {
    {EXACT_BITS, 1 << 12, 6}, {EXACT_BITS, 1 << 12, 41}, {384, 1 << 12, 41}, {EXACT_BITS, 1 << 14, 21}, {EXACT_BITS, 1 << 16, 11}};

/* A curve is a surface of degree 0 in its second direction. */
typedef struct {
    size_t p[2], n[2];
    const double *u[2];
    const et_vec3 *points;
    const double *weights;
    et_vec3 point;
    exact_net net;                        /* less w times the point */
    slong unit;                           /* 2^unit: of the balls' coordinates; weights count as they are in the net */
} target;

typedef struct {
    double lo[2], hi[2];
    int open[2];                          /* a jump at hi: the value there is another piece's */
    arb_ptr N, W;                         /* W null: all 1 */
} piece;

typedef struct {
    const target *t;
    size_t m[2], size;                    /* coefficients in each direction, and of all */
    slong bits, close;
    size_t pieces, most;
    arf_t least, bound, tolerance, missed; /* squares; missed: a bound of pieces that have no double inside */
    double best[2];
    int missing;
} search;

/* ---- the target ---- */

static size_t knots(const target *t, size_t d)
{
    return t->n[d] + t->p[d] + 1;
}

static double coordinate(const et_vec3 *P, size_t a)
{
    return a == 0 ? P->x : a == 1 ? P->y : P->z;
}

static void target_init(target *t)
{
    slong e, top = 0;
    fmpz_t q;
    fmpz_init(q);
    exact_net_init(&t->net, t->points, t->weights, t->n[0], t->n[1], t->n[1]);
    e = t->net.e;
    for (size_t a = 0; a < 3; a++)
        e = exact_place(e, coordinate(&t->point, a));
    exact_net_align(&t->net, e);
    for (size_t a = 0; a < 3; a++) {
        exact_integer(q, coordinate(&t->point, a), e);
        for (size_t k = 0; k < t->net.n; k++) {
            fmpz *H = t->net.H + EXACT_COMPONENTS * k;
            fmpz_submul(H + a, H + 3, q);
            slong over = (slong)fmpz_bits(H + a) - (slong)fmpz_bits(H + 3);
            top = over > top ? over : top;
        }
    }
    t->unit = e + top;
    fmpz_clear(q);
}

/* ---- pieces ---- */

static void piece_init(piece *c, const search *s)
{
    c->N = _arb_vec_init((slong)s->size);
    c->W = s->t->weights == NULL ? NULL : _arb_vec_init((slong)s->size);
}

static void piece_clear(piece *c, const search *s)
{
    _arb_vec_clear(c->N, (slong)s->size);
    if (c->W != NULL)
        _arb_vec_clear(c->W, (slong)s->size);
}

/* B[j*(p+1) + r], j, r <= p: the Bezier points of the span are these sums of the control points from span - p on. */
static arb_ptr bezier_rows(const target *t, size_t d, size_t span, slong bits)
{
    size_t p = t->p[d];
    const double *u = t->u[d];
    arb_ptr B = _arb_vec_init((slong)((p + 1) * (p + 1)));
    fmpq *N = _fmpq_vec_init((slong)(p + 1));
    double *at = flint_malloc((p + 1) * sizeof *at);
    for (size_t j = 0; j <= p; j++) {
        for (size_t i = 0; i < p; i++)
            at[i] = u[i < j ? span + 1 : span];
        exact_blossom(N, u, p, span, at);
        for (size_t r = 0; r <= p; r++)
            arb_set_fmpq(B + j * (p + 1) + r, N + r, bits);
    }
    flint_free(at);
    _fmpq_vec_clear(N, (slong)(p + 1));
    return B;
}

/* Coordinate a (3: the weight) of the Bezier points of spans k, times binomial coefficients; (p+1)(q+1) of them. */
static arb_ptr bezier_points(const target *t, const size_t k[2], const arb_ptr rows[2], size_t a, slong bits)
{
    size_t m = t->p[0] + 1, n = t->p[1] + 1;
    arb_ptr h = _arb_vec_init((slong)(m * n)), T = _arb_vec_init((slong)(m * n)), P = _arb_vec_init((slong)(m * n));
    fmpz_t binomial;
    fmpz_init(binomial);
    for (size_t i = 0; i < m * n; i++) {
        size_t at = (k[0] - t->p[0] + i / n) * t->n[1] + k[1] - t->p[1] + i % n;
        arb_set_round_fmpz(h + i, t->net.H + EXACT_COMPONENTS * at + a, bits);
        arb_mul_2exp_si(h + i, h + i, a < 3 ? t->net.e - t->unit : 0);
    }
    for (size_t i = 0; i < m * n; i++)
        for (size_t r = 0; r < m; r++)
            arb_addmul(T + i, rows[0] + i / n * m + r, h + r * n + i % n, bits);
    for (size_t i = 0; i < m * n; i++) {
        for (size_t r = 0; r < n; r++)
            arb_addmul(P + i, rows[1] + i % n * n + r, T + i / n * n + r, bits);
        fmpz_bin_uiui(binomial, (ulong)(m - 1), (ulong)(i / n));
        arb_mul_fmpz(P + i, P + i, binomial, bits);
        fmpz_bin_uiui(binomial, (ulong)(n - 1), (ulong)(i % n));
        arb_mul_fmpz(P + i, P + i, binomial, bits);
    }
    _arb_vec_clear(h, (slong)(m * n));
    _arb_vec_clear(T, (slong)(m * n));
    fmpz_clear(binomial);
    return P;
}

/* S += the square of the polynomial with the coefficients P, times the binomial coefficients of S. */
static void add_square(arb_ptr S, const search *s, arb_srcptr P)
{
    size_t m = s->t->p[0] + 1, n = s->t->p[1] + 1;
    for (size_t i = 0; i < m * n; i++)
        for (size_t j = 0; j < m * n; j++)
            arb_addmul(S + (i / n + j / n) * s->m[1] + i % n + j % n, P + i, P + j, s->bits);
}

static void divide_binomials(arb_ptr S, const search *s)
{
    fmpz_t binomial;
    fmpz_init(binomial);
    for (size_t i = 0; i < s->size; i++) {
        fmpz_bin_uiui(binomial, (ulong)(s->m[0] - 1), (ulong)(i / s->m[1]));
        arb_div_fmpz(S + i, S + i, binomial, s->bits);
        fmpz_bin_uiui(binomial, (ulong)(s->m[1] - 1), (ulong)(i % s->m[1]));
        arb_div_fmpz(S + i, S + i, binomial, s->bits);
    }
    fmpz_clear(binomial);
}

/* Whether the right end of the span is an inner knot where the curve may jump. */
static int jumps(const target *t, size_t d, size_t span)
{
    size_t times = 0;
    double x = t->u[d][span + 1];
    for (size_t i = span + 1; i < knots(t, d) && t->u[d][i] == x; i++)
        times++;
    return x < t->u[d][t->n[d]] && times > t->p[d];
}

static void piece_of_spans(piece *c, const search *s, const size_t k[2])
{
    const target *t = s->t;
    arb_ptr rows[2];
    piece_init(c, s);
    for (size_t d = 0; d < 2; d++) {
        c->lo[d] = t->u[d][k[d]];
        c->hi[d] = t->u[d][k[d] + 1];
        c->open[d] = jumps(t, d, k[d]);
        rows[d] = bezier_rows(t, d, k[d], s->bits);
    }
    for (size_t a = 0; a < (c->W != NULL ? 4 : 3); a++) {
        arb_ptr P = bezier_points(t, k, rows, a, s->bits);
        add_square(a < 3 ? c->N : c->W, s, P);
        _arb_vec_clear(P, (slong)((t->p[0] + 1) * (t->p[1] + 1)));
    }
    divide_binomials(c->N, s);
    if (c->W != NULL)
        divide_binomials(c->W, s);
    for (size_t d = 0; d < 2; d++)
        _arb_vec_clear(rows[d], (slong)((t->p[d] + 1) * (t->p[d] + 1)));
}

/* ---- halves ---- */

/* The double in the middle; one of the ends if there is none between. */
static double middle(const piece *c, size_t d)
{
    return c->lo[d] + (c->hi[d] - c->lo[d]) / 2;
}

static int divisible(const piece *c, const search *s, size_t d)
{
    double x = middle(c, d);
    return s->m[d] > 1 && c->lo[d] < x && x < c->hi[d];
}

/* f = (x - lo)/(hi - lo). */
static void fraction(arb_t f, double lo, double x, double hi, slong bits)
{
    arf_t l, h;
    arb_t whole;
    arf_init(l);
    arf_init(h);
    arb_init(whole);
    arf_set_d(l, lo);
    arf_set_d(h, hi);
    arf_sub(arb_midref(whole), h, l, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_set_d(h, x);
    arf_sub(arb_midref(f), h, l, ARF_PREC_EXACT, ARF_RND_DOWN);
    arb_div(f, f, whole, bits);
    arf_clear(l);
    arf_clear(h);
    arb_clear(whole);
}

/* de Casteljau's algorithm on n coefficients of c, `step` apart: those of the left part go to a, those of the right part stay. */
static void cut(arb_ptr a, arb_ptr c, size_t n, size_t step, const arb_t f, const arb_t rest, int half, slong bits)
{
    for (size_t r = n; r-- > 0;) {
        arb_set(a + (n - 1 - r) * step, c);
        for (size_t i = 0; i < r; i++) {
            arb_ptr x = c + i * step, y = x + step;
            if (half) {
                arb_add(x, x, y, bits);
                arb_mul_2exp_si(x, x, -1);
            } else {
                arb_mul(x, x, rest, bits);
                arb_addmul(x, y, f, bits);
            }
        }
    }
}

static void cut_all(arb_ptr a, arb_ptr c, const search *s, size_t d, const arb_t f, const arb_t rest, int half)
{
    size_t lines = s->size / s->m[d];
    for (size_t l = 0; l < lines; l++) {
        size_t at = d == 0 ? l : l * s->m[1];
        cut(a + at, c + at, s->m[d], d == 0 ? s->m[1] : 1, f, rest, half, s->bits);
    }
}

/* c becomes its right half, a its left one. */
static void halve(piece *a, piece *c, const search *s, size_t d)
{
    double x = middle(c, d);
    arb_t f, rest;
    arb_init(f);
    arb_init(rest);
    fraction(f, c->lo[d], x, c->hi[d], s->bits);
    arb_sub_ui(rest, f, 1, s->bits);
    arb_neg(rest, rest);
    int half = arb_equal(f, rest);
    piece_init(a, s);
    for (size_t e = 0; e < 2; e++) {
        a->lo[e] = c->lo[e];
        a->hi[e] = c->hi[e];
        a->open[e] = c->open[e];
    }
    a->hi[d] = c->lo[d] = x;
    a->open[d] = 0;
    cut_all(a->N, c->N, s, d, f, rest, half);
    if (c->W != NULL)
        cut_all(a->W, c->W, s, d, f, rest, half);
    arb_clear(f);
    arb_clear(rest);
}

/* ---- bounds ---- */

/* What follows from the least square. */
static void set_bound(search *s)
{
    arf_t small;
    arf_init(small);
    if (arf_is_finite(s->least))
        arf_mul_2exp_si(small, s->least, -s->close);
    arf_sub(s->bound, s->least, small, s->bits, ARF_RND_DOWN);
    arf_clear(small);
}

static void found(search *s, const arf_t square, double u, double v)
{
    arf_set(s->least, square);
    s->best[0] = u;
    s->best[1] = v;
    set_bound(s);
}

static void try_corners(search *s, const piece *c)
{
    arf_t top;
    arb_t q;
    arf_init(top);
    arb_init(q);
    for (size_t e = 0; e < 4; e++) {
        size_t i = e / 2, j = e % 2, at = i * (s->m[0] - 1) * s->m[1] + j * (s->m[1] - 1);
        if ((i == 1 && c->open[0]) || (j == 1 && c->open[1]))
            continue;
        if (c->W != NULL)
            arb_div(q, c->N + at, c->W + at, s->bits);
        else
            arb_set(q, c->N + at);
        arb_get_ubound_arf(top, q, s->bits);
        if (arf_cmp(top, s->least) < 0)
            found(s, top, i == 0 ? c->lo[0] : c->hi[0], j == 0 ? c->lo[1] : c->hi[1]);
    }
    arf_clear(top);
    arb_clear(q);
}

/* Whether nothing in the piece is nearer than the bound. */
static int beyond(const search *s, const piece *c)
{
    int all = 1;
    arb_t bound, d;
    arb_init(bound);
    arb_init(d);
    arb_set_arf(bound, s->bound);
    for (size_t i = 0; all && i < s->size; i++) {
        if (c->W != NULL) {
            arb_mul(d, c->W + i, bound, s->bits);
            arb_sub(d, c->N + i, d, s->bits);
        } else {
            arb_sub(d, c->N + i, bound, s->bits);
        }
        all = arb_is_nonnegative(d);
    }
    arb_clear(bound);
    arb_clear(d);
    return all;
}

/* No double is inside: what may be nearer in it counts for the lower bound only. */
static void miss(search *s, const piece *c)
{
    arf_t low;
    arb_t q;
    arf_init(low);
    arb_init(q);
    for (size_t i = 0; i < s->size; i++) {
        if (c->W != NULL)
            arb_div(q, c->N + i, c->W + i, s->bits);
        else
            arb_set(q, c->N + i);
        arb_get_lbound_arf(low, q, s->bits);
        if (arf_cmp(low, s->missed) < 0)
            arf_set(s->missed, low);
    }
    s->missing = 1;
    arf_clear(low);
    arb_clear(q);
}

static double quotient(const piece *c, size_t i)
{
    double n = arf_get_d(arb_midref(c->N + i), ARF_RND_NEAR);
    return c->W == NULL ? n : n / arf_get_d(arb_midref(c->W + i), ARF_RND_NEAR);
}

/* How much the coefficients bend in a direction: what makes the bound by them less than the least value. */
static double bend(const search *s, const piece *c, size_t d)
{
    size_t step = d == 0 ? s->m[1] : 1;
    double most = 0;
    for (size_t i = 0; i < s->size; i++) {
        size_t along = d == 0 ? i / s->m[1] : i % s->m[1];
        if (along + 2 < s->m[d])
            most = fmax(most, fabs(quotient(c, i) - 2 * quotient(c, i + step) + quotient(c, i + 2 * step)));
    }
    return most;
}

static double least_coefficient(const search *s, const piece *c)
{
    double least = quotient(c, 0);
    for (size_t i = 1; i < s->size; i++)
        least = fmin(least, quotient(c, i));
    return least;
}

/* ---- the search ---- */

static int finished(const search *s)
{
    return arf_cmp(s->least, s->tolerance) <= 0 || s->pieces > s->most;
}

static int unfinished(const search *s)
{
    return s->pieces > s->most && arf_cmp(s->least, s->tolerance) > 0;
}

/* The piece, which is used up; the nearer half first. */
static void visit(search *s, piece *c)
{
    s->pieces++;
    try_corners(s, c);
    if (finished(s) || beyond(s, c)) {
        piece_clear(c, s);
        return;
    }
    int can[2] = {divisible(c, s, 0), divisible(c, s, 1)};
    if (!can[0] && !can[1]) {
        miss(s, c);
        piece_clear(c, s);
        return;
    }
    piece half;
    halve(&half, c, s, !can[0] || (can[1] && bend(s, c, 1) > bend(s, c, 0)));
    int left = least_coefficient(s, &half) <= least_coefficient(s, c);
    visit(s, left ? &half : c);
    visit(s, left ? c : &half);
}

/* Spans, and a lower bound of the squared distance of their control points' box. */
typedef struct {
    double bound;
    size_t k[2];
} span;

static int nearer(const void *a, const void *b)
{
    const span *x = a, *y = b;
    return x->bound < y->bound ? -1 : x->bound > y->bound;
}

/* Of one coordinate, rounded down, in the search's units. */
static void add_outside(arf_t sum, double lo, double x, double hi, slong unit)
{
    arf_t a, b;
    if (lo <= x && x <= hi)
        return;
    arf_init(a);
    arf_init(b);
    arf_set_d(a, x);
    arf_set_d(b, x < lo ? lo : hi);
    arf_sub(a, a, b, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_mul_2exp_si(a, a, -unit);
    arf_mul(a, a, a, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_add(sum, sum, a, EXACT_BITS, ARF_RND_DOWN);
    arf_clear(a);
    arf_clear(b);
}

/* The box of rows x columns control points from (i, j) on. */
static void box_of(double lo[3], double hi[3], const target *t, size_t i, size_t j, size_t rows, size_t columns)
{
    for (size_t a = 0; a < 3; a++) {
        lo[a] = HUGE_VAL;
        hi[a] = -HUGE_VAL;
        for (size_t k = 0; k < rows * columns; k++) {
            double x = coordinate(t->points + (i + k / columns) * t->n[1] + j + k % columns, a);
            lo[a] = fmin(lo[a], x);
            hi[a] = fmax(hi[a], x);
        }
    }
}

static double span_bound(const target *t, const size_t k[2])
{
    double lo[3], hi[3], bound;
    arf_t sum;
    arf_init(sum);
    box_of(lo, hi, t, k[0] - t->p[0], k[1] - t->p[1], t->p[0] + 1, t->p[1] + 1);
    for (size_t a = 0; a < 3; a++)
        add_outside(sum, lo[a], coordinate(&t->point, a), hi[a], t->unit);
    bound = arf_get_d(sum, ARF_RND_DOWN);
    arf_clear(sum);
    return bound;
}

/* All that are not empty, the nearest first. */
static span *spans_of(size_t *n, const target *t)
{
    size_t rows = t->n[0] - t->p[0], columns = t->n[1] - t->p[1];
    span *all = flint_malloc(rows * columns * sizeof *all);
    *n = 0;
    for (size_t i = 0; i < rows * columns; i++) {
        span c = {0, {t->p[0] + i / columns, t->p[1] + i % columns}};
        if (t->u[0][c.k[0]] < t->u[0][c.k[0] + 1] && t->u[1][c.k[1]] < t->u[1][c.k[1] + 1]) {
            c.bound = span_bound(t, c.k);
            all[(*n)++] = c;
        }
    }
    qsort(all, *n, sizeof *all, nearer);
    return all;
}

/* (2^-40 size)^2, the size being the longest side of the box of all control points. */
static void set_tolerance(arf_t tolerance, const target *t)
{
    double lo[3], hi[3];
    arf_t side, x;
    arf_init(side);
    arf_init(x);
    arf_zero(tolerance);
    box_of(lo, hi, t, 0, 0, t->n[0], t->n[1]);
    for (size_t a = 0; a < 3; a++) {
        arf_set_d(x, lo[a]);
        arf_set_d(side, hi[a]);
        arf_sub(side, side, x, ARF_PREC_EXACT, ARF_RND_DOWN);
        arf_mul_2exp_si(side, side, -NEGLIGIBLE - t->unit);
        arf_mul(side, side, side, ARF_PREC_EXACT, ARF_RND_DOWN);
        if (arf_cmp(side, tolerance) > 0)
            arf_set(tolerance, side);
    }
    arf_clear(side);
    arf_clear(x);
}

static void run(search *s, const span *spans, size_t n)
{
    piece c;
    set_bound(s);
    arf_pos_inf(s->missed);
    s->pieces = 0;
    s->missing = 0;
    for (size_t i = 0; i < n && !finished(s) && arf_cmp_d(s->bound, spans[i].bound) > 0; i++) {
        piece_of_spans(&c, s, spans[i].k);
        visit(s, &c);
    }
}

/* ---- results ---- */

/* The distance at the best parameters, rounded up. */
static double distance_at(const target *t, const double x[2])
{
    exact_line l[2];
    fmpq_t q, d;
    fmpz *T = _fmpz_vec_init((slong)(EXACT_COMPONENTS * (t->p[1] + 2))), *S = T + EXACT_COMPONENTS * (t->p[1] + 1);
    fmpq_init(q);
    fmpq_init(d);
    for (size_t e = 0; e < 2; e++)
        exact_line_init(l + e, t->u[e], t->n[e], t->p[e], x[e], 0);
    exact_contract(T, t->p[1] + 1, l[0].row, t->net.H + EXACT_COMPONENTS * (l[0].first * t->n[1] + l[1].first), t->n[1]);
    exact_contract(S, 1, l[1].row, T, 1);
    for (size_t a = 0; a < 3; a++)
        fmpz_addmul(fmpq_numref(q), S + a, S + a);
    fmpz_mul(fmpq_denref(q), S + 3, S + 3);
    fmpq_canonicalise(q);
    exact_scale(q, 2 * t->net.e);
    double up = exact_round_sqrt(q);
    if (isfinite(up)) {
        exact_set(d, up);
        fmpq_mul(d, d, d);
        up = fmpq_cmp(d, q) < 0 ? nextafter(up, HUGE_VAL) : up;
    }
    for (size_t e = 0; e < 2; e++)
        exact_line_clear(l + e);
    _fmpz_vec_clear(T, (slong)(EXACT_COMPONENTS * (t->p[1] + 2)));
    fmpq_clear(q);
    fmpq_clear(d);
    return up;
}

/* The root of what is proved, rounded down. */
static double lower_of(const search *s)
{
    arf_t low;
    arf_init(low);
    if (arf_cmp(s->least, s->tolerance) > 0) {
        arf_set(low, arf_cmp(s->missed, s->bound) < 0 ? s->missed : s->bound);
        if (arf_sgn(low) < 0)
            arf_zero(low);
        arf_sqrt(low, low, s->bits, ARF_RND_DOWN);
        arf_mul_2exp_si(low, low, s->t->unit);
    }
    double x = arf_get_d(low, ARF_RND_DOWN);
    arf_clear(low);
    return x;
}

static et_status nearest(double x[2], double *distance, double *lower, target *t)
{
    size_t n;
    search s;
    s.t = t;
    s.m[0] = 2 * t->p[0] + 1;
    s.m[1] = 2 * t->p[1] + 1;
    s.size = s.m[0] * s.m[1];
    arf_init(s.least);
    arf_init(s.bound);
    arf_init(s.tolerance);
    arf_init(s.missed);
    arf_pos_inf(s.least);
    target_init(t);
    set_tolerance(s.tolerance, t);
    span *spans = spans_of(&n, t);
    for (size_t k = COARSE; k <= CLOSE || (k < PASSES && unfinished(&s)) || (k == BITS && s.missing); k++) {
        s.bits = passes[k].bits;
        s.most = passes[k].pieces;
        s.close = passes[k].close;
        run(&s, spans, n);
    }
    et_status status = unfinished(&s) ? ET_ENOCONV : ET_OK;
    if (status == ET_OK) {
        x[0] = s.best[0];
        x[1] = s.best[1];
        *distance = distance_at(t, s.best);
        *lower = lower_of(&s);
    }
    flint_free(spans);
    exact_net_clear(&t->net);
    arf_clear(s.least);
    arf_clear(s.bound);
    arf_clear(s.tolerance);
    arf_clear(s.missed);
    return status;
}

et_status et_exact_curve_nearest(double *x, double *distance, double *lower, const et_curve *c, et_vec3 point)
{
    static const double one[2] = {0, 1};
    double at[2];
    size_t size;
    if (!et_curve_valid(c) || !et_vec3_finite(&point, 1))
        return ET_EINVAL;
    if (!exact_fits(&size, c->n, 2 * c->p + 1))
        return ET_ENOMEM;
    target t = {{c->p, 0}, {c->n, 1}, {c->u, one}, c->points, c->weights, point, {NULL, 0, 0, 0}, 0};
    et_status status = nearest(at, distance, lower, &t);
    *x = status == ET_OK ? at[0] : *x;
    return status;
}

et_status et_exact_surface_nearest(double uv[2], double *distance, double *lower, const et_surface *s, et_vec3 point)
{
    size_t size;
    if (!et_surface_valid(s) || !et_vec3_finite(&point, 1))
        return ET_EINVAL;
    if (!exact_fits(&size, s->nu, s->nv) || !exact_fits(&size, 2 * s->p + 1, 2 * s->q + 1))
        return ET_ENOMEM;
    target t = {{s->p, s->q}, {s->nu, s->nv}, {s->u, s->v}, s->points, s->weights, point, {NULL, 0, 0, 0}, 0};
    return nearest(uv, distance, lower, &t);
}

/* ---- the error of a surface ---- */

/* Whether all are finite. */
static int finite(const double *t, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(t[i]))
            return 0;
    return 1;
}

et_status et_exact_surface_error(double *sum, double *greatest, const et_surface *s, const double *a, size_t mu, const double *b, size_t mv,
                                 const et_vec3 *D)
{
    slong e;
    size_t n, size, bits = EXACT_BITS;
    exact_net data;
    double most = 0;
    if (!et_surface_valid(s) || !finite(a, mu) || !finite(b, mv))
        return ET_EINVAL;
    if (!exact_fits(&size, s->nu, s->nv) || !exact_fits(&n, mu, mv))
        return ET_ENOMEM;
    if (!et_vec3_finite(D, n))
        return ET_EINVAL;
    fmpz *G = _fmpz_vec_init((slong)(EXACT_COMPONENTS * n)), *num = _fmpz_vec_init((slong)(2 * n)), *den = num + n;
    exact_grid(G, &e, s, a, mu, b, mv);
    exact_net_init(&data, D, NULL, n, 1, 1);
    slong unit = e < data.e ? e : data.e;
    for (size_t k = 0; k < n; k++) {
        exact_gap(num + k, den + k, data.H + EXACT_COMPONENTS * k, data.e, G + EXACT_COMPONENTS * k, e);
        most = fmax(most, exact_root(num + k, den + k, unit));     /* rounding is monotone */
    }
    *sum = exact_root_sum(num, den, n, unit, 1, &bits);
    *greatest = most;
    _fmpz_vec_clear(G, (slong)(EXACT_COMPONENTS * n));
    _fmpz_vec_clear(num, (slong)(2 * n));
    exact_net_clear(&data);
    return ET_OK;
}
