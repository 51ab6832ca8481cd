(* Insertion: Boehm's knot insertion leaves the curve as it is, for any degree, any non-decreasing knots and any x of the domain, be it a knot
   already or not.

   The code (insert_once in src/spline/curve_net.c) finds the last knot t_k that does not lie behind x and its multiplicity s <= p, puts x
   between t_k and t_(k+1), and replaces the control points by
       Q_i = P_i                          i <= k-p,
       Q_i = a P_i + b P_(i-1)            k-p < i <= k-s,   a = (x - t_i)/(t_(i+p) - t_i),   b = (t_(i+p) - x)/(t_(i+p) - t_i),
       Q_i = P_(i-1)                      k-s < i;
   `times` insertions do it so often, with k and s one greater each time. *)
Require Import Reals Lra Lia Arith.
From Etalon Require Import Sums Space Basis Curve.
Open Scope R_scope.

(* ---- one knot more ---- *)

Section Functions.
Variables (t : nat -> R) (k : nat) (x : R).
Hypothesis M : forall i, t i <= t (S i).
Hypothesis Hx : t k <= x < t (S k).

(* The knots with x among them. *)
Definition insert_knot (i : nat) : R := if le_lt_dec i k then t i else if Nat.eq_dec i (S k) then x else t (i - 1)%nat.

Lemma knot_before : forall i, (i <= k)%nat -> insert_knot i = t i.
Proof. intros; unfold insert_knot; destruct (le_lt_dec i k); auto; lia. Qed.

Lemma knot_new : insert_knot (S k) = x.
Proof. unfold insert_knot; destruct (le_lt_dec (S k) k); [lia|]. destruct (Nat.eq_dec (S k) (S k)); auto; lia. Qed.

Lemma knot_after : forall i, (k < i)%nat -> insert_knot (S i) = t i.
Proof.
  intros; unfold insert_knot; destruct (le_lt_dec (S i) k); [lia|]. destruct (Nat.eq_dec (S i) (S k)); [lia|].
  f_equal; lia.
Qed.

Lemma insert_mono : forall i, insert_knot i <= insert_knot (S i).
Proof.
  intros i. destruct (lt_eq_lt_dec i k) as [[h|h]|h].
  - rewrite !knot_before by lia. apply M.
  - subst. rewrite knot_before, knot_new by lia. lra.
  - rewrite knot_after by lia. destruct (Nat.eq_dec i (S k)) as [->|]; [rewrite knot_new; lra|].
    destruct i; [lia|]. rewrite knot_after by lia. apply M.
Qed.

(* The share of the i-th function of degree p over the new knots in the i-th over the old ones. *)
Definition share (p i : nat) : R :=
  if le_lt_dec (i + p) k then 1 else if Rlt_dec (t i) x then (x - t i) / (t (i + p)%nat - t i) else 0.

Let le := mono_le t M.

(* Decides which of its three values a share has. *)
Ltac shares := unfold share; repeat match goal with
  | |- context [le_lt_dec ?a ?b] => destruct (le_lt_dec a b); try lia
  | |- context [Rlt_dec ?a ?b] => destruct (Rlt_dec a b); try lra
  end.

(* The recursion's coefficients fit together: the function i, *)
Lemma fit_first : forall q i u, insert_knot i < insert_knot (i + S q) ->
  frac (u - t i) (t (i + S q)%nat - t i) * share q i =
  share (S q) i * frac (u - insert_knot i) (insert_knot (i + S q) - insert_knot i).
Proof.
  intros q i u H. destruct (lt_eq_lt_dec (i + S q) (S k)) as [[h|h]|h].
  - rewrite !knot_before in * by lia. shares; ring.
  - rewrite h, knot_new, (knot_before i) in * by lia.
    shares; rewrite h, !frac_nz by lra; field; lra.
  - replace (i + S q)%nat with (S (i + q)) in * by lia. rewrite knot_after in * by lia.
    assert (t (S k) <= t (i + q)%nat) by (apply le; lia).
    assert (t (i + q)%nat <= t (S (i + q))) by (apply le; lia).
    destruct (le_lt_dec i k).
    + rewrite knot_before in * by lia. replace (S (i + q)) with (i + S q)%nat in * by lia.
      shares; try ring; rewrite !frac_nz by lra; field; lra.
    + assert (t (S k) <= t i) by (apply le; lia). shares; ring.
Qed.

(* the function i + 2, here j + 1, *)
Lemma fit_last : forall q j u, insert_knot (S j) < insert_knot (S j + S q) ->
  frac (t (j + S q)%nat - u) (t (j + S q)%nat - t j) * (1 - share q (S j)) =
  (1 - share (S q) j) * frac (insert_knot (S j + S q) - u) (insert_knot (S j + S q) - insert_knot (S j)).
Proof.
  intros q j u H. destruct (le_lt_dec (j + S q) k) as [h|h]; [shares; ring|].
  change (S j + S q)%nat with (S (j + S q)) in *. rewrite (knot_after (j + S q)) in * by lia.
  assert (t (S k) <= t (j + S q)%nat) by (apply le; lia).
  destruct (lt_eq_lt_dec j k) as [[h'|h']|h'].
  - assert (t j <= t (S j)) by apply M. assert (t (S j) <= t k) by (apply le; lia).
    rewrite knot_before in * by lia. replace (S j + q)%nat with (j + S q)%nat by lia.
    shares; rewrite ?frac_nz by lra.
    all: replace (S j + q)%nat with (j + S q)%nat by lia.
    all: try (field; lra).
    all: try (replace (t (S j)) with x by lra; field; lra).
    all: replace (t j) with x by lra; replace (t (S j)) with x by lra; field; lra.
  - subst j. rewrite knot_new in *. shares; rewrite ?frac_nz by lra; [field; lra|].
    replace (t k) with x by lra. field; lra.
  - rewrite knot_after in * by lia. assert (t (S k) <= t j) by (apply le; lia).
    assert (t j <= t (S j)) by apply M. shares; ring.
Qed.

(* and the function i + 1 between, to which both parts contribute. *)
Lemma fit_middle : forall q i u, insert_knot (S i) < insert_knot (S i + S q) ->
  frac (u - t i) (t (i + S q)%nat - t i) * (1 - share q (S i)) +
  frac (t (S i + S q)%nat - u) (t (S i + S q)%nat - t (S i)) * share q (S i) =
  share (S q) i * frac (insert_knot (S i + S q) - u) (insert_knot (S i + S q) - insert_knot (S i)) +
  (1 - share (S q) (S i)) * frac (u - insert_knot (S i)) (insert_knot (S i + S q) - insert_knot (S i)).
Proof.
  intros q i u H. assert (t i <= t (S i)) by apply M.
  destruct (lt_eq_lt_dec (S i + S q) (S k)) as [[h|h]|h].
  - rewrite !knot_before in * by lia. shares; ring.
  - rewrite h, knot_new, (knot_before (S i)) in * by lia. shares.
    all: rewrite Rminus_eq_0, Rmult_0_r, Rplus_0_l, h, !frac_nz by lra; field; lra.
  - change (S i + S q)%nat with (S (i + S q)) in *. rewrite (knot_after (i + S q)) in * by lia.
    assert (t (S k) <= t (i + S q)%nat) by (apply le; lia).
    assert (t (i + S q)%nat <= t (S (i + S q))) by apply M.
    assert (E : (S i + q = i + S q)%nat) by lia. assert (E' : (S i + S q = S (i + S q))%nat) by lia.
    destruct (lt_eq_lt_dec i k) as [[h'|h']|h'].
    + assert (t (S i) <= t k) by (apply le; lia). rewrite knot_before in * by lia.
      shares; rewrite ?E, ?E', ?frac_nz by lra.
      all: try (field; lra).
      * replace (t (S i)) with x by lra. field. lra.
      * replace (t (S i)) with x by lra. replace (t i) with x by lra. field. lra.
    + subst i. rewrite knot_new in *. shares; rewrite Rmult_0_r, Rplus_0_r, ?frac_nz by lra; [field; lra|].
      replace (t k) with x by lra. field. lra.
    + rewrite knot_after in * by lia. assert (t (S k) <= t i) by (apply le; lia).
      shares; ring.
Qed.

(* Each old function is a sum of two neighbours among the new ones.  s and s' are the spans in the old and the new knots: *)
Definition same_place (s s' : nat) : Prop :=
  insert_knot s' < insert_knot (S s') /\
  ((s < k)%nat /\ s' = s \/ s = k /\ (s' = k \/ s' = S k) \/ (k < s)%nat /\ s' = S s).

Theorem B_insert : forall s s' u, same_place s s' -> forall p i,
  B t s p i u = share p i * B insert_knot s' p i u + (1 - share p (S i)) * B insert_knot s' p (S i) u.
Proof.
  intros s s' u [Hs H] p. set (t' := insert_knot).
  assert (L := mono_le t' insert_mono).
  induction p; intros i.
  - cbn [B]. unfold share.
    destruct (Nat.eqb_spec i s), (Nat.eqb_spec i s'), (Nat.eqb_spec (S i) s'), (le_lt_dec (i + 0) k), (le_lt_dec (S i + 0) k);
      try lia; try ring.
    all: try (assert (x < t i) by (assert (t (S k) <= t i) by (apply le; lia); lra)).
    all: try (assert (x < t (S i)) by (assert (t (S k) <= t (S i)) by (apply le; lia); lra)).
    all: repeat match goal with |- context [Rlt_dec ?a ?b] => destruct (Rlt_dec a b); try lra end.
  - (* A function that is not zero at the span has a support of positive length. *)
    assert (V : forall j c c', (t' j < t' (j + S p)%nat -> c = c') -> c * B t' s' p j u = c' * B t' s' p j u).
    { intros j c c' Hc. destruct (le_lt_dec j s'); [destruct (le_lt_dec s' (j + p))|];
        try (rewrite B_support by lia; ring).
      rewrite Hc; auto. assert (t' j <= t' s') by (apply L; lia).
      assert (t' (S s') <= t' (j + S p)%nat) by (apply L; lia). unfold t' in *; lra. }
    cbn [B]. rewrite (IHp i), (IHp (S i)).
    assert (F := V i _ _ (fit_first p i u)).
    assert (G := V (S i) _ _ (fit_middle p i u)).
    assert (E := V (S (S i)) _ _ (fit_last p (S i) u)).
    fold t' in F, G, E. lra.
Qed.
End Functions.

(* ---- the curve ---- *)

(* What the code asks for: x in the domain, t_k the last knot that does not lie behind x, s its multiplicity, s <= p. *)
Record insertable (t : nat -> R) (p n : nat) (x : R) (k s : nat) : Prop := {
  insert_domain : t p <= x <= t n;
  insert_last : t k <= x < t (S k);
  insert_below : forall i, (i <= k - s)%nat -> t i < x;
  insert_equal : forall i, (k - s < i <= k)%nat -> t i = x;
  insert_degree : (s <= p)%nat
}.

(* How many of the first m knots equal x: et_knots_multiplicity. *)
Fixpoint multiplicity (t : nat -> R) (m : nat) (x : R) : nat :=
  match m with O => O | S j => if Req_EM_T (t j) x then S (multiplicity t j x) else multiplicity t j x end.

Lemma multiplicity_none : forall t m x, (forall i, (i < m)%nat -> t i <> x) -> multiplicity t m x = O.
Proof.
  induction m; intros x H; simpl; auto. destruct (Req_EM_T (t m) x) as [E|]; [elim (H m); auto|]. apply IHm. auto.
Qed.

(* The knots that equal x are the last of those that do not lie behind it. *)
Lemma multiplicity_last : forall t, (forall i, t i <= t (S i)) -> forall k x, t k <= x ->
  forall i, (i <= k)%nat -> (t i < x <-> (i + multiplicity t (S k) x <= k)%nat).
Proof.
  intros t M k x. assert (le := mono_le t M). induction k; intros H i Hi.
  - replace i with O by lia. simpl. destruct (Req_EM_T (t O) x); split; intros; try lia; lra.
  - change (multiplicity t (S (S k)) x) with (if Req_EM_T (t (S k)) x then S (multiplicity t (S k) x) else multiplicity t (S k) x).
    assert (t k <= t (S k)) by apply M. destruct (Req_EM_T (t (S k)) x) as [E|].
    + destruct (Nat.eq_dec i (S k)) as [->|]; [split; intros; [lra|lia]|].
      specialize (IHk ltac:(lra) i ltac:(lia)). rewrite IHk. lia.
    + rewrite multiplicity_none.
      * split; intros; [lia|]. assert (t i <= t (S k)) by (apply le; lia). lra.
      * intros j Hj. assert (t j <= t (S k)) by (apply le; lia). lra.
Qed.

(* So what the code looks up, and tests, is what is asked for. *)
Theorem insertable_found : forall t p n x k, knots t p n -> t p <= x <= t n -> t k <= x < t (S k) ->
  (multiplicity t (S k) x <= p)%nat -> insertable t p n x k (multiplicity t (S k) x).
Proof.
  intros t p n x k K D L H. assert (M := knots_mono t p n K). assert (le := mono_le t M).
  assert (Q := multiplicity_last t M k x (proj1 L)). set (s := multiplicity t (S k) x) in *.
  assert (p <= k)%nat. { destruct (le_lt_dec p k); auto. assert (t (S k) <= t p) by (apply le; lia). lra. }
  split; auto.
  - intros i Hi. apply Q; lia.
  - intros i Hi. assert (t i <= t k) by (apply le; lia). specialize (Q i ltac:(lia)).
    destruct (Rlt_dec (t i) x) as [h|]; [|lra]. apply Q in h. lia.
Qed.

(* The code's formula, for numbers: a coordinate, one of the homogeneous coordinates, or a weight. *)
Definition insert1 (t : nat -> R) (p : nat) (x : R) (k s : nat) (f : nat -> R) (i : nat) : R :=
  if le_lt_dec (i + p) k then f i
  else if le_lt_dec i (k - s) then (x - t i) / (t (i + p)%nat - t i) * f i + (t (i + p)%nat - x) / (t (i + p)%nat - t i) * f (i - 1)%nat
  else f (i - 1)%nat.

(* The same, for points. *)
Definition insert_point (t : nat -> R) (p : nat) (x : R) (k s : nat) (P : nat -> vec3) (i : nat) : vec3 :=
  if le_lt_dec (i + p) k then P i
  else if le_lt_dec i (k - s) then
    let a := (x - t i) / (t (i + p)%nat - t i) in let b := (t (i + p)%nat - x) / (t (i + p)%nat - t i) in
    plus (times a (P i)) (times b (P (i - 1)%nat))
  else P (i - 1)%nat.

Section Insertion.
Variables (t : nat -> R) (p n : nat) (x : R) (k s : nat).
Hypothesis K : knots t p n.
Hypothesis I : insertable t p n x k s.

Let M := knots_mono t p n K.
Let le := mono_le t M.
Let t' := insert_knot t k x.

Lemma place : (p <= k < n + p)%nat.
Proof.
  destruct I as [D L W E G]. assert (p < n)%nat by apply K. split.
  - destruct (le_lt_dec p k); auto. assert (t (S k) <= t p) by (apply le; lia). lra.
  - destruct (le_lt_dec (n + p) k); auto. assert (t n <= t (k - s)%nat) by (apply le; lia).
    specialize (W (k - s)%nat ltac:(lia)). lra.
Qed.

(* The code's a is the share, and its b = 1 - a; a is from 0 to 1. *)
Lemma share_range : forall i, 0 <= share t k x p i <= 1.
Proof.
  intros i. unfold share. destruct (le_lt_dec (i + p) k); [lra|]. destruct (Rlt_dec (t i) x); [|lra].
  assert (t (S k) <= t (i + p)%nat) by (apply le; lia). assert (x < t (i + p)%nat) by (destruct I; lra).
  split; [apply Rlt_le, Rdiv_lt_0_compat; lra|].
  apply Rmult_le_reg_r with (t (i + p)%nat - t i); [lra|].
  unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

Lemma insert1_share : forall f i,
  insert1 t p x k s f i = share t k x p i * f i + (1 - share t k x p i) * f (i - 1)%nat.
Proof.
  intros f i. unfold insert1, share. destruct (le_lt_dec (i + p) k); [ring|]. destruct I as [D L W E G].
  assert (t (S k) <= t (i + p)%nat) by (apply le; lia).
  destruct (le_lt_dec i (k - s)).
  - specialize (W i l0). destruct (Rlt_dec (t i) x); [|lra]. field. lra.
  - destruct (Rlt_dec (t i) x); [|ring]. exfalso. destruct (le_lt_dec i k).
    + rewrite (E i) in * by lia. lra.
    + assert (t (S k) <= t i) by (apply le; lia). lra.
Qed.

Lemma insert_point_coordinates : forall P i,
  X (insert_point t p x k s P i) = insert1 t p x k s (fun j => X (P j)) i /\
  Y (insert_point t p x k s P i) = insert1 t p x k s (fun j => Y (P j)) i /\
  Z (insert_point t p x k s P i) = insert1 t p x k s (fun j => Z (P j)) i.
Proof.
  intros. unfold insert_point, insert1. destruct (le_lt_dec (i + p) k); [auto|]. destruct (le_lt_dec i (k - s)); auto.
Qed.

(* The domain is the same, the new knots are knots, *)
Lemma domain_kept : t' p = t p /\ t' (S n) = t n.
Proof.
  destruct place as [H1 H2]. unfold t'. split; [now apply knot_before|].
  destruct I as [D L W E G]. destruct (lt_eq_lt_dec k n) as [[h|h]|h].
  - now apply knot_after.
  - subst k. rewrite knot_new. lra.
  - rewrite knot_before by lia.
    assert (t n <= t (S n)) by apply M. assert (t (S n) <= t k) by (apply le; lia). lra.
Qed.

Theorem insert_knots : knots t' p (S n).
Proof.
  destruct domain_kept as [E1 E2]. destruct K as [M' Kc Kd]. destruct I as [D L W E G]. split; [|lia|lra].
  intros i. now apply insert_mono.
Qed.

(* and a parameter's spans in both are in the same place. *)
Lemma spans_fit : forall u, exists r r', is_span t p n u r /\ is_span t' p (S n) u r' /\ same_place t k x r r' \/ ~ (t p <= u <= t n).
Proof.
  intros u. destruct (Rle_dec (t p) u) as [h1|h1]; [destruct (Rle_dec u (t n)) as [h2|h2]|];
    try (exists O, O; right; lra).
  assert (D := knots_domain t p n K). assert (H := span_correct t M p n u D (conj h1 h2)). remember (span t n u) as r eqn:Er; clear Er.
  destruct domain_kept as [E1 E2]. destruct place as [P1 P2].
  assert (Q : forall i, t' i <= t' (S i)) by (apply insert_knots).
  assert (B0 := knot_before t k x). assert (A0 := knot_after t k x). assert (N0 := knot_new t k x). fold t' in B0, A0, N0.
  assert (L := insert_last _ _ _ _ _ _ I).
  destruct H as [Hr Hn Hi Hl]. destruct (lt_eq_lt_dec r k) as [[h|h]|h].
  - exists r, r. left. split; [now split|].
    assert (F : t' r = t r) by (apply B0; lia). assert (F' : t' (S r) = t (S r)) by (apply B0; lia).
    split; [split; [lia|lra|lra|intros ->; rewrite F', E2; apply Hl; auto]|]. split; [fold t'; lra|lia].
  - assert (F : t' k = t k) by (apply B0; lia). assert (F' : t' (S (S k)) = t (S k)) by (apply A0; lia). rewrite h in *.
    exists k. destruct (Rlt_dec u x).
    + exists k. left. split; [now split|]. split; [split; [lia|lra|lra|intros; lra]|]. split; [fold t'; lra|lia].
    + exists (S k). left. split; [now split|].
      split; [split; [lia|lra|lra|rewrite F', E2; auto]|]. split; [fold t'; lra|lia].
  - exists r, (S r). left. split; [now split|].
    assert (F : t' (S (S r)) = t (S r)) by (apply A0; lia).
    assert (F' : t' (S r) = t r) by (apply A0; lia).
    split; [split; [lia|lra|lra|rewrite F, E2; auto]|]. split; [fold t'; lra|lia].
Qed.

(* The functions of both knot vectors at the same parameter. *)
Lemma basis_insert : forall u i, basis t p n i u =
  share t k x p i * basis t' p (S n) i u + (1 - share t k x p (S i)) * basis t' p (S n) (S i) u.
Proof.
  intros u i. destruct domain_kept as [E1 E2].
  assert (Hin := inside_range t p n K u).
  destruct (spans_fit (inside t p n u)) as (r & r' & [(H & H' & HS)|H]); [|contradiction].
  assert (E : inside t' p (S n) u = inside t p n u) by (unfold inside; now rewrite E1, E2).
  rewrite (basis_at t p n K r u i H).
  rewrite !(basis_at t' p (S n) insert_knots r') by now rewrite E. rewrite E.
  apply B_insert; auto. now destruct I.
Qed.

(* The values are the same, for whatever is controlled by numbers, *)
Theorem curve1_insert : forall f u, curve1 t' p (S n) (insert1 t p x k s f) u = curve1 t p n f u.
Proof.
  intros f u. unfold curve1. destruct place as [P1 P2]. assert (p < n)%nat by apply K.
  set (a := share t k x p). set (b := fun i => basis t' p (S n) i u).
  transitivity (sum (fun i => b i * (a i * f i)) (S n) + sum (fun i => b i * ((1 - a i) * f (i - 1)%nat)) (S n)).
  { rewrite <- sum_add. apply sum_ext; intros i _. rewrite insert1_share. unfold a, b. ring. }
  (* The last of the first, share 0, and the first of the last, share 1, are zero. *)
  rewrite (sum_first n (fun i => b i * ((1 - a i) * f (i - 1)%nat))). simpl sum at 1.
  assert (A0 : a O = 1) by (unfold a, share; destruct (le_lt_dec (0 + p) k); [auto|lia]).
  assert (An : a n = 0).
  { unfold a, share. destruct (le_lt_dec (n + p) k); [lia|]. destruct I as [D _ _ _ _].
    destruct (Rlt_dec (t n) x); lra. }
  rewrite A0, An, Rmult_0_l, !Rmult_0_r, Rplus_0_r.
  replace (b O * ((1 - 1) * f (0 - 1)%nat)) with 0 by ring.
  rewrite Rplus_0_l, <- sum_add. apply sum_ext; intros i Hi.
  rewrite basis_insert. fold a. fold (b i). fold (b (S i)). replace (S i - 1)%nat with i by lia. ring.
Qed.

(* and the curve is the same. *)
Theorem curve_insert : forall P u, curve t' p (S n) (insert_point t p x k s P) u = curve t p n P u.
Proof.
  intros P u. unfold curve, comb. apply vec_ext; cbn [X Y Z].
  - transitivity (curve1 t' p (S n) (insert1 t p x k s (fun j => X (P j))) u); [|apply curve1_insert].
    unfold curve1. apply sum_ext; intros i _. now destruct (insert_point_coordinates P i) as (-> & _ & _).
  - transitivity (curve1 t' p (S n) (insert1 t p x k s (fun j => Y (P j))) u); [|apply curve1_insert].
    unfold curve1. apply sum_ext; intros i _. now destruct (insert_point_coordinates P i) as (_ & -> & _).
  - transitivity (curve1 t' p (S n) (insert1 t p x k s (fun j => Z (P j))) u); [|apply curve1_insert].
    unfold curve1. apply sum_ext; intros i _. now destruct (insert_point_coordinates P i) as (_ & _ & ->).
Qed.

(* The new points lie between neighbours of the old ones: a new weight is positive, as the old ones are. *)
Theorem insert1_pos : forall w, (forall i, (i < n)%nat -> 0 < w i) -> forall i, (i < S n)%nat -> 0 < insert1 t p x k s w i.
Proof.
  intros w Hw i Hi. rewrite insert1_share. assert (R := share_range i).
  destruct place as [P1 P2]. assert (p < n)%nat by apply K. assert (Wp : 0 < w (i - 1)%nat) by (apply Hw; lia).
  destruct (Nat.eq_dec i n) as [->|].
  - assert (E : share t k x p n = 0).
    { unfold share. destruct (le_lt_dec (n + p) k); [lia|]. destruct I as [D _ _ _ _]. destruct (Rlt_dec (t n) x); lra. }
    rewrite E. lra.
  - assert (Wi : 0 < w i) by (apply Hw; lia). set (a := share t k x p i) in *.
    destruct (Rlt_dec 0 a).
    + assert (0 < a * w i) by now apply Rmult_lt_0_compat.
      assert (0 <= (1 - a) * w (i - 1)%nat) by (apply Rmult_le_pos; lra). lra.
    + replace a with 0 by lra. lra.
Qed.

(* Once more: the next insertion of the same knot, if its multiplicity allows. *)
Theorem insert_again : (s < p)%nat -> insertable t' p (S n) x (S k) (S s).
Proof.
  intros Hs. destruct domain_kept as [E1 E2]. destruct I as [D L W E G]. unfold t' in *. split; try lia.
  - lra.
  - rewrite knot_new, knot_after by lia. lra.
  - intros i Hi. rewrite knot_before by lia. apply W. lia.
  - intros i Hi. destruct (Nat.eq_dec i (S k)) as [->|]; [apply knot_new|]. rewrite knot_before by lia. apply E. lia.
Qed.
End Insertion.

(* ---- many times: what et_curve_insert does ---- *)

Fixpoint insert_knot_times (m : nat) (t : nat -> R) (x : R) (k : nat) : nat -> R :=
  match m with O => t | S m' => insert_knot_times m' (insert_knot t k x) x (S k) end.

Fixpoint insert_times (m : nat) (t : nat -> R) (p : nat) (x : R) (k s : nat) (P : nat -> vec3) : nat -> vec3 :=
  match m with
  | O => P
  | S m' => insert_times m' (insert_knot t k x) p x (S k) (S s) (insert_point t p x k s P)
  end.

Fixpoint insert1_times (m : nat) (t : nat -> R) (p : nat) (x : R) (k s : nat) (f : nat -> R) : nat -> R :=
  match m with
  | O => f
  | S m' => insert1_times m' (insert_knot t k x) p x (S k) (S s) (insert1 t p x k s f)
  end.

(* As often as the multiplicity stays within p + 1. *)
Theorem curve_insert_times : forall m t p n x k s P u, knots t p n -> insertable t p n x k s -> (m + s <= p + 1)%nat ->
  curve (insert_knot_times m t x k) p (n + m) (insert_times m t p x k s P) u = curve t p n P u.
Proof.
  induction m; intros t p n x k s P u K I H; simpl; [now rewrite Nat.add_0_r|].
  replace (n + S m)%nat with (S n + m)%nat by lia. rewrite <- (curve_insert t p n x k s K I P u).
  destruct m; [simpl; now rewrite Nat.add_0_r|].
  apply IHm; [now apply (insert_knots t p n x k s)|apply (insert_again t p n x k s); auto; lia|lia].
Qed.

Theorem curve1_insert_times : forall m t p n x k s f u, knots t p n -> insertable t p n x k s -> (m + s <= p + 1)%nat ->
  curve1 (insert_knot_times m t x k) p (n + m) (insert1_times m t p x k s f) u = curve1 t p n f u.
Proof.
  induction m; intros t p n x k s f u K I H; simpl; [now rewrite Nat.add_0_r|].
  replace (n + S m)%nat with (S n + m)%nat by lia. rewrite <- (curve1_insert t p n x k s K I f u).
  destruct m; [simpl; now rewrite Nat.add_0_r|].
  apply IHm; [now apply (insert_knots t p n x k s)|apply (insert_again t p n x k s); auto; lia|lia].
Qed.
