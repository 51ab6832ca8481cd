/* exact_grid: the points of a surface over a grid of parameters, in whole numbers. */
#include "exact/exact_radical_parts.h"

/* A line of the grid: T, 4*nv numbers of work, becomes the control points of a curve in v. */
static void grid_line(fmpz *G, fmpz *T, const et_surface *s, const fmpz *H, double a, const exact_line *v, size_t nb)
{
    exact_line u;

    exact_line_init(&u, s->u, s->nu, s->p, a, 0);
    exact_contract(T, s->nv, u.row, H + EXACT_COMPONENTS * u.first * s->nv, s->nv);
    for (size_t j = 0; j < nb; j++)
        exact_contract(G + EXACT_COMPONENTS * j, 1, v[j].row, T + EXACT_COMPONENTS * v[j].first, 1);
    exact_line_clear(&u);
}

void exact_grid(fmpz *G, slong *e, const et_surface *s, const double *a, size_t na, const double *b, size_t nb)
{
    exact_line *v = flint_calloc(nb, sizeof *v);
    fmpz *T = _fmpz_vec_init((slong)(EXACT_COMPONENTS * s->nv));
    exact_net net;

    for (size_t j = 0; j < nb; j++)
        exact_line_init(v + j, s->v, s->nv, s->q, b[j], 0);
    exact_net_init(&net, s->points, s->weights, s->nu, s->nv, s->nv);
    for (size_t i = 0; i < na; i++)
        grid_line(G + EXACT_COMPONENTS * i * nb, T, s, net.H, a[i], v, nb);
    *e = net.e;
    exact_net_clear(&net);
    for (size_t j = 0; j < nb; j++)
        exact_line_clear(v + j);
    _fmpz_vec_clear(T, (slong)(EXACT_COMPONENTS * s->nv));
    flint_free(v);
}
