"""Golden rows of base/real: sums of rationals; elementary functions from decimals of 120 digits, correctly rounded."""
from decimal import Decimal as D, getcontext
from fractions import Fraction as F

from rational import Choices, above, gamma, head, row

getcontext().prec = 120


def rounds(n):
    m, reach, blocks = 18, 1, -(-n // 128)
    while reach < blocks:
        m, reach = m + 1, reach * 2
    return m


def near(d):
    return float(d)                 # decimal to double is correctly rounded


def sine(x, cosine=False):
    x, term, total, k = D(x), D(1) if cosine else D(x), D(0), 0 if cosine else 1
    while term != 0 and (k < 4 or abs(term) > D(10) ** -110 or k * k < x * x):
        total += term
        term = -term * x * x / ((k + 1) * (k + 2))
        k += 2
    return total


head("real", "sums and elementary functions")
c = Choices(1)
row("real_sum", "exact", "no term", [], [0.0])
for x in (1.5, -2.0, 5e-324, 1.7976931348623157e308):
    row("real_sum", "exact", "one term", [x], [x])
row("real_sum", "exact", "infinity", [1.0, float("inf"), -1e308], [float("inf")])
row("real_sum", "exact", "not a number", [float("inf"), float("-inf"), 1.0], [float("nan")])
row("real_sum", "exact", "subnormal terms add exactly", [5e-324] * 9 + [1e-323], [11 * 5e-324])
for n in (2, 7, 8, 9, 15, 16, 17, 31, 40):
    x = [float(c.upto(2000) - 1000) / 16 for _ in range(n)]
    row("real_sum", "exact", "sixteenths add exactly", x, [sum(map(F, x), F(0))])
for n in (5, 8, 12, 24, 33):
    x = [c.real(-1, 1) * 10.0 ** c.upto(8) for _ in range(n)]
    row("real_sum", "abs " + above(gamma(rounds(n)) * sum(abs(F(t)) for t in x) + F(1, 2**70)), "mixed scales", x, [sum(map(F, x), F(0))])
row("real_sum", "abs " + above(gamma(18) * F(2 * 10**16 + 1)), "cancellation", [1e16, 1.0, -1e16], [F(1)])
for n in (64, 127, 128, 129, 255, 256, 257, 384, 512, 1000, 1280):
    row("real_sum_ramp", "exact", "integers", [n, 1.0, 1.0], [F(n * (n + 1) // 2)])
    row("real_sum_ramp", "exact", "quarters around 0", [n, -10.0, 0.25], [sum((F(-10) + F(i, 4) for i in range(n)), F(0))])

XS = [0.0, 1.0, -1.0, 0.5, 2.0, 10.0, -10.0, 0.1, 700.0, -700.0, 1e-10, -1e-300, 709.0, -740.0, 3.0, 0.6931471805599453, 1e-17]
for x in XS + [c.real(-20, 20) for _ in range(10)]:
    row("real_exp", "exact" if x == 0 else "ulp 1", "exponential", [x], [near(D(x).exp())])
row("real_exp", "exact", "overflow", [710.0], [float("inf")])
row("real_exp", "exact", "underflow", [-750.0], [0.0])
for x in [1.0, 2.0, 0.5, 10.0, 1e-300, 5e-324, 1e308, 1.0 + 2.0**-52, 1.0 - 2.0**-53, 0.9, 1.1, 2.718281828459045] + [c.real(0, 30) for _ in range(10)]:
    row("real_log", "exact" if x == 1 else "ulp 1", "logarithm", [x], [near(D(x).ln())])
row("real_log", "exact", "zero", [0.0], [float("-inf")])
row("real_log", "exact", "negative", [-1.0], [float("nan")])
PAIRS = [(2.0, 10.0), (2.0, -3.0), (10.0, 2.0), (0.5, 3.0), (3.0, 40.0), (0.1, 0.8), (2.0, 0.8), (1e-5, 0.8), (7.5, 0.5), (1e300, 1.02), (0.999, 1e5)]
for x, y in PAIRS + [(c.real(0, 5), 0.8) for _ in range(10)]:
    row("real_pow", "ulp 1", "power", [x, y], [near((D(y) * D(x).ln()).exp())])
for x, y, z in [(5.0, 0.0, 1.0), (0.0, 0.0, 1.0), (1.0, 77.5, 1.0), (0.0, 0.8, 0.0)]:
    row("real_pow", "exact", "special", [x, y], [z])
ANGLES = [1.0, -1.0, 0.5, 1e-8, -1e-300, 1.5707963267948966, 3.141592653589793, 0.7853981633974483, 6.283185307179586, 10.0, 30.0, 1e-3]
row("real_sin", "exact", "zero", [0.0], [0.0])
row("real_cos", "exact", "zero", [0.0], [1.0])
for x in ANGLES + [c.real(-40, 40) for _ in range(10)]:
    row("real_sin", "ulp 1", "sine", [x], [near(sine(x))])
    row("real_cos", "ulp 1", "cosine", [x], [near(sine(x, True))])
