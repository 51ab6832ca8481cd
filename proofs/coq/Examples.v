(* The hypotheses of the theorems on knots can be met: degree 2, four control points, the knots 0 0 0 1 2 2 2 (and 2 from there on).
   Those of the double-double operations have theirs in DoubleDoubleBounds.v. *)
From Coq Require Import Reals Lra Lia Arith.
From Etalon Require Import Sums Space Basis Curve Insertion.
Open Scope R_scope.

Definition some_knots (i : nat) : R := if (i <=? 2)%nat then 0 else if (i =? 3)%nat then 1 else 2.
Ltac each i := unfold some_knots; repeat match goal with |- context [(?a <=? ?b)%nat] => destruct (Nat.leb_spec a b)
  | |- context [(?a =? ?b)%nat] => destruct (Nat.eqb_spec a b) end; try lra; try lia.

Example some_knots_are_knots : knots some_knots 2 4.
Proof. split; [intros i; each i|lia|each 2%nat]. Qed.
Example some_knots_are_clamped : clamped some_knots 2 4.
Proof. split; each 2%nat. Qed.
(* Between two knots, and once more where a knot is. *)
Example half_is_insertable : insertable some_knots 2 4 (1 / 2) 2 0.
Proof. split; try lia; try (split; each 2%nat). intros i Hi. each i. Qed.
Example one_is_insertable : insertable some_knots 2 4 1 3 1.
Proof. split; try lia; try (split; each 2%nat). - intros i Hi. each i. - intros i Hi. each i. Qed.
Example half_is_in_a_span : is_span some_knots 2 4 (1 / 2) 2.
Proof. split; try lia; try (split; each 2%nat); each 2%nat. Qed.
(* So the curve keeps its points, whatever its control points are. *)
Example half_inserted : forall P u,
  curve (insert_knot some_knots 2 (1 / 2)) 2 5 (insert_point some_knots 2 (1 / 2) 2 0 P) u = curve some_knots 2 4 P u.
Proof. intros P u. apply curve_insert; [exact some_knots_are_knots|exact half_is_insertable]. Qed.
