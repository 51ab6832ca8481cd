/* Points as text and as PLY. */
#include "io/cloud_parts.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

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

void cloud_put(FILE *out, const et_vec3 *points, size_t count, et_cloud_format format)
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
