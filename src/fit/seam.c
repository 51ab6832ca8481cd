#include "etalon/fit/seam.h"
#include "etalon/base/size.h"
#include <stdlib.h>

/* Two sorted lists of knots of one domain become one without repetitions; returns its length. */
static size_t merge(double *t, const double *a, size_t na, const double *b, size_t nb)
{
    size_t n = 0, i = 0, j = 0;

    while (i < na || j < nb) {
        const double x = j == nb || (i < na && a[i] <= b[j]) ? a[i++] : b[j++];
        if (n == 0 || x > t[n - 1])
            t[n++] = x;
    }
    return n;
}

/* Every knot and `samples` equidistant parameters between neighbours, all knots' domains being [0,1]. */
static et_status sample_parameters(double **t, size_t *n, const double *a, const double *b, size_t nu, size_t samples)
{
    double *knots = et_size_array(nu, 2 * sizeof *knots), *out = NULL;
    size_t nk = 0, total = 0;
    et_status status = knots == NULL || samples == (size_t)-1 ? ET_ENOMEM : ET_OK;

    if (status == ET_OK) {
        nk = merge(knots, a, nu, b, nu);
        status = et_size_mul(&total, nk, samples + 1);
    }
    if (status == ET_OK)
        out = et_size_array(total, sizeof *out);
    if (out != NULL) {
        size_t at = 0;
        for (size_t k = 0; k + 1 < nk; k++)
            for (size_t i = 0; i <= samples; i++)
                out[at++] = knots[k] + (knots[k + 1] - knots[k]) * ((double)i / (double)(samples + 1));
        out[at++] = knots[nk - 1];
        *t = out;
        *n = at;
    }
    free(knots);
    return out == NULL ? ET_ENOMEM : ET_OK;
}

static void visit(et_seam *gap, const et_shell *shell, double u, double v, double *work, size_t nwork)
{
    const et_vec3 a = et_surface_point(&shell->view[ET_BOTTOM], u, v, work, nwork);
    const et_vec3 b = et_surface_point(&shell->view[ET_TOP], u, v, work, nwork);
    const double d = et_vec3_distance(a, b);

    if (d > gap->distance)
        *gap = (et_seam){d, u, v};
}

static int unit_domain(const et_surface *s)
{
    return s->u[s->p] == 0 && s->u[s->nu] == 1 && s->v[s->q] == 0 && s->v[s->nv] == 1;
}

et_status et_seam_gap(et_seam *gap, const et_shell *shell, size_t samples)
{
    const et_surface *a = &shell->view[ET_BOTTOM], *b = &shell->view[ET_TOP];
    double *s = NULL, *r = NULL, *work = NULL;
    size_t ns = 0, nr = 0, nwork;
    et_seam found = {0, 0, 0};
    et_status status;

    if (!et_shell_valid(shell) || !unit_domain(a) || !unit_domain(b))
        return ET_EINVAL;
    status = sample_parameters(&s, &ns, a->u + a->p, b->u + b->p, a->nu - a->p + 1, samples);
    if (status == ET_OK)
        status = sample_parameters(&r, &nr, a->v + a->q, b->v + b->q, a->nv - a->q + 1, samples);
    nwork = et_surface_work(a);
    if (status == ET_OK)
        work = et_size_array(nwork, sizeof *work);
    if (work != NULL) {
        for (size_t j = 0; j < nr; j++) {
            visit(&found, shell, 0, r[j], work, nwork);
            visit(&found, shell, 1, r[j], work, nwork);
        }
        for (size_t i = 0; i < ns; i++) {
            visit(&found, shell, s[i], 0, work, nwork);
            visit(&found, shell, s[i], 1, work, nwork);
        }
        *gap = found;
    } else {
        status = ET_ENOMEM;
    }
    free(s);
    free(r);
    free(work);
    return status;
}
