/* As in rng.h. */
#include "rng.h"
