#!/usr/bin/env python3
"""golden/iges.tsv: whole IGES files of small shells, formatted here from the standard's record layout (IGES 5.3, sections 2.2 and 4.23)."""


def real(x):
    """The fewest significant digits that read back as x, positional within 1e-4 .. 10^digits, else with D."""
    for digits in range(1, 18):
        mantissa, exponent = ("%.*e" % (digits - 1, x)).split("e")
        if float(mantissa + "e" + exponent) == x:
            break
    sign, figures, e = ("-" if mantissa[0] == "-" else ""), mantissa.lstrip("-").replace(".", "").rstrip("0") or "0", int(exponent)
    if -4 <= e < digits:
        if e < 0:
            return sign + "0." + "0" * (-e - 1) + figures
        figures = figures.ljust(e + 1, "0")
        return sign + figures[:e + 1] + "." + figures[e + 1:]
    return sign + figures[0] + "." + figures[1:] + "D%d" % e


def records(fields, width):
    lines, line = [], ""
    for f in fields:
        if len(line) + len(f) > width:
            lines.append(line)
            line = ""
        line += f
    return lines + [line]


def text(s):
    return "%dH%s," % (len(s), s)


def closed(s, direction):
    nu, nv, degree, knots = s["nu"], s["nv"], (s["p"], s["q"])[direction], s["uv"[direction]]
    if len(set(knots[:degree + 1])) > 1 or len(set(knots[-degree - 1:])) > 1:
        return 0
    node = lambda i, j: (s["points"][i * nv + j], s["weights"][i * nv + j] if s["weights"] else 1)
    if direction == 0:
        return int(all(node(0, j) == node(nu - 1, j) for j in range(nv)))
    return int(all(node(i, 0) == node(i, nv - 1) for i in range(nu)))


def entity(s):
    nu, nv = s["nu"], s["nv"]
    order = [i * nv + j for j in range(nv) for i in range(nu)]
    out = [128, nu - 1, nv - 1, s["p"], s["q"], closed(s, 0), closed(s, 1), int(not s["weights"]), 0, 0]
    out += [real(x) for x in s["u"] + s["v"]]
    out += [real(s["weights"][k] if s["weights"] else 1.0) for k in order]
    out += [real(x) for k in order for x in s["points"][k]]
    out += [real(x) for x in (s["u"][s["p"]], s["u"][nu], s["v"][s["q"]], s["v"][nv])]
    return ["%s," % x for x in out[:-1]] + ["%s;" % out[-1]]


def iges(shell):
    most = max(abs(x) for s in shell for p in s["points"] for x in p)
    glob = [text(","), text(";"), text("ETALON"), text("etalon.igs"), text("Etalon"), text("Etalon IGES 5.3"), "32,", "38,", "6,", "308,", "15,",
            text("ETALON"), "1.,", "2,", text("MM"), "1,", "0.,", text("20000101.000000"), real(most * 2.0**-30 if most else 2.0**-30) + ",",
            real(most) + ",", ",", ",", "11,", "0,", text("20000101.000000")[:-1] + ";"]
    start = ["Closed double surface: bottom and top, equal along the border."]
    glob = records(glob, 72)
    data = [records(entity(s), 64) for s in shell]
    out = ["%-72sS%7d" % (l, k + 1) for k, l in enumerate(start)] + ["%-72sG%7d" % (l, k + 1) for k, l in enumerate(glob)]
    first = 1
    for view, lines in enumerate(data):
        out.append("%8d%8d%8d%8d%8d%8d%8d%8d%8sD%7d" % (128, first, 0, 1, 0, 0, 0, 0, "0" * 8, 2 * view + 1))
        out.append("%8d%8d%8d%8d%8d%8s%8s%8s%8dD%7d" % (128, 0, 0, len(lines), 0, "", "", ("BOTTOM", "TOP")[view], 0, 2 * view + 2))
        first += len(lines)
    number = 0
    for view, lines in enumerate(data):
        for l in lines:
            number += 1
            out.append("%-64s %7dP%7d" % (l, 2 * view + 1, number))
    out.append("%-72sT%7d" % ("S%7dG%7dD%7dP%7d" % (len(start), len(glob), 4, number), 1))
    assert all(len(l) == 80 for l in out)
    return [l.replace(" ", "_") for l in out]


def row(reason, p, q, u, v, weights, points, offset=(0.0, 0.0, 0.0), scale=(1.0, 1.0, 1.0)):
    """weights and points: a pair, bottom and top; the frame's arithmetic is exact in every row (or its rounding is Python's, the same IEEE)."""
    nu, nv = len(u) - p - 1, len(v) - q - 1
    args, shell = [p, q, nu, nv, int(weights is not None)], []
    for view in range(2):
        w = weights[view] if weights else None
        args += [float(x).hex() for x in u + v + (w or [])] + [float(x).hex() for pt in points[view] for x in pt]
        own = [tuple(o + s * float(x) for o, s, x in zip(offset, scale, pt)) for pt in points[view]]
        shell.append({"p": p, "q": q, "nu": nu, "nv": nv, "u": [float(x) for x in u], "v": [float(x) for x in v], "weights": w, "points": own})
    args += [x.hex() for x in offset + scale]
    print("iges_write", "exact", reason, " ".join(map(str, args)), " ".join(iges(shell)), sep="\t")


def flat(nu, nv, z):
    return [(i / (nu - 1), j / (nv - 1), z) for i in range(nu) for j in range(nv)]


L2, L3 = [0, 0, 1, 1], [0, 0, 0.5, 1, 1]
print("# function\tclass\treason\tp q nu nv rational, views' knots, weights, points, frame\tthe records, _ for a blank")
print("# made by tests/golden/iges.py")
row("two_bilinear_squares", 1, 1, L2, L2, None, (flat(2, 2, 0.0), flat(2, 2, 0.0)))
row("frame", 1, 1, L2, L2, None, (flat(2, 2, 0.5), flat(2, 2, 0.5)), (10.0, -20.0, 0.25), (2.0, 4.0, 8.0))
row("all_zero", 1, 1, L2, L2, None, ([(0.0, 0.0, 0.0)] * 4,) * 2)
row("rational", 1, 1, L2, L2, ([1.0, 2.0, 0.5, 0.1], [1.0, 2.0, 0.5, 0.1]), (flat(2, 2, 0.0), flat(2, 2, 0.0)))
row("first_index_fastest", 1, 1, L3, L2, ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0],) * 2, ([(i, 10 * j, 0) for i in range(3) for j in range(2)],) * 2)
row("closed_in_u", 1, 1, L3, L2, None, ([(0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0), (0, 0, 0), (0, 1, 0)], flat(3, 2, 1.0)))
row("closed_in_v", 1, 1, L2, L3, None, ([(0, 0, 0), (0, 1, 0), (0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 0, 0)], flat(2, 3, 1.0)))
row("equal_points_unequal_weights", 1, 1, L2, L3, ([1.0, 1.0, 2.0, 1.0, 1.0, 1.0],) * 2, ([(0, 0, 0), (0, 1, 0), (0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 0, 0)],) * 2)
row("not_clamped", 1, 1, [-0.5, 0, 1, 1.5], L2, None, ([(0, 0, 0), (0, 1, 0)] * 2,) * 2)
row("quadratic_in_u", 2, 1, [0, 0, 0, 1, 1, 1], L2, None, (flat(3, 2, 0.0), flat(3, 2, 1.0)))
row("bicubic", 3, 3, [0] * 4 + [0.3] + [1] * 4, [0] * 4 + [1] * 4, None, (flat(5, 4, 0.0), flat(5, 4, 1.0)))
for name, xs in {
    "seventeen_digits": (0.1 + 0.2, 1 / 3, 2 / 3, -1 / 3), "large_and_small": (1e300, 1e-300, 5e-324, 1.7976931348623157e308),
    "negative": (-1.0, -0.5, -1e-5, -123456789.0), "near_the_switch": (0.0001, 0.00001, 0.00012345, 0.000099999),
    "integers": (10.0, 100.0, 1e15, 123456.0), "powers_of_two": (2.0**-44, 2.0**53, 2.0**-1022, 2.0**100),
    "neighbours_of_one": (1 - 2.0**-53, 1 + 2.0**-52, 1.0, 0.99), "tenths": (0.1, 0.7, 9.5, 99.75),
    "sixteen_digits": (9007199254740993.0, 5.684341886080802e-14, 9.5367431640625e-07, 4.35),
}.items():
    row(name, 1, 1, L2, L2, None, ([(xs[0], xs[1], xs[2]), (xs[3], 0.0, 0.0), (0.0, xs[0], 1.0), (1.0, 1.0, xs[3])], [(x, 0.0, 0.0) for x in xs]))
row("knots_an_ulp_apart", 1, 1, [0, 0, 0.5, 0.5 + 2.0**-53, 1, 1], L2, None, (flat(4, 2, 0.0), flat(4, 2, 1.0)))
row("lines_full_to_column_64", 1, 1, L2, [0, 0] + [k / 64 for k in range(1, 40)] + [1, 1], None, (flat(2, 41, 0.0), flat(2, 41, 1.0)))
