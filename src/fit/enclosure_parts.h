/* enclosure_parts: what the files of enclosure share: systems in double-double, their verified factors, the approaches' exact solutions. */
#ifndef FIT_ENCLOSURE_PARTS_H
#define FIT_ENCLOSURE_PARTS_H
#include "etalon/base/dd.h"
#include "etalon/fit/enclosure.h"
#include <stddef.h>

/* Absolute error of every basis function, product and bound: covers all underflow. */
#define ENCLOSURE_TINY 0x1p-1000
/* u^2. */
#define ENCLOSURE_UNIT2 0x1p-106

/* Weighted least squares: the least sum of weight[i] (d_i - (A x)_i)^2.  Row i of A has the entries a[i*width + k] >= 0 in the columns
 * at[i*width + k]; each is within relative |a| + ENCLOSURE_TINY of the exact matrix's.
 * Once verified: T (upper triangular) is about the inverse of R in A = Q R, C >= |A T| entry by entry, and
 * |(T'A'W A T)^-1| v <= v + defect max(v) for v >= 0. */
typedef struct {
    size_t rows, columns, width;
    size_t tall;      /* most entries in a column */
    size_t *at;
    et_dd *a;
    double *weight;   /* 1 or 2 */
    double *share;    /* views that have the unknown, 1 or 2 */
    double relative;
    double *T, *C;    /* columns x columns, rows x columns */
    double defect;
    double norm, inverse; /* about the greatest singular value and the reciprocal of the least, in unknowns that are not shared */
    et_dd *r, *g, *z; /* room for a column: rows, columns, columns */
    double *work;     /* 3 (rows + columns) */
} enclosure_system;

/* What the enclosure is made from. */
typedef struct {
    const et_fit *fit;
    const et_fit_options *options;
    et_message *message;
    int fixed;            /* corners stand at the data's */
    et_doublenet data, control;
    double *D[2];         /* D[view][3*(i*ny + j) + c], coordinate c divided by 2^exponent[c] */
    int exponent[3];
    double lost[3];       /* what that division may have cost */
} enclosure_job;

/* The exact solution: |x - exact| <= radius, both in the job's scale; [3*(i*cy + j) + c] of each view. */
typedef struct {
    et_dd *x[2];
    double *radius[2];
    double norm, inverse;
} enclosure_solution;

/* ---- systems (enclosure_system.c) ---- */

/* N[0..p]: the basis functions of the span at x in its domain, relative error 26 p u^2 and absolute ENCLOSURE_TINY. */
void enclosure_basis(et_dd *N, const double *u, size_t p, size_t span, double x);
/* How many of the n functions (inner: without the first and last) can be given parameters of their own where they are positive: the rank of their
 * collocation (Schoenberg and Whitney), exactly. */
size_t enclosure_rank(const double *u, size_t n, size_t p, const double *t, size_t m, int inner);
/* The collocation of one direction; inner: without the first and last parameter and without the first and last function. */
et_status enclosure_direction(enclosure_system *s, const double *t, size_t m, const double *u, size_t n, size_t p, int inner);
/* The products of two directions: row i*m2 + j; columns as numbered, n1*n2 numbers, (size_t)-1 for entries that are left out. */
et_status enclosure_product(enclosure_system *s, const enclosure_system *U, const enclosure_system *V, const size_t *number, size_t columns);
/* Free what s holds. */
void enclosure_system_free(enclosure_system *s);

/* ---- verified solutions (enclosure_verify.c, enclosure_solve.c) ---- */

/* Factor and verify a system of full rank.  ET_ENOCONV: no bound can be given; ET_ENOMEM. */
et_status enclosure_verify(enclosure_system *s);
/* x and radius (columns of them) for the right-hand side d, each d_i within error[i] of the exact one. */
void enclosure_column(et_dd *x, double *radius, enclosure_system *s, const et_dd *d, const double *error);

/* ---- the approaches (enclosure_views.c) ---- */

/* The exact solution of the job's approach; to be freed.  On failure nothing is held and the message is set. */
/*@ requires valid: \valid(x) && \valid_read(job) && (job->message == \null || \valid(job->message));
    assigns  *x, job->message->text[0 .. ET_MESSAGE_SIZE - 1];
*/
et_status enclosure_solve(enclosure_solution *x, const enclosure_job *job);
/* Free what x holds. */
/*@ requires valid: \valid(x);
    assigns  *x;
*/
void enclosure_solution_free(enclosure_solution *x);

/* ---- measures (enclosure_measure.c) ---- */

/* The normwise backward error of the fit's control points, in eps.  ET_ENOMEM. */
/*@ requires valid: \valid(backward) && \valid_read(job) && \valid_read(x);
    assigns  *backward;
*/
et_status enclosure_backward(double *backward, const enclosure_job *job, const enclosure_solution *x);
#endif
