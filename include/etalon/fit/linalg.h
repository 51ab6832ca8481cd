/* linalg: every call of LAPACKE and BLAS in one place.  Matrices are row-major, A is m x n with m >= 1, n >= 1. */
#ifndef ETALON_FIT_LINALG_H
#define ETALON_FIT_LINALG_H
#include "etalon/base/status.h"
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef enum { ET_LINALG_QR = 0, ET_LINALG_CHOLESKY, ET_LINALG_SVD } et_linalg_method;
const char *et_linalg_name(et_linalg_method method);          /* "qr", "cholesky", "svd" */

/* The least-squares solution X (n x k) of A X = B (B is m x k): QR with a check of R's condition, normal equations with Cholesky, or
 * SVD (least norm when rank deficient: never ET_ERANK).  A and B are not changed.  *rank: the numerical rank found.
 * ET_ERANK (QR, Cholesky): A has not full column rank to working precision; *rank tells (n - 1 where only "deficient" is known). */
et_status et_linalg_lsq(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k, et_linalg_method method);

/* A = Q R: R (n x n upper triangular, m >= n) and C = first n rows of Q'B. */
et_status et_linalg_qr(double *R, double *C, const double *A, size_t m, size_t n, const double *B, size_t k);

/* The same for a banded A: row i has the entries a[i*w .. i*w+w-1] in columns start[i] .. start[i]+w-1. */
et_status et_linalg_band_lsq(double *X, size_t *rank, const double *a, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k,
                             et_linalg_method method);

#ifdef __cplusplus
}
#endif
#endif
