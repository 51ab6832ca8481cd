/* som_table: the source's table of quantisation and topographic errors (You 2023, Appendix B, double nets), next to ours: during training as printed,
 * mean of ten seeds, and after training over all points.  Exit status 1 if a figure is off by more than 2 % (QE) or 0.02 (TE). */
#include "etalon/io/primitive.h"
#include "etalon/som/quality.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SEEDS = 10, SIDE = 30, CLASSES = 2 * (SIDE * SIDE - 2 * SIDE + 2), POINTS = 7552 };

typedef struct {
    et_primitive_kind kind;
    size_t n;
    double qe, te;
} printed;
typedef struct {
    double qe, te, qe_after, te_after, spread;
} figures;

static int train(figures *f, const printed *p)
{
    static et_vec3 cloud[POINTS], weights[CLASSES];
    const et_doublenet net = {p->n, p->n};
    const et_som_options options = et_som_defaults();
    const size_t nov = et_doublenet_nov(net);
    double squares = 0;
    size_t count;

    if (et_primitive_count(&count, p->kind, 0, 0) || count > POINTS || et_primitive_make(cloud, count, p->kind, 0, 0))
        return 0;
    *f = (figures){0, 0, 0, 0, 0};
    for (uint64_t k = 0; k < SEEDS; k++) {
        et_som_quality during, after;
        et_rng *rng;

        if (et_rng_new(&rng, et_rng_stream(1, k)))
            return 0;
        et_som_start(weights, nov, rng);
        const et_status status = et_som_train(weights, nov, &during, net, cloud, count, &options, rng, NULL);
        et_rng_free(rng);
        if (status || et_quality_of(&after, weights, nov, net, cloud, count))
            return 0;
        f->qe += during.qe / SEEDS;
        f->te += during.te / SEEDS;
        f->qe_after += after.qe / SEEDS;
        f->te_after += after.te / SEEDS;
        squares += during.qe * during.qe;
    }
    f->spread = sqrt(fmax(0, (squares - SEEDS * f->qe * f->qe) / (SEEDS - 1)));
    return 1;
}

int main(void)
{
    static const printed table[] = {
        {ET_PRIMITIVE_CUBE, 10, 0.138079, 0.218967},    {ET_PRIMITIVE_CUBE, 20, 0.085877, 0.205167},
        {ET_PRIMITIVE_CUBE, 30, 0.067436, 0.197733},    {ET_PRIMITIVE_SPHERE, 10, 0.098825, 0.235833},
        {ET_PRIMITIVE_SPHERE, 20, 0.061035, 0.212000},  {ET_PRIMITIVE_SPHERE, 30, 0.047605, 0.211433},
        {ET_PRIMITIVE_SPINDLE, 10, 0.099202, 0.231400}, {ET_PRIMITIVE_SPINDLE, 20, 0.060576, 0.221100},
        {ET_PRIMITIVE_SPINDLE, 30, 0.047371, 0.218300}, {ET_PRIMITIVE_OILTANK, 10, 0.109936, 0.219400},
        {ET_PRIMITIVE_OILTANK, 20, 0.067115, 0.203767}, {ET_PRIMITIVE_OILTANK, 30, 0.052517, 0.193733},
    };
    int met = 1;

    printf("%-8s %5s | %8s %8s %6s %9s | %7s %7s %7s | met | after: QE, TE\n", "cloud", "net", "QE", "ours", "dev", "sd", "TE", "ours", "dev");
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        const printed *p = &table[k];
        figures f;

        if (!train(&f, p)) {
            fputs("som_table: out of memory\n", stderr);
            return 70;
        }
        const double qe = f.qe / p->qe - 1, te = f.te - p->te;
        const int ok = fabs(qe) <= 0.02 && fabs(te) <= 0.02;
        printf("%-8s %2zux%2zu | %8.6f %8.6f %+5.1f%% %9.6f | %7.5f %7.5f %+7.4f | %s | %8.6f %7.5f\n", et_primitive_name(p->kind), p->n, p->n, p->qe,
               f.qe, 100 * qe, f.spread, p->te, f.te, te, ok ? "yes" : "NO ", f.qe_after, f.te_after);
        met = met && ok;
    }
    printf("bar (QE within 2 %%, TE within 0.02, mean of %d seeds): %s\n", SEEDS, met ? "met" : "NOT met");
    return met ? 0 : 1;
}
