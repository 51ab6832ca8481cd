#include "ascending.h"
#include "refine/optimum_cases.h"
#include "refine/some_fit.h"
#include <math.h>
#include <string.h>

void optimum_case_knots(gen *g, double *u, size_t n, size_t p)
{
    const size_t kind = gen_upto(g, 5);

    gen_knots(g, u, n + p + 1, p);
    if (kind == 1)                        /* not clamped */
        for (size_t k = 0; k < n + p + 1; k++)
            u[k] = (double)k - (double)p + (k % 2 ? gen_real(g, 0, 0.5) : 0);
    if (kind == 2 && n > p + 1)           /* spans so small that powers of them are no doubles */
        for (size_t k = p + 1; k < n; k++)
            u[k] = ldexp(1, -150 * (int)(n - k));
    if (kind == 3)                        /* the same from the other end */
        for (size_t k = 0; k < n + p + 1; k++)
            u[k] = k <= p ? -1 : k >= n ? 0 : -ldexp(1, -150 * (int)(k - p));
    if (kind == 4 && n > 2 * p)           /* the domain ends at full multiplicity, and knots follow */
        for (size_t k = n - p; k < n + p + 1; k++)
            u[k] = k <= n ? 1 : (double)(k - n + 1);
}

void optimum_case_parameters(gen *g, double *t, size_t nt, const double *u, size_t n, size_t p, size_t kind)
{
    const double a = u[p], b = u[n], from = kind == 2 && gen_chance(g, 4) ? u[gen_between(g, p, n - 1)] : b;

    for (size_t i = 0; i < nt; i++)
        t[i] = kind == 0 ? a + (b - a) * ((double)i / (double)(nt - 1))
             : kind == 1 ? a + (b - a) * pow((double)i / (double)(nt - 1), (double)gen_between(g, 2, 4))
             : gen_chance(g, 6) ? a + (b - a) * gen_real(g, -0.25, 1.25)
             : gen_chance(g, 4) ? u[gen_upto(g, n + p)] / 2
                                : gen_parameter(g, u, n + p + 1, p);
    for (size_t i = 0; i < nt && from < b; i++)     /* all behind one knot */
        t[i] = from + (b - from) * ((double)(i + 1) / (double)(nt + 1));
    ascending(t, nt);
    if (kind < 2) {
        t[0] = a;
        t[nt - 1] = b;
    }
}

bool optimum_case_new(optimum_case *c, size_t p, size_t q, et_doublenet control, et_doublenet data)
{
    memset(c, 0, sizeof *c);
    c->control = control;
    c->nov = et_doublenet_nov(data);
    c->n = et_doublenet_nov(control);
    return some_fit_new(&c->fit, p, q, control, data);
}

static et_vec3 some_point(gen *g)
{
    return (et_vec3){gen_real(g, -1, 1), gen_real(g, -1, 1), gen_real(g, -1, 1)};
}

void optimum_case_close(optimum_case *c)
{
    some_fit_share(&c->fit);
    et_shell_scatter(&c->fit.shell, c->start, c->n);
}

void optimum_case_end(optimum_case *c)
{
    et_fit_free(&c->fit);
}

void optimum_case_even(double *u, size_t n, size_t p)
{
    for (size_t k = 0; k < n + p + 1; k++)
        u[k] = k <= p ? 0 : k >= n ? 1 : (double)(k - p) / (double)(n - p);
}

bool optimum_case_draw(gen *g, optimum_case *c, optimum_state state)
{
    const bool wild = state == BARE || state == LOOSE;
    const size_t p = gen_between(g, 1, 3), q = gen_between(g, 1, 3);
    const et_doublenet control = {gen_between(g, p + 1, 5), gen_between(g, q + 1, 5)};
    const et_doublenet data = {gen_between(g, wild ? 2 : control.nx, 6), gen_between(g, wild ? 2 : control.ny, 6)};
    const size_t kind = state == TAME ? 0 : state == STEEP ? 1 + gen_upto(g, 2) : 0;
    et_surface *const s = &c->fit.shell.view[ET_BOTTOM];

    if (!optimum_case_new(c, p, q, control, data))
        return false;
    optimum_case_even(s->u, s->nu, p);
    optimum_case_even(s->v, s->nv, q);
    if (wild && gen_chance(g, 2)) {
        optimum_case_knots(g, s->u, s->nu, p);
        optimum_case_knots(g, s->v, s->nv, q);
    }
    optimum_case_parameters(g, c->fit.s[ET_BOTTOM], data.nx, s->u, s->nu, p, wild ? gen_upto(g, 2) : kind & 1);
    optimum_case_parameters(g, c->fit.r[ET_BOTTOM], data.ny, s->v, s->nv, q, wild ? gen_upto(g, 2) : kind >> 1);
    for (size_t i = 0; state == LOOSE && i < data.nx; i++)
        c->fit.s[ET_BOTTOM][i] = s->u[p] + (s->u[s->nu] - s->u[p]) * (0.25 + 0.5 * (double)i / (double)data.nx);
    for (size_t k = 0; k < c->nov; k++)
        c->data[k] = some_point(g);
    for (size_t k = 0; k < c->n; k++)
        c->start[k] = some_point(g);
    optimum_case_close(c);
    return true;
}

/* q = (t - from) / (to - from). */
static void fraction(arb_t q, double t, double from, double to)
{
    arb_t a, b;

    arb_init(a);
    arb_init(b);
    arb_set_d(a, from);
    arb_set_d(b, to);
    arb_sub(b, b, a, OPTIMUM_BITS);
    arb_set_d(q, t);
    arb_sub(q, q, a, OPTIMUM_BITS);
    arb_div(q, q, b, OPTIMUM_BITS);
    arb_clear(a);
    arb_clear(b);
}

static void recur(arb_t N, const double *u, double end, size_t p, size_t i, double t)
{
    arb_t a, b;

    if (p == 0) {
        const bool last = t >= end && u[i] < u[i + 1] && u[i] < end && end <= u[i + 1];

        arb_set_si(N, (u[i] <= t && t < u[i + 1] && t < end) || last);
        return;
    }
    arb_init(a);
    arb_init(b);
    arb_zero(N);
    if (u[i] < u[i + p] && u[i] < t) {
        fraction(a, t, u[i], u[i + p]);
        recur(b, u, end, p - 1, i, t);
        arb_addmul(N, a, b, OPTIMUM_BITS);
    }
    if (u[i + 1] < u[i + p + 1] && t < u[i + p + 1]) {
        fraction(a, t, u[i + p + 1], u[i + 1]);
        recur(b, u, end, p - 1, i + 1, t);
        arb_addmul(N, a, b, OPTIMUM_BITS);
    }
    arb_clear(a);
    arb_clear(b);
}

void optimum_case_basis(arb_t N, const double *u, size_t n, size_t p, size_t i, double t)
{
    recur(N, u, u[n], p, i, fmin(fmax(t, u[p]), u[n]));
}

double optimum_case_nearest(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

bool optimum_case_same(const double *a, const double *b, size_t n)
{
    return n == 0 || memcmp(a, b, n * sizeof *a) == 0;
}
