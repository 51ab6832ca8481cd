/* live: how many blocks FLINT and GMP hold, to see whether a call leaves any behind.  What they keep for later is given back before counting.  The
 * stack below is filled, too, so that what is read before it is written is no number by chance. */
#ifndef TESTS_EXACT_LIVE_H
#define TESTS_EXACT_LIVE_H
#include <flint/flint.h>
#include <gmp.h>
#include <stdlib.h>

static long live_blocks;

static inline void *live_alloc(size_t n)
{
    void *p = malloc(n);
    live_blocks += p != NULL;
    return p;
}

static inline void *live_zeros(size_t n, size_t size)
{
    void *p = calloc(n, size);
    live_blocks += p != NULL;
    return p;
}

static inline void *live_realloc(void *p, size_t n)
{
    void *q = realloc(p, n);
    live_blocks += p == NULL && q != NULL;
    return q;
}

static inline void live_free(void *p)
{
    live_blocks -= p != NULL;
    free(p);
}

static inline void *live_gmp_realloc(void *p, size_t old, size_t n)
{
    (void)old;
    return live_realloc(p, n);
}

static inline void live_gmp_free(void *p, size_t n)
{
    (void)n;
    live_free(p);
}

/* Bytes 0x41 are an integer of FLINT's that lies where there is no memory, bytes 0xff a size beyond all. */
static inline void live_stack(int huge)
{
    volatile unsigned char below[1 << 14];

    for (size_t i = 0; i < sizeof below; i++)
        below[i] = huge ? 0xff : 0x41;
}

static inline void live_begin(int huge)
{
    flint_cleanup();
    live_stack(huge);
    live_blocks = 0;
    __flint_set_memory_functions(live_alloc, live_zeros, live_realloc, live_free);
    mp_set_memory_functions(live_alloc, live_gmp_realloc, live_gmp_free);
}

/* Whether nothing is held that was not at live_begin; all is as before it. */
static inline int live_end(void)
{
    flint_cleanup();
    __flint_set_memory_functions(malloc, calloc, realloc, free);
    mp_set_memory_functions(NULL, NULL, NULL);
    return live_blocks == 0;
}
#endif
