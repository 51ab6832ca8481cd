/* gen: draws, and the typed generators made of them. */
#include "ascending.h"
#include "source.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

uint64_t gen_mix(uint64_t x)
{
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

static void start(gen *g, origin from)
{
    g->from = from;
    g->pos = g->ndraws = g->nspans = g->depth = 0;
    for (size_t i = 0; i < g->nlabels; i++)
        g->labels[i].here = false;
}

void gen_clear(gen *g)
{
    memset(g, 0, sizeof *g);
}

void gen_from_seed(gen *g, uint64_t seed)
{
    start(g, FROM_SEED);
    g->state = seed;
}

void gen_from_bytes(gen *g, const uint8_t *bytes, size_t n)
{
    start(g, FROM_BYTES);
    g->bytes = bytes;
    g->nbytes = n;
}

void gen_from_values(gen *g, const uint64_t *values, size_t n)
{
    start(g, FROM_VALUES);
    g->values = values;
    g->nvalues = n;
}

static uint64_t random_upto(gen *g, uint64_t max)
{
    const uint64_t r = gen_mix(g->state);

    g->state += 0x9E3779B97F4A7C15u;
    if (max == UINT64_MAX)
        return r;
    if (max > 255 && r >> 60 == 0)       /* the ends of a wide range, each one time in thirty-two */
        return r >> 59 & 1 ? max : 0;
    return r % (max + 1);
}

static uint64_t decode_upto(gen *g, uint64_t max)
{
    uint64_t v = 0;

    for (uint64_t m = max; m > 0; m >>= 8) {
        v = v << 8 | (g->pos < g->nbytes ? g->bytes[g->pos] : 0u);
        g->pos++;
    }
    return max == UINT64_MAX ? v : v % (max + 1);
}

size_t gen_encode(uint8_t bytes[GEN_BYTES], const draw *draws, size_t n)
{
    size_t len = 0;

    for (size_t i = 0; i < n; i++) {
        size_t width = 0;
        for (uint64_t m = draws[i].max; m > 0; m >>= 8)
            width++;
        for (size_t k = width; k-- > 0;)
            bytes[len++] = (uint8_t)(draws[i].value >> (8 * k) & 0xFF);
    }
    return len;
}

uint64_t gen_upto(gen *g, uint64_t max)
{
    uint64_t v = 0;

    if (max == 0 || g->ndraws == GEN_DRAWS)
        return 0;
    if (g->from == FROM_SEED)
        v = random_upto(g, max);
    else if (g->from == FROM_BYTES)
        v = decode_upto(g, max);
    else if (g->ndraws < g->nvalues)
        v = g->values[g->ndraws] < max ? g->values[g->ndraws] : max;
    g->draws[g->ndraws].value = v;
    g->draws[g->ndraws].max = max;
    g->ndraws++;
    if (g->show && g->show_draws)
        printf("  draw %zu: %llu of %llu\n", g->ndraws - 1, (unsigned long long)v, (unsigned long long)max);
    return v;
}

uint64_t gen_between(gen *g, uint64_t lo, uint64_t hi)
{
    return lo + gen_upto(g, hi - lo);
}

bool gen_chance(gen *g, unsigned in)
{
    return in > 0 && gen_upto(g, in - 1) == in - 1;
}

/* Spans tell the shrinker which draws make one thing. */
static size_t begin(gen *g)
{
    return g->ndraws;
}

static void end(gen *g, size_t from)
{
    if (g->nspans < GEN_SPANS && g->ndraws > from + 1) {
        g->spans[g->nspans].from = from;
        g->spans[g->nspans].to = g->ndraws;
        g->nspans++;
    }
}

/* Draws that are not recorded: what comes of them is. */
static size_t unrecorded(gen *g, size_t max)
{
    const uint64_t r = gen_mix(g->state);

    g->state += 0x9E3779B97F4A7C15u;
    return (size_t)(r % ((uint64_t)max + 1));
}

/* Put m bytes into the n at `at`, in the place of `gone` of them; the length then. */
static size_t splice(uint8_t *bytes, size_t n, size_t most, size_t at, size_t gone, const char *put, size_t m)
{
    m = m < most - n + gone ? m : most - n + gone;
    memmove(bytes + at + m, bytes + at + gone, n - at - gone);
    if (m > 0)
        memcpy(bytes + at, put, m);
    return n - gone + m;
}

/* One change: a byte another, a piece of another sample put in, a piece taken out or said twice, the end cut off. */
static size_t alter(gen *g, uint8_t *bytes, size_t n, size_t most, const sample *from)
{
    const size_t at = unrecorded(g, n), kind = unrecorded(g, 5), rest = n - at, few = unrecorded(g, 15), gone = rest < few ? rest : few;
    char piece[64], byte = (char)unrecorded(g, 255);

    if (kind == 0 && rest > 0) {
        bytes[at] = (uint8_t)byte;
    } else if (kind == 1) {
        n = splice(bytes, n, most, at, 0, &byte, 1);
    } else if (kind == 2 && from->size > 0) {
        const size_t k = unrecorded(g, from->size - 1), m = from->size - k < sizeof piece ? from->size - k : sizeof piece;
        n = splice(bytes, n, most, at, gone, from->bytes + k, unrecorded(g, m));
    } else if (kind == 3) {
        n = splice(bytes, n, most, at, gone, "", 0);
    } else if (kind == 4 && gone > 0) {
        memcpy(piece, bytes + at, gone);
        n = splice(bytes, n, most, at, 0, piece, gone);
    } else if (kind == 5 && unrecorded(g, 3) == 0) {
        n = at;
    }
    return n;
}

static size_t altered_sample(gen *g, uint8_t *bytes, size_t most, const sample *samples)
{
    size_t count = 0, n;

    while (samples[count].bytes)
        count++;
    if (count == 0)
        return 0;
    const sample first = samples[unrecorded(g, count - 1)];
    n = splice(bytes, 0, most, 0, 0, first.bytes, first.size);
    for (size_t changes = unrecorded(g, 6); changes > 0; changes--)
        n = alter(g, bytes, n, most, &samples[unrecorded(g, count - 1)]);
    return n;
}

size_t gen_rest(gen *g, uint8_t *bytes, size_t most, const sample *samples)
{
    size_t n = 0;

    most = most < GEN_DRAWS - g->ndraws ? most : GEN_DRAWS - g->ndraws;
    if (g->from == FROM_SEED)
        n = altered_sample(g, bytes, most, samples);
    else if (g->from == FROM_BYTES)
        n = g->pos < g->nbytes ? g->nbytes - g->pos : 0;
    else
        n = g->ndraws < g->nvalues ? g->nvalues - g->ndraws : 0;
    n = n < most ? n : most;
    for (size_t i = 0; i < n; i++) {
        if (g->from == FROM_BYTES)
            bytes[i] = g->bytes[g->pos++];
        else if (g->from == FROM_VALUES)
            bytes[i] = (uint8_t)(g->values[g->ndraws] < 255 ? g->values[g->ndraws] : 255);
        g->draws[g->ndraws++] = (draw){ bytes[i], 255 };
    }
    return n;
}

static double within(double x, double lo, double hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static double part(double lo, double hi, uint64_t k, uint64_t n)
{
    const double t = (double)k / (double)n;

    if (k == 0 || k == n)
        return k == 0 ? lo : hi;
    return within(isfinite(hi - lo) ? lo + (hi - lo) * t : lo * (1 - t) + hi * t, lo, hi);
}

/* Sixteenths half of the time, then finer fractions, then neighbours of the ends. */
double gen_real(gen *g, double lo, double hi)
{
    const size_t from = begin(g);
    const uint64_t kind = gen_upto(g, 7);
    double x;

    if (kind < 4)
        x = part(lo, hi, gen_upto(g, 16), 16);
    else if (kind < 6)
        x = part(lo, hi, gen_upto(g, UINT64_C(1) << 20), UINT64_C(1) << 20);
    else if (kind == 6)
        x = part(lo, hi, gen_upto(g, UINT64_C(1) << 53), UINT64_C(1) << 53);
    else {
        const bool top = gen_upto(g, 1) == 1;
        x = top ? hi : lo;
        for (uint64_t n = gen_upto(g, 3); n > 0; n--)
            x = nextafter(x, top ? lo : hi);
    }
    end(g, from);
    return x;
}

enum {
    KNOTS_UNIFORM, KNOTS_REPEATED, KNOTS_FULL, KNOTS_ULP, KNOTS_TINY, PARAMETER_LEFT, PARAMETER_RIGHT, PARAMETER_KNOT, PARAMETER_NEAR,
    POINTS_COINCIDENT, POINTS_CHORD, POINTS_ULP, POINTS_SMALL, POINTS_LARGE
};
const char *const gen_standard[] = {
    "knots: uniform", "knots: repeated", "knots: full multiplicity", "knots: one ulp apart", "knots: a span below 2^-40", "parameter: left end",
    "parameter: right end", "parameter: a knot inside", "parameter: one ulp from a knot", "points: coincident", "points: on a chord",
    "points: one ulp apart", "points: scale 2^-100", "points: scale 2^100", NULL };

static void standard(gen *g, int which, bool so)
{
    if (so)
        gen_label(g, gen_standard[which]);
}

static double inner_knot(gen *g, const double *u, size_t first, size_t i)
{
    const uint64_t kind = gen_upto(g, 7);
    const double old = i > first ? u[first + gen_upto(g, i - first - 1)] : 0.5;

    if (kind < 3)
        return (double)gen_between(g, 1, 15) / 16;
    if (kind == 3)
        return old;
    if (kind == 4)
        return nextafter(old, gen_upto(g, 1) ? 0 : 1);
    if (kind == 5)                       /* a tiny span at an end */
        return gen_upto(g, 1) ? 1 - 0x1p-50 : 0x1p-50;
    return (double)gen_between(g, 1, (UINT64_C(1) << 20) - 1) / 0x1p20;
}

/* No interior knot more than p times (the curve stays continuous), all strictly inside (0,1); false when there is no room. */
static bool spread(double *u, size_t first, size_t last, size_t p)
{
    const size_t most = p > 0 ? p : 1;

    for (size_t i = first; i < last; i++) {
        if (i > first && u[i] < u[i - 1])
            u[i] = u[i - 1];
        if (i >= first + most && u[i] <= u[i - most])
            u[i] = nextafter(u[i - most], 2);
        if (!(u[i] > 0 && u[i] < 1))
            return false;
    }
    return true;
}

static void label_knots(gen *g, const double *u, size_t nu, size_t p, bool uniform)
{
    size_t run = 1, most = 1;
    bool close = false, tiny = false;

    for (size_t i = p + 1; i + p < nu; i++) {
        run = u[i] == u[i - 1] && i > p + 1 ? run + 1 : 1;
        most = run > most && i + p + 1 < nu ? run : most;
        close |= u[i] == nextafter(u[i - 1], 2);
        tiny |= u[i] > u[i - 1] && u[i] - u[i - 1] < 0x1p-40;
    }
    standard(g, KNOTS_UNIFORM, uniform);
    standard(g, KNOTS_REPEATED, most > 1);
    standard(g, KNOTS_FULL, most > 1 && most >= p);
    standard(g, KNOTS_ULP, close);
    standard(g, KNOTS_TINY, tiny);
}

void gen_knots(gen *g, double *u, size_t nu, size_t p)
{
    const size_t from = begin(g), first = p + 1, last = nu - p - 1;
    bool uniform = last == first || gen_upto(g, 3) == 0;

    if (!uniform) {
        for (size_t i = first; i < last; i++) {
            const size_t at = begin(g);
            u[i] = inner_knot(g, u, first, i);
            end(g, at);
        }
        ascending(u + first, last - first);
        uniform = !spread(u, first, last, p);
    }
    for (size_t i = first; uniform && i < last; i++)
        u[i] = (double)(i - p) / (double)(last - p);
    for (size_t i = 0; i <= p; i++) {
        u[i] = 0;
        u[nu - 1 - i] = 1;
    }
    end(g, from);
    label_knots(g, u, nu, p, uniform);
}

static void label_parameter(gen *g, const double *u, size_t nu, size_t p, double x)
{
    bool knot = false, near = false;

    for (size_t i = p; i + p < nu; i++) {
        knot |= x == u[i];
        near |= x != u[i] && (nextafter(x, u[i]) == u[i]);
    }
    standard(g, PARAMETER_LEFT, x == u[p]);
    standard(g, PARAMETER_RIGHT, x == u[nu - p - 1]);
    standard(g, PARAMETER_KNOT, knot && x > u[p] && x < u[nu - p - 1]);
    standard(g, PARAMETER_NEAR, near);
}

double gen_parameter(gen *g, const double *u, size_t nu, size_t p)
{
    const size_t from = begin(g);
    const double lo = u[p], hi = u[nu - p - 1];
    const uint64_t kind = gen_upto(g, 7);
    double x = lo;

    if (kind == 1)
        x = hi;
    else if (kind > 1 && kind < 6) {
        x = u[gen_between(g, p, nu - p - 1)];
        if (kind > 3)
            x = nextafter(x, kind == 4 ? hi : lo);
    } else if (kind > 5)
        x = gen_real(g, lo, hi);
    end(g, from);
    x = within(x, lo, hi);
    label_parameter(g, u, nu, p, x);
    return x;
}

static double coordinate(gen *g, double scale)
{
    const double x = gen_real(g, 0, 1);

    return gen_upto(g, 1) ? -x * scale : x * scale;
}

static void one_point(gen *g, double *xyz, size_t i, double scale)
{
    const uint64_t kind = i > 0 ? gen_upto(g, 9) : 0;
    double *x = xyz + 3 * i;

    if (kind < 7) {
        for (size_t c = 0; c < 3; c++)
            x[c] = coordinate(g, scale);
        return;
    }
    const double *a = xyz + 3 * gen_upto(g, i - 1), *b = xyz + 3 * gen_upto(g, i - 1);
    const double t = kind == 8 ? gen_real(g, 0, 1) : 0;
    standard(g, kind == 7 ? POINTS_COINCIDENT : kind == 8 ? POINTS_CHORD : POINTS_ULP, true);
    for (size_t c = 0; c < 3; c++)       /* 7: coincident; 8: on a chord; 9: a neighbour */
        x[c] = kind == 8 ? a[c] + t * (b[c] - a[c]) : a[c];
    if (kind == 9)
        x[0] = nextafter(x[0], gen_upto(g, 1) ? -2 * scale : 2 * scale);
}

void gen_points(gen *g, double *xyz, size_t n)
{
    static const double scales[8] = { 1, 1, 1, 16, 0x1p-20, 0x1p20, 0x1p-100, 0x1p100 };
    const size_t from = begin(g);
    const double scale = scales[gen_upto(g, 7)];

    standard(g, POINTS_SMALL, scale == 0x1p-100);
    standard(g, POINTS_LARGE, scale == 0x1p100);
    for (size_t i = 0; i < n; i++) {
        const size_t at = begin(g);
        one_point(g, xyz, i, scale);
        end(g, at);
    }
    end(g, from);
}

void gen_label(gen *g, const char *text)
{
    size_t i = 0;

    while (i < g->nlabels && strncmp(g->labels[i].text, text, GEN_LABEL_SIZE - 1) != 0)
        i++;
    if (i == GEN_LABELS)
        return;
    if (i == g->nlabels) {
        g->nlabels++;
        memset(&g->labels[i], 0, sizeof g->labels[i]);
        strncpy(g->labels[i].text, text, GEN_LABEL_SIZE - 1);
    }
    g->labels[i].cases += !g->labels[i].here;
    g->labels[i].here = true;
}

bool gen_check(gen *g, bool ok, const char *format, ...)
{
    if (!ok && g->show) {
        va_list args;
        fputs("  not so: ", stdout);
        va_start(args, format);
        vprintf(format, args);
        va_end(args);
        putchar('\n');
    }
    return ok;
}

void gen_note(gen *g, const char *format, ...)
{
    if (g->show) {
        va_list args;
        fputs("  ", stdout);
        va_start(args, format);
        vprintf(format, args);
        va_end(args);
        putchar('\n');
    }
}
