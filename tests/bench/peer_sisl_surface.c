/* SISL's s1424: a point without derivatives. */
#include "surface_peer.h"
#include <sisl.h>

typedef struct { SISLSurf *surface; int left1, left2; } peer;

static void point(double *S, void *context, double u, double v)
{
    peer *p = context;
    double at[2];
    int status;
    at[0] = u;
    at[1] = v;
    s1424(p->surface, 0, 0, at, &p->left1, &p->left2, S, &status);
}

int main(int argc, char **argv)
{
    surface_input in;
    peer p = {NULL, 0, 0};
    double xyz[3 * INPUT_SIDE * INPUT_SIDE];
    surface_input_net(&in);
    for (size_t i = 0; i < INPUT_SIDE; i++) {     /* SISL's first parameter runs fastest */
        for (size_t j = 0; j < INPUT_SIDE; j++) {
            memcpy(xyz + 3 * (j * INPUT_SIDE + i), in.xyz + 3 * (i * INPUT_SIDE + j), 3 * sizeof *xyz);
        }
    }
    p.surface = newSurf(INPUT_SIDE, INPUT_SIDE, 4, 4, in.knots, in.knots, xyz, 1, 3, 1);
    return argc > 1 && p.surface ? surface_peer_run("SISL_4.6_s1424", argv[1], point, &p) : 1;
}
