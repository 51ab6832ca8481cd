#include "eva.h"
#include "etalon/fit/param.h"

static void parameters(et_param_method method)
{
    double t[4], work[4], s[4], r[3];
    et_vec3 D[12];
    size_t flat;

    any_memory();
    fill(&D[0].x, 36);
    fill(s, 4);
    fill(t, 4);
    et_param_row(t, 4, D, 3, method, work);
    et_param_grid(s, 4, r, 3, &flat, D, method);
    et_param_standardise(s, t, 4);
    et_param_name(method);
}

void eva_param_uniform(void) { parameters(ET_PARAM_UNIFORM); }
void eva_param_chord(void) { parameters(ET_PARAM_CHORD); }
void eva_param_centripetal(void) { parameters(ET_PARAM_CENTRIPETAL); }
void eva_param_exponential(void) { parameters(ET_PARAM_EXPONENTIAL); }
