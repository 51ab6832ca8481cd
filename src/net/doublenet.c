#include "etalon/net/doublenet.h"

/*@ assigns \nothing;
    ensures value: \result == et_absdiff(a, b);
*/
static size_t distance(size_t a, size_t b)
{
    return a < b ? b - a : a - b;
}

/*@ requires net:  2 <= net.nx && 2 <= net.ny;
    assigns \nothing;
    ensures truth: \result == 0 || \result == 1;
    ensures value: \result == 1 <==> et_net_border(net.nx, net.ny, i, j);
*/
static int on_border(et_doublenet net, size_t i, size_t j)
{
    return i == 0 || i == net.nx - 1 || j == 0 || j == net.ny - 1;
}

int et_doublenet_valid(et_doublenet net)
{
    return net.nx >= 2 && net.ny >= 2 && net.nx <= SIZE_MAX / 2 / net.ny;
}

size_t et_doublenet_non(et_doublenet net)
{
    return 2 * net.nx * net.ny;
}

size_t et_doublenet_nov(et_doublenet net)
{
    return net.nx * net.ny + (net.nx - 2) * (net.ny - 2);
}

size_t et_doublenet_nor(et_doublenet net)
{
    return 2 * net.nx + 2 * (net.ny - 2);
}

size_t et_doublenet_class(et_doublenet net, size_t view, size_t i, size_t j)
{
    //@ ghost fact_product(i + 1, net.nx, net.ny);
    //@ ghost fact_product(0, net.nx - 2, net.ny - 2);
    if (view == ET_BOTTOM || on_border(net, i, j))
        return i * net.ny + j + 1;
    //@ ghost fact_product(0, i - 1, net.ny - 2);
    //@ ghost fact_product(i, net.nx - 2, net.ny - 2);
    return net.nx * net.ny + (i - 1) * (net.ny - 2) + (j - 1) + 1;
}

et_index et_doublenet_index(et_doublenet net, size_t c)
{
    const size_t bottom = net.nx * net.ny;
    et_index v;

    if (c <= bottom) {
        v.i = (c - 1) / net.ny;
        v.j = (c - 1) % net.ny;
        //@ assert parts: c - 1 == v.i*net.ny + v.j && v.j < net.ny;
        //@ ghost fact_quotient(v.i, v.j, net.nx, net.ny);
        v.k = on_border(net, v.i, v.j) ? 1 : 0;
    } else {
        //@ assert place: 0 <= c - 1 - bottom < (net.nx - 2)*(net.ny - 2);
        //@ assert inner: 0 < net.ny - 2;
        v.i = (c - 1 - bottom) / (net.ny - 2) + 1;
        v.j = (c - 1 - bottom) % (net.ny - 2) + 1;
        v.k = 2;
        //@ assert parts: c - 1 - bottom == (v.i - 1)*(net.ny - 2) + (v.j - 1) && 1 <= v.i && 1 <= v.j < net.ny - 1;
        //@ ghost fact_quotient((size_t)(v.i - 1), (size_t)(v.j - 1), (size_t)(net.nx - 2), (size_t)(net.ny - 2));
    }
    //@ assert vector: et_index_ok(net.nx, net.ny, v.i, v.j, v.k);
    //@ assert inverse: et_class_of(net.nx, net.ny, v.i, v.j, v.k) == c;
    //@ ghost size_t a = 0;
    /*@ ghost
      /@ loop invariant place:  a <= net.nx;
         loop invariant unique: \forall integer i, j, k; i < a && et_index_ok(net.nx, net.ny, i, j, k) && et_class_of(net.nx, net.ny, i, j, k) == c
                                    ==> i == v.i && j == v.j && k == v.k;
         loop assigns a;
         loop variant net.nx - a; @/
      while (a < net.nx) {
          fact_row(net.nx, net.ny, v.i, v.j, v.k, a);
          a++;
      }
    */
    return v;
}

void et_doublenet_corners(size_t c[4], et_doublenet net)
{
    c[0] = 1;
    c[1] = net.ny;
    c[2] = net.ny * (net.nx - 1) + 1;
    c[3] = net.nx * net.ny;
}

void et_doublenet_seam(size_t *c, size_t nor, et_doublenet net)
{
    size_t i = 0, j = 0;

    /*@ loop invariant place: 0 <= s <= nor;
        loop invariant node:  i == et_seam_i(net.nx, net.ny, s) && j == et_seam_j(net.nx, net.ny, s);
        loop invariant value: \forall integer t; 0 <= t < s ==> c[t] == et_seam_class(net.nx, net.ny, t);
        loop invariant range: \forall integer t; 0 <= t < s ==> 1 <= c[t] <= net.nx*net.ny;
        loop invariant once:  \forall integer t, q; 0 <= t < q < s ==> c[t] != c[q];
        loop assigns s, i, j, c[0 .. nor - 1];
        loop variant nor - s;
    */
    for (size_t s = 0; s < nor; s++) {
        //@ ghost fact_product(i + 1, net.nx, net.ny);
        //@ ghost size_t q = 0;
        /*@ ghost
          /@ loop invariant place: q <= s;
             loop invariant other: \forall integer t; 0 <= t < q ==> et_seam_class(net.nx, net.ny, t) != et_seam_class(net.nx, net.ny, s);
             loop assigns q;
             loop variant s - q; @/
          while (q < s) {
              fact_seam(net.nx, net.ny, q, s);
              q++;
          }
        */
        c[s] = i * net.ny + j + 1;
        if (i == 0 && j < net.ny - 1)
            j++;
        else if (j == net.ny - 1 && i < net.nx - 1)
            i++;
        else if (i == net.nx - 1 && j > 0)
            j--;
        else
            i--;
    }
}

size_t et_doublenet_dist2(et_index a, et_index b)
{
    const size_t i = distance(a.i, b.i), j = distance(a.j, b.j), k = distance(a.k, b.k);

    return i * i + j * j + k * k;
}

int et_doublenet_adjacent(et_index a, et_index b)
{
    const size_t i = distance(a.i, b.i), j = distance(a.j, b.j);

    /* each side first, so that the sum cannot wrap */
    return i <= 1 && j <= 1 && i + j <= 1 && distance(a.k, b.k) <= 1;
}
