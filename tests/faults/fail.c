/* fail: preloaded, it lets one allocation or one call that writes fail.  A shared object of its own, for the tests only.
 *
 * ET_FAIL_ALLOC=K  the K-th allocation returns null; ET_FAIL_LASTING=1: and all after it
 * ET_FAIL_WRITE=K  the K-th call of write, fsync, rename, open for writing, ftruncate and the like fails as on a full disk
 * ET_FAIL_TELL=F   on exit both counts are written to the file F: `allocations writes`
 *
 * Counted are the calls made from the program itself and from the C library on its behalf, but not those of libraries that are known to end the
 * program when memory is short (FLINT, MPFR, GMP) nor those of the loader.  Writes to standard error do not count: messages must get through.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

extern void *__libc_malloc(size_t);
extern void *__libc_calloc(size_t, size_t);
extern void *__libc_realloc(void *, size_t);
extern void *__libc_memalign(size_t, size_t);

enum { RANGES = 16 };
static struct { uintptr_t from, to; } range[RANGES];
static int ranges;
static int ready;
static unsigned long allocations, writes, fail_alloc, fail_write;
static int lasting;

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
    const char *path = getenv("ET_FAIL_TELL");
    const unsigned long a = allocations, w = writes;
    FILE *f;

    ready = 0;
    f = path ? fopen(path, "w") : NULL;
    if (f) {
        fprintf(f, "%lu %lu\n", a, w);
        fclose(f);
    }
}

__attribute__((constructor)) static void begin(void)
{
    dl_iterate_phdr(note, NULL);
    fail_alloc = setting("ET_FAIL_ALLOC");
    fail_write = setting("ET_FAIL_WRITE");
    lasting = setting("ET_FAIL_LASTING") != 0;
    atexit(tell);
    ready = 1;
}

static int falls(unsigned long *count, unsigned long at, const void *caller)
{
    if (!ready)
        return 0;
    for (int k = 0; k < ranges; k++)
        if (range[k].from <= (uintptr_t)caller && (uintptr_t)caller < range[k].to) {
            const unsigned long n = __atomic_add_fetch(count, 1, __ATOMIC_RELAXED);
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

static int full(const void *caller)
{
    if (!falls(&writes, fail_write, caller))
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
