/* mutants: what an instrumented source file asks at each of its points. */
#ifndef TESTS_MUTANTS_H
#define TESTS_MUTANTS_H
#include <stddef.h>

/* The points of one file: on[p] is not zero where somebody wants to know about p; the mutants of p are first[p] .. first[p + 1] - 1. */
typedef struct {
    const char *path;
    unsigned char *on;
    const unsigned *first;
    unsigned points;
} et_points;

/* Which of n variants, each of so many bytes, the first of which is the original.  Only watching: the original, and the others are noted that differ. */
unsigned et_choose(const et_points *f, unsigned p, const void *variants, size_t size, unsigned n);
/* Is the only mutant of p wanted? */
int et_flip(const et_points *f, unsigned p);
/* This mutant of p divides by zero here. */
void et_trap(const et_points *f, unsigned p, unsigned variant);
int et_same(const void *a, const void *b, size_t size);
#endif
