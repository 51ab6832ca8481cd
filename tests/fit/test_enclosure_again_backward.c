/* The second computation of an enclosure: the backward error, matrices written out and conjugate gradients as they stand in the books. */
#include "fit/enclosure_again.h"
#include "fit/fit_parts.h"
#include <string.h>

/* A problem of one view or of two: the matrix whole, border data and border control points of the second view being the first's. */
typedef struct {
    const enclosure_job *k;
    size_t first, views, nodes, points;
    double U[2][SIDE][SIDE], V[2][SIDE][SIDE];
    bool unknown[2 * NODES], counted[2 * NODES];
} backward;

static bool tabulate(double N[SIDE][SIDE], const double *t, size_t m, const double *u, size_t n, size_t p)
{
    fit_collocation c;

    memset(N, 0, sizeof(double[SIDE][SIDE]));
    if (fit_collocate(&c, t, m, u, n, p) != ET_OK)
        return false;
    for (size_t i = 0; i < m; i++)
        for (size_t e = 0; e <= p; e++)
            N[i][c.start[i] + e] = c.a[i * (p + 1) + e];
    fit_collocation_free(&c);
    return true;
}

static bool backward_start(backward *b, const enclosure_job *k, size_t first, size_t views)
{
    const et_surface *s = &k->fit->shell.view[first];
    const et_doublenet n = k->data, f = k->control;

    *b = (backward){ .k = k, .first = first, .views = views, .nodes = n.nx * n.ny, .points = f.nx * f.ny };
    for (size_t at = 0; at < 2 * b->points; at++) {
        const size_t i = at % b->points / f.ny, j = at % b->points % f.ny;
        b->unknown[at] = !(k->fixed && again_at_corner(f, i, j)) && !(at >= b->points && again_on_border(f, i, j));
    }
    for (size_t at = 0; at < 2 * b->nodes; at++)
        b->counted[at] = at < b->nodes || !again_on_border(n, at % b->nodes / n.ny, at % b->nodes % n.ny);
    return tabulate(b->U[0], k->fit->s[first], n.nx, s->u, s->nu, s->p) && tabulate(b->V[0], k->fit->r[first], n.ny, s->v, s->nv, s->q);
}

/* y = A x, x with all its control points. */
static void forward(double *y, const backward *b, const double *x)
{
    const et_doublenet n = b->k->data, f = b->k->control;

    for (size_t at = 0; at < b->views * b->nodes; at++) {
        const size_t w = at / b->nodes, i = at % b->nodes / n.ny, j = at % b->nodes % n.ny;
        double sum = 0;
        for (size_t l = 0; l < b->points; l++)
            if (b->U[0][i][l / f.ny] != 0 && b->V[0][j][l % f.ny] != 0)
                sum += b->U[0][i][l / f.ny] * b->V[0][j][l % f.ny] * x[w * b->points + l];
        y[at] = b->counted[at] ? sum : 0;
    }
}

/* q = A'A x over the unknowns. */
static void normal(double *q, const backward *b, const double *x)
{
    const et_doublenet n = b->k->data, f = b->k->control;
    double y[2 * NODES], whole_x[2 * NODES] = { 0 };

    for (size_t l = 0; l < b->views * b->points; l++)
        whole_x[l] = l >= b->points && again_on_border(f, l % b->points / f.ny, l % b->points % f.ny) ? x[l - b->points] : x[l];
    forward(y, b, whole_x);
    for (size_t l = 0; l < b->views * b->points; l++) {
        const size_t w = l / b->points, c = l % b->points / f.ny, d = l % b->points % f.ny;
        q[l] = 0;
        for (size_t at = 0; at < b->nodes; at++)
            if (b->U[0][at / n.ny][c] != 0 && b->V[0][at % n.ny][d] != 0)
                q[l] += b->U[0][at / n.ny][c] * b->V[0][at % n.ny][d] * y[w * b->nodes + at];
    }
    for (size_t l = b->points; l < b->views * b->points; l++)
        if (again_on_border(f, l % b->points / f.ny, l % b->points % f.ny))
            q[l - b->points] += q[l];
    for (size_t l = 0; l < b->views * b->points; l++)
        q[l] = b->unknown[l] ? q[l] : 0;
}

static double sum_of_squares(const double *x, size_t n)
{
    double sum = 0;

    for (size_t i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sum;
}

/* g'(A'A + shift I)^-1 g by conjugate gradients. */
static double conjugate(const backward *b, double *g, double shift)
{
    const size_t n = b->views * b->points;
    double p[2 * NODES], q[2 * NODES], value = 0, before = sum_of_squares(g, n), first = before;

    memcpy(p, g, n * sizeof *p);
    for (int step = 1; step <= 40 && before > first * 0x1p-60; step++) {
        double curvature = 0, after;
        normal(q, b, p);
        for (size_t i = 0; i < n; i++) {
            q[i] += shift * p[i];
            curvature += p[i] * q[i];
        }
        if (!(curvature > 0))
            return value;
        value += before / curvature * before;
        for (size_t i = 0; i < n; i++)
            g[i] -= before / curvature * q[i];
        after = sum_of_squares(g, n);
        for (size_t i = 0; i < n; i++)
            p[i] = g[i] + after / before * p[i];
        before = after;
    }
    return value;
}

static double one_backward(const backward *b, const again_answer *x, size_t c)
{
    const enclosure_job *k = b->k;
    double P[2 * NODES], e[2 * NODES], y[2 * NODES], g[2 * NODES], solution = 0, residual = 0, gradient;

    for (size_t l = 0; l < b->views * b->points; l++) {
        const size_t w = b->first + l / b->points, at = l % b->points;
        P[l] = ldexp((&k->fit->shell.view[w].points[at].x)[c], -k->exponent[c]);
        e[l] = b->unknown[l] ? et_dd_sub(whole(P[l]), x->x[w][3 * at + c]).hi : 0;
        solution += b->unknown[l] ? P[l] * P[l] : 0;
    }
    forward(y, b, P);
    for (size_t w = 0; w < b->views; w++) {
        for (size_t at = 0; at < b->nodes; at++)
            y[w * b->nodes + at] = b->counted[w * b->nodes + at] ? k->D[b->first + w][3 * at + c] - y[w * b->nodes + at] : 0;
        residual += sum_of_squares(y + w * b->nodes, b->nodes);
    }
    normal(g, b, e);
    gradient = sum_of_squares(g, b->views * b->points);
    if (gradient == 0)
        return 0;
    if (!(solution < 0x1p1000) || !(residual < 0x1p1000) || !(gradient < 0x1p1000))
        return HUGE_VAL;
    if (solution > residual * 0x1p-900)
        return sqrt(conjugate(b, g, residual / solution) / solution) / x->norm / 0x1p-52;
    return sqrt(gradient / residual) / x->norm / 0x1p-52;
}

double again_backward(const enclosure_job *k, const again_answer *x)
{
    const size_t views = k->options->approach == ET_FIT_JOINT ? 2 : 1;
    double most = 0;
    backward b;

    for (size_t first = 0; first < 2; first += views)
        for (size_t c = 0; c < 3 && backward_start(&b, k, first, views); c++)
            most = fmax(most, one_backward(&b, x, c));
    return most;
}
