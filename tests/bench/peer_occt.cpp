// OCCT: Geom_BSplineSurface::D0 at random parameters; GeomAdaptor_Surface, which caches a patch's polynomials, on a grid.
#include "surface_peer.h"
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Version.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <string>

static void put(double *S, const gp_Pnt &P)
{
    S[0] = P.X();
    S[1] = P.Y();
    S[2] = P.Z();
}

static void direct(double *S, void *context, double u, double v)
{
    gp_Pnt P;
    static_cast<Geom_BSplineSurface *>(context)->D0(u, v, P);
    put(S, P);
}

static void cached(double *S, void *context, double u, double v)
{
    gp_Pnt P;
    static_cast<GeomAdaptor_Surface *>(context)->D0(u, v, P);
    put(S, P);
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        return 1;
    }
    surface_input in;
    surface_input_net(&in);
    TColgp_Array2OfPnt poles(1, INPUT_SIDE, 1, INPUT_SIDE);
    TColStd_Array1OfReal knots(1, INPUT_SIDE - 2);
    TColStd_Array1OfInteger multiplicities(1, INPUT_SIDE - 2);
    for (int i = 0; i < INPUT_SIDE; i++) {
        for (int j = 0; j < INPUT_SIDE; j++) {
            const double *P = in.xyz + 3 * (i * INPUT_SIDE + j);
            poles.SetValue(i + 1, j + 1, gp_Pnt(P[0], P[1], P[2]));
        }
    }
    for (int k = 1; k <= INPUT_SIDE - 2; k++) {
        knots.SetValue(k, in.knots[k + 2]);
        multiplicities.SetValue(k, k == 1 || k == INPUT_SIDE - 2 ? 4 : 1);
    }
    Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
    GeomAdaptor_Surface adaptor(surface);
    bool grid = strcmp(argv[1], "surface_grid") == 0;
    std::string version = std::string("OCCT_") + OCC_VERSION_COMPLETE + (grid ? "_cached" : "_D0");
    return grid ? surface_peer_run(version.c_str(), argv[1], cached, &adaptor) : surface_peer_run(version.c_str(), argv[1], direct, surface.get());
}
