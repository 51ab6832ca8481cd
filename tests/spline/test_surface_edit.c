/* spline/surface: knots inserted and removed, degrees elevated: line by line the bits of the curves', and any sequence of edits against the given surface. */
#include "surfaces.h"
#include <stdint.h>

static const double speck = 0x1p-700;         /* what underflows is below this */

static size_t lines(const et_surface *s, et_direction along)
{
    return along == ET_ALONG_U ? s->nv : s->nu;
}

/* The j-th of the surface's curves along the direction. */
static et_curve line_of(const et_surface *s, et_direction along, size_t j)
{
    bool u = along == ET_ALONG_U;
    size_t p = u ? s->p : s->q, n = u ? s->nu : s->nv;
    et_curve c = {0, 0, NULL, NULL, NULL};
    if (et_curve_new(&c, p, n, s->weights != NULL) != ET_OK) {
        abort();
    }
    memcpy(c.u, u ? s->u : s->v, (n + p + 1) * sizeof *c.u);
    for (size_t i = 0; i < n; i++) {
        size_t at = u ? i * s->nv + j : j * s->nv + i;
        c.points[i] = s->points[at];
        if (s->weights) {
            c.weights[i] = s->weights[at];
        }
    }
    return c;
}

/* The same bits, but for coordinates that underflow with the weight of one line and not with that of another. */
static bool same_line(const et_curve *a, const et_curve *b)
{
    bool ok = a->p == b->p && a->n == b->n && !a->weights == !b->weights && !memcmp(a->u, b->u, (a->n + a->p + 1) * sizeof *a->u);
    for (size_t i = 0; ok && i < 3 * a->n; i++) {
        double x = coordinate(&a->points[i / 3], (int)(i % 3)), y = coordinate(&b->points[i / 3], (int)(i % 3));
        ok = ref_same(x, y) || (a->weights && fabs(x - y) <= speck);
    }
    return ok && (!a->weights || !memcmp(a->weights, b->weights, a->n * sizeof *a->weights));
}

/* The knots across are those of before, and the j-th line is that curve. */
static bool is_line(gen *g, const et_surface *t, const et_surface *s, et_direction along, size_t j, const et_curve *want)
{
    et_curve c = line_of(t, along, j);
    bool ok = gen_check(g, same_line(&c, want), "line %zu along %s is another curve", j, along == ET_ALONG_U ? "u" : "v");
    et_curve_free(&c);
    ok = ok && gen_check(g, lines(t, along) == lines(s, along) && et_surface_valid(t), "%zu lines", lines(t, along));
    if (along == ET_ALONG_U) {
        return ok && gen_check(g, t->q == s->q && memcmp(t->v, s->v, (s->nv + s->q + 1) * sizeof *s->v) == 0, "knots across");
    }
    return ok && gen_check(g, t->p == s->p && memcmp(t->u, s->u, (s->nu + s->p + 1) * sizeof *s->u) == 0, "knots across");
}

static et_surface untouched(void)
{
    et_surface s;
    memset(&s, 0x3c, sizeof s);
    return s;
}

static bool is_untouched(const et_surface *s)
{
    et_surface t = untouched();
    return memcmp(s, &t, sizeof t) == 0;
}

static double draw_along(gen *g, const et_surface *s, et_direction along)
{
    return along == ET_ALONG_U ? draw_u(g, s) : draw_v(g, s);
}

/* One case in 2. */
verdict prop_surface_insert(gen *g)
{
    et_surface s, t = untouched();
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    et_direction along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    double x = draw_along(g, &s, along);
    size_t times = (size_t)gen_upto(g, 5);
    et_status status = et_surface_insert(&t, &s, along, x, times);
    bool ok = gen_check(g, status == ET_OK || is_untouched(&t), "the output was changed");
    for (size_t j = 0; ok && j < lines(&s, along); j++) {
        et_curve c = line_of(&s, along, j), d = {0, 0, NULL, NULL, NULL};
        ok = gen_check(g, et_curve_insert(&d, &c, x, times) == status, "status %d", (int)status);
        ok = ok && (status != ET_OK || is_line(g, &t, &s, along, j, &d));
        et_curve_free(&c);
        et_curve_free(&d);
    }
    gen_label(g, status == ET_OK ? "inserted" : "refused");
    et_surface_free(&s);
    if (status == ET_OK) {
        et_surface_free(&t);
    }
    return ok ? PASS : FAIL;
}

/* One case in 2. */
verdict prop_surface_elevate(gen *g)
{
    et_surface s, t = untouched();
    if (!draw_surface(g, &s, gen_upto(g, 1) == 1)) {
        return SKIP;
    }
    et_direction along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    size_t times = (size_t)gen_upto(g, 2);
    et_status status = et_surface_elevate(&t, &s, along, times);
    bool ok = gen_check(g, status == ET_OK || is_untouched(&t), "the output was changed");
    for (size_t j = 0; ok && j < lines(&s, along); j++) {
        et_curve c = line_of(&s, along, j), d = {0, 0, NULL, NULL, NULL};
        ok = gen_check(g, et_curve_elevate(&d, &c, times) == status, "status %d", (int)status);
        ok = ok && (status != ET_OK || is_line(g, &t, &s, along, j, &d));
        et_curve_free(&c);
        et_curve_free(&d);
    }
    gen_label(g, status == ET_OK ? "elevated" : "refused");
    et_surface_free(&s);
    if (status == ET_OK) {
        et_surface_free(&t);
    }
    return ok ? PASS : FAIL;
}

/* One removal is made if it may be of every line; several never more often than of any line.  (Of rational surfaces the tolerance depends on all weights.) */
/* One case in 2. */
verdict prop_surface_remove(gen *g)
{
    et_surface s, t = untouched();
    size_t removed = 77, least = 77;
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    et_direction along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    size_t p = along == ET_ALONG_U ? s.p : s.q, n = along == ET_ALONG_U ? s.nu : s.nv, times = (size_t)gen_upto(g, 3);
    double *u = along == ET_ALONG_U ? s.u : s.v, x = u[p + 1 < n ? p + 1 : n], tolerance = ldexp(1.0, (int)gen_upto(g, 130) - 20);
    if (gen_upto(g, 2) == 0) {                /* many lines that can do without the knot */
        for (size_t k = 0; k < s.nu * s.nv; k++) {
            s.points[k] = s.points[k > 0 && gen_upto(g, 7) ? k - 1 : k];
        }
    }
    et_status status = et_surface_remove(&t, &removed, &s, along, x, times, tolerance);
    bool ok = gen_check(g, status == ET_OK || (is_untouched(&t) && removed == 77), "outputs were changed");
    for (size_t j = 0; ok && j < lines(&s, along); j++) {
        et_curve c = line_of(&s, along, j), d = {0, 0, NULL, NULL, NULL};
        size_t one = 77;
        ok = gen_check(g, et_curve_remove(&d, &one, &c, x, times, tolerance) == status, "status %d", (int)status);
        least = one < least ? one : least;
        ok = ok && (status != ET_OK || s.weights || one != removed || is_line(g, &t, &s, along, j, &d));
        et_curve_free(&c);
        et_curve_free(&d);
    }
    ok = ok && gen_check(g, status != ET_OK || s.weights || (times > 1 ? removed <= least : removed == least), "%zu removed, of a line %zu", removed, least);
    ok = ok && gen_check(g, status != ET_OK || removed > 0 || same_surface(&t, &s), "not a copy");
    gen_label(g, status != ET_OK ? "refused" : removed > 0 ? "removed" : "not removed");
    et_surface_free(&s);
    if (status == ET_OK) {
        et_surface_free(&t);
    }
    return ok ? PASS : FAIL;
}

/* A knot inserted is removed: its lines' distances, few roundings, are below 2^-20 of the control net where spans are even. */
verdict prop_surface_remove_again(gen *g)
{
    et_surface s, t, back;
    size_t removed = 77, nu = 4 + (size_t)gen_upto(g, 3), times = 1 + (size_t)gen_upto(g, 1);
    int rational = (int)gen_upto(g, 1);
    et_direction along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    if (et_surface_new(&s, 3, 2, nu, 4, rational) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < nu + 4; i++) {
        s.u[i] = (double)(i < 4 ? 0 : i < nu ? i - 3 : nu - 3);
    }
    for (size_t i = 0; i < 7; i++) {
        s.v[i] = i < 3 ? 0.0 : i < 4 ? 1.0 : 2.0;
    }
    gen_points(g, &s.points[0].x, 4 * nu);
    double size = 0.0;
    for (size_t k = 0; k < 4 * nu; k++) {
        size = fmax(size, fmax(fabs(s.points[k].x), fmax(fabs(s.points[k].y), fabs(s.points[k].z))));
        if (rational) {
            s.weights[k] = gen_real(g, 0.5, 1.0);
        }
    }
    double tolerance = 0x1p-20 * size * (1.0 + size) + speck;
    bool ok = gen_check(g, et_surface_insert(&t, &s, along, 0.5, times) == ET_OK, "not inserted");
    ok = ok && gen_check(g, et_surface_remove(&back, &removed, &t, along, 0.5, times, tolerance) == ET_OK && removed == times, "not all of %zu", times);
    for (size_t k = 0; ok && k < 4 * nu && removed == times; k++) {
        ok = gen_check(g, fabs(back.points[k].x - s.points[k].x) <= 0x1p-30 * size + speck, "control point %zu: %a for %a", k, back.points[k].x, s.points[k].x);
    }
    et_surface_free(&s);
    et_surface_free(&t);
    et_surface_free(&back);
    return ok ? PASS : FAIL;
}

/* One line of several, quadratic: the point left of it would be infinite, or its weight not positive, or neither: then the knot goes, with no movement
 * allowed.  The other lines are 0 throughout and of equal weights. */
verdict prop_surface_remove_lines(gen *g)
{
    static const double u[] = {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0};
    size_t count = 2 + (size_t)gen_upto(g, 5), one = (size_t)gen_upto(g, count - 1), removed = 77, kind = (size_t)gen_upto(g, 2);
    et_direction along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    bool v = along == ET_ALONG_V;
    et_surface s, t = untouched();
    if (et_surface_new(&s, v ? 1 : 2, v ? 2 : 1, v ? count : 4, v ? 4 : count, kind == 1) != ET_OK) {
        return FAIL;
    }
    double *across = v ? s.u : s.v;
    memcpy(v ? s.v : s.u, u, sizeof u);
    for (size_t j = 0; j < count + 2; j++) {
        across[j] = j < 1 ? 0.0 : j > count ? (double)(count - 1) : (double)(j - 1);
    }
    /* Solved from the left as (P_1 - b P_0)/a with a = 2^-40. */
    if (kind == 2) {
        (v ? s.v : s.u)[3] = 0x1p-40;
    }
    for (size_t i = 0; i < 4; i++) {
        size_t at = v ? one * 4 + i : i * count + one;
        if (kind == 1) {
            s.weights[at] = i == 1 || i == 2 ? 1.0 : 4.0;
        }
        if (kind == 2) {
            s.points[at].y = i == 1 ? 0x1p1020 : 0.0;
        }
    }
    et_status status = et_surface_remove(&t, &removed, &s, along, (v ? s.v : s.u)[3], 1, kind == 0 ? 0.0 : 0x1p900);
    bool ok = gen_check(g, status == ET_OK && removed == (kind == 0), "line %zu of %zu, kind %zu: status %d, %zu removed", one, count, kind, (int)status, removed);
    ok = ok && gen_check(g, kind == 0 || same_surface(&t, &s), "not a copy");
    et_surface_free(&s);
    if (status == ET_OK) {
        et_surface_free(&t);
    }
    return ok ? PASS : FAIL;
}

verdict prop_surface_insert_refused(gen *g)
{
    et_surface s, t = untouched();
    size_t removed = 77;
    if (!draw_surface(g, &s, false)) {
        return SKIP;
    }
    et_direction none = (et_direction)2, along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    bool ok = gen_check(g, et_surface_insert(&t, &s, none, 0.5, 1) == ET_EINVAL && et_surface_elevate(&t, &s, none, 1) == ET_EINVAL &&
                               et_surface_remove(&t, &removed, &s, none, 0.5, 1, 1.0) == ET_EINVAL, "a direction that is none");
    ok = ok && gen_check(g, et_surface_insert(&t, &s, along, 2.0, 1) == ET_EINVAL && et_surface_insert(&t, &s, along, NAN, 1) == ET_EINVAL &&
                                et_surface_insert(&t, &s, along, 0.5, SIZE_MAX) == ET_EINVAL && et_surface_insert(&t, &s, along, 0.0, 1) == ET_EINVAL,
                         "insertion");
    ok = ok && gen_check(g, et_surface_remove(&t, &removed, &s, along, 0.0, 1, 1.0) == ET_EINVAL && et_surface_remove(&t, &removed, &s, along, 1.0, 1, 1.0) == ET_EINVAL &&
                                et_surface_remove(&t, &removed, &s, along, 0x1p-40, 1, 1.0) == ET_EINVAL, "removal of what is no inner knot");
    ok = ok && gen_check(g, et_surface_elevate(&t, &s, along, SIZE_MAX) == ET_ENOMEM && et_surface_elevate(&t, &s, along, SIZE_MAX / 2) == ET_ENOMEM &&
                                et_surface_elevate(&t, &s, along, SIZE_MAX - s.p) == ET_ENOMEM, "sizes beyond all");
    size_t p = along == ET_ALONG_U ? s.p : s.q, n = along == ET_ALONG_U ? s.nu : s.nv;
    double *u = along == ET_ALONG_U ? s.u : s.v, x = u[p + 1 < n ? p + 1 : 0];
    ok = ok && gen_check(g, et_surface_remove(&t, &removed, &s, along, x, 1, -1.0) == ET_EINVAL && et_surface_remove(&t, &removed, &s, along, x, 1, NAN) == ET_EINVAL &&
                                et_surface_remove(&t, &removed, &s, along, x, 1, HUGE_VAL) == ET_EINVAL, "tolerances");
    u[0] -= 1.0;
    ok = ok && gen_check(g, p == 0 || et_surface_elevate(&t, &s, along, 1) == ET_EINVAL, "ends not clamped");
    u[0] += 1.0;
    s.points[s.nu * s.nv - 1].z = NAN;
    ok = ok && gen_check(g, et_surface_insert(&t, &s, along, 0.5, 0) == ET_EINVAL && et_surface_elevate(&t, &s, along, 1) == ET_EINVAL &&
                                et_surface_remove(&t, &removed, &s, along, x, 1, 1.0) == ET_EINVAL, "a coordinate NaN");
    ok = ok && gen_check(g, is_untouched(&t) && removed == 77, "outputs were changed");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* The greatest weight, wherever it is, sets the scale of all: no product with a great coordinate overflows. */
verdict prop_surface_insert_scales(gen *g)
{
    et_surface s, t;
    et_direction along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    if (et_surface_new(&s, 1, 2, 3, 4, 1) != ET_OK) {
        return FAIL;
    }
    static const double u[] = {0.0, 0.0, 0.5, 1.0, 1.0}, v[] = {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0};
    memcpy(s.u, u, sizeof u);
    memcpy(s.v, v, sizeof v);
    for (size_t k = 0; k < 12; k++) {
        s.points[k] = (et_vec3){1e307, 1.0, -1e307};
        s.weights[k] = 1.0;
    }
    s.weights[gen_upto(g, 11)] = 0x1p1000;
    bool ok = gen_check(g, et_surface_insert(&t, &s, along, 0.25, 1) == ET_OK && t.nu * t.nv == (along == ET_ALONG_U ? 16 : 15), "not inserted");
    for (size_t k = 0; ok && k < t.nu * t.nv; k++) {
        ok = gen_check(g, fabs(t.points[k].x - 1e307) <= roundings(13.0) * 1e307 && fabs(t.points[k].y - 1.0) <= roundings(13.0), "control point %zu: %a", k,
                       t.points[k].x);
    }
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

/* ---- any sequence of edits ---- */

static double greatest(const et_surface *s)
{
    double most = 1.0;
    for (size_t k = 0; k < s->nu * s->nv; k++) {
        double w = s->weights ? fmax(s->weights[k], 1.0) : 1.0;
        most = fmax(most, w * fmax(1.0, fmax(fabs(s->points[k].x), fmax(fabs(s->points[k].y), fabs(s->points[k].z)))));
    }
    return most;
}

/* *t edited once at random, and what that may move a point by added to *off. */
static bool edit(gen *g, et_surface *t, double *off)
{
    et_surface next;
    et_direction along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    size_t kind = (size_t)gen_upto(g, 2), times = 1 + (size_t)gen_upto(g, 1), removed = 0, p = along == ET_ALONG_U ? t->p : t->q;
    double x = draw_along(g, t, along), size = greatest(t), tolerance = ldexp(size, -(int)gen_between(g, 4, 50)), least = 1.0;
    et_status status = ET_EINVAL;
    if (kind == 0 && t->nu < 12 && t->nv < 12) {
        status = et_surface_insert(&next, t, along, x, times);
        *off += status == ET_OK ? 2.0 * roundings(5.0 * (double)times + 3.0) * size : 0.0;
    } else if (kind == 1) {
        status = et_surface_remove(&next, &removed, t, along, x, times, tolerance);
        for (size_t k = 0; status == ET_OK && t->weights && k < next.nu * next.nv; k++) {
            least = fmin(least, next.weights[k]);
        }
        double top = status == ET_OK ? size + greatest(&next) : size;
        *off += removed > 0 ? tolerance * (1.0 + 0x1p-30) + (double)removed * 4.0 * roundings(8.0) * top * (t->weights ? (1.0 + top) / least : 1.0) : 0.0;
    } else if (kind == 2 && p < SURFACE_DEGREE + 2 && t->nu < 12 && t->nv < 12) {
        status = et_surface_elevate(&next, t, along, times);
        *off += status == ET_OK ? 2.0 * roundings((7.0 * (double)(p + 2) + 2.0) * (double)times + 3.0) * size : 0.0;
    }
    if (status == ET_OK) {
        gen_note(g, "%s along %s, %a", kind == 0 ? "insert" : kind == 1 ? "remove" : "elevate", along == ET_ALONG_U ? "u" : "v", x);
        gen_label(g, kind == 0 ? "inserted" : kind == 2 ? "elevated" : removed > 0 ? "removed" : "not removed");
        et_surface_free(t);
        *t = next;
    }
    return gen_check(g, status != ET_ENOMEM && et_surface_valid(t), "edit %zu: status %d", kind, (int)status);
}

/* One case in 4. */
verdict prop_surface_insert_sequence(gen *g)
{
    et_surface s, t;
    double off = speck;
    if (!draw_surface(g, &s, gen_upto(g, 1) == 1) || et_surface_copy(&t, &s) != ET_OK) {
        return SKIP;
    }
    size_t edits = (size_t)gen_upto(g, 7);
    bool ok = true;
    for (size_t k = 0; ok && k < edits; k++) {
        ok = edit(g, &t, &off);
    }
    for (size_t k = 0; ok && k < 4; k++) {
        double u = draw_u(g, &s), v = draw_v(g, &s);
        et_side a = gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT, b = gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
        fine e = fine_surface(&t, u, v, a, b), f = fine_surface(&s, u, v, a, b);
        for (int c = 0; ok && c < 3; c++) {
            double move = et_dd_sub(et_dd_div(e.value[c], e.value[3]), et_dd_div(f.value[c], f.value[3])).hi;
            ok = gen_check(g, fabs(move) <= off, "after %zu edits, at (%a, %a): coordinate %d moved by %g, within %g", edits, u, v, c, move, off);
        }
    }
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

/* ---- rows ---- */

/* What is wanted is a surface, written as those of the arguments are: sizes and knots to the bit, the rest as the row's class says. */
static bool is_surface(const row *r, size_t at, const et_surface *s)
{
    size_t n = s->nu * s->nv, rational = s->weights != NULL, sizes[5] = {s->p, s->q, s->nu, s->nv, rational}, ku = s->nu + s->p + 1, kv = s->nv + s->q + 1;
    bool ok = r->nwant == at + 5 + ku + kv + (rational ? 4 : 3) * n;
    for (size_t i = 0; ok && i < 5; i++, at++) {
        ok = strtod(r->want[at], NULL) == (double)sizes[i];
    }
    for (size_t i = 0; ok && i < ku + kv; i++, at++) {
        double x = i < ku ? s->u[i] : s->v[i - ku];
        ok = ref_same(strtod(r->want[at], NULL), x) && row_is(r, at, x);
    }
    for (size_t i = 0; ok && i < 3 * n; i++, at++) {
        ok = row_is(r, at, coordinate(&s->points[i / 3], (int)(i % 3)));
    }
    for (size_t i = 0; ok && rational && i < n; i++, at++) {
        ok = row_is(r, at, s->weights[i]);
    }
    return ok;
}

/* After the surface: direction (0 u, 1 v), x, times. */
verdict gold_surface_insert(const row *r)
{
    et_surface s, t;
    size_t at = read_surface(r, &s);
    if (at == 0 || et_surface_insert(&t, &s, (et_direction)row_size(r, at), row_real(r, at + 1), row_size(r, at + 2)) != ET_OK) {
        return FAIL;
    }
    bool ok = is_surface(r, 0, &t);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

/* After the surface: direction, x, times, tolerance; wanted: how often it was removed, the surface. */
verdict gold_surface_remove(const row *r)
{
    et_surface s, t;
    size_t at = read_surface(r, &s), removed = 0;
    if (at == 0 || et_surface_remove(&t, &removed, &s, (et_direction)row_size(r, at), row_real(r, at + 1), row_size(r, at + 2), row_real(r, at + 3)) != ET_OK) {
        return FAIL;
    }
    bool ok = row_is(r, 0, (double)removed) && strtod(r->want[0], NULL) == (double)removed && is_surface(r, 1, &t);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}

/* After the surface: direction, times. */
verdict gold_surface_elevate(const row *r)
{
    et_surface s, t;
    size_t at = read_surface(r, &s);
    if (at == 0 || et_surface_elevate(&t, &s, (et_direction)row_size(r, at), row_size(r, at + 1)) != ET_OK) {
        return FAIL;
    }
    bool ok = is_surface(r, 0, &t);
    et_surface_free(&s);
    et_surface_free(&t);
    return ok ? PASS : FAIL;
}
