/* spline/surface: derivatives of any order from either side, against Leibniz' rule with the basis by its definition; unit normals in double-double. */
#include "etalon/spline/basis.h"
#include "surfaces.h"
#include <stdint.h>

enum { TOP = 5, ALL = (TOP + 1) * (TOP + 2) / 2 };

static size_t place(size_t a, size_t b)
{
    return (a + b) * (a + b + 1) / 2 + b;
}

/* The surface run backwards along u, v or both: its right is the other's left. */
static et_surface backwards(const et_surface *s, bool along_u, bool along_v)
{
    et_surface t;
    if (et_surface_copy(&t, s) != ET_OK) {
        abort();
    }
    for (size_t i = 0; along_u && i <= s->nu + s->p; i++) {
        t.u[i] = -s->u[s->nu + s->p - i];
    }
    for (size_t j = 0; along_v && j <= s->nv + s->q; j++) {
        t.v[j] = -s->v[s->nv + s->q - j];
    }
    for (size_t k = 0; k < s->nu * s->nv; k++) {
        size_t i = k / s->nv, j = k % s->nv, from = (along_u ? s->nu - 1 - i : i) * s->nv + (along_v ? s->nv - 1 - j : j);
        t.points[k] = s->points[from];
        if (s->weights) {
            t.weights[k] = s->weights[from];
        }
    }
    return t;
}

static double clamped(double x, double lo, double hi)
{
    return fmin(fmax(x, lo), hi);
}

/* Exact derivatives as near as sums come: of w and w S, with the signs of a run backwards. */
static void derivatives(sums A[ALL], const et_surface *s, double u, double v, bool left_u, bool left_v, size_t d)
{
    et_surface t = backwards(s, left_u, left_v);
    u = clamped(u, s->u[s->p], s->u[s->nu]);
    v = clamped(v, s->v[s->q], s->v[s->nv]);
    for (size_t a = 0; a <= d; a++) {
        for (size_t b = 0; a + b <= d; b++) {
            sums *at = &A[place(a, b)];
            *at = surface_brute(&t, left_u ? -u : u, left_v ? -v : v, a, b);
            for (int c = 0; c < 4 && ((left_u && a % 2) != (left_v && b % 2)); c++) {
                at->value[c] = -at->value[c];
            }
            if (!s->weights) {
                at->value[0] = at->size[0] = a + b == 0 ? 1.0 : 0.0;
            }
        }
    }
    et_surface_free(&t);
}

static double binomial(size_t n, size_t k)
{
    double c = 1.0;
    for (size_t i = 0; i < k; i++) {
        c = c * (double)(n - i) / (double)(i + 1);
    }
    return c;
}

/* w S = A, derived a times and b times. */
static bool leibniz(gen *g, const sums A[ALL], const et_vec3 *D, size_t a, size_t b, double slack)
{
    bool ok = true;
    for (int c = 0; ok && c < 3; c++) {
        const sums *want = &A[place(a, b)];
        double sum = 0.0, size = want->size[c + 1];
        for (size_t i = 0; i <= a; i++) {
            for (size_t j = 0; j <= b; j++) {
                double f = binomial(a, i) * binomial(b, j), x = coordinate(&D[place(a - i, b - j)], c);
                sum += f * A[place(i, j)].value[0] * x;
                size += f * A[place(i, j)].size[0] * fabs(x);
            }
        }
        ok = !(size < 0x1p900) || gen_check(g, fabs(sum - want->value[c + 1]) <= slack * size + 0x1p-300, "derivative (%zu, %zu), coordinate %d: %a for %a", a, b,
                                            c, sum, want->value[c + 1]);
    }
    return ok;
}

/* One case in 2. */
verdict prop_surface_partials(gen *g)
{
    et_surface s;
    et_vec3 D[ALL + 1];
    sums A[ALL];
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    size_t d = (size_t)gen_upto(g, TOP), n = et_surface_partials_work(&s, d), all = (d + 1) * (d + 2) / 2;
    bool left_u = gen_upto(g, 1) == 1, left_v = gen_upto(g, 1) == 1, ok = true;
    double u = draw_u(g, &s), v = draw_v(g, &s), *work = et_size_array(n + 1, sizeof(double));
    if (gen_chance(g, 8)) {
        u = gen_upto(g, 1) ? 1e300 : -1e300;
        gen_label(g, "outside");
    }
    memset(work, 0xff, n * sizeof *work);
    work[n] = D[all].x = 4711.0;
    et_surface_partials(D, d, &s, u, v, left_u ? ET_SIDE_LEFT : ET_SIDE_RIGHT, left_v ? ET_SIDE_LEFT : ET_SIDE_RIGHT, work, n);
    ok = gen_check(g, work[n] == 4711.0 && D[all].x == 4711.0, "wrote beyond");
    derivatives(A, &s, u, v, left_u, left_v, d);
    /* Ours and the brute way's roundings, those of the sums here. */
    double slack = surface_slack(&s) + roundings((double)((s.p + 1) * (s.q + 1)) + 2.0 * TOP * TOP);
    for (size_t a = 0; ok && a <= d; a++) {
        for (size_t b = 0; ok && a + b <= d; b++) {
            et_vec3 *at = &D[place(a, b)];
            ok = leibniz(g, A, D, a, b, slack);
            ok = ok && gen_check(g, s.weights || (a <= s.p && b <= s.q) || same_point(*at, (et_vec3){0.0, 0.0, 0.0}), "(%zu, %zu) beyond the degrees", a, b);
        }
    }
    gen_label(g, left_u || left_v ? "from the left" : "from the right");
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* From the right what the other functions give, every bit; and more derivatives do not change the first ones. */
verdict prop_surface_partials_bits(gen *g)
{
    et_surface s;
    et_vec3 D[ALL], E[ALL], six[6];
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    size_t d = (size_t)gen_upto(g, TOP), n = et_surface_partials_work(&s, TOP);
    double u = draw_u(g, &s), v = draw_v(g, &s), *work = et_size_array(n, sizeof(double)), *room = surface_room(&s);
    et_side left_u = gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT, left_v = gen_upto(g, 1) ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
    et_surface_partials(D, TOP, &s, u, v, ET_SIDE_RIGHT, ET_SIDE_RIGHT, work, n);
    et_surface_ders(six, &s, u, v, room, et_surface_work(&s));
    bool ok = gen_check(g, same_point(D[0], surface_at(&s, u, v)), "another point");
    for (size_t k = 0; ok && k < 6; k++) {
        bool same = D[k].x == six[k].x && D[k].y == six[k].y && D[k].z == six[k].z;
        ok = gen_check(g, same || isnan(six[k].x + six[k].y + six[k].z), "derivative %zu is another one: %a for %a", k, D[k].x, six[k].x);
    }
    et_surface_partials(D, TOP, &s, u, v, left_u, left_v, work, n);
    et_surface_partials(E, d, &s, u, v, left_u, left_v, work, et_surface_partials_work(&s, d));
    for (size_t k = 0; ok && k < (d + 1) * (d + 2) / 2; k++) {
        ok = gen_check(g, same_point(D[k], E[k]) || isnan(D[k].x + D[k].y + D[k].z), "derivative %zu depends on the order", k);
    }
    free(work);
    free(room);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

verdict prop_surface_partials_work(gen *g)
{
    size_t p = (size_t)gen_upto(g, 9), q = (size_t)gen_upto(g, 9), d = (size_t)gen_upto(g, 12), a = (d < p ? d : p) + 1, b = (d < q ? d : q) + 1;
    et_surface s = {p, q, 0, 0, NULL, NULL, NULL, NULL}, wide = s;
    size_t basis = p > q ? (p + 1) * (p + 5) : (q + 1) * (q + 5), want = a * (p + 1) + b * (q + 1) + 4 * a * (q + 1) + basis + (d + 1) * (d + 2);
    bool ok = gen_check(g, et_surface_partials_work(&s, d) == want, "%zu doubles for %zu", et_surface_partials_work(&s, d), want);
    ok = ok && gen_check(g, et_surface_partials_work(&s, SIZE_MAX) == SIZE_MAX && et_surface_partials_work(&s, SIZE_MAX - 1) == SIZE_MAX &&
                                et_surface_partials_work(&s, SIZE_MAX / 2) == SIZE_MAX && et_surface_partials_work(&s, (size_t)1 << 32) == SIZE_MAX,
                         "an order beyond all sizes");
    wide.p = SIZE_MAX - d;
    ok = ok && gen_check(g, et_surface_partials_work(&wide, 1) == SIZE_MAX && et_surface_partials_work(&wide, 0) == SIZE_MAX, "a degree beyond all sizes");
    wide = s;
    wide.q = SIZE_MAX - d;
    ok = ok && gen_check(g, et_surface_partials_work(&wide, 1) == SIZE_MAX && et_surface_partials_work(&wide, 0) == SIZE_MAX, "a degree beyond all sizes");
    size_t root = (size_t)1 << (4 * sizeof(size_t));
    wide = (et_surface){root / 16 * 11, root / 16 * 11, 0, 0, NULL, NULL, NULL, NULL};      /* each product fits, their sum does not */
    ok = ok && gen_check(g, et_surface_partials_work(&wide, wide.p) == SIZE_MAX, "a sum beyond all sizes");
    return ok ? PASS : FAIL;
}

/* ---- normals ---- */

/* A control point moved to the origin o, in double-double. */
static fine moved(const et_surface *s, size_t at, et_vec3 o)
{
    fine h;
    double w = s->weights ? s->weights[at] : 1.0;
    for (int a = 0; a < 4; a++) {
        h.value[a] = a == 3 ? dd_of(w) : et_dd_mul(dd_of(w), et_dd_two_sum(coordinate(&s->points[at], a), -coordinate(&o, a)));
        h.size[a] = fabs(h.value[a].hi);
    }
    return h;
}

/* De Boor's algorithm, or with slope that of the derivative times the span's width, in which the first step takes differences. */
static fine deboor(fine *h, const double *u, size_t p, size_t span, double x, bool slope)
{
    const et_dd zero = {0.0, 0.0};
    et_dd span_width = et_dd_two_sum(u[span + 1], -u[span]);
    for (size_t j = 1; j <= p; j++) {
        for (size_t r = p; r >= j; r--) {
            double lo = u[span - p + r], hi = u[span + 1 + r - j];
            et_dd width = et_dd_two_sum(hi, -lo), a = et_dd_div(et_dd_two_sum(hi, -x), width), b = et_dd_div(et_dd_two_sum(x, -lo), width);
            if (slope && j == 1) {
                b = et_dd_mul(et_dd_div(span_width, width), dd_of((double)p));
                fine f = combine(h[r - 1], et_dd_sub(zero, b), h[r], b);
                for (int k = 0; k < 4; k++) {
                    f.size[k] = b.hi * (h[r - 1].size[k] + h[r].size[k]);
                }
                h[r] = f;
            } else {
                h[r] = combine(h[r - 1], a, h[r], b);
            }
        }
    }
    if (slope && p == 0) {
        h[0] = combine(h[0], zero, h[0], zero);
    }
    return h[p];
}

static fine tensor(const et_surface *s, double u, double v, et_vec3 o, bool slope_u, bool slope_v)
{
    fine h[16], T[16];
    size_t i = et_knots_span(s->u, s->nu + s->p + 1, s->p, u), j = et_knots_span(s->v, s->nv + s->q + 1, s->q, v);
    for (size_t l = 0; l <= s->q; l++) {
        for (size_t k = 0; k <= s->p; k++) {
            h[k] = moved(s, (i - s->p + k) * s->nv + j - s->q + l, o);
        }
        T[l] = deboor(h, s->u, s->p, i, u, slope_u);
    }
    return deboor(T, s->v, s->q, j, v, slope_v);
}

/* w A' - w' A, over its greatest coordinate. */
static fine direction(fine A, fine D, bool rational)
{
    double most = 0.0;
    for (int c = 0; c < 3; c++) {
        if (rational) {
            D.value[c] = et_dd_sub(et_dd_mul(A.value[3], D.value[c]), et_dd_mul(D.value[3], A.value[c]));
            D.size[c] = A.size[3] * D.size[c] + D.size[3] * A.size[c];
        }
        most = fmax(most, fabs(D.value[c].hi));
    }
    for (int c = 0; c < 3 && most > 0.0; c++) {
        D.value[c] = et_dd_div(D.value[c], dd_of(most));
        D.size[c] /= most;
    }
    return D;
}

static fine cross(fine a, fine b)
{
    fine c = a;
    for (int k = 0; k < 3; k++) {
        int x = (k + 1) % 3, y = (k + 2) % 3;
        c.value[k] = et_dd_sub(et_dd_mul(a.value[x], b.value[y]), et_dd_mul(a.value[y], b.value[x]));
        c.size[k] = a.size[x] * b.size[y] + a.size[y] * b.size[x];
    }
    return c;
}

static et_dd norm(fine c)
{
    et_dd sum = et_dd_add(et_dd_add(et_dd_mul(c.value[0], c.value[0]), et_dd_mul(c.value[1], c.value[1])), et_dd_mul(c.value[2], c.value[2]));
    return et_dd_sqrt(sum);
}

/* The control point of the greatest product of functions: the first of equal ones. */
static et_vec3 origin(const et_surface *s, double u, double v)
{
    double N[SURFACE_DEGREE + 1], M[SURFACE_DEGREE + 1], work[2 * (SURFACE_DEGREE + 1)];
    size_t i = et_knots_span(s->u, s->nu + s->p + 1, s->p, u), j = et_knots_span(s->v, s->nv + s->q + 1, s->q, v), a = 0, b = 0;
    et_basis_eval(N, s->u, s->nu + s->p + 1, s->p, i, u, work, 2 * (s->p + 1));
    et_basis_eval(M, s->v, s->nv + s->q + 1, s->q, j, v, work, 2 * (s->q + 1));
    for (size_t k = 1; k <= s->p; k++) {
        a = N[k] > N[a] ? k : a;
    }
    for (size_t k = 1; k <= s->q; k++) {
        b = M[k] > M[b] ? k : b;
    }
    return s->points[(i - s->p + a) * s->nv + j - s->q + b];
}

/* Few digits' coordinates, so that cross products vanish exactly and nearly. */
static void simplify(gen *g, et_surface *s)
{
    uint64_t kind = gen_upto(g, 3);
    for (size_t k = 0; kind > 0 && k < s->nu * s->nv; k++) {
        double i = (double)(k / s->nv), j = (double)(k % s->nv), z = (double)gen_upto(g, 4);
        s->points[k] = kind == 1 ? (et_vec3){i, j, z} : kind == 2 ? (et_vec3){i + z, 2.0 * (i + z), 0.5 * (i + z)} : (et_vec3){i * j, i * z, i};
    }
    if (kind > 0) {
        gen_label(g, kind == 1 ? "graph" : kind == 2 ? "on a line" : "pole");
    }
}

verdict prop_surface_normal(gen *g)
{
    et_surface s;
    et_vec3 n = {7.0, 8.0, 9.0};
    if (!draw_surface(g, &s, true)) {
        return SKIP;
    }
    simplify(g, &s);
    double u = draw_u(g, &s), v = draw_v(g, &s), *work = surface_room(&s);
    size_t nwork = et_surface_work(&s);
    work[nwork] = 4711.0;
    bool outside = gen_chance(g, 8), low = gen_upto(g, 1) == 1;
    et_status status = et_surface_normal(&n, &s, outside ? (low ? -1e300 : 1e300) : u, outside ? (low ? 1e300 : -1e300) : v, work, nwork);
    u = outside ? (low ? s.u[s.p] : s.u[s.nu]) : u;
    v = outside ? (low ? s.v[s.nv] : s.v[s.q]) : v;
    et_vec3 o = origin(&s, u, v);
    fine A = tensor(&s, u, v, o, false, false), Du = tensor(&s, u, v, o, true, false), Dv = tensor(&s, u, v, o, false, true);
    fine c = cross(direction(A, Du, s.weights != NULL), direction(A, Dv, s.weights != NULL));
    double m = sqrt(c.size[0] * c.size[0] + c.size[1] * c.size[1] + c.size[2] * c.size[2]), bound = roundings(28.0 * (double)(s.p + s.q) + 16.0) * m;
    et_dd length = norm(c);
    double least = fmax(fabs(Du.value[0].hi), fmax(fabs(Du.value[1].hi), fabs(Du.value[2].hi)));
    least = fmin(least, fmax(fabs(Dv.value[0].hi), fmax(fabs(Dv.value[1].hi), fabs(Dv.value[2].hi))));
    least = least > 0.0 ? least : HUGE_VAL;
    for (size_t k = 0; k < 3 * s.nu * s.nv; k++) {
        double x = fabs(coordinate(&s.points[k / 3], (int)(k % 3)));
        least = x > 0.0 ? fmin(least, x) : least;
    }
    bool ok = gen_check(g, work[nwork] == 4711.0, "wrote beyond the workspace");
    gen_label(g, status == ET_OK ? "normal" : "none");
    if (least < 0x1p-400) {
        gen_label(g, "underflow");
    } else if (status == ET_ERANK) {
        ok = ok && gen_check(g, n.x == 7.0 && n.y == 8.0 && n.z == 9.0, "the output was changed");
        ok = ok && gen_check(g, !(length.hi > 2.001 * bound + 0x1p-400), "refused, though the cross product is %g, the bound %g", length.hi, bound);
    } else {
        ok = ok && gen_check(g, status == ET_OK && length.hi > 0.0, "status %d of a cross product %g", (int)status, length.hi);
        double reach = 2.0 * bound / (length.hi - bound) + roundings(5.0);
        for (int k = 0; ok && k < 3; k++) {
            et_dd want = et_dd_div(c.value[k], length);
            ok = gen_check(g, !(reach < 1.0) || fabs(coordinate(&n, k) - want.hi) <= reach, "coordinate %d: %a for %a, within %g", k, coordinate(&n, k), want.hi, reach);
        }
        ok = ok && gen_check(g, fabs(n.x * n.x + n.y * n.y + n.z * n.z - 1.0) <= roundings(14.0), "length %a", n.x * n.x + n.y * n.y + n.z * n.z);
    }
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Control points near a line, so that the cross product is about the bound of its error.  Few roundings are made of what the bound counts: of 7(p+q) + 2 at
 * most p + q + 2, so that c and bound are known to a quarter of the bound. */
verdict prop_surface_normal_threshold(gen *g)
{
    size_t p = 1 + (size_t)gen_upto(g, 1), q = 1 + (size_t)gen_upto(g, 1), n = (p + 1) * (q + 1);
    int rational = (int)gen_upto(g, 1);
    double u = (double)gen_upto(g, 4) / 4.0, v = (double)gen_upto(g, 4) / 4.0, factor = (double)gen_between(g, 1, 80) / 8.0;
    et_surface s;
    if (et_surface_new(&s, p, q, p + 1, q + 1, rational) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i <= p; i++) {
        s.u[p + 1 + i] = 1.0;
    }
    for (size_t j = 0; j <= q; j++) {
        s.v[q + 1 + j] = 1.0;
    }
    int x = (int)gen_upto(g, 2), y = (x + 1) % 3;
    for (size_t k = 0; k < n; k++) {
        double t = (double)gen_upto(g, 4) - 2.0;
        (&s.points[k].x)[x] = t;
        (&s.points[k].x)[y] = t;
        if (rational) {
            s.weights[k] = ldexp(1.0, (int)gen_upto(g, 2));
        }
    }
    /* One of them beside the line, by a part of what its neighbours are apart. */
    size_t at = (size_t)gen_upto(g, n - 1);
    (&s.points[at].x)[y] += factor * 28.0 * (double)(p + q) * ET_UNIT * (1.0 + (double)gen_upto(g, 3));
    et_vec3 normal = {7.0, 8.0, 9.0}, o = origin(&s, u, v);
    double *work = surface_room(&s);
    et_status status = et_surface_normal(&normal, &s, u, v, work, et_surface_work(&s));
    fine A = tensor(&s, u, v, o, false, false), Du = tensor(&s, u, v, o, true, false), Dv = tensor(&s, u, v, o, false, true);
    fine c = cross(direction(A, Du, rational), direction(A, Dv, rational));
    double m = sqrt(c.size[0] * c.size[0] + c.size[1] * c.size[1] + c.size[2] * c.size[2]), bound = (28.0 * (double)(p + q) + 16.0) * ET_UNIT * m;
    double length = norm(c).hi;
    gen_label(g, length < 0.75 * bound ? "below" : length > 1.25 * bound ? "above" : "about");
    bool ok = gen_check(g, !(length < 0.75 * bound) || status == ET_ERANK, "a normal, though %g is below %g", length, bound);
    ok = ok && gen_check(g, !(length > 1.25 * bound) || status == ET_OK, "no normal, though %g is above %g", length, bound);
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* Over a coordinate plane at any scale: the unit vector exactly; run backwards its opposite; where edge or net shrink to a point or a line, none. */
verdict prop_surface_normal_known(gen *g)
{
    et_surface s, t;
    et_vec3 n = {7.0, 8.0, 9.0};
    size_t p = 1 + (size_t)gen_upto(g, 3), q = 1 + (size_t)gen_upto(g, 3), nu = p + 1 + (size_t)gen_upto(g, 2), nv = q + 1 + (size_t)gen_upto(g, 2);
    static const double scales[] = {1.0, 0x1p1021, 0x1p-1000, 0x1p-1021, 3.0};
    int x = (int)gen_upto(g, 2), y = (x + 1) % 3, z = (x + 2) % 3;
    double scale = scales[gen_upto(g, 4)] * (gen_upto(g, 1) ? -1.0 : 1.0), knots = gen_upto(g, 1) ? 0x1p-1018 : 1.0, height = scale * (double)gen_upto(g, 3);
    int rational = (int)gen_upto(g, 1);
    double weight = gen_upto(g, 1) ? 0x1p-900 : 0x1p1000;
    if (et_surface_new(&s, p, q, nu, nv, rational) != ET_OK) {
        return FAIL;
    }
    for (size_t i = 0; i < nu + p + 1; i++) {
        s.u[i] = knots * (i <= p ? 0.0 : i < nu ? (double)(i - p) : (double)(nu - p));
    }
    for (size_t j = 0; j < nv + q + 1; j++) {
        s.v[j] = j <= q ? 0.0 : j < nv ? (double)(j - q) : (double)(nv - q);
    }
    for (size_t k = 0; k < nu * nv; k++) {
        (&s.points[k].x)[x] = scale * (double)(k / nv);
        (&s.points[k].x)[y] = scale * (double)(k % nv);
        (&s.points[k].x)[z] = height;
        if (rational) {
            s.weights[k] = gen_real(g, 0.5, 1.0) * weight;
        }
    }
    double *work = surface_room(&s), u = draw_u(g, &s), v = draw_v(g, &s);
    size_t nwork = et_surface_work(&s);
    bool ok = gen_check(g, et_surface_normal(&n, &s, u, v, work, nwork) == ET_OK && (&n.x)[x] == 0.0 && (&n.x)[y] == 0.0 && (&n.x)[z] == 1.0, "(%a, %a, %a) at (%a, %a)", n.x, n.y,
                        n.z, u, v);
    t = backwards(&s, true, false);
    ok = ok && gen_check(g, et_surface_normal(&n, &t, -u, v, work, nwork) == ET_OK && (&n.x)[z] == -1.0, "backwards (%a, %a, %a)", n.x, n.y, n.z);
    et_surface_free(&t);
    bool end = gen_upto(g, 1) == 1, along_v = gen_upto(g, 1) == 1;
    n = (et_vec3){7.0, 8.0, 9.0};
    for (size_t k = 0; k < nu * nv; k++) {      /* an edge shrinks to a point whose coordinates are no short numbers */
        if (along_v ? k % nv == (end ? nv - 1 : 0) : k / nv == (end ? nu - 1 : 0)) {
            s.points[k] = (et_vec3){0.1 * scale, 0.7 * scale, -0.3 * scale};
        }
    }
    double at_u = along_v ? u : end ? s.u[nu] : s.u[0], at_v = along_v ? (end ? s.v[nv] : s.v[0]) : v;
    ok = ok && gen_check(g, et_surface_normal(&n, &s, at_u, at_v, work, nwork) == ET_ERANK && n.x == 7.0 && n.y == 8.0 && n.z == 9.0, "a normal of a pole");
    for (size_t k = 0; k < nu * nv; k++) {      /* all on a line; all one point */
        double step = along_v ? (double)k * 0.1 : 1.0;
        s.points[k] = (et_vec3){step * scale, 2.0 * step * scale, 0.25 * step * scale};
    }
    ok = ok && gen_check(g, et_surface_normal(&n, &s, u, v, work, nwork) == ET_ERANK && n.x == 7.0, "a normal of a line");
    for (size_t k = 0; k < nu * nv; k++) {      /* on a line, too, and the derivative along v is not above the least numbers */
        double step = (double)(k / nv) + (double)(k % nv > 1 ? k % nv : 0);
        s.points[k] = (et_vec3){step, 2.0 * step, 0.25 * step};
    }
    ok = ok && gen_check(g, et_surface_normal(&n, &s, u, 0x1p-1074, work, nwork) == ET_ERANK && n.x == 7.0, "a normal of what underflows");
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* ---- rows ---- */

/* After the surface: a, b, u, v, sides along u and v (0 right, 1 left); wanted is the derivative a times in u and b times in v. */
verdict gold_surface_partials(const row *r)
{
    et_surface s;
    et_vec3 D[ALL * 4];
    size_t at = read_surface(r, &s), a = at > 0 ? row_size(r, at) : 0, b = at > 0 ? row_size(r, at + 1) : 0, d = a + b;
    if (at == 0 || (d + 1) * (d + 2) / 2 > ALL * 4) {
        return FAIL;
    }
    size_t n = et_surface_partials_work(&s, d);
    double *work = et_size_array(n, sizeof(double));
    et_side side_u = row_size(r, at + 4) ? ET_SIDE_LEFT : ET_SIDE_RIGHT, side_v = row_size(r, at + 5) ? ET_SIDE_LEFT : ET_SIDE_RIGHT;
    et_surface_partials(D, d, &s, row_real(r, at + 2), row_real(r, at + 3), side_u, side_v, work, n);
    bool ok = r->nwant == 3;
    for (int c = 0; ok && c < 3; c++) {
        ok = row_is(r, (size_t)c, coordinate(&D[place(a, b)], c));
    }
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* degrees p, q; order; wanted: doubles. */
verdict gold_surface_partials_work(const row *r)
{
    et_surface s = {row_size(r, 0), row_size(r, 1), 0, 0, NULL, NULL, NULL, NULL};
    return row_is_size(r, 0, et_surface_partials_work(&s, row_size(r, 2))) ? PASS : FAIL;
}

/* After the surface: u, v. */
verdict gold_surface_normal(const row *r)
{
    et_surface s;
    et_vec3 n;
    size_t at = read_surface(r, &s);
    double *work = surface_room(&s);
    bool ok = at > 0 && et_surface_normal(&n, &s, row_real(r, at), row_real(r, at + 1), work, et_surface_work(&s)) == ET_OK && r->nwant == 3;
    for (int c = 0; ok && c < 3; c++) {
        ok = row_is(r, (size_t)c, coordinate(&n, c));
    }
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}

/* After the surface: u, v; wanted is the status. */
verdict gold_surface_normal_status(const row *r)
{
    et_surface s;
    et_vec3 n;
    size_t at = read_surface(r, &s);
    double *work = surface_room(&s);
    bool ok = at > 0 && row_is_size(r, 0, (size_t)et_surface_normal(&n, &s, row_real(r, at), row_real(r, at + 1), work, et_surface_work(&s)));
    free(work);
    et_surface_free(&s);
    return ok ? PASS : FAIL;
}
