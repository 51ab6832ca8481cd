/* refine/ceres: without options as with the defaults, and the same again in one process. */
#include "etalon/refine/ceres.h"
#include "refine/optimum_cases.h"
#include <string.h>

/* One case in 500. */
verdict prop_ceres_defaults_used(gen *g)
{
    const et_ceres_options o = et_ceres_defaults();
    et_ceres_summary sum[2];
    et_vec3 P[2][OPTIMUM_CLASSES];
    optimum_case c;
    bool ok = optimum_case_draw(g, &c, TAME);

    for (size_t k = 0; k < c.nov; k++)
        c.data[k] = (et_vec3){gen_real(g, -1, 1), gen_real(g, -1, 1), gen_real(g, -1, 1)};
    for (int k = 0; ok && k < 2; k++) {
        et_shell_scatter(&c.fit.shell, c.start, c.n);
        ok = gen_check(g, et_ceres_points(&c.fit, &sum[k], NULL, 0, c.data, c.nov, k ? &o : NULL, NULL, NULL) == ET_OK, "not done");
        et_shell_gather(P[k], c.n, &c.fit.shell);
    }
    ok = ok && gen_check(g, sum[0].before == sum[1].before && sum[0].after == sum[1].after && sum[0].iterations == sum[1].iterations,
                         "by default E %a, with the defaults %a", sum[0].after, sum[1].after);
    ok = ok && gen_check(g, memcmp(P[0], P[1], c.n * sizeof **P) == 0, "other control points");
    optimum_case_end(&c);
    return ok ? PASS : FAIL;
}
