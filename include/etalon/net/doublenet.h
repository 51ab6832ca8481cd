/* doublenet: two nx x ny grids glued along their border (You 2023, section 4.2; the same numbering serves the map and the control nets).
 *
 * A node is (view, i, j), view 0 bottom, 1 top, i < nx, j < ny.  Its index vector is (i, j, k): k = 1 on the border (shared by
 * both views), k = 0 in the bottom's interior, k = 2 in the top's.  Nodes with equal index vectors form one class; classes are
 * numbered from 1: i*ny + j + 1 for the bottom view, nx*ny + (i-1)*(ny-2) + (j-1) + 1 for the top's interior.
 * What belongs to class c stands at array index c - 1.
 */
#ifndef ETALON_NET_DOUBLENET_H
#define ETALON_NET_DOUBLENET_H
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { size_t nx, ny; } et_doublenet;
typedef struct { size_t i, j, k; } et_index;      /* index vector */

enum { ET_BOTTOM = 0, ET_TOP = 1 };

/* nx, ny >= 2 and 2*nx*ny does not overflow size_t. */
int et_doublenet_valid(et_doublenet net);

size_t et_doublenet_non(et_doublenet net);        /* 2 nx ny                      nodes (Eq. 4.1)     */
size_t et_doublenet_nov(et_doublenet net);        /* 2 (nx ny - nx - ny + 2)      classes (Eq. 4.2)   */
size_t et_doublenet_nor(et_doublenet net);        /* 2 nx + 2 (ny - 2)            redundant (Eq. 4.3) */

size_t et_doublenet_class(et_doublenet net, size_t view, size_t i, size_t j);     /* 1 .. NOV */
et_index et_doublenet_index(et_doublenet net, size_t c);                          /* of class c, 1 .. NOV */

/* The classes of the corners (0,0), (0,ny-1), (nx-1,0), (nx-1,ny-1): 1, ny, ny(nx-1)+1, nx ny. */
void et_doublenet_corners(size_t c[4], et_doublenet net);

/* The classes of the seam in cyclic order, NOR of them, from (0,0) along j, then along i, and back. */
void et_doublenet_seam(size_t *c, size_t nor, et_doublenet net);

/* |a.i-b.i|^2 + |a.j-b.j|^2 + |a.k-b.k|^2 (Eq. 4.7), and the neighbour rule of the topographic error: I^2 + J^2 <= 1 and K <= 1. */
size_t et_doublenet_dist2(et_index a, et_index b);
int et_doublenet_adjacent(et_index a, et_index b);

#ifdef __cplusplus
}
#endif
#endif
