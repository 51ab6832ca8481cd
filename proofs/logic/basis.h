/* As in logic.h. */
#include "logic.h"
#include <stdint.h>
