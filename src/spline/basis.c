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

/*@ assigns \nothing; */
static double clamp(double x, double lo, double hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

/* left[j] = x - u[span+1-j], right[j] = u[span+j] - x, j = 1..p; returns the index of the only function that is not zero where x meets a knot
 * of multiplicity p or more (there A2.2 gives r * (1 / r), which may not be 1), else p + 1. */
/*@ requires span:  p <= span && span + p <= SIZE_MAX;
    requires left:  \valid(left + (0 .. p)) && \valid(right + (0 .. p));
    requires knots: \valid_read(u + (0 .. span + p));
    assigns  left[1 .. p], right[1 .. p];
    ensures  range: \result <= p + 1;
*/
static size_t distances(double *left, double *right, const double *u, size_t p, size_t span, double x)
{
    /*@ loop invariant place: 1 <= j <= p + 1;
        loop assigns j, left[1 .. p], right[1 .. p];
        loop variant p - j;
    */
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
    /*@ loop invariant place: 1 <= j <= p + 1;
        loop assigns j, N[0 .. p];
        loop variant p - j;
    */
    for (size_t j = 1; j <= p; j++) {
        double saved = 0.0;
        /*@ loop invariant place: r <= j;
            loop assigns r, saved, N[0 .. p];
            loop variant j - r;
        */
        for (size_t r = 0; r < j; r++) {
            double temp = N[r] / (right[r + 1] + left[j - r]);
            N[r] = saved + right[r + 1] * temp;
            saved = left[j - r] * temp;
        }
        N[j] = saved;
    }
    /*@ loop invariant place: r <= p + 1;
        loop assigns r, N[0 .. p];
        loop variant p - r;
    */
    for (size_t r = 0; only <= p && r <= p; r++) {
        N[r] = r == only ? 1.0 : 0.0;
    }
}

/* ndu[r*(p+1) + j], r <= j: the functions of degree j; below the diagonal the knot differences ndu[j*(p+1) + r], r < j. */
/*@ requires room: (p + 1)*(p + 1) <= SIZE_MAX && \valid(ndu + (0 .. (p + 1)*(p + 1) - 1));
    requires rows: \valid_read(left + (0 .. p)) && \valid_read(right + (0 .. p));
    assigns  ndu[0 .. (p + 1)*(p + 1) - 1];
*/
static void triangle(double *ndu, const double *left, const double *right, size_t p)
{
    size_t w = p + 1;
    //@ ghost fact_product(1, w, w);
    ndu[0] = 1.0;
    /*@ loop invariant place: 1 <= j <= p + 1;
        loop assigns j, ndu[0 .. w*w - 1];
        loop variant p - j;
    */
    for (size_t j = 1; j <= p; j++) {
        double saved = 0.0;
        //@ ghost fact_product(j + 1, w, w);
        /*@ loop invariant place: r <= j;
            loop assigns r, saved, ndu[0 .. w*w - 1];
            loop variant j - r;
        */
        for (size_t r = 0; r < j; r++) {
            //@ ghost fact_product(r + 1, w, w);
            ndu[j * w + r] = right[r + 1] + left[j - r];
            double temp = ndu[r * w + j - 1] / ndu[j * w + r];
            ndu[r * w + j] = saved + right[r + 1] * temp;
            saved = left[j - r] * temp;
        }
        ndu[j * w + j] = saved;
    }
}

/* The k-th derivative of function r without its factor p!/(p-k)!: next[0..k] from prev[0..k-1] (Eqs. 2.9, 2.10; terms outside the triangle are 0). */
/*@ requires place: 1 <= k <= p && r <= p;
    requires room:  (p + 1)*(p + 1) <= SIZE_MAX && \valid_read(ndu + (0 .. (p + 1)*(p + 1) - 1));
    requires rows:  \valid(next + (0 .. k)) && \valid_read(prev + (0 .. k - 1));
    assigns  next[0 .. k];
*/
static double derivative(double *next, const double *prev, const double *ndu, size_t p, size_t r, size_t k)
{
    size_t w = p + 1, pk = p - k;
    double d = 0.0;
    //@ ghost fact_product(pk + 2, w, w);
    //@ ghost fact_product(1, w, p + 1);
    /*@ loop invariant place: j <= k + 1;
        loop assigns j, d, next[0 .. k];
        loop variant k - j;
    */
    for (size_t j = 0; j <= k; j++) {
        /* The function of degree p-k and local index r-k+j, times a_{k,j}. */
        next[j] = 0.0;
        if (r + j < k || r + j - k > pk) {
            continue;
        }
        size_t i = r + j - k;
        //@ ghost fact_product(i + 1, w, w);
        double a = (j < k ? prev[j] : 0.0) - (j > 0 ? prev[j - 1] : 0.0);
        next[j] = a / ndu[(pk + 1) * w + i];
        d += next[j] * ndu[i * w + pk];
    }
    return d;
}

/* Column r of D: the derivatives of function r up to order top, without their factors. */
/*@ requires place: r <= p && top <= p && only <= p + 1;
    requires room:  (p + 1)*(p + 1) <= SIZE_MAX && \valid_read(ndu + (0 .. (p + 1)*(p + 1) - 1)) && \valid(a + (0 .. 2*(p + 1) - 1));
    requires D:     (top + 1)*(p + 1) <= SIZE_MAX && \valid(D + (0 .. (top + 1)*(p + 1) - 1));
    assigns  D[0 .. (top + 1)*(p + 1) - 1], a[0 .. 2*(p + 1) - 1];
*/
static void column(double *D, size_t top, const double *ndu, double *a, size_t p, size_t r, size_t only)
{
    size_t w = p + 1;
    double *prev = a, *next = a + w;
    //@ ghost fact_product(r + 1, w, w);
    //@ ghost fact_product(0, r, w);
    //@ ghost fact_product(1, top + 1, w);
    //@ assert first: r < (top + 1)*w && r*w + p < w*w;
    prev[0] = 1.0;
    D[r] = only > p ? ndu[r * w + p] : r == only ? 1.0 : 0.0;
    /*@ loop invariant place: 1 <= k <= top + 1;
        loop invariant rows:  (prev == a && next == a + w) || (prev == a + w && next == a);
        loop assigns k, prev, next, D[0 .. (top + 1)*w - 1], a[0 .. 2*w - 1];
        loop variant top - k;
    */
    for (size_t k = 1; k <= top; k++) {
        //@ ghost fact_product(k + 1, top + 1, w);
        //@ ghost fact_product(0, k, w);
        //@ assert at: 0 <= k*w <= k*w + r < (top + 1)*w;
        D[k * w + r] = derivative(next, prev, ndu, p, r, k);
        double *swap = prev;
        prev = next;
        next = swap;
    }
}

/* Rows 1 .. d get their factors p!/(p-k)!, which are 0 beyond the degree. */
/*@ requires D: p < SIZE_MAX && (d + 1)*(p + 1) <= SIZE_MAX && \valid(D + (0 .. (d + 1)*(p + 1) - 1));
    assigns  D[0 .. (d + 1)*(p + 1) - 1];
*/
static void factors(double *D, size_t d, size_t p)
{
    size_t w = p + 1;
    double factor = 1.0;
    //@ ghost fact_product(1, w, d + 1);
    /*@ loop invariant place: 1 <= k <= d + 1;
        loop assigns k, factor, D[0 .. (d + 1)*w - 1];
        loop variant d - k;
    */
    for (size_t k = 1; k <= d; k++) {
        //@ ghost fact_product(k + 1, d + 1, w);
        //@ ghost fact_product(0, k, w);
        factor *= k <= p ? (double)(p - k + 1) : 0.0;
        /*@ loop invariant place: r <= p + 1;
            loop assigns r, D[0 .. (d + 1)*w - 1];
            loop variant p - r;
        */
        for (size_t r = 0; r <= p; r++) {
            //@ assert at: 0 <= k*w <= k*w + r < (d + 1)*w;
            D[k * w + r] = k <= p ? D[k * w + r] * factor : 0.0;
        }
    }
}

void et_basis_ders(double *D, size_t d, const double *u, size_t nu, size_t p, size_t span, double x, double *work, size_t nwork)
{
    size_t w = p + 1, top = d < p ? d : p;
    //@ ghost fact_product(w, p + 5, w);
    double *ndu = work, *a = ndu + w * w, *left = a + 2 * w, *right = left + w;
    (void)nwork;
    x = clamp(x, u[p], u[nu - p - 1]);
    size_t only = distances(left, right, u, p, span, x);
    triangle(ndu, left, right, p);
    //@ ghost fact_product(top + 1, d + 1, w);
    /*@ loop invariant place: r <= p + 1;
        loop assigns r, D[0 .. (top + 1)*w - 1], a[0 .. 2*w - 1];
        loop variant p - r;
    */
    for (size_t r = 0; r <= p; r++) {
        column(D, top, ndu, a, p, r, only);
    }
    factors(D, d, p);
}
