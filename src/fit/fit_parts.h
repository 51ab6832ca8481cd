/* fit_parts: what the files of fit share: nodes of a net, collocation, the problem of glued views and its solutions. */
#ifndef FIT_FIT_PARTS_H
#define FIT_FIT_PARTS_H
#include "etalon/fit/fit.h"
#include <stddef.h>
#include <stdint.h>

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

/*@ predicate fit_collocated(fit_collocation *N) =
        1 <= N->w <= N->n && N->m * N->w <= SIZE_MAX && \valid(N->start + (0 .. N->m - 1)) && \valid(N->a + (0 .. N->m * N->w - 1)) &&
        (\forall integer i; 0 <= i < N->m ==> N->start[i] + N->w <= N->n);

    predicate fit_collocated_glued(fit_glued *g) =
        et_net_ok(g->data.nx, g->data.ny) && et_net_ok(g->control.nx, g->control.ny) && 1 <= g->views <= 2 &&
        (\forall integer w; 0 <= w < g->views ==> \valid_read(g->D[w] + (0 .. g->data.nx * g->data.ny - 1)) &&
                                                 \valid(g->P[w] + (0 .. g->control.nx * g->control.ny - 1)));

    predicate fit_numbered(fit_dense *d, integer nodes) =
        \valid_read(d->number + (0 .. nodes - 1)) &&
        (\forall integer at; 0 <= at < nodes ==> d->number[at] < d->columns || d->number[at] >= SIZE_MAX - 1);
*/

/* ---- nodes of a net ---- */

/* Whether node (i, j) is on the border that both views share. */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    assigns  \nothing;
    ensures  truth: \result == 0 || \result == 1;
    ensures  node:  \result == 1 <==> et_net_border(net.nx, net.ny, i, j);
*/
static inline int fit_on_border(et_doublenet net, size_t i, size_t j)
{
    return i == 0 || i == net.nx - 1 || j == 0 || j == net.ny - 1;
}

/* Whether node (i, j) is one of the four corners. */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    assigns  \nothing;
    ensures  truth: \result == 0 || \result == 1;
    ensures  node:  \result == 1 <==> (i == 0 || i == net.nx - 1) && (j == 0 || j == net.ny - 1);
*/
static inline int fit_is_corner(et_doublenet net, size_t i, size_t j)
{
    return (i == 0 || i == net.nx - 1) && (j == 0 || j == net.ny - 1);
}

/* A corner of the grid D. */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    requires valid: \valid_read(D + (0 .. net.nx * net.ny - 1));
    assigns  \nothing;
*/
static inline et_vec3 fit_corner(const et_vec3 *D, et_doublenet net, int far_u, int far_v)
{
    //@ ghost fact_product(0, net.nx - 1, net.ny);
    //@ assert last: 0 <= (net.nx - 1) * net.ny && (net.nx - 1) * net.ny + net.ny == net.nx * net.ny;
    return D[(far_u ? (net.nx - 1) * net.ny : 0) + (far_v ? net.ny - 1 : 0)];
}

/* ---- a view by itself ---- */

/* N of the m parameters t, for n control points of degree p on the knots u; to be freed.  On failure nothing is held. */
/*@ requires valid:  \valid(N);
    assigns  *N;
    ensures  status: \result == ET_OK || \result == ET_ENOMEM;
    ensures  made:   \result == ET_OK ==> fit_collocated(N) && N->m == m && N->n == n && N->w == p + 1;
    ensures  none:   \result != ET_OK ==> N->a == \null && N->start == \null;
*/
et_status fit_collocate(fit_collocation *N, const double *t, size_t m, const double *u, size_t n, size_t p);
/* Free what N holds. */
/*@ requires valid: \valid(N);
    assigns  *N;
    ensures  none:  N->a == \null && N->start == \null && N->m == 0 && N->n == 0 && N->w == 0;
*/
void fit_collocation_free(fit_collocation *N);
/* T[j*m + i] = A[i*n + j]. */
/*@ requires size:  m * n <= SIZE_MAX && m <= SIZE_MAX - 16 && n <= SIZE_MAX - 16;
    requires valid: \valid(T + (0 .. m * n - 1)) && \valid_read(A + (0 .. m * n - 1));
    assigns  T[0 .. m * n - 1];
*/
void fit_transpose(et_vec3 *T, const et_vec3 *A, size_t m, size_t n);
/* P = Nu^+ D (Nv^+)', direction u first.  where: the view's name in messages. */
/*@ requires valid: \valid_read(U) && \valid_read(V) && fit_collocated((fit_collocation *)U) && fit_collocated((fit_collocation *)V);
    requires grids: \valid(P + (0 .. U->n * V->n - 1)) && \valid_read(D + (0 .. U->m * V->m - 1));
    requires where: message == \null || \valid(message);
    assigns  P[0 .. U->n * V->n - 1], message->text[0 .. ET_MESSAGE_SIZE - 1];
*/
et_status fit_solve_view(et_vec3 *P, const fit_collocation *U, const fit_collocation *V, const et_vec3 *D, const char *where, et_linalg_method method,
                         et_message *message);

/* ---- views glued along their border ---- */

/* The control points of g: by orthogonal reduction (QR), else by one dense system. */
/*@ requires valid: \valid_read(g) && fit_collocated_glued((fit_glued *)g) && (message == \null || \valid(message));
    assigns  g->P[0][0 .. g->control.nx * g->control.ny - 1], g->P[1][0 .. g->control.nx * g->control.ny - 1],
             message->text[0 .. ET_MESSAGE_SIZE - 1];
*/
et_status fit_solve_glued(const fit_glued *g, et_linalg_method method, et_message *message);
/* The same with all unknowns at once: NOV rows and columns (of a double net, or of one view). */
/*@ requires valid: \valid_read(g) && fit_collocated_glued((fit_glued *)g) && (message == \null || \valid(message));
    assigns  g->P[0][0 .. g->control.nx * g->control.ny - 1], g->P[1][0 .. g->control.nx * g->control.ny - 1],
             message->text[0 .. ET_MESSAGE_SIZE - 1];
*/
et_status fit_solve_dense(const fit_glued *g, et_linalg_method method, et_message *message);
/* A problem of so many rows, all zero, in the border control points, or in all; to be freed.  On failure nothing is held. */
/*@ requires valid:  \valid(d) && \valid_read(g) && fit_collocated_glued((fit_glued *)g);
    assigns  *d;
    ensures  status: \result == ET_OK || \result == ET_ENOMEM;
    ensures  sizes:  \result == ET_OK ==> d->rows == rows && fit_numbered(d, g->views * (g->control.nx * g->control.ny));
*/
et_status fit_dense_new(fit_dense *d, const fit_glued *g, size_t rows, int all);
/* Free what d holds. */
/*@ requires valid: \valid(d);
    assigns  \nothing;
*/
void fit_dense_free(fit_dense *d);
/* The row's coefficient of control point (i, j) of view w becomes greater by x; a fixed one goes to the right-hand side. */
/*@ requires valid:   \valid_read(d) && \valid_read(g) && fit_collocated_glued((fit_glued *)g);
    requires node:    w < g->views && i < g->control.nx && j < g->control.ny && row < d->rows;
    requires numbers: fit_numbered(d, g->views * (g->control.nx * g->control.ny));
    requires sizes:   g->views * (g->control.nx * g->control.ny) <= SIZE_MAX && d->rows * d->columns <= SIZE_MAX;
    requires room:    \valid(d->A + (0 .. d->rows * d->columns - 1)) && \valid(d->B + (0 .. d->rows - 1));
    requires apart:   \separated(d->B + (0 .. d->rows - 1), d, g, d->number + (0 .. g->views * (g->control.nx * g->control.ny) - 1)) &&
                      \separated(d->A + (0 .. d->rows * d->columns - 1), d, g);
    assigns  d->A[0 .. d->rows * d->columns - 1], d->B[row];
*/
void fit_dense_term(fit_dense *d, size_t row, const fit_glued *g, size_t w, size_t i, size_t j, double x);
/* The row asks for the datum (i, j) of view w. */
/*@ requires valid: \valid_read(d) && \valid_read(g) && fit_collocated_glued((fit_glued *)g) && row < d->rows && w < g->views;
    assigns  d->A[0 .. d->rows * d->columns - 1], d->B[row];
*/
void fit_dense_data(fit_dense *d, size_t row, const fit_glued *g, size_t w, size_t i, size_t j);
/* X of the problem.  what: which control points, in messages. */
/*@ requires valid: \valid_read(d) && \valid_read(g) && (message == \null || \valid(message));
    assigns  d->X[0 .. d->columns - 1], message->text[0 .. ET_MESSAGE_SIZE - 1];
*/
et_status fit_dense_solve(fit_dense *d, const fit_glued *g, const char *what, et_linalg_method method, et_message *message);
/* Every numbered or fixed node gets its point, in both views the same. */
/*@ requires valid:   \valid_read(d) && \valid_read(g) && fit_collocated_glued((fit_glued *)g);
    requires numbers: fit_numbered((fit_dense *)d, g->views * (g->control.nx * g->control.ny));
    requires room:    \valid_read(d->X + (0 .. d->columns - 1));
    assigns  g->P[0][0 .. g->control.nx * g->control.ny - 1], g->P[1][0 .. g->control.nx * g->control.ny - 1];
*/
void fit_dense_deliver(const fit_dense *d, const fit_glued *g);
#endif
