#include "etalon/refine/optimum.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/refine/objective.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 4 };

et_optimum_options et_optimum_defaults(void)
{
    return (et_optimum_options){100, 1e-12};
}

/* ---- what is accepted ---- */

static int ascending(const double *t, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(t[i]) || (i > 0 && t[i] < t[i - 1]))
            return 0;
    return 1;
}

/* As et_objective_new, and finite. */
static et_status check(const et_fit *fit, const et_vec3 *data, size_t nov, et_message *message)
{
    et_objective *objective = NULL;
    et_status status = ET_EINVAL;

    if (fit == NULL || data == NULL)
        return et_status_fail(message, ET_EINVAL, "optimum: a null pointer");
    if (!fit->s[0] || !fit->s[1] || !fit->r[0] || !fit->r[1] || !et_shell_glued(&fit->shell))
        return et_status_fail(message, ET_EINVAL, "optimum: the shell is not glued along its border, or there are no parameters");
    if (et_doublenet_valid(fit->data) && nov == et_doublenet_nov(fit->data))
        status = et_vec3_finite(data, nov) ? et_objective_new(&objective, fit, data, nov) : ET_EFORMAT;
    et_objective_free(objective);
    if (status == ET_OK && !(ascending(fit->s[0], fit->data.nx) && ascending(fit->r[0], fit->data.ny)))
        status = ET_EINVAL;
    if (status == ET_EFORMAT)
        return et_status_fail(message, ET_EINVAL, "optimum: the data are not finite");
    return status == ET_OK ? status
                           : et_status_fail(message, status, "optimum: %s",
                                            status == ET_EINVAL ? "no closed polynomial fit of these data with equal parameters in both views"
                                                                : et_status_text(status));
}

/* ---- finding ---- */

typedef struct {
    et_fit *fit;
    const et_vec3 *data;
    size_t nov;
    optimum_model model;
    optimum_search search;
    et_vec3 *came, *start, *found;        /* control classes: as the fit came, at the start of a round, at its end */
    double *y, *step;                     /* a second dual; control points' steps */
    et_optimum_result result;
    int proved;
} job;

static et_status acquire(job *k)
{
    const size_t n = et_doublenet_nov(et_shell_net(&k->fit->shell));
    et_status status = optimum_model_new(&k->model, k->fit);

    if (status != ET_OK)
        return status;
    k->came = et_size_array(n, sizeof *k->came);
    k->start = et_size_array(n, sizeof *k->start);
    k->found = et_size_array(n, sizeof *k->found);
    k->y = et_size_array(k->nov, 3 * sizeof(double));
    k->step = et_size_array(k->model.m, 3 * sizeof(double));
    k->search.D = et_size_array(k->nov, 3 * sizeof(double));
    k->search.y = et_size_array(k->nov, 3 * sizeof(double));
    k->search.x = et_size_array(k->model.m, 3 * sizeof(double));
    k->search.weight = et_size_array(k->nov, 6 * sizeof(double));
    if (k->came)
        et_shell_gather(k->came, n, &k->fit->shell);
    return k->came && k->start && k->found && k->y && k->step && k->search.D && k->search.y && k->search.x && k->search.weight ? ET_OK : ET_ENOMEM;
}

static void release(job *k)
{
    optimum_model_free(&k->model);
    free(k->came);
    free(k->start);
    free(k->found);
    free(k->y);
    free(k->step);
    free(k->search.D);
    free(k->search.y);
    free(k->search.x);
    free(k->search.weight);
}

/* The start's residuals, in lengths such that the greatest coordinate is about one; y = r / |r|. */
static void normalise(job *k)
{
    double most = 0;
    int shift = 0;

    for (size_t c = 0; c < 3 * k->nov; c++)
        most = fmax(most, fabs(k->search.D[c]));
    frexp(most, &shift);
    k->search.unit = ldexp(1, shift > 1023 ? 1023 : shift < -1021 ? -1021 : shift);
    for (size_t c = 0; c < k->nov; c++) {
        double *const r = k->search.D + 3 * c, length;

        for (size_t d = 0; d < 3; d++)
            r[d] /= k->search.unit;
        length = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
        for (size_t d = 0; d < 3; d++)
            k->search.y[3 * c + d] = length > 0 ? r[d] / length : 0;
    }
}

/* Start and step; a control point that would leave the range of doubles stays. */
static void move_points(job *k)
{
    const et_doublenet net = k->model.control;
    const et_shell *const shell = &k->fit->shell;

    et_shell_gather(k->start, et_doublenet_nov(net), shell);
    optimum_model_points(k->step, &k->model, k->search.x);
    for (size_t c = 0; c < et_doublenet_nov(net); c++) {
        const et_index at = et_doublenet_index(net, c + 1);
        const size_t place = optimum_model_place(&k->model, at.k == 2, at.i, at.j);
        const double *const x = k->step + 3 * (place == SIZE_MAX ? 0 : place);
        const int shift = k->model.u.shift[at.i] + k->model.v.shift[at.j];
        et_vec3 p = k->start[c];

        if (place != SIZE_MAX) {
            p.x += ldexp(x[0], shift) * k->search.unit;
            p.y += ldexp(x[1], shift) * k->search.unit;
            p.z += ldexp(x[2], shift) * k->search.unit;
        }
        k->found[c] = et_vec3_finite(&p, 1) ? p : k->start[c];
    }
}

/* The better of the points so far and those found, by what is proved of them. */
static void deliver_points(job *k)
{
    const size_t n = et_doublenet_nov(k->model.control);
    double found = 0;

    move_points(k);
    et_shell_scatter(&k->fit->shell, k->found, n);
    optimum_ball_value(&found, NULL, k->fit, &k->model, k->data);
    if (found <= k->result.value)
        k->result.value = found;
    else
        et_shell_scatter(&k->fit->shell, k->start, n);
}

/* The better of the dual found and the same polished. */
static et_status deliver_dual(job *k)
{
    double polished = 0;
    et_status status = optimum_ball_bound(&k->result.lower, &k->proved, k->search.y, &k->model, k->data);

    memcpy(k->y, k->search.y, 3 * k->nov * sizeof *k->y);
    if (status == ET_OK)
        status = optimum_ball_polish(k->y, &k->model, k->search.weight);
    if (status == ET_OK)
        status = optimum_ball_bound(&polished, &k->proved, k->y, &k->model, k->data);
    if (status == ET_OK && polished > k->result.lower) {
        k->result.lower = polished;
        memcpy(k->search.y, k->y, 3 * k->nov * sizeof *k->y);
    }
    return status;
}

/* From the points so far.  1 if so little of E is left that it is rounding of the residuals begun with: then another round sees more of it. */
static int improve(job *k, et_status *status)
{
    const double before = k->result.value;
    double again = 0;

    optimum_ball_value(&again, k->search.D, k->fit, &k->model, k->data);
    normalise(k);
    memset(k->search.x, 0, 3 * k->model.m * sizeof *k->search.x);
    *status = optimum_cone_run(&k->search);
    if (*status == ET_OK)
        deliver_points(k);
    return *status == ET_OK && k->search.status == ET_OK && k->search.iterations < k->search.limit && k->result.value < before * 0x1p-16;
}

static et_status run(job *k)
{
    et_status status = ET_OK;

    optimum_ball_value(&k->result.before, NULL, k->fit, &k->model, k->data);
    if (!isfinite(k->result.before))
        return ET_EINVAL;
    k->result.value = k->result.before;
    k->search.model = &k->model;
    for (size_t round = 0; round < ROUNDS && improve(k, &status); round++)
        continue;
    if (status == ET_OK)
        status = deliver_dual(k);
    if (status != ET_OK)
        return status;
    k->result.iterations = k->search.iterations;
    k->result.gap = k->result.value - k->result.lower;
    if (k->result.gap > 0)                /* at most half an ulp too small */
        k->result.gap += k->result.gap * ET_EPS + 0x1p-1074;
    return ET_OK;
}

et_status et_optimum_find(et_fit *fit, et_optimum_result *result, et_vec3 *dual, double *history, size_t room, const et_vec3 *data, size_t nov,
                          const et_optimum_options *options, const et_task *task, et_message *message)
{
    const et_optimum_options o = options ? *options : et_optimum_defaults();
    job k;
    et_status status = result ? check(fit, data, nov, message) : et_status_fail(message, ET_EINVAL, "optimum: a null pointer");

    if (status != ET_OK)
        return status;
    if (!(o.gap >= 0))
        return et_status_fail(message, ET_EINVAL, "optimum: a gap of %g is none", o.gap);
    memset(&k, 0, sizeof k);
    k.fit = fit;
    k.data = data;
    k.nov = nov;
    k.search.task = task;
    k.search.history = history;
    k.search.room = history ? room : 0;
    k.search.limit = o.iterations;
    k.search.tolerance = o.gap;
    status = acquire(&k);
    if (status == ET_OK) {
        status = run(&k);
        if (status != ET_OK)
            et_shell_scatter(&fit->shell, k.came, et_doublenet_nov(k.model.control));
    }
    if (status == ET_OK) {
        *result = k.result;
        for (size_t c = 0; dual != NULL && c < nov; c++)
            dual[c] = (et_vec3){k.search.y[3 * c], k.search.y[3 * c + 1], k.search.y[3 * c + 2]};
        if (!k.proved)
            et_status_fail(message, ET_OK, "no lower bound but 0 is proved: the control points are not determined by the data");
    }
    release(&k);
    if (status != ET_OK)
        return et_status_fail(message, status, "optimum: %s", status == ET_EINVAL ? "E overflows" : et_status_text(status));
    return k.search.status;
}

et_status et_optimum_bound(double *lower, const et_vec3 *dual, size_t nov, const et_fit *fit, const et_vec3 *data)
{
    optimum_model model;
    double bound = 0;
    double *y;
    int proved;
    et_status status = lower && dual ? check(fit, data, nov, NULL) : ET_EINVAL;

    if (status != ET_OK)
        return status;
    status = optimum_model_new(&model, fit);
    y = et_size_array(nov, 3 * sizeof *y);
    if (y == NULL)
        status = ET_ENOMEM;
    for (size_t c = 0; status == ET_OK && c < nov; c++) {
        y[3 * c] = dual[c].x;
        y[3 * c + 1] = dual[c].y;
        y[3 * c + 2] = dual[c].z;
    }
    if (status == ET_OK)
        status = optimum_ball_bound(&bound, &proved, y, &model, data);
    free(y);
    optimum_model_free(&model);
    if (status == ET_OK)
        *lower = bound;
    return status;
}
