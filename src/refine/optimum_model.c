/* What is linear: the matrix N over the control points that count, and N'WN. */
#include "etalon/base/size.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NONE SIZE_MAX

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
    int changed = -1, clamped;
    et_status status;

    memset(model, 0, sizeof *model);
    model->data = fit->data;
    model->control = et_shell_net(&fit->shell);
    model->nov = et_doublenet_nov(fit->data);
    status = optimum_axis_new(&model->u, s->u, s->nu, s->p, fit->s[ET_BOTTOM], fit->data.nx);
    if (status == ET_OK)
        status = optimum_axis_new(&model->v, s->v, s->nv, s->q, fit->r[ET_BOTTOM], fit->data.ny);
    if (status != ET_OK)
        return status;
    clamped = model->u.clamped && model->v.clamped;
    if (!clamped) {
        optimum_axis_keep_all(&model->u);
        optimum_axis_keep_all(&model->v);
    }
    status = clamped ? optimum_axis_change(&changed, &model->u, &model->v) : ET_OK;
    if (status == ET_OK)
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
    optimum_axis_free(&model->u);
    optimum_axis_free(&model->v);
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
