/* As in search.h: what the steps call. */
#ifndef PSO_H
#define PSO_H
#include "de.h"
/*@ ghost
  /@ requires same:     a == c && b == d;
     assigns  \nothing;
     ensures  places:   a * b == c * d; @/
  static void fact_places(size_t a, size_t b, size_t c, size_t d) {}
*/
#endif
