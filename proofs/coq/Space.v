(* Space: points of space (et_vec3), their combinations, affine maps, and the convex hull of finitely many points. *)
Require Import Reals Lra Lia Arith.
From Etalon Require Import Sums.
Open Scope R_scope.

Record vec3 : Type := vec { X : R; Y : R; Z : R }.

Lemma vec_ext : forall P Q, X P = X Q -> Y P = Y Q -> Z P = Z Q -> P = Q.
Proof. intros [] []; simpl; intros; subst; reflexivity. Qed.

Definition plus (P Q : vec3) : vec3 := vec (X P + X Q) (Y P + Y Q) (Z P + Z Q).
Definition times (a : R) (P : vec3) : vec3 := vec (a * X P) (a * Y P) (a * Z P).
Definition over (P : vec3) (a : R) : vec3 := vec (X P / a) (Y P / a) (Z P / a).
Definition dot (P Q : vec3) : R := X P * X Q + Y P * Y Q + Z P * Z Q.

(* ---- combinations ---- *)

(* c 0 P_0 + ... + c (n-1) P_(n-1) *)
Definition comb (n : nat) (c : nat -> R) (P : nat -> vec3) : vec3 :=
  vec (sum (fun i => c i * X (P i)) n) (sum (fun i => c i * Y (P i)) n) (sum (fun i => c i * Z (P i)) n).

Lemma comb_ext : forall n c d P Q, (forall i, (i < n)%nat -> c i = d i /\ P i = Q i) -> comb n c P = comb n d Q.
Proof. intros n c d P Q H; apply vec_ext; simpl; apply sum_ext; intros i Hi; destruct (H i Hi) as [-> ->]; reflexivity. Qed.

Lemma comb_single : forall n c P i, (i < n)%nat -> c i = 1 -> (forall k, (k < n)%nat -> k <> i -> c k = 0) -> comb n c P = P i.
Proof.
  intros n c P i Hi H1 H0; apply vec_ext; simpl; rewrite (sum_single n _ i Hi), H1;
    try lra; intros; rewrite H0; auto; lra.
Qed.

(* A linear form takes combinations to combinations. *)
Lemma dot_comb : forall n a c P, dot a (comb n c P) = sum (fun i => c i * dot a (P i)) n.
Proof.
  intros; unfold dot, comb; simpl. rewrite <- !sum_scal, <- !sum_add. apply sum_ext; intros; ring.
Qed.

(* A combination of combinations, by the distributive law. *)
Lemma comb_comb : forall m n c d (P : nat -> nat -> vec3) a, 
  dot a (comb m c (fun j => comb n d (fun i => P i j))) = sum (fun i => sum (fun j => d i * c j * dot a (P i j)) m) n.
Proof.
  intros. rewrite dot_comb, sum_swap. apply sum_ext; intros j _.
  rewrite dot_comb, <- sum_scal. apply sum_ext; intros; ring.
Qed.

(* ---- affine maps: those with the rows a, b, c of a matrix and the shift o ---- *)

Definition affine (a b c o P : vec3) : vec3 := vec (dot a P + X o) (dot b P + Y o) (dot c P + Z o).

Lemma comb_affine : forall n k P a b c o, sum k n = 1 ->
  affine a b c o (comb n k P) = comb n k (fun i => affine a b c o (P i)).
Proof.
  assert (E : forall n k f s, sum k n = 1 -> sum (fun i => k i * (f i + s)) n = sum (fun i => k i * f i) n + s).
  { intros n k f s H. transitivity (sum (fun i => k i * f i) n + s * sum k n); [|rewrite H; ring].
    rewrite <- sum_scal, <- sum_add. apply sum_ext; intros; ring. }
  intros; apply vec_ext; simpl; rewrite E, dot_comb; auto.
Qed.

(* ---- the convex hull ---- *)

(* Q is in the convex hull of P_0 .. P_(n-1): a combination with coefficients that are not negative and sum to 1. *)
Definition in_hull (n : nat) (P : nat -> vec3) (Q : vec3) : Prop :=
  exists c, (forall i, (i < n)%nat -> 0 <= c i) /\ sum c n = 1 /\ Q = comb n c P.

(* The same for points with two indices. *)
Definition in_hull2 (m n : nat) (P : nat -> nat -> vec3) (Q : vec3) : Prop :=
  exists c, (forall i j, (i < m)%nat -> (j < n)%nat -> 0 <= c i j) /\ sum (fun i => sum (c i) n) m = 1 /\
    forall a, dot a Q = sum (fun i => sum (fun j => c i j * dot a (P i j)) n) m.

(* What lies in the hull lies in every half-space in which the points lie. *)
Lemma hull_halfspace : forall n P Q a b, in_hull n P Q -> (forall i, (i < n)%nat -> dot a (P i) <= b) -> dot a Q <= b.
Proof.
  intros n P Q a b (c & Hc & H1 & ->) H. rewrite dot_comb, <- (Rmult_1_r b), <- H1, <- sum_scal.
  apply sum_le; intros i Hi. rewrite Rmult_comm. apply Rmult_le_compat_r; auto.
Qed.

Lemma hull2_halfspace : forall m n P Q a b, in_hull2 m n P Q ->
  (forall i j, (i < m)%nat -> (j < n)%nat -> dot a (P i j) <= b) -> dot a Q <= b.
Proof.
  intros m n P Q a b (c & Hc & H1 & E) H. rewrite E, <- (Rmult_1_r b), <- H1, <- sum_scal.
  apply sum_le; intros i Hi. rewrite <- sum_scal. apply sum_le; intros j Hj.
  rewrite (Rmult_comm b). apply Rmult_le_compat_l; auto.
Qed.
