/* As in alloc_frame.h and curve.h. */
#include "alloc_frame.h"
#include "curve.h"
