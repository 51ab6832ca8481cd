/* conform/request: lines written by printf and read back; every promise about storage. */
#include "etalon/conform/request.h"
#include "golden.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 1 << 14 };

/* Any double at all; simple ones come often. */
static double any_real(gen *g)
{
    static const double hard[] = { 0.0, -0.0, 1.0, INFINITY, -INFINITY, NAN, 0x1p-1074, -0x1.fffffffffffffp-1023, 0x1p-1022, 0x1.fffffffffffffp1023,
                                   0.1 };
    const uint64_t kind = gen_upto(g, 3);
    uint64_t bits;
    double x;

    if (kind == 0)
        return hard[gen_upto(g, sizeof hard / sizeof *hard - 1)];
    if (kind == 1)
        return gen_real(g, -4, 4);
    bits = gen_upto(g, UINT64_MAX);
    memcpy(&x, &bits, sizeof x);
    return isnan(x) ? NAN : x;
}

static bool same_real(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

static size_t words_of(const et_request_shape *shape)
{
    size_t n = 0;

    while (shape->words[n])
        n++;
    return n;
}

static size_t reals_of(const et_request_shape *shape, size_t count)
{
    return shape->kind == ET_ARG_REAL ? 1 : shape->kind == ET_ARG_REALS ? count : shape->kind == ET_ARG_POINTS ? 3 * count : 0;
}

/* A request of any operation with any arguments. */
static bool draw(gen *g, et_request *r)
{
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    const et_request_shape *shape;
    bool ok = et_request_new(r, op) == ET_OK;

    for (size_t k = 0; ok && (shape = et_request_argument(op, k)) != NULL; k++) {
        double x[36];
        const size_t count = shape->kind == ET_ARG_WORD ? (size_t)gen_upto(g, words_of(shape) - 1)
                             : shape->kind == ET_ARG_COUNT && gen_chance(g, 4) ? (size_t)gen_upto(g, UINT64_C(1) << 53) & SIZE_MAX
                                 : (size_t)gen_upto(g, 12);
        for (size_t i = 0; i < reals_of(shape, count); i++)
            x[i] = any_real(g);
        ok = et_request_set(r, k, count, x) == ET_OK;
    }
    return gen_check(g, ok, "a request of operation %d is made", (int)op);
}

static bool same(const et_request *a, const et_request *b)
{
    const et_request_shape *shape;

    if (a->op != b->op)
        return false;
    for (size_t k = 0; (shape = et_request_argument(a->op, k)) != NULL; k++) {
        if (a->arg[k].count != b->arg[k].count)
            return false;
        for (size_t i = 0; i < reals_of(shape, a->arg[k].count); i++)
            if (!same_real(a->arg[k].x[i], b->arg[k].x[i]))
                return false;
    }
    return true;
}

static bool untouched(const et_request *r, const et_request *was)
{
    return memcmp(r, was, sizeof *r) == 0;
}

/* ---- the table ---- */

verdict prop_request_name(gen *g)
{
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    const char *name = et_request_name(op);
    bool ok = gen_check(g, name && name[0] && strspn(name, "abcdefghijklmnopqrstuvwxyz_") == strlen(name), "operation %d has a name", (int)op);

    for (int other = 0; ok && other < (int)op; other++)
        ok = gen_check(g, strcmp(name, et_request_name((et_request_op)other)) != 0, "%s stands twice", name);
    ok = ok && gen_check(g, !et_request_name(ET_OPS) && !et_request_name((et_request_op)(ET_OPS + 1)), "there is nothing past the last");
    return ok ? PASS : FAIL;
}

verdict prop_request_find(gen *g)
{
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    char name[40];
    bool ok = gen_check(g, et_request_find(et_request_name(op)) == op, "%s is found", et_request_name(op));
    const size_t length = strlen(strcpy(name, et_request_name(op))), at = (size_t)gen_upto(g, length - 1);

    name[at] = (char)(name[at] + 1 + (char)gen_upto(g, 2));
    bool known = false;
    for (int k = 0; k < ET_OPS; k++)
        known = known || strcmp(name, et_request_name((et_request_op)k)) == 0;
    ok = ok && gen_check(g, known || et_request_find(name) == ET_OPS, "%s is none", name);
    strcpy(name, et_request_name(op));
    strcat(name, "s");
    ok = ok && gen_check(g, et_request_find(name) == ET_OPS || strcmp(name, "parameters") == 0, "%s is none", name);
    name[length - 1] = '\0';
    ok = ok && gen_check(g, et_request_find(name) == ET_OPS && et_request_find("") == ET_OPS, "'%s' is none", name);
    return ok ? PASS : FAIL;
}

verdict prop_request_argument(gen *g)
{
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    const et_request_shape *shape, *other;
    bool ok = true;
    size_t n = 0;

    for (; ok && (shape = et_request_argument(op, n)) != NULL; n++) {
        ok = gen_check(g, shape->name && shape->name[0] && (shape->kind == ET_ARG_WORD) == (shape->words != NULL), "argument %zu", n);
        for (size_t k = 0; ok && k < n; k++) {
            other = et_request_argument(op, k);
            ok = gen_check(g, strcmp(shape->name, other->name) != 0, "%s: %s twice", et_request_name(op), shape->name);
        }
    }
    ok = ok && gen_check(g, n >= 2 && n < ET_REQUEST_ARGS, "%s has %zu arguments", et_request_name(op), n);
    const size_t past = n + (size_t)gen_upto(g, 20);
    ok = ok && gen_check(g, !et_request_argument(op, past) && !et_request_argument(op, SIZE_MAX) && !et_request_argument(ET_OPS, 0), "past the last");
    return ok ? PASS : FAIL;
}

/* ---- storage ---- */

verdict prop_request_new(gen *g)
{
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    const et_request_shape *shape;
    et_request r, was;

    memset(&r, 7, sizeof r);
    was = r;
    bool ok = gen_check(g, et_request_new(&r, ET_OPS) == ET_EINVAL && untouched(&r, &was), "no operation");
    if (!ok || !gen_check(g, et_request_new(&r, op) == ET_OK && r.op == op, "made"))
        return FAIL;
    for (size_t k = 0; ok && k < ET_REQUEST_ARGS; k++) {
        shape = et_request_argument(op, k);
        ok = gen_check(g, r.arg[k].count == 0, "counts are 0");
        if (shape && shape->kind == ET_ARG_REAL)
            ok = ok && gen_check(g, r.arg[k].x && r.arg[k].x[0] == 0.0, "reals are 0");
        else
            ok = ok && gen_check(g, !r.arg[k].x, "arrays are empty");
    }
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

verdict prop_request_free(gen *g)
{
    et_request r;

    if (!draw(g, &r))
        return FAIL;
    et_request_free(&r);
    et_request_free(&r);
    bool ok = true;
    for (size_t k = 0; k < ET_REQUEST_ARGS; k++)
        ok = ok && gen_check(g, !r.arg[k].x && r.arg[k].count == 0, "argument %zu is left", k);
    return ok ? PASS : FAIL;
}

verdict prop_request_copy(gen *g)
{
    et_request r, copy, none;

    if (!draw(g, &r))
        return FAIL;
    bool ok = gen_check(g, et_request_copy(&copy, &r) == ET_OK && same(&copy, &r), "the copy is the same");
    for (size_t k = 0; ok && k < ET_REQUEST_ARGS; k++)
        ok = gen_check(g, !copy.arg[k].x || copy.arg[k].x != r.arg[k].x, "with storage of its own");
    if (ok)
        et_request_free(&copy);
    memset(&none, 0, sizeof none);
    none.op = ET_OPS;
    ok = ok && gen_check(g, et_request_copy(&copy, &none) == ET_EINVAL, "what is no operation is not copied");
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

verdict prop_request_set(gen *g)
{
    et_request r, was;
    double x[9];

    if (!draw(g, &r))
        return FAIL;
    size_t n = 0;
    while (et_request_argument(r.op, n))
        n++;
    const size_t k = (size_t)gen_upto(g, n - 1), count = 1 + (size_t)gen_upto(g, 2);
    const et_request_shape *shape = et_request_argument(r.op, k);
    for (size_t i = 0; i < 9; i++)
        x[i] = any_real(g);
    was = r;
    bool ok = gen_check(g, et_request_set(&r, n, 0, x) == ET_EINVAL && et_request_set(&r, SIZE_MAX, 0, x) == ET_EINVAL && untouched(&r, &was),
                        "past the last");
    if (shape->kind == ET_ARG_WORD) {
        ok = ok && gen_check(g, et_request_set(&r, k, words_of(shape), NULL) == ET_EINVAL && untouched(&r, &was), "no such word");
        ok = ok && gen_check(g, et_request_set(&r, k, words_of(shape) - 1, NULL) == ET_OK && r.arg[k].count == words_of(shape) - 1, "the last word");
    } else if (shape->kind == ET_ARG_COUNT) {
        const uint64_t most = UINT64_C(1) << 53;
        const bool wide = sizeof(size_t) > 4;
        ok = ok && gen_check(g, et_request_set(&r, k, wide ? (size_t)most : SIZE_MAX, NULL) == ET_OK, "the greatest count");
        was = r;
        ok = ok && gen_check(g, !wide || (et_request_set(&r, k, (size_t)(most + 1), NULL) == ET_EINVAL && untouched(&r, &was)), "a greater one");
    } else {
        ok = ok && gen_check(g, et_request_set(&r, k, count, NULL) == ET_EINVAL && untouched(&r, &was), "numbers are missing");
        ok = ok && gen_check(g, et_request_set(&r, k, count, x) == ET_OK && r.arg[k].count == (shape->kind == ET_ARG_REAL ? 0 : count), "set");
        for (size_t i = 0; ok && i < reals_of(shape, count); i++)
            ok = gen_check(g, same_real(r.arg[k].x[i], x[i]), "number %zu", i);
        ok = ok && gen_check(g, et_request_set(&r, k, count, r.arg[k].x) == ET_OK && same_real(r.arg[k].x[0], x[0]), "set to itself");
    }
    if (shape->kind == ET_ARG_REALS || shape->kind == ET_ARG_POINTS) {
        ok = ok && gen_check(g, et_request_set(&r, k, SIZE_MAX, x) == ET_ENOMEM && r.arg[k].count == count, "more than there is");
        ok = ok && gen_check(g, et_request_set(&r, k, 0, NULL) == ET_OK && !r.arg[k].x && r.arg[k].count == 0, "set to nothing");
    }
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* ---- lines ---- */

static void add(char *line, size_t *at, const char *text)
{
    *at += (size_t)snprintf(line + *at, LINE - *at, "%s", text);
}

/* One real, in one of the ways that name it exactly. */
static void add_real(gen *g, char *line, size_t *at, double x)
{
    static const char *const ways[] = { "%a", "%A", "%.17g", "%.13a", "%.20e" };

    *at += (size_t)snprintf(line + *at, LINE - *at, ways[gen_upto(g, sizeof ways / sizeof *ways - 1)], x);
}

/* The words of the request, with single blanks or, `loose`, with what else is taken for them. */
static void write_line(gen *g, char *line, const et_request *r, bool loose)
{
    static const char *const gaps[] = { " ", "  ", "\t", " \t " };
    const et_request_shape *shape;
    size_t at = 0;

    line[0] = '\0';
    if (loose && gen_chance(g, 3))
        add(line, &at, gaps[gen_upto(g, 3)]);
    add(line, &at, et_request_name(r->op));
    for (size_t k = 0; (shape = et_request_argument(r->op, k)) != NULL; k++) {
        add(line, &at, gaps[loose ? gen_upto(g, 3) : 0]);
        if (shape->kind == ET_ARG_WORD)
            add(line, &at, shape->words[r->arg[k].count]);
        else if (shape->kind != ET_ARG_REAL)
            at += (size_t)snprintf(line + at, LINE - at, "%zu", r->arg[k].count);
        for (size_t i = 0; i < reals_of(shape, r->arg[k].count); i++) {
            if (shape->kind != ET_ARG_REAL)
                add(line, &at, gaps[loose ? gen_upto(g, 3) : 0]);
            if (loose)
                add_real(g, line, &at, r->arg[k].x[i]);
            else
                at += (size_t)snprintf(line + at, LINE - at, isnan(r->arg[k].x[i]) ? "nan" : "%a", r->arg[k].x[i]);
        }
    }
    if (loose && gen_chance(g, 2))
        add(line, &at, gen_chance(g, 2) ? "\r\n" : " \n");
}

verdict prop_request_parse(gen *g)
{
    char line[LINE];
    et_request r, read, was;
    et_message message = { "" };

    if (!draw(g, &r))
        return FAIL;
    write_line(g, line, &r, true);
    bool ok = gen_check(g, et_request_parse(&read, line, &message) == ET_OK, "'%s' is read: %s", line, message.text);
    if (ok) {
        ok = gen_check(g, same(&read, &r), "'%s' is read right", line);
        et_request_free(&read);
    }
    memset(&read, 7, sizeof read);
    was = read;
    write_line(g, line, &r, false);
    strcat(line, " 0");
    ok = ok && gen_check(g, et_request_parse(&read, line, &message) == ET_EFORMAT && message.text[0] && untouched(&read, &was),
                         "'%s': one word too many", line);
    *strrchr(line, ' ') = '\0';
    *strrchr(line, ' ') = '\0';
    ok = ok && gen_check(g, et_request_parse(&read, line, NULL) == ET_EFORMAT && untouched(&read, &was), "'%s': one word too few", line);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* A word altered in one place: none of the words may then be taken for another, unless it names the same kind of thing. */
verdict prop_request_parse_words(gen *g)
{
    static const char *const bad[] = { "", "x", "1x", "0x", "0xp1", "-", "+", ".", "1e", "1,5", "nanx", "inff", "\v1", "\f1", "1\v", "--1", "0x1p",
                                       "1p1", "(1)" };
    char line[64];
    et_request r;
    et_message message = { "" };
    const char *word = bad[gen_upto(g, sizeof bad / sizeof *bad - 1)];

    snprintf(line, sizeof line, "multiplicity 2 0 %s%s1", word, word[0] ? " " : "");
    bool ok = word[0] == '\0' || gen_check(g, et_request_parse(&r, line, &message) == ET_EFORMAT, "'%s' is no number", word);
    snprintf(line, sizeof line, "net_counts 2 %s", word);
    ok = ok && gen_check(g, et_request_parse(&r, line, &message) == ET_EFORMAT, "'%s' is no count", word);
    ok = ok && gen_check(g, strncmp(message.text, "ny: ", 4) == 0, "the argument is named: %s", message.text);
    ok = ok && gen_check(g, et_request_parse(&r, "", NULL) == ET_EFORMAT && et_request_parse(&r, " \t\r\n", NULL) == ET_EFORMAT, "an empty line");
    return ok ? PASS : FAIL;
}

/* Of a long word the sentence shows forty characters. */
verdict prop_request_parse_long(gen *g)
{
    const size_t length = (size_t)gen_between(g, 38, 90), place = (size_t)gen_upto(g, 2);
    char word[100], line[160], want[160];
    et_message message = { "" };
    et_request r;

    for (size_t k = 0; k < length; k++)
        word[k] = (char)('a' + k % 26);
    word[length] = '\0';
    snprintf(line, sizeof line, place == 0 ? "%s" : place == 1 ? "net_counts %s 2" : "net_counts 2 2 %s", word);
    snprintf(want, sizeof want, place == 0 ? "'%.40s' is no operation" : place == 1 ? "nx: '%.40s' is not a count" : "'%.40s' is one word too many",
             word);
    const et_status status = et_request_parse(&r, line, &message);
    return gen_check(g, status == ET_EFORMAT && strcmp(message.text, want) == 0, "%s", message.text) ? PASS : FAIL;
}

/* Numbers and points are said to be missing before anything is taken for them. */
verdict prop_request_parse_short(gen *g)
{
    static const uint64_t most = UINT64_C(1) << 53;
    const uint64_t n = gen_chance(g, 2) ? most - gen_upto(g, 9) : 3 + gen_upto(g, 999);
    const bool points = gen_upto(g, 1);
    char line[160], want[160];
    et_message message = { "" };
    et_request r;

    snprintf(line, sizeof line, points ? "parameters chord %llu 1 2" : "multiplicity %llu 1 2", (unsigned long long)n);
    snprintf(want, sizeof want, points ? "points: the line ends before its %llu points" : "u: the line ends before its %llu numbers",
             (unsigned long long)n);
    const et_status status = et_request_parse(&r, line, &message);
    const bool soon = !points && n <= 4;                      /* as many characters are left */
    return gen_check(g, status == ET_EFORMAT && (soon || strcmp(message.text, want) == 0), "%s", message.text) ? PASS : FAIL;
}

verdict prop_request_print(gen *g)
{
    char line[LINE], *printed = NULL;
    et_request r;

    if (!draw(g, &r))
        return FAIL;
    write_line(g, line, &r, false);
    bool ok = gen_check(g, et_request_print(&printed, &r) == ET_OK && strcmp(printed, line) == 0, "'%s', not '%s'", printed ? printed : "", line);
    free(printed);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* ---- curves and surfaces ---- */

verdict prop_request_curve(gen *g)
{
    static const double zero[64];
    const size_t p = (size_t)gen_upto(g, 4), n = 1 + (size_t)gen_upto(g, 6), nu = n + p + 1 + (size_t)gen_upto(g, 1), np = n + (size_t)gen_upto(g, 1);
    const size_t nw = gen_upto(g, 1) ? 0 : n + (size_t)gen_upto(g, 1);
    et_curve c, was;
    et_request r;

    memset(&c, 7, sizeof c);
    was = c;
    if (et_request_new(&r, ET_OP_CURVE_POINT) != ET_OK)
        return FAIL;
    bool ok = gen_check(g, et_request_curve(&c, &r, 0) == ET_EFORMAT && memcmp(&c, &was, sizeof c) == 0, "nothing in it");
    ok = ok && et_request_set(&r, 0, p, NULL) == ET_OK && et_request_set(&r, 1, nu, zero) == ET_OK && et_request_set(&r, 2, np, zero) == ET_OK
         && et_request_set(&r, 3, nw, zero) == ET_OK;
    const bool fits = nu == np + p + 1 && (nw == 0 || nw == np);
    const et_status status = et_request_curve(&c, &r, 0);
    ok = ok && gen_check(g, status == (fits ? ET_OK : ET_EFORMAT), "p = %zu, %zu knots, %zu points, %zu weights", p, nu, np, nw);
    if (ok && fits)
        ok = gen_check(g, c.p == p && c.n == np && c.u == r.arg[1].x && (double *)c.points == r.arg[2].x && c.weights == (nw ? r.arg[3].x : NULL),
                       "its parts");
    else
        ok = ok && gen_check(g, memcmp(&c, &was, sizeof c) == 0, "unchanged");
    ok = ok && gen_check(g, et_request_curve(&c, &r, 1) == ET_EINVAL && et_request_curve(&c, &r, SIZE_MAX) == ET_EINVAL, "there stands none");
    ok = ok && et_request_set(&r, 0, nu, NULL) == ET_OK && gen_check(g, et_request_curve(&c, &r, 0) == ET_EFORMAT, "a degree beyond the knots");
    ok = ok && et_request_set(&r, 0, nu - 1, NULL) == ET_OK && gen_check(g, et_request_curve(&c, &r, 0) == ET_EFORMAT, "no point left");
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

verdict prop_request_surface(gen *g)
{
    static const double zero[160];
    const size_t p = (size_t)gen_upto(g, 3), q = (size_t)gen_upto(g, 3), nu = 1 + (size_t)gen_upto(g, 4), nv = 1 + (size_t)gen_upto(g, 4);
    const size_t np = nu * nv + (size_t)gen_upto(g, 1), nw = gen_upto(g, 1) ? 0 : nu * nv + (size_t)gen_upto(g, 1), first = gen_upto(g, 1) ? 6 : 0;
    et_surface s, was;
    et_request r;

    memset(&s, 7, sizeof s);
    was = s;
    if (et_request_new(&r, ET_OP_SEAM_GAP) != ET_OK)
        return FAIL;
    bool ok = gen_check(g, et_request_surface(&s, &r, first) == ET_EFORMAT && memcmp(&s, &was, sizeof s) == 0, "nothing in it");
    ok = ok && et_request_set(&r, first, p, NULL) == ET_OK && et_request_set(&r, first + 1, q, NULL) == ET_OK
        && et_request_set(&r, first + 2, nu + p + 1, zero) == ET_OK
         && et_request_set(&r, first + 3, nv + q + 1, zero) == ET_OK && et_request_set(&r, first + 4, np, zero) == ET_OK
             && et_request_set(&r, first + 5, nw, zero) == ET_OK;
    const bool fits = np == nu * nv && (nw == 0 || nw == np);
    ok = ok && gen_check(g, et_request_surface(&s, &r, first) == (fits ? ET_OK : ET_EFORMAT), "%zu x %zu, %zu points, %zu weights", nu, nv, np, nw);
    if (ok && fits)
        ok = gen_check(g, s.p == p && s.q == q && s.nu == nu && s.nv == nv && s.u == r.arg[first + 2].x && s.v == r.arg[first + 3].x
                              && (double *)s.points == r.arg[first + 4].x && s.weights == (nw ? r.arg[first + 5].x : NULL), "its parts");
    else
        ok = ok && gen_check(g, memcmp(&s, &was, sizeof s) == 0, "unchanged");
    ok = ok && gen_check(g, et_request_surface(&s, &r, 5) == ET_EINVAL && et_request_surface(&s, &r, 12) == ET_EINVAL, "there stands none");
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* ---- golden rows ---- */

/* The row's arguments as a line again. */
static char *line_of(const row *r)
{
    size_t length = 1;

    for (size_t i = 0; i < r->nargs; i++)
        length += strlen(r->arg[i]) + 1;
    char *line = malloc(length);
    if (line)
        line[0] = '\0';
    for (size_t i = 0; line && i < r->nargs; i++)
        strcat(strcat(line, i ? " " : ""), r->arg[i]);
    return line;
}

static bool is_text(const row *r, const char *text)
{
    bool ok = r->nwant == strlen(text);

    for (size_t i = 0; ok && i < r->nwant; i++)
        ok = row_is_size(r, i, (size_t)(unsigned char)text[i]);
    return ok;
}

/* Knots of which there are so many that their control points cannot be counted: no such surface, and nothing is looked at but counts. */
verdict prop_request_surface_many(gen *g)
{
    const size_t p = (size_t)gen_upto(g, 3), q = (size_t)gen_upto(g, 3), half = (size_t)1 << (sizeof(size_t) * 4);
    et_surface s, was;
    et_request r;

    memset(&s, 7, sizeof s);
    was = s;
    memset(&r, 0, sizeof r);
    r.op = ET_OP_SEAM_GAP;
    r.arg[0].count = p;
    r.arg[1].count = q;
    r.arg[2].count = half * (1 + (size_t)gen_upto(g, 5)) + p + 1;
    r.arg[3].count = half * (1 + (size_t)gen_upto(g, 5)) + q + 1;
    r.arg[4].count = (r.arg[2].count - p - 1) * (r.arg[3].count - q - 1);      /* what is left of the product */
    return gen_check(g, et_request_surface(&s, &r, 0) == ET_EFORMAT && memcmp(&s, &was, sizeof s) == 0, "a surface") ? PASS : FAIL;
}

verdict gold_request_name(const row *r)
{
    const char *name = et_request_name((et_request_op)row_size(r, 0));

    return (name ? is_text(r, name) : row_is_size(r, 0, 0)) ? PASS : FAIL;
}

verdict gold_request_find(const row *r)
{
    return row_is_size(r, 0, (size_t)et_request_find(r->arg[0])) ? PASS : FAIL;
}

verdict gold_request_argument(const row *r)
{
    static const size_t kinds[] = { 0, 1, 2, 3, 4 };
    const et_request_shape *shape = et_request_argument((et_request_op)row_size(r, 0), row_size(r, 1));

    if (!shape)
        return row_is_size(r, 0, 9) ? PASS : FAIL;
    return row_is_size(r, 0, kinds[shape->kind]) && row_is_size(r, 1, shape->kind == ET_ARG_WORD ? words_of(shape) : 0) ? PASS : FAIL;
}

verdict gold_request_parse(const row *r)
{
    char *line = line_of(r);
    et_request read;
    size_t i = 1;
    const et_request_shape *shape;
    const et_status status = line ? et_request_parse(&read, line, NULL) : ET_ENOMEM;
    bool ok = row_is_size(r, 0, (size_t)status);

    free(line);
    if (status != ET_OK)
        return ok ? PASS : FAIL;
    for (size_t k = 0; (shape = et_request_argument(read.op, k)) != NULL; k++) {
        if (shape->kind != ET_ARG_REAL)
            ok = ok && i < r->nwant && row_is_size(r, i++, read.arg[k].count);
        for (size_t j = 0; ok && j < reals_of(shape, read.arg[k].count); j++)
            ok = i < r->nwant && row_is(r, i++, read.arg[k].x[j]);
    }
    et_request_free(&read);
    return ok && i == r->nwant ? PASS : FAIL;
}

verdict gold_request_print(const row *r)
{
    char *line = line_of(r), *printed = NULL;
    et_request read;
    bool ok = line && et_request_parse(&read, line, NULL) == ET_OK;

    if (ok) {
        ok = et_request_print(&printed, &read) == ET_OK && is_text(r, printed);
        et_request_free(&read);
    }
    free(printed);
    free(line);
    return ok ? PASS : FAIL;
}
