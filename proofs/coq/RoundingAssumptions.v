(* The theorems on rounding: what each of them says and the axioms it rests on.  What this file prints when it is compiled is golden, so that neither
   a statement nor a definition of the double-double operations can change unseen. *)
From Coq Require Import Reals.
From Etalon Require Import Rounding RoundingBasis Binary64 DoubleDouble DoubleDoubleBounds Tie.
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
Print Assumptions two_sum_exact.
Check fast_two_sum_exact.
Print Assumptions fast_two_sum_exact.
Check two_product_exact.
Print Assumptions two_product_exact.
Check two_product_near.
Print Assumptions two_product_near.
Check add_near_same.
Print Assumptions add_near_same.
Check add_near.
Print Assumptions add_near.
Check mul_near.
Print Assumptions mul_near.
Check mul_double_near.
Print Assumptions mul_double_near.
Check div_near.
Print Assumptions div_near.
Check div_near_published.
Print Assumptions div_near_published.
Check root_0.
Print Assumptions root_0.
Check root_near.
Print Assumptions root_near.
