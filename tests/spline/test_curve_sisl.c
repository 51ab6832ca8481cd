/* spline/curve against SISL: another library's points and derivatives. */
#include "etalon/base/size.h"
#include "etalon/spline/curve.h"
#include "etalon/spline/knots.h"
#include "sisl_peer.h"
#include <stdlib.h>

enum { DEGREE = 6, MOST = 16, ORDER = 3 };

static bool draw(gen *g, et_curve *c, bool rational)
{
    size_t p = 1 + (size_t)gen_upto(g, DEGREE - 1), n = p + 1 + (size_t)gen_upto(g, 8);
    if (et_curve_new(c, p, n, rational) != ET_OK) {
        return false;
    }
    bool ok = peer_knots(g, c->u, n + p + 1, p);
    gen_points(g, &c->points[0].x, n);
    for (size_t i = 0; rational && i < n; i++) {
        c->weights[i] = gen_real(g, 0.25, 4.0);
    }
    gen_note(g, "p = %zu, n = %zu, %s", p, n, rational ? "rational" : "polynomial");
    if (!ok) {
        et_curve_free(c);
    }
    return ok;
}

static SISLCurve *peer_of(const et_curve *c)
{
    double h[4 * MOST];
    size_t dim = c->weights ? 4 : 3;
    for (size_t i = 0; i < c->n; i++) {
        double w = c->weights ? c->weights[i] : 1.0;
        h[dim * i] = w * c->points[i].x;
        h[dim * i + 1] = w * c->points[i].y;
        h[dim * i + 2] = w * c->points[i].z;
        h[dim * i + dim - 1] = c->weights ? w : h[dim * i + 2];
    }
    return newCurve((int)c->n, (int)c->p + 1, c->u, h, c->weights ? 2 : 1, 3, 1);
}

static double coordinate(et_vec3 P, int a)
{
    return a == 0 ? P.x : a == 1 ? P.y : P.z;
}

/* The sum of the magnitudes of all terms of the k-th derivative of the numerator's coordinate a; of the denominator for a == 3. */
static double magnitude(const et_curve *c, double x, size_t k, int a)
{
    double M[REF_KNOTS], size = 0.0;
    peer_magnitudes(M, c->u, c->n + c->p + 1, c->p, x, k);
    for (size_t i = 0; i < c->n; i++) {
        double w = c->weights ? c->weights[i] : 1.0;
        size += M[i] * fabs(a == 3 ? w : w * coordinate(c->points[i], a));
    }
    return size;
}

/* At a knot inside, SISL is asked for the limit from the right, which is ours. */
verdict prop_curve_ders_sisl(gen *g)
{
    et_curve c;
    et_vec3 D[ORDER + 1];
    double E[3 * (ORDER + 1)];
    int left = 0, status = -1;
    if (!draw(g, &c, false)) {
        return SKIP;
    }
    SISLCurve *peer = peer_of(&c);
    size_t n = et_curve_work(&c, ORDER), d = (size_t)gen_upto(g, ORDER);
    double *work = et_size_array(n, sizeof(double)), x = peer_coarse(gen_parameter(g, c.u, c.n + c.p + 1, c.p));
    et_curve_ders(D, d, &c, x, work, n);
    s1221(peer, (int)d, x, &left, E, &status);
    bool ok = gen_check(g, status >= 0, "SISL: status %d", status);
    for (size_t k = 0; ok && k <= d; k++) {
        for (int a = 0; ok && a < 3; a++) {
            double bound = peer_slack(c.p, k) * magnitude(&c, x, k, a) + 0x1p-700, got = coordinate(D[k], a), want = E[3 * k + (size_t)a];
            ok = gen_check(g, fabs(got - want) <= bound, "derivative %zu at %a, coordinate %d: %a, SISL %a", k, x, a, got, want);
        }
    }
    freeCurve(peer);
    free(work);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

verdict prop_curve_point_sisl(gen *g)
{
    et_curve c;
    double E[3];
    int left = 0, status = -1;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    SISLCurve *peer = peer_of(&c);
    size_t n = et_curve_work(&c, 0);
    double *work = et_size_array(n, sizeof(double)), x = peer_coarse(gen_parameter(g, c.u, c.n + c.p + 1, c.p));
    et_vec3 C = et_curve_point(&c, x, work, n);
    s1221(peer, 0, x, &left, E, &status);
    bool ok = gen_check(g, status >= 0, "SISL: status %d", status);
    for (int a = 0; ok && a < 3; a++) {   /* of the numerator, and of the denominator, which is 1/4 at least, times the point */
        double bound = 4.0 * peer_slack(c.p, 0) * (magnitude(&c, x, 0, a) + magnitude(&c, x, 0, 3) * fabs(E[a])) + 0x1p-700;
        ok = gen_check(g, fabs(coordinate(C, a) - E[a]) <= bound, "at %a, coordinate %d: %a, SISL %a", x, a, coordinate(C, a), E[a]);
    }
    freeCurve(peer);
    free(work);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}
