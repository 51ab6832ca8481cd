/* conform/judge: right answers of every operation with one number altered, dropped or added. */
#include "conform/judge_kit.h"
#include <stdio.h>

verdict prop_judge_reply_altered(gen *g);
verdict prop_judge_validity_numbers(gen *g);
verdict prop_judge_truth_each(gen *g);

enum { MOST = 90 };

/* All alterations of one answer: none speaks better for the reply than the answer itself, and what is no count or not finite is never right. */
static bool altered(gen *g, const et_request *q, const et_truth *truth, const et_reply *right)
{
    static const double wrong[] = { (double)NAN, (double)INFINITY, -1, 0.5, 0x1p40, 0 };
    bool ok = true;

    for (size_t i = 0; ok && i < right->count && i < MOST; i++)
        for (size_t k = 0; ok && k < sizeof wrong / sizeof *wrong; k++) {
            const double was = right->x[i];
            const double free_number = truth->count == right->count && isinf(truth->bound[i]);
            et_judgement j;
            if (i > 8 && (i + k) % 13 != 0)
                continue;
            right->x[i] = k < 5 ? wrong[k] : was + 1;
            ok = gen_check(g, et_judge_reply(&j, q, truth, right) == ET_OK && j.verdict < ET_VERDICTS, "judged");
            ok = ok && gen_check(g, k >= 2 || free_number > 0 || truth->count == 0 || et_judge_bad(j.verdict), "%s: number %zu is not finite, and %s",
                                 et_request_name(q->op), i, et_judge_name(j.verdict));
            ok = ok && gen_check(g, !et_judge_bad(j.verdict) || j.text[0], "%s: a fault is told", et_request_name(q->op));
            right->x[i] = was;
        }
    return ok;
}

/* One more number, one less, none; another kind of reply. */
static bool cut(gen *g, const et_request *q, const et_truth *truth, et_reply *reply)
{
    const double more = 1;
    et_judgement j;
    bool ok = gen_check(g, et_reply_put(reply, &more, 1) == ET_OK && et_judge_reply(&j, q, truth, reply) == ET_OK, "one more");

    ok = ok && gen_check(g, truth->count == 0 || j.verdict == ET_VERDICT_WRONG, "%s: one number more is %s", et_request_name(q->op),
                         et_judge_name(j.verdict));
    reply->count -= 2;
    ok = ok && gen_check(g, et_judge_reply(&j, q, truth, reply) == ET_OK && (truth->count == 0 || et_judge_bad(j.verdict)), "%s: one less",
                         et_request_name(q->op));
    reply->count = 0;
    ok = ok && gen_check(g, et_judge_reply(&j, q, truth, reply) == ET_OK && (truth->count == 0 || et_judge_bad(j.verdict)), "%s: none",
                         et_request_name(q->op));
    return ok;
}

/* One case in 1000. */
verdict prop_judge_reply_altered(gen *g)
{
    const et_hello all = et_answer_hello(1);
    bool ok = true;

    for (int op = 0; ok && op < ET_OPS; op++)
        for (int c = 0; ok && c < ET_CATEGORIES; c++)
            for (uint64_t number = 0; ok && number < 2; number++) {
                et_request q;
                et_truth truth;
                et_reply right;
                if (op == ET_OP_SURFACE_NEAREST || op == ET_OP_FIT_SCATTERED || c == ET_CATEGORY_SIZE || c == ET_CATEGORY_DEGREES
                    || et_campaign_draw(&q, (et_request_op)op, (et_category)c, 2, number, &all) != ET_OK)
                    continue;
                if (et_judge_truth(&truth, &q) == ET_OK) {
                    ok = gen_check(g, et_answer_exact(&right, &q) == ET_OK, "answered");
                    if (ok && right.kind == ET_REPLY_OK && right.count > 0)
                        ok = altered(g, &q, &truth, &right) && cut(g, &q, &truth, &right);
                    et_reply_free(&right);
                    et_judge_free(&truth);
                }
                et_request_free(&q);
            }
    return ok ? PASS : FAIL;
}

/* Words and counts that no line can hold, given by whoever calls. */
/* One case in 1000. */
verdict prop_judge_validity_numbers(gen *g)
{
    static const struct { const char *line; size_t arg, count; et_validity is; } all[] = {
        { "surface_insert 1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 0 u 0x1p-1 1", 6, 2, ET_INVALID },
        { "knots uniform 1 2 2 0x0p+0 0x1p+0", 0, 4, ET_INVALID }, { "knots uniform 1 2 2 0x0p+0 0x1p+0", 1, 65, ET_INVALID },
        { "parameters chord 2 0 0 0 1 1 1", 0, 4, ET_INVALID }, { "net_node 2 2 1", 2, 0, ET_INVALID }, { "net_node 2 2 1", 2, 5, ET_INVALID },
        { "net_class 2 2 1 1 1", 2, 2, ET_INVALID }, { "net_class 2 2 1 1 1", 0, (size_t)1 << 53, ET_IMPLEMENTATION_DEFINED },
        { "fit_grid interpolated 1 1 4 0 0 1 1 4 0 0 1 1 2 0 1 2 0 1 4 0 0 0 0 1 0 1 0 0 1 1 1", 0, 2, ET_INVALID },
        { "approximate 1 1 2 2 2 2 4 0 0 0 0 1 0 1 0 0 1 1 1", 0, 65, ET_INVALID },
        { "basis_ders 1 4 0 0 1 1 0x1p-1 any 1", 4, 65, ET_IMPLEMENTATION_DEFINED },
    };
    static const struct { const char *line; et_validity is; } large[] = {
        { "knots uniform 65 66 2 0x0p+0 0x1p+0", ET_IMPLEMENTATION_DEFINED }, { "net_node 9007199254740992 9007199254740992 1", ET_IMPLEMENTATION_DEFINED },
        { "net_node 9007199254740992 9007199254740992 0", ET_INVALID }, { "net_counts 9007199254740992 9007199254740992", ET_IMPLEMENTATION_DEFINED },
        { "approximate 65 1 66 2 66 2 132" , ET_IMPLEMENTATION_DEFINED }, { "approximate 1 65 2 66 2 66 132" , ET_IMPLEMENTATION_DEFINED },
    };
    et_request none;
    char reason[128];
    bool ok = true;

    memset(&none, 0, sizeof none);
    none.op = ET_OPS;
    ok = gen_check(g, et_judge_validity(reason, &none) == ET_INVALID && reason[0], "no operation");
    for (size_t k = 0; ok && k < sizeof large / sizeof *large; k++) {
        char line[1200];
        size_t n = (size_t)snprintf(line, sizeof line, "%s", large[k].line);
        for (size_t i = 0; strncmp(line, "approximate", 11) == 0 && i < 3 * 132; i++)
            n += (size_t)snprintf(line + n, sizeof line - n, " %zu", i % 10);
        et_request q = kit_parse(line);
        const et_validity v = et_judge_validity(reason, &q);
        ok = gen_check(g, v == large[k].is && reason[0], "%s: %d, %s", large[k].line, (int)v, reason);
        et_request_free(&q);
    }
    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++) {
        et_request q = kit_parse(all[k].line);
        ok = gen_check(g, et_judge_validity(reason, &q) == ET_VALID, "%s: %s", all[k].line, reason);
        q.arg[all[k].arg].count = all[k].count;
        const et_validity v = et_judge_validity(reason, &q);
        ok = ok && gen_check(g, v == all[k].is && reason[0], "%s with %zu: %d, %s", all[k].line, all[k].count, (int)v, reason);
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

/* Numbers at both ends of the range, sides that jump and do not: judged as the exact layer says, and by the fast answer. */
/* One case in 1000. */
verdict prop_judge_truth_each(gen *g)
{
#define JUMP_U "1 1 6 0 0 0x1p-1 0x1p-1 1 1 4 0 0 1 1 8 0 0 0 0 1 0 1 0 0 1 1 1 2 0 1 2 1 0 3 0 0 3 1 1 0 "
#define JUMP_V "1 1 4 0 0 1 1 6 0 0 0x1p-1 0x1p-1 1 1 8 0 0 0 0 1 0 0 2 1 0 3 1 1 0 0 1 1 1 1 2 0 1 3 1 0 "
#define JUMP_UV "1 1 6 0 0 0x1p-1 0x1p-1 1 1 6 0 0 0x1p-1 0x1p-1 1 1 16 0 0 0 0 1 0 0 2 1 0 3 1 1 0 0 1 1 1 1 2 0 1 3 1 " \
                "2 0 0 2 1 0 2 2 1 2 3 1 3 0 0 3 1 1 3 2 0 3 3 1 0 "
    static const char *const lines[] = {
        "surface_normal " JUMP_U "0x1p-1 0x1p-2", "surface_normal " JUMP_V "0x1p-2 0x1p-1", "surface_normal " JUMP_UV "0x1p-1 0x1p-1",
        "surface_normal " JUMP_UV "0x1p-1 0x1p+0", "surface_point " JUMP_UV "0x1p-1 0x1p-1 any any", "surface_ders " JUMP_UV "0x1p-1 0x1p-1 any left 2",
        "surface_ders " JUMP_UV "0x1p-1 0x1p-2 left any 12", "curve_nearest 1 4 0 0 1 1 2 0 0 0 0 0 0 0 1 0 0 0",
        "curve_nearest 1 4 0 0 1 1 2 0 0 0 0x1p-1040 0 0 0 1 0 0 0", "curve_nearest 1 4 0 0 1 1 2 0 0 0 0x1p+900 0 0 0 1 0x1p+800 1 0",
        "curve_nearest 1 4 0 0 1 1 2 0 0 0 0x1.fffffffffffffp+1023 0 0 0 1 -0x1.fffffffffffffp+1023 0 0",
        "fit_curve 1 4 0 0 1 1 3 0 0x1p-1 1 3 0 0 0 0x1p+1023 1 1 2 2 2", "fit_curve 1 4 0 0 1 1 3 0 0 0 3 0 0 0 1 1 1 2 2 2",
        "curve_remove 2 7 0 0 0 0x1p-1 1 1 1 4 0 0 0 1 2 0 2 2 0x1p-3 3 0 1 0 0x1p-1 1 0",
        "curve_remove 2 7 0 0 0 0x1p-1 1 1 1 4 0 0 0 1 2 0 2 2 0x1p-3 3 0 1 0 0x1p-1 1 0x1p+10",
        "surface_error " JUMP_UV "1 0x1p-2 1 0x1p-2 1 0 0 0",
    };
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof lines / sizeof *lines; k++) {
        et_request q = kit_parse(lines[k]);
        et_truth truth;
        const et_status status = et_judge_truth(&truth, &q);
        ok = gen_check(g, status == ET_OK || status == ET_ENOCONV, "%s: status %d", lines[k], (int)status);
        for (int exact = 0; ok && status == ET_OK && exact < 2; exact++) {
            et_judgement j;
            et_reply reply;
            ok = gen_check(g, (exact ? et_answer_exact : et_answer_fast)(&reply, &q) == ET_OK && et_judge_reply(&j, &q, &truth, &reply) == ET_OK, "answered");
            ok = ok && gen_check(g, !et_judge_bad(j.verdict) || (!exact && reply.kind == ET_REPLY_REFUSED), "%s: %s: %s", lines[k], et_judge_name(j.verdict),
                                 j.text);
            et_reply_free(&reply);
        }
        if (status == ET_OK)
            et_judge_free(&truth);
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}
