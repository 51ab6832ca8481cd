// Open CASCADE Technology: Geom_BSplineCurve and Geom_BSplineSurface.
#include "../adapter.h"
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <cmath>
#include <cstdio>
#include <vector>

static const char *const sides[] = { "any", "right", "left", nullptr }, *const directions[] = { "u", "v", nullptr };
enum { ANY = 0, RIGHT = 1, LEFT = 2 };

// The library keeps different knots and how often each occurs.
struct Knots {
    std::vector<double> value;
    std::vector<int> times;
    explicit Knots(const list &u)
    {
        for (size_t k = 0; k < u.n; k++)
            if (k > 0 && u.x[k] == u.x[k - 1])
                times.back()++;
            else {
                value.push_back(u.x[k]);
                times.push_back(1);
            }
    }
    TColStd_Array1OfReal values() const
    {
        TColStd_Array1OfReal a(1, (int)value.size());
        for (size_t k = 0; k < value.size(); k++)
            a((int)k + 1) = value[k];
        return a;
    }
    TColStd_Array1OfInteger multiplicities() const
    {
        TColStd_Array1OfInteger a(1, (int)times.size());
        for (size_t k = 0; k < times.size(); k++)
            a((int)k + 1) = times[k];
        return a;
    }
    bool supported(size_t p) const
    {
        for (size_t k = 1; k + 1 < times.size(); k++)
            if ((size_t)times[k] > p)
                unsupport("inner knots of multiplicity greater than the degree");
        return !refused();
    }
};

static gp_Pnt point(const list &P, size_t k)
{
    return gp_Pnt(P.x[3 * k], P.x[3 * k + 1], P.x[3 * k + 2]);
}

static void put_xyz(const gp_XYZ &p)
{
    put(p.X());
    put(p.Y());
    put(p.Z());
}

static Handle(Geom_BSplineCurve) make(const curve &c)
{
    const Knots k(c.u);

    if (refused() || c.points.n == 0 || c.u.n == 0 || (c.weights.n && c.weights.n != c.points.n)) {
        refuse("nothing to make a curve of");
        return nullptr;
    }
    if (!k.supported(c.p))
        return nullptr;
    TColgp_Array1OfPnt P(1, (int)c.points.n);
    TColStd_Array1OfReal w(1, (int)c.points.n);
    for (size_t i = 0; i < c.points.n; i++) {
        P((int)i + 1) = point(c.points, i);
        w((int)i + 1) = c.weights.n ? c.weights.x[i] : 1;
    }
    if (c.weights.n)
        return new Geom_BSplineCurve(P, w, k.values(), k.multiplicities(), (int)c.p);
    return new Geom_BSplineCurve(P, k.values(), k.multiplicities(), (int)c.p);
}

static Handle(Geom_BSplineSurface) make(const surface &s)
{
    const Knots u(s.u), v(s.v);

    if (refused() || s.nu == 0 || s.nv == 0 || s.points.n != s.nu * s.nv || (s.weights.n && s.weights.n != s.points.n)) {
        refuse("control points, weights and knots do not fit in number");
        return nullptr;
    }
    if (!u.supported(s.p) || !v.supported(s.q))
        return nullptr;
    TColgp_Array2OfPnt P(1, (int)s.nu, 1, (int)s.nv);
    TColStd_Array2OfReal w(1, (int)s.nu, 1, (int)s.nv);
    for (size_t i = 0; i < s.nu; i++)
        for (size_t j = 0; j < s.nv; j++) {
            P((int)i + 1, (int)j + 1) = point(s.points, i * s.nv + j);
            w((int)i + 1, (int)j + 1) = s.weights.n ? s.weights.x[i * s.nv + j] : 1;
        }
    if (s.weights.n)
        return new Geom_BSplineSurface(P, w, u.values(), v.values(), u.multiplicities(), v.multiplicities(), (int)s.p, (int)s.q);
    return new Geom_BSplineSurface(P, u.values(), v.values(), u.multiplicities(), v.multiplicities(), (int)s.p, (int)s.q);
}

template <class Array> static void put_reals(const Array &a)
{
    put((double)a.Length());
    for (int k = a.Lower(); k <= a.Upper(); k++)
        put(a(k));
}

static void put_curve(const Handle(Geom_BSplineCurve) &c)
{
    put(c->Degree());
    put_reals(c->KnotSequence());
    put(c->NbPoles());
    for (int i = 1; i <= c->NbPoles(); i++)
        put_xyz(c->Pole(i).XYZ());
    put(c->IsRational() ? c->NbPoles() : 0);
    for (int i = 1; i <= c->NbPoles() && c->IsRational(); i++)
        put(c->Weight(i));
}

static void put_surface(const Handle(Geom_BSplineSurface) &s)
{
    const bool rational = s->IsURational() || s->IsVRational();
    const int n = s->NbUPoles() * s->NbVPoles();

    put(s->UDegree());
    put(s->VDegree());
    put_reals(s->UKnotSequence());
    put_reals(s->VKnotSequence());
    put(n);
    for (int i = 1; i <= s->NbUPoles(); i++)
        for (int j = 1; j <= s->NbVPoles(); j++)
            put_xyz(s->Pole(i, j).XYZ());
    put(rational ? n : 0);
    for (int i = 1; rational && i <= s->NbUPoles(); i++)
        for (int j = 1; j <= s->NbVPoles(); j++)
            put(s->Weight(i, j));
}

static bool one_point(const list &P)
{
    if (P.n != 1)
        refuse("not one point");
    return !refused();
}

// ---- evaluation -------------------------------------------------------------------------------------------------------------

// The knots (numbers from 1) between which the limit is taken, within the domain.
static void span(const list &u, size_t p, double x, size_t side, int &from, int &to)
{
    const Knots k(u);
    const double lo = u.x[p], hi = u.x[u.n - p - 1];

    from = 1;
    while (k.value[(size_t)from - 1] < lo)
        from++;
    while (k.value[(size_t)from] < hi && (side == LEFT ? k.value[(size_t)from] < x : k.value[(size_t)from] <= x))
        from++;
    to = from + 1;
}

static void curve_at(bool ders)
{
    const curve c = take_curve();
    const double x = take_real();
    const size_t side = take_word(sides), d = ders ? take_count() : 0;
    const Handle(Geom_BSplineCurve) g = make(c);
    int from = 0, to = 0;

    if (g.IsNull())
        return;
    if (x < g->FirstParameter() || x > g->LastParameter())
        refuse("outside the domain");
    span(c.u, c.p, x, side, from, to);
    for (size_t k = 0; k <= d && !refused(); k++) {
        gp_Pnt p;
        if (k == 0 && side == ANY)
            g->D0(x, p);
        else if (k == 0)
            g->LocalD0(x, from, to, p);
        put_xyz(k == 0 ? p.XYZ() : side == ANY ? g->DN(x, (int)k).XYZ() : g->LocalDN(x, from, to, (int)k).XYZ());
    }
}

static void curve_point()
{
    curve_at(false);
}

static void curve_ders()
{
    curve_at(true);
}

static void surface_at(bool ders)
{
    const surface s = take_surface();
    const double x = take_real(), y = take_real();
    const size_t side_u = take_word(sides), side_v = take_word(sides), d = ders ? take_count() : 0;
    const Handle(Geom_BSplineSurface) g = make(s);
    const bool local = side_u != ANY || side_v != ANY;
    int u[2], v[2];

    if (g.IsNull())
        return;
    double u0, u1, v0, v1;
    g->Bounds(u0, u1, v0, v1);
    if (x < u0 || x > u1 || y < v0 || y > v1)
        refuse("outside the domain");
    span(s.u, s.p, x, side_u, u[0], u[1]);
    span(s.v, s.q, y, side_v, v[0], v[1]);
    for (int total = 0; total <= (int)d && !refused(); total++)
        for (int b = 0; b <= total; b++) {
            gp_Pnt p;
            if (total == 0 && local)
                g->LocalD0(x, y, u[0], u[1], v[0], v[1], p);
            else if (total == 0)
                g->D0(x, y, p);
            put_xyz(total == 0 ? p.XYZ() : local ? g->LocalDN(x, y, u[0], u[1], v[0], v[1], total - b, b).XYZ() : g->DN(x, y, total - b, b).XYZ());
        }
}

static void surface_point()
{
    surface_at(false);
}

static void surface_ders()
{
    surface_at(true);
}

static void surface_normal()
{
    const surface s = take_surface();
    const double x = take_real(), y = take_real();
    const Handle(Geom_BSplineSurface) g = make(s);

    if (g.IsNull())
        return;
    GeomLProp_SLProps p(g, x, y, 1, 1e-300);
    if (p.IsNormalDefined())
        put_xyz(p.Normal().XYZ());
    else
        refuse("the normal is not defined");
}

// ---- editing ----------------------------------------------------------------------------------------------------------------

static int multiplicity(const list &u, double x)
{
    int n = 0;

    for (size_t k = 0; k < u.n; k++)
        n += u.x[k] == x;
    return n;
}

static bool may_insert(const list &u, size_t p, double x, size_t r)
{
    const bool inner = u.n > 2 * p + 1 && u.x[p] < x && x < u.x[u.n - p - 1];
    const size_t most = p + 1;

    if (inside(&u, p, x) && (r > most || (size_t)multiplicity(u, x) + r > most))
        refuse("more often than degree + 1");
    if (!refused() && r > 0 && (!inner || (size_t)multiplicity(u, x) + r > p))
        unsupport("knots at the ends, or more often than the degree");
    return !refused();
}

static void curve_insert()
{
    const curve c = take_curve();
    const double x = take_real();
    const size_t r = take_count();
    const Handle(Geom_BSplineCurve) g = make(c);

    if (g.IsNull() || !may_insert(c.u, c.p, x, r))
        return;
    if (r > 0)
        g->InsertKnot(x, (int)r, 0, Standard_True);
    put_curve(g);
}

static void surface_insert()
{
    const surface s = take_surface();
    const size_t along = take_word(directions);
    const double x = take_real();
    const size_t r = take_count();
    const Handle(Geom_BSplineSurface) g = make(s);

    if (g.IsNull() || !(along == 0 ? may_insert(s.u, s.p, x, r) : may_insert(s.v, s.q, x, r)))
        return;
    if (r > 0 && along == 0)
        g->InsertUKnot(x, (int)r, 0, Standard_True);
    else if (r > 0)
        g->InsertVKnot(x, (int)r, 0, Standard_True);
    put_surface(g);
}

// The number of the inner knot x, or 0.
static int knot_number(const list &u, size_t p, double x)
{
    const Knots k(u);

    for (size_t i = 1; i + 1 < k.value.size(); i++)
        if (k.value[i] == x && u.x[p] < x && x < u.x[u.n - p - 1])
            return (int)i + 1;
    refuse("no inner knot");
    return 0;
}

static void curve_remove()
{
    const curve c = take_curve();
    const double x = take_real();
    const size_t r = take_count();
    const double tolerance = take_real();
    const Handle(Geom_BSplineCurve) g = make(c);
    const int k = g.IsNull() ? 0 : knot_number(c.u, c.p, x), m = multiplicity(c.u, x);
    size_t t = 0;

    if (refused())
        return;
    while (t < r && (int)t < m && g->RemoveKnot(k, m - (int)t - 1, tolerance))
        t++;
    put((double)t);
    put_curve(g);
}

static void surface_remove()
{
    const surface s = take_surface();
    const size_t along = take_word(directions);
    const double x = take_real();
    const size_t r = take_count();
    const double tolerance = take_real();
    const Handle(Geom_BSplineSurface) g = make(s);
    const int k = g.IsNull() ? 0 : along == 0 ? knot_number(s.u, s.p, x) : knot_number(s.v, s.q, x);
    const int m = multiplicity(along == 0 ? s.u : s.v, x);
    size_t t = 0;

    if (refused())
        return;
    while (t < r && (int)t < m && (along == 0 ? g->RemoveUKnot(k, m - (int)t - 1, tolerance) : g->RemoveVKnot(k, m - (int)t - 1, tolerance)))
        t++;
    put((double)t);
    put_surface(g);
}

static void curve_elevate()
{
    const curve c = take_curve();
    const size_t r = take_count();
    const Handle(Geom_BSplineCurve) g = make(c);

    if (g.IsNull())
        return;
    g->IncreaseDegree((int)(c.p + r));
    put_curve(g);
}

static void surface_elevate()
{
    const surface s = take_surface();
    const size_t along = take_word(directions), r = take_count();
    const Handle(Geom_BSplineSurface) g = make(s);

    if (g.IsNull())
        return;
    g->IncreaseDegree((int)(s.p + (along == 0 ? r : 0)), (int)(s.q + (along == 0 ? 0 : r)));
    put_surface(g);
}

// ---- nearest points: the library finds feet of perpendiculars; ends and borders are tried besides ---------------------------

struct Nearest {
    double distance = HUGE_VAL, x = 0, y = 0;
    void offer(double d, double u, double v)
    {
        if (d < distance) {
            distance = d;
            x = u;
            y = v;
        }
    }
};

template <class Offer> static void feet(const Handle(Geom_Curve) &c, const gp_Pnt &p, Offer offer)
{
    const double ends[2] = { c->FirstParameter(), c->LastParameter() };
    GeomAPI_ProjectPointOnCurve all(p, c);

    for (double x : ends)
        offer(p.Distance(c->Value(x)), x);
    for (int k = 1; k <= all.NbPoints(); k++)
        offer(all.Distance(k), all.Parameter(k));
}

static void curve_nearest()
{
    const curve c = take_curve();
    const list P = take_points();
    const Handle(Geom_BSplineCurve) g = make(c);
    Nearest best;

    if (g.IsNull() || !one_point(P))
        return;
    feet(g, point(P, 0), [&](double d, double x) { best.offer(d, x, 0); });
    put(best.x);
    put(best.distance);
}

static void surface_nearest()
{
    const surface s = take_surface();
    const list P = take_points();
    const Handle(Geom_BSplineSurface) g = make(s);
    Nearest best;

    if (g.IsNull() || !one_point(P))
        return;
    const gp_Pnt p = point(P, 0);
    double u[2], v[2];
    g->Bounds(u[0], u[1], v[0], v[1]);
    for (double x : u)
        feet(g->UIso(x), p, [&](double d, double y) { best.offer(d, x, y); });
    for (double y : v)
        feet(g->VIso(y), p, [&](double d, double x) { best.offer(d, x, y); });
    GeomAPI_ProjectPointOnSurf all(p, g);
    for (int k = 1; k <= all.NbPoints(); k++) {
        double x, y;
        all.Parameters(k, x, y);
        best.offer(all.Distance(k), x, y);
    }
    put(best.x);
    put(best.y);
    put(best.distance);
}

// What the library throws is a refusal.
template <void f()> static void caught()
{
    try {
        f();
    } catch (const Standard_Failure &e) {
        refuse(e.DynamicType()->Name());
    }
}

int main()
{
    static const operation operations[] = {
        { "curve_point", caught<curve_point> }, { "curve_ders", caught<curve_ders> }, { "surface_point", caught<surface_point> },
        { "surface_ders", caught<surface_ders> }, { "surface_normal", caught<surface_normal> }, { "curve_insert", caught<curve_insert> },
        { "curve_remove", caught<curve_remove> }, { "curve_elevate", caught<curve_elevate> }, { "surface_insert", caught<surface_insert> },
        { "surface_remove", caught<surface_remove> }, { "surface_elevate", caught<surface_elevate> }, { "curve_nearest", caught<curve_nearest> },
        { "surface_nearest", caught<surface_nearest> }, { nullptr, nullptr } };
    char hello[160];

    // Knots closer than the machine's epsilon times their magnitude are one to the library.
    snprintf(hello, sizeof hello, "name=OCCT version=%s degree=%d rational=1 sides=any,left,right knot_tolerance=0x1p-50", OCC_VERSION_COMPLETE,
             Geom_BSplineCurve::MaxDegree());
    return adapter_run(hello, operations);
}
