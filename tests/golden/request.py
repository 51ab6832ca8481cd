"""Golden rows of conform/request: the table of docs/conformance.md once more, and lines read and written by its rules."""
from fractions import Fraction as F

from rational import head, nearest, row

SIDE, ALONG = ("any", "right", "left"), ("u", "v")
METHOD, RULE = ("uniform", "chord", "centripetal", "exponential"), ("piegl", "averaging", "faithful", "uniform")
CURVE, SURFACE = ["c", "R", "P", "R"], ["c", "c", "R", "R", "P", "R"]
OPS = [
    ("span", ["c", "R", "r"]), ("multiplicity", ["R", "r"]), ("greville", ["c", "R"]), ("basis", ["c", "R", "r", SIDE]),
    ("basis_ders", ["c", "R", "r", SIDE, "c"]), ("curve_point", CURVE + ["r", SIDE]), ("curve_ders", CURVE + ["r", SIDE, "c"]),
    ("surface_point", SURFACE + ["r", "r", SIDE, SIDE]), ("surface_ders", SURFACE + ["r", "r", SIDE, SIDE, "c"]), ("surface_normal", SURFACE + ["r", "r"]),
    ("curve_insert", CURVE + ["r", "c"]), ("curve_remove", CURVE + ["r", "c", "r"]), ("curve_elevate", CURVE + ["c"]),
    ("surface_insert", SURFACE + [ALONG, "r", "c"]), ("surface_remove", SURFACE + [ALONG, "r", "c", "r"]), ("surface_elevate", SURFACE + [ALONG, "c"]),
    ("parameters", [METHOD, "P"]), ("parameters_grid", [METHOD, "c", "c", "P"]), ("knots", [RULE, "c", "c", "R"]), ("fit_curve", ["c", "R", "R", "P"]),
    ("fit_grid", [("free", "interpolated"), "c", "c", "R", "R", "R", "R", "P"]), ("fit_scattered", ["c", "c", "R", "R", "R", "R", "P"]),
    ("approximate", ["c"] * 6 + ["P"]), ("curve_nearest", CURVE + ["P"]), ("surface_nearest", SURFACE + ["P"]), ("surface_error", SURFACE + ["R", "R", "P"]),
    ("net_counts", ["c", "c"]), ("net_class", ["c"] * 5), ("net_node", ["c"] * 3), ("seam_gap", SURFACE + SURFACE + ["c"]),
]
EFORMAT = 2


def codes(text):
    return [ord(c) for c in text]


def number(word):
    """The double that a word names, by rationals."""
    low = word.lower()
    sign = -1.0 if low.startswith("-") else 1.0
    low = low.lstrip("+-")
    if low in ("inf", "infinity"):
        return sign * float("inf")
    if low == "nan":
        return float("nan")
    if low.startswith("0x"):
        digits, _, power = low[2:].partition("p")
        whole, _, part = digits.partition(".")
        value = F(int(whole + part, 16), 16 ** len(part)) * F(2) ** int(power or 0)
    else:
        value = F(low)
    return sign * nearest(value)


def hexed(x):
    """C's %a."""
    if x != x or x in (float("inf"), -float("inf")):
        return "nan" if x != x else "inf" if x > 0 else "-inf"
    sign = "-" if str(x).startswith("-") else ""
    if x == 0:
        return sign + "0x0p+0"
    m, e = abs(x).hex()[2:].split("p")
    m = m.rstrip("0").rstrip(".") if "." in m else m
    return "%s0x%sp%s" % (sign, m, e)


def read(line):
    """Numbers and normal form of a right line."""
    words = line.split()
    op, words = dict(OPS)[words[0]], iter(words[1:])
    name, seen, text = line.split()[0], [], []
    for kind in op:
        n = 1
        if isinstance(kind, tuple):
            word = next(words)
            seen.append(kind.index(word))
            text.append(word)
            continue
        if kind in "cRP":
            n = int(next(words))
            seen.append(n)
            text.append(str(n))
        for _ in range({"c": 0, "r": 1, "R": n, "P": 3 * n}[kind]):
            x = number(next(words))
            seen.append(x)
            text.append(hexed(x))
    return seen, " ".join([name] + text)


def main():
    head("request", "operations, their arguments, and the lines of requests")
    for k, (name, kinds) in enumerate(OPS):
        row("request_name", "exact", "operation %d" % k, [k], codes(name))
        row("request_find", "exact", "its name", [name], [k])
        for j, kind in enumerate(kinds):
            row("request_argument", "exact", "argument %d of %s" % (j, name), [k, j], ["crRP".index(kind), 0] if isinstance(kind, str) else [4, len(kind)])
        row("request_argument", "exact", "past the last of %s" % name, [k, len(kinds)], [9])
    row("request_name", "exact", "past the last", [30], [0])
    row("request_argument", "exact", "past the last operation", [30, 0], [9])
    for name in ("spa", "spann", "Span", "hello", "curve_points", "curve"):
        row("request_find", "exact", "no operation", [name], [30])
    good = [
        ("span 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p-1", "hex floats"), ("span 0 2 0 1 0.5", "decimals"), ("multiplicity 3 0 -0 -0x0p+0 -0.0", "zeros have signs"),
        ("multiplicity 2 inf -inf nan", "what is not finite"), ("multiplicity 1 +INF -Infinity", "capitals"), ("multiplicity 0 NaN", "no numbers"),
        ("multiplicity 1 0x1.fffffffffffff8p+0 0x1.00000000000008p+0", "more than 53 bits, ties"),
        ("multiplicity 1 0x1.fffffffffffff7ffp+0 0x1.000000000000080001p+0", "more than 53 bits, near ties"),
        ("multiplicity 1 0x1p-1074 0x0.0000000000001p-1022", "the least number"), ("multiplicity 1 0x1p-1075 0x1.8p-1075", "below the least number"),
        ("multiplicity 1 0x1p+1024 -1e400", "beyond the greatest number"), ("multiplicity 1 1e-400 0.1", "decimals are rounded"),
        ("multiplicity 1 1.7976931348623157e308 2.2250738585072014e-308", "the ends of the range"), ("multiplicity 1 0X1.8P+1 0x.8p1", "other hex floats"),
        ("basis 1 4 0 0 1 1 0.25 left", "a word"), ("basis_ders 1 4 0 0 1 1 0.25 right 2", "a count behind a word"),
        ("curve_point 1 4 0 0 1 1 2 1 2 3 4 5 6 0 0.5 any", "a polynomial curve"), ("curve_point 1 4 0 0 1 1 2 1 2 3 4 5 6 2 1 0.5 0.5 any", "a rational curve"),
        ("curve_point 9007199254740992 0 0 0 0 any", "the greatest count"), ("curve_ders 1 1 7 2 1 2 3 4 5 6 3 1 2 3 0 any 0", "counts that do not fit are no fault of the line"),
        ("surface_insert 1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 1 0 0 0 1 0 1 1 0 0 v 0.5 1", "a surface"), ("parameters chord 2 0 0 0 1 0 0", "points"),
        ("parameters_grid exponential 2 1 2 0 0 0 1 0 0", "a grid"), ("knots faithful 1 2 2 0 1", "a rule"), ("knots uniform 1 2 0", "the same word elsewhere"),
        ("fit_grid interpolated 1 1 0 0 0 0 0", "nothing in it"), ("net_class 4 5 1 2 3", "counts alone"), ("net_node 4 5 6", "counts alone"),
    ]
    for line, reason in good:
        seen, text = read(line)
        row("request_parse", "exact", reason, line.split(" "), [0] + seen)
        row("request_print", "exact", reason, line.split(" "), codes(text))
    for line, reason in [
        ("fold 1", "no operation"), ("span", "nothing behind it"), ("span 1 4 0 0 1 1", "one word too few"), ("span 1 4 0 0 1 1 0 0", "one word too many"),
        ("span -1 2 0 1 0", "a negative count"), ("span 1.0 2 0 1 0", "a real for a count"), ("span 0x1 2 0 1 0", "a hex count"), ("span +1 2 0 1 0", "a sign before a count"),
        ("span 9007199254740993 2 0 1 0", "above 2^53"), ("span 99999999999999999999999999 2 0 1 0", "far above 2^53"),
        ("multiplicity 9007199254740992 0 1 2", "a count that the line cannot hold"), ("parameters chord 9007199254740992 0 0 0", "points that the line cannot hold"),
        ("multiplicity 2 0 x 1", "not a number"), ("multiplicity 2 0 1e 1", "half a number"), ("multiplicity 2 0 0x 1", "half a hex float"),
        ("multiplicity 2 0 1,5 1", "another point"), ("multiplicity 2 0 1f 1", "a suffix"), ("basis 1 4 0 0 1 1 0.25 both", "no such word"),
        ("basis 1 4 0 0 1 1 0.25 Any", "words have no capitals"), ("basis 1 4 0 0 1 1 0.25 an", "part of a word"), ("basis 1 4 0 0 1 1 0.25", "the word is missing"),
        ("parameters chord 2 0 0 0 1 0", "a coordinate is missing"), ("surface_insert 1 1 0 0 0 0 w 0 1", "no such direction"), ("net_counts 2 2.", "a point behind a count"),
    ]:
        row("request_parse", "exact", reason, line.split(" "), [EFORMAT])


if __name__ == "__main__":
    main()
