/* exact_edit: knots inserted and removed, degrees elevated, by polar forms.
 *
 * A polynomial of degree p has one symmetric form of p arguments, affine in each, that is the polynomial where all are equal: its blossom f.  The
 * control points of a spline are its pieces' blossoms at p consecutive knots (Ramshaw 1989); so are those on other knots.  The form of degree p + 1
 * of the same polynomial is the mean of f with one argument left out, over all p + 1 of them.
 */
#include "etalon/base/size.h"
#include "exact/exact_sums_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Control points along one direction: point i of line (o, w) is number (o*n + i)*width + w, o < outer, w < width. */
typedef struct {
    size_t outer, n, width, p;
    const double *u;
    const et_vec3 *points;
    const double *weights;
} sheet;

static sheet sheet_of_curve(const et_curve *c)
{
    return (sheet){1, c->n, 1, c->p, c->u, c->points, c->weights};
}

static sheet sheet_of_surface(const et_surface *s, et_direction along)
{
    if (along == ET_ALONG_U) {
        return (sheet){1, s->nu, s->nv, s->p, s->u, s->points, s->weights};
    }
    return (sheet){s->nu, s->nv, 1, s->q, s->v, s->points, s->weights};
}

/* ---- new control points as combinations of old ones ---- */

/* sum_r v[r] old[first + r]. */
typedef struct {
    size_t first, n;
    fmpq *v;
} band;

/* n new control points, the degree p and the knots they belong to. */
typedef struct {
    size_t p, n;
    double *u;
    band *row;
} change;

/* Room for so much, zeroed; 0 if there is no memory. */
static int change_init(change *m, size_t p, size_t n)
{
    *m = (change){p, n, et_size_array(n + p + 1, sizeof *m->u), et_size_array(n, sizeof *m->row)};
    if (m->u == NULL || m->row == NULL) {
        free(m->u);
        free(m->row);
        return 0;
    }
    return 1;
}

static void change_clear(change *m)
{
    for (size_t j = 0; j < m->n; j++) {
        _fmpq_vec_clear(m->row[j].v, (slong)m->row[j].n);
    }
    free(m->u);
    free(m->row);
}

static void band_init(band *b, size_t first, size_t n)
{
    *b = (band){first, n, _fmpq_vec_init((slong)n)};
}

/* The old control point itself. */
static void band_unit(band *b, size_t at)
{
    band_init(b, at, 1);
    fmpq_one(b->v);
}

/* Cox-de Boor with another parameter at each step. */
void exact_blossom(fmpq *N, const double *u, size_t p, size_t span, const double *t)
{
    fmpq *k = _fmpq_vec_init((slong)(2 * p + 2)), *x = k + 2 * p, *f = x + 1;
    for (size_t i = 0; i < 2 * p; i++) {
        exact_set(k + i, u[span + 1 - p + i]);
    }
    fmpq_one(N);
    for (size_t j = 1; j <= p; j++) {
        exact_set(x, t[j - 1]);
        fmpq_zero(N + j);
        for (size_t r = j; r-- > 0;) {
            const fmpq *hi = k + p + r, *lo = hi - j;
            fmpq_sub(f, hi, lo);
            fmpq_div(f, N + r, f);
            fmpq_sub(N + r, hi, x);
            fmpq_mul(N + r, N + r, f);
            fmpq_t rest;
            fmpq_init(rest);
            fmpq_sub(rest, x, lo);
            fmpq_addmul(N + r + 1, rest, f);
            fmpq_clear(rest);
        }
    }
    _fmpq_vec_clear(k, (slong)(2 * p + 2));
}

static void band_blossom(band *b, const double *u, size_t p, size_t span, const double *t)
{
    band_init(b, span - p, p + 1);
    exact_blossom(b->v, u, p, span, t);
}

/* The new points out of the old ones; W is null where there are no weights. */
static void change_apply(et_vec3 *P, double *W, const change *m, const sheet *s)
{
    exact_net net;
    exact_row row;
    fmpz *T = _fmpz_vec_init((slong)(EXACT_COMPONENTS * s->width));
    fmpq *C = _fmpq_vec_init(EXACT_COMPONENTS);
    exact_net_init(&net, s->points, s->weights, s->outer * s->n, s->width, s->width);
    for (size_t j = 0; j < m->n; j++) {
        exact_row_init(&row, m->row[j].v, m->row[j].n);
        for (size_t o = 0; o < s->outer; o++) {
            exact_contract(T, s->width, &row, net.H + EXACT_COMPONENTS * (o * s->n + m->row[j].first) * s->width, s->width);
            for (size_t w = 0; w < s->width; w++) {
                size_t at = (o * m->n + j) * s->width + w;
                exact_project(C, T + EXACT_COMPONENTS * w, net.e);
                P[at] = exact_round_point(C);
                if (W != NULL) {
                    fmpq_set_fmpz_frac(C + 3, T + EXACT_COMPONENTS * w + 3, row.denominator);
                    exact_scale(C + 3, net.w);
                    W[at] = exact_round(C + 3);
                }
            }
        }
        exact_row_clear(&row);
    }
    exact_net_clear(&net);
    _fmpz_vec_clear(T, (slong)(EXACT_COMPONENTS * s->width));
    _fmpq_vec_clear(C, EXACT_COMPONENTS);
}

/* The changed curve or surface; the change is cleared. */
static et_status finish_curve(et_curve *out, change *m, const et_curve *c)
{
    et_curve made;
    sheet s = sheet_of_curve(c);
    et_status status = et_curve_new(&made, m->p, m->n, c->weights != NULL);
    if (status == ET_OK) {
        memcpy(made.u, m->u, (m->n + m->p + 1) * sizeof *m->u);
        change_apply(made.points, made.weights, m, &s);
        *out = made;
    }
    change_clear(m);
    return status;
}

static et_status finish_surface(et_surface *out, change *m, const et_surface *c, et_direction along)
{
    et_surface made;
    sheet s = sheet_of_surface(c, along);
    int u = along == ET_ALONG_U;
    et_status status = et_surface_new(&made, u ? m->p : c->p, u ? c->q : m->p, u ? m->n : c->nu, u ? c->nv : m->n, c->weights != NULL);
    if (status == ET_OK) {
        memcpy(made.u, u ? m->u : c->u, (made.nu + made.p + 1) * sizeof *m->u);
        memcpy(made.v, u ? c->v : m->u, (made.nv + made.q + 1) * sizeof *m->u);
        change_apply(made.points, made.weights, m, &s);
        *out = made;
    }
    change_clear(m);
    return status;
}

/* ---- insertion ---- */

/* How many of the knots are x, and how many are not greater. */
static void count_knots(size_t *multiplicity, size_t *upto, const double *u, size_t nu, double x)
{
    *multiplicity = *upto = 0;
    for (size_t i = 0; i < nu; i++) {
        *multiplicity += u[i] == x;
        *upto += u[i] <= x;
    }
}

/* A new control point whose p knots stand side by side in u is an old one; with the run of x-es held to grow at its end, or at its beginning. */
static et_status change_insert(change *m, const sheet *s, double x, size_t times)
{
    size_t multiplicity, upto, p = s->p, n = s->n;
    count_knots(&multiplicity, &upto, s->u, n + p + 1, x);
    if (!(s->u[p] <= x && x <= s->u[n]) || (times > 0 && (multiplicity > p || times > p + 1 - multiplicity))) {
        return ET_EINVAL;
    }
    if (!change_init(m, p, n + times)) {
        return ET_ENOMEM;
    }
    for (size_t i = 0; i < n + p + 1 + times; i++) {
        m->u[i] = i < upto ? s->u[i] : i < upto + times ? x : s->u[i - times];
    }
    if (!et_knots_valid(m->u, n + p + 1 + times, p)) {           /* x too close to another one */
        change_clear(m);
        return ET_EINVAL;
    }
    size_t span = et_knots_span(s->u, n + p + 1, p, x);
    for (size_t j = 0; j < m->n; j++) {
        if (j + p < upto) {
            band_unit(m->row + j, j);
        } else if (j + 1 + multiplicity >= upto + times) {
            band_unit(m->row + j, j - times);
        } else {
            band_blossom(m->row + j, s->u, p, span, m->u + j + 1);
        }
    }
    return ET_OK;
}

et_status et_exact_curve_insert(et_curve *refined, const et_curve *c, double x, size_t times)
{
    change m;
    if (!et_curve_valid(c)) {
        return ET_EINVAL;
    }
    sheet s = sheet_of_curve(c);
    et_status status = change_insert(&m, &s, x, times);
    return status == ET_OK ? finish_curve(refined, &m, c) : status;
}

et_status et_exact_surface_insert(et_surface *refined, const et_surface *s, et_direction along, double x, size_t times)
{
    change m;
    if (!et_surface_valid(s)) {
        return ET_EINVAL;
    }
    sheet l = sheet_of_surface(s, along);
    et_status status = change_insert(&m, &l, x, times);
    return status == ET_OK ? finish_surface(refined, &m, s, along) : status;
}

/* ---- elevation ---- */

static int change_none(change *m, const sheet *s)
{
    if (!change_init(m, s->p, s->n)) {
        return 0;
    }
    memcpy(m->u, s->u, (s->n + s->p + 1) * sizeof *m->u);
    for (size_t j = 0; j < s->n; j++) {
        band_unit(m->row + j, j);
    }
    return 1;
}

/* sum += f row, a band within another. */
static void add_band(band *sum, const fmpq_t f, const band *row)
{
    for (size_t r = 0; r < row->n; r++) {
        fmpq_addmul(sum->v + row->first - sum->first + r, f, row->v + r);
    }
}

/* The mean of the blossoms of degree p at p of the p+1 arguments t, in the control points that the old ones are made of. */
static void mean_of_blossoms(band *mean, const change *old, size_t span, const double *t)
{
    size_t p = old->p;
    const band *row = old->row + span - p;
    fmpq *N = _fmpq_vec_init((slong)(p + 2)), *f = N + p + 1;
    double *rest = flint_malloc((p + 1) * sizeof *rest);
    band_init(mean, row[0].first, row[p].first + row[p].n - row[0].first);
    memcpy(rest, t + 1, p * sizeof *rest);
    for (size_t i = 0, same = 1; i <= p; i++, same++) {          /* rest: t without t[i] */
        if (i == p || t[i] < t[i + 1]) {
            exact_blossom(N, old->u, p, span, rest);
            fmpq_set_si(f, (slong)same, (ulong)(p + 1));
            for (size_t r = 0; r <= p; r++) {
                fmpq_mul(N + r, N + r, f);
                add_band(mean, N + r, row + r);
            }
            same = 0;
        }
        rest[i] = t[i];
    }
    flint_free(rest);
    _fmpq_vec_clear(N, (slong)(p + 2));
}

/* Each different knot once more. */
static void raise_knots(double *t, const double *u, size_t nu)
{
    for (size_t i = 0; i < nu; i++) {
        *t++ = u[i];
        if (i + 1 == nu || u[i] < u[i + 1]) {
            *t++ = u[i];
        }
    }
}

static size_t different(const double *u, size_t nu)
{
    size_t n = 1;
    for (size_t i = 0; i + 1 < nu; i++) {
        n += u[i] < u[i + 1];
    }
    return n;
}

/* The degree higher by one.  A new control point belongs to any span i where its basis function lives, here the first; `before` knots of t are there
 * more than in the old ones up to that span's left end but one.  Where its function lives nowhere (a knot of more than p + 1), it takes an old one of
 * that kind. */
static int change_raise(change *m, const change *old)
{
    size_t nu = old->n + old->p + 1, i = 0, before = 0;
    if (!change_init(m, old->p + 1, old->n + different(old->u, nu) - 1)) {
        return 0;
    }
    raise_knots(m->u, old->u, nu);
    for (size_t j = 0; j < m->n; j++) {
        while (i <= j + m->p && (i < j || m->u[i] == m->u[i + 1])) {
            before += m->u[i] < m->u[i + 1];
            i++;
        }
        if (i > j + m->p) {
            band_unit(m->row + j, old->row[j - before].first);
        } else {
            mean_of_blossoms(m->row + j, old, i - before - 1, m->u + j + 1);
        }
    }
    return 1;
}

static et_status change_elevate(change *m, const sheet *s, size_t times)
{
    size_t nu = s->n + s->p + 1, more, size;
    if (!et_knots_clamped(s->u, nu, s->p)) {
        return ET_EINVAL;
    }
    if (et_size_mul(&more, times, different(s->u, nu)) != ET_OK || more > SIZE_MAX - nu || !exact_fits(&size, nu + more, s->n) ||
        !change_none(m, s)) {
        return ET_ENOMEM;
    }
    for (; times > 0; times--) {
        change next;
        int done = change_raise(&next, m);
        change_clear(m);
        if (!done) {
            return ET_ENOMEM;
        }
        *m = next;
    }
    return ET_OK;
}

et_status et_exact_curve_elevate(et_curve *elevated, const et_curve *c, size_t times)
{
    change m;
    if (!et_curve_valid(c)) {
        return ET_EINVAL;
    }
    sheet s = sheet_of_curve(c);
    et_status status = change_elevate(&m, &s, times);
    return status == ET_OK ? finish_curve(elevated, &m, c) : status;
}

et_status et_exact_surface_elevate(et_surface *elevated, const et_surface *s, et_direction along, size_t times)
{
    change m;
    if (!et_surface_valid(s)) {
        return ET_EINVAL;
    }
    sheet l = sheet_of_surface(s, along);
    et_status status = change_elevate(&m, &l, times);
    return status == ET_OK ? finish_surface(elevated, &m, s, along) : status;
}

/* ---- removal ---- */

/* Whether the k-th derivatives of all lines are the same from both sides, homogeneous coordinates of course. */
static int agree(const sheet *s, const exact_net *net, const exact_line *left, const exact_line *right, size_t k)
{
    size_t n = EXACT_COMPONENTS * s->width;
    fmpz *L = _fmpz_vec_init((slong)(2 * n)), *R = L + n;
    int same = 1;
    for (size_t o = 0; same && o < s->outer; o++) {
        const fmpz *H = net->H + EXACT_COMPONENTS * o * s->n * s->width;
        exact_contract(L, s->width, left->row + k, H + EXACT_COMPONENTS * left->first * s->width, s->width);
        exact_contract(R, s->width, right->row + k, H + EXACT_COMPONENTS * right->first * s->width, s->width);
        _fmpz_vec_scalar_mul_fmpz(L, L, (slong)n, right->row[k].denominator);
        _fmpz_vec_scalar_mul_fmpz(R, R, (slong)n, left->row[k].denominator);
        same = _fmpz_vec_equal(L, R, (slong)n);
    }
    _fmpz_vec_clear(L, (slong)(2 * n));
    return same;
}

/* How often, at most `times`, the knot can go: a knot of multiplicity m leaves p - m derivatives continuous and takes the next away, so each one less
 * asks for one more, and the first m - p - 1 of them for nothing. */
static size_t smooth(const sheet *s, double x, size_t multiplicity, size_t last, size_t times)
{
    size_t p = s->p, r = 0;
    exact_line left, right;
    exact_net net;
    exact_line_init_at(&left, s->u, s->n, p, last - multiplicity, x, p);
    exact_line_init_at(&right, s->u, s->n, p, last, x, p);
    exact_net_init(&net, s->points, s->weights, s->outer * s->n, s->width, s->width);
    while (r < times && r < multiplicity && (p + r + 1 < multiplicity || agree(s, &net, &left, &right, p + r + 1 - multiplicity))) {
        r++;
    }
    exact_net_clear(&net);
    exact_line_clear(&left);
    exact_line_clear(&right);
    return r;
}

/* As in change_insert; the new control points among the knots on both sides of x are the blossoms of the piece before x. */
static int change_remove(change *m, const sheet *s, size_t multiplicity, size_t last, size_t times)
{
    size_t p = s->p, before = last - multiplicity;
    if (!change_init(m, p, s->n - times)) {
        return 0;
    }
    for (size_t i = 0; i < m->n + p + 1; i++) {
        m->u[i] = s->u[i + times <= last ? i : i + times];
    }
    for (size_t j = 0; j < m->n; j++) {
        if (j <= before && j + p + times <= last) {
            band_unit(m->row + j, j);
        } else if (j >= before) {
            band_unit(m->row + j, j + times);
        } else {
            band_blossom(m->row + j, s->u, p, before, m->u + j + 1);
        }
    }
    return 1;
}

static int positive(const change *m, const sheet *s)
{
    exact_net net;
    exact_row row;
    fmpz *T = _fmpz_vec_init((slong)(EXACT_COMPONENTS * s->width));
    int ok = 1;
    exact_net_init(&net, s->points, s->weights, s->outer * s->n, s->width, s->width);
    for (size_t j = 0; ok && j < m->n; j++) {
        exact_row_init(&row, m->row[j].v, m->row[j].n);
        for (size_t o = 0; o < s->outer; o++) {
            exact_contract(T, s->width, &row, net.H + EXACT_COMPONENTS * (o * s->n + m->row[j].first) * s->width, s->width);
            for (size_t w = 0; w < s->width; w++) {
                ok = ok && fmpz_sgn(T + EXACT_COMPONENTS * w + 3) > 0;
            }
        }
        exact_row_clear(&row);
    }
    exact_net_clear(&net);
    _fmpz_vec_clear(T, (slong)(EXACT_COMPONENTS * s->width));
    return ok;
}

/* As often as all is smooth and all weights stay positive.  Those after fewer removals are means of those after more: positive, too. */
static et_status change_least(change *m, size_t *removed, const sheet *s, double x, size_t times)
{
    size_t multiplicity, upto;
    count_knots(&multiplicity, &upto, s->u, s->n + s->p + 1, x);
    if (!(s->u[s->p] < x && x < s->u[s->n]) || multiplicity == 0) {
        return ET_EINVAL;
    }
    for (size_t r = smooth(s, x, multiplicity, upto - 1, times);; r--) {
        if (!change_remove(m, s, multiplicity, upto - 1, r)) {
            return ET_ENOMEM;
        }
        if (positive(m, s)) {
            *removed = r;
            return ET_OK;
        }
        change_clear(m);
    }
}

et_status et_exact_curve_remove(et_curve *reduced, size_t *removed, const et_curve *c, double x, size_t times)
{
    change m;
    size_t often;
    if (!et_curve_valid(c)) {
        return ET_EINVAL;
    }
    sheet s = sheet_of_curve(c);
    et_status status = change_least(&m, &often, &s, x, times);
    status = status == ET_OK ? finish_curve(reduced, &m, c) : status;
    *removed = status == ET_OK ? often : *removed;
    return status;
}

et_status et_exact_surface_remove(et_surface *reduced, size_t *removed, const et_surface *s, et_direction along, double x, size_t times)
{
    change m;
    size_t often;
    if (!et_surface_valid(s)) {
        return ET_EINVAL;
    }
    sheet l = sheet_of_surface(s, along);
    et_status status = change_least(&m, &often, &l, x, times);
    status = status == ET_OK ? finish_surface(reduced, &m, s, along) : status;
    *removed = status == ET_OK ? often : *removed;
    return status;
}

/* ---- Greville points ---- */

et_status et_exact_knots_greville(double *g, size_t n, const double *u, size_t nu, size_t p)
{
    fmpq_t sum, x;
    if (!et_knots_valid(u, nu, p) || n != nu - p - 1) {
        return ET_EINVAL;
    }
    size_t first = p == 0 ? 0 : 1, terms = p == 0 ? 2 : p;
    fmpq_init(sum);
    fmpq_init(x);
    for (size_t i = 0; i < n; i++) {
        fmpq_zero(sum);
        for (size_t j = 0; j < terms; j++) {
            exact_set(x, u[i + first + j]);
            fmpq_add(sum, sum, x);
        }
        fmpz_mul_ui(fmpq_denref(sum), fmpq_denref(sum), (ulong)terms);
        fmpq_canonicalise(sum);
        g[i] = exact_round(sum);
    }
    fmpq_clear(sum);
    fmpq_clear(x);
    return ET_OK;
}
