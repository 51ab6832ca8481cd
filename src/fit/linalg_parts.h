/* linalg_parts: what the files of linalg share: the band's factorisation in our own arithmetic, and what is left to LAPACK. */
#ifndef FIT_LINALG_PARTS_H
#define FIT_LINALG_PARTS_H
#include "etalon/fit/linalg.h"
#include <stddef.h>

enum { LINALG_STRIP = 64 }; /* columns treated together: their w accumulators stay in the first cache */

/* A factorised banded matrix, m rows of w entries in n columns. */
typedef struct {
    double *R;              /* R[i*w + c] = R(i, i+c) */
    double *top, *q;        /* top[s*w*w + ...] for the block that starts at column s; q[i*w + c] */
    double *v, *tau, *dots; /* of one block of t rows: reflector c's bottom part at v[c*t + ...] */
} linalg_band;

/* ---- the band ---- */

/* Room for a matrix of these sizes, all zero; to be freed.  On failure nothing is held. */
et_status linalg_band_new(linalg_band *f, size_t m, size_t n, size_t w);
/* Free what f holds. */
void linalg_band_free(linalg_band *f);
/* f, new, becomes the QR factorisation of a. */
void linalg_band_qr(linalg_band *f, const double *a, const size_t *start, size_t m, size_t w);
/* One strip of C (zero on entry) becomes Q'B, or A'B for normal equations.  work: w * LINALG_STRIP doubles. */
void linalg_band_project(double *C, const linalg_band *f, const size_t *start, size_t m, size_t w, const double *B, size_t k, size_t width,
                         double *work);
/* X (n x k, zero on entry) = the solution, a strip of columns at a time while it is in the cache. */
void linalg_band_solve(double *X, const linalg_band *f, const size_t *start, size_t m, size_t n, size_t w, const double *B, size_t k, int normal,
                       double *work);

/* ---- LAPACK ---- */

/* Whether LAPACK can count a * b: it counts in 32 bits, products such as m n included. */
int linalg_fits(size_t a, size_t b);
/* f, new, becomes the factorisation of a: normal equations for ET_LINALG_CHOLESKY, else QR; ET_ERANK when singular to working precision. */
et_status linalg_band_factor(linalg_band *f, const double *a, const size_t *start, size_t m, size_t n, size_t w, et_linalg_method method);
/* ET_ERANK with the rank told; at most n - 1, since the caller has found the matrix singular. */
et_status linalg_deficient(size_t *rank, const double *A, size_t m, size_t n);
/* Dense least squares by normal equations, as et_linalg_lsq with valid arguments. */
et_status linalg_lsq_cholesky(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k);
/* The same by SVD: of least norm. */
et_status linalg_lsq_svd(double *X, size_t *rank, const double *A, size_t m, size_t n, const double *B, size_t k);
#endif
