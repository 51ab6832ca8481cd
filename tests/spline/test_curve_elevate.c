/* spline/curve: degrees elevated, and any sequence of edits; golden rows of all edits. */
#include "spline/edits.h"

/* ---- elevation ---- */

static double elevation_roundings(size_t p, size_t times)
{
    double m = 0.0;
    for (size_t k = 0; k < times; k++) {
        m += 7.0 * (double)(p + k) + 2.0;
    }
    return m;
}

/* Clamped knots of any inner multiplicity, up to p + 1 and beyond. */
static void draw_clamped(gen *g, et_curve *c)
{
    double x = 0.0;
    for (size_t i = c->p + 1; i < c->n; i++) {
        x += gen_upto(g, 1) ? 0.0 : gen_upto(g, 3) ? (1.0 - x) * 0.125 : (nextafter(x, 1.0) - x) + 0x1p-60;
        c->u[i] = x > 0.0 ? x : (x = 0.0625);
    }
    for (size_t i = 0; i <= c->p; i++) {
        c->u[i] = 0.0;
        c->u[c->n + i] = 1.0;
    }
}

/* One case in 2. */
verdict prop_curve_elevate(gen *g)
{
    et_curve c, t = untouched();
    if (!draw(g, &c, false)) {
        return SKIP;
    }
    size_t times = (size_t)gen_upto(g, 3), k = 0;
    if (gen_upto(g, 1)) {
        draw_clamped(g, &c);
        gen_label(g, "any multiplicities");
    }
    if (!gen_check(g, et_curve_elevate(&t, &c, times) == ET_OK, "not elevated by %zu", times)) {
        return FAIL;
    }
    bool ok = gen_check(g, t.p == c.p + times && !t.weights == !c.weights && et_curve_valid(&t), "degree %zu", t.p);
    for (size_t i = 0; ok && i < knots(&c); i++) {
        bool last = i + 1 == knots(&c) || c.u[i + 1] > c.u[i];
        for (size_t m = 0; ok && m < (last ? times + 1 : 1); m++, k++) {
            ok = gen_check(g, k < knots(&t) && ref_same(t.u[k], c.u[i]), "knot %zu", k);
        }
    }
    ok = ok && gen_check(g, k == knots(&t), "%zu knots for %zu", knots(&t), k);
    ok = ok && agree(g, &t, &c, elevation_roundings(c.p, times));
    ok = ok && gen_check(g, same_point(t.points[0], c.points[0]) && same_point(t.points[t.n - 1], c.points[c.n - 1]), "other ends");
    ok = ok && gen_check(g, !c.weights || (t.weights[0] == c.weights[0] && t.weights[t.n - 1] == c.weights[c.n - 1]), "other weights at the ends");
    /* Where the curve falls apart both ends stay, every bit. */
    for (size_t i = c.p + 1; ok && i < c.n; i++) {
        if (et_knots_multiplicity(c.u, knots(&c), c.u[i]) != c.p + 1 || c.u[i - 1] == c.u[i] || c.u[i] == 1.0) {
            continue;
        }
        for (k = t.p + 1; t.u[k] < c.u[i]; k++) {
        }
        gen_label(g, "in two parts");
        ok = gen_check(g, same_point(t.points[k - 1], c.points[i - 1]) && same_point(t.points[k], c.points[i]), "the ends at %a", c.u[i]);
        ok = ok && gen_check(g, !c.weights || (t.weights[k - 1] == c.weights[i - 1] && t.weights[k] == c.weights[i]), "weights at %a", c.u[i]);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Degree after degree of a Bezier curve: Q_i = (i P_{i-1} + (p + 1 - i) P_i)/(p + 1), in double-double; several at once have the bits of one after the other. */
/* One case in 8. */
verdict prop_curve_elevate_bezier(gen *g)
{
    enum { MOST = 32 };
    size_t p = (size_t)gen_upto(g, 26), times = 1 + (size_t)gen_upto(g, 4);
    et_dd Q[MOST + 2];
    et_curve c, t, next;
    if (et_curve_new(&c, p, p + 1, 0) != ET_OK) {
        return FAIL;
    }
    gen_points(g, &c.points[0].x, p + 1);
    double size = 0.0, scale = ldexp(1.0, (int)gen_upto(g, 100) - 50);
    for (size_t i = 0; i <= p; i++) {
        c.u[p + 1 + i] = scale;
        size = fmax(size, fabs(c.points[i].x));
        Q[i] = dd_of(c.points[i].x);
    }
    for (size_t k = p + 1; k <= p + times; k++) {
        Q[k] = Q[k - 1];
        for (size_t i = k - 1; i > 0; i--) {
            et_dd a = et_dd_mul(dd_of((double)i), Q[i - 1]), b = et_dd_mul(dd_of((double)(k - i)), Q[i]);
            Q[i] = et_dd_div(et_dd_add(a, b), dd_of((double)k));
        }
    }
    if (!gen_check(g, et_curve_elevate(&t, &c, times) == ET_OK && t.p == p + times && t.n == p + times + 1, "not elevated")) {
        return FAIL;
    }
    bool ok = true;
    for (size_t i = 0; ok && i < t.n; i++) {
        double bound = (roundings(elevation_roundings(p, times)) + 0x1p-90) * size + speck;
        ok = gen_check(g, dd_off(dd_of(t.points[i].x), Q[i]) <= bound, "control point %zu: %a for %a", i, t.points[i].x, Q[i].hi);
    }
    for (size_t k = 0; ok && k < times; k++) {
        ok = gen_check(g, et_curve_elevate(&next, &c, 1) == ET_OK, "no step %zu", k);
        et_curve_free(&c);
        c = next;
    }
    ok = ok && gen_check(g, same_curve(&t, &c), "other bits than one after the other");
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

verdict prop_curve_elevate_refused(gen *g)
{
    et_curve c, t = untouched();
    if (!draw(g, &c, false)) {
        return SKIP;
    }
    bool right = gen_upto(g, 1) == 1, ok = true;
    double *end = right ? &c.u[knots(&c) - 1] : &c.u[0], old = *end;
    ok = gen_check(g, et_curve_elevate(&t, &c, SIZE_MAX) == ET_ENOMEM && et_curve_elevate(&t, &c, SIZE_MAX / 2) == ET_ENOMEM &&
                          et_curve_elevate(&t, &c, SIZE_MAX - c.p) == ET_ENOMEM, "sizes beyond all");
    *end += right ? 0.5 : -0.5;
    ok = ok && gen_check(g, c.p == 0 || et_curve_elevate(&t, &c, 1) == ET_EINVAL, "ends not clamped");
    *end = old;
    c.points[c.n - 1].x = NAN;
    ok = ok && gen_check(g, et_curve_elevate(&t, &c, 1) == ET_EINVAL, "a coordinate NaN");
    ok = ok && gen_check(g, is_untouched(&t), "the output was changed");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* ---- any sequence of edits ---- */

/* *t edited once at random, and what that may move a point by added to *off. */
static bool edit(gen *g, et_curve *t, double *off)
{
    et_curve next;
    size_t kind = (size_t)gen_upto(g, 2), times = 1 + (size_t)gen_upto(g, 1), removed = 0, s;
    double x = draw_x(g, t), size = greatest(t), tolerance = ldexp(size, -(int)gen_between(g, 4, 50)), least = 1.0;
    et_status status = ET_EINVAL;
    if (kind == 0) {
        s = et_knots_multiplicity(t->u, knots(t), x);
        status = s <= t->p && t->n < 24 ? et_curve_insert(&next, t, x, times < t->p + 1 - s ? times : t->p + 1 - s) : ET_EINVAL;
        *off += status == ET_OK ? 2.0 * roundings(5.0 * (double)times + 3.0) * size : 0.0;
    } else if (kind == 1) {
        status = et_curve_remove(&next, &removed, t, x, times, tolerance);
        for (size_t i = 0; status == ET_OK && t->weights && i < next.n; i++) {
            least = fmin(least, next.weights[i]);
        }
        double top = status == ET_OK ? size + greatest(&next) : size;
        *off += removed > 0 ? tolerance * (1.0 + 0x1p-30) + (double)removed * 4.0 * roundings(8.0) * top * (t->weights ? (1.0 + top) / least : 1.0) : 0.0;
    } else {
        status = t->p < DEGREE + 2 && t->n < 20 && et_knots_clamped(t->u, knots(t), t->p) ? et_curve_elevate(&next, t, times) : ET_EINVAL;
        *off += status == ET_OK ? 2.0 * roundings(elevation_roundings(t->p, times) + 3.0) * size : 0.0;
    }
    if (status == ET_OK) {
        gen_note(g, "%s %a", kind == 0 ? "insert" : kind == 1 ? "remove" : "elevate", x);
        gen_label(g, kind == 0 ? "inserted" : kind == 2 ? "elevated" : removed > 0 ? "removed" : "not removed");
        et_curve_free(t);
        *t = next;
    }
    return gen_check(g, status != ET_ENOMEM && et_curve_valid(t), "edit %zu: status %d", kind, (int)status);
}

/* One case in 2. */
verdict prop_curve_insert_sequence(gen *g)
{
    et_curve c, t;
    double off = speck;
    if (!draw(g, &c, gen_upto(g, 1) == 1) || et_curve_copy(&t, &c) != ET_OK) {
        return SKIP;
    }
    size_t edits = (size_t)gen_upto(g, 7);
    bool ok = true;
    for (size_t k = 0; ok && k < edits; k++) {
        ok = edit(g, &t, &off);
    }
    for (size_t k = 0; ok && k < 6; k++) {
        double x = draw_x(g, &c);
        et_side side = gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
        fine e = fine_point(&t, x, side), f = fine_point(&c, x, side);
        for (int a = 0; ok && a < 3; a++) {
            double move = et_dd_sub(et_dd_div(e.value[a], e.value[3]), et_dd_div(f.value[a], f.value[3])).hi;
            ok = gen_check(g, fabs(move) <= off, "after %zu edits, at %a: coordinate %d moved by %g, within %g", edits, x, a, move, off);
        }
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* ---- rows ---- */

/* What is wanted is a curve, written as those of the arguments are: sizes and knots to the bit, the rest as the row's class says. */
static bool is_curve(const row *r, size_t at, const et_curve *c)
{
    size_t n = c->n, rational = c->weights != NULL;
    bool ok = r->nwant == at + 3 + knots(c) + (rational ? 4 : 3) * n && strtod(r->want[at], NULL) == (double)c->p && strtod(r->want[at + 1], NULL) == (double)n &&
              strtod(r->want[at + 2], NULL) == (double)rational;
    at += 3;
    for (size_t i = 0; ok && i < knots(c); i++, at++) {
        ok = ref_same(strtod(r->want[at], NULL), c->u[i]) && row_is(r, at, c->u[i]);
    }
    for (size_t i = 0; ok && i < 3 * n; i++, at++) {
        ok = row_is(r, at, coordinate(&c->points[i / 3], (int)(i % 3)));
    }
    for (size_t i = 0; ok && rational && i < n; i++, at++) {
        ok = row_is(r, at, c->weights[i]);
    }
    return ok;
}

/* After the curve: k, x, side (0 right, 1 left); wanted is the k-th derivative. */
verdict gold_curve_ders_side(const row *r)
{
    et_curve c;
    et_vec3 D[32];
    size_t at = read_curve(r, &c), k = at > 0 ? row_size(r, at) : 0, n = at > 0 ? et_curve_work(&c, k) : 0;
    if (at == 0 || k >= 32 || !et_curve_valid(&c)) {
        return FAIL;
    }
    double *work = et_size_array(n, sizeof(double));
    et_curve_ders_side(D, k, &c, row_real(r, at + 1), row_size(r, at + 2) ? ET_SIDE_LEFT : ET_SIDE_RIGHT, work, n);
    bool ok = r->nwant == 3;
    for (int a = 0; ok && a < 3; a++) {
        ok = row_is(r, (size_t)a, coordinate(&D[k], a));
    }
    free(work);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* After the curve: x, times. */
verdict gold_curve_insert(const row *r)
{
    et_curve c, t;
    size_t at = read_curve(r, &c);
    if (at == 0 || et_curve_insert(&t, &c, row_real(r, at), row_size(r, at + 1)) != ET_OK) {
        return FAIL;
    }
    bool ok = is_curve(r, 0, &t);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* After the curve: x, times; wanted is the status. */
verdict gold_curve_insert_status(const row *r)
{
    et_curve c, t;
    size_t at = read_curve(r, &c);
    et_status status = et_curve_insert(&t, &c, row_real(r, at), row_size(r, at + 1));
    bool ok = at > 0 && row_is_size(r, 0, (size_t)status);
    et_curve_free(&c);
    if (status == ET_OK) {
        et_curve_free(&t);
    }
    return ok ? PASS : FAIL;
}

/* After the curve: x, times, tolerance; wanted: how often it was removed, the curve.  It can be removed exactly so often. */
verdict gold_curve_remove(const row *r)
{
    et_curve c, t;
    size_t at = read_curve(r, &c), removed = 0;
    if (at == 0 || et_curve_remove(&t, &removed, &c, row_real(r, at), row_size(r, at + 1), row_real(r, at + 2)) != ET_OK) {
        return FAIL;
    }
    bool ok = row_is(r, 0, (double)removed) && strtod(r->want[0], NULL) == (double)removed && is_curve(r, 1, &t);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* After the curve: times. */
verdict gold_curve_elevate(const row *r)
{
    et_curve c, t;
    size_t at = read_curve(r, &c);
    if (at == 0 || et_curve_elevate(&t, &c, row_size(r, at)) != ET_OK) {
        return FAIL;
    }
    bool ok = is_curve(r, 0, &t);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}
