/* PCD: the data ascii. */
#include "io/cloud_parts.h"
#include <stdint.h>
#include <string.h>

/* A header keyword's list, by field: columns of the data and where x, y, z stand. */
typedef struct {
    size_t fields, field_of[3];   /* field numbers of x, y, z */
    size_t columns, column[3];
    size_t points, width, height;
    int has_points, has_size, counted;
} pcd_header;

static et_status pcd_fields(cloud_reader *r, pcd_header *h, cloud_field rest)
{
    static const char *const name[3] = { "x", "y", "z" };
    size_t found[3] = { 0, 0, 0 };
    cloud_field f;
    for (h->fields = 0; cloud_next_field(&f, &rest, ' '); h->fields++) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (cloud_field_is(f, name[axis])) {
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

static et_status pcd_counts(cloud_reader *r, pcd_header *h, cloud_field rest)
{
    size_t k = 0, count;
    cloud_field f;
    h->columns = 0;
    for (; cloud_next_field(&f, &rest, ' '); k++) {
        if (!cloud_count(&count, f) || count > SIZE_MAX - h->columns)
            return cloud_unknown_word(r, "COUNT", f);
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

static et_status pcd_number(cloud_reader *r, size_t *value, cloud_field rest)
{
    cloud_field f;
    (void)cloud_next_field(&f, &rest, ' ');
    return cloud_count(value, f) ? ET_OK : cloud_unknown_word(r, "count", f);
}

/* DATA ends the header: whether it can serve. */
static et_status pcd_data(cloud_reader *r, pcd_header *h, cloud_field rest)
{
    cloud_field f;
    size_t product = 0;
    (void)cloud_next_field(&f, &rest, ' ');
    if (cloud_field_is(f, "binary") || cloud_field_is(f, "binary_compressed"))
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: of PCD only DATA ascii is read", r->path, r->line);
    if (!cloud_field_is(f, "ascii"))
        return cloud_unknown_word(r, "PCD data", f);
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

static et_status pcd_keyword(cloud_reader *r, pcd_header *h, cloud_field word, cloud_field rest, int *data)
{
    static const char *const passed[] = { "VERSION", "SIZE", "TYPE", "VIEWPOINT" };
    if (cloud_field_is(word, "FIELDS"))
        return pcd_fields(r, h, rest);
    if (cloud_field_is(word, "COUNT"))
        return pcd_counts(r, h, rest);
    if (cloud_field_is(word, "WIDTH") || cloud_field_is(word, "HEIGHT")) {
        h->has_size++;
        return pcd_number(r, cloud_field_is(word, "WIDTH") ? &h->width : &h->height, rest);
    }
    if (cloud_field_is(word, "POINTS")) {
        h->has_points = 1;
        return pcd_number(r, &h->points, rest);
    }
    if (cloud_field_is(word, "DATA")) {
        *data = 1;
        return pcd_data(r, h, rest);
    }
    for (size_t k = 0; k < sizeof passed / sizeof *passed; k++) {
        if (cloud_field_is(word, passed[k]))
            return ET_OK;
    }
    return cloud_unknown_word(r, "PCD keyword", word);
}

static et_status pcd_point(cloud_reader *r, const pcd_header *h, et_vec3 *p, cloud_field line)
{
    cloud_field f, at[3] = { { NULL, NULL }, { NULL, NULL }, { NULL, NULL } };
    size_t k = 0;
    et_status status = ET_OK;
    for (; cloud_next_field(&f, &line, ' '); k++) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (h->column[axis] == k)
                at[axis] = f;
        }
    }
    for (size_t axis = 0; axis < 3 && !status; axis++)
        status = cloud_coordinate(r, p, axis, at[axis]);
    if (!status && k != h->columns)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %zu columns, %zu declared", r->path, r->line, k, h->columns);
    return status;
}

et_status cloud_read_pcd(cloud_reader *r, cloud_builder *b)
{
    pcd_header h;
    et_vec3 p = { 0, 0, 0 };
    et_status status;
    cloud_field line, word, rest;
    int more, data = 0;
    memset(&h, 0, sizeof h);
    while ((status = cloud_next_line(r, &line, &more)) == ET_OK && more) {
        rest = line = cloud_trimmed(line);
        if (line.begin == line.end || *line.begin == '#')
            continue;
        if (!data) {
            (void)cloud_next_field(&word, &rest, ' ');
            status = pcd_keyword(r, &h, word, rest, &data);
        } else if (b->count == h.points) {
            status = et_status_fail(r->message, ET_EFORMAT, "%s:%zu: more than the declared %zu points", r->path, r->line, h.points);
        } else if ((status = pcd_point(r, &h, &p, line)) == ET_OK) {
            status = cloud_append(r, b, p);
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
