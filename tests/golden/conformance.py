#!/usr/bin/env python3
"""golden/conformance: frozen requests of the conformance protocol, and what is right, in integers and rationals; not from Etalon.

Usage: conformance.py FOLDER [OPERATION ...]      writes FOLDER/OPERATION.json (all, if none is named)
       conformance.py --list                      the operations, slowest first
"""
import sys

import conformance_edit
import conformance_evaluate
import conformance_fit
import conformance_other

MAKERS = {"surface_ders": conformance_evaluate.surface_derivatives, "surface_normal": conformance_evaluate.normals, "surface_point": conformance_evaluate.surfaces,
          "curve_ders": conformance_evaluate.curve_derivatives, "basis_ders": conformance_evaluate.basis_derivatives, "basis": conformance_evaluate.bases,
          "curve_point": conformance_evaluate.curves, "greville": conformance_evaluate.grevilles, "span": conformance_evaluate.spans_of,
          "multiplicity": conformance_evaluate.multiplicities, "curve_insert": conformance_edit.curve_insertions, "curve_remove": conformance_edit.curve_removals,
          "curve_elevate": conformance_edit.curve_elevations, "surface_insert": conformance_edit.surface_insertions,
          "surface_remove": conformance_edit.surface_removals, "surface_elevate": conformance_edit.surface_elevations,
          "parameters": conformance_fit.parameters, "parameters_grid": conformance_fit.parameter_grids, "knots": conformance_fit.knot_rules,
          "fit_curve": conformance_fit.fit_curves, "fit_grid": conformance_fit.fit_grids, "fit_scattered": conformance_fit.fit_scatters,
          "approximate": conformance_fit.approximations, "curve_nearest": conformance_other.curve_inversions,
          "surface_nearest": conformance_other.surface_inversions, "surface_error": conformance_other.surface_errors, "net_counts": conformance_other.net_counts,
          "net_class": conformance_other.net_classes, "net_node": conformance_other.net_nodes, "seam_gap": conformance_other.seam_gaps}


def main(folder, names):
    for name in names or MAKERS:
        op = MAKERS[name]()
        assert op.name == name
        with open("%s/%s.json" % (folder, name), "w", encoding="ascii", newline="\n") as f:
            f.write(op.text())


if __name__ == "__main__":
    if sys.argv[1:] == ["--list"]:
        print("\n".join(MAKERS))
    else:
        main(sys.argv[1], sys.argv[2:])
