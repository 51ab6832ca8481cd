#include "etalon/io/iges.h"
#include "golden.h"
#include "some_shell.h"
#include <ctype.h>
#include <float.h>
#include <math.h>

enum { RECORD = 81 };                     /* 80 columns and the end of the line */

/* Record k of the file, its 80 columns. */
static const char *record(const char *text, size_t k)
{
    return text + RECORD * k;
}

static size_t number_at(const char *columns, size_t n)
{
    char buffer[16] = "";

    memcpy(buffer, columns, n);
    return (size_t)strtoul(buffer, NULL, 10);
}

/* Every record has 80 columns, its section's letter in column 73, its number in 74-80; sections S, G, D, P, T in this order. */
static bool records_are(gen *g, const char *text, size_t size, size_t count[5])
{
    static const char letters[] = "SGDPT";
    size_t s = 0;
    bool ok = gen_check(g, size % RECORD == 0, "not records of 80 columns");

    memset(count, 0, 5 * sizeof *count);
    for (size_t k = 0; ok && k < size / RECORD; k++) {
        const char *const c = record(text, k);

        while (s < 4 && c[72] != letters[s])
            s++;
        count[s]++;
        ok = gen_check(g, c[80] == '\n' && memchr(c, '\n', 80) == NULL && c[72] == letters[s], "record %zu", k + 1);
        ok = ok && gen_check(g, number_at(c + 73, 7) == count[s] && c[79] != ' ', "record %zu is not numbered %zu", k + 1, count[s]);
    }
    return ok && gen_check(g, count[0] == 1 && count[1] >= 1 && count[2] == 4 && count[3] >= 2 && count[4] == 1, "section sizes");
}

static bool terminate_is(gen *g, const char *c, const size_t count[5])
{
    bool ok = true;

    for (size_t s = 0; s < 4; s++)
        ok = ok && c[8 * s] == "SGDP"[s] && number_at(c + 8 * s + 1, 7) == count[s];
    for (size_t k = 32; k < 72; k++)
        ok = ok && c[k] == ' ';
    return gen_check(g, ok, "terminate record");
}

/* Directory entry: type, pointer and number of parameter records, form, label. */
static bool directory_is(gen *g, const char *c, size_t view, size_t from, size_t records)
{
    const char *const d = c + RECORD;
    bool ok = number_at(c, 8) == 128 && number_at(c + 8, 8) == from && number_at(d, 8) == 128 && number_at(d + 24, 8) == records;

    ok = ok && number_at(d + 32, 8) == 0 && memcmp(c + 64, "00000000", 8) == 0 && memcmp(d + 56, view ? "     TOP" : "  BOTTOM", 8) == 0;
    return gen_check(g, ok && number_at(c + 16, 8) == 0 && number_at(c + 48, 8) == 0, "directory entry %zu", view);
}

/* Global parameters: free-format fields of all G records; text lengths are honoured. */
static size_t global_fields(char field[32][80], const char *text, size_t from, size_t records)
{
    char all[1024] = "";
    size_t n = 0;
    const char *c = all;

    for (size_t k = 0; k < records && k < 12; k++) {
        size_t width = 72;

        while (width && record(text, from + k)[width - 1] == ' ')
            width--;
        strncat(all, record(text, from + k), width);
    }
    while (*c && n < 32) {
        char *end;
        const size_t length = (size_t)strtoul(c, &end, 10);
        const char *stop = end > c && *end == 'H' ? end + 1 + length : c + strcspn(c, ",;");

        snprintf(field[n++], 80, "%.*s", (int)(stop - c), c);
        if (*stop == ';')
            break;
        c = stop + 1;
    }
    return n;
}

/* A real of the file: D for e. */
static double real_of(const char *token)
{
    char buffer[80];

    snprintf(buffer, sizeof buffer, "%s", token);
    for (char *c = buffer; *c; c++)
        *c = *c == 'D' ? 'e' : *c;
    return strtod(buffer, NULL);
}

static bool globals_are(gen *g, const char *text, const size_t count[5], const et_shell *own)
{
    char f[32][80];
    const size_t n = global_fields(f, text, count[0], count[1]);
    double most = 0;
    bool ok = gen_check(g, n == 25, "%zu global parameters", n);

    for (size_t view = 0; view < 2; view++)
        for (size_t k = 0; k < own->view[view].nu * own->view[view].nv; k++)
            for (int d = 0; d < 3; d++)
                most = fmax(most, fabs((&own->view[view].points[k].x)[d]));
    ok = ok && gen_check(g, strcmp(f[0], "1H,") == 0 && strcmp(f[1], "1H;") == 0, "delimiters");
    ok = ok && gen_check(g, strcmp(f[13], "2") == 0 && strcmp(f[14], "2HMM") == 0, "units");
    ok = ok && gen_check(g, strcmp(f[17], f[24]) == 0 && strcmp(f[17], "15H20000101.000000") == 0, "dates");
    ok = ok && gen_check(g, real_of(f[19]) == most && real_of(f[18]) > 0, "greatest coordinate %s, resolution %s", f[19], f[18]);
    return ok && gen_check(g, strcmp(f[22], "11") == 0 && strcmp(f[6], "32") == 0 && real_of(f[12]) == 1, "version, bits, scale");
}

/* A walk over the fields of one entity. */
typedef struct { const char *text; size_t at, last, column, entity; char end; bool ok; } walk;

static bool real_is_well_formed(const char *token)
{
    const char *const point = strchr(token, '.');

    return point && strspn(token, "-0123456789.D") == strlen(token) && strchr(point + 1, '.') == NULL;
}

static const char *next(walk *w, char token[64])
{
    size_t n = 0;

    token[0] = '\0';
    while (w->ok && w->at < w->last) {
        const char *const c = record(w->text, w->at);

        if (w->column == 0)
            w->ok = c[64] == ' ' && number_at(c + 65, 7) == w->entity;
        if (w->column == 64 || c[w->column] == ' ') {
            for (size_t k = w->column; k < 64; k++)
                w->ok = w->ok && c[k] == ' ';
            w->ok = w->ok && n == 0 && w->column > 0;   /* a field is never broken, no record is empty */
            w->at++;
            w->column = 0;
            continue;
        }
        w->end = c[w->column++];
        if (w->end == ',' || w->end == ';') {
            token[n] = '\0';
            return token;
        }
        w->ok = w->ok && n < 63;
        if (w->ok)
            token[n++] = w->end;
    }
    w->ok = false;
    return token;
}

static bool next_is_size(walk *w, size_t x)
{
    char token[64], want[64];

    snprintf(want, sizeof want, "%zu", x);
    return strcmp(next(w, token), want) == 0 && w->ok;
}

static bool next_is_real(walk *w, double x)
{
    char token[64];
    const double got = real_of(next(w, token));

    return w->ok && real_is_well_formed(token) && memcmp(&got, &x, sizeof x) == 0;
}

static bool same_node(const et_surface *s, size_t a, size_t b)
{
    return s->points[a].x == s->points[b].x && s->points[a].y == s->points[b].y && s->points[a].z == s->points[b].z
           && (!s->weights || s->weights[a] == s->weights[b]);
}

static bool header_is(walk *w, const et_surface *s)
{
    size_t closed_u = 1, closed_v = 1;
    bool ok;

    for (size_t j = 0; j < s->nv; j++)
        closed_u = closed_u && same_node(s, j, s->nv * (s->nu - 1) + j);
    for (size_t i = 0; i < s->nu; i++)
        closed_v = closed_v && same_node(s, s->nv * i, s->nv * i + s->nv - 1);
    for (size_t k = 0; k <= s->p; k++)
        closed_u = closed_u && s->u[k] == s->u[0] && s->u[s->nu + k] == s->u[s->nu];
    for (size_t k = 0; k <= s->q; k++)
        closed_v = closed_v && s->v[k] == s->v[0] && s->v[s->nv + k] == s->v[s->nv];
    closed_u = closed_u && s->u[s->p + 1] != s->u[0] && s->u[s->nu - 1] != s->u[s->nu];
    closed_v = closed_v && s->v[s->q + 1] != s->v[0] && s->v[s->nv - 1] != s->v[s->nv];
    ok = next_is_size(w, 128) && next_is_size(w, s->nu - 1) && next_is_size(w, s->nv - 1) && next_is_size(w, s->p) && next_is_size(w, s->q);
    ok = ok && next_is_size(w, closed_u) && next_is_size(w, closed_v) && next_is_size(w, s->weights ? 0 : 1);
    return ok && next_is_size(w, 0) && next_is_size(w, 0);
}

static bool entity_is(gen *g, walk *w, const et_surface *s)
{
    const size_t nodes = s->nu * s->nv;
    bool ok = gen_check(g, header_is(w, s), "counts, degrees or flags");

    for (size_t k = 0; ok && k < s->nu + s->p + 1; k++)
        ok = gen_check(g, next_is_real(w, s->u[k]), "knot %zu of u", k);
    for (size_t k = 0; ok && k < s->nv + s->q + 1; k++)
        ok = gen_check(g, next_is_real(w, s->v[k]), "knot %zu of v", k);
    for (size_t k = 0; ok && k < nodes; k++) {
        const size_t from = k % s->nu * s->nv + k / s->nu;

        ok = gen_check(g, next_is_real(w, s->weights ? s->weights[from] : 1), "weight %zu", k);
    }
    for (size_t k = 0; ok && k < nodes; k++) {
        const et_vec3 p = s->points[k % s->nu * s->nv + k / s->nu];

        ok = gen_check(g, next_is_real(w, p.x) && next_is_real(w, p.y) && next_is_real(w, p.z), "point %zu", k);
    }
    ok = ok && gen_check(g, next_is_real(w, s->u[s->p]) && next_is_real(w, s->u[s->nu]), "range of u");
    ok = ok && gen_check(g, next_is_real(w, s->v[s->q]) && w->end == ',' && next_is_real(w, s->v[s->nv]) && w->end == ';', "range of v");
    for (const char *c = record(w->text, w->at); ok && w->column < 64; w->column++)
        ok = gen_check(g, c[w->column] == ' ', "text behind the end");
    return ok && gen_check(g, w->at + 1 == w->last, "records behind the end");
}

static bool file_is(gen *g, const char *text, size_t size, const et_shell *own)
{
    size_t count[5], d, p, records;
    bool ok = records_are(g, text, size, count) && globals_are(g, text, count, own);

    if (!ok || !terminate_is(g, record(text, size / RECORD - 1), count))
        return false;
    d = count[0] + count[1];
    p = d + count[2];
    records = number_at(record(text, d + 1) + 24, 8);
    for (size_t view = 0; ok && view < 2; view++) {
        const size_t first = view ? records : 0, n = view ? count[3] - records : records;
        walk w = {text, p + first, p + first + n, 0, 2 * view + 1, 0, true};

        ok = directory_is(g, record(text, d + 2 * view), view, first + 1, n) && entity_is(g, &w, &own->view[view]);
    }
    return ok;
}

static bool refuses_bad(gen *g, const char *path, const et_shell *shell, const et_frame *frame)
{
    const et_frame huge = {{DBL_MAX, 0, 0}, {DBL_MAX, DBL_MAX, DBL_MAX}};
    const et_shell zero = {0};
    et_message message;
    et_shell copy = {0};
    bool ok = et_iges_write(NULL, shell, frame, &message) == ET_EINVAL && et_iges_write(path, NULL, frame, &message) == ET_EINVAL;

    ok = ok && et_iges_write(path, shell, NULL, NULL) == ET_EINVAL && et_iges_write(path, &zero, frame, &message) == ET_EINVAL;
    ok = ok && et_iges_write("/nonexistent/x.igs", shell, frame, &message) == ET_EIO && et_shell_copy(&copy, shell) == ET_OK;
    if (ok) {
        copy.view[1].points[0].x = 2;
        ok = et_iges_write(path, &copy, &huge, &message) == ET_EINVAL;
    }
    et_shell_free(&copy);
    return gen_check(g, ok, "a bad argument was taken");
}

/* At one end of one direction of a view a knot too few for a clamped one, or one too many: the curves do not end in their control points. */
static void unclamp(gen *g, et_shell *shell)
{
    et_surface *const s = &shell->view[gen_upto(g, 1)];
    const bool along_u = gen_upto(g, 1), last = gen_upto(g, 1), few = gen_upto(g, 1);
    double *const t = along_u ? s->u : s->v;
    const size_t p = along_u ? s->p : s->q, n = along_u ? s->nu : s->nv;

    if (few)
        t[last ? n + p : 0] += last ? 0.5 : -0.5;
    else if (n > p + 1)
        t[last ? n - 1 : p + 1] = t[last ? n : p];
}

/* One case in 3. */
verdict prop_iges_write(gen *g)
{
    char path[256], *text = NULL;
    const et_frame frame = some_frame(g);
    et_shell shell = {0}, own = {0};
    et_message message;
    size_t size = 0;
    bool ok;

    if (some_shell(g, &shell, !gen_chance(g, 4)))
        return SKIP;
    if (gen_chance(g, 3))
        unclamp(g, &shell);
    if (et_shell_copy(&own, &shell))
        return et_shell_free(&shell), SKIP;
    for (size_t view = 0; view < 2; view++)
        et_frame_from_unit(own.view[view].points, own.view[view].nu * own.view[view].nv, &frame);
    remove(some_path(path, ".igs"));
    ok = refuses_bad(g, path, &shell, &frame) && gen_check(g, access(path, F_OK) != 0, "a refused call wrote a file");
    ok = ok && gen_check(g, et_iges_write(path, &shell, &frame, &message) == ET_OK, "not written");
    text = whole_file(path, &size);
    ok = ok && gen_check(g, text != NULL, "no file") && file_is(g, text, size, &own);
    free(text);
    remove(path);
    et_shell_free(&own);
    et_shell_free(&shell);
    return ok ? PASS : FAIL;
}

/* p q nu nv rational, then for each view knots of u, of v, weights if rational, points; offset, scale.  Wanted: the records, '_' for a blank. */
static bool row_shell(const row *r, et_shell *shell, et_frame *frame)
{
    const size_t p = row_size(r, 0), q = row_size(r, 1), rational = row_size(r, 4);
    const et_doublenet net = {row_size(r, 2), row_size(r, 3)};
    size_t k = 5;

    if (et_shell_new(shell, p, q, net, (int)rational))
        return false;
    for (size_t view = 0; view < 2; view++) {
        et_surface *const s = &shell->view[view];

        for (size_t i = 0; i < net.nx + p + 1; i++)
            s->u[i] = row_real(r, k++);
        for (size_t i = 0; i < net.ny + q + 1; i++)
            s->v[i] = row_real(r, k++);
        for (size_t i = 0; rational && i < net.nx * net.ny; i++)
            s->weights[i] = row_real(r, k++);
        for (size_t i = 0; i < net.nx * net.ny; i++, k += 3)
            s->points[i] = (et_vec3){row_real(r, k), row_real(r, k + 1), row_real(r, k + 2)};
    }
    frame->offset = (et_vec3){row_real(r, k), row_real(r, k + 1), row_real(r, k + 2)};
    frame->scale = (et_vec3){row_real(r, k + 3), row_real(r, k + 4), row_real(r, k + 5)};
    return k + 6 == r->nargs;
}

verdict gold_iges_write(const row *r)
{
    char path[256], *text = NULL;
    et_shell shell = {0};
    et_frame frame;
    size_t size = 0;
    bool ok = row_shell(r, &shell, &frame) && et_iges_write(some_path(path, ".igs"), &shell, &frame, NULL) == ET_OK;

    text = ok ? whole_file(path, &size) : NULL;
    ok = text && size == RECORD * r->nwant;
    for (size_t k = 0; k < size; k++)
        text[k] = text[k] == ' ' ? '_' : text[k];
    for (size_t k = 0; ok && k < r->nwant; k++) {
        ok = strlen(r->want[k]) == 80 && memcmp(record(text, k), r->want[k], 80) == 0;
        if (!ok)
            printf("  record %zu is %.80s,\n     wanted %s\n", k + 1, record(text, k), r->want[k]);
    }
    free(text);
    remove(path);
    et_shell_free(&shell);
    return ok ? PASS : FAIL;
}
