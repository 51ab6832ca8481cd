#!/usr/bin/env python3
"""golden/param.tsv: parameters of points, from rational distances or from roots enclosed as narrowly as their rounding needs (lines.py).

Bounds: chord (2n + 6) u; the powers cost a root's half ulp or a few more, each step once; half an ulp for the wanted value: (2n + 32) u in all.
"""
from fractions import Fraction as F

from lines import CHORD, UNIFORM, Line, grid
from rational import Choices, bound_of, nearest, show

U = F(1, 2**53)
METHODS = {"uniform": 0, "chord": 1, "centripetal": 2, "exponential": 3}


def row(reason, method, points, whole=False):
    """whole: short sums of whole numbers, so that the only rounding is the quotient's."""
    m = METHODS[method]
    line = Line(points, m)
    exact = line.flat or m == UNIFORM or (m == CHORD and whole and line.exact())
    cls = "exact" if exact else "abs " + bound_of((2 * len(points) + 32) * U)
    args = " ".join([str(m), str(len(points))] + [show(float(c)) for p in points for c in p])
    print("param_row", cls, reason, args, " ".join([str(line.flat)] + [show(x) for x in line.parameters()]), sep="\t")


def grid_row(reason, method, rows):
    m = METHODS[method]
    nx, ny = len(rows), len(rows[0])
    flat, s, r = grid(rows, m)
    args = [str(m), str(nx), str(ny)] + [show(float(c)) for line in rows for p in line for c in p]
    want = " ".join([str(flat)] + [show(x) for x in s + r])
    print("param_grid", "abs " + bound_of((2 * max(nx, ny) + 34) * U), reason, " ".join(args), want, sep="\t")


def status(reason, method, nx, ny, want):
    print("param_grid_status", "exact", reason, "%d %d %d" % (method, nx, ny), want, sep="\t")


def standardise(reason, a, b):
    want = " ".join(show(nearest((F(x) + F(y)) / 2)) for x, y in zip(a, b))
    print("param_standardise", "exact", reason, " ".join([str(len(a))] + [show(x) for x in a + b]), want, sep="\t")


def first():
    triples = [(0, 0, 0), (3, 4, 0), (3, 4, 12), (11, 8, 11), (11, 8, 11), (11, 20, 16)]
    line = [(0, 0, 0), (1, 0, 0), (3, 0, 0), (6, 0, 0), (10, 0, 0)]
    same = [(0.5, -1, 2)] * 4
    ends = [(0, 0, 0), (0, 0, 0), (2, 3, 6), (2, 3, 6)]
    general = [(0, 0, 0), (1, 2, 3), (0.1, -0.7, 2.5), (4, 4, 4), (4, 4, 4.0000001)]
    huge = [(-1.5e308, 0, 0), (1.5e308, 0, 0), (1.5e308, 1.5e308, 0)]
    tiny = [(0, 0, 0), (3 * 2.0**-1074, 4 * 2.0**-1074, 0), (3 * 2.0**-1074, 4 * 2.0**-1074, 12 * 2.0**-1074)]
    far = [(1e15, 0, 0), (1e15 + 1, 0, 0), (1e15 + 3, 0, 0)]
    small = [tuple(c * 2.0**-600 for c in p) for p in triples]
    large = [tuple(c * 2.0**900 for c in p) for p in triples]
    for name, points in [("pythagorean", triples), ("line", line), ("coincident points, all", same), ("coincident points, ends", ends),
                         ("two points", triples[:2]), ("coincident points, two", same[:2]), ("general", general), ("extreme scale, huge", huge),
                         ("extreme scale, subnormal", tiny), ("extreme scale, offset", far), ("extreme scale, squares vanish", small),
                         ("extreme scale, squares overflow", large), ("backwards", triples[::-1]), ("back and forth", line + line[::-1])]:
        for method in METHODS:
            row(name, method, points, name != "general")
    lattice = [[(x, y, 0) for y in (0, 1, 4, 6)] for x in (0, 3, 4, 9, 12)]
    hill = [[(x, y, 3 * (x % 2) * (y % 2)) for y in range(4)] for x in range(3)]
    pinch = [[(x, y, 0) if y else (0, 0, 0) for y in range(3)] for x in range(4)]
    point = [[(1, 2, 3)] * 3 for _ in range(2)]
    for name, rows in [("lattice", lattice), ("hill", hill), ("degenerate geometry, pole", pinch), ("coincident points, all", point),
                       ("smallest", [r[:2] for r in lattice[:2]])]:
        for method in METHODS:
            grid_row(name, method, rows)
    standardise("ends", [0.0, 1.0], [0.0, 1.0])
    standardise("halves", [0.0, 0.25, 1.0], [0.0, 0.75, 1.0])
    standardise("rounded", [0.0, 0.1, 0.3, 1.0], [0.0, 0.2, 0.7, 1.0])
    standardise("ulps", [0.0, 0.5, 1.0], [0.0, 0.5 + 2.0**-53, 1.0])
    standardise("subnormal", [0.0, 2.0**-1074, 1.0], [0.0, 3 * 2.0**-1074, 1.0])


def drawn(c):
    """(category, a draw of one coordinate)"""
    return [("random", lambda: c.real(-1, 1)), ("short", lambda: c.short(-4, 4)), ("extreme scale, offset", lambda: 1e9 + c.short(-1, 1)),
            ("extreme scale, 1e307", lambda: 1e307 * c.short(-1, 1)), ("extreme scale, 1e-160", lambda: 1e-160 * c.short(-1, 1)),
            ("extreme scale, 1e160", lambda: 1e160 * c.short(-1, 1)), ("extreme scale, subnormal", lambda: 5e-324 * c.upto(99)),
            ("extreme scale, mixed", lambda: 10.0 ** (c.upto(16) - 8) * c.short(-1, 1))]


def lines(c):
    for name, draw in drawn(c):
        for k in range(10):
            n = (2, 3, 4, 5, 7, 9)[k % 6]
            points = [tuple(draw() for _ in range(3)) for _ in range(n)]
            if k > 6:
                i = c.upto(n - 2)
                points[i + 1] = points[i]
            for method in list(METHODS)[k % 2:]:
                row(name + (", coincident points" if k > 6 else ""), method, points)
    for k in range(12):                                    # nearly coincident: an ulp apart
        points = [(1.0, 0.0, 0.0), (1.0 + 2.0**-52, 0.0, 0.0), (c.real(2, 3), 0.0, 0.0), (3.0, c.short(0, 1), 0.0)]
        for method in METHODS:
            row("nearly coincident points", method, points)
    for k in range(40):                                    # whole distances
        points = [(0, 0, 0)]
        for _ in range(c.between(1, 8)):
            x, y, z = points[-1]
            a, b, d = c.of(((1, 2, 2), (2, 3, 6), (1, 4, 8), (0, 3, 4), (0, 0, 5), (0, 0, 0), (2, 6, 9), (8, 9, 12)))
            points.append((x + a, y - b, z + d))
        row("whole distances", "chord", points, True)


def grids(c):
    for name, draw in drawn(c):
        for k in range(5):
            nx, ny = c.between(2, 4), c.between(2, 4)
            rows = [[tuple(draw() for _ in range(3)) for _ in range(ny)] for _ in range(nx)]
            why = name
            if k == 1:
                rows[0] = [rows[0][0]] * ny
                why += ", degenerate geometry, pole"
            if k == 2:
                for r in rows:
                    r[-1] = r[0]
                why += ", seam and closure"
            for method in list(METHODS)[k % 3:]:
                grid_row(why, method, rows)


def main():
    print("# param: parameters of points\n# Written by tests/golden/param.py from exact arithmetic; not from Etalon.")
    print("# function\tclass\treason\tmethod n points; or method nx ny points; or n a b\tflat t; or flat s r; or means; or the status")
    for k, name in enumerate(["uniform", "chord", "centripetal", "exponential", "null"]):
        print("param_name", "exact", "order", k, name, sep="\t")
    c = Choices(19)
    first()
    lines(c)
    grids(c)
    for k in range(120):
        n = c.between(2, 9)
        a, b = (sorted([0.0, 1.0] + [c.real(0, 1) if k % 3 else c.short(0, 1, 16) for _ in range(n)]) for _ in range(2))
        if k % 5 == 0:
            b = [min(1.0, x * (1 + 2.0**-52)) for x in a]
        standardise("one ulp apart" if k % 5 == 0 else "random", a, b)
    for method in range(6):
        for nx, ny in ((0, 0), (0, 3), (1, 1), (1, 4), (4, 1), (2, 1), (2, 2), (3, 4)):
            bad = nx < 2 or ny < 2
            known = method <= 3
            status("too few points" if bad else "known method" if known else "unknown method", method, nx, ny, 0 if known and not bad else 1)


main()
