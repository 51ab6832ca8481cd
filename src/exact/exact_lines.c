/* exact_lines: parameters of lines of points, and their means. */
#include "etalon/base/size.h"
#include "exact/exact_radical_parts.h"
#include <stdlib.h>
#include <string.h>

enum { DOUBLINGS = 2 }; /* ties are looked for after so many */

void exact_uniform(double *t, size_t n)
{
    fmpq_t q;

    fmpq_init(q);
    for (size_t i = 0; i < n; i++) {
        fmpz_set_ui(fmpq_numref(q), (ulong)i);
        fmpz_set_ui(fmpq_denref(q), (ulong)(n - 1));
        fmpq_canonicalise(q);
        t[i] = exact_round(q);
    }
    fmpq_clear(q);
}

/* ---- lines ---- */

/* From squared chords: d = q^(1/2), d^(1/2) = q^(1/4), d^(4/5) = (q^2)^(1/5). */
static ulong root_of(et_param_method method)
{
    return method == ET_PARAM_CHORD ? 2 : method == ET_PARAM_CENTRIPETAL ? 4 : 5;
}

/* Radicands of the chords of one line; a line of no length gets equal ones, which make it uniform. */
static int line_set(fmpz *r, const et_vec3 *D, size_t n, size_t stride, ulong root)
{
    exact_net points;
    fmpz_t unit;
    int flat;

    fmpz_init(unit);
    exact_net_init(&points, D, NULL, n, 1, stride);
    for (size_t k = 0; k + 1 < n; k++) {
        exact_gap(r + k, unit, points.H + EXACT_COMPONENTS * k, 0, points.H + EXACT_COMPONENTS * (k + 1), 0);
        if (root == 5)
            fmpz_mul(r + k, r + k, r + k);
    }
    flat = _fmpz_vec_is_zero(r, (slong)(n - 1));
    for (size_t k = 0; flat && k + 1 < n; k++)
        fmpz_one(r + k);
    exact_net_clear(&points);
    fmpz_clear(unit);
    return flat;
}

et_status exact_lines_init(exact_lines *L, size_t lines, size_t step, const et_vec3 *D, size_t n, size_t stride, et_param_method method)
{
    size_t cells;

    /* The tables of ties have at most chords x chords entries. */
    if (et_size_mul(&cells, lines, n - 1) != ET_OK || cells > WORD_MAX / sizeof(fmpq) || et_size_mul(&cells, n, n) != ET_OK ||
        cells > WORD_MAX / sizeof(fmpq))
        return ET_ENOMEM;
    *L = (exact_lines){lines, n - 1, 0, root_of(method), _fmpz_vec_init((slong)(lines * (n - 1)))};
    for (size_t l = 0; l < lines; l++)
        L->flat += line_set(L->r + l * L->n, D + l * step, n, stride, L->root) != 0;
    return ET_OK;
}

void exact_lines_clear(exact_lines *L)
{
    _fmpz_vec_clear(L->r, (slong)(L->lines * L->n));
}

/* ---- balls ---- */

/* m[k] += t_{k+1} of the line of radicands r; a: n balls of work. */
static void add_line(arb_ptr m, arb_ptr a, const fmpz *r, size_t n, ulong root, slong prec)
{
    for (size_t k = 0; k < n; k++) {
        arb_set_fmpz(a + k, r + k);
        arb_root_ui(a + k, a + k, root, prec);
        if (k > 0)
            arb_add(a + k, a + k, a + k - 1, prec);
    }
    for (size_t k = 0; k + 1 < n; k++) {
        arb_div(a + k, a + k, a + n - 1, prec);
        arb_add(m + k, m + k, a + k, prec);
    }
}

/* m[k]: the mean t_{k+1} as a ball; a as above. */
static void enclose(arb_ptr m, arb_ptr a, const exact_lines *L, slong prec)
{
    _arb_vec_zero(m, (slong)L->n);
    for (size_t l = 0; l < L->lines; l++)
        add_line(m, a, L->r + l * L->n, L->n, L->root, prec);
    for (size_t k = 0; k + 1 < L->n; k++)
        arb_div_ui(m + k, m + k, (ulong)L->lines, prec);
}

/* ---- ties ---- */

/* A line's chords in groups of rational proportion to one another; each group's length is a radical, and radicals of different groups are linearly
 * independent over the rationals (Besicovitch 1940, Mordell 1953).  W[g]: the root-th power of group g's length over the first one's, rising;
 * F[g*n + k]: the sum, over the lines of the same W, of the share of group g that lies in the chords 0..k.  As
 *     t_{k+1} = sum_g share_g W_g^(1/root) / sum_g W_g^(1/root)
 * for each of these lines, their sum is rational just if F[g*n + k] is the same for all g, and then it is that. */
typedef struct {
    size_t groups;
    fmpq *W, *F;
} family;

static void family_clear(family *f, size_t n)
{
    _fmpq_vec_clear(f->W, (slong)f->groups);
    _fmpq_vec_clear(f->F, (slong)(f->groups * n));
}

/* c = (a/b)^(1/root) if that is rational; b not zero. */
static int proportion(fmpq_t c, const fmpz_t a, const fmpz_t b, ulong root)
{
    fmpz_set(fmpq_numref(c), a);
    fmpz_set(fmpq_denref(c), b);
    fmpq_canonicalise(c);
    return fmpz_root(fmpq_numref(c), fmpq_numref(c), (slong)root) && fmpz_root(fmpq_denref(c), fmpq_denref(c), (slong)root);
}

/* The groups of line l and F[g*n + k], not yet shares: lengths in units of the group's first chord; first[g]: which that is.  A chord of no length
 * belongs to no group. */
static size_t gather(fmpq *F, size_t *first, const exact_lines *L, size_t l)
{
    const size_t n = L->n;
    size_t groups = 0;
    fmpq_t c;

    fmpq_init(c);
    for (size_t k = 0; k < n; k++) {
        const fmpz *r = L->r + l * n;
        size_t g = 0;
        for (size_t h = 0; k > 0 && h < groups; h++)
            fmpq_set(F + h * n + k, F + h * n + k - 1);
        if (fmpz_is_zero(r + k))
            continue;
        while (g < groups && !proportion(c, r + k, r + first[g], L->root))
            g++;
        if (g == groups) {
            first[groups++] = k;
            fmpq_one(c);
        }
        fmpq_add(F + g * n + k, F + g * n + k, c);
    }
    fmpq_clear(c);
    return groups;
}

/* Groups in rising order of W, by insertion. */
static void sort_groups(family *f, size_t n)
{
    for (size_t g = 1; g < f->groups; g++)
        for (size_t h = g; h > 0 && fmpq_cmp(f->W + h, f->W + h - 1) < 0; h--) {
            fmpq_swap(f->W + h, f->W + h - 1);
            for (size_t k = 0; k < n; k++)
                fmpq_swap(f->F + h * n + k, f->F + (h - 1) * n + k);
        }
}

/* From lengths to W and shares. */
static void normalise(family *f, const size_t *first, const exact_lines *L, size_t l)
{
    const size_t n = L->n;
    fmpq_t least;

    fmpq_init(least);
    for (size_t g = 0; g < f->groups; g++) {
        fmpq *F = f->F + g * n;
        fmpq_pow_si(f->W + g, F + n - 1, (slong)L->root);
        fmpq_mul_fmpz(f->W + g, f->W + g, L->r + l * n + first[g]);
        for (size_t k = 0; k < n; k++)
            fmpq_div(F + k, F + k, F + n - 1);
    }
    sort_groups(f, n);
    fmpq_set(least, f->W);
    for (size_t g = 0; g < f->groups; g++)
        fmpq_div(f->W + g, f->W + g, least);
    fmpq_clear(least);
}

static void family_init(family *f, const exact_lines *L, size_t l)
{
    const size_t n = L->n;
    size_t *first = flint_calloc(n, sizeof *first);
    fmpq *F = _fmpq_vec_init((slong)(n * n));

    f->groups = gather(F, first, L, l);
    f->W = _fmpq_vec_init((slong)f->groups);
    f->F = _fmpq_vec_init((slong)(f->groups * n));
    for (size_t k = 0; k < f->groups * n; k++)
        fmpq_swap(f->F + k, F + k);
    _fmpq_vec_clear(F, (slong)(n * n));
    normalise(f, first, L, l);
    flint_free(first);
}

static int same_lengths(const family *a, const family *b)
{
    size_t g = 0;

    while (g < a->groups && g < b->groups && fmpq_equal(a->W + g, b->W + g))
        g++;
    return g == a->groups && g == b->groups;
}

/* All lines in families; returns how many there are. */
static size_t families(family *f, const exact_lines *L)
{
    size_t n = 0;

    for (size_t l = 0; l < L->lines; l++) {
        size_t at = 0;
        family_init(f + n, L, l);
        while (!same_lengths(f + at, f + n))
            at++;
        for (size_t k = 0; at < n && k < f[n].groups * L->n; k++)
            fmpq_add(f[at].F + k, f[at].F + k, f[n].F + k);
        if (at < n)
            family_clear(f + n, L->n);
        else
            n++;
    }
    return n;
}

/* How many of the families' sums at k are irrational; sum: the others' sum. */
static size_t irrationals(fmpq_t sum, const family *f, size_t nf, size_t n, size_t k)
{
    size_t count = 0;

    fmpq_zero(sum);
    for (size_t i = 0; i < nf; i++) {
        size_t g = 1;
        while (g < f[i].groups && fmpq_equal(f[i].F + g * n + k, f[i].F + k))
            g++;
        count += g < f[i].groups;
        if (g == f[i].groups)
            fmpq_add(sum, sum, f[i].F + k);
    }
    return count;
}

typedef enum { OPEN = 0, ENDING, DECIDED } decision; /* ENDING: irrational, so that some precision decides */

/* What is rational is rounded; what is proved not to be is marked. */
static void settle(double *t, decision *known, const exact_lines *L)
{
    family *f = flint_calloc(L->lines, sizeof *f);
    const size_t nf = families(f, L);
    fmpq_t sum;

    fmpq_init(sum);
    for (size_t k = 0; k + 1 < L->n; k++) {
        const size_t count = known[k] == DECIDED ? 2 : irrationals(sum, f, nf, L->n, k);
        if (count == 1)
            known[k] = ENDING;
        if (count > 0)
            continue;
        fmpz_mul_ui(fmpq_denref(sum), fmpq_denref(sum), (ulong)L->lines);
        fmpq_canonicalise(sum);
        t[k] = exact_round(sum);
        known[k] = DECIDED;
    }
    fmpq_clear(sum);
    for (size_t i = 0; i < nf; i++)
        family_clear(f + i, L->n);
    flint_free(f);
}

/* ---- means ---- */

/* t[k] = t_{k+1}, k + 1 < n; known, m, a: n each, known all OPEN. */
static et_status decide(double *t, decision *known, arb_ptr m, arb_ptr a, const exact_lines *L, size_t *bits)
{
    size_t prec = exact_first_bits(bits);

    for (size_t doublings = 0;; doublings++, prec *= 2) {
        decision least = DECIDED;
        enclose(m, a, L, (slong)prec);
        for (size_t k = 0; k + 1 < L->n; k++)
            if (known[k] != DECIDED && exact_round_ball(t + k, m + k))
                known[k] = DECIDED;
        if (doublings == DOUBLINGS)
            settle(t, known, L);
        for (size_t k = 0; k + 1 < L->n; k++)
            least = known[k] < least ? known[k] : least;
        if (least == DECIDED) {
            *bits = prec;
            return ET_OK;
        }
        if (least == OPEN && doublings >= DOUBLINGS && prec >= EXACT_MOST_BITS)
            return ET_ENOCONV;
    }
}

et_status exact_lines_means(double *t, const exact_lines *L, size_t *bits)
{
    double *inner;
    decision *known;
    arb_ptr m, a;
    et_status status;

    if (L->flat == L->lines || L->n == 1) {
        exact_uniform(t, L->n + 1);
        *bits = 0;
        return ET_OK;
    }
    inner = flint_calloc(L->n, sizeof *inner);
    known = flint_calloc(L->n, sizeof *known);
    m = _arb_vec_init((slong)L->n);
    a = _arb_vec_init((slong)L->n);
    status = decide(inner, known, m, a, L, bits);
    if (status == ET_OK) {
        t[0] = 0;
        memcpy(t + 1, inner, (L->n - 1) * sizeof *t);
        t[L->n] = 1;
    }
    _arb_vec_clear(m, (slong)L->n);
    _arb_vec_clear(a, (slong)L->n);
    flint_free(inner);
    flint_free(known);
    return status;
}
