/* Training of a double net of 20 x 20 (724 classes), 30000 steps: next to a plain loop in C and to R's kohonen.  The column of residuals is the
 * relative difference of the quantisation errors: another generator draws the points, so that it is a matter of per cent (kohonen trains another
 * map). */
#include "bench.h"
#include "etalon/som/som.h"
#include "som_input.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    et_vec3 *cloud, *start, *weights;
    et_rng *rng;
} job;

static double train(void *context)
{
    job *j = context;
    const et_doublenet net = {SOM_INPUT_SIDE, SOM_INPUT_SIDE};
    const et_som_options options = et_som_defaults();
    et_som_quality q = {0};

    et_rng_seek(j->rng, 0);
    for (size_t c = 0; c < SOM_INPUT_CLASSES; c++)
        j->weights[c] = j->start[c];
    if (et_som_train(j->weights, SOM_INPUT_CLASSES, &q, net, j->cloud, SOM_INPUT_POINTS, &options, j->rng, NULL))
        return NAN;
    return q.qe;
}

int main(void)
{
    static const char *const peer[] = {"peer_som_plain", "peer_kohonen.R"};
    const double goal[] = {bench_goal(3, 8), 0};
    const char *bin = getenv("BENCH_BIN"), *src = getenv("BENCH_SRC");
    static et_vec3 cloud[SOM_INPUT_POINTS], start[SOM_INPUT_CLASSES], weights[SOM_INPUT_CLASSES];
    job j = {cloud, start, weights, NULL};
    double seconds, qe;
    int met = 1;

    if (et_rng_new(&j.rng, 1)) {
        fputs("bench_som: out of memory\n", stderr);
        return 1;
    }
    som_input_cloud(&cloud[0].x);
    som_input_uniform(&start[0].x, 3 * SOM_INPUT_CLASSES, 1);
    bench_head();
    seconds = bench_min(train, &j, 20, &qe);
    for (size_t k = 0; k < 2; k++) {
        char command[512];
        bench_result r;

        snprintf(command, sizeof command, "%s%s/%s", k == 1 ? "Rscript --vanilla " : "", k == 1 ? (src ? src : "tests/bench") : (bin ? bin : "."),
                 peer[k]);
        if (bench_peer(&r, command, "som_train", "724x30000"))
            met &= bench_row("som_train", "724x30000", r.version, r.seconds, seconds, goal[k], fabs(r.residual - qe) / qe);
        else
            bench_skip("som_train", "724x30000", peer[k]);
    }
    printf("ours: %.4f s a training; goals %s\n", seconds, met ? "met" : "NOT met");
    et_rng_free(j.rng);
    return 0;
}
