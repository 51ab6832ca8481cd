/* One direction of the optimum's model, from inside: basis functions, the columns that count, the better basis.  Each is computed again from its
 * definition and compared bit for bit. */
#include "etalon/base/real.h"
#include "etalon/refine/optimum.h"
#include "refine/optimum_cases.h"
#include "refine/optimum_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 66, ROWS = 70, WIDE = 5 };

typedef struct { size_t count; double sum; } matched;

typedef struct {
    size_t n, p, nt;
    double u[COLUMNS + WIDE], t[ROWS];
    size_t first[ROWS];
    double value[ROWS * WIDE];
    int shift[COLUMNS];
    unsigned char keep[COLUMNS], zero[COLUMNS];
    int clamped, whole;
    double change[COLUMNS][COLUMNS], table[ROWS][COLUMNS];
    bool tied;                            /* a number lies so near the middle of two doubles that 256 bits do not tell which is nearer */
} expected;

/* ---- the second computation ---- */

static double moved_inside(const expected *e, double t)
{
    return t < e->u[e->p] ? e->u[e->p] : t > e->u[e->n] ? e->u[e->n] : t;
}

/* The last span that is not empty and begins at or before t, within the domain. */
static size_t span(const expected *e, double t)
{
    size_t found = e->p;

    for (size_t k = e->p; k < e->n; k++)
        if (e->u[k] < e->u[k + 1] && e->u[k] <= t && e->u[k] < e->u[e->n])
            found = k;
    return found;
}

static double nearest(expected *e, const arb_t x)
{
    const double d = optimum_case_nearest(x);
    arb_t distance, half;

    arb_init(distance);
    arb_init(half);
    for (size_t side = 0; side < 2 && d != 0; side++) {
        arb_set_d(half, (nextafter(d, side ? 2 * d : 0) - d) / 2);
        arb_set_d(distance, d);
        arb_sub(distance, x, distance, OPTIMUM_BITS);
        arb_div(distance, distance, half, OPTIMUM_BITS);
        e->tied = e->tied || fabs(1 - optimum_case_nearest(distance)) < 0x1p-50;
    }
    arb_clear(distance);
    arb_clear(half);
    return d;
}

static void expect_values(expected *e)
{
    arb_t N;

    e->tied = false;
    arb_init(N);
    for (size_t i = 0; i < e->nt; i++) {
        const double t = moved_inside(e, e->t[i]);

        e->first[i] = span(e, t) - e->p;
        for (size_t k = 0; k <= e->p; k++) {
            optimum_case_basis(N, e->u, e->n, e->p, e->first[i] + k, t);
            e->value[i * (e->p + 1) + k] = arb_is_zero(N) ? 0 : fmax(nearest(e, N), 0x1p-1022);
        }
    }
    arb_clear(N);
}

static double value_at(const expected *e, size_t i, size_t j)
{
    return j < e->first[i] || j > e->first[i] + e->p ? 0 : e->value[i * (e->p + 1) + j - e->first[i]];
}

static bool ahead(matched a, matched b)
{
    return a.count != b.count ? a.count > b.count : a.sum > b.sum;
}

/* The best increasing choice: of the first i parameters and j columns; what leaves out the last parameter first, then the last column, then the pair.
 */
static void expect_keep(expected *e)
{
    static matched best[ROWS + 1][COLUMNS + 1];
    size_t i = e->nt, j = e->n;

    memset(best, 0, sizeof best);
    memset(e->keep, 0, sizeof e->keep);
    for (size_t a = 1; a <= e->nt; a++)
        for (size_t b = 1; b <= e->n; b++) {
            const bool again = a > 1 && moved_inside(e, e->t[a - 1]) == moved_inside(e, e->t[a - 2]);
            const double x = again ? 0 : value_at(e, a - 1, b - 1);

            best[a][b] = ahead(best[a][b - 1], best[a - 1][b]) ? best[a][b - 1] : best[a - 1][b];
            if (x > 0) {
                const matched pair = {best[a - 1][b - 1].count + 1, best[a - 1][b - 1].sum + et_real_log(x)};

                if (ahead(pair, best[a][b]))
                    best[a][b] = pair;
            }
        }
    while (i > 0 && j > 0) {
        if (!ahead(best[i][j], best[i - 1][j]))
            i--;
        else if (!ahead(best[i][j], best[i][j - 1]))
            j--;
        else
            e->keep[--i, --j] = 1;
    }
}

/* The columns' sizes; which are zero; what is left out although it is not. */
static void expect_shift(expected *e)
{
    e->whole = 1;
    for (size_t j = 0; j < e->n; j++) {
        double most = 0;

        for (size_t i = 0; i < e->nt; i++)
            most = fmax(most, value_at(e, i, j));
        e->zero[j] = most == 0;
        e->whole = e->whole && (e->zero[j] || e->keep[j]);
        for (e->shift[j] = 0; most > 0 && most < 0.5; most *= 2)
            e->shift[j]++;
        if (most == 1)
            e->shift[j] = -1;
    }
    for (size_t i = 0; i < e->nt; i++)
        for (size_t k = 0; k <= e->p; k++)
            e->value[i * (e->p + 1) + k] *=
                ldexp(1, e->shift[e->first[i] + k] / 2) * ldexp(1, e->shift[e->first[i] + k] - e->shift[e->first[i] + k] / 2);
}

static void expect_axis(expected *e)
{
    expect_values(e);
    e->clamped = 1;
    for (size_t j = 0; j < e->n; j++)
        e->clamped = e->clamped && (value_at(e, 0, j) > 0) == (j == 0) && (value_at(e, e->nt - 1, j) > 0) == (j == e->n - 1);
    expect_keep(e);
    expect_shift(e);
}

static double inner(const expected *e, size_t j, size_t k)
{
    double sum = 0;

    for (size_t i = 0; i < e->nt; i++)
        sum += e->table[i][j] * e->table[i][k];
    return sum;
}

static bool orthogonal(expected *e, size_t j, size_t end)
{
    double length;

    for (size_t pass = 0; pass < 2; pass++)
        for (size_t k = 1; k < end; k++) {
            const double share = inner(e, j, k);

            for (size_t i = 0; i < e->nt && e->keep[k]; i++)
                e->table[i][j] -= share * e->table[i][k];
            for (size_t i = 0; i < e->n && e->keep[k]; i++)
                e->change[i][j] -= share * e->change[i][k];
        }
    length = sqrt(inner(e, j, j));
    if (length <= 0x1p-40)
        return false;
    for (size_t i = 0; i < e->nt; i++)
        e->table[i][j] /= length;
    for (size_t i = 0; i < e->n; i++)
        e->change[i][j] /= length;
    return true;
}

/* Gram and Schmidt, the ends last: the amplification, or 0. */
static double expect_change(expected *e)
{
    double sum = 0;

    if (e->n > 64 || !e->keep[0] || !e->keep[e->n - 1])
        return 0;
    memset(e->change, 0, sizeof e->change);
    memset(e->table, 0, sizeof e->table);
    for (size_t i = 0; i < e->nt; i++)
        for (size_t j = 0; j < e->n; j++)
            e->table[i][j] = e->keep[j] ? value_at(e, i, j) : 0;
    for (size_t j = 0; j < e->n; j++)
        e->change[j][j] = 1;
    for (size_t j = 1; j + 1 < e->n; j++)
        if (e->keep[j] && !orthogonal(e, j, j))
            return 0;
    if (!orthogonal(e, 0, e->n - 1) || !orthogonal(e, e->n - 1, e->n - 1))
        return 0;
    for (size_t i = 0; i < e->n; i++)
        for (size_t j = 0; j < e->n; j++)
            sum += e->change[i][j] * e->change[i][j];
    return sqrt(sum);
}

/* The table anew from the exact basis functions. */
static void expect_table(expected *e)
{
    arb_t N, s, x;

    arb_init(N);
    arb_init(s);
    arb_init(x);
    for (size_t i = 0; i < e->nt; i++)
        for (size_t j = 0; j < e->n; j++) {
            arb_zero(s);
            for (size_t k = e->first[i]; k <= e->first[i] + e->p; k++)
                if (e->keep[k]) {
                    optimum_case_basis(N, e->u, e->n, e->p, k, moved_inside(e, e->t[i]));
                    arb_mul_2exp_si(N, N, e->shift[k]);
                    arb_set_d(x, e->change[k][j]);
                    arb_addmul(s, N, x, OPTIMUM_BITS);
                }
            e->table[i][j] = nearest(e, s);
        }
    arb_clear(N);
    arb_clear(s);
    arb_clear(x);
}

/* ---- comparing ---- */

static bool same_axis(gen *g, const optimum_axis *a, const expected *e)
{
    bool ok = gen_check(g, a->n == e->n && a->p == e->p && a->nt == e->nt && a->knots == e->u && a->t == e->t, "sizes");

    ok = ok && gen_check(g, memcmp(a->first, e->first, e->nt * sizeof *e->first) == 0, "first");
    for (size_t j = 0; j < e->n && ok; j++)
        ok = gen_check(g, a->keep[j] == e->keep[j], "column %zu: %d kept, not %d", j, a->keep[j], e->keep[j]) &&
             gen_check(g, a->shift[j] == e->shift[j], "column %zu: shift %d, not %d", j, a->shift[j], e->shift[j]);
    for (size_t k = 0; k < e->nt * (e->p + 1) && ok; k++)
        ok = gen_check(g, optimum_case_same(a->value + k, e->value + k, 1), "value %zu: %a, not %a", k, a->value[k], e->value[k]);
    return ok && gen_check(g, a->clamped == e->clamped && a->whole == e->whole, "clamped %d, whole %d", a->clamped, a->whole) &&
           gen_check(g, a->change == NULL && a->table == NULL, "a basis nobody asked for");
}

static bool same_change(gen *g, const optimum_axis *a, const expected *e, bool wanted)
{
    bool ok = gen_check(g, (a->change != NULL) == wanted && (a->table != NULL) == wanted, "basis %s", wanted ? "missing" : "not wanted");

    for (size_t i = 0; i < e->n && ok && wanted; i++)
        ok = gen_check(g, optimum_case_same(a->change + i * e->n, e->change[i], e->n), "row %zu of T", i);
    for (size_t k = 0; k < e->nt * e->n && ok && wanted; k++) {     /* where terms cancel their 256 bits' roundings are left */
        const double got = a->table[k], want = e->table[k / e->n][k % e->n];

        ok = gen_check(g, got == want || fabs(got - want) <= 0x1p-200, "table, row %zu: %a, not %a", k / e->n, got, want);
    }
    return ok;
}

static et_status make(optimum_axis *a, const expected *e)
{
    return optimum_axis_new(a, e->u, e->n, e->p, e->t, e->nt);
}

/* ---- properties ---- */

static void draw(gen *g, expected *e, size_t kind)
{
    e->p = gen_between(g, 1, 4);
    e->n = gen_between(g, e->p + 1, 7);
    e->nt = gen_between(g, kind == 2 ? 2 : e->n, 8);
    if (kind == 2)
        optimum_case_knots(g, e->u, e->n, e->p);
    else
        gen_knots(g, e->u, e->n + e->p + 1, e->p);
    optimum_case_parameters(g, e->t, e->nt, e->u, e->n, e->p, kind);
}

/* Anything: knots at full multiplicity, not clamped, powers of spans that underflow; parameters repeated, outside, few. */
verdict prop_optimum_find_axis(gen *g)
{
    static expected e;
    optimum_axis a;
    bool ok;

    draw(g, &e, gen_upto(g, 2));
    expect_axis(&e);
    if (e.tied)
        return SKIP;
    ok = gen_check(g, make(&a, &e) == ET_OK, "not made") && same_axis(g, &a, &e);
    gen_label(g, !e.whole ? "columns left out" : e.clamped ? "clamped" : "whole");
    if (ok) {
        optimum_axis_keep_all(&a);
        for (size_t j = 0; j < e.n && ok; j++)
            ok = gen_check(g, a.keep[j] == (e.keep[j] || !e.zero[j]), "column %zu: kept %d of all", j, a.keep[j]);
        ok = ok && gen_check(g, a.whole == 1, "not whole");
    }
    optimum_axis_free(&a);
    return ok ? PASS : FAIL;
}

/* The better basis of the pair's worse direction, if together they are bad enough. */
static bool changed(gen *g, expected *e, expected *f, int *which)
{
    optimum_axis a, b;
    const double u = (expect_axis(e), expect_change(e)), v = (expect_axis(f), expect_change(f));
    const int want = u * v <= 64 * sqrt((double)(e->n * f->n)) ? -1 : u <= v;
    bool ok = make(&a, e) == ET_OK, sure = !e->tied && !f->tied;

    ok = make(&b, f) == ET_OK && ok;
    ok = ok && gen_check(g, optimum_axis_change(which, &a, &b) == ET_OK && (!sure || *which == want), "%d, not %d: %g and %g", *which, want, u, v);
    if (sure && want >= 0)
        expect_table(want == 1 ? f : e);
    sure = sure && !e->tied && !f->tied;
    ok = ok && (!sure || (same_change(g, &a, e, want == 0) && same_change(g, &b, f, want == 1)));
    optimum_axis_free(&a);
    optimum_axis_free(&b);
    return ok;
}

/* One case in 2. */
verdict prop_optimum_find_axis_change(gen *g)
{
    static expected e, f;
    int which = 7;
    bool ok;

    draw(g, &e, gen_upto(g, 2));
    draw(g, &f, gen_upto(g, 2));
    if (gen_chance(g, 4))                 /* both alike: the second */
        f = e;
    ok = changed(g, &e, &f, &which);
    gen_label(g, which < 0 ? "none" : which == 0 ? "first" : "second");
    return ok ? PASS : FAIL;
}

/* Cubics whose second and third parameter are so far apart. */
static void draw_close(expected *e, double distance)
{
    e->p = 3;
    e->n = e->nt = 4;
    for (size_t k = 0; k < 8; k++)
        e->u[k] = k < 4 ? 0 : 1;
    e->t[0] = 0;
    e->t[1] = 0.5;
    e->t[2] = 0.5 + distance;
    e->t[3] = 1;
}

static int decided(expected *e, expected *f)
{
    const double u = (expect_axis(e), expect_change(e)), v = (expect_axis(f), expect_change(f));

    return u * v > 64 * sqrt((double)(e->n * f->n));
}

/* Two parameters so close that the pair is just bad enough, or just not. */
/* One case in 50. */
verdict prop_optimum_find_axis_change_limit(gen *g)
{
    static expected e, f;
    double low = 0x1p-20, high = 0.25;
    int which = 7;
    bool ok;

    do {
        draw(g, &f, 0);
        draw_close(&e, high);
    } while (decided(&e, &f) && gen_chance(g, 2));
    for (size_t step = 0; step < 20; step++) {
        const double middle = (low + high) / 2;

        draw_close(&e, middle);
        *(decided(&e, &f) ? &low : &high) = middle;
    }
    draw_close(&e, low);
    ok = changed(g, &e, &f, &which);
    draw_close(&e, high);
    ok = ok && changed(g, &e, &f, &which);
    gen_label(g, which < 0 ? "at the limit" : "always changed");
    return ok ? PASS : FAIL;
}

/* So close that rounding has nearly left nothing of a column, or nothing. */
/* One case in 100. */
verdict prop_optimum_find_axis_change_nothing(gen *g)
{
    static expected e, f;
    int which = 7;
    bool ok = true, some = false, none = false;

    draw_close(&f, 0.25);
    for (int k = 0; k < 24 && ok; k++) {
        draw_close(&e, ldexp(1 + gen_real(g, 0, 1), -32 - k / 2));
        ok = changed(g, &e, &f, &which) && (k % 2 || changed(g, &f, &e, &which));
        *(which < 0 ? &none : &some) = true;
    }
    return ok && gen_check(g, some && none, "no limit") ? PASS : FAIL;
}

/* At most 64 columns are changed. */
/* One case in 400. */
verdict prop_optimum_find_axis_change_many(gen *g)
{
    static expected e, f;
    int which = 7;
    bool ok = true;

    for (size_t n = 63; n <= 65 && ok; n++) {
        e.p = gen_between(g, 2, 3);
        e.n = n;
        for (size_t k = 0; k < n + e.p + 1; k++)
            e.u[k] = k <= e.p ? 0 : k >= n ? 1 : (double)(k - e.p) / (double)(n - e.p);
        e.nt = n;
        for (size_t i = 0; i < n; i++)
            e.t[i] = (double)i / (double)(n - 1);
        f.p = 3;
        f.n = f.nt = 4;
        for (size_t k = 0; k < 8; k++)
            f.u[k] = k < 4 ? 0 : 1;
        for (size_t i = 0; i < 4; i++)
            f.t[i] = i == 0 ? 0 : i == 3 ? 1 : i == 1 ? 0.5 : 0.5 + 0x1p-14;
        ok = changed(g, &e, &f, &which);
        ok = ok && gen_check(g, (which == -1) == (n > 64), "%zu columns: %d", n, which);
    }
    return ok ? PASS : FAIL;
}
