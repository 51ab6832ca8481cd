/* As in search.h: what the steps call. */
#ifndef DE_H
#define DE_H
#include "search.h"
/*@ ghost
  /@ requires same:     a == c && b == d;
     assigns  \nothing;
     ensures  cells:    (a + 1) * (b + 1) == (c + 1) * (d + 1); @/
  static void fact_cells(size_t a, size_t b, size_t c, size_t d) {}
*/
#endif
