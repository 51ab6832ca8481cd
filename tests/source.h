/* source: the inside of a source of choices, for the engines only (check, shrink, fuzz); a property knows gen.h and nothing else. */
#ifndef TESTS_SOURCE_H
#define TESTS_SOURCE_H
#include "gen.h"

enum {
    GEN_DRAWS = 1 << 14,                 /* draws recorded; later ones are 0 */
    GEN_SPANS = 1 << 12,
    GEN_BYTES = 8 * GEN_DRAWS,
    GEN_LABELS = 64,
    GEN_LABEL_SIZE = 40
};

typedef struct { uint64_t value, max; } draw;
typedef struct { size_t from, to; } span;               /* draws from .. to-1 belong together */
typedef struct { char text[GEN_LABEL_SIZE]; size_t cases; bool here; } label;
typedef enum { FROM_SEED, FROM_BYTES, FROM_VALUES } origin;

/* No pointer of this struct is needed to read what was drawn: it may live in memory shared with a process that has died. */
struct gen {
    origin from;
    uint64_t state;                      /* FROM_SEED */
    const uint8_t *bytes;                /* FROM_BYTES; zeros beyond the end */
    size_t nbytes, pos;
    const uint64_t *values;              /* FROM_VALUES; zeros beyond the end, larger ones than allowed become the largest */
    size_t nvalues;
    draw draws[GEN_DRAWS];
    size_t ndraws;
    span spans[GEN_SPANS];
    size_t nspans, depth;
    label labels[GEN_LABELS];
    size_t nlabels;
    bool show, show_draws;
};

void gen_clear(gen *g);                                           /* no draws, no labels */
void gen_from_seed(gen *g, uint64_t seed);                        /* a new case; the counts of the labels stay */
void gen_from_bytes(gen *g, const uint8_t *bytes, size_t n);
void gen_from_values(gen *g, const uint64_t *values, size_t n);
size_t gen_encode(uint8_t bytes[GEN_BYTES], const draw *draws, size_t n);   /* the canonical bytes of these draws; their number */
extern const char *const gen_standard[];                          /* the labels that the typed generators give; ends with a null */
uint64_t gen_mix(uint64_t x);                                     /* splitmix64 */
#endif
