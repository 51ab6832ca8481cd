/* What the harnesses share: unknown numbers, and curves, surfaces and shells of the sizes that they are for.
 *
 * An entry point is a function `void eva_...(void)`.  Sizes, degrees and knots are concrete; coordinates, weights, parameters and seeds are any finite
 * numbers; any one of the requests for memory may fail. */
#ifndef PROOFS_EVA_H
#define PROOFS_EVA_H
#include "__fc_builtin.h"
#include "etalon/fit/shell.h"
#include "etalon/spline/curve.h"
#include "etalon/spline/surface.h"
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/* Of degree p: numbers of control points, and knots on [0,1], clamped, of degree 3 with a double one. */
static const size_t counts[4] = {3, 4, 4, 6};
static const double knots[4][10] = {{0, 0.25, 0.5, 1}, {0, 0, 0.25, 0.5, 1, 1}, {0, 0, 0, 0.5, 1, 1, 1}, {0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1}};

double any(void);
void any_memory(void);
void fill(double *x, size_t n);
int make_curve(et_curve *c, size_t p, int rational);
int make_surface(et_surface *s, size_t p, size_t q, int rational);
int make_shell(et_shell *s, size_t p, size_t q, int rational);
#endif
