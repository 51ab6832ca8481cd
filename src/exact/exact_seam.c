/* exact_seam: how far two surfaces that should meet stand apart, compared exactly. */
#include "etalon/base/size.h"
#include "exact/exact_radical_parts.h"
#include <stdlib.h>

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

/* The very doubles at which et_seam_gap samples: its expression, operation by operation, since a room's private parts are its own. */
static et_status sample_parameters(double **t, size_t *n, const double *a, const double *b, size_t nu, size_t samples)
{
    double *knots = et_size_array(nu, 2 * sizeof *knots), *out = NULL;
    size_t nk = 0, total = 0, at = 0;

    if (knots != NULL && samples < SIZE_MAX) {
        nk = merge(knots, a, nu, b, nu);
        out = et_size_mul(&total, nk, samples + 1) == ET_OK ? et_size_array(total, sizeof *out) : NULL;
    }
    if (out != NULL) {
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

/* The greatest gap so far: sqrt(num)/den, and where. */
typedef struct {
    fmpz_t num, den;
    double u, v;
} best;

/* The homogeneous points of both views over the same parameters; the coordinates' units are 2^a and 2^b wherever on the surfaces. */
typedef struct {
    fmpz *bottom, *top;
    slong a, b;
} borders;

/* Whether sqrt(num)/den is greater than the greatest: by squares, all of them whole numbers. */
static int exceeds(const fmpz_t num, const fmpz_t den, const best *g)
{
    fmpz_t x, y;
    int greater;

    fmpz_init(x);
    fmpz_init(y);
    fmpz_mul(x, g->den, g->den);
    fmpz_mul(x, x, num);
    fmpz_mul(y, den, den);
    fmpz_mul(y, y, g->num);
    greater = fmpz_cmp(x, y) > 0;
    fmpz_clear(x);
    fmpz_clear(y);
    return greater;
}

static void visit(best *g, const borders *s, size_t at, double u, double v)
{
    fmpz_t num, den;

    fmpz_init(num);
    fmpz_init(den);
    exact_gap(num, den, s->bottom + EXACT_COMPONENTS * at, s->a, s->top + EXACT_COMPONENTS * at, s->b);
    if (exceeds(num, den, g)) {
        fmpz_swap(g->num, num);
        fmpz_swap(g->den, den);
        g->u = u;
        g->v = v;
    }
    fmpz_clear(num);
    fmpz_clear(den);
}

static void borders_init(borders *s, const et_shell *shell, const double *a, size_t na, const double *b, size_t nb)
{
    s->bottom = _fmpz_vec_init((slong)(EXACT_COMPONENTS * na * nb));
    s->top = _fmpz_vec_init((slong)(EXACT_COMPONENTS * na * nb));
    exact_grid(s->bottom, &s->a, &shell->view[ET_BOTTOM], a, na, b, nb);
    exact_grid(s->top, &s->b, &shell->view[ET_TOP], a, na, b, nb);
}

static void borders_clear(borders *s, size_t n)
{
    _fmpz_vec_clear(s->bottom, (slong)(EXACT_COMPONENTS * n));
    _fmpz_vec_clear(s->top, (slong)(EXACT_COMPONENTS * n));
}

static void search(et_seam *gap, const et_shell *shell, const double *s, size_t ns, const double *r, size_t nr)
{
    static const double ends[2] = {0, 1};
    best g = {.u = 0, .v = 0};
    borders b;

    fmpz_init(g.num);
    fmpz_init_set_ui(g.den, 1);
    borders_init(&b, shell, ends, 2, r, nr);
    for (size_t j = 0; j < nr; j++)
        for (size_t k = 0; k < 2; k++)
            visit(&g, &b, k * nr + j, ends[k], r[j]);
    borders_clear(&b, 2 * nr);
    borders_init(&b, shell, s, ns, ends, 2);
    for (size_t i = 0; i < ns; i++)
        for (size_t k = 0; k < 2; k++)
            visit(&g, &b, 2 * i + k, s[i], ends[k]);
    borders_clear(&b, 2 * ns);
    *gap = (et_seam){exact_root(g.num, g.den, b.a < b.b ? b.a : b.b), g.u, g.v};
    fmpz_clear(g.num);
    fmpz_clear(g.den);
}

static int unit_domain(const et_surface *s)
{
    return s->u[s->p] == 0 && s->u[s->nu] == 1 && s->v[s->q] == 0 && s->v[s->nv] == 1;
}

et_status et_exact_seam_gap(et_seam *gap, const et_shell *shell, size_t samples)
{
    const et_surface *a = &shell->view[ET_BOTTOM], *b = &shell->view[ET_TOP];
    double *s = NULL, *r = NULL;
    size_t ns = 0, nr = 0;
    et_status status;

    if (!et_shell_valid(shell) || !unit_domain(a) || !unit_domain(b))
        return ET_EINVAL;
    status = sample_parameters(&s, &ns, a->u + a->p, b->u + b->p, a->nu - a->p + 1, samples);
    if (status == ET_OK)
        status = sample_parameters(&r, &nr, a->v + a->q, b->v + b->q, a->nv - a->q + 1, samples);
    if (status == ET_OK)
        search(gap, shell, s, ns, r, nr);
    free(s);
    free(r);
    return status;
}
