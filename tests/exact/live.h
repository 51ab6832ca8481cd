/* live: what a call does with FLINT's and GMP's memory: whether it keeps any, reads what nobody has written, or goes beyond an array.  What FLINT
 * keeps for later is given back before counting.  All that is new, also on the stack below, and what lies around it is filled with bytes 0x41, an
 * integer of FLINT's where there is no memory. */
#ifndef TESTS_EXACT_LIVE_H
#define TESTS_EXACT_LIVE_H
#include <flint/flint.h>
#include <gmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#if defined __SANITIZE_ADDRESS__
#define LIVE_SANITIZED 1
#elif defined __has_feature
#if __has_feature(address_sanitizer)
#define LIVE_SANITIZED 1
#endif
#endif

/* A block: its size and a sign, guards, what was asked for, guards; the sanitizer has guards of its own. */
#ifdef LIVE_SANITIZED
enum { LIVE_GUARDS = 0, LIVE_FILL = 0x41 };
#else
enum { LIVE_GUARDS = 64, LIVE_FILL = 0x41 };
#endif
enum { LIVE_HEAD = 16, LIVE_SIGN = 0x1e5c0de };

static long live_blocks, live_torn;
static int live_open;

static inline void *live_put(unsigned char *block, size_t n)
{
    size_t head[2] = {n, LIVE_SIGN};

    if (block == NULL)
        return NULL;
    memcpy(block, head, sizeof head);
    memset(block + LIVE_HEAD, LIVE_FILL, LIVE_GUARDS);
    memset(block + LIVE_HEAD + LIVE_GUARDS + n, LIVE_FILL, LIVE_GUARDS);
    live_blocks++;
    return block + LIVE_HEAD + LIVE_GUARDS;
}

static inline void *live_alloc(size_t n)
{
    const size_t more = LIVE_HEAD + 2 * (size_t)LIVE_GUARDS;
    unsigned char *p = n < SIZE_MAX - more ? live_put(malloc(n + more), n) : NULL;

    return p == NULL ? NULL : memset(p, LIVE_FILL, n);
}

static inline void *live_zeros(size_t n, size_t size)
{
    unsigned char *p = size == 0 || n <= SIZE_MAX / size ? live_alloc(n * size) : NULL;

    return p == NULL ? NULL : memset(p, 0, n * size);
}

static inline int live_filled(const unsigned char *p)
{
    static const unsigned char whole[] = "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA";

    return memcmp(p, whole, LIVE_GUARDS) == 0;
}

/* Its size. */
static inline size_t live_check(const unsigned char *p)
{
    const unsigned char *block = p - LIVE_GUARDS - LIVE_HEAD;
    size_t head[2];

    memcpy(head, block, sizeof head);
    if (head[1] != LIVE_SIGN || !live_filled(block + LIVE_HEAD) || !live_filled(p + head[0]))
        live_torn++;
    return head[0];
}

static inline void live_free(void *p)
{
    if (p == NULL)
        return;
    memset(p, LIVE_FILL, live_check(p));
    live_blocks--;
    free((unsigned char *)p - LIVE_GUARDS - LIVE_HEAD);
}

static inline void *live_realloc(void *p, size_t n)
{
    void *q = live_alloc(n);

    if (p != NULL && q != NULL) {
        const size_t old = live_check(p);
        memcpy(q, p, old < n ? old : n);
        live_free(p);
    }
    return q;
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

static inline void live_stack(int huge)
{
    volatile unsigned char below[1 << 14];

    for (size_t i = 0; i < sizeof below; i++)
        below[i] = huge ? 0xff : LIVE_FILL;
}

/* It takes a third of a millisecond, so that only every fourth key is looked at; every eighth with the stack full of bytes 0xff, sizes beyond all. */
static inline void live_begin(size_t key)
{
    live_open = key % 4 == 0;
    if (!live_open)
        return;
    flint_cleanup();
    live_blocks = live_torn = 0;
    __flint_set_memory_functions(live_alloc, live_zeros, live_realloc, live_free);
    mp_set_memory_functions(live_alloc, live_gmp_realloc, live_gmp_free);
    live_stack(key % 8 == 0);
}

/* Whether nothing is held that was not at live_begin, and nothing was written beyond a block; all is as before it. */
static inline int live_end(void)
{
    if (!live_open)
        return 1;
    flint_cleanup();
    __flint_set_memory_functions(malloc, calloc, realloc, free);
    mp_set_memory_functions(NULL, NULL, NULL);
    return live_blocks == 0 && live_torn == 0;
}
#endif
