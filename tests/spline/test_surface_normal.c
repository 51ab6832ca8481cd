/* spline/surface: where the normal ends.  Surfaces whose tangents and the sizes of whose terms are exact, so that the bound that decides is known to a
 * rounding of the cross product; and scales at which a number taken from a wrong place over- or underflows. */
#include "surfaces.h"
#include <stdint.h>

/* ---- the bound ---- */

/* Bernstein's polynomials of degree p, exact at quarters. */
static void bernstein(double B[4], size_t p, double u)
{
    static const double choose[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
    for (size_t k = 0; k <= p; k++) {
        B[k] = choose[p][k];
        for (size_t i = 0; i < p; i++) {
            B[k] *= i < k ? u : 1.0 - u;
        }
    }
}

/* Of one direction: the functions, their derivatives over p, and these with the signs dropped; the greatest function, the first of equal ones. */
typedef struct {
    double N[4], dN[4], size[4];
    size_t most;
} shape;

static shape shape_of(size_t p, double u)
{
    shape s;
    double B[4] = {0.0, 0.0, 0.0, 0.0};
    bernstein(s.N, p, u);
    bernstein(B, p - 1, u);
    s.most = 0;
    for (size_t k = 0; k <= p; k++) {
        double before = k > 0 ? B[k - 1] : 0.0, next = k < p ? B[k] : 0.0;
        s.dN[k] = before - next;
        s.size[k] = before + next;
        s.most = s.N[k] > s.N[s.most] ? k : s.most;
    }
    return s;
}

/* Coprime a and b, and c and d with a d - b c = 1. */
typedef struct { double a, b, c, d; } unimodular;

static unimodular coprime(int64_t a, int64_t b)
{
    for (;; b++) {
        int64_t r0 = a, r1 = b, s0 = 1, s1 = 0, t0 = 0, t1 = 1;
        while (r1 != 0) {
            int64_t k = r0 / r1, r = r0 - k * r1, s = s0 - k * s1, t = t0 - k * t1;
            r0 = r1, r1 = r, s0 = s1, s1 = s, t0 = t1, t1 = t;
        }
        if (r0 == 1) {                        /* a s0 + b t0 = 1 */
            return (unimodular){(double)a, (double)b, (double)-t0, (double)s0};
        }
    }
}

/* Sums over the net: of a value that may be anything, and of one that is not negative. */
static double over(size_t p, size_t q, const double *N, const double *M, const double *what)
{
    double sum = 0.0;
    for (size_t k = 0; k <= p; k++) {
        for (size_t l = 0; l <= q; l++) {
            sum += N[k] * M[l] * what[k * (q + 1) + l];
        }
    }
    return sum;
}

/* The value sum of `what` times the derivative along a direction, with weights w A' - w' A; with sizes w A' + w' A of the magnitudes. */
static double turned(const shape *f, const shape *g, size_t p, size_t q, bool along_v, const double *w, const double *what, bool sizes)
{
    const double *N = along_v ? f->N : sizes ? f->size : f->dN, *M = !along_v ? g->N : sizes ? g->size : g->dN;
    double A = over(p, q, f->N, g->N, what), D = over(p, q, N, M, what);
    double W = over(p, q, f->N, g->N, w), dW = over(p, q, N, M, w);
    return sizes ? W * D + dW * A : W * D - dW * A;
}

/* Control points t X + r E with X = (a, b), E = (c, d), a d - b c = 1, some 22 bits each, t and r small: tangents are alpha X + alpha' E, exactly, their
 * cross product is alpha beta' - alpha' beta, a small number.  What is computed of it is off by less than a rounding of the products' magnitudes, of which the
 * bound is 28(p+q) + 16. */
verdict prop_surface_normal_bound(gen *g)
{
    static const double quarters[] = {0.0, 0.25, 0.75, 0.5, 1.0}, halves[] = {0.0, 0.5, 1.0};
    size_t p = 1 + (size_t)gen_upto(g, 2), q = 1 + (size_t)gen_upto(g, 2), n = (p + 1) * (q + 1);
    bool rational = gen_upto(g, 1) == 1;
    double u = rational ? halves[gen_upto(g, 2)] : quarters[gen_upto(g, 4)], v = rational ? halves[gen_upto(g, 2)] : quarters[gen_upto(g, 4)];
    int x = (int)gen_upto(g, 2), y = (x + 1 + (int)gen_upto(g, 1)) % 3;
    double sx = gen_upto(g, 1) ? -1.0 : 1.0, sy = gen_upto(g, 1) ? -1.0 : 1.0, t[16], r[16], X[16], Y[16], w[16], one[16];
    int64_t top = INT64_C(1) << (18 + (int)gen_upto(g, 5));
    unimodular m = coprime(top + (int64_t)gen_upto(g, (uint64_t)top), 1 + (int64_t)gen_upto(g, (uint64_t)top));
    et_surface s;
    if (et_surface_new(&s, p, q, p + 1, q + 1, rational) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < 4; i++) {
        if (i <= p) {
            s.u[p + 1 + i] = 1.0;
        }
        if (i <= q) {
            s.v[q + 1 + i] = 1.0;
        }
    }
    for (size_t k = 0; k < n; k++) {
        t[k] = (double)gen_upto(g, 4) - 2.0;
        r[k] = (double)gen_upto(g, 2) - 1.0;
        w[k] = rational ? (double)gen_between(g, 1, 3) : 1.0;
        one[k] = 1.0;
        s.points[k] = (et_vec3){5.0, 5.0, 5.0};
        (&s.points[k].x)[x] = sx * (t[k] * m.a + r[k] * m.c);
        (&s.points[k].x)[y] = sy * (t[k] * m.b + r[k] * m.d);
        if (rational) {
            s.weights[k] = w[k];
        }
    }
    shape f = shape_of(p, u), h = shape_of(q, v);
    size_t o = f.most * (q + 1) + h.most;
    double t0 = t[o], r0 = r[o];
    for (size_t k = 0; k < n; k++) {          /* as seen from the origin, weighted */
        t[k] = w[k] * (t[k] - t0);
        r[k] = w[k] * (r[k] - r0);
        X[k] = fabs(t[k] * m.a + r[k] * m.c);
        Y[k] = fabs(t[k] * m.b + r[k] * m.d);
    }
    const double *with = rational ? w : one;
    double c = turned(&f, &h, p, q, false, with, t, false) * turned(&f, &h, p, q, true, with, r, false) -
               turned(&f, &h, p, q, true, with, t, false) * turned(&f, &h, p, q, false, with, r, false);
    double kx, ky, lx, ly;
    if (rational) {
        kx = turned(&f, &h, p, q, false, w, X, true), ky = turned(&f, &h, p, q, false, w, Y, true);
        lx = turned(&f, &h, p, q, true, w, X, true), ly = turned(&f, &h, p, q, true, w, Y, true);
    } else {
        kx = over(p, q, f.size, h.N, X), ky = over(p, q, f.size, h.N, Y);
        lx = over(p, q, f.N, h.size, X), ly = over(p, q, f.N, h.size, Y);
    }
    double count = 28.0 * (double)(p + q) + 16.0, bound = count * ET_UNIT * (kx * ly + ky * lx), near = 1.5 / count * bound;
    et_vec3 normal = {7.0, 8.0, 9.0};
    double *work = surface_room(&s);
    et_status status = et_surface_normal(&normal, &s, u, v, work, et_surface_work(&s));
    double sign = sx * sy * (y == (x + 1) % 3 ? 1.0 : -1.0) * (c > 0.0 ? 1.0 : -1.0);
    gen_label(g, fabs(c) < 0.8 * bound ? "below" : fabs(c) > 1.25 * bound ? "above" : "about");
    bool ok = gen_check(g, !(fabs(c) < bound - near) || (status == ET_ERANK && normal.x == 7.0 && normal.y == 8.0 && normal.z == 9.0),
                        "a normal, though %g is below %g", fabs(c), bound);
    ok = ok && gen_check(g, !(fabs(c) > bound + near) || status == ET_OK, "no normal, though %g is above %g", fabs(c), bound);
    ok = ok && gen_check(g, status != ET_OK || (&normal.x)[3 - x - y] == sign, "another normal");
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* ---- underflow ---- */

static double product_of(const double a[3], const double b[3], double sign)
{
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
        double c = a[(k + 1) % 3] * b[(k + 2) % 3] + sign * a[(k + 2) % 3] * b[(k + 1) % 3];
        sum += c * c;
    }
    return sqrt(sum);
}

/* A bilinear surface at a corner: tangents a, a few units, and b y with y so small that the 2^-1000 added to each size for what underflows decides.
 * Everything else is exact but for the roundings of lengths, some 10 in all. */
verdict prop_surface_normal_underflow(gen *g)
{
    double a[3], b[3], size[3], most = 0.0, lo = 1.0, hi = 0x1p60, margin = ldexp(1.0, -1 - (int)gen_upto(g, 18));
    bool swap = gen_upto(g, 1) == 1, above = gen_upto(g, 1) == 1;
    int e = 0;
    et_surface s;
    for (int k = 0; k < 3; k++) {
        a[k] = (double)gen_upto(g, 4) - 2.0;
        b[k] = (double)gen_upto(g, 4) - 2.0;
        most = fmax(most, fabs(a[k]));
    }
    double c = product_of(a, b, -1.0);
    if (c == 0.0) {
        a[0] = 1.0, a[1] = a[2] = b[0] = b[2] = 0.0, b[1] = -1.0, most = c = 1.0;
    }
    for (int k = 0; k < 100; k++) {           /* the bound as a function of 2^-1000 / y */
        double d = 0.5 * (lo + hi);
        for (int i = 0; i < 3; i++) {
            size[i] = fabs(b[i]) + d;
        }
        const double A[3] = {fabs(a[0]), fabs(a[1]), fabs(a[2])};
        *(72.0 * ET_UNIT * product_of(A, size, 1.0) < c ? &lo : &hi) = d;
    }
    frexp(most, &e);                          /* y = count 2^-1074 where the greatest coordinate is below 1 */
    double count = floor(0x1p74 / lo * (above ? 1.0 + margin : 1.0 - margin));
    if (et_surface_new(&s, 1, 1, 2, 2, 0) != ET_OK) {
        return FAIL;
    }
    s.u[2] = s.u[3] = s.v[2] = s.v[3] = 1.0;
    for (int k = 0; k < 3; k++) {
        (&s.points[swap ? 1 : 2].x)[k] = a[k];
        (&s.points[swap ? 2 : 1].x)[k] = ldexp(b[k] * count, e - 1074);
    }
    et_vec3 normal = {7.0, 8.0, 9.0};
    double *work = surface_room(&s);
    et_status status = et_surface_normal(&normal, &s, 0.0, 0.0, work, et_surface_work(&s));
    bool ok = gen_check(g, status == (above ? ET_OK : ET_ERANK), "%g times 2^-1074 is %s the bound", count, above ? "above" : "below");
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* ---- scales ---- */

/* A clamped net of zeros but for the neighbours of a corner, one along each direction, which are all that the tangents there are made of.  Either one is
 * 2^1023 and the other 2^-6: scaled by what is not the greatest of them the first overflows.  Or both are 2^-1000 and all that is beyond the corner's
 * span 2^1000: scaled by what is not of the span they vanish.  Or the corner's and one neighbour's weights are 2^1023, the others' 2^-6. */
verdict prop_surface_normal_scales(gen *g)
{
    size_t p = 1 + (size_t)gen_upto(g, 2), q = 1 + (size_t)gen_upto(g, 2), nu = p + 1 + (size_t)gen_upto(g, 2), nv = q + 1 + (size_t)gen_upto(g, 2);
    bool right = gen_upto(g, 1) == 1, top = gen_upto(g, 1) == 1, first = gen_upto(g, 1) == 1;
    uint64_t kind = gen_upto(g, 2);
    int x = (int)gen_upto(g, 2), y = (x + 1 + (int)gen_upto(g, 1)) % 3, z = 3 - x - y;
    double su = gen_upto(g, 1) ? -1.0 : 1.0, sv = gen_upto(g, 1) ? -1.0 : 1.0;
    et_surface s;
    if (et_surface_new(&s, p, q, nu, nv, kind == 2) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < nu + p + 1; i++) {
        s.u[i] = i <= p ? 0.0 : i < nu ? (double)(i - p) : (double)(nu - p);
    }
    for (size_t j = 0; j < nv + q + 1; j++) {
        s.v[j] = j <= q ? 0.0 : j < nv ? (double)(j - q) : (double)(nv - q);
    }
    size_t i = right ? nu - 1 : 0, j = top ? nv - 1 : 0, along_u = (right ? i - 1 : i + 1) * nv + j, along_v = i * nv + (top ? j - 1 : j + 1);
    for (size_t k = 0; k < nu * nv; k++) {
        bool inside = (right ? k / nv >= nu - p - 1 : k / nv <= p) && (top ? k % nv >= nv - q - 1 : k % nv <= q);
        s.points[k] = kind == 1 && !inside ? (et_vec3){0x1p1000, -0x1p1000, 0x1p1000} : (et_vec3){0.0, 0.0, 0.0};
        if (kind == 2) {
            s.weights[k] = 0x1p-6;
        }
    }
    (&s.points[along_u].x)[x] = su * (kind == 0 ? (first ? 0x1p1023 : 0x1p-6) : kind == 1 ? 0x1p-1000 : 1.0);
    (&s.points[along_v].x)[y] = sv * (kind == 0 ? (first ? 0x1p-6 : 0x1p1023) : kind == 1 ? 0x1p-1000 : 1.0);
    if (kind == 2) {
        s.weights[i * nv + j] = s.weights[first ? along_u : along_v] = 0x1p1023;
    }
    et_vec3 n = {7.0, 8.0, 9.0};
    double *work = surface_room(&s), want = su * sv * (right ? -1.0 : 1.0) * (top ? -1.0 : 1.0) * (y == (x + 1) % 3 ? 1.0 : -1.0);
    et_status status = et_surface_normal(&n, &s, s.u[right ? nu : 0], s.v[top ? nv : 0], work, et_surface_work(&s));
    bool ok = gen_check(g, status == ET_OK && (&n.x)[x] == 0.0 && (&n.x)[y] == 0.0 && (&n.x)[z] == want, "kind %d: status %d, (%a, %a, %a)", (int)kind,
                        (int)status, n.x, n.y, n.z);
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* The least span that there may be between wide ones: derivatives count in its width, which over any other overflows. */
verdict prop_surface_normal_narrow(gen *g)
{
    const double knots[6] = {-4.0, -4.0, 0.0, 0x1p-1022, 4.0, 4.0};
    bool across = gen_upto(g, 1) == 1;
    et_surface s;
    if (et_surface_new(&s, 1, 1, 4, 4, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < 6; i++) {
        s.u[i] = across ? (double)i : knots[i];
        s.v[i] = across ? knots[i] : (double)i;
    }
    for (size_t k = 0; k < 16; k++) {
        s.points[k] = (et_vec3){(double)(k / 4), (double)(k % 4), 0.0};
    }
    et_vec3 n = {7.0, 8.0, 9.0};
    double *work = surface_room(&s), at = gen_upto(g, 1) ? 0x1p-1023 : 0.0;
    et_status status = et_surface_normal(&n, &s, across ? 2.5 : at, across ? at : 2.5, work, et_surface_work(&s));
    bool ok = gen_check(g, status == ET_OK && n.x == 0.0 && n.y == 0.0 && n.z == 1.0, "status %d, (%a, %a, %a)", (int)status, n.x, n.y, n.z);
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
