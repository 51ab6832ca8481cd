(* The theorems on rounding: what each of them says and the axioms it rests on.  What this file prints when it is compiled is golden, so that neither
   a statement nor a definition of the double-double operations can change unseen. *)
From Coq Require Import Reals.
From Etalon Require Import Rounding RoundingBasis Binary64 DoubleDouble DoubleDoubleBounds Examples Tie.
Open Scope R_scope.

(* ---- definitions ---- *)

Print within.
Print near.
Print u64.
Print rnd64.
Print guarded.
Print row_safe.
Print u.
Print dd.
Print value.
Print normal.
Print two_sum.
Print fast_two_sum.
Print upper.
Print two_product.
Print add.
Print mul.
Print mul_double.
Print div.
Print root.

(* ---- statements and axioms ---- *)

Check basis_at_within.
Print Assumptions basis_at_within.
Check basis_at_sum.
Print Assumptions basis_at_sum.
Check eval_within.
Print Assumptions eval_within.
Check derivative_near.
Print Assumptions derivative_near.
Check surface_point_rational_near.
Print Assumptions surface_point_rational_near.
Check inserted_rational.
Print Assumptions inserted_rational.
Check basis64_within.
Print Assumptions basis64_within.
Check basis64_sum.
Print Assumptions basis64_sum.
Check model_is_code.
Print Assumptions model_is_code.
Check processor_within.
Print Assumptions processor_within.
Check processor_within_knots.
Print Assumptions processor_within_knots.
Check two_sum_exact.
Check fast_two_sum_exact.
Check two_product_exact.
Check two_product_near.
Check add_near_same.
Check add_near.
Check mul_near.
Check mul_near_published.
Check mul_double_near.
Check div_near.
Check div_near_published.
Check root_0.
Check root_near.
Check two_sum_normal.
Check fast_two_sum_normal.
Check unity_normal.
Check unity_range.
Check unity_root.
Check unity_quotient.
Check some_knots_are_knots.
Check some_knots_are_clamped.
Check half_is_insertable.
Check one_is_insertable.
Check half_is_in_a_span.
Check half_inserted.
Definition all_of_double_double := (two_sum_exact, fast_two_sum_exact, two_product_exact, two_product_near, add_near_same, add_near, mul_near,
  mul_double_near, div_near, div_near_published, root_0, root_near, two_sum_normal, fast_two_sum_normal, unity_normal, unity_range, unity_root,
  unity_quotient, some_knots_are_knots, some_knots_are_clamped, half_is_insertable, one_is_insertable, half_is_in_a_span, half_inserted).
Print Assumptions all_of_double_double.
