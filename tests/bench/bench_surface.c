/* Items 1 and 2 of the speed goals: bicubic points at random parameters and on a grid, next to peers on the same input.
 * The residual is the greatest distance of the peer's sum of coordinates from ours, relative to it. */
#include "bench.h"
#include "etalon/base/real.h"
#include "etalon/spline/surface.h"
#include "surface_input.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    et_surface surface;
    et_vec3 *S;
    double *u, *v, *work;
    size_t n, nwork;
} job;

static double points(void *context)
{
    job *j = context;
    et_surface_points(j->S, &j->surface, j->u, j->v, j->n, j->work, j->nwork);
    return 0.0;
}

static double grid(void *context)
{
    job *j = context;
    return et_surface_grid(j->S, &j->surface, j->u, INPUT_GRID, j->u, INPUT_GRID) == ET_OK ? 0.0 : 1.0;
}

/* Every peer sums its coordinates so. */
static double total(const job *j, size_t n)
{
    return et_real_sum(&j->S[0].x, 3 * n);
}

/* The first peer is the one the goal is about: three times, and eight in the native build. */
static double goal(size_t k)
{
    return k > 0 ? 0.0 : bench_goal(3, 8);
}

static int table(const char *item, const char *size, double ours, double sum, const char *const *peer, size_t n)
{
    static const char *const interpreter[] = {"", "/usr/bin/python3 "};
    const char *bin = getenv("BENCH_BIN"), *src = getenv("BENCH_SRC");
    int met = 1;
    for (size_t k = 0; k < n; k++) {
        char command[512];
        bench_result r;
        int script = strstr(peer[k], ".py") != NULL;
        snprintf(command, sizeof command, "%s%s/%s", interpreter[script], script ? (src ? src : "tests/bench") : (bin ? bin : "."), peer[k]);
        if (!bench_peer(&r, command, item, size)) {
            bench_skip(item, size, peer[k]);
            continue;
        }
        met &= bench_row(item, size, r.version, r.seconds, ours, goal(k), fabs(r.residual - sum) / fabs(sum));
    }
    return met;
}

static int setup(job *j)
{
    surface_input in;
    surface_input_net(&in);
    if (et_surface_new(&j->surface, 3, 3, INPUT_SIDE, INPUT_SIDE, 0) != ET_OK) {
        return 0;
    }
    memcpy(j->surface.u, in.knots, sizeof in.knots);
    memcpy(j->surface.v, in.knots, sizeof in.knots);
    memcpy(j->surface.points, in.xyz, sizeof in.xyz);
    j->nwork = et_surface_work(&j->surface);
    j->work = calloc(j->nwork, sizeof *j->work);
    j->n = INPUT_POINTS;
    j->S = calloc(j->n, sizeof *j->S);
    return j->work && j->S;
}

int main(void)
{
    static const char *const peers1[] = {"peer_gsl_surface", "peer_sisl_surface", "peer_textbook_surface", "peer_occt"};
    static const char *const peers2[] = {"peer_scipy_surface.py", "peer_occt", "peer_textbook_surface"};
    job j = {.n = 0};
    if (!setup(&j) || !(j.u = surface_input_random(j.n, 0)) || !(j.v = surface_input_random(j.n, 1))) {
        fputs("bench_surface: out of memory\n", stderr);
        return 1;
    }
    bench_head();
    double seconds = bench_min(points, &j, 5, NULL) / (double)j.n;
    int met = table("surface_points", "20x20,1e7", seconds, total(&j, j.n), peers1, 4);
    free(j.u);
    free(j.v);
    j.v = NULL;
    if (!(j.u = surface_input_equal(INPUT_GRID))) {
        return 1;
    }
    j.n = (size_t)INPUT_GRID * INPUT_GRID;
    seconds = bench_min(grid, &j, 20, NULL) / (double)j.n;
    met &= table("surface_grid", "20x20,1000^2", seconds, total(&j, j.n), peers2, 3);
    printf("ours: %.3g ns a point on the grid; goals %s\n", 1e9 * seconds, met ? "met" : "NOT met");
    free(j.u);
    free(j.S);
    free(j.work);
    et_surface_free(&j.surface);
    return 0;
}
