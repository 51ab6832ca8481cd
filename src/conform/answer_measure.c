/* answer_measure: what the fast functions answer of distances: the error of a surface, the gap of a seam; of valid requests.
 *
 * Distances are taken in a unit in which squares neither overflow nor underflow.  The unit is that of the control points which have a share in what
 * is measured: another one, however large, must not make the others vanish. */
#include "conform/answer_parts.h"
#include "conform/judge_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/fit/seam.h"
#include "etalon/spline/basis.h"
#include <math.h>
#include <stdlib.h>

/* 2^-e, with the greatest magnitude below 2^e: in that unit squares neither overflow nor, where they matter, underflow; 1 in the range where they do
 * not anyway. */
static double unit_of(double most)
{
    int e;

    frexp(most, &e);
    return most == 0 || (e < 500 && e > -400) ? 1 : ldexp(1, e < -1000 ? 1000 : -e);
}

static double greatest(const double *x, size_t n)
{
    double most = 0;

    for (size_t i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

/* share[i] becomes 1 where the i-th of n basis functions is not 0 at one of the nt parameters. */
static et_status mark(char *share, const double *u, size_t n, size_t p, const double *t, size_t nt)
{
    const size_t nwork = et_basis_work(p, 0);
    double *N = et_size_array(p + 1, sizeof *N), *work = et_size_array(nwork, sizeof *work);
    const et_status status = N && work ? ET_OK : ET_ENOMEM;

    for (size_t k = 0; status == ET_OK && k < nt; k++) {
        const size_t span = et_knots_span(u, n + p + 1, p, t[k]);
        et_basis_eval(N, u, n + p + 1, p, span, t[k], work, nwork);
        for (size_t i = 0; i <= p; i++)
            share[span - p + i] |= N[i] != 0;
    }
    free(N);
    free(work);
    return status;
}

/* Whether the i-th basis function is not 0 on all of the domain. */
static int lives(const double *u, size_t n, size_t p, size_t i)
{
    return u[i] < u[i + p + 1] && u[i] < u[n] && u[i + p + 1] > u[p];
}

/* A copy in which control points without a share are 0: those with it stand in marked rows and columns, or, at a border, in one of them and anywhere
 * along it. */
static et_status shared(et_surface *copy, const et_surface *s, const double *x, size_t nx, const double *y, size_t ny, int border)
{
    char *row = et_size_array(s->nu, sizeof *row), *column = et_size_array(s->nv, sizeof *column);
    et_status status = row && column ? mark(row, s->u, s->nu, s->p, x, nx) : ET_ENOMEM;

    if (status == ET_OK)
        status = mark(column, s->v, s->nv, s->q, y, ny);
    if (status == ET_OK)
        status = et_surface_copy(copy, s);
    for (size_t i = 0; status == ET_OK && i < s->nu; i++)
        for (size_t j = 0; j < s->nv; j++) {
            const int along = border && ((row[i] && lives(s->v, s->nv, s->q, j)) || (column[j] && lives(s->u, s->nu, s->p, i)));
            if (!along && !(row[i] && column[j]))
                copy->points[i * s->nv + j] = (et_vec3){ 0, 0, 0 };
        }
    free(row);
    free(column);
    return status;
}

static double most_of(const et_surface *s)
{
    return greatest(&s->points->x, 3 * s->nu * s->nv);
}

static void scale(et_surface *s, double unit)
{
    for (size_t i = 0; i < s->nu * s->nv; i++)
        s->points[i] = (et_vec3){ unit * s->points[i].x, unit * s->points[i].y, unit * s->points[i].z };
}

static et_status distances(double *d, const et_surface *s, const et_request_value *a, double unit)
{
    et_vec3 *S = et_size_array(a[8].count, sizeof *S);
    const et_status status = S ? et_surface_grid(S, s, a[6].x, a[6].count, a[7].x, a[7].count) : ET_ENOMEM;

    for (size_t k = 0; status == ET_OK && k < a[8].count; k++) {
        const double *D = a[8].x + 3 * k;
        d[k] = et_vec3_distance(S[k], (et_vec3){ unit * D[0], unit * D[1], unit * D[2] });
    }
    free(S);
    return status;
}

static et_status surface_error(et_reply *reply, const et_request *request)
{
    const et_request_value *a = request->arg;
    const size_t n = a[8].count;
    const et_surface s = judge_surface_of(request, 0);
    double *d = et_size_array(n, sizeof *d);
    et_surface t;
    et_status status = d ? shared(&t, &s, a[6].x, a[6].count, a[7].x, a[7].count, 0) : ET_ENOMEM;

    if (status == ET_OK) {
        const double unit = unit_of(fmax(most_of(&t), greatest(a[8].x, 3 * n)));
        scale(&t, unit);
        status = distances(d, &t, a, unit);
        et_surface_free(&t);
        const double answer[2] = { et_real_sum(d, n) / unit, greatest(d, n) / unit };
        if (status == ET_OK)
            status = et_reply_put(reply, answer, 2);
    }
    free(d);
    return status;
}

/* Both surfaces as far as they have a share in the border. */
static et_status shared_border(et_shell *shell, const et_request *request)
{
    static const double ends[2] = { 0, 1 };
    const et_surface s = judge_surface_of(request, 0), t = judge_surface_of(request, 6);
    et_status status = shared(&shell->view[0], &s, ends, 2, ends, 2, 1);

    if (status == ET_OK) {
        status = shared(&shell->view[1], &t, ends, 2, ends, 2, 1);
        if (status != ET_OK)
            et_surface_free(&shell->view[0]);
    }
    return status;
}

static et_status seam_gap(et_reply *reply, const et_request *request)
{
    et_shell shell;
    et_seam gap;
    et_status status = shared_border(&shell, request);

    if (status == ET_OK) {
        const double unit = unit_of(fmax(most_of(&shell.view[0]), most_of(&shell.view[1])));
        scale(&shell.view[0], unit);
        scale(&shell.view[1], unit);
        status = et_seam_gap(&gap, &shell, request->arg[12].count);
        et_shell_free(&shell);
        if (status == ET_OK) {
            gap.distance /= unit;
            status = et_reply_put(reply, &gap.distance, 1);
        }
    }
    return status;
}

et_status answer_measure(et_reply *reply, const et_request *request)
{
    return request->op == ET_OP_SURFACE_ERROR ? surface_error(reply, request) : seam_gap(reply, request);
}
