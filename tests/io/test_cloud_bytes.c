/* io/cloud: STL, PLY and PCD, text and bytes. */
#include "io/clouds.h"

/* ---- STL ---- */

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
