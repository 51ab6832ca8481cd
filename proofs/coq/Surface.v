(* Surface: tensor-product B-spline surfaces of any degrees, S(u,v) = sum_ij N_i,p(u) N_j,q(v) P_ij (etalon/spline/surface.h).

   The code sums over u first, for each column j, then over v; so a surface is a curve whose control points are points of curves, and what is
   known of curves carries over. *)
Require Import Reals Lra Lia Arith.
From Etalon Require Import Sums Space Basis Curve Insertion.
Open Scope R_scope.

(* Degrees p, q; knots t, r; m x n control points P i j, i < m, j < n. *)
Definition surface (t r : nat -> R) (p q m n : nat) (P : nat -> nat -> vec3) (u v : R) : vec3 :=
  curve r q n (fun j => curve t p m (fun i => P i j) u) v.

(* The same of numbers: a coordinate, or the weights of a rational surface. *)
Definition surface1 (t r : nat -> R) (p q m n : nat) (f : nat -> nat -> R) (u v : R) : R :=
  curve1 r q n (fun j => curve1 t p m (fun i => f i j) u) v.

(* ---- the tensor product ---- *)

Theorem surface1_tensor : forall t r p q m n f u v,
  surface1 t r p q m n f u v = sum (fun i => sum (fun j => basis t p m i u * basis r q n j v * f i j) n) m.
Proof.
  intros. rewrite sum_swap. apply sum_ext; intros j _. unfold curve1. rewrite <- sum_scal. apply sum_ext; intros; ring.
Qed.

Theorem surface_tensor : forall t r p q m n P u v,
  X (surface t r p q m n P u v) = sum (fun i => sum (fun j => basis t p m i u * basis r q n j v * X (P i j)) n) m /\
  Y (surface t r p q m n P u v) = sum (fun i => sum (fun j => basis t p m i u * basis r q n j v * Y (P i j)) n) m /\
  Z (surface t r p q m n P u v) = sum (fun i => sum (fun j => basis t p m i u * basis r q n j v * Z (P i j)) n) m.
Proof.
  intros. repeat split; [apply (surface1_tensor t r p q m n (fun i j => X (P i j)))|
    apply (surface1_tensor t r p q m n (fun i j => Y (P i j)))|apply (surface1_tensor t r p q m n (fun i j => Z (P i j)))].
Qed.

(* The order of the directions does not matter. *)
Theorem surface_transpose : forall t r p q m n P u v, surface t r p q m n P u v = surface r t q p n m (fun j i => P i j) v u.
Proof.
  intros. destruct (surface_tensor t r p q m n P u v) as (EX & EY & EZ).
  destruct (surface_tensor r t q p n m (fun j i => P i j) v u) as (FX & FY & FZ).
  apply vec_ext; [rewrite EX, FX|rewrite EY, FY|rewrite EZ, FZ]; rewrite sum_swap;
    apply sum_ext; intros; apply sum_ext; intros; ring.
Qed.

Section Surface.
Variables (t r : nat -> R) (p q m n : nat).
Hypothesis Ku : knots t p m.
Hypothesis Kv : knots r q n.

Let at_uv := surface t r p q m n.

(* Beyond the domain the surface has the values of its border. *)
Theorem surface_inside : forall P u v, surface t r p q m n P (inside t p m u) (inside r q n v) = surface t r p q m n P u v.
Proof.
  intros. apply comb_ext; intros j _. rewrite basis_inside by auto. split; auto.
  apply comb_ext; intros i _. now rewrite basis_inside.
Qed.

(* ---- functions of two parameters ---- *)

Theorem surface_unity : forall u v, sum (fun i => sum (fun j => basis t p m i u * basis r q n j v) n) m = 1.
Proof.
  intros. rewrite <- (basis_unity t p m Ku u). apply sum_ext; intros i _.
  rewrite sum_scal, basis_unity by auto. ring.
Qed.

(* ---- affine invariance and the convex hull ---- *)

Theorem surface_affine : forall a b c o P u v, affine a b c o (at_uv P u v) = at_uv (fun i j => affine a b c o (P i j)) u v.
Proof.
  intros. unfold at_uv, surface. rewrite curve_affine by auto. apply comb_ext; intros j _. split; auto.
  now rewrite curve_affine.
Qed.

Theorem surface_hull : forall P u v, in_hull2 m n P (at_uv P u v).
Proof.
  intros P u v. exists (fun i j => basis t p m i u * basis r q n j v). repeat split.
  - intros. apply Rmult_le_pos; now apply basis_nonneg.
  - apply surface_unity.
  - intros a. apply comb_comb.
Qed.

(* ---- borders: the curves of the border's control points, where the knots of the direction across are clamped ---- *)

Theorem border_left : forall P v, clamped t p m -> at_uv P (t p) v = curve r q n (fun j => P O j) v.
Proof. intros P v C. apply comb_ext; intros j _. split; auto. now apply (curve_first t p m Ku (fun i => P i j)). Qed.

Theorem border_right : forall P v, clamped t p m -> at_uv P (t m) v = curve r q n (fun j => P (m - 1)%nat j) v.
Proof. intros P v C. apply comb_ext; intros j _. split; auto. now apply (curve_last t p m Ku (fun i => P i j)). Qed.

Theorem border_bottom : forall P u, clamped r q n -> at_uv P u (r q) = curve t p m (fun i => P i O) u.
Proof. intros P u C. now apply (curve_first r q n Kv (fun j => curve t p m (fun i => P i j) u)). Qed.

Theorem border_top : forall P u, clamped r q n -> at_uv P u (r n) = curve t p m (fun i => P i (n - 1)%nat) u.
Proof. intros P u C. now apply (curve_last r q n Kv (fun j => curve t p m (fun i => P i j) u)). Qed.

(* ---- corners ---- *)

Theorem corners : forall P, clamped t p m -> clamped r q n ->
  at_uv P (t p) (r q) = P O O /\ at_uv P (t p) (r n) = P O (n - 1)%nat /\
  at_uv P (t m) (r q) = P (m - 1)%nat O /\ at_uv P (t m) (r n) = P (m - 1)%nat (n - 1)%nat.
Proof.
  intros P Cu Cv. rewrite !border_left, !border_right by auto.
  now rewrite !curve_first, !curve_last by auto.
Qed.
End Surface.

(* ---- which data matter ---- *)

Theorem surface_ext : forall t t' r r' p q m n P P' u v, (p < m)%nat -> (q < n)%nat ->
  (forall i, (i <= m + p)%nat -> t i = t' i) -> (forall j, (j <= n + q)%nat -> r j = r' j) ->
  (forall i j, (i < m)%nat -> (j < n)%nat -> P i j = P' i j) -> surface t r p q m n P u v = surface t' r' p q m n P' u v.
Proof. intros. apply curve_ext; auto. intros; apply curve_ext; auto. Qed.

(* ---- inserting a knot in either direction: into each of the curves along it ---- *)

Theorem surface_insert_u : forall t r p q m n x k s P u v, knots t p m -> insertable t p m x k s ->
  surface (insert_knot t k x) r p q (S m) n (fun i j => insert_point t p x k s (fun i' => P i' j) i) u v = surface t r p q m n P u v.
Proof. intros. apply comb_ext; intros j _. split; auto. now apply (curve_insert t p m x k s H H0 (fun i => P i j)). Qed.

Theorem surface_insert_v : forall t r p q m n x k s P u v, knots r q n -> insertable r q n x k s ->
  surface t (insert_knot r k x) p q m (S n) (fun i => insert_point r q x k s (P i)) u v = surface t r p q m n P u v.
Proof.
  intros. rewrite surface_transpose, (surface_transpose t r).
  apply (surface_insert_u r t q p n m x k s (fun j i => P i j)); auto.
Qed.
