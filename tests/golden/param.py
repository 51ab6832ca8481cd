#!/usr/bin/env python3
"""golden/param.tsv: parameters of points, from rational distances or from square roots and powers to 60 decimals."""
from decimal import Decimal, getcontext
from fractions import Fraction as F

getcontext().prec = 60
U = F(1, 2**53)
METHODS = {"uniform": 0, "chord": 1, "centripetal": 2, "exponential": 3}


def hexf(x):
    return float(x).hex()


def dec(x):
    return Decimal(x.numerator) / Decimal(x.denominator)


def distances(points, method):
    out = []
    for a, b in zip(points, points[1:]):
        d2 = sum((F(y) - F(x)) ** 2 for x, y in zip(a, b))
        d = dec(d2).sqrt()
        e = {0: Decimal(1), 1: d, 2: d.sqrt(), 3: d ** Decimal("0.8") if d else Decimal(0)}[method]
        out.append(F(e))
    return out


def parameters(points, method):
    d = distances(points, method)
    flat = method != 0 and sum(d) == 0
    if flat:
        d = [F(1)] * len(d)
    t = [F(0)]
    for x in d:
        t.append(t[-1] + x)
    return int(flat), [x / t[-1] for x in t]


def is_rational(points):
    for a, b in zip(points, points[1:]):
        d2 = sum((F(y) - F(x)) ** 2 for x, y in zip(a, b))
        n, m = d2.numerator, d2.denominator
        if int(F(dec(F(n)).sqrt())) ** 2 != n or int(F(dec(F(m)).sqrt())) ** 2 != m:
            return False
    return True


def row(reason, method, points):
    m = METHODS[method]
    flat, t = parameters(points, m)
    if flat or m == 0 or (m == 1 and is_rational(points)):
        cls = "exact"                      # short sums of whole numbers, one rounding: the quotient's
    else:
        cls = "abs " + hexf((len(t) + 32) * U)
    args = " ".join([str(m), str(len(points))] + [hexf(c) for p in points for c in p])
    print("param_row", cls, reason, args, " ".join([str(flat)] + [hexf(x) for x in t]), sep="\t")


def mean(lines):
    return [sum(c) / len(lines) for c in zip(*lines)]


def grid(reason, method, rows):
    m = METHODS[method]
    nx, ny = len(rows), len(rows[0])
    s = [parameters([rows[i][j] for i in range(nx)], m) for j in range(ny)]
    r = [parameters(rows[i], m) for i in range(nx)]
    flat = sum(x[0] for x in s) + sum(x[0] for x in r)
    want = [str(flat)] + [hexf(x) for x in mean([x[1] for x in s])] + [hexf(x) for x in mean([x[1] for x in r])]
    args = [str(m), str(nx), str(ny)] + [hexf(c) for line in rows for p in line for c in p]
    print("param_grid", "abs " + hexf((2 * max(nx, ny) + 34) * U), reason, " ".join(args), " ".join(want), sep="\t")


def standardise(reason, a, b):
    want = " ".join(hexf((F(x) + F(y)) / 2) for x, y in zip(a, b))
    print("param_standardise", "exact", reason, " ".join([str(len(a))] + [hexf(x) for x in a + b]), want, sep="\t")


def main():
    print("# function\tclass\treason\tmethod n points; or method nx ny points; or n a b\tflat t; or flat s r; or means")
    print("# made by tests/golden/param.py")
    for k, name in enumerate(["uniform", "chord", "centripetal", "exponential", "null"]):
        print("param_name", "exact", "order", k, name, sep="\t")
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
    for name, points in [("pythagorean", triples), ("line", line), ("all_equal", same), ("coincident_ends", ends), ("two_points", triples[:2]),
                         ("two_equal_points", same[:2]), ("general", general), ("huge", huge), ("subnormal", tiny), ("far_away", far),
                         ("squares_vanish", small), ("squares_overflow", large), ("backwards", triples[::-1]), ("back_and_forth", line + line[::-1])]:
        for method in METHODS:
            row(name, method, points)
    lattice = [[(x, y, 0) for y in (0, 1, 4, 6)] for x in (0, 3, 4, 9, 12)]
    hill = [[(x, y, 3 * (x % 2) * (y % 2)) for y in range(4)] for x in range(3)]
    pinch = [[(x, y, 0) if y else (0, 0, 0) for y in range(3)] for x in range(4)]
    point = [[(1, 2, 3)] * 3 for _ in range(2)]
    for name, rows in [("lattice", lattice), ("hill", hill), ("pinched", pinch), ("all_equal", point), ("smallest", [r[:2] for r in lattice[:2]])]:
        for method in METHODS:
            grid(name, method, rows)
    standardise("ends", [0.0, 1.0], [0.0, 1.0])
    standardise("halves", [0.0, 0.25, 1.0], [0.0, 0.75, 1.0])
    standardise("rounded", [0.0, 0.1, 0.3, 1.0], [0.0, 0.2, 0.7, 1.0])
    standardise("ulps", [0.0, 0.5, 1.0], [0.0, 0.5 + 2.0**-53, 1.0])
    standardise("subnormal", [0.0, 2.0**-1074, 1.0], [0.0, 3 * 2.0**-1074, 1.0])


main()
