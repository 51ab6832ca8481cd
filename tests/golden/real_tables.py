#!/usr/bin/env python3
"""The tables and constants of src/base/real_exp.c, real_log.c and real_trig.c, from integers.

Usage: real_tables.py exp | log | trig   prints src/base/real_exp_table.h and so on
       real_tables.py check             compares the files with what it would print
"""
import os
import sys
from fractions import Fraction as F

from elementary import LN2, PI, double, exp_of, ln2, log_of, pi, sine_of
from rational import show

W = 300


def cut(q, bits):
    """The multiple of 2^-bits nearest to q, which is then a double."""
    n = round(q * 2**bits)
    assert abs(n) < 2**53
    return F(n, 2**bits)


def parts(q, *bits):
    """q as a sum: multiples of 2^-bits in turn, and the double nearest to the rest."""
    said = []
    for b in bits:
        said.append(cut(q, b))
        q -= said[-1]
    return [show(double(x)) for x in said] + [show(double(q))]


def value(v, e, q):
    return F(v) * F(2) ** q


def power_of_two(t):
    return value(*exp_of((ln2(W) * t.numerator) // t.denominator, 2, W))


def sine(j):
    """sin(j pi / 512)."""
    at = lambda i, start: F(sine_of((pi(W) * i) // 512, W, start)[0], 2**W)
    return F(1) if j == 256 else at(j, 1) if j <= 128 else at(256 - j, 0)


def lines(what, name, rows, width):
    yield "/* %s */" % what
    yield "static const double %s[%d][%d] = {" % (name, len(rows), width)
    for r in rows:
        yield "    {%s}," % ", ".join(r)
    yield "};"


def constant(what, name, text):
    return "static const double %s = %s; /* %s */" % (name, text, what)


def exp_table():
    yield from lines("2^(i/128): a multiple of 2^-25, and the rest.", "exp_table", [parts(power_of_two(F(i, 128)), 25) for i in range(128)], 2)
    a, b = parts(LN2 / 128, 42)
    yield constant("128 / ln 2", "exp_steps", show(double(128 / LN2)))
    yield constant("ln 2 / 128: a multiple of 2^-42 ...", "exp_step", a)
    yield constant("... and the rest", "exp_step_rest", b)


def interval(i):
    """The bounds of m with index i: 11/16 + i/256 and 1/256 more below 1, twice as wide above."""
    return (F(176 + i, 256), F(177 + i, 256)) if i < 80 else (F(48 + i, 128), F(49 + i, 128))


def log_row(i):
    low, high = interval(i)
    c = F(1) if low == 1 or high == 1 else cut(2 / (low + high), 12)
    assert all(abs(c * m - 1) <= F(1, 128 if c == 1 else 239) for m in (low, high))
    return [show(double(c))] + (["0x0p+0", "0x0p+0"] if c == 1 else parts(-value(*log_of(c, W)), 42))


def log_table():
    yield from lines("c near 1/m, a multiple of 2^-12; -ln c: a multiple of 2^-42, and the rest.", "log_table", [log_row(i) for i in range(128)], 3)
    a, b = parts(LN2, 42)
    yield constant("ln 2: a multiple of 2^-42 ...", "log_2", a)
    yield constant("... and the rest", "log_2_rest", b)
    third = [double(F(1, 3)), double(F(1, 3) - F(double(F(1, 3))))]
    yield "static const et_dd log_third = {%s}; /* 1/3 */" % ", ".join(show(x) for x in third)


def trig_table():
    yield from lines("sin(j pi / 512): a multiple of 2^-26, and the rest.", "sine_table", [parts(sine(j), 26) for j in range(257)], 2)
    a, b, c = parts(PI / 512, 39, 72)
    yield constant("512 / pi", "sine_steps", show(double(512 / PI)))
    yield constant("pi / 512: a multiple of 2^-39 ...", "sine_step1", a)
    yield constant("... a multiple of 2^-72 ...", "sine_step2", b)
    yield constant("... and the rest", "sine_step3", c)


TABLES = {"exp": exp_table, "log": log_table, "trig": trig_table}


def text(name):
    guard = "BASE_REAL_%s_TABLE_H" % name.upper()
    first = ["/* Written by tests/golden/real_tables.py; not to be edited. */", "#ifndef " + guard, "#define " + guard] + (['#include "etalon/base/dd.h"'] if name == "log" else [])
    return "\n".join(first + list(TABLES[name]()) + ["#endif", ""])


def check():
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "src", "base")
    wrong = [n for n in TABLES if open(os.path.join(root, "real_%s_table.h" % n)).read() != text(n)]
    print("real tables: " + ("differ: " + ", ".join(wrong) if wrong else "as computed"))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(check() if sys.argv[1] == "check" else print(text(sys.argv[1]), end=""))
