(* Rounding errors of the loops of RoundingScheme.v, for any degree: what docs/accuracy.md and the comments in src/spline state.
   (Those lines are quoted above the theorems; proofs/coq/quote.sh checks that they still stand there.)
   The model: |rnd y - y| <= u |y| and rnd idempotent, so nothing underflows or overflows; Binary64.v says when that is so.
   Two relations carry all proofs, with c = 1 - u:
     within k a b     a, b >= 0 and c^k b <= a <= b / c^k: k roundings apart;
     near k a b m     |a - b| <= (c^-k - 1) m and |b| <= m: k roundings apart relative to the magnitude m. *)
Require Import Reals Lra Lia Arith Psatz Bool List.
From Etalon Require Import RoundingScheme.
Open Scope R_scope.

(* ---- arithmetics of real numbers ---- *)

Definition less_R (x y : R) : bool := if Rlt_dec x y then true else false.
Definition same_R (x y : R) : bool := if Req_EM_T x y then true else false.
Definition rounded (rnd : R -> R) : arithmetic :=
  Arithmetic R 0 1 (fun x y => rnd (x + y)) (fun x y => rnd (x - y)) (fun x y => rnd (x * y)) (fun x y => rnd (x / y)) less_R same_R.
Definition plain (y : R) : R := y.
Definition exact : arithmetic := rounded plain.

Fixpoint total (f : nat -> R) (n : nat) : R := match n with O => 0 | S k => total f k + f k end.

Lemma total_ext : forall n f g, (forall k, (k < n)%nat -> f k = g k) -> total f n = total g n.
Proof. induction n; simpl; intros; auto. rewrite (IHn f g), H; auto. Qed.
Lemma total_add : forall n f g, total (fun k => f k + g k) n = total f n + total g n.
Proof. induction n; simpl; intros; [lra|rewrite IHn; lra]. Qed.
Lemma total_shift : forall n f, total f (S n) = f O + total (fun k => f (S k)) n.
Proof. induction n; intros; [simpl; lra|]. change (total f (S (S n))) with (total f (S n) + f (S n)). rewrite IHn; simpl; lra. Qed.

(* ---- Cox-de Boor with 0/0 = 0, from the span s on: it does for the right end, too, where the last span is closed ---- *)

Definition quotient (n d : R) : R := if Req_EM_T d 0 then 0 else n / d.
Lemma quotient_is_div : forall n d, d <> 0 -> quotient n d = n / d.
Proof. intros; unfold quotient; destruct (Req_EM_T d 0); auto; contradiction. Qed.

Section Basis.
Variable t : nat -> R.
Hypothesis sorted : forall i, t i <= t (S i).
Variables (s : nat) (x : R).

Lemma knots_le : forall i j, (i <= j)%nat -> t i <= t j.
Proof. intros i j H; induction H; [lra|]. specialize (sorted m); lra. Qed.

Fixpoint cox (p i : nat) : R :=
  match p with
  | O => if (i =? s)%nat then 1 else 0
  | S q => quotient (x - t i) (t (i + p)%nat - t i) * cox q i
         + quotient (t (S i + p)%nat - x) (t (S i + p)%nat - t (S i)) * cox q (S i)
  end.

Lemma cox_support : forall p i, (i + p < s \/ s < i)%nat -> cox p i = 0.
Proof.
  induction p; intros i H; cbn [cox].
  - destruct (Nat.eqb_spec i s); auto; lia.
  - rewrite !IHp by lia. ring.
Qed.

Hypothesis span : t s < t (S s).
Notation L := (to_left (A := exact) t s x).
Notation Rt := (to_right (A := exact) t s x).

Lemma left_is : forall j, L j = x - t (s + 1 - j)%nat.
Proof. reflexivity. Qed.
Lemma right_is : forall j, Rt j = t (s + j)%nat - x.
Proof. reflexivity. Qed.
Lemma width_pos : forall j r, (r < j)%nat -> 0 < Rt (r + 1)%nat + L (j - r)%nat.
Proof.
  intros j r H. rewrite left_is, right_is.
  assert (t (s + 1 - (j - r))%nat <= t s) by (apply knots_le; lia).
  assert (t (S s) <= t (s + (r + 1))%nat) by (apply knots_le; lia). lra.
Qed.

(* Over the reals the loop computes Cox and de Boor's functions. *)
Theorem scheme_is_cox : forall j r, (j <= s)%nat -> (r <= j)%nat -> entry (A := exact) L Rt j r = cox j (s - j + r).
Proof.
  induction j as [|j IH]; intros r Hj Hr.
  - replace r with O by lia. cbn. replace (s - 0 + 0)%nat with s by lia. now rewrite Nat.eqb_refl.
  - cbn [entry cox]. unfold next, saved, temp. cbn -[Nat.add Nat.sub to_left to_right cox entry Nat.eqb]. unfold plain.
    set (i := (s - S j + r)%nat).
    assert (W : forall q, (q <= j)%nat -> 0 < t (s + (q + 1))%nat - t (s + 1 - (S j - q))%nat).
    { intros q Hq. assert (t (s + 1 - (S j - q))%nat <= t s) by (apply knots_le; lia).
      assert (t (S s) <= t (s + (q + 1))%nat) by (apply knots_le; lia). lra. }
    assert (HR : forall q, (q <= j)%nat -> Rt (q + 1)%nat + L (S j - q)%nat = t (s + (q + 1))%nat - t (s + 1 - (S j - q))%nat)
      by (intros; rewrite left_is, right_is; ring).
    assert (before : (1 <= r)%nat -> L (S j - (r - 1))%nat = x - t i).
    { intros. rewrite left_is. now replace (s + 1 - (S j - (r - 1)))%nat with i by (unfold i; lia). }
    assert (behind : (r <= j)%nat -> Rt (r + 1)%nat = t (S i + S j)%nat - x).
    { intros. rewrite right_is. now replace (s + (r + 1))%nat with (S (i + S j)) by (unfold i; lia). }
    destruct r as [|q].
    + cbn [Nat.eqb]. rewrite HR, behind by lia. rewrite (cox_support j i) by (unfold i; lia). rewrite IH by lia.
      specialize (W O ltac:(lia)). revert W.
      replace (s + 1 - (S j - 0))%nat with (S i) by (unfold i; lia). replace (s + (0 + 1))%nat with (S i + S j)%nat by (unfold i; lia).
      replace (s - j + 0)%nat with (S i) by (unfold i; lia). intro W.
      rewrite (quotient_is_div (t (S i + S j)%nat - x)) by (cbn in W |- *; lra). cbn. field. cbn in W; lra.
    + destruct (Nat.eqb_spec (S q) (S j)) as [e|e].
      * assert (q = j) by lia; subst q. rewrite HR by lia. rewrite (cox_support j (S i)) by (unfold i; lia). rewrite IH by lia.
        specialize (W j ltac:(lia)). revert W before.
        replace (S j - 1)%nat with j by lia. replace (s + 1 - (S j - j))%nat with i by (unfold i; lia).
        replace (s + (j + 1))%nat with (i + S j)%nat by (unfold i; lia). replace (s - j + j)%nat with i by (unfold i; lia). intros W before.
        rewrite before by lia. rewrite quotient_is_div by lra. field. lra.
      * rewrite !HR, behind by lia. rewrite !IH by lia.
        pose proof (W q ltac:(lia)) as W1. pose proof (W (S q) ltac:(lia)) as W2. revert W1 W2 before.
        replace (S q - 1)%nat with q by lia. replace (s + 1 - (S j - q))%nat with i by (unfold i; lia).
        replace (s + (q + 1))%nat with (i + S j)%nat by (unfold i; lia). replace (s + 1 - (S j - S q))%nat with (S i) by (unfold i; lia).
        replace (s + (S q + 1))%nat with (S i + S j)%nat by (unfold i; lia).
        replace (s - j + q)%nat with i by (unfold i; lia). replace (s - j + S q)%nat with (S i) by (unfold i; lia).
        intros W1 W2 before. rewrite before by lia. rewrite !quotient_is_div by lra. field. split; lra.
Qed.
End Basis.

(* ---- the two relations ---- *)

Section Error.
Variable u : R.
Hypothesis unit_roundoff : 0 <= u < 1.
Notation c := (1 - u).

Lemma power_pos : forall k, 0 < c ^ k <= 1.
Proof. induction k; simpl; [lra|]. nra. Qed.

Definition within (k : nat) (a b : R) : Prop := 0 <= a /\ 0 <= b /\ c ^ k * b <= a /\ c ^ k * a <= b.

Lemma within_refl : forall k a, 0 <= a -> within k a a.
Proof. intros k a H. pose proof (power_pos k). repeat split; auto; nra. Qed.
Lemma within_weaken : forall k l a b, (k <= l)%nat -> within k a b -> within l a b.
Proof.
  intros k l a b H (h1 & h2 & h3 & h4). replace l with (k + (l - k))%nat by lia.
  unfold within; rewrite pow_add. pose proof (power_pos k). pose proof (power_pos (l - k)).
  assert (c ^ k * c ^ (l - k) <= c ^ k) by nra. repeat split; auto; nra.
Qed.
Lemma within_trans : forall k l a b d, within k a b -> within l b d -> within (k + l) a d.
Proof.
  intros k l a b d (h1 & h2 & h3 & h4) (g1 & g2 & g3 & g4). unfold within; rewrite pow_add.
  pose proof (power_pos k). pose proof (power_pos l). repeat split; auto; nra.
Qed.
Lemma within_add : forall k a b d e, within k a b -> within k d e -> within k (a + d) (b + e).
Proof. intros k a b d e (h1 & h2 & h3 & h4) (g1 & g2 & g3 & g4). pose proof (power_pos k). repeat split; nra. Qed.
Lemma within_mul : forall k l a b d e, within k a b -> within l d e -> within (k + l) (a * d) (b * e).
Proof.
  intros k l a b d e (h1 & h2 & h3 & h4) (g1 & g2 & g3 & g4). unfold within; rewrite pow_add.
  pose proof (power_pos k). pose proof (power_pos l). repeat split; try (apply Rmult_le_pos; auto).
  - replace (c ^ k * c ^ l * (b * e)) with ((c ^ k * b) * (c ^ l * e)) by ring.
    apply Rmult_le_compat; auto; apply Rmult_le_pos; lra.
  - replace (c ^ k * c ^ l * (a * d)) with ((c ^ k * a) * (c ^ l * d)) by ring.
    apply Rmult_le_compat; auto; apply Rmult_le_pos; lra.
Qed.
Lemma within_inv : forall k a b, 0 < a -> 0 < b -> within k a b -> within k (/ a) (/ b).
Proof.
  intros k a b Ha Hb (h1 & h2 & h3 & h4). pose proof (power_pos k).
  pose proof (Rinv_0_lt_compat a Ha). pose proof (Rinv_0_lt_compat b Hb).
  repeat split; try lra; (apply Rmult_le_reg_l with (a * b); [nra|]).
  - replace (a * b * (c ^ k * / b)) with (c ^ k * a) by (field; lra). replace (a * b * / a) with b by (field; lra). lra.
  - replace (a * b * (c ^ k * / a)) with (c ^ k * b) by (field; lra). replace (a * b * / b) with a by (field; lra). lra.
Qed.
Lemma within_div : forall k l a b d e, 0 < d -> 0 < e -> within k a b -> within l d e -> within (k + l) (a / d) (b / e).
Proof. intros; unfold Rdiv; apply within_mul; auto; apply within_inv; auto. Qed.
Lemma within_pos : forall k a b, within k a b -> 0 < b -> 0 < a.
Proof. intros k a b (h1 & h2 & h3 & h4) Hb. pose proof (power_pos k). nra. Qed.
Lemma within_total : forall k n f g, (forall i, (i < n)%nat -> within k (f i) (g i)) -> within k (total f n) (total g n).
Proof. intros k; induction n; intros f g H; simpl; [apply within_refl; lra|]. apply within_add; auto. Qed.

Definition near (k : nat) (a b m : R) : Prop := Rabs (a - b) <= (/ c ^ k - 1) * m /\ Rabs b <= m.

Lemma growth : forall k, 1 <= / c ^ k.
Proof. intros k. pose proof (power_pos k). rewrite <- Rinv_1 at 1. apply Rinv_le_contravar; lra. Qed.
Lemma growth_add : forall k l, / c ^ (k + l) = / c ^ k * / c ^ l.
Proof. intros. pose proof (power_pos k). pose proof (power_pos l). rewrite pow_add. field. lra. Qed.
Lemma near_refl : forall k b, near k b b (Rabs b).
Proof. intros. split; [|lra]. rewrite Rminus_eq_0, Rabs_R0. pose proof (growth k). pose proof (Rabs_pos b). nra. Qed.
Lemma near_magnitude : forall k a b m, near k a b m -> 0 <= m.
Proof. intros k a b m [_ h]. pose proof (Rabs_pos b). lra. Qed.
Lemma near_abs : forall k a b m, near k a b m -> Rabs a <= / c ^ k * m.
Proof. intros k a b m [h1 h2]. pose proof (Rabs_triang (a - b) b). replace (a - b + b) with a in * by ring. nra. Qed.
Lemma near_weaken : forall k l a b m, (k <= l)%nat -> near k a b m -> near l a b m.
Proof.
  intros k l a b m H N. pose proof (near_magnitude _ _ _ _ N). destruct N as [h1 h2]. split; auto.
  replace l with (k + (l - k))%nat by lia. rewrite growth_add. pose proof (growth k). pose proof (growth (l - k)).
  assert (/ c ^ k <= / c ^ k * / c ^ (l - k)) by nra. nra.
Qed.
(* Changes by l roundings and by k are by k + l. *)
Lemma near_trans : forall k l a' a b m, near k a b m -> Rabs (a' - a) <= (/ c ^ l - 1) * Rabs a -> near (k + l) a' b m.
Proof.
  intros k l a' a b m N H. pose proof (near_abs _ _ _ _ N) as Ha. pose proof (near_magnitude _ _ _ _ N). destruct N as [h1 h2]. split; auto.
  pose proof (Rabs_triang (a' - a) (a - b)). replace (a' - a + (a - b)) with (a' - b) in * by ring.
  rewrite growth_add. pose proof (growth k). pose proof (growth l). pose proof (Rabs_pos a).
  assert ((/ c ^ l - 1) * Rabs a <= (/ c ^ l - 1) * (/ c ^ k * m)) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma near_add : forall k a b m a' b' m', near k a b m -> near k a' b' m' -> near k (a + a') (b + b') (m + m').
Proof.
  intros k a b m a' b' m' [h1 h2] [g1 g2]. split.
  - pose proof (Rabs_triang (a - b) (a' - b')). replace (a - b + (a' - b')) with (a + a' - (b + b')) in * by ring. lra.
  - pose proof (Rabs_triang b b'). lra.
Qed.
Lemma near_sub : forall k a b m a' b' m', near k a b m -> near k a' b' m' -> near k (a - a') (b - b') (m + m').
Proof.
  intros k a b m a' b' m' N [g1 g2]. unfold Rminus. apply near_add; auto. split.
  - replace (- a' - - b') with (- (a' - b')) by ring. now rewrite Rabs_Ropp.
  - now rewrite Rabs_Ropp.
Qed.
Lemma within_factor : forall l a b, within l a b -> Rabs (a - b) <= (/ c ^ l - 1) * b.
Proof.
  intros l a b (h1 & h2 & h3 & h4). pose proof (power_pos l) as P. pose proof (growth l).
  assert (E : c ^ l * / c ^ l = 1) by (field; lra).
  apply Rabs_le; split.
  - assert (1 - c ^ l <= / c ^ l - 1) by nra. nra.
  - apply Rmult_le_reg_l with (c ^ l); [lra|]. nra.
Qed.
Lemma within_near : forall l a b, within l a b -> near l a b b.
Proof. intros l a b W. split; [now apply within_factor|]. rewrite Rabs_pos_eq; [lra|apply W]. Qed.
Lemma near_mul : forall k l w w' a b m, within l w' w -> near k a b m -> near (k + l) (w' * a) (w * b) (w * m).
Proof.
  intros k l w w' a b m W [h1 h2]. assert (0 <= w) by apply W. apply near_trans with (a := w * a).
  - split.
    + replace (w * a - w * b) with (w * (a - b)) by ring. rewrite Rabs_mult, (Rabs_pos_eq w) by auto. nra.
    + rewrite Rabs_mult, (Rabs_pos_eq w) by auto. nra.
  - replace (w' * a - w * a) with ((w' - w) * a) by ring. rewrite !Rabs_mult, (Rabs_pos_eq w) by auto.
    pose proof (within_factor _ _ _ W). pose proof (Rabs_pos a). nra.
Qed.
Lemma near_div : forall k l w w' a b m, 0 < w -> within l w' w -> near k a b m -> near (k + l) (a / w') (b / w) (m / w).
Proof.
  intros k l w w' a b m P W N. unfold Rdiv. rewrite !(Rmult_comm _ (/ _)). apply near_mul; auto.
  apply within_inv; auto. now apply (within_pos l w' w).
Qed.

(* ---- a rounding ---- *)

Variable rnd : R -> R.
Hypothesis rnd_error : forall y, Rabs (rnd y - y) <= u * Rabs y.
Hypothesis rnd_idem : forall y, rnd (rnd y) = rnd y.
Notation arith := (rounded rnd).

Lemma no_magnitude : forall y, Rabs y <= 0 -> y = 0.
Proof. intros y. unfold Rabs. destruct (Rcase_abs y); lra. Qed.
Lemma rnd_zero : rnd 0 = 0.
Proof. pose proof (rnd_error 0) as H. rewrite Rabs_R0, Rmult_0_r, Rminus_0_r in H. apply no_magnitude. lra. Qed.
Lemma magnitude_le : forall y b, Rabs y <= b -> - b <= y <= b.
Proof. intros y b. unfold Rabs. destruct (Rcase_abs y); lra. Qed.
Lemma rnd_within : forall y, 0 <= y -> within 1 (rnd y) y.
Proof.
  intros y Hy. pose proof (rnd_error y) as H. rewrite (Rabs_pos_eq y Hy) in H. apply magnitude_le in H.
  unfold within. rewrite pow_1. repeat split; auto; nra.
Qed.
Lemma rnd_nonneg : forall y, 0 <= y -> 0 <= rnd y.
Proof. intros y Hy. now destruct (rnd_within y Hy). Qed.
Lemma within_rnd : forall k a b, within k a b -> within (k + 1) (rnd a) b.
Proof. intros k a b H. rewrite Nat.add_comm. eapply within_trans; [|eauto]. apply rnd_within; apply H. Qed.
Lemma rnd_eq_zero : forall y, rnd y = 0 -> y = 0.
Proof. intros y H. pose proof (rnd_error y) as E. rewrite H in E. replace (0 - y) with (- y) in E by ring. rewrite Rabs_Ropp in E.
  pose proof (Rabs_pos y). apply no_magnitude. nra. Qed.
Lemma near_rnd : forall k a b m, near k a b m -> near (k + 1) (rnd a) b m.
Proof.
  intros k a b m N. apply near_trans with a; auto. pose proof (rnd_error a). pose proof (Rabs_pos a).
  assert (u <= / c ^ 1 - 1).
  { rewrite pow_1. apply Rmult_le_reg_l with c; [lra|]. replace (c * (/ c - 1)) with (1 - c) by (field; lra). nra. }
  nra.
Qed.

(* ---- basis functions ---- *)

Section BasisError.
Variable t : nat -> R.
Hypothesis sorted : forall i, t i <= t (S i).
Variables (s : nat) (x : R).
Hypothesis span : t s < t (S s).
Hypothesis inside : t s <= x <= t (S s).
Notation L := (to_left (A := arith) t s x).
Notation Rt := (to_right (A := arith) t s x).
Notation Le := (to_left (A := exact) t s x).
Notation Re := (to_right (A := exact) t s x).
Notation N := (entry (A := arith) L Rt).
Notation Ne := (entry (A := exact) Le Re).

Lemma left_within : forall j, (1 <= j)%nat -> within 1 (L j) (Le j).
Proof. intros j Hj. apply (rnd_within (x - t (s + 1 - j)%nat)). assert (t (s + 1 - j)%nat <= t s) by (apply knots_le; auto; lia). lra. Qed.
Lemma right_within : forall j, (1 <= j)%nat -> within 1 (Rt j) (Re j).
Proof. intros j Hj. apply (rnd_within (t (s + j)%nat - x)). assert (t (S s) <= t (s + j)%nat) by (apply knots_le; auto; lia). lra. Qed.
Lemma width_within : forall j r, (r < j)%nat -> within 2 (rnd (Rt (r + 1)%nat + L (j - r)%nat)) (Re (r + 1)%nat + Le (j - r)%nat).
Proof. intros j r H. apply (within_rnd 1). apply within_add; [apply right_within|apply left_within]; lia. Qed.
Lemma width_exact_pos : forall j r, (r < j)%nat -> 0 < Re (r + 1)%nat + Le (j - r)%nat.
Proof. intros. now apply width_pos. Qed.
Lemma temp_within : forall n f g j r, (r < j)%nat -> within n (f r) (g r) ->
  within (n + 3) (temp (A := arith) L Rt f j r) (temp (A := exact) Le Re g j r).
Proof.
  intros n f g j r H W. unfold temp. cbn -[Nat.add]. unfold plain. replace (n + 3)%nat with (n + 2 + 1)%nat by lia. apply within_rnd.
  pose proof (width_exact_pos j r H). pose proof (width_within j r H). apply within_div; auto. eapply within_pos; eauto.
Qed.

(* Each step costs a value six roundings, the first five: there nothing is added. *)
Definition steps (j : nat) : nat := match j with O => O | S k => (6 * k + 5)%nat end.

Theorem entry_within : forall j r, (r <= j)%nat -> within (steps j) (N j r) (Ne j r).
Proof.
  induction j as [|j IH]; intros r Hr; [exact (within_refl _ 1 Rle_0_1)|].
  cbn [entry]. set (n := steps j) in *.
  assert (HT : forall q, (q <= j)%nat -> within (n + 3) (temp (A := arith) L Rt (N j) (S j) q) (temp (A := exact) Le Re (Ne j) (S j) q))
    by (intros; apply temp_within; [lia|auto]).
  assert (HS : forall q, (q <= j)%nat -> within (n + 5) (saved (A := arith) L Rt (N j) (S j) (S q)) (saved (A := exact) Le Re (Ne j) (S j) (S q))).
  { intros q Hq. replace (n + 5)%nat with (1 + (n + 3) + 1)%nat by lia.
    refine (within_rnd _ (L (S j - q)%nat * temp (A := arith) L Rt (N j) (S j) q) (Le (S j - q)%nat * temp (A := exact) Le Re (Ne j) (S j) q) _).
    apply within_mul; auto. apply left_within; lia. }
  assert (HR : forall q, (q <= j)%nat -> within (n + 5) (rnd (Rt (q + 1)%nat * temp (A := arith) L Rt (N j) (S j) q))
                                                       (Re (q + 1)%nat * temp (A := exact) Le Re (Ne j) (S j) q)).
  { intros q Hq. replace (n + 5)%nat with (1 + (n + 3) + 1)%nat by lia. apply within_rnd. apply within_mul; auto. apply right_within; lia. }
  unfold next. destruct (Nat.eqb_spec r (S j)) as [e|e].
  - subst r. apply within_weaken with (n + 5)%nat; [unfold n, steps; destruct j; lia|apply HS; lia].
  - destruct r as [|q].
    + change (within (steps (S j)) (rnd (0 + rnd (Rt 1%nat * temp (A := arith) L Rt (N j) (S j) 0))) (0 + Re 1%nat * temp (A :=
      exact) Le Re (Ne j) (S j) 0)).
      rewrite !Rplus_0_l, rnd_idem.
      apply within_weaken with (n + 5)%nat; [unfold n, steps; destruct j; lia|apply (HR O); lia].
    + destruct j as [|i]; [lia|]. apply within_weaken with (n + 5 + 1)%nat; [unfold n, steps; lia|].
      refine (within_rnd (n + 5) (_ + _) (_ + _) _). apply within_add; [apply HS|apply HR]; lia.
Qed.

(* QUOTE docs/accuracy.md
| basis function of degree p | `et_basis_eval` | 6p - 1 roundings | itself |
END
   QUOTE include/etalon/spline/basis.h
 * Barring underflow each value is within the factors (1-u)^(6p-1) and (1-u)^-(6p-1) of the exact one (p >= 1; p = 0 is exact), and the
 * exact sum of the p+1 values within (1-u)^(4p-1) and (1-u)^-(4p-1) of 1 (both machine-checked for A2.2).  Never negative.  Where x is a knot of
END *)
Theorem basis_within : forall p r, (1 <= p <= s)%nat -> (r <= p)%nat -> within (6 * p - 1) (N p r) (cox t s x p (s - p + r)).
Proof.
  intros p r Hp Hr. rewrite <- scheme_is_cox by (auto; lia).
  apply within_weaken with (steps p); [unfold steps; destruct p; lia|]. now apply entry_within.
Qed.
Corollary basis_nonneg : forall p r, (r <= p)%nat -> 0 <= N p r.
Proof. intros. now destruct (entry_within p r). Qed.

(* A step changes the exact sum of the computed values by four roundings, the first by three. *)
Lemma step_sum : forall j, within (match j with O => 3 | _ => 4 end) (total (N (S j)) (S (S j))) (total (N j) (S j)).
Proof.
  intros j. set (T := temp (A := arith) L Rt (N j) (S j)).
  set (a := fun r => rnd (L (S j - r)%nat * T r)). set (b := fun r => rnd (Rt (r + 1)%nat * T r)).
  set (D := fun r => rnd (Rt (r + 1)%nat + L (S j - r)%nat)).
  assert (HD : forall r, (r <= j)%nat -> 0 < D r).
  { intros r Hr. eapply within_pos; [apply width_within; lia|]. apply width_exact_pos; lia. }
  assert (HL : forall r, (r <= j)%nat -> 0 <= L (S j - r)%nat) by (intros; apply left_within; lia).
  assert (HR : forall r, 0 <= Rt (r + 1)%nat) by (intros; apply right_within; lia).
  assert (HQ : forall r, (r <= j)%nat -> 0 <= N j r / D r).
  { intros r Hr. apply Rmult_le_pos; [now apply basis_nonneg|]. apply Rlt_le, Rinv_0_lt_compat; auto. }
  assert (HT : forall r, (r <= j)%nat -> 0 <= T r) by (intros; apply rnd_nonneg, HQ; auto).
  assert (Ha : forall r, (r <= j)%nat -> 0 <= a r) by (intros; apply rnd_nonneg, Rmult_le_pos; auto).
  assert (Hb : forall r, (r <= j)%nat -> 0 <= b r) by (intros; apply rnd_nonneg, Rmult_le_pos; auto).
  (* A product's rounding, the quotient's, the denominator's. *)
  assert (HS : forall r, (r <= j)%nat -> within 3 (b r + a r) (N j r)).
  { intros r Hr. apply (within_trans 1 2) with ((Rt (r + 1)%nat + L (S j - r)%nat) * T r).
    - rewrite Rmult_plus_distr_r. apply within_add; apply rnd_within, Rmult_le_pos; auto.
    - replace (N j r) with (D r * (N j r / D r)) by (field; specialize (HD r Hr); lra).
      apply (within_mul 1 1); [|apply rnd_within; auto].
      assert (H0 : 0 <= Rt (r + 1)%nat + L (S j - r)%nat) by (specialize (HL r Hr); specialize (HR r); lra).
      destruct (rnd_within _ H0) as (h1 & h2 & h3 & h4). repeat split; auto. }
  set (G := fun r => match r with O => 0 | S q => a q end + (if (r =? S j)%nat then 0 else b r)).
  assert (EG : total G (S (S j)) = total (fun r => b r + a r) (S j)).
  { unfold G. rewrite total_add. rewrite (total_shift (S j) (fun r => match r with O => 0 | S q => a q end)).
    rewrite Rplus_0_l. change (total (fun r => if (r =? S j)%nat then 0 else b r) (S (S j))) with
      (total (fun r => if (r =? S j)%nat then 0 else b r) (S j) + (if (S j =? S j)%nat then 0 else b (S j))).
    rewrite Nat.eqb_refl, Rplus_0_r.
    rewrite (total_ext (S j) (fun r => if (r =? S j)%nat then 0 else b r) b)
      by (intros k Hk; destruct (Nat.eqb_spec k (S j)); [lia|auto]).
    rewrite total_add. apply Rplus_comm. }
  assert (EN : forall r, (r <= S j)%nat -> N (S j) r = if ((r =? 0) || (r =? S j))%nat then G r else rnd (G r)).
  { intros r Hr. cbn [entry]. unfold next, G. destruct (Nat.eqb_spec r (S j)) as [e|e].
    - subst r. cbn [Nat.eqb orb saved]. rewrite Rplus_0_r. reflexivity.
    - destruct r as [|q]; cbn [Nat.eqb orb saved]; cbn -[temp Nat.add].
      + rewrite !Rplus_0_l. unfold b. now rewrite rnd_idem.
      + reflexivity. }
  assert (GN : forall r, (r <= S j)%nat -> 0 <= G r).
  { intros r Hr. unfold G. apply Rplus_le_le_0_compat; [destruct r; [lra|apply Ha; lia]|].
    destruct (Nat.eqb_spec r (S j)); [lra|apply Hb; lia]. }
  assert (W3 : within 3 (total G (S (S j))) (total (N j) (S j))) by (rewrite EG; apply within_total; intros; apply HS; lia).
  destruct j as [|i].
  - rewrite (total_ext 2 (N 1%nat) G); [exact W3|]. intros k Hk. rewrite EN by lia. now destruct k as [|[|k]]; [| |lia].
  - apply (within_trans 1 3) with (total G (S (S (S i)))); auto. apply within_total. intros k Hk. rewrite EN by lia.
    destruct ((k =? 0) || (k =? S (S i)))%nat; [apply within_refl|apply rnd_within]; apply GN; lia.
Qed.

(* QUOTE docs/accuracy.md
| sum of the basis functions | `et_basis_eval` | 4p - 1 roundings | 1 |
END *)
Theorem basis_sum : forall p, (1 <= p)%nat -> within (4 * p - 1) (total (N p) (S p)) 1.
Proof.
  intros p Hp. destruct p as [|p]; [lia|]. clear Hp. induction p as [|p IH].
  - replace 1 with (total (N 0) 1) by (cbn; lra). apply (step_sum 0).
  - replace (4 * S (S p) - 1)%nat with (4 + (4 * S p - 1))%nat by lia. eapply within_trans; [apply (step_sum (S p))|exact IH].
Qed.

(* ---- the special case of et_basis_eval: x meets a knot of multiplicity p ---- *)

Lemma entry_left : forall p, (forall j, (1 <= j <= p)%nat -> Le j = 0) -> forall j r, (j <= p)%nat -> (r <= j)%nat ->
  Ne j r = if (r =? 0)%nat then 1 else 0.
Proof.
  intros p H. induction j as [|j IH]; intros r Hj Hr; [now replace r with O by lia|].
  assert (Z : saved (A := exact) Le Re (Ne j) (S j) r = 0).
  { destruct r as [|q]; [reflexivity|]. change (Le (S j - q)%nat * temp (A := exact) Le Re (Ne j) (S j) q = 0). rewrite H by lia. ring. }
  cbn [entry]. unfold next. rewrite Z. destruct (Nat.eqb_spec r (S j)) as [e|e]; [subst r; reflexivity|].
  change (0 + Re (r + 1)%nat * (Ne j r / (Re (r + 1)%nat + Le (S j - r)%nat)) = if (r =? 0)%nat then 1 else 0).
  rewrite <- IH by lia. pose proof (width_exact_pos (S j) r ltac:(lia)) as W. rewrite H in * by lia. field. lra.
Qed.
Lemma entry_right : forall p, (forall j, (1 <= j <= p)%nat -> Re j = 0) -> forall j r, (j <= p)%nat -> (r <= j)%nat ->
  Ne j r = if (r =? j)%nat then 1 else 0.
Proof.
  intros p H. induction j as [|j IH]; intros r Hj Hr; [now replace r with O by lia|].
  assert (Z : saved (A := exact) Le Re (Ne j) (S j) r = if (r =? S j)%nat then 1 else 0).
  { destruct r as [|q]; [reflexivity|]. change (Le (S j - q)%nat * (Ne j q / (Re (q + 1)%nat + Le (S j - q)%nat)) = if (q =? j)%nat then 1 else 0).
    rewrite <- IH by lia. pose proof (width_exact_pos (S j) q ltac:(lia)) as W. rewrite H in * by lia. field. lra. }
  cbn [entry]. unfold next. rewrite Z. destruct (Nat.eqb_spec r (S j)) as [e|e]; [reflexivity|].
  change (0 + Re (r + 1)%nat * temp (A := exact) Le Re (Ne j) (S j) r = 0). rewrite H by lia. ring.
Qed.

Lemma only_exact : forall p, (p <= s)%nat -> (only_of (A := arith) t p s x <= p)%nat ->
  forall r, (r <= p)%nat -> cox t s x p (s - p + r) = if (r =? only_of (A := arith) t p s x)%nat then 1 else 0.
Proof.
  intros p Hp. unfold only_of. destruct (Nat.eqb_spec p 0) as [e|e].
  - subst p. cbn [orb]. intros _ r Hr. replace r with O by lia. cbn [cox]. replace (s - 0 + 0)%nat with s by lia. now rewrite Nat.eqb_refl.
  - cbn [orb]. cbn [same arith rounded zero]. unfold same_R. destruct (Req_EM_T _ 0) as [z|z].
    + intros _ r Hr. rewrite <- scheme_is_cox by (auto; lia). apply entry_left with p; auto; try lia. intros j Hj. rewrite left_is.
      apply rnd_eq_zero in z. assert (t (s + 1 - p)%nat <= t (s + 1 - j)%nat) by (apply knots_le; auto; lia).
      assert (t (s + 1 - j)%nat <= t s) by (apply knots_le; auto; lia). lra.
    + destruct (Req_EM_T _ 0) as [z'|z']; [|lia].
      intros _ r Hr. rewrite <- scheme_is_cox by (auto; lia). apply entry_right with p; auto; try lia. intros j Hj. rewrite right_is.
      apply rnd_eq_zero in z'. assert (t (s + j)%nat <= t (s + p)%nat) by (apply knots_le; auto; lia).
      assert (t (S s) <= t (s + j)%nat) by (apply knots_le; auto; lia). lra.
Qed.

Lemma unit_row_nth : forall {A : arithmetic} p only r (d : A), (r <= p)%nat -> nth r (unit_row (A :=
  A) p only) d = if (r =? only)%nat then one else zero.
Proof.
  intros A p only r d Hr. unfold unit_row. rewrite nth_indep with (d' := (fun r => if (r =? only)%nat then one else zero) O)
    by (rewrite map_length, seq_length; lia).
  rewrite map_nth with (f := fun r => if (r =? only)%nat then one else zero). now rewrite seq_nth by lia.
Qed.

(* The whole function, degree 0 included, for a parameter that is clamped. *)
Theorem basis_at_within : forall p r, (p <= s)%nat -> (r <= p)%nat ->
  within (6 * p - 1) (nth r (basis_at (A := arith) t p s x) 0) (cox t s x p (s - p + r)).
Proof.
  intros p r Hp Hr. unfold basis_at. destruct (Nat.leb_spec (only_of (A := arith) t p s x) p) as [h|h].
  - rewrite only_exact by auto. rewrite unit_row_nth by auto.
    destruct (r =? _)%nat; [exact (within_refl _ 1 Rle_0_1)|exact (within_refl _ 0 (Rle_refl 0))].
  - rewrite outer_is_entry by auto. apply basis_within; auto. split; auto.
    destruct p; [cbn in h; lia|lia].
Qed.
Theorem basis_at_sum : forall p, (p <= s)%nat -> within (4 * p - 1) (total (fun r => nth r (basis_at (A := arith) t p s x) 0) (S p)) 1.
Proof.
  intros p Hp. unfold basis_at. destruct (Nat.leb_spec (only_of (A := arith) t p s x) p) as [h|h].
  - set (only := only_of (A := arith) t p s x) in *. rewrite (total_ext _ _ (fun r => if (r =? only)%nat then 1 else 0))
      by (intros; rewrite unit_row_nth by lia; reflexivity).
    assert (E : forall n, total (fun r => if (r =? only)%nat then 1 else 0) n = if (only <? n)%nat then 1 else 0).
    { induction n as [|n IH]; [reflexivity|]. cbn [total]. rewrite IH. destruct (Nat.ltb_spec only n), (Nat.eqb_spec n only),
      (Nat.ltb_spec only (S n)); try lia; lra. }
    rewrite E. destruct (Nat.ltb_spec only (S p)); [|lia]. apply within_refl; lra.
  - rewrite (total_ext _ _ (N p)) by (intros k Hk; exact (outer_is_entry (A := arith) L Rt 0 p k ltac:(lia))). apply basis_sum. destruct p;
    [cbn in h; lia|lia].
Qed.

End BasisError.

(* ---- sums of basis functions times numbers ---- *)

Lemma contract_near : forall N Ne P Pe Pm k l p,
  (forall r, (r <= p)%nat -> within l (N r) (Ne r)) -> (forall r, (r <= p)%nat -> near k (P r) (Pe r) (Pm r)) ->
  near (k + l + 1 + p) (contract (A := arith) N P p) (contract (A := exact) Ne Pe p) (contract (A := exact) Ne Pm p).
Proof.
  intros N Ne P Pe Pm k l p HN HP.
  assert (term : forall r, (r <= p)%nat -> near (k + l + 1) (rnd (N r * P r)) (Ne r * Pe r) (Ne r * Pm r)).
  { intros r Hr. apply near_rnd, near_mul; auto. }
  assert (E : forall q, (q <= p)%nat -> near (k + l + 1 + q) (contract (A := arith) N P q) (contract (A := exact) Ne Pe q) (contract (A :=
    exact) Ne Pm q)); [|auto].
  induction q as [|q IH]; intros Hq.
  - rewrite Nat.add_0_r. apply term; auto.
  - replace (k + l + 1 + S q)%nat with (k + l + 1 + q + 1)%nat by lia.
    refine (near_rnd _ (contract (A := arith) N P q + rnd (N (S q) * P (S q))) (_ + Ne (S q) * Pe (S q)) (_ + Ne (S q) * Pm (S q)) _).
    apply near_add; [apply IH; lia|]. apply near_weaken with (k + l + 1)%nat; [lia|apply term; lia].
Qed.
(* The same where the numbers are exact and the first factors have magnitudes, as derivatives do. *)
Lemma contract_near_exact : forall N Ne Nm P k p, (forall r, (r <= p)%nat -> near k (N r) (Ne r) (Nm r)) ->
  near (k + 1 + p) (contract (A := arith) N P p) (contract (A := exact) Ne P p) (contract (A := exact) Nm (fun r => Rabs (P r)) p).
Proof.
  intros N Ne Nm P k p HN.
  assert (term : forall r, (r <= p)%nat -> near (k + 1) (rnd (N r * P r)) (Ne r * P r) (Nm r * Rabs (P r))).
  { intros r Hr. apply near_rnd. destruct (HN r Hr) as [h1 h2]. pose proof (Rabs_pos (P r)). split.
    - rewrite <- Rmult_minus_distr_r, Rabs_mult. nra.
    - rewrite Rabs_mult. nra. }
  assert (E : forall q, (q <= p)%nat -> near (k + 1 + q) (contract (A := arith) N P q) (contract (A := exact) Ne P q) (contract (A :=
    exact) Nm (fun r => Rabs (P r)) q)); [|auto].
  induction q as [|q IH]; intros Hq.
  - rewrite Nat.add_0_r. apply term; auto.
  - replace (k + 1 + S q)%nat with (k + 1 + q + 1)%nat by lia.
    refine (near_rnd _ (contract (A := arith) N P q + rnd (N (S q) * P (S q))) (_ + Ne (S q) * P (S q)) (_ + Nm (S q) * Rabs (P (S q))) _).
    apply near_add; [apply IH; lia|]. apply near_weaken with (k + 1)%nat; [lia|apply term; lia].
Qed.
Lemma contract_within : forall N Ne P Pe k l p,
  (forall r, (r <= p)%nat -> within l (N r) (Ne r)) -> (forall r, (r <= p)%nat -> within k (P r) (Pe r)) ->
  within (k + l + 1 + p) (contract (A := arith) N P p) (contract (A := exact) Ne Pe p).
Proof.
  intros N Ne P Pe k l p HN HP.
  assert (term : forall r, (r <= p)%nat -> within (k + l + 1) (rnd (N r * P r)) (Ne r * Pe r)).
  { intros r Hr. apply within_rnd. rewrite Nat.add_comm. apply within_mul; auto. }
  assert (E : forall q, (q <= p)%nat -> within (k + l + 1 + q) (contract (A := arith) N P q) (contract (A := exact) Ne Pe q)); [|auto].
  induction q as [|q IH]; intros Hq.
  - rewrite Nat.add_0_r. apply term; auto.
  - replace (k + l + 1 + S q)%nat with (k + l + 1 + q + 1)%nat by lia.
    refine (within_rnd _ (contract (A := arith) N P q + rnd (N (S q) * P (S q))) (_ + Ne (S q) * Pe (S q)) _).
    apply within_add; [apply IH; lia|]. apply within_weaken with (k + l + 1)%nat; [lia|apply term; lia].
Qed.
Lemma contract_pos : forall N w p, (forall r, (r <= p)%nat -> 0 <= N r) -> (forall r, (r <= p)%nat -> 0 < w r) ->
  0 < total N (S p) -> 0 < contract (A := exact) N w p.
Proof.
  intros N w p HN Hw.
  assert (E : forall q, (q <= p)%nat -> 0 <= contract (A := exact) N w q /\ (0 < total N (S q) -> 0 < contract (A := exact) N w q)); [|intros;
    now apply E].
  induction q as [|q IH]; intros Hq.
  - specialize (HN O Hq). specialize (Hw O Hq). cbn. unfold plain. split; [nra|intros; nra].
  - specialize (HN (S q) Hq). specialize (Hw (S q) Hq). destruct (IH ltac:(lia)) as [IH1 IH2].
    change (contract (A := exact) N w (S q)) with (contract (A := exact) N w q + N (S q) * w (S q)).
    change (total N (S (S q))) with (total N (S q) + N (S q)). split; [nra|]. intros H.
    destruct (Rle_lt_dec (total N (S q)) 0); [assert (0 < N (S q)) by lra; nra|]. specialize (IH2 ltac:(auto)). nra.
Qed.

(* ---- points of curves and surfaces ---- *)

(* What the points need of a row of basis functions: their own error, and of the exact ones that they are a partition of unity.  A row of the
   scheme has it (basis_row); exact sums of 1 follow from basis_sum with no rounding at all. *)
Definition row (p : nat) (N Ne : nat -> R) : Prop :=
  (forall r, (r <= p)%nat -> within (6 * p - 1) (N r) (Ne r)) /\ total Ne (S p) = 1.

Lemma contract_row_pos : forall p N Ne w, row p N Ne -> (forall r, (r <= p)%nat -> 0 < w r) -> 0 < contract (A := exact) Ne w p.
Proof. intros p N Ne w [HN H1] Hw. apply contract_pos; auto; [intros; now apply HN|]. rewrite H1; lra. Qed.

Section Points.
Variables (p q : nat) (N Ne M Me : nat -> R).
Hypothesis degree_p : (1 <= p)%nat.
Hypothesis degree_q : (1 <= q)%nat.
Hypothesis row_N : row p N Ne.
Hypothesis row_M : row q M Me.

(* QUOTE include/etalon/spline/curve.h
 * Error of a coordinate of a polynomial curve: at most ((1-u)^-m - 1) sum N |c|, m = 7p, barring underflow; a rational one: the same bound for
 * numerator (m + 1) and denominator, and one rounding.
END *)
Theorem curve_point_near : forall P, (forall r, (r <= p)%nat -> rnd (P r) = P r) ->
  near (7 * p) (curve_point (A := arith) N P p) (curve_point (A := exact) Ne P p) (contract (A := exact) Ne (fun r => Rabs (P r)) p).
Proof.
  clear degree_q row_M M Me q. intros P HP. replace (7 * p)%nat with (0 + (6 * p - 1) + 1 + p)%nat by lia. apply contract_near; [apply row_N|].
  intros r Hr. cbn. unfold plain. rewrite Rmult_1_l, HP by auto. apply near_refl.
Qed.
(* With weights 7p + 1 of the numerator, 7p of the denominator, one of the division. *)
Theorem curve_point_rational_near : forall w P, (forall r, (r <= p)%nat -> 0 < w r) ->
  near (14 * p + 2) (curve_point_rational (A := arith) N w P p) (curve_point_rational (A := exact) Ne w P p)
    (contract (A := exact) Ne (fun r => w r * Rabs (P r)) p / contract (A := exact) Ne w p).
Proof.
  clear degree_q row_M M Me q. intros w P Hw. replace (14 * p + 2)%nat with (1 + (6 * p - 1) + 1 + p + (0 + (6 * p - 1) + 1 + p) + 1)%nat by lia.
  apply near_rnd, near_div.
  - now apply (contract_row_pos p N).
  - apply contract_within; [apply row_N|]. intros r Hr. apply within_refl. specialize (Hw r Hr); lra.
  - apply contract_near; [apply row_N|]. intros r Hr. apply (near_rnd 0). cbn. unfold plain. specialize (Hw r Hr).
    rewrite <- (Rabs_pos_eq (w r)) at 3 by lra. rewrite <- Rabs_mult. apply near_refl.
Qed.

(* QUOTE docs/accuracy.md
| surface point, polynomial | `et_surface_point` | 7 (p + q) roundings | sum N M abs(x) |
END
   QUOTE include/etalon/spline/surface.h
 * Parameters outside the domain are clamped to it.  Error of a coordinate of a polynomial surface: at most ((1-u)^-m - 1) sum N M |x|,
 * m = 7(p + q), barring underflow; a rational one: the same bound for numerator (m+1) and denominator, and one rounding.
END *)
Theorem surface_point_near : forall P, (forall i j, (i <= p)%nat -> (j <= q)%nat -> rnd (P i j) = P i j) ->
  near (7 * (p + q)) (surface_point (A := arith) N M P p q) (surface_point (A := exact) Ne Me P p q)
    (contract_uv (A := exact) Ne Me (fun i j => Rabs (P i j)) p q).
Proof.
  intros P HP. replace (7 * (p + q))%nat with (0 + (6 * p - 1) + 1 + p + (6 * q - 1) + 1 + q)%nat by lia.
  unfold surface_point, contract_uv. apply contract_near; [apply row_M|]. intros j Hj. apply contract_near; [apply row_N|].
  intros r Hr. cbn. unfold plain. rewrite Rmult_1_l, HP by auto. apply near_refl.
Qed.
(* QUOTE docs/accuracy.md
| surface point, rational | `et_surface_point` | 14 (p + q) + 2 roundings | sum N M w abs(x) / sum N M w |
END *)
Theorem surface_point_rational_near : forall w P, (forall i j, (i <= p)%nat -> (j <= q)%nat -> 0 < w i j) ->
  near (14 * (p + q) + 2) (surface_point_rational (A := arith) N M w P p q) (surface_point_rational (A := exact) Ne Me w P p q)
    (contract_uv (A := exact) Ne Me (fun i j => w i j * Rabs (P i j)) p q / contract_uv (A := exact) Ne Me w p q).
Proof.
  intros w P Hw. replace (14 * (p + q) + 2)%nat with
    (1 + (6 * p - 1) + 1 + p + (6 * q - 1) + 1 + q + (0 + (6 * p - 1) + 1 + p + (6 * q - 1) + 1 + q) + 1)%nat by lia.
  apply near_rnd, near_div.
  - apply (contract_row_pos q M); auto. intros j Hj. apply (contract_row_pos p N); auto.
  - apply contract_within; [apply row_M|]. intros j Hj. apply contract_within; [apply row_N|].
    intros r Hr. apply within_refl. specialize (Hw r j Hr Hj); lra.
  - apply contract_near; [apply row_M|]. intros j Hj. apply contract_near; [apply row_N|].
    intros r Hr. apply (near_rnd 0). cbn. unfold plain. specialize (Hw r j Hr Hj).
    rewrite <- (Rabs_pos_eq (w r j)) at 3 by lra. rewrite <- Rabs_mult. apply near_refl.
Qed.
End Points.

(* ---- insertion of a knot ---- *)

Section Insertion.
Variables (p k s : nat) (x : R).

(* Knots that do not decrease, x in the span from k on. *)
Definition spanned (t : nat -> R) (at_ : nat) : Prop := (forall i, t i <= t (S i)) /\ t at_ <= x < t (S at_).

Lemma inserted_spanned : forall t times, spanned t k -> spanned (inserted_knots (A := exact) t k x times) (k + times).
Proof.
  intros t times H. induction times as [|n [IHs IHx]]; [now rewrite Nat.add_0_r|]. cbn [inserted_knots].
  set (v := inserted_knots (A := exact) t k x n) in *. unfold spanned, insert_knots.
  replace (k + S n)%nat with (k + n + 1)%nat by lia. set (m := (k + n)%nat) in *. split.
  - intros i. destruct (Nat.leb_spec i m), (Nat.leb_spec (S i) m), (Nat.eqb_spec i (m + 1)), (Nat.eqb_spec (S i) (m + 1)); try lia; auto.
    + replace i with m by lia. lra.
    + replace (S i - 1)%nat with (S m) by lia. lra.
    + replace (S i - 1)%nat with (S (i - 1)) by lia. apply IHs.
  - destruct (Nat.leb_spec (m + 1) m), (Nat.leb_spec (S (m + 1)) m), (Nat.eqb_spec (m + 1) (m + 1)), (Nat.eqb_spec (S (m + 1)) (m + 1)); try lia.
    replace (S (m + 1) - 1)%nat with (S m) by lia. lra.
Qed.

(* The knots are moved, not computed: with any rounding they are the same. *)
Lemma inserted_knots_same : forall t times, inserted_knots (A := arith) t k x times = inserted_knots (A := exact) t k x times.
Proof. induction times; [reflexivity|]. cbn [inserted_knots]. now rewrite IHtimes. Qed.

Lemma shares_within : forall t at_ i, spanned t at_ -> (i <= at_ < i + p)%nat ->
  within 3 (share_a (A := arith) t p i x) (share_a (A := exact) t p i x) /\ within 3 (share_b (A := arith) t p i x) (share_b (A := exact) t p i x).
Proof.
  intros t at_ i [Hs Hx] Hi. assert (t i <= t at_) by (apply knots_le; auto; lia).
  assert (t (S at_) <= t (i + p)%nat) by (apply knots_le; auto; lia).
  assert (W : 0 < t (i + p)%nat - t i) by lra. pose proof (rnd_within _ (Rlt_le _ _ W)) as W1. pose proof (within_pos _ _ _ W1 W).
  split; apply (within_rnd 2), (within_div 1 1); auto.
  - exact (rnd_within (x - t i) ltac:(lra)).
  - exact (rnd_within (t (i + p)%nat - x) ltac:(lra)).
Qed.

(* One knot costs five roundings relative to the convex combination of the magnitudes. *)
Lemma insert_near : forall n t at_ m h he hm, spanned t at_ -> (forall i, near n (h i) (he i) (hm i)) ->
  forall i, near (n + 5) (insert_points (A := arith) t p at_ m x h i) (insert_points (A := exact) t p at_ m x he i) (insert_points (A :=
    exact) t p at_ m x hm i).
Proof.
  intros n t at_ m h he hm Hs H i. unfold insert_points. destruct (Nat.leb_spec i (at_ - m)).
  - destruct (Nat.ltb_spec at_ (i + p)).
    + destruct (shares_within t at_ i Hs ltac:(lia)) as [Wa Wb]. replace (n + 5)%nat with (n + 3 + 1 + 1)%nat by lia.
      apply near_rnd, near_add; apply near_rnd, near_mul; auto.
    + apply near_weaken with n; auto; lia.
  - apply near_weaken with n; auto; lia.
Qed.

(* Beyond multiplicity p nothing is computed. *)
Lemma insert_copies : forall n t at_ m h he hm, (p <= m <= at_)%nat -> (forall i, near n (h i) (he i) (hm i)) ->
  forall i, near n (insert_points (A := arith) t p at_ m x h i) (insert_points (A := exact) t p at_ m x he i) (insert_points (A :=
    exact) t p at_ m x hm i).
Proof.
  intros n t at_ m h he hm Hm H i. unfold insert_points. destruct (Nat.leb_spec i (at_ - m)); auto. destruct (Nat.ltb_spec at_ (i + p)); auto; lia.
Qed.

(* QUOTE include/etalon/spline/curve.h
 * weights remain positive.  A coordinate of a polynomial curve's control point, and a weight, is off by at most ((1-u)^-m - 1) sum A |c|, A the
 * convex combination that makes it of the old ones, m = 5 min(times, p); a coordinate of a rational one: numerator m + 1, denominator m, and one
 * rounding. All barring underflow. */
END
   (h: points that n roundings went into already.) *)
Theorem inserted_near : forall n t h he hm times, spanned t k -> (s <= k)%nat -> (forall i, near n (h i) (he i) (hm i)) ->
  forall i, near (n + 5 * Nat.min times p) (inserted (A := arith) t p k s x h times i) (inserted (A := exact) t p k s x he times i)
    (inserted (A := exact) t p k s x hm times i).
Proof.
  intros n t h he hm times Hs Hk H. induction times as [|l IH]; intros i; [now rewrite Nat.add_0_r|].
  cbn [inserted]. rewrite inserted_knots_same. destruct (Nat.le_gt_cases p l) as [e|e].
  - replace (Nat.min (S l) p) with (Nat.min l p) by lia. apply insert_copies; auto; lia.
  - replace (n + 5 * Nat.min (S l) p)%nat with (n + 5 * Nat.min l p + 5)%nat by lia. apply insert_near; auto. now apply inserted_spanned.
Qed.
Corollary inserted_polynomial : forall t c times, spanned t k -> (s <= k)%nat ->
  forall i, near (5 * Nat.min times p) (inserted (A := arith) t p k s x c times i) (inserted (A := exact) t p k s x c times i)
    (inserted (A := exact) t p k s x (fun i => Rabs (c i)) times i).
Proof. intros. apply (inserted_near 0); auto. intros; apply near_refl. Qed.

Lemma inserted_pos : forall t w times, spanned t k -> (forall i, 0 < w i) -> forall i, 0 < inserted (A := exact) t p k s x w times i.
Proof.
  intros t w times Hs Hw. induction times as [|n IH]; intros i; cbn [inserted]; auto.
  unfold insert_points. destruct (Nat.leb_spec i (k + n - (s + n))); auto. destruct (Nat.ltb_spec (k + n) (i + p)); auto.
  pose proof (inserted_spanned t n Hs) as [S1 S2]. set (v := inserted_knots (A := exact) t k x n) in *.
  assert (v i <= v (k + n)%nat) by (apply knots_le; auto; lia).
  assert (v (S (k + n)) <= v (i + p)%nat) by (apply knots_le; auto; lia).
  change (0 < (x - v i) / (v (i + p)%nat - v i) * inserted (A := exact) t p k s x w n i
            + (v (i + p)%nat - x) / (v (i + p)%nat - v i) * inserted (A := exact) t p k s x w n (i - 1)%nat).
  apply Rplus_le_lt_0_compat.
  - apply Rmult_le_pos; [|apply Rlt_le, IH]. apply Rmult_le_pos; [lra|]. apply Rlt_le, Rinv_0_lt_compat; lra.
  - apply Rmult_lt_0_compat; [|apply IH]. apply Rmult_lt_0_compat; [lra|]. apply Rinv_0_lt_compat; lra.
Qed.
(* Weights: all terms are positive. *)
Lemma inserted_within : forall n t h he times, spanned t k -> (s <= k)%nat -> (forall i, within n (h i) (he i)) ->
  forall i, within (n + 5 * Nat.min times p) (inserted (A := arith) t p k s x h times i) (inserted (A := exact) t p k s x he times i).
Proof.
  intros n t h he times Hs Hk H. induction times as [|l IH]; intros i; [now rewrite Nat.add_0_r|].
  cbn [inserted]. rewrite inserted_knots_same. unfold insert_points. set (v := inserted_knots (A := exact) t k x l).
  destruct (Nat.leb_spec i (k + l - (s + l))) as [e|e]; [destruct (Nat.ltb_spec (k + l) (i + p)) as [e'|e']|];
    try (apply within_weaken with (n + 5 * Nat.min l p)%nat; [lia|apply IH]).
  destruct (shares_within v (k + l) i (inserted_spanned t l Hs) ltac:(lia)) as [Wa Wb].
  replace (n + 5 * Nat.min (S l) p)%nat with (3 + (n + 5 * Nat.min l p) + 1 + 1)%nat by lia.
  apply within_rnd, within_add; apply within_rnd, within_mul; auto.
Qed.
(* A rational curve's: m + 1 of the numerator, m of the denominator, one of the division. *)
Theorem inserted_rational : forall t w c times, spanned t k -> (s <= k)%nat -> (forall i, 0 < w i) ->
  forall i, near (10 * Nat.min times p + 2)
    (rnd (inserted (A := arith) t p k s x (fun i => rnd (w i * c i)) times i / inserted (A := arith) t p k s x w times i))
    (inserted (A := exact) t p k s x (fun i => w i * c i) times i / inserted (A := exact) t p k s x w times i)
    (inserted (A := exact) t p k s x (fun i => w i * Rabs (c i)) times i / inserted (A := exact) t p k s x w times i).
Proof.
  intros t w c times Hs Hk Hw i. replace (10 * Nat.min times p + 2)%nat with (1 + 5 * Nat.min times p + (0 + 5 * Nat.min times p) + 1)%nat by lia.
  apply near_rnd, near_div.
  - now apply inserted_pos.
  - apply inserted_within; auto. intros j. apply within_refl. specialize (Hw j); lra.
  - apply inserted_near; auto. intros j. apply (near_rnd 0). specialize (Hw j).
    rewrite <- (Rabs_pos_eq (w j)) at 3 by lra. rewrite <- Rabs_mult. apply near_refl.
Qed.
End Insertion.

(* ---- derivatives ---- *)

(* The arithmetic of magnitudes: differences become sums.  basis.h: the recursion of the a_kj suffers no cancellation, so there these are |a_kj|. *)
Definition magnitudes : arithmetic := Arithmetic R 0 1 Rplus Rplus Rmult Rdiv less_R same_R.

Section Derivatives.
Variable t : nat -> R.
Hypothesis sorted : forall i, t i <= t (S i).
Variables (s : nat) (x : R).
Hypothesis span : t s < t (S s).
Hypothesis inside : t s <= x <= t (S s).
Notation L := (to_left (A := arith) t s x).
Notation Rt := (to_right (A := arith) t s x).
Notation Le := (to_left (A := exact) t s x).
Notation Re := (to_right (A := exact) t s x).

Lemma outside_not : forall p r k j, (k <= p)%nat -> outside p r k j = false -> (k <= r + j)%nat /\ (r + j - k <= p - k)%nat.
Proof. intros p r k j Hk. unfold outside. rewrite orb_false_iff, !Nat.ltb_ge. tauto. Qed.

Lemma coefficient_near : forall p r k, (k <= p)%nat -> forall j,
  near (4 * k) (coefficient (A := arith) L Rt p r k j) (coefficient (A := exact) Le Re p r k j) (coefficient (A := magnitudes) Le Re p r k j).
Proof.
  intros p r. induction k as [|l IH]; intros Hk j.
  - change (near 0 1 1 1). rewrite <- Rabs_R1 at 3. apply near_refl.
  - assert (Z : forall n, near n 0 0 0) by (intros; split; [rewrite Rminus_eq_0, Rabs_R0; lra|rewrite Rabs_R0; lra]).
    cbn [coefficient]. destruct (outside p r (S l) j) eqn:O; [apply Z|]. apply outside_not in O; [|lia].
    set (i := (r + j - S l)%nat) in *. replace (4 * S l)%nat with (4 * l + 1 + 2 + 1)%nat by lia.
    pose proof (width_within t sorted s x inside (p - S l + 1) i ltac:(lia)) as W.
    pose proof (width_exact_pos t sorted s x span (p - S l + 1) i ltac:(lia)) as Wpos.
    apply near_rnd. apply (near_div _ 2); [exact Wpos|exact W|]. apply near_rnd.
    apply near_sub; [destruct (j <? S l)%nat|destruct j as [|j']]; try apply Z; apply IH; lia.
Qed.

(* Signs alternate, (-1)^j: no difference cancels. *)
Theorem coefficient_sign : forall p r k j, (k <= p)%nat -> (j <= k)%nat ->
  coefficient (A := exact) Le Re p r k j = (-1) ^ j * coefficient (A := magnitudes) Le Re p r k j.
Proof.
  intros p r. induction k as [|l IH]; intros j Hk Hj.
  - replace j with O by lia. change (1 = (-1) ^ 0 * 1). ring.
  - cbn [coefficient]. destruct (outside p r (S l) j); [change (0 = (-1) ^ j * 0); ring|].
    assert (E : forall a b wd, a = (-1) ^ j * b -> a / wd = (-1) ^ j * (b / wd)) by (intros a b wd ->; unfold Rdiv; ring).
    apply (E _ _ (Re (r + j - S l + 1)%nat + Le (p - S l + 1 - (r + j - S l))%nat)). clear E.
    destruct (Nat.ltb_spec j (S l)) as [e|e]; destruct j as [|i].
    + rewrite IH by lia. change ((-1) ^ 0 * coefficient (A := magnitudes) Le Re p r l 0 - 0 = (-1) ^ 0 * (coefficient (A :=
      magnitudes) Le Re p r l 0 + 0)). ring.
    + rewrite !IH by lia.
      change ((-1) ^ S i * coefficient (A := magnitudes) Le Re p r l (S i) - (-1) ^ i * coefficient (A := magnitudes) Le Re p r l i =
              (-1) ^ S i * (coefficient (A := magnitudes) Le Re p r l (S i) + coefficient (A := magnitudes) Le Re p r l i)).
      cbn [pow]. ring.
    + lia.
    + rewrite IH by lia. change (0 - (-1) ^ i * coefficient (A := magnitudes) Le Re p r l i = (-1) ^ S i * (0 + coefficient (A :=
      magnitudes) Le Re p r l i)).
      cbn [pow]. ring.
Qed.
Corollary coefficient_magnitude : forall p r k j, (k <= p)%nat -> (j <= k)%nat ->
  Rabs (coefficient (A := exact) Le Re p r k j) = coefficient (A := magnitudes) Le Re p r k j.
Proof.
  intros p r k j Hk Hj. rewrite coefficient_sign, Rabs_mult, pow_1_abs by auto. pose proof (near_magnitude _ _ _ _ (coefficient_near p r k Hk j)).
  rewrite Rabs_pos_eq by auto. ring.
Qed.

(* The functions of lower degree that the sum meets. *)
Notation N := (entry (A := arith) L Rt).
Notation Ne := (entry (A := exact) Le Re).
Definition magnitude_sum (p r k n : nat) : R :=
  total (fun j => if outside p r k j then 0 else Rabs (coefficient (A := exact) Le Re p r k j) * Ne (p - k)%nat (r + j - k)%nat) n.

Lemma derivative_sum_near : forall p r k n, (k <= p)%nat -> (n <= k + 1)%nat ->
  near (4 * k + steps (p - k) + 1 + (n - 1)) (derivative_sum (A := arith) L Rt p r k n) (derivative_sum (A :=
    exact) Le Re p r k n) (magnitude_sum p r k n).
Proof.
  intros p r k n Hk. induction n as [|j IH]; intros Hn.
  - split; cbn; [rewrite Rminus_eq_0, Rabs_R0; lra|rewrite Rabs_R0; lra].
  - specialize (IH ltac:(lia)). unfold magnitude_sum in *. cbn [total derivative_sum]. destruct (outside p r k j) eqn:O.
    + rewrite Rplus_0_r. apply near_weaken with (2 := IH). lia.
    + apply outside_not in O; auto. rewrite coefficient_magnitude by lia.
      set (i := (r + j - k)%nat) in *.
      assert (T : near (4 * k + steps (p - k) + 1) (rnd (coefficient (A := arith) L Rt p r k j * N (p - k)%nat i))
        (coefficient (A := exact) Le Re p r k j * Ne (p - k)%nat i) (coefficient (A := magnitudes) Le Re p r k j * Ne (p - k)%nat i)).
      { apply near_rnd. rewrite (Rmult_comm (coefficient (A := arith) L Rt p r k j)), (Rmult_comm (coefficient (A := exact) Le Re p r k j)),
          (Rmult_comm (coefficient (A := magnitudes) Le Re p r k j)). apply near_mul; [apply entry_within; auto; lia|now apply coefficient_near]. }
      destruct j as [|j'].
      * change (near (4 * k + steps (p - k) + 1 + (1 - 1)) (rnd (0 + rnd (coefficient (A := arith) L Rt p r k 0 * N (p - k)%nat i)))
          (0 + coefficient (A := exact) Le Re p r k 0 * Ne (p - k)%nat i) (0 + coefficient (A := magnitudes) Le Re p r k 0 * Ne (p - k)%nat i)).
        rewrite !Rplus_0_l, rnd_idem. apply near_weaken with (2 := T). lia.
      * replace (4 * k + steps (p - k) + 1 + (S (S j') - 1))%nat with (4 * k + steps (p - k) + 1 + (S j' - 1) + 1)%nat by lia.
        refine (near_rnd _ (_ + _) (_ + _) _ _). apply near_add; auto. apply near_weaken with (2 := T). lia.
Qed.

Lemma factor_within : forall p k, within k (factor (A := arith) INR p k) (factor (A := exact) INR p k).
Proof.
  intros p. induction k as [|l IH]; [exact (within_refl 0 1 Rle_0_1)|].
  replace (S l) with (l + 0 + 1)%nat at 1 by lia.
  refine (within_rnd _ (factor (A := arith) INR p l * INR (p - S l + 1)) (factor (A := exact) INR p l * INR (p - S l + 1)) _).
  apply within_mul; auto. apply within_refl, pos_INR.
Qed.

(* QUOTE docs/accuracy.md
| derivatives of basis functions | `et_basis_ders` | 6p + 2 roundings | sum of the terms' absolute values (Eq. 2.9) |
END
   QUOTE include/etalon/spline/basis.h
 * A k-th derivative is p!/(p-k)! sum_j a_kj N_{i+j,p-k} (Eq. 2.9).  The a_kj and their recursion suffer no cancellation; hence the error is
 * at most ((1-u)^-m - 1) p!/(p-k)! sum_j |a_kj| N_{i+j,p-k}, m = 6p + 2, barring over- and underflow: small relative to the largest
 * derivatives, not to one that vanishes. */
END *)
Theorem derivative_near : forall p r k, (1 <= k <= p)%nat ->
  near (6 * p + 2) (derivative (A := arith) L Rt INR p r k) (derivative (A := exact) Le Re INR p r k)
    (factor (A := exact) INR p k * magnitude_sum p r k (k + 1)).
Proof.
  intros p r k Hk. pose proof (derivative_sum_near p r k (k + 1) ltac:(lia) ltac:(lia)) as D.
  apply near_weaken with (4 * k + steps (p - k) + 1 + (k + 1 - 1) + k + 1)%nat.
  { unfold steps. destruct (p - k)%nat eqn:E; lia. }
  unfold derivative. refine (near_rnd _ (derivative_sum (A := arith) L Rt p r k (k + 1) * factor (A := arith) INR p k)
    (derivative_sum (A := exact) Le Re p r k (k + 1) * factor (A := exact) INR p k) _ _).
  rewrite (Rmult_comm (derivative_sum (A := arith) L Rt p r k (k + 1))), (Rmult_comm (derivative_sum (A := exact) Le Re p r k (k + 1))).
  apply near_mul; auto. apply factor_within.
Qed.

(* QUOTE include/etalon/spline/curve.h
 * Error of a coordinate of a polynomial curve's k-th derivative: at most ((1-u)^-(7p+3) - 1) M_k, M_k the sum of the magnitudes of all terms,
 * p!/(p-k)! sum_ij |a_kj| N_{i+j,p-k} |c_i| (et_basis_ders).  A rational curve's derivatives satisfy Leibniz' rule for w C = A up to roundings:
END *)
Theorem curve_derivative_near : forall p k P, (1 <= k <= p)%nat ->
  near (7 * p + 3) (contract (A := arith) (fun r => derivative (A := arith) L Rt INR p r k) P p)
    (contract (A := exact) (fun r => derivative (A := exact) Le Re INR p r k) P p)
    (contract (A := exact) (fun r => factor (A := exact) INR p k * magnitude_sum p r k (k + 1)) (fun r => Rabs (P r)) p).
Proof.
  intros p k P Hk. replace (7 * p + 3)%nat with (6 * p + 2 + 1 + p)%nat by lia. apply contract_near_exact. intros r Hr. now apply derivative_near.
Qed.
End Derivatives.
End Error.

(* ---- over the reals the functions are a partition of unity: 4p - 1 roundings that do nothing ---- *)

Lemma plain_error : forall y, Rabs (plain y - y) <= 0 * Rabs y.
Proof. intros. unfold plain. rewrite Rminus_eq_0, Rabs_R0, Rmult_0_l. lra. Qed.

Theorem cox_unity : forall t s x p, (forall i, t i <= t (S i)) -> t s < t (S s) -> t s <= x <= t (S s) -> (p <= s)%nat ->
  total (fun r => cox t s x p (s - p + r)) (S p) = 1.
Proof.
  intros t s x p Ht Hs Hx Hp.
  destruct (basis_at_sum 0 ltac:(lra) plain plain_error (fun _ => eq_refl) t Ht s x Hs Hx p Hp) as (_ & _ & h1 & h2).
  replace (1 - 0) with 1 in * by ring. rewrite pow1 in *.
  rewrite (total_ext _ _ (fun r => nth r (basis_at (A := exact) t p s x) 0)); [change exact with (rounded plain); lra|].
  intros r Hr. destruct (basis_at_within 0 ltac:(lra) plain plain_error (fun _ => eq_refl) t Ht s x Hs Hx p r Hp ltac:(lia)) as (_ & _ & g1 & g2).
  replace (1 - 0) with 1 in * by ring. rewrite pow1 in *. change exact with (rounded plain). lra.
Qed.

(* So what et_basis_eval computes is a row in the sense of the theorems on points. *)
Theorem basis_row : forall u rnd t s x p, 0 <= u < 1 -> (forall y, Rabs (rnd y - y) <= u * Rabs y) -> (forall y, rnd (rnd y) = rnd y) ->
  (forall i, t i <= t (S i)) -> t s < t (S s) -> t s <= x <= t (S s) -> (p <= s)%nat ->
  row u p (fun r => nth r (basis_at (A := rounded rnd) t p s x) 0) (fun r => cox t s x p (s - p + r)).
Proof. intros. split; [intros; now apply basis_at_within|now apply cox_unity]. Qed.

(* Powers of 1 - u and multiples of u: (1-u)^-k - 1 is at most k u / (1 - k u). *)
Lemma near_gamma : forall u k a b m, 0 <= u < 1 -> INR k * u < 1 -> near u k a b m -> Rabs (a - b) <= INR k * u / (1 - INR k * u) * m.
Proof.
  intros u k a b m Hu Hk N. pose proof (near_magnitude _ _ _ _ _ N) as Hm. destruct N as [h _].
  assert (B : forall n, 1 - INR n * u <= (1 - u) ^ n).
  { induction n as [|n IH]; [simpl; lra|]. rewrite S_INR; simpl. pose proof (power_pos u Hu n). pose proof (pos_INR n). nra. }
  pose proof (B k). assert (/ (1 - u) ^ k <= / (1 - INR k * u)) by (apply Rinv_le_contravar; lra).
  replace (INR k * u / (1 - INR k * u)) with (/ (1 - INR k * u) - 1) by (field; lra). nra.
Qed.
