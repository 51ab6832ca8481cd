/* SISL, SINTEF's spline library. */
#include "../adapter.h"
#include <sisl.h>
#include <math.h>
#include <stdlib.h>

static const char *const sides[] = { "any", "right", "left", NULL }, *const directions[] = { "u", "v", NULL };
enum { LEFT = 2 };

/* SISL takes control points one after the other, of rational ones w P and w. */
static void homogeneous(double *to, const double *point, const list *weights, size_t k)
{
    const double w = weights->n ? weights->x[k] : 1;

    for (size_t a = 0; a < 3; a++)
        to[a] = w * point[a];
    if (weights->n)
        to[3] = w;
}

static SISLCurve *make_curve(const curve *c)
{
    const size_t width = c->weights.n ? 4 : 3;
    SISLCurve *s;
    double *x;

    if (!curve_good(c))
        return NULL;
    x = room(width * c->n);
    for (size_t k = 0; k < c->n; k++)
        homogeneous(x + width * k, c->points.x + 3 * k, &c->weights, k);
    s = newCurve((int)c->n, (int)c->p + 1, c->u.x, x, c->weights.n ? 2 : 1, 3, 1);
    if (!s)
        refuse("newCurve fails");
    return s;
}

/* The first parameter runs fastest. */
static SISLSurf *make_surface(const surface *s)
{
    const size_t width = s->weights.n ? 4 : 3;
    SISLSurf *t;
    double *x;

    if (!surface_good(s))
        return NULL;
    x = room(width * s->nu * s->nv);
    for (size_t i = 0; i < s->nu; i++)
        for (size_t j = 0; j < s->nv; j++)
            homogeneous(x + width * (j * s->nu + i), s->points.x + 3 * (i * s->nv + j), &s->weights, i * s->nv + j);
    t = newSurf((int)s->nu, (int)s->nv, (int)s->p + 1, (int)s->q + 1, s->u.x, s->v.x, x, s->weights.n ? 2 : 1, 3, 1);
    if (!t)
        refuse("newSurf fails");
    return t;
}

static void put_curve(const SISLCurve *c)
{
    const int rational = c->ikind == 2 || c->ikind == 4;

    put(c->ik - 1);
    put_list(c->et, (size_t)(c->in + c->ik));
    put_points(c->ecoef, (size_t)c->in);
    put(rational ? c->in : 0);
    for (int k = 0; rational && k < c->in; k++)
        put(c->rcoef[4 * k + 3]);
}

static void put_surface(const SISLSurf *s)
{
    const int rational = s->ikind == 2 || s->ikind == 4, n = s->in1 * s->in2;

    put(s->ik1 - 1);
    put(s->ik2 - 1);
    put_list(s->et1, (size_t)(s->in1 + s->ik1));
    put_list(s->et2, (size_t)(s->in2 + s->ik2));
    put(n);
    for (int i = 0; i < s->in1; i++)
        for (int j = 0; j < s->in2; j++)
            put_all(s->ecoef + 3 * (j * s->in1 + i), 3);
    put(rational ? n : 0);
    for (int i = 0; rational && i < s->in1; i++)
        for (int j = 0; j < s->in2; j++)
            put(s->rcoef[4 * (j * s->in1 + i) + 3]);
}

/* ---- evaluation ------------------------------------------------------------------------------------------------------------ */

static void curve_at(int ders)
{
    curve c = take_curve();
    double x = take_real(), *D;
    const size_t side = take_word(sides), d = ders ? take_count() : 0;
    SISLCurve *s = make_curve(&c);
    int left = 0, status = 0;

    if (!s)
        return;
    if (inside(&c.u, c.p, x)) {
        D = room(3 * (d + 1));
        (side == LEFT ? s1227 : s1221)(s, (int)d, x, &left, D, &status);
        if (status < 0)
            refuse("s1221 or s1227 fails");
        put_all(D, 3 * (d + 1));
    }
    freeCurve(s);
}

static void curve_point(void)
{
    curve_at(0);
}

static void curve_ders(void)
{
    curve_at(1);
}

static void surface_at(int ders, int normal)
{
    surface s = take_surface();
    double at[2], *D, N[3] = { 0, 0, 0 };
    size_t side[2] = { 0, 0 }, d = (size_t)normal, n;
    SISLSurf *t = NULL;
    int left[2] = { 0, 0 }, status = 0;

    at[0] = take_real();
    at[1] = take_real();
    for (size_t k = 0; k < 2 && !normal; k++)
        side[k] = take_word(sides);
    if (ders)
        d = take_count();
    t = make_surface(&s);
    if (!t)
        return;
    if (inside(&s.u, s.p, at[0]) && inside(&s.v, s.q, at[1])) {
        n = 3 * (d + 1) * (d + 2) / 2;
        D = room(n);
        s1422(t, (int)d, side[0] == LEFT ? -1 : 1, side[1] == LEFT ? -1 : 1, at, &left[0], &left[1], D, N, &status);
        const double length = hypot(hypot(N[0], N[1]), N[2]);
        if (status < 0 || (normal && !(length > 0)))
            refuse("s1422 fails");
        for (size_t k = 0; k < 3 && normal; k++)
            put(N[k] / length);
        if (!normal)
            put_all(D, n);
    }
    freeSurf(t);
}

static void surface_point(void)
{
    surface_at(0, 0);
}

static void surface_ders(void)
{
    surface_at(1, 0);
}

static void surface_normal(void)
{
    surface_at(0, 1);
}

/* ---- editing ---------------------------------------------------------------------------------------------------------------- */

static size_t multiplicity(const list *u, double x)
{
    size_t n = 0;

    for (size_t k = 0; k < u->n; k++)
        n += u->x[k] == x;
    return n;
}

static double *repeated(double x, size_t r)
{
    double *all = room(r + 1);

    for (size_t k = 0; k < r; k++)
        all[k] = x;
    return all;
}

static int may_insert(const list *u, size_t p, double x, size_t r)
{
    if (inside(u, p, x) && (r > p + 1 || multiplicity(u, x) + r > p + 1))
        refuse("more often than degree + 1");
    return !refused();
}

static void curve_insert(void)
{
    curve c = take_curve();
    const double x = take_real();
    const size_t r = take_count();
    SISLCurve *s = make_curve(&c), *t = NULL;
    int status = 0;

    if (!s)
        return;
    if (may_insert(&c.u, c.p, x, r)) {
        s1018(s, repeated(x, r), (int)r, &t, &status);
        if (status < 0 || !t)
            refuse("s1018 fails");
        else
            put_curve(t);
    }
    if (t)
        freeCurve(t);
    freeCurve(s);
}

static void curve_elevate(void)
{
    curve c = take_curve();
    const size_t r = take_count();
    SISLCurve *s = make_curve(&c), *t = NULL;
    int status = 0;

    if (!s)
        return;
    s1750(s, s->ik + (int)r, &t, &status);
    if (status < 0 || !t)
        refuse("s1750 fails");
    else
        put_curve(t);
    if (t)
        freeCurve(t);
    freeCurve(s);
}

static void surface_insert(void)
{
    surface s = take_surface();
    const size_t along = take_word(directions);
    const double x = take_real();
    const size_t r = take_count();
    SISLSurf *a = make_surface(&s), *b = NULL;
    int status = 0;

    if (!a)
        return;
    if (along == 0 ? may_insert(&s.u, s.p, x, r) : may_insert(&s.v, s.q, x, r)) {
        s1025(a, repeated(x, r), along == 0 ? (int)r : 0, repeated(x, r), along == 0 ? 0 : (int)r, &b, &status);
        if (status < 0 || !b)
            refuse("s1025 fails");
        else
            put_surface(b);
    }
    if (b)
        freeSurf(b);
    freeSurf(a);
}

static void surface_elevate(void)
{
    surface s = take_surface();
    const size_t along = take_word(directions), r = take_count();
    SISLSurf *a = make_surface(&s), *b = NULL;
    int status = 0;

    if (!a)
        return;
    s1387(a, a->ik1 + (along == 0 ? (int)r : 0), a->ik2 + (along == 0 ? 0 : (int)r), &b, &status);
    if (status < 0 || !b)
        refuse("s1387 fails");
    else
        put_surface(b);
    if (b)
        freeSurf(b);
    freeSurf(a);
}

/* ---- nearest points --------------------------------------------------------------------------------------------------------- */

static const double resolution = 1e-15;      /* geometric, so that the library tries its best */

static int one_point(const list *P)
{
    const list x = { 3 * P->n, P->x };

    if (P->n != 1)
        refuse("not one point");
    return reals_good(&x);
}

static double apart(const double *a, const double *b)
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* s1953 finds all closest points, single ones and, as intervals, curves of them (s1957 is faster, but does not promise to find the right one). */
static void curve_nearest(void)
{
    curve c = take_curve();
    const list P = take_points();
    SISLCurve *s = make_curve(&c);
    SISLIntcurve **intervals = NULL;
    double *x = NULL, at[3], best = 0;
    int points = 0, ncurves = 0, left = 0, status = 0;

    if (!s)
        return;
    if (one_point(&P)) {
        s1953(s, P.x, 3, resolution, resolution, &points, &x, &ncurves, &intervals, &status);
        if (status < 0 || points + ncurves == 0)
            refuse("s1953 finds nothing");
        else
            best = points > 0 ? x[0] : intervals[0]->epar1[0];
        s1221(s, 0, best, &left, at, &status);
        put(best);
        put(apart(at, P.x));
        free(x);
        freeIntcrvlist(intervals, ncurves);
    }
    freeCurve(s);
}

static void surface_nearest(void)
{
    surface s = take_surface();
    const list P = take_points();
    SISLSurf *t = make_surface(&s);
    SISLIntcurve **curves = NULL;
    double *x = NULL, at[3], normal[3];
    int points = 0, ncurves = 0, left[2] = { 0, 0 }, status = 0;

    if (!t)
        return;
    if (one_point(&P)) {
        s1954(t, P.x, 3, resolution, resolution, &points, &x, &ncurves, &curves, &status);
        if (status < 0 || points + ncurves == 0)
            refuse("s1954 finds nothing");
        else {
            double *best = points > 0 ? x : curves[0]->epar1;
            s1421(t, 0, best, &left[0], &left[1], at, normal, &status);
            put_all(best, 2);
            put(apart(at, P.x));
        }
        free(x);
        freeIntcrvlist(curves, ncurves);
    }
    freeSurf(t);
}

int main(void)
{
    static const operation operations[] = {
        { "curve_point", curve_point }, { "curve_ders", curve_ders }, { "surface_point", surface_point }, { "surface_ders", surface_ders },
        { "surface_normal", surface_normal }, { "curve_insert", curve_insert }, { "curve_elevate", curve_elevate }, { "surface_insert", surface_insert },
        { "surface_elevate", surface_elevate }, { "curve_nearest", curve_nearest }, { "surface_nearest", surface_nearest }, { NULL, NULL } };

    /* Parameters that differ by less than 10^-12 relative are one to the library (REL_PAR_RES). */
    return adapter_run("name=SISL version=4.6.0 rational=1 sides=any,left,right knot_tolerance=0x1p-36", operations);
}
