/* vec3: points and vectors of space. */
#ifndef ETALON_BASE_VEC3_H
#define ETALON_BASE_VEC3_H
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { double x, y, z; } et_vec3;

/* sqrt((ax-bx)^2 + (ay-by)^2 + (az-bz)^2), the squares added in this order; at most 3.5u relative error barring
 * overflow and underflow of the squares. */
double et_vec3_distance(et_vec3 a, et_vec3 b);

/* Not one coordinate of the n points is NaN or infinite. */
int et_vec3_finite(const et_vec3 *points, size_t n);

#ifdef __cplusplus
}
#endif
#endif
