#!/usr/bin/env python3
"""golden/quality.tsv: winners by squared distances in rationals, ties to the lowest class; the mean and the extremes rounded once.

Rows `exact`: every distance is rational and short.  Else a distance is within 3.5u of its own, the mean's sum within (18 + log2 n) u, the quotient
half an ulp, the wanted value another: (24 + log2 n) u of the greatest.  A row is only written where no two classes compete within rounding.
"""
from fractions import Fraction as F

from rational import Choices, bound_of, decided, nearest, root, show

U = F(1, 2**53)


def classes(nx, ny):
    border = lambda i, j: i in (0, nx - 1) or j in (0, ny - 1)
    bottom = [(i, j, 1 if border(i, j) else 0) for i in range(nx) for j in range(ny)]
    return bottom + [(i, j, 2) for i in range(nx) for j in range(ny) if not border(i, j)]


def quality(nx, ny, weights, cloud):
    """qe, te, least, greatest; whether all roots are rational; whether rounding could change a winner."""
    net, squares, apart, close = classes(nx, ny), [], 0, False
    W = [[F(x) for x in w] for w in weights]
    for p in cloud:
        P = [F(x) for x in p]
        d2 = [sum((a - b) ** 2 for a, b in zip(P, w)) for w in W]
        order = sorted(range(len(net)), key=lambda c: (d2[c], c))
        u, v = net[order[0]], net[order[1]]
        squares.append(d2[order[0]])
        for a, b in zip(order[:2], order[1:3]):
            close = close or 0 < d2[b] - d2[a] < d2[b] / 2**40
        apart += (u[0] - v[0]) ** 2 + (u[1] - v[1]) ** 2 > 1 or abs(u[2] - v[2]) > 1
    n = len(cloud)

    def mean(bits):
        parts = [root(q, 2, bits) for q in squares]
        low = sum(x if whole else x - F(1, 2**bits) for x, whole in parts)
        high = sum(x if whole else x + F(1, 2**bits) for x, whole in parts)
        return low / n, high / n

    least, greatest = (nearest(root(f(squares), 2, 120)[0]) for f in (min, max))
    rational = all(root(q)[1] for q in squares)
    return [decided(mean), nearest(F(apart, n)), least, greatest], rational, close


def row(reason, nx, ny, weights, cloud, exact=True):
    assert len(weights) == len(classes(nx, ny))
    want, rational, close = quality(nx, ny, weights, cloud)
    if not exact and close:
        return
    assert rational or not exact
    n = len(cloud)
    cls = "exact" if exact else "abs " + bound_of((24 + n.bit_length()) * U * F(want[3]) + F(1, 2**1074))
    args = [str(nx), str(ny)] + [show(float(x)) for p in weights + cloud for x in p]
    print("quality_of", cls, reason, " ".join(args), " ".join(show(x) for x in want), sep="\t")


def first():
    SQUARE = [(0, 0, 0), (0, 4, 0), (4, 0, 0), (4, 4, 0)]
    row("on a weight", 2, 2, SQUARE, [(0, 0, 0)])
    row("first and second adjacent", 2, 2, SQUARE, [(0, 1, 0)])
    row("tie of two: the lower wins, its neighbour is second", 2, 2, SQUARE, [(0, 2, 0)])
    row("tie of two: second by lowest class", 2, 2, SQUARE, [(0, 0, 3), (4, 4, 1)])
    row("tie of all: classes 1 and 2", 2, 2, [(1, 1, 1)] * 4, [(1, 1, 4), (4, 5, 1)])
    row("three coincide: classes 2 and 3 are opposite corners", 2, 2, [(9, 9, 9), (0, 0, 0), (0, 0, 0), (0, 0, 0)], [(3, 4, 0)])
    row("diagonal is not adjacent", 2, 2, [(0, 0, 0), (9, 9, 9), (8, 9, 9), (1, 0, 0)], [(0, 0, 0), (0.25, 0, 0)])
    row("bottom above top is not adjacent", 3, 3, [(9, 9, k) for k in range(4)] + [(0, 0, 0)] + [(9, 8, k) for k in range(4)] + [(1, 0, 0)],
        [(0, 0, 0), (1, 0, 0), (0, 0, 2)])
    row("centre and border are adjacent", 3, 3, [(9, 9, 0), (0, 1, 0)] + [(9, 9, k) for k in range(2)] + [(0, 0, 0)] + [(9, 8, k) for k in range(5)],
        [(0, 0, 0), (0, 3, 0)])
    row("top and border are adjacent", 3, 3, [(9, 9, k) for k in range(7)] + [(0, 1, 0), (9, 8, 8), (0, 0, 0)], [(0, 0, 0), (0, 1, 0)])
    row("last class wins, first is second", 3, 3, [(1, 0, 0)] + [(9, 9, k) for k in range(8)] + [(0, 0, 0)], [(0, 0, 0)])
    row("tiny", 2, 2, [tuple(x * 2.0**-400 for x in p) for p in SQUARE], [(0, 2.0**-400, 0), (2.0**-398, 0, 3 * 2.0**-400)])
    row("huge", 2, 2, [tuple(x * 2.0**490 for x in p) for p in SQUARE], [(0, 2.0**490, 0), (2.0**492, 0, 3 * 2.0**490)])


def above_weights(c):
    for nx, ny in ((2, 2), (2, 6), (3, 3), (4, 5), (5, 4), (6, 6), (7, 5)):
        n = len(classes(nx, ny))
        weights = [(c.upto(63), c.upto(63), 0) for _ in range(n)]
        for reason, count in (("points above the weights", 4), ("many points above the weights", 16)):
            cloud = []
            for _ in range(count):        # straight above a weight and no farther from it than that is from the plane: its winner is that weight
                x, y, _z = c.of(weights)
                cloud.append((x, y, c.upto(63) / 8))
            row("%s, %d x %d" % (reason, nx, ny), nx, ny, weights, cloud)


def drawn(c):
    kinds = [("random", lambda: c.real(-1, 1)), ("short", lambda: c.short(-4, 4)), ("extreme scale, offset", lambda: 1e9 + c.short(-1, 1)),
             ("extreme scale, 1e140", lambda: 1e140 * c.short(-1, 1)), ("extreme scale, 1e-140", lambda: 1e-140 * c.short(-1, 1)),
             ("coincident points", lambda: c.short(0, 1, 1))]
    for name, draw in kinds:
        for nx, ny in ((2, 2), (2, 3), (3, 3), (4, 3), (3, 4)):
            for count in (1, 2, 3, 5, 8, 13):
                weights, cloud = ([tuple(draw() for _ in range(3)) for _ in range(n)] for n in (len(classes(nx, ny)), count))
                row("%s, %d x %d" % (name, nx, ny), nx, ny, weights, cloud, False)


def main():
    print("# quality: how well a net stands for a cloud\n# Written by tests/golden/quality.py from exact arithmetic; not from Etalon.")
    print("# function\tclass\treason\tnx ny, weights, points\tqe te least greatest")
    c = Choices(37)
    first()
    above_weights(c)
    drawn(c)


main()
