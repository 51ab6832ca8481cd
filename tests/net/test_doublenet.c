#include "etalon/net/doublenet.h"
#include "gen.h"
#include "golden.h"

/* The net by brute force: every node's index vector from the definition, and classes numbered by walking the bottom view, then the top's nodes
 * that are new, i outer, j inner. */
enum { SIDE = 12, LONG = 50, NODES = 2 * LONG * LONG };

typedef struct {
    size_t nodes, classes;
    size_t number[2][LONG][LONG]; /* of node (view, i, j) */
    et_index vector[NODES];       /* of class c at c - 1 */
} brute;

static size_t level(et_doublenet net, size_t view, size_t i, size_t j)
{
    const bool inside = 0 < i && i + 1 < net.nx && 0 < j && j + 1 < net.ny;

    return inside ? 2 * view : 1;
}

static void enumerate(brute *b, et_doublenet net)
{
    b->nodes = b->classes = 0;
    for (size_t view = 0; view < 2; view++)
        for (size_t i = 0; i < net.nx; i++)
            for (size_t j = 0; j < net.ny; j++) {
                const et_index v = {i, j, level(net, view, i, j)};
                size_t c = 0;

                if (view == 1) /* only then can the vector have been seen, at the same place of the bottom */
                    c = v.k == 1 ? b->number[0][i][j] : 0;
                if (c == 0) {
                    b->vector[b->classes++] = v;
                    c = b->classes;
                }
                b->number[view][i][j] = c;
                b->nodes++;
            }
}

/* Vectors all different: by comparison of all pairs, for small nets only. */
static bool distinct(const brute *b)
{
    for (size_t c = 0; c < b->classes; c++)
        for (size_t d = 0; d < c; d++)
            if (b->vector[c].i == b->vector[d].i && b->vector[c].j == b->vector[d].j && b->vector[c].k == b->vector[d].k)
                return false;
    return true;
}

static et_doublenet small_net(gen *g)
{
    et_doublenet net = {gen_between(g, 2, SIDE), gen_between(g, 2, SIDE)};

    if (gen_chance(g, 8)) { /* long and thin */
        net.nx = gen_chance(g, 2) ? 2 : LONG;
        net.ny = net.nx == 2 ? LONG : 2;
        gen_label(g, "long and thin");
    }
    if (net.nx == 2 || net.ny == 2)
        gen_label(g, "no interior");
    return net;
}

/* Any net up to the greatest that is valid. */
static et_doublenet large_net(gen *g)
{
    const size_t a = gen_between(g, 2, 40), most = SIZE_MAX / 2 / a, b = gen_chance(g, 2) ? most - gen_upto(g, 3) : gen_between(g, 2, most);
    et_doublenet net = {a, b};

    if (gen_chance(g, 2)) {
        net.nx = b;
        net.ny = a;
    }
    return net;
}

static bool same(et_index a, et_index b)
{
    return a.i == b.i && a.j == b.j && a.k == b.k;
}

/* a * b > SIZE_MAX, by halves. */
static bool too_big(size_t a, size_t b)
{
    const unsigned half = sizeof(size_t) * 4;
    const size_t mask = ((size_t)1 << half) - 1, ah = a >> half, al = a & mask, bh = b >> half, bl = b & mask;
    const size_t middle = (al * bl >> half) + (ah * bl & mask) + (al * bh & mask);

    return (ah && bh) || (ah * bl) >> half || (al * bh) >> half || middle >> half;
}

verdict prop_doublenet_valid(gen *g);
verdict prop_doublenet_valid(gen *g)
{
    static const size_t edge[] = {0, 1, 2, 3, SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 2 + 1, SIZE_MAX / 4, SIZE_MAX / 4 + 1};
    et_doublenet net = {edge[gen_upto(g, 8)], edge[gen_upto(g, 8)]};
    bool ok;

    if (gen_chance(g, 2)) { /* close to the limit of one side */
        net.nx = gen_between(g, 2, gen_chance(g, 2) ? 1000 : SIZE_MAX / 4);
        net.ny = SIZE_MAX / 2 / net.nx + gen_upto(g, 2);
        if (gen_chance(g, 2))
            net = (et_doublenet){net.ny, net.nx};
    }
    ok = net.nx >= 2 && net.ny >= 2 && net.nx <= SIZE_MAX / 2 && !too_big(2 * net.nx, net.ny);
    return gen_check(g, et_doublenet_valid(net) == (ok ? 1 : 0), "%zu x %zu is %svalid", net.nx, net.ny, ok ? "" : "not ") ? PASS : FAIL;
}

verdict prop_doublenet_non(gen *g);
verdict prop_doublenet_non(gen *g)
{
    static brute b;
    const et_doublenet net = small_net(g);

    enumerate(&b, net);
    return gen_check(g, et_doublenet_non(net) == b.nodes, "%zu x %zu has %zu nodes", net.nx, net.ny, b.nodes) ? PASS : FAIL;
}

verdict prop_doublenet_nov(gen *g);
verdict prop_doublenet_nov(gen *g)
{
    static brute b;
    const et_doublenet net = small_net(g);

    enumerate(&b, net);
    if (!gen_check(g, net.nx * net.ny > 150 || distinct(&b), "the test's own numbering repeats a vector"))
        return FAIL;
    return gen_check(g, et_doublenet_nov(net) == b.classes, "%zu x %zu has %zu classes", net.nx, net.ny, b.classes) ? PASS : FAIL;
}

verdict prop_doublenet_nor(gen *g);
verdict prop_doublenet_nor(gen *g)
{
    static brute b;
    const et_doublenet net = small_net(g), big = large_net(g);
    size_t shared = 0;

    enumerate(&b, net);
    for (size_t c = 0; c < b.classes; c++)
        shared += b.vector[c].k == 1;
    if (!gen_check(g, et_doublenet_nor(net) == shared && shared == b.nodes - b.classes, "%zu x %zu shares %zu", net.nx, net.ny, shared))
        return FAIL;
    return gen_check(g, et_doublenet_nov(big) + et_doublenet_nor(big) == et_doublenet_non(big) && et_doublenet_nov(big) <= et_doublenet_non(big),
                     "%zu x %zu: NOV + NOR = NON", big.nx, big.ny)
               ? PASS
               : FAIL;
}

verdict prop_doublenet_class(gen *g);
verdict prop_doublenet_class(gen *g)
{
    static brute b;
    const et_doublenet net = small_net(g);

    enumerate(&b, net);
    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++)
        for (size_t i = 0; i < net.nx; i++)
            for (size_t j = 0; j < net.ny; j++)
                if (!gen_check(g, et_doublenet_class(net, view, i, j) == b.number[view][i][j], "%zu x %zu: node (%zu,%zu,%zu) is of class %zu",
                               net.nx, net.ny, view, i, j, b.number[view][i][j]))
                    return FAIL;
    return PASS;
}

verdict prop_doublenet_index(gen *g);
verdict prop_doublenet_index(gen *g)
{
    static brute b;
    const et_doublenet net = small_net(g);

    enumerate(&b, net);
    for (size_t c = 1; c <= b.classes; c++)
        if (!gen_check(g, same(et_doublenet_index(net, c), b.vector[c - 1]), "%zu x %zu: class %zu", net.nx, net.ny, c))
            return FAIL;
    return PASS;
}

/* There and back on nets of any size, also the greatest. */
verdict prop_doublenet_index_large(gen *g);
verdict prop_doublenet_index_large(gen *g)
{
    const et_doublenet net = large_net(g);
    const size_t nov = et_doublenet_nov(net), c = gen_chance(g, 2) ? nov - gen_upto(g, 3) : gen_between(g, 1, nov);
    const et_index v = et_doublenet_index(net, c);
    const size_t view = v.k == 2 ? ET_TOP : ET_BOTTOM;

    if (!gen_check(g, v.i < net.nx && v.j < net.ny && v.k == level(net, view, v.i, v.j), "the vector of class %zu is one of the net", c))
        return FAIL;
    if (!gen_check(g, et_doublenet_class(net, view, v.i, v.j) == c, "class %zu and back", c))
        return FAIL;
    return gen_check(g, v.k != 1 || et_doublenet_class(net, ET_TOP, v.i, v.j) == c, "class %zu seen from the top", c) ? PASS : FAIL;
}

verdict prop_doublenet_corners(gen *g);
verdict prop_doublenet_corners(gen *g)
{
    const et_doublenet net = gen_chance(g, 3) ? large_net(g) : small_net(g);
    size_t c[6] = {0, 0, 0, 0, 77, 78};
    const size_t at[4][2] = {{0, 0}, {0, net.ny - 1}, {net.nx - 1, 0}, {net.nx - 1, net.ny - 1}};

    et_doublenet_corners(c, net);
    for (size_t k = 0; k < 4; k++)
        for (size_t view = 0; view < 2; view++)
            if (!gen_check(g, c[k] == et_doublenet_class(net, view, at[k][0], at[k][1]), "%zu x %zu: corner %zu", net.nx, net.ny, k))
                return FAIL;
    return gen_check(g, c[4] == 77 && c[5] == 78, "four numbers are written") ? PASS : FAIL;
}

/* A closed walk along the border: every class of it once, each step to a neighbour, first along j. */
verdict prop_doublenet_seam(gen *g);
verdict prop_doublenet_seam(gen *g)
{
    static size_t c[4 * LONG + 1];
    static bool seen[LONG * LONG + 1];
    const et_doublenet net = small_net(g);
    const size_t nor = et_doublenet_nor(net);

    for (size_t k = 0; k <= net.nx * net.ny; k++)
        seen[k] = false;
    c[nor] = 77;
    et_doublenet_seam(c, nor, net);
    if (!gen_check(g, c[nor] == 77 && c[0] == 1 && c[1] == 2 && c[nor - 1] == net.ny + 1, "%zu x %zu: both ends", net.nx, net.ny))
        return FAIL;
    for (size_t s = 0; s < nor; s++) {
        const size_t next = c[(s + 1) % nor];

        if (!gen_check(g, 1 <= c[s] && c[s] <= net.nx * net.ny && !seen[c[s]], "place %zu: class %zu is once on the border", s, c[s]))
            return FAIL;
        seen[c[s]] = true;
        const size_t i = (c[s] - 1) / net.ny, j = (c[s] - 1) % net.ny, ni = (next - 1) / net.ny, nj = (next - 1) % net.ny;
        const size_t step = (i > ni ? i - ni : ni - i) + (j > nj ? j - nj : nj - j);
        if (!gen_check(g, level(net, 0, i, j) == 1 && step == 1, "from class %zu to %zu is a step along the border", c[s], next))
            return FAIL;
    }
    return PASS;
}

static et_index any_index(gen *g, size_t most)
{
    return (et_index){gen_upto(g, most), gen_upto(g, most), gen_upto(g, 2)};
}

/* In signed integers, where differences need no care. */
verdict prop_doublenet_dist2(gen *g);
verdict prop_doublenet_dist2(gen *g)
{
    const size_t most = gen_chance(g, 2) ? (size_t)1 << 30 : 8;
    const et_index a = any_index(g, most), b = any_index(g, most);
    const long long i = (long long)a.i - (long long)b.i, j = (long long)a.j - (long long)b.j, k = (long long)a.k - (long long)b.k;
    const size_t want = (size_t)(i * i + j * j + k * k);

    return gen_check(g, et_doublenet_dist2(a, b) == want && et_doublenet_dist2(b, a) == want, "dist^2 = %zu", want) ? PASS : FAIL;
}

verdict prop_doublenet_adjacent(gen *g);
verdict prop_doublenet_adjacent(gen *g)
{
    const et_index a = any_index(g, 3), b = any_index(g, 3);
    const int i = (int)a.i - (int)b.i, j = (int)a.j - (int)b.j, k = (int)a.k - (int)b.k;
    const int want = i * i + j * j <= 1 && k * k <= 1;
    const et_index far = {gen_chance(g, 2) ? SIZE_MAX : 2 + a.i, a.j, a.k}, wide = {a.i, gen_chance(g, 2) ? SIZE_MAX : 2 + a.j, a.k};

    if (!gen_check(g, et_doublenet_adjacent(a, b) == want && et_doublenet_adjacent(b, a) == want, "(%zu,%zu,%zu), (%zu,%zu,%zu): %d", a.i, a.j, a.k,
                   b.i, b.j, b.k, want))
        return FAIL;
    /* Distances whose sum is 2^64 or 2^64 + 1. */
    const et_index edge = {0, a.j, a.k}, around = {SIZE_MAX, a.j + gen_between(g, 1, 2), a.k};
    const et_index side = {a.i, 0, a.k}, behind = {a.i + gen_between(g, 1, 2), SIZE_MAX, a.k};
    if (!gen_check(g, !et_doublenet_adjacent(edge, around) && !et_doublenet_adjacent(behind, side), "a sum that wraps"))
        return FAIL;
    return gen_check(g, !et_doublenet_adjacent(a, far) && !et_doublenet_adjacent(wide, a) && et_doublenet_adjacent(a, a), "far and itself") ? PASS
                                                                                                                                            : FAIL;
}

static et_doublenet row_net(const row *r)
{
    return (et_doublenet){row_size(r, 0), row_size(r, 1)};
}

verdict gold_doublenet_valid(const row *r);
verdict gold_doublenet_valid(const row *r)
{
    return row_is_size(r, 0, (size_t)et_doublenet_valid(row_net(r))) ? PASS : FAIL;
}

verdict gold_doublenet_non(const row *r);
verdict gold_doublenet_non(const row *r)
{
    return row_is_size(r, 0, et_doublenet_non(row_net(r))) ? PASS : FAIL;
}

verdict gold_doublenet_nov(const row *r);
verdict gold_doublenet_nov(const row *r)
{
    return row_is_size(r, 0, et_doublenet_nov(row_net(r))) ? PASS : FAIL;
}

verdict gold_doublenet_nor(const row *r);
verdict gold_doublenet_nor(const row *r)
{
    return row_is_size(r, 0, et_doublenet_nor(row_net(r))) ? PASS : FAIL;
}

verdict gold_doublenet_class(const row *r);
verdict gold_doublenet_class(const row *r)
{
    return row_is_size(r, 0, et_doublenet_class(row_net(r), row_size(r, 2), row_size(r, 3), row_size(r, 4))) ? PASS : FAIL;
}

verdict gold_doublenet_index(const row *r);
verdict gold_doublenet_index(const row *r)
{
    const et_index v = et_doublenet_index(row_net(r), row_size(r, 2));
    const bool i = row_is_size(r, 0, v.i), j = row_is_size(r, 1, v.j), k = row_is_size(r, 2, v.k);

    return i && j && k ? PASS : FAIL;
}

verdict gold_doublenet_corners(const row *r);
verdict gold_doublenet_corners(const row *r)
{
    size_t c[4];
    bool ok = true;

    et_doublenet_corners(c, row_net(r));
    for (size_t k = 0; k < 4; k++)
        ok = row_is_size(r, k, c[k]) && ok;
    return ok ? PASS : FAIL;
}

verdict gold_doublenet_seam(const row *r);
verdict gold_doublenet_seam(const row *r)
{
    size_t c[4 * LONG];
    const size_t nor = et_doublenet_nor(row_net(r));
    bool ok = nor == r->nwant;

    et_doublenet_seam(c, nor, row_net(r));
    for (size_t k = 0; k < nor && ok; k++)
        ok = row_is_size(r, k, c[k]);
    return ok ? PASS : FAIL;
}

static et_index row_index(const row *r, size_t at)
{
    return (et_index){row_size(r, at), row_size(r, at + 1), row_size(r, at + 2)};
}

verdict gold_doublenet_dist2(const row *r);
verdict gold_doublenet_dist2(const row *r)
{
    return row_is_size(r, 0, et_doublenet_dist2(row_index(r, 0), row_index(r, 3))) ? PASS : FAIL;
}

verdict gold_doublenet_adjacent(const row *r);
verdict gold_doublenet_adjacent(const row *r)
{
    return row_is_size(r, 0, (size_t)et_doublenet_adjacent(row_index(r, 0), row_index(r, 3))) ? PASS : FAIL;
}
