/* The parts of module optimum: a band's Cholesky factor, the model (what is linear), the cones, the balls. */
#ifndef REFINE_OPTIMUM_PARTS_H
#define REFINE_OPTIMUM_PARTS_H
#include "etalon/refine/optimum.h"

/* ---- optimum_band: a symmetric positive definite band matrix, then its Cholesky factor, in square tiles ---- */

enum { OPTIMUM_SIDE = 24 };               /* of a tile; a multiple of 3, so that no 3 x 3 block is cut, and of 4 */

typedef struct {
    size_t n;                             /* rows */
    size_t tiles, width;                  /* rows of tiles; tiles left of the diagonal */
    double *tile;                         /* [row of tiles][distance from the diagonal]: by columns */
} optimum_band;

et_status optimum_band_new(optimum_band *band, size_t n, size_t half);       /* half: the greatest i - j */
void optimum_band_free(optimum_band *band);
void optimum_band_clear(optimum_band *band);
double *optimum_band_at(const optimum_band *band, size_t i, size_t j);       /* i >= j, i - j at most half; of a tile the next */
                                          /* row is the next double, the next column the next but OPTIMUM_SIDE - 1 */
/* L L' = the matrix; a pivot that rounding may have spoilt is replaced.  poor (may be null; optimum_band_work zeros): 1 for rows that seem to depend on those
 * before, which are then left out. */
void optimum_band_factor(optimum_band *band, unsigned char *poor);
void optimum_band_solve(const optimum_band *band, double *x, size_t stride, double *work);
size_t optimum_band_work(const optimum_band *band);                          /* doubles of workspace to solve */

/* ---- optimum_model: r = D - N P in the control points that count ---- */

/* Basis functions of one direction at its parameters, exact zeros left out. */
typedef struct {
    const double *knots, *t;
    size_t n, p, nt;                      /* control points, degree, parameters */
    size_t *first;                        /* [nt] the first of the p+1 functions */
    double *value;                        /* [nt][p+1], each column times 2^shift */
    int *shift;                           /* [n] */
    unsigned char *keep;                  /* [n] columns that span the range; the others depend on them, and their control points stay */
    int clamped;                          /* the first and the last parameter see the first and the last control point alone */
    int whole;                            /* no column but zero ones is left out */
    double *change;                       /* [n][n] T, or null: the unknowns are Z with X = T Z, so that the columns of table = value T are */
    double *table;                        /* [nt][n] nearly orthogonal; the first and the last of X depend on the first and the last of Z alone */
} optimum_axis;

et_status optimum_axis_new(optimum_axis *a, const double *knots, size_t n, size_t p, const double *t, size_t nt);
void optimum_axis_free(optimum_axis *a);
/* Whatever is not zero: where the ends see more than the first and the last control point, columns that depend on each other in one direction need not
 * do so in the net. */
void optimum_axis_keep_all(optimum_axis *a);
/* Of the two directions the one that is worse conditioned gets a better basis, if that is worth the while.  *which 1: the second, 0: the first, -1: none.
 * ET_ENOMEM: then none. */
et_status optimum_axis_change(int *which, optimum_axis *first, optimum_axis *second);

typedef struct {
    et_doublenet data, control;
    size_t nov, m;                        /* data classes; control classes kept */
    size_t half;                          /* the greatest distance of two that meet */
    optimum_axis u, v;
    unsigned char *drop;                  /* [view][i][j]: control nodes left out though both their columns are kept */
    size_t *place;                        /* [view][i][j]: place of a control node among the m, or SIZE_MAX */
    size_t *start, *at;                   /* data class c - 1 has the terms start[c-1] .. start[c]-1: places, */
    double *value;                        /* values */
    et_index *node;                       /* of each data class */
} optimum_model;

et_status optimum_model_new(optimum_model *model, const et_fit *fit);
void optimum_model_free(optimum_model *model);
/* The place of a control node, SIZE_MAX if it stays. */
size_t optimum_model_place(const optimum_model *model, size_t view, size_t i, size_t j);
void optimum_model_apply(double *r, const optimum_model *model, const double *x);       /* r[3 nov] -= N x, x[3 m] */
void optimum_model_adjoint(double *x, const optimum_model *model, const double *y);     /* x[3 m] = N'y */
void optimum_model_points(double *p, const optimum_model *model, const double *z);      /* X = T Z, [3 m] each */
void optimum_model_forces(double *z, const optimum_model *model, const double *x);      /* z = T'x */
/* N'WN: weight[nov] of 1 number a class (m rows), or of 6, a symmetric 3 x 3 block xx, xy, xz, yy, yz, zz (3 m rows). */
void optimum_model_scalar(optimum_band *band, const optimum_model *model, const double *weight);
void optimum_model_blocks(optimum_band *band, const optimum_model *model, const double *weight);

/* ---- optimum_solve: N'WN x = b ---- */

typedef struct {
    const optimum_model *model;
    int blocks;                           /* the weights are blocks, not numbers */
    const double *weight;
    double ridge;                         /* relative, on the diagonal of what is factored */
    optimum_band band;
    double *x, *w;                        /* the solution, and N x: [3 m], [3 nov] pairs of doubles */
    double *work, *row, *tile;
} optimum_solver;

et_status optimum_solve_new(optimum_solver *solver, const optimum_model *model, int blocks);
void optimum_solve_free(optimum_solver *solver);
void optimum_solve_factor(optimum_solver *solver, const double *weight);              /* which stays in use */
/* Until the error in energy has shrunk by `tolerance`; 0 if it does not get there.  What is factored gets a ridge if nothing else helps. */
int optimum_solve_run(optimum_solver *solver, const double *b, double tolerance);
void optimum_solve_take(double *x, double *w, const optimum_solver *solver);          /* x[3 m], w[3 nov] = N x */

/* ---- sums in twice the precision (Dekker 1971; Knuth) ---- */

typedef struct { double hi, lo; } optimum_pair;

optimum_pair optimum_solve_add(optimum_pair s, double a, optimum_pair x);    /* s + a x */

/* ---- optimum_cone: the primal-dual method ---- */

typedef struct {
    const optimum_model *model;
    const et_task *task;
    double *history;
    size_t room, limit;
    double tolerance;                     /* of the relative gap */
    double unit;                          /* one in the method's lengths */
    size_t iterations;
    et_status status;                     /* what the task said */
    double *D;                            /* [3 nov] data less what the control points that stay give, in the method's lengths */
    double *x;                            /* [3 m] the best control points */
    double *y;                            /* [3 nov] the best dual */
    double *weight;                       /* [6 nov] of the metric in which the dual may be moved */
} optimum_search;

et_status optimum_cone_run(optimum_search *search);

/* ---- optimum_ball: proofs ---- */

/* *value: an upper bound of E at the fit's control points; +infinity if that is no double.  r (may be null): the 3 nov residuals, nearly rounded. */
void optimum_ball_value(double *value, double *r, const et_fit *fit, const optimum_model *model, const et_vec3 *data);
/* value[nt][p+1], nearest to the basis functions; and table, nearest to those times 2^shift times T. */
void optimum_ball_axis(optimum_axis *axis);
void optimum_ball_table(optimum_axis *axis);
/* y moved by W N z, so that N'y is zero but for its own roundings. */
et_status optimum_ball_polish(double *y, const optimum_model *model, const double *weight);
/* As et_optimum_bound; proved: 0 if nothing could be. */
et_status optimum_ball_bound(double *lower, int *proved, const double *y, const optimum_model *model, const et_vec3 *data);
#endif
