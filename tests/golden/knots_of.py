"""knots_of: the knot vectors on which the basis and the surfaces are tabulated."""
from fractions import Fraction as F
from math import frexp

ULP = 2.0**-52
BASES = [
    (3, [0.0] * 4 + [1.0] * 4, "Bernstein"),
    (3, [0.0] * 4 + [0.1, 0.3, 0.7] + [1.0] * 4, "clamped"),
    (3, [0.0] * 4 + [0.5, 0.5 + ULP / 2, 0.5 + ULP] + [1.0] * 4, "one ulp apart"),
    (3, [0.0] * 4 + [0.5] * 3 + [1.0] * 4, "multiplicity p"),
    (3, [0.0] * 4 + [0.5] * 4 + [1.0] * 4, "multiplicity p + 1"),
    (3, [0.0] * 6 + [1.0] * 5, "more than p + 1 equal"),
    (2, [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0, 5.0, 5.0, 5.0], "the book's"),
    (0, [-3.0, 0.125, 7.0], "degree 0"),
    (1, [0.0, 0.0, 1.0 / 3, 0.9, 0.9, 1.0, 1.0], "degree 1"),
    (2, [-1.0, -0.5, 0.0, 0.25, 0.25, 2.0, 2.5, 3.0], "not clamped"),
    (3, [float(k) for k in range(10)], "uniform"),
    (3, [0.0] * 4 + [2.0**-50] + [1.0] * 4, "a tiny span"),
    (3, [49.0 * 2.0**60] * 4 + [98.0 * 2.0**60] * 4, "r (1/r) is not 1"),
    (5, [0.0] * 6 + [0.2, 0.45, 0.45, 0.8] + [1.0] * 6, "degree 5"),
    (7, [0.0] * 8 + [0.3] * 7 + [0.31] + [1.0] * 8, "degree 7"),
]


def after(x):
    """The next double above."""
    if x == 0:
        return 5e-324
    m, e = frexp(abs(x))
    step = max(2.0**-1074, 2.0 ** (e - 53))
    return x + (step if x > 0 or m > 0.5 else step / 2)


def valid(u, p):
    if len(u) < 2 * p + 2 or any(x - x != 0 for x in u):
        return 0
    for a, b in zip(u, u[1:]):
        if b < a or 0 < F(b) - F(a) < F(2.0**-1022):
            return 0
    # A difference overflows from the middle between the greatest double and 2^1024 on.
    return int(F(u[-1]) - F(u[0]) < F(2) ** 1024 - F(2) ** 970 and u[p] < u[len(u) - p - 1])


def clamped(p, inner, lo=0.0, hi=1.0):
    return [lo] * (p + 1) + inner + [hi] * (p + 1)


def inner_knots(c, n, most, steps=64):
    """n knots inside (0, 1), some of them repeated up to `most` times."""
    inner = []
    while len(inner) < n:
        t = c.between(1, steps - 1) / steps if c.upto(1) else 0.001 + 0.998 * c.bits(53) / 2.0**53
        inner += [t] * min(n - len(inner), 1 + (c.upto(most - 1) if c.upto(2) == 0 else 0))
    return sorted(inner)


def near(c, p):
    """Interior knots one ulp apart, in the middle and at the domain's ends."""
    where = c.upto(3)
    t = c.real(0.01, 0.99) if where == 0 else 0.5 if where == 1 else 1.0 - 3 * 2.0**-53 if where == 2 else 2.0**-960
    run = [t]
    for _ in range(c.between(1, p + 1)):
        run.append(after(run[-1]) if c.upto(3) else run[-1])
    return clamped(p, [x for x in run if 0 < x < 1])


def scaled(u, factor, offset=0.0):
    return [offset + t * factor for t in u]


def families(c, rounds, degrees=6):
    """Knot vectors by category: (degree, knots, category)."""
    for _ in range(rounds):
        p = c.between(1, degrees)
        yield p, clamped(p, inner_knots(c, c.between(0, 6), 1)), "random"
        yield p, clamped(p, inner_knots(c, c.between(p, p + 5), p + 1)), "repeated knots"
        yield p, clamped(p, inner_knots(c, p + 1, p + 2, 8)), "knot equality"
        yield p, near(c, p), "near-equal knots"
        u = sorted(c.short(-4, 4, 32) for _ in range(2 * p + 2 + c.upto(5)))
        yield p, u if u[p] < u[-p - 1] else [float(k) for k in range(len(u))], "not clamped"
        base = clamped(p, inner_knots(c, c.between(0, 4), 2))
        yield p, scaled(base, 2.0 ** c.of((531, -531))), "extreme scale"
        offset = c.of((1e9, -1e9, 2.0**40))
        yield p, scaled(base, 1.0, offset), "extreme scale, offset"
        wide = clamped(p, sorted([2.0 ** -c.between(20, 200), 1.0 - 2.0**-c.between(10, 52)] + inner_knots(c, 2, 1)))
        yield p, wide, "extreme scale, spans"
        zero = clamped(p, inner_knots(c, 2, 2), -1.0)
        yield p, sorted(zero + [0.0, -0.0], key=lambda t: (t, str(t)[0] != "-")), "negative zero"


def least(p):
    """Spans of the least width there may be, and knots of subnormal size."""
    m = 2.0**-1022
    yield p, clamped(p, [m * k for k in range(1, 5)], 0.0, 5 * m), "extreme scale, least spans"
    yield p, clamped(p, [-m, 0.0, m], -2 * m, 2 * m), "extreme scale, least spans"


def high_degrees(c):
    for p in range(26):
        yield p, clamped(p, []), "degree %d" % p
        yield p, clamped(p, inner_knots(c, 2, 1)), "degree %d" % p
        if p:
            yield p, clamped(p, [0.5] * min(p, 9)), "degree %d, repeated knots" % p
