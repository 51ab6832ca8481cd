(* Assumptions: the definitions that the main theorems speak of, what each of them says, and the axioms it rests on: those of Coq's real numbers
   and no others.  What this file prints when it is compiled is golden, so that neither a definition nor a statement can change unseen.
   To ask for the axioms of a single theorem takes as long as for those of many, so a file's are asked for together, and a few by themselves. *)
Require Import Reals.
From Etalon Require Import Sums Space Basis Curve Insertion Surface Rational Seam Code.
Open Scope R_scope.
Set Printing Width 140.

(* ---- definitions ---- *)

Print sum.
Print frac.
Print clamp.
Print vec3.
Print comb.
Print dot.
Print affine.
Print in_hull.
Print in_hull2.
Print knots.
Print clamped.
Print indicator.
Print N.
Print B.
Print span.
Print is_span.
Print inside.
Print basis.
Print curve.
Print curve1.
Print insert_knot.
Print multiplicity.
Print insertable.
Print insert1.
Print insert_point.
Print insert_knot_times.
Print insert_times.
Print surface.
Print surface1.
Print rcurve.
Print rbasis.
Print rsurface.
Print rbasis2.
Print positive.
Print positive2.
Print zeros.
Print border_parameter.
Print border_index.
Print view.
Print on_border.
Print class.
Print net_points.
Print net_weights.
Print view_surface.
Print view_rsurface.
Print loop_basis.
Print node.

(* ---- Basis.v ---- *)

Check span_correct.
Check span_ensured.
Check N_nonneg.
Check N_support.
Check basis_is_N.
Check basis_nonneg.
Check basis_support.
Check basis_unity.
Check basis_le_1.
Check basis_first.
Check basis_last.
Check basis_ext.
Definition all_of_basis := (span_correct, span_ensured, N_nonneg, N_support, basis_is_N, basis_nonneg, basis_support, basis_unity,
  basis_le_1, basis_first, basis_last, basis_ext).
Print Assumptions all_of_basis.

(* ---- Curve.v ---- *)

Check curve_local.
Check curve_affine.
Check curve_hull.
Check curve_hull_local.
Check curve_first.
Check curve_last.
Check begins_later.
Definition all_of_curve := (curve_local, curve_affine, curve_hull, curve_hull_local, curve_first, curve_last, begins_later).
Print Assumptions all_of_curve.

(* ---- Insertion.v ---- *)

Check insertable_found.
Check curve_insert.
Check curve_insert_times.
Print Assumptions curve_insert.
Definition all_of_insertion := (insertable_found, curve_insert, curve_insert_times).
Print Assumptions all_of_insertion.

(* ---- Surface.v ---- *)

Check surface_tensor.
Check surface_affine.
Check surface_hull.
Check border_left.
Check border_right.
Check border_bottom.
Check border_top.
Check corners.
Check surface_insert_u.
Check surface_insert_v.
Definition all_of_surface := (surface_tensor, surface_affine, surface_hull, border_left, border_right, border_bottom, border_top, corners,
  surface_insert_u, surface_insert_v).
Print Assumptions all_of_surface.

(* ---- Rational.v ---- *)

Check weight_pos.
Check rbasis_nonneg.
Check rbasis_unity.
Check rcurve_affine.
Check rcurve_hull.
Check rcurve_first.
Check rcurve_last.
Check rcurve_insert.
Check weight2_pos.
Check rbasis2_nonneg.
Check rbasis2_unity.
Check rsurface_affine.
Check rsurface_hull.
Check rcorners.
Check rsurface_insert_u.
Check rsurface_insert_v.
Definition all_of_rational := (weight_pos, rbasis_nonneg, rbasis_unity, rcurve_affine, rcurve_hull, rcurve_first, rcurve_last,
  rcurve_insert, weight2_pos, rbasis2_nonneg, rbasis2_unity, rsurface_affine, rsurface_hull, rcorners,
  rsurface_insert_u, rsurface_insert_v).
Print Assumptions all_of_rational.

(* ---- Seam.v ---- *)

Check seam_left.
Check seam_right.
Check seam_bottom.
Check seam_top.
Check rational_seam_left.
Check rational_seam_right.
Check rational_seam_bottom.
Check rational_seam_top.
Check gap_otherwise.
Check shell_seam.
Check rational_shell_seam.
Check class_shared.
Check class_unique.
Check doublenet_seam.
Check doublenet_rational_seam.
Check doublenet_corners.
Print Assumptions class_unique.
Print Assumptions doublenet_seam.
Print Assumptions doublenet_rational_seam.
Definition all_of_seam := (seam_left, seam_right, seam_bottom, seam_top, rational_seam_left, rational_seam_right, rational_seam_bottom,
  rational_seam_top, gap_otherwise, shell_seam, rational_shell_seam, class_shared, class_unique, doublenet_seam, doublenet_rational_seam,
  doublenet_corners).
Print Assumptions all_of_seam.

(* ---- Code.v ---- *)

Check code_basis.
Check curve_coordinates.
Check code_curve.
Check rcurve_coordinates.
Check code_curve_rational.
Check surface_coordinates.
Check code_surface.
Check rsurface_coordinates.
Check code_surface_rational.
Check code_insert_knot.
Check code_insert.
Check code_insert_times.
Check code_seam.
Check code_seam_rational.
Definition all_of_code := (code_basis, curve_coordinates, code_curve, rcurve_coordinates, code_curve_rational, surface_coordinates, code_surface,
  rsurface_coordinates, code_surface_rational, code_insert_knot, code_insert, code_insert_times,
  code_seam, code_seam_rational).
Print Assumptions all_of_code.
