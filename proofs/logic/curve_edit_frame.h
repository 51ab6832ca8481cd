/* As in alloc_frame.h and curve_edit.h. */
#include "alloc_frame.h"
#include "curve_edit.h"
