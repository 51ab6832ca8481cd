/* base/task: the callback is called once, with what it was given. */
#include "etalon/base/task.h"
#include "gen.h"

typedef struct { size_t calls, done, total; et_status answer; } record;

static et_status note(void *context, size_t done, size_t total)
{
    record *r = context;
    r->calls++;
    r->done = done;
    r->total = total;
    return r->answer;
}

verdict prop_task_step(gen *g)
{
    record r = {0, 0, 0, (et_status)gen_upto(g, ET_EDIFFER)};
    size_t total = (size_t)gen_upto(g, 1000), done = (size_t)gen_upto(g, total);
    et_task task = {note, &r}, silent = {NULL, &r};
    bool ok = gen_check(g, et_task_step(NULL, done, total) == ET_OK && et_task_step(&silent, done, total) == ET_OK && r.calls == 0, "no task, no call");
    et_status status = et_task_step(&task, done, total);
    ok = ok && gen_check(g, status == r.answer && r.calls == 1 && r.done == done && r.total == total, "answer %d, calls %zu, done %zu of %zu", (int)status,
                         r.calls, r.done, r.total);
    return ok ? PASS : FAIL;
}
