/* surface_peer: what the C peers of the surface benchmarks share: the two items, and the line they print. */
#ifndef TESTS_SURFACE_PEER_H
#define TESTS_SURFACE_PEER_H
#include "bench.h"
#include "surface_input.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __cplusplus
extern "C" {
#endif

/* One point of the surface; S[0..2]. */
typedef void (*surface_peer_fn)(double *S, void *context, double u, double v);

typedef struct { surface_peer_fn point; void *context; double *u, *v, *S; size_t n; int grid; } surface_peer_job;

static inline double surface_peer_pass(void *context)
{
    surface_peer_job *j = (surface_peer_job *)context;
    for (size_t k = 0; k < j->n; k++) {
        j->point(j->S + 3 * k, j->context, j->u[j->grid ? k / INPUT_GRID : k], j->v[j->grid ? k % INPUT_GRID : k]);
    }
    return 0.0;
}

/* The number of points of an item; 0 if it is not known. */
static inline size_t surface_peer_count(const char *item)
{
    return strcmp(item, "surface_points") == 0 ? (size_t)INPUT_POINTS : strcmp(item, "surface_grid") == 0 ? (size_t)INPUT_GRID * INPUT_GRID : 0;
}

/* Times the item and prints the version, the seconds a point and the sum of all coordinates; the exit status of main. */
static inline int surface_peer_run(const char *version, const char *item, surface_peer_fn point, void *context)
{
    size_t n = surface_peer_count(item);
    int grid = strcmp(item, "surface_grid") == 0;
    double *S = n ? (double *)calloc(3 * n, sizeof *S) : NULL;
    double *u = grid ? surface_input_equal(INPUT_GRID) : surface_input_random(n, 0), *v = grid ? u : surface_input_random(n, 1), sum = 0.0;
    if (!S || !u || !v) {
        return 1;
    }
    surface_peer_job j = {point, context, u, v, S, n, grid};
    double seconds = bench_min(surface_peer_pass, &j, grid ? 5 : 2, NULL);
    for (size_t k = 0; k < 3 * n; k++) {
        sum += S[k];
    }
    printf("%s %.17g %.17g\n", version, seconds / (double)n, sum);
    return 0;
}

#ifdef __cplusplus
}
#endif
#endif
