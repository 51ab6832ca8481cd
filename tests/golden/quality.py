#!/usr/bin/env python3
"""Golden rows of quality: rational arithmetic on points whose distances to their winners are rational, so that every number is exact.

Usage: quality.py > golden/quality.tsv
"""
import random
from fractions import Fraction
from math import isqrt


def classes(nx, ny):
    border = lambda i, j: i in (0, nx - 1) or j in (0, ny - 1)
    bottom = [(i, j, 1 if border(i, j) else 0) for i in range(nx) for j in range(ny)]
    return bottom + [(i, j, 2) for i in range(nx) for j in range(ny) if not border(i, j)]


def root(q):
    a, b = isqrt(q.numerator), isqrt(q.denominator)
    assert a * a == q.numerator and b * b == q.denominator, q
    return Fraction(a, b)


def quality(nx, ny, weights, cloud):
    net, errors, apart = classes(nx, ny), [], 0
    for p in cloud:
        d2 = [sum((Fraction(a) - Fraction(b)) ** 2 for a, b in zip(p, w)) for w in weights]
        order = sorted(range(len(net)), key=lambda c: (d2[c], c))
        u, v = net[order[0]], net[order[1]]
        errors.append(root(d2[order[0]]))
        apart += (u[0] - v[0]) ** 2 + (u[1] - v[1]) ** 2 > 1 or abs(u[2] - v[2]) > 1
    n = len(cloud)
    return [float(x) for x in (sum(errors) / n, Fraction(apart, n), min(errors), max(errors))]


def row(reason, nx, ny, weights, cloud):
    assert len(weights) == len(classes(nx, ny))
    args = [str(nx), str(ny)] + [float(x).hex() for p in weights + cloud for x in p]
    print("quality_of", "exact", reason, " ".join(args), " ".join(x.hex() for x in quality(nx, ny, weights, cloud)), sep="\t")


SQUARE = [(0, 0, 0), (0, 4, 0), (4, 0, 0), (4, 4, 0)]
print("# function\tclass\treason\tnx ny, weights, points\tqe te least greatest")
print("# made by tests/golden/quality.py in rational arithmetic")
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
draw = random.Random(1)
for nx, ny in ((2, 2), (2, 6), (3, 3), (4, 5), (5, 4), (6, 6), (7, 5)):
    n = len(classes(nx, ny))
    weights = [(draw.randrange(64), draw.randrange(64), 0) for _ in range(n)]
    for reason, count in (("points above the weights", 4), ("many points above the weights", 16)):
        cloud = []
        for _ in range(count):            # straight above a weight and no farther from it than that is from the plane: its winner is that weight
            x, y, _z = weights[draw.randrange(n)]
            cloud.append((x, y, draw.randrange(64) / 8))
        row("%s, %d x %d" % (reason, nx, ny), nx, ny, weights, cloud)
