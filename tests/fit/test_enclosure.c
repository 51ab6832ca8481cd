/* fit/enclosure: radii hold the exact solution; data moved, condition numbers, backward errors, residuals that are known. */
#include "fit/enclosed.h"

/* ---- properties ---- */

/* One case in 4. */
verdict prop_enclosure_make(gen *g)
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
    const et_status status = et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL);
    if (status != ET_OK) {
        ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0, "unchanged") && status_right(g, status, &c, &f);
    } else {
        solve_exactly(&x, &c, &f, false);
        ok = gen_check(g, x.full, "a bound, but no unique solution") && gen_check(g, e.count == c.options.control.nx * c.options.control.ny, "count");
        ok = ok && encloses(g, &c, &f, &e, &x) && decided(g, &c, &f, &e, &x);
        exact_clear(&x);
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* A coordinate moved by an ulp or by much more: the radius tells. */
verdict prop_enclosure_make_moved(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, moved;
    bool ok;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return SKIP;
    if (et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL) != ET_OK) {
        et_fit_free(&f);
        return SKIP;
    }
    const size_t w = gen_upto(g, 1), at = gen_upto(g, e.count - 1), m = gen_upto(g, 2);
    double *p = &(&f.shell.view[w].points[at].x)[m];
    const double was = *p, r = (&e.radius[w][at].x)[m];
    *p = gen_upto(g, 1) ? nextafter(*p, HUGE_VAL) : *p + 1e-6 * fabs(*p);
    ok = gen_check(g, et_enclosure_make(&moved, &f, c.data, c.nov, &c.options, NULL) == ET_OK, "made");
    if (ok) {
        const double s = (&moved.radius[w][at].x)[m], step = *p - was;
        ok = gen_check(g, s >= (step - r) * (1 - 0x1p-50), "radius %g after a step of %g, %g before", s, step, r);
        ok = gen_check(g, s <= (step + r) * (1 + 0x1p-40) + 0x1p-1072, "radius %g after a step of %g, %g before", s, step, r) && ok;
        ok = gen_check(g, step <= 4 * r || moved.backward >= e.backward || moved.undecided > 0, "a step tells nothing") && ok;
        et_enclosure_free(&moved);
    }
    et_enclosure_free(&e);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* condition: against the exact Gram matrix, whose row sums are within a factor n of its 2-norm, and the estimate at least half of the value. */
/* One case in 4. */
verdict prop_enclosure_make_condition(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    exact x;
    bool ok = true;

    if (!draw_fit(g, &f, &c, 4))
        return FAIL;
    const et_status status = et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL);
    if (status == ET_OK) {
        const double n = 2 * (double)(c.options.control.nx * c.options.control.ny);
        solve_exactly(&x, &c, &f, true);
        if (e.condition < 1e9)
            ok = gen_check(g, e.condition <= sqrt(x.square) * (c.options.approach == ET_FIT_JOINT ? 1.0001 : n), "condition %g, bound %g",
                           e.condition, sqrt(x.square)) &&
                 gen_check(g, 2 * e.condition * sqrt(n) >= sqrt(x.square / n), "condition %g, at least %g", e.condition, sqrt(x.square / n));
        ok = gen_check(g, e.condition >= 1 - 1e-12, "condition %g", e.condition) && ok;
        exact_clear(&x);
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* backward: a stable solver's is a few eps; a fit whose control points are all scaled by 1 + h is h off. */
verdict prop_enclosure_make_backward(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, off;
    bool ok;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    c.options.algebra = ET_LINALG_QR;
    c.options.approach = gen_upto(g, 1) ? ET_FIT_JOINT : ET_FIT_CONVENTIONAL;
    c.options.corners = ET_CORNERS_FREE;
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return SKIP;
    if (et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL) != ET_OK) {
        et_fit_free(&f);
        return SKIP;
    }
    note(g, &f, &c);
    /* The gradient is at most 64 (rows + 8)(columns + 8) u |N| (|D| + |N| |P|) (as the properties of et_fit_make hold it to), through the inverse. */
    const double n = (double)(c.options.control.nx * c.options.control.ny), size = 64 * (2 * (double)c.nov + 8) * (2 * n + 8) * (1 + e.condition);
    bool coarse = false; /* near the least doubles results are rounded to multiples of 2^-1074 */
    for (size_t i = 0; i < c.nov; i++)
        for (size_t m = 0; m < 3; m++)
            coarse = coarse || ((&c.data[i].x)[m] != 0 && fabs((&c.data[i].x)[m]) < 0x1p-960);
    ok = gen_check(g, e.backward >= 0 && (coarse || e.backward <= size * (1 + e.condition)), "backward error %g eps", e.backward);
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < (size_t)n; at++) {
            et_vec3 *p = &f.shell.view[w].points[at];
            *p = (et_vec3){p->x * (1 + 0x1p-10), p->y * (1 + 0x1p-10), p->z * (1 + 0x1p-10)};
        }
    ok = gen_check(g, et_enclosure_make(&off, &f, c.data, c.nov, &c.options, NULL) == ET_OK, "made") && ok;
    if (ok) {
        /* |N e| / |P| is at most |N| 2^-10 (1 + 2^-10) and what was off before. */
        ok = gen_check(g, off.backward <= 0x1p42 * 1.01 + 2 * e.backward, "scaled: %g eps", off.backward);
        et_enclosure_free(&off);
    }
    et_enclosure_free(&e);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Interpolation with degree 1 at knots that are the parameters: N is the identity, and of a coordinate all 1 that became 1 + h the backward error
 * is h / sqrt((1 + h)^2 + h^2). */
verdict prop_enclosure_make_identity(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    const double h = ldexp(1, -(int)gen_between(g, 10, 30));
    bool ok;

    memset(&c, 0, sizeof c);
    c.net = (et_doublenet){gen_between(g, 2, 4), gen_between(g, 2, 4)};
    c.nov = et_doublenet_nov(c.net);
    c.options = et_fit_defaults();
    c.options.approach = gen_upto(g, 1) ? ET_FIT_JOINT : ET_FIT_CONVENTIONAL;
    c.options.corners = ET_CORNERS_FREE;
    c.options.method = ET_PARAM_UNIFORM;
    c.options.knots = ET_KNOTRULE_AVERAGING;
    c.options.p = c.options.q = 1;
    c.options.control = c.net;
    for (size_t i = 0; i < c.nov; i++)
        c.data[i] = (et_vec3){1 + (double)gen_upto(g, 3), 1, 3};
    if (et_fit_make(&f, c.data, c.nov, c.net, &c.options, NULL) != ET_OK)
        return FAIL;
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < c.net.nx * c.net.ny; at++)
            f.shell.view[w].points[at].y = 1 + h;
    ok = gen_check(g, et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL) == ET_OK, "made");
    if (ok) {
        ok = gen_check(g, fabs(e.condition - 1) < 1e-12, "condition %g", e.condition);
        ok = gen_check(g, fabs(e.backward * 0x1p-52 * sqrt((1 + h) * (1 + h) + h * h) / h - 1) < 1e-9, "backward error %g eps, moved by %g",
                       e.backward, h) &&
             ok;
        for (size_t w = 0; w < 2; w++)
            for (size_t at = 0; at < e.count; at++)
                ok = gen_check(g, fabs(e.radius[w][at].y / h - 1) < 1e-12 && e.radius[w][at].x < 1e-27 && e.radius[w][at].z < 1e-27,
                               "radii %g %g %g", e.radius[w][at].x, e.radius[w][at].y, e.radius[w][at].z) &&
                     ok;
        ok = gen_check(g, e.undecided == 2 * e.count, "%zu undecided", e.undecided) && ok;
        et_enclosure_free(&e);
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}
