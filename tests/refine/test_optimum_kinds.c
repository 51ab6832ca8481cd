/* refine/optimum: without options as with the defaults, and the same again. */
#include "etalon/refine/optimum.h"
#include "refine/optimum_cases.h"
#include <string.h>

/* One case in 250. */
verdict prop_optimum_defaults_used(gen *g)
{
    const et_optimum_options o = et_optimum_defaults();
    et_optimum_result r[2];
    et_vec3 dual[2][OPTIMUM_CLASSES], P[2][OPTIMUM_CLASSES];
    optimum_case c;
    bool ok = optimum_case_draw(g, &c, TAME);

    for (size_t k = 0; k < c.nov; k++)
        c.data[k] = (et_vec3){gen_real(g, -1, 1), gen_real(g, -1, 1), gen_real(g, -1, 1)};
    for (int k = 0; ok && k < 2; k++) {
        et_shell_scatter(&c.fit.shell, c.start, c.n);
        ok = gen_check(g, et_optimum_find(&c.fit, &r[k], dual[k], NULL, 0, c.data, c.nov, k ? &o : NULL, NULL, NULL) == ET_OK, "not done");
        et_shell_gather(P[k], c.n, &c.fit.shell);
    }
    ok = ok && gen_check(g, r[0].value == r[1].value && r[0].lower == r[1].lower && r[0].gap == r[1].gap && r[0].iterations == r[1].iterations,
                         "by default %a to %a, with the defaults %a to %a", r[0].lower, r[0].value, r[1].lower, r[1].value);
    ok = ok && gen_check(g, memcmp(P[0], P[1], c.n * sizeof **P) == 0 && memcmp(dual[0], dual[1], c.nov * sizeof **dual) == 0,
            "other control points or duals");
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}
