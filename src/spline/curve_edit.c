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
    //@ assert same:  t.n == c->n && t.p == c->p;
    /*@ assert fresh: \separated(t.u + (0 .. c->n + c->p), c->u + (0 .. c->n + c->p)) &&
                      \separated(t.points + (0 .. c->n - 1), c->points + (0 .. c->n - 1)) &&
                      (c->weights == \null || \separated(t.weights + (0 .. c->n - 1), c->weights + (0 .. c->n - 1))); */
    memcpy(t.u, c->u, (c->n + c->p + 1) * sizeof *t.u);
    memcpy(t.points, c->points, c->n * sizeof *t.points);
    if (c->weights) {
        memcpy(t.weights, c->weights, c->n * sizeof *t.weights);
    }
    *copy = t;
    return ET_OK;
}

/*@ requires c:      \valid_read(c);
    assigns  \nothing;
    ensures  fields: \result.points == c->points && \result.weights == c->weights && \result.step == 1 && \result.across == 0;
*/
static curve_controls controls(const et_curve *c)
{
    return (curve_controls){.points = c->points, .weights = c->weights, .step = 1};
}

/*@ requires net:   \valid(net) && \valid_read(c) && \separated(net, c) && et_curve_ok((et_curve *)c) &&
                    \separated(net, c->u + (0 .. c->n + c->p));
    requires room:  c->n + room + c->p < SIZE_MAX;
    assigns  *net;
    ensures  ends:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  sizes: \result == ET_OK ==> net->p == c->p && net->n == c->n && net->lines == 1 && (net->rational != 0 <==> c->weights != \null);
    ensures  made:  \result == ET_OK ==> curve_net_made(net, c->n + room) && curve_net_apart(net, c->n + room);
    ensures  from:  \result == ET_OK ==> curve_net_from(net, c->n);
    ensures  knots: \result == ET_OK ==> curve_knots(net->u, c->n, c->p);
    ensures  same:  \result == ET_OK ==> \forall integer i; 0 <= i <= c->n + c->p ==> net->u[i] == c->u[i];
    ensures  count: \result == ET_OK ==> curve_different(net->u, c->n + c->p + 1) == curve_different(c->u, c->n + c->p + 1);
*/
static et_status load(curve_net *net, const et_curve *c, size_t room)
{
    curve_controls from = controls(c);
    return curve_net_load(net, c->p, c->n, room, 1, c->u, &from);
}

/* *edited, which has storage, from the net; both are freed if what comes out is no curve. */
/*@ requires t:      \valid(t) && \valid(edited) && \valid_read(c) && et_curve_ok((et_curve *)c) && \separated(edited, t, c) && t->n >= 1;
    requires made:   t->n + t->p < SIZE_MAX && et_numbers(t->u, t->n + t->p + 1) &&
                     et_numbers((double *)t->points, 3 * t->n) && (t->weights == \null <==> c->weights == \null) &&
                     (t->weights == \null || et_numbers(t->weights, t->n));
    requires net:    \valid_read(net) && curve_net_made(net, net->n) && curve_net_from(net, c->n) && net->n == t->n && net->p == t->p &&
                     net->lines == 1 && (net->rational != 0 <==> c->weights != \null);
    requires own:    \separated(t->u + (0 .. t->n + t->p), net->u + (0 .. net->n + net->p));
    assigns  *edited, *t, t->u[0 .. t->n + t->p], t->points[0 .. t->n - 1], t->weights[0 .. t->n - 1];
    ensures  ends:   \result == ET_OK || \result == ET_EINVAL;
    ensures  done:   \result == ET_OK ==> *edited == \old(*t) && et_curve_ok(edited);
    ensures  kept:   \result != ET_OK ==> *edited == \old(*edited);
*/
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
    //@ assert distinct: \separated(t.u + (0 .. t.n + t.p), net.u + (0 .. net.n + times + net.p));
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
    //@ assert distinct: \separated(t.u + (0 .. t.n + t.p), net.u + (0 .. net.n + net.p));
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
    if (n == SIZE_MAX || et_curve_new(&t, c->p + times, n, c->weights != NULL) != ET_OK) {
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
    //@ assert distinct: \separated(t.u + (0 .. t.n + t.p), net.u + (0 .. net.n + net.p));
    return store(elevated, &t, &net, c);
}
