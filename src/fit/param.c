#include "etalon/fit/param.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdlib.h>

static const char *const names[] = {"uniform", "chord", "centripetal", "exponential"};

const char *et_param_name(et_param_method method)
{
    return (unsigned)method < sizeof names / sizeof *names ? names[method] : NULL;
}

/*@ requires valid: 2 <= n && \valid(t + (0 .. n - 1));
    assigns  t[0 .. n - 1];
*/
static void uniform(double *t, size_t n)
{
    /*@ loop invariant place: i <= n;
        loop assigns i, t[0 .. n - 1];
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++)
        t[i] = (double)i / (double)(n - 1);
}

/* half = 0.5 keeps a difference of two huge coordinates finite. */
/*@ assigns \nothing; */
static et_vec3 difference(et_vec3 a, et_vec3 b, double half)
{
    return (et_vec3){half * b.x - half * a.x, half * b.y - half * a.y, half * b.z - half * a.z};
}

/* The greatest |coordinate of a difference| of neighbours; infinite on overflow. */
static double greatest_step(size_t n, const et_vec3 *D, size_t stride, double half)
{
    double greatest = 0;

    for (size_t i = 1; i < n; i++) {
        const et_vec3 d = difference(D[(i - 1) * stride], D[i * stride], half);
        greatest = fmax(greatest, fmax(fabs(d.x), fmax(fabs(d.y), fabs(d.z))));
    }
    return greatest;
}

/* |d|^e for d whose coordinates, times f * g (powers of two), are at most 1 in size. */
static double step(et_vec3 d, double f, double g, et_param_method method)
{
    const double x = d.x * f * g, y = d.y * f * g, z = d.z * f * g;
    const double length = sqrt(x * x + y * y + z * z); /* within 2.5u relative, and 2^-537 where squares underflow */

    if (method == ET_PARAM_CENTRIPETAL)
        return sqrt(length);
    if (method == ET_PARAM_EXPONENTIAL && length > 0)
        return et_real_pow(length, 0x1.999999999999ap-1);
    return length;
}

int et_param_row(double *t, size_t n, const et_vec3 *D, size_t stride, et_param_method method, double *work)
{
    double half = 1, greatest, sum = 0, f, g;
    int e;

    if (method == ET_PARAM_UNIFORM) {
        uniform(t, n);
        return 0;
    }
    greatest = greatest_step(n, D, stride, half);
    if (!(greatest < HUGE_VAL)) {
        half = 0.5;
        greatest = greatest_step(n, D, stride, half);
    }
    if (!(greatest > 0)) {
        uniform(t, n);
        return 1;
    }
    (void)frexp(greatest, &e);
    /* Two factors, since 2^-e alone may overflow. */
    f = ldexp(1, -(e / 2));
    g = ldexp(1, -(e - e / 2));
    work[0] = 0;
    for (size_t i = 1; i < n; i++) {
        sum += step(difference(D[(i - 1) * stride], D[i * stride], half), f, g, method);
        work[i] = sum;
    }
    /* Rounded addition and division are monotone: t is non-decreasing, and sum / sum is 1.  Error of t_i: at most (2n + 6) u t_i (chord). */
    for (size_t i = 0; i < n; i++)
        t[i] = work[i] / sum;
    return 0;
}

/* mean[i] = average over the `lines` rows of T (lines x n), each sum by et_real_sum; column: `lines` doubles. */
static void average(double *mean, size_t n, const double *T, size_t lines, double *column)
{
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < lines; k++)
            column[k] = T[k * n + i];
        mean[i] = et_real_sum(column, lines) / (double)lines;
    }
}

et_status et_param_grid(double *s, size_t nx, double *r, size_t ny, size_t *flat, const et_vec3 *D, et_param_method method)
{
    const size_t longest = nx > ny ? nx : ny;
    size_t cells, lost = 0;
    double *T, *work;

    if (nx < 2 || ny < 2 || et_param_name(method) == NULL)
        return ET_EINVAL;
    if (et_size_mul(&cells, nx, ny) != ET_OK)
        return ET_ENOMEM;
    T = et_size_array(cells, sizeof *T);
    work = et_size_array(longest, sizeof *work);
    if (T == NULL || work == NULL) {
        free(T);
        free(work);
        return ET_ENOMEM;
    }
    for (size_t j = 0; j < ny; j++)
        lost += et_param_row(T + j * nx, nx, D + j, ny, method, work) != 0;
    average(s, nx, T, ny, work);
    for (size_t i = 0; i < nx; i++)
        lost += et_param_row(T + i * ny, ny, D + i * ny, 1, method, work) != 0;
    average(r, ny, T, nx, work);
    *flat = lost;
    free(T);
    free(work);
    return ET_OK;
}

void et_param_standardise(double *a, double *b, size_t n)
{
    /*@ loop invariant place:  i <= n;
        loop invariant shared: \forall integer k; 0 <= k < i ==> a[k] == b[k];
        loop assigns i, a[0 .. n - 1], b[0 .. n - 1];
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++)
        a[i] = b[i] = (a[i] + b[i]) / 2;
}
