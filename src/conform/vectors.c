#include "etalon/conform/vectors.h"
#include "etalon/base/size.h"
#include <errno.h>
#include <jansson.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where we are: the file, and the vector by its place and, once it is known, its id. */
typedef struct {
    const char *path, *operation, *id;
    size_t at;
    et_message *message;
} place;

static et_status wrong(const place *p, const char *what)
{
    return p->id ? et_status_fail(p->message, ET_EFORMAT, "%s: %s: %s", p->path, p->id, what)
                 : et_status_fail(p->message, ET_EFORMAT, "%s: vector %zu: %s", p->path, p->at + 1, what);
}

static et_status no_memory(const place *p)
{
    return et_status_fail(p->message, ET_ENOMEM, "%s: out of memory", p->path);
}

static et_status copy_text(const place *p, char **copy, const json_t *text)
{
    const char *s = json_string_value(text);

    if (!text)
        return ET_OK;
    if (!s || s[0] == '\0')
        return wrong(p, "a text is missing, empty or no text");
    *copy = malloc(strlen(s) + 1);
    if (!*copy)
        return no_memory(p);
    strcpy(*copy, s);
    return ET_OK;
}

static int is_number(const json_t *text, double *x)
{
    const char *s = json_string_value(text);
    char *stop;

    if (!s || s[0] == '\0' || strspn(s, " \t\n\v\f\r") > 0)
        return 0;
    *x = strtod(s, &stop);
    return *stop == '\0' && !isnan(*x);
}

/* A list of numbers, *x null and *n 0 if there is none. */
static et_status numbers(const place *p, double **x, size_t *n, const json_t *list)
{
    *x = NULL;
    *n = json_array_size(list);
    if (!list)
        return ET_OK;
    if (*n == 0)
        return wrong(p, "a list of numbers is empty or no list");
    *x = et_size_array(*n, sizeof **x);
    if (!*x)
        return no_memory(p);
    for (size_t i = 0; i < *n; i++)
        if (!is_number(json_array_get(list, i), &(*x)[i]))
            return wrong(p, "a text of a list is no number");
    return ET_OK;
}

static int is_bounds(const double *bound, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (signbit(bound[i]))
            return 0;
    return 1;
}

/* want, bound, and the same of the left: lists of one length. */
static et_status right_values(const place *p, et_truth *t, const json_t *v)
{
    double **list[4] = { &t->want, &t->bound, &t->other, &t->other_bound };
    static const char *const name[4] = { "want", "bound", "want_left", "bound_left" };
    const json_t *condition = json_object_get(v, "condition");
    size_t n[4];

    for (size_t k = 0; k < 4; k++) {
        const et_status status = numbers(p, list[k], &n[k], json_object_get(v, name[k]));
        if (status)
            return status;
        if ((k % 2 == 1 && n[k] != n[k - 1]) || (k == 2 && n[k] != 0 && n[k] != n[0]) || (k % 2 == 1 && !is_bounds(*list[k], n[k])))
            return wrong(p, "want and bound do not match");
    }
    t->count = n[0];
    t->condition = 1;
    if ((condition != NULL) != (n[0] > 0) || (condition && (!is_number(condition, &t->condition) || t->condition < 1)))
        return wrong(p, "condition is missing where there is something wanted, there where there is nothing, or no number from 1 on");
    return n[0] > 0 && t->validity == ET_INVALID ? wrong(p, "an invalid request has nothing wanted") : ET_OK;
}

static et_status kinds(const place *p, et_vector *v, const json_t *category, const json_t *validity)
{
    const char *c = json_string_value(category), *k = json_string_value(validity);
    static const et_validity all[3] = { ET_VALID, ET_IMPLEMENTATION_DEFINED, ET_INVALID };
    static const char *const name[3] = { "valid", "implementation_defined", "invalid" };
    size_t i = 0, j = 0;

    while (c && i < ET_CATEGORIES && strcmp(et_campaign_name((et_category)i), c) != 0)
        i++;
    while (k && j < 3 && strcmp(name[j], k) != 0)
        j++;
    if (!c || i == ET_CATEGORIES)
        return wrong(p, "category is missing, or there is none of this name");
    if (!k || j == 3)
        return wrong(p, "validity is missing, or there is none of this name");
    v->category = (et_category)i;
    v->truth.validity = all[j];
    return ET_OK;
}

static et_status request_of(const place *p, et_request *request, const json_t *text)
{
    const char *words = json_string_value(text);
    et_message why;
    char *line;
    size_t n;
    et_status status;

    if (!words)
        return wrong(p, "request is missing, or no text");
    n = strlen(p->operation) + strlen(words) + 2;
    line = malloc(n);
    if (!line)
        return no_memory(p);
    snprintf(line, n, "%s %s", p->operation, words);
    status = et_request_parse(request, line, &why);
    free(line);
    if (status == ET_ENOMEM)
        return no_memory(p);
    return status ? et_status_fail(p->message, ET_EFORMAT, "%s: %s: request: %s", p->path, p->id, why.text) : ET_OK;
}

/* Nothing else is there: a misspelt member is told. */
static et_status only_known(const place *p, json_t *v)
{
    static const char *const known[] = { "id", "category", "validity", "request", "want", "bound", "want_left", "bound_left", "condition", "issue",
                                         "comment" };
    const char *key;
    json_t *value;

    json_object_foreach(v, key, value) {
        size_t k = 0;
        while (k < sizeof known / sizeof known[0] && strcmp(known[k], key) != 0)
            k++;
        if (k == sizeof known / sizeof known[0])
            return wrong(p, "a member that no vector has");
    }
    return ET_OK;
}

static void free_vector(et_vector *v)
{
    free(v->id);
    free(v->issue);
    free(v->comment);
    et_request_free(&v->request);
    free(v->truth.want);
    free(v->truth.bound);
    free(v->truth.other);
    free(v->truth.other_bound);
}

/* What is filled in when it fails is freed with the rest. */
static et_status read_vector(place *p, et_vector *v, json_t *from)
{
    et_status status;

    p->id = NULL;
    if (!json_is_object(from) || !json_object_get(from, "id"))
        return wrong(p, "is no object with an id");
    status = copy_text(p, &v->id, json_object_get(from, "id"));
    p->id = v->id;
    if (!status)
        status = only_known(p, from);
    if (!status)
        status = kinds(p, v, json_object_get(from, "category"), json_object_get(from, "validity"));
    if (!status)
        status = copy_text(p, &v->issue, json_object_get(from, "issue"));
    if (!status)
        status = copy_text(p, &v->comment, json_object_get(from, "comment"));
    if (!status)
        status = request_of(p, &v->request, json_object_get(from, "request"));
    return status ? status : right_values(p, &v->truth, from);
}

static et_status document_of(const place *p, json_t **document)
{
    json_error_t error;
    FILE *in = fopen(p->path, "rb");
    int failed, reason;

    if (!in)
        return et_status_fail(p->message, errno == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot read %s: %s", p->path, strerror(errno));
    errno = 0;
    *document = json_loadf(in, JSON_REJECT_DUPLICATES, &error);
    reason = errno;
    failed = ferror(in);
    (void)fclose(in);
    if (*document && !failed)
        return ET_OK;
    json_decref(*document);
    if (failed)
        return et_status_fail(p->message, ET_EIO, "cannot read %s: %s", p->path, reason ? strerror(reason) : "read error");
    if (json_error_code(&error) == json_error_out_of_memory)
        return no_memory(p);
    return et_status_fail(p->message, ET_EFORMAT, "%s:%d: %s", p->path, error.line, error.text);
}

static et_status header(place *p, json_t **list, json_t *document)
{
    const char *format = json_string_value(json_object_get(document, "format"));
    const json_t *version = json_object_get(document, "version");

    p->operation = json_string_value(json_object_get(document, "operation"));
    *list = json_object_get(document, "vectors");
    if (!format || strcmp(format, "etalon-conformance") != 0)
        return et_status_fail(p->message, ET_EFORMAT, "%s: format: is not \"etalon-conformance\"", p->path);
    if (json_integer_value(version) != 1)
        return et_status_fail(p->message, ET_EFORMAT, "%s: version: is not 1", p->path);
    if (!p->operation || et_request_find(p->operation) == ET_OPS)
        return et_status_fail(p->message, ET_EFORMAT, "%s: operation: is none of the protocol", p->path);
    if (!json_is_array(*list) || json_object_size(document) != 4)
        return et_status_fail(p->message, ET_EFORMAT, "%s: vectors: is no list, or stands beside something else", p->path);
    return ET_OK;
}

static et_status read_all(et_vectors *all, place *p, json_t *list)
{
    const size_t n = json_array_size(list);

    all->count = 0;
    all->vector = n ? calloc(n, sizeof *all->vector) : NULL;
    if (n && !all->vector)
        return no_memory(p);
    for (p->at = 0; p->at < n; p->at++) {
        all->count++;
        const et_status status = read_vector(p, &all->vector[p->at], json_array_get(list, p->at));
        if (status)
            return status;
    }
    return ET_OK;
}

et_status et_vectors_read(et_vectors *vectors, const char *path, et_message *message)
{
    place p = { path, NULL, NULL, 0, message };
    json_t *document = NULL, *list = NULL;
    et_vectors all = { NULL, 0 };
    et_status status;
    locale_t c, before;

    if (!vectors || !path)
        return et_status_fail(message, ET_EINVAL, "no file to read");
    /* Numbers have a point, whatever the locale of the program. */
    c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (c == (locale_t)0)
        return no_memory(&p);
    before = uselocale(c);
    status = document_of(&p, &document);
    if (!status) {
        status = header(&p, &list, document);
        if (!status)
            status = read_all(&all, &p, list);
        json_decref(document);
    }
    (void)uselocale(before);
    freelocale(c);
    if (status)
        et_vectors_free(&all);
    else
        *vectors = all;
    return status;
}

void et_vectors_free(et_vectors *vectors)
{
    if (!vectors)
        return;
    for (size_t i = 0; i < vectors->count; i++)
        free_vector(&vectors->vector[i]);
    free(vectors->vector);
    vectors->vector = NULL;
    vectors->count = 0;
}
