(* Rational: rational (NURBS) curves and surfaces with positive weights,
       C(x) = sum_i N_i,p(x) w_i P_i / sum_i N_i,p(x) w_i,   R_i(x) = N_i,p(x) w_i / sum_j N_j,p(x) w_j,
   and likewise with two indices.  As the code does: first the sums of w P and of w, last the division. *)
Require Import Reals Lra Lia Arith.
From Etalon Require Import Sums Space Basis Curve Insertion Surface.
Open Scope R_scope.

(* ---- definitions ---- *)

Definition lifted (w : nat -> R) (P : nat -> vec3) (i : nat) : vec3 := times (w i) (P i).

Definition rcurve (t : nat -> R) (p n : nat) (w : nat -> R) (P : nat -> vec3) (x : R) : vec3 :=
  over (curve t p n (lifted w P) x) (curve1 t p n w x).

Definition rbasis (t : nat -> R) (p n : nat) (w : nat -> R) (i : nat) (x : R) : R := basis t p n i x * w i / curve1 t p n w x.

Definition lifted2 (w : nat -> nat -> R) (P : nat -> nat -> vec3) (i j : nat) : vec3 := times (w i j) (P i j).

Definition rsurface (t r : nat -> R) (p q m n : nat) (w : nat -> nat -> R) (P : nat -> nat -> vec3) (u v : R) : vec3 :=
  over (surface t r p q m n (lifted2 w P) u v) (surface1 t r p q m n w u v).

Definition rbasis2 (t r : nat -> R) (p q m n : nat) (w : nat -> nat -> R) (i j : nat) (u v : R) : R :=
  basis t p m i u * basis r q n j v * w i j / surface1 t r p q m n w u v.

Definition positive (n : nat) (w : nat -> R) : Prop := forall i, (i < n)%nat -> 0 < w i.
Definition positive2 (m n : nat) (w : nat -> nat -> R) : Prop := forall i j, (i < m)%nat -> (j < n)%nat -> 0 < w i j.

(* w P / w = P *)
Lemma over_times : forall a P, a <> 0 -> over (times a P) a = P.
Proof. intros; apply vec_ext; simpl; field; auto. Qed.

(* ---- curves ---- *)

Section Curve.
Variables (t : nat -> R) (p n : nat) (w : nat -> R).
Hypothesis K : knots t p n.
Hypothesis W : positive n w.

(* The denominator is positive: no division by zero. *)
Theorem weight_pos : forall x, 0 < curve1 t p n w x.
Proof.
  intros x. unfold curve1. apply sum_weighted_pos; auto.
  - intros; now apply basis_nonneg.
  - rewrite basis_unity by auto. lra.
Qed.

Theorem rbasis_nonneg : forall i x, (i < n)%nat -> 0 <= rbasis t p n w i x.
Proof.
  intros i x Hi. apply Rmult_le_pos; [apply Rmult_le_pos; [now apply basis_nonneg|apply Rlt_le; auto]|].
  apply Rlt_le, Rinv_0_lt_compat, weight_pos.
Qed.

Theorem rbasis_unity : forall x, sum (fun i => rbasis t p n w i x) n = 1.
Proof.
  intros x. assert (H := weight_pos x).
  rewrite (sum_ext n _ (fun i => / curve1 t p n w x * (basis t p n i x * w i))) by (intros; unfold rbasis, Rdiv; ring).
  rewrite sum_scal. fold (curve1 t p n w x). field. lra.
Qed.

(* The curve is the combination of its control points with the R_i; *)
Theorem rcurve_comb : forall P x, rcurve t p n w P x = comb n (fun i => rbasis t p n w i x) P.
Proof.
  intros P x. assert (H := weight_pos x). unfold rcurve, curve, lifted, comb, over, times, rbasis.
  apply vec_ext; cbn [X Y Z]; unfold Rdiv; rewrite Rmult_comm, <- sum_scal; apply sum_ext; intros; ring.
Qed.

(* so the affine map of the curve is the curve of the mapped points, *)
Theorem rcurve_affine : forall a b c o P x, affine a b c o (rcurve t p n w P x) = rcurve t p n w (fun i => affine a b c o (P i)) x.
Proof. intros. rewrite !rcurve_comb. apply comb_affine, rbasis_unity. Qed.

(* and it lies in their convex hull. *)
Theorem rcurve_hull : forall P x, in_hull n P (rcurve t p n w P x).
Proof.
  intros P x. rewrite rcurve_comb. exists (fun i => rbasis t p n w i x). repeat split; auto.
  - intros; now apply rbasis_nonneg.
  - apply rbasis_unity.
Qed.

Lemma curve1_first : clamped t p n -> forall f, curve1 t p n f (t p) = f O.
Proof.
  intros C f. assert (p < n)%nat by apply K. unfold curve1. rewrite (sum_single n _ O); [|lia|].
  - rewrite basis_first by auto. simpl; ring.
  - intros k _ Hk. rewrite basis_first by auto. destruct (Nat.eqb_spec k 0); [contradiction|ring].
Qed.

Lemma curve1_last : clamped t p n -> forall f, curve1 t p n f (t n) = f (n - 1)%nat.
Proof.
  intros C f. assert (p < n)%nat by apply K. unfold curve1. rewrite (sum_single n _ (n - 1)%nat); [|lia|].
  - rewrite basis_last, Nat.eqb_refl by auto. ring.
  - intros k _ Hk. rewrite basis_last by auto. destruct (Nat.eqb_spec k (n - 1)); [contradiction|ring].
Qed.

Theorem rcurve_first : forall P, clamped t p n -> rcurve t p n w P (t p) = P O.
Proof.
  intros P C. assert (p < n)%nat by apply K. unfold rcurve. rewrite curve_first, curve1_first by auto.
  apply over_times. apply Rgt_not_eq, W. lia.
Qed.

Theorem rcurve_last : forall P, clamped t p n -> rcurve t p n w P (t n) = P (n - 1)%nat.
Proof.
  intros P C. assert (p < n)%nat by apply K. unfold rcurve. rewrite curve_last, curve1_last by auto.
  apply over_times. apply Rgt_not_eq, W. lia.
Qed.

(* Inserting a knot into the homogeneous coordinates: the new weights are positive, the new points are quotients, the curve is the same. *)
Theorem rcurve_insert : forall x k s P u, insertable t p n x k s ->
  let w' := insert1 t p x k s w in
  let P' := fun i => over (insert_point t p x k s (lifted w P) i) (w' i) in
  positive (S n) w' /\ rcurve (insert_knot t k x) p (S n) w' P' u = rcurve t p n w P u.
Proof.
  intros x k s P u I w' P'. assert (W' : positive (S n) w') by (intros i Hi; now apply (insert1_pos t p n x k s)). split; auto.
  unfold rcurve. rewrite <- (curve_insert t p n x k s K I (lifted w P) u), <- (curve1_insert t p n x k s K I w u).
  fold w'. f_equal. apply comb_ext. intros i Hi. split; auto. specialize (W' i Hi).
  unfold P', lifted at 1. apply vec_ext; simpl; field; lra.
Qed.
End Curve.

(* With equal weights a rational curve is a polynomial one. *)
Theorem rcurve_equal_weights : forall t p n a P x, knots t p n -> 0 < a -> rcurve t p n (fun _ => a) P x = curve t p n P x.
Proof.
  intros t p n a P x K Ha. assert (W : positive n (fun _ => a)) by (intros i _; auto).
  rewrite rcurve_comb by auto. apply comb_ext; intros i _. split; auto. unfold rbasis, curve1.
  rewrite (sum_ext n _ (fun k => a * basis t p n k x)), sum_scal, basis_unity by (auto; intros; ring). field. lra.
Qed.

(* ---- surfaces ---- *)

Section Surface.
Variables (t r : nat -> R) (p q m n : nat) (w : nat -> nat -> R).
Hypothesis Ku : knots t p m.
Hypothesis Kv : knots r q n.

Theorem rsurface_inside : forall P u v, rsurface t r p q m n w P (inside t p m u) (inside r q n v) = rsurface t r p q m n w P u v.
Proof.
  intros. unfold rsurface. rewrite surface_inside by auto. f_equal.
  apply sum_ext; intros j _. rewrite basis_inside by auto. f_equal.
  apply sum_ext; intros i _. now rewrite basis_inside.
Qed.

Hypothesis W : positive2 m n w.

Theorem weight2_pos : forall u v, 0 < surface1 t r p q m n w u v.
Proof.
  intros u v. apply (weight_pos r q n); auto. intros j Hj. apply (weight_pos t p m); auto. intros i Hi. auto.
Qed.

Theorem rbasis2_nonneg : forall i j u v, (i < m)%nat -> (j < n)%nat -> 0 <= rbasis2 t r p q m n w i j u v.
Proof.
  intros i j u v Hi Hj. apply Rmult_le_pos; [apply Rmult_le_pos; [apply Rmult_le_pos; now apply basis_nonneg|apply Rlt_le; auto]|].
  apply Rlt_le, Rinv_0_lt_compat, weight2_pos.
Qed.

(* Sums with the R_ij are quotients of sums. *)
Lemma rbasis2_sum : forall f u v, sum (fun i => sum (fun j => rbasis2 t r p q m n w i j u v * f i j) n) m =
  surface1 t r p q m n (fun i j => w i j * f i j) u v / surface1 t r p q m n w u v.
Proof.
  intros. unfold Rdiv. rewrite (surface1_tensor t r p q m n (fun i j => w i j * f i j)), Rmult_comm, <- sum_scal.
  apply sum_ext; intros i _. rewrite <- sum_scal. apply sum_ext; intros j _. unfold rbasis2, Rdiv. ring.
Qed.

Theorem rbasis2_unity : forall u v, sum (fun i => sum (fun j => rbasis2 t r p q m n w i j u v) n) m = 1.
Proof.
  intros u v. assert (H := weight2_pos u v).
  transitivity (sum (fun i => sum (fun j => rbasis2 t r p q m n w i j u v * 1) n) m).
  - apply sum_ext; intros; apply sum_ext; intros; ring.
  - rewrite (rbasis2_sum (fun _ _ => 1)).
    assert (E : surface1 t r p q m n (fun i j => w i j * 1) u v = surface1 t r p q m n w u v).
    { rewrite !surface1_tensor. apply sum_ext; intros; apply sum_ext; intros; ring. }
    rewrite E. field. lra.
Qed.

(* A linear form of a point of the surface, by the R_ij. *)
Lemma rsurface_dot : forall a P u v, dot a (rsurface t r p q m n w P u v) =
  sum (fun i => sum (fun j => rbasis2 t r p q m n w i j u v * dot a (P i j)) n) m.
Proof.
  intros a P u v. rewrite rbasis2_sum.
  transitivity (dot a (surface t r p q m n (lifted2 w P) u v) / surface1 t r p q m n w u v).
  - unfold rsurface, dot, over; simpl; unfold Rdiv; ring.
  - f_equal. rewrite surface1_tensor. unfold surface, curve. rewrite comb_comb.
    apply sum_ext; intros; apply sum_ext; intros. unfold lifted2, dot, times; simpl. ring.
Qed.

Theorem rsurface_hull : forall P u v, in_hull2 m n P (rsurface t r p q m n w P u v).
Proof.
  intros P u v. exists (fun i j => rbasis2 t r p q m n w i j u v). repeat split.
  - intros; now apply rbasis2_nonneg.
  - apply rbasis2_unity.
  - intros; apply rsurface_dot.
Qed.

Theorem rsurface_affine : forall a b c o P u v, affine a b c o (rsurface t r p q m n w P u v) =
  rsurface t r p q m n w (fun i j => affine a b c o (P i j)) u v.
Proof.
  intros a b c o P u v.
  assert (H : forall d, sum (fun i => sum (fun j => rbasis2 t r p q m n w i j u v * d) n) m = d).
  { intros d. transitivity (sum (fun i => d * sum (fun j => rbasis2 t r p q m n w i j u v) n) m).
    - apply sum_ext; intros. rewrite <- sum_scal. apply sum_ext; intros; ring.
    - rewrite sum_scal, rbasis2_unity. ring. }
  assert (G : forall f d, sum (fun i => sum (fun j => rbasis2 t r p q m n w i j u v * f i j) n) m + d =
    sum (fun i => sum (fun j => rbasis2 t r p q m n w i j u v * (f i j + d)) n) m).
  { intros f d. rewrite <- (H d) at 1. rewrite <- sum_add. apply sum_ext; intros. rewrite <- sum_add. apply sum_ext; intros; ring. }
  set (Q := rsurface t r p q m n w (fun i j => affine a b c o (P i j)) u v).
  assert (EX : X Q = dot (vec 1 0 0) Q) by (unfold dot; simpl; ring).
  assert (EY : Y Q = dot (vec 0 1 0) Q) by (unfold dot; simpl; ring).
  assert (EZ : Z Q = dot (vec 0 0 1) Q) by (unfold dot; simpl; ring).
  apply vec_ext; [rewrite EX|rewrite EY|rewrite EZ]; unfold Q, affine at 1; cbn [X Y Z]; rewrite !rsurface_dot, G;
    apply sum_ext; intros i _; apply sum_ext; intros j _; unfold affine, dot; simpl; ring.
Qed.

(* ---- borders and corners ---- *)

Theorem rborder_left : forall P v, clamped t p m ->
  rsurface t r p q m n w P (t p) v = rcurve r q n (fun j => w O j) (fun j => P O j) v.
Proof.
  intros P v C. unfold rsurface, rcurve. rewrite border_left by auto. f_equal.
  apply sum_ext; intros j _. rewrite curve1_first by auto. reflexivity.
Qed.

Theorem rborder_right : forall P v, clamped t p m ->
  rsurface t r p q m n w P (t m) v = rcurve r q n (fun j => w (m - 1)%nat j) (fun j => P (m - 1)%nat j) v.
Proof.
  intros P v C. unfold rsurface, rcurve. rewrite border_right by auto. f_equal.
  apply sum_ext; intros j _. rewrite curve1_last by auto. reflexivity.
Qed.

Theorem rborder_bottom : forall P u, clamped r q n ->
  rsurface t r p q m n w P u (r q) = rcurve t p m (fun i => w i O) (fun i => P i O) u.
Proof.
  intros P u C. unfold rsurface, rcurve. rewrite border_bottom by auto. f_equal. unfold surface1. now rewrite curve1_first.
Qed.

Theorem rborder_top : forall P u, clamped r q n ->
  rsurface t r p q m n w P u (r n) = rcurve t p m (fun i => w i (n - 1)%nat) (fun i => P i (n - 1)%nat) u.
Proof.
  intros P u C. unfold rsurface, rcurve. rewrite border_top by auto. f_equal. unfold surface1. now rewrite curve1_last.
Qed.

Theorem rcorners : forall P, clamped t p m -> clamped r q n ->
  rsurface t r p q m n w P (t p) (r q) = P O O /\ rsurface t r p q m n w P (t p) (r n) = P O (n - 1)%nat /\
  rsurface t r p q m n w P (t m) (r q) = P (m - 1)%nat O /\ rsurface t r p q m n w P (t m) (r n) = P (m - 1)%nat (n - 1)%nat.
Proof.
  intros P Cu Cv. assert (p < m)%nat by apply Ku. assert (q < n)%nat by apply Kv. rewrite !rborder_left, !rborder_right by auto.
  rewrite !rcurve_first, !rcurve_last by (auto; intros j Hj; apply W; lia). auto.
Qed.
End Surface.

(* ---- inserting a knot in either direction, into the homogeneous coordinates of each of the curves along it ---- *)

Theorem rsurface_insert_u : forall t r p q m n x k s w P u v, knots t p m -> positive2 m n w -> insertable t p m x k s ->
  let w' := fun i j => insert1 t p x k s (fun a => w a j) i in
  let P' := fun i j => over (insert_point t p x k s (fun a => lifted2 w P a j) i) (w' i j) in
  positive2 (S m) n w' /\ rsurface (insert_knot t k x) r p q (S m) n w' P' u v = rsurface t r p q m n w P u v.
Proof.
  intros t r p q m n x k s w P u v K W I w' P'.
  assert (W' : positive2 (S m) n w').
  { intros i j Hi Hj. apply (insert1_pos t p m x k s K I (fun a => w a j)); auto. }
  split; auto. unfold rsurface. f_equal.
  - rewrite <- (surface_insert_u t r p q m n x k s (lifted2 w P) u v K I).
    apply comb_ext; intros j Hj. split; auto. apply comb_ext; intros i Hi. split; auto. specialize (W' i j Hi Hj).
    unfold P', lifted2 at 1. apply vec_ext; simpl; field; lra.
  - apply sum_ext; intros j _. f_equal. apply (curve1_insert t p m x k s K I (fun a => w a j)).
Qed.

Theorem rsurface_transpose : forall t r p q m n w P u v,
  rsurface t r p q m n w P u v = rsurface r t q p n m (fun j i => w i j) (fun j i => P i j) v u.
Proof.
  intros. unfold rsurface. f_equal; [apply (surface_transpose t r p q m n (lifted2 w P))|].
  rewrite !surface1_tensor, sum_swap. apply sum_ext; intros; apply sum_ext; intros; ring.
Qed.

Theorem rsurface_insert_v : forall t r p q m n x k s w P u v, knots r q n -> positive2 m n w -> insertable r q n x k s ->
  let w' := fun i => insert1 r q x k s (w i) in
  let P' := fun i j => over (insert_point r q x k s (lifted2 w P i) j) (w' i j) in
  positive2 m (S n) w' /\ rsurface t (insert_knot r k x) p q m (S n) w' P' u v = rsurface t r p q m n w P u v.
Proof.
  intros t r p q m n x k s w P u v K W I w' P'.
  destruct (rsurface_insert_u r t q p n m x k s (fun j i => w i j) (fun j i => P i j) v u K (fun j i Hj Hi => W i j Hi Hj) I) as [W' E].
  split; [intros i j Hi Hj; now apply W'|]. rewrite rsurface_transpose, (rsurface_transpose t r). exact E.
Qed.

(* ---- which data matter ---- *)

Theorem rcurve_ext : forall t t' p n w w' P P' x, (p < n)%nat -> (forall j, (j <= n + p)%nat -> t j = t' j) ->
  (forall i, (i < n)%nat -> w i = w' i) -> (forall i, (i < n)%nat -> P i = P' i) -> rcurve t p n w P x = rcurve t' p n w' P' x.
Proof.
  intros t t' p n w w' P P' x Hp Ht Hw HP. unfold rcurve. f_equal.
  - apply curve_ext; auto. intros i Hi. unfold lifted. now rewrite Hw, HP.
  - apply sum_ext. intros i Hi. now rewrite Hw, (basis_ext t t') by auto.
Qed.
