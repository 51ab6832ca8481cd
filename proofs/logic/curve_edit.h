/* As in libm.h: isfinite; memcpy of doubles and of structs of doubles (Frama-C's own contract copies characters, which the memory model does not see
 * as doubles). */
#include "libm.h"
#include "logic.h"
#include <stdint.h>
#include <string.h>
#define memcpy(to, from, bytes) edit_memcpy((double *)(to), (const double *)(from), bytes)
/*@ requires bytes:    bytes % sizeof(double) == 0;
    requires valid:    \valid(to + (0 .. bytes / sizeof(double) - 1)) && \valid_read(from + (0 .. bytes / sizeof(double) - 1));
    requires apart:    \separated(to + (0 .. bytes / sizeof(double) - 1), from + (0 .. bytes / sizeof(double) - 1));
    assigns  to[0 .. bytes / sizeof(double) - 1];
*/
void edit_memcpy(double *to, const double *from, size_t bytes);
