/* As in alloc.h and curve.h. */
#include "alloc.h"
#include "curve.h"
