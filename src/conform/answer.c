#include "etalon/conform/answer.h"
#include "conform/answer_parts.h"
#include "conform/judge_parts.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

et_hello et_answer_hello(int exact)
{
    et_hello hello;

    memset(&hello, 0, sizeof hello);
    snprintf(hello.name, sizeof hello.name, "%s", exact ? "etalon-exact" : "etalon");
    snprintf(hello.version, sizeof hello.version, "0.1.0");
    hello.degree = JUDGE_DEGREE;
    hello.order = 8;
    hello.rational = hello.any = hello.left = hello.right = 1;
    for (int op = 0; op < ET_OPS; op++)
        hello.op[op] = exact || (op != ET_OP_CURVE_NEAREST && op != ET_OP_SURFACE_NEAREST);
    return hello;
}

static void decline(et_reply *reply, et_reply_kind kind, const char *reason)
{
    et_reply_free(reply);
    reply->kind = kind;
    snprintf(reply->reason, sizeof reply->reason, "%s", reason);
}

/* Invalid requests, and those that have no right value, are refused. */
static int refused(et_reply *reply, const et_request *request)
{
    judge_case c;
    char reason[128];

    judge_valid(&c, request);
    if (c.validity == ET_VALID || c.known)
        c.validity = et_judge_validity(reason, request);
    else
        snprintf(reason, sizeof reason, "%s", c.reason);
    if (c.validity != ET_INVALID && c.known)
        return 0;
    decline(reply, ET_REPLY_REFUSED, reason);
    return 1;
}

static et_status compute(et_reply *reply, const et_request *request)
{
    switch (request->op) {
    case ET_OP_SPAN: case ET_OP_MULTIPLICITY: case ET_OP_GREVILLE: case ET_OP_BASIS: case ET_OP_BASIS_DERS:
        return answer_basis(reply, request);
    case ET_OP_CURVE_POINT: case ET_OP_CURVE_DERS: case ET_OP_SURFACE_POINT: case ET_OP_SURFACE_DERS: case ET_OP_SURFACE_NORMAL:
        return answer_point(reply, request);
    case ET_OP_CURVE_INSERT: case ET_OP_CURVE_REMOVE: case ET_OP_CURVE_ELEVATE:
    case ET_OP_SURFACE_INSERT: case ET_OP_SURFACE_REMOVE: case ET_OP_SURFACE_ELEVATE:
        return answer_edit(reply, request);
    case ET_OP_PARAMETERS: case ET_OP_PARAMETERS_GRID: case ET_OP_KNOTS:
        return answer_parameters(reply, request);
    case ET_OP_FIT_CURVE: case ET_OP_FIT_GRID: case ET_OP_FIT_SCATTERED:
        return answer_fit(reply, request);
    case ET_OP_APPROXIMATE:
        return answer_approximate(reply, request, 0);
    case ET_OP_SURFACE_ERROR: case ET_OP_SEAM_GAP:
        return answer_measure(reply, request);
    default:
        return answer_net(reply, request);
    }
}

et_status et_answer_fast(et_reply *reply, const et_request *request)
{
    et_reply made = { ET_REPLY_OK, 0, NULL, "" };
    const et_hello hello = et_answer_hello(0);

    if ((size_t)request->op < ET_OPS && !hello.op[request->op]) {
        decline(&made, ET_REPLY_UNSUPPORTED, "only the exact answer has it");
    } else if (!refused(&made, request)) {
        const et_status status = compute(&made, request);
        if (status == ET_ENOMEM) {
            et_reply_free(&made);
            return status;
        }
        if (status != ET_OK)
            decline(&made, ET_REPLY_REFUSED, et_status_text(status));
    }
    *reply = made;
    return ET_OK;
}

/* ---- exact ---- */

/* The fast removal where it takes more knots than go without any change. */
static et_status remove_more(et_reply *made, const et_request *request, const et_truth *truth)
{
    const double tolerance = request->arg[request->op == ET_OP_CURVE_REMOVE ? 6 : 9].x[0];
    et_reply more = { ET_REPLY_OK, 0, NULL, "" };

    if (tolerance == 0)
        return ET_OK;
    const et_status status = answer_edit(&more, request);
    if (status == ET_OK && more.x[0] > truth->want[0]) {
        et_reply_free(made);
        *made = more;
    } else {
        et_reply_free(&more);
    }
    return status == ET_ENOMEM ? status : ET_OK;
}

static et_status by_truth(et_reply *made, const et_request *request)
{
    et_truth truth;
    et_status status = et_judge_truth(&truth, request);

    if (status == ET_ENOMEM)
        return status;
    if (status != ET_OK) {
        decline(made, ET_REPLY_REFUSED, et_status_text(status));
        return ET_OK;
    }
    if (truth.validity == ET_INVALID || truth.count == 0)
        decline(made, ET_REPLY_REFUSED, truth.reason);
    else
        status = et_reply_put(made, truth.want, truth.count);
    if (status == ET_OK && made->kind == ET_REPLY_OK && (request->op == ET_OP_CURVE_REMOVE || request->op == ET_OP_SURFACE_REMOVE))
        status = remove_more(made, request, &truth);
    et_judge_free(&truth);
    return status;
}

et_status et_answer_exact(et_reply *reply, const et_request *request)
{
    et_reply made = { ET_REPLY_OK, 0, NULL, "" };
    et_status status = ET_OK;

    if (request->op != ET_OP_APPROXIMATE)
        status = by_truth(&made, request);
    else if (!refused(&made, request)) {
        status = answer_approximate(&made, request, 1);
        if (status != ET_OK && status != ET_ENOMEM) {
            decline(&made, ET_REPLY_REFUSED, et_status_text(status));
            status = ET_OK;
        }
    }
    if (status == ET_OK)
        *reply = made;
    else
        et_reply_free(&made);
    return status;
}
