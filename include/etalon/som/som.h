/* som: Kohonen's training loop, over any net given by its classes' index vectors (You 2023, section 4.2; spec section 3). */
#ifndef ETALON_SOM_SOM_H
#define ETALON_SOM_SOM_H
#include "etalon/base/rng.h"
#include "etalon/base/status.h"
#include "etalon/base/task.h"
#include "etalon/base/vec3.h"
#include "etalon/net/doublenet.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    size_t iterations;                    /* T >= 1, default 30000 */
    double alpha0;                        /* initial learning rate in (0, 1], default 0.9 */
    double sigma0;                        /* initial radius; 0 (default) means min(nx, ny) / 2 */
} et_som_options;

/* What the source measures while it trains, over the steps, before each update. */
typedef struct {
    double qe;                            /* mean distance of input and winner */
    double te;                            /* share of steps whose winner and second winner are not adjacent */
    double min_error, max_error;          /* least and greatest distance of input and winner */
    size_t steps;                         /* steps made: fewer than asked for only when stopped */
} et_som_quality;

et_som_options et_som_defaults(void);

/* Weights, NOV of them (class c at c - 1): uniform in [0,1)^3, drawn x, y, z, class by class. */
void et_som_start(et_vec3 *weights, size_t nov, et_rng *rng);

/* Train weights in place on the cloud of n points.  Deterministic in (weights, cloud, options, rng).
 * ET_EINVAL, ET_ENOMEM (weights unchanged); ET_ESTOPPED: weights and quality are those of the steps made. */
et_status et_som_train(et_vec3 *weights, size_t nov, et_som_quality *quality, et_doublenet net, const et_vec3 *cloud, size_t n,
                       const et_som_options *options, et_rng *rng, const et_task *task);

#ifdef __cplusplus
}
#endif
#endif
