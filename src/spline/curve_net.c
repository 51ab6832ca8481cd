#include "curve_parts.h"
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- storage ---- */

et_status curve_net_new(curve_net *net, size_t p, size_t n, size_t lines, int rational)
{
    size_t count;
    /* So many points, and their knots, have been had by whoever calls. */
    if (et_size_mul(&count, n, lines) != ET_OK) {
        return ET_ENOMEM;
    }
    curve_net t = {.p = p, .n = n, .lines = lines, .rational = rational, .u = et_size_array(n + p + 1, sizeof(double)),
                   .h = et_size_array(count, sizeof(curve_point)), .from = et_size_array(n, sizeof(size_t))};
    if (!t.u || !t.h || !t.from) {
        curve_net_free(&t);
        return ET_ENOMEM;
    }
    *net = t;
    return ET_OK;
}

void curve_net_free(curve_net *net)
{
    free(net->u);
    free(net->h);
    free(net->from);
}

/* The exponent of the greatest weight. */
static int exponent_of(const curve_controls *c, size_t n, size_t lines)
{
    int exponent;
    double most = 0.0;
    for (size_t i = 0; c->weights && i < n; i++) {
        for (size_t j = 0; j < lines; j++) {
            most = fmax(most, c->weights[i * c->step + j * c->across]);
        }
    }
    frexp(most, &exponent);
    return exponent;
}

et_status curve_net_load(curve_net *net, size_t p, size_t n, size_t room, size_t lines, const double *u, const curve_controls *c)
{
    et_status status = curve_net_new(net, p, n + room, lines, c->weights != NULL);
    if (status != ET_OK) {
        return status;
    }
    net->n = n;
    memcpy(net->u, u, (n + p + 1) * sizeof *u);
    net->exponent = exponent_of(c, n, lines);
    for (size_t i = 0; i < n; i++) {
        net->from[i] = i;
        for (size_t j = 0; j < lines; j++) {
            et_vec3 P = c->points[i * c->step + j * c->across];
            double w = c->weights ? ldexp(c->weights[i * c->step + j * c->across], -net->exponent) : 1.0;
            net->h[i * lines + j] = (curve_point){w * P.x, w * P.y, w * P.z, w};
        }
    }
    return ET_OK;
}

void curve_net_store(double *u, const curve_controls *to, const curve_net *net, const curve_controls *old)
{
    memcpy(u, net->u, (net->n + net->p + 1) * sizeof *u);
    for (size_t i = 0; i < net->n; i++) {
        for (size_t j = 0; j < net->lines; j++) {
            size_t at = i * to->step + j * to->across, before = net->from[i] * old->step + j * old->across;
            curve_point h = net->h[i * net->lines + j];
            if (net->from[i] == CURVE_COMPUTED) {
                to->points[at] = net->rational ? (et_vec3){h.x / h.w, h.y / h.w, h.z / h.w} : (et_vec3){h.x, h.y, h.z};
            } else {
                to->points[at] = old->points[before];
            }
            if (net->rational) {
                to->weights[at] = net->from[i] == CURVE_COMPUTED ? ldexp(h.w, net->exponent) : old->weights[before];
            }
        }
    }
}

/* ---- insertion ---- */

int curve_net_insertable(const double *u, size_t p, size_t n, double x, size_t times)
{
    size_t s = et_knots_multiplicity(u, n + p + 1, x);
    return x >= u[p] && x <= u[n] && (times == 0 || (s <= p && times <= p + 1 - s));
}

/* The last knot not beyond x. */
static size_t last_of(const double *u, double x)
{
    size_t k = 0;
    while (u[k + 1] <= x) {
        k++;
    }
    return k;
}

/* a P + b Q: where a and b have three roundings, five of each term. */
static curve_point combine(double a, curve_point P, double b, curve_point Q)
{
    return (curve_point){a * P.x + b * Q.x, a * P.y + b * Q.y, a * P.z + b * Q.z, a * P.w + b * Q.w};
}

/* Makes room at point i, which stands there twice now, for all lines. */
static void shift_up(curve_net *net, size_t i)
{
    size_t lines = net->lines;
    memmove(net->h + (i + 1) * lines, net->h + i * lines, (net->n - i) * lines * sizeof *net->h);
    memmove(net->from + i + 1, net->from + i, (net->n - i) * sizeof *net->from);
    net->n++;
}

/* A5.1, one knot: Q_i = a P_i + (1 - a) P_{i-1}, a = (x - u_i)/(u_{i+p} - u_i), i = k-p+1 .. k-s, from the last to the first in place. */
static void insert_once(curve_net *net, size_t k, size_t s, double x)
{
    size_t p = net->p, lines = net->lines, nu = net->n + p + 1;
    double *u = net->u;
    shift_up(net, k - s);
    for (size_t i = k - s; i + p > k; i--) {
        double width = u[i + p] - u[i], a = (x - u[i]) / width, b = (u[i + p] - x) / width;
        net->from[i] = CURVE_COMPUTED;
        for (size_t j = 0; j < lines; j++) {
            curve_point *h = net->h + i * lines + j;
            h[0] = combine(a, h[0], b, *(h - lines));
        }
    }
    memmove(u + k + 2, u + k + 1, (nu - k - 1) * sizeof *u);
    u[k + 1] = x;
}

void curve_net_insert(curve_net *net, double x, size_t times)
{
    if (times == 0) {
        return;
    }
    size_t k = last_of(net->u, x), s = et_knots_multiplicity(net->u, k + 1, x);
    for (size_t t = 0; t < times; t++) {
        insert_once(net, k + t, s + t, x);
    }
}

/* ---- removal ---- */

int curve_net_removable(const double *u, size_t p, size_t n, double x)
{
    return u[p] < x && x < u[n] && et_knots_multiplicity(u, n, x) > 0;
}

static void fill(curve_net *to, const curve_net *net)
{
    to->n = net->n;
    memcpy(to->u, net->u, (net->n + net->p + 1) * sizeof *net->u);
    memcpy(to->h, net->h, net->n * net->lines * sizeof *net->h);
    memcpy(to->from, net->from, net->n * sizeof *net->from);
}

/* sqrt(x^2 + y^2 + z^2); nothing over- or underflows that matters.  Not a number where a coordinate is infinite or not a number. */
static double length(double x, double y, double z)
{
    double most = fmax(fabs(x), fmax(fabs(y), fabs(z)));
    return most > 0.0 ? most * sqrt((x / most) * (x / most) + (y / most) * (y / most) + (z / most) * (z / most)) : fabs(x + y + z);
}

/* |w P - w' P'| + reach |w - w'|. */
static double distance(curve_point a, curve_point b, double reach)
{
    return length(a.x - b.x, a.y - b.y, a.z - b.z) + reach * fabs(a.w - b.w);
}

/* With the knot x in, P_i = a Q_i + b Q_{i-1}, a = (x - u_i)/(u_{i+p+1} - u_i) and b = 1 - a. */
typedef struct { double a, b; } shares;

static shares shares_of(const curve_net *net, size_t i, double x)
{
    double lo = net->u[i], hi = net->u[i + net->p + 1];
    return (shares){(x - lo) / (hi - lo), (hi - x) / (hi - lo)};
}

static curve_point solve(curve_point P, double known, curve_point Q, double share)
{
    return (curve_point){(P.x - known * Q.x) / share, (P.y - known * Q.y) / share, (P.z - known * Q.z) / share, (P.w - known * Q.w) / share};
}

/* From the left Q_i, which takes the place of P_i; from the right Q_{i-1}, which does, too. */
static void solve_left(curve_net *net, size_t i, double x)
{
    shares s = shares_of(net, i, x);
    net->from[i] = CURVE_COMPUTED;
    for (size_t j = 0; j < net->lines; j++) {
        curve_point *h = net->h + i * net->lines + j;
        h[0] = solve(h[0], s.b, *(h - net->lines), s.a);
    }
}

static void solve_right(curve_net *net, size_t i, double x)
{
    shares s = shares_of(net, i, x);
    net->from[i] = CURVE_COMPUTED;
    for (size_t j = 0; j < net->lines; j++) {
        curve_point *h = net->h + i * net->lines + j;
        h[0] = solve(h[0], s.a, h[net->lines], s.b);
    }
}

static void drop(curve_net *net, size_t i, size_t knot)
{
    size_t after = net->n - i - 1, lines = net->lines;
    memmove(net->u + knot, net->u + knot + 1, (net->n + net->p - knot) * sizeof *net->u);
    memmove(net->h + i * lines, net->h + (i + 1) * lines, after * lines * sizeof *net->h);
    memmove(net->from + i, net->from + i + 1, after * sizeof *net->from);
    net->n--;
}

/* The greatest of the lines' deviations: what the equation left over is not satisfied by, or, with none left over, by how much the two ways to the
 * middle point differ.  Not a number where a point solved for is infinite: that goes on from each to the next. */
static double deviation(const curve_net *net, size_t i, int odd, double x, double reach)
{
    double most = 0.0;
    shares s = shares_of(net, i, x);
    for (size_t j = 0; j < net->lines; j++) {
        const curve_point *h = net->h + i * net->lines + j;
        curve_point want = odd ? combine(s.a, h[net->lines], s.b, *(h - net->lines)) : h[net->lines];
        double d = distance(h[0], want, reach);
        most = d <= most ? most : d;
        if (!(d <= most)) {
            break;
        }
    }
    return most;
}

static int weights_positive(const curve_net *net)
{
    int positive = 1;
    for (size_t k = 0; net->rational && k < net->n * net->lines; k++) {
        positive = positive && net->h[k].w > 0.0;
    }
    return positive;
}

/* A5.8, one knot, the last of those equal to x: half of the equations are solved from the left, half from the right.  By how much the curve moves at
 * most; infinite where a weight would not be positive. */
static double remove_once(curve_net *net, double x, double reach)
{
    size_t p = net->p, r = last_of(net->u, x), s = et_knots_multiplicity(net->u, r + 1, x);
    size_t equations = s <= p ? p + 1 - s : 0, half = equations / 2;
    for (size_t k = 0; k < half; k++) {
        solve_left(net, r - p + k, x);
        solve_right(net, r - s - k, x);
    }
    int odd = equations % 2 == 1;
    size_t middle = r - p + half - (odd ? 0 : 1);
    /* Of more than p + 1 equal knots this point's function is zero. */
    double d = s > p + 1 ? 0.0 : deviation(net, middle, odd, x, reach);
    drop(net, middle, r);
    return weights_positive(net) ? d : HUGE_VAL;
}

/* With A = w C and errors e of A and w the curve moves by |e_A - C e_w| / (w + e_w), so by at most the tolerance if |e_A| + (|C| + tolerance) |e_w|
 * is at most tolerance w: with the greatest |C| and the least w.  Eq. 5.30 puts both errors together, and asks for more. */
static double reach_of(const curve_net *net, double tolerance)
{
    double most = 0.0;
    for (size_t k = 0; net->rational && k < net->n * net->lines; k++) {
        curve_point h = net->h[k];
        most = fmax(most, length(h.x / h.w, h.y / h.w, h.z / h.w));
    }
    return net->rational ? most + tolerance : 0.0;
}

static double least_weight(const curve_net *net)
{
    double least = 1.0;
    for (size_t k = 0; net->rational && k < net->n * net->lines; k++) {
        least = fmin(least, net->h[k].w);
    }
    return least;
}

et_status curve_net_remove(curve_net *net, size_t *removed, double x, size_t times, double tolerance)
{
    curve_net t;
    size_t count = 0;
    double left = tolerance * least_weight(net), reach = reach_of(net, tolerance);
    if (curve_net_new(&t, net->p, net->n, net->lines, net->rational) != ET_OK) {
        return ET_ENOMEM;
    }
    while (count < times && et_knots_multiplicity(net->u, net->n, x) > 0) {
        fill(&t, net);
        double d = remove_once(&t, x, reach);
        if (!(d <= left)) {
            break;
        }
        left -= d;
        fill(net, &t);
        count++;
    }
    curve_net_free(&t);
    *removed = count;
    return ET_OK;
}
