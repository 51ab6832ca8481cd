"""Golden rows of base/real: sums of rationals; elementary functions correctly rounded in integers (elementary.py).

Arguments that are hard to round come from the published searches (Lefevre and Muller 2001; Lefevre 2020; for pow Zimmermann 2023) and from here: the
inverse function of a number midway between two doubles, where the function is so flat that rounding the argument leaves the result there.
"""
from fractions import Fraction as F
from math import isqrt, nextafter

import elementary as exactly
from rational import Choices, above, gamma, head, row


def rounds(n):
    m, reach, blocks = 18, 1, -(-n // 128)
    while reach < blocks:
        m, reach = m + 1, reach * 2
    return m


def elementary(name, reason, *args):
    row("real_" + name, "exact", reason, list(args), [getattr(exactly, name)(*args)])


def scaled(x, e):
    """x 2^e, rounded once."""
    return exactly.double(F(x) * F(2) ** e)


def beside(x):
    return [nextafter(x, -INF), x, nextafter(x, INF)]


def midway(x):
    """The number midway between x and the double above."""
    return (F(x) + F(nextafter(x, INF))) / 2


def root(q):
    """The double nearest to the square root of a rational, or beside it."""
    return exactly.double(F(isqrt(int(q * 4**120)), 2**120))


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

INF, NAN, LEAST, NORMAL, GREATEST = float("inf"), float("nan"), 5e-324, 2.0**-1022, 1.7976931348623157e308
SPECIAL = [0.0, -0.0, INF, -INF, NAN, 1.0, -1.0, LEAST, -LEAST, NORMAL, GREATEST, -GREATEST]

# The exponential.
for x in SPECIAL:
    elementary("exp", "special", x)
for x in [709.782712893384, 709.7827128933841, 710.0, 709.78, 709.0, 708.9999, -708.0, -708.3964185322641, -708.4, -744.4400719213812,
          -745.1332191019411, -745.1332191019412, -746.0, 1000.0, -1000.0]:
    for y in beside(x):
        elementary("exp", "near overflow or underflow", y)
for _ in range(40):
    elementary("exp", "subnormal result", c.real(-745.2, -708.3))
for x in ["0x1.83d4bcdebb3f4p+2", "-0x1.12d31a20fb38bp+5", "-0x1.a2fefefd580dfp-13", "0x1.9e9cbbfd6080bp-31", "0x1.0122ef37212ebp-1",
          "0x1.3d963bb752ap-1", "0x1.accfbe46b4efp-1", "0x1.c2c72a87085a9p-1", "0x1.3efea4cb30446p-1", "0x1.967b7b14a2e6ep-1",
          "0x1.70a1a8cb942d3p+0"]:
    for y in (float.fromhex(x), -float.fromhex(x)):
        elementary("exp", "published as hard, and its negative", y)
for k in range(1, 56):
    for x in (2.0**-k, -(2.0**-k), 2.0**-k * c.real(1, 2)):
        elementary("exp", "small argument", x)
for k in range(24):
    for m in (midway(1.0 + c.bits(30) * 2.0**-52), midway(1.0 - (1 + c.bits(20)) * 2.0**-53)):
        elementary("exp", "result nearly midway", exactly.decide(lambda w: exactly.log_of(m, w)))
for k in range(-20, 21, 2):
    for x in beside(exactly.double(F(k * 8 + 1, 16) * exactly.LN2)):
        elementary("exp", "between two steps of the table", x)
for _ in range(80):
    elementary("exp", "any", c.real(-20, 20))
    elementary("exp", "any", c.real(-708, 709))

# The logarithm.
for x in SPECIAL:
    elementary("log", "special", x)
for k in range(1, 53):
    for x in (1.0 + 2.0**-k, 1.0 - 2.0**-k, 1.0 + 2.0**-k * c.real(1, 2)):
        elementary("log", "near 1", x)
for x in ["0x1.62a88613629b6p+678", "0x1.ac50b409c8aeep+8", "0x1.a6ae5142326b5p+0", "0x1.c877cba59d0acp+0", "0x1.39e3e05fe5f35p+3",
          "0x1.4cad5d815d981p+2", "0x1.08ddce0f5ceep+43", "0x1.a6004162f2b8cp+45", "0x1.304da5ffcea3dp+42", "0x1.1cd5b1b9d3fc6p+23"]:
    elementary("log", "published as hard", float.fromhex(x))
for k in (3, 5, 7, 13, 15, 25, 60):
    elementary("log", "nearly midway: z - z^2/2", 1.0 + k * 2.0**-51)
    elementary("log", "nearly midway: z - z^2/2", 1.0 - k * 2.0**-52)
for i in range(0, 128, 4):
    low = 0.6875 + i / 256 if i < 80 else 0.375 + i / 128
    for x in beside(low):
        elementary("log", "border of a step of the table", x)
for _ in range(40):
    elementary("log", "subnormal argument", LEAST * (1 + c.bits(1 + c.upto(50))))
    elementary("log", "any exponent", scaled(c.real(1, 2), c.upto(2000) - 1000))
    elementary("log", "any", c.real(0, 30))

# Powers: annex F of C99 in full, then exact cases and midpoints, then the rest.
EXPONENTS = [0.0, -0.0, INF, -INF, NAN, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 0.5, -0.5, 2.0**53 - 1, 2.0**53, -(2.0**53) - 2, GREATEST, -GREATEST, LEAST]
for x in [0.0, -0.0, INF, -INF, NAN, 1.0, -1.0, 2.0, -2.0, 0.5, -0.5, GREATEST, -LEAST]:
    for y in EXPONENTS:
        elementary("pow", "special", x, y)
for a in (3, 5, 7, 9, 11, 21, 625, 94906267, 134217727):
    for n in range(2, 60):
        if 53 <= (a**n).bit_length() <= 56:
            elementary("pow", "exact, or midway", float(a), float(n))
            elementary("pow", "exact, or midway", -float(a), float(n))
            elementary("pow", "exact, or midway", scaled(a, -7), float(n))
for a, m in ((9, 1), (81, 2), (2**40, 3), (25, 1), (3**32, 4), (49 * 2**20, 1)):
    for n in (1, 3, -1, 5, 7, 9, 27):
        elementary("pow", "root and power", float(a), n / 2.0**m)
for n in (-1074, -1075, -1073, -1023, -1022, 1023, 1024, -1074.5, -1075.5, 0.5, -0.5):
    for x in (2.0, 0.5, 4.0):
        elementary("pow", "power of 2", x, float(n))
for x, y in [("0x1.ffffffffffffcp-1", "0x1.fffffffffffffp-2"), ("0x1.ffffffffffffcp-1", "-0x1.ffffffffffffdp-2"),
             ("0x1.ffffffffffffp-1", "-0x1.ffffffffffff6p-3"), ("0x1.ffffffffffff8p-1", "-0x1.ffffffffffffbp-3")]:
    elementary("pow", "published as hard", float.fromhex(x), float.fromhex(y))
# A logarithm with a relative error of 2^-74 may round these to the wrong side.
for x, y in [("0x1.01e08232ac264p+0", "0x1.62ee03bdd0417p+16"), ("0x1.01efc19db3299p+0", "0x1.6490b09d5ea04p+16"),
             ("0x1.01fa5a0e88b9ap+0", "0x1.38f6709e5c463p+16"), ("0x1.01f6fe12879a4p+0", "-0x1.372aa0d45f4adp+16"),
             ("0x1.01f2e8a6975d5p+0", "-0x1.5b394332c37p+16"), ("0x1.01e917d33ff19p+0", "0x1.6df9980d09c59p+16"),
             ("0x1.01dbd49388bc6p+0", "0x1.578fbee0ea8dbp+16"), ("0x1.01fdfe4ce51abp+0", "0x1.344939bf63b4cp+16")]:
    elementary("pow", "large power of a base near 1", float.fromhex(x), float.fromhex(y))
for k in range(30):
    y = 2.0 ** -(c.upto(16) + 4) * c.real(1, 2)
    m = midway(1.0 + c.bits(52 - 6 - k % 20) * 2.0**-52)
    elementary("pow", "result nearly midway", exactly.decide(lambda w: exactly.power_of(m, 1 / F(y), w)), y)
for k in range(1, 53, 3):
    x = 1.0 + 2.0**-k * c.real(1, 2)
    for size in (700.0, -700.0, 709.7, -745.0, 1.0, 2.0**-52):
        elementary("pow", "base near 1", x, size / exactly.log(x))
for _ in range(60):
    elementary("pow", "length to the power 0.8", c.real(0, 5), 0.8)
    elementary("pow", "length to the power 0.8, tiny", scaled(c.real(1, 2), -c.upto(1074)), 0.8)
    elementary("pow", "any", c.real(0, 100), c.real(-30, 30))
    elementary("pow", "any exponent", scaled(c.real(1, 2), c.upto(2000) - 1000), c.real(-1, 1))
    elementary("pow", "integer exponent", -c.real(0, 10), float(c.upto(40) - 20))

# Sine and cosine.
HUGE = [1e22, 1e300, GREATEST, scaled(6381956970095103, 797), 2.0**1023, 1e16, 4096.0, 4096.5, 1e5]
NEAR = [exactly.double(F(k) * exactly.PI / 2) for k in list(range(1, 30)) + [100, 1000, 2607, 2608, 10**6, 10**15]]
STEPS = [exactly.double(F(2 * k + 1) * exactly.PI / 1024) for k in range(0, 520, 13)]
HARD = ["0x1.598bae9e632f6p-7", "0x1.0102947e7003bp-3", "0x1.e0000000001c2p-20", "0x1.184a0aa58191dp-24", "0x1.06b505550e6b2p-9",
        "0x1.8000000000009p-23", "0x1.005023d32fee5p+1", "0x1.06800e629d672p-23", "0x1.21f63ff409044p-23", "0x1.30c7efbee12adp-24",
        "0x1.45dd7c26e54b9p-24", "0x1.58868e3115187p-24"]
for name in ("sin", "cos"):
    for x in SPECIAL:
        elementary(name, "special", x)
    for x in HUGE:
        for y in beside(x) + [-x]:
            elementary(name, "huge", y)
    for x in NEAR:
        for y in beside(x):
            elementary(name, "near a multiple of pi/2", y)
    for x in STEPS:
        elementary(name, "between two steps of the table", x)
    for x in HARD:
        elementary(name, "published as hard for the sine or the cosine", float.fromhex(x))
        elementary(name, "published as hard for the sine or the cosine", -float.fromhex(x))
    for k in range(1, 60):
        elementary(name, "small argument", 2.0**-k * c.real(1, 2))
    for _ in range(60):
        elementary(name, "any", c.real(-40, 40))
        elementary(name, "any", c.real(-4096, 4096))
    for _ in range(20):
        elementary(name, "any exponent", scaled(c.real(1, 2), c.upto(2000) - 1000))
for k in range(24):
    x = root(2 * (1 - midway(1.0 - (1 + c.bits(30)) * 2.0**-53)))
    elementary("cos", "result nearly midway", x)
