/* fit: a trained net becomes two surfaces. */
#include "cli/cli.h"
#include "etalon/exact/exact.h"
#include "etalon/io/file.h"
#include "etalon/io/iges.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OWN = 7 };

typedef struct { const char *surface, *iges, *bounds; } fit_outputs;

/* What is known of the distance to the exact solution. */
typedef struct {
    int known;
    et_enclosure enclosure;
    size_t escalated;                     /* coordinates that double-double left to the exact layer */
} fit_truth;

/* ---- the exact solution ------------------------------------------------------------------------------------------------ */

/* Correctly rounded control points; what double-double cannot decide (ties, ill conditioning) the exact layer does. */
static et_status refine_solution(et_surface_file *s, fit_truth *truth, const et_net_file *net, cli_run *run, et_message *message)
{
    const size_t nov = et_doublenet_nov(net->net), coordinates = 6 * s->options.control.nx * s->options.control.ny;
    et_status status = et_enclosure_refine(&s->fit, &truth->enclosure, net->weights, nov, &s->options, message);

    truth->known = status == ET_OK;
    truth->escalated = status == ET_OK ? truth->enclosure.undecided : coordinates;
    if ((status == ET_OK && truth->escalated) || status == ET_ENOCONV) {
        const et_task task = cli_task(run, "exact solution");
        status = et_exact_fit_solve(&s->fit, net->weights, nov, &s->options, NULL, &task, message);
        cli_task_end(run);
    }
    return status == ET_OK ? cli_surface_measure(s, net->weights, 0) : status;
}

static double greatest_radius(const et_enclosure *e)
{
    double most = 0;

    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; k < e->count; k++)
            most = fmax(most, fmax(e->radius[w][k].x, fmax(e->radius[w][k].y, e->radius[w][k].z)));
    return most;
}

static et_status write_bounds(const char *path, const et_surface_file *s, const et_enclosure *e, et_message *message)
{
    const size_t cy = s->options.control.ny;
    et_file file;
    const et_status status = et_file_create(&file, path, message);

    if (status != ET_OK)
        return status;
    fprintf(file.stream, "view,i,j,x,y,z,radius_x,radius_y,radius_z\n");
    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; k < e->count; k++) {
            const et_vec3 P = s->fit.shell.view[w].points[k], r = e->radius[w][k];
            fprintf(file.stream, "%s,%zu,%zu,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", w ? "top" : "bottom", k / cy, k % cy, P.x, P.y, P.z, r.x, r.y, r.z);
        }
    return et_file_commit(&file, message);
}

/* ---- telling ------------------------------------------------------------------------------------------------------------ */

static json_t *to_json(const et_surface_file *s, const fit_truth *truth, double overshoot, int exact)
{
    const et_enclosure *e = &truth->enclosure;
    json_t *o = cli_json_fit(s, overshoot);

    if (o)
        cli_json_add(&o, "exact", json_boolean(exact));
    if (o && truth->known)
        cli_json_add(&o, "enclosure", json_pack("{s:f, s:f, s:f, s:I, s:I}", "greatest_radius", greatest_radius(e), "condition", e->condition,
                                                "backward_error_eps", e->backward, "undecided", (json_int_t)e->undecided, "solved_exactly",
                                                (json_int_t)truth->escalated));
    return o;
}

static void tell(const et_surface_file *s, const fit_truth *truth, int exact)
{
    printf("%s, %s, knots %s, degree %zux%zu, control net %zux%zu%s\n", et_fit_name(s->options.approach), et_param_name(s->options.method),
           et_knotrule_name(s->options.knots), s->options.p, s->options.q, s->options.control.nx, s->options.control.ny,
           exact ? ", every stage correctly rounded" : "");
    printf("surface error %.9g over NOV, %.9g over NON; greatest %.6g\n", s->error.nov, s->error.non, s->error.greatest);
    printf("seam gap %.6g, corner error %.6g\n", s->seam_gap, s->error.corner);
    if (truth->known)
        printf("control points within %.3g of the exact solution (proved); condition %.3g, backward error %.3g eps\n",
               greatest_radius(&truth->enclosure), truth->enclosure.condition, truth->enclosure.backward);
}

static et_status finish(const et_surface_file *s, const fit_truth *truth, double overshoot, const fit_outputs *out, const cli_run *run,
                        et_message *message)
{
    et_status status = ET_OK;

    if (out->iges)
        status = et_iges_write(out->iges, &s->fit.shell, &s->frame, message);
    if (status == ET_OK && out->bounds)
        status = write_bounds(out->bounds, s, &truth->enclosure, message);
    if (status == ET_OK && out->surface)
        status = et_json_write_surface(out->surface, s, message);
    if (status == ET_OK && run->json) {
        json_t *object = to_json(s, truth, overshoot, run->exact);
        status = cli_print(object, message);
        json_decref(object);
    } else if (status == ET_OK && !run->quiet && !(out->surface && strcmp(out->surface, "-") == 0)) {
        tell(s, truth, run->exact);
    }
    return status;
}

/* ---- the command -------------------------------------------------------------------------------------------------------- */

static et_status run_it(const char *path, const et_fit_options *o, const fit_outputs *out, int refine, cli_run *run, et_message *message)
{
    et_net_file net;
    et_surface_file surface;
    fit_truth truth;
    double overshoot = 0;
    et_status status = et_json_read_net(&net, path, message);

    if (status != ET_OK)
        return status;
    memset(&truth, 0, sizeof truth);
    status = cli_fit(&surface, &net, o, run, message);
    if (status != ET_OK) {
        et_json_free_net(&net);
        return status;
    }
    if (refine)
        status = refine_solution(&surface, &truth, &net, run, message);
    if (status == ET_OK && out->bounds && !truth.known) {
        status = et_enclosure_make(&truth.enclosure, &surface.fit, net.weights, et_doublenet_nov(net.net), o, message);
        truth.known = status == ET_OK;
    }
    if (status == ET_OK) {
        overshoot = cli_overshoot(&surface, net.weights);
        cli_warn_overshoot(run, overshoot);
        status = cli_check(message);
    }
    if (status == ET_OK)
        status = finish(&surface, &truth, overshoot, out, run, message);
    et_enclosure_free(&truth.enclosure);
    et_json_free_surface(&surface);
    et_json_free_net(&net);
    return status;
}

et_status cli_fit_command(int argc, char **argv, et_message *message)
{
    cli_fit_choice choice = cli_fit_choice_defaults();
    cli_run run = cli_run_defaults();
    const char *positional[1];
    fit_outputs out = { NULL, NULL, NULL };
    int faithful = 0, refine = 0;
    size_t n;
    cli_option options[OWN + CLI_FIT_OPTIONS + CLI_COMMON] = {
        { "output", 'o', CLI_TEXT, &out.surface, "FILE", "the surface file (JSON)", NULL },
        { "iges", 0, CLI_TEXT, &out.iges, "FILE", "the surfaces for CAD (two IGES 128 entities)", NULL },
        { "approach", 0, CLI_NAME, &choice.approach, "WORD", "how the views are joined", cli_approach_name },
        { "faithful", 0, CLI_FLAG, &faithful, NULL, "the source's reading: knots from the first parameters only", NULL },
        { "exact", 0, CLI_FLAG, &run.exact, NULL, "parameters, knots, control points, errors: each correctly rounded", NULL },
        { "refine-solution", 0, CLI_FLAG, &refine, NULL, "improve the control points until they are the correctly rounded exact solution", NULL },
        { "bounds", 0, CLI_TEXT, &out.bounds, "FILE", "how far each control point may be from the exact solution (CSV, proved)", NULL },
    };
    const cli_help help = { "fit", "etalon fit NET [options]", "Fit two B-spline surfaces to a trained double net (defaults: improved, chord, piegl, qr).",
                            "  etalon fit net.json --control 12x12 --approach joint -o surface.json --iges surface.igs\n"
                            "  etalon fit net.json --degree 2x3 --method centripetal --json\n"
                            "  etalon fit net.json --exact -o exact.json\n"
                            "  etalon fit net.json --algebra cholesky --refine-solution --bounds radii.csv\n", 1, 1 };

    cli_fit_table(options + OWN, &choice);
    cli_common(options + OWN + CLI_FIT_OPTIONS, &run);
    et_status status = cli_parse(positional, &n, argc, argv, options, OWN + CLI_FIT_OPTIONS + CLI_COMMON, &help, message);
    if (status != ET_OK || run.help)
        return status;
    if (run.exact && (refine || out.bounds))
        return et_status_fail(message, ET_EINVAL, "--exact leaves nothing to refine and no error to bound: without --refine-solution and --bounds");
    const char *const paths[] = { out.surface, out.iges, out.bounds };
    status = cli_distinct(paths, 3, message);
    if (status != ET_OK)
        return status;
    cli_end_at_once();
    if (faithful)
        choice.knots = ET_KNOTRULE_FAITHFUL;
    const et_fit_options o = cli_fit_chosen(&choice);
    return run_it(positional[0], &o, &out, refine, &run, message);
}
