/* As in winner.h. */
#include "winner.h"
