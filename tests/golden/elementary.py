"""elementary: exp, log, pow, sin, cos correctly rounded to nearest-even, in integers alone.

A real is enclosed as (v - e) 2^q < value < (v + e) 2^q with integers v, e, q; the precision grows until both ends round to one double.  Where that
can never happen (values that are doubles or stand midway between two) the value is a rational and is rounded as one: by Lindemann and Weierstrass
e^x, ln x, sin x and cos x are irrational for rational x but 0 (and 1 for ln), and x^y is rational only as `dyadic_power` finds.
"""
from fractions import Fraction as F
from functools import lru_cache
from math import isqrt

INF = float("inf")
NAN = float("nan")


def double(q):
    """The double nearest to a rational; infinite where it overflows."""
    try:
        return float(q)                    # Python divides integers with correct rounding, subnormal results too
    except OverflowError:
        return INF if q > 0 else -INF


def scaled(x, w):
    """floor(x 2^w) of a rational x."""
    return (x.numerator << w) // x.denominator if w >= 0 else x.numerator // (x.denominator << -w)


def arctangent_of_inverse(n, w, sign):
    """atan(1/n) (sign -1) or atanh(1/n) (sign 1) times 2^w; each of fewer than w terms is off by less than 2: error below 2w."""
    total, power, k = 0, (1 << w) // n, 0
    while power:
        total += (sign ** k) * (power // (2 * k + 1))
        power //= n * n
        k += 1
    return total


@lru_cache(maxsize=None)
def pi(w):
    """pi 2^w with an error below 1: Machin's formula."""
    g = w + 40
    return (16 * arctangent_of_inverse(5, g, -1) - 4 * arctangent_of_inverse(239, g, -1)) >> 40


@lru_cache(maxsize=None)
def ln2(w):
    """ln 2 2^w with an error below 1."""
    g = w + 40
    return (18 * arctangent_of_inverse(26, g, 1) - 2 * arctangent_of_inverse(4801, g, 1) + 8 * arctangent_of_inverse(8749, g, 1)) >> 40


LN2, PI = F(ln2(400), 2**400), F(pi(400), 2**400)     # within 2^-400


def exp_of(x, e, w):
    """(v, e', q) for e^(x 2^-w) where x is off by at most e."""
    k = (x + (ln2(w) >> 1)) // ln2(w)
    r = x - k * ln2(w)                                   # off by e + |k|; 0 <= |r| < 2^w
    total, term, n = 0, 1 << w, 0
    while term:
        total += term
        n += 1
        term = term * r >> w
        term //= n
    # Each of n terms is off by less than 3, the rest is less than one; e^r < 2 carries the error of r.
    return total, 4 * n + 4 * (e + abs(k) + 2), k - w


def log_of(x, w):
    """(v, e, q) for ln x of a rational x > 0."""
    k = x.numerator.bit_length() - x.denominator.bit_length()
    m = x / F(2) ** k
    if 4 * m > 5:                                        # 5/8 < m <= 5/4
        m, k = m / 2, k + 1
    t = scaled((m - 1) / (m + 1), w)
    square, total, power, n = t * t >> w, 0, t, 1
    while power not in (0, -1):
        total += power // n
        power = power * square >> w
        n += 2
    # n/2 terms, each off by less than 4 (power by less than 3 as |t| < 1/4, the quotient by 1).
    return 2 * total + k * ln2(w), 8 * n + abs(k) + 8, -w


def power_of(x, y, w):
    """(v, e, q) for x^y of rationals, x > 0."""
    v, e, q = log_of(x, w + 16 + max(0, y.numerator.bit_length() - y.denominator.bit_length()))
    return exp_of(scaled(v * y * F(2) ** q, w), 2 + scaled(abs(y) * e * F(2) ** q, w), w)


def turn_of(x, w):
    """(quarter turns mod 4, r, e) with x = quarters pi/2 + r 2^-w, |r| 2^-w < 0.8."""
    extra = max(0, x.numerator.bit_length() - x.denominator.bit_length()) + 8
    half = pi(w + extra) >> 1
    full = scaled(x, w + extra)
    k = (full + (half >> 1)) // half
    return k % 4, (full - k * half) >> extra, 4


def sine_of(r, w, start):
    """sin (start 1) or cos (start 0) of r 2^-w, |r| 2^-w < 1, and the error."""
    square, total, term, n = r * r >> w, 0, (1 << w) if start == 0 else r, start
    while term not in (0, -1):
        total += term
        term = -(term * square >> w)
        term //= (n + 1) * (n + 2)
        n += 2
    return total, 4 * n + 8


def trigonometric(x, w, shift):
    quarter, r, e = turn_of(x, w)
    quarter = (quarter + shift) % 4
    v, more = sine_of(r, w, 1 if quarter % 2 == 0 else 0)
    return (v if quarter < 2 else -v), e + more, -w


def decide(enclosure):
    w = 128
    while True:
        v, e, q = enclosure(w)
        low, high = (double((v + s * e) * F(2) ** q) for s in (-1, 1))
        if low == high and (low != 0 or v - e > 0 or v + e < 0):
            return low
        w += w // 2


def exp(x):
    if x != x or x == INF:
        return x
    if x == 0 or x == -INF:
        return 1.0 if x == 0 else 0.0
    if abs(x) > 800:
        return INF if x > 0 else 0.0
    return decide(lambda w: exp_of(scaled(F(x), w), 1, w))


def log(x):
    if x != x or x < 0:
        return NAN
    if x in (0, 1, INF):
        return {0: -INF, 1: 0.0, INF: INF}[x]
    return decide(lambda w: log_of(F(x), w))


def sin(x):
    if x in (INF, -INF):
        return NAN
    return x if x != x or x == 0 else decide(lambda w: trigonometric(F(x), w, 0))


def cos(x):
    if x in (INF, -INF):
        return NAN
    return x if x != x else 1.0 if x == 0 else decide(lambda w: trigonometric(F(x), w, 1))


def integer_root(a, m):
    """The 2^m-th root of a natural number if it is a natural number, else None."""
    for _ in range(m):
        r = isqrt(a)
        if r * r != a:
            return None
        a = r
    return a


def dyadic_power(x, y):
    """x^y if it is a rational with a power of 2 as denominator and at most 60 bits, else None; x > 0.  With x = a 2^b, a odd, and y = n/2^m in lowest
    terms x^y is rational only if a and 2^b are 2^m-th powers; for n < 0 it is dyadic only if a = 1."""
    f, n = F(x), F(y)
    m, n = n.denominator.bit_length() - 1, n.numerator
    a = f.numerator
    b = (a & -a).bit_length() - 1 - (f.denominator.bit_length() - 1)
    a >>= (a & -a).bit_length() - 1
    if b % (1 << m) or (a > 1 and m > 6):
        return None
    a = integer_root(a, m) if a > 1 else 1
    if a is None or a > 1 and (n < 0 or n * (a.bit_length() - 1) > 60) or abs(n * (b >> m)) > 5000:
        return None
    return F(a) ** (n if a > 1 else 1) * F(2) ** (n * (b >> m))


def odd(y):
    return abs(y) < 2.0**53 and y == int(y) and int(y) % 2 == 1


def special_power(x, y):
    """The values C99 F.9.4.4 prescribes, or None where x^y is an ordinary number: x finite, not 0, not 1, y finite and not 0."""
    if x == 1 or y == 0:
        return 1.0
    if x != x or y != y:
        return NAN
    if y in (INF, -INF):
        return 1.0 if x == -1 else INF if (abs(x) > 1) == (y > 0) else 0.0
    if x in (0, INF, -INF):
        size = INF if (x == 0) == (y < 0) else 0.0
        return -size if odd(y) and str(x)[0] == "-" else size
    if x < 0 and y != int(y):
        return NAN
    return None


def pow(x, y):
    value = special_power(x, y)
    if value is not None:
        return value
    sign = -1.0 if x < 0 and odd(y) else 1.0
    x, y = abs(x), F(y)
    if x == 1:
        return sign
    exact = dyadic_power(x, y)
    if exact is not None:
        return sign * double(exact)
    v, e, q = log_of(F(x), 64)
    if v + e < 0 or v - e > 0:
        size = y * v * F(2) ** q
        if abs(size) > 1000:
            return sign * (INF if size > 0 else 0.0)
        if abs(size) < F(1, 2**70):
            return sign
    return sign * decide(lambda w: power_of(F(x), y, w))
