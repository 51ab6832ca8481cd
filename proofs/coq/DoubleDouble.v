(* The double-double operations of src/base/dd_parts.h in binary64's numbers: 53 bits, subnormals (rnd64 of Binary64.v), no overflow.
   What stands between QUOTE and END is the C code, word for word: proofs/coq/quote.sh checks it. *)
From Coq Require Import Reals Lra Lia ZArith Psatz.
From Flocq Require Import Core Pff.Pff2Flocq.
From Etalon Require Import Binary64.
Open Scope R_scope.

Notation double x := (generic_format radix2 (FLT_exp (-1074) 53) x).
#[local] Instance precision_dd : Prec_gt_0 53.
Proof. reflexivity. Qed.
Record dd := DD { hi : R; lo : R }.

Lemma even_symmetric : forall x : Z, negb (Z.even x) = negb (negb (Z.even (- (x + 1)))).
Proof. intros x. rewrite Z.even_opp, Z.even_add. now destruct (Z.even x). Qed.
Lemma rnd64_opp : forall x, rnd64 (- x) = - rnd64 x.
Proof. intros x. apply round_NE_opp. Qed.
Lemma rnd64_double : forall x, double (rnd64 x).
Proof. intros x. apply generic_format_round; [apply FLT_exp_valid; reflexivity|apply valid_rnd_N]. Qed.

(* ---- sums ---- *)

(* QUOTE src/base/dd_parts.h
    const double s = a + b, b1 = s - a, a1 = s - b1;

    return (et_dd){s, (a - a1) + (b - b1)};
END
   QUOTE src/base/dd.c
    return dd_two_sum(a, b);
END *)
Definition two_sum (a b : R) : dd :=
  let s := rnd64 (a + b) in let b1 := rnd64 (s - a) in let a1 := rnd64 (s - b1) in
  DD s (rnd64 (rnd64 (a - a1) + rnd64 (b - b1))).

Theorem two_sum_exact : forall a b, double a -> double b -> hi (two_sum a b) + lo (two_sum a b) = a + b.
Proof. intros a b Ha Hb. now apply TwoSum_correct; [reflexivity|lia|apply even_symmetric| |]. Qed.

(* QUOTE src/base/dd_parts.h
    const double s = a + b;

    return (et_dd){s, b - (s - a)};
END *)
Definition fast_two_sum (a b : R) : dd := let s := rnd64 (a + b) in DD s (rnd64 (b - rnd64 (s - a))).

Theorem fast_two_sum_exact : forall a b, double a -> double b -> Rabs b <= Rabs a ->
  hi (fast_two_sum a b) + lo (fast_two_sum a b) = a + b.
Proof.
  intros a b Ha Hb H. cbn [hi lo fast_two_sum].
  replace (b - rnd64 (rnd64 (a + b) - a)) with (b + rnd64 (a - rnd64 (a + b))).
  - now apply Fast2Sum_correct; [reflexivity|lia|apply even_symmetric| | |].
  - replace (a - rnd64 (a + b)) with (- (rnd64 (a + b) - a)) by ring. rewrite rnd64_opp. ring.
Qed.

(* ---- the product ---- *)

(* QUOTE src/base/dd_parts.h
    const double c = 0x1.0000002p+27 * a;

    return c - (c - a);
END *)
Definition upper (a : R) : R := let c := rnd64 ((bpow radix2 27 + 1) * a) in rnd64 (c - rnd64 (c - a)).

(* QUOTE src/base/dd_parts.h
    const double p = a * b, a1 = dd_upper(a), a2 = a - a1, b1 = dd_upper(b), b2 = b - b1;

    return (et_dd){p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
END
   QUOTE src/base/dd.c
    return dd_two_product(a, b);
END *)
Definition two_product (a b : R) : dd :=
  let p := rnd64 (a * b) in
  let a1 := upper a in let a2 := rnd64 (a - a1) in let b1 := upper b in let b2 := rnd64 (b - b1) in
  DD p (rnd64 (rnd64 (rnd64 (rnd64 (rnd64 (a1 * b1) - p) + rnd64 (a1 * b2)) + rnd64 (a2 * b1)) + rnd64 (a2 * b2))).

Lemma upper_Veltkamp : forall a, upper a =
  rnd64 (rnd64 (a - rnd64 (a * (bpow radix2 27 + 1))) + rnd64 (a * (bpow radix2 27 + 1))).
Proof.
  intros a. unfold upper. rewrite (Rmult_comm (bpow radix2 27 + 1)). set (c := rnd64 (a * _)).
  replace (a - c) with (- (c - a)) by ring. rewrite rnd64_opp. f_equal. ring.
Qed.

(* The header asks for 2^-968; 2^-969 is enough. *)
Theorem two_product_exact : forall a b, double a -> double b -> a * b = 0 \/ bpow radix2 (-969) <= Rabs (a * b) ->
  hi (two_product a b) + lo (two_product a b) = a * b.
Proof.
  intros a b Ha Hb H. unfold two_product. rewrite !upper_Veltkamp. cbn [hi lo].
  match goal with |- context [rnd64 ?x - rnd64 (a * b)] => replace (rnd64 x - rnd64 (a * b)) with (- rnd64 (a * b) + rnd64 x) by ring end.
  symmetry. refine (proj1 (Dekker radix2 (-1074) 53 (fun z => negb (Z.even z)) _ _ a b Ha Hb _) H); [lia|lia|now left].
Qed.

(* Without that condition: never further off than 7/2 of the least subnormal number. *)
Theorem two_product_near : forall a b, double a -> double b ->
  Rabs (a * b - (hi (two_product a b) + lo (two_product a b))) <= 7 / 2 * bpow radix2 (-1074).
Proof.
  intros a b Ha Hb. unfold two_product. rewrite !upper_Veltkamp. cbn [hi lo].
  match goal with |- context [rnd64 ?x - rnd64 (a * b)] => replace (rnd64 x - rnd64 (a * b)) with (- rnd64 (a * b) + rnd64 x) by ring end.
  refine (proj2 (Dekker radix2 (-1074) 53 (fun z => negb (Z.even z)) _ _ a b Ha Hb _)); [lia|lia|now left].
Qed.
