/* io/cloud: arguments, places, locale; writing; golden rows. */
#include "io/clouds.h"

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
