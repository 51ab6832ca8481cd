/* Every operation in turn: bad input is bad, and what is shrunk stays what it is. */
#include "etalon/conform/answer.h"
#include "etalon/conform/campaign.h"
#include "etalon/conform/judge.h"
#include "gen.h"

verdict prop_campaign_draw_bad_input(gen *g);
verdict prop_campaign_shrink_validity(gen *g);

/* One case in 4. */
verdict prop_campaign_draw_bad_input(gen *g)
{
    const et_hello all = et_answer_hello(1);
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    const uint64_t seed = gen_upto(g, 1000);
    bool ok = true;

    for (uint64_t number = 0; number < 24 && ok; number++) {
        char reason[128];
        et_request q;
        ok = gen_check(g, et_campaign_draw(&q, op, ET_CATEGORY_BAD_INPUT, seed, number, &all) == ET_OK, "number %d is not drawn", (int)number);
        if (ok) {
            const et_validity validity = et_judge_validity(reason, &q);
            ok = gen_check(g, validity == ET_INVALID && q.op == op, "number %d of %s is not bad: %s", (int)number, et_request_name(op), reason);
            et_request_free(&q);
        }
    }
    return ok ? PASS : FAIL;
}

static int same_validity(void *context, const et_request *q)
{
    char reason[128];

    return et_judge_validity(reason, q) == *(const et_validity *)context;
}

static size_t numbers(const et_request *q)
{
    size_t n = 0;

    for (size_t k = 0; et_request_argument(q->op, k); k++) {
        const et_request_kind kind = et_request_argument(q->op, k)->kind;
        n += kind == ET_ARG_REALS ? q->arg[k].count : kind == ET_ARG_POINTS ? 3 * q->arg[k].count : 0;
    }
    return n;
}

/* One case in 4. */
verdict prop_campaign_shrink_validity(gen *g)
{
    const et_hello all = et_answer_hello(1);
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    const et_category drawn = (et_category)gen_upto(g, ET_CATEGORIES - 1);
    const et_category category = et_campaign_has(op, drawn) && drawn != ET_CATEGORY_SIZE ? drawn : ET_CATEGORY_PLAIN;
    char reason[128];
    et_request q;

    if (et_campaign_draw(&q, op, category, gen_upto(g, 1000), gen_upto(g, 99), &all) != ET_OK)
        return FAIL;
    et_validity validity = et_judge_validity(reason, &q);
    const size_t before = numbers(&q);
    bool ok = gen_check(g, et_campaign_shrink(&q, same_validity, &validity, 400) == ET_OK, "not shrunk");
    ok = ok && gen_check(g, q.op == op && same_validity(&validity, &q), "%s: what was %d is %d: %s", et_request_name(op), (int)validity,
                         (int)et_judge_validity(reason, &q), reason);
    ok = ok && gen_check(g, numbers(&q) <= before, "%zu numbers, before %zu", numbers(&q), before);
    et_request_free(&q);
    return ok ? PASS : FAIL;
}
