/* read_iges FILE.igs SURFACE.json: what OpenCASCADE reads from an IGES file is, bit for bit, what the surface file says (knots, poles in the
 * cloud's own coordinates, weights), and its evaluation agrees with the recursion of Cox and de Boor.  Prints `ok ...` and `FAIL ...`. */
#include <Geom_BSplineSurface.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <BRep_Tool.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <cstdio>
#include <jansson.h>
#include <string>
#include <vector>

namespace
{

bool failed;

void told(bool ok, const std::string &what)
{
    std::printf("%s iges_occt %s\n", ok ? "ok" : "FAIL", what.c_str());
    failed = failed || !ok;
}

struct View {
    int p, q, nu, nv;
    std::vector<double> u, v, w;
    std::vector<gp_Pnt> points;           /* [i*nv + j], own coordinates */
};

std::vector<double> reals(const json_t *a)
{
    std::vector<double> x;

    for (size_t k = 0; k < json_array_size(a); k++)
        x.push_back(json_number_value(json_array_get(a, k)));
    return x;
}

View view_of(const json_t *root, const char *name)
{
    const json_t *const o = json_object_get(json_object_get(root, "views"), name), *const frame = json_object_get(root, "frame");
    const std::vector<double> offset = reals(json_object_get(frame, "offset")), scale = reals(json_object_get(frame, "scale"));
    const auto count = [o](const char *key) { return (int)json_integer_value(json_object_get(o, key)); };
    const json_t *const points = json_object_get(o, "points");
    View s = {count("p"), count("q"), count("nu"), count("nv"), reals(json_object_get(o, "u")), reals(json_object_get(o, "v")), {}, {}};

    s.w = reals(json_object_get(o, "weights"));
    if (s.w.empty())
        s.w.assign((size_t)(s.nu * s.nv), 1.0);
    for (size_t k = 0; k < json_array_size(points); k++) {
        const std::vector<double> x = reals(json_array_get(points, k));

        s.points.emplace_back(offset[0] + scale[0] * x[0], offset[1] + scale[1] * x[1], offset[2] + scale[2] * x[2]);
    }
    return s;
}

double basis(const std::vector<double> &u, int n, int p, int k, double t)
{
    const auto at = [&u](int i) { return u[(size_t)i]; };

    if (p == 0)
        return (at(k) <= t && t < at(k + 1)) || (t >= at(n) && at(k) < at(k + 1) && at(k + 1) == at(n)) ? 1 : 0;
    return (at(k + p) > at(k) ? (t - at(k)) / (at(k + p) - at(k)) * basis(u, n, p - 1, k, t) : 0)
           + (at(k + p + 1) > at(k + 1) ? (at(k + p + 1) - t) / (at(k + p + 1) - at(k + 1)) * basis(u, n, p - 1, k + 1, t) : 0);
}

gp_Pnt point(const View &s, double u, double v)
{
    gp_XYZ sum(0, 0, 0);
    double w = 0;

    for (int i = 0; i < s.nu; i++)
        for (int j = 0; j < s.nv; j++) {
            const size_t k = (size_t)(i * s.nv + j);
            const double b = basis(s.u, s.nu, s.p, i, u) * basis(s.v, s.nv, s.q, j, v) * s.w[k];

            sum += b * s.points[k].XYZ();
            w += b;
        }
    return gp_Pnt(sum / w);
}

bool same_knots(const TColStd_Array1OfReal &got, const std::vector<double> &want)
{
    bool same = (size_t)got.Length() == want.size();

    for (size_t k = 0; same && k < want.size(); k++)
        same = got.Value(got.Lower() + (int)k) == want[k];
    return same;
}

bool same_net(const Handle(Geom_BSplineSurface) & got, const View &want)
{
    bool same = got->NbUPoles() == want.nu && got->NbVPoles() == want.nv;

    for (int i = 0; same && i < want.nu; i++)
        for (int j = 0; same && j < want.nv; j++) {
            const size_t k = (size_t)(i * want.nv + j);

            same = got->Pole(i + 1, j + 1).Distance(want.points[k]) == 0 && got->Weight(i + 1, j + 1) == want.w[k];
        }
    return same;
}

/* The greatest distance on a grid of 12 x 12 parameters, in units of the greatest coordinate. */
double distance(const Handle(Geom_BSplineSurface) & got, const View &want)
{
    double most = 0, size = 0;

    for (const gp_Pnt &p : want.points)
        size = std::max(size, p.XYZ().Modulus());
    for (int i = 0; i <= 11; i++)
        for (int j = 0; j <= 11; j++)
            most = std::max(most, got->Value(i / 11.0, j / 11.0).Distance(point(want, i / 11.0, j / 11.0)));
    return most / size;
}

void compare(const TopoDS_Face &face, const View &want, const std::string &name)
{
    TopLoc_Location place;
    const Handle(Geom_BSplineSurface) s = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face, place));

    told(!s.IsNull(), name + ": a B-spline surface");
    if (s.IsNull())
        return;
    told(place.IsIdentity() && s->UDegree() == want.p && s->VDegree() == want.q, name + ": degrees");
    told(same_knots(s->UKnotSequence(), want.u) && same_knots(s->VKnotSequence(), want.v), name + ": knots, bit for bit");
    told(same_net(s, want), name + ": poles and weights, bit for bit");
    /* Two evaluations of (p+1)(q+1) terms, each term a dozen roundings: 2^-46 is generous for bicubic patches and catches any mistake. */
    told(distance(s, want) <= 0x1p-46, name + ": points");
}

int run(const char *iges, const char *surface)
{
    json_error_t error;
    json_t *const root = json_load_file(surface, 0, &error);
    IGESControl_Reader reader;
    int faces = 0;

    if (!root) {
        std::fprintf(stderr, "%s:%d: %s\n", surface, error.line, error.text);
        return 2;
    }
    Interface_Static::SetIVal("read.iges.bspline.continuity", 0);   /* as written: do not cut at knots of low continuity */
    told(reader.ReadFile(iges) == IFSelect_RetDone, "the file is read");
    told(reader.TransferRoots() == 2, "two roots");
    const TopoDS_Shape shape = reader.OneShape();
    for (TopExp_Explorer x(shape, TopAbs_FACE); x.More() && faces < 2; x.Next(), faces++)
        compare(TopoDS::Face(x.Current()), view_of(root, faces ? "top" : "bottom"), faces ? "top" : "bottom");
    told(faces == 2, "two faces");
    json_decref(root);
    return failed;
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    Message::DefaultMessenger()->ChangePrinters().Clear();
    try {
        return run(argv[1], argv[2]);
    } catch (const Standard_Failure &e) {
        std::printf("FAIL iges_occt %s\n", e.GetMessageString());
        return 1;
    }
}
