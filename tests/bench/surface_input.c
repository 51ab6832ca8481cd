#include "surface_input.h"
#include <stdint.h>
#include <stdlib.h>

static double random53(uint64_t k)
{
    uint64_t z = (k + 1) * UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

void surface_input_net(surface_input *in)
{
    for (size_t k = 0; k < INPUT_KNOTS; k++) {
        double t = ((double)k - 3.0) / (double)(INPUT_SIDE - 3);
        in->knots[k] = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    }
    for (size_t i = 0; i < INPUT_SIDE; i++) {
        for (size_t j = 0; j < INPUT_SIDE; j++) {
            double *P = in->xyz + 3 * (i * INPUT_SIDE + j);
            P[0] = (double)i / (INPUT_SIDE - 1);
            P[1] = (double)j / (INPUT_SIDE - 1);
            P[2] = random53(UINT64_C(1) << 40 | (uint64_t)(i * INPUT_SIDE + j));
        }
    }
}

double surface_input_parameter(size_t k, int direction)
{
    return random53(2 * (uint64_t)k + (uint64_t)direction);
}

double *surface_input_random(size_t n, int direction)
{
    double *x = malloc((n + 1) * sizeof *x);
    for (size_t k = 0; x && k < n; k++) {
        x[k] = surface_input_parameter(k, direction);
    }
    return x;
}

double *surface_input_equal(size_t n)
{
    double *x = malloc((n + 1) * sizeof *x);
    for (size_t k = 0; x && k < n; k++) {
        x[k] = (double)k / (double)(n - 1);
    }
    return x;
}
