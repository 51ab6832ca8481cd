/* As in alloc.h; memset of an enclosure as C has it: zero bits are null pointers; of fmax and nextafter only the frame
 * matters here. */
#include "alloc.h"
#include "logic.h"
#include "etalon/fit/enclosure.h"
#define memset(made, value, bytes) enclosure_zero(made)
#define fmax(x, y) enclosure_fmax(x, y)
#define nextafter(x, y) enclosure_nextafter(x, y)
/*@ assigns \nothing; */
double enclosure_fmax(double x, double y);
/*@ assigns \nothing; */
double enclosure_nextafter(double x, double y);
/*@ requires valid: \valid(made);
    assigns  *made;
    ensures  zero:  made->radius[0] == \null && made->radius[1] == \null && made->count == 0 && made->undecided == 0;
*/
void enclosure_zero(et_enclosure *made);
