/* As in libm.h: sqrt. */
#include "libm.h"
