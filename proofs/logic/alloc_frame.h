/* As in alloc.h, for frames: what is new was not allocated when the function was called.  Included before all other headers. */
#ifndef LOGIC_ALLOC_FRAME_H
#define LOGIC_ALLOC_FRAME_H
#include "alloc.h"
#define et_array(p, count, size) frame_array(p)
#define et_numbers(p, n) frame_array((char *)(void *)p)
#define et_size_array(count, size) frame_size_array(count, size)
/*@ predicate frame_array(char *p) = \block_length(p) == 0 && p == \base_addr(p); */
/*@ assigns \result \from count, size;
    ensures fresh: \result == \null || frame_array((char *)\result);
*/
void *frame_size_array(size_t count, size_t size);
#endif
