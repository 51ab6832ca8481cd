#include "eva.h"
#include "etalon/som/quality.h"
#include "etalon/som/som.h"

enum { NX = 3, NY = 4, NOV = 2 * NX * NY - 2 * (NX + NY) + 4 };

static et_status step(void *context, size_t done, size_t total)
{
    return *(int *)context ? ET_ESTOPPED : ET_OK;
}

void eva_som(void)    /* eva: -eva-slevel 100 */
{
    et_rng *rng;
    et_vec3 weights[NOV], cloud[5];
    et_som_quality quality;
    const et_doublenet net = {NX, NY};
    int stop = Frama_C_interval(0, 1);
    const et_task task = {step, &stop};
    et_som_options o = et_som_defaults();

    o.iterations = 3;
    any_memory();
    fill(&cloud[0].x, 15);
    if (et_rng_new(&rng, 1) != ET_OK)
        return;
    et_som_start(weights, NOV, rng);
    et_som_train(weights, NOV, &quality, net, cloud, 5, &o, rng, &task);
    et_rng_free(rng);
}

void eva_quality(void)    /* eva: -eva-slevel 100 */
{
    et_vec3 weights[NOV], cloud[5];
    et_som_quality quality;
    const et_doublenet net = {NX, NY};

    any_memory();
    fill(&weights[0].x, 3 * NOV);
    fill(&cloud[0].x, 15);
    et_quality_of(&quality, weights, NOV, net, cloud, 5);
}
