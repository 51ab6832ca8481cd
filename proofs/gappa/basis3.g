# The four cubic basis functions as et_basis_eval computes them (src/spline/basis.c, p = 3): relative errors at most 15, 17, 17 and 15 u, u = 2^-53,
# where the general bound (proofs/coq/Rounding.v) has 17 for all.  IEEE binary64, underflow and overflow included.
# Condition: the exact differences of the knots and x, dLj = x - u[span+1-j] and dRj = u[span+j] - x, lie in [2^-160, 2^160]; then nothing underflows.
# Where x is a knot some of them are 0: see basis3_knot.g.
@rnd = float<ieee_64,ne>;

# Over the reals.
EN10 = dR1 * (1 / (dR1 + dL1));
EN11 = dL1 * (1 / (dR1 + dL1));
E20 = EN10 / (dR1 + dL2);
E21 = EN11 / (dR2 + dL1);
EN20 = dR1 * E20;
EN21 = dL2 * E20 + dR2 * E21;
EN22 = dL1 * E21;
E30 = EN20 / (dR1 + dL3);
E31 = EN21 / (dR2 + dL2);
E32 = EN22 / (dR3 + dL1);
EN30 = dR1 * E30;
EN31 = dL3 * E30 + dR2 * E31;
EN32 = dL2 * E31 + dR3 * E32;
EN33 = dL1 * E32;

# As coded; saved is S.., the sum with saved = 0 is exact.
L1 = rnd(dL1); L2 = rnd(dL2); L3 = rnd(dL3);
R1 = rnd(dR1); R2 = rnd(dR2); R3 = rnd(dR3);
T10 rnd= 1 / (R1 + L1);
N10 rnd= R1 * T10;
N11 rnd= L1 * T10;
T20 rnd= N10 / (R1 + L2);
N20 rnd= R1 * T20;
S20 rnd= L2 * T20;
T21 rnd= N11 / (R2 + L1);
N21 rnd= S20 + R2 * T21;
N22 rnd= L1 * T21;
T30 rnd= N20 / (R1 + L3);
N30 rnd= R1 * T30;
S30 rnd= L3 * T30;
T31 rnd= N21 / (R2 + L2);
N31 rnd= S30 + R2 * T31;
S31 rnd= L2 * T31;
T32 rnd= N22 / (R3 + L1);
N32 rnd= S31 + R3 * T32;
N33 rnd= L1 * T32;

{ dL1 in [1b-160,1b160] /\ dL2 in [1b-160,1b160] /\ dL3 in [1b-160,1b160] /\
  dR1 in [1b-160,1b160] /\ dR2 in [1b-160,1b160] /\ dR3 in [1b-160,1b160]
  ->
  |N30 -/ EN30| <= 1.6653346e-15 /\ |N33 -/ EN33| <= 1.6653346e-15 /\       # 15 u
  |N31 -/ EN31| <= 1.8873792e-15 /\ |N32 -/ EN32| <= 1.8873792e-15 }        # 17 u
