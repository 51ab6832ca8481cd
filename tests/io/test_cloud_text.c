/* io/cloud: XYZ, CSV and OBJ. */
#include "io/clouds.h"

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
/* One case in 3. */
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
