/* conform/answer: any line asked: an answer that the judge has nothing to say against. */
#include "etalon/conform/answer.h"
#include "etalon/conform/judge.h"
#include "lines.h"

enum { MOST = 1000 };

/* Elevated by more than 24 the rationals take seconds: right, but no fuzzing. */
static bool takes_long(const et_request *request)
{
    return (request->op == ET_OP_CURVE_ELEVATE && request->arg[4].count > 24) || (request->op == ET_OP_SURFACE_ELEVATE && request->arg[7].count > 24);
}

/* The same again, and right. */
static bool judged(gen *g, const et_request *request, const et_reply *reply, et_status (*answer)(et_reply *reply, const et_request *request))
{
    et_reply again;
    et_truth truth;
    et_judgement j;
    bool ok = gen_check(g, answer(&again, request) == ET_OK, "not answered again");

    if (ok) {
        ok = gen_check(g, et_reply_same(reply, &again), "another answer the second time");
        et_reply_free(&again);
    }
    if (!ok || et_judge_truth(&truth, request) != ET_OK)
        return ok;
    ok = gen_check(g, et_judge_reply(&j, request, &truth, reply) == ET_OK, "not judged");
    ok = ok && gen_check(g, !et_judge_bad(j.verdict), "%s: %s", et_judge_name(j.verdict), j.text);
    gen_label(g, ok ? et_judge_name(j.verdict) : "bad");
    et_judge_free(&truth);
    return ok;
}

static bool answered(gen *g, const et_request *request, et_status (*answer)(et_reply *reply, const et_request *request))
{
    et_reply reply;
    const et_status status = answer(&reply, request);
    bool ok = gen_check(g, status == ET_OK || status == ET_ENOMEM, "status %s", et_status_text(status));

    if (status == ET_OK) {
        ok = gen_check(g, reply.kind <= ET_REPLY_UNSUPPORTED && (reply.count == 0 || reply.x), "not a reply") && judged(g, request, &reply, answer);
        et_reply_free(&reply);
    }
    return ok;
}

static verdict asked(gen *g, et_status (*answer)(et_reply *reply, const et_request *request))
{
    char *const line = line_rest(g, MOST);
    et_request request;
    bool ok = line != NULL;

    if (ok && et_request_parse(&request, line, NULL) == ET_OK) {
        if (takes_long(&request))
            gen_label(g, "long");
        else
            ok = answered(g, &request, answer);
        et_request_free(&request);
    } else {
        gen_label(g, "no request");
    }
    free(line);
    return ok ? PASS : FAIL;
}

/* One case in 4. */
verdict prop_answer_fast_raw(gen *g)
{
    return asked(g, et_answer_fast);
}

/* One case in 4. */
verdict prop_answer_exact_raw(gen *g)
{
    return asked(g, et_answer_exact);
}
