/* PLY, ASCII and binary of either byte order: the element vertex. */
#include "io/cloud_parts.h"
#include <stdint.h>
#include <string.h>

enum { ELEMENTS = 64, PROPERTIES = 1024 }; /* at most, in a header */

typedef struct { const char *name, *alias; size_t size; char kind; } ply_type;
static const ply_type ply_types[] = {
    { "char", "int8", 1, 'i' }, { "uchar", "uint8", 1, 'u' }, { "short", "int16", 2, 'i' }, { "ushort", "uint16", 2, 'u' },
    { "int", "int32", 4, 'i' }, { "uint", "uint32", 4, 'u' }, { "float", "float32", 4, 'f' }, { "double", "float64", 8, 'f' },
};

/* A property: list null unless it is a list (then the type of its length); axis 0, 1, 2 for a vertex's x, y, z, else 3. */
typedef struct { const ply_type *type, *list; size_t axis; } ply_property;
typedef struct { char name[CLOUD_WORD]; size_t count, first, last; int vertex; } ply_element; /* properties first .. last-1 */
typedef struct {
    enum { PLY_NONE = 0, PLY_ASCII, PLY_LITTLE, PLY_BIG } format;
    ply_element element[ELEMENTS];
    size_t elements;
    ply_property property[PROPERTIES];
    size_t properties;
} ply_header;

static const ply_type *ply_type_of(cloud_field f)
{
    for (size_t k = 0; k < sizeof ply_types / sizeof *ply_types; k++) {
        if (cloud_field_is(f, ply_types[k].name) || cloud_field_is(f, ply_types[k].alias))
            return &ply_types[k];
    }
    return NULL;
}

static et_status ply_format(cloud_reader *r, ply_header *h, cloud_field rest)
{
    cloud_field f, version;
    (void)cloud_next_field(&f, &rest, ' ');
    (void)cloud_next_field(&version, &rest, ' ');
    if (cloud_field_is(f, "ascii"))
        h->format = PLY_ASCII;
    else if (cloud_field_is(f, "binary_little_endian"))
        h->format = PLY_LITTLE;
    else if (cloud_field_is(f, "binary_big_endian"))
        h->format = PLY_BIG;
    else
        return cloud_unknown_word(r, "PLY format", f);
    return cloud_field_is(version, "1.0") ? ET_OK : cloud_unknown_word(r, "PLY version", version);
}

static et_status ply_add_element(cloud_reader *r, ply_header *h, cloud_field rest)
{
    cloud_field name, count;
    char word[CLOUD_WORD];
    (void)cloud_next_field(&name, &rest, ' ');
    (void)cloud_next_field(&count, &rest, ' ');
    if (h->elements == ELEMENTS)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: more than %d elements", r->path, r->line, (int)ELEMENTS);
    ply_element *e = &h->element[h->elements];
    if (!cloud_count(&e->count, count)) {
        cloud_show(word, count);
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: \"%s\" is not a count", r->path, r->line, word);
    }
    cloud_show(e->name, name);
    e->vertex = strcmp(e->name, "vertex") == 0;
    e->first = e->last = h->properties;
    h->elements++;
    return ET_OK;
}

static et_status ply_add_property(cloud_reader *r, ply_header *h, cloud_field rest)
{
    cloud_field f;
    ply_property p = { NULL, NULL, 3 };
    if (h->elements == 0 || h->properties == PROPERTIES)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %s", r->path, r->line,
                              h->elements ? "more properties than are read" : "property before any element");
    (void)cloud_next_field(&f, &rest, ' ');
    if (cloud_field_is(f, "list")) {
        (void)cloud_next_field(&f, &rest, ' ');
        p.list = ply_type_of(f);
        if (!p.list || p.list->kind == 'f')
            return cloud_unknown_word(r, "PLY list length type", f);
        (void)cloud_next_field(&f, &rest, ' ');
    }
    p.type = ply_type_of(f);
    if (!p.type)
        return cloud_unknown_word(r, "PLY type", f);
    if (!cloud_next_field(&f, &rest, ' '))
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
static et_status ply_check(cloud_reader *r, const ply_header *h)
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

static et_status ply_read_header(cloud_reader *r, ply_header *h)
{
    et_status status;
    cloud_field line, word;
    int more, first = 1;
    while ((status = cloud_next_line(r, &line, &more)) == ET_OK && more) {
        if (first)
            r->bare_cr = r->cr_ended;
        first = 0;
        if (!cloud_next_field(&word, &line, ' ') || cloud_field_is(word, "ply") || cloud_field_is(word, "comment") ||
            cloud_field_is(word, "obj_info"))
            continue;
        if (cloud_field_is(word, "end_header"))
            return ply_check(r, h);
        if (cloud_field_is(word, "format"))
            status = ply_format(r, h, line);
        else if (cloud_field_is(word, "element"))
            status = ply_add_element(r, h, line);
        else if (cloud_field_is(word, "property"))
            status = ply_add_property(r, h, line);
        else
            status = cloud_unknown_word(r, "PLY keyword", word);
        if (status)
            return status;
    }
    return status ? status : et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the file ends within the PLY header", r->path, r->following);
}

static double double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static double ply_value(const unsigned char *p, const ply_type *type, int big)
{
    uint64_t bits = cloud_bits(p, type->size, big);
    if (type->kind == 'f')
        return type->size == 4 ? cloud_float(bits) : double_of(bits);
    double value = (double)bits;  /* at most 32 bits: exact */
    uint64_t sign = UINT64_C(1) << (8 * type->size - 1);
    return type->kind == 'i' && (bits & sign) ? value - 2.0 * (double)sign : value;
}

static et_status ply_short(cloud_reader *r, const ply_element *e, size_t row, int ascii)
{
    if (ascii)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %s %zu of %zu is missing (truncated)", r->path, r->line, e->name, row + 1, e->count);
    return et_status_fail(r->message, ET_EFORMAT, "%s: %s %zu of %zu is missing (truncated)", r->path, e->name, row + 1, e->count);
}

/* Read row number `row` of a binary element; of a vertex its point. */
static et_status ply_binary_row(cloud_reader *r, const ply_header *h, const ply_element *e, size_t row, et_vec3 *p)
{
    int there, big = h->format == PLY_BIG;
    for (size_t k = e->first; k < e->last; k++) {
        const ply_property *property = &h->property[k];
        size_t size = property->list ? property->list->size : property->type->size;
        et_status status = cloud_need(r, size, &there);
        if (status)
            return status;
        if (!there)
            return ply_short(r, e, row, 0);
        const unsigned char *at = r->buffer + r->start;
        r->start += size;
        if (property->axis < 3) {
            *cloud_axis(p, property->axis) = ply_value(at, property->type, big);
        } else if (property->list) {
            double length = ply_value(at, property->list, big);
            if (length < 0)
                return et_status_fail(r->message, ET_EFORMAT, "%s: %s %zu has a list of negative length", r->path, e->name, row + 1);
            if ((status = cloud_skip(r, (size_t)length * property->type->size, &there)) != ET_OK)
                return status;
            if (!there)
                return ply_short(r, e, row, 0);
        }
    }
    char c = cloud_not_finite(*p);
    return c ? et_status_fail(r->message, ET_EFORMAT, "%s: vertex %zu: %c is not finite", r->path, row + 1, c) : ET_OK;
}

/* Read row number `row` of an element of an ASCII file: a line. */
static et_status ply_ascii_row(cloud_reader *r, const ply_header *h, const ply_element *e, size_t row, et_vec3 *p)
{
    cloud_field line, f;
    int more;
    et_status status;
    do {
        if ((status = cloud_next_line(r, &line, &more)) != ET_OK)
            return status;
        line = cloud_trimmed(line);
    } while (more && line.begin == line.end);
    if (!more)
        return ply_short(r, e, row, 1);
    for (size_t k = e->first; k < e->last; k++) {
        const ply_property *property = &h->property[k];
        size_t values = 1;
        int there = cloud_next_field(&f, &line, ' ');
        if (property->axis < 3) {
            if ((status = cloud_coordinate(r, p, property->axis, f)) != ET_OK)
                return status;
            continue;
        }
        if (there && property->list && !cloud_count(&values, f))
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: a list's length is not a count", r->path, r->line);
        for (size_t i = 0; there && property->list && i < values; i++)
            there = cloud_next_field(&f, &line, ' ');
        if (!there)
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: fewer values than properties", r->path, r->line);
    }
    if (cloud_next_field(&f, &line, ' '))
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: more values than properties", r->path, r->line);
    return ET_OK;
}

et_status cloud_read_ply(cloud_reader *r, cloud_builder *b)
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
                status = cloud_append(r, b, p);
            if (status)
                return status;
        }
        if (e->vertex)
            break;                /* what follows is of no interest */
    }
    return status;
}
