/* exact_fit_side: one direction of a grid, its control points split into inner ones and the two ends.
 *
 * Least squares on the grid, |A P B' - D|^2, are solved in the coordinates P = F X G' of both directions' splits.  There the normal equations fall
 * apart: inner x inner, inner x ends, ends x inner, ends x ends.  That stays so if the data inside the border are counted twice, as two views that
 * share their border do, since data at clamped ends see the ends alone: the end's function is 1 there, the others 0.
 */
#include "exact/exact_fit_parts.h"
#include "etalon/spline/knots.h"

void exact_collocation(fmpq_mat_t A, const double *t, const double *u, size_t p)
{
    const size_t m = (size_t)fmpq_mat_nrows(A), nu = (size_t)fmpq_mat_ncols(A) + p + 1;
    fmpq *N = _fmpq_vec_init((slong)p + 1);

    for (size_t i = 0; i < m; i++) {
        const size_t span = et_knots_span(u, nu, p, t[i]);
        exact_basis(N, 0, u, nu, p, span, t[i]);
        for (size_t k = 0; k <= p; k++)
            fmpq_set(fmpq_mat_entry(A, (slong)i, (slong)(span - p + k)), N + k);
    }
    _fmpq_vec_clear(N, (slong)p + 1);
}

/* G = L' L. */
static void gram(exact_mat *G, const exact_mat *L)
{
    exact_mat Lt;

    exact_mat_init(&Lt, L->columns, L->rows, G->bits);
    exact_mat_transpose(&Lt, L);
    exact_mat_mul(G, &Lt, L);
    exact_mat_clear(&Lt);
}

/* I = L without its first and last row, which become zero. */
static void without_border(exact_mat *I, const exact_mat *L)
{
    for (size_t i = 1; i + 1 < L->rows; i++)
        for (size_t j = 0; j < L->columns; j++)
            exact_mat_copy(I, i, j, L, i, j);
}

/* Z = (Ai'Ai)^-1 Ai'. */
static int inner_inverse(exact_mat *Z, const exact_mat *Ai)
{
    exact_mat G, At;
    int ok;

    exact_mat_init(&G, Z->rows, Z->rows, Z->bits);
    exact_mat_init(&At, Z->rows, Z->columns, Z->bits);
    gram(&G, Ai);
    exact_mat_transpose(&At, Ai);
    ok = exact_mat_solve(Z, &G, &At);
    exact_mat_clear(&G);
    exact_mat_clear(&At);
    return ok;
}

/* Q = Ac - Ai W, and F. */
static void split(exact_side *s, const exact_mat *Z, const exact_mat *Ac)
{
    const size_t inner = s->n - 2;
    exact_mat W, AW, one;

    exact_mat_init(&W, inner, 2, Z->bits);
    exact_mat_init(&AW, s->m, 2, Z->bits);
    exact_mat_init(&one, 1, 1, Z->bits);
    exact_mat_put_double(&one, 0, 0, 1);
    exact_mat_mul(&W, Z, Ac);
    exact_mat_mul(&AW, &s->Ai, &W);
    exact_mat_sub(&s->Q, Ac, &AW);
    for (size_t i = 0; i < s->n; i++)
        exact_mat_copy(&s->F, i, i, &one, 0, 0);
    for (size_t i = 0; i < inner; i++)
        for (size_t e = 0; e < 2; e++)
            exact_mat_copy_minus(&s->F, i + 1, e * (s->n - 1), &W, i, e);
    exact_mat_clear(&one);
    exact_mat_clear(&AW);
    exact_mat_clear(&W);
}

/* V = (Q'Q)^-1 Q', or with Qi, which is Q without its border, (Q'Q + Qi'Qi)^-1 (Q + Qi)'. */
static int end_inverse(exact_mat *V, const exact_mat *Q, int doubled)
{
    exact_mat Qi, T, Ti, R, Rt;
    int ok;

    exact_mat_init(&Qi, Q->rows, 2, Q->bits);
    exact_mat_init(&T, 2, 2, Q->bits);
    exact_mat_init(&Ti, 2, 2, Q->bits);
    exact_mat_init(&R, Q->rows, 2, Q->bits);
    exact_mat_init(&Rt, 2, Q->rows, Q->bits);
    if (doubled)
        without_border(&Qi, Q);
    gram(&T, Q);
    gram(&Ti, &Qi);
    exact_mat_add(&T, &T, &Ti);
    exact_mat_add(&R, Q, &Qi);
    exact_mat_transpose(&Rt, &R);
    ok = exact_mat_solve(V, &T, &Rt);
    exact_mat_clear(&Qi);
    exact_mat_clear(&T);
    exact_mat_clear(&Ti);
    exact_mat_clear(&R);
    exact_mat_clear(&Rt);
    return ok;
}

/* Y of its inner and its end rows. */
static void compose(exact_side *s, const exact_mat *Z, const exact_mat *V)
{
    for (size_t i = 0; i < s->m; i++) {
        for (size_t k = 0; k + 2 < s->n; k++)
            exact_mat_copy(&s->Y, k + 1, i, Z, k, i);
        for (size_t e = 0; e < 2; e++)
            exact_mat_copy(&s->Y, e * (s->n - 1), i, V, e, i);
    }
}

/* Ai and Ac of A. */
static void take(exact_mat *Ai, exact_mat *Ac, const fmpq_mat_t A)
{
    for (size_t i = 0; i < Ai->rows; i++) {
        for (size_t k = 0; k < Ai->columns; k++)
            exact_mat_put(Ai, i, k, fmpq_mat_entry(A, (slong)i, (slong)k + 1));
        for (size_t e = 0; e < 2; e++)
            exact_mat_put(Ac, i, e, fmpq_mat_entry(A, (slong)i, (slong)(e * (Ai->columns + 1))));
    }
}

int exact_side_init(exact_side *s, const fmpq_mat_t A, int doubled, int open, slong bits)
{
    const size_t m = (size_t)fmpq_mat_nrows(A), n = (size_t)fmpq_mat_ncols(A);
    exact_mat Ac, Z, V;
    int ok;

    s->m = m;
    s->n = n;
    exact_mat_init(&s->Ai, m, n - 2, bits);
    exact_mat_init(&s->Q, m, 2, bits);
    exact_mat_init(&s->F, n, n, bits);
    exact_mat_init(&s->Y, n, m, bits);
    exact_mat_init(&Ac, m, 2, bits);
    exact_mat_init(&Z, n - 2, m, bits);
    exact_mat_init(&V, 2, m, bits);
    take(&s->Ai, &Ac, A);
    ok = inner_inverse(&Z, &s->Ai);
    if (ok)
        split(s, &Z, &Ac);
    if (ok && !open)
        ok = end_inverse(&V, &s->Q, doubled);
    if (ok)
        compose(s, &Z, &V);
    exact_mat_clear(&Ac);
    exact_mat_clear(&Z);
    exact_mat_clear(&V);
    if (!ok)
        exact_side_clear(s);
    return ok;
}

void exact_side_clear(exact_side *s)
{
    exact_mat_clear(&s->Ai);
    exact_mat_clear(&s->Q);
    exact_mat_clear(&s->F);
    exact_mat_clear(&s->Y);
}

/* N = N + U'U (x) V'V and R = R + U'D V, R as one column. */
static void add_normal(exact_mat *N, exact_mat *R, const exact_mat *U, const exact_mat *V, const exact_mat *D)
{
    const size_t a = U->columns, b = V->columns;
    exact_mat Gu, Gv, Ut, Vt, S, column;

    exact_mat_init(&Gu, a, a, N->bits);
    exact_mat_init(&Gv, b, b, N->bits);
    exact_mat_init(&Ut, a, U->rows, N->bits);
    exact_mat_init(&Vt, b, V->rows, N->bits);
    exact_mat_init(&S, a, b, N->bits);
    exact_mat_init(&column, a * b, 1, N->bits);
    gram(&Gu, U);
    gram(&Gv, V);
    exact_mat_add_kronecker(N, &Gu, &Gv);
    exact_mat_transpose(&Ut, U);
    exact_mat_transpose(&Vt, V);
    exact_mat_sandwich(&S, &Ut, D, &Vt);
    for (size_t i = 0; i < a * b; i++)
        exact_mat_copy(&column, i, 0, &S, i / b, i % b);
    exact_mat_add(R, R, &column);
    exact_mat_clear(&Gu);
    exact_mat_clear(&Gv);
    exact_mat_clear(&Ut);
    exact_mat_clear(&Vt);
    exact_mat_clear(&S);
    exact_mat_clear(&column);
}

int exact_fit_twice(exact_mat *X, const exact_mat *U, const exact_mat *V, const exact_mat *D)
{
    const size_t a = U->columns, b = V->columns;
    exact_mat Ui, Vi, N, R, S;
    int ok;

    exact_mat_init(&Ui, U->rows, a, X->bits);
    exact_mat_init(&Vi, V->rows, b, X->bits);
    exact_mat_init(&N, a * b, a * b, X->bits);
    exact_mat_init(&R, a * b, 1, X->bits);
    exact_mat_init(&S, a * b, 1, X->bits);
    without_border(&Ui, U);
    without_border(&Vi, V);
    add_normal(&N, &R, U, V, D);
    add_normal(&N, &R, &Ui, &Vi, D);
    ok = exact_mat_solve(&S, &N, &R);
    for (size_t i = 0; ok && i < a * b; i++)
        exact_mat_copy(X, i / b, i % b, &S, i, 0);
    exact_mat_clear(&Ui);
    exact_mat_clear(&Vi);
    exact_mat_clear(&N);
    exact_mat_clear(&R);
    exact_mat_clear(&S);
    return ok;
}
