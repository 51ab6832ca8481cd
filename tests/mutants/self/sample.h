#ifndef SAMPLE_H
#define SAMPLE_H
#include <stddef.h>

size_t et_sample_find(const int *x, size_t n, int wanted);
int et_sample_clamp(int x, int lo, int hi);
double et_sample_mean(const double *x, size_t n);
int et_sample_untested(int a);
#endif
