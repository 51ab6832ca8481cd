/* fit: the defaults by hand, and the same again. */
#include "etalon/fit/fit.h"
#include "gen.h"
#include <math.h>
#include <string.h>

enum { SIDE = 14, CLASSES = 2 * SIDE * SIDE };

/* One case in 50. */
verdict prop_fit_defaults_used(gen *g)
{
    const et_fit_options by_hand = {.approach = ET_FIT_IMPROVED, .method = ET_PARAM_CHORD, .knots = ET_KNOTRULE_PIEGL, .algebra = ET_LINALG_QR,
                                    .corners = ET_CORNERS_DEFAULT, .p = 3, .q = 3, .control = {12, 12}};
    const et_doublenet net = {gen_between(g, 12, SIDE), gen_between(g, 12, SIDE)};
    const size_t nov = et_doublenet_nov(net);
    static et_vec3 data[CLASSES];
    et_fit f[2];
    bool ok = true;

    for (size_t c = 1; c <= nov; c++) {
        const et_index at = et_doublenet_index(net, c);
        data[c - 1] = (et_vec3){(double)at.i + gen_real(g, 0, 0.5), (double)at.j + gen_real(g, 0, 0.5), (double)at.k};
    }
    for (int k = 0; k < 2; k++) {
        const et_fit_options o = k ? by_hand : et_fit_defaults();
        ok = gen_check(g, et_fit_make(&f[k], data, nov, net, &o, NULL) == ET_OK, "not made") && ok;
        if (!ok)
            return FAIL;
    }
    for (size_t w = 0; w < 2; w++)
        ok = ok && gen_check(g, memcmp(f[0].shell.view[w].points, f[1].shell.view[w].points, 144 * sizeof(et_vec3)) == 0 &&
                                    memcmp(f[0].shell.view[w].u, f[1].shell.view[w].u, 16 * sizeof(double)) == 0 &&
                                    memcmp(f[0].s[w], f[1].s[w], net.nx * sizeof(double)) == 0, "view %zu is another", w);
    et_fit_free(&f[0]);
    et_fit_free(&f[1]);
    return ok ? PASS : FAIL;
}

/* Data and control points 2^e times as far: all errors 2^e times as great. */
/* One case in 20. */
verdict prop_fit_measure_scaled(gen *g)
{
    const et_doublenet net = {gen_between(g, 4, 8), gen_between(g, 4, 8)};
    const size_t nov = et_doublenet_nov(net);
    const int e = (int)gen_upto(g, 60);
    et_fit_options o = et_fit_defaults();
    static et_vec3 data[CLASSES];
    double near[CLASSES], far[CLASSES];
    et_fit_error a, b;
    et_fit f;

    o.control = (et_doublenet){4, 4};
    for (size_t c = 1; c <= nov; c++) {
        const et_index at = et_doublenet_index(net, c);
        data[c - 1] = (et_vec3){(double)at.i + gen_real(g, 0, 0.5), (double)at.j + gen_real(g, 0, 0.5), (double)at.k};
    }
    if (!gen_check(g, et_fit_make(&f, data, nov, net, &o, NULL) == ET_OK, "not made"))
        return FAIL;
    bool ok = gen_check(g, et_fit_measure(&a, near, nov, &f, data) == ET_OK, "not measured");
    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; k < 16; k++) {
            et_vec3 *P = &f.shell.view[w].points[k];
            *P = (et_vec3){ldexp(P->x, e), ldexp(P->y, e), ldexp(P->z, e)};
        }
    for (size_t c = 0; c < nov; c++)
        data[c] = (et_vec3){ldexp(data[c].x, e), ldexp(data[c].y, e), ldexp(data[c].z, e)};
    ok = ok && gen_check(g, et_fit_measure(&b, far, nov, &f, data) == ET_OK, "not measured");
    ok = ok && gen_check(g, b.nov == ldexp(a.nov, e) && b.non == ldexp(a.non, e) && b.greatest == ldexp(a.greatest, e) &&
            b.corner == ldexp(a.corner, e),
                         "2^%d times: %a, not %a", e, b.nov, ldexp(a.nov, e));
    for (size_t c = 0; ok && c < nov; c++)
        ok = gen_check(g, far[c] == ldexp(near[c], e), "class %zu: %a, not %a", c + 1, far[c], ldexp(near[c], e));
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}
