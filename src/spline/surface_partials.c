#include "etalon/base/size.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/surface.h"
#include "surface_parts.h"
#include <stdint.h>

/*@ assigns \nothing;
    ensures  value: \result == \min(a, b);
*/
static size_t lesser(size_t a, size_t b)
{
    return a < b ? a : b;
}

/*@ assigns \nothing;
    ensures  value: \result == \max(a, b);
*/
static size_t greater(size_t a, size_t b)
{
    return a > b ? a : b;
}

/* ---- workspace; SIZE_MAX stands for all that does not fit ---- */

/*@ assigns \nothing;
    ensures  value: \result == (a + b <= SIZE_MAX ? a + b : SIZE_MAX);
*/
static size_t plus(size_t a, size_t b)
{
    return a > SIZE_MAX - b ? SIZE_MAX : a + b;
}

/*@ assigns \nothing;
    ensures  value: \result == (a * b <= SIZE_MAX ? a * b : SIZE_MAX);
*/
static size_t product(size_t a, size_t b)
{
    size_t n = SIZE_MAX;
    return et_size_mul(&n, a, b) == ET_OK ? n : SIZE_MAX;
}

/* n (n + 1)/2: numbers in a triangle of n rows. */
/*@ assigns \nothing;
    ensures  value: 2*\result == n*(n + 1) || (\result == SIZE_MAX && n*(n + 1) > 2*SIZE_MAX);
    ensures  some:  n >= 1 ==> \result >= 1;
*/
static size_t triangle(size_t n)
{
    return n % 2 == 0 ? product(n / 2, n + 1) : product(n, n / 2 + 1);
}

/*@ requires s:    \valid_read(s);
    assigns  \nothing;
    ensures  room: (s->p + 1)*(s->p + 5) <= SIZE_MAX && (s->q + 1)*(s->q + 5) <= SIZE_MAX
                       ==> \result == \max((s->p + 1)*(s->p + 5), (s->q + 1)*(s->q + 5));
*/
static size_t basis_room(const et_surface *s)
{
    return greater(et_basis_work(s->p, 1), et_basis_work(s->q, 1));
}

/* Basis values of both directions with the rows of derivatives, the basis' own room, a row of sums for each derivative along u, the derivatives of w,
 * binomial coefficients. */
typedef struct { double *N, *M, *basis, *T, *w, *binomial; } room;

size_t et_surface_partials_work(const et_surface *s, size_t d)
{
    if (d == SIZE_MAX || s->p == SIZE_MAX || s->q == SIZE_MAX) {
        return SIZE_MAX;
    }
    size_t a = lesser(d, s->p) + 1, N = product(a, s->p + 1), M = product(lesser(d, s->q) + 1, s->q + 1), T = product(product(a, s->q + 1), 4);
    return plus(plus(plus(N, M), plus(T, basis_room(s))), product(2, triangle(d + 1)));
}

static room divide(const et_surface *s, size_t p, size_t q, size_t d, double *work)
{
    room r = {.N = work};
    r.M = r.N + (p + 1) * (s->p + 1);
    r.basis = r.M + (q + 1) * (s->q + 1);
    r.T = r.basis + basis_room(s);
    r.w = r.T + 4 * (p + 1) * (s->q + 1);
    r.binomial = r.w + triangle(d + 1);
    return r;
}

/* ---- derivatives ---- */

/* Where the derivative a times along u and b times along v stands. */
static size_t place(size_t a, size_t b)
{
    return triangle(a + b) + b;
}

/* C(k, i), k > 0, stands at triangle(k) + i: exact up to k = 56. */
static void pascal(double *binomial, size_t d)
{
    for (size_t k = 1; k <= d; k++) {
        double *row = binomial + triangle(k), *above = row - k;
        row[0] = row[k] = 1.0;
        for (size_t i = 1; i < k; i++) {
            row[i] = above[i - 1] + above[i];
        }
    }
}

static et_vec3 less(et_vec3 A, double a, et_vec3 S)
{
    return (et_vec3){A.x - a * S.x, A.y - a * S.y, A.z - a * S.z};
}

/* Eq. 4.20: (A - sum C(a,i) C(b,j) w_ij D_{a-i,b-j}) / w over (i, j) other than (0, 0), w_ij = 0 beyond the degrees: first those with j = 0, then
 * those with i = 0, then the rest. */
static et_vec3 quotient(surface_point A, const et_vec3 *D, const room *r, const et_surface *s, size_t a, size_t b)
{
    const double *Ca = r->binomial + triangle(a), *Cb = r->binomial + triangle(b);
    et_vec3 S = {A.x, A.y, A.z};
    for (size_t i = 1; i <= a && i <= s->p; i++) {
        S = less(S, Ca[i] * r->w[place(i, 0)], D[place(a - i, b)]);
    }
    for (size_t j = 1; j <= b && j <= s->q; j++) {
        S = less(S, Cb[j] * r->w[place(0, j)], D[place(a, b - j)]);
    }
    for (size_t i = 1; i <= a && i <= s->p; i++) {
        for (size_t j = 1; j <= b && j <= s->q; j++) {
            S = less(S, Ca[i] * Cb[j] * r->w[place(i, j)], D[place(a - i, b - j)]);
        }
    }
    return (et_vec3){S.x / r->w[0], S.y / r->w[0], S.z / r->w[0]};
}

void et_surface_partials(et_vec3 *D, size_t d, const et_surface *s, double u, double v, et_side side_u, et_side side_v, double *work, size_t nwork)
{
    size_t nu = s->nu + s->p + 1, nv = s->nv + s->q + 1, p = lesser(d, s->p), q = lesser(d, s->q), columns = s->q + 1;
    room r = divide(s, p, q, d, work);
    surface_point *T = (surface_point *)r.T;
    size_t nbasis = nwork - (size_t)(r.basis - work);
    size_t i = et_knots_span_side(s->u, nu, s->p, u, side_u), j = et_knots_span_side(s->v, nv, s->q, v, side_v);
    et_basis_ders(r.N, p, s->u, nu, s->p, i, u, r.basis, nbasis);
    et_basis_ders(r.M, q, s->v, nv, s->q, j, v, r.basis, nbasis);
    for (size_t a = 0; a <= p; a++) {
        surface_contract_u(T + a * columns, columns, r.N + a * (s->p + 1), s, (i - s->p) * s->nv + j - s->q);
    }
    pascal(r.binomial, d);
    for (size_t order = 0; order <= d; order++) {
        for (size_t b = 0; b <= order; b++) {
            size_t a = order - b, at = place(a, b);
            surface_point A = {0.0, 0.0, 0.0, 0.0};
            if (a <= p && b <= q) {
                A = surface_contract_v(T + a * columns, r.M + b * columns, s->q);
            }
            r.w[at] = A.w;
            D[at] = s->weights ? quotient(A, D, &r, s, a, b) : surface_project(A, 0);
        }
    }
}
