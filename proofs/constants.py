#!/usr/bin/env python3
"""One bound, one constant: what the theorems say, what the pages and headers promise, and what the programs measure against, compared: constants.py.

Each line of PLACES is a file and a pattern whose group is the number of roundings there; all of a bound's places must be found and say the same.
"""
import os
import re
import sys

ROUNDING, BINARY, ACCURACY = "proofs/coq/Rounding.v", "proofs/coq/Binary64.v", "docs/accuracy.md"
NUMBER = r"([0-9pqk *()+-]+?)"
PLACES = {
    "basis function": [
        (ROUNDING, r"Theorem basis_within : .* within \(" + NUMBER + r"\) \(N p r\)"),
        (ROUNDING, r"Theorem basis_at_within : [^.]*?within \(" + NUMBER + r"\) \(nth"),
        (BINARY, r"Theorem basis64_within : [^.]*?within u64 \(" + NUMBER + r"\) \("),
        (ACCURACY, r"\| basis function of degree p \| `et_basis_eval` \| " + NUMBER + r" roundings \|"),
        ("docs/basis.md", r"each value is the exact one times a factor between \(1-u\)\^\(" + NUMBER + r"\)"),
        ("include/etalon/spline/basis.h", r"each value is within the factors \(1-u\)\^\(" + NUMBER + r"\)"),
        ("src/spline/surface_normal.c", r"each term has " + NUMBER + r" roundings at most"),
    ],
    "sum of the basis functions": [
        (ROUNDING, r"Theorem basis_sum : .* within \(" + NUMBER + r"\) \(total"),
        (ROUNDING, r"Theorem basis_at_sum : .* within \(" + NUMBER + r"\) \(total"),
        (BINARY, r"Theorem basis64_sum : .* within u64 \(" + NUMBER + r"\) \(total"),
        (ACCURACY, r"\| sum of the basis functions \| `et_basis_eval` \| " + NUMBER + r" roundings \|"),
        ("docs/basis.md", r"sum of the computed values lies within \(1-u\)\^\(" + NUMBER + r"\)"),
        ("include/etalon/spline/basis.h", r"exact sum of the p\+1 values within \(1-u\)\^\(" + NUMBER + r"\)"),
    ],
    "derivatives of basis functions": [
        (ROUNDING, r"Theorem derivative_near : [^.]*?near \(" + NUMBER + r"\) \(derivative"),
        (BINARY, r"Theorem derivative64_near : [^.]*?near u64 \(" + NUMBER + r"\) \("),
        (ACCURACY, r"\| derivatives of basis functions \| `et_basis_ders` \| " + NUMBER + r" roundings \|"),
        ("include/etalon/spline/basis.h", r"m = " + NUMBER + r", barring over- and underflow: small relative to the largest"),
    ],
    "surface point": [
        (ROUNDING, r"Theorem surface_point_near : [^.]*?near \(" + NUMBER + r"\) \(surface_point"),
        (BINARY, r"Theorem surface_point64_near : .*?near u64 \(" + NUMBER + r"\) \(B2R b\) \(surface_point "),
        (ACCURACY, r"\| surface point, polynomial \| `et_surface_point` \| " + NUMBER + r" roundings \|"),
        ("docs/surface.md", r"m = " + NUMBER + r", barring underflow"),
        ("include/etalon/spline/surface.h", r"m = " + NUMBER + r", barring underflow"),
        ("docs/objective.md", r"is within " + NUMBER + r"u max\|P\|"),
        ("src/cli/refine.c", r"by the roundings of its surface point, " + NUMBER + r" u of"),
    ],
    "rational surface point": [
        (ROUNDING, r"Theorem surface_point_rational_near : [^.]*?near \(" + NUMBER + r"\) \(surface_point_rational"),
        (BINARY, r"near u64 \(" + NUMBER + r"\) \(B2R b\) \(surface_point_rational "),
        (ACCURACY, r"\| surface point, rational \| `et_surface_point` \| " + NUMBER + r" roundings \|"),
    ],
}
# What `make accuracy` measures against: degree d in both directions.
MEASURED = {"basis function": "6 * d - 1", "sum of the basis functions": "4 * d - 1", "derivatives of basis functions": "6 * d + 2"}
# The columns of the table of what was measured, "worst of bound".
COLUMNS = ["basis function", "sum of the basis functions", "derivatives of basis functions", "derivatives of basis functions", "surface point", "rational surface point"]
# Degree 3: Gappa's constants may be smaller, never larger.
GAPPA = {"proofs/gappa/basis3.g": 17, "proofs/gappa/basis3_knot.g": 17, "proofs/gappa/sum3.g": 11}


def plain(text):
    return re.sub(r"[ *]", "", text)


def main():
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    read = lambda f: re.sub(r"\n \*", " ", open(os.path.join(root, f)).read())
    wrong = found = 0
    for name, places in PLACES.items():
        said = {}
        for f, pattern in places:
            m = re.search(pattern, read(f), re.S)
            if not m:
                wrong += 1
                print("%s: %s says nothing (%s)" % (name, f, pattern))
            else:
                found += 1
                said.setdefault(plain(m.group(1)), []).append(f)
        if len(said) > 1:
            wrong += 1
            print("%s: %s" % (name, "; ".join("%s in %s" % (n, ", ".join(f)) for n, f in said.items())))
    measured = read("tests/bench/accuracy.c")
    for name, formula in MEASURED.items():
        found += 1
        if formula not in measured or plain(formula).replace("d", "p") != plain(re.search(PLACES[name][0][1], read(ROUNDING), re.S).group(1)):
            wrong += 1
            print("%s: tests/bench/accuracy.c does not measure against %s" % (name, formula))
    theorem = {name: re.search(PLACES[name][0][1], read(ROUNDING), re.S) for name in COLUMNS}
    rows = re.findall(r"^\| (\d+) \|(.*)\|$", read(ACCURACY).split("<!-- measured -->")[1], re.M)
    for degree, cells in rows:
        for name, cell in zip(COLUMNS, cells.split("|")):
            bound = re.search(r"of (\d+)", cell)
            found += bound is not None
            if bound and int(bound.group(1)) != eval(theorem[name].group(1), {"p": int(degree), "q": int(degree)}):
                wrong += 1
                print("%s: %s promises %s at degree %s" % (name, ACCURACY, bound.group(1), degree))
    if not rows:
        wrong += 1
        print("%s has no table of what was measured" % ACCURACY)
    for f, most in GAPPA.items():
        numbers = re.findall(r"<= ([0-9.]+e-[0-9]+)", read(f))
        found += len(numbers)
        if not numbers or max(float(n) for n in numbers) > (most + 1e-3) * 2.0**-53:
            wrong += 1
            print("%s proves %s, the pages promise %d u" % (f, " and ".join(numbers) or "nothing", most))
    print("%d places, %d wrong" % (found, wrong))
    return wrong > 0


sys.exit(main())
