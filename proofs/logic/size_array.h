/* posix_memalign as POSIX has it: in Frama-C's own contract nothing is written to *memory. */
#include <stdlib.h>
#define posix_memalign(memory, alignment, bytes) logic_posix_memalign(memory, alignment, bytes)
/*@ requires valid:     \valid(memory);
    requires alignment: alignment == 64;
    assigns  *memory, \result \from alignment, bytes;
    ensures  memory:    \result == 0 ==> *memory != \null && \valid((char *)*memory + (0 .. bytes - 1));
*/
int logic_posix_memalign(void **memory, size_t alignment, size_t bytes);
