#include "etalon/base/real.h"
#include "etalon/exact/exact.h"
#include "exact/exact_radical_parts.h"
#include "exact/live.h"
#include "exact/nearest.h"
#include "gen.h"
#include "golden.h"
#include <stdlib.h>

enum { MOST = 8, STRIDE = 3, SIDE = 5, LONG = 700 };

/* ---- a second way ---- */

static et_vec3 scaled(et_vec3 p, int k)
{
    return (et_vec3){ldexp(p.x, k), ldexp(p.y, k), ldexp(p.z, k)};
}

/* |b - a|^e, e = 0, 1, 1/2, 4/5 (d over its fifth root). */
static void chord(mpfr_t d, et_vec3 a, et_vec3 b, et_param_method method)
{
    const double from[3] = {a.x, a.y, a.z}, to[3] = {b.x, b.y, b.z};
    mpfr_t x;

    mpfr_init2(x, SECOND_BITS);
    mpfr_set_zero(d, 1);
    for (size_t c = 0; c < 3; c++) {
        mpfr_set_d(x, to[c], MPFR_RNDN);
        mpfr_sub_d(x, x, from[c], MPFR_RNDN);
        mpfr_sqr(x, x, MPFR_RNDN);
        mpfr_add(d, d, x, MPFR_RNDN);
    }
    mpfr_sqrt(d, d, MPFR_RNDN);
    if (method == ET_PARAM_CENTRIPETAL)
        mpfr_sqrt(d, d, MPFR_RNDN);
    if (method == ET_PARAM_EXPONENTIAL) {
        mpfr_rootn_ui(x, d, 5, MPFR_RNDN);
        if (!mpfr_zero_p(d))
            mpfr_div(d, d, x, MPFR_RNDN);
    }
    if (method == ET_PARAM_UNIFORM)
        mpfr_set_ui(d, 1, MPFR_RNDN);
    mpfr_clear(x);
}

/* t[i] += the parameters of one line; whether it has no length. */
static bool add_line(mpfr_t *t, size_t n, const et_vec3 *D, size_t stride, et_param_method method)
{
    mpfr_t part[LONG], d;
    bool flat;

    mpfr_init2(d, SECOND_BITS);
    mpfr_init2(part[0], SECOND_BITS);
    mpfr_set_zero(part[0], 1);
    for (size_t i = 1; i < n; i++) {
        mpfr_init2(part[i], SECOND_BITS);
        chord(d, D[(i - 1) * stride], D[i * stride], method);
        mpfr_add(part[i], part[i - 1], d, MPFR_RNDN);
    }
    flat = mpfr_zero_p(part[n - 1]);
    for (size_t i = 0; i < n; i++) {
        if (flat) {
            mpfr_set_ui(d, (unsigned long)i, MPFR_RNDN);
            mpfr_div_ui(d, d, (unsigned long)(n - 1), MPFR_RNDN);
        } else {
            mpfr_div(d, part[i], part[n - 1], MPFR_RNDN);
        }
        mpfr_add(t[i], t[i], d, MPFR_RNDN);
    }
    for (size_t i = 0; i < n; i++)
        mpfr_clear(part[i]);
    mpfr_clear(d);
    return flat;
}

/* t[0..n-1]: means over the lines; returns how many are flat. */
static size_t second(double *t, size_t n, const et_vec3 *D, size_t stride, size_t lines, size_t next, et_param_method method)
{
    mpfr_t sum[LONG];
    size_t flat = 0;

    for (size_t i = 0; i < n; i++) {
        mpfr_init2(sum[i], SECOND_BITS);
        mpfr_set_zero(sum[i], 1);
    }
    for (size_t l = 0; l < lines; l++)
        flat += add_line(sum, n, D + l * next, stride, method);
    for (size_t i = 0; i < n; i++) {
        mpfr_div_ui(sum[i], sum[i], (unsigned long)lines, MPFR_RNDN);
        t[i] = nearest(sum[i]);
        mpfr_clear(sum[i]);
    }
    return method == ET_PARAM_UNIFORM ? 0 : flat;
}

/* ---- cases ---- */

static bool same(const double *a, const double *b, size_t n)
{
    return memcmp(a, b, n * sizeof *a) == 0;
}

/* Points of the generator, at ordinary scales or at the greatest and least of all. */
static void draw_points(gen *g, et_vec3 *D, size_t n)
{
    static const int scale[4] = {0, 0, 1000, -1060};
    const uint64_t kind = gen_upto(g, 3);

    gen_points(g, &D[0].x, n);
    for (size_t i = 0; i < n; i++) {
        const et_vec3 p = scaled(D[i], kind < 2 ? 0 : scale[kind]);
        D[i] = isfinite(p.x) && isfinite(p.y) && isfinite(p.z) ? p : D[0];
        if (!(isfinite(D[0].x) && isfinite(D[0].y) && isfinite(D[0].z)))
            D[0] = D[i] = (et_vec3){0x1.fffffffffffffp1023, -0x1p1023, 0};
    }
}

/* Whether the precision is none, or asked for 2^k bits. */
static bool doubled(size_t used, size_t asked)
{
    size_t bits = asked < 2 ? 2 : asked < EXACT_MOST_BITS ? asked : EXACT_MOST_BITS;

    while (bits < used)
        bits *= 2;
    return used == 0 || bits == used;
}

/* The same doubles from any precision on; the second's is four times what the first needed. */
static bool precise(gen *g, const double *t, size_t n, const et_vec3 *D, size_t stride, et_param_method method, size_t used)
{
    size_t start[3] = {4 * used, 1, n == 3 ? (size_t)-1 : 1000};
    double s[LONG];
    int flat;

    for (size_t k = 0; k < 3; k++) {
        const size_t asked = start[k];
        live_begin(n + k + used / 128);
        const et_status status = et_exact_param_row(s, n, &flat, D, stride, method, start + k);
        if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK && same(s, t, n), "from %zu bits on", asked) ||
            !gen_check(g, doubled(start[k], asked), "%zu bits from %zu on", start[k], asked) ||
            !gen_check(g,
                       used == 0 ? start[k] == 0
                                 : start[k] >= (k == 0   ? asked
                                                : k == 1 ? 2
                                                         : used),
                       "%zu bits", start[k]))
            return false;
    }
    return gen_check(g, et_exact_param_row(s, n, &flat, D, stride, method, NULL) == ET_OK && same(s, t, n), "bits not asked for");
}

/* A chord of et_param_row is within 2.5u of itself, and within 2^-537 where squares underflow, of a longest one of at least 1/2; half of the first
 * and the root of the second for its square root; for its power 4/5 2u, 1u for the power itself, and for the rounded 0.8, 2^-54.4 off, |ln d| < 373
 * times that, 142u.  Twice that for a quotient of sums, and their own (2n + 6) u. */
static double fast_bound(size_t n, et_param_method method, double t)
{
    const double roundings = 2 * (double)n + 6 + (method == ET_PARAM_EXPONENTIAL ? 290 : 0);
    const double lost = method == ET_PARAM_CHORD ? 0x1p-536 : method == ET_PARAM_CENTRIPETAL ? 0x1p-268 : 0x1p-428;

    return (roundings + 1) * ET_UNIT * t + 2 * (double)n * lost;
}

verdict prop_exact_param_row(gen *g)
{
    const size_t n = gen_between(g, 2, MOST), stride = gen_between(g, 1, STRIDE);
    const et_param_method method = (et_param_method)gen_upto(g, 3);
    et_vec3 D[MOST], wide[MOST * STRIDE];
    double t[MOST + 1], s[MOST + 1], fast[MOST], work[MOST];
    size_t bits = gen_upto(g, 1) * 64;
    int told = 7;

    draw_points(g, D, n);
    if (gen_chance(g, 8))
        for (size_t i = 1; i < n; i++)
            D[i] = D[0];
    for (size_t i = 0; i < MOST * STRIDE; i++)
        wide[i] = (et_vec3){NAN, NAN, NAN};
    for (size_t i = 0; i < n; i++)
        wide[i * stride] = D[i];
    t[0] = t[n] = 7;
    if (!gen_check(g,
                   et_exact_param_row(t, 1, &told, D, 1, method, &bits) == ET_EINVAL &&
                       et_exact_param_row(t, 0, &told, D, 1, method, &bits) == ET_EINVAL &&
                       et_exact_param_row(t, n, &told, D, 0, method, &bits) == ET_EINVAL &&
                       et_exact_param_row(t, n, &told, D, 1, (et_param_method)4, &bits) == ET_EINVAL && told == 7 && t[0] == 7 && bits % 64 == 0,
                   "bad arguments"))
        return FAIL;
    const size_t start = bits;
    live_begin(n + stride);
    const et_status status = et_exact_param_row(t, n, &told, wide, stride, method, &bits);
    if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK && t[n] == 7, "made"))
        return FAIL;
    const bool flat = second(s, n, D, 1, 1, 0, method) != 0;
    gen_label(g, flat ? "flat" : "long");
    if (!gen_check(g, told == flat, "told flat: %d", told) ||
        !gen_check(g, flat || method == ET_PARAM_UNIFORM || n == 2 ? bits == 0 : bits > 0 && doubled(bits, start ? start : 128), "%zu bits", bits))
        return FAIL;
    et_param_row(fast, n, D, 1, method, work);
    for (size_t i = 0; i < n; i++)
        if (!gen_check(g, same(t + i, s + i, 1), "t[%zu] = %a, not %a", i, t[i], s[i]) ||
            !gen_check(g, fabs(fast[i] - t[i]) <= fast_bound(n, flat ? ET_PARAM_CHORD : method, t[i]), "t[%zu] = %a, fast %a", i, t[i], fast[i]))
            return FAIL;
    return gen_check(g, t[0] == 0 && t[n - 1] == 1, "ends") && precise(g, t, n, wide, stride, method, bits) ? PASS : FAIL;
}

/* ---- ties ---- */

/* The double nearest to 1/2 + m/2^54, m odd and below 2^53: the even one of two neighbours. */
static double middle(uint64_t m)
{
    const uint64_t below = ((UINT64_C(1) << 53) + m - 1) / 2;

    return ldexp((double)(below + below % 2), -53);
}

/* One of the doubles that have many odd digits or few. */
static uint64_t odd_digits(gen *g, uint64_t most)
{
    return (gen_chance(g, 2) ? 2 * gen_upto(g, most / 2 - 1) : gen_chance(g, 2) ? 2 * gen_upto(g, 3) : most - 2 - 2 * gen_upto(g, 3)) + 1;
}

/* Along one direction from 2^53 to 0, to m, and back to 2^53: chords 2^53, m, 2^53 - m, times the direction's length, which may be irrational. */
static size_t tie_of_chords(et_vec3 *D, gen *g, uint64_t m, int scale)
{
    const double at[4] = {0x1p53, 0, (double)m, 0x1p53};
    const double x = (double)gen_upto(g, 2), y = (double)gen_upto(g, 2), z = gen_upto(g, 1) ? -4.0 : 1.0;

    for (size_t i = 0; i < 4; i++)
        D[i] = scaled((et_vec3){x > 1 ? 4 * at[i] : x * at[i], -y * at[i], z * at[i]}, scale);
    return 4;
}

/* Roots of lengths 2^53, m, and 2^53 - m in three pieces of 26 digits: along each axis from a length to 0 and from 0 to another.  An odd scale makes
 * all of them irrational. */
static size_t tie_of_roots(et_vec3 *D, uint64_t m, int scale)
{
    const uint64_t rest = (UINT64_C(1) << 53) - m, last = UINT64_C(1) << 27;
    const double a[6] = {0x1p53, (double)m, (double)(rest / last * last), (double)(rest % last / 2 * 2), (double)(rest % 2), 0};
    double at[3] = {a[0] * a[0], a[2] * a[2], a[4] * a[4]};

    D[0] = scaled((et_vec3){at[0], at[1], at[2]}, scale);
    for (size_t k = 0; k < 6; k++) {
        at[k / 2] = k % 2 == 0 ? 0 : a[k] * a[k];
        D[k + 1] = scaled((et_vec3){at[0], at[1], at[2]}, scale);
    }
    return 7;
}

/* There and back, so often that the powers 4/5, each a power of 16, add up to twice x. */
static size_t hexadecimal(et_vec3 *D, size_t n, uint64_t x, int scale)
{
    for (int digit = 0; x > 0; digit++, x /= 16)
        for (uint64_t k = x % 16; k > 0; k--) {
            D[n] = scaled((et_vec3){0, 0x1p-70, 0}, scale);
            D[n++].y *= ldexp(1, 5 * digit);
            D[n++] = (et_vec3){0, 0, 0};
        }
    return n;
}

/* Parameters that lie in the middle between two doubles. */
/* One case in 4. */
verdict prop_exact_param_row_ties(gen *g)
{
    const et_param_method method = gen_chance(g, 16) ? ET_PARAM_EXPONENTIAL : gen_upto(g, 1) ? ET_PARAM_CENTRIPETAL : ET_PARAM_CHORD;
    const int scale = (int)gen_upto(g, 30) - 15;
    const uint64_t m = method == ET_PARAM_CENTRIPETAL ? odd_digits(g, UINT64_C(1) << 26)
                       : method == ET_PARAM_CHORD     ? odd_digits(g, UINT64_C(1) << 53)
                                                      : odd_digits(g, 64) + (gen_upto(g, 15) << 40);
    et_vec3 D[LONG] = {{0, 0, 0}};
    double t[LONG], s[LONG];
    size_t n, tie = 2, bits = 0;
    int flat;

    if (method == ET_PARAM_EXPONENTIAL) {
        tie = hexadecimal(D, hexadecimal(D, 1, UINT64_C(1) << 53, scale), m, scale) - 1;
        n = hexadecimal(D, tie + 1, (UINT64_C(1) << 53) - m, scale);
    } else {
        n = method == ET_PARAM_CHORD ? tie_of_chords(D, g, m, scale) : tie_of_roots(D, m, scale);
    }
    gen_label(g, et_param_name(method));
    live_begin((size_t)(scale + 16));
    const et_status status = et_exact_param_row(t, n, &flat, D, 1, method, &bits);
    if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK && flat == 0, "made") ||
        !gen_check(g, t[tie] == middle(m), "1/2 + %llu/2^54 is %a, not %a", (unsigned long long)m, t[tie], middle(m)) ||
        !gen_check(g, bits == 128 || bits == 512, "%zu bits", bits)) /* whole roots are found at once */
        return FAIL;
    if (n <= MOST) {
        second(s, n, D, 1, 1, 0, method);
        if (!gen_check(g, same(s, t, n), "other parameters"))
            return FAIL;
    }
    return precise(g, t, n, D, 1, method, bits) ? PASS : FAIL;
}

/* As good as in the middle: chords 2^53, m and, in two pieces, 2^53 - m, the first two a little askew, by h^2 (1/2^54 + 1/2m).  So the parameter is
 * above the middle by between 2^-170 and 2^-130: 128 bits do not tell, 256 do, while the next parameter has long been known. */
/* One case in 4. */
verdict prop_exact_param_row_near_ties(gen *g)
{
    const uint64_t m = (UINT64_C(1) << 40) + odd_digits(g, (UINT64_C(1) << 53) - (UINT64_C(1) << 41)), rest = (UINT64_C(1) << 53) - m;
    const double h = ldexp(1, -20 - (int)gen_upto(g, 10));
    const et_vec3 D[5] = {{0x1p53, 0, 0}, {0, h, 0}, {(double)m, 0, 0}, {(double)((m + rest / 3) / 2 * 2), 0, 0}, {0x1p53, 0, 0}};
    double t[5], s[5];
    size_t bits = 0;
    int flat;

    if (!gen_check(g, et_exact_param_row(t, 5, &flat, D, 1, ET_PARAM_CHORD, &bits) == ET_OK && flat == 0, "made") ||
        !gen_check(g, bits == 256, "%zu bits", bits))
        return FAIL;
    second(s, 5, D, 1, 1, 0, ET_PARAM_CHORD);
    return gen_check(g, same(s, t, 5), "t[2] = %a, not %a", t[2], s[2]) && precise(g, t, 5, D, 1, ET_PARAM_CHORD, bits) ? PASS : FAIL;
}

/* A tie from the greatest precision on is looked for after two doublings all the same. */
/* One case in 250. */
verdict prop_exact_param_row_greatest(gen *g)
{
    const size_t asked = gen_upto(g, 1) ? SIZE_MAX : EXACT_MOST_BITS;
    const et_vec3 D[4] = {{0x1p53, 0x1p53, 0}, {0, 0, 0}, {0x1p52 + 1, 0x1p52 + 1, 0}, {0x1p53, 0x1p53, 0}};
    size_t bits = asked;
    double t[4];
    int flat;

    live_begin(0);
    const et_status status = et_exact_param_row(t, 4, &flat, D, 1, ET_PARAM_CHORD, &bits);
    return gen_check(g, live_end(), "memory is kept") && gen_check(g, status == ET_OK && t[2] == 0.75, "t[2] = %a", t[2]) &&
                   gen_check(g, bits == 4 * (size_t)EXACT_MOST_BITS, "%zu bits", bits)
               ? PASS
               : FAIL;
}

static void zero_stack(void)
{
    volatile unsigned char below[1 << 12];

    for (size_t i = 0; i < sizeof below; i++)
        below[i] = 0;
}

/* Lines that no memory holds are refused before anything is read. */
verdict prop_exact_param_row_sizes(gen *g)
{
    static const size_t many[5][2] = {{SIZE_MAX / 2 + 1, 3}, {(size_t)1 << 58, 3}, {(size_t)1 << 59, 2}, {1, (size_t)1 << 40}, {1, (size_t)1 << 30}};
    const size_t k = gen_upto(g, 4), n = (size_t)1 << gen_between(g, 30, 60);
    const et_param_method method = (et_param_method)gen_between(g, ET_PARAM_CHORD, ET_PARAM_EXPONENTIAL);
    const et_vec3 D[2] = {{0, 0, 0}, {1, 1, 1}};
    exact_lines L = {7, 7, 7, 7, NULL};
    double t[1] = {9};
    size_t bits = 5;
    int flat = 77;

    zero_stack();
    return gen_check(g, exact_lines_init(&L, many[k][0], 1, D, many[k][1], 1, method) == ET_ENOMEM && L.n == 7 && L.r == NULL, "lines") &&
                   gen_check(g, et_exact_param_row(t, n, &flat, D, 1, method, &bits) == ET_ENOMEM && t[0] == 9 && flat == 77 && bits == 5, "a line")
               ? PASS
               : FAIL;
}

/* ---- grids ---- */

/* Repeated lines, lines of no length, and mirrored ones come often. */
static void draw_grid(gen *g, et_vec3 *D, size_t nx, size_t ny)
{
    draw_points(g, D, nx * ny);
    if (gen_chance(g, 4)) {
        const size_t i = gen_upto(g, nx - 1);
        for (size_t j = 1; j < ny; j++)
            D[i * ny + j] = D[i * ny];
    }
    if (gen_chance(g, 4))
        for (size_t i = 1, j = gen_upto(g, ny - 1); i < nx; i++)
            D[i * ny + j] = D[j];
    if (gen_chance(g, 4))
        for (size_t i = 0; i < nx; i++)
            for (size_t j = 0; j < ny / 2; j++)
                D[i * ny + ny - 1 - j] = D[(nx - 1 - i) * ny + j];
}

static bool means_agree(gen *g, const double *t, const double *s, const double *fast, size_t n, size_t lines, et_param_method method)
{
    for (size_t i = 0; i < n; i++) {
        /* Lines of no length may stand beside others: the methods' bounds together; (lines + 1)u more for the mean. */
        const double bound = fast_bound(n, method, t[i]) + ((double)lines + 1) * ET_UNIT * t[i];
        if (!gen_check(g, same(t + i, s + i, 1), "mean %zu is %a, not %a", i, t[i], s[i]) ||
            !gen_check(g, fabs(fast[i] - t[i]) <= bound, "mean %zu is %a, fast %a", i, t[i], fast[i]))
            return false;
    }
    return gen_check(g, t[0] == 0 && t[n - 1] == 1, "ends");
}

static bool grid_precise(gen *g, const double *s, size_t nx, const double *r, size_t ny, const et_vec3 *D, et_param_method method, size_t used)
{
    double a[SIDE], b[SIDE];
    size_t start[3] = {4 * used, 3, 1000}, flat;

    for (size_t k = 0; k < 3; k++) {
        const size_t asked = start[k];
        live_begin(nx + 2 * ny + k);
        const et_status status = et_exact_param_grid(a, nx, b, ny, &flat, D, method, start + k);
        if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK && same(a, s, nx) && same(b, r, ny), "start %zu", k) ||
            !gen_check(g, used == 0 ? start[k] == 0 : start[k] > 0 && doubled(start[k], asked), "%zu bits from %zu on", start[k], asked))
            return false;
    }
    return gen_check(g, et_exact_param_grid(a, nx, b, ny, &flat, D, method, NULL) == ET_OK && same(a, s, nx) && same(b, r, ny), "no bits");
}

/* One case in 2. */
verdict prop_exact_param_grid(gen *g)
{
    const size_t nx = gen_between(g, 2, SIDE), ny = gen_between(g, 2, SIDE);
    const et_param_method method = (et_param_method)gen_upto(g, 3);
    et_vec3 D[SIDE * SIDE];
    double s[SIDE + 1] = {9, 9, 9, 9, 9, 9}, r[SIDE + 1] = {9, 9, 9, 9, 9, 9}, s2[SIDE], r2[SIDE], sf[SIDE], rf[SIDE];
    size_t flat = 77, bits = 5, fast_flat;

    draw_grid(g, D, nx, ny);
    if (!gen_check(g,
                   et_exact_param_grid(s, 1, r, ny, &flat, D, method, &bits) == ET_EINVAL &&
                       et_exact_param_grid(s, nx, r, 1, &flat, D, method, &bits) == ET_EINVAL &&
                       et_exact_param_grid(s, nx, r, ny, &flat, D, (et_param_method)4, &bits) == ET_EINVAL &&
                       et_exact_param_grid(s, SIZE_MAX / 2, r, 3, &flat, D, method, &bits) == ET_ENOMEM && flat == 77 && s[0] == 9 && r[0] == 9 &&
                       bits == 5,
                   "bad arguments"))
        return FAIL;
    bits = 0;
    live_begin(nx + 2 * ny);
    const et_status status = et_exact_param_grid(s, nx, r, ny, &flat, D, method, &bits);
    if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK && s[nx] == 9 && r[ny] == 9, "made"))
        return FAIL;
    const size_t along_u = second(s2, nx, D, ny, ny, 1, method), along_v = second(r2, ny, D, 1, nx, ny, method);
    et_param_grid(sf, nx, rf, ny, &fast_flat, D, method);
    gen_label(g, along_u + along_v > 0 ? "flat lines" : "long lines");
    const bool none = method == ET_PARAM_UNIFORM || ((nx == 2 || along_u == ny) && (ny == 2 || along_v == nx));
    return gen_check(g, none ? bits == 0 : bits > 0 && doubled(bits, 128), "%zu bits", bits) &&
                   gen_check(g, flat == along_u + along_v && flat == fast_flat, "%zu flat lines", flat) &&
                   means_agree(g, s, s2, sf, nx, ny, method) && means_agree(g, r, r2, rf, ny, nx, method) &&
                   grid_precise(g, s, nx, r, ny, D, method, bits)
               ? PASS
               : FAIL;
}

/* Line j of the grid of n x ny points, or, transposed, of ny x n. */
static void put_line(et_vec3 *D, const et_vec3 *line, size_t n, size_t ny, size_t j, bool transposed)
{
    for (size_t i = 0; i < n; i++)
        D[transposed ? j * n + i : i * ny + j] = line[i];
}

/* Means in the middle between two doubles of parameters that are not rational: lines of chords a, c sqrt(2) and, three times as long, c sqrt(2), a
 * have parameters that add up to 1; with m/2^53 and 0 of two more the mean is (1 + m/2^53)/4. */
verdict prop_exact_param_grid_ties(gen *g)
{
    const double a = (double)gen_between(g, 1, 9), c = (double)gen_between(g, 1, 9);
    const uint64_t m = odd_digits(g, UINT64_C(1) << 53);
    const int scale = (int)gen_upto(g, 20) - 10;
    const bool transposed = gen_upto(g, 1) == 1;
    const size_t shift = gen_upto(g, 3);
    const et_vec3 line[4][3] = {{{0, 0, 0}, {a, 0, 0}, {a + c, c, 0}},
                                {{0, 0, 0}, {3 * c, 3 * c, 0}, {3 * c, 3 * c, 3 * a}},
                                {{0, 0, 0}, {0, (double)m, 0}, {0, 0x1p53, 0}},
                                {{5, 0, 0}, {5, 0, 0}, {0, 0, 0}}};
    et_vec3 D[12];
    double s[4], r[4];
    size_t flat, bits = 0;

    for (size_t j = 0; j < 4; j++)
        put_line(D, line[(j + shift) % 4], 3, 4, j, transposed);
    for (size_t i = 0; i < 12; i++)
        D[i] = scaled(D[i], scale);
    live_begin(m / 2 + shift);
    const et_status status = et_exact_param_grid(s, transposed ? 4 : 3, r, transposed ? 3 : 4, &flat, D, ET_PARAM_CHORD, &bits);
    if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK, "made"))
        return FAIL;
    const double mean = transposed ? r[1] : s[1];
    return gen_check(g, mean == middle(m) / 2 && flat == 0 && bits == 512, "%llu: mean %a, not %a; %zu bits", (unsigned long long)m,
                     mean, middle(m) / 2, bits)
               ? PASS
               : FAIL;
}

static et_vec3 beyond(et_vec3 p, et_vec3 d, double k)
{
    return (et_vec3){p.x + k * d.x, p.y + k * d.y, p.z + k * d.z};
}

/* The same with chords of four kinds, of sizes in no order, and the kinds in another order in each line: a, c sqrt(2) | d sqrt(3), e sqrt(6) and d, e
 * | a, c, the pairs turned or not; the parameters in the middle add up to 1. */
verdict prop_exact_param_grid_ties_of_kinds(gen *g)
{
    et_vec3 kind[4] = {{(double)gen_between(g, 1, 9), 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, -1}}, D[20], line[5];
    const uint64_t m = odd_digits(g, UINT64_C(1) << 53);
    const double at[5] = {0, 0, (double)m, 0x1p53, 0x1p53};
    const bool transposed = gen_upto(g, 1) == 1;
    double s[5], r[5];
    size_t flat, bits = 0;

    for (size_t k = 1; k < 4; k++)
        kind[k] = beyond((et_vec3){0, 0, 0}, kind[k], (double)gen_between(g, 1, 9));
    for (size_t j = 0; j < 2; j++) {
        const size_t turned[2] = {gen_upto(g, 1), gen_upto(g, 1)};
        line[0] = (et_vec3){1, 2, 3};
        for (size_t k = 0; k < 4; k++) {
            const size_t pair = (k / 2 + j) % 2;
            line[k + 1] = beyond(line[k], kind[2 * pair + (k + turned[pair]) % 2], j == 0 ? 1 : -3);
        }
        put_line(D, line, 5, 4, 3 * j, transposed);
    }
    for (size_t k = 0; k < 5; k++)
        line[k] = (et_vec3){at[k], 0, 0};
    put_line(D, line, 5, 4, 1, transposed);
    for (size_t k = 0; k < 5; k++)
        line[k] = (et_vec3){0, k > 2 ? 5 : 0, 0};
    put_line(D, line, 5, 4, 2, transposed);
    live_begin(m / 2);
    const et_status status = et_exact_param_grid(s, transposed ? 4 : 5, r, transposed ? 5 : 4, &flat, D, ET_PARAM_CHORD, &bits);
    if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK, "made"))
        return FAIL;
    const double mean = transposed ? r[2] : s[2];
    return gen_check(g, mean == middle(m) / 2 && bits == 512, "%llu: mean %a, not %a; %zu bits", (unsigned long long)m, mean,
                     middle(m) / 2, bits)
               ? PASS
               : FAIL;
}

/* Chords 3, 4, 7 sqrt(2) and 3, sqrt(2), 0: parameters 3/(7 + 7 sqrt(2)) and 3/(3 + sqrt(2)), which add up to 6/7 although no line is a multiple of
 * the other or of its reverse.  With (2^53 + 7)/(7 2^53) and 0 the mean is 1/4 + 2^-55, and that is not found out. */
/* One case in 2. */
verdict prop_exact_param_grid_undecided(gen *g)
{
    static const et_vec3 line[4][4] = {{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {3, -3, 7}},
                                       {{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {4, 1, 0}},
                                       {{-7, 0, 0}, {0x1p53, 0, 0}, {0x1.cp55 - 8, 0, 0}, {0x1.cp55 - 8, 1, 0}},
                                       {{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 2, 0}}};
    const int scale = (int)gen_upto(g, 20) - 10;
    const bool transposed = gen_upto(g, 1) == 1;
    const size_t shift = gen_upto(g, 3);
    et_vec3 D[16];
    double s[4] = {9, 9, 9, 9}, r[4] = {9, 9, 9, 9};
    size_t flat = 77, bits = gen_upto(g, 1) * 50;
    const size_t before = bits;

    if (gen_upto(g, 3) > 0) /* ten milliseconds each */
        return SKIP;
    for (size_t j = 0; j < 4; j++)
        put_line(D, line[(j + shift) % 4], 4, 4, j, transposed);
    for (size_t i = 0; i < 16; i++)
        D[i] = scaled(D[i], scale);
    live_begin(shift);
    const et_status status = et_exact_param_grid(s, 4, r, 4, &flat, D, ET_PARAM_CHORD, &bits);
    return gen_check(g, live_end(), "memory is kept") &&
                   gen_check(g, status == ET_ENOCONV && flat == 77 && bits == before && s[1] == 9 && r[1] == 9, "decided: %a, %a", s[1], r[1])
               ? PASS
               : FAIL;
}

/* ---- means of two views, knots ---- */

/* (x[0] + ... + x[n-1]) / divisor, divisor below 2^11. */
static double ratio(const double *x, size_t n, unsigned long divisor)
{
    mpfr_t sum;
    double q;

    mpfr_init2(sum, SECOND_BITS);
    mpfr_set_zero(sum, 1);
    for (size_t i = 0; i < n; i++)
        mpfr_add_d(sum, sum, x[i], MPFR_RNDN);
    mpfr_div_ui(sum, sum, divisor, MPFR_RNDN);
    /* Sums of doubles are exact in 5000 bits; a quotient that is no double is 2^-12 of an ulp or more away from any middle unless it is one. */
    q = mpfr_get_d(sum, MPFR_RNDN);
    mpfr_clear(sum);
    return q + 0.0;
}

verdict prop_exact_param_standardise(gen *g)
{
    const size_t n = gen_between(g, 2, MOST);
    double a[MOST + 1], b[MOST + 1], x[MOST], y[MOST], u[MOST], v[MOST];

    for (size_t i = 0; i < n; i++) {
        const uint64_t kind = gen_upto(g, 3);
        const double far = kind == 0 ? 1 : kind == 1 ? 0x1.fffffffffffffp1023 : kind == 2 ? 0x1p-1070 : 0x1p-60;
        x[i] = gen_real(g, 0, 1);
        y[i] = gen_real(g, 0, far);
        u[i] = a[i] = x[i];
        v[i] = b[i] = y[i];
    }
    a[n] = b[n] = 5;
    et_exact_param_standardise(a, b, n);
    et_param_standardise(u, v, n);
    for (size_t i = 0; i < n; i++) {
        const double both[2] = {x[i], y[i]}, expect = ratio(both, 2, 2);
        /* The fast way rounds the sum, and the half only where it is subnormal. */
        if (!gen_check(g, same(a + i, &expect, 1) && same(b + i, &expect, 1), "mean of %a and %a is %a, not %a", x[i], y[i], a[i], expect) ||
            !gen_check(g, isinf(u[i]) || fabs(u[i] - a[i]) <= 0x1p-1074, "fast %a", u[i]))
            return FAIL;
    }
    return gen_check(g, a[n] == 5 && b[n] == 5, "written past the end") ? PASS : FAIL;
}

enum { P_MOST = 4, CONTROL = 10, PARAMETERS = 24, KNOTS = CONTROL + P_MOST + 2 };

static void draw_parameters(gen *g, double *t, size_t nt)
{
    t[0] = 0;
    for (size_t i = 1; i < nt; i++) {
        const uint64_t kind = gen_upto(g, 4);
        t[i] = kind == 0   ? t[i - 1]
               : kind == 1 ? nextafter(t[i - 1], 2)
               : kind == 2 ? t[i - 1] * 2 + 0x1p-1074 * (double)gen_upto(g, 3)
                           : t[i - 1] + (1 - t[i - 1]) * gen_real(g, 0, 1);
        t[i] = fmin(t[i], 1);
    }
    if (gen_upto(g, 7))
        t[nt - 1] = 1;
}

/* Interior knot j: i by search, and the whole formula over `spans` as one sum of doubles over one divisor. */
static double second_knot(const double *t, size_t nt, size_t p, size_t j, size_t spans, et_knotrule_kind kind)
{
    const double whole = (double)j;
    double x[KNOTS + P_MOST] = {0};
    size_t i = 0;

    if (kind == ET_KNOTRULE_UNIFORM)
        return ratio(&whole, 1, spans);
    if (kind != ET_KNOTRULE_PIEGL)
        return ratio(t + j, p, p);
    while ((i + 1) * spans <= j * nt)
        i++;
    for (size_t k = 0; k < spans; k++)
        x[k] = t[k < j * nt - i * spans ? i : i - 1];
    return ratio(x, spans, spans);
}

static bool refuses(gen *g, size_t p, const double *t, size_t nt, size_t nu)
{
    double u[KNOTS + 2], was[KNOTS + 2];
    bool ok = true;

    for (size_t i = 0; i < KNOTS + 2; i++)
        u[i] = was[i] = 5;
    ok = ok && et_exact_knotrule_make(u, nu, 0, t, nt, ET_KNOTRULE_UNIFORM) == ET_EINVAL;
    ok = ok && et_exact_knotrule_make(u, 2 * p + 1, p, t, nt, ET_KNOTRULE_UNIFORM) == ET_EINVAL;
    ok = ok && et_exact_knotrule_make(u, nu, p, t, 1, ET_KNOTRULE_UNIFORM) == ET_EINVAL;
    ok = ok && et_exact_knotrule_make(u, nu, p, t, nt, (et_knotrule_kind)4) == ET_EINVAL;
    ok = ok && (nt == nu - p - 1 || et_exact_knotrule_make(u, nu, p, t, nt, ET_KNOTRULE_AVERAGING) == ET_EINVAL);
    ok = ok && et_exact_knotrule_make(u, nu, p, t, nu - p - 2, ET_KNOTRULE_PIEGL) == ET_EINVAL;
    ok = ok && et_exact_knotrule_make(u, nu, p, t, nu - p - 2, ET_KNOTRULE_FAITHFUL) == ET_EINVAL;
    ok = ok && et_exact_knotrule_make(u, SIZE_MAX, 1, t, 2, ET_KNOTRULE_UNIFORM) == ET_ENOMEM;
    return gen_check(g, ok && same(u, was, KNOTS + 2), "bad arguments");
}

verdict prop_exact_knotrule_make(gen *g)
{
    const size_t p = gen_between(g, 1, P_MOST), control = gen_between(g, p + 1, CONTROL), nu = control + p + 1, spans = control - p;
    const et_knotrule_kind kind = (et_knotrule_kind)gen_upto(g, 3);
    const size_t nt = kind == ET_KNOTRULE_AVERAGING                        ? control
                      : kind == ET_KNOTRULE_UNIFORM && gen_upto(g, 3) == 0 ? 2
                                                                           : gen_between(g, control, PARAMETERS);
    double t[PARAMETERS], u[KNOTS + 1], v[KNOTS + 1];

    draw_parameters(g, t, nt);
    u[nu] = 5;
    if (!refuses(g, p, t, nt, nu) || !gen_check(g, et_exact_knotrule_make(u, nu, p, t, nt, kind) == ET_OK && u[nu] == 5, "made"))
        return FAIL;
    et_knotrule_make(v, nu, p, t, nt, kind);
    for (size_t i = 0; i < nu; i++) {
        const double expect = i <= p ? 0 : i >= control ? 1 : second_knot(t, nt, p, i - p, spans, kind);
        /* The documented bounds, 1u more for this one's rounding, and half the least double for each rounding of a subnormal. */
        const double u_of = kind == ET_KNOTRULE_PIEGL ? 4 : kind == ET_KNOTRULE_UNIFORM ? 0 : (double)p + 2;
        const double bound = u_of * ET_UNIT * expect + (kind == ET_KNOTRULE_UNIFORM ? 0 : 0x1p-1072);
        if (!gen_check(g, same(u + i, &expect, 1), "knot %zu is %a, not %a", i, u[i], expect) ||
            !gen_check(g, fabs(v[i] - u[i]) <= bound, "knot %zu is %a, fast %a", i, u[i], v[i]) ||
            !gen_check(g, i == 0 || u[i - 1] <= u[i], "knots %zu: %a, %a", i, u[i > 0 ? i - 1 : 0], u[i]))
            return FAIL;
    }
    gen_label(g, et_knotrule_name(kind));
    return PASS;
}

/* ---- the rows of the fast functions ---- */

static et_vec3 *points_of(const row *r, size_t first, size_t n)
{
    et_vec3 *D = calloc(n, sizeof *D);

    for (size_t i = 0; D != NULL && i < 3 * n; i++)
        (&D[0].x)[i] = row_real(r, first + i);
    return D;
}

/* Rows: method n, then n points; wanted: flat, t. */
verdict true_param_row(const row *r)
{
    const size_t n = row_size(r, 1);
    et_vec3 *D = points_of(r, 2, n);
    double *t = calloc(n + 1, sizeof *t);
    int flat = 0;
    bool ok = D != NULL && t != NULL && et_exact_param_row(t, n, &flat, D, 1, (et_param_method)row_size(r, 0), NULL) == ET_OK;

    ok = ok && row_is_size(r, 0, (size_t)flat);
    for (size_t i = 0; ok && i < n; i++)
        ok = row_is(r, 1 + i, t[i]);
    free(D);
    free(t);
    return ok ? PASS : FAIL;
}

/* Rows: method nx ny, then points; wanted: flat, s, r. */
verdict true_param_grid(const row *r)
{
    const size_t nx = row_size(r, 1), ny = row_size(r, 2);
    et_vec3 *D = points_of(r, 3, nx * ny);
    double *t = calloc(nx + ny + 1, sizeof *t);
    size_t flat = 0;
    bool ok = D != NULL && t != NULL && et_exact_param_grid(t, nx, t + nx, ny, &flat, D, (et_param_method)row_size(r, 0), NULL) == ET_OK;

    ok = ok && row_is_size(r, 0, flat);
    for (size_t i = 0; ok && i < nx + ny; i++)
        ok = row_is(r, 1 + i, t[i]);
    free(D);
    free(t);
    return ok ? PASS : FAIL;
}

/* Rows: n, a, b; wanted: the means. */
verdict true_param_standardise(const row *r)
{
    const size_t n = row_size(r, 0);
    double *a = calloc(n + 1, sizeof *a), *b = calloc(n + 1, sizeof *b);
    bool ok = a != NULL && b != NULL;

    for (size_t i = 0; ok && i < n; i++) {
        a[i] = row_real(r, 1 + i);
        b[i] = row_real(r, 1 + n + i);
    }
    if (ok)
        et_exact_param_standardise(a, b, n);
    for (size_t i = 0; ok && i < n; i++)
        ok = row_is(r, i, a[i]) && a[i] == b[i];
    free(a);
    free(b);
    return ok ? PASS : FAIL;
}

/* Rows: kind p nu nt, then t; wanted: interior knots. */
verdict true_knotrule_make(const row *r)
{
    const size_t p = row_size(r, 1), nu = row_size(r, 2), nt = row_size(r, 3);
    double *t = calloc(nt + 1, sizeof *t), *u = calloc(nu + 1, sizeof *u);
    bool ok = t != NULL && u != NULL;

    for (size_t i = 0; ok && i < nt; i++)
        t[i] = row_real(r, 4 + i);
    ok = ok && et_exact_knotrule_make(u, nu, p, t, nt, (et_knotrule_kind)row_size(r, 0)) == ET_OK;
    for (size_t i = p + 1; ok && i < nu - p - 1; i++)
        ok = row_is(r, i - p - 1, u[i]);
    free(t);
    free(u);
    return ok ? PASS : FAIL;
}
