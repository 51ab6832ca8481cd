#include "curve_parts.h"
#include "etalon/base/size.h"
#include "etalon/spline/knots.h"
#include <stdlib.h>

static size_t different(const double *u, size_t nu)
{
    size_t count = 1;
    for (size_t i = 1; i < nu; i++) {
        count += u[i - 1] < u[i];
    }
    return count;
}

size_t curve_net_elevated(const double *u, size_t p, size_t n, size_t times)
{
    size_t more;
    if (et_size_mul(&more, times, different(u, n + p + 1) - 1) != ET_OK || more > SIZE_MAX - n) {
        return SIZE_MAX;
    }
    return n + more;
}

/* Each different knot once more. */
static void multiply(double *v, const double *u, size_t nu)
{
    for (size_t i = 0; i < nu; i++) {
        *v++ = u[i];
        if (i + 1 == nu || u[i] < u[i + 1]) {
            *v++ = u[i];
        }
    }
}

/* The control point of index i after refinement to knots t[0] = v[i], t[1], ..., but for t[skip], is sum_c alpha[c] P_{span-p+c}: discrete B-splines
 * by the Oslo algorithm (Cohen, Lyche and Riesenfeld 1980), span that of t[0].  What is not zero has support within that of the function it is made
 * of: no factor is negative, and each alpha is within ((1-u)^(5p), (1-u)^-(5p)) of the exact one. */
static void discrete(double *alpha, const double *u, size_t p, size_t span, const double *t, size_t skip)
{
    alpha[p] = 1.0;
    for (size_t k = 1; k <= p; k++) {
        double x = t[k < skip ? k : k + 1];
        alpha[p - k] = 0.0;
        for (size_t c = p - k + 1; c <= p; c++) {
            size_t j = span - p + c;
            double width = u[j + k] - u[j], old = alpha[c];
            if (old > 0.0) {
                alpha[c - 1] += (u[j + k] - x) / width * old;
                alpha[c] = (x - u[j]) / width * old;
            }
        }
    }
}

/* Control point i of degree p + 1 is the mean of p + 1 of degree p: over the knots v, each time without one of v[i+1] .. v[i+p+1] (Prautzsch 1984).
 * row[c]: the share of P_{span-p+c}, off by at most 6p + 1 roundings. */
static void shares(double *row, double *alpha, const double *u, size_t p, size_t span, const double *t)
{
    for (size_t c = 0; c <= p; c++) {
        row[c] = 0.0;
    }
    for (size_t skip = 1; skip <= p + 1; skip++) {
        discrete(alpha, u, p, span, t, skip);
        for (size_t c = 0; c <= p; c++) {
            row[c] += alpha[c];
        }
    }
    for (size_t c = 0; c <= p; c++) {
        row[c] /= (double)(p + 1);
    }
}

/* Point i: sum_c row[c] P_{first+c}, from left to right over what is not zero; where that is one point, this point. */
static void contract(curve_net *to, size_t i, const curve_net *net, size_t first, const double *row)
{
    size_t lines = net->lines, begin = 0, end = net->p;
    while (!(row[begin] > 0.0)) {
        begin++;
    }
    while (!(row[end] > 0.0)) {
        end--;
    }
    to->from[i] = begin == end ? net->from[first + begin] : CURVE_COMPUTED;
    for (size_t j = 0; j < lines; j++) {
        const curve_point *P = net->h + (first + begin) * lines + j;
        double a = begin == end ? 1.0 : row[begin];
        curve_point S = {a * P->x, a * P->y, a * P->z, a * P->w};
        for (size_t c = begin + 1; c <= end; c++) {
            a = row[c];
            P = net->h + (first + c) * lines + j;
            S = (curve_point){S.x + a * P->x, S.y + a * P->y, S.z + a * P->z, S.w + a * P->w};
        }
        to->h[i * lines + j] = S;
    }
}

static et_status elevate_once(curve_net *net)
{
    size_t p = net->p, nu = net->n + p + 1, n = curve_net_elevated(net->u, p, net->n, 1);
    double *row = et_size_array(p + 1, 2 * sizeof(double));
    curve_net t;
    if (!row || curve_net_new(&t, p + 1, n, net->lines, net->rational) != ET_OK) {
        free(row);
        return ET_ENOMEM;
    }
    t.exponent = net->exponent;
    multiply(t.u, net->u, nu);
    for (size_t i = 0; i < n; i++) {
        size_t span = et_knots_span(net->u, nu, p, t.u[i]);
        shares(row, row + p + 1, net->u, p, span, t.u + i);
        contract(&t, i, net, span - p, row);
    }
    free(row);
    curve_net_free(net);
    *net = t;
    return ET_OK;
}

et_status curve_net_elevate(curve_net *net, size_t times)
{
    et_status status = ET_OK;
    for (size_t t = 0; t < times && status == ET_OK; t++) {
        status = elevate_once(net);
    }
    return status;
}
