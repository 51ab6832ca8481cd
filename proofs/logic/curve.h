/* As in libm.h and logic.h: isfinite, facts on products. */
#include "libm.h"
#include "logic.h"
#include <stdint.h>
