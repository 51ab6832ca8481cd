/* fit: the defaults by hand, and the same again. */
#include "etalon/fit/fit.h"
#include "gen.h"
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
