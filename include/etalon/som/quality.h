/* quality: the honest quality of a trained net: over all points of a cloud, after training (spec section 3). */
#ifndef ETALON_SOM_QUALITY_H
#define ETALON_SOM_QUALITY_H
#include "etalon/som/som.h"
#ifdef __cplusplus
extern "C" {
#endif

/* quality over every point of the cloud (steps = n).  Ties go to the lowest class.  ET_EINVAL, ET_ENOMEM. */
et_status et_quality_of(et_som_quality *quality, const et_vec3 *weights, size_t nov, et_doublenet net, const et_vec3 *cloud, size_t n);

#ifdef __cplusplus
}
#endif
#endif
