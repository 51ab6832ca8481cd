/* refine: the control points of a closed surface are moved to lessen its error. */
#include "cli/cli.h"
#include "etalon/io/iges.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OWN = 9 };

typedef struct { const char *surface, *iges, *history, *net, *certificate; int algorithm, exact; } refine_files;

/* The best so far of an interrupted run goes beside the place of the whole one: what stood there stays. */
static et_status partial(const cli_refined *r, const char *output, et_message *message)
{
    const size_t size = strlen(output) + sizeof ".partial";
    char *path = malloc(size);
    et_status status;

    if (!path)
        return et_status_fail(message, ET_ENOMEM, "not enough memory");
    snprintf(path, size, "%s.partial", output);
    status = et_json_write_surface(path, &r->surface, message);
    if (status == ET_OK)
        status = et_status_fail(message, ET_ESTOPPED, "interrupted after %zu steps; the best so far is in %s", r->steps, path);
    free(path);
    return status;
}

static et_status finish(const cli_refined *r, const refine_files *f, const cli_run *run, et_message *message)
{
    et_status status = ET_OK;

    if (r->stopped)
        return f->surface && strcmp(f->surface, "-") != 0 ? partial(r, f->surface, message)
                                                          : et_status_fail(message, ET_ESTOPPED, "interrupted after %zu steps", r->steps);
    if (f->iges)
        status = et_iges_write(f->iges, &r->surface.fit.shell, &r->surface.frame, message);
    if (status == ET_OK && f->history)
        status = cli_write_history(f->history, r, 1, message);
    if (status == ET_OK && f->certificate)
        status = cli_write_certificate(f->certificate, r, message);
    if (status == ET_OK && f->surface)
        status = et_json_write_surface(f->surface, &r->surface, message);
    if (status == ET_OK && run->json) {
        json_t *object = cli_json_refined(r);
        status = cli_print(object, message);
        json_decref(object);
    } else if (status == ET_OK && !run->quiet && !(f->surface && strcmp(f->surface, "-") == 0)) {
        printf("%s: %.9g -> %.9g (%.3g less) in %zu steps, %llu evaluations, %.2f s CPU; seam gap %g\n", cli_algorithm_name(r->algorithm), r->before,
               r->after, r->before - r->after, r->steps, (unsigned long long)r->evaluations, r->seconds, r->surface.seam_gap);
        if (r->algorithm == CLI_OPTIMUM)
            printf("certified: value %.17g, lower bound %.17g, gap %.3g\n", r->optimum.value, r->optimum.lower, r->optimum.gap);
    }
    return status;
}

/* The surface and the net must be of one making: same sides, and for the objective one control net for both views. */
static et_status matches(const et_surface_file *surface, const et_net_file *net, const refine_files *f, const char *path, et_message *message)
{
    const et_doublenet a = surface->fit.data, b = net->net;

    if (a.nx != b.nx || a.ny != b.ny)
        return et_status_fail(message, ET_EFORMAT, "%s was fitted to a %zux%zu net, %s holds one of %zux%zu", path, a.nx, a.ny, f->net, b.nx, b.ny);
    if (!et_shell_glued(&surface->fit.shell))
        return et_status_fail(message, ET_EFORMAT, "%s has a gap: fit it with --approach improved or joint to refine it", path);
    if (f->algorithm != CLI_CERES_FULL && surface->fit.shell.view[0].weights)
        return et_status_fail(message, ET_EFORMAT, "%s is rational: only ceres-full refines weights", path);
    if (f->exact && surface->uv)
        return et_status_fail(message, ET_EFORMAT, "%s has parameters of its own: --exact measures at the fit's", path);
    return ET_OK;
}

/* How far two honest measures of E may be apart: each of nov distances by the roundings of its surface point, 7(p + q) u of the largest coordinate, by
 * those of the difference and the root, 4 u, three coordinates together sqrt 3 < 2; twice, since either may be off. */
static double rounding(const et_surface_file *surface, const et_net_file *net)
{
    const et_surface *view = surface->fit.shell.view;
    const size_t nov = et_doublenet_nov(net->net), points = view[0].nu * view[0].nv;
    double most = 0;

    for (size_t c = 0; c < nov; c++)
        most = fmax(most, fmax(fabs(net->weights[c].x), fmax(fabs(net->weights[c].y), fabs(net->weights[c].z))));
    for (size_t k = 0; k < 2 * points; k++) {
        const et_vec3 P = view[k / points].points[k % points];
        most = fmax(most, fmax(fabs(P.x), fmax(fabs(P.y), fabs(P.z))));
    }
    return 2 * (double)nov * (double)(7 * (view[0].p + view[0].q) + 4) * 2 * most * 0x1p-53;
}

/* A surface tells its error at its net; another net of the same sides has another one.  1e-6: files of other programs may hold fewer digits. */
static et_status belongs(const et_surface_file *surface, const et_net_file *net, const refine_files *f, const char *path, et_message *message)
{
    et_surface_file here = *surface;
    const et_status status = cli_surface_measure(&here, net->weights, 0);

    if (status != ET_OK)
        return et_status_fail(message, status, "%s cannot be measured: %s", path, et_status_text(status));
    if (fabs(here.error.nov - surface->error.nov) > 1e-6 * fmax(here.error.nov, surface->error.nov) + rounding(surface, net))
        return et_status_fail(message, ET_EFORMAT, "%s was not fitted to the net in %s: its error there is %.6g, not %.6g", path, f->net, here.error.nov,
                              surface->error.nov);
    return ET_OK;
}

static et_status run_it(const char *path, const refine_files *f, const cli_refine_options *o, cli_run *run, et_message *message)
{
    et_surface_file surface;
    et_net_file net;
    cli_refined refined;
    et_status status = et_json_read_surface(&surface, path, message);

    if (status != ET_OK)
        return status;
    status = et_json_read_net(&net, f->net, message);
    if (status == ET_OK) {
        status = matches(&surface, &net, f, path, message);
        if (status == ET_OK)
            status = belongs(&surface, &net, f, path, message);
        if (status == ET_OK) {
            const et_task task = cli_task(run, cli_algorithm_name((size_t)f->algorithm));
            status = cli_refine(&refined, &surface, net.weights, (cli_algorithm)f->algorithm, o, run->seed, 0, &task, message);
            cli_task_end(run);
            if (status == ET_OK && message->text[0])          /* done, but with something to tell */
                cli_say(run, "warning: %s", message->text);
            if (status == ET_OK || status == ET_ESTOPPED) {
                status = finish(&refined, f, run, message);
                cli_refined_free(&refined);
            }
        }
        et_json_free_net(&net);
    }
    et_json_free_surface(&surface);
    return status;
}

et_status cli_refine_command(int argc, char **argv, et_message *message)
{
    cli_refine_options o = cli_refine_defaults();
    cli_run run = cli_run_defaults();
    refine_files f = { NULL, NULL, NULL, NULL, NULL, -1, 0 };
    const char *positional[1];
    size_t n;
    cli_option options[OWN + CLI_REFINE_OPTIONS + CLI_COMMON] = {
        { "output", 'o', CLI_TEXT, &f.surface, "FILE", "the refined surface (JSON)", NULL },
        { "net", 0, CLI_TEXT, &f.net, "FILE", "the trained net the surface was fitted to (needed)", NULL },
        { "with", 0, CLI_NAME, &f.algorithm, "WORD", "the algorithm (needed)", cli_algorithm_name },
        { "iges", 0, CLI_TEXT, &f.iges, "FILE", "the refined surfaces for CAD", NULL },
        { "history", 0, CLI_TEXT, &f.history, "FILE", "best value after every step (CSV)", NULL },
        { "certificate", 0, CLI_TEXT, &f.certificate, "FILE", "optimum: the dual point that proves the lower bound (JSON)", NULL },
        { "exact", 0, CLI_FLAG, &f.exact, NULL, "the result's errors correctly rounded (not for ceres-full)", NULL },
        { "checkpoint", 0, CLI_TEXT, &o.checkpoint, "FILE", "leave the state of GA, DE, PSO here at the end, also when interrupted", NULL },
        { "resume", 0, CLI_TEXT, &o.resume, "FILE", "go on from a checkpoint, with the same settings and seed, for --generations more", NULL },
    };
    const cli_help help = { "refine", "etalon refine SURFACE --net NET --with WORD [options]", "Refine the control points of a closed surface.",
                            "  etalon refine out/surface.json --net out/net.json --with pso --seed 3 -o better.json\n"
                            "  etalon refine s.json --net n.json --with ceres --iges better.igs\n"
                            "  etalon refine s.json --net n.json --with optimum --certificate dual.json --json\n"
                            "  etalon refine s.json --net n.json --with de --generations 500 --checkpoint de.state\n", 1, 1 };

    cli_refine_table(options + OWN, &o);
    cli_common(options + OWN + CLI_REFINE_OPTIONS, &run);
    et_status status = cli_parse(positional, &n, argc, argv, options, OWN + CLI_REFINE_OPTIONS + CLI_COMMON, &help, message);
    if (status != ET_OK || run.help)
        return status;
    if (!f.net || f.algorithm < 0)
        return et_status_fail(message, ET_EINVAL, "--net and --with are needed; usage: %s", help.usage);
    if ((o.checkpoint || o.resume) && f.algorithm > CLI_PSO)
        return et_status_fail(message, ET_EINVAL, "--checkpoint and --resume are for ga, de, pso");
    if (f.certificate && f.algorithm != CLI_OPTIMUM)
        return et_status_fail(message, ET_EINVAL, "--certificate is for optimum");
    if (f.exact && f.algorithm == CLI_CERES_FULL)
        return et_status_fail(message, ET_EINVAL, "--exact measures at the fit's parameters, ceres-full has its own");
    o.exact = f.exact;
    const char *const paths[] = { f.surface, f.iges, f.history, o.checkpoint, f.certificate };
    status = cli_distinct(paths, sizeof paths / sizeof paths[0], message);
    if (status == ET_OK)
        status = cli_refine_settle(&o, message);
    return status == ET_OK ? run_it(positional[0], &f, &o, &run, message) : status;
}
