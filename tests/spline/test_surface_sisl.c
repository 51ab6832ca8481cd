/* spline/surface against SISL: another library's points and derivatives. */
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include "etalon/spline/surface.h"
#include "sisl_peer.h"
#include <stdlib.h>

enum { DEGREE = 4, MOST = 10 };

static bool draw(gen *g, et_surface *s, bool rational)
{
    size_t p = 1 + (size_t)gen_upto(g, DEGREE - 1), q = 1 + (size_t)gen_upto(g, DEGREE - 1), nu = p + 1 + (size_t)gen_upto(g, 4),
           nv = q + 1 + (size_t)gen_upto(g, 4);
    if (et_surface_new(s, p, q, nu, nv, rational) != ET_OK) {
        return false;
    }
    bool ok = peer_knots(g, s->u, nu + p + 1, p) && peer_knots(g, s->v, nv + q + 1, q);
    gen_points(g, &s->points[0].x, nu * nv);
    for (size_t i = 0; rational && i < nu * nv; i++) {
        s->weights[i] = gen_real(g, 0.25, 4.0);
    }
    gen_note(g, "p = %zu, q = %zu, %zu x %zu, %s", p, q, nu, nv, rational ? "rational" : "polynomial");
    if (!ok) {
        et_surface_free(s);
    }
    return ok;
}

static double coordinate(et_vec3 P, int a)
{
    return a == 0 ? P.x : a == 1 ? P.y : P.z;
}

/* SISL's first parameter runs fastest. */
static SISLSurf *peer_of(const et_surface *s)
{
    double h[4 * MOST * MOST];
    size_t dim = s->weights ? 4 : 3;
    for (size_t i = 0; i < s->nu; i++) {
        for (size_t j = 0; j < s->nv; j++) {
            double w = s->weights ? s->weights[i * s->nv + j] : 1.0, *to = h + dim * (j * s->nu + i);
            to[dim - 1] = w;
            for (int a = 0; a < 3; a++) {
                to[a] = w * coordinate(s->points[i * s->nv + j], a);
            }
        }
    }
    return newSurf((int)s->nu, (int)s->nv, (int)s->p + 1, (int)s->q + 1, s->u, s->v, h, s->weights ? 2 : 1, 3, 1);
}

/* The sum of the magnitudes of all terms of the derivative k times in u and l times in v of the numerator's coordinate a (3: the denominator). */
static double magnitude(const et_surface *s, double u, double v, size_t k, size_t l, int a)
{
    double M[REF_KNOTS], L[REF_KNOTS], size = 0.0;
    peer_magnitudes(M, s->u, s->nu + s->p + 1, s->p, u, k);
    peer_magnitudes(L, s->v, s->nv + s->q + 1, s->q, v, l);
    for (size_t i = 0; i < s->nu * s->nv; i++) {
        double w = s->weights ? s->weights[i] : 1.0;
        size += M[i / s->nv] * L[i % s->nv] * fabs(a == 3 ? w : w * coordinate(s->points[i], a));
    }
    return size;
}

/* S, S_u, S_v, S_uu, S_uv, S_vv: the same order in both. */
verdict prop_surface_ders_sisl(gen *g)
{
    static const size_t ku[6] = { 0, 1, 0, 2, 1, 0 }, kv[6] = { 0, 0, 1, 0, 1, 2 };
    et_surface s;
    et_vec3 D[6];
    double E[18], normal[3], at[2];
    int left[2] = { 0, 0 }, status = -1;
    if (!draw(g, &s, false)) {
        return SKIP;
    }
    SISLSurf *peer = peer_of(&s);
    size_t n = et_surface_work(&s);
    double *work = et_size_array(n, sizeof(double));
    at[0] = peer_coarse(gen_parameter(g, s.u, s.nu + s.p + 1, s.p));
    at[1] = peer_coarse(gen_parameter(g, s.v, s.nv + s.q + 1, s.q));
    et_surface_ders(D, &s, at[0], at[1], work, n);
    s1421(peer, 2, at, left, left + 1, E, normal, &status);
    bool ok = gen_check(g, status >= 0, "SISL: status %d", status);
    for (size_t k = 0; ok && k < 6; k++) {
        for (int a = 0; ok && a < 3; a++) {
            double bound = peer_slack(s.p + s.q, ku[k] + kv[k]) * magnitude(&s, at[0], at[1], ku[k], kv[k], a) + 0x1p-700;
            double got = coordinate(D[k], a), want = E[3 * k + (size_t)a];
            ok = gen_check(g, fabs(got - want) <= bound, "derivative %zu at (%a, %a), coordinate %d: %a, SISL %a", k, at[0], at[1], a, got, want);
        }
    }
    freeSurf(peer);
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_surface_point_sisl(gen *g)
{
    et_surface s;
    double E[3], at[2];
    int left[2] = { 0, 0 }, status = -1;
    if (!draw(g, &s, true)) {
        return SKIP;
    }
    SISLSurf *peer = peer_of(&s);
    size_t n = et_surface_work(&s);
    double *work = et_size_array(n, sizeof(double));
    at[0] = peer_coarse(gen_parameter(g, s.u, s.nu + s.p + 1, s.p));
    at[1] = peer_coarse(gen_parameter(g, s.v, s.nv + s.q + 1, s.q));
    et_vec3 S = et_surface_point(&s, at[0], at[1], work, n);
    s1424(peer, 0, 0, at, left, left + 1, E, &status);
    bool ok = gen_check(g, status >= 0, "SISL: status %d", status);
    for (int a = 0; ok && a < 3; a++) {   /* of the numerator, and of the denominator, which is 1/4 at least, times the point */
        double size = magnitude(&s, at[0], at[1], 0, 0, a) + magnitude(&s, at[0], at[1], 0, 0, 3) * fabs(E[a]);
        double bound = 4.0 * peer_slack(s.p + s.q, 0) * size + 0x1p-700;
        ok = gen_check(g, fabs(coordinate(S, a) - E[a]) <= bound, "at (%a, %a), coordinate %d: %a, SISL %a", at[0], at[1], a, coordinate(S, a), E[a]);
    }
    freeSurf(peer);
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
