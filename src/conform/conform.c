#include "etalon/conform/conform.h"
#include "conform/campaign_parts.h"
#include "conform/conform_parts.h"
#include "etalon/base/size.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Level 0: cases of each operation and category; level 3: neighbours tried of each operation, cases of each relation, at least. */
enum { SMOKE = 8, NEIGHBOURS = 100, RELATED = 20 };

et_conform_options et_conform_defaults(void)
{
    et_conform_options o;

    memset(&o, 0, sizeof o);
    for (int op = 0; op < ET_OPS; op++)
        o.op[op] = 1;
    o.seed = 1;
    o.cases = 10000;
    o.findings = 3;
    return o;
}

static int wanted(const conform_run *run, et_request_op op)
{
    return run->options->op[op] != 0;
}

static int offered(const conform_run *run, et_request_op op)
{
    return wanted(run, op) && run->hello->op[op] != 0;
}

/* ---- levels 0 and 2: drawn cases ---- */

typedef struct { et_request_op op; et_category category; } kind;

/* Operations and categories that are wanted; count[0] of them are offered and come first. */
static void list_kinds(const conform_run *run, kind kinds[ET_OPS * ET_CATEGORIES], size_t count[2])
{
    size_t n = 0;

    for (int yes = 1; yes >= 0; yes--) {
        for (int op = 0; op < ET_OPS; op++)
            for (int c = 0; c < ET_CATEGORIES; c++)
                if (wanted(run, (et_request_op)op) && offered(run, (et_request_op)op) == yes && et_campaign_has((et_request_op)op, (et_category)c))
                    kinds[n++] = (kind){ (et_request_op)op, (et_category)c };
        count[1 - yes] = n;
    }
    count[1] -= count[0];
}

/* One case is drawn and asked; what hello leaves nothing of is unsupported. */
static et_status draw(conform_run *run, kind k, uint64_t number)
{
    et_request request;
    const et_status status = et_campaign_draw(&request, k.op, k.category, run->options->seed, number, run->hello);

    if (status == ET_EINVAL) {
        conform_count(run, k.op, k.category, ET_VERDICT_UNSUPPORTED);
        return ET_OK;
    }
    return status == ET_OK ? conform_add(run, &request, k.category, NULL) : status;
}

static et_status smoke(conform_run *run, const kind *kinds, const size_t count[2])
{
    et_status status = ET_OK;

    for (size_t number = 0; status == ET_OK && number < SMOKE; number++)
        for (size_t k = 0; status == ET_OK && k < count[0]; k++)
            status = draw(run, kinds[k], number);
    for (size_t k = 0; k < count[1]; k++)
        conform_count(run, kinds[count[0] + k].op, kinds[count[0] + k].category, ET_VERDICT_UNSUPPORTED);
    return status == ET_OK ? conform_flush(run) : status;
}

static et_status campaign(conform_run *run, const kind *kinds, const size_t count[2])
{
    et_status status = ET_OK;

    for (size_t i = 0; status == ET_OK && count[0] > 0 && i < run->options->cases; i++)
        status = draw(run, kinds[i % count[0]], SMOKE + i / count[0]);
    return status == ET_OK ? conform_flush(run) : status;
}

/* ---- level 1: frozen vectors ---- */

static char *join(const char *folder, const char *name, const char *end)
{
    const size_t length = strlen(folder) + strlen(name) + strlen(end) + 2;
    char *path = malloc(length);

    if (path)
        (void)snprintf(path, length, "%s/%s%s", folder, name, end);
    return path;
}

/* 1, 0, or -1 without memory. */
static int is_there(const char *folder, const char *name)
{
    char *path = join(folder, name, ".json");
    FILE *file = path ? fopen(path, "rb") : NULL;
    const int there = !path ? -1 : file != NULL;

    if (file)
        fclose(file);
    free(path);
    return there;
}

static et_status ask_vector(conform_run *run, const et_vector *v)
{
    et_request request;

    if (!offered(run, v->request.op) || !campaign_offered(&v->request, run->hello)) {
        conform_count(run, v->request.op, v->category, ET_VERDICT_UNSUPPORTED);
        return ET_OK;
    }
    const et_status status = et_request_copy(&request, &v->request);
    return status == ET_OK ? conform_add(run, &request, v->category, v) : status;
}

/* The vectors of one operation; an operation without any has no file. */
static et_status ask_vectors(conform_run *run, et_request_op op)
{
    et_vectors all = { NULL, 0 };
    const int there = is_there(run->options->vectors, et_request_name(op));

    if (there <= 0)
        return there < 0 ? ET_ENOMEM : ET_OK;
    char *path = join(run->options->vectors, et_request_name(op), ".json");
    et_status status = path ? et_vectors_read(&all, path, run->message) : ET_ENOMEM;
    free(path);
    if (status != ET_OK)
        return status;
    run->total += all.count;
    for (size_t k = 0; status == ET_OK && k < all.count; k++)
        status = ask_vector(run, &all.vector[k]);
    if (status == ET_OK)
        status = conform_flush(run);
    et_vectors_free(&all);                /* what is in the block still, without memory, is freed and not judged */
    return status;
}

static et_status frozen(conform_run *run)
{
    et_status status = ET_OK;
    const int there = is_there(run->options->vectors, "schema");

    if (there <= 0)
        return there < 0 ? ET_ENOMEM : et_status_fail(run->message, ET_EIO, "%s has no frozen vectors (no schema.json)", run->options->vectors);
    for (int op = 0; status == ET_OK && op < ET_OPS; op++)
        if (wanted(run, (et_request_op)op))
            status = ask_vectors(run, (et_request_op)op);
    return status;
}

/* ---- level 3: relations, and the greatest error / bound ---- */

/* Why an answer is missing. */
typedef struct { conform_run *run; et_asked how; et_message text; } relating;

static et_status ask_related(void *context, et_reply *reply, const et_request *request)
{
    relating *r = context;

    /* What hello does not offer is not asked by a relation. */
    if (!wanted(r->run, request->op) || conform_given_up(r->run, request->op)) {
        memset(reply, 0, sizeof *reply);
        reply->kind = ET_REPLY_UNSUPPORTED;
        return ET_OK;
    }
    const et_status status = et_peer_ask(r->run->peer, &r->how, reply, request, &r->text);
    if (status == ET_EIO)
        et_status_fail(r->run->message, status, "%.900s", r->text.text);
    /* Without a reply there is nothing to compare; such requests are judged at the other levels. */
    if (status == ET_OK && r->how != ET_ASKED_REPLY) {
        memset(reply, 0, sizeof *reply);
        reply->kind = ET_REPLY_UNSUPPORTED;
    }
    return status;
}

static et_status relate(conform_run *run, size_t relation, uint64_t number)
{
    relating r = { run, ET_ASKED_REPLY, { "" } };
    conform_case c;

    memset(&c, 0, sizeof c);
    et_status status = et_campaign_relate(&c.judgement, &c.request, relation, run->options->seed, number, run->hello, ask_related, &r);
    if (status != ET_OK)
        return status;
    if (c.judgement.verdict != ET_VERDICT_UNSUPPORTED) {
        run->report->asked++;
        c.how = ET_ASKED_CRASH;           /* there is not one reply to show */
        conform_count(run, c.request.op, ET_CATEGORY_PLAIN, c.judgement.verdict);
        if (et_judge_bad(c.judgement.verdict))
            status = conform_tell(run, &c, et_campaign_relation_name(relation));
    }
    conform_free_case(&c);
    return status == ET_OK ? et_task_step(run->task, run->done, run->total) : status;
}

static size_t related(const conform_run *run)
{
    const size_t share = run->options->cases / (10 * (et_campaign_relations() + 1));

    return share > RELATED ? share : RELATED;
}

static et_status relations(conform_run *run)
{
    const size_t each = related(run);
    et_status status = ET_OK;

    for (size_t k = 0; status == ET_OK && k < et_campaign_relations(); k++)
        for (size_t number = 0; status == ET_OK && number < each; number++) {
            status = relate(run, k, number);
            run->done += run->done < run->total;
        }
    return status;
}

/* From the worst case known to its neighbours, and on from each that is worse: a case asked, judged and counted takes its place by itself. */
static et_status climb(conform_run *run, et_request_op op)
{
    et_status status = ET_OK;

    for (uint64_t number = 0; status == ET_OK && number < NEIGHBOURS && !conform_given_up(run, op); number++) {
        et_request varied;
        status = et_campaign_vary(&varied, &run->worst[op], run->options->seed, number, run->hello);
        if (status == ET_OK)
            status = conform_add(run, &varied, run->worst_category[op], NULL);
        if (status == ET_OK)
            status = conform_flush(run);
    }
    return status;
}

static et_status worst_cases(conform_run *run)
{
    et_status status = ET_OK;

    for (int op = 0; status == ET_OK && op < ET_OPS; op++)
        if (run->has_worst[op])
            status = climb(run, (et_request_op)op);
    return status;
}

/* ---- the run ---- */

/* Offered by hello, and never answered. */
static et_status empty_offers(conform_run *run)
{
    et_status status = ET_OK;

    for (int op = 0; status == ET_OK && op < ET_OPS; op++)
        if (run->answered[op] > 0 && run->declined[op] == run->answered[op]) {
            conform_case c;
            memset(&c, 0, sizeof c);
            status = et_campaign_draw(&c.request, (et_request_op)op, run->category[op], run->options->seed, 0, run->hello);
            if (status == ET_EINVAL)
                status = et_request_new(&c.request, (et_request_op)op);
            if (status != ET_OK)
                return status;
            c.how = ET_ASKED_CRASH;
            c.category = run->category[op];
            c.judgement.verdict = ET_VERDICT_WRONGLY_REFUSED;
            c.judgement.at = SIZE_MAX;
            (void)snprintf(c.judgement.text, sizeof c.judgement.text, "hello offers it, but every request is answered `unsupported`");
            conform_count(run, (et_request_op)op, c.category, ET_VERDICT_WRONGLY_REFUSED);
            status = conform_tell(run, &c, "offered in hello");
            conform_free_case(&c);
        }
    return status;
}

static et_status levels(conform_run *run)
{
    const unsigned level = run->options->level;
    kind kinds[ET_OPS * ET_CATEGORIES];
    size_t count[2];

    list_kinds(run, kinds, count);
    run->total = SMOKE * count[0] + (level >= 2 ? run->options->cases : 0) + (level >= 3 ? related(run) * et_campaign_relations() : 0);
    et_status status = smoke(run, kinds, count);
    if (status == ET_OK && level >= 1 && run->options->vectors)
        status = frozen(run);
    if (status == ET_OK && level >= 2)
        status = campaign(run, kinds, count);
    if (status == ET_OK && level >= 3)
        status = relations(run);
    if (status == ET_OK && level >= 3)
        status = worst_cases(run);
    return status == ET_OK ? empty_offers(run) : status;
}

et_status et_conform_run(et_conform_report *report, et_peer *peer, const et_conform_options *options, const et_task *task, et_message *message)
{
    conform_run *run = et_size_array(1, sizeof *run);

    memset(report, 0, sizeof *report);
    if (!run)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    if (message)
        message->text[0] = '\0';
    run->report = report;
    run->peer = peer;
    run->options = options;
    run->hello = et_peer_hello(peer);
    run->task = task;
    run->message = message;
    const et_status status = levels(run);
    for (size_t k = 0; k < run->n; k++)
        conform_free_case(&run->block[k]);
    for (int op = 0; op < ET_OPS; op++)
        if (run->has_worst[op])
            et_request_free(&run->worst[op]);
    free(run);
    if (status != ET_OK && message && !message->text[0])
        et_status_fail(message, status, "%s", et_status_text(status));
    return status;
}
