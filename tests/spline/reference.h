/* reference: the B-spline basis by its definition (Eq. 2.5), all functions at once, for comparison with what etalon computes another way.
 *
 * Each level of the recursion costs a value at most two roundings for each difference's quotient and one each for product and sum: five, so
 * 5p roundings in all.  A derivative by Eq. 2.7 costs four a level beside. */
#ifndef TESTS_SPLINE_REFERENCE_H
#define TESTS_SPLINE_REFERENCE_H
#include "etalon/base/real.h"
#include "gen.h"
#include <math.h>
#include <stddef.h>
#include <string.h>

enum { REF_KNOTS = 64, REF_DEGREE = 9 };

static inline bool ref_same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* By a walk from the left. */
static inline size_t ref_span(const double *u, size_t nu, size_t p, double x)
{
    size_t k = p;
    for (size_t i = p; i + p + 1 < nu; i++) {
        if (u[i] < u[nu - p - 1] && u[i] <= x) {
            k = i;
        }
    }
    while (!(u[k] < u[k + 1])) {              /* x before the domain, whose first knot is repeated */
        k++;
    }
    return k;
}

static inline double ref_ratio(double a, double b)
{
    return b == 0.0 ? 0.0 : a / b;
}

/* N[i] = N_{i,p}(x), i = 0 .. nu-p-2. */
static inline void ref_basis(double N[REF_KNOTS], const double *u, size_t nu, size_t p, double x)
{
    size_t span = ref_span(u, nu, p, x);
    for (size_t i = 0; i + 1 < nu; i++) {
        N[i] = i == span ? 1.0 : 0.0;
    }
    for (size_t d = 1; d <= p; d++) {
        for (size_t i = 0; i + d + 1 < nu; i++) {
            double a = N[i] == 0.0 ? 0.0 : ref_ratio(x - u[i], u[i + d] - u[i]) * N[i];
            double b = N[i + 1] == 0.0 ? 0.0 : ref_ratio(u[i + d + 1] - x, u[i + d + 1] - u[i + 1]) * N[i + 1];
            N[i] = a + b;
        }
    }
}

/* D[i] = k-th derivative of N_{i,p} at x; M[i] the same with the terms' magnitudes added. */
static inline void ref_derivative(double D[REF_KNOTS], double M[REF_KNOTS], const double *u, size_t nu, size_t p, double x, size_t k)
{
    for (size_t i = 0; i < REF_KNOTS; i++) {
        D[i] = M[i] = 0.0;
    }
    if (k > p) {
        return;
    }
    /* The functions of degree p-k, in the span that degree p sees. */
    ref_basis(D, u + k, nu - 2 * k, p - k, x);
    memmove(D + k, D, (REF_KNOTS - k) * sizeof *D);
    for (size_t i = 0; i < k; i++) {
        D[i] = 0.0;
    }
    for (size_t i = nu - p - 1; i < REF_KNOTS; i++) {
        D[i] = 0.0;
    }
    memcpy(M, D, REF_KNOTS * sizeof *M);
    for (size_t d = p - k + 1; d <= p; d++) {
        for (size_t i = 0; i + d + 1 < nu; i++) {
            double a = u[i + d] - u[i], b = u[i + d + 1] - u[i + 1];
            D[i] = (double)d * (ref_ratio(D[i], a) - ref_ratio(D[i + 1], b));
            M[i] = (double)d * (ref_ratio(M[i], a) + ref_ratio(M[i + 1], b));
        }
    }
}

/* Clamped knots on [0,1] (gen_knots), the same moved and scaled, or any non-decreasing ones, with knots repeated beyond p+1 times. */
static inline void ref_draw_knots(gen *g, double *u, size_t nu, size_t p)
{
    uint64_t kind = gen_upto(g, 3);
    gen_knots(g, u, nu, p);
    if (kind == 2) {
        int e = (int)gen_upto(g, 200) - 100;
        double shift = ldexp((double)gen_upto(g, 16) - 8.0, e);
        gen_label(g, "moved and scaled");
        for (size_t i = 0; i < nu; i++) {
            u[i] = ldexp(u[i], e) + shift;
        }
    }
    if (kind == 3) {
        double x = gen_real(g, 0.0, 8.0) - 4.0;
        gen_label(g, "not clamped");
        for (size_t i = 0; i < nu; i++) {
            u[i] = x;
            x += gen_chance(g, 3) ? 0.0 : gen_real(g, 0.0, 1.0);
        }
    }
}
#endif
