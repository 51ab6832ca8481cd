/* As in libm.h: isfinite. */
#include "libm.h"
