#include "curve_parts.h"
#include "etalon/spline/curve.h"
#include <math.h>
#include <string.h>

et_status et_curve_copy(et_curve *copy, const et_curve *c)
{
    et_curve t;
    et_status status = et_curve_new(&t, c->p, c->n, c->weights != NULL);
    if (status != ET_OK) {
        return status;
    }
    memcpy(t.u, c->u, (c->n + c->p + 1) * sizeof *t.u);
    memcpy(t.points, c->points, c->n * sizeof *t.points);
    if (c->weights) {
        memcpy(t.weights, c->weights, c->n * sizeof *t.weights);
    }
    *copy = t;
    return ET_OK;
}

static curve_controls controls(const et_curve *c)
{
    return (curve_controls){.points = c->points, .weights = c->weights, .step = 1};
}

static et_status load(curve_net *net, const et_curve *c, size_t room)
{
    curve_controls from = controls(c);
    return curve_net_load(net, c->p, c->n, room, 1, c->u, &from);
}

/* *edited, which has storage, from the net; both are freed if what comes out is no curve. */
static et_status store(et_curve *edited, et_curve *t, curve_net *net, const et_curve *c)
{
    curve_controls to = controls(t), from = controls(c);
    curve_net_store(t->u, &to, net, &from);
    curve_net_free(net);
    if (!et_curve_valid(t)) {
        et_curve_free(t);
        return ET_EINVAL;
    }
    *edited = *t;
    return ET_OK;
}

et_status et_curve_insert(et_curve *refined, const et_curve *c, double x, size_t times)
{
    et_curve t;
    curve_net net;
    if (!et_curve_valid(c) || !curve_net_insertable(c->u, c->p, c->n, x, times)) {
        return ET_EINVAL;
    }
    if (et_curve_new(&t, c->p, c->n + times, c->weights != NULL) != ET_OK) {
        return ET_ENOMEM;
    }
    if (load(&net, c, times) != ET_OK) {
        et_curve_free(&t);
        return ET_ENOMEM;
    }
    curve_net_insert(&net, x, times);
    return store(refined, &t, &net, c);
}

et_status et_curve_remove(et_curve *reduced, size_t *removed, const et_curve *c, double x, size_t times, double tolerance)
{
    et_curve t;
    curve_net net;
    size_t count;
    if (!et_curve_valid(c) || !curve_net_removable(c->u, c->p, c->n, x) || !(tolerance >= 0.0) || !isfinite(tolerance)) {
        return ET_EINVAL;
    }
    if (load(&net, c, 0) != ET_OK) {
        return ET_ENOMEM;
    }
    if (curve_net_remove(&net, &count, x, times, tolerance) != ET_OK || et_curve_new(&t, c->p, net.n, c->weights != NULL) != ET_OK) {
        curve_net_free(&net);
        return ET_ENOMEM;
    }
    et_status status = store(reduced, &t, &net, c);
    if (status == ET_OK) {
        *removed = count;
    }
    return status;
}

et_status et_curve_elevate(et_curve *elevated, const et_curve *c, size_t times)
{
    et_curve t;
    curve_net net;
    if (!et_curve_valid(c) || !et_knots_clamped(c->u, c->n + c->p + 1, c->p)) {
        return ET_EINVAL;
    }
    size_t n = curve_net_elevated(c->u, c->p, c->n, times);
    /* Where p + times wraps, n does, too. */
    if (et_curve_new(&t, c->p + times, n, c->weights != NULL) != ET_OK) {
        return ET_ENOMEM;
    }
    if (load(&net, c, 0) != ET_OK) {
        et_curve_free(&t);
        return ET_ENOMEM;
    }
    if (curve_net_elevate(&net, times) != ET_OK) {
        curve_net_free(&net);
        et_curve_free(&t);
        return ET_ENOMEM;
    }
    return store(elevated, &t, &net, c);
}
