/* som_input: the input that every trainer gets, from its own generator, so that peers need nothing of ours. */
#ifndef TESTS_BENCH_SOM_INPUT_H
#define TESTS_BENCH_SOM_INPUT_H
#include <stddef.h>

enum { SOM_INPUT_SIDE = 20, SOM_INPUT_CLASSES = 724, SOM_INPUT_STEPS = 30000, SOM_INPUT_POINTS = 7082 };

/* The source's sphere of 59 rings of 120 points between its poles, in the unit cube (not rounded to decimals): 3 numbers a point. */
void som_input_cloud(double *xyz);

/* n numbers in [0,1) from a 32-bit xorshift; the same for the same seed. */
void som_input_uniform(double *x, size_t n, unsigned seed);
#endif
