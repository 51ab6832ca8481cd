/* What enclosures refuse, one wrong thing at a time, and numbers at the ends of the range. */
#include "fit/enclosure_parts.h"
#include "gen.h"
#include <math.h>
#include <string.h>

/* A fit of 4x5 data with 3x4 control points of degrees 1 and 2, any of its parts to be spoilt. */
typedef struct {
    et_fit fit;
    et_fit_options options;
    size_t nov;
    double t[2][2][5], u[2][2][8], weights[12];
    et_vec3 P[2][12], data[40];
} sound;

static void make_sound(sound *c, et_fit_approach approach)
{
    static const double knots[2][8] = { { 0, 0, 0.5, 1, 1 }, { 0, 0, 0, 0.5, 1, 1, 1 } };

    memset(c, 0, sizeof *c);
    c->options = et_fit_defaults();
    c->options.approach = approach;
    c->options.p = 1;
    c->options.q = 2;
    c->options.control = (et_doublenet){ 3, 4 };
    c->fit.data = (et_doublenet){ 4, 5 };
    c->nov = et_doublenet_nov(c->fit.data);
    for (size_t i = 0; i < 12; i++)
        c->weights[i] = 1;
    for (size_t i = 0; i < c->nov; i++)
        c->data[i] = (et_vec3){ (double)i, 1, (double)(i * i) };
    for (size_t w = 0; w < 2; w++) {
        memcpy(c->u[w], knots, sizeof knots);
        for (size_t i = 0; i < 5; i++) {
            c->t[w][0][i] = (double)i / 3;
            c->t[w][1][i] = (double)i / 4;
        }
        c->fit.shell.view[w] = (et_surface){ 1, 2, 3, 4, c->u[w][0], c->u[w][1], c->P[w], NULL };
        c->fit.s[w] = c->t[w][0];
        c->fit.r[w] = c->t[w][1];
    }
}

/* The status is as wanted, of both functions; a failure changes nothing. */
static bool says(gen *g, sound *c, et_status want, const char *what, size_t part)
{
    et_enclosure e, was;
    et_vec3 P[2][12];
    et_message message = { "" };
    bool ok;

    memset(&e, 0x3c, sizeof e);
    was = e;
    memcpy(P, c->P, sizeof P);
    const et_status made = et_enclosure_make(&e, &c->fit, c->data, c->nov, &c->options, &message);
    ok = gen_check(g, made == want && (made == ET_OK || message.text[0] != 0), "%s %zu: make says %d, not %d", what, part, (int)made, (int)want);
    ok = gen_check(g, made == ET_OK || memcmp(&e, &was, sizeof e) == 0, "%s %zu: changed", what, part) && ok;
    if (made == ET_OK)
        et_enclosure_free(&e);
    const et_status refined = et_enclosure_refine(&c->fit, NULL, c->data, c->nov, &c->options, &message);
    ok = gen_check(g, refined == want, "%s %zu: refine says %d, not %d", what, part, (int)refined, (int)want) && ok;
    return gen_check(g, refined == ET_OK || memcmp(P, c->P, sizeof P) == 0, "%s %zu: points changed", what, part) && ok;
}

/* One case in 300. */
verdict prop_enclosure_make_options(gen *g)
{
    sound c;
    bool ok = true;

    for (size_t a = 0; a < 3; a++) {
        const et_fit_approach approach = (et_fit_approach)a;
        make_sound(&c, approach);
        ok = says(g, &c, ET_OK, "sound", a) && ok;
        for (size_t e = 0; e < 8; e++) {
            make_sound(&c, approach);
            const size_t by = e < 4 ? 1 : SIZE_MAX;
            c.options.p += e % 4 == 0 ? by : 0;
            c.options.q += e % 4 == 1 ? by : 0;
            c.options.control.nx += e % 4 == 2 ? by : 0;
            c.options.control.ny += e % 4 == 3 ? by : 0;
            ok = says(g, &c, ET_EINVAL, "options", e) && ok;
        }
        make_sound(&c, approach);
        c.fit.shell.view[0].weights = c.fit.shell.view[1].weights = c.weights;
        ok = says(g, &c, ET_EINVAL, "weights", a) && ok;
        make_sound(&c, approach);
        c.options.approach = (et_fit_approach)-1;
        ok = says(g, &c, ET_EINVAL, "approach", a) && ok;
        make_sound(&c, approach);
        c.options.corners = (et_fit_corners)-1;
        ok = says(g, &c, ET_EINVAL, "corners", a) && ok;
        make_sound(&c, approach);
        c.fit.data = (et_doublenet){ (size_t)1 << 30, (size_t)1 << 29 }; /* not asked for before it is refused */
        ok = says(g, &c, ET_EINVAL, "data", a) && ok;
        /* Degree 0 in one direction, everything else in order. */
        for (size_t e = 0; e < 2; e++) {
            make_sound(&c, approach);
            *(e ? &c.options.q : &c.options.p) = 0;
            for (size_t w = 0; w < 2; w++) {
                *(e ? &c.fit.shell.view[w].q : &c.fit.shell.view[w].p) = 0;
                for (size_t i = 0; i < 5; i++)
                    c.u[w][e][i] = (double)i / (e ? 4 : 3);
            }
            ok = says(g, &c, ET_EINVAL, "degree 0, direction", e) && ok;
        }
    }
    return ok ? PASS : FAIL;
}

/* Knots that are not clamped at an end, parameters that do not begin or end with the domain, or come back, of each view and direction. */
/* One case in 300. */
verdict prop_enclosure_make_parameters(gen *g)
{
    sound c;
    bool ok = true;

    for (size_t e = 0; e < 4; e++) {
        const size_t w = e / 2, d = e % 2, m = d ? 5 : 4, n = d ? 4 : 3, p = d ? 2 : 1;
        for (size_t kind = 0; kind < 10; kind++) {
            make_sound(&c, ET_FIT_CONVENTIONAL);
            double *t = c.t[w][d], *u = c.u[w][d];
            if (kind == 0)
                u[0] = -0.25;
            else if (kind == 1)
                u[n + p] = 1.25;
            else if (kind == 2)
                t[0] = -0.25;
            else if (kind == 3)
                t[0] = 0.0625;
            else if (kind == 4)
                t[m - 1] = 1.25;
            else if (kind == 5)
                t[m - 1] = 0.96875;
            else if (kind == 6)
                t[1] = -0.25;
            else if (kind == 7)
                t[m - 2] = 1.25;
            else if (kind == 8)
                t[1] = t[2] + 0.0625;
            else
                *(d ? &c.fit.r[w] : &c.fit.s[w]) = NULL;
            ok = says(g, &c, ET_EINVAL, "parameters", 10 * e + kind) && ok;
        }
        make_sound(&c, ET_FIT_CONVENTIONAL);
        c.t[w][d][1] = c.t[w][d][2]; /* equal ones are in order */
        ok = says(g, &c, d ? ET_OK : ET_OK, "equal parameters", e) && ok;
    }
    return ok ? PASS : FAIL;
}

/* Improved and joint views share knots and parameters, in each place and either way; conventional ones need not. */
/* One case in 300. */
verdict prop_enclosure_make_shared(gen *g)
{
    sound c;
    bool ok = true;

    for (size_t a = 0; a < 3; a++)
        for (size_t e = 0; e < 8; e++) {
            const size_t w = e / 4, d = e % 2;
            make_sound(&c, (et_fit_approach)a);
            if (e / 2 % 2)
                c.u[w][d][d ? 3 : 2] += 0x1p-20;
            else
                c.t[w][d][2] += 0x1p-20;
            ok = says(g, &c, a == ET_FIT_CONVENTIONAL ? ET_OK : ET_EINVAL, "shared", e) && ok;
        }
    return ok ? PASS : FAIL;
}

/* Control points past the greatest double: refused, and nothing is changed. */
/* One case in 300. */
verdict prop_enclosure_refine_overflow(gen *g)
{
    sound c;
    bool ok = true;

    for (size_t a = 0; a < 3; a++)
        for (size_t m = 0; m < 3; m++) {
            make_sound(&c, (et_fit_approach)a);
            c.options.corners = ET_CORNERS_FREE;
            for (size_t i = 0; i < c.nov; i++)
                (&c.data[i].x)[m] = i % 3 == 1 ? 0x1.fffffffffffffp1023 : -0x1.fffffffffffffp1023;
            et_message message = { "" };
            const et_status status = et_enclosure_refine(&c.fit, NULL, c.data, c.nov, &c.options, &message);
            ok = gen_check(g, status == ET_EFORMAT && strcmp(message.text, "the control points overflow: the data are too large") == 0,
                           "%s: status %d, '%s'", et_fit_name((et_fit_approach)a), (int)status, message.text) && ok;
            for (size_t i = 0; i < 24; i++)
                ok = gen_check(g, c.P[i / 12][i % 12].x == 0 && c.P[i / 12][i % 12].y == 0 && c.P[i / 12][i % 12].z == 0, "changed") && ok;
        }
    return ok ? PASS : FAIL;
}

/* Parameters so near a knot that a direction by itself is proved, but what both take apart passes every number: refused. */
/* One case in 300. */
verdict prop_enclosure_make_nearest_knot(gen *g)
{
    sound c;
    bool ok = true;

    for (int h = 100; h <= 700; h += 50) {
        make_sound(&c, ET_FIT_CONVENTIONAL);
        c.options.corners = ET_CORNERS_FREE;
        c.options.control = c.fit.data = (et_doublenet){ 3, 3 };
        c.options.q = 1;
        c.nov = et_doublenet_nov(c.fit.data);
        for (size_t w = 0; w < 2; w++) {
            memcpy(c.u[w][1], c.u[w][0], sizeof c.u[w][0]);
            c.fit.shell.view[w].q = 1;
            c.fit.shell.view[w].nv = 3;
            for (size_t e = 0; e < 2; e++) {
                c.t[w][e][1] = ldexp(1, -h);
                c.t[w][e][2] = 1;
            }
        }
        /* Past 2^-1000 the data's unit decides nothing any more: radii of 2^(2 h - 106) and more are no longer numbers. */
        et_enclosure e;
        const et_status status = et_enclosure_make(&e, &c.fit, c.data, c.nov, &c.options, NULL);
        ok = gen_check(g, status == (2 * h < 900 ? ET_OK : 2 * h > 1200 ? ET_ENOCONV : status), "2^-%d: status %d", h, (int)status) && ok;
        for (size_t i = 0; status == ET_OK && i < 18; i++)
            ok = gen_check(g, e.radius[i / 9][i % 9].x > 0 && !isnan(e.radius[i / 9][i % 9].x), "2^-%d: radius %g", h, e.radius[i / 9][i % 9].x) && ok;
        if (status == ET_OK)
            et_enclosure_free(&e);
    }
    return ok ? PASS : FAIL;
}

/* Points so far from the data that their squares overflow are infinitely far, not 0. */
/* One case in 300. */
verdict prop_enclosure_make_far(gen *g)
{
    sound c;
    et_enclosure e;
    bool ok = true;

    for (int k = 400; k <= 1000; k += 50) {
        make_sound(&c, ET_FIT_JOINT);
        for (size_t i = 0; i < 24; i++)
            c.P[i / 12][i % 12].y = ldexp(1 + (double)(i % 3), k);
        if (et_enclosure_make(&e, &c.fit, c.data, c.nov, &c.options, NULL) != ET_OK)
            return FAIL;
        ok = gen_check(g, k < 500 ? e.backward > 0x1p40 && e.backward < 0x1p56 : k > 510 ? isinf(e.backward) : e.backward > 0x1p40,
                       "points of 2^%d: backward error %g", k, e.backward) && ok;
        et_enclosure_free(&e);
        make_sound(&c, ET_FIT_JOINT); /* and nearly 0 they are as far off as 0 is */
        for (size_t i = 0; i < 24; i++)
            c.P[i / 12][i % 12].y = k == 400 ? 0 : ldexp(1 + (double)(i % 3), -k);
        if (et_enclosure_make(&e, &c.fit, c.data, c.nov, &c.options, NULL) != ET_OK)
            return FAIL;
        ok = gen_check(g, e.backward > 0x1p40 && e.backward < 0x1p56, "points of 2^-%d: backward error %g", k, e.backward) && ok;
        et_enclosure_free(&e);
    }
    return ok ? PASS : FAIL;
}

/* A system with an entry that is no number is never verified, wherever it stands; nor one whose factor has a zero in its diagonal. */
/* One case in 300. */
verdict prop_enclosure_make_unverified(gen *g)
{
    static const double bad[] = { HUGE_VAL, -HUGE_VAL, NAN };
    sound c;
    enclosure_system s;
    bool ok = true;

    make_sound(&c, ET_FIT_JOINT);
    for (size_t e = 0; e < 15 * 6; e++) {
        if (enclosure_direction(&s, c.t[0][1], 5, c.u[0][1], 4, 2, 0) != ET_OK)
            return FAIL;
        *(e % 2 ? &s.a[e / 6].lo : &s.a[e / 6].hi) = bad[e / 2 % 3];
        const et_status status = enclosure_verify(&s);
        ok = gen_check(g, status == ET_ENOCONV, "entry %zu: status %d", e / 6, (int)status) && ok;
        enclosure_system_free(&s);
    }
    for (size_t j = 0; j < 4; j++) {
        if (enclosure_direction(&s, c.t[0][1], 5, c.u[0][1], 4, 2, 0) != ET_OK)
            return FAIL;
        for (size_t k = 0; k < 15; k++)
            s.a[k] = s.at[k] == j ? (et_dd){ 0, 0 } : s.a[k];
        const et_status status = enclosure_verify(&s);
        ok = gen_check(g, status == ET_ENOCONV, "column %zu of zeros: status %d", j, (int)status) && ok;
        enclosure_system_free(&s);
    }
    return ok ? PASS : FAIL;
}

/* Four parameters half way between two knots, one at the end: A'A = ((1, 1), (1, 2)), so that R is ((1, 1), (0, 1)) but for signs and T but for
 * others; entries of 1 count as others do.  Householder's method solves for columns that are off by 5 2 c u of their lengths at most (Higham 2002,
 * Th. 19.4), all of A by 2^-46 with c = 6; R by sqrt(2) cond(A) of that, T by |T|^2 of that, cond(A) = |T|^2 = 2.62: 10 times 2^-46 and a few roundings,
 * below 2^-42. */
verdict prop_enclosure_make_ones(gen *g)
{
    static const double u[4] = { 0, 0, 1, 1 }, t[5] = { 0.5, 0.5, 0.5, 0.5, 1 };
    enclosure_system s;
    bool ok = true;

    if (enclosure_direction(&s, t, 5, u, 2, 1, 0) != ET_OK)
        return FAIL;
    const et_status status = enclosure_verify(&s);
    ok = gen_check(g, status == ET_OK, "status %d", (int)status);
    for (size_t k = 0; k < 4 && ok; k += k == 1 ? 2 : 1)
        ok = gen_check(g, fabs(fabs(s.T[k]) - 1) <= 0x1p-42, "T[%zu] = %a", k, s.T[k]);
    enclosure_system_free(&s);
    return ok ? PASS : FAIL;
}

/* Degree 0: each parameter sees the interval it is in. */
verdict prop_enclosure_make_steps(gen *g)
{
    static const double u[5] = { 0, 0.25, 0.5, 0.75, 1 };
    const size_t span = (size_t)gen_upto(g, 3);
    const double x = gen_real(g, u[span], u[span + 1]);
    et_dd N[2] = { { 7, 7 }, { 7, 7 } };

    enclosure_basis(N, u, 0, span, x);
    return gen_check(g, N[0].hi == 1 && N[0].lo == 0 && N[1].hi == 7, "N = %a", N[0].hi) ? PASS : FAIL;
}
