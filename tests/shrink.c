/* shrink: passes over the failing sequence of draws, repeated until none of them helps. */
#include "shrink.h"
#include <string.h>
#include <time.h>

enum { FAR = 24 };                       /* pairs of draws are looked at up to this distance */

typedef struct { uint64_t v[GEN_DRAWS]; size_t n; } values;
static values trial;                     /* the candidate under construction */
static clock_t began;

static bool spent(const shrinker *s)
{
    return s->calls == 0 || (double)(clock() - began) > s->seconds * CLOCKS_PER_SEC;
}

static void copy(const shrinker *s)
{
    trial.n = s->nbest;
    for (size_t i = 0; i < s->nbest; i++)
        trial.v[i] = s->best[i].value;
}

static bool smaller(const shrinker *s, const gen *g)
{
    if (g->ndraws != s->nbest)
        return g->ndraws < s->nbest;
    for (size_t i = 0; i < g->ndraws; i++)
        if (g->draws[i].value != s->best[i].value)
            return g->draws[i].value < s->best[i].value;
    return false;
}

static void keep(shrinker *s, const gen *g)
{
    memcpy(s->best, g->draws, g->ndraws * sizeof g->draws[0]);
    memcpy(s->spans, g->spans, g->nspans * sizeof g->spans[0]);
    s->nbest = g->ndraws;
    s->nspans = g->nspans;
}

/* Run the candidate; keep it if it fails and is smaller. */
static bool attempt(shrinker *s)
{
    gen *g = s->trial;

    if (spent(s))
        return false;
    s->calls--;
    gen_from_values(g, trial.v, trial.n);
    if (!s->fails(s->context, g) || !smaller(s, g))
        return false;
    keep(s, g);
    return true;
}

static void delete(size_t from, size_t to)
{
    memmove(trial.v + from, trial.v + to, (trial.n - to) * sizeof trial.v[0]);
    trial.n -= to - from;
}

static bool cut_all(shrinker *s, size_t k)
{
    bool any = false;

    for (size_t i = s->nbest; i-- > 0;) {
        if (i + k > s->nbest)
            continue;
        copy(s);
        delete(i, i + k);
        any |= attempt(s);
    }
    return any;
}

static bool cut_spans(shrinker *s)
{
    bool any = false;

    for (size_t i = s->nspans; i-- > 0;) {
        if (i >= s->nspans || s->spans[i].to > s->nbest)
            continue;
        copy(s);
        delete(s->spans[i].from, s->spans[i].to);
        any |= attempt(s);
    }
    return any;
}

static bool delete_draws(shrinker *s)
{
    bool any = cut_spans(s);

    for (size_t k = s->nbest / 2; k > 8; k /= 2)
        any |= cut_all(s, k);
    for (size_t k = 8; k > 0; k--)
        any |= cut_all(s, k);
    return any;
}

/* A length and what it counts: lower draw j by one; if k draws fewer are then made, take k draws away at each place after it. */
static bool shorten_at(shrinker *s, size_t j, uint64_t by)
{
    const size_t before = s->nbest;
    size_t k;

    copy(s);
    trial.v[j] -= by;
    if (attempt(s))
        return true;
    k = before - (s->trial->ndraws < before ? s->trial->ndraws : before);
    for (size_t i = j + 1; k > 0 && i + k <= s->nbest && !spent(s); i++) {
        copy(s);
        trial.v[j] -= by;
        delete(i, i + k);
        if (attempt(s))
            return true;
    }
    return false;
}

static bool shorten(shrinker *s)
{
    bool any = false;

    for (size_t j = 0; j < s->nbest && !spent(s); j++)
        for (uint64_t by = s->best[j].value / 2; j < s->nbest && by > 0;)
            if (by <= s->best[j].value && shorten_at(s, j, by))
                any = true;
            else
                by = by > s->best[j].value && by > 1 ? s->best[j].value : by / 2;
    for (size_t j = 0; j < s->nbest && !spent(s); j++)
        while (j < s->nbest && s->best[j].value > 0 && shorten_at(s, j, 1))
            any = true;
    return any;
}

/* As above where the number of draws does not tell: lower a draw, and take k draws away after it. */
static bool lower_and_cut(shrinker *s)
{
    bool any = false;

    for (size_t k = 1; k <= 6; k++)
        for (size_t i = s->nbest; i-- > 1 && !spent(s);)
            for (size_t j = i; j-- > 0 && (i - j <= FAR || j < 4);) {
                if (i + k > s->nbest || s->best[j].value == 0)
                    continue;
                copy(s);
                trial.v[j]--;
                delete(i, i + k);
                any |= attempt(s);
            }
    return any;
}

static bool clear(shrinker *s, size_t from, size_t to)
{
    bool work = false;

    copy(s);
    for (size_t i = from; i < to && i < trial.n; i++) {
        work |= trial.v[i] != 0;
        trial.v[i] = 0;
    }
    return work && attempt(s);
}

static bool zero_spans(shrinker *s)
{
    bool any = false;

    for (size_t i = s->nspans; i-- > 0;)
        if (i < s->nspans)
            any |= clear(s, s->spans[i].from, s->spans[i].to);
    for (size_t k = s->nbest; k > 0; k /= 2)
        for (size_t i = 0; i < s->nbest; i += k)
            any |= clear(s, i, i + k);
    return any;
}

/* One draw to v. */
static bool put(shrinker *s, size_t i, uint64_t v)
{
    if (i >= s->nbest || v >= s->best[i].value)
        return false;
    copy(s);
    trial.v[i] = v;
    return attempt(s);
}

/* The smallest value by bisection, as if failing were monotone; then the few ways in which it often is not. */
static bool lower(shrinker *s, size_t i)
{
    bool any = false;
    uint64_t lo = 0;

    for (uint64_t v = 0; v < 8 && i < s->nbest && v < s->best[i].value; v++)
        if (put(s, i, v))
            return true;
    while (i < s->nbest && lo < s->best[i].value) {
        const uint64_t mid = lo + (s->best[i].value - lo) / 2;
        if (put(s, i, mid))
            any = true;
        else
            lo = mid + 1;
    }
    for (unsigned bit = 64; bit-- > 0 && i < s->nbest;)
        if (s->best[i].value >> bit & 1)
            any |= put(s, i, s->best[i].value - (UINT64_C(1) << bit));
    for (uint64_t d = 2; d < 9 && i < s->nbest; d++)
        if (s->best[i].value >= d)
            any |= put(s, i, s->best[i].value - d);
    return any;
}

static bool lower_all(shrinker *s)
{
    bool any = false;

    for (size_t i = 0; i < s->nbest && !spent(s); i++)
        any |= lower(s, i);
    return any;
}

/* Two draws lowered by the same amount: equal values, and differences that matter. */
static bool lower_both(shrinker *s, size_t i, size_t j)
{
    bool any = false;
    const uint64_t least = s->best[i].value < s->best[j].value ? s->best[i].value : s->best[j].value;

    for (uint64_t by = least; by > 0;) {
        if (j >= s->nbest || s->best[i].value < by || s->best[j].value < by) {
            by /= 2;
            continue;
        }
        copy(s);
        trial.v[i] -= by;
        trial.v[j] -= by;
        if (attempt(s))
            any = true;
        else
            by /= 2;
    }
    return any;
}

/* Move an amount from an earlier draw to a later one: what matters is their sum. */
static bool move(shrinker *s, size_t i, size_t j)
{
    bool any = false;

    for (uint64_t by = s->best[i].value; by > 0;) {
        if (j >= s->nbest || s->best[i].value < by || s->best[j].max - s->best[j].value < by) {
            by /= 2;
            continue;
        }
        copy(s);
        trial.v[i] -= by;
        trial.v[j] += by;
        if (attempt(s))
            any = true;
        else
            by /= 2;
    }
    return any;
}

/* An earlier draw to 0 or one less, a later one as large as it gets: factors of one product. */
static bool trade(shrinker *s, size_t i, size_t j)
{
    for (unsigned less = 0; less < 2; less++) {
        if (j >= s->nbest || s->best[i].value == 0)
            return false;
        copy(s);
        trial.v[i] = less ? trial.v[i] - 1 : 0;
        trial.v[j] = UINT64_MAX;
        if (attempt(s))
            return true;
    }
    return false;
}

static bool swap(shrinker *s, size_t i, size_t j)
{
    uint64_t t;

    if (j >= s->nbest || s->best[i].max != s->best[j].max || s->best[i].value <= s->best[j].value)
        return false;
    copy(s);
    t = trial.v[i];
    trial.v[i] = trial.v[j];
    trial.v[j] = t;
    return attempt(s);
}

static bool pairs(shrinker *s)
{
    bool any = false;

    for (size_t d = 1; d <= FAR; d++)
        for (size_t i = 0; i + d < s->nbest && !spent(s); i++) {
            if (s->best[i].value == 0)
                continue;
            any |= swap(s, i, i + d);
            if (i + d < s->nbest && s->best[i].value > 0)
                any |= move(s, i, i + d);
            if (i + d < s->nbest && s->best[i].value > 0)
                any |= lower_both(s, i, i + d);
            if (i + d < s->nbest && s->best[i].value > 0)
                any |= trade(s, i, i + d);
        }
    return any;
}

/* Neighbouring spans of one length, in order. */
static bool order_spans(shrinker *s)
{
    bool any = false;

    for (size_t a = 0; a < s->nspans; a++)
        for (size_t b = 0; b < s->nspans; b++) {
            const span x = s->spans[a], y = s->spans[b];
            const size_t n = x.to - x.from;
            if (x.to != y.from || y.to - y.from != n || y.to > s->nbest || spent(s))
                continue;
            copy(s);
            for (size_t i = 0; i < n; i++) {
                trial.v[x.from + i] = s->best[y.from + i].value;
                trial.v[y.from + i] = s->best[x.from + i].value;
            }
            any |= attempt(s);
        }
    return any;
}

/* One draw of a few kinds to kind v, k draws after it gone; and the draw then next to it unchanged, at its largest, or small. */
static bool to_kind(shrinker *s, size_t i, uint64_t v, size_t k)
{
    const uint64_t small = v == 0 ? 16 : 0;

    for (uint64_t next = 0; next <= small + 1; next++) {
        if (i >= s->nbest || i + 1 + k > s->nbest)
            return false;
        copy(s);
        trial.v[i] = v;
        delete(i + 1, i + 1 + k);
        if (next > 0 && i + 1 < trial.n)
            trial.v[i + 1] = next == small + 1 ? UINT64_MAX : next;
        if (attempt(s))
            return true;
    }
    return false;
}

/* Another kind may need other draws after it, mostly fewer. */
static bool change_kinds(shrinker *s)
{
    bool any = false;

    for (size_t i = s->nbest; i-- > 0 && !spent(s);)
        for (size_t k = 4; k-- > 0;)
            for (uint64_t v = 0; i < s->nbest && s->best[i].max < 16 && v <= s->best[i].max; v++)
                if (v < s->best[i].value || (v > s->best[i].value && k > 0))
                    any |= to_kind(s, i, v, k);
    return any;
}

void shrink(shrinker *s)
{
    bool again = true;

    began = clock();
    while (again && !spent(s)) {
        again = delete_draws(s);
        again |= zero_spans(s);
        again |= shorten(s);
        again |= lower_all(s);
        again |= lower_and_cut(s);
        again |= pairs(s);
        again |= order_spans(s);
        again = again || change_kinds(s);
    }
}
