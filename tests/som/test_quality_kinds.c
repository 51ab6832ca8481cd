/* som/quality: 2^e times as far, and points in another order. */
#include "etalon/som/quality.h"
#include "etalon/base/real.h"
#include "gen.h"
#include <math.h>

enum { SIDE = 5, CLASSES = 2 * SIDE * SIDE, POINTS = 40 };

/* Errors 2^e times as great, the topographic one the same; of points in another order only the mean's roundings differ: 19 of a sum of less than
 * 128. */
verdict prop_quality_of_scaled(gen *g);
verdict prop_quality_of_scaled(gen *g)
{
    const et_doublenet net = {gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)};
    const size_t nov = et_doublenet_nov(net), n = gen_between(g, 1, POINTS);
    const int e = (int)gen_upto(g, 40);
    et_vec3 w[CLASSES], p[POINTS], r[POINTS];
    et_som_quality q, turned, large;
    bool ok;

    gen_points(g, &w[0].x, nov);
    gen_points(g, &p[0].x, n);
    for (size_t i = 0; i < n; i++)
        r[n - 1 - i] = p[i];
    ok = gen_check(g, et_quality_of(&q, w, nov, net, p, n) == ET_OK && et_quality_of(&turned, w, nov, net, r, n) == ET_OK, "computed");
    ok = ok && gen_check(g, turned.te == q.te && turned.min_error == q.min_error && turned.max_error == q.max_error, "another order");
    ok = ok && gen_check(g, fabs(turned.qe - q.qe) <= 2 * 20 * ET_UNIT * q.qe, "qe %a, in another order %a", q.qe, turned.qe);
    for (size_t k = 0; k < 3 * nov; k++)
        (&w[0].x)[k] = ldexp((&w[0].x)[k], e);
    for (size_t k = 0; k < 3 * n; k++)
        (&p[0].x)[k] = ldexp((&p[0].x)[k], e);
    ok = ok && gen_check(g, et_quality_of(&large, w, nov, net, p, n) == ET_OK, "computed");
    ok = ok && gen_check(g, large.te == q.te && large.qe == ldexp(q.qe, e) && large.min_error == ldexp(q.min_error, e) &&
            large.max_error == ldexp(q.max_error, e),
                         "2^%d times: qe %a, not %a", e, large.qe, ldexp(q.qe, e));
    return ok ? PASS : FAIL;
}
