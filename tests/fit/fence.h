/* fence: an array at the very end of the memory that may be touched, so that what is read or written behind it ends the program at once. */
#ifndef TESTS_FIT_FENCE_H
#define TESTS_FIT_FENCE_H
#include <fcntl.h>
#include <stddef.h>
#include <sys/mman.h>
#include <unistd.h>

enum { FENCE_BYTES = 1 << 18 };
typedef struct {
    unsigned char *end;
} fence;

/* Room for n doubles; null where there is no such memory.  Later arrays of the same fence overlap the earlier ones. */
static inline double *fence_doubles(fence *f, size_t n)
{
    if (f->end == NULL) {
        const int zero = open("/dev/zero", O_RDWR);
        void *p = mmap(NULL, FENCE_BYTES + (1 << 16), PROT_READ | PROT_WRITE, MAP_PRIVATE, zero, 0);
        close(zero);
        if (p == MAP_FAILED || mprotect((unsigned char *)p + FENCE_BYTES, 1 << 16, PROT_NONE) != 0)
            return NULL;
        f->end = (unsigned char *)p + FENCE_BYTES;
    }
    return n * sizeof(double) <= FENCE_BYTES ? (double *)(void *)(f->end - n * sizeof(double)) : NULL;
}
#endif
