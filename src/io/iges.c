#include "etalon/io/iges.h"
#include "etalon/io/file.h"
#include "etalon/spline/knots.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 72, DATA_COLUMNS = 64, FIELD = 40, MOST_RECORDS = 9999999 };

/* A writer of one section's records; with no stream it only counts them.  Fields gather in `line` until the next does not fit. */
typedef struct {
    FILE *stream;
    char section;
    size_t columns;                       /* 72, or 64 in the parameter section */
    size_t entity;                        /* directory number behind parameter data */
    size_t records, used;
    char line[COLUMNS + 1];
} section;

static section section_start(FILE *stream, char letter)
{
    section s = {0};

    s.stream = stream;
    s.section = letter;
    s.columns = letter == 'P' ? DATA_COLUMNS : COLUMNS;
    return s;
}

static void end_record(section *s)
{
    s->records++;
    s->line[s->used] = '\0';
    s->used = 0;
    if (!s->stream)
        return;
    if (s->section == 'P')
        fprintf(s->stream, "%-64s %7zu%c%7zu\n", s->line, s->entity, s->section, s->records);
    else
        fprintf(s->stream, "%-72s%c%7zu\n", s->line, s->section, s->records);
}

/* One field with its delimiter, never broken. */
static void put(section *s, const char *text)
{
    const size_t n = strlen(text);

    if (s->used + n > s->columns)
        end_record(s);
    memcpy(s->line + s->used, text, n);
    s->used += n;
}

static void put_string(section *s, const char *text, char delimiter)
{
    char field[FIELD];

    snprintf(field, sizeof field, "%zuH%s%c", strlen(text), text, delimiter);
    put(s, field);
}

static void put_size(section *s, size_t x, char delimiter)
{
    char field[FIELD];

    snprintf(field, sizeof field, "%zu%c", x, delimiter);
    put(s, field);
}

/* digits[0] '.' digits[1..] 'D' exponent, or without exponent where that is short: what C prints with %g, in IGES' letters. */
static void put_real(section *s, double x, char delimiter)
{
    char g[FIELD], field[FIELD];
    size_t n = 0;

    for (int digits = 1; digits <= 17; digits++) {
        snprintf(g, sizeof g, "%.*g", digits, x);
        if (strtod(g, NULL) == x)
            break;
    }
    for (const char *c = g; *c && *c != 'e'; c++)
        field[n++] = *c == ',' ? '.' : *c;   /* a program may have chosen a locale with a decimal comma */
    if (!memchr(field, '.', n))
        field[n++] = '.';
    if (strchr(g, 'e'))
        n += (size_t)snprintf(field + n, sizeof field - n, "D%d", atoi(strchr(g, 'e') + 1));
    field[n++] = delimiter;
    field[n] = '\0';
    put(s, field);
}

static double greatest_coordinate(const et_shell *shell)
{
    double most = 0;

    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++)
        for (size_t k = 0; k < shell->view[view].nu * shell->view[view].nv; k++) {
            const et_vec3 p = shell->view[view].points[k];

            most = fmax(most, fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))));
        }
    return most;
}

static size_t write_start(FILE *stream)
{
    section s = section_start(stream, 'S');

    put(&s, "Closed double surface: bottom and top, equal along the border.");
    end_record(&s);
    return s.records;
}

/* The first 25 global parameters (IGES 5.3, table 1), in order. */
static size_t write_global(FILE *stream, double greatest)
{
    section s = section_start(stream, 'G');

    put_string(&s, ",", ',');
    put_string(&s, ";", ',');
    put_string(&s, "ETALON", ',');             /* product identification of the sender */
    put_string(&s, "etalon.igs", ',');
    put_string(&s, "Etalon", ',');             /* native system */
    put_string(&s, "Etalon IGES 5.3", ',');    /* preprocessor */
    put_size(&s, 32, ',');                     /* bits of an integer */
    put_size(&s, 38, ',');                     /* single: greatest power of ten, digits; double: the same */
    put_size(&s, 6, ',');
    put_size(&s, 308, ',');
    put_size(&s, 15, ',');
    put_string(&s, "ETALON", ',');             /* product identification for the receiver */
    put_real(&s, 1, ',');                      /* model space scale */
    put_size(&s, 2, ',');
    put_string(&s, "MM", ',');
    put_size(&s, 1, ',');                      /* line weights: number, greatest width */
    put_real(&s, 0, ',');
    put_string(&s, "20000101.000000", ',');    /* no clock in a result */
    put_real(&s, greatest > 0 ? greatest * 0x1p-30 : 0x1p-30, ',');   /* resolution: 2^-30 of the size, about 1e-9 */
    put_real(&s, greatest, ',');
    put(&s, ",");                              /* no author, no organisation */
    put(&s, ",");
    put_size(&s, 11, ',');                     /* version 5.3 */
    put_size(&s, 0, ',');                      /* no drafting standard */
    put_string(&s, "20000101.000000", ';');    /* no application protocol */
    end_record(&s);
    return s.records;
}

/* Both lines of a directory entry; status 00000000: visible, independent, geometry. */
static void write_directory(FILE *stream, size_t view, size_t from, size_t records)
{
    const char *const label = view == ET_BOTTOM ? "BOTTOM" : "TOP";
    const char *const blank = "";

    fprintf(stream, "%8d%8zu%8d%8d%8d%8d%8d%8d%sD%7zu\n", 128, from, 0, 1, 0, 0, 0, 0, "00000000", 2 * view + 1);
    fprintf(stream, "%8d%8d%8d%8zu%8d%8s%8s%8s%8dD%7zu\n", 128, 0, 0, records, 0, blank, blank, label, 0, 2 * view + 2);
}

static int same_node(const et_surface *s, size_t a, size_t b)
{
    const et_vec3 p = s->points[a], q = s->points[b];

    return p.x == q.x && p.y == q.y && p.z == q.z && (!s->weights || s->weights[a] == s->weights[b]);
}

static size_t closed_u(const et_surface *s)
{
    if (!et_knots_interpolating(s->u, s->nu + s->p + 1, s->p))
        return 0;
    for (size_t j = 0; j < s->nv; j++)
        if (!same_node(s, j, (s->nu - 1) * s->nv + j))
            return 0;
    return 1;
}

static size_t closed_v(const et_surface *s)
{
    if (!et_knots_interpolating(s->v, s->nv + s->q + 1, s->q))
        return 0;
    for (size_t i = 0; i < s->nu; i++)
        if (!same_node(s, i * s->nv, i * s->nv + s->nv - 1))
            return 0;
    return 1;
}

static void put_header(section *p, const et_surface *s)
{
    const size_t integer[10] = {128, s->nu - 1, s->nv - 1, s->p, s->q, closed_u(s), closed_v(s), s->weights ? 0 : 1, 0, 0};

    for (size_t k = 0; k < 10; k++)
        put_size(p, integer[k], ',');
}

static void put_surface(section *p, const et_surface *s)
{
    put_header(p, s);
    for (size_t k = 0; k < s->nu + s->p + 1; k++)
        put_real(p, s->u[k], ',');
    for (size_t k = 0; k < s->nv + s->q + 1; k++)
        put_real(p, s->v[k], ',');
    for (size_t j = 0; j < s->nv; j++)
        for (size_t i = 0; i < s->nu; i++)
            put_real(p, s->weights ? s->weights[i * s->nv + j] : 1, ',');
    for (size_t j = 0; j < s->nv; j++)
        for (size_t i = 0; i < s->nu; i++) {
            put_real(p, s->points[i * s->nv + j].x, ',');
            put_real(p, s->points[i * s->nv + j].y, ',');
            put_real(p, s->points[i * s->nv + j].z, ',');
        }
    put_real(p, s->u[s->p], ',');
    put_real(p, s->u[s->nu], ',');
    put_real(p, s->v[s->q], ',');
    put_real(p, s->v[s->nv], ';');
    end_record(p);
}

/* The parameter section, or with no stream only its counts: records[view]. */
static void write_parameters(FILE *stream, size_t records[2], const et_shell *shell)
{
    section p = section_start(stream, 'P');

    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++) {
        const size_t before = p.records;

        p.entity = 2 * view + 1;
        put_surface(&p, &shell->view[view]);
        records[view] = p.records - before;
    }
}

static void write_all(FILE *stream, const size_t records[2], const et_shell *shell)
{
    size_t again[2];
    const size_t start = write_start(stream);
    const size_t global = write_global(stream, greatest_coordinate(shell));

    write_directory(stream, ET_BOTTOM, 1, records[ET_BOTTOM]);
    write_directory(stream, ET_TOP, 1 + records[ET_BOTTOM], records[ET_TOP]);
    write_parameters(stream, again, shell);
    fprintf(stream, "S%7zuG%7zuD%7dP%7zu%40sT%7d\n", start, global, 4, records[ET_BOTTOM] + records[ET_TOP], "", 1);
}

et_status et_iges_write(const char *path, const et_shell *shell, const et_frame *frame, et_message *message)
{
    et_shell own = {0};
    et_file file = {0};
    size_t records[2];
    et_status status;

    if (!path || !shell || !frame || !et_shell_valid(shell))
        return et_status_fail(message, ET_EINVAL, "IGES: no path, no frame, or not a valid shell");
    status = et_shell_copy(&own, shell);
    if (status)
        return et_status_fail(message, status, "IGES: %s", et_status_text(status));
    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++)
        et_frame_from_unit(own.view[view].points, own.view[view].nu * own.view[view].nv, frame);
    if (!et_shell_valid(&own))
        status = et_status_fail(message, ET_EINVAL, "%s: the control points overflow in the cloud's own coordinates", path);
    if (!status) {
        write_parameters(NULL, records, &own);   /* the directory stands first and needs the counts */
        if (records[ET_BOTTOM] > MOST_RECORDS || records[ET_TOP] > MOST_RECORDS - records[ET_BOTTOM])
            status = et_status_fail(message, ET_EINVAL, "%s: more records than IGES can number", path);
    }
    if (!status)
        status = et_file_create(&file, path, message);
    if (!status) {
        write_all(file.stream, records, &own);
        status = et_file_commit(&file, message);
    }
    et_shell_free(&own);
    return status;
}
