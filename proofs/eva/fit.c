#include "eva.h"
#include "etalon/fit/enclosure.h"
#include "etalon/fit/fit.h"

enum { NX = 4, NY = 5, NOV = 2 * NX * NY - 2 * (NX + NY) + 4 };

static et_fit_options choose(et_fit_approach approach, et_linalg_method algebra)
{
    et_fit_options o = et_fit_defaults();

    o.approach = approach;
    o.algebra = algebra;
    o.p = 2;
    o.q = 3;
    o.control = (et_doublenet){3, 4};
    return o;
}

/* A fit, measured, or enclosed as it is or after refinement: which of these two, the analysis does not know, so that it looks once at what is before. */
static void fit(et_fit_approach approach, et_linalg_method algebra, int enclose)
{
    const et_fit_options o = choose(approach, algebra);
    const et_doublenet net = {NX, NY};
    et_fit f;
    et_fit_error error;
    et_enclosure e;
    et_vec3 data[NOV];
    double residual[NOV];
    et_message message;

    fill(&data[0].x, 3 * NOV);
    if (et_fit_make(&f, data, NOV, net, &o, &message) != ET_OK)
        return;
    if (!enclose)
        et_fit_measure(&error, residual, NOV, &f, data);
    else if (Frama_C_nondet(0, 1)) {
        if (et_enclosure_make(&e, &f, data, NOV, &o, &message) == ET_OK)
            et_enclosure_free(&e);
    } else if (et_enclosure_refine(&f, &e, data, NOV, &o, &message) == ET_OK)
        et_enclosure_free(&e);
    et_fit_free(&f);
}

/* Any one request for memory may fail: on the least net. */
void eva_fit_memory(void)
{
    enum { N = 14 };
    et_fit_options o = et_fit_defaults();
    const et_doublenet net = {3, 4};
    et_fit f;
    et_vec3 data[N];
    et_message message;

    o.p = 1;
    o.q = 2;
    o.control = (et_doublenet){2, 3};
    any_memory();
    fill(&data[0].x, 3 * N);
    if (et_fit_make(&f, data, N, net, &o, &message) == ET_OK)
        et_fit_free(&f);
}

void eva_fit_parameters(void)
{
    const et_doublenet net = {NX, NY};
    et_fit f;
    et_vec3 data[NOV];

    any_memory();
    fill(&data[0].x, 3 * NOV);
    et_fit_name(ET_FIT_JOINT);
    if (et_fit_parameters(&f, data, NOV, net, ET_FIT_IMPROVED, ET_PARAM_CHORD) == ET_OK)
        et_fit_free(&f);
}

void eva_fit_conventional_qr(void) { fit(ET_FIT_CONVENTIONAL, ET_LINALG_QR, 0); }
void eva_fit_improved_cholesky(void) { fit(ET_FIT_IMPROVED, ET_LINALG_CHOLESKY, 0); }
void eva_fit_improved_svd(void) { fit(ET_FIT_IMPROVED, ET_LINALG_SVD, 0); }
void eva_fit_joint_qr(void) { fit(ET_FIT_JOINT, ET_LINALG_QR, 0); }
void eva_enclosure(void) { fit(ET_FIT_IMPROVED, ET_LINALG_QR, 1); } /* eva: -eva-slevel 150 */
