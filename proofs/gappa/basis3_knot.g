# basis3.g where x is a knot, of multiplicity one (dL1 = 0) or two (dL1 = dL2 = 0): the zeros are exact, and what is left has no more roundings.  At knots
# of multiplicity three the values are set to 1 and 0.  For the knot to the right exchange left and right: each sum has but two terms.
# Condition: the other exact differences lie in [2^-160, 2^160].
@rnd = float<ieee_64,ne>;

# dL1 = 0: N11 = N22 = N33 = 0.
E10 = dR1 * (1 / dR1);
E20 = E10 / (dR1 + dL2);
EN20 = dR1 * E20;
EN21 = dL2 * E20;
E30 = EN20 / (dR1 + dL3);
E31 = EN21 / (dR2 + dL2);
EN30 = dR1 * E30;
EN31 = dL3 * E30 + dR2 * E31;
EN32 = dL2 * E31;
L2 = rnd(dL2); L3 = rnd(dL3);
R1 = rnd(dR1); R2 = rnd(dR2);
T10 rnd= 1 / R1;
N10 rnd= R1 * T10;
T20 rnd= N10 / (R1 + L2);
N20 rnd= R1 * T20;
N21 rnd= L2 * T20;
T30 rnd= N20 / (R1 + L3);
N30 rnd= R1 * T30;
S30 rnd= L3 * T30;
T31 rnd= N21 / (R2 + L2);
N31 rnd= S30 + R2 * T31;
N32 rnd= L2 * T31;

# dL2 = 0, too: N21 = N32 = 0.
F20 = E10 / dR1;
FN20 = dR1 * F20;
F30 = FN20 / (dR1 + dL3);
FN30 = dR1 * F30;
FN31 = dL3 * F30;
U20 rnd= N10 / R1;
M20 rnd= R1 * U20;
U30 rnd= M20 / (R1 + L3);
M30 rnd= R1 * U30;
M31 rnd= L3 * U30;

{ dL2 in [1b-160,1b160] /\ dL3 in [1b-160,1b160] /\ dR1 in [1b-160,1b160] /\ dR2 in [1b-160,1b160]
  ->
  |N30 -/ EN30| <= 1.5543123e-15 /\                                         # 14 u
  |N31 -/ EN31| <= 1.6653346e-15 /\                                         # 15 u
  |N32 -/ EN32| <= 1.5543123e-15 /\                                         # 14 u
  |M30 -/ FN30| <= 1.4432900e-15 /\ |M31 -/ FN31| <= 1.4432900e-15 }        # 13 u
