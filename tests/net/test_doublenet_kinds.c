/* net/doublenet: the net with its sides exchanged. */
#include "etalon/net/doublenet.h"
#include "gen.h"

enum { SIDE = 12 };

/* As many nodes and classes; the corners between exchanged; the same nodes share a class; neighbours and distances stay. */
verdict prop_doublenet_class_exchanged(gen *g);
verdict prop_doublenet_class_exchanged(gen *g)
{
    const et_doublenet net = {gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)}, turned = {net.ny, net.nx};
    const size_t view = gen_upto(g, 1), i = gen_upto(g, net.nx - 1), j = gen_upto(g, net.ny - 1), k = gen_upto(g, net.nx - 1), l = gen_upto(g,
            net.ny - 1);
    const et_index a = et_doublenet_index(net, et_doublenet_class(net, view, i, j)), b = et_doublenet_index(net, et_doublenet_class(net, 1, k, l));
    const et_index c = et_doublenet_index(turned, et_doublenet_class(turned, view, j, i)), d = et_doublenet_index(turned, et_doublenet_class(turned,
            1, l, k));
    size_t corner[4], other[4];
    bool ok = gen_check(g, et_doublenet_valid(net) == et_doublenet_valid(turned) && et_doublenet_non(net) == et_doublenet_non(turned), "nodes");

    ok = ok && gen_check(g, et_doublenet_nov(net) == et_doublenet_nov(turned) && et_doublenet_nor(net) == et_doublenet_nor(turned), "classes");
    ok = ok && gen_check(g, a.i == c.j && a.j == c.i && a.k == c.k && b.i == d.j && b.j == d.i && b.k == d.k, "index vectors exchanged");
    ok = ok && gen_check(g, et_doublenet_dist2(a, b) == et_doublenet_dist2(c, d) && et_doublenet_adjacent(a, b) == et_doublenet_adjacent(c, d),
            "distances");
    et_doublenet_corners(corner, net);
    et_doublenet_corners(other, turned);
    for (size_t e = 0; ok && e < 4; e++) {
        const et_index x = et_doublenet_index(net, corner[e]), y = et_doublenet_index(turned, other[e == 1 ? 2 : e == 2 ? 1 : e]);
        ok = gen_check(g, x.i == y.j && x.j == y.i && x.k == y.k, "corner %zu", e);
    }
    return ok ? PASS : FAIL;
}

/* The walk round the border of the one is that of the other, the other way round. */
verdict prop_doublenet_seam_exchanged(gen *g);
verdict prop_doublenet_seam_exchanged(gen *g)
{
    const et_doublenet net = {gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)}, turned = {net.ny, net.nx};
    const size_t nor = et_doublenet_nor(net);
    size_t a[4 * SIDE], b[4 * SIDE];
    bool ok = true;

    et_doublenet_seam(a, nor, net);
    et_doublenet_seam(b, nor, turned);
    for (size_t s = 0; ok && s < nor; s++) {
        const et_index x = et_doublenet_index(net, a[s]), y = et_doublenet_index(turned, b[(nor - s) % nor]);
        ok = gen_check(g, x.i == y.j && x.j == y.i, "%zu x %zu: place %zu", net.nx, net.ny, s);
    }
    return ok ? PASS : FAIL;
}
