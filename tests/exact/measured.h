/* measured: a second way to measure: rationals by the definitions, roots and their sums by MPFR. */
#ifndef TESTS_EXACT_MEASURED_H
#define TESTS_EXACT_MEASURED_H
#include "etalon/base/real.h"
#include "etalon/base/rng.h"
#include "etalon/exact/exact.h"
#include "exact/exact_radical_parts.h"
#include "exact/live.h"
#include "exact/nearest.h"
#include "gen.h"
#include "golden.h"
#include <flint/fmpq.h>
#include <stdlib.h>

enum { SIDE = 4, DEGREE = 3, NODES = SIDE * SIDE, CLASSES = 2 * NODES, SAMPLES = 2 };

/* ---- a second way: rationals by the definitions, roots and their sums by MPFR ---- */

static inline void of_double(fmpq_t q, double x)
{
    int e;
    const double m = frexp(x, &e);

    fmpq_set_si(q, (slong)ldexp(m, 53), 1);
    if (e >= 53)
        fmpq_mul_2exp(q, q, (ulong)(e - 53));
    else
        fmpq_div_2exp(q, q, (ulong)(53 - e));
}

static inline void exactly(mpfr_t v, const fmpq_t q)
{
    mpfr_t d;

    mpfr_init2(d, SECOND_BITS);
    fmpz_get_mpfr(v, fmpq_numref(q), MPFR_RNDN);
    fmpz_get_mpfr(d, fmpq_denref(q), MPFR_RNDN);
    mpfr_div(v, v, d, MPFR_RNDN);
    mpfr_clear(d);
}

/* The double nearest to (sum of the square roots of q[0..n-1]) / divisor. */
static inline double sum_of_roots(const fmpq *q, size_t n, size_t divisor)
{
    mpfr_t sum, x;
    double result;

    mpfr_init2(sum, SECOND_BITS);
    mpfr_init2(x, SECOND_BITS);
    mpfr_set_zero(sum, 1);
    for (size_t k = 0; k < n; k++) {
        exactly(x, q + k);
        mpfr_sqrt(x, x, MPFR_RNDN);
        mpfr_add(sum, sum, x, MPFR_RNDN);
    }
    mpfr_div_ui(sum, sum, (unsigned long)divisor, MPFR_RNDN);
    result = nearest(sum);
    mpfr_clear(sum);
    mpfr_clear(x);
    return result;
}

static inline void square(fmpq_t q, const fmpq *A, const fmpq *B)
{
    fmpq_t d;

    fmpq_init(d);
    fmpq_zero(q);
    for (size_t k = 0; k < 3; k++) {
        fmpq_sub(d, A + k, B + k);
        fmpq_addmul(q, d, d);
    }
    fmpq_clear(d);
}

static inline void point_of(fmpq *P, et_vec3 p)
{
    of_double(P, p.x);
    of_double(P + 1, p.y);
    of_double(P + 2, p.z);
}

/* ---- et_exact_fit_measure ---- */

static inline bool same(const void *a, const void *b, size_t n)
{
    return memcmp(a, b, n) == 0;
}

/* Whether the precision is what was asked for (128 if nothing was) times 2^k. */
static inline bool doubled(size_t used, size_t asked)
{
    size_t bits = asked == 0 ? 128 : asked < 2 ? 2 : asked < EXACT_MOST_BITS ? asked : EXACT_MOST_BITS;

    while (bits < used)
        bits *= 2;
    return bits == used;
}
#endif
