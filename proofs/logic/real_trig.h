/* As in libm.h: what sine and cosine call. */
#include "libm.h"
