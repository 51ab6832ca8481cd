/* The objective's evaluations next to the dense triple product of the source, and 80,040 evaluations of DE and PSO next to pagmo2, on one problem of
 * 580 x 3 coordinates.  The residual of the objective is the relative difference of the values; that of DE and PSO how much greater our best value is
 * than the peer's, relative to the gain of the peer over the start (negative: ours is better). */
#include "bench.h"
#include "etalon/refine/de.h"
#include "etalon/refine/objective.h"
#include "etalon/refine/pso.h"
#include "refine_input.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPEATS = 20000 };

typedef struct {
    et_objective *objective;
    double x[REFINE_N];
    et_search_step step;
    int like_pagmo;                       /* pso: the swarm's best at once, velocities lost at the box */
    int failed;
} job;

/* All coordinates change: every evaluation is full. */
static double full(void *context)
{
    job *j = context;
    double value = 0.0;
    for (int k = 0; k < REPEATS; k++) {
        for (size_t c = 0; c < REFINE_N; c += 12) j->x[c] += k % 2 ? -0x1p-40 : 0x1p-40;
        j->failed |= et_objective_eval(&value, j->x, REFINE_N, j->objective) != ET_OK;
    }
    return value;
}

/* One control point changes at a time. */
static double incremental(void *context)
{
    job *j = context;
    double value = 0.0;
    for (size_t k = 0; k < REPEATS; k++) {
        j->x[3 * (7 * k % REFINE_CLASSES)] += k % 2 ? -0x1p-40 : 0x1p-40;
        j->failed |= et_objective_eval(&value, j->x, REFINE_N, j->objective) != ET_OK;
    }
    return value;
}

static double search(void *context)
{
    job *j = context;
    et_search s;
    et_rng *rng = NULL;
    et_search_options o = et_search_defaults();
    size_t made = 0;
    double best = 0.0;
    o.group = 3;
    o.immediate = o.absorb = j->like_pagmo;
    if (et_rng_new(&rng, 1) != ET_OK || et_search_start(&s, j->x, REFINE_N, &o, 1, et_objective_eval, j->objective, rng) != ET_OK) {
        et_rng_free(rng);
        j->failed = 1;
        return 0.0;
    }
    j->failed |= et_search_run(&s, &made, NULL, 2000, j->step, rng, NULL) != ET_OK || s.evaluations != REFINE_EVALUATIONS;
    best = s.best_value;
    et_search_free(&s);
    et_rng_free(rng);
    return best;
}

static int make_objective(job *j, refine_input *in)
{
    et_fit fit;
    et_vec3 points[REFINE_CLASSES], data[REFINE_NOV];
    memset(&fit, 0, sizeof fit);
    fit.data = (et_doublenet){ REFINE_DATA, REFINE_DATA };
    if (et_shell_new(&fit.shell, 3, 3, (et_doublenet){ REFINE_CONTROL, REFINE_CONTROL }, 0) != ET_OK) return 0;
    for (size_t w = 0; w < 2; w++) {
        memcpy(fit.shell.view[w].u, in->knots, sizeof in->knots);
        memcpy(fit.shell.view[w].v, in->knots, sizeof in->knots);
        fit.s[w] = fit.r[w] = in->t;
    }
    memcpy(points, in->x0, sizeof points);
    memcpy(data, in->data, sizeof data);
    memcpy(j->x, in->x0, sizeof j->x);
    et_shell_scatter(&fit.shell, points, REFINE_CLASSES);
    const et_status status = et_objective_new(&j->objective, &fit, data, REFINE_NOV);
    et_shell_free(&fit.shell);
    return status == ET_OK;
}

static int peer(bench_result *r, const char *name, const char *item, const char *size)
{
    const char *bin = getenv("BENCH_BIN");
    char command[512];
    snprintf(command, sizeof command, "%s/%s", bin ? bin : ".", name);
    if (bench_peer(r, command, item, size)) return 1;
    bench_skip(item, size, name);
    return 0;
}

static int compare_search(job *j, const char *item, et_search_step step, double start)
{
    bench_result r;
    j->step = step;
    double best;
    const double seconds = bench_min(search, j, 2, &best);
    if (!peer(&r, "peer_pagmo", step == et_de_step ? "de" : "pso", "580x3,80040")) {
        printf("ours: %s %.3g s for 80,040 evaluations\n", item, seconds);
        return 1;
    }
    return bench_row(item, "580x3,80040", r.version, r.seconds, seconds, bench_goal(4, 8), (best - r.residual) / (start - r.residual));
}

int main(void)
{
    static refine_input in;
    static job j;
    bench_result r;
    double start = 0.0;
    int met = 1;
    refine_input_make(&in);
    if (!make_objective(&j, &in) || et_objective_eval(&start, j.x, REFINE_N, j.objective) != ET_OK) {
        fputs("bench_refine: no objective\n", stderr);
        return 1;
    }
    bench_head();
    const double seconds = bench_min(full, &j, 5, NULL) / REPEATS;
    if (peer(&r, "peer_dense", "objective", "20x20,18x18"))
        met &= bench_row("objective", "20x20,18x18", r.version, r.seconds, seconds, bench_goal(4, 8), fabs(r.residual - start) / start);
    const double part = bench_min(incremental, &j, 5, NULL) / REPEATS;
    if (peer(&r, "peer_dense", "objective", "20x20,18x18"))
        bench_row("objective, one point moved", "20x20,18x18", r.version, r.seconds, part, 0.0, 0.0);
    memcpy(j.x, in.x0, sizeof j.x);
    met &= compare_search(&j, "de", et_de_step, start);
    met &= compare_search(&j, "pso", et_pso_step, start);
    j.like_pagmo = 1;
    met &= compare_search(&j, "pso, immediate and absorb", et_pso_step, start);
    printf("ours: %.0f evaluations a second in full, %.0f with one point moved; goals %s\n", 1.0 / seconds, 1.0 / part, met ? "met" : "NOT met");
    et_objective_free(j.objective);
    return j.failed;
}
