/* The second computation of an enclosure: the cases both are given. */
#include "ascending.h"
#include "fit/enclosure_again.h"
#include <string.h>

/* Parameters from 0 to 1: even; any; with coincident ones; two very near each other; near 0. */
static void draw_parameters(gen *g, double *t, size_t m)
{
    const size_t kind = gen_upto(g, 9);

    for (size_t i = 0; i < m; i++)
        t[i] = kind < 5 ? ((double)i + (i > 0 && i + 1 < m ? gen_real(g, -0.4, 0.4) : 0)) / (double)(m - 1) : gen_real(g, 0, 1);
    ascending(t, m);
    t[0] = 0;
    t[m - 1] = 1;
    if (kind == 1 && m > 3)
        t[2] = fmin(1, t[1] + ldexp(gen_real(g, 1, 2), -(int)gen_between(g, 30, 50)));
    if (kind == 2 && m > 2)
        t[1] = ldexp(gen_real(g, 1, 2), -(int)(gen_between(g, 30, 60) * (gen_chance(g, 2) ? 1 + gen_upto(g, 15) : 1)));
    if (kind == 3 && m > 2)
        t[1] = gen_chance(g, 2) ? 0 : t[2];
    if (kind == 4)
        t[m - 2] = m > 2 ? 1 - ldexp(gen_real(g, 1, 2), -(int)gen_between(g, 30, 52)) : 0;
}

/* Clamped on [0, 1]: averages of parameters, rarely an end knot more often than p + 1 times; even; hard ones. */
static void draw_knots(gen *g, double *u, size_t n, size_t p, const double *t, size_t m)
{
    const size_t kind = gen_upto(g, 7);

    for (size_t i = 0; i < n + p + 1; i++)
        u[i] = i <= p ? 0 : i >= n ? 1 : (double)(i - p) / (double)(n - p);
    for (size_t i = p + 1; i < n && kind < 4; i++)
        u[i] = fmax(0x1p-30, fmin(1 - 0x1p-30, (t[(i - p) * m / n] + t[(i - 1) * m / n]) / 2));
    if (kind == 4)
        gen_knots(g, u, n + p + 1, p);
    if (kind == 5 && n > p + 1)
        u[gen_chance(g, 2) ? p + 1 : n - 1] = gen_real(g, 0, 1);
    ascending(u, n + p + 1);
    if (kind == 6 && n > p + 1 && gen_chance(g, 4))
        u[gen_chance(g, 2) ? p + 1 : n - 1] = gen_chance(g, 2);
    for (size_t i = 0; i < n + p + 1; i++)
        u[i] = u[i] < 0x1p-900 ? 0 : u[i];
    ascending(u, n + p + 1);
}

void again_draw_frame(gen *g, again_case *c)
{
    const bool hard = gen_chance(g, 2);
    et_fit_options *o = &c->options;
    et_fit *f = &c->fit;

    memset(c, 0, sizeof *c);
    f->data = (et_doublenet){ gen_between(g, 2, SIDE), gen_between(g, 2, SIDE) };
    *o = et_fit_defaults();
    o->control = (et_doublenet){ gen_between(g, 2, f->data.nx), gen_between(g, 2, f->data.ny) };
    o->p = gen_between(g, 1, o->control.nx - 1 < 3 ? o->control.nx - 1 : 3);
    o->q = gen_between(g, 1, o->control.ny - 1 < 3 ? o->control.ny - 1 : 3);
    o->approach = (et_fit_approach)gen_upto(g, 2);
    o->corners = (et_fit_corners)gen_upto(g, 2);
    for (size_t w = 0; w < 2; w++) {
        et_surface *s = &f->shell.view[w];
        const size_t from = o->approach == ET_FIT_CONVENTIONAL ? w : 0;
        *s = (et_surface){ o->p, o->q, o->control.nx, o->control.ny, c->u[from][0], c->u[from][1], c->P[w], NULL };
        for (size_t e = 0; e < 2 && from == w; e++) {
            const size_t m = e ? f->data.ny : f->data.nx, n = e ? s->nv : s->nu, p = e ? s->q : s->p;
            for (size_t i = 0; i < m; i++)
                c->t[w][e][i] = (double)i / (double)(m - 1);
            if (hard)
                draw_parameters(g, c->t[w][e], m);
            draw_knots(g, c->u[w][e], n, p, c->t[w][e], m);
        }
        f->s[w] = c->t[from][0];
        f->r[w] = c->t[from][1];
    }
}

void again_draw_job(gen *g, again_case *c)
{
    static const double losses[] = { 0, 0, 0, 0x1p-1000, 0x1p-999, 0x1p-90, 0x1p-20 };
    static const int scales[] = { 0, 0, 0, 0, 0, 0, 0, -2000, -2000, -170, -538, 1023 };
    enclosure_job *k = &c->job;

    *k = (enclosure_job){ .fit = &c->fit, .options = &c->options, .message = &c->message, .data = c->fit.data, .control = c->options.control,
                          .fixed = c->options.corners != ET_CORNERS_FREE, .D = { c->D[0], c->D[1] } };
    for (size_t e = 0; e < 3; e++) {
        const int scale = scales[gen_upto(g, 11)];
        const bool like = gen_chance(g, 3);
        k->lost[e] = losses[gen_upto(g, 6)];
        k->exponent[e] = (int)gen_upto(g, 20) - 10;
        for (size_t w = 0; w < 2; w++)
            for (size_t at = 0; at < k->data.nx * k->data.ny; at++) {
                const bool border = again_on_border(k->data, at / k->data.ny, at % k->data.ny);
                c->D[w][3 * at + e] = border && w ? c->D[0][3 * at + e] : ldexp(gen_real(g, -1, 1), like && !w ? 0 : scale);
            }
    }
}

void again_draw_points(gen *g, again_case *c, const enclosure_solution *x)
{
    static const int scales[] = { -52, -52, -20, 0, -538, -541, -460, 300, 480, 505, 520, 1000, -2000 };

    for (size_t e = 0; e < 3; e++) {
        const int scale = scales[gen_upto(g, 12)];
        const bool near = gen_chance(g, 2);
        for (size_t w = 0; w < 2; w++)
            for (size_t at = 0; at < c->options.control.nx * c->options.control.ny; at++) {
                const double p = ldexp((near && x ? x->x[w][3 * at + e].hi : 0) + ldexp(gen_real(g, -1, 1), scale), c->job.exponent[e]);
                (&c->P[w][at].x)[e] = isfinite(p) ? p : copysign(0x1.fffffffffffffp1023, p);
            }
    }
}

void again_tell(gen *g, const again_case *c)
{
    gen_note(g, "%s, corners %d, degrees %zu %zu, data %zux%zu, control %zux%zu", et_fit_name(c->options.approach), (int)c->options.corners,
             c->options.p, c->options.q, c->fit.data.nx, c->fit.data.ny, c->options.control.nx, c->options.control.ny);
    for (size_t e = 0; e < 4; e++) {
        for (size_t i = 0; i < (e % 2 ? c->fit.data.ny : c->fit.data.nx); i++)
            gen_note(g, "t[%zu][%zu][%zu] = %a", e / 2, e % 2, i, c->t[e / 2][e % 2][i]);
        for (size_t i = 0; i <= (e % 2 ? c->options.q + c->options.control.ny : c->options.p + c->options.control.nx); i++)
            gen_note(g, "u[%zu][%zu][%zu] = %a", e / 2, e % 2, i, c->u[e / 2][e % 2][i]);
    }
}

void again_take_job(again_case *c, const et_vec3 *data)
{
    enclosure_job *k = &c->job;
    const et_doublenet n = c->fit.data;

    *k = (enclosure_job){ .fit = &c->fit, .options = &c->options, .message = &c->message, .data = n, .control = c->options.control,
                          .fixed = c->options.corners == ET_CORNERS_INTERPOLATED ||
                                   (c->options.corners == ET_CORNERS_DEFAULT && c->options.approach == ET_FIT_IMPROVED),
                          .D = { c->D[0], c->D[1] } };
    for (size_t e = 0; e < 3; e++) {
        double most = 0;
        for (size_t i = 0; i < et_doublenet_nov(n); i++)
            most = fmax(most, fabs((&data[i].x)[e]));
        frexp(most, &k->exponent[e]);
        for (size_t at = 0; at < 2 * n.nx * n.ny; at++) {
            const double x = (&data[et_doublenet_class(n, at % 2, at / 2 / n.ny, at / 2 % n.ny) - 1].x)[e];
            c->D[at % 2][3 * (at / 2) + e] = ldexp(x, -k->exponent[e]);
            k->lost[e] = ldexp(ldexp(x, -k->exponent[e]), k->exponent[e]) == x ? k->lost[e] : TINY;
        }
    }
}

void again_draw_data(gen *g, again_case *c, et_vec3 *data)
{
    static const int units[] = { 0, 0, 0, 0, 1020, 1023, -1060, -1070, -400 };
    const size_t nov = et_doublenet_nov(c->fit.data);

    for (size_t e = 0; e < 3; e++) {
        const int unit = units[gen_upto(g, 8)];
        const size_t kind = gen_upto(g, 5);
        for (size_t i = 0; i < nov; i++) {
            double x = ldexp(gen_real(g, -1, 1), unit);
            if (kind == 0)
                x = ldexp((double)gen_upto(g, 8) - 4, unit);
            if (kind == 1)
                x = 0;
            if (kind == 2 && gen_chance(g, 2))
                x = ldexp(x, -1040);
            (&data[i].x)[e] = isfinite(x) ? x : copysign(0x1.fffffffffffffp1023, x);
        }
    }
    again_take_job(c, data);
}
