/* What exact fits refuse, and where they stop; data at the ends of the doubles. */
#include "exact/fitted.h"

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

/* One case in 2. */
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
