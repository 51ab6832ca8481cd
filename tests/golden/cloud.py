#!/usr/bin/env python3
"""Rows of golden/cloud.tsv: decimal numbers and the doubles nearest to them, by exact integer arithmetic; doubles and their shortest digits."""
from fractions import Fraction
import struct


def rounded(q):
    """The double nearest to the rational q, ties to even, as a hex float; q >= 0 and not past the largest double."""
    if q == 0:
        return 0, -1074
    e = q.numerator.bit_length() - q.denominator.bit_length() - 53
    while q / Fraction(2) ** e >= 2 ** 53:
        e += 1
    while q / Fraction(2) ** e < 2 ** 52:
        e -= 1
    e = max(e, -1074)
    m = q / Fraction(2) ** e
    n, rest = divmod(m.numerator, m.denominator)
    if 2 * rest > m.denominator or (2 * rest == m.denominator and n % 2):
        n += 1
    return n, e


def hex_of(word):
    """The double nearest to a decimal number."""
    sign = "-" if word.startswith("-") else ""
    body = word.lstrip("+-").lower().replace("d", "e")
    mantissa, _, exponent = body.partition("e")
    whole, _, part = mantissa.partition(".")
    q = Fraction(int((whole + part) or "0")) * Fraction(10) ** (int(exponent or "0") - len(part))
    n, e = rounded(q)
    return "%s0x%xp%+d" % (sign, n, e)


def bits(k):
    return struct.unpack("<d", struct.pack("<Q", k))[0]


def shortest(x):
    """15, 16 or 17 significant digits, the least that lead back; decided in rationals."""
    for digits in (15, 16, 17):
        word = "%.*g" % (digits, x)
        n, e = rounded(abs(Fraction(word)))
        if Fraction(n) * Fraction(2) ** e == abs(Fraction(x)):
            return word
    raise AssertionError


def middle(x):
    """The decimal exactly halfway between x >= 1 and the next double, and its neighbours in the last place."""
    n, e = rounded(Fraction(x))
    q = (2 * n + 1) * Fraction(2) ** (e - 1)
    places = 0
    while q.denominator != 1:
        q *= 10
        places += 1
    d = str(q.numerator).zfill(places + 1)
    word = d[: len(d) - places] + "." + (d[len(d) - places:] or "0")
    return word, word + "0" * 30 + "1", word[:-1] + str(int(word[-1]) - 1) + "9" * 30 if word[-1] != "0" else word


def read(reason, *words):
    print("cloud_read", "exact", reason, " ".join(words), " ".join(hex_of(w) for w in words[:3]), sep="\t")


def write(reason, *xs):
    print("cloud_write", "exact", reason, " ".join(x.hex() for x in xs), " ".join(shortest(x) for x in xs), sep="\t")


print("# Written by tests/golden/cloud.py.  cloud_read: a line of an XYZ file, its three doubles.  cloud_write: three doubles, their digits.")
read("small integers", "1", "-2", "+3")
read("zeros", "0", "-0", "0.000")
read("tenths", "0.1", "0.2", "0.3")
read("a point at an end", "5.", ".5", "-.25")
read("exponents", "1e3", "25E-2", "-7e+0")
read("Fortran's exponents", "1.5D+02", "1d0", "-2.5d-1")
read("extra columns", "1", "2", "3", "4", "nan", "name")
read("powers of ten, exact", "1e22", "1e15", "1e-5")
read("powers of ten, past the exact ones", "1e23", "1e24", "1e-23")
read("digits to 2^53 and past", "9007199254740992", "9007199254740993", "9007199254740995")
read("19 and 20 digits", "9999999999999999999", "18446744073709551615", "18446744073709551616")
read("21 and 40 digits", "123456789012345678901", "1234567890123456789012345678901234567890", "0.1000000000000000055511151231257827021181583404541015625")
read("leading zeros", "000000000000000000000000000001.5", "0.000000000000000000000000000001", "-00.10")
read("trailing zeros", "1.5000000000000000000000000000000", "100000000000000000000000", "7.000")
read("largest", "1.7976931348623157e308", "-1.7976931348623157e308", "179769313486231570e291")
read("just below overflow", "1.797693134862315807e308", "1.7976931348623158e308", "0.17976931348623157e309")
read("smallest normal", "2.2250738585072014e-308", "2.2250738585072011e-308", "2.225073858507201e-308")
read("subnormal", "4.9406564584124654e-324", "2.4703282292062328e-324", "2.4703282292062327e-324")
read("subnormal, more digits", "1e-323", "1.2345678901234567e-310", "-3e-324")
read("underflow", "1e-400", "-1e-400", "0e999")
read("zero with an exponent", "0e400", "-0.0e-400", "0.0e5")
for k, x in enumerate((1.0, 1.5, 2.0 ** 52, 2.0 ** 53 - 1, 2.0 ** 10 - 2.0 ** -43, 2.0 ** 20 + 2.0 ** -32, 8.0 / 7)):
    read("halfway, just above, just below (%d)" % k, *middle(x))
read("known hard cases", "6.02214076e23", "8.5e-315", "9.4e-322")
read("known hard cases", "3.0540412E5", "4.1518994E-10", "8533e+68")
read("known hard cases", "5e-20", "7e-27", "9.5367431640625e-7")
read("known hard cases", "69e267", "999e-26", "7861e-34")
read("known hard cases", "5708990770823839207320493820740630171355185152001e-3", "104308485241983990666713401708072175773165034278685e-3",
     "1090544144181609348671888949248e0")
state = 20230401
for k in range(40):
    words = []
    for _ in range(3):
        state = (state * 6364136223846793005 + 1442695040888963407) % 2 ** 64
        digits = 1 + state // 2 ** 59
        number = str(state % 10 ** digits)
        state = (state * 6364136223846793005 + 1442695040888963407) % 2 ** 64
        words.append("%s%s.%se%d" % ("-" if state >> 63 else "", number[:1], number[1:], (state >> 40) % 41 - 20))
    read("drawn", *words)
write("integers", 0.0, 1.0, -3.0)
write("negative zero", -0.0, 100000.0, 123456789012345.0)
write("tenths", 0.1, 0.2, 0.30000000000000004)
write("thirds", 1 / 3, 2 / 3, -1 / 3)
write("16 digits", 0.1 + 0.7, 9007199254740993.0, 5e-324)
write("large and small", 1.7976931348623157e308, 2.2250738585072014e-308, 4.9406564584124654e-324)
write("a power of ten not exact", 1e23, 1e22, 1e-7)
for k in range(30):
    xs = []
    for _ in range(3):
        state = (state * 6364136223846793005 + 1442695040888963407) % 2 ** 64
        xs.append(bits((state >> 1) % (0x7FF << 52)) if k % 2 else (state >> 11) / 2 ** 53)
    write("drawn", *xs)
def next_bits():
    global state
    state = (state * 6364136223846793005 + 1442695040888963407) % 2 ** 64
    return state >> 1


def any_double(kind):
    """A finite double: of any exponent, subnormal, a short one, an integer."""
    k = next_bits()
    sign = -1.0 if next_bits() % 2 else 1.0
    if kind == 0:
        return sign * bits(k % (0x7FF << 52))
    if kind == 1:
        return sign * bits(k % (1 << 52))
    if kind == 2:
        return sign * (k % 10 ** (1 + k % 7)) / 10.0 ** (k % 5)
    return sign * float(k % 2 ** (k % 60 + 1))


KINDS = ("extreme scale", "extreme scale, subnormal", "short", "whole")
for k in range(240):
    write(KINDS[k % 4], *(any_double(k % 4) for _ in range(3)))
for k in range(120):
    read(KINDS[k % 4] + ", shortest digits", *(shortest(any_double(k % 4)) for _ in range(3)))
for k in range(120):
    read(KINDS[k % 4] + ", 25 digits", *("%.24e" % any_double(k % 4) for _ in range(3)))
for k in range(60):
    x = abs(any_double(2 if k % 2 else 3)) + 1.0
    if x < 2.0 ** 52:
        read("tie of two doubles, just above, just below", *middle(x))
for k, name in enumerate(("xyz", "ply-ascii", "ply", "ply-big", "null")):
    print("cloud_name", "exact", "name" if k < 4 else "past the last", k, name, sep="\t")
