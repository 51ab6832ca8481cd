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

static void put_bytes(text *t, const void *bytes, size_t n)
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

static void put(text *t, const char *format, ...)
{
    char buffer[1024];
    va_list list;

    va_start(list, format);
    const int n = vsnprintf(buffer, sizeof buffer, format, list);
    va_end(list);
    put_bytes(t, buffer, n < 0 ? 0 : (size_t)n);
}

static void end_line(text *t)
{
    put(t, "%s", t->end_of_line);
}

static void spill(const char *path, const text *t)
{
    FILE *const f = fopen(path, "wb");

    if (f) {
        if (t->n > 0)
            fwrite(t->bytes, 1, t->n, f);
        fclose(f);
    }
}

static bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* ---- reals and how they are written ---- */

static double any_real(gen *g)
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
static double put_real(gen *g, text *t)
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
static et_status read_checked(gen *g, et_cloud *cloud, const char *path, et_message *message, bool *ok)
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

static bool read_as_wanted(gen *g, const text *t, const char *path)
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
static verdict verdict_of(gen *g, text *t, const char *ending)
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

static const char *some_end_of_line(gen *g)
{
    static const char *const ends[] = { "\n", "\r\n", "\r" };

    return ends[gen_upto(g, 2)];
}

static void put_mark(gen *g, text *t)
{
    if (gen_chance(g, 4))
        put(t, "\xef\xbb\xbf");
}

/* ---- XYZ and CSV ---- */

static void put_rest(gen *g, text *t)
{
    static const char *const noise[] = { "", "   ", "\t", "# 7 7 7", "// 8,8,8", "% 9 9 9", "  #", "//" };

    while (gen_chance(g, 4)) {
        put(t, "%s", noise[gen_upto(g, 7)]);
        end_line(t);
    }
}

static void put_separator(gen *g, text *t, char kind)
{
    static const char *const blanks[] = { "", " ", "\t", "  \t" };

    if (kind == ' ') {
        put(t, "%s", blanks[1 + gen_upto(g, 2)]);
        return;
    }
    put(t, "%s%c", blanks[gen_upto(g, 3)], kind);
    put(t, "%s", blanks[gen_upto(g, 3)]);
}

/* One line: the coordinates in the columns x, y, z, anything between and after. */
static void put_row(gen *g, text *t, const size_t column[3], size_t columns, char kind)
{
    static const char *const extra[] = { "0", "nan", "name", "1.5.2", "-", "+inf" };
    double *const axis[3] = { &t->want[t->count].x, &t->want[t->count].y, &t->want[t->count].z };

    if (gen_chance(g, 4))
        put(t, "  ");
    for (size_t k = 0; k < columns; k++) {
        if (k > 0)
            put_separator(g, t, kind);
        size_t a = 0;
        while (a < 3 && column[a] != k)
            a++;
        if (a < 3)
            *axis[a] = put_real(g, t);
        else
            put(t, "%s", extra[gen_upto(g, 5)]);
    }
    if (gen_chance(g, 8))
        put(t, "%s", gen_chance(g, 2) ? " # note 1,2;3" : "\t// note");
    else if (gen_chance(g, 8))
        put(t, " \t");
    t->count++;
}

verdict prop_cloud_read_xyz(gen *g)
{
    static const char kinds[] = " ,;";
    text t = { .end_of_line = some_end_of_line(g) };
    size_t column[3] = { 0, 1, 2 }, columns = 3;
    const size_t n = 1 + (size_t)gen_upto(g, MOST - 1);
    char kind = kinds[gen_upto(g, 2)];
    const bool mixed = gen_chance(g, 4), named = gen_chance(g, 3);

    put_mark(g, &t);
    put_rest(g, &t);
    if (gen_chance(g, 4)) {
        put(&t, " %zu ", n);
        end_line(&t);
        put_rest(g, &t);
    }
    if (named) {                          /* x, y, z among five columns */
        const char *name[5] = { "id", "label", "id2", "r", "xy" };
        static const char *const spelt[2][3] = { { "x", "Y", "z" }, { "\"X\"", "\"y\"", "\" z \"" } };
        const size_t quoted = kind == ' ' ? 0 : (size_t)gen_upto(g, 1);
        for (size_t a = 0; a < 3; a++) {
            column[a] = (a + (size_t)gen_upto(g, 4)) % 5;
            while (name[column[a]] == spelt[quoted][0] || name[column[a]] == spelt[quoted][1])
                column[a] = (column[a] + 1) % 5;
            name[column[a]] = spelt[quoted][a];
        }
        columns = 5;
        for (size_t k = 0; k < columns; k++) {
            if (k > 0)
                put_separator(g, &t, kind);
            put(&t, "%s", name[k]);
        }
        end_line(&t);
    } else if (gen_chance(g, 3)) {
        put(&t, "%s", gen_chance(g, 2) ? "lat lon height" : "Easting [m], Northing [m], H");
        end_line(&t);
    }
    for (size_t i = 0; i < n; i++) {
        put_rest(g, &t);
        if (mixed && !named)
            kind = kinds[gen_upto(g, 2)];
        put_row(g, &t, column, named ? 5 : 3 + (size_t)gen_upto(g, 2), kind);
        if (i + 1 < n || !gen_chance(g, 3))
            end_line(&t);
    }
    gen_label(g, named ? "columns named" : "first three columns");
    return verdict_of(g, &t, gen_chance(g, 2) ? ".csv" : ".xyz");
}

/* Lines far longer than a block, and a block's end anywhere in a line: the points, and the number of a bad line. */
verdict prop_cloud_read_long(gen *g)
{
    enum { BLOCK = 1 << 18, LONG = 1 << 21 };
    text t = { .end_of_line = some_end_of_line(g) };
    const size_t from = gen_chance(g, 64) ? LONG : gen_chance(g, 4) ? 2 * BLOCK : BLOCK, lines = 1 + (size_t)gen_upto(g, 1);
    char *const noise = calloc(1, from), path[PATH], wanted[PATH + 40];
    const bool comment = gen_chance(g, 2);
    et_cloud cloud;
    et_message message;
    bool ok;

    memset(noise, comment ? 'c' : ' ', from);
    noise[0] = comment ? '#' : ' ';
    for (size_t k = 0; k < lines; k++) {
        const size_t length = from - (size_t)gen_upto(g, 60);
        put_bytes(&t, noise, length);
        if (comment)
            end_line(&t);
        put(&t, "1.5 -2.25 %zu", k);
        t.want[t.count++] = (et_vec3){ 1.5, -2.25, (double)k };
        end_line(&t);
        end_line(&t);
    }
    free(noise);
    const size_t here = lines * (comment ? 3 : 2) + 1;
    spill(some_path(path, ".xyz"), &t);
    ok = read_as_wanted(g, &t, path);
    put(&t, "1 2");
    spill(path, &t);
    snprintf(wanted, sizeof wanted, "%s:%zu: z is missing", path, here);
    if (ok) {
        const et_status status = read_checked(g, &cloud, path, &message, &ok);
        ok = ok && gen_check(g, status == ET_EFORMAT && strcmp(message.text, wanted) == 0, "%s, not %s", message.text, wanted);
    }
    unlink(path);
    free(t.bytes);
    return ok ? PASS : FAIL;
}

/* ---- OBJ ---- */

verdict prop_cloud_read_obj(gen *g)
{
    static const char *const other[] = { "", "vn 1 2 3", "vt 0 0", "f 1 2 3", "g a b", "# v 7 7 7", "vp 1 1 1", "l 1 2 \\" };
    text t = { .end_of_line = some_end_of_line(g) };
    const size_t n = 1 + (size_t)gen_upto(g, MOST - 1);

    put_mark(g, &t);
    for (size_t i = 0; i < n; i++) {
        et_vec3 *const p = &t.want[t.count++];
        double *const axis[3] = { &p->x, &p->y, &p->z };
        while (gen_chance(g, 4)) {
            const size_t k = (size_t)gen_upto(g, 7);
            put(&t, "%s", other[k]);
            end_line(&t);
            if (k == 7) {                 /* goes on in the next line */
                put(&t, "v 5 5 5");
                end_line(&t);
            }
        }
        put(&t, "%sv", gen_chance(g, 4) ? "  " : "");
        for (size_t a = 0; a < 3; a++) {
            put(&t, "%s", gen_chance(g, 4) ? "\t" : " ");
            if (gen_chance(g, 8)) {
                put(&t, "\\");
                end_line(&t);
            }
            *axis[a] = put_real(g, &t);
        }
        put(&t, "%s", gen_chance(g, 3) ? " 1.0 0.5 red" : gen_chance(g, 3) ? " # note" : "");
        if (i + 1 < n || !gen_chance(g, 3))
            end_line(&t);
    }
    return verdict_of(g, &t, gen_chance(g, 2) ? ".obj" : ".OBJ");
}

/* ---- bytes of numbers ---- */

static void put_number(text *t, const void *x, size_t size, bool big)
{
    const uint16_t one = 1;
    const unsigned char *from = x;
    unsigned char low = 0, bytes[8];

    memcpy(&low, &one, 1);
    for (size_t k = 0; k < size && k < sizeof bytes; k++)
        bytes[k] = from[(low == 1) == big ? size - 1 - k : k];
    put_bytes(t, bytes, size);
}

static float some_float(gen *g)
{
    static const float hard[] = { 0.0f, -0.0f, 1.0f, 0.1f, -2.5e-45f, 3.4028235e38f, 1e-30f };

    return gen_chance(g, 2) ? (float)gen_real(g, -10, 10) : hard[gen_upto(g, 6)];
}

/* ---- STL ---- */

/* Keep a vertex unless it is there already (by value). */
static void want_distinct(text *t, et_vec3 p)
{
    for (size_t i = 0; i < t->count; i++)
        if (t->want[i].x == p.x && t->want[i].y == p.y && t->want[i].z == p.z)
            return;
    t->want[t->count++] = p;
}

static void put_stl_ascii(gen *g, text *t, size_t triangles)
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

static void put_stl_binary(gen *g, text *t, size_t triangles)
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

verdict prop_cloud_read_stl(gen *g)
{
    text t = { .end_of_line = some_end_of_line(g) };
    const bool binary = gen_chance(g, 2);
    const size_t n = 1 + (size_t)gen_upto(g, MOST - 1);

    (binary ? put_stl_binary : put_stl_ascii)(g, &t, n);
    gen_label(g, binary ? "binary" : "ascii");
    return verdict_of(g, &t, gen_chance(g, 2) ? ".stl" : ".dat");
}

/* Many vertices, each listed up to six times: the table of distinct ones grows and keeps the order of first occurrence. */
verdict prop_cloud_read_stl_many(gen *g)
{
    text t = { .end_of_line = "\n" };
    const uint32_t side = 1 + (uint32_t)gen_upto(g, gen_chance(g, 20) ? 89 : 29), triangles = side * side;
    const char head[80] = { 0 };
    const uint16_t attribute = 0;
    char path[PATH];
    et_cloud cloud;
    et_message message;
    bool ok;

    put_bytes(&t, head, sizeof head);
    put_number(&t, &triangles, 4, false);
    for (uint32_t k = 0; k < triangles; k++) {
        const float c[3][3] = { { (float)(k / side), (float)(k % side), 0 }, { (float)(k / side) + 1, (float)(k % side), 0 }, { 0, 0, 0 } };
        put_bytes(&t, head, 12);
        for (size_t i = 0; i < 9; i++)
            put_number(&t, &c[i / 3][i % 3], 4, false);
        put_number(&t, &attribute, 2, false);
    }
    spill(some_path(path, ".stl"), &t);
    ok = gen_check(g, read_checked(g, &cloud, path, &message, &ok) == ET_OK, "%s", message.text) && ok;
    ok = ok && gen_check(g, cloud.count == (size_t)side * (side + 1), "%zu points of side %u", cloud.count, (unsigned)side);
    /* The sum over i <= side, j < side of (i, j), in exact integers; and (0,0), (1,0), (0,1) first. */
    double x = 0, y = 0;
    for (size_t i = 0; ok && i < cloud.count; i++) {
        x += cloud.points[i].x;
        y += cloud.points[i].y;
    }
    const double s = side;
    ok = ok && gen_check(g, x == s * s * (s + 1) / 2 && y == s * (s - 1) / 2 * (s + 1), "sums %g, %g", x, y);
    ok = ok && gen_check(g, cloud.points[0].x == 0 && cloud.points[1].x == 1 && (side == 1 || cloud.points[2].y == 1), "order");
    et_cloud_free(&cloud);
    unlink(path);
    free(t.bytes);
    return ok ? PASS : FAIL;
}

/* ---- PLY ---- */

static const struct { const char *name, *alias; size_t size; } types[] = {
    { "char", "int8", 1 }, { "uchar", "uint8", 1 }, { "short", "int16", 2 }, { "ushort", "uint16", 2 },
    { "int", "int32", 4 }, { "uint", "uint32", 4 }, { "float", "float32", 4 }, { "double", "float64", 8 },
};

typedef enum { ASCII, LITTLE, BIG } ply_format;

/* One value of a type, drawn anew; its value as a double. */
static double put_typed(gen *g, text *t, size_t type, ply_format format)
{
    const bool big = format == BIG;
    double value;

    if (type == 7) {
        const double x = any_real(g);
        if (format == ASCII)
            return put_real(g, t);
        put_number(t, &x, 8, big);
        return x;
    }
    if (type == 6) {
        const float x = some_float(g);
        if (format == ASCII)
            put(t, "%.9g", (double)x);
        else
            put_number(t, &x, 4, big);
        char text9[40];
        snprintf(text9, sizeof text9, "%.9g", (double)x);
        return format == ASCII ? strtod(text9, NULL) : (double)x;
    }
    const size_t size = types[type].size;
    const uint64_t bits = gen_upto(g, (UINT64_C(1) << (8 * size)) - 1);
    const bool negative = type % 2 == 0 && bits >> (8 * size - 1);
    value = negative ? -(double)((UINT64_C(1) << (8 * size)) - bits) : (double)bits;
    if (format == ASCII) {
        put(t, "%.0f", value);
    } else {
        const uint8_t b1 = (uint8_t)bits;
        const uint16_t b2 = (uint16_t)bits;
        const uint32_t b4 = (uint32_t)bits;
        put_number(t, size == 1 ? (const void *)&b1 : size == 2 ? (const void *)&b2 : (const void *)&b4, size, big);
    }
    return value;
}

/* A list of `length` values with its length before it. */
static void put_typed_list(gen *g, text *t, size_t length_type, size_t type, size_t length, ply_format format)
{
    const uint8_t b1 = (uint8_t)length;
    const uint16_t b2 = (uint16_t)length;
    const uint32_t b4 = (uint32_t)length;
    const size_t size = types[length_type].size;

    if (format == ASCII)
        put(t, "%zu", length);
    else
        put_number(t, size == 1 ? (const void *)&b1 : size == 2 ? (const void *)&b2 : (const void *)&b4, size, format == BIG);
    for (size_t k = 0; k < length; k++) {
        if (format == ASCII)
            put(t, " ");
        (void)put_typed(g, t, type, format);
    }
}

/* A property: a list where its length's type is one; axis 3 where it is no coordinate. */
typedef struct { size_t type, length_type, axis; bool list; } ply_property;

static void put_property(gen *g, text *t, const ply_property *p, const char *name)
{
    const size_t type = p->type;
    const char *const spelt = gen_chance(g, 2) ? types[type].alias : types[type].name;

    if (p->list)
        put(t, "property list %s %s %s", types[p->length_type].name, spelt, name);
    else
        put(t, "property %s %s", spelt, name);
    end_line(t);
}

static void put_element(gen *g, text *t, const ply_property *p, size_t np, size_t rows, ply_format format, bool vertex)
{
    for (size_t i = 0; i < rows; i++) {
        double x[4] = { 0, 0, 0, 0 };
        if (format == ASCII && gen_chance(g, 8))
            end_line(t);
        for (size_t k = 0; k < np; k++) {
            if (format == ASCII && k > 0)
                put(t, "%s", gen_chance(g, 4) ? " \t" : " ");
            if (p[k].list)
                put_typed_list(g, t, p[k].length_type, p[k].type, (size_t)gen_upto(g, 4), format);
            else
                x[p[k].axis] = put_typed(g, t, p[k].type, format);
        }
        if (format == ASCII)
            end_line(t);
        if (vertex)
            t->want[t->count++] = (et_vec3){ x[0], x[1], x[2] };
    }
}

static size_t some_properties(gen *g, ply_property p[8], bool vertex)
{
    const size_t n = (vertex ? 3 : 1) + (size_t)gen_upto(g, 3);
    const bool mostly_double = gen_chance(g, 2);

    for (size_t k = 0; k < n; k++) {
        p[k] = (ply_property){ vertex && mostly_double ? 7 : (size_t)gen_upto(g, 7), (size_t)gen_upto(g, 5), 3, false };
        p[k].list = !(vertex && k < 3) && gen_chance(g, 2);
        p[k].axis = vertex && k < 3 ? k : 3;
    }
    for (size_t k = n; vertex && k-- > 1;) {
        const size_t other = k - (size_t)gen_upto(g, k);
        const ply_property keep = p[k];
        p[k] = p[other];
        p[other] = keep;
    }
    return n;
}

verdict prop_cloud_read_ply(gen *g)
{
    static const char *const format_name[] = { "ascii", "binary_little_endian", "binary_big_endian" };
    static const char *const coordinate[] = { "x", "y", "z", "other" };
    text t = { .end_of_line = some_end_of_line(g) };
    const ply_format format = (ply_format)gen_upto(g, 2);
    const bool before = gen_chance(g, 2), after = gen_chance(g, 2), empty = gen_chance(g, 8);
    ply_property faces[8], vertices[8];
    const size_t nv = some_properties(g, vertices, true), nf = some_properties(g, faces, false);
    const size_t n = 1 + (size_t)gen_upto(g, MOST - 1), f = (size_t)gen_upto(g, 5);

    put(&t, "ply");
    end_line(&t);
    if (gen_chance(g, 2)) {
        put(&t, "comment element vertex 9");
        end_line(&t);
    }
    put(&t, "format %s 1.0", format_name[format]);
    end_line(&t);
    if (gen_chance(g, 2)) {
        put(&t, "obj_info property x");
        end_line(&t);
    }
    for (size_t turn = 0; turn < 3; turn++) {
        if (turn == 1) {
            put(&t, "element vertex %zu", n);
            end_line(&t);
            for (size_t k = 0; k < nv; k++)
                put_property(g, &t, &vertices[k], coordinate[vertices[k].axis]);
        } else if (turn == 0 ? before : after) {
            put(&t, "element face%zu %zu", turn, f);
            end_line(&t);
            for (size_t k = 0; k < nf; k++)
                put_property(g, &t, &faces[k], "x");
            if (empty) {                  /* no properties: no bytes, however many */
                put(&t, "element none%zu 18446744073709551615", turn);
                end_line(&t);
            }
        }
    }
    put(&t, "end_header");
    end_line(&t);
    if (before)
        put_element(g, &t, faces, nf, f, format, false);
    put_element(g, &t, vertices, nv, n, format, true);
    if (after)
        put_element(g, &t, faces, nf, f, format, false);
    gen_label(g, format_name[format]);
    return verdict_of(g, &t, gen_chance(g, 2) ? ".ply" : ".obj");
}

/* ---- PCD ---- */

/* The fields in any order: axis 0, 1, 2 are x, y, z; how many columns each has. */
typedef struct { size_t fields, axis[5], many[5]; } pcd_form;

static pcd_form some_pcd_form(gen *g, bool counted)
{
    pcd_form f = { 3 + (size_t)gen_upto(g, 2), { 0, 1, 2, 3, 4 }, { 1, 1, 1, 1, 1 } };

    for (size_t k = f.fields; k-- > 1;) {
        const size_t other = k - (size_t)gen_upto(g, k), a = f.axis[k];
        f.axis[k] = f.axis[other];
        f.axis[other] = a;
    }
    for (size_t k = 0; counted && k < f.fields; k++)
        f.many[k] = f.axis[k] < 3 ? 1 : (size_t)gen_upto(g, 3);
    return f;
}

static void put_pcd_head(gen *g, text *t, const pcd_form *f, bool counted, size_t n)
{
    static const char *const name[5] = { "x", "y", "z", "rgb", "normal" };
    const bool points = gen_chance(g, 2), sized = !points || gen_chance(g, 2);

    put_mark(g, t);
    if (gen_chance(g, 2)) {
        put(t, "# .PCD v.7 - Point Cloud Data file format");
        end_line(t);
    }
    put(t, "VERSION .7");
    end_line(t);
    put(t, "FIELDS");
    for (size_t k = 0; k < f->fields; k++)
        put(t, " %s", name[f->axis[k]]);
    end_line(t);
    put(t, "SIZE 4 4 4");
    end_line(t);
    if (counted) {
        put(t, "COUNT");
        for (size_t k = 0; k < f->fields; k++)
            put(t, " %zu", f->many[k]);
        end_line(t);
    }
    if (sized) {
        put(t, "WIDTH %zu", n % 2 ? n : 2);
        end_line(t);
        put(t, "HEIGHT %zu", n % 2 ? 1 : n / 2);
        end_line(t);
    }
    put(t, "VIEWPOINT 0 0 0 1 0 0 0");
    end_line(t);
    if (points) {
        put(t, "POINTS %zu", n);
        end_line(t);
    }
    put(t, "DATA ascii");
    end_line(t);
}

verdict prop_cloud_read_pcd(gen *g)
{
    text t = { .end_of_line = some_end_of_line(g) };
    const size_t n = 1 + (size_t)gen_upto(g, MOST - 1);
    const bool counted = gen_chance(g, 2);
    const pcd_form f = some_pcd_form(g, counted);

    put_pcd_head(g, &t, &f, counted, n);
    for (size_t i = 0; i < n; i++) {
        double x[3] = { 0, 0, 0 };
        for (size_t k = 0; k < f.fields; k++) {
            for (size_t m = 0; m < f.many[k]; m++) {
                if (f.axis[k] < 3)
                    x[f.axis[k]] = put_real(g, &t);
                else
                    put(&t, "nan");
                put(&t, "%s", gen_chance(g, 4) ? "\t" : " ");
            }
        }
        t.want[t.count++] = (et_vec3){ x[0], x[1], x[2] };
        if (i + 1 < n || !gen_chance(g, 3))
            end_line(&t);
    }
    return verdict_of(g, &t, gen_chance(g, 2) ? ".pcd" : ".xyz");
}

/* ---- faults, one by one ---- */

#define PLY_HEAD "ply\nformat ascii 1.0\n"
#define PLY_XYZ "property double x\nproperty double y\nproperty double z\nend_header\n"
#define PCD_HEAD "# .PCD v.7\nFIELDS x y z\n"

/* ending, text, what follows the file's name in the message; null: it is read, `points` points. */
static const struct { const char *ending, *text, *message; size_t points; } faults[] = {
    { ".xyz", "", ": no points", 0 },
    { ".xyz", "\n\n# only\n", ": no points", 0 },
    { ".xyz", "x y z\n", ": no points", 0 },
    { ".xyz", "0\n", ": no points", 0 },
    { ".xyz", "1 2 3", NULL, 1 },
    { ".xyz", "1 2", ":1: z is missing", 0 },
    { ".xyz", "1", ":1: the count is 1, but 0 points follow", 0 },
    { ".xyz", "\n-1", ":2: y is missing", 0 },
    { ".xyz", "1 2 3\n4 5\n6 7 8\n", ":2: z is missing", 0 },
    { ".xyz", "1 2 3\r\n4 5\r\n6 7 8\r\n", ":2: z is missing", 0 },
    { ".xyz", "1 2 3\r\r4\r", ":3: y is missing", 0 },
    { ".xyz", "1 2 3\n\n7\n", ":3: y is missing", 0 },
    { ".xyz", "1 2 3\nabc 5 6\n", ":2: x is not a number: \"abc\"", 0 },
    { ".xyz", "abc 5 6\n", ":1: x is not a number: \"abc\"", 0 },
    { ".xyz", "a b c\nd e f\n", ":2: x is not a number: \"d\"", 0 },
    { ".xyz", "nan nan nan\n", ":1: x is not finite", 0 },
    { ".xyz", "1 NaN 3\n", ":1: y is not finite", 0 },
    { ".xyz", "1 2 inf\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 -Infinity\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 nan(7)\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 1e999\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 1e99999999999999999999\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 0x1p9999\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 1e-99999999999999999999\n", NULL, 1 },
    { ".xyz", "1.0.0 2 3\n", ":1: x is not a number: \"1.0.0\"", 0 },
    { ".xyz", "1e 2 3\n", ":1: x is not a number: \"1e\"", 0 },
    { ".xyz", "1e+ 2 3\n", ":1: x is not a number: \"1e+\"", 0 },
    { ".xyz", "1 2 .\n", ":1: z is not a number: \".\"", 0 },
    { ".xyz", "1 2 -\n", ":1: z is not a number: \"-\"", 0 },
    { ".xyz", "1 2 +-3\n", ":1: z is not a number: \"+-3\"", 0 },
    { ".xyz", "1 2 3x\n", ":1: z is not a number: \"3x\"", 0 },
    { ".xyz", "1 2 0x\n", ":1: z is not a number: \"0x\"", 0 },
    { ".xyz", "1 2 infx\n", ":1: z is not a number: \"infx\"", 0 },
    { ".xyz", "1 2 3e5 x\n", NULL, 1 },
    { ".xyz", "1 2 3\001\n", ":1: z is not a number: \"3?\"", 0 },
    { ".xyz", "1 2 aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\n",
      ":1: z is not a number: \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...\"", 0 },
    { ".xyz", "1,5;2,5;3,5\n", ":1: y is not a number: \"5;2\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "1,5 2,5 3,5\n", ":1: y is not a number: \"5 2\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "1\t2,5\t3\n", ":1: y is not a number: \"2,5\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "1;2;3,5\n", ":1: z is not a number: \"3,5\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "1 2 3 a,b\nx 2 3\n", ":2: x is not a number: \"x\"", 0 },
    { ".xyz", "2 b;c 4\n", ":1: y is not a number: \"b;c\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "a b,;\tc 3\n", ":1: x is not a number: \"a\"", 0 },
    { ".xyz", "\"left x\", y, x, z\nq, 1, 2, 3\n", NULL, 1 },
    { ".xyz", "1,,3\n", ":1: y is missing", 0 },
    { ".xyz", ",1,2\n", ":1: x is missing", 0 },
    { ".xyz", "1,2,\n", ":1: z is missing", 0 },
    { ".xyz", "1,2,3,\n", NULL, 1 },
    { ".xyz", "2\n1 2 3\n4 5 6\n", NULL, 2 },
    { ".xyz", "# c\n2\nx y z\n1 2 3\n4 5 6\n", NULL, 2 },
    { ".xyz", "# c\n3\n1 2 3\n4 5 6\n", ":2: the count is 3, but 2 points follow", 0 },
    { ".xyz", "1\n1 2 3\n4 5 6\n", ":1: the count is 1, but 2 points follow", 0 },
    { ".xyz", "2\n2\n1 2 3\n", ":2: y is missing", 0 },
    { ".xyz", "99999999999999999999999\n1 2 3\n", ":1: y is missing", 0 },
    { ".xyz", "x,y,h\n1,2,3\n", ":1: the header names z not at all, but another of x, y, z", 0 },
    { ".xyz", "x,y,z,x\n1,2,3,4\n", ":1: the header names x twice", 0 },
    { ".xyz", "a,b,x,y,z\n1,2,3,4\n", ":2: z is missing", 0 },
    { ".xyz", "name;x;y;z\nJohn Smith;1;2;3\n", NULL, 1 },
    { ".xyz", "x,y,z\n1 2 3\n4,5,6\n", NULL, 2 },
    { ".xyz", "1 2 3 // 4\n4 5 6 #\n7/8 9 9\n", ":3: x is not a number: \"7/8\"", 0 },
    { ".xyz", "solve 1 2\n", ":1: x is not a number: \"solve\"", 0 },
    { ".obj", "v 1 2 3\nv 1 2\n", ":2: z is missing", 0 },
    { ".obj", "v 1 2 \\\n\nv 1 2 3\n", ":1: z is missing", 0 },
    { ".obj", "v 1 \\\n 2 3\n\nv 1 x 3\n", ":4: y is not a number: \"x\"", 0 },
    { ".obj", "v 1 2 # 3\n", ":1: z is missing", 0 },
    { ".obj", "v 1 2 nan\n", ":1: z is not finite", 0 },
    { ".obj", "v 1,2,3\n", ":1: x is not a number: \"1,2,3\" (mixed separators, or a decimal comma)", 0 },
    { ".obj", "f 1 2 3\n", ": no points", 0 },
    { ".obj", "v 1 2 3\\", NULL, 1 },
    { ".ply", "ply", ":2: the file ends within the PLY header", 0 },
    { ".ply", "ply\nformat ascii 1.0\n", ":3: the file ends within the PLY header", 0 },
    { ".ply", "ply\nformat ascii 2.0\n", ":2: unknown PLY version \"2.0\"", 0 },
    { ".ply", "ply\nformat ascii\n", ":2: unknown PLY version \"\"", 0 },
    { ".ply", "ply\nformat text 1.0\n", ":2: unknown PLY format \"text\"", 0 },
    { ".ply", "ply\nelement vertex 1\n" PLY_XYZ "1 2 3\n", ":6: PLY header without a format", 0 },
    { ".ply", "ply\nelement vertex\n", ":2: \"\" is not a count", 0 },
    { ".ply", "ply\nelement vertex -5\n", ":2: \"-5\" is not a count", 0 },
    { ".ply", "ply\nelement vertex 18446744073709551616\n", ":2: \"18446744073709551616\" is not a count", 0 },
    { ".ply", "ply\nelement vertex 1e3\n", ":2: \"1e3\" is not a count", 0 },
    { ".ply", "ply\nproperty float x\n", ":2: property before any element", 0 },
    { ".ply", "ply\nelement vertex 1\nproperty half x\n", ":3: unknown PLY type \"half\"", 0 },
    { ".ply", "ply\nelement vertex 1\nproperty float\n", ":3: property without a name", 0 },
    { ".ply", "ply\nelement vertex 1\nproperty list float int x\n", ":3: unknown PLY list length type \"float\"", 0 },
    { ".ply", "ply\nelement vertex 1\nproperty float x\nproperty int x\n", ":4: property x twice", 0 },
    { ".ply", "ply\nelements vertex 1\n", ":2: unknown PLY keyword \"elements\"", 0 },
    { ".ply", PLY_HEAD "element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n",
      ":6: a vertex has not all of the properties x, y, z", 0 },
    { ".ply", PLY_HEAD "element vertex 1\nproperty float x\nproperty float y\nproperty list char float z\nend_header\n1 2 1 3\n",
      ":7: a vertex has not all of the properties x, y, z", 0 },
    { ".ply", PLY_HEAD "element face 1\n" PLY_XYZ, ":7: PLY header with 0 elements vertex", 0 },
    { ".ply", PLY_HEAD "element vertex 1\nelement vertex 1\n" PLY_XYZ, ":8: PLY header with 2 elements vertex", 0 },
    { ".ply", PLY_HEAD "element vertex 0\n" PLY_XYZ, ": no points", 0 },
    { ".ply", PLY_HEAD "element vertex 2\n" PLY_XYZ "1 2 3\n", ":9: vertex 2 of 2 is missing (truncated)", 0 },
    { ".ply", PLY_HEAD "element vertex 1000000000000000000\n" PLY_XYZ "1 2 3\n4 5 6\n",
      ":10: vertex 3 of 1000000000000000000 is missing (truncated)", 0 },
    { ".ply", PLY_HEAD "element vertex 1\n" PLY_XYZ "1 2\n", ":8: z is missing", 0 },
    { ".ply", PLY_HEAD "element vertex 1\n" PLY_XYZ "1 2 3 4\n", ":8: more values than properties", 0 },
    { ".ply", PLY_HEAD "element vertex 1\n" PLY_XYZ "1 x 3\n", ":8: y is not a number: \"x\"", 0 },
    { ".ply", PLY_HEAD "element vertex 1\n" PLY_XYZ "1 2 nan\n", ":8: z is not finite", 0 },
    { ".ply", PLY_HEAD "element vertex 1\nproperty int a\n" PLY_XYZ "7 1 2 3\n", NULL, 1 },
    { ".ply", PLY_HEAD "element face 1\nproperty list uchar int i\nelement vertex 1\n" PLY_XYZ "3 0 1\n1 2 3\n",
      ":10: fewer values than properties", 0 },
    { ".ply", PLY_HEAD "element face 1\nproperty list uchar int i\nelement vertex 1\n" PLY_XYZ "-1 0 1\n1 2 3\n",
      ":10: a list's length is not a count", 0 },
    { ".ply", PLY_HEAD "element face 1\nproperty list uchar int i\nelement vertex 1\n" PLY_XYZ "2 0 1 5\n1 2 3\n",
      ":10: more values than properties", 0 },
    { ".ply", PLY_HEAD "element face 3\nproperty list uchar int i\nelement vertex 1\n" PLY_XYZ "1 0\n1 2\n",
      ":12: face 3 of 3 is missing (truncated)", 0 },
    { ".ply", "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" PLY_XYZ "aaaaaaaabbbbbbbbccccccccaaaaaaaabbbbbbbb",
      ": vertex 2 of 3 is missing (truncated)", 0 },
    { ".ply", "ply\nformat binary_big_endian 1.0\nelement vertex 18446744073709551615\n" PLY_XYZ "aaaaaaaabbbbbbbbcccccccc",
      ": vertex 2 of 18446744073709551615 is missing (truncated)", 0 },
    { ".ply", "ply\nformat binary_big_endian 1.0\nelement vertex 1\n" PLY_XYZ "aaaaaaaa\x7f\xf8zzzzzzcccccccc", ": vertex 1: y is not finite", 0 },
    { ".ply", "ply\nformat binary_big_endian 1.0\nelement face 2\nproperty list int char i\nelement vertex 1\n" PLY_XYZ "\xff\xff\xff\xff",
      ": face 1 has a list of negative length", 0 },
    { ".ply", "ply\nformat binary_big_endian 1.0\nelement face 2\nproperty list uint double i\nelement vertex 1\n" PLY_XYZ "\xff\xff\xff\xff....",
      ": face 1 of 2 is missing (truncated)", 0 },
    { ".ply", "plyx 1 2\n", ":1: x is not a number: \"plyx\"", 0 },
    { ".stl", "solid a\nvertex 1 2 3\nvertex 1 2 3.0\n vertex 4 5 6\nendsolid\n", NULL, 2 },
    { ".stl", "solid a\nvertex 1 2 3\nendsolid\nsolid b\nvertex 4 5 6\nendsolid b\n", NULL, 2 },
    { ".stl", "solid a\nvertex 1 2 3\n", ":3: the file ends without endsolid (truncated)", 0 },
    { ".stl", "solid a\nvertex 1 2\nendsolid\n", ":2: z is missing", 0 },
    { ".stl", "solid a\nvertex 1 2 z\nendsolid\n", ":2: z is not a number: \"z\"", 0 },
    { ".stl", "solid a\nvertices 1 2 3\nendsolid\n", ":2: unknown STL keyword \"vertices\"", 0 },
    { ".stl", "solid a\nfacet normal 0 0 1 2\nendsolid\n", ":2: unknown STL keyword \"2\"", 0 },
    { ".stl", "solid a\nvertex 1 2 inf\nendsolid\n", ":2: z is not finite", 0 },
    { ".stl", "solid a\nendsolid\n", ": no points", 0 },
    { ".stl", "something else\n", ": STL header is not complete", 0 },
    { ".pcd", "nothing\n", ":1: unknown PCD keyword \"nothing\"", 0 },
    { ".pcd", PCD_HEAD, ":3: the file ends within the PCD header", 0 },
    { ".pcd", PCD_HEAD "DATA binary\n", ":3: of PCD only DATA ascii is read", 0 },
    { ".pcd", PCD_HEAD "DATA binary_compressed\n", ":3: of PCD only DATA ascii is read", 0 },
    { ".pcd", PCD_HEAD "DATA text\n", ":3: unknown PCD data \"text\"", 0 },
    { ".pcd", PCD_HEAD "DATA ascii\n", ":3: PCD header without POINTS", 0 },
    { ".pcd", PCD_HEAD "WIDTH 4\nDATA ascii\n", ":4: PCD header without POINTS", 0 },
    { ".pcd", "VERSION .7\nPOINTS 1\nDATA ascii\n", ":3: PCD header without FIELDS", 0 },
    { ".pcd", "FIELDS x y\n", ":1: FIELDS names z not at all", 0 },
    { ".pcd", "FIELDS x y z y\n", ":1: FIELDS names y twice", 0 },
    { ".pcd", PCD_HEAD "COUNT 1 1\n", ":3: 2 COUNT for 3 FIELDS", 0 },
    { ".pcd", PCD_HEAD "COUNT 1 2 1\n", ":3: COUNT of y is not 1", 0 },
    { ".pcd", PCD_HEAD "COUNT 1 1 x\n", ":3: unknown COUNT \"x\"", 0 },
    { ".pcd", PCD_HEAD "POINTS -1\n", ":3: unknown count \"-1\"", 0 },
    { ".pcd", PCD_HEAD "WIDTH 2\nHEIGHT 3\nPOINTS 5\nDATA ascii\n", ":6: WIDTH times HEIGHT is 6, POINTS 5", 0 },
    { ".pcd", PCD_HEAD "WIDTH 4294967296\nHEIGHT 4294967296\nDATA ascii\n", ":5: WIDTH times HEIGHT is too large", 0 },
    { ".pcd", PCD_HEAD "POINTS 2\nDATA ascii\n1 2 3\n", ":6: the file ends after 1 of 2 points", 0 },
    { ".pcd", PCD_HEAD "POINTS 1\nDATA ascii\n1 2 3\n4 5 6\n", ":6: more than the declared 1 points", 0 },
    { ".pcd", PCD_HEAD "POINTS 1\nDATA ascii\n1 2 nan\n", ":5: z is not finite", 0 },
    { ".pcd", PCD_HEAD "POINTS 1\nDATA ascii\n1 2\n", ":5: z is missing", 0 },
    { ".pcd", PCD_HEAD "POINTS 1\nDATA ascii\n1 2 3 4\n", ":5: 4 columns, 3 declared", 0 },
    { ".pcd", PCD_HEAD "POINTS 0\nDATA ascii\n", ": no points", 0 },
};

static bool fault_is_told(gen *g, size_t k)
{
    text t = { .end_of_line = "\n" };
    char path[PATH], wanted[2 * PATH];
    et_cloud cloud;
    et_message message;
    bool ok;

    put_bytes(&t, faults[k].text, strlen(faults[k].text));
    spill(some_path(path, faults[k].ending), &t);
    const et_status status = read_checked(g, &cloud, path, &message, &ok);
    if (faults[k].message) {
        snprintf(wanted, sizeof wanted, "%s%s", path, faults[k].message);
        ok = ok && gen_check(g, status == ET_EFORMAT && strcmp(message.text, wanted) == 0, "fault %zu: \"%s\", not \"%s\"", k, message.text, wanted);
    } else {
        ok = ok && gen_check(g, status == ET_OK && cloud.count == faults[k].points, "fault %zu: %s", k, message.text);
    }
    et_cloud_free(&cloud);
    unlink(path);
    free(t.bytes);
    return ok;
}

verdict prop_cloud_read_faults(gen *g)
{
    const size_t n = sizeof faults / sizeof *faults, k = (size_t)gen_upto(g, n);
    bool ok = true;

    for (size_t i = 0; k == 0 && ok && i < n; i++)
        ok = fault_is_told(g, i);
    return ok && (k == 0 || fault_is_told(g, k - 1)) ? PASS : FAIL;
}

/* A NUL byte in a text, a binary STL that is short or has more, a point that is not finite in it. */
verdict prop_cloud_read_bytes(gen *g)
{
    static const char nul[] = "1 2 3\n4 \0005 6\n";
    text t = { .end_of_line = "\n" };
    const uint64_t kind = gen_upto(g, 3);
    const size_t n = 2 + (size_t)gen_upto(g, 5);
    char path[PATH], wanted[2 * PATH];
    et_cloud cloud;
    et_message message;
    bool ok;

    some_path(path, kind == 0 ? ".xyz" : ".stl");
    if (kind == 0) {
        put_bytes(&t, nul, sizeof nul - 1);
        snprintf(wanted, sizeof wanted, "%s:2: NUL byte in a text file", path);
    } else {
        put_stl_binary(g, &t, n);
        t.bytes[6] = 0;
        if (kind == 1) {                  /* short by a part of the last triangle at most */
            t.n -= 1 + (size_t)gen_upto(g, 49);
            snprintf(wanted, sizeof wanted, "%s: triangle %zu of %zu is missing (truncated)", path, n, n);
        } else if (kind == 2) {
            put_bytes(&t, "more", 1 + (size_t)gen_upto(g, 3));
            snprintf(wanted, sizeof wanted, "%s: more bytes than its %zu triangles", path, n);
        } else {
            const size_t at = (size_t)gen_upto(g, 8);
            memcpy(t.bytes + 84 + 50 * (n - 1) + 12 + 4 * at, "\x00\x00\x80\x7f", 4);
            snprintf(wanted, sizeof wanted, "%s: triangle %zu, vertex %zu: %c is not finite", path, n, at / 3 + 1, "xyz"[at % 3]);
        }
    }
    spill(path, &t);
    const et_status status = read_checked(g, &cloud, path, &message, &ok);
    ok = ok && gen_check(g, status == ET_EFORMAT && strcmp(message.text, wanted) == 0, "%s, not %s", message.text, wanted);
    et_cloud_free(&cloud);
    unlink(path);
    free(t.bytes);
    return ok ? PASS : FAIL;
}

/* Whatever the bytes are: a cloud of finite points, or a sentence with the file's name. */
verdict prop_cloud_read_mutated(gen *g)
{
    static const char *const endings[] = { ".xyz", ".obj", ".stl", ".pcd", ".ply" };
    const size_t k = (size_t)gen_upto(g, sizeof faults / sizeof *faults + 2);
    text t = { .end_of_line = "\n" };
    char path[PATH];
    et_cloud cloud;
    et_message message;
    bool ok;

    if (k < sizeof faults / sizeof *faults)
        put_bytes(&t, faults[k].text, strlen(faults[k].text));
    else if (k == sizeof faults / sizeof *faults)
        put_stl_binary(g, &t, 1 + (size_t)gen_upto(g, 3));
    for (uint64_t changes = gen_upto(g, 8); changes > 0; changes--) {
        char byte = (char)gen_upto(g, 255);
        const size_t at = (size_t)gen_upto(g, t.n);
        if (at == t.n || gen_chance(g, 4)) {
            put_bytes(&t, &byte, 1);
            memmove(t.bytes + at + 1, t.bytes + at, t.n - 1 - at);
        }
        t.bytes[at] = byte;
        if (gen_chance(g, 8))
            t.n = at;
    }
    spill(some_path(path, endings[gen_upto(g, 4)]), &t);
    gen_label(g, read_checked(g, &cloud, path, &message, &ok) ? "refused" : "read");
    et_cloud_free(&cloud);
    unlink(path);
    free(t.bytes);
    return ok ? PASS : FAIL;
}

/* ---- et_cloud_read: arguments, places, locale ---- */

static bool fails_as(gen *g, const char *path, et_status status, const char *told)
{
    static et_vec3 nowhere;
    et_cloud cloud = { &nowhere, 7 };
    et_message message = { "" };

    return gen_check(g, et_cloud_read(&cloud, path, &message) == status, "%s: status", path ? path : "null") &&
           gen_check(g, cloud.points == &nowhere && cloud.count == 7, "*cloud changed") &&
           gen_check(g, !told || strcmp(message.text, told) == 0, "%s", message.text) &&
           gen_check(g, et_cloud_read(&cloud, path, NULL) == status, "status without a message");
}

/* Through a FIFO and through standard input: no size is known. */
static bool through_fifo(gen *g, const text *t, const char *path)
{
    char fifo[PATH];
    int status = 1;

    if (mkfifo(some_path(fifo, ".fifo"), 0600) != 0)
        return false;
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        spill(fifo, t);
        _exit(0);
    }
    bool ok = read_as_wanted(g, t, fifo);
    waitpid(child, &status, 0);
    unlink(fifo);
    et_cloud cloud;
    et_message message = { "" };
    spill(path, t);
    ok = ok && gen_check(g, freopen(path, "rb", stdin) && et_cloud_read(&cloud, "-", &message) == ET_OK, "standard input: %s", message.text);
    ok = ok && gen_check(g, cloud.count == t->count, "standard input: %zu points", cloud.count);
    if (ok)
        et_cloud_free(&cloud);
    return ok;
}

static bool in_another_locale(gen *g)
{
    static const char *const names[] = { "de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8" };
    text t = { .end_of_line = "\n" };
    char path[PATH];
    bool found = false;

    for (size_t k = 0; !found && k < sizeof names / sizeof *names; k++)
        found = setlocale(LC_NUMERIC, names[k]) != NULL;
    if (found)
        gen_label(g, "decimal comma in the locale");
    put(&t, "%s", "1.5 0.30000000000000004441 1.1754943508222875e-38\n");
    t.want[t.count++] = (et_vec3){ 0x1.8p0, 0x1.3333333333334p-2, 0x1p-126 };
    spill(some_path(path, ".xyz"), &t);
    const bool ok = read_as_wanted(g, &t, path);
    setlocale(LC_NUMERIC, "C");
    unlink(path);
    free(t.bytes);
    return ok;
}

verdict prop_cloud_read(gen *g)
{
    char path[PATH], told[2 * PATH];
    text t = { .end_of_line = "\n" };
    bool ok = in_another_locale(g);

    some_path(path, ".none");
    snprintf(told, sizeof told, "cannot read %s: %s", path, strerror(ENOENT));
    ok = ok && fails_as(g, path, ET_EIO, told) && fails_as(g, NULL, ET_EINVAL, NULL);
    ok = ok && fails_as(g, "/tmp", ET_EIO, "cannot read /tmp: Is a directory") && fails_as(g, "", ET_EIO, NULL);
    ok = ok && fails_as(g, "/dev/null", ET_EFORMAT, "/dev/null: no points");
    ok = ok && gen_check(g, et_cloud_read(NULL, path, NULL) == ET_EINVAL, "null cloud");
    if (gen_chance(g, 8)) {
        some_path(path, ".stl");
        (gen_chance(g, 2) ? put_stl_ascii : put_stl_binary)(g, &t, 1 + (size_t)gen_upto(g, 9));
        ok = ok && through_fifo(g, &t, path);
        unlink(path);
    }
    free(t.bytes);
    return ok ? PASS : FAIL;
}

verdict prop_cloud_free(gen *g)
{
    et_cloud cloud = { malloc(sizeof *cloud.points * 3), 3 };

    et_cloud_free(NULL);
    et_cloud_free(&cloud);
    const bool ok = gen_check(g, !cloud.points && cloud.count == 0, "not zeroed");
    et_cloud_free(&cloud);
    return ok ? PASS : FAIL;
}

verdict prop_cloud_name(gen *g)
{
    static const char *const names[] = { "xyz", "ply-ascii", "ply", "ply-big" };
    const size_t k = (size_t)gen_upto(g, 6);
    const char *const got = et_cloud_name((et_cloud_format)k);

    return gen_check(g, k < 4 ? got && strcmp(got, names[k]) == 0 : !got, "name %zu", k) ? PASS : FAIL;
}

/* ---- et_cloud_write ---- */

/* Each number of a text has 15, 16 or 17 significant digits at most, and never more than needed. */
static bool shortest(gen *g, char *line)
{
    bool ok = true;

    for (char *token = strtok(line, " \n"); ok && token; token = strtok(NULL, " \n")) {
        const double x = strtod(token, NULL);
        char fewer[40];
        size_t digits = 0, zeros = 0;
        for (const char *c = token; *c && *c != 'e'; c++) {
            digits += (*c >= '0' && *c <= '9') && (digits > 0 || *c != '0');
            zeros = *c == '0' ? zeros + 1 : 0;
        }
        ok = gen_check(g, digits <= 17 || zeros > 0, "%s has %zu digits", token, digits);
        for (int n = 15; ok && n < (int)digits && n < 17; n++) {
            snprintf(fewer, sizeof fewer, "%.*g", n, x);
            ok = gen_check(g, strlen(fewer) >= strlen(token) || strtod(fewer, NULL) != x, "%s for %s", token, fewer);
        }
    }
    return ok;
}

static bool write_is_refused(gen *g, const et_vec3 *p)
{
    char path[PATH], told[2 * PATH];
    et_message message = { "" };
    const et_vec3 bad[2] = { { 0, 0, 0 }, { 0, gen_chance(g, 2) ? NAN : INFINITY, 0 } };
    const et_cloud_format format = (et_cloud_format)gen_upto(g, 3);
    bool ok = true;

    some_path(path, ".none");
    ok = ok && gen_check(g, et_cloud_write(NULL, p, 1, format, NULL) == ET_EINVAL, "null path");
    ok = ok && gen_check(g, et_cloud_write(path, NULL, 1, format, NULL) == ET_EINVAL, "null points");
    ok = ok && gen_check(g, et_cloud_write(path, p, 0, format, NULL) == ET_EINVAL, "no points");
    ok = ok && gen_check(g, et_cloud_write(path, bad, 2, format, NULL) == ET_EINVAL, "not finite");
    ok = ok && gen_check(g, et_cloud_write(path, bad, 1, format, NULL) == ET_OK, "the finite first");
    unlink(path);
    ok = ok && gen_check(g, et_cloud_write(path, p, 1, (et_cloud_format)4, NULL) == ET_EINVAL, "format");
    ok = ok && gen_check(g, access(path, F_OK) != 0, "a file is there");
    ok = ok && gen_check(g, et_cloud_write("/dev/full", p, 1, format, &message) == ET_EIO, "/dev/full");
    snprintf(told, sizeof told, "cannot write /dev/full: %s", strerror(ENOSPC));
    return ok && gen_check(g, strcmp(message.text, told) == 0, "%s", message.text);
}

verdict prop_cloud_write(gen *g)
{
    static const char *const heads[] = { "", "ply\nformat ascii 1.0\n",
                                         "ply\nformat binary_little_endian 1.0\n", "ply\nformat binary_big_endian 1.0\n" };
    const et_cloud_format format = (et_cloud_format)gen_upto(g, 3);
    text t = { .end_of_line = "\n" };
    char path[PATH], *whole;
    et_message message = { "" };
    size_t size, lines = 0;
    bool ok;

    t.count = 1 + (size_t)gen_upto(g, MOST - 1);
    for (size_t i = 0; i < t.count; i++)
        t.want[i] = (et_vec3){ any_real(g), any_real(g), any_real(g) };
    some_path(path, ".out");
    ok = gen_check(g, et_cloud_write(path, t.want, t.count, format, &message) == ET_OK, "%s", message.text) && read_as_wanted(g, &t, path);
    whole = whole_file(path, &size);
    ok = ok && gen_check(g, whole && strncmp(whole, heads[format], strlen(heads[format])) == 0, "head");
    if (ok && format <= ET_CLOUD_PLY_ASCII) {
        char *const data = format == ET_CLOUD_XYZ ? whole : strstr(whole, "end_header\n") + 11;
        for (const char *c = data; *c; c++)
            lines += *c == '\n';
        ok = gen_check(g, lines == t.count && whole[size - 1] == '\n', "%zu lines", lines) && shortest(g, data);
    } else if (ok) {
        const char *const data = strstr(whole, "end_header\n") + 11;
        ok = gen_check(g, (size_t)(whole + size - data) == 24 * t.count, "%zu bytes", size);
    }
    free(whole);
    unlink(path);
    ok = ok && write_is_refused(g, t.want);
    return ok ? PASS : FAIL;
}

/* ---- golden rows ---- */

/* args: the words of one line of an XYZ file; wanted: x y z. */
verdict gold_cloud_read(const row *r)
{
    text t = { .end_of_line = "\n" };
    char path[PATH];
    et_cloud cloud;
    bool ok;

    for (size_t k = 0; k < r->nargs; k++) {
        put_bytes(&t, r->arg[k], strlen(r->arg[k]));
        put(&t, k + 1 < r->nargs ? " " : "\n");
    }
    spill(some_path(path, ".xyz"), &t);
    ok = et_cloud_read(&cloud, path, NULL) == ET_OK;
    unlink(path);
    free(t.bytes);
    if (!ok)
        return FAIL;
    ok = cloud.count == 1;
    ok = row_is(r, 0, cloud.points[0].x) && ok;
    ok = row_is(r, 1, cloud.points[0].y) && ok;
    ok = row_is(r, 2, cloud.points[0].z) && ok;
    et_cloud_free(&cloud);
    return ok ? PASS : FAIL;
}

/* args: x y z; wanted: the three words written. */
verdict gold_cloud_write(const row *r)
{
    const et_vec3 p = { row_real(r, 0), row_real(r, 1), row_real(r, 2) };
    char path[PATH], wanted[200];
    size_t size;

    if (r->nwant != 3 || et_cloud_write(some_path(path, ".xyz"), &p, 1, ET_CLOUD_XYZ, NULL) != ET_OK)
        return FAIL;
    char *const whole = whole_file(path, &size);
    snprintf(wanted, sizeof wanted, "%s %s %s\n", r->want[0], r->want[1], r->want[2]);
    const bool ok = whole && strcmp(whole, wanted) == 0;
    free(whole);
    unlink(path);
    return ok ? PASS : FAIL;
}

verdict gold_cloud_name(const row *r)
{
    const char *const name = et_cloud_name((et_cloud_format)row_size(r, 0));

    return r->nwant == 1 && strcmp(name ? name : "null", r->want[0]) == 0 ? PASS : FAIL;
}
