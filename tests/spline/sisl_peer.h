/* sisl_peer: what both comparisons with SISL share.  SISL takes knots and parameters that differ by less than a tolerance of its own for equal: knots
 * and parameters are multiples of 2^-12 here, which no tolerance joins. */
#ifndef TESTS_SPLINE_SISL_PEER_H
#define TESTS_SPLINE_SISL_PEER_H
#include "reference.h"
#define SISLNEEDPROTOTYPES
#include <sisl.h>

static inline double peer_coarse(double x)
{
    return floor(x * 0x1p12 + 0.5) * 0x1p-12;
}

/* Clamped on [0,1], no inner knot more than p times; false where rounding has joined more. */
static inline bool peer_knots(gen *g, double *u, size_t nu, size_t p)
{
    gen_knots(g, u, nu, p);
    for (size_t i = p + 1; i + p + 1 < nu; i++) {
        u[i] = fmin(fmax(peer_coarse(u[i]), 0x1p-12), 1.0 - 0x1p-12);
        if (i >= 2 * p + 1 && u[i] == u[i - p]) {
            return false;
        }
    }
    return true;
}

/* M[i]: the magnitudes of the terms of the k-th derivative of the basis, if each function of degree p - k in reach were 1.  SISL computes basis functions
 * to within roundings of 1, not of themselves (at the left end of [0,1] the second of two may be 2^-53, and the first 1 - 2^-53). */
static inline void peer_magnitudes(double M[REF_KNOTS], const double *u, size_t nu, size_t p, double x, size_t k)
{
    size_t span = ref_span(u, nu, p, x);
    for (size_t i = 0; i < REF_KNOTS; i++) {
        M[i] = k <= p && i + p - k >= span && i <= span ? 1.0 : 0.0;
    }
    for (size_t d = p - k + 1; k <= p && d <= p; d++) {
        for (size_t i = 0; i + d + 1 < nu; i++) {
            M[i] = (double)d * (ref_ratio(M[i], u[i + d] - u[i]) + ref_ratio(M[i + 1], u[i + d + 1] - u[i + 1]));
        }
    }
}

/* Theirs: 16 (p + d + 2) roundings, which is generous to every stable algorithm; ours and the sum of magnitudes: less than as many again. */
static inline double peer_slack(size_t p, size_t d)
{
    return 32.0 * (double)(p + d + 2) * ET_UNIT;
}
#endif
