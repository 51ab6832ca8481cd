/* real: the one place where elementary functions and long sums are computed.
 *
 * Every sum over many terms in Etalon is et_real_sum, so that two ways to the same number give the same bits.
 * exp, log, pow pass through here so that one implementation decides their bits.
 */
#ifndef ETALON_BASE_REAL_H
#define ETALON_BASE_REAL_H
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

/* 2^-52 and 2^-53 (the unit roundoff u). */
#define ET_EPS 0x1p-52
#define ET_UNIT 0x1p-53

/* x[0] + ... + x[n-1] in a fixed order of additions (pairwise over blocks; the order depends on n alone), error at most
 * (blocksize + log2 n) u sum|x_i| to first order; 0 for n == 0. */
double et_real_sum(const double *x, size_t n);

double et_real_exp(double x);
double et_real_log(double x);
double et_real_pow(double x, double y);
double et_real_sin(double x);
double et_real_cos(double x);

#ifdef __cplusplus
}
#endif
#endif
