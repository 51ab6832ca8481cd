#include "etalon/spline/basis.h"
#include "etalon/base/size.h"
#include <stdint.h>

size_t et_basis_work(size_t p, size_t d)
{
    size_t n = 0;
    if (p > SIZE_MAX / 4 || et_size_mul(&n, p + 1, d == 0 ? 2 : p + 5) != ET_OK) {
        return SIZE_MAX;
    }
    return n;
}

static double clamp(double x, double lo, double hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

/* left[j] = x - u[span+1-j], right[j] = u[span+j] - x, j = 1..p; returns the index of the only function that is not zero where x meets a knot
 * of multiplicity p or more (there A2.2 gives r * (1 / r), which may not be 1), else p + 1. */
static size_t distances(double *left, double *right, const double *u, size_t p, size_t span, double x)
{
    for (size_t j = 1; j <= p; j++) {
        left[j] = x - u[span + 1 - j];
        right[j] = u[span + j] - x;
    }
    if (p == 0 || left[p] == 0.0) {
        return 0;
    }
    return right[p] == 0.0 ? p : p + 1;
}

void et_basis_eval(double *N, const double *u, size_t nu, size_t p, size_t span, double x, double *work, size_t nwork)
{
    double *left = work, *right = work + p + 1;
    (void)nwork;
    x = clamp(x, u[p], u[nu - p - 1]);
    size_t only = distances(left, right, u, p, span, x);
    N[0] = 1.0;
    for (size_t j = 1; j <= p; j++) {
        double saved = 0.0;
        for (size_t r = 0; r < j; r++) {
            double temp = N[r] / (right[r + 1] + left[j - r]);
            N[r] = saved + right[r + 1] * temp;
            saved = left[j - r] * temp;
        }
        N[j] = saved;
    }
    for (size_t r = 0; only <= p && r <= p; r++) {
        N[r] = r == only ? 1.0 : 0.0;
    }
}

/* ndu[r*(p+1) + j], r <= j: the functions of degree j; below the diagonal the knot differences ndu[j*(p+1) + r], r < j. */
static void triangle(double *ndu, const double *left, const double *right, size_t p)
{
    size_t w = p + 1;
    ndu[0] = 1.0;
    for (size_t j = 1; j <= p; j++) {
        double saved = 0.0;
        for (size_t r = 0; r < j; r++) {
            ndu[j * w + r] = right[r + 1] + left[j - r];
            double temp = ndu[r * w + j - 1] / ndu[j * w + r];
            ndu[r * w + j] = saved + right[r + 1] * temp;
            saved = left[j - r] * temp;
        }
        ndu[j * w + j] = saved;
    }
}

/* The k-th derivative of function r without its factor p!/(p-k)!: next[0..k] from prev[0..k-1] (Eqs. 2.9, 2.10; terms outside the triangle are 0). */
static double derivative(double *next, const double *prev, const double *ndu, size_t p, size_t r, size_t k)
{
    size_t w = p + 1, pk = p - k;
    double d = 0.0;
    for (size_t j = 0; j <= k; j++) {
        /* The function of degree p-k and local index r-k+j, times a_{k,j}. */
        next[j] = 0.0;
        if (r + j < k || r + j - k > pk) {
            continue;
        }
        size_t i = r + j - k;
        double a = (j < k ? prev[j] : 0.0) - (j > 0 ? prev[j - 1] : 0.0);
        next[j] = a / ndu[(pk + 1) * w + i];
        d += next[j] * ndu[i * w + pk];
    }
    return d;
}

void et_basis_ders(double *D, size_t d, const double *u, size_t nu, size_t p, size_t span, double x, double *work, size_t nwork)
{
    size_t w = p + 1, top = d < p ? d : p;
    double *ndu = work, *a = ndu + w * w, *left = a + 2 * w, *right = left + w;
    (void)nwork;
    x = clamp(x, u[p], u[nu - p - 1]);
    size_t only = distances(left, right, u, p, span, x);
    triangle(ndu, left, right, p);
    for (size_t r = 0; r <= p; r++) {
        double *prev = a, *next = a + w;
        prev[0] = 1.0;
        D[r] = only > p ? ndu[r * w + p] : r == only ? 1.0 : 0.0;
        for (size_t k = 1; k <= top; k++) {
            D[k * w + r] = derivative(next, prev, ndu, p, r, k);
            double *swap = prev;
            prev = next;
            next = swap;
        }
    }
    double factor = 1.0;
    for (size_t k = 1; k <= d; k++) {
        factor *= k <= p ? (double)(p - k + 1) : 0.0;
        for (size_t r = 0; r <= p; r++) {
            D[k * w + r] = k <= p ? D[k * w + r] * factor : 0.0;
        }
    }
}
