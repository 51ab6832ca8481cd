"""Golden rows of base/dd: sums and products of doubles exactly; the rest of rationals, hi rounded once, lo the rounded rest, within the proved bound.

The bounds are those of the header, of the rational result, and half an ulp of lo more for the rounding of the wanted lo.
"""
from fractions import Fraction as F
from math import isqrt

from rational import Choices, above, head, row

U = F(1, 2**53)
c = Choices(53)


def split(q):
    hi = float(q)
    return [hi, float(q - F(hi))]


def number(low, high):
    m = [F(2**52 + c.bits(52)), F(2**52 + (c.bits(8) << 44)), F(2**53 - 1 - c.upto(3))][c.upto(2)]
    return float(m * F(2) ** (low + c.upto(high - low) - 52) * (1 - 2 * c.upto(1)))


def pair(low, high):
    hi = number(low, high)
    lo = [0.0, float(F(hi) * U * F(c.upto(2**20), 2**20) * (1 - 2 * c.upto(1))), hi * 2.0**-60 * c.real(-1, 1)][c.upto(2)]
    return split(F(hi) + F(lo))


def near(function, reason, args, q, bound):
    hi, lo = split(q)
    row(function, "abs " + above(bound * abs(q) + abs(F(lo)) * U) if q else "exact", reason, args, [hi, lo])


def root(q):
    """sqrt q to 2^-200 relative, rounded down."""
    e = 400 + 2 * max(0, q.denominator.bit_length() - q.numerator.bit_length())
    return F(isqrt(q.numerator * 2**e // q.denominator), 2 ** (e // 2))


head("dd", "double-double arithmetic")
EDGES = [(1.0, 2.0**-53), (1.0, -(2.0**-54)), (1.0, 2.0**-1074), (2.0**53, 1.0), (2.0**53, -1.0), (2.0**1022, 2.0**969), (1.0, 1.0), (1.0, -1.0),
         (0.0, 0.0), (5e-324, 5e-324), (2.0**-1022, -5e-324), (0.1, 0.2), (1e16, 1.0), (-1e16, 1.0), (1.0 + 2.0**-52, 2.0**-53),
         (2.0 - 2.0**-52, 2.0**-52)]
for a, b in EDGES + [(number(-70, 70), number(-70, 70)) for _ in range(40)] + [(number(-1040, 1020), number(-1040, 1020)) for _ in range(20)]:
    row("dd_two_sum", "exact", "any" if (a, b) not in EDGES else "edge", [a, b], split(F(a) + F(b)))
EDGES = [(1.0 + 2.0**-52, 1.0 + 2.0**-52), (2.0 - 2.0**-52, 2.0 - 2.0**-52), (2.0**27 + 1, 2.0**27 + 1), (2.0**26 + 1, 2.0**27 - 1), (0.1, 10.0),
         (2.0**-968, 1.0), ((2.0 - 2.0**-52) * 2.0**-484, (2.0 - 2.0**-52) * 2.0**-485), (2.0**995, 2.0**26), (2.0**995, 2.0**-1074), (0.0, 3.0),
         (1 / 3, 3.0)]
for a, b in EDGES + [(number(-70, 70), number(-70, 70)) for _ in range(40)] + [(number(-480, 500), number(-480, 500)) for _ in range(20)]:
    row("dd_two_product", "exact", "any" if (a, b) not in EDGES else "edge", [a, b], split(F(a) * F(b)))
for k in range(60):
    a, b = (pair(-30, 30), pair(-30, 30)) if k % 3 else (pair(-400, 400), pair(-400, 400))
    x, y = sum(map(F, a)), sum(map(F, b))
    near("dd_add", "any", a + b, x + y, 3 * U**2 + 13 * U**3)
    near("dd_sub", "any", a + b, x - y, 3 * U**2 + 13 * U**3)
    near("dd_mul", "any", a + b, x * y, 7 * U**2)
    near("dd_div", "any", a + b, x / y, 15 * U**2 + 56 * U**3)
    a, x = ([-a[0], -a[1]], -x) if x < 0 else (a, x)
    near("dd_sqrt", "any", a, root(x), F(25, 8) * U**2 + F(1, 2**190))
for k in range(20):
    a = pair(-10, 10)
    b = split(F(-a[0]) + F(a[1]) * k)
    near("dd_add", "cancels", a + b, sum(map(F, a + b)), 3 * U**2 + 13 * U**3)
    near("dd_sub", "cancels", a + [-b[0], -b[1]], sum(map(F, a + b)), 3 * U**2 + 13 * U**3)
for k in range(1, 12):
    x, y = F(k), F(2 * k + 1, 2**60) + k
    near("dd_mul", "exact", split(y) + split(x), x * y, F(0))
    near("dd_div", "exact", split(x * 3) + split(F(3)), x, F(0))
    near("dd_sqrt", "square", split(x * x), x, F(0))
near("dd_add", "zero", [1.5, 2.0**-60, -1.5, -(2.0**-60)], F(0), F(0))
near("dd_sub", "zero", [1.5, 2.0**-60, 1.5, 2.0**-60], F(0), F(0))
near("dd_mul", "zero", [0.0, 0.0, 1.5, 2.0**-60], F(0), F(0))
near("dd_div", "zero", [0.0, 0.0, 1.5, 2.0**-60], F(0), F(0))
near("dd_sqrt", "zero", [0.0, 0.0], F(0), F(0))
row("dd_sqrt", "exact", "zero of the other sign", [-0.0, 0.0], [-0.0, 0.0])
row("dd_sqrt", "exact", "negative", [-1.0, 0.0], [float("nan"), float("nan")])
