/* fit/seam: the views exchanged, in other units, and with more samples. */
#include "etalon/fit/seam.h"
#include "gen.h"
#include <math.h>

enum { SIDE = 5, DEGREE = 3 };

static bool draw(gen *g, et_shell *s)
{
    const size_t p = gen_between(g, 1, DEGREE), q = gen_between(g, 1, DEGREE);
    const et_doublenet c = {gen_between(g, p + 1, SIDE), gen_between(g, q + 1, SIDE)};

    if (et_shell_new(s, p, q, c, 0) != ET_OK)
        return false;
    for (size_t w = 0; w < 2; w++) {
        gen_knots(g, s->view[w].u, c.nx + p + 1, p);
        gen_knots(g, s->view[w].v, c.ny + q + 1, q);
        gen_points(g, &s->view[w].points[0].x, c.nx * c.ny);
    }
    return true;
}

/* The gap is as wide from the other side, 2^e times as wide where all is 2^e times as far, and with every second sample left out not wider. */
verdict prop_seam_gap_scaled(gen *g)
{
    const size_t samples = 2 * gen_upto(g, 2) + 1;
    const int e = (int)gen_upto(g, 40);
    et_seam gap, other, large, few;
    et_shell s;
    bool ok;

    if (!draw(g, &s))
        return FAIL;
    const et_shell exchanged = {{s.view[1], s.view[0]}};
    ok = gen_check(g, et_seam_gap(&gap, &s, samples) == ET_OK && et_seam_gap(&other, &exchanged, samples) == ET_OK, "measured");
    ok = ok && gen_check(g, gap.distance == other.distance && gap.u == other.u && gap.v == other.v, "gap %a, from the other side %a", gap.distance,
            other.distance);
    ok = ok && gen_check(g, et_seam_gap(&few, &s, samples / 2) == ET_OK, "measured");
    /* i/(n + 1) is 2i/(2n + 2), to the bit: the few are among the many. */
    ok = ok && gen_check(g, few.distance <= gap.distance, "fewer samples: %a, then %a", few.distance, gap.distance);
    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; k < s.view[w].nu * s.view[w].nv; k++) {
            et_vec3 *P = &s.view[w].points[k];
            *P = (et_vec3){ldexp(P->x, e), ldexp(P->y, e), ldexp(P->z, e)};
        }
    ok = ok && gen_check(g, et_seam_gap(&large, &s, samples) == ET_OK && fabs(large.distance - ldexp(gap.distance, e)) <= 0x1p-400,
            "2^%d times: %a, not %a", e,
                         large.distance, ldexp(gap.distance, e));
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}
