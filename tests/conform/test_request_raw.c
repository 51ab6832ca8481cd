/* conform/request: any bytes as the line of a request. */
#include "etalon/conform/request.h"
#include "lines.h"

/* Printed, it is a line that says the same, to the bit: printed again it is the same line. */
static bool returns(gen *g, const et_request *r)
{
    char *first = NULL, *second = NULL;
    et_request again;
    et_message message = { "" };
    bool ok = gen_check(g, et_request_print(&first, r) == ET_OK && first && !strpbrk(first, "\r\n"), "print");

    ok = ok && gen_check(g, et_request_parse(&again, first, &message) == ET_OK, "%s: %s", first, message.text);
    if (ok) {
        ok = gen_check(g, again.op == r->op && et_request_print(&second, &again) == ET_OK && strcmp(first, second) == 0, "%s, then %s", first, second);
        et_request_free(&again);
    }
    free(first);
    free(second);
    return ok;
}

/* Counts of words are within their lists, and a curve or surface is made only of counts that fit. */
static bool shaped(gen *g, const et_request *r)
{
    bool ok = gen_check(g, r->op < ET_OPS, "operation %d", (int)r->op);

    for (size_t k = 0; ok && et_request_argument(r->op, k); k++) {
        const et_request_shape *const shape = et_request_argument(r->op, k);
        size_t words = 0;
        while (shape->kind == ET_ARG_WORD && shape->words[words])
            words++;
        ok = gen_check(g, shape->kind != ET_ARG_WORD || r->arg[k].count < words, "word %zu of %s", r->arg[k].count, shape->name);
        ok = ok && gen_check(g, shape->kind == ET_ARG_WORD || shape->kind == ET_ARG_COUNT || r->arg[k].count == 0 || r->arg[k].x, "%s: no numbers", shape->name);
    }
    et_curve c;
    if (ok && r->op == ET_OP_CURVE_POINT && et_request_curve(&c, r, 0) == ET_OK)
        ok = gen_check(g, r->arg[1].count == c.n + c.p + 1 && r->arg[2].count == c.n && (!c.weights || r->arg[3].count == c.n), "a curve of other counts");
    et_surface s;
    if (ok && r->op == ET_OP_SURFACE_POINT && et_request_surface(&s, r, 0) == ET_OK)
        ok = gen_check(g, r->arg[2].count == s.nu + s.p + 1 && r->arg[3].count == s.nv + s.q + 1 && r->arg[4].count == s.nu * s.nv, "a surface of other counts");
    return ok;
}

verdict prop_request_parse_raw(gen *g)
{
    char *const line = line_rest(g, LINE_MOST);
    et_request r, was;
    et_message message = { "" };

    if (!line)
        return FAIL;
    memset(&r, 0xAB, sizeof r);
    memset(&was, 0xAB, sizeof was);
    const et_status status = et_request_parse(&r, line, &message);
    bool ok = gen_check(g, status == ET_OK || status == ET_EFORMAT, "status %s", et_status_text(status));
    gen_label(g, status == ET_OK ? "read" : "refused");
    if (status == ET_OK) {
        ok = ok && shaped(g, &r) && returns(g, &r);
        et_request_free(&r);
    } else {
        ok = ok && gen_check(g, memcmp(&r, &was, sizeof r) == 0, "changed on failure") && gen_check(g, message.text[0] != 0, "nothing told");
        ok = ok && gen_check(g, et_request_parse(&r, line, NULL) == status, "another status without a message");
    }
    free(line);
    return ok ? PASS : FAIL;
}
