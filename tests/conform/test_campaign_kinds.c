/* conform/campaign: a relation tried again is the same trial with the same end. */
#include "etalon/conform/answer.h"
#include "etalon/conform/campaign.h"
#include "gen.h"
#include <stdlib.h>
#include <string.h>

/* Answers that are right, or all of them off by a little. */
static et_status ask(void *context, et_reply *reply, const et_request *q)
{
    const bool nearest = q->op == ET_OP_CURVE_NEAREST || q->op == ET_OP_SURFACE_NEAREST, *const off = context;
    const et_status status = nearest ? et_answer_exact(reply, q) : et_answer_fast(reply, q);

    for (size_t i = 0; status == ET_OK && *off && i < reply->count; i++)
        reply->x[i] = reply->x[i] * (1.0 + 0x1p-6) + 0x1p-6;
    return status;
}

/* One case in 20. */
verdict prop_campaign_relate_again(gen *g)
{
    const et_hello h = et_answer_hello(0);
    const size_t relation = (size_t)gen_upto(g, et_campaign_relations() - 1);
    const uint64_t seed = gen_upto(g, 1000), number = gen_upto(g, 1000);
    bool off = gen_upto(g, 1), ok = true;
    et_judgement j[2];
    et_request q[2];
    char *line[2] = {NULL, NULL};

    for (int k = 0; k < 2; k++) {
        memset(&q[k], 0, sizeof q[k]);
        if (!gen_check(g, et_campaign_relate(&j[k], &q[k], relation, seed, number, &h, ask, &off) == ET_OK, "not tried"))
            return FAIL;
        ok = gen_check(g, et_request_print(&line[k], &q[k]) == ET_OK, "no line") && ok;
    }
    ok = ok && gen_check(g, strcmp(line[0], line[1]) == 0, "%s, then %s", line[0], line[1]);
    ok = ok && gen_check(g, j[0].verdict == j[1].verdict && j[0].at == j[1].at && strcmp(j[0].text, j[1].text) == 0, "%s, then %s", j[0].text,
            j[1].text);
    for (int k = 0; k < 2; k++) {
        et_request_free(&q[k]);
        free(line[k]);
    }
    return ok ? PASS : FAIL;
}
