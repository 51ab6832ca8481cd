/* ascending: a few numbers put in order. */
#ifndef TESTS_ASCENDING_H
#define TESTS_ASCENDING_H
#include <stddef.h>

static inline void ascending(double *x, size_t n)
{
    for (size_t i = 1; i < n; i++)
        for (size_t j = i; j > 0 && x[j] < x[j - 1]; j--) {
            const double t = x[j];
            x[j] = x[j - 1];
            x[j - 1] = t;
        }
}
#endif
