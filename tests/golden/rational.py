"""rational: what the generators of golden rows share: rationals, correctly rounded hex floats, B-spline bases by their definition."""
import re
import sys
from fractions import Fraction as F


def show(x):
    """A double as a hex float without idle zeros; a count or a word as it is."""
    return re.sub(r"\.?0*p", "p", x.hex()) if isinstance(x, float) else str(x)


def rounded(x):
    """The double nearest to a rational, as a hex float."""
    return show(float(F(x)))


def row(function, kind, reason, args, want):
    """One line: wanted rationals are rounded, wanted doubles, counts and words written as they are."""
    text = [rounded(w) if isinstance(w, F) else show(w) for w in want]
    print("\t".join([function, kind, reason, " ".join(show(a) for a in args), " ".join(text)]))


def head(name, what):
    print("# %s: %s" % (name, what))
    print("# Written by tests/golden/%s.py from exact arithmetic; not from Etalon." % name)
    print("# function\tclass\treason\targuments\twanted")


def span(u, p, x):
    """The span of x, clamped to the domain: the last non-empty one that begins at or before x and before the domain's end."""
    end = u[len(u) - p - 1]
    x = min(max(x, u[p]), end)
    return max(k for k in range(p, len(u) - p - 1) if u[k] <= x and u[k] < end)


def cox(u, p, k, x):
    """All N_{i,p}(x), i = 0..len(u)-p-2, exactly, from the definition; k the span of x."""
    n = [F(int(i == k)) for i in range(len(u) - 1)]
    for d in range(1, p + 1):
        n = [(ratio(x - F(u[i]), F(u[i + d]) - F(u[i])) * n[i] + ratio(F(u[i + d + 1]) - x, F(u[i + d + 1]) - F(u[i + 1])) * n[i + 1])
             for i in range(len(u) - d - 1)]
    return n


def cox_derivative(u, p, k, x, d, sign=-1):
    """All d-th derivatives of N_{i,p} at x; with sign = 1 the sums of the terms' magnitudes."""
    if d == 0:
        return cox(u, p, k, x)
    if p == 0:
        return [F(0)] * (len(u) - 1)
    lower = cox_derivative(u, p - 1, k, x, d - 1, sign)
    return [p * (ratio(lower[i], F(u[i + p]) - F(u[i])) + sign * ratio(lower[i + 1], F(u[i + p + 1]) - F(u[i + 1]))) for i in range(len(u) - p - 1)]


def ratio(a, b):
    return a / b if b != 0 else F(0)


def gamma(m):
    """(1-u)^-m - 1, u = 2^-53."""
    return 1 / (1 - F(1, 2**53)) ** m - 1


def above(x):
    """A double not below the rational x, as a hex float."""
    y = float(x)
    while F(y) < x:
        y *= 1 + 2.0**-52
    return show(y)


class Choices:
    """A small generator of test arguments: the same everywhere."""

    def __init__(self, seed):
        self.state = seed

    def bits(self, n):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return self.state >> (64 - n)

    def upto(self, n):
        return self.bits(32) * (n + 1) >> 32

    def real(self, lo, hi):
        return lo + (hi - lo) * (self.bits(53) / 2.0**53)


if __name__ == "__main__":
    sys.exit("rational.py is imported by the generators")
