/* What is proved in balls, a second time from its formulas, operation by operation: the same balls, so the same bounds bit for bit, also where what is
 * left of N'y counts.  And what balls take they give back. */
#include "etalon/refine/optimum.h"
#include "exact/live.h"
#include "refine/optimum_cases.h"
#include "refine/optimum_parts.h"
#include <arb.h>
#include <arb_mat.h>
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

/* ---- |P*| and the bound ---- */

/* 1 / sigma at most, of the columns kept; inner: without the first and last column and parameter. */
static bool inverse_of(arb_t out, const optimum_axis *a, arb_srcptr N, bool inner, slong bits)
{
    size_t column[C], n = 0;
    arb_mat_t gram;
    bool ok;

    for (size_t j = 0; j < a->n; j++)
        if (a->keep[j] && !(inner && (j == 0 || j + 1 == a->n)))
            column[n++] = j;
    arb_mat_init(gram, (slong)n, (slong)n);
    for (size_t k = 0; k < n; k++)
        for (size_t l = 0; l < n; l++)
            for (size_t i = inner; i + inner < a->nt; i++)
                if (column[k] >= a->first[i] && column[k] <= a->first[i] + a->p && column[l] >= a->first[i] && column[l] <= a->first[i] + a->p)
                    arb_addmul(arb_mat_entry(gram, k, l), N + i * a->n + column[k], N + i * a->n + column[l], bits);
    ok = n == 0 || arb_mat_spd_inv(gram, gram, bits);
    if (ok) {
        arb_mat_frobenius_norm(out, gram, bits);
        arb_sqrtpos(out, out, bits);
        ok = arb_is_finite(out);
    }
    arb_mat_clear(gram);
    return ok;
}

/* |B| + |T|, with |B| <= |U|' |V|' and |T| <= (1 + |U| |V| |B|) |U inner|' |V inner|'. */
static bool factor_of(arb_t factor, const optimum_model *m, slong bits)
{
    bases b = bases_of(m, true, bits);
    arb_ptr s = _arb_vec_init(6);
    const bool ok = inverse_of(s, &m->u, b.u, false, bits) && inverse_of(s + 1, &m->v, b.v, false, bits) && inverse_of(s + 2, &m->u, b.u, true, bits) &&
                    inverse_of(s + 3, &m->v, b.v, true, bits);

    square_root_of_squares(s + 4, b.u, m->u.nt * m->u.n, bits);
    square_root_of_squares(s + 5, b.v, m->v.nt * m->v.n, bits);
    arb_mul(s, s, s + 1, bits);
    arb_mul(s + 4, s + 4, s + 5, bits);
    arb_one(factor);
    arb_addmul(factor, s + 4, s, bits);
    arb_mul(factor, factor, s + 2, bits);
    arb_mul(factor, factor, s + 3, bits);
    arb_add(factor, factor, s, bits);
    _arb_vec_clear(s, 6);
    bases_end(&b);
    return ok;
}

/* (y . D - |N'y| factor 2 sum |D_c|) / max |y_c|, downwards, at least 0. */
static double weighed(const moved *p, const arb_t factor, const et_vec3 *data)
{
    arb_ptr s = _arb_vec_init(7);         /* D_c, |.|, their sum, y . D, the greatest */
    double lower = 0;

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
    arb_sub(s + 5, s + 5, s + 4, BITS);
    arb_div(s + 5, s + 5, s + 6, BITS);
    if (arb_is_finite(s + 5))
        lower = fmax(rounded(s + 5, ARF_RND_FLOOR), 0);
    _arb_vec_clear(s, 7);
    return lower;
}

static bool bound_of(double *lower, int *proved, const double *y, const optimum_case *c, const optimum_model *m)
{
    moved p;
    arb_t factor;
    double most = 0;
    int shift = 0;

    *lower = *proved = 0;
    for (size_t k = 0; k < 3 * m->nov; k++) {
        if (!isfinite(y[k]))
            return true;
        most = fmax(most, fabs(y[k]));
    }
    if (!move_begin(&p, m, NULL))
        return false;
    arb_init(factor);
    frexp(most, &shift);
    for (size_t k = 0; k < 3 * m->nov; k++) {
        arb_set_d(p.y + k, y[k]);
        arb_mul_2exp_si(p.y + k, p.y + k, -shift);
    }
    for (slong bits = BITS; bits <= 4096 && !*proved; bits *= 4)
        *proved = ((m->u.whole && m->v.whole) || (m->u.clamped && m->v.clamped)) && factor_of(factor, m, bits);
    if (*proved && most > 0) {
        make_left_small(&p, NULL);
        *lower = weighed(&p, factor, c->data);
    }
    arb_clear(factor);
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
    double y[3 * C + 1], lower = -1, want = -2;
    int proved = -1, expected = -2;
    bool ok = drawn(g, &c, &m, y);

    if (!ok)
        return FAIL;
    if (gen_upto(g, 1))
        hinder(g, &m, y);
    y[3 * m.nov] = NAN;
    live_begin(gen_upto(g, 15));
    ok = optimum_ball_bound(&lower, &proved, y, &m, c.data) == ET_OK;
    ok = gen_check(g, live_end(), "memory not given back, or torn") && gen_check(g, ok, "status");
    ok = ok && gen_check(g, bound_of(&want, &expected, y, &c, &m), "not computed again");
    ok = ok && gen_check(g, proved == expected, "proved: %d, not %d", proved, expected) && alike(g, "lower", &lower, &want, 1);
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
