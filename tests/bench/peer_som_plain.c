/* peer_som_plain ITEM SIZE: double-net training as one writes it in C: an array of structs, every class looked at twice a step, one exp for each
 * class that moves.  Compiled with -O2 in every build.  Prints `c99-O2 SECONDS QE`: the least of five trainings' times, the mean error during
 * training. */
#include "bench.h"
#include "som_input.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    double x, y, z;
    int i, j, k;
} neuron;

static neuron neurons[SOM_INPUT_CLASSES];
static double cloud[3 * SOM_INPUT_POINTS], start[3 * SOM_INPUT_CLASSES];

static int on_border(int i, int j)
{
    return i == 0 || j == 0 || i == SOM_INPUT_SIDE - 1 || j == SOM_INPUT_SIDE - 1;
}

static void setup(void)
{
    int c = 0;

    for (int k = 0; k <= 2; k += 2)
        for (int i = 0; i < SOM_INPUT_SIDE; i++)
            for (int j = 0; j < SOM_INPUT_SIDE; j++)
                if (k == 0 || !on_border(i, j)) {
                    neurons[c].i = i;
                    neurons[c].j = j;
                    neurons[c++].k = on_border(i, j) ? 1 : k;
                }
    for (c = 0; c < SOM_INPUT_CLASSES; c++) {
        neurons[c].x = start[3 * c];
        neurons[c].y = start[3 * c + 1];
        neurons[c].z = start[3 * c + 2];
    }
}

static double train(void *context)
{
    const double alpha0 = 0.9, sigma0 = SOM_INPUT_SIDE / 2.0, tau = SOM_INPUT_STEPS / log(sigma0);
    uint32_t state = 88172645u;
    double error = 0;

    (void)context;
    setup();
    for (int t = 1; t <= SOM_INPUT_STEPS; t++) {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        const double *p = cloud + 3 * (state % SOM_INPUT_POINTS);
        const double alpha = alpha0 * exp(-t / tau), sigma = sigma0 * exp(-t / tau);
        double first = HUGE_VAL, second = HUGE_VAL;
        int winner = 0;

        for (int c = 0; c < SOM_INPUT_CLASSES; c++) {
            const neuron *n = &neurons[c];
            const double x = p[0] - n->x, y = p[1] - n->y, z = p[2] - n->z, d = x * x + y * y + z * z;

            if (d < first) {
                second = first;
                first = d;
                winner = c;
            } else if (d < second)
                second = d;
        }
        error += sqrt(first);
        for (int c = 0; c < SOM_INPUT_CLASSES; c++) {
            neuron *n = &neurons[c];
            const int i = n->i - neurons[winner].i, j = n->j - neurons[winner].j, k = n->k - neurons[winner].k, d = i * i + j * j + k * k;

            if (d < sigma * sigma && k != 2 && k != -2) {
                const double f = alpha * exp(-d / (2 * sigma * sigma));

                n->x += f * (p[0] - n->x);
                n->y += f * (p[1] - n->y);
                n->z += f * (p[2] - n->z);
            }
        }
    }
    return error / SOM_INPUT_STEPS;
}

int main(void)
{
    double residual, seconds;

    som_input_cloud(cloud);
    som_input_uniform(start, sizeof start / sizeof *start, 1);
    seconds = bench_min(train, NULL, 5, &residual);
    printf("c99-O2 %.9g %.17g\n", seconds, residual);
    return 0;
}
