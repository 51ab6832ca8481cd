/* splines: the second way of the tests of exact curves and surfaces. */
#ifndef TESTS_EXACT_SPLINES_H
#define TESTS_EXACT_SPLINES_H
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/exact/exact.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include "exact/exact_parts.h"
#include "exact/live.h"
#include "exact/rational.h"
#include "exact/written.h"
#include "golden.h"
#include "spline/reference.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEGREE = 5, ORDER = 6, TALL = 140 };

/* ---- the second way ---- */

/* M[0..p]: the k-th derivatives of the functions of the span, all terms taken by their magnitudes (Eq. 2.9 with plus signs). */
static inline void magnitudes(fmpq *M, const double *u, size_t nu, size_t p, size_t span, double x, size_t k)
{
    fmpq_t zero, part;
    fmpq_init(zero);
    fmpq_init(part);
    for (size_t r = 0; r <= p; r++) {
        fmpq_zero(M + r);
    }
    if (k <= p) {
        exact_basis(M, 0, u + k, nu - 2 * k, p - k, span - k, fmin(fmax(x, u[p]), u[nu - p - 1]));
    }
    for (size_t q = p - k + 1; k <= p && q <= p; q++) {
        for (size_t r = q; r-- > 0;) {
            slope(part, zero, M + r, q, u[span + 1 + r - q], u[span + 1 + r]);
            fmpq_set(M + r, part);
            fmpq_add(M + r + 1, M + r + 1, part);
        }
    }
    fmpq_clear(zero);
    fmpq_clear(part);
}

/* (1-u)^-m - 1, u = 2^-53. */
static inline void gamma_of(fmpq_t q, size_t m)
{
    fmpq_t one;
    fmpq_init(one);
    exact_set(one, 1.0);
    exact_set(q, 1.0 - ET_UNIT);
    fmpq_pow_si(q, q, -(slong)m);
    fmpq_sub(q, q, one);
    fmpq_clear(one);
}

/* |fast f - want| <= ((1-u)^-m - 1) size, and a number that allows for underflow where sizes are not small. */
static inline bool within(double fast, const fmpq_t f, const fmpq_t want, size_t m, const fmpq_t size)
{
    fmpq_t d, bound, small;
    if (!isfinite(fast)) {
        return false;
    }
    fmpq_init(d);
    fmpq_init(bound);
    fmpq_init(small);
    exact_set(d, fast);
    fmpq_mul(d, d, f);
    fmpq_sub(d, d, want);
    fmpq_abs(d, d);
    gamma_of(bound, m);
    fmpq_mul(bound, bound, size);
    exact_set(small, 0x1p-700);
    fmpq_add(bound, bound, small);
    bool ok = fmpq_cmp(d, bound) <= 0;
    fmpq_clear(d);
    fmpq_clear(bound);
    fmpq_clear(small);
    return ok;
}

/* ---- curves ---- */

/* q = k! */
static inline void factorial(fmpq_t q, size_t k)
{
    fmpq_one(q);
    for (size_t i = 2; i <= k; i++) {
        fmpq_mul_ui(q, q, (ulong)i);
    }
}

/* The fast point f w = A within the stated bound: fast w is off by gamma(m+1) of the numerator's size, and by as many of w times the result. */
static inline bool point_within(double fast, const fmpq_t w, const fmpq_t A, size_t m, const fmpq_t size, bool rational)
{
    fmpq_t q, s;
    fmpq_init(q);
    fmpq_init(s);
    fmpq_set(s, size);
    if (rational && isfinite(fast)) {
        exact_set(q, fabs(fast));
        fmpq_addmul(s, q, w);
    }
    bool ok = within(fast, w, A, rational ? m + 1 : m, s);
    fmpq_clear(q);
    fmpq_clear(s);
    return ok;
}

static inline bool moderate(const et_vec3 *D, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        if (!(fabs(D[k].x) < 0x1p900 && fabs(D[k].y) < 0x1p900 && fabs(D[k].z) < 0x1p900)) {
            return false;
        }
    }
    return true;
}
#endif
