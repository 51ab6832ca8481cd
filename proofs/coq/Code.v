(* Code: what the loops of the code (RoundingScheme.v, which quotes them) compute over the real numbers is what the theorems of Basis.v to
   Seam.v speak of.  So these are theorems about the code but for rounding, which Rounding.v bounds. *)
Require Import Reals Lra Lia Arith List FunctionalExtensionality.
From Etalon Require Import Sums Space Basis Curve Insertion Surface Rational Seam.
From Etalon Require RoundingScheme Rounding.
Module Loop := RoundingScheme.
Open Scope R_scope.

Notation exact := Rounding.exact.

(* ---- basis functions: et_basis_eval ---- *)

Lemma cox_is_B : forall t s x p i, Rounding.cox t s x p i = B t s p i x.
Proof. intros t s x p; induction p; intros i; [reflexivity|]. cbn [Rounding.cox B]. now rewrite !IHp. Qed.

Lemma clamp_is_clamp : forall x lo hi, Loop.clamp (A := exact) x lo hi = clamp lo hi x.
Proof.
  intros. unfold Loop.clamp, clamp. cbn. unfold Rounding.less_R. destruct (Rlt_dec x lo); [|destruct (Rlt_dec hi x)]; reflexivity.
Qed.

(* No rounding is the rounding with u = 0, so within no distance at all. *)
Lemma within_0 : forall k a b, Rounding.within 0 k a b -> a = b.
Proof. intros k a b (_ & _ & H1 & H2). rewrite Rminus_0_r, pow1 in *. lra. Qed.

Section Basis.
Variables (t : nat -> R) (p n : nat).
Hypothesis K : knots t p n.

(* N[r] behind the call, for any x and the span that et_knots_span finds. *)
Definition loop_basis (s : nat) (x : R) (r : nat) : R := nth r (Loop.basis_eval (A := exact) t (n + p + 1) p s x) 0.

Theorem code_basis : forall s x r, is_span t p n (inside t p n x) s -> (r <= p)%nat -> loop_basis s x r = basis t p n (s - p + r) x.
Proof.
  intros s x r H Hr. rewrite (basis_at t p n K s) by auto. unfold loop_basis, Loop.basis_eval. rewrite clamp_is_clamp.
  replace (n + p + 1 - p - 1)%nat with n by lia. fold (inside t p n x). destruct H as [Hs Hn Hi _]. rewrite <- cox_is_B.
  apply (within_0 (6 * p - 1)). apply Rounding.basis_at_within; auto; try lia; try lra; try apply K.
  intros y. unfold Rounding.plain. rewrite Rminus_eq_0, Rabs_R0. lra.
Qed.

(* ---- curves: et_curve_point; f is a coordinate of the control points ---- *)

Lemma contract_is_sum : forall N c m, Loop.contract (A := exact) N c m = sum (fun r => N r * c r) (S m).
Proof.
  intros N c m; induction m; cbn; unfold Rounding.plain; [ring|]. rewrite IHm. simpl. ring.
Qed.

Lemma curve1_local : forall f x s, is_span t p n (inside t p n x) s ->
  curve1 t p n f x = sum (fun r => basis t p n (s - p + r) x * f (s - p + r)%nat) (S p).
Proof.
  intros f x s H. assert (E : forall i, basis t p n i x = B t s p i (inside t p n x)) by (intros; now apply basis_at).
  unfold curve1. rewrite (sum_ext n _ (fun i => B t s p i (inside t p n x) * f i)) by (intros; now rewrite E).
  destruct H. rewrite B_sum_local by auto. apply sum_ext; intros; now rewrite E.
Qed.

Lemma code_sum : forall f x s, is_span t p n (inside t p n x) s ->
  Loop.contract (A := exact) (loop_basis s x) (fun r => f (s - p + r)%nat) p = curve1 t p n f x.
Proof.
  intros f x s H. rewrite contract_is_sum, (curve1_local f x s H). apply sum_ext; intros r Hr. rewrite code_basis by (auto; lia).
  reflexivity.
Qed.

Theorem code_curve : forall f x s, is_span t p n (inside t p n x) s ->
  Loop.curve_point (A := exact) (loop_basis s x) (fun r => f (s - p + r)%nat) p = curve1 t p n f x.
Proof.
  intros f x s H. rewrite <- (code_sum f x s H). unfold Loop.curve_point. rewrite !contract_is_sum.
  apply sum_ext; intros r _. cbn. unfold Rounding.plain. ring.
Qed.

Theorem code_curve_rational : forall w f x s, is_span t p n (inside t p n x) s ->
  Loop.curve_point_rational (A := exact) (loop_basis s x) (fun r => w (s - p + r)%nat) (fun r => f (s - p + r)%nat) p =
  curve1 t p n (fun i => w i * f i) x / curve1 t p n w x.
Proof.
  intros w f x s H. rewrite <- (code_sum w x s H), <- (code_sum (fun i => w i * f i) x s H). reflexivity.
Qed.
End Basis.

(* Each coordinate of a curve is what the loops compute. *)
Theorem curve_coordinates : forall t p n P x, curve t p n P x =
  vec (curve1 t p n (fun i => X (P i)) x) (curve1 t p n (fun i => Y (P i)) x) (curve1 t p n (fun i => Z (P i)) x).
Proof. reflexivity. Qed.

Theorem rcurve_coordinates : forall t p n w P x, rcurve t p n w P x =
  vec (curve1 t p n (fun i => w i * X (P i)) x / curve1 t p n w x) (curve1 t p n (fun i => w i * Y (P i)) x / curve1 t p n w x)
      (curve1 t p n (fun i => w i * Z (P i)) x / curve1 t p n w x).
Proof. reflexivity. Qed.

(* ---- surfaces: et_surface_point ---- *)

Theorem surface_coordinates : forall t r p q m n P u v, surface t r p q m n P u v =
  vec (surface1 t r p q m n (fun i j => X (P i j)) u v) (surface1 t r p q m n (fun i j => Y (P i j)) u v)
      (surface1 t r p q m n (fun i j => Z (P i j)) u v).
Proof. reflexivity. Qed.

Theorem rsurface_coordinates : forall t r p q m n w P u v, rsurface t r p q m n w P u v =
  vec (surface1 t r p q m n (fun i j => w i j * X (P i j)) u v / surface1 t r p q m n w u v)
      (surface1 t r p q m n (fun i j => w i j * Y (P i j)) u v / surface1 t r p q m n w u v)
      (surface1 t r p q m n (fun i j => w i j * Z (P i j)) u v / surface1 t r p q m n w u v).
Proof. reflexivity. Qed.

Section Surface.
Variables (t r : nat -> R) (p q m n : nat).
Hypothesis Ku : knots t p m.
Hypothesis Kv : knots r q n.

Lemma code_sums : forall f u v i j, is_span t p m (inside t p m u) i -> is_span r q n (inside r q n v) j ->
  Loop.contract_uv (A := exact) (loop_basis t p m i u) (loop_basis r q n j v) (fun a b => f (i - p + a)%nat (j - q + b)%nat) p q =
  surface1 t r p q m n f u v.
Proof.
  intros f u v i j Hi Hj. unfold surface1. rewrite <- (code_sum r q n Kv _ v j Hj). unfold Loop.contract_uv.
  rewrite !contract_is_sum. apply sum_ext; intros b _. f_equal. apply (code_sum t p m Ku (fun a => f a (j - q + b)%nat) u i Hi).
Qed.

Theorem code_surface : forall f u v i j, is_span t p m (inside t p m u) i -> is_span r q n (inside r q n v) j ->
  Loop.surface_point (A := exact) (loop_basis t p m i u) (loop_basis r q n j v) (fun a b => f (i - p + a)%nat (j - q + b)%nat) p q =
  surface1 t r p q m n f u v.
Proof.
  intros f u v i j Hi Hj. rewrite <- (code_sums f u v i j Hi Hj). unfold Loop.surface_point, Loop.contract_uv.
  rewrite !contract_is_sum. apply sum_ext; intros b _. rewrite !contract_is_sum. f_equal. apply sum_ext; intros a _.
  cbn. unfold Rounding.plain. ring.
Qed.

Theorem code_surface_rational : forall w f u v i j, is_span t p m (inside t p m u) i -> is_span r q n (inside r q n v) j ->
  Loop.surface_point_rational (A := exact) (loop_basis t p m i u) (loop_basis r q n j v)
    (fun a b => w (i - p + a)%nat (j - q + b)%nat) (fun a b => f (i - p + a)%nat (j - q + b)%nat) p q =
  surface1 t r p q m n (fun a b => w a b * f a b) u v / surface1 t r p q m n w u v.
Proof.
  intros w f u v i j Hi Hj. rewrite <- (code_sums w u v i j Hi Hj), <- (code_sums (fun a b => w a b * f a b) u v i j Hi Hj).
  reflexivity.
Qed.
End Surface.

(* ---- knot insertion: insert_once, and et_curve_insert; f is one of the homogeneous coordinates ---- *)

Theorem code_insert_knot : forall t k x i, Loop.insert_knots (A := exact) t k x i = insert_knot t k x i.
Proof.
  intros. unfold Loop.insert_knots, insert_knot. destruct (Nat.leb_spec i k), (le_lt_dec i k); try lia; auto.
  destruct (Nat.eqb_spec i (k + 1)), (Nat.eq_dec i (S k)); try lia; auto.
Qed.

Theorem code_insert : forall t p k s x f i, (s <= p)%nat -> Loop.insert_points (A := exact) t p k s x f i = insert1 t p x k s f i.
Proof.
  intros t p k s x f i H. unfold Loop.insert_points, insert1.
  destruct (Nat.leb_spec i (k - s)), (Nat.ltb_spec k (i + p)), (le_lt_dec (i + p) k), (le_lt_dec i (k - s)); try lia; reflexivity.
Qed.

(* The whole of et_curve_insert, over the reals: the code's loops leave every coordinate of the curve as it is. *)
Section Insertion.
Variables (t : nat -> R) (p n : nat) (x : R) (k s : nat) (f : nat -> R).
Hypothesis K : knots t p n.
Hypothesis I : insertable t p n x k s.

Let knots_at (m : nat) := Loop.inserted_knots (A := exact) t k x m.
Let points_at (m : nat) := Loop.inserted (A := exact) t p k s x f m.

Theorem code_insert_times : forall m, (m + s <= p + 1)%nat ->
  knots (knots_at m) p (n + m) /\ forall u, curve1 (knots_at m) p (n + m) (points_at m) u = curve1 t p n f u.
Proof.
  assert (H : forall m, (m + s <= p + 1)%nat -> knots (knots_at m) p (n + m) /\
    ((m + s <= p)%nat -> insertable (knots_at m) p (n + m) x (k + m) (s + m)) /\
    forall u, curve1 (knots_at m) p (n + m) (points_at m) u = curve1 t p n f u).
  { induction m; intros Hm; [rewrite !Nat.add_0_r; auto|].
    destruct (IHm ltac:(lia)) as (Km & Im & Cm). specialize (Im ltac:(lia)).
    assert (E : knots_at (S m) = insert_knot (knots_at m) (k + m) x) by (apply functional_extensionality; apply code_insert_knot).
    assert (F : points_at (S m) = insert1 (knots_at m) p x (k + m) (s + m) (points_at m)).
    { apply functional_extensionality. intros i. apply code_insert. lia. }
    rewrite E, F, !Nat.add_succ_r. split; [|split].
    - now apply (insert_knots (knots_at m) p (n + m) x (k + m) (s + m)).
    - intros Hs. apply insert_again; auto. lia.
    - intros u. now rewrite curve1_insert. }
  intros m Hm. now destruct (H m Hm) as (A & _ & C).
Qed.
End Insertion.

(* ---- the seam, of what the code computes: c is a coordinate of the control classes ---- *)

Section Seam.
Variables (t r : nat -> R) (p q nx ny : nat) (c : nat -> R).
Hypothesis Ku : knots t p nx.
Hypothesis Kv : knots r q ny.
Hypothesis Cu : clamped t p nx.
Hypothesis Cv : clamped r q ny.
Variables (u v : R) (i j : nat).
Hypothesis Hb : border_parameter t r p q nx ny u v.
Hypothesis Hi : is_span t p nx (inside t p nx u) i.
Hypothesis Hj : is_span r q ny (inside r q ny v) j.

(* The value at node (a, b) of a view's control net. *)
Definition node (value : nat -> R) (k : view) (a b : nat) : R := value (class nx ny k a b - 1)%nat.

Let N := loop_basis t p nx i u.
Let M := loop_basis r q ny j v.

Theorem code_seam :
  Loop.surface_point (A := exact) N M (fun a b => node c bottom (i - p + a) (j - q + b)) p q =
  Loop.surface_point (A := exact) N M (fun a b => node c top (i - p + a) (j - q + b)) p q.
Proof.
  unfold N, M. rewrite (code_surface t r p q nx ny Ku Kv (node c bottom) u v i j Hi Hj).
  rewrite (code_surface t r p q nx ny Ku Kv (node c top) u v i j Hi Hj).
  exact (f_equal X (doublenet_seam t r p q nx ny (fun a => vec (c a) 0 0) Ku Kv Cu Cv u v Hb)).
Qed.

Theorem code_seam_rational : forall w,
  Loop.surface_point_rational (A := exact) N M (fun a b => node w bottom (i - p + a) (j - q + b)) (fun a b => node c bottom (i - p + a) (j - q + b)) p q =
  Loop.surface_point_rational (A := exact) N M (fun a b => node w top (i - p + a) (j - q + b)) (fun a b => node c top (i - p + a) (j - q + b)) p q.
Proof.
  intros w. unfold N, M. rewrite (code_surface_rational t r p q nx ny Ku Kv (node w bottom) (node c bottom) u v i j Hi Hj).
  rewrite (code_surface_rational t r p q nx ny Ku Kv (node w top) (node c top) u v i j Hi Hj).
  exact (f_equal X (doublenet_rational_seam t r p q nx ny (fun a => vec (c a) 0 0) w Ku Kv Cu Cv u v Hb)).
Qed.
End Seam.
