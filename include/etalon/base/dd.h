/* dd: double-double arithmetic: an unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi)/2 (Dekker 1971; Joldes, Muller and Popescu 2017).
 *
 * Error bounds hold barring overflow and underflow; each operation's is a relative one in u = 2^-53.  No fused multiply-add is used, so that every
 * processor computes the same bits.
 */
#ifndef ETALON_BASE_DD_H
#define ETALON_BASE_DD_H
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { double hi, lo; } et_dd;

et_dd et_dd_two_sum(double a, double b);          /* a + b exactly (Knuth) */
et_dd et_dd_two_product(double a, double b);      /* a b exactly (Dekker, Veltkamp) */
et_dd et_dd_add(et_dd a, et_dd b);                /* 3 u^2 + 13 u^3 */
et_dd et_dd_sub(et_dd a, et_dd b);
et_dd et_dd_mul(et_dd a, et_dd b);                /* 7 u^2 at most */
et_dd et_dd_div(et_dd a, et_dd b);                /* 15 u^2 + 56 u^3 */
et_dd et_dd_sqrt(et_dd a);

#ifdef __cplusplus
}
#endif
#endif
