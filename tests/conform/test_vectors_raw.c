/* conform/vectors: any bytes as a file of frozen vectors. */
#include "etalon/conform/vectors.h"
#include "io/raw.h"

#define TEXT(s) { s, sizeof s - 1 }

verdict prop_vectors_read_raw(gen *g)
{
    static const sample some[] = {
        TEXT("{\"format\":\"etalon-conformance\",\"version\":1,\"operation\":\"multiplicity\",\"vectors\":[\n"
             "{\"id\":\"multiplicity/plain/1\",\"category\":\"plain\",\"validity\":\"valid\",\"request\":\"3 0x0p+0 0x1p-1 0x1p-1 0x1p-1\",\"want\":[\"0x1p+1\"],\n"
             "\"bound\":[\"0x0p+0\"],\"condition\":\"0x1p+0\",\"comment\":\"twice\"},\n"
             "{\"id\":\"multiplicity/bad_input/1\",\"category\":\"bad_input\",\"validity\":\"invalid\",\"request\":\"1 nan 0x0p+0\",\"issue\":\"https://a.example/1\"}]}\n"),
        TEXT("{\"format\":\"etalon-conformance\",\"version\":1,\"operation\":\"curve_ders\",\"vectors\":[{\"id\":\"curve_ders/repeated_knots/1\",\n"
             "\"category\":\"repeated_knots\",\"validity\":\"valid\",\"request\":\"1 5 0 0 0x1p-1 1 1 3 0 0 0 1 0 0 1 1 0 0 0x1p-1 any 1\",\n"
             "\"want\":[\"0x1p+0\",\"0x0p+0\",\"0x0p+0\",\"0x0p+0\",\"0x1p+1\",\"0x0p+0\"],\"bound\":[\"0x1p-50\",\"0x0p+0\",\"0x0p+0\",\"0x0p+0\",\"0x1p-50\",\"0x0p+0\"],\n"
             "\"want_left\":[\"0x1p+0\",\"0x0p+0\",\"0x0p+0\",\"0x1p+1\",\"0x0p+0\",\"0x0p+0\"],\"bound_left\":[\"0x1p-50\",\"0x0p+0\",\"0x0p+0\",\"0x1p-50\",\"0x0p+0\",\"0x0p+0\"],\n"
             "\"condition\":\"inf\"}]}\n"), { NULL, 0 } };
    static raw_file f;
    static et_vector nowhere;
    et_vectors v = { &nowhere, 12345 };
    et_message message = { "" };

    if (!raw_draw(g, &f, ".json", some))
        return FAIL;
    const et_status status = et_vectors_read(&v, f.path, &message);
    bool ok = gen_check(g, status == ET_OK || status == ET_EFORMAT, "status %s", et_status_text(status));
    gen_label(g, status == ET_OK ? "read" : "refused");
    if (status == ET_OK) {
        for (size_t k = 0; ok && k < v.count; k++) {
            const et_vector *const at = &v.vector[k];
            ok = gen_check(g, at->id && at->request.op < ET_OPS && at->truth.validity <= ET_INVALID && (at->truth.count == 0 || (at->truth.want && at->truth.bound)),
                           "vector %zu is not valid", k);
            for (size_t i = 0; ok && i < at->truth.count; i++)
                ok = gen_check(g, at->truth.bound[i] >= 0, "bound %zu of vector %zu", i, k);
        }
        et_vectors_free(&v);
    } else {
        ok = ok && gen_check(g, v.vector == &nowhere && v.count == 12345, "*vectors changed") && raw_told(g, &f, &message);
    }
    unlink(f.path);
    return ok ? PASS : FAIL;
}
