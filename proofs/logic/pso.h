/* As in search.h: what the steps call. */
#include "search.h"
