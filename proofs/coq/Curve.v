(* Curve: B-spline curves of any degree, C(x) = sum_i N_i,p(x) P_i (etalon/spline/curve.h; rational ones: Rational.v).

   A curve has degree p, knots t and control points P_0 .. P_(n-1) in space; x outside the domain is clamped to it, so what is said holds for
   all real x. *)
Require Import Reals Lra Lia Arith.
From Etalon Require Import Sums Space Basis.
Open Scope R_scope.

Definition curve (t : nat -> R) (p n : nat) (P : nat -> vec3) (x : R) : vec3 := comb n (fun i => basis t p n i x) P.

(* The same of numbers: a coordinate, or the weights of a rational curve. *)
Definition curve1 (t : nat -> R) (p n : nat) (f : nat -> R) (x : R) : R := sum (fun i => basis t p n i x * f i) n.

Section Curve.
Variables (t : nat -> R) (p n : nat).
Hypothesis K : knots t p n.

Let M := knots_mono t p n K.

(* What et_curve_point computes: the p+1 terms of the span, from the first on. *)
Theorem curve_local : forall P x s, is_span t p n (inside t p n x) s ->
  curve t p n P x = comb (S p) (fun r => B t s p (s - p + r) (inside t p n x)) (fun r => P (s - p + r)%nat).
Proof.
  intros P x s H. assert (E : forall i, basis t p n i x = B t s p i (inside t p n x)) by (intros; now apply basis_at).
  destruct H as [Hr _ _ _]. unfold curve, comb. f_equal;
    (rewrite <- (B_sum_local t s p n) with (f := fun i => _ (P i)) by auto; apply sum_ext; intros; now rewrite E).
Qed.

(* Affine invariance: to map the curve, map its control points. *)
Theorem curve_affine : forall a b c o P x, affine a b c o (curve t p n P x) = curve t p n (fun i => affine a b c o (P i)) x.
Proof. intros. apply comb_affine. now apply basis_unity. Qed.

(* The curve lies in the convex hull of its control points ... *)
Theorem curve_hull : forall P x, in_hull n P (curve t p n P x).
Proof.
  intros P x. exists (fun i => basis t p n i x). repeat split; auto.
  - intros; now apply basis_nonneg.
  - now apply basis_unity.
Qed.

(* ... and more: in that of the p+1 points of the span. *)
Theorem curve_hull_local : forall P x s, is_span t p n (inside t p n x) s ->
  in_hull (S p) (fun r => P (s - p + r)%nat) (curve t p n P x).
Proof.
  intros P x s H. exists (fun r => B t s p (s - p + r) (inside t p n x)). rewrite (curve_local P x s H).
  destruct H. repeat split; auto.
  - intros; now apply B_nonneg.
  - apply B_unity_local; auto; lia.
Qed.

(* Its ends are the ends of the control polygon, where the knots are clamped. *)
Theorem curve_first : forall P, clamped t p n -> curve t p n P (t p) = P O.
Proof.
  intros P C. assert (p < n)%nat by apply K. apply comb_single; [lia| |]; intros; rewrite basis_first by auto; [reflexivity|].
  destruct (Nat.eqb_spec k 0); [contradiction|reflexivity].
Qed.

Theorem curve_last : forall P, clamped t p n -> curve t p n P (t n) = P (n - 1)%nat.
Proof.
  intros P C. assert (p < n)%nat by apply K. apply comb_single; [lia| |]; intros; rewrite basis_last by auto.
  - now rewrite Nat.eqb_refl.
  - destruct (Nat.eqb_spec k (n - 1)); [contradiction|reflexivity].
Qed.

(* In general, with the first knots equal, it is control point s - p, s the span at the end of the domain: not the first one, if its knot
   stands more than p+1 times. *)
Theorem curve_at_left : forall P s, t O = t p -> is_span t p n (t p) s -> curve t p n P (t p) = P (s - p)%nat.
Proof.
  intros P s HL H. assert (E := basis_at_left t p n K HL s H). destruct H as [Hr _ _ _].
  apply comb_single; [lia| |]; intros; rewrite E.
  - replace (s - p + p)%nat with s by lia. now rewrite Nat.eqb_refl.
  - destruct (Nat.eqb_spec (k + p) s); [lia|reflexivity].
Qed.

Theorem curve_at_right : forall P s, t n = t (n + p)%nat -> is_span t p n (t n) s -> curve t p n P (t n) = P s.
Proof.
  intros P s HR H. assert (E := basis_at_right t p n K HR s H). destruct H as [Hr _ _ _].
  apply comb_single; [lia| |]; intros; rewrite E.
  - now rewrite Nat.eqb_refl.
  - destruct (Nat.eqb_spec k s); [contradiction|reflexivity].
Qed.
End Curve.

(* The curve depends on its n+p+1 knots and n control points alone. *)
Theorem curve_ext : forall t t' p n P P' x, (p < n)%nat -> (forall j, (j <= n + p)%nat -> t j = t' j) ->
  (forall i, (i < n)%nat -> P i = P' i) -> curve t p n P x = curve t' p n P' x.
Proof. intros. apply comb_ext. intros; split; auto. now apply basis_ext. Qed.

(* ---- that end knots stand no more than p+1 times is needed ---- *)

(* Knots 0 0 0 1 1 1 ... of a curve of degree 1 with 3 control points: the first two are equal and the last two, but 0 stands three times. *)
Definition zeros (i : nat) : R := if le_lt_dec i 2 then 0 else 1.

Lemma zeros_knots : knots zeros 1 3.
Proof.
  unfold zeros. split; [|lia|simpl; lra]. intros i. destruct (le_lt_dec i 2), (le_lt_dec (S i) 2); try lia; lra.
Qed.

(* The curve begins at its second control point. *)
Theorem begins_later : zeros 0 = zeros 1 /\ zeros 3 = zeros (3 + 1) /\ forall P, curve zeros 1 3 P (zeros 1) = P 1%nat.
Proof.
  repeat split. intros P. apply (curve_at_left _ 1 3 zeros_knots P 2); auto.
  unfold zeros. split; [lia| | |]; simpl; intros; lra.
Qed.
