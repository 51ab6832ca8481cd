(* What the theorems on rounding rest on; the output is golden. *)
From Etalon Require Import Rounding RoundingBasis Binary64 DoubleDouble Tie.
Print Assumptions basis_at_within.
Print Assumptions basis_at_sum.
Print Assumptions eval_within.
Print Assumptions derivative_near.
Print Assumptions surface_point_rational_near.
Print Assumptions inserted_rational.
Print Assumptions basis64_within.
Print Assumptions model_is_code.
Print Assumptions processor_within.
Print Assumptions processor_within_knots.
Print Assumptions two_sum_exact.
Print Assumptions two_product_exact.
