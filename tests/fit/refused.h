/* refused: what a fit says when it refuses, word by word; for the fast and for the exact one. */
#ifndef TESTS_FIT_REFUSED_H
#define TESTS_FIT_REFUSED_H
#include "etalon/fit/fit.h"
#include "gen.h"
#include <stdio.h>
#include <string.h>

enum { REFUSED_CLASSES = 128 };
typedef et_status (*refused_make)(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, const et_fit_options *o, et_message *message);

/* A net whose rows (or columns) but the last stand at one place: with chord lengths only two parameters are different, 0 and 1. */
static void refused_data(et_vec3 *data, et_doublenet n, int across)
{
    for (size_t c = 1; c <= et_doublenet_nov(n); c++) {
        const et_index k = et_doublenet_index(n, c);
        const double i = across ? (double)k.i / 2 : k.i + 1 == n.nx, j = across ? k.j + 1 == n.ny : (double)k.j / 2;
        data[c - 1] = (et_vec3){ i, j, k.k == 2 ? 0.25 : 0 };
    }
}

static verdict refused_says(gen *g, refused_make make)
{
    const et_doublenet n = { gen_between(g, 5, 6), gen_between(g, 7, 8) };
    const uint64_t kind = gen_upto(g, 6);
    et_vec3 data[REFUSED_CLASSES];
    et_fit_options o = et_fit_defaults();
    et_message said = { "" }, want = { "" };
    size_t nov = et_doublenet_nov(n);
    et_status status = ET_EINVAL;
    et_fit f;

    refused_data(data, n, kind == 6);
    o.approach = ET_FIT_CONVENTIONAL;
    o.control = (et_doublenet){ 4, 5 };
    o.p = gen_between(g, 1, 3);
    o.q = o.p == 2 ? 1 : 2;
    if (kind == 0) {
        nov++;
        snprintf(want.text, sizeof want.text, "%zu points are not the classes of a double net %zux%zu", nov, n.nx, n.ny);
    } else if (kind == 1) {
        o.control.nx = 1;
        snprintf(want.text, sizeof want.text, "a control net 1x5 is too small");
    } else if (kind == 2) {
        o.control = (et_doublenet){ 3, 9 };
        snprintf(want.text, sizeof want.text, "control net 3x9 is larger than the data %zux%zu", n.nx, n.ny);
    } else if (kind == 3) {
        o.q = 6;
        snprintf(want.text, sizeof want.text, "degrees %zu and 6 do not suit a control net 4x5: at least 1, less than its side", o.p);
    } else if (kind == 4) {
        o.knots = ET_KNOTRULE_AVERAGING;
        snprintf(want.text, sizeof want.text, "averaged knots need as many control points (4x5) as data (%zux%zu)", n.nx, n.ny);
    } else {
        status = ET_ERANK;
        o.knots = ET_KNOTRULE_UNIFORM;
        snprintf(want.text, sizeof want.text, "bottom view, direction %s: the %zu parameters determine only 2 of %d control points", kind == 6 ? "v" : "u",
                 kind == 6 ? n.ny : n.nx, kind == 6 ? 5 : 4);
    }
    const et_status got = make(&f, data, nov, n, &o, &said);
    if (got == ET_OK)
        et_fit_free(&f);
    return gen_check(g, got == status && strcmp(said.text, want.text) == 0, "status %d: %s\n  not: %s", (int)got, said.text, want.text) ? PASS : FAIL;
}
#endif
