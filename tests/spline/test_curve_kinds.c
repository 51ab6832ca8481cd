/* spline/curve: in other units: points, weights and knots times powers of two. */
#include "curves.h"
#include "etalon/spline/curve.h"

/* Coordinates times 2^e and exchanged, weights times 2^w, knots and parameter times 2^f: k-th derivatives times 2^(e - fk), every bit but for
 * underflow. */
verdict prop_curve_ders_scaled(gen *g)
{
    et_curve c, t;
    et_vec3 D[ORDER + 1], E[ORDER + 1];
    int e = (int)gen_upto(g, 40), w = (int)gen_upto(g, 40), f = (int)gen_upto(g, 20);

    if (!draw(g, &c, true) || et_curve_copy(&t, &c) != ET_OK) {
        return SKIP;
    }
    for (size_t i = 0; i < c.n; i++) {
        et_vec3 P = c.points[i];
        t.points[i] = (et_vec3){ldexp(P.y, e), -ldexp(P.z, e), ldexp(P.x, e)};
        if (c.weights) {
            t.weights[i] = ldexp(c.weights[i], w);
        }
    }
    for (size_t i = 0; i <= c.n + c.p; i++) {
        t.u[i] = ldexp(c.u[i], f);
    }
    double x = draw_x(g, &c), y = ldexp(x, f);
    size_t d = (size_t)gen_upto(g, 4), n = et_curve_work(&c, d);
    et_side side = gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
    double *work = et_size_array(n, sizeof(double));
    bool ok = gen_check(g, et_curve_valid(&t) && et_curve_work(&t, d) == n, "not valid, or more room");
    et_curve_ders_side(D, d, &c, x, side, work, n);
    et_curve_ders_side(E, d, &t, y, side, work, n);
    for (int way = 0; ok && way < 2; way++) {
        for (size_t k = 0; ok && k <= d; k++) {
            int power = e - f * (int)k;
            et_vec3 want = {ldexp(D[k].y, power), -ldexp(D[k].z, power), ldexp(D[k].x, power)};
            bool same = fabs(E[k].x - want.x) <= 0x1p-600 && fabs(E[k].y - want.y) <= 0x1p-600 && fabs(E[k].z - want.z) <= 0x1p-600;
            ok = gen_check(g, same || !isfinite(D[k].x + D[k].y + D[k].z), "derivative %zu: %a, not %a", k, E[k].x, want.x);
        }
        et_curve_ders(D, d, &c, x, work, n);
        et_curve_ders(E, d, &t, y, work, n);
    }
    et_vec3 C = point(&c, x), T = point(&t, y);
    ok = ok && gen_check(g, fabs(T.x - ldexp(C.y, e)) <= 0x1p-600 && fabs(T.z - ldexp(C.x, e)) <= 0x1p-600, "the point: %a, not %a", T.z, ldexp(C.x,
            e));
    free(work);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Inserting into, removing from and elevating the curve of points 2^e times as far gives points 2^e times as far, the tolerance being so much
 * greater. */
verdict prop_curve_insert_units(gen *g)
{
    et_curve c, t, a = {0, 0, NULL, NULL, NULL}, b = {0, 0, NULL, NULL, NULL};
    int e = (int)gen_upto(g, 40);
    size_t removed = 0, same = 0;

    if (!draw(g, &c, false) || et_curve_copy(&t, &c) != ET_OK) {
        return SKIP;
    }
    for (size_t i = 0; i < c.n; i++) {
        t.points[i] = (et_vec3){ldexp(c.points[i].x, e), ldexp(c.points[i].y, e), ldexp(c.points[i].z, e)};
    }
    double x = draw_x(g, &c), tolerance = ldexp(1.0, (int)gen_upto(g, 60) - 50);
    uint64_t kind = gen_upto(g, 2);
    et_status status = kind == 0 ? et_curve_insert(&a, &c, x, 1) : kind == 1 ? et_curve_elevate(&a, &c, 1) : et_curve_remove(&a, &removed, &c, x, 1,
            tolerance);
    et_status again = kind == 0 ? et_curve_insert(&b, &t, x, 1) : kind == 1 ? et_curve_elevate(&b, &t, 1)
                                                                            : et_curve_remove(&b, &same, &t, x, 1, ldexp(tolerance, e));
    bool ok = gen_check(g, status == again && removed == same && a.n == b.n && a.p == b.p, "statuses %d and %d", (int)status, (int)again);
    for (size_t i = 0; ok && status == ET_OK && i < a.n; i++) {
        for (int k = 0; ok && k < 3; k++) {
            double want = ldexp(coordinate(&a.points[i], k), e);
            ok = gen_check(g, fabs(coordinate(&b.points[i], k) - want) <= 0x1p-600, "control point %zu: %a, not %a", i, coordinate(&b.points[i], k),
                    want);
        }
    }
    gen_label(g, status != ET_OK ? "refused" : kind == 0 ? "inserted" : kind == 1 ? "elevated" : removed ? "removed" : "not removed");
    et_curve_free(&c);
    et_curve_free(&t);
    et_curve_free(&a);
    et_curve_free(&b);
    return ok ? PASS : FAIL;
}
