/* judge_kit: requests of all kinds to judge, and replies to them. */
#ifndef TESTS_CONFORM_JUDGE_KIT_H
#define TESTS_CONFORM_JUDGE_KIT_H
#include "etalon/conform/answer.h"
#include "etalon/conform/campaign.h"
#include "etalon/conform/judge.h"
#include "gen.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A request of the operation, of any category but what `but` excludes. */
static inline bool kit_draw(gen *g, et_request *r, et_request_op op, et_category but)
{
    const et_hello hello = et_answer_hello(1);
    et_category category = (et_category)gen_upto(g, ET_CATEGORIES - 1);
    const uint64_t seed = gen_upto(g, 1 << 20), number = gen_upto(g, 1 << 10);

    while (category == but || !et_campaign_has(op, category))
        category = (et_category)((category + 1) % ET_CATEGORIES);
    gen_note(g, "%s %s, seed %llu, number %llu", et_request_name(op), et_campaign_name(category), (unsigned long long)seed,
            (unsigned long long)number);
    gen_label(g, et_campaign_name(category));
    for (uint64_t k = 0; k < 4; k++)
        if (et_campaign_draw(r, op, category, seed, number + k, &hello) == ET_OK)
            return true;
    return gen_check(g, false, "not drawn");
}

/* Any operation but the nearest points of surfaces, of which some take a second, and those that are slow anyway one time in eight. */
static inline et_request_op kit_op(gen *g)
{
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    const bool slow = op == ET_OP_SEAM_GAP || op == ET_OP_FIT_SCATTERED || op == ET_OP_FIT_CURVE || op == ET_OP_FIT_GRID;

    return op == ET_OP_SURFACE_NEAREST || (slow && !gen_chance(g, 8)) ? ET_OP_CURVE_POINT : op;
}

static inline et_reply kit_reply(const double *x, size_t n)
{
    et_reply r = { ET_REPLY_OK, 0, NULL, "" };

    if (et_reply_put(&r, x, n) != ET_OK)
        abort();
    return r;
}

/* The numbers judged. */
static inline et_judgement kit_judge(gen *g, const et_request *request, const et_truth *truth, const double *x, size_t n)
{
    et_judgement j = { ET_VERDICTS, 0, 0, 0, 0, 0, "" };
    et_reply r = kit_reply(x, n);

    gen_check(g, et_judge_reply(&j, request, truth, &r) == ET_OK, "not judged");
    et_reply_free(&r);
    return j;
}

static inline bool kit_is(gen *g, const et_judgement *j, et_verdict right, const char *what)
{
    return gen_check(g, j->verdict == right, "%s: %s instead of %s (%s; got %a, want %a, bound %a)", what,
                     j->verdict < ET_VERDICTS ? et_judge_name(j->verdict) : "nothing", et_judge_name(right), j->text, j->got, j->want, j->bound);
}

/* Operations whose replies are judged with a look at the request. */
static inline bool kit_structured(et_request_op op)
{
    return op == ET_OP_CURVE_REMOVE || op == ET_OP_SURFACE_REMOVE || op == ET_OP_CURVE_NEAREST || op == ET_OP_SURFACE_NEAREST
            || op == ET_OP_APPROXIMATE;
}
static inline bool kit_editing(et_request_op op)
{
    return op == ET_OP_CURVE_INSERT || op == ET_OP_SURFACE_INSERT || op == ET_OP_CURVE_ELEVATE || op == ET_OP_SURFACE_ELEVATE;
}

static inline et_request kit_parse(const char *line)
{
    et_request r;
    et_message message = { "" };

    if (et_request_parse(&r, line, &message) != ET_OK)
        abort();
    return r;
}
#endif
