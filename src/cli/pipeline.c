/* pipeline: the steps of the main job, as the subcommands share them. */
#include "cli/cli.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/fit/seam.h"
#include "etalon/refine/de.h"
#include "etalon/refine/ga.h"
#include "etalon/refine/objective.h"
#include "etalon/refine/pso.h"
#include "etalon/som/quality.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SEAM_SAMPLES = 16 };

/* ---- words ---------------------------------------------------------------------------------------------------------- */

const char *cli_algorithm_name(size_t k)
{
    static const char *const names[] = { "ga", "de", "pso", "ceres", "ceres-full" };
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
        status = et_quality_of(&net->final, net->weights, nov, net->net, unit, n);
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

et_status cli_surface_measure(et_surface_file *surface, const et_vec3 *data)
{
    double *residual = et_size_array(et_doublenet_nov(surface->fit.data), sizeof *residual);
    et_seam seam;
    et_status status = residual ? et_seam_gap(&seam, &surface->fit.shell, SEAM_SAMPLES) : ET_ENOMEM;

    if (status == ET_OK)
        status = cli_residual(residual, &surface->error, surface, data);
    if (status == ET_OK)
        surface->seam_gap = seam.distance;
    free(residual);
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

et_status cli_fit(et_surface_file *surface, const et_net_file *net, const et_fit_options *options, et_message *message)
{
    et_surface_file made;
    et_status status;

    memset(&made, 0, sizeof made);
    made.options = *options;
    made.frame = net->frame;
    status = et_fit_make(&made.fit, net->weights, et_doublenet_nov(net->net), net->net, options, message);
    if (status != ET_OK)
        return status;
    status = cli_surface_measure(&made, net->weights);
    if (status != ET_OK) {
        et_json_free_surface(&made);
        return et_status_fail(message, status, "the fit cannot be measured: %s", et_status_text(status));
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

/* ---- refining ------------------------------------------------------------------------------------------------------- */

cli_refine_options cli_refine_defaults(void)
{
    cli_refine_options options;

    memset(&options, 0, sizeof options);
    options.search = et_search_defaults();
    options.search.group = 3;
    options.search.box = 0;               /* the source's box is there by --box and --faithful */
    options.ceres = et_ceres_defaults();
    options.generations = 2000;
    return options;
}

void cli_refined_free(cli_refined *result)
{
    free(result->history);
    et_json_free_surface(&result->surface);
    memset(result, 0, sizeof *result);
}

/* What a search found, as control points; the start where that was better, unless the source's way is asked for. */
static void deliver(cli_refined *r, const et_search *search, const double *start, int faithful)
{
    const double *best = search->best;
    const size_t nov = search->n / 3;

    r->after = search->best_value;
    if (!faithful && !(r->after < r->before)) {
        best = start;
        r->after = r->before;
    }
    if (!faithful)
        for (size_t g = 0; g < r->steps; g++)
            if (!(r->history[g] < r->before))
                r->history[g] = r->before;
    et_shell_scatter(&r->surface.fit.shell, (const et_vec3 *)(const void *)best, nov);
    r->evaluations = search->evaluations;
}

static et_status searched(cli_refined *r, et_objective *objective, const double *start, size_t n, const cli_refine_options *o, et_rng *rng,
                          uint64_t seed, const et_task *task, et_message *message)
{
    static const et_search_step steps[] = { et_ga_step, et_de_step, et_pso_step };
    et_search search;
    size_t made = 0, before = 0;
    et_status status = et_search_start(&search, start, n, &o->search, r->algorithm == CLI_PSO, et_objective_eval, objective, rng);

    if (status != ET_OK)
        return et_status_fail(message, status, "%s cannot start with these settings: %s", cli_algorithm_name(r->algorithm), et_status_text(status));
    if (o->resume) {
        status = cli_checkpoint_read(&search, rng, &r->history, r->algorithm, seed, o->generations, o->resume, message);
        before = search.generation;
    }
    if (status == ET_OK) {
        status = et_search_run(&search, &made, r->history + before, o->generations, steps[r->algorithm], rng, task);
        r->steps = before + made;
        if (status == ET_OK || status == ET_ESTOPPED) {
            const et_status saved = o->checkpoint
                ? cli_checkpoint_write(o->checkpoint, &search, rng, r->algorithm, seed, r->history, message) : ET_OK;
            deliver(r, &search, start, o->faithful);
            r->stopped = status == ET_ESTOPPED;
            status = saved != ET_OK ? saved : status;
        }
    }
    et_search_free(&search);
    return status;
}

static et_status by_search(cli_refined *r, const et_vec3 *data, const cli_refine_options *o, uint64_t seed, uint64_t round, const et_task *task,
                           et_message *message)
{
    const size_t nov = et_doublenet_nov(r->surface.fit.data);
    et_objective *objective = NULL;
    et_rng *rng = NULL;
    double *start = NULL;
    size_t n;
    const uint64_t stream = et_rng_stream(et_rng_stream(seed, 1 + (uint64_t)r->algorithm), round);
    et_status status = et_objective_new(&objective, &r->surface.fit, data, nov);

    if (status != ET_OK)
        return et_status_fail(message, status, "this surface cannot be refined: it must be polynomial and closed");
    n = et_objective_size(objective);
    r->history = et_size_array(o->generations, sizeof *r->history);
    start = et_size_array(n, sizeof *start);
    status = r->history && start ? et_rng_new(&rng, stream) : ET_ENOMEM;
    if (status == ET_OK) {
        et_shell_gather((et_vec3 *)(void *)start, n / 3, &r->surface.fit.shell);
        status = et_objective_eval(&r->before, start, n, objective);
    }
    if (status == ET_OK)
        status = searched(r, objective, start, n, o, rng, seed, task, message);
    free(start);
    et_rng_free(rng);
    et_objective_free(objective);
    return status;
}

static et_status by_ceres(cli_refined *r, const et_vec3 *data, const cli_refine_options *o, const et_task *task, et_message *message)
{
    const size_t nov = et_doublenet_nov(r->surface.fit.data), room = o->ceres.iterations + 1;
    et_ceres_summary summary;
    et_status status;

    memset(&summary, 0, sizeof summary);
    r->history = et_size_array(room, sizeof *r->history);
    if (!r->history)
        return ET_ENOMEM;
    if (r->algorithm == CLI_CERES_FULL) {
        if (!r->surface.uv)
            r->surface.uv = et_size_array(2 * nov, sizeof *r->surface.uv);
        if (!r->surface.uv)
            return ET_ENOMEM;
        status = et_ceres_full(&r->surface.fit, r->surface.uv, &summary, r->history, room, data, nov, &o->ceres, task, message);
    } else {
        status = et_ceres_points(&r->surface.fit, &summary, r->history, room, data, nov, &o->ceres, task, message);
    }
    r->before = summary.before;
    r->after = summary.after;
    r->evaluations = summary.evaluations;
    r->steps = summary.made;
    r->stopped = status == ET_ESTOPPED;
    return status;
}

et_status cli_refine(cli_refined *result, const et_surface_file *surface, const et_vec3 *data, cli_algorithm algorithm,
                     const cli_refine_options *options, uint64_t seed, uint64_t round, const et_task *task, et_message *message)
{
    cli_refined made;
    et_status status, measured;
    const double began = cli_cpu();

    memset(&made, 0, sizeof made);
    made.algorithm = algorithm;
    if (message)
        message->text[0] = '\0';
    status = cli_surface_copy(&made.surface, surface);
    if (status == ET_OK)
        status = algorithm <= CLI_PSO ? by_search(&made, data, options, seed, round, task, message) : by_ceres(&made, data, options, task, message);
    made.seconds = cli_cpu() - began;
    measured = status == ET_OK || status == ET_ESTOPPED ? cli_surface_measure(&made.surface, data) : status;
    if (measured != ET_OK) {
        cli_refined_free(&made);
        if (message && !message->text[0])
            et_status_fail(message, measured, "%s failed: %s", cli_algorithm_name(algorithm), et_status_text(measured));
        return measured;
    }
    *result = made;
    return status;
}
