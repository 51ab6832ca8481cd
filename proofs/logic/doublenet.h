/* Facts on the double net's numbering, as in logic.h. */
#include "logic.h"
#include "etalon/net/doublenet.h"
/*@ ghost
  /@ requires net:    et_net_ok(nx, ny);
     requires vector: et_index_ok(nx, ny, i, j, k);
     requires row:    a < nx;
     assigns  \nothing;
     ensures  row:    \forall integer b, l; et_index_ok(nx, ny, a, b, l) && et_class_of(nx, ny, a, b, l) == et_class_of(nx, ny, i, j, k)
                          ==> a == i && b == j && l == k; @/
  static void fact_row(size_t nx, size_t ny, size_t i, size_t j, size_t k, size_t a)
  {
      fact_product(a + 1, nx, ny);
      fact_product(i + 1, nx, ny);
      if (a < i) fact_product(a + 1, i, ny);
      if (i < a) fact_product(i + 1, a, ny);
      if (0 < a) fact_product(0, a - 1, ny - 2);
      if (0 < i) fact_product(0, i - 1, ny - 2);
      if (0 < a && a < i) fact_product(a, i - 1, ny - 2);
      if (0 < i && i < a) fact_product(i, a - 1, ny - 2);
  }
  /@ requires net:    et_net_ok(nx, ny);
     requires order:  s < t < NOR(nx, ny);
     assigns  \nothing;
     ensures  distinct: et_seam_class(nx, ny, s) != et_seam_class(nx, ny, t); @/
  static void fact_seam(size_t nx, size_t ny, size_t s, size_t t)
  {
      size_t a, b, c, d;
      if (s < ny) { a = 0; b = s; }
      else if (s <= ny + nx - 2) { a = s - ny + 1; b = ny - 1; }
      else if (s <= ny - 1 + (nx - 1) + (ny - 1)) { a = nx - 1; b = ny - 1 - (s - (ny + nx - 2)); }
      else { a = nx - 1 - (s - (ny - 1 + (nx - 1) + (ny - 1))); b = 0; }
      if (t < ny) { c = 0; d = t; }
      else if (t <= ny + nx - 2) { c = t - ny + 1; d = ny - 1; }
      else if (t <= ny - 1 + (nx - 1) + (ny - 1)) { c = nx - 1; d = ny - 1 - (t - (ny + nx - 2)); }
      else { c = nx - 1 - (t - (ny - 1 + (nx - 1) + (ny - 1))); d = 0; }
      /@ assert a == et_seam_i(nx, ny, s) && b == et_seam_j(nx, ny, s); @/
      /@ assert c == et_seam_i(nx, ny, t) && d == et_seam_j(nx, ny, t); @/
      fact_distinct(a, b, c, d, ny);
  }
*/
