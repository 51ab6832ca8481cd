/* GSL's basis functions (gsl_bspline_eval_nonzero) in both directions, and the 4 x 4 sum in plain C. */
#include "surface_peer.h"
#include <gsl/gsl_bspline.h>
#include <gsl/gsl_version.h>

typedef struct { surface_input in; gsl_bspline_workspace *w; gsl_vector *N, *M; } peer;

static void point(double *S, void *context, double u, double v)
{
    peer *p = context;
    size_t i, j, end;
    gsl_bspline_eval_nonzero(u, p->N, &i, &end, p->w);
    gsl_bspline_eval_nonzero(v, p->M, &j, &end, p->w);
    S[0] = S[1] = S[2] = 0.0;
    for (size_t k = 0; k < 4; k++) {
        const double *P = p->in.xyz + 3 * ((i + k) * INPUT_SIDE + j);
        for (size_t l = 0; l < 4; l++) {
            double b = p->N->data[k] * p->M->data[l];
            S[0] += b * P[3 * l];
            S[1] += b * P[3 * l + 1];
            S[2] += b * P[3 * l + 2];
        }
    }
}

int main(int argc, char **argv)
{
    peer p;
    surface_input_net(&p.in);
    p.w = gsl_bspline_alloc(4, INPUT_SIDE - 2);
    p.N = gsl_vector_alloc(4);
    p.M = gsl_vector_alloc(4);
    memcpy(p.w->knots->data, p.in.knots, sizeof p.in.knots);
    return argc > 1 ? surface_peer_run("GSL_" GSL_VERSION, argv[1], point, &p) : 1;
}
