/* All stages of an exact fit, and what follows from exactness: symmetries hold bit for bit, planted surfaces come back. */
#include "exact/fitted.h"

/* ---- cases ---- */

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

/* One case in 2. */
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

/* One case in 2. */
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

/* One case in 2. */
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

/* One case in 2. */
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
/* One case in 2. */
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
