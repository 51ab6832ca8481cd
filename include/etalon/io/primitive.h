/* primitive: the source's four clouds, regenerated point by point (spec section 1; You 2023, Table 3.1), and at any other size; noise and outliers. */
#ifndef ETALON_IO_PRIMITIVE_H
#define ETALON_IO_PRIMITIVE_H
#include "etalon/base/rng.h"
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef enum { ET_PRIMITIVE_CUBE = 0, ET_PRIMITIVE_SPHERE, ET_PRIMITIVE_SPINDLE, ET_PRIMITIVE_OILTANK } et_primitive_kind;
const char *et_primitive_name(et_primitive_kind kind);

/* Resolution: cube a lattice of n x n x n (a = n, b unused, 36); the others a rings between the poles of b points (sphere 59 x 120,
 * spindle 151 x 50, oiltank 99 x 60).  a = b = 0: the source's. */
et_status et_primitive_count(size_t *count, et_primitive_kind kind, size_t a, size_t b);
et_status et_primitive_make(et_vec3 *points, size_t count, et_primitive_kind kind, size_t a, size_t b);

/* Add N(0, sigma^2) to every coordinate, and replace round(fraction * count) distinct points by uniform ones in the box [-0.1, 1.1]^3. */
et_status et_primitive_disturb(et_vec3 *points, size_t count, double sigma, double fraction, et_rng *rng);

#ifdef __cplusplus
}
#endif
#endif
