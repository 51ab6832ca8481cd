#include "etalon/fit/enclosure.h"
#include "gen.h"
#include <stdio.h>
#include <string.h>

/* What an enclosure says when it refuses, word by word. */
verdict prop_enclosure_make_says(gen *g)
{
    const et_doublenet n = { gen_between(g, 5, 6), gen_between(g, 7, 8) };
    const size_t kind = (size_t)gen_upto(g, 3), w = (size_t)gen_upto(g, 1), nov = et_doublenet_nov(n) + (kind == 0);
    et_vec3 data[128];
    et_fit_options o = et_fit_defaults();
    et_message said = { "" }, want = { "" };
    et_enclosure e;
    et_fit f;

    for (size_t c = 1; c <= et_doublenet_nov(n); c++) {
        const et_index k = et_doublenet_index(n, c);
        data[c - 1] = (et_vec3){ (double)k.i, (double)k.j, k.k == 2 ? 0.25 : 0 };
    }
    o.approach = ET_FIT_CONVENTIONAL;
    o.knots = ET_KNOTRULE_UNIFORM;
    o.control = (et_doublenet){ 4, 5 };
    o.p = o.q = 2;
    if (et_fit_make(&f, data, et_doublenet_nov(n), n, &o, &said) != ET_OK)
        return FAIL;
    if (kind == 0)
        snprintf(want.text, sizeof want.text, "%zu points are not the classes of a double net %zux%zu", nov, n.nx, n.ny);
    else if (kind == 1)
        snprintf(want.text, sizeof want.text, "the fit's shell or parameters are not those of its options");
    else
        snprintf(want.text, sizeof want.text, "%s view, direction %s: the %zu parameters determine only 2 of %d control points", w ? "top" : "bottom",
                 kind == 2 ? "u" : "v", kind == 2 ? n.nx : n.ny, kind == 2 ? 4 : 5);
    if (kind == 1)
        o.p = 3;
    for (size_t i = 0; kind == 2 && i + 1 < n.nx; i++)
        f.s[w][i] = 0;
    for (size_t j = 0; kind == 3 && j + 1 < n.ny; j++)
        f.r[w][j] = 0;
    const et_status got = et_enclosure_make(&e, &f, data, nov, &o, &said);
    if (got == ET_OK)
        et_enclosure_free(&e);
    et_fit_free(&f);
    return gen_check(g, got == (kind < 2 ? ET_EINVAL : ET_ERANK) && strcmp(said.text, want.text) == 0, "status %d: %s\n  not: %s", (int)got, said.text,
                     want.text) ? PASS : FAIL;
}
