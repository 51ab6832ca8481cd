/* conform/conform: function tables with known faults are judged; the counts are those of the faults. */
#include "etalon/conform/conform.h"
#include "etalon/conform/answer.h"
#include "conform/report.h"
#include "gen.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How a table goes wrong, at which operation. */
typedef enum { RIGHT, OFF_BY_ONE, NAN_ALWAYS, REFUSES, ACCEPTS, DECLINES, FORGETS, TOO_MANY, CONDUCTS } conduct;
typedef struct { conduct how; et_request_op op; size_t calls, spoilt; } context;

static et_status answer(void *at, et_reply *reply, const et_request *request)
{
    context *c = at;
    const double wrong = c->how == NAN_ALWAYS ? (double)NAN : 1;
    et_status status = et_answer_fast(reply, request);

    c->calls++;
    if (status != ET_OK || request->op != c->op || c->how == RIGHT)
        return status;
    const int ok = reply->kind == ET_REPLY_OK && reply->count > 0;
    c->spoilt += (size_t)ok;
    if (c->how == OFF_BY_ONE && ok)
        reply->x[0] += 1;
    else if (c->how == NAN_ALWAYS && ok)
        reply->x[0] = wrong;
    else if (c->how == FORGETS && ok)
        reply->x[0] += (double)(c->calls % 1000);
    else if (c->how == TOO_MANY && ok)
        status = et_reply_put(reply, &wrong, 1);
    else if (c->how == REFUSES || c->how == DECLINES) {
        et_reply_free(reply);
        reply->kind = c->how == REFUSES ? ET_REPLY_REFUSED : ET_REPLY_UNSUPPORTED;
    } else if (c->how == ACCEPTS && reply->kind == ET_REPLY_REFUSED) {
        et_reply_free(reply);
        status = et_reply_put(reply, &wrong, 1);
    }
    return status;
}

static et_peer *wrap(context *c)
{
    et_peer_table table;
    et_peer *peer = NULL;

    memset(&table, 0, sizeof table);
    table.hello = et_answer_hello(0);
    table.answer = answer;
    table.context = c;
    return et_peer_wrap(&peer, &table) == ET_OK ? peer : NULL;
}

/* Operations that are cheap to judge. */
static const et_request_op cheap[] = { ET_OP_SPAN, ET_OP_MULTIPLICITY, ET_OP_GREVILLE, ET_OP_NET_COUNTS, ET_OP_NET_CLASS };

static et_conform_options choose(gen *g, size_t first, size_t second)
{
    et_conform_options o = et_conform_defaults();

    memset(o.op, 0, sizeof o.op);
    o.op[cheap[first]] = o.op[cheap[second]] = 1;
    o.seed = gen_upto(g, 1000);
    o.findings = (size_t)gen_upto(g, 2);
    return o;
}

verdict prop_conform_defaults(gen *g)
{
    const et_conform_options o = et_conform_defaults();
    bool ok = gen_check(g, o.level == 0 && o.seed == 1 && o.cases == 10000 && !o.vectors && o.findings == 3, "the settings told");

    for (int op = 0; ok && op < ET_OPS; op++)
        ok = gen_check(g, o.op[op] == 1, "operation %d", op);
    return ok ? PASS : FAIL;
}

static bool told_rightly(gen *g, const et_conform_report *r, const et_conform_options *o, conduct how)
{
    size_t told[ET_OPS][ET_VERDICTS] = { { 0 } };
    bool ok = true;

    for (size_t k = 0; ok && k < r->findings; k++) {
        const et_conform_finding *f = &r->finding[k];
        ok = gen_check(g, et_judge_bad(f->judgement.verdict) && f->request && ++told[f->op][f->judgement.verdict] <= o->findings, "finding %zu", k);
        ok = ok && gen_check(g, r->count[f->op][f->category][f->judgement.verdict] > 0, "it is counted");
        ok = ok && gen_check(g, !f->shrunk || f->shrunk_judgement.verdict == f->judgement.verdict, "made small, it is the same fault");
        ok = ok && gen_check(g, how == FORGETS || how == DECLINES || (f->shrunk && strlen(f->shrunk) <= strlen(f->request) + 8),
                             "'%s', not smaller than '%s'",
                             f->shrunk ? f->shrunk : "", f->request);
    }
    return ok;
}

/* One case in 8. */
verdict prop_conform_run(gen *g)
{
    static const et_verdict bad[CONDUCTS] = { ET_VERDICT_CORRECTLY_ROUNDED, ET_VERDICT_WRONG, ET_VERDICT_NON_FINITE, ET_VERDICT_WRONGLY_REFUSED,
                                              ET_VERDICT_WRONGLY_ACCEPTED, ET_VERDICT_WRONGLY_REFUSED, ET_VERDICT_NONDETERMINISTIC,
                                                  ET_VERDICT_WRONG };
    const conduct how = (conduct)gen_upto(g, CONDUCTS - 1);
    const size_t first = (size_t)gen_upto(g, 4), second = (size_t)gen_upto(g, 4);
    context c = { how, cheap[first], 0, 0 };
    const et_conform_options o = choose(g, first, second);
    et_peer *peer = wrap(&c);
    et_conform_report r;
    size_t total = 0;

    if (!gen_check(g, peer != NULL, "wrapped"))
        return FAIL;
    bool ok = gen_check(g, et_conform_run(&r, peer, &o, NULL, NULL) == ET_OK, "the run ends well");
    for (int op = 0; op < ET_OPS; op++)
        for (int v = 0; v < ET_VERDICTS; v++)
            total += count_of(&r, (et_request_op)op, (et_verdict)v);
    ok = ok && gen_check(g, r.asked > 0 && r.skipped == 0 && total == r.asked + (how == DECLINES), "%zu verdicts on %zu requests", total, r.asked);
    if (how == RIGHT)
        ok = ok && gen_check(g, bad_of(&r) == 0 && r.findings == 0 && c.calls == 2 * r.asked, "nothing is wrong, each is asked twice: %zu", c.calls);
    else if (how == DECLINES)
        ok = ok && gen_check(g, bad_of(&r) == 1 && count_of(&r, c.op, ET_VERDICT_WRONGLY_REFUSED) == 1, "what is never answered is one fault");
    else
        ok = ok && gen_check(g, count_of(&r, c.op, bad[how]) > 0 || how == NAN_ALWAYS, "the fault %d is found", (int)how);
    if (how == OFF_BY_ONE || how == TOO_MANY)
        ok = ok && gen_check(g, bad_of(&r) >= r.asked / 8 && (first == second || count_of(&r, cheap[second], ET_VERDICT_WRONG) == 0),
                             "and nowhere else");
    ok = ok && told_rightly(g, &r, &o, how);
    et_conform_free(&r);
    et_peer_stop(peer);
    return ok ? PASS : FAIL;
}

/* The same seed, the same report; another level, more requests. */
/* One case in 20. */
verdict prop_conform_run_again(gen *g)
{
    const size_t first = (size_t)gen_upto(g, 4);
    et_conform_options o = choose(g, first, first);
    context c[3] = { { OFF_BY_ONE, cheap[first], 0, 0 }, { OFF_BY_ONE, cheap[first], 0, 0 }, { RIGHT, cheap[first], 0, 0 } };
    et_conform_report r[3];
    bool ok = true;

    o.cases = (size_t)gen_upto(g, 40);
    for (int k = 0; k < 3; k++) {
        et_peer *peer = wrap(&c[k]);
        o.level = k == 2 ? 2 : 0;
        ok = gen_check(g, peer && et_conform_run(&r[k], peer, &o, NULL, NULL) == ET_OK, "run %d", k) && ok;
        et_peer_stop(peer);
    }
    ok = ok && gen_check(g, memcmp(r[0].count, r[1].count, sizeof r[0].count) == 0 && r[0].findings == r[1].findings, "the same");
    for (size_t k = 0; ok && k < r[0].findings; k++)
        ok = gen_check(g, strcmp(r[0].finding[k].request, r[1].finding[k].request) == 0, "finding %zu", k);
    ok = ok && gen_check(g, r[2].asked + count_of(&r[2], cheap[first], ET_VERDICT_UNSUPPORTED) >= r[0].asked + o.cases, "%zu, then %zu", r[0].asked,
                         r[2].asked);
    for (int k = 0; k < 3; k++)
        et_conform_free(&r[k]);
    return ok ? PASS : FAIL;
}

/* One case in 20. */
verdict prop_conform_run_stopped(gen *g)
{
    const et_conform_options o = choose(g, 0, 1);
    patience p = { 0, (size_t)gen_upto(g, 40) };
    const et_task task = { step, &p };
    context c = { RIGHT, ET_OP_SPAN, 0, 0 };
    et_peer *peer = wrap(&c);
    et_message message = { "" };
    et_conform_report r;
    const et_status status = et_conform_run(&r, peer, &o, &task, &message);
    bool ok = gen_check(g, status == (p.calls > p.most ? ET_ESTOPPED : ET_OK), "status %d after %zu steps", (int)status, p.calls);

    ok = ok && gen_check(g, status == ET_OK || (r.asked <= p.most + 1 && r.skipped == 0 && message.text[0]), "%zu requests were asked", r.asked);
    ok = ok && gen_check(g, bad_of(&r) == 0, "what was asked is judged");
    et_conform_free(&r);
    et_peer_stop(peer);
    return ok ? PASS : FAIL;
}

/* No folder, no vectors. */
/* One case in 100. */
verdict prop_conform_run_vectors(gen *g)
{
    et_conform_options o = choose(g, 0, 0);
    context c = { RIGHT, ET_OP_SPAN, 0, 0 };
    et_peer *peer = wrap(&c);
    et_message message = { "" };
    et_conform_report r;

    o.level = 1;
    o.vectors = "there/is/no/such/folder";
    bool ok = gen_check(g, et_conform_run(&r, peer, &o, NULL, &message) == ET_EIO && strstr(message.text, o.vectors), "'%s'", message.text);
    ok = ok && gen_check(g, r.asked > 0, "what was asked before is delivered");
    et_conform_free(&r);
    et_peer_stop(peer);
    return ok ? PASS : FAIL;
}

/* One case in 20. */
verdict prop_conform_free(gen *g)
{
    const et_conform_options o = choose(g, (size_t)gen_upto(g, 4), 0);
    context c = { TOO_MANY, ET_OP_SPAN, 0, 0 };
    et_peer *peer = wrap(&c);
    et_conform_report r;
    bool ok = gen_check(g, et_conform_run(&r, peer, &o, NULL, NULL) == ET_OK, "run");

    et_conform_free(&r);
    ok = ok && gen_check(g, !r.finding && r.findings == 0 && r.asked == 0 && bad_of(&r) == 0, "zeroed");
    et_conform_free(&r);
    et_peer_stop(peer);
    return ok ? PASS : FAIL;
}
