/* exact_band: banded symmetric systems, and whether columns depend on each other. */
#include "exact/exact_fit_parts.h"
#include <flint/nmod_mat.h>
#include <flint/ulong_extras.h>

/* The row behind the last that the band of row or column i reaches. */
static size_t reach(const exact_mat *A, size_t i, size_t w)
{
    return i + w + 1 < A->rows ? i + w + 1 : A->rows;
}

int exact_band_factor(exact_mat *A, size_t w)
{
    int definite = 1;
    exact_mat l;
    exact_mat_init(&l, 1, 1, A->bits);
    for (size_t k = 0; definite && k < A->rows; k++) {
        definite = exact_mat_positive(A, k, k);
        for (size_t i = reach(A, k, w); definite && i-- > k + 1;) {     /* those above still hold L D */
            exact_mat_copy(&l, 0, 0, A, i, k);
            exact_mat_divide(&l, 0, 0, A, k, k);
            for (size_t j = k + 1; j <= i; j++)
                exact_mat_sub_product(A, i, j, &l, 0, 0, A, j, k);
            exact_mat_copy(A, i, k, &l, 0, 0);
        }
    }
    exact_mat_clear(&l);
    return definite;
}

void exact_band_solve(exact_mat *B, const exact_mat *L, size_t w)
{
    for (size_t c = 0; c < B->columns; c++) {
        for (size_t i = 0; i < L->rows; i++)
            for (size_t k = i < w ? 0 : i - w; k < i; k++)
                exact_mat_sub_product(B, i, c, L, i, k, B, k, c);
        for (size_t i = L->rows; i-- > 0;) {
            exact_mat_divide(B, i, c, L, i, i);
            for (size_t k = i + 1; k < reach(L, i, w); k++)
                exact_mat_sub_product(B, i, c, L, k, i, B, k, c);
        }
    }
}

/* Of Z = (L D L')^-1 the elements within the band are enough to find one another (Takahashi, Fagan and Chin 1973): Z = D^-1 L^-1 + (I - L') Z. */
void exact_band_trace(exact_mat *t, size_t i, size_t j, const exact_mat *L, size_t w)
{
    exact_mat Z, unit;
    exact_mat_init(&Z, L->rows, L->rows, L->bits);
    exact_mat_init(&unit, 1, 1, L->bits);
    exact_mat_put_double(&unit, 0, 0, 1);
    for (size_t c = L->rows; c-- > 0;) {
        for (size_t r = reach(L, c, w); r-- > c;) {
            if (r == c) {
                exact_mat_put_double(&Z, c, c, 1);
                exact_mat_divide(&Z, c, c, L, c, c);
            }
            for (size_t k = c + 1; k < reach(L, c, w); k++)
                exact_mat_sub_product(&Z, r, c, L, k, c, &Z, k > r ? k : r, k > r ? r : k);
        }
        exact_mat_add_product(t, i, j, &unit, 0, 0, &Z, c, c);
    }
    exact_mat_clear(&Z);
    exact_mat_clear(&unit);
}

/* ---- dependence ---- */

/* The first column of A's echelon form that has no pivot, and the pivots' columns before it; or the number of columns. */
static slong first_free(slong *pivot, nmod_mat_t A)
{
    slong rank = nmod_mat_rref(A), c = 0;
    while (c < rank && nmod_mat_entry(A, c, c) != 0)
        c++;
    for (slong r = 0, at = 0; pivot != NULL && r < rank; r++, at++) {
        while (nmod_mat_entry(A, r, at) == 0)
            at++;
        pivot[r] = at;
    }
    return c;
}

/* Whether column c of A is what the columns before it say it has to be, if they and these rows are independent. */
static int is_sum(const fmpz_mat_t A, slong c, const slong *row)
{
    fmpz_mat_t S, b;
    fmpq_mat_t x, B, Bx;
    int same = 1;
    fmpz_mat_init(S, c, c);
    fmpz_mat_init(b, c, 1);
    fmpq_mat_init(x, c, 1);
    fmpq_mat_init(B, fmpz_mat_nrows(A), c);
    fmpq_mat_init(Bx, fmpz_mat_nrows(A), 1);
    for (slong r = 0; r < c; r++) {
        fmpz_set(fmpz_mat_entry(b, r, 0), fmpz_mat_entry(A, row[r], c));
        for (slong k = 0; k < c; k++)
            fmpz_set(fmpz_mat_entry(S, r, k), fmpz_mat_entry(A, row[r], k));
    }
    if (c > 0)
        same = fmpq_mat_solve_fmpz_mat(x, S, b);
    for (slong r = 0; r < fmpz_mat_nrows(A); r++)
        for (slong k = 0; k < c; k++)
            fmpq_set_fmpz(fmpq_mat_entry(B, r, k), fmpz_mat_entry(A, r, k));
    fmpq_mat_mul(Bx, B, x);
    for (slong r = 0; same && r < fmpz_mat_nrows(A); r++)
        same = fmpq_equal_fmpz(fmpq_mat_entry(Bx, r, 0), fmpz_mat_entry(A, r, c));
    fmpz_mat_clear(S);
    fmpz_mat_clear(b);
    fmpq_mat_clear(x);
    fmpq_mat_clear(B);
    fmpq_mat_clear(Bx);
    return same;
}

/* 1 or 0; -1 if the prime, which divides a minor, tells nothing. */
static int dependent_by(const fmpz_mat_t A, ulong prime)
{
    slong m = fmpz_mat_nrows(A), n = fmpz_mat_ncols(A), c;
    nmod_mat_t residues, first, turned;
    nmod_mat_init(residues, m, n, prime);
    nmod_mat_init(first, m, n, prime);
    fmpz_mat_get_nmod_mat(residues, A);
    nmod_mat_set(first, residues);
    c = first_free(NULL, first);
    nmod_mat_clear(first);
    int answer = c == n ? 0 : -1;
    if (c < n) {
        slong *row = flint_malloc((size_t)(m + 1) * sizeof *row);
        nmod_mat_init(turned, c, m, prime);
        for (slong r = 0; r < m; r++)
            for (slong k = 0; k < c; k++)
                nmod_mat_entry(turned, k, r) = nmod_mat_entry(residues, r, k);
        first_free(row, turned);
        answer = is_sum(A, c, row) ? 1 : -1;
        nmod_mat_clear(turned);
        flint_free(row);
    }
    nmod_mat_clear(residues);
    return answer;
}

/* Columns that are independent modulo a prime are independent.  The first that is not is dependent by all primes but those that divide some minor: it
 * is tried whether it is the sum of the others that it would have to be. */
int exact_dependent(const fmpq_mat_t A)
{
    fmpz_mat_t whole;
    int answer = -1;
    if (fmpq_mat_nrows(A) < fmpq_mat_ncols(A))
        return 1;
    fmpz_mat_init(whole, fmpq_mat_nrows(A), fmpq_mat_ncols(A));
    fmpq_mat_get_fmpz_mat_rowwise(whole, NULL, A);
    for (ulong prime = EXACT_PRIME; answer < 0; prime = n_nextprime(prime, 1))
        answer = dependent_by(whole, prime);
    fmpz_mat_clear(whole);
    return answer;
}
