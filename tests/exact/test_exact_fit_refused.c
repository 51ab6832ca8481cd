/* What a fit says when it refuses, word by word. */
#include "etalon/exact/exact.h"
#include "fit/refused.h"

static et_status make(et_fit *fit, const et_vec3 *data, size_t nov, et_doublenet net, const et_fit_options *o, et_message *message)
{
    return et_exact_fit_make(fit, data, nov, net, o, NULL, NULL, message);
}

verdict prop_exact_fit_make_says(gen *g)
{
    return refused_says(g, make);
}
