/* tessellation: a watertight triangle mesh of a shell (shared vertices along the seam), as OBJ and STL. */
#ifndef ETALON_IO_TESSELLATION_H
#define ETALON_IO_TESSELLATION_H
#include "etalon/base/frame.h"
#include "etalon/fit/shell.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { et_vec3 *vertices; size_t nvertices; size_t (*triangles)[3]; size_t ntriangles; } et_tessellation;

/* nu x nv parameters a view (>= 2 each): the vertices are the classes of a double net {nu, nv}, in the cloud's own coordinates; triangles
 * are oriented alike (outward for a shell of positive volume).  The border takes the bottom view's points: for a shell with a gap the
 * mesh is closed all the same.  ET_EINVAL, ET_ENOMEM. */
et_status et_tessellation_of(et_tessellation *mesh, const et_shell *shell, const et_frame *frame, size_t nu, size_t nv);
void et_tessellation_free(et_tessellation *mesh);

/* Signed volume (divergence theorem). */
double et_tessellation_volume(const et_tessellation *mesh);

et_status et_tessellation_write_obj(const char *path, const et_tessellation *mesh, et_message *message);
et_status et_tessellation_write_stl(const char *path, const et_tessellation *mesh, et_message *message);    /* binary, little-endian */

#ifdef __cplusplus
}
#endif
#endif
