#include "conform/conform_parts.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* So many in a row, and the rest of the operation is left out; so many timeouts in a row whatever is asked, and all the rest is. */
enum { TIMEOUTS = 3, CRASHES = 8, HUNG = 12 };

int conform_given_up(const conform_run *run, et_request_op op)
{
    return run->timeouts[op] >= TIMEOUTS || run->crashes[op] >= CRASHES || run->hung >= HUNG;
}

void conform_free_case(conform_case *c)
{
    et_request_free(&c->request);
    et_reply_free(&c->reply);
}

void conform_count(conform_run *run, et_request_op op, et_category category, et_verdict verdict)
{
    run->report->count[op][category][verdict]++;
}

/* ---- asking ---- */

static void keep_rows(conform_run *run, et_request_op op, et_asked how)
{
    run->hung = how == ET_ASKED_TIMEOUT ? run->hung + 1 : 0;
    if (how == ET_ASKED_TIMEOUT)
        run->timeouts[op]++;
    else if (how == ET_ASKED_CRASH)
        run->crashes[op]++;
    else
        run->timeouts[op] = run->crashes[op] = 0;
}

static et_status ask_once(conform_run *run, conform_case *c)
{
    const et_status status = et_peer_ask(run->peer, &c->how, &c->reply, &c->request, &c->text);

    c->asked = 1;
    if (status != ET_OK) {
        /* A program that does not start any more has crashed, and the run ends with what is known. */
        c->how = ET_ASKED_CRASH;
        c->asked = status == ET_EIO;
        if (status == ET_EIO)
            et_status_fail(run->message, status, "%.900s", c->text.text);
        return status;
    }
    keep_rows(run, c->request.op, c->how);
    return ET_OK;
}

/* A request without a reply is not asked again: its verdict is known. */
static et_status ask_again(conform_run *run, conform_case *c)
{
    et_message text = { "" };
    et_reply reply;

    memset(&reply, 0, sizeof reply);
    if (!c->asked || c->how != ET_ASKED_REPLY || conform_given_up(run, c->request.op))
        return ET_OK;
    const et_status status = et_peer_ask(run->peer, &c->how_again, &reply, &c->request, &text);
    if (status != ET_OK && status != ET_EIO)
        return status;
    if (status == ET_EIO) {
        et_status_fail(run->message, status, "%.900s", text.text);
        c->how_again = ET_ASKED_CRASH;
    }
    keep_rows(run, c->request.op, c->how_again);
    c->twice = 1;
    c->same = c->how_again == ET_ASKED_REPLY && et_reply_same(&c->reply, &reply);
    if (c->how_again != ET_ASKED_REPLY)
        c->text = text;
    et_reply_free(&reply);
    return status;
}

et_status conform_ask(conform_run *run, conform_case *c, int twice)
{
    const et_status status = ask_once(run, c);

    return status == ET_OK && twice ? ask_again(run, c) : status;
}

/* ---- judging ---- */

static void decide(et_judgement *judgement, et_verdict verdict, const char *text)
{
    memset(judgement, 0, sizeof *judgement);
    judgement->verdict = verdict;
    judgement->at = SIZE_MAX;
    (void)snprintf(judgement->text, sizeof judgement->text, "%.240s", text);
}

/* 1 if the verdict is clear without the exact result. */
static int judge_conduct(conform_case *c)
{
    static const et_verdict verdicts[] = { ET_VERDICT_CORRECTLY_ROUNDED, ET_VERDICT_CRASH, ET_VERDICT_TIMEOUT, ET_VERDICT_WRONG };
    et_message text;

    if (c->how != ET_ASKED_REPLY)
        decide(&c->judgement, verdicts[c->how], c->text.text);
    else if (!c->twice || c->same)
        return 0;
    else if (c->how_again == ET_ASKED_GARBLED)
        decide(&c->judgement, ET_VERDICT_WRONG, c->text.text);
    else if (c->how_again != ET_ASKED_REPLY) {
        et_status_fail(&text, ET_OK, "there was a reply; asked again: %.900s", c->text.text);
        decide(&c->judgement, ET_VERDICT_NONDETERMINISTIC, text.text);
    } else
        decide(&c->judgement, ET_VERDICT_NONDETERMINISTIC, "asked again, the reply is another");
    return 1;
}

void conform_judge(conform_case *c, const et_truth *truth)
{
    et_truth own;

    c->judged = ET_OK;
    if (judge_conduct(c))
        return;
    if (c->reply.kind == ET_REPLY_UNSUPPORTED) {
        decide(&c->judgement, ET_VERDICT_UNSUPPORTED, c->reply.reason);
        return;
    }
    if (truth) {
        c->judged = et_judge_reply(&c->judgement, &c->request, truth, &c->reply);
        return;
    }
    c->judged = et_judge_truth(&own, &c->request);
    if (c->judged == ET_OK) {
        c->judged = et_judge_reply(&c->judgement, &c->request, &own, &c->reply);
        et_judge_free(&own);
    }
}

/* ---- counting ---- */

/* The greatest error / bound of those that are right is where the search for worse ones begins. */
static et_status keep_worst(conform_run *run, const conform_case *c)
{
    const et_request_op op = c->request.op;
    const int right = c->judgement.verdict == ET_VERDICT_WITHIN_BOUND || c->judgement.verdict == ET_VERDICT_CORRECTLY_ROUNDED;
    et_request copy;

    if (c->how != ET_ASKED_REPLY || c->reply.kind != ET_REPLY_OK)
        return ET_OK;
    if (c->judgement.ratio > run->report->worst[op])
        run->report->worst[op] = c->judgement.ratio;
    if (!right || run->options->level < 3 || !(c->judgement.ratio > run->worst_ratio[op]))
        return ET_OK;
    const et_status status = et_request_copy(&copy, &c->request);
    if (status != ET_OK)
        return status;
    if (run->has_worst[op])
        et_request_free(&run->worst[op]);
    run->worst[op] = copy;
    run->worst_ratio[op] = c->judgement.ratio;
    run->worst_category[op] = c->category;
    run->has_worst[op] = 1;
    return ET_OK;
}

static et_status count_case(conform_run *run, conform_case *c)
{
    const et_request_op op = c->request.op;

    if (!c->asked) {
        run->report->skipped++;
        return ET_OK;
    }
    run->report->asked++;
    if (c->judged == ET_ENOCONV) {
        run->report->skipped++;
        return ET_OK;
    }
    if (c->judged != ET_OK)
        return c->judged;
    if (run->answered[op]++ == 0)
        run->category[op] = c->category;
    if (c->how == ET_ASKED_REPLY && c->reply.kind == ET_REPLY_UNSUPPORTED)
        run->declined[op]++;
    if (c->how == ET_ASKED_REPLY && c->reply.kind == ET_REPLY_REFUSED && c->judgement.verdict <= ET_VERDICT_WITHIN_BOUND)
        run->report->refused_rightly++;
    conform_count(run, op, c->category, c->judgement.verdict);
    const et_status status = keep_worst(run, c);
    return status == ET_OK && et_judge_bad(c->judgement.verdict) ? conform_tell(run, c, NULL) : status;
}

/* A hello that changes is told once, with the request that was asked then. */
static et_status count_hello(conform_run *run, const conform_case *c)
{
    conform_case told = *c;

    if (run->changed || !et_peer_changed(run->peer))
        return ET_OK;
    run->changed = 1;
    decide(&told.judgement, ET_VERDICT_NONDETERMINISTIC, "started again, its hello was another");
    conform_count(run, c->request.op, c->category, ET_VERDICT_NONDETERMINISTIC);
    return conform_tell(run, &told, NULL);
}

/* ---- blocks ---- */

et_status conform_flush(conform_run *run)
{
    et_status status = ET_OK, counted = ET_OK;

    for (size_t k = 0; status == ET_OK && k < run->n; k++) {
        conform_case *c = &run->block[k];
        if (!conform_given_up(run, c->request.op))
            status = ask_once(run, c);
        if (status == ET_OK)
            status = et_task_step(run->task, run->done + k, run->total);
    }
    for (size_t k = run->n; status == ET_OK && k-- > 0;)
        status = ask_again(run, &run->block[k]);
    for (size_t k = 0; k < run->n; k++)
        if (run->block[k].asked)
            conform_judge(&run->block[k], run->block[k].vector ? &run->block[k].vector->truth : NULL);
    if (status == ET_OK && run->n > 0)
        counted = count_hello(run, &run->block[run->n - 1]);
    /* When the run ends within the block, what was not asked is not skipped, but not reached. */
    for (size_t k = 0; k < run->n; k++)
        if (counted == ET_OK && (status == ET_OK || run->block[k].asked))
            counted = count_case(run, &run->block[k]);
    for (size_t k = 0; k < run->n; k++)
        conform_free_case(&run->block[k]);
    run->done = run->done + run->n < run->total ? run->done + run->n : run->total;
    run->n = 0;
    return status != ET_OK ? status : counted;
}

et_status conform_add(conform_run *run, et_request *request, et_category category, const et_vector *vector)
{
    conform_case *c = &run->block[run->n++];

    memset(c, 0, sizeof *c);
    c->request = *request;
    c->category = category;
    c->vector = vector;
    memset(request, 0, sizeof *request);
    return run->n == CONFORM_BLOCK ? conform_flush(run) : ET_OK;
}
