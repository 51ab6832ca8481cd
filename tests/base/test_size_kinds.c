/* base/size: products do not depend on the order, and what was multiplied is divided out again. */
#include "etalon/base/size.h"
#include "gen.h"

verdict prop_size_mul_order(gen *g)
{
    const size_t a = (size_t)gen_upto(g, UINT64_MAX) >> gen_upto(g, 63), b = (size_t)gen_upto(g, UINT64_MAX) >> gen_upto(g, 63);
    size_t ab = 7, ba = 7;
    const et_status status = et_size_mul(&ab, a, b);
    bool ok = gen_check(g, et_size_mul(&ba, b, a) == status && ab == ba, "%zu times %zu: %zu, the other way round %zu", a, b, ab, ba);

    gen_label(g, status == ET_OK ? "fits" : "wraps");
    ok = ok && gen_check(g, status != ET_OK || a == 0 || (ab / a == b && ab % a == 0), "%zu times %zu is %zu", a, b, ab);
    return ok && gen_check(g, status == ET_OK || ab == 7, "changed") ? PASS : FAIL;
}
