/* A banded Cholesky factorisation in square tiles, so that a plain compiler's code is quick; the order of all operations is fixed. */
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = OPTIMUM_SIDE, AREA = SIDE * SIDE };

et_status optimum_band_new(optimum_band *band, size_t n, size_t half)
{
    size_t count = 0;

    band->n = n;
    band->tiles = n / SIDE + (n % SIDE != 0);
    band->width = half / SIDE + (half % SIDE != 0);
    if (band->width >= band->tiles)
        band->width = band->tiles == 0 ? 0 : band->tiles - 1;
    band->tile = NULL;
    if (et_size_mul(&count, band->tiles, band->width + 1) == ET_OK && et_size_mul(&count, count, AREA) == ET_OK)
        band->tile = et_size_array(count, sizeof(double));
    return band->tile == NULL ? ET_ENOMEM : ET_OK;
}

void optimum_band_free(optimum_band *band)
{
    free(band->tile);
    band->tile = NULL;
}

static double *tile_at(const optimum_band *band, size_t I, size_t J)
{
    return band->tile + (I * (band->width + 1) + (I - J)) * AREA;
}

void optimum_band_clear(optimum_band *band)
{
    memset(band->tile, 0, band->tiles * (band->width + 1) * AREA * sizeof *band->tile);
    for (size_t i = band->n; i < band->tiles * SIDE; i++)
        *optimum_band_at(band, i, i) = 1;
}

double *optimum_band_at(const optimum_band *band, size_t i, size_t j)
{
    return tile_at(band, i / SIDE, j / SIDE) + j % SIDE * SIDE + i % SIDE;
}

/* C -= A B': a column of C stays in registers while four columns of A pass. */
static void subtract(double *restrict C, const double *restrict A, const double *restrict B)
{
    for (size_t c = 0; c < SIDE; c++) {
        double s[SIDE];

        for (size_t i = 0; i < SIDE; i++)
            s[i] = C[c * SIDE + i];
        for (size_t k = 0; k < SIDE; k += 4) {
            const double *restrict a = A + k * SIDE, *restrict b = B + k * SIDE + c;
            const double b0 = b[0], b1 = b[SIDE], b2 = b[2 * SIDE], b3 = b[3 * SIDE];

            for (size_t i = 0; i < SIDE; i++)
                s[i] -= ((a[i] * b0 + a[SIDE + i] * b1) + a[2 * SIDE + i] * b2) + a[3 * SIDE + i] * b3;
        }
        for (size_t i = 0; i < SIDE; i++)
            C[c * SIDE + i] = s[i];
    }
}

/* The diagonal tile.  given: its diagonal before anything was subtracted. */
static void factor_tile(double *T, const double *given, unsigned char *poor)
{
    for (size_t k = 0; k < SIDE; k++) {
        double *const column = T + k * SIDE;

        if (poor != NULL && !(column[k] > given[k] * 0x1p-44)) {
            poor[k] = 1;
            column[k] = given[k] > 0 ? given[k] * 0x1p+200 : 1;
        } else if (!(column[k] > given[k] * 0x1p-48)) {
            column[k] = given[k] > 0 ? given[k] * 0x1p-48 : 1;
        }
        column[k] = sqrt(column[k]);
        for (size_t i = k + 1; i < SIDE; i++)
            column[i] /= column[k];
        for (size_t j = k + 1; j < SIDE; j++)
            for (size_t i = j; i < SIDE; i++)
                T[j * SIDE + i] -= column[i] * column[j];
    }
}

/* C = C L'^-1. */
static void divide(double *restrict C, const double *restrict L)
{
    for (size_t k = 0; k < SIDE; k++) {
        for (size_t i = 0; i < SIDE; i++)
            C[k * SIDE + i] /= L[k * SIDE + k];
        for (size_t j = k + 1; j < SIDE; j++)
            for (size_t i = 0; i < SIDE; i++)
                C[j * SIDE + i] -= C[k * SIDE + i] * L[k * SIDE + j];
    }
}

void optimum_band_factor(optimum_band *band, unsigned char *poor)
{
    for (size_t J = 0; J < band->tiles; J++) {
        const size_t last = J + band->width < band->tiles ? J + band->width : band->tiles - 1;
        double given[SIDE];

        for (size_t k = 0; k < SIDE; k++)
            given[k] = tile_at(band, J, J)[k * SIDE + k];
        for (size_t I = J; I <= last; I++) {
            for (size_t K = I > band->width ? I - band->width : 0; K < J; K++)
                subtract(tile_at(band, I, J), tile_at(band, I, K), tile_at(band, J, K));
            if (I == J)
                factor_tile(tile_at(band, J, J), given, poor == NULL ? NULL : poor + J * SIDE);
            else
                divide(tile_at(band, I, J), tile_at(band, J, J));
        }
    }
}

size_t optimum_band_work(const optimum_band *band)
{
    return band->tiles * SIDE;
}

static void forward(const optimum_band *band, double *x)
{
    for (size_t J = 0; J < band->tiles; J++) {
        const double *const L = tile_at(band, J, J);
        double *const a = x + J * SIDE;

        for (size_t k = 0; k < SIDE; k++) {
            a[k] /= L[k * SIDE + k];
            for (size_t i = k + 1; i < SIDE; i++)
                a[i] -= L[k * SIDE + i] * a[k];
        }
        for (size_t I = J + 1; I < band->tiles && I <= J + band->width; I++) {
            const double *const T = tile_at(band, I, J);

            for (size_t k = 0; k < SIDE; k++)
                for (size_t i = 0; i < SIDE; i++)
                    x[I * SIDE + i] -= T[k * SIDE + i] * a[k];
        }
    }
}

static void backward(const optimum_band *band, double *x)
{
    for (size_t J = band->tiles; J-- > 0;) {
        const double *const L = tile_at(band, J, J);
        double *const a = x + J * SIDE;

        for (size_t I = J + 1; I < band->tiles && I <= J + band->width; I++) {
            const double *const T = tile_at(band, I, J), *const b = x + I * SIDE;

            for (size_t k = 0; k < SIDE; k += 4) {          /* four sums at once: each waits for itself */
                const double *const t = T + k * SIDE;
                double s0 = 0, s1 = 0, s2 = 0, s3 = 0;

                for (size_t i = 0; i < SIDE; i++) {
                    s0 += t[i] * b[i];
                    s1 += t[SIDE + i] * b[i];
                    s2 += t[2 * SIDE + i] * b[i];
                    s3 += t[3 * SIDE + i] * b[i];
                }
                a[k] -= s0;
                a[k + 1] -= s1;
                a[k + 2] -= s2;
                a[k + 3] -= s3;
            }
        }
        for (size_t k = SIDE; k-- > 0;) {
            for (size_t i = k + 1; i < SIDE; i++)
                a[k] -= L[k * SIDE + i] * a[i];
            a[k] /= L[k * SIDE + k];
        }
    }
}

void optimum_band_solve(const optimum_band *band, double *x, size_t stride, double *work)
{
    memset(work, 0, optimum_band_work(band) * sizeof *work);
    for (size_t i = 0; i < band->n; i++)
        work[i] = x[i * stride];
    forward(band, work);
    backward(band, work);
    for (size_t i = 0; i < band->n; i++)
        x[i * stride] = work[i];
}
