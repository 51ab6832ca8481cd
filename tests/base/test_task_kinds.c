/* base/task: one step after another: each is told once, in order, and answered by itself. */
#include "etalon/base/task.h"
#include "gen.h"

enum { STEPS = 20 };
typedef struct { size_t calls, done[STEPS]; et_status answer[STEPS]; } record;

static et_status note(void *context, size_t done, size_t total)
{
    record *r = context;

    r->done[r->calls] = total - done;
    return r->answer[r->calls++];
}

verdict prop_task_step_sequence(gen *g)
{
    const size_t n = (size_t)gen_upto(g, STEPS);
    record r = {0, {0}, {ET_OK}};
    const et_task task = {note, &r};
    bool ok = true;

    for (size_t k = 0; k < n; k++)
        r.answer[k] = (et_status)gen_upto(g, ET_EDIFFER);
    for (size_t k = 0; ok && k < n; k++)
        ok = gen_check(g, et_task_step(&task, k, n) == r.answer[k] && r.calls == k + 1 && r.done[k] == n - k, "step %zu of %zu", k, n);
    return ok ? PASS : FAIL;
}
