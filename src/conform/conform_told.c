#include "conform/conform_parts.h"
#include <stdlib.h>
#include <string.h>

/* How often the program is asked while a request is made small.  A crash, or a reply out of order, costs a new start, hanging its whole time limit:
 * of these there are so many in the whole run. */
enum { CALLS = 400, CALLS_ANEW = 60, CALLS_CRASH = 40, ALL_CRASH = 400, CALLS_TIMEOUT = 6, ALL_TIMEOUT = 12 };

static int same_text(const char *a, const char *b)
{
    return a && b ? strcmp(a, b) == 0 : !a && !b;
}

/* 1 if one just like it is told already, or as many as wanted. */
static int enough(const conform_run *run, const conform_case *c, const char *issue, const char *relation)
{
    size_t same = 0;

    for (size_t k = 0; k < run->report->findings; k++) {
        const et_conform_finding *f = &run->report->finding[k];
        if (f->op != c->request.op || f->judgement.verdict != c->judgement.verdict)
            continue;
        same++;
        if (f->category == c->category && same_text(f->issue, issue) && same_text(f->relation, relation))
            return 1;
    }
    return same >= run->options->findings;
}

static char *copied(const char *text, et_status *status)
{
    char *copy = text ? strdup(text) : NULL;

    if (text && !copy)
        *status = ET_ENOMEM;
    return copy;
}

static void free_finding(et_conform_finding *f)
{
    free(f->vector);
    free(f->issue);
    free(f->relation);
    free(f->request);
    free(f->reply);
    free(f->shrunk);
    free(f->shrunk_reply);
    memset(f, 0, sizeof *f);
}

void et_conform_free(et_conform_report *report)
{
    for (size_t k = 0; k < report->findings; k++)
        free_finding(&report->finding[k]);
    free(report->finding);
    memset(report, 0, sizeof *report);
}

/* The reply without the number of its request. */
static et_status print_reply(char **text, const et_reply *reply)
{
    char *line;
    const et_status status = et_reply_print(&line, 0, reply);

    if (status != ET_OK)
        return status;
    memmove(line, line + 2, strlen(line) - 1);
    *text = line;
    return ET_OK;
}

/* ---- smaller requests ---- */

typedef struct {
    conform_run *run;
    et_verdict verdict;
    et_status status;                     /* of the last asking that failed: nothing is asked after it */
    et_category category;
    int starts;                           /* each time the program is started again */
} shrinking;

/* The request asked as often as its verdict needs, and judged. */
static et_status try_again(conform_case *c, shrinking *s, const et_request *request)
{
    memset(c, 0, sizeof *c);
    c->category = s->category;
    et_status status = et_request_copy(&c->request, request);
    if (status == ET_OK)
        status = conform_ask(s->run, c, s->verdict == ET_VERDICT_NONDETERMINISTIC || s->verdict == ET_VERDICT_WRONG);
    if (status == ET_OK) {
        conform_judge(c, NULL);
        status = c->judged;
    }
    return status;
}

static int still_fails(void *context, const et_request *request)
{
    shrinking *s = context;
    conform_case c;

    if (s->status != ET_OK || et_task_step(s->run->task, s->run->done, s->run->total) != ET_OK)
        return 0;
    const et_status status = try_again(&c, s, request);
    s->run->hangs += s->verdict == ET_VERDICT_TIMEOUT;
    s->run->starts += s->starts != 0;
    const int fails = status == ET_OK && c.judgement.verdict == s->verdict;
    conform_free_case(&c);
    /* What the exact layer cannot decide is no example. */
    s->status = status == ET_ENOCONV ? ET_OK : status;
    return fails;
}

static size_t calls_for(const conform_run *run, const shrinking *s)
{
    if (s->verdict == ET_VERDICT_TIMEOUT)
        return run->hangs < ALL_TIMEOUT ? CALLS_TIMEOUT : 0;
    if (s->starts)
        return run->starts < ALL_CRASH ? CALLS_CRASH : 0;
    return s->verdict == ET_VERDICT_NONDETERMINISTIC ? CALLS_ANEW : CALLS;
}

/* What is told of the smallest request, which the exact layer has decided before, if it fails once more. */
static et_status tell_shrunk(et_conform_finding *f, shrinking *s, const et_request *request)
{
    conform_case c;
    et_status status = try_again(&c, s, request);

    if (status == ET_OK && c.judgement.verdict == s->verdict) {
        f->shrunk_judgement = c.judgement;
        status = et_request_print(&f->shrunk, &c.request);
        if (status == ET_OK && c.how == ET_ASKED_REPLY)
            status = print_reply(&f->shrunk_reply, &c.reply);
    }
    conform_free_case(&c);
    return status;
}

/* The rows of crashes and timeouts are those of the run, not of the shrinking.  A fault that does not come again (it came from what was asked
 * before) is told as it is. */
static et_status shrink(conform_run *run, et_conform_finding *f, const conform_case *c)
{
    const int starts = c->how != ET_ASKED_REPLY || (c->twice && c->how_again != ET_ASKED_REPLY);
    shrinking s = { run, c->judgement.verdict, ET_OK, c->category, starts };
    const et_request_op op = c->request.op;
    const unsigned timeouts = run->timeouts[op], crashes = run->crashes[op], hung = run->hung;
    const size_t calls = calls_for(run, &s);
    et_request small;

    if (calls == 0)
        return ET_OK;
    et_status status = et_request_copy(&small, &c->request);
    if (status != ET_OK)
        return status;
    run->timeouts[op] = run->crashes[op] = run->hung = 0;
    if (still_fails(&s, &small)) {
        status = et_campaign_shrink(&small, still_fails, &s, calls);
        if (status == ET_OK)
            status = s.status;
        if (status == ET_OK)
            status = tell_shrunk(f, &s, &small);
    } else {
        status = s.status;
    }
    et_request_free(&small);
    run->timeouts[op] = timeouts;
    run->crashes[op] = crashes;
    run->hung = hung;
    /* A program that does not start any more ends the run when the next request is asked, not before what is known has been counted. */
    return status == ET_EIO ? ET_OK : status;
}

/* ---- telling ---- */

static et_status make_room(conform_run *run)
{
    et_conform_report *report = run->report;

    if (report->findings < run->told_size)
        return ET_OK;
    const size_t room = 2 * run->told_size + 16;
    et_conform_finding *more = realloc(report->finding, room * sizeof *more);
    if (!more)
        return ET_ENOMEM;
    report->finding = more;
    run->told_size = room;
    return ET_OK;
}

et_status conform_tell(conform_run *run, const conform_case *c, const char *relation)
{
    const char *issue = c->vector ? c->vector->issue : NULL;
    et_conform_finding f;

    if (enough(run, c, issue, relation))
        return ET_OK;
    memset(&f, 0, sizeof f);
    et_status status = make_room(run);
    f.op = c->request.op;
    f.category = c->category;
    f.judgement = c->judgement;
    f.vector = copied(c->vector ? c->vector->id : NULL, &status);
    f.issue = copied(issue, &status);
    f.relation = copied(relation, &status);
    if (status == ET_OK)
        status = et_request_print(&f.request, &c->request);
    if (status == ET_OK && c->how == ET_ASKED_REPLY)
        status = print_reply(&f.reply, &c->reply);
    if (status != ET_OK) {
        free_finding(&f);
        return status;
    }
    if (!relation)
        status = shrink(run, &f, c);
    run->report->finding[run->report->findings++] = f;
    return status;
}
