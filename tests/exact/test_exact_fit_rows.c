/* The rows of et_fit, recomputed. */
#include "exact/fitted.h"

/* ---- the rows of et_fit, recomputed ---- */

static et_vec3 *read_data(const row *r, size_t first, et_doublenet n, size_t *nov)
{
    et_vec3 *data;

    if (!et_doublenet_valid(n) || r->nargs != first + 3 * et_doublenet_nov(n))
        return NULL;
    *nov = et_doublenet_nov(n);
    data = calloc(*nov, sizeof *data);
    for (size_t i = 0; data != NULL && i < 3 * *nov; i++)
        (&data[i / 3].x)[i % 3] = row_real(r, first + i);
    return data;
}

/* Rows: approach method knots algebra corners p q nx ny cx cy, data by class.  ET_EINTERNAL for a malformed one. */
static et_status fit_of(const row *r, et_fit *f)
{
    const et_doublenet n = {row_size(r, 7), row_size(r, 8)};
    et_fit_options o = et_fit_defaults();
    size_t nov = 0;
    et_vec3 *data = read_data(r, 11, n, &nov);
    et_status status;

    if (data == NULL)
        return ET_EINTERNAL;
    o.approach = (et_fit_approach)row_size(r, 0);
    o.method = (et_param_method)row_size(r, 1);
    o.knots = (et_knotrule_kind)row_size(r, 2);
    o.corners = (et_fit_corners)row_size(r, 4);
    o.p = row_size(r, 5);
    o.q = row_size(r, 6);
    o.control = (et_doublenet){row_size(r, 9), row_size(r, 10)};
    status = fit_make(f, data, nov, n, &o, NULL, NULL, NULL);
    free(data);
    return status;
}

/* Wanted: control points, bottom view then top. */
verdict true_fit_make(const row *r)
{
    et_fit f;
    bool ok = true;

    if (fit_of(r, &f) != ET_OK)
        return FAIL;
    for (size_t i = 0; i < 6 * controls(&f); i++)
        ok = row_is(r, i, (&f.shell.view[i / (3 * controls(&f))].points[i % (3 * controls(&f)) / 3].x)[i % 3]) && ok;
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}

/* Wanted: the status alone.  SVD's least norm, which is never deficient, has no exact counterpart, and what is no algebra is not seen. */
verdict true_fit_make_status(const row *r)
{
    et_fit f;
    et_status status;

    if (row_size(r, 3) >= ET_LINALG_SVD)
        return SKIP;
    status = fit_of(r, &f);
    if (status == ET_OK)
        et_fit_free(&f);
    return row_is_size(r, 0, (size_t)status) ? PASS : FAIL;
}

/* Rows: approach method nx ny, data by class; wanted: flat, s and r of the bottom view, s and r of the top. */
verdict true_fit_parameters(const row *r)
{
    const et_doublenet n = {row_size(r, 2), row_size(r, 3)};
    size_t k = 1, nov = 0;
    et_vec3 *data = read_data(r, 4, n, &nov);
    et_fit f;
    bool ok;

    if (data == NULL)
        return FAIL;
    const et_status status = fit_parameters(&f, data, nov, n, (et_fit_approach)row_size(r, 0), (et_param_method)row_size(r, 1), NULL);
    free(data);
    if (status != ET_OK)
        return FAIL;
    ok = row_is_size(r, 0, f.flat);
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; i < n.nx; i++)
            ok = row_is(r, k++, f.s[w][i]) && ok;
        for (size_t j = 0; j < n.ny; j++)
            ok = row_is(r, k++, f.r[w][j]) && ok;
    }
    et_fit_free(&f);
    return ok ? PASS : FAIL;
}
