#include "etalon/conform/reply.h"
#include "conform/request_words.h"
#include "etalon/base/size.h"
#include "etalon/conform/request.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const kinds[] = { "ok", "refused", "unsupported" };
enum { KINDS = 3, SHOWN = 40 };

static int shown(size_t length)
{
    return length < SHOWN ? (int)length : SHOWN;
}

static int is(const char *word, size_t length, const char *name)
{
    return strlen(name) == length && memcmp(word, name, length) == 0;
}

void et_reply_free(et_reply *reply)
{
    free(reply->x);
    memset(reply, 0, sizeof *reply);
}

et_status et_reply_put(et_reply *reply, const double *x, size_t n)
{
    size_t bytes;

    if (n == 0)
        return ET_OK;
    if (reply->count > SIZE_MAX - n || et_size_mul(&bytes, reply->count + n, sizeof *reply->x) != ET_OK)
        return ET_ENOMEM;
    double *more = realloc(reply->x, bytes);
    if (!more)
        return ET_ENOMEM;
    memcpy(more + reply->count, x, n * sizeof *more);
    reply->x = more;
    reply->count += n;
    return ET_OK;
}

/* ---- reading ---- */

/* The rest of the line, without blanks at its ends, cut to the room there is; what is no printable character becomes a blank. */
static void read_reason(char reason[128], const char *at)
{
    size_t n = 0;

    while (*at == ' ' || *at == '\t' || *at == '\r' || *at == '\n')
        at++;
    for (; *at && n < 127; at++)
        reason[n++] = (unsigned char)*at < ' ' || *at == 127 ? ' ' : *at;
    while (n > 0 && reason[n - 1] == ' ')
        n--;
    reason[n] = '\0';
}

/* What is allocated is at most as large as the line: each number takes two bytes of it. */
static et_status read_values(et_reply *reply, request_words words, et_message *message)
{
    const request_words first = words;
    const char *word;
    size_t length, n = 0;

    while (request_words_next(&word, &words) > 0)
        n++;
    if (n == 0)
        return ET_OK;
    words = first;
    reply->x = et_size_array(n, sizeof *reply->x);
    if (!reply->x)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    for (; reply->count < n; reply->count++) {
        length = request_words_next(&word, &words);
        if (!request_words_real(&reply->x[reply->count], word, length))
            return et_status_fail(message, ET_EFORMAT, "number %zu: '%.*s' is not a number", reply->count + 1, shown(length), word);
    }
    return ET_OK;
}

static et_status read_all(et_reply *reply, uint64_t *id, request_words words, et_message *message)
{
    const char *word;
    size_t length = request_words_next(&word, &words);
    int kind = 0;

    memset(reply, 0, sizeof *reply);
    if (!request_words_count(id, word, length))
        return et_status_fail(message, ET_EFORMAT, "'%.*s' is not the number of a request", shown(length), word);
    length = request_words_next(&word, &words);
    while (kind < KINDS && !is(word, length, kinds[kind]))
        kind++;
    if (kind == KINDS)
        return et_status_fail(message, ET_EFORMAT, "'%.*s' is not one of ok, refused, unsupported", shown(length), word);
    reply->kind = (et_reply_kind)kind;
    if (kind == ET_REPLY_OK)
        return read_values(reply, words, message);
    read_reason(reply->reason, words.at);
    return ET_OK;
}

et_status et_reply_parse(et_reply *reply, uint64_t *id, const char *line, et_message *message)
{
    locale_t c, before;
    et_reply read;
    uint64_t number;
    const request_words words = { line };

    if (request_words_point(&c, &before) != ET_OK)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    const et_status status = read_all(&read, &number, words, message);
    request_words_point_end(c, before);
    if (status != ET_OK) {
        et_reply_free(&read);
        return status;
    }
    *reply = read;
    *id = number;
    return ET_OK;
}

/* ---- writing ---- */

et_status et_reply_print(char **line, uint64_t id, const et_reply *reply)
{
    request_line made = { NULL, 0, 0, 0 };

    request_line_count(&made, id);
    request_line_text(&made, " ");
    request_line_text(&made, kinds[reply->kind]);
    if (reply->kind != ET_REPLY_OK && reply->reason[0]) {
        char reason[128];
        read_reason(reason, reply->reason);
        request_line_text(&made, " ");
        request_line_text(&made, reason);
    }
    for (size_t i = 0; reply->kind == ET_REPLY_OK && i < reply->count; i++) {
        request_line_text(&made, " ");
        request_line_real(&made, reply->x[i]);
    }
    return request_line_end(line, &made);
}

static et_status put_count(et_reply *reply, size_t n)
{
    const double x = (double)n;

    return et_reply_put(reply, &x, 1);
}

static et_status put_reals(et_reply *reply, const double *x, size_t n)
{
    const et_status status = put_count(reply, n);

    return status == ET_OK ? et_reply_put(reply, x, n) : status;
}

static et_status put_points(et_reply *reply, const et_vec3 *points, size_t n)
{
    et_status status = put_count(reply, n);

    for (size_t i = 0; status == ET_OK && i < n; i++) {
        const double x[3] = { points[i].x, points[i].y, points[i].z };
        status = et_reply_put(reply, x, 3);
    }
    return status;
}

/* What was put since is taken back. */
static et_status all_or_none(et_reply *reply, size_t before, et_status status)
{
    if (status != ET_OK)
        reply->count = before;
    return status;
}

et_status et_reply_put_curve(et_reply *reply, const et_curve *c)
{
    const size_t before = reply->count;
    et_status status = put_count(reply, c->p);

    if (status == ET_OK)
        status = put_reals(reply, c->u, c->n + c->p + 1);
    if (status == ET_OK)
        status = put_points(reply, c->points, c->n);
    if (status == ET_OK)
        status = put_reals(reply, c->weights, c->weights ? c->n : 0);
    return all_or_none(reply, before, status);
}

et_status et_reply_put_surface(et_reply *reply, const et_surface *s)
{
    const size_t before = reply->count;
    et_status status = put_count(reply, s->p);

    if (status == ET_OK)
        status = put_count(reply, s->q);
    if (status == ET_OK)
        status = put_reals(reply, s->u, s->nu + s->p + 1);
    if (status == ET_OK)
        status = put_reals(reply, s->v, s->nv + s->q + 1);
    if (status == ET_OK)
        status = put_points(reply, s->points, s->nu * s->nv);
    if (status == ET_OK)
        status = put_reals(reply, s->weights, s->weights ? s->nu * s->nv : 0);
    return all_or_none(reply, before, status);
}

/* ---- curves and surfaces among the numbers ---- */

/* The count at *at; 0: there is none. */
static int get_count(size_t *n, size_t *at, const et_reply *reply)
{
    if (*at >= reply->count)
        return 0;
    const double x = reply->x[*at];
    if (!(x >= 0 && x <= 0x1p53) || x != floor(x) || x > (double)(SIZE_MAX / 2))
        return 0;
    *n = (size_t)x;
    ++*at;
    return 1;
}

/* A count n and n * size numbers, which begin at *x. */
static int get_reals(const double **x, size_t *n, size_t size, size_t *at, const et_reply *reply)
{
    if (!get_count(n, at, reply) || *n > (reply->count - *at) / size)
        return 0;
    *x = reply->x + *at;
    *at += *n * size;
    return 1;
}

static void copy_points(et_vec3 *points, const double *x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        points[i] = (et_vec3){ x[3 * i], x[3 * i + 1], x[3 * i + 2] };
}

et_status et_reply_get_curve(et_curve *c, size_t *at, const et_reply *reply)
{
    size_t here = *at, p, nu, n, nw;
    const double *u, *x, *w;
    et_curve made;

    if (reply->kind != ET_REPLY_OK || !get_count(&p, &here, reply) || !get_reals(&u, &nu, 1, &here, reply) || !get_reals(&x, &n, 3, &here, reply)
        || !get_reals(&w, &nw, 1, &here, reply) || n <= p || nu != n + p + 1 || (nw != 0 && nw != n))
        return ET_EFORMAT;
    const et_status status = et_curve_new(&made, p, n, nw != 0);
    if (status != ET_OK)
        return status;
    memcpy(made.u, u, nu * sizeof *u);
    copy_points(made.points, x, n);
    if (nw != 0)
        memcpy(made.weights, w, nw * sizeof *w);
    *c = made;
    *at = here;
    return ET_OK;
}

et_status et_reply_get_surface(et_surface *s, size_t *at, const et_reply *reply)
{
    size_t here = *at, p, q, ku, kv, n, nw, product;
    const double *u, *v, *x, *w;
    et_surface made;

    if (reply->kind != ET_REPLY_OK || !get_count(&p, &here, reply) || !get_count(&q, &here, reply) || !get_reals(&u, &ku, 1, &here, reply)
        || !get_reals(&v, &kv, 1, &here, reply) || !get_reals(&x, &n, 3, &here, reply) || !get_reals(&w, &nw, 1, &here, reply))
        return ET_EFORMAT;
    if (ku <= p || ku - p - 1 <= p || kv <= q || kv - q - 1 <= q || et_size_mul(&product, ku - p - 1, kv - q - 1) != ET_OK || product != n
        || (nw != 0 && nw != n))
        return ET_EFORMAT;
    const et_status status = et_surface_new(&made, p, q, ku - p - 1, kv - q - 1, nw != 0);
    if (status != ET_OK)
        return status;
    memcpy(made.u, u, ku * sizeof *u);
    memcpy(made.v, v, kv * sizeof *v);
    copy_points(made.points, x, n);
    if (nw != 0)
        memcpy(made.weights, w, nw * sizeof *w);
    *s = made;
    *at = here;
    return ET_OK;
}

int et_reply_same(const et_reply *a, const et_reply *b)
{
    if (a->kind != b->kind || a->count != b->count)
        return 0;
    for (size_t i = 0; i < a->count; i++)
        if (memcmp(&a->x[i], &b->x[i], sizeof *a->x) != 0 && !(isnan(a->x[i]) && isnan(b->x[i])))
            return 0;
    return 1;
}

/* ---- hello ---- */

enum { PROTOCOL, NAME, VERSION, OPS, DEGREE, ORDER, RATIONAL, SIDES, TOLERANCE, KEYS };
static const char *const keys[KEYS] = { "protocol", "name", "version", "ops", "degree", "order", "rational", "sides", "knot_tolerance" };

/* The next of the words that commas separate; 0: no more. */
static size_t next_of_list(const char **word, const char **at, const char *end)
{
    while (*at < end && **at == ',')
        ++*at;
    *word = *at;
    while (*at < end && **at != ',')
        ++*at;
    return (size_t)(*at - *word);
}

static void read_ops(et_hello *hello, const char *value, size_t length)
{
    const char *at = value, *word;
    size_t n;

    while ((n = next_of_list(&word, &at, value + length)) > 0) {
        int op = 0;
        while (op < ET_OPS && !is(word, n, et_request_name((et_request_op)op)))
            op++;
        if (op < ET_OPS)
            hello->op[op] = 1;
        else
            hello->unknown++;
    }
}

static int read_sides(et_hello *hello, const char *value, size_t length)
{
    const char *at = value, *word;
    size_t n;

    hello->any = hello->left = hello->right = 0;
    while ((n = next_of_list(&word, &at, value + length)) > 0) {
        int *which = is(word, n, "any") ? &hello->any : is(word, n, "left") ? &hello->left : is(word, n, "right") ? &hello->right : NULL;
        if (!which)
            return 0;
        *which = 1;
    }
    return hello->any || hello->left || hello->right;
}

static int read_limit(size_t *limit, const char *value, size_t length)
{
    uint64_t n;

    if (!request_words_count(&n, value, length) || n > SIZE_MAX)
        return 0;
    *limit = (size_t)n;
    return 1;
}

static void read_name(char name[64], const char *value, size_t length)
{
    const size_t n = length < 63 ? length : 63;

    memcpy(name, value, n);
    name[n] = '\0';
}

/* 1 if the value is one that this key may have. */
static int read_key(et_hello *hello, int key, const char *value, size_t length)
{
    switch (key) {
    case PROTOCOL:
        return is(value, length, "1");
    case NAME:
        read_name(hello->name, value, length);
        return length > 0;
    case VERSION:
        read_name(hello->version, value, length);
        return length > 0;
    case OPS:
        read_ops(hello, value, length);
        return 1;
    case DEGREE:
        return read_limit(&hello->degree, value, length);
    case ORDER:
        return read_limit(&hello->order, value, length);
    case RATIONAL:
        hello->rational = is(value, length, "1");
        return hello->rational || is(value, length, "0");
    case SIDES:
        return read_sides(hello, value, length);
    default:
        return request_words_real(&hello->knot_tolerance, value, length) && hello->knot_tolerance >= 0 && isfinite(hello->knot_tolerance);
    }
}

static et_status read_hello(et_hello *hello, request_words words, et_message *message)
{
    int seen[KEYS] = { 0 };
    const char *word;
    size_t length;

    while ((length = request_words_next(&word, &words)) > 0) {
        const char *equals = memchr(word, '=', length);
        int key = 0;
        if (!equals)
            return et_status_fail(message, ET_EFORMAT, "hello: '%.*s' is not key=value", shown(length), word);
        while (key < KEYS && !is(word, (size_t)(equals - word), keys[key]))
            key++;
        if (key == KEYS)
            continue;
        if (seen[key]++)
            return et_status_fail(message, ET_EFORMAT, "hello: %s is said twice", keys[key]);
        if (!read_key(hello, key, equals + 1, length - (size_t)(equals + 1 - word)))
            return et_status_fail(message, ET_EFORMAT, "hello: '%.*s' is not understood", shown(length), word);
    }
    for (int key = PROTOCOL; key <= OPS; key++)
        if (!seen[key])
            return et_status_fail(message, ET_EFORMAT, "hello: %s is missing", keys[key]);
    return ET_OK;
}

et_status et_reply_hello(et_hello *hello, const char *words, et_message *message)
{
    locale_t c, before;
    et_hello read;
    const request_words all = { words };

    memset(&read, 0, sizeof read);
    read.degree = SIZE_MAX;
    read.order = 3;
    read.any = 1;
    if (request_words_point(&c, &before) != ET_OK)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    const et_status status = read_hello(&read, all, message);
    request_words_point_end(c, before);
    if (status == ET_OK)
        *hello = read;
    return status;
}
