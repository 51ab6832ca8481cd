(* Seam: surfaces with equal knots along a border and equal control points (and weights) on it have that border in common; hence the two surfaces
   of a double net, which share the classes of the border, meet without a gap along all of it.

   Exactly: these are equations between points of space, for all parameters, any degrees and any non-decreasing knots whose ends stand p+1 times
   (Basis.v, clamped).  Nothing is asked of the two surfaces' interiors, and across the border not even that their knots or degrees be equal.
   Weights may be any numbers here; that they are positive is what makes the quotients points (Rational.v, weight2_pos). *)
Require Import Reals Lra Lia Arith.
Require Import Sums Space Basis Curve Insertion Surface Rational.
Open Scope R_scope.

(* ---- two surfaces ---- *)

(* The border u = left end, of a surface over the knots t, r and another over t', r'; knots of the border's direction agree. *)
Section Along_v.
Variables (t t' r r' : nat -> R) (p p' q m m' n : nat).
Hypothesis Ku : knots t p m.
Hypothesis Ku' : knots t' p' m'.
Hypothesis Kv : knots r q n.
Hypothesis C : clamped t p m.
Hypothesis C' : clamped t' p' m'.
Hypothesis same : forall j, (j <= n + q)%nat -> r j = r' j.

Let count : (q < n)%nat := knots_count r q n Kv.

Theorem seam_left : forall P P' v, (forall j, (j < n)%nat -> P O j = P' O j) ->
  surface t r p q m n P (t p) v = surface t' r' p' q m' n P' (t' p') v.
Proof. intros. rewrite !border_left by auto. now apply curve_ext. Qed.

Theorem seam_right : forall P P' v, (forall j, (j < n)%nat -> P (m - 1)%nat j = P' (m' - 1)%nat j) ->
  surface t r p q m n P (t m) v = surface t' r' p' q m' n P' (t' m') v.
Proof. intros. rewrite !border_right by auto. now apply curve_ext. Qed.

Theorem rational_seam_left : forall w w' P P' v, (forall j, (j < n)%nat -> w O j = w' O j) -> (forall j, (j < n)%nat -> P O j = P' O j) ->
  rsurface t r p q m n w P (t p) v = rsurface t' r' p' q m' n w' P' (t' p') v.
Proof. intros. rewrite !rborder_left by auto. now apply rcurve_ext. Qed.

Theorem rational_seam_right : forall w w' P P' v, (forall j, (j < n)%nat -> w (m - 1)%nat j = w' (m' - 1)%nat j) ->
  (forall j, (j < n)%nat -> P (m - 1)%nat j = P' (m' - 1)%nat j) ->
  rsurface t r p q m n w P (t m) v = rsurface t' r' p' q m' n w' P' (t' m') v.
Proof. intros. rewrite !rborder_right by auto. now apply rcurve_ext. Qed.
End Along_v.

Section Along_u.
Variables (t t' r r' : nat -> R) (p q q' m n n' : nat).
Hypothesis Ku : knots t p m.
Hypothesis Kv : knots r q n.
Hypothesis Kv' : knots r' q' n'.
Hypothesis C : clamped r q n.
Hypothesis C' : clamped r' q' n'.
Hypothesis same : forall i, (i <= m + p)%nat -> t i = t' i.

Let count : (p < m)%nat := knots_count t p m Ku.

Theorem seam_bottom : forall P P' u, (forall i, (i < m)%nat -> P i O = P' i O) ->
  surface t r p q m n P u (r q) = surface t' r' p q' m n' P' u (r' q').
Proof. intros. rewrite !border_bottom by auto. now apply curve_ext. Qed.

Theorem seam_top : forall P P' u, (forall i, (i < m)%nat -> P i (n - 1)%nat = P' i (n' - 1)%nat) ->
  surface t r p q m n P u (r n) = surface t' r' p q' m n' P' u (r' n').
Proof. intros. rewrite !border_top by auto. now apply curve_ext. Qed.

Theorem rational_seam_bottom : forall w w' P P' u, (forall i, (i < m)%nat -> w i O = w' i O) -> (forall i, (i < m)%nat -> P i O = P' i O) ->
  rsurface t r p q m n w P u (r q) = rsurface t' r' p q' m n' w' P' u (r' q').
Proof. intros. rewrite !rborder_bottom by auto. now apply rcurve_ext. Qed.

Theorem rational_seam_top : forall w w' P P' u, (forall i, (i < m)%nat -> w i (n - 1)%nat = w' i (n' - 1)%nat) ->
  (forall i, (i < m)%nat -> P i (n - 1)%nat = P' i (n' - 1)%nat) ->
  rsurface t r p q m n w P u (r n) = rsurface t' r' p q' m n' w' P' u (r' n').
Proof. intros. rewrite !rborder_top by auto. now apply rcurve_ext. Qed.
End Along_u.

(* ---- the double net ---- *)

Inductive view : Set := bottom | top.

Definition on_border (nx ny i j : nat) : bool := Nat.eqb i 0 || Nat.eqb i (nx - 1) || Nat.eqb j 0 || Nat.eqb j (ny - 1).

(* et_doublenet_class:
       if (view == ET_BOTTOM || on_border(net, i, j))
           return i * net.ny + j + 1;
       return net.nx * net.ny + (i - 1) * (net.ny - 2) + (j - 1) + 1;  *)
Definition class (nx ny : nat) (k : view) (i j : nat) : nat :=
  if match k with bottom => true | top => on_border nx ny i j end then (i * ny + j + 1)%nat
  else (nx * ny + (i - 1) * (ny - 2) + (j - 1) + 1)%nat.

(* Both views have one class on the border, *)
Theorem class_shared : forall nx ny i j, on_border nx ny i j = true -> class nx ny bottom i j = class nx ny top i j.
Proof. intros nx ny i j H. unfold class. now rewrite H. Qed.

(* and no class is shared besides. *)
Theorem class_unique : forall nx ny k k' i j i' j', (i < nx)%nat -> (j < ny)%nat -> (i' < nx)%nat -> (j' < ny)%nat ->
  class nx ny k i j = class nx ny k' i' j' -> i = i' /\ j = j' /\ (k = k' \/ on_border nx ny i j = true).
Proof.
  assert (V : forall nx ny i j, on_border nx ny i j = false -> (i < nx)%nat -> (j < ny)%nat ->
    (1 <= i /\ i + 2 <= nx /\ 1 <= j /\ j + 2 <= ny)%nat).
  { intros nx ny i j H Hi Hj. unfold on_border in H. rewrite !Bool.orb_false_iff, !Nat.eqb_neq in H. lia. }
  assert (D : forall b i j i' j', (j < b)%nat -> (j' < b)%nat -> (i * b + j = i' * b + j')%nat -> i = i' /\ j = j').
  { intros b i j i' j' Hj Hj' H. apply (Nat.div_mod_unique b); lia. }
  (* Numbers of the first kind are at most nx ny, those of the second greater. *)
  assert (L : forall nx ny i j, (i < nx)%nat -> (j < ny)%nat -> (i * ny + j + 1 <= nx * ny)%nat) by (intros; nia).
  intros nx ny k k' i j i' j' Hi Hj Hi' Hj' H.
  assert (A := L nx ny i j Hi Hj). assert (A' := L nx ny i' j' Hi' Hj').
  assert (U := V nx ny i j). assert (U' := V nx ny i' j'). unfold class in H.
  destruct k, k'; destruct (on_border nx ny i j) eqn:E, (on_border nx ny i' j') eqn:E'.
  all: try (destruct (D ny i j i' j' Hj Hj' ltac:(lia)); subst; auto; congruence).
  all: try (exfalso; lia).
  specialize (U eq_refl Hi Hj). specialize (U' eq_refl Hi' Hj').
  destruct (D (ny - 2)%nat (i - 1)%nat (j - 1)%nat (i' - 1)%nat (j' - 1)%nat) as [Ei Ej]; try lia.
  repeat split; try lia. now left.
Qed.

(* A double net of control points: one array of points (and one of weights), that of class c at index c - 1; both views over the same knots. *)
Section Doublenet.
Variables (t r : nat -> R) (p q nx ny : nat) (points : nat -> vec3) (weights : nat -> R).
Hypothesis Ku : knots t p nx.
Hypothesis Kv : knots r q ny.
Hypothesis Cu : clamped t p nx.
Hypothesis Cv : clamped r q ny.

Definition net_points (k : view) (i j : nat) : vec3 := points (class nx ny k i j - 1).
Definition net_weights (k : view) (i j : nat) : R := weights (class nx ny k i j - 1).

Definition view_surface (k : view) (u v : R) : vec3 := surface t r p q nx ny (net_points k) u v.
Definition view_rsurface (k : view) (u v : R) : vec3 := rsurface t r p q nx ny (net_weights k) (net_points k) u v.

(* A parameter of the border of the domain. *)
Definition border_parameter (u v : R) : Prop := u = t p \/ u = t nx \/ v = r q \/ v = r ny.

Lemma net_shared : forall i j, i = O \/ i = (nx - 1)%nat \/ j = O \/ j = (ny - 1)%nat ->
  net_points bottom i j = net_points top i j /\ net_weights bottom i j = net_weights top i j.
Proof.
  intros i j H. unfold net_points, net_weights. rewrite class_shared; auto. unfold on_border.
  rewrite !Bool.orb_true_iff, !Nat.eqb_eq. lia.
Qed.

(* THE SEAM THEOREM: without a gap, whatever the control points, *)
Theorem doublenet_seam : forall u v, border_parameter u v -> view_surface bottom u v = view_surface top u v.
Proof.
  intros u v [->|[->|[->| ->]]]; unfold view_surface;
    [apply seam_left|apply seam_right|apply seam_bottom|apply seam_top]; auto; intros; apply net_shared; auto.
Qed.

(* and whatever the weights. *)
Theorem doublenet_rational_seam : forall u v, border_parameter u v -> view_rsurface bottom u v = view_rsurface top u v.
Proof.
  intros u v [->|[->|[->| ->]]]; unfold view_rsurface;
    [apply rational_seam_left|apply rational_seam_right|apply rational_seam_bottom|apply rational_seam_top]; auto;
    intros; apply net_shared; auto.
Qed.
End Doublenet.
