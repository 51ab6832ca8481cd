/* What is linear: which control points count, the matrix N, and N'WN. */
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NONE SIZE_MAX
enum { CHANGED = 64 };                    /* control points of a direction, at most, whose basis is changed: it then has no local support */

/* ---- one direction ---- */

static double inside(const optimum_axis *a, double t)
{
    return fmin(fmax(t, a->knots[a->p]), a->knots[a->n]);
}

/* Whether N_j(t) > 0, decided by comparisons alone: t lies within the support, or at an end of it where the function does not vanish. */
static int positive(const optimum_axis *a, size_t j, double t)
{
    const double *const u = a->knots + j;
    const size_t p = a->p;
    const int left = u[0] < t || (u[0] == t && u[p] == t && t < u[p + 1]);
    const int right = t < u[p + 1] || (t == a->knots[a->n] && t == u[p + 1] && u[1] == t && u[0] < t);

    return left && right;
}

static int repeated(const optimum_axis *a, size_t i)
{
    return i > 0 && inside(a, a->t[i]) == inside(a, a->t[i - 1]);
}

/* The greatest set of columns with an increasing choice of parameters at which they are positive.  By the total positivity of B-splines
 * (Schoenberg and Whitney 1953; de Boor 1976) its columns are independent, and there are as many as the rank: the others depend on them. */
static size_t choose_first(optimum_axis *a)
{
    size_t next = 0, count = 0;

    for (size_t i = 0; i < a->nt; i++) {
        size_t j = next > a->first[i] ? next : a->first[i];

        while (j <= a->first[i] + a->p && a->value[i * (a->p + 1) + j - a->first[i]] == 0)
            j++;
        if (!repeated(a, i) && j <= a->first[i] + a->p) {
            a->keep[j] = 1;
            next = j + 1;
            count++;
        }
    }
    return count;
}

/* How many of the first columns are matched with how many of the first parameters, and the sum of the logarithms of their values. */
typedef struct { size_t count; double sum; } matching;

static int better(matching a, matching b)
{
    return a.count > b.count || (a.count == b.count && a.sum > b.sum);
}

/* best[i*(n+1) + j]: of the first i parameters and the first j columns. */
static void match(matching *best, const optimum_axis *a)
{
    const size_t n = a->n, w = a->p + 1;

    for (size_t i = 1; i <= a->nt; i++)
        for (size_t j = 1; j <= n; j++) {
            const size_t k = j - 1 - a->first[i - 1];
            const double x = j > a->first[i - 1] && k < w && !repeated(a, i - 1) ? a->value[(i - 1) * w + k] : 0;
            const matching diagonal = best[(i - 1) * (n + 1) + j - 1];
            const matching with = { diagonal.count + 1, diagonal.sum + (x > 0 ? et_real_log(x) : 0) };
            matching most = best[(i - 1) * (n + 1) + j];

            if (better(best[i * (n + 1) + j - 1], most))
                most = best[i * (n + 1) + j - 1];
            best[i * (n + 1) + j] = x > 0 && better(with, most) ? with : most;
        }
}

/* Of all greatest sets one whose values at its parameters have the greatest product: columns that are barely positive there would make the control points
 * that carry them huge. */
static et_status choose(optimum_axis *a)
{
    size_t entries = 0, i = a->nt, j = a->n;
    matching *best;

    a->whole = 1;
    if (choose_first(a) == a->n)
        return ET_OK;
    if (et_size_mul(&entries, a->nt + 1, a->n + 1) != ET_OK || !(best = et_size_array(entries, sizeof *best)))
        return ET_ENOMEM;
    memset(a->keep, 0, a->n);
    match(best, a);
    while (i > 0 && j > 0) {
        const matching here = best[i * (a->n + 1) + j];
        if (!better(here, best[(i - 1) * (a->n + 1) + j]))
            i--;
        else if (!better(here, best[i * (a->n + 1) + j - 1]))
            j--;
        else {
            i--;
            a->keep[--j] = 1;
        }
    }
    free(best);
    return ET_OK;
}

/* Columns to the same size, by powers of two; those left out are told from zero ones. */
static void equilibrate(optimum_axis *a)
{
    const size_t w = a->p + 1;

    for (size_t j = 0; j < a->n; j++) {
        double most = 0;

        for (size_t i = 0; i < a->nt; i++)
            if (a->first[i] <= j && j <= a->first[i] + a->p)
                most = fmax(most, a->value[i * w + j - a->first[i]]);
        if (most > 0 && !a->keep[j])
            a->whole = 0;
        frexp(most, &a->shift[j]);
        a->shift[j] = -a->shift[j];
        for (size_t i = 0; i < a->nt; i++)
            if (a->first[i] <= j && j <= a->first[i] + a->p)
                a->value[i * w + j - a->first[i]] = ldexp(a->value[i * w + j - a->first[i]], a->shift[j]);
    }
}

static void evaluate(optimum_axis *a)
{
    const size_t w = a->p + 1;

    optimum_ball_axis(a);
    for (size_t i = 0; i < a->nt; i++) {
        const double t = inside(a, a->t[i]);

        a->first[i] = et_knots_span(a->knots, a->n + w, a->p, t) - a->p;
        for (size_t k = 0; k < w; k++)      /* what is positive may have underflowed, but is there */
            a->value[i * w + k] = positive(a, a->first[i] + k, t) ? fmax(a->value[i * w + k], 0x1p-1022) : 0;
    }
}

/* Whatever is not zero: where the ends see more than the first and the last control point, columns that depend on each other in one direction need not
 * do so in the net. */
static void keep_all(optimum_axis *a)
{
    const size_t w = a->p + 1;

    for (size_t k = 0; k < a->nt * w; k++)
        if (a->value[k] != 0)
            a->keep[a->first[k / w] + k % w] = 1;
    a->whole = 1;
}

static int alone(const optimum_axis *a, size_t i, size_t j)
{
    for (size_t k = 0; k <= a->p; k++)
        if ((a->value[i * (a->p + 1) + k] != 0) != (a->first[i] + k == j))
            return 0;
    return 1;
}

static et_status axis_new(optimum_axis *a, const double *knots, size_t n, size_t p, const double *t, size_t nt)
{
    size_t count = 0;
    et_status status = et_size_mul(&count, nt, p + 1);

    *a = (optimum_axis){knots, t, n, p, nt, NULL, NULL, NULL, NULL, 0, 0, NULL, NULL};
    if (status != ET_OK)
        return status;
    a->first = et_size_array(nt, sizeof *a->first);
    a->value = et_size_array(count, sizeof *a->value);
    a->shift = et_size_array(n, sizeof *a->shift);
    a->keep = et_size_array(n, 1);
    if (!a->first || !a->value || !a->shift || !a->keep)
        return ET_ENOMEM;
    evaluate(a);
    a->clamped = alone(a, 0, 0) && alone(a, nt - 1, n - 1);
    status = choose(a);
    if (status == ET_OK)
        equilibrate(a);
    return status;
}

static void axis_free(optimum_axis *a)
{
    free(a->first);
    free(a->value);
    free(a->shift);
    free(a->keep);
    free(a->change);
    free(a->table);
}

/* ---- a better basis ---- */

static double product(const double *a, const double *b, size_t n, size_t stride)
{
    double s = 0;

    for (size_t i = 0; i < n; i++)
        s += a[i * stride] * b[i * stride];
    return s;
}

/* Column j of Q = value T made orthogonal to column k, the same done to T. */
static void part(optimum_axis *a, size_t j, size_t k)
{
    const size_t n = a->n;
    const double share = product(a->table + j, a->table + k, a->nt, n);

    for (size_t i = 0; i < a->nt; i++)
        a->table[i * n + j] -= share * a->table[i * n + k];
    for (size_t i = 0; i < n; i++)
        a->change[i * n + j] -= share * a->change[i * n + k];
}

/* To length one; 0 if there is nothing left of it. */
static int normalise(optimum_axis *a, size_t j)
{
    const size_t n = a->n;
    const double length = sqrt(product(a->table + j, a->table + j, a->nt, n));

    for (size_t i = 0; i < a->nt && length > 0x1p-40; i++)
        a->table[i * n + j] /= length;
    for (size_t i = 0; i < n && length > 0x1p-40; i++)
        a->change[i * n + j] /= length;
    return length > 0x1p-40;
}

static void unchange(optimum_axis *a)
{
    free(a->change);
    free(a->table);
    a->change = a->table = NULL;
}

/* T by Gram and Schmidt, twice for each column: the inner columns in turn, then the two at the ends against the inner ones.  How much T amplifies
 * is returned, 0 for no T: too many columns, or rounding has left nothing of one. */
static double change(optimum_axis *a)
{
    const size_t n = a->n, w = a->p + 1;
    int done = 1;

    if (n > CHANGED || !a->keep[0] || !a->keep[n - 1])
        return 0;
    a->change = et_size_array(n * n, sizeof *a->change);
    a->table = et_size_array(n, a->nt * sizeof *a->table);
    for (size_t i = 0; i < a->nt && a->change && a->table; i++)
        for (size_t k = 0; k < w; k++)
            if (a->keep[a->first[i] + k])
                a->table[i * n + a->first[i] + k] = a->value[i * w + k];
    for (size_t step = 1; step <= n && a->change && a->table && done; step++) {
        const size_t j = step % n == n - 1 ? 0 : step == n ? n - 1 : step, last = j == 0 || j == n - 1 ? n - 1 : j;

        a->change[j * n + j] = 1;
        for (size_t k = 1; k < 2 * last && a->keep[j]; k++)
            if (k % last != 0 && a->keep[k % last])
                part(a, j, k % last);
        done = !a->keep[j] || normalise(a, j);
    }
    if (a->change && a->table && done)
        return sqrt(product(a->change, a->change, n * n, 1));
    unchange(a);
    return 0;
}

/* Of the two directions the one that is worse conditioned gets a better basis, if that is worth the while.  1: v, 0: u, -1: none. */
static int choose_basis(optimum_model *m)
{
    const double u = change(&m->u), v = change(&m->v);

    if (u * v <= 64 * sqrt((double)(m->u.n * m->v.n))) {
        unchange(&m->u);
        unchange(&m->v);
        return -1;
    }
    unchange(u > v ? &m->v : &m->u);
    optimum_ball_table(u > v ? &m->u : &m->v);
    return u <= v;
}

/* ---- both ---- */

size_t optimum_model_place(const optimum_model *model, size_t view, size_t i, size_t j)
{
    return model->place[(view * model->control.nx + i) * model->control.ny + j];
}

/* Places line by line, both views side by side, border nodes once.  Lines run along v if `rows`, else along u. */
static void number_places(optimum_model *m, int rows)
{
    const size_t nu = m->control.nx, nv = m->control.ny, lines = rows ? nu : nv, length = rows ? nv : nu;

    m->m = 0;
    for (size_t a = 0; a < lines; a++)
        for (size_t b = 0; b < length; b++) {
            const size_t i = rows ? a : b, j = rows ? b : a;
            const int border = i == 0 || j == 0 || i == nu - 1 || j == nv - 1, kept = m->u.keep[i] && m->v.keep[j];
            const size_t below = i * nv + j, above = (nu + i) * nv + j;

            m->place[below] = kept && !m->drop[below] ? m->m++ : NONE;
            m->place[above] = border ? m->place[below] : kept && !m->drop[above] ? m->m++ : NONE;
        }
}

/* The terms of data class c, and how far apart the farthest of them stand. */
static size_t lay_terms(optimum_model *m, size_t c)
{
    const et_index node = m->node[c];
    const optimum_axis *const u = &m->u, *const v = &m->v;
    const size_t view = node.k == 2 ? ET_TOP : ET_BOTTOM, nk = u->table ? u->n : u->p + 1, nl = v->table ? v->n : v->p + 1;
    const size_t i0 = u->table ? 0 : u->first[node.i], j0 = v->table ? 0 : v->first[node.j];
    const double *const a = (u->table ? u->table : u->value) + node.i * nk, *const b = (v->table ? v->table : v->value) + node.j * nl;
    size_t n = m->start[c], low = NONE, high = 0;

    for (size_t k = 0; k < nk; k++)
        for (size_t l = 0; l < nl; l++) {
            const size_t at = optimum_model_place(m, view, i0 + k, j0 + l);

            if (a[k] * b[l] == 0 || at == NONE)
                continue;
            m->at[n] = at;
            m->value[n++] = a[k] * b[l];
            low = at < low ? at : low;
            high = at > high ? at : high;
        }
    m->start[c + 1] = n;
    return high > low ? high - low : 0;
}

static void lay(optimum_model *m, int rows)
{
    number_places(m, rows);
    m->half = 0;
    m->start[0] = 0;
    for (size_t c = 0; c < m->nov; c++) {
        const size_t reach = lay_terms(m, c);

        m->half = reach > m->half ? reach : m->half;
    }
}

static et_status allocate(optimum_model *m)
{
    size_t terms = 0;

    if (et_size_mul(&terms, m->u.table ? m->u.n : m->u.p + 1, m->v.table ? m->v.n : m->v.p + 1) != ET_OK || et_size_mul(&terms, terms, m->nov) != ET_OK)
        return ET_ENOMEM;
    m->place = et_size_array(et_doublenet_non(m->control), sizeof *m->place);
    m->drop = et_size_array(et_doublenet_non(m->control), 1);
    m->start = et_size_array(m->nov + 1, sizeof *m->start);
    m->at = et_size_array(terms, sizeof *m->at);
    m->value = et_size_array(terms, sizeof *m->value);
    m->node = et_size_array(m->nov, sizeof *m->node);
    return m->place && m->drop && m->start && m->at && m->value && m->node ? ET_OK : ET_ENOMEM;
}

static void lay_narrow(optimum_model *m)
{
    size_t by_rows;

    lay(m, 1);
    by_rows = m->half;
    lay(m, 0);
    if (by_rows <= m->half)
        lay(m, 1);
}

/* Leave out nodes whose columns seem to depend on others'.  What is left out for this is not proved to change nothing: no bound is then proved. */
static et_status leave_out(optimum_model *m)
{
    optimum_band band;
    et_status status = optimum_band_new(&band, m->m, m->half);
    double *const one = et_size_array(m->nov, sizeof *one);
    unsigned char *const poor = et_size_array(optimum_band_work(&band), 1);

    if (one == NULL || poor == NULL)
        status = ET_ENOMEM;
    for (size_t c = 0; status == ET_OK && c < m->nov; c++)
        one[c] = 1;
    if (status == ET_OK) {
        optimum_model_scalar(&band, m, one);
        optimum_band_factor(&band, poor);
    }
    for (size_t k = 0; status == ET_OK && k < et_doublenet_non(m->control); k++)
        if (m->place[k] != NONE && poor[m->place[k]]) {
            m->drop[k] = 1;
            m->u.whole = m->u.clamped = 0;
        }
    free(one);
    free(poor);
    optimum_band_free(&band);
    return status;
}

et_status optimum_model_new(optimum_model *model, const et_fit *fit)
{
    const et_surface *const s = &fit->shell.view[ET_BOTTOM];
    int changed, clamped;
    et_status status;

    memset(model, 0, sizeof *model);
    model->data = fit->data;
    model->control = et_shell_net(&fit->shell);
    model->nov = et_doublenet_nov(fit->data);
    status = axis_new(&model->u, s->u, s->nu, s->p, fit->s[ET_BOTTOM], fit->data.nx);
    if (status == ET_OK)
        status = axis_new(&model->v, s->v, s->nv, s->q, fit->r[ET_BOTTOM], fit->data.ny);
    if (status != ET_OK)
        return status;
    clamped = model->u.clamped && model->v.clamped;
    if (!clamped) {
        keep_all(&model->u);
        keep_all(&model->v);
    }
    changed = clamped ? choose_basis(model) : -1;
    status = allocate(model);
    if (status != ET_OK)
        return status;
    for (size_t c = 0; c < model->nov; c++)
        model->node[c] = et_doublenet_index(fit->data, c + 1);
    if (changed >= 0) {
        lay(model, changed);
        return ET_OK;
    }
    lay_narrow(model);                    /* either order will do */
    status = leave_out(model);
    lay_narrow(model);
    return status;
}

void optimum_model_free(optimum_model *model)
{
    axis_free(&model->u);
    axis_free(&model->v);
    free(model->place);
    free(model->drop);
    free(model->start);
    free(model->at);
    free(model->value);
    free(model->node);
}

void optimum_model_apply(double *r, const optimum_model *model, const double *x)
{
    for (size_t c = 0; c < model->nov; c++)
        for (size_t k = model->start[c]; k < model->start[c + 1]; k++)
            for (size_t d = 0; d < 3; d++)
                r[3 * c + d] -= model->value[k] * x[3 * model->at[k] + d];
}

void optimum_model_adjoint(double *x, const optimum_model *model, const double *y)
{
    memset(x, 0, 3 * model->m * sizeof *x);
    for (size_t c = 0; c < model->nov; c++)
        for (size_t k = model->start[c]; k < model->start[c + 1]; k++)
            for (size_t d = 0; d < 3; d++)
                x[3 * model->at[k] + d] += model->value[k] * y[3 * c + d];
}

/* The place of the l-th node of X = T Z at (view, i, j), and T's entry. */
static size_t changed_place(double *entry, const optimum_model *m, size_t view, size_t i, size_t j, size_t l)
{
    *entry = m->u.change ? m->u.change[i * m->u.n + l] : m->v.change ? m->v.change[j * m->v.n + l] : l == 0;
    if (*entry == 0)
        return NONE;
    return m->u.change ? optimum_model_place(m, view, l, j) : m->v.change ? optimum_model_place(m, view, i, l) : optimum_model_place(m, view, i, j);
}

/* forward: p = T z; else p = T'z. */
static void apply_change(double *p, const optimum_model *m, const double *z, int forward)
{
    const size_t nu = m->control.nx, nv = m->control.ny, n = m->u.change ? nu : m->v.change ? nv : 1;

    memset(p, 0, 3 * m->m * sizeof *p);
    for (size_t k = 0; k < 2 * nu * nv; k++) {
        const size_t view = k / (nu * nv), i = k / nv % nu, j = k % nv, at = m->place[k];
        const int border = i == 0 || j == 0 || i == nu - 1 || j == nv - 1;

        for (size_t d = 0; d < 3 && at != NONE && !(view == ET_TOP && border); d++) {
            optimum_pair sum = {0, 0};
            double entry;

            for (size_t l = 0; l < n; l++) {
                const size_t other = changed_place(&entry, m, view, i, j, l);

                if (other != NONE && forward)
                    sum = optimum_solve_add(sum, entry, (optimum_pair){z[3 * other + d], 0});
                else if (other != NONE)
                    p[3 * other + d] += entry * z[3 * at + d];
            }
            p[3 * at + d] += sum.hi;
        }
    }
}

void optimum_model_points(double *p, const optimum_model *model, const double *z)
{
    apply_change(p, model, z, 1);
}

void optimum_model_forces(double *z, const optimum_model *model, const double *x)
{
    apply_change(z, model, x, 0);
}

void optimum_model_scalar(optimum_band *band, const optimum_model *model, const double *weight)
{
    optimum_band_clear(band);
    for (size_t c = 0; c < model->nov; c++)
        for (size_t k = model->start[c]; k < model->start[c + 1]; k++)
            for (size_t l = model->start[c]; l < model->start[c + 1]; l++)
                if (model->at[l] <= model->at[k])
                    *optimum_band_at(band, model->at[k], model->at[l]) += weight[c] * model->value[k] * model->value[l];
}

/* T += a W, a tile's 3 x 3 block. */
static void add_block(double *T, double a, const double *W)
{
    T[0] += a * W[0];
    T[1] += a * W[1];
    T[2] += a * W[2];
    T[OPTIMUM_SIDE] += a * W[1];
    T[OPTIMUM_SIDE + 1] += a * W[3];
    T[OPTIMUM_SIDE + 2] += a * W[4];
    T[2 * OPTIMUM_SIDE] += a * W[2];
    T[2 * OPTIMUM_SIDE + 1] += a * W[4];
    T[2 * OPTIMUM_SIDE + 2] += a * W[5];
}

void optimum_model_blocks(optimum_band *band, const optimum_model *model, const double *weight)
{
    optimum_band_clear(band);
    for (size_t c = 0; c < model->nov; c++)
        for (size_t k = model->start[c]; k < model->start[c + 1]; k++)
            for (size_t l = model->start[c]; l < model->start[c + 1]; l++)
                if (model->at[l] <= model->at[k])
                    add_block(optimum_band_at(band, 3 * model->at[k], 3 * model->at[l]), model->value[k] * model->value[l], weight + 6 * c);
}
