/* fitted: the cases of the tests of exact fits, and their functions with memory counted. */
#ifndef TESTS_EXACT_FITTED_H
#define TESTS_EXACT_FITTED_H
#include "etalon/base/real.h"
#include "exact/exact_parts.h"
#include "exact/live.h"
#include "gen.h"
#include "golden.h"
#include <arb_mat.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 6, LARGE = 12, NODES = SIDE * SIDE, CLASSES = 2 * LARGE * LARGE };

/* ---- the functions, memory counted: ET_EINTERNAL if any is kept ---- */

static inline et_status fit_make(et_fit *f, const et_vec3 *data, size_t nov, et_doublenet n, const et_fit_options *o, size_t *bits, const et_task *task,
                          et_message *message)
{
    live_begin(nov / 2 + o->p + o->control.nx);
    const et_status status = et_exact_fit_make(f, data, nov, n, o, bits, task, message);
    return live_end() ? status : ET_EINTERNAL;
}

static inline et_status fit_parameters(et_fit *f, const et_vec3 *data, size_t nov, et_doublenet n, et_fit_approach approach, et_param_method method,
                                size_t *bits)
{
    live_begin(nov / 2 + (size_t)method);
    const et_status status = et_exact_fit_parameters(f, data, nov, n, approach, method, bits);
    return live_end() ? status : ET_EINTERNAL;
}

static inline et_status fit_solve(et_fit *f, const et_vec3 *data, size_t nov, const et_fit_options *o, size_t *bits, const et_task *task,
                           et_message *message)
{
    live_begin(nov / 2 + o->p + o->control.nx);
    const et_status status = et_exact_fit_solve(f, data, nov, o, bits, task, message);
    return live_end() ? status : ET_EINTERNAL;
}

/* ---- cases ---- */

typedef struct {
    et_doublenet net;
    size_t nov;
    et_vec3 data[CLASSES];
    et_fit_options options;
} problem;

static inline void draw_options(gen *g, problem *c, size_t least, size_t most)
{
    et_fit_options *o = &c->options;

    c->net = (et_doublenet){gen_between(g, least, most), gen_between(g, least, most)};
    c->nov = et_doublenet_nov(c->net);
    *o = et_fit_defaults();
    o->control = (et_doublenet){gen_between(g, 2, c->net.nx), gen_between(g, 2, c->net.ny)};
    o->p = gen_between(g, 1, o->control.nx > 4 ? 3 : o->control.nx - 1);
    o->q = gen_between(g, 1, o->control.ny > 4 ? 3 : o->control.ny - 1);
    o->approach = (et_fit_approach)gen_upto(g, 2);
    o->method = (et_param_method)gen_upto(g, 3);
    o->knots = (et_knotrule_kind)gen_upto(g, c->net.nx == o->control.nx && c->net.ny == o->control.ny ? 3 : 2);
    o->corners = (et_fit_corners)gen_upto(g, 2);
}

static inline size_t class_at(const problem *c, size_t w, size_t i, size_t j)
{
    return et_doublenet_class(c->net, w, i, j) - 1;
}

/* Both views bulge, with steps of sixteenths or with many digits. */
static inline void draw_pillow(gen *g, problem *c)
{
    const et_doublenet n = c->net;
    const bool digits = gen_chance(g, 3);

    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < n.nx; i++)
            for (size_t j = 0; j < n.ny; j++) {
                const double x = 2.0 * (double)i / (double)(n.nx - 1) - 1, y = 2.0 * (double)j / (double)(n.ny - 1) - 1;
                const double z = (w == 0 ? -1 : 1) * (1 - x * x) * (1 - y * y);
                double noise[3];
                for (size_t e = 0; e < 3; e++)
                    noise[e] = digits ? (double)gen_upto(g, (UINT64_C(1) << 53) - 1) * 0x1p-55 : (double)gen_upto(g, 3) / 16;
                c->data[class_at(c, w, i, j)] = (et_vec3){x + noise[0], y + noise[1], z + noise[2]};
            }
}

static inline bool bits_equal(const void *a, const void *b, size_t doubles)
{
    return memcmp(a, b, doubles * sizeof(double)) == 0;
}

static inline size_t controls(const et_fit *f)
{
    return f->shell.view[0].nu * f->shell.view[0].nv;
}
#endif
