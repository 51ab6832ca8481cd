/* Memory that is allocated.  WP knows no allocation: for it the table of what is valid never changes.  So a source file that allocates is proved twice,
 * as two units, both in the model Typed+cast (a void pointer becomes one to numbers), by the same two names of facts:
 *
 *   fresh     an assertion after the allocations: what is new is apart from what the function was given;
 *   distinct  an assertion after the allocations: what is new is apart from what else is new.
 *
 * UNIT_new    everything but the frames and these two: new memory counts as valid all the time, and nobody else knows it (this header).
 * UNIT_frame  the frames and `fresh`: new memory counts as not allocated when the function was called, which is what makes it new (alloc_frame.h).
 *
 * Trusted is what malloc promises: that its memory was not allocated before (the contract frame_size_array) and `distinct`.  That nothing is used after it is
 * freed, or freed twice, is not proved: the sanitisers look there. */
#ifndef LOGIC_ALLOC_H
#define LOGIC_ALLOC_H
#include "etalon/base/size.h"
#include <stdlib.h>
#define free(p) alloc_free(p)
/*@ assigns \nothing; */
void alloc_free(void *p);
#ifndef LOGIC_ALLOC_FRAME_H
/*@ ghost
  /@ requires made:  et_array((char *)p, n, sizeof(double));
     assigns  \nothing;
     ensures  valid: \valid(p + (0 .. n - 1)); @/
  static void fact_array(double *p, size_t n) {}
*/
#else
/*@ ghost
  /@ assigns  \nothing; @/
  static void fact_array(double *p, size_t n) {}
*/
#endif
#endif
