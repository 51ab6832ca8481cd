/* conform: the defaults again, whatever was done to the ones before. */
#include "etalon/conform/conform.h"
#include "gen.h"
#include <string.h>

verdict prop_conform_defaults_again(gen *g)
{
    et_conform_options o = et_conform_defaults();
    const et_conform_options was = o;

    o.level = 3;
    o.seed = gen_upto(g, 99);
    o.cases = 0;
    o.vectors = "";
    memset(o.op, 0, sizeof o.op);
    o = et_conform_defaults();
    return gen_check(g, o.level == was.level && o.seed == was.seed && o.cases == was.cases && o.vectors == was.vectors &&
            o.findings == was.findings &&
                            memcmp(o.op, was.op, sizeof o.op) == 0,
                     "other defaults")
           ? PASS
           : FAIL;
}
