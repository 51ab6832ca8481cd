/* All stages of an exact fit, and what follows from exactness: symmetries hold bit for bit, planted surfaces come back, the fast fit is near. */
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

static et_status fit_make(et_fit *f, const et_vec3 *data, size_t nov, et_doublenet n, const et_fit_options *o, size_t *bits, const et_task *task,
                          et_message *message)
{
    live_begin(nov / 2 + o->p + o->control.nx);
    const et_status status = et_exact_fit_make(f, data, nov, n, o, bits, task, message);
    return live_end() ? status : ET_EINTERNAL;
}

static et_status fit_parameters(et_fit *f, const et_vec3 *data, size_t nov, et_doublenet n, et_fit_approach approach, et_param_method method,
                                size_t *bits)
{
    live_begin(nov / 2 + (size_t)method);
    const et_status status = et_exact_fit_parameters(f, data, nov, n, approach, method, bits);
    return live_end() ? status : ET_EINTERNAL;
}

static et_status fit_solve(et_fit *f, const et_vec3 *data, size_t nov, const et_fit_options *o, size_t *bits, const et_task *task,
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

static void draw_options(gen *g, problem *c, size_t least, size_t most)
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

static size_t class_at(const problem *c, size_t w, size_t i, size_t j)
{
    return et_doublenet_class(c->net, w, i, j) - 1;
}

/* Both views bulge, with steps of sixteenths or with many digits. */
static void draw_pillow(gen *g, problem *c)
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

static void draw_problem(gen *g, problem *c)
{
    const size_t kind = gen_upto(g, 3);

    draw_options(g, c, 2, SIDE);
    if (kind == 3)
        gen_points(g, &c->data[0].x, c->nov);
    else
        draw_pillow(g, c);
    if (kind == 2) /* lines of no length, crowded parameters */
        for (size_t i = 1; i < c->nov; i++)
            if (gen_chance(g, 3))
                c->data[i] = c->data[i - 1];
}

static bool bits_equal(const void *a, const void *b, size_t doubles)
{
    return memcmp(a, b, doubles * sizeof(double)) == 0;
}

static size_t controls(const et_fit *f)
{
    return f->shell.view[0].nu * f->shell.view[0].nv;
}

static bool same_points(const et_fit *a, const et_fit *b)
{
    return bits_equal(a->shell.view[0].points, b->shell.view[0].points, 3 * controls(a)) &&
           bits_equal(a->shell.view[1].points, b->shell.view[1].points, 3 * controls(a));
}

static bool same_parameters(const et_fit *a, const et_fit *b)
{
    bool ok = a->data.nx == b->data.nx && a->data.ny == b->data.ny && a->flat == b->flat;

    for (size_t w = 0; ok && w < 2; w++)
        ok = bits_equal(a->s[w], b->s[w], a->data.nx) && bits_equal(a->r[w], b->r[w], a->data.ny);
    return ok;
}

static bool same_knots(const et_fit *a, const et_fit *b)
{
    bool ok = true;

    for (size_t w = 0; ok && w < 2; w++) {
        const et_surface *x = &a->shell.view[w], *y = &b->shell.view[w];
        ok = x->p == y->p && x->q == y->q && x->nu == y->nu && x->nv == y->nv && bits_equal(x->u, y->u, x->nu + x->p + 1) &&
             bits_equal(x->v, y->v, x->nv + x->q + 1);
    }
    return ok;
}

/* ---- parameters ---- */

/* Every view by itself, then the means. */
static bool by_stages(gen *g, const problem *c, const et_fit *f, size_t begin, size_t used)
{
    double s[2][LARGE], r[2][LARGE];
    size_t most = 0;
    et_vec3 D[NODES];
    size_t flat[2] = {0, 0};
    bool ok = true;

    for (size_t w = 0; w < 2; w++) {
        for (size_t at = 0; at < c->net.nx * c->net.ny; at++)
            D[at] = c->data[class_at(c, w, at / c->net.ny, at % c->net.ny)];
        size_t bits = begin;
        ok = et_exact_param_grid(s[w], c->net.nx, r[w], c->net.ny, &flat[w], D, c->options.method, &bits) == ET_OK && ok;
        most = bits > most ? bits : most;
    }
    if (c->options.approach != ET_FIT_CONVENTIONAL) {
        et_exact_param_standardise(s[0], s[1], c->net.nx);
        et_exact_param_standardise(r[0], r[1], c->net.ny);
    }
    for (size_t w = 0; w < 2; w++)
        ok = gen_check(g, ok && bits_equal(s[w], f->s[w], c->net.nx) && bits_equal(r[w], f->r[w], c->net.ny), "view %zu is not its stages", w) && ok;
    ok = gen_check(g, used == most, "%zu bits, the stages %zu", used, most) && ok;
    return gen_check(g,
                     f->flat == flat[0] + flat[1] && f->data.nx == c->net.nx && f->data.ny == c->net.ny && f->shell.view[0].u == NULL &&
                         f->shell.view[1].points == NULL,
                     "the rest") &&
           ok;
}

/* Those of et_fit_parameters: a row's are within (2n + 6)u of the truth (chord), roots of it within a little more, and 4/5 as a double is off by 0.4u
 * |ln d| d^(4/5) < 0.2u a distance d; sums, averages and means add a few. */
static bool near_fast(gen *g, const problem *c, const et_fit *f)
{
    const double bound = (4 * (double)SIDE + 64) * ET_UNIT;
    et_fit fast;
    bool ok = true;

    if (!gen_check(g, et_fit_parameters(&fast, c->data, c->nov, c->net, c->options.approach, c->options.method) == ET_OK, "fast"))
        return false;
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; i < c->net.nx; i++)
            ok = gen_check(g, fabs(f->s[w][i] - fast.s[w][i]) <= bound, "s %a, fast %a", f->s[w][i], fast.s[w][i]) && ok;
        for (size_t j = 0; j < c->net.ny; j++)
            ok = gen_check(g, fabs(f->r[w][j] - fast.r[w][j]) <= bound, "r %a, fast %a", f->r[w][j], fast.r[w][j]) && ok;
    }
    ok = gen_check(g, f->flat == fast.flat, "flat") && ok;
    et_fit_free(&fast);
    return ok;
}

static bool parameters_refused(gen *g, const problem *c)
{
    const et_fit_options *o = &c->options;
    size_t bits = 77;
    et_fit f;
    memset(&f, 0x3c, sizeof f);
    const et_fit was = f;

    return gen_check(g,
                     fit_parameters(&f, c->data, c->nov + 1, c->net, o->approach, o->method, &bits) == ET_EINVAL &&
                         fit_parameters(&f, c->data, c->nov, (et_doublenet){c->net.nx, 1}, o->approach, o->method, &bits) == ET_EINVAL &&
                         fit_parameters(&f, c->data, c->nov, c->net, (et_fit_approach)3, o->method, &bits) == ET_EINVAL &&
                         fit_parameters(&f, c->data, c->nov, c->net, o->approach, (et_param_method)4, &bits) == ET_EINVAL &&
                         memcmp(&f, &was, sizeof f) == 0 && bits == 77,
                     "bad arguments");
}

verdict prop_exact_fit_parameters(gen *g)
{
    problem c;
    et_fit f, again;
    size_t bits = 0;
    bool ok;

    draw_problem(g, &c);
    const et_fit_options *o = &c.options;
    ok = parameters_refused(g, &c);
    if (!gen_check(g, fit_parameters(&f, c.data, c.nov, c.net, o->approach, o->method, &bits) == ET_OK, "made"))
        return FAIL;
    ok = by_stages(g, &c, &f, 0, bits) && near_fast(g, &c, &f) && ok;
    ok = gen_check(g, o->method != ET_PARAM_UNIFORM || bits == 0, "equal steps need no balls") && ok;
    for (size_t k = 0; k < 2; k++) {
        const size_t begin = k == 0 ? 4 * bits : 1 + gen_upto(g, 99);
        bits = begin;
        if (!gen_check(g, fit_parameters(&again, c.data, c.nov, c.net, o->approach, o->method, &bits) == ET_OK, "again"))
            return FAIL;
        ok = gen_check(g, same_parameters(&f, &again), "other bits, other parameters") && by_stages(g, &c, &again, begin, bits) && ok;
        et_fit_free(&again);
    }
    if (!gen_check(g, fit_parameters(&again, c.data, c.nov, c.net, o->approach, o->method, NULL) == ET_OK, "bits null"))
        return FAIL;
    ok = gen_check(g, same_parameters(&f, &again), "bits null, other parameters") && ok;
    et_fit_free(&again);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Steps along the axes have whole lengths: parameters are rationals. */
verdict prop_exact_fit_parameters_rational(gen *g)
{
    problem c;
    et_fit f;
    uint64_t x[SIDE] = {0}, y[SIDE] = {0};
    bool ok = true;
    fmpq_t q;

    draw_options(g, &c, 2, SIDE);
    c.options.method = ET_PARAM_CHORD;
    for (size_t k = 1; k < SIDE; k++) {
        x[k] = x[k - 1] + gen_between(g, 1, 9);
        y[k] = y[k - 1] + gen_between(g, 1, 1000000);
    }
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < c.net.nx; i++)
            for (size_t j = 0; j < c.net.ny; j++)
                c.data[class_at(&c, w, i, j)] = (et_vec3){(double)x[i], (double)y[j], 5};
    if (!gen_check(g, fit_parameters(&f, c.data, c.nov, c.net, c.options.approach, c.options.method, NULL) == ET_OK, "made"))
        return FAIL;
    fmpq_init(q);
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; i < c.net.nx; i++) {
            fmpq_set_ui(q, (ulong)x[i], (ulong)x[c.net.nx - 1]);
            ok = gen_check(g, f.s[w][i] == exact_round(q), "s[%zu]", i) && ok;
        }
        for (size_t j = 0; j < c.net.ny; j++) {
            fmpq_set_ui(q, (ulong)y[j], (ulong)y[c.net.ny - 1]);
            ok = gen_check(g, f.r[w][j] == exact_round(q), "r[%zu]", j) && ok;
        }
    }
    fmpq_clear(q);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- all stages ---- */

/* Parameters, knots and control points, stage after stage; *most: the most bits that a stage needed. */
static et_status stages(et_fit *f, const problem *c, size_t *most, et_message *message)
{
    const et_fit_options *o = &c->options;
    size_t line = 0, point = 0;
    et_status status = fit_parameters(f, c->data, c->nov, c->net, o->approach, o->method, &line);

    if (status == ET_OK)
        status = et_shell_new(&f->shell, o->p, o->q, o->control, 0);
    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        status = et_exact_knotrule_make(f->shell.view[w].u, o->control.nx + o->p + 1, o->p, f->s[w], c->net.nx, o->knots);
        if (status == ET_OK)
            status = et_exact_knotrule_make(f->shell.view[w].v, o->control.ny + o->q + 1, o->q, f->r[w], c->net.ny, o->knots);
    }
    if (status == ET_OK)
        status = fit_solve(f, c->data, c->nov, o, &point, NULL, message);
    *most = line > point ? line : point;
    return status;
}

verdict prop_exact_fit_make(gen *g)
{
    problem c;
    et_fit f, by, again;
    et_message message = {"untouched"}, other = {"untouched"};
    size_t bits = 0, used, most;
    bool ok;

    draw_problem(g, &c);
    const et_status expect = stages(&by, &c, &most, &other);
    c.options.algebra = (et_linalg_method)gen_upto(g, 5); /* not used */
    memset(&f, 0x3c, sizeof f);
    const et_fit was = f;
    const et_status status = fit_make(&f, c.data, c.nov, c.net, &c.options, &bits, NULL, &message);
    gen_label(g, status == ET_OK ? et_fit_name(c.options.approach) : "deficient");
    ok = gen_check(g, status == expect && strcmp(message.text, other.text) == 0, "status %d, %s, should be %d, %s", (int)status, message.text,
                   (int)expect, other.text);
    if (status != ET_OK)
        ok = gen_check(g, memcmp(&f, &was, sizeof f) == 0 && bits == 0 && status == ET_ERANK, "the fit changed") && ok;
    else {
        ok = gen_check(g, same_parameters(&f, &by) && same_knots(&f, &by) && same_points(&f, &by), "make is not its stages") && ok;
        ok = gen_check(g, bits == most, "%zu bits, the stages %zu", bits, most) && ok;
        ok = gen_check(g, et_shell_valid(&f.shell) && (c.options.approach == ET_FIT_CONVENTIONAL || et_shell_glued(&f.shell)), "shell") && ok;
        used = 4 * bits;
        ok = gen_check(g, fit_make(&again, c.data, c.nov, c.net, &c.options, &used, NULL, NULL) == ET_OK && used >= 4 * bits, "again") && ok;
        ok = gen_check(g, ok && same_parameters(&f, &again) && same_knots(&f, &again) && same_points(&f, &again), "four times the bits") && ok;
        if (ok)
            et_fit_free(&again);
        et_fit_free(&f);
    }
    et_fit_free(&by);
    return ok ? PASS : FAIL;
}

static bool refused(gen *g, const problem *c, const et_fit_options *o, size_t nov, et_doublenet net, const char *word)
{
    et_message message = {""};
    size_t bits = 3;
    et_fit f;
    memset(&f, 0x3c, sizeof f);
    const et_fit was = f;
    const et_status status = fit_make(&f, c->data, nov, net, o, &bits, NULL, &message);

    return gen_check(g, status == ET_EINVAL && memcmp(&f, &was, sizeof f) == 0 && bits == 3, "%s: status %d", word, (int)status) &&
           gen_check(g, strstr(message.text, word) != NULL, "message: %s (no \"%s\")", message.text, word) &&
           gen_check(g, fit_make(&f, c->data, nov, net, o, NULL, NULL, NULL) == ET_EINVAL, "without a message");
}

verdict prop_exact_fit_make_refuses(gen *g)
{
    problem c;
    et_fit_options o;
    bool ok;

    draw_options(g, &c, 2, SIDE);
    draw_pillow(g, &c);
    const et_fit_options good = c.options;
    ok = refused(g, &c, &good, c.nov + 1, c.net, "classes");
    ok = refused(g, &c, &good, c.nov, (et_doublenet){1, c.net.ny}, "classes") && ok;
    for (size_t k = 0; k < 12; k++) {
        static const char *const words[] = {"enumeration", "enumeration", "enumeration", "enumeration", "larger",    "larger",
                                            "degrees",     "degrees",     "degrees",     "degrees",     "too small", "too small"};
        o = good;
        o.approach = k == 0 ? (et_fit_approach)3 : o.approach;
        o.method = k == 1 ? (et_param_method)4 : o.method;
        o.knots = k == 2 ? (et_knotrule_kind)4 : o.knots;
        o.corners = k == 3 ? (et_fit_corners)3 : o.corners;
        o.control.nx = k == 4 ? c.net.nx + 1 : k == 10 ? 1 : o.control.nx;
        o.control.ny = k == 5 ? c.net.ny + 1 : k == 11 ? 1 : o.control.ny;
        o.p = k == 6 ? 0 : k == 7 ? o.control.nx : o.p;
        o.q = k == 8 ? 0 : k == 9 ? o.control.ny : o.q;
        ok = refused(g, &c, &o, c.nov, c.net, words[k]) && ok;
    }
    o = good;
    o.knots = ET_KNOTRULE_AVERAGING;
    if (o.control.nx < c.net.nx || o.control.ny < c.net.ny)
        ok = refused(g, &c, &o, c.nov, c.net, "averaged") && ok;
    return ok ? PASS : FAIL;
}

/* Distances of 1 and of 2^-1070 in one row put knots closer than a valid surface may have them; data near the greatest double give control points
 * beyond it. */
verdict prop_exact_fit_make_extremes(gen *g)
{
    const bool across = gen_chance(g, 2);
    problem c;
    et_fit f;
    et_message message = {""};
    et_status status;
    bool ok;
    memset(&f, 0x3c, sizeof f);
    const et_fit was = f;

    c.net = across ? (et_doublenet){2, 5} : (et_doublenet){5, 2};
    c.nov = et_doublenet_nov(c.net);
    c.options = et_fit_defaults();
    c.options.approach = (et_fit_approach)gen_upto(g, 2);
    c.options.control = across ? (et_doublenet){2, 4} : (et_doublenet){4, 2};
    c.options.p = across ? 1 : 2;
    c.options.q = across ? 2 : 1;
    c.options.knots = ET_KNOTRULE_FAITHFUL;
    for (size_t at = 0; at < 10; at++) {
        const size_t along = across ? at % 5 : at / 2, side = across ? at / 5 : at % 2;
        c.data[at] = (et_vec3){along < 4 ? (double)along * 0x1p-1070 : 1, side ? 0x1p-1070 : 0, 0};
    }
    status = fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, &message);
    ok = gen_check(g, status == ET_EFORMAT && strstr(message.text, "knots") != NULL, "knots 2^-1070 apart: %s", message.text);
    for (size_t at = 0; at < 10; at++)
        c.data[at] = (et_vec3){(across ? at % 5 : at / 2) % 2 ? 0x1.fp1023 : -0x1.fp1023, 0, 0};
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_PIEGL;
    c.options.control = c.net;
    c.options.p = across ? 1 : 3;
    c.options.q = across ? 3 : 1;
    status = fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, &message);
    ok = gen_check(g, status == ET_EFORMAT && strstr(message.text, "overflow") != NULL, "overflow: %s", message.text) && ok;
    return gen_check(g, memcmp(&f, &was, sizeof f) == 0, "the fit changed") && ok ? PASS : FAIL;
}

/* ---- symmetries, bit for bit ---- */

static double signless(double x)
{
    return x == 0 ? 0 : x;
}

/* Data times 2^k, axes turned round, x mirrored. */
static bool moved(gen *g, const problem *c, const et_fit *f, int k)
{
    problem d = *c;
    et_fit h;
    bool ok = true;

    for (size_t i = 0; i < c->nov; i++)
        d.data[i] = (et_vec3){ldexp(c->data[i].y, k), ldexp(c->data[i].z, k), -ldexp(c->data[i].x, k)};
    if (!gen_check(g, fit_make(&h, d.data, d.nov, d.net, &d.options, NULL, NULL, NULL) == ET_OK, "moved: not solved"))
        return false;
    ok = gen_check(g, same_parameters(f, &h), "moved: other parameters");
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < controls(f); i++) {
            const et_vec3 a = f->shell.view[w].points[i], b = h.shell.view[w].points[i];
            const et_vec3 e = {ldexp(a.y, k), ldexp(a.z, k), signless(-ldexp(a.x, k))};
            ok = gen_check(g, bits_equal(&b, &e, 3), "times 2^%d: (%a, %a, %a), not (%a, %a, %a)", k, b.x, b.y, b.z, e.x, e.y, e.z) && ok;
        }
    et_fit_free(&h);
    return ok;
}

/* u for v. */
static bool turned(gen *g, const problem *c, const et_fit *f)
{
    problem d = *c;
    et_fit h;
    const size_t kx = c->options.control.nx, ky = c->options.control.ny;
    bool ok = true;

    d.net = (et_doublenet){c->net.ny, c->net.nx};
    d.options.control = (et_doublenet){ky, kx};
    d.options.p = c->options.q;
    d.options.q = c->options.p;
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < c->net.nx; i++)
            for (size_t j = 0; j < c->net.ny; j++)
                d.data[class_at(&d, w, j, i)] = c->data[class_at(c, w, i, j)];
    if (!gen_check(g, fit_make(&h, d.data, d.nov, d.net, &d.options, NULL, NULL, NULL) == ET_OK, "turned: not solved"))
        return false;
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < kx; i++)
            for (size_t j = 0; j < ky; j++)
                ok = gen_check(g, bits_equal(&f->shell.view[w].points[i * ky + j], &h.shell.view[w].points[j * kx + i], 3),
                               "turned: view %zu (%zu,%zu)", w, i, j) &&
                     ok;
    et_fit_free(&h);
    return ok;
}

/* The top for the bottom. */
static bool flipped(gen *g, const problem *c, const et_fit *f)
{
    problem d = *c;
    et_fit h;
    bool ok;

    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < c->net.nx; i++)
            for (size_t j = 0; j < c->net.ny; j++)
                d.data[class_at(&d, w, i, j)] = c->data[class_at(c, 1 - w, i, j)];
    if (!gen_check(g, fit_make(&h, d.data, d.nov, d.net, &d.options, NULL, NULL, NULL) == ET_OK, "flipped: not solved"))
        return false;
    ok = gen_check(g,
                   bits_equal(f->shell.view[0].points, h.shell.view[1].points, 3 * controls(f)) &&
                       bits_equal(f->shell.view[1].points, h.shell.view[0].points, 3 * controls(f)),
                   "flipped");
    et_fit_free(&h);
    return ok;
}

verdict prop_exact_fit_make_symmetry(gen *g)
{
    problem c;
    et_fit f;

    draw_options(g, &c, 2, SIDE);
    draw_pillow(g, &c);
    if (fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL) != ET_OK)
        return SKIP;
    const bool ok = moved(g, &c, &f, (int)gen_between(g, 1, 1500) - 750) && turned(g, &c, &f) && flipped(g, &c, &f);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- planted surfaces come back, all bits of them ---- */

/* Knots and parameters are such that basis functions are whole multiples of 2^-12, so that points of surfaces with short coordinates are doubles. */
static void draw_dyadic(gen *g, size_t *m, size_t *n, size_t *p)
{
    *m = 1 + ((size_t)2 << gen_upto(g, 2));
    *p = gen_between(g, 1, *m > 3 ? 3 : 2);
    const uint64_t doublings = *p == 3 ? (*m > 5 ? 1 : 0) : *m == 9 ? 2 : *m == 5 ? 1 : *p == 1 ? 1 : 0;
    *n = *p + ((size_t)1 << gen_upto(g, doublings));
}

verdict prop_exact_fit_make_planted(gen *g)
{
    problem c;
    et_fit f;
    et_vec3 planted[CLASSES], S[LARGE * LARGE];
    bool ok = true;

    draw_options(g, &c, 2, 2);
    draw_dyadic(g, &c.net.nx, &c.options.control.nx, &c.options.p);
    draw_dyadic(g, &c.net.ny, &c.options.control.ny, &c.options.q);
    c.nov = et_doublenet_nov(c.net);
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_UNIFORM;
    memset(c.data, 0, sizeof c.data);
    if (!gen_check(g, fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL) == ET_OK, "frame"))
        return FAIL;
    const size_t nov = et_doublenet_nov(c.options.control);
    for (size_t i = 0; i < nov; i++)
        planted[i] = (et_vec3){(double)gen_upto(g, 16) - 8, (double)gen_upto(g, 999) * 0x1p-1040, (double)gen_upto(g, 999) * 0x1p1000};
    et_shell_scatter(&f.shell, planted, nov);
    for (size_t w = 2; ok && w-- > 0;) {
        ok = et_exact_surface_grid(S, &f.shell.view[w], f.s[w], c.net.nx, f.r[w], c.net.ny) == ET_OK;
        for (size_t i = 0; i < c.net.nx; i++)
            for (size_t j = 0; j < c.net.ny; j++)
                c.data[class_at(&c, w, i, j)] = S[i * c.net.ny + j];
    }
    et_fit_free(&f);
    if (!gen_check(g, ok && fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL) == ET_OK, "fit"))
        return FAIL;
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < controls(&f); at++) {
            const et_vec3 a = f.shell.view[w].points[at];
            const et_vec3 b = planted[et_doublenet_class(c.options.control, w, at / c.options.control.ny, at % c.options.control.ny) - 1];
            ok = gen_check(g, bits_equal(&a, &b, 3), "view %zu %zu: (%a, %a, %a), planted (%a, %a, %a)", w, at, a.x, a.y, a.z, b.x, b.y, b.z) && ok;
        }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- ties ---- */

/* Data on a line, 1 + i ulp or i of the least subnormals, at i/8: a quadratic's control points are at the middles of knots (Greville), thus as often
 * as not in the middle between two doubles: to even. */
verdict prop_exact_fit_solve_ties(gen *g)
{
    problem c;
    et_fit f;
    uint64_t knot[8];
    size_t inner = 0, bits = 0;
    bool ok = true;
    const bool tiny = gen_chance(g, 2), across = gen_chance(g, 2);

    for (uint64_t k = 1; k < 8; k++)
        if (!gen_chance(g, 3) && inner < 6) /* nine data bear nine control points at most */
            knot[inner++] = k;
    const size_t control = inner + 3;
    draw_options(g, &c, 2, 2);
    c.options.control = across ? (et_doublenet){2, control} : (et_doublenet){control, 2};
    c.options.p = across ? 1 : 2;
    c.options.q = across ? 2 : 1;
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_UNIFORM;
    c.net = across ? (et_doublenet){2, 9} : (et_doublenet){9, 2};
    c.nov = et_doublenet_nov(c.net);
    for (size_t at = 0; at < c.nov; at++) {
        const double i = (double)(across ? at % 9 : at / 2);
        c.data[at] = (et_vec3){tiny ? i * 0x1p-1074 : 1 + i * 0x1p-52, 0.5, 0};
    }
    if (!gen_check(g, fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL) == ET_OK, "frame"))
        return FAIL;
    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; k < inner; k++)
            (across ? f.shell.view[w].v : f.shell.view[w].u)[3 + k] = (double)knot[k] / 8;
    ok = gen_check(g, fit_solve(&f, c.data, c.nov, &c.options, &bits, NULL, NULL) == ET_OK, "solved");
    bool tie = false;
    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; k < control; k++) {
            /* its knots k + 1 and k + 2, in eighths */
            const uint64_t lo = k < 2 ? 0 : k - 2 < inner ? knot[k - 2] : 8, hi = k < 1 ? 0 : k - 1 < inner ? knot[k - 1] : 8;
            const uint64_t half = lo + hi, even = half % 2 == 0 ? half / 2 : half / 2 + half / 2 % 2;
            tie = tie || half % 2 == 1;
            const double x = f.shell.view[w].points[across ? k : 2 * k].x, expect = tiny ? (double)even * 0x1p-1074 : 1 + (double)even * 0x1p-52;
            ok = gen_check(g, x == expect, "control point %zu, %llu halves: %a, should be %a", k, (unsigned long long)half, x, expect) && ok;
        }
    ok = gen_check(g, !tie || bits == 2048, "a tie is tried to 2048 bits, not to %zu", bits) && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- hard data ---- */

/* A constant coordinate is constant in all control points, and zeros are +0; mirrored views give mirrored control points. */
verdict prop_exact_fit_make_degenerate(gen *g)
{
    problem c;
    et_fit f;
    bool ok = true;

    draw_options(g, &c, 2, SIDE);
    draw_pillow(g, &c);
    const bool point = gen_chance(g, 4);
    const double y = gen_chance(g, 2) ? 0.1 : gen_real(g, -1, 1);
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < c.net.nx; i++)
            for (size_t j = 0; j < c.net.ny; j++) {
                et_vec3 *D = &c.data[class_at(&c, w, i, j)], *B = &c.data[class_at(&c, 0, i, j)];
                const bool border = i == 0 || j == 0 || i + 1 == c.net.nx || j + 1 == c.net.ny;
                *D = point ? (et_vec3){0.1, y, -0.0} : (et_vec3){border ? -0.0 : w ? -B->x : B->x, y, B->z};
            }
    const et_status status = fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL);
    gen_label(g, status == ET_OK ? "solved" : "deficient");
    if (status != ET_OK)
        return gen_check(g, status == ET_ERANK, "status %d", (int)status) ? PASS : FAIL;
    for (size_t at = 0; at < controls(&f); at++) {
        const et_vec3 a = f.shell.view[0].points[at], b = f.shell.view[1].points[at];
        const double zero = 0, constant = signless(y), tenth = 0.1, mirrored = signless(-a.x);
        ok = gen_check(g, bits_equal(&a.y, &constant, 1) && bits_equal(&b.y, &constant, 1), "y: %a, %a, should be %a", a.y, b.y, constant) && ok;
        if (point)
            ok = gen_check(g, bits_equal(&a.x, &tenth, 1) && bits_equal(&b.x, &tenth, 1) && bits_equal(&a.z, &zero, 1) && bits_equal(&b.z, &zero, 1),
                           "a point") &&
                 ok;
        else
            ok = gen_check(g, bits_equal(&b.x, &mirrored, 1) && bits_equal(&a.z, &b.z, 1), "x: %a, %a, z: %a, %a", a.x, b.x, a.z, b.z) && ok;
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- larger nets: the gradient at the rounded solution is what rounding leaves ---- */

enum { BITS = 512 };

static void collocation(arb_mat_t A, const double *t, const double *u, size_t p)
{
    const size_t m = (size_t)arb_mat_nrows(A), n = (size_t)arb_mat_ncols(A);
    fmpq *N = _fmpq_vec_init((slong)p + 1);

    arb_mat_zero(A);
    for (size_t i = 0; i < m; i++) {
        size_t span = p;
        while (span + 1 < n && !(t[i] < u[span + 1]))
            span++;
        while (u[span] == u[span + 1])
            span--;
        exact_basis(N, 0, u, n + p + 1, p, span, t[i]);
        for (size_t k = 0; k <= p; k++)
            arb_set_fmpq(arb_mat_entry(A, (slong)i, (slong)(span - p + k)), N + k, BITS);
    }
    _fmpq_vec_clear(N, (slong)p + 1);
}

/* C = A X B', or A'X B. */
static void sandwich(arb_mat_t C, const arb_mat_t A, const arb_mat_t X, const arb_mat_t B, bool from_left)
{
    arb_mat_t T, L;

    if (from_left) {
        arb_mat_init(L, arb_mat_ncols(A), arb_mat_nrows(A));
        arb_mat_init(T, arb_mat_ncols(A), arb_mat_ncols(X));
        arb_mat_transpose(L, A);
        arb_mat_mul(T, L, X, BITS);
        arb_mat_mul(C, T, B, BITS);
    } else {
        arb_mat_init(L, arb_mat_ncols(B), arb_mat_nrows(B));
        arb_mat_init(T, arb_mat_nrows(A), arb_mat_ncols(X));
        arb_mat_transpose(L, B);
        arb_mat_mul(T, A, X, BITS);
        arb_mat_mul(C, T, L, BITS);
    }
    arb_mat_clear(L);
    arb_mat_clear(T);
}

static double half_ulp(double x)
{
    return fmax((nextafter(fabs(x), HUGE_VAL) - fabs(x)) / 2, 0x1p-1074);
}

/* Of view w and one coordinate: gradient A'(A P B' - D)B, and its bound, A'A |half ulps| B'B, basis functions being positive.  border: of the view's
 * own, too, are the border's data. */
static void slope(arb_mat_t G, arb_mat_t E, const problem *c, const et_fit *f, size_t w, size_t e, bool border)
{
    const et_surface *v = &f->shell.view[w];
    const size_t m = c->net.nx, n = c->net.ny;
    arb_mat_t A, B, P, H, R, S;

    arb_mat_init(A, (slong)m, (slong)v->nu);
    arb_mat_init(B, (slong)n, (slong)v->nv);
    arb_mat_init(P, (slong)v->nu, (slong)v->nv);
    arb_mat_init(H, (slong)v->nu, (slong)v->nv);
    arb_mat_init(R, (slong)m, (slong)n);
    arb_mat_init(S, (slong)m, (slong)n);
    collocation(A, f->s[w], v->u, v->p);
    collocation(B, f->r[w], v->v, v->q);
    for (size_t at = 0; at < v->nu * v->nv; at++) {
        const double x = (&v->points[at].x)[e];
        arb_set_d(arb_mat_entry(P, (slong)(at / v->nv), (slong)(at % v->nv)), x);
        arb_set_d(arb_mat_entry(H, (slong)(at / v->nv), (slong)(at % v->nv)), half_ulp(x));
    }
    sandwich(R, A, P, B, false);
    sandwich(S, A, H, B, false);
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < n; j++) {
            arb_ptr r = arb_mat_entry(R, (slong)i, (slong)j), s = arb_mat_entry(S, (slong)i, (slong)j);
            arb_t d;
            arb_init(d);
            arb_set_d(d, (&c->data[class_at(c, w, i, j)].x)[e]);
            arb_sub(r, r, d, BITS);
            arb_clear(d);
            if (!border && (i == 0 || j == 0 || i + 1 == m || j + 1 == n)) {
                arb_zero(r);
                arb_zero(s);
            }
        }
    sandwich(G, A, R, B, true);
    sandwich(E, A, S, B, true);
    arb_mat_clear(A);
    arb_mat_clear(B);
    arb_mat_clear(P);
    arb_mat_clear(H);
    arb_mat_clear(R);
    arb_mat_clear(S);
}

static bool stationary(gen *g, const problem *c, const et_fit *f, size_t e, bool fixed)
{
    const et_doublenet k = c->options.control;
    const bool joint = c->options.approach == ET_FIT_JOINT;
    arb_mat_t G[2], E[2];
    bool ok = true;

    for (size_t w = 0; w < 2; w++) {
        arb_mat_init(G[w], (slong)k.nx, (slong)k.ny);
        arb_mat_init(E[w], (slong)k.nx, (slong)k.ny);
        slope(G[w], E[w], c, f, w, e, !joint || w == 0);
    }
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < k.nx; i++)
            for (size_t j = 0; j < k.ny; j++) {
                const bool end_u = i == 0 || i + 1 == k.nx, end_v = j == 0 || j + 1 == k.ny;
                arb_ptr x = arb_mat_entry(G[w], (slong)i, (slong)j), bound = arb_mat_entry(E[w], (slong)i, (slong)j);
                if ((fixed && end_u && end_v) || (joint && w == 1 && (end_u || end_v)))
                    continue;
                if (joint && (end_u || end_v)) {
                    arb_add(x, x, arb_mat_entry(G[1], (slong)i, (slong)j), BITS);
                    arb_add(bound, bound, arb_mat_entry(E[1], (slong)i, (slong)j), BITS);
                }
                arb_abs(x, x);
                ok = gen_check(g, !arb_gt(x, bound), "view %zu (%zu,%zu): gradient %g, rounding leaves %g", w, i, j,
                               arf_get_d(arb_midref(x), ARF_RND_NEAR), arf_get_d(arb_midref(bound), ARF_RND_NEAR)) &&
                     ok;
            }
    for (size_t w = 0; w < 2; w++) {
        arb_mat_clear(G[w]);
        arb_mat_clear(E[w]);
    }
    return ok;
}

verdict prop_exact_fit_make_gradient(gen *g)
{
    problem c;
    et_fit f;
    bool ok = true;

    draw_options(g, &c, 2, gen_chance(g, 8) ? LARGE : SIDE);
    draw_pillow(g, &c);
    if (c.options.approach == ET_FIT_IMPROVED)
        c.options.approach = ET_FIT_JOINT;
    if (fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL) != ET_OK)
        return SKIP;
    gen_label(g, et_fit_name(c.options.approach));
    for (size_t e = 0; e < 3; e++)
        ok = stationary(g, &c, &f, e, c.options.corners == ET_CORNERS_INTERPOLATED) && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- the fast fit is near ---- */

/* |A+| and |A| of a direction, Frobenius norms, from above. */
static bool norms(double *inverse, double *norm, const double *t, size_t m, const double *u, size_t n, size_t p)
{
    arb_mat_t A, At, G;
    arb_t sum;
    bool ok;

    arb_mat_init(A, (slong)m, (slong)n);
    arb_mat_init(At, (slong)n, (slong)m);
    arb_mat_init(G, (slong)n, (slong)n);
    arb_init(sum);
    collocation(A, t, u, p);
    arb_mat_transpose(At, A);
    arb_mat_mul(G, At, A, BITS);
    arb_mat_trace(sum, G, BITS);
    *norm = sqrt(arf_get_d(arb_midref(sum), ARF_RND_UP)) * (1 + 0x1p-40);
    ok = arb_mat_inv(G, G, BITS);
    arb_mat_trace(sum, G, BITS);
    *inverse = sqrt(arf_get_d(arb_midref(sum), ARF_RND_UP)) * (1 + 0x1p-40);
    arb_clear(sum);
    arb_mat_clear(A);
    arb_mat_clear(At);
    arb_mat_clear(G);
    return ok && *inverse < HUGE_VAL;
}

/* How far backward stable solvers may be: (1 + condition)^2 times their backward error (the number of entries they touch, in u; the basis functions'
 * own error is within it) times |A+| times the data; both views share a border, which may halve squares of the singular values, and corners moved to
 * the right make it greater by |A| times themselves. */
static double spread(const problem *c, const et_fit *f)
{
    double bound = 0, data = 0;

    for (size_t i = 0; i < c->nov; i++)
        data += c->data[i].x * c->data[i].x + c->data[i].y * c->data[i].y + c->data[i].z * c->data[i].z;
    data = 2 * sqrt(data);
    for (size_t w = 0; w < 2; w++) {
        const et_surface *v = &f->shell.view[w];
        double iu, iv, nu, nv;
        if (!norms(&iu, &nu, f->s[w], c->net.nx, v->u, v->nu, v->p) || !norms(&iv, &nv, f->r[w], c->net.ny, v->v, v->nv, v->q))
            return HUGE_VAL;
        const double inverse = sqrt(2) * iu * iv, norm = sqrt(2) * nu * nv;
        const double size = 64 * (double)((c->nov + 8) * (2 * v->nu * v->nv + 8)) * ET_UNIT;
        bound = fmax(bound, size * (1 + inverse * norm) * (1 + inverse * norm) * inverse * data * (1 + norm));
    }
    return bound;
}

verdict prop_exact_fit_solve_fast(gen *g)
{
    problem c;
    et_fit f, h;
    bool ok;

    draw_options(g, &c, 2, SIDE);
    draw_pillow(g, &c);
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return SKIP;
    h = f; /* its parameters and knots, but control points of its own */
    if (!gen_check(g, et_shell_copy(&h.shell, &f.shell) == ET_OK, "copy"))
        return FAIL;
    const double bound = spread(&c, &f);
    const et_status status = fit_solve(&h, c.data, c.nov, &c.options, NULL, NULL, NULL);
    gen_label(g, bound < 1e-6 ? "well conditioned" : bound < 1 ? "badly" : "hopeless");
    ok = gen_check(g, status == ET_OK || (status == ET_ERANK && bound > 1), "status %d", (int)status);
    for (size_t w = 0; ok && status == ET_OK && w < 2; w++)
        for (size_t at = 0; at < controls(&f); at++) {
            const double off = et_vec3_distance(f.shell.view[w].points[at], h.shell.view[w].points[at]);
            ok = gen_check(g, off <= bound, "view %zu, %zu: fast is off by %g, bound %g", w, at, off, bound) && ok;
        }
    et_shell_free(&h.shell);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- what is refused, and stopped ---- */

static bool not_solved(gen *g, et_fit *f, const problem *c, size_t nov, const et_fit_options *o, const char *word)
{
    et_vec3 *P = f->shell.view[0].points, *Q = f->shell.view[1].points, was[2][NODES];
    const size_t n = controls(f) > NODES ? NODES : controls(f);
    et_message message = {""};
    size_t bits = 5;

    if (P != NULL)
        memcpy(was[0], P, n * sizeof *P);
    if (Q != NULL)
        memcpy(was[1], Q, n * sizeof *Q);
    const et_status status = fit_solve(f, c->data, nov, o, &bits, NULL, &message);
    return gen_check(g, status == ET_EINVAL && strstr(message.text, word) != NULL, "%s: status %d, %s", word, (int)status, message.text) &&
           gen_check(g, (P == NULL || memcmp(P, was[0], n * sizeof *P) == 0) && (Q == NULL || memcmp(Q, was[1], n * sizeof *Q) == 0) && bits == 5,
                     "changed") &&
           gen_check(g, fit_solve(f, c->data, nov, o, NULL, NULL, NULL) == ET_EINVAL, "without a message");
}

/* f, broken in the k-th way; null past the last. */
static const char *broken(et_fit *f, et_fit_options *o, size_t *nov, size_t w, size_t k)
{
    static double ones[] = {1, 1, 1, 1, 1, 1, 1, 1, 1}, two[] = {0, 0, 1, 1}, quadratic[] = {0, 0, 0, 1, 1, 1};
    et_surface *v = &f->shell.view[w], *other = &f->shell.view[1 - w];

    if (k == 0)
        *nov += 1;
    if (k == 1)
        f->data.nx = 1;
    if (k < 2)
        return "classes";
    if (k == 2)
        o->approach = (et_fit_approach)3;
    if (k == 3)
        o->corners = (et_fit_corners)3;
    if (k < 4)
        return "enumeration";
    v->weights = k == 4 ? ones : NULL;
    v->points = k == 5 ? NULL : v->points;
    v->u = k == 6 ? NULL : k == 7 ? quadratic : k == 8 ? two : v->u;
    v->v = k == 9 ? NULL : k == 10 ? quadratic : k == 11 ? two : v->v;
    v->p = k == 7 ? 2 : v->p;
    v->nu = k == 8 ? 2 : v->nu;
    v->q = k == 10 ? 2 : v->q;
    v->nv = k == 11 ? 2 : v->nv;
    f->s[w] = k == 12 ? NULL : f->s[w];
    f->r[w] = k == 13 ? NULL : f->r[w];
    if (k == 14 || k == 15)
        v->p = other->p = k == 14 ? 0 : v->nu;
    if (k == 16 || k == 17)
        v->q = other->q = k == 16 ? 0 : v->nv;
    /* The first view's degrees and sizes are both views'. */
    return k >= 18 ? NULL : k < 14 && (w == 1 || k == 7 || k == 8 || k == 10 || k == 11) ? "top view" : "bottom view";
}

/* Where and how f is spoiled in the k-th way; null past the last. */
static double *spoiled(et_fit *f, size_t w, size_t k, double *value)
{
    et_surface *v = &f->shell.view[w];
    const size_t nu = v->nu + v->p + 1, nv = v->nv + v->q + 1, nx = f->data.nx, ny = f->data.ny;
    const struct {
        double *place, value;
    } ways[] = {{&f->s[w][0], 0x1p-30},
                {&f->s[w][nx - 1], 1 - 0x1p-53},
                {&f->s[w][nx - 2], -0.5},
                {&f->s[w][0], NAN},
                {&f->r[w][0], -0x1p-1074},
                {&f->r[w][ny - 1], 1 + 0x1p-52},
                {&f->r[w][ny - 2], -0.5},
                {&f->r[w][ny - 1], NAN},
                {&v->u[0], -1},
                {&v->u[nu - 1], 2},
                {&v->u[v->p], NAN},
                {&v->u[v->p + 1], 1.5},
                {&v->u[v->p + 1], 0x1p-1074},
                {&v->v[0], -1},
                {&v->v[nv - 1], 2},
                {&v->v[v->q], NAN},
                {&v->v[v->q + 1], -1.5},
                {&v->v[v->q + 1], NAN},
                {&f->s[w][1], NAN},
                {&f->r[w][1], NAN}};

    if (k >= sizeof ways / sizeof *ways)
        return NULL;
    *value = ways[k].value;
    return ways[k].place;
}

static bool views_differ(gen *g, et_fit *f, const problem *c)
{
    double *const places[] = {&f->s[1][1], &f->r[1][1], &f->shell.view[1].u[2], &f->shell.view[1].v[2]};
    et_fit_options o = c->options;
    bool ok = true;

    for (size_t k = 0; k < 8; k++) {
        double *const place = places[k % 4];
        const double was = *place;
        *place = nextafter(was, k < 4 ? 0 : 2);
        o.approach = ET_FIT_IMPROVED;
        ok = not_solved(g, f, c, c->nov, &o, "differ") && ok;
        o.approach = ET_FIT_JOINT;
        ok = not_solved(g, f, c, c->nov, &o, "differ") && ok;
        *place = was;
    }
    return ok;
}

verdict prop_exact_fit_solve_refuses(gen *g)
{
    problem c;
    et_fit f, h;
    et_fit_options o;
    const char *word = "";
    char text[ET_MESSAGE_SIZE];
    double value;
    bool ok = true;
    const size_t w = gen_upto(g, 1);

    draw_options(g, &c, 3, 5);
    c.options.control = (et_doublenet){3, 3};
    c.options.p = c.options.q = 1;
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_UNIFORM;
    draw_pillow(g, &c);
    if (!gen_check(g, fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL) == ET_OK, "frame"))
        return FAIL;
    for (size_t k = 0; word != NULL; k++) {
        size_t nov = c.nov;
        h = f;
        o = c.options;
        word = broken(&h, &o, &nov, w, k);
        if (k < 2) {
            snprintf(text, sizeof text, "%zu points are not the classes of a double net %zux%zu", nov, h.data.nx, h.data.ny);
            word = text;
        }
        ok = (word == NULL || not_solved(g, &h, &c, nov, &o, word)) && ok;
    }
    for (size_t k = 0; spoiled(&f, w, k, &value) != NULL; k++) {
        double *place = spoiled(&f, w, k, &value);
        const double was = *place;
        *place = value;
        ok = not_solved(g, &f, &c, c.nov, &c.options, w == 0 ? "bottom view" : "top view") && ok;
        *place = was;
    }
    ok = views_differ(g, &f, &c) && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Inner knots of degree 2 and 3, where one view's differ. */
/* One case in 20. */
verdict prop_exact_fit_solve_refuses_knots(gen *g)
{
    problem c;
    et_fit f;
    bool ok = true;

    draw_options(g, &c, 5, SIDE);
    c.options.control = (et_doublenet){5, 5};
    c.options.p = gen_between(g, 2, 3);
    c.options.q = gen_between(g, 2, 3);
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_UNIFORM;
    c.options.approach = gen_chance(g, 2) ? ET_FIT_IMPROVED : ET_FIT_JOINT;
    draw_pillow(g, &c);
    if (!gen_check(g, fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL) == ET_OK, "frame"))
        return FAIL;
    for (size_t k = 0; k < 8; k++) {
        et_surface *v = &f.shell.view[k % 2];
        double *place = k < 4 ? &v->u[k / 2 ? 4 : v->p + 1] : &v->v[k / 2 % 2 ? 4 : v->q + 1];
        const double was = *place;
        *place = nextafter(was, (double)gen_upto(g, 1));
        ok = not_solved(g, &f, &c, c.nov, &c.options, "differ") && ok;
        *place = was;
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Straight lines through three data each: the first value is (5 a + 2 b - c)/6.  One control point alone of both views overflows. */
verdict prop_exact_fit_solve_overflow(gen *g)
{
    const bool last = gen_chance(g, 2), across = gen_chance(g, 2);
    const double huge = gen_chance(g, 2) ? -0x1.fffffffffffffp1023 : 0x1.fffffffffffffp1023;
    const size_t e = gen_upto(g, 2);
    et_message message = {""};
    problem c;
    et_fit f;

    draw_options(g, &c, 3, 3);
    c.options.control = (et_doublenet){2, 2};
    c.options.p = c.options.q = 1;
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_UNIFORM;
    c.options.approach = ET_FIT_CONVENTIONAL;
    c.options.corners = ET_CORNERS_FREE;
    memset(c.data, 0, sizeof c.data);
    const size_t end = last ? 2 : 0;
    (&c.data[class_at(&c, 0, end, end)].x)[e] = huge; /* 25/36 */
    (&c.data[class_at(&c, 0, across ? end : 1, across ? 1 : end)].x)[e] = huge; /* 10/36 */
    bool ok = gen_check(g, fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, NULL) == ET_OK, "35/36 of the greatest double");
    if (ok)
        et_fit_free(&f);
    (&c.data[class_at(&c, last, 1, 1)].x)[e] = huge; /* 4/36 */
    ok = ok && gen_check(g, fit_make(&f, c.data, c.nov, c.net, &c.options, NULL, NULL, &message) == ET_EFORMAT, "39/36 of it");
    return ok && gen_check(g, strstr(message.text, "overflow") != NULL, "message: %s", message.text) ? PASS : FAIL;
}

/* (5 a + 2 b - c)/6 is the middle of two doubles but for 2^-200/6: 128 bits do not tell, 256 do.  Two coordinates are known at once. */
static void draw_near_tie(problem *c, size_t e, bool across, bool up)
{
    static const double line[] = {1 + 0x1p-52, 0.5 - 0x1p-52, 0x1p-200};

    c->net = across ? (et_doublenet){2, 3} : (et_doublenet){3, 2};
    c->nov = et_doublenet_nov(c->net);
    c->options.control = (et_doublenet){2, 2};
    c->options.p = c->options.q = 1;
    c->options.method = ET_PARAM_UNIFORM;
    c->options.knots = ET_KNOTRULE_UNIFORM;
    c->options.approach = c->options.approach == ET_FIT_IMPROVED ? ET_FIT_JOINT : c->options.approach;
    c->options.corners = ET_CORNERS_FREE;
    memset(c->data, 0, sizeof c->data);
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 2; j++)
            (&c->data[class_at(c, 0, across ? j : i, across ? i : j)].x)[e] = i == 2 && up ? -line[i] : line[i];
}

/* One case in 10. */
verdict prop_exact_fit_solve_bits(gen *g)
{
    static const size_t given[][2] = {{0, 256}, {1, 256}, {2, 256}, {60, 240}, {240, 240}, {999, 999}, {2049, 2049}};
    const bool up = gen_chance(g, 2), across = gen_chance(g, 2);
    const size_t e = gen_upto(g, 2);
    problem c;
    et_fit f;
    bool ok = true;

    draw_options(g, &c, 2, 2);
    draw_near_tie(&c, e, across, up);
    for (size_t k = 0; ok && k < sizeof given / sizeof *given; k++) {
        size_t bits = given[k][0];
        ok = gen_check(g, fit_make(&f, c.data, c.nov, c.net, &c.options, &bits, NULL, NULL) == ET_OK, "made");
        ok = ok && gen_check(g, bits == given[k][1], "from %zu: %zu bits, not %zu", given[k][0], bits, given[k][1]);
        const double x = ok ? (&f.shell.view[k % 2].points[0].x)[e] : 0;
        ok = ok && gen_check(g, x == (up ? 1 + 0x1p-52 : 1), "%a", x);
        if (ok)
            et_fit_free(&f);
    }
    return ok ? PASS : FAIL;
}

/* One case in 250. */
verdict prop_exact_fit_solve_greatest(gen *g)
{
    size_t bits = gen_upto(g, 1) ? SIZE_MAX : ((size_t)1 << 20) + gen_upto(g, 1);
    problem c;
    et_fit f;

    draw_options(g, &c, 2, 2);
    draw_near_tie(&c, 1, false, true);
    if (!gen_check(g, fit_make(&f, c.data, c.nov, c.net, &c.options, &bits, NULL, NULL) == ET_OK && bits == (size_t)1 << 20, "%zu bits", bits))
        return FAIL;
    const double y = f.shell.view[1].points[0].y;
    et_fit_free(&f);
    return gen_check(g, y == 1 + 0x1p-52, "%a", y) ? PASS : FAIL;
}

typedef struct {
    size_t calls, stop, done;
    et_status with;
    bool orderly;
} watch;

static et_status watching(void *context, size_t done, size_t total)
{
    watch *w = context;

    w->orderly = w->orderly && done >= w->done && done <= total && total == 3;
    w->done = done;
    return w->calls++ == w->stop ? w->with : ET_OK;
}

verdict prop_exact_fit_solve_stops(gen *g)
{
    problem c;
    et_fit f, h;
    watch w = {0, SIZE_MAX, 0, ET_ESTOPPED, true};
    const et_task task = {watching, &w};
    et_vec3 was[2][NODES];
    et_message message = {"untouched"};
    size_t bits = 0;
    bool ok;

    draw_options(g, &c, 2, SIDE);
    draw_pillow(g, &c);
    if (fit_make(&f, c.data, c.nov, c.net, &c.options, &bits, &task, &message) != ET_OK)
        return SKIP;
    ok = gen_check(g, w.orderly && w.calls > 1 && strcmp(message.text, "untouched") == 0, "%zu calls", w.calls);
    for (size_t v = 0; v < 2; v++)
        for (size_t i = 0; i < controls(&f); i++)
            was[v][i] = f.shell.view[v].points[i] = (et_vec3){1, 2, (double)i};
    w = (watch){0, gen_upto(g, w.calls - 1), 0, gen_chance(g, 2) ? ET_EIO : ET_ESTOPPED, true};
    bits = 9;
    memset(&h, 0x3c, sizeof h);
    const et_fit before = h;
    ok = gen_check(g,
                   fit_make(&h, c.data, c.nov, c.net, &c.options, &bits, &task, NULL) == w.with && memcmp(&h, &before, sizeof h) == 0 &&
                       bits == 9,
                   "made though stopped") &&
         ok;
    w.calls = w.done = 0;
    ok = gen_check(g, fit_solve(&f, c.data, c.nov, &c.options, NULL, &task, &message) == w.with && w.calls == w.stop + 1, "not stopped") &&
         ok;
    for (size_t v = 0; v < 2; v++)
        ok = gen_check(g, bits_equal(was[v], f.shell.view[v].points, 3 * controls(&f)), "control points changed") && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- the rows of et_fit, recomputed ---- */

static et_vec3 *read_data(const row *r, size_t first, et_doublenet n, size_t *nov)
{
    et_vec3 *data;

    if (!et_doublenet_valid(n) || r->nargs != first + 3 * et_doublenet_nov(n))
        return NULL;
    *nov = et_doublenet_nov(n);
    data = calloc(*nov, sizeof *data);
    for (size_t i = 0; data != NULL && i < 3 * *nov; i++)
        (&data[i / 3].x)[i % 3] = row_real(r, first + i);
    return data;
}

/* Rows: approach method knots algebra corners p q nx ny cx cy, data by class.  ET_EINTERNAL for a malformed one. */
static et_status fit_of(const row *r, et_fit *f)
{
    const et_doublenet n = {row_size(r, 7), row_size(r, 8)};
    et_fit_options o = et_fit_defaults();
    size_t nov = 0;
    et_vec3 *data = read_data(r, 11, n, &nov);
    et_status status;

    if (data == NULL)
        return ET_EINTERNAL;
    o.approach = (et_fit_approach)row_size(r, 0);
    o.method = (et_param_method)row_size(r, 1);
    o.knots = (et_knotrule_kind)row_size(r, 2);
    o.corners = (et_fit_corners)row_size(r, 4);
    o.p = row_size(r, 5);
    o.q = row_size(r, 6);
    o.control = (et_doublenet){row_size(r, 9), row_size(r, 10)};
    status = fit_make(f, data, nov, n, &o, NULL, NULL, NULL);
    free(data);
    return status;
}

/* Wanted: control points, bottom view then top. */
verdict true_fit_make(const row *r)
{
    et_fit f;
    bool ok = true;

    if (fit_of(r, &f) != ET_OK)
        return FAIL;
    for (size_t i = 0; i < 6 * controls(&f); i++)
        ok = row_is(r, i, (&f.shell.view[i / (3 * controls(&f))].points[i % (3 * controls(&f)) / 3].x)[i % 3]) && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Wanted: the status alone.  SVD's least norm, which is never deficient, has no exact counterpart, and what is no algebra is not seen. */
verdict true_fit_make_status(const row *r)
{
    et_fit f;
    et_status status;

    if (row_size(r, 3) >= ET_LINALG_SVD)
        return SKIP;
    status = fit_of(r, &f);
    if (status == ET_OK)
        et_fit_free(&f);
    return row_is_size(r, 0, (size_t)status) ? PASS : FAIL;
}

/* Rows: approach method nx ny, data by class; wanted: flat, s and r of the bottom view, s and r of the top. */
verdict true_fit_parameters(const row *r)
{
    const et_doublenet n = {row_size(r, 2), row_size(r, 3)};
    size_t k = 1, nov = 0;
    et_vec3 *data = read_data(r, 4, n, &nov);
    et_fit f;
    bool ok;

    if (data == NULL)
        return FAIL;
    const et_status status = fit_parameters(&f, data, nov, n, (et_fit_approach)row_size(r, 0), (et_param_method)row_size(r, 1), NULL);
    free(data);
    if (status != ET_OK)
        return FAIL;
    ok = row_is_size(r, 0, f.flat);
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; i < n.nx; i++)
            ok = row_is(r, k++, f.s[w][i]) && ok;
        for (size_t j = 0; j < n.ny; j++)
            ok = row_is(r, k++, f.r[w][j]) && ok;
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}
