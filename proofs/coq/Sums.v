(* Sums: finite sums of real numbers, and the quotient with 0/0 = 0.

   What the files on splines need of them, and nothing else.  All sums run over 0 .. n-1, as the loops of the code do. *)
Require Import Reals Lra Lia Arith.
Open Scope R_scope.

(* ---- sums ---- *)

(* f 0 + f 1 + ... + f (n-1), from left to right. *)
Fixpoint sum (f : nat -> R) (n : nat) : R :=
  match n with O => 0 | S k => sum f k + f k end.

Lemma sum_ext : forall n f g, (forall k, (k < n)%nat -> f k = g k) -> sum f n = sum g n.
Proof. induction n; simpl; intros f g H; [reflexivity|]. rewrite (IHn f g), H; auto. Qed.

Lemma sum_add : forall n f g, sum (fun k => f k + g k) n = sum f n + sum g n.
Proof. induction n; simpl; intros; [|rewrite IHn]; lra. Qed.

Lemma sum_scal : forall n c f, sum (fun k => c * f k) n = c * sum f n.
Proof. induction n; simpl; intros; [|rewrite IHn]; lra. Qed.

Lemma sum_zero : forall n f, (forall k, (k < n)%nat -> f k = 0) -> sum f n = 0.
Proof. induction n; simpl; intros f H; [reflexivity|]. rewrite IHn, H; auto; lra. Qed.

(* The first term apart. *)
Lemma sum_first : forall n f, sum f (S n) = f O + sum (fun k => f (S k)) n.
Proof.
  induction n; intros f; [simpl; lra|].
  change (sum f (S (S n))) with (sum f (S n) + f (S n)). rewrite IHn; simpl; lra.
Qed.

Lemma sum_split : forall a b f, sum f (a + b) = sum f a + sum (fun k => f (a + k)%nat) b.
Proof.
  induction b; intros f; [rewrite Nat.add_0_r; simpl; lra|].
  rewrite Nat.add_succ_r; simpl; rewrite IHb; lra.
Qed.

Lemma sum_nonneg : forall n f, (forall k, (k < n)%nat -> 0 <= f k) -> 0 <= sum f n.
Proof.
  induction n; simpl; intros f H; [lra|].
  assert (0 <= sum f n) by auto. assert (0 <= f n) by auto. lra.
Qed.

Lemma sum_le : forall n f g, (forall k, (k < n)%nat -> f k <= g k) -> sum f n <= sum g n.
Proof.
  induction n; simpl; intros f g H; [lra|].
  assert (sum f n <= sum g n) by auto. assert (f n <= g n) by auto. lra.
Qed.

(* Only one term is not zero. *)
Lemma sum_single : forall n f i, (i < n)%nat -> (forall k, (k < n)%nat -> k <> i -> f k = 0) -> sum f n = f i.
Proof.
  induction n; intros f i Hi H; [lia|]. simpl. destruct (Nat.eq_dec i n) as [->|Hne].
  - rewrite sum_zero; [lra|]. intros; apply H; lia.
  - rewrite (IHn f i), (H n); try lia; try lra. intros; apply H; lia.
Qed.

Lemma sum_swap : forall m n (f : nat -> nat -> R),
  sum (fun i => sum (fun j => f i j) n) m = sum (fun j => sum (fun i => f i j) m) n.
Proof.
  induction m; intros n f; simpl; [now rewrite sum_zero|]. rewrite IHm, <- sum_add; reflexivity.
Qed.

(* Terms that are not negative, weighted by positive numbers, and not all zero: the sum is positive. *)
Lemma sum_weighted_pos : forall n f w, (forall k, (k < n)%nat -> 0 <= f k) -> 0 < sum f n ->
  (forall k, (k < n)%nat -> 0 < w k) -> 0 < sum (fun k => f k * w k) n.
Proof.
  induction n; simpl; intros f w Hf Hs Hw; [lra|].
  assert (F : 0 <= f n) by auto. assert (W : 0 < w n) by auto.
  assert (P : 0 <= sum (fun k => f k * w k) n).
  { apply sum_nonneg; intros. apply Rmult_le_pos; [auto|]. apply Rlt_le; auto. }
  destruct (Rle_lt_dec (f n) 0).
  - assert (E : f n = 0) by lra. rewrite E, Rmult_0_l, Rplus_0_r. apply IHn; auto; lra.
  - assert (0 < f n * w n) by now apply Rmult_lt_0_compat. lra.
Qed.

(* ---- the quotient of the recursion, 0/0 = 0 ---- *)

Definition frac (a b : R) : R := if Req_EM_T b 0 then 0 else a / b.

Lemma frac_nz : forall a b, b <> 0 -> frac a b = a / b.
Proof. intros; unfold frac; destruct (Req_EM_T b 0); auto; contradiction. Qed.

Lemma frac_0 : forall b, frac 0 b = 0.
Proof. intros; unfold frac; destruct (Req_EM_T b 0); auto; unfold Rdiv; ring. Qed.

Lemma frac_nonneg : forall a b, 0 <= a -> 0 <= b -> 0 <= frac a b.
Proof.
  intros; unfold frac; destruct (Req_EM_T b 0); [lra|].
  apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat; lra.
Qed.

(* ---- what lies beyond an interval is moved to its end, as the code does with parameters ---- *)

Definition clamp (lo hi x : R) : R := if Rlt_dec x lo then lo else if Rlt_dec hi x then hi else x.

Lemma clamp_range : forall lo hi x, lo <= hi -> lo <= clamp lo hi x <= hi.
Proof. intros; unfold clamp; destruct (Rlt_dec x lo); [|destruct (Rlt_dec hi x)]; lra. Qed.

Lemma clamp_id : forall lo hi x, lo <= x <= hi -> clamp lo hi x = x.
Proof. intros; unfold clamp; destruct (Rlt_dec x lo); [|destruct (Rlt_dec hi x)]; lra. Qed.
