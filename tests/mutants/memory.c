/* memory: the calls of tests/faults/memory.c as cases of one unit of test. */
#define main memory_alone
#include "../faults/memory.c"

size_t et_memory_cases(const char *folder);
int et_memory_fails(size_t k);

size_t et_memory_cases(const char *folder)
{
    if (!folder || !make_all(folder) || !make_files(folder))
        return 0;
    learn();
    return CALLS;
}

/* Memory, sizes and LAPACK in turn. */
int et_memory_fails(size_t k)
{
    const char *why = NULL;

    for (way = MEMORY; !why && way < WAYS; way++) {
        int end = way != MEMORY && !sized(calls[k].name);
        for (size_t at = 1; !why && !end; at++)
            why = run(k, at, &end);
    }
    return why != NULL;
}
