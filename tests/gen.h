/* gen: a source of choices.
 *
 * Every random value of a property is drawn here, and every draw is backed by bytes: from a seed, from libFuzzer, or from a file.  Hence a
 * failing random case, a fuzzer's crash, a corpus entry and a shrunk case are one thing.  Decoding is total, and the byte 0 gives the
 * simplest value: whoever writes a generator keeps it so.
 */
#ifndef TESTS_GEN_H
#define TESTS_GEN_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct gen gen;
typedef enum { PASS, FAIL, SKIP } verdict;
/* in: a property whose cases are long says "One case in N." in a comment of its own on the line before it, and gets that share of the cases. */
typedef struct { const char *name; verdict (*run)(gen *g); size_t in; } property;
extern const property properties[];      /* generated; ends with a null name */

uint64_t gen_upto(gen *g, uint64_t max);                 /* 0 .. max; 0 the simplest */
uint64_t gen_between(gen *g, uint64_t lo, uint64_t hi);  /* lo .. hi; lo the simplest */
bool gen_chance(gen *g, unsigned in);                    /* true once in `in`; false the simplest */
double gen_real(gen *g, double lo, double hi);           /* lo the simplest; grid points of sixteenths come often */

/* The rest of the source as it stands, at most `most` bytes: of a file or a fuzzer its own bytes, so that what a reader is given is a case as it is.
 * From a seed: one of the samples (the list ends with a null), altered in a few places.  No bytes are the simplest. */
typedef struct { const char *bytes; size_t size; } sample;
size_t gen_rest(gen *g, uint8_t *bytes, size_t most, const sample *samples);

/* A knot vector of degree p with `spans` non-zero or zero interior steps, clamped on [0,1]: nu = 2p + 2 + interior.  Hard cases come often:
 * repeated knots to full multiplicity, knots one ulp apart, tiny spans. */
void gen_knots(gen *g, double *u, size_t nu, size_t p);
/* A parameter of the domain [lo, hi] of u[0..nu-1]: ends, knots, neighbours of knots come often. */
double gen_parameter(gen *g, const double *u, size_t nu, size_t p);
/* n points (x,y,z triples): scales, coincident points, collinear points come often. */
void gen_points(gen *g, double *xyz, size_t n);

/* Label a case; the frequencies are printed per property (check -v). */
void gen_label(gen *g, const char *label);
/* ok, and when it is not and a counterexample is being shown, the sentence (printf's rules) is printed. */
bool gen_check(gen *g, bool ok, const char *format, ...);
/* Printed only while a counterexample is shown. */
void gen_note(gen *g, const char *format, ...);
#endif
