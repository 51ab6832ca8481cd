/* STL, binary and ASCII: each distinct vertex once. */
#include "io/cloud_parts.h"
#include <stdint.h>

et_status cloud_read_stl_binary(cloud_reader *r, cloud_builder *b)
{
    int there;
    et_status status = cloud_need(r, CLOUD_MAGIC, &there);
    if (status)
        return status;
    if (!there)
        return et_status_fail(r->message, ET_EFORMAT, "%s: STL header is not complete", r->path);
    uint64_t count = cloud_bits(r->buffer + r->start + 80, 4, 0);
    r->start += CLOUD_MAGIC;
    for (uint64_t t = 0; t < count; t++) {
        if ((status = cloud_need(r, 50, &there)) != ET_OK)
            return status;
        if (!there)
            return et_status_fail(r->message, ET_EFORMAT, "%s: triangle %llu of %llu is missing (truncated)", r->path,
                                  (unsigned long long)t + 1, (unsigned long long)count);
        for (size_t k = 12; k < 48; k += 12) {
            const unsigned char *at = r->buffer + r->start + k;
            et_vec3 p = { cloud_float(cloud_bits(at, 4, 0)), cloud_float(cloud_bits(at + 4, 4, 0)), cloud_float(cloud_bits(at + 8, 4, 0)) };
            if (cloud_not_finite(p))
                return et_status_fail(r->message, ET_EFORMAT, "%s: triangle %llu, vertex %zu: %c is not finite", r->path,
                                      (unsigned long long)t + 1, k / 12, cloud_not_finite(p));
            if ((status = cloud_append_distinct(r, b, p)) != ET_OK)
                return status;
        }
        r->start += 50;
    }
    if ((status = cloud_need(r, 1, &there)) != ET_OK)
        return status;
    return there ? et_status_fail(r->message, ET_EFORMAT, "%s: more bytes than its %llu triangles", r->path, (unsigned long long)count) : ET_OK;
}

/* One line of an ASCII STL file; *open: inside a solid. */
static et_status stl_line(cloud_reader *r, cloud_builder *b, cloud_field line, int *open)
{
    static const char *const passed[] = { "facet", "outer", "loop", "endloop", "endfacet" };
    et_status status;
    et_vec3 p = { 0, 0, 0 };
    cloud_field f;
    while (cloud_next_field(&f, &line, ' ')) {
        if (cloud_field_is(f, "solid") || cloud_field_is(f, "endsolid")) {
            *open = cloud_field_is(f, "solid");
            return ET_OK;         /* a name follows */
        }
        if (cloud_field_is(f, "vertex")) {
            if ((status = cloud_three(r, &p, &line)) != ET_OK || (status = cloud_append_distinct(r, b, p)) != ET_OK)
                return status;
            continue;
        }
        if (cloud_field_is(f, "normal")) {
            for (int k = 0; k < 3; k++)
                (void)cloud_next_field(&f, &line, ' ');
            continue;
        }
        size_t k = 0;
        while (k < sizeof passed / sizeof *passed && !cloud_field_is(f, passed[k]))
            k++;
        if (k == sizeof passed / sizeof *passed)
            return cloud_unknown_word(r, "STL keyword", f);
    }
    return ET_OK;
}

et_status cloud_read_stl_ascii(cloud_reader *r, cloud_builder *b)
{
    et_status status;
    cloud_field line;
    int more, open = 0;
    while ((status = cloud_next_line(r, &line, &more)) == ET_OK && more) {
        if ((status = stl_line(r, b, line, &open)) != ET_OK)
            return status;
    }
    if (!status && open)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the file ends without endsolid (truncated)", r->path, r->following);
    return status;
}
