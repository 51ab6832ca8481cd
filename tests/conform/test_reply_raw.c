/* conform/reply: any bytes as the line of a reply, and as the words of a hello. */
#include "etalon/conform/reply.h"
#include "gen.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096 };
#define TEXT(s) { s, sizeof s - 1 }

static char *line_of(gen *g, const sample *some)
{
    static uint8_t bytes[MOST + 1];
    const size_t n = gen_rest(g, bytes, MOST, some);
    char *const line = calloc(n + 1, 1);

    if (line)
        memcpy(line, bytes, n);
    gen_note(g, "%s", line ? line : "");
    return line;
}

static bool returns(gen *g, const et_reply *r, uint64_t id)
{
    char *line = NULL;
    et_reply again;
    et_message message = { "" };
    uint64_t same = 0;
    bool ok = gen_check(g, et_reply_print(&line, id, r) == ET_OK && line && !strpbrk(line, "\r\n"), "print");

    ok = ok && gen_check(g, et_reply_parse(&again, &same, line, &message) == ET_OK, "%s: %s", line, message.text);
    if (ok) {
        ok = gen_check(g, same == id && et_reply_same(r, &again), "not the same again: %s", line);
        et_reply_free(&again);
    }
    free(line);
    return ok;
}

/* What can be taken for a curve is put as the same numbers. */
static bool as_curve(gen *g, const et_reply *r)
{
    et_curve c;
    et_reply put = { ET_REPLY_OK, 0, NULL, "" };
    size_t at = 0;
    bool ok = true;

    if (et_reply_get_curve(&c, &at, r) != ET_OK)
        return gen_check(g, at == 0, "moved by a failure");
    ok = gen_check(g, at <= r->count && et_reply_put_curve(&put, &c) == ET_OK && put.count == at, "%zu numbers of %zu", put.count, at);
    for (size_t i = 0; ok && i < at; i++)
        ok = gen_check(g, put.x[i] == r->x[i] || isnan(r->x[i]), "number %zu", i);
    et_reply_free(&put);
    et_curve_free(&c);
    return ok;
}

static bool as_surface(gen *g, const et_reply *r)
{
    et_surface s;
    et_reply put = { ET_REPLY_OK, 0, NULL, "" };
    size_t at = 0;
    bool ok = true;

    if (et_reply_get_surface(&s, &at, r) != ET_OK)
        return gen_check(g, at == 0, "moved by a failure");
    ok = gen_check(g, at <= r->count && et_reply_put_surface(&put, &s) == ET_OK && put.count == at, "%zu numbers of %zu", put.count, at);
    for (size_t i = 0; ok && i < at; i++)
        ok = gen_check(g, put.x[i] == r->x[i] || isnan(r->x[i]), "number %zu", i);
    et_reply_free(&put);
    et_surface_free(&s);
    return ok;
}

verdict prop_reply_parse_raw(gen *g)
{
    static const sample some[] = {
        TEXT("7 ok 0x1p+0 -0x0p+0 inf nan"), TEXT("18 refused knots decrease"), TEXT("0 unsupported"), TEXT("1 ok 3 0.10000000000000001 1E5 NaN -INF"),
        TEXT("2 ok 1 4 0 0 1 1 2 0 0 0 1 1 1 0"), TEXT("3 ok 1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 4 1 1 1 1"), TEXT("9007199254740992 ok"),
        { NULL, 0 } };
    char *const line = line_of(g, some);
    et_reply r, was;
    uint64_t id = 12345;
    et_message message = { "" };

    if (!line)
        return FAIL;
    memset(&r, 0xAB, sizeof r);
    memset(&was, 0xAB, sizeof was);
    const et_status status = et_reply_parse(&r, &id, line, &message);
    bool ok = gen_check(g, status == ET_OK || status == ET_EFORMAT, "status %s", et_status_text(status));
    gen_label(g, status == ET_OK ? "read" : "refused");
    if (status == ET_OK) {
        ok = ok && gen_check(g, r.kind <= ET_REPLY_UNSUPPORTED && memchr(r.reason, 0, sizeof r.reason) && (r.count == 0 || r.x), "what was read is not valid");
        ok = ok && gen_check(g, et_reply_same(&r, &r), "not the same as itself") && returns(g, &r, id) && as_curve(g, &r) && as_surface(g, &r);
        et_reply_free(&r);
    } else {
        ok = ok && gen_check(g, memcmp(&r, &was, sizeof r) == 0 && id == 12345, "changed on failure") && gen_check(g, message.text[0] != 0, "nothing told");
        ok = ok && gen_check(g, et_reply_parse(&r, &id, line, NULL) == status, "another status without a message");
    }
    free(line);
    return ok ? PASS : FAIL;
}

verdict prop_reply_hello_raw(gen *g)
{
    static const sample some[] = {
        TEXT("protocol=1 name=mylib version=2.1 degree=9 rational=1 sides=any knot_tolerance=0 ops=span,basis,curve_point,curve_ders"),
        TEXT("ops=surface_point,what version=1 name=a protocol=1 order=2 sides=left,right rational=0 knot_tolerance=0x1p-40 own=7"),
        TEXT("protocol=2 name= version= ops="), { NULL, 0 } };
    char *const line = line_of(g, some);
    et_hello h, was;
    et_message message = { "" };

    if (!line)
        return FAIL;
    memset(&h, 0xAB, sizeof h);
    memset(&was, 0xAB, sizeof was);
    const et_status status = et_reply_hello(&h, line, &message);
    bool ok = gen_check(g, status == ET_OK || status == ET_EFORMAT, "status %s", et_status_text(status));
    gen_label(g, status == ET_OK ? "read" : "refused");
    if (status == ET_OK)
        ok = ok && gen_check(g, h.name[0] && memchr(h.name, 0, sizeof h.name) && h.version[0] && memchr(h.version, 0, sizeof h.version) && h.knot_tolerance >= 0 &&
                             isfinite(h.knot_tolerance) && (h.any || h.left || h.right), "what was read is not valid");
    else
        ok = ok && gen_check(g, memcmp(&h, &was, sizeof h) == 0, "changed on failure") && gen_check(g, message.text[0] != 0, "nothing told");
    free(line);
    return ok ? PASS : FAIL;
}
