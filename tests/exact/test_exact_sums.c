/* exact/exact_sums, exact_round, exact_surface: the parts that others are made of, at the limits of doubles and of sizes; and what functions of
 * surfaces do with memory. */
#include "etalon/exact/exact.h"
#include "exact/exact_radical_parts.h"
#include "exact/live.h"
#include "exact/nearest.h"
#include "exact/rational.h"
#include "gen.h"
#include <float.h>
#include <math.h>

/* ---- rounding ---- */

/* A double of any size, subnormal ones too, and its last place. */
static double any_double(gen *g, int *place)
{
    const int e = (int)gen_upto(g, 2097) - 1074;
    const uint64_t kind = gen_upto(g, 2), digits = kind == 0 ? 0 : kind == 1 ? (UINT64_C(1) << 52) - 1 : gen_upto(g, (UINT64_C(1) << 52) - 1);
    const double x = ldexp((double)((UINT64_C(1) << 52) + digits), e - 52);

    *place = e - 52 > -1074 ? e - 52 : -1074;
    return x;
}

/* q = x + k/8 of the last place. */
static void beside(fmpq_t q, double x, int place, long k)
{
    fmpq_t d;

    fmpq_init(d);
    fmpq_set_si(d, k, 8);
    exact_scale(d, place);
    exact_set(q, x);
    fmpq_add(q, q, d);
    fmpq_clear(d);
}

/* Beside each double, above the middle to the next the next one, below it the same, in it the even one; of squares the roots. */
verdict prop_exact_curve_point_rounding(gen *g)
{
    int place;
    const double x = any_double(g, &place), next = x < DBL_MAX ? nextafter(x, HUGE_VAL) : HUGE_VAL;
    const long k = (long)gen_upto(g, 8);
    const double up = k > 4 || (k == 4 && !nearest_even(x)) ? next : x, sign = gen_upto(g, 1) ? -1.0 : 1.0;
    fmpq_t q, s;
    double got, root;

    live_begin((size_t)(place + 1074) / 2);
    fmpq_init(q);
    fmpq_init(s);
    beside(q, x, place, k);
    fmpq_mul(s, q, q);
    root = exact_round_sqrt(s);
    if (sign < 0.0)
        fmpq_neg(q, q);
    got = exact_round(q);
    fmpq_clear(q);
    fmpq_clear(s);
    return gen_check(g, live_end(), "memory is kept") && gen_check(g, ref_same(got, up == 0.0 ? 0.0 : sign * up), "%ld/8 above %a: %a", k, x, got) &&
                   gen_check(g, ref_same(root, up), "the root of the square of %ld/8 above %a: %a", k, x, root)
               ? PASS
               : FAIL;
}

/* Far beyond the doubles, and far below. */
verdict prop_exact_curve_point_beyond(gen *g)
{
    const slong e = (slong)gen_between(g, 1024, 5000);
    const bool below = gen_upto(g, 1) == 1;
    fmpq_t q, s;

    fmpq_init(q);
    fmpq_init(s);
    fmpq_set_si(q, gen_upto(g, 1) ? 1 : 3, gen_upto(g, 1) ? 1 : 5);
    exact_scale(q, below ? -e - 53 : e + 3);
    fmpq_mul(s, q, q);
    const double got = exact_round(q), root = exact_round_sqrt(s);
    fmpq_neg(q, q);
    const double minus = exact_round(q);
    fmpq_clear(q);
    fmpq_clear(s);
    return gen_check(g, below ? ref_same(got, 0.0) && ref_same(root, 0.0) && ref_same(minus, 0.0) : got == HUGE_VAL && root == got && minus == -got,
                     "%a, %a, %a", got, root, minus)
               ? PASS
               : FAIL;
}

/* A ball tells its double just if both ends round to it. */
verdict prop_exact_curve_point_ball(gen *g)
{
    int place;
    const double x = any_double(g, &place), next = x < DBL_MAX ? nextafter(x, HUGE_VAL) : HUGE_VAL;
    const long k = (long)gen_upto(g, 8), wide = (long)gen_upto(g, 3), sign = gen_upto(g, 1) ? -1 : 1;
    const double from = k - wide > 4 || (k - wide == 4 && !nearest_even(x)) ? next : x;
    const double to = k + wide > 4 || (k + wide == 4 && !nearest_even(x)) ? next : x;
    const bool tells = from == to && k - wide > -2;         /* 2/8 below a power of 2 is the middle */
    double got = 47.0;
    fmpq_t q;
    arb_t ball;
    mag_t more;

    fmpq_init(q);
    arb_init(ball);
    mag_init(more);
    beside(q, x, place, k);
    fmpq_mul_si(q, q, sign);
    arb_set_fmpq(ball, q, 4200);
    mag_set_ui_2exp_si(more, (ulong)wide, place - 3);
    mag_add(arb_radref(ball), arb_radref(ball), more);
    live_begin((size_t)k);
    const int one = exact_round_ball(&got, ball);
    const int kept = !live_end();
    mag_clear(more);
    arb_clear(ball);
    fmpq_clear(q);
    if (!gen_check(g, !kept, "memory is kept") ||
        !gen_check(g, one ? ref_same(got, from == 0.0 ? 0.0 : (double)sign * from) : got == 47.0, "%a", got))
        return FAIL;
    return k - wide <= -2 || gen_check(g, one == tells, "%ld +- %ld eighths from %a: %d", k, wide, x, one) ? PASS : FAIL;
}

/* ---- whole numbers ---- */

/* The place of a double's last digit of 53, the least of all; numbers in units of a place. */
verdict prop_exact_surface_point_places(gen *g)
{
    int place;
    const double x = any_double(g, &place), sign = gen_upto(g, 1) ? -1.0 : 1.0;
    const slong shift = (slong)gen_upto(g, 60) - 30, e = ilogb(x) - 52;
    fmpz_t n, m;

    fmpz_init(n);
    fmpz_init(m);
    bool ok = gen_check(g, exact_place(WORD_MAX, sign * x) == e && exact_place(e - 1, x) == e - 1 && exact_place(e + 1, x) == e, "place of %a", x) &&
              gen_check(g, exact_place(shift, 0.0) == shift && exact_place(shift, -0.0) == shift, "0 has no place");
    fmpz_set_d(m, ldexp(sign * x, (int)-e));
    if (shift >= 0)
        fmpz_mul_2exp(m, m, (ulong)shift);
    else
        fmpz_tdiv_q_2exp(m, m, (ulong)-shift);
    exact_integer(n, sign * x, e - shift);
    ok = ok && gen_check(g, fmpz_equal(n, m), "%a in units of 2^%ld", sign * x, (long)(e - shift));
    exact_integer(n, 0.0, e);
    ok = ok && gen_check(g, fmpz_is_zero(n), "0 is 0");
    fmpz_clear(n);
    fmpz_clear(m);
    return ok ? PASS : FAIL;
}

/* Sizes up to 2^57 - 1 rationals of four words fit, and no more. */
verdict prop_exact_surface_grid_sizes(gen *g)
{
    const size_t limit = WORD_MAX / (4 * sizeof(fmpq)), k = (size_t)gen_upto(g, 62), a = (size_t)1 << k;
    size_t n = 5;
    bool ok = gen_check(g, exact_fits(&n, limit, 1) && n == limit && exact_fits(&n, 1, limit), "%zu fits", limit);

    n = 5;
    ok = ok &&
         gen_check(g, !exact_fits(&n, limit + 1, 1) && !exact_fits(&n, SIZE_MAX, 2) && !exact_fits(&n, SIZE_MAX / 3, 4) && n == 5, "and no more");
    ok = ok &&
         gen_check(g, exact_fits(&n, a, limit / a) == (limit / a > 0 || a * (limit / a) <= limit) && !exact_fits(&n, a, limit / a + 1), "%zu", a);
    return ok ? PASS : FAIL;
}

/* ---- surfaces ---- */

/* Points, derivatives, normals and grids keep nothing, and write where they should. */
/* One case in 4. */
verdict prop_exact_surface_partials_memory(gen *g)
{
    enum { MOST = 10 };
    et_surface s;
    et_vec3 D[MOST + 2], S = {0.0, 0.0, 0.0}, n = {1.0, 2.0, 3.0}, grid[14];

    if (!draw_surface(g, &s, 3))
        return SKIP;
    const size_t d = (size_t)gen_upto(g, 3), many = (d + 1) * (d + 2) / 2, na = (size_t)gen_upto(g, 3), nb = (size_t)gen_upto(g, 4);
    double a[5], b[5];
    for (size_t k = 0; k < 5; k++) {
        a[k] = k < na ? gen_parameter(g, s.u, s.nu + s.p + 1, s.p) : NAN;
        b[k] = k < nb ? gen_parameter(g, s.v, s.nv + s.q + 1, s.q) : NAN;
    }
    const double u = gen_parameter(g, s.u, s.nu + s.p + 1, s.p), v = gen_parameter(g, s.v, s.nv + s.q + 1, s.q);
    const et_side left = gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
    D[0].x = D[many + 1].x = 47.0;
    grid[0].x = grid[na * nb + 1].x = 47.0;
    live_begin(4 * d);
    et_status status = et_exact_surface_point(&S, &s, u, v);
    status = status == ET_OK ? et_exact_surface_partials(D + 1, d, &s, u, v, left, ET_SIDE_RIGHT) : status;
    const et_status normal = et_exact_surface_normal(&n, &s, u, v);
    status = status == ET_OK ? et_exact_surface_grid(grid + 1, &s, a, na, b, nb) : status;
    bool ok = gen_check(g, live_end(), "memory is kept") && gen_check(g, status == ET_OK, "status") &&
              gen_check(g, normal == ET_OK || (normal == ET_ERANK && n.x == 1.0 && n.y == 2.0 && n.z == 3.0), "normal") &&
              gen_check(g, D[0].x == 47.0 && D[many + 1].x == 47.0 && grid[0].x == 47.0 && grid[na * nb + 1].x == 47.0, "written beyond the end");
    ok =
        ok && gen_check(g, left == ET_SIDE_LEFT || (ref_same(D[1].x, S.x) && ref_same(D[1].y, S.y) && ref_same(D[1].z, S.z)), "the point is another");
    for (size_t k = 0; ok && k < na * nb; k++) {
        ok = gen_check(g, et_exact_surface_point(&S, &s, a[k / nb], b[k % nb]) == ET_OK && memcmp(&S, grid + 1 + k, sizeof S) == 0, "grid point %zu",
                       k);
    }
    for (size_t k = 0; ok && k < na; k++) {                 /* each parameter is looked at */
        const double was = a[k];
        a[k] = NAN;
        S = grid[1];
        ok = gen_check(g, et_exact_surface_grid(grid + 1, &s, a, na, b, nb) == ET_EINVAL && memcmp(&S, grid + 1, sizeof S) == 0, "parameter %zu", k);
        a[k] = was;
    }
    for (size_t k = 0; ok && k < nb; k++) {
        const double was = b[k];
        b[k] = HUGE_VAL;
        ok = gen_check(g, et_exact_surface_grid(grid + 1, &s, a, na, b, nb) == ET_EINVAL, "parameter %zu", k);
        b[k] = was;
    }
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Derivatives of such orders that no memory holds them. */
verdict prop_exact_surface_partials_sizes(gen *g)
{
    static const size_t orders[] = {SIZE_MAX, SIZE_MAX - 1, SIZE_MAX - 2, SIZE_MAX / 2, (size_t)1 << 40, (size_t)1 << 32, (size_t)1 << 29};
    const size_t d = orders[gen_upto(g, 6)];
    et_surface s;
    et_vec3 D = {1.0, 2.0, 3.0};

    if (et_surface_new(&s, 1, 1, 2, 2, 0) != ET_OK)
        return FAIL;
    s.u[2] = s.u[3] = s.v[2] = s.v[3] = 1.0;
    const bool ok = gen_check(g, et_exact_surface_partials(&D, d, &s, 0.5, 0.5, ET_SIDE_LEFT, ET_SIDE_LEFT) == ET_ENOMEM && D.x == 1.0, "%zu", d);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
