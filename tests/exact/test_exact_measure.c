/* exact/exact: errors of fits and gaps of seams. */
#include "exact/measured.h"

/* ---- a second way: rationals by the definitions, roots and their sums by MPFR ---- */

/* N_{i,p}(x) by Cox and de Boor's recursion; x of the domain, whose end belongs to the last span that is not empty. */
static void deboor(fmpq_t N, const double *u, size_t i, size_t p, double x, double end)
{
    fmpq_t a, b, c;

    if (p == 0) {
        fmpq_set_si(N, (u[i] <= x && x < u[i + 1]) || (x == end && u[i] < end && u[i + 1] == end), 1);
        return;
    }
    fmpq_init(a);
    fmpq_init(b);
    fmpq_init(c);
    fmpq_zero(N);
    for (size_t k = 0; k < 2; k++) {
        /* (x - u_i)/(u_{i+p} - u_i) N_{i,p-1} and (u_{i+p+1} - x)/(u_{i+p+1} - u_{i+1}) N_{i+1,p-1} */
        const double from = k == 0 ? u[i] : u[i + p + 1], to = k == 0 ? u[i + p] : u[i + 1];
        if (from == to || x < u[i + k] || x > u[i + k + p])
            continue;
        deboor(c, u, i + k, p - 1, x, end);
        of_double(a, x);
        of_double(b, from);
        fmpq_sub(a, a, b);
        fmpq_mul(c, c, a);
        of_double(a, to);
        fmpq_sub(a, a, b);
        fmpq_div(c, c, a);
        fmpq_add(N, N, c);
    }
    fmpq_clear(a);
    fmpq_clear(b);
    fmpq_clear(c);
}

/* A[i*n + j] = N_j(t[i]). */
static fmpq *basis_matrix(const double *t, size_t m, const double *u, size_t n, size_t p)
{
    fmpq *A = _fmpq_vec_init((slong)(m * n));

    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < n; j++)
            deboor(A + i * n + j, u, j, p, fmin(fmax(t[i], u[p]), u[n]), u[n]);
    return A;
}

/* S = sum N M w P / sum N M w for one row of each matrix. */
static void surface_point(fmpq *S, const et_surface *s, const fmpq *N, const fmpq *M)
{
    fmpq_t b, c, w;

    fmpq_init(b);
    fmpq_init(c);
    fmpq_init(w);
    for (size_t k = 0; k < 3; k++)
        fmpq_zero(S + k);
    for (size_t at = 0; at < s->nu * s->nv; at++) {
        if (fmpq_is_zero(N + at / s->nv) || fmpq_is_zero(M + at % s->nv))
            continue;
        fmpq_mul(b, N + at / s->nv, M + at % s->nv);
        of_double(c, s->weights == NULL ? 1 : s->weights[at]);
        fmpq_mul(b, b, c);
        fmpq_add(w, w, b);
        for (size_t k = 0; k < 3; k++) {
            of_double(c, (&s->points[at].x)[k]);
            fmpq_addmul(S + k, b, c);
        }
    }
    for (size_t k = 0; k < 3; k++)
        fmpq_div(S + k, S + k, w);
    fmpq_clear(b);
    fmpq_clear(c);
    fmpq_clear(w);
}

/* ---- bounds of the fast way ---- */

/* Error of a coordinate of a point: at most ((1-u)^-m - 1) |P|, m = 7 (p + q), for a polynomial; numerator and denominator and the quotient for a
 * rational one, (1-u)^-(2m + 3) - 1; three coordinates, for each |P| the greatest; (1-u)^-k - 1 < 1.01 k u. */
static double point_bound(const et_surface *s)
{
    double size[3] = {0, 0, 0};

    for (size_t at = 0; at < s->nu * s->nv; at++)
        for (size_t k = 0; k < 3; k++)
            size[k] = fmax(size[k], fabs((&s->points[at].x)[k]));
    return 1.01 * (14 * (double)(s->p + s->q) + 3) * ET_UNIT * (size[0] + size[1] + size[2]);
}

/* ---- et_exact_fit_measure ---- */

static double direction(gen *g)
{
    const double x = (double)gen_upto(g, 2);

    return gen_upto(g, 1) ? -x : x;
}

/* Control points in 0 and data that are (3, 4, 0) or (1, 2, 2) times halved numbers: distances that are rational, their sums in the middle between
 * two doubles more often than not. */
static void draw_ties(gen *g, et_fit *f, et_vec3 *data, size_t nov)
{
    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; k < f->shell.view[w].nu * f->shell.view[w].nv; k++)
            f->shell.view[w].points[k] = (et_vec3){0, 0, 0};
    for (size_t k = 0; k < nov; k++) {
        const double a = ldexp((double)gen_upto(g, 3), -(int)gen_upto(g, 1) * (50 + (int)gen_upto(g, 4)));
        data[k] = k == 0 ? (et_vec3){0, 1, 0} : gen_upto(g, 1) == 1 ? (et_vec3){3 * a, 0, 4 * a} : (et_vec3){2 * a, a, 2 * a};
    }
}

static void draw_shell(gen *g, et_shell *s, bool rational)
{
    const size_t p = gen_between(g, 1, DEGREE), q = gen_between(g, 1, DEGREE);
    const et_doublenet c = {gen_between(g, p + 1, SIDE), gen_between(g, q + 1, SIDE)};

    et_shell_new(s, p, q, c, rational);
    for (size_t w = 0; w < 2; w++) {
        gen_knots(g, s->view[w].u, c.nx + p + 1, p);
        gen_knots(g, s->view[w].v, c.ny + q + 1, q);
        gen_points(g, &s->view[w].points[0].x, c.nx * c.ny);
        for (size_t i = 0; rational && i < c.nx * c.ny; i++)
            s->view[w].weights[i] = 0.5 + gen_real(g, 0, 2);
    }
}

static void draw_fit(gen *g, et_fit *f, et_vec3 *data)
{
    const bool rational = gen_chance(g, 3);

    memset(f, 0, sizeof *f);
    draw_shell(g, &f->shell, rational);
    f->data = (et_doublenet){gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)};
    for (size_t w = 0; w < 2; w++) {
        const et_surface *s = &f->shell.view[w];
        f->s[w] = calloc(f->data.nx + 1, sizeof(double));
        f->r[w] = calloc(f->data.ny + 1, sizeof(double));
        f->s[w][f->data.nx] = f->r[w][f->data.ny] = NAN;   /* nobody's */
        for (size_t i = 0; i < f->data.nx; i++)
            f->s[w][i] = gen_parameter(g, s->u, s->nu + s->p + 1, s->p) - (double)gen_chance(g, 16);
        for (size_t j = 0; j < f->data.ny; j++)
            f->r[w][j] = gen_parameter(g, s->v, s->nv + s->q + 1, s->q) + (double)gen_chance(g, 16);
    }
    gen_points(g, &data[0].x, et_doublenet_nov(f->data));
    for (size_t k = 0; k < et_doublenet_nov(f->data); k++) /* some are control points */
        if (gen_chance(g, 4))
            data[k] = f->shell.view[k % 2].points[k % (f->shell.view[0].nu * f->shell.view[0].nv)];
    if (gen_chance(g, 3)) {
        draw_ties(g, f, data, et_doublenet_nov(f->data));
        gen_label(g, "ties");
    }
}

/* q[w*nodes + i*ny + j]: squared distances. */
static void all_squares(fmpq *q, const et_fit *f, const et_vec3 *data)
{
    const et_doublenet n = f->data;
    fmpq *S = _fmpq_vec_init(6);

    for (size_t w = 0; w < 2; w++) {
        const et_surface *s = &f->shell.view[w];
        fmpq *A = basis_matrix(f->s[w], n.nx, s->u, s->nu, s->p), *B = basis_matrix(f->r[w], n.ny, s->v, s->nv, s->q);
        for (size_t i = 0; i < n.nx; i++)
            for (size_t j = 0; j < n.ny; j++) {
                surface_point(S, s, A + i * s->nu, B + j * s->nv);
                point_of(S + 3, data[et_doublenet_class(n, w, i, j) - 1]);
                square(q + w * n.nx * n.ny + i * n.ny + j, S, S + 3);
            }
        _fmpq_vec_clear(A, (slong)(n.nx * s->nu));
        _fmpq_vec_clear(B, (slong)(n.ny * s->nv));
    }
    _fmpq_vec_clear(S, 6);
}

/* What et_exact_fit_measure should say. */
static et_fit_error second_measure(double *residual, const et_fit *f, const et_vec3 *data)
{
    const et_doublenet n = f->data;
    const size_t nodes = n.nx * n.ny;
    fmpq *q = _fmpq_vec_init((slong)(2 * nodes)), *c = _fmpq_vec_init((slong)(2 * nodes));
    et_fit_error e = {0, 0, 0, 0};

    all_squares(q, f, data);
    for (size_t at = 2 * nodes; at-- > 0;) { /* the bottom view's last, so that the border's are its */
        const size_t i = at % nodes / n.ny, j = at % n.ny, k = et_doublenet_class(n, at / nodes, i, j) - 1;
        residual[k] = sum_of_roots(q + at, 1, 1);
        fmpq_set(c + k, q + at);
        e.greatest = fmax(e.greatest, residual[k]);
        if (i % (n.nx - 1) == 0 && j % (n.ny - 1) == 0)
            e.corner = fmax(e.corner, residual[k]);
    }
    e.nov = sum_of_roots(c, et_doublenet_nov(n), 1);
    e.non = sum_of_roots(q, 2 * nodes, 1);
    _fmpq_vec_clear(q, (slong)(2 * nodes));
    _fmpq_vec_clear(c, (slong)(2 * nodes));
    return e;
}

/* et_vec3_distance is within 3.5u of itself and, where squares vanish, 2^-536; a sum of n < 128 has at most 18 roundings; 1u for this one's own. */
static bool near_measure(gen *g, const et_fit *f, const et_vec3 *data, const et_fit_error *e)
{
    const et_doublenet n = f->data;
    const double one = fmax(point_bound(&f->shell.view[0]), point_bound(&f->shell.view[1])) + 0x1p-536, all = 2 * (double)(n.nx * n.ny) * one;
    et_fit_error fast;

    return gen_check(g, et_fit_measure(&fast, NULL, et_doublenet_nov(n), f, data) == ET_OK, "fast") &&
           gen_check(g, fabs(fast.nov - e->nov) <= all + 24 * ET_UNIT * e->nov, "nov %a, fast %a", e->nov, fast.nov) &&
           gen_check(g, fabs(fast.non - e->non) <= all + 24 * ET_UNIT * e->non, "non %a, fast %a", e->non, fast.non) &&
           gen_check(g, fabs(fast.greatest - e->greatest) <= 1.01 * one + 6 * ET_UNIT * e->greatest, "greatest %a, fast %a", e->greatest,
                     fast.greatest) &&
           gen_check(g, fabs(fast.corner - e->corner) <= 1.01 * one + 6 * ET_UNIT * e->corner, "corner %a, fast %a", e->corner, fast.corner);
}

static bool measure_refuses(gen *g, et_fit *f, const et_vec3 *data)
{
    const size_t nov = et_doublenet_nov(f->data);
    const et_doublenet n = f->data;
    et_fit_error e = {1, 2, 3, 4};
    const size_t which = gen_upto(g, 3);
    double residual[CLASSES] = {9}, *t[4] = {f->s[0], f->s[1], f->r[0], f->r[1]};
    double *at = t[which] + gen_upto(g, (which < 2 ? n.nx : n.ny) - 1), was = *at;
    size_t bits = 7;
    bool ok = et_exact_fit_measure(&e, residual, nov - 1, f, data, &bits) == ET_EINVAL &&
              et_exact_fit_measure(&e, residual, nov + 1, f, data, &bits) == ET_EINVAL;

    f->data.ny = 1;
    ok = ok && et_exact_fit_measure(&e, residual, 2, f, data, &bits) == ET_EINVAL;
    f->data = n;
    *at = gen_upto(g, 1) ? NAN : INFINITY;
    ok = ok && et_exact_fit_measure(&e, residual, nov, f, data, &bits) == ET_EINVAL;
    *at = was;
    at = &f->shell.view[gen_upto(g, 1)].points[0].y;
    was = *at;
    *at = NAN;
    ok = ok && et_exact_fit_measure(&e, residual, nov, f, data, &bits) == ET_EINVAL;
    *at = was;
    return gen_check(g, ok && e.nov == 1 && e.non == 2 && e.greatest == 3 && e.corner == 4 && residual[0] == 9 && bits == 7, "bad arguments");
}

static void free_fit(et_fit *f)
{
    et_shell_free(&f->shell);
    for (size_t w = 0; w < 2; w++) {
        free(f->s[w]);
        free(f->r[w]);
    }
}

static bool measure_right(gen *g, et_fit *f, const et_vec3 *data)
{
    const size_t nov = et_doublenet_nov(f->data);
    et_fit_error e, again, want;
    double guarded[CLASSES + 2], *residual = guarded + 1, expect[CLASSES];
    size_t bits = 0, start[2];

    residual[-1] = residual[nov] = 9;
    live_begin(f->data.nx + f->data.ny + f->shell.view[0].p);
    const et_status status = et_exact_fit_measure(&e, residual, nov, f, data, &bits);
    if (!gen_check(g, live_end(), "memory is kept") ||
        !gen_check(g, status == ET_OK && residual[-1] == 9 && residual[nov] == 9 && doubled(bits, 0), "measured"))
        return false;
    want = second_measure(expect, f, data);
    for (size_t k = 0; k < nov; k++)
        if (!gen_check(g, same(residual + k, expect + k, sizeof(double)), "class %zu: %a, not %a", k + 1, residual[k], expect[k]))
            return false;
    if (!gen_check(g, same(&e.nov, &want.nov, sizeof e.nov), "nov %a, not %a", e.nov, want.nov) ||
        !gen_check(g, same(&e.non, &want.non, sizeof e.non), "non %a, not %a", e.non, want.non) ||
        !gen_check(g, e.greatest == want.greatest && e.corner == want.corner, "%a %a, not %a %a", e.greatest, e.corner, want.greatest, want.corner))
        return false;
    start[0] = 4 * bits;
    start[1] = gen_between(g, 1, 70);
    for (size_t k = 0; k < 2; k++) {
        const size_t asked = start[k];
        live_begin(f->data.nx + 2 * f->data.ny + k);
        const et_status s = et_exact_fit_measure(&again, NULL, nov, f, data, start + k);
        if (!gen_check(g, live_end(), "memory is kept") || !gen_check(g, s == ET_OK && same(&again, &e, sizeof e), "from other bits on") ||
            !gen_check(g, doubled(start[k], asked), "%zu bits from %zu on", start[k], asked))
            return false;
    }
    return gen_check(g, et_exact_fit_measure(&again, NULL, nov, f, data, NULL) == ET_OK && same(&again, &e, sizeof e), "bits not asked for");
}

/* One case in 2. */
verdict prop_exact_fit_measure(gen *g)
{
    et_vec3 data[CLASSES];
    et_fit f;

    draw_fit(g, &f, data);
    et_fit_error e = {0, 0, 0, 0};
    const bool ok = measure_refuses(g, &f, data) && measure_right(g, &f, data) &&
                    et_exact_fit_measure(&e, NULL, et_doublenet_nov(f.data), &f, data, NULL) == ET_OK && near_measure(g, &f, data, &e);
    free_fit(&f);
    return ok ? PASS : FAIL;
}

/* The precision is the greater of the two sums'.  Bottom at (2/3, 0, 0), a third of two weights' sum; data on the axis, on both sides of it:
 * distances from it 2^53 - 2/3, 5/3, 4/3, 2/3 add up to 2^53 + 3, a tie, while those of the top, at (0, 1, 1), have no rational sum.  Or all data at
 * the bottom, so that one sum is 0 at once and the other 4 sqrt(2). */
/* One case in 50. */
verdict prop_exact_fit_measure_bits(gen *g)
{
    const bool tie = gen_upto(g, 1) == 1;
    const double x[4] = {tie ? 0x1p53 : 0, tie ? -1 : 0, tie ? 2 : 0, 0};
    const size_t shift = gen_upto(g, 3), asked = tie ? 128 : 2;
    double s[2] = {0.5, 0.5};
    et_fit f = {.data = {2, 2}, .s = {s, s}, .r = {s, s}};
    et_fit_error e = {0, 0, 0, 0};
    et_vec3 data[4];
    size_t bits = asked;

    et_shell_new(&f.shell, 1, 1, (et_doublenet){2, 2}, 1);
    for (size_t w = 0; w < 2; w++) {
        et_surface *v = &f.shell.view[w];
        v->u[2] = v->u[3] = v->v[2] = v->v[3] = 1;
        for (size_t k = 0; k < 4; k++) {
            v->points[k] = (et_vec3){w == 0 && k > 1 && tie ? 1 : 0, (double)w, (double)w};
            v->weights[k] = k > 1 ? 2 : 1;
        }
    }
    for (size_t k = 0; k < 4; k++)
        data[k] = (et_vec3){x[(k + shift) % 4], 0, 0};
    live_begin(0);
    const et_status status = et_exact_fit_measure(&e, NULL, 4, &f, data, &bits);
    const bool ok = gen_check(g, live_end(), "memory is kept") && gen_check(g, status == ET_OK && e.nov == (tie ? 0x1p53 + 4 : 0), "nov %a", e.nov) &&
                    gen_check(g, bits == (tie ? 512 : 64), "%zu bits", bits);
    et_shell_free(&f.shell);
    return ok ? PASS : FAIL;
}

/* Data 2^k times as far, to where doubles end: all errors are 2^k times as great, or infinite. */
verdict prop_exact_fit_measure_scales(gen *g)
{
    const int up = (int)gen_between(g, 900, 1000), k = gen_upto(g, 1) ? -up - 60 : up;
    et_vec3 data[CLASSES];
    et_fit_error e, far;
    et_fit f;
    bool ok;

    draw_fit(g, &f, data);
    const size_t nov = et_doublenet_nov(f.data);
    for (size_t i = 0; i < nov; i++)
        data[i] = (et_vec3){direction(g), direction(g), direction(g)};
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < f.shell.view[w].nu * f.shell.view[w].nv; i++)
            f.shell.view[w].points[i] = (et_vec3){direction(g), direction(g), direction(g)};
    ok = gen_check(g, et_exact_fit_measure(&e, NULL, nov, &f, data, NULL) == ET_OK, "measured");
    for (size_t i = 0; i < nov; i++)
        data[i] = (et_vec3){ldexp(data[i].x, k), ldexp(data[i].y, k), ldexp(data[i].z, k)};
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < f.shell.view[w].nu * f.shell.view[w].nv; i++) {
            et_vec3 *p = f.shell.view[w].points + i;
            *p = (et_vec3){ldexp(p->x, k), ldexp(p->y, k), ldexp(p->z, k)};
        }
    ok = ok && gen_check(g, et_exact_fit_measure(&far, NULL, nov, &f, data, NULL) == ET_OK, "measured far away");
    /* A subnormal is a rounded number rounded again here. */
    const double lost = k < 0 ? 0x1p-1074 : 0;
    ok = ok && gen_check(g,
                         fabs(far.nov - ldexp(e.nov, k)) <= lost && fabs(far.non - ldexp(e.non, k)) <= lost &&
                             fabs(far.greatest - ldexp(e.greatest, k)) <= lost && fabs(far.corner - ldexp(e.corner, k)) <= lost,
                         "scaled by 2^%d: %a is not %a", k, far.nov, ldexp(e.nov, k));
    free_fit(&f);
    return ok ? PASS : FAIL;
}

/* Distances 2^1023 add up to infinity, and one beyond the greatest double is infinite, while the exact arithmetic goes on. */
verdict prop_exact_fit_measure_overflow(gen *g)
{
    const double far = ldexp((double)gen_between(g, 8, 15), 1020);
    et_vec3 data[4] = {{-far, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    double s[2] = {0, 1};
    et_fit f = {.data = {2, 2}, .s = {s, s}, .r = {s, s}};
    et_fit_error e = {0, 0, 0, 0};
    bool ok;

    et_shell_new(&f.shell, 1, 1, (et_doublenet){2, 2}, 0);
    for (size_t w = 0; w < 2; w++) {
        et_surface *v = &f.shell.view[w];
        v->u[2] = v->u[3] = v->v[2] = v->v[3] = 1;
        v->points[0] = (et_vec3){w == 0 ? 0 : far, 0, 0};
    }
    ok = gen_check(g,
                   et_exact_fit_measure(&e, NULL, 4, &f, data, NULL) == ET_OK && e.nov == far && isinf(e.non) && isinf(e.greatest) && isinf(e.corner),
                   "%a %a %a %a", e.nov, e.non, e.greatest, e.corner);
    et_shell_free(&f.shell);
    return ok ? PASS : FAIL;
}

/* ---- et_exact_seam_gap ---- */

/* All sample parameters of one direction by definition: for each pair of neighbouring distinct knots, found by search. */
static size_t samples_of(double *t, const double *a, const double *b, size_t na, size_t nb, size_t samples)
{
    size_t n = 0;
    double x = 0;

    t[n++] = 0;
    while (x < 1) {
        double next = 1;
        for (size_t i = 0; i < na; i++)
            next = a[i] > x && a[i] < next ? a[i] : next;
        for (size_t i = 0; i < nb; i++)
            next = b[i] > x && b[i] < next ? b[i] : next;
        for (size_t i = 1; i <= samples; i++)
            t[n++] = x + (next - x) * ((double)i / (double)(samples + 1));
        t[n++] = next;
        x = next;
    }
    return n;
}

enum { MOST = 2 * SIDE * (SAMPLES + 1) + 2 };

/* The greatest square of all pairs of a[0..na-1] and b[0..nb-1] in turn, a outer, where it exceeds `best`. */
static void greatest_gap(fmpq_t best, et_seam *where, const et_shell *s, const double *a, size_t na, const double *b, size_t nb, bool swapped)
{
    fmpq *N[2], *M[2], *S = _fmpq_vec_init(6);
    fmpq_t q;

    fmpq_init(q);
    for (size_t w = 0; w < 2; w++) {
        N[w] = basis_matrix(a, na, s->view[w].u, s->view[w].nu, s->view[w].p);
        M[w] = basis_matrix(b, nb, s->view[w].v, s->view[w].nv, s->view[w].q);
    }
    for (size_t k = 0; k < na * nb; k++) {
        const size_t i = swapped ? k % na : k / nb, j = swapped ? k / na : k % nb;
        for (size_t w = 0; w < 2; w++)
            surface_point(S + 3 * w, &s->view[w], N[w] + i * s->view[w].nu, M[w] + j * s->view[w].nv);
        square(q, S, S + 3);
        if (fmpq_cmp(q, best) > 0) {
            fmpq_set(best, q);
            where->u = a[i];
            where->v = b[j];
        }
    }
    for (size_t w = 0; w < 2; w++) {
        _fmpq_vec_clear(N[w], (slong)(na * s->view[w].nu));
        _fmpq_vec_clear(M[w], (slong)(nb * s->view[w].nv));
    }
    _fmpq_vec_clear(S, 6);
    fmpq_clear(q);
}

static et_seam second_gap(const et_shell *s, size_t samples)
{
    static const double ends[2] = {0, 1};
    const et_surface *a = &s->view[0], *b = &s->view[1];
    double t[MOST];
    et_seam gap = {0, 0, 0};
    fmpq *best = _fmpq_vec_init(1);

    size_t n = samples_of(t, a->v, b->v, a->nv + a->q + 1, b->nv + b->q + 1, samples);
    greatest_gap(best, &gap, s, ends, 2, t, n, true);
    n = samples_of(t, a->u, b->u, a->nu + a->p + 1, b->nu + b->p + 1, samples);
    greatest_gap(best, &gap, s, t, n, ends, 2, false);
    gap.distance = sum_of_roots(best, 1, 1);
    _fmpq_vec_clear(best, 1);
    return gap;
}

static void close_shell(et_shell *s)
{
    et_surface *a = &s->view[0], *b = &s->view[1];

    memcpy(b->u, a->u, (a->nu + a->p + 1) * sizeof(double));
    memcpy(b->v, a->v, (a->nv + a->q + 1) * sizeof(double));
    for (size_t at = 0; at < a->nu * a->nv; at++)
        if (at / a->nv % (a->nu - 1) == 0 || at % a->nv % (a->nv - 1) == 0) {
            b->points[at] = a->points[at];
            if (a->weights != NULL)
                b->weights[at] = a->weights[at];
        }
}

/* The top is the bottom moved by steps that are equal or differ in the last digit: gaps that are equal, or nearly so. */
static void draw_nearly_equal(gen *g, et_shell *s)
{
    const et_surface *a = &s->view[0];

    memcpy(s->view[1].u, a->u, (a->nu + a->p + 1) * sizeof(double));
    memcpy(s->view[1].v, a->v, (a->nv + a->q + 1) * sizeof(double));
    for (size_t at = 0; at < a->nu * a->nv; at++) {
        const uint64_t kind = gen_upto(g, 3);
        const double d = kind == 0 ? 1 : kind == 1 ? 0x1.0000000000001p0 : kind == 2 ? -1 : 0x1.fffffffffffffp-1;
        a->points[at] = (et_vec3){0, 0, 0};
        s->view[1].points[at] = gen_upto(g, 1) ? (et_vec3){d, 0, 0} : (et_vec3){0, 0.6, 0.8 * d};
        if (a->weights != NULL)
            a->weights[at] = s->view[1].weights[at] = 1;
    }
}

static bool seam_refuses(gen *g, et_shell *s, size_t samples)
{
    et_seam gap = {5, 6, 7};
    et_surface *view = &s->view[gen_upto(g, 1)];
    const bool in_u = gen_upto(g, 1) == 1, start = gen_upto(g, 1) == 1;
    const size_t p = in_u ? view->p : view->q, n = in_u ? view->nu : view->nv;
    double *t = (in_u ? view->u : view->v) + (start ? 0 : n);
    bool ok;

    ok = gen_check(g, et_exact_seam_gap(&gap, s, (size_t)-1) == ET_ENOMEM && et_exact_seam_gap(&gap, s, SIZE_MAX / 2) == ET_ENOMEM,
                   "too many samples");
    for (size_t i = 0; i <= p; i++)
        t[i] = start ? -1 : 2;
    ok = gen_check(g, et_exact_seam_gap(&gap, s, samples) == ET_EINVAL, "a domain that is not [0,1]") && ok;
    for (size_t i = 0; i <= p; i++)
        t[i] = start ? 0 : 1;
    view->points[0].x = NAN;
    ok = gen_check(g, et_exact_seam_gap(&gap, s, samples) == ET_EINVAL, "an invalid shell") && ok;
    return gen_check(g, gap.distance == 5 && gap.u == 6 && gap.v == 7, "written though refused") && ok;
}

verdict prop_exact_seam_gap(gen *g)
{
    const size_t samples = gen_upto(g, SAMPLES);
    const uint64_t kind = gen_upto(g, 3);
    et_shell s;
    et_seam gap = {5, 6, 7}, fast = {5, 6, 7};
    bool ok;

    draw_shell(g, &s, gen_chance(g, 3));
    if (kind == 0)
        close_shell(&s);
    if (kind == 1)
        draw_nearly_equal(g, &s);
    gen_label(g, kind == 0 ? "closed" : kind == 1 ? "nearly equal gaps" : "open");
    live_begin(samples + s.view[0].nu + s.view[0].nv);
    const et_status status = et_exact_seam_gap(&gap, &s, samples);
    ok = gen_check(g, live_end(), "memory is kept") && gen_check(g, status == ET_OK && et_seam_gap(&fast, &s, samples) == ET_OK, "measured");
    const et_seam expect = second_gap(&s, samples);
    const double bound = point_bound(&s.view[0]) + point_bound(&s.view[1]) + 0x1p-536;
    ok = ok && gen_check(g, same(&gap, &expect, sizeof gap), "gap %a at (%a, %a), not %a at (%a, %a)", gap.distance, gap.u, gap.v, expect.distance,
                         expect.u, expect.v);
    ok = ok && gen_check(g, kind != 0 || (gap.distance == 0 && gap.u == 0 && gap.v == 0), "a closed shell's gap %a", gap.distance);
    ok = ok && gen_check(g, fabs(fast.distance - gap.distance) <= 1.01 * bound + 6 * ET_UNIT * gap.distance, "gap %a, fast %a", gap.distance,
                         fast.distance);
    ok = ok && seam_refuses(g, &s, samples);
    et_shell_free(&s);
    return ok ? PASS : FAIL;
}

/* Knots beyond the domain [0,1], for n control points. */
static void free_ends(gen *g, double *u, size_t n, size_t p)
{
    for (size_t i = 0; i < p; i++) {
        u[i] = -gen_real(g, 0, 1) - (double)(p - i);
        u[n + p - i] = 1 + (double)(p - i);
    }
}

/* Knots not clamped: what matters is the domain. */
verdict prop_exact_seam_gap_free_ends(gen *g)
{
    const size_t samples = gen_upto(g, SAMPLES);
    et_shell s;
    et_seam gap = {5, 6, 7};

    draw_shell(g, &s, false);
    for (size_t w = 0; w < 2; w++) {
        et_surface *v = &s.view[w];
        free_ends(g, v->u, v->nu, v->p);
        free_ends(g, v->v, v->nv, v->q);
    }
    const bool ok = gen_check(g, et_exact_seam_gap(&gap, &s, samples) == ET_OK, "measured");
    const et_seam expect = second_gap(&s, samples);
    et_shell_free(&s);
    return ok && gen_check(g, same(&gap, &expect, sizeof gap), "gap %a at (%a, %a), not %a at (%a, %a)", gap.distance, gap.u, gap.v, expect.distance,
                           expect.u, expect.v)
               ? PASS
               : FAIL;
}
