/* dd: double-double arithmetic: an unevaluated sum hi + lo of two doubles, hi the double nearest to hi + lo (Dekker 1971; Joldes, Muller and
 * Popescu 2017, whose algorithms' numbers are given below as JMP; Lefevre, Louvet, Muller, Picot and Rideau 2023 for the root).
 *
 * Error bounds are relative, in u = 2^-53, and proved in those papers for operands in normal form (et_dd_normal: hi = hi + lo rounded to nearest) where
 * nothing overflows and no product underflows; each contract says what range is enough (proofs/README.md: which of them
 * Coq proves of this code, too).  No fused multiply-add is used, so that every processor computes
 * the same bits.  Outside the range hi is still what the same steps give in IEEE 754, but lo may be NaN or off.
 */
#ifndef ETALON_BASE_DD_H
#define ETALON_BASE_DD_H
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { double hi, lo; } et_dd;

/*@ predicate et_dd_normal(et_dd a) = a.hi == (double)(a.hi + a.lo); */

/* a + b exactly: hi the rounded sum, lo its error (Knuth).  Underflow does no harm. */
/*@ requires finite: \is_finite(a) && \is_finite(b);
    requires range:  -0x1p1022 <= a <= 0x1p1022 && -0x1p1022 <= b <= 0x1p1022;
    assigns  \nothing;
    ensures  exact:  \result.hi + \result.lo == a + b;
*/
et_dd et_dd_two_sum(double a, double b);

/* a b exactly: hi the rounded product, lo its error (Dekker, by Veltkamp's splitting).  Exact for |a|, |b| <= 2^995 where a b = 0 or
 * 2^-968 <= |a b| <= 2^1021: then no partial product overflows or has a bit below 2^-1074. */
/*@ requires finite: \is_finite(a) && \is_finite(b);
    requires split:  -0x1p995 <= a <= 0x1p995 && -0x1p995 <= b <= 0x1p995;
    requires range:  a * b == 0 || 0x1p-968 <= a * b <= 0x1p1021 || -0x1p1021 <= a * b <= -0x1p-968;
    assigns  \nothing;
    ensures  exact:  \result.hi + \result.lo == a * b;
*/
et_dd et_dd_two_product(double a, double b);

/* a + b within 3u^2 + 13u^3 relative (JMP 6, AccurateDWPlusDW), cancellation included.  Underflow does no harm. */
/*@ requires finite: \is_finite(a.hi) && \is_finite(a.lo) && \is_finite(b.hi) && \is_finite(b.lo);
    requires normal: et_dd_normal(a) && et_dd_normal(b);
    requires range:  -0x1p1021 <= a.hi <= 0x1p1021 && -0x1p1021 <= b.hi <= 0x1p1021;
    assigns  \nothing;
    ensures  above:  (\result.hi + \result.lo) - (a.hi + a.lo + b.hi + b.lo) <=  0x1.8000000000004p-105 * \abs(a.hi + a.lo + b.hi + b.lo);
    ensures  below:  (\result.hi + \result.lo) - (a.hi + a.lo + b.hi + b.lo) >= -0x1.8000000000004p-105 * \abs(a.hi + a.lo + b.hi + b.lo);
*/
et_dd et_dd_add(et_dd a, et_dd b);

/* a - b: et_dd_add of a and the negative of b, which is exact. */
/*@ requires finite: \is_finite(a.hi) && \is_finite(a.lo) && \is_finite(b.hi) && \is_finite(b.lo);
    requires normal: et_dd_normal(a) && et_dd_normal(b);
    requires range:  -0x1p1021 <= a.hi <= 0x1p1021 && -0x1p1021 <= b.hi <= 0x1p1021;
    assigns  \nothing;
    ensures  above:  (\result.hi + \result.lo) - (a.hi + a.lo - b.hi - b.lo) <=  0x1.8000000000004p-105 * \abs(a.hi + a.lo - b.hi - b.lo);
    ensures  below:  (\result.hi + \result.lo) - (a.hi + a.lo - b.hi - b.lo) >= -0x1.8000000000004p-105 * \abs(a.hi + a.lo - b.hi - b.lo);
*/
et_dd et_dd_sub(et_dd a, et_dd b);

/* a b within 7u^2 relative (JMP 10, DWTimesDW1), for |a.hi|, |b.hi| <= 2^995 and a.hi b.hi = 0 or 2^-900 <= |a.hi b.hi| <= 2^1020: there what
 * underflows in the lower terms is below 2^-170 relative. */
/*@ requires finite: \is_finite(a.hi) && \is_finite(a.lo) && \is_finite(b.hi) && \is_finite(b.lo);
    requires normal: et_dd_normal(a) && et_dd_normal(b);
    requires split:  -0x1p995 <= a.hi <= 0x1p995 && -0x1p995 <= b.hi <= 0x1p995;
    requires range:  a.hi * b.hi == 0 || 0x1p-900 <= \abs(a.hi * b.hi) <= 0x1p1020;
    assigns  \nothing;
    ensures  above:  (\result.hi + \result.lo) - (a.hi + a.lo) * (b.hi + b.lo) <=  0x1.cp-104 * \abs((a.hi + a.lo) * (b.hi + b.lo));
    ensures  below:  (\result.hi + \result.lo) - (a.hi + a.lo) * (b.hi + b.lo) >= -0x1.cp-104 * \abs((a.hi + a.lo) * (b.hi + b.lo));
*/
et_dd et_dd_mul(et_dd a, et_dd b);

/* a / b within 15u^2 + 56u^3 relative (JMP 17, DWDivDW2), for |a.hi| (or a = 0), |b.hi| and |a.hi / b.hi| from 2^-900 to 2^990.  Division by zero
 * gives no useful result. */
/*@ requires finite: \is_finite(a.hi) && \is_finite(a.lo) && \is_finite(b.hi) && \is_finite(b.lo);
    requires normal: et_dd_normal(a) && et_dd_normal(b);
    requires range:  (a.hi == 0 || 0x1p-900 <= \abs(a.hi) <= 0x1p990) && 0x1p-900 <= \abs(b.hi) <= 0x1p990;
    requires ratio:  a.hi == 0 || 0x1p-900 * \abs(b.hi) <= \abs(a.hi) <= 0x1p990 * \abs(b.hi);
    assigns  \nothing;
    ensures  above:  (\result.hi + \result.lo) - (a.hi + a.lo) / (b.hi + b.lo) <=  0x1.e000000000004p-103 * \abs((a.hi + a.lo) / (b.hi + b.lo));
    ensures  below:  (\result.hi + \result.lo) - (a.hi + a.lo) / (b.hi + b.lo) >= -0x1.e000000000004p-103 * \abs((a.hi + a.lo) / (b.hi + b.lo));
*/
et_dd et_dd_div(et_dd a, et_dd b);

/* The square root within 25/8 u^2 relative (SQRTDWtoDW), for a.hi = 0 (the root is a zero of the same sign) or from 2^-900 to 2^1021; NaN below 0. */
/*@ requires finite: \is_finite(a.hi) && \is_finite(a.lo);
    requires normal: et_dd_normal(a);
    requires range:  a.hi == 0 || 0x1p-900 <= a.hi <= 0x1p1021;
    assigns  \nothing;
    ensures  zero:   a.hi == 0 ==> \result.hi == 0 && \result.lo == 0;
    ensures  square: \abs((\result.hi + \result.lo) * (\result.hi + \result.lo) - (a.hi + a.lo)) <= 0x1.ap-104 * (a.hi + a.lo);
*/
et_dd et_dd_sqrt(et_dd a);

#ifdef __cplusplus
}
#endif
#endif
