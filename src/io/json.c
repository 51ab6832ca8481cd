#include "etalon/io/json.h"
#include "etalon/base/size.h"
#include "etalon/io/file.h"
#include "etalon/spline/knots.h"
#include <errno.h>
#include <jansson.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VERSION = 1, PLACE = 120 };

static const char net_format[] = "etalon-net", surface_format[] = "etalon-surface";
static const char *const view_name[2] = { "bottom", "top" };

/* Counts are JSON integers, which jansson keeps as signed 64-bit numbers. */
static const size_t greatest_count = SIZE_MAX / 2;

/* ---- names of the choices ---- */

static const char *approach_name(int k)
{
    return k >= 0 && k <= ET_FIT_JOINT ? et_fit_name((et_fit_approach)k) : NULL;
}

static const char *method_name(int k)
{
    return k >= 0 && k <= ET_PARAM_EXPONENTIAL ? et_param_name((et_param_method)k) : NULL;
}

static const char *knots_name(int k)
{
    return k >= 0 && k <= ET_KNOTRULE_AVERAGING ? et_knotrule_name((et_knotrule_kind)k) : NULL;
}

static const char *algebra_name(int k)
{
    return k >= 0 && k <= ET_LINALG_SVD ? et_linalg_name((et_linalg_method)k) : NULL;
}

static const char *corners_name(int k)
{
    static const char *const name[] = { "default", "free", "interpolated" };
    return k >= 0 && k <= ET_CORNERS_INTERPOLATED ? name[k] : NULL;
}

/* ---- what a file may hold ---- */

static int reals_valid(const double *x, size_t n, double lo, double hi)
{
    for (size_t k = 0; k < n; k++) {
        if (!(x[k] >= lo && x[k] <= hi))
            return 0;
    }
    return 1;
}

static int frame_valid(const et_frame *f)
{
    double scale[3] = { f->scale.x, f->scale.y, f->scale.z };
    return et_vec3_finite(&f->offset, 1) && reals_valid(scale, 3, 0x1p-1074, 0x1.fffffffffffffp1023);
}

static int quality_valid(const et_som_quality *q)
{
    double x[3] = { q->qe, q->min_error, q->max_error };
    return reals_valid(x, 3, 0, 0x1.fffffffffffffp1023) && reals_valid(&q->te, 1, 0, 1) && q->min_error <= q->max_error &&
           q->steps <= greatest_count;
}

static int som_options_valid(const et_som_options *o)
{
    return o->iterations >= 1 && o->iterations <= greatest_count && reals_valid(&o->alpha0, 1, 0x1p-1074, 1) &&
           reals_valid(&o->sigma0, 1, 0, 0x1.fffffffffffffp1023);
}

static int net_valid(const et_net_file *n)
{
    return et_doublenet_valid(n->net) && n->weights && et_vec3_finite(n->weights, et_doublenet_nov(n->net)) && frame_valid(&n->frame) &&
           som_options_valid(&n->options) && quality_valid(&n->training) && quality_valid(&n->final);
}

/* Parameters: from 0 to 1, non-decreasing. */
static int parameters_valid(const double *t, size_t n)
{
    for (size_t k = 1; t && k < n; k++) {
        if (!(t[k - 1] <= t[k]))
            return 0;
    }
    return t && reals_valid(t, n, 0, 1);
}

static int fit_options_valid(const et_fit_options *o)
{
    return approach_name((int)o->approach) && method_name((int)o->method) && knots_name((int)o->knots) && algebra_name((int)o->algebra) &&
           corners_name((int)o->corners) && o->p >= 1 && o->q >= 1 && et_doublenet_valid(o->control) && o->p < o->control.nx &&
           o->q < o->control.ny && o->control.nx <= greatest_count && o->control.ny <= greatest_count;
}

static int surface_valid(const et_surface_file *s)
{
    const et_fit *f = &s->fit;
    double e[5] = { s->error.nov, s->error.non, s->error.greatest, s->error.corner, s->seam_gap };
    if (!et_shell_valid(&f->shell) || f->shell.view[ET_BOTTOM].p < 1 || f->shell.view[ET_BOTTOM].q < 1 || !et_doublenet_valid(f->data) ||
        f->flat > greatest_count)
        return 0;
    for (size_t w = 0; w < 2; w++) {
        if (!parameters_valid(f->s[w], f->data.nx) || !parameters_valid(f->r[w], f->data.ny))
            return 0;
    }
    return fit_options_valid(&s->options) && frame_valid(&s->frame) && reals_valid(e, 5, 0, 0x1.fffffffffffffp1023) &&
           (!s->uv || reals_valid(s->uv, 2 * et_doublenet_nov(f->data), 0, 1));
}

/* ---- writing: by the line, so that a large net needs no second copy in memory ---- */

/* 17 significant digits are read as the same double; a point or an exponent keeps it a real, and -0 negative. */
static void put_real(FILE *out, double x)
{
    char text[40];
    (void)snprintf(text, sizeof text - 2, "%.17g", x);
    if (!strpbrk(text, ".e"))
        strcat(text, ".0");
    fputs(text, out);
}

static void put_member(FILE *out, const char *name, double x, const char *after)
{
    fprintf(out, "\"%s\": ", name);
    put_real(out, x);
    fputs(after, out);
}

static void put_list(FILE *out, const double *x, size_t n)
{
    putc('[', out);
    for (size_t k = 0; k < n; k++) {
        fputs(k ? ", " : "", out);
        put_real(out, x[k]);
    }
    putc(']', out);
}

static void put_vector(FILE *out, et_vec3 p)
{
    double x[3] = { p.x, p.y, p.z };
    put_list(out, x, 3);
}

static void put_points(FILE *out, const char *indent, const et_vec3 *points, size_t n)
{
    fputs("[\n", out);
    for (size_t k = 0; k < n && !ferror(out); k++) {
        fprintf(out, "%s  ", indent);
        put_vector(out, points[k]);
        fputs(k + 1 < n ? ",\n" : "\n", out);
    }
    fprintf(out, "%s]", indent);
}

static void put_frame(FILE *out, const et_frame *frame)
{
    fputs("  \"frame\": {\"offset\": ", out);
    put_vector(out, frame->offset);
    fputs(", \"scale\": ", out);
    put_vector(out, frame->scale);
    fputs("}", out);
}

static void put_quality(FILE *out, const char *name, const et_som_quality *q)
{
    fprintf(out, "    \"%s\": {", name);
    put_member(out, "qe", q->qe, ", ");
    put_member(out, "te", q->te, ", ");
    put_member(out, "min_error", q->min_error, ", ");
    put_member(out, "max_error", q->max_error, ", ");
    fprintf(out, "\"steps\": %zu}", q->steps);
}

static void put_net(FILE *out, const et_net_file *n)
{
    fprintf(out, "{\n  \"format\": \"%s\",\n  \"version\": %d,\n", net_format, (int)VERSION);
    fprintf(out, "  \"net\": {\"nx\": %zu, \"ny\": %zu, \"non\": %zu, \"nov\": %zu, \"nor\": %zu},\n", n->net.nx, n->net.ny,
            et_doublenet_non(n->net), et_doublenet_nov(n->net), et_doublenet_nor(n->net));
    fprintf(out, "  \"training\": {\"iterations\": %zu, ", n->options.iterations);
    put_member(out, "alpha0", n->options.alpha0, ", ");
    put_member(out, "sigma0", n->options.sigma0, ", ");
    fprintf(out, "\"seed\": \"%llu\"},\n  \"quality\": {\n", (unsigned long long)n->seed);
    put_quality(out, "training", &n->training);
    fputs(",\n", out);
    put_quality(out, "final", &n->final);
    fputs("\n  },\n", out);
    put_frame(out, &n->frame);
    fputs(",\n  \"weights\": ", out);
    put_points(out, "  ", n->weights, et_doublenet_nov(n->net));
    fputs("\n}\n", out);
}

static void put_view(FILE *out, const char *name, const et_surface *s)
{
    fprintf(out, "    \"%s\": {\n      \"p\": %zu, \"q\": %zu, \"nu\": %zu, \"nv\": %zu,\n      \"u\": ", name, s->p, s->q, s->nu, s->nv);
    put_list(out, s->u, s->nu + s->p + 1);
    fputs(",\n      \"v\": ", out);
    put_list(out, s->v, s->nv + s->q + 1);
    fputs(",\n      \"points\": ", out);
    put_points(out, "      ", s->points, s->nu * s->nv);
    fputs(",\n      \"weights\": ", out);
    if (s->weights)
        put_list(out, s->weights, s->nu * s->nv);
    else
        fputs("null", out);
    fputs("\n    }", out);
}

static void put_data(FILE *out, const et_surface_file *s)
{
    const et_fit *f = &s->fit;
    fprintf(out, "  \"data\": {\n    \"nx\": %zu, \"ny\": %zu, \"flat\": %zu,\n", f->data.nx, f->data.ny, f->flat);
    for (size_t w = 0; w < 2; w++) {
        fprintf(out, "    \"%s\": {\n      \"s\": ", view_name[w]);
        put_list(out, f->s[w], f->data.nx);
        fputs(",\n      \"r\": ", out);
        put_list(out, f->r[w], f->data.ny);
        fputs("\n    },\n", out);
    }
    fputs("    \"uv\": ", out);
    if (s->uv) {
        size_t nov = et_doublenet_nov(f->data);
        fputs("[\n", out);
        for (size_t c = 0; c < nov; c++) {
            fputs("      ", out);
            put_list(out, s->uv + 2 * c, 2);
            fputs(c + 1 < nov ? ",\n" : "\n    ]", out);
        }
    } else {
        fputs("null", out);
    }
    fputs("\n  },\n", out);
}

static void put_surface(FILE *out, const et_surface_file *s)
{
    const et_fit_options *o = &s->options;
    fprintf(out, "{\n  \"format\": \"%s\",\n  \"version\": %d,\n", surface_format, (int)VERSION);
    fprintf(out, "  \"fit\": {\"approach\": \"%s\", \"parameters\": \"%s\", \"knots\": \"%s\", \"algebra\": \"%s\", \"corners\": \"%s\",\n",
            approach_name((int)o->approach), method_name((int)o->method), knots_name((int)o->knots), algebra_name((int)o->algebra),
            corners_name((int)o->corners));
    fprintf(out, "    \"p\": %zu, \"q\": %zu, \"nx\": %zu, \"ny\": %zu},\n", o->p, o->q, o->control.nx, o->control.ny);
    fputs("  \"error\": {", out);
    put_member(out, "nov", s->error.nov, ", ");
    put_member(out, "non", s->error.non, ", ");
    put_member(out, "greatest", s->error.greatest, ", ");
    put_member(out, "corner", s->error.corner, "},\n  ");
    put_member(out, "seam_gap", s->seam_gap, ",\n");
    fprintf(out, "  \"closed\": %s,\n", et_shell_closed(&s->fit.shell) ? "true" : "false");
    put_frame(out, &s->frame);
    fputs(",\n", out);
    put_data(out, s);
    fputs("  \"views\": {\n", out);
    put_view(out, view_name[0], &s->fit.shell.view[0]);
    fputs(",\n", out);
    put_view(out, view_name[1], &s->fit.shell.view[1]);
    fputs("\n  }\n}\n", out);
}

/* Exactly one of net and surface is given.  Reals are written with a point, whatever the locale of the program. */
static et_status write_file(const char *path, const et_net_file *net, const et_surface_file *surface, et_message *message)
{
    et_file file;
    et_status status = et_file_create(&file, path, message);
    if (status)
        return status;
    locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (c == (locale_t)0) {
        et_file_abandon(&file);
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    }
    locale_t before = uselocale(c);
    if (net)
        put_net(file.stream, net);
    else
        put_surface(file.stream, surface);
    (void)uselocale(before);
    freelocale(c);
    return et_file_commit(&file, message);
}

et_status et_json_write_net(const char *path, const et_net_file *net, et_message *message)
{
    if (!path || !net || !net_valid(net))
        return et_status_fail(message, ET_EINVAL, "no file, or a net with a value that no net file holds");
    return write_file(path, net, NULL, message);
}

et_status et_json_write_surface(const char *path, const et_surface_file *surface, et_message *message)
{
    if (!path || !surface || !surface_valid(surface))
        return et_status_fail(message, ET_EINVAL, "no file, or a surface with a value that no surface file holds");
    return write_file(path, NULL, surface, message);
}

/* ---- reading ---- */

typedef struct { const char *path; et_message *message; } source;

/* A value of the document and the way to it from the top, as in a.b.c. */
typedef struct { const json_t *value; char name[PLACE]; } place;

static et_status wrong(const source *d, const place *at, const char *what)
{
    return et_status_fail(d->message, ET_EFORMAT, "%s: %s%s%s", d->path, at->name, *at->name ? ": " : "", what);
}

static et_status wrong_element(const source *d, const place *at, size_t k, const char *what)
{
    return et_status_fail(d->message, ET_EFORMAT, "%s: %s[%zu]: %s", d->path, at->name, k, what);
}

static et_status no_memory(const source *d)
{
    return et_status_fail(d->message, ET_ENOMEM, "out of memory while reading %s", d->path);
}

/* way: parent.name; every name is one of this file's own, and all of them fit. */
static void extend(char way[PLACE], const char *parent, const char *name)
{
    size_t n = strlen(parent), m = strlen(name);
    size_t dot = n > 0 ? 1 : 0;
    if (n + dot + m >= PLACE)
        m = PLACE - 1 - n - dot;
    memmove(way, parent, n);
    if (dot)
        way[n] = '.';
    memcpy(way + n + dot, name, m);
    way[n + dot + m] = 0;
}

/* child: the member `name` of the object `parent`. */
static et_status member(const source *d, place *child, const place *parent, const char *name)
{
    if (!json_is_object(parent->value))
        return wrong(d, parent, "is not an object");
    child->value = json_object_get(parent->value, name);
    extend(child->name, parent->name, name);
    return child->value ? ET_OK : wrong(d, child, "is missing");
}

static et_status get_real(const source *d, double *x, const place *parent, const char *name, double lo, double hi)
{
    place at;
    et_status status = member(d, &at, parent, name);
    if (status)
        return status;
    if (!json_is_number(at.value))
        return wrong(d, &at, "is not a number");
    double value = json_number_value(at.value);
    if (!(value >= lo && value <= hi))
        return wrong(d, &at, "is out of range");
    *x = value;
    return ET_OK;
}

static et_status get_count(const source *d, size_t *n, const place *parent, const char *name, size_t least)
{
    place at;
    et_status status = member(d, &at, parent, name);
    if (status)
        return status;
    json_int_t value = json_integer_value(at.value);
    if (!json_is_integer(at.value) || value < 0 || (unsigned long long)value > greatest_count)
        return wrong(d, &at, "is not a count");
    if ((size_t)value < least)
        return wrong(d, &at, "is too small");
    *n = (size_t)value;
    return ET_OK;
}

/* A count that follows from others: where it is given it must agree. */
static et_status check_count(const source *d, const place *parent, const char *name, size_t wanted)
{
    size_t n = 0;
    et_status status;
    if (!json_object_get(parent->value, name))
        return ET_OK;
    if ((status = get_count(d, &n, parent, name, 0)) != ET_OK)
        return status;
    return n == wanted ? ET_OK
                       : et_status_fail(d->message, ET_EFORMAT, "%s: %s.%s: is %zu, but follows as %zu", d->path, parent->name, name, n, wanted);
}

static et_status get_choice(const source *d, int *choice, const place *parent, const char *name, const char *(*choice_name)(int))
{
    place at;
    et_status status = member(d, &at, parent, name);
    if (status)
        return status;
    if (!json_is_string(at.value))
        return wrong(d, &at, "is not a string");
    for (int k = 0; choice_name(k); k++) {
        if (strcmp(json_string_value(at.value), choice_name(k)) == 0) {
            *choice = k;
            return ET_OK;
        }
    }
    return wrong(d, &at, "is not a known name");
}

/* A 64-bit number as a string of decimal digits. */
static et_status get_digits(const source *d, uint64_t *x, const place *parent, const char *name)
{
    place at;
    et_status status = member(d, &at, parent, name);
    if (status)
        return status;
    const char *p = json_string_value(at.value);
    uint64_t value = 0;
    for (; p && *p >= '0' && *p <= '9'; p++) {
        uint64_t digit = (uint64_t)(*p - '0');
        if (value > (UINT64_MAX - digit) / 10)
            break;
        value = 10 * value + digit;
    }
    if (!p || *p || json_string_length(at.value) == 0)
        return wrong(d, &at, "is not a string of decimal digits below 2^64");
    *x = value;
    return ET_OK;
}

static et_status get_array(const source *d, place *at, const place *parent, const char *name, size_t n)
{
    et_status status = member(d, at, parent, name);
    if (status)
        return status;
    if (!json_is_array(at->value))
        return wrong(d, at, "is not an array");
    if (json_array_size(at->value) != n)
        return et_status_fail(d->message, ET_EFORMAT, "%s: %s: has %zu elements, not %zu", d->path, at->name, json_array_size(at->value), n);
    return ET_OK;
}

static et_status fill_reals(const source *d, double *x, const place *at, double lo, double hi)
{
    for (size_t k = 0; k < json_array_size(at->value); k++) {
        const json_t *value = json_array_get(at->value, k);
        if (!json_is_number(value))
            return wrong_element(d, at, k, "is not a number");
        x[k] = json_number_value(value);
        if (!(x[k] >= lo && x[k] <= hi))
            return wrong_element(d, at, k, "is out of range");
    }
    return ET_OK;
}

/* The n numbers of element k of an array, itself an array. */
static et_status get_row(const source *d, double *x, size_t n, const place *at, size_t k)
{
    const json_t *row = json_array_get(at->value, k);
    int fits = json_is_array(row) && json_array_size(row) == n;
    for (size_t i = 0; i < n && fits; i++) {
        const json_t *value = json_array_get(row, i);
        fits = json_is_number(value);
        x[i] = json_number_value(value);
    }
    return fits ? ET_OK : wrong_element(d, at, k, n == 3 ? "is not an array of three numbers" : "is not an array of two numbers");
}

static et_status fill_pairs(const source *d, double *x, const place *at)
{
    et_status status = ET_OK;
    for (size_t k = 0; k < json_array_size(at->value) && !status; k++) {
        status = get_row(d, x + 2 * k, 2, at, k);
        if (!status && !reals_valid(x + 2 * k, 2, 0, 1))
            status = wrong_element(d, at, k, "is out of range");
    }
    return status;
}

static et_status fill_points(const source *d, et_vec3 *points, const place *at)
{
    et_status status = ET_OK;
    for (size_t k = 0; k < json_array_size(at->value) && !status; k++) {
        double x[3] = { 0, 0, 0 };
        status = get_row(d, x, 3, at, k);
        points[k] = (et_vec3){ x[0], x[1], x[2] };
    }
    return status;
}

static et_status get_vector(const source *d, et_vec3 *p, const place *parent, const char *name, double lo)
{
    place at;
    double x[3] = { 0, 0, 0 };
    et_status status = get_array(d, &at, parent, name, 3);
    if (!status)
        status = fill_reals(d, x, &at, lo, 0x1.fffffffffffffp1023);
    if (!status)
        *p = (et_vec3){ x[0], x[1], x[2] };
    return status;
}

static et_status get_frame(const source *d, et_frame *frame, const place *top)
{
    place at;
    et_status status = member(d, &at, top, "frame");
    if (!status)
        status = get_vector(d, &frame->offset, &at, "offset", -0x1.fffffffffffffp1023);
    if (!status)
        status = get_vector(d, &frame->scale, &at, "scale", 0x1p-1074);
    return status;
}

static const char *shown(const char *path)
{
    return path && strcmp(path, "-") == 0 ? "standard input" : path;
}

/* The document of a file, of the wanted format and version. */
static et_status load(const source *d, json_t **document, const char *path, const char *format)
{
    json_error_t error;
    int standard = strcmp(path, "-") == 0;
    FILE *in = standard ? stdin : fopen(path, "rb");
    if (!in)
        return et_status_fail(d->message, errno == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot read %s: %s", d->path, strerror(errno));
    errno = 0;
    json_t *loaded = json_loadf(in, JSON_REJECT_DUPLICATES, &error);
    int reason = errno, failed = ferror(in);
    if (!standard)
        (void)fclose(in);
    if (failed || !loaded) {
        json_decref(loaded);
        if (failed)
            return et_status_fail(d->message, ET_EIO, "cannot read %s: %s", d->path, reason ? strerror(reason) : "read error");
        if (json_error_code(&error) == json_error_out_of_memory)
            return no_memory(d);
        return et_status_fail(d->message, ET_EFORMAT, "%s:%d: %s", d->path, error.line, error.text);
    }
    place top = { loaded, "" }, at;
    et_status status = member(d, &at, &top, "format");
    if (!status && (!json_is_string(at.value) || strcmp(json_string_value(at.value), format) != 0))
        status = et_status_fail(d->message, ET_EFORMAT, "%s: format: is not \"%s\"", d->path, format);
    if (!status)
        status = member(d, &at, &top, "version");
    if (!status && (!json_is_integer(at.value) || json_integer_value(at.value) != VERSION))
        status = et_status_fail(d->message, ET_EFORMAT, "%s: version: is not %d", d->path, (int)VERSION);
    if (status) {
        json_decref(loaded);
        return status;
    }
    *document = loaded;
    return ET_OK;
}

static et_status get_sides(const source *d, et_doublenet *net, const place *at)
{
    et_doublenet sides = { 0, 0 };
    et_status status = get_count(d, &sides.nx, at, "nx", 2);
    if (!status)
        status = get_count(d, &sides.ny, at, "ny", 2);
    if (!status && !et_doublenet_valid(sides))
        status = wrong(d, at, "has too many nodes");
    if (!status)
        *net = sides;
    return status;
}

/* ---- the net file ---- */

static et_status read_training(const source *d, et_net_file *n, const place *top)
{
    place at;
    et_status status = member(d, &at, top, "training");
    if (!status)
        status = get_count(d, &n->options.iterations, &at, "iterations", 1);
    if (!status)
        status = get_real(d, &n->options.alpha0, &at, "alpha0", 0x1p-1074, 1);
    if (!status)
        status = get_real(d, &n->options.sigma0, &at, "sigma0", 0, 0x1.fffffffffffffp1023);
    if (!status)
        status = get_digits(d, &n->seed, &at, "seed");
    return status;
}

static et_status read_quality(const source *d, et_som_quality *q, const place *all, const char *name)
{
    place at;
    et_status status = member(d, &at, all, name);
    if (!status)
        status = get_real(d, &q->qe, &at, "qe", 0, 0x1.fffffffffffffp1023);
    if (!status)
        status = get_real(d, &q->te, &at, "te", 0, 1);
    if (!status)
        status = get_real(d, &q->min_error, &at, "min_error", 0, 0x1.fffffffffffffp1023);
    if (!status)
        status = get_real(d, &q->max_error, &at, "max_error", q->min_error, 0x1.fffffffffffffp1023);
    if (!status)
        status = get_count(d, &q->steps, &at, "steps", 0);
    return status;
}

static et_status read_weights(const source *d, et_net_file *n, const place *top)
{
    place at;
    size_t nov = et_doublenet_nov(n->net);
    et_status status = get_array(d, &at, top, "weights", nov);
    if (status)
        return status;
    n->weights = et_size_array(nov, sizeof *n->weights);
    return n->weights ? fill_points(d, n->weights, &at) : no_memory(d);
}

static et_status read_net(const source *d, et_net_file *n, const place *top)
{
    place at;
    et_status status = member(d, &at, top, "net");
    if (!status)
        status = get_sides(d, &n->net, &at);
    if (!status)
        status = check_count(d, &at, "non", et_doublenet_non(n->net));
    if (!status)
        status = check_count(d, &at, "nov", et_doublenet_nov(n->net));
    if (!status)
        status = check_count(d, &at, "nor", et_doublenet_nor(n->net));
    if (!status)
        status = read_training(d, n, top);
    if (!status)
        status = member(d, &at, top, "quality");
    if (!status)
        status = read_quality(d, &n->training, &at, "training");
    if (!status)
        status = read_quality(d, &n->final, &at, "final");
    if (!status)
        status = get_frame(d, &n->frame, top);
    if (!status)
        status = read_weights(d, n, top);
    return status;
}

et_status et_json_read_net(et_net_file *net, const char *path, et_message *message)
{
    source d = { shown(path), message };
    et_net_file read;
    json_t *document = NULL;
    if (!net || !path)
        return et_status_fail(message, ET_EINVAL, "no file to read");
    memset(&read, 0, sizeof read);
    et_status status = load(&d, &document, path, net_format);
    if (status)
        return status;
    place top = { document, "" };
    status = read_net(&d, &read, &top);
    json_decref(document);
    if (status)
        et_json_free_net(&read);
    else
        *net = read;
    return status;
}

void et_json_free_net(et_net_file *net)
{
    if (!net)
        return;
    free(net->weights);
    memset(net, 0, sizeof *net);
}

/* ---- the surface file ---- */

static et_status read_options(const source *d, et_fit_options *o, const place *top)
{
    place at;
    int approach = 0, method = 0, knots = 0, algebra = 0, corners = 0;
    et_status status = member(d, &at, top, "fit");
    if (!status)
        status = get_choice(d, &approach, &at, "approach", approach_name);
    if (!status)
        status = get_choice(d, &method, &at, "parameters", method_name);
    if (!status)
        status = get_choice(d, &knots, &at, "knots", knots_name);
    if (!status)
        status = get_choice(d, &algebra, &at, "algebra", algebra_name);
    if (!status)
        status = get_choice(d, &corners, &at, "corners", corners_name);
    if (!status)
        status = get_sides(d, &o->control, &at);
    if (!status)
        status = get_count(d, &o->p, &at, "p", 1);
    if (!status)
        status = get_count(d, &o->q, &at, "q", 1);
    if (!status && (o->p >= o->control.nx || o->q >= o->control.ny))
        status = wrong(d, &at, "the degrees p, q are not below the sides nx, ny");
    o->approach = (et_fit_approach)approach;
    o->method = (et_param_method)method;
    o->knots = (et_knotrule_kind)knots;
    o->algebra = (et_linalg_method)algebra;
    o->corners = (et_fit_corners)corners;
    return status;
}

static et_status read_error(const source *d, et_surface_file *s, const place *top)
{
    place at;
    double most = 0x1.fffffffffffffp1023;
    et_status status = member(d, &at, top, "error");
    if (!status)
        status = get_real(d, &s->error.nov, &at, "nov", 0, most);
    if (!status)
        status = get_real(d, &s->error.non, &at, "non", 0, most);
    if (!status)
        status = get_real(d, &s->error.greatest, &at, "greatest", 0, most);
    if (!status)
        status = get_real(d, &s->error.corner, &at, "corner", 0, most);
    if (!status)
        status = get_real(d, &s->seam_gap, top, "seam_gap", 0, most);
    return status;
}

static et_status read_parameters(const source *d, double **t, size_t n, const place *view, const char *name)
{
    place at;
    et_status status = get_array(d, &at, view, name, n);
    if (status)
        return status;
    *t = et_size_array(n, sizeof **t);
    if (!*t)
        return no_memory(d);
    if ((status = fill_reals(d, *t, &at, 0, 1)) != ET_OK)
        return status;
    return parameters_valid(*t, n) ? ET_OK : wrong(d, &at, "decreases");
}

static et_status read_uv(const source *d, et_surface_file *s, const place *data)
{
    place at;
    size_t nov = et_doublenet_nov(s->fit.data);
    et_status status = member(d, &at, data, "uv");
    if (status || json_is_null(at.value))
        return status;
    if ((status = get_array(d, &at, data, "uv", nov)) != ET_OK)
        return status;
    s->uv = et_size_array(nov, 2 * sizeof *s->uv);
    return s->uv ? fill_pairs(d, s->uv, &at) : no_memory(d);
}

static et_status read_data(const source *d, et_surface_file *s, const place *top)
{
    place at, view;
    et_fit *f = &s->fit;
    et_status status = member(d, &at, top, "data");
    if (!status)
        status = get_sides(d, &f->data, &at);
    if (!status)
        status = get_count(d, &f->flat, &at, "flat", 0);
    for (size_t w = 0; w < 2 && !status; w++) {
        status = member(d, &view, &at, view_name[w]);
        if (!status)
            status = read_parameters(d, &f->s[w], f->data.nx, &view, "s");
        if (!status)
            status = read_parameters(d, &f->r[w], f->data.ny, &view, "r");
    }
    return status ? status : read_uv(d, s, &at);
}

/* Sizes of a view, and that the document holds what they promise before anything of that size is allocated. */
static et_status read_shape(const source *d, et_surface *s, place array[4], const place *view, int *rational)
{
    size_t count;
    et_status status = get_count(d, &s->nu, view, "nu", 2);
    if (!status)
        status = get_count(d, &s->nv, view, "nv", 2);
    if (!status)
        status = get_count(d, &s->p, view, "p", 1);
    if (!status)
        status = get_count(d, &s->q, view, "q", 1);
    if (!status && (s->p >= s->nu || s->q >= s->nv))
        status = wrong(d, view, "the degrees p, q are not below the sizes nu, nv");
    if (!status && et_size_mul(&count, s->nu, s->nv) != ET_OK)
        status = wrong(d, view, "has too many control points");
    if (!status)
        status = get_array(d, &array[0], view, "u", s->nu + s->p + 1);
    if (!status)
        status = get_array(d, &array[1], view, "v", s->nv + s->q + 1);
    if (!status)
        status = get_array(d, &array[2], view, "points", s->nu * s->nv);
    if (!status)
        status = member(d, &array[3], view, "weights");
    *rational = !status && !json_is_null(array[3].value);
    return *rational ? get_array(d, &array[3], view, "weights", s->nu * s->nv) : status;
}

static et_status read_view(const source *d, et_surface *s, const place *views, const char *name)
{
    place view, array[4];
    et_surface shape;
    int rational = 0;
    const double most = 0x1.fffffffffffffp1023;
    memset(&shape, 0, sizeof shape);
    et_status status = member(d, &view, views, name);
    if (!status)
        status = read_shape(d, &shape, array, &view, &rational);
    if (status)
        return status;
    if ((status = et_surface_new(s, shape.p, shape.q, shape.nu, shape.nv, rational)) != ET_OK)
        return status == ET_ENOMEM ? no_memory(d) : wrong(d, &view, "has sizes that no surface has");
    status = fill_reals(d, s->u, &array[0], -most, most);
    if (!status && !et_knots_valid(s->u, s->nu + s->p + 1, s->p))
        status = wrong(d, &array[0], "is no knot vector: it decreases, or its domain is empty");
    if (!status)
        status = fill_reals(d, s->v, &array[1], -most, most);
    if (!status && !et_knots_valid(s->v, s->nv + s->q + 1, s->q))
        status = wrong(d, &array[1], "is no knot vector: it decreases, or its domain is empty");
    if (!status)
        status = fill_points(d, s->points, &array[2]);
    if (!status && rational)
        status = fill_reals(d, s->weights, &array[3], 0x1p-1074, most);
    return status;
}

static et_status read_views(const source *d, et_surface_file *s, const place *top)
{
    place at, closed = { json_object_get(top->value, "closed"), "closed" };
    et_status status = member(d, &at, top, "views");
    for (size_t w = 0; w < 2 && !status; w++)
        status = read_view(d, &s->fit.shell.view[w], &at, view_name[w]);
    if (!status && !et_shell_valid(&s->fit.shell))
        status = wrong(d, &at, "bottom and top differ in degrees, in sizes, or in being rational");
    if (!status && closed.value && !json_is_boolean(closed.value))
        status = wrong(d, &closed, "is neither true nor false");
    if (!status && closed.value && json_is_true(closed.value) != (et_shell_closed(&s->fit.shell) != 0))
        status = wrong(d, &closed, "does not fit the views");
    return status;
}

et_status et_json_read_surface(et_surface_file *surface, const char *path, et_message *message)
{
    source d = { shown(path), message };
    et_surface_file read;
    json_t *document = NULL;
    if (!surface || !path)
        return et_status_fail(message, ET_EINVAL, "no file to read");
    memset(&read, 0, sizeof read);
    et_status status = load(&d, &document, path, surface_format);
    if (status)
        return status;
    place top = { document, "" };
    status = read_options(&d, &read.options, &top);
    if (!status)
        status = read_error(&d, &read, &top);
    if (!status)
        status = get_frame(&d, &read.frame, &top);
    if (!status)
        status = read_data(&d, &read, &top);
    if (!status)
        status = read_views(&d, &read, &top);
    json_decref(document);
    if (status)
        et_json_free_surface(&read);
    else
        *surface = read;
    return status;
}

void et_json_free_surface(et_surface_file *surface)
{
    if (!surface)
        return;
    et_fit_free(&surface->fit);
    free(surface->uv);
    memset(surface, 0, sizeof *surface);
}
