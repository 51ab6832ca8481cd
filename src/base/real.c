#include "etalon/base/real.h"
#include <float.h>

/* Double precision must be double precision: no x87 registers.  Where the method is 1 (s390x) only floats are evaluated as doubles. */
typedef char et_real_assert_evaluation[FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1 ? 1 : -1];
typedef char et_real_assert_binary64[FLT_RADIX == 2 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024 ? 1 : -1];

enum { LANES = 8, BLOCK = 128 };

/* At most BLOCK terms.  A full block: BLOCK / LANES - 1 rounded additions in a lane and three between lanes; else one fewer in a lane and
 * one for the rest: a term passes at most 18 roundings. */
/*@ requires terms: \valid_read(x + (0 .. n - 1)) && n <= BLOCK;
    assigns  \nothing;
*/
static double sum_block(const double *x, size_t n)
{
    double lane[LANES] = {0.0};
    double rest = 0.0;
    size_t i = 0;
    /*@ loop invariant place: i <= n;
        loop assigns i, lane[0 .. LANES - 1];
        loop variant n - i;
    */
    for (; i + LANES <= n; i += LANES) {
        /*@ loop invariant place: k <= LANES;
            loop assigns k, lane[0 .. LANES - 1];
            loop variant LANES - k;
        */
        for (size_t k = 0; k < LANES; k++) {
            lane[k] += x[i + k];
        }
    }
    /*@ loop invariant place: i <= n;
        loop assigns i, rest;
        loop variant n - i;
    */
    for (; i < n; i++) {
        rest += x[i];
    }
    /*@ loop invariant half: half <= LANES / 2;
        loop assigns half, lane[0 .. LANES / 2 - 1];
        loop variant half;
    */
    for (size_t half = LANES / 2; half > 0; half /= 2) {
        /*@ loop invariant place: k <= half;
            loop assigns k, lane[0 .. LANES / 2 - 1];
            loop variant half - k;
        */
        for (size_t k = 0; k < half; k++) {
            lane[k] += lane[k + half];
        }
    }
    return lane[0] + rest;
}

double et_real_sum(const double *x, size_t n)
{
    if (n <= BLOCK) {
        return sum_block(x, n);
    }
    size_t left = (n / BLOCK + 1) / 2 * BLOCK;     /* whole blocks, so that only the last is short */
    return et_real_sum(x, left) + et_real_sum(x + left, n - left);
}
