/* OBJ: the lines v. */
#include "io/cloud_parts.h"
#include <string.h>

et_status cloud_read_obj(cloud_reader *r, cloud_builder *b)
{
    et_status status;
    et_vec3 p = { 0, 0, 0 };
    cloud_field line, f;
    int more;
    r->continued = 1;
    while ((status = cloud_next_line(r, &line, &more)) == ET_OK && more) {
        char *comment = memchr(line.begin, '#', (size_t)(line.end - line.begin));
        if (comment)
            line.end = comment;
        if (!cloud_next_field(&f, &line, ' ') || f.end - f.begin != 1 || *f.begin != 'v')
            continue;
        if ((status = cloud_three(r, &p, &line)) != ET_OK || (status = cloud_append(r, b, p)) != ET_OK)
            return status;
    }
    return status;
}
