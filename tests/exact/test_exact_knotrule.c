/* exact_knotrule: nothing is kept, nothing read that nobody has written. */
#include "etalon/exact/exact.h"
#include "exact/live.h"
#include "gen.h"

/* One case in 4. */
verdict prop_exact_knotrule_make_kept(gen *g)
{
    double t[12], u[12 + 3 + 1], v[12 + 3 + 1];
    const size_t p = gen_between(g, 1, 3), control = gen_between(g, p + 1, 12), nu = control + p + 1;
    const et_knotrule_kind kind = (et_knotrule_kind)gen_upto(g, 3);
    const size_t nt = kind == ET_KNOTRULE_AVERAGING ? control : 12;

    t[0] = 0.0;
    for (size_t i = 1; i < 12; i++)
        t[i] = t[i - 1] + gen_real(g, 0, 0.09);
    live_begin(4 * p);
    const et_status status = et_exact_knotrule_make(u, nu, p, t, nt, kind);
    if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK, "status %d", (int)status) ||
        !gen_check(g, et_exact_knotrule_make(v, nu, p, t, nt, kind) == ET_OK, "not again"))
        return FAIL;
    for (size_t i = 0; i < nu; i++)
        if (!gen_check(g, u[i] == v[i], "knot %zu: %a, with other memory %a", i, u[i], v[i]))
            return FAIL;
    return PASS;
}
