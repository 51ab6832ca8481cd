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
/*@ requires size:  2 <= n && 1 <= stride && (n - 1) * stride < SIZE_MAX;
    requires valid: \valid_read(D + (0 .. (n - 1) * stride));
    assigns  \nothing;
*/
static double greatest_step(size_t n, const et_vec3 *D, size_t stride, double half)
{
    double greatest = 0;

    /*@ loop invariant place: 1 <= i <= n;
        loop assigns i, greatest;
        loop variant n - i;
    */
    for (size_t i = 1; i < n; i++) {
        //@ ghost fact_product(i, n - 1, stride);
        //@ ghost fact_product(i - 1, n - 1, stride);
        const et_vec3 d = difference(D[(i - 1) * stride], D[i * stride], half);
        greatest = fmax(greatest, fmax(fabs(d.x), fmax(fabs(d.y), fabs(d.z))));
    }
    return greatest;
}

/* |d|^e for d whose coordinates, times f * g (powers of two), are at most 1 in size. */
/*@ assigns \nothing; */
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
    /*@ loop invariant place: 1 <= i <= n;
        loop assigns i, sum, work[1 .. n - 1];
        loop variant n - i;
    */
    for (size_t i = 1; i < n; i++) {
        //@ ghost fact_product(i, n - 1, stride);
        //@ ghost fact_product(i - 1, n - 1, stride);
        sum += step(difference(D[(i - 1) * stride], D[i * stride], half), f, g, method);
        work[i] = sum;
    }
    /* Rounded addition and division are monotone: t is non-decreasing, and sum / sum is 1.  Error of t_i: at most (2n + 6) u t_i (chord). */
    /*@ loop invariant place: i <= n;
        loop assigns i, t[0 .. n - 1];
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++)
        t[i] = work[i] / sum;
    return 0;
}

/* mean[i] = average over the `lines` rows of T (lines x n), each sum by et_real_sum; column: `lines` doubles. */
/*@ requires size:  n * lines <= SIZE_MAX && 1 <= n;
    requires valid: \valid(mean + (0 .. n - 1)) && \valid(column + (0 .. lines - 1)) && \valid_read(T + (0 .. n * lines - 1));
    assigns  mean[0 .. n - 1], column[0 .. lines - 1];
*/
static void average(double *mean, size_t n, const double *T, size_t lines, double *column)
{
    /*@ loop invariant place: i <= n;
        loop assigns i, mean[0 .. n - 1], column[0 .. lines - 1];
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++) {
        /*@ loop invariant place: k <= lines;
            loop assigns k, column[0 .. lines - 1];
            loop variant lines - k;
        */
        for (size_t k = 0; k < lines; k++) {
            //@ ghost fact_product(k + 1, lines, n);
            column[k] = T[k * n + i];
        }
        mean[i] = et_real_sum(column, lines) / (double)lines;
    }
}

/* Parameters of `count` lines of n points into the rows of T; neighbouring lines begin `next` points apart, a line's points stand `stride` apart.
 * Returns the number of lines of no length. */
/*@ requires size:   1 <= count && 2 <= n && 1 <= stride && (count - 1) * next + (n - 1) * stride < count * n <= SIZE_MAX;
    requires method: et_param_known(method);
    requires table:  \valid(T + (0 .. count * n - 1));
    requires work:   \valid(work + (0 .. n - 1));
    requires points: \valid_read(D + (0 .. count * n - 1));
    requires finite: et_points_finite((et_vec3 *)D, count * n);
    requires apart:  \separated(T + (0 .. count * n - 1), work + (0 .. n - 1), D + (0 .. count * n - 1));
    assigns  T[0 .. count * n - 1], work[0 .. n - 1];
    ensures  lost:   \result <= count;
*/
static size_t rows(double *T, size_t count, size_t n, const et_vec3 *D, size_t next, size_t stride, et_param_method method, double *work)
{
    size_t lost = 0;

    //@ ghost fact_product(0, n - 1, stride);
    /*@ loop invariant place: k <= count;
        loop invariant lost:  lost <= k;
        loop invariant given: et_points_finite((et_vec3 *)D, count * n);
        loop assigns k, lost, T[0 .. count * n - 1], work[0 .. n - 1];
        loop variant count - k;
    */
    for (size_t k = 0; k < count; k++) {
        //@ ghost fact_product(0, k, n);
        //@ ghost fact_product(k + 1, count, n);
        //@ ghost fact_product(k, count - 1, next);
        //@ assert last: k * next + (n - 1) * stride < count * n && 0 <= k * n && k * n + n <= count * n;
        //@ ghost fact_line(count * n, k * next, stride, n, (et_vec3 *)D);
        //@ assert apart: \separated(T + k * n + (0 .. n - 1), D + (0 .. count * n - 1));
        lost += et_param_row(T + k * n, n, D + k * next, stride, method, work) != 0;
    }
    return lost;
}

et_status et_param_grid(double *s, size_t nx, double *r, size_t ny, size_t *flat, const et_vec3 *D, et_param_method method)
{
    const size_t longest = nx > ny ? nx : ny;
    size_t cells, lost;
    double *T, *work;

    if (nx < 2 || ny < 2 || et_param_name(method) == NULL)
        return ET_EINVAL;
    if (et_size_mul(&cells, nx, ny) != ET_OK)
        return ET_ENOMEM;
    //@ ghost fact_product(2, nx, ny);
    //@ ghost fact_product(2, ny, nx);
    //@ assert sides: nx + ny <= nx * ny <= SIZE_MAX && nx * ny == cells;
    T = et_size_array(cells, sizeof *T);
    work = et_size_array(longest, sizeof *work);
    if (T == NULL || work == NULL) {
        free(T);
        free(work);
        return ET_ENOMEM;
    }
    //@ ghost fact_array(T, cells);
    //@ ghost fact_array(work, longest);
    //@ assert distinct: \separated(T + (0 .. nx * ny - 1), work + (0 .. longest - 1));
    /*@ assert fresh:    \separated(T + (0 .. nx * ny - 1), s + (0 .. nx - 1), flat, D + (0 .. nx * ny - 1)) &&
                         \separated(T + (0 .. nx * ny - 1), r + (0 .. ny - 1)) &&
                         \separated(work + (0 .. longest - 1), s + (0 .. nx - 1), flat, D + (0 .. nx * ny - 1)) &&
                         \separated(work + (0 .. longest - 1), r + (0 .. ny - 1)); */
    lost = rows(T, ny, nx, D, 1, ny, method, work);
    average(s, nx, T, ny, work);
    lost += rows(T, nx, ny, D, ny, 1, method, work);
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
