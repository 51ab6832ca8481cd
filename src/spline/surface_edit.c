#include "curve_parts.h"
#include "etalon/spline/surface.h"
#include <math.h>

/* One direction of a surface: its degree, number of control points, knots, and how many lines there are. */
typedef struct { size_t p, n, lines; const double *u; } direction;

static direction direction_of(const et_surface *s, et_direction along)
{
    return along == ET_ALONG_U ? (direction){s->p, s->nu, s->nv, s->u} : (direction){s->q, s->nv, s->nu, s->v};
}

static curve_controls controls(const et_surface *s, et_direction along)
{
    return along == ET_ALONG_U ? (curve_controls){s->points, s->weights, s->nv, 1} : (curve_controls){s->points, s->weights, 1, s->nv};
}

/* Storage for degree p and n control points along the direction. */
static et_status storage(et_surface *t, const et_surface *s, et_direction along, size_t p, size_t n)
{
    int rational = s->weights != NULL;
    return along == ET_ALONG_U ? et_surface_new(t, p, s->q, n, s->nv, rational) : et_surface_new(t, s->p, p, s->nu, n, rational);
}

static et_status load(curve_net *net, const et_surface *s, et_direction along, size_t room)
{
    curve_controls from = controls(s, along);
    direction d = direction_of(s, along);
    return curve_net_load(net, d.p, d.n, room, d.lines, d.u, &from);
}

static et_status store(et_surface *edited, et_surface *t, curve_net *net, const et_surface *s, et_direction along)
{
    curve_controls to = controls(t, along), from = controls(s, along);
    const double *across = along == ET_ALONG_U ? s->v : s->u;
    double *copy = along == ET_ALONG_U ? t->v : t->u;
    size_t count = along == ET_ALONG_U ? s->nv + s->q + 1 : s->nu + s->p + 1;
    curve_net_store(along == ET_ALONG_U ? t->u : t->v, &to, net, &from);
    for (size_t i = 0; i < count; i++) {
        copy[i] = across[i];
    }
    curve_net_free(net);
    if (!et_surface_valid(t)) {
        et_surface_free(t);
        return ET_EINVAL;
    }
    *edited = *t;
    return ET_OK;
}

static int known(et_direction along)
{
    return along == ET_ALONG_U || along == ET_ALONG_V;
}

et_status et_surface_insert(et_surface *refined, const et_surface *s, et_direction along, double x, size_t times)
{
    et_surface t;
    curve_net net;
    if (!et_surface_valid(s) || !known(along)) {
        return ET_EINVAL;
    }
    direction d = direction_of(s, along);
    if (!curve_net_insertable(d.u, d.p, d.n, x, times)) {
        return ET_EINVAL;
    }
    if (storage(&t, s, along, d.p, d.n + times) != ET_OK) {
        return ET_ENOMEM;
    }
    if (load(&net, s, along, times) != ET_OK) {
        et_surface_free(&t);
        return ET_ENOMEM;
    }
    curve_net_insert(&net, x, times);
    return store(refined, &t, &net, s, along);
}

et_status et_surface_remove(et_surface *reduced, size_t *removed, const et_surface *s, et_direction along, double x, size_t times, double tolerance)
{
    et_surface t;
    curve_net net;
    size_t count;
    if (!et_surface_valid(s) || !known(along) || !(tolerance >= 0.0) || !isfinite(tolerance)) {
        return ET_EINVAL;
    }
    direction d = direction_of(s, along);
    if (!curve_net_removable(d.u, d.p, d.n, x)) {
        return ET_EINVAL;
    }
    if (load(&net, s, along, 0) != ET_OK) {
        return ET_ENOMEM;
    }
    if (curve_net_remove(&net, &count, x, times, tolerance) != ET_OK || storage(&t, s, along, d.p, net.n) != ET_OK) {
        curve_net_free(&net);
        return ET_ENOMEM;
    }
    et_status status = store(reduced, &t, &net, s, along);
    if (status == ET_OK) {
        *removed = count;
    }
    return status;
}

et_status et_surface_elevate(et_surface *elevated, const et_surface *s, et_direction along, size_t times)
{
    et_surface t;
    curve_net net;
    if (!et_surface_valid(s) || !known(along)) {
        return ET_EINVAL;
    }
    direction d = direction_of(s, along);
    if (!et_knots_clamped(d.u, d.n + d.p + 1, d.p)) {
        return ET_EINVAL;
    }
    /* Where p + times wraps, n does, too. */
    if (storage(&t, s, along, d.p + times, curve_net_elevated(d.u, d.p, d.n, times)) != ET_OK) {
        return ET_ENOMEM;
    }
    if (load(&net, s, along, 0) != ET_OK) {
        et_surface_free(&t);
        return ET_ENOMEM;
    }
    if (curve_net_elevate(&net, times) != ET_OK) {
        curve_net_free(&net);
        et_surface_free(&t);
        return ET_ENOMEM;
    }
    return store(elevated, &t, &net, s, along);
}
