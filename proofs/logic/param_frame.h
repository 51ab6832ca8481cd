/* As in alloc_frame.h and param.h. */
#include "alloc_frame.h"
#include "param.h"
