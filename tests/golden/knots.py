"""Golden rows of spline/knots: by comparing doubles exactly; Greville points in rationals.

Arguments: degree, knots; then for spans the parameter, for spans from a side the parameter and 0 (right) or 1 (left), for multiplicities the parameter.
"""
from fractions import Fraction as F

from knots_of import BASES, after, families, high_degrees, least, valid
from rational import Choices, bound_of, gamma, head, row, span

MIN, MAX = 2.0**-1022, 1.7976931348623157e308
inf, nan = float("inf"), float("nan")


def is_clamped(u, p):
    return int(len(set(u[:p + 1])) == 1 and len(set(u[-p - 1:])) == 1)


def is_interpolating(u, p):
    """The ends p + 1 times each, no more and no less."""
    return int(u.count(u[p]) == p + 1 == u[:p + 1].count(u[p]) and u.count(u[-p - 1]) == p + 1 == u[-p - 1:].count(u[-1]))


BEZIER = [0.0] * 4 + [1.0] * 4
BOOK = [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0, 5.0, 5.0, 5.0]      # The NURBS Book, example 2.3
ULPS = [0.0] * 4 + [0.5, 0.5 + 2.0**-53, 0.5 + 2.0**-52] + [1.0] * 4
FULL = [0.0] * 4 + [0.5] * 4 + [1.0] * 4
OVER = [0.0] * 6 + [0.25] * 5 + [1.0] * 7
LOOSE = [-1.0, -0.5, 0.0, 0.25, 0.25, 2.0, 2.5, 3.0]
STEP = [-3.0, 0.125]
GOOD = [(3, BEZIER, "one span"), (2, BOOK, "the book's"), (3, ULPS, "one ulp apart"), (3, FULL, "full multiplicity"), (3, OVER, "more than p + 1 equal"),
        (2, LOOSE, "not clamped"), (0, STEP, "degree 0"), (1, [0.0, 0.0, MIN, 1.0, 1.0], "the least distance"), (3, [float(k) for k in range(12)], "uniform")]
BAD = [(3, BEZIER[:-1], "too few"), (4, BEZIER, "too few"), (0, [1.0, 1.0], "empty domain"), (1, [0.0, 0.5, 0.5, 1.0], "empty domain"),
       (1, [0.0, 0.0, 1.0, 1.0 - 2.0**-53], "decreasing by an ulp"), (1, [0.0, 0.0, 5e-324, 1.0, 1.0], "too near"),
       (1, [0.0, 0.0, MIN - 5e-324, 1.0, 1.0], "too near by an ulp"), (0, [-MAX, MAX], "overflow"), (1, [nan, 0.0, 1.0, 1.0], "not a number"),
       (1, [0.0, 0.0, nan, 1.0, 1.0], "not a number"), (1, [0.0, 0.0, 1.0, inf], "infinite"), (1, [-inf, 0.0, 1.0, 1.0], "infinite"), (0, [], "none")]

head("knots", "knot vectors, and the spans of parameters")
for p, u, why in GOOD:
    assert valid(u, p) == 1
for p, u, why in GOOD + BAD:
    row("knots_valid", "exact", why, [p] + u, [valid(u, p)])
row("knots_valid", "exact", "half the range each side", [0, -MAX / 2, MAX / 2], [1])
for p, u, why in GOOD:
    row("knots_clamped", "exact", why, [p] + u, [is_clamped(u, p)])
    row("knots_interpolating", "exact", why, [p] + u, [is_interpolating(u, p)])
for f in "knots_clamped", "knots_interpolating":
    row(f, "exact", "left end open", [2] + [-1.0] + BOOK[1:], [0])
    row(f, "exact", "right end open", [2] + BOOK[:-1] + [6.0], [0])
row("knots_interpolating", "exact", "left end four times", [2] + [0.0] + BOOK, [0])
row("knots_interpolating", "exact", "right end four times", [2] + BOOK + [5.0], [0])
c = Choices(7)
for p, u, why in GOOD:
    lo, hi = u[p], u[-p - 1]
    inner = sorted(set(u))
    mids = [a / 2 + b / 2 for a, b in zip(inner, inner[1:])]
    for x in sorted(set(inner + mids + [lo, hi, lo - 1.0, hi + 1.0, hi - 2.0**-53, c.real(lo, hi)])):
        row("knots_span", "exact", why, [p] + u + [x], [span(u, p, x)])


def before(x):
    return -after(-x)


def spots(c, u, p):
    """(category, parameter)"""
    lo, hi = u[p], u[-p - 1]
    at = c.of(u)
    yield "end of domain", lo
    yield "end of domain", hi
    yield "next to the end", before(hi)
    yield "next to the end", after(lo)
    yield "at a knot", at
    yield "near-equal to a knot", c.of((before, after))(at)
    yield "outside the domain", c.of((lo - 1.0, hi + 1.0, before(lo), after(hi), -MAX, MAX))
    yield "between", lo + (hi - lo) * c.short(0.0, 1.0, 1024)
    yield "negative zero", -0.0


def spoiled(c, u, p):
    """Knots that are not valid, or may not be: one thing changed."""
    i = c.upto(len(u) - 1)
    j = c.between(1, len(u) - 1)
    put = lambda k, x: u[:k] + [x] + u[k + 1:]
    yield "not a number", put(i, nan)
    yield "infinite", put(i, c.of((inf, -inf)))
    yield "decreasing", put(j, before(u[j - 1]))
    yield "decreasing", u[::-1]
    yield "too few", u[:c.upto(2 * p + 1)]
    yield "empty domain", [u[p]] * len(u)
    yield "near-equal knots", u[:j] + [after(u[j - 1])] + [max(t, after(u[j - 1])) for t in u[j + 1:]]
    yield "extreme scale, too near", put(0, u[0] - 2.0**-1030) if u[0] == 0 else put(0, before(u[0]))
    yield "extreme scale, overflow", u[:1] + [t if t < u[-1] else MAX for t in u[1:]]
    yield "extreme scale, overflow", [t if t > u[0] else -MAX for t in u]


for p, u, why in list(families(c, 40, 9)) + [x for p in range(1, 8) for x in least(p)] + list(high_degrees(c)) + BASES:
    row("knots_valid", "exact", why, [p] + u, [valid(u, p)])
    row("knots_clamped", "exact", why, [p] + u, [is_clamped(u, p)])
    row("knots_interpolating", "exact", why, [p] + u, [is_interpolating(u, p)])
    for where, x in spots(c, u, p):
        if x - x == 0:
            row("knots_span", "exact", why + ", " + where, [p] + u + [x], [span(u, p, x)])
for p, u, why in families(c, 8, 5):
    for what, bad in spoiled(c, u, p):
        row("knots_valid", "exact", what + ", from " + why, [p] + bad, [valid(bad, p)])
        if valid(bad, p):
            row("knots_clamped", "exact", what + ", from " + why, [p] + bad, [is_clamped(bad, p)])
            row("knots_interpolating", "exact", what + ", from " + why, [p] + bad, [is_interpolating(bad, p)])


def left_span(u, p, x):
    """The last span that is not empty and begins before x, or else the first."""
    some = [k for k in range(p, len(u) - p - 1) if u[k] < u[k + 1]]
    return max([k for k in some if u[k] < x] or some[:1])


def greville_row(p, u, why):
    points, bound = [], F(0)
    for i in range(len(u) - p - 1):
        some = [F(t) for t in (u[i + 1:i + p + 1] if p else u[i:i + 2])]
        points.append(sum(some) / len(some))
        bound = max(bound, gamma(p + 1 if p else 3) * (points[-1] - some[0]) + abs(points[-1]) / 2**53 + F(p + 2, 2**1075))
    row("knots_greville", "abs " + bound_of(bound * (1 + F(1, 2**40))), why, [p] + u, points)


c = Choices(19)
for n, (p, u, why) in enumerate(list(families(c, 4, 9)) + [x for p in range(1, 4) for x in least(p)] + list(high_degrees(c))[::3] + BASES):
    greville_row(p, u, why)
    for where, x in spots(c, u, p):
        if x - x == 0:
            row("knots_span_side", "exact", why + ", " + where, [p] + u + [x, 1], [left_span(u, p, x)])
            if n % 4 == 0:
                row("knots_span_side", "exact", why + ", " + where, [p] + u + [x, 0], [span(u, p, x)])
            if n % 2 == 0:
                row("knots_multiplicity", "exact", why + ", " + where, [p] + u + [x], [sum(t == x for t in u)])
greville_row(0, [-MAX / 2, 0.0, MAX / 2], "extreme scale, degree 0")
greville_row(25, [0.875 * MAX] * 26 + [MAX] * 26, "extreme scale, a sum that overflows")
greville_row(3, [0.1] * 4 + [0.7] * 4, "repeated knots, 3 x / 3")
