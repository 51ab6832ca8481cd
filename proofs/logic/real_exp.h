/* As in libm.h: what the elementary functions call. */
#include "libm.h"
