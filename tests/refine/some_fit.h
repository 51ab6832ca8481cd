/* some_fit: room for a fit, and its two views made alike; for the tests of objective and optimum. */
#ifndef TESTS_REFINE_SOME_FIT_H
#define TESTS_REFINE_SOME_FIT_H
#include "etalon/fit/fit.h"
#include <stdlib.h>
#include <string.h>

/* Everything 0. */
static inline bool some_fit_new(et_fit *f, size_t p, size_t q, et_doublenet control, et_doublenet data)
{
    memset(f, 0, sizeof *f);
    f->data = data;
    if (et_shell_new(&f->shell, p, q, control, 0) != ET_OK)
        return false;
    for (size_t w = 0; w < 2; w++) {
        f->s[w] = calloc(data.nx, sizeof(double));
        f->r[w] = calloc(data.ny, sizeof(double));
    }
    if (f->s[0] && f->s[1] && f->r[0] && f->r[1])
        return true;
    et_fit_free(f);
    return false;
}

/* The top view's knots and parameters are the bottom's. */
static inline void some_fit_share(et_fit *f)
{
    const et_surface *const a = &f->shell.view[ET_BOTTOM], *const b = &f->shell.view[ET_TOP];

    memcpy(b->u, a->u, (a->nu + a->p + 1) * sizeof *a->u);
    memcpy(b->v, a->v, (a->nv + a->q + 1) * sizeof *a->v);
    memcpy(f->s[ET_TOP], f->s[ET_BOTTOM], f->data.nx * sizeof(double));
    memcpy(f->r[ET_TOP], f->r[ET_BOTTOM], f->data.ny * sizeof(double));
}
#endif
