#include "etalon/io/tessellation.h"
#include "golden.h"
#include "some_shell.h"
#include <float.h>
#include <math.h>
#include <stdint.h>

enum { SIDE = 6, MOST = 2 * SIDE * SIDE };

/* Directed edges: how many triangles run from a to b. */
static int edge[MOST][MOST];

static int count_edges(const et_tessellation *m)
{
    int most = 0;

    memset(edge, 0, sizeof edge);
    for (size_t t = 0; t < m->ntriangles; t++)
        for (size_t k = 0; k < 3; k++) {
            int *const e = &edge[m->triangles[t][k]][m->triangles[t][(k + 1) % 3]];

            *e += 1;
            most = *e > most ? *e : most;
        }
    return most;
}

static bool is_sphere(gen *g, const et_tessellation *m)
{
    size_t edges = 0, used = 0;
    bool ok = gen_check(g, count_edges(m) == 1, "an edge is run through twice in one direction");

    for (size_t a = 0; a < m->nvertices; a++) {
        size_t degree = 0;

        ok = ok && gen_check(g, edge[a][a] == 0, "triangle with vertex %zu twice", a);
        for (size_t b = 0; b < m->nvertices; b++) {
            ok = ok && gen_check(g, edge[a][b] == edge[b][a], "edge %zu-%zu is open", a, b);
            edges += a < b && edge[a][b];
            degree += (size_t)edge[a][b];
        }
        used += degree >= 3;
    }
    ok = ok && gen_check(g, used == m->nvertices, "%zu of %zu vertices used", used, m->nvertices);
    return ok && gen_check(g, m->nvertices + m->ntriangles == edges + 2, "Euler: %zu - %zu + %zu", m->nvertices, edges, m->ntriangles);
}

/* Triangle t has the vertices a, b, c in this cyclic order. */
static bool runs(const et_tessellation *m, size_t t, size_t a, size_t b, size_t c)
{
    const size_t *const v = m->triangles[t];

    return (v[0] == a && v[1] == b && v[2] == c) || (v[0] == b && v[1] == c && v[2] == a) || (v[0] == c && v[1] == a && v[2] == b);
}

static bool has(const et_tessellation *m, size_t a, size_t b, size_t c)
{
    for (size_t t = 0; t < m->ntriangles; t++)
        if (runs(m, t, a, b, c))
            return true;
    return false;
}

static size_t at(size_t nu, size_t nv, size_t view, size_t i, size_t j)
{
    const bool border = i == 0 || j == 0 || i + 1 == nu || j + 1 == nv;

    return view == 0 || border ? i * nv + j : nu * nv + (i - 1) * (nv - 2) + j - 1;
}

/* The stated cut of every quad; which side is out decides the sense, one for all. */
static bool cuts_as_said(gen *g, const et_tessellation *m, size_t nu, size_t nv)
{
    bool ok = true;

    for (int over = 0, fits = 0; over < 2 && !fits; over++) {
        fits = 1;
        for (size_t i = 0; i + 1 < nu; i++)
            for (size_t j = 0; j + 1 < nv; j++) {
                const size_t a = at(nu, nv, 0, i, j), b = at(nu, nv, 0, i + 1, j), c = at(nu, nv, 0, i + 1, j + 1), d = at(nu, nv, 0, i, j + 1);
                const size_t e = at(nu, nv, 1, i, j), f = at(nu, nv, 1, i + 1, j), h = at(nu, nv, 1, i + 1, j + 1), k = at(nu, nv, 1, i, j + 1);

                fits = fits && (over ? has(m, a, b, c) && has(m, a, c, d) : has(m, a, c, b) && has(m, a, d, c));
                if (nu > 2 && nv > 2)
                    fits = fits && (over ? has(m, e, k, f) && has(m, f, k, h) : has(m, e, f, k) && has(m, f, h, k));
            }
        ok = fits;
    }
    return gen_check(g, ok, "quads are not cut as stated");
}

static bool same(et_vec3 a, et_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool points_as_said(gen *g, const et_tessellation *m, const et_shell *shell, const et_frame *frame, size_t nu, size_t nv)
{
    const size_t nwork = et_surface_work(&shell->view[0]);
    double *const work = calloc(nwork + 1, sizeof *work);
    bool ok = work != NULL;

    for (size_t view = 0; view < 2; view++)
        for (size_t i = 0; i < nu; i++)
            for (size_t j = 0; ok && j < nv; j++) {
                const size_t k = at(nu, nv, view, i, j), from = view && k >= nu * nv;
                et_vec3 p = et_surface_point(&shell->view[from], (double)i / (double)(nu - 1), (double)j / (double)(nv - 1), work, nwork);

                et_frame_from_unit(&p, 1, frame);
                ok = gen_check(g, same(p, m->vertices[k]), "vertex %zu is not S(%zu/%zu, %zu/%zu)", k, i, nu - 1, j, nv - 1);
            }
    free(work);
    return ok;
}

static bool refuses_bad(gen *g, const et_shell *shell, const et_frame *frame)
{
    et_tessellation m = {NULL, 7, NULL, 8};
    et_frame huge = {{0, 0, 0}, {DBL_MAX, DBL_MAX, DBL_MAX}};
    et_shell zero = {0}, *copy = &zero;
    bool ok = et_tessellation_of(&m, NULL, frame, 2, 2) == ET_EINVAL && et_tessellation_of(&m, shell, NULL, 2, 2) == ET_EINVAL;

    ok = ok && et_tessellation_of(NULL, shell, frame, 2, 2) == ET_EINVAL && et_tessellation_of(&m, copy, frame, 2, 2) == ET_EINVAL;
    ok = ok && et_tessellation_of(&m, shell, frame, 1, 5) == ET_EINVAL && et_tessellation_of(&m, shell, frame, 5, 1) == ET_EINVAL;
    ok = ok && et_tessellation_of(&m, shell, frame, 0, 5) == ET_EINVAL && et_tessellation_of(&m, shell, frame, SIZE_MAX, 3) == ET_EINVAL;
    ok = ok && et_tessellation_of(&m, shell, frame, SIZE_MAX / 8, 4) == ET_ENOMEM;
    huge.offset.x = DBL_MAX;
    if (et_tessellation_of(&m, shell, &huge, 2, 2) == ET_OK)
        ok = ok && et_vec3_finite(m.vertices, m.nvertices), et_tessellation_free(&m), m = (et_tessellation){NULL, 7, NULL, 8};
    return gen_check(g, ok && m.nvertices == 7 && m.ntriangles == 8, "a bad argument was taken or the output touched");
}

verdict prop_tessellation_of(gen *g)
{
    const size_t nu = 2 + (size_t)gen_upto(g, SIDE - 2), nv = 2 + (size_t)gen_upto(g, SIDE - 2);
    const et_frame frame = some_frame(g);
    et_tessellation m = {0};
    et_shell shell = {0};
    bool ok;

    if (some_shell(g, &shell, !gen_chance(g, 4)))
        return SKIP;
    gen_label(g, nu == 2 && nv == 2 ? "two by two" : nu == 2 || nv == 2 ? "a side of two" : "inner vertices");
    ok = gen_check(g, et_tessellation_of(&m, &shell, &frame, nu, nv) == ET_OK, "not done");
    ok = ok && gen_check(g, m.nvertices == 2 * nu * nv - 2 * nu - 2 * nv + 4 && m.ntriangles == 4 * (nu - 1) * (nv - 1), "wrong counts");
    ok = ok && is_sphere(g, &m) && cuts_as_said(g, &m, nu, nv) && points_as_said(g, &m, &shell, &frame, nu, nv);
    ok = ok && gen_check(g, et_tessellation_volume(&m) >= 0, "inside out");
    et_tessellation_free(&m);
    ok = ok && refuses_bad(g, &shell, &frame);
    et_shell_free(&shell);
    return ok ? PASS : FAIL;
}

/* Degree 1, 4 x 4, three control points in each corner: the unit cube exactly, its border at half height.  Either view may be the upper one. */
static et_status unit_cube(et_shell *shell, int upside_down)
{
    static const double x[4] = {0, 0, 1, 1};
    const et_doublenet net = {4, 4};
    const et_status status = et_shell_new(shell, 1, 1, net, 0);

    if (status)
        return status;
    for (size_t view = 0; view < 2; view++)
        for (size_t i = 0; i < 4; i++) {
            shell->view[view].u[i + 1] = shell->view[view].v[i + 1] = (double)i / 3;
            for (size_t j = 0; j < 4; j++) {
                const bool border = i == 0 || j == 0 || i == 3 || j == 3;
                const double z = border ? 0.5 : (view == 1) != upside_down ? 1 : 0;

                shell->view[view].points[4 * i + j] = (et_vec3){x[i], x[j], z};
            }
        }
    for (size_t view = 0; view < 2; view++)
        shell->view[view].u[5] = shell->view[view].v[5] = 1;
    return ET_OK;
}

/* Integer boxes have their volume to the last bit, whichever view is on top: outward triangles either way. */
verdict prop_tessellation_of_cube(gen *g)
{
    const double a = (double)gen_between(g, 1, 1000), b = (double)gen_between(g, 1, 1000), c = 2 * (double)gen_between(g, 1, 500);
    const et_frame frame = {{(double)gen_upto(g, 4096), (double)gen_upto(g, 4096), (double)gen_upto(g, 4096)}, {a, b, c}};
    et_tessellation m = {0};
    et_shell shell = {0};
    bool ok;

    if (unit_cube(&shell, (int)gen_upto(g, 1)))
        return SKIP;
    ok = gen_check(g, et_tessellation_of(&m, &shell, &frame, 4, 4) == ET_OK, "not done");
    ok = ok && gen_check(g, et_tessellation_volume(&m) == a * b * c, "volume %.17g of %g x %g x %g", et_tessellation_volume(&m), a, b, c);
    et_tessellation_free(&m);
    et_shell_free(&shell);
    return ok ? PASS : FAIL;
}

/* Connectivity of a net with random integer vertices: six volumes are an integer, by another formula (prisms down to z = 0). */
verdict prop_tessellation_volume(gen *g)
{
    static const size_t sides[][2] = {{2, 2}, {3, 4}, {9, 17}, {14, 14}, {17, 17}};
    const size_t *const side = sides[gen_upto(g, gen_chance(g, 8) ? 4 : 1)];
    const double shift = gen_chance(g, 3) ? 0x1p40 : 0;
    const et_frame frame = {{0, 0, 0}, {1, 1, 1}};
    et_tessellation m = {0};
    et_shell shell = {0};
    long long six = 0;
    bool ok;

    if (unit_cube(&shell, 0) || et_tessellation_of(&m, &shell, &frame, side[0], side[1]))
        return et_shell_free(&shell), FAIL;
    for (size_t i = 0; i < m.nvertices; i++)
        m.vertices[i] = (et_vec3){(double)gen_upto(g, 2000) - 1000, (double)gen_upto(g, 2000) - 1000, (double)gen_upto(g, 2000) - 1000};
    for (size_t t = 0; t < m.ntriangles; t++) {
        const et_vec3 a = m.vertices[m.triangles[t][0]], b = m.vertices[m.triangles[t][1]], c = m.vertices[m.triangles[t][2]];
        const long long area = (long long)((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));

        six += area * (long long)(a.z + b.z + c.z);
    }
    for (size_t i = 0; i < m.nvertices; i++)
        m.vertices[i].y += shift;
    ok = gen_check(g, et_tessellation_volume(&m) == (double)six / 6, "%.17g, not %lld/6", et_tessellation_volume(&m), six);
    et_tessellation_free(&m);
    ok = ok && gen_check(g, et_tessellation_volume(&m) == 0, "no triangles, but a volume");
    et_shell_free(&shell);
    return ok ? PASS : FAIL;
}

verdict prop_tessellation_free(gen *g)
{
    et_tessellation m = {0};

    m.vertices = calloc(1 + (size_t)gen_upto(g, 5), sizeof *m.vertices);
    m.triangles = calloc(1 + (size_t)gen_upto(g, 5), sizeof *m.triangles);
    m.nvertices = m.ntriangles = 1;
    et_tessellation_free(NULL);
    et_tessellation_free(&m);
    et_tessellation_free(&m);
    return gen_check(g, !m.vertices && !m.triangles && !m.nvertices && !m.ntriangles, "not empty") ? PASS : FAIL;
}

/* A mesh to be written: any doubles, small connectivity. */
static bool some_mesh(gen *g, et_tessellation *m)
{
    const size_t n = 3 + (size_t)gen_upto(g, 6), triangles = (size_t)gen_upto(g, 8);

    m->vertices = calloc(n, sizeof *m->vertices);
    m->triangles = calloc(triangles + 1, sizeof *m->triangles);
    m->nvertices = n;
    m->ntriangles = triangles;
    if (!m->vertices || !m->triangles)
        return false;
    gen_points(g, &m->vertices[0].x, n);
    for (size_t t = 0; t < triangles; t++)
        for (size_t k = 0; k < 3; k++)
            m->triangles[t][k] = (size_t)gen_upto(g, n - 1);
    return true;
}

static bool obj_is(gen *g, const char *text, const et_tessellation *m)
{
    const char *c = text;
    bool ok = true;

    c += c[0] == '#' ? strcspn(c, "\n") + 1 : 0;
    for (size_t i = 0; ok && i < m->nvertices; i++) {
        et_vec3 p = {0, 0, 0};
        int n = 0;

        ok = gen_check(g, sscanf(c, "v %lf %lf %lf\n%n", &p.x, &p.y, &p.z, &n) == 3 && n > 0, "vertex line %zu", i);
        ok = ok && gen_check(g, memcmp(&p, &m->vertices[i], sizeof p) == 0, "vertex %zu changed", i);
        c += n;
    }
    for (size_t t = 0; ok && t < m->ntriangles; t++) {
        size_t v[3] = {0, 0, 0};
        int n = 0;

        ok = gen_check(g, sscanf(c, "f %zu %zu %zu\n%n", &v[0], &v[1], &v[2], &n) == 3 && n > 0, "face line %zu", t);
        for (size_t k = 0; k < 3; k++)
            ok = ok && gen_check(g, v[k] == m->triangles[t][k] + 1, "face %zu changed", t);
        c += n;
    }
    return ok && gen_check(g, *c == '\0', "more lines than the mesh has");
}

verdict prop_tessellation_write_obj(gen *g)
{
    char path[256], *text = NULL;
    et_tessellation m = {0};
    et_message message;
    size_t size;
    bool ok = some_mesh(g, &m);

    ok = ok && gen_check(g, et_tessellation_write_obj(some_path(path, ".obj"), &m, &message) == ET_OK, "not written");
    text = whole_file(path, &size);
    ok = ok && gen_check(g, text != NULL, "no file") && obj_is(g, text, &m);
    ok = ok && gen_check(g, et_tessellation_write_obj(NULL, &m, &message) == ET_EINVAL, "null path taken");
    ok = ok && gen_check(g, et_tessellation_write_obj(path, NULL, NULL) == ET_EINVAL, "null mesh taken");
    ok = ok && gen_check(g, et_tessellation_write_obj("/nonexistent/x.obj", &m, &message) == ET_EIO, "written nowhere");
    free(text);
    remove(path);
    et_tessellation_free(&m);
    return ok ? PASS : FAIL;
}

static float float_at(const char *bytes)
{
    const unsigned char *const b = (const unsigned char *)bytes;
    const uint32_t bits = (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
    float x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The normal is one of unit length at right angles to both sides and of the sense of the triangle; in 32 bits: each within 2^-22. */
static bool normal_is(gen *g, const double n[3], const et_vec3 p[3])
{
    const double a[3] = {p[1].x - p[0].x, p[1].y - p[0].y, p[1].z - p[0].z}, b[3] = {p[2].x - p[0].x, p[2].y - p[0].y, p[2].z - p[0].z};
    const double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double most = fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2])));
    double length = 0;

    for (int k = 0; k < 3; k++)
        length += most > 0 ? c[k] / most * (c[k] / most) : 0;
    length = sqrt(length);
    for (int k = 0; k < 3; k++) {
        const double want = most > 0 ? c[k] / most / length : 0;

        if (!gen_check(g, fabs(n[k] - want) <= 0x1p-22, "normal %d is %g, not %g (%g %g %g; %g %g %g)", k, n[k], want, a[0], a[1], a[2], b[0], b[1], b[2]))
            return false;
    }
    return true;
}

static bool stl_is(gen *g, const char *bytes, size_t size, const et_tessellation *m)
{
    bool ok = gen_check(g, size == 84 + 50 * m->ntriangles, "%zu bytes", size) && gen_check(g, memcmp(bytes, "solid", 5) != 0, "looks like text");
    const unsigned char *const count = (const unsigned char *)bytes + 80;

    ok = ok && gen_check(g, count[0] == m->ntriangles && !count[1] && !count[2] && !count[3], "wrong count");
    for (size_t t = 0; ok && t < m->ntriangles; t++) {
        const char *const record = bytes + 84 + 50 * t;
        double n[3];
        et_vec3 p[3];

        for (size_t k = 0; k < 3; k++) {
            const et_vec3 q = m->vertices[m->triangles[t][k]];

            n[k] = float_at(record + 4 * k);
            p[k] = (et_vec3){float_at(record + 12 + 12 * k), float_at(record + 16 + 12 * k), float_at(record + 20 + 12 * k)};
            ok = ok && gen_check(g, p[k].x == (float)q.x && p[k].y == (float)q.y && p[k].z == (float)q.z, "vertex %zu of %zu", k, t);
        }
        ok = ok && normal_is(g, n, p) && gen_check(g, record[48] == 0 && record[49] == 0, "attribute of %zu", t);
    }
    return ok;
}

verdict prop_tessellation_write_stl(gen *g)
{
    char path[256], *bytes = NULL;
    et_tessellation m = {0};
    et_message message;
    size_t size;
    bool ok = some_mesh(g, &m), fits = true;

    for (size_t i = 0; ok && i < m.nvertices; i++) {
        double *const x = &m.vertices[i].x;

        if (gen_chance(g, 40))
            x[gen_upto(g, 2)] = gen_chance(g, 2) ? FLT_MAX : -(double)FLT_MAX * (1 + 0x1p-20);
        for (size_t k = 0; k < 3; k++)
            fits = fits && x[k] >= -(double)FLT_MAX && x[k] <= FLT_MAX;
    }
    gen_label(g, fits ? "fits" : "does not fit");
    ok = ok && gen_check(g, et_tessellation_write_stl(some_path(path, ".stl"), &m, &message) == (fits ? ET_OK : ET_EINVAL), "wrong status");
    bytes = whole_file(path, &size);
    ok = ok && gen_check(g, fits == (bytes != NULL), "a file, or none") && (!fits || stl_is(g, bytes, size, &m));
    ok = ok && gen_check(g, et_tessellation_write_stl(NULL, &m, &message) == ET_EINVAL, "null path taken");
    ok = ok && gen_check(g, et_tessellation_write_stl(path, NULL, NULL) == ET_EINVAL, "null mesh taken");
    ok = ok && gen_check(g, !fits || et_tessellation_write_stl("/nonexistent/x.stl", &m, &message) == ET_EIO, "written nowhere");
    free(bytes);
    remove(path);
    et_tessellation_free(&m);
    return ok ? PASS : FAIL;
}

/* nvertices, ntriangles, coordinates, indices; the volume. */
verdict gold_tessellation_volume(const row *r)
{
    et_tessellation m = {0};
    verdict v = FAIL;

    m.nvertices = row_size(r, 0);
    m.ntriangles = row_size(r, 1);
    m.vertices = calloc(m.nvertices + 1, sizeof *m.vertices);
    m.triangles = calloc(m.ntriangles + 1, sizeof *m.triangles);
    if (m.vertices && m.triangles && r->nargs == 2 + 3 * (m.nvertices + m.ntriangles)) {
        for (size_t i = 0; i < m.nvertices; i++)
            m.vertices[i] = (et_vec3){row_real(r, 2 + 3 * i), row_real(r, 3 + 3 * i), row_real(r, 4 + 3 * i)};
        for (size_t t = 0; t < m.ntriangles; t++)
            for (size_t k = 0; k < 3; k++)
                m.triangles[t][k] = row_size(r, 2 + 3 * (m.nvertices + t) + k);
        v = row_is(r, 0, et_tessellation_volume(&m)) ? PASS : FAIL;
    }
    et_tessellation_free(&m);
    return v;
}
