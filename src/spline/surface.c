#include "etalon/spline/surface.h"
#include "etalon/base/size.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include "surface_parts.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- storage ---- */

int et_surface_valid(const et_surface *s)
{
    size_t n;
    if (!s->u || !s->v || !s->points || s->p > SIZE_MAX - s->nu || s->q > SIZE_MAX - s->nv || s->nu + s->p == SIZE_MAX || s->nv + s->q == SIZE_MAX) {
        return 0;
    }
    if (et_size_mul(&n, s->nu, s->nv) != ET_OK || !et_knots_valid(s->u, s->nu + s->p + 1, s->p) || !et_knots_valid(s->v, s->nv + s->q + 1, s->q)) {
        return 0;
    }
    /*@ loop invariant place:  i <= n;
        loop invariant finite: s->weights != \null ==> \forall integer k; 0 <= k < i ==> \is_finite(s->weights[k]) && s->weights[k] > 0.0;
        loop assigns i;
        loop variant n - i;
    */
    for (size_t i = 0; s->weights && i < n; i++) {
        if (!isfinite(s->weights[i]) || !(s->weights[i] > 0.0)) {
            return 0;
        }
    }
    return et_vec3_finite(s->points, n);
}

et_status et_surface_new(et_surface *s, size_t p, size_t q, size_t nu, size_t nv, int rational)
{
    size_t n;
    if (nu == 0 || nv == 0 || nu - 1 < p || nv - 1 < q) {
        return ET_EINVAL;
    }
    if (p > SIZE_MAX - nu || q > SIZE_MAX - nv || nu + p == SIZE_MAX || nv + q == SIZE_MAX || et_size_mul(&n, nu, nv) != ET_OK) {
        return ET_ENOMEM;
    }
    et_surface t = {p, q, nu, nv, et_size_array(nu + p + 1, sizeof(double)), et_size_array(nv + q + 1, sizeof(double)),
                    et_size_array(n, sizeof(et_vec3)), rational ? et_size_array(n, sizeof(double)) : NULL};
    if (!t.u || !t.v || !t.points || (rational && !t.weights)) {
        et_surface_free(&t);
        return ET_ENOMEM;
    }
    //@ assert made: et_numbers(t.u, nu + p + 1) && et_numbers(t.v, nv + q + 1) && et_numbers((double *)t.points, 3 * n);
    //@ assert fits: (nu + p + 1) * sizeof(double) <= SIZE_MAX && (nv + q + 1) * sizeof(double) <= SIZE_MAX && n * sizeof(et_vec3) <= SIZE_MAX;
    //@ assert room: rational != 0 ==> et_numbers(t.weights, n);
    /*@ loop invariant place: i <= n;
        loop invariant ones:  rational != 0 ==> \forall integer k; 0 <= k < i ==> t.weights[k] == 1.0;
        loop assigns i, t.weights[0 .. n - 1];
        loop variant n - i;
    */
    for (size_t i = 0; rational && i < n; i++) {
        t.weights[i] = 1.0;
    }
    *s = t;
    return ET_OK;
}

et_status et_surface_copy(et_surface *copy, const et_surface *s)
{
    et_surface t;
    et_status status = et_surface_new(&t, s->p, s->q, s->nu, s->nv, s->weights != NULL);
    if (status != ET_OK) {
        return status;
    }
    //@ assert sizes: s->nu * s->nv * sizeof(et_vec3) <= SIZE_MAX && s->nu > s->p && s->nv > s->q && s->nu * s->nv >= 0;
    size_t n = s->nu * s->nv;
    /*@ assert fresh: \separated(t.u + (0 .. s->nu + s->p), s->u + (0 .. s->nu + s->p)) &&
                      \separated(t.v + (0 .. s->nv + s->q), s->v + (0 .. s->nv + s->q)) &&
                      \separated(t.points + (0 .. s->nu * s->nv - 1), s->points + (0 .. s->nu * s->nv - 1)) &&
                      (s->weights == \null || \separated(t.weights + (0 .. s->nu * s->nv - 1), s->weights + (0 .. s->nu * s->nv - 1))); */
    /*@ assert stored: et_numbers(t.u, s->nu + s->p + 1) && et_numbers(t.v, s->nv + s->q + 1) && et_numbers((double *)t.points, 3 * n) &&
                       t.u != s->u && t.v != s->v && t.points != s->points; */
    memcpy(t.u, s->u, (s->nu + s->p + 1) * sizeof *t.u);
    memcpy(t.v, s->v, (s->nv + s->q + 1) * sizeof *t.v);
    memcpy(t.points, s->points, n * sizeof *t.points);
    if (s->weights) {
        memcpy(t.weights, s->weights, n * sizeof *t.weights);
    }
    //@ ghost size_t nu = s->nu, nv = s->nv, p = s->p, q = s->q;
    *copy = t;
    //@ assert kept:  s->nu == nu && s->nv == nv && s->p == p && s->q == q;
    return ET_OK;
}

void et_surface_free(et_surface *s)
{
    free(s->u);
    free(s->v);
    free(s->points);
    free(s->weights);
    *s = (et_surface){0, 0, 0, 0, NULL, NULL, NULL, NULL};
}

/* ---- one point ---- */

/* The workspace in doubles: three rows of basis values a direction, three of column sums, the basis' own room. */
typedef struct {
    double *N, *M, *basis;
    surface_point *T;
    size_t nbasis;
} room;

/*@ assigns \nothing;
    ensures value: \result == \max(a, b);
*/
static size_t greater(size_t a, size_t b)
{
    return a > b ? a : b;
}

/*@ requires s:    \valid_read(s);
    assigns  \nothing;
    ensures  fits: s->p <= SIZE_MAX - 5 && s->q <= SIZE_MAX - 5 && (s->p + 1)*(s->p + 5) <= SIZE_MAX && (s->q + 1)*(s->q + 5) <= SIZE_MAX
                       ==> \result == \max((s->p + 1)*(s->p + 5), (s->q + 1)*(s->q + 5));
    ensures  room: \result >= \max((s->p + 1)*(s->p + 5), (s->q + 1)*(s->q + 5)) || \result == SIZE_MAX;
*/
static size_t basis_work(const et_surface *s)
{
    return greater(et_basis_work(s->p, 2), et_basis_work(s->q, 2));
}

size_t et_surface_work(const et_surface *s)
{
    const size_t sums = 3 * (s->p + 1) + 15 * (s->q + 1), basis = basis_work(s);
    return basis > SIZE_MAX - sums ? SIZE_MAX : sums + basis;
}

/*@ requires s:     \valid_read(s);
    requires room:  et_surface_room((et_surface *)s) <= SIZE_MAX && \valid(work + (0 .. et_surface_room((et_surface *)s) - 1));
    assigns  \nothing;
    ensures  rows:  \result.N == work && \result.M == work + 3*(s->p + 1) && \result.basis == work + 3*(s->p + 1) + 15*(s->q + 1);
    ensures  small: 3*(s->p + 1) + 15*(s->q + 1) <= SIZE_MAX;
    ensures  valid: \valid(\result.N + (0 .. 3*(s->p + 1) - 1)) && \valid(\result.M + (0 .. 3*(s->q + 1) - 1));
    ensures  sums:  \result.T == (surface_point *)(work + 3*(s->p + 1) + 3*(s->q + 1)) && \valid(\result.T + (0 .. 3*(s->q + 1) - 1));
    ensures  basis: 2*(s->p + 1) <= \result.nbasis && 2*(s->q + 1) <= \result.nbasis && \valid(\result.basis + (0 .. \result.nbasis - 1));
    ensures  ders:  \result.nbasis == \max((s->p + 1)*(s->p + 5), (s->q + 1)*(s->q + 5));
*/
static room divide(const et_surface *s, double *work)
{
    //@ ghost fact_product(2, s->p + 5, s->p + 1);
    //@ ghost fact_product(2, s->q + 5, s->q + 1);
    double *T = work + 3 * (s->p + 1) + 3 * (s->q + 1);
    return (room){work, work + 3 * (s->p + 1), T + 12 * (s->q + 1), (surface_point *)T, basis_work(s)};
}

/*@ predicate untouched(double *a, integer m, double *b, integer n, double *t, integer last) =
        \separated(a + (0 .. m - 1), t + (0 .. last)) && \separated(b + (0 .. n - 1), t + (0 .. last));
*/

/* The span of x, among n functions, and the values there of those that are not zero. */
/*@ requires count: p < n && n + p < SIZE_MAX && \is_finite(x);
    requires knots: \valid_read(u + (0 .. n + p)) && et_surface_domain((double *)u, n + p, p);
    requires room:  2*(p + 1) <= nbasis && \valid(N + (0 .. p)) && \valid(basis + (0 .. nbasis - 1));
    requires apart: \separated(N + (0 .. p), u + (0 .. n + p), basis + (0 .. nbasis - 1));
    assigns  N[0 .. p], basis[0 .. nbasis - 1];
    ensures  range: p <= \result < n;
    ensures  kept:  \forall double *t, integer last, integer degree; 0 <= degree <= last && untouched(N, p + 1, basis, nbasis, t, last) &&
                        \at(et_surface_domain(t, last, degree), Pre) ==> et_surface_domain(t, last, degree);
*/
static size_t values(double *N, const double *u, size_t n, size_t p, double x, double *basis, size_t nbasis)
{
    size_t span = et_knots_span(u, n + p + 1, p, x);
    et_basis_eval(N, u, n + p + 1, p, span, x, basis, nbasis);
    /*@ assert equal:  \forall double *t, integer last, integer i; untouched(N, p + 1, basis, nbasis, t, last) && 0 <= i <= last ==>
                           t[i] == \at(t[i], Pre); */
    /*@ assert finite: \forall double *t, integer last; 0 <= last && untouched(N, p + 1, basis, nbasis, t, last) &&
                           \at(et_surface_finite(t, last), Pre) ==> et_surface_finite(t, last); */
    /*@ assert rising: \forall double *t, integer last; 0 <= last && untouched(N, p + 1, basis, nbasis, t, last) &&
                           \at(et_surface_rising(t, last), Pre) ==> et_surface_rising(t, last); */
    /*@ assert ends:   \forall double *t, integer last, integer degree; 0 <= degree <= last && untouched(N, p + 1, basis, nbasis, t, last) ==>
                           (\at(t[degree] < t[last - degree], Pre) ==> t[degree] < t[last - degree]); */
    /*@ assert both:   \forall double *t, integer last; 0 <= last && untouched(N, p + 1, basis, nbasis, t, last) ==>
                           t[last] == \at(t[last], Pre) && t[0] == \at(t[0], Pre); */
    /*@ assert width:  \forall double *t, integer last; 0 <= last && untouched(N, p + 1, basis, nbasis, t, last) &&
                           \at(et_surface_width(t, last), Pre) ==> et_surface_width(t, last); */
    /*@ assert spread: \forall double *t, integer last; 0 <= last && untouched(N, p + 1, basis, nbasis, t, last) &&
                           \at(et_surface_spread(t, last), Pre) ==> et_surface_spread(t, last); */
    return span;
}

et_vec3 et_surface_point(const et_surface *s, double u, double v, double *work, size_t nwork)
{
    room r = divide(s, work);
    (void)nwork;
    size_t i = values(r.N, s->u, s->nu, s->p, u, r.basis, r.nbasis);
    size_t j = values(r.M, s->v, s->nv, s->q, v, r.basis, r.nbasis);
    surface_contract_u(r.T, s->q + 1, r.N, s, surface_first(s, i, j));
    return surface_project(surface_contract_v(r.T, r.M, s->q), s->weights != NULL);
}

/* (A - a S) with the homogeneous derivative A and a number a. */
/*@ assigns \nothing; */
static et_vec3 less(et_vec3 A, double a, et_vec3 S)
{
    return (et_vec3){A.x - a * S.x, A.y - a * S.y, A.z - a * S.z};
}

/*@ assigns \nothing; */
static et_vec3 over(et_vec3 A, double w)
{
    return (et_vec3){A.x / w, A.y / w, A.z / w};
}

/* Eq. 4.20: from the homogeneous derivatives A, in the order of D, to those of the quotient. */
/*@ requires D:     \valid(D + (0 .. 5)) && \valid_read(A + (0 .. 5));
    assigns  D[0 .. 5];
*/
static void quotient(et_vec3 D[6], const surface_point A[6])
{
    et_vec3 B[6];
    /*@ loop invariant place: k <= 6;
        loop assigns k, B[0 .. 5];
        loop variant 6 - k;
    */
    for (size_t k = 0; k < 6; k++) {
        B[k] = (et_vec3){A[k].x, A[k].y, A[k].z};
    }
    double w = A[0].w, wu = A[1].w, wv = A[2].w;
    D[0] = over(B[0], w);
    D[1] = over(less(B[1], wu, D[0]), w);
    D[2] = over(less(B[2], wv, D[0]), w);
    D[3] = over(less(less(B[3], 2.0 * wu, D[1]), A[3].w, D[0]), w);
    D[4] = over(less(less(less(B[4], wu, D[2]), wv, D[1]), A[4].w, D[0]), w);
    D[5] = over(less(less(B[5], 2.0 * wv, D[2]), A[5].w, D[0]), w);
}

/* As values(), with two rows of derivatives. */
/*@ requires count: p < n && n + p < SIZE_MAX && \is_finite(x);
    requires knots: \valid_read(u + (0 .. n + p)) && et_surface_domain((double *)u, n + p, p);
    requires room:  3*(p + 1) <= SIZE_MAX && (p + 1)*(p + 5) <= nbasis && \valid(N + (0 .. 3*(p + 1) - 1)) && \valid(basis + (0 .. nbasis - 1));
    requires apart: \separated(N + (0 .. 3*(p + 1) - 1), u + (0 .. n + p), basis + (0 .. nbasis - 1));
    assigns  N[0 .. 3*(p + 1) - 1], basis[0 .. nbasis - 1];
    ensures  range: p <= \result < n;
    ensures  kept:  \forall double *t, integer last, integer degree; 0 <= degree <= last && untouched(N, 3*(p + 1), basis, nbasis, t, last) &&
                        \at(et_surface_domain(t, last, degree), Pre) ==> et_surface_domain(t, last, degree);
*/
static size_t derivatives(double *N, const double *u, size_t n, size_t p, double x, double *basis, size_t nbasis)
{
    size_t span = et_knots_span(u, n + p + 1, p, x);
    et_basis_ders(N, 2, u, n + p + 1, p, span, x, basis, nbasis);
    /*@ assert equal:  \forall double *t, integer last, integer i; untouched(N, 3*(p + 1), basis, nbasis, t, last) && 0 <= i <= last ==>
                           t[i] == \at(t[i], Pre); */
    /*@ assert finite: \forall double *t, integer last; 0 <= last && untouched(N, 3*(p + 1), basis, nbasis, t, last) &&
                           \at(et_surface_finite(t, last), Pre) ==> et_surface_finite(t, last); */
    /*@ assert rising: \forall double *t, integer last; 0 <= last && untouched(N, 3*(p + 1), basis, nbasis, t, last) &&
                           \at(et_surface_rising(t, last), Pre) ==> et_surface_rising(t, last); */
    /*@ assert ends:   \forall double *t, integer last, integer degree; 0 <= degree <= last && untouched(N, 3*(p + 1), basis, nbasis, t, last) ==>
                           (\at(t[degree] < t[last - degree], Pre) ==> t[degree] < t[last - degree]); */
    /*@ assert both:   \forall double *t, integer last; 0 <= last && untouched(N, 3*(p + 1), basis, nbasis, t, last) ==>
                           t[last] == \at(t[last], Pre) && t[0] == \at(t[0], Pre); */
    /*@ assert width:  \forall double *t, integer last; 0 <= last && untouched(N, 3*(p + 1), basis, nbasis, t, last) &&
                           \at(et_surface_width(t, last), Pre) ==> et_surface_width(t, last); */
    /*@ assert spread: \forall double *t, integer last; 0 <= last && untouched(N, 3*(p + 1), basis, nbasis, t, last) &&
                           \at(et_surface_spread(t, last), Pre) ==> et_surface_spread(t, last); */
    return span;
}

void et_surface_ders(et_vec3 D[6], const et_surface *s, double u, double v, double *work, size_t nwork)
{
    static const size_t du[6] = {0, 1, 0, 2, 1, 0}, dv[6] = {0, 0, 1, 0, 1, 2};
    size_t n = s->q + 1;
    surface_point A[6];
    room r = divide(s, work);
    (void)nwork;
    size_t i = derivatives(r.N, s->u, s->nu, s->p, u, r.basis, r.nbasis);
    size_t j = derivatives(r.M, s->v, s->nv, s->q, v, r.basis, r.nbasis);
    size_t first = surface_first(s, i, j);
    /*@ loop invariant place: k <= 3;
        loop assigns k, work[0 .. nwork - 1];
        loop variant 3 - k;
    */
    for (size_t k = 0; k < 3; k++) {
        //@ ghost fact_product(k, 2, n);
        //@ ghost fact_product(k, 2, s->p + 1);
        //@ ghost fact_product(0, k, s->p + 1);
        surface_contract_u(r.T + k * n, n, r.N + k * (s->p + 1), s, first);
    }
    /*@ loop invariant place: k <= 6;
        loop assigns k, A[0 .. 5];
        loop variant 6 - k;
    */
    for (size_t k = 0; k < 6; k++) {
        //@ assert which: (du[k] == 0 || du[k] == 1 || du[k] == 2) && (dv[k] == 0 || dv[k] == 1 || dv[k] == 2);
        //@ ghost fact_product(du[k], 2, n);
        //@ ghost fact_product(dv[k], 2, n);
        A[k] = surface_contract_v(r.T + du[k] * n, r.M + dv[k] * n, s->q);
    }
    if (s->weights) {
        quotient(D, A);
        return;
    }
    /*@ loop invariant place: k <= 6;
        loop assigns k, D[0 .. 5];
        loop variant 6 - k;
    */
    for (size_t k = 0; k < 6; k++) {
        D[k] = surface_project(A[k], 0);
    }
}

/* ---- many points ---- */

enum { CELLS = 512, BLOCK = 32 };

/* The span of many parameters: the domain is cut into equal cells; first[c] is a span that begins before every parameter of cell c. */
typedef struct {
    const double *u;
    size_t nu, p, last;
    double lo, hi, inverse;
    int tabled;
    uint16_t first[CELLS];
} finder;

/* Never decreasing in x, because each operation rounds monotonically: so knots of earlier cells lie before x. */
static int cell(const finder *f, double x)
{
    int c = (int)((x - f->lo) * f->inverse);
    return c < CELLS ? c : CELLS - 1;
}

static void finder_init(finder *f, const double *u, size_t nu, size_t p, size_t n)
{
    f->u = u;
    f->nu = nu;
    f->p = p;
    f->lo = u[p];
    f->hi = u[nu - p - 1];
    f->last = et_knots_span(u, nu, p, f->hi);
    f->inverse = CELLS / (f->hi - f->lo);
    f->tabled = n >= CELLS && nu <= UINT16_MAX && isfinite(f->inverse);
    size_t k = p;
    for (int c = 0; f->tabled && c < CELLS; c++) {
        while (k < f->last && cell(f, u[k + 1]) < c) {
            k++;
        }
        f->first[c] = (uint16_t)k;
    }
}

/* The cubic functions of BLOCK parameters at once: knot distances, and values N[r][k] of the r-th function at the k-th parameter. */
typedef struct {
    size_t span[BLOCK];
    double L1[BLOCK], L2[BLOCK], L3[BLOCK], R1[BLOCK], R2[BLOCK], R3[BLOCK];
    double N[4][BLOCK];
    int ends;
} cubics;

static double clamp(double x, double lo, double hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

/* The spans of BLOCK parameters of the domain: et_knots_span for each, from the cells where there is a table. */
static void spans(size_t *restrict span, const finder *restrict f, const double *restrict t)
{
    int c[BLOCK];
    for (size_t k = 0; !f->tabled && k < BLOCK; k++) {
        span[k] = et_knots_span(f->u, f->nu, f->p, t[k]);
    }
    if (!f->tabled) {
        return;
    }
    for (size_t k = 0; k < BLOCK; k++) {
        c[k] = cell(f, t[k]);
    }
    for (size_t k = 0; k < BLOCK; k++) {
        size_t i = f->first[c[k]];
        while (f->u[i + 1] <= t[k] && i < f->last) {
            i++;
        }
        span[k] = i;
    }
}

/* Parameters 0..n-1; the rest of the block repeats the last. */
static void cubics_distances(cubics *restrict c, const finder *restrict f, const double *restrict x, size_t n)
{
    double t[BLOCK];
    for (size_t k = 0; k < BLOCK; k++) {
        t[k] = x[k < n ? k : n - 1];
    }
    for (size_t k = 0; k < BLOCK; k++) {
        t[k] = clamp(t[k], f->lo, f->hi);
    }
    spans(c->span, f, t);
    c->ends = 0;
    for (size_t k = 0; k < BLOCK; k++) {
        const double *u = f->u + c->span[k];
        double L3 = t[k] - u[-2], R3 = u[3] - t[k];
        c->L1[k] = t[k] - u[0];
        c->L2[k] = t[k] - u[-1];
        c->L3[k] = L3;
        c->R1[k] = u[1] - t[k] + 0.0;         /* no -0: et_basis_eval adds this function's value to 0 */
        c->R2[k] = u[2] - t[k];
        c->R3[k] = R3;
        c->ends |= (L3 == 0.0) | (R3 == 0.0);
    }
}

/* The operations of et_basis_eval in their order, so its bits; written so that a compiler may take several parameters at a time. */
static void cubics_values(cubics *c)
{
    for (size_t k = 0; k < BLOCK; k++) {
        double L1 = c->L1[k], L2 = c->L2[k], L3 = c->L3[k], R1 = c->R1[k], R2 = c->R2[k], R3 = c->R3[k];
        double a = 1.0 / (R1 + L1);
        double n0 = R1 * a, n1 = L1 * a;
        a = n0 / (R1 + L2);
        double b = n1 / (R2 + L1);
        n0 = R1 * a;
        n1 = L2 * a + R2 * b;
        double n2 = L1 * b;
        a = n0 / (R1 + L3);
        b = n1 / (R2 + L2);
        double d = n2 / (R3 + L1);
        c->N[0][k] = R1 * a;
        c->N[1][k] = L3 * a + R2 * b;
        c->N[2][k] = L2 * b + R3 * d;
        c->N[3][k] = L1 * d;
    }
    for (size_t k = 0; c->ends && k < BLOCK; k++) {
        for (size_t r = 0; r < 4 && (c->L3[k] == 0.0 || c->R3[k] == 0.0); r++) {
            c->N[r][k] = r == (c->L3[k] == 0.0 ? 0u : 3u) ? 1.0 : 0.0;
        }
    }
}

/* What contract_u and contract_v do for 4 x 4 polynomial terms, in two passes over a block, so that a compiler may take several coordinates at a
 * time: the twelve coordinates of a row of the net lie side by side. */
typedef struct { double T[BLOCK][12]; } bicubics;

static void bicubics_columns(bicubics *restrict b, const et_vec3 *restrict net, size_t nv, const cubics *restrict u, const cubics *restrict v)
{
    size_t step = 3 * nv;
    for (size_t k = 0; k < BLOCK; k++) {
        const double *P = &net[(u->span[k] - 3) * nv + v->span[k] - 3].x;
        double N0 = u->N[0][k], N1 = u->N[1][k], N2 = u->N[2][k], N3 = u->N[3][k];
        for (size_t c = 0; c < 12; c++) {
            b->T[k][c] = N0 * P[c] + N1 * P[step + c] + N2 * P[2 * step + c] + N3 * P[3 * step + c];
        }
    }
}

static void bicubics_sums(et_vec3 *restrict S, const bicubics *restrict b, const cubics *restrict v, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const double *T = b->T[k];
        double M0 = v->N[0][k], M1 = v->N[1][k], M2 = v->N[2][k], M3 = v->N[3][k];
        S[k] = (et_vec3){M0 * T[0] + M1 * T[3] + M2 * T[6] + M3 * T[9], M0 * T[1] + M1 * T[4] + M2 * T[7] + M3 * T[10],
                         M0 * T[2] + M1 * T[5] + M2 * T[8] + M3 * T[11]};
    }
}

static void points_bicubic(et_vec3 *S, const et_surface *s, const finder *fu, const finder *fv, const double *u, const double *v, size_t n)
{
    cubics cu, cv;
    bicubics b;
    for (size_t from = 0; from < n; from += BLOCK) {
        size_t m = n - from < BLOCK ? n - from : BLOCK;
        cubics_distances(&cu, fu, u + from, m);
        cubics_distances(&cv, fv, v + from, m);
        cubics_values(&cu);
        cubics_values(&cv);
        bicubics_columns(&b, s->points, s->nv, &cu, &cv);
        bicubics_sums(S + from, &b, &cv, m);
    }
}

void et_surface_points(et_vec3 *S, const et_surface *s, const double *u, const double *v, size_t n, double *work, size_t nwork)
{
    finder fu, fv;
    if (n >= BLOCK && s->p == 3 && s->q == 3 && !s->weights) {
        finder_init(&fu, s->u, s->nu + 4, 3, n);
        finder_init(&fv, s->v, s->nv + 4, 3, n);
        points_bicubic(S, s, &fu, &fv, u, v, n);
        return;
    }
    for (size_t k = 0; k < n; k++) {
        S[k] = et_surface_point(s, u[k], v[k], work, nwork);
    }
}

/* Basis values and spans of the parameters b, and room for the sums of one line. */
typedef struct {
    double *M, *N, *basis;
    size_t *span;
    surface_point *T;
    size_t lo, hi, nbasis;                /* columns lo .. hi-1 of the net are met */
} lines;

static void lines_free(lines *l)
{
    free(l->M);
    free(l->N);
    free(l->basis);
    free(l->span);
    free(l->T);
}

static et_status lines_new(lines *l, const et_surface *s, const double *b, size_t nb)
{
    size_t n = s->q + 1;
    *l = (lines){.lo = s->nv, .nbasis = basis_work(s)};
    if (et_size_mul(&n, n, sizeof(double)) != ET_OK) {
        return ET_ENOMEM;
    }
    l->M = et_size_array(nb, n);
    l->N = et_size_array(s->p + 1, sizeof(double));
    l->basis = et_size_array(l->nbasis, sizeof(double));
    l->span = et_size_array(nb, sizeof(size_t));
    l->T = et_size_array(s->nv, sizeof(surface_point));
    if (!l->M || !l->N || !l->basis || !l->span || !l->T) {
        lines_free(l);
        return ET_ENOMEM;
    }
    for (size_t j = 0; j < nb; j++) {
        size_t k = et_knots_span(s->v, s->nv + s->q + 1, s->q, b[j]);
        et_basis_eval(l->M + j * (s->q + 1), s->v, s->nv + s->q + 1, s->q, k, b[j], l->basis, l->nbasis);
        l->span[j] = k - s->q;
        l->lo = k - s->q < l->lo ? k - s->q : l->lo;
        l->hi = k + 1 > l->hi ? k + 1 : l->hi;
    }
    return ET_OK;
}

/* contract_v for each b, unrolled for cubics. */
static void line_cubic(et_vec3 *S, const lines *l, size_t nb)
{
    for (size_t j = 0; j < nb; j++) {
        const double *M = l->M + 4 * j, *T = &l->T[l->span[j]].x;
        double t[4];
        for (size_t c = 0; c < 4; c++) {
            t[c] = M[0] * T[c] + M[1] * T[c + 4] + M[2] * T[c + 8] + M[3] * T[c + 12];
        }
        S[j] = (et_vec3){t[0], t[1], t[2]};
    }
}

et_status et_surface_grid(et_vec3 *S, const et_surface *s, const double *a, size_t na, const double *b, size_t nb)
{
    lines l;
    if (lines_new(&l, s, b, nb) != ET_OK) {
        return ET_ENOMEM;
    }
    for (size_t i = 0; i < na && nb > 0; i++) {
        size_t k = et_knots_span(s->u, s->nu + s->p + 1, s->p, a[i]);
        et_basis_eval(l.N, s->u, s->nu + s->p + 1, s->p, k, a[i], l.basis, l.nbasis);
        surface_contract_u(l.T + l.lo, l.hi - l.lo, l.N, s, (k - s->p) * s->nv + l.lo);
        if (s->q == 3 && !s->weights) {
            line_cubic(S + i * nb, &l, nb);
            continue;
        }
        for (size_t j = 0; j < nb; j++) {
            S[i * nb + j] = surface_project(surface_contract_v(l.T + l.span[j], l.M + j * (s->q + 1), s->q), s->weights != NULL);
        }
    }
    lines_free(&l);
    return ET_OK;
}
