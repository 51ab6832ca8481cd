/* base/vec3: distances against Pythagorean quadruples and against the exact sum of squares. */
#include "etalon/base/vec3.h"
#include "etalon/base/real.h"
#include "gen.h"
#include "golden.h"
#include <math.h>

/* a^2 + b^2 + c^2 = d^2 for m, n, p, q (Lebesgue's identity): integers, so all is exact. */
verdict prop_vec3_distance(gen *g)
{
    double m = (double)gen_upto(g, 500), n = (double)gen_upto(g, 500), p = (double)gen_upto(g, 500), q = (double)gen_upto(g, 500);
    double scale = ldexp(1.0, (int)gen_upto(g, 400) - 200);
    et_vec3 d = {(m * m + n * n - p * p - q * q) * scale, 2.0 * (m * q + n * p) * scale, 2.0 * (n * q - m * p) * scale};
    et_vec3 a = {(double)gen_upto(g, 1000) * scale, (double)gen_upto(g, 1000) * scale, (double)gen_upto(g, 1000) * scale};
    et_vec3 b = {a.x + d.x, a.y + d.y, a.z + d.z};
    double want = (m * m + n * n + p * p + q * q) * scale;
    bool ok = gen_check(g, et_vec3_distance(a, b) == want, "%a for %a", et_vec3_distance(a, b), want);
    ok = ok && gen_check(g, et_vec3_distance(b, a) == want && et_vec3_distance(a, a) == 0.0, "not symmetric, or not 0 to itself");
    return ok ? PASS : FAIL;
}

/* Any points: d^2 against the sum of squares of the rounded differences, both with their rounding errors by fma. */
verdict prop_vec3_distance_rounding(gen *g)
{
    double c[6];
    gen_points(g, c, 2);
    et_vec3 a = {c[0], c[1], c[2]}, b = {c[3], c[4], c[5]};
    double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z, d = et_vec3_distance(a, b);
    double greatest = fmax(fabs(x), fmax(fabs(y), fabs(z)));
    if (greatest == 0.0) {
        return gen_check(g, d == 0.0, "coincident points are %a apart", d) ? PASS : FAIL;
    }
    if (greatest < 0x1p-450) {
        return SKIP;                         /* squares, or their rounding errors, may underflow */
    }
    int e;
    frexp(greatest, &e);                     /* to scale 1, exactly */
    x = ldexp(x, -e), y = ldexp(y, -e), z = ldexp(z, -e), d = ldexp(d, -e);
    double xx = x * x, yy = y * y, zz = z * z, s = xx + yy + zz;
    double rest = fma(x, x, -xx) + fma(y, y, -yy) + fma(z, z, -zz) + ((yy - (xx + yy - xx)) + (xx - (xx + yy - (xx + yy - xx))));
    double t = xx + yy, v = s - t;
    rest += (t - (s - v)) + (zz - v);
    double error = (fma(d, d, -s) - rest) / s;      /* d^2 / (exact sum) - 1 */
    /* Of the squares: one rounding, two additions; the root twice: 5u. */
    return gen_check(g, fabs(error) <= 5.01 * ET_UNIT, "squared distance off by %g u", error / ET_UNIT) ? PASS : FAIL;
}

verdict prop_vec3_finite(gen *g)
{
    static const double bad[] = {HUGE_VAL, -HUGE_VAL};
    et_vec3 p[20];
    size_t n = (size_t)gen_upto(g, 19);
    gen_points(g, &p[0].x, 20);
    bool ok = gen_check(g, et_vec3_finite(p, n) == 1, "finite points");
    size_t at = (size_t)gen_upto(g, 19);
    double *c = at % 3 == 0 ? &p[at].x : at % 3 == 1 ? &p[at].y : &p[at].z;
    *c = gen_upto(g, 2) == 0 ? NAN : bad[gen_upto(g, 1)];
    ok = ok && gen_check(g, et_vec3_finite(p, n) == (at >= n), "point %zu of %zu is not finite", at, n);
    ok = ok && gen_check(g, et_vec3_finite(p, at) == 1 && et_vec3_finite(p, at + 1) == 0, "the first %zu", at);
    return ok ? PASS : FAIL;
}

verdict gold_vec3_distance(const row *r)
{
    et_vec3 a = {row_real(r, 0), row_real(r, 1), row_real(r, 2)}, b = {row_real(r, 3), row_real(r, 4), row_real(r, 5)};
    return row_is(r, 0, et_vec3_distance(a, b)) ? PASS : FAIL;
}

verdict gold_vec3_finite(const row *r)
{
    et_vec3 p[8];
    size_t n = r->nargs / 3;
    for (size_t i = 0; i < n && i < 8; i++) {
        p[i] = (et_vec3){row_real(r, 3 * i), row_real(r, 3 * i + 1), row_real(r, 3 * i + 2)};
    }
    return row_is_size(r, 0, (size_t)et_vec3_finite(p, n)) ? PASS : FAIL;
}
