/* exact_parts: what the files of exact share: doubles in and out of rationals and balls, exact basis functions and points. */
#ifndef EXACT_EXACT_PARTS_H
#define EXACT_EXACT_PARTS_H
#include "etalon/exact/exact.h"
#include <arb.h>
#include <flint/fmpq.h>
#include <flint/fmpq_vec.h>

enum { EXACT_BITS = 128 };                /* where balls begin */

/* ---- rounding (exact_round.c) ---- */

/* q = x, exactly; x finite. */
void exact_set(fmpq_t q, double x);
/* The double nearest to q, ties to even, subnormals and overflow as IEEE 754 rounds; zero is +0. */
double exact_round(const fmpq_t q);
/* The double nearest to sqrt(q), q >= 0: decided by integers, ties included. */
double exact_round_sqrt(const fmpq_t q);
/* 1 and *x if all numbers of the ball round to the one double *x (zero: +0), else 0 and *x as it was. */
int exact_round_ball(double *x, const arb_t ball);

/* ---- basis functions (exact_basis.c) ---- */

/* D[k*(p+1) + j]: k-th derivative of N_{span-p+j,p} at x (clamped to the domain), k = 0..d; (d+1)(p+1) initialised rationals. */
void exact_basis(fmpq *D, size_t d, const double *u, size_t nu, size_t p, size_t span, double x);

/* ---- points (exact_surface.c) ---- */

/* S(u,v): three initialised rationals. */
void exact_surface(fmpq *S, const et_surface *s, double u, double v);
#endif
