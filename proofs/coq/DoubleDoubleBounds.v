(* How far the double-double operations of src/base/dd_parts.h are from the exact results: relative bounds for operands in normal form, on binary64's
   numbers with gradual underflow, no overflow.  A sum never underflows; for products and quotients the range is a hypothesis, that of
   include/etalon/base/dd.h.  u = 2^-53.
   What stands between QUOTE and END is the C code, word for word: proofs/coq/quote.sh checks it. *)
From Coq Require Import Reals Lra Lia ZArith Psatz.
From Flocq Require Import Core Relative Mult_error Plus_error Sterbenz Div_sqrt_error Pff.Pff2Flocq.
From Etalon Require Import Binary64 DoubleDouble.
Open Scope R_scope.
#[local] Instance precision_bounds : Prec_gt_0 53.
Proof. reflexivity. Qed.

Definition u : R := / 9007199254740992.
Definition eta : R := bpow radix2 (-1075).
Definition value (d : dd) : R := hi d + lo d.
Record normal (d : dd) : Prop := { hi_double : double (hi d); lo_double : double (lo d); hi_nearest : hi d = rnd64 (value d) }.

(* ---- one rounding ---- *)

Lemma u_is_u64 : u64 = u.
Proof. unfold u64, u. simpl. lra. Qed.
Lemma eta_pos : 0 < eta.
Proof. apply bpow_gt_0. Qed.
Lemma Rabs_in : forall x k, Rabs x <= k -> - k <= x <= k.
Proof. intros x k H. now apply Rabs_le_inv. Qed.

Lemma round_any : forall x k, Rabs x <= k -> Rabs (rnd64 x - x) <= u * k + eta.
Proof.
  intros x k H. destruct (error_N_FLT radix2 (-1074) 53 eq_refl (fun z => negb (Z.even z)) x) as (e & n & He & Hn & _ & E).
  change (round radix2 (FLT_exp (-1074) 53) (Znearest (fun z => negb (Z.even z))) x) with (rnd64 x) in E. rewrite E.
  replace (x * (1 + e) + n - x) with (x * e + n) by ring. apply Rle_trans with (1 := Rabs_triang _ _). apply Rplus_le_compat.
  - rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat; try apply Rabs_pos; auto. apply Rle_trans with (1 := He). unfold u. simpl. lra.
  - apply Rle_trans with (1 := Hn). apply Req_le. unfold eta. change (-1075)%Z with (-1 + -1074)%Z. rewrite bpow_plus. simpl (bpow _ (-1)). lra.
Qed.
Lemma round_normal : forall x k, x = 0 \/ least <= Rabs x -> Rabs x <= k -> Rabs (rnd64 x - x) <= u * k.
Proof.
  intros x k Hl H. rewrite rnd64_normal by auto. apply Rle_trans with (1 := rnd_error x). rewrite u_is_u64.
  apply Rmult_le_compat_l; [unfold u; lra|auto].
Qed.
Lemma round_sum : forall x y k, double x -> double y -> Rabs (x + y) <= k -> Rabs (rnd64 (x + y) - (x + y)) <= u * k.
Proof.
  intros x y k Hx Hy H. rewrite rnd64_sum by auto. apply Rle_trans with (1 := rnd_error _). rewrite u_is_u64.
  apply Rmult_le_compat_l; [unfold u; lra|auto].
Qed.
Lemma round_sum_result : forall x y, double x -> double y -> Rabs (rnd64 (x + y) - (x + y)) <= u * Rabs (rnd64 (x + y)).
Proof.
  intros x y Hx Hy. rewrite rnd64_sum by auto.
  pose proof (relative_error_N_FLX_round radix2 53 eq_refl (fun z => negb (Z.even z)) (x + y)) as H.
  change (round radix2 (FLX_exp 53) (Znearest (fun z => negb (Z.even z))) (x + y)) with (rnd (x + y)) in H.
  apply Rle_trans with (1 := H). apply Rmult_le_compat_r; [apply Rabs_pos|]. unfold u. simpl. lra.
Qed.
Lemma round_0 : rnd64 0 = 0.
Proof. apply Generic_fmt.round_0. apply valid_rnd_N. Qed.
Lemma round_id : forall x, double x -> rnd64 x = x.
Proof. intros x H. apply round_generic; [apply valid_rnd_N|auto]. Qed.
Lemma double_0 : double 0.
Proof. apply generic_format_0. Qed.
Lemma double_opp : forall x, double x -> double (- x).
Proof. intros x. apply generic_format_opp. Qed.

Lemma normal_lo : forall d, normal d -> Rabs (lo d) <= u * Rabs (hi d).
Proof.
  intros d [Hh Hl E]. rewrite E. replace (lo d) with (- (rnd64 (value d) - value d)) by (rewrite <- E; unfold value; ring).
  rewrite Rabs_Ropp. now apply round_sum_result.
Qed.
Lemma normal_0 : forall d, normal d -> hi d = 0 -> lo d = 0.
Proof.
  intros d H E. pose proof (normal_lo d H) as L. rewrite E, Rabs_R0, Rmult_0_r in L. pose proof (Rabs_pos (lo d)).
  destruct (Req_dec (lo d) 0) as [e|e]; auto. apply Rabs_pos_lt in e. lra.
Qed.

(* What is less than 2^-170 of a value from 2^-905 on. *)
Lemma eta_small : forall m, bpow radix2 (-905) <= m -> 0 <= eta <= / 1000000000000000000000000000000000000000000000000000 * m.
Proof.
  intros m H. split; [apply Rlt_le, eta_pos|]. unfold eta. change (-1075)%Z with (-170 + -905)%Z. rewrite bpow_plus.
  apply Rmult_le_compat; try apply bpow_ge_0; auto. simpl. lra.
Qed.

(* ---- the product: JMP 10 ---- *)

(* QUOTE src/base/dd_parts.h
    const et_dd p = dd_two_product(a.hi, b.hi);

    return dd_fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
END
   QUOTE src/base/dd.c
    return dd_mul(a, b);
END *)
Definition mul (a b : dd) : dd :=
  let p := two_product (hi a) (hi b) in
  fast_two_sum (hi p) (rnd64 (lo p + rnd64 (rnd64 (hi a * lo b) + rnd64 (lo a * hi b)))).

Lemma product_bound : forall x y k l, Rabs x <= k -> Rabs y <= l -> Rabs (x * y) <= k * l.
Proof. intros. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. Qed.
Lemma lo_double_product : forall a b, double (lo (two_product a b)).
Proof. intros. apply rnd64_double. Qed.

Ltac zeros := repeat (rewrite ?Rmult_0_l, ?Rmult_0_r, ?Rplus_0_l, ?Rplus_0_r, ?Rminus_0_r, ?round_0).
Lemma two_product_0_l : forall b, two_product 0 b = DD 0 0.
Proof. intros b. unfold two_product, upper. zeros. reflexivity. Qed.
Lemma two_product_0_r : forall a, two_product a 0 = DD 0 0.
Proof. intros a. unfold two_product, upper. zeros. reflexivity. Qed.
Ltac bounds := repeat match goal with H : Rabs _ <= _ |- _ => apply Rabs_in in H end.

Theorem mul_near : forall a b, normal a -> normal b -> hi a * hi b = 0 \/ bpow radix2 (-900) <= Rabs (hi a * hi b) ->
  Rabs (value (mul a b) - value a * value b) <= (8 * u ^ 2 + 40 * u ^ 3) * Rabs (value a * value b).
Proof.
  intros a b Ha Hb H. pose proof (normal_lo a Ha) as La. pose proof (normal_lo b Hb) as Lb.
  destruct H as [Z|H].
  { assert (value a * value b = 0 /\ value (mul a b) = 0) as [-> ->].
    2: { rewrite Rminus_0_r, Rabs_R0. lra. }
    unfold value, mul. apply Rmult_integral in Z. destruct Z as [Z|Z]; [rewrite Z, (normal_0 a Ha Z), two_product_0_l|
      rewrite Z, (normal_0 b Hb Z), two_product_0_r]; unfold fast_two_sum; cbn [hi lo]; split; try ring; zeros; ring. }
  destruct Ha as [Dah Dal _], Hb as [Dbh Dbl _]. set (M := Rabs (hi a * hi b)) in *.
  assert (E := two_product_exact (hi a) (hi b) Dah Dbh). 
  assert (M0 : 0 < M) by (apply Rlt_le_trans with (2 := H); apply bpow_gt_0).
  assert (T : 0 <= eta <= / 1000000000000000000000000000000000000000000000000000 * M).
  { apply eta_small. apply Rle_trans with (2 := H). apply bpow_le. lia. }
  specialize (E ltac:(right; apply Rle_trans with (2 := H); apply bpow_le; lia)).
  unfold mul. set (p := two_product (hi a) (hi b)) in *.
  assert (Dp : double (hi p)) by apply rnd64_double. assert (Dq : double (lo p)) by apply rnd64_double.
  assert (P : Rabs (hi p - hi a * hi b) <= u * M).
  { apply round_normal; [right|unfold M; lra]. apply Rle_trans with (2 := H). unfold least. apply bpow_le. lia. }
  assert (Eab : forall x y, Rabs x * Rabs y = Rabs (x * y)) by (intros; now rewrite Rabs_mult).
  assert (T1 : Rabs (hi a * lo b) <= u * M).
  { apply Rle_trans with (1 := product_bound _ _ _ _ (Rle_refl _) Lb). unfold M. rewrite <- Eab. apply Req_le. ring. }
  assert (T2 : Rabs (lo a * hi b) <= u * M).
  { apply Rle_trans with (1 := product_bound _ _ _ _ La (Rle_refl _)). unfold M. rewrite <- Eab. apply Req_le. ring. }
  assert (T3 : Rabs (lo a * lo b) <= u * u * M).
  { apply Rle_trans with (1 := product_bound _ _ _ _ La Lb). unfold M. rewrite <- Eab. apply Req_le. ring. }
  assert (R1 := round_any _ _ T1). assert (R2 := round_any _ _ T2).
  set (t1 := rnd64 (hi a * lo b)) in *. set (t2 := rnd64 (lo a * hi b)) in *.
  assert (D1 : double t1) by apply rnd64_double. assert (D2 : double t2) by apply rnd64_double.
  assert (S1 : Rabs (t1 + t2) <= (2 * u + 3 * u * u) * M).
  { apply Rabs_le. bounds. unfold u in *. lra. }
  assert (R3 := round_sum t1 t2 _ D1 D2 S1). set (c := rnd64 (t1 + t2)) in *. assert (D3 : double c) by apply rnd64_double.
  assert (S2 : Rabs (lo p + c) <= (3 * u + 6 * u * u) * M).
  { apply Rabs_le. bounds. unfold u in *. lra. }
  assert (R4 := round_sum (lo p) c _ Dq D3 S2). set (d := rnd64 (lo p + c)) in *. assert (D4 : double d) by apply rnd64_double.
  unfold value at 1. rewrite fast_two_sum_exact; auto.
  2: { apply Rle_trans with (4 * u * M); [apply Rabs_le; bounds; unfold u in *; lra|]. apply Rle_trans with ((1 - u) * M).
       - unfold u. lra.
       - assert (M - Rabs (hi p) <= u * M); [|lra]. apply Rle_trans with (2 := P). unfold M. rewrite Rabs_minus_sym. apply Rabs_triang_inv. }
  assert (V : (1 - 3 * u) * M <= Rabs (value a * value b)).
  { unfold value. replace ((hi a + lo a) * (hi b + lo b)) with (hi a * hi b - - (hi a * lo b + lo a * hi b + lo a * lo b)) by ring.
    apply Rle_trans with (2 := Rabs_triang_inv _ _). fold M. rewrite Rabs_Ropp.
    assert (Rabs (hi a * lo b + lo a * hi b + lo a * lo b) <= 3 * u * M); [|lra]. apply Rabs_le. bounds. unfold u in *. lra. }
  apply Rle_trans with ((8 * u ^ 2 + 12 * u ^ 3) * M).
  - unfold value. apply Rabs_le. bounds. replace ((hi a + lo a) * (hi b + lo b)) with (hi p + lo p + (hi a * lo b + lo a * hi b + lo a * lo b)) by
      (rewrite E; ring). unfold u in *. lra.
  - apply Rle_trans with ((8 * u ^ 2 + 40 * u ^ 3) * ((1 - 3 * u) * M)); [unfold u; lra|]. apply Rmult_le_compat_l; [unfold u; lra|exact V].
Qed.

(* ---- the published constant of the product: errors in units in the last place, not relative ones ---- *)

Lemma round_below : forall x e, Rabs x <= bpow radix2 e -> Rabs (rnd64 x - x) <= u / 2 * bpow radix2 e + eta.
Proof.
  intros x e H. destruct (Req_dec x 0) as [->|Z].
  { rewrite round_0, Rminus_0_r, Rabs_R0. pose proof eta_pos. pose proof (bpow_gt_0 radix2 e). unfold u. lra. }
  assert (B : forall f, (mag radix2 x <= f)%Z -> Rabs (rnd64 x - x) <= u / 2 * bpow radix2 f + eta).
  { intros f Hf. apply Rle_trans with (1 := error_le_half_ulp radix2 (FLT_exp (-1074) 53) _ x). rewrite ulp_neq_0 by auto.
    assert (E : / 2 * bpow radix2 (-1074) = eta).
    { unfold eta. change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus. reflexivity. }
    assert (F : / 2 * bpow radix2 (f - 53) = u / 2 * bpow radix2 f).
    { unfold Z.sub. rewrite bpow_plus. replace (bpow radix2 (-(53))) with u by (unfold u; simpl; lra). unfold Rdiv. ring. }
    rewrite <- E, <- F. unfold cexp, FLT_exp. pose proof (bpow_gt_0 radix2 (f - 53)). pose proof (bpow_gt_0 radix2 (-1074)).
    destruct (Z.max_spec (mag radix2 x - 53) (-1074)) as [[_ ->]|[_ ->]]; [lra|].
    assert (bpow radix2 (mag radix2 x - 53) <= bpow radix2 (f - 53)) by (apply bpow_le; lia). lra. }
  destruct (Rle_lt_or_eq_dec _ _ H) as [h|h].
  - apply B. now apply mag_le_bpow.
  - destruct (Z_le_gt_dec (-1074) e) as [he|he].
    + assert (D : double x).
      { assert (G : double (bpow radix2 e)) by (apply generic_format_bpow; unfold FLT_exp; lia).
        revert h. unfold Rabs. destruct (Rcase_abs x); intros h; [replace x with (- - x) by ring; apply double_opp|]; now rewrite h. }
      rewrite (round_id x D), Rminus_eq_0, Rabs_R0. pose proof eta_pos. pose proof (bpow_gt_0 radix2 e). unfold u. lra.
    + apply Rle_trans with (1 := error_le_half_ulp radix2 (FLT_exp (-1074) 53) _ x). rewrite ulp_neq_0 by auto. unfold cexp, FLT_exp.
      assert (mag radix2 x <= e + 1)%Z by (apply mag_le_bpow; auto; rewrite h; apply bpow_lt; lia).
      rewrite Z.max_r by lia. assert (E : / 2 * bpow radix2 (-1074) = eta).
      { unfold eta. change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus. reflexivity. }
      pose proof (bpow_gt_0 radix2 e). unfold u. lra.
Qed.
(* No double is nearer. *)
Lemma round_nearest : forall x g, double g -> Rabs (rnd64 x - x) <= Rabs (g - x).
Proof. intros x g Hg. exact (proj2 (round_N_pt radix2 (FLT_exp (-1074) 53) _ x) g Hg). Qed.
(* A little above a power of two. *)
Lemma round_about : forall x e k, (-1074 <= e)%Z -> 0 <= k -> Rabs x <= bpow radix2 e + k ->
Rabs (rnd64 x - x) <= Rmax (u / 2 * bpow radix2 e + eta) k.
Proof.
  intros x e k He Hk H. destruct (Rle_or_lt (Rabs x) (bpow radix2 e)) as [h|h].
  - apply Rle_trans with (2 := Rmax_l _ _). now apply round_below.
  - apply Rle_trans with (2 := Rmax_r _ _). assert (G : double (bpow radix2 e)) by (apply generic_format_bpow; unfold FLT_exp; lia).
    destruct (Rle_or_lt 0 x) as [hx|hx].
    + apply Rle_trans with (1 := round_nearest x _ G). rewrite (Rabs_pos_eq x) in * by auto. apply Rabs_le. lra.
    + apply Rle_trans with (1 := round_nearest x _ (double_opp _ G)). rewrite (Rabs_left x) in * by auto. apply Rabs_le. lra.
Qed.

(* A number in normal form in units of its upper part's leading bit. *)
Lemma normal_unit : forall d, normal d -> hi d <> 0 ->
  exists e, bpow radix2 e <= Rabs (hi d) <= 2 * bpow radix2 e /\ Rabs (lo d) <= u * bpow radix2 e /\
    (Rabs (hi d) = bpow radix2 e \/ (1 + 2 * u) * bpow radix2 e <= Rabs (hi d)).
Proof.
  intros d [Hh Hl E] Z. exists (mag radix2 (hi d) - 1)%Z. set (e := (mag radix2 (hi d) - 1)%Z).
  assert (B1 : bpow radix2 e <= Rabs (hi d)) by (now apply bpow_mag_le).
  assert (B2 : Rabs (hi d) < bpow radix2 (e + 1)) by (unfold e; rewrite Z.sub_add; apply bpow_mag_gt).
  assert (U : bpow radix2 (e - 52) = 2 * u * bpow radix2 e).
  { unfold Z.sub. rewrite bpow_plus. replace (bpow radix2 (-(52))) with (2 * u) by (unfold u; simpl; lra). ring. }
  rewrite bpow_plus in B2. change (bpow radix2 1) with 2 in B2. split; [lra|split].
  - replace (lo d) with (- (rnd64 (value d) - value d)) by (rewrite <- E; unfold value; ring). rewrite Rabs_Ropp.
    unfold value in *. rewrite rnd64_sum in * by auto.
    apply Rle_trans with (1 := error_le_half_ulp_round radix2 (FLX_exp 53) _ (hi d + lo d)).
    fold (rnd (hi d + lo d)). rewrite <- E, ulp_neq_0 by auto. unfold cexp, FLX_exp.
    replace (mag radix2 (hi d) - 53)%Z with (e - 52)%Z by (unfold e; ring). rewrite U. lra.
  - destruct (Rle_lt_or_eq_dec _ _ B1) as [h|h]; [right|now left].
    assert (G : generic_format radix2 (FLX_exp 53) (Rabs (hi d))) by (apply generic_format_abs; now apply generic_format_FLX_FLT with (-1074)%Z).
    assert (S : succ radix2 (FLX_exp 53) (bpow radix2 e) <= Rabs (hi d)).
    { apply succ_le_lt; auto; try (apply FLX_exp_valid; reflexivity). apply generic_format_bpow. unfold FLX_exp. lia. }
    rewrite succ_eq_pos in S by apply bpow_ge_0. rewrite ulp_bpow in S. unfold FLX_exp in S. replace (e + 1 - 53)%Z with (e - 52)%Z in S by ring. lra.
Qed.

Theorem mul_near_published : forall a b, normal a -> normal b -> hi a * hi b = 0 \/ bpow radix2 (-900) <= Rabs (hi a * hi b) ->
  Rabs (value (mul a b) - value a * value b) <= 7 * u ^ 2 * Rabs (value a * value b).
Proof.
  intros a b Ha Hb H. destruct (Req_dec (hi a * hi b) 0) as [Z|Z].
  { pose proof (mul_near a b Ha Hb (or_introl Z)) as G. assert (value a * value b = 0) as V.
    { unfold value. apply Rmult_integral in Z. destruct Z as [Z|Z]; [rewrite Z, (normal_0 a Ha Z)|rewrite Z, (normal_0 b Hb Z)]; ring. }
    rewrite V in *. rewrite Rabs_R0 in *. lra. }
  destruct H as [?|H]; [contradiction|]. assert (Za : hi a <> 0) by (intros E; apply Z; rewrite E; ring).
  assert (Zb : hi b <> 0) by (intros E; apply Z; rewrite E; ring).
  destruct (normal_unit a Ha Za) as (ea & A1 & A2 & A3). destruct (normal_unit b Hb Zb) as (eb & B1 & B2 & B3).
  pose proof (bpow_gt_0 radix2 ea) as A0. pose proof (bpow_gt_0 radix2 eb) as B0.
  assert (EP : bpow radix2 (ea + eb) = bpow radix2 ea * bpow radix2 eb) by apply bpow_plus.
  set (A := bpow radix2 ea) in *. set (B := bpow radix2 eb) in *. set (P := bpow radix2 (ea + eb)) in *.
  set (x := Rabs (hi a)) in *. set (y := Rabs (hi b)) in *.
  set (M := Rabs (hi a * hi b)) in *. assert (EM : M = x * y) by (apply Rabs_mult).
  assert (P0 : 0 < P) by apply bpow_gt_0.
  assert (M1 : M <= 4 * P) by (rewrite EM, EP; replace (4 * (A * B)) with (2 * A * (2 * B)) by ring; apply Rmult_le_compat; lra).
  assert (M2 : P <= M) by (rewrite EM, EP; apply Rmult_le_compat; lra).
  assert (T : 0 <= eta <= / 100000000000000000000000000000000000000000000000000 * P).
  { assert (Q := eta_small M ltac:(apply Rle_trans with (2 := H); apply bpow_le; lia)). lra. }
  assert (Le : (-903 < ea + eb)%Z).
  { apply (lt_bpow radix2). fold P. apply Rlt_le_trans with (/ 4 * bpow radix2 (-900)); [|lra].
    change (/ 4) with (bpow radix2 (-2)). rewrite <- bpow_plus. apply bpow_lt. lia. }
  assert (U : forall j, bpow radix2 (ea + eb + j - 53) = u * (bpow radix2 j * P)).
  { intros j. unfold Z.sub, P. rewrite bpow_plus, (bpow_plus radix2 (ea + eb) j). replace (bpow radix2 (-(53))) with u by (unfold u; simpl; lra).
    ring. }
  pose proof (U 1%Z) as U1. pose proof (U 2%Z) as U2. pose proof (U 3%Z) as U3. clear U. change (bpow radix2 1) with 2 in U1.
  change (bpow radix2 2) with 4 in U2. change (bpow radix2 3) with 8 in U3.
  assert (Two : bpow radix2 (ea + eb + 1) = 2 * P) by (rewrite bpow_plus; fold P; change (bpow radix2 1) with 2; ring).
  assert (Four : bpow radix2 (ea + eb + 2) = 4 * P) by (rewrite bpow_plus; fold P; change (bpow radix2 2) with 4; ring).
  assert (p1 : P <= x * B <= 2 * P) by (rewrite EP; split; [apply Rmult_le_compat_r; lra|rewrite <- Rmult_assoc; apply Rmult_le_compat_r; lra]).
  assert (p2 : P <= A * y <= 2 * P).
  { rewrite EP. split; [apply Rmult_le_compat_l; lra|]. replace (2 * (A * B)) with (A * (2 * B)) by ring. apply Rmult_le_compat_l; lra. }
  assert (T1 : Rabs (hi a * lo b) <= u * (x * B)).
  { apply Rle_trans with (1 := product_bound _ _ _ _ (Rle_refl _) B2). apply Req_le. unfold x. ring. }
  assert (T2 : Rabs (lo a * hi b) <= u * (A * y)).
  { apply Rle_trans with (1 := product_bound _ _ _ _ A2 (Rle_refl _)). apply Req_le. unfold y. ring. }
  assert (T3 : Rabs (lo a * lo b) <= u * u * P).
  { apply Rle_trans with (1 := product_bound _ _ _ _ A2 B2). rewrite EP. apply Req_le. ring. }
  assert (R1 := round_below (hi a * lo b) (ea + eb + 1 - 53) ltac:(rewrite U1; unfold u in *; lra)).
  assert (R2 := round_below (lo a * hi b) (ea + eb + 1 - 53) ltac:(rewrite U1; unfold u in *; lra)). rewrite U1 in R1, R2.
  assert (Dah := hi_double a Ha). assert (Dbh := hi_double b Hb).
  assert (E := two_product_exact (hi a) (hi b) Dah Dbh ltac:(right; apply Rle_trans with (2 := H); apply bpow_le; lia)).
  assert (Eh : hi (two_product (hi a) (hi b)) = rnd64 (hi a * hi b)) by reflexivity.
  assert (PP : Rabs (hi (two_product (hi a) (hi b)) - hi a * hi b) <= u * M).
  { apply round_normal; [right|unfold M; lra]. apply Rle_trans with (2 := H). unfold least. apply bpow_le. lia. }
  unfold mul. set (p := two_product (hi a) (hi b)) in *.
  assert (Dp : double (hi p)) by apply rnd64_double. assert (Dq : double (lo p)) by apply rnd64_double.
  set (t1 := rnd64 (hi a * lo b)) in *. set (t2 := rnd64 (lo a * hi b)) in *.
  assert (S1 : Rabs (t1 + t2) <= 4 * u * P + 3 * u ^ 2 * P) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (S2 : Rabs (t1 + t2) <= u * (x * B) + u * (A * y) + 2 * u ^ 2 * P + 2 * eta) by (apply Rabs_le; bounds; unfold u in *; lra).
  set (c := rnd64 (t1 + t2)) in *.
  assert (Dc : double c) by apply rnd64_double. set (d := rnd64 (lo p + c)) in *. assert (Dd : double d) by apply rnd64_double.
  assert (V0 : M - 3 * u * M <= Rabs (value a * value b)).
  { unfold value. replace ((hi a + lo a) * (hi b + lo b)) with (hi a * hi b - - (hi a * lo b + lo a * hi b + lo a * lo b)) by ring.
    pose proof (normal_lo a Ha) as La. pose proof (normal_lo b Hb) as Lb. fold x in La. fold y in Lb.
    assert (G1 := product_bound (hi a) (lo b) _ _ (Rle_refl _) Lb). assert (G2 := product_bound (lo a) (hi b) _ _ La (Rle_refl _)).
    assert (G3 := product_bound (lo a) (lo b) _ _ La Lb). fold x in G1. fold y in G2.
    replace (x * (u * y)) with (u * M) in G1 by (rewrite EM; ring). replace (u * x * y) with (u * M) in G2 by (rewrite EM; ring).
    replace (u * x * (u * y)) with (u * u * M) in G3 by (rewrite EM; ring).
    apply Rle_trans with (2 := Rabs_triang_inv _ _). fold M. rewrite Rabs_Ropp.
    assert (Rabs (hi a * lo b + lo a * hi b + lo a * lo b) <= 3 * u * M); [|lra]. apply Rabs_le. bounds. unfold u in *. lra. }
  (* It is enough to bound the last two roundings. *)
  assert (Sum : forall e3 e4 : R, e3 + e4 <= 20 * u ^ 2 * P -> Rabs (c - (t1 + t2)) <= e3 -> Rabs (d - (lo p + c)) <= e4 ->
    (3 * u ^ 2 * P + 2 * eta) + e3 + e4 <= 7 * u ^ 2 * Rabs (value a * value b) ->
    Rabs (value (fast_two_sum (hi p) d) - value a * value b) <= 7 * u ^ 2 * Rabs (value a * value b)).
  { intros e3 e4 H0 H3 H4 HS. unfold value at 1. rewrite fast_two_sum_exact; auto.
    2: { assert (M - Rabs (hi p) <= u * M) by (apply Rle_trans with (2 := PP); unfold M; rewrite Rabs_minus_sym; apply Rabs_triang_inv).
         apply Rle_trans with (10 * u * M); [|unfold u in *; lra].
         apply Rabs_le. bounds. unfold u in *. lra. }
    apply Rle_trans with (2 := HS). unfold value.
    replace ((hi a + lo a) * (hi b + lo b)) with (hi p + lo p + (hi a * lo b + lo a * hi b + lo a * lo b)) by (rewrite E; ring).
    apply Rabs_le. bounds. unfold u in *. lra. }
  assert (R3 : Rabs (c - (t1 + t2)) <= 3 * u ^ 2 * P).
  { apply Rle_trans with (1 := round_about (t1 + t2) (ea + eb + 2 - 53) (3 * u ^ 2 * P) ltac:(lia) ltac:(unfold u; lra)
      ltac:(rewrite U2; lra)). apply Rmax_lub; [rewrite U2; unfold u in *; lra|lra]. }
  destruct (Rlt_or_le (2 * P) M) as [h|h].
  - (* a product of 2 to 4 units *)
    apply (Sum (3 * u ^ 2 * P) (4 * u ^ 2 * P + eta)); auto; [unfold u in *; lra| |unfold u in *; lra].
    assert (Q : Rabs (hi p - hi a * hi b) <= u / 2 * (4 * P) + eta).
    { rewrite Eh. replace (4 * P) with (bpow radix2 (ea + eb + 2)) by (rewrite Four; ring). apply round_below. rewrite Four. fold M. lra. }
    assert (S3 : Rabs (lo p + c) <= u * (8 * P)) by (apply Rabs_le; bounds; unfold u in *; lra).
    rewrite <- U3 in S3. apply Rle_trans with (1 := round_below _ _ S3). rewrite U3. lra.
  - assert (Exact : double (hi a * hi b) ->
      Rabs (value (fast_two_sum (hi p) d) - value a * value b) <= 7 * u ^ 2 * Rabs (value a * value b)).
    { intros D. assert (Z0 : lo p = 0) by (rewrite (round_id _ D) in Eh; lra).
      apply (Sum (3 * u ^ 2 * P) 0); auto; [unfold u in *; lra| |unfold u in *; lra].
      unfold d. rewrite Z0, Rplus_0_l, (round_id c) by auto. rewrite Rminus_eq_0, Rabs_R0. lra. }
    assert (Power : forall v w e f, double w -> Rabs v = bpow radix2 e -> bpow radix2 f <= Rabs w -> (-903 < e + f)%Z -> double (w * v)).
    { intros v w e f Dw Hv Hw Hl. assert (G : double (w * bpow radix2 e)).
      { apply mult_bpow_exact_FLT; auto. replace f with (f + 1 - 1)%Z in Hw by ring. apply mag_ge_bpow in Hw. lia. }
      rewrite <- Hv in G. revert G. unfold Rabs. destruct (Rcase_abs v); auto. intros G. apply double_opp in G.
      replace (- (w * - v)) with (w * v) in G by ring. exact G. }
    destruct A3 as [A3|A3].
    { apply Exact. rewrite Rmult_comm. apply (Power _ _ ea eb Dbh A3 (proj1 B1)). lia. }
    destruct B3 as [B3|B3].
    { apply Exact. apply (Power _ _ eb ea Dah B3 (proj1 A1)). lia. }
    assert (XY : x * B + A * y <= (3 - 2 * u + 8 * u ^ 2) * P).
    { assert (0 <= (x - (1 + 2 * u) * A) * (y - (1 + 2 * u) * B)) as G by (apply Rmult_le_pos; lra).
      replace ((x - (1 + 2 * u) * A) * (y - (1 + 2 * u) * B)) with (M - (1 + 2 * u) * (x * B) - (1 + 2 * u) * (A * y) + (1 + 2 * u) ^ 2 * P) in G by
        (rewrite EM, EP; ring). unfold u in *. lra. }
    assert (S3 : Rabs (t1 + t2) <= (3 * u + 9 * u ^ 3) * P) by (unfold u in *; lra).
    assert (R3' := round_below (t1 + t2) (ea + eb + 2 - 53) ltac:(rewrite U2; unfold u in *; lra)). rewrite U2 in R3'. fold c in R3'.
    assert (Q : Rabs (hi p - hi a * hi b) <= u / 2 * (2 * P) + eta).
    { rewrite Eh. replace (2 * P) with (bpow radix2 (ea + eb + 1)) by (rewrite Two; ring). apply round_below. rewrite Two. fold M. lra. }
    assert (V : (1 + 2 * u) * P <= Rabs (value a * value b)).
    { assert (G1 : (1 + u) * A <= Rabs (value a)).
      { unfold value. assert (Rabs (hi a) - Rabs (lo a) <= Rabs (hi a + lo a)) by (clear; split_Rabs; lra). fold x in H0. lra. }
      assert (G2 : (1 + u) * B <= Rabs (value b)).
      { unfold value. assert (Rabs (hi b) - Rabs (lo b) <= Rabs (hi b + lo b)) by (clear; split_Rabs; lra). fold y in H0. lra. }
      rewrite Rabs_mult. apply Rle_trans with ((1 + u) * A * ((1 + u) * B)).
      - replace ((1 + u) * A * ((1 + u) * B)) with ((1 + u) * (1 + u) * P) by (rewrite EP; ring). unfold u in *. lra.
      - apply Rmult_le_compat; try (apply Rmult_le_pos; unfold u; lra); auto. }
    apply (Sum (2 * u ^ 2 * P + eta) ((2 * u ^ 2 + 10 * u ^ 3) * P)); [unfold u in *; lra|unfold u in *; lra| |unfold u in *; lra].
    apply Rle_trans with (1 := round_about (lo p + c) (ea + eb + 2 - 53) ((2 * u ^ 2 + 10 * u ^ 3) * P) ltac:(lia) ltac:(unfold u; lra)
      ltac:(rewrite U2; apply Rabs_le; bounds; unfold u in *; lra)). apply Rmax_lub; [rewrite U2; unfold u in *; lra|lra].
Qed.

(* ---- the sum: JMP 6 ---- *)

(* QUOTE src/base/dd_parts.h
    const et_dd s = dd_two_sum(a.hi, b.hi), t = dd_two_sum(a.lo, b.lo), v = dd_fast_two_sum(s.hi, s.lo + t.hi);

    return dd_fast_two_sum(v.hi, t.lo + v.lo);
END
   QUOTE src/base/dd.c
    return dd_add(a, b);
END *)
Definition add (a b : dd) : dd :=
  let s := two_sum (hi a) (hi b) in let t := two_sum (lo a) (lo b) in let v := fast_two_sum (hi s) (rnd64 (lo s + hi t)) in
  fast_two_sum (hi v) (rnd64 (lo t + lo v)).

(* fast_two_sum is exact, too, where the sum is a double, and where both are multiples of a power of two of which the second is less than 2^53. *)
Lemma fast_two_sum_double : forall a b, double b -> double (a + b) -> hi (fast_two_sum a b) = a + b /\ lo (fast_two_sum a b) = 0.
Proof.
  intros a b Hb H. unfold fast_two_sum. cbn [hi lo]. rewrite (round_id (a + b)) by auto. replace (a + b - a) with b by ring.
  rewrite (round_id b) by auto. now rewrite Rminus_eq_0, round_0.
Qed.
Lemma grid_double : forall n e, (Z.abs n <= 2 ^ 53)%Z -> (-1074 <= e)%Z -> double (IZR n * bpow radix2 e).
Proof.
  intros n e Hn He. destruct (Z.eq_dec (Z.abs n) (2 ^ 53)) as [E|E].
  - assert (D : double (bpow radix2 53 * bpow radix2 e)).
    { rewrite <- bpow_plus. apply generic_format_bpow. unfold FLT_exp. lia. }
    change (bpow radix2 53) with (IZR (2 ^ 53)) in D. set (z := (2 ^ 53)%Z) in *.
    assert (n = z \/ n = - z)%Z as [-> | ->] by (unfold z in *; lia); [exact D|].
    rewrite opp_IZR. replace (- IZR z * bpow radix2 e) with (- (IZR z * bpow radix2 e)) by ring. now apply double_opp.
  - apply generic_format_FLT. exists (Float radix2 n e); [reflexivity|simpl; lia|simpl; lia].
Qed.
Lemma on_grid : forall x e, double x -> (e <= cexp radix2 (FLT_exp (-1074) 53) x)%Z -> exists n, x = IZR n * bpow radix2 e.
Proof.
  intros x e H He. exists (Ztrunc (scaled_mantissa radix2 (FLT_exp (-1074) 53) x) * 2 ^ (cexp radix2 (FLT_exp (-1074) 53) x - e))%Z.
  rewrite mult_IZR. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by lia. rewrite Rmult_assoc, <- bpow_plus.
  rewrite Z.sub_add. exact H.
Qed.
Lemma grid_round : forall n e, (-1074 <= e)%Z -> (Z.abs n < 2 ^ 54)%Z ->
  exists d, (Z.abs d <= 1)%Z /\ rnd64 (IZR n * bpow radix2 e) = IZR (n + d) * bpow radix2 e.
Proof.
  intros n e He Hn. pose proof (bpow_gt_0 radix2 e) as Pe. destruct (Z_le_gt_dec (Z.abs n) (2 ^ 53)) as [h|h].
  { exists 0%Z. split; [lia|]. rewrite Z.add_0_r. apply round_id. now apply grid_double. }
  assert (A : forall k, (Z.abs k <= 2 ^ 53)%Z -> double (IZR (2 * k) * bpow radix2 e)).
  { intros k Hk. replace (IZR (2 * k) * bpow radix2 e) with (IZR k * bpow radix2 (e + 1)); [apply grid_double; lia|].
    rewrite mult_IZR, bpow_plus. change (bpow radix2 1) with 2. ring. }
  destruct (Z.Even_or_Odd n) as [[m Em]|[m Em]].
  { exists 0%Z. split; [lia|]. rewrite Z.add_0_r. apply round_id. rewrite Em. apply A. lia. }
  set (x := IZR n * bpow radix2 e).
  assert (G : exists k, rnd64 x = IZR k * bpow radix2 e).
  { apply on_grid; [apply rnd64_double|].
    assert (L : bpow radix2 (e + 53) <= Rabs (rnd64 x)).
    { apply abs_round_ge_generic; [apply FLT_exp_valid; reflexivity|apply valid_rnd_N|apply generic_format_bpow; unfold FLT_exp; lia|].
      unfold x. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ e)), Z.add_comm, bpow_plus by lra. apply Rmult_le_compat_r; [lra|].
      rewrite <- abs_IZR. replace (bpow radix2 53) with (IZR (2 ^ 53)) by reflexivity. apply IZR_le. lia. }
    unfold cexp, FLT_exp. replace (e + 53)%Z with (e + 54 - 1)%Z in L by ring. apply mag_ge_bpow in L. lia. }
  destruct G as [k G]. exists (k - n)%Z. rewrite G. split; [|f_equal; f_equal; lia].
  assert (R1 : IZR (2 * m) * bpow radix2 e <= rnd64 x).
  { rewrite <- (round_id (IZR (2 * m) * bpow radix2 e)) by (apply A; lia). apply round_le; [apply FLT_exp_valid; reflexivity|apply valid_rnd_N|].
    apply Rmult_le_compat_r; [lra|apply IZR_le; lia]. }
  assert (R2 : rnd64 x <= IZR (2 * (m + 1)) * bpow radix2 e).
  { rewrite <- (round_id (IZR (2 * (m + 1)) * bpow radix2 e)) by (apply A; lia). apply round_le; [apply FLT_exp_valid; reflexivity|
      apply valid_rnd_N|]. apply Rmult_le_compat_r; [lra|apply IZR_le; lia]. }
  rewrite G in R1, R2. apply Rmult_le_reg_r in R1, R2; auto. apply le_IZR in R1, R2. lia.
Qed.
Lemma fast_two_sum_grid : forall n m e, (-1074 <= e)%Z -> (Z.abs n <= Z.abs m < 2 ^ 53)%Z ->
  let a := IZR n * bpow radix2 e in let b := IZR m * bpow radix2 e in hi (fast_two_sum a b) + lo (fast_two_sum a b) = a + b.
Proof.
  intros n m e He Hm a b. assert (E : a + b = IZR (n + m) * bpow radix2 e) by (unfold a, b; rewrite plus_IZR; ring).
  destruct (grid_round (n + m) e He ltac:(lia)) as (d & Hd & R). unfold fast_two_sum. cbn [hi lo]. rewrite E, R.
  replace (IZR (n + m + d) * bpow radix2 e - a) with (IZR (m + d) * bpow radix2 e) by (unfold a; rewrite !plus_IZR; ring).
  rewrite (round_id (IZR (m + d) * bpow radix2 e)) by (apply grid_double; lia).
  replace (b - IZR (m + d) * bpow radix2 e) with (IZR (- d) * bpow radix2 e) by (unfold b; rewrite !plus_IZR, opp_IZR; ring).
  rewrite (round_id (IZR (- d) * bpow radix2 e)) by (apply grid_double; lia). rewrite !plus_IZR, opp_IZR. ring.
Qed.

Lemma two_sum_lo : forall a b, double a -> double b -> Rabs (lo (two_sum a b)) <= u * Rabs (a + b).
Proof.
  intros a b Ha Hb. replace (lo (two_sum a b)) with (- (hi (two_sum a b) - (a + b))) by (rewrite <- (two_sum_exact a b) by auto; ring).
  rewrite Rabs_Ropp. apply round_sum; auto. lra.
Qed.

(* Nothing much cancels in the upper parts: the lower parts' sum is within k u of theirs. *)
Lemma add_apart : forall a b k, normal a -> normal b -> 1 <= k <= 3 -> Rabs (lo a + lo b) <= k * u * Rabs (hi a + hi b) ->
  Rabs (value (add a b) - (value a + value b)) <= ((k + 2) * u ^ 2 + (4 * k + 3) * u ^ 3) * Rabs (hi a + hi b).
Proof.
  intros a b k [Ah Al _] [Bh Bl _] Hk H. set (S := Rabs (hi a + hi b)) in *. pose proof (Rabs_pos (hi a + hi b)) as S0. fold S in S0.
  pose proof (two_sum_exact _ _ Ah Bh) as Es. pose proof (two_sum_exact _ _ Al Bl) as Et.
  pose proof (two_sum_lo _ _ Ah Bh) as Ls. fold S in Ls. pose proof (two_sum_lo _ _ Al Bl) as Lt.
  assert (KS : 0 <= k * S <= 3 * S) by (split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_r; lra]).
  replace (k * u * S) with (u * (k * S)) in H by ring.
  replace (((k + 2) * u ^ 2 + (4 * k + 3) * u ^ 3) * S) with ((u ^ 2 + 4 * u ^ 3) * (k * S) + (2 * u ^ 2 + 3 * u ^ 3) * S) by ring.
  set (W := k * S) in *.
  unfold add. set (s := two_sum (hi a) (hi b)) in *. set (t := two_sum (lo a) (lo b)) in *.
  assert (Dsh : double (hi s)) by apply rnd64_double. assert (Dsl : double (lo s)) by apply rnd64_double.
  assert (Dth : double (hi t)) by apply rnd64_double. assert (Dtl : double (lo t)) by apply rnd64_double.
  assert (Lt' : Rabs (lo t) <= u * (u * W)) by (apply Rle_trans with (1 := Lt); apply Rmult_le_compat_l; [unfold u; lra|exact H]).
  assert (C1 : Rabs (lo s + hi t) <= u * S + u * W + u * u * W) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (R1 := round_sum _ _ _ Dsl Dth C1). set (c := rnd64 (lo s + hi t)) in *. assert (Dc : double c) by apply rnd64_double.
  assert (Bsh : (1 - u) * S <= Rabs (hi s) <= (1 + u) * S).
  { unfold S in *. rewrite <- Es in *. split; [|apply Rabs_le; apply Rabs_le_inv in Ls]; unfold u in *; split_Rabs; lra. }
  assert (Bc : Rabs c <= (1 + u) * (u * S + u * W + u * u * W)) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (Ev := fast_two_sum_exact (hi s) c Dsh Dc ltac:(unfold u in *; lra)).
  assert (Lv : Rabs (lo (fast_two_sum (hi s) c)) <= u * ((1 + u) * S + (1 + u) * (u * S + u * W + u * u * W))).
  { replace (lo (fast_two_sum (hi s) c)) with (- (hi (fast_two_sum (hi s) c) - (hi s + c))) by (rewrite <- Ev; ring). rewrite Rabs_Ropp.
    apply round_sum; auto. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  set (v := fast_two_sum (hi s) c) in *. assert (Dvh : double (hi v)) by apply rnd64_double. assert (Dvl : double (lo v)) by apply rnd64_double.
  assert (C2 : Rabs (lo t + lo v) <= u * (u * W + (1 + u) * S + (1 + u) * (u * S + u * W + u * u * W))) by (apply Rabs_le; bounds; unfold u in *;
  lra).
  assert (R2 := round_sum _ _ _ Dtl Dvl C2). set (w := rnd64 (lo t + lo v)) in *. assert (Dw : double w) by apply rnd64_double.
  unfold value at 1. rewrite fast_two_sum_exact; auto.
  2: { assert (Rabs w <= 2 * u * S) by (apply Rabs_le; bounds; unfold u in *; lra).
       assert (Rabs (hi s) - Rabs c - Rabs (lo v) <= Rabs (hi v)); [|unfold u in *; lra].
       replace (hi s) with (hi v + lo v - c) by lra. clear. split_Rabs; lra. }
  unfold value. apply Rabs_le. bounds. unfold u in *. lra.
Qed.

(* Where they do, within a factor 2: their sum and, with it, all but the last rounding are exact; and that is exact if the rest cancels too. *)
Lemma sterbenz_either : forall a b, double a -> double b -> b / 2 <= - a <= 2 * b \/ 2 * b <= - a <= b / 2 -> double (a + b).
Proof.
  intros a b Ha Hb [H|H].
  - replace (a + b) with (b - - a) by ring. apply sterbenz; [apply FLT_exp_valid; reflexivity|apply FLT_exp_monotone|auto|now apply double_opp|lra].
  - replace (a + b) with (a - - b) by ring. apply sterbenz; [apply FLT_exp_valid; reflexivity|apply FLT_exp_monotone|auto|now apply double_opp|lra].
Qed.
Notation place := (cexp radix2 (FLT_exp (-1074) 53)).
Lemma normal_ulp : forall d, normal d -> hi d <> 0 -> Rabs (lo d) <= / 2 * bpow radix2 (place (hi d)).
Proof.
  intros d [Hh Hl E] Z. rewrite <- (ulp_neq_0 radix2 (FLT_exp (-1074) 53) (hi d)) by auto.
  replace (lo d) with (- (rnd64 (value d) - value d)) by (rewrite <- E; unfold value; ring). rewrite Rabs_Ropp. rewrite E.
  apply error_le_half_ulp_round; [apply FLT_exp_valid; reflexivity|apply FLT_exp_monotone].
Qed.
Lemma mag_double : forall x y, x <> 0 -> Rabs x <= 2 * Rabs y -> (mag radix2 x <= mag radix2 y + 1)%Z.
Proof.
  intros x y Z H. assert (y <> 0) by (intros ->; rewrite Rabs_R0 in H; apply Rabs_pos_lt in Z; lra).
  rewrite <- (mag_mult_bpow radix2 y 1) by auto. apply mag_le_abs; auto. change (bpow radix2 1) with 2. rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
  lra.
Qed.
(* The rounded sum of the lower parts has no bit to the right of which the upper parts have none. *)
Lemma lower_place : forall a b, normal a -> normal b -> hi a <> 0 -> hi b <> 0 -> Rabs (hi a) <= 2 * Rabs (hi b) -> Rabs (hi b) <= 2 * Rabs (hi a) ->
  let t := rnd64 (lo a + lo b) in t <> 0 -> (place t <= place (hi a) /\ place t <= place (hi b))%Z.
Proof.
  intros a b Ha Hb Za Zb H1 H2 t Zt. pose proof (normal_ulp a Ha Za) as La. pose proof (normal_ulp b Hb Zb) as Lb.
  pose proof (mag_double _ _ Za H1) as M1. pose proof (mag_double _ _ Zb H2) as M2.
  assert (A : forall c, (place (hi a) <= c + 1)%Z -> (place (hi b) <= c + 1)%Z -> (-1074 <= c)%Z -> (place t <= c)%Z).
  { intros c Ca Cb Hc. apply (bpow_le radix2) in Ca. apply (bpow_le radix2) in Cb.
    assert (L : Rabs t <= bpow radix2 (c + 1)).
    { apply abs_round_le_generic; [apply FLT_exp_valid; reflexivity|apply valid_rnd_N|apply generic_format_bpow; unfold FLT_exp; lia|].
      apply Rle_trans with (1 := Rabs_triang _ _). lra. }
    assert (Mt : (mag radix2 t <= c + 2)%Z).
    { apply mag_le_bpow; auto. apply Rle_lt_trans with (1 := L). apply bpow_lt. lia. }
    unfold cexp, FLT_exp. lia. }
  split; apply A; unfold cexp, FLT_exp; lia.
Qed.

Lemma add_close : forall a b, normal a -> normal b -> hi b / 2 <= - hi a <= 2 * hi b \/ 2 * hi b <= - hi a <= hi b / 2 ->
  Rabs (value (add a b) - (value a + value b)) <= (3 * u ^ 2 + 7 * u ^ 3) * Rabs (value a + value b).
Proof.
  intros a b Ha Hb H. assert (Ah := hi_double a Ha). assert (Bh := hi_double b Hb). assert (Al := lo_double a Ha). assert (Bl := lo_double b Hb).
  assert (D := sterbenz_either _ _ Ah Bh H).
  pose proof (two_sum_exact _ _ Ah Bh) as Es. assert (Hs : hi (two_sum (hi a) (hi b)) = hi a + hi b) by (now apply round_id).
  assert (Ls : lo (two_sum (hi a) (hi b)) = 0) by lra. pose proof (two_sum_exact _ _ Al Bl) as Et.
  assert (Lt : Rabs (lo (two_sum (lo a) (lo b))) <= u * Rabs (hi (two_sum (lo a) (lo b)))).
  { replace (lo (two_sum (lo a) (lo b))) with (- (hi (two_sum (lo a) (lo b)) - (lo a + lo b))) by lra. rewrite Rabs_Ropp.
    now apply round_sum_result. }
  assert (P : hi (two_sum (lo a) (lo b)) <> 0 -> hi a = 0 \/
    (place (hi (two_sum (lo a) (lo b))) <= place (hi a) /\ place (hi (two_sum (lo a) (lo b))) <= place (hi b))%Z).
  { intros Zt. destruct (Req_dec (hi a) 0) as [Za|Za]; [now left|right]. apply lower_place; auto; try (intros Zb; lra); split_Rabs; lra. }
  unfold add. rewrite Ls, Hs. set (t := two_sum (lo a) (lo b)) in *. set (s := hi a + hi b) in *. rewrite Rplus_0_l.
  assert (Dth : double (hi t)) by apply rnd64_double. assert (Dtl : double (lo t)) by apply rnd64_double. rewrite (round_id (hi t)) by auto.
  assert (V : value a + value b = s + hi t + lo t) by (unfold value, s; lra). rewrite V.
  assert (G : hi t <> 0 -> hi a <> 0 -> exists n m, s = IZR n * bpow radix2 (place (hi t)) /\ hi t = IZR m * bpow radix2 (place (hi t)) /\
  (Z.abs m < 2 ^ 53)%Z).
  { intros Zt Za. destruct (P Zt) as [?|[P1 P2]]; [contradiction|].
    destruct (on_grid (hi a) _ Ah P1) as [n1 E1]. destruct (on_grid (hi b) _ Bh P2) as [n2 E2].
    exists (n1 + n2)%Z, (Ztrunc (scaled_mantissa radix2 (FLT_exp (-1074) 53) (hi t))). split; [|split].
    - unfold s. rewrite plus_IZR, Rmult_plus_distr_r. now rewrite <- E1, <- E2.
    - exact Dth.
    - apply lt_IZR. rewrite abs_IZR. rewrite <- scaled_mantissa_generic by exact Dth.
      change (IZR (2 ^ 53)) with (bpow radix2 53). apply Rlt_le_trans with (1 := scaled_mantissa_lt_bpow radix2 (FLT_exp (-1074) 53) (hi t)).
      apply bpow_le. unfold cexp, FLT_exp. lia. }
  pose proof (Rabs_pos (s + hi t)) as X0.
  destruct (Rle_or_lt (Rabs (hi t)) (2 * Rabs (s + hi t))) as [C|C].
  - assert (Ev : hi (fast_two_sum s (hi t)) + lo (fast_two_sum s (hi t)) = s + hi t).
    { destruct (Rle_or_lt (Rabs (hi t)) (Rabs s)) as [h|h]; [now apply fast_two_sum_exact|].
      assert (Zt : hi t <> 0) by (intros E; rewrite E, Rabs_R0 in h; pose proof (Rabs_pos s); lra).
      destruct (Req_dec (hi a) 0) as [Za|Za].
      - destruct (fast_two_sum_double s (hi t)) as [-> ->]; auto; [|ring]. replace (s + hi t) with (hi t); auto. unfold s. lra.
      - destruct (G Zt Za) as (n & m & E1 & E2 & Hm). set (e := place (hi t)) in *.
        assert (h' : Rabs (IZR n * bpow radix2 e) < Rabs (IZR m * bpow radix2 e)) by (rewrite <- E1, <- E2; exact h).
        rewrite !Rabs_mult in h'. apply Rmult_lt_reg_r in h'; [|rewrite Rabs_pos_eq by apply bpow_ge_0; apply bpow_gt_0].
        rewrite <- !abs_IZR in h'. apply lt_IZR in h'.
        pose proof (fast_two_sum_grid n m e ltac:(unfold e, cexp, FLT_exp; lia) ltac:(lia)) as Q. cbv zeta in Q. now rewrite <- E1, <- E2 in Q. }
    assert (Lv : Rabs (lo (fast_two_sum s (hi t))) <= u * Rabs (s + hi t)).
    { replace (lo (fast_two_sum s (hi t))) with (- (hi (fast_two_sum s (hi t)) - (s + hi t))) by lra. rewrite Rabs_Ropp.
      apply round_sum; auto. lra. }
    set (v := fast_two_sum s (hi t)) in *. assert (Dvh : double (hi v)) by apply rnd64_double. assert (Dvl : double (lo v)) by apply rnd64_double.
    set (X := Rabs (s + hi t)) in *.
    assert (T : Rabs (lo t) <= 2 * u * X) by (unfold u in *; lra).
    assert (S2 : Rabs (lo t + lo v) <= 3 * u * X) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
    assert (R := round_sum _ _ _ Dtl Dvl S2). set (w := rnd64 (lo t + lo v)) in *. assert (Dw : double w) by apply rnd64_double.
    unfold value. rewrite fast_two_sum_exact; auto.
    2: { assert (Rabs w <= 4 * u * X) by (apply Rabs_le; bounds; unfold u in *; lra).
         assert (X - Rabs (lo v) <= Rabs (hi v)); [|unfold u in *; lra]. unfold X. rewrite <- Ev. clear. split_Rabs; lra. }
    assert (B : X - 2 * u * X <= Rabs (s + hi t + lo t)) by (unfold X; revert T; unfold X; clear; intros; split_Rabs; lra).
    apply Rle_trans with (3 * u ^ 2 * X).
    + replace (hi v + w - (s + hi t + lo t)) with (w - (lo t + lo v)) by lra. unfold u in *. lra.
    + unfold u in *. lra.
  - assert (Zt : hi t <> 0) by (intros E; rewrite E in C, X0; rewrite Rabs_R0 in C; lra).
    assert (DX : double (s + hi t)).
    { apply sterbenz_either; auto. revert C. clear. split_Rabs; lra. }
    destruct (fast_two_sum_double s (hi t) Dth DX) as [-> ->]. rewrite Rplus_0_r, (round_id (lo t)) by auto.
    assert (Z : hi (fast_two_sum (s + hi t) (lo t)) + lo (fast_two_sum (s + hi t) (lo t)) = s + hi t + lo t).
    { destruct (Req_dec (s + hi t) 0) as [E|E].
      - rewrite E. destruct (fast_two_sum_double 0 (lo t)) as [-> ->]; auto; rewrite ?Rplus_0_l; auto; ring.
      - apply fast_two_sum_exact; auto. destruct (Req_dec (hi a) 0) as [Za|Za].
        { exfalso. replace s with 0 in C by (unfold s; lra). rewrite Rplus_0_l in C. apply Rabs_pos_lt in Zt. lra. }
        destruct (G Zt Za) as (n & m & E1 & E2 & Hm).
        assert (U : Rabs (lo t) <= / 2 * bpow radix2 (place (hi t))).
        { rewrite <- (ulp_neq_0 radix2 (FLT_exp (-1074) 53) (hi t)) by auto.
          replace (lo t) with (- (hi t - (lo a + lo b))) by lra. rewrite Rabs_Ropp.
          apply error_le_half_ulp_round; [apply FLT_exp_valid; reflexivity|apply FLT_exp_monotone]. }
        apply Rle_trans with (1 := U). pose proof (bpow_gt_0 radix2 (place (hi t))) as Pe.
        apply Rle_trans with (1 * bpow radix2 (place (hi t))); [lra|].
        assert (Q : s + hi t = IZR (n + m) * bpow radix2 (place (hi t))) by (rewrite plus_IZR, Rmult_plus_distr_r; now rewrite <- E1, <- E2).
        rewrite Q, Rabs_mult, (Rabs_pos_eq (bpow _ _)) by lra. apply Rmult_le_compat_r; [lra|]. rewrite <- abs_IZR. apply IZR_le.
        destruct (Z.eq_dec (n + m) 0) as [e|e]; [|lia]. rewrite e in Q. rewrite Rmult_0_l in Q. contradiction. }
    unfold value. rewrite Z, Rminus_eq_0, Rabs_R0. apply Rmult_le_pos; [unfold u; lra|apply Rabs_pos].
Qed.

Lemma normal_apart : forall a b k, normal a -> normal b -> 1 <= k <= 3 -> Rabs (hi a) + Rabs (hi b) <= k * Rabs (hi a + hi b) ->
  Rabs (value (add a b) - (value a + value b)) <= ((k + 2) * u ^ 2 + (4 * k + 3) * u ^ 3) * Rabs (hi a + hi b) /\
  (1 - k * u) * Rabs (hi a + hi b) <= Rabs (value a + value b).
Proof.
  intros a b k Ha Hb Hk H. pose proof (normal_lo a Ha) as La. pose proof (normal_lo b Hb) as Lb.
  assert (L : Rabs (lo a + lo b) <= k * u * Rabs (hi a + hi b)).
  { apply Rle_trans with (1 := Rabs_triang _ _). apply Rle_trans with (u * (Rabs (hi a) + Rabs (hi b))); [lra|].
    replace (k * u * Rabs (hi a + hi b)) with (u * (k * Rabs (hi a + hi b))) by ring. apply Rmult_le_compat_l; [unfold u; lra|auto]. }
  split; [now apply add_apart|]. unfold value. replace (hi a + lo a + (hi b + lo b)) with (hi a + hi b + (lo a + lo b)) by ring.
  assert (Rabs (hi a + hi b) - Rabs (lo a + lo b) <= Rabs (hi a + hi b + (lo a + lo b))) by (clear; split_Rabs; lra). lra.
Qed.

(* Operands of one sign, or where much cancels: the published constant. *)
Theorem add_near_same : forall a b, normal a -> normal b -> 0 <= hi a * hi b ->
  Rabs (value (add a b) - (value a + value b)) <= (3 * u ^ 2 + 13 * u ^ 3) * Rabs (value a + value b).
Proof.
  intros a b Ha Hb H. destruct (normal_apart a b 1 Ha Hb) as [B V]; [lra| |].
  - rewrite Rmult_1_l. destruct (Req_dec (hi a) 0) as [Z|Z]; [rewrite Z, Rabs_R0, !Rplus_0_l; apply Rle_refl|].
    assert (C : 0 <= hi a /\ 0 <= hi b \/ hi a <= 0 /\ hi b <= 0); [|clear - C; split_Rabs; lra].
    destruct (Rle_or_lt 0 (hi a)); [left|right]; split; try lra; nra.
  - pose proof (Rabs_pos (hi a + hi b)). apply Rle_trans with (1 := B). unfold u in *. lra.
Qed.
(* Any operands. *)
Theorem add_near : forall a b, normal a -> normal b ->
  Rabs (value (add a b) - (value a + value b)) <= (5 * u ^ 2 + 31 * u ^ 3) * Rabs (value a + value b).
Proof.
  intros a b Ha Hb. pose proof (Rabs_pos (value a + value b)) as V0.
  destruct (Rle_or_lt (Rabs (hi a) + Rabs (hi b)) (3 * Rabs (hi a + hi b))) as [h|h].
  - destruct (normal_apart a b 3 Ha Hb) as [B V]; [lra|auto|]. pose proof (Rabs_pos (hi a + hi b)).
    apply Rle_trans with (1 := B). unfold u in *. lra.
  - apply Rle_trans with ((3 * u ^ 2 + 7 * u ^ 3) * Rabs (value a + value b)); [|unfold u; lra].
    apply add_close; auto. assert (K : Rabs (hi a) + Rabs (hi b) > 3 * Rabs (hi a + hi b)) by lra. clear - K. split_Rabs; lra.
Qed.

(* ---- a double-double times a double: JMP 7 ---- *)

(* QUOTE src/base/dd_parts.h
    const et_dd p = dd_two_product(a.hi, b), t = dd_fast_two_sum(p.hi, a.lo * b);

    return dd_fast_two_sum(t.hi, t.lo + p.lo);
END *)
Definition mul_double (a : dd) (b : R) : dd :=
  let p := two_product (hi a) b in let t := fast_two_sum (hi p) (rnd64 (lo a * b)) in fast_two_sum (hi t) (rnd64 (lo t + lo p)).

Lemma fast_two_sum_lo : forall a b k, double a -> double b -> hi (fast_two_sum a b) + lo (fast_two_sum a b) = a + b -> Rabs (a + b) <= k ->
  Rabs (lo (fast_two_sum a b)) <= u * k.
Proof.
  intros a b k Ha Hb E H. replace (lo (fast_two_sum a b)) with (- (hi (fast_two_sum a b) - (a + b))) by lra. rewrite Rabs_Ropp.
  now apply round_sum.
Qed.

Lemma mul_double_parts : forall a b, normal a -> double b -> bpow radix2 (-905) <= Rabs (hi a * b) ->
  Rabs (value (mul_double a b) - value a * b) <= (3 * u ^ 2 + 5 * u ^ 3) * Rabs (hi a * b) /\
  Rabs (lo (mul_double a b)) <= (u + 3 * u ^ 2) * Rabs (hi a * b).
Proof.
  intros a b Ha Db H. pose proof (normal_lo a Ha) as La. destruct Ha as [Dah Dal _]. set (M := Rabs (hi a * b)) in *.
  pose proof (two_product_exact (hi a) b Dah Db ltac:(right; apply Rle_trans with (2 := H); apply bpow_le; lia)) as E.
  pose proof (eta_small M H) as T. assert (M0 : 0 < M) by (apply Rlt_le_trans with (2 := H); apply bpow_gt_0).
  unfold mul_double. set (p := two_product (hi a) b) in *.
  assert (Dp : double (hi p)) by apply rnd64_double. assert (Dq : double (lo p)) by apply rnd64_double.
  assert (P : Rabs (hi p - hi a * b) <= u * M).
  { apply round_normal; [right|unfold M; lra]. apply Rle_trans with (2 := H). unfold least. apply bpow_le. lia. }
  assert (T1 : Rabs (lo a * b) <= u * M).
  { apply Rle_trans with (1 := product_bound _ _ _ _ La (Rle_refl _)). unfold M. rewrite (Rabs_mult (hi a)). apply Req_le. ring. }
  assert (R1 := round_any _ _ T1). set (c := rnd64 (lo a * b)) in *. assert (Dc : double c) by apply rnd64_double.
  assert (BM : - M <= hi a * b <= M) by (apply Rabs_in; unfold M; lra).
  assert (Bp : (1 - u) * M <= Rabs (hi p)).
  { assert (M - Rabs (hi p) <= u * M); [|lra]. apply Rle_trans with (2 := P). unfold M. rewrite Rabs_minus_sym. apply Rabs_triang_inv. }
  assert (Bc : Rabs c <= (u + 2 * u * u) * M) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (Et := fast_two_sum_exact (hi p) c Dp Dc ltac:(unfold u in *; lra)).
  assert (S1 : Rabs (hi p + c) <= (1 + 3 * u) * M) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (Lt := fast_two_sum_lo _ _ _ Dp Dc Et S1). set (t := fast_two_sum (hi p) c) in *.
  assert (Dth : double (hi t)) by apply rnd64_double. assert (Dtl : double (lo t)) by apply rnd64_double.
  assert (S2 : Rabs (lo t + lo p) <= (2 * u + 3 * u * u) * M) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (R2 := round_sum _ _ _ Dtl Dq S2). set (w := rnd64 (lo t + lo p)) in *. assert (Dw : double w) by apply rnd64_double.
  assert (Bt : (1 - 4 * u) * M <= Rabs (hi t)).
  { assert (Rabs (hi p) - Rabs c - Rabs (lo t) <= Rabs (hi t)); [|unfold u in *; lra]. replace (hi p) with (hi t + lo t - c) by lra.
    clear. split_Rabs; lra. }
  assert (Bw : Rabs w <= 3 * u * M) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (Er := fast_two_sum_exact (hi t) w Dth Dw ltac:(unfold u in *; lra)). split.
  - unfold value. rewrite Er. apply Rabs_le. bounds. replace ((hi a + lo a) * b) with (hi p + lo p + lo a * b) by (rewrite E; ring).
    unfold u in *. lra.
  - apply Rle_trans with (u * ((1 + 3 * u) * M)); [|unfold u; lra]. apply fast_two_sum_lo; auto. apply Rabs_le. bounds. unfold u in *. lra.
Qed.

Theorem mul_double_near : forall a b, normal a -> double b -> bpow radix2 (-900) <= Rabs (hi a * b) ->
  Rabs (value (mul_double a b) - value a * b) <= (3 * u ^ 2 + 9 * u ^ 3) * Rabs (value a * b).
Proof.
  intros a b Ha Db H. destruct (mul_double_parts a b Ha Db) as [B _]; [apply Rle_trans with (2 := H); apply bpow_le; lia|].
  pose proof (Rabs_pos (hi a * b)). assert (V : (1 - u) * Rabs (hi a * b) <= Rabs (value a * b)).
  { rewrite !Rabs_mult, <- Rmult_assoc. apply Rmult_le_compat_r; [apply Rabs_pos|]. pose proof (normal_lo a Ha) as L. unfold value.
    assert (Rabs (hi a) - Rabs (lo a) <= Rabs (hi a + lo a)) by (clear; split_Rabs; lra). lra. }
  apply Rle_trans with (1 := B). unfold u in *. lra.
Qed.

(* ---- the quotient: JMP 17 ---- *)

(* QUOTE src/base/dd_parts.h
    const double q = a.hi / b.hi;
    const et_dd r = dd_mul_double(b, q);

    return dd_fast_two_sum(q, ((a.hi - r.hi) + (a.lo - r.lo)) / b.hi);
END
   QUOTE src/base/dd.c
    return dd_div(a, b);
END *)
Definition div (a b : dd) : dd :=
  let q := rnd64 (hi a / hi b) in let r := mul_double b q in
  fast_two_sum q (rnd64 (rnd64 (rnd64 (hi a - hi r) + rnd64 (lo a - lo r)) / hi b)).

Lemma value_big : forall a, normal a -> (1 - u) * Rabs (hi a) <= Rabs (value a).
Proof.
  intros a Ha. pose proof (normal_lo a Ha) as L. unfold value.
  assert (Rabs (hi a) - Rabs (lo a) <= Rabs (hi a + lo a)) by (clear; split_Rabs; lra). lra.
Qed.

Theorem div_near : forall a b, normal a -> normal b -> hi a = 0 \/ bpow radix2 (-900) <= Rabs (hi a) -> bpow radix2 (-900) <= Rabs (hi b) ->
  hi a = 0 \/ bpow radix2 (-900) * Rabs (hi b) <= Rabs (hi a) ->
  Rabs (value (div a b) - value a / value b) <= (14 * u ^ 2 + 90 * u ^ 3) * Rabs (value a / value b).
Proof.
  intros a b Ha Hb Ra Rb Rq. pose proof (normal_lo a Ha) as La. pose proof (normal_lo b Hb) as Lb.
  assert (Pb : 0 < Rabs (hi b)) by (apply Rlt_le_trans with (2 := Rb); apply bpow_gt_0).
  assert (Zb : hi b <> 0) by (intros E; rewrite E, Rabs_R0 in Pb; lra).
  pose proof (value_big b Hb) as Vb. assert (Zv : value b <> 0).
  { intros E. rewrite E, Rabs_R0 in Vb. unfold u in Vb. lra. }
  destruct (Req_dec (hi a) 0) as [Za|Za].
  { assert (E : value (div a b) = 0).
    { unfold value, div, mul_double. rewrite Za, (normal_0 a Ha Za). unfold Rdiv. rewrite Rmult_0_l, round_0, two_product_0_r.
      unfold fast_two_sum. cbn [hi lo]. zeros. ring. }
    rewrite E. unfold value. rewrite Za, (normal_0 a Ha Za). unfold Rdiv. rewrite Rplus_0_l, Rmult_0_l, Rminus_0_r, Rabs_R0. lra. }
  destruct Ra as [?|Ra]; [contradiction|]. destruct Rq as [?|Rq]; [contradiction|].
  assert (Dah := hi_double a Ha). assert (Dal := lo_double a Ha). assert (Dbh := hi_double b Hb). assert (Dbl := lo_double b Hb).
  set (N := Rabs (hi a)) in *. set (K := Rabs (hi a / hi b)).
  assert (EK : K * Rabs (hi b) = N) by (unfold K, N; rewrite <- Rabs_mult; f_equal; field; auto).
  assert (BK : bpow radix2 (-900) <= K) by (apply Rmult_le_reg_r with (1 := Pb); rewrite EK; exact Rq).
  assert (Q : Rabs (rnd64 (hi a / hi b) - hi a / hi b) <= u * K).
  { apply round_normal; [right|unfold K; lra]. apply Rle_trans with (2 := BK). unfold least. apply bpow_le. lia. }
  unfold div. set (q := rnd64 (hi a / hi b)) in *. assert (Dq : double q) by apply rnd64_double.
  assert (Bq : Rabs (hi b * q - hi a) <= u * N).
  { replace (hi b * q - hi a) with ((q - hi a / hi b) * hi b) by (field; auto). rewrite Rabs_mult, <- EK.
    rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [lra|exact Q]. }
  assert (BN : - N <= hi a <= N) by (apply Rabs_in; unfold N; lra).
  set (M := Rabs (hi b * q)).
  assert (BM : (1 - u) * N <= M <= (1 + u) * N).
  { revert Bq. unfold M, N. clear. intros. split_Rabs; lra. }
  assert (N0 : 0 < N) by (apply Rlt_le_trans with (2 := Ra); apply bpow_gt_0).
  assert (HM : bpow radix2 (-905) <= M).
  { apply Rle_trans with (/ 32 * bpow radix2 (-900)); [|unfold u in *; lra]. change (-905)%Z with (-5 + -900)%Z. rewrite bpow_plus.
    apply Rmult_le_compat_r; [apply bpow_ge_0|simpl; lra]. }
  destruct (mul_double_parts b q Hb Dq HM) as [E1 E2]. fold M in E1, E2. set (r := mul_double b q) in *.
  assert (Drh : double (hi r)) by apply rnd64_double. assert (Drl : double (lo r)) by apply rnd64_double.
  assert (T1 : Rabs (lo b * q) <= u * M).
  { apply Rle_trans with (1 := product_bound _ _ _ _ Lb (Rle_refl _)). unfold M. rewrite (Rabs_mult (hi b)). apply Req_le. ring. }
  unfold value in E1. replace ((hi b + lo b) * q) with (hi b * q + lo b * q) in E1 by ring.
  assert (Bd : Rabs (hi a - hi r) <= / 4 * N).
  { apply Rabs_le. bounds. unfold u in *. lra. }
  assert (Dd : double (hi a - hi r)).
  { replace (hi a - hi r) with (hi a + - hi r) by ring. apply sterbenz_either; auto; [now apply double_opp|].
    revert Bd. unfold N. clear. intros. split_Rabs; lra. }
  rewrite (round_id (hi a - hi r)) by auto.
  assert (S1 : Rabs (lo a - lo r) <= (2 * u + 6 * u ^ 2) * N) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (R1 := round_sum (lo a) (- lo r) _ Dal (double_opp _ Drl) S1). fold (lo a - lo r) in R1.
  set (l := rnd64 (lo a - lo r)) in *. assert (Dl : double l) by apply rnd64_double.
  assert (S2 : Rabs (hi a - hi r + l) <= (3 * u + 8 * u ^ 2) * N) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (R2 := round_sum (hi a - hi r) l _ Dd Dl S2). set (d := rnd64 (hi a - hi r + l)) in *.
  assert (S3 : Rabs d <= (3 * u + 12 * u ^ 2) * N) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (S4 : Rabs (d / hi b) <= (3 * u + 12 * u ^ 2) * K).
  { apply Rmult_le_reg_r with (1 := Pb). rewrite <- Rabs_mult. replace (d / hi b * hi b) with d by (field; auto). rewrite Rmult_assoc, EK. exact S3. }
  assert (R3 := round_any _ _ S4). pose proof (eta_small K ltac:(apply Rle_trans with (2 := BK); apply bpow_le; lia)) as T.
  set (t := rnd64 (d / hi b)) in *. assert (Dt : double t) by apply rnd64_double.
  assert (K0 : 0 < K) by (apply Rlt_le_trans with (2 := BK); apply bpow_gt_0).
  assert (Bt : Rabs (t - d / hi b) <= (3 * u ^ 2 + 13 * u ^ 3) * K) by (apply Rle_trans with (1 := R3); unfold u in *; lra).
  assert (Bt' : Rabs t <= 4 * u * K) by (apply Rabs_le; bounds; unfold u in *; lra).
  unfold value at 1. rewrite fast_two_sum_exact; auto.
  2: { apply Rle_trans with (1 := Bt'). assert (K - u * K <= Rabs q) by (revert Q; unfold K; clear; intros; split_Rabs; lra). unfold u in *. lra. }
  assert (B1 : Rabs (t * hi b - d) <= (3 * u ^ 2 + 13 * u ^ 3) * N).
  { replace (t * hi b - d) with ((t - d / hi b) * hi b) by (field; auto). rewrite Rabs_mult, <- EK, <- Rmult_assoc.
    apply Rmult_le_compat_r; [lra|exact Bt]. }
  assert (B2 : Rabs (t * lo b) <= u * ((3 * u + 16 * u ^ 2) * N)).
  { assert (W : Rabs (t * hi b) <= (3 * u + 16 * u ^ 2) * N) by (apply Rabs_le; bounds; unfold u in *; lra).
    apply Rle_trans with (u * Rabs (t * hi b)); [|apply Rmult_le_compat_l; [unfold u; lra|exact W]].
    rewrite !Rabs_mult. rewrite <- Rmult_assoc, (Rmult_comm u), Rmult_assoc. apply Rmult_le_compat_l; [apply Rabs_pos|exact Lb]. }
  assert (F : Rabs ((q + t) * value b - value a) <= (14 * u ^ 2 + 60 * u ^ 3) * N).
  { unfold value. replace ((q + t) * (hi b + lo b) - (hi a + lo a)) with (hi b * q + lo b * q + t * hi b + t * lo b - (hi a + lo a)) by ring.
    apply Rabs_le. bounds. unfold u in *. lra. }
  pose proof (value_big a Ha) as Va. fold N in Va.
  replace (q + t - value a / value b) with (((q + t) * value b - value a) / value b) by (field; auto).
  unfold Rdiv. rewrite !Rabs_mult, <- Rmult_assoc. apply Rmult_le_compat_r; [apply Rabs_pos|].
  apply Rle_trans with (1 := F). unfold u in *. lra.
Qed.
Corollary div_near_published : forall a b, normal a -> normal b -> hi a = 0 \/ bpow radix2 (-900) <= Rabs (hi a) ->
bpow radix2 (-900) <= Rabs (hi b) ->
  hi a = 0 \/ bpow radix2 (-900) * Rabs (hi b) <= Rabs (hi a) ->
  Rabs (value (div a b) - value a / value b) <= (15 * u ^ 2 + 56 * u ^ 3) * Rabs (value a / value b).
Proof.
  intros a b Ha Hb Ra Rb Rq. apply Rle_trans with (1 := div_near a b Ha Hb Ra Rb Rq). apply Rmult_le_compat_r; [apply Rabs_pos|unfold u; lra].
Qed.

(* ---- the square root: SQRTDWtoDW ---- *)

(* QUOTE src/base/dd_parts.h
    const double s = sqrt(a.hi);
    const et_dd p = dd_two_product(s, s);

    if (a.hi == 0)
        return (et_dd){s, 0};
    return dd_fast_two_sum(s, (((a.hi - p.hi) - p.lo) + a.lo) / (2 * s));
END
   QUOTE src/base/dd.c
    return dd_sqrt(a);
END *)
Definition root (a : dd) : dd :=
  let s := rnd64 (sqrt (hi a)) in let p := two_product s s in
  if Req_EM_T (hi a) 0 then DD s 0
  else fast_two_sum s (rnd64 (rnd64 (rnd64 (rnd64 (hi a - hi p) - lo p) + lo a) / rnd64 (2 * s))).

Theorem root_0 : forall a, hi a = 0 -> value (root a) = 0.
Proof. intros a H. unfold root, value. destruct (Req_EM_T (hi a) 0); [|contradiction]. cbn [hi lo]. rewrite H, sqrt_0, round_0. ring. Qed.

Theorem root_near : forall a, normal a -> bpow radix2 (-900) <= hi a ->
  Rabs (value (root a) * value (root a) - value a) <= (33 / 4 * u ^ 2 + 80 * u ^ 3) * value a.
Proof.
  intros a Ha Ra. pose proof (normal_lo a Ha) as La. assert (Dh := hi_double a Ha). assert (Dl := lo_double a Ha).
  set (N := hi a) in *. assert (N0 : 0 < N) by (apply Rlt_le_trans with (2 := Ra); apply bpow_gt_0). rewrite (Rabs_pos_eq N) in La by lra.
  unfold root. fold N. destruct (Req_EM_T N 0) as [?|_]; [lra|].
  set (z := sqrt N). assert (Ez : z * z = N) by (apply sqrt_sqrt; lra).
  assert (Bz : bpow radix2 (-450) <= z).
  { unfold z. rewrite <- (sqrt_Rsqr (bpow radix2 (-450))) by apply bpow_ge_0. apply sqrt_le_1_alt. unfold Rsqr. rewrite <- bpow_plus. exact Ra. }
  assert (z0 : 0 < z) by (apply Rlt_le_trans with (2 := Bz); apply bpow_gt_0).
  assert (Nz : least <= Rabs z) by (rewrite Rabs_pos_eq by lra; apply Rle_trans with (2 := Bz); apply bpow_le; lia).
  assert (Rs : Rabs (rnd64 z - z) <= u * z) by (apply round_normal; [now right|rewrite Rabs_pos_eq; lra]).
  assert (Fs : generic_format radix2 (FLX_exp 53) (N - rnd64 z * rnd64 z)).
  { rewrite (rnd64_normal z) by (now right). refine (sqrt_error_FLX_N radix2 53 (fun n => negb (Z.even n)) eq_refl N _).
    exact (generic_format_FLX_FLT _ _ _ _ Dh). }
  set (s := rnd64 z) in *. assert (Ds : double s) by apply rnd64_double. apply Rabs_in in Rs.
  assert (s0 : (1 - u) * z <= s <= (1 + u) * z) by lra.
  assert (sp : 0 < s) by (unfold u in *; lra).
  assert (Bs : (1 - 2 * u) * N <= s * s <= (1 + 2 * u + u ^ 2) * N).
  { rewrite <- Ez. split.
    - apply Rle_trans with (((1 - u) * z) * ((1 - u) * z)); [|].
      1: replace ((1 - u) * z * ((1 - u) * z)) with ((1 - u) ^ 2 * (z * z)) by ring; apply Rmult_le_compat_r; [apply Rle_0_sqr|unfold u; lra].
      apply Rmult_le_compat; unfold u in *; lra.
    - apply Rle_trans with (((1 + u) * z) * ((1 + u) * z)); [apply Rmult_le_compat; lra|]. right. ring. }
  assert (E : hi (two_product s s) + lo (two_product s s) = s * s).
  { apply two_product_exact; auto. right. rewrite Rabs_pos_eq by (apply Rle_0_sqr).
    apply Rle_trans with (/ 2 * bpow radix2 (-900)); [|unfold u in *; lra]. change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus.
    apply bpow_le. lia. }
  assert (P : Rabs (hi (two_product s s) - s * s) <= u * ((1 + 3 * u) * N)).
  { apply round_normal.
    - right. rewrite Rabs_pos_eq by (apply Rle_0_sqr). apply Rle_trans with (/ 2 * bpow radix2 (-900)); [|unfold u in *; lra].
      change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus. apply bpow_le. lia.
    - rewrite Rabs_pos_eq by (apply Rle_0_sqr). unfold u in *. lra. }
  set (p := two_product s s) in *. assert (Dp : double (hi p)) by apply rnd64_double. assert (Dq : double (lo p)) by apply rnd64_double.
  assert (Dd : double (N - hi p)).
  { replace (N - hi p) with (N + - hi p) by ring. apply sterbenz_either; auto; [now apply double_opp|].
    right. apply Rabs_in in P. unfold u in *. lra. }
  rewrite (round_id (N - hi p)) by auto.
  assert (Er : rnd64 (N - hi p - lo p) = N - s * s).
  { unfold Rminus at 1. rewrite rnd64_sum by (auto; now apply double_opp).
    replace (N - hi p + - lo p) with (N - s * s) by lra. apply round_generic; [apply valid_rnd_N|exact Fs]. }
  assert (Drho : double (N - s * s)) by (rewrite <- Er; apply rnd64_double). rewrite Er.
  assert (S1 : Rabs (N - s * s + lo a) <= (3 * u + u ^ 2) * N) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (R1 := round_sum _ _ _ Drho Dl S1). set (d := rnd64 (N - s * s + lo a)) in *.
  assert (S2 : Rabs d <= (3 * u + 5 * u ^ 2) * N) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (E2 : rnd64 (2 * s) = 2 * s).
  { apply round_id. replace (2 * s) with (s * bpow radix2 1) by (change (bpow radix2 1) with 2; ring).
    apply mult_bpow_pos_exact_FLT; [exact Ds|lia]. }
  rewrite E2. set (K := N / (2 * s)). assert (EK : K * (2 * s) = N) by (unfold K; field; lra).
  assert (BK : bpow radix2 (-905) <= K).
  { apply Rle_trans with (s / 4).
    - apply Rle_trans with (/ 8 * bpow radix2 (-450)); [|unfold u in *; lra].
      change (/ 8) with (bpow radix2 (-3)). rewrite <- bpow_plus. apply bpow_le. lia.
    - apply Rmult_le_reg_r with (2 * s); [lra|]. rewrite EK. unfold u in *. lra. }
  assert (S3 : Rabs (d / (2 * s)) <= (3 * u + 5 * u ^ 2) * K).
  { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (apply Rlt_le, Rinv_0_lt_compat; lra).
    unfold K, Rdiv. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra|exact S2]. }
  assert (R3 := round_any _ _ S3). pose proof (eta_small K BK) as T.
  set (t := rnd64 (d / (2 * s))) in *. assert (Dt : double t) by apply rnd64_double.
  assert (K0 : 0 < K) by (apply Rlt_le_trans with (2 := BK); apply bpow_gt_0).
  assert (R4 : Rabs (t - d / (2 * s)) <= (3 * u ^ 2 + 6 * u ^ 3) * K) by (apply Rle_trans with (1 := R3); unfold u in *; lra).
  assert (Bt : Rabs t <= 4 * u * K) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (KS : K <= 2 * s) by (apply Rmult_le_reg_r with (2 * s); [lra|]; rewrite EK; unfold u in *; lra).
  unfold value at 1 2. rewrite fast_two_sum_exact; auto.
  2: { rewrite (Rabs_pos_eq s) by lra. unfold u in *. lra. }
  assert (G : Rabs (2 * s * t - d) <= (3 * u ^ 2 + 6 * u ^ 3) * N).
  { replace (2 * s * t - d) with ((t - d / (2 * s)) * (2 * s)) by (field; lra). rewrite Rabs_mult, (Rabs_pos_eq (2 * s)) by lra.
    replace ((3 * u ^ 2 + 6 * u ^ 3) * N) with ((3 * u ^ 2 + 6 * u ^ 3) * K * (2 * s)) by (rewrite Rmult_assoc, EK; ring).
    apply Rmult_le_compat_r; [lra|exact R4]. }
  assert (W : Rabs (2 * s * t) <= (3 * u + 9 * u ^ 2) * N) by (apply Rabs_le; bounds; unfold u in *; lra).
  assert (Q : 0 <= t * t <= (9 / 4 * u ^ 2 + 20 * u ^ 3) * N).
  { split; [apply Rle_0_sqr|]. pose proof (product_bound _ _ _ _ W W) as WW. apply Rabs_in in WW.
    apply Rmult_le_reg_r with (4 * (s * s)); [apply Rmult_lt_0_compat; [lra|apply Rmult_lt_0_compat; lra]|].
    replace (t * t * (4 * (s * s))) with (2 * s * t * (2 * s * t)) by ring. apply Rle_trans with (1 := proj2 WW).
    apply Rle_trans with ((9 / 4 * u ^ 2 + 20 * u ^ 3) * N * (4 * ((1 - 2 * u) * N))).
    - assert (0 <= N * N) by (apply Rle_0_sqr).
      replace ((3 * u + 9 * u ^ 2) * N * ((3 * u + 9 * u ^ 2) * N)) with ((3 * u + 9 * u ^ 2) ^ 2 * (N * N)) by ring.
      replace ((9 / 4 * u ^ 2 + 20 * u ^ 3) * N * (4 * ((1 - 2 * u) * N))) with ((9 / 4 * u ^ 2 + 20 * u ^ 3) * (4 * (1 - 2 * u)) * (N * N)) by ring.
      apply Rmult_le_compat_r; [auto|unfold u; lra].
    - apply Rmult_le_compat_l; [apply Rmult_le_pos; [unfold u; lra|lra]|]. lra. }
  apply Rle_trans with ((33 / 4 * u ^ 2 + 60 * u ^ 3) * N).
  - unfold value. fold N. replace ((s + t) * (s + t)) with (s * s + 2 * s * t + t * t) by ring. apply Rabs_le. bounds. unfold u in *. lra.
  - unfold value. fold N. bounds. unfold u in *. lra.
Qed.

(* ---- the hypotheses can be met ---- *)

(* Every sum of two doubles is in normal form; so is a double by itself. *)
Theorem two_sum_normal : forall a b, double a -> double b -> normal (two_sum a b).
Proof. intros a b Ha Hb. split; try apply rnd64_double. unfold value. rewrite two_sum_exact by auto. reflexivity. Qed.
Lemma double_normal : forall x, double x -> normal (DD x 0).
Proof. intros x H. split; cbn [hi lo]; auto using double_0. unfold value. cbn [hi lo]. now rewrite Rplus_0_r, round_id. Qed.
Theorem fast_two_sum_normal : forall a b, double a -> double b -> Rabs b <= Rabs a -> normal (fast_two_sum a b).
Proof. intros a b Ha Hb H. split; try apply rnd64_double. unfold value. rewrite fast_two_sum_exact by auto. reflexivity. Qed.

(* 1 + 2^-60, of which the lower part is not 0. *)
Example unity : dd := two_sum 1 (bpow radix2 (-60)).
Example unity_normal : normal unity.
Proof.
  apply two_sum_normal; [change 1 with (bpow radix2 0)|]; apply generic_format_bpow; unfold FLT_exp; lia.
Qed.
Example unity_is : value unity = 1 + bpow radix2 (-60).
Proof. apply two_sum_exact; [change 1 with (bpow radix2 0)|]; apply generic_format_bpow; unfold FLT_exp; lia. Qed.
Example unity_range : bpow radix2 (-900) <= hi unity.
Proof.
  change (hi unity) with (rnd64 (1 + bpow radix2 (-60))). apply Rle_trans with 1; [change 1 with (bpow radix2 0); apply bpow_le; lia|].
  apply round_ge_generic; [apply FLT_exp_valid; reflexivity|apply valid_rnd_N| |pose proof (bpow_gt_0 radix2 (-60)); lra].
  change 1 with (bpow radix2 0). apply generic_format_bpow. unfold FLT_exp. lia.
Qed.
Example unity_root : Rabs (value (root unity) * value (root unity) - value unity) <= (33 / 4 * u ^ 2 + 80 * u ^ 3) * value unity.
Proof. exact (root_near unity unity_normal unity_range). Qed.
Example unity_quotient : Rabs (value (div unity unity) - 1) <= 15 * u ^ 2 + 56 * u ^ 3.
Proof.
  pose proof unity_range as R. pose proof (bpow_gt_0 radix2 (-900)) as P.
  assert (A : bpow radix2 (-900) <= Rabs (hi unity)) by (rewrite Rabs_pos_eq by lra; exact R).
  pose proof (div_near_published unity unity unity_normal unity_normal (or_intror A) A) as H.
  assert (V : value unity / value unity = 1).
  { rewrite unity_is. pose proof (bpow_gt_0 radix2 (-60)). field. lra. }
  rewrite V, Rabs_R1, Rmult_1_r in H. apply H. right. rewrite <- (Rmult_1_l (Rabs (hi unity))) at 2. apply Rmult_le_compat_r; [lra|].
  change 1 with (bpow radix2 0). apply bpow_le. lia.
Qed.
