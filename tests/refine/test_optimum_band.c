#include "etalon/refine/optimum.h"
#include "gen.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The band's Cholesky factor computed a second time on a full matrix, number by number: each entry is what its row and column leave of it. */
enum { SIDE = OPTIMUM_SIDE, MOST = 4 * SIDE };

typedef struct {
    size_t n, half, rows, width;          /* rows: with those that fill the last tile */
    double a[MOST][MOST];
    unsigned char poor[MOST];
} full;

static bool alike(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

static double hashed(size_t *seed)
{
    *seed = (*seed * 1103515245u + 12345u) & 0x7fffffffu;
    return (double)(*seed >> 7) * 0x1p-23 - 1;
}

/* Pairs of rows of which the second is all but the first, each at a scale of its own; some rows empty or negative. */
static void pairs(gen *g, full *f)
{
    static const double rest[] = { 1, 0x1p-44, 0x1p-44 + 0x1p-52, 0x1p-45, 0x1p-47, 0x1p-48, 0x1p-48 + 0x1p-52, 0, -0x1p-52 };
    size_t seed = gen_upto(g, 0xffffff);

    for (size_t i = gen_upto(g, 1); i + 1 < f->n; i += 2) {
        const double scale = ldexp(1, 2 * (int)(4 * hashed(&seed)));
        const size_t which = (size_t)(5.5 * (1 + hashed(&seed)));

        if (which > 8) {
            f->a[i][i] = which == 9 ? 0 : -scale;
            f->a[i + 1][i + 1] = 0.25;
        } else {
            f->a[i][i] = f->a[i + 1][i] = scale;
            f->a[i + 1][i + 1] = scale * (1 + rest[which]);
        }
    }
}

static void filled(gen *g, full *f)
{
    const double diagonal = gen_upto(g, 3) == 3 ? 0.5 : (double)(2 * f->half + 1);
    size_t seed = gen_upto(g, 0xffffff);

    for (size_t i = 0; i < f->n; i++) {
        for (size_t j = i > f->half ? i - f->half : 0; j < i; j++)
            f->a[i][j] = hashed(&seed);
        f->a[i][i] = diagonal * (1.5 + hashed(&seed));
    }
}

static void draw(gen *g, full *f)
{
    memset(f, 0, sizeof *f);
    f->n = gen_upto(g, 3) == 3 ? SIDE * gen_between(g, 1, 3) : gen_between(g, 1, MOST - 12);
    f->half = gen_upto(g, 3) == 3 ? SIDE * gen_between(g, 1, 3) : gen_between(g, 1, 40);
    f->rows = (f->n + SIDE - 1) / SIDE * SIDE;
    f->width = (f->half + SIDE - 1) / SIDE;
    if (f->width > f->rows / SIDE - 1)
        f->width = f->rows / SIDE - 1;
    if (gen_upto(g, 1))
        filled(g, f);
    else
        pairs(g, f);
    for (size_t i = f->n; i < f->rows; i++)
        f->a[i][i] = 1;
}

/* What a pivot that was `given` becomes when x is left of it. */
static double pivot(double x, double given, unsigned char *poor)
{
    if (poor != NULL && !(x > given / 0x1p44)) {
        *poor = 1;
        return given > 0 ? ldexp(given, 200) : 1;
    }
    return x > given / 0x1p48 ? x : given > 0 ? ldexp(given, -48) : 1;
}

/* Entry (i, j), i >= j: whole tiles four columns at a time, then columns one by one. */
static void entry(full *f, size_t i, size_t j, bool watched)
{
    const size_t I = i / SIDE, J = j / SIDE;
    const double given = f->a[j][j];
    double x = f->a[i][j];

    for (size_t k = I > f->width ? (I - f->width) * SIDE : 0; k < J * SIDE; k += 4) {
        double s = f->a[i][k] * f->a[j][k];

        for (size_t l = k + 1; l < k + 4; l++)
            s += f->a[i][l] * f->a[j][l];
        x -= s;
    }
    for (size_t k = J * SIDE; k < j; k++)
        x -= f->a[i][k] * f->a[j][k];
    f->a[i][j] = i == j ? sqrt(pivot(x, given, watched ? &f->poor[j] : NULL)) : x / f->a[j][j];
}

static void factor(full *f, bool watched)
{
    for (size_t j = 0; j < f->rows; j++)
        for (size_t i = j; i < f->rows && i / SIDE - j / SIDE <= f->width; i++)
            entry(f, i, j, watched);
}

static void solve(double *x, const full *f)
{
    for (size_t k = 0; k < f->rows; k++) {
        x[k] /= f->a[k][k];
        for (size_t i = k + 1; i < f->rows && i / SIDE - k / SIDE <= f->width; i++)
            x[i] -= f->a[i][k] * x[k];
    }
    for (size_t k = f->rows; k-- > 0;) {
        for (size_t from = k - k % SIDE + SIDE; from < f->rows && from / SIDE - k / SIDE <= f->width; from += SIDE) {
            double s = 0;

            for (size_t i = from; i < from + SIDE; i++)
                s += f->a[i][k] * x[i];
            x[k] -= s;
        }
        for (size_t i = k + 1; i < k - k % SIDE + SIDE; i++)
            x[k] -= f->a[i][k] * x[i];
        x[k] /= f->a[k][k];
    }
}

/* A band made dirty, cleared, and filled. */
static bool laid(gen *g, optimum_band *band, const full *f)
{
    bool ok = gen_check(g, optimum_band_new(band, f->n, f->half) == ET_OK, "no band");
    size_t count;

    ok = ok && gen_check(g, band->n == f->n && band->tiles * SIDE == f->rows && band->width == f->width, "%zu rows, %zu beside the diagonal: %zu, %zu",
                         f->n, f->half, band->tiles, band->width);
    ok = ok && gen_check(g, optimum_band_work(band) == f->rows, "work");
    if (!ok)
        return false;
    count = band->tiles * (band->width + 1) * SIDE * SIDE;
    for (size_t k = 0; k < count; k++)
        band->tile[k] = NAN;
    optimum_band_clear(band);
    for (size_t i = f->n; i < f->rows; i++) {
        ok = ok && gen_check(g, *optimum_band_at(band, i, i) == 1, "row %zu of %zu is not filled up", i, f->n);
        *optimum_band_at(band, i, i) = 0;
    }
    for (size_t k = 0; k < count && ok; k++)
        ok = gen_check(g, alike(band->tile[k], 0), "not clear");
    for (size_t i = 0; i < f->rows; i++)
        for (size_t j = 0; j <= i; j++)
            if (i / SIDE - j / SIDE <= f->width)
                *optimum_band_at(band, i, j) = f->a[i][j];
    return ok;
}

/* One case in 2. */
verdict prop_optimum_find_band(gen *g)
{
    full f;
    optimum_band band = { 0, 0, 0, NULL };
    unsigned char poor[MOST] = { 0 };
    double x[MOST] = { 0 }, strided[3 * MOST], work[MOST];
    size_t seed = 77;
    bool watched, ok;

    draw(g, &f);
    watched = gen_upto(g, 1);
    ok = laid(g, &band, &f);
    for (size_t i = 0; i < MOST; i++) {
        work[i] = NAN;
        strided[3 * i] = strided[3 * i + 1] = strided[3 * i + 2] = 9;
        if (i < f.n)
            x[i] = strided[3 * i + 1] = hashed(&seed);
    }
    factor(&f, watched);
    if (ok)
        optimum_band_factor(&band, watched ? poor : NULL);
    for (size_t i = 0; i < f.rows && ok; i++) {
        ok = gen_check(g, poor[i] == f.poor[i], "row %zu: poor %d, not %d", i, poor[i], f.poor[i]);
        for (size_t j = 0; j <= i && ok; j++)
            if (i / SIDE - j / SIDE <= f.width)
                ok = gen_check(g, alike(*optimum_band_at(&band, i, j), f.a[i][j]), "factor's %zu, %zu of %zu: %a, not %a", i, j, f.n,
                               *optimum_band_at(&band, i, j), f.a[i][j]);
    }
    solve(x, &f);
    if (ok)
        optimum_band_solve(&band, strided + 1, 3, work);
    for (size_t i = 0; i < f.n && ok; i++)
        ok = gen_check(g, alike(strided[3 * i + 1], x[i]) && strided[3 * i] == 9 && strided[3 * i + 2] == 9, "x %zu: %a, not %a", i, strided[3 * i + 1], x[i]);
    optimum_band_free(&band);
    ok = ok && gen_check(g, band.tile == NULL, "a freed band has tiles");
    return ok ? PASS : FAIL;
}

/* Of no rows; of more than can be. */
/* One case in 100. */
verdict prop_optimum_find_band_sizes(gen *g)
{
    optimum_band band;
    bool ok = gen_check(g, optimum_band_new(&band, 0, 0) == ET_OK || band.tile == NULL, "a band of no rows");

    ok = ok && gen_check(g, band.tiles == 0 && band.width == 0, "tiles of no rows");
    optimum_band_free(&band);
    ok = ok && gen_check(g, optimum_band_new(&band, SIZE_MAX / 2, SIZE_MAX / 2) == ET_ENOMEM && band.tile == NULL, "a band too large");
    optimum_band_free(&band);
    return ok ? PASS : FAIL;
}
