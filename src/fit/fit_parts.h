/* fit_parts: what the files of fit share: nodes of a net, collocation, the problem of glued views and its solutions. */
#ifndef FIT_FIT_PARTS_H
#define FIT_FIT_PARTS_H
#include "etalon/fit/fit.h"
#include <stddef.h>

/* The linear algebra sees points as three columns of doubles. */
typedef char fit_assert_vec3[sizeof(et_vec3) == 3 * sizeof(double) ? 1 : -1];

/* The basis functions at the parameters, by rows of p + 1 entries. */
typedef struct {
    size_t m, n, w; /* parameters, control points, p + 1 */
    double *a;      /* a[i*w + k] = N_{start[i]+k}(t_i) */
    size_t *start;
} fit_collocation;

/* Views to be fitted glued along their border. */
typedef struct {
    size_t views; /* 1 or 2; two share their border and their collocation */
    int fixed;    /* corners stand at the data's corners */
    et_doublenet data, control;
    const fit_collocation *U, *V;
    const et_vec3 *D[2];
    et_vec3 *P[2];
    const char *where;
} fit_glued;

/* A dense least-squares problem in the control points of glued views, those that are numbered. */
typedef struct {
    size_t rows, columns;
    double *A;
    et_vec3 *B, *X;
    size_t *number;
} fit_dense;

/* ---- nodes of a net ---- */

/* Whether node (i, j) is on the border that both views share. */
static inline int fit_on_border(et_doublenet net, size_t i, size_t j)
{
    return i == 0 || i == net.nx - 1 || j == 0 || j == net.ny - 1;
}

/* Whether node (i, j) is one of the four corners. */
static inline int fit_is_corner(et_doublenet net, size_t i, size_t j)
{
    return (i == 0 || i == net.nx - 1) && (j == 0 || j == net.ny - 1);
}

/* A corner of the grid D. */
static inline et_vec3 fit_corner(const et_vec3 *D, et_doublenet net, int far_u, int far_v)
{
    return D[(far_u ? (net.nx - 1) * net.ny : 0) + (far_v ? net.ny - 1 : 0)];
}

/* ---- a view by itself ---- */

/* N of the m parameters t, for n control points of degree p on the knots u; to be freed.  On failure nothing is held. */
et_status fit_collocate(fit_collocation *N, const double *t, size_t m, const double *u, size_t n, size_t p);
/* Free what N holds. */
void fit_collocation_free(fit_collocation *N);
/* T[j*m + i] = A[i*n + j]. */
void fit_transpose(et_vec3 *T, const et_vec3 *A, size_t m, size_t n);
/* P = Nu^+ D (Nv^+)', direction u first.  where: the view's name in messages. */
et_status fit_solve_view(et_vec3 *P, const fit_collocation *U, const fit_collocation *V, const et_vec3 *D, const char *where, et_linalg_method method,
                         et_message *message);

/* ---- views glued along their border ---- */

/* The control points of g: by orthogonal reduction (QR), else by one dense system. */
et_status fit_solve_glued(const fit_glued *g, et_linalg_method method, et_message *message);
/* The same with all unknowns at once: NOV rows and columns (of a double net, or of one view). */
et_status fit_solve_dense(const fit_glued *g, et_linalg_method method, et_message *message);
/* A problem of so many rows, all zero, in the border control points, or in all; to be freed.  On failure nothing is held. */
et_status fit_dense_new(fit_dense *d, const fit_glued *g, size_t rows, int all);
/* Free what d holds. */
void fit_dense_free(fit_dense *d);
/* The row's coefficient of control point (i, j) of view w becomes greater by x; a fixed one goes to the right-hand side. */
void fit_dense_term(fit_dense *d, size_t row, const fit_glued *g, size_t w, size_t i, size_t j, double x);
/* The row asks for the datum (i, j) of view w. */
void fit_dense_data(fit_dense *d, size_t row, const fit_glued *g, size_t w, size_t i, size_t j);
/* X of the problem.  what: which control points, in messages. */
et_status fit_dense_solve(fit_dense *d, const fit_glued *g, const char *what, et_linalg_method method, et_message *message);
/* Every numbered or fixed node gets its point, in both views the same. */
void fit_dense_deliver(const fit_dense *d, const fit_glued *g);
#endif
