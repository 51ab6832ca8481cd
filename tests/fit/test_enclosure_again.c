/* Enclosures equal to the bit to their second computation: solutions by themselves, what the functions make of them, and next to boundaries. */
#include "fit/enclosure_again.h"
#include <string.h>

/* ---- radii around given points ---- */

/* Whether every number within radius of x (in units of 2^exponent) rounds to P. */
static bool rounds_to(double P, et_dd x, double radius, int exponent)
{
    double above = nextafter(P, HUGE_VAL) - P, below = P - nextafter(P, -HUGE_VAL);
    const double d = et_dd_sub(x, whole(ldexp(P, -exponent))).hi, slack = (fabs(d) + radius) * 0x1p-49;

    if (radius == 0)
        return P == 0;
    above = isinf(above) ? below : above;
    below = isinf(below) ? above : below;
    above = ldexp(above, -exponent - 1);
    below = ldexp(below, -exponent - 1);
    return above > TINY && below > TINY && d + radius + slack < above && -d + radius + slack < below;
}

/* |P - exact| and all it may be off, in the data's unit. */
static double around(double P, et_dd x, double radius, int exponent)
{
    const double unit = ldexp(P, -exponent);
    const double off = ldexp(unit, exponent) == P ? 0 : TINY;
    const double sum = (fabs(et_dd_sub(x, whole(unit)).hi) * (1 + 0x1p-51) + (radius + off)) * (1 + 0x1p-51), back = ldexp(sum, exponent);

    if (isinf(unit))
        return (fabs(P) + nextafter(ldexp((fabs(x.hi) + radius) * (1 + 0x1p-51), exponent), HUGE_VAL)) * (1 + 0x1p-51);
    return ldexp(back, -exponent) < sum ? nextafter(back, HUGE_VAL) : back;
}

static double to_nearest(et_dd x, double radius, int exponent)
{
    const double P = ldexp(x.hi, exponent), above = nextafter(P, HUGE_VAL), below = nextafter(P, -HUGE_VAL);

    if (fabs(P) >= 0x1p-1021 || rounds_to(P, x, radius, exponent))
        return P;
    return rounds_to(above, x, radius, exponent) ? above : rounds_to(below, x, radius, exponent) ? below : P;
}

/* ---- properties ---- */

/* The solution of a job and its backward error. */
verdict prop_enclosure_make_again(gen *g)
{
    static again_answer want;
    again_case c;
    enclosure_solution x, unset;
    bool ok;

    again_draw_frame(g, &c);
    again_draw_job(g, &c);
    again_tell(g, &c);
    memset(&unset, 0x3c, sizeof unset);
    x = unset;
    const et_status wanted = again_solve(&want, &c.job), status = enclosure_solve(&x, &c.job);
    ok = gen_check(g, status == wanted, "status %d, not %d (%s; %s)", (int)status, (int)wanted, c.message.text, want.text);
    gen_label(g, wanted == ET_OK ? "solved" : wanted == ET_ERANK ? "deficient" : "no bound");
    if (!ok || status != ET_OK) {
        ok = gen_check(g, !ok || strcmp(c.message.text, want.text) == 0, "'%s', not '%s'", c.message.text, want.text) && ok;
        ok = gen_check(g, status == ET_OK || memcmp(&x, &unset, sizeof x) == 0, "set, though it failed") && ok;
        if (status == ET_OK)
            enclosure_solution_free(&x);
        return ok ? PASS : FAIL;
    }
    ok = gen_check(g, same(x.norm, want.norm) && same(x.inverse, want.inverse), "norms %a %a, not %a %a", x.norm, x.inverse, want.norm, want.inverse);
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < 3 * c.job.control.nx * c.job.control.ny; at++)
            ok = gen_check(g, same_dd(x.x[w][at], want.x[w][at]) && same(x.radius[w][at], want.radius[w][at]),
                           "view %zu, %zu: %a + %a within %a, not %a + %a within %a", w, at, x.x[w][at].hi, x.x[w][at].lo, x.radius[w][at],
                           want.x[w][at].hi, want.x[w][at].lo, want.radius[w][at]) && ok;
    again_draw_points(g, &c, &x);
    double b = -1;
    const double b_wanted = again_backward(&c.job, &want);
    ok = gen_check(g, enclosure_backward(&b, &c.job, &x) == ET_OK && same(b, b_wanted), "backward error %a, not %a", b, b_wanted) && ok;
    enclosure_solution_free(&x);
    ok = gen_check(g, x.x[0] == NULL && x.x[1] == NULL && x.radius[0] == NULL && x.radius[1] == NULL && x.norm == 0 && x.inverse == 0, "freed") && ok;
    return ok ? PASS : FAIL;
}

/* What an enclosure of the points P must be. */
static void enclose_again(et_enclosure *e, et_vec3 R[2][NODES], const again_case *c, et_vec3 P[2][NODES], const again_answer *x, const et_vec3 *data)
{
    const enclosure_job *k = &c->job;

    *e = (et_enclosure){ { R[0], R[1] }, k->control.nx * k->control.ny, 1, 0, 0 };
    for (size_t at = 0; at < 6 * e->count; at++) {
        const size_t w = at / 3 / e->count, l = at / 3 % e->count, m = at % 3, i = l / k->control.ny, j = l % k->control.ny;
        const double p = (&P[w][l].x)[m], r = x->radius[w][3 * l + m];
        const size_t corner = et_doublenet_class(k->data, 0, i ? k->data.nx - 1 : 0, j ? k->data.ny - 1 : 0) - 1;
        const double d = (&data[corner].x)[m];
        if (k->fixed && again_at_corner(k->control, i, j)) {
            (&R[w][l].x)[m] = p == d ? 0 : nextafter(fabs(p - d), HUGE_VAL);
            e->undecided += p != d;
        } else {
            (&R[w][l].x)[m] = around(p, x->x[w][3 * l + m], r, k->exponent[m]);
            e->undecided += !rounds_to(p, x->x[w][3 * l + m], r, k->exponent[m]);
        }
    }
    e->condition = x->norm > 0 ? x->norm * x->inverse : 1;
}

static bool equal(gen *g, const char *what, const et_enclosure *e, const et_enclosure *want)
{
    bool ok = gen_check(g, e->count == want->count && same(e->condition, want->condition) && same(e->backward, want->backward) &&
                               e->undecided == want->undecided,
                        "%s: condition %a, backward %a, %zu undecided, not %a, %a, %zu", what, e->condition, e->backward, e->undecided, want->condition,
                        want->backward, want->undecided);

    for (size_t at = 0; ok && at < 6 * e->count; at++) {
        const double r = (&e->radius[at / 3 / e->count][at / 3 % e->count].x)[at % 3];
        const double wanted = (&want->radius[at / 3 / e->count][at / 3 % e->count].x)[at % 3];
        ok = gen_check(g, same(r, wanted), "%s: radius %zu is %a, not %a", what, at, r, wanted);
    }
    return ok;
}

/* The rounded solution; false where it overflows. */
static bool round_again(et_vec3 P[2][NODES], const again_case *c, const again_answer *x, const et_vec3 *data)
{
    const enclosure_job *k = &c->job;
    bool finite = true;

    for (size_t at = 0; at < 6 * k->control.nx * k->control.ny; at++) {
        const size_t n = k->control.nx * k->control.ny, w = at / 3 / n, l = at / 3 % n, m = at % 3, i = l / k->control.ny, j = l % k->control.ny;
        const size_t corner = et_doublenet_class(k->data, 0, i ? k->data.nx - 1 : 0, j ? k->data.ny - 1 : 0) - 1;
        double *p = &(&P[w][l].x)[m];
        *p = k->fixed && again_at_corner(k->control, i, j) ? (&data[corner].x)[m]
                                                      : to_nearest(x->x[w][3 * l + m], x->radius[w][3 * l + m], k->exponent[m]) + 0.0;
        finite = finite && isfinite(*p);
    }
    return finite;
}

static bool as_again(gen *g, again_case *c, const et_vec3 *data)
{
    static again_answer x;
    static et_vec3 R[2][NODES], P[2][NODES];
    const size_t nov = et_doublenet_nov(c->fit.data);
    et_enclosure e, want;
    const et_status wanted = again_solve(&x, &c->job);
    et_status status = et_enclosure_make(&e, &c->fit, data, nov, &c->options, &c->message);
    bool ok = gen_check(g, status == wanted, "make: status %d, not %d", (int)status, (int)wanted);

    if (status == ET_OK && wanted == ET_OK) {
        enclose_again(&want, R, c, c->P, &x, data);
        want.backward = again_backward(&c->job, &x);
        ok = equal(g, "make", &e, &want) && ok;
    } else {
        ok = gen_check(g, strcmp(c->message.text, x.text) == 0, "make: '%s', not '%s'", c->message.text, x.text) && ok;
    }
    if (status == ET_OK)
        et_enclosure_free(&e);
    if (!ok || wanted != ET_OK)
        return ok;
    const bool finite = round_again(P, c, &x, data);
    status = et_enclosure_refine(&c->fit, &e, data, nov, &c->options, &c->message);
    ok = gen_check(g, status == (finite ? ET_OK : ET_EFORMAT), "refine: status %d, %s", (int)status, finite ? "finite" : "overflow");
    if (!finite)
        ok = gen_check(g, strcmp(c->message.text, "the control points overflow: the data are too large") == 0, "refine: '%s'", c->message.text) && ok;
    gen_label(g, finite ? "refined" : "overflow");
    if (status == ET_OK) {
        for (size_t at = 0; at < 6 * e.count; at++) {
            const size_t w = at / 3 / e.count, l = at / 3 % e.count, m = at % 3;
            const double p = (&c->P[w][l].x)[m], q = (&P[w][l].x)[m];
            ok = gen_check(g, p == q && !signbit(p) == !signbit(q), "refine: coordinate %zu is %a, not %a", at, p, q) && ok;
        }
        enclose_again(&want, R, c, P, &x, data);
        want.backward = again_backward(&c->job, &x);
        ok = equal(g, "refine", &e, &want) && ok;
        et_enclosure_free(&e);
    }
    return ok;
}

/* Both functions, whole. */
verdict prop_enclosure_refine_again(gen *g)
{
    again_case c;
    et_vec3 data[2 * NODES];

    again_draw_frame(g, &c);
    again_draw_data(g, &c, data);
    again_draw_points(g, &c, NULL);
    again_tell(g, &c);
    return as_again(g, &c, data) ? PASS : FAIL;
}

/* ---- next to a boundary ---- */

/* Three by two data, two by two control points, degree 1: parameters 0, 0, 1 and 0, 1, so that lines are fitted. */
static void draw_lines(gen *g, again_case *c)
{
    memset(c, 0, sizeof *c);
    c->fit.data = (et_doublenet){ 3, 2 };
    c->options = et_fit_defaults();
    c->options.control = (et_doublenet){ 2, 2 };
    c->options.p = c->options.q = 1;
    c->options.approach = (et_fit_approach)gen_upto(g, 2);
    c->options.corners = ET_CORNERS_FREE;
    for (size_t i = 0; i < 2; i++) {
        c->t[0][0][2] = c->t[0][1][1] = c->u[0][i][2] = c->u[0][i][3] = 1;
        c->fit.shell.view[i] = (et_surface){ 1, 1, 2, 2, c->u[0][0], c->u[0][1], c->P[i], NULL };
        c->fit.s[i] = c->t[0][0];
        c->fit.r[i] = c->t[0][1];
    }
}

static bool bottom_decided(const again_case *c, const again_answer *x)
{
    return rounds_to(c->P[0][0].x, x->x[0][0], x->radius[0][0], c->job.exponent[0]);
}

/* Two data at one parameter: their mean is as near as one likes to the middle between two doubles.  Where the proof just succeeds and where it just
 * fails is found by halving; there all must be equal. */
/* One case in 25. */
verdict prop_enclosure_refine_boundary(gen *g)
{
    static again_answer x;
    again_case c;
    et_vec3 data[2 * NODES];
    const bool negative = gen_chance(g, 2), below = gen_chance(g, 2), zero = gen_chance(g, 2);
    const double big = gen_chance(g, 2) ? 1 : 1 + 2 * (double)gen_upto(g, 100) * 0x1p-52;
    double near = 0, far = 0x1p-30;
    enum { HALVINGS = 26 };
    bool ok = true;

    draw_lines(g, &c);
    for (size_t i = 0; i < 6; i++)
        data[i] = (et_vec3){ (double)i + 1, zero ? 0 : 0.5 + (double)i, zero ? 0 : 2 };
    const size_t first = et_doublenet_class(c.fit.data, 0, 0, 0) - 1, second = et_doublenet_class(c.fit.data, 0, 1, 0) - 1;
    for (int step = 0; step < HALVINGS + 8; step++) {
        /* big / 2 and half an ulp of it, less a little: halvings first, then the doubles around */
        const double gap = below ? -0x1p-53 * (big == 1 ? 0.5 : 1) : 0x1p-53, middle = near + (far - near) / 2;
        const double less = step < HALVINGS ? middle : far + (step - HALVINGS - 4) * 0x1p-53;
        data[first].x = negative ? -big : big;
        data[second].x = gap * (1 - less) * (negative ? -1 : 1);
        c.P[0][0].x = c.P[1][0].x = (negative ? -big : big) / 2;
        again_take_job(&c, data);
        if (again_solve(&x, &c.job) != ET_OK)
            return FAIL;
        if (step < HALVINGS) {
            if (bottom_decided(&c, &x))
                far = middle;
            else
                near = middle;
            continue;
        }
        ok = as_again(g, &c, data) && ok;
    }
    return gen_check(g, ok && far < 0x1p-31, "decided from %a", far) ? PASS : FAIL;
}

/* Of the least doubles: a line through data at 0, t and 1 stands at 0 at (d0 + d1)/2 + O(t), next to the middle between two multiples of 2^-1074, so
 * near that 53 bits do not tell on which side, but the rest of a double-double does. */
verdict prop_enclosure_refine_least(gen *g)
{
    again_case c;
    et_vec3 data[2 * NODES];
    const bool normal = gen_chance(g, 3);

    draw_lines(g, &c);
    c.t[0][0][1] = ldexp(1, -(int)gen_between(g, 54, 80));
    for (size_t m = 0; m < 3; m++) {
        const bool zero = gen_chance(g, 3);
        for (size_t i = 0; i < 6; i++) {
            double *d = &(&data[i].x)[m];
            *d = (double)gen_upto(g, 40) - 20;
            if (normal) /* about the least normal double, above and below */
                *d = (gen_chance(g, 2) ? -1 : 1) * (0x1p52 + (double)gen_upto(g, 4) - 2);
            *d = zero ? 0 : ldexp(*d, -1074);
        }
    }
    again_take_job(&c, data);
    again_draw_points(g, &c, NULL);
    return as_again(g, &c, data) ? PASS : FAIL;
}
