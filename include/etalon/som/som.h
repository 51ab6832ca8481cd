/* som: Kohonen's training loop over the classes of a double net (You 2023, section 4.2).
 *
 * Each class c has an index vector (i, j, k) in the net and a weight w_c, a point of space.  Step t = 1 .. T:
 *
 *     draw a point p of the cloud, uniformly and with replacement;
 *     winner: the class of least |p - w_c|, second: the least of the others;
 *     alpha(t) = alpha0 exp(-t/tau), sigma(t) = sigma0 exp(-t/tau), tau = T / ln sigma0                         (Eqs. 4.12-4.14)
 *     w_c += alpha(t) exp(-dist^2 / (2 sigma(t)^2)) (p - w_c)   for all c with dist < sigma(t) and K != 2       (Eqs. 4.10, 4.11)
 *
 * with dist^2 = I^2 + J^2 + K^2 between the index vectors of c and of the winner.  K = 2 is the opposite view's interior.
 *
 * What the bits depend on is settled here.  |p - w|^2 is ((dx*dx + dy*dy) + dz*dz), and classes are compared by it: equal ones go to the
 * lowest class.  The error of a step is its square root.  exp(-t/tau) is computed once a step and multiplies alpha0 and sigma0; dist < sigma is
 * dist^2 < sigma*sigma; the factor is alpha * exp(-(dist^2 / (2*(sigma*sigma)))).  A step draws one et_rng_index(rng, n).  The mean error is the
 * et_real_sum, over blocks of 4096 steps, of the blocks' own et_real_sum, divided by the number of steps.
 *
 * No sigma0 up to 1 reaches beyond the winner, and ln sigma0 <= 0 would make tau infinite or negative: for sigma0 in (0, 1], which includes the
 * default of a net with a side of 2, sigma stays at 1 and alpha at alpha0, and the winner alone moves.
 */
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
    double qe;                            /* mean distance of input and winner (Eq. 4.15) */
    double te;                            /* share of steps whose winner and second winner are not adjacent (Eq. 4.16) */
    double min_error, max_error;          /* least and greatest distance of input and winner */
    size_t steps;                         /* steps made: fewer than asked for only when stopped */
} et_som_quality;

/*@ predicate et_som_bounded(et_vec3 *p, integer n) = \forall integer i; 0 <= i < n ==> \is_finite(p[i].x) && \is_finite(p[i].y)
        && \is_finite(p[i].z) && \abs(p[i].x) <= 0x1p500 && \abs(p[i].y) <= 0x1p500 && \abs(p[i].z) <= 0x1p500;

    predicate et_som_options_ok(et_som_options o) =
        1 <= o.iterations && \is_finite(o.alpha0) && 0 < o.alpha0 <= 1 && \is_finite(o.sigma0) && 0 <= o.sigma0;

    predicate et_som_quality_ok(et_som_quality q) =
        1 <= q.steps && 0 <= q.te <= 1 && 0 <= q.min_error <= q.max_error && \is_finite(q.max_error) && \is_finite(q.qe) && 0 <= q.qe;
*/

/* The source's options: 30000 steps, alpha0 = 0.9, sigma0 = 0, which means min(nx, ny)/2. */
/*@ assigns \nothing;
    ensures steps: \result.iterations == 30000;
    ensures valid: et_som_options_ok(\result);
    ensures radius: \result.sigma0 == 0;
*/
et_som_options et_som_defaults(void);

/* Weights, nov of them (class c at c - 1): uniform in [0,1)^3, drawn x, y, z, class by class (You 2023, section 4.2.5). */
/*@ requires valid:    \valid(weights + (0 .. nov - 1));
    requires rng:      \valid(rng) && \separated(rng, weights + (0 .. nov - 1));
    assigns weights[0 .. nov - 1], *rng;
    ensures cube:      \forall integer c; 0 <= c < nov ==> 0 <= weights[c].x < 1 && 0 <= weights[c].y < 1 && 0 <= weights[c].z < 1;
*/
void et_som_start(et_vec3 *weights, size_t nov, et_rng *rng);

/* Train weights in place on the cloud of n points.  Deterministic in (weights, cloud, options, rng).
 * The callback of task is asked after steps 1000, 2000, ... before the last.
 * ET_EINVAL: no net, nov not its NOV, n == 0, options out of range, a coordinate not finite or beyond 2^500 (the cloud is meant to
 * lie in the unit cube).  ET_ENOMEM.  In both cases nothing is changed and nothing drawn.  Any status of the task: weights and quality are those
 * of the steps made.  What the callback writes of its own is not among what is assigned below: it has to be apart from
 * all that is given here (task.h).
 * Golden rows of class bits: trained weights of small nets. */
/*@ requires weights:   \valid(weights + (0 .. nov - 1));
    requires quality:   \valid(quality);
    requires cloud:     \valid_read(cloud + (0 .. n - 1));
    requires options:   \valid_read(options);
    requires task:      task == \null || \valid_read(task);
    requires rng:       \valid(rng);
    requires separated: \separated(weights + (0 .. nov - 1), quality, cloud + (0 .. n - 1), options, rng);
    assigns weights[0 .. nov - 1], *quality, *rng;
    ensures status:     task == \null ==> \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures invalid:    !(et_net_ok(net.nx, net.ny) && nov == NOV(net.nx, net.ny) && n >= 1 && \old(et_som_options_ok(*options))
                          && \old(et_som_bounded(weights, nov)) && \old(et_som_bounded(cloud, n))) ==> \result == ET_EINVAL;
    ensures done:       \result == ET_OK ==> et_som_quality_ok(*quality);
    ensures steps:      \result == ET_OK ==> quality->steps == options->iterations;
    ensures finite:     \result == ET_OK ==> et_som_bounded(weights, nov);
    ensures unchanged:  (\result == ET_EINVAL || \result == ET_ENOMEM) && task == \null ==>
                          (\forall integer c; 0 <= c < nov ==> weights[c] == \old(weights[c])) && *quality == \old(*quality);
*/
et_status et_som_train(et_vec3 *weights, size_t nov, et_som_quality *quality, et_doublenet net, const et_vec3 *cloud, size_t n,
                       const et_som_options *options, et_rng *rng, const et_task *task);

#ifdef __cplusplus
}
#endif
#endif
