"""Golden rows of base/vec3: distances from integers' square roots, correctly rounded; 3.5u relative is at most 3.5 ulps."""
from fractions import Fraction as F

from rational import Choices, bound_of, head, root, row

U = F(1, 2**53)


def distance(p, q):
    """The root cut off well below half an ulp, which rounds as the root itself."""
    return root(sum((F(a) - F(b)) ** 2 for a, b in zip(p, q)))[0]


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


def rounds(why, p, q):
    """3.5u, and half an ulp of the wanted value; where squares underflow, by 2^-1075 each, their root by less than 2^-536."""
    d = distance(p, q)
    if d == 0:
        row("vec3_distance", "exact", why, p + q, [0.0])
    elif min(abs(F(a) - F(b)) for a, b in zip(p, q) if a != b) > F(1, 2**500):
        row("vec3_distance", "ulp 4", why, p + q, [d])
    else:
        row("vec3_distance", "abs " + bound_of(4 * U * d + F(1, 2**536)), why, p + q, [d])


def lebesgue(m, n, p, q):
    return m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p), m * m + n * n + p * p + q * q


for k in range(240):
    a, b, c, d = lebesgue(*(ch.upto(200) for _ in range(4)))
    s = 2.0 ** (ch.upto(500) - 250)
    o = [float(ch.upto(64)) * s for _ in range(3)]
    row("vec3_distance", "exact", "exact at scale", o + [x + y * s for x, y in zip(o, (a, b, c))], [d * s])
for why, draw in [("random", lambda: ch.real(-1, 1)), ("short", lambda: ch.short(-4, 4)), ("extreme scale, offset", lambda: 1e9 + ch.short(-1, 1)),
                  ("extreme scale, 1e150", lambda: 1e150 * ch.short(-1, 1)), ("extreme scale, 1e-150", lambda: 1e-150 * ch.short(-1, 1)),
                  ("extreme scale, squares underflow", lambda: 1e-170 * ch.short(-1, 1)), ("extreme scale, subnormal", lambda: 5e-324 * ch.upto(9)),
                  ("extreme scale, mixed", lambda: 10.0 ** (ch.upto(200) - 100) * ch.short(-1, 1))]:
    for _ in range(50):
        rounds(why, [draw() for _ in range(3)], [draw() for _ in range(3)])
for _ in range(60):
    p = [ch.real(-9, 9) for _ in range(3)]
    q = list(p)
    for _ in range(ch.upto(3)):
        i = ch.upto(2)
        q[i] = q[i] * (1 + 2.0**-52)
    rounds("coincident points, or nearly", p, q)
for k in range(6):
    p = [0.0] * 3
    p[k % 3] = 1.7e308 if k < 3 else -1.7e308
    row("vec3_distance", "exact", "extreme scale, overflow", p + [-x for x in p], [inf])
for _ in range(150):
    n = ch.between(1, 8)
    p = [ch.short(-1, 1) * 10.0 ** (ch.upto(600) - 300) for _ in range(3 * n)]
    bad = ch.upto(2) > 0
    if bad:
        p[ch.upto(3 * n - 1)] = ch.of((inf, -inf, nan))
    row("vec3_finite", "exact", "not a number or infinite" if bad else "extreme scale", p, [int(not bad)])
