/* spline/curve: copies, one-sided derivatives, knots inserted and removed, degrees elevated: the edited curve against the given one in double-double, within
 * the bounds that the header states, at as many places as determine it. */
#include "curves.h"
#include "etalon/spline/knots.h"
#include <float.h>
#include <stdint.h>

enum { PLACES = 256 };

static const double speck = 0x1p-700;         /* what underflows is below this */

/* ---- what the edits have in common ---- */

/* The Greville points and both sides of the knots of the domain: they determine a spline. */
typedef struct { double x[PLACES]; et_side side[PLACES]; size_t n; } places;

static void add(places *at, double x, et_side side)
{
    if (at->n < PLACES) {
        at->x[at->n] = x;
        at->side[at->n++] = side;
    }
}

static places places_of(const et_curve *c)
{
    double greville[PLACES];
    places at = {{0.0}, {ET_SIDE_RIGHT}, 0};
    et_knots_greville(greville, c->n, c->u, c->n + c->p + 1, c->p);
    for (size_t i = 0; i < c->n; i++) {
        add(&at, fmin(fmax(greville[i], c->u[c->p]), c->u[c->n]), ET_SIDE_RIGHT);
    }
    for (size_t i = c->p; i <= c->n; i++) {
        add(&at, c->u[i], ET_SIDE_RIGHT);
        add(&at, c->u[i], ET_SIDE_LEFT);
    }
    return at;
}

/* The edited curve is the given one: a weight of it m roundings off, w times a coordinate m + 1, and the division's. */
static bool agree(gen *g, const et_curve *edited, const et_curve *c, double m)
{
    places at = places_of(edited);
    bool ok = true;
    for (size_t k = 0; ok && k < at.n; k++) {
        fine e = fine_point(edited, at.x[k], at.side[k]), f = fine_point(c, at.x[k], at.side[k]);
        for (int a = 0; ok && a < 4; a++) {
            double bound = roundings(a < 3 && c->weights ? m + 2.0 : m) * f.size[a] + 0x1p-90 * f.size[a] + speck;
            ok = gen_check(g, dd_off(e.value[a], f.value[a]) <= bound, "at %a, side %d, coordinate %d is %a for %a, within %a", at.x[k], (int)at.side[k], a,
                           e.value[a].hi, f.value[a].hi, bound);
        }
    }
    return ok;
}

static size_t knots(const et_curve *c)
{
    return c->n + c->p + 1;
}

/* Output that nothing has written to. */
static et_curve untouched(void)
{
    et_curve c;
    memset(&c, 0x3c, sizeof c);
    return c;
}

static bool is_untouched(const et_curve *c)
{
    et_curve t = untouched();
    return memcmp(c, &t, sizeof t) == 0;
}

/* A place to insert at, and how often: up to what is allowed. */
static bool draw_site(gen *g, const et_curve *c, double *x, size_t *times)
{
    *x = draw_x(g, c);
    size_t s = et_knots_multiplicity(c->u, knots(c), *x);
    if (s > c->p + 1) {
        return false;
    }
    *times = (size_t)gen_upto(g, c->p + 1 - s);
    gen_note(g, "the knot %a, %zu times there, %zu times more", *x, s, *times);
    gen_label(g, s == 0 ? "new knot" : s + *times == c->p + 1 ? "to multiplicity p + 1" : "knot there");
    return true;
}

/* The knots with x so often more, in order. */
static void merge(double *v, const et_curve *c, double x, size_t times)
{
    size_t k = 0;
    for (size_t i = 0; i < knots(c); i++) {
        v[k++] = c->u[i];
        for (size_t t = 0; t < times && c->u[i] <= x && (i + 1 == knots(c) || c->u[i + 1] > x); t++) {
            v[k++] = x;
        }
    }
}

/* ---- copies, sides ---- */

verdict prop_curve_copy(gen *g)
{
    et_curve c, t = untouched(), none = {3, 3, NULL, NULL, NULL};
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    bool ok = gen_check(g, et_curve_copy(&t, &none) == ET_EINVAL && is_untouched(&t), "a copy of nothing");
    if (!gen_check(g, et_curve_copy(&t, &c) == ET_OK, "no copy")) {
        return FAIL;
    }
    ok = ok && gen_check(g, same_curve(&t, &c), "another curve");
    ok = ok && gen_check(g, t.u != c.u && t.points != c.points && (t.weights != c.weights || !c.weights), "shared storage");
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* The curve run backwards: its right is the other's left. */
static bool backwards(et_curve *back, const et_curve *c)
{
    if (et_curve_copy(back, c) != ET_OK) {
        return false;
    }
    for (size_t i = 0; i < knots(c); i++) {
        back->u[i] = -c->u[knots(c) - 1 - i];
    }
    for (size_t i = 0; i < c->n; i++) {
        back->points[i] = c->points[c->n - 1 - i];
        if (c->weights) {
            back->weights[i] = c->weights[c->n - 1 - i];
        }
    }
    return true;
}

verdict prop_curve_ders_side(gen *g)
{
    et_curve c, back;
    et_vec3 D[ORDER + 2], E[ORDER + 1];
    if (!draw(g, &c, true) || !backwards(&back, &c)) {
        return SKIP;
    }
    double x = draw_x(g, &c);
    if (gen_chance(g, 8)) {
        x = gen_upto(g, 1) ? c.u[c.n] + 1.0 : c.u[c.p] - 1.0;
        gen_label(g, "outside");
    }
    size_t d = (size_t)gen_upto(g, ORDER), n = et_curve_work(&c, d);
    double *work = et_size_array(n + 1, sizeof(double)), sign = 1.0, inside = fmin(fmax(x, c.u[c.p]), c.u[c.n]);
    work[n] = D[d + 1].x = 4711.0;
    et_curve_ders(E, d, &c, x, work, n);
    et_curve_ders_side(D, d, &c, x, ET_SIDE_RIGHT, work, n);
    bool ok = gen_check(g, memcmp(D, E, (d + 1) * sizeof *D) == 0 || isnan(D[d].x + D[d].y + D[d].z), "from the right other bits");
    et_curve_ders_side(D, d, &c, x, ET_SIDE_LEFT, work, n);
    ok = ok && gen_check(g, work[n] == 4711.0 && D[d + 1].x == 4711.0, "wrote beyond");
    sums A[ORDER + 1];
    for (size_t k = 0; k <= d; k++, sign = -sign) {
        A[k] = brute(&back, -inside, k);
        for (int a = 0; a < 4; a++) {
            A[k].value[a] *= sign;
        }
        if (!c.weights) {
            A[k].value[0] = A[k].size[0] = k == 0 ? 1.0 : 0.0;
        }
    }
    for (size_t k = 0; k <= d; k++) {                        /* Leibniz' rule, as from the right */
        for (int a = 0; ok && a < 3; a++) {
            double sum = 0.0, size = A[k].size[a + 1], binomial = 1.0;
            for (size_t i = 0; i <= k; i++) {
                sum += binomial * A[i].value[0] * coordinate(&D[k - i], a);
                size += binomial * A[i].size[0] * fabs(coordinate(&D[k - i], a));
                binomial = binomial * (double)(k - i) / (double)(i + 1);
            }
            ok = !(size < 0x1p900) || gen_check(g, fabs(sum - A[k].value[a + 1]) <= slack(&c) * size + 0x1p-300,
                                                "%a from the left: derivative %zu, coordinate %d: %a for %a", x, k, a, sum, A[k].value[a + 1]);
        }
        ok = ok && gen_check(g, c.weights || k <= c.p || same_point(D[k], (et_vec3){0.0, 0.0, 0.0}), "derivative %zu of degree %zu", k, c.p);
    }
    free(work);
    et_curve_free(&c);
    et_curve_free(&back);
    return ok ? PASS : FAIL;
}

/* ---- insertion ---- */

verdict prop_curve_insert(gen *g)
{
    et_curve c, t = untouched();
    double x, v[REF_KNOTS];
    size_t times;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    if (!draw_site(g, &c, &x, &times)) {
        et_curve_free(&c);
        return SKIP;
    }
    merge(v, &c, x, times);
    et_status status = et_curve_insert(&t, &c, x, times);
    if (!et_knots_valid(v, knots(&c) + times, c.p)) {
        gen_label(g, "too near");
        bool kept = gen_check(g, status == ET_EINVAL && is_untouched(&t), "knots too near each other: %d", (int)status);
        et_curve_free(&c);
        return kept ? PASS : FAIL;
    }
    if (!gen_check(g, status == ET_OK, "status %d", (int)status)) {
        return FAIL;
    }
    bool ok = gen_check(g, t.p == c.p && t.n == c.n + times && !t.weights == !c.weights && et_curve_valid(&t), "%zu points", t.n);
    ok = ok && gen_check(g, memcmp(t.u, v, knots(&t) * sizeof *v) == 0, "other knots");
    ok = ok && agree(g, &t, &c, 5.0 * (double)(times < c.p ? times : c.p));
    /* Out of reach of x, every bit. */
    size_t s = et_knots_multiplicity(c.u, knots(&c), x), below = 0;
    while (below < knots(&c) && c.u[below] <= x) {
        below++;
    }
    for (size_t i = 0; ok && i < c.n; i++) {
        size_t j = i + c.p < below ? i : i + times;
        bool kept = i + c.p < below || i + s + 1 > below;
        ok = !kept || gen_check(g, same_point(t.points[j], c.points[i]) && (!c.weights || ref_same(t.weights[j], c.weights[i])), "control point %zu", i);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Several times at once are the bits of one after the other, up to multiplicity p + 1, where the curve falls apart; so are weights of any one power of two. */
verdict prop_curve_insert_steps(gen *g)
{
    et_curve c, t, once, next;
    double x;
    size_t times;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    if (!draw_site(g, &c, &x, &times) || et_curve_insert(&t, &c, x, times) != ET_OK) {
        et_curve_free(&c);
        return SKIP;
    }
    bool ok = et_curve_copy(&once, &c) == ET_OK;
    fine C = fine_point(&c, x, ET_SIDE_LEFT);
    double w = c.weights ? C.value[3].hi : 1.0;
    for (size_t k = 0; ok && k < times && !c.weights; k++) {
        ok = gen_check(g, et_curve_insert(&next, &once, x, 1) == ET_OK, "no step %zu", k);
        et_curve_free(&once);
        once = next;
    }
    ok = ok && gen_check(g, c.weights || same_curve(&t, &once), "other bits than one after the other");
    et_curve_free(&once);
    if (ok && c.weights) {
        static const int powers[] = {0, 1, 40, 1000, -1000};
        int e = powers[gen_upto(g, 4)];
        for (size_t i = 0; i < c.n; i++) {
            c.weights[i] = ldexp(c.weights[i], e);
        }
        ok = gen_check(g, et_curve_insert(&next, &c, x, times) == ET_OK, "weights of 2^%d", e);
        for (size_t i = 0; ok && i < t.n; i++) {
            ok = gen_check(g, same_point(next.points[i], t.points[i]) && next.weights[i] == ldexp(t.weights[i], e), "weights of 2^%d: point %zu", e, i);
        }
        et_curve_free(&next);
    }
    size_t s = et_knots_multiplicity(t.u, knots(&t), x), k = 0;
    while (s == t.p + 1 && t.u[k] < x) {
        k++;
    }
    /* Both parts end where they meet. */
    if (ok && times > 0 && s == t.p + 1 && x > c.u[c.p] && x < c.u[c.n]) {
        for (int a = 0; ok && a < 3; a++) {
            double bound = 2.0 * roundings(5.0 * (double)c.p + 3.0) * C.size[a] / w + speck;
            ok = gen_check(g, fabs(coordinate(&t.points[k - 1], a) - C.value[a].hi / w) <= bound, "the end before %a", x);
        }
        ok = ok && gen_check(g, times > 1 || same_point(t.points[k - 1], t.points[k]), "two ends at %a", x);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* What is refused leaves the output alone. */
verdict prop_curve_insert_refused(gen *g)
{
    et_curve c, t = untouched();
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    double x = c.u[c.p] + 0.5 * (c.u[c.n] - c.u[c.p]), lo = c.u[c.p], hi = c.u[c.n], *u = c.u, *weights = c.weights;
    size_t s = et_knots_multiplicity(c.u, knots(&c), x), most = s > c.p ? 0 : c.p + 1 - s;
    bool ok = gen_check(g, et_curve_insert(&t, &c, x, most + 1) == ET_EINVAL && et_curve_insert(&t, &c, x, SIZE_MAX) == ET_EINVAL &&
                               et_curve_insert(&t, &c, x, SIZE_MAX - s) == ET_EINVAL, "%zu times there, %zu more", s, most + 1);
    ok = ok && gen_check(g, et_curve_insert(&t, &c, NAN, 1) == ET_EINVAL && et_curve_insert(&t, &c, HUGE_VAL, 1) == ET_EINVAL &&
                                et_curve_insert(&t, &c, nextafter(lo, -HUGE_VAL), 1) == ET_EINVAL &&
                                et_curve_insert(&t, &c, nextafter(hi, HUGE_VAL), 0) == ET_EINVAL, "outside the domain");
    c.u = NULL;
    ok = ok && gen_check(g, et_curve_insert(&t, &c, x, 0) == ET_EINVAL, "no curve");
    c.u = u;
    c.points[0].y = NAN;
    ok = ok && gen_check(g, et_curve_insert(&t, &c, x, 0) == ET_EINVAL, "a coordinate NaN");
    c.points[0].y = 0.0;
    c.weights = weights;
    ok = ok && gen_check(g, is_untouched(&t), "the output was changed");
    if (ok && most > 0) {
        ok = gen_check(g, et_curve_insert(&t, &c, x, most) == ET_OK, "%zu times there, %zu more", s, most);
        et_curve_free(ok ? &t : &c);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* The greatest coordinates, weights of all sizes: nothing overflows on the way; a weight that vanishes is refused. */
verdict prop_curve_insert_scales(gen *g)
{
    et_curve c, t = untouched();
    size_t p = 1 + (size_t)gen_upto(g, 4);
    if (et_curve_new(&c, p, p + 1, 1) != ET_OK) {
        return FAIL;
    }
    double most = gen_upto(g, 1) ? 1e307 : 1e-300, x = gen_real(g, 0.0625, 0.9375), unit = gen_upto(g, 1) ? 0x1p1020 : 0x1p-1060;
    size_t heavy = (size_t)gen_upto(g, p);
    for (size_t i = 0; i <= p; i++) {
        c.u[p + 1 + i] = 1.0;
        c.points[i] = (et_vec3){most, (double)i * most, -most};
        c.weights[i] = unit;
    }
    bool ok = gen_check(g, et_curve_insert(&t, &c, x, 1) == ET_OK, "not inserted");
    for (size_t i = 0; ok && i <= p + 1; i++) {
        /* Coordinates that do not change: seven roundings and the division's denominator's. */
        ok = gen_check(g, fabs(t.points[i].x - most) <= roundings(13.0) * most && fabs(t.weights[i] - unit) <= roundings(5.0) * unit + 0x1p-1074,
                       "point %zu: %a of weight %a", i, t.points[i].x, t.weights[i]);
    }
    if (ok) {
        et_curve_free(&t);
        c.weights[heavy] = unit > 1.0 ? 0x1p1023 : 0x1p-1040;      /* one that would overflow for itself */
        ok = gen_check(g, et_curve_insert(&t, &c, x, 1) == ET_OK, "weight %zu the greatest", heavy);
    }
    for (size_t i = 0; ok && i <= p + 1; i++) {
        ok = gen_check(g, fabs(t.points[i].x - most) <= roundings(13.0) * most, "point %zu: %a", i, t.points[i].x);
    }
    if (ok) {
        et_curve_free(&t);
    }
    t = untouched();
    if (ok && p == 1) {                       /* the combination of two least weights is one of them, or nothing */
        c.weights[1] = DBL_MAX;
        c.weights[0] = 1.0;
        ok = gen_check(g, et_curve_insert(&t, &c, 0.5, 1) == ET_OK && t.weights[1] == 0.5 * DBL_MAX, "weights 1 and the greatest");
        et_curve_free(&t);
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* ---- removal ---- */

/* How far the points solved for may be off: known ones by e, of magnitude `size` at most; and the deviation found at the end. */
typedef struct { double off, deviation; } spread;

/* Along one side of the equations: c[k] of the point solved for, 1 - c[k] of the one before. */
static double solved(double off, double share, double e, double size)
{
    return (e + (1.0 - share) * off + roundings(6.0) * (3.0 * (size + off) + e)) / share;
}

static spread removal_errors(const et_curve *c, double x, double e, double size)
{
    size_t p = c->p, s = et_knots_multiplicity(c->u, knots(c), x), r = 0, equations = s <= p ? p + 1 - s : 0;
    while (c->u[r + 1] <= x) {
        r++;
    }
    double left = e, right = e, most = e, a = 0.5;
    for (size_t k = 0; k < equations / 2; k++) {
        size_t i = r - p + k, j = r - s - k;
        left = solved(left, (x - c->u[i]) / (c->u[i + p + 1] - c->u[i]), e, size);
        right = solved(right, (c->u[j + p + 1] - x) / (c->u[j + p + 1] - c->u[j]), e, size);
        most = fmax(most, fmax(left, right));
    }
    if (equations % 2 == 1) {
        size_t i = r - p + equations / 2;
        a = (x - c->u[i]) / (c->u[i + p + 1] - c->u[i]);
        return (spread){most, e + a * right + (1.0 - a) * left + roundings(8.0) * (size + e + left + right)};
    }
    return (spread){most, left + right + roundings(4.0) * (size + left + right)};
}

static double greatest(const et_curve *c)
{
    double most = 0.0;
    for (size_t i = 0; i < c->n; i++) {
        double w = c->weights ? fmax(c->weights[i], 1.0) : 1.0;
        most = fmax(most, w * fmax(1.0, fmax(fabs(c->points[i].x), fmax(fabs(c->points[i].y), fabs(c->points[i].z)))));
    }
    return most;
}

/* What was inserted is removed again, with a tolerance not more than what roundings can make of it. */
verdict prop_curve_remove(gen *g)
{
    et_curve c, want, t, back = untouched();
    double x;
    size_t times, removed = 77;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    if (!draw_site(g, &c, &x, &times) || times == 0 || x <= c.u[c.p] || x >= c.u[c.n] || et_curve_insert(&t, &c, x, times) != ET_OK) {
        et_curve_free(&c);
        return SKIP;
    }
    bool ok = et_curve_insert(&want, &c, x, times - 1) == ET_OK;
    double size = greatest(&c), e = 2.0 * roundings(5.0 * (double)times + 2.0) * size + speck, least = 1.0, most = 0.0;
    spread s = removal_errors(&t, x, e, size);
    for (size_t i = 0; i < t.n; i++) {
        et_vec3 P = t.points[i];
        least = t.weights ? fmin(least, t.weights[i]) : 1.0;
        most = fmax(most, fabs(P.x) + fabs(P.y) + fabs(P.z));
    }
    /* Four coordinates; and so that with weights |e_A| + (|P| + tolerance) |e_w| is not more than tolerance w. */
    double d = 2.0 * (1.0 + 0x1p-20) * s.deviation, tolerance = !t.weights ? d : d < 0.5 * least ? 2.0 * d * (1.0 + most) / least / (1.0 - d / least) : NAN;
    if (!ok || !isfinite(tolerance) || tolerance > 0x1p900) {
        gen_label(g, "ill-conditioned");
    } else {
        ok = gen_check(g, et_curve_remove(&back, &removed, &t, x, 1, tolerance) == ET_OK && removed == 1, "not removed within %g", tolerance);
        ok = ok && gen_check(g, back.p == c.p && back.n == t.n - 1 && memcmp(back.u, want.u, knots(&want) * sizeof *want.u) == 0, "other knots");
        for (size_t i = 0; ok && i < want.n && !c.weights; i++) {
            for (int a = 0; ok && a < 3; a++) {
                ok = gen_check(g, fabs(coordinate(&back.points[i], a) - coordinate(&want.points[i], a)) <= s.off + e, "control point %zu, coordinate %d: %a for %a",
                               i, a, coordinate(&back.points[i], a), coordinate(&want.points[i], a));
            }
        }
        if (removed == 1) {
            et_curve_free(&back);
        }
    }
    et_curve_free(&c);
    et_curve_free(&t);
    et_curve_free(&want);
    return ok ? PASS : FAIL;
}

/* Whatever is removed moves no point by more than the tolerance, but for roundings; what is not removed leaves a copy. */
verdict prop_curve_remove_tolerance(gen *g)
{
    et_curve c, t;
    size_t removed = 77;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    size_t k = c.p + 1 + (size_t)gen_upto(g, c.n - c.p - 1), times = (size_t)gen_upto(g, c.p + 2);
    double x = c.u[k < c.n ? k : c.n - 1], size = greatest(&c), tolerance = gen_chance(g, 8) ? 0.0 : ldexp(size, (int)gen_upto(g, 12) - 9);
    if (x <= c.u[c.p] || x >= c.u[c.n]) {
        et_curve_free(&c);
        return SKIP;
    }
    if (!gen_check(g, et_curve_remove(&t, &removed, &c, x, times, tolerance) == ET_OK, "status")) {
        return FAIL;
    }
    size_t s = et_knots_multiplicity(c.u, knots(&c), x);
    bool ok = gen_check(g, removed <= times && removed <= s && t.n == c.n - removed && et_curve_valid(&t), "%zu of %zu", removed, s);
    ok = ok && gen_check(g, et_knots_multiplicity(t.u, knots(&t), x) == s - removed, "multiplicity");
    ok = ok && gen_check(g, removed > 0 || same_curve(&t, &c), "not a copy");
    gen_label(g, removed > 0 ? "removed" : "not removed");
    places at = places_of(&t);
    double least = 1.0, top = greatest(&t);
    for (size_t i = 0; c.weights && i < t.n; i++) {
        least = fmin(least, t.weights[i]);
    }
    for (size_t i = 0; ok && removed > 0 && i < at.n; i++) {
        fine e = fine_point(&t, at.x[i], at.side[i]), f = fine_point(&c, at.x[i], at.side[i]);
        double move[3];
        for (int a = 0; a < 3; a++) {
            move[a] = et_dd_sub(et_dd_div(e.value[a], e.value[3]), et_dd_div(f.value[a], f.value[3])).hi;
        }
        /* Each removal's residual, w c and w; seven roundings with those of storing. */
        double rounded = (double)removed * 4.0 * roundings(8.0) * (top + size) * (c.weights ? (1.0 + top) / least : 1.0);
        double moved = sqrt(move[0] * move[0] + move[1] * move[1] + move[2] * move[2]);
        ok = gen_check(g, moved <= tolerance * (1.0 + 0x1p-30) + rounded + speck, "at %a moved by %g, tolerance %g", at.x[i], moved, tolerance);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* With any movement allowed every knot goes, and several at once give the bits of one after the other. */
verdict prop_curve_remove_steps(gen *g)
{
    et_curve c, t, once, next;
    size_t removed = 77, one = 77;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    size_t k = c.p + 1 + (size_t)gen_upto(g, c.n - c.p - 1), times = (size_t)gen_upto(g, c.p + 1);
    double x = c.u[k < c.n ? k : c.n - 1];
    if (c.weights || x <= c.u[c.p] || x >= c.u[c.n]) {
        et_curve_free(&c);
        return SKIP;
    }
    size_t s = et_knots_multiplicity(c.u, knots(&c), x), want = times < s ? times : s;
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, x, times, 1e300) == ET_OK && removed == want, "%zu of %zu removed", removed, s);
    ok = ok && et_curve_copy(&once, &c) == ET_OK;
    for (size_t i = 0; ok && i < want; i++) {
        ok = gen_check(g, et_curve_remove(&next, &one, &once, x, 1, 1e300) == ET_OK && one == 1, "no step %zu", i);
        et_curve_free(&once);
        once = next;
    }
    ok = ok && gen_check(g, same_curve(&t, &once), "other bits than one after the other");
    et_curve_free(&c);
    et_curve_free(&t);
    et_curve_free(&once);
    return ok ? PASS : FAIL;
}

/* Two lines that nearly meet, b and c apart by 1 unit at the middle of a and d, which is 2 more away: the removals' distances add up. */
verdict prop_curve_remove_budget(gen *g)
{
    static const struct { double tolerance; size_t removed; } cases[] = {{0.0, 0}, {0.99, 0}, {1.0, 1}, {2.5, 1}, {2.99, 1}, {3.0, 2}, {1e9, 2}};
    double unit = ldexp(1.0, -(int)gen_upto(g, 20)), weight = ldexp(1.0, (int)gen_upto(g, 40) - 20);
    size_t k = (size_t)gen_upto(g, 6), removed = 77, axis = (size_t)gen_upto(g, 2);
    int rational = (int)gen_upto(g, 1);
    et_curve c, t;
    if (et_curve_new(&c, 1, 4, rational) != ET_OK) {
        return FAIL;
    }
    static const double u[] = {0.0, 0.0, 0.5, 0.5, 1.0, 1.0}, value[] = {0.0, 3.0, 2.0, 0.0};
    memcpy(c.u, u, sizeof u);
    for (size_t i = 0; i < 4; i++) {
        (&c.points[i].x)[axis] = value[i] * unit;
        if (rational) {
            c.weights[i] = weight;
        }
    }
    /* Equal weights do not matter. */
    double tolerance = cases[k].tolerance * unit;
    size_t want = cases[k].removed;
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, 0.5, 2, tolerance) == ET_OK && removed == want, "%g: %zu removed for %zu", tolerance, removed, want);
    ok = ok && gen_check(g, same_point(t.points[0], c.points[0]) && same_point(t.points[t.n - 1], c.points[3]), "other ends");
    ok = ok && gen_check(g, removed != 1 || same_point(t.points[1], c.points[2]), "one point of two is left");
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Degree 1: what it takes to remove the middle point is known by hand: |e_A| + (max |P| + T) |e_w| <= T min w.  At any scale. */
verdict prop_curve_remove_threshold(gen *g)
{
    static const double u[] = {0.0, 0.0, 0.5, 1.0, 1.0};
    int rational = (int)gen_upto(g, 1), e = (int)gen_upto(g, 600) - 300, f = (int)gen_upto(g, 1200) - 600;
    et_curve c, t;
    et_vec3 A = {0.0, 0.0, 0.0};
    double w = 0.0, most = 0.0, least = HUGE_VAL;
    if (et_curve_new(&c, 1, 3, rational) != ET_OK) {
        return FAIL;
    }
    memcpy(c.u, u, sizeof u);
    for (size_t i = 0; i < 3; i++) {
        et_vec3 P = {(double)gen_upto(g, 16) - 8.0, (double)gen_upto(g, 16) - 8.0, (double)gen_upto(g, 16) - 8.0};
        double weight = rational ? (double)gen_between(g, 8, 16) / 8.0 : 1.0, share = (i == 1 ? 1.0 : -0.5) * weight;
        A = (et_vec3){A.x + share * P.x, A.y + share * P.y, A.z + share * P.z};
        w += share;
        most = fmax(most, sqrt(P.x * P.x + P.y * P.y + P.z * P.z));
        least = fmin(least, weight);
        c.points[i] = (et_vec3){ldexp(P.x, e), ldexp(P.y, e), ldexp(P.z, e)};
        if (rational) {
            c.weights[i] = ldexp(weight, f);
        }
    }
    double need = ldexp((sqrt(A.x * A.x + A.y * A.y + A.z * A.z) + most * fabs(w)) / (least - fabs(w)), e);
    size_t less = 77, more = 77;
    if (least <= fabs(w)) {                   /* a weight might vanish: no tolerance is enough */
        bool kept = gen_check(g, et_curve_remove(&t, &more, &c, 0.5, 1, ldexp(1.0, e + 20)) == ET_OK && (more == 0 || most == 0.0), "removed");
        et_curve_free(&c);
        et_curve_free(&t);
        return kept ? PASS : FAIL;
    }
    /* A few roundings of the need. */
    bool ok = gen_check(g, et_curve_remove(&t, &less, &c, 0.5, 1, need * (1.0 - 0x1p-45)) == ET_OK && (less == 0 || need == 0.0), "removed below %g", need);
    et_curve_free(&t);
    t = (et_curve){0, 0, NULL, NULL, NULL};
    ok = ok && gen_check(g, et_curve_remove(&t, &more, &c, 0.5, 2, need * (1.0 + 0x1p-45)) == ET_OK && more == 1, "not removed above %g", need);
    ok = ok && gen_check(g, t.n == 2 && same_point(t.points[0], c.points[0]) && same_point(t.points[1], c.points[2]), "other ends");
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Spans from 2^-1000 to 2^900: no quotient that counts overflows, and what is constant stays so. */
verdict prop_curve_elevate_scales(gen *g)
{
    size_t p = (size_t)gen_upto(g, 4), inner = (size_t)gen_upto(g, 5), n = p + 1 + inner;
    int e = -1000, rational = (int)gen_upto(g, 1);
    et_curve c, t;
    if (et_curve_new(&c, p, n, rational) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < n; i++) {
        if (i > p) {
            c.u[i] = ldexp(1.0, e);
            e += gen_upto(g, 2) ? (int)gen_upto(g, 300) : 0;
        }
        c.points[i] = (et_vec3){1e300, (double)i * 1e-300, -1.0};
        if (rational) {
            c.weights[i] = i + 1 == n ? 0x1p1000 : 0x1p980;
        }
    }
    for (size_t i = n; i <= n + p; i++) {
        c.u[i] = 0x1p900;
    }
    bool ok = gen_check(g, et_curve_elevate(&t, &c, 1) == ET_OK, "not elevated");
    double off = roundings(2.0 * (7.0 * (double)p + 2.0) + 4.0);
    for (size_t i = 0; ok && i < t.n; i++) {
        et_vec3 P = t.points[i];
        ok = gen_check(g, fabs(P.x - 1e300) <= off * 1e300 && fabs(P.z + 1.0) <= off && P.y >= 0.0 && P.y <= (double)n * 1e-300, "control point %zu: %a", i, P.x);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* More than p + 1 equal knots: control points that do not matter go first, without a move. */
verdict prop_curve_remove_beyond(gen *g)
{
    size_t p = (size_t)gen_upto(g, DEGREE), more = (size_t)gen_upto(g, 3), n = 2 * p + 2 + more, removed = 77;
    int rational = (int)gen_upto(g, 1);
    et_curve c, t;
    if (et_curve_new(&c, p, n, rational) != ET_OK) {
        return FAIL;
    }
    gen_points(g, &c.points[0].x, n);
    for (size_t i = 0; i < n + p + 1; i++) {
        c.u[i] = i <= p ? 0.0 : i < n ? 0.375 : 1.0;
    }
    for (size_t i = 0; rational && i < n; i++) {
        c.weights[i] = gen_real(g, 0.25, 4.0);
    }
    c.points[p] = (et_vec3){1.0, 2.0, 3.0};
    c.points[n - p - 1] = (et_vec3){1.0, 2.0, 5.0};
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, 0.375, SIZE_MAX, 0.0) == ET_OK && removed == more, "%zu of %zu", removed, more);
    for (size_t i = 0; ok && i < t.n; i++) {
        size_t j = i <= p ? i : i + more;
        ok = gen_check(g, same_point(t.points[i], c.points[j]) && (!rational || t.weights[i] == c.weights[j]), "control point %zu", i);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

verdict prop_curve_remove_refused(gen *g)
{
    et_curve c, t = untouched();
    size_t removed = 77;
    if (!draw(g, &c, true)) {
        return SKIP;
    }
    double x = c.n > c.p + 1 ? c.u[c.p + 1] : c.u[c.p], lo = c.u[c.p], hi = c.u[c.n], between = NAN;
    for (size_t i = c.p; i < c.n; i++) {
        double mid = c.u[i] + 0.5 * (c.u[i + 1] - c.u[i]);
        between = mid > c.u[i] && mid < c.u[i + 1] ? mid : between;
    }
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, lo, 1, 1.0) == ET_EINVAL && et_curve_remove(&t, &removed, &c, hi, 1, 1.0) == ET_EINVAL &&
                               et_curve_remove(&t, &removed, &c, NAN, 1, 1.0) == ET_EINVAL, "the domain's ends");
    ok = ok && gen_check(g, et_curve_remove(&t, &removed, &c, between, 1, 1.0) == ET_EINVAL, "%a is no knot", between);
    ok = ok && gen_check(g, et_curve_remove(&t, &removed, &c, x, 1, -1.0) == ET_EINVAL && et_curve_remove(&t, &removed, &c, x, 1, NAN) == ET_EINVAL &&
                                et_curve_remove(&t, &removed, &c, x, 1, HUGE_VAL) == ET_EINVAL, "tolerances");
    c.points[0].z = HUGE_VAL;
    ok = ok && gen_check(g, et_curve_remove(&t, &removed, &c, x, 1, 1.0) == ET_EINVAL, "a coordinate infinite");
    ok = ok && gen_check(g, is_untouched(&t) && removed == 77, "outputs were changed");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* The weights 2 w_1 - w_0 = 2 w_2 - w_3 of the point left would be 0 or less: not removed, whatever the tolerance; else it is. */
verdict prop_curve_remove_weights(gen *g)
{
    static const double u[] = {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0};
    size_t removed = 77;
    double great = (double)gen_between(g, 1, 64) / 16.0;
    et_curve c, t;
    if (et_curve_new(&c, 2, 4, 1) != ET_OK) {
        return FAIL;
    }
    memcpy(c.u, u, sizeof u);
    for (size_t i = 0; i < 4; i++) {
        c.points[i] = (et_vec3){1.0, 2.0, -1.0};
        c.weights[i] = i == 1 || i == 2 ? 1.0 : great;
    }
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, 0.5, 1, 1e18) == ET_OK && removed == (great < 2.0), "%g: %zu removed", great, removed);
    ok = ok && gen_check(g, removed == 0 || (t.weights[1] == 2.0 - great && t.points[1].y == 2.0), "weight %g", t.weights[1]);
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* All control points 0: a polynomial curve is not moved, by nothing at all, though shares of weights are rounded. */
verdict prop_curve_remove_zeros(gen *g)
{
    size_t p = 1 + (size_t)gen_upto(g, 3), removed = 77;
    et_curve c, t;
    if (et_curve_new(&c, p, p + 4, 0) != ET_OK) {
        return FAIL;
    }
    double x = 0.0;
    for (size_t i = 0; i < 2 * p + 5; i++) {
        x += i > p && i <= p + 4 ? gen_real(g, 0.1, 1.0) : 0.0;
        c.u[i] = x;
    }
    x = c.u[p + 1 + (size_t)gen_upto(g, 2)];
    bool ok = gen_check(g, et_curve_remove(&t, &removed, &c, x, 1, 0.0) == ET_OK && removed == 1, "%zu removed", removed);
    for (size_t i = 0; ok && i < t.n; i++) {
        ok = gen_check(g, t.points[i].x == 0.0 && t.points[i].y == 0.0 && t.points[i].z == 0.0, "control point %zu", i);
    }
    et_curve_free(&c);
    et_curve_free(&t);
    return ok ? PASS : FAIL;
}

/* Both ways to the point left agree, its weight 2 w_1 - w_0 is positive, and the point is infinite: nothing is returned. */
verdict prop_curve_remove_overflow(gen *g)
{
    static const double u[] = {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0};
    size_t removed = 77;
    double weight = ldexp(1.0, -(int)gen_between(g, 40, 52)), far = gen_upto(g, 1) ? 0x1p1000 : -0x1p1000;
    bool infinite = gen_upto(g, 1) == 1;
    et_curve c, t = untouched();
    if (et_curve_new(&c, 2, 4, 1) != ET_OK) {
        return FAIL;
    }
    memcpy(c.u, u, sizeof u);
    for (size_t i = 0; i < 4; i++) {
        bool end = i == 0 || i == 3;
        c.points[i] = (et_vec3){1.0, (end ? -1.0 : 1.0) * (infinite ? far : 1.0), 0.0};
        c.weights[i] = end ? 2.0 - weight : 1.0;
    }
    et_status status = et_curve_remove(&t, &removed, &c, 0.5, 1, 0x1p900);
    bool ok = infinite ? gen_check(g, status == ET_EINVAL && removed == 77 && is_untouched(&t), "status %d, %zu removed", (int)status, removed)
                       : gen_check(g, status == ET_OK && removed == 1 && t.weights[1] == weight && t.points[1].y == (4.0 - weight) / weight, "%a", t.points[1].y);
    et_curve_free(&c);
    if (status == ET_OK) {
        et_curve_free(&t);
    }
    return ok ? PASS : FAIL;
}

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
