#include "etalon/base/real.h"
#include "etalon/fit/param.h"
#include "gen.h"
#include "golden.h"
#include <math.h>
#include <string.h>

enum { MOST = 8, STRIDE = 3, SIDE = 5 };

static const double exponent[4] = {0, 1, 0.5, 0.8};

verdict prop_param_name(gen *g)
{
    static const char *const names[] = {"uniform", "chord", "centripetal", "exponential"};
    const size_t k = gen_upto(g, 6);
    const char *name = et_param_name((et_param_method)k);

    return gen_check(g, k < 4 ? name != NULL && strcmp(name, names[k]) == 0 : name == NULL, "name %zu", k) &&
                   gen_check(g, et_param_name((et_param_method)-1) == NULL, "name of -1")
               ? PASS
               : FAIL;
}

verdict gold_param_name(const row *r)
{
    const char *name = et_param_name((et_param_method)row_size(r, 0));

    return strcmp(name == NULL ? "null" : name, r->want[0]) == 0 ? PASS : FAIL;
}

static bool is_params(const double *t, size_t n)
{
    for (size_t i = 1; i < n; i++)
        if (!(t[i - 1] <= t[i]))
            return false;
    return t[0] == 0 && t[n - 1] == 1;
}

static bool equal_points(et_vec3 a, et_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Eq. 2.8 as it stands, distances by hypot.  et_param_row: each distance within 3u and, for pow, 2u more (0.8 itself is rounded: 0.1u ln d, |ln d| <
 * 200 for the generator's scales: 20u); sums and quotient (n + 1)u.  Here the same and n u for the recursion: together at most 2 (n + 32) u. */
static bool agrees(gen *g, const double *t, const et_vec3 *D, size_t n, et_param_method method)
{
    double d[MOST], L = 0, expect = 0;

    for (size_t i = 1; i < n; i++) {
        const double chord = hypot(hypot(D[i].x - D[i - 1].x, D[i].y - D[i - 1].y), D[i].z - D[i - 1].z);
        d[i] = method == ET_PARAM_UNIFORM ? 1 : pow(chord, exponent[method]);
        L += d[i];
    }
    for (size_t i = 1; i < n; i++) {
        expect = expect + d[i] / L;
        if (!gen_check(g, fabs(t[i] - expect) <= 2 * (double)(n + 32) * ET_UNIT, "t[%zu] = %a, not %a", i, t[i], expect))
            return false;
    }
    return true;
}

/* The greatest and the least k for which all coordinates times 2^k are finite and normal (or zero). */
static void room(int *lo, int *hi, const et_vec3 *D, size_t n)
{
    *lo = -4000;
    *hi = 4000;
    for (size_t i = 0; i < 3 * n; i++) {
        const double x = i % 3 == 0 ? D[i / 3].x : i % 3 == 1 ? D[i / 3].y : D[i / 3].z;
        int e;
        (void)frexp(x, &e);
        if (x != 0) {
            *hi = 1024 - e < *hi ? 1024 - e : *hi;
            *lo = -1021 - e > *lo ? -1021 - e : *lo;
        }
    }
}

/* Scaling by powers of two, up to coordinates whose differences overflow and whose squares vanish, changes no bit. */
static bool scales(gen *g, const double *t, const et_vec3 *D, size_t n, et_param_method method)
{
    et_vec3 E[MOST];
    double s[MOST], work[MOST];
    int lo, hi, k;

    room(&lo, &hi, D, n);
    if (lo > hi || hi == 4000)
        return true;
    k = gen_chance(g, 2) ? hi : gen_chance(g, 2) ? lo : 0;
    for (size_t i = 0; i < n; i++)
        E[i] = (et_vec3){ldexp(D[i].x, k), ldexp(D[i].y, k), ldexp(D[i].z, k)};
    et_param_row(s, n, E, 1, method, work);
    return gen_check(g, memcmp(s, t, n * sizeof *s) == 0, "scaled by 2^%d: other bits", k);
}

verdict prop_param_row(gen *g)
{
    const size_t n = gen_between(g, 2, MOST), stride = gen_between(g, 1, STRIDE);
    const et_param_method method = (et_param_method)gen_upto(g, 3);
    et_vec3 D[MOST], wide[MOST * STRIDE], back[MOST];
    double t[MOST + 1], s[MOST + 1], work[MOST];
    bool flat = true;

    gen_points(g, &D[0].x, n);
    if (gen_chance(g, 8))
        for (size_t i = 1; i < n; i++)
            D[i] = D[0];
    for (size_t i = 0; i < MOST * STRIDE; i++)
        wide[i] = (et_vec3){NAN, NAN, NAN};
    for (size_t i = 0; i < n; i++) {
        wide[i * stride] = D[i];
        back[n - 1 - i] = D[i];
        flat = flat && equal_points(D[i], D[0]);
    }
    t[n] = s[n] = 7;
    const int told = et_param_row(t, n, wide, stride, method, work);
    if (!gen_check(g, is_params(t, n) && t[n] == 7, "parameters from 0 to 1") ||
        !gen_check(g, told == (flat && method != ET_PARAM_UNIFORM), "told flat: %d", told))
        return FAIL;
    gen_label(g, flat ? "flat" : "long");
    if (flat || method == ET_PARAM_UNIFORM) {
        for (size_t i = 0; i < n; i++)
            if (!gen_check(g, t[i] == (double)i / (double)(n - 1), "uniform"))
                return FAIL;
        return PASS;
    }
    et_param_row(s, n, back, 1, method, work);
    for (size_t i = 0; i < n; i++)
        if (!gen_check(g, fabs(s[n - 1 - i] + t[i] - 1) <= 2 * (double)(n + 32) * ET_UNIT, "reversed: %a and %a", t[i], s[n - 1 - i]))
            return FAIL;
    return agrees(g, t, D, n, method) && scales(g, t, D, n, method) ? PASS : FAIL;
}

/* Rows: method n, then n points; wanted: flat, t. */
verdict gold_param_row(const row *r)
{
    const size_t n = row_size(r, 1);
    et_vec3 D[64];
    double t[64], work[64];

    for (size_t i = 0; i < n; i++)
        D[i] = (et_vec3){row_real(r, 2 + 3 * i), row_real(r, 3 + 3 * i), row_real(r, 4 + 3 * i)};
    const int flat = et_param_row(t, n, D, 1, (et_param_method)row_size(r, 0), work);
    bool ok = row_is_size(r, 0, (size_t)flat);
    for (size_t i = 0; i < n; i++)
        ok = row_is(r, 1 + i, t[i]) && ok;
    return ok ? PASS : FAIL;
}

/* Mean over the lines by a plain sum: et_real_sum of k terms in [0,1] and this one each err by at most (k - 1)u of the sum. */
static bool mean_agrees(gen *g, const double *mean, size_t n, const et_vec3 *D, size_t step, size_t lines, size_t next, et_param_method method)
{
    double t[SIDE], work[SIDE], sum[SIDE] = {0};

    for (size_t k = 0; k < lines; k++) {
        et_param_row(t, n, D + k * next, step, method, work);
        for (size_t i = 0; i < n; i++)
            sum[i] += t[i];
    }
    for (size_t i = 0; i < n; i++)
        if (!gen_check(g, fabs(mean[i] - sum[i] / (double)lines) <= 2 * (double)(lines + 1) * ET_UNIT, "mean of parameter %zu", i))
            return false;
    return true;
}

static size_t flat_lines(const et_vec3 *D, size_t n, size_t step, size_t lines, size_t next)
{
    size_t count = 0;

    for (size_t k = 0; k < lines; k++) {
        bool flat = true;
        for (size_t i = 1; i < n; i++)
            flat = flat && equal_points(D[k * next + i * step], D[k * next]);
        count += flat;
    }
    return count;
}

verdict prop_param_grid(gen *g)
{
    const size_t nx = gen_between(g, 2, SIDE), ny = gen_between(g, 2, SIDE);
    const et_param_method method = (et_param_method)gen_upto(g, 3);
    et_vec3 D[SIDE * SIDE];
    double s[SIDE + 1] = {9, 9, 9, 9, 9, 9}, r[SIDE + 1] = {9, 9, 9, 9, 9, 9};
    size_t flat = 77, expect;

    gen_points(g, &D[0].x, nx * ny);
    if (gen_chance(g, 3)) {
        const size_t i = gen_upto(g, nx - 1);
        for (size_t j = 1; j < ny; j++)
            D[i * ny + j] = D[i * ny];
    }
    if (gen_chance(g, 3))
        for (size_t i = 1, j = gen_upto(g, ny - 1); i < nx; i++)
            D[i * ny + j] = D[j];
    if (!gen_check(g,
                   et_param_grid(s, 1, r, ny, &flat, D, method) == ET_EINVAL && et_param_grid(s, nx, r, 1, &flat, D, method) == ET_EINVAL &&
                       et_param_grid(s, nx, r, ny, &flat, D, (et_param_method)4) == ET_EINVAL && flat == 77 && s[0] == 9 && r[0] == 9,
                   "bad arguments"))
        return FAIL;
    if (!gen_check(g, et_param_grid(s, nx, r, ny, &flat, D, method) == ET_OK && is_params(s, nx) && is_params(r, ny), "parameters from 0 to 1") ||
        !gen_check(g, s[nx] == 9 && r[ny] == 9, "written past the end"))
        return FAIL;
    expect = method == ET_PARAM_UNIFORM ? 0 : flat_lines(D, ny, 1, nx, ny) + flat_lines(D, nx, ny, ny, 1);
    return gen_check(g, flat == expect, "%zu flat lines, not %zu", flat, expect) && mean_agrees(g, s, nx, D, ny, ny, 1, method) &&
                   mean_agrees(g, r, ny, D, 1, nx, ny, method)
               ? PASS
               : FAIL;
}

/* Rows: method nx ny, then points; wanted: flat, s, r. */
verdict gold_param_grid(const row *r)
{
    const size_t nx = row_size(r, 1), ny = row_size(r, 2);
    et_vec3 D[64];
    double a[16], b[16];
    size_t flat = 0;
    bool ok;

    for (size_t i = 0; i < nx * ny; i++)
        D[i] = (et_vec3){row_real(r, 3 + 3 * i), row_real(r, 4 + 3 * i), row_real(r, 5 + 3 * i)};
    ok = et_param_grid(a, nx, b, ny, &flat, D, (et_param_method)row_size(r, 0)) == ET_OK;
    ok = ok && row_is_size(r, 0, flat);
    for (size_t i = 0; ok && i < nx; i++)
        ok = row_is(r, 1 + i, a[i]);
    for (size_t j = 0; ok && j < ny; j++)
        ok = row_is(r, 1 + nx + j, b[j]);
    return ok ? PASS : FAIL;
}

verdict prop_param_standardise(gen *g)
{
    const size_t n = gen_between(g, 2, MOST);
    double a[MOST + 1], b[MOST + 1], x[MOST], y[MOST];

    for (size_t i = 0; i < n; i++) {
        x[i] = a[i] = i == 0 ? 0 : i == n - 1 ? 1 : gen_real(g, 0, 1);
        y[i] = b[i] = i == 0 ? 0 : i == n - 1 ? 1 : gen_real(g, 0, 1);
    }
    a[n] = b[n] = 5;
    et_param_standardise(a, b, n);
    for (size_t i = 0; i < n; i++) {
        /* The halves are exact unless subnormal, so x/2 + y/2 is the mean with one rounding: the same number. */
        if (!gen_check(g, a[i] == b[i] && fabs(a[i] - (0.5 * x[i] + 0.5 * y[i])) <= 0x1p-1070, "mean of %a and %a", x[i], y[i]) ||
            !gen_check(g, a[i] >= fmin(x[i], y[i]) && a[i] <= fmax(x[i], y[i]), "between"))
            return FAIL;
    }
    return gen_check(g, a[0] == 0 && a[n - 1] == 1 && a[n] == 5 && b[n] == 5, "ends") ? PASS : FAIL;
}

/* method nx ny; the points are those of a lattice. */
verdict gold_param_grid_status(const row *r)
{
    const size_t nx = row_size(r, 1), ny = row_size(r, 2);
    et_vec3 D[64] = {{0, 0, 0}};
    double a[16], b[16];
    size_t flat = 0;

    for (size_t i = 0; i < nx * ny && i < 64; i++)
        D[i] = (et_vec3){(double)(i / ny), (double)(i % ny), 0};
    return row_is_size(r, 0, (size_t)et_param_grid(a, nx, b, ny, &flat, D, (et_param_method)row_size(r, 0))) ? PASS : FAIL;
}

/* Rows: n, a, b; wanted: the means. */
verdict gold_param_standardise(const row *r)
{
    const size_t n = row_size(r, 0);
    double a[16], b[16];
    bool ok = true;

    for (size_t i = 0; i < n; i++) {
        a[i] = row_real(r, 1 + i);
        b[i] = row_real(r, 1 + n + i);
    }
    et_param_standardise(a, b, n);
    for (size_t i = 0; i < n; i++)
        ok = row_is(r, i, a[i]) && a[i] == b[i] && ok;
    return ok ? PASS : FAIL;
}
