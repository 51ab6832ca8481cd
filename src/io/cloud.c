#include "etalon/io/cloud.h"
#include "etalon/io/file.h"
#include "io/cloud_parts.h"
#include <errno.h>
#include <locale.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

static int field_starts(cloud_field f, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(f.end - f.begin) >= n && strncasecmp(f.begin, word, n) == 0;
}

static int ends_in(const char *path, const char *ending)
{
    size_t n = strlen(path), m = strlen(ending);
    return n >= m && strcasecmp(path + n - m, ending) == 0;
}

/* A binary STL file: its size says so; or a zero byte among the first 84 does, where the size is unknown (the count's highest byte) or
 * where "solid" or the ending make it an STL file. */
static int is_stl_binary(const cloud_reader *r, cloud_field head, int solid)
{
    size_t n = (size_t)(head.end - head.begin);
    if (n < CLOUD_MAGIC)
        return 0;
    uint64_t size = CLOUD_MAGIC + 50 * cloud_bits((unsigned char *)head.begin + 80, 4, 0);
    if (r->size)
        return r->size == size || (memchr(head.begin, 0, CLOUD_MAGIC) && (solid || ends_in(r->path, ".stl")));
    return memchr(head.begin, 0, CLOUD_MAGIC) != NULL;
}

static et_status read_any(cloud_reader *r, cloud_builder *b)
{
    int there;
    et_status status = cloud_need(r, CLOUD_BLOCK, &there);
    if (status)
        return status;
    cloud_field all = { (char *)r->buffer + r->start, (char *)r->buffer + r->end }, head = all;
    if (field_starts(head, "\xef\xbb\xbf"))
        head.begin += 3;
    cloud_field word = { head.begin, head.begin };
    while (word.end < head.end && !cloud_blank(*word.end) && *word.end != '\n' && *word.end != '\r')
        word.end++;
    if (cloud_field_is(word, "ply")) {
        r->start += (size_t)(head.begin - all.begin);
        return cloud_read_ply(r, b);
    }
    cloud_field lead = cloud_trimmed(head);
    int solid = field_starts(lead, "solid");
    if (is_stl_binary(r, all, solid))
        return cloud_read_stl_binary(r, b);
    r->start += (size_t)(head.begin - all.begin);
    if (solid)
        return cloud_read_stl_ascii(r, b);
    if (field_starts(head, "# .PCD") || cloud_field_is(word, "VERSION") || ends_in(r->path, ".pcd"))
        return cloud_read_pcd(r, b);
    if (ends_in(r->path, ".stl"))
        return cloud_read_stl_binary(r, b);
    return ends_in(r->path, ".obj") ? cloud_read_obj(r, b) : cloud_read_table(r, b);
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

static et_status read_open(cloud_builder *b, FILE *in, const char *path, et_message *message)
{
    cloud_reader r = { 0 };
    r.in = in;
    r.path = path;
    r.message = message;
    r.room = CLOUD_BLOCK;
    r.following = 1;
    r.size = size_of(in);
    r.buffer = malloc(CLOUD_BLOCK + 1);
    if (!r.buffer)
        return cloud_out_of_memory(&r);
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
    cloud_builder b = { NULL, 0, 0, NULL, 0 };
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

static const char *const format_name[] = { "xyz", "ply-ascii", "ply", "ply-big" };

const char *et_cloud_name(et_cloud_format format)
{
    return (int)format >= ET_CLOUD_XYZ && format <= ET_CLOUD_PLY_BIG ? format_name[format] : NULL;
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
    cloud_put(file.stream, points, count, format);
    leave_c_locale(c, before);
    return et_file_commit(&file, message);
}
