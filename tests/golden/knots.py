"""Golden rows of spline/knots: by comparing doubles exactly."""
from fractions import Fraction as F

from rational import Choices, head, row, span

MIN, MAX = 2.0**-1022, 1.7976931348623157e308
inf, nan = float("inf"), float("nan")


def valid(u, p):
    if len(u) < 2 * p + 2 or any(x != x or abs(x) == inf for x in u):
        return 0
    for a, b in zip(u, u[1:]):
        if b < a or 0 < F(b) - F(a) < F(MIN):
            return 0
    # A difference overflows from the middle between the greatest double and 2^1024 on.
    return int(F(u[-1]) - F(u[0]) < F(2) ** 1024 - F(2) ** 970 and u[p] < u[len(u) - p - 1])


def clamped(u, p):
    return int(len(set(u[:p + 1])) == 1 and len(set(u[-p - 1:])) == 1)


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
    row("knots_clamped", "exact", why, [p] + u, [clamped(u, p)])
row("knots_clamped", "exact", "left end open", [2] + [-1.0] + BOOK[1:], [0])
row("knots_clamped", "exact", "right end open", [2] + BOOK[:-1] + [6.0], [0])
c = Choices(7)
for p, u, why in GOOD:
    lo, hi = u[p], u[-p - 1]
    inner = sorted(set(u))
    mids = [a / 2 + b / 2 for a, b in zip(inner, inner[1:])]
    for x in sorted(set(inner + mids + [lo, hi, lo - 1.0, hi + 1.0, hi - 2.0**-53, c.real(lo, hi)])):
        row("knots_span", "exact", why, [p] + u + [x], [span(u, p, x)])
