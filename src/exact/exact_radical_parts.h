/* exact_radical_parts: sums of rationals times radicals, rounded once: distances, their sums, and the parameters of lines of points. */
#ifndef EXACT_EXACT_RADICAL_PARTS_H
#define EXACT_EXACT_RADICAL_PARTS_H
#include "exact/exact_parts.h"
#include "exact/exact_sums_parts.h"

enum { EXACT_MOST_BITS = 1 << 16 };       /* where balls are given up, if no proof says that they will come to an end */

/* ---- distances and their sums (exact_radical.c) ---- */

/* The precision to begin with: *bits, or EXACT_BITS for a null pointer or 0. */
size_t exact_first_bits(const size_t *bits);

/* Coordinates in units of 2^e, e <= net->e. */
void exact_net_align(exact_net *net, slong e);

/* Squared length and unit of the difference of two homogeneous points in units of 2^a and 2^b: sqrt(num)/den 2^min(a, b). */
void exact_gap(fmpz_t num, fmpz_t den, const fmpz *A, slong a, const fmpz *B, slong b);

/* sqrt(num)/den 2^e. */
double exact_root(const fmpz_t num, const fmpz_t den, slong e);

/* (sum of sqrt(num[k])/den[k], k < n) 2^e / divisor; den may be null: all 1.  *bits: the precision to begin with, then the one that decided. */
double exact_root_sum(const fmpz *num, const fmpz *den, size_t n, slong e, size_t divisor, size_t *bits);

/* ---- points of a grid (exact_grid.c) ---- */

/* G[4*(i*nb + j)] ..: the homogeneous point S(a[i], b[j]), four whole numbers; the coordinates' unit is 2^*e. */
void exact_grid(fmpz *G, slong *e, const et_surface *s, const double *a, size_t na, const double *b, size_t nb);

/* ---- lines of points (exact_lines.c) ---- */

/* Lines of n chords each; the k-th of line l counts r[l*n + k]^(1/root), each line in a unit of its own.  Lines of no length have equal chords. */
typedef struct {
    size_t lines, n;
    size_t flat;                          /* lines of no length */
    ulong root;
    fmpz *r;
} exact_lines;

/* Lines of n points, `stride` apart, from D[0], D[step], D[2 step], ...: chords, their square roots or their powers 4/5 (method: not uniform).
 * ET_ENOMEM. */
et_status exact_lines_init(exact_lines *L, size_t lines, size_t step, const et_vec3 *D, size_t n, size_t stride, et_param_method method);
void exact_lines_clear(exact_lines *L);
/* t[0..n]: the means over all lines of their parameters.  *bits: the precision to begin with, then the one that
 * decided, 0 if none was needed.  ET_ENOCONV (t and *bits as they were): a sum of roots of different fields is undecided by EXACT_MOST_BITS. */
et_status exact_lines_means(double *t, const exact_lines *L, size_t *bits);
/* t[i] = i/(n-1). */
void exact_uniform(double *t, size_t n);
#endif
