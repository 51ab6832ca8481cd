/* exit: in the coverage build a program that leaves, by _exit too, tells first which lines it has reached; what tests let fail no longer fails then. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <sys/resource.h>

void __gcov_dump(void);
void __real__exit(int code);
void __wrap__exit(int code);

static void leave(void)
{
    const struct rlimit any = { RLIM_INFINITY, RLIM_INFINITY };
    void *symbol = dlsym(RTLD_DEFAULT, "et_fail_off");
    void (*off)(void);

    *(void **)&off = symbol;
    if (symbol)
        off();
    (void)setrlimit(RLIMIT_FSIZE, &any);
}

__attribute__((constructor)) static void enter(void)
{
    (void)atexit(leave);
}

void __wrap__exit(int code)
{
    leave();
    __gcov_dump();
    __real__exit(code);
}
