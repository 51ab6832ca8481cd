#include "etalon/spline/curve.h"
#include "etalon/base/size.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* ---- storage ---- */

int et_curve_valid(const et_curve *c)
{
    if (!c->u || !c->points || c->n >= SIZE_MAX - c->p || !et_knots_valid(c->u, c->n + c->p + 1, c->p)) {
        return 0;
    }
    /*@ loop invariant place:  i <= c->n;
        loop invariant finite: c->weights != \null ==> \forall integer k; 0 <= k < i ==> \is_finite(c->weights[k]) && c->weights[k] > 0.0;
        loop assigns i;
        loop variant c->n - i;
    */
    for (size_t i = 0; c->weights && i < c->n; i++) {
        if (!isfinite(c->weights[i]) || !(c->weights[i] > 0.0)) {
            return 0;
        }
    }
    return et_vec3_finite(c->points, c->n);
}

et_status et_curve_new(et_curve *c, size_t p, size_t n, int rational)
{
    if (n == 0 || n - 1 < p) {
        return ET_EINVAL;
    }
    if (n >= SIZE_MAX - p) {
        return ET_ENOMEM;
    }
    et_curve t = {p, n, et_size_array(n + p + 1, sizeof(double)), et_size_array(n, sizeof(et_vec3)),
                  rational ? et_size_array(n, sizeof(double)) : NULL};
    if (!t.u || !t.points || (rational && !t.weights)) {
        et_curve_free(&t);
        return ET_ENOMEM;
    }
    //@ assert made: et_numbers(t.u, n + p + 1) && et_numbers((double *)t.points, 3 * n);
    //@ assert room: rational != 0 ==> et_numbers(t.weights, n);
    /*@ loop invariant place: i <= n;
        loop invariant ones:  rational != 0 ==> \forall integer k; 0 <= k < i ==> t.weights[k] == 1.0;
        loop assigns i, t.weights[0 .. n - 1];
        loop variant n - i;
    */
    for (size_t i = 0; rational && i < n; i++) {
        t.weights[i] = 1.0;
    }
    *c = t;
    return ET_OK;
}

void et_curve_free(et_curve *c)
{
    free(c->u);
    free(c->points);
    free(c->weights);
    *c = (et_curve){0, 0, NULL, NULL, NULL};
}

/* ---- workspace: rows of basis values; derivatives of w, a row of binomial coefficients; the basis' own room ---- */

/*@ assigns \nothing;
    ensures value: \result == \min(a, b);
*/
static size_t lesser(size_t a, size_t b)
{
    return a < b ? a : b;
}

size_t et_curve_work(const et_curve *c, size_t d)
{
    size_t rows, basis = et_basis_work(c->p, 1);
    if (basis == SIZE_MAX || d > SIZE_MAX / 4 || et_size_mul(&rows, lesser(d, c->p) + 1, c->p + 1) != ET_OK) {
        return SIZE_MAX;
    }
    size_t sums = rows > SIZE_MAX - basis ? SIZE_MAX : rows + basis;
    return sums > SIZE_MAX - 2 * (d + 1) ? SIZE_MAX : sums + 2 * (d + 1);
}

/* ---- sums over the functions that are not zero, from the first on ---- */

typedef struct { double x, y, z, w; } homogeneous;

/*@ requires c: \valid_read(c) && \valid_read(c->points + i) && (c->weights == \null || \valid_read(c->weights + i));
    assigns  \nothing;
*/
static homogeneous lift(const et_curve *c, size_t i)
{
    et_vec3 P = c->points[i];
    double w = c->weights ? c->weights[i] : 1.0;
    return (homogeneous){w * P.x, w * P.y, w * P.z, w};
}

/* sum_r N[r] (w P)[first + r], r = 0..p: within ((1-u)^-(7p) - 1) sum N |c|, for derivatives 7p + 3; a rounding more with weights. */
/*@ requires c:     \valid_read(c) && et_curve_stored((et_curve *)c);
    requires N:     \valid_read(N + (0 .. c->p));
    requires place: first + c->p < c->n;
    assigns  \nothing;
*/
static homogeneous contract(const double *N, const et_curve *c, size_t first)
{
    homogeneous P = lift(c, first), S = {N[0] * P.x, N[0] * P.y, N[0] * P.z, N[0] * P.w};
    /*@ loop invariant place: 1 <= r <= c->p + 1;
        loop assigns r, P, S;
        loop variant c->p - r;
    */
    for (size_t r = 1; r <= c->p; r++) {
        P = lift(c, first + r);
        S = (homogeneous){S.x + N[r] * P.x, S.y + N[r] * P.y, S.z + N[r] * P.z, S.w + N[r] * P.w};
    }
    return S;
}

/*@ assigns \nothing;
    ensures same: rational == 0 ==> \result.x == S.x && \result.y == S.y && \result.z == S.z;
*/
static et_vec3 project(homogeneous S, int rational)
{
    return rational ? (et_vec3){S.x / S.w, S.y / S.w, S.z / S.w} : (et_vec3){S.x, S.y, S.z};
}

et_vec3 et_curve_point(const et_curve *c, double x, double *work, size_t nwork)
{
    size_t nu = c->n + c->p + 1, span = et_knots_span(c->u, nu, c->p, x);
    //@ ghost fact_product(2, c->p + 5, c->p + 1);
    //@ assert zero: \min(0, c->p) == 0;
    //@ assert one:  et_curve_room((et_curve *)c, 0) == 1*(c->p + 1) + (c->p + 1)*(c->p + 5) + 2;
    //@ assert room: 3*(c->p + 1) <= nwork;
    et_basis_eval(work, c->u, nu, c->p, span, x, work + c->p + 1, nwork - c->p - 1);
    return project(contract(work, c, span - c->p), c->weights != NULL);
}

/* C(k,0..k) from C(k-1,0..k-1), in place: exact up to k = 56. */
/*@ requires row: \valid(binomial + (0 .. k));
    assigns  binomial[0 .. k];
*/
static void pascal(double *binomial, size_t k)
{
    binomial[k] = 1.0;
    /*@ loop invariant place: i <= k;
        loop assigns i, binomial[0 .. k];
        loop variant i;
    */
    for (size_t i = k; i > 1; i--) {
        binomial[i - 1] += binomial[i - 2];
    }
}

/* Eq. 4.8: (A - sum_i C(k,i) w_i D_{k-i}) / w_0, i = 1..k, as w_i = 0 beyond the degree. */
/*@ requires D:    k < SIZE_MAX && \valid_read(D + (0 .. k - 1));
    requires rows: \valid_read(w + (0 .. k)) && \valid_read(binomial + (0 .. k));
    assigns  \nothing;
*/
static et_vec3 quotient(homogeneous A, const et_vec3 *D, const double *w, const double *binomial, size_t k, size_t p)
{
    /*@ loop invariant place: 1 <= i <= k + 1;
        loop assigns i, A;
        loop variant k - i;
    */
    for (size_t i = 1; i <= k && i <= p; i++) {
        double a = binomial[i] * w[i];
        et_vec3 C = D[k - i];
        A = (homogeneous){A.x - a * C.x, A.y - a * C.y, A.z - a * C.z, A.w};
    }
    A.w = w[0];
    return project(A, 1);
}

void et_curve_ders_side(et_vec3 *D, size_t d, const et_curve *c, double x, et_side side, double *work, size_t nwork)
{
    size_t nu = c->n + c->p + 1, span = et_knots_span_side(c->u, nu, c->p, x, side), top = lesser(d, c->p);
    size_t rows = top + 1, row = c->p + 1;
    //@ ghost fact_product(0, rows, row);
    //@ ghost fact_product(0, row, c->p + 5);
    //@ ghost fact_product(rows, row, row);
    //@ assert rows: 0 <= rows*row <= nwork;
    //@ assert fits: 2*(d + 1) + rows*row + row*(c->p + 5) <= nwork;
    double *w = work, *binomial = w + d + 1, *N = binomial + d + 1, *room = N + rows * row;
    const homogeneous zero = {0.0, 0.0, 0.0, 0.0};
    et_basis_ders(N, top, c->u, nu, c->p, span, x, room, nwork - (size_t)(room - work));
    //@ assert curve: et_curve_stored((et_curve *)c) && span < c->n;
    /*@ loop invariant place: k <= d + 1;
        loop invariant above: c->weights == \null ==> \forall integer i; c->p < i < k ==> D[i].x == 0.0 && D[i].y == 0.0 && D[i].z == 0.0;
        loop assigns k, D[0 .. d], w[0 .. d], binomial[0 .. d];
        loop variant d - k;
    */
    for (size_t k = 0; k <= d; k++) {
        //@ ghost if (k <= top) fact_product(k + 1, rows, row);
        //@ ghost fact_product(0, k, row);
        //@ assert row: k <= top ==> 0 <= k*row && k*row + c->p < rows*row;
        homogeneous A = k <= top ? contract(N + k * row, c, span - c->p) : zero;
        w[k] = A.w;
        pascal(binomial, k);
        D[k] = c->weights ? quotient(A, D, w, binomial, k, c->p) : project(A, 0);
    }
}

void et_curve_ders(et_vec3 *D, size_t d, const et_curve *c, double x, double *work, size_t nwork)
{
    et_curve_ders_side(D, d, c, x, ET_SIDE_RIGHT, work, nwork);
}
