/* fit: a trained net becomes two surfaces. */
#include "cli/cli.h"
#include "etalon/io/iges.h"
#include <string.h>

enum { OWN = 4 };

typedef struct { const char *surface, *iges; } fit_outputs;

static et_status finish(const et_surface_file *s, double overshoot, const fit_outputs *out, const cli_run *run, et_message *message)
{
    const char *const paths[] = { out->surface, out->iges };
    et_status status = cli_distinct(paths, 2, message);

    if (status == ET_OK && out->iges)
        status = et_iges_write(out->iges, &s->fit.shell, &s->frame, message);
    if (status == ET_OK && out->surface)
        status = et_json_write_surface(out->surface, s, message);
    if (status == ET_OK && run->json) {
        json_t *object = cli_json_fit(s, overshoot);
        status = cli_print(object, message);
        json_decref(object);
    } else if (status == ET_OK && !run->quiet && !(out->surface && strcmp(out->surface, "-") == 0)) {
        printf("%s, %s, knots %s, degree %zux%zu, control net %zux%zu\n", et_fit_name(s->options.approach), et_param_name(s->options.method),
               et_knotrule_name(s->options.knots), s->options.p, s->options.q, s->options.control.nx, s->options.control.ny);
        printf("surface error %.9g over NOV, %.9g over NON; greatest %.6g\n", s->error.nov, s->error.non, s->error.greatest);
        printf("seam gap %.6g, corner error %.6g\n", s->seam_gap, s->error.corner);
    }
    return status;
}

et_status cli_fit_command(int argc, char **argv, et_message *message)
{
    cli_fit_choice choice = cli_fit_choice_defaults();
    cli_run run = cli_run_defaults();
    const char *positional[1];
    fit_outputs out = { NULL, NULL };
    int faithful = 0;
    size_t n;
    et_net_file net;
    et_surface_file surface;
    cli_option options[OWN + CLI_FIT_OPTIONS + CLI_COMMON] = {
        { "output", 'o', CLI_TEXT, &out.surface, "FILE", "the surface file (JSON)", NULL },
        { "iges", 0, CLI_TEXT, &out.iges, "FILE", "the surfaces for CAD (two IGES 128 entities)", NULL },
        { "approach", 0, CLI_NAME, &choice.approach, "WORD", "how the views are joined", cli_approach_name },
        { "faithful", 0, CLI_FLAG, &faithful, NULL, "the source's reading: knots from the first parameters only", NULL },
    };
    const cli_help help = { "fit", "etalon fit NET [options]", "Fit two B-spline surfaces to a trained double net (defaults: improved, chord, piegl, qr).",
                            "  etalon fit net.json --control 12x12 --approach joint -o surface.json --iges surface.igs\n"
                            "  etalon fit net.json --degree 2x3 --method centripetal --json\n", 1, 1 };

    cli_fit_table(options + OWN, &choice);
    cli_common(options + OWN + CLI_FIT_OPTIONS, &run);
    et_status status = cli_parse(positional, &n, argc, argv, options, OWN + CLI_FIT_OPTIONS + CLI_COMMON, &help, message);
    if (status != ET_OK || run.help)
        return status;
    cli_end_at_once();
    if (faithful)
        choice.knots = ET_KNOTRULE_FAITHFUL;
    const et_fit_options o = cli_fit_chosen(&choice);
    status = et_json_read_net(&net, positional[0], message);
    if (status != ET_OK)
        return status;
    status = cli_fit(&surface, &net, &o, message);
    const double overshoot = status == ET_OK ? cli_overshoot(&surface, net.weights) : 0;
    et_json_free_net(&net);
    if (status != ET_OK)
        return status;
    cli_warn_overshoot(&run, overshoot);
    status = cli_check(message);
    if (status == ET_OK)
        status = finish(&surface, overshoot, &out, &run, message);
    et_json_free_surface(&surface);
    return status;
}
