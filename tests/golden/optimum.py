#!/usr/bin/env python3
"""golden/optimum.tsv: least sums of distances known in closed form, or by Newton's method in long decimals.  python3 tests/golden/optimum.py > golden/optimum.tsv

Where parameters repeat, data share a surface point, and bilinear patches over parameters 0 and 1 only have no others but their corners: the least sum is that of
a geometric median for each corner: of points on a line the middle one, of three Fermat's point, of the vertices of a regular polygon its centre, of four in a plane
the crossing of the diagonals, else by Weiszfeld's steps in 50 decimals, sped up by Newton's.  Rows `gap T`: half of the gap allowed, 1e-11 of the value.
"""
from decimal import Decimal as D, getcontext

from rational import Choices, show

getcontext().prec = 50
RELATIVE = D(10) ** -11


def distance(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b)).sqrt()


def total(points, x):
    return sum(distance(p, x) for p in points)


def vertex(points):
    """The datum that is a median, if one is: the unit vectors to the others add up to no more than its multiplicity."""
    for p in points:
        pull = [D(0)] * 3
        here = 0
        for q in points:
            d = distance(p, q)
            if d == 0:
                here += 1
            else:
                pull = [a + (y - x) / d for a, x, y in zip(pull, p, q)]
        if sum(a * a for a in pull) <= here * here:
            return p
    return None


def solve(m, b):
    """3 x 3, by elimination with pivots."""
    a = [row[:] + [c] for row, c in zip(m, b)]
    for k in range(3):
        best = max(range(k, 3), key=lambda i: abs(a[i][k]))
        a[k], a[best] = a[best], a[k]
        for i in range(k + 1, 3):
            f = a[i][k] / a[k][k]
            a[i] = [x - f * y for x, y in zip(a[i], a[k])]
    x = [D(0)] * 3
    for k in (2, 1, 0):
        x[k] = (a[k][3] - sum(a[k][j] * x[j] for j in range(k + 1, 3))) / a[k][k]
    return x


def median(points):
    """The least sum of distances.  Newton's steps from the mean, halved while they lead upwards."""
    at = vertex(points)
    if at:
        return total(points, at)
    x = [sum(p[d] for p in points) / len(points) for d in range(3)]
    for _ in range(200):
        grad, hess = [D(0)] * 3, [[D(0)] * 3 for _ in range(3)]
        for p in points:
            d = distance(p, x)
            e = [(b - a) / d for a, b in zip(p, x)]
            for i in range(3):
                grad[i] += e[i]
                for j in range(3):
                    hess[i][j] += ((i == j) - e[i] * e[j]) / d
        if sum(g * g for g in grad) < D(10) ** -60:
            break
        step, here, f = solve(hess, grad), total(points, x), D(1)
        while f > D(10) ** -30 and total(points, [a - f * s for a, s in zip(x, step)]) > here:
            f /= 2
        x = [a - f * s for a, s in zip(x, step)]
    return total(points, x)


def line(points):
    s = sorted(points)
    return total(points, s[len(s) // 2])


def number(nx, ny, view, i, j):
    return nx * ny + (i - 1) * (ny - 2) + j - 1 if view and 0 < i < nx - 1 and 0 < j < ny - 1 else i * ny + j


def classes(nx, ny):
    return [(0, i, j) for i in range(nx) for j in range(ny)] + [(1, i, j) for i in range(1, nx - 1) for j in range(1, ny - 1)]


def arguments(s, r, data):
    knots = [0.0, 0.0, 1.0, 1.0]
    reals = knots + knots + s + r + [float(c) for p in data for c in p]
    return "1 1 2 2 %d %d " % (len(s), len(r)) + " ".join(show(x) for x in reals)


def emit(function, reason, args, value):
    bound = float(value * RELATIVE) if value else 2.0**-60
    print("\t".join([function, "gap " + show(bound), reason, args, show(float(value))]))


def corners(reason, s, r, data, of=median):
    """Every corner by itself."""
    groups = {}
    for (view, i, j), p in zip(classes(len(s), len(r)), data):
        groups.setdefault((s[i], r[j]), []).append([D(c) for c in p])
    emit("optimum_find", reason, arguments(s, r, data), sum(of(g) for g in groups.values()))


def pair(reason, data, y, value):
    emit("optimum_bound", reason, arguments([0.0, 0.0, 1.0], [0.0, 1.0], data) + " " + " ".join(show(float(c)) for p in y for c in p), D(value))


print("# optimum: least sums of distances, and bounds that a dual proves")
print("# Written by tests/golden/optimum.py from closed forms and long decimals; not from Etalon.")
print("# function\tclass\treason\tp q nu nv nx ny, knots u v, parameters s r, data, for a bound y\twanted")
c = Choices(20)
whole = lambda k: [float(c.upto(k)) for _ in range(3)]
Z = [0.0, 0.0, 0.0]
corners("interpolated", [0.0, 1.0], [0.0, 1.0], [whole(8) for _ in range(4)])
corners("all points equal", [0.0, 0.0, 1.0], [0.0, 1.0], [[3.0, 4.0, 5.0]] * 6)
for n in range(2, 8):
    corners("points on a line, %d" % n, [0.0] * n + [1.0], [0.0, 1.0], [[float(c.upto(64)), 0.0, 0.0] for _ in range(2 * n + 2)], line)
    corners("points on a slanting line, %d" % n, [0.0] * n + [1.0], [0.0, 1.0],
            [[float(k), 2.0 * k, -2.0 * k] for k in (c.upto(64) for _ in range(2 * n + 2))], line)
for a in (1.0, 3.0, 0.25, 2.0**-200, 2.0**200):
    corners("right angle, %s" % show(a), [0.0, 0.0, 0.0, 1.0], [0.0, 1.0], [[a, 0.0, 0.0], Z, [0.0, a, 0.0], Z, Z, Z, Z, Z])
    corners("an obtuse angle: its vertex, %s" % show(a), [0.0, 0.0, 0.0, 1.0], [0.0, 1.0], [[a, 0.0, 0.0], Z, [-a, a / 4, 0.0], Z, Z, Z, Z, Z])
corners("square", [0.0] * 4 + [1.0], [0.0, 1.0], [[1.0, 0.0, 0.0], Z, [0.0, 1.0, 0.0], Z, [-1.0, 0.0, 0.0], Z, [0.0, -1.0, 0.0], Z, Z, Z])
corners("octahedron", [0.0] * 6 + [1.0], [0.0, 1.0], [[1.0, 0.0, 0.0], Z, [0.0, 1.0, 0.0], Z, [-1.0, 0.0, 0.0], Z, [0.0, -1.0, 0.0], Z,
                                                    [0.0, 0.0, 1.0], Z, [0.0, 0.0, -1.0], Z, Z, Z])
for n in (3, 4, 5, 6):
    for k in range(3):
        corners("medians of %d in space" % n, [0.0] * n + [1.0], [0.0, 1.0], [whole(64) for _ in range(2 * n + 2)])
for s, r in (([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]), ([0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 1.0, 1.0]), ([0.0, 0.0, 0.0, 1.0], [0.0, 1.0, 1.0])):
    for k in range(4):
        corners("both views at a corner, %d x %d" % (len(s), len(r)), s, r, [whole(64) for _ in classes(len(s), len(r))])
for b in (1.0, 4.0, 1024.0, 2.0**-30):
    d = [Z, Z, [b, 0.0, 0.0], Z, Z, Z]
    pair("two points, the best dual", d, [[-1, 0, 0], Z, [1, 0, 0], Z, Z, Z], b)
    pair("two points, half of it", d, [[-0.5, 0, 0], Z, [0.5, 0, 0], Z, Z, Z], b)
    pair("two points, a dual aslant: 3/5 of it", d, [[-3, -4, 0], Z, [3, 4, 0], Z, Z, Z], D(b) * 3 / 5)
    pair("two points, a dual that is not balanced", d, [[-1, 0, 0], Z, [3, 0, 0], Z, Z, Z], b)
    pair("two points, the wrong way round", d, [[1, 0, 0], Z, [-1, 0, 0], Z, Z, Z], 0)
    pair("no dual", d, [Z] * 6, 0)
    pair("a dual that projects to nothing", d, [Z, [1, 0, 0], Z, Z, [0, 1, 0], [0, 0, 1]], 0)
