(* The model is the code: et_basis_eval's loops as RoundingScheme.v writes them down, run on the processor's binary64 numbers inside Coq, give the
   bits the C code gives, on all rows of TieRows.v (tie.py: the inputs of golden/basis.tsv and more; the C code's own answers).

   Trusted here: that Coq's primitive floats are the processor's, which vm_compute uses, and the axioms of Coq.Floats.FloatAxioms, by which
   Flocq.IEEE754.PrimFloat says what they are (sub_equiv, ... below): Prim2SF_valid, SF2Prim_Prim2SF, Prim2SF_SF2Prim, eqb_spec, ltb_spec, add_spec,
   sub_spec, mul_spec, div_spec, and Leibniz.eqb_spec. *)
Require Import List Arith Floats Reals.
From Flocq Require Import IEEE754.PrimFloat IEEE754.BinarySingleNaN.
From Etalon Require Import RoundingScheme TieRows.
Import ListNotations.

Definition machine : arithmetic :=
  Arithmetic PrimFloat.float PrimFloat.zero PrimFloat.one PrimFloat.add PrimFloat.sub PrimFloat.mul PrimFloat.div PrimFloat.ltb PrimFloat.eqb.

(* ---- the rows ---- *)

(* The last knot not beyond x, in the domain: the span of a row is right, too (et_knots_span). *)
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
