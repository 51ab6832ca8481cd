/* As in libm.h: what the logarithm calls. */
#include "libm.h"
