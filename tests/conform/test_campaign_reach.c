/* conform/campaign: every operation and category for hellos that offer little, and every relation with answers that go wrong in each way. */
#include "conform/judge_kit.h"
#include <stdio.h>

verdict prop_campaign_draw_offered(gen *g);
verdict prop_campaign_relate_conduct(gen *g);
verdict prop_campaign_relate_offered(gen *g);
verdict prop_campaign_shrink_each(gen *g);
verdict prop_campaign_vary_each(gen *g);

/* Hellos that leave out more and more. */
static et_hello little(size_t k)
{
    et_hello h = et_answer_hello(1);

    h.degree = k == 1 ? 1 : k == 2 ? 2 : k == 3 ? 0 : k == 8 ? 3 : h.degree;
    h.order = k == 2 ? 0 : k == 4 ? 1 : h.order;
    h.rational = k != 1 && k != 5;
    h.any = k != 4 && k != 6 && k != 7;
    h.left = k != 5 && k != 6;
    h.right = k != 5 && k != 4 && k != 7;
    h.knot_tolerance = k == 8 ? 0x1p-10 : k == 9 ? 0.1 : 0;
    return h;
}
enum { HELLOS = 10 };

/* What is drawn can be asked: no degree, order, weight or side that is not offered.  Nothing is drawn that hello leaves nothing of. */
static bool keeps_to(gen *g, const et_request *q, const et_hello *h)
{
    bool ok = gen_check(g, h->op[q->op] != 0, "the operation is offered");

    for (size_t k = 0; ok && et_request_argument(q->op, k); k++) {
        const char *name = et_request_argument(q->op, k)->name;
        const size_t n = q->arg[k].count;
        if (strcmp(name, "p") == 0 || strcmp(name, "q") == 0)
            ok = gen_check(g, n <= h->degree, "degree %zu of %zu", n, h->degree);
        else if (strcmp(name, "d") == 0)
            ok = gen_check(g, n <= h->order, "order %zu of %zu", n, h->order);
        else if (strcmp(name, "w") == 0)
            ok = gen_check(g, h->rational || n == 0, "weights");
        else if (strncmp(name, "side", 4) == 0)
            ok = gen_check(g, n == 0 ? h->any : n == 1 ? h->right : h->left, "side %zu", n);
    }
    return ok;
}

/* One case in 1000. */
verdict prop_campaign_draw_offered(gen *g)
{
    et_request q;
    et_hello none;
    bool ok = true;

    for (size_t k = 0; ok && k < HELLOS; k++) {
        const et_hello h = little(k);
        for (int op = 0; ok && op < ET_OPS; op++)
            for (int c = 0; ok && c < ET_CATEGORIES; c++)
                for (uint64_t number = 0; ok && c != ET_CATEGORY_SIZE && number < (k == 0 ? 40 : 5); number++) {
                    if (et_campaign_draw(&q, (et_request_op)op, (et_category)c, 7, number, &h) != ET_OK)
                        continue;
                    ok = c == ET_CATEGORY_BAD_INPUT || keeps_to(g, &q, &h);
                    ok = ok && gen_check(g, et_campaign_has((et_request_op)op, (et_category)c) && q.op == (et_request_op)op, "hello %zu, operation %d, category %d", k, op, c);
                    et_request_free(&q);
                }
    }
    none = little(6);
    none.right = 0;
    ok = ok && gen_check(g, et_campaign_draw(&q, ET_OP_BASIS, ET_CATEGORY_PLAIN, 1, 1, &none) == ET_EINVAL, "no side is offered");
    none = little(0);
    none.op[ET_OP_SPAN] = 0;
    ok = ok && gen_check(g, et_campaign_draw(&q, ET_OP_SPAN, ET_CATEGORY_PLAIN, 1, 1, &none) == ET_EINVAL, "the operation is not offered");
    ok = ok && gen_check(g, et_campaign_draw(&q, ET_OPS, ET_CATEGORY_PLAIN, 1, 1, &none) == ET_EINVAL, "no operation");
    return ok ? PASS : FAIL;
}

/* ---- relations ---- */

/* How an answer goes wrong, at which call (SIZE_MAX: at all). */
typedef enum { RIGHT, REFUSES, DECLINES, TOO_FEW, NOT_FINITE, SHIFTED, FAILS, EMPTY, SEVENS, CONDUCTS } conduct;
typedef struct { conduct how; size_t at, calls; } answers;

static et_status answer(void *context, et_reply *reply, const et_request *request)
{
    answers *a = context;
    const size_t call = a->calls++;
    et_status status;

    if (a->how == FAILS && call == a->at)
        return ET_ENOMEM;
    status = (request->op == ET_OP_CURVE_NEAREST ? et_answer_exact : et_answer_fast)(reply, request);
    if (status != ET_OK || a->how == RIGHT || (call != a->at && a->at != SIZE_MAX))
        return status;
    if (a->how == REFUSES || a->how == DECLINES) {
        et_reply_free(reply);
        reply->kind = a->how == REFUSES ? ET_REPLY_REFUSED : ET_REPLY_UNSUPPORTED;
    } else if (a->how == TOO_FEW && reply->count > 0) {
        reply->count--;
    } else if (a->how == EMPTY) {
        reply->count = 0;
    } else {
        for (size_t k = 0; k < reply->count; k++)
            reply->x[k] = a->how == NOT_FINITE ? (double)NAN : a->how == SEVENS ? 7 : reply->x[k] + (double)(call + 1);
    }
    return status;
}

/* Relations of what takes long are left to the campaign's own tests. */
static bool slow(const char *name)
{
    return strstr(name, "nearest") || strstr(name, "fit") || strstr(name, "seam") || strstr(name, "approximate");
}

/* One case in 1000. */
verdict prop_campaign_relate_conduct(gen *g)
{
    et_hello all = et_answer_hello(0);
    bool ok = true;

    all.op[ET_OP_CURVE_NEAREST] = 1;
    for (size_t relation = 0; ok && relation < et_campaign_relations(); relation++)
        for (int how = 0; ok && how < CONDUCTS; how++)
            for (size_t at = 0; ok && at < (slow(et_campaign_relation_name(relation)) ? 1u : how == RIGHT ? 8u : 4u); at++) {
                answers a = { (conduct)how, at >= 3 ? SIZE_MAX : at, 0 };
                et_judgement j;
                et_request q;
                memset(&q, 0, sizeof q);
                const et_status status = et_campaign_relate(&j, &q, relation, 5, 3 * relation + at, &all, answer, &a);
                const int reached = a.calls > at || (at == 3 && a.calls > 0);
                ok = gen_check(g, status == (how == FAILS && reached && at < 3 ? ET_ENOMEM : ET_OK), "%s: conduct %d at call %zu: status %d",
                               et_campaign_relation_name(relation), how, at, (int)status);
                if (ok && status == ET_OK) {
                    ok = gen_check(g, how != RIGHT || !et_judge_bad(j.verdict), "%s: right answers: %s", et_campaign_relation_name(relation), j.text);
                    ok = ok && gen_check(g, how != REFUSES || !reached || j.verdict == ET_VERDICT_WRONGLY_REFUSED, "%s: refused: %s",
                                         et_campaign_relation_name(relation), et_judge_name(j.verdict));
                    ok = ok && gen_check(g, how != DECLINES || !reached || j.verdict == ET_VERDICT_UNSUPPORTED, "%s: declined: %s",
                                         et_campaign_relation_name(relation), et_judge_name(j.verdict));
                    ok = ok && gen_check(g, (how != TOO_FEW && how != NOT_FINITE) || !reached || et_judge_bad(j.verdict)
                                                || j.verdict == ET_VERDICT_UNSUPPORTED, "%s: conduct %d: %s", et_campaign_relation_name(relation), how,
                                         et_judge_name(j.verdict));
                    et_request_free(&q);
                }
            }
    return ok ? PASS : FAIL;
}

/* Where hello offers little, fewer relations can be checked; none is broken, and nothing is asked that is not offered. */
typedef struct { const et_hello *hello; gen *g; bool ok; } watched;

static et_status watch(void *context, et_reply *reply, const et_request *request)
{
    watched *w = context;

    w->ok = w->ok && keeps_to(w->g, request, w->hello);
    return et_answer_fast(reply, request);
}

/* One case in 1000. */
verdict prop_campaign_relate_offered(gen *g)
{
    bool ok = true;

    for (size_t k = 1; ok && k < HELLOS + 2; k++) {
        et_hello h = little(k < HELLOS ? k : 0);
        for (int op = 0; op < ET_OPS; op++)
            h.op[op] = k < HELLOS || op % 2 == (int)(k - HELLOS);
        for (size_t relation = 0; ok && relation < et_campaign_relations(); relation++) {
            watched w = { &h, g, true };
            et_judgement j;
            et_request q;
            if (slow(et_campaign_relation_name(relation)) && k < HELLOS)
                continue;
            memset(&q, 0, sizeof q);
            ok = gen_check(g, et_campaign_relate(&j, &q, relation, 11, k, &h, watch, &w) == ET_OK && w.ok && !et_judge_bad(j.verdict), "hello %zu, %s: %s", k,
                           et_campaign_relation_name(relation), j.text);
            et_request_free(&q);
        }
    }
    return ok ? PASS : FAIL;
}

/* ---- smaller, and other, requests ---- */

typedef struct { int kind; et_validity validity; } wish;

static int still(void *context, const et_request *q)
{
    const wish *w = context;
    char reason[128];
    size_t odd = 0;

    if (w->kind == 0)
        return 1;
    if (w->kind == 1)
        return et_judge_validity(reason, q) == w->validity;
    for (size_t k = 0; et_request_argument(q->op, k); k++) {
        const et_request_kind kind = et_request_argument(q->op, k)->kind;
        const size_t n = kind == ET_ARG_REALS ? q->arg[k].count : kind == ET_ARG_POINTS ? 3 * q->arg[k].count : kind == ET_ARG_REAL ? 1 : 0;
        for (size_t i = 0; i < n; i++)
            odd += (size_t)(w->kind == 2 ? !isfinite(q->arg[k].x[i]) : w->kind == 3 ? fabs(q->arg[k].x[i]) >= 0x1p53 : q->arg[k].x[i] < 0);
    }
    return odd > 0;
}

/* One case in 1000. */
verdict prop_campaign_shrink_each(gen *g)
{
    const et_hello all = et_answer_hello(1);
    bool ok = true;

    for (int op = 0; ok && op < ET_OPS; op++)
        for (int c = 0; ok && c < ET_CATEGORIES; c++)
            for (int kind = 0; ok && kind < 5; kind++) {
                wish w = { kind, ET_VALID };
                char reason[128];
                et_request q;
                if (c == ET_CATEGORY_SIZE || et_campaign_draw(&q, (et_request_op)op, (et_category)c, 3, (uint64_t)kind, &all) != ET_OK)
                    continue;
                w.validity = et_judge_validity(reason, &q);
                if (w.validity == ET_INVALID || kind != 1 || op != ET_OP_FIT_SCATTERED) {
                    const int before = still(&w, &q);
                    ok = gen_check(g, et_campaign_shrink(&q, still, &w, before ? 150 : 0) == ET_OK && still(&w, &q) == before, "%s, category %d, wish %d",
                                   et_request_name((et_request_op)op), c, kind);
                }
                et_request_free(&q);
            }
    return ok ? PASS : FAIL;
}

/* One case in 1000. */
verdict prop_campaign_vary_each(gen *g)
{
    static const char *const lines[] = { "multiplicity 1 0x0p+0 0x0p+0", "knots uniform 1 2 2 0x0p+0 0x1p+0", "net_node 2 2 1",
                                         "multiplicity 3 0x0p+0 0x1p+0 0x1p+0 0x1p+0" };
    const et_hello all = et_answer_hello(1);
    char reason[128];
    bool ok = true;

    for (int op = 0; ok && op < ET_OPS + 4; op++)
        for (uint64_t number = 0; ok && number < 6; number++) {
            et_request q, varied;
            const et_category c = number % 2 ? ET_CATEGORY_EXTREME_SCALE : ET_CATEGORY_PLAIN;
            if (op >= ET_OPS)
                q = kit_parse(lines[op - ET_OPS]);
            else if (op == ET_OP_FIT_SCATTERED || et_campaign_draw(&q, (et_request_op)op, c, 3, number, &all) != ET_OK)
                continue;
            ok = gen_check(g, et_campaign_vary(&varied, &q, 9, number, &all) == ET_OK, "varied");
            if (ok) {
                ok = gen_check(g, varied.op == q.op && et_judge_validity(reason, &varied) == et_judge_validity(reason, &q), "of the same validity");
                et_request_free(&varied);
            }
            et_request_free(&q);
        }
    return ok ? PASS : FAIL;
}
