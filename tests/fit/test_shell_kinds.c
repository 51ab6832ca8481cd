/* fit/shell: the net that a shell was made for is the net it tells, and its copy's. */
#include "etalon/fit/shell.h"
#include "gen.h"

verdict prop_shell_net_back(gen *g)
{
    const size_t p = gen_between(g, 1, 3), q = gen_between(g, 1, 3);
    const et_doublenet net = {gen_between(g, p + 1, 9), gen_between(g, q + 1, 9)};
    et_shell s;

    if (!gen_check(g, et_shell_new(&s, p, q, net, (int)gen_upto(g, 1)) == ET_OK, "not made"))
        return FAIL;
    const et_doublenet told = et_shell_net(&s);
    et_shell_free(&s);
    return gen_check(g, told.nx == net.nx && told.ny == net.ny, "%zu x %zu became %zu x %zu", net.nx, net.ny, told.nx, told.ny) ? PASS : FAIL;
}
