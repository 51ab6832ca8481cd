/* choices: the option tables that several subcommands share. */
#include "cli/cli.h"
#include <string.h>

void cli_train_table(cli_option table[CLI_TRAIN_OPTIONS], cli_train_options *o, int *frame)
{
    const cli_option rows[CLI_TRAIN_OPTIONS] = {
        { "grid", 0, CLI_PAIR, &o->grid, "NXxNY", "sides of the double net (default 20x20)", NULL },
        { "iterations", 0, CLI_SIZE, &o->iterations, "T", "training steps (default 30000)", NULL },
        { "alpha", 0, CLI_REAL, &o->alpha, "A", "initial learning rate (default 0.9)", NULL },
        { "radius", 0, CLI_REAL, &o->radius, "S", "initial radius; 0 means half the shorter side (default 0)", NULL },
        { "normalise", 0, CLI_NAME, frame, "WORD", "how the cloud is mapped to the unit cube (default box)", cli_frame_name },
    };
    memcpy(table, rows, sizeof rows);
}

cli_fit_choice cli_fit_choice_defaults(void)
{
    const et_fit_options o = et_fit_defaults();
    const cli_fit_choice choice = { (int)o.approach, (int)o.method, (int)o.knots, (int)o.algebra, (int)o.corners,
                                    { o.p, o.q }, { o.control.nx, o.control.ny } };
    return choice;
}

void cli_fit_table(cli_option table[CLI_FIT_OPTIONS], cli_fit_choice *c)
{
    const cli_option rows[CLI_FIT_OPTIONS] = {
        { "control", 0, CLI_PAIR, &c->control, "HXxHY", "sides of the control net (default 12x12)", NULL },
        { "degree", 0, CLI_PAIR, &c->degree, "PxQ", "degrees (default 3x3)", NULL },
        { "method", 0, CLI_NAME, &c->method, "WORD", "parameterisation (default chord)", cli_method_name },
        { "knots", 0, CLI_NAME, &c->knots, "WORD", "knot rule (default piegl)", cli_knots_name },
        { "algebra", 0, CLI_NAME, &c->algebra, "WORD", "how least squares are solved (default qr)", cli_algebra_name },
        { "corners", 0, CLI_NAME, &c->corners, "WORD", "corners of the data (default: interpolated for improved, else free)", cli_corners_name },
    };
    memcpy(table, rows, sizeof rows);
}

et_fit_options cli_fit_chosen(const cli_fit_choice *c)
{
    et_fit_options o = et_fit_defaults();

    o.approach = (et_fit_approach)c->approach;
    o.method = (et_param_method)c->method;
    o.knots = (et_knotrule_kind)c->knots;
    o.algebra = (et_linalg_method)c->algebra;
    o.corners = (et_fit_corners)c->corners;
    o.p = c->degree[0];
    o.q = c->degree[1];
    o.control.nx = c->control[0];
    o.control.ny = c->control[1];
    return o;
}

void cli_refine_table(cli_option table[CLI_REFINE_OPTIONS], cli_refine_options *o)
{
    et_search_options *s = &o->search;
    const cli_option rows[CLI_REFINE_OPTIONS] = {
        { "generations", 0, CLI_SIZE, &o->generations, "N", "generations of GA, DE, PSO (default 2000)", NULL },
        { "population", 0, CLI_SIZE, &s->population, "N", "individuals (default 40)", NULL },
        { "spread", 0, CLI_REAL, &s->spread, "W", "the start population is the surface's net plus U(-W, W) (default 5e-6)", NULL },
        { "box", 0, CLI_REAL, &s->box, "W", "keep every coordinate within W of its start; 0: no box (default 0; --faithful: 5e-6)", NULL },
        { "tournament", 0, CLI_SIZE, &s->tournament, "N", "GA: individuals a tournament (default 4)", NULL },
        { "crossover", 0, CLI_REAL, &s->crossover, "P", "GA: probability of crossover (default 0.7)", NULL },
        { "swap", 0, CLI_REAL, &s->swap, "P", "GA: probability that a control point is swapped (default 0.5)", NULL },
        { "mutation", 0, CLI_REAL, &s->mutation, "P", "GA: probability of mutation (default 0.01)", NULL },
        { "F", 0, CLI_REAL, &s->F, "F", "DE: differential weight (default 0.3)", NULL },
        { "CR", 0, CLI_REAL, &s->CR, "P", "DE: crossover probability (default 0.8)", NULL },
        { "by-coordinate", 0, CLI_FLAG, &s->by_coordinate, NULL, "DE: cross single coordinates instead of control points", NULL },
        { "K", 0, CLI_REAL, &s->K, "K", "PSO: constriction factor (default 0.729)", NULL },
        { "c1", 0, CLI_REAL, &s->c1, "C", "PSO: pull of an individual's own best (default 2.05)", NULL },
        { "c2", 0, CLI_REAL, &s->c2, "C", "PSO: pull of the swarm's best (default 2.05)", NULL },
        { "vmax", 0, CLI_REAL, &s->vmax, "V", "PSO: greatest speed a coordinate; 0: none (default 5e-6)", NULL },
        { "immediate", 0, CLI_FLAG, &s->immediate, NULL, "PSO: follow the best found within the same sweep already", NULL },
        { "absorb", 0, CLI_FLAG, &s->absorb, NULL, "PSO: a coordinate held by the box loses its velocity", NULL },
        { "ceres-iterations", 0, CLI_SIZE, &o->ceres.iterations, "N", "Ceres: iterations in all (default 400)", NULL },
        { "ceres-tolerance", 0, CLI_REAL, &o->ceres.tolerance, "T", "Ceres: relative change that ends a stage (default 1e-10)", NULL },
        { "optimum-iterations", 0, CLI_SIZE, &o->optimum.iterations, "N", "optimum: iterations at most (default 100)", NULL },
        { "optimum-gap", 0, CLI_REAL, &o->optimum.gap, "G", "optimum: done when value and lower bound are this near, relatively (default 1e-12)", NULL },
        { "faithful", 0, CLI_FLAG, &o->faithful, NULL, "the source's readings: box of 5e-6, and the population's best even if worse than the start", NULL },
    };
    memcpy(table, rows, sizeof rows);
}

static int probability(double p)
{
    return p >= 0 && p <= 1;
}

et_status cli_refine_settle(cli_refine_options *o, et_message *message)
{
    et_search_options *s = &o->search;

    if (o->faithful && s->box == 0)
        s->box = et_search_defaults().box;
    if (s->population < 4 || o->generations < 1 || s->tournament < 1)
        return et_status_fail(message, ET_EINVAL, "--population must be at least 4, --generations and --tournament at least 1");
    if (!probability(s->crossover) || !probability(s->swap) || !probability(s->mutation) || !probability(s->CR))
        return et_status_fail(message, ET_EINVAL, "--crossover, --swap, --mutation and --CR are probabilities: 0 to 1");
    if (s->spread < 0 || s->box < 0 || s->vmax < 0)
        return et_status_fail(message, ET_EINVAL, "--spread, --box and --vmax must not be negative");
    if (o->ceres.iterations < 1 || !(o->ceres.tolerance > 0))
        return et_status_fail(message, ET_EINVAL, "--ceres-iterations must be at least 1, --ceres-tolerance greater than 0");
    if (o->optimum.iterations < 1 || !(o->optimum.gap >= 0))
        return et_status_fail(message, ET_EINVAL, "--optimum-iterations must be at least 1, --optimum-gap not negative");
    return ET_OK;
}
