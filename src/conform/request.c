#include "etalon/conform/request.h"
#include "conform/request_words.h"
#include "etalon/base/size.h"
#include <stdlib.h>
#include <string.h>

/* ---- operations and their arguments ---- */

enum { SHAPES = 14 };
typedef struct { const char *name; et_request_shape shape[SHAPES]; } operation;

static const char *const side[] = { "any", "right", "left", NULL };
static const char *const along[] = { "u", "v", NULL };
static const char *const method[] = { "uniform", "chord", "centripetal", "exponential", NULL };
static const char *const rule[] = { "piegl", "averaging", "faithful", "uniform", NULL };
static const char *const corners[] = { "free", "interpolated", NULL };

#define COUNT ET_ARG_COUNT, NULL
#define REAL ET_ARG_REAL, NULL
#define REALS ET_ARG_REALS, NULL
#define POINTS ET_ARG_POINTS, NULL
#define CURVE { "p", COUNT }, { "u", REALS }, { "points", POINTS }, { "weights", REALS }
#define SURFACE { "p", COUNT }, { "q", COUNT }, { "u", REALS }, { "v", REALS }, { "points", POINTS }, { "weights", REALS }
#define OTHER \
    { "p_other", COUNT }, { "q_other", COUNT }, { "u_other", REALS }, { "v_other", REALS }, { "points_other", POINTS }, { "weights_other", REALS }
#define SIDE { "side", ET_ARG_WORD, side }
#define SIDES { "side_u", ET_ARG_WORD, side }, { "side_v", ET_ARG_WORD, side }
#define ALONG { "along", ET_ARG_WORD, along }
#define END { NULL, ET_ARG_COUNT, NULL }

/* In the order of et_request_op. */
static const operation operations[ET_OPS] = {
    { "span", { { "p", COUNT }, { "u", REALS }, { "x", REAL }, END } },
    { "multiplicity", { { "u", REALS }, { "x", REAL }, END } },
    { "greville", { { "p", COUNT }, { "u", REALS }, END } },
    { "basis", { { "p", COUNT }, { "u", REALS }, { "x", REAL }, SIDE, END } },
    { "basis_ders", { { "p", COUNT }, { "u", REALS }, { "x", REAL }, SIDE, { "d", COUNT }, END } },
    { "curve_point", { CURVE, { "x", REAL }, SIDE, END } },
    { "curve_ders", { CURVE, { "x", REAL }, SIDE, { "d", COUNT }, END } },
    { "surface_point", { SURFACE, { "x", REAL }, { "y", REAL }, SIDES, END } },
    { "surface_ders", { SURFACE, { "x", REAL }, { "y", REAL }, SIDES, { "d", COUNT }, END } },
    { "surface_normal", { SURFACE, { "x", REAL }, { "y", REAL }, END } },
    { "curve_insert", { CURVE, { "x", REAL }, { "r", COUNT }, END } },
    { "curve_remove", { CURVE, { "x", REAL }, { "r", COUNT }, { "tol", REAL }, END } },
    { "curve_elevate", { CURVE, { "r", COUNT }, END } },
    { "surface_insert", { SURFACE, ALONG, { "x", REAL }, { "r", COUNT }, END } },
    { "surface_remove", { SURFACE, ALONG, { "x", REAL }, { "r", COUNT }, { "tol", REAL }, END } },
    { "surface_elevate", { SURFACE, ALONG, { "r", COUNT }, END } },
    { "parameters", { { "method", ET_ARG_WORD, method }, { "points", POINTS }, END } },
    { "parameters_grid", { { "method", ET_ARG_WORD, method }, { "nx", COUNT }, { "ny", COUNT }, { "points", POINTS }, END } },
    { "knots", { { "rule", ET_ARG_WORD, rule }, { "p", COUNT }, { "n", COUNT }, { "t", REALS }, END } },
    { "fit_curve", { { "p", COUNT }, { "u", REALS }, { "t", REALS }, { "points", POINTS }, END } },
    { "fit_grid", { { "corners", ET_ARG_WORD, corners }, { "p", COUNT }, { "q", COUNT }, { "u", REALS }, { "v", REALS }, { "s", REALS },
                    { "r", REALS }, { "points", POINTS }, END } },
    { "fit_scattered", { { "p", COUNT }, { "q", COUNT }, { "u", REALS }, { "v", REALS }, { "a", REALS }, { "b", REALS }, { "points", POINTS },
                         END } },
    { "approximate", { { "p", COUNT }, { "q", COUNT }, { "nu", COUNT }, { "nv", COUNT }, { "mx", COUNT }, { "my", COUNT }, { "points", POINTS },
                       END } },
    { "curve_nearest", { CURVE, { "point", POINTS }, END } },
    { "surface_nearest", { SURFACE, { "point", POINTS }, END } },
    { "surface_error", { SURFACE, { "s", REALS }, { "r", REALS }, { "data", POINTS }, END } },
    { "net_counts", { { "nx", COUNT }, { "ny", COUNT }, END } },
    { "net_class", { { "nx", COUNT }, { "ny", COUNT }, { "view", COUNT }, { "i", COUNT }, { "j", COUNT }, END } },
    { "net_node", { { "nx", COUNT }, { "ny", COUNT }, { "c", COUNT }, END } },
    { "seam_gap", { SURFACE, OTHER, { "samples", COUNT }, END } },
};

const char *et_request_name(et_request_op op)
{
    return (size_t)op < ET_OPS ? operations[op].name : NULL;
}

static et_request_op find(const char *name, size_t length)
{
    for (int op = 0; op < ET_OPS; op++)
        if (strlen(operations[op].name) == length && memcmp(operations[op].name, name, length) == 0)
            return (et_request_op)op;
    return ET_OPS;
}

et_request_op et_request_find(const char *name)
{
    return find(name, strlen(name));
}

const et_request_shape *et_request_argument(et_request_op op, size_t k)
{
    if ((size_t)op >= ET_OPS)
        return NULL;
    const et_request_shape *shape = operations[op].shape;
    for (; k > 0 && shape->name; k--)
        shape++;
    return shape->name ? shape : NULL;
}

/* ---- storage ---- */

et_status et_request_new(et_request *request, et_request_op op)
{
    et_request made;
    const et_request_shape *shape;

    if ((size_t)op >= ET_OPS)
        return ET_EINVAL;
    memset(&made, 0, sizeof made);
    made.op = op;
    for (size_t k = 0; (shape = et_request_argument(op, k)) != NULL; k++)
        if (shape->kind == ET_ARG_REAL && !(made.arg[k].x = et_size_array(1, sizeof(double)))) {
            et_request_free(&made);
            return ET_ENOMEM;
        }
    *request = made;
    return ET_OK;
}

void et_request_free(et_request *request)
{
    for (size_t k = 0; k < ET_REQUEST_ARGS; k++)
        free(request->arg[k].x);
    memset(request, 0, sizeof *request);
}

/* How many doubles each item of a value of this kind holds. */
static size_t width(et_request_kind kind)
{
    return kind == ET_ARG_REAL || kind == ET_ARG_REALS ? 1 : kind == ET_ARG_POINTS ? 3 : 0;
}

/* How many doubles a value that is stored holds. */
static size_t held(et_request_kind kind, size_t count)
{
    return kind == ET_ARG_REAL ? 1 : width(kind) * count;
}

et_status et_request_set(et_request *request, size_t k, size_t count, const double *x)
{
    const et_request_shape *shape = et_request_argument(request->op, k);
    double *own = NULL;
    size_t n, words = 0;

    if (!shape)
        return ET_EINVAL;
    while (shape->kind == ET_ARG_WORD && shape->words[words])
        words++;
    if (et_size_mul(&n, width(shape->kind), shape->kind == ET_ARG_REAL ? 1 : count) != ET_OK)
        return ET_ENOMEM;
    if ((shape->kind == ET_ARG_WORD && count >= words) || (shape->kind == ET_ARG_COUNT && (uint64_t)count > UINT64_C(1) << 53) || (n > 0 && !x))
        return ET_EINVAL;
    if (n > 0) {
        if (!(own = et_size_array(n, sizeof *own)))
            return ET_ENOMEM;
        memcpy(own, x, n * sizeof *own);
    }
    free(request->arg[k].x);
    request->arg[k].x = own;
    request->arg[k].count = shape->kind == ET_ARG_REAL ? 0 : count;
    return ET_OK;
}

et_status et_request_copy(et_request *copy, const et_request *request)
{
    et_request made;
    et_status status = et_request_new(&made, request->op);

    if (status != ET_OK)
        return status;
    for (size_t k = 0; status == ET_OK && et_request_argument(request->op, k); k++)
        status = et_request_set(&made, k, request->arg[k].count, request->arg[k].x);
    if (status != ET_OK)
        et_request_free(&made);
    else
        *copy = made;
    return status;
}

/* ---- reading ---- */

enum { SHOWN = 40 };
static int shown(size_t length)
{
    return length < SHOWN ? (int)length : SHOWN;
}

static et_status misses(const et_request_shape *shape, const char *what, const char *word, size_t length, et_message *message)
{
    return length == 0 ? et_status_fail(message, ET_EFORMAT, "%s: the line ends where %s should be", shape->name, what)
                       : et_status_fail(message, ET_EFORMAT, "%s: '%.*s' is not %s", shape->name, shown(length), word, what);
}

static et_status read_count(size_t *count, const et_request_shape *shape, request_words *words, et_message *message)
{
    const char *word;
    const size_t length = request_words_next(&word, words);
    uint64_t value;

    if (!request_words_count(&value, word, length) || value > SIZE_MAX)
        return misses(shape, "a count", word, length, message);
    *count = (size_t)value;
    return ET_OK;
}

static et_status read_word(size_t *number, const et_request_shape *shape, request_words *words, et_message *message)
{
    const char *word;
    const size_t length = request_words_next(&word, words);

    for (size_t k = 0; length > 0 && shape->words[k]; k++)
        if (strlen(shape->words[k]) == length && memcmp(shape->words[k], word, length) == 0) {
            *number = k;
            return ET_OK;
        }
    return misses(shape, "one of its words", word, length, message);
}

/* What is allocated is at most as large as the line: each number takes two bytes of it. */
static et_status read_reals(double **x, size_t count, const et_request_shape *shape, request_words *words, et_message *message)
{
    if (count == 0)
        return ET_OK;
    if (count > strlen(words->at) / width(shape->kind))
        return et_status_fail(message, ET_EFORMAT, "%s: the line ends before its %zu %s", shape->name, count,
                              shape->kind == ET_ARG_POINTS ? "points" : "numbers");
    const size_t n = held(shape->kind, count);
    *x = et_size_array(n, sizeof **x);
    if (!*x)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    for (size_t i = 0; i < n; i++) {
        const char *word;
        const size_t length = request_words_next(&word, words);
        if (!request_words_real(&(*x)[i], word, length))
            return misses(shape, "a number", word, length, message);
    }
    return ET_OK;
}

static et_status read_argument(et_request_value *value, const et_request_shape *shape, request_words *words, et_message *message)
{
    if (shape->kind == ET_ARG_WORD)
        return read_word(&value->count, shape, words, message);
    if (shape->kind != ET_ARG_REAL) {
        const et_status status = read_count(&value->count, shape, words, message);
        if (status != ET_OK || shape->kind == ET_ARG_COUNT)
            return status;
    }
    free(value->x);
    value->x = NULL;
    return read_reals(&value->x, shape->kind == ET_ARG_REAL ? 1 : value->count, shape, words, message);
}

static et_status read_all(et_request *request, request_words words, et_message *message)
{
    const char *word;
    size_t length = request_words_next(&word, &words);
    const et_request_op op = find(word, length);
    const et_request_shape *shape;

    if (op == ET_OPS)
        return length == 0 ? et_status_fail(message, ET_EFORMAT, "no operation")
                           : et_status_fail(message, ET_EFORMAT, "'%.*s' is no operation", shown(length), word);
    et_status status = et_request_new(request, op);
    if (status != ET_OK)
        return et_status_fail(message, status, "out of memory");
    for (size_t k = 0; status == ET_OK && (shape = et_request_argument(op, k)) != NULL; k++)
        status = read_argument(&request->arg[k], shape, &words, message);
    if (status == ET_OK && (length = request_words_next(&word, &words)) > 0)
        status = et_status_fail(message, ET_EFORMAT, "'%.*s' is one word too many", shown(length), word);
    if (status != ET_OK)
        et_request_free(request);
    return status;
}

et_status et_request_parse(et_request *request, const char *line, et_message *message)
{
    locale_t c, before;
    et_request read;
    const request_words words = { line };

    if (request_words_point(&c, &before) != ET_OK)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    const et_status status = read_all(&read, words, message);
    request_words_point_end(c, before);
    if (status == ET_OK)
        *request = read;
    return status;
}

/* ---- writing ---- */

et_status et_request_print(char **line, const et_request *request)
{
    request_line made = { NULL, 0, 0, 0 };
    const et_request_shape *shape;

    request_line_text(&made, et_request_name(request->op));
    for (size_t k = 0; (shape = et_request_argument(request->op, k)) != NULL; k++) {
        const et_request_value *value = &request->arg[k];
        if (shape->kind == ET_ARG_WORD) {
            request_line_text(&made, " ");
            request_line_text(&made, shape->words[value->count]);
        } else if (shape->kind != ET_ARG_REAL) {
            request_line_text(&made, " ");
            request_line_count(&made, value->count);
        }
        for (size_t i = 0; !made.failed && i < held(shape->kind, value->count); i++) {
            request_line_text(&made, " ");
            request_line_real(&made, value->x[i]);
        }
    }
    return request_line_end(line, &made);
}

/* ---- curves and surfaces ---- */

/* 1 if the arguments from k on are of these kinds. */
static int are(const et_request *request, size_t k, const et_request_kind *kinds, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const et_request_shape *shape = k < ET_REQUEST_ARGS ? et_request_argument(request->op, k + i) : NULL;
        if (!shape || shape->kind != kinds[i])
            return 0;
    }
    return 1;
}

/* The number of control points that so many knots say, 0 if they are too few. */
static size_t points_of(size_t knots, size_t p)
{
    return knots > p && knots - p > 1 ? knots - p - 1 : 0;
}

et_status et_request_curve(et_curve *c, const et_request *request, size_t k)
{
    static const et_request_kind kinds[] = { ET_ARG_COUNT, ET_ARG_REALS, ET_ARG_POINTS, ET_ARG_REALS };

    if (!are(request, k, kinds, sizeof kinds / sizeof *kinds))
        return ET_EINVAL;
    const et_request_value *a = request->arg + k;
    const size_t p = a[0].count, n = points_of(a[1].count, p);
    if (n == 0 || a[2].count != n || (a[3].count != 0 && a[3].count != n))
        return ET_EFORMAT;
    *c = (et_curve){ p, n, a[1].x, (et_vec3 *)a[2].x, a[3].count ? a[3].x : NULL };
    return ET_OK;
}

et_status et_request_surface(et_surface *s, const et_request *request, size_t k)
{
    static const et_request_kind kinds[] = { ET_ARG_COUNT, ET_ARG_COUNT, ET_ARG_REALS, ET_ARG_REALS, ET_ARG_POINTS, ET_ARG_REALS };
    size_t n;

    if (!are(request, k, kinds, sizeof kinds / sizeof *kinds))
        return ET_EINVAL;
    const et_request_value *a = request->arg + k;
    const size_t p = a[0].count, q = a[1].count, nu = points_of(a[2].count, p), nv = points_of(a[3].count, q);
    if (et_size_mul(&n, nu, nv) != ET_OK || n == 0 || a[4].count != n || (a[5].count != 0 && a[5].count != n))
        return ET_EFORMAT;
    *s = (et_surface){ p, q, nu, nv, a[2].x, a[3].x, (et_vec3 *)a[4].x, a[5].count ? a[5].x : NULL };
    return ET_OK;
}
