#include "etalon/base/vec3.h"
#include <math.h>

double et_vec3_distance(et_vec3 a, et_vec3 b)
{
    double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return sqrt(x * x + y * y + z * z);
}

int et_vec3_finite(const et_vec3 *points, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (!isfinite(points[i].x) || !isfinite(points[i].y) || !isfinite(points[i].z)) {
            return 0;
        }
    }
    return 1;
}
