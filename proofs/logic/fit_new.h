/* As in alloc.h and fit.h. */
#include "alloc.h"
#include "fit.h"
