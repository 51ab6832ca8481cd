/* As in logic.h and libm.h; fmax of C's library, of which only the frame matters here. */
#include "libm.h"
#include "logic.h"
#include "etalon/fit/param.h"
#define fmax(x, y) param_fmax(x, y)
/*@ assigns \nothing; */
double param_fmax(double x, double y);
