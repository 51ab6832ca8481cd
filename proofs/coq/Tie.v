(* The model is the code: et_basis_eval's loops as RoundingScheme.v writes them down, run on the processor's binary64 numbers inside Coq, give the
   bits the C code gives, on all rows of TieRows.v (tie.py: the inputs of golden/basis.tsv and more; the C code's own answers); so do, on some
   two hundred rows each, the loops of derivatives, curve points and knot insertion.

   Trusted here: that Coq's primitive floats are the processor's, which vm_compute uses, and the axioms of Coq.Floats.FloatAxioms, by which
   Flocq.IEEE754.PrimFloat says what they are (sub_equiv, ... below): Prim2SF_valid, SF2Prim_Prim2SF, Prim2SF_SF2Prim, eqb_spec, ltb_spec, add_spec,
   sub_spec, mul_spec, div_spec, and Leibniz.eqb_spec. *)
From Coq Require Import List Arith Reals Floats Uint63.
From Flocq Require Import IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Etalon Require Import RoundingScheme Rounding Binary64 TieRows.
Import ListNotations.

Definition machine : arithmetic :=
  Arithmetic PrimFloat.float PrimFloat.zero PrimFloat.one PrimFloat.add PrimFloat.sub PrimFloat.mul PrimFloat.div PrimFloat.ltb PrimFloat.eqb.

(* ---- the rows ---- *)

Definition machine_eval (p : nat) (u : list PrimFloat.float) (span : nat) (x : PrimFloat.float) : list PrimFloat.float :=
  basis_eval (A := machine) (fun i => nth i u PrimFloat.zero) (length u) p span x.

Fixpoint same_bits (a b : list PrimFloat.float) : bool :=
  match a, b with
  | [], [] => true
  | x :: a', y :: b' => (PrimFloat.Leibniz.eqb x y && same_bits a' b')%bool
  | _, _ => false
  end.
Definition holds (block : nat * list PrimFloat.float * list (nat * PrimFloat.float * list PrimFloat.float)) : bool :=
  let '(p, u, cases) := block in forallb (fun '(span, x, want) => same_bits (machine_eval p u span x) want) cases.

Theorem all_rows_hold : forallb holds rows = true.
Proof. vm_compute. reflexivity. Qed.

Theorem rows_enough : 2000 <=? list_sum (map (fun '(_, _, cases) => length cases) rows) = true.
Proof. vm_compute. reflexivity. Qed.

Lemma same_bits_equal : forall a b, same_bits a b = true -> a = b.
Proof.
  induction a as [|x a IH]; destruct b as [|y b]; try easy. cbn. intros H. apply andb_prop in H as [H1 H2].
  apply FloatAxioms.Leibniz.eqb_spec in H1. now rewrite H1, (IH b H2).
Qed.

(* Bit for bit: an equality of floats, which tells -0 from 0. *)
Theorem model_is_code : forall p u cases span x want, In (p, u, cases) rows -> In (span, x, want) cases -> machine_eval p u span x = want.
Proof.
  intros p u cases span x want H1 H2. apply same_bits_equal. pose proof all_rows_hold as H. rewrite forallb_forall in H.
  specialize (H _ H1). unfold holds in H. rewrite forallb_forall in H. exact (H _ H2).
Qed.

(* The other loops: derivatives of order 1 to number, a coordinate of a curve's point, those of a curve with a knot inserted. *)
Definition from_list (l : list PrimFloat.float) (i : nat) : machine := nth i l PrimFloat.zero.
Definition machine_nat (n : nat) : machine := PrimFloat.of_uint63 (Uint63.of_Z (Z.of_nat n)).
Definition clamped (p : nat) (u : list PrimFloat.float) (x : machine) : machine :=
  clamp (A := machine) x (from_list u p) (from_list u (length u - p - 1)).
Notation row := (nat * list PrimFloat.float * nat * nat * PrimFloat.float * list PrimFloat.float * list PrimFloat.float)%type.

Definition derivatives_hold (r : row) : bool :=
  let '(p, u, span, number, x, _, want) := r in
  let left := to_left (A := machine) (from_list u) span (clamped p u x) in let right := to_right (A := machine) (from_list u) span (clamped p u x) in
  forallb (fun k => (p <? k) || forallb (fun i =>
      PrimFloat.Leibniz.eqb (derivative (A := machine) left right machine_nat p i k) (nth (k * (p + 1) + i) want PrimFloat.nan)) (seq 0 (p + 1)))%bool
    (seq 1 number).
Definition point_holds (r : row) : bool :=
  let '(p, u, span, _, x, c, want) := r in
  same_bits [curve_point (A := machine) (from_list (machine_eval p u span x)) (fun i => from_list c (span - p + i)) p] want.
Definition insertion_holds (r : row) : bool :=
  let '(p, u, k, number, x, c, want) := r in let s := length (filter (PrimFloat.eqb x) u) in
  same_bits (map (inserted (A := machine) (from_list u) p k s x (from_list c) number) (seq 0 (length c + number))) want.

Theorem other_rows_hold : (forallb derivatives_hold derivatives && forallb point_holds points && forallb insertion_holds insertions)%bool = true.
Proof. vm_compute. reflexivity. Qed.

(* ---- the processor's arithmetic is Flocq's binary64 ---- *)

Definition corresponds (a : machine) (b : binary64) : Prop := Prim2B a = b.

Theorem machine_is_binary64 : forall u nu p s x,
  Forall2 corresponds (basis_eval (A := machine) u nu p s x) (basis_eval (A := binary64) (fun i => Prim2B (u i)) nu p s (Prim2B x)).
Proof.
  intros. apply (basis_eval_related (A := machine) (B := binary64) corresponds); unfold corresponds; intros; subst; try easy.
  - apply B2Prim_inj. rewrite B2Prim_Prim2B. exact one_equiv.
  - apply add_equiv.
  - apply sub_equiv.
  - apply mul_equiv.
  - apply div_equiv.
  - apply ltb_equiv.
  - apply eqb_equiv.
Qed.

(* So what the processor computes, which is what the C code computes, is within the bounds of docs/accuracy.md: a value within 6p - 1 roundings of
   Cox and de Boor's, the sum within 4p - 1 of 1, where nothing over- or underflows (Binary64.row_safe). *)
Section Bounds.
Variables (u : nat -> PrimFloat.float) (nu p s : nat) (x : PrimFloat.float).
Notation t := (fun i => B2R (Prim2B (u i))).
Notation y := (clamp (A := binary64) (Prim2B x) (Prim2B (u p)) (Prim2B (u (nu - p - 1)%nat))).
Notation result := (fun r => B2R (Prim2B (nth r (basis_eval (A := machine) u nu p s x) PrimFloat.zero))).
Hypothesis knots_finite : forall i, BinarySingleNaN.is_finite (Prim2B (u i)) = true.
Hypothesis x_finite : BinarySingleNaN.is_finite (Prim2B x) = true.
Hypothesis sorted : forall i, (t i <= t (S i))%R.
Hypothesis degree : (p <= s)%nat.
Hypothesis span : (t s < t (S s))%R.
Hypothesis inside : (t s <= B2R y <= t (S s))%R.
Hypothesis safe : row_safe (fun i => Prim2B (u i)) p s y.

Lemma clamped_finite : BinarySingleNaN.is_finite y = true.
Proof. unfold clamp. destruct (less _ _); [apply knots_finite|]. destruct (less _ _); [apply knots_finite|exact x_finite]. Qed.
Lemma result_is : forall r, result r = B2R (nth r (basis_at (A := binary64) (fun i => Prim2B (u i)) p s y) (B754_zero false)).
Proof.
  intros r. pose proof (machine_is_binary64 u nu p s x) as H. change (basis_eval (A := binary64) _ nu p s (Prim2B x))
    with (basis_at (A := binary64) (fun i => Prim2B (u i)) p s y) in H.
  revert r. induction H as [|a b la lb Hab Hl IH]; intros r.
  - destruct r; cbn [nth]; reflexivity.
  - destruct r; cbn [nth]; [exact (f_equal B2R Hab)|apply IH].
Qed.
Theorem processor_within : forall r, (r <= p)%nat -> within u64 (6 * p - 1) (result r) (cox t s (B2R y) p (s - p + r)).
Proof. intros r Hr. cbv beta. rewrite result_is. apply basis64_within; auto using clamped_finite. Qed.
Theorem processor_sum : within u64 (4 * p - 1) (total result (S p)) 1.
Proof. rewrite (total_ext _ _ _ (fun r _ => result_is r)). apply basis64_sum; auto using clamped_finite. Qed.
End Bounds.

(* The same with the condition on the knots alone: the differences of the parameter and the 2p knots about it are 0 or from 2^-e to 2^e,
   (2e + 1) p <= 1022: e = 169 for cubics. *)
Theorem processor_within_knots : forall (u : nat -> PrimFloat.float) nu p s x e,
  let t := fun i => B2R (Prim2B (u i)) in
  let y := B2R (clamp (A := binary64) (Prim2B x) (Prim2B (u p)) (Prim2B (u (nu - p - 1)%nat))) in
  (forall i, BinarySingleNaN.is_finite (Prim2B (u i)) = true) -> BinarySingleNaN.is_finite (Prim2B x) = true ->
  (forall i, (t i <= t (S i))%R) -> (p <= s)%nat -> (t s < t (S s))%R -> (t s <= y <= t (S s))%R ->
  (0 <= e /\ (2 * e + 1) * Z.of_nat p <= 1022 /\ e <= 1022)%Z ->
  (forall j, (1 <= j <= p)%nat -> band (- e) e (y - t (s + 1 - j)%nat)) -> (forall j, (1 <= j <= p)%nat -> band (- e) e (t (s + j)%nat - y)) ->
  forall r, (r <= p)%nat ->
  within u64 (6 * p - 1) (B2R (Prim2B (nth r (basis_eval (A := machine) u nu p s x) PrimFloat.zero))) (cox t s y p (s - p + r)).
Proof.
  intros u nu p s x e t y Hu Hx Hs Hp Hspan Hin He HL HR r Hr. apply processor_within; auto. apply guard_enough with e; auto.
Qed.
