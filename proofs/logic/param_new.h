/* As in alloc.h and param.h. */
#include "alloc.h"
#include "param.h"
