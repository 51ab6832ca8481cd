#include "etalon/base/vec3.h"
#include <math.h>

double et_vec3_distance(et_vec3 a, et_vec3 b)
{
    double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return sqrt(x * x + y * y + z * z);
}

int et_vec3_finite(const et_vec3 *points, size_t n)
{
    /*@ loop invariant place:  i <= n;
        loop invariant finite: \forall integer k; 0 <= k < i ==> \is_finite(points[k].x) && \is_finite(points[k].y) && \is_finite(points[k].z);
        loop assigns i;
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++) {
        if (!isfinite(points[i].x) || !isfinite(points[i].y) || !isfinite(points[i].z)) {
            return 0;
        }
    }
    return 1;
}
