/* seam: knots beyond the domain, other domains, and which of several equal gaps is told. */
#include "etalon/fit/seam.h"
#include "gen.h"
#include <math.h>
#include <string.h>

/* Degree 1 or 2, four control points a side, the top view `gap` above the bottom one; knots -1/2 and 3/2 beyond the domain where ends are free.
 * Inner knots and samples are such that nothing is rounded. */
static bool plates(et_shell *s, size_t p, bool free_ends, double gap)
{
    if (et_shell_new(s, p, p, (et_doublenet){4, 4}, 0) != ET_OK)
        return false;
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; i < 4 + p + 1; i++)
            s->view[w].u[i] = s->view[w].v[i] =
                i < p ? (free_ends ? -0.5 : 0) : i > 4 ? (free_ends ? 1.5 : 1) : i == p ? 0 : i == 4 ? 1 : ldexp(1, (int)i - 4);
        for (size_t at = 0; at < 16; at++)
            s->view[w].points[at] = (et_vec3){(double)(at / 4), (double)(at % 4), w == 1 ? gap : 0};
    }
    return true;
}

static bool told(gen *g, const et_shell *s, size_t samples, double distance, double u, double v, const char *what)
{
    et_seam gap = {7, 7, 7};
    const et_status status = et_seam_gap(&gap, s, samples);

    return gen_check(g, status == ET_OK && gap.distance == distance && gap.u == u && gap.v == v, "%s: status %d, %g at (%g, %g)",
                     what, (int)status, gap.distance, gap.u, gap.v);
}

static bool refused(gen *g, et_shell *s, double *end, double x)
{
    et_seam gap = {7, 7, 7};
    const double was = *end;

    *end = x;
    const et_status status = et_seam_gap(&gap, s, 1);
    *end = was;
    return gen_check(g, status == ET_EINVAL && gap.distance == 7, "an end at %g: status %d", x, (int)status);
}

/* One case in 100. */
verdict prop_seam_gap_ends(gen *g)
{
    const size_t p = gen_between(g, 1, 2), samples = (size_t)(1 << gen_upto(g, 2)) - 1;
    et_shell s;
    bool ok;

    if (!plates(&s, p, true, 0.5))
        return FAIL;
    ok = told(g, &s, samples, 0.5, 0, 0, "free ends");
    /* Beyond the domain the views are far from each other. */
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < 2; i++) {
            et_surface *v = &s.view[w];
            ok = refused(g, &s, i ? &v->u[p] : &v->v[p], -0.25) && ok;
            ok = refused(g, &s, i ? &v->u[p] : &v->v[p], 0.125) && ok;
            ok = refused(g, &s, i ? &v->u[4] : &v->v[4], 0.875) && ok;
            ok = refused(g, &s, i ? &v->u[4] : &v->v[4], 1.25) && ok;
        }
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

/* Of equal gaps the first is told: v runs along u = 0 and u = 1, then u along v = 0 and v = 1. */
/* One case in 100. */
verdict prop_seam_gap_first(gen *g)
{
    const size_t p = gen_between(g, 1, 2), samples = (size_t)(1 << gen_upto(g, 2)) - 1;
    et_shell s;
    bool ok;

    if (!plates(&s, p, false, 0.5))
        return FAIL;
    ok = told(g, &s, samples, 0.5, 0, 0, "everywhere");
    for (size_t j = 0; j < 4; j++)
        s.view[1].points[j].z = 0;
    ok = told(g, &s, samples, 0.5, 1, 0, "not at u = 0") && ok;
    for (size_t at = 0; at < 16; at++)
        s.view[1].points[at].z = at / 4 == 0 || at / 4 == 3 || at % 4 == 0 ? 0 : 0.5;
    et_seam gap = {7, 7, 7};
    ok = gen_check(g, et_seam_gap(&gap, &s, samples) == ET_OK && gap.v == 1 && gap.u > 0 && gap.u < 1, "only at v = 1: (%g, %g)", gap.u, gap.v) && ok;
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}
