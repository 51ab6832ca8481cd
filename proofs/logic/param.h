/* As in logic.h, libm.h and alloc.h; fmax, frexp and ldexp of the C library, of which only the frame matters here, and that exponents of doubles are small. */
#include "alloc.h"
#include "libm.h"
#include "logic.h"
#include "etalon/fit/param.h"
#define fmax(x, y) param_fmax(x, y)
#define frexp(x, e) param_frexp(x, e)
#define ldexp(x, e) param_ldexp(x, e)
/*@ assigns \nothing; */
double param_fmax(double x, double y);
/*@ requires e: \valid(e);
    assigns  *e;
    ensures  e: -1073 <= *e <= 1024;
*/
double param_frexp(double x, int *e);
/*@ assigns \nothing; */
double param_ldexp(double x, int e);
/*@ ghost
  /@ requires points: et_points_finite(D, total) && total <= SIZE_MAX;
     requires inside: 1 <= n && at + (n - 1)*stride < total;
     assigns  \nothing;
     ensures  line:   \forall integer i; 0 <= i < n ==> et_line_finite(D + at, stride, i); @/
  static void fact_line(size_t total, size_t at, size_t stride, size_t n, et_vec3 *D)
  {
      size_t k = 0;
      /@ loop invariant place: k <= n;
         loop invariant line:  \forall integer i; 0 <= i < k ==> et_line_finite(D + at, stride, i);
         loop assigns k;
         loop variant n - k; @/
      while (k < n) {
          fact_product(k, n - 1, stride);
          /@ assert point: et_point_finite(D + (at + k*stride)); @/
          k++;
      }
  }
*/
