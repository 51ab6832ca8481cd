/* fit/enclosure: refined points are the exact ones, rounded; golden rows. */
#include "fit/enclosed.h"

/* ---- properties ---- */

verdict prop_enclosure_free(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    bool ok;

    memset(&e, 0, sizeof e);
    if (!draw_fit(g, &f, &c, 3))
        return FAIL;
    const et_status status = et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL);
    et_enclosure_free(&e);
    ok = gen_check(g, e.radius[0] == NULL && e.radius[1] == NULL && e.count == 0 && e.undecided == 0 && e.condition == 0 && e.backward == 0,
                   "something is left, status %d", (int)status);
    et_enclosure_free(&e);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

static bool same_points(const et_fit *a, const et_fit *b)
{
    const size_t n = a->shell.view[0].nu * a->shell.view[0].nv;

    return memcmp(a->shell.view[0].points, b->shell.view[0].points, n * sizeof(et_vec3)) == 0 &&
           memcmp(a->shell.view[1].points, b->shell.view[1].points, n * sizeof(et_vec3)) == 0;
}

/* Corners that stand are the data's bits; a coordinate zero throughout is +0, with radius 0. */
static bool zeros_and_corners(gen *g, const problem *c, const et_fit *f, const et_enclosure *e)
{
    const et_doublenet k = c->options.control;
    bool ok = true;

    for (size_t m = 0; m < 3; m++) {
        bool zero = true;
        for (size_t i = 0; i < c->nov; i++)
            zero = zero && (&c->data[i].x)[m] == 0;
        for (size_t at = 0; at < 2 * e->count; at++) {
            const size_t w = at / e->count, a = at % e->count / k.ny, b = at % k.ny;
            const double p = (&f->shell.view[w].points[a * k.ny + b].x)[m], r = (&e->radius[w][a * k.ny + b].x)[m];
            if (corners_fixed(&c->options) && corner_node(k, a, b))
                ok = gen_check(g, memcmp(&p, &(&corner_data(c, a, b)->x)[m], sizeof p) == 0 && r == 0, "corner %zu %zu: %a, radius %g", a, b, p, r) &&
                     ok;
            else if (zero)
                ok = gen_check(g, p == 0 && !signbit(p) && r == 0, "zero: %a, radius %g", p, r) && ok;
        }
    }
    return ok;
}

static bool refined_again(gen *g, const problem *c, et_fit *f, const et_enclosure *e)
{
    et_fit other = *f;
    et_enclosure again;
    bool ok;

    memset(&other.shell, 0, sizeof other.shell);
    if (et_shell_copy(&other.shell, &f->shell) != ET_OK)
        return false;
    fill(g, &other, c);
    ok = gen_check(g, et_enclosure_refine(&other, NULL, c->data, c->nov, &c->options, NULL) == ET_OK, "refined from elsewhere");
    ok = gen_check(g, same_points(f, &other), "another start, other bits") && ok;
    if (et_enclosure_make(&again, f, c->data, c->nov, &c->options, NULL) == ET_OK) {
        ok = gen_check(g, again.undecided == e->undecided && memcmp(again.radius[0], e->radius[0], e->count * sizeof(et_vec3)) == 0 &&
                              memcmp(again.radius[1], e->radius[1], e->count * sizeof(et_vec3)) == 0 && again.backward == e->backward &&
                              again.condition == e->condition,
                       "the refinement's enclosure is not that of its points") &&
             ok;
        et_enclosure_free(&again);
    } else {
        ok = gen_check(g, false, "no enclosure of what was refined");
    }
    et_shell_free(&other.shell);
    return ok;
}

/* One case in 4. */
verdict prop_enclosure_refine(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, was;
    exact x;
    bool ok = true;

    if (!draw_fit(g, &f, &c, 4))
        return FAIL;
    memset(&e, 0x3c, sizeof e);
    was = e;
    const et_vec3 first = f.shell.view[1].points[0];
    const et_status status = et_enclosure_refine(&f, &e, c.data, c.nov, &c.options, NULL);
    if (status == ET_EFORMAT) {
        gen_label(g, "overflow");
        ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0, "unchanged");
    } else if (status != ET_OK) {
        ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0 && memcmp(&first, f.shell.view[1].points, sizeof first) == 0, "unchanged") &&
             status_right(g, status, &c, &f);
    } else {
        solve_exactly(&x, &c, &f, false);
        gen_label(g, e.undecided ? "undecided" : "decided");
        ok = gen_check(g, x.full, "refined, but no unique solution") && encloses(g, &c, &f, &e, &x) && decided(g, &c, &f, &e, &x);
        ok = ok && zeros_and_corners(g, &c, &f, &e) && refined_again(g, &c, &f, &e);
        ok = gen_check(g, c.options.approach == ET_FIT_CONVENTIONAL || et_shell_glued(&f.shell), "closed") && ok;
        exact_clear(&x);
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Data of all bits on well-conditioned nets: every coordinate is decided, and is the exact one rounded. */
verdict prop_enclosure_refine_decides(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    exact x;
    bool ok;

    draw_options(g, &c, 4);
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_PIEGL;
    for (size_t i = 0; i < c.nov; i++) /* odd last bits: no ties, no zeros */
        for (size_t m = 0; m < 3; m++)
            (&c.data[i].x)[m] = (double)(2 * (gen_upto(g, UINT64_C(1) << 51)) + 1) * 0x1p-52 + (m == 2 ? 3 : 1);
    if (!frame_of(&f, &c))
        return FAIL;
    ok = gen_check(g, et_enclosure_refine(&f, &e, c.data, c.nov, &c.options, NULL) == ET_OK, "refined");
    if (ok) {
        solve_exactly(&x, &c, &f, false);
        ok = gen_check(g, e.condition < 1e4, "condition %g", e.condition) && decided(g, &c, &f, &e, &x);
        gen_label(g, e.undecided ? "undecided" : "all decided");
        exact_clear(&x);
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Turning the net (rows for columns) and exchanging views give the same control points, turned. */
verdict prop_enclosure_refine_symmetry(gen *g)
{
    problem c, t;
    et_fit f, h;
    et_enclosure e;
    bool ok = true;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    if (!frame_of(&f, &c))
        return FAIL;
    t = c;
    t.net = (et_doublenet){c.net.ny, c.net.nx};
    t.options.control = (et_doublenet){c.options.control.ny, c.options.control.nx};
    t.options.p = c.options.q;
    t.options.q = c.options.p;
    for (size_t at = 0; at < 2 * c.net.nx * c.net.ny; at++) {
        const size_t w = at % 2, i = at / 2 / c.net.ny, j = at / 2 % c.net.ny;
        t.data[et_doublenet_class(t.net, w, j, i) - 1] = c.data[et_doublenet_class(c.net, 1 - w, i, j) - 1];
    }
    memset(&h, 0, sizeof h);
    if (et_fit_parameters(&h, t.data, t.nov, t.net, t.options.approach, t.options.method) != ET_OK ||
        et_shell_new(&h.shell, t.options.p, t.options.q, t.options.control, 0) != ET_OK)
        return FAIL;
    for (size_t w = 0; w < 2; w++) {
        const et_surface *v = &f.shell.view[1 - w];
        memcpy(h.s[w], f.r[1 - w], t.net.nx * sizeof(double));
        memcpy(h.r[w], f.s[1 - w], t.net.ny * sizeof(double));
        memcpy(h.shell.view[w].u, v->v, (v->nv + v->q + 1) * sizeof(double));
        memcpy(h.shell.view[w].v, v->u, (v->nu + v->p + 1) * sizeof(double));
    }
    const et_status a = et_enclosure_refine(&f, &e, c.data, c.nov, &c.options, NULL);
    if (a == ET_OK && e.undecided == 0) {
        et_enclosure_free(&e);
        ok = gen_check(g, et_enclosure_refine(&h, &e, t.data, t.nov, &t.options, NULL) == ET_OK, "turned");
        ok = ok && gen_check(g, e.undecided > 0 || e.condition > 0, "turned");
        for (size_t at = 0; ok && e.undecided == 0 && at < 2 * e.count; at++) {
            const size_t w = at / e.count, i = at % e.count / c.options.control.ny, j = at % c.options.control.ny;
            const et_vec3 p = f.shell.view[w].points[i * c.options.control.ny + j], q = h.shell.view[1 - w].points[j * c.options.control.nx + i];
            ok = gen_check(g, p.x == q.x && p.y == q.y && p.z == q.z, "view %zu (%zu,%zu)", w, i, j);
        }
    }
    if (a == ET_OK)
        et_enclosure_free(&e);
    et_fit_free(&f);
    et_fit_free(&h);
    return ok ? PASS : FAIL;
}

/* ---- golden rows ---- */

static const double *take(double *to, size_t n, const row *r, size_t *at)
{
    for (size_t i = 0; i < n; i++)
        to[i] = row_real(r, (*at)++);
    return to;
}

/* Rows: approach corners p q nx ny cx cy, then for the view, or for each of two (conventional), its parameters s and r and knots u and v; the data by
 * class.  Wanted: control points, bottom view then top. */
verdict gold_enclosure_refine(const row *r)
{
    et_fit_options o = et_fit_defaults();
    const et_doublenet n = {row_size(r, 4), row_size(r, 5)};
    et_vec3 data[128];
    et_fit f;
    et_enclosure e;
    size_t at = 8;
    bool ok;

    o.approach = (et_fit_approach)row_size(r, 0);
    o.corners = (et_fit_corners)row_size(r, 1);
    o.p = row_size(r, 2);
    o.q = row_size(r, 3);
    o.control = (et_doublenet){row_size(r, 6), row_size(r, 7)};
    memset(data, 0, sizeof data);
    if (et_doublenet_nov(n) > sizeof data / sizeof *data ||
        et_fit_parameters(&f, data, et_doublenet_nov(n), n, o.approach, ET_PARAM_UNIFORM) != ET_OK)
        return FAIL;
    if (et_shell_new(&f.shell, o.p, o.q, o.control, 0) != ET_OK) {
        et_fit_free(&f);
        return FAIL;
    }
    for (size_t w = 0; w < 2; w++) {
        et_surface *v = &f.shell.view[w];
        at = w == 1 && o.approach != ET_FIT_CONVENTIONAL ? 8 : at;
        take(f.s[w], n.nx, r, &at);
        take(f.r[w], n.ny, r, &at);
        take(v->u, v->nu + v->p + 1, r, &at);
        take(v->v, v->nv + v->q + 1, r, &at);
    }
    take(&data[0].x, 3 * et_doublenet_nov(n), r, &at);
    ok = et_enclosure_refine(&f, &e, data, et_doublenet_nov(n), &o, NULL) == ET_OK;
    if (ok) {
        const size_t count = e.count;
        ok = e.undecided == 0;
        et_enclosure_free(&e);
        for (size_t i = 0; ok && i < 6 * count; i++)
            ok = row_is(r, i, (&f.shell.view[i / (3 * count)].points[i % (3 * count) / 3].x)[i % 3]);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}
