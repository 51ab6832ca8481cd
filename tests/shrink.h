/* shrink: the simplest case that still fails. */
#ifndef TESTS_SHRINK_H
#define TESTS_SHRINK_H
#include "source.h"

typedef struct {
    bool (*fails)(void *context, gen *g);   /* runs the property on g, which has been given its values */
    void *context;
    gen *trial;                             /* where the candidates are run */
    size_t calls;                           /* budget: runs of the property ... */
    double seconds;                         /* ... and processor time */
    draw best[GEN_DRAWS];                   /* in: the failing case; out: the shrunk one, canonical */
    size_t nbest;
    span spans[GEN_SPANS];
    size_t nspans;
} shrinker;

/* Cases are ordered by number of draws, then draw by draw by value; every accepted step is strictly smaller, so that this ends. */
void shrink(shrinker *s);
#endif
