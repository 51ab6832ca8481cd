/* As in libm.h and logic.h; a generator is a struct that holds no double and no pointer. */
#ifndef LOGIC_WINNER_H
#define LOGIC_WINNER_H
#include "libm.h"
#include "logic.h"
#include <stdint.h>
struct et_rng { uint64_t draws; };
#define ceil(x) libm_ceil(x)
/*@ assigns \nothing;
    ensures  next: \is_finite(x) ==> \is_finite(\result) && x <= \result < x + 1;
*/
double libm_ceil(double x);
/*@ ghost
  /@ requires order:    a <= b;
     assigns  \nothing;
     ensures  square:   0 <= a*a <= b*b; @/
  static void fact_square(size_t a, size_t b)
  {
      fact_product(a, b, a);
      fact_product(a, b, b);
  }
*/
#endif
