#include "exact/exact_fit_parts.h"
#include <flint/nmod_mat.h>

/* ---- entries ---- */

void exact_mat_init(exact_mat *A, size_t rows, size_t columns, slong bits)
{
    A->bits = bits;
    A->rows = rows;
    A->columns = columns;
    if (bits > 0)
        arb_mat_init(A->as.balls, (slong)rows, (slong)columns);
    else
        fmpq_mat_init(A->as.rationals, (slong)rows, (slong)columns);
}

void exact_mat_clear(exact_mat *A)
{
    if (A->bits > 0)
        arb_mat_clear(A->as.balls);
    else
        fmpq_mat_clear(A->as.rationals);
}

static arb_ptr ball_at(const exact_mat *A, size_t i, size_t j)
{
    return arb_mat_entry(A->as.balls, (slong)i, (slong)j);
}

static fmpq *rational_at(const exact_mat *A, size_t i, size_t j)
{
    return fmpq_mat_entry(A->as.rationals, (slong)i, (slong)j);
}

void exact_mat_put(exact_mat *A, size_t i, size_t j, const fmpq_t q)
{
    if (A->bits > 0)
        arb_set_fmpq(ball_at(A, i, j), q, A->bits);
    else
        fmpq_set(rational_at(A, i, j), q);
}

void exact_mat_put_double(exact_mat *A, size_t i, size_t j, double x)
{
    if (A->bits > 0)
        arb_set_d(ball_at(A, i, j), x);
    else
        exact_set(rational_at(A, i, j), x);
}

void exact_mat_copy(exact_mat *A, size_t i, size_t j, const exact_mat *B, size_t k, size_t l)
{
    if (A->bits > 0)
        arb_set(ball_at(A, i, j), ball_at(B, k, l));
    else
        fmpq_set(rational_at(A, i, j), rational_at(B, k, l));
}

void exact_mat_copy_minus(exact_mat *A, size_t i, size_t j, const exact_mat *B, size_t k, size_t l)
{
    if (A->bits > 0)
        arb_neg(ball_at(A, i, j), ball_at(B, k, l));
    else
        fmpq_neg(rational_at(A, i, j), rational_at(B, k, l));
}

void exact_mat_mean(exact_mat *A, exact_mat *B, size_t i, size_t j)
{
    if (A->bits > 0) {
        arb_ptr a = ball_at(A, i, j), b = ball_at(B, i, j);
        arb_add(a, a, b, A->bits);
        arb_mul_2exp_si(a, a, -1);
        arb_set(b, a);
    } else {
        fmpq *a = rational_at(A, i, j), *b = rational_at(B, i, j);
        fmpq_add(a, a, b);
        fmpq_div_2exp(a, a, 1);
        fmpq_set(b, a);
    }
}

int exact_mat_round(double *x, const exact_mat *A, size_t i, size_t j)
{
    if (A->bits > 0)
        return exact_round_ball(x, ball_at(A, i, j));
    *x = exact_round(rational_at(A, i, j));
    return 1;
}

int exact_mat_round_sqrt(double *x, const exact_mat *A, size_t i, size_t j)
{
    if (A->bits > 0) {
        arb_t root;
        arb_init(root);
        arb_sqrtpos(root, ball_at(A, i, j), A->bits);
        int one = exact_round_ball(x, root);
        arb_clear(root);
        return one;
    }
    *x = exact_round_sqrt(rational_at(A, i, j));
    return 1;
}

/* ---- products ---- */

void exact_mat_mul(exact_mat *C, const exact_mat *A, const exact_mat *B)
{
    if (C->bits > 0)
        arb_mat_mul(C->as.balls, A->as.balls, B->as.balls, C->bits);
    else
        fmpq_mat_mul(C->as.rationals, A->as.rationals, B->as.rationals);
}

void exact_mat_add(exact_mat *C, const exact_mat *A, const exact_mat *B)
{
    if (C->bits > 0)
        arb_mat_add(C->as.balls, A->as.balls, B->as.balls, C->bits);
    else
        fmpq_mat_add(C->as.rationals, A->as.rationals, B->as.rationals);
}

void exact_mat_sub(exact_mat *C, const exact_mat *A, const exact_mat *B)
{
    if (C->bits > 0)
        arb_mat_sub(C->as.balls, A->as.balls, B->as.balls, C->bits);
    else
        fmpq_mat_sub(C->as.rationals, A->as.rationals, B->as.rationals);
}

void exact_mat_transpose(exact_mat *C, const exact_mat *A)
{
    if (C->bits > 0)
        arb_mat_transpose(C->as.balls, A->as.balls);
    else
        fmpq_mat_transpose(C->as.rationals, A->as.rationals);
}

void exact_mat_sandwich(exact_mat *C, const exact_mat *A, const exact_mat *X, const exact_mat *B)
{
    exact_mat AX, Bt;

    exact_mat_init(&AX, A->rows, X->columns, C->bits);
    exact_mat_init(&Bt, B->columns, B->rows, C->bits);
    exact_mat_mul(&AX, A, X);
    exact_mat_transpose(&Bt, B);
    exact_mat_mul(C, &AX, &Bt);
    exact_mat_clear(&AX);
    exact_mat_clear(&Bt);
}

void exact_mat_add_product(exact_mat *C, size_t r, size_t c, const exact_mat *A, size_t i, size_t j, const exact_mat *B, size_t k, size_t l)
{
    if (C->bits > 0)
        arb_addmul(ball_at(C, r, c), ball_at(A, i, j), ball_at(B, k, l), C->bits);
    else
        fmpq_addmul(rational_at(C, r, c), rational_at(A, i, j), rational_at(B, k, l));
}

void exact_mat_sub_product(exact_mat *C, size_t r, size_t c, const exact_mat *A, size_t i, size_t j, const exact_mat *B, size_t k, size_t l)
{
    if (C->bits > 0)
        arb_submul(ball_at(C, r, c), ball_at(A, i, j), ball_at(B, k, l), C->bits);
    else
        fmpq_submul(rational_at(C, r, c), rational_at(A, i, j), rational_at(B, k, l));
}

void exact_mat_divide(exact_mat *C, size_t r, size_t c, const exact_mat *A, size_t i, size_t j)
{
    if (C->bits > 0)
        arb_div(ball_at(C, r, c), ball_at(C, r, c), ball_at(A, i, j), C->bits);
    else
        fmpq_div(rational_at(C, r, c), rational_at(C, r, c), rational_at(A, i, j));
}

int exact_mat_positive(const exact_mat *A, size_t i, size_t j)
{
    return A->bits > 0 ? arb_is_positive(ball_at(A, i, j)) : fmpq_sgn(rational_at(A, i, j)) > 0;
}

void exact_mat_add_kronecker(exact_mat *C, const exact_mat *A, const exact_mat *B)
{
    for (size_t i = 0; i < A->rows; i++)
        for (size_t j = 0; j < A->columns; j++)
            for (size_t k = 0; k < B->rows; k++)
                for (size_t l = 0; l < B->columns; l++)
                    exact_mat_add_product(C, i * B->rows + k, j * B->columns + l, A, i, j, B, k, l);
}

/* ---- solutions ---- */

int exact_mat_solve(exact_mat *X, const exact_mat *A, const exact_mat *B)
{
    if (X->bits > 0)
        return arb_mat_solve(X->as.balls, A->as.balls, B->as.balls, X->bits);
    return fmpq_mat_solve(X->as.rationals, A->as.rationals, B->as.rationals);
}

size_t exact_rank(const fmpq_mat_t A)
{
    const slong rows = fmpq_mat_nrows(A), columns = fmpq_mat_ncols(A);
    fmpz_mat_t whole;
    nmod_mat_t residues;
    slong rank;

    fmpz_mat_init(whole, rows, columns);
    nmod_mat_init(residues, rows, columns, EXACT_PRIME);
    fmpq_mat_get_fmpz_mat_rowwise(whole, NULL, A);
    fmpz_mat_get_nmod_mat(residues, whole);
    /* A minor that is not zero modulo a prime is not zero. */
    rank = nmod_mat_rank(residues);
    if (rank < columns)
        rank = fmpz_mat_rank(whole);
    nmod_mat_clear(residues);
    fmpz_mat_clear(whole);
    return (size_t)rank;
}
