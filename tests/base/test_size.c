/* base/size against long multiplication in half words. */
#include "etalon/base/size.h"
#include "gen.h"
#include "golden.h"
#include <stdint.h>
#include <stdlib.h>

/* 1 if a * b needs more than 64 bits, by schoolbook multiplication. */
static int wraps(uint64_t a, uint64_t b)
{
    uint64_t a0 = a & 0xffffffffu, a1 = a >> 32, b0 = b & 0xffffffffu, b1 = b >> 32;
    uint64_t middle = a1 * b0 + (a0 * b0 >> 32), more = a0 * b1 + (middle & 0xffffffffu);
    return a1 * b1 + (middle >> 32) + (more >> 32) != 0;
}

verdict prop_size_mul(gen *g)
{
    size_t a = (size_t)gen_upto(g, UINT64_MAX), b = 0, product = 77;
    a >>= gen_upto(g, 63);
    switch (gen_upto(g, 3)) {
    case 0:
        b = (size_t)gen_upto(g, UINT64_MAX) >> gen_upto(g, 63);
        break;
    case 1:
        b = a ? SIZE_MAX / a : 0;         /* the greatest that fits */
        break;
    case 2:
        b = a > 1 ? SIZE_MAX / a + 1 : 1; /* the least that does not */
        break;
    default:
        b = (size_t)gen_upto(g, 2);
    }
    et_status status = et_size_mul(&product, a, b);
    if (wraps(a, b)) {
        gen_label(g, "wraps");
        return gen_check(g, status == ET_ENOMEM && product == 77, "%zu * %zu: status %d, product %zu", a, b, (int)status, product) ? PASS : FAIL;
    }
    return gen_check(g, status == ET_OK && product == a * b, "%zu * %zu: status %d, product %zu", a, b, (int)status, product) ? PASS : FAIL;
}

verdict prop_size_array(gen *g)
{
    size_t count = (size_t)gen_upto(g, 300), size = (size_t)gen_upto(g, 40);
    unsigned char *x = et_size_array(count, size);
    bool ok = gen_check(g, x != NULL, "no array of %zu * %zu bytes", count, size);
    for (size_t i = 0; ok && i < count * size; i++) {
        ok = gen_check(g, x[i] == 0, "byte %zu is %d", i, x[i]);
        x[i] = 1;
    }
    free(x);
    size_t most = SIZE_MAX / (size + 2) + 1;
    void *y = et_size_array(most, size + 2);
    ok = gen_check(g, y == NULL, "an array of %zu * %zu bytes", most, size + 2) && ok;
    free(y);
    y = et_size_array(size + 2, most);
    ok = gen_check(g, y == NULL, "an array of %zu * %zu bytes", size + 2, most) && ok;
    free(y);
    return ok ? PASS : FAIL;
}

verdict gold_size_mul(const row *r)
{
    size_t product = 0;
    et_status status = et_size_mul(&product, row_size(r, 0), row_size(r, 1));
    return row_is_size(r, 0, (size_t)status) && row_is_size(r, 1, product) ? PASS : FAIL;
}
