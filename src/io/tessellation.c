#include "etalon/io/tessellation.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/io/file.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Where the next triangle goes. */
typedef struct {
    size_t (*triangles)[3], count;
} sink;

/* a, b, c in this order, or turned over. */
static void emit(sink *s, int over, size_t a, size_t b, size_t c)
{
    size_t *const t = s->triangles[s->count++];

    t[0] = a - 1;
    t[1] = (over ? c : b) - 1;
    t[2] = (over ? b : c) - 1;
}

/* The two triangles of the quad (i,j) .. (i+1,j+1), counter-clockwise in (u,v) for the top and clockwise for the bottom. */
static void emit_quad(sink *s, et_doublenet net, size_t view, size_t i, size_t j)
{
    const size_t a = et_doublenet_class(net, view, i, j), b = et_doublenet_class(net, view, i + 1, j);
    const size_t c = et_doublenet_class(net, view, i + 1, j + 1), d = et_doublenet_class(net, view, i, j + 1);

    if (view == ET_BOTTOM) {
        emit(s, 1, a, b, c);
        emit(s, 1, a, c, d);
    } else {
        emit(s, 0, a, b, d);
        emit(s, 0, b, c, d);
    }
}

/* The top of a net with a side of 2: both rows lie on the border, so that a cross-edge (i,i) or (i,i+1) is the bottom's already.
 * Row 0 leads by one or two: cross-edges (1,0), (2,0), (2,1), (3,1), ... are free. */
static void emit_lace(sink *s, et_doublenet net)
{
    const int along_v = net.nx == 2;
    const size_t last = (along_v ? net.ny : net.nx) - 1;
    size_t a = 0, b = 0;

    while (a < last || b < last) {
        const size_t pa = et_doublenet_class(net, ET_TOP, along_v ? 0 : a, along_v ? a : 0);
        const size_t pb = et_doublenet_class(net, ET_TOP, along_v ? 1 : b, along_v ? b : 1);

        if (a < last && a < b + 2) {
            a++;
            emit(s, along_v, pa, et_doublenet_class(net, ET_TOP, along_v ? 0 : a, along_v ? a : 0), pb);
        } else {
            b++;
            emit(s, along_v, pa, et_doublenet_class(net, ET_TOP, along_v ? 1 : b, along_v ? b : 1), pb);
        }
    }
}

static void fill_triangles(et_tessellation *mesh, et_doublenet net)
{
    sink s = {mesh->triangles, 0};

    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++) {
        if (view == ET_TOP && (net.nx == 2 || net.ny == 2)) {
            emit_lace(&s, net);
            continue;
        }
        for (size_t i = 0; i + 1 < net.nx; i++)
            for (size_t j = 0; j + 1 < net.ny; j++)
                emit_quad(&s, net, view, i, j);
    }
}

/* Vertices of a view: the bottom's grid is the first nx*ny classes as they stand, the top gives its interior. */
static et_status fill_vertices(et_vec3 *vertices, const et_shell *shell, et_doublenet net)
{
    const size_t nodes = net.nx * net.ny;
    double *const a = et_size_array(net.nx, sizeof *a), *const b = et_size_array(net.ny, sizeof *b);
    et_vec3 *const top = et_size_array(nodes, sizeof *top);
    et_status status = a && b && top ? ET_OK : ET_ENOMEM;

    for (size_t i = 0; !status && i < net.nx; i++)
        a[i] = (double)i / (double)(net.nx - 1);
    for (size_t j = 0; !status && j < net.ny; j++)
        b[j] = (double)j / (double)(net.ny - 1);
    if (!status)
        status = et_surface_grid(vertices, &shell->view[ET_BOTTOM], a, net.nx, b, net.ny);
    if (!status)
        status = et_surface_grid(top, &shell->view[ET_TOP], a, net.nx, b, net.ny);
    for (size_t i = 1; !status && i + 1 < net.nx; i++)
        for (size_t j = 1; j + 1 < net.ny; j++)
            vertices[et_doublenet_class(net, ET_TOP, i, j) - 1] = top[i * net.ny + j];
    free(a);
    free(b);
    free(top);
    return status;
}

static void turn_over(et_tessellation *mesh)
{
    for (size_t t = 0; t < mesh->ntriangles; t++) {
        const size_t b = mesh->triangles[t][1];

        mesh->triangles[t][1] = mesh->triangles[t][2];
        mesh->triangles[t][2] = b;
    }
}

et_status et_tessellation_of(et_tessellation *mesh, const et_shell *shell, const et_frame *frame, size_t nu, size_t nv)
{
    const et_doublenet net = {nu, nv};
    et_tessellation m = {0};
    et_status status;

    if (!mesh || !shell || !frame || !et_shell_valid(shell) || !et_doublenet_valid(net))
        return ET_EINVAL;
    if (et_size_mul(&m.ntriangles, 4, (nu - 1) * (nv - 1)))
        return ET_ENOMEM;
    m.nvertices = et_doublenet_nov(net);
    m.vertices = et_size_array(m.nvertices, sizeof *m.vertices);
    m.triangles = et_size_array(m.ntriangles, sizeof *m.triangles);
    status = m.vertices && m.triangles ? fill_vertices(m.vertices, shell, net) : ET_ENOMEM;
    if (!status) {
        et_frame_from_unit(m.vertices, m.nvertices, frame);
        status = et_vec3_finite(m.vertices, m.nvertices) ? ET_OK : ET_EINVAL;
    }
    if (status) {
        et_tessellation_free(&m);
        return status;
    }
    fill_triangles(&m, net);
    if (et_tessellation_volume(&m) < 0)
        turn_over(&m);
    *mesh = m;
    return ET_OK;
}

void et_tessellation_free(et_tessellation *mesh)
{
    if (!mesh)
        return;
    free(mesh->vertices);
    free(mesh->triangles);
    *mesh = (et_tessellation){0};
}

static et_vec3 minus(et_vec3 a, et_vec3 b)
{
    return (et_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static et_vec3 cross(et_vec3 a, et_vec3 b)
{
    return (et_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static double six_volumes(const et_tessellation *mesh, size_t t)
{
    const et_vec3 o = mesh->vertices[0];
    const et_vec3 a = minus(mesh->vertices[mesh->triangles[t][0]], o);
    const et_vec3 b = minus(mesh->vertices[mesh->triangles[t][1]], o);
    const et_vec3 c = minus(mesh->vertices[mesh->triangles[t][2]], o);
    const et_vec3 n = cross(b, c);

    return a.x * n.x + a.y * n.y + a.z * n.z;
}

double et_tessellation_volume(const et_tessellation *mesh)
{
    double term[512], sum = 0;
    size_t n = 0;

    /* Blocks on the stack: the volume needs no memory and cannot fail, at the price of n/512 plain additions. */
    for (size_t t = 0; t < mesh->ntriangles; t++) {
        term[n++] = six_volumes(mesh, t);
        if (n == sizeof term / sizeof *term || t + 1 == mesh->ntriangles) {
            sum += et_real_sum(term, n);
            n = 0;
        }
    }
    return sum / 6;
}

et_status et_tessellation_write_obj(const char *path, const et_tessellation *mesh, et_message *message)
{
    et_file file = {0};
    et_status status;

    if (!path || !mesh)
        return et_status_fail(message, ET_EINVAL, "OBJ: no path or no mesh");
    status = et_file_create(&file, path, message);
    if (status)
        return status;
    fprintf(file.stream, "# Etalon: %zu vertices, %zu triangles\n", mesh->nvertices, mesh->ntriangles);
    for (size_t i = 0; i < mesh->nvertices; i++)
        fprintf(file.stream, "v %.17g %.17g %.17g\n", mesh->vertices[i].x, mesh->vertices[i].y, mesh->vertices[i].z);
    for (size_t t = 0; t < mesh->ntriangles; t++)
        fprintf(file.stream, "f %zu %zu %zu\n", mesh->triangles[t][0] + 1, mesh->triangles[t][1] + 1, mesh->triangles[t][2] + 1);
    return et_file_commit(&file, message);
}

/* x rounded to 32 bits.  volatile: gcc 12.2 at -O2 drops the rounding where it vectorises double -> float -> double. */
static double rounded(double x)
{
    volatile float f = (float)x;

    return f;
}

static unsigned char *put_u32(unsigned char *to, uint32_t x)
{
    for (int k = 0; k < 4; k++)
        *to++ = (unsigned char)(x >> 8 * k & 0xff);
    return to;
}

static unsigned char *put_vec3(unsigned char *to, et_vec3 p)
{
    const float x[3] = {(float)p.x, (float)p.y, (float)p.z};

    for (int k = 0; k < 3; k++) {
        uint32_t bits;

        memcpy(&bits, &x[k], sizeof bits);
        to = put_u32(to, bits);
    }
    return to;
}

/* The unit normal of a triangle of 32-bit coordinates: in double neither the products nor their squares overflow or vanish. */
static et_vec3 normal_of(const et_vec3 p[3])
{
    const et_vec3 n = cross(minus(p[1], p[0]), minus(p[2], p[0]));
    const double length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z);

    return length > 0 ? (et_vec3){n.x / length, n.y / length, n.z / length} : (et_vec3){0, 0, 0};
}

static void put_triangle(unsigned char record[50], const et_tessellation *mesh, size_t t)
{
    et_vec3 p[3];
    unsigned char *to = record;

    for (int k = 0; k < 3; k++) {
        const et_vec3 q = mesh->vertices[mesh->triangles[t][k]];

        p[k] = (et_vec3){rounded(q.x), rounded(q.y), rounded(q.z)};
    }
    to = put_vec3(to, normal_of(p));
    for (int k = 0; k < 3; k++)
        to = put_vec3(to, p[k]);
    to[0] = to[1] = 0;
}

static int fits_stl(const et_tessellation *mesh)
{
    const double most = FLT_MAX;

    if (mesh->ntriangles > UINT32_MAX)
        return 0;
    for (size_t i = 0; i < mesh->nvertices; i++) {
        const et_vec3 p = mesh->vertices[i];

        if (!(fabs(p.x) <= most && fabs(p.y) <= most && fabs(p.z) <= most))
            return 0;
    }
    return 1;
}

et_status et_tessellation_write_stl(const char *path, const et_tessellation *mesh, et_message *message)
{
    unsigned char head[84] = "Etalon binary STL", record[50];
    et_file file = {0};
    et_status status;

    if (!path || !mesh)
        return et_status_fail(message, ET_EINVAL, "STL: no path or no mesh");
    if (!fits_stl(mesh))
        return et_status_fail(message, ET_EINVAL, "%s: the mesh does not fit STL's 32-bit numbers", path);
    status = et_file_create(&file, path, message);
    if (status)
        return status;
    put_u32(head + 80, (uint32_t)mesh->ntriangles);
    fwrite(head, 1, sizeof head, file.stream);
    for (size_t t = 0; t < mesh->ntriangles; t++) {
        put_triangle(record, mesh, t);
        fwrite(record, 1, sizeof record, file.stream);
    }
    return et_file_commit(&file, message);
}
