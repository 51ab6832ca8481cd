/* vec3: points and vectors of space. */
#ifndef ETALON_BASE_VEC3_H
#define ETALON_BASE_VEC3_H
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { double x, y, z; } et_vec3;

/* sqrt((ax-bx)^2 + (ay-by)^2 + (az-bz)^2), the squares added in this order; relative error at most 3.5u to first order barring
 * overflow and underflow of the squares: a difference's rounding counts once under the root, a square's half, two additions, and the root itself. */
/*@ requires finite: \is_finite(a.x) && \is_finite(a.y) && \is_finite(a.z) && \is_finite(b.x) && \is_finite(b.y) && \is_finite(b.z);
    assigns  \nothing;
    ensures  range:  \is_plus_infinity(\result) || \result >= 0.0;
*/
double et_vec3_distance(et_vec3 a, et_vec3 b);

/* 1 if not one coordinate of the n points is NaN or infinite, else 0. */
/*@ requires points: \valid_read(points + (0 .. n - 1));
    assigns  \nothing;
    ensures  all:    \result == 1 <==> \forall integer i; 0 <= i < n ==>
                         \is_finite(points[i].x) && \is_finite(points[i].y) && \is_finite(points[i].z);
    ensures  flag:   \result == 0 || \result == 1;
*/
int et_vec3_finite(const et_vec3 *points, size_t n);

#ifdef __cplusplus
}
#endif
#endif
