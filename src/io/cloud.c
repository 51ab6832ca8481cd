#include "etalon/io/cloud.h"
#include "etalon/io/file.h"
#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    BLOCK = 1 << 18,              /* bytes of the buffer at first */
    LONGEST = 1 << 26,            /* bytes of the longest line read */
    MAGIC = 84,                   /* bytes that decide the format */
    ELEMENTS = 64, PROPERTIES = 1024,
    WORD = 48                     /* bytes of a faulty field that a message shows */
};

/* A file read in blocks: the unread bytes are buffer[start .. end-1], and one byte more is always there to hold a terminator. */
typedef struct {
    FILE *in;
    const char *path;
    et_message *message;
    unsigned char *buffer;
    size_t room, start, end;
    size_t line, following;       /* number of the line last given, and of the next */
    int ended;                    /* nothing is left to read into the buffer */
    int continued;                /* a backslash at the end of a line joins the next to it */
    int bare_cr, cr_ended;        /* a CR alone ends a line, even before LF; the last line was ended by a CR alone */
    size_t size;                  /* of a regular file, else 0 */
} reader;

typedef struct { char *begin, *end; } field;

/* ---- the cloud being built ---- */

typedef struct {
    et_vec3 *points;
    size_t count, room;
    size_t *slot, slots;          /* for distinct points: 1 + index, open addressing; slots is a power of two, at most half full */
} builder;

static et_status out_of_memory(const reader *r)
{
    return et_status_fail(r->message, ET_ENOMEM, "out of memory while reading %s", r->path);
}

static et_status append(reader *r, builder *b, et_vec3 p)
{
    if (b->count == b->room) {
        size_t room = b->room ? 2 * b->room : 1024;
        et_vec3 *points = room <= SIZE_MAX / 2 / sizeof *points ? realloc(b->points, room * sizeof *points) : NULL;
        if (!points)
            return out_of_memory(r);
        b->points = points;
        b->room = room;
    }
    b->points[b->count++] = p;
    return ET_OK;
}

static uint64_t mix(uint64_t h, double x)
{
    uint64_t bits;
    x += 0.0;                     /* -0 and 0 are one coordinate */
    memcpy(&bits, &x, sizeof bits);
    h = (h ^ bits) * UINT64_C(0x9e3779b97f4a7c15);
    return h ^ (h >> 29);
}

/* The slot that holds p, or the empty one where it belongs. */
static size_t place_of(const builder *b, et_vec3 p)
{
    uint64_t h = mix(mix(mix(0, p.x), p.y), p.z);
    size_t k = (size_t)(h ^ (h >> 32)) & (b->slots - 1);
    while (b->slot[k]) {
        const et_vec3 *q = &b->points[b->slot[k] - 1];
        if (q->x == p.x && q->y == p.y && q->z == p.z)
            break;
        k = (k + 1) & (b->slots - 1);
    }
    return k;
}

static et_status append_distinct(reader *r, builder *b, et_vec3 p)
{
    if (2 * (b->count + 1) > b->slots) {
        size_t slots = b->slots ? 2 * b->slots : 4096;
        size_t *slot = calloc(slots, sizeof *slot);
        if (!slot)
            return out_of_memory(r);
        free(b->slot);
        b->slot = slot;
        b->slots = slots;
        for (size_t i = 0; i < b->count; i++)
            b->slot[place_of(b, b->points[i])] = i + 1;
    }
    size_t k = place_of(b, p);
    if (b->slot[k])
        return ET_OK;
    b->slot[k] = b->count + 1;
    return append(r, b, p);
}

/* ---- bytes and lines ---- */

static et_status fill(reader *r)
{
    if (r->start > 0) {
        memmove(r->buffer, r->buffer + r->start, r->end - r->start);
        r->end -= r->start;
        r->start = 0;
    }
    if (r->end == r->room) {
        if (r->room >= LONGEST)
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: line of more than %d bytes", r->path, r->following, (int)LONGEST);
        unsigned char *buffer = realloc(r->buffer, 2 * r->room + 1);
        if (!buffer)
            return out_of_memory(r);
        r->buffer = buffer;
        r->room *= 2;
    }
    errno = 0;
    size_t wanted = r->room - r->end;
    size_t got = fread(r->buffer + r->end, 1, wanted, r->in);
    r->end += got;
    if (got < wanted) {
        if (ferror(r->in))
            return et_status_fail(r->message, ET_EIO, "cannot read %s: %s", r->path, errno ? strerror(errno) : "read error");
        r->ended = 1;
    }
    return ET_OK;
}

/* *there: whether n bytes (at most BLOCK) are left; they then stand in the buffer. */
static et_status need(reader *r, size_t n, int *there)
{
    et_status status = ET_OK;
    while (!status && r->end - r->start < n && !r->ended)
        status = fill(r);
    *there = r->end - r->start >= n;
    return status;
}

static et_status skip(reader *r, size_t n, int *there)
{
    et_status status = ET_OK;
    *there = 1;
    while (!status && n > 0 && *there) {
        status = need(r, 1, there);
        size_t part = r->end - r->start < n ? r->end - r->start : n;
        r->start += part;
        n -= part;
    }
    return status;
}

/* Pass the line end at buffer[k]; *k: the byte after it. */
static et_status pass_line_end(reader *r, size_t *k)
{
    r->cr_ended = 0;
    if (r->buffer[(*k)++] == '\n')
        return ET_OK;
    r->cr_ended = 1;
    if (r->bare_cr)
        return ET_OK;
    size_t done = *k - r->start;
    int there;
    et_status status = need(r, done + 1, &there);
    *k = r->start + done;
    if (!status && there && r->buffer[*k] == '\n') {
        (*k)++;
        r->cr_ended = 0;
    }
    return status;
}

/* The next line without its end (LF, CR LF or CR); *more: 0 when there is none. */
static et_status next_line(reader *r, field *line, int *more)
{
    et_status status;
    size_t k = r->start, first = r->following;
    r->line = first;
    for (;;) {
        while (k < r->end && r->buffer[k] > '\r')
            k++;
        size_t done = k - r->start;
        if (k == r->end) {
            if (r->ended)
                break;
            if ((status = fill(r)) != ET_OK)
                return status;
            k = r->start + done;
        } else if (r->buffer[k] == '\n' || r->buffer[k] == '\r') {
            size_t after = k;
            if ((status = pass_line_end(r, &after)) != ET_OK)
                return status;
            r->following++;
            line->begin = (char *)r->buffer + r->start;
            line->end = line->begin + done;
            k = r->start + done;
            if (!r->continued || done == 0 || r->buffer[k - 1] != '\\') {
                r->start = after;
                *more = 1;
                return ET_OK;
            }
            memset(r->buffer + k - 1, ' ', after - k + 1);
        } else if (r->buffer[k] == 0) {
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: NUL byte in a text file", r->path, r->following);
        } else {
            k++;
        }
    }
    if (r->continued && k > r->start && r->buffer[k - 1] == '\\')
        r->buffer[k - 1] = ' ';
    *more = k > r->start;
    r->following += *more ? 1 : 0;
    line->begin = (char *)r->buffer + r->start;
    line->end = (char *)r->buffer + k;
    r->start = k;
    return ET_OK;
}

/* ---- fields and numbers ---- */

static int blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static field trimmed(field f)
{
    while (f.begin < f.end && blank(*f.begin))
        f.begin++;
    while (f.begin < f.end && blank(f.end[-1]))
        f.end--;
    return f;
}

/* The next field of `rest` and what is left of it; 0 when there is none.  separator: comma or semicolon, blanks around it are not part of
 * a field; or a blank, for runs of blanks. */
static int next_field(field *f, field *rest, char separator)
{
    if (!rest->begin)
        return 0;
    if (separator != ' ') {
        char *end = memchr(rest->begin, separator, (size_t)(rest->end - rest->begin));
        *f = trimmed((field){ rest->begin, end ? end : rest->end });
        rest->begin = end ? end + 1 : NULL;
        return 1;
    }
    while (rest->begin < rest->end && blank(*rest->begin))
        rest->begin++;
    f->begin = rest->begin;
    while (rest->begin < rest->end && !blank(*rest->begin))
        rest->begin++;
    f->end = rest->begin;
    return f->begin < f->end;
}

static int has(field f, char c)
{
    while (f.begin < f.end && *f.begin != c)
        f.begin++;
    return f.begin < f.end;
}

static int field_is(field f, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(f.end - f.begin) == n && strncasecmp(f.begin, word, n) == 0;
}

static int field_starts(field f, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(f.end - f.begin) >= n && strncasecmp(f.begin, word, n) == 0;
}

/* A decimal number as its parts: sign, digits as an integer (`many` when they do not fit), decimal exponent. */
typedef struct { uint64_t digits; long exponent; int negative, many; char *letter; } decimal;

static char *scan_digits(decimal *d, char *p, const char *end, int after_point, int *seen)
{
    for (; p < end && *p >= '0' && *p <= '9'; p++) {
        *seen = 1;
        if (d->digits > (UINT64_MAX - 9) / 10)
            d->many = 1;
        else
            d->digits = 10 * d->digits + (uint64_t)(*p - '0');
        d->exponent -= after_point;
    }
    return p;
}

/* Whether the whole field is [+-] digits [. digits] [(e|E|d|D) [+-] digits]. */
static int scan_decimal(decimal *d, field f)
{
    char *p = f.begin;
    int seen = 0, negative = 0, exponent_seen = 0;
    long exponent = 0;
    *d = (decimal){ 0, 0, 0, 0, NULL };
    if (p < f.end && (*p == '+' || *p == '-'))
        d->negative = *p++ == '-';
    p = scan_digits(d, p, f.end, 0, &seen);
    if (p < f.end && *p == '.')
        p = scan_digits(d, p + 1, f.end, 1, &seen);
    if (!seen || p == f.end)
        return seen;
    if (*p != 'e' && *p != 'E' && *p != 'd' && *p != 'D')
        return 0;
    d->letter = p++;
    if (p < f.end && (*p == '+' || *p == '-'))
        negative = *p++ == '-';
    for (; p < f.end && *p >= '0' && *p <= '9'; p++) {
        exponent_seen = 1;
        if (exponent < 100000)
            exponent = 10 * exponent + (*p - '0');
    }
    d->exponent += negative ? -exponent : exponent;
    return exponent_seen && p == f.end;
}

/* The value of a field that strtod takes whole, correctly rounded. */
static int strtod_whole(double *value, field f)
{
    char keep = *f.end, *stop;
    *f.end = 0;
    *value = strtod(f.begin, &stop);
    *f.end = keep;
    return stop == f.end && stop > f.begin;
}

/* The number that is the whole field: decimal, hexadecimal, inf or nan; correctly rounded. */
static int number(double *value, field f)
{
    static const double ten[] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
    decimal d;
    if (!scan_decimal(&d, f)) {
        char c = f.begin < f.end ? f.begin[f.end - f.begin > 1 && (*f.begin == '+' || *f.begin == '-')] : 0;
        return (c == '0' || c == 'i' || c == 'I' || c == 'n' || c == 'N') && strtod_whole(value, f);
    }
    /* Digits and power of ten are exact doubles: one operation, one rounding (Clinger 1990). */
    if (!d.many && d.digits <= UINT64_C(1) << 53 && d.exponent >= -22 && d.exponent <= 22) {
        double w = (double)d.digits;
        w = d.exponent < 0 ? w / ten[-d.exponent] : w * ten[d.exponent];
        *value = d.negative ? -w : w;
        return 1;
    }
    char letter = d.letter ? *d.letter : 0;
    if (d.letter)
        *d.letter = 'e';          /* Fortran's D */
    int whole = strtod_whole(value, f);
    if (d.letter)
        *d.letter = letter;
    return whole;
}

/* A count: decimal digits only, fitting size_t. */
static int count_of(size_t *count, field f)
{
    size_t n = 0;
    if (f.begin >= f.end)
        return 0;
    for (const char *p = f.begin; p < f.end; p++) {
        if (*p < '0' || *p > '9' || n > (SIZE_MAX - (size_t)(*p - '0')) / 10)
            return 0;
        n = 10 * n + (size_t)(*p - '0');
    }
    *count = n;
    return 1;
}

static void show(char word[WORD], field f)
{
    size_t n = (size_t)(f.end - f.begin);
    size_t shown = n < WORD - 4 ? n : WORD - 4;
    for (size_t k = 0; k < shown; k++)
        word[k] = blank(f.begin[k]) ? ' ' : f.begin[k] > ' ' && f.begin[k] <= '~' ? f.begin[k] : '?';
    memcpy(word + shown, n > shown ? "..." : "", n > shown ? 4 : 1);
}

static double *axis_of(et_vec3 *p, size_t axis)
{
    return axis == 0 ? &p->x : axis == 1 ? &p->y : &p->z;
}

/* Coordinate number `axis` of a point from a field of the line last read. */
static et_status coordinate(reader *r, et_vec3 *p, size_t axis, field f)
{
    double value;
    char word[WORD];
    char letter = "xyz"[axis];
    if (f.begin >= f.end)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %c is missing", r->path, r->line, letter);
    if (!number(&value, f)) {
        show(word, f);
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %c is not a number: \"%s\"%s", r->path, r->line, letter, word,
                              strpbrk(word, ",; ") ? " (mixed separators, or a decimal comma)" : "");
    }
    if (!isfinite(value))
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %c is not finite", r->path, r->line, letter);
    *axis_of(p, axis) = value;
    return ET_OK;
}

static et_status unknown_word(reader *r, const char *what, field f)
{
    char word[WORD];
    show(word, f);
    return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: unknown %s \"%s\"", r->path, r->line, what, word);
}

/* The three coordinates from the next three fields between blanks. */
static et_status three(reader *r, et_vec3 *p, field *rest)
{
    et_status status = ET_OK;
    for (size_t axis = 0; axis < 3 && !status; axis++) {
        field f;
        (void)next_field(&f, rest, ' ');
        status = coordinate(r, p, axis, f);
    }
    return status;
}

/* ---- XYZ and CSV ---- */

typedef struct {
    size_t column[3];             /* of x, y, z */
    char separator;               /* the header's, 0 without a header */
    int first;                    /* no header and no point yet */
    size_t count, count_line;     /* the count before the points, and its line; line 0 without a count */
} table_form;

static field without_comment(field line)
{
    size_t n = (size_t)(line.end - line.begin);
    char *p = memchr(line.begin, '#', n);
    if (p)
        line.end = p;
    for (p = line.begin; p < line.end && (p = memchr(p, '/', (size_t)(line.end - p))) != NULL; p++) {
        if (p + 1 < line.end && p[1] == '/') {
            line.end = p;
            break;
        }
    }
    line = trimmed(line);
    if (line.begin < line.end && *line.begin == '%')
        line.end = line.begin;
    return line;
}

/* What stands between the columns: the first of comma, semicolon and blanks after the first field decides (a header's own where it occurs). */
static char separator_of(const table_form *form, field line)
{
    if (form->separator && form->separator != ' ' && has(line, form->separator))
        return form->separator;
    char *p = line.begin;
    while (p < line.end && !blank(*p) && *p != ',' && *p != ';')
        p++;
    while (p < line.end && blank(*p))
        p++;
    return p < line.end && (*p == ',' || *p == ';') ? *p : ' ';
}

static field unquoted(field f)
{
    if (f.end - f.begin >= 2 && *f.begin == '"' && f.end[-1] == '"')
        f = trimmed((field){ f.begin + 1, f.end - 1 });
    return f;
}

/* Whether a number stands between any separators of the line: then it is no header. */
static int holds_number(field line)
{
    double value;
    field f = { line.begin, line.begin };
    for (; f.begin < line.end; f.begin = f.end = f.end + 1) {
        while (f.end < line.end && !blank(*f.end) && *f.end != ',' && *f.end != ';')
            f.end++;
        if (number(&value, f))
            return 1;
    }
    return 0;
}

/* Whether the line is a header; takes the columns from it where it names x, y and z. */
static et_status take_header(reader *r, table_form *form, field line, int *header)
{
    static const char *const name[3] = { "x", "y", "z" };
    size_t column[3] = { 0, 0, 0 }, found[3] = { 0, 0, 0 };
    char separator = has(line, ';') ? ';' : has(line, ',') ? ',' : ' ';
    field f, rest = line;
    *header = !holds_number(line);
    for (size_t k = 0; *header && next_field(&f, &rest, separator); k++) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (field_is(unquoted(f), name[axis])) {
                column[axis] = k;
                found[axis]++;
            }
        }
    }
    if (found[0] || found[1] || found[2]) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (found[axis] != 1)
                return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the header names %s %s", r->path, r->line, name[axis],
                                      found[axis] ? "twice" : "not at all, but another of x, y, z");
        }
        memcpy(form->column, column, sizeof column);
    }
    form->separator = *header ? separator : 0;
    return ET_OK;
}

static et_status table_point(reader *r, const table_form *form, et_vec3 *p, field line)
{
    field f, at[3] = { { NULL, NULL }, { NULL, NULL }, { NULL, NULL } };
    char separator = separator_of(form, line);
    size_t missing = 3;
    for (size_t k = 0; missing > 0 && next_field(&f, &line, separator); k++) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (form->column[axis] == k) {
                at[axis] = f;
                missing--;
            }
        }
    }
    et_status status = ET_OK;
    for (size_t axis = 0; axis < 3 && !status; axis++)
        status = coordinate(r, p, axis, at[axis]);
    return status;
}

static et_status read_table(reader *r, builder *b)
{
    table_form form = { { 0, 1, 2 }, 0, 1, 0, 0 };
    et_vec3 p = { 0, 0, 0 };
    et_status status;
    field line;
    int more, header = 0;
    while ((status = next_line(r, &line, &more)) == ET_OK && more) {
        line = without_comment(line);
        if (line.begin == line.end)
            continue;
        if (form.first && !form.count_line && count_of(&form.count, line)) {
            form.count_line = r->line;
            continue;
        }
        if (form.first) {
            form.first = 0;
            if ((status = take_header(r, &form, line, &header)) != ET_OK)
                return status;
            if (header)
                continue;
        }
        if ((status = table_point(r, &form, &p, line)) != ET_OK || (status = append(r, b, p)) != ET_OK)
            return status;
    }
    if (!status && form.count_line && form.count != b->count)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the count is %zu, but %zu points follow", r->path, form.count_line, form.count,
                              b->count);
    return status;
}

/* ---- OBJ ---- */

static et_status read_obj(reader *r, builder *b)
{
    et_status status;
    et_vec3 p = { 0, 0, 0 };
    field line, f;
    int more;
    r->continued = 1;
    while ((status = next_line(r, &line, &more)) == ET_OK && more) {
        char *comment = memchr(line.begin, '#', (size_t)(line.end - line.begin));
        if (comment)
            line.end = comment;
        if (!next_field(&f, &line, ' ') || f.end - f.begin != 1 || *f.begin != 'v')
            continue;
        if ((status = three(r, &p, &line)) != ET_OK || (status = append(r, b, p)) != ET_OK)
            return status;
    }
    return status;
}

/* ---- numbers in bytes ---- */

static uint64_t bits_of(const unsigned char *p, size_t size, int big)
{
    uint64_t bits = 0;
    for (size_t k = 0; k < size; k++)
        bits = bits << 8 | p[big ? k : size - 1 - k];
    return bits;
}

static double float_of(uint64_t bits)
{
    uint32_t word = (uint32_t)bits;
    float x;
    memcpy(&x, &word, sizeof x);
    return (double)x;
}

static double double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static char not_finite(et_vec3 p)
{
    return !isfinite(p.x) ? 'x' : !isfinite(p.y) ? 'y' : !isfinite(p.z) ? 'z' : 0;
}

/* ---- STL ---- */

static et_status read_stl_binary(reader *r, builder *b)
{
    int there;
    et_status status = need(r, MAGIC, &there);
    if (status)
        return status;
    if (!there)
        return et_status_fail(r->message, ET_EFORMAT, "%s: STL header is not complete", r->path);
    uint64_t count = bits_of(r->buffer + r->start + 80, 4, 0);
    r->start += MAGIC;
    for (uint64_t t = 0; t < count; t++) {
        if ((status = need(r, 50, &there)) != ET_OK)
            return status;
        if (!there)
            return et_status_fail(r->message, ET_EFORMAT, "%s: triangle %llu of %llu is missing (truncated)", r->path,
                                  (unsigned long long)t + 1, (unsigned long long)count);
        for (size_t k = 12; k < 48; k += 12) {
            const unsigned char *at = r->buffer + r->start + k;
            et_vec3 p = { float_of(bits_of(at, 4, 0)), float_of(bits_of(at + 4, 4, 0)), float_of(bits_of(at + 8, 4, 0)) };
            if (not_finite(p))
                return et_status_fail(r->message, ET_EFORMAT, "%s: triangle %llu, vertex %zu: %c is not finite", r->path,
                                      (unsigned long long)t + 1, k / 12, not_finite(p));
            if ((status = append_distinct(r, b, p)) != ET_OK)
                return status;
        }
        r->start += 50;
    }
    if ((status = need(r, 1, &there)) != ET_OK)
        return status;
    return there ? et_status_fail(r->message, ET_EFORMAT, "%s: more bytes than its %llu triangles", r->path, (unsigned long long)count) : ET_OK;
}

/* One line of an ASCII STL file; *open: inside a solid. */
static et_status stl_line(reader *r, builder *b, field line, int *open)
{
    static const char *const passed[] = { "facet", "outer", "loop", "endloop", "endfacet" };
    et_status status;
    et_vec3 p = { 0, 0, 0 };
    field f;
    while (next_field(&f, &line, ' ')) {
        if (field_is(f, "solid") || field_is(f, "endsolid")) {
            *open = field_is(f, "solid");
            return ET_OK;         /* a name follows */
        }
        if (field_is(f, "vertex")) {
            if ((status = three(r, &p, &line)) != ET_OK || (status = append_distinct(r, b, p)) != ET_OK)
                return status;
            continue;
        }
        if (field_is(f, "normal")) {
            for (int k = 0; k < 3; k++)
                (void)next_field(&f, &line, ' ');
            continue;
        }
        size_t k = 0;
        while (k < sizeof passed / sizeof *passed && !field_is(f, passed[k]))
            k++;
        if (k == sizeof passed / sizeof *passed)
            return unknown_word(r, "STL keyword", f);
    }
    return ET_OK;
}

static et_status read_stl_ascii(reader *r, builder *b)
{
    et_status status;
    field line;
    int more, open = 0;
    while ((status = next_line(r, &line, &more)) == ET_OK && more) {
        if ((status = stl_line(r, b, line, &open)) != ET_OK)
            return status;
    }
    if (!status && open)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the file ends without endsolid (truncated)", r->path, r->following);
    return status;
}

/* ---- PLY ---- */

typedef struct { const char *name, *alias; size_t size; char kind; } ply_type;
static const ply_type ply_types[] = {
    { "char", "int8", 1, 'i' }, { "uchar", "uint8", 1, 'u' }, { "short", "int16", 2, 'i' }, { "ushort", "uint16", 2, 'u' },
    { "int", "int32", 4, 'i' }, { "uint", "uint32", 4, 'u' }, { "float", "float32", 4, 'f' }, { "double", "float64", 8, 'f' },
};

/* A property: list null unless it is a list (then the type of its length); axis 0, 1, 2 for a vertex's x, y, z, else 3. */
typedef struct { const ply_type *type, *list; size_t axis; } ply_property;
typedef struct { char name[WORD]; size_t count, first, last; int vertex; } ply_element;      /* properties first .. last-1 */
typedef struct {
    enum { PLY_NONE = 0, PLY_ASCII, PLY_LITTLE, PLY_BIG } format;
    ply_element element[ELEMENTS];
    size_t elements;
    ply_property property[PROPERTIES];
    size_t properties;
} ply_header;

static const ply_type *ply_type_of(field f)
{
    for (size_t k = 0; k < sizeof ply_types / sizeof *ply_types; k++) {
        if (field_is(f, ply_types[k].name) || field_is(f, ply_types[k].alias))
            return &ply_types[k];
    }
    return NULL;
}

static et_status ply_format(reader *r, ply_header *h, field rest)
{
    field f, version;
    (void)next_field(&f, &rest, ' ');
    (void)next_field(&version, &rest, ' ');
    if (field_is(f, "ascii"))
        h->format = PLY_ASCII;
    else if (field_is(f, "binary_little_endian"))
        h->format = PLY_LITTLE;
    else if (field_is(f, "binary_big_endian"))
        h->format = PLY_BIG;
    else
        return unknown_word(r, "PLY format", f);
    return field_is(version, "1.0") ? ET_OK : unknown_word(r, "PLY version", version);
}

static et_status ply_add_element(reader *r, ply_header *h, field rest)
{
    field name, count;
    char word[WORD];
    (void)next_field(&name, &rest, ' ');
    (void)next_field(&count, &rest, ' ');
    if (h->elements == ELEMENTS)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: more than %d elements", r->path, r->line, (int)ELEMENTS);
    ply_element *e = &h->element[h->elements];
    if (!count_of(&e->count, count)) {
        show(word, count);
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: \"%s\" is not a count", r->path, r->line, word);
    }
    show(e->name, name);
    e->vertex = strcmp(e->name, "vertex") == 0;
    e->first = e->last = h->properties;
    h->elements++;
    return ET_OK;
}

static et_status ply_add_property(reader *r, ply_header *h, field rest)
{
    field f;
    ply_property p = { NULL, NULL, 3 };
    if (h->elements == 0 || h->properties == PROPERTIES)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %s", r->path, r->line,
                              h->elements ? "more properties than are read" : "property before any element");
    (void)next_field(&f, &rest, ' ');
    if (field_is(f, "list")) {
        (void)next_field(&f, &rest, ' ');
        p.list = ply_type_of(f);
        if (!p.list || p.list->kind == 'f')
            return unknown_word(r, "PLY list length type", f);
        (void)next_field(&f, &rest, ' ');
    }
    p.type = ply_type_of(f);
    if (!p.type)
        return unknown_word(r, "PLY type", f);
    if (!next_field(&f, &rest, ' '))
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: property without a name", r->path, r->line);
    ply_element *e = &h->element[h->elements - 1];
    if (e->vertex && !p.list && f.end - f.begin == 1 && *f.begin >= 'x' && *f.begin <= 'z')
        p.axis = (size_t)(*f.begin - 'x');
    for (size_t k = e->first; k < e->last && p.axis < 3; k++) {
        if (h->property[k].axis == p.axis)
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: property %c twice", r->path, r->line, *f.begin);
    }
    h->property[h->properties++] = p;
    e->last = h->properties;
    return ET_OK;
}

/* Whether the header can serve: a format, one element vertex, x, y and z in it. */
static et_status ply_check(reader *r, const ply_header *h)
{
    size_t vertices = 0, axes = 0;
    if (h->format == PLY_NONE)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: PLY header without a format", r->path, r->line);
    for (size_t k = 0; k < h->elements; k++) {
        vertices += h->element[k].vertex ? 1 : 0;
        for (size_t i = h->element[k].first; i < h->element[k].last; i++)
            axes += h->property[i].axis < 3 ? 1 : 0;
    }
    if (vertices != 1)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: PLY header with %zu elements vertex", r->path, r->line, vertices);
    if (axes != 3)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: a vertex has not all of the properties x, y, z", r->path, r->line);
    return ET_OK;
}

static et_status ply_read_header(reader *r, ply_header *h)
{
    et_status status;
    field line, word;
    int more, first = 1;
    while ((status = next_line(r, &line, &more)) == ET_OK && more) {
        if (first)
            r->bare_cr = r->cr_ended;
        first = 0;
        if (!next_field(&word, &line, ' ') || field_is(word, "ply") || field_is(word, "comment") || field_is(word, "obj_info"))
            continue;
        if (field_is(word, "end_header"))
            return ply_check(r, h);
        if (field_is(word, "format"))
            status = ply_format(r, h, line);
        else if (field_is(word, "element"))
            status = ply_add_element(r, h, line);
        else if (field_is(word, "property"))
            status = ply_add_property(r, h, line);
        else
            status = unknown_word(r, "PLY keyword", word);
        if (status)
            return status;
    }
    return status ? status : et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the file ends within the PLY header", r->path, r->following);
}

static double ply_value(const unsigned char *p, const ply_type *type, int big)
{
    uint64_t bits = bits_of(p, type->size, big);
    if (type->kind == 'f')
        return type->size == 4 ? float_of(bits) : double_of(bits);
    double value = (double)bits;  /* at most 32 bits: exact */
    uint64_t sign = UINT64_C(1) << (8 * type->size - 1);
    return type->kind == 'i' && (bits & sign) ? value - 2.0 * (double)sign : value;
}

static et_status ply_short(reader *r, const ply_element *e, size_t row, int ascii)
{
    if (ascii)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %s %zu of %zu is missing (truncated)", r->path, r->line, e->name, row + 1, e->count);
    return et_status_fail(r->message, ET_EFORMAT, "%s: %s %zu of %zu is missing (truncated)", r->path, e->name, row + 1, e->count);
}

/* Read row number `row` of a binary element; of a vertex its point. */
static et_status ply_binary_row(reader *r, const ply_header *h, const ply_element *e, size_t row, et_vec3 *p)
{
    int there, big = h->format == PLY_BIG;
    for (size_t k = e->first; k < e->last; k++) {
        const ply_property *property = &h->property[k];
        size_t size = property->list ? property->list->size : property->type->size;
        et_status status = need(r, size, &there);
        if (status)
            return status;
        if (!there)
            return ply_short(r, e, row, 0);
        const unsigned char *at = r->buffer + r->start;
        r->start += size;
        if (property->axis < 3) {
            *axis_of(p, property->axis) = ply_value(at, property->type, big);
        } else if (property->list) {
            double length = ply_value(at, property->list, big);
            if (length < 0)
                return et_status_fail(r->message, ET_EFORMAT, "%s: %s %zu has a list of negative length", r->path, e->name, row + 1);
            if ((status = skip(r, (size_t)length * property->type->size, &there)) != ET_OK)
                return status;
            if (!there)
                return ply_short(r, e, row, 0);
        }
    }
    char c = not_finite(*p);
    return c ? et_status_fail(r->message, ET_EFORMAT, "%s: vertex %zu: %c is not finite", r->path, row + 1, c) : ET_OK;
}

/* Read row number `row` of an element of an ASCII file: a line. */
static et_status ply_ascii_row(reader *r, const ply_header *h, const ply_element *e, size_t row, et_vec3 *p)
{
    field line, f;
    int more;
    et_status status;
    do {
        if ((status = next_line(r, &line, &more)) != ET_OK)
            return status;
        line = trimmed(line);
    } while (more && line.begin == line.end);
    if (!more)
        return ply_short(r, e, row, 1);
    for (size_t k = e->first; k < e->last; k++) {
        const ply_property *property = &h->property[k];
        size_t values = 1;
        int there = next_field(&f, &line, ' ');
        if (property->axis < 3) {
            if ((status = coordinate(r, p, property->axis, f)) != ET_OK)
                return status;
            continue;
        }
        if (there && property->list && !count_of(&values, f))
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: a list's length is not a count", r->path, r->line);
        for (size_t i = 0; there && property->list && i < values; i++)
            there = next_field(&f, &line, ' ');
        if (!there)
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: fewer values than properties", r->path, r->line);
    }
    if (next_field(&f, &line, ' '))
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: more values than properties", r->path, r->line);
    return ET_OK;
}

static et_status read_ply(reader *r, builder *b)
{
    ply_header h;
    memset(&h, 0, sizeof h);
    et_status status = ply_read_header(r, &h);
    for (size_t k = 0; !status && k < h.elements; k++) {
        const ply_element *e = &h.element[k];
        for (size_t row = 0; row < e->count && e->first < e->last; row++) {
            et_vec3 p = { 0, 0, 0 };
            status = (h.format == PLY_ASCII ? ply_ascii_row : ply_binary_row)(r, &h, e, row, &p);
            if (!status && e->vertex)
                status = append(r, b, p);
            if (status)
                return status;
        }
        if (e->vertex)
            break;                /* what follows is of no interest */
    }
    return status;
}

/* ---- PCD ---- */

/* A header keyword's list, by field: columns of the data and where x, y, z stand. */
typedef struct {
    size_t fields, field_of[3];   /* field numbers of x, y, z */
    size_t columns, column[3];
    size_t points, width, height;
    int has_points, has_size, counted;
} pcd_header;

static et_status pcd_fields(reader *r, pcd_header *h, field rest)
{
    static const char *const name[3] = { "x", "y", "z" };
    size_t found[3] = { 0, 0, 0 };
    field f;
    for (h->fields = 0; next_field(&f, &rest, ' '); h->fields++) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (field_is(f, name[axis])) {
                h->field_of[axis] = h->fields;
                found[axis]++;
            }
        }
    }
    for (size_t axis = 0; axis < 3; axis++) {
        if (found[axis] != 1)
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: FIELDS names %s %s", r->path, r->line, name[axis],
                                  found[axis] ? "twice" : "not at all");
        h->column[axis] = h->field_of[axis];
    }
    h->columns = h->fields;
    return ET_OK;
}

static et_status pcd_counts(reader *r, pcd_header *h, field rest)
{
    size_t k = 0, count;
    field f;
    h->columns = 0;
    for (; next_field(&f, &rest, ' '); k++) {
        if (!count_of(&count, f) || count > SIZE_MAX - h->columns)
            return unknown_word(r, "COUNT", f);
        for (size_t axis = 0; axis < 3; axis++) {
            if (h->field_of[axis] == k) {
                if (count != 1)
                    return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: COUNT of %c is not 1", r->path, r->line, "xyz"[axis]);
                h->column[axis] = h->columns;
            }
        }
        h->columns += count;
    }
    h->counted = 1;
    return k == h->fields ? ET_OK : et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %zu COUNT for %zu FIELDS", r->path, r->line, k, h->fields);
}

static et_status pcd_number(reader *r, size_t *value, field rest)
{
    field f;
    (void)next_field(&f, &rest, ' ');
    return count_of(value, f) ? ET_OK : unknown_word(r, "count", f);
}

/* DATA ends the header: whether it can serve. */
static et_status pcd_data(reader *r, pcd_header *h, field rest)
{
    field f;
    size_t product = 0;
    (void)next_field(&f, &rest, ' ');
    if (field_is(f, "binary") || field_is(f, "binary_compressed"))
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: of PCD only DATA ascii is read", r->path, r->line);
    if (!field_is(f, "ascii"))
        return unknown_word(r, "PCD data", f);
    if (h->fields == 0)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: PCD header without FIELDS", r->path, r->line);
    if (h->has_size == 2) {
        if (h->height && h->width > SIZE_MAX / h->height)
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: WIDTH times HEIGHT is too large", r->path, r->line);
        product = h->width * h->height;
        if (h->has_points && product != h->points)
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: WIDTH times HEIGHT is %zu, POINTS %zu", r->path, r->line, product, h->points);
        h->points = product;
        h->has_points = 1;
    }
    return h->has_points ? ET_OK : et_status_fail(r->message, ET_EFORMAT, "%s:%zu: PCD header without POINTS", r->path, r->line);
}

static et_status pcd_keyword(reader *r, pcd_header *h, field word, field rest, int *data)
{
    static const char *const passed[] = { "VERSION", "SIZE", "TYPE", "VIEWPOINT" };
    if (field_is(word, "FIELDS"))
        return pcd_fields(r, h, rest);
    if (field_is(word, "COUNT"))
        return pcd_counts(r, h, rest);
    if (field_is(word, "WIDTH") || field_is(word, "HEIGHT")) {
        h->has_size++;
        return pcd_number(r, field_is(word, "WIDTH") ? &h->width : &h->height, rest);
    }
    if (field_is(word, "POINTS")) {
        h->has_points = 1;
        return pcd_number(r, &h->points, rest);
    }
    if (field_is(word, "DATA")) {
        *data = 1;
        return pcd_data(r, h, rest);
    }
    for (size_t k = 0; k < sizeof passed / sizeof *passed; k++) {
        if (field_is(word, passed[k]))
            return ET_OK;
    }
    return unknown_word(r, "PCD keyword", word);
}

static et_status pcd_point(reader *r, const pcd_header *h, et_vec3 *p, field line)
{
    field f, at[3] = { { NULL, NULL }, { NULL, NULL }, { NULL, NULL } };
    size_t k = 0;
    et_status status = ET_OK;
    for (; next_field(&f, &line, ' '); k++) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (h->column[axis] == k)
                at[axis] = f;
        }
    }
    for (size_t axis = 0; axis < 3 && !status; axis++)
        status = coordinate(r, p, axis, at[axis]);
    if (!status && k != h->columns)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %zu columns, %zu declared", r->path, r->line, k, h->columns);
    return status;
}

static et_status read_pcd(reader *r, builder *b)
{
    pcd_header h;
    et_vec3 p = { 0, 0, 0 };
    et_status status;
    field line, word, rest;
    int more, data = 0;
    memset(&h, 0, sizeof h);
    while ((status = next_line(r, &line, &more)) == ET_OK && more) {
        rest = line = trimmed(line);
        if (line.begin == line.end || *line.begin == '#')
            continue;
        if (!data) {
            (void)next_field(&word, &rest, ' ');
            status = pcd_keyword(r, &h, word, rest, &data);
        } else if (b->count == h.points) {
            status = et_status_fail(r->message, ET_EFORMAT, "%s:%zu: more than the declared %zu points", r->path, r->line, h.points);
        } else if ((status = pcd_point(r, &h, &p, line)) == ET_OK) {
            status = append(r, b, p);
        }
        if (status)
            return status;
    }
    if (!status && !data)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the file ends within the PCD header", r->path, r->following);
    if (!status && b->count < h.points)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the file ends after %zu of %zu points", r->path, r->following, b->count, h.points);
    return status;
}

/* ---- which format ---- */

static int ends_in(const char *path, const char *ending)
{
    size_t n = strlen(path), m = strlen(ending);
    return n >= m && strcasecmp(path + n - m, ending) == 0;
}

/* A binary STL file: its size says so; or a zero byte among the first 84 does, where the size is unknown (the count's highest byte) or
 * where "solid" or the ending make it an STL file. */
static int is_stl_binary(const reader *r, field head, int solid)
{
    size_t n = (size_t)(head.end - head.begin);
    if (n < MAGIC)
        return 0;
    uint64_t size = MAGIC + 50 * bits_of((unsigned char *)head.begin + 80, 4, 0);
    if (r->size)
        return r->size == size || (memchr(head.begin, 0, MAGIC) && (solid || ends_in(r->path, ".stl")));
    return memchr(head.begin, 0, MAGIC) != NULL;
}

static et_status read_any(reader *r, builder *b)
{
    int there;
    et_status status = need(r, BLOCK, &there);
    if (status)
        return status;
    field all = { (char *)r->buffer + r->start, (char *)r->buffer + r->end }, head = all;
    if (field_starts(head, "\xef\xbb\xbf"))
        head.begin += 3;
    field word = { head.begin, head.begin };
    while (word.end < head.end && !blank(*word.end) && *word.end != '\n' && *word.end != '\r')
        word.end++;
    if (field_is(word, "ply")) {
        r->start += (size_t)(head.begin - all.begin);
        return read_ply(r, b);
    }
    field lead = trimmed(head);
    int solid = field_starts(lead, "solid");
    if (is_stl_binary(r, all, solid))
        return read_stl_binary(r, b);
    r->start += (size_t)(head.begin - all.begin);
    if (solid)
        return read_stl_ascii(r, b);
    if (field_starts(head, "# .PCD") || field_is(word, "VERSION") || ends_in(r->path, ".pcd"))
        return read_pcd(r, b);
    if (ends_in(r->path, ".stl"))
        return read_stl_binary(r, b);
    return ends_in(r->path, ".obj") ? read_obj(r, b) : read_table(r, b);
}

/* The size of a regular file, from where it stands; else 0. */
static size_t size_of(FILE *in)
{
    struct stat s;
    off_t at;
    if (fstat(fileno(in), &s) != 0 || !S_ISREG(s.st_mode) || (at = lseek(fileno(in), 0, SEEK_CUR)) < 0 || at > s.st_size)
        return 0;
    return (size_t)(s.st_size - at);
}

static et_status read_open(builder *b, FILE *in, const char *path, et_message *message)
{
    reader r = { 0 };
    r.in = in;
    r.path = path;
    r.message = message;
    r.room = BLOCK;
    r.following = 1;
    r.size = size_of(in);
    r.buffer = malloc(BLOCK + 1);
    if (!r.buffer)
        return out_of_memory(&r);
    et_status status = read_any(&r, b);
    if (!status && b->count == 0)
        status = et_status_fail(message, ET_EFORMAT, "%s: no points", path);
    free(r.buffer);
    free(b->slot);
    return status;
}

/* Reals are read and written with a point, whatever the locale of the program. */
static et_status enter_c_locale(locale_t *c, locale_t *before, et_message *message)
{
    *c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (*c == (locale_t)0)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    *before = uselocale(*c);
    return ET_OK;
}

static void leave_c_locale(locale_t c, locale_t before)
{
    (void)uselocale(before);
    freelocale(c);
}

et_status et_cloud_read(et_cloud *cloud, const char *path, et_message *message)
{
    builder b = { NULL, 0, 0, NULL, 0 };
    locale_t c = (locale_t)0, before = (locale_t)0;
    if (!cloud || !path)
        return et_status_fail(message, ET_EINVAL, "no file to read");
    int standard = strcmp(path, "-") == 0;
    FILE *in = standard ? stdin : fopen(path, "rb");
    if (!in)
        return et_status_fail(message, errno == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot read %s: %s", path, strerror(errno));
    et_status status = enter_c_locale(&c, &before, message);
    if (!status) {
        status = read_open(&b, in, standard ? "standard input" : path, message);
        leave_c_locale(c, before);
    }
    if (!standard)
        (void)fclose(in);
    if (status) {
        free(b.points);
        return status;
    }
    et_vec3 *fitting = realloc(b.points, b.count * sizeof *fitting);
    cloud->points = fitting ? fitting : b.points;
    cloud->count = b.count;
    return ET_OK;
}

void et_cloud_free(et_cloud *cloud)
{
    if (!cloud)
        return;
    free(cloud->points);
    cloud->points = NULL;
    cloud->count = 0;
}

/* ---- writing ---- */

static const char *const format_name[] = { "xyz", "ply-ascii", "ply", "ply-big" };

const char *et_cloud_name(et_cloud_format format)
{
    return (int)format >= ET_CLOUD_XYZ && format <= ET_CLOUD_PLY_BIG ? format_name[format] : NULL;
}

/* The shortest of 15, 16 and 17 significant digits that is read as the same double. */
static void put_real(FILE *out, double x, char after)
{
    char text[40];
    for (int digits = 15; digits <= 17; digits++) {
        (void)snprintf(text, sizeof text, "%.*g", digits, x);
        if (strtod(text, NULL) == x)
            break;
    }
    fputs(text, out);
    putc(after, out);
}

static void put_bytes(FILE *out, double x, int big)
{
    uint64_t bits;
    unsigned char bytes[8];
    memcpy(&bits, &x, sizeof bits);
    for (size_t k = 0; k < 8; k++)
        bytes[k] = (unsigned char)(bits >> (big ? 56 - 8 * k : 8 * k));
    fwrite(bytes, 1, sizeof bytes, out);
}

static void put_cloud(FILE *out, const et_vec3 *points, size_t count, et_cloud_format format)
{
    static const char *const ply[] = { "", "ascii", "binary_little_endian", "binary_big_endian" };
    if (format != ET_CLOUD_XYZ)
        fprintf(out, "ply\nformat %s 1.0\nelement vertex %zu\nproperty double x\nproperty double y\nproperty double z\nend_header\n", ply[format],
                count);
    for (size_t i = 0; i < count && !ferror(out); i++) {
        const et_vec3 *p = &points[i];
        if (format == ET_CLOUD_XYZ || format == ET_CLOUD_PLY_ASCII) {
            put_real(out, p->x, ' ');
            put_real(out, p->y, ' ');
            put_real(out, p->z, '\n');
        } else {
            put_bytes(out, p->x, format == ET_CLOUD_PLY_BIG);
            put_bytes(out, p->y, format == ET_CLOUD_PLY_BIG);
            put_bytes(out, p->z, format == ET_CLOUD_PLY_BIG);
        }
    }
}

et_status et_cloud_write(const char *path, const et_vec3 *points, size_t count, et_cloud_format format, et_message *message)
{
    et_file file;
    locale_t c = (locale_t)0, before = (locale_t)0;
    if (!path || !points || count == 0 || !et_cloud_name(format))
        return et_status_fail(message, ET_EINVAL, "no points to write, or no file or format to write them to");
    if (!et_vec3_finite(points, count))
        return et_status_fail(message, ET_EINVAL, "a point to write is not finite");
    et_status status = et_file_create(&file, path, message);
    if (status)
        return status;
    if ((status = enter_c_locale(&c, &before, message)) != ET_OK) {
        et_file_abandon(&file);
        return status;
    }
    put_cloud(file.stream, points, count, format);
    leave_c_locale(c, before);
    return et_file_commit(&file, message);
}
