/* exact_measure: how far the surfaces are from the data, correctly rounded. */
#include "etalon/base/size.h"
#include "exact/exact_radical_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Distances of all nodes, bottom then top: sqrt(num)/den in units of 2^e[view], and as doubles d.  Those of the classes are some of them. */
typedef struct {
    et_doublenet net;
    size_t nodes;
    fmpz *num, *den;
    slong e[2];
    double *d;
} nodes_apart;

static int finite(const double *t, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(t[i]))
            return 0;
    return 1;
}

static int can_measure(const et_fit *fit, size_t nov)
{
    const et_doublenet n = fit->data;

    if (!et_doublenet_valid(n) || nov != et_doublenet_nov(n))
        return 0;
    for (size_t w = 0; w < 2; w++)
        if (!et_surface_valid(&fit->shell.view[w]) || !finite(fit->s[w], n.nx) || !finite(fit->r[w], n.ny))
            return 0;
    return 1;
}

static void measure_view(nodes_apart *a, const et_fit *fit, size_t w, const exact_net *data)
{
    const et_doublenet n = a->net;
    fmpz *G = _fmpz_vec_init((slong)(EXACT_COMPONENTS * a->nodes));
    slong e;

    exact_grid(G, &e, &fit->shell.view[w], fit->s[w], n.nx, fit->r[w], n.ny);
    a->e[w] = e < data->e ? e : data->e;
    for (size_t k = 0; k < a->nodes; k++) {
        const size_t at = w * a->nodes + k, c = et_doublenet_class(n, w, k / n.ny, k % n.ny) - 1;
        exact_gap(a->num + at, a->den + at, data->H + EXACT_COMPONENTS * c, data->e, G + EXACT_COMPONENTS * k, e);
        a->d[at] = exact_root(a->num + at, a->den + at, a->e[w]);
    }
    _fmpz_vec_clear(G, (slong)(EXACT_COMPONENTS * a->nodes));
}

/* One unit for both views. */
static void common_unit(nodes_apart *a)
{
    const size_t finer = a->e[0] > a->e[1], n = a->nodes;
    fmpz *num = a->num + (finer ? 0 : n);

    _fmpz_vec_scalar_mul_2exp(num, num, (slong)n, 2 * (ulong)(a->e[!finer] - a->e[finer]));
    a->e[!finer] = a->e[finer];
}

/* Rounding is monotone: the greatest of the rounded is the greatest one rounded. */
static void greatest(et_fit_error *e, const nodes_apart *a)
{
    const et_doublenet n = a->net;

    for (size_t at = 0; at < 2 * a->nodes; at++) {
        const size_t i = at % a->nodes / n.ny, j = at % n.ny;
        e->greatest = fmax(e->greatest, a->d[at]);
        if ((i == 0 || i == n.nx - 1) && (j == 0 || j == n.ny - 1))
            e->corner = fmax(e->corner, a->d[at]);
    }
}

/* The nodes of the classes are brought together first: all of the bottom view and the top's interior. */
static void sums(et_fit_error *e, nodes_apart *a, size_t *bits)
{
    const et_doublenet n = a->net;
    size_t bn = *bits, bv = *bits, count = a->nodes;

    common_unit(a);
    e->non = exact_root_sum(a->num, a->den, 2 * a->nodes, a->e[0], 1, &bn);
    for (size_t c = a->nodes + 1; c <= et_doublenet_nov(n); c++) {
        const et_index x = et_doublenet_index(n, c);
        const size_t at = a->nodes + x.i * n.ny + x.j;
        fmpz_swap(a->num + count, a->num + at);
        fmpz_swap(a->den + count++, a->den + at);
    }
    e->nov = exact_root_sum(a->num, a->den, count, a->e[0], 1, &bv);
    *bits = bn > bv ? bn : bv;
}

static void residuals(double *residual, size_t nov, const nodes_apart *a)
{
    for (size_t c = 1; c <= nov; c++) {
        const et_index x = et_doublenet_index(a->net, c);
        residual[c - 1] = a->d[(x.k == 2 ? a->nodes : 0) + x.i * a->net.ny + x.j];
    }
}

et_status et_exact_fit_measure(et_fit_error *error, double *residual, size_t nov, const et_fit *fit, const et_vec3 *data, size_t *bits)
{
    const et_doublenet n = fit->data;
    size_t prec = exact_first_bits(bits);
    et_fit_error e = {0, 0, 0, 0};
    nodes_apart a;
    exact_net points;

    if (!can_measure(fit, nov))
        return ET_EINVAL;
    a = (nodes_apart){n, n.nx * n.ny, NULL, NULL, {0, 0}, et_size_array(2 * n.nx * n.ny, sizeof(double))};
    if (a.d == NULL)
        return ET_ENOMEM;
    a.num = _fmpz_vec_init((slong)(2 * a.nodes));
    a.den = _fmpz_vec_init((slong)(2 * a.nodes));
    exact_net_init(&points, data, NULL, nov, 1, 1);
    for (size_t w = 0; w < 2; w++)
        measure_view(&a, fit, w, &points);
    greatest(&e, &a);
    sums(&e, &a, &prec);
    if (residual != NULL)
        residuals(residual, nov, &a);
    *error = e;
    if (bits != NULL)
        *bits = prec;
    exact_net_clear(&points);
    _fmpz_vec_clear(a.num, (slong)(2 * a.nodes));
    _fmpz_vec_clear(a.den, (slong)(2 * a.nodes));
    free(a.d);
    return ET_OK;
}
