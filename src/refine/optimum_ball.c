/* What is proved: sums and projections in ball arithmetic (Arb).  Here N is the matrix of the exact basis functions at the given knots and parameters. */
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include "refine/optimum_parts.h"
#include <arb.h>
#include <arb_mat.h>
#include <math.h>
#include <stdlib.h>

enum { BITS = 256,                        /* of precision */
       MOST_BITS = 4096, STEPS = 64 };    /* of precision, and of a projection, at most */

/* The basis functions of both directions, [t][p+1], columns as they are or times 2^shift. */
typedef struct {
    arb_ptr u, v;
    slong bits;
} basis;

/* ---- basis functions ---- */

/* A2.2 in balls: positive terms only, so that each value is known to nearly all bits. */
static void axis_row(arb_ptr N, const optimum_axis *a, size_t i, slong bits)
{
    const double t = fmin(fmax(a->t[i], a->knots[a->p]), a->knots[a->n]);
    const size_t span = et_knots_span(a->knots, a->n + a->p + 1, a->p, t);
    arb_t x, left, right, saved, term;

    arb_init(x);
    arb_init(left);
    arb_init(right);
    arb_init(saved);
    arb_init(term);
    arb_one(N);
    for (size_t j = 1; j <= a->p; j++) {
        arb_zero(saved);
        for (size_t r = 0; r < j; r++) {
            arb_set_d(x, t);
            arb_set_d(right, a->knots[span + r + 1]);
            arb_sub(right, right, x, bits);
            arb_set_d(left, a->knots[span + 1 + r - j]);
            arb_sub(left, x, left, bits);
            arb_add(x, right, left, bits);
            arb_div(term, N + r, x, bits);
            arb_mul(right, right, term, bits);
            arb_add(N + r, saved, right, bits);
            arb_mul(saved, left, term, bits);
        }
        arb_set(N + j, saved);
    }
    arb_clear(x);
    arb_clear(left);
    arb_clear(right);
    arb_clear(saved);
    arb_clear(term);
}

static void axis_fill(arb_ptr N, const optimum_axis *a, int shifted, slong bits)
{
    const size_t w = a->p + 1;

    for (size_t i = 0; i < a->nt; i++) {
        axis_row(N + i * w, a, i, bits);
        for (size_t k = 0; k < w; k++) {
            if (a->value[i * w + k] == 0)
                arb_zero(N + i * w + k);
            else if (shifted)
                arb_mul_2exp_si(N + i * w + k, N + i * w + k, a->shift[a->first[i] + k]);
        }
    }
}

static slong axis_terms(const optimum_axis *a)
{
    return (slong)(a->nt * (a->p + 1));
}

static void basis_init(basis *b, const optimum_model *m, int shifted, slong bits)
{
    b->bits = bits;
    b->u = _arb_vec_init(axis_terms(&m->u));
    b->v = _arb_vec_init(axis_terms(&m->v));
    axis_fill(b->u, &m->u, shifted, bits);
    axis_fill(b->v, &m->v, shifted, bits);
}

static void basis_clear(basis *b, const optimum_model *m)
{
    _arb_vec_clear(b->u, axis_terms(&m->u));
    _arb_vec_clear(b->v, axis_terms(&m->v));
}

/* ---- rounding ---- */

static double upwards(const arb_t x)
{
    arf_t a;
    double d;

    arf_init(a);
    arb_get_ubound_arf(a, x, BITS);
    d = arf_get_d(a, ARF_RND_CEIL);
    arf_clear(a);
    return d;
}

static double downwards(const arb_t x)
{
    arf_t a;
    double d;

    arf_init(a);
    arb_get_lbound_arf(a, x, BITS);
    d = arf_get_d(a, ARF_RND_FLOOR);
    arf_clear(a);
    return d;
}

static double nearest(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

/* ---- for the model ---- */

void optimum_ball_axis(optimum_axis *axis)
{
    const size_t w = axis->p + 1;
    arb_ptr row = _arb_vec_init((slong)w);

    for (size_t i = 0; i < axis->nt; i++) {
        axis_row(row, axis, i, BITS);
        for (size_t k = 0; k < w; k++)
            axis->value[i * w + k] = nearest(row + k);
    }
    _arb_vec_clear(row, (slong)w);
}

void optimum_ball_table(optimum_axis *axis)
{
    const size_t w = axis->p + 1, n = axis->n;
    arb_ptr row = _arb_vec_init(axis_terms(axis)), s = _arb_vec_init(2);

    axis_fill(row, axis, 1, BITS);
    for (size_t i = 0; i < axis->nt; i++)
        for (size_t j = 0; j < n; j++) {
            arb_zero(s);
            for (size_t k = 0; k < w; k++)
                if (axis->keep[axis->first[i] + k]) {
                    arb_set_d(s + 1, axis->change[(axis->first[i] + k) * n + j]);
                    arb_addmul(s, row + i * w + k, s + 1, BITS);
                }
            axis->table[i * n + j] = nearest(s);
        }
    _arb_vec_clear(row, axis_terms(axis));
    _arb_vec_clear(s, 2);
}

/* ---- E ---- */

static void set_point(arb_ptr x, et_vec3 p)
{
    arb_set_d(x, p.x);
    arb_set_d(x + 1, p.y);
    arb_set_d(x + 2, p.z);
}

/* r[3] = D_c - S_c. */
static void residual(arb_ptr r, const et_fit *fit, const optimum_model *m, const basis *b, et_vec3 data, size_t c, arb_ptr point, arb_t weight)
{
    const et_index node = m->node[c];
    const et_surface *const s = &fit->shell.view[node.k == 2 ? ET_TOP : ET_BOTTOM];
    const size_t wu = m->u.p + 1, wv = m->v.p + 1;

    set_point(r, data);
    for (size_t k = 0; k < wu; k++)
        for (size_t l = 0; l < wv; l++) {
            arb_mul(weight, b->u + node.i * wu + k, b->v + node.j * wv + l, b->bits);
            set_point(point, s->points[(m->u.first[node.i] + k) * s->nv + m->v.first[node.j] + l]);
            for (int d = 0; d < 3; d++)
                arb_submul(r + d, weight, point + d, b->bits);
        }
}

/* length = |r|. */
static void euclid(arb_t length, arb_srcptr r, slong bits)
{
    arb_t square;

    arb_init(square);
    arb_mul(square, r, r, bits);
    arb_addmul(square, r + 1, r + 1, bits);
    arb_addmul(square, r + 2, r + 2, bits);
    arb_sqrtpos(length, square, bits);
    arb_clear(square);
}

void optimum_ball_value(double *value, double *r, const et_fit *fit, const optimum_model *model, const et_vec3 *data)
{
    arb_ptr s = _arb_vec_init(9);         /* r, point, length, sum, weight */
    basis b;

    basis_init(&b, model, 0, BITS);
    for (size_t c = 0; c < model->nov; c++) {
        residual(s, fit, model, &b, data[c], c, s + 3, s + 8);
        for (size_t d = 0; d < 3 && r != NULL; d++)
            r[3 * c + d] = nearest(s + d);
        euclid(s + 6, s, BITS);
        arb_add(s + 7, s + 7, s + 6, BITS);
    }
    *value = upwards(s + 7);
    basis_clear(&b, model);
    _arb_vec_clear(s, 9);
}

/* ---- N and N' ---- */

typedef struct {
    const optimum_model *m;
    basis b;
    arb_ptr y, x, s;                      /* 3 nov; 3 m; 3 to work with */
    optimum_solver solver;
    double *z, *f, *w, *one;              /* 3 m, 3 m, 3 nov; nov ones */
} projection;

static void projection_clear(projection *p)
{
    basis_clear(&p->b, p->m);
    _arb_vec_clear(p->y, (slong)(3 * p->m->nov));
    _arb_vec_clear(p->x, (slong)(3 * p->m->m));
    _arb_vec_clear(p->s, 3);
    optimum_solve_free(&p->solver);
    free(p->z);
    free(p->f);
    free(p->w);
    free(p->one);
}

/* weight: 3 x 3 blocks, or null for ones. */
static et_status projection_init(projection *p, const optimum_model *m, const double *weight)
{
    const et_status status = optimum_solve_new(&p->solver, m, weight != NULL);

    p->m = m;
    basis_init(&p->b, m, 1, BITS);
    p->y = _arb_vec_init((slong)(3 * m->nov));
    p->x = _arb_vec_init((slong)(3 * m->m));
    p->s = _arb_vec_init(3);
    p->z = et_size_array(m->m, 3 * sizeof *p->z);
    p->f = et_size_array(m->m, 3 * sizeof *p->f);
    p->w = et_size_array(m->nov, 3 * sizeof *p->w);
    p->one = et_size_array(m->nov, sizeof *p->one);
    if (status != ET_OK || !p->z || !p->f || !p->w || !p->one) {
        projection_clear(p);
        return ET_ENOMEM;
    }
    for (size_t c = 0; c < m->nov; c++)
        p->one[c] = 1;
    optimum_solve_factor(&p->solver, weight ? weight : p->one);
    return ET_OK;
}

/* x = N'y; *size = an upper bound of |x|. */
static void adjoint(arb_t size, projection *p)
{
    const optimum_model *const m = p->m;
    const size_t wu = m->u.p + 1, wv = m->v.p + 1;

    _arb_vec_zero(p->x, (slong)(3 * m->m));
    for (size_t c = 0; c < m->nov; c++)
        for (size_t k = 0; k < wu; k++)
            for (size_t l = 0; l < wv; l++) {
                const et_index node = m->node[c];
                const size_t at = optimum_model_place(m, node.k == 2, m->u.first[node.i] + k, m->v.first[node.j] + l);

                if (at == SIZE_MAX)
                    continue;
                arb_mul(p->s, p->b.u + node.i * wu + k, p->b.v + node.j * wv + l, p->b.bits);
                for (size_t d = 0; d < 3; d++)
                    arb_addmul(p->x + 3 * at + d, p->s, p->y + 3 * c + d, p->b.bits);
            }
    arb_zero(size);
    for (size_t k = 0; k < 3 * m->m; k++)
        arb_addmul(size, p->x + k, p->x + k, p->b.bits);
    arb_sqrtpos(size, size, p->b.bits);
    arb_get_ubound_arf(arb_midref(size), size, p->b.bits);
    mag_zero(arb_radref(size));
}

/* y -= W N z with N'WN z = N'y, again and again until N'y shrinks no more: it is then zero but for the roundings of y.  The correction may be any:
 * what is left of N'y is seen in balls each time.  size: a bound of what is left. */
static void project(arb_t size, projection *p, const double *weight)
{
    const optimum_model *const m = p->m;
    arb_t before;

    arb_init(before);
    adjoint(size, p);
    for (size_t step = 0; step < STEPS && !arb_is_zero(size); step++) {
        for (size_t k = 0; k < 3 * m->m; k++)
            p->f[k] = nearest(p->x + k);
        optimum_model_forces(p->z, m, p->f);
        optimum_solve_run(&p->solver, p->z, 0x1p-40);
        optimum_solve_take(p->z, p->w, &p->solver);
        for (size_t c = 0; c < m->nov; c++) {
            const double *const h = weight ? weight + 6 * c : NULL, *const w = p->w + 3 * c;
            const double by_block[3] = {h ? h[0] * w[0] + h[1] * w[1] + h[2] * w[2] : w[0], h ? h[1] * w[0] + h[3] * w[1] + h[4] * w[2] : w[1],
                                        h ? h[2] * w[0] + h[4] * w[1] + h[5] * w[2] : w[2]};

            for (size_t d = 0; d < 3; d++) {
                arb_set_d(p->s, by_block[d]);
                arb_sub(p->y + 3 * c + d, p->y + 3 * c + d, p->s, p->b.bits);
            }
        }
        arb_set(before, size);
        adjoint(size, p);
        arb_mul_2exp_si(p->s, size, 1);
        if (!arb_lt(p->s, before))
            break;
    }
    arb_clear(before);
}

et_status optimum_ball_polish(double *y, const optimum_model *model, const double *weight)
{
    projection p;
    arb_t size;
    const et_status status = projection_init(&p, model, weight);

    if (status != ET_OK)
        return status;
    arb_init(size);
    for (size_t k = 0; k < 3 * model->nov; k++)
        arb_set_d(p.y + k, y[k]);
    project(size, &p, weight);
    for (size_t k = 0; k < 3 * model->nov; k++)
        y[k] = nearest(p.y + k);
    arb_clear(size);
    projection_clear(&p);
    return ET_OK;
}

/* ---- how long a least P can be ---- */

/* *inverse >= |A x|-to-|x|: an upper bound of 1 / the least singular value of the columns kept, or, inner, of the columns kept but the first and
 * the last at the parameters but the first and the last.  0 if none is found: the columns may be dependent.  at: room for a->n. */
static int axis_inverse(arb_t inverse, const optimum_axis *a, arb_srcptr N, int inner, slong bits, size_t *at)
{
    const size_t w = a->p + 1;
    size_t n = 0;
    arb_mat_t gram;
    int found = 1;

    for (size_t j = 0; j < a->n; j++)
        at[j] = a->keep[j] && !(inner && (j == 0 || j == a->n - 1)) ? n++ : SIZE_MAX;
    arb_mat_init(gram, (slong)n, (slong)n);
    for (size_t i = inner ? 1 : 0; i < a->nt - (inner ? 1 : 0); i++)
        for (size_t k = 0; k < w; k++)
            for (size_t l = 0; l < w; l++) {
                const size_t c = at[a->first[i] + k], d = at[a->first[i] + l];

                if (c != SIZE_MAX && d != SIZE_MAX)
                    arb_addmul(arb_mat_entry(gram, c, d), N + i * w + k, N + i * w + l, bits);
            }
    if (n > 0)
        found = arb_mat_spd_inv(gram, gram, bits);
    if (found) {
        arb_mat_frobenius_norm(inverse, gram, bits);
        arb_sqrtpos(inverse, inverse, bits);
        found = arb_is_finite(inverse);
    }
    arb_mat_clear(gram);
    return found;
}

static void axis_norm(arb_t size, const optimum_axis *a, arb_srcptr N, slong bits)
{
    arb_zero(size);
    for (slong k = 0; k < axis_terms(a); k++)
        arb_addmul(size, N + k, N + k, bits);
    arb_sqrtpos(size, size, bits);
}

/* With |N X| <= 1: |X| <= factor.  X is the bottom view's net B and the top's inner nodes T.  |B| <= |U B V'| / (sigma_u sigma_v), and
 * |T| <= (|N X| + |U| |V| |B|) / (sigma_u' sigma_v'), sigma' those of inner columns at inner parameters. */
static int reach_of(arb_t factor, const optimum_model *m, slong bits, size_t *at)
{
    basis b;
    arb_ptr s = _arb_vec_init(6);
    int found;

    basis_init(&b, m, 1, bits);
    found = axis_inverse(s, &m->u, b.u, 0, bits, at) && axis_inverse(s + 1, &m->v, b.v, 0, bits, at) && axis_inverse(s + 2, &m->u, b.u, 1, bits, at) &&
            axis_inverse(s + 3, &m->v, b.v, 1, bits, at);
    axis_norm(s + 4, &m->u, b.u, bits);
    axis_norm(s + 5, &m->v, b.v, bits);
    arb_mul(s, s, s + 1, bits);
    arb_mul(s + 4, s + 4, s + 5, bits);
    arb_one(factor);
    arb_addmul(factor, s + 4, s, bits);
    arb_mul(factor, factor, s + 2, bits);
    arb_mul(factor, factor, s + 3, bits);
    arb_add(factor, factor, s, bits);
    basis_clear(&b, m);
    _arb_vec_clear(s, 6);
    return found;
}

/* Where control points stay aside, the range must be that of the others: it is where only zero columns stay aside, and where the ends see the first
 * and the last control points alone, for then N has the rank of the smaller double net. */
static int find_reach(arb_t factor, const optimum_model *m, size_t *at)
{
    if (!(m->u.whole && m->v.whole) && !(m->u.clamped && m->v.clamped))
        return 0;
    for (slong bits = BITS; bits <= MOST_BITS; bits *= 4)
        if (reach_of(factor, m, bits, at))
            return 1;
    return 0;
}

/* ---- the bound ---- */

/* lower <= (y . D - |N'y| |P*|) / max |y_c|, with |N P*| <= |D| + E(P*) <= 2 sum |D_c|. */
static double weigh(projection *p, const arb_t left, const arb_t factor, const et_vec3 *data)
{
    arb_ptr s = _arb_vec_init(8);         /* point, product, length, most, sum of lengths, product's sum */
    const slong bits = p->b.bits;
    double lower;

    for (size_t c = 0; c < p->m->nov; c++) {
        set_point(s, data[c]);
        euclid(s + 4, s, bits);
        arb_add(s + 6, s + 6, s + 4, bits);
        for (size_t d = 0; d < 3; d++)
            arb_addmul(s + 7, s + d, p->y + 3 * c + d, bits);
        euclid(s + 4, p->y + 3 * c, bits);
        arb_max(s + 5, s + 5, s + 4, bits);
    }
    arb_mul(s + 6, s + 6, factor, bits);
    arb_mul(s + 6, s + 6, left, bits);
    arb_mul_2exp_si(s + 6, s + 6, 1);
    arb_sub(s + 7, s + 7, s + 6, bits);
    arb_div(s + 7, s + 7, s + 5, bits);
    lower = arb_is_finite(s + 7) ? downwards(s + 7) : 0;
    _arb_vec_clear(s, 8);
    return lower > 0 ? lower : 0;
}

static int all_finite(const double *y, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (!isfinite(y[k]))
            return 0;
    return 1;
}

et_status optimum_ball_bound(double *lower, int *proved, const double *y, const optimum_model *model, const et_vec3 *data)
{
    projection p;
    arb_t left, factor;
    double most = 0;
    size_t *at;
    et_status status;
    int shift = 0;

    *lower = 0;
    *proved = 0;
    if (!all_finite(y, 3 * model->nov))
        return ET_OK;
    at = et_size_array(model->u.n > model->v.n ? model->u.n : model->v.n, sizeof *at);
    status = at ? projection_init(&p, model, NULL) : ET_ENOMEM;
    if (status != ET_OK) {
        free(at);
        return status;
    }
    arb_init(left);
    arb_init(factor);
    for (size_t k = 0; k < 3 * model->nov; k++)
        most = fmax(most, fabs(y[k]));
    frexp(most, &shift);
    for (size_t k = 0; k < 3 * model->nov; k++) {
        arb_set_d(p.y + k, y[k]);
        arb_mul_2exp_si(p.y + k, p.y + k, -shift);
    }
    *proved = find_reach(factor, model, at);
    if (*proved && most > 0) {
        project(left, &p, NULL);
        *lower = weigh(&p, left, factor, data);
    }
    arb_clear(left);
    arb_clear(factor);
    projection_clear(&p);
    free(at);
    return ET_OK;
}
