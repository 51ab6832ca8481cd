/* linalg: every call of LAPACKE in one place.  Matrices are row-major, A is m x n with m >= 1, n >= 1; entries are finite. */
#ifndef ETALON_FIT_LINALG_H
#define ETALON_FIT_LINALG_H
#include "etalon/base/status.h"
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef enum { ET_LINALG_QR = 0, ET_LINALG_CHOLESKY, ET_LINALG_SVD } et_linalg_method;

/*@ predicate et_linalg_known(integer method) = 0 <= method <= 2;
    predicate et_reals(double *x, integer n) = \valid_read(x + (0 .. n - 1)) && (\forall integer i; 0 <= i < n ==> \is_finite(x[i]));
*/

/* "qr", "cholesky", "svd"; null past the last. */
/*@ assigns \result \from method;
    ensures known:   et_linalg_known(method) ==> valid_read_string(\result);
    ensures named:   et_linalg_known(method) ==> \result != \null;
    ensures unknown: !et_linalg_known(method) ==> \result == \null;
*/
const char *et_linalg_name(et_linalg_method method);

/* The least-squares solution X (n x k) of A X = B (B is m x k): QR with a check of R's condition, normal equations with Cholesky, or SVD (least
 * norm when rank deficient: never ET_ERANK).  A and B are not changed.  *rank: the numerical rank found (X and *rank are written together).
 * QR (own code: bits depend on no BLAS) and SVD are backward stable; Cholesky's error grows with the square of A's condition number.
 * ET_ERANK (QR, Cholesky): the reciprocal condition number of R (of A'A) is at most max(m,n) eps, or m < n; then X is unchanged and *rank tells how
 * many diagonal elements of a column-pivoted R exceed max(m,n) eps times the first, at most n - 1.
 * ET_EINVAL: m, n or k is 0, method unknown.  ET_ENOMEM: memory, or sizes past LAPACK's 32 bits.  ET_ENOCONV: SVD.
 * ET_EINTERNAL: entries not finite. */
/*@ requires valid:     \valid(X + (0 .. n*k - 1)) && \valid(rank);
    requires finite:    et_reals(A, m*n) && et_reals(B, m*k);
    requires separated: \separated(X + (0 .. n*k - 1), rank, A + (0 .. m*n - 1), B + (0 .. m*k - 1));
    assigns X[0 .. n*k - 1], *rank;
    ensures invalid:    m < 1 || n < 1 || k < 1 || !et_linalg_known(method) <==> \result == ET_EINVAL;
    ensures full:       \result == ET_OK && method != ET_LINALG_SVD ==> *rank == n;
    ensures most:       \result == ET_OK ==> *rank <= n && *rank <= m;
    ensures deficient:  \result == ET_ERANK ==> *rank < n && *rank <= m && method != ET_LINALG_SVD;
    ensures wide:       \result == ET_OK && method == ET_LINALG_QR ==> n <= m;
    ensures unchanged:  \result != ET_OK ==> \forall integer i; 0 <= i < n*k ==> X[i] == \old(X[i]);
*/
et_status et_linalg_lsq(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k, et_linalg_method method);

/* A = Q R: R (n x n, upper triangular, zeros below) and C = first n rows of Q'B (n x k; k = 0 is allowed).  Rank is not judged: R may be singular.
 * Own code too.
 * ET_EINVAL: n < 1 or m < n.  ET_ENOMEM, ET_EINTERNAL as above. */
/*@ requires valid:     \valid(R + (0 .. n*n - 1)) && \valid(C + (0 .. n*k - 1));
    requires finite:    et_reals(A, m*n) && et_reals(B, m*k);
    requires separated: \separated(R + (0 .. n*n - 1), C + (0 .. n*k - 1), A + (0 .. m*n - 1), B + (0 .. m*k - 1));
    assigns R[0 .. n*n - 1], C[0 .. n*k - 1];
    ensures invalid:    n < 1 || m < n <==> \result == ET_EINVAL;
    ensures triangular: \result == ET_OK ==> \forall integer i, j; 0 <= j < i < n ==> R[i*n + j] == 0.0;
*/
et_status et_linalg_qr(double *R, double *C, const double *A, size_t m, size_t n, const double *B, size_t k);

/* et_linalg_lsq for a banded A: row i has the entries a[i*w .. i*w+w-1] in columns start[i] .. start[i]+w-1, start non-decreasing, n >= w.
 * Work is m w k multiplications and m w^2 for the factor.  QR: each group of rows of equal start is eliminated into R by w reflectors (Lawson and
 * Hanson, Solving Least Squares Problems, chapter 27), whose product is formed explicitly; own code, so that bits depend on no BLAS.
 * Cholesky: the banded normal matrix.  SVD: dense, m n doubles.
 * Errors as et_linalg_lsq; also ET_EINVAL: w < 1, n < w, start decreasing or past n - w. */
/*@ requires valid:     \valid(X + (0 .. n*k - 1)) && \valid(rank) && \valid_read(start + (0 .. m - 1));
    requires finite:    et_reals(a, m*w) && et_reals(B, m*k);
    requires separated: \separated(X + (0 .. n*k - 1), rank, a + (0 .. m*w - 1), start + (0 .. m - 1), B + (0 .. m*k - 1));
    assigns X[0 .. n*k - 1], *rank;
    ensures invalid:    m < 1 || w < 1 || n < w || k < 1 || !et_linalg_known(method) ==> \result == ET_EINVAL;
    ensures full:       \result == ET_OK && method != ET_LINALG_SVD ==> *rank == n;
    ensures most:       \result == ET_OK ==> *rank <= n && *rank <= m;
    ensures deficient:  \result == ET_ERANK ==> *rank < n && *rank <= m && method != ET_LINALG_SVD;
    ensures unchanged:  \result != ET_OK ==> \forall integer i; 0 <= i < n*k ==> X[i] == \old(X[i]);
*/
et_status et_linalg_band_lsq(double *X, size_t *rank, const double *a, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k,
                             et_linalg_method method);

#ifdef __cplusplus
}
#endif
#endif
