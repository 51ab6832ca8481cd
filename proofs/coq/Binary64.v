(* The bounds of Rounding.v for IEEE binary64 (Flocq's: gradual underflow, infinities), under conditions that are written out: `guarded` is an
   arithmetic that carries, beside the rounded value, the proposition that no operation that led to it over- or underflowed:
     a sum or difference must not overflow (it never underflows: where it is small it is exact);
     a product or quotient must be 0 or at least 2^-1022, and must not overflow; a divisor must not be 0.
   Where that holds the numbers of the machine are those of unbounded exponents, and every theorem of Rounding.v applies.
   `guard_enough` gives a condition on the knots alone. *)
From Coq Require Import Reals Lra Lia Arith ZArith Psatz List Bool Floats.
From Flocq Require Import Core Relative Plus_error IEEE754.BinarySingleNaN.
From Etalon Require Import RoundingScheme Rounding.
Open Scope R_scope.

(* ---- 53 bits to nearest, ties to even; unbounded exponents (rnd) and those of binary64 (rnd64) ---- *)

Definition u64 : R := bpow radix2 (-53).
Definition rnd : R -> R := round radix2 (FLX_exp 53) ZnearestE.
Definition rnd64 : R -> R := round radix2 (FLT_exp (-1074) 53) ZnearestE.
Definition least : R := bpow radix2 (-1022).
Definition most : R := bpow radix2 1024.

Lemma u64_range : 0 <= u64 < 1.
Proof. unfold u64; simpl; lra. Qed.
#[local] Instance precision : Prec_gt_0 53.
Proof. reflexivity. Qed.
Lemma rnd_error : forall y, Rabs (rnd y - y) <= u64 * Rabs y.
Proof.
  intros y. pose proof (relative_error_N_FLX radix2 53 precision (fun x => negb (Z.even x)) y) as H.
  change (round radix2 (FLX_exp 53) (Znearest (fun x => negb (Z.even x))) y) with (rnd y) in H.
  replace (/ 2 * bpow radix2 (- (53) + 1)) with u64 in H; auto. unfold u64; simpl; lra.
Qed.
Lemma rnd_idem : forall y, rnd (rnd y) = rnd y.
Proof.
  intros y. apply round_generic; [apply valid_rnd_N|]. apply generic_format_round; [apply FLX_exp_valid; reflexivity|apply valid_rnd_N].
Qed.
Lemma format_rnd : forall y, generic_format radix2 (FLT_exp (-1074) 53) y -> rnd y = y.
Proof.
  intros y H. apply round_generic; [apply valid_rnd_N|]. now apply generic_format_FLX_FLT with (emin := (-1074)%Z).
Qed.
Lemma rnd64_normal : forall y, y = 0 \/ least <= Rabs y -> rnd64 y = rnd y.
Proof.
  intros y [->|H]; unfold rnd64, rnd.
  - now rewrite !round_0 by apply valid_rnd_N.
  - apply round_FLT_FLX. exact H.
Qed.
Lemma rnd64_sum : forall x y, generic_format radix2 (FLT_exp (-1074) 53) x -> generic_format radix2 (FLT_exp (-1074) 53) y ->
  rnd64 (x + y) = rnd (x + y).
Proof.
  intros x y Hx Hy. destruct (Rle_or_lt least (Rabs (x + y))) as [h|h]; [apply rnd64_normal; auto|].
  assert (G : generic_format radix2 (FLT_exp (-1074) 53) (x + y)).
  { apply (FLT_format_plus_small radix2 (-1074) 53); auto. apply Rlt_le, Rlt_le_trans with (1 := h). unfold least. apply bpow_le. lia. }
  rewrite format_rnd by auto. apply round_generic; [apply valid_rnd_N|auto].
Qed.

(* ---- the machine's numbers and the guarded ones ---- *)

#[local] Instance prec_pos : FLX.Prec_gt_0 prec := eq_refl.
#[local] Instance prec_emax : Prec_lt_emax prec emax := eq_refl.
Notation float64 := (binary_float prec emax).
Definition binary64 : arithmetic :=
  Arithmetic float64 (B754_zero false) Bone (Bplus mode_NE) (Bminus mode_NE) (Bmult mode_NE) (Bdiv mode_NE) Bltb Beqb.

Definition guarded_number : Type := (R * Prop)%type.
Definition lifted (op : R -> R -> R) (safe : R -> R -> Prop) (a b : guarded_number) : guarded_number :=
  (rnd (op (fst a) (fst b)), snd a /\ snd b /\ safe (fst a) (fst b)).
Definition no_overflow (y : R) : Prop := Rabs (rnd y) < most.
Definition no_underflow (y : R) : Prop := y = 0 \/ least <= Rabs y.
Definition guarded : arithmetic :=
  Arithmetic guarded_number (0, True) (1, True)
    (lifted Rplus (fun x y => no_overflow (x + y))) (lifted Rminus (fun x y => no_overflow (x - y)))
    (lifted Rmult (fun x y => no_overflow (x * y) /\ no_underflow (x * y)))
    (lifted Rdiv (fun x y => y <> 0 /\ no_overflow (x / y) /\ no_underflow (x / y)))
    (fun a b => less_R (fst a) (fst b)) (fun a b => same_R (fst a) (fst b)).

(* b is the guarded number a, provided nothing went wrong on the way. *)
Definition holds (b : binary64) (a : guarded) : Prop := snd a -> is_finite b = true /\ B2R b = fst a.
Definition value (a : guarded) (y : rounded rnd) : Prop := fst a = y.

Lemma format : forall b : float64, generic_format radix2 (FLT_exp (-1074) 53) (B2R b).
Proof. intros b. exact (generic_format_B2R prec emax b). Qed.
Lemma bounded : forall y, Rabs y < most -> Rlt_bool (Rabs y) (bpow radix2 emax) = true.
Proof. intros. now apply Rlt_bool_true. Qed.

Lemma holds_add : forall a a' b b', holds a a' -> holds b b' -> holds (add a b) (add a' b').
Proof.
  intros a [x P] b [y Q] Ha Hb (HP & HQ & HS). cbn in *. destruct (Ha HP) as [Fa Ra], (Hb HQ) as [Fb Rb]. cbn in *. subst x y.
  pose proof (Bplus_correct prec emax _ _ mode_NE a b Fa Fb) as H. change (round radix2 _ _ (B2R a + B2R b)) with (rnd64 (B2R a + B2R b)) in H.
  rewrite rnd64_sum in H by apply format. rewrite bounded in H by exact HS. tauto.
Qed.
Lemma holds_sub : forall a a' b b', holds a a' -> holds b b' -> holds (sub a b) (sub a' b').
Proof.
  intros a [x P] b [y Q] Ha Hb (HP & HQ & HS). cbn in *. destruct (Ha HP) as [Fa Ra], (Hb HQ) as [Fb Rb]. cbn in *. subst x y.
  pose proof (Bminus_correct prec emax _ _ mode_NE a b Fa Fb) as H. change (round radix2 _ _ (B2R a - B2R b)) with (rnd64 (B2R a - B2R b)) in H.
  unfold Rminus in H. rewrite rnd64_sum in H by (try apply generic_format_opp; apply format). fold (B2R a - B2R b) in H. rewrite bounded in H by
    exact HS. tauto.
Qed.
Lemma holds_mul : forall a a' b b', holds a a' -> holds b b' -> holds (mul a b) (mul a' b').
Proof.
  intros a [x P] b [y Q] Ha Hb (HP & HQ & HS & HU). cbn in *. destruct (Ha HP) as [Fa Ra], (Hb HQ) as [Fb Rb]. cbn in *. subst x y.
  pose proof (Bmult_correct prec emax _ _ mode_NE a b) as H. change (round radix2 _ _ (B2R a * B2R b)) with (rnd64 (B2R a * B2R b)) in H.
  rewrite rnd64_normal in H by exact HU. rewrite bounded in H by exact HS. rewrite Fa, Fb in H. cbn in H. tauto.
Qed.
Lemma holds_div : forall a a' b b', holds a a' -> holds b b' -> holds (div a b) (div a' b').
Proof.
  intros a [x P] b [y Q] Ha Hb (HP & HQ & HZ & HS & HU). cbn in *. destruct (Ha HP) as [Fa Ra], (Hb HQ) as [Fb Rb]. cbn in *. subst x y.
  pose proof (Bdiv_correct prec emax _ _ mode_NE a b HZ) as H. change (round radix2 _ _ (B2R a / B2R b)) with (rnd64 (B2R a / B2R b)) in H.
  rewrite rnd64_normal in H by exact HU. rewrite bounded in H by exact HS. rewrite Fa in H. cbn in H. tauto.
Qed.
Lemma holds_zero : holds zero zero.
Proof. now intros _. Qed.
Lemma holds_one : holds one one.
Proof. intros _. split; [reflexivity|exact (Bone_correct prec emax _ _)]. Qed.
Lemma value_op : forall op safe a y b z, fst a = y -> fst b = z -> fst (lifted op safe a b) = rnd (op y z).
Proof. intros; subst; reflexivity. Qed.

(* A number that is given: finite, and nothing has gone wrong yet. *)
Definition given (b : float64) : guarded := (B2R b, True).
Lemma given_holds : forall b, is_finite b = true -> holds b (given b).
Proof. now intros b H _. Qed.

(* ---- the loops ---- *)

Section Basis.
Variables (t : nat -> float64) (p s : nat) (x : float64).
Hypothesis knots_finite : forall i, is_finite (t i) = true.
Hypothesis x_finite : is_finite x = true.
Notation T := (fun i => B2R (t i)).
Notation X := (B2R x).
Notation L := (to_left (A := binary64) t s x).
Notation Rt := (to_right (A := binary64) t s x).
Notation Lg := (to_left (A := guarded) (fun i => given (t i)) s (given x)).
Notation Rg := (to_right (A := guarded) (fun i => given (t i)) s (given x)).

Lemma given_all : rel_all (A := binary64) (B := guarded) holds t (fun i => given (t i)).
Proof. intros i. now apply given_holds. Qed.
Lemma left_holds : rel_all (A := binary64) (B := guarded) holds L Lg.
Proof. apply to_left_related; [exact holds_sub|exact given_all|now apply given_holds]. Qed.
Lemma right_holds : rel_all (A := binary64) (B := guarded) holds Rt Rg.
Proof. apply to_right_related; [exact holds_sub|exact given_all|now apply given_holds]. Qed.
Lemma entry_holds : forall j r, holds (entry (A := binary64) L Rt j r) (entry (A := guarded) Lg Rg j r).
Proof.
  apply (entry_related (A := binary64) (B := guarded) holds);
    auto using holds_zero, holds_one, holds_add, holds_sub, holds_mul, holds_div, left_holds, right_holds.
Qed.
Lemma entry_value : forall j r, fst (entry (A := guarded) Lg Rg j r) = entry (A := rounded rnd) (to_left (A := rounded rnd) T s X) (to_right (A :=
  rounded rnd) T s X) j r.
Proof.
  apply (entry_related (A := guarded) (B := rounded rnd) value); try reflexivity;
    try (intros; apply value_op; assumption); intros j; reflexivity.
Qed.

(* What must not go wrong: the differences and, unless the special case makes them superfluous, the values. *)
Definition row_safe : Prop :=
  (1 <= p)%nat -> (snd (Lg p) /\ snd (Rg p)) /\
  ((p < only_of (A := rounded rnd) T p s X)%nat -> forall r, (r <= p)%nat -> snd (entry (A := guarded) Lg Rg p r)).

Lemma only_agrees : row_safe -> only_of (A := binary64) t p s x = only_of (A := rounded rnd) T p s X.
Proof.
  intros H. unfold only_of. destruct (Nat.eqb_spec p 0); [reflexivity|]. destruct (H ltac:(lia)) as [[HL HR] _].
  destruct (left_holds p HL) as [Fl El], (right_holds p HR) as [Fr Er].
  assert (E : forall b : float64, is_finite b = true -> same (a := binary64) b (zero (a := binary64)) = same_R (B2R b) 0).
  { intros b Fb. refine (eq_trans (Beqb_correct prec emax b (B754_zero false) Fb eq_refl) _). unfold same_R.
    change (B2R (B754_zero false)) with 0. destruct (Req_EM_T (B2R b) 0); case Req_bool_spec; intros; auto; contradiction. }
  rewrite !E, El, Er by auto. reflexivity.
Qed.

(* et_basis_eval on binary64: each value is finite and the real scheme's. *)
Theorem basis_at_value : row_safe -> forall r, (r <= p)%nat ->
  let b := nth r (basis_at (A := binary64) t p s x) (B754_zero false) in
  is_finite b = true /\ B2R b = nth r (basis_at (A := rounded rnd) T p s X) 0.
Proof.
  intros H r Hr. unfold basis_at. rewrite (only_agrees H). set (only := only_of (A := rounded rnd) T p s X) in *.
  destruct (Nat.leb_spec only p) as [h|h].
  - rewrite (unit_row_nth (A := binary64)), (unit_row_nth (A := rounded rnd)) by auto. destruct (r =? only)%nat; [|now cbn].
    split; [reflexivity|exact (Bone_correct prec emax _ _)].
  - rewrite (outer_is_entry (A := binary64) L Rt _ p r Hr). rewrite (outer_is_entry (A := rounded rnd) _ _ 0 p r Hr).
    rewrite <- entry_value. apply entry_holds. destruct (Nat.eq_dec p 0) as [e|e].
    + exfalso. revert h. unfold only, only_of. rewrite e. cbn. lia.
    + destruct (H ltac:(lia)) as [_ H2]. now apply H2.
Qed.

Hypothesis sorted : forall i, T i <= T (S i).
Hypothesis degree : (p <= s)%nat.
Hypothesis span : T s < T (S s).
Hypothesis inside : T s <= X <= T (S s).

Theorem basis64_within : row_safe -> forall r, (r <= p)%nat ->
  within u64 (6 * p - 1) (B2R (nth r (basis_at (A := binary64) t p s x) (B754_zero false))) (cox T s X p (s - p + r)).
Proof.
  intros H r Hr. destruct (basis_at_value H r Hr) as [_ ->]. apply basis_at_within; auto using u64_range, rnd_error, rnd_idem.
Qed.
Theorem basis64_sum : row_safe -> within u64 (4 * p - 1) (total (fun r => B2R (nth r (basis_at (A := binary64) t p s x) (B754_zero false))) (S p)) 1.
Proof.
  intros H. rewrite (total_ext _ _ (fun r => nth r (basis_at (A := rounded rnd) T p s X) 0)) by (intros; apply basis_at_value; auto; lia).
  apply basis_at_sum; auto using u64_range, rnd_error, rnd_idem.
Qed.
End Basis.

(* ---- when nothing goes wrong: a condition on the knots ---- *)

(* 0, or between two powers of two. *)
Definition band (a b : Z) (y : R) : Prop := y = 0 \/ bpow radix2 a <= y <= bpow radix2 b.

Lemma bpow_format : forall e, generic_format radix2 (FLX_exp 53) (bpow radix2 e).
Proof. intros e. apply generic_format_bpow. unfold FLX_exp. lia. Qed.
Lemma rnd_between : forall a b y, bpow radix2 a <= y <= bpow radix2 b -> bpow radix2 a <= rnd y <= bpow radix2 b.
Proof.
  intros a b y [h1 h2]. split.
  - apply round_ge_generic; [apply FLX_exp_valid; reflexivity|apply valid_rnd_N|apply bpow_format|auto].
  - apply round_le_generic; [apply FLX_exp_valid; reflexivity|apply valid_rnd_N|apply bpow_format|auto].
Qed.
Lemma band_rnd : forall a b y, band a b y -> band a b (rnd y).
Proof. intros a b y [->|H]; [left; now apply rnd_zero with u64; [apply rnd_error|..]|right; now apply rnd_between]. Qed.
Lemma band_weaken : forall a b a' b' y, (a' <= a)%Z -> (b <= b')%Z -> band a b y -> band a' b' y.
Proof.
  intros a b a' b' y Ha Hb [->|[h1 h2]]; [now left|right]. split; [apply Rle_trans with (2 := h1)|apply Rle_trans with (1 := h2)]; now apply bpow_le.
Qed.
Lemma band_mul : forall a b c d y z, band a b y -> band c d z -> band (a + c) (b + d) (y * z).
Proof.
  intros a b c d y z [->|[h1 h2]] [->|[g1 g2]]; try (left; ring). right. rewrite !bpow_plus.
  pose proof (bpow_gt_0 radix2 a). pose proof (bpow_gt_0 radix2 c). split; apply Rmult_le_compat; lra.
Qed.
Lemma band_div : forall a b c d y z, band a b y -> bpow radix2 c <= z <= bpow radix2 d -> band (a - d) (b - c) (y / z).
Proof.
  intros a b c d y z Hy [g1 g2]. pose proof (bpow_gt_0 radix2 c). unfold Rdiv, Z.sub. apply band_mul; auto. right. rewrite !bpow_opp.
  split; apply Rinv_le_contravar; lra.
Qed.
Lemma band_add : forall a b y z, band a b y -> band a b z -> band a (b + 1) (y + z).
Proof.
  intros a b y z Hy Hz. assert (E : bpow radix2 (b + 1) = 2 * bpow radix2 b) by (rewrite bpow_plus; simpl; lra).
  pose proof (bpow_gt_0 radix2 a). pose proof (bpow_gt_0 radix2 b).
  destruct Hy as [->|[h1 h2]], Hz as [->|[g1 g2]]; [left; ring|right; rewrite E; lra|right; rewrite E; lra|right; rewrite E; lra].
Qed.
Lemma band_zero : forall a b y z, band a b y -> band a b z -> y + z = 0 -> y = 0 /\ z = 0.
Proof. intros a b y z Hy Hz E. pose proof (bpow_gt_0 radix2 a). destruct Hy as [?|[? ?]], Hz as [?|[? ?]]; lra. Qed.
Lemma band_safe : forall a b y, band a b y -> (-1022 <= a)%Z -> (b <= 1023)%Z -> no_overflow y /\ no_underflow y.
Proof.
  intros a b y H Ha Hb. pose proof (bpow_gt_0 radix2 a). split.
  - unfold no_overflow. destruct (band_rnd _ _ _ H) as [->|[h1 h2]].
    + rewrite Rabs_R0. apply bpow_gt_0.
    + rewrite Rabs_pos_eq by lra. apply Rle_lt_trans with (1 := h2). apply bpow_lt. lia.
  - destruct H as [->|[h1 h2]]; [now left|right]. rewrite Rabs_pos_eq by lra. apply Rle_trans with (2 := h1). now apply bpow_le.
Qed.

Section Enough.
Variables (t : nat -> float64) (p s : nat) (x : float64) (e : Z).
Notation T := (fun i => B2R (t i)).
Notation X := (B2R x).
Notation Lg := (to_left (A := guarded) (fun i => given (t i)) s (given x)).
Notation Rg := (to_right (A := guarded) (fun i => given (t i)) s (given x)).
Hypothesis sorted : forall i, T i <= T (S i).
Hypothesis span : T s < T (S s).
Hypothesis exponent : (0 <= e /\ (2 * e + 1) * Z.of_nat p <= 1022 /\ e <= 1022)%Z.
(* The exact differences of x and the knots are 0 or from 2^-e to 2^e. *)
Hypothesis lefts : forall j, (1 <= j <= p)%nat -> band (- e) e (X - T (s + 1 - j)%nat).
Hypothesis rights : forall j, (1 <= j <= p)%nat -> band (- e) e (T (s + j)%nat - X).
Notation w := (2 * e + 1)%Z.

Lemma left_safe : forall j, (1 <= j <= p)%nat -> snd (Lg j) /\ band (- e) e (fst (Lg j)).
Proof.
  intros j Hj. destruct (band_safe _ _ _ (lefts j Hj) ltac:(lia) ltac:(lia)) as [h1 h2].
  split; [exact (conj I (conj I h1))|exact (band_rnd _ _ _ (lefts j Hj))].
Qed.
Lemma right_safe : forall j, (1 <= j <= p)%nat -> snd (Rg j) /\ band (- e) e (fst (Rg j)).
Proof.
  intros j Hj. destruct (band_safe _ _ _ (rights j Hj) ltac:(lia) ltac:(lia)) as [h1 h2].
  split; [exact (conj I (conj I h1))|exact (band_rnd _ _ _ (rights j Hj))].
Qed.
Lemma sum_between : forall j r, (j <= p)%nat -> (r < j)%nat ->
  bpow radix2 (- e) <= fst (Rg (r + 1)%nat) + fst (Lg (j - r)%nat) <= bpow radix2 (e + 1).
Proof.
  intros j r Hj Hr. destruct (left_safe (j - r) ltac:(lia)) as [_ HL], (right_safe (r + 1) ltac:(lia)) as [_ HR].
  destruct (band_add _ _ _ _ HR HL) as [z|z]; auto. exfalso. pose proof (bpow_gt_0 radix2 (- e)).
  destruct (band_zero _ _ _ _ HR HL z) as [ZR ZL].
  apply (rnd_eq_zero u64 u64_range rnd rnd_error (X - T (s + 1 - (j - r))%nat)) in ZL.
  apply (rnd_eq_zero u64 u64_range rnd rnd_error (T (s + (r + 1))%nat - X)) in ZR.
  assert (T (s + 1 - (j - r))%nat <= T s) by (apply (knots_le T sorted); lia).
  assert (T (S s) <= T (s + (r + 1))%nat) by (apply (knots_le T sorted); lia). lra.
Qed.

Lemma entry_safe : forall j r, (j <= p)%nat -> (r <= j)%nat ->
  snd (entry (A := guarded) Lg Rg j r) /\ band (- (w * Z.of_nat j)) (w * Z.of_nat j) (fst (entry (A := guarded) Lg Rg j r)).
Proof.
  induction j as [|j IH]; intros r Hj Hr.
  - split; [exact I|]. right. replace (w * Z.of_nat 0)%Z with 0%Z by lia. simpl; lra.
  - set (m := (w * Z.of_nat j)%Z) in *. assert (Em : (w * Z.of_nat (S j) = m + w)%Z) by (unfold m; lia). rewrite Em.
    assert (Hm : (0 <= m)%Z) by (unfold m; nia). assert (Hmw : (m + w <= 1022)%Z) by (rewrite <- Em; nia).
    set (f := entry (A := guarded) Lg Rg j) in *.
    assert (HT : forall q, (q <= j)%nat -> snd (temp (A := guarded) Lg Rg f (S j) q) /\
      band (- m - (e + 1)) (m + e) (fst (temp (A := guarded) Lg Rg f (S j) q))).
    { intros q Hq. destruct (IH q ltac:(lia) Hq) as [S1 B1]. pose proof (sum_between (S j) q Hj ltac:(lia)) as Bs.
      destruct (left_safe (S j - q) ltac:(lia)) as [SL _], (right_safe (q + 1) ltac:(lia)) as [SR _].
      pose proof (band_safe _ _ _ (or_intror Bs) ltac:(lia) ltac:(lia)) as [O _].
      pose proof (rnd_between _ _ _ Bs) as Bd. pose proof (band_div _ _ _ _ _ _ B1 Bd) as Bq. replace (m - - e)%Z with (m + e)%Z in Bq by lia.
      pose proof (band_safe _ _ _ Bq ltac:(lia) ltac:(lia)) as [O1 O2]. pose proof (bpow_gt_0 radix2 (- e)).
      split; [|exact (band_rnd _ _ _ Bq)].
      refine (conj S1 (conj (conj SR (conj SL O)) (conj _ (conj O1 O2)))).
      change (rnd (fst (Rg (q + 1)%nat) + fst (Lg (S j - q)%nat)) <> 0). lra. }
    assert (HP : forall (g : guarded) q, (q <= j)%nat -> snd g -> band (- e) e (fst g) ->
      snd (mul (a := guarded) g (temp (A := guarded) Lg Rg f (S j) q)) /\
      band (- (m + w)) (m + 2 * e) (fst (mul (a := guarded) g (temp (A := guarded) Lg Rg f (S j) q)))).
    { intros g q Hq Sg Bg. destruct (HT q Hq) as [ST BT]. pose proof (band_mul _ _ _ _ _ _ Bg BT) as Bp.
      apply (band_weaken _ _ (- (m + w)) (m + 2 * e)) in Bp; [|lia|lia].
      pose proof (band_safe _ _ _ Bp ltac:(lia) ltac:(lia)) as [O1 O2].
      split; [exact (conj Sg (conj ST (conj O1 O2)))|exact (band_rnd _ _ _ Bp)]. }
    assert (HS : snd (saved (A := guarded) Lg Rg f (S j) r) /\ band (- (m + w)) (m + 2 * e) (fst (saved (A := guarded) Lg Rg f (S j) r))).
    { destruct r as [|q]; [split; [exact I|now left]|]. apply HP; try lia; apply left_safe; lia. }
    cbn [entry]. fold f. unfold next. destruct (Nat.eqb_spec r (S j)) as [c|c].
    + split; [apply HS|]. apply band_weaken with (3 := proj2 HS); lia.
    + destruct (HP (Rg (r + 1)%nat) r ltac:(lia)) as [SP BP]; [apply right_safe; lia|apply right_safe; lia|].
      pose proof (band_add _ _ _ _ (proj2 HS) BP) as Ba. replace (m + 2 * e + 1)%Z with (m + w)%Z in Ba by lia.
      pose proof (band_safe _ _ _ Ba ltac:(lia) ltac:(lia)) as [O _].
      split; [exact (conj (proj1 HS) (conj SP O))|exact (band_rnd _ _ _ Ba)].
Qed.

(* With (2e + 1) p <= 1022, so e = 169 for cubics and 56 for degree 9. *)
Theorem guard_enough : row_safe t p s x.
Proof. intros Hp. split; [split; [apply left_safe|apply right_safe]; lia|]. intros _ r Hr. now apply entry_safe. Qed.
End Enough.

(* ---- points, insertion and derivatives: the same way, from the numbers they are given ---- *)

Definition all_finite (f : nat -> float64) : Prop := forall i, is_finite (f i) = true.
Definition reals (f : nat -> float64) (i : nat) : R := B2R (f i).
Definition givens (f : nat -> float64) (i : nat) : guarded := given (f i).

Lemma givens_hold : forall f, all_finite f -> rel_all (A := binary64) (B := guarded) holds f (givens f).
Proof. intros f Hf i. apply given_holds, Hf. Qed.
Lemma givens_value : forall f, rel_all (A := guarded) (B := rounded rnd) value (givens f) (reals f).
Proof. intros f i. reflexivity. Qed.
Lemma holds_value : forall (b : binary64) (g : guarded) (y : R), holds b g -> value g y -> snd g -> is_finite b = true /\ B2R b = y.
Proof. intros b g y Hb Hy Hg. destruct (Hb Hg) as [h1 h2]. split; auto. now rewrite h2. Qed.
Ltac transfer b y Hs :=
  match type of Hs with snd ?g =>
    let V := fresh in let W := fresh in let F := fresh in
    assert (V : holds b g); [|assert (W : value g y); [|destruct (holds_value b g y V W Hs) as [F ->]]] end.
Lemma reals_format : forall f i, rnd (reals f i) = reals f i.
Proof. intros. apply format_rnd, format. Qed.

Lemma value_add : forall a a' b b', value a a' -> value b b' -> value (add a b) (add a' b').
Proof. intros. now apply value_op. Qed.
Lemma value_sub : forall a a' b b', value a a' -> value b b' -> value (sub a b) (sub a' b').
Proof. intros. now apply value_op. Qed.
Lemma value_mul : forall a a' b b', value a a' -> value b b' -> value (mul a b) (mul a' b').
Proof. intros. now apply value_op. Qed.
Lemma value_div : forall a a' b b', value a a' -> value b b' -> value (div a b) (div a' b').
Proof. intros. now apply value_op. Qed.

Section Points.
Variables (p q : nat) (N M : nat -> float64) (Ne Me : nat -> R).
Hypothesis degree_p : (1 <= p)%nat.
Hypothesis degree_q : (1 <= q)%nat.
Hypothesis N_finite : all_finite N.
Hypothesis M_finite : all_finite M.
Hypothesis row_N : row u64 p (reals N) Ne.
Hypothesis row_M : row u64 q (reals M) Me.

Theorem curve_point64_near : forall c, all_finite c -> snd (curve_point (A := guarded) (givens N) (givens c) p) ->
  let b := curve_point (A := binary64) N c p in
  is_finite b = true /\ near u64 (7 * p) (B2R b) (curve_point (A := exact) Ne (reals c) p) (contract (A := exact) Ne (fun r => Rabs (reals c r)) p).
Proof.
  clear degree_q row_M M_finite M Me q. intros c Hc Hs b. transfer b (curve_point (A := rounded rnd) (reals N) (reals c) p) Hs.
  - apply (contract_related (A := binary64) (B := guarded) holds); auto using holds_add, holds_mul, givens_hold. intros i. apply holds_mul;
    [apply holds_one|now apply givens_hold].
  - apply (contract_related (A := guarded) (B := rounded rnd) value); auto using value_add, value_mul, givens_value. intros i. apply value_mul;
    [reflexivity|apply givens_value].
  - split; auto. apply curve_point_near; auto using u64_range, rnd_error, reals_format.
Qed.

Theorem curve_point_rational64_near : forall w c, all_finite w -> all_finite c -> (forall i, (i <= p)%nat -> 0 < reals w i) ->
  snd (curve_point_rational (A := guarded) (givens N) (givens w) (givens c) p) ->
  let b := curve_point_rational (A := binary64) N w c p in
  is_finite b = true /\ near u64 (14 * p + 2) (B2R b) (curve_point_rational (A := exact) Ne (reals w) (reals c) p)
    (contract (A := exact) Ne (fun r => reals w r * Rabs (reals c r)) p / contract (A := exact) Ne (reals w) p).
Proof.
  clear degree_q row_M M_finite M Me q. intros w c Hw Hc Pw Hs b. transfer b (curve_point_rational (A :=
    rounded rnd) (reals N) (reals w) (reals c) p) Hs.
  - apply holds_div; apply (contract_related (A := binary64) (B := guarded) holds); auto using holds_add, holds_mul, givens_hold. intros i.
    apply holds_mul; now apply givens_hold.
  - apply value_div; apply (contract_related (A := guarded) (B := rounded rnd) value); auto using value_add, value_mul, givens_value. intros i.
    apply value_mul; apply givens_value.
  - split; auto. apply curve_point_rational_near; auto using u64_range, rnd_error.
Qed.

Theorem surface_point64_near : forall c : nat -> nat -> float64, (forall i, all_finite (c i)) ->
  snd (surface_point (A := guarded) (givens N) (givens M) (fun i => givens (c i)) p q) ->
  let b := surface_point (A := binary64) N M c p q in
  is_finite b = true /\ near u64 (7 * (p + q)) (B2R b) (surface_point (A := exact) Ne Me (fun i => reals (c i)) p q)
    (contract_uv (A := exact) Ne Me (fun i j => Rabs (reals (c i) j)) p q).
Proof.
  intros c Hc Hs b. transfer b (surface_point (A := rounded rnd) (reals N) (reals M) (fun i => reals (c i)) p q) Hs.
  - apply (contract_related (A := binary64) (B := guarded) holds); auto using holds_add, holds_mul, givens_hold. intros j.
    apply (contract_related (A := binary64) (B := guarded) holds); auto using holds_add, holds_mul, givens_hold.
    intros i. apply holds_mul; [apply holds_one|now apply givens_hold].
  - apply (contract_related (A := guarded) (B := rounded rnd) value); auto using value_add, value_mul, givens_value. intros j.
    apply (contract_related (A := guarded) (B := rounded rnd) value); auto using value_add, value_mul, givens_value.
    intros i. apply value_mul; [reflexivity|apply givens_value].
  - split; auto. apply surface_point_near; auto using u64_range, rnd_error. intros; apply reals_format.
Qed.

Theorem surface_point_rational64_near : forall w c : nat -> nat -> float64, (forall i, all_finite (w i)) -> (forall i, all_finite (c i)) ->
  (forall i j, (i <= p)%nat -> (j <= q)%nat -> 0 < reals (w i) j) ->
  snd (surface_point_rational (A := guarded) (givens N) (givens M) (fun i => givens (w i)) (fun i => givens (c i)) p q) ->
  let b := surface_point_rational (A := binary64) N M w c p q in
  is_finite b = true /\
  near u64 (14 * (p + q) + 2) (B2R b) (surface_point_rational (A := exact) Ne Me (fun i => reals (w i)) (fun i => reals (c i)) p q)
    (contract_uv (A := exact) Ne Me (fun i j => reals (w i) j * Rabs (reals (c i) j)) p q / contract_uv (A :=
      exact) Ne Me (fun i => reals (w i)) p q).
Proof.
  intros w c Hw Hc Pw Hs b.
  transfer b (surface_point_rational (A := rounded rnd) (reals N) (reals M) (fun i => reals (w i)) (fun i => reals (c i)) p q) Hs.
  - apply holds_div; apply (contract_related (A := binary64) (B := guarded) holds); auto using holds_add, holds_mul, givens_hold; intros j;
      apply (contract_related (A := binary64) (B := guarded) holds); auto using holds_add, holds_mul, givens_hold; intros i; [apply holds_mul|];
        now apply givens_hold.
  - apply value_div; apply (contract_related (A := guarded) (B := rounded rnd) value); auto using value_add, value_mul, givens_value; intros j;
      apply (contract_related (A := guarded) (B := rounded rnd) value); auto using value_add, value_mul, givens_value; intros i;
        [apply value_mul|]; apply givens_value.
  - split; auto. apply (surface_point_rational_near u64 u64_range rnd rnd_error p q (reals N) Ne (reals M) Me); auto.
Qed.
End Points.

(* Knot insertion of a polynomial curve's coordinate. *)
Theorem inserted64_near : forall t c x p k s times, all_finite t -> all_finite c -> is_finite x = true -> (s <= k)%nat ->
  spanned (B2R x) (reals t) k ->
  forall i, snd (inserted (A := guarded) (givens t) p k s (given x) (givens c) times i) ->
  let b := inserted (A := binary64) t p k s x c times i in
  is_finite b = true /\
  near u64 (5 * Nat.min times p) (B2R b) (inserted (A := exact) (reals t) p k s (B2R x) (reals c) times i)
    (inserted (A := exact) (reals t) p k s (B2R x) (fun i => Rabs (reals c i)) times i).
Proof.
  intros t c x p k s times Ht Hc Hx Hk Hspan i Hs b.
  transfer b (inserted (A := rounded rnd) (reals t) p k s (B2R x) (reals c) times i) Hs.
  - apply (inserted_related (A := binary64) (B := guarded) holds); auto using holds_add, holds_sub, holds_mul, holds_div, givens_hold, given_holds.
  - apply (inserted_related (A := guarded) (B := rounded rnd) value); auto using value_add, value_sub, value_mul, value_div, givens_value.
    reflexivity.
  - split; auto. apply inserted_polynomial; auto using u64_range, rnd_error.
Qed.

(* Derivatives; f is the conversion (double) of the numbers 1 .. p. *)
Theorem derivative64_near : forall t x f p s r k, all_finite t -> is_finite x = true -> all_finite f ->
  (forall m, (1 <= m <= p)%nat -> reals f m = INR m) -> (forall i, reals t i <= reals t (S i)) -> reals t s < reals t (S s) ->
  reals t s <= B2R x <= reals t (S s) -> (1 <= k <= p)%nat ->
  snd (derivative (A := guarded) (to_left (A := guarded) (givens t) s (given x)) (to_right (A := guarded) (givens t) s (given x)) (givens f) p r k) ->
  let b := derivative (A := binary64) (to_left (A := binary64) t s x) (to_right (A := binary64) t s x) f p r k in
  let Le := to_left (A := exact) (reals t) s (B2R x) in let Re := to_right (A := exact) (reals t) s (B2R x) in
  is_finite b = true /\
  near u64 (6 * p + 2) (B2R b) (derivative (A := exact) Le Re INR p r k)
    (factor (A := exact) INR p k * magnitude_sum (reals t) s (B2R x) p r k (k + 1)).
Proof.
  intros t x f p s r k Ht Hx Hf HI Hs Hspan Hin Hk Hsafe b Le Re.
  transfer b (derivative (A := rounded rnd) (to_left (A := rounded rnd) (reals t) s (B2R x)) (to_right (A :=
    rounded rnd) (reals t) s (B2R x)) (reals f) p r k) Hsafe.
  - apply derivative_related; auto using holds_zero, holds_one, holds_add, holds_sub, holds_mul, holds_div, givens_hold.
    + apply to_left_related; auto using holds_sub, givens_hold, given_holds.
    + apply to_right_related; auto using holds_sub, givens_hold, given_holds.
  - apply (derivative_related (A := guarded) (B := rounded rnd) value); auto using value_add, value_sub, value_mul, value_div, givens_value;
    try reflexivity;
      intros i; reflexivity.
  - split; auto. unfold derivative at 1. assert (F : forall l, (l <= p)%nat -> factor (A := rounded rnd) (reals f) p l = factor (A :=
    rounded rnd) INR p l).
    { induction l as [|l IH]; intros Hl; [reflexivity|]. cbn [factor]. rewrite IH, HI by lia. reflexivity. }
    rewrite F by lia. apply derivative_near; auto using u64_range, rnd_error, rnd_idem.
Qed.
