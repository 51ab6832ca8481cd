#include "som_input.h"
#include <math.h>
#include <stdint.h>

void som_input_cloud(double *xyz)
{
    const double pi = 0x1.921fb54442d18p+1;
    size_t at = 0;

    for (int r = 0; r <= 60; r++) {
        const int sides = r == 0 || r == 60 ? 1 : 120;

        for (int s = 0; s < sides; s++) {
            xyz[at++] = 0.5 - 0.5 * sin(pi * r / 60) * sin(2 * pi * s / 120);
            xyz[at++] = 0.5 + 0.5 * cos(pi * r / 60);
            xyz[at++] = 0.5 - 0.5 * sin(pi * r / 60) * cos(2 * pi * s / 120);
        }
    }
}

void som_input_uniform(double *x, size_t n, unsigned seed)
{
    uint32_t s = (uint32_t)seed * 2654435761u + 1u;

    for (size_t i = 0; i < n; i++) {
        s ^= s << 13;
        s ^= s >> 17;
        s ^= s << 5;
        x[i] = s / 4294967296.0;
    }
}
