/* exact_lsq: least squares with given parameters and knots, by balls at a precision that is raised until each number rounds to one double, else by
 * rationals; and what a bound for a computed solution needs. */
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include "exact/exact_fit_parts.h"
#include "exact/exact_sums_parts.h"
#include <stdlib.h>

/* Beyond the last, where zeros have been told from the least subnormal, what is left undecided is a tie, mostly; 0: rationals. */
static const slong PRECISIONS[] = {EXACT_BITS, 512, 2560, 0};

/* Sums of squares: of the matrix, of its pseudo-inverse, of the product of both; per coordinate, of the solution and of what is left. */
enum { NORM, INVERSE, CONDITION, SOLUTION, RESIDUAL = SOLUTION + 3, SUMS = RESIDUAL + 3 };

/* The least |U X V' - D|; for curves and scattered points V is 1. */
typedef struct {
    const fmpq_mat_struct *U, *V;
    size_t nu, nv, mu, mv, wu, wv;        /* control points, data, half-widths of U'U and V'V */
    const et_vec3 *D;
    int corners;
} problem;

/* A of a direction, where it is not 0 (Q tells), and A'A as L D L'. */
typedef struct {
    const fmpq_mat_struct *Q;
    exact_mat A, L;
    size_t w;
} side;

static double coordinate(const et_vec3 *P, size_t a)
{
    return a == 0 ? P->x : a == 1 ? P->y : P->z;
}

static double *coordinate_of(et_vec3 *P, size_t a)
{
    return a == 0 ? &P->x : a == 1 ? &P->y : &P->z;
}

/* ---- a direction ---- */

static int seen(const side *s, size_t i, size_t j)
{
    return !fmpq_is_zero(fmpq_mat_entry(s->Q, (slong)i, (slong)j));
}

/* The lower half of A'A. */
static void normal_matrix(side *s)
{
    for (size_t r = 0; r < s->A.rows; r++)
        for (size_t i = 0; i < s->A.columns; i++)
            for (size_t j = i < s->w ? 0 : i - s->w; j <= i && seen(s, r, i); j++)
                if (seen(s, r, j))
                    exact_mat_add_product(&s->L, i, j, &s->A, r, i, &s->A, r, j);
}

static void side_clear(side *s)
{
    exact_mat_clear(&s->A);
    exact_mat_clear(&s->L);
}

/* 0, and nothing held, if A'A is not definite or its balls do not show it. */
static int side_init(side *s, const fmpq_mat_struct *A, size_t w, slong bits)
{
    s->Q = A;
    s->w = w;
    exact_mat_init(&s->A, (size_t)fmpq_mat_nrows(A), (size_t)fmpq_mat_ncols(A), bits);
    exact_mat_init(&s->L, s->A.columns, s->A.columns, bits);
    for (size_t i = 0; i < s->A.rows; i++)
        for (size_t j = 0; j < s->A.columns; j++)
            if (seen(s, i, j))
                exact_mat_put(&s->A, i, j, fmpq_mat_entry(A, (slong)i, (slong)j));
    normal_matrix(s);
    if (exact_band_factor(&s->L, w))
        return 1;
    side_clear(s);
    return 0;
}

/* X' = A+ B. */
static void side_solve(exact_mat *X, const side *s, const exact_mat *B)
{
    exact_mat Y;
    exact_mat_init(&Y, s->A.columns, B->columns, X->bits);
    for (size_t i = 0; i < s->A.rows; i++)
        for (size_t j = 0; j < s->A.columns; j++)
            for (size_t k = 0; k < B->columns && seen(s, i, j); k++)
                exact_mat_add_product(&Y, j, k, &s->A, i, j, B, i, k);
    exact_band_solve(&Y, &s->L, s->w);
    exact_mat_transpose(X, &Y);
    exact_mat_clear(&Y);
}

/* S' = A X. */
static void side_values(exact_mat *S, const side *s, const exact_mat *X)
{
    exact_mat Y;
    exact_mat_init(&Y, s->A.rows, X->columns, X->bits);
    for (size_t i = 0; i < s->A.rows; i++)
        for (size_t j = 0; j < s->A.columns; j++)
            for (size_t k = 0; k < X->columns && seen(s, i, j); k++)
                exact_mat_add_product(&Y, i, k, &s->A, i, j, X, j, k);
    exact_mat_transpose(S, &Y);
    exact_mat_clear(&Y);
}

/* t += sum of squares. */
static void add_squares(exact_mat *t, size_t at, const exact_mat *X)
{
    for (size_t i = 0; i < X->rows; i++)
        for (size_t j = 0; j < X->columns; j++)
            exact_mat_add_product(t, 0, at, X, i, j, X, i, j);
}

/* |A|_F and |A+|_F, squared: the latter's is the trace of (A'A)^-1. */
static void side_norms(exact_mat *t, const side *s)
{
    add_squares(t, NORM, &s->A);
    exact_band_trace(t, 0, INVERSE, &s->L, s->w);
}

/* ---- corners ---- */

/* With G = (A'A)^-1: K (n x 2) = G(., ends) G(ends, ends)^-1, how the least sum of squares moves all when the ends are moved. */
static int side_ends(exact_mat *K, const side *s)
{
    size_t last = s->L.rows - 1;
    exact_mat G, T, E, X;
    fmpq_t one;
    fmpq_init(one);
    fmpq_one(one);
    exact_mat_init(&G, last + 1, 2, K->bits);
    exact_mat_init(&T, 2, last + 1, K->bits);
    exact_mat_init(&X, 2, last + 1, K->bits);
    exact_mat_init(&E, 2, 2, K->bits);
    exact_mat_put(&G, 0, 0, one);
    exact_mat_put(&G, last, 1, one);
    exact_band_solve(&G, &s->L, s->w);
    for (size_t e = 0; e < 4; e++)
        exact_mat_copy(&E, e / 2, e % 2, &G, e / 2 * last, e % 2);
    exact_mat_transpose(&T, &G);
    int ok = exact_mat_solve(&X, &E, &T);      /* E is symmetric */
    exact_mat_transpose(K, &X);
    exact_mat_clear(&G);
    exact_mat_clear(&T);
    exact_mat_clear(&X);
    exact_mat_clear(&E);
    fmpq_clear(one);
    return ok;
}

/* The corners of X are those of D. */
static void copy_corners(exact_mat *X, const exact_mat *D)
{
    for (size_t e = 0; e < 4; e++)
        exact_mat_copy(X, e / 2 * (X->rows - 1), e % 2 * (X->columns - 1), D, e / 2 * (D->rows - 1), e % 2 * (D->columns - 1));
}

/* The least under the condition that the corners are the data's: X + (Ku x Kv)(corners of D - X), since the inverse of the normal matrix and its part
 * of the corners are products of both directions'. */
static int put_corners(exact_mat *X, const side *u, const side *v, const exact_mat *D)
{
    exact_mat Ku, Kv, C, E, M;
    exact_mat_init(&Ku, X->rows, 2, X->bits);
    exact_mat_init(&Kv, X->columns, 2, X->bits);
    exact_mat_init(&C, 2, 2, X->bits);
    exact_mat_init(&E, 2, 2, X->bits);
    exact_mat_init(&M, X->rows, X->columns, X->bits);
    int ok = side_ends(&Ku, u) && side_ends(&Kv, v);
    copy_corners(&E, D);
    copy_corners(&C, X);
    exact_mat_sub(&E, &E, &C);
    exact_mat_sandwich(&M, &Ku, &E, &Kv);
    exact_mat_add(X, X, &M);
    copy_corners(X, D);                        /* balls know them only nearly */
    exact_mat_clear(&Ku);
    exact_mat_clear(&Kv);
    exact_mat_clear(&C);
    exact_mat_clear(&E);
    exact_mat_clear(&M);
    return ok;
}

/* ---- a coordinate ---- */

/* t += |U X V' - D|^2. */
static void add_residual(exact_mat *t, size_t at, const exact_mat *X, const side *u, const side *v, const exact_mat *D)
{
    exact_mat Y, S;
    exact_mat_init(&Y, X->columns, D->rows, X->bits);
    exact_mat_init(&S, D->rows, D->columns, X->bits);
    side_values(&Y, u, X);
    side_values(&S, v, &Y);
    exact_mat_sub(&S, &S, D);
    add_squares(t, at, &S);
    exact_mat_clear(&Y);
    exact_mat_clear(&S);
}

static int round_all(et_vec3 *P, size_t a, const exact_mat *X)
{
    for (size_t k = 0; k < X->rows * X->columns; k++)
        if (!exact_mat_round(coordinate_of(P + k, a), X, k / X->columns, k % X->columns))
            return 0;
    return 1;
}

/* Coordinate a of P and its sums; of as many data as there are control points nothing is left. */
static int solve_coordinate(et_vec3 *P, exact_mat *t, size_t a, const problem *b, const side *u, const side *v)
{
    exact_mat D, Y, X;
    exact_mat_init(&D, b->mu, b->mv, t->bits);
    exact_mat_init(&Y, b->mv, b->nu, t->bits);
    exact_mat_init(&X, b->nu, b->nv, t->bits);
    for (size_t k = 0; k < b->mu * b->mv; k++)
        exact_mat_put_double(&D, k / b->mv, k % b->mv, coordinate(b->D + k, a));
    side_solve(&Y, u, &D);
    side_solve(&X, v, &Y);
    int ok = (!b->corners || put_corners(&X, u, v, &D)) && round_all(P, a, &X);
    if (ok) {
        add_squares(t, SOLUTION + a, &X);
        if (b->nu < b->mu || b->nv < b->mv)
            add_residual(t, RESIDUAL + a, &X, u, v, &D);
    }
    exact_mat_clear(&D);
    exact_mat_clear(&Y);
    exact_mat_clear(&X);
    return ok;
}

/* ---- all of it ---- */

/* Of Kronecker's product of both: the products of the norms. */
static void norms(exact_mat *t, const side *u, const side *v)
{
    exact_mat a, b;
    exact_mat_init(&a, 1, SUMS, t->bits);
    exact_mat_init(&b, 1, SUMS, t->bits);
    side_norms(&a, u);
    side_norms(&b, v);
    exact_mat_add_product(t, 0, NORM, &a, 0, NORM, &b, 0, NORM);
    exact_mat_add_product(t, 0, INVERSE, &a, 0, INVERSE, &b, 0, INVERSE);
    exact_mat_add_product(t, 0, CONDITION, t, 0, NORM, t, 0, INVERSE);
    exact_mat_clear(&a);
    exact_mat_clear(&b);
}

static int round_sums(et_exact_lsq *q, const exact_mat *t)
{
    int ok = exact_mat_round_sqrt(&q->norm, t, 0, NORM) && exact_mat_round_sqrt(&q->condition, t, 0, CONDITION);
    for (size_t a = 0; ok && a < 3; a++)
        ok = exact_mat_round_sqrt(coordinate_of(&q->solution, a), t, 0, SOLUTION + a) &&
             exact_mat_round_sqrt(coordinate_of(&q->residual, a), t, 0, RESIDUAL + a);
    return ok;
}

/* 0 if this precision does not decide everything. */
static int solve(et_vec3 *P, et_exact_lsq *q, const problem *b, slong bits)
{
    side u, v;
    exact_mat t;
    if (!side_init(&u, b->U, b->wu, bits))
        return 0;
    if (!side_init(&v, b->V, b->wv, bits)) {
        side_clear(&u);
        return 0;
    }
    exact_mat_init(&t, 1, SUMS, bits);
    int ok = 1;
    for (size_t a = 0; ok && a < 3; a++)
        ok = solve_coordinate(P, &t, a, b, &u, &v);
    if (ok)
        norms(&t, &u, &v);
    ok = ok && round_sums(q, &t);
    exact_mat_clear(&t);
    side_clear(&u);
    side_clear(&v);
    return ok;
}

/* Balls that show a definite matrix show full rank; else the rank is looked at. */
static et_status run(et_vec3 *P, et_exact_lsq *lsq, const problem *b)
{
    size_t n = b->nu * b->nv, pass = 0;
    et_exact_lsq q;
    et_vec3 *X = et_size_array(n, sizeof *X);
    et_status status = X == NULL ? ET_ENOMEM : ET_OK;
    while (status == ET_OK && !solve(X, &q, b, PRECISIONS[pass])) {
        if (pass++ == 0 && (exact_dependent(b->U) || exact_dependent(b->V)))
            status = ET_ERANK;
    }
    for (size_t k = 0; status == ET_OK && k < n; k++)
        P[k] = X[k];
    if (status == ET_OK)
        *lsq = q;
    free(X);
    return status;
}

/* n functions of degree p on the knots u, m parameters of their domain. */
static int can_fit(const double *u, size_t n, size_t p, const double *t, size_t m)
{
    if (p < 1 || n <= p || n > SIZE_MAX - p - 1 || m < 1 || !et_knots_valid(u, n + p + 1, p))
        return 0;
    for (size_t k = 0; k < m; k++)
        if (!(u[p] <= t[k] && t[k] <= u[n]))
            return 0;
    return 1;
}

et_status et_exact_fit_curve(et_vec3 *P, size_t n, et_exact_lsq *lsq, const double *u, size_t nu, size_t p, const double *t, const et_vec3 *D,
                             size_t m)
{
    size_t size;
    fmpq_mat_t U, V;
    if (nu < n || nu - n != p + 1 || !can_fit(u, n, p, t, m) || !et_vec3_finite(D, m))
        return ET_EINVAL;
    if (!exact_fits(&size, m, n) || !exact_fits(&size, n, n))
        return ET_ENOMEM;
    fmpq_mat_init(U, (slong)m, (slong)n);
    fmpq_mat_init(V, 1, 1);
    fmpq_mat_one(V);
    exact_collocation(U, t, u, p);
    problem b = {U, V, n, 1, m, 1, p, 0, D, 0};
    et_status status = run(P, lsq, &b);
    fmpq_mat_clear(U);
    fmpq_mat_clear(V);
    return status;
}

/* Whether the first and the last datum stand where the first and the last control point do. */
static int at_ends(const double *u, size_t n, size_t p, const double *t, size_t m)
{
    return et_knots_interpolating(u, n + p + 1, p) && t[0] == u[p] && t[m - 1] == u[n];
}

et_status et_exact_fit_grid(et_vec3 *P, size_t nu, size_t nv, et_exact_lsq *lsq, const double *u, size_t p, const double *v, size_t q,
                            const double *a, size_t mu, const double *b, size_t mv, const et_vec3 *D, int corners)
{
    size_t size, data;
    fmpq_mat_t U, V;
    if (!can_fit(u, nu, p, a, mu) || !can_fit(v, nv, q, b, mv) || (corners && !(at_ends(u, nu, p, a, mu) && at_ends(v, nv, q, b, mv))))
        return ET_EINVAL;
    if (!exact_fits(&data, mu, mv) || !exact_fits(&size, nu, nv) || !exact_fits(&size, mu, nu) || !exact_fits(&size, mv, nv) ||
        !exact_fits(&size, nu, nu) || !exact_fits(&size, nv, nv) || !exact_fits(&size, nu, mv))
        return ET_ENOMEM;
    if (!et_vec3_finite(D, data))
        return ET_EINVAL;
    fmpq_mat_init(U, (slong)mu, (slong)nu);
    fmpq_mat_init(V, (slong)mv, (slong)nv);
    exact_collocation(U, a, u, p);
    exact_collocation(V, b, v, q);
    problem f = {U, V, nu, nv, mu, mv, p, q, D, corners};
    et_status status = run(P, lsq, &f);
    fmpq_mat_clear(U);
    fmpq_mat_clear(V);
    return status;
}

/* A[k][i*nv + j] = N_i(a_k) M_j(b_k). */
static void products(fmpq_mat_t A, size_t nv, const double *u, size_t p, const double *v, size_t q, const double *a, const double *b)
{
    slong m = fmpq_mat_nrows(A), columns = (slong)nv;
    fmpq_mat_t U, V;
    fmpq_mat_init(U, m, fmpq_mat_ncols(A) / columns);
    fmpq_mat_init(V, m, columns);
    exact_collocation(U, a, u, p);
    exact_collocation(V, b, v, q);
    for (slong k = 0; k < m; k++)
        for (slong c = 0; c < fmpq_mat_ncols(A); c++)
            fmpq_mul(fmpq_mat_entry(A, k, c), fmpq_mat_entry(U, k, c / columns), fmpq_mat_entry(V, k, c % columns));
    fmpq_mat_clear(U);
    fmpq_mat_clear(V);
}

et_status et_exact_fit_scattered(et_vec3 *P, size_t nu, size_t nv, et_exact_lsq *lsq, const double *u, size_t p, const double *v, size_t q,
                                 const double *a, const double *b, const et_vec3 *D, size_t m)
{
    size_t n, size;
    fmpq_mat_t A, V;
    if (!can_fit(u, nu, p, a, m) || !can_fit(v, nv, q, b, m) || !et_vec3_finite(D, m))
        return ET_EINVAL;
    if (!exact_fits(&n, nu, nv) || !exact_fits(&size, m, n) || !exact_fits(&size, n, n))
        return ET_ENOMEM;
    fmpq_mat_init(A, (slong)m, (slong)n);
    fmpq_mat_init(V, 1, 1);
    fmpq_mat_one(V);
    products(A, nv, u, p, v, q, a, b);
    problem f = {A, V, n, 1, m, 1, p * nv + q, 0, D, 0};
    et_status status = run(P, lsq, &f);
    fmpq_mat_clear(A);
    fmpq_mat_clear(V);
    return status;
}
