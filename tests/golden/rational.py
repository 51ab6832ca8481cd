"""rational: what the generators of golden rows share: rationals, correctly rounded hex floats, B-spline bases by their definition."""
import re
import sys
from fractions import Fraction as F
from functools import lru_cache
from math import isqrt

MAX = 1.7976931348623157e308


def show(x):
    """A double as a hex float without idle zeros; a count or a word as it is."""
    return re.sub(r"\.?0*p", "p", x.hex()) if isinstance(x, float) else str(x)


def nearest(x):
    """The double nearest to a rational, ties to even, infinite beyond the greatest; zero is +0."""
    try:
        return float(x) + 0.0 if x else 0.0
    except OverflowError:
        return float("inf") if x > 0 else float("-inf")


def rounded(x):
    """The double nearest to a rational, as a hex float."""
    return show(nearest(F(x)))


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


def whole(u, x):
    """Knots and parameter as integers: all times one power of two, and that power."""
    parts = [F(t) for t in u] + [F(x)]
    scale = max(t.denominator for t in parts)
    parts = [t.numerator * (scale // t.denominator) for t in parts]
    return parts[:-1], parts[-1], scale


def local(u, p, k, x):
    """N_{i,p}, i = k-p..k, from the definition, the functions that vanish on the span left out: no difference of knots below is zero.  Integers."""
    n = [F(1)]
    for d in range(1, p + 1):
        n = [F(0)] + n + [F(0)]                  # n[i - k + d] = N_{i,d-1}, i = k-d .. k+1
        n = [times(n[r], x - u[i], u[i + d] - u[i]) + times(n[r + 1], u[i + d + 1] - x, u[i + d + 1] - u[i + 1])
             for r, i in enumerate(range(k - d, k + 1))]
    return n


def times(f, a, b):
    return F(f.numerator * a, f.denominator * b) if f else f


def local_derivative(u, p, k, x, d, sign):
    """d-th derivatives of N_{i,p}, i = k-p..k, in integers."""
    if d > p:
        return [F(0)] * (p + 1)
    n = local(u, p - d, k, x)
    for e in range(p - d + 1, p + 1):
        n = [F(0)] + n + [F(0)]
        n = [times(n[r], e, u[i + e] - u[i]) + sign * times(n[r + 1], e, u[i + e + 1] - u[i + 1]) for r, i in enumerate(range(k - e, k + 1))]
    return n


def window(u, p, k, x, d=0, sign=-1):
    """The d-th derivatives at x of N_{k-p,p} .. N_{k,p}, which do not vanish on span k; with sign = 1 the sums of the terms' magnitudes."""
    U, X, scale = whole(u, x)
    if d == 0:
        return local(U, p, k, X)
    return [v * scale ** d for v in local_derivative(U, p, k, X, d, sign)]


def cox(u, p, k, x):
    """All N_{i,p}(x), i = 0..len(u)-p-2, exactly, from the definition; k the span of x."""
    return cox_derivative(u, p, k, x, 0)


def cox_derivative(u, p, k, x, d, sign=-1):
    """All d-th derivatives of N_{i,p} at x; with sign = 1 the sums of the terms' magnitudes."""
    return [F(0)] * (k - p) + window(u, p, k, x, d, sign) + [F(0)] * (len(u) - p - 2 - k)


def ratio(a, b):
    return a / b if b != 0 else F(0)


@lru_cache(None)
def gamma(m):
    """(1-u)^-m - 1, u = 2^-53, rounded up to 64 binary digits: bounds are made of it, and rationals of thousands of digits are slow."""
    return up(1 / (1 - F(1, 2**53)) ** m - 1, 64)


def above(x):
    """A double not below the rational x, as a hex float."""
    y = nearest(x)
    while y < x:
        y = y * (1 + 2.0**-52) if y > 1e-300 else y + 5e-324
    return show(y)


def up(x, bits=32):
    """A number of few digits not below x >= 0: bounds need no more."""
    if x == 0:
        return F(0)
    e = x.numerator.bit_length() - x.denominator.bit_length() - bits
    if e < 0:
        return F(-(-(x.numerator << -e) // x.denominator), 1 << -e)
    return F(-(-x.numerator // (x.denominator << e)) << e)


def bound_of(x):
    """The same as a hex float of few digits: golden files are read by people, too."""
    return above(up(x, 4))


def root(q, degree=2, bits=80):
    """The degree-th root of a rational, cut off after `bits` binary digits, and whether that is all of it.  Cut off: a last digit 1 is put behind, so
    that it rounds to a double as the root itself does."""
    if q == 0:
        return F(0), True
    k = bits + max(0, (q.denominator.bit_length() - q.numerator.bit_length()) // degree + 1)
    scaled = F(q.numerator << (k * degree), q.denominator)
    n = iroot(scaled.numerator // scaled.denominator, degree)
    if n ** degree == scaled:
        return F(n, 2**k), True
    return F(2 * n + 1, 2 ** (k + 1)), False


def iroot(n, degree):
    """The greatest integer whose degree-th power does not exceed n."""
    if degree == 2:
        return isqrt(n)
    if degree == 4:
        return isqrt(isqrt(n))
    if n == 0:
        return 0
    x = 1 << -(-n.bit_length() // degree)
    while True:
        y = ((degree - 1) * x + n // x ** (degree - 1)) // degree
        if y >= x:
            return x
        x = y


def decided(value):
    """The double to which value(bits) -> (low, high) rounds, bits doubled until both ends agree."""
    bits = 128
    while True:
        low, high = value(bits)
        a, b = nearest(low), nearest(high)
        if a == b:
            return a
        bits *= 2
        assert bits < 10000, "a tie that no precision decides"


class Choices:
    """A small generator of test arguments: the same everywhere."""

    def __init__(self, seed):
        self.state = seed

    def bits(self, n):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return self.state >> (64 - n)

    def upto(self, n):
        return self.bits(32) * (n + 1) >> 32

    def between(self, lo, hi):
        return lo + self.upto(hi - lo)

    def of(self, things):
        return things[self.upto(len(things) - 1)]

    def real(self, lo, hi):
        return lo + (hi - lo) * (self.bits(53) / 2.0**53)

    def short(self, lo, hi, steps=64):
        """One of steps + 1 equal steps: few digits."""
        return lo + (hi - lo) * (self.upto(steps) / steps)


if __name__ == "__main__":
    sys.exit("rational.py is imported by the generators")
