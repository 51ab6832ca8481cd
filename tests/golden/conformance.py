#!/usr/bin/env python3
"""golden/conformance: frozen requests of the conformance protocol, and what is right, in integers and rationals; not from Etalon.

Usage: conformance.py OPERATION                   prints OPERATION.json
       conformance.py --all FOLDER                writes them all
       conformance.py --list                      the operations, slowest first
       conformance.py --check FOLDER              each file there against FOLDER/schema.json; enough vectors, of every category
"""
import sys

import conformance_edit
import conformance_evaluate
import conformance_fit
import conformance_other
import conformance_schema
from conformance_base import CATEGORIES

MAKERS = {"seam_gap": conformance_other.seam_gaps, "curve_nearest": conformance_other.curve_inversions,
          "curve_elevate": conformance_edit.curve_elevations, "curve_ders": conformance_evaluate.curve_derivatives,
          "fit_scattered": conformance_fit.fit_scatters, "fit_curve": conformance_fit.fit_curves,
          "basis_ders": conformance_evaluate.basis_derivatives, "surface_normal": conformance_evaluate.normals,
          "fit_grid": conformance_fit.fit_grids, "surface_insert": conformance_edit.surface_insertions, "curve_point": conformance_evaluate.curves,
          "surface_ders": conformance_evaluate.surface_derivatives, "surface_point": conformance_evaluate.surfaces,
          "surface_error": conformance_other.surface_errors, "curve_insert": conformance_edit.curve_insertions, "basis": conformance_evaluate.bases,
          "greville": conformance_evaluate.grevilles, "span": conformance_evaluate.spans_of, "multiplicity": conformance_evaluate.multiplicities,
          "curve_remove": conformance_edit.curve_removals, "surface_remove": conformance_edit.surface_removals,
          "surface_elevate": conformance_edit.surface_elevations, "parameters": conformance_fit.parameters,
          "parameters_grid": conformance_fit.parameter_grids, "knots": conformance_fit.knot_rules, "approximate": conformance_fit.approximations,
          "surface_nearest": conformance_other.surface_inversions, "net_counts": conformance_other.net_counts,
          "net_class": conformance_other.net_classes, "net_node": conformance_other.net_nodes}


LEAST = 5000


def text_of(name):
    op = MAKERS[name]()
    assert op.name == name
    return op.text()


def check(folder):
    good, count = conformance_schema.check(["%s/%s.json" % (folder, name) for name in MAKERS], folder + "/schema.json")
    for what, ok in (("the validator finds what is planted", conformance_schema.bites(folder + "/schema.json")),
                     ("%d vectors" % sum(count.values()), sum(count.values()) >= LEAST),
                     ("of every category: " + ", ".join("%s %d" % (c, count.get(c, 0)) for c in CATEGORIES),
                      all(count.get(c, 0) for c in CATEGORIES))):
        print("%s %s" % ("ok" if ok else "FAIL", what))
        good = good and ok
    return good


def main(words):
    if words == ["--list"]:
        print("\n".join(MAKERS))
    elif words[:1] == ["--check"] and len(words) == 2:
        return 0 if check(words[1]) else 1
    elif words[:1] == ["--all"] and len(words) == 2:
        for name in MAKERS:
            with open("%s/%s.json" % (words[1], name), "w", encoding="ascii", newline="\n") as f:
                f.write(text_of(name))
    elif len(words) == 1 and words[0] in MAKERS:
        sys.stdout.write(text_of(words[0]))
    else:
        sys.exit(__doc__)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
