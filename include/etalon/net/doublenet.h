/* doublenet: two nx x ny grids glued along their border (You 2023, section 4.2; the same numbering serves the map and the control nets).
 *
 * A node is (view, i, j), view 0 bottom, 1 top, i < nx, j < ny.  Its index vector is (i, j, k): k = 1 on the border (shared by
 * both views), k = 0 in the bottom's interior, k = 2 in the top's.  Nodes with equal index vectors form one class; classes are
 * numbered from 1: i*ny + j + 1 for the bottom view, nx*ny + (i-1)*(ny-2) + (j-1) + 1 for the top's interior.
 * What belongs to class c stands at array index c - 1.
 *
 * Everything here is integer arithmetic and exact.  A net with a side of 2 has no interior: it is all border, NOV = NOR = nx ny.
 */
#ifndef ETALON_NET_DOUBLENET_H
#define ETALON_NET_DOUBLENET_H
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { size_t nx, ny; } et_doublenet;
typedef struct { size_t i, j, k; } et_index;      /* index vector */

enum { ET_BOTTOM = 0, ET_TOP = 1 };

/*@ predicate et_net_ok(integer nx, integer ny) = 2 <= nx && 2 <= ny && 2*(nx*ny) <= SIZE_MAX;

    logic integer NON(integer nx, integer ny) = 2*(nx*ny);
    logic integer NOV(integer nx, integer ny) = 2*(nx*ny - nx - ny + 2);
    logic integer NOR(integer nx, integer ny) = 2*nx + 2*(ny - 2);

    predicate et_net_border(integer nx, integer ny, integer i, integer j) = i == 0 || i == nx - 1 || j == 0 || j == ny - 1;
    predicate et_net_inside(integer nx, integer ny, integer i, integer j) = 0 <= i < nx && 0 <= j < ny;

    predicate et_index_ok(integer nx, integer ny, integer i, integer j, integer k) =
        et_net_inside(nx, ny, i, j) && (et_net_border(nx, ny, i, j) ==> k == 1) && (!et_net_border(nx, ny, i, j) ==> k == 0 || k == 2);

    logic integer et_class_of(integer nx, integer ny, integer i, integer j, integer k) =
        k <= 1 ? i*ny + j + 1 : nx*ny + (i - 1)*(ny - 2) + (j - 1) + 1;

    logic integer et_level_of(integer nx, integer ny, integer view, integer i, integer j) =
        i == 0 || i == nx - 1 || j == 0 || j == ny - 1 ? 1 : 2*view;

    logic integer et_absdiff(integer a, integer b) = a < b ? b - a : a - b;

    logic integer et_seam_i(integer nx, integer ny, integer s) =
        s < ny ? 0 : s <= ny + nx - 2 ? s - ny + 1 : s <= 2*ny + nx - 3 ? nx - 1 : 2*nx + 2*ny - 4 - s;
    logic integer et_seam_j(integer nx, integer ny, integer s) =
        s < ny ? s : s <= ny + nx - 2 ? ny - 1 : s <= 2*ny + nx - 3 ? 2*ny + nx - 3 - s : 0;
    logic integer et_seam_class(integer nx, integer ny, integer s) = et_seam_i(nx, ny, s)*ny + et_seam_j(nx, ny, s) + 1;
*/
/*@ lemma et_net_count: \forall integer nx, ny; NON(nx, ny) == NOV(nx, ny) + NOR(nx, ny);
    lemma et_net_top:   \forall integer nx, ny; nx*ny + (nx - 2)*(ny - 2) == NOV(nx, ny);
*/

/* Whether the net is one: nx, ny >= 2 and 2 nx ny does not overflow size_t.  Total. */
/*@ assigns \nothing;
    ensures truth: \result == 0 || \result == 1;
    ensures valid: \result == 1 <==> et_net_ok(net.nx, net.ny);
*/
int et_doublenet_valid(et_doublenet net);

/* NON = 2 nx ny, the number of nodes of both views (You 2023, Eq. 4.1). */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    assigns \nothing;
    ensures count:  \result == NON(net.nx, net.ny);
*/
size_t et_doublenet_non(et_doublenet net);

/* NOV = 2 (nx ny - nx - ny + 2), the number of classes (You 2023, Eq. 4.2). */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    assigns \nothing;
    ensures count:  \result == NOV(net.nx, net.ny);
    ensures range:  4 <= \result <= NON(net.nx, net.ny);
*/
size_t et_doublenet_nov(et_doublenet net);

/* NOR = 2 nx + 2 (ny - 2) = NON - NOV, the number of redundant nodes, which is that of the border's classes (You 2023, Eq. 4.3). */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    assigns \nothing;
    ensures count:  \result == NOR(net.nx, net.ny);
    ensures sum:    \result + NOV(net.nx, net.ny) == NON(net.nx, net.ny);
*/
size_t et_doublenet_nor(et_doublenet net);

/* The class of node (view, i, j), 1 .. NOV; nodes of the border have one class in both views (You 2023, Table 4.2). */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    requires node:  view <= 1 && i < net.nx && j < net.ny;
    assigns \nothing;
    ensures value:  \result == et_class_of(net.nx, net.ny, i, j, et_level_of(net.nx, net.ny, view, i, j));
    ensures range:  1 <= \result <= NOV(net.nx, net.ny);
*/
size_t et_doublenet_class(et_doublenet net, size_t view, size_t i, size_t j);

/* The index vector of class c, 1 .. NOV: the inverse of the numbering, one vector a class and one class a vector (You 2023, Table 4.3). */
/*@ requires net:     et_net_ok(net.nx, net.ny);
    requires class:   1 <= c <= NOV(net.nx, net.ny);
    assigns \nothing;
    ensures vector:   et_index_ok(net.nx, net.ny, \result.i, \result.j, \result.k);
    ensures inverse:  et_class_of(net.nx, net.ny, \result.i, \result.j, \result.k) == c;
    ensures unique:   \forall integer i, j, k; et_index_ok(net.nx, net.ny, i, j, k) && et_class_of(net.nx, net.ny, i, j, k) == c
                          ==> i == \result.i && j == \result.j && k == \result.k;
*/
et_index et_doublenet_index(et_doublenet net, size_t c);

/* The classes of the corners (0,0), (0,ny-1), (nx-1,0), (nx-1,ny-1): 1, ny, ny(nx-1)+1, nx ny (You 2023, Table 5.1; its Eq. 5.10 lacks the +1). */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    requires valid: \valid(c + (0 .. 3));
    assigns c[0 .. 3];
    ensures c0:     c[0] == 1;
    ensures c1:     c[1] == net.ny;
    ensures c2:     c[2] == net.ny*(net.nx - 1) + 1;
    ensures c3:     c[3] == net.nx*net.ny;
*/
void et_doublenet_corners(size_t c[4], et_doublenet net);

/* The classes of the seam in cyclic order, NOR of them, from (0,0) along j, then along i, and back: (0,0) .. (0,ny-1), (1,ny-1) .. (nx-1,ny-1),
 * (nx-1,ny-2) .. (nx-1,0), (nx-2,0) .. (1,0).  Consecutive classes, the last and the first too, are neighbours in the grid. */
/*@ requires net:    et_net_ok(net.nx, net.ny);
    requires size:   nor == NOR(net.nx, net.ny);
    requires valid:  \valid(c + (0 .. nor - 1));
    assigns c[0 .. nor - 1];
    ensures value:   \forall integer s; 0 <= s < nor ==> c[s] == et_seam_class(net.nx, net.ny, s);
    ensures range:   \forall integer s; 0 <= s < nor ==> 1 <= c[s] <= net.nx*net.ny;
    ensures once:    \forall integer s, t; 0 <= s < t < nor ==> c[s] != c[t];
    ensures first:   c[0] == 1 && c[net.ny - 1] == net.ny;
    ensures opposite: c[net.ny + net.nx - 2] == net.nx*net.ny;
*/
void et_doublenet_seam(size_t *c, size_t nor, et_doublenet net);

/* I^2 + J^2 + K^2 with I = |a.i - b.i| and so on: the squared distance within the net (You 2023, Eqs. 4.4-4.7). */
/*@ requires fits:  et_absdiff(a.i, b.i)*et_absdiff(a.i, b.i) + et_absdiff(a.j, b.j)*et_absdiff(a.j, b.j)
                        + et_absdiff(a.k, b.k)*et_absdiff(a.k, b.k) <= SIZE_MAX;
    assigns \nothing;
    ensures value:  \result == et_absdiff(a.i, b.i)*et_absdiff(a.i, b.i) + et_absdiff(a.j, b.j)*et_absdiff(a.j, b.j)
                        + et_absdiff(a.k, b.k)*et_absdiff(a.k, b.k);
*/
size_t et_doublenet_dist2(et_index a, et_index b);

/* The neighbour rule of the topographic error: I^2 + J^2 <= 1 and K <= 1, that is, I + J <= 1 and K <= 1.  Total.
 * An index vector is adjacent to itself; (i,j,0) and (i,j,2), one above the other, are not adjacent. */
/*@ assigns \nothing;
    ensures truth:  \result == 0 || \result == 1;
    ensures rule:   \result == 1 <==> et_absdiff(a.i, b.i) + et_absdiff(a.j, b.j) <= 1 && et_absdiff(a.k, b.k) <= 1;
*/
int et_doublenet_adjacent(et_index a, et_index b);

#ifdef __cplusplus
}
#endif
#endif
