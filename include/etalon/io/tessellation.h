/* tessellation: a watertight triangle mesh of a shell (shared vertices along the seam), as OBJ and STL. */
#ifndef ETALON_IO_TESSELLATION_H
#define ETALON_IO_TESSELLATION_H
#include "etalon/base/frame.h"
#include "etalon/fit/shell.h"
#ifdef __cplusplus
extern "C" {
#endif

/* Triangle t joins vertices[triangles[t][0]], [1], [2], counter-clockwise seen from outside. */
typedef struct { et_vec3 *vertices; size_t nvertices; size_t (*triangles)[3]; size_t ntriangles; } et_tessellation;

/*@ predicate et_tessellation_ok(et_tessellation *m) =
        \valid_read(m) && \valid_read(m->vertices + (0 .. m->nvertices - 1)) && \valid_read(m->triangles + (0 .. m->ntriangles - 1)) &&
        (\forall integer t, k; 0 <= t < m->ntriangles && 0 <= k < 3 ==> m->triangles[t][k] < m->nvertices);
*/

/* nu x nv parameters a view, u = i/(nu-1), v = j/(nv-1), nu and nv >= 2: the vertices are the NOV classes of the double net {nu, nv} in the
 * order of their numbers, in the cloud's own coordinates.  The border takes the bottom view's points: for a shell with a gap the mesh is
 * closed all the same.
 *
 * 4 (nu-1)(nv-1) triangles.  Every edge belongs to exactly two of them, which run through it in opposite directions, and V - E + F = 2 (a sphere):
 * the quads of the bottom are cut along (i,j)-(i+1,j+1), those of the top along the other diagonal; where a side has only 2 parameters
 * the top is laced one step off, because its cross-edges would be the bottom's.  All triangles are turned over if the volume is negative.
 *
 * Golden: none (points are et_surface_grid's; the rest is combinatorial, and the property tests all of it)
 * ET_EINVAL (null pointer, shell not valid, nu or nv < 2, vertices that overflow), ET_ENOMEM. */
/*@ requires mesh:     mesh == \null || \valid(mesh);
    requires shell:    shell == \null || (\valid_read(shell) && et_shell_readable((et_shell *)shell));
    requires frame:    frame == \null || \valid_read(frame);
    requires apart:    mesh != \null ==> \separated(mesh, shell) && \separated(mesh, frame);
    assigns *mesh \from *shell, *frame, nu, nv;
    ensures status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_ENOMEM;
    ensures refused:   (mesh == \null || shell == \null || frame == \null || nu < 2 || nv < 2) ==> \result == ET_EINVAL;
    ensures unchanged: mesh != \null && \result != ET_OK ==> *mesh == \old(*mesh);
    ensures vertices:  \result == ET_OK ==> mesh->nvertices == 2 * (nu * nv - nu - nv + 2);
    ensures triangles: \result == ET_OK ==> mesh->ntriangles == 4 * (nu - 1) * (nv - 1);
    ensures storage:   \result == ET_OK ==> et_tessellation_ok(mesh);
*/
et_status et_tessellation_of(et_tessellation *mesh, const et_shell *shell, const et_frame *frame, size_t nu, size_t nv);

/* Give back the storage and zero the struct; nothing for a null pointer or a zeroed struct.
 * Golden: none (frees memory) */
/*@ requires mesh: mesh == \null || \valid(mesh);
    assigns *mesh;
    ensures empty: mesh != \null ==> mesh->vertices == \null && mesh->nvertices == 0 && mesh->triangles == \null && mesh->ntriangles == 0;
*/
void et_tessellation_free(et_tessellation *mesh);

/* Signed volume by the divergence theorem, positive for triangles that face outwards: sum over triangles of det(a-o, b-o, c-o) / 6 with o the
 * first vertex (any o gives the same for a closed mesh; one of its own keeps a distant offset out of the products).  0 for no triangles.
 * Error to first order at most (b + n/512) u sum |a-o||b-o||c-o|, b < 64: exact for small integer coordinates but for the last division. */
/*@ requires mesh: et_tessellation_ok((et_tessellation *)mesh);
    assigns \nothing;
    ensures none:  mesh->ntriangles == 0 ==> \result == 0.0;
*/
double et_tessellation_volume(const et_tessellation *mesh);

/* Wavefront OBJ: one `v` line a vertex, 17 significant digits (every double round-trips), one `f` line a triangle, counted from 1.
 * Golden: none (the property reads the file back; what it must hold is the mesh itself)
 * ET_EINVAL (null pointer), ET_EIO, ET_ENOMEM. */
/*@ requires path:    path == \null || valid_read_string(path);
    requires mesh:    mesh == \null || et_tessellation_ok((et_tessellation *)mesh);
    requires message: message == \null || \valid(message);
    assigns *message \from *mesh;
    ensures status:   \result == ET_OK || \result == ET_EINVAL || \result == ET_EIO || \result == ET_ENOMEM;
    ensures refused:  (path == \null || mesh == \null) ==> \result == ET_EINVAL;
*/
et_status et_tessellation_write_obj(const char *path, const et_tessellation *mesh, et_message *message);

/* Binary STL, little-endian: 80 bytes of header, the number of triangles in 4 bytes, 50 bytes a triangle (unit normal, three vertices, 0).
 * Vertices are rounded to 32 bits, shared ones alike; normals are those of the rounded triangle, (0,0,0) for one without area.
 * Golden: none (the property reads the bytes back)
 * ET_EINVAL (null pointer, a coordinate beyond 32-bit range, more than 2^32 - 1 triangles), ET_EIO, ET_ENOMEM. */
/*@ requires path:    path == \null || valid_read_string(path);
    requires mesh:    mesh == \null || et_tessellation_ok((et_tessellation *)mesh);
    requires message: message == \null || \valid(message);
    assigns *message \from *mesh;
    ensures status:   \result == ET_OK || \result == ET_EINVAL || \result == ET_EIO || \result == ET_ENOMEM;
    ensures refused:  (path == \null || mesh == \null) ==> \result == ET_EINVAL;
*/
et_status et_tessellation_write_stl(const char *path, const et_tessellation *mesh, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
