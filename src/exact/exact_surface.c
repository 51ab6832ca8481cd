#include "exact/exact_radical_parts.h"
#include <math.h>

/* A grid is computed by so many rows at a time: whole numbers of them all are kept. */
enum { GRID_ROWS = 64 };

/* The control points that two directions' basis functions meet. */
static void window(exact_net *net, const et_surface *s, const exact_line *u, const exact_line *v)
{
    size_t at = u->first * s->nv + v->first;
    exact_net_init(net, s->points + at, s->weights ? s->weights + at : NULL, s->p + 1, s->q + 1, s->nv);
}

void exact_surface(fmpq *S, const et_surface *s, double u, double v)
{
    exact_line a, b;
    exact_net net;
    size_t n = s->q + 1;
    exact_line_init(&a, s->u, s->nu, s->p, u, 0);
    exact_line_init(&b, s->v, s->nv, s->q, v, 0);
    window(&net, s, &a, &b);
    fmpz *T = _fmpz_vec_init((slong)(EXACT_COMPONENTS * (n + 1)));
    exact_contract(T, n, a.row, net.H, n);
    exact_contract(T + EXACT_COMPONENTS * n, 1, b.row, T, 1);
    exact_project(S, T + EXACT_COMPONENTS * n, net.e);
    _fmpz_vec_clear(T, (slong)(EXACT_COMPONENTS * (n + 1)));
    exact_net_clear(&net);
    exact_line_clear(&a);
    exact_line_clear(&b);
}

et_status et_exact_surface_point(et_vec3 *S, const et_surface *s, double u, double v)
{
    if (!et_surface_valid(s) || !isfinite(u) || !isfinite(v)) {
        return ET_EINVAL;
    }
    fmpq *C = _fmpq_vec_init(3);
    exact_surface(C, s, u, v);
    *S = exact_round_point(C);
    _fmpq_vec_clear(C, 3);
    return ET_OK;
}

/* Where the derivative k times by u and l times by v stands. */
static size_t place(size_t k, size_t l)
{
    return (k + l) * (k + l + 1) / 2 + l;
}

/* A[4 place(k,l) + a]: the derivatives of w x, w y, w z and w, up to a common power of two. */
static void homogeneous(fmpq *A, const exact_net *net, const exact_line *u, const exact_line *v)
{
    size_t n = v->row->n;
    fmpz_t denominator;
    fmpz *T = _fmpz_vec_init((slong)(EXACT_COMPONENTS * (n + 1))), *S = T + EXACT_COMPONENTS * n;
    fmpz_init(denominator);
    for (size_t k = 0; k <= u->d; k++) {
        exact_contract(T, n, u->row + k, net->H, n);
        for (size_t l = 0; k + l <= v->d; l++) {
            exact_contract(S, 1, v->row + l, T, 1);
            fmpz_mul(denominator, u->row[k].denominator, v->row[l].denominator);
            for (size_t a = 0; a < EXACT_COMPONENTS; a++) {
                fmpq_set_fmpz_frac(A + EXACT_COMPONENTS * place(k, l) + a, S + a, denominator);
            }
        }
    }
    fmpz_clear(denominator);
    _fmpz_vec_clear(T, (slong)(EXACT_COMPONENTS * (n + 1)));
}

/* Eq. 4.20 of one derivative, those of lower order being quotients already: w S^(k,l) is A^(k,l) less the sum of C(k,i) C(l,j) w^(i,j) S^(k-i,l-j),
 * (i,j) not (0,0). */
static void quotient(fmpq *A, size_t k, size_t l)
{
    fmpq *S = A + EXACT_COMPONENTS * place(k, l);
    fmpz_t c, b;
    fmpq_t f;
    fmpz_init(c);
    fmpz_init(b);
    fmpq_init(f);
    for (size_t i = 0; i <= k; i++) {
        for (size_t j = i == 0; j <= l; j++) {
            const fmpq *w = A + EXACT_COMPONENTS * place(i, j) + 3, *R = A + EXACT_COMPONENTS * place(k - i, l - j);
            fmpz_bin_uiui(b, (ulong)k, (ulong)i);
            fmpz_bin_uiui(c, (ulong)l, (ulong)j);
            fmpz_mul(c, c, b);
            fmpq_mul_fmpz(f, w, c);
            for (size_t a = 0; a < 3 && !fmpq_is_zero(f); a++) {
                fmpq_submul(S + a, f, R + a);
            }
        }
    }
    for (size_t a = 0; a < 3; a++) {
        fmpq_div(S + a, S + a, A + 3);
    }
    fmpz_clear(c);
    fmpz_clear(b);
    fmpq_clear(f);
}

/* A as above, of `size` entries, becomes S and its derivatives, a coordinate's place unused. */
static void derivatives(fmpq *A, size_t d, const et_surface *s, double u, double v, et_side side_u, et_side side_v)
{
    exact_line a, b;
    exact_net net;
    exact_line_init_at(&a, s->u, s->nu, s->p, exact_span(s->u, s->nu + s->p + 1, s->p, u, side_u), u, d);
    exact_line_init_at(&b, s->v, s->nv, s->q, exact_span(s->v, s->nv + s->q + 1, s->q, v, side_v), v, d);
    window(&net, s, &a, &b);
    homogeneous(A, &net, &a, &b);
    for (size_t m = 0; m <= d; m++) {
        for (size_t l = 0; l <= m; l++) {
            quotient(A, m - l, l);
        }
    }
    for (size_t k = 0; k <= place(0, d); k++) {
        for (size_t c = 0; c < 3; c++) {
            exact_scale(A + EXACT_COMPONENTS * k + c, net.e);
        }
    }
    exact_net_clear(&net);
    exact_line_clear(&a);
    exact_line_clear(&b);
}

et_status et_exact_surface_ders(et_vec3 *D, size_t d, const et_surface *s, double u, double v)
{
    return et_exact_surface_partials(D, d, s, u, v, ET_SIDE_RIGHT, ET_SIDE_RIGHT);
}

et_status et_exact_surface_partials(et_vec3 *D, size_t d, const et_surface *s, double u, double v, et_side side_u, et_side side_v)
{
    size_t n, greater = s->p > s->q ? s->p : s->q;
    if (!et_surface_valid(s) || !isfinite(u) || !isfinite(v)) {
        return ET_EINVAL;
    }
    if (d >= SIZE_MAX - 1 || !exact_fits(&n, d + 1, d + 2) || !exact_fits(&n, d + 1, greater + 1)) {
        return ET_ENOMEM;
    }
    n = place(0, d) + 1;
    fmpq *A = _fmpq_vec_init((slong)(EXACT_COMPONENTS * n));
    derivatives(A, d, s, u, v, side_u, side_v);
    for (size_t k = 0; k < n; k++) {
        D[k] = exact_round_point(A + EXACT_COMPONENTS * k);
    }
    _fmpq_vec_clear(A, (slong)(EXACT_COMPONENTS * n));
    return ET_OK;
}

/* C = A x B. */
static void cross(fmpq *C, const fmpq *A, const fmpq *B)
{
    for (size_t a = 0; a < 3; a++) {
        fmpq_mul(C + a, A + (a + 1) % 3, B + (a + 2) % 3);
        fmpq_submul(C + a, A + (a + 2) % 3, B + (a + 1) % 3);
    }
}

/* c / sqrt(square): its square's root, with c's sign. */
static double cosine(const fmpq_t c, const fmpq_t square)
{
    fmpq_t q;
    fmpq_init(q);
    fmpq_mul(q, c, c);
    fmpq_div(q, q, square);
    double x = exact_round_sqrt(q);
    fmpq_clear(q);
    return fmpq_sgn(c) < 0 ? -x : x;
}

et_status et_exact_surface_normal(et_vec3 *n, const et_surface *s, double u, double v)
{
    if (!et_surface_valid(s) || !isfinite(u) || !isfinite(v)) {
        return ET_EINVAL;
    }
    fmpq *A = _fmpq_vec_init(3 * EXACT_COMPONENTS), *C = _fmpq_vec_init(EXACT_COMPONENTS), *square = C + 3;
    derivatives(A, 1, s, u, v, ET_SIDE_RIGHT, ET_SIDE_RIGHT);
    cross(C, A + EXACT_COMPONENTS, A + (size_t)2 * EXACT_COMPONENTS);
    for (size_t a = 0; a < 3; a++) {
        fmpq_addmul(square, C + a, C + a);
    }
    int flat = fmpq_is_zero(square);
    if (!flat) {
        *n = (et_vec3){cosine(C, square), cosine(C + 1, square), cosine(C + 2, square)};
    }
    _fmpq_vec_clear(A, 3 * EXACT_COMPONENTS);
    _fmpq_vec_clear(C, EXACT_COMPONENTS);
    return flat ? ET_ERANK : ET_OK;
}

static int finite(const double *x, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        if (!isfinite(x[k])) {
            return 0;
        }
    }
    return 1;
}

et_status et_exact_surface_grid(et_vec3 *S, const et_surface *s, const double *a, size_t na, const double *b, size_t nb)
{
    slong e;
    size_t n;
    if (!et_surface_valid(s) || !finite(a, na) || !finite(b, nb)) {
        return ET_EINVAL;
    }
    if (!exact_fits(&n, s->nu, s->nv) || !exact_fits(&n, nb, GRID_ROWS)) {
        return ET_ENOMEM;
    }
    fmpq *C = _fmpq_vec_init(3);
    for (size_t from = 0; from < na && nb > 0; from += GRID_ROWS) {
        size_t rows = na - from < GRID_ROWS ? na - from : GRID_ROWS;
        fmpz *G = _fmpz_vec_init((slong)(EXACT_COMPONENTS * rows * nb));
        exact_grid(G, &e, s, a + from, rows, b, nb);
        for (size_t k = 0; k < rows * nb; k++) {
            exact_project(C, G + EXACT_COMPONENTS * k, e);
            S[from * nb + k] = exact_round_point(C);
        }
        _fmpz_vec_clear(G, (slong)(EXACT_COMPONENTS * rows * nb));
    }
    _fmpq_vec_clear(C, 3);
    return ET_OK;
}
