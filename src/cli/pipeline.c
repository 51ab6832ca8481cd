/* pipeline: the steps of the main job, as the subcommands share them. */
#include "cli/cli.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/exact/exact.h"
#include "etalon/fit/seam.h"
#include "etalon/som/quality.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SEAM_SAMPLES = 16 };

/* ---- words ---------------------------------------------------------------------------------------------------------- */

const char *cli_algorithm_name(size_t k)
{
    static const char *const names[] = { "ga", "de", "pso", "ceres", "ceres-full", "optimum" };
    return k < CLI_ALGORITHMS ? names[k] : NULL;
}

const char *cli_approach_name(size_t k)
{
    return et_fit_name((et_fit_approach)k);
}

const char *cli_method_name(size_t k)
{
    return et_param_name((et_param_method)k);
}

const char *cli_knots_name(size_t k)
{
    return et_knotrule_name((et_knotrule_kind)k);
}

const char *cli_algebra_name(size_t k)
{
    return et_linalg_name((et_linalg_method)k);
}

const char *cli_corners_name(size_t k)
{
    static const char *const names[] = { "default", "free", "interpolated" };
    return k < 3 ? names[k] : NULL;
}

const char *cli_frame_name(size_t k)
{
    return et_frame_name((et_frame_kind)k);
}

/* ---- training ------------------------------------------------------------------------------------------------------- */

cli_train_options cli_train_defaults(void)
{
    const et_som_options som = et_som_defaults();
    const cli_train_options options = { { 20, 20 }, som.iterations, som.alpha0, som.sigma0, ET_FRAME_BOX };
    return options;
}

static et_status train(et_net_file *net, double *seconds, const et_vec3 *unit, size_t n, cli_run *run, et_message *message)
{
    const size_t nov = et_doublenet_nov(net->net);
    const et_task task = cli_task(run, "training");
    et_rng *rng = NULL;
    et_status status = et_rng_new(&rng, et_rng_stream(run->seed, 0));

    if (status == ET_OK) {
        const double began = cli_cpu();
        et_som_start(net->weights, nov, rng);
        status = et_som_train(net->weights, nov, &net->training, net->net, unit, n, &net->options, rng, &task);
        *seconds = cli_cpu() - began;
        cli_task_end(run);
    }
    et_rng_free(rng);
    if (status == ET_OK)
        status = run->exact ? et_exact_quality_of(&net->final, net->weights, nov, net->net, unit, n, NULL)
                            : et_quality_of(&net->final, net->weights, nov, net->net, unit, n);
    if (status == ET_ESTOPPED)
        return et_status_fail(message, status, "interrupted; nothing was written");
    if (status == ET_EINVAL)
        return et_status_fail(message, ET_EFORMAT, "%s: coordinates this large cannot be trained on; leave --normalise none out", run->input);
    return status == ET_OK ? status : et_status_fail(message, status, "training failed: %s", et_status_text(status));
}

et_status cli_train(et_net_file *net, double *seconds, const et_vec3 *cloud, size_t n, const cli_train_options *options, cli_run *run, et_message *message)
{
    const et_doublenet sides = { options->grid[0], options->grid[1] };
    et_net_file made;
    et_vec3 *unit;
    et_status status;

    memset(&made, 0, sizeof made);
    made.net = sides;
    made.seed = run->seed;
    made.options.iterations = options->iterations;
    made.options.alpha0 = options->alpha;
    made.options.sigma0 = options->radius;
    if (!et_doublenet_valid(sides))
        return et_status_fail(message, ET_EINVAL, "--grid %zux%zu: both sides must be at least 2%s", sides.nx, sides.ny,
                              sides.nx >= 2 && sides.ny >= 2 ? ", and not that large" : "");
    if (options->iterations == 0 || !(options->alpha > 0 && options->alpha <= 1) || !(options->radius >= 0))
        return et_status_fail(message, ET_EINVAL, "--iterations must be at least 1, --alpha in (0, 1], --radius not negative");
    status = et_frame_of(&made.frame, cloud, n, options->frame);
    if (status != ET_OK)
        return et_status_fail(message, status, "%s cannot be normalised: its points are all equal, or its extent overflows", run->input);
    unit = et_size_array(n, sizeof *unit);
    made.weights = et_size_array(et_doublenet_nov(sides), sizeof *made.weights);
    if (!unit || !made.weights) {
        status = et_status_fail(message, ET_ENOMEM, "not enough memory for %zu points and a %zux%zu net", n, sides.nx, sides.ny);
    } else {
        memcpy(unit, cloud, n * sizeof *unit);
        et_frame_to_unit(unit, n, &made.frame);
        status = train(&made, seconds, unit, n, run, message);
    }
    free(unit);
    if (status != ET_OK)
        et_json_free_net(&made);
    else
        *net = made;
    return status;
}

/* ---- fitting -------------------------------------------------------------------------------------------------------- */

/* |D_c - S(u_c, v_c)| at the data's own, refined, parameters; the bottom view's surface where both have a class. */
static et_status residual_at(double *residual, const et_surface_file *surface, const et_vec3 *data)
{
    const et_surface *view = surface->fit.shell.view;
    const et_doublenet net = surface->fit.data;
    const size_t nov = et_doublenet_nov(net), need = et_surface_work(&view[ET_BOTTOM]), top = et_surface_work(&view[ET_TOP]);
    const size_t nwork = need > top ? need : top;
    double *work = et_size_array(nwork, sizeof *work);

    if (!work)
        return ET_ENOMEM;
    for (size_t c = 1; c <= nov; c++) {
        const et_surface *s = &view[et_doublenet_index(net, c).k == 2 ? ET_TOP : ET_BOTTOM];
        residual[c - 1] = et_vec3_distance(data[c - 1], et_surface_point(s, surface->uv[2 * (c - 1)], surface->uv[2 * (c - 1) + 1], work, nwork));
    }
    free(work);
    return ET_OK;
}

et_status cli_residual(double *residual, et_fit_error *error, const et_surface_file *surface, const et_vec3 *data)
{
    const size_t nov = et_doublenet_nov(surface->fit.data);
    et_status status = et_fit_measure(error, residual, nov, &surface->fit, data);

    if (status != ET_OK || !surface->uv)
        return status;
    status = residual_at(residual, surface, data);
    if (status == ET_OK) {
        error->nov = error->non = et_real_sum(residual, nov);
        error->greatest = 0;
        for (size_t c = 1; c <= nov; c++) {
            error->greatest = fmax(error->greatest, residual[c - 1]);
            if (et_doublenet_index(surface->fit.data, c).k == 1)
                error->non += residual[c - 1];
        }
    }
    return status;
}

static et_status measure_fast(et_surface_file *surface, et_seam *seam, const et_vec3 *data)
{
    double *residual = et_size_array(et_doublenet_nov(surface->fit.data), sizeof *residual);
    et_status status = residual ? et_seam_gap(seam, &surface->fit.shell, SEAM_SAMPLES) : ET_ENOMEM;

    if (status == ET_OK)
        status = cli_residual(residual, &surface->error, surface, data);
    free(residual);
    return status;
}

static et_status measure_exactly(et_surface_file *surface, et_seam *seam, const et_vec3 *data)
{
    const et_status status = et_exact_seam_gap(seam, &surface->fit.shell, SEAM_SAMPLES);

    return status == ET_OK ? et_exact_fit_measure(&surface->error, NULL, et_doublenet_nov(surface->fit.data), &surface->fit, data, NULL) : status;
}

et_status cli_surface_measure(et_surface_file *surface, const et_vec3 *data, int exact)
{
    et_seam seam;
    const et_status status = (exact ? measure_exactly : measure_fast)(surface, &seam, data);

    if (status == ET_OK)
        surface->seam_gap = seam.distance;
    return status;
}

static void grow(et_vec3 *lo, et_vec3 *hi, const et_vec3 *points, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        lo->x = fmin(lo->x, points[k].x), hi->x = fmax(hi->x, points[k].x);
        lo->y = fmin(lo->y, points[k].y), hi->y = fmax(hi->y, points[k].y);
        lo->z = fmin(lo->z, points[k].z), hi->z = fmax(hi->z, points[k].z);
    }
}

double cli_overshoot(const et_surface_file *surface, const et_vec3 *data)
{
    et_vec3 lo = data[0], hi = data[0], out_lo, out_hi;
    double side, most;

    grow(&lo, &hi, data, et_doublenet_nov(surface->fit.data));
    out_lo = lo, out_hi = hi;
    for (size_t w = 0; w < 2; w++) {
        const et_surface *view = &surface->fit.shell.view[w];
        grow(&out_lo, &out_hi, view->points, view->nu * view->nv);
    }
    side = fmax(hi.x - lo.x, fmax(hi.y - lo.y, hi.z - lo.z));
    most = fmax(fmax(lo.x - out_lo.x, out_hi.x - hi.x), fmax(fmax(lo.y - out_lo.y, out_hi.y - hi.y), fmax(lo.z - out_lo.z, out_hi.z - hi.z)));
    return side > 0 ? most / side : 0;
}

void cli_warn_overshoot(const cli_run *run, double overshoot)
{
    if (overshoot > 1)
        cli_say(run, "warning: control points leave the box of the net by %.3g times its size: the surface swings out between the data;\n"
                     "take fewer control points, or --knots uniform or averaging (as many control points as data)", overshoot);
}

et_status cli_fit(et_surface_file *surface, const et_net_file *net, const et_fit_options *options, cli_run *run, et_message *message)
{
    const size_t nov = et_doublenet_nov(net->net);
    et_surface_file made;
    et_status status;

    memset(&made, 0, sizeof made);
    made.options = *options;
    made.frame = net->frame;
    if (run->exact) {
        const et_task task = cli_task(run, "exact fit");
        status = et_exact_fit_make(&made.fit, net->weights, nov, net->net, options, NULL, &task, message);
        cli_task_end(run);
    } else {
        status = et_fit_make(&made.fit, net->weights, nov, net->net, options, message);
    }
    if (status != ET_OK)
        return status;
    status = cli_surface_measure(&made, net->weights, run->exact);
    if (status != ET_OK) {
        et_json_free_surface(&made);
        return et_status_fail(message, status, "the fit cannot be measured: %s", et_status_text(status));
    }
    if (!isfinite(made.error.nov) || !isfinite(made.error.non) || !isfinite(made.seam_gap)) {
        et_json_free_surface(&made);
        return et_status_fail(message, ET_EFORMAT, "the squares of distances overflow: coordinates of this size want --exact%s",
                              run->exact ? ", and here even the errors are beyond all doubles" : ", or a cloud mapped to the unit cube");
    }
    *surface = made;
    return ET_OK;
}

static double *copied(const double *from, size_t n)
{
    double *to = from ? et_size_array(n, sizeof *to) : NULL;
    if (to)
        memcpy(to, from, n * sizeof *to);
    return to;
}

et_status cli_surface_copy(et_surface_file *copy, const et_surface_file *surface)
{
    const et_doublenet net = surface->fit.data;
    et_surface_file made = *surface;
    et_status status;
    int short_of_memory = 0;

    memset(&made.fit.shell, 0, sizeof made.fit.shell);
    for (size_t w = 0; w < 2; w++) {
        made.fit.s[w] = copied(surface->fit.s[w], net.nx);
        made.fit.r[w] = copied(surface->fit.r[w], net.ny);
        short_of_memory |= !made.fit.s[w] || !made.fit.r[w];
    }
    made.uv = copied(surface->uv, 2 * et_doublenet_nov(net));
    short_of_memory |= surface->uv && !made.uv;
    status = short_of_memory ? ET_ENOMEM : et_shell_copy(&made.fit.shell, &surface->fit.shell);
    if (status != ET_OK)
        et_json_free_surface(&made);
    else
        *copy = made;
    return status;
}
