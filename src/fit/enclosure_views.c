/* enclosure_views: the exact solutions of the three approaches, from verified systems.
 *
 * A view by itself is solved direction by direction, X = Nu+ D and P = X (Nv+)', the radii of X being passed on as errors of the second right-hand
 * side.  Two glued views are separated: with S and T half the sum and half the difference of the views' control points, s and t those of their data,
 *     |D0 - N P0|^2 + |D1 - N P1|^2 = 2 |s - N S|^2 + 2 |t - N T|^2   for interior data,
 * and border data, which see border control points alone, ask for S only, since T is zero there (more than p + 1 equal knots at an end leave a
 * function without support, and a deficient rank, but where all control points are border and T is zero anyway).  Hence T is a product of the directions' interior
 * parts, and S one least-squares problem of a single view in which interior data weigh 2.
 */
#include "etalon/base/size.h"
#include "fit/enclosure_parts.h"
#include "fit/fit_parts.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Points in double-double with their errors, rows of a grid. */
typedef struct {
    et_dd *x;
    double *error;
} points;

/* A column and its solution. */
typedef struct {
    et_dd *d, *x;
    double *error, *radius;
} column;

static const char *const view_names[] = {"bottom view", "top view", "both views"};

static et_status told(et_message *message, et_status status, const char *where, double norm, double inverse)
{
    if (status == ET_ENOCONV)
        return et_status_fail(message, status, "%s: no bound can be given in twice the working precision; the condition number is about %.1g", where,
                              norm * inverse);
    return et_status_fail(message, status, "%s: %s", where, et_status_text(status));
}

/* ---- storage ---- */

static et_status points_new(points *p, size_t n)
{
    size_t coordinates;

    memset(p, 0, sizeof *p);
    if (et_size_mul(&coordinates, n, 3) != ET_OK)
        return ET_ENOMEM;
    p->x = et_size_array(coordinates, sizeof *p->x);
    p->error = et_size_array(coordinates, sizeof *p->error);
    return p->x != NULL && p->error != NULL ? ET_OK : ET_ENOMEM;
}

static void points_free(points *p)
{
    free(p->x);
    free(p->error);
}

static et_status column_new(column *c, const enclosure_system *s)
{
    c->d = et_size_array(s->rows, sizeof *c->d);
    c->error = et_size_array(s->rows, sizeof *c->error);
    c->x = et_size_array(s->columns, sizeof *c->x);
    c->radius = et_size_array(s->columns, sizeof *c->radius);
    return c->d != NULL && c->error != NULL && c->x != NULL && c->radius != NULL ? ET_OK : ET_ENOMEM;
}

static void column_free(column *c)
{
    free(c->d);
    free(c->error);
    free(c->x);
    free(c->radius);
}

/* ---- solutions of verified systems ---- */

/* X (cols x rows x n3: transposed) = A+ D for D of s->rows rows of `lines` points: X[l*n + j] solves for line l. */
static et_status solve_lines(points *X, enclosure_system *s, const points *D, size_t lines)
{
    column c;
    et_status status = column_new(&c, s);

    for (size_t l = 0; status == ET_OK && l < 3 * lines; l++) {
        for (size_t i = 0; i < s->rows; i++) {
            c.d[i] = D->x[i * 3 * lines + l];
            c.error[i] = D->error[i * 3 * lines + l];
        }
        enclosure_column(c.x, c.radius, s, c.d, c.error);
        for (size_t j = 0; j < s->columns; j++) {
            const size_t at = 3 * (l / 3 * s->columns + j) + l % 3;
            X->x[at] = c.x[j];
            X->error[at] = c.radius[j];
            if (!isfinite(c.radius[j]) || !isfinite(c.x[j].hi))
                status = ET_ENOCONV;
        }
    }
    column_free(&c);
    return status;
}

/* P (U->columns x V->columns) = U+ D (V+)'. */
static et_status solve_tensor(points *P, enclosure_system *U, enclosure_system *V, const points *D)
{
    points X, Y;
    et_status status = points_new(&X, U->columns * V->rows), second = points_new(&Y, U->columns * V->columns);

    if (status == ET_OK)
        status = second;
    if (status == ET_OK)
        status = solve_lines(&X, U, D, V->rows);         /* X[j*n1 + a] */
    if (status == ET_OK)
        status = solve_lines(&Y, V, &X, U->columns);     /* rows j of n1 points; Y[a*n2 + b] */
    if (status == ET_OK) {
        memcpy(P->x, Y.x, 3 * U->columns * V->columns * sizeof *P->x);
        memcpy(P->error, Y.error, 3 * U->columns * V->columns * sizeof *P->error);
    }
    points_free(&X);
    points_free(&Y);
    return status;
}

static void keep_norms(enclosure_solution *x, double norm, double inverse)
{
    x->norm = norm > x->norm ? norm : x->norm;
    x->inverse = inverse > x->inverse ? inverse : x->inverse;
}

/* ---- a view by itself ---- */

static et_status directions(enclosure_system *U, enclosure_system *V, const enclosure_job *k, size_t w, int inner)
{
    const et_surface *s = &k->fit->shell.view[w];
    et_status status = enclosure_direction(U, k->fit->s[w], k->data.nx, s->u, s->nu, s->p, inner);

    memset(V, 0, sizeof *V);
    if (status == ET_OK) {
        status = enclosure_direction(V, k->fit->r[w], k->data.ny, s->v, s->nv, s->q, inner);
        if (status != ET_OK)
            enclosure_system_free(U);
    }
    return status;
}

static et_status solve_product(points *P, enclosure_solution *x, const enclosure_job *k, size_t w, int inner, const points *D)
{
    enclosure_system U, V;
    et_status status = directions(&U, &V, k, w, inner);

    if (status != ET_OK)
        return told(k->message, status, view_names[inner ? 2 : w], 0, 0);
    status = enclosure_verify(&U);
    if (status == ET_OK)
        status = enclosure_verify(&V);
    if (status == ET_OK)
        status = solve_tensor(P, &U, &V, D);
    if (status == ET_OK)
        keep_norms(x, U.norm * V.norm, U.inverse * V.inverse);
    else
        told(k->message, status, view_names[inner ? 2 : w], U.norm * (V.norm > 0 ? V.norm : 1), U.inverse * (V.inverse > 0 ? V.inverse : 1));
    enclosure_system_free(&U);
    enclosure_system_free(&V);
    return status;
}

static et_status solve_separate(enclosure_solution *x, const enclosure_job *k, size_t w)
{
    const size_t n = k->data.nx * k->data.ny;
    points D, P = {x->x[w], x->radius[w]};
    et_status status = points_new(&D, n);

    for (size_t at = 0; status == ET_OK && at < 3 * n; at++) {
        D.x[at] = (et_dd){k->D[w][at], 0};
        D.error[at] = k->lost[at % 3];
    }
    status = status == ET_OK ? solve_product(&P, x, k, w, 0, &D) : told(k->message, status, view_names[w], 0, 0);
    points_free(&D);
    return status;
}

/* ---- one system for all control points of a view: fixed corners, and sums of glued views ---- */

/* number[i*cy + j]: the unknown of a control point, SIZE_MAX for a fixed corner; returns how many unknowns there are. */
static size_t number_unknowns(size_t *number, const enclosure_job *k)
{
    const et_doublenet c = k->control;
    size_t count = 0;

    for (size_t i = 0; i < c.nx; i++)
        for (size_t j = 0; j < c.ny; j++)
            number[i * c.ny + j] = k->fixed && fit_is_corner(c, i, j) ? SIZE_MAX : count++;
    return count;
}

/* The value of function j at row i. */
static et_dd entry(const enclosure_system *s, size_t i, size_t j)
{
    for (size_t e = i * s->width; e < (i + 1) * s->width; e++)
        if (s->at[e] == j)
            return s->a[e];
    return (et_dd){0, 0};
}

/* d -= sum of N P over the four corners P of the data: at most 4 products of factors within U->relative + V->relative + 8 u^2, and 4 differences. */
static void subtract_corners(et_dd *d, double *error, const enclosure_job *k, const enclosure_system *U, const enclosure_system *V, size_t c)
{
    const et_doublenet n = k->data;

    for (size_t i = 0; i < n.nx; i++)
        for (size_t j = 0; j < n.ny; j++)
            for (size_t e = 0; e < 4; e++) {
                const et_dd N = et_dd_mul(entry(U, i, e & 1 ? U->columns - 1 : 0), entry(V, j, e & 2 ? V->columns - 1 : 0));
                const double P = k->D[0][3 * ((e & 1 ? (n.nx - 1) * n.ny : 0) + (e & 2 ? n.ny - 1 : 0)) + c];
                et_dd *x = d + i * n.ny + j;
                const double size = fabs(x->hi) + N.hi * fabs(P);
                if (N.hi == 0 || (P == 0 && k->lost[c] == 0))
                    continue;
                *x = et_dd_sub(*x, et_dd_mul(N, (et_dd){P, 0}));
                error[i * n.ny + j] += (U->relative + V->relative + 20 * ENCLOSURE_UNIT2) * size + k->lost[c] + 4 * ENCLOSURE_TINY;
                error[i * n.ny + j] *= 1 + 0x1p-50;
            }
}

/* Coordinate c of the data of one view, or half the sum of both. */
static void take_data(et_dd *d, double *error, const enclosure_job *k, size_t w, size_t c)
{
    for (size_t at = 0; at < k->data.nx * k->data.ny; at++) {
        d[at] = (et_dd){k->D[w & 1][3 * at + c], 0};
        if (w == 2) {
            d[at] = et_dd_two_sum(k->D[0][3 * at + c], k->D[1][3 * at + c]); /* exact, and so is the half */
            d[at] = (et_dd){d[at].hi / 2, d[at].lo / 2};
        }
        error[at] = k->lost[c];
    }
}

/* x of view w, or of half the sum of both views (w = 2), from the verified system s. */
static et_status solve_columns(points *P, enclosure_system *s, const enclosure_job *k, size_t w, const enclosure_system *U, const enclosure_system *V,
                               const size_t *number)
{
    column m;
    et_status status = column_new(&m, s);

    for (size_t c = 0; status == ET_OK && c < 3; c++) {
        take_data(m.d, m.error, k, w, c);
        if (k->fixed)
            subtract_corners(m.d, m.error, k, U, V, c);
        enclosure_column(m.x, m.radius, s, m.d, m.error);
        for (size_t at = 0; at < k->control.nx * k->control.ny; at++) {
            const size_t j = number[at];
            const et_doublenet n = k->data;
            const size_t corner = (at / k->control.ny != 0 ? (n.nx - 1) * n.ny : 0) + (at % k->control.ny != 0 ? n.ny - 1 : 0);
            P->x[3 * at + c] = j == SIZE_MAX ? (et_dd){k->D[0][3 * corner + c], 0} : m.x[j];
            P->error[3 * at + c] = j == SIZE_MAX ? k->lost[c] : m.radius[j];
            if (!isfinite(P->error[3 * at + c]) || !isfinite(P->x[3 * at + c].hi))
                status = ET_ENOCONV;
        }
    }
    column_free(&m);
    return status;
}

/* Interior data and interior unknowns belong to both views. */
static void set_weights(enclosure_system *s, const enclosure_job *k, const size_t *number)
{
    const et_doublenet n = k->data, c = k->control;

    for (size_t i = 0; i < n.nx; i++)
        for (size_t j = 0; j < n.ny; j++)
            s->weight[i * n.ny + j] = fit_on_border(n, i, j) ? 1 : 2;
    for (size_t i = 0; i < c.nx; i++)
        for (size_t j = 0; j < c.ny; j++)
            if (!fit_on_border(c, i, j))
                s->share[number[i * c.ny + j]] = 2;
}

static et_status solve_whole(points *P, enclosure_solution *x, const enclosure_job *k, size_t w)
{
    enclosure_system U, V, s;
    size_t *number = et_size_array(k->control.nx * k->control.ny, sizeof *number), columns;
    et_status status = number == NULL ? ET_ENOMEM : directions(&U, &V, k, w & 1, 0);

    if (status != ET_OK) {
        free(number);
        return told(k->message, status, view_names[w], 0, 0);
    }
    columns = number_unknowns(number, k);
    status = enclosure_product(&s, &U, &V, number, columns);
    if (status == ET_OK && w == 2)
        set_weights(&s, k, number);
    if (status == ET_OK && columns > 0)
        status = enclosure_verify(&s);
    if (status == ET_OK)
        status = solve_columns(P, &s, k, w, &U, &V, number);
    if (status == ET_OK)
        keep_norms(x, s.norm, s.inverse);
    else
        told(k->message, status, view_names[w], s.norm, s.inverse);
    enclosure_system_free(&s);
    enclosure_system_free(&U);
    enclosure_system_free(&V);
    free(number);
    return status;
}

/* ---- two glued views ---- */

/* Half the difference of the interior data: exact. */
static et_status half_difference(points *D, const enclosure_job *k)
{
    const et_doublenet n = k->data;
    const et_status status = points_new(D, (n.nx - 2) * (n.ny - 2));

    for (size_t i = 1; status == ET_OK && i + 1 < n.nx; i++)
        for (size_t j = 1; j + 1 < n.ny; j++)
            for (size_t c = 0; c < 3; c++) {
                const size_t from = 3 * (i * n.ny + j) + c, to = 3 * ((i - 1) * (n.ny - 2) + j - 1) + c;
                const et_dd d = et_dd_two_sum(k->D[0][from], -k->D[1][from]);
                D->x[to] = (et_dd){d.hi / 2, d.lo / 2};
                D->error[to] = k->lost[c];
            }
    return status;
}

/* P0 = S + T, P1 = S - T; a sum costs 3 u^2 + 13 u^3. */
static void combine(enclosure_solution *x, const enclosure_job *k, const points *T)
{
    const et_doublenet c = k->control;

    memcpy(x->x[1], x->x[0], 3 * c.nx * c.ny * sizeof *x->x[1]);
    memcpy(x->radius[1], x->radius[0], 3 * c.nx * c.ny * sizeof *x->radius[1]);
    for (size_t i = 1; i + 1 < c.nx; i++)
        for (size_t j = 1; j + 1 < c.ny; j++)
            for (size_t e = 0; e < 3; e++) {
                const size_t at = 3 * (i * c.ny + j) + e, from = 3 * ((i - 1) * (c.ny - 2) + j - 1) + e;
                const et_dd s = x->x[0][at], t = T->x[from];
                x->x[0][at] = et_dd_add(s, t);
                x->x[1][at] = et_dd_sub(s, t);
                x->radius[0][at] = x->radius[1][at] =
                    (x->radius[0][at] + T->error[from] + 4 * ENCLOSURE_UNIT2 * (fabs(s.hi) + fabs(t.hi))) * (1 + 0x1p-50);
            }
}

static et_status solve_glued(enclosure_solution *x, const enclosure_job *k)
{
    const et_doublenet c = k->control;
    points S = {x->x[0], x->radius[0]}, T = {NULL, NULL}, D = {NULL, NULL};
    et_status status = solve_whole(&S, x, k, 2);

    if (status == ET_OK && c.nx > 2 && c.ny > 2) {
        status = half_difference(&D, k);
        if (status == ET_OK)
            status = points_new(&T, (c.nx - 2) * (c.ny - 2));
        status = status == ET_OK ? solve_product(&T, x, k, 0, 1, &D) : told(k->message, status, view_names[2], 0, 0);
    }
    if (status == ET_OK)
        combine(x, k, &T);
    points_free(&T);
    points_free(&D);
    return status;
}

/* Border control points become the means of the views', corners the data's where fixed. */
static void close_border(enclosure_solution *x, const enclosure_job *k)
{
    const et_doublenet c = k->control, n = k->data;

    for (size_t i = 0; i < c.nx; i++)
        for (size_t j = 0; j < c.ny; j++)
            for (size_t e = 0; e < 3 && fit_on_border(c, i, j); e++) {
                const size_t at = 3 * (i * c.ny + j) + e, corner = 3 * ((i != 0 ? (n.nx - 1) * n.ny : 0) + (j != 0 ? n.ny - 1 : 0)) + e;
                const et_dd a = x->x[0][at], b = x->x[1][at], sum = et_dd_add(a, b);
                const double r = x->radius[0][at] + x->radius[1][at] + 4 * ENCLOSURE_UNIT2 * fabs(sum.hi);
                const int fixed = k->fixed && fit_is_corner(c, i, j);
                x->x[0][at] = x->x[1][at] = fixed ? (et_dd){k->D[0][corner], 0} : (et_dd){sum.hi / 2, sum.lo / 2};
                x->radius[0][at] = x->radius[1][at] = fixed ? k->lost[e] : r / 2 * (1 + 0x1p-50);
            }
}

/* ---- rank ---- */

static et_status check_direction(const enclosure_job *k, size_t w, const char *name, const double *u, size_t n, size_t p, const double *t, size_t m,
                                 int inner)
{
    const size_t rank = enclosure_rank(u, n, p, t, m, inner), wanted = inner ? n - 2 : n;

    if (rank == wanted)
        return ET_OK;
    return et_status_fail(k->message, ET_ERANK, "%s, direction %s: the %zu parameters determine only %zu of %zu control points", view_names[w], name,
                          m, rank, wanted);
}

/* A product has full rank if and only if both directions have, and so has the problem of glued views.  With fixed corners nothing changes, unless the
 * other side is two: then the first and last function belong to corners alone. */
static et_status check_rank(const enclosure_job *k)
{
    const et_doublenet c = k->control, n = k->data;
    const int spared = k->fixed && k->options->approach != ET_FIT_IMPROVED;
    et_status status = ET_OK;

    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        const et_surface *s = &k->fit->shell.view[w];
        status = check_direction(k, w, "u", s->u, c.nx, s->p, k->fit->s[w], n.nx, spared && c.ny == 2);
        if (status == ET_OK)
            status = check_direction(k, w, "v", s->v, c.ny, s->q, k->fit->r[w], n.ny, spared && c.nx == 2);
    }
    return status;
}

/* ---- all of it ---- */

void enclosure_solution_free(enclosure_solution *x)
{
    for (size_t w = 0; w < 2; w++) {
        free(x->x[w]);
        free(x->radius[w]);
    }
    memset(x, 0, sizeof *x);
}

static et_status solve_approach(enclosure_solution *x, const enclosure_job *k)
{
    const et_fit_approach approach = k->options->approach;
    et_status status = check_rank(k);

    if (status == ET_OK && approach == ET_FIT_JOINT)
        return solve_glued(x, k);
    for (size_t w = 0; status == ET_OK && w < 2; w++) {
        points P = {x->x[w], x->radius[w]};
        status = k->fixed && approach == ET_FIT_CONVENTIONAL ? solve_whole(&P, x, k, w) : solve_separate(x, k, w);
    }
    if (status == ET_OK && approach == ET_FIT_IMPROVED)
        close_border(x, k);
    return status;
}

et_status enclosure_solve(enclosure_solution *x, const enclosure_job *job)
{
    const size_t n = 3 * job->control.nx * job->control.ny;
    enclosure_solution made;
    et_status status = ET_OK;

    memset(&made, 0, sizeof made);
    for (size_t w = 0; w < 2; w++) {
        made.x[w] = et_size_array(n, sizeof *made.x[w]);
        made.radius[w] = et_size_array(n, sizeof *made.radius[w]);
        if (made.x[w] == NULL || made.radius[w] == NULL)
            status = et_status_fail(job->message, ET_ENOMEM, "%s", et_status_text(ET_ENOMEM));
    }
    if (status == ET_OK)
        status = solve_approach(&made, job);
    if (status != ET_OK) {
        enclosure_solution_free(&made);
        return status;
    }
    *x = made;
    return ET_OK;
}
