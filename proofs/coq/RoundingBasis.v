(* The functions whose rounding Rounding.v bounds are those of Basis.v, of which curves and surfaces are made: et_basis_eval computes, for any real x,
   the p+1 functions that are not zero within 6p - 1 roundings, and any others are 0. *)
Require Import Reals Lra Lia Arith List.
From Etalon Require Sums Basis.
From Etalon Require Import RoundingScheme Rounding.
Open Scope R_scope.

Lemma cox_is_B : forall t s x p i, cox t s x p i = Basis.B t s p i x.
Proof. intros t s x. induction p as [|p IH]; intros i; cbn [cox Basis.B]; [reflexivity|]. rewrite !IH. reflexivity. Qed.

(* The clamp of the code is that of Basis.v. *)
Lemma clamp_is_clamp : forall rnd lo hi x, clamp (A := rounded rnd) x lo hi = Sums.clamp lo hi x.
Proof.
  intros. unfold clamp, Sums.clamp. cbn [less rounded]. unfold less_R.
  destruct (Rlt_dec x lo); auto. destruct (Rlt_dec hi x); auto.
Qed.

Section Basis.
Variables (u : R) (rnd : R -> R) (t : nat -> R) (p n : nat) (x : R).
Hypothesis unit_roundoff : 0 <= u < 1.
Hypothesis error : forall y, Rabs (rnd y - y) <= u * Rabs y.
Hypothesis idem : forall y, rnd (rnd y) = rnd y.
Hypothesis valid : Basis.knots t p n.
Notation y := (Sums.clamp (t p) (t n) x).
Notation s := (Basis.span t n y).

Theorem eval_within : forall r, (r <= p)%nat ->
  within u (6 * p - 1) (nth r (basis_eval (A := rounded rnd) t (n + p + 1) p s x) 0) (Basis.basis t p n (s - p + r) x).
Proof.
  intros r Hr. unfold Basis.basis, basis_eval. replace (n + p + 1 - p - 1)%nat with n by lia. rewrite clamp_is_clamp.
  destruct valid as [M C D]. assert (Y : t p <= y <= t n) by (apply Sums.clamp_range; lra).
  destruct (Basis.span_correct t M p n y) as [S1 S2 S3 _]; auto. rewrite <- cox_is_B. apply basis_at_within; auto; lia.
Qed.
End Basis.
