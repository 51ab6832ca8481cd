#include "etalon/base/task.h"

et_status et_task_step(const et_task *task, size_t done, size_t total)
{
    return task && task->step ? task->step(task->context, done, total) : ET_OK;
}
