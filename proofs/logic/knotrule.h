/* Facts on knots from parameters, as in logic.h; fmin and fmax as C99, F.9.9, has them. */
#include "libm.h"
#include "logic.h"
#include "etalon/fit/knotrule.h"
#include <stdint.h>
#define fmin(x, y) knotrule_fmin(x, y)
#define fmax(x, y) knotrule_fmax(x, y)
/*@ assigns \nothing;
    ensures  finite: \is_finite(x) && \is_finite(y) ==> \is_finite(\result) && \result <= x && \result <= y && (\result == x || \result == y);
    ensures  above:  \is_plus_infinity(x) && \is_finite(y) ==> \is_finite(\result) && \result == y;
*/
double knotrule_fmin(double x, double y);
/*@ assigns \nothing;
    ensures  finite: \is_finite(y) ==> \is_plus_infinity(\result) || (\is_finite(\result) && \result >= y);
*/
double knotrule_fmax(double x, double y);
/*@ logic integer knotrule_place(integer nt, integer spans, integer j) = j*(nt/spans) + (j*(nt%spans))/spans; */
/*@ ghost
  /@ requires parts: n == whole*spans + part && part < spans && j*part == q*spans + r && r < spans && 1 <= j < spans && 1 <= whole;
     assigns  \nothing;
     ensures  place: 1 <= j*whole + q < n; @/
  static void fact_place(size_t j, size_t whole, size_t part, size_t q, size_t r, size_t spans, size_t n)
  {
      /@ assert times: (j*whole + q)*spans + r == j*n; @/
      fact_product(j + 1, spans, n);
      /@ assert less: (j*whole + q)*spans + r < n*spans; @/
      fact_quotient(j*whole + q, r, n, spans);
      fact_product(1, j, whole);
  }
*/
