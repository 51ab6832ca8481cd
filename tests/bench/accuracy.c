/* accuracy CASES [DEGREE...]: the proved bounds of basis functions and surface points beside the worst error seen, as a table in Markdown.
 *
 * Half of the cases are drawn: uniform, graded, repeated and almost equal knots; parameters inside, at the ends and one ulp beside them.  The other half
 * are adversarial: the worst case so far of each quantity with something altered by a few ulps.  The reference is double-double: sums and products of
 * numbers that are exact or positive, relative error below 100 (p + q + 1) 2^-106, which is below 2^-40 u here; each worst case is computed
 * again by the exact layer, whose doubles must be the reference's.  Own seed: the same table on every machine. */
#include "etalon/base/dd.h"
#include "etalon/base/rng.h"
#include "etalon/exact/exact.h"
#include "etalon/spline/basis.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 10, KNOTS = 2 * MOST + 2, NET = (MOST + 1) * (MOST + 1) };
enum { VALUE, SUM, FIRST, SECOND, POINT, RATIONAL, QUANTITIES };
static const char *const titles[QUANTITIES] = { "basis value", "sum of basis values", "first derivative", "second derivative", "surface point",
                                                "rational surface point" };

/* One span of knots a direction, x in it, and a net for a surface of that span. */
typedef struct {
    double u[KNOTS], v[KNOTS], x, y;
    et_vec3 P[NET];
    double w[NET];
} problem;
typedef struct { double error; problem at; } worst;

/* The double nearest to what each quantity has been proved to stay below, in units of u (first order). */
static double bound(int quantity, size_t p)
{
    const double m = 7.0 * (double)(p + p), d = (double)p;
    const double bounds[QUANTITIES] = { 6 * d - 1, 4 * d - 1, 6 * d + 2, 6 * d + 2, m, 2 * m + 2 };

    return bounds[quantity];
}

/* ---- drawing ------------------------------------------------------------------------------------------------------------- */

static double stepped(double x, et_rng *rng)
{
    const size_t n = 1 + et_rng_index(rng, 3);
    const double to = et_rng_index(rng, 2) ? INFINITY : -INFINITY;

    for (size_t k = 0; k < n; k++)
        x = nextafter(x, to);
    return x;
}

static int rising(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void draw_knots(double *u, size_t p, et_rng *rng)
{
    const size_t kind = et_rng_index(rng, 4), n = 2 * p + 2;

    for (size_t k = 0; k < n; k++)
        u[k] = kind == 1 ? ldexp(et_rng_uniform(rng), -(int)et_rng_index(rng, 40)) : et_rng_uniform(rng);
    qsort(u, n, sizeof *u, rising);
    for (size_t k = 1; k < n && kind >= 2; k++)
        if (k != p + 1 && et_rng_index(rng, 2))
            u[k] = kind == 2 ? u[k - 1] : fmin(nextafter(u[k - 1], 2), k < p + 1 ? u[p + 1] : 2);
    qsort(u, n, sizeof *u, rising);
}

static double draw_parameter(const double *u, size_t p, et_rng *rng)
{
    const size_t kind = et_rng_index(rng, 8);
    const double a = u[p], b = u[p + 1];

    return kind == 0 ? nextafter(a, b) : kind == 1 ? nextafter(b, a) : kind == 2 ? a : a + (b - a) * et_rng_uniform(rng);
}

static void draw(problem *c, size_t p, et_rng *rng)
{
    do {
        draw_knots(c->u, p, rng);
        draw_knots(c->v, p, rng);
    } while (!(c->u[p] < c->u[p + 1] && c->v[p] < c->v[p + 1]));
    c->x = draw_parameter(c->u, p, rng);
    c->y = draw_parameter(c->v, p, rng);
    for (size_t k = 0; k < (p + 1) * (p + 1); k++) {
        c->P[k].x = 2 * et_rng_uniform(rng) - 1;
        c->P[k].y = et_rng_uniform(rng);
        c->P[k].z = ldexp(et_rng_uniform(rng), -(int)et_rng_index(rng, 30));
        c->w[k] = ldexp(1 + et_rng_uniform(rng), (int)et_rng_index(rng, 9) - 4);
    }
}

/* A few ulps here and there. */
static void alter(problem *c, size_t p, et_rng *rng)
{
    for (size_t times = 1 + et_rng_index(rng, 3); times > 0; times--) {
        const size_t k = et_rng_index(rng, 2 * p + 2), m = et_rng_index(rng, (p + 1) * (p + 1));
        switch (et_rng_index(rng, 7)) {
        case 0: c->x = stepped(c->x, rng); break;
        case 1: c->y = stepped(c->y, rng); break;
        case 2: c->u[k] = stepped(c->u[k], rng); break;
        case 3: c->v[k] = stepped(c->v[k], rng); break;
        case 4: c->P[m].x = stepped(c->P[m].x, rng); break;
        case 5: c->P[m].x = 2 * et_rng_uniform(rng) - 1; break;
        default: c->w[m] = stepped(c->w[m], rng); break;
        }
    }
}

static int sound(const double *u, size_t p, double x)
{
    for (size_t k = 1; k < 2 * p + 2; k++)
        if (u[k - 1] > u[k])
            return 0;
    return u[p] < u[p + 1] && u[p] <= x && x <= u[p + 1];
}

/* ---- the reference --------------------------------------------------------------------------------------------------------- */

static et_dd of(double x)
{
    const et_dd d = { x, 0 };
    return d;
}

/* a/b c for a, b exact differences of doubles; 0/0 = 0. */
static et_dd part(double a1, double a0, double b1, double b0, et_dd c)
{
    return b1 == b0 || a1 == a0 ? of(0) : et_dd_mul(et_dd_div(et_dd_two_sum(a1, -a0), et_dd_two_sum(b1, -b0)), c);
}

/* N[0..q] of degree q at x in the span (u[p], u[p+1]): the functions i = p-q .. p. */
static void reference_basis(et_dd *N, const double *u, size_t p, size_t q, double x)
{
    memset(N, 0, (q + 1) * sizeof *N);
    N[0] = of(1);
    for (size_t d = 1; d <= q; d++)
        for (size_t k = d + 1; k-- > 0;) {
            const size_t i = p - d + k;        /* N_{i,d} of N_{i,d-1} at k-1 and N_{i+1,d-1} at k */
            et_dd left = k > 0 ? part(x, u[i], u[i + d], u[i], N[k - 1]) : of(0);
            const et_dd right = k < d ? part(u[i + d + 1], x, u[i + d + 1], u[i + 1], N[k]) : of(0);
            N[k] = et_dd_add(left, right);
        }
}

/* The k-th derivatives, and the sums of the magnitudes of their terms (one formula, with the sign and without). */
static void reference_ders(et_dd *D, et_dd *M, const double *u, size_t p, size_t k, double x)
{
    reference_basis(D, u, p, p - k, x);
    memcpy(M, D, (p - k + 1) * sizeof *M);
    for (size_t d = p - k + 1; d <= p; d++)
        for (size_t j = d + 1; j-- > 0;) {
            const size_t i = p - d + j;
            const et_dd f = of((double)d);
            const et_dd a = j > 0 ? et_dd_two_sum(u[i + d], -u[i]) : of(0), b = j < d ? et_dd_two_sum(u[i + d + 1], -u[i + 1]) : of(0);
            const et_dd left = j > 0 ? et_dd_mul(f, et_dd_div(D[j - 1], a)) : of(0), right = j < d ? et_dd_mul(f, et_dd_div(D[j], b)) : of(0);
            const et_dd up = j > 0 ? et_dd_mul(f, et_dd_div(M[j - 1], a)) : of(0), down = j < d ? et_dd_mul(f, et_dd_div(M[j], b)) : of(0);
            D[j] = et_dd_sub(left, right);
            M[j] = et_dd_add(up, down);
        }
}

/* ---- errors, in units of u -------------------------------------------------------------------------------------------------- */

static double off(double got, et_dd want, double scale)
{
    return scale > 0 ? fabs(((got - want.hi) - want.lo) / scale) * 0x1p53 : 0;
}

static void basis_errors(double *errors, const problem *c, size_t p, const et_dd *N)
{
    double got[MOST + 1], D[3 * (MOST + 1)], work[(MOST + 1) * (MOST + 5)];
    et_dd sum = of(0);

    et_basis_eval(got, c->u, 2 * p + 2, p, p, c->x, work, sizeof work / sizeof *work);
    for (size_t k = 0; k <= p; k++) {
        errors[VALUE] = fmax(errors[VALUE], off(got[k], N[k], N[k].hi));
        sum = et_dd_add(sum, of(got[k]));
    }
    errors[SUM] = off(1, sum, 1);
    et_basis_ders(D, 2, c->u, 2 * p + 2, p, p, c->x, work, sizeof work / sizeof *work);
    for (size_t k = 1; k <= 2 && k <= p; k++) {
        et_dd E[MOST + 1], M[MOST + 1];
        reference_ders(E, M, c->u, p, k, c->x);
        for (size_t j = 0; j <= p; j++)
            errors[FIRST + k - 1] = fmax(errors[FIRST + k - 1], off(D[k * (p + 1) + j], E[j], M[j].hi));
    }
}

/* The first coordinate; all three are computed alike. */
static void point_errors(double *errors, const problem *c, size_t p, const et_dd *N, const et_dd *M)
{
    double work[256 + (MOST + 1) * (MOST + 5)];
    et_surface s = { p, p, p + 1, p + 1, (double *)c->u, (double *)c->v, (et_vec3 *)c->P, NULL };
    et_dd S = of(0), A = of(0), R = of(0), B = of(0), W = of(0);

    for (size_t i = 0; i <= p; i++)
        for (size_t j = 0; j <= p; j++) {
            const size_t k = i * (p + 1) + j;
            const et_dd n = et_dd_mul(N[i], M[j]), nw = et_dd_mul(n, of(c->w[k]));
            S = et_dd_add(S, et_dd_mul(n, of(c->P[k].x)));
            A = et_dd_add(A, et_dd_mul(n, of(fabs(c->P[k].x))));
            R = et_dd_add(R, et_dd_mul(nw, of(c->P[k].x)));
            B = et_dd_add(B, et_dd_mul(nw, of(fabs(c->P[k].x))));
            W = et_dd_add(W, nw);
        }
    errors[POINT] = off(et_surface_point(&s, c->x, c->y, work, sizeof work / sizeof *work).x, S, A.hi);
    s.weights = (double *)c->w;
    errors[RATIONAL] = off(et_surface_point(&s, c->x, c->y, work, sizeof work / sizeof *work).x, et_dd_div(R, W), et_dd_div(B, W).hi);
}

static void measure(double *errors, const problem *c, size_t p)
{
    et_dd N[MOST + 1], M[MOST + 1];

    memset(errors, 0, QUANTITIES * sizeof *errors);
    reference_basis(N, c->u, p, p, c->x);
    reference_basis(M, c->v, p, p, c->y);
    basis_errors(errors, c, p, N);
    point_errors(errors, c, p, N, M);
}

/* The exact layer's doubles are the reference's. */
static int confirmed(const problem *c, size_t p)
{
    double exact[MOST + 1];
    et_dd N[MOST + 1], M[MOST + 1], S = of(0);
    et_vec3 point;
    const et_surface s = { p, p, p + 1, p + 1, (double *)c->u, (double *)c->v, (et_vec3 *)c->P, NULL };

    reference_basis(N, c->u, p, p, c->x);
    reference_basis(M, c->v, p, p, c->y);
    if (et_exact_basis_eval(exact, c->u, 2 * p + 2, p, p, c->x) != ET_OK || et_exact_surface_point(&point, &s, c->x, c->y) != ET_OK)
        return 0;
    for (size_t i = 0; i <= p; i++) {
        if (exact[i] != N[i].hi)
            return 0;
        for (size_t j = 0; j <= p; j++)
            S = et_dd_add(S, et_dd_mul(et_dd_mul(N[i], M[j]), of(c->P[i * (p + 1) + j].x)));
    }
    return point.x == S.hi || fabs(point.x - S.hi) <= 0x1p-90;       /* a sum that cancels is known absolutely */
}

/* ---- the search -------------------------------------------------------------------------------------------------------------- */

static int search(worst *found, size_t p, unsigned long long cases, et_rng *rng)
{
    for (unsigned long long k = 0; k < cases; k++) {
        double errors[QUANTITIES];
        problem c;

        if (k % 2 == 0 || k < 100) {
            draw(&c, p, rng);
        } else {
            c = found[et_rng_index(rng, QUANTITIES)].at;
            alter(&c, p, rng);
            if (!sound(c.u, p, c.x) || !sound(c.v, p, c.y))
                continue;
        }
        measure(errors, &c, p);
        for (int q = 0; q < QUANTITIES; q++)
            if (errors[q] > found[q].error || k == 0) {
                found[q].error = errors[q];
                found[q].at = c;
            }
    }
    for (int q = 0; q < QUANTITIES; q++)
        if (!confirmed(&found[q].at, p)) {
            fprintf(stderr, "accuracy: degree %zu, %s: the exact layer does not confirm the reference\n", p, titles[q]);
            return 0;
        }
    return 1;
}

static int degree(size_t p, unsigned long long cases)
{
    static worst found[QUANTITIES];
    et_rng *rng;
    int good;

    memset(found, 0, sizeof found);
    if (et_rng_new(&rng, et_rng_stream(20230, p)) != ET_OK)
        return 0;
    good = search(found, p, cases, rng);
    et_rng_free(rng);
    printf("| %zu |", p);
    for (int q = 0; q < QUANTITIES; q++) {
        if (q == SECOND && p < 2)
            printf(" |");
        else
            printf(" %.2f of %.0f |", found[q].error, bound(q, p));
        if (found[q].error > bound(q, p) + 1e-6 * bound(q, p)) {       /* the bounds' second-order terms */
            fprintf(stderr, "accuracy: degree %zu, %s: %.3f u is beyond the bound of %.0f u\n", p, titles[q], found[q].error, bound(q, p));
            good = 0;
        }
    }
    printf("\n");
    fflush(stdout);
    return good;
}

int main(int argc, char **argv)
{
    const unsigned long long cases = argc > 1 ? strtoull(argv[1], NULL, 10) : 0;
    int good = cases > 0;

    if (!good)
        return fputs("accuracy CASES [DEGREE...]\n", stderr), 2;
    printf("| degree |");
    for (int q = 0; q < QUANTITIES; q++)
        printf(" %s |", titles[q]);
    printf("\n|---|---|---|---|---|---|---|\n");
    if (argc == 2)
        for (size_t p = 1; p <= MOST; p++)
            good &= degree(p, cases);
    for (int k = 2; k < argc; k++) {
        const size_t p = strtoull(argv[k], NULL, 10);
        good &= p >= 1 && p <= MOST && degree(p, cases);
    }
    return !good;
}
