#include "etalon/io/json.h"
#include "gen.h"
#include "some_shell.h"
#include <errno.h>
#include <jansson.h>
#include <locale.h>
#include <math.h>

enum { PATH = 256 };

/* ---- random content ---- */

/* A finite real of any size and any bits. */
static double any_real(gen *g)
{
    uint64_t bits;
    double x;

    switch (gen_upto(g, 5)) {
    case 0: return gen_real(g, 0, 1);
    case 1: return gen_real(g, -1, 1);
    case 2: return -0.0;
    case 3: return (double)gen_upto(g, UINT64_C(1) << 60);
    case 4: return gen_real(g, 0, 1e-320);
    default: bits = gen_upto(g, UINT64_MAX); break;
    }
    memcpy(&x, &bits, sizeof x);
    return isfinite(x) ? x : 0x1.fffffffffffffp1023;
}

static double positive(gen *g)
{
    const double x = fabs(any_real(g));

    return x > 0 ? x : 1;
}

static double not_negative(gen *g)
{
    return fabs(any_real(g));
}

static size_t any_count(gen *g, size_t least)
{
    return gen_chance(g, 8) ? SIZE_MAX / 2 : least + (size_t)gen_upto(g, 50000);
}

static et_vec3 any_point(gen *g)
{
    const et_vec3 p = { any_real(g), any_real(g), any_real(g) };

    return p;
}

static et_frame any_frame(gen *g)
{
    const et_frame f = { any_point(g), { positive(g), positive(g), positive(g) } };

    return f;
}

static et_som_quality any_quality(gen *g)
{
    const double a = not_negative(g), b = not_negative(g);
    const et_som_quality q = { not_negative(g), gen_real(g, 0, 1), a < b ? a : b, a < b ? b : a, any_count(g, 0) };

    return q;
}

static void any_net(gen *g, et_net_file *n)
{
    memset(n, 0, sizeof *n);
    n->net = (et_doublenet){ 2 + (size_t)gen_upto(g, 4), 2 + (size_t)gen_upto(g, 4) };
    const size_t nov = et_doublenet_nov(n->net);
    n->weights = malloc(nov * sizeof *n->weights);
    for (size_t c = 0; n->weights && c < nov; c++)
        n->weights[c] = any_point(g);
    n->frame = any_frame(g);
    n->options = (et_som_options){ any_count(g, 1), 1 - gen_real(g, 0, 0.99), not_negative(g) };
    n->seed = gen_upto(g, UINT64_MAX);
    n->training = any_quality(g);
    n->final = any_quality(g);
}

/* 0 <= t[0] <= ... <= 1. */
static double *any_parameters(gen *g, size_t n)
{
    double *const t = malloc(n * sizeof *t);

    for (size_t k = 0; t && k < n; k++)
        t[k] = k == 0 ? gen_real(g, 0, 1) : gen_real(g, t[k - 1], 1);
    return t;
}

static bool any_surface(gen *g, et_surface_file *s, int closed)
{
    memset(s, 0, sizeof *s);
    if (some_shell(g, &s->fit.shell, closed) != ET_OK)
        return false;
    s->fit.data = (et_doublenet){ 2 + (size_t)gen_upto(g, 3), 2 + (size_t)gen_upto(g, 3) };
    for (size_t w = 0; w < 2; w++) {
        s->fit.s[w] = any_parameters(g, s->fit.data.nx);
        s->fit.r[w] = any_parameters(g, s->fit.data.ny);
    }
    s->fit.flat = any_count(g, 0);
    s->options.approach = (et_fit_approach)gen_upto(g, ET_FIT_JOINT);
    s->options.method = (et_param_method)gen_upto(g, ET_PARAM_EXPONENTIAL);
    s->options.knots = (et_knotrule_kind)gen_upto(g, ET_KNOTRULE_AVERAGING);
    s->options.algebra = (et_linalg_method)gen_upto(g, ET_LINALG_SVD);
    s->options.corners = (et_fit_corners)gen_upto(g, ET_CORNERS_INTERPOLATED);
    s->options.p = 1 + (size_t)gen_upto(g, 4);
    s->options.q = 1 + (size_t)gen_upto(g, 4);
    s->options.control = (et_doublenet){ s->options.p + 1 + (size_t)gen_upto(g, 9), s->options.q + 1 + (size_t)gen_upto(g, 9) };
    s->frame = any_frame(g);
    s->error = (et_fit_error){ not_negative(g), not_negative(g), not_negative(g), not_negative(g) };
    s->seam_gap = closed ? 0 : not_negative(g);
    if (gen_chance(g, 2)) {
        const size_t n = 2 * et_doublenet_nov(s->fit.data);
        s->uv = malloc(n * sizeof *s->uv);
        for (size_t k = 0; s->uv && k < n; k++)
            s->uv[k] = gen_real(g, 0, 1);
    }
    return true;
}

/* ---- bit for bit ---- */

static bool same(const void *a, const void *b, size_t n)
{
    return (!a && !b) || (a && b && memcmp(a, b, n) == 0);
}

static bool same_quality(const et_som_quality *a, const et_som_quality *b)
{
    return same(&a->qe, &b->qe, sizeof a->qe) && same(&a->te, &b->te, sizeof a->te) && same(&a->min_error, &b->min_error, sizeof a->min_error) &&
           same(&a->max_error, &b->max_error, sizeof a->max_error) && a->steps == b->steps;
}

static bool same_frame(const et_frame *a, const et_frame *b)
{
    return same(&a->offset, &b->offset, sizeof a->offset) && same(&a->scale, &b->scale, sizeof a->scale);
}

static bool same_net(const et_net_file *a, const et_net_file *b)
{
    return a->net.nx == b->net.nx && a->net.ny == b->net.ny && same(a->weights, b->weights, et_doublenet_nov(a->net) * sizeof *a->weights) &&
           same_frame(&a->frame, &b->frame) && a->options.iterations == b->options.iterations &&
           same(&a->options.alpha0, &b->options.alpha0, sizeof(double)) && same(&a->options.sigma0, &b->options.sigma0, sizeof(double)) &&
           a->seed == b->seed && same_quality(&a->training, &b->training) && same_quality(&a->final, &b->final);
}

static bool same_view(const et_surface *a, const et_surface *b)
{
    const size_t n = a->nu * a->nv;

    return a->p == b->p && a->q == b->q && a->nu == b->nu && a->nv == b->nv && same(a->u, b->u, (a->nu + a->p + 1) * sizeof(double)) &&
           same(a->v, b->v, (a->nv + a->q + 1) * sizeof(double)) && same(a->points, b->points, n * sizeof *a->points) &&
           same(a->weights, b->weights, n * sizeof(double));
}

static bool same_options(const et_fit_options *a, const et_fit_options *b)
{
    return a->approach == b->approach && a->method == b->method && a->knots == b->knots && a->algebra == b->algebra && a->corners == b->corners &&
           a->p == b->p && a->q == b->q && a->control.nx == b->control.nx && a->control.ny == b->control.ny;
}

static bool same_surface(const et_surface_file *a, const et_surface_file *b)
{
    const et_doublenet d = a->fit.data;
    bool ok = same_options(&a->options, &b->options) && same_frame(&a->frame, &b->frame) && d.nx == b->fit.data.nx && d.ny == b->fit.data.ny;

    for (size_t w = 0; ok && w < 2; w++)
        ok = same_view(&a->fit.shell.view[w], &b->fit.shell.view[w]) && same(a->fit.s[w], b->fit.s[w], d.nx * sizeof(double)) &&
             same(a->fit.r[w], b->fit.r[w], d.ny * sizeof(double));
    return ok && a->fit.flat == b->fit.flat && same(&a->error.nov, &b->error.nov, sizeof(double)) &&
           same(&a->error.non, &b->error.non, sizeof(double)) &&
           same(&a->error.greatest, &b->error.greatest, sizeof(double)) && same(&a->error.corner, &b->error.corner, sizeof(double)) &&
           same(&a->seam_gap, &b->seam_gap, sizeof(double)) && same(a->uv, b->uv, 2 * et_doublenet_nov(d) * sizeof(double));
}

/* ---- reading what is given as bytes, with the promises that always hold ---- */

static bool spill(const char *path, const char *bytes, size_t n)
{
    FILE *const f = fopen(path, "wb");
    const bool ok = f && fwrite(bytes, 1, n, f) == n;

    return f && fclose(f) == 0 && ok;
}

typedef enum { NET, SURFACE } kind;

/* Read and free; ok: on failure *file is as it was and the sentence begins with the file's name. */
static et_status read_any(gen *g, kind k, const char *path, et_message *message, bool *ok)
{
    et_net_file n, n_was;
    et_surface_file s, s_was;
    char place[PATH + 4];

    memset(&n, 0xAB, sizeof n);
    memset(&s, 0xAB, sizeof s);
    n_was = n;
    s_was = s;
    message->text[0] = 0;
    const et_status status = k == NET ? et_json_read_net(&n, path, message) : et_json_read_surface(&s, path, message);
    if (status != ET_OK) {
        snprintf(place, sizeof place, "%s:", path);
        *ok = gen_check(g, memcmp(&n, &n_was, sizeof n) == 0 && memcmp(&s, &s_was, sizeof s) == 0, "*file changed") &&
              gen_check(g, status == ET_EFORMAT, "status %s", et_status_text(status)) &&
              gen_check(g, strncmp(message->text, place, strlen(place)) == 0, "message %s", message->text);
        return status;
    }
    if (k == NET) {
        *ok = gen_check(g, et_doublenet_valid(n.net) && et_vec3_finite(n.weights, et_doublenet_nov(n.net)), "not a valid net");
        *ok = *ok && gen_check(g, et_json_write_net("/dev/null", &n, NULL) == ET_OK, "read what cannot be written");
        et_json_free_net(&n);
    } else {
        *ok = gen_check(g, et_shell_valid(&s.fit.shell) && et_doublenet_valid(s.fit.data), "not a valid shell");
        *ok = *ok && gen_check(g, et_json_write_surface("/dev/null", &s, NULL) == ET_OK, "read what cannot be written");
        et_json_free_surface(&s);
    }
    return status;
}

/* A file's bytes: a random net or surface, as written. */
static char *some_file(gen *g, kind k, size_t *size)
{
    et_net_file n;
    et_surface_file s;
    char path[PATH], *bytes = NULL;

    some_path(path, ".json");
    if (k == NET) {
        any_net(g, &n);
        bytes = et_json_write_net(path, &n, NULL) == ET_OK ? whole_file(path, size) : NULL;
        et_json_free_net(&n);
    } else if (any_surface(g, &s, (int)gen_upto(g, 1))) {
        bytes = et_json_write_surface(path, &s, NULL) == ET_OK ? whole_file(path, size) : NULL;
        et_json_free_surface(&s);
    }
    unlink(path);
    return bytes;
}

/* Every shorter part of a valid file is refused (but the one that lacks the last line's end alone). */
static verdict truncated(gen *g, kind k)
{
    size_t size = 0;
    char path[PATH], *const bytes = some_file(g, k, &size);
    et_message message;
    bool ok = gen_check(g, bytes != NULL, "not written");

    some_path(path, ".json");
    for (size_t from = 0; ok && from < 8; from++) {
        const size_t n = (size_t)gen_upto(g, size - 2);
        ok = spill(path, bytes, n) && gen_check(g, read_any(g, k, path, &message, &ok) == ET_EFORMAT, "read %zu bytes of %zu", n, size) && ok;
    }
    ok = ok && spill(path, bytes, size - 1) && gen_check(g, read_any(g, k, path, &message, &ok) == ET_OK, "%s", message.text) && ok;
    unlink(path);
    free(bytes);
    return ok ? PASS : FAIL;
}

/* Bytes altered, doubled, dropped: read or refused, nothing else. */
static verdict mutated(gen *g, kind k)
{
    static const char telling[] = "0123456789-+.eE,:[]{}\"\\ \nnulltrue";
    size_t size = 0;
    char path[PATH], *const bytes = some_file(g, k, &size);
    et_message message;
    bool ok = gen_check(g, bytes != NULL, "not written");

    for (uint64_t changes = 1 + gen_upto(g, 3); ok && changes > 0; changes--) {
        const size_t at = (size_t)gen_upto(g, size - 1), n = 1 + (size_t)gen_upto(g, 9);
        if (gen_chance(g, 4) && at + n < size) {
            memmove(bytes + at, bytes + at + n, size - at - n);
            size -= n;
        } else {
            bytes[at] = gen_chance(g, 4) ? (char)gen_upto(g, 255) : telling[gen_upto(g, sizeof telling - 2)];
        }
    }
    some_path(path, ".json");
    if (ok && spill(path, bytes, size))
        gen_label(g, read_any(g, k, path, &message, &ok) == ET_OK ? "read" : "refused");
    unlink(path);
    free(bytes);
    return ok ? PASS : FAIL;
}

/* ---- faults, one by one: a small document, one member set to something else ---- */

/* What stands at `way` (names and indices, divided by dots) is replaced by `value` (JSON; null pointer: removed); the message after "FILE: ". */
typedef struct { const char *way, *value, *message; } fault;

static const fault net_faults[] = {
    { "format", "\"etalon-surface\"", "format: is not \"etalon-net\"" },
    { "format", "1", "format: is not \"etalon-net\"" },
    { "format", NULL, "format: is missing" },
    { "version", "2", "version: is not 1" },
    { "version", "1.0", "version: is not 1" },
    { "version", NULL, "version: is missing" },
    { "net", "7", "net: is not an object" },
    { "net.nx", "1", "net.nx: is too small" },
    { "net.nx", "-3", "net.nx: is not a count" },
    { "net.nx", "3.0", "net.nx: is not a count" },
    { "net.ny", NULL, "net.ny: is missing" },
    { "net.non", "19", "net.non: is 19, but follows as 12" },
    { "net.nov", "11", "net.nov: is 11, but follows as 6" },
    { "net.nor", "\"6\"", "net.nor: is not a count" },
    { "net.non", NULL, NULL },
    { "net.nov", NULL, NULL },
    { "net.nor", NULL, NULL },
    { "net.note", "[1,2]", NULL },
    { "training.iterations", "0", "training.iterations: is too small" },
    { "training.alpha0", "0", "training.alpha0: is out of range" },
    { "training.alpha0", "1.0000000000000002", "training.alpha0: is out of range" },
    { "training.alpha0", "1", NULL },
    { "training.alpha0", "true", "training.alpha0: is not a number" },
    { "training.sigma0", "-1", "training.sigma0: is out of range" },
    { "training.seed", "12", "training.seed: is not a string of decimal digits below 2^64" },
    { "training.seed", "\"\"", "training.seed: is not a string of decimal digits below 2^64" },
    { "training.seed", "\"-1\"", "training.seed: is not a string of decimal digits below 2^64" },
    { "training.seed", "\"18446744073709551616\"", "training.seed: is not a string of decimal digits below 2^64" },
    { "training.seed", "\"18446744073709551615\"", NULL },
    { "training.seed", "\"12x\"", "training.seed: is not a string of decimal digits below 2^64" },
    { "quality", NULL, "quality: is missing" },
    { "quality.training", "[]", "quality.training: is not an object" },
    { "quality.training.qe", "-1", "quality.training.qe: is out of range" },
    { "quality.training.te", "1.5", "quality.training.te: is out of range" },
    { "quality.final.te", "-0.5", "quality.final.te: is out of range" },
    { "quality.final.min_error", "7", "quality.final.max_error: is out of range" },
    { "quality.final.min_error", "-7", "quality.final.min_error: is out of range" },
    { "quality.final.steps", "-1", "quality.final.steps: is not a count" },
    { "quality.final.steps", "1e3", "quality.final.steps: is not a count" },
    { "frame", NULL, "frame: is missing" },
    { "frame.offset", "[1,2]", "frame.offset: has 2 elements, not 3" },
    { "frame.offset", "{}", "frame.offset: is not an array" },
    { "frame.offset.1", "null", "frame.offset[1]: is not a number" },
    { "frame.scale.2", "0", "frame.scale[2]: is out of range" },
    { "frame.scale.0", "-1", "frame.scale[0]: is out of range" },
    { "frame.scale.0", "5e-324", NULL },
    { "weights", NULL, "weights: is missing" },
    { "weights", "[[1,2,3]]", "weights: has 1 elements, not 6" },
    { "weights.5", "[1,2]", "weights[5]: is not an array of three numbers" },
    { "weights.0", "[1,2,3,4]", "weights[0]: is not an array of three numbers" },
    { "weights.3", "7", "weights[3]: is not an array of three numbers" },
    { "weights.2.1", "\"1\"", "weights[2]: is not an array of three numbers" },
    { "weights.2.1", "17", NULL },
};

static const fault surface_faults[] = {
    { "format", "\"etalon-net\"", "format: is not \"etalon-surface\"" },
    { "version", "0", "version: is not 1" },
    { "fit", NULL, "fit: is missing" },
    { "fit.approach", "\"better\"", "fit.approach: is not a known name" },
    { "fit.parameters", "2", "fit.parameters: is not a string" },
    { "fit.knots", "\"\"", "fit.knots: is not a known name" },
    { "fit.algebra", "\"lu\"", "fit.algebra: is not a known name" },
    { "fit.corners", "null", "fit.corners: is not a string" },
    { "fit.corners", NULL, "fit.corners: is missing" },
    { "fit.p", "0", "fit.p: is too small" },
    { "fit.p", "2", "fit: the degrees p, q are not below the sides nx, ny" },
    { "fit.q", "2", "fit: the degrees p, q are not below the sides nx, ny" },
    { "fit.nx", "1", "fit.nx: is too small" },
    { "error.nov", "-1", "error.nov: is out of range" },
    { "error.non", "null", "error.non: is not a number" },
    { "error.greatest", NULL, "error.greatest: is missing" },
    { "error.corner", "\"0\"", "error.corner: is not a number" },
    { "seam_gap", "-1e-300", "seam_gap: is out of range" },
    { "seam_gap", "[0]", "seam_gap: is not a number" },
    { "closed", "0", "closed: is neither true nor false" },
    { "closed", "false", "closed: does not fit the views" },
    { "closed", NULL, NULL },
    { "frame.scale", "1", "frame.scale: is not an array" },
    { "data", "null", "data: is not an object" },
    { "data.nx", "1", "data.nx: is too small" },
    { "data.nx", "9223372036854775807", "data: has too many nodes" },
    { "data.nx", "3", "data.bottom.s: has 2 elements, not 3" },
    { "data.ny", "3", "data.bottom.r: has 2 elements, not 3" },
    { "data.ny", "1000000000000", "data.bottom.r: has 2 elements, not 1000000000000" },
    { "data.flat", "0.5", "data.flat: is not a count" },
    { "data.top", NULL, "data.top: is missing" },
    { "data.bottom.s.0", "-0.5", "data.bottom.s[0]: is out of range" },
    { "data.top.r.1", "1.5", "data.top.r[1]: is out of range" },
    { "data.top.s", "[0.75, 0.5]", "data.top.s: decreases" },
    { "data.top.s", "[0.5, 0.5]", NULL },
    { "data.uv", NULL, "data.uv: is missing" },
    { "data.uv", "0", "data.uv: is not an array" },
    { "data.uv", "[[0,0]]", "data.uv: has 1 elements, not 4" },
    { "data.uv", "[[0,0],[0,1],[1,0],[1,1]]", NULL },
    { "data.uv", "[[0,0],[0,1],[1,0],[1]]", "data.uv[3]: is not an array of two numbers" },
    { "data.uv", "[[0,0],[0,1],[1,0],[1,1.5]]", "data.uv[3]: is out of range" },
    { "data.uv", "[[0,0],[-1,1],[1,0],[1,1]]", "data.uv[1]: is out of range" },
    { "views", NULL, "views: is missing" },
    { "views.bottom", NULL, "views.bottom: is missing" },
    { "views.top.nu", "3", "views.top.u: has 4 elements, not 5" },
    { "views.top.nv", "3", "views.top.v: has 4 elements, not 5" },
    { "views.top.nu", "1", "views.top.nu: is too small" },
    { "views.bottom.nu", "9223372036854775807", "views.bottom.u: has 4 elements, not 9223372036854775809" },
    { "views.bottom.p", "2", "views.bottom: the degrees p, q are not below the sizes nu, nv" },
    { "views.bottom.q", "2", "views.bottom: the degrees p, q are not below the sizes nu, nv" },
    { "views.bottom.p", "0", "views.bottom.p: is too small" },
    { "views.bottom.u.1", "2", "views.bottom.u: is no knot vector: it decreases, or its domain is empty" },
    { "views.top.v", "[0,0,0,1]", "views.top.v: is no knot vector: it decreases, or its domain is empty" },
    { "views.top.u.0", "\"0\"", "views.top.u[0]: is not a number" },
    { "views.top.points", "[]", "views.top.points: has 0 elements, not 4" },
    { "views.top.points.3", "[1,2]", "views.top.points[3]: is not an array of three numbers" },
    { "views.top.points.3.2", "5", "closed: does not fit the views" },
    { "views.top.weights", NULL, "views.top.weights: is missing" },
    { "views.top.weights", "[1,1,1]", "views.top.weights: has 3 elements, not 4" },
    { "views.top.weights", "[1,1,1,0]", "views.top.weights[3]: is out of range" },
    { "views.top.weights", "[1,1,1,1]", "views: bottom and top differ in degrees, in sizes, or in being rational" },
    { "views.top.u", "[0,0,1,2]", "closed: does not fit the views" },
};

/* The smallest net: 2 x 3; the smallest surface: bilinear, closed, data 2 x 2. */
static bool write_smallest(kind k, const char *path)
{
    et_vec3 weights[6] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 }, { 0, 1, 1 } };
    double ends[2] = { 0, 1 };
    const et_frame frame = { { 0, 0, 0 }, { 1, 1, 1 } };
    const et_som_quality quality = { 0.5, 0.25, 0, 1, 10 };
    const et_net_file n = { { 2, 3 }, weights, frame, { 10, 0.5, 0 }, 7, quality, quality };
    et_surface_file s;

    if (k == NET)
        return et_json_write_net(path, &n, NULL) == ET_OK;
    memset(&s, 0, sizeof s);
    if (et_shell_new(&s.fit.shell, 1, 1, (et_doublenet){ 2, 2 }, 0) != ET_OK)
        return false;
    for (size_t w = 0; w < 2; w++) {
        et_surface *const v = &s.fit.shell.view[w];
        v->u[2] = v->u[3] = v->v[2] = v->v[3] = 1;
        memcpy(v->points, weights, 4 * sizeof *weights);
        s.fit.s[w] = s.fit.r[w] = ends;
    }
    s.fit.data = s.options.control = (et_doublenet){ 2, 2 };
    s.options.p = s.options.q = 1;
    s.frame = frame;
    const bool ok = et_json_write_surface(path, &s, NULL) == ET_OK;
    et_shell_free(&s.fit.shell);
    return ok;
}

static json_t *part_of(json_t *in, const char *name)
{
    return json_is_array(in) ? json_array_get(in, (size_t)strtoul(name, NULL, 10)) : json_object_get(in, name);
}

static bool replace(json_t *document, const char *way, const char *value)
{
    char names[100], *last = names;
    json_t *in = document;

    snprintf(names, sizeof names, "%s", way);
    for (char *dot = strchr(last, '.'); dot; dot = strchr(last, '.')) {
        *dot = 0;
        in = part_of(in, last);
        last = dot + 1;
    }
    if (!value)
        return json_object_del(in, last) == 0;
    json_t *const new = json_loads(value, JSON_DECODE_ANY, NULL);
    return json_is_array(in) ? json_array_set_new(in, (size_t)strtoul(last, NULL, 10), new) == 0 : json_object_set_new(in, last, new) == 0;
}

static bool fault_is_told(gen *g, kind k, const fault *f)
{
    char path[PATH], wanted[2 * PATH];
    et_message message = { "" };
    bool ok = true;

    some_path(path, ".json");
    if (!write_smallest(k, path))
        return gen_check(g, false, "not written");
    json_t *const document = json_load_file(path, 0, NULL);
    ok = replace(document, f->way, f->value) && json_dump_file(document, path, JSON_REAL_PRECISION(17)) == 0;
    json_decref(document);
    ok = gen_check(g, ok, "no document");
    snprintf(wanted, sizeof wanted, "%s: %s", path, f->message ? f->message : "");
    const et_status status = ok ? read_any(g, k, path, &message, &ok) : ET_OK;
    ok = ok && gen_check(g, (status == ET_OK) == !f->message, "%s = %s: status %s", f->way, f->value ? f->value : "", et_status_text(status));
    ok = ok && gen_check(g, status == ET_OK || strcmp(message.text, wanted) == 0, "\"%s\", not \"%s\"", message.text, wanted);
    unlink(path);
    return ok;
}

static verdict faulty(gen *g, kind k, const fault *list, size_t n)
{
    const size_t at = (size_t)gen_upto(g, n);
    bool ok = true;

    for (size_t i = 0; at == 0 && ok && i < n; i++)
        ok = fault_is_told(g, k, &list[i]);
    return ok && (at == 0 || fault_is_told(g, k, &list[at - 1])) ? PASS : FAIL;
}

/* What is no JSON, or no file. */
static bool no_document(gen *g, kind k)
{
    static const char *const texts[] = { "", "7", "[]", "{", "{\"format\": \"etalon-net\", \"format\": \"etalon-net\"}", "{\"version\": 1e999}",
                                         "{\"version\": 99999999999999999999}", "{\"a\": NaN}", "{} {}", "{}x", "\xff", "{\"a\": \"\\u0000\"}" };
    const size_t deep = 100000, which = (size_t)gen_upto(g, sizeof texts / sizeof *texts);
    char path[PATH], told[2 * PATH];
    et_message message = { "" };
    bool ok = true;

    some_path(path, ".json");
    if (which == sizeof texts / sizeof *texts) {
        char *const nested = malloc(deep);
        memset(nested, '[', deep);
        spill(path, nested, deep);
        free(nested);
    } else {
        spill(path, texts[which], strlen(texts[which]));
    }
    ok = gen_check(g, read_any(g, k, path, &message, &ok) == ET_EFORMAT, "read text %zu", which) && ok;
    unlink(path);
    const et_status none = k == NET ? et_json_read_net(&(et_net_file){ .seed = 0 }, path, &message)
                                    : et_json_read_surface(&(et_surface_file){ .seam_gap = 0 }, path, &message);
    snprintf(told, sizeof told, "cannot read %s: %s", path, strerror(ENOENT));
    ok = ok && gen_check(g, none == ET_EIO && strcmp(message.text, told) == 0, "%s", message.text);
    const et_status directory = k == NET ? et_json_read_net(&(et_net_file){ .seed = 0 }, "/tmp", &message)
                                         : et_json_read_surface(&(et_surface_file){ .seam_gap = 0 }, "/tmp", &message);
    return ok && gen_check(g, directory == ET_EIO && strcmp(message.text, "cannot read /tmp: Is a directory") == 0, "%s", message.text);
}

/* ---- the net ---- */

verdict prop_json_read_net(gen *g)
{
    static const char *const names[] = { "de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8" };
    et_net_file n, got;
    char path[PATH];
    et_message message = { "" };
    bool ok, comma = false;

    any_net(g, &n);
    for (size_t k = 0; gen_chance(g, 4) && !comma && k < sizeof names / sizeof *names; k++)
        comma = setlocale(LC_NUMERIC, names[k]) != NULL;
    if (comma)
        gen_label(g, "decimal comma in the locale");
    ok = gen_check(g, et_json_write_net(some_path(path, ".json"), &n, &message) == ET_OK, "%s", message.text);
    ok = ok && gen_check(g, et_json_read_net(&got, path, &message) == ET_OK, "%s", message.text);
    setlocale(LC_NUMERIC, "C");
    if (ok) {
        ok = gen_check(g, same_net(&n, &got), "not the same");
        et_json_free_net(&got);
    }
    ok = ok && gen_check(g, et_json_read_net(NULL, path, NULL) == ET_EINVAL && et_json_read_net(&got, NULL, NULL) == ET_EINVAL, "null");
    unlink(path);
    et_json_free_net(&n);
    ok = ok && no_document(g, NET);
    return ok ? PASS : FAIL;
}

verdict prop_json_read_net_faults(gen *g)
{
    return faulty(g, NET, net_faults, sizeof net_faults / sizeof *net_faults);
}

/* One case in 2. */
verdict prop_json_read_net_truncated(gen *g)
{
    return truncated(g, NET);
}

verdict prop_json_read_net_mutated(gen *g)
{
    return mutated(g, NET);
}

/* A value that no net file holds. */
static void spoil_net(gen *g, et_net_file *n)
{
    const double bad = gen_chance(g, 2) ? NAN : gen_chance(g, 2) ? INFINITY : -1;
    const size_t last = et_doublenet_nov(n->net) - 1;

    switch (gen_upto(g, 17)) {
    case 0: n->net.nx = 1; break;
    case 1: n->net.ny = 1; break;
    case 2: n->weights[0].x = NAN; break;
    case 3: n->weights[last].z = INFINITY; break;
    case 4: n->frame.offset.y = NAN; break;
    case 5: n->frame.scale.x = 0; break;
    case 6: n->frame.scale.z = bad; break;
    case 7: n->options.iterations = 0; break;
    case 8: n->options.alpha0 = 0; break;
    case 9: n->options.alpha0 = 0x1.0000000000001p0; break;
    case 10: n->options.sigma0 = bad; break;
    case 11: n->training.qe = bad; break;
    case 12: n->final.te = gen_chance(g, 2) ? bad : 0x1.0000000000001p0; break;
    case 13: n->final.min_error = 2; n->final.max_error = 1; break;
    case 14: n->training.max_error = INFINITY; break;
    case 15: n->training.steps = SIZE_MAX / 2 + 1; break;
    case 16: n->options.iterations = SIZE_MAX / 2 + 1; break;
    default: n->final.min_error = -1; break;
    }
}

verdict prop_json_write_net(gen *g)
{
    et_net_file n;
    char path[PATH], head[200], *whole;
    et_message message = { "" };
    size_t size;
    bool ok;

    any_net(g, &n);
    some_path(path, ".json");
    ok = gen_check(g, et_json_write_net(path, &n, &message) == ET_OK, "%s", message.text);
    whole = whole_file(path, &size);
    snprintf(head, sizeof head, "{\n  \"format\": \"etalon-net\",\n  \"version\": 1,\n"
             "  \"net\": {\"nx\": %zu, \"ny\": %zu, \"non\": %zu, \"nov\": %zu, \"nor\": %zu},",
             n.net.nx, n.net.ny, et_doublenet_non(n.net), et_doublenet_nov(n.net), et_doublenet_nor(n.net));
    ok = ok && gen_check(g, whole && strncmp(whole, head, strlen(head)) == 0 && whole[size - 1] == '\n', "head");
    /* A second reader: the first weight, and the last, as jansson sees them. */
    json_t *const document = whole ? json_loads(whole, JSON_REJECT_DUPLICATES, NULL) : NULL;
    const json_t *const weights = json_object_get(document, "weights");
    const size_t nov = et_doublenet_nov(n.net);
    const double x = json_real_value(json_array_get(json_array_get(weights, 0), 0));
    const double z = json_real_value(json_array_get(json_array_get(weights, nov - 1), 2));
    ok = ok && gen_check(g, same(&x, &n.weights[0].x, sizeof x) && same(&z, &n.weights[nov - 1].z, sizeof z), "weights");
    json_decref(document);
    free(whole);
    unlink(path);
    ok = ok && gen_check(g, et_json_write_net("/dev/full", &n, &message) == ET_EIO, "/dev/full");
    ok = ok && gen_check(g, et_json_write_net(NULL, &n, NULL) == ET_EINVAL && et_json_write_net(path, NULL, NULL) == ET_EINVAL, "null");
    spoil_net(g, &n);
    ok = ok && gen_check(g, et_json_write_net(path, &n, NULL) == ET_EINVAL && access(path, F_OK) != 0, "a bad value is written");
    et_json_free_net(&n);
    ok = ok && gen_check(g, et_json_write_net(path, &n, NULL) == ET_EINVAL, "no weights");
    return ok ? PASS : FAIL;
}

verdict prop_json_free_net(gen *g)
{
    et_net_file n, zero;

    memset(&zero, 0, sizeof zero);
    any_net(g, &n);
    et_json_free_net(NULL);
    et_json_free_net(&n);
    const bool ok = gen_check(g, memcmp(&n, &zero, sizeof n) == 0, "not zeroed");
    et_json_free_net(&n);
    return ok ? PASS : FAIL;
}

/* ---- the surface ---- */

verdict prop_json_read_surface(gen *g)
{
    et_surface_file s, got;
    char path[PATH];
    et_message message = { "" };
    const int closed = (int)gen_upto(g, 1);
    bool ok;

    if (!any_surface(g, &s, closed))
        return FAIL;
    ok = gen_check(g, et_json_write_surface(some_path(path, ".json"), &s, &message) == ET_OK, "%s", message.text);
    ok = ok && gen_check(g, et_json_read_surface(&got, path, &message) == ET_OK, "%s", message.text);
    if (ok) {
        ok = gen_check(g, same_surface(&s, &got), "not the same") &&
             gen_check(g, et_shell_closed(&s.fit.shell) == et_shell_closed(&got.fit.shell) && (!closed || et_shell_closed(&got.fit.shell)), "closed");
        et_json_free_surface(&got);
    }
    ok = ok && gen_check(g, et_json_read_surface(NULL, path, NULL) == ET_EINVAL && et_json_read_surface(&got, NULL, NULL) == ET_EINVAL, "null");
    unlink(path);
    et_json_free_surface(&s);
    ok = ok && no_document(g, SURFACE);
    return ok ? PASS : FAIL;
}

verdict prop_json_read_surface_faults(gen *g)
{
    return faulty(g, SURFACE, surface_faults, sizeof surface_faults / sizeof *surface_faults);
}

/* One case in 2. */
verdict prop_json_read_surface_truncated(gen *g)
{
    return truncated(g, SURFACE);
}

verdict prop_json_read_surface_mutated(gen *g)
{
    return mutated(g, SURFACE);
}

static void spoil_surface(gen *g, et_surface_file *s)
{
    const double bad = gen_chance(g, 2) ? NAN : gen_chance(g, 2) ? INFINITY : -1;
    const size_t w = (size_t)gen_upto(g, 1);
    et_surface *const v = &s->fit.shell.view[w];

    switch (gen_upto(g, 20)) {
    case 0: v->points[0].x = NAN; break;
    case 1: v->u[0] = 7; break;
    case 2: v->v[v->nv + v->q] = INFINITY; break;
    case 3: s->fit.data.nx = 1; break;
    case 4: s->fit.s[w][0] = bad; break;
    case 5: s->fit.r[w][s->fit.data.ny - 1] = 0x1.0000000000001p0; break;
    case 6: s->fit.s[w][0] = 1; s->fit.s[w][1] = 0.5; break;
    case 7: s->options.approach = (et_fit_approach)3; break;
    case 8: s->options.method = (et_param_method)4; break;
    case 9: s->options.knots = (et_knotrule_kind)4; break;
    case 10: s->options.algebra = (et_linalg_method)3; break;
    case 11: s->options.corners = (et_fit_corners)3; break;
    case 12: s->options.p = s->options.control.nx; break;
    case 13: s->options.q = 0; break;
    case 14: s->frame.scale.y = -1; break;
    case 15: s->error.nov = bad; break;
    case 16: s->error.corner = bad; break;
    case 17: s->seam_gap = bad; break;
    case 18: s->fit.flat = SIZE_MAX / 2 + 1; break;
    case 19: s->options.q = s->options.control.ny; break;
    default:
        if (s->uv)
            s->uv[2 * et_doublenet_nov(s->fit.data) - 1] = 0x1.0000000000001p0;
        else
            s->options.p = 0;
        break;
    }
}

verdict prop_json_write_surface(gen *g)
{
    static const char *const names[5][4] = { { "conventional", "improved", "joint" },
                                             { "uniform", "chord", "centripetal", "exponential" },
                                             { "piegl", "faithful", "uniform", "averaging" },
                                             { "qr", "cholesky", "svd" },
                                             { "default", "free", "interpolated" } };
    et_surface_file s;
    char path[PATH], head[300], *whole;
    et_message message = { "" };
    size_t size;
    bool ok;

    if (!any_surface(g, &s, (int)gen_upto(g, 1)))
        return FAIL;
    some_path(path, ".json");
    ok = gen_check(g, et_json_write_surface(path, &s, &message) == ET_OK, "%s", message.text);
    whole = whole_file(path, &size);
    snprintf(head, sizeof head,
             "{\n  \"format\": \"etalon-surface\",\n  \"version\": 1,\n  \"fit\": {\"approach\": \"%s\", \"parameters\": \"%s\", \"knots\": \"%s\", "
             "\"algebra\": \"%s\", \"corners\": \"%s\",\n",
             names[0][s.options.approach], names[1][s.options.method], names[2][s.options.knots],
             names[3][s.options.algebra], names[4][s.options.corners]);
    ok = ok && gen_check(g, whole && strncmp(whole, head, strlen(head)) == 0 && whole[size - 1] == '\n', "head");
    ok = ok && gen_check(g, strstr(whole, et_shell_closed(&s.fit.shell) ? "\"closed\": true" : "\"closed\": false") != NULL, "closed");
    /* A second reader: a control point and a knot of the top, as jansson sees them. */
    json_t *const document = whole ? json_loads(whole, JSON_REJECT_DUPLICATES, NULL) : NULL;
    const json_t *const top = json_object_get(json_object_get(document, "views"), "top");
    const et_surface *const v = &s.fit.shell.view[ET_TOP];
    const double y = json_real_value(json_array_get(json_array_get(json_object_get(top, "points"), v->nv), 1));
    const double u = json_real_value(json_array_get(json_object_get(top, "u"), v->nu));
    ok = ok && gen_check(g, same(&y, &v->points[v->nv].y, sizeof y) && same(&u, &v->u[v->nu], sizeof u), "the top view");
    json_decref(document);
    free(whole);
    unlink(path);
    ok = ok && gen_check(g, et_json_write_surface("/dev/full", &s, &message) == ET_EIO, "/dev/full");
    ok = ok && gen_check(g, et_json_write_surface(NULL, &s, NULL) == ET_EINVAL && et_json_write_surface(path, NULL, NULL) == ET_EINVAL, "null");
    spoil_surface(g, &s);
    ok = ok && gen_check(g, et_json_write_surface(path, &s, NULL) == ET_EINVAL && access(path, F_OK) != 0, "a bad value is written");
    et_json_free_surface(&s);
    return ok ? PASS : FAIL;
}

verdict prop_json_free_surface(gen *g)
{
    et_surface_file s, zero;

    memset(&zero, 0, sizeof zero);
    if (!any_surface(g, &s, 1))
        return FAIL;
    et_json_free_surface(NULL);
    et_json_free_surface(&s);
    const bool ok = gen_check(g, memcmp(&s, &zero, sizeof s) == 0, "not zeroed");
    et_json_free_surface(&s);
    return ok ? PASS : FAIL;
}
