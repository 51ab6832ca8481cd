/* memory: the calls of tests/faults/memory.c as cases of one unit of test. */
#define main memory_alone
#include "../faults/memory.c"

size_t et_memory_cases(const char *folder);
int et_memory_fails(size_t k);

size_t et_memory_cases(const char *folder)
{
    if (folder)
        json_set_alloc_funcs(__wrap_malloc, __wrap_free);
    return folder && make_all(folder) ? CALLS : 0;
}

int et_memory_fails(size_t k)
{
    const char *why = NULL;
    int end = 0;

    for (size_t at = 1; !why && !end; at++)
        why = run(k, at, &end);
    return why != NULL;
}
