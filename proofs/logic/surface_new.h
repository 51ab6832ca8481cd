/* As in alloc.h and surface.h; memcpy of doubles. */
#include "alloc.h"
#include "surface.h"
#include <string.h>
#define memcpy(to, from, bytes) surface_memcpy((double *)(to), (const double *)(from), bytes)
/*@ requires bytes:    bytes % sizeof(double) == 0;
    requires valid:    \valid(to + (0 .. bytes / sizeof(double) - 1)) && \valid_read(from + (0 .. bytes / sizeof(double) - 1));
    requires apart:    \separated(to + (0 .. bytes / sizeof(double) - 1), from + (0 .. bytes / sizeof(double) - 1));
    assigns  to[0 .. bytes / sizeof(double) - 1];
*/
void surface_memcpy(double *to, const double *from, size_t bytes);
