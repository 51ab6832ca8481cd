/* As in surface.h: facts on products. */
#include "surface.h"
