/* fit_measure: how far the surfaces are from the data. */
#include "fit/fit_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* d[at] = distance of each node of a view. */
static et_status node_distances(double *d, const et_fit *fit, size_t w, const et_vec3 *data, et_vec3 *S)
{
    const et_doublenet n = fit->data;
    const et_status status = et_surface_grid(S, &fit->shell.view[w], fit->s[w], n.nx, fit->r[w], n.ny);

    if (status != ET_OK)
        return status;
    for (size_t i = 0; i < n.nx; i++)
        for (size_t j = 0; j < n.ny; j++)
            d[i * n.ny + j] = et_vec3_distance(data[et_doublenet_class(n, w, i, j) - 1], S[i * n.ny + j]);
    return ET_OK;
}

/* d: distances of all nodes, bottom then top; c: the same by class. */
static void summarise(et_fit_error *error, const double *d, const double *c, size_t nov, et_doublenet n)
{
    const size_t nodes = n.nx * n.ny;
    et_fit_error e = {et_real_sum(c, nov), et_real_sum(d, 2 * nodes), 0, 0};

    for (size_t at = 0; at < 2 * nodes; at++) {
        e.greatest = fmax(e.greatest, d[at]);
        if (fit_is_corner(n, at % nodes / n.ny, at % n.ny))
            e.corner = fmax(e.corner, d[at]);
    }
    *error = e;
}

et_status et_fit_measure(et_fit_error *error, double *residual, size_t nov, const et_fit *fit, const et_vec3 *data)
{
    const et_doublenet n = fit->data;
    const size_t nodes = n.nx * n.ny;
    et_vec3 *S;
    double *d, *c;
    et_status status = ET_ENOMEM;

    if (!et_doublenet_valid(n) || nov != et_doublenet_nov(n))
        return ET_EINVAL;
    S = et_size_array(nodes, sizeof *S);
    d = et_size_array(2 * nodes, sizeof *d);
    c = et_size_array(nov, sizeof *c);
    if (S != NULL && d != NULL && c != NULL) {
        status = node_distances(d, fit, ET_BOTTOM, data, S);
        if (status == ET_OK)
            status = node_distances(d + nodes, fit, ET_TOP, data, S);
    }
    if (status == ET_OK) {
        for (size_t k = 1; k <= nov; k++) {
            const et_index x = et_doublenet_index(n, k);
            c[k - 1] = d[(x.k == 2 ? nodes : 0) + x.i * n.ny + x.j];
        }
        summarise(error, d, c, nov, n);
        if (residual != NULL)
            memcpy(residual, c, nov * sizeof *c);
    }
    free(S);
    free(d);
    free(c);
    return status;
}
