/* fit/fit: names, defaults, parameters, measures; golden rows. */
#include "fit/fits.h"

/* ---- the other functions ---- */

verdict prop_fit_name(gen *g)
{
    static const char *const names[] = {"conventional", "improved", "joint"};
    const size_t k = gen_upto(g, 5);
    const char *name = et_fit_name((et_fit_approach)k);

    return gen_check(g, k < 3 ? name != NULL && strcmp(name, names[k]) == 0 : name == NULL, "name %zu", k) &&
                   gen_check(g, et_fit_name((et_fit_approach)-1) == NULL, "name of -1")
               ? PASS
               : FAIL;
}

verdict gold_fit_name(const row *r)
{
    const char *name = et_fit_name((et_fit_approach)row_size(r, 0));

    return strcmp(name == NULL ? "null" : name, r->want[0]) == 0 ? PASS : FAIL;
}

verdict prop_fit_defaults(gen *g)
{
    const et_fit_options o = et_fit_defaults();

    return gen_check(g,
                     o.approach == ET_FIT_IMPROVED && o.method == ET_PARAM_CHORD && o.knots == ET_KNOTRULE_PIEGL && o.algebra == ET_LINALG_QR &&
                         o.corners == ET_CORNERS_DEFAULT && o.p == 3 && o.q == 3 && o.control.nx == 12 && o.control.ny == 12,
                     "the defaults")
               ? PASS
               : FAIL;
}

verdict prop_fit_free(gen *g)
{
    problem c;
    et_fit f;
    et_fit empty;

    draw_problem(g, &c);
    memset(&empty, 0, sizeof empty);
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        f = empty;
    et_fit_free(&f);
    const bool ok = gen_check(g,
                              f.s[0] == NULL && f.s[1] == NULL && f.r[0] == NULL && f.r[1] == NULL && f.shell.view[0].points == NULL &&
                                  f.shell.view[1].points == NULL && f.data.nx == 0 && f.flat == 0,
                              "something is left");
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

verdict prop_fit_parameters(gen *g)
{
    problem c;
    et_fit f, was;
    et_vec3 D[NODES];
    double s[2][SIDE], r[2][SIDE];
    size_t flat[2];
    bool ok;

    draw_problem(g, &c);
    const et_fit_options *o = &c.options;
    memset(&f, 0x3c, sizeof f);
    was = f;
    ok = et_fit_parameters(&f, c.data, c.nov + 1, c.net, o->approach, o->method) == ET_EINVAL &&
         et_fit_parameters(&f, c.data, c.nov, (et_doublenet){c.net.nx, 1}, o->approach, o->method) == ET_EINVAL &&
         et_fit_parameters(&f, c.data, c.nov, c.net, (et_fit_approach)3, o->method) == ET_EINVAL &&
         et_fit_parameters(&f, c.data, c.nov, c.net, o->approach, (et_param_method)4) == ET_EINVAL;
    ok = gen_check(g, ok && memcmp(&f, &was, sizeof f) == 0, "bad arguments");
    if (!gen_check(g, et_fit_parameters(&f, c.data, c.nov, c.net, o->approach, o->method) == ET_OK, "made"))
        return FAIL;
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; i < c.net.nx; i++)
            for (size_t j = 0; j < c.net.ny; j++)
                D[i * c.net.ny + j] = c.data[et_doublenet_class(c.net, w, i, j) - 1];
        et_param_grid(s[w], c.net.nx, r[w], c.net.ny, &flat[w], D, o->method);
    }
    if (o->approach != ET_FIT_CONVENTIONAL) {
        et_param_standardise(s[0], s[1], c.net.nx);
        et_param_standardise(r[0], r[1], c.net.ny);
    }
    for (size_t w = 0; w < 2; w++)
        ok = gen_check(g, memcmp(s[w], f.s[w], c.net.nx * sizeof(double)) == 0 && memcmp(r[w], f.r[w], c.net.ny * sizeof(double)) == 0, "view %zu",
                       w) &&
             ok;
    ok = gen_check(g, f.flat == flat[0] + flat[1] && f.data.nx == c.net.nx && f.data.ny == c.net.ny && f.shell.view[0].u == NULL, "the rest") && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Node by node with et_surface_point: the same bits. */
verdict prop_fit_measure(gen *g)
{
    problem c;
    et_fit f;
    et_fit_error e = {1, 2, 3, 4};
    double node[CLASSES], class[CLASSES] = {0}, residual[CLASSES + 1], work[1024], greatest = 0, corner = 0;
    bool ok;

    draw_problem(g, &c);
    c.options.algebra = ET_LINALG_SVD; /* never deficient */
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return FAIL;
    if (et_surface_work(&f.shell.view[0]) > 1024)
        return FAIL;
    const size_t nodes = c.net.nx * c.net.ny;
    for (size_t w = 2; w-- > 0;)
        for (size_t i = 0; i < c.net.nx; i++)
            for (size_t j = 0; j < c.net.ny; j++) {
                const et_vec3 S = et_surface_point(&f.shell.view[w], f.s[w][i], f.r[w][j], work, 1024);
                const size_t k = et_doublenet_class(c.net, w, i, j) - 1;
                const double d = et_vec3_distance(c.data[k], S);
                node[w * nodes + i * c.net.ny + j] = class[k] = d;
                greatest = fmax(greatest, d);
                corner = corner_node(c.net, i, j) ? fmax(corner, d) : corner;
            }
    residual[0] = residual[c.nov] = 9;
    ok = gen_check(g, et_fit_measure(&e, residual, c.nov - 1, &f, c.data) == ET_EINVAL && e.nov == 1 && residual[0] == 9, "bad argument");
    ok = gen_check(g, et_fit_measure(&e, NULL, c.nov, &f, c.data) == ET_OK && et_fit_measure(&e, residual, c.nov, &f, c.data) == ET_OK, "measured") &&
         ok;
    ok = gen_check(g, e.nov == et_real_sum(class, c.nov), "over classes: %a", e.nov) && ok;
    ok = gen_check(g, e.non == et_real_sum(node, 2 * nodes), "over nodes: %a", e.non) && ok;
    ok = gen_check(g, e.greatest == greatest && e.corner == corner, "greatest %a, corner %a", e.greatest, e.corner) && ok;
    ok = gen_check(g, memcmp(residual, class, c.nov * sizeof *class) == 0 && residual[c.nov] == 9, "residuals") && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* ---- golden rows ---- */

static et_status fit_of(const row *r, et_fit *f, problem *c)
{
    et_fit_options *o = &c->options;

    *o = et_fit_defaults();
    o->approach = (et_fit_approach)row_size(r, 0);
    o->method = (et_param_method)row_size(r, 1);
    o->knots = (et_knotrule_kind)row_size(r, 2);
    o->algebra = (et_linalg_method)row_size(r, 3);
    o->corners = (et_fit_corners)row_size(r, 4);
    o->p = row_size(r, 5);
    o->q = row_size(r, 6);
    c->net = (et_doublenet){row_size(r, 7), row_size(r, 8)};
    o->control = (et_doublenet){row_size(r, 9), row_size(r, 10)};
    c->nov = et_doublenet_nov(c->net);
    for (size_t i = 0; i < c->nov; i++)
        c->data[i] = (et_vec3){row_real(r, 11 + 3 * i), row_real(r, 12 + 3 * i), row_real(r, 13 + 3 * i)};
    return et_fit_make(f, c->data, c->nov, c->net, o, NULL);
}

static bool read_fit(const row *r, et_fit *f, problem *c)
{
    return fit_of(r, f, c) == ET_OK;
}

/* Rows: approach method knots algebra corners p q nx ny cx cy, data by class; wanted: control points, bottom view then top. */
verdict gold_fit_make(const row *r)
{
    problem c;
    et_fit f;
    bool ok = read_fit(r, &f, &c);

    if (!ok)
        return FAIL;
    const size_t n = c.options.control.nx * c.options.control.ny;
    for (size_t i = 0; ok && i < 6 * n; i++)
        ok = row_is(r, i, (&f.shell.view[i / (3 * n)].points[i % (3 * n) / 3].x)[i % 3]);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Rows as above; wanted: the status alone. */
verdict gold_fit_make_status(const row *r)
{
    problem c;
    et_fit f;
    const et_status status = fit_of(r, &f, &c);

    if (status == ET_OK)
        et_fit_free(&f);
    return row_is_size(r, 0, (size_t)status) ? PASS : FAIL;
}

/* Rows as above; wanted: nov, non, greatest, corner. */
verdict gold_fit_measure(const row *r)
{
    problem c;
    et_fit f;
    et_fit_error e = {0, 0, 0, 0};
    bool ok = read_fit(r, &f, &c);

    if (!ok)
        return FAIL;
    ok = et_fit_measure(&e, NULL, c.nov, &f, c.data) == ET_OK && row_is(r, 0, e.nov) && row_is(r, 1, e.non) && row_is(r, 2, e.greatest) &&
         row_is(r, 3, e.corner);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Rows: approach method nx ny, data by class; wanted: flat, s and r of the bottom view, s and r of the top. */
verdict gold_fit_parameters(const row *r)
{
    const et_doublenet n = {row_size(r, 2), row_size(r, 3)};
    et_vec3 data[CLASSES];
    et_fit f;
    size_t k = 1;
    bool ok;

    for (size_t i = 0; i < et_doublenet_nov(n); i++)
        data[i] = (et_vec3){row_real(r, 4 + 3 * i), row_real(r, 5 + 3 * i), row_real(r, 6 + 3 * i)};
    if (et_fit_parameters(&f, data, et_doublenet_nov(n), n, (et_fit_approach)row_size(r, 0), (et_param_method)row_size(r, 1)) != ET_OK)
        return FAIL;
    ok = row_is_size(r, 0, f.flat);
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; ok && i < n.nx; i++)
            ok = row_is(r, k++, f.s[w][i]);
        for (size_t j = 0; ok && j < n.ny; j++)
            ok = row_is(r, k++, f.r[w][j]);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}
