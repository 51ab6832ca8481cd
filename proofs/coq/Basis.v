(* Basis: the B-spline basis functions of Cox and de Boor, of any degree p and over any non-decreasing knots, with 0/0 = 0.

   Knots are a function t : nat -> R, of which a knot vector t_0 .. t_(n+p) of n control points is the beginning (let the last knot go on);
   what is said of n functions depends on no other knot (basis_ext).  The domain is [t_p, t_n].  The header etalon/spline/basis.h has the same
   definition,
       N_i,0(x) = 1 if t_i <= x < t_(i+1) (the last non-empty span of the domain is closed), else 0,
       N_i,p(x) = (x - t_i)/(t_(i+p) - t_i) N_i,p-1(x) + (t_(i+p+1) - x)/(t_(i+p+1) - t_(i+1)) N_i+1,p-1(x),
   and, as there, x outside the domain is clamped to it; so the theorems hold for all real x. *)
Require Import Reals Lra Lia Arith.
From Etalon Require Import Sums.
Open Scope R_scope.

(* ---- knots ---- *)

(* What et_knots_valid establishes. *)
Record knots (t : nat -> R) (p n : nat) : Prop := {
  knots_mono : forall i, t i <= t (S i);
  knots_count : (p < n)%nat;
  knots_domain : t p < t n
}.

(* The first and the last p+1 knots are equal, and no more of them.  The last part is no pedantry: et_knots_clamped asks for the first only,
   and where an end knot stands p+2 times the curve does not begin (or end) at its first (or last) control point: see basis_at_left. *)
Record clamped (t : nat -> R) (p n : nat) : Prop := {
  clamped_left : t O = t p;
  clamped_right : t n = t (n + p)%nat;
  clamped_left_strict : t p < t (S p);
  clamped_right_strict : t (n - 1)%nat < t n
}.

Lemma mono_le : forall t, (forall i, t i <= t (S i)) -> forall i j, (i <= j)%nat -> t i <= t j.
Proof. intros t M i j H; induction H; [lra|]. specialize (M m); lra. Qed.

(* Knots that differ are in the order of their indices. *)
Lemma mono_lt : forall t, (forall i, t i <= t (S i)) -> forall i j, t i < t j -> (i < j)%nat.
Proof. intros t M i j H. destruct (Nat.lt_ge_cases i j); auto. assert (t j <= t i) by now apply mono_le. lra. Qed.

Section Basis.
Variable t : nat -> R.

(* ---- the textbook's recursion, from half-open spans ---- *)

Definition indicator (i : nat) (x : R) : R := if Rle_dec (t i) x then if Rlt_dec x (t (S i)) then 1 else 0 else 0.

Fixpoint N (p i : nat) (x : R) : R :=
  match p with
  | O => indicator i x
  | S q => frac (x - t i) (t (i + p)%nat - t i) * N q i x
         + frac (t (S i + p)%nat - x) (t (S i + p)%nat - t (S i)) * N q (S i) x
  end.

(* ---- the same recursion from a span s that was found before, as the code has it ---- *)

Fixpoint B (s p i : nat) (x : R) : R :=
  match p with
  | O => if Nat.eqb i s then 1 else 0
  | S q => frac (x - t i) (t (i + p)%nat - t i) * B s q i x
         + frac (t (S i + p)%nat - x) (t (S i + p)%nat - t (S i)) * B s q (S i) x
  end.

(* The last non-empty span of those before the n-th that does not begin behind x: what et_knots_span finds by bisection. *)
Fixpoint span (n : nat) (x : R) : nat :=
  match n with
  | O => O
  | S j => if Rlt_dec (t j) (t (S j)) then if Rle_dec (t j) x then j else span j x else span j x
  end.

(* What et_knots_span ensures of its result, for x in the domain. *)
Record is_span (p n : nat) (x : R) (s : nat) : Prop := {
  span_range : (p <= s < n)%nat;
  span_nonempty : t s < t (S s);
  span_inside : t s <= x <= t (S s);
  span_last : x = t (S s) -> t (S s) = t n
}.

(* N_i,p(x) of a knot vector with n control points: of all the files, this is what curves and surfaces are made of. *)
Definition basis (p n i : nat) (x : R) : R := let y := clamp (t p) (t n) x in B (span n y) p i y.

(* ---- local support: no assumption on the knots is needed ---- *)

Theorem B_support : forall s x p i, (i + p < s \/ s < i)%nat -> B s p i x = 0.
Proof.
  intros s x p; induction p; intros i H; simpl.
  - destruct (Nat.eqb_spec i s); auto; lia.
  - rewrite !IHp by lia. ring.
Qed.

Hypothesis M : forall i, t i <= t (S i).

(* Knots in the order of their indices, for lra. *)
Let le := mono_le t M.

Theorem N_support : forall p i x, ~ (t i <= x < t (i + p + 1)%nat) -> N p i x = 0.
Proof.
  induction p; intros i x H; simpl.
  - unfold indicator. replace (i + 0 + 1)%nat with (S i) in H by lia.
    destruct (Rle_dec (t i) x); auto. destruct (Rlt_dec x (t (S i))); auto. lra.
  - rewrite (IHp i), (IHp (S i)); [ring| |].
    + intros [? ?]; apply H; split; [generalize (M i); lra|].
      replace (i + S p + 1)%nat with (S i + p + 1)%nat by lia; auto.
    + intros [? ?]; apply H; split; auto.
      assert (t (i + p + 1)%nat <= t (i + S p + 1)%nat) by (apply le; lia). lra.
Qed.

(* ---- both recursions agree where the span is the textbook's ---- *)

Theorem N_is_B : forall s x, t s <= x < t (S s) -> forall p i, N p i x = B s p i x.
Proof.
  intros s x Hx p; induction p; intros i; simpl; [|now rewrite !IHp].
  unfold indicator. destruct (Nat.eqb_spec i s) as [->|Hne].
  - destruct (Rle_dec (t s) x); [|lra]. destruct (Rlt_dec x (t (S s))); lra.
  - destruct (Rle_dec (t i) x); auto. destruct (Rlt_dec x (t (S i))); auto. exfalso.
    destruct (Nat.lt_ge_cases i s).
    + assert (t (S i) <= t s) by (apply le; lia). lra.
    + assert (t (S s) <= t i) by (apply le; lia). lra.
Qed.

(* ---- the span ---- *)

Lemma span_below : forall p n x m, (m <= n)%nat -> t p < t m -> t p <= x <= t n -> (x < t m \/ t m = t n) ->
  is_span p n x (span m x).
Proof.
  intros p n x m; induction m; intros Hm Hp Hx H.
  { assert (t O <= t p) by (apply le; lia). lra. }
  assert (p < S m)%nat by (now apply (mono_lt t M)). simpl.
  assert (Hd : forall j, t p < t j -> (p < j)%nat) by (intros; now apply (mono_lt t M)).
  destruct (Rlt_dec (t m) (t (S m))); [destruct (Rle_dec (t m) x)|].
  - split; [lia|lra|lra|intros ->; lra].
  - apply IHm; try lia; lra.
  - assert (t m = t (S m)) by (generalize (M m); lra). apply IHm; try lia; try lra.
Qed.

Theorem span_correct : forall p n x, t p < t n -> t p <= x <= t n -> is_span p n x (span n x).
Proof. intros; apply span_below; auto. Qed.

Lemma span_unique : forall p n x s r, is_span p n x s -> is_span p n x r -> s = r.
Proof.
  assert (W : forall p n x s r, is_span p n x s -> is_span p n x r -> (s < r)%nat -> False).
  { intros p n x s r [] [] H. assert (t (S s) <= t r) by (apply le; lia). assert (t (S r) <= t n) by (apply le; lia).
    assert (x = t (S s)) by lra. specialize (span_last0 H2). lra. }
  intros p n x s r Hs Hr. destruct (Nat.lt_trichotomy s r) as [H|[H|H]]; auto; exfalso; eauto.
Qed.

(* ---- non-negativity ---- *)

Theorem B_nonneg : forall s x, t s <= x <= t (S s) -> forall p i, 0 <= B s p i x.
Proof.
  intros s x Hx; induction p; intros i; [simpl; destruct (Nat.eqb i s); lra|].
  cbn [B]. apply Rplus_le_le_0_compat.
  - destruct (le_lt_dec i s) as [h|h]; [destruct (le_lt_dec s (i + p)) as [h'|h']|];
      try (rewrite B_support by lia; lra).
    apply Rmult_le_pos; auto. apply frac_nonneg.
    + assert (t i <= t s) by (apply le; lia). lra.
    + assert (t i <= t (i + S p)%nat) by (apply le; lia). lra.
  - destruct (le_lt_dec (S i) s) as [h|h]; [destruct (le_lt_dec s (S i + p)) as [h'|h']|];
      try (rewrite (B_support s x p (S i)) by lia; lra).
    apply Rmult_le_pos; auto. apply frac_nonneg.
    + assert (t (S s) <= t (S i + S p)%nat) by (apply le; lia). lra.
    + assert (t (S i) <= t (S i + S p)%nat) by (apply le; lia). lra.
Qed.

(* For every real x, inside its span or not. *)
Theorem N_nonneg : forall p i x, 0 <= N p i x.
Proof.
  intros p i x. destruct (Rle_dec (t i) x) as [h1|h1]; [destruct (Rlt_dec x (t (i + p + 1)%nat)) as [h2|h2]|];
    try (rewrite N_support; lra).
  assert (E : forall m, x < t (i + m)%nat -> exists s, t s <= x < t (S s)).
  { induction m; [rewrite Nat.add_0_r; lra|]. intros H. destruct (Rlt_dec x (t (i + m)%nat)); auto.
    exists (i + m)%nat. rewrite Nat.add_succ_r in H. lra. }
  destruct (E (p + 1)%nat) as [s Hs]; [now rewrite Nat.add_assoc|].
  rewrite (N_is_B s x Hs). apply B_nonneg; lra.
Qed.

(* ---- partition of unity ---- *)

(* An identity of polynomials, so for all x: the p+1 functions that the code computes. *)
Theorem B_unity_local : forall s x, t s < t (S s) -> forall p, (p <= s)%nat -> sum (fun r => B s p (s - p + r)%nat x) (S p) = 1.
Proof.
  intros s x Hs; induction p; intros Hp.
  { simpl. replace (s - 0 + 0)%nat with s by lia. rewrite Nat.eqb_refl; lra. }
  set (b := (s - S p)%nat).
  set (f := fun r => frac (x - t (b + r)%nat) (t (b + r + S p)%nat - t (b + r)%nat) * B s p (b + r) x).
  set (g := fun r => frac (t (S (b + r) + S p)%nat - x) (t (S (b + r) + S p)%nat - t (S (b + r))) * B s p (S (b + r)) x).
  transitivity (sum f (S (S p)) + sum g (S (S p))); [rewrite <- sum_add; apply sum_ext; reflexivity|].
  (* The first of the first and the last of the last are zero; the rest pairs up. *)
  rewrite (sum_first (S p) f). change (sum g (S (S p))) with (sum g (S p) + g (S p)).
  replace (f O) with 0 by (unfold f; rewrite B_support by (unfold b; lia); ring).
  replace (g (S p)) with 0 by (unfold g; rewrite B_support by (unfold b; lia); ring).
  rewrite Rplus_0_l, Rplus_0_r, <- sum_add, <- (IHp ltac:(lia)). apply sum_ext; intros r Hr. unfold f, g.
  replace (b + S r)%nat with (s - p + r)%nat by (unfold b; lia).
  replace (S (b + r)) with (s - p + r)%nat by (unfold b; lia).
  set (i := (s - p + r)%nat).
  assert (t i <= t s) by (apply le; unfold i; lia).
  assert (t (S s) <= t (i + S p)%nat) by (apply le; unfold i; lia).
  rewrite !frac_nz by lra. field. lra.
Qed.

(* A sum over all functions is one over the p+1 that are not zero. *)
Lemma B_sum_local : forall s p n x (f : nat -> R), (p <= s < n)%nat ->
  sum (fun i => B s p i x * f i) n = sum (fun r => B s p (s - p + r)%nat x * f (s - p + r)%nat) (S p).
Proof.
  intros s p n x f H. replace n with ((s - p) + (S p + (n - 1 - s)))%nat by lia. rewrite !sum_split.
  rewrite (sum_zero (s - p)) by (intros; rewrite B_support by lia; ring).
  rewrite (sum_zero (n - 1 - s)) by (intros; rewrite B_support by lia; ring). lra.
Qed.

Theorem B_unity : forall s p n x, t s < t (S s) -> (p <= s < n)%nat -> sum (fun i => B s p i x) n = 1.
Proof.
  intros s p n x Hs H. rewrite <- (B_unity_local s x Hs p) by lia.
  rewrite (sum_ext n _ (fun i => B s p i x * 1)), B_sum_local by (auto; intros; ring).
  apply sum_ext; intros; ring.
Qed.

(* ---- the ends: where x is a knot of multiplicity p, one function is 1 and all others are 0 ---- *)

Theorem B_left_end : forall s x, t s < t (S s) -> forall p, (p <= s)%nat -> (forall k, (k < p)%nat -> t (s - k)%nat = x) ->
  forall i, B s p i x = if Nat.eqb (i + p) s then 1 else 0.
Proof.
  intros s x Hs; induction p; intros Hp Hk i; [simpl; now rewrite Nat.add_0_r|].
  cbn [B]. rewrite !IHp by (try lia; auto).
  assert (Hts : t s = x) by (rewrite <- (Hk O) by lia; f_equal; lia).
  destruct (Nat.eqb_spec (i + p) s).
  - assert (t i = x) by (replace i with (s - p)%nat by lia; apply Hk; lia).
    replace (x - t i) with 0 by lra. rewrite frac_0.
    destruct (Nat.eqb_spec (S i + p) s); [lia|]. destruct (Nat.eqb_spec (i + S p) s); [lia|]. ring.
  - destruct (Nat.eqb_spec (S i + p) s).
    + destruct (Nat.eqb_spec (i + S p) s); [|lia]. replace (S i + S p)%nat with (S s) by lia.
      assert (Hti : t (S i) = x) by (replace (S i) with (s - p)%nat by lia; apply Hk; lia).
      rewrite Hti, Rmult_0_r, Rplus_0_l, frac_nz by lra. field. lra.
    + destruct (Nat.eqb_spec (i + S p) s); [lia|]. ring.
Qed.

Theorem B_right_end : forall s x, t s < t (S s) -> forall p, (forall k, (k < p)%nat -> t (S s + k)%nat = x) ->
  forall i, B s p i x = if Nat.eqb i s then 1 else 0.
Proof.
  intros s x Hs; induction p; intros Hk i; [reflexivity|].
  cbn [B]. rewrite !IHp by auto. assert (Hts : t (S s) = x) by (rewrite <- (Hk O) by lia; f_equal; lia).
  destruct (Nat.eqb_spec i s) as [->|].
  - destruct (Nat.eqb_spec (S s) s); [lia|].
    replace (t (s + S p)%nat) with x by (replace (s + S p)%nat with (S s + p)%nat by lia; symmetry; apply Hk; lia).
    rewrite frac_nz by lra. field. lra.
  - destruct (Nat.eqb_spec (S i) s); [|ring].
    replace (t (S i + S p)%nat) with x by (replace (S i + S p)%nat with (S s + p)%nat by lia; symmetry; apply Hk; lia).
    replace (x - x) with 0 by ring. rewrite frac_0. ring.
Qed.
End Basis.

(* ---- which knots matter ---- *)

Lemma B_ext : forall t t' s p i x, (forall j, (i <= j <= i + p + 1)%nat -> t j = t' j) -> B t s p i x = B t' s p i x.
Proof.
  intros t t' s p; induction p; intros i x H; [reflexivity|].
  cbn [B]. rewrite !H by lia. rewrite (IHp i), (IHp (S i)) by (intros; apply H; lia). reflexivity.
Qed.

Lemma span_ext : forall t t' n x, (forall j, (j <= n)%nat -> t j = t' j) -> span t n x = span t' n x.
Proof. intros t t' n x; induction n; intros H; [reflexivity|]. simpl. rewrite !H, IHn by (auto; lia). reflexivity. Qed.

(* The n functions depend on the n+p+1 knots alone. *)
Theorem basis_ext : forall t t' p n i x, (p < n)%nat -> (i < n)%nat -> (forall j, (j <= n + p)%nat -> t j = t' j) ->
  basis t p n i x = basis t' p n i x.
Proof.
  intros t t' p n i x Hp Hi H. unfold basis. rewrite !H by lia.
  rewrite (span_ext t t') by (intros; apply H; lia). apply B_ext. intros; apply H; lia.
Qed.

(* ---- what is claimed of the functions of a knot vector, for all x ---- *)

Section Vector.
Variables (t : nat -> R) (p n : nat).
Hypothesis K : knots t p n.

Let M := knots_mono t p n K.
Let D := knots_domain t p n K.

Definition inside (x : R) : R := clamp (t p) (t n) x.

Lemma inside_range : forall x, t p <= inside x <= t n.
Proof. intros; apply clamp_range; lra. Qed.

Lemma inside_span : forall x, is_span t p n (inside x) (span t n (inside x)).
Proof. intros; apply span_correct; auto. apply inside_range. Qed.

(* Beyond the domain the functions have the values of its ends. *)
Lemma basis_inside : forall x i, basis t p n i (inside x) = basis t p n i x.
Proof.
  intros x i. unfold basis. fold (inside x). fold (inside (inside x)).
  assert (E : inside (inside x) = inside x) by (unfold inside at 1; apply clamp_id, inside_range). now rewrite E.
Qed.

Lemma inside_left : forall x, x <= t p -> inside x = t p.
Proof. intros; unfold inside, clamp; destruct (Rlt_dec x (t p)); [|destruct (Rlt_dec (t n) x)]; lra. Qed.

Lemma inside_right : forall x, t n <= x -> inside x = t n.
Proof. intros; unfold inside, clamp; destruct (Rlt_dec x (t p)); [|destruct (Rlt_dec (t n) x)]; lra. Qed.

(* The clauses that et_knots_span ensures of its result s, for any x, make s the span of x: so that is what the code computes with. *)
Theorem span_ensured : forall x s, (p <= s < n)%nat -> t s < t (S s) -> (t p <= x < t n -> t s <= x < t (S s)) ->
  (t n <= x -> t (S s) = t n) -> (x < t p -> t s = t p) -> is_span t p n (inside x) s.
Proof.
  intros x s Hr Hn Hi HR HL. unfold inside, clamp. destruct (Rlt_dec x (t p)); [|destruct (Rlt_dec (t n) x)].
  - specialize (HL r). split; auto; lra.
  - specialize (HR ltac:(lra)). split; auto; lra.
  - destruct (Req_dec x (t n)) as [->|]; [specialize (HR ltac:(lra))|specialize (Hi ltac:(lra))]; split; auto; lra.
Qed.

(* A span with the stated property is the one that is meant. *)
Lemma basis_at : forall s x i, is_span t p n (inside x) s -> basis t p n i x = B t s p i (inside x).
Proof.
  intros s x i H. unfold basis. fold (inside x). now rewrite (span_unique t M p n (inside x) _ s (inside_span x) H).
Qed.

(* The textbook's functions, on the half-open domain. *)
Theorem basis_is_N : forall x i, t p <= x < t n -> basis t p n i x = N t p i x.
Proof.
  intros x i Hx. assert (E : inside x = x) by (unfold inside; apply clamp_id; lra).
  destruct (inside_span x) as [Hr Hn Hi Hl]. rewrite E in *. unfold basis. fold (inside x). rewrite E.
  symmetry. apply N_is_B; auto. destruct Hi as [H1 H2]. split; auto. destruct H2 as [|H2]; auto.
  specialize (Hl H2). lra.
Qed.

Theorem basis_nonneg : forall x i, 0 <= basis t p n i x.
Proof. intros x i. destruct (inside_span x). now apply B_nonneg. Qed.

Theorem basis_support : forall x s i, is_span t p n (inside x) s -> (i + p < s \/ s < i)%nat -> basis t p n i x = 0.
Proof. intros x s i H Hi. rewrite (basis_at s) by auto. now apply B_support. Qed.

Theorem basis_unity : forall x, sum (fun i => basis t p n i x) n = 1.
Proof. intros x. destruct (inside_span x). now apply B_unity. Qed.

Theorem basis_le_1 : forall x i, (i < n)%nat -> basis t p n i x <= 1.
Proof.
  intros x i Hi. rewrite <- (basis_unity x).
  apply Rle_trans with (sum (fun k => if Nat.eqb k i then basis t p n k x else 0) n).
  - rewrite (sum_single n _ i Hi); [rewrite Nat.eqb_refl; lra|].
    intros k _ Hk; destruct (Nat.eqb_spec k i); auto; contradiction.
  - apply sum_le; intros k _. destruct (Nat.eqb k i); [lra|apply basis_nonneg].
Qed.

(* At the left end of the domain the one function that is 1 is number s - p, s the span there: number 0 if and only if the knot at the end
   stands no more than p+1 times. *)
Theorem basis_at_left : t O = t p -> forall s, is_span t p n (t p) s ->
  forall i, basis t p n i (t p) = if Nat.eqb (i + p) s then 1 else 0.
Proof.
  intros HL s Hs i. assert (E : inside (t p) = t p) by (unfold inside; apply clamp_id; lra).
  rewrite (basis_at s), E by (rewrite E; auto). destruct Hs as [Hr Hn Hi _].
  apply B_left_end; auto; try lia. intros k Hk.
  assert (t O <= t (s - k)%nat) by (apply mono_le; auto; lia).
  assert (t (s - k)%nat <= t s) by (apply mono_le; auto; lia). lra.
Qed.

Theorem basis_at_right : t n = t (n + p)%nat -> forall s, is_span t p n (t n) s ->
  forall i, basis t p n i (t n) = if Nat.eqb i s then 1 else 0.
Proof.
  intros HR s Hs i. assert (E : inside (t n) = t n) by (unfold inside; apply clamp_id; lra).
  rewrite (basis_at s), E by (rewrite E; auto). destruct Hs as [Hr Hn Hi _].
  apply B_right_end; auto. intros k Hk.
  assert (t (S s) <= t (S s + k)%nat) by (apply mono_le; auto; lia).
  assert (t (S s + k)%nat <= t (n + p)%nat) by (apply mono_le; auto; lia). lra.
Qed.

Hypothesis C : clamped t p n.

Theorem basis_first : forall i, basis t p n i (t p) = if Nat.eqb i 0 then 1 else 0.
Proof.
  intros i. destruct C as [HL _ HS _]. rewrite (basis_at_left HL p).
  - destruct (Nat.eqb_spec (i + p) p), (Nat.eqb_spec i 0); auto; lia.
  - assert (p < n)%nat by apply K. split; [lia|auto|lra|lra].
Qed.

Theorem basis_last : forall i, basis t p n i (t n) = if Nat.eqb i (n - 1) then 1 else 0.
Proof.
  intros i. destruct C as [_ HR _ HS]. assert (p < n)%nat by apply K.
  apply (basis_at_right HR). split; replace (S (n - 1)) with n by lia; auto; try lia; lra.
Qed.
End Vector.
