/* exact/exact_edit: knots of curves inserted (against Boehm's algorithm in rationals) and removed, degrees elevated (against the dual functionals of
 * de Boor and Fix). */
#include "exact/edited.h"

/* ---- the functions, memory counted: ET_EINTERNAL if any is kept ---- */

/* Whether the curve's n control points (and weights) are the homogeneous ones of h, rounded. */
static bool is_rounded(gen *g, const et_curve *c, const fmpq *h)
{
    bool ok = true;
    fmpq_t q;
    fmpq_init(q);
    for (size_t i = 0; ok && i < c->n; i++) {
        for (int a = 0; ok && a < 3; a++) {
            fmpq_div(q, h + 4 * i + (size_t)a, h + 4 * i + 3);
            ok = gen_check(g, ref_same(coordinate(c->points[i], a), exact_round(q)), "coordinate %d of control point %zu is %a, not %a", a, i,
                           coordinate(c->points[i], a), exact_round(q));
        }
        ok = ok && (c->weights == NULL || gen_check(g, ref_same(c->weights[i], exact_round(h + 4 * i + 3)), "weight %zu is %a, not %a", i,
                                                    c->weights[i], exact_round(h + 4 * i + 3)));
    }
    fmpq_clear(q);
    return ok;
}

/* Boehm's algorithm: the knot x once more; n + 1 points of 4 numbers in place of n, and the knots u. */
static fmpq *boehm(fmpq *h, double *u, size_t n, size_t p, double x)
{
    size_t nu = n + p + 1, upto = 0, times = multiplicity(u, nu, x);
    fmpq *q = _fmpq_vec_init((slong)(4 * (n + 1)));
    fmpq_t at;
    fmpq_init(at);
    exact_set(at, x);
    while (upto < nu && u[upto] <= x) {
        upto++;
    }
    for (size_t i = 0; i <= n; i++) {
        for (size_t a = 0; a < 4; a++) {
            if (i + p < upto) {
                fmpq_set(q + 4 * i + a, h + 4 * i + a);
            } else if (i >= upto - times) {
                fmpq_set(q + 4 * i + a, h + 4 * (i - 1) + a);
            } else {
                between(q + 4 * i + a, h + 4 * (i - 1) + a, h + 4 * i + a, at, u[i], u[i + p]);
            }
        }
    }
    memmove(u + upto + 1, u + upto, (nu - upto) * sizeof *u);
    u[upto] = x;
    fmpq_clear(at);
    _fmpq_vec_clear(h, (slong)(4 * n));
    return q;
}

/* ---- insertion ---- */

verdict prop_exact_curve_insert(gen *g)
{
    et_curve c, r = {0, 0, NULL, NULL, NULL};
    if (!draw_curve(g, &c, DEGREE)) {
        return SKIP;
    }
    double x = draw_place(g, c.u, knots_of(&c), c.p), u[REF_KNOTS];
    size_t times = (size_t)gen_upto(g, c.p + 2), m = multiplicity(c.u, knots_of(&c), x);
    bool can = times == 0 || m + times <= c.p + 1;
    et_status status = curve_insert(&r, &c, x, times);
    bool ok = gen_check(g, can || (status == ET_EINVAL && r.u == NULL), "%zu times more a knot of multiplicity %zu", times, m);
    memcpy(u, c.u, knots_of(&c) * sizeof *u);
    if (ok && can) {
        fmpq *h = lifted(c.points, c.weights, c.n);
        for (size_t k = 0; k < times; k++) {
            h = boehm(h, u, c.n + k, c.p, x);
        }
        bool valid = et_knots_valid(u, knots_of(&c) + times, c.p);
        gen_label(g, !valid ? "too close" : times + m == c.p + 1 ? "to p + 1" : times == 0 ? "copy" : "insert");
        ok = gen_check(g, status == (valid ? ET_OK : ET_EINVAL), "status %d", (int)status);
        if (ok && valid) {
            ok = gen_check(g, r.p == c.p && r.n == c.n + times && (r.weights == NULL) == (c.weights == NULL) && same_reals(r.u, u, knots_of(&r)),
                           "knots") &&
                 is_rounded(g, &r, h) && gen_check(g, et_curve_valid(&r), "not valid");
        }
        _fmpq_vec_clear(h, (slong)(4 * (c.n + times)));
    }
    et_curve_free(&r);
    ok = ok && gen_check(g, curve_insert(&r, &c, nextafter(c.u[c.p], -HUGE_VAL), 1) == ET_EINVAL &&
                                curve_insert(&r, &c, nextafter(c.u[c.n], HUGE_VAL), 1) == ET_EINVAL && r.u == NULL, "outside the domain");
    ok = ok &&
         gen_check(g, curve_insert(&r, &c, NAN, 0) == ET_EINVAL && curve_insert(&r, &c, x, SIZE_MAX) == ET_EINVAL && r.u == NULL,
                   "no number, or too often");
    for (size_t i = c.n; ok && i < knots_of(&c); i++) {    /* clamped at the right end, where p + 1 are enough */
        c.u[i] = c.u[c.n];
    }
    m = multiplicity(c.u, knots_of(&c), c.u[c.n]);
    ok = ok && gen_check(g, curve_insert(&r, &c, c.u[c.n], 1) == ET_EINVAL && r.u == NULL, "a knot of multiplicity %zu at the end", m);
    c.points[0].x = HUGE_VAL;
    ok = ok && gen_check(g, curve_insert(&r, &c, x, 0) == ET_EINVAL && r.u == NULL, "a curve that is not valid");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* ---- elevation ---- */

/* The value of the dual functional of the j-th function of degree p on the knots t at the polynomial whose derivatives from 0 to d at y are D[stride
 * k]: sum over r of (-1)^(p-r) psi^(p-r)(y) D_r / p!, psi(x) = (t_{j+1} - x) .. (t_{j+p} - x). */
static void dual(fmpq_t L, const double *t, size_t p, size_t j, double y, const fmpq *D, size_t stride, size_t d)
{
    fmpq *c = _fmpq_vec_init((slong)(p + 2)), *f = c + p + 1;
    fmpz_t factor;
    fmpz_init(factor);
    fmpq_one(c);
    for (size_t i = 1; i <= p; i++) {                       /* c: coefficients of psi(y + s); times (t - y - s) */
        fmpq_t k;
        fmpq_init(k);
        exact_set(f, t[j + i]);
        exact_set(k, y);
        fmpq_sub(f, f, k);
        for (size_t e = i + 1; e-- > 0;) {
            fmpq_mul(c + e, c + e, f);
            if (e > 0) {
                fmpq_sub(c + e, c + e, c + e - 1);
            }
        }
        fmpq_clear(k);
    }
    fmpq_zero(L);
    for (size_t r = 0; r <= p && r <= d; r++) {
        fmpz_fac_ui(factor, (ulong)(p - r));
        fmpq_mul_fmpz(f, c + p - r, factor);
        fmpq_mul(f, f, D + r * stride);
        if ((p - r) % 2 == 1) {
            fmpq_neg(f, f);
        }
        fmpq_add(L, L, f);
    }
    fmpz_fac_ui(factor, (ulong)p);
    fmpq_div_fmpz(L, L, factor);
    fmpz_clear(factor);
    _fmpq_vec_clear(c, (slong)(p + 2));
}

/* Whether span i is a part of the domain. */
static bool lives(const double *t, size_t i, const et_curve *c)
{
    return t[i] < t[i + 1] && c->u[c->p] <= t[i] && t[i + 1] <= c->u[c->n];
}

/* The homogeneous control point j of the same curve on the knots t of degree p; 0 if the function lives nowhere.  Of the spans where it lives the
 * `which`-th: all give the same. */
static bool dual_point(fmpq *h, const double *t, size_t p, size_t j, const et_curve *c, size_t which)
{
    fmpq *all = lifted(c->points, c->weights, c->n), *D = _fmpq_vec_init((slong)(4 * (c->p + 1)));
    size_t spans = 0, at = 0;
    for (size_t i = j; i <= j + p; i++) {
        spans += lives(t, i, c);
    }
    for (size_t i = j, k = 0; spans > 0 && i <= j + p; i++) {
        if (lives(t, i, c) && k++ == which % spans) {
            at = i;
        }
    }
    for (size_t k = 0; k <= c->p && spans > 0; k++) {
        for (size_t a = 0; a < 4; a++) {
            deboor(D + 4 * k + a, all + a, 4, c->u, knots_of(c), c->p, t[at], k);
        }
    }
    for (size_t a = 0; a < 4 && spans > 0; a++) {
        dual(h + a, t, p, j, t[at], D + a, 4, c->p);
    }
    _fmpq_vec_clear(all, (slong)(4 * c->n));
    _fmpq_vec_clear(D, (slong)(4 * (c->p + 1)));
    return spans > 0;
}

/* Clamped knots of any scale, knots inside repeated up to p + 2 times now and then. */
static bool draw_clamped(gen *g, et_curve *c)
{
    if (!draw_curve(g, c, DEGREE)) {
        return false;
    }
    for (size_t i = 0; i < c->p; i++) {
        c->u[i] = c->u[c->p];
        c->u[c->n + 1 + i] = c->u[c->n];
    }
    if (gen_chance(g, 6) && c->n > c->p + 1) {
        size_t i = c->p + (size_t)gen_upto(g, c->n - c->p - 2);
        c->u[i + 1] = c->u[i];                              /* at the left end: p + 2 times */
        gen_label(g, "repeated");
    }
    if (gen_chance(g, 6) && c->n > c->p + 1 && c->u[c->p] < c->u[c->n - 1]) {
        c->u[c->n - 1] = c->u[c->n];
        gen_label(g, "repeated end");
    }
    if (!et_curve_valid(c)) {
        et_curve_free(c);
        return false;
    }
    return true;
}

/* The new knots, and what old control point keeps its place at j if no other says where it is: the j-th less `times` for every knot left of it. */
static size_t elevated_knots(double *t, const double *u, size_t nu, size_t times)
{
    size_t n = 0;
    for (size_t i = 0; i < nu; i++) {
        t[n++] = u[i];
        for (size_t k = 0; k < times && (i + 1 == nu || u[i] < u[i + 1]); k++) {
            t[n++] = u[i];
        }
    }
    return n;
}

/* One case in 2. */
verdict prop_exact_curve_elevate(gen *g)
{
    et_curve c, e = {0, 0, NULL, NULL, NULL};
    double t[4 * REF_KNOTS];
    fmpq *h = NULL;
    if (!draw_clamped(g, &c)) {
        return SKIP;
    }
    size_t times = (size_t)gen_upto(g, 3), nt = elevated_knots(t, c.u, knots_of(&c), times), p = c.p + times, n = nt - p - 1,
           which = (size_t)gen_upto(g, 3);
    bool ok = gen_check(g, curve_elevate(&e, &c, times) == ET_OK, "status");
    ok = ok && gen_check(g, e.p == p && e.n == n && (e.weights == NULL) == (c.weights == NULL) && same_reals(e.u, t, nt), "knots");
    h = _fmpq_vec_init((slong)(4 * n));
    for (size_t j = 0; ok && j < n; j++) {
        if (!dual_point(h + 4 * j, t, p, j, &c, which)) {   /* among so many equal knots a place, no point */
            size_t before = 0;
            for (size_t i = 0; i + 1 < nt && t[i] < t[j]; i++) {
                before += t[i] < t[i + 1];
            }
            fmpq *all = lifted(c.points, c.weights, c.n);
            for (size_t a = 0; a < 4; a++) {
                fmpq_set(h + 4 * j + a, all + 4 * (j - before * times) + a);
            }
            _fmpq_vec_clear(all, (slong)(4 * c.n));
            gen_label(g, "lives nowhere");
        }
    }
    ok = ok && is_rounded(g, &e, h) && gen_check(g, et_curve_valid(&e), "not valid");
    _fmpq_vec_clear(h, (slong)(4 * n));
    et_curve_free(&e);
    ok = ok &&
         gen_check(g,
                   curve_elevate(&e, &c, SIZE_MAX) == ET_ENOMEM && curve_elevate(&e, &c, SIZE_MAX / 2) == ET_ENOMEM && e.u == NULL,
                   "sizes beyond all");
    double first = c.u[0], last = c.u[knots_of(&c) - 1];
    if (ok && c.p > 0) {
        c.u[0] = first - fabs(first) - 1.0;
        ok = gen_check(g, curve_elevate(&e, &c, 1) == ET_EINVAL && e.u == NULL, "not clamped at the left");
        c.u[0] = first;
        c.u[knots_of(&c) - 1] = last + fabs(last) + 1.0;
        ok = ok && gen_check(g, curve_elevate(&e, &c, 1) == ET_EINVAL && e.u == NULL, "not clamped at the right");
        c.u[knots_of(&c) - 1] = last;
    }
    c.points[0].x = NAN;
    ok = ok && gen_check(g, curve_elevate(&e, &c, 0) == ET_EINVAL && e.u == NULL, "a curve that is not valid");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* ---- removal ---- */

/* Whether each function lives somewhere: of others the dual functionals do not tell. */
static bool all_live(const et_curve *c)
{
    for (size_t j = 0; j < c->n; j++) {
        size_t spans = 0;
        for (size_t i = j; i <= j + c->p; i++) {
            spans += lives(c->u, i, c);
        }
        if (spans == 0) {
            return false;
        }
    }
    return true;
}

/* Coordinates whole multiples of 6^6, weights of 2^12; knots whole numbers or fourths: inserting up to three knots makes no fraction that is no
 * double. */
static bool draw_whole(gen *g, et_curve *c)
{
    size_t p = (size_t)gen_upto(g, 3), n = p + 2 + (size_t)gen_upto(g, 4);
    if (et_curve_new(c, p, n, 0) != ET_OK) {
        return false;
    }
    double x = 0.0;
    for (size_t i = 0; i < n + p + 1; i++) {
        c->u[i] = x;
        x += gen_upto(g, 3) != 3 ? 1.0 : 0.0;
    }
    for (size_t i = 0; i < n; i++) {
        c->points[i] = (et_vec3){46656.0 * ((double)gen_upto(g, 64) - 32.0), 46656.0 * (double)gen_upto(g, 3), 46656.0 * (double)(i % 3)};
    }
    if (!et_curve_valid(c) || !all_live(c)) {
        et_curve_free(c);
        return false;
    }
    return true;
}

/* Whether the curve without r of its knots x, its control points by dual functionals at the left of each function's support, gives the curve back
 * when they are inserted; h: those control points. */
static bool restores(fmpq **h, const et_curve *c, double x, size_t r)
{
    size_t nu = knots_of(c), upto = 0, n = c->n - r;
    double t[REF_KNOTS];
    while (upto < nu && c->u[upto] <= x) {
        upto++;
    }
    memcpy(t, c->u, upto * sizeof *t);
    memcpy(t + upto - r, c->u + upto, (nu - upto) * sizeof *t);
    *h = _fmpq_vec_init((slong)(4 * n));
    for (size_t j = 0; j < n; j++) {
        if (!dual_point(*h + 4 * j, t, c->p, j, c, 0)) {
            return false;
        }
    }
    fmpq *back = _fmpq_vec_init((slong)(4 * n)), *all = lifted(c->points, c->weights, c->n);
    for (size_t k = 0; k < 4 * n; k++) {
        fmpq_set(back + k, *h + k);
    }
    for (size_t k = 0; k < r; k++) {
        back = boehm(back, t, n + k, c->p, x);
    }
    bool same = true;
    for (size_t k = 0; same && k < 4 * c->n; k++) {
        same = fmpq_equal(back + k, all + k);
    }
    _fmpq_vec_clear(back, (slong)(4 * c->n));
    _fmpq_vec_clear(all, (slong)(4 * c->n));
    return same;
}

static bool all_positive(const fmpq *h, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (fmpq_sgn(h + 4 * i + 3) <= 0) {
            return false;
        }
    }
    return true;
}

/* The greatest number of removals, by trying each. */
static bool remove_as_often(gen *g, const et_curve *c, double x, size_t times)
{
    et_curve r = {0, 0, NULL, NULL, NULL};
    size_t removed = 4711, m = multiplicity(c->u, knots_of(c), x), want = 0;
    fmpq *h = NULL, *try = NULL;
    bool ok = gen_check(g, curve_remove(&r, &removed, c, x, times) == ET_OK, "status");
    for (size_t k = 0; ok && k <= m && k <= times; k++) {
        if (restores(&try, c, x, k) && all_positive(try, c->n - k)) {
            if (h != NULL) {
                _fmpq_vec_clear(h, (slong)(4 * (c->n - want)));
            }
            want = k;
            h = try;
        } else {
            _fmpq_vec_clear(try, (slong)(4 * (c->n - k)));
        }
    }
    gen_label(g, want == 0 ? "kept" : want == m ? "all" : "some");
    ok = ok && gen_check(g, removed == want && r.p == c->p && r.n == c->n - want, "%zu of %zu removed, not %zu", removed, m, want);
    ok = ok && is_rounded(g, &r, h);
    ok = ok && gen_check(g, multiplicity(r.u, knots_of(&r), x) == m - want, "knots x");
    for (size_t i = 0, k = 0; ok && i < knots_of(c); i++) {  /* the others in their order */
        if (c->u[i] != x) {
            while (k < knots_of(&r) && r.u[k] == x) {
                k++;
            }
            ok = gen_check(g, k < knots_of(&r) && ref_same(r.u[k++], c->u[i]), "knot %zu", i);
        }
    }
    if (h != NULL) {
        _fmpq_vec_clear(h, (slong)(4 * (c->n - want)));
    }
    et_curve_free(&r);
    return ok;
}

/* A knot inserted into whole numbers, so that nothing is rounded, goes again, and the rounding of a coordinate keeps it. */
verdict prop_exact_curve_remove(gen *g)
{
    et_curve c, r = {0, 0, NULL, NULL, NULL};
    size_t removed = 4711;
    if (!draw_whole(g, &c)) {
        return SKIP;
    }
    double lo = c.u[c.p], hi = c.u[c.n], x = lo + (double)(1 + gen_upto(g, (uint64_t)(2.0 * (hi - lo)) - 2)) / 2.0;
    size_t m = multiplicity(c.u, knots_of(&c), x), times = 1 + (size_t)gen_upto(g, 2);
    if (m + times > c.p + 1) {
        times = m <= c.p ? c.p + 1 - m : 0;
    }
    bool ok = gen_check(g, curve_insert(&r, &c, x, times) == ET_OK, "not inserted");
    if (ok && gen_chance(g, 3)) {
        size_t i = (size_t)gen_upto(g, r.n - 1);
        r.points[i].y = nextafter(r.points[i].y, HUGE_VAL);
        gen_label(g, "off by an ulp");
    }
    if (ok && multiplicity(r.u, knots_of(&r), x) > 0) {
        ok = remove_as_often(g, &r, x, (size_t)gen_upto(g, 4));
        ok = ok && remove_as_often(g, &r, x, SIZE_MAX);
    }
    et_curve_free(&r);
    ok = ok && gen_check(g,
                         curve_remove(&r, &removed, &c, lo, 1) == ET_EINVAL && curve_remove(&r, &removed, &c, hi, 1) == ET_EINVAL &&
                             curve_remove(&r, &removed, &c, nextafter(x, lo), 1) == ET_EINVAL && r.u == NULL && removed == 4711,
                         "no knots of the open domain");
    c.points[0].x = NAN;
    ok =
        ok && gen_check(g, curve_remove(&r, &removed, &c, x, 0) == ET_EINVAL && r.u == NULL && removed == 4711, "a curve that is not valid");
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* Any curve, rational ones, too, at any of its knots: mostly none can go. */
verdict prop_exact_curve_remove_any(gen *g)
{
    et_curve c, r;
    if (!draw_curve(g, &c, 3)) {
        return SKIP;
    }
    double x = c.u[(size_t)gen_upto(g, knots_of(&c) - 1)];
    bool constant = gen_chance(g, 4), inner = c.u[c.p] < x && x < c.u[c.n];
    for (size_t i = 0; i < c.n && constant; i++) {          /* equal points and weights: all knots can go */
        c.points[i] = c.points[0];
        if (c.weights != NULL) {
            c.weights[i] = c.weights[0];
        }
    }
    size_t removed = 4711, m = multiplicity(c.u, knots_of(&c), x);
    bool ok = true;
    if (!inner) {
        ok = gen_check(g, curve_remove(&r, &removed, &c, x, 1) == ET_EINVAL && removed == 4711, "not inside, but removed");
    } else if (all_live(&c)) {
        ok = remove_as_often(g, &c, x, (size_t)gen_upto(g, m));
    }
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* By hand: control points of no function go first, then those that are twice there; a weight that would become negative stays; what leaves the
 * doubles' range becomes infinite. */
verdict prop_exact_curve_remove_byhand(gen *g)
{
    et_curve c, r;
    size_t removed = 0, more = (size_t)gen_upto(g, 2), p = (size_t)gen_upto(g, 3), n = 2 * p + 2 + more;
    bool meets = gen_upto(g, 1) == 1;
    if (et_curve_new(&c, p, n, 0) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < n + p + 1; i++) {
        c.u[i] = i <= p ? 0.0 : i < n ? 1.0 : 2.0;
    }
    for (size_t i = 0; i < n; i++) {                       /* two pieces, between them `more` points that count for nothing */
        c.points[i] = (et_vec3){(double)(i * i), 1.0, 0.0};
    }
    c.points[n - 1 - p] = c.points[p];
    c.points[n - 1 - p].z = meets ? 0.0 : 1.0;
    bool ok =
        gen_check(g, curve_remove(&r, &removed, &c, 1.0, more) == ET_OK && removed == more && r.n == n - more, "%zu of %zu", removed, more);
    for (size_t i = 0; ok && i < r.n; i++) {
        ok = gen_check(g, same_point(r.points[i], c.points[i <= p ? i : i + more]), "control point %zu of two pieces", i);
    }
    et_curve_free(&r);
    ok = ok && gen_check(g, curve_remove(&r, &removed, &c, 1.0, more + 1) == ET_OK && removed == more + meets, "%zu of %zu, meets: %d",
                         removed, more, (int)meets);
    for (size_t i = 0; ok && meets && i < r.n; i++) {
        ok = gen_check(g, same_point(r.points[i], c.points[i <= p ? i : i + more + 1]), "control point %zu of a corner", i);
    }
    et_curve_free(&r);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}

/* The knot 1/2, twice there, goes once of five points with these weights, and the other points stay. */
static bool kept_positive(gen *g, const double *w, const double *x)
{
    static const double knots[] = {0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0}, fewer[] = {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0};
    et_curve c, r = {0, 0, NULL, NULL, NULL};
    size_t removed = 0;
    if (et_curve_new(&c, 2, 5, 1) != ET_OK) {
        return false;
    }
    memcpy(c.u, knots, sizeof knots);
    memcpy(c.weights, w, 5 * sizeof *w);
    for (size_t i = 0; i < 5; i++) {
        c.points[i].x = x[i];
    }
    bool ok = gen_check(g, curve_remove(&r, &removed, &c, 0.5, 2) == ET_OK && removed == 1 && r.n == 4, "a weight not positive: %zu removed", removed);
    ok = ok && gen_check(g, same_reals(r.u, fewer, 7), "knots");
    for (size_t i = 0; ok && i < 4; i++) {
        size_t k = i < 2 ? i : i + 1;
        ok = gen_check(g, r.weights[i] == w[k] && r.points[i].x == x[k], "point %zu: %g, weight %g", i, r.points[i].x, r.weights[i]);
    }
    et_curve_free(&c);
    et_curve_free(&r);
    return ok;
}

verdict prop_exact_curve_remove_limits(gen *g)
{
    static const double weights[] = {1.0, 0.375, 0.375, 0.375, 1.0}, x[] = {0.0, 1.0, 5.0, 9.0, 6.0};  /* of 1, -1/4, 1, with 1/2 twice more */
    static const double even[] = {1.0, 0.5, 0.5, 0.5, 1.0}, y[] = {0.0, 0.75, 3.75, 6.75, 6.0};          /* of 1, 0, 1 */
    et_curve c, r;
    size_t removed = 0, sign = (size_t)gen_upto(g, 1);
    double least = ldexp(1.0, -(int)gen_upto(g, 1070)), s = sign ? -1.0 : 1.0;
    for (size_t k = 0; k < 2; k++) {
        if (!gen_check(g, kept_positive(g, k == 0 ? weights : even, k == 0 ? x : y), "weights %zu", k)) {
            return FAIL;
        }
    }
    if (et_curve_new(&c, 2, 4, 0) != ET_OK) {
        return FAIL;
    }
    c.u[3] = 0.5;
    c.u[4] = c.u[5] = c.u[6] = 1.0;
    c.points[1].x = c.points[2].x = s * 0x1p1023;          /* of 0, 2^1024, 0 */
    c.points[1].y = c.points[2].y = s * least;
    bool ok = gen_check(g, curve_remove(&r, &removed, &c, 0.5, 7) == ET_OK && removed == 1 && r.n == 3, "not removed");
    ok = ok && gen_check(g, r.points[1].x == s * HUGE_VAL && r.points[1].y == s * 2.0 * least && ref_same(r.points[1].z, 0.0), "to infinity: %g",
                         r.points[1].x);
    et_curve_free(&r);
    et_curve_free(&c);
    return ok ? PASS : FAIL;
}
