(* The loops of src/spline/{basis,curve,surface,curve_net}.c, once, over any arithmetic.  The same definitions are run on real numbers (what is
   meant), on real numbers with a rounding behind each operation (Rounding.v), on Flocq's binary64 (Binary64.v) and on the processor's (Tie.v).
   What stands between QUOTE and END is the C code, word for word: proofs/coq/quote.sh checks it. *)
Require Import List Arith Lia.
Import ListNotations.

Record arithmetic := Arithmetic {
  number :> Type;
  zero : number; one : number;
  add : number -> number -> number; sub : number -> number -> number;
  mul : number -> number -> number; div : number -> number -> number;
  less : number -> number -> bool; same : number -> number -> bool
}.
Arguments zero {_}. Arguments one {_}.
Arguments add {_}. Arguments sub {_}. Arguments mul {_}. Arguments div {_}. Arguments less {_}. Arguments same {_}.

Section Scheme.
Context {A : arithmetic}.
Implicit Types (u left right : nat -> A) (x : A).

(* ---- basis functions, A2.2 ---- *)

(* QUOTE src/spline/basis.c
static double clamp(double x, double lo, double hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}
END *)
Definition clamp x (lo hi : A) : A := if less x lo then lo else if less hi x then hi else x.

(* QUOTE src/spline/basis.c
    for (size_t j = 1; j <= p; j++) {
        left[j] = x - u[span + 1 - j];
        right[j] = u[span + j] - x;
    }
    if (p == 0 || left[p] == 0.0) {
        return 0;
    }
    return right[p] == 0.0 ? p : p + 1;
END *)
Definition to_left u (span : nat) x (j : nat) : A := sub x (u (span + 1 - j)).
Definition to_right u (span : nat) x (j : nat) : A := sub (u (span + j)) x.
Definition only_of u (p span : nat) x : nat :=
  if orb (p =? 0) (same (to_left u span x p) zero) then 0 else if same (to_right u span x p) zero then p else p + 1.

(* QUOTE src/spline/basis.c
    N[0] = 1.0;
    for (size_t j = 1; j <= p; j++) {
        double saved = 0.0;
        for (size_t r = 0; r < j; r++) {
            double temp = N[r] / (right[r + 1] + left[j - r]);
            N[r] = saved + right[r + 1] * temp;
            saved = left[j - r] * temp;
        }
        N[j] = saved;
    }
END *)
Fixpoint inner left right (j r : nat) (saved : A) (N : list A) : list A :=
  match N with
  | [] => [saved]
  | n :: N' =>
      let temp := div n (add (right (r + 1)) (left (j - r))) in
      add saved (mul (right (r + 1)) temp) :: inner left right j (r + 1) (mul (left (j - r)) temp) N'
  end.
Fixpoint outer left right (j : nat) : list A :=
  match j with
  | O => [one]
  | S k => inner left right (S k) 0 zero (outer left right k)
  end.

(* QUOTE src/spline/basis.c
    for (size_t r = 0; only <= p && r <= p; r++) {
        N[r] = r == only ? 1.0 : 0.0;
    }
END *)
Definition unit_row (p only : nat) : list A := map (fun r => if r =? only then one else zero) (seq 0 (p + 1)).

(* QUOTE src/spline/basis.c
    x = clamp(x, u[p], u[nu - p - 1]);
    size_t only = distances(left, right, u, p, span, x);
END *)
Definition basis_at u (p span : nat) x : list A :=
  let only := only_of u p span x in
  if only <=? p then unit_row p only else outer (to_left u span x) (to_right u span x) p.
Definition basis_eval u (nu p span : nat) x : list A := basis_at u p span (clamp x (u p) (u (nu - p - 1))).

(* The same as a function: entry j r is N[r] behind step j. *)
Definition temp left right (f : nat -> A) (j r : nat) : A := div (f r) (add (right (r + 1)) (left (j - r))).
Definition saved left right (f : nat -> A) (j r : nat) : A :=
  match r with O => zero | S q => mul (left (j - q)) (temp left right f j q) end.
Definition next left right (f : nat -> A) (j r : nat) : A :=
  if r =? j then saved left right f j r else add (saved left right f j r) (mul (right (r + 1)) (temp left right f j r)).
Fixpoint entry left right (j : nat) : nat -> A :=
  match j with
  | O => fun _ => one
  | S k => next left right (entry left right k) (S k)
  end.

Lemma inner_length : forall left right j N r s, length (inner left right j r s N) = S (length N).
Proof. induction N; simpl; intros; auto. Qed.
Lemma outer_length : forall left right j, length (outer left right j) = S j.
Proof. induction j; [easy|]. cbn [outer]. now rewrite inner_length, IHj. Qed.

Lemma inner_nth : forall left right d j N r0 s i, i <= length N ->
  let f := fun q => nth q N d in
  let before := match i with
    | O => s
    | S q => mul (left (j - (r0 + q))) (div (f q) (add (right (r0 + q + 1)) (left (j - (r0 + q)))))
    end in
  nth i (inner left right j r0 s N) d =
    if i =? length N then before else add before (mul (right (r0 + i + 1)) (div (f i) (add (right (r0 + i + 1)) (left (j - (r0 + i)))))).
Proof.
  induction N as [|n N IH]; intros r0 s i Hi; simpl in Hi.
  - assert (i = 0) by lia. now subst i.
  - destruct i as [|i]; [simpl; now rewrite !Nat.add_0_r|].
    cbn [inner length nth]. rewrite IH by lia. cbn [Nat.eqb].
    destruct i as [|i]; cbn [nth].
    + now rewrite !Nat.add_0_r.
    + replace (r0 + 1 + i) with (r0 + S i) by lia. now replace (r0 + 1 + S i) with (r0 + S (S i)) by lia.
Qed.

Lemma next_ext : forall left right f g j r, r <= j -> (forall q, q < j -> f q = g q) -> next left right f j r = next left right g j r.
Proof.
  intros left right f g j r Hr H. unfold next.
  assert (E : saved left right f j r = saved left right g j r) by (destruct r; auto; unfold saved, temp; rewrite H; auto; lia).
  rewrite E. destruct (Nat.eqb_spec r j); auto. unfold temp. rewrite H; auto; lia.
Qed.

Theorem outer_is_entry : forall left right d j r, r <= j -> nth r (outer left right j) d = entry left right j r.
Proof.
  induction j as [|k IH]; intros r Hr; [now replace r with 0 by lia|].
  cbn [outer entry]. rewrite inner_nth by (rewrite outer_length; lia). rewrite outer_length.
  rewrite <- (next_ext left right (fun q => nth q (outer left right k) d)) by (auto; intros; apply IH; lia).
  unfold next, saved, temp. destruct r; cbn [Nat.add]; reflexivity.
Qed.

(* ---- points ---- *)

(* QUOTE src/spline/curve.c
    homogeneous P = lift(c, first), S = {N[0] * P.x, N[0] * P.y, N[0] * P.z, N[0] * P.w};
    for (size_t r = 1; r <= c->p; r++) {
        P = lift(c, first + r);
        S = (homogeneous){S.x + N[r] * P.x, S.y + N[r] * P.y, S.z + N[r] * P.z, S.w + N[r] * P.w};
    }
END
   QUOTE src/spline/surface_parts.h
        T[j] = surface_scale(N[0], surface_lift(s, first + j));
        for (size_t k = 1; k <= s->p; k++) {
            T[j] = surface_add(T[j], surface_scale(N[k], surface_lift(s, first + k * s->nv + j)));
        }
END
   QUOTE src/spline/surface_parts.h
    surface_point S = surface_scale(N[0], T[0]);
    for (size_t l = 1; l <= q; l++) {
        S = surface_add(S, surface_scale(N[l], T[l]));
    }
END *)
Fixpoint contract (N P : nat -> A) (p : nat) : A :=
  match p with
  | O => mul (N 0) (P 0)
  | S k => add (contract N P k) (mul (N (S k)) (P (S k)))
  end.
Definition contract_uv (N M : nat -> A) (P : nat -> nat -> A) (p q : nat) : A :=
  contract M (fun j => contract N (fun i => P i j) p) q.

(* QUOTE src/spline/surface_parts.h
    et_vec3 P = s->points[index];
    double w = s->weights ? s->weights[index] : 1.0;
    return (surface_point){w * P.x, w * P.y, w * P.z, w};
END
   QUOTE src/spline/curve.c
    et_vec3 P = c->points[i];
    double w = c->weights ? c->weights[i] : 1.0;
    return (homogeneous){w * P.x, w * P.y, w * P.z, w};
END
   QUOTE src/spline/curve.c
    return rational ? (et_vec3){S.x / S.w, S.y / S.w, S.z / S.w} : (et_vec3){S.x, S.y, S.z};
END
   One coordinate c, polynomial and rational. *)
Definition curve_point (N c : nat -> A) (p : nat) : A := contract N (fun i => mul one (c i)) p.
Definition curve_point_rational (N w c : nat -> A) (p : nat) : A := div (contract N (fun i => mul (w i) (c i)) p) (contract N w p).
Definition surface_point (N M : nat -> A) (c : nat -> nat -> A) (p q : nat) : A := contract_uv N M (fun i j => mul one (c i j)) p q.
Definition surface_point_rational (N M : nat -> A) (w c : nat -> nat -> A) (p q : nat) : A :=
  div (contract_uv N M (fun i j => mul (w i j) (c i j)) p q) (contract_uv N M w p q).

(* ---- insertion of a knot, A5.1 ---- *)

(* QUOTE src/spline/curve_net.c
    size_t p = net->p, lines = net->lines, nu = net->n + p + 1;
    double *u = net->u;
    shift_up(net, k - s);
    for (size_t i = k - s; i + p > k; i--) {
        double width = u[i + p] - u[i], a = (x - u[i]) / width, b = (u[i + p] - x) / width;
        net->from[i] = CURVE_COMPUTED;
        for (size_t j = 0; j < lines; j++) {
            curve_point *h = net->h + i * lines + j;
            h[0] = combine(a, h[0], b, *(h - lines));
        }
    }
    memmove(u + k + 2, u + k + 1, (nu - k - 1) * sizeof *u);
    u[k + 1] = x;
END
   QUOTE src/spline/curve_net.c
    return (curve_point){a * P.x + b * Q.x, a * P.y + b * Q.y, a * P.z + b * Q.z, a * P.w + b * Q.w};
END
   From the last i to the first: point i - 1 is still the old one. *)
Definition share_a u (p i : nat) x : A := div (sub x (u i)) (sub (u (i + p)) (u i)).
Definition share_b u (p i : nat) x : A := div (sub (u (i + p)) x) (sub (u (i + p)) (u i)).
Definition insert_points u (p k s : nat) x (h : nat -> A) (i : nat) : A :=
  if i <=? k - s
  then if k <? i + p then add (mul (share_a u p i x) (h i)) (mul (share_b u p i x) (h (i - 1))) else h i
  else h (i - 1).
Definition insert_knots u (k : nat) x (i : nat) : A := if i <=? k then u i else if i =? k + 1 then x else u (i - 1).

(* QUOTE src/spline/curve_net.c
    for (size_t t = 0; t < times; t++) {
        insert_once(net, k + t, s + t, x);
    }
END *)
Fixpoint inserted_knots u (k : nat) x (times : nat) : nat -> A :=
  match times with O => u | S t => insert_knots (inserted_knots u k x t) (k + t) x end.
Fixpoint inserted u (p k s : nat) x (h : nat -> A) (times : nat) : nat -> A :=
  match times with O => h | S t => insert_points (inserted_knots u k x t) p (k + t) (s + t) x (inserted u p k s x h t) end.

(* ---- derivatives, A2.3 (Eqs. 2.9 and 2.10) ---- *)

(* QUOTE src/spline/basis.c
    size_t w = p + 1, pk = p - k;
    double d = 0.0;
    for (size_t j = 0; j <= k; j++) {
        /* The function of degree p-k and local index r-k+j, times a_{k,j}. */
        next[j] = 0.0;
        if (r + j < k || r + j - k > pk) {
            continue;
        }
        size_t i = r + j - k;
        double a = (j < k ? prev[j] : 0.0) - (j > 0 ? prev[j - 1] : 0.0);
        next[j] = a / ndu[(pk + 1) * w + i];
        d += next[j] * ndu[i * w + pk];
    }
    return d;
END
   The knot difference ndu[(pk + 1) * w + i] is right[i + 1] + left[pk + 1 - i], the function ndu[i * w + pk] is entry pk i. *)
Definition outside (p r k j : nat) : bool := orb (r + j <? k) (p - k <? r + j - k).
Fixpoint coefficient left right (p r k : nat) : nat -> A :=
  match k with
  | O => fun _ => one
  | S l => fun j =>
      if outside p r k j then zero
      else div (sub (if j <? k then coefficient left right p r l j else zero) (match j with O => zero | S i => coefficient left right p r l i end))
               (add (right (r + j - k + 1)) (left (p - k + 1 - (r + j - k))))
  end.
(* The sum over the first n of the terms. *)
Fixpoint derivative_sum left right (p r k n : nat) : A :=
  match n with
  | O => zero
  | S j => if outside p r k j then derivative_sum left right p r k j
           else add (derivative_sum left right p r k j) (mul (coefficient left right p r k j) (entry left right (p - k) (r + j - k)))
  end.

(* QUOTE src/spline/basis.c
    double factor = 1.0;
    for (size_t k = 1; k <= d; k++) {
        factor *= k <= p ? (double)(p - k + 1) : 0.0;
        for (size_t r = 0; r <= p; r++) {
            D[k * w + r] = k <= p ? D[k * w + r] * factor : 0.0;
        }
    }
END *)
Fixpoint factor (of_nat : nat -> A) (p k : nat) : A :=
  match k with O => one | S l => mul (factor of_nat p l) (of_nat (p - k + 1)) end.
Definition derivative left right of_nat (p r k : nat) : A := mul (derivative_sum left right p r k (k + 1)) (factor of_nat p k).

End Scheme.

(* ---- what two arithmetics have in common, the loops have in common ---- *)

Section Related.
Context {A B : arithmetic} (rel : A -> B -> Prop).
Hypothesis rel_zero : rel zero zero.
Hypothesis rel_one : rel one one.
Hypothesis rel_add : forall a a' b b', rel a a' -> rel b b' -> rel (add a b) (add a' b').
Hypothesis rel_sub : forall a a' b b', rel a a' -> rel b b' -> rel (sub a b) (sub a' b').
Hypothesis rel_mul : forall a a' b b', rel a a' -> rel b b' -> rel (mul a b) (mul a' b').
Hypothesis rel_div : forall a a' b b', rel a a' -> rel b b' -> rel (div a b) (div a' b').
Definition rel_all (f : nat -> A) (g : nat -> B) : Prop := forall i, rel (f i) (g i).

Lemma to_left_related : forall u u' s x x', rel_all u u' -> rel x x' -> rel_all (to_left u s x) (to_left u' s x').
Proof. intros u u' s x x' Hu Hx j. apply rel_sub; auto. Qed.
Lemma to_right_related : forall u u' s x x', rel_all u u' -> rel x x' -> rel_all (to_right u s x) (to_right u' s x').
Proof. intros u u' s x x' Hu Hx j. apply rel_sub; auto. Qed.

Lemma entry_related : forall l l' r r', rel_all l l' -> rel_all r r' -> forall j, rel_all (entry l r j) (entry l' r' j).
Proof.
  intros l l' r r' Hl Hr. induction j as [|j IH]; intros i; cbn [entry]; auto.
  assert (HT : forall k, rel (temp l r (entry l r j) (S j) k) (temp l' r' (entry l' r' j) (S j) k)) by (intros; apply rel_div, rel_add; auto).
  assert (HS : forall k, rel (saved l r (entry l r j) (S j) k) (saved l' r' (entry l' r' j) (S j) k)) by (destruct k; cbn [saved]; auto).
  unfold next. destruct (i =? S j); auto.
Qed.
Lemma outer_related : forall l l' r r', rel_all l l' -> rel_all r r' -> forall j, Forall2 rel (outer l r j) (outer l' r' j).
Proof.
  intros l l' r r' Hl Hr. assert (E : forall j N N', Forall2 rel N N' -> forall i s s', rel s s' ->
    Forall2 rel (inner l r j i s N) (inner l' r' j i s' N')).
  { intros j N N' H. induction H; intros i s s' Hs; cbn [inner]; [auto|]. constructor; [|apply IHForall2]; auto 6. }
  induction j; cbn [outer]; auto.
Qed.
Lemma contract_related : forall N N' P P' p, rel_all N N' -> rel_all P P' -> rel (contract N P p) (contract N' P' p).
Proof. intros N N' P P' p HN HP. induction p; cbn [contract]; auto. Qed.
Lemma inserted_knots_related : forall u u' k x x' n, rel_all u u' -> rel x x' -> rel_all (inserted_knots u k x n) (inserted_knots u' k x' n).
Proof.
  intros u u' k x x' n Hu Hx. induction n as [|n IH]; cbn [inserted_knots]; auto. intros i. unfold insert_knots.
  destruct (i <=? k + n); auto. destruct (i =? k + n + 1); auto.
Qed.
Lemma inserted_related : forall u u' p k s x x' h h' n, rel_all u u' -> rel x x' -> rel_all h h' ->
  rel_all (inserted u p k s x h n) (inserted u' p k s x' h' n).
Proof.
  intros u u' p k s x x' h h' n Hu Hx Hh. induction n as [|n IH]; cbn [inserted]; auto. intros i. unfold insert_points.
  pose proof (inserted_knots_related u u' k x x' n Hu Hx) as Hk.
  destruct (i <=? k + n - (s + n)); auto. destruct (k + n <? i + p); auto. unfold share_a, share_b. auto 12.
Qed.
Lemma derivative_related : forall l l' r r' f f' p i k, rel_all l l' -> rel_all r r' -> rel_all f f' ->
  rel (derivative l r f p i k) (derivative l' r' f' p i k).
Proof.
  intros l l' r r' f f' p i k Hl Hr Hf. pose proof (entry_related l l' r r' Hl Hr) as HN.
  assert (HC : forall k j, rel (coefficient l r p i k j) (coefficient l' r' p i k j)).
  { induction k0 as [|m IH]; intros j; cbn [coefficient]; auto. destruct (outside p i (S m) j); auto.
    apply rel_div, rel_add; auto. apply rel_sub; [destruct (j <? S m)|destruct j]; auto. }
  assert (HD : forall n, rel (derivative_sum l r p i k n) (derivative_sum l' r' p i k n)).
  { induction n as [|n IH]; cbn [derivative_sum]; auto. destruct (outside p i k n); auto. apply rel_add, rel_mul; auto. apply HN. }
  assert (HF : forall m, rel (factor f p m) (factor f' p m)) by (induction m; cbn [factor]; auto).
  apply rel_mul; auto.
Qed.

(* Where comparisons agree, too, so does the whole function. *)
Hypothesis rel_less : forall a a' b b', rel a a' -> rel b b' -> less a b = less a' b'.
Hypothesis rel_same : forall a a' b b', rel a a' -> rel b b' -> same a b = same a' b'.
Theorem basis_eval_related : forall u u' nu p s x x', rel_all u u' -> rel x x' -> Forall2 rel (basis_eval u nu p s x) (basis_eval u' nu p s x').
Proof.
  intros u u' nu p s x x' Hu Hx. assert (HC : rel (clamp x (u p) (u (nu - p - 1))) (clamp x' (u' p) (u' (nu - p - 1)))).
  { unfold clamp. rewrite (rel_less x x' (u p) (u' p)), (rel_less (u (nu - p - 1)) (u' (nu - p - 1)) x x') by auto.
    destruct (less x' (u' p)); auto. destruct (less (u' (nu - p - 1)) x'); auto. }
  unfold basis_eval, basis_at. set (y := clamp x _ _) in *. set (y' := clamp x' _ _) in *.
  pose proof (to_left_related u u' s y y' Hu HC) as HL. pose proof (to_right_related u u' s y y' Hu HC) as HR.
  assert (E : only_of u p s y = only_of u' p s y').
  { unfold only_of. rewrite (rel_same _ _ zero zero (HL p) rel_zero), (rel_same _ _ zero zero (HR p) rel_zero). reflexivity. }
  rewrite E. destruct (only_of u' p s y' <=? p); [|now apply outer_related].
  unfold unit_row. induction (seq 0 (p + 1)); cbn [map]; constructor; auto. destruct (a =? only_of u' p s y'); auto.
Qed.
End Related.
