#!/usr/bin/env python3
"""golden/knotrule.tsv: knots by rational arithmetic from parameters that are dyadic or rounded."""
from fractions import Fraction as F

KINDS = ["piegl", "faithful", "uniform", "averaging"]


def hexf(x):
    return float(x).hex()


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
        cls = "abs " + hexf(F(3, 2**53))
    else:
        cls = "abs " + hexf(F(p + 1, 2**53))
    args = [str(KINDS.index(kind)), str(p), str(control + p + 1), str(len(t))] + [hexf(x) for x in t]
    print("knotrule_make", cls, reason, " ".join(args), " ".join(hexf(x) for x in want), sep="\t")


def main():
    print("# function\tclass\treason\tkind p nu nt t\tinterior knots")
    print("# made by tests/golden/knotrule.py")
    for k, name in enumerate(KINDS + ["null"]):
        print("knotrule_name", "exact", "order", k, name, sep="\t")
    even = lambda n: [F(i, n - 1) for i in range(n)]
    squares = lambda n: [F(i * i * 1024 // ((n - 1) * (n - 1)), 1024) for i in range(n)]
    # The NURBS Book, example 9.1: chord parameters of five points with distances 5, 5, 3, 4 wanting cubic knots.
    book = [F(0), F(5, 17), F(9, 17), F(14, 17), F(1)]
    for kind in KINDS:
        row("example_9_1", kind, 3, 5, [F(float(x)) for x in book])
        for n, control, p in [(9, 9, 3), (17, 17, 2), (5, 5, 1)]:
            row("as_many_as_data", kind, p, control, [F(float(x)) for x in even(n)])
            row("as_many_as_data_crowded", kind, p, control, squares(n))
    for kind in KINDS[:3]:
        for n, control, p in [(20, 6, 3), (20, 18, 3), (20, 19, 3), (18, 6, 3), (30, 12, 3), (9, 5, 2), (9, 4, 1), (33, 9, 4), (10, 5, 3),
                              (12, 6, 5)]:
            row("even", kind, p, control, [F(float(x)) for x in even(n)])
            row("crowded", kind, p, control, squares(n))
        row("coincident", kind, 3, 6, [F(0)] * 5 + [F(1, 2)] * 4 + [F(1)] * 3)
        row("ulps", kind, 2, 5, [F(0), F(1, 2), F(1, 2) + F(1, 2**53), F(1, 2) + F(1, 2**52), F(3, 4), F(1)])


main()
