/* exact/exact_edit: knots of surfaces inserted and removed, degrees elevated: each of their curves. */
#include "exact/edited.h"

/* ---- the functions, memory counted: ET_EINTERNAL if any is kept ---- */

/* Equal but for the signs of zeros. */
static bool equal_points(const et_vec3 *a, const et_vec3 *b, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (!(a[i].x == b[i].x && a[i].y == b[i].y && a[i].z == b[i].z)) {
            return false;
        }
    }
    return true;
}

static bool equal_curves(const et_curve *a, const et_curve *b)
{
    return a->p == b->p && a->n == b->n && same_reals(a->u, b->u, knots_of(a)) && equal_points(a->points, b->points, a->n) &&
           (a->weights == NULL) == (b->weights == NULL) && (a->weights == NULL || same_reals(a->weights, b->weights, a->n));
}

/* ---- surfaces: each of their curves ---- */

/* Curve k of the surface along a direction, with storage of its own. */
static bool curve_of(et_curve *c, const et_surface *s, et_direction along, size_t k)
{
    bool u = along == ET_ALONG_U;
    if (et_curve_new(c, u ? s->p : s->q, u ? s->nu : s->nv, s->weights != NULL) != ET_OK) {
        return false;
    }
    memcpy(c->u, u ? s->u : s->v, knots_of(c) * sizeof *c->u);
    for (size_t i = 0; i < c->n; i++) {
        size_t at = u ? i * s->nv + k : k * s->nv + i;
        c->points[i] = s->points[at];
        if (s->weights != NULL) {
            c->weights[i] = s->weights[at];
        }
    }
    return true;
}

static size_t curves_of(const et_surface *s, et_direction along)
{
    return along == ET_ALONG_U ? s->nv : s->nu;
}

typedef enum { INSERT, ELEVATE, REMOVE } edit;

static et_status edit_surface(et_surface *r, size_t *removed, const et_surface *s, et_direction along, edit what, double x, size_t times)
{
    return what == INSERT    ? surface_insert(r, s, along, x, times)
           : what == ELEVATE ? surface_elevate(r, s, along, times)
                             : surface_remove(r, removed, s, along, x, times);
}

static et_status edit_curve(et_curve *r, size_t *removed, const et_curve *c, edit what, double x, size_t times)
{
    return what == INSERT    ? curve_insert(r, c, x, times)
           : what == ELEVATE ? curve_elevate(r, c, times)
                             : curve_remove(r, removed, c, x, times);
}

/* How often a knot goes from all curves. */
static size_t least_removed(const et_surface *s, et_direction along, double x, size_t times)
{
    size_t least = times;
    for (size_t k = 0; k < curves_of(s, along); k++) {
        et_curve c, r;
        size_t removed = 0;
        if (curve_of(&c, s, along, k)) {
            if (curve_remove(&r, &removed, &c, x, times) == ET_OK) {
                et_curve_free(&r);
            }
            et_curve_free(&c);
        }
        least = removed < least ? removed : least;
    }
    return least;
}

/* The edited surface is made of the edited curves, and what is across stays. */
static bool as_curves(gen *g, const et_surface *s, et_direction along, edit what, double x, size_t times)
{
    et_surface r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t removed = 4711, often = times;
    et_status status = edit_surface(&r, &removed, s, along, what, x, times), want = ET_OK;
    if (status == ET_OK && what == REMOVE) {
        often = least_removed(s, along, x, times);
        if (!gen_check(g, removed == often, "%zu removed, not %zu", removed, often)) {
            et_surface_free(&r);
            return false;
        }
    }
    bool ok = true, u = along == ET_ALONG_U;
    for (size_t k = 0; ok && k < curves_of(s, along); k++) {
        et_curve c, d = {0, 0, NULL, NULL, NULL}, e = {0, 0, NULL, NULL, NULL};
        ok = curve_of(&c, s, along, k);
        want = edit_curve(&d, &removed, &c, what, x, often);
        ok = ok && gen_check(g, status == want, "status %d, of curve %zu %d", (int)status, k, (int)want);
        ok = ok && (want != ET_OK || (curve_of(&e, &r, along, k) && gen_check(g, equal_curves(&e, &d), "curve %zu is another one", k)));
        et_curve_free(&c);
        et_curve_free(&d);
        et_curve_free(&e);
    }
    if (ok && status == ET_OK) {
        ok = gen_check(g, u ? r.q == s->q && r.nv == s->nv && same_reals(r.v, s->v, s->nv + s->q + 1)
                            : r.p == s->p && r.nu == s->nu && same_reals(r.u, s->u, s->nu + s->p + 1), "the other direction changed");
        ok = ok && gen_check(g, (r.weights == NULL) == (s->weights == NULL), "weights");
        et_surface_free(&r);
    }
    return ok && gen_check(g, r.u == NULL && r.points == NULL, "changed on failure");
}

/* A surface of which one direction is clamped now and then, and a direction of it. */
static bool draw_edited(gen *g, et_surface *s, et_direction *along, size_t degree)
{
    if (!draw_surface(g, s, degree)) {
        return false;
    }
    *along = gen_upto(g, 1) ? ET_ALONG_V : ET_ALONG_U;
    gen_label(g, *along == ET_ALONG_V ? "along v" : "along u");
    return true;
}

verdict prop_exact_surface_insert(gen *g)
{
    et_surface s, r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    et_direction along;
    if (!draw_edited(g, &s, &along, 3)) {
        return SKIP;
    }
    bool u = along == ET_ALONG_U;
    double x = u ? draw_place(g, s.u, s.nu + s.p + 1, s.p) : draw_place(g, s.v, s.nv + s.q + 1, s.q);
    bool ok = as_curves(g, &s, along, INSERT, x, (size_t)gen_upto(g, 3));
    s.points[0].y = NAN;
    ok = ok && gen_check(g, surface_insert(&r, &s, along, x, 0) == ET_EINVAL && r.u == NULL, "a surface that is not valid");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_exact_surface_elevate(gen *g)
{
    et_surface s, r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    et_direction along;
    if (!draw_edited(g, &s, &along, 3)) {
        return SKIP;
    }
    bool ok = as_curves(g, &s, along, ELEVATE, 0.0, (size_t)gen_upto(g, 2));
    ok = ok && gen_check(g, surface_elevate(&r, &s, along, SIZE_MAX) != ET_OK && r.u == NULL, "a degree beyond all sizes");
    s.points[0].y = NAN;
    ok = ok && gen_check(g, surface_elevate(&r, &s, along, 0) == ET_EINVAL && r.u == NULL, "a surface that is not valid");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_exact_surface_remove(gen *g)
{
    et_surface s, r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    et_direction along;
    size_t removed = 4711;
    if (!draw_edited(g, &s, &along, 3)) {
        return SKIP;
    }
    bool u = along == ET_ALONG_U;
    size_t p = u ? s.p : s.q, n = u ? s.nu : s.nv;
    double *knot = u ? s.u : s.v;
    for (size_t i = 0; i < n + p + 1; i++) {                /* whole numbers, and points of which sums of halves and sixths are doubles */
        knot[i] = i == 0 ? 0.0 : knot[i - 1] + (gen_upto(g, 3) != 3 ? 1.0 : 0.0);
    }
    for (size_t k = 0; k < s.nu * s.nv; k++) {
        s.points[k] = (et_vec3){46656.0 * (double)gen_upto(g, 16), 46656.0 * (double)gen_upto(g, 1), 0.0};
        if (s.weights != NULL) {
            s.weights[k] = 1.0;
        }
    }
    if (!et_surface_valid(&s) || !(knot[n] - knot[p] > 1.0)) {
        et_surface_free(&s);
        return SKIP;
    }
    double x = knot[p] + (double)(1 + gen_upto(g, (uint64_t)(2.0 * (knot[n] - knot[p])) - 2)) / 2.0;
    size_t m = multiplicity(knot, n + p + 1, x), times = m <= p ? 1 + (size_t)gen_upto(g, p - m) : 0;
    bool ok = gen_check(g, surface_insert(&r, &s, along, x, times) == ET_OK, "not inserted");
    if (ok && gen_chance(g, 3)) {
        size_t i = (size_t)gen_upto(g, r.nu * r.nv - 1);
        r.points[i].z = 1.0;
        gen_label(g, "one point off");
    }
    if (ok) {
        ok = as_curves(g, &r, along, REMOVE, x, (size_t)gen_upto(g, 3)) && as_curves(g, &r, along, REMOVE, x, times + m);
        et_surface_free(&r);
        r = (et_surface){0, 0, 0, 0, NULL, NULL, NULL, NULL};
    }
    ok = ok && gen_check(g, surface_remove(&r, &removed, &s, along, knot[p], 1) == ET_EINVAL && r.u == NULL && removed == 4711, "at an end");
    s.points[0].y = NAN;
    ok = ok && gen_check(g, surface_remove(&r, &removed, &s, along, x, 0) == ET_EINVAL && r.u == NULL && removed == 4711, "not valid");
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Lines of constant weight but for one, in which a weight would become negative if the knot went twice. */
verdict prop_exact_surface_remove_weights(gen *g)
{
    static const double knots[] = {0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0}, weights[] = {1.0, 0.375, 0.375, 0.375, 1.0};
    et_surface s, r = {0, 0, 0, 0, NULL, NULL, NULL, NULL};
    size_t removed = 0, lines = 2 + (size_t)gen_upto(g, 2), odd = (size_t)gen_upto(g, lines);
    bool u = gen_upto(g, 1) == 0;
    if (et_surface_new(&s, u ? 2 : 1, u ? 1 : 2, u ? 5 : lines, u ? lines : 5, 1) != ET_OK) {
        return FAIL;
    }
    double *across = u ? s.v : s.u;
    memcpy(u ? s.u : s.v, knots, sizeof knots);
    for (size_t i = 0; i < lines + 2; i++) {
        across[i] = (double)i;
    }
    for (size_t k = 0; k < 5 * lines; k++) {
        size_t line = u ? k % lines : k / 5;
        s.weights[k] = line == odd ? weights[u ? k / lines : k % 5] : 1.0;
    }
    size_t want = odd < lines ? 1 : 2;
    bool ok = gen_check(g, surface_remove(&r, &removed, &s, u ? ET_ALONG_U : ET_ALONG_V, 0.5, 2) == ET_OK && removed == want, "%zu removed", removed);
    for (size_t k = 0; ok && k < (5 - want) * lines; k++) {
        size_t line = u ? k % lines : k / (5 - want), i = u ? k / lines : k % (5 - want);
        ok = gen_check(g, r.weights[k] == (line == odd && i > 0 && i < 3 ? 0.375 : 1.0), "line %zu, weight %zu: %g", line, i, r.weights[k]);
    }
    et_surface_free(&s);
    et_surface_free(&r);
    return ok ? PASS : FAIL;
}
