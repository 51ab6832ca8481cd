#include "etalon/refine/pso.h"
#include <string.h>

enum { BLOCK = 8 };                       /* loops of a fixed count become vectors at any level of optimisation */

typedef struct { double K, c1, c2; } coefficients;

/* v = K (v + c1 r1 (own - x) + c2 r2 (all - x)), r1 = r[0..n-1], r2 = r[n..2n-1] */
static void accelerate(double *restrict v, const double *restrict x, const double *restrict own, const double *restrict all, const double *restrict r,
                       coefficients c, size_t n)
{
    const double *restrict r2 = r + n;
    size_t k = 0;
    for (; k + BLOCK <= n; k += BLOCK)
        for (size_t i = 0; i < BLOCK; i++)
            v[k + i] = c.K * ((v[k + i] + c.c1 * r[k + i] * (own[k + i] - x[k + i])) + c.c2 * r2[k + i] * (all[k + i] - x[k + i]));
    for (; k < n; k++) v[k] = c.K * ((v[k] + c.c1 * r[k] * (own[k] - x[k])) + c.c2 * r2[k] * (all[k] - x[k]));
}

static void limit(double *v, double vmax, size_t n)
{
    if (!(vmax > 0.0)) return;
    for (size_t k = 0; k < n; k++) {
        const double w = v[k] < -vmax ? -vmax : v[k];
        v[k] = w > vmax ? vmax : w;
    }
}

/* y = x + v in the box */
static void move(double *y, double *v, const double *x, const et_search *s)
{
    for (size_t k = 0; k < s->n; k++) y[k] = x[k] + v[k];
    et_search_clamp(y, s);
    if (!s->options.absorb) return;
    for (size_t k = 0; k < s->n; k++) v[k] = y[k] == x[k] + v[k] ? v[k] : 0.0;
}

static void settle(et_search *s, size_t i, const double *y, double value)
{
    const size_t n = s->n;
    memcpy(s->x + i * n, y, n * sizeof *y);
    s->value[i] = value;
    if (!(value < s->remembered[i])) return;
    memcpy(s->memory + i * n, y, n * sizeof *y);
    s->remembered[i] = value;
}

et_status et_pso_step(et_search *search, et_rng *rng)
{
    if (!search->velocity) return ET_EINVAL;
    const et_search_options *o = &search->options;
    const coefficients c = { o->K, o->c1, o->c2 };
    const size_t n = search->n;
    double *before = search->trial, *y = before + n, *r = y + n;
    const double *all = o->immediate ? search->best : before;
    memcpy(before, search->best, n * sizeof *before);
    for (size_t i = 0; i < o->population; i++) {
        double *x = search->x + i * n, *v = search->velocity + i * n, value = 0.0;
        et_rng_fill(r, 2 * n, rng);
        accelerate(v, x, search->memory + i * n, all, r, c, n);
        limit(v, o->vmax, n);
        move(y, v, x, search);
        const et_status status = et_search_eval(&value, search, y);
        if (status != ET_OK) return status;
        settle(search, i, y, value);
    }
    search->generation++;
    return ET_OK;
}
