/* conform/reply: lines written by printf and read back; curves and surfaces put and got; hellos of any order. */
#include "etalon/conform/reply.h"
#include "etalon/conform/request.h"
#include "golden.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 1 << 12, NUMBERS = 20 };

static double any_real(gen *g)
{
    static const double hard[] = { 0.0, -0.0, 1.0, INFINITY, -INFINITY, NAN, 0x1p-1074, 0x1.fffffffffffffp1023, 0.1, 3.0 };
    uint64_t bits;
    double x;

    if (gen_upto(g, 2) < 2)
        return hard[gen_upto(g, sizeof hard / sizeof *hard - 1)];
    bits = gen_upto(g, UINT64_MAX);
    memcpy(&x, &bits, sizeof x);
    return isnan(x) ? NAN : x;
}

static bool same_real(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

static size_t draw_numbers(gen *g, double x[NUMBERS])
{
    const size_t n = (size_t)gen_upto(g, NUMBERS);

    for (size_t i = 0; i < n; i++)
        x[i] = any_real(g);
    return n;
}

/* A reply of any kind. */
static bool draw(gen *g, et_reply *r)
{
    static const char *const reasons[] = { "", "no", "outside the domain", "1 2 3" };
    double x[NUMBERS];

    memset(r, 0, sizeof *r);
    r->kind = (et_reply_kind)gen_upto(g, 2);
    if (r->kind != ET_REPLY_OK) {
        strcpy(r->reason, reasons[gen_upto(g, 3)]);
        return true;
    }
    const size_t n = draw_numbers(g, x);
    return gen_check(g, et_reply_put(r, x, n) == ET_OK, "%zu numbers are put", n);
}

static bool same_values(const et_reply *a, const et_reply *b)
{
    if (a->kind != b->kind || a->count != b->count)
        return false;
    for (size_t i = 0; i < a->count; i++)
        if (!same_real(a->x[i], b->x[i]))
            return false;
    return true;
}

/* ---- lines ---- */

static const char *const kinds[] = { "ok", "refused", "unsupported" };

static void write_line(gen *g, char *line, uint64_t id, const et_reply *r, bool loose)
{
    static const char *const ways[] = { "%a", "%A", "%.17g", "%.20e" };
    size_t at = (size_t)snprintf(line, LINE, "%" PRIu64 " %s%s%s", id, kinds[r->kind], r->reason[0] ? " " : "", r->reason);

    for (size_t i = 0; r->kind == ET_REPLY_OK && i < r->count; i++) {
        at += (size_t)snprintf(line + at, LINE - at, "%s", loose && gen_chance(g, 4) ? " \t" : " ");
        if (!loose && isnan(r->x[i]))
            at += (size_t)snprintf(line + at, LINE - at, "nan");
        else
            at += (size_t)snprintf(line + at, LINE - at, ways[loose ? gen_upto(g, 3) : 0], r->x[i]);
    }
    if (loose)
        snprintf(line + at, LINE - at, "%s", gen_chance(g, 2) ? "\r\n" : gen_chance(g, 2) ? " " : "");
}

static uint64_t any_id(gen *g)
{
    return gen_upto(g, 1) ? gen_upto(g, UINT64_C(1) << 53) : gen_upto(g, 9);
}

verdict prop_reply_parse(gen *g)
{
    char line[LINE];
    et_reply r, read, was;
    et_message message = { "" };
    uint64_t id = any_id(g), got = 7;

    if (!draw(g, &r))
        return FAIL;
    write_line(g, line, id, &r, true);
    bool ok = gen_check(g, et_reply_parse(&read, &got, line, &message) == ET_OK, "'%s' is read: %s", line, message.text);
    if (ok) {
        ok = gen_check(g, got == id && same_values(&read, &r), "'%s' is read right", line);
        ok = ok && gen_check(g, strcmp(read.reason, r.reason) == 0, "the reason '%s', not '%s'", read.reason, r.reason);
        et_reply_free(&read);
    }
    memset(&read, 7, sizeof read);
    was = read;
    got = 7;
    snprintf(line, sizeof line, "%" PRIu64 " ok 1 2 %s", id, gen_upto(g, 1) ? "x" : "0x");
    ok = ok && gen_check(g, et_reply_parse(&read, &got, line, &message) == ET_EFORMAT && message.text[0] && got == 7
                         && memcmp(&read, &was, sizeof read) == 0,
                         "'%s' is none, and nothing changes", line);
    ok = ok && gen_check(g, et_reply_parse(&read, &got, "", NULL) == ET_EFORMAT && got == 7, "an empty line");
    et_reply_free(&r);
    return ok ? PASS : FAIL;
}

/* A reason of any bytes fits where it is kept, and does nothing to a terminal. */
verdict prop_reply_parse_reason(gen *g)
{
    char line[400];
    et_reply r;
    uint64_t id;
    size_t at = (size_t)snprintf(line, sizeof line, "3 refused ");
    const size_t n = (size_t)gen_upto(g, 300);

    for (size_t i = 0; i < n; i++) {
        char c = (char)(1 + gen_upto(g, 254));
        line[at++] = c == '\n' || c == '\r' ? ' ' : c;
    }
    line[at] = '\0';
    if (!gen_check(g, et_reply_parse(&r, &id, line, NULL) == ET_OK, "read"))
        return FAIL;
    bool ok = gen_check(g, memchr(r.reason, 0, sizeof r.reason) != NULL, "the reason ends");
    for (const char *c = r.reason; ok && *c; c++)
        ok = gen_check(g, (unsigned char)*c >= ' ' && *c != 127, "byte %d of the reason", (int)(unsigned char)*c);
    et_reply_free(&r);
    return ok ? PASS : FAIL;
}

verdict prop_reply_print(gen *g)
{
    char line[LINE], *printed = NULL;
    const uint64_t id = any_id(g);
    et_reply r;

    if (!draw(g, &r))
        return FAIL;
    write_line(g, line, id, &r, false);
    bool ok = gen_check(g, et_reply_print(&printed, id, &r) == ET_OK && strcmp(printed, line) == 0, "'%s', not '%s'", printed ? printed : "", line);
    free(printed);
    if (r.kind != ET_REPLY_OK) {
        strcpy(r.reason, " two\nlines\t");
        printed = NULL;
        snprintf(line, sizeof line, "%" PRIu64 " %s two lines", id, kinds[r.kind]);
        ok = ok && gen_check(g, et_reply_print(&printed, id, &r) == ET_OK && strcmp(printed, line) == 0, "one line: '%s'", printed ? printed : "");
        free(printed);
    }
    et_reply_free(&r);
    return ok ? PASS : FAIL;
}

/* ---- storage ---- */

verdict prop_reply_free(gen *g)
{
    et_reply r;

    if (!draw(g, &r))
        return FAIL;
    et_reply_free(&r);
    bool ok = gen_check(g, !r.x && r.count == 0 && r.kind == ET_REPLY_OK && !r.reason[0], "zeroed");
    et_reply_free(&r);
    return ok ? PASS : FAIL;
}

verdict prop_reply_put(gen *g)
{
    double x[NUMBERS], y[NUMBERS];
    et_reply r, was;

    memset(&r, 0, sizeof r);
    const size_t n = draw_numbers(g, x), m = draw_numbers(g, y);
    bool ok = gen_check(g, et_reply_put(&r, x, n) == ET_OK && et_reply_put(&r, y, m) == ET_OK && r.count == n + m, "%zu and %zu numbers", n, m);
    for (size_t i = 0; ok && i < n + m; i++)
        ok = gen_check(g, same_real(r.x[i], i < n ? x[i] : y[i - n]), "number %zu", i);
    was = r;
    ok = ok && gen_check(g, et_reply_put(&r, NULL, 0) == ET_OK && memcmp(&r, &was, sizeof r) == 0, "nothing");
    ok = ok && gen_check(g, et_reply_put(&r, x, SIZE_MAX) == ET_ENOMEM && et_reply_put(&r, x, SIZE_MAX / 8 + 1) == ET_ENOMEM
                         && memcmp(&r, &was, sizeof r) == 0,
                         "more than there is");
    et_reply_free(&r);
    return ok ? PASS : FAIL;
}

static bool draw_curve(gen *g, et_curve *c)
{
    const size_t p = (size_t)gen_upto(g, 3), n = p + 1 + (size_t)gen_upto(g, 4);

    if (et_curve_new(c, p, n, gen_upto(g, 1) != 0) != ET_OK)
        return false;
    for (size_t i = 0; i < n + p + 1; i++)
        c->u[i] = any_real(g);
    for (size_t i = 0; i < n; i++)
        c->points[i] = (et_vec3){ any_real(g), any_real(g), any_real(g) };
    for (size_t i = 0; c->weights && i < n; i++)
        c->weights[i] = any_real(g);
    return true;
}

static bool same_points(const et_vec3 *a, const et_vec3 *b, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!same_real(a[i].x, b[i].x) || !same_real(a[i].y, b[i].y) || !same_real(a[i].z, b[i].z))
            return false;
    return true;
}

static bool same_reals(const double *a, const double *b, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!same_real(a[i], b[i]))
            return false;
    return true;
}

static bool same_curve(const et_curve *a, const et_curve *b)
{
    return a->p == b->p && a->n == b->n && !a->weights == !b->weights && same_reals(a->u, b->u, a->n + a->p + 1)
        && same_points(a->points, b->points, a->n)
           && (!a->weights || same_reals(a->weights, b->weights, a->n));
}

/* The numbers one by one, as the protocol says. */
verdict prop_reply_put_curve(gen *g)
{
    et_curve c;
    et_reply r;
    const double first = 0x1p-3;
    size_t k = 1;

    memset(&r, 0, sizeof r);
    if (!draw_curve(g, &c))
        return FAIL;
    bool ok = gen_check(g, et_reply_put(&r, &first, 1) == ET_OK && et_reply_put_curve(&r, &c) == ET_OK, "put");
    const size_t nu = c.n + c.p + 1, nw = c.weights ? c.n : 0;
    ok = ok && gen_check(g, r.count == 1 + 4 + nu + 3 * c.n + nw && r.x[0] == first, "%zu numbers", r.count);
    ok = ok && gen_check(g, r.x[k] == (double)c.p && r.x[k + 1] == (double)nu && same_reals(r.x + k + 2, c.u, nu), "degree and knots");
    k += 2 + nu;
    ok = ok && gen_check(g, r.x[k] == (double)c.n && r.x[k + 3 * c.n + 1] == (double)nw, "counts of points and weights");
    for (size_t i = 0; ok && i < c.n; i++)
        ok = gen_check(g, same_real(r.x[k + 1 + 3 * i], c.points[i].x) && same_real(r.x[k + 2 + 3 * i], c.points[i].y)
                       && same_real(r.x[k + 3 + 3 * i], c.points[i].z),
                       "point %zu", i);
    ok = ok && gen_check(g, nw == 0 || same_reals(r.x + r.count - nw, c.weights, nw), "weights");
    et_curve_free(&c);
    et_reply_free(&r);
    return ok ? PASS : FAIL;
}

verdict prop_reply_get_curve(gen *g)
{
    et_curve c, got, was;
    et_reply r;
    size_t at = 0;

    memset(&r, 0, sizeof r);
    memset(&got, 7, sizeof got);
    was = got;
    if (!draw_curve(g, &c))
        return FAIL;
    bool ok = et_reply_put_curve(&r, &c) == ET_OK && et_reply_put_curve(&r, &c) == ET_OK;
    for (size_t which = 1; ok && which <= 2; which++) {
        ok = gen_check(g, et_reply_get_curve(&got, &at, &r) == ET_OK && at == which * r.count / 2 && same_curve(&got, &c), "what was put is got");
        if (ok)
            et_curve_free(&got);
        got = was;
    }
    ok = ok && gen_check(g, et_reply_get_curve(&got, &at, &r) == ET_EFORMAT && at == r.count, "there is no third");
    /* One count altered, or one number less. */
    const size_t nu = c.n + c.p + 1, counts[] = { 0, 1, 2 + nu, 3 + nu + 3 * c.n }, k = (size_t)gen_upto(g, 4);
    static const double wrong[] = { -1, 0.5, INFINITY, NAN, 0x1p60, 1 };
    at = 0;
    if (ok && k < 4) {
        const double step = wrong[gen_upto(g, 5)];
        r.x[counts[k]] = step == 1 ? r.x[counts[k]] + 1 : step;
    } else {
        r.count = r.count / 2 - 1;
    }
    const bool ones = k == 3 && !c.weights && c.n == 1;          /* a weight more may be the next curve's degree */
    const et_status status = ok ? et_reply_get_curve(&got, &at, &r) : ET_EFORMAT;
    ok = ok && gen_check(g, ones || (status == ET_EFORMAT && at == 0 && memcmp(&got, &was, sizeof got) == 0), "altered at %zu: no curve", k);
    if (status == ET_OK)
        et_curve_free(&got);
    r.kind = ET_REPLY_REFUSED;
    ok = ok && gen_check(g, et_reply_get_curve(&got, &at, &r) == ET_EFORMAT, "a refusal is no curve");
    et_curve_free(&c);
    et_reply_free(&r);
    return ok ? PASS : FAIL;
}

static bool draw_surface(gen *g, et_surface *s)
{
    const size_t p = (size_t)gen_upto(g, 2), q = (size_t)gen_upto(g, 2), nu = p + 1 + (size_t)gen_upto(g, 2), nv = q + 1 + (size_t)gen_upto(g, 2);

    if (et_surface_new(s, p, q, nu, nv, gen_upto(g, 1) != 0) != ET_OK)
        return false;
    for (size_t i = 0; i < nu + p + 1; i++)
        s->u[i] = any_real(g);
    for (size_t i = 0; i < nv + q + 1; i++)
        s->v[i] = any_real(g);
    for (size_t i = 0; i < nu * nv; i++)
        s->points[i] = (et_vec3){ any_real(g), any_real(g), any_real(g) };
    for (size_t i = 0; s->weights && i < nu * nv; i++)
        s->weights[i] = any_real(g);
    return true;
}

static bool same_surface(const et_surface *a, const et_surface *b)
{
    const size_t n = a->nu * a->nv;

    return a->p == b->p && a->q == b->q && a->nu == b->nu && a->nv == b->nv && !a->weights == !b->weights && same_reals(a->u, b->u, a->nu + a->p + 1)
           && same_reals(a->v, b->v, a->nv + a->q + 1) && same_points(a->points, b->points, n) && (!a->weights
                                                                                                   || same_reals(a->weights, b->weights, n));
}

verdict prop_reply_put_surface(gen *g)
{
    et_surface s;
    et_reply r;

    memset(&r, 0, sizeof r);
    if (!draw_surface(g, &s))
        return FAIL;
    const size_t ku = s.nu + s.p + 1, kv = s.nv + s.q + 1, n = s.nu * s.nv, nw = s.weights ? n : 0;
    bool ok = gen_check(g, et_reply_put_surface(&r, &s) == ET_OK && r.count == 6 + ku + kv + 3 * n + nw, "%zu numbers", r.count);
    ok = ok && gen_check(g, r.x[0] == (double)s.p && r.x[1] == (double)s.q && r.x[2] == (double)ku && same_reals(r.x + 3, s.u, ku),
                         "degrees and knots");
    ok = ok && gen_check(g, r.x[3 + ku] == (double)kv && same_reals(r.x + 4 + ku, s.v, kv) && r.x[4 + ku + kv] == (double)n, "knots and points");
    for (size_t i = 0; ok && i < n; i++)
        ok = gen_check(g, same_real(r.x[5 + ku + kv + 3 * i], s.points[i].x) && same_real(r.x[7 + ku + kv + 3 * i], s.points[i].z), "point %zu", i);
    ok = ok && gen_check(g, r.x[5 + ku + kv + 3 * n] == (double)nw && (nw == 0 || same_reals(r.x + r.count - nw, s.weights, nw)), "weights");
    et_surface_free(&s);
    et_reply_free(&r);
    return ok ? PASS : FAIL;
}

verdict prop_reply_get_surface(gen *g)
{
    et_surface s, got, was;
    et_reply r;
    size_t at = 0;

    memset(&r, 0, sizeof r);
    memset(&got, 7, sizeof got);
    was = got;
    if (!draw_surface(g, &s))
        return FAIL;
    bool ok = et_reply_put_surface(&r, &s) == ET_OK && et_reply_put_surface(&r, &s) == ET_OK;
    for (size_t which = 1; ok && which <= 2; which++) {
        ok = gen_check(g, et_reply_get_surface(&got, &at, &r) == ET_OK && at == which * r.count / 2 && same_surface(&got, &s), "what was put is got");
        if (ok)
            et_surface_free(&got);
        got = was;
    }
    const size_t ku = s.nu + s.p + 1, kv = s.nv + s.q + 1, counts[] = { 0, 1, 2, 3 + ku, 4 + ku + kv }, k = (size_t)gen_upto(g, 5);
    static const double wrong[] = { -1, 0.5, INFINITY, NAN, 0x1p60, 1 };
    at = 0;
    if (k < 5) {
        const double step = wrong[gen_upto(g, 5)];
        r.x[counts[k]] = step == 1 ? r.x[counts[k]] + 1 : step;
    } else {
        r.count = r.count / 2 - 1;
    }
    /* A degree may be one more where the number of points happens to fit: then what is got is a surface. */
    const et_status status = ok ? et_reply_get_surface(&got, &at, &r) : ET_EFORMAT;
    ok = ok && gen_check(g, status == ET_EFORMAT ? at == 0 && memcmp(&got, &was, sizeof got) == 0 : got.nu * got.nv == s.nu * s.nv && got.nu > got.p
                         && got.nv > got.q,
                         "altered at %zu", k);
    ok = ok && gen_check(g, status == ET_EFORMAT || k < 2, "altered at %zu: no surface", k);
    if (status == ET_OK)
        et_surface_free(&got);
    r.kind = ET_REPLY_UNSUPPORTED;
    ok = ok && gen_check(g, et_reply_get_surface(&got, &at, &r) == ET_EFORMAT, "what is unsupported is no surface");
    et_surface_free(&s);
    et_reply_free(&r);
    return ok ? PASS : FAIL;
}

verdict prop_reply_same(gen *g)
{
    et_reply a, b;
    double x[NUMBERS];

    memset(&a, 0, sizeof a);
    memset(&b, 0, sizeof b);
    const size_t n = draw_numbers(g, x);
    bool ok = et_reply_put(&a, x, n) == ET_OK && et_reply_put(&b, x, n) == ET_OK;
    ok = ok && gen_check(g, et_reply_same(&a, &b) == 1 && et_reply_same(&a, &a) == 1, "equal ones");
    strcpy(b.reason, "why");
    ok = ok && gen_check(g, et_reply_same(&a, &b) == 1, "reasons do not count");
    if (ok && n > 0) {
        const size_t at = (size_t)gen_upto(g, n - 1);
        const double old = b.x[at];
        b.x[at] = isnan(old) ? 0 : isfinite(old) && gen_upto(g, 1) ? nextafter(old, HUGE_VAL) : -old;
        ok = gen_check(g, et_reply_same(&a, &b) == 0 && et_reply_same(&b, &a) == 0, "number %zu is %a, not %a", at, b.x[at], old);
        b.x[at] = old;
        b.count--;
        ok = ok && gen_check(g, et_reply_same(&a, &b) == 0, "fewer numbers");
        b.count++;
    }
    b.kind = ET_REPLY_REFUSED;
    ok = ok && gen_check(g, et_reply_same(&a, &b) == 0, "another kind");
    et_reply_free(&a);
    et_reply_free(&b);
    return ok ? PASS : FAIL;
}

/* ---- hello ---- */

typedef struct { char text[4][80]; size_t n; } words;

static void put_word(words *w, const char *text)
{
    if (w->n < 4)
        strcpy(w->text[w->n++], text);
}

/* Words in an order drawn, with what they say. */
verdict prop_reply_hello(gen *g)
{
    static const char *const must[] = { "protocol=1", "name=a", "version=0.1", "ops=span,knots,fold" };
    char line[LINE] = "", word[80];
    const size_t degree = (size_t)gen_upto(g, 30), order = (size_t)gen_upto(g, 9);
    const unsigned sides = (unsigned)gen_upto(g, 7), left_out = (unsigned)gen_upto(g, 4);
    const bool limits = gen_upto(g, 1) != 0, rational = gen_upto(g, 1) != 0;
    words w = { { "" }, 0 };
    et_hello h, was;

    if (limits) {
        snprintf(word, sizeof word, "degree=%zu", degree);
        put_word(&w, word);
        snprintf(word, sizeof word, "order=%zu rational=%d", order, rational);
        put_word(&w, word);
    }
    if (sides) {
        snprintf(word, sizeof word, "sides=%s%s%s colour=blue", sides & 1 ? "any," : "", sides & 2 ? "left," : "", sides & 4 ? "right" : "");
        put_word(&w, word);
    }
    const size_t turn = (size_t)gen_upto(g, 3), gap = (size_t)gen_upto(g, 4);
    for (size_t k = 0; k < 4; k++) {
        if (k == gap)
            for (size_t i = 0; i < w.n; i++)
                strcat(strcat(line, w.text[i]), " ");
        if ((k + turn) % 4 != left_out)
            strcat(strcat(line, must[(k + turn) % 4]), k == 3 ? "" : "  ");
    }
    memset(&h, 7, sizeof h);
    was = h;
    const et_status status = et_reply_hello(&h, line, NULL);
    if (left_out < 4)
        return gen_check(g, status == ET_EFORMAT && memcmp(&h, &was, sizeof h) == 0, "'%s' lacks %s", line, must[left_out]) ? PASS : FAIL;
    bool ok = gen_check(g, status == ET_OK && strcmp(h.name, "a") == 0 && strcmp(h.version, "0.1") == 0 && h.unknown == 1, "'%s' is read", line);
    for (int op = 0; ok && op < ET_OPS; op++)
        ok = gen_check(g, h.op[op] == (op == ET_OP_SPAN || op == ET_OP_KNOTS), "operation %d", op);
    const bool told = limits && gap < 4, sided = sides && gap < 4;
    ok = ok && gen_check(g, h.degree == (told ? degree : SIZE_MAX) && h.order == (told ? order : 3) && h.rational == (told && rational),
                         "limits of '%s'", line);
    ok = ok && gen_check(g, h.any == (sided ? (int)(sides & 1) : 1) && h.left == (sided && sides & 2) && h.right == (sided && sides & 4),
                         "sides of '%s'", line);
    return ok && gen_check(g, h.knot_tolerance == 0, "no tolerance") ? PASS : FAIL;
}

/* Long names are cut. */
verdict prop_reply_hello_long(gen *g)
{
    char line[LINE] = "protocol=1 version=1 ops=span name=";
    const size_t n = 1 + (size_t)gen_upto(g, 200), at = strlen(line);
    et_hello h;

    memset(line + at, 'n', n);
    line[at + n] = '\0';
    return gen_check(g, et_reply_hello(&h, line, NULL) == ET_OK && strlen(h.name) == (n < 63 ? n : 63), "a name of %zu bytes", n) ? PASS : FAIL;
}

/* ---- golden rows ---- */

/* The arguments from `first` to before `past` as a line again. */
static char *line_of(const row *r, size_t first, size_t past)
{
    size_t length = 1;

    for (size_t i = first; i < past; i++)
        length += strlen(r->arg[i]) + 1;
    char *line = malloc(length);
    if (line)
        line[0] = '\0';
    for (size_t i = first; line && i < past; i++)
        strcat(strcat(line, i > first ? " " : ""), r->arg[i]);
    return line;
}

static bool read_row(et_status *status, et_reply *reply, uint64_t *id, const row *r, size_t first, size_t past)
{
    char *line = line_of(r, first, past);

    memset(reply, 0, sizeof *reply);
    if (!line)
        return false;
    *status = et_reply_parse(reply, id, line, NULL);
    free(line);
    return true;
}

verdict gold_reply_parse(const row *r)
{
    static const size_t numbers[] = { 0, 1, 2 };
    et_reply reply;
    et_status status;
    uint64_t id;
    bool ok = read_row(&status, &reply, &id, r, 0, r->nargs) && row_is_size(r, 0, (size_t)status);

    if (ok && status == ET_OK) {
        ok = r->nwant == 3 + reply.count && row_is_size(r, 1, (size_t)id) && row_is_size(r, 2, numbers[reply.kind]);
        for (size_t i = 0; ok && i < reply.count; i++)
            ok = row_is(r, 3 + i, reply.x[i]);
    }
    et_reply_free(&reply);
    return ok ? PASS : FAIL;
}

verdict gold_reply_print(const row *r)
{
    char *printed = NULL;
    et_reply reply;
    et_status status;
    uint64_t id;
    bool ok = read_row(&status, &reply, &id, r, 0, r->nargs) && status == ET_OK && et_reply_print(&printed, id, &reply) == ET_OK
        && strlen(printed) == r->nwant;

    for (size_t i = 0; ok && i < r->nwant; i++)
        ok = row_is_size(r, i, (size_t)(unsigned char)printed[i]);
    free(printed);
    et_reply_free(&reply);
    return ok ? PASS : FAIL;
}

verdict gold_reply_same(const row *r)
{
    et_reply a, b;
    et_status status[2];
    uint64_t id;
    size_t bar = 0;

    while (bar < r->nargs && strcmp(r->arg[bar], "|") != 0)
        bar++;
    bool ok = read_row(&status[0], &a, &id, r, 0, bar) && read_row(&status[1], &b, &id, r, bar + 1, r->nargs) && status[0] == ET_OK
        && status[1] == ET_OK
              && row_is_size(r, 0, (size_t)et_reply_same(&a, &b));
    et_reply_free(&a);
    et_reply_free(&b);
    return ok ? PASS : FAIL;
}

verdict gold_reply_hello(const row *r)
{
    char *line = line_of(r, 0, r->nargs);
    et_hello h;
    uint64_t bits[2] = { 0, 0 };
    const et_status status = line ? et_reply_hello(&h, line, NULL) : ET_ENOMEM;
    bool ok = row_is_size(r, 0, (size_t)status);

    free(line);
    if (status != ET_OK)
        return ok ? PASS : FAIL;
    for (int op = 0; op < ET_OPS; op++)
        bits[op / 15] |= (uint64_t)(h.op[op] != 0) << (op % 15);
    /* 2^53 + 1 stands for no limit. */
    ok = ok && r->nwant == 11 && (h.degree == SIZE_MAX ? strcmp(r->want[1], "9007199254740993") == 0 : row_is_size(r, 1, h.degree));
    const int flags[] = { h.rational, h.any, h.right, h.left };
    ok = ok && row_is_size(r, 2, h.order);
    for (size_t k = 0; ok && k < 4; k++)
        ok = row_is_size(r, 3 + k, (size_t)flags[k]);
    return ok && row_is(r, 7, h.knot_tolerance) && row_is_size(r, 8, h.unknown) && row_is_size(r, 9, (size_t)bits[0])
        && row_is_size(r, 10, (size_t)bits[1]) ? PASS : FAIL;
}
