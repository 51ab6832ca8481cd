/* exact/exact: the quality of maps; the rows of the fast functions that measure. */
#include "exact/measured.h"

/* ---- et_exact_quality_of ---- */

enum { FEW = 12 };

typedef struct {
    et_doublenet net;
    size_t nov, n;
    et_vec3 weights[CLASSES], cloud[FEW];
} job;

/* From a small lattice, and half of them a last digit off it. */
static void draw_lattice(gen *g, et_vec3 *p, size_t n, double scale)
{
    for (size_t k = 0; k < 3 * n; k++) {
        const uint64_t to = gen_upto(g, 3);
        const double x = (double)gen_upto(g, 2) / 2;
        (&p[0].x)[k] = scale * (to == 1 ? nextafter(x, 2) : to == 2 ? nextafter(x, -2) : x);
    }
}

static void draw_job(gen *g, job *j)
{
    static const double scales[] = {1, 0x1p498, 0x1p-530, 0x1p-540, 0x1p-1074, 0x1p-300};
    const double scale = scales[gen_chance(g, 3) ? gen_upto(g, 5) : 0];
    const uint64_t kind = gen_upto(g, 3);

    j->net = (et_doublenet){gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)};
    j->nov = et_doublenet_nov(j->net);
    j->n = gen_between(g, 1, FEW);
    if (kind == 2) {
        gen_points(g, &j->weights[0].x, j->nov);
        gen_points(g, &j->cloud[0].x, j->n);
        return;
    }
    draw_lattice(g, j->weights, j->nov, scale);
    draw_lattice(g, j->cloud, j->n, scale);
    if (kind == 3) /* whole distances: qe often rational */
        for (size_t k = 0; k < j->n; k++) {
            const double a = ldexp((double)gen_upto(g, 3), -(int)gen_upto(g, 1) * 52), far = 64;
            const size_t c = gen_upto(g, j->nov - 1);
            for (size_t i = 0; i < j->nov; i++)
                j->weights[i] = (et_vec3){far * (double)i, 0, 0};
            j->cloud[k] = (et_vec3){far * (double)c, 3 * a, gen_upto(g, 1) ? 4 * a : 0};
        }
}

static size_t apart(size_t a, size_t b)
{
    return a > b ? a - b : b - a;
}

static void square_to(fmpq_t q, et_vec3 a, et_vec3 b)
{
    fmpq *P = _fmpq_vec_init(6);

    point_of(P, a);
    point_of(P + 3, b);
    square(q, P, P + 3);
    _fmpq_vec_clear(P, 6);
}

static et_som_quality second_quality(const job *j)
{
    fmpq *q = _fmpq_vec_init((slong)j->n), *d = _fmpq_vec_init((slong)j->nov);
    et_som_quality e = {0, 0, INFINITY, 0, j->n};
    size_t count = 0;

    for (size_t s = 0; s < j->n; s++) {
        size_t a = 0, b = j->nov;
        for (size_t c = 0; c < j->nov; c++) {
            square_to(d + c, j->weights[c], j->cloud[s]);
            a = fmpq_cmp(d + c, d + a) < 0 ? c : a;
        }
        for (size_t c = 0; c < j->nov; c++)
            if (c != a && (b == j->nov || fmpq_cmp(d + c, d + b) < 0))
                b = c;
        fmpq_set(q + s, d + a);
        const et_index v = et_doublenet_index(j->net, a + 1), w = et_doublenet_index(j->net, b + 1);
        count += apart(v.i, w.i) + apart(v.j, w.j) > 1 || apart(v.k, w.k) > 1;
        e.min_error = fmin(e.min_error, sum_of_roots(d + a, 1, 1));
        e.max_error = fmax(e.max_error, sum_of_roots(d + a, 1, 1));
    }
    e.qe = sum_of_roots(q, j->n, j->n);
    e.te = (double)count / (double)j->n;
    _fmpq_vec_clear(q, (slong)j->n);
    _fmpq_vec_clear(d, (slong)j->nov);
    return e;
}

static bool same_quality(gen *g, const et_som_quality *q, const et_som_quality *want)
{
    return gen_check(g, same(&q->qe, &want->qe, sizeof q->qe), "qe %a, not %a", q->qe, want->qe) &&
           gen_check(g, same(&q->te, &want->te, sizeof q->te) && q->steps == want->steps, "te %a, not %a", q->te, want->te) &&
           gen_check(g, same(&q->min_error, &want->min_error, sizeof q->qe) && same(&q->max_error, &want->max_error, sizeof q->qe),
                     "from %a to %a, not %a to %a", q->min_error, q->max_error, want->min_error, want->max_error);
}

/* Distances within 3.5u, where squares vanish 2^-535; the mean of few within 18u more; 1u for this one's own rounding. */
static bool near_quality(gen *g, const job *j, const et_som_quality *q)
{
    et_som_quality fast;

    return gen_check(g, et_quality_of(&fast, j->weights, j->nov, j->net, j->cloud, j->n) == ET_OK, "fast") &&
           gen_check(g, fabs(fast.qe - q->qe) <= 24 * ET_UNIT * q->qe + 0x1p-535, "qe %a, fast %a", q->qe, fast.qe) &&
           gen_check(g, fabs(fast.min_error - q->min_error) <= 6 * ET_UNIT * q->min_error + 0x1p-535, "least %a, fast %a", q->min_error,
                     fast.min_error) &&
           gen_check(g, fabs(fast.max_error - q->max_error) <= 6 * ET_UNIT * q->max_error + 0x1p-535, "greatest %a, fast %a", q->max_error,
                     fast.max_error);
}

/* One case in 2. */
verdict prop_exact_quality_of(gen *g)
{
    static job j, before;
    et_som_quality q = {1, 2, 3, 4, 5}, again, want;
    size_t bits = 0, start[2];

    draw_job(g, &j);
    before = j;
    live_begin(j.n + j.net.nx);
    const et_status status = et_exact_quality_of(&q, j.weights, j.nov, j.net, j.cloud, j.n, &bits);
    if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK && doubled(bits, 0), "computed") ||
        !gen_check(g, memcmp(&j, &before, sizeof j) == 0, "nothing else is written"))
        return FAIL;
    want = second_quality(&j);
    if (!same_quality(g, &q, &want) || !near_quality(g, &j, &q))
        return FAIL;
    start[0] = 4 * bits;
    start[1] = gen_between(g, 1, 70);
    for (size_t k = 0; k < 2; k++) {
        const size_t asked = start[k];
        live_begin(j.n + k);
        const et_status s = et_exact_quality_of(&again, j.weights, j.nov, j.net, j.cloud, j.n, start + k);
        if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, s == ET_OK, "from other bits on") || !same_quality(g, &again, &q) ||
            !gen_check(g, doubled(start[k], asked), "%zu bits from %zu on", start[k], asked))
            return FAIL;
    }
    return gen_check(g, et_exact_quality_of(&again, j.weights, j.nov, j.net, j.cloud, j.n, NULL) == ET_OK, "no bits") && same_quality(g, &again, &q)
               ? PASS
               : FAIL;
}

/* The double nearest to (whole + m/2^52 + a little) / n, n a power of 2. */
static double mean_by_hand(uint64_t whole, uint64_t m, bool more, size_t n, int scale, bool *tie)
{
    const uint64_t sum = (whole << 52) + m;
    uint64_t unit = 1;

    while (sum / unit >> 53 > 0)
        unit *= 2;
    const uint64_t rest = 2 * (sum % unit), digits = sum / unit;
    *tie = rest == unit;
    return ldexp((double)(digits + (rest > unit || (rest == unit && (more || digits % 2 == 1)))) * (double)unit, scale - 52) / (double)n;
}

/* A mean in the middle between two doubles, or as good as there: distances m/2^52 and some of 1 and 3, each d greater or less in turn, so that d goes
 * out; or one of them a little greater and irrational. */
verdict prop_exact_quality_of_ties(gen *g)
{
    const size_t n = (size_t)1 << gen_between(g, 1, 3), ones = gen_between(g, 1, n - 1), off = gen_upto(g, n - 1);
    const uint64_t m = 2 * gen_upto(g, UINT64_C(1) << 51) + 1, kind = gen_upto(g, 2);
    const int scale = (int)gen_upto(g, 8);
    const double d = ldexp(1, -(int)gen_between(g, 100, 1070));
    const et_vec3 weights[4] = {{0, 0, kind == 1 ? d : 0}, {4096, 0, 0}, {0, 4096, 0}, {0, 0, 8192}};
    et_vec3 cloud[8];
    et_som_quality q = {0, 0, 0, 0, 0};
    size_t bits = 0;
    bool tie;

    for (size_t k = 0; k < n; k++) {
        const double z = ldexp(k == 0 ? (double)m * 0x1p-52 : k <= ones ? 1 : 3, scale);
        cloud[k] = (et_vec3){kind == 2 && k == off ? d : 0, 0, k % 2 == 0 ? z : -z};
    }
    const double expect = mean_by_hand(ones + 3 * (n - 1 - ones), m, kind == 2, n, scale, &tie);
    gen_label(g, tie ? "tie" : "no tie");
    live_begin(m / 2);
    const et_status status = et_exact_quality_of(&q, weights, 4, (et_doublenet){2, 2}, cloud, n, &bits);
    if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, status == ET_OK, "computed") ||
        !gen_check(g, kind == 0 ? bits == 128 : doubled(bits, 128), "%zu bits", bits))
        return FAIL;
    return gen_check(g, q.qe == expect && bits < 8192, "%llu of %zu: mean %a, not %a; %zu bits", (unsigned long long)m, n, q.qe, expect, bits) ? PASS
                                                                                                                                               : FAIL;
}

verdict prop_exact_quality_of_refuses(gen *g)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, 0x1.0000000000001p500, -0x1.0000000000001p500};
    static job j;
    et_som_quality q = {1, 2, 3, 4, 5};
    const uint64_t what = gen_upto(g, 4);
    size_t bits = 7;

    draw_job(g, &j);
    if (what == 0)
        j.net.ny = gen_upto(g, 1);
    else if (what == 1)
        j.nov += gen_chance(g, 2) ? 1 : SIZE_MAX;
    else if (what == 2)
        j.n = 0;
    else if (what == 3)
        (&j.weights[0].x)[gen_upto(g, 3 * j.nov - 1)] = bad[gen_upto(g, 4)];
    else
        (&j.cloud[0].x)[gen_upto(g, 3 * j.n - 1)] = bad[gen_upto(g, 4)];
    if (!gen_check(g, et_exact_quality_of(&q, j.weights, j.nov, j.net, j.cloud, j.n, &bits) == ET_EINVAL, "refused"))
        return FAIL;
    return gen_check(g, q.qe == 1 && q.te == 2 && q.min_error == 3 && q.max_error == 4 && q.steps == 5 && bits == 7, "quality as before") ? PASS
                                                                                                                                          : FAIL;
}

/* ---- the rows of the fast functions ---- */

static et_vec3 *points_of(const row *r, size_t first, size_t n)
{
    et_vec3 *D = calloc(n + 1, sizeof *D);

    for (size_t i = 0; D != NULL && i < 3 * n; i++)
        (&D[0].x)[i] = row_real(r, first + i);
    return D;
}

/* Rows: approach method knots algebra corners p q nx ny cx cy, data by class; wanted: nov, non, greatest, corner, of the control points as rounded.
 */
verdict true_fit_measure(const row *r)
{
    const et_doublenet net = {row_size(r, 7), row_size(r, 8)};
    const size_t nov = et_doublenet_nov(net);
    et_vec3 *data = points_of(r, 11, nov);
    et_fit_options o = et_fit_defaults();
    et_fit_error e = {0, 0, 0, 0};
    et_fit f;

    o.approach = (et_fit_approach)row_size(r, 0);
    o.method = (et_param_method)row_size(r, 1);
    o.knots = (et_knotrule_kind)row_size(r, 2);
    o.corners = (et_fit_corners)row_size(r, 4);
    o.p = row_size(r, 5);
    o.q = row_size(r, 6);
    o.control = (et_doublenet){row_size(r, 9), row_size(r, 10)};
    if (data == NULL || et_exact_fit_make(&f, data, nov, net, &o, NULL, NULL, NULL) != ET_OK) {
        free(data);
        return FAIL;
    }
    const bool ok = et_exact_fit_measure(&e, NULL, nov, &f, data, NULL) == ET_OK && row_is(r, 0, e.nov) && row_is(r, 1, e.non) &&
                    row_is(r, 2, e.greatest) && row_is(r, 3, e.corner);
    et_fit_free(&f);
    free(data);
    return ok ? PASS : FAIL;
}

/* Rows: p q nu nv samples, interior knots in u and v of both views (u bottom, v bottom, u top, v top), points of both views; wanted: distance u v. */
verdict true_seam_gap(const row *r)
{
    const size_t p = row_size(r, 0), q = row_size(r, 1), nu = row_size(r, 2), nv = row_size(r, 3);
    et_shell s;
    et_seam gap = {0, 0, 0};
    size_t k = 5;
    bool ok;

    if (et_shell_new(&s, p, q, (et_doublenet){nu, nv}, 0) != ET_OK)
        return FAIL;
    for (size_t w = 0; w < 2; w++) {
        for (size_t i = 0; i < nu + p + 1; i++)
            s.view[w].u[i] = i <= p ? 0 : i >= nu ? 1 : row_real(r, k++);
        for (size_t i = 0; i < nv + q + 1; i++)
            s.view[w].v[i] = i <= q ? 0 : i >= nv ? 1 : row_real(r, k++);
    }
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < nu * nv; i++, k += 3)
            s.view[w].points[i] = (et_vec3){row_real(r, k), row_real(r, k + 1), row_real(r, k + 2)};
    ok = et_exact_seam_gap(&gap, &s, row_size(r, 4)) == ET_OK;
    ok = ok && row_is(r, 0, gap.distance) && row_is(r, 1, gap.u) && row_is(r, 2, gap.v);
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

/* Rows: nx ny, NOV weights, points; wanted: qe te least greatest. */
verdict true_quality_of(const row *r)
{
    const et_doublenet net = {row_size(r, 0), row_size(r, 1)};
    const size_t nov = et_doublenet_nov(net), n = (r->nargs - 2) / 3 - nov;
    et_vec3 *w = points_of(r, 2, nov), *cloud = points_of(r, 2 + 3 * nov, n);
    et_som_quality q;
    bool ok = w != NULL && cloud != NULL && et_exact_quality_of(&q, w, nov, net, cloud, n, NULL) == ET_OK && q.steps == n;

    ok = ok && row_is(r, 0, q.qe) && row_is(r, 1, q.te) && row_is(r, 2, q.min_error) && row_is(r, 3, q.max_error);
    free(w);
    free(cloud);
    return ok ? PASS : FAIL;
}
