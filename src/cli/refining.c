/* refining: a closed surface's control points are moved by one of the refiners. */
#include "cli/cli.h"
#include "etalon/base/size.h"
#include "etalon/refine/de.h"
#include "etalon/refine/ga.h"
#include "etalon/refine/objective.h"
#include "etalon/refine/pso.h"
#include <stdlib.h>
#include <string.h>

cli_refine_options cli_refine_defaults(void)
{
    cli_refine_options options;

    memset(&options, 0, sizeof options);
    options.search = et_search_defaults();
    options.search.group = 3;
    options.search.box = 0;               /* the source's box is there by --box and --faithful */
    options.ceres = et_ceres_defaults();
    options.optimum = et_optimum_defaults();
    options.generations = 2000;
    return options;
}

void cli_refined_free(cli_refined *result)
{
    free(result->history);
    free(result->dual);
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

/* The certificate's interval is rounded outwards: its upper end is what the surface is said to have. */
static et_status by_optimum(cli_refined *r, const et_vec3 *data, const cli_refine_options *o, const et_task *task, et_message *message)
{
    const size_t nov = et_doublenet_nov(r->surface.fit.data), room = o->optimum.iterations;
    et_status status;

    r->history = et_size_array(room, sizeof *r->history);
    r->dual = et_size_array(nov, sizeof *r->dual);
    if (!r->history || !r->dual)
        return ET_ENOMEM;
    status = et_optimum_find(&r->surface.fit, &r->optimum, r->dual, r->history, room, data, nov, &o->optimum, task, message);
    r->before = r->optimum.before;
    r->after = r->optimum.value;
    r->evaluations = r->steps = r->optimum.iterations;
    r->stopped = status == ET_ESTOPPED;
    return status;
}

static et_status refined_by(cli_refined *r, const et_vec3 *data, const cli_refine_options *o, uint64_t seed, uint64_t round, const et_task *task,
                            et_message *message)
{
    if (r->algorithm <= CLI_PSO)
        return by_search(r, data, o, seed, round, task, message);
    return (r->algorithm == CLI_OPTIMUM ? by_optimum : by_ceres)(r, data, o, task, message);
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
        status = refined_by(&made, data, options, seed, round, task, message);
    made.seconds = cli_cpu() - began;
    measured = status == ET_OK || status == ET_ESTOPPED ? cli_surface_measure(&made.surface, data, options->exact) : status;
    if (measured != ET_OK) {
        cli_refined_free(&made);
        if (message && !message->text[0])
            et_status_fail(message, measured, "%s failed: %s", cli_algorithm_name(algorithm), et_status_text(measured));
        return measured;
    }
    *result = made;
    return status;
}
