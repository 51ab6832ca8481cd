/* compare: least squares (conventional, improved, joint) against the refiners, over control nets and parameterisations.
 *
 * The work is a list of jobs numbered by the settings alone.  Finished jobs can be kept in a journal and are not done again; threads take
 * jobs in any order, the table does not depend on it.
 */
#include "cli/compare.h"
#include "etalon/base/size.h"
#include "etalon/io/cloud.h"
#include <stdlib.h>
#include <string.h>

enum { OWN = 11, TABLE = OWN + CLI_TRAIN_OPTIONS + CLI_REFINE_OPTIONS + CLI_COMMON };

/* ---- the cases: least squares ------------------------------------------------------------------------------------------ */

static et_status fit_case(compare_case *c, const compare_options *o, const et_net_file *net, cli_run *run, et_message *message)
{
    for (size_t a = 0; a < 3; a++) {
        et_fit_options options = cli_fit_chosen(&o->fit);
        options.approach = (et_fit_approach)a;
        options.method = (et_param_method)c->method;
        options.knots = c->faithful ? ET_KNOTRULE_FAITHFUL : options.knots;
        options.control.nx = c->control[0];
        options.control.ny = c->control[1];
        const double began = cli_cpu();
        const et_status status = cli_fit(&c->fit[a], net, &options, run, message);
        if (status != ET_OK)
            return status;
        c->seconds[a] = cli_cpu() - began;
    }
    return ET_OK;
}

/* Default readings first; with --faithful each case once more in the source's way. */
static et_status make_cases(comparison *t, const et_net_file *net, cli_run *run, et_message *message)
{
    const compare_options *o = t->options;
    const size_t modes = o->refiner.faithful ? 2 : 1;

    t->cases = et_size_array(modes * o->ncontrols * o->nmethods, sizeof *t->cases);
    if (!t->cases)
        return et_status_fail(message, ET_ENOMEM, "not enough memory");
    for (size_t mode = 0; mode < modes; mode++)
        for (size_t h = 0; h < o->ncontrols; h++)
            for (size_t m = 0; m < o->nmethods; m++) {
                compare_case *c = &t->cases[t->ncases++];
                c->faithful = mode == 1;
                memcpy(c->control, o->controls[h], sizeof c->control);
                c->method = o->methods[m];
                const et_status status = fit_case(c, o, net, run, message);
                if (status != ET_OK)
                    return status;
            }
    return ET_OK;
}

/* ---- the jobs: refiners ------------------------------------------------------------------------------------------------ */

/* Case by case, algorithm by algorithm, run by run; Ceres draws nothing at random and runs once. */
static et_status make_jobs(comparison *t, et_message *message)
{
    const compare_options *o = t->options;
    size_t n = 0;

    for (size_t a = 0; a < o->nalgorithms; a++)
        n += o->algorithms[a] <= CLI_PSO ? o->runs : 1;
    if (et_size_mul(&n, n, t->ncases) != ET_OK || !(t->jobs = et_size_array(n, sizeof *t->jobs)))
        return et_status_fail(message, ET_ENOMEM, "not enough memory");
    for (size_t c = 0; c < t->ncases; c++)
        for (size_t a = 0; a < o->nalgorithms; a++)
            for (size_t r = 0; r < (o->algorithms[a] <= CLI_PSO ? o->runs : 1); r++) {
                const compare_job job = { c, o->algorithms[a], r, 0, 0, 0, 0, 0, 0, 0, 0, 0 };
                t->jobs[t->njobs++] = job;
            }
    return ET_OK;
}

static et_status do_job(compare_job *job, const comparison *t, const et_net_file *net, const et_task *task, uint64_t seed, et_message *message)
{
    const compare_case *c = &t->cases[job->which];
    cli_refine_options options = t->options->refiner;
    cli_refined refined;

    options.faithful = c->faithful;
    if (!c->faithful)
        options.search.box = t->options->box;
    const et_status status = cli_refine(&refined, &c->fit[t->options->start], net->weights, (cli_algorithm)job->algorithm, &options, seed, job->run, task,
                                        message);
    if (status == ET_OK) {
        job->before = refined.before;
        job->after = refined.after;
        job->lower = refined.optimum.lower;
        job->gap = refined.surface.seam_gap;
        job->evaluations = refined.evaluations;
        job->steps = refined.steps;
        job->seconds = refined.seconds;
        job->done = 1;
    }
    if (status == ET_OK || status == ET_ESTOPPED)
        cli_refined_free(&refined);
    return status;
}

/* Only interruption: the progress line counts jobs, not steps within them. */
static et_status stop_only(void *context, size_t done, size_t total)
{
    (void)context, (void)done, (void)total;
    return cli_stopped() ? ET_ESTOPPED : ET_OK;
}

static et_status do_jobs(comparison *t, const et_net_file *net, cli_run *run, et_message *message)
{
    const et_task quiet = { stop_only, NULL }, progress = cli_task(run, "refining");
    const int threads = (int)(run->threads < 1024 ? run->threads : 1024);
    const long n = (long)t->njobs;
    et_status worst = ET_OK;
    size_t finished = 0;

    (void)threads;                        /* unused where the compiler has no OpenMP */
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (long k = 0; k < n; k++) {
        et_message own = { "" };
        et_status status = cli_stopped() ? ET_ESTOPPED : ET_OK;
        if (status == ET_OK && !t->jobs[k].done)
            status = do_job(&t->jobs[k], t, net, &quiet, run->seed, &own);
#pragma omp critical
        {
            if (status == ET_OK)
                status = compare_journal_add(t, (size_t)k, &own);
            if (status == ET_OK)
                status = et_task_step(&progress, ++finished, t->njobs);
            if (status != ET_OK && worst == ET_OK) {
                worst = status;
                et_status_fail(message, status, "%s", own.text[0] ? own.text : et_status_text(status));
            }
        }
    }
    cli_task_end(run);
    if (worst == ET_ESTOPPED)
        return et_status_fail(message, worst, t->options->journal ? "interrupted; finished runs are in %s" : "interrupted; --journal FILE keeps finished runs%s",
                              t->options->journal ? t->options->journal : "");
    return worst;
}

/* ---- the command ------------------------------------------------------------------------------------------------------- */

static void release(comparison *t)
{
    for (size_t c = 0; c < t->ncases; c++)
        for (size_t a = 0; a < 3; a++)
            et_json_free_surface(&t->cases[c].fit[a]);
    free(t->cases);
    free(t->jobs);
    json_decref(t->baseline);
    compare_journal_close(t);
}

static et_status compute(comparison *t, const et_net_file *net, cli_run *run, et_message *message)
{
    et_status status = make_cases(t, net, run, message);

    if (status == ET_OK)
        status = make_jobs(t, message);
    if (status == ET_OK)
        status = compare_journal_open(t, net, message);
    if (status == ET_OK)
        status = do_jobs(t, net, run, message);
    return status == ET_OK ? compare_deliver(t, run, message) : status;
}

static et_status run_it(const char *path, const compare_options *o, cli_run *run, et_message *message)
{
    comparison t;
    et_cloud cloud;
    et_net_file net;
    double seconds;
    et_status status = et_cloud_read(&cloud, path, message);

    if (status != ET_OK)
        return status;
    memset(&t, 0, sizeof t);
    t.options = o;
    run->input = path;
    t.cloud = path;
    t.points = cloud.count;
    status = compare_baseline_read(&t, message);
    if (status == ET_OK)
        status = cli_train(&net, &seconds, cloud.points, cloud.count, &o->train, run, message);
    et_cloud_free(&cloud);
    if (status != ET_OK) {
        release(&t);
        return status;
    }
    t.som = cli_json_som(&net, seconds);
    status = t.som ? compute(&t, &net, run, message) : et_status_fail(message, ET_ENOMEM, "not enough memory");
    json_decref(t.som);
    release(&t);
    et_json_free_net(&net);
    return status;
}

typedef struct { const char *controls, *methods, *with; } compare_lists;

static et_status settle(compare_options *o, const compare_lists *lists, et_message *message)
{
    et_status status = cli_pairs(o->controls, &o->ncontrols, COMPARE_CONTROLS, lists->controls, "control", message);

    if (status == ET_OK)
        status = cli_list(o->methods, &o->nmethods, COMPARE_METHODS, lists->methods, cli_method_name, "method", message);
    if (status == ET_OK && strcmp(lists->with, "none") != 0)
        status = cli_list(o->algorithms, &o->nalgorithms, CLI_ALGORITHMS, lists->with, cli_algorithm_name, "with", message);
    if (status != ET_OK)
        return status;
    if (o->runs < 1)
        return et_status_fail(message, ET_EINVAL, "--runs must be at least 1");
    if (o->start == ET_FIT_CONVENTIONAL)
        return et_status_fail(message, ET_EINVAL, "--start: the conventional approach leaves a gap and cannot be refined");
    o->box = o->refiner.search.box;
    const char *const paths[] = { o->output, o->journal, o->baseline };
    status = cli_distinct(paths, 3, message);
    if (status != ET_OK)
        return status;
    return cli_refine_settle(&o->refiner, message);
}

et_status cli_compare(int argc, char **argv, et_message *message)
{
    compare_options o;
    compare_lists lists = { "6x6,12x12,18x18", "chord", "ga,de,pso,ceres,optimum" };
    cli_run run = cli_run_defaults();
    const char *positional[1];
    int frame = ET_FRAME_BOX, start = ET_FIT_IMPROVED;
    size_t n;
    const cli_help help = { "compare", "etalon compare CLOUD [options]",
                            "Compare least squares (conventional, improved, joint) with Ceres and with GA, DE, PSO (average, least and greatest over the runs),\n"
                            "and all of them with the certified optimum: what share of the possible improvement each reached.",
                            "  etalon compare sphere.xyz --grid 20x20 --control 6x6,12x12 --method chord,uniform --runs 10 --threads 2\n"
                            "  etalon compare sphere.xyz --faithful --runs 10 --format csv -o table.csv\n"
                            "  etalon compare sphere.xyz --with none --baseline earlier.json\n", 1, 1 };

    memset(&o, 0, sizeof o);
    o.output = "-";
    o.runs = 10;
    o.train = cli_train_defaults();
    o.fit = cli_fit_choice_defaults();
    o.refiner = cli_refine_defaults();
    cli_option options[TABLE] = {
        { "output", 'o', CLI_TEXT, &o.output, "FILE", "where the table goes (default -: standard output)", NULL },
        { "format", 0, CLI_NAME, &o.format, "WORD", "(default text; --json means json)", compare_format_name },
        { "control", 0, CLI_TEXT, &lists.controls, "LIST", "control nets (default 6x6,12x12,18x18)", NULL },
        { "method", 0, CLI_TEXT, &lists.methods, "LIST", "parameterisations: uniform, chord, centripetal, exponential (default chord)", NULL },
        { "with", 0, CLI_TEXT, &lists.with, "LIST", "refiners: ga, de, pso, ceres, ceres-full, optimum, or none (default ga,de,pso,ceres,optimum)", NULL },
        { "runs", 0, CLI_SIZE, &o.runs, "N", "runs of GA, DE, PSO each (default 10)", NULL },
        { "start", 0, CLI_NAME, &start, "WORD", "the fit the refiners start from (default improved)", cli_approach_name },
        { "knots", 0, CLI_NAME, &o.fit.knots, "WORD", "knot rule of the default readings (default piegl)", cli_knots_name },
        { "degree", 0, CLI_PAIR, &o.fit.degree, "PxQ", "degrees (default 3x3)", NULL },
        { "journal", 0, CLI_TEXT, &o.journal, "FILE", "keep finished runs here, and do not repeat those it holds", NULL },
        { "baseline", 0, CLI_TEXT, &o.baseline, "FILE", "an earlier table (json): exit 1 if a figure differs from it", NULL },
    };
    cli_train_table(options + OWN, &o.train, &frame);
    cli_refine_table(options + OWN + CLI_TRAIN_OPTIONS, &o.refiner);
    cli_common(options + TABLE - CLI_COMMON, &run);
    et_status status = cli_parse(positional, &n, argc, argv, options, TABLE, &help, message);
    if (status != ET_OK || run.help)
        return status;
    o.train.frame = (et_frame_kind)frame;
    o.start = (size_t)start;
    o.format = run.json ? COMPARE_JSON : o.format;
    status = settle(&o, &lists, message);
    return status == ET_OK ? run_it(positional[0], &o, &run, message) : status;
}
