/* exact_param: parameters of gridded data, correctly rounded. */
#include "etalon/base/size.h"
#include "exact/exact_radical_parts.h"
#include <stdlib.h>
#include <string.h>

/* Means of the parameters of so many lines; *flat: how many have no length.  *bits as in exact_lines_means. */
static et_status line_means(double *t, size_t *flat, size_t lines, size_t step, const et_vec3 *D, size_t n, size_t stride, et_param_method method,
                            size_t *bits)
{
    exact_lines L;
    et_status status;

    if (method == ET_PARAM_UNIFORM) {
        exact_uniform(t, n);
        *flat = *bits = 0;
        return ET_OK;
    }
    status = exact_lines_init(&L, lines, step, D, n, stride, method);
    if (status != ET_OK)
        return status;
    status = exact_lines_means(t, &L, bits);
    *flat = L.flat;
    exact_lines_clear(&L);
    return status;
}

et_status et_exact_param_row(double *t, size_t n, int *flat, const et_vec3 *D, size_t stride, et_param_method method, size_t *bits)
{
    size_t prec = exact_first_bits(bits), lost;
    et_status status;

    if (n < 2 || stride < 1 || et_param_name(method) == NULL)
        return ET_EINVAL;
    status = line_means(t, &lost, 1, 0, D, n, stride, method, &prec);
    if (status != ET_OK)
        return status;
    *flat = lost != 0;
    if (bits != NULL)
        *bits = prec;
    return ET_OK;
}

et_status et_exact_param_grid(double *s, size_t nx, double *r, size_t ny, size_t *flat, const et_vec3 *D, et_param_method method, size_t *bits)
{
    size_t ps = exact_first_bits(bits), pr = ps, fs = 0, fr = 0, cells;
    double *a, *b;
    et_status status = ET_ENOMEM;

    if (nx < 2 || ny < 2 || et_param_name(method) == NULL)
        return ET_EINVAL;
    if (et_size_mul(&cells, nx, ny) != ET_OK)
        return ET_ENOMEM;
    a = et_size_array(nx, sizeof *a);
    b = et_size_array(ny, sizeof *b);
    if (a != NULL && b != NULL)
        status = line_means(a, &fs, ny, 1, D, nx, ny, method, &ps);
    if (status == ET_OK)
        status = line_means(b, &fr, nx, ny, D, ny, 1, method, &pr);
    if (status == ET_OK) {
        memcpy(s, a, nx * sizeof *s);
        memcpy(r, b, ny * sizeof *r);
        *flat = fs + fr;
        if (bits != NULL)
            *bits = ps > pr ? ps : pr;
    }
    free(a);
    free(b);
    return status;
}

void et_exact_param_standardise(double *a, double *b, size_t n)
{
    fmpq_t x, y;

    fmpq_init(x);
    fmpq_init(y);
    for (size_t i = 0; i < n; i++) {
        exact_set(x, a[i]);
        exact_set(y, b[i]);
        fmpq_add(x, x, y);
        fmpq_div_2exp(x, x, 1);
        a[i] = b[i] = exact_round(x);
    }
    fmpq_clear(x);
    fmpq_clear(y);
}
