/* What a fit says when it refuses, word by word. */
#include "fit/refused.h"

verdict prop_fit_make_says(gen *g)
{
    return refused_says(g, et_fit_make);
}
