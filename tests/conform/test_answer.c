/* conform/answer: what is offered, answered and refused; the judge has nothing to say against any answer. */
#include "judge_kit.h"

verdict prop_answer_hello(gen *g)
{
    bool ok = true;

    for (int exact = 0; exact < 2; exact++) {
        const et_hello h = et_answer_hello(exact), again = et_answer_hello(exact);
        ok = ok && gen_check(g, memcmp(&h, &again, sizeof h) == 0, "another hello");
        ok = ok && gen_check(g, h.name[0] && h.version[0] && !strpbrk(h.name, " \t") && !strpbrk(h.version, " \t"), "name or version");
        ok = ok && gen_check(g, h.any && h.left && h.right && h.rational && h.knot_tolerance == 0 && h.unknown == 0, "limits, weights");
        ok = ok && gen_check(g, h.degree == 64 && h.order == 8, "degree, order");
        for (int op = 0; op < ET_OPS; op++)
            ok = ok && gen_check(g, h.op[op] == (exact || (op != ET_OP_CURVE_NEAREST && op != ET_OP_SURFACE_NEAREST)), "%d", op);
        for (int op = ET_OPS; op < 64; op++)
            ok = ok && gen_check(g, h.op[op] == 0, "%d is no operation", op);
    }
    return ok ? PASS : FAIL;
}

typedef et_status answerer(et_reply *reply, const et_request *request);

/* Kind and count as validity and truth say. */
static bool kinds(gen *g, const et_request *request, const et_truth *truth, const et_reply *reply, int exact)
{
    const et_hello h = et_answer_hello(exact);

    if (!h.op[request->op])
        return gen_check(g, reply->kind == ET_REPLY_UNSUPPORTED && reply->count == 0 && reply->reason[0], "not unsupported");
    bool ok = gen_check(g, reply->kind != ET_REPLY_UNSUPPORTED, "unsupported");
    if (truth->validity == ET_INVALID)
        ok = ok && gen_check(g, reply->kind == ET_REPLY_REFUSED && strcmp(reply->reason, truth->reason) == 0, "%s, refused because %s",
                truth->reason, reply->reason);
    else if (truth->validity == ET_VALID)
        ok = ok && gen_check(g, reply->kind == ET_REPLY_OK, "refused: %s", reply->reason);
    else if (truth->count == 0)
        ok = ok && gen_check(g, reply->kind == ET_REPLY_REFUSED && reply->reason[0], "answered without a right value");
    if (reply->kind == ET_REPLY_OK && request->op != ET_OP_APPROXIMATE && request->op != ET_OP_CURVE_REMOVE && request->op != ET_OP_SURFACE_REMOVE)
        ok = ok && gen_check(g, reply->count == truth->count, "%zu numbers, %zu wanted", reply->count, truth->count);
    return ok;
}

/* Where there is but one right answer. */
static bool single(const et_request *request)
{
    return request->op != ET_OP_APPROXIMATE && ((request->op != ET_OP_CURVE_REMOVE && request->op != ET_OP_SURFACE_REMOVE)
                                                 || request->arg[request->op == ET_OP_CURVE_REMOVE ? 6 : 9].x[0] == 0);
}

static verdict answers(gen *g, answerer *answer, int exact, et_request_op op)
{
    et_request r;
    et_truth t;
    et_reply reply, again;
    et_judgement j;

    if (!kit_draw(g, &r, op, ET_CATEGORIES))
        return FAIL;
    const et_status known = et_judge_truth(&t, &r);
    bool ok = gen_check(g, known == ET_OK || known == ET_ENOCONV, "truth") && gen_check(g, answer(&reply, &r) == ET_OK, "not answered");
    if (known != ET_OK || !ok) {
        if (ok)
            et_reply_free(&reply);
        et_request_free(&r);
        return ok ? SKIP : FAIL;
    }
    ok = kinds(g, &r, &t, &reply, exact) && gen_check(g, et_judge_reply(&j, &r, &t, &reply) == ET_OK, "not judged");
    ok = ok && gen_check(g, !et_judge_bad(j.verdict), "%s: %s", et_judge_name(j.verdict), j.text);
    if (exact && reply.kind == ET_REPLY_OK && single(&r))
        ok = ok && kit_is(g, &j, ET_VERDICT_CORRECTLY_ROUNDED, "exact");
    ok = ok && gen_check(g, answer(&again, &r) == ET_OK && et_reply_same(&reply, &again), "another answer");
    et_reply_free(&again);
    et_reply_free(&reply);
    et_judge_free(&t);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* One case in 3. */
verdict prop_answer_fast(gen *g)
{
    return answers(g, et_answer_fast, 0, kit_op(g));
}

/* One case in 3. */
verdict prop_answer_exact(gen *g)
{
    return answers(g, et_answer_exact, 1, kit_op(g));
}

/* One case in 40. */
verdict prop_answer_exact_all(gen *g)
{
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);

    return answers(g, et_answer_exact, 1, op == ET_OP_SURFACE_NEAREST && !gen_chance(g, 8) ? ET_OP_SEAM_GAP : op);
}

/* One case in 40. */
verdict prop_answer_fast_all(gen *g)
{
    return answers(g, et_answer_fast, 0, (et_request_op)gen_upto(g, ET_OPS - 1));
}

/* Whatever the numbers are: no number, no end, of the wrong size. */
static void break_request(gen *g, et_request *r)
{
    static const double odd[] = { NAN, INFINITY, -INFINITY, 0x1.fffffffffffffp+1023, -0x1p+1023, 0x1p-1074, 0.0, -0.0, -1.0, 0x1p+60 };
    static const size_t counts[] = { 0, 1, 2, 3, 1000, (size_t)1 << 31, SIZE_MAX / 3, SIZE_MAX };
    size_t n = 0;

    while (et_request_argument(r->op, n))
        n++;
    for (size_t times = gen_between(g, 1, 3); times > 0; times--) {
        const size_t k = gen_upto(g, n - 1);
        const et_request_kind kind = et_request_argument(r->op, k)->kind;
        et_request_value *a = &r->arg[k];
        const size_t have = kind == ET_ARG_REAL ? 1 : kind == ET_ARG_REALS ? a->count : kind == ET_ARG_POINTS ? 3 * a->count : 0;
        if (have > 0 && gen_chance(g, 2))
            a->x[gen_upto(g, have - 1)] = odd[gen_upto(g, sizeof odd / sizeof *odd - 1)];
        else if (kind == ET_ARG_COUNT || kind == ET_ARG_WORD)
            a->count = counts[gen_upto(g, sizeof counts / sizeof *counts - 1)];
        else if (have > 0 && kind != ET_ARG_REAL)
            a->count = gen_upto(g, a->count - 1);
    }
}

static bool still(gen *g, answerer *answer, const et_request *r, et_validity validity, const char *reason)
{
    et_reply reply;

    if (!gen_check(g, answer(&reply, r) == ET_OK, "not answered"))
        return false;
    const bool ok = validity != ET_INVALID
                    || gen_check(g, reply.kind == ET_REPLY_UNSUPPORTED || (reply.kind == ET_REPLY_REFUSED && strcmp(reply.reason, reason) == 0),
                            "%s", reply.reason);
    et_reply_free(&reply);
    return ok;
}

/* Broken requests are answered or refused, nothing else: no crash, no endless run, no memory without end. */
/* One case in 3. */
verdict prop_answer_fast_broken(gen *g)
{
    et_request r;
    char reason[128];

    if (!kit_draw(g, &r, kit_op(g), ET_CATEGORIES))
        return FAIL;
    break_request(g, &r);
    const et_validity validity = et_judge_validity(reason, &r);
    gen_label(g, et_judge_validity_name(validity));
    const bool ok = still(g, et_answer_fast, &r, validity, reason) && still(g, et_answer_exact, &r, validity, reason);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* What is invalid the fast functions' own tests of curves and surfaces do not let through either. */
verdict prop_answer_fast_refusals(gen *g)
{
    static const et_request_op ops[] = { ET_OP_CURVE_POINT, ET_OP_SURFACE_POINT };
    const size_t which = gen_upto(g, 1);
    et_request r;
    et_curve c;
    et_surface s;
    char reason[128];

    if (!kit_draw(g, &r, ops[which], ET_CATEGORIES))
        return FAIL;
    r.arg[which ? 6 : 4].x[0] = r.arg[1 + which].count > 2 * r.arg[0].count + 1 ? r.arg[1 + which].x[r.arg[0].count] : 0;
    if (which)
        r.arg[7].x[0] = r.arg[3].count > 2 * r.arg[1].count + 1 ? r.arg[3].x[r.arg[1].count] : 0;
    if (gen_chance(g, 2))
        break_request(g, &r);
    const et_validity validity = et_judge_validity(reason, &r);
    const bool made = which ? et_request_surface(&s, &r, 0) == ET_OK : et_request_curve(&c, &r, 0) == ET_OK;
    const bool accepted = made && (which ? et_surface_valid(&s) : et_curve_valid(&c));
    const bool ends = made && (which ? isfinite(r.arg[6].x[0]) && isfinite(r.arg[7].x[0]) : isfinite(r.arg[4].x[0]));
    const bool sides = r.arg[which ? 8 : 5].count <= 2 && r.arg[which ? 9 : 5].count <= 2;
    et_reply reply;
    bool ok = gen_check(g, !accepted || !ends || !sides || validity != ET_INVALID, "invalid (%s), accepted", reason);
    ok = ok && gen_check(g, validity != ET_VALID || accepted, "valid, not accepted");
    if (ok && gen_check(g, et_answer_fast(&reply, &r) == ET_OK, "not answered")) {
        ok = gen_check(g, reply.kind != ET_REPLY_OK || accepted, "answered, not accepted (%s)", reason);
        et_reply_free(&reply);
    }
    gen_label(g, accepted ? "accepted" : "refused");
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* What is no operation is refused, whatever its arguments. */
verdict prop_answer_fast_no_operation(gen *g)
{
    answerer *const answer = gen_chance(g, 2) ? et_answer_exact : et_answer_fast;
    et_request none;
    et_reply reply;

    memset(&none, 0, sizeof none);
    none.op = (et_request_op)(ET_OPS + gen_upto(g, 3));
    none.arg[0].count = (size_t)gen_upto(g, 9);
    const bool ok = gen_check(g, answer(&reply, &none) == ET_OK && reply.kind == ET_REPLY_REFUSED && strcmp(reply.reason, "no such operation") == 0,
                              "not refused");
    et_reply_free(&reply);
    return ok ? PASS : FAIL;
}

/* Data near the greatest double, to and fro: the control points of the surface through them are beyond it, and there is no surface to answer. */
/* One case in 100. */
verdict prop_answer_exact_beyond(gen *g)
{
    answerer *const answer = gen_chance(g, 2) ? et_answer_exact : et_answer_fast;
    et_request r = kit_parse("approximate 3 1 5 2 5 2 10 "
                             "0 0 0x1.fp1023 1 0 0x1.fp1023 0 1 -0x1.fp1023 1 1 -0x1.fp1023 0 2 0x1.fp1023 1 2 0x1.fp1023 "
                             "0 3 -0x1.fp1023 1 3 -0x1.fp1023 0 4 0x1.fp1023 1 4 0x1.fp1023");
    et_reply reply;
    char reason[128];
    bool ok = gen_check(g, et_judge_validity(reason, &r) == ET_VALID && answer(&reply, &r) == ET_OK, "answered");

    ok = ok && gen_check(g, reply.kind == ET_REPLY_REFUSED && reply.reason[0] && reply.count == 0, "kind %d, %zu numbers: %s", (int)reply.kind,
                         reply.count, reply.reason);
    et_reply_free(&reply);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* Knots beyond the domain and knots that stand too often: functions without a place in the domain, whose control points are far away and do not
 * matter. */
/* One case in 50. */
verdict prop_answer_fast_nowhere(gen *g)
{
#define FLAT "4 0 0 1 1 "
#define NEAR "0 0 0 0 1 0 1 0 1 1 1 0 2 0 0 2 1 1 "
#define FAR "0x1p1000 0 0 0x1p1000 1 0 "
    static const char *const lines[] = {
        "surface_error 1 1 6 0 0 1 1 1 2 " FLAT "8 " NEAR FAR "0 2 0x1p-2 0x1p-1 1 0x1p-1 2 1 1 1 0 0x1p-1 0x1p-2",
        "surface_error 1 1 6 -1 0 0 0 1 1 " FLAT "8 " FAR NEAR "0 1 0x1p-1 1 0x1p-1 1 1 1 1",
        "surface_error 1 1 5 0 0 1 1 1 " FLAT "6 0 0 0 0 1 0 1 0 1 1 1 0 " FAR "0 1 0x1p-2 1 0x1p-1 1 1 1 1",
    };
    et_request r = kit_parse(lines[gen_upto(g, 2)]);
    et_truth truth;
    et_judgement j;
    et_reply reply;

    if (!gen_check(g, et_judge_truth(&truth, &r) == ET_OK && truth.count == 2 && truth.validity == ET_IMPLEMENTATION_DEFINED, "no truth"))
        return FAIL;
    bool ok = gen_check(g, et_answer_fast(&reply, &r) == ET_OK && et_judge_reply(&j, &r, &truth, &reply) == ET_OK, "judged");
    ok = ok && gen_check(g, reply.kind == ET_REPLY_OK && j.verdict <= ET_VERDICT_WITHIN_BOUND, "%s (%s)", et_judge_name(j.verdict), j.text);
    et_reply_free(&reply);
    et_judge_free(&truth);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}
