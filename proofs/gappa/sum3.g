# The exact sum of the four cubic basis functions that et_basis_eval computes (basis3.g): within 11 u of 1, u = 2^-53; after the first step within 3 u,
# after the second 7 u.  Condition: as in basis3.g, the exact differences lie in [2^-160, 2^160].
# The hints at the end are identities of the reals (distribution, cancellation of a denominator that is not 0), which Gappa takes as given.
@rnd = float<ieee_64,ne>;
L1 = rnd(dL1); L2 = rnd(dL2); L3 = rnd(dL3);
R1 = rnd(dR1); R2 = rnd(dR2); R3 = rnd(dR3);
D11 rnd= R1 + L1; D12 rnd= R1 + L2; D21 rnd= R2 + L1;
D13 rnd= R1 + L3; D22 rnd= R2 + L2; D31 rnd= R3 + L1;
T1 rnd= 1 / D11;
N10 rnd= R1 * T1;
N11 rnd= L1 * T1;
T20 rnd= N10 / D12;
N20 rnd= R1 * T20;
S20 rnd= L2 * T20;
T21 rnd= N11 / D21;
P21 rnd= R2 * T21;
N21 rnd= S20 + P21;
N22 rnd= L1 * T21;
T30 rnd= N20 / D13;
N30 rnd= R1 * T30;
S30 rnd= L3 * T30;
T31 rnd= N21 / D22;
P31 rnd= R2 * T31;
N31 rnd= S30 + P31;
S31 rnd= L2 * T31;
T32 rnd= N22 / D31;
P32 rnd= R3 * T32;
N32 rnd= S31 + P32;
N33 rnd= L1 * T32;

H1   = (R1 + L1) * (1 / (R1 + L1));
H20  = (R1 + L2) * (N10 / (R1 + L2)); H21 = (R2 + L1) * (N11 / (R2 + L1));
H30  = (R1 + L3) * (N20 / (R1 + L3)); H31 = (R2 + L2) * (N21 / (R2 + L2)); H32 = (R3 + L1) * (N22 / (R3 + L1));
SUM1 = N10 + N11;                       # computed values, exact sum
C1   = R1 * T1 + L1 * T1;               # before the rounding of the products
B1   = (R1 + L1) * T1;                  # = C1
SUM2 = (N20 + N21) + N22;
F2   = (N20 + (S20 + P21)) + N22;       # before the rounding of the sums
C2   = (R1*T20 + (L2*T20 + R2*T21)) + L1*T21;
B2   = (R1 + L2) * T20 + (R2 + L1) * T21;
SUM3 = (N30 + N31) + (N32 + N33);
F3   = (N30 + (S30 + P31)) + ((S31 + P32) + N33);
C3   = (R1*T30 + (L3*T30 + R2*T31)) + ((L2*T31 + R3*T32) + L1*T32);
B3   = ((R1 + L3) * T30 + (R2 + L2) * T31) + (R3 + L1) * T32;

{ dL1 in [1b-160,1b160] /\ dL2 in [1b-160,1b160] /\ dL3 in [1b-160,1b160] /\
  dR1 in [1b-160,1b160] /\ dR2 in [1b-160,1b160] /\ dR3 in [1b-160,1b160]
  -> |SUM1 - 1| <= 3.3306691e-16 /\      # 3 u
     |SUM2 - 1| <= 7.7715612e-16 /\      # 7 u
     |SUM3 - 1| <= 1.2212454e-15 }        # 11 u

C1 -> B1;
C2 -> B2;
C3 -> B3;
H1 -> 1 { R1 + L1 <> 0 };
H20 -> N10 { R1 + L2 <> 0 }; H21 -> N11 { R2 + L1 <> 0 };
H30 -> N20 { R1 + L3 <> 0 }; H31 -> N21 { R2 + L2 <> 0 }; H32 -> N22 { R3 + L1 <> 0 };
SUM1 ~ C1; B1 ~ H1;
SUM2 ~ F2; F2 ~ C2; B2 ~ H20 + H21; 
SUM3 ~ F3; F3 ~ C3; B3 ~ (H30 + H31) + H32;
