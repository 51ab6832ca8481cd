(* Seam: surfaces with equal knots along a border and equal control points (and weights) on it have that border in common; hence the two surfaces
   of a double net, which share the classes of the border, meet without a gap along all of it.

   Exactly: these are equations between points of space, for all parameters, any degrees and any non-decreasing knots whose ends stand p+1 times
   (Basis.v, clamped).  Nothing is asked of the two surfaces' interiors, and across the border not even that their knots or degrees be equal.
   Weights may be any numbers here; that they are positive is what makes the quotients points (Rational.v, weight2_pos). *)
Require Import Reals Lra Lia Arith.
From Etalon Require Import Sums Space Basis Curve Insertion Surface Rational.
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

(* ---- that the knots are clamped, with no end knot more than p+1 times, is needed ---- *)

(* Two nets of 3 x 3 points that differ in the middle only, over knots whose first p+1 and last p+1 are equal: the corners are apart. *)
Theorem gap_otherwise : exists P P' : nat -> nat -> vec3,
  (forall i j, i = O \/ i = 2%nat \/ j = O \/ j = 2%nat -> P i j = P' i j) /\
  surface zeros zeros 1 1 3 3 P (zeros 1) (zeros 1) <> surface zeros zeros 1 1 3 3 P' (zeros 1) (zeros 1).
Proof.
  set (net := fun a (i j : nat) => if Nat.eqb i 1 then if Nat.eqb j 1 then vec a 0 0 else vec 0 0 0 else vec 0 0 0).
  exists (net 0), (net 1). split.
  - intros i j H. unfold net. destruct (Nat.eqb_spec i 1), (Nat.eqb_spec j 1); auto; lia.
  - destruct begins_later as (_ & _ & E). unfold surface. rewrite !E. unfold net. simpl. intros H. injection H. lra.
Qed.

(* ---- two surfaces of one shape: a shell ---- *)

(* On the border of the domain or beyond, from where it is clamped to the border. *)
Definition border_parameter (t r : nat -> R) (p q m n : nat) (u v : R) : Prop := u <= t p \/ t m <= u \/ v <= r q \/ r n <= v.

Definition border_index (m n i j : nat) : Prop := i = O \/ i = (m - 1)%nat \/ j = O \/ j = (n - 1)%nat.

(* What et_shell_closed compares, and clamped knots: *)
Section Shell.
Variables (t t' r r' : nat -> R) (p q m n : nat).
Hypothesis Ku : knots t p m.
Hypothesis Ku' : knots t' p m.
Hypothesis Kv : knots r q n.
Hypothesis Kv' : knots r' q n.
Hypothesis Cu : clamped t p m.
Hypothesis Cu' : clamped t' p m.
Hypothesis Cv : clamped r q n.
Hypothesis Cv' : clamped r' q n.
Hypothesis same_u : forall i, (i <= m + p)%nat -> t i = t' i.
Hypothesis same_v : forall j, (j <= n + q)%nat -> r j = r' j.

Let Eu : t p = t' p /\ t m = t' m.
Proof. assert (p < m)%nat by apply Ku. split; apply same_u; lia. Qed.

Let Ev : r q = r' q /\ r n = r' n.
Proof. assert (q < n)%nat by apply Kv. split; apply same_v; lia. Qed.

(* a statement for all parameters of the border, from those for its four sides. *)
Lemma on_four_sides : forall f f' : R -> R -> vec3,
  (forall u v, f (inside t p m u) (inside r q n v) = f u v) -> (forall u v, f' (inside t' p m u) (inside r' q n v) = f' u v) ->
  (forall v, f (t p) v = f' (t' p) v) -> (forall v, f (t m) v = f' (t' m) v) ->
  (forall u, f u (r q) = f' u (r' q)) -> (forall u, f u (r n) = f' u (r' n)) ->
  forall u v, border_parameter t r p q m n u v -> f u v = f' u v.
Proof.
  intros f f' I I' HL HR HB HT u v H. destruct Eu as [E1 E2], Ev as [E3 E4]. rewrite <- I, <- (I' u v).
  assert (Fu : inside t' p m u = inside t p m u) by (unfold inside; now rewrite E1, E2).
  assert (Fv : inside r' q n v = inside r q n v) by (unfold inside; now rewrite E3, E4).
  rewrite Fu, Fv. destruct H as [H|[H|[H|H]]].
  - rewrite (inside_left t p m Ku u H), HL. now rewrite E1.
  - rewrite (inside_right t p m Ku u H), HR. now rewrite E2.
  - rewrite (inside_left r q n Kv v H), HB. now rewrite E3.
  - rewrite (inside_right r q n Kv v H), HT. now rewrite E4.
Qed.

Theorem shell_seam : forall P P', (forall i j, (i < m)%nat -> (j < n)%nat -> border_index m n i j -> P i j = P' i j) ->
  forall u v, border_parameter t r p q m n u v -> surface t r p q m n P u v = surface t' r' p q m n P' u v.
Proof.
  intros P P' H. assert (p < m)%nat by apply Ku. assert (q < n)%nat by apply Kv. unfold border_index in H.
  apply on_four_sides; [intros; now apply surface_inside|intros; now apply surface_inside|..]; intros;
    [apply seam_left|apply seam_right|apply seam_bottom|apply seam_top]; auto; intros; apply H; auto; lia.
Qed.

Theorem rational_shell_seam : forall w w' P P',
  (forall i j, (i < m)%nat -> (j < n)%nat -> border_index m n i j -> w i j = w' i j /\ P i j = P' i j) ->
  forall u v, border_parameter t r p q m n u v -> rsurface t r p q m n w P u v = rsurface t' r' p q m n w' P' u v.
Proof.
  intros w w' P P' H. assert (p < m)%nat by apply Ku. assert (q < n)%nat by apply Kv. unfold border_index in H.
  apply on_four_sides; [intros; now apply rsurface_inside|intros; now apply rsurface_inside|..]; intros;
    [apply rational_seam_left|apply rational_seam_right|apply rational_seam_bottom|apply rational_seam_top]; auto; intros;
    apply H; auto; lia.
Qed.
End Shell.

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

Lemma border_class : forall nx ny i j, border_index nx ny i j -> class nx ny bottom i j = class nx ny top i j.
Proof.
  intros nx ny i j H. apply class_shared. unfold on_border, border_index in *. rewrite !Bool.orb_true_iff, !Nat.eqb_eq. tauto.
Qed.

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

(* THE SEAM THEOREM: without a gap, whatever the control points, *)
Theorem doublenet_seam : forall u v, border_parameter t r p q nx ny u v -> view_surface bottom u v = view_surface top u v.
Proof. clear weights. apply shell_seam; auto. intros. unfold net_points. now rewrite border_class. Qed.

(* and whatever the weights. *)
Theorem doublenet_rational_seam : forall u v, border_parameter t r p q nx ny u v -> view_rsurface bottom u v = view_rsurface top u v.
Proof. apply rational_shell_seam; auto. intros. unfold net_points, net_weights. now rewrite border_class. Qed.

(* The corners of both are the points of the classes 1, ny, ny (nx - 1) + 1 and nx ny (et_doublenet_corners), here at indices one less. *)
Theorem doublenet_corners : forall k,
  view_surface k (t p) (r q) = points 0%nat /\ view_surface k (t p) (r ny) = points (ny - 1)%nat /\
  view_surface k (t nx) (r q) = points (ny * (nx - 1))%nat /\ view_surface k (t nx) (r ny) = points (nx * ny - 1)%nat.
Proof.
  clear weights. intros k. assert (p < nx)%nat by apply Ku. assert (q < ny)%nat by apply Kv.
  destruct (corners t r p q nx ny Ku Kv (net_points k) Cu Cv) as (A & B & C & D).
  assert (E : forall i j, border_index nx ny i j -> net_points k i j = points (i * ny + j)%nat).
  { intros i j Hij. transitivity (net_points bottom i j).
    - unfold net_points. destruct k; auto. now rewrite border_class.
    - unfold net_points, class. f_equal. lia. }
  unfold view_surface. rewrite A, B, C, D, !E by (unfold border_index; auto).
  repeat split; f_equal; nia.
Qed.
End Doublenet.
