/* As in libm.h: isfinite and sqrt. */
#include "libm.h"
