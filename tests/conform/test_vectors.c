/* conform/vectors: what was written is read; what is wrong is told, with the file's name and the vector's. */
#include "etalon/conform/vectors.h"
#include "io/raw.h"
#include <math.h>

enum { VECTORS_MOST = 4, NUMBERS = 6, TEXT_MOST = 1 << 14 };

/* What a vector says, and the text of it. */
typedef struct {
    char id[64], request[400];
    et_category category;
    et_validity validity;
    size_t count;
    double want[NUMBERS], bound[NUMBERS], other[NUMBERS], other_bound[NUMBERS], condition;
    bool left, issue, comment;
} told;

static const char *const shapes[][2] = {
    { "multiplicity", "3 0x0p+0 0x1p-1 0x1p+0 0x1p-1" },
    { "span", "1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1.8p-1" },
    { "curve_point", "1 5 0x0p+0 0x0p+0 0x1p-1 0x1p+0 0x1p+0 3 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x0p+0 0 0x1p-1 any" },
    { "net_counts", "4 5" }, { "parameters", "chord 2 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+0" }, { "greville", "1 4 nan -inf inf -0x0p+0" } };

typedef struct { char text[TEXT_MOST]; size_t n; } page;

static void put(page *p, const char *format, const char *a)
{
    const int n = snprintf(p->text + p->n, TEXT_MOST - p->n, format, a);

    p->n += n > 0 ? (size_t)n : 0;
}

static double any_number(gen *g)
{
    static const double odd[] = { 0, 1, -1, INFINITY, -INFINITY, 0x1p-1074, -0x1.fffffffffffffp+1023 };

    return gen_chance(g, 3) ? odd[gen_upto(g, 6)] : gen_real(g, -8, 8);
}

static void numbers(page *p, const char *name, const double *x, size_t n)
{
    char word[40];

    put(p, ", \"%s\": [", name);
    for (size_t k = 0; k < n; k++) {
        /* Counts may be written so. */
        snprintf(word, sizeof word, x[k] == floor(x[k]) && x[k] >= 1 && x[k] <= 8 && k % 2 == 0 ? "%.0f" : "%a", x[k]);
        put(p, k ? ", \"%s\"" : "\"%s\"", word);
    }
    put(p, "]%s", "");
}

static void draw(gen *g, told *t, size_t shape, size_t number)
{
    memset(t, 0, sizeof *t);
    snprintf(t->id, sizeof t->id, "%s/plain/%zu", shapes[shape][0], number);
    snprintf(t->request, sizeof t->request, "%s", shapes[shape][1]);
    t->category = (et_category)gen_upto(g, ET_CATEGORIES - 1);
    t->validity = (et_validity)gen_upto(g, 2);
    t->count = t->validity == ET_INVALID ? 0 : (size_t)gen_upto(g, NUMBERS);
    t->left = t->count > 0 && gen_chance(g, 3);
    t->issue = gen_chance(g, 2);
    t->comment = gen_chance(g, 2);
    t->condition = 1;
    if (t->count > 0 && gen_chance(g, 2))
        t->condition = gen_chance(g, 3) ? INFINITY : gen_real(g, 1, 1000);
    for (size_t k = 0; k < t->count; k++) {
        t->want[k] = any_number(g);
        t->bound[k] = fabs(any_number(g));
        t->other[k] = any_number(g);
        t->other_bound[k] = fabs(any_number(g));
    }
}

static void write_vector(page *p, const told *t)
{
    char condition[40];

    snprintf(condition, sizeof condition, "%a", t->condition);
    put(p, "  {\"id\": \"%s\"", t->id);
    put(p, ", \"category\": \"%s\"", et_campaign_name(t->category));
    put(p, ", \"validity\": \"%s\"", et_judge_validity_name(t->validity));
    put(p, ", \"request\": \"%s\"", t->request);
    if (t->count > 0) {
        numbers(p, "want", t->want, t->count);
        numbers(p, "bound", t->bound, t->count);
        put(p, ", \"condition\": \"%s\"", condition);
    }
    if (t->left) {
        numbers(p, "want_left", t->other, t->count);
        numbers(p, "bound_left", t->other_bound, t->count);
    }
    put(p, t->issue ? ", \"issue\": \"https://example.org/%s\"" : "%.0s", "1");
    put(p, t->comment ? ", \"comment\": \"%s\"" : "%.0s", "\\u00e9 in a \\\"comment\\\"");
    put(p, "}%s", "");
}

static void write_page(page *p, const char *operation, const told *t, size_t n)
{
    p->n = 0;
    put(p, "{ \"format\": \"etalon-conformance\", \"version\": 1, \"operation\": \"%s\", \"vectors\": [\n", operation);
    for (size_t k = 0; k < n; k++) {
        write_vector(p, &t[k]);
        put(p, "%s\n", k + 1 < n ? "," : "");
    }
    put(p, "] }%s\n", "");
}

static bool same_list(const double *a, const double *b, size_t n)
{
    return n == 0 ? a == NULL : a && memcmp(a, b, n * sizeof *a) == 0;
}

static bool same_vector(const et_vector *v, const told *t, const char *operation)
{
    static const char comment[] = "\xc3\xa9 in a \"comment\"";
    char line[500], *printed = NULL;
    const size_t left = t->left ? t->count : 0;
    bool ok;

    snprintf(line, sizeof line, "%s %s", operation, t->request);
    ok = et_request_print(&printed, &v->request) == ET_OK && strcmp(printed, line) == 0;
    free(printed);
    return ok && strcmp(v->id, t->id) == 0 && v->category == t->category && v->truth.validity == t->validity && v->truth.count == t->count
        && same_list(v->truth.want, t->want, t->count) && same_list(v->truth.bound, t->bound, t->count) && same_list(v->truth.other, t->other, left)
        && same_list(v->truth.other_bound, t->other_bound, left) && v->truth.condition == t->condition && v->truth.reason[0] == '\0'
        && (t->issue ? v->issue && strcmp(v->issue, "https://example.org/1") == 0 : !v->issue)
        && (t->comment ? v->comment && strcmp(v->comment, comment) == 0 : !v->comment);
}

static bool spill(gen *g, char path[256], const page *p)
{
    gen_note(g, "%s", p->text);
    return gen_check(g, raw_spill(some_path(path, ".json"), (const uint8_t *)p->text, p->n), "%s cannot be written", path);
}

verdict prop_vectors_read(gen *g)
{
    static page p;
    told t[VECTORS_MOST];
    const size_t shape = (size_t)gen_upto(g, sizeof shapes / sizeof shapes[0] - 1), n = (size_t)gen_upto(g, VECTORS_MOST);
    et_vectors v = { NULL, 77 };
    et_message message = { "" };
    char path[256];
    bool ok;

    for (size_t k = 0; k < n; k++)
        draw(g, &t[k], shape, k + 1);
    write_page(&p, shapes[shape][0], t, n);
    if (!spill(g, path, &p))
        return FAIL;
    ok = gen_check(g, et_vectors_read(&v, path, &message) == ET_OK, "not read: %s", message.text) && gen_check(g, v.count == n,
            "%zu vectors, not %zu", v.count, n);
    unlink(path);
    for (size_t k = 0; ok && k < n; k++)
        ok = gen_check(g, v.vector[k].request.op == et_request_find(shapes[shape][0]) && same_vector(&v.vector[k], &t[k], shapes[shape][0]),
                       "vector %zu is another", k);
    if (!ok)
        return FAIL;
    et_vectors_free(&v);
    return gen_check(g, !v.vector && v.count == 0, "not empty afterwards") ? PASS : FAIL;
}

#define LEFT "\"want_left\": [\"0x1p+0\", \"0x0p+0\", \"-inf\"], \"bound_left\": [\"0x1p-49\", \"0x0p+0\", \"inf\"]"
/* One thing of a good file and what it becomes; `whole` where the file, not the vector, is told to be wrong. */
static const struct { const char *from, *to; bool whole; } wrongs[] = {
    { "etalon-conformance", "etalon-net", true }, { "\"version\": 1", "\"version\": 2", true }, { "\"version\": 1", "\"version\": \"1\"", true },
    { "\"version\": 1, ", "", true }, { "\"operation\": \"curve_point\"", "\"operation\": \"curve_spam\"",
                                       true }, { "\"operation\": \"curve_point\"", "\"operation\": 1", true },
    { "\"vectors\": [", "\"vektors\": [", true }, { "\"version\": 1", "\"version\": 1, \"more\": 1", true }, { "\"version\": 1",
            "\"version\": 1, \"version\": 1", true },
    { "] }", "]", true }, { "{\"id\": \"curve_point/plain/1\", ", "{", true }, { "{\"id\": \"curve_point/plain/1\"", "{\"id\": 1",
                                                                                true }, { "\"id\": \"curve_point/plain/1\"", "\"id\": \"\"", true },
    { "  {\"id\"", "  1, {\"id\"", true },
    { "\"category\": \"plain\"", "\"category\": \"plane\"", false }, { "\"category\": \"plain\", ", "", false }, { "\"category\": \"plain\"",
            "\"category\": 3", false },
    { "\"validity\": \"valid\"", "\"validity\": \"Valid\"", false }, { "\"validity\": \"valid\", ", "", false }, { "\"validity\": \"valid\"",
            "\"validity\": true", false },
    { "\"validity\": \"valid\"", "\"validity\": \"invalid\"", false }, { "\"request\": \"1 5", "\"request\": \"1 6", false }, { "\"request\": \"1 5",
            "\"request\": \"1 x", false },
    { " any\"", " any any\"", false }, { " any\"", "\"", false }, { "\"request\": ", "\"requests\": ", false },
    { "\"request\": \"1 5 0 0 0x1p-1 1 1 3 0 0 0 1 0 0 1 1 0 0 0x1p-1 any\"", "\"request\": 7", false },
    { "\"request\": \"1 5 0 0 0x1p-1 1 1 3 0 0 0 1 0 0 1 1 0 0 0x1p-1 any\", ", "", false },
    { "\"want\": [\"0x1p+0\", ", "\"want\": [", false }, { "\"want\": [", "\"want\": [\"1\", ", false }, { "\"want\": [\"0x1p+0\"", "\"want\": [1",
            false },
    { "\"want\": [\"0x1p+0\"", "\"want\": [\"\"", false }, { "\"want\": [\"0x1p+0\"", "\"want\": [\"0x1p+0 \"", false }, { "\"want\": [\"0x1p+0\"",
            "\"want\": [\" 1\"", false },
    { "\"want\": [\"0x1p+0\"", "\"want\": [\"nan\"", false }, { "\"bound\": [\"0x1p-50\"", "\"bound\": [\"-0x1p-50\"",
                                                               false }, { "\"bound\": [\"0x1p-50\"", "\"bound\": [\"-0x0p+0\"", false },
    { "\"bound\": [\"0x1p-50\", ", "\"bound\": [", false }, { "\"bound\": ", "\"bounds\": ", false }, { "\"bound_left\": [\"0x1p-49\", ",
            "\"bound_left\": [", false },
    { "\"want_left\": [\"0x1p+0\", ", "\"want_left\": [", false }, { "\"want_left\": ", "\"other\": ", false }, { "\"want_left\": [",
            "\"want_left\": 1, \"wants\": [", false },
    { LEFT, "\"want_left\": [], \"bound_left\": []", false }, { LEFT, "\"want_left\": [\"1\", \"2\"], \"bound_left\": [\"1\", \"2\"]", false },
    { LEFT, "\"want_left\": 1, \"bound_left\": 1", false }, { "\"condition\": \"0x1p+1\"", "\"condition\": \"0x1.8p-1\"",
                                                             false }, { "\"condition\": \"0x1p+1\"", "\"condition\": 2",
                                                                       false }, { ", \"condition\": \"0x1p+1\"", "", false },
    { "\"issue\": \"https://example.org/1\"", "\"issue\": 1", false }, { "\"issue\": \"https://example.org/1\"", "\"issue\": \"\"", false },
    { "\"comment\": \"", "\"comments\": \"", false }, { "\"comment\": \"it\"", "\"comment\": null", false } };

static const char good[] =
    "{ \"format\": \"etalon-conformance\", \"version\": 1, \"operation\": \"curve_point\", \"vectors\": [\n"
    "  {\"id\": \"curve_point/plain/1\", \"category\": \"plain\", \"validity\": \"valid\", "
    "\"request\": \"1 5 0 0 0x1p-1 1 1 3 0 0 0 1 0 0 1 1 0 0 0x1p-1 any\", "
    "\"want\": [\"0x1p+0\", \"0x0p+0\", \"0\"], \"bound\": [\"0x1p-50\", \"inf\", \"0x0p+0\"], \"want_left\": [\"0x1p+0\", \"0x0p+0\", \"-inf\"], "
    "\"bound_left\": [\"0x1p-49\", \"0x0p+0\", \"inf\"], \"condition\": \"0x1p+1\", "
    "\"issue\": \"https://example.org/1\", \"comment\": \"it\"}\n] }\n";

static bool fails(gen *g, const page *p, bool whole)
{
    static et_vector nowhere;
    et_vectors v = { &nowhere, 5 };
    et_message message = { "" };
    char path[256];

    if (!spill(g, path, p))
        return false;
    const et_status status = et_vectors_read(&v, path, &message);
    unlink(path);
    return gen_check(g, status == ET_EFORMAT, "status %s", et_status_text(status)) && gen_check(g, v.vector == &nowhere && v.count == 5,
                                                                                                "*vectors changed")
        && gen_check(g, strncmp(message.text, path, strlen(path)) == 0, "the file is not named: %s", message.text)
        && gen_check(g, whole || strstr(message.text, "curve_point/plain/1: ") != NULL, "the vector is not named: %s", message.text);
}

verdict prop_vectors_read_wrong(gen *g)
{
    static page p;
    const size_t k = (size_t)gen_upto(g, sizeof wrongs / sizeof wrongs[0] - 1);
    const char *at = strstr(good, wrongs[k].from);

    if (!gen_check(g, at != NULL, "wrong %zu is not there", k))
        return FAIL;
    p.n = (size_t)(at - good);
    memcpy(p.text, good, p.n);
    p.text[p.n] = '\0';
    put(&p, "%s", wrongs[k].to);
    put(&p, "%s", at + strlen(wrongs[k].from));
    gen_label(g, wrongs[k].whole ? "the file" : "the vector");
    return fails(g, &p, wrongs[k].whole) ? PASS : FAIL;
}

static bool read_as(gen *g, const char *path, et_status want, et_message *message)
{
    static et_vector nowhere;
    et_vectors v = { &nowhere, 5 };
    const et_status status = et_vectors_read(&v, path, message);

    return gen_check(g, status == want, "status %s", et_status_text(status)) && gen_check(g, v.vector == &nowhere && v.count == 5,
                                                                                          "*vectors changed");
}

/* The sentence begins with the file's name; what follows. */
static bool tells(gen *g, const char *text, const char *what)
{
    page p = { "", 0 };
    et_vectors v = { NULL, 0 };
    et_message m = { "" };
    char path[256];

    put(&p, "%s", text);
    if (!spill(g, path, &p))
        return false;
    const et_status status = et_vectors_read(&v, path, &m);
    unlink(path);
    return gen_check(g, status == ET_EFORMAT && strcmp(m.text + strlen(path), what) == 0, "%s", m.text);
}

#define HEAD(operation) "{\"format\": \"etalon-conformance\", \"version\": 1, \"operation\": \"" operation "\", \"vectors\": "
verdict prop_vectors_read_nothing(gen *g)
{
    et_message m = { "" };
    char path[256];
    page p = { "", 0 };
    et_vectors v = { NULL, 5 };

    (void)some_path(path, ".none");
    bool ok = read_as(g, path, ET_EIO, &m) && gen_check(g, strstr(m.text, path) && strstr(m.text, "No such file"), "%s", m.text);
    ok = ok && read_as(g, path, ET_EIO, NULL) && read_as(g, "/tmp", ET_EIO, &m);
    ok = ok && gen_check(g, strcmp(m.text, "cannot read /tmp: Is a directory") == 0, "%s", m.text);
    ok = ok && read_as(g, NULL, ET_EINVAL, &m) && gen_check(g, et_vectors_read(NULL, path, &m) == ET_EINVAL, "nowhere to put it");
    ok = ok && fails(g, &p, true) && tells(g, HEAD("spam") "[]}", ": operation: is none of the protocol");
    ok = ok && tells(g, HEAD("span") "[7]}", ": vector 1: is no object with an id") && tells(g, HEAD("span") "{}}",
        ": vectors: is no list, or stands beside something else");
    ok = ok && tells(g, HEAD("span") "[{\"id\": \"a\", \"more\": 1}]}", ": a: a member that no vector has");
    put(&p, "%s", good);
    ok = ok && spill(g, path, &p) && gen_check(g, et_vectors_read(&v, path, NULL) == ET_OK && v.count == 1, "the good one is not read");
    if (ok) {
        unlink(path);
        et_vectors_free(&v);
    }
    return ok ? PASS : FAIL;
}

verdict prop_vectors_free(gen *g)
{
    et_vectors v = { NULL, 0 };
    const size_t n = (size_t)gen_upto(g, 3);

    et_vectors_free(NULL);
    et_vectors_free(&v);
    v.vector = calloc(n + 1, sizeof *v.vector);
    v.count = v.vector ? n : 0;
    for (size_t k = 0; k < v.count; k++) {
        v.vector[k].id = malloc(1);
        v.vector[k].comment = k % 2 ? malloc(2) : NULL;
        v.vector[k].issue = k % 2 ? NULL : malloc(3);
        v.vector[k].truth.want = malloc(sizeof(double));
        v.vector[k].truth.bound = malloc(sizeof(double));
        v.vector[k].truth.other = malloc(sizeof(double));
        v.vector[k].truth.other_bound = malloc(sizeof(double));
        if (!gen_check(g, et_request_parse(&v.vector[k].request, "multiplicity 1 0 0", NULL) == ET_OK, "not parsed"))
            return FAIL;
    }
    et_vectors_free(&v);
    if (!gen_check(g, !v.vector && v.count == 0, "not empty"))
        return FAIL;
    et_vectors_free(&v);
    return gen_check(g, !v.vector && v.count == 0, "not empty the second time") ? PASS : FAIL;
}
