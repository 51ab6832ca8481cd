/* fit/enclosure: what is refused, shared or not, and data and parameters that leave nothing to prove. */
#include "fit/enclosed.h"

/* ---- properties ---- */

/* Everything that is wrong with the arguments, one at a time. */
verdict prop_enclosure_make_refuses(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, was;
    et_message message;
    double weight[NODES];
    bool ok;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    if (!frame_of(&f, &c))
        return FAIL;
    memset(&e, 0x3c, sizeof e);
    was = e;
    for (size_t i = 0; i < NODES; i++)
        weight[i] = 1;
    const et_fit good = f;
    et_fit_options o = c.options;
    size_t nov = c.nov;
    const double last = f.s[1][c.net.nx - 1], knot = f.shell.view[1].v[f.shell.view[1].nv];
    const size_t kind = gen_upto(g, 13);
    double end = 1;
    switch (kind) {
    case 0: nov++; break;
    case 1: nov--; break;
    case 2: o.approach = (et_fit_approach)3; break;
    case 3: o.corners = (et_fit_corners)3; break;
    case 4: o.p++; break;
    case 5: o.q = 0; break;
    case 6: o.control.nx++; break;
    case 7: o.control.ny--; break;
    case 8: f.shell.view[0].weights = f.shell.view[1].weights = weight; break;
    case 9: f.s[1][c.net.nx - 1] = end = 0.999; break;
    case 10: f.shell.view[1].v[f.shell.view[1].nv] = 1 - 0x1p-53; break;
    case 11: f.r[0] = NULL; break;
    case 12: f.s[0][0] = 0x1p-60; break;
    default: f.data.nx = 1; break;
    }
    message.text[0] = 0;
    ok = gen_check(g, et_enclosure_make(&e, &f, c.data, nov, &o, &message) == ET_EINVAL && message.text[0] != 0, "case %zu, make", kind);
    ok = gen_check(g, et_enclosure_refine(&f, &e, c.data, nov, &o, &message) == ET_EINVAL, "case %zu, refine", kind) && ok;
    ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0, "case %zu, unchanged", kind) && ok;
    f.s[1][c.net.nx - 1] = last;
    f.shell.view[1].v[f.shell.view[1].nv] = knot;
    (void)end;
    f = good;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Views that do not share what the approach shares; parameters out of order. */
verdict prop_enclosure_make_unshared(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e;
    et_status want;

    draw_options(g, &c, SIDE);
    draw_data(g, &c);
    c.net.nx = c.options.control.nx = 4;
    c.nov = et_doublenet_nov(c.net);
    c.options.p = gen_between(g, 1, 3);
    c.options.method = ET_PARAM_UNIFORM;
    for (size_t i = 0; i < c.nov; i++)
        c.data[i] = (et_vec3){(double)i, 1, 2};
    if (!frame_of(&f, &c))
        return FAIL;
    want = c.options.approach == ET_FIT_CONVENTIONAL ? ET_OK : ET_EINVAL;
    const size_t kind = gen_upto(g, 2);
    if (kind == 0)
        f.s[1][1] += 0x1p-40;
    else if (kind == 1)
        f.shell.view[0].v[0] = f.shell.view[0].v[0]; /* nothing: what is shared is accepted */
    else
        f.s[0][1] = f.s[1][1] = nextafter(f.s[0][2], 1);
    want = kind == 1 ? ET_OK : kind == 2 ? ET_EINVAL : want;
    const et_status status = et_enclosure_make(&e, &f, c.data, c.nov, &c.options, NULL);
    const bool ok = gen_check(g, status == want, "case %zu: status %d, wanted %d", kind, (int)status, (int)want);
    if (status == ET_OK)
        et_enclosure_free(&e);
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Interior parameters an ulp apart: full rank, but past what double-double can bound; and coincident ones: deficient. */
verdict prop_enclosure_make_hopeless(gen *g)
{
    problem c;
    et_fit f;
    et_enclosure e, was;
    et_message message;
    bool ok;
    const bool coincident = gen_upto(g, 1);

    memset(&c, 0, sizeof c);
    c.net = c.options.control = (et_doublenet){4, gen_between(g, 2, 4)};
    c.options = et_fit_defaults();
    c.options.control = c.net;
    c.options.q = 1;
    c.options.method = ET_PARAM_UNIFORM;
    c.options.approach = (et_fit_approach)gen_upto(g, 2);
    c.options.corners = (et_fit_corners)gen_upto(g, 2);
    c.nov = et_doublenet_nov(c.net);
    for (size_t i = 0; i < c.nov; i++)
        c.data[i] = (et_vec3){(double)i, 1, (double)(i * i)};
    if (!frame_of(&f, &c))
        return FAIL;
    f.s[0][2] = f.s[1][2] = coincident ? f.s[0][1] : nextafter(f.s[0][1], 1);
    memset(&e, 0x3c, sizeof e);
    was = e;
    message.text[0] = 0;
    const et_status want = coincident ? ET_ERANK : ET_ENOCONV;
    const et_vec3 first = f.shell.view[0].points[0];
    ok = gen_check(g, et_enclosure_make(&e, &f, c.data, c.nov, &c.options, &message) == want && message.text[0] != 0, "make: %s", message.text);
    ok = gen_check(g, et_enclosure_refine(&f, &e, c.data, c.nov, &c.options, &message) == want, "refine: %s", message.text) && ok;
    ok = gen_check(g, memcmp(&e, &was, sizeof e) == 0 && memcmp(&first, f.shell.view[0].points, sizeof first) == 0, "unchanged") && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* The terms of the bound that rounding alone never fills, filled on purpose: right-hand sides moved by the whole of their error (kind 0), or entries
 * of the matrix by 2^-30 of themselves, and `relative` says so (kind 1).  The radius must cover what that does to the solution; the factor is for the
 * products of 2^-30 with itself and with the condition, which `relative`, some u^2 in earnest, leaves out. */
verdict prop_enclosure_make_uncertain(gen *g)
{
    static const double t[6] = {0, 0.125, 0.375, 0.5, 0.8125, 1}, u[8] = {0, 0, 0, 0.25, 0.625, 1, 1, 1};
    enclosure_system s, moved;
    et_dd d[6], e[6], x[5], y[5];
    double error[6], none[6] = {0}, r[5], q[5];
    const int kind = (int)gen_upto(g, 1);
    bool ok;

    if (enclosure_direction(&s, t, 6, u, 5, 2, 0) != ET_OK ||
        enclosure_direction(&moved, t, 6, u, 5, 2, 0) != ET_OK)
        return FAIL;
    for (size_t i = 0; i < 6; i++) {
        d[i] = e[i] = (et_dd){(double)gen_between(g, 1, 16) * (gen_upto(g, 1) ? -1 : 1), 0};
        error[i] = kind == 0 && gen_upto(g, 3) ? 0x1p-20 : 0;
        e[i].hi += gen_upto(g, 1) ? error[i] : -error[i];
    }
    for (size_t k = 0; kind == 1 && k < 18; k++)
        moved.a[k].hi *= 1 + (gen_upto(g, 1) ? 0x1p-30 : -0x1p-30);
    s.relative = kind == 1 ? 0x1p-30 : s.relative;
    ok = enclosure_verify(&s) == ET_OK && enclosure_verify(&moved) == ET_OK;
    if (ok) {
        enclosure_column(x, r, &s, d, error);
        enclosure_column(y, q, &moved, e, none);
        for (size_t j = 0; j < 5; j++) {
            const double off = fabs(et_dd_sub(x[j], y[j]).hi);
            ok = gen_check(g, off <= (r[j] + q[j]) * (1 + 0x1p-16), "kind %d: %g off, radius %g", kind, off, r[j]) && ok;
        }
    }
    enclosure_system_free(&s);
    enclosure_system_free(&moved);
    return ok ? PASS : FAIL;
}
