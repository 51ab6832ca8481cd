/* clouds: what the tests of reading and writing clouds share: texts, the points that must be read, numbers as bytes. */
#ifndef TESTS_IO_CLOUDS_H
#define TESTS_IO_CLOUDS_H
#include "etalon/io/cloud.h"
#include "golden.h"
#include "some_shell.h"
#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <sys/wait.h>

enum { MOST = 24, PATH = 256 };

/* ---- a file's text, and the points it must be read as ---- */

typedef struct {
    char *bytes;
    size_t n, room;
    const char *end_of_line;
    et_vec3 want[4 * MOST];
    size_t count;
} text;

static inline void put_bytes(text *t, const void *bytes, size_t n)
{
    if (t->n + n > t->room) {
        t->room = 2 * (t->n + n) + 256;
        t->bytes = realloc(t->bytes, t->room);
        if (!t->bytes)
            abort();
    }
    if (n > 0)
        memcpy(t->bytes + t->n, bytes, n);
    t->n += n;
}

static inline void put(text *t, const char *format, ...)
{
    char buffer[1024];
    va_list list;

    va_start(list, format);
    const int n = vsnprintf(buffer, sizeof buffer, format, list);
    va_end(list);
    put_bytes(t, buffer, n < 0 ? 0 : (size_t)n);
}

static inline void end_line(text *t)
{
    put(t, "%s", t->end_of_line);
}

static inline void spill(const char *path, const text *t)
{
    FILE *const f = fopen(path, "wb");

    if (f) {
        if (t->n > 0)
            fwrite(t->bytes, 1, t->n, f);
        fclose(f);
    }
}

static inline bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* ---- reals and how they are written ---- */

static inline double any_real(gen *g)
{
    uint64_t bits;
    double x;

    switch (gen_upto(g, 7)) {
    case 0: return 0;
    case 1: return gen_real(g, 0, 10);
    case 2: return gen_real(g, -1, 1);
    case 3: return gen_real(g, 0, -1e300);
    case 4: return gen_real(g, 0, 1e-300);
    case 5: return (double)gen_upto(g, UINT64_C(1) << 60);
    case 6: return -0.0;
    default: bits = gen_upto(g, UINT64_MAX); break;
    }
    memcpy(&x, &bits, sizeof x);
    return isfinite(x) ? x : 0x1.fffffffffffffp1023;
}

/* A number as text, any of the ways that are read; its value as strtod sees it. */
static inline double put_real(gen *g, text *t)
{
    static const char *const way[] = { "%.17g", "%.3f", "%e", "%.15g", "%+.6f", "%a", "%.40e", "%.0f.", "%.0f.5", "%.0f.50000000000000000000001",
                                       "%.0f.4999999999999999999999", "%.0fe0", "0000%.0f", "%.16E" };
    const size_t k = (size_t)gen_upto(g, sizeof way / sizeof *way);
    char token[800];
    double x = any_real(g);

    if (k == sizeof way / sizeof *way) {  /* a Fortran exponent */
        snprintf(token, sizeof token, "%.16e", x);
        const double value = strtod(token, NULL);
        *strchr(token, 'e') = gen_chance(g, 2) ? 'd' : 'D';
        put(t, "%s", token);
        return value;
    }
    if (k >= 7 && k <= 12 && !(fabs(x) < 0x1p60))
        x = 0x1p53 - 1;
    if (k == 12)
        x = fabs(x);
    snprintf(token, sizeof token, way[k], x);
    if (!isfinite(strtod(token, NULL)))
        snprintf(token, sizeof token, "1");
    put(t, "%s", token);
    return strtod(token, NULL);
}

/* ---- reading, and what every reading promises ---- */

/* Read; the promises that hold whatever the file is. */
static inline et_status read_checked(gen *g, et_cloud *cloud, const char *path, et_message *message, bool *ok)
{
    static et_vec3 nowhere;
    const et_cloud unused = { &nowhere, 12345 };

    *cloud = unused;
    message->text[0] = 0;
    const et_status status = et_cloud_read(cloud, path, message);
    if (status == ET_OK) {
        *ok = gen_check(g, cloud->count >= 1 && cloud->points && et_vec3_finite(cloud->points, cloud->count), "not finite points");
    } else {
        char place[PATH + 4];
        snprintf(place, sizeof place, "%s:", path);
        *ok = gen_check(g, status == ET_EFORMAT, "status %s", et_status_text(status)) &&
              gen_check(g, strncmp(message->text, place, strlen(place)) == 0, "message %s", message->text) &&
              gen_check(g, cloud->points == unused.points && cloud->count == unused.count, "*cloud changed");
        *cloud = (et_cloud){ NULL, 0 };
    }
    return status;
}

static inline bool read_as_wanted(gen *g, const text *t, const char *path)
{
    et_cloud cloud;
    et_message message;
    bool ok;
    const et_status status = read_checked(g, &cloud, path, &message, &ok);

    ok = ok && gen_check(g, status == ET_OK, "%s", message.text);
    ok = ok && gen_check(g, cloud.count == t->count, "%zu points, %zu wanted", cloud.count, t->count);
    for (size_t i = 0; ok && i < t->count; i++) {
        const et_vec3 a = cloud.points[i], b = t->want[i];
        ok = gen_check(g, same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z), "point %zu: %a %a %a, wanted %a %a %a", i, a.x, a.y,
                       a.z, b.x, b.y, b.z);
    }
    et_cloud_free(&cloud);
    return ok;
}

/* Write the text, read it, remove it. */
static inline verdict verdict_of(gen *g, text *t, const char *ending)
{
    char path[PATH];

    spill(some_path(path, ending), t);
    const bool ok = read_as_wanted(g, t, path);
    if (!ok)
        gen_note(g, "%.*s", (int)(t->n < 2000 ? t->n : 2000), t->bytes);
    unlink(path);
    free(t->bytes);
    return ok ? PASS : FAIL;
}

static inline const char *some_end_of_line(gen *g)
{
    static const char *const ends[] = { "\n", "\r\n", "\r" };

    return ends[gen_upto(g, 2)];
}

static inline void put_mark(gen *g, text *t)
{
    if (gen_chance(g, 4))
        put(t, "\xef\xbb\xbf");
}

/* ---- bytes of numbers ---- */

static inline void put_number(text *t, const void *x, size_t size, bool big)
{
    const uint16_t one = 1;
    const unsigned char *from = x;
    unsigned char low = 0, bytes[8];

    memcpy(&low, &one, 1);
    for (size_t k = 0; k < size && k < sizeof bytes; k++)
        bytes[k] = from[(low == 1) == big ? size - 1 - k : k];
    put_bytes(t, bytes, size);
}

static inline float some_float(gen *g)
{
    static const float hard[] = { 0.0f, -0.0f, 1.0f, 0.1f, -2.5e-45f, 3.4028235e38f, 1e-30f };

    return gen_chance(g, 2) ? (float)gen_real(g, -10, 10) : hard[gen_upto(g, 6)];
}

/* ---- STL ---- */

/* Keep a vertex unless it is there already (by value). */
static inline void want_distinct(text *t, et_vec3 p)
{
    for (size_t i = 0; i < t->count; i++)
        if (t->want[i].x == p.x && t->want[i].y == p.y && t->want[i].z == p.z)
            return;
    t->want[t->count++] = p;
}

static inline void put_stl_ascii(gen *g, text *t, size_t triangles)
{
    const bool upper = gen_chance(g, 4), flat = gen_chance(g, 4);
    text corner = { .end_of_line = "" };

    put(t, upper ? "SOLID the name vertex 1 2 3" : "solid");
    end_line(t);
    for (size_t k = 0; k < triangles; k++) {
        put(t, upper ? "FACET NORMAL nan 0 1e9" : " facet normal 0 0 1");
        flat ? put(t, " ") : end_line(t);
        put(t, upper ? "OUTER LOOP" : "outer loop");
        for (size_t v = 0; v < 3; v++) {
            et_vec3 p;
            flat ? put(t, " ") : end_line(t);
            put(t, upper ? "VERTEX " : "  vertex\t");
            if (v > 0 || k == 0 || gen_chance(g, 2)) {          /* else the last corner once more */
                corner.n = 0;
                p.x = put_real(g, &corner);
                put(&corner, " ");
                p.y = put_real(g, &corner);
                put(&corner, " ");
                p.z = put_real(g, &corner);
                want_distinct(t, p);
            }
            put_bytes(t, corner.bytes, corner.n);
        }
        flat ? put(t, " ") : end_line(t);
        put(t, upper ? "ENDLOOP ENDFACET" : "endloop");
        end_line(t);
        if (!upper) {
            put(t, "endfacet");
            end_line(t);
        }
    }
    free(corner.bytes);
    put(t, upper ? "ENDSOLID the name" : "endsolid");
    if (!gen_chance(g, 3))
        end_line(t);
}

static inline void put_stl_binary(gen *g, text *t, size_t triangles)
{
    char head[80] = { 0 };
    const uint32_t count = (uint32_t)triangles;
    const float normal[3] = { NAN, 0, INFINITY };
    const uint16_t attribute = 0x0a0d;

    memcpy(head, gen_chance(g, 2) ? "solid but binary" : "made by hand", 12);
    if (gen_chance(g, 4))
        memset(head, ' ', sizeof head);
    put_bytes(t, head, sizeof head);
    put_number(t, &count, 4, false);
    for (size_t k = 0; k < triangles; k++) {
        for (size_t i = 0; i < 3; i++)
            put_number(t, &normal[i], 4, false);
        for (size_t v = 0; v < 3; v++) {
            const float c[3] = { some_float(g), some_float(g), some_float(g) };
            for (size_t i = 0; i < 3; i++)
                put_number(t, &c[i], 4, false);
            want_distinct(t, (et_vec3){ (double)c[0], (double)c[1], (double)c[2] });
        }
        put_number(t, &attribute, 2, false);
    }
}
#endif
