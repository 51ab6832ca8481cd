/* Facts that the provers do not find by themselves: ghost functions that do nothing, called in the code where the fact is needed.  Each is proved where
 * it stands. */
#ifndef LOGIC_H
#define LOGIC_H
#include <stddef.h>
/*@ ghost
  /@ requires order:    a <= c;
     assigns  \nothing;
     ensures  product:  a*n <= c*n; @/
  static void fact_product(size_t a, size_t c, size_t n) {}
  /@ requires parts:    0 < n && r < n && q*n + r < c*n;
     assigns  \nothing;
     ensures  quotient: q < c; @/
  static void fact_quotient(size_t q, size_t r, size_t c, size_t n) {}
  /@ requires parts:    b < n && d < n && (a != c || b != d);
     assigns  \nothing;
     ensures  distinct: a*n + b != c*n + d; @/
  static void fact_distinct(size_t a, size_t b, size_t c, size_t d, size_t n)
  {
      if (a < c) fact_product(a + 1, c, n);
      if (c < a) fact_product(c + 1, a, n);
  }
*/
#endif
