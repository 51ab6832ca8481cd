/* Facts on shells, as in logic.h; memcmp and memset as C has them for what they are called with: doubles of equal bits are equal or both no number,
 * and zero bits are null pointers. */
#include "logic.h"
#include "etalon/fit/shell.h"
#define memcmp(a, b, bytes) shell_compare(a, b, (bytes) / sizeof(double))
#define memset(made, value, bytes) shell_zero(made)
/*@ requires valid: \valid_read(a + (0 .. n - 1)) && \valid_read(b + (0 .. n - 1));
    assigns  \result \from a[0 .. n - 1], b[0 .. n - 1];
    ensures  equal: \result == 0 ==> \forall integer i; 0 <= i < n && \is_finite(a[i]) ==> \is_finite(b[i]) && a[i] == b[i];
*/
int shell_compare(const double *a, const double *b, size_t n);
/*@ requires valid: \valid(made);
    assigns  *made;
    ensures  zero:  made->view[0].points == \null && made->view[1].points == \null;
*/
void shell_zero(et_shell *made);
