/* exact_sums_parts: what curves and surfaces share: sums of basis functions and control points in integers over a common denominator. */
#ifndef EXACT_EXACT_SUMS_PARTS_H
#define EXACT_EXACT_SUMS_PARTS_H
#include "exact/exact_parts.h"

/* The place of x's last digit of 53, or `least` if that is less; zero has none. */
slong exact_place(slong least, double x);

/* n = x / 2^place, which is an integer. */
void exact_integer(fmpz_t n, double x, slong place);

enum { EXACT_COMPONENTS = 4 };            /* w x, w y, w z, w */

/* Control points in integers: H[4k + 3] 2^w is the weight of the k-th point, H[4k + a] 2^(w + e) its coordinate a times that.  Without weights
 * they are 1; as the basis functions add up to 1 exactly, a quotient by the sum for w is right there, too. */
typedef struct {
    fmpz *H;
    size_t n;
    slong e, w;
} exact_net;

/* rows x columns points, the first at `points` and its weight at `weights` (or null), `step` from row to row. */
void exact_net_init(exact_net *net, const et_vec3 *points, const double *weights, size_t rows, size_t columns, size_t step);
void exact_net_clear(exact_net *net);

/* A row of basis values: value[r] / denominator. */
typedef struct {
    fmpz *value;
    fmpz_t denominator;
    size_t n;
} exact_row;

void exact_row_init(exact_row *row, const fmpq *values, size_t n);
void exact_row_clear(exact_row *row);

/* The span whose basis functions have the limit at x from that side; x outside the domain is clamped to it. */
size_t exact_span(const double *u, size_t nu, size_t p, double x, et_side side);

/* The basis functions at one parameter, row[k] their k-th derivatives, k <= d; the first control point they meet. */
typedef struct {
    exact_row *row;
    size_t d, first;
} exact_line;

/* n control points of degree p with knots u; x of the domain or clamped to it. */
void exact_line_init(exact_line *line, const double *u, size_t n, size_t p, double x, size_t d);
/* Those of the span, at x or outside it. */
void exact_line_init_at(exact_line *line, const double *u, size_t n, size_t p, size_t span, double x, size_t d);
void exact_line_clear(exact_line *line);

/* N[0..p]: the blossoms (polar forms) at t[0..p-1] of the functions that are not zero in the span, as polynomials. */
void exact_blossom(fmpq *N, const double *u, size_t p, size_t span, const double *t);

/* T[0..4n-1] = sum_r row[r] net[r*stride + first + (0..n-1)], points as they stand in the net. */
void exact_contract(fmpz *T, size_t n, const exact_row *row, const fmpz *H, size_t stride);

/* The three coordinates 2^e S[a] / S[3]. */
void exact_project(fmpq *C, const fmpz *S, slong e);

/* C *= 2^e. */
void exact_scale(fmpq_t C, slong e);

/* 1 if arrays of n rationals can be had, n = a * b; *n as it was if not. */
int exact_fits(size_t *n, size_t a, size_t b);

et_vec3 exact_round_point(const fmpq *C);
#endif
