/* exact_fit_parts: matrices of balls or of rationals, and least squares on a tensor-product grid in them. */
#ifndef EXACT_EXACT_FIT_PARTS_H
#define EXACT_EXACT_FIT_PARTS_H
#include "exact/exact_parts.h"
#include <arb_mat.h>
#include <flint/fmpq_mat.h>

/* ---- matrices (exact_fit_mat.c) ---- */

enum { EXACT_PRIME = 0x7fffffff };        /* 2^31 - 1: a word has 32 bits somewhere */

/* Balls of `bits` bits, or rationals for bits = 0: formulas are written once, for both. */
typedef struct {
    slong bits;
    size_t rows, columns;
    union {
        arb_mat_t balls;
        fmpq_mat_t rationals;
    } as;
} exact_mat;

/* A matrix of zeros; to be cleared. */
void exact_mat_init(exact_mat *A, size_t rows, size_t columns, slong bits);
void exact_mat_clear(exact_mat *A);
/* A[i][j] = q, enclosed where A is of balls. */
void exact_mat_put(exact_mat *A, size_t i, size_t j, const fmpq_t q);
/* A[i][j] = x, exactly. */
void exact_mat_put_double(exact_mat *A, size_t i, size_t j, double x);
/* A[i][j] = B[k][l]. */
void exact_mat_copy(exact_mat *A, size_t i, size_t j, const exact_mat *B, size_t k, size_t l);
/* A[i][j] = -B[k][l]. */
void exact_mat_copy_minus(exact_mat *A, size_t i, size_t j, const exact_mat *B, size_t k, size_t l);
/* A[i][j] and B[i][j] become their mean. */
void exact_mat_mean(exact_mat *A, exact_mat *B, size_t i, size_t j);
/* C = A B, A + B, A - B, A'; mul and transpose: C another matrix. */
void exact_mat_mul(exact_mat *C, const exact_mat *A, const exact_mat *B);
void exact_mat_add(exact_mat *C, const exact_mat *A, const exact_mat *B);
void exact_mat_sub(exact_mat *C, const exact_mat *A, const exact_mat *B);
void exact_mat_transpose(exact_mat *C, const exact_mat *A);
/* C = A X B'. */
void exact_mat_sandwich(exact_mat *C, const exact_mat *A, const exact_mat *X, const exact_mat *B);
/* C = C + A (x) B, Kronecker's product. */
void exact_mat_add_kronecker(exact_mat *C, const exact_mat *A, const exact_mat *B);
/* 1 and X of A X = B; 0 if A is singular, or its balls do not exclude that. */
int exact_mat_solve(exact_mat *X, const exact_mat *A, const exact_mat *B);
/* C[r][c] = C[r][c] + A[i][j] B[k][l], and less that. */
void exact_mat_add_product(exact_mat *C, size_t r, size_t c, const exact_mat *A, size_t i, size_t j, const exact_mat *B, size_t k, size_t l);
void exact_mat_sub_product(exact_mat *C, size_t r, size_t c, const exact_mat *A, size_t i, size_t j, const exact_mat *B, size_t k, size_t l);
/* C[r][c] = C[r][c] / A[i][j], which is not 0. */
void exact_mat_divide(exact_mat *C, size_t r, size_t c, const exact_mat *A, size_t i, size_t j);
/* Whether A[i][j] is positive; balls: every number of it. */
int exact_mat_positive(const exact_mat *A, size_t i, size_t j);
/* 1 and *x if A[i][j] rounds to the one double *x, which rationals always do; else 0. */
int exact_mat_round(double *x, const exact_mat *A, size_t i, size_t j);
/* The same of the root of A[i][j] >= 0, of which a ball may tell less. */
int exact_mat_round_sqrt(double *x, const exact_mat *A, size_t i, size_t j);

/* ---- banded matrices (exact_band.c) ---- */

/* The lower half of a symmetric matrix of half-width w becomes L and, on the diagonal, D of L D L'.  0 if it is not positive definite, or its balls do
 * not show it; then its content is lost. */
int exact_band_factor(exact_mat *A, size_t w);
/* B = (L D L')^-1 B. */
void exact_band_solve(exact_mat *B, const exact_mat *L, size_t w);
/* The sum of the diagonal of (L D L')^-1 is added to t[i][j]. */
void exact_band_trace(exact_mat *t, size_t i, size_t j, const exact_mat *L, size_t w);

/* Whether the columns of A depend on each other, proved. */
int exact_dependent(const fmpq_mat_t A);

/* The rank of A, proved: full by its reduction modulo EXACT_PRIME, else over the rationals. */
size_t exact_rank(const fmpq_mat_t A);

/* ---- a direction of the grid (exact_fit_side.c) ---- */

/* A (m x n): N_j(t_i) of n functions of degree p on the knots u. */
void exact_collocation(fmpq_mat_t A, const double *t, const double *u, size_t p);

/* With A = (Ai | Ac), the inner columns and the two of the ends, W = (Ai'Ai)^-1 Ai'Ac and Q = Ac - Ai W: A F = (Ai | Q) has Ai'Q = 0, so that least
 * squares fall apart into an inner problem and one for the values at the ends.  F and Y keep the order of the control points. */
typedef struct {
    size_t m, n;
    exact_mat Ai, Q;   /* m x (n - 2), m x 2 */
    exact_mat F;       /* n x n: 1 on the inner diagonal, columns of the ends (1, -W, 0) and (0, -W, 1) */
    exact_mat Y;       /* n x m: inner rows (Ai'Ai)^-1 Ai', end rows those of the ends' problem */
} exact_side;

/* The side of A.  Its ends' problem: the least |Q x - d|^2, or, doubled, |Q x - d|^2 + |Q x - d|^2 without the first and the last row; end rows of Y
 * are zero if `open`.  0 if balls are too wide, and then nothing is held. */
int exact_side_init(exact_side *s, const fmpq_mat_t A, int doubled, int open, slong bits);
void exact_side_clear(exact_side *s);

/* X of the least |U X V' - D|^2 + |U X V' - D|^2 without D's border; 0 if balls are too wide. */
int exact_fit_twice(exact_mat *X, const exact_mat *U, const exact_mat *V, const exact_mat *D);

/* ---- all of it (exact_fit_solve.c) ---- */

typedef struct {
    et_doublenet data, control;
    et_fit_approach approach;
    int fixed;                            /* corners stand at the data's */
    const et_vec3 *D;                     /* by class */
    et_vec3 *P[2];                        /* what is to be found */
    fmpq_mat_struct A[2][2];              /* A[view][direction]; of improved and joint, view 0's is both views' */
} exact_fit;

/* Every coordinate of P.  *bits as in exact.h. */
et_status exact_fit_run(exact_fit *f, size_t *bits, const et_task *task, et_message *message);
#endif
