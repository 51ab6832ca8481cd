/* refine_table: what GA, DE and PSO gain over the improved fit B, in units of 1e-4, beside the source's tables (You 2023, Appendix K; chord, its own
 * knots, its box of 5e-6): mean over nets, one run each.
 *
 * refine_table [NETS]     (3)
 */
#include "etalon/fit/fit.h"
#include "etalon/io/primitive.h"
#include "etalon/refine/de.h"
#include "etalon/refine/ga.h"
#include "etalon/refine/objective.h"
#include "etalon/refine/pso.h"
#include "etalon/som/som.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 20, ROWS = 4, METHODS = 3, GENERATIONS = 2000 };

typedef struct { et_primitive_kind kind; size_t side; double published[METHODS]; } cell;     /* published NaN: not at hand */

static const cell cells[ROWS] = { { ET_PRIMITIVE_CUBE, 6, { 2.8, 4.6, 3.6 } }, { ET_PRIMITIVE_CUBE, 18, { -0.2, 3.6, 3.4 } },
                                  { ET_PRIMITIVE_SPHERE, 6, { NAN, NAN, NAN } }, { ET_PRIMITIVE_SPHERE, 18, { -0.2, 3.3, 3.5 } } };
static const char *const names[METHODS] = { "GA", "DE", "PSO" };
static const et_search_step steps[METHODS] = { et_ga_step, et_de_step, et_pso_step };

static void need(et_status status, const char *what)
{
    if (status == ET_OK) return;
    fprintf(stderr, "refine_table: %s: %s\n", what, et_status_text(status));
    exit(1);
}

static et_vec3 *cloud_of(size_t *n, et_primitive_kind kind)
{
    need(et_primitive_count(n, kind, 0, 0), "cloud");
    et_vec3 *cloud = malloc((*n + 1) * sizeof *cloud);
    need(cloud ? et_primitive_make(cloud, *n, kind, 0, 0) : ET_ENOMEM, "cloud");
    return cloud;
}

static void train(et_vec3 *data, size_t nov, et_doublenet net, const et_vec3 *cloud, size_t n, uint64_t seed)
{
    const et_som_options options = et_som_defaults();
    et_som_quality quality;
    et_rng *rng;
    need(et_rng_new(&rng, seed), "generator");
    et_som_start(data, nov, rng);
    need(et_som_train(data, nov, &quality, net, cloud, n, &options, rng, NULL), "training");
    et_rng_free(rng);
}

/* B - result of one run. */
static double gain(const et_fit *fit, const et_vec3 *data, size_t nov, size_t method, double b, uint64_t seed)
{
    const size_t classes = et_doublenet_nov(et_shell_net(&fit->shell));
    et_vec3 *points = malloc(classes * sizeof *points);
    double *x0 = malloc(3 * classes * sizeof *x0);
    et_search_options options = et_search_defaults();
    et_objective *objective;
    et_search search;
    et_rng *rng;
    size_t made;
    need(points && x0 ? ET_OK : ET_ENOMEM, "start");
    options.group = 3;
    et_shell_gather(points, classes, &fit->shell);
    memcpy(x0, points, 3 * classes * sizeof *x0);
    need(et_objective_new(&objective, fit, data, nov), "objective");
    need(et_rng_new(&rng, seed), "generator");
    need(et_search_start(&search, x0, 3 * classes, &options, method == 2, et_objective_eval, objective, rng), "start");
    need(et_search_run(&search, &made, NULL, GENERATIONS, steps[method], rng, NULL), "run");
    const double result = search.best_value;
    et_search_free(&search);
    et_rng_free(rng);
    et_objective_free(objective);
    free(points);
    free(x0);
    return b - result;
}

static void add(double sum[METHODS], const et_vec3 *data, size_t nov, et_doublenet net, size_t side, uint64_t seed)
{
    et_fit_options options = et_fit_defaults();
    et_fit_error error;
    et_fit fit;
    options.knots = ET_KNOTRULE_FAITHFUL;
    options.control = (et_doublenet){ side, side };
    need(et_fit_make(&fit, data, nov, net, &options, NULL), "fit");
    need(et_fit_measure(&error, NULL, nov, &fit, data), "measure");
    for (size_t m = 0; m < METHODS; m++) sum[m] += gain(&fit, data, nov, m, error.nov, et_rng_stream(seed, m));
    et_fit_free(&fit);
}

static void row(const cell *c, size_t nets)
{
    const et_doublenet net = { SIDE, SIDE };
    const size_t nov = et_doublenet_nov(net);
    double sum[METHODS] = { 0.0 };
    size_t n = 0;
    et_vec3 *cloud = cloud_of(&n, c->kind), *data = malloc(nov * sizeof *data);
    need(data ? ET_OK : ET_ENOMEM, "data");
    for (size_t k = 1; k <= nets; k++) {
        train(data, nov, net, cloud, n, k);
        add(sum, data, nov, net, c->side, k);
    }
    printf("%-7s %2zux%-2zu ", et_primitive_name(c->kind), c->side, c->side);
    for (size_t m = 0; m < METHODS; m++) {
        if (isnan(c->published[m])) printf("  %-3s    -   ", names[m]);
        else printf("  %-3s %5.1f  ", names[m], c->published[m]);
        printf("%5.1f", 1e4 * sum[m] / (double)nets);
    }
    printf("\n");
    fflush(stdout);
    free(cloud);
    free(data);
}

int main(int argc, char **argv)
{
    const size_t nets = argc > 1 ? (size_t)strtoul(argv[1], NULL, 10) : 3;
    if (nets < 1) return 2;
    printf("gain over B, 1e-4: each method, thesis, here\n");
    for (size_t k = 0; k < ROWS; k++) row(&cells[k], nets);
    return 0;
}
