#include "etalon/fit/enclosure.h"
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include "fit/enclosure_parts.h"
#include "fit/fit_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- what is asked ---- */

/*@ requires size:  1 <= n && 1 <= nu;
    requires valid: \valid_read(u + (0 .. nu - 1)) && (t == \null || \valid_read(t + (0 .. n - 1)));
    assigns  \nothing;
    ensures  truth: \result == 0 || \result == 1;
    ensures  given: \result == 1 ==> t != \null;
*/
static int parameters_valid(const double *t, size_t n, const double *u, size_t nu)
{
    if (t == NULL || t[0] != u[0] || t[n - 1] != u[nu - 1])
        return 0;
    /*@ loop invariant place: 1 <= i <= n;
        loop assigns i;
        loop variant n - i;
    */
    for (size_t i = 1; i < n; i++)
        if (!(t[i - 1] <= t[i]))
            return 0;
    return 1;
}

static int view_valid(const et_fit *fit, size_t w, const et_fit_options *o)
{
    const et_surface *s = &fit->shell.view[w];

    return s->p == o->p && s->q == o->q && s->nu == o->control.nx && s->nv == o->control.ny && s->weights == NULL &&
           et_knots_clamped(s->u, s->nu + s->p + 1, s->p) && et_knots_clamped(s->v, s->nv + s->q + 1, s->q) &&
           parameters_valid(fit->s[w], fit->data.nx, s->u, s->nu + s->p + 1) && parameters_valid(fit->r[w], fit->data.ny, s->v, s->nv + s->q + 1);
}

/*@ requires valid: \valid_read(a + (0 .. n - 1)) && \valid_read(b + (0 .. n - 1));
    assigns  \nothing;
    ensures  truth: \result == 0 || \result == 1;
*/
static int same(const double *a, const double *b, size_t n)
{
    /*@ loop invariant place: i <= n;
        loop assigns i;
        loop variant n - i;
    */
    for (size_t i = 0; i < n; i++)
        if (a[i] != b[i])
            return 0;
    return 1;
}

/* Whether both views have the same parameters and knots. */
static int shared(const et_fit *fit)
{
    const et_surface *a = &fit->shell.view[0], *b = &fit->shell.view[1];

    return same(a->u, b->u, a->nu + a->p + 1) && same(a->v, b->v, a->nv + a->q + 1) && same(fit->s[0], fit->s[1], fit->data.nx) &&
           same(fit->r[0], fit->r[1], fit->data.ny);
}

static et_status check(const et_fit *fit, size_t nov, const et_fit_options *o, et_message *message)
{
    const et_doublenet n = fit->data;

    if (!et_doublenet_valid(n) || nov != et_doublenet_nov(n))
        return et_status_fail(message, ET_EINVAL, "%zu points are not the classes of a double net %zux%zu", nov, n.nx, n.ny);
    if (et_fit_name(o->approach) == NULL || (unsigned)o->corners > ET_CORNERS_INTERPOLATED)
        return et_status_fail(message, ET_EINVAL, "a fit option is not one of its enumeration");
    if (!et_shell_valid(&fit->shell) || o->p < 1 || o->q < 1 || !view_valid(fit, 0, o) || !view_valid(fit, 1, o))
        return et_status_fail(message, ET_EINVAL, "the fit's shell or parameters are not those of its options");
    if (o->approach != ET_FIT_CONVENTIONAL && !shared(fit))
        return et_status_fail(message, ET_EINVAL, "the views' parameters or knots differ, where the approach shares them");
    return ET_OK;
}

/* ---- scaling ---- */

/* Each coordinate is divided by a power of two so that the largest is about 1: no product over- or underflows by the data's unit. */
static void scale(enclosure_job *k, const et_vec3 *data, size_t nov)
{
    for (size_t c = 0; c < 3; c++) {
        double most = 0;
        for (size_t i = 0; i < nov; i++)
            most = fmax(most, fabs((&data[i].x)[c]));
        frexp(most, &k->exponent[c]); /* 0 of 0 */
        for (size_t w = 0; w < 2; w++)
            for (size_t at = 0; at < k->data.nx * k->data.ny; at++) {
                const double d = (&data[et_doublenet_class(k->data, w, at / k->data.ny, at % k->data.ny) - 1].x)[c];
                k->D[w][3 * at + c] = ldexp(d, -k->exponent[c]);
                if (ldexp(k->D[w][3 * at + c], k->exponent[c]) != d)
                    k->lost[c] = ENCLOSURE_TINY; /* half of 2^-1074 at most */
            }
    }
}

static et_status start(enclosure_job *k, const et_fit *fit, const et_vec3 *data, size_t nov, const et_fit_options *o, et_message *message)
{
    et_status status = check(fit, nov, o, message);

    memset(k, 0, sizeof *k);
    if (status != ET_OK)
        return status;
    k->fit = fit;
    k->options = o;
    k->message = message;
    k->fixed = o->corners == ET_CORNERS_INTERPOLATED || (o->corners == ET_CORNERS_DEFAULT && o->approach == ET_FIT_IMPROVED);
    k->data = fit->data;
    k->control = o->control;
    for (size_t w = 0; w < 2; w++) {
        k->D[w] = et_size_array(k->data.nx * k->data.ny, 3 * sizeof *k->D[w]);
        if (k->D[w] == NULL)
            status = et_status_fail(message, ET_ENOMEM, "%s", et_status_text(ET_ENOMEM));
    }
    if (status == ET_OK)
        scale(k, data, nov);
    return status;
}

static void stop(enclosure_job *k)
{
    free(k->D[0]);
    free(k->D[1]);
}

/* ---- rounding ---- */

/* x + radius < half the gap to the next double, x - radius > minus half the gap to the last one, x = hi + lo being P's distance from the exact
 * value's middle: then P is the exact value rounded to nearest, whatever is done with ties.  The slack covers hi for x (3 u^2 + u) and the sums'
 * roundings. */
static int proved(double P, et_dd x, double radius, int exponent)
{
    const double scaled = ldexp(P, -exponent), above = nextafter(P, HUGE_VAL) - P, below = P - nextafter(P, -HUGE_VAL);
    const double up = ldexp(isfinite(above) ? above : below, -exponent - 1), down = ldexp(isfinite(below) ? below : above, -exponent - 1);
    const double d = et_dd_sub(x, (et_dd){scaled, 0}).hi, slack = (fabs(d) + radius) * 0x1p-49;

    if (radius == 0) /* only of a coordinate that is zero throughout */
        return P == 0;
    if (!(up > ENCLOSURE_TINY) || !(down > ENCLOSURE_TINY)) /* what scaling may have rounded proves nothing */
        return 0;
    return d + radius + slack < up && -d + radius + slack < down;
}

/* The double nearest to x 2^exponent: hi, but where that is subnormal it may be rounded twice. */
static double nearest(et_dd x, double radius, int exponent)
{
    const double P = ldexp(x.hi, exponent), above = nextafter(P, HUGE_VAL), below = nextafter(P, -HUGE_VAL);

    if (fabs(P) < 0x1p-1021 && !proved(P, x, radius, exponent))
        return proved(above, x, radius, exponent) ? above : proved(below, x, radius, exponent) ? below : P + 0.0;
    return P + 0.0; /* no negative zero */
}

/* |P - exact| from above: the difference within 3 u^2 + u, its sum with the radius, and both back in the data's unit. */
static double distance(double P, et_dd x, double radius, int exponent)
{
    const double scaled = ldexp(P, -exponent), d = fabs(et_dd_sub(x, (et_dd){scaled, 0}).hi);
    const double size = nextafter(ldexp((fabs(x.hi) + radius) * (1 + 0x1p-51), exponent), HUGE_VAL);
    const double lost = ldexp(scaled, exponent) == P ? 0 : ENCLOSURE_TINY, sum = (d * (1 + 0x1p-51) + (radius + lost)) * (1 + 0x1p-51);
    const double back = ldexp(sum, exponent);

    if (isinf(scaled)) /* beside P the solution is next to nothing */
        return (fabs(P) + size) * (1 + 0x1p-51);
    return ldexp(back, -exponent) < sum ? nextafter(back, HUGE_VAL) : back;
}

/* ---- delivery ---- */

static double corner_of(const enclosure_job *k, const et_vec3 *data, size_t at, size_t c)
{
    const size_t i = at / k->control.ny, j = at % k->control.ny;

    return (&data[(i != 0 ? (k->data.nx - 1) * k->data.ny : 0) + (j != 0 ? k->data.ny - 1 : 0)].x)[c];
}

static int stands(const enclosure_job *k, size_t at)
{
    return k->fixed && fit_is_corner(k->control, at / k->control.ny, at % k->control.ny);
}

/* Radii around the points P[view], and how many coordinates are not proved; e is new. */
static void enclose(et_enclosure *e, const enclosure_job *k, const enclosure_solution *x, et_vec3 *const P[2], const et_vec3 *data)
{
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < e->count; at++)
            for (size_t c = 0; c < 3; c++) {
                const double p = (&P[w][at].x)[c];
                const et_dd v = x->x[w][3 * at + c];
                const double r = x->radius[w][3 * at + c];
                double *radius = &(&e->radius[w][at].x)[c];
                if (stands(k, at)) {
                    const double d = corner_of(k, data, at, c);
                    *radius = p == d ? 0 : nextafter(fabs(p - d), HUGE_VAL);
                    e->undecided += p != d;
                } else {
                    *radius = distance(p, v, r, k->exponent[c]);
                    e->undecided += !proved(p, v, r, k->exponent[c]);
                }
            }
}

static et_status enclosure_new(et_enclosure *e, size_t count, et_message *message)
{
    memset(e, 0, sizeof *e);
    e->count = count;
    e->radius[0] = et_size_array(count, sizeof *e->radius[0]);
    e->radius[1] = et_size_array(count, sizeof *e->radius[1]);
    if (e->radius[0] != NULL && e->radius[1] != NULL)
        return ET_OK;
    et_enclosure_free(e);
    return et_status_fail(message, ET_ENOMEM, "%s", et_status_text(ET_ENOMEM));
}

void et_enclosure_free(et_enclosure *enclosure)
{
    free(enclosure->radius[0]);
    free(enclosure->radius[1]);
    memset(enclosure, 0, sizeof *enclosure);
}

static et_status make(et_enclosure *made, const enclosure_job *k, const et_vec3 *data)
{
    et_vec3 *const P[2] = {k->fit->shell.view[0].points, k->fit->shell.view[1].points};
    enclosure_solution x;
    et_status status = enclosure_solve(&x, k);

    if (status != ET_OK)
        return status;
    status = enclosure_new(made, k->control.nx * k->control.ny, k->message);
    if (status == ET_OK) {
        enclose(made, k, &x, P, data);
        made->condition = x.norm > 0 ? x.norm * x.inverse : 1;
        status = enclosure_backward(&made->backward, k, &x);
        if (status != ET_OK) {
            et_enclosure_free(made);
            et_status_fail(k->message, status, "%s", et_status_text(status));
        }
    }
    enclosure_solution_free(&x);
    return status;
}

et_status et_enclosure_make(et_enclosure *enclosure, const et_fit *fit, const et_vec3 *data, size_t nov, const et_fit_options *options,
                            et_message *message)
{
    enclosure_job k;
    et_enclosure made;
    et_status status = start(&k, fit, data, nov, options, message);

    if (status == ET_OK)
        status = make(&made, &k, data);
    if (status == ET_OK)
        *enclosure = made;
    stop(&k);
    return status;
}

/* ---- refinement ---- */

/* The nearest doubles; ET_EFORMAT where they are past the greatest. */
static et_status round_points(et_vec3 *const P[2], const enclosure_job *k, const enclosure_solution *x, const et_vec3 *data)
{
    for (size_t w = 0; w < 2; w++)
        for (size_t at = 0; at < k->control.nx * k->control.ny; at++)
            for (size_t c = 0; c < 3; c++) {
                double *p = &(&P[w][at].x)[c];
                *p = stands(k, at) ? corner_of(k, data, at, c) : nearest(x->x[w][3 * at + c], x->radius[w][3 * at + c], k->exponent[c]);
                if (!isfinite(*p))
                    return et_status_fail(k->message, ET_EFORMAT, "the control points overflow: the data are too large");
            }
    return ET_OK;
}

/* Everything that can fail, in a copy of the fit. */
static et_status refine(et_fit *copy, et_enclosure *made, enclosure_job *k, const et_vec3 *data)
{
    et_vec3 *const P[2] = {copy->shell.view[0].points, copy->shell.view[1].points};
    enclosure_solution x;
    et_status status = enclosure_solve(&x, k);

    if (status != ET_OK)
        return status;
    status = round_points(P, k, &x, data);
    if (status == ET_OK)
        status = enclosure_new(made, k->control.nx * k->control.ny, k->message);
    if (status == ET_OK) {
        enclose(made, k, &x, P, data);
        made->condition = x.norm > 0 ? x.norm * x.inverse : 1;
        k->fit = copy;
        status = enclosure_backward(&made->backward, k, &x);
        if (status != ET_OK) {
            et_enclosure_free(made);
            et_status_fail(k->message, status, "%s", et_status_text(status));
        }
    }
    enclosure_solution_free(&x);
    return status;
}

static void take_points(et_fit *fit, const et_fit *copy)
{
    for (size_t w = 0; w < 2; w++)
        memcpy(fit->shell.view[w].points, copy->shell.view[w].points, fit->shell.view[w].nu * fit->shell.view[w].nv * sizeof(et_vec3));
}

et_status et_enclosure_refine(et_fit *fit, et_enclosure *enclosure, const et_vec3 *data, size_t nov, const et_fit_options *options,
                              et_message *message)
{
    enclosure_job k;
    et_enclosure made;
    et_fit copy = *fit;
    et_status status = start(&k, fit, data, nov, options, message);

    memset(&copy.shell, 0, sizeof copy.shell);
    if (status == ET_OK && et_shell_copy(&copy.shell, &fit->shell) != ET_OK)
        status = et_status_fail(message, ET_ENOMEM, "%s", et_status_text(ET_ENOMEM));
    if (status == ET_OK)
        status = refine(&copy, &made, &k, data);
    if (status == ET_OK) {
        take_points(fit, &copy);
        if (enclosure != NULL)
            *enclosure = made;
        else
            et_enclosure_free(&made);
    }
    et_shell_free(&copy.shell);
    stop(&k);
    return status;
}
