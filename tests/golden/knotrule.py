#!/usr/bin/env python3
"""golden/knotrule.tsv: knots by rational arithmetic from parameters that are dyadic or rounded.

Bounds: PIEGL 3u t, an average of p parameters (p + 1) u; half an ulp, u at most, for the wanted value.
"""
from fractions import Fraction as F

from rational import Choices, bound_of, nearest, show

KINDS = ["piegl", "faithful", "uniform", "averaging"]
EINVAL = 1


def knots(kind, p, control, t):
    spans, out = control - p, []
    for j in range(1, spans):
        if kind == "piegl":
            jd = F(j * len(t), spans)
            i = jd.numerator // jd.denominator
            alpha = jd - i
            out.append((1 - alpha) * t[i - 1] + alpha * t[i])
        elif kind == "uniform":
            out.append(F(j, spans))
        else:
            out.append(sum(t[j:j + p]) / p)
    return out


def row(reason, kind, p, control, t):
    t = [F(x) for x in t]
    want = knots(kind, p, control, t)
    if not want:
        return
    dyadic = all(1024 % x.denominator == 0 for x in t)
    if kind == "uniform" or (kind != "piegl" and dyadic):
        cls = "exact"                      # exact sums, one rounding
    elif kind == "piegl":
        cls = "abs " + bound_of(F(4, 2**53))
    else:
        cls = "abs " + bound_of(F(p + 2, 2**53))
    args = [str(KINDS.index(kind)), str(p), str(control + p + 1), str(len(t))] + [show(nearest(x)) for x in t]
    print("knotrule_make", cls, reason, " ".join(args), " ".join(show(nearest(x)) for x in want), sep="\t")


def status(reason, kind, p, nu, t):
    bad = p < 1 or nu < 2 * p + 2 or len(t) < 2 or kind > 3 or (kind == 3 and nu - p - 1 != len(t)) or (kind < 2 and nu - p - 1 > len(t))
    args = [str(kind), str(p), str(nu), str(len(t))] + [show(x) for x in t]
    print("knotrule_make_status", "exact", reason, " ".join(args), EINVAL if bad else 0, sep="\t")


def first():
    even = lambda n: [F(i, n - 1) for i in range(n)]
    squares = lambda n: [F(i * i * 1024 // ((n - 1) * (n - 1)), 1024) for i in range(n)]
    # The NURBS Book, example 9.1: chord parameters of five points with distances 5, 5, 3, 4 wanting cubic knots.
    book = [F(0), F(5, 17), F(9, 17), F(14, 17), F(1)]
    for kind in KINDS:
        row("example 9.1", kind, 3, 5, [F(float(x)) for x in book])
        for n, control, p in [(9, 9, 3), (17, 17, 2), (5, 5, 1)]:
            row("as many as data", kind, p, control, [F(float(x)) for x in even(n)])
            row("as many as data, crowded", kind, p, control, squares(n))
    for kind in KINDS[:3]:
        for n, control, p in [(20, 6, 3), (20, 18, 3), (20, 19, 3), (18, 6, 3), (30, 12, 3), (9, 5, 2), (9, 4, 1), (33, 9, 4), (10, 5, 3),
                              (12, 6, 5)]:
            row("even", kind, p, control, [F(float(x)) for x in even(n)])
            row("crowded", kind, p, control, squares(n))
        row("repeated sites", kind, 3, 6, [F(0)] * 5 + [F(1, 2)] * 4 + [F(1)] * 3)
        row("one ulp apart", kind, 2, 5, [F(0), F(1, 2), F(1, 2) + F(1, 2**53), F(1, 2) + F(1, 2**52), F(3, 4), F(1)])


def sites(c, n, how):
    """n parameters from 0 to 1, non-decreasing, doubles."""
    if how == "random":
        t = [c.real(0, 1) for _ in range(n - 2)]
    elif how == "short":
        t = [c.short(0, 1, 32) for _ in range(n - 2)]
    elif how == "repeated sites":
        some = [c.short(0, 1, 16) for _ in range(3)]
        t = [c.of(some) for _ in range(n - 2)]
    elif how == "one ulp apart":
        a = c.real(0.1, 0.9)
        t = [a * (1 + c.upto(3) * 2.0**-52) for _ in range(n - 2)]
    elif how == "end of domain":
        t = [c.of((0.0, 1.0, 1 - 2.0**-53, 2.0**-53)) for _ in range(n - 2)]
    else:                                                  # extreme scale
        t = [c.of((2.0**-1074, 2.0**-1000, 1e-160, 0.5, 1e-16)) for _ in range(n - 2)]
    return [0.0] + sorted(t) + [1.0]


def drawn(c):
    for how in ("random", "short", "repeated sites", "one ulp apart", "end of domain", "extreme scale"):
        for _ in range(28):
            n = c.between(3, 20)
            p = c.between(1, min(5, n - 1))
            control = c.between(min(p + 2, n), n)
            t = sites(c, n, how)
            for kind in KINDS[:2] + (["averaging"] if control == n else []):
                row(how, kind, p, control, t)
    for p in range(1, 26):                                 # degrees, and uniform knots of many spans
        n = p + c.between(2, 6)
        row("degree %d" % p, "averaging", p, n, sites(c, n, "random"))
        row("degree %d" % p, "piegl", p, n - 1, sites(c, n, "short"))
        if 2 * p + 8 < 64:
            row("degree %d" % p, "uniform", p, p + 7, [0.0, 1.0])
    for spans in range(2, 50):
        row("uniform, %d spans" % spans, "uniform", 1 + spans % 3, spans + 1 + spans % 3, [0.0, 1.0])


def refused(c):
    for kind in range(5):
        for p, nu, n, why in ((0, 4, 4, "degree 0"), (1, 3, 4, "too few coefficients"), (3, 7, 9, "too few coefficients"), (3, 8, 4, "fewest"),
                              (3, 8, 1, "too few parameters"), (3, 8, 0, "too few parameters"), (3, 9, 5, "as many as data"),
                              (3, 10, 5, "more coefficients than data"), (3, 9, 9, "fewer coefficients than data"),
                              (2, 40, 5, "more coefficients than data"),
                              (25, 52, 26, "degree 25"), (25, 51, 26, "degree 25, too few coefficients")):
            status(why + (", unknown kind" if kind > 3 else ""), kind, p, nu, sites(c, n, "short") if n > 1 else [0.0] * n)


def main():
    print("# knotrule: knots from parameters\n# Written by tests/golden/knotrule.py from exact arithmetic; not from Etalon.")
    print("# function\tclass\treason\tkind p nu nt t\tinterior knots; or the status")
    for k, name in enumerate(KINDS + ["null"]):
        print("knotrule_name", "exact", "order", k, name, sep="\t")
    c = Choices(23)
    first()
    drawn(c)
    refused(c)


main()
