/* judge_magnitude: the magnitudes of all terms of a value or a derivative, and the bounds made of them (docs/judge.md, "Bounds, to the letter").
 * Plain doubles, nothing of the spline room: all terms are positive, so that each result is right to a few units of its last place. */
#include "conform/judge_parts.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double eta = 0x1p-1074;

double judge_times(double a, double b)
{
    return a == 0 || b == 0 ? 0 : a * b;
}

double judge_coordinate(const et_vec3 *P, size_t c)
{
    return c == 0 ? P->x : c == 1 ? P->y : P->z;
}

double judge_length(const double c[3])
{
    const double most = fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2])));

    if (!(most > 0) || !isfinite(most))
        return most;
    return most * sqrt((c[0] / most) * (c[0] / most) + (c[1] / most) * (c[1] / most) + (c[2] / most) * (c[2] / most));
}

double judge_bound(double want, double B)
{
    const double a = fabs(want);
    int e = -1021;

    if (!(B <= 0x1.fffffffffffffp+1023) || !isfinite(want))
        return INFINITY;
    if (a > 0x1p-1022)
        frexp(a, &e);
    const double h = e < -1020 ? eta : ldexp(0.5, e - 53);
    return (B + h) * (1 + 0x1p-40);
}

/* ---- one direction ---- */

/* The span of x in the domain: from the right u_k <= x < u_k+1, from the left u_k < x <= u_k+1, at the domain's ends the one inside. */
static size_t span_of(const double *u, size_t nu, size_t p, double x, int left)
{
    const size_t n = nu - p - 1;
    size_t k = p;

    for (size_t i = p; i < n; i++)
        if (u[i] < u[i + 1] && (u[i] < x || (!left && u[i] == x) || u[i] == u[p]))
            k = i;
    return k;
}

/* N_span-q+j,q at tri[q (p+1) + j], q = 0..p. */
static void functions(double *tri, const double *u, size_t p, size_t span, double x)
{
    tri[0] = 1;
    for (size_t q = 1; q <= p; q++)
        for (size_t j = 0; j <= q; j++) {
            const size_t i = span - q + j;
            const double *N = tri + (q - 1) * (p + 1);
            const double a = j > 0 ? (x - u[i]) / (u[i + q] - u[i]) * N[j - 1] : 0;
            const double b = j < q ? (u[i + q + 1] - x) / (u[i + q + 1] - u[i + 1]) * N[j] : 0;
            tri[q * (p + 1) + j] = a + b;
        }
}

/* From row (degree q - 1, functions span-q+1 ..) to the same of degree q and an order more, in place: Eq. 2.7 with plus. */
static void raised(double *row, const double *u, size_t q, size_t span)
{
    for (size_t j = q + 1; j-- > 0;) {
        const size_t i = span - q + j;
        const double a = j > 0 ? row[j - 1] / (u[i + q] - u[i]) : 0;
        const double b = j < q ? row[j] / (u[i + q + 1] - u[i + 1]) : 0;
        row[j] = (double)q * (a + b);
    }
}

et_status judge_line_make(judge_line *line, const double *u, size_t nu, size_t p, double x, int left, size_t d)
{
    const size_t span = span_of(u, nu, p, x, left), top = d < p ? d : p;
    double *tri = et_size_array((p + 1) * (p + 1), sizeof *tri);
    double *rows = et_size_array((d + 1) * (p + 1), 2 * sizeof *rows);

    if (!tri || !rows) {
        free(tri);
        free(rows);
        return ET_ENOMEM;
    }
    *line = (judge_line){ span - p, p, d, fmax(1, u[nu - 1] - u[0]), rows, rows + (d + 1) * (p + 1) };
    functions(tri, u, p, span, x);
    for (size_t k = 0; k <= top; k++) {
        double *m = line->m + k * (p + 1), *s = line->s + k * (p + 1);
        memcpy(m, tri + (p - k) * (p + 1), (p - k + 1) * sizeof *m);
        for (size_t j = 0; j <= p - k; j++)
            s[j] = 1;
        for (size_t q = p - k + 1; q <= p; q++) {
            raised(m, u, q, span);
            raised(s, u, q, span);
        }
    }
    free(tri);
    return ET_OK;
}

void judge_line_free(judge_line *line)
{
    free(line->m);
    memset(line, 0, sizeof *line);
}

/* ---- a curve or a surface ---- */

et_status judge_net_curve(judge_net *net, const et_curve *c, double x, int left, size_t d)
{
    memset(net, 0, sizeof *net);
    net->points = c->points;
    net->weights = c->weights;
    net->nv = 1;
    net->curve = 1;
    return judge_line_make(&net->u, c->u, c->n + c->p + 1, c->p, x, left, d);
}

et_status judge_net_surface(judge_net *net, const et_surface *s, double x, double y, int left_u, int left_v, size_t d)
{
    memset(net, 0, sizeof *net);
    net->points = s->points;
    net->weights = s->weights;
    net->nv = s->nv;
    et_status status = judge_line_make(&net->u, s->u, s->nu + s->p + 1, s->p, x, left_u, d);
    if (status == ET_OK && (status = judge_line_make(&net->v, s->v, s->nv + s->q + 1, s->q, y, left_v, d)) != ET_OK)
        judge_line_free(&net->u);
    return status;
}

void judge_net_free(judge_net *net)
{
    judge_line_free(&net->u);
    judge_line_free(&net->v);
}

double judge_net_k(const judge_net *net, size_t a, size_t b)
{
    return 16 * (double)(net->u.p + net->v.p + a + b + 2);
}

/* |c|, fl(w |c|) or w. */
static double coefficient(const judge_net *net, size_t at, size_t component)
{
    const double w = net->weights ? net->weights[at] : 1;

    return component == JUDGE_WEIGHT ? w : net->weights ? w * fabs(judge_coordinate(&net->points[at], component))
                                                         : fabs(judge_coordinate(&net->points[at], component));
}

void judge_net_sums(double *M, double *E, const judge_net *net, size_t a, size_t b, size_t component)
{
    const judge_line *u = &net->u, *v = &net->v;
    const double *mu = u->m + a * (u->p + 1), *su = u->s + a * (u->p + 1);
    const double *mv = net->curve ? NULL : v->m + b * (v->p + 1), *sv = net->curve ? NULL : v->s + b * (v->p + 1);
    const double K = judge_net_k(net, a, b);
    double m = 0, U = 1, most = 0, first = 0, then = net->curve ? 1 : 0;

    for (size_t i = 0; i <= u->p; i++)
        first += mu[i];
    for (size_t j = 0; j <= v->p && !net->curve; j++)
        then += mv[j];
    for (size_t i = 0; i <= u->p; i++)
        for (size_t j = 0; j <= v->p; j++) {
            const double c = coefficient(net, (u->first + i) * net->nv + v->first + j, component);
            if (c == 0)
                continue;
            most = fmax(most, c);
            const double second = net->curve ? 1 : mv[j], more = net->curve ? 1 : 1 + v->length * sv[j];
            m += judge_times(judge_times(mu[i], c), second);
            U += (1 + u->length * su[i]) * c * more;
        }
    *M = m;
    *E = judge_times(judge_times(K * ET_UNIT * first, most), then) + K * eta * U;
}

/* ---- bounds of derivatives ---- */

static size_t place(const judge_net *net, size_t a, size_t b)
{
    return net->curve ? a : (a + b) * (a + b + 1) / 2 + b;
}

static double binomial(size_t n, size_t k)
{
    double c = 1;

    for (size_t i = 0; i < k; i++)
        c = c * (double)(n - i) / (double)(i + 1);
    return c;
}

/* The B of (a, b), those of lower orders being known; M and E of w stand at Mw and Ew. */
static double rational_bound(const double *B, const judge_net *net, const et_vec3 *C, const double *Mw, const double *Ew, size_t a, size_t b,
                             size_t c)
{
    double M, sum;

    judge_net_sums(&M, &sum, net, a, b, c);
    for (size_t i = 0; i <= a; i++)
        for (size_t j = 0; j <= b; j++) {
            const size_t at = place(net, i, j), rest = place(net, a - i, b - j);
            const double n = binomial(a, i) * binomial(b, j);
            sum += n * judge_times(Ew[at], fabs(judge_coordinate(&C[rest], c)));
            if (i + j > 0)
                sum += n * judge_times(Mw[at], B[3 * rest + c]);
        }
    return sum / Mw[0] + judge_net_k(net, a, b) * eta;
}

et_status judge_net_bounds(double *B, const judge_net *net, const et_vec3 *C, size_t d)
{
    const size_t n = place(net, 0, d) + 1, rows = net->curve ? d + 1 : n;
    double *Mw = et_size_array(rows, 2 * sizeof *Mw), *Ew = Mw ? Mw + rows : NULL;

    if (!Mw)
        return ET_ENOMEM;
    for (size_t o = 0; o <= d; o++)
        for (size_t b = 0; b <= (net->curve ? 0 : o); b++) {
            const size_t at = place(net, o - b, b);
            if (net->weights)
                judge_net_sums(&Mw[at], &Ew[at], net, o - b, b, JUDGE_WEIGHT);
            for (size_t c = 0; c < 3; c++) {
                double M;
                if (net->weights)
                    B[3 * at + c] = rational_bound(B, net, C, Mw, Ew, o - b, b, c);
                else
                    judge_net_sums(&M, &B[3 * at + c], net, o - b, b, c);
            }
        }
    free(Mw);
    return ET_OK;
}
