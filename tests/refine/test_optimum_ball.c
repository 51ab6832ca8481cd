/* What is proved in balls, a second time: sums and projections operation by operation, the same balls and so the same doubles; how long a least P can be,
 * which counts where something is left of N'y, in rationals and by other formulas.  And what balls take they give back. */
#include "etalon/refine/optimum.h"
#include "exact/exact_parts.h"
#include "exact/live.h"
#include "refine/optimum_cases.h"
#include "refine/optimum_parts.h"
#include <arb.h>
#include <flint/fmpq_mat.h>
#include <flint/fmpq_poly.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 256, C = OPTIMUM_CLASSES, NODES = 2 * OPTIMUM_MOST * OPTIMUM_MOST };

typedef struct {
    const optimum_model *m;
    slong bits;
    arb_ptr u, v;                         /* [t][n]: all functions of a direction, zeros too */
} bases;

/* ---- basis functions ---- */

/* One row by the triangle of A2.2: N_{r,j} = (u_{r+j+1} - t) N_{r+1,j-1} / (u_{r+j+1} - u_{r+1}) + (t - u_r) N_{r,j-1} / (u_{r+j} - u_r). */
static void row(arb_ptr N, const optimum_axis *a, double t, slong bits)
{
    size_t span = a->p;
    arb_ptr s = _arb_vec_init(5);

    t = t < a->knots[a->p] ? a->knots[a->p] : t > a->knots[a->n] ? a->knots[a->n] : t;
    while (span + 1 < a->n && a->knots[span + 1] <= t)
        span++;
    while (a->knots[span] == a->knots[span + 1])
        span--;
    arb_one(N);
    for (size_t j = 1; j <= a->p; j++) {
        arb_zero(s + 4);
        for (size_t r = 0; r < j; r++) {
            const double knots[2] = {a->knots[span + 1 + r - j], a->knots[span + 1 + r]};

            for (int k = 0; k < 2; k++) {
                arb_set_d(s + 2, knots[k]);
                arb_set_d(s + 3, t);
                arb_sub(s + k, k == 0 ? s + 3 : s + 2, k == 0 ? s + 2 : s + 3, bits);
            }
            arb_add(s + 2, s + 1, s, bits);
            arb_div(s + 3, N + r, s + 2, bits);
            arb_mul(s + 1, s + 1, s + 3, bits);
            arb_add(N + r, s + 4, s + 1, bits);
            arb_mul(s + 4, s, s + 3, bits);
        }
        arb_set(N + j, s + 4);
    }
    _arb_vec_clear(s, 5);
}

static arb_ptr all_rows(const optimum_axis *a, bool shifted, slong bits)
{
    arb_ptr N = _arb_vec_init((slong)(a->nt * a->n)), part = _arb_vec_init((slong)a->p + 1);

    for (size_t i = 0; i < a->nt; i++) {
        row(part, a, a->t[i], bits);
        for (size_t k = 0; k <= a->p; k++) {
            const size_t j = a->first[i] + k;

            if (a->value[i * (a->p + 1) + k] != 0)
                arb_mul_2exp_si(N + i * a->n + j, part + k, shifted ? a->shift[j] : 0);
        }
    }
    _arb_vec_clear(part, (slong)a->p + 1);
    return N;
}

static bases bases_of(const optimum_model *m, bool shifted, slong bits)
{
    return (bases){m, bits, all_rows(&m->u, shifted, bits), all_rows(&m->v, shifted, bits)};
}

static void bases_end(bases *b)
{
    _arb_vec_clear(b->u, (slong)(b->m->u.nt * b->m->u.n));
    _arb_vec_clear(b->v, (slong)(b->m->v.nt * b->m->v.n));
}

/* The functions in use at data class c, by control row and column. */
static arb_srcptr along_u(const bases *b, size_t c, size_t i)
{
    return b->u + b->m->node[c].i * b->m->u.n + b->m->u.first[b->m->node[c].i] + i;
}

static arb_srcptr along_v(const bases *b, size_t c, size_t j)
{
    return b->v + b->m->node[c].j * b->m->v.n + b->m->v.first[b->m->node[c].j] + j;
}

/* ---- rounding and lengths ---- */

static double rounded(const arb_t x, arf_rnd_t way)
{
    arf_t a;
    double d;

    arf_init(a);
    if (way == ARF_RND_CEIL)
        arb_get_ubound_arf(a, x, BITS);
    else if (way == ARF_RND_FLOOR)
        arb_get_lbound_arf(a, x, BITS);
    else
        arf_set(a, arb_midref(x));
    d = arf_get_d(a, way);
    arf_clear(a);
    return d;
}

static void square_root_of_squares(arb_t out, arb_srcptr x, size_t n, slong bits)
{
    arb_t s;

    arb_init(s);
    for (size_t k = 0; k < n; k++)
        arb_addmul(s, x + k, x + k, bits);
    arb_sqrtpos(out, s, bits);
    arb_clear(s);
}

static void set_data(arb_ptr x, et_vec3 p)
{
    const double all[3] = {p.x, p.y, p.z};

    for (int d = 0; d < 3; d++)
        arb_set_d(x + d, all[d]);
}

/* ---- E ---- */

static double value_of(double *r, const optimum_case *c, const optimum_model *m)
{
    bases b = bases_of(m, false, BITS);
    arb_ptr s = _arb_vec_init(9);
    double value;

    for (size_t k = 0; k < m->nov; k++) {
        const et_surface *const f = &c->fit.shell.view[m->node[k].k == 2];

        set_data(s, c->data[k]);
        for (size_t i = 0; i <= m->u.p; i++)
            for (size_t j = 0; j <= m->v.p; j++) {
                arb_mul(s + 8, along_u(&b, k, i), along_v(&b, k, j), BITS);
                set_data(s + 3, f->points[(m->u.first[m->node[k].i] + i) * f->nv + m->v.first[m->node[k].j] + j]);
                for (int d = 0; d < 3; d++)
                    arb_submul(s + d, s + 8, s + 3 + d, BITS);
            }
        for (size_t d = 0; d < 3; d++)
            r[3 * k + d] = rounded(s + d, ARF_RND_NEAR);
        square_root_of_squares(s + 6, s, 3, BITS);
        arb_add(s + 7, s + 7, s + 6, BITS);
    }
    value = rounded(s + 7, ARF_RND_CEIL);
    _arb_vec_clear(s, 9);
    bases_end(&b);
    return value;
}

/* ---- projections ---- */

typedef struct {
    bases b;
    arb_ptr x, y;                         /* N'y, y */
    arb_t left;                           /* |N'y| at most */
    optimum_solver solver;
} moved;

static void see_left(moved *p)
{
    const optimum_model *const m = p->b.m;
    arb_t w;

    arb_init(w);
    _arb_vec_zero(p->x, (slong)(3 * m->m));
    for (size_t c = 0; c < m->nov; c++)
        for (size_t k = 0; k <= m->u.p; k++)
            for (size_t l = 0; l <= m->v.p; l++) {
                const et_index node = m->node[c];
                const size_t at = optimum_model_place(m, node.k == 2, m->u.first[node.i] + k, m->v.first[node.j] + l);

                arb_mul(w, along_u(&p->b, c, k), along_v(&p->b, c, l), BITS);
                for (size_t d = 0; d < 3 && at != SIZE_MAX; d++)
                    arb_addmul(p->x + 3 * at + d, w, p->y + 3 * c + d, BITS);
            }
    square_root_of_squares(p->left, p->x, 3 * m->m, BITS);
    arb_get_ubound_arf(arb_midref(p->left), p->left, BITS);
    mag_zero(arb_radref(p->left));
    arb_clear(w);
}

/* W a, W symmetric: xx, xy, xz, yy, yz, zz. */
static double times(const double *h, const double *a, size_t d)
{
    static const size_t at[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

    return h == NULL ? a[d] : h[at[d][0]] * a[0] + h[at[d][1]] * a[1] + h[at[d][2]] * a[2];
}

static void make_left_small(moved *p, const double *weight)
{
    const optimum_model *const m = p->b.m;
    double f[3 * NODES], z[3 * NODES], w[3 * C];
    arb_t before, s;

    arb_init(before);
    arb_init(s);
    see_left(p);
    for (int step = 0; step < 64 && !arb_is_zero(p->left); step++) {
        for (size_t k = 0; k < 3 * m->m; k++)
            f[k] = rounded(p->x + k, ARF_RND_NEAR);
        optimum_model_forces(z, m, f);
        optimum_solve_run(&p->solver, z, 0x1p-40);
        optimum_solve_take(z, w, &p->solver);
        for (size_t k = 0; k < 3 * m->nov; k++) {
            arb_set_d(s, times(weight ? weight + 6 * (k / 3) : NULL, w + k / 3 * 3, k % 3));
            arb_sub(p->y + k, p->y + k, s, BITS);
        }
        arb_set(before, p->left);
        see_left(p);
        arb_mul_2exp_si(s, p->left, 1);
        if (!arb_lt(s, before))
            break;
    }
    arb_clear(before);
    arb_clear(s);
}

static bool move_begin(moved *p, const optimum_model *m, const double *weight)
{
    static double ones[C];

    for (size_t c = 0; c < C; c++)
        ones[c] = 1;
    if (optimum_solve_new(&p->solver, m, weight != NULL) != ET_OK)
        return false;
    p->b = bases_of(m, true, BITS);
    p->x = _arb_vec_init((slong)(3 * m->m));
    p->y = _arb_vec_init((slong)(3 * m->nov));
    arb_init(p->left);
    optimum_solve_factor(&p->solver, weight ? weight : ones);
    return true;
}

static void move_end(moved *p)
{
    _arb_vec_clear(p->x, (slong)(3 * p->b.m->m));
    _arb_vec_clear(p->y, (slong)(3 * p->b.m->nov));
    arb_clear(p->left);
    bases_end(&p->b);
    optimum_solve_free(&p->solver);
}

/* ---- |P*|, in rationals and by other formulas ---- */

/* N, columns times 2^shift; values that are no doubles are zero. */
static void exact_columns(fmpq_mat_t N, const optimum_axis *a)
{
    fmpq *row = _fmpq_vec_init((slong)a->p + 1);

    for (size_t i = 0; i < a->nt; i++) {
        exact_basis(row, 0, a->knots, a->n + a->p + 1, a->p, a->first[i] + a->p, a->t[i]);
        for (size_t k = 0; k <= a->p; k++) {
            const int shift = a->shift[a->first[i] + k];
            fmpq *const q = fmpq_mat_entry(N, (slong)i, (slong)(a->first[i] + k));

            if (a->value[i * (a->p + 1) + k] == 0)
                continue;
            if (shift < 0)
                fmpq_div_2exp(q, row + k, (ulong)-shift);
            else
                fmpq_mul_2exp(q, row + k, (ulong)shift);
        }
    }
    _fmpq_vec_clear(row, (slong)a->p + 1);
}

static void sum_of_squares(fmpq_t sum, const fmpq_mat_t A)
{
    fmpq_zero(sum);
    for (slong i = 0; i < fmpq_mat_nrows(A); i++)
        for (slong j = 0; j < fmpq_mat_ncols(A); j++)
            fmpq_addmul(sum, fmpq_mat_entry(A, i, j), fmpq_mat_entry(A, i, j));
}

/* The sum of 1 / lambda^2 over the eigenvalues of G from its characteristic polynomial ... + c2 x^2 + c1 x + c0: that of 1 / lambda is -c1 / c0, that of
 * products of two of them c2 / c0.  False if an eigenvalue is 0. */
static bool inverse_squares(fmpq_t sum, const fmpq_mat_t G)
{
    fmpq_poly_t c;
    fmpq_t e[3];

    fmpq_poly_init(c);
    fmpq_mat_charpoly(c, G);
    for (slong k = 0; k < 3; k++) {
        fmpq_init(e[k]);
        fmpq_poly_get_coeff_fmpq(e[k], c, k);
    }
    const bool regular = !fmpq_is_zero(e[0]);
    if (regular) {
        fmpq_div(e[1], e[1], e[0]);
        fmpq_div(e[2], e[2], e[0]);
        fmpq_mul(sum, e[1], e[1]);
        fmpq_sub(sum, sum, e[2]);
        fmpq_sub(sum, sum, e[2]);
    }
    for (int k = 0; k < 3; k++)
        fmpq_clear(e[k]);
    fmpq_poly_clear(c);
    return regular;
}

/* Of A'A, A the columns kept (inner: without the first and the last column and row): the sum of 1 / lambda^2, and more than its condition number's
 * square, both sums of squares' product. */
static bool columns_kept(fmpq_t sum, fmpq_t condition, const optimum_axis *a, const fmpq_mat_t N, slong inner)
{
    const slong rows = (slong)a->nt - 2 * inner;
    slong n = 0, column[OPTIMUM_MOST];
    fmpq_mat_t A, T, G;

    for (slong j = inner; j + inner < (slong)a->n; j++)
        if (a->keep[j])
            column[n++] = j;
    fmpq_mat_init(A, rows, n);
    fmpq_mat_init(T, n, rows);
    fmpq_mat_init(G, n, n);
    for (slong i = 0; i < rows; i++)
        for (slong k = 0; k < n; k++)
            fmpq_set(fmpq_mat_entry(A, i, k), fmpq_mat_entry(N, i + inner, column[k]));
    fmpq_mat_transpose(T, A);
    fmpq_mat_mul(G, T, A);
    const bool regular = inverse_squares(sum, G);
    sum_of_squares(condition, G);
    fmpq_mul(condition, condition, sum);
    fmpq_mat_clear(G);
    fmpq_mat_clear(T);
    fmpq_mat_clear(A);
    return regular;
}

/* out = q^(1/2^times). */
static void root(arb_t out, const fmpq_t q, int times)
{
    arb_set_fmpq(out, q, 2 * BITS);
    for (int k = 0; k < times; k++)
        arb_sqrtpos(out, out, 2 * BITS);
}

/* With |N X| <= 1: |X| <= factor = b + (1 + |U| |V| b) b', b and b' the fourth roots of what columns_kept tells of u and of v, multiplied; b' of the inner
 * columns.  condition: the greatest square.  False if columns depend on each other. */
static bool factor_of(arb_t factor, fmpq_t condition, const optimum_model *m)
{
    const optimum_axis *const axes[2] = {&m->u, &m->v};
    fmpq_t q[5];                          /* for b, b', |U| |V|, and two to work with */
    fmpq_mat_t N;
    arb_t x, b;
    bool regular = true;

    arb_init(x);
    arb_init(b);
    for (int k = 0; k < 5; k++) {
        fmpq_init(q[k]);
        fmpq_one(q[k]);
    }
    fmpq_one(condition);
    for (int e = 0; e < 2; e++) {
        fmpq_mat_init(N, (slong)axes[e]->nt, (slong)axes[e]->n);
        exact_columns(N, axes[e]);
        for (int inner = 0; inner < 2 && regular; inner++) {
            regular = columns_kept(q[3], q[4], axes[e], N, inner);
            fmpq_mul(q[inner], q[inner], q[3]);
            if (regular && fmpq_cmp(condition, q[4]) < 0)
                fmpq_set(condition, q[4]);
        }
        sum_of_squares(q[3], N);
        fmpq_mul(q[2], q[2], q[3]);
        fmpq_mat_clear(N);
    }
    root(factor, q[0], 2);
    root(x, q[2], 1);
    arb_mul(x, x, factor, 2 * BITS);
    arb_add_ui(x, x, 1, 2 * BITS);
    root(b, q[1], 2);
    arb_addmul(factor, x, b, 2 * BITS);
    for (int k = 0; k < 5; k++)
        fmpq_clear(q[k]);
    arb_clear(x);
    arb_clear(b);
    return regular;
}

/* ---- the bound ---- */

/* How surely the precisions tried do, from condition^2 of at most five columns: in 256 bits with a factor known to 2^-60 (condition up to 2^16), in 4096
 * at all (up to 2^800), or perhaps.  In balls a step of Cholesky's method makes what entries are off (1 + rho)^2 times as much at most, rho <= sqrt(condition)
 * a column's greatest entry over its pivot: four steps 2^8 condition^4.  It gets to its end where that, times 2^-4080 for the entries and roundings, is less
 * than 1 / condition.  The inverse of L by substitution loses sqrt(condition) 2^4 more, the inverse's Frobenius norm condition^2 and 2^6: 2^-250 times all
 * this is less than 2^-60 for condition^7 < 2^170. */
typedef enum { PERHAPS, SURELY, CLOSELY } sureness;

static sureness how_sure(const fmpq_t condition)
{
    sureness s = PERHAPS;
    fmpq_t most;

    fmpq_init(most);
    fmpq_one(most);
    fmpq_mul_2exp(most, most, 2 * 16);
    if (fmpq_cmp(condition, most) <= 0)
        s = CLOSELY;
    fmpq_mul_2exp(most, most, 2 * (800 - 16));
    if (s == PERHAPS && fmpq_cmp(condition, most) <= 0)
        s = SURELY;
    fmpq_clear(most);
    return s;
}

typedef struct {
    bool may, must;                       /* be proved */
    double least, most;                   /* the bound then */
} expectation;

/* (y . D - |N'y| factor 2 sum |D_c|) / max |y_c|, downwards, at least 0: with the factor as it is, and with one greater by 2^-60. */
static void weighed(expectation *e, const moved *p, const arb_t factor, const et_vec3 *data)
{
    arb_ptr s = _arb_vec_init(8);         /* D_c, |.|, their sum, y . D, the greatest, more */

    for (size_t c = 0; c < p->b.m->nov; c++) {
        set_data(s, data[c]);
        square_root_of_squares(s + 3, s, 3, BITS);
        arb_add(s + 4, s + 4, s + 3, BITS);
        for (size_t d = 0; d < 3; d++)
            arb_addmul(s + 5, s + d, p->y + 3 * c + d, BITS);
        square_root_of_squares(s + 3, p->y + 3 * c, 3, BITS);
        arb_max(s + 6, s + 6, s + 3, BITS);
    }
    arb_mul(s + 4, s + 4, factor, BITS);
    arb_mul(s + 4, s + 4, p->left, BITS);
    arb_mul_2exp_si(s + 4, s + 4, 1);
    arb_mul_2exp_si(s + 7, s + 4, -60);
    arb_sub(s + 5, s + 5, s + 4, BITS);
    arb_sub(s + 7, s + 5, s + 7, BITS);
    arb_div(s + 5, s + 5, s + 6, BITS);
    arb_div(s + 7, s + 7, s + 6, BITS);
    if (arb_is_finite(s + 5)) {
        arf_t above;

        arf_init(above);
        arb_get_ubound_arf(above, s + 5, BITS);
        e->most = fmax(arf_get_d(above, ARF_RND_FLOOR), 0);
        e->least = fmax(rounded(s + 7, ARF_RND_FLOOR), 0);
        arf_clear(above);
    }
    _arb_vec_clear(s, 8);
}

static bool expect(expectation *e, const double *y, const optimum_case *c, const optimum_model *m)
{
    moved p;
    arb_t factor;
    fmpq_t condition;
    double most = 0;
    int shift = 0;

    memset(e, 0, sizeof *e);
    for (size_t k = 0; k < 3 * m->nov; k++) {
        if (!isfinite(y[k]))
            return true;
        most = fmax(most, fabs(y[k]));
    }
    if (!move_begin(&p, m, NULL))
        return false;
    arb_init(factor);
    fmpq_init(condition);
    frexp(most, &shift);
    for (size_t k = 0; k < 3 * m->nov; k++) {
        arb_set_d(p.y + k, y[k]);
        arb_mul_2exp_si(p.y + k, p.y + k, -shift);
    }
    e->may = ((m->u.whole && m->v.whole) || (m->u.clamped && m->v.clamped)) && factor_of(factor, condition, m);
    e->must = e->may && how_sure(condition) != PERHAPS;
    if (e->may && most > 0) {
        make_left_small(&p, NULL);
        weighed(e, &p, factor, c->data);
        e->least = how_sure(condition) == CLOSELY ? e->least : 0;
    }
    arb_clear(factor);
    fmpq_clear(condition);
    move_end(&p);
    return true;
}

/* ---- drawing ---- */

static double hashed(size_t *seed)
{
    *seed = (*seed * 1103515245u + 12345u) & 0x7fffffffu;
    return (double)(*seed >> 7) * 0x1p-23 - 1;
}

/* Parameters of one direction or both within a tiny stretch of the domain but for the ends: 1 / sigma as great as it gets. */
static void crowd(gen *g, optimum_case *c)
{
    const int small = gen_chance(g, 6) ? -(int)gen_between(g, 600, 1070) : -(int)gen_between(g, 4, 50);
    const size_t which = gen_upto(g, 2);

    for (size_t i = 1; i + 1 < c->fit.data.nx && which != 1; i++)
        c->fit.s[0][i] = ldexp((double)i, small);
    for (size_t j = 1; j + 1 < c->fit.data.ny && which != 0; j++)
        c->fit.r[0][j] = ldexp((double)j, small);
    c->fit.s[0][0] = c->fit.r[0][0] = 0;
    c->fit.s[0][c->fit.data.nx - 1] = c->fit.r[0][c->fit.data.ny - 1] = 1;
    optimum_case_close(c);
}

static bool drawn(gen *g, optimum_case *c, optimum_model *m, double *y)
{
    const size_t kind = gen_upto(g, 5);
    const int scale = kind == 4 ? (int)gen_upto(g, 2000) - 1000 : 0;
    const double near = ldexp(1, -(int)gen_upto(g, 60));
    size_t seed = gen_upto(g, 0xffffff);

    if (!optimum_case_draw(g, c, (optimum_state)gen_upto(g, 3)))
        return false;
    if (gen_chance(g, 3))
        crowd(g, c);
    if (optimum_model_new(m, &c->fit) != ET_OK)
        return false;
    for (size_t k = 0; k < 3 * m->nov; k++)
        y[k] = kind == 5 ? near : ldexp(hashed(&seed), scale);
    if (gen_chance(g, 20))
        memset(y, 0, 3 * m->nov * sizeof *y);
    if (gen_chance(g, 20))
        y[gen_upto(g, 3 * m->nov - 1)] = gen_upto(g, 1) ? NAN : INFINITY;
    return true;
}

static bool alike(gen *g, const char *what, const double *a, const double *b, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (!gen_check(g, memcmp(a + k, b + k, sizeof *a) == 0 || (isnan(a[k]) && isnan(b[k])), "%s %zu: %a, not %a", what, k, a[k], b[k]))
            return false;
    return true;
}

/* A y that is nearly balanced, and equations four times too stiff: what is left of N'y does not shrink by half, and has to be paid for. */
static void hinder(gen *g, optimum_model *m, double *y)
{
    const int by = -(int)gen_between(g, 12, 40);
    size_t seed = gen_upto(g, 0xffff);

    for (size_t k = 0; k < 3 * m->nov; k++)
        y[k] = hashed(&seed);
    if (optimum_ball_polish(y, m, NULL) != ET_OK)
        return;
    for (size_t k = 0; k < 3 * m->nov; k++)
        y[k] += ldexp(hashed(&seed), by);
    for (size_t k = 0; k < m->start[m->nov]; k++)
        m->value[k] *= 4;
}

/* One case in 4. */
verdict prop_optimum_bound_ball(gen *g)
{
    optimum_case c;
    optimum_model m;
    expectation e;
    double y[3 * C + 1], lower = -1;
    int proved = -1;
    bool ok = drawn(g, &c, &m, y);

    if (!ok)
        return FAIL;
    if (gen_upto(g, 1))
        hinder(g, &m, y);
    y[3 * m.nov] = NAN;
    live_begin(gen_upto(g, 15));
    ok = optimum_ball_bound(&lower, &proved, y, &m, c.data) == ET_OK;
    ok = gen_check(g, live_end(), "memory not given back, or torn") && gen_check(g, ok, "status");
    ok = ok && gen_check(g, expect(&e, y, &c, &m), "not computed again");
    ok = ok && gen_check(g, proved == e.must || (proved == 1 && e.may), "proved: %d; it may be: %d, must be: %d", proved, e.may, e.must);
    ok = ok && gen_check(g, proved ? e.least <= lower && lower <= e.most : lower == 0, "lower: %a, not in [%a, %a]", lower, e.least, e.most);
    gen_label(g, !proved ? "nothing proved" : lower > 0 ? "a bound" : "no use");
    optimum_model_free(&m);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* Positive definite, with every entry of its own. */
static void draw_weight(double *weight, size_t nov, size_t seed)
{
    for (size_t c = 0; c < nov; c++)
        for (size_t k = 0; k < 6; k++)
            weight[6 * c + k] = (k == 0 || k == 3 || k == 5 ? 3 : 0) + hashed(&seed);
}

/* One case in 4. */
verdict prop_optimum_find_ball_polish(gen *g)
{
    optimum_case c;
    optimum_model m;
    moved p;
    double y[3 * C + 1], want[3 * C], weight[6 * C];
    bool ok = drawn(g, &c, &m, y), weighted = gen_upto(g, 1);

    if (!ok || !move_begin(&p, &m, NULL))
        return FAIL;
    move_end(&p);
    for (size_t k = 0; k < 3 * m.nov; k++)
        y[k] = isfinite(y[k]) ? y[k] : 1;
    y[3 * m.nov] = 7;
    draw_weight(weight, m.nov, gen_upto(g, 0xffff));
    ok = gen_check(g, move_begin(&p, &m, weighted ? weight : NULL), "not begun");
    for (size_t k = 0; k < 3 * m.nov && ok; k++)
        arb_set_d(p.y + k, y[k]);
    if (ok) {
        make_left_small(&p, weighted ? weight : NULL);
        for (size_t k = 0; k < 3 * m.nov; k++)
            want[k] = rounded(p.y + k, ARF_RND_NEAR);
        move_end(&p);
    }
    live_begin(gen_upto(g, 15));
    ok = optimum_ball_polish(y, &m, weighted ? weight : NULL) == ET_OK && ok;
    ok = gen_check(g, live_end(), "memory not given back, or torn") && gen_check(g, ok, "status");
    ok = ok && alike(g, "y", y, want, 3 * m.nov) && gen_check(g, y[3 * m.nov] == 7, "beyond the end");
    optimum_model_free(&m);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* Data anywhere, or on the surface, where only roundings are left of them. */
/* One case in 4. */
verdict prop_optimum_find_ball_value(gen *g)
{
    optimum_case c;
    optimum_model m;
    double y[3 * C + 1], r[3 * C + 1], s[3 * C], work[512], value = -1, want, alone = -1;
    bool ok = drawn(g, &c, &m, y);

    if (!ok)
        return FAIL;
    for (size_t k = 0; k < c.n && gen_upto(g, 1); k++)
        c.start[k] = c.start[0];
    optimum_case_close(&c);
    for (size_t k = 0, on = gen_upto(g, 1); k < c.nov && on; k++) {
        const et_index at = et_doublenet_index(c.fit.data, k + 1);
        const et_surface *const f = &c.fit.shell.view[at.k == 2];

        c.data[k] = et_surface_point(f, c.fit.s[0][at.i], c.fit.r[0][at.j], work, et_surface_work(f));
    }
    r[3 * c.nov] = 7;
    live_begin(gen_upto(g, 15));
    optimum_ball_value(&value, r, &c.fit, &m, c.data);
    optimum_ball_value(&alone, NULL, &c.fit, &m, c.data);
    ok = gen_check(g, live_end(), "memory not given back, or torn");
    want = value_of(s, &c, &m);
    ok = ok && alike(g, "value", &value, &want, 1) && alike(g, "value alone", &alone, &want, 1) && alike(g, "residual", r, s, 3 * c.nov);
    ok = ok && gen_check(g, r[3 * c.nov] == 7, "beyond the end");
    optimum_model_free(&m);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}

/* The basis functions and the table once more into arrays: nothing is kept. */
/* One case in 8. */
verdict prop_optimum_find_ball_axis(gen *g)
{
    optimum_case c;
    optimum_model m;
    double y[3 * C + 1];
    bool ok = drawn(g, &c, &m, y);
    optimum_axis *const axes[2] = {&m.u, &m.v};

    for (size_t k = 0; k < 2 && ok; k++) {
        optimum_axis *const a = axes[k];
        arb_ptr part = _arb_vec_init((slong)a->p + 1);

        if (a->change != NULL) {
            live_begin(0);
            optimum_ball_table(a);
            ok = gen_check(g, live_end(), "table: memory not given back, or torn");
        }
        live_begin(0);
        optimum_ball_axis(a);
        ok = gen_check(g, live_end(), "axis: memory not given back, or torn") && ok;
        for (size_t i = 0; i < a->nt && ok; i++) {
            row(part, a, a->t[i], BITS);
            for (size_t j = 0; j <= a->p && ok; j++) {
                const double want = rounded(part + j, ARF_RND_NEAR);

                ok = alike(g, "value", a->value + i * (a->p + 1) + j, &want, 1);
            }
        }
        _arb_vec_clear(part, (slong)a->p + 1);
    }
    optimum_model_free(&m);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}
