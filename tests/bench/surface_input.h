/* surface_input: the one input of all surface benchmarks: a bicubic 20 x 20 net, clamped uniform knots, and random parameters. */
#ifndef TESTS_SURFACE_INPUT_H
#define TESTS_SURFACE_INPUT_H
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

enum { INPUT_SIDE = 20, INPUT_KNOTS = INPUT_SIDE + 4, INPUT_GRID = 1000, INPUT_POINTS = 10000000 };

typedef struct { double knots[INPUT_KNOTS], xyz[3 * INPUT_SIDE * INPUT_SIDE]; } surface_input;

/* Control point (i, j), i along u, at xyz[3 * (i*INPUT_SIDE + j)]. */
void surface_input_net(surface_input *in);

/* The k-th of the random parameters of direction 0 (u) or 1 (v): splitmix64 of 2k + direction, 53 bits. */
double surface_input_parameter(size_t k, int direction);

/* n random parameters of a direction, or n equally spaced ones; null if memory is short. */
double *surface_input_random(size_t n, int direction);
double *surface_input_equal(size_t n);

#ifdef __cplusplus
}
#endif
#endif
