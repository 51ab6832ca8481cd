/* quality: the honest quality of a trained net: over all points of a cloud, after training. */
#ifndef ETALON_SOM_QUALITY_H
#define ETALON_SOM_QUALITY_H
#include "etalon/som/som.h"
#ifdef __cplusplus
extern "C" {
#endif

/* quality over every point of the cloud in turn, each with its winner and second winner as in training (squared distances compared, ties to the
 * lowest class), nothing being moved: qe the mean distance of point and winner, te the share of points whose two winners are not
 * adjacent, steps = n.  The mean is summed as in training, by blocks of 4096: its relative error is below (18 + log2 n) u.
 * The numbers the source prints are means over the training steps instead (You 2023, Eqs. 4.15, 4.16) and about twice as large.
 * ET_EINVAL: no net, nov not its NOV, n == 0, a coordinate not finite or beyond 2^500.  ET_ENOMEM. */
/*@ requires quality:   \valid(quality);
    requires weights:   \valid_read(weights + (0 .. nov - 1));
    requires cloud:     \valid_read(cloud + (0 .. n - 1));
    requires separated: \separated(quality, weights + (0 .. nov - 1)) && \separated(quality, cloud + (0 .. n - 1));
    assigns *quality;
    ensures status:     \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures invalid:    \result == ET_EINVAL <==> !(et_net_ok(net.nx, net.ny) && nov == NOV(net.nx, net.ny) && n >= 1
                          && et_som_bounded(weights, nov) && et_som_bounded(cloud, n));
    ensures done:       \result == ET_OK ==> et_som_quality_ok(*quality);
    ensures steps:      \result == ET_OK ==> quality->steps == n;
    ensures unchanged:  \result != ET_OK ==> *quality == \old(*quality);
*/
et_status et_quality_of(et_som_quality *quality, const et_vec3 *weights, size_t nov, et_doublenet net, const et_vec3 *cloud, size_t n);

#ifdef __cplusplus
}
#endif
#endif
