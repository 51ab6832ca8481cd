/* fit_table: the surface errors of the source's Tables (You 2023, chapter 5), A conventional and B improved, beside ours: mean of ten nets, chord,
 * counted and knotted as the source did; then the same nets with the default knots, counted like for like over the classes, joint fit included.
 *
 * fit_table [NETS]     (10)
 */
#include "etalon/fit/fit.h"
#include "etalon/io/primitive.h"
#include "etalon/som/som.h"
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 20, SIZES = 2, COLUMNS = 5 };

static const size_t sizes[SIZES] = {6, 18};
static const double published[2][SIZES][2] = {{{30.6, 28.8}, {3.09, 2.82}}, {{14.5, 15.4}, {2.03, 1.93}}};
static const et_primitive_kind kinds[2] = {ET_PRIMITIVE_CUBE, ET_PRIMITIVE_SPHERE};
static const char *const kind_names[2] = {"cube", "sphere"};

static void stop(et_status status, const char *what)
{
    fprintf(stderr, "fit_table: %s: %s\n", what, et_status_text(status));
    exit(1);
}

static void train(et_vec3 *data, size_t nov, et_doublenet net, const et_vec3 *cloud, size_t n, uint64_t seed)
{
    et_som_options options = et_som_defaults();
    et_som_quality quality;
    et_rng *rng;
    et_status status = et_rng_new(&rng, seed);

    if (status != ET_OK)
        stop(status, "generator");
    et_som_start(data, nov, rng);
    status = et_som_train(data, nov, &quality, net, cloud, n, &options, rng, NULL);
    et_rng_free(rng);
    if (status != ET_OK)
        stop(status, "training");
}

static et_fit_error fit(const et_vec3 *data, size_t nov, et_doublenet net, size_t side, et_fit_approach approach, et_knotrule_kind knots)
{
    et_fit_options options = et_fit_defaults();
    et_fit_error error;
    et_fit made;
    et_status status;

    options.approach = approach;
    options.knots = knots;
    options.control = (et_doublenet){side, side};
    status = et_fit_make(&made, data, nov, net, &options, NULL);
    if (status != ET_OK)
        stop(status, "fit");
    status = et_fit_measure(&error, NULL, nov, &made, data);
    if (status != ET_OK)
        stop(status, "measure");
    et_fit_free(&made);
    return error;
}

static void add_net(double sum[SIZES][COLUMNS], const et_vec3 *data, size_t nov, et_doublenet net)
{
    for (size_t k = 0; k < SIZES; k++) {
        sum[k][0] += fit(data, nov, net, sizes[k], ET_FIT_CONVENTIONAL, ET_KNOTRULE_FAITHFUL).non;
        sum[k][1] += fit(data, nov, net, sizes[k], ET_FIT_IMPROVED, ET_KNOTRULE_FAITHFUL).nov;
        sum[k][2] += fit(data, nov, net, sizes[k], ET_FIT_CONVENTIONAL, ET_KNOTRULE_PIEGL).nov;
        sum[k][3] += fit(data, nov, net, sizes[k], ET_FIT_IMPROVED, ET_KNOTRULE_PIEGL).nov;
        sum[k][4] += fit(data, nov, net, sizes[k], ET_FIT_JOINT, ET_KNOTRULE_PIEGL).nov;
    }
}

static void run(size_t model, size_t nets)
{
    const et_doublenet net = {SIDE, SIDE};
    const size_t nov = et_doublenet_nov(net);
    double sum[SIZES][COLUMNS] = {{0}};
    size_t n = 0;
    et_vec3 *cloud, *data = malloc(nov * sizeof *data);
    et_status status = et_primitive_count(&n, kinds[model], model == 0 ? 36 : 59, model == 0 ? 0 : 120);

    cloud = malloc((n + 1) * sizeof *cloud);
    if (data == NULL || cloud == NULL)
        stop(ET_ENOMEM, "data");
    if (status == ET_OK)
        status = et_primitive_make(cloud, n, kinds[model], model == 0 ? 36 : 59, model == 0 ? 0 : 120);
    if (status != ET_OK)
        stop(status, "cloud");
    for (size_t k = 0; k < nets; k++) {
        train(data, nov, net, cloud, n, 1 + k);
        add_net(sum, data, nov, net);
    }
    for (size_t k = 0; k < SIZES; k++) {
        printf("%-7s %2zux%-2zu  %7.2f %7.2f   %7.2f %7.2f  ", kind_names[model], sizes[k], sizes[k], published[model][k][0],
               sum[k][0] / (double)nets, published[model][k][1], sum[k][1] / (double)nets);
        printf("| %7.2f %7.2f %7.2f\n", sum[k][2] / (double)nets, sum[k][3] / (double)nets, sum[k][4] / (double)nets);
    }
    free(cloud);
    free(data);
}

int main(int argc, char **argv)
{
    const size_t nets = argc > 1 ? (size_t)strtoul(argv[1], NULL, 10) : 10;

    if (nets < 1)
        return 2;
    printf("                 the source's knots and count     | right knots, over the classes\n");
    printf("                A thesis    here  B thesis    here  |       A       B   joint\n");
    for (size_t model = 0; model < 2; model++)
        run(model, nets);
    return 0;
}
