/* fail: preloaded, it lets one allocation or one call that writes fail.  A shared object of its own, for the tests only.
 *
 * ET_FAIL_ALLOC=K  the K-th allocation returns null; ET_FAIL_LASTING=1: and all after it
 * ET_FAIL_WRITE=K  the K-th call of write, fsync, rename, open for writing, ftruncate and the like fails as on a full disk
 * ET_FAIL_READ=K   the K-th call of fread fails as on a disk that cannot be read
 * ET_FAIL_SLOW=K    the K-th of these calls makes the file `slow` and takes three seconds, whatever signals come
 * ET_FAIL_TELL=F   on exit the counts are written to the file F: `allocations writes reads`; then, a line each, which of them were the first from their place in
 *                  the program: `a K` and `w K`, where a place is the chain of the program's calls that led there
 *
 * Counted are the calls made from the program itself and from the C library on its behalf, but not those of libraries that are known to end the
 * program when memory is short (FLINT, MPFR, GMP) nor those of the loader.  Writes to standard error do not count: messages must get through.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

extern void *__libc_malloc(size_t);
extern void *__libc_calloc(size_t, size_t);
extern void *__libc_realloc(void *, size_t);
extern void *__libc_memalign(size_t, size_t);

enum { RANGES = 16, PLACES = 4096, DEPTH = 24 };
static struct { uintptr_t from, to; int program; } range[RANGES];
static int ranges;
static int ready;
static unsigned long allocations, writes, reads, fail_alloc, fail_write, fail_read, slow;
static int lasting;
static struct { uintptr_t chain; unsigned long first; char kind; } place[PLACES];
static const char *tell_to;

static int counts_as_ours(const char *name)
{
    return name[0] == '\0' || strstr(name, "/libc.so") || strstr(name, "libjansson");
}

static int note(struct dl_phdr_info *info, size_t size, void *data)
{
    (void)size, (void)data;
    for (int k = 0; counts_as_ours(info->dlpi_name) && k < info->dlpi_phnum && ranges < RANGES; k++)
        if (info->dlpi_phdr[k].p_type == PT_LOAD && (info->dlpi_phdr[k].p_flags & PF_X)) {
            range[ranges].from = info->dlpi_addr + info->dlpi_phdr[k].p_vaddr;
            range[ranges].to = range[ranges].from + info->dlpi_phdr[k].p_memsz;
            range[ranges].program = info->dlpi_name[0] == '\0';
            ranges++;
        }
    return 0;
}

static unsigned long setting(const char *name)
{
    const char *text = getenv(name);

    return text ? strtoul(text, NULL, 10) : 0;
}

/* From here on nothing fails: tests/cover/exit.c. */
void et_fail_off(void);
void et_fail_off(void)
{
    ready = 0;
}

static void tell(void)
{
    const unsigned long a = allocations, w = writes, r = reads;
    FILE *f;

    ready = 0;
    f = tell_to ? fopen(tell_to, "w") : NULL;
    if (f) {
        fprintf(f, "%lu %lu %lu\n", a, w, r);
        for (int k = 0; k < PLACES; k++)
            if (place[k].kind)
                fprintf(f, "%c %lu\n", place[k].kind, place[k].first);
        fclose(f);
    }
}

__attribute__((constructor)) static void begin(void)
{
    static const char *const names[] = { "ET_FAIL_ALLOC", "ET_FAIL_WRITE", "ET_FAIL_READ", "ET_FAIL_SLOW", "ET_FAIL_LASTING", "ET_FAIL_TELL" };
    void *first[1];

    dl_iterate_phdr(note, NULL);
    tell_to = getenv("ET_FAIL_TELL") ? strdup(getenv("ET_FAIL_TELL")) : NULL;
    (void)backtrace(first, 1);           /* the first call allocates */
    fail_alloc = setting("ET_FAIL_ALLOC");
    fail_write = setting("ET_FAIL_WRITE");
    fail_read = setting("ET_FAIL_READ");
    slow = setting("ET_FAIL_SLOW");
    lasting = setting("ET_FAIL_LASTING") != 0;
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        (void)unsetenv(names[k]);        /* what the program starts is left alone */
    atexit(tell);
    ready = 1;
}

/* A loop over the same calls is one place; with OMP_NUM_THREADS=1, as counts must be, nobody else is here. */
static void note_place(char kind, unsigned long n)
{
    void *caller[DEPTH];
    uintptr_t chain = (uintptr_t)kind;

    ready = 0;
    for (int k = 0, depth = backtrace(caller, DEPTH); k < depth; k++)
        for (int r = 0; r < ranges; r++)
            if (range[r].program && range[r].from <= (uintptr_t)caller[k] && (uintptr_t)caller[k] < range[r].to)
                chain = (chain ^ (uintptr_t)caller[k]) * (uintptr_t)0x9e3779b97f4a7c15u;
    ready = 1;
    for (size_t tried = 0, k = chain >> 20; tried < PLACES; tried++, k++)
        if (!place[k % PLACES].kind || place[k % PLACES].chain == chain) {
            if (!place[k % PLACES].kind) {
                place[k % PLACES].kind = kind;
                place[k % PLACES].chain = chain;
                place[k % PLACES].first = n;
            }
            return;
        }
}

static int falls(unsigned long *count, unsigned long at, const void *caller)
{
    if (!ready)
        return 0;
    for (int k = 0; k < ranges; k++)
        if (range[k].from <= (uintptr_t)caller && (uintptr_t)caller < range[k].to) {
            const unsigned long n = __atomic_add_fetch(count, 1, __ATOMIC_RELAXED);
            if (tell_to)
                note_place(count == &writes ? 'w' : count == &reads ? 'r' : 'a', n);
            return at != 0 && (n == at || (lasting && n > at));
        }
    return 0;
}

/* ---- memory ------------------------------------------------------------------------------------------------------------------ */

static void *no_memory(void)
{
    errno = ENOMEM;
    return NULL;
}

void *malloc(size_t n)
{
    return falls(&allocations, fail_alloc, __builtin_return_address(0)) ? no_memory() : __libc_malloc(n);
}

void *calloc(size_t n, size_t size)
{
    return falls(&allocations, fail_alloc, __builtin_return_address(0)) ? no_memory() : __libc_calloc(n, size);
}

void *realloc(void *p, size_t n)
{
    return falls(&allocations, fail_alloc, __builtin_return_address(0)) ? no_memory() : __libc_realloc(p, n);
}

int posix_memalign(void **p, size_t align, size_t n)
{
    if (falls(&allocations, fail_alloc, __builtin_return_address(0)))
        return ENOMEM;
    *p = __libc_memalign(align, n);
    return *p ? 0 : ENOMEM;
}

void *aligned_alloc(size_t align, size_t n)
{
    return falls(&allocations, fail_alloc, __builtin_return_address(0)) ? no_memory() : __libc_memalign(align, n);
}

/* ---- what writes --------------------------------------------------------------------------------------------------------------- */

static void sleep_through(void)
{
    struct timespec left = { 3, 0 };
    FILE *f;

    slow = 0;
    f = fopen("slow", "w");
    if (f)
        fclose(f);
    while (nanosleep(&left, &left) != 0)
        ;
}

static int full(const void *caller)
{
    const int fails = falls(&writes, fail_write, caller);

    if (ready && slow && writes >= slow)
        sleep_through();
    if (!fails)
        return 0;
    errno = ENOSPC;
    return 1;
}

ssize_t write(int fd, const void *data, size_t n)
{
    static ssize_t (*real)(int, const void *, size_t);

    if (!real)
        real = (ssize_t(*)(int, const void *, size_t))dlsym(RTLD_NEXT, "write");
    return fd != STDERR_FILENO && full(__builtin_return_address(0)) ? -1 : real(fd, data, n);
}

/* The C library's stdio does not call write() by its public name: the stream's own functions stand in. */
static int stream_fails(FILE *f, const void *caller)
{
    return f != stderr && full(caller);
}

int fflush(FILE *f)
{
    static int (*real)(FILE *);

    if (!real)
        real = (int (*)(FILE *))dlsym(RTLD_NEXT, "fflush");
    return f && stream_fails(f, __builtin_return_address(0)) ? EOF : real(f);
}

int fclose(FILE *f)
{
    static int (*real)(FILE *);
    const int bad = (fcntl(fileno(f), F_GETFL) & O_ACCMODE) != O_RDONLY && stream_fails(f, __builtin_return_address(0));

    if (!real)
        real = (int (*)(FILE *))dlsym(RTLD_NEXT, "fclose");
    const int status = real(f);
    if (bad)
        errno = ENOSPC;
    return bad ? EOF : status;
}

size_t fwrite(const void *data, size_t size, size_t n, FILE *f)
{
    static size_t (*real)(const void *, size_t, size_t, FILE *);

    if (!real)
        real = (size_t(*)(const void *, size_t, size_t, FILE *))dlsym(RTLD_NEXT, "fwrite");
    if (!stream_fails(f, __builtin_return_address(0)))
        return real(data, size, n, f);
    f->_flags |= 0x20;                   /* glibc's _IO_ERR_SEEN: ferror() must know */
    return 0;
}

size_t fread(void *data, size_t size, size_t n, FILE *f)
{
    static size_t (*real)(void *, size_t, size_t, FILE *);

    if (!real)
        real = (size_t(*)(void *, size_t, size_t, FILE *))dlsym(RTLD_NEXT, "fread");
    if (!falls(&reads, fail_read, __builtin_return_address(0)))
        return real(data, size, n, f);
    f->_flags |= 0x20;
    errno = EIO;
    return 0;
}

int ftruncate(int fd, off_t length)
{
    static int (*real)(int, off_t);

    if (!real)
        real = (int (*)(int, off_t))dlsym(RTLD_NEXT, "ftruncate");
    return full(__builtin_return_address(0)) ? -1 : real(fd, length);
}

FILE *tmpfile(void)
{
    static FILE *(*real)(void);

    if (!real)
        real = (FILE * (*)(void)) dlsym(RTLD_NEXT, "tmpfile");
    return full(__builtin_return_address(0)) ? NULL : real();
}

int fsync(int fd)
{
    static int (*real)(int);

    if (!real)
        real = (int (*)(int))dlsym(RTLD_NEXT, "fsync");
    return full(__builtin_return_address(0)) ? -1 : real(fd);
}

int rename(const char *from, const char *to)
{
    static int (*real)(const char *, const char *);

    if (!real)
        real = (int (*)(const char *, const char *))dlsym(RTLD_NEXT, "rename");
    return full(__builtin_return_address(0)) ? -1 : real(from, to);
}

int mkdir(const char *path, mode_t mode)
{
    static int (*real)(const char *, mode_t);

    if (!real)
        real = (int (*)(const char *, mode_t))dlsym(RTLD_NEXT, "mkdir");
    return full(__builtin_return_address(0)) ? -1 : real(path, mode);
}

int mkstemp(char *path)
{
    static int (*real)(char *);

    if (!real)
        real = (int (*)(char *))dlsym(RTLD_NEXT, "mkstemp");
    return full(__builtin_return_address(0)) ? -1 : real(path);
}

int open(const char *path, int flags, ...)
{
    static int (*real)(const char *, int, ...);
    mode_t mode = 0;
    va_list list;

    if (!real)
        real = (int (*)(const char *, int, ...))dlsym(RTLD_NEXT, "open");
    va_start(list, flags);
    if (flags & O_CREAT)
        mode = va_arg(list, mode_t);
    va_end(list);
    return (flags & O_ACCMODE) != O_RDONLY && full(__builtin_return_address(0)) ? -1 : real(path, flags, mode);
}

FILE *fopen(const char *path, const char *how)
{
    static FILE *(*real)(const char *, const char *);

    if (!real)
        real = (FILE * (*)(const char *, const char *)) dlsym(RTLD_NEXT, "fopen");
    return how[0] != 'r' && full(__builtin_return_address(0)) ? NULL : real(path, how);
}
