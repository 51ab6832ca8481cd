#include "exact/exact_sums_parts.h"
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include <math.h>

enum { DIGITS = 53 };

static double coordinate(const et_vec3 *P, size_t a)
{
    return a == 0 ? P->x : a == 1 ? P->y : P->z;
}

slong exact_place(slong least, double x)
{
    int e;
    if (x == 0.0) {
        return least;
    }
    frexp(x, &e);
    return e - DIGITS < least ? e - DIGITS : least;
}

void exact_integer(fmpz_t n, double x, slong place)
{
    int e;
    double m = frexp(x, &e);
    fmpz_set_d(n, ldexp(m, DIGITS));
    if (x != 0.0 && e - DIGITS >= place) {
        fmpz_mul_2exp(n, n, (ulong)(e - DIGITS - place));
    } else if (x != 0.0) {
        fmpz_tdiv_q_2exp(n, n, (ulong)(place + DIGITS - e));
    }
}

void exact_net_init(exact_net *net, const et_vec3 *points, const double *weights, size_t rows, size_t columns, size_t step)
{
    slong ex = WORD_MAX, ew = WORD_MAX;
    net->n = rows * columns;
    net->H = _fmpz_vec_init((slong)(EXACT_COMPONENTS * net->n));
    for (size_t k = 0; k < net->n; k++) {
        size_t at = k / columns * step + k % columns;
        for (size_t a = 0; a < 3; a++) {
            ex = exact_place(ex, coordinate(points + at, a));
        }
        ew = weights ? exact_place(ew, weights[at]) : 0;
    }
    for (size_t k = 0; k < net->n; k++) {
        size_t at = k / columns * step + k % columns;
        fmpz *H = net->H + EXACT_COMPONENTS * k;
        exact_integer(H + 3, weights ? weights[at] : 1.0, ew);
        for (size_t a = 0; a < 3; a++) {
            exact_integer(H + a, coordinate(points + at, a), ex);
            fmpz_mul(H + a, H + a, H + 3);
        }
    }
    net->e = ex == WORD_MAX ? 0 : ex;     /* all points in the origin */
    net->w = ew;
}

void exact_net_clear(exact_net *net)
{
    _fmpz_vec_clear(net->H, (slong)(EXACT_COMPONENTS * net->n));
}

void exact_row_init(exact_row *row, const fmpq *values, size_t n)
{
    row->n = n;
    row->value = _fmpz_vec_init((slong)n);
    fmpz_init(row->denominator);
    _fmpq_vec_get_fmpz_vec_fmpz(row->value, row->denominator, values, (slong)n);
}

void exact_row_clear(exact_row *row)
{
    _fmpz_vec_clear(row->value, (slong)row->n);
    fmpz_clear(row->denominator);
}

size_t exact_span(const double *u, size_t nu, size_t p, double x, et_side side)
{
    size_t k = p, last = nu - p - 2;
    if (side != ET_SIDE_LEFT) {
        return et_knots_span(u, nu, p, x);
    }
    while (k < last && (u[k + 1] < x || u[k] == u[k + 1])) {
        k++;
    }
    while (u[k] == u[k + 1]) {            /* x beyond the domain, whose last knot is repeated */
        k--;
    }
    return k;
}

void exact_line_init(exact_line *line, const double *u, size_t n, size_t p, double x, size_t d)
{
    exact_line_init_at(line, u, n, p, et_knots_span(u, n + p + 1, p, x), x, d);
}

void exact_line_init_at(exact_line *line, const double *u, size_t n, size_t p, size_t span, double x, size_t d)
{
    size_t size = (d + 1) * (p + 1);
    fmpq *D = _fmpq_vec_init((slong)size);
    exact_basis(D, d, u, n + p + 1, p, span, x);
    line->d = d;
    line->first = span - p;
    line->row = flint_malloc((d + 1) * sizeof *line->row);
    for (size_t k = 0; k <= d; k++) {
        exact_row_init(line->row + k, D + k * (p + 1), p + 1);
    }
    _fmpq_vec_clear(D, (slong)size);
}

void exact_line_clear(exact_line *line)
{
    for (size_t k = 0; k <= line->d; k++) {
        exact_row_clear(line->row + k);
    }
    flint_free(line->row);
}

void exact_contract(fmpz *T, size_t n, const exact_row *row, const fmpz *H, size_t stride)
{
    slong m = (slong)(EXACT_COMPONENTS * n);
    _fmpz_vec_scalar_mul_fmpz(T, H, m, row->value);
    for (size_t r = 1; r < row->n; r++) {
        _fmpz_vec_scalar_addmul_fmpz(T, H + EXACT_COMPONENTS * r * stride, m, row->value + r);
    }
}

void exact_scale(fmpq_t C, slong e)
{
    if (e >= 0) {
        fmpq_mul_2exp(C, C, (flint_bitcnt_t)e);
    } else {
        fmpq_div_2exp(C, C, (flint_bitcnt_t)-e);
    }
}

void exact_project(fmpq *C, const fmpz *S, slong e)
{
    for (size_t a = 0; a < 3; a++) {
        fmpq_set_fmpz_frac(C + a, S + a, S + 3);
        exact_scale(C + a, e);
    }
}

int exact_fits(size_t *n, size_t a, size_t b)
{
    size_t m;
    if (et_size_mul(&m, a, b) != ET_OK || m > WORD_MAX / (EXACT_COMPONENTS * sizeof(fmpq))) {
        return 0;
    }
    *n = m;
    return 1;
}

et_vec3 exact_round_point(const fmpq *C)
{
    return (et_vec3){exact_round(C), exact_round(C + 1), exact_round(C + 2)};
}
