"""Golden rows of base/vec3: distances from integers' square roots, correctly rounded; 3.5u relative is at most 3.5 ulps."""
from decimal import Decimal as D, getcontext
from fractions import Fraction as F

from rational import Choices, head, row

getcontext().prec = 400


def distance(p, q):
    s = sum((F(a) - F(b)) ** 2 for a, b in zip(p, q))
    return float((D(s.numerator) / D(s.denominator)).sqrt())


head("vec3", "distances, and which points are finite")
EXACT = [(1, 2, 2, 3), (2, 3, 6, 7), (1, 4, 8, 9), (4, 4, 7, 9), (2, 6, 9, 11), (6, 6, 7, 11), (3, 4, 12, 13), (0, 3, 4, 5), (0, 0, 8, 8)]
for a, b, c, d in EXACT:
    for s in (1.0, -0.25, 2.0**100, 2.0**-100):
        row("vec3_distance", "exact", "Pythagorean", [a * s, b * s, c * s, 0.0, 0.0, 0.0], [d * abs(s)])
row("vec3_distance", "exact", "coincident", [0.1, 0.2, 0.3, 0.1, 0.2, 0.3], [0.0])
row("vec3_distance", "exact", "neighbours", [1.0, 0.0, 0.0, 1.0 + 2.0**-52, 0.0, 0.0], [2.0**-52])
ch = Choices(3)
for k in range(20):
    p = [ch.real(-1, 1) * 10.0 ** (k - 10) for _ in range(3)]
    q = [ch.real(-1, 1) * 10.0 ** (k - 10) for _ in range(3)]
    row("vec3_distance", "ulp 4", "any", p + q, [distance(p, q)])
inf, nan = float("inf"), float("nan")
row("vec3_finite", "exact", "no point", [], [1])
row("vec3_finite", "exact", "greatest", [1.7976931348623157e308, -1.7976931348623157e308, 5e-324], [1])
for bad in (inf, -inf, nan):
    for at in range(6):
        p = [1.0] * 6
        p[at] = bad
        row("vec3_finite", "exact", "one coordinate", p, [0])
