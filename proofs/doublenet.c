/* Theorems on the double net that no single contract states.  Each is a function whose contract is the theorem and whose body calls the functions of
 * src/net/doublenet.c, known here by their contracts alone; proofs/wp.sh proves them. */
#include "etalon/net/doublenet.h"

/* NON = NOV + NOR; and nothing of it overflows. */
/*@ requires net: et_net_ok(net.nx, net.ny);
    assigns \nothing;
    ensures sum:  \result == 1;
*/
int theorem_counts(et_doublenet net)
{
    return et_doublenet_nov(net) + et_doublenet_nor(net) == et_doublenet_non(net);
}

/* Whatever nx and ny are: a net is called valid if and only if its nodes can be counted. */
/*@ assigns \nothing;
    ensures valid: \result == 1 <==> 2 <= nx && 2 <= ny && NON(nx, ny) <= SIZE_MAX;
*/
int theorem_overflow(size_t nx, size_t ny)
{
    et_doublenet net = {nx, ny};
    return et_doublenet_valid(net);
}

/* From a class to its vector and back: every class 1 .. NOV is that of a node, in the bottom view if k = 0 or 1 and in the top if k = 1 or 2. */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    requires class: 1 <= c <= NOV(net.nx, net.ny);
    assigns \nothing;
    ensures back:   \result == 1;
*/
int theorem_onto(et_doublenet net, size_t c)
{
    et_index v = et_doublenet_index(net, c);
    return et_doublenet_class(net, v.k / 2, v.i, v.j) == c;
}

/* From a node to its class and back: nodes of one class have one (i, j), and one view too unless they are on the border. */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    requires node:  view <= 1 && i < net.nx && j < net.ny;
    assigns \nothing;
    ensures back:   \result == 1;
*/
int theorem_one_to_one(et_doublenet net, size_t view, size_t i, size_t j)
{
    et_index v = et_doublenet_index(net, et_doublenet_class(net, view, i, j));
    //@ assert vector: et_index_ok(net.nx, net.ny, i, j, et_level_of(net.nx, net.ny, view, i, j));
    return v.i == i && v.j == j && (v.k == 1 || v.k == 2 * view);
}

/* The two views share a class at (i, j) if and only if (i, j) is on the border. */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    requires node:  i < net.nx && j < net.ny;
    assigns \nothing;
    ensures shared: \result == 1 <==> et_net_border(net.nx, net.ny, i, j);
    ensures truth:  \result == 0 || \result == 1;
*/
int theorem_shared(et_doublenet net, size_t i, size_t j)
{
    //@ ghost fact_product(i + 1, net.nx, net.ny);
    //@ ghost if (0 < i) fact_product(0, i - 1, net.ny - 2);
    return et_doublenet_class(net, ET_BOTTOM, i, j) == et_doublenet_class(net, ET_TOP, i, j);
}

/* Nodes of the two views that differ in (i, j) never share a class; so only border classes are shared. */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    requires nodes: i < net.nx && j < net.ny && a < net.nx && b < net.ny;
    assigns \nothing;
    ensures shared: \result == 1 ==> i == a && j == b && et_net_border(net.nx, net.ny, i, j);
*/
int theorem_only_border(et_doublenet net, size_t i, size_t j, size_t a, size_t b)
{
    //@ assert bottom: et_index_ok(net.nx, net.ny, i, j, et_level_of(net.nx, net.ny, 0, i, j));
    //@ assert top:    et_index_ok(net.nx, net.ny, a, b, et_level_of(net.nx, net.ny, 1, a, b));
    //@ ghost size_t k = i == 0 || i == net.nx - 1 || j == 0 || j == net.ny - 1 ? 1 : 0;
    //@ ghost fact_row(net.nx, net.ny, i, j, k, a);
    return et_doublenet_class(net, ET_BOTTOM, i, j) == et_doublenet_class(net, ET_TOP, a, b);
}

/* Table 5.1: the four corners' classes, from either view. */
/*@ requires net:   et_net_ok(net.nx, net.ny);
    requires view:  view <= 1;
    assigns \nothing;
    ensures table:  \result == 1;
*/
int theorem_corners(et_doublenet net, size_t view)
{
    size_t c[4];
    et_doublenet_corners(c, net);
    return et_doublenet_class(net, view, 0, 0) == c[0] && et_doublenet_class(net, view, 0, net.ny - 1) == c[1]
        && et_doublenet_class(net, view, net.nx - 1, 0) == c[2] && et_doublenet_class(net, view, net.nx - 1, net.ny - 1) == c[3];
}

/* Eq. 5.10 gives the third corner as ny (nx - 1): in the net of 2 x 2 that is class 2, which is the corner (0, 1). */
/*@ assigns \nothing;
    ensures refuted: \result == 3 && \result != 2*(2 - 1);
*/
size_t theorem_eq_5_10(void)
{
    et_doublenet net = {2, 2};
    return et_doublenet_class(net, ET_BOTTOM, 1, 0);
}

/* No class of the bottom's interior is adjacent to one of the top's. */
/*@ requires net:      et_net_ok(net.nx, net.ny);
    requires classes:  1 <= c <= NOV(net.nx, net.ny) && 1 <= d <= NOV(net.nx, net.ny);
    assigns \nothing;
    ensures apart:     \result == 1;
*/
int theorem_interiors_apart(et_doublenet net, size_t c, size_t d)
{
    et_index v = et_doublenet_index(net, c), w = et_doublenet_index(net, d);
    return !(v.k == 0 && w.k == 2 && et_doublenet_adjacent(v, w));
}

/* Adjacency does not ask which class comes first, and every class is adjacent to itself. */
/*@ assigns \nothing;
    ensures symmetric: \result == 1;
*/
int theorem_adjacent(et_index v, et_index w)
{
    return et_doublenet_adjacent(v, w) == et_doublenet_adjacent(w, v) && et_doublenet_adjacent(v, v);
}
