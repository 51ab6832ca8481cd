/* The linear part of the optimum, from inside: places, terms, N and N', the change of basis, N'WN.  Each is computed again from its definition. */
#include "etalon/refine/optimum.h"
#include "refine/optimum_cases.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NODES = 2 * OPTIMUM_MOST * OPTIMUM_MOST, TERMS = OPTIMUM_CLASSES * OPTIMUM_MOST * OPTIMUM_MOST };

typedef struct {
    optimum_axis u, v;
    size_t nu, nv, m, half;
    unsigned char drop[NODES];
    size_t place[NODES], start[OPTIMUM_CLASSES + 1], at[TERMS];
    double value[TERMS];
} expected;

static double factor(const optimum_axis *a, size_t t, size_t j)
{
    if (a->table != NULL)
        return a->table[t * a->n + j];
    return j < a->first[t] || j > a->first[t] + a->p ? 0 : a->value[t * (a->p + 1) + j - a->first[t]];
}

/* The node that stands for k: of the border the bottom view's. */
static size_t stands_for(const expected *e, size_t k)
{
    const size_t i = k / e->nv % e->nu, j = k % e->nv;

    return i == 0 || j == 0 || i + 1 == e->nu || j + 1 == e->nv ? i * e->nv + j : k;
}

static bool counts(const expected *e, size_t k)
{
    return stands_for(e, k) == k && e->u.keep[k / e->nv % e->nu] && e->v.keep[k % e->nv] && !e->drop[k];
}

static size_t turn_of(const expected *e, size_t k, bool rows)
{
    const size_t i = k / e->nv % e->nu, j = k % e->nv, view = k / (e->nu * e->nv);

    return (rows ? i * e->nv + j : j * e->nu + i) * 2 + view;
}

/* A node's place: how many that count come before it. */
static void expect_places(expected *e, bool rows)
{
    const size_t n = 2 * e->nu * e->nv;

    e->m = 0;
    for (size_t k = 0; k < n; k++) {
        const size_t own = stands_for(e, k);

        e->m += counts(e, k);
        e->place[k] = counts(e, own) ? 0 : SIZE_MAX;
        for (size_t other = 0; other < n && e->place[k] != SIZE_MAX; other++)
            e->place[k] += counts(e, other) && turn_of(e, other, rows) < turn_of(e, own, rows);
    }
}

static void expect_terms(expected *e, const optimum_case *c, bool rows)
{
    size_t n = 0;

    expect_places(e, rows);
    e->half = 0;
    for (size_t k = 0; k < c->nov; k++) {
        const et_index node = et_doublenet_index(c->fit.data, k + 1);

        e->start[k] = n;
        for (size_t i = 0; i < e->nu; i++)
            for (size_t j = 0; j < e->nv; j++) {
                const double value = factor(&e->u, node.i, i) * factor(&e->v, node.j, j);
                const size_t at = e->place[((node.k == 2 ? 1 : 0) * e->nu + i) * e->nv + j];

                if (value == 0 || at == SIZE_MAX)
                    continue;
                e->at[n] = at;
                e->value[n++] = value;
            }
        for (size_t a = e->start[k]; a < n; a++)
            for (size_t b = e->start[k]; b < n; b++)
                e->half = e->at[a] > e->at[b] && e->at[a] - e->at[b] > e->half ? e->at[a] - e->at[b] : e->half;
    }
    e->start[c->nov] = n;
}

/* The narrower of both orders, rows if they are alike. */
static void expect_narrow(expected *e, const optimum_case *c)
{
    size_t by_rows;

    expect_terms(e, c, true);
    by_rows = e->half;
    expect_terms(e, c, false);
    if (by_rows <= e->half)
        expect_terms(e, c, true);
}

/* Nodes that seem to depend on those before; whether there are any. */
static bool expect_drop(expected *e, const optimum_case *c)
{
    optimum_band band;
    unsigned char poor[NODES + OPTIMUM_SIDE] = {0};
    bool any = false;

    if (optimum_band_new(&band, e->m, e->half) != ET_OK)
        return false;
    optimum_band_clear(&band);
    for (size_t k = 0; k < c->nov; k++)
        for (size_t a = e->start[k]; a < e->start[k + 1]; a++)
            for (size_t b = e->start[k]; b < e->start[k + 1]; b++)
                if (e->at[a] >= e->at[b])
                    *optimum_band_at(&band, e->at[a], e->at[b]) += e->value[a] * e->value[b];
    optimum_band_factor(&band, poor);
    for (size_t k = 0; k < 2 * e->nu * e->nv; k++)
        if (e->place[k] != SIZE_MAX && poor[e->place[k]]) {
            e->drop[k] = 1;
            any = true;
        }
    optimum_band_free(&band);
    return any;
}

/* dropped: whether any node was.  which: the direction whose basis is changed, or -1. */
static bool expect(expected *e, int *which, bool *dropped, const optimum_case *c)
{
    const et_surface *const s = &c->fit.shell.view[ET_BOTTOM];
    bool ok;

    memset(e, 0, sizeof *e);
    e->nu = s->nu;
    e->nv = s->nv;
    *which = -1;
    *dropped = false;
    ok = optimum_axis_new(&e->u, s->u, s->nu, s->p, c->fit.s[0], c->fit.data.nx) == ET_OK;
    ok = optimum_axis_new(&e->v, s->v, s->nv, s->q, c->fit.r[0], c->fit.data.ny) == ET_OK && ok;
    if (!ok)
        return false;
    if (e->u.clamped && e->v.clamped) {
        ok = optimum_axis_change(which, &e->u, &e->v) == ET_OK;
    } else {
        optimum_axis_keep_all(&e->u);
        optimum_axis_keep_all(&e->v);
    }
    if (*which >= 0) {
        expect_terms(e, c, *which == 1);
        return ok;
    }
    expect_narrow(e, c);
    *dropped = expect_drop(e, c);
    expect_narrow(e, c);
    return ok;
}

static void end(expected *e)
{
    optimum_axis_free(&e->u);
    optimum_axis_free(&e->v);
}

static bool same_axis(gen *g, const optimum_axis *a, const optimum_axis *b)
{
    return gen_check(g, a->n == b->n && a->p == b->p && a->nt == b->nt && a->knots == b->knots && a->t == b->t, "an axis' sizes") &&
           gen_check(g, memcmp(a->first, b->first, a->nt * sizeof *a->first) == 0, "an axis' first") &&
           gen_check(g, optimum_case_same(a->value, b->value, a->nt * (a->p + 1)), "an axis' values") &&
           gen_check(g, memcmp(a->keep, b->keep, a->n) == 0, "an axis' columns") &&
           gen_check(g, (a->change == NULL) == (b->change == NULL) && (a->table == NULL) == (b->table == NULL), "an axis' basis") &&
           gen_check(g, a->change == NULL || optimum_case_same(a->change, b->change, a->n * a->n), "an axis' T") &&
           gen_check(g, a->table == NULL || optimum_case_same(a->table, b->table, a->n * a->nt), "an axis' table");
}

static bool same_model(gen *g, const optimum_model *m, const expected *e, const optimum_case *c, bool dropped)
{
    bool ok = same_axis(g, &m->u, &e->u) && same_axis(g, &m->v, &e->v);

    ok = ok && gen_check(g, m->data.nx == c->fit.data.nx && m->data.ny == c->fit.data.ny && m->control.nx == e->nu && m->control.ny == e->nv, "nets");
    ok = ok &&
         gen_check(g, m->nov == c->nov && m->m == e->m && m->half == e->half, "%zu places, not %zu; half %zu, not %zu", m->m, e->m, m->half, e->half);
    ok = ok && gen_check(g, m->u.clamped == (e->u.clamped && !dropped) && m->u.whole == (e->u.whole && !dropped), "what is proved of u") &&
         gen_check(g, m->v.clamped == e->v.clamped && m->v.whole == e->v.whole, "what is proved of v");
    for (size_t k = 0; k < 2 * e->nu * e->nv && ok; k++)
        ok = gen_check(g, m->place[k] == e->place[k] && m->drop[k] == e->drop[k], "node %zu at %zu, not %zu", k, m->place[k], e->place[k]) &&
             gen_check(g, optimum_model_place(m, k / (e->nu * e->nv), k / e->nv % e->nu, k % e->nv) == e->place[k], "node %zu", k);
    ok = ok && gen_check(g, memcmp(m->start, e->start, (c->nov + 1) * sizeof *e->start) == 0, "starts");
    ok = ok && gen_check(g, memcmp(m->at, e->at, e->start[c->nov] * sizeof *e->at) == 0, "terms' places");
    ok = ok && gen_check(g, optimum_case_same(m->value, e->value, e->start[c->nov]), "terms");
    for (size_t k = 0; k < c->nov && ok; k++) {
        const et_index node = et_doublenet_index(c->fit.data, k + 1);

        ok = gen_check(g, m->node[k].k == node.k && m->node[k].i == node.i && m->node[k].j == node.j, "node of class %zu", k + 1);
    }
    return ok;
}

/* N x and N'y, term by term. */
static bool same_products(gen *g, const optimum_model *m, const expected *e, size_t nov)
{
    double x[3 * NODES], r[3 * OPTIMUM_CLASSES], s[3 * OPTIMUM_CLASSES], y[3 * NODES], z[3 * NODES] = {0};
    bool ok;

    for (size_t k = 0; k < 3 * e->m; k++)
        x[k] = y[k] = gen_real(g, -1, 1);
    for (size_t k = 0; k < 3 * nov; k++)
        r[k] = s[k] = gen_real(g, -1, 1);
    for (size_t d = 0; d < 3; d++)
        for (size_t c = 0; c < nov; c++)
            for (size_t k = e->start[c]; k < e->start[c + 1]; k++) {
                z[3 * e->at[k] + d] += e->value[k] * r[3 * c + d];
                s[3 * c + d] -= e->value[k] * x[3 * e->at[k] + d];
            }
    optimum_model_adjoint(y, m, r);
    optimum_model_apply(r, m, x);
    ok = gen_check(g, optimum_case_same(r, s, 3 * nov), "D - N x") && gen_check(g, optimum_case_same(y, z, 3 * e->m), "N'y");
    return ok;
}

/* T's entry between two nodes; 0 where they are not in one line of the direction that is changed. */
static double entry(const expected *e, size_t k, size_t other)
{
    const size_t i = k / e->nv % e->nu, j = k % e->nv, oi = other / e->nv % e->nu, oj = other % e->nv;

    if (k / (e->nu * e->nv) != other / (e->nu * e->nv) || (e->u.change == NULL && i != oi) || (e->v.change == NULL && j != oj))
        return 0;
    return e->u.change ? e->u.change[i * e->nu + oi] : e->v.change ? e->v.change[j * e->nv + oj] : 1;
}

/* T z, correctly rounded, and T'x in the nodes' order. */
static bool same_change(gen *g, const optimum_model *m, const expected *e)
{
    double z[3 * NODES], got[3 * NODES], want[3 * NODES] = {0};
    const size_t n = 2 * e->nu * e->nv;
    arb_ptr s = _arb_vec_init(3);
    bool ok = true;

    for (size_t k = 0; k < 3 * e->m; k++)
        z[k] = gen_real(g, -1, 1);
    optimum_model_points(got, m, z);
    for (size_t k = 0; k < n && ok; k++)
        for (size_t d = 0; d < 3 && ok && counts(e, k); d++) {
            arb_zero(s);
            for (size_t other = 0; other < n; other++)
                if (entry(e, k, other) != 0 && e->place[other] != SIZE_MAX) {
                    arb_set_d(s + 1, entry(e, k, other));
                    arb_set_d(s + 2, z[3 * e->place[other] + d]);
                    arb_addmul(s, s + 1, s + 2, OPTIMUM_BITS);
                }
            ok = gen_check(g, got[3 * e->place[k] + d] == optimum_case_nearest(s), "T z at %zu: %a, not %a", k, got[3 * e->place[k] + d],
                           optimum_case_nearest(s));
        }
    _arb_vec_clear(s, 3);
    optimum_model_forces(got, m, z);
    for (size_t k = 0; k < n; k++)
        for (size_t other = 0; other < n && counts(e, k); other++)
            for (size_t d = 0; d < 3 && entry(e, k, other) != 0 && e->place[other] != SIZE_MAX; d++)
                want[3 * e->place[other] + d] += entry(e, k, other) * z[3 * e->place[k] + d];
    return ok && gen_check(g, optimum_case_same(got, want, 3 * e->m), "T'x");
}

/* N'WN, number by number. */
static bool same_matrix(gen *g, const optimum_model *m, const expected *e, size_t nov, size_t rows)
{
    static const size_t block[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    static double full[3 * NODES][3 * NODES];
    const size_t n = rows * e->m, half = rows == 1 ? e->half : 3 * e->half + 2;
    double weight[6 * OPTIMUM_CLASSES];
    optimum_band band;
    bool ok = gen_check(g, optimum_band_new(&band, n, half) == ET_OK, "no band");

    for (size_t k = 0; k < 6 * nov; k++)
        weight[k] = gen_real(g, -1, 1);
    for (size_t k = 0; k < n; k++)
        memset(full[k], 0, n * sizeof full[k][0]);
    for (size_t c = 0; c < nov; c++)
        for (size_t a = e->start[c]; a < e->start[c + 1]; a++)
            for (size_t b = e->start[c]; b < e->start[c + 1]; b++)
                for (size_t i = 0; i < rows; i++)
                    for (size_t j = 0; j < rows; j++)
                        full[rows * e->at[a] + i][rows * e->at[b] + j] += rows == 1 ? weight[c] * e->value[a] * e->value[b]
                                                                                 : e->value[a] * e->value[b] * weight[6 * c + block[i][j]];
    if (ok)
        (rows == 1 ? optimum_model_scalar : optimum_model_blocks)(&band, m, weight);
    for (size_t i = 0; i < n && ok; i++)
        for (size_t j = i > half ? i - half : 0; j <= i && ok; j++)
            ok = gen_check(g, *optimum_band_at(&band, i, j) == full[i][j], "%zu numbers, entry %zu, %zu: %a, not %a", rows, i, j,
                           *optimum_band_at(&band, i, j), full[i][j]);
    optimum_band_free(&band);
    return ok;
}

/* One case in 3. */
verdict prop_optimum_find_model(gen *g)
{
    static expected e;
    optimum_case c;
    optimum_model m;
    bool dropped = false, ok = optimum_case_draw(g, &c, (optimum_state)gen_upto(g, 3));
    int which = -1;

    ok = ok && expect(&e, &which, &dropped, &c);
    ok = ok && gen_check(g, optimum_model_new(&m, &c.fit) == ET_OK, "not made");
    gen_label(g, which == 0 ? "first changed" : which == 1 ? "second changed" : dropped ? "nodes left out" : "plain");
    if (ok) {
        ok = same_model(g, &m, &e, &c, dropped) && same_products(g, &m, &e, c.nov) && same_change(g, &m, &e);
        ok = ok && same_matrix(g, &m, &e, c.nov, 1) && (c.nov > 40 || same_matrix(g, &m, &e, c.nov, 3));
        optimum_model_free(&m);
    }
    end(&e);
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}
