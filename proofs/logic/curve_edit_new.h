/* As in alloc.h and curve_edit.h. */
#include "alloc.h"
#include "curve_edit.h"
