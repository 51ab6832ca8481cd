/* task: how a long computation tells its progress and learns that it should stop.
 *
 * The callback is called now and then with what is done of what is to do; whatever it returns but ET_OK ends the
 * computation, which then delivers its best so far and returns that status (ET_ESTOPPED by custom).
 */
#ifndef ETALON_BASE_TASK_H
#define ETALON_BASE_TASK_H
#include "etalon/base/status.h"
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef et_status (*et_task_fn)(void *context, size_t done, size_t total);
typedef struct { et_task_fn step; void *context; } et_task;

/* ET_OK if task or its callback is null, else what the callback returns for (task->context, done, total); it is called once.
 * The callback writes to its own memory only: to nothing that the computation reads or writes.
 * Golden: none (the caller's function decides). */
/*@ requires task: task == \null || \valid_read(task);
    requires done: done <= total;
    assigns  \result \from task, done, total;
    ensures  none: \old(task == \null || task->step == \null) ==> \result == ET_OK;
*/
et_status et_task_step(const et_task *task, size_t done, size_t total);

#ifdef __cplusplus
}
#endif
#endif
